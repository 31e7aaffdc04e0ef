//! From changes of the independent coordinates and speeds to those of all.

use super::derivatives::constants;
use crate::any::{AnyMechanism, At};
use crate::mobility::mobility_of;
use nalgebra::{Complex, DMatrix, DVector, Dyn, SVD};
use sim_kernel::{Dual, Start};

/// The given coordinates are taken as independent ones if the columns of the others are this far from singular.
const REGULAR: f64 = 1e-3;

/// dq = H dq_i, dq' = N dq_i' + S dq_i. Where constraints hold between speeds alone there are more independent coordinates
/// than independent speeds; elsewhere H is N.
pub(super) struct Reduction {
    /// The independent coordinates, h of them.
    pub(super) independent: Vec<usize>,
    /// The independent speeds, f of them.
    pub(super) independent_speeds: Vec<usize>,
    /// H, n x h.
    by_positions: DMatrix<f64>,
    /// S, n x h.
    speeds_by_positions: DMatrix<f64>,
    /// N, n x f.
    by_speeds: DMatrix<f64>,
}

impl Reduction {
    pub(super) fn at(mechanism: &dyn AnyMechanism, at: At<f64>) -> Reduction {
        let of_speeds = mechanism.constraint_jacobian(at.time, at.positions);
        let of_positions = mechanism.between_positions(of_speeds.clone());
        let chosen = chosen(mechanism, at);
        let freedoms = mobility_of(mechanism, at.time, at.positions);
        // In a singular position more than nearby.
        let more = freedoms.singular.len();
        let [moves, rates] = [
            Split::new(&of_positions, freedoms.configuration_freedom + more, &chosen[0]),
            Split::new(&of_speeds, freedoms.degrees_of_freedom + more, &chosen[1]),
        ];
        let by_positions = moves.spread(1.0, &moves.columns(&of_positions));
        let bent = rates_by_positions(mechanism, at) * &by_positions;
        Reduction {
            speeds_by_positions: rates.spread(0.0, &bent),
            by_speeds: rates.spread(1.0, &rates.columns(&of_speeds)),
            by_positions,
            independent: moves.independent,
            independent_speeds: rates.independent,
        }
    }

    /// The change of positions and speeds with entry k of x.
    pub(super) fn change(&self, k: usize) -> (DVector<f64>, DVector<f64>) {
        let h = self.independent.len();
        match k < h {
            true => (self.by_positions.column(k).into(), self.speeds_by_positions.column(k).into()),
            false => (DVector::zeros(self.by_positions.nrows()), self.by_speeds.column(k - h).into()),
        }
    }

    /// The change of all coordinates in a mode.
    pub(super) fn positions(&self, x: &DVector<Complex<f64>>) -> DVector<Complex<f64>> {
        self.by_positions.map(|entry| Complex::new(entry, 0.0)) * x.rows(0, self.independent.len())
    }
}

/// Independent and dependent columns of a constraint Jacobian.
struct Split {
    independent: Vec<usize>,
    dependent: Vec<usize>,
    /// Of the dependent columns, if there are any.
    factors: Option<SVD<f64, Dyn, Dyn>>,
}

impl Split {
    /// The columns that are given at the start are independent if the others are regular, else those that pivoting chose.
    fn new(jacobian: &DMatrix<f64>, freedoms: usize, chosen: &Given) -> Split {
        let n = jacobian.ncols();
        let rest = |taken: &[usize]| (0..n).filter(|j| !taken.contains(j)).collect::<Vec<usize>>();
        let given: Vec<usize> = chosen.given.iter().copied().take(freedoms).collect();
        let is_regular = |dependent: &DMatrix<f64>| {
            let values = dependent.singular_values();
            values.iter().take(dependent.ncols()).all(|value| *value > REGULAR * values.max())
        };
        if jacobian.is_empty() || freedoms == n {
            return Split { independent: rest(&[]), dependent: Vec::new(), factors: None };
        }
        let independent = if given.len() == freedoms && is_regular(&jacobian.select_columns(&rest(&given))) {
            given
        } else {
            rest(&chosen.dependent)
        };
        let dependent = rest(&independent);
        let factors = (!dependent.is_empty()).then(|| jacobian.select_columns(&dependent).svd(true, true));
        Split { independent, dependent, factors }
    }

    fn columns(&self, jacobian: &DMatrix<f64>) -> DMatrix<f64> {
        jacobian.select_columns(&self.independent)
    }

    /// The change of all with each column: `own` times a unit vector of the independent ones, and the others so that
    /// J_d x_d = -rates. Rows that depend on others agree with them, and least squares solves them all.
    fn spread(&self, own: f64, rates: &DMatrix<f64>) -> DMatrix<f64> {
        let mut all = DMatrix::zeros(self.independent.len() + self.dependent.len(), rates.ncols());
        if own != 0.0 {
            self.independent.iter().enumerate().for_each(|(k, j)| all[(*j, k)] = own);
        }
        if let Some(Ok(others)) = self.factors.as_ref().map(|factors| factors.solve(&-rates, 1e-12)) {
            self.dependent.iter().enumerate().for_each(|(k, j)| all.set_row(*j, &others.row(k)));
        }
        all
    }
}

/// Coordinates or speeds that the declaration gives at the start, and those that pivoting takes for dependent.
struct Given {
    given: Vec<usize>,
    dependent: Vec<usize>,
}

fn chosen(mechanism: &dyn AnyMechanism, at: At<f64>) -> [Given; 2] {
    let coordinates = mechanism.description().coordinates.iter().enumerate();
    let given: Vec<usize> = coordinates.filter(|(_, c)| c.start == Start::Given).map(|(j, _)| j).collect();
    // What pivoting cannot choose, because nothing is independent, is not asked for either.
    let chosen = mechanism.dependent(at).unwrap_or_default();
    chosen.map(|dependent| Given { given: given.clone(), dependent })
}

/// (C_q q' + C_t)_q, m x n, by dual numbers.
fn rates_by_positions(mechanism: &dyn AnyMechanism, at: At<f64>) -> DMatrix<f64> {
    let (n, m) = (at.positions.len(), mechanism.description().constraints.len());
    let mut rates = DMatrix::zeros(m, n);
    for by in 0..n {
        let mut positions = constants(at.positions);
        positions[by] = Dual::variable(at.positions[by]);
        let moving = At::moving(Dual::constant(at.time), &positions, &[]);
        let [_, jacobian, time_derivative] = mechanism.constraints_along(moving, None);
        for i in 0..m {
            let turning = jacobian[n * i..n * (i + 1)].iter().zip(at.speeds).map(|(c, speed)| c.derivative * speed);
            rates[(i, by)] = turning.sum::<f64>() + time_derivative[i].derivative;
        }
    }
    rates
}
