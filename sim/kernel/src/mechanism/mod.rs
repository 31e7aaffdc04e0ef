//! The interface between generated kernels and the code that runs them.
//!
//! A mechanism is its parameters: the generated type is a struct with the parameters as fields, generic over the
//! scalar, and its kernels are methods. A separate parameter type would make every call name the mechanism twice, and
//! the trait would need generic associated types for every size.

mod compiled;
mod differentiate;

use crate::{Array, Description, Input, Scalar};
pub use compiled::Compiled;
use core::fmt::Debug;
use differentiate::{jacobian, sensitivity};

/// A mechanism with the values of its parameters, as `mechanism!` generates it.
///
/// n is the number of coordinates and m of constraint rows; matrices are arrays of rows. All quantities are in
/// SI units. Kernels neither allocate nor panic; outside a function's domain results are NaN.
pub trait Mechanism<S: Scalar = f64>: Clone + Debug {
    /// Coordinates, speeds or accelerations: n.
    type Q: Array<S>;
    /// Constraints or multipliers: m.
    type L: Array<S>;
    /// Both, one after the other: n + m.
    type Z: Array<S>;
    /// n x n.
    type QQ: Array<Self::Q>;
    /// Velocities of the mass matrix in speeds; none where the declaration does not request it.
    type V: Array<S>;
    /// As many rows as columns of these.
    type VV: Array<Self::V>;
    /// m x n.
    type LQ: Array<Self::Q>;
    /// m x m.
    type LL: Array<Self::L>;
    /// (n + m) x (n + m).
    type ZZ: Array<Self::Z>;
    /// The entries of C_q that may be nonzero, row after row as in [`Description::sparsity`]; none if that is empty.
    type Entries: Array<S>;
    /// The lower triangle of C_q C_q' within its envelope, row after row; likewise.
    type Envelope: Array<S>;
    /// Parameters.
    type Parameters: Array<S>;
    /// Inputs, each following its declared course or held.
    type Inputs: Array<Input<S>>;
    /// Outputs.
    type Outputs: Array<S>;
    /// Rates of the outputs that have one.
    type OutputRates: Array<S>;
    /// Events.
    type Events: Array<S>;
    /// The values that the actions of events need.
    type EventValues: Array<S>;
    /// Functions of time alone where expressions change their form.
    type SwitchingFunctions: Array<S>;
    /// Conditions of loads on positions and speeds.
    type LoadConditions: Array<S>;
    /// Constraints that events switch.
    type Activities: Array<S>;
    /// Numbers of the drawing.
    type Drawing: Array<S>;
    /// n x parameters.
    type QP: Array<Self::Parameters>;
    /// m x parameters.
    type LP: Array<Self::Parameters>;
    /// The values that the equations of motion need of the parameters.
    type Prepared: Clone + Debug;
    /// The same mechanism on another scalar type.
    type On<T: Scalar>: Mechanism<T>;

