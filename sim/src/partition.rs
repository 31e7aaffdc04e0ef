//! Coordinate partitioning: some coordinates are independent, and the others follow from the constraints.
//!
//! Wehage and Haug, Journal of Mechanical Design 104 (1982): the dependent coordinates are those whose columns of the
//! constraint Jacobian carry the pivots of an elimination with complete pivoting.

use crate::failure::{Failure, What, constraint_name, largest};
use crate::level::{between_positions, has_speed_rows};
use crate::project::is_met;
use crate::trajectory::State;
use sim_kernel::{Array, Mechanism};

/// Newton steps after which the dependent coordinates are given up.
const MOST_STEPS: usize = 20;
/// Where a dependent coordinate moves this much faster than an independent one, the choice has aged: a fresh one has
/// ratios of about 1.
const OLD: f64 = 4.0;
/// A pivot this much smaller than the first is taken for zero.
const SMALLEST_PIVOT: f64 = 1e-9;

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
    /// Chooses again if the choice has aged, or none has been made.
    pub(crate) fn renew<M: Mechanism>(&mut self, mechanism: &M, state: &State<M>) -> Result<(), Failure> {
        let jacobian = mechanism.constraint_jacobian(state.time, &state.positions);
        self.positions.renew::<M>(between_positions::<M>(&jacobian));
        if has_speed_rows::<M>() {
            self.speeds.renew::<M>(jacobian);
        }
        Ok(())
    }

    /// The dependent coordinates and the dependent speeds, by index.
    pub(crate) fn dependent<M: Mechanism>(&self) -> [&[usize]; 2] {
        [&self.positions.dependent, &self.of_speeds::<M>().dependent]
    }

    fn of_speeds<M: Mechanism>(&self) -> &Choice {
        if has_speed_rows::<M>() { &self.speeds } else { &self.positions }
    }

    /// Makes the dependent coordinates and speeds follow from the independent ones.
    pub(crate) fn follow<M: Mechanism>(&self, mechanism: &M, state: &mut State<M>) -> Result<(), Failure> {
        if M::L::LEN == 0 {
            return Ok(());
        }
        let (time, q) = (state.time, &mut state.positions);
        let mut linear = mechanism.constraint_linearization(time, q);
        let mut steps = 0;
        loop {
            let by_positions = between_positions::<M>(&linear.jacobian);
            let (_, change) = self.positions.reduce::<M>(by_positions, linear.values, time, q)?;
            self.positions.dependent.iter().enumerate().for_each(|(k, i)| q[*i] -= change[k]);
            linear = mechanism.constraint_linearization(time, q);
            steps += 1;
            if is_met(mechanism, time, q, &linear) {
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
        let (_, following) = speeds.reduce::<M>(linear.jacobian, driven, time, q)?;
        speeds.dependent.iter().enumerate().for_each(|(k, i)| state.speeds[*i] = -following[k]);
        Ok(())
    }
}

impl Choice {
    fn renew<M: Mechanism>(&mut self, jacobian: M::LQ) {
        if self.dependent.is_empty() || self.has_aged::<M>(jacobian) {
            self.choose::<M>(jacobian);
        }
    }

    /// By elimination with complete pivoting.
    fn choose<M: Mechanism>(&mut self, mut jacobian: M::LQ) {
        self.dependent.clear();
        let mut first = 0.0;
        for k in 0..M::L::LEN.min(M::Q::LEN) {
            let (mut row, mut column, mut size) = (k, 0, 0.0);
            for i in k..M::L::LEN {
                for j in 0..M::Q::LEN {
                    let entry = jacobian[i][j].abs();
                    if entry > size && !self.dependent.contains(&j) {
                        (row, column, size) = (i, j, entry);
                    }
                }
            }
            first = f64::max(first, size);
            if !(size > SMALLEST_PIVOT * first) {
                break;
            }
            jacobian.as_mut().swap(k, row);
            eliminate_column::<M>(&mut jacobian, &mut M::L::filled(0.0), k, column);
            self.dependent.push(column);
        }
    }

    fn has_aged<M: Mechanism>(&self, jacobian: M::LQ) -> bool {
        let Some(reduced) = self.reduced::<M>(jacobian, M::L::filled(0.0)) else { return true };
        let rows = reduced.0.iter().take(self.dependent.len());
        !rows.flat_map(|row| row.iter()).all(|entry| entry.abs() <= OLD)
    }

    /// J_d^-1 J and J_d^-1 r, where J_d are the columns of the dependent coordinates: row k belongs to the k-th of them.
    fn reduced<M: Mechanism>(&self, mut jacobian: M::LQ, mut residual: M::L) -> Option<(M::LQ, M::L)> {
        for (k, column) in self.dependent.iter().enumerate() {
            let size = |i: &usize| jacobian[*i][*column].abs();
            let row = (k..M::L::LEN).max_by(|a, b| size(a).total_cmp(&size(b)))?;
            jacobian.as_mut().swap(k, row);
            residual.as_mut().swap(k, row);
            if !(jacobian[k][*column].abs() > 0.0) {
                return None;
            }
            eliminate_column::<M>(&mut jacobian, &mut residual, k, *column);
        }
        Some((jacobian, residual))
    }

    fn reduce<M: Mechanism>(
        &self,
        jacobian: M::LQ,
        residual: M::L,
        time: f64,
        q: &M::Q,
    ) -> Result<(M::LQ, M::L), Failure> {
        self.reduced::<M>(jacobian, residual).ok_or_else(|| {
            let names = self.dependent.iter().map(|i| format!("`{}`", M::DESCRIPTION.coordinates[*i].position.name));
            let unknown = format!("a dependent coordinate, of {},", names.collect::<Vec<_>>().join(", "));
            Failure::at::<M>(What::Singular { unknown }, time, q)
        })
    }
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
