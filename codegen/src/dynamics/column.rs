//! A column of the derivatives of the residual.

use crate::symbolic::Expr;

/// Derivatives with respect to one variable.
pub struct Column {
    /// Of r - K z at fixed accelerations and multipliers, n + m.
    pub residual: Vec<Expr>,
    /// Of the angles by which rows are turned, one for each turn.
    pub angles: Vec<Expr>,
}