    /// Names, units, documentation.
    fn description(&self) -> &'static Description;
    /// The number of coordinates.
    #[inline(always)]
    fn n(&self) -> usize {
        self.description().coordinates.len()
    }
    /// The number of constraint rows.
    #[inline(always)]
    fn m(&self) -> usize {
        self.description().constraints.len()
    }
    /// Where generalised speeds are declared, the constraints that they leave, as
    /// [`GeneralizedSpeeds::ROWS`](crate::GeneralizedSpeeds::ROWS).
    #[inline(always)]
    fn rows_left(&self) -> Option<&'static [usize]> {
        None
    }
    /// The mechanism as it is declared: with defaults of parameters, inputs and activities.
    fn as_declared(&self) -> Self;
    /// The parameters in the order of declaration, in SI units.
    fn parameters(&self) -> Self::Parameters;
    /// The mechanism with these parameters and unchanged inputs and activities.
    fn with_parameters(&self, parameters: Self::Parameters) -> Self;
    /// For each constraint that events switch, 1 while it holds and 0 while it is released.
    fn activities(&self) -> Self::Activities {
        Self::Activities::repeat(self.description().conditionals.len(), S::from_f64(1.0))
    }
    /// The mechanism with these activities.
    fn with_activities(self, activities: Self::Activities) -> Self {
        let _ = activities;
        self
    }
    /// The inputs in the order of declaration.
    fn inputs(&self) -> Self::Inputs;
    /// The mechanism with these inputs.
    fn with_inputs(&self, inputs: Self::Inputs) -> Self;
    /// The inputs as they are at a time, each held at its value there.
    fn held_inputs(&self, t: S, q: &Self::Q) -> Self::Inputs {
        let _ = (t, q);
        self.inputs()
    }
    /// Sets the inputs of the prepared values.
    fn set_inputs(prepared: &mut Self::Prepared, inputs: Self::Inputs);
    /// The same mechanism on another scalar type, with each parameter and input converted.
    fn on<T: Scalar>(&self, convert: impl Fn(S) -> T) -> Self::On<T>;
    /// The declared start.
    fn initial(&self) -> Initial<Self::Q>;

    /// T_q' M T_q, n x n.
    fn mass_matrix(&self, t: S, q: &Self::Q) -> Self::QQ;
    /// N' M N in speeds: in the generalised speeds u of q' = N u + n, or, where none are declared, in q' with the velocities
    /// of free bodies. Those stand in the place of their coordinates: the velocity of the origin, then the angular velocity,
    /// both in the body's own frame. Without rows if the declaration does not request it.
    fn speed_mass_matrix(&self, t: S, q: &Self::Q) -> Self::VV {
        let _ = (t, q);
        Self::VV::repeat(0, Self::V::repeat(0, S::from_f64(0.0)))
    }
    /// T_q' M g, n.
    fn convective_forces(&self, t: S, q: &Self::Q, qd: &Self::Q) -> Self::Q;
    /// T_q' F, n.
    fn generalized_forces(&self, t: S, q: &Self::Q, qd: &Self::Q) -> Self::Q;
    /// C, m; zero for rows that hold between speeds alone.
    fn constraints(&self, t: S, q: &Self::Q) -> Self::L;
    /// The sum of the magnitudes of the terms of C, m.
    fn constraint_magnitudes(&self, t: S, q: &Self::Q) -> Self::L;
    /// C_q, m x n; w_q' for a row w(q, q', t) = 0 between speeds.
    fn constraint_jacobian(&self, t: S, q: &Self::Q) -> Self::LQ;
    /// C_t, m; w without speeds, for a row between speeds.
    fn constraint_time_derivative(&self, t: S, q: &Self::Q) -> Self::L;
    /// (C_q q' + C_t)_q q' + (..)_t, m; w' without accelerations, for a row between speeds.
    fn constraint_convective(&self, t: S, q: &Self::Q, qd: &Self::Q) -> Self::L;
    /// C, C_q and C_t together.
    fn constraint_linearization(&self, t: S, q: &Self::Q) -> ConstraintLinearization<Self::L, Self::LQ>;
    /// The same with C_q by its entries.
    fn sparse_linearization(&self, t: S, q: &Self::Q) -> ConstraintLinearization<Self::L, Self::Entries> {
        let dense = self.constraint_linearization(t, q);
        let sparsity = self.description().sparsity;
        let count = sparsity.iter().map(|row| row.columns.len()).sum();
        let mut entries = Self::Entries::repeat(count, S::from_f64(0.0));
        for row in sparsity {
            for (k, j) in row.columns.iter().enumerate() {
                entries[row.entries + k] = dense.jacobian[row.constraint][*j];
            }
        }
        ConstraintLinearization { values: dense.values, jacobian: entries, time_derivative: dense.time_derivative }
    }
    /// v' M v / 2, in joules.
    fn kinetic_energy(&self, t: S, q: &Self::Q, qd: &Self::Q) -> S;
    /// The values that the equations of motion need of the parameters, computed once for a set of parameters.
    fn prepare(&self) -> Self::Prepared;
    /// Accelerations, multipliers and power.
    fn prepared_dynamics(prepared: &Self::Prepared, t: S, q: &Self::Q, qd: &Self::Q) -> Dynamics<S, Self::Q, Self::L>;
    /// [`Mechanism::prepared_dynamics`] for one call.
    #[inline(always)]
    fn dynamics(&self, t: S, q: &Self::Q, qd: &Self::Q) -> Dynamics<S, Self::Q, Self::L> {
        Self::prepared_dynamics(&self.prepare(), t, q, qd)
    }
    /// M q'' + h - Q, n: the forces along the coordinates that must be added to produce these accelerations without
    /// constraints. A kernel of its own if the declaration requests one.
    fn inverse_dynamics(&self, t: S, q: &Self::Q, qd: &Self::Q, qdd: &Self::Q) -> Self::Q {
        let (mass, h) = (self.mass_matrix(t, q), self.convective_forces(t, q, qd));
        let loads = self.generalized_forces(t, q, qd);
        let force = |i: usize| {
            let inertial = (0..q.len()).fold(S::from_f64(0.0), |sum, j| sum + mass[i][j] * qdd[j]);
            inertial + h[i] - loads[i]
        };
        q.like(force)
    }
    /// d(q'', lambda)/d(q, q'): a kernel if the declaration requests one, otherwise from dual numbers.
    fn dynamics_jacobian(&self, t: S, q: &Self::Q, qd: &Self::Q) -> DynamicsJacobian<S, Self::QQ, Self::LQ> {
        jacobian(self, t, q, qd)
    }
    /// d(q'', lambda)/d(parameters), likewise.
    fn dynamics_sensitivity(&self, t: S, q: &Self::Q, qd: &Self::Q) -> DynamicsSensitivity<S, Self::QP, Self::LP> {
        sensitivity(self, t, q, qd)
    }
    /// The velocity variables, n, which are integrated beside q: generalised speeds, padded with zeros, if some are
    /// declared, otherwise q'.
    #[inline(always)]
    fn velocity_variables(&self, t: S, q: &Self::Q, qd: &Self::Q) -> Self::Q {
        let _ = (t, q);
        qd.clone()
    }
    /// q' of velocity variables.
    #[inline(always)]
    fn prepared_velocities(prepared: &Self::Prepared, t: S, q: &Self::Q, v: &Self::Q) -> Kinematics<S, Self::Q> {
        let _ = (prepared, t, q);
        Kinematics { rates: v.clone(), refused: S::ZERO.greater(S::ZERO) }
    }
    /// The power of loads and drives, in watts; `dynamics` gives it too.
    fn power(&self, t: S, q: &Self::Q, qd: &Self::Q, qdd: &Self::Q, lambda: &Self::L) -> S;
    /// Outputs in the order of declaration, in SI units.
    fn outputs(&self, t: S, q: &Self::Q, qd: &Self::Q, qdd: &Self::Q, lambda: &Self::L) -> Self::Outputs;
    /// Rates, in SI units, of the outputs listed in [`Description::rated_outputs`].
    fn output_rates(&self, t: S, q: &Self::Q, qd: &Self::Q, qdd: &Self::Q) -> Self::OutputRates;
    /// left - right of each event. Accelerations and multipliers count only for those that are
    /// [`on_forces`](crate::event::Event::on_forces).
    fn events(&self, t: S, q: &Self::Q, qd: &Self::Q, qdd: &Self::Q, lambda: &Self::L) -> Self::Events;
    /// The values that the actions of events set, and the coefficients of restitution of impacts, in the order of
    /// declaration.
    fn event_values(&self, t: S, q: &Self::Q, qd: &Self::Q) -> Self::EventValues {
        let _ = (t, q, qd);
        Self::EventValues::repeat(0, S::from_f64(0.0))
    }
    /// The functions of time alone that [`Description::switching`] lists, in SI units.
    fn switching_functions(&self, t: S) -> Self::SwitchingFunctions {
        let _ = t;
        Self::SwitchingFunctions::repeat(0, S::from_f64(0.0))
    }
    /// The functions of positions and speeds that [`Description::load_conditions`] lists, in SI units.
    fn load_conditions(&self, t: S, q: &Self::Q, qd: &Self::Q) -> Self::LoadConditions {
        let _ = (t, q, qd);
        Self::LoadConditions::repeat(0, S::from_f64(0.0))
    }
    /// The numbers of each shape of the drawing, in order.
    fn drawing(&self, t: S, q: &Self::Q) -> Self::Drawing;
}

