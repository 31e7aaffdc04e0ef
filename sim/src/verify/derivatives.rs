//! Generated derivatives against dual numbers, which differentiate the kernels themselves.

use super::Check;
use super::formulations::places;
use crate::any::{Any, AnyMechanism, At};
use crate::trajectory::Sample;
use sim_kernel::{Dual, Mechanism};
use std::collections::BTreeMap;

/// How much more than its own rounding a derivative may differ; it is relative to the largest entry of its row.
const BOUND: f64 = 1e-8;
/// A row this small beside all rows of all samples, as that of an acceleration that time prescribes, or of a follower where its
/// cam dwells, may be rounding.
const SMALL: f64 = 1e-6;

/// C_q, d(q'')/dq, d(q'')/dq', d(lambda)/dq and d(lambda)/dq'.
pub fn jacobians_against_duals<M: Mechanism>(mechanism: &M, samples: &[Sample<M>]) -> Check {
    compare_with_duals(&Any(mechanism), &places(samples))
}

pub(super) fn compare_with_duals(mechanism: &dyn AnyMechanism, samples: &[At<f64>]) -> Check {
    let mut compared: Vec<Difference> = Vec::new();
    let mut compare = |what: &'static str, generated: f64, dual: f64, size: f64| {
        compared.push(Difference { what, apart: (generated - dual).abs(), size });
    };
    for sample in samples {
        let (t, q, qd) = (sample.time, sample.positions, sample.speeds);
        let (n, m) = (q.len(), sample.multipliers.len());
        let jacobian = mechanism.constraint_jacobian(t, q);
        let columns: Vec<Vec<f64>> = (0..n).map(|j| constraints_by(mechanism, sample, j)).collect();
        let sizes = row_sizes(&|i, j| columns[j][i], m, n);
        // Rows between speeds are no derivatives of anything.
        for i in (0..m).filter(|i| !mechanism.description().speed_constraints.contains(i)) {
            (0..n).for_each(|j| compare("C_q", jacobian[(i, j)], columns[j][i], sizes[i]));
        }
        let Some(generated) = mechanism.by_state(t, q, qd) else { continue };
        let names = [["d(q'')/dq", "d(lambda)/dq"], ["d(q'')/dq'", "d(lambda)/dq'"]];
        for ((generated, names), by_speed) in generated.iter().zip(names).zip([false, true]) {
            let columns: Option<Vec<Vec<f64>>> = (0..n).map(|j| solution_by(mechanism, sample, j, by_speed)).collect();
            let Some(columns) = columns else { continue };
            let sizes = row_sizes(&|i, j| columns[j][i], n + m, n);
            for i in 0..n + m {
                let name = names[usize::from(i >= n)];
                (0..n).for_each(|j| compare(name, generated[(i, j)], columns[j][i], sizes[i]));
            }
        }
    }
    let worst = worst(&compared);
    let meaning = match worst.1 {
        "" => "largest difference relative to its row".into(),
        what => format!("largest difference relative to its row: {what}"),
    };
    Check { name: "Jacobians against dual numbers", figure: worst.0, bound: BOUND, meaning }
}

/// The difference of an entry of some matrix, and the size of its row.
struct Difference {
    what: &'static str,
    apart: f64,
    size: f64,
}

/// The largest difference relative to its row, and in which matrix it is.
fn worst(compared: &[Difference]) -> (f64, &'static str) {
    // Accelerations and multipliers are one solution: where one of both is zero it is rounding of the other.
    let by = |what: &'static str| what.rsplit('/').next();
    let mut largest: BTreeMap<Option<&str>, f64> = BTreeMap::new();
    for Difference { what, size, .. } in compared {
        let all = largest.entry(by(what)).or_default();
        *all = all.max(*size);
    }
    let mut worst = (0.0, "");
    for Difference { what, apart, size } in compared {
        let size = largest.get(&by(what)).map_or(*size, |all| size.max(SMALL * all));
        let relative = apart / size;
        if !(relative <= worst.0) && size > 0.0 {
            worst = (relative, what);
        }
    }
    worst
}

/// The largest entry of each row.
fn row_sizes(entry: &dyn Fn(usize, usize) -> f64, rows: usize, n: usize) -> Vec<f64> {
    (0..rows).map(|i| (0..n).fold(0.0f64, |size, j| entry(i, j).abs().max(size))).collect()
}

/// The same numbers, of which one is what derivatives are taken by.
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
fn constraints_by(mechanism: &dyn AnyMechanism, sample: &At<f64>, j: usize) -> Vec<f64> {
    let positions = seeded(sample.positions, Some(j));
    let [values, ..] = mechanism.constraints_along(At::moving(Dual::constant(sample.time), &positions, &[]), None);
    derivatives(&values)
}

/// The derivatives of accelerations and multipliers by one coordinate or speed.
fn solution_by(mechanism: &dyn AnyMechanism, sample: &At<f64>, j: usize, by_speed: bool) -> Option<Vec<f64>> {
    let positions = seeded(sample.positions, (!by_speed).then_some(j));
    let speeds = seeded(sample.speeds, by_speed.then_some(j));
    let at = At::moving(Dual::constant(sample.time), &positions, &speeds);
    mechanism.solution_along(at, None).map(|solution| derivatives(&solution))
}
