//! A start on the constraints, from given values and guesses.

use crate::model::{AnyMechanism, Linear};
use crate::motion::lengths::{measure, without_units};
use crate::motion::typed::Any;
use crate::numerics::arrays::array;
use crate::start::dyads::{Branches, Closed, close_loops, nearest};
use crate::state::failure::{Failure, What, largest};
use crate::state::trajectory::State;
use nalgebra::{DMatrix, DVector};
use sim_kernel::{Description, Mechanism};

/// The given start of a motion; all in SI units.
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
#[inline(never)]
pub fn declared_start<M: Mechanism>(mechanism: &M) -> Start<M> {
    let initial = mechanism.initial();
    let [position_given, speed_given] = declared_given(mechanism.description());
    Start { positions: initial.positions, speeds: initial.speeds, position_given, speed_given }
}

/// Which coordinates and which speeds a declaration gives at the start.
fn declared_given(description: &Description) -> [Vec<bool>; 2] {
    let coordinates = description.coordinates;
    let positions = coordinates.iter().map(|c| c.start == sim_kernel::Start::Given).collect();
    [positions, coordinates.iter().map(|c| c.speed_given).collect()]
}

/// The number of Gauss-Newton steps after which assembly is given up.
const MOST_STEPS: usize = 200;

/// The state at time 0 nearest to a start that satisfies the constraints and all given values.
///
/// Loops that close in closed form are closed that way, on the branch nearest to the guesses: see [`branches`]. Otherwise,
/// and for the last bits, positions by Gauss-Newton with least-norm steps in the free coordinates, halved until the
/// residual falls; speeds by least squares of least norm, so that an undriven freedom starts at rest.
///
/// # Errors
/// [`What::NotAssembled`] with the closest configuration, [`What::SpeedsContradict`].
#[inline(never)]
pub fn assemble<M: Mechanism>(mechanism: &M, start: &Start<M>) -> Result<State<M>, Failure> {
    let n = mechanism.n();
    let (mechanism, given): (&dyn AnyMechanism, Given) = (&Any(mechanism), start.given());
    let positions = assemble_positions(mechanism, &given)?;
    let speeds = assemble_speeds(mechanism, &given, &positions)?;
    Ok(State { time: 0.0, positions: array(n, &positions), speeds: array(n, &speeds), work: 0.0 })
}

/// All configurations with the given coordinates of the start, as far as loops close in closed form: elbow up and elbow
/// down. Coordinates of other loops are found by Gauss-Newton from their guesses; if that fails there is no
/// configuration. Angles are within half a turn of their guesses.
#[inline(never)]
pub fn branches<M: Mechanism>(mechanism: &M, start: &Start<M>) -> Branches<M> {
    let Closed { loops, open, positions } = branches_of(&Any(mechanism), &start.given());
    Branches { loops, open, positions: positions.iter().map(|q| array(mechanism.n(), q)).collect() }
}

/// A start of a mechanism of any type.
#[derive(Clone, Copy)]
struct Given<'a> {
    positions: &'a [f64],
    speeds: &'a [f64],
    position_given: &'a [bool],
    speed_given: &'a [bool],
}

impl<M: Mechanism> Start<M> {
    fn given(&self) -> Given<'_> {
        Given {
            positions: self.positions.as_ref(),
            speeds: self.speeds.as_ref(),
            position_given: &self.position_given,
            speed_given: &self.speed_given,
        }
    }
}

fn branches_of(mechanism: &dyn AnyMechanism, start: &Given) -> Closed {
    let mut found = close_loops(mechanism, start.positions, start.position_given);
    if !found.open.is_empty() {
        let names = mechanism.description().coordinates.iter().map(|c| c.position.name);
        let held: Vec<bool> = names.map(|name| !found.open.contains(&name)).collect();
        let held = Given { position_given: &held, ..*start };
        let corrected = found.positions.iter().filter_map(|q| correct_positions(mechanism, &held, q.clone()).ok());
        found.positions = corrected.collect();
        found.sort(start.positions);
    }
    found
}

fn assemble_positions(mechanism: &dyn AnyMechanism, start: &Given) -> Result<Vec<f64>, Failure> {
    let closed = nearest(mechanism, start.positions, start.position_given);
    correct_positions(mechanism, start, closed.unwrap_or_else(|| start.positions.to_vec()))
}

