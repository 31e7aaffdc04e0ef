//! Verification of a mechanism's kernels, equations and runs: independent computations of the same numbers, compared.
//!
//! Each check is a function of its own that returns the difference of two computations and its bound.

mod declared;
mod derivatives;
mod freed;
mod lagrange;
mod oracle;
mod order;
mod runs;
mod scale;
mod smooth;
mod worst;

pub use declared::Declared;
pub use derivatives::jacobians_against_duals;
pub use freed::reactions_against_balance;
pub use lagrange::lagrange_against_kernels;
pub use oracle::{computed, kernels_against_oracle, observed};
pub use order::order_of_convergence;
pub use runs::{constraint_residuals, difference, energy_balance, runs_agree};

use derivatives::compare_with_duals;
use freed::check_balance;
use lagrange::compare_with_lagrange;
use oracle::compare_with_oracle;
use smooth::smooth;

use crate::integrate::{Course, Dop853, ExplicitRungeKutta, RK4, Steps, integrate};
use crate::model::{At, Differentiable};
use crate::motion::Motion;
use crate::motion::measured::mobility;
use crate::motion::measures::Measures;
use crate::motion::typed::Any;
use crate::run::{Run, run_while};
use crate::start::assemble::{Start, assemble};
use crate::state::failure::Failure;
use crate::state::settings::{Method, Settings, Stabilisation, Stepping, Tolerance};
use crate::state::trajectory::Sample;
use sim_kernel::Mechanism;
use std::ops::ControlFlow;

/// The result of a check.
#[derive(Clone, Debug, PartialEq)]
pub struct Check {
    /// The compared computations.
    pub name: &'static str,
    /// The difference; none if there was nothing to compare.
    pub figure: Option<f64>,
    /// The largest allowed difference.
    pub bound: f64,
    /// The meaning of the figure, and its place.
    pub meaning: String,
}

impl Check {
    fn new(name: &'static str, figure: f64, bound: f64, meaning: String) -> Check {
        Check { name, figure: Some(figure), bound, meaning }
    }

    /// One that had nothing to compare, for a reason.
    fn unmade(name: &'static str, bound: f64, why: String) -> Check {
        Check { name, figure: None, bound, meaning: why }
    }

    /// Whether it passes: the figure is within its bound (NaN is not), or there was nothing to compare.
    pub fn passes(&self) -> bool {
        self.figure.is_none_or(|figure| figure <= self.bound)
    }
}

/// Why a mechanism could not be verified.
#[derive(Debug, thiserror::Error)]
pub enum VerifyError {
    /// Its motion fails.
    #[error("the run to be verified failed {0}")]
    Run(Failure),
    /// Its declaration cannot be read again, or interpreted.
    #[error("the declaration cannot be interpreted: {0}")]
    Declaration(String),
}

impl From<Failure> for VerifyError {
    fn from(failure: Failure) -> VerifyError {
        VerifyError::Run(failure)
    }
}

/// Relative tolerance of the runs that are compared.
const TOLERANCE: f64 = 1e-11;
/// Steps of DOP853 that are verified.
const STEPS: u64 = 150;
/// States at which kernels are compared.
const STATES: usize = 64;

/// Every check of a mechanism along its motion from a start: to `end`, or for as long as 150 steps of DOP853 take.
///
/// # Errors
/// If no start can be assembled, the motion fails, or the declaration cannot be read.
pub fn verify<M: Mechanism>(mechanism: M, start: &Start<M>, end: f64) -> Result<Vec<Check>, VerifyError> {
    verify_while(mechanism, start, end, &|| true)
}

/// The same for as long as `goes_on` says so, which is asked after each step of a run.
///
/// # Errors
/// As [`verify`], and [`What::Interrupted`](crate::What::Interrupted).
#[inline(never)]
pub fn verify_while<M: Mechanism>(
    mechanism: M,
    start: &Start<M>,
    end: f64,
    goes_on: &dyn Fn() -> bool,
) -> Result<Vec<Check>, VerifyError> {
    let end = span(&mechanism, start, end)?;
    let declared = Declared::of(&mechanism)?;
    let with = |method, stabilisation| {
        let settings = Settings { stabilisation, ..Settings::adaptive(method, end, TOLERANCE) };
        let found = run_while(mechanism.clone(), start, &settings, &mut |_| goes_on())?;
        match found.trajectory.failure {
            Some(failure) => Err(VerifyError::Run(failure)),
            None => Ok(found),
        }
    };
    let projected = with(Method::Dop853, Stabilisation::Projection)?;
    let parts = parts(&projected);
    let first = projected.trajectory.samples[0].state.clone();
    let smooth = smooth(&projected, end);
    let any: Vec<Any<M>> = parts.iter().map(|(mechanism, _)| Any(mechanism)).collect();
    let parts: Vec<Part> = any.iter().zip(&parts).map(|(any, (_, samples))| (any as _, places(samples))).collect();
    let mut checks = kernels_agree(&declared, &parts)?;
    if mechanism.m() > 0 {
        checks.push(constraint_residuals(&projected));
    }
    checks.push(energy_balance(&projected));
    let otherwise = with(Method::Dopri5, Stabilisation::Projection)?;
    checks.push(runs_agree("DOP853 against DOPRI5", &projected, &otherwise));
    checks.push(order_of_convergence(&mechanism, first, smooth, || ExplicitRungeKutta::new(&mechanism, &RK4), 4.0)?);
    if mechanism.m() > 0 {
        let partitioned = with(Method::Dop853, Stabilisation::Partitioning)?;
        checks.push(runs_agree("projection against partitioning", &projected, &partitioned));
    }
    Ok(checks)
}

