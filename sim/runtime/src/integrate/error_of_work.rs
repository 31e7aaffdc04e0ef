//! The error of a step in its work. Under forces that are polynomials of time positions and speeds may be exact however long a step
//! is, and the work is not.

use sim_kernel::{Mask, Scalar};

/// The error of the work in tolerances that counts as one: in other motions that of positions and speeds is larger.
const MOST: f64 = 1000.0;

/// Speeds of fewer tolerances are those of rest, where work is what rounding leaves.
const AT_REST: f64 = 1000.0;

/// The larger one of the error of positions and speeds, in tolerances, and that of the work, as a part of the largest energy: the
/// work at both ends, or what is asked for where that does not settle it: the works of stages, kinetic energies, and how many
/// tolerances the speeds are.
#[inline(always)]
pub(super) fn with_work<S: Scalar>(
    [error, of_work]: [S; 2],
    [from, to]: [S; 2],
    relative: f64,
    (others, speeds): (impl FnOnce() -> S, impl FnOnce() -> S),
) -> S {
    let in_tolerances = |energy: S| of_work / (S::from_f64(MOST * relative) * energy);
    let largest = larger(from.abs(), to);
    // False where there is no error.
    if !in_tolerances(largest).greater(error).any() {
        return error;
    }
    let of_work = in_tolerances(larger(largest, others()));
    S::select(of_work.greater(error) & speeds().greater(S::from_f64(AT_REST)), of_work, error)
}

/// The larger one of an energy and the size of another.
pub(super) fn larger<S: Scalar>(largest: S, energy: S) -> S {
    S::select(energy.abs().greater(largest), energy.abs(), largest)
}
