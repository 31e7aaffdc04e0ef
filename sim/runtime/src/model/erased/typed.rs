//! A compiled mechanism with its type erased.

use super::each::{Results, States};
use super::model::{Found, Kernel, Model, Prepared, Values};
use super::one_by_one::one_by_one;
use crate::model::{At, exactly};
use crate::numerics::arrays::array;
use sim_kernel::{Array, Compiled, Description, Dual, Input, Interval, Mask, Mechanism, Scalar, Vectors};
use std::sync::Arc;

/// A compiled mechanism as a [`Model`].
pub fn erase<M: Compiled>(mechanism: M) -> Arc<dyn Model> {
    Arc::new(Typed(mechanism))
}

#[derive(Clone, Copy, Debug)]
struct Typed<M>(M);

impl<M: Compiled> Model for Typed<M> {
    fn description(&self) -> &'static Description {
        self.0.description()
    }
    fn rows_left(&self) -> Option<&'static [usize]> {
        self.0.rows_left()
    }
    fn values(&self) -> Values {
        Values {
            parameters: self.0.parameters().as_ref().to_vec(),
            inputs: self.0.inputs().as_ref().to_vec(),
            activities: self.0.activities().as_ref().to_vec(),
        }
    }
    fn with_values(&self, values: &Values) -> Arc<dyn Model> {
        Arc::new(Typed(with_values(self.0, values)))
    }
    fn as_declared(&self) -> Arc<dyn Model> {
        Arc::new(Typed(self.0.as_declared()))
    }
    fn initial(&self) -> [Vec<f64>; 2] {
        let start = self.0.initial();
        [start.positions, start.speeds].map(|values| values.as_ref().to_vec())
    }
    fn held_inputs(&self, time: f64, q: &[f64]) -> Vec<Input> {
        self.0.held_inputs(time, &array(q.len(), q)).as_ref().to_vec()
    }
    fn call(&self, kernel: Kernel, at: At<f64>, found: Found<f64>) -> bool {
        call(&self.0, kernel, at, found)
    }
    fn call_each_with(&self, _: Vectors, kernel: Kernel, states: &States) -> Results {
        one_by_one(self, kernel, states)
    }
    fn call_on_duals(&self, values: &Values<Dual>, kernel: Kernel, at: At<Dual>, found: Found<Dual>) -> bool {
        call_differentiable(&with_values(self.0.on(Dual::constant), values), kernel, at, found)
    }
    fn call_on_intervals(&self, kernel: Kernel, at: At<Dual<Interval>>, found: Found<Dual<Interval>>) -> bool {
        if kernel != Kernel::SwitchingFunctions {
            return true;
        }
        found(0, self.0.on(exactly).switching_functions(at.time).as_ref());
        false
    }
    fn prepare(&self) -> Box<dyn Prepared> {
        Box::new(PreparedKernels::<M>(self.0.prepare()))
    }
}

#[derive(Debug)]
struct PreparedKernels<M: Mechanism>(M::Prepared);

impl<M: Compiled> Prepared for PreparedKernels<M> {
    fn copied(&self) -> Box<dyn Prepared> {
        Box::new(PreparedKernels::<M>(self.0))
    }
    fn set_inputs(&mut self, inputs: &[Input]) {
        M::set_inputs(&mut self.0, inputs_of::<f64, M>(inputs));
    }
    fn call(&self, kernel: Kernel, at: At<f64>, found: Found<f64>) -> bool {
        call_prepared::<f64, M>(&self.0, kernel, at, found)
    }
}

fn inputs_of<S: Scalar, M: Mechanism<S>>(inputs: &[Input<S>]) -> M::Inputs {
    M::Inputs::with_len(inputs.len(), |i| inputs[i])
}

fn with_values<S: Scalar, M: Mechanism<S>>(mechanism: M, values: &Values<S>) -> M {
    let Values { parameters, inputs, activities } = values;
    let mechanism = mechanism.with_parameters(array(parameters.len(), parameters));
    let mechanism = mechanism.with_inputs(inputs_of::<S, M>(inputs));
    mechanism.with_activities(array(activities.len(), activities))
}

fn call_prepared<S: Scalar, M: Mechanism<S>>(
    prepared: &M::Prepared,
    kernel: Kernel,
    at: At<S>,
    found: Found<S>,
) -> bool {
    let (n, t) = (at.positions.len(), at.time);
    let (q, qd) = (array(n, at.positions), array(n, at.speeds));
    if kernel == Kernel::Velocities {
        let velocities = M::prepared_velocities(prepared, t, &q, &qd);
        found(0, velocities.rates.as_ref());
        return velocities.refused.any();
    }
    let solved = M::prepared_dynamics(prepared, t, &q, &qd);
    found(0, solved.accelerations.as_ref());
    found(1, solved.multipliers.as_ref());
    found(2, &[solved.power]);
    solved.refused.any()
}

