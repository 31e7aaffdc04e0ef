//! The order of convergence that a method shows.

use super::Check;
use crate::failure::Failure;
use crate::integrate::{Advance, Course, Dop853, Steps, integrate};
use crate::measures::Measures;
use crate::motion::Motion;
use crate::settings::{Stabilisation, Stepping};
use crate::trajectory::State;
use sim_kernel::{Array, Mechanism};
use std::ops::ControlFlow;

/// Errors below this are rounding.
const FLOOR: f64 = 1e-11;

/// A method shows its order along a motion: the step is halved until the error is down to rounding.
///
/// # Errors
/// If the motion fails.
pub fn order_of_convergence<M: Mechanism, A: Advance<M>>(
    mechanism: &M,
    start: State<M>,
    end: f64,
    method: impl Fn() -> A,
    expected: f64,
) -> Result<Check, Failure> {
    let (order, error) = observed_order(mechanism, start, end, method)?;
    let exact = order.is_nan() && error <= FLOOR;
    let meaning = match exact {
        true => format!("exact to rounding: error {error:.1e}"),
        false => format!("observed {order:.3} at error {error:.1e}, expected {expected}: what is missing"),
    };
    // More than the order is chance, less is a mistake.
    let figure = match order.is_nan() {
        true if exact => 0.0,
        true => f64::NAN,
        false => (expected - order).max(0.0),
    };
    Ok(Check { name: "order of convergence", figure, bound: 0.3, meaning })
}

/// The order between the two finest steps whose errors at the end are above rounding, and the error of the finer; NaN if
/// there are no two.
///
/// # Errors
/// If the motion fails.
pub fn observed_order<M: Mechanism, A: Advance<M>>(
    mechanism: &M,
    start: State<M>,
    end: f64,
    method: impl Fn() -> A,
) -> Result<(f64, f64), Failure> {
    let exact = state_at(mechanism, start, end, &mut Dop853::new(), 4096)?;
    let (mut order, mut last) = (f64::NAN, f64::NAN);
    for power in 5..16 {
        // Steps too large for the motion say nothing.
        let Ok(found) = state_at(mechanism, start, end, &mut method(), 1 << power) else { continue };
        let error = distance(&found, &exact);
        if error < FLOOR {
            return Ok((order, if last.is_nan() { error } else { last }));
        }
        (order, last) = ((last / error).log2(), error);
    }
    Ok((order, last))
}

fn state_at<M: Mechanism>(
    mechanism: &M,
    start: State<M>,
    end: f64,
    method: &mut dyn Advance<M>,
    steps: usize,
) -> Result<State<M>, Failure> {
    let measures = Measures::at(mechanism, start.time, &start.positions);
    let motion = Motion::new(mechanism, Stabilisation::Projection, measures);
    let course = Course { begin: start.time, end, stepping: Stepping::Equal(steps), interrupt: None };
    let mut last = start;
    integrate(&motion, method, &course, motion.sample(start)?, &mut Steps::default(), |step| {
        last = step.to.state;
        Ok(ControlFlow::Continue(()))
    })?;
    Ok(last)
}

/// The largest difference of a coordinate or speed, relative to its size or to 1 in SI units, whichever is larger.
fn distance<M: Mechanism>(a: &State<M>, b: &State<M>) -> f64 {
    let pairs = a.positions.iter().zip(b.positions.iter()).chain(a.speeds.iter().zip(b.speeds.iter()));
    pairs.fold(0.0, |worst, (a, b)| {
        let apart = (a - b).abs() / b.abs().max(1.0);
        if apart <= worst { worst } else { apart }
    })
}
