//! The error of a step in its work. Under forces that are polynomials of time positions and speeds may be exact however long a step
//! is, and the work is not.

use sim_kernel::{Mask, Scalar};

/// The error of the work in tolerances that counts as one: in other motions that of positions and speeds is larger.
const MOST: f64 = 1000.0;

/// Speeds of fewer tolerances are those of rest, where work is what rounding leaves.
const AT_REST: f64 = 1000.0;

/// The larger one of the error of positions and speeds, in tolerances, and that of the work, as a part of the largest energy: one of
/// these works, or a kinetic energy, which is asked for where it matters. So are speeds, in tolerances.
pub(super) fn with_work<S: Scalar>(
    error: S,
    of_work: S,
    works: impl Iterator<Item = S>,
    relative: f64,
    (kinetic_energies, speeds): (impl FnOnce() -> [S; 2], impl FnOnce() -> S),
) -> S {
    let in_tolerances = |energy: S| of_work / (S::from_f64(MOST * relative) * energy);
    let largest = works.fold(S::ZERO, larger);
    // False where no work is done at all.
    if !in_tolerances(largest).greater(error).any() {
        return error;
    }
    let of_work = in_tolerances(kinetic_energies().into_iter().fold(largest, larger));
    S::select(of_work.greater(error) & speeds().greater(S::from_f64(AT_REST)), of_work, error)
}

/// The larger one of an energy and the size of another.
fn larger<S: Scalar>(largest: S, energy: S) -> S {
    S::select(energy.abs().greater(largest), energy.abs(), largest)
}
