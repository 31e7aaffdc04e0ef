//! A mechanism one of whose kernels is spoiled, for tests of what verification sees.

use sim::sim_kernel::{ConstraintLinearization, DynamicsJacobian, Initial};
use sim::{Compiled, Description, Dynamics, FixedArray, Mechanism, Scalar};

/// What is wrong.
#[derive(Clone, Copy, Debug, PartialEq)]
pub(crate) enum Fault {
    None,
    /// The first multiplier has the wrong sign.
    MultiplierSign,
    /// Convective forces lack the products of two different speeds.
    MixedDerivative,
    /// Convective forces, kinetic energy and power take what this parameter moves in time for fixed.
    Frozen(usize),
    /// Generalised forces lack the load with this parameter.
    LostLoad(usize),
    /// Kernels take this parameter for a number in another unit.
    UnitFactor(usize, f64),
    /// The first two outputs are exchanged.
    SwappedOutputs,
    /// d(q'')/dq lacks its first entry.
    LostDerivative,
    /// Accelerations leave out what the constraints' convective terms are.
    LostConvective,
    /// The power of loads is half of what it is.
    HalfPower,
}

/// The mechanism `true_one`, spoiled.
#[derive(Clone, Copy, Debug)]
pub(crate) struct Faulty<M> {
    pub(crate) true_one: M,
    pub(crate) fault: Fault,
}

impl<M: Compiled> Faulty<M> {
    /// The mechanism whose kernels are called.
    fn kernels(&self) -> M {
        match self.fault {
            Fault::UnitFactor(parameter, factor) => self.with(parameter, |value| factor * value),
            _ => self.true_one,
        }
    }

    fn with(&self, parameter: usize, change: impl Fn(f64) -> f64) -> M {
        let mut parameters = self.true_one.parameters();
        parameters[parameter] = change(parameters[parameter]);
        self.true_one.with_parameters(parameters)
    }

    /// The mechanism for what depends on the rates of moved points.
    fn moved(&self) -> M {
        match self.fault {
            Fault::Frozen(parameter) => self.with(parameter, |_| 0.0),
            _ => self.kernels(),
        }
    }
}

impl<M: Compiled> Mechanism for Faulty<M> {
    type Q = M::Q;
    type L = M::L;
    type Z = M::Z;
    type QQ = M::QQ;
    type V = M::V;
    type VV = M::VV;
    type LQ = M::LQ;
    type LL = M::LL;
    type ZZ = M::ZZ;
    type Entries = M::Entries;
    type Envelope = M::Envelope;
    type Parameters = M::Parameters;
    type Outputs = M::Outputs;
    type OutputRates = M::OutputRates;
    type Events = M::Events;
    type EventValues = M::EventValues;
    type SwitchingFunctions = M::SwitchingFunctions;
    type LoadConditions = M::LoadConditions;
    type Activities = M::Activities;
    type Drawing = M::Drawing;
    type QP = M::QP;
    type LP = M::LP;
    type Inputs = M::Inputs;
    type Prepared = Self;
    type On<T: Scalar> = M::On<T>;

