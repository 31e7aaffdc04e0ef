//! A type-erased mechanism: its kernels on slices, whose lengths are known at run time.
//!
//! What runs at every step knows the mechanism's sizes at compile time and is compiled for each mechanism. Everything
//! else (assembly, mobility, sweeps, linearisation, verification, tables, reports) is written for these kernels, and
//! compiled once. Public functions stay generic and are a few lines each.

mod at;
pub(crate) mod conditional;
mod control;
pub(crate) mod erased;
pub(crate) mod level;

pub use at::At;
pub(crate) use at::{constants, exactly};
pub use control::Control;

use crate::model::conditional::is_row_active;
use crate::state::failure::{Failure, What, row_name};
use nalgebra::{DMatrix, DVector};
use sim_kernel::{Description, Dual, Input};

/// C, C_q and C_t.
pub(crate) struct Linear {
    pub(crate) values: DVector<f64>,
    /// m x n.
    pub(crate) jacobian: DMatrix<f64>,
    pub(crate) time_derivative: DVector<f64>,
}

/// The kernels of a mechanism; arguments and results are as those of [`Mechanism`].
pub(crate) trait AnyMechanism {
    fn description(&self) -> &'static Description;
    fn parameters(&self) -> Vec<f64>;
    fn inputs(&self) -> Vec<Input>;
    fn activities(&self) -> Vec<f64>;
    fn constraints(&self, time: f64, q: &[f64]) -> DVector<f64>;
    fn constraint_magnitudes(&self, time: f64, q: &[f64]) -> DVector<f64>;
    fn constraint_jacobian(&self, time: f64, q: &[f64]) -> DMatrix<f64>;
    fn constraint_time_derivative(&self, time: f64, q: &[f64]) -> DVector<f64>;
    fn constraint_linearization(&self, time: f64, q: &[f64]) -> Linear;
    fn constraint_convective(&self, time: f64, q: &[f64], qd: &[f64]) -> DVector<f64>;
    fn mass_matrix(&self, time: f64, q: &[f64]) -> DMatrix<f64>;
    fn convective_forces(&self, time: f64, q: &[f64], qd: &[f64]) -> DVector<f64>;
    fn generalized_forces(&self, time: f64, q: &[f64], qd: &[f64]) -> DVector<f64>;
    fn kinetic_energy(&self, time: f64, q: &[f64], qd: &[f64]) -> f64;
    fn power(&self, at: At<f64>) -> f64;
    fn outputs(&self, at: At<f64>) -> Vec<f64>;
    fn output_rates(&self, at: At<f64>) -> Vec<f64>;
    fn events(&self, at: At<f64>) -> Vec<f64>;
    fn event_values(&self, at: At<f64>) -> Vec<f64>;
    fn switching_functions(&self, time: f64) -> Vec<f64>;
    fn load_conditions(&self, at: At<f64>) -> Vec<f64>;
    /// Whether the constraints are met, as after a projection.
    fn is_met(&self, time: f64, q: &[f64]) -> bool;
    /// As [`project_positions`].
    fn project_positions(&self, time: f64, q: &mut [f64]) -> Result<(), Failure>;
    /// Accelerations and multipliers, of the mechanism with other parameters and inputs.
    fn accelerate_with(&self, parameters: &[f64], inputs: &[Input], at: At<f64>) -> Result<DVector<f64>, Failure>;
    /// The inputs as they are at a time, each held at its value there.
    fn held_inputs(&self, time: f64, q: &[f64]) -> Vec<Input>;
    /// Whether a row of the constraints holds: all do except those of released constraints.
    fn is_active(&self, row: usize) -> bool {
        is_row_active(self.description(), &self.activities(), row)
    }

    /// Accelerations and, below them, multipliers.
    fn accelerate(&self, at: At<f64>) -> Result<DVector<f64>, Failure> {
        self.accelerate_with(&self.parameters(), &self.inputs(), at)
    }

    /// C_q with zeros in the rows between speeds alone: what positions are corrected by.
    fn between_positions(&self, mut jacobian: DMatrix<f64>) -> DMatrix<f64> {
        self.description().speed_constraints.iter().for_each(|row| jacobian.row_mut(*row).fill(0.0));
        jacobian
    }

    /// The name of a constraint row.
    fn constraint_name(&self, row: usize) -> &'static str {
        row_name(self.description(), row)
    }

    /// A failure at a position.
    fn failure(&self, what: What, time: f64, q: &[f64]) -> Failure {
        Failure::of(self.description(), what, time, q)
    }
}

/// A mechanism with its derivatives, from generated kernels and from dual numbers. These are apart so that a program which
/// only runs mechanisms compiles no kernels on dual numbers for them.
pub(crate) trait Differentiable: AnyMechanism {
    /// d(q'', lambda)/dq and d(q'', lambda)/dq', each n + m x n, from the generated kernels; `None` if these refuse a
    /// pivot.
    fn by_state(&self, time: f64, q: &[f64], qd: &[f64]) -> Option<[DMatrix<f64>; 2]>;
    /// Accelerations and multipliers with their derivatives along a change of positions and speeds, and of a control;
    /// `None` if the elimination refuses a pivot.
    fn solution_along(&self, at: At<Dual>, control: Option<Control>) -> Option<Vec<Dual>>;
    /// C, C_q by rows, and C_t, likewise.
    fn constraints_along(&self, at: At<Dual>, control: Option<Control>) -> [Vec<Dual>; 3];
    /// The outputs, likewise.
    fn outputs_along(&self, at: At<Dual>, control: Option<Control>) -> Vec<Dual>;
    /// The rates of outputs that have one, with their derivatives along a change of positions and speeds.
    fn output_rates_along(&self, at: At<Dual>) -> Vec<Dual>;
}

/// One matrix below the other.
pub(crate) fn below(above: DMatrix<f64>, below: DMatrix<f64>) -> DMatrix<f64> {
    let (n, m) = (above.nrows(), below.nrows());
    let mut both = above.resize_vertically(n + m, 0.0);
    both.rows_mut(n, m).copy_from(&below);
    both
}
