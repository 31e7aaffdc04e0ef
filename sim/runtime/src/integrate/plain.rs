//! One attempted step of a plain motion, on numbers of any kind.

use super::attempt::{distance, with_move};
use super::explicit::ExplicitRungeKutta;
use super::method::Attempt;
use crate::motion::field::Field;
use crate::motion::plain::Plain;
use crate::state::failure::Failure;
use crate::state::settings::Tolerance;
use crate::state::trajectory::Sample;
use sim_kernel::{Mechanism, Scalar};

/// The end of an attempted step.
#[derive(Clone, Debug)]
pub(crate) struct Reached<M: Mechanism<S>, S: Scalar> {
    /// Its end, on the constraints.
    pub(crate) to: Sample<M, S>,
    /// The estimate of its error by the method, its move by the projection, and its length before that, in units of the
    /// tolerance; 0 without one.
    errors: [S; 3],
    /// 1/s^2 there, as [`Plain::keep`].
    pub(crate) closeness: S,
    /// The number of right-hand sides evaluated, of which one at its end.
    pub(crate) evaluations: u64,
}

impl<S: Scalar, M: Mechanism<S>> Reached<M, S> {
    /// The estimate of the error in a lane, as [`attempt`](super::attempt::attempt) gives it, from these numbers of that
    /// lane.
    pub(crate) fn error(&self, in_lane: impl Fn(S) -> f64) -> f64 {
        let [error, moved, gained] = self.errors.map(&in_lane);
        if error <= 1.0 { with_move(error, [moved, gained], 1.0 / in_lane(self.closeness).sqrt()) } else { error }
    }
}

/// One step in each lane, with its end on the constraints.
///
/// # Errors
/// If any lane fails.
#[inline(always)]
pub(crate) fn attempt_plainly<S: Scalar, M: Mechanism<S>>(
    plain: &Plain<M, S>,
    method: &mut ExplicitRungeKutta<M, S>,
    from: &Sample<M, S>,
    time: S,
    tolerance: Option<&Tolerance>,
) -> Result<Reached<M, S>, Failure> {
    let evaluations = plain.evaluations.get();
    let Attempt { end: before, error } = method.advance(plain, from, time, tolerance)?;
    let mut end = before.clone();
    let closeness = plain.keep(&mut end)?;
    let moves = [[&before, &end], [&from.state, &before]];
    let [moved, gained] =
        moves.map(|[a, b]| tolerance.map_or(S::ZERO, |given| distance(given, plain.measures(), a, b)));
    let to = plain.sample(end)?;
    Ok(Reached { to, errors: [error, moved, gained], closeness, evaluations: plain.evaluations.get() - evaluations })
}
