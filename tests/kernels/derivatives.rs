//! The derivatives of the motion, derived symbolically through the solution, against dual numbers carried through
//! `dynamics`: the two share the factorisation and nothing of the differentiation. Where a declaration has no kernel made, the
//! trait has dual numbers too, and there is nothing to compare.

use crate::all::all_mechanisms;
use nalgebra::DMatrix;
use sim::{Array, Compiled, Dual, FixedArray, Mechanism};
use tests::Random;

const STATES: usize = 100;

type OnDual<M> = <M as Mechanism>::On<Dual>;
type Q<M> = <OnDual<M> as Mechanism<Dual>>::Q;
/// Accelerations, then multipliers.
type Solution = Vec<Dual>;

#[test]
fn kernels_of_derivatives_are_those_of_dual_numbers() {
    macro_rules! check_all {
        ($($model:ty),*) => { $(check::<$model>();)* };
    }
    all_mechanisms!(check_all);
}

fn check<M: Compiled>() {
    let name = M::DESCRIPTION.name;
    let is_made = |kernel: &str| M::DESCRIPTION.optional_kernels.contains(&kernel);
    let [by_state, by_parameters] = [is_made("dynamics_jacobian"), is_made("dynamics_sensitivity")];
    if !by_state && !by_parameters {
        println!("{name:<20} no kernel to compare");
        return;
    }
    let mut random = Random(5);
    let (mut worst, mut sharp) = (0.0f64, 0);
    for _ in 0..STATES {
        let defaults = M::defaults().parameters();
        let mechanism =
            M::defaults().with_parameters(M::Parameters::from_fn(|i| defaults[i] * random.between(0.8, 1.2)));
        let mechanism = mechanism.with_activities(M::Activities::from_fn(|_| random.between(0.0, 2.0).floor()));
        let t = random.between(0.0, 2.0);
        let [q, qd] = [1.5, 3.0].map(|size| M::Q::from_fn(|_| random.between(-size, size)));
        let jacobian = mechanism.dynamics_jacobian(t, &q, &qd);
        let sensitivity = mechanism.dynamics_sensitivity(t, &q, &qd);
        assert_eq!(jacobian.refused, mechanism.dynamics(t, &q, &qd).refused);
        if jacobian.refused {
            continue;
        }
        let condition = condition(&mechanism, t, &q);
        // The rounding of K z = r, and of K dz = dr - dK z, each amplified by the condition of K.
        let tolerance = f64::EPSILON * condition * condition;
        sharp += usize::from(tolerance < 1e-6);
        let mut compare = |what: &str, columns: Vec<Solution>, entry: &dyn Fn(usize, usize) -> f64| {
            for (j, column) in columns.iter().enumerate() {
                let size = column.iter().fold(0.0f64, |size, z| size.max(z.derivative.abs()).max(z.value.abs()));
                for (i, z) in column.iter().enumerate() {
                    let difference = (entry(i, j) - z.derivative).abs() / (tolerance * size.max(1.0));
                    assert!(difference < 100.0, "{name}, {what} {i} {j}: {} {}", entry(i, j), z.derivative);
                    worst = worst.max(difference);
                }
            }
        };
        let n = M::Q::LEN;
        let n_compared = if by_state { n } else { 0 };
        let positions = (0..n_compared).map(|j| along::<M>(&mechanism, t, &q, &qd, Direction::Position(j))).collect();
        compare("by position", positions, &|i, j| match i < n {
            true => jacobian.accelerations_by_positions[i][j],
            false => jacobian.multipliers_by_positions[i - n][j],
        });
        let speeds = (0..n_compared).map(|j| along::<M>(&mechanism, t, &q, &qd, Direction::Speed(j))).collect();
        compare("by speed", speeds, &|i, j| match i < n {
            true => jacobian.accelerations_by_speeds[i][j],
            false => jacobian.multipliers_by_speeds[i - n][j],
        });
        let p = if by_parameters { M::Parameters::LEN } else { 0 };
        let parameters = (0..p).map(|j| along::<M>(&mechanism, t, &q, &qd, Direction::Parameter(j))).collect();
        compare("by parameter", parameters, &|i, j| match i < n {
            true => sensitivity.accelerations[i][j],
            false => sensitivity.multipliers[i - n][j],
        });
    }
    println!("{name:<20} {worst:.2} eps cond(K)^2, below 1e-6 at {sharp} of {STATES} states");
    assert!(sharp > STATES / 3, "{name}: {sharp}");
}

#[derive(Clone, Copy, PartialEq)]
enum Direction {
    Position(usize),
    Speed(usize),
    Parameter(usize),
}

fn along<M: Compiled>(mechanism: &M, t: f64, q: &M::Q, qd: &M::Q, direction: Direction) -> Solution {
    let dual = |value: f64, at: Direction| Dual { value, derivative: f64::from(at == direction) };
    let values = mechanism.parameters();
    let parameters = <OnDual<M> as Mechanism<Dual>>::Parameters::with_len(values.len(), |i| {
        dual(values[i], Direction::Parameter(i))
    });
    let q = Q::<M>::with_len(q.len(), |i| dual(q[i], Direction::Position(i)));
    let qd = Q::<M>::with_len(qd.len(), |i| dual(qd[i], Direction::Speed(i)));
    let solved = mechanism.on(Dual::constant).with_parameters(parameters).dynamics(Dual::constant(t), &q, &qd);
    solved.accelerations.iter().chain(solved.multipliers.iter()).copied().collect()
}

/// Of the equations of motion, units apart: rows and columns scaled to largest entries of 1.
fn condition<M: Compiled>(mechanism: &M, t: f64, q: &M::Q) -> f64 {
    let (n, m) = (M::Q::LEN, M::L::LEN);
    let (mass, jacobian) = (mechanism.mass_matrix(t, q), mechanism.constraint_jacobian(t, q));
    let mut matrix = DMatrix::from_fn(n + m, n + m, |i, j| match (i < n, j < n) {
        (true, true) => mass[i][j],
        (true, false) => jacobian[j - n][i],
        (false, true) => jacobian[i - n][j],
        (false, false) => 0.0,
    });
    (0..m).filter(|i| !sim::is_active(mechanism, *i)).for_each(|i| matrix[(n + i, n + i)] = -1.0);
    for i in 0..n + m {
        let scale = matrix.row(i).amax().sqrt().recip();
        matrix.row_mut(i).scale_mut(scale);
        matrix.column_mut(i).scale_mut(scale);
    }
    let singular = matrix.singular_values();
    singular.max() / singular.min()
}
