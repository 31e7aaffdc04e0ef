//! Forces and reactions as arrows on the mechanism.

use crate::{Run, Sample};
use sim_kernel::Mechanism;
use std::marker::PhantomData;

/// A force that can be drawn.
pub(super) struct Vector<M: Mechanism> {
    /// What stands at its arrow.
    pub(super) label: String,
    /// What it is.
    pub(super) about: String,
    /// `load` or `reaction`.
    pub(super) kind: &'static str,
    of: PhantomData<M>,
}

impl<M: Mechanism> Vector<M> {
    /// The point it acts at and its components at a sample.
    pub(super) fn at(&self, _sample: &Sample<M>) -> [f64; 4] {
        [f64::NAN; 4]
    }
}

/// The forces of a run.
pub(super) fn vectors<M: Mechanism>(_run: &Run<M>) -> Vec<Vector<M>> {
    Vec::new()
}
