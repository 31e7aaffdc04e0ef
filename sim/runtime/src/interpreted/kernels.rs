//! The kernels of a mechanism by its programs, and those that it has none for.

use super::execute::Given;
use super::programs::Programs;
use super::registers::Number;
use crate::model::At;
use crate::model::erased::{Found, Kernel, Results, States, Values};
use codegen::kernel_id::{KernelId, Receiver};
use sim_kernel::{Scalar, Vectors};

/// A mechanism with values, on numbers of any kind.
#[derive(Clone, Copy)]
pub(super) struct Kernels<'a, S> {
    pub(super) programs: &'a Programs,
    pub(super) values: &'a Values<S>,
}

impl<'a, S: Number> Kernels<'a, S> {
    /// What the equations of motion need of the parameters.
    pub(super) fn prepare(self) -> Vec<S> {
        self.programs.list(KernelId::Prepare, &self.given(&[], At::moving(S::ZERO, &[], &[])))
    }

    /// The declared start: positions, then speeds.
    pub(super) fn initial(self) -> Vec<S> {
        self.programs.list(KernelId::Initial, &self.given(&[], At::moving(S::ZERO, &[], &[])))
    }

    /// The values of the inputs at a place.
    pub(super) fn inputs(self, at: At<S>) -> Vec<S> {
        self.programs.list(KernelId::InputValues, &self.given(&[], at))
    }

    /// What programs read.
    fn given(self, prepared: &'a [S], at: At<'a, S>) -> Given<'a, S> {
        let Values { parameters, inputs, activities } = self.values;
        let (parameters, activities, inputs) = (&**parameters, &**activities, &**inputs);
        Given { parameters, activities, ..given(self.programs, inputs, prepared, at) }
    }

    /// Gives the rows of a kernel; true if it refuses a pivot.
    pub(super) fn call(self, kernel: Kernel, at: At<'a, S>, found: Found<S>) -> bool {
        let programs = self.programs;
        match program(kernel).filter(|id| programs.has(*id)) {
            Some(id) => {
                let prepared = self.prepared_for(id);
                let kernels = Kernels { programs, values: self.values };
                kernels.programs.call(id, &kernels.given(&prepared, at), found)
            }
            None => self.without_program(kernel, at, found),
        }
    }

    /// What a program reads of what is prepared.
    fn prepared_for(self, id: KernelId) -> Vec<S> {
        if id.signature().receiver == Receiver::Prepared { self.prepare() } else { Vec::new() }
    }

    /// What the trait of mechanisms does where there is no kernel.
    fn without_program(self, kernel: Kernel, at: At<S>, found: Found<S>) -> bool {
        match kernel {
            Kernel::SparseLinearization => {
                self.call(Kernel::ConstraintLinearization, at, &mut |row, numbers| {
                    if row < 2 {
                        found(row, numbers);
                    }
                });
                found(2, &[]);
            }
            Kernel::InverseDynamics => found(0, &self.inverse_dynamics(at)),
            Kernel::EventValues | Kernel::SwitchingFunctions | Kernel::LoadConditions => found(0, &[]),
            Kernel::SpeedMassMatrix => {}
            Kernel::VelocityVariables => found(0, &self.velocity_variables(at)),
            Kernel::Velocities => found(0, &self.speeds(at)),
            _ => return true,
        }
        false
    }

    /// M q'' + h - Q.
    fn inverse_dynamics(self, at: At<S>) -> Vec<S> {
        let row = |kernel| self.programs.list(kernel, &self.given(&[], at));
        let (mass, h) = (row(KernelId::MassMatrix), row(KernelId::ConvectiveForces));
        let (loads, n) = (row(KernelId::GeneralizedForces), self.n());
        let force = |i: usize| {
            let entries = mass[i * n..][..n].iter().zip(at.accelerations);
            let inertial = entries.fold(S::ZERO, |sum, (entry, acceleration)| sum + *entry * *acceleration);
            inertial + h[i] - loads[i]
        };
        (0..n).map(force).collect()
    }

    /// Generalised speeds, with zeros after them, or q'.
    fn velocity_variables(self, at: At<S>) -> Vec<S> {
        if !self.programs.has(KernelId::GeneralizedSpeeds) {
            return self.speeds(at);
        }
        let mut speeds = self.programs.list(KernelId::GeneralizedSpeeds, &self.given(&[], at));
        speeds.resize(self.n(), S::ZERO);
        speeds
    }

    /// q', zero if omitted.
    fn speeds(self, at: At<S>) -> Vec<S> {
        let mut speeds = at.speeds.to_vec();
        speeds.resize(self.n(), S::ZERO);
        speeds
    }

    pub(super) fn n(self) -> usize {
        self.programs.description.coordinates.len()
    }
}

