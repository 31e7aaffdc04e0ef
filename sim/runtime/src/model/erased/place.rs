//! A place in the motion, by references to whole arrays: these can be told apart by their numbers.

use super::arrays::Storage;
use crate::model::At;
use sim_kernel::Scalar;
use std::any::Any;

/// Time, coordinates, speeds, accelerations and multipliers.
pub(super) struct Place<'a, K: Storage, S: Scalar> {
    time: S,
    /// Positions, speeds, accelerations, multipliers.
    arrays: [Option<&'a K::Array<S>>; 4],
}

impl<'a, K: Storage, S: Scalar> Place<'a, K, S> {
    /// A time alone.
    pub(super) fn at(time: S) -> Self {
        Place { time, arrays: [None; 4] }
    }

    /// Without speeds, accelerations and multipliers.
    pub(super) fn of(time: S, q: &'a K::Array<S>) -> Self {
        Place { time, arrays: [Some(q), None, None, None] }
    }

    /// Without accelerations and multipliers.
    pub(super) fn moving(time: S, q: &'a K::Array<S>, qd: &'a K::Array<S>) -> Self {
        Place { time, arrays: [Some(q), Some(qd), None, None] }
    }

    /// Of all.
    pub(super) fn of_all(time: S, arrays: [&'a K::Array<S>; 4]) -> Self {
        Place { time, arrays: arrays.map(Some) }
    }

    /// With accelerations.
    pub(super) fn with_accelerations(mut self, qdd: &'a K::Array<S>) -> Self {
        self.arrays[2] = Some(qdd);
        self
    }

    /// The place as one in numbers of this kind, if it is.
    #[inline]
    pub(super) fn on<T: Scalar>(&self) -> Option<At<'a, T>> {
        let time = *(&self.time as &dyn Any).downcast_ref::<T>()?;
        let [positions, speeds, accelerations, multipliers] = self.arrays.map(|array| {
            let array = array.and_then(|array| (array as &dyn Any).downcast_ref::<K::Array<T>>());
            array.map_or(&[][..], AsRef::as_ref)
        });
        Some(At { time, positions, speeds, accelerations, multipliers })
    }
}
