//! Coordinate partitioning: some coordinates are independent, and the others follow from the constraints.
//!
//! Wehage and Haug, Journal of Mechanical Design 104 (1982): the dependent coordinates are those whose columns of the
//! constraint Jacobian carry the pivots of an elimination with complete pivoting.

use crate::failure::{Failure, What, constraint_name, largest};
use crate::level::{between_positions, has_speed_rows};
use crate::measures::Measures;
use crate::met::is_met;
use crate::trajectory::{Sample, State};
use sim_kernel::{Array, Mechanism};

/// Newton steps after which the dependent coordinates are given up.
const MOST_STEPS: usize = 20;

/// The dependent coordinates and the dependent speeds. They differ where constraints hold between speeds alone.
#[derive(Clone, Debug, Default)]
pub(crate) struct Partition {
    positions: Choice,
    speeds: Choice,
}

/// Which coordinates or speeds are dependent: as many as there are independent constraints.
#[derive(Clone, Debug, Default)]
struct Choice {
    dependent: Vec<usize>,
}

impl Partition {
    /// Chooses for a step from a sample to a time, by the position in its middle, foretold from its start.
    pub(crate) fn renew<M: Mechanism>(&mut self, mechanism: &M, measures: &Measures<M>, from: &Sample<M>, time: f64) {
        let (state, h) = (&from.state, (time - from.state.time) / 2.0);
        let moved = |i: usize| state.positions[i] + h * (state.speeds[i] + h / 2.0 * from.accelerations[i]);
        self.choose(mechanism, measures, state.time + h, &M::Q::from_fn(moved));
    }

    /// Chooses by a position.
    pub(crate) fn choose<M: Mechanism>(&mut self, mechanism: &M, measures: &Measures<M>, time: f64, q: &M::Q) {
        let jacobian = &mechanism.constraint_jacobian(time, q);
        self.positions.choose(measures, between_positions::<M>(jacobian), measures.rank_of_positions());
        if has_speed_rows::<M>() {
            self.speeds.choose(measures, *jacobian, measures.rank());
        }
    }

    fn of_speeds<M: Mechanism>(&self) -> &Choice {
        if has_speed_rows::<M>() { &self.speeds } else { &self.positions }
    }

    /// Makes the dependent coordinates and speeds follow from the independent ones.
    pub(crate) fn follow<M: Mechanism>(
        &self,
        mechanism: &M,
        measures: &Measures<M>,
        state: &mut State<M>,
    ) -> Result<(), Failure> {
        if M::L::LEN == 0 {
            return Ok(());
        }
        let (time, q) = (state.time, &mut state.positions);
        let mut linear = mechanism.constraint_linearization(time, q);
        let mut steps = 0;
        loop {
            let by_positions = between_positions::<M>(&linear.jacobian);
            let change = self.positions.solve(measures, by_positions, linear.values, time, q)?;
            self.positions.dependent.iter().enumerate().for_each(|(k, i)| q[*i] -= change[k]);
            linear = mechanism.constraint_linearization(time, q);
            steps += 1;
            if is_met(mechanism, measures, time, q, &linear) {
                break;
            }
            if steps == MOST_STEPS {
                let (row, residual) = largest(linear.values.iter()).unwrap_or((0, f64::NAN));
                let what = What::NotProjected { constraint: constraint_name::<M>(row), residual, iterations: steps };
                return Err(Failure::at::<M>(what, time, q));
            }
        }
        let speeds = self.of_speeds::<M>();
        speeds.dependent.iter().for_each(|i| state.speeds[*i] = 0.0);
        let driven = crate::project::rates::<M>(&linear, &state.speeds);
        let following = speeds.solve(measures, linear.jacobian, driven, time, q)?;
        speeds.dependent.iter().enumerate().for_each(|(k, i)| state.speeds[*i] = -following[k]);
        Ok(())
    }
}

