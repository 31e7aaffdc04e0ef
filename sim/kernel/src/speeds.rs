//! Motion in generalised speeds, for mechanisms that declare some.

use crate::{Array, FixedArray, Kinematics, Mechanism, Quantity, Scalar};

/// A mechanism whose declaration names generalised speeds u = W q' + w: its state is (q, u), which q' = N u + n and
/// Kane's equations for u' move. Norms of quaternions and constraints between speeds hold for every u.
///
/// k is the number of generalised speeds, r that of the constraints that are left. All quantities are in SI units.
pub trait GeneralizedSpeeds<S: Scalar = f64>: Mechanism<S> {
    /// Generalised speeds or their rates: k.
    type U: FixedArray<S>;
    /// Multipliers of the constraints that are left: r.
    type R: FixedArray<S>;

    /// The generalised speeds.
    const SPEEDS: &'static [Quantity];
    /// Which constraints are left, of the m.
    const ROWS: &'static [usize];

    /// u = W q' + w, k.
    fn generalized_speeds(&self, t: S, q: &Self::Q, qd: &Self::Q) -> Self::U;
    /// q' = N u + n.
    fn prepared_kinematics(prepared: &Self::Prepared, t: S, q: &Self::Q, u: &Self::U) -> Kinematics<S, Self::Q>;
    /// u' and the multipliers that are left.
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

/// [`Mechanism::velocity_variables`] where generalised speeds are declared.
#[inline(always)]
pub fn velocity_variables<S: Scalar, M: GeneralizedSpeeds<S>>(mechanism: &M, t: S, q: &M::Q, qd: &M::Q) -> M::Q {
    let speeds = mechanism.generalized_speeds(t, q, qd);
    qd.like(|i| if i < speeds.len() { speeds[i] } else { S::ZERO })
}

/// [`Mechanism::prepared_velocities`] where generalised speeds are declared.
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
    /// lambda of the constraints that are left, r.
    pub multipliers: R,
    /// Where this is true the planned elimination met a pivot that it refused, and nothing above holds.
    pub refused: S::Mask,
}
