//! The residuals of constraints and of their rates.

use crate::motion::rows::{Dense, Linear, Rows};
use crate::state::failure::largest;
use crate::state::trajectory::State;
use sim_kernel::{Array, ConstraintLinearization, Mechanism, Scalar};

/// C_q q' + C_t.
#[inline]
pub fn rates<S: Scalar, M: Mechanism<S>>(
    mechanism: &M,
    linear: &ConstraintLinearization<M::L, M::LQ>,
    qd: &M::Q,
) -> M::L {
    rates_of::<S, M, Dense>(mechanism, linear, qd)
}

#[inline(always)]
pub(crate) fn rates_of<S: Scalar, M: Mechanism<S>, R: Rows<S, M>>(
    mechanism: &M,
    linear: &Linear<S, M, R>,
    qd: &M::Q,
) -> M::L {
    let along = R::times(mechanism, &linear.jacobian, qd);
    along.like(|i| along[i] + linear.time_derivative[i])
}

/// The largest magnitudes of C and of C_q q' + C_t at a state.
#[inline(never)]
pub fn residuals<M: Mechanism>(mechanism: &M, state: &State<M>) -> (f64, f64) {
    if mechanism.m() == 0 {
        return (0.0, 0.0);
    }
    let linear = mechanism.constraint_linearization(state.time, &state.positions);
    let rates = rates(mechanism, &linear, &state.speeds);
    let size = |values: &M::L| largest(values.iter()).map_or(0.0, |(_, value)| value.abs());
    (size(&linear.values), size(&rates))
}
