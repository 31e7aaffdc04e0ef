//! Partitioning: the parts of the coordinates along the constraints are independent, and those across follow from them.
//!
//! The directions across are those of the rows of C_q in the middle of a step: Mani, Haug and Atkinson, Journal of
//! Mechanisms, Transmissions, and Automation in Design 107 (1985); Potra and Yen, Mechanics of Structures and Machines
//! 19 (1991). Single coordinates (Wehage and Haug, Journal of Mechanical Design 104, 1982) change their share of the
//! motion within a step: near dead points, and wherever a crank turns far, equal steps then lose up to three digits.

use crate::model::level::{between_positions, has_speed_rows};
use crate::motion::measures::Measures;
use crate::motion::met::is_met;
use crate::motion::reduction::row_space;
use crate::motion::residuals::rates;
use crate::motion::rows::Dense;
use crate::numerics::arrays::{inner, subtract};
use crate::state::failure::{Failure, What, constraint_name, largest};
use crate::state::trajectory::{Sample, State};
use sim_kernel::{Array, Mechanism};

/// Newton steps after which the dependent parts are given up.
const MOST_STEPS: usize = 20;

/// The directions across the constraints, of positions and of speeds. They differ where constraints hold between speeds alone.
#[derive(Clone, Debug)]
pub(crate) struct Partition<M: Mechanism> {
    positions: Across<M>,
    speeds: Across<M>,
}

/// Orthonormal directions, as many as there are independent constraints; coordinates counted in the changes that count as 1.
#[derive(Clone, Debug)]
struct Across<M: Mechanism> {
    directions: M::LQ,
    rank: usize,
}

impl<M: Mechanism> Partition<M> {
    /// None chosen yet.
    pub(crate) fn new(mechanism: &M) -> Partition<M> {
        let none = Across { directions: M::LQ::repeat(mechanism.m(), M::Q::repeat(mechanism.n(), 0.0)), rank: 0 };
        Partition { positions: none.clone(), speeds: none }
    }

    /// Chooses for a step from a sample to a time, by the position in its middle, predicted from its start.
    pub(crate) fn renew(&mut self, mechanism: &M, measures: &Measures<M>, from: &Sample<M>, time: f64) {
        let (state, h) = (&from.state, (time - from.state.time) / 2.0);
        let moved = |i: usize| state.positions[i] + h * (state.speeds[i] + h / 2.0 * from.accelerations[i]);
        self.choose(mechanism, measures, state.time + h, &state.positions.like(moved));
    }

    /// Chooses by a position.
    pub(crate) fn choose(&mut self, mechanism: &M, measures: &Measures<M>, time: f64, q: &M::Q) {
        let jacobian = &mechanism.constraint_jacobian(time, q);
        self.positions =
            Across::new(mechanism, measures, between_positions(mechanism, jacobian), measures.rank_of_positions());
        if has_speed_rows(mechanism) {
            self.speeds = Across::new(mechanism, measures, jacobian.clone(), measures.rank());
        }
    }

    fn of_speeds(&self, mechanism: &M) -> &Across<M> {
        if has_speed_rows(mechanism) { &self.speeds } else { &self.positions }
    }

    /// Computes the parts across the constraints from those along them.
    pub(crate) fn follow(&self, mechanism: &M, measures: &Measures<M>, state: &mut State<M>) -> Result<(), Failure> {
        if mechanism.m() == 0 {
            return Ok(());
        }
        let (time, q) = (state.time, &mut state.positions);
        let mut linear = mechanism.constraint_linearization(time, q);
        let mut steps = 0;
        loop {
            let by_positions = between_positions(mechanism, &linear.jacobian);
            subtract(q, &self.positions.solve(mechanism, measures, &by_positions, &linear.values, time, q)?);
            linear = mechanism.constraint_linearization(time, q);
            steps += 1;
            if is_met::<f64, M, Dense>(mechanism, measures, time, q, &linear) {
                break;
            }
            if steps == MOST_STEPS {
                let (row, residual) = largest(linear.values.iter()).unwrap_or((0, f64::NAN));
                let what =
                    What::NotProjected { constraint: constraint_name(mechanism, row), residual, iterations: steps };
                return Err(Failure::at(mechanism, what, time, q));
            }
        }
        let open = rates(mechanism, &linear, &state.speeds);
        subtract(
            &mut state.speeds,
            &self.of_speeds(mechanism).solve(mechanism, measures, &linear.jacobian, &open, time, q)?,
        );
        Ok(())
    }
}

impl<M: Mechanism> Across<M> {
    fn new(mechanism: &M, measures: &Measures<M>, jacobian: M::LQ, rank: usize) -> Across<M> {
        let scaled = scaled(mechanism, measures, &jacobian);
        Across { directions: row_space(scaled, rank), rank: rank.min(mechanism.m()) }
    }

    /// The change x along the directions with C_q x = r, in SI units.
    fn solve(
        &self,
        mechanism: &M,
        measures: &Measures<M>,
        jacobian: &M::LQ,
        residual: &M::L,
        time: f64,
        q: &M::Q,
    ) -> Result<M::Q, Failure> {
        let shares = self.shares(mechanism, measures, jacobian, residual).ok_or_else(|| {
            let unknown = "what follows from the constraints".to_owned();
            Failure::at(mechanism, What::Singular { unknown }, time, q)
        })?;
        let along = |j: usize| (0..self.rank).map(|k| shares[k] * self.directions[k][j]).sum();
        Ok(measures.change(mechanism, q.like(along)))
    }

    /// The share of each direction in that change, by elimination with pivoting over the rows; the remaining rows are
    /// redundant.
    fn shares(&self, mechanism: &M, measures: &Measures<M>, jacobian: &M::LQ, residual: &M::L) -> Option<M::L> {
        let (rows, sizes) = (scaled(mechanism, measures, jacobian), measures.constraints());
        let mut residual = residual.like(|i| residual[i] / sizes[i]);
        let mut across =
            M::LL::with_len(mechanism.m(), |i| M::L::with_len(mechanism.m(), |k| inner(&rows[i], &self.directions[k])));
        for k in 0..self.rank {
            let size = |i: &usize| across[*i][k].abs();
            let row = (k..mechanism.m()).max_by(|a, b| size(a).total_cmp(&size(b)))?;
            across.as_mut().swap(k, row);
            residual.as_mut().swap(k, row);
            let pivot = across[k][k];
            if !(pivot.abs() > 0.0) {
                return None;
            }
            let (above, below) = across.as_mut().split_at_mut(k + 1);
            let pivot_row = &above[k].as_ref()[k..self.rank];
            for (i, row) in below.iter_mut().enumerate() {
                let row = &mut row.as_mut()[k..self.rank];
                let factor = row[0] / pivot;
                row.iter_mut().zip(pivot_row).for_each(|(entry, pivot)| *entry -= factor * pivot);
                residual[k + 1 + i] -= factor * residual[k];
            }
        }
        let mut shares = M::L::repeat(mechanism.m(), 0.0);
        for k in (0..self.rank).rev() {
            let known: f64 = (k + 1..self.rank).map(|j| across[k][j] * shares[j]).sum();
            shares[k] = (residual[k] - known) / across[k][k];
        }
        Some(shares)
    }
}

/// Rows in the scales of coordinates and constraints.
fn scaled<M: Mechanism>(mechanism: &M, measures: &Measures<M>, jacobian: &M::LQ) -> M::LQ {
    let mut rows = measures.columns(mechanism, jacobian);
    for (i, size) in measures.constraints().iter().enumerate() {
        rows[i].as_mut().iter_mut().for_each(|entry| *entry /= size);
    }
    rows
}