/// The kernels that analyses and sensitivities differentiate, which are all that is compiled on dual numbers; others are refused.
fn call_differentiable<S: Scalar, M: Mechanism<S>>(mechanism: &M, kernel: Kernel, at: At<S>, found: Found<S>) -> bool {
    let (n, m, t) = (mechanism.n(), mechanism.m(), at.time);
    let (q, qd): (M::Q, M::Q) = (array(n, at.positions), array(n, at.speeds));
    let accelerations = || array::<S, M::Q>(n, at.accelerations);
    match kernel {
        Kernel::ConstraintLinearization => {
            let linear = mechanism.constraint_linearization(t, &q);
            found(0, linear.values.as_ref());
            found(1, linear.time_derivative.as_ref());
            rows(2, &linear.jacobian, found);
        }
        Kernel::ConstraintMagnitudes => found(0, mechanism.constraint_magnitudes(t, &q).as_ref()),
        Kernel::SparseLinearization => {
            let linear = mechanism.sparse_linearization(t, &q);
            found(0, linear.values.as_ref());
            found(1, linear.time_derivative.as_ref());
            found(2, linear.jacobian.as_ref());
        }
        Kernel::Dynamics | Kernel::Velocities => {
            return call_prepared::<S, M>(&mechanism.prepare(), kernel, at, found);
        }
        Kernel::VelocityVariables => found(0, mechanism.velocity_variables(t, &q, &qd).as_ref()),
        Kernel::Outputs => {
            found(0, mechanism.outputs(t, &q, &qd, &accelerations(), &array(m, at.multipliers)).as_ref());
        }
        Kernel::OutputRates => found(0, mechanism.output_rates(t, &q, &qd, &accelerations()).as_ref()),
        Kernel::SwitchingFunctions => found(0, mechanism.switching_functions(t).as_ref()),
        Kernel::LoadConditions => found(0, mechanism.load_conditions(t, &q, &qd).as_ref()),
        _ => return true,
    }
    false
}

/// All kernels.
fn call<M: Mechanism>(mechanism: &M, kernel: Kernel, at: At<f64>, found: Found<f64>) -> bool {
    let (n, m, t) = (mechanism.n(), mechanism.m(), at.time);
    let (q, qd): (M::Q, M::Q) = (array(n, at.positions), array(n, at.speeds));
    let accelerations = || array::<f64, M::Q>(n, at.accelerations);
    let multipliers = || array::<f64, M::L>(m, at.multipliers);
    match kernel {
        Kernel::MassMatrix => rows(0, &mechanism.mass_matrix(t, &q), found),
        Kernel::SpeedMassMatrix => rows(0, &mechanism.speed_mass_matrix(t, &q), found),
        Kernel::ConvectiveForces => found(0, mechanism.convective_forces(t, &q, &qd).as_ref()),
        Kernel::GeneralizedForces => found(0, mechanism.generalized_forces(t, &q, &qd).as_ref()),
        Kernel::Constraints => found(0, mechanism.constraints(t, &q).as_ref()),
        Kernel::ConstraintJacobian => rows(0, &mechanism.constraint_jacobian(t, &q), found),
        Kernel::ConstraintTimeDerivative => found(0, mechanism.constraint_time_derivative(t, &q).as_ref()),
        Kernel::ConstraintConvective => found(0, mechanism.constraint_convective(t, &q, &qd).as_ref()),
        Kernel::KineticEnergy => found(0, &[mechanism.kinetic_energy(t, &q, &qd)]),
        Kernel::InverseDynamics => found(0, mechanism.inverse_dynamics(t, &q, &qd, &accelerations()).as_ref()),
        Kernel::DynamicsJacobian => {
            let by_state = mechanism.dynamics_jacobian(t, &q, &qd);
            rows(0, &by_state.accelerations_by_positions, found);
            rows(n, &by_state.accelerations_by_speeds, found);
            rows(2 * n, &by_state.multipliers_by_positions, found);
            rows(2 * n + m, &by_state.multipliers_by_speeds, found);
            return by_state.refused.any();
        }
        Kernel::DynamicsSensitivity => {
            let by_parameters = mechanism.dynamics_sensitivity(t, &q, &qd);
            rows(0, &by_parameters.accelerations, found);
            rows(n, &by_parameters.multipliers, found);
            return by_parameters.refused.any();
        }
        Kernel::Power => found(0, &[mechanism.power(t, &q, &qd, &accelerations(), &multipliers())]),
        Kernel::Events => found(0, mechanism.events(t, &q, &qd, &accelerations(), &multipliers()).as_ref()),
        Kernel::EventValues => found(0, mechanism.event_values(t, &q, &qd).as_ref()),
        Kernel::Drawing => found(0, mechanism.drawing(t, &q).as_ref()),
        Kernel::ConstraintLinearization
        | Kernel::ConstraintMagnitudes
        | Kernel::SparseLinearization
        | Kernel::Dynamics
        | Kernel::Velocities
        | Kernel::VelocityVariables
        | Kernel::Outputs
        | Kernel::OutputRates
        | Kernel::SwitchingFunctions
        | Kernel::LoadConditions => return call_differentiable(mechanism, kernel, at, found),
    }
    false
}

/// The rows of a matrix, from this index on.
fn rows<S: Scalar, R: Array<S>>(first: usize, matrix: &impl Array<R>, found: Found<S>) {
    for (i, row) in matrix.iter().enumerate() {
        found(first + i, row.as_ref());
    }
}
