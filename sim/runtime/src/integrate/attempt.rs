//! One attempted step, and why it may fail.
//!
//! A projection that moves the end of a step by more than a thousand tolerances is refused: it would lead to another
//! branch of the motion. So is one that takes back what the step gained: a motion that ends at a kink of a constraint would
//! stand still there while time goes on.

use super::method::{Advance, Attempt};
use super::sticking::sticks;
use crate::motion::Motion;
use crate::motion::generalized_speeds::has_generalized_speeds;
use crate::motion::gimbal;
use crate::motion::measures::Measures;
use crate::motion::residuals::rates;
use crate::motion::singular::{AT, weakest_constraint};
use crate::state::failure::{Failure, What, constraint_name, largest};
use crate::state::settings::Tolerance;
use crate::state::trajectory::{Sample, State};
use sim_kernel::{Array, Mechanism, Scalar};

/// The largest move of a step's end by projection, in units of the tolerance: further away lies another branch of the
/// motion.
const MOST_MOVED: f64 = 1000.0;
/// The same at a singular position, where rounding moves it.
const MOST_MOVED_THERE: f64 = 1.0;

/// The largest part of a step that its projection may take back.
const MOST_TAKEN_BACK: f64 = 0.5;

/// The differences of positions and speeds.
pub(super) fn difference<S: Scalar, M: Mechanism<S>>(a: &State<M, S>, b: &State<M, S>) -> [M::Q; 2] {
    [a.positions.zip_with(&b.positions, |a, b| *a - *b), a.speeds.zip_with(&b.speeds, |a, b| *a - *b)]
}

/// One step, with its end on the constraints; gives the estimate of its error.
#[inline]
pub(super) fn attempt<M: Mechanism>(
    motion: &Motion<M>,
    method: &mut dyn Advance<M>,
    from: &Sample<M>,
    time: f64,
    tolerance: Option<&Tolerance>,
    to: &mut Sample<M>,
) -> Result<f64, Failure> {
    motion.prepare(from, time);
    if has_generalized_speeds(motion.mechanism()) {
        motion.choose_velocity_variables(from, time, method.is_explicit());
    }
    let mut made = method.step(motion, from, time, tolerance);
    if has_generalized_speeds(motion.mechanism()) && made.as_ref().is_err_and(|failure| motion.falls_back(failure)) {
        made = method.step(motion, from, time, tolerance);
    }
    // It is used where it stands: a copy would wait until all of the step is in memory.
    let (end, error) = match &mut made {
        Ok(Attempt { end, error }) => (end, *error),
        Err(failure) => return Err(failure.clone()),
    };
    if !(error <= 1.0) {
        return Ok(error);
    }
    let before = tolerance.map(|tolerance| (tolerance, end.clone()));
    let longest = motion.longest();
    motion.keep(end).inspect_err(|_| motion.forget(&longest))?;
    let moves = before.map(|(tolerance, before)| {
        let moved = distance(tolerance, motion.measures(), &before, end);
        // Seldom needed.
        let gained = if moved > 1.0 { distance(tolerance, motion.measures(), &from.state, &before) } else { 0.0 };
        [moved, gained]
    });
    *to = motion.sample_in_place(end.clone())?;
    let error = moves.map_or(error, |moves| with_move(error, moves, motion.relative_sine()));
    if !(error <= 1.0) {
        motion.forget(&longest);
    }
    Ok(error)
}

/// How far two states are apart, in units of the tolerance.
#[inline]
pub(super) fn distance<S: Scalar, M: Mechanism<S>>(
    tolerance: &Tolerance,
    measures: &Measures<M, S>,
    a: &State<M, S>,
    b: &State<M, S>,
) -> S {
    let [positions, speeds] = difference(a, b);
    tolerance.norm(measures, a, b, [&positions, &speeds])
}

/// The estimate of an error with the move by projection, in units of the tolerance, to where this is the smallest sine.
/// Infinite where the projection takes the step back, which gained so much.
#[inline]
pub(super) fn with_move(error: f64, [moved, gained]: [f64; 2], sine: f64) -> f64 {
    if moved > 1.0 && moved > MOST_TAKEN_BACK * gained {
        return f64::INFINITY;
    }
    error.max(moved / if sine < AT { MOST_MOVED_THERE } else { MOST_MOVED })
}

