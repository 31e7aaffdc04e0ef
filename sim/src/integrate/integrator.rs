//! The methods that settings name.

use super::{Advance, DOPRI5, Dop853, EULER, ExplicitRungeKutta, HEUN, RK3, RK4, Radau5};
use crate::state::saved::{Bytes, Damaged};
use crate::state::settings::Method;
use sim_kernel::Mechanism;

/// One of the methods that settings name, with its memory of the last step.
#[derive(Clone, Debug)]
pub(crate) enum Integrator<M: Mechanism> {
    Explicit(ExplicitRungeKutta<M>),
    Dop853(Dop853<M>),
    Radau5(Radau5<M>),
}

impl<M: Mechanism> Integrator<M> {
    pub(crate) fn new(mechanism: &M, method: Method) -> Integrator<M> {
        let explicit = |tableau| Integrator::Explicit(ExplicitRungeKutta::new(mechanism, tableau));
        match method {
            Method::Euler => explicit(&EULER),
            Method::Heun => explicit(&HEUN),
            Method::Rk3 => explicit(&RK3),
            Method::Rk4 => explicit(&RK4),
            Method::Dopri5 => explicit(&DOPRI5),
            Method::Dop853 => Integrator::Dop853(Dop853::new(mechanism)),
            Method::Radau5 => Integrator::Radau5(Radau5::new(mechanism)),
        }
    }

    /// Its state between steps as bytes, or from them. The stages of an explicit method serve its last step alone.
    pub(crate) fn transfer(&mut self, bytes: &mut Bytes) -> Result<(), Damaged> {
        match self {
            Integrator::Explicit(_) | Integrator::Dop853(_) => Ok(()),
            Integrator::Radau5(method) => method.transfer(bytes),
        }
    }

    pub(crate) fn method(&mut self) -> &mut dyn Advance<M> {
        match self {
            Integrator::Explicit(method) => method,
            Integrator::Dop853(method) => method,
            Integrator::Radau5(method) => method,
        }
    }
}
