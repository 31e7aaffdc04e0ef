//! Outputs, and their groups.

use crate::dsl::{Expression, Unit};
use syn::Ident;

/// Outputs that belong in one figure.
pub struct OutputGroup {
    /// The group's name; `None` for an output that stands alone.
    pub name: Option<Ident>,
    /// The title of the figure.
    pub title: Option<String>,
    /// Its outputs.
    pub outputs: Vec<Output>,
}

/// `x6 [m] = C.x;`
pub struct Output {
    /// Documentation.
    pub docs: String,
    /// Its name.
    pub name: Ident,
    /// The unit it is reported in.
    pub unit: Option<Unit>,
    /// Its expression.
    pub value: Expression,
}
