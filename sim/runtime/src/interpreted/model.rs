//! A mechanism whose programs are executed as they are.

use super::kernels::{Kernels, given, program};
use super::programs::Programs;
use crate::model::erased::{Found, Kernel, Model, Prepared, Results, States, Values, one_by_one};
use crate::model::{At, exactly};
use codegen::Derived;
use codegen::kernel_id::KernelId;
use sim_kernel::{Description, Dual, Input, Interval, Vectors};
use std::sync::Arc;

/// A mechanism made of a declaration at run time.
pub fn interpret(derived: &Derived) -> Arc<dyn Model> {
    declared(Arc::new(Programs::new(derived)))
}

/// With the declared values.
fn declared(programs: Arc<Programs>) -> Arc<dyn Model> {
    let Description { inputs, conditionals, .. } = programs.description;
    let values = Values {
        parameters: programs.defaults.clone(),
        inputs: vec![Input::Declared; inputs.len()],
        activities: conditionals.iter().map(|c| f64::from(u8::from(c.initially_active))).collect(),
    };
    Arc::new(Interpreted { programs, values })
}

#[derive(Debug)]
struct Interpreted {
    programs: Arc<Programs>,
    values: Values,
}

impl Interpreted {
    fn kernels(&self) -> Kernels<'_, f64> {
        Kernels { programs: &self.programs, values: &self.values }
    }
}

impl Model for Interpreted {
    fn description(&self) -> &'static Description {
        self.programs.description
    }
    fn rows_left(&self) -> Option<&'static [usize]> {
        self.programs.rows_left
    }
    fn values(&self) -> Values {
        self.values.clone()
    }
    fn with_values(&self, values: &Values) -> Arc<dyn Model> {
        Arc::new(Interpreted { programs: self.programs.clone(), values: values.clone() })
    }
    fn as_declared(&self) -> Arc<dyn Model> {
        declared(self.programs.clone())
    }
    fn initial(&self) -> [Vec<f64>; 2] {
        let mut positions = self.kernels().initial();
        let speeds = positions.split_off(positions.len() / 2);
        [positions, speeds]
    }
    fn held_inputs(&self, time: f64, q: &[f64]) -> Vec<Input> {
        self.kernels().inputs(At::moving(time, q, &[])).into_iter().map(Input::Held).collect()
    }
    fn call(&self, kernel: Kernel, at: At<f64>, found: Found<f64>) -> bool {
        let has_program = program(kernel).is_some_and(|id| self.programs.has(id));
        match kernel {
            Kernel::DynamicsJacobian if !has_program => self.kernels().jacobian(at, found),
            Kernel::DynamicsSensitivity if !has_program => self.kernels().sensitivity(at, found),
            _ => self.kernels().call(kernel, at, found),
        }
    }
    fn call_each_with(&self, vectors: Vectors, kernel: Kernel, states: &States) -> Results {
        let is_one = states.times.len() < 2;
        let of_many = if is_one { None } else { self.kernels().call_each(vectors, kernel, states) };
        of_many.unwrap_or_else(|| one_by_one(self, kernel, states))
    }
    fn call_on_duals(&self, values: &Values<Dual>, kernel: Kernel, at: At<Dual>, found: Found<Dual>) -> bool {
        Kernels { programs: &self.programs, values }.call(kernel, at, found)
    }
    fn call_on_intervals(&self, kernel: Kernel, at: At<Dual<Interval>>, found: Found<Dual<Interval>>) -> bool {
        let values = self.values.map(exactly);
        kernel != Kernel::SwitchingFunctions
            || Kernels { programs: &self.programs, values: &values }.call(kernel, at, found)
    }
    fn prepare(&self) -> Box<dyn Prepared> {
        let (programs, inputs) = (self.programs.clone(), self.values.inputs.clone());
        let values = self.kernels().prepare();
        let given = given(&programs, &inputs, &values, At::moving(0.0, &[], &[]));
        let [dynamics, velocities] =
            [KernelId::Dynamics, KernelId::Kinematics].map(|kernel| programs.image(kernel, &given));
        Box::new(InterpretedPrepared { programs, inputs, dynamics, velocities })
    }
}

/// The equations of motion with all that the parameters determine computed.
#[derive(Clone, Debug)]
struct InterpretedPrepared {
    programs: Arc<Programs>,
    inputs: Vec<Input>,
    /// What these kernels begin with.
    dynamics: Vec<f64>,
    velocities: Vec<f64>,
}

impl Prepared for InterpretedPrepared {
    fn copied(&self) -> Box<dyn Prepared> {
        Box::new(self.clone())
    }
    fn set_inputs(&mut self, inputs: &[Input]) {
        self.inputs.copy_from_slice(inputs);
    }
    fn call(&self, kernel: Kernel, at: At<f64>, found: Found<f64>) -> bool {
        let (id, image) = match kernel {
            Kernel::Velocities => (KernelId::Kinematics, &self.velocities),
            _ => (KernelId::Dynamics, &self.dynamics),
        };
        if !self.programs.has(id) {
            found(0, at.speeds);
            return false;
        }
        self.programs.call_from(id, image, &given(&self.programs, &self.inputs, &[], at), found)
    }
}
