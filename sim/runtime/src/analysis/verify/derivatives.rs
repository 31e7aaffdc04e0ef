//! Generated derivatives against dual numbers, which differentiate the kernels themselves.

use super::scale::scales;
use super::worst::{Worst, largest, relative};
use super::{Check, places};
use crate::model::{At, Differentiable};
use crate::motion::typed::Any;
use crate::numerics::numbers::larger;
use crate::state::trajectory::Sample;
use nalgebra::DMatrix;
use sim_kernel::{Dual, Mechanism};

/// The largest difference of a derivative, relative to its rounding. Both ways solve K dz = dr - dK z, which amplifies
/// rounding by the condition of K: 1e-8 lets it be 1e8.
const BOUND: f64 = 1e-8;
/// The part of the largest acceleration and reaction below which a derivative, by a change that counts as 1, is their rounding:
/// a few hundred times what doubles resolve, at [`BOUND`].
const LEAST: f64 = 1e-5;

/// C_q, d(q'')/dq, d(q'')/dq', d(lambda)/dq and d(lambda)/dq'.
pub fn jacobians_against_duals<M: Mechanism>(mechanism: &M, samples: &[Sample<M>]) -> Check {
    compare_with_duals(&Any(mechanism), &places(samples))
}

pub(super) fn compare_with_duals(mechanism: &dyn Differentiable, samples: &[At<f64>]) -> Check {
    let mut worst = Worst::<&str>::default();
    let constraints = compare_constraints(mechanism, samples, &mut worst);
    let found = compare_solutions(mechanism, samples, &mut worst);
    let is_made = mechanism.description().optional_kernels.contains(&"dynamics_jacobian");
    let solutions = match (is_made, found) {
        (false, _) => "no kernel of d(q'', lambda)/d(q, q') to compare",
        (true, 0) => "the kernel of d(q'', lambda)/d(q, q') refuses every state, so nothing is compared",
        (true, _) => "",
    };
    let compared = if constraints == 0 && found == 0 { None } else { Some(worst.figure) };
    let where_ = if worst.at.is_empty() { String::new() } else { format!(": {}", worst.at) };
    let meaning = match (compared, solutions) {
        (None, why) => why.to_owned(),
        (_, "") => format!("largest difference relative to matrices{where_}"),
        (_, why) => format!("largest difference relative to rows of C_q{where_}; {why}"),
    };
    Check { figure: compared, ..Check::unmade("Jacobians against dual numbers", BOUND, meaning) }
}

/// C_q, relative to the largest entry that a row has in any sample. Gives how many entries were compared.
fn compare_constraints(mechanism: &dyn Differentiable, samples: &[At<f64>], worst: &mut Worst<&str>) -> usize {
    // Rows between speeds are not derivatives.
    let between_speeds = mechanism.description().speed_constraints;
    let mut compared = 0;
    let pairs = samples.iter().map(|sample| {
        let kernel = mechanism.constraint_jacobian(sample.time, sample.positions);
        let columns: Vec<Vec<f64>> =
            (0..sample.positions.len()).map(|j| constraints_by(mechanism, sample, j)).collect();
        (kernel, columns)
    });
    let pairs: Vec<(DMatrix<f64>, Vec<Vec<f64>>)> = pairs.collect();
    let rows = mechanism.description().constraints.len();
    for i in (0..rows).filter(|i| !between_speeds.contains(i)) {
        let entries = || {
            pairs
                .iter()
                .flat_map(|(kernel, dual)| dual.iter().enumerate().map(move |(j, column)| (kernel[(i, j)], column[i])))
        };
        let size = largest(entries().flat_map(|(kernel, dual)| [kernel, dual]));
        for (kernel, dual) in entries() {
            worst.enter(relative((kernel - dual).abs(), size), "C_q");
            compared += 1;
        }
    }
    compared
}

/// d(q'', lambda)/dq and d(q'', lambda)/dq', each relative to its largest entry in any sample, in units that make all
/// coordinates, accelerations and multipliers comparable. Gives how many entries were compared.
fn compare_solutions(mechanism: &dyn Differentiable, samples: &[At<f64>], worst: &mut Worst<&str>) -> usize {
    if !mechanism.description().optional_kernels.contains(&"dynamics_jacobian") {
        return 0;
    }
    let n = mechanism.description().coordinates.len();
    let coordinates = scales(mechanism, samples);
    let names = [["d(q'')/dq", "d(lambda)/dq"], ["d(q'')/dq'", "d(lambda)/dq'"]];
    let mut found: [Vec<(&str, f64, f64)>; 2] = [vec![], vec![]];
    let mut solved = 0.0;
    for sample in samples {
        let Some(generated) = mechanism.by_state(sample.time, sample.positions, sample.speeds) else { continue };
        let jacobian = mechanism.constraint_jacobian(sample.time, sample.positions);
        // A multiplier is measured by its force.
        let forces = (0..jacobian.nrows()).map(|k| largest((0..n).map(|j| jacobian[(k, j)] / coordinates[j])));
        let rows: Vec<f64> = coordinates.iter().copied().chain(forces).collect();
        let solution = sample.accelerations.iter().chain(sample.multipliers).zip(&rows);
        solved = larger(solved, largest(solution.map(|(value, unit)| value * unit)));
        for (by_speed, generated) in generated.iter().enumerate() {
            let columns: Option<Vec<Vec<f64>>> =
                (0..n).map(|j| solution_by(mechanism, sample, j, by_speed == 1)).collect();
            let Some(columns) = columns else { continue };
            for (j, column) in columns.iter().enumerate() {
                for (i, dual) in column.iter().enumerate() {
                    let unit = rows[i] / coordinates[j];
                    let apart = (generated[(i, j)] - dual).abs() * unit;
                    found[by_speed].push((names[by_speed][usize::from(i >= n)], apart, dual.abs() * unit));
                }
            }
        }
    }
    for entries in &found {
        let size = larger(largest(entries.iter().map(|(_, _, size)| *size)), LEAST * solved);
        entries.iter().for_each(|(name, apart, _)| worst.enter(relative(*apart, size), name));
    }
    found.iter().map(Vec::len).sum()
}

/// The same numbers, with one as the variable of differentiation.
fn seeded(values: &[f64], by: Option<usize>) -> Vec<Dual> {
    let seeded = |(j, value): (usize, &f64)| match by == Some(j) {
        true => Dual::variable(*value),
        false => Dual::constant(*value),
    };
    values.iter().enumerate().map(seeded).collect()
}

fn derivatives(values: &[Dual]) -> Vec<f64> {
    values.iter().map(|value| value.derivative).collect()
}

/// The derivatives of the constraints by one coordinate.
fn constraints_by(mechanism: &dyn Differentiable, sample: &At<f64>, j: usize) -> Vec<f64> {
    let positions = seeded(sample.positions, Some(j));
    let [values, ..] = mechanism.constraints_along(At::moving(Dual::constant(sample.time), &positions, &[]), None);
    derivatives(&values)
}

/// The derivatives of accelerations and multipliers by one coordinate or speed.
fn solution_by(mechanism: &dyn Differentiable, sample: &At<f64>, j: usize, by_speed: bool) -> Option<Vec<f64>> {
    let positions = seeded(sample.positions, (!by_speed).then_some(j));
    let speeds = seeded(sample.speeds, by_speed.then_some(j));
    let at = At::moving(Dual::constant(sample.time), &positions, &speeds);
    mechanism.solution_along(at, None).map(|solution| derivatives(&solution))
}
