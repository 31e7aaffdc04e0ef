/// A ball that falls on a floor and bounces, each time to a lesser height.
///
/// The fields are its parameters, in SI units; the methods are its kernels.
///
/// # Equations of motion
///
/// ```text
/// [
///     mass_matrix, transpose(constraint_jacobian);
///     constraint_jacobian, 0
/// ] * [accelerations; multipliers] = [
///     generalized_forces - convective_forces;
///     -constraint_convective
/// ]
/// coordinates = [x; y]
/// multipliers = [lambda_floor]
/// constraints = 0
/// [
///     m, 0, 0;
///     0, m, floor_activity;
///     0, floor_activity, floor_activity - 1
/// ] * [x_ddot; y_ddot; lambda_floor] = [0; -m*g; 0]
///
/// mass_matrix = [m, 0; 0, m]
///
/// convective_forces = [0; 0]
///
/// generalized_forces = [0; -m*g]
///
/// constraints = [floor_activity*(y - r)]
///
/// constraint_jacobian = [0, floor_activity]
///
/// constraint_convective = [0]
/// ```
#[allow(non_snake_case)]
#[derive(
    ::core::clone::Clone,
    ::core::marker::Copy,
    ::core::fmt::Debug,
    ::core::cmp::PartialEq
)]
pub struct BouncingBall<S = ::core::primitive::f64> {
    /// In `kg`.
    pub m: S,
    /// Radius, in `m`.
    pub r: S,
    /// Height from which it falls, in `m`.
    pub h: S,
    /// The ratio of its speeds after and before an impact, in `1`.
    pub rebound: S,
    /// Its speed along the floor, in `m/s`.
    pub v: S,
    /// In `m/s^2`.
    pub g: S,
    /// Whether constraint `floor` holds: 1, or 0 where it is released.
    pub floor_activity: S,
}
impl<S: sim_kernel::Scalar> ::core::default::Default for BouncingBall<S> {
    /// The declared values.
    fn default() -> Self {
        <Self as sim_kernel::Compiled<S>>::defaults()
    }
}
/// Coordinates of [`BouncingBall`] by name, in SI units; also for their speeds and accelerations.
#[allow(non_snake_case)]
#[derive(
    ::core::clone::Clone,
    ::core::marker::Copy,
    ::core::fmt::Debug,
    ::core::cmp::PartialEq
)]
pub struct BouncingBallCoordinates<S = ::core::primitive::f64> {
    /// How far it has rolled, in `m`.
    pub x: S,
    /// Height of its centre above the floor, in `m`.
    pub y: S,
}
impl<S: sim_kernel::Scalar> ::core::convert::From<[S; 2]>
for BouncingBallCoordinates<S> {
    fn from(values: [S; 2]) -> Self {
        Self { x: values[0], y: values[1] }
    }
}
impl<S: sim_kernel::Scalar> ::core::convert::From<BouncingBallCoordinates<S>>
for [S; 2] {
    fn from(record: BouncingBallCoordinates<S>) -> Self {
        [record.x, record.y]
    }
}
/// Outputs of [`BouncingBall`] by name, in SI units.
#[allow(non_snake_case)]
#[derive(
    ::core::clone::Clone,
    ::core::marker::Copy,
    ::core::fmt::Debug,
    ::core::cmp::PartialEq
)]
pub struct BouncingBallOutputs<S = ::core::primitive::f64> {
    /// Height of the ball above the floor, in `m`.
    pub height: S,
    /// Speed upwards, in `m/s`.
    pub climb: S,
    /// Kinetic and potential energy, in `J`.
    pub energy: S,
}
impl<S: sim_kernel::Scalar> ::core::convert::From<[S; 3]> for BouncingBallOutputs<S> {
    fn from(values: [S; 3]) -> Self {
        Self {
            height: values[0],
            climb: values[1],
            energy: values[2],
        }
    }
}
impl<S: sim_kernel::Scalar> ::core::convert::From<BouncingBallOutputs<S>> for [S; 3] {
    fn from(record: BouncingBallOutputs<S>) -> Self {
        [record.height, record.climb, record.energy]
    }
}
/// Rates of the outputs of [`BouncingBall`] by name, in SI units.
#[allow(non_snake_case)]
#[derive(
    ::core::clone::Clone,
    ::core::marker::Copy,
    ::core::fmt::Debug,
    ::core::cmp::PartialEq
)]
pub struct BouncingBallOutputRates<S = ::core::primitive::f64> {
    /// Rate of `height`.
    pub height: S,
    /// Rate of `climb`.
    pub climb: S,
    /// Rate of `energy`.
    pub energy: S,
}
impl<S: sim_kernel::Scalar> ::core::convert::From<[S; 3]>
for BouncingBallOutputRates<S> {
    fn from(values: [S; 3]) -> Self {
        Self {
            height: values[0],
            climb: values[1],
            energy: values[2],
        }
    }
}
impl<S: sim_kernel::Scalar> ::core::convert::From<BouncingBallOutputRates<S>>
for [S; 3] {
    fn from(record: BouncingBallOutputRates<S>) -> Self {
        [record.height, record.climb, record.energy]
    }
}
/// What the equations of motion need of the parameters of [`BouncingBall`], from [`BouncingBall::prepare`]; its methods are the kernels of each step.
#[allow(non_snake_case)]
#[derive(
    ::core::clone::Clone,
    ::core::marker::Copy,
    ::core::fmt::Debug,
    ::core::cmp::PartialEq
)]
pub struct BouncingBallPrepared<S = ::core::primitive::f64> {
    m: S,
    minus_rhs_y: S,
    minus_pivot_lambda_floor: S,
    pivot_lambda_floor: S,
    lambda_floor: S,
    y_ddot: S,
}
#[allow(non_snake_case, unused_variables, unused_parens, clippy::all, clippy::pedantic)]
impl<S: sim_kernel::Scalar> BouncingBall<S> {
    /// What the equations of motion need of the parameters, computed once for a set of parameters.
    ///
    /// Operations: 5 additions, 7 multiplications, 2 divisions.
    #[inline]
    pub fn prepare(&self) -> BouncingBallPrepared<S> {
        let w = self.m * self.g;
        let inverse_m = S::from_f64(1.0) / self.m;
        let w_2 = self.floor_activity * inverse_m;
        let w_3 = S::from_f64(1.0) - self.floor_activity + self.floor_activity * w_2;
        let w_4 = S::from_f64(1.0) / w_3 * w * w_2;
        BouncingBallPrepared {
            m: self.m,
            minus_rhs_y: w,
            minus_pivot_lambda_floor: w_3,
            pivot_lambda_floor: -w_3,
            lambda_floor: -w_4,
            y_ddot: w_2 * w_4 - w * inverse_m,
        }
    }
    /// Mass matrix `T_q' M T_q`, 2 x 2, symmetric, in SI units.
    ///
    /// Operations: none.
    #[inline]
    pub fn mass_matrix(&self, t: S, q: &[S; 2]) -> [[S; 2]; 2] {
        [[self.m, S::from_f64(0.0)], [S::from_f64(0.0), self.m]]
    }
    /// Convective forces `T_q' M g`, 2, with `g = (T_q q' + T_t)_q q' + (..)_t`: joules per unit of each coordinate.
    ///
    /// Operations: none.
    #[inline]
    pub fn convective_forces(&self, t: S, q: &[S; 2], qd: &[S; 2]) -> [S; 2] {
        [S::from_f64(0.0), S::from_f64(0.0)]
    }
    /// Generalised forces `T_q' F`, 2: joules per unit of each coordinate.
    ///
    /// Operations: 1 addition, 1 multiplication.
    #[inline]
    pub fn generalized_forces(&self, t: S, q: &[S; 2], qd: &[S; 2]) -> [S; 2] {
        [S::from_f64(0.0), -(self.m * self.g)]
    }
    /// Constraints `C`, 1, in SI units; zero throughout the motion.
    ///
    /// Operations: 1 addition, 1 multiplication.
    #[inline]
    pub fn constraints(&self, t: S, q: &[S; 2]) -> [S; 1] {
        let [_, y] = *q;
        [(y - self.r) * self.floor_activity]
    }
    /// The sum of the magnitudes of the terms of `C`, 1, in SI units: what its rounding is relative to.
    ///
    /// Operations: 3 additions.
    #[inline]
    pub fn constraint_magnitudes(&self, t: S, q: &[S; 2]) -> [S; 1] {
        let [_, y] = *q;
        [y.abs() + self.r.abs()]
    }
    /// Constraint Jacobian `C_q`, 1 x 2: units of each constraint per unit of each coordinate.
    ///
    /// Operations: none.
    #[inline]
    pub fn constraint_jacobian(&self, t: S, q: &[S; 2]) -> [[S; 2]; 1] {
        [[S::from_f64(0.0), self.floor_activity]]
    }
    /// `C_t`, 1, units of `C` per second: the speeds obey `C_q q' + C_t = 0`.
    ///
    /// Operations: none.
    #[inline]
    pub fn constraint_time_derivative(&self, t: S, q: &[S; 2]) -> [S; 1] {
        [S::from_f64(0.0)]
    }
    /// `(C_q q' + C_t)_q q' + (..)_t`, 1, units of `C` per second squared: the part of `C''` without accelerations.
    ///
    /// Operations: none.
    #[inline]
    pub fn constraint_convective(&self, t: S, q: &[S; 2], qd: &[S; 2]) -> [S; 1] {
        [S::from_f64(0.0)]
    }
    /// `C` (1), `C_q` (1 x 2) and `C_t` (1) together, in SI units, for projection.
    ///
    /// Operations: 1 addition, 1 multiplication.
    #[inline]
    pub fn constraint_linearization(
        &self,
        t: S,
        q: &[S; 2],
    ) -> sim_kernel::ConstraintLinearization<[S; 1], [[S; 2]; 1]> {
        let [_, y] = *q;
        sim_kernel::ConstraintLinearization {
            values: [(y - self.r) * self.floor_activity],
            jacobian: [[S::from_f64(0.0), self.floor_activity]],
            time_derivative: [S::from_f64(0.0)],
        }
    }
    /// Kinetic energy `v' M v / 2`, in joules.
    ///
    /// Operations: 1 addition, 4 multiplications.
    #[inline]
    pub fn kinetic_energy(&self, t: S, q: &[S; 2], qd: &[S; 2]) -> S {
        let [x_dot, y_dot] = *qd;
        S::from_f64(0.5) * self.m * (x_dot * x_dot + y_dot * y_dot)
    }
    /// Power of loads and drives, `F' v + lambda' C_t + T_t' (M x'' - F)`, in watts.
    ///
    /// Operations: 1 addition, 2 multiplications.
    #[inline]
    pub fn power(
        &self,
        t: S,
        q: &[S; 2],
        qd: &[S; 2],
        qdd: &[S; 2],
        lambda: &[S; 1],
    ) -> S {
        let [_, y_dot] = *qd;
        -(y_dot * self.m * self.g)
    }
    /// Outputs, 3, in SI units.
    ///
    /// Operations: 3 additions, 6 multiplications.
    #[inline]
    pub fn outputs(
        &self,
        t: S,
        q: &[S; 2],
        qd: &[S; 2],
        qdd: &[S; 2],
        lambda: &[S; 1],
    ) -> BouncingBallOutputs<S> {
        let [_, y] = *q;
        let [x_dot, y_dot] = *qd;
        let w = y - self.r;
        [
            w,
            y_dot,
            (x_dot * x_dot + y_dot * y_dot) * S::from_f64(0.5) * self.m
                + w * self.m * self.g,
        ]
            .into()
    }
    /// Rates of the outputs that depend on neither accelerations nor multipliers, 3, in SI units per second.
    ///
    /// Operations: 2 additions, 5 multiplications.
    #[inline]
    pub fn output_rates(
        &self,
        t: S,
        q: &[S; 2],
        qd: &[S; 2],
        qdd: &[S; 2],
    ) -> BouncingBallOutputRates<S> {
        let [x_dot, y_dot] = *qd;
        let [x_ddot, y_ddot] = *qdd;
        [
            y_dot,
            y_ddot,
            y_dot * self.m * self.g + self.m * (x_dot * x_ddot + y_dot * y_ddot),
        ]
            .into()
    }
    /// `left - right` of each event, 2, in SI units: zero when it happens.
    ///
    /// Operations: 1 addition.
    #[inline]
    pub fn events(
        &self,
        t: S,
        q: &[S; 2],
        qd: &[S; 2],
        qdd: &[S; 2],
        lambda: &[S; 1],
    ) -> [S; 2] {
        let [_, y] = *q;
        let [_, y_dot] = *qd;
        [y - self.r, y_dot]
    }
    /// The numbers of each shape of the drawing, in metres and radians.
    ///
    /// Operations: 1 addition.
    #[inline]
    pub fn drawing(&self, t: S, q: &[S; 2]) -> [S; 7] {
        let [x, y] = *q;
        [
            -S::from_f64(0.2),
            S::from_f64(0.0),
            S::from_f64(2.0),
            S::from_f64(0.0),
            x,
            y,
            self.r,
        ]
    }
    /// Declared start: values or guesses of the coordinates (2), and speeds (2), in SI units; 0 where nothing is declared.
    ///
    /// Operations: 1 addition.
    #[inline]
    pub fn initial(&self) -> sim_kernel::Initial<[S; 2]> {
        sim_kernel::Initial {
            positions: [S::from_f64(0.0), self.r + self.h],
            speeds: [self.v, S::from_f64(0.0)],
        }
    }
    /// What the actions of events set, and the coefficients of restitution of impacts, 1, in SI units, in the order of declaration.
    ///
    /// Operations: none.
    #[inline]
    pub fn event_values(&self, t: S, q: &[S; 2], qd: &[S; 2]) -> [S; 1] {
        [self.rebound]
    }
    /// [`BouncingBallPrepared::dynamics`] once; for many calls with the same parameters [`Self::prepare`] first.
    #[inline]
    pub fn dynamics(
        &self,
        t: S,
        q: &[S; 2],
        qd: &[S; 2],
    ) -> sim_kernel::Dynamics<S, [S; 2], [S; 1]> {
        self.prepare().dynamics(t, q, qd)
    }
    /// [`BouncingBallPrepared::dynamics_jacobian`] once; for many calls with the same parameters [`Self::prepare`] first.
    #[inline]
    pub fn dynamics_jacobian(
        &self,
        t: S,
        q: &[S; 2],
        qd: &[S; 2],
    ) -> sim_kernel::DynamicsJacobian<S, [[S; 2]; 2], [[S; 2]; 1]> {
        self.prepare().dynamics_jacobian(t, q, qd)
    }
}
#[allow(non_snake_case, unused_variables, unused_parens, clippy::all, clippy::pedantic)]
impl<S: sim_kernel::Scalar> BouncingBallPrepared<S> {
    /// Accelerations (2), multipliers (1) and power, from
    ///
    /// ```text
    /// [ T_q' M T_q   C_q' ] [ q''    ]   [ T_q' (F - M g)                      ]
    /// [ C_q          0    ] [ lambda ] = [ -(C_q q' + C_t)_q q' - (..)_t       ]
    /// ```
    ///
    /// by an elimination planned from the structure of the system. Where `refused` is set a pivot was too small and nothing else holds: solve that state from the other kernels.
    ///
    /// Operations: 1 addition, 1 multiplication.
    #[inline(always)]
    pub fn dynamics(
        &self,
        t: S,
        q: &[S; 2],
        qd: &[S; 2],
    ) -> sim_kernel::Dynamics<S, [S; 2], [S; 1]> {
        let [_, y_dot] = *qd;
        sim_kernel::Dynamics {
            accelerations: [S::from_f64(0.0), self.y_ddot],
            multipliers: [self.lambda_floor],
            power: -(self.minus_rhs_y * y_dot),
            refused: sim_kernel::pivot_is_refused(self.m, self.m)
                | sim_kernel::pivot_is_refused(self.m, self.m)
                | sim_kernel::pivot_is_refused(
                    self.pivot_lambda_floor,
                    self.minus_pivot_lambda_floor,
                ),
        }
    }
    /// The derivatives of accelerations (2 rows) and multipliers (1 rows) with respect to coordinates and speeds (2 columns each): with the equations of motion as `K z = r`, the solutions of `K dz = dr - dK z`. Where `refused` is set a pivot was too small and nothing else holds.
    ///
    /// Operations: none.
    #[inline]
    pub fn dynamics_jacobian(
        &self,
        t: S,
        q: &[S; 2],
        qd: &[S; 2],
    ) -> sim_kernel::DynamicsJacobian<S, [[S; 2]; 2], [[S; 2]; 1]> {
        sim_kernel::DynamicsJacobian {
            accelerations_by_positions: [
                [S::from_f64(0.0), S::from_f64(0.0)],
                [S::from_f64(0.0), S::from_f64(0.0)],
            ],
            accelerations_by_speeds: [
                [S::from_f64(0.0), S::from_f64(0.0)],
                [S::from_f64(0.0), S::from_f64(0.0)],
            ],
            multipliers_by_positions: [[S::from_f64(0.0), S::from_f64(0.0)]],
            multipliers_by_speeds: [[S::from_f64(0.0), S::from_f64(0.0)]],
            refused: sim_kernel::pivot_is_refused(self.m, self.m)
                | sim_kernel::pivot_is_refused(self.m, self.m)
                | sim_kernel::pivot_is_refused(
                    self.pivot_lambda_floor,
                    self.minus_pivot_lambda_floor,
                ),
        }
    }
}
#[allow(non_snake_case, unused_variables, clippy::all, clippy::pedantic)]
impl<S: sim_kernel::Scalar> sim_kernel::Mechanism<S> for BouncingBall<S> {
    type Q = [S; 2];
    type L = [S; 1];
    type Z = [S; 3];
    type QQ = [[S; 2]; 2];
    type V = [S; 0];
    type VV = [[S; 0]; 0];
    type LQ = [[S; 2]; 1];
    type LL = [[S; 1]; 1];
    type ZZ = [[S; 3]; 3];
    type Entries = [S; 0];
    type Envelope = [S; 0];
    type Parameters = [S; 6];
    type Outputs = [S; 3];
    type OutputRates = [S; 3];
    type Events = [S; 2];
    type EventValues = [S; 1];
    type SwitchingFunctions = [S; 0];
    type LoadConditions = [S; 0];
    type Activities = [S; 1];
    type Drawing = [S; 7];
    type QP = [[S; 6]; 2];
    type LP = [[S; 6]; 1];
    type Inputs = [sim_kernel::Input<S>; 0];
    type Prepared = BouncingBallPrepared<S>;
    type On<T: sim_kernel::Scalar> = BouncingBall<T>;
    #[inline(always)]
    fn description(&self) -> &'static sim_kernel::Description {
        const { &<Self as sim_kernel::Compiled<S>>::DESCRIPTION }
    }
    fn as_declared(&self) -> Self {
        <Self as sim_kernel::Compiled<S>>::defaults()
    }
    fn parameters(&self) -> [S; 6] {
        [self.m, self.r, self.h, self.rebound, self.v, self.g]
    }
    fn with_parameters(&self, parameters: [S; 6]) -> Self {
        Self {
            m: parameters[0],
            r: parameters[1],
            h: parameters[2],
            rebound: parameters[3],
            v: parameters[4],
            g: parameters[5],
            ..*self
        }
    }
    fn on<T: sim_kernel::Scalar>(
        &self,
        convert: impl ::core::ops::Fn(S) -> T,
    ) -> BouncingBall<T> {
        BouncingBall {
            m: convert(self.m),
            r: convert(self.r),
            h: convert(self.h),
            rebound: convert(self.rebound),
            v: convert(self.v),
            g: convert(self.g),
            floor_activity: convert(self.floor_activity),
        }
    }
    fn inputs(&self) -> [sim_kernel::Input<S>; 0] {
        []
    }
    fn with_inputs(&self, inputs: [sim_kernel::Input<S>; 0]) -> Self {
        Self { ..*self }
    }
    fn set_inputs(prepared: &mut Self::Prepared, inputs: [sim_kernel::Input<S>; 0]) {}
    fn activities(&self) -> [S; 1] {
        [self.floor_activity]
    }
    fn with_activities(self, activities: [S; 1]) -> Self {
        Self {
            floor_activity: activities[0],
            ..self
        }
    }
    #[inline(always)]
    fn prepare(&self) -> BouncingBallPrepared<S> {
        self.prepare()
    }
    #[inline(always)]
    fn prepared_dynamics(
        prepared: &Self::Prepared,
        t: S,
        q: &[S; 2],
        qd: &[S; 2],
    ) -> sim_kernel::Dynamics<S, [S; 2], [S; 1]> {
        prepared.dynamics(t, q, qd)
    }
    #[inline(always)]
    fn dynamics_jacobian(
        &self,
        t: S,
        q: &[S; 2],
        qd: &[S; 2],
    ) -> sim_kernel::DynamicsJacobian<S, [[S; 2]; 2], [[S; 2]; 1]> {
        self.prepare().dynamics_jacobian(t, q, qd)
    }
    #[inline(always)]
    fn mass_matrix(&self, t: S, q: &[S; 2]) -> [[S; 2]; 2] {
        self.mass_matrix(t, q)
    }
    #[inline(always)]
    fn convective_forces(&self, t: S, q: &[S; 2], qd: &[S; 2]) -> [S; 2] {
        self.convective_forces(t, q, qd)
    }
    #[inline(always)]
    fn generalized_forces(&self, t: S, q: &[S; 2], qd: &[S; 2]) -> [S; 2] {
        self.generalized_forces(t, q, qd)
    }
    #[inline(always)]
    fn constraints(&self, t: S, q: &[S; 2]) -> [S; 1] {
        self.constraints(t, q)
    }
    #[inline(always)]
    fn constraint_magnitudes(&self, t: S, q: &[S; 2]) -> [S; 1] {
        self.constraint_magnitudes(t, q)
    }
    #[inline(always)]
    fn constraint_jacobian(&self, t: S, q: &[S; 2]) -> [[S; 2]; 1] {
        self.constraint_jacobian(t, q)
    }
    #[inline(always)]
    fn constraint_time_derivative(&self, t: S, q: &[S; 2]) -> [S; 1] {
        self.constraint_time_derivative(t, q)
    }
    #[inline(always)]
    fn constraint_convective(&self, t: S, q: &[S; 2], qd: &[S; 2]) -> [S; 1] {
        self.constraint_convective(t, q, qd)
    }
    #[inline(always)]
    fn constraint_linearization(
        &self,
        t: S,
        q: &[S; 2],
    ) -> sim_kernel::ConstraintLinearization<[S; 1], [[S; 2]; 1]> {
        self.constraint_linearization(t, q)
    }
    #[inline(always)]
    fn kinetic_energy(&self, t: S, q: &[S; 2], qd: &[S; 2]) -> S {
        self.kinetic_energy(t, q, qd)
    }
    #[inline(always)]
    fn power(&self, t: S, q: &[S; 2], qd: &[S; 2], qdd: &[S; 2], lambda: &[S; 1]) -> S {
        self.power(t, q, qd, qdd, lambda)
    }
    #[inline(always)]
    fn outputs(
        &self,
        t: S,
        q: &[S; 2],
        qd: &[S; 2],
        qdd: &[S; 2],
        lambda: &[S; 1],
    ) -> [S; 3] {
        self.outputs(t, q, qd, qdd, lambda).into()
    }
    #[inline(always)]
    fn output_rates(&self, t: S, q: &[S; 2], qd: &[S; 2], qdd: &[S; 2]) -> [S; 3] {
        self.output_rates(t, q, qd, qdd).into()
    }
    #[inline(always)]
    fn events(
        &self,
        t: S,
        q: &[S; 2],
        qd: &[S; 2],
        qdd: &[S; 2],
        lambda: &[S; 1],
    ) -> [S; 2] {
        self.events(t, q, qd, qdd, lambda)
    }
    #[inline(always)]
    fn drawing(&self, t: S, q: &[S; 2]) -> [S; 7] {
        self.drawing(t, q)
    }
    #[inline(always)]
    fn initial(&self) -> sim_kernel::Initial<[S; 2]> {
        self.initial()
    }
    #[inline(always)]
    fn event_values(&self, t: S, q: &[S; 2], qd: &[S; 2]) -> [S; 1] {
        self.event_values(t, q, qd)
    }
}
#[allow(clippy::all, clippy::pedantic)]
impl<S: sim_kernel::Scalar> sim_kernel::Compiled<S> for BouncingBall<S> {
    const DESCRIPTION: sim_kernel::Description = sim_kernel::Description {
        name: "bouncing-ball",
        type_name: "BouncingBall",
        docs: "A ball that falls on a floor and bounces, each time to a lesser height.",
        declaration: "/// A ball that falls on a floor and bounces, each time to a lesser height.\npub BouncingBall;\n\ncoordinates {\n    /// How far it has rolled.\n    x [m];\n    /// Height of its centre above the floor.\n    y [m];\n}\n\nparameters {\n    m [kg] = 0.06;\n    /// Radius.\n    r [m] = 0.033;\n    /// Height from which it falls.\n    h [m] = 1;\n    /// The ratio of its speeds after and before an impact.\n    rebound = 0.9;\n    /// Its speed along the floor.\n    v [m/s] = 0.4;\n    g [m/s^2] = 9.81;\n}\n\nlet P = [x, y];\n\nbodies { ball: mass m at P; }\nloads { gravity [0, -g]; }\nconstraints {\n    /// It holds for the instant of an impact.\n    floor: P.y = r initially released;\n}\ninitial { x = 0; y = r + h; dot(x) = v; dot(y) = 0; }\n\nevents {\n    /// The ball meets the floor.\n    landing: P.y = r falling { impact floor restitution rebound; }\n    /// It is at its highest.\n    top: dot(P.y) = 0 falling;\n}\n\noutputs {\n    /// Height of the ball above the floor\n    height [m] = P.y - r;\n    /// Speed upwards\n    climb [m/s] = dot(P.y);\n    /// Kinetic and potential energy\n    energy [J] = m*inner(dot(P), dot(P))/2 + m*g*(P.y - r);\n}\n\ndrawing {\n    curve [-0.2 [m], 0], [2 [m], 0];\n    circle P radius r;\n}\n",
        declaration_hash: "8f22326163e0882b3fe6343a9abd0306",
        coordinates: &[
            sim_kernel::Coordinate {
                position: sim_kernel::Quantity {
                    name: "x",
                    unit: "m",
                    factor: 1f64,
                    is_length: true,
                    docs: "How far it has rolled.",
                },
                speed: sim_kernel::Quantity {
                    name: "x_dot",
                    unit: "m/s",
                    factor: 1f64,
                    is_length: false,
                    docs: "",
                },
                acceleration: sim_kernel::Quantity {
                    name: "x_ddot",
                    unit: "m/s^2",
                    factor: 1f64,
                    is_length: false,
                    docs: "",
                },
                start: sim_kernel::Start::Given,
                speed_given: true,
            },
            sim_kernel::Coordinate {
                position: sim_kernel::Quantity {
                    name: "y",
                    unit: "m",
                    factor: 1f64,
                    is_length: true,
                    docs: "Height of its centre above the floor.",
                },
                speed: sim_kernel::Quantity {
                    name: "y_dot",
                    unit: "m/s",
                    factor: 1f64,
                    is_length: false,
                    docs: "",
                },
                acceleration: sim_kernel::Quantity {
                    name: "y_ddot",
                    unit: "m/s^2",
                    factor: 1f64,
                    is_length: false,
                    docs: "",
                },
                start: sim_kernel::Start::Given,
                speed_given: true,
            },
        ],
        mixes_lengths: false,
        parameters: &[
            sim_kernel::Quantity {
                name: "m",
                unit: "kg",
                factor: 1f64,
                is_length: false,
                docs: "",
            },
            sim_kernel::Quantity {
                name: "r",
                unit: "m",
                factor: 1f64,
                is_length: true,
                docs: "Radius.",
            },
            sim_kernel::Quantity {
                name: "h",
                unit: "m",
                factor: 1f64,
                is_length: true,
                docs: "Height from which it falls.",
            },
            sim_kernel::Quantity {
                name: "rebound",
                unit: "1",
                factor: 1f64,
                is_length: false,
                docs: "The ratio of its speeds after and before an impact.",
            },
            sim_kernel::Quantity {
                name: "v",
                unit: "m/s",
                factor: 1f64,
                is_length: false,
                docs: "Its speed along the floor.",
            },
            sim_kernel::Quantity {
                name: "g",
                unit: "m/s^2",
                factor: 1f64,
                is_length: false,
                docs: "",
            },
        ],
        inputs: &[],
        constraints: &[
            sim_kernel::Quantity {
                name: "floor",
                unit: "N",
                factor: 1f64,
                is_length: false,
                docs: "",
            },
        ],
        speed_constraints: &[],
        norm_constraints: &[],
        sparsity: &[],
        common_column: ::core::option::Option::None,
        conditionals: &[
            sim_kernel::event::Conditional {
                name: "floor",
                first_row: 0,
                rows: 1,
                initially_active: false,
            },
        ],
        events: &[
            sim_kernel::event::Event {
                name: "landing",
                direction: sim_kernel::event::Direction::Falling,
                on_motion: true,
                on_forces: false,
                steps: &[
                    sim_kernel::event::Step::Impact(
                        &[
                            sim_kernel::event::Hit {
                                conditional: 0,
                                restitution: 0,
                            },
                        ],
                    ),
                ],
            },
            sim_kernel::event::Event {
                name: "top",
                direction: sim_kernel::event::Direction::Falling,
                on_motion: true,
                on_forces: false,
                steps: &[],
            },
        ],
        outputs: &[
            sim_kernel::Quantity {
                name: "height",
                unit: "m",
                factor: 1f64,
                is_length: true,
                docs: "Height of the ball above the floor",
            },
            sim_kernel::Quantity {
                name: "climb",
                unit: "m/s",
                factor: 1f64,
                is_length: false,
                docs: "Speed upwards",
            },
            sim_kernel::Quantity {
                name: "energy",
                unit: "J",
                factor: 1f64,
                is_length: false,
                docs: "Kinetic and potential energy",
            },
        ],
        rated_outputs: &[0, 1, 2],
        figures: &[
            sim_kernel::Figure {
                name: "height",
                title: "Height of the ball above the floor",
                len: 1,
            },
            sim_kernel::Figure {
                name: "climb",
                title: "Speed upwards",
                len: 1,
            },
            sim_kernel::Figure {
                name: "energy",
                title: "Kinetic and potential energy",
                len: 1,
            },
        ],
        optional_kernels: &["dynamics_jacobian"],
        dimension: 2,
        drawing: &[sim_kernel::Shape::Curve(2), sim_kernel::Shape::Circle],
        run: &[],
        switching: &[],
        load_conditions: &[],
    };
    fn defaults() -> Self {
        Self {
            m: S::from_f64(0.06f64),
            r: S::from_f64(0.033f64),
            h: S::from_f64(1f64),
            rebound: S::from_f64(0.9f64),
            v: S::from_f64(0.4f64),
            g: S::from_f64(9.81f64),
            floor_activity: S::from_f64(0.0),
        }
    }
}
