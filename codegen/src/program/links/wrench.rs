//! Forces and moments about the origin of a frame.

use super::tree::{Column, LinkValues};
use super::triple::{Triple, add, apply, cross, dot, sum};
use crate::program::values::{Value, Values};

/// Moment and force.
pub(super) type Wrench = [Triple; 2];

impl LinkValues {
    /// The work of a wrench along a column.
    pub(super) fn along(&self, values: &mut Values, column: &Column, [moment, force]: &Wrench) -> Value {
        let pushed = apply(values, &self.turn, force);
        let parts = [dot(values, &column.spin, moment), dot(values, &column.shift, &pushed)];
        sum(values, &parts)
    }

    /// A wrench in the frame before, about the origin there.
    pub(super) fn wrench_before(&self, values: &mut Values, wrench: &Wrench) -> Wrench {
        let turned = wrench.map(|part| apply(values, &self.turn, &part));
        moved(values, &self.offset[0], &turned)
    }
}

/// A wrench about an origin from which its own stands at r.
pub(super) fn moved(values: &mut Values, r: &Triple, [moment, force]: &Wrench) -> Wrench {
    let arm = cross(values, r, force);
    [add(values, moment, &arm), *force]
}
