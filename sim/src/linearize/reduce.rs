//! From changes of the independent coordinates and speeds to those of all.

use super::Change;
use crate::mobility::mobility;
use crate::partition::Partition;
use crate::trajectory::State;
use nalgebra::{Complex, DMatrix, DVector};
use sim_kernel::{Array, ConstraintLinearization, Dual, Mechanism, Start};

/// The given coordinates are taken as independent ones if the columns of the others are this far from singular.
const REGULAR: f64 = 1e-3;

/// dq = N dq_i, dq' = N dq_i' + S dq_i.
pub(super) struct Reduction {
    pub(super) independent: Vec<usize>,
    /// N, n x f.
    positions: DMatrix<f64>,
    /// S, n x f.
    speeds: DMatrix<f64>,
}

impl Reduction {
    pub(super) fn at<M: Mechanism>(mechanism: &M, state: &State<M>) -> Reduction {
        let (n, m) = (M::Q::LEN, M::L::LEN);
        let jacobian = mechanism.constraint_jacobian(state.time, &state.positions);
        let jacobian = DMatrix::from_fn(m, n, |i, j| jacobian[i][j]);
        let independent = choose(mechanism, state, &jacobian);
        let dependent: Vec<usize> = (0..n).filter(|j| !independent.contains(j)).collect();
        // Rows that depend on others agree with them: least squares solves them all.
        let of_dependent = jacobian.select_columns(&dependent).svd(true, true);
        let follow = |by_independent: DMatrix<f64>| match dependent.is_empty() {
            true => DMatrix::zeros(0, independent.len()),
            false => of_dependent
                .solve(&-by_independent, 1e-12)
                .unwrap_or_else(|_| DMatrix::zeros(dependent.len(), independent.len())),
        };
        let spread = |own: f64, others: DMatrix<f64>| {
            let mut all = DMatrix::zeros(n, independent.len());
            independent.iter().enumerate().for_each(|(k, j)| all[(*j, k)] = own);
            dependent.iter().enumerate().for_each(|(k, j)| all.set_row(*j, &others.row(k)));
            all
        };
        let positions = spread(1.0, follow(jacobian.select_columns(&independent)));
        let speeds = spread(0.0, follow(rates_by_positions(mechanism, state) * &positions));
        Reduction { independent, positions, speeds }
    }

    /// The change of positions and speeds with entry k of x.
    pub(super) fn change(&self, k: usize) -> (DVector<f64>, DVector<f64>) {
        let f = self.independent.len();
        match k < f {
            true => (self.positions.column(k).into(), self.speeds.column(k).into()),
            false => (DVector::zeros(self.positions.nrows()), self.positions.column(k - f).into()),
        }
    }

    /// The change of all coordinates in a mode.
    pub(super) fn positions(&self, x: &DVector<Complex<f64>>) -> DVector<Complex<f64>> {
        let f = self.independent.len();
        self.positions.map(|entry| Complex::new(entry, 0.0)) * x.rows(0, f)
    }
}

/// The coordinates that are given at the start, if they determine the others well, else what pivoting chooses.
fn choose<M: Mechanism>(mechanism: &M, state: &State<M>, jacobian: &DMatrix<f64>) -> Vec<usize> {
    let n = M::Q::LEN;
    if M::L::LEN == 0 {
        return (0..n).collect();
    }
    let freedoms = mobility(mechanism, state.time, &state.positions).degrees_of_freedom;
    let given = (0..n).filter(|j| M::DESCRIPTION.coordinates[*j].start == Start::Given);
    let given: Vec<usize> = given.take(freedoms).collect();
    let others: Vec<usize> = (0..n).filter(|j| !given.contains(j)).collect();
    let values = jacobian.select_columns(&others).singular_values();
    if given.len() == freedoms && values.iter().take(n - freedoms).all(|value| *value > REGULAR * values.max()) {
        return given;
    }
    let mut partition = Partition::default();
    match partition.renew(mechanism, state) {
        Ok(()) => (0..n).filter(|j| !partition.dependent().contains(j)).collect(),
        Err(_) => given,
    }
}

/// (C_q q' + C_t)_q, m x n, by dual numbers.
fn rates_by_positions<M: Mechanism>(mechanism: &M, state: &State<M>) -> DMatrix<f64> {
    let lifted = mechanism.on(Dual::constant);
    let columns = (0..M::Q::LEN).map(|j| rates_by_position(&lifted, state.time, j, &state.positions, &state.speeds));
    let columns: Vec<DVector<f64>> = columns.collect();
    DMatrix::from_fn(M::L::LEN, M::Q::LEN, |i, j| columns[j][i])
}

fn rates_by_position<M: Mechanism<Dual>, Q: Array<f64>>(
    mechanism: &M,
    time: f64,
    by: usize,
    q: &Q,
    qd: &Q,
) -> DVector<f64> {
    let moved = M::Q::from_fn(|j| if j == by { Dual::variable(q[j]) } else { Dual::constant(q[j]) });
    let ConstraintLinearization { jacobian, time_derivative, .. } =
        mechanism.constraint_linearization(Dual::constant(time), &moved);
    let rate = |i: usize| {
        let turning: f64 = (0..Q::LEN).map(|j| jacobian[i][j].derivative * qd[j]).sum();
        turning + time_derivative[i].derivative
    };
    DVector::from_fn(M::L::LEN, |i, _| rate(i))
}