/// A constraint whose rows are this close to dependence, as a sine, explains why a step fails.
const NEARLY_SINGULAR: f64 = 1e-2;

/// Why no step is small enough: a singular position, the failure of the last attempt, or the tolerance.
pub(super) fn too_small<M: Mechanism>(motion: &Motion<M>, at: &State<M>, step: f64, cause: Option<Failure>) -> Failure {
    let too_small = || if sticks(motion, at) { What::Sticks } else { What::StepTooSmall { step } };
    let cause = cause.unwrap_or_else(|| Failure::at(motion.mechanism(), too_small(), at.time, &at.positions));
    gimbal::explained(explained(motion, at, cause), motion.mechanism(), at.time, &at.positions)
}

/// The part of a constraint's scale, or of its terms, by which a jump of speeds that counts opens it in the longest step.
const LEAST_JUMP: f64 = 1e-9;

/// Whether the speeds at a sample still meet the constraints so much later: accelerations alone jump there, as at the rows of a
/// table of time. The longest step was so long.
pub(super) fn keeps_its_speeds<M: Mechanism>(motion: &Motion<M>, at: &Sample<M>, [later, longest]: [f64; 2]) -> bool {
    let (mechanism, time) = (motion.mechanism(), at.state.time + later);
    let ahead = at.state.changed(time, later, &at.rates());
    let linear = mechanism.constraint_linearization(time, &ahead.positions);
    let open = rates(mechanism, &linear, &ahead.speeds);
    // The scale of a start at the origin says little of where the motion has come.
    let (sizes, terms) = (motion.measures().constraints(), mechanism.constraint_magnitudes(time, &ahead.positions));
    (0..open.len()).all(|row| open[row].abs() * longest <= LEAST_JUMP * sizes[row].max(terms[row]))
}

/// The part of a time after which speeds that a jump of accelerations turns away from the constraints are so much nearer to them.
const SOONER: f64 = 0.25;
const NEARER: f64 = 0.5;

/// Whether speeds open the constraints the less, the shorter the time from a sample on: so they do where accelerations alone jump, as
/// at the rows of a table, but not beyond a kink.
pub(super) fn slows<M: Mechanism>(motion: &Motion<M>, at: &Sample<M>, ahead: f64) -> bool {
    let mechanism = motion.mechanism();
    let open = |later: f64| {
        let (time, there) = (at.state.time + later, at.state.changed(at.state.time + later, later, &at.rates()));
        rates(mechanism, &mechanism.constraint_linearization(time, &there.positions), &there.speeds)
    };
    let ([far, near], sizes) = ([ahead, SOONER * ahead].map(open), motion.measures().constraints());
    let largest = |open: &M::L| (0..open.len()).fold(0.0, |most: f64, row| most.max(open[row].abs() / sizes[row]));
    largest(&near) <= NEARER * largest(&far)
}

/// Why the constraints take steps back from a state on.
pub(super) fn taken_back<M: Mechanism>(motion: &Motion<M>, at: &Sample<M>, step: f64) -> Failure {
    let ahead = at.state.changed(at.state.time + step, step, &at.rates());
    let opened = motion.mechanism().constraints(ahead.time, &ahead.positions);
    let row = largest(opened.iter()).map_or(0, |(row, _)| row);
    let what = What::Kink { constraint: constraint_name(motion.mechanism(), row) };
    Failure::at(motion.mechanism(), what, at.state.time, &at.state.positions)
}

/// A failure that a singular position explains, as such.
pub(super) fn explained<M: Mechanism>(motion: &Motion<M>, at: &State<M>, failure: Failure) -> Failure {
    let has_reason = matches!(failure.what, What::NotFinite { .. } | What::Interrupted);
    match weakest_constraint(motion, at).filter(|(_, sine)| !has_reason && *sine < NEARLY_SINGULAR) {
        Some((constraint, _)) => {
            Failure::at(motion.mechanism(), What::SingularPosition { constraint }, at.time, &at.positions)
        }
        None => failure,
    }
}
