//! The reactions, body by body.

use super::declared::{Declared, held, solved, uninterpreted};
use super::scale::scales;
use super::worst::{Worst, largest, relative};
use super::{Check, VerifyError, places};
use crate::model::{AnyMechanism, At};
use crate::motion::typed::Any;
use crate::state::trajectory::Sample;
use codegen::oracle::State;
use sim_kernel::Mechanism;

/// The largest residual of a body's balance, relative to the largest force in any. Elimination in a planned order
/// amplifies rounding where masses are small relative to reactions. Both are divided by the root of their inertia, so
/// that vanishing forces, such as those on an upright link, are not compared with their own rounding. Largest in any
/// shipped mechanism: 1e-15.
const BALANCE: f64 = 1e-9;

/// Newton and Euler: each body freed, with its mass times its acceleration, the loads and the reactions lambda of the run.
///
/// # Errors
/// If the equations of motion cannot be solved at a sample, or the oracle cannot interpret the declaration.
pub fn reactions_against_balance<M: Mechanism>(
    mechanism: &M,
    declared: &Declared,
    samples: &[Sample<M>],
) -> Result<Check, VerifyError> {
    check_balance(&Any(mechanism), declared, &places(samples))
}

pub(super) fn check_balance(
    mechanism: &dyn AnyMechanism,
    declared: &Declared,
    samples: &[At<f64>],
) -> Result<Check, VerifyError> {
    let (parameters, inputs) = (mechanism.parameters(), held(mechanism));
    let (oracle, scales) = (declared.oracle(mechanism), scales(mechanism, samples));
    let mut balances = Vec::new();
    for sample in samples {
        let (coordinates, speeds) = (sample.positions, sample.speeds);
        let at = State { time: sample.time, parameters: &parameters, inputs: &inputs, coordinates, speeds };
        let freed = oracle.freed(&at, &solved(mechanism, sample)?).map_err(uninterpreted)?;
        // Those along coordinates come first; one of a body without inertia is among them.
        let scale = |i: usize, inertia: f64| scales.get(i).copied().unwrap_or(inertia.sqrt());
        let scaled = freed.into_iter().enumerate().map(|(i, balance)| (scale(i, balance.inertia), balance));
        let scaled = scaled.filter(|(scale, _)| *scale > 0.0);
        balances.extend(scaled.map(|(s, balance)| (balance.missing.abs() / s, balance.size / s, balance.name)));
    }
    let all = largest(balances.iter().map(|(_, size, _)| *size));
    let mut worst = Worst::default();
    for (missing, _, name) in balances {
        worst.enter(relative(missing, all), name);
    }
    let meaning =
        format!("largest residual of the equations of freed bodies, relative to their terms, at `{}`", worst.at);
    Ok(Check::new("reactions against Newton-Euler", worst.figure, BALANCE, meaning))
}
