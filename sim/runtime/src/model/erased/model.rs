//! A mechanism whose sizes are known at run time: its kernels on slices.

use super::each::{Results, States};
use crate::model::At;
use sim_kernel::{Description, Dual, Input, Interval, Scalar, Vectors};
use std::fmt::Debug;
use std::sync::Arc;

macro_rules! kernels {
    ($($(#[$about:meta])* $kernel:ident = $name:literal,)*) => {
        /// What a mechanism can be asked for, as the method of [`Mechanism`](sim_kernel::Mechanism) of the same name.
        #[derive(Clone, Copy, Debug, PartialEq, Eq)]
        pub enum Kernel {
            $($(#[$about])* $kernel,)*
        }

        impl Kernel {
            /// All of them.
            pub const ALL: &'static [Kernel] = &[$(Kernel::$kernel),*];

            /// Its name: that of the method.
            pub fn name(self) -> &'static str {
                match self {
                    $(Kernel::$kernel => $name,)*
                }
            }
        }
    };
}

kernels! {
    /// n rows of n.
    MassMatrix = "mass_matrix",
    /// As many rows as columns; none where the declaration does not request it.
    SpeedMassMatrix = "speed_mass_matrix",
    /// A row of n.
    ConvectiveForces = "convective_forces",
    /// A row of n.
    GeneralizedForces = "generalized_forces",
    /// A row of m.
    Constraints = "constraints",
    /// A row of m.
    ConstraintMagnitudes = "constraint_magnitudes",
    /// m rows of n.
    ConstraintJacobian = "constraint_jacobian",
    /// A row of m.
    ConstraintTimeDerivative = "constraint_time_derivative",
    /// A row of m.
    ConstraintConvective = "constraint_convective",
    /// C, C_t, and m rows of n.
    ConstraintLinearization = "constraint_linearization",
    /// C, C_t, and the entries of C_q.
    SparseLinearization = "sparse_linearization",
    /// A row of 1.
    KineticEnergy = "kinetic_energy",
    /// Accelerations, multipliers, and the power.
    Dynamics = "dynamics",
    /// A row of n.
    InverseDynamics = "inverse_dynamics",
    /// n rows by positions, n by speeds, then m and m of the multipliers, each of n.
    DynamicsJacobian = "dynamics_jacobian",
    /// n rows of accelerations and m of multipliers, each by the parameters.
    DynamicsSensitivity = "dynamics_sensitivity",
    /// A row of n.
    VelocityVariables = "velocity_variables",
    /// q' of velocity variables, which stand for the speeds: a row of n.
    Velocities = "velocities",
    /// A row of 1.
    Power = "power",
    /// A row of the outputs.
    Outputs = "outputs",
    /// A row of the rates of those that have one.
    OutputRates = "output_rates",
    /// A row of the events.
    Events = "events",
    /// A row of the values that actions need.
    EventValues = "event_values",
    /// A row of the functions of time alone where expressions change their form.
    SwitchingFunctions = "switching_functions",
    /// A row of the conditions of loads on positions and speeds.
    LoadConditions = "load_conditions",
    /// A row of the numbers of the drawing.
    Drawing = "drawing",
}

impl Kernel {
    /// Why a mechanism cannot be asked for it, if it was not requested and nothing gives it in its place.
    pub fn missing_in(self, description: &Description) -> Option<String> {
        let (name, mechanism) = (self.name(), description.name);
        if self == Kernel::SparseLinearization && description.sparsity.is_empty() {
            return Some(format!("`{mechanism}` has few constraints and no `{name}`; ask for `constraint_jacobian`"));
        }
        let is_missing = self == Kernel::SpeedMassMatrix && !description.optional_kernels.contains(&name);
        is_missing.then(|| format!("`{mechanism}` has no `{name}`; write `kernels {{ {name}; }}` in its declaration"))
    }
}

/// What may be set of a mechanism, in the order of declaration.
#[derive(Clone, Debug, PartialEq)]
pub struct Values<S = f64> {
    /// Parameters, in SI units.
    pub parameters: Vec<S>,
    /// Inputs.
    pub inputs: Vec<Input<S>>,
    /// For each constraint that events switch, 1 while it holds and 0 while it is released.
    pub activities: Vec<S>,
}

impl<S: Scalar> Values<S> {
    /// The same on other numbers.
    pub fn map<T: Scalar>(&self, convert: impl Fn(S) -> T) -> Values<T> {
        Values {
            parameters: self.parameters.iter().map(|value| convert(*value)).collect(),
            inputs: self.inputs.iter().map(|input| input.map(&convert)).collect(),
            activities: self.activities.iter().map(|value| convert(*value)).collect(),
        }
    }
}

/// Takes the rows of a result, by their index.
pub type Found<'f, S> = &'f mut dyn FnMut(usize, &[S]);

/// A mechanism with its type erased: its kernels on slices, whose lengths the description tells.
///
/// `mechanism!` makes one of every declaration ([`erase`](crate::erase)). [`Erased`](crate::Erased) runs it.
pub trait Model: Debug + Send + Sync {
    /// Names, units, documentation.
    fn description(&self) -> &'static Description;
    /// As [`Mechanism::rows_left`](sim_kernel::Mechanism::rows_left).
    fn rows_left(&self) -> Option<&'static [usize]>;
    /// Its parameters, inputs and activities.
    fn values(&self) -> Values;
    /// The same mechanism with other values.
    fn with_values(&self, values: &Values) -> Arc<dyn Model>;
    /// The same mechanism with the declared values.
    fn as_declared(&self) -> Arc<dyn Model>;
    /// The declared start: positions and speeds.
    fn initial(&self) -> [Vec<f64>; 2];
    /// The inputs as they are at a time, each held at its value there.
    fn held_inputs(&self, time: f64, q: &[f64]) -> Vec<Input>;
    /// Gives the rows of a kernel's result. True if the kernel refuses a pivot: the result is then not valid.
    fn call(&self, kernel: Kernel, at: At<f64>, found: Found<f64>) -> bool;
    /// A kernel's results at many states, with the bits of [`call`](Model::call).
    fn call_each(&self, kernel: Kernel, states: &States) -> Results {
        self.call_each_with(Vectors::widest(), kernel, states)
    }
    /// [`call_each`](Model::call_each) with chosen vector instructions, for measurements: all give the same bits. Kernels that are
    /// called state by state use none.
    fn call_each_with(&self, vectors: Vectors, kernel: Kernel, states: &States) -> Results;
    /// As [`call`](Model::call), on dual numbers, with these values in place of its own, for the kernels that analyses differentiate:
    /// the linearised constraints and their magnitudes, dynamics, velocities and their variables, outputs and their rates. It refuses others.
    fn call_on_duals(&self, values: &Values<Dual>, kernel: Kernel, at: At<Dual>, found: Found<Dual>) -> bool;
    /// As [`call`](Model::call), on intervals and their rates, for [`Kernel::SwitchingFunctions`]; it refuses others.
    fn call_on_intervals(&self, kernel: Kernel, at: At<Dual<Interval>>, found: Found<Dual<Interval>>) -> bool;
    /// Its equations of motion, with all that the parameters determine computed.
    fn prepare(&self) -> Box<dyn Prepared>;
}

/// The equations of motion of a model with given parameters.
pub trait Prepared: Debug + Send + Sync {
    /// A copy.
    fn copied(&self) -> Box<dyn Prepared>;
    /// Sets the inputs.
    fn set_inputs(&mut self, inputs: &[Input]);
    /// As [`Model::call`], for [`Kernel::Dynamics`] and [`Kernel::Velocities`].
    fn call(&self, kernel: Kernel, at: At<f64>, found: Found<f64>) -> bool;
}
