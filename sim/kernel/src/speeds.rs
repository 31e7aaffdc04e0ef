//! Motion in generalised speeds, for mechanisms that declare some.

use crate::{Array, Compiled, FixedArray, Kinematics, Quantity, Scalar};

/// A mechanism whose declaration names generalised speeds u = W q' + w: its state is (q, u), governed by q' = N u + n
/// and Kane's equations for u'. Norms of quaternions and constraints between speeds hold for every u.
///
/// k is the number of generalised speeds, r that of the remaining constraints. All quantities are in SI units.
pub trait GeneralizedSpeeds<S: Scalar = f64>: Compiled<S> {
    /// Generalised speeds or their rates: k.
    type U: FixedArray<S>;
    /// Multipliers of the remaining constraints: r.
    type R: FixedArray<S>;

    /// The generalised speeds.
    const SPEEDS: &'static [Quantity];
    /// The remaining constraints, by index among the m.
    const ROWS: &'static [usize];

    /// u = W q' + w, k.
    fn generalized_speeds(&self, t: S, q: &Self::Q, qd: &Self::Q) -> Self::U;
    /// q' = N u + n.
    fn prepared_kinematics(prepared: &Self::Prepared, t: S, q: &Self::Q, u: &Self::U) -> Kinematics<S, Self::Q>;
    /// u' and the remaining multipliers.
    fn prepared_speed_dynamics(
        prepared: &Self::Prepared,
        t: S,
        q: &Self::Q,
        u: &Self::U,
    ) -> SpeedDynamics<S, Self::U, Self::R>;
    /// [`GeneralizedSpeeds::prepared_kinematics`] for one call.
    #[inline(always)]
    fn kinematics(&self, t: S, q: &Self::Q, u: &Self::U) -> Kinematics<S, Self::Q> {
        Self::prepared_kinematics(&self.prepare(), t, q, u)
    }
    /// [`GeneralizedSpeeds::prepared_speed_dynamics`] for one call.
    #[inline(always)]
    fn speed_dynamics(&self, t: S, q: &Self::Q, u: &Self::U) -> SpeedDynamics<S, Self::U, Self::R> {
        Self::prepared_speed_dynamics(&self.prepare(), t, q, u)
    }
}

/// [`crate::Mechanism::velocity_variables`] where generalised speeds are declared.
#[inline(always)]
pub fn velocity_variables<S: Scalar, M: GeneralizedSpeeds<S>>(mechanism: &M, t: S, q: &M::Q, qd: &M::Q) -> M::Q {
    let speeds = mechanism.generalized_speeds(t, q, qd);
    qd.like(|i| if i < speeds.len() { speeds[i] } else { S::ZERO })
}

/// [`crate::Mechanism::prepared_velocities`] where generalised speeds are declared.
#[inline(always)]
pub fn prepared_velocities<S: Scalar, M: GeneralizedSpeeds<S>>(
    prepared: &M::Prepared,
    t: S,
    q: &M::Q,
    v: &M::Q,
) -> Kinematics<S, M::Q> {
    M::prepared_kinematics(prepared, t, q, &M::U::with_len(M::SPEEDS.len(), |i| v[i]))
}

/// The equations of motion in generalised speeds, solved at one state.
#[derive(Clone, Copy, Debug)]
pub struct SpeedDynamics<S: Scalar, U, R> {
    /// u', k.
    pub rates: U,
    /// lambda of the remaining constraints, r.
    pub multipliers: R,
    /// If true, the planned elimination refused a pivot, and nothing above is valid.
    pub refused: S::Mask,
}
