//! The methods that settings name.

use super::tableau::{DOPRI5, EULER, HEUN, RK3, RK4, Tableau};
use super::{Advance, DOP853, Dop853, ExplicitRungeKutta, Radau5};
use crate::state::saved::{Bytes, Damaged};
use crate::state::settings::Method;
use sim_kernel::{Mechanism, Scalar};

/// The tableau of a method, if it is explicit.
pub(crate) fn tableau(method: Method) -> Option<&'static Tableau> {
    match method {
        Method::Euler => Some(&EULER),
        Method::Heun => Some(&HEUN),
        Method::Rk3 => Some(&RK3),
        Method::Rk4 => Some(&RK4),
        Method::Dopri5 => Some(&DOPRI5),
        Method::Dop853 => Some(&DOP853),
        Method::Radau5 => None,
    }
}

/// One of the methods that settings name, with its memory of the last step.
#[derive(Clone, Debug)]
pub(crate) enum Integrator<M: Mechanism> {
    Explicit(ExplicitRungeKutta<M>),
    Dop853(Dop853<M>),
    Radau5(Radau5<M>),
}

impl<M: Mechanism> Integrator<M> {
    pub(crate) fn new(mechanism: &M, method: Method) -> Integrator<M> {
        match (method, tableau(method)) {
            (Method::Dop853, _) => Integrator::Dop853(Dop853::new(mechanism)),
            (_, Some(tableau)) => Integrator::Explicit(ExplicitRungeKutta::new(mechanism, tableau)),
            (_, None) => Integrator::Radau5(Radau5::new(mechanism)),
        }
    }

    /// Takes the stages of a step that was made elsewhere, on other numbers: in each its number is found by `number`.
    pub(crate) fn take_stages<S: Scalar, N: Mechanism<S>>(
        &mut self,
        made: &ExplicitRungeKutta<N, S>,
        number: impl Fn(S) -> f64,
    ) {
        match self {
            Integrator::Dop853(method) => method.take_stages(made, number),
            Integrator::Explicit(method) if method.has_dense_output() => method.take_stages(made, number),
            // Others look into a step by its ends alone.
            Integrator::Explicit(_) | Integrator::Radau5(_) => {}
        }
    }

    /// Its state between steps as bytes, or from them. The stages of an explicit method serve its last step alone.
    pub(crate) fn transfer(&mut self, bytes: &mut Bytes) -> Result<(), Damaged> {
        match self {
            Integrator::Explicit(_) | Integrator::Dop853(_) => Ok(()),
            Integrator::Radau5(method) => method.transfer(bytes),
        }
    }

    /// As [`Advance`].
    pub(crate) fn method(&mut self) -> &mut dyn Advance<M> {
        match self {
            Integrator::Explicit(method) => method,
            Integrator::Dop853(method) => method,
            Integrator::Radau5(method) => method,
        }
    }
}
