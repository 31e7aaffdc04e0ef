/// A bob on a rod that swings in all directions, pushed sideways from its lowest turn.
///
/// The fields are its parameters, in SI units; the methods are its kernels.
///
/// # Equations of motion
///
/// ```text
/// mass_matrix * accelerations = generalized_forces - convective_forces
/// coordinates = [theta; phi]
/// [m*l^2, 0; 0, m*l^2*sin(theta)^2] * [theta_ddot; phi_ddot] = [
///     -m*l*g*sin(theta) - convective_forces[1];
///     -convective_forces[2]
/// ]
///
/// mass_matrix = [m*l^2, 0; 0, m*l^2*sin(theta)^2]
///
/// convective_forces = [convective_forces[1]; convective_forces[2]]
/// convective_forces[1] = m*l*s_1*sin(phi)*cos(theta) + m*l^2*theta_dot^2*sin(theta)*cos(theta)
///     - m*l*s_2*cos(phi)*cos(theta)
/// convective_forces[2] = m*l*s_2*sin(theta)*sin(phi) + m*l*s_1*sin(theta)*cos(phi)
///
/// generalized_forces = [-m*l*g*sin(theta); 0]
///
/// s_1 = 2*l*theta_dot*phi_dot*cos(phi)*cos(theta) - l*theta_dot^2*sin(theta)*sin(phi)
///     - l*phi_dot^2*sin(theta)*sin(phi)
/// s_2 = 2*l*theta_dot*phi_dot*sin(phi)*cos(theta) + l*theta_dot^2*sin(theta)*cos(phi)
///     + l*phi_dot^2*sin(theta)*cos(phi)
/// ```
#[allow(non_snake_case)]
#[derive(
    ::core::clone::Clone,
    ::core::marker::Copy,
    ::core::fmt::Debug,
    ::core::cmp::PartialEq
)]
pub struct SphericalPendulum<S = ::core::primitive::f64> {
    /// In `kg`.
    pub m: S,
    /// In `m`.
    pub l: S,
    /// In `m/s^2`.
    pub g: S,
    /// Angle at the start, where the bob is lowest, in `1`.
    pub theta0: S,
    /// Rate at which it turns there, in `rad/s`.
    pub turning: S,
}
impl<S: sim_kernel::Scalar> ::core::default::Default for SphericalPendulum<S> {
    /// The declared values.
    fn default() -> Self {
        <Self as sim_kernel::Mechanism<S>>::defaults()
    }
}
/// Coordinates of [`SphericalPendulum`] by name, in SI units; also for their speeds and accelerations.
#[allow(non_snake_case)]
#[derive(
    ::core::clone::Clone,
    ::core::marker::Copy,
    ::core::fmt::Debug,
    ::core::cmp::PartialEq
)]
pub struct SphericalPendulumCoordinates<S = ::core::primitive::f64> {
    /// Angle of the rod from straight down, in `rad`.
    pub theta: S,
    /// Direction in which it leans, in `rad`.
    pub phi: S,
}
impl<S: sim_kernel::Scalar> ::core::convert::From<[S; 2]>
for SphericalPendulumCoordinates<S> {
    fn from(values: [S; 2]) -> Self {
        Self {
            theta: values[0],
            phi: values[1],
        }
    }
}
impl<S: sim_kernel::Scalar> ::core::convert::From<SphericalPendulumCoordinates<S>>
for [S; 2] {
    fn from(record: SphericalPendulumCoordinates<S>) -> Self {
        [record.theta, record.phi]
    }
}
/// Outputs of [`SphericalPendulum`] by name, in SI units.
#[allow(non_snake_case)]
#[derive(
    ::core::clone::Clone,
    ::core::marker::Copy,
    ::core::fmt::Debug,
    ::core::cmp::PartialEq
)]
pub struct SphericalPendulumOutputs<S = ::core::primitive::f64> {
    /// height of the bob, in `m`.
    pub height: S,
    /// In `m`.
    pub x: S,
    /// In `m`.
    pub y: S,
    /// angular momentum about the vertical, in `N*m*s`.
    pub momentum: S,
}
impl<S: sim_kernel::Scalar> ::core::convert::From<[S; 4]>
for SphericalPendulumOutputs<S> {
    fn from(values: [S; 4]) -> Self {
        Self {
            height: values[0],
            x: values[1],
            y: values[2],
            momentum: values[3],
        }
    }
}
impl<S: sim_kernel::Scalar> ::core::convert::From<SphericalPendulumOutputs<S>>
for [S; 4] {
    fn from(record: SphericalPendulumOutputs<S>) -> Self {
        [record.height, record.x, record.y, record.momentum]
    }
}
/// Rates of the outputs of [`SphericalPendulum`] by name, in SI units.
#[allow(non_snake_case)]
#[derive(
    ::core::clone::Clone,
    ::core::marker::Copy,
    ::core::fmt::Debug,
    ::core::cmp::PartialEq
)]
pub struct SphericalPendulumOutputRates<S = ::core::primitive::f64> {
    /// Rate of `height`.
    pub height: S,
    /// Rate of `x`.
    pub x: S,
    /// Rate of `y`.
    pub y: S,
    /// Rate of `momentum`.
    pub momentum: S,
}
impl<S: sim_kernel::Scalar> ::core::convert::From<[S; 4]>
for SphericalPendulumOutputRates<S> {
    fn from(values: [S; 4]) -> Self {
        Self {
            height: values[0],
            x: values[1],
            y: values[2],
            momentum: values[3],
        }
    }
}
impl<S: sim_kernel::Scalar> ::core::convert::From<SphericalPendulumOutputRates<S>>
for [S; 4] {
    fn from(record: SphericalPendulumOutputRates<S>) -> Self {
        [record.height, record.x, record.y, record.momentum]
    }
}
/// What the equations of motion need of the parameters of [`SphericalPendulum`], from [`SphericalPendulum::prepare`]; its methods are the kernels of each step.
#[allow(non_snake_case)]
#[derive(
    ::core::clone::Clone,
    ::core::marker::Copy,
    ::core::fmt::Debug,
    ::core::cmp::PartialEq
)]
pub struct SphericalPendulumPrepared<S = ::core::primitive::f64> {
    l: S,
    mass_theta_theta: S,
    k: S,
    k_2: S,
    k_3: S,
    k_4: S,
    inverse_theta: S,
    k_5: S,
}
#[allow(non_snake_case, unused_variables, unused_parens, clippy::all, clippy::pedantic)]
impl<S: sim_kernel::Scalar> SphericalPendulum<S> {
    /// What the equations of motion need of the parameters, computed once for a set of parameters.
    ///
    /// Operations: 8 multiplications, 1 division.
    #[inline]
    pub fn prepare(&self) -> SphericalPendulumPrepared<S> {
        let l_squared = self.l * self.l;
        let mass_theta_theta = self.m * l_squared;
        let w = self.m * self.l;
        SphericalPendulumPrepared {
            l: self.l,
            mass_theta_theta: mass_theta_theta,
            k: self.l * S::from_f64(2.0),
            k_2: w,
            k_3: self.g * w,
            k_4: self.m * l_squared * S::from_f64(2.0),
            inverse_theta: S::from_f64(1.0) / mass_theta_theta,
            k_5: S::from_f64(2.0) * w,
        }
    }
    /// Mass matrix `T_q' M T_q`, 2 x 2, symmetric, in SI units.
    ///
    /// Operations: 4 multiplications, 1 sine-cosine pair.
    #[inline]
    pub fn mass_matrix(&self, t: S, q: &[S; 2]) -> [[S; 2]; 2] {
        let [theta, _] = *q;
        let mass_theta_theta = self.m * self.l * self.l;
        let ([sin_theta], [_]) = S::sin_cos_each([theta]);
        [
            [mass_theta_theta, S::from_f64(0.0)],
            [S::from_f64(0.0), mass_theta_theta * sin_theta * sin_theta],
        ]
    }
    /// Convective forces `T_q' M g`, 2, with `g = (T_q q' + T_t)_q q' + (..)_t`: joules per unit of each coordinate.
    ///
    /// Operations: 1 addition, 11 multiplications, 1 sine-cosine pair.
    #[inline]
    pub fn convective_forces(&self, t: S, q: &[S; 2], qd: &[S; 2]) -> [S; 2] {
        let [theta, _] = *q;
        let [theta_dot, phi_dot] = *qd;
        let l_squared = self.l * self.l;
        let ([sin_theta], [cos_theta]) = S::sin_cos_each([theta]);
        let w = cos_theta * sin_theta;
        [
            -(phi_dot * phi_dot * self.m * l_squared * w),
            theta_dot * phi_dot * w * self.m * S::from_f64(2.0) * l_squared,
        ]
    }
    /// Generalised forces `T_q' F`, 2: joules per unit of each coordinate.
    ///
    /// Operations: 1 addition, 3 multiplications, 1 sine-cosine pair.
    #[inline]
    pub fn generalized_forces(&self, t: S, q: &[S; 2], qd: &[S; 2]) -> [S; 2] {
        let [theta, _] = *q;
        let ([sin_theta], [_]) = S::sin_cos_each([theta]);
        [-(sin_theta * self.m * self.l * self.g), S::from_f64(0.0)]
    }
    /// Constraints `C`, 0, in SI units; zero throughout the motion.
    ///
    /// Operations: none.
    #[inline]
    pub fn constraints(&self, t: S, q: &[S; 2]) -> [S; 0] {
        []
    }
    /// The sum of the magnitudes of the terms of `C`, 0, in SI units: what its rounding is relative to.
    ///
    /// Operations: none.
    #[inline]
    pub fn constraint_magnitudes(&self, t: S, q: &[S; 2]) -> [S; 0] {
        []
    }
    /// Constraint Jacobian `C_q`, 0 x 2: units of each constraint per unit of each coordinate.
    ///
    /// Operations: none.
    #[inline]
    pub fn constraint_jacobian(&self, t: S, q: &[S; 2]) -> [[S; 2]; 0] {
        []
    }
    /// `C_t`, 0, units of `C` per second: the speeds obey `C_q q' + C_t = 0`.
    ///
    /// Operations: none.
    #[inline]
    pub fn constraint_time_derivative(&self, t: S, q: &[S; 2]) -> [S; 0] {
        []
    }
    /// `(C_q q' + C_t)_q q' + (..)_t`, 0, units of `C` per second squared: the part of `C''` without accelerations.
    ///
    /// Operations: none.
    #[inline]
    pub fn constraint_convective(&self, t: S, q: &[S; 2], qd: &[S; 2]) -> [S; 0] {
        []
    }
    /// `C` (0), `C_q` (0 x 2) and `C_t` (0) together, in SI units, for projection.
    ///
    /// Operations: none.
    #[inline]
    pub fn constraint_linearization(
        &self,
        t: S,
        q: &[S; 2],
    ) -> sim_kernel::ConstraintLinearization<[S; 0], [[S; 2]; 0]> {
        sim_kernel::ConstraintLinearization {
            values: [],
            jacobian: [],
            time_derivative: [],
        }
    }
    /// Kinetic energy `v' M v / 2`, in joules.
    ///
    /// Operations: 4 additions, 18 multiplications, 2 sine-cosine pairs.
    #[inline]
    pub fn kinetic_energy(&self, t: S, q: &[S; 2], qd: &[S; 2]) -> S {
        let [theta, phi] = *q;
        let [theta_dot, phi_dot] = *qd;
        let w = S::from_f64(0.5) * self.m;
        let ([sin_phi, sin_theta], [cos_phi, cos_theta]) = S::sin_cos_each([phi, theta]);
        let w_2 = theta_dot * cos_theta;
        let w_3 = phi_dot * sin_theta;
        let w_4 = self.l * (cos_phi * w_2 - sin_phi * w_3);
        let w_5 = self.l * (sin_phi * w_2 + cos_phi * w_3);
        w * (w_4 * w_4 + w_5 * w_5)
            + theta_dot * theta_dot * sin_theta * sin_theta * self.l * self.l * w
    }
    /// Power of loads and drives, `F' v + lambda' C_t + T_t' (M x'' - F)`, in watts.
    ///
    /// Operations: 1 addition, 4 multiplications, 1 sine-cosine pair.
    #[inline]
    pub fn power(
        &self,
        t: S,
        q: &[S; 2],
        qd: &[S; 2],
        qdd: &[S; 2],
        lambda: &[S; 0],
    ) -> S {
        let [theta, _] = *q;
        let [theta_dot, _] = *qd;
        let ([sin_theta], [_]) = S::sin_cos_each([theta]);
        -(theta_dot * sin_theta * self.m * self.l * self.g)
    }
    /// Outputs, 4, in SI units.
    ///
    /// Operations: 4 additions, 17 multiplications, 2 sine-cosine pairs.
    #[inline]
    pub fn outputs(
        &self,
        t: S,
        q: &[S; 2],
        qd: &[S; 2],
        qdd: &[S; 2],
        lambda: &[S; 0],
    ) -> SphericalPendulumOutputs<S> {
        let [theta, phi] = *q;
        let [theta_dot, phi_dot] = *qd;
        let ([sin_theta, sin_phi], [cos_theta, cos_phi]) = S::sin_cos_each([theta, phi]);
        let w = self.l * sin_theta;
        let w_2 = cos_theta * theta_dot;
        let w_3 = sin_theta * phi_dot;
        [
            -(self.l * cos_theta),
            cos_phi * w,
            w * sin_phi,
            self.m * self.l * sin_theta
                * (cos_phi * self.l * (sin_phi * w_2 + cos_phi * w_3)
                    - sin_phi * self.l * (cos_phi * w_2 - sin_phi * w_3)),
        ]
            .into()
    }
    /// Rates of the outputs that depend on neither accelerations nor multipliers, 4, in SI units per second.
    ///
    /// Operations: 12 additions, 36 multiplications, 2 sine-cosine pairs.
    #[inline]
    pub fn output_rates(
        &self,
        t: S,
        q: &[S; 2],
        qd: &[S; 2],
        qdd: &[S; 2],
    ) -> SphericalPendulumOutputRates<S> {
        let [theta, phi] = *q;
        let [theta_dot, phi_dot] = *qd;
        let [theta_ddot, phi_ddot] = *qdd;
        let ([sin_theta, sin_phi], [cos_theta, cos_phi]) = S::sin_cos_each([theta, phi]);
        let w = theta_dot * cos_theta;
        let w_2 = sin_theta * phi_dot;
        let w_3 = cos_phi * w - sin_phi * w_2;
        let w_4 = self.l * w_3;
        let w_5 = sin_phi * w + cos_phi * w_2;
        let w_6 = self.l * w_5;
        let w_7 = theta_dot * theta_dot + phi_dot * phi_dot;
        let w_8 = cos_theta * theta_ddot;
        let w_9 = phi_dot * self.l * S::from_f64(2.0);
        let w_10 = sin_phi
            * (self.l
                * (sin_theta * (cos_phi * w_7 + sin_phi * phi_ddot) - cos_phi * w_8)
                + sin_phi * w * w_9);
        let w_11 = sin_theta
            * (cos_phi
                * (self.l
                    * (sin_theta * (cos_phi * phi_ddot - sin_phi * w_7) + sin_phi * w_8)
                    + cos_phi * w * w_9) + w_10);
        [
            theta_dot * self.l * sin_theta,
            w_4,
            w_6,
            self.m * self.l * (w_11 + w_3 * w_6 - w_4 * w_5),
        ]
            .into()
    }
    /// `left - right` of each event, 0, in SI units: zero when it happens.
    ///
    /// Operations: none.
    #[inline]
    pub fn events(
        &self,
        t: S,
        q: &[S; 2],
        qd: &[S; 2],
        qdd: &[S; 2],
        lambda: &[S; 0],
    ) -> [S; 0] {
        []
    }
    /// The numbers of each shape of the drawing, in metres and radians.
    ///
    /// Operations: 1 addition, 4 multiplications, 2 sine-cosine pairs.
    #[inline]
    pub fn drawing(&self, t: S, q: &[S; 2]) -> [S; 12] {
        let [theta, phi] = *q;
        let ([sin_theta, sin_phi], [cos_theta, cos_phi]) = S::sin_cos_each([theta, phi]);
        let w = self.l * sin_theta;
        let P_x = cos_phi * w;
        let P_y = w * sin_phi;
        let P_z = -(self.l * cos_theta);
        [
            S::from_f64(0.0),
            S::from_f64(0.0),
            S::from_f64(0.0),
            S::from_f64(0.0),
            S::from_f64(0.0),
            S::from_f64(0.0),
            P_x,
            P_y,
            P_z,
            P_x,
            P_y,
            P_z,
        ]
    }
    /// Declared start: values or guesses of the coordinates (2), and speeds (2), in SI units; 0 where nothing is declared.
    ///
    /// Operations: none.
    #[inline]
    pub fn initial(&self) -> sim_kernel::Initial<[S; 2]> {
        sim_kernel::Initial {
            positions: [self.theta0, S::from_f64(0.0)],
            speeds: [S::from_f64(0.0), self.turning],
        }
    }
    /// [`SphericalPendulumPrepared::dynamics`] once; for many calls with the same parameters [`Self::prepare`] first.
    #[inline]
    pub fn dynamics(
        &self,
        t: S,
        q: &[S; 2],
        qd: &[S; 2],
    ) -> sim_kernel::Dynamics<S, [S; 2], [S; 0]> {
        self.prepare().dynamics(t, q, qd)
    }
    /// [`SphericalPendulumPrepared::dynamics_jacobian`] once; for many calls with the same parameters [`Self::prepare`] first.
    #[inline]
    pub fn dynamics_jacobian(
        &self,
        t: S,
        q: &[S; 2],
        qd: &[S; 2],
    ) -> sim_kernel::DynamicsJacobian<S, [[S; 2]; 2], [[S; 2]; 0]> {
        self.prepare().dynamics_jacobian(t, q, qd)
    }
}
#[allow(non_snake_case, unused_variables, unused_parens, clippy::all, clippy::pedantic)]
impl<S: sim_kernel::Scalar> SphericalPendulumPrepared<S> {
    /// Accelerations (2), multipliers (0) and power, from
    ///
    /// ```text
    /// [ T_q' M T_q   C_q' ] [ q''    ]   [ T_q' (F - M g)                      ]
    /// [ C_q          0    ] [ lambda ] = [ -(C_q q' + C_t)_q q' - (..)_t       ]
    /// ```
    ///
    /// by an elimination planned from the structure of the system. Where `refused` is set a pivot was too small and nothing else holds: solve that state from the other kernels.
    ///
    /// Operations: 3 additions, 14 multiplications, 1 division, 1 sine-cosine pair.
    #[inline(always)]
    pub fn dynamics(
        &self,
        t: S,
        q: &[S; 2],
        qd: &[S; 2],
    ) -> sim_kernel::Dynamics<S, [S; 2], [S; 0]> {
        let [theta, _] = *q;
        let [theta_dot, phi_dot] = *qd;
        let ([sin_theta], [cos_theta]) = S::sin_cos_each([theta]);
        let mass_phi_phi = self.mass_theta_theta * sin_theta * sin_theta;
        sim_kernel::Dynamics {
            accelerations: [
                sin_theta
                    * (self.mass_theta_theta * cos_theta * phi_dot * phi_dot - self.k_3)
                    * self.inverse_theta,
                -(sin_theta * cos_theta * theta_dot * phi_dot * self.k_4
                    * (S::from_f64(1.0) / mass_phi_phi)),
            ],
            multipliers: [],
            power: -(sin_theta * theta_dot * self.k_3),
            refused: sim_kernel::pivot_is_refused(
                self.mass_theta_theta,
                self.mass_theta_theta,
            ) | sim_kernel::pivot_is_refused(mass_phi_phi, mass_phi_phi),
        }
    }
    /// The derivatives of accelerations (2 rows) and multipliers (0 rows) with respect to coordinates and speeds (2 columns each): with the equations of motion as `K z = r`, the solutions of `K dz = dr - dK z`. Where `refused` is set a pivot was too small and nothing else holds.
    ///
    /// Operations: 26 additions, 82 multiplications, 1 division, 2 sine-cosine pairs.
    #[inline]
    pub fn dynamics_jacobian(
        &self,
        t: S,
        q: &[S; 2],
        qd: &[S; 2],
    ) -> sim_kernel::DynamicsJacobian<S, [[S; 2]; 2], [[S; 2]; 0]> {
        let [theta, phi] = *q;
        let [theta_dot, phi_dot] = *qd;
        let ([sin_theta, sin_phi], [cos_theta, cos_phi]) = S::sin_cos_each([theta, phi]);
        let w = cos_phi * self.k;
        let w_2 = sin_theta * theta_dot;
        let w_3 = phi_dot * w_2;
        let theta_dot_squared = theta_dot * theta_dot;
        let w_4 = theta_dot_squared + phi_dot * phi_dot;
        let w_5 = self.l * w_4;
        let w_6 = sin_phi * cos_theta;
        let w_7 = w * w_3 + w_5 * w_6;
        let w_8 = sin_phi * self.k;
        let w_9 = cos_theta * cos_phi;
        let w_10 = w_8 * w_3 - w_5 * w_9;
        let w_11 = cos_theta * phi_dot;
        let w_12 = theta_dot * w_11;
        let w_13 = w_12 * w_8 + sin_theta * cos_phi * w_5;
        let w_14 = w_12 * w - self.l * sin_theta * sin_phi * w_4;
        let sin_theta_squared = sin_theta * sin_theta;
        let w_15 = self.k_2
            * (cos_theta * (sin_phi * w_7 - cos_phi * w_10)
                - sin_theta * (cos_phi * w_13 - sin_phi * w_14))
            + theta_dot_squared * (sin_theta_squared * self.k_4 - self.mass_theta_theta)
            - cos_theta * self.k_3;
        let mass_phi_phi = self.mass_theta_theta * sin_theta_squared;
        let w_16 = self.k_2
            * (sin_theta * (sin_phi * w_10 + cos_phi * w_7)
                - cos_theta * (sin_phi * w_13 + cos_phi * w_14));
        let inverse_phi = S::from_f64(1.0) / mass_phi_phi;
        let w_17 = self.k_4 * w_2;
        let w_18 = self.l * (sin_phi * w_11 + cos_phi * w_2);
        let w_19 = self.l * (cos_phi * w_11 - sin_phi * w_2);
        let w_20 = sin_theta * phi_dot;
        let w_21 = self.l * (theta_dot * w_6 + cos_phi * w_20);
        let w_22 = self.l * (theta_dot * w_9 - sin_phi * w_20);
        sim_kernel::DynamicsJacobian {
            accelerations_by_positions: [
                [self.inverse_theta * w_15, S::from_f64(0.0)],
                [
                    inverse_phi
                        * (w_16
                            + sin_theta * cos_theta * self.k_4 * w_11 * w_17
                                * inverse_phi),
                    S::from_f64(0.0),
                ],
            ],
            accelerations_by_speeds: [
                [
                    self.inverse_theta * cos_theta
                        * (self.k_5 * (cos_phi * w_18 - sin_phi * w_19) - w_17),
                    self.inverse_theta * self.k_5 * cos_theta
                        * (cos_phi * w_21 - sin_phi * w_22),
                ],
                [
                    -(inverse_phi * self.k_5 * sin_theta
                        * (sin_phi * w_18 + cos_phi * w_19)),
                    -(inverse_phi * self.k_5 * sin_theta
                        * (sin_phi * w_21 + cos_phi * w_22)),
                ],
            ],
            multipliers_by_positions: [],
            multipliers_by_speeds: [],
            refused: sim_kernel::pivot_is_refused(
                self.mass_theta_theta,
                self.mass_theta_theta,
            ) | sim_kernel::pivot_is_refused(mass_phi_phi, mass_phi_phi),
        }
    }
}
#[allow(non_snake_case, clippy::all, clippy::pedantic)]
impl<S: sim_kernel::Scalar> sim_kernel::Mechanism<S> for SphericalPendulum<S> {
    type Q = [S; 2];
    type L = [S; 0];
    type Z = [S; 2];
    type QQ = [[S; 2]; 2];
    type LQ = [[S; 2]; 0];
    type LL = [[S; 0]; 0];
    type ZZ = [[S; 2]; 2];
    type Entries = [S; 0];
    type Envelope = [S; 0];
    type Parameters = [S; 5];
    type Outputs = [S; 4];
    type OutputRates = [S; 4];
    type Events = [S; 0];
    type EventValues = [S; 0];
    type Activities = [S; 0];
    type Drawing = [S; 12];
    type QP = [[S; 5]; 2];
    type LP = [[S; 5]; 0];
    type Inputs = [sim_kernel::Input<S>; 0];
    type Prepared = SphericalPendulumPrepared<S>;
    type On<T: sim_kernel::Scalar> = SphericalPendulum<T>;
    const DESCRIPTION: sim_kernel::Description = sim_kernel::Description {
        name: "spherical-pendulum",
        type_name: "SphericalPendulum",
        docs: "A bob on a rod that swings in all directions, pushed sideways from its lowest turn.",
        declaration: "/// A bob on a rod that swings in all directions, pushed sideways from its lowest turn.\npub SphericalPendulum;\n\ncoordinates {\n    /// Angle of the rod from straight down.\n    theta [rad];\n    /// Direction in which it leans.\n    phi [rad];\n}\n\nparameters {\n    m [kg] = 1;\n    l [m] = 0.8;\n    g [m/s^2] = 9.81;\n    /// Angle at the start, where the bob is lowest.\n    theta0 [deg] = 30;\n    /// Rate at which it turns there.\n    turning [rad/s] = 6;\n}\n\nlet P = l*[sin(theta)*cos(phi), sin(theta)*sin(phi), -cos(theta)];\n\nbodies { bob: mass m at P; }\nloads { gravity [0, 0, -g]; }\ninitial { theta = theta0; phi = 0; dot(theta) = 0; dot(phi) = turning; }\n\noutputs {\n    /// height of the bob\n    height [m] = P.z;\n    path \"Path seen from above\" { x [m] = P.x; y [m] = P.y; }\n    /// angular momentum about the vertical\n    momentum [N*m*s] = m*(P.x*dot(P).y - P.y*dot(P).x);\n}\n\ndrawing {\n    ground [0, 0, 0];\n    line [0, 0, 0], P;\n    point P;\n}\n",
        coordinates: &[
            sim_kernel::Coordinate {
                position: sim_kernel::Quantity {
                    name: "theta",
                    unit: "rad",
                    factor: 1f64,
                    is_length: false,
                    docs: "Angle of the rod from straight down.",
                },
                speed: sim_kernel::Quantity {
                    name: "theta_dot",
                    unit: "rad/s",
                    factor: 1f64,
                    is_length: false,
                    docs: "",
                },
                acceleration: sim_kernel::Quantity {
                    name: "theta_ddot",
                    unit: "rad/s^2",
                    factor: 1f64,
                    is_length: false,
                    docs: "",
                },
                start: sim_kernel::Start::Given,
                speed_given: true,
            },
            sim_kernel::Coordinate {
                position: sim_kernel::Quantity {
                    name: "phi",
                    unit: "rad",
                    factor: 1f64,
                    is_length: false,
                    docs: "Direction in which it leans.",
                },
                speed: sim_kernel::Quantity {
                    name: "phi_dot",
                    unit: "rad/s",
                    factor: 1f64,
                    is_length: false,
                    docs: "",
                },
                acceleration: sim_kernel::Quantity {
                    name: "phi_ddot",
                    unit: "rad/s^2",
                    factor: 1f64,
                    is_length: false,
                    docs: "",
                },
                start: sim_kernel::Start::Given,
                speed_given: true,
            },
        ],
        parameters: &[
            sim_kernel::Quantity {
                name: "m",
                unit: "kg",
                factor: 1f64,
                is_length: false,
                docs: "",
            },
            sim_kernel::Quantity {
                name: "l",
                unit: "m",
                factor: 1f64,
                is_length: true,
                docs: "",
            },
            sim_kernel::Quantity {
                name: "g",
                unit: "m/s^2",
                factor: 1f64,
                is_length: false,
                docs: "",
            },
            sim_kernel::Quantity {
                name: "theta0",
                unit: "deg",
                factor: 0.017453292519943295f64,
                is_length: false,
                docs: "Angle at the start, where the bob is lowest.",
            },
            sim_kernel::Quantity {
                name: "turning",
                unit: "rad/s",
                factor: 1f64,
                is_length: false,
                docs: "Rate at which it turns there.",
            },
        ],
        inputs: &[],
        constraints: &[],
        speed_constraints: &[],
        norm_constraints: &[],
        sparsity: &[],
        conditionals: &[],
        events: &[],
        outputs: &[
            sim_kernel::Quantity {
                name: "height",
                unit: "m",
                factor: 1f64,
                is_length: true,
                docs: "height of the bob",
            },
            sim_kernel::Quantity {
                name: "x",
                unit: "m",
                factor: 1f64,
                is_length: true,
                docs: "",
            },
            sim_kernel::Quantity {
                name: "y",
                unit: "m",
                factor: 1f64,
                is_length: true,
                docs: "",
            },
            sim_kernel::Quantity {
                name: "momentum",
                unit: "N*m*s",
                factor: 1f64,
                is_length: false,
                docs: "angular momentum about the vertical",
            },
        ],
        rated_outputs: &[0, 1, 2, 3],
        figures: &[
            sim_kernel::Figure {
                name: "height",
                title: "height of the bob",
                len: 1,
            },
            sim_kernel::Figure {
                name: "path",
                title: "Path seen from above",
                len: 2,
            },
            sim_kernel::Figure {
                name: "momentum",
                title: "angular momentum about the vertical",
                len: 1,
            },
        ],
        optional_kernels: &["dynamics_jacobian"],
        dimension: 3,
        drawing: &[
            sim_kernel::Shape::Ground(1),
            sim_kernel::Shape::Line(2),
            sim_kernel::Shape::Points(1),
        ],
    };
    fn defaults() -> Self {
        Self {
            m: S::from_f64(1f64),
            l: S::from_f64(0.8f64),
            g: S::from_f64(9.81f64),
            theta0: S::from_f64(0.5235987755982988f64),
            turning: S::from_f64(6f64),
        }
    }
    fn parameters(&self) -> [S; 5] {
        [self.m, self.l, self.g, self.theta0, self.turning]
    }
    fn with_parameters(&self, parameters: [S; 5]) -> Self {
        Self {
            m: parameters[0],
            l: parameters[1],
            g: parameters[2],
            theta0: parameters[3],
            turning: parameters[4],
            ..*self
        }
    }
    fn on<T: sim_kernel::Scalar>(
        &self,
        convert: impl ::core::ops::Fn(S) -> T,
    ) -> SphericalPendulum<T> {
        SphericalPendulum {
            m: convert(self.m),
            l: convert(self.l),
            g: convert(self.g),
            theta0: convert(self.theta0),
            turning: convert(self.turning),
        }
    }
    fn inputs(&self) -> [sim_kernel::Input<S>; 0] {
        []
    }
    fn with_inputs(&self, inputs: [sim_kernel::Input<S>; 0]) -> Self {
        Self { ..*self }
    }
    fn set_inputs(prepared: &mut Self::Prepared, inputs: [sim_kernel::Input<S>; 0]) {}
    #[inline(always)]
    fn prepare(&self) -> SphericalPendulumPrepared<S> {
        self.prepare()
    }
    #[inline(always)]
    fn prepared_dynamics(
        prepared: &Self::Prepared,
        t: S,
        q: &[S; 2],
        qd: &[S; 2],
    ) -> sim_kernel::Dynamics<S, [S; 2], [S; 0]> {
        prepared.dynamics(t, q, qd)
    }
    #[inline(always)]
    fn dynamics_jacobian(
        &self,
        t: S,
        q: &[S; 2],
        qd: &[S; 2],
    ) -> sim_kernel::DynamicsJacobian<S, [[S; 2]; 2], [[S; 2]; 0]> {
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
    fn constraints(&self, t: S, q: &[S; 2]) -> [S; 0] {
        self.constraints(t, q)
    }
    #[inline(always)]
    fn constraint_magnitudes(&self, t: S, q: &[S; 2]) -> [S; 0] {
        self.constraint_magnitudes(t, q)
    }
    #[inline(always)]
    fn constraint_jacobian(&self, t: S, q: &[S; 2]) -> [[S; 2]; 0] {
        self.constraint_jacobian(t, q)
    }
    #[inline(always)]
    fn constraint_time_derivative(&self, t: S, q: &[S; 2]) -> [S; 0] {
        self.constraint_time_derivative(t, q)
    }
    #[inline(always)]
    fn constraint_convective(&self, t: S, q: &[S; 2], qd: &[S; 2]) -> [S; 0] {
        self.constraint_convective(t, q, qd)
    }
    #[inline(always)]
    fn constraint_linearization(
        &self,
        t: S,
        q: &[S; 2],
    ) -> sim_kernel::ConstraintLinearization<[S; 0], [[S; 2]; 0]> {
        self.constraint_linearization(t, q)
    }
    #[inline(always)]
    fn kinetic_energy(&self, t: S, q: &[S; 2], qd: &[S; 2]) -> S {
        self.kinetic_energy(t, q, qd)
    }
    #[inline(always)]
    fn power(&self, t: S, q: &[S; 2], qd: &[S; 2], qdd: &[S; 2], lambda: &[S; 0]) -> S {
        self.power(t, q, qd, qdd, lambda)
    }
    #[inline(always)]
    fn outputs(
        &self,
        t: S,
        q: &[S; 2],
        qd: &[S; 2],
        qdd: &[S; 2],
        lambda: &[S; 0],
    ) -> [S; 4] {
        self.outputs(t, q, qd, qdd, lambda).into()
    }
    #[inline(always)]
    fn output_rates(&self, t: S, q: &[S; 2], qd: &[S; 2], qdd: &[S; 2]) -> [S; 4] {
        self.output_rates(t, q, qd, qdd).into()
    }
    #[inline(always)]
    fn events(
        &self,
        t: S,
        q: &[S; 2],
        qd: &[S; 2],
        qdd: &[S; 2],
        lambda: &[S; 0],
    ) -> [S; 0] {
        self.events(t, q, qd, qdd, lambda)
    }
    #[inline(always)]
    fn drawing(&self, t: S, q: &[S; 2]) -> [S; 12] {
        self.drawing(t, q)
    }
    #[inline(always)]
    fn initial(&self) -> sim_kernel::Initial<[S; 2]> {
        self.initial()
    }
}
