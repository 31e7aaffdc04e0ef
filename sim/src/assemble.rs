//! A start on the constraints, from given values and guesses.

use crate::dyads::{Branches, close_loops, nearest};
use crate::failure::{Failure, What, constraint_name, largest};
use crate::level::between_positions;
use crate::project::{is_met, project_positions, rates};
use crate::trajectory::State;
use nalgebra::{DMatrix, DVector};
use sim_kernel::{Array, Mechanism};

/// What is known of the start of a motion; all in SI units.
#[derive(Clone, Debug)]
pub struct Start<M: Mechanism> {
    /// Values or guesses of the coordinates.
    pub positions: M::Q,
    /// Speeds; those not given are found.
    pub speeds: M::Q,
    /// Which coordinates are given; the others are found.
    pub position_given: Vec<bool>,
    /// Which speeds are given.
    pub speed_given: Vec<bool>,
}

/// The declared start of a mechanism.
pub fn declared_start<M: Mechanism>(mechanism: &M) -> Start<M> {
    let initial = mechanism.initial();
    let coordinates = M::DESCRIPTION.coordinates;
    Start {
        positions: initial.positions,
        speeds: initial.speeds,
        position_given: coordinates.iter().map(|c| c.start == sim_kernel::Start::Given).collect(),
        speed_given: coordinates.iter().map(|c| c.speed_given).collect(),
    }
}

/// Steps of Gauss-Newton, after which assembly is given up.
const MOST_STEPS: usize = 200;

/// The state at time 0 nearest to a start that satisfies the constraints and all that is given.
///
/// Loops that close in closed form are closed so, on the branch nearest to the guesses: see [`branches`]. Otherwise, and
/// for the last bits, positions by Gauss-Newton with least-norm steps in the free coordinates, halved until the residual falls; speeds
/// by least squares of least norm, so that a freedom that nothing drives starts at rest.
///
/// # Errors
/// [`What::NotAssembled`] with the closest configuration, [`What::SpeedsContradict`].
pub fn assemble<M: Mechanism>(mechanism: &M, start: &Start<M>) -> Result<State<M>, Failure> {
    let positions = assemble_positions(mechanism, start)?;
    let speeds = assemble_speeds(mechanism, start, &positions)?;
    Ok(State { time: 0.0, positions, speeds, work: 0.0 })
}

fn assemble_positions<M: Mechanism>(mechanism: &M, start: &Start<M>) -> Result<M::Q, Failure> {
    correct_positions(mechanism, start, nearest(mechanism, start).unwrap_or(start.positions))
}

/// All configurations that have the coordinates that the start gives, as far as loops close in closed form: elbow up and
/// elbow down. Coordinates of other loops are found by Gauss-Newton from their guesses; where that fails there is no
/// configuration. Angles are within half a turn of their guesses.
pub fn branches<M: Mechanism>(mechanism: &M, start: &Start<M>) -> Branches<M> {
    let mut found = close_loops(mechanism, start);
    if !found.open.is_empty() {
        let is_open = |j: usize| found.open.contains(&M::DESCRIPTION.coordinates[j].position.name);
        let held = Start { position_given: (0..M::Q::LEN).map(|j| !is_open(j)).collect(), ..start.clone() };
        let corrected = found.positions.iter().filter_map(|q| correct_positions(mechanism, &held, *q).ok());
        found.positions = corrected.collect();
        found.sort(start);
    }
    found
}

fn correct_positions<M: Mechanism>(mechanism: &M, start: &Start<M>, mut q: M::Q) -> Result<M::Q, Failure> {
    let mut linear = mechanism.constraint_linearization(0.0, &q);
    let norm = |values: &M::L| values.iter().map(|value| value * value).sum::<f64>().sqrt();
    for _ in 0..MOST_STEPS {
        if is_met(mechanism, 0.0, &q, &linear) {
            return polish(mechanism, start, q);
        }
        let residual = DVector::from_iterator(M::L::LEN, linear.values.iter().copied());
        let by_positions = between_positions::<M>(&linear.jacobian);
        let Some(step) = least_norm_solution::<M>(&by_positions, &start.position_given, residual) else { break };
        let current = norm(&linear.values);
        let mut scale = 1.0;
        let accepted = loop {
            let trial = M::Q::from_fn(|j| q[j] - scale * step[j]);
            let trial_linear = mechanism.constraint_linearization(0.0, &trial);
            if norm(&trial_linear.values) < current {
                break Some((trial, trial_linear));
            }
            scale /= 2.0;
            if scale < 1e-10 {
                break None;
            }
        };
        let Some(better) = accepted else { break };
        (q, linear) = better;
    }
    Err(not_assembled(mechanism, &q))
}