/// C(q + dq) = `values` + `jacobian` dq, and the velocities obey `jacobian` q' + `time_derivative` = 0.
#[derive(Clone, Copy, Debug)]
pub struct ConstraintLinearization<L, J> {
    /// C, m.
    pub values: L,
    /// C_q, m x n or by its entries.
    pub jacobian: J,
    /// C_t, m.
    pub time_derivative: L,
}

/// The solution of the equations of motion at one state.
#[derive(Clone, Copy, Debug)]
pub struct Dynamics<S: Scalar, Q, L> {
    /// q'', n.
    pub accelerations: Q,
    /// lambda, m: the reactions, conjugate to the constraints.
    pub multipliers: L,
    /// The power of loads and drives, in watts.
    pub power: S,
    /// If true, the planned elimination refused a pivot, and nothing above is valid.
    pub refused: S::Mask,
}

/// The derivatives of the solution of the equations of motion with respect to the state.
#[derive(Clone, Copy, Debug)]
pub struct DynamicsJacobian<S: Scalar, QQ, LQ> {
    /// d(q'')/dq, n x n.
    pub accelerations_by_positions: QQ,
    /// d(q'')/dq', n x n.
    pub accelerations_by_speeds: QQ,
    /// d(lambda)/dq, m x n.
    pub multipliers_by_positions: LQ,
    /// d(lambda)/dq', m x n.
    pub multipliers_by_speeds: LQ,
    /// If true, nothing above is valid, as in [`Dynamics`].
    pub refused: S::Mask,
}