    fn description(&self) -> &'static Description {
        self.true_one.description()
    }
    fn as_declared(&self) -> Self {
        Faulty { true_one: M::defaults(), fault: Fault::None }
    }
    fn parameters(&self) -> Self::Parameters {
        self.true_one.parameters()
    }
    fn with_parameters(&self, parameters: Self::Parameters) -> Self {
        Faulty { true_one: self.true_one.with_parameters(parameters), ..*self }
    }
    fn inputs(&self) -> Self::Inputs {
        self.true_one.inputs()
    }
    fn with_inputs(&self, inputs: Self::Inputs) -> Self {
        Faulty { true_one: self.true_one.with_inputs(inputs), ..*self }
    }
    fn set_inputs(prepared: &mut Self, inputs: Self::Inputs) {
        *prepared = prepared.with_inputs(inputs);
    }
    fn on<T: Scalar>(&self, convert: impl Fn(f64) -> T) -> Self::On<T> {
        self.kernels().on(convert)
    }
    fn initial(&self) -> Initial<Self::Q> {
        self.kernels().initial()
    }
    fn mass_matrix(&self, t: f64, q: &Self::Q) -> Self::QQ {
        self.kernels().mass_matrix(t, q)
    }
    fn convective_forces(&self, t: f64, q: &Self::Q, qd: &Self::Q) -> Self::Q {
        if self.fault != Fault::MixedDerivative {
            return self.moved().convective_forces(t, q, qd);
        }
        let alone = |k: usize| M::Q::from_fn(|i| if i == k { qd[i] } else { 0.0 });
        let forces: Vec<M::Q> = (0..M::Q::LEN).map(|k| self.true_one.convective_forces(t, q, &alone(k))).collect();
        M::Q::from_fn(|i| forces.iter().map(|force| force[i]).sum())
    }
    fn generalized_forces(&self, t: f64, q: &Self::Q, qd: &Self::Q) -> Self::Q {
        match self.fault {
            Fault::LostLoad(parameter) => self.with(parameter, |_| 0.0).generalized_forces(t, q, qd),
            _ => self.kernels().generalized_forces(t, q, qd),
        }
    }
    fn constraints(&self, t: f64, q: &Self::Q) -> Self::L {
        self.kernels().constraints(t, q)
    }
    fn constraint_magnitudes(&self, t: f64, q: &Self::Q) -> Self::L {
        self.kernels().constraint_magnitudes(t, q)
    }
    fn constraint_jacobian(&self, t: f64, q: &Self::Q) -> Self::LQ {
        self.kernels().constraint_jacobian(t, q)
    }
    fn constraint_time_derivative(&self, t: f64, q: &Self::Q) -> Self::L {
        self.kernels().constraint_time_derivative(t, q)
    }
    fn constraint_convective(&self, t: f64, q: &Self::Q, qd: &Self::Q) -> Self::L {
        if self.fault == Fault::LostConvective {
            return Self::L::filled(0.0);
        }
        self.kernels().constraint_convective(t, q, qd)
    }
    fn constraint_linearization(&self, t: f64, q: &Self::Q) -> ConstraintLinearization<Self::L, Self::LQ> {
        self.kernels().constraint_linearization(t, q)
    }
    fn kinetic_energy(&self, t: f64, q: &Self::Q, qd: &Self::Q) -> f64 {
        self.moved().kinetic_energy(t, q, qd)
    }
    fn prepare(&self) -> Self {
        *self
    }
    /// Where a smaller kernel is spoiled the elimination is refused, so that the runtime solves with that kernel.
    fn prepared_dynamics(prepared: &Self, t: f64, q: &Self::Q, qd: &Self::Q) -> Dynamics<f64, Self::Q, Self::L> {
        let mut dynamics = prepared.kernels().dynamics(t, q, qd);
        match prepared.fault {
            Fault::MultiplierSign => dynamics.multipliers[0] *= -1.0,
            Fault::HalfPower => dynamics.power *= 0.5,
            Fault::MixedDerivative | Fault::Frozen(_) | Fault::LostLoad(_) | Fault::LostConvective => {
                dynamics.refused = true;
            }
            _ => {}
        }
        dynamics
    }
    fn dynamics_jacobian(&self, t: f64, q: &Self::Q, qd: &Self::Q) -> DynamicsJacobian<f64, Self::QQ, Self::LQ> {
        let mut jacobian = self.kernels().dynamics_jacobian(t, q, qd);
        if self.fault == Fault::LostDerivative {
            jacobian.accelerations_by_positions[0][0] = 0.0;
        }
        jacobian
    }
    fn power(&self, t: f64, q: &Self::Q, qd: &Self::Q, qdd: &Self::Q, lambda: &Self::L) -> f64 {
        self.moved().power(t, q, qd, qdd, lambda)
    }
    fn outputs(&self, t: f64, q: &Self::Q, qd: &Self::Q, qdd: &Self::Q, lambda: &Self::L) -> Self::Outputs {
        let mut outputs = self.kernels().outputs(t, q, qd, qdd, lambda);
        if self.fault == Fault::SwappedOutputs {
            outputs.as_mut().swap(0, 1);
        }
        outputs
    }
    fn output_rates(&self, t: f64, q: &Self::Q, qd: &Self::Q, qdd: &Self::Q) -> Self::OutputRates {
        self.kernels().output_rates(t, q, qd, qdd)
    }
    fn events(&self, t: f64, q: &Self::Q, qd: &Self::Q, qdd: &Self::Q, lambda: &Self::L) -> Self::Events {
        self.kernels().events(t, q, qd, qdd, lambda)
    }
    fn activities(&self) -> Self::Activities {
        self.true_one.activities()
    }
    fn with_activities(self, activities: Self::Activities) -> Self {
        Faulty { true_one: self.true_one.with_activities(activities), ..self }
    }
    fn event_values(&self, t: f64, q: &Self::Q, qd: &Self::Q) -> Self::EventValues {
        self.kernels().event_values(t, q, qd)
    }
    fn load_conditions(&self, t: f64, q: &Self::Q, qd: &Self::Q) -> Self::LoadConditions {
        self.kernels().load_conditions(t, q, qd)
    }
    fn switching_functions(&self, t: f64) -> Self::SwitchingFunctions {
        self.kernels().switching_functions(t)
    }
    fn drawing(&self, t: f64, q: &Self::Q) -> Self::Drawing {
        self.kernels().drawing(t, q)
    }
}