impl Kernels<'_, f64> {
    /// A kernel's results at many states, if it has a program.
    pub(super) fn call_each(self, vectors: Vectors, kernel: Kernel, states: &States) -> Option<Results> {
        let id = program(kernel)?;
        let (prepared, programs) = (self.prepared_for(id), self.programs);
        let kernels = Kernels { programs, values: self.values };
        programs.call_each((vectors, id), &kernels.given(&prepared, At::moving(0.0, &[], &[])), states)
    }
}

/// What the programs of what is prepared read.
pub(super) fn given<'a, S: Scalar>(
    programs: &'a Programs,
    inputs: &'a [sim_kernel::Input<S>],
    prepared: &'a [S],
    at: At<'a, S>,
) -> Given<'a, S> {
    let At { time, positions, speeds, accelerations, multipliers } = at;
    Given {
        time,
        positions,
        speeds,
        accelerations,
        multipliers,
        // They stand in place of the speeds.
        generalized_speeds: speeds,
        prepared,
        ..Given::at_rest(inputs, programs.tables)
    }
}

/// The program of a kernel.
pub(super) fn program(kernel: Kernel) -> Option<KernelId> {
    Some(match kernel {
        Kernel::MassMatrix => KernelId::MassMatrix,
        Kernel::SpeedMassMatrix => KernelId::SpeedMassMatrix,
        Kernel::ConvectiveForces => KernelId::ConvectiveForces,
        Kernel::GeneralizedForces => KernelId::GeneralizedForces,
        Kernel::Constraints => KernelId::Constraints,
        Kernel::ConstraintMagnitudes => KernelId::ConstraintMagnitudes,
        Kernel::ConstraintJacobian => KernelId::ConstraintJacobian,
        Kernel::ConstraintTimeDerivative => KernelId::ConstraintTimeDerivative,
        Kernel::ConstraintConvective => KernelId::ConstraintConvective,
        Kernel::ConstraintLinearization => KernelId::ConstraintLinearization,
        Kernel::SparseLinearization => KernelId::SparseLinearization,
        Kernel::KineticEnergy => KernelId::KineticEnergy,
        Kernel::Dynamics => KernelId::Dynamics,
        Kernel::InverseDynamics => KernelId::InverseDynamics,
        Kernel::DynamicsJacobian => KernelId::DynamicsJacobian,
        Kernel::DynamicsSensitivity => KernelId::DynamicsSensitivity,
        Kernel::Velocities => KernelId::Kinematics,
        Kernel::Power => KernelId::Power,
        Kernel::Outputs => KernelId::Outputs,
        Kernel::OutputRates => KernelId::OutputRates,
        Kernel::Events => KernelId::Events,
        Kernel::EventValues => KernelId::EventValues,
        Kernel::SwitchingFunctions => KernelId::SwitchingFunctions,
        Kernel::LoadConditions => KernelId::LoadConditions,
        Kernel::Drawing => KernelId::Drawing,
        // Generalised speeds with zeros after them, or q'.
        Kernel::VelocityVariables => return None,
    })
}
