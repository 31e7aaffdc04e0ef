//! Generated derivatives against dual numbers, which differentiate the kernels themselves.

use super::Check;
use crate::trajectory::Sample;
use sim_kernel::{Array, Dual, Mechanism};
use std::collections::BTreeMap;

/// How much more than its own rounding a derivative may differ; it is relative to the largest entry of its row.
const BOUND: f64 = 1e-8;
/// A row this small beside all rows of all samples, as that of an acceleration that time prescribes, or of a follower where its
/// cam dwells, may be rounding.
const SMALL: f64 = 1e-6;

/// C_q, d(q'')/dq, d(q'')/dq', d(lambda)/dq and d(lambda)/dq'.
pub fn jacobians_against_duals<M: Mechanism>(mechanism: &M, samples: &[Sample<M>]) -> Check {
    let mut compared: Vec<Difference> = Vec::new();
    let mut compare = |what: &'static str, generated: f64, dual: f64, size: f64| {
        compared.push(Difference { what, apart: (generated - dual).abs(), size });
    };
    for sample in samples {
        let (t, q, qd) = (sample.state.time, &sample.state.positions, &sample.state.speeds);
        let jacobian = mechanism.constraint_jacobian(t, q);
        let generated = mechanism.dynamics_jacobian(t, q, qd);
        let (n, m) = (M::Q::LEN, M::L::LEN);
        let columns: Vec<[Column; 2]> =
            (0..n).map(|j| [false, true].map(|by_speed| column(mechanism, sample, j, by_speed))).collect();
        let sizes = row_sizes(&|i, j| columns[j][0].constraints[i], m, n);
        // Rows between speeds are no derivatives of anything.
        for i in (0..m).filter(|i| !M::DESCRIPTION.speed_constraints.contains(i)) {
            (0..n).for_each(|j| compare("C_q", jacobian[i][j], columns[j][0].constraints[i], sizes[i]));
        }
        if generated.refused {
            continue;
        }
        let sizes = [0, 1].map(|by| row_sizes(&|i, j| columns[j][by].accelerations[i], n, n));
        for i in 0..n {
            for j in 0..n {
                let [by_q, by_qd] = &columns[j];
                compare("d(q'')/dq", generated.accelerations_by_positions[i][j], by_q.accelerations[i], sizes[0][i]);
                compare("d(q'')/dq'", generated.accelerations_by_speeds[i][j], by_qd.accelerations[i], sizes[1][i]);
            }
        }
        let sizes = [0, 1].map(|by| row_sizes(&|i, j| columns[j][by].multipliers[i], m, n));
        for i in 0..m {
            for j in 0..n {
                let [by_q, by_qd] = &columns[j];
                compare("d(lambda)/dq", generated.multipliers_by_positions[i][j], by_q.multipliers[i], sizes[0][i]);
                compare("d(lambda)/dq'", generated.multipliers_by_speeds[i][j], by_qd.multipliers[i], sizes[1][i]);
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

/// The derivatives of everything by one coordinate or speed.
struct Column {
    constraints: Vec<f64>,
    accelerations: Vec<f64>,
    multipliers: Vec<f64>,
}

fn column<M: Mechanism>(mechanism: &M, sample: &Sample<M>, j: usize, by_speed: bool) -> Column {
    type Numbers<M> = <M as Mechanism>::On<Dual>;
    let constant = |x: f64| Dual::constant(x);
    let seeded = |x: f64, is_seed: bool| if is_seed { Dual::variable(x) } else { constant(x) };
    let dual = mechanism.on(constant);
    let state = &sample.state;
    let q = <Numbers<M> as Mechanism<Dual>>::Q::from_fn(|i| seeded(state.positions[i], !by_speed && i == j));
    let qd = <Numbers<M> as Mechanism<Dual>>::Q::from_fn(|i| seeded(state.speeds[i], by_speed && i == j));
    let time = constant(state.time);
    let solved = dual.dynamics(time, &q, &qd);
    let derivatives = |values: &[Dual]| values.iter().map(|value| value.derivative).collect();
    Column {
        constraints: derivatives(dual.constraints(time, &q).as_ref()),
        accelerations: derivatives(solved.accelerations.as_ref()),
        multipliers: derivatives(solved.multipliers.as_ref()),
    }
}