/// The derivatives of the solution of the equations of motion with respect to the parameters.
#[derive(Clone, Copy, Debug)]
pub struct DynamicsSensitivity<S: Scalar, QP, LP> {
    /// d(q'')/d(parameters), a row for each coordinate.
    pub accelerations: QP,
    /// d(lambda)/d(parameters), a row for each constraint.
    pub multipliers: LP,
    /// If true, nothing above is valid, as in [`Dynamics`].
    pub refused: S::Mask,
}

/// The declared start of the motion; entries that are not declared are 0.
#[derive(Clone, Copy, Debug)]
pub struct Initial<Q> {
    /// Values or guesses of the coordinates.
    pub positions: Q,
    /// Given speeds.
    pub speeds: Q,
}

/// Whether elimination must not divide by this pivot: cancellation has taken half of its digits, or it is zero or NaN.
/// `size` is the scale of its terms: the sum of those with the sign that the pivot should have, and of the magnitudes
/// of those whose sign is not known.
#[inline(always)]
pub fn pivot_is_refused<S: Scalar>(pivot: S, size: S) -> S::Mask {
    S::not(pivot.abs().greater(S::from_f64(S::HALF_DIGITS) * size))
}

/// The speeds that belong to generalised speeds.
#[derive(Clone, Copy, Debug)]
pub struct Kinematics<S: Scalar, Q> {
    /// q', n.
    pub rates: Q,
    /// If true, generalised speeds do not determine the speeds, and nothing above is valid.
    pub refused: S::Mask,
}
