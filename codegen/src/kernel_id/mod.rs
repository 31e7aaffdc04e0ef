//! The kernels of a mechanism: one table of what each is called, takes and returns, which every stage reads.

mod kernels;
mod signature;

pub use kernels::KernelId;
pub use signature::{Argument, Arguments, Associated, Method, Receiver, Record, Signature, Trait, Type};

/// What documentation says of kernels that may refuse a pivot.
const REFUSED: &str = "Where `refused` is set a pivot was too small and nothing else holds";

impl KernelId {
    /// Its name: of the generated method, in listings and in the language.
    pub fn name(self) -> &'static str {
        self.signature().name
    }

    /// Those that are made where the block `kernels` names them.
    pub fn optional() -> impl Iterator<Item = KernelId> {
        KernelId::ALL.iter().copied().filter(|kernel| kernel.signature().is_optional)
    }

    /// What it computes: formula, shape, units. Each `{word}` of the table's text gives way to what is said for it.
    pub fn documentation(self, words: &[(&str, String)]) -> String {
        let text = self.signature().documentation.replace("{refused}", REFUSED);
        words.iter().fold(text, |text, (word, value)| text.replace(&format!("{{{word}}}"), value))
    }
}