impl Choice {
    /// By elimination with complete pivoting.
    fn choose<M: Mechanism>(&mut self, measures: &Measures<M>, jacobian: M::LQ, rank: usize) {
        self.dependent.clear();
        let (mut rows, _) = scaled(measures, &jacobian, &M::L::filled(0.0));
        for k in 0..rank.min(M::Q::LEN) {
            let (mut row, mut column, mut size) = (k, 0, 0.0);
            for i in k..M::L::LEN {
                for j in 0..M::Q::LEN {
                    let entry = rows[i][j].abs();
                    if entry > size && !self.dependent.contains(&j) {
                        (row, column, size) = (i, j, entry);
                    }
                }
            }
            if !(size > 0.0) {
                break;
            }
            rows.as_mut().swap(k, row);
            eliminate_column::<M>(&mut rows, &mut M::L::filled(0.0), k, column);
            self.dependent.push(column);
        }
    }

    /// J_d^-1 J and J_d^-1 r, where J_d are the columns of the dependent coordinates: row k belongs to the k-th of them. All
    /// coordinates are counted in the changes that count as 1.
    fn reduced<M: Mechanism>(
        &self,
        measures: &Measures<M>,
        jacobian: &M::LQ,
        residual: &M::L,
    ) -> Option<(M::LQ, M::L)> {
        let (mut rows, mut residual) = scaled(measures, jacobian, residual);
        for (k, column) in self.dependent.iter().enumerate() {
            let size = |i: &usize| rows[*i][*column].abs();
            let row = (k..M::L::LEN).max_by(|a, b| size(a).total_cmp(&size(b)))?;
            rows.as_mut().swap(k, row);
            residual.as_mut().swap(k, row);
            if !(rows[k][*column].abs() > 0.0) {
                return None;
            }
            eliminate_column::<M>(&mut rows, &mut residual, k, *column);
        }
        Some((rows, residual))
    }

    /// J_d^-1 r, in SI units.
    fn solve<M: Mechanism>(
        &self,
        measures: &Measures<M>,
        jacobian: M::LQ,
        residual: M::L,
        time: f64,
        q: &M::Q,
    ) -> Result<M::L, Failure> {
        let fail = || {
            let names = self.dependent.iter().map(|i| format!("`{}`", M::DESCRIPTION.coordinates[*i].position.name));
            let unknown = format!("a dependent coordinate, of {},", names.collect::<Vec<_>>().join(", "));
            Failure::at::<M>(What::Singular { unknown }, time, q)
        };
        let (_, mut solution) = self.reduced(measures, &jacobian, &residual).ok_or_else(fail)?;
        let mut change = M::Q::filled(0.0);
        self.dependent.iter().enumerate().for_each(|(k, i)| change[*i] = solution[k]);
        change = measures.change(change);
        self.dependent.iter().enumerate().for_each(|(k, i)| solution[k] = change[*i]);
        Ok(solution)
    }
}

/// Rows and their residuals in what coordinates and constraints are measured by.
fn scaled<M: Mechanism>(measures: &Measures<M>, jacobian: &M::LQ, residual: &M::L) -> (M::LQ, M::L) {
    let (mut rows, mut residual) = (measures.columns(jacobian), *residual);
    for (i, size) in measures.constraints().iter().enumerate() {
        rows[i].as_mut().iter_mut().for_each(|entry| *entry /= size);
        residual[i] /= size;
    }
    (rows, residual)
}

/// Makes column j a unit vector with its 1 in row k.
fn eliminate_column<M: Mechanism>(jacobian: &mut M::LQ, residual: &mut M::L, k: usize, column: usize) {
    let pivot = jacobian[k][column];
    jacobian[k].as_mut().iter_mut().for_each(|entry| *entry /= pivot);
    residual[k] /= pivot;
    for i in (0..M::L::LEN).filter(|i| *i != k) {
        let factor = jacobian[i][column];
        for j in 0..M::Q::LEN {
            jacobian[i][j] -= factor * jacobian[k][j];
        }
        residual[i] -= factor * residual[k];
    }
}
