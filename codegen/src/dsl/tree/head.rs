//! The head of a declaration.

use syn::{Ident, Visibility};

/// Documentation, visibility and name: all that the stub of a mechanism with mistakes needs.
#[derive(Clone)]
pub struct Head {
    /// Documentation, one line each.
    pub docs: String,
    /// `pub` and its like.
    pub visibility: Visibility,
    /// The type's name.
    pub name: Ident,
}