/// One projection as in every step, if nothing is given that it could move.
fn polish<M: Mechanism>(mechanism: &M, start: &Start<M>, q: M::Q) -> Result<M::Q, Failure> {
    let mut polished = q;
    let nothing_given = start.position_given.iter().all(|given| !given);
    match nothing_given && project_positions(mechanism, 0.0, &mut polished).is_ok() {
        true => Ok(polished),
        false => Ok(q),
    }
}

fn not_assembled<M: Mechanism>(mechanism: &M, q: &M::Q) -> Failure {
    let values = mechanism.constraints(0.0, q);
    let Some((row, residual)) = largest(values.iter()) else {
        return Failure::at::<M>(What::NotFinite { quantity: "the start".into() }, 0.0, q);
    };
    if !residual.is_finite() {
        let quantity = format!("constraint `{}` at the guesses", constraint_name::<M>(row));
        return Failure::at::<M>(What::NotFinite { quantity }, 0.0, q);
    }
    let others: Vec<String> = values
        .iter()
        .enumerate()
        .filter(|(i, value)| *i != row && value.abs() > 1e-12)
        .map(|(i, value)| format!("`{}` by {value:.3e}", constraint_name::<M>(i)))
        .collect();
    let others = if others.is_empty() { String::new() } else { format!(", {}", others.join(", ")) };
    Failure::at::<M>(What::NotAssembled { constraint: constraint_name::<M>(row), residual, others }, 0.0, q)
}

fn assemble_speeds<M: Mechanism>(mechanism: &M, start: &Start<M>, q: &M::Q) -> Result<M::Q, Failure> {
    let linear = mechanism.constraint_linearization(0.0, q);
    let mut speeds = M::Q::from_fn(|j| if start.speed_given[j] { start.speeds[j] } else { 0.0 });
    let residual = DVector::from_iterator(M::L::LEN, rates::<M>(&linear, &speeds).iter().copied());
    let Some(step) = least_norm_solution::<M>(&linear.jacobian, &start.speed_given, residual) else {
        let quantity = "a derivative of the constraints".into();
        return Err(Failure::at::<M>(What::NotFinite { quantity }, 0.0, q));
    };
    speeds = M::Q::from_fn(|j| speeds[j] - step[j]);
    let open_rates = rates::<M>(&linear, &speeds);
    let scale = |i: usize| linear.jacobian[i].iter().zip(speeds.iter()).map(|(c, v)| (c * v).abs()).sum::<f64>();
    // Least squares leave a few roundings of the terms; a contradiction leaves a part of them.
    let open = (0..M::L::LEN).find(|i| !(open_rates[*i].abs() <= 1e-9 * scale(*i) + 1e-12));
    match open {
        None => Ok(speeds),
        Some(row) => {
            let what = What::SpeedsContradict { constraint: constraint_name::<M>(row), residual: open_rates[row] };
            Err(Failure::at::<M>(what, 0.0, q))
        }
    }
}

/// The shortest x with J x nearest to the residual, x_j = 0 where j is given.
fn least_norm_solution<M: Mechanism>(jacobian: &M::LQ, given: &[bool], residual: DVector<f64>) -> Option<M::Q> {
    let (m, n) = (M::L::LEN, M::Q::LEN);
    if m == 0 {
        return Some(M::Q::filled(0.0));
    }
    let free = DMatrix::from_fn(m, n, |i, j| if given[j] { 0.0 } else { jacobian[i][j] });
    if free.iter().chain(residual.iter()).any(|value| !value.is_finite()) {
        return None;
    }
    let svd = free.svd(true, true);
    let largest = svd.singular_values.iter().fold(0.0, |a: f64, b| a.max(*b));
    let solution = svd.solve(&residual, 1e-12 * largest.max(f64::MIN_POSITIVE)).ok()?;
    // Rounding must not move what is given.
    Some(M::Q::from_fn(|j| if given[j] { 0.0 } else { solution[j] }))
}
