//! Forces and reactions as arrows on the mechanism.
//!
//! The declaration is read again, and the loads, the points they act at and the constraints' derivatives by their points
//! are evaluated as outputs of it, by the interpreter that also checks the kernels.

#[cfg(feature = "analysis")]
mod arrows;
#[cfg(feature = "analysis")]
mod evaluate;
#[cfg(feature = "analysis")]
mod expressions;

/// A force that can be drawn.
pub(super) struct Vector {
    /// The label of its arrow.
    pub(super) label: String,
    /// Its kind.
    pub(super) about: String,
    /// `load` or `reaction`.
    pub(super) kind: &'static str,
}

#[cfg(feature = "analysis")]
pub(super) use evaluate::vectors;

/// None: the declaration cannot be read again.
#[cfg(not(feature = "analysis"))]
pub(super) fn vectors(
    _: &dyn crate::outcome::Rows,
    _: &sim_kernel::Description,
    _: &[usize],
) -> Vec<(Vector, Vec<f64>)> {
    Vec::new()
}
