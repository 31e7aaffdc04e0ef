//! How a declaration wants to be run.

use crate::dsl::{Region, Unit};
use syn::Ident;

/// `t_end = 30 [ms];` in `run`.
pub struct RunSetting {
    /// What is set.
    pub name: Ident,
    /// To what.
    pub value: RunValue,
}

/// The value of a setting.
pub enum RunValue {
    /// `1e-11`, `30 [ms]`
    Number {
        /// As written.
        text: String,
        /// Its unit.
        unit: Option<Unit>,
        /// Its place.
        region: Region,
    },
    /// `dop853`, `period`, `period: 3`
    Word {
        /// The word.
        word: Ident,
        /// The number after a colon.
        count: Option<usize>,
    },
}

impl RunValue {
    /// Its place.
    pub fn region(&self) -> Region {
        match self {
            RunValue::Number { region, .. } => *region,
            RunValue::Word { word, .. } => word.into(),
        }
    }
}
