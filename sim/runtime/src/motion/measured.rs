//! What is found of a mechanism at the start of a motion: its scales, degrees of freedom and masses.

use crate::motion::inertia::check_inertias;
use crate::motion::lengths;
use crate::motion::measures::Measures;
use crate::motion::mobility::{Mobility, check_masses_of, mobility_of};
use crate::motion::typed::Any;
use crate::state::failure::Failure;
use sim_kernel::Mechanism;

impl<M: Mechanism> Measures<M> {
    /// Those of a mechanism at a position on its constraints.
    pub fn at(mechanism: &M, time: f64, q: &M::Q) -> Measures<M> {
        Measures::with_mobility(mechanism, time, q, &mobility(mechanism, time, q))
    }

    /// Those after a change within a motion that has been measured.
    pub(crate) fn after(before: &Measures<M>, mechanism: &M, time: f64, q: &M::Q) -> Measures<M> {
        Measures::after_with_mobility(before, mechanism, (time, q), &mobility(mechanism, time, q))
    }

    /// The same with known degrees of freedom.
    pub(crate) fn after_with_mobility(
        before: &Measures<M>,
        mechanism: &M,
        (time, q): (f64, &M::Q),
        mobility: &Mobility,
    ) -> Measures<M> {
        Measures::with_mobility(mechanism, time, q, mobility).measuring_as(before, &Any(mechanism), (time, q))
    }

    /// Those of a mechanism at a position with known degrees of freedom.
    pub fn with_mobility(mechanism: &M, time: f64, q: &M::Q, mobility: &Mobility) -> Measures<M> {
        Measures::of(mechanism, &Any(mechanism), (time, q), mobility)
    }
}

/// Degrees of freedom and dependent constraints at a position, by orthogonalisation of the rows of C_q, in order. Rows
/// that depend on others there are checked at nearby positions too.
#[inline(never)]
pub fn mobility<M: Mechanism>(mechanism: &M, time: f64, q: &M::Q) -> Mobility {
    mobility_of(&Any(mechanism), time, q.as_ref())
}

/// The length that a mechanism is measured by, in metres, if anything tells it.
#[inline(never)]
pub(crate) fn known_length<M: Mechanism>(mechanism: &M, time: f64, q: &M::Q) -> Option<f64> {
    lengths::known_length(&Any(mechanism), time, q.as_ref())
}

/// Checks that no motion has negative kinetic energy: the mass matrix, constraints apart, has no negative eigenvalue.
///
/// # Errors
/// [`What::NegativeMass`](crate::What::NegativeMass), with the parameters that are negative.
#[inline(never)]
pub fn check_masses<M: Mechanism>(mechanism: &M, time: f64, q: &M::Q) -> Result<(), Failure> {
    check_masses_of(&Any(mechanism), time, q.as_ref())
}

/// Checks that bodies have masses and inertias that there are.
///
/// # Errors
/// As [`check_masses`] and [`check_inertias`].
#[inline(never)]
pub fn check_bodies<M: Mechanism>(mechanism: &M, time: f64, q: &M::Q) -> Result<(), Failure> {
    check_masses(mechanism, time, q)?;
    check_inertias(mechanism, time, q)
}