fn correct_positions(mechanism: &dyn AnyMechanism, start: &Given, mut q: Vec<f64>) -> Result<Vec<f64>, Failure> {
    let mut linear = mechanism.constraint_linearization(0.0, &q);
    let measured = measure(mechanism, 0.0, &q);
    for steps in 0..MOST_STEPS {
        if mechanism.is_met(0.0, &q) {
            let settled = if steps == 0 { q } else { settle(mechanism, start, (q, linear), &measured) };
            return Ok(polish(mechanism, start, settled));
        }
        let by_positions = mechanism.between_positions(linear.jacobian);
        let (by_positions, open) = of_one_size((by_positions, linear.values.clone()), &measured.1);
        let Some(step) = least_norm_solution(by_positions, start.position_given, &open) else { break };
        let current = linear.values.norm();
        let mut scale = 1.0;
        let accepted = loop {
            let trial = moved(&q, &step, scale);
            let trial_linear = mechanism.constraint_linearization(0.0, &trial);
            if trial_linear.values.norm() < current {
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
    let linear = mechanism.constraint_linearization(0.0, &q);
    let settled = settle(mechanism, start, (q.clone(), linear), &measured);
    if mechanism.is_met(0.0, &settled) { Ok(settled) } else { Err(not_assembled(mechanism, &q)) }
}

fn moved(q: &[f64], step: &DVector<f64>, scale: f64) -> Vec<f64> {
    q.iter().zip(step).map(|(q, step)| q - scale * step).collect()
}

/// Steps that are shorter than this part of the scales of coordinates are left.
const SETTLED: f64 = 1e-9;

/// Goes on from a configuration whose residual is small and that is still far from the solution: the solution is a double one, as
/// that of a quaternion of which q0 = 1 is given. Steps there go half the way, and those of twice the length all of it.
fn settle(
    mechanism: &dyn AnyMechanism,
    start: &Given,
    (mut q, mut linear): (Vec<f64>, Linear),
    scales @ (sizes, terms): &(Vec<f64>, Vec<f64>),
) -> Vec<f64> {
    let open = |linear: &Linear| linear.values.zip_map(&DVector::from_column_slice(terms), |value, term| value / term);
    // In the scales of coordinates and constraints, so that rounding is small beside any of them.
    let step_from = |linear: &Linear| {
        let by_positions = without_units(mechanism.between_positions(linear.jacobian.clone()), scales);
        let step = least_norm_solution(by_positions, start.position_given, &open(linear))?;
        Some(step.zip_map(&DVector::from_column_slice(sizes), |step, size| step * size))
    };
    let at = |q: Vec<f64>| (mechanism.constraint_linearization(0.0, &q), q);
    for _ in 0..MOST_STEPS {
        let Some(step) = step_from(&linear) else { break };
        if step.iter().zip(sizes).all(|(step, size)| step.abs() <= SETTLED * size) {
            break;
        }
        let [once, twice] = [1.0, 2.0].map(|scale| {
            let (bent, trial) = at(moved(&q, &step, scale));
            // By what the curvature of the other constraints opens them.
            let again = step_from(&bent).map(|again| moved(&trial, &again, 1.0));
            at(again.unwrap_or(trial))
        });
        let best = if open(&twice.0).norm() < open(&once.0).norm() { twice } else { once };
        if !(open(&best.0).norm() < open(&linear).norm()) {
            break;
        }
        (linear, q) = best;
    }
    q
}

/// One projection as in every step, if it cannot move given values.
fn polish(mechanism: &dyn AnyMechanism, start: &Given, q: Vec<f64>) -> Vec<f64> {
    let mut polished = q.clone();
    let nothing_given = start.position_given.iter().all(|given| !given);
    if nothing_given && mechanism.project_positions(0.0, &mut polished).is_ok() { polished } else { q }
}

fn not_assembled(mechanism: &dyn AnyMechanism, q: &[f64]) -> Failure {
    let values = mechanism.constraints(0.0, q);
    let Some((row, residual)) = largest(values.iter()) else {
        return mechanism.failure(What::NotFinite { quantity: "the start".into() }, 0.0, q);
    };
    let name = |row: usize| mechanism.constraint_name(row);
    if !residual.is_finite() {
        let quantity = format!("constraint `{}` at the guesses", name(row));
        return mechanism.failure(What::NotFinite { quantity }, 0.0, q);
    }
    let others = values.iter().enumerate().filter(|(i, value)| *i != row && value.abs() > 1e-12);
    let others: Vec<String> = others.map(|(i, value)| format!("`{}` by {value:.3e}", name(i))).collect();
    let others = if others.is_empty() { String::new() } else { format!(", {}", others.join(", ")) };
    mechanism.failure(What::NotAssembled { constraint: name(row), residual, others }, 0.0, q)
}

/// How often speeds that leave a constraint open are corrected.
const MOST_REFINEMENTS: usize = 4;

fn assemble_speeds(mechanism: &dyn AnyMechanism, start: &Given, q: &[f64]) -> Result<Vec<f64>, Failure> {
    let Linear { jacobian, time_derivative, .. } = mechanism.constraint_linearization(0.0, q);
    let given = start.speeds.iter().zip(start.speed_given);
    let mut speeds = DVector::from_iterator(q.len(), given.map(|(speed, given)| if *given { *speed } else { 0.0 }));
    let mut open = &jacobian * &speeds + &time_derivative;
    let (mut contradicted, (sizes, terms)) = (0, measure(mechanism, 0.0, q));
    // Once is enough, unless lengths are far from 1 m and the decomposition of J loses digits.
    for _ in 0..MOST_REFINEMENTS {
        let (rows, left) = of_one_size((without_rounding(jacobian.clone(), &terms, &sizes), open), &terms);
        let Some(step) = least_norm_solution(rows, start.speed_given, &left) else {
            let quantity = "a derivative of the constraints".into();
            return Err(mechanism.failure(What::NotFinite { quantity }, 0.0, q));
        };
        speeds -= step;
        open = &jacobian * &speeds + &time_derivative;
        let moved = |i: usize| jacobian.row(i).iter().zip(&speeds).map(|(c, v)| (c * v).abs()).sum::<f64>();
        // Those of J are rounding where they cancel, as the way of a point about an axis through it.
        let of_terms = |i: usize| terms[i] * speeds.iter().zip(&sizes).map(|(v, size)| (v / size).abs()).sum::<f64>();
        // Least squares leave a residual of a few roundings of the terms; a contradiction leaves a fraction of them.
        let most = |i: usize| 1e-9 * moved(i) + 1e-13 * of_terms(i) + 1e-12;
        match (0..open.len()).find(|i| !(open[*i].abs() <= most(*i))) {
            None => return Ok(speeds.as_slice().to_vec()),
            Some(row) => contradicted = row,
        }
    }
    let (constraint, residual) = (mechanism.constraint_name(contradicted), open[contradicted]);
    Err(mechanism.failure(What::SpeedsContradict { constraint, residual }, 0.0, q))
}

/// The shortest x with J x nearest to the residual, x_j = 0 where j is given.
pub(super) fn least_norm_solution(
    mut jacobian: DMatrix<f64>,
    given: &[bool],
    residual: &DVector<f64>,
) -> Option<DVector<f64>> {
    if jacobian.nrows() == 0 {
        return Some(DVector::zeros(given.len()));
    }
    (0..given.len()).filter(|j| given[*j]).for_each(|j| jacobian.column_mut(j).fill(0.0));
    if jacobian.iter().chain(residual.iter()).any(|value| !value.is_finite()) {
        return None;
    }
    let svd = jacobian.svd(true, true);
    let largest = svd.singular_values.iter().fold(0.0, |a: f64, b| a.max(*b));
    let mut solution = svd.solve(residual, 1e-12 * largest.max(f64::MIN_POSITIVE)).ok()?;
    // Rounding must not move given values.
    (0..given.len()).filter(|j| given[*j]).for_each(|j| solution[j] = 0.0);
    Some(solution)
}

/// C_q without what is but rounding of the terms of its rows: at a dead point cos(pi/2) is 6e-17.
fn without_rounding(mut jacobian: DMatrix<f64>, terms: &[f64], sizes: &[f64]) -> DMatrix<f64> {
    for (j, size) in sizes.iter().enumerate() {
        for (entry, terms) in jacobian.column_mut(j).iter_mut().zip(terms) {
            if (*entry * size).abs() <= ROUNDED * terms {
                *entry = 0.0;
            }
        }
    }
    jacobian
}

/// The rounding of a derivative relative to the terms of its constraint.
const ROUNDED: f64 = 4.0 * f64::EPSILON;

/// Rows whose terms are this much smaller than those of others are brought to one size with them.
const UNEQUAL: f64 = 1e-6;

/// C_q and the residual with rows of one size, where the terms of constraints are of very different size: singular values of
/// small rows would be taken for zeros.
fn of_one_size(
    (mut jacobian, mut residual): (DMatrix<f64>, DVector<f64>),
    terms: &[f64],
) -> (DMatrix<f64>, DVector<f64>) {
    let [least, most] = [f64::min, f64::max].map(|of| terms.iter().copied().reduce(of).unwrap_or(1.0));
    if least < UNEQUAL * most {
        for (i, size) in terms.iter().enumerate() {
            jacobian.row_mut(i).unscale_mut(*size);
            residual[i] /= size;
        }
    }
    (jacobian, residual)
}
