//! Text in a PNG, in chunks that every reader skips (Portable Network Graphics, third edition, 11.3.3).

use sim_runtime::Provenance;

/// Where the first chunk, the header, ends: after the signature, its length and type, its 13 bytes and its checksum.
const AFTER_HEADER: usize = 8 + 8 + 13 + 4;

/// A PNG with `Software`, which names the program, and `Comment`, which has all of it as JSON.
pub(super) fn with_provenance(mut png: Vec<u8>, provenance: &Provenance) -> Vec<u8> {
    let software = [b"Software\0", Provenance::program().as_bytes()].concat();
    // Neither compressed nor translated.
    let comment = [b"Comment\0\0\0\0\0", provenance.to_json().to_string().as_bytes()].concat();
    let chunks = [chunk(*b"tEXt", &software), chunk(*b"iTXt", &comment)].concat();
    let place = AFTER_HEADER.min(png.len());
    png.splice(place..place, chunks);
    png
}

fn chunk(kind: [u8; 4], data: &[u8]) -> Vec<u8> {
    let checked = [&kind, data].concat();
    let length = u32::try_from(data.len()).unwrap_or_default();
    [&length.to_be_bytes(), checked.as_slice(), &checksum(&checked).to_be_bytes()].concat()
}

/// CRC-32 of ISO 3309, annex D of the same document.
fn checksum(bytes: &[u8]) -> u32 {
    let shift = |crc: u32| if crc & 1 == 1 { 0xedb8_8320 ^ (crc >> 1) } else { crc >> 1 };
    let add = |crc: u32, byte: &u8| (0..8).fold(crc ^ u32::from(*byte), |crc, _| shift(crc));
    !bytes.iter().fold(u32::MAX, add)
}

#[cfg(test)]
mod tests {
    use super::*;
    use tiny_skia::Pixmap;

    /// The check value of CRC-32/ISO-HDLC, and the last chunk of every PNG.
    #[test]
    fn checksums_are_those_of_png() {
        assert_eq!(checksum(b"123456789"), 0xcbf4_3926);
        assert_eq!(chunk(*b"IEND", &[]), b"\0\0\0\0IEND\xae\x42\x60\x82");
    }

    /// A reader finds the same picture.
    #[test]
    fn the_picture_stays() {
        let mut picture = Pixmap::new(3, 2).unwrap();
        picture.fill(tiny_skia::Color::from_rgba8(1, 2, 3, 255));
        let provenance = Provenance { command: Some("sim plot \u{e4}".into()), ..Provenance::default() };
        let png = with_provenance(picture.encode_png().unwrap(), &provenance);
        assert_eq!(Pixmap::decode_png(&png).unwrap(), picture);
        let text = String::from_utf8_lossy(&png);
        assert!(text.contains(&format!("tEXtSoftware\0{}", Provenance::program())));
        assert!(text.contains(&format!("iTXtComment\0\0\0\0\0{}", provenance.to_json())));
    }
}
