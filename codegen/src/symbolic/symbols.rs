//! Bloom filters of symbols, which are quick to compare.

use super::Symbol;

/// A Bloom filter of 64 bits: it may report symbols that are absent, but never misses one. So most independence of a
/// symbol shows at once.
#[derive(Clone, Copy, Default)]
pub(super) struct Symbols(u64);

impl Symbols {
    pub(super) fn of<'a>(symbols: impl IntoIterator<Item = &'a Symbol>) -> Symbols {
        Symbols(symbols.into_iter().fold(0, |bits, symbol| bits | 1 << (symbol.0 % u64::BITS)))
    }

    pub(super) fn or(self, others: Symbols) -> Symbols {
        Symbols(self.0 | others.0)
    }

    /// Whether some symbol may be in both.
    pub(super) fn meet(self, others: Symbols) -> bool {
        self.0 & others.0 != 0
    }
}