/// The kernels against other formulations, at samples of a run.
fn kernels_agree(declared: &Declared, parts: &[Part]) -> Result<Vec<Check>, VerifyError> {
    Ok(vec![
        worst(parts, &|mechanism, samples| compare_with_lagrange(mechanism, declared, samples))?,
        worst(parts, &|mechanism, samples| compare_with_oracle(mechanism, declared, samples))?,
        worst(parts, &|mechanism, samples| Ok(compare_with_duals(mechanism, samples)))?,
        worst(parts, &|mechanism, samples| check_balance(mechanism, declared, samples))?,
    ])
}

/// Samples of a mechanism of any type.
fn places<M: Mechanism>(samples: &[Sample<M>]) -> Vec<At<'_, f64>> {
    samples.iter().map(At::sample).collect()
}

/// `end`, or the time that so many steps take.
fn span<M: Mechanism>(mechanism: &M, start: &Start<M>, end: f64) -> Result<f64, Failure> {
    let first = assemble(mechanism, start)?;
    let mobility = mobility(mechanism, first.time, &first.positions);
    mobility.check_regular(mechanism, first.time, &first.positions)?;
    let measures = Measures::with_mobility(mechanism, first.time, &first.positions, &mobility);
    let motion = Motion::new(mechanism.clone(), Stabilisation::Projection, measures);
    let course = Course { begin: 0.0, end, stepping: Stepping::Adaptive(Tolerance::new(TOLERANCE)) };
    let (mut steps, mut count, mut reached) = (Steps::default(), 0, first.time);
    integrate(&motion, &mut Dop853::new(motion.mechanism()), &course, motion.sample(first)?, &mut steps, |step| {
        (count, reached) = (count + 1, step.to.state.time);
        Ok(if count < STEPS { ControlFlow::Continue(()) } else { ControlFlow::Break(()) })
    })?;
    Ok(reached)
}

/// Some samples of a run, evenly spread, with the mechanism that they belong to.
fn parts<M: Mechanism>(run: &Run<M>) -> Vec<(M, Vec<Sample<M>>)> {
    let mut parts: Vec<(M, Vec<Sample<M>>)> = Vec::new();
    let is_same = |a: &M, b: &M| {
        let (parameters, inputs, activities) = (a.parameters(), a.inputs(), a.activities());
        parameters.as_ref() == b.parameters().as_ref()
            && inputs.as_ref() == b.inputs().as_ref()
            && activities.as_ref() == b.activities().as_ref()
    };
    let stride = (run.trajectory.samples.len() / STATES).max(1);
    for (mechanism, sample) in run.trajectory.with_mechanisms(&run.mechanism).step_by(stride) {
        match parts.iter_mut().find(|(other, _)| is_same(&mechanism, other)) {
            Some((_, samples)) => samples.push(sample.clone()),
            None => parts.push((mechanism, vec![sample.clone()])),
        }
    }
    parts
}

/// A mechanism of any type, and samples of it.
type Part<'p> = (&'p dyn Differentiable, Vec<At<'p, f64>>);

/// A check of a mechanism at some samples.
type CheckOfPart<'c> = dyn Fn(&dyn Differentiable, &[At<f64>]) -> Result<Check, VerifyError> + 'c;

/// The largest difference in any part.
fn worst(parts: &[Part], check: &CheckOfPart) -> Result<Check, VerifyError> {
    let checks = parts.iter().map(|(mechanism, samples)| check(*mechanism, samples));
    let checks = checks.collect::<Result<Vec<Check>, VerifyError>>()?;
    let size = |check: &Check| check.figure.map_or(-1.0, |figure| if figure.is_nan() { f64::INFINITY } else { figure });
    let worst = checks.into_iter().reduce(|a, b| if size(&b) > size(&a) { b } else { a });
    worst.ok_or_else(|| VerifyError::Declaration("the run has no samples".into()))
}
