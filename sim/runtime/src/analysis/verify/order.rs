//! The order of convergence that a method shows.

use super::Check;
use super::runs::{RESTS, Sizes};
use super::worst::Worst;
use crate::integrate::{Advance, Course, Dop853, Steps, integrate};
use crate::motion::Motion;
use crate::motion::measures::Measures;
use crate::state::failure::Failure;
use crate::state::settings::{Stabilisation, Stepping};
use crate::state::trajectory::{Sample, State};
use sim_kernel::Mechanism;
use std::ops::ControlFlow;

/// The error is the largest at this many equidistant times: at a single one it may happen to vanish.
const TIMES: usize = 4;
/// The relative error below which terms of higher order are small and the order shows.
const ASYMPTOTIC: f64 = 1e-4;
/// An error is known to one digit if it exceeds the error of the reference by this factor.
const READABLE: f64 = 30.0;
/// The error may be as large as if one halving of the step had no effect: its constant changes with the step by terms
/// of the next order, which are not negligible at the first error. A method whose order is lower by one exceeds this
/// after five halvings, by two after three.
const BOUND: f64 = 16.0;
/// Projection leaves a residual of 1e-12 of a constraint's terms, which the geometry of a loop may magnify ten times:
/// smaller errors are not used.
const OPEN: f64 = 1e-11;

/// The reference is exact to rounding of its steps if it is known so well; in a motion that is not smooth it is not.
const ROUNDING: f64 = 1e-11;

/// What the check is called.
const NAME: &str = "order of convergence";

/// The binary logarithm of the number of steps, and the error.
type Measured = (i32, f64);

/// The order of a method along a motion: its error at the smallest step where it exceeds rounding, relative to that
/// predicted by the order from the first in the asymptotic range.
///
/// # Errors
/// If the motion fails.
pub fn order_of_convergence<M: Mechanism, A: Advance<M>>(
    mechanism: &M,
    start: State<M>,
    end: f64,
    method: impl Fn() -> A,
    order: f64,
) -> Result<Check, Failure> {
    let check = |figure: f64, meaning: String| Ok(Check::new(NAME, figure, BOUND, meaning));
    let unmade = |why: String| Ok(Check::unmade(NAME, BOUND, why));
    let reference = states(mechanism, start.clone(), end, &mut Dop853::new(mechanism), 4096)?;
    let sizes = Sizes::of(mechanism, &reference);
    if sizes.at_rest {
        return unmade(RESTS.into());
    }
    let distance = |found: &[Sample<M>]| {
        let mut worst = Worst::default();
        found.iter().zip(&reference).for_each(|(a, b)| sizes.compare(mechanism, &a.state, &b.state, &mut worst));
        worst.figure
    };
    // The error of order 8, and rounding.
    let floor = distance(&states(mechanism, start.clone(), end, &mut Dop853::new(mechanism), 2048)?).max(f64::EPSILON);
    let open = if mechanism.m() > 0 { OPEN } else { 0.0 };
    let (mut first, mut last): (Option<Measured>, Option<Measured>) = (None, None);
    for power in 2..16 {
        let foretold = |(at, error): Measured| error * (-order * f64::from(power - at)).exp2();
        if first.is_some_and(|first| foretold(first) < READABLE * floor) {
            break;
        }
        // Steps too large for the motion are skipped.
        let Ok(found) = states(mechanism, start.clone(), end, &mut method(), 1 << power) else { continue };
        let error = distance(&found);
        match first {
            None if error > ASYMPTOTIC => {}
            None if error < (READABLE * order.exp2() * floor).max(open) => {
                return Ok(unread(error, floor));
            }
            None => first = Some((power, error)),
            Some(_) => last = Some((power, error)),
        }
    }
    let (Some((coarse, error)), Some((fine, left))) = (first, last) else {
        if floor > ROUNDING {
            return unmade(format!("not checked: equal steps tell the motion itself to {floor:.1e} alone"));
        }
        return check(f64::INFINITY, "no step is small enough for the method to converge".into());
    };
    let halvings = fine - coarse;
    let observed = (error / left).log2() / f64::from(halvings);
    let figure = left / (error * (-order * f64::from(halvings)).exp2()).max(open);
    check(
        figure,
        format!(
            "error relative to that predicted by order {order} from {halvings} halvings before; observed {observed:.2}"
        ),
    )
}

/// Where errors are too small beside that of the reference to show an order.
fn unread(error: f64, floor: f64) -> Check {
    match floor < ROUNDING {
        true => Check::new(NAME, 0.0, BOUND, format!("exact to rounding: error {error:.1e}, known to {floor:.1e}")),
        false => Check::unmade(
            NAME,
            BOUND,
            format!(
                "not checked: the motion itself is known to {floor:.1e} alone, and an error of {error:.1e} is too near to that"
            ),
        ),
    }
}

/// The motion by equal steps, at equidistant times.
fn states<M: Mechanism>(
    mechanism: &M,
    start: State<M>,
    end: f64,
    method: &mut dyn Advance<M>,
    steps: usize,
) -> Result<Vec<Sample<M>>, Failure> {
    let measures = Measures::at(mechanism, start.time, &start.positions);
    let motion = Motion::new(mechanism.clone(), Stabilisation::Projection, measures);
    let course = Course { begin: start.time, end, stepping: Stepping::Equal(steps) };
    // A step may be split, so times are identified by their middles.
    let begin = start.time;
    let time = |k: usize| begin + (end - begin) * (k as f64 + 0.5) / steps as f64;
    let mut found: Vec<Sample<M>> = Vec::new();
    integrate(&motion, method, &course, motion.sample(start)?, &mut Steps::default(), |step| {
        if step.to.state.time > time((found.len() + 1) * (steps / TIMES) - 1) {
            found.push(step.to.clone());
        }
        Ok(ControlFlow::Continue(()))
    })?;
    Ok(found)
}
