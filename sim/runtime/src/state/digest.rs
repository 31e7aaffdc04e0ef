//! FNV-1a, 64 bits (Fowler, Noll, Vo; RFC 9923): it distinguishes contents and is not cryptographic. A change of one
//! byte always changes it.

/// The digest of the bytes so far.
pub struct Digest(u64);

impl Default for Digest {
    /// That of no bytes.
    fn default() -> Digest {
        Digest(0xcbf2_9ce4_8422_2325)
    }
}

impl Digest {
    /// That of these bytes.
    pub fn of(bytes: &[u8]) -> u64 {
        let mut digest = Digest::default();
        digest.add(bytes);
        digest.0
    }

    /// Adds bytes.
    pub fn add(&mut self, bytes: &[u8]) {
        for byte in bytes {
            self.0 = (self.0 ^ u64::from(*byte)).wrapping_mul(0x0000_0100_0000_01b3);
        }
    }

    /// In hexadecimal.
    pub fn text(&self) -> String {
        format!("{:016x}", self.0)
    }
}
