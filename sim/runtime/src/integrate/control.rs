//! The step size control of adaptive methods.

use crate::motion::Motion;
use crate::state::failure::Failure;
use crate::state::saved::{Bytes, Damaged};
use crate::state::settings::Tolerance;
use crate::state::trajectory::Sample;
use sim_kernel::{Array, Mechanism};

/// Bounds of the ratio of successive steps.
const LEAST_RATIO: f64 = 0.2;
const LARGEST_RATIO: f64 = 6.0;
/// The safety factor.
const SAFETY: f64 = 0.9;

/// Proportional-integral control of steps (Gustafsson; Hairer, Wanner, Solving Ordinary Differential Equations II,
/// IV.2): h grows by 0.9 err^-(1/k - 3 b/4) err_old^b with b = 1/(5k), where k is the order of control.
#[derive(Clone, Copy, Debug)]
pub(super) struct Controller {
    order: f64,
    previous_error: f64,
    /// No growth in the step after a rejected one.
    rejected: bool,
}

impl Controller {
    pub(super) fn new(order: f64) -> Controller {
        Controller { order, previous_error: 1e-4, rejected: false }
    }

    /// Its state as bytes, or from them.
    pub(super) fn transfer(&mut self, bytes: &mut Bytes) -> Result<(), Damaged> {
        bytes.number(&mut self.previous_error)?;
        bytes.flag(&mut self.rejected)
    }

    /// The ratio of the next step to one with this error, which was accepted.
    pub(super) fn accepted(&mut self, error: f64) -> f64 {
        let integral = 0.2 / self.order;
        let error = error.max(1e-10);
        let ratio = SAFETY * error.powf(0.75 * integral - 1.0 / self.order) * self.previous_error.powf(integral);
        let most = if self.rejected { 1.0 } else { LARGEST_RATIO };
        (self.previous_error, self.rejected) = (error.max(1e-4), false);
        ratio.clamp(LEAST_RATIO, most)
    }

    /// The ratio of the next attempt to one with this error, which was too large, or which failed.
    pub(super) fn rejected(&mut self, error: Option<f64>) -> f64 {
        self.rejected = true;
        let ratio = error.map_or(0.25, |error| SAFETY * error.powf(-1.0 / self.order));
        if ratio.is_nan() { LEAST_RATIO } else { ratio.clamp(LEAST_RATIO, SAFETY) }
    }
}

/// A first step for a method of this order (Hairer, Norsett, Wanner I, II.4): small against the scales of the solution and
/// of its second derivative, which one explicit step of Euler's estimates.
pub(super) fn initial_step<M: Mechanism>(
    motion: &Motion<M>,
    start: &Sample<M>,
    span: f64,
    order: f64,
    tolerance: &Tolerance,
) -> Result<f64, Failure> {
    let (state, rates) = (&start.state, start.rates());
    let norm = |positions: &M::Q, speeds: &M::Q| tolerance.norm(motion.measures(), state, state, [positions, speeds]);
    let (size, slope) = (norm(&state.positions, &state.speeds), norm(&rates.positions, &rates.speeds));
    let tiny = size < 1e-5 || slope < 1e-5;
    let first = if tiny { 1e-6 * span } else { (0.01 * size / slope).min(span) };
    let ahead = motion.sample(state.changed(state.time + first, first, &rates))?.rates();
    let bend = |a: &M::Q, b: &M::Q| a.like(|i| a[i] - b[i]);
    let curvature = norm(&bend(&ahead.positions, &rates.positions), &bend(&ahead.speeds, &rates.speeds)) / first;
    let steepest = slope.max(curvature);
    let second = if steepest <= 1e-15 { 1e-3 * first } else { (0.01 / steepest).powf(1.0 / order) };
    Ok(second.min(100.0 * first).min(span))
}
