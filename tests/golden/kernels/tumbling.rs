/// A free rigid body that tumbles, by Euler's angles.
///
/// The fields are its parameters, in SI units; the methods are its kernels.
///
/// # Equations of motion
///
/// ```text
/// mass_matrix * accelerations = generalized_forces - convective_forces
/// coordinates = [psi; theta; phi]
/// [
///     mass_matrix[1, 1], mass_matrix[1, 2], C*cos(theta);
///     mass_matrix[1, 2], A*cos(phi)^2 + B*sin(phi)^2, 0;
///     C*cos(theta), 0, C
/// ] * [psi_ddot; theta_ddot; phi_ddot] = [
///     -convective_forces[1];
///     s_2*sin(phi) - s_1*cos(phi);
///     -s_3
/// ]
///
/// mass_matrix = [
///     mass_matrix[1, 1], mass_matrix[1, 2], C*cos(theta);
///     mass_matrix[1, 2], A*cos(phi)^2 + B*sin(phi)^2, 0;
///     C*cos(theta), 0, C
/// ]
/// mass_matrix[1, 1] = A*sin(theta)^2*sin(phi)^2 + B*sin(theta)^2*cos(phi)^2 + C*cos(theta)^2
/// mass_matrix[1, 2] = A*sin(theta)*sin(phi)*cos(phi) - B*sin(theta)*sin(phi)*cos(phi)
///
/// convective_forces = [
///     convective_forces[1];
///     s_1*cos(phi) - s_2*sin(phi);
///     s_3
/// ]
/// convective_forces[1] = s_1*sin(theta)*sin(phi) + s_2*sin(theta)*cos(phi) + s_3*cos(theta)
///
/// generalized_forces = [0; 0; 0]
///
/// w_x = theta_dot*cos(phi) + psi_dot*sin(theta)*sin(phi)
/// w_y = psi_dot*sin(theta)*cos(phi) - theta_dot*sin(phi)
/// w_z = phi_dot + psi_dot*cos(theta)
/// s_1 = C*w_y*w_z - B*w_y*w_z + A*(w_y*phi_dot + psi_dot*theta_dot*cos(theta)*sin(phi))
/// s_2 = A*w_x*w_z - C*w_x*w_z - B*(w_x*phi_dot - psi_dot*theta_dot*cos(theta)*cos(phi))
/// s_3 = B*w_x*w_y - A*w_x*w_y - C*psi_dot*theta_dot*sin(theta)
/// ```
#[allow(non_snake_case)]
#[derive(
    ::core::clone::Clone,
    ::core::marker::Copy,
    ::core::fmt::Debug,
    ::core::cmp::PartialEq
)]
pub struct Tumbling<S = ::core::primitive::f64> {
    /// Principal moments of inertia, in `kg*m^2`.
    pub A: S,
    /// In `kg*m^2`.
    pub B: S,
    /// In `kg*m^2`.
    pub C: S,
    /// Angular momentum, in `N*m*s`.
    pub H: S,
    /// Nutation at the start, in `1`.
    pub theta0: S,
}
impl<S: sim_kernel::Scalar> ::core::default::Default for Tumbling<S> {
    /// The declared values.
    fn default() -> Self {
        <Self as sim_kernel::Mechanism<S>>::defaults()
    }
}
/// Coordinates of [`Tumbling`] by name, in SI units; also for their speeds and accelerations.
#[allow(non_snake_case)]
#[derive(
    ::core::clone::Clone,
    ::core::marker::Copy,
    ::core::fmt::Debug,
    ::core::cmp::PartialEq
)]
pub struct TumblingCoordinates<S = ::core::primitive::f64> {
    /// Precession about the angular momentum, in `rad`.
    pub psi: S,
    /// Nutation: angle between the third axis of the body and the angular momentum, in `rad`.
    pub theta: S,
    /// Spin about the third axis, in `rad`.
    pub phi: S,
}
impl<S: sim_kernel::Scalar> ::core::convert::From<[S; 3]> for TumblingCoordinates<S> {
    fn from(values: [S; 3]) -> Self {
        Self {
            psi: values[0],
            theta: values[1],
            phi: values[2],
        }
    }
}
impl<S: sim_kernel::Scalar> ::core::convert::From<TumblingCoordinates<S>> for [S; 3] {
    fn from(record: TumblingCoordinates<S>) -> Self {
        [record.psi, record.theta, record.phi]
    }
}
/// Outputs of [`Tumbling`] by name, in SI units.
#[allow(non_snake_case)]
#[derive(
    ::core::clone::Clone,
    ::core::marker::Copy,
    ::core::fmt::Debug,
    ::core::cmp::PartialEq
)]
pub struct TumblingOutputs<S = ::core::primitive::f64> {
    /// about the axis of least inertia, in `rad/s`.
    pub w1: S,
    /// about the intermediate axis, in `rad/s`.
    pub w2: S,
    /// about the axis of most inertia, in `rad/s`.
    pub w3: S,
    /// In `N*m*s`.
    pub Hx: S,
    /// In `N*m*s`.
    pub Hy: S,
    /// In `N*m*s`.
    pub Hz: S,
    /// kinetic energy, in `J`.
    pub energy: S,
}
impl<S: sim_kernel::Scalar> ::core::convert::From<[S; 7]> for TumblingOutputs<S> {
    fn from(values: [S; 7]) -> Self {
        Self {
            w1: values[0],
            w2: values[1],
            w3: values[2],
            Hx: values[3],
            Hy: values[4],
            Hz: values[5],
            energy: values[6],
        }
    }
}
impl<S: sim_kernel::Scalar> ::core::convert::From<TumblingOutputs<S>> for [S; 7] {
    fn from(record: TumblingOutputs<S>) -> Self {
        [record.w1, record.w2, record.w3, record.Hx, record.Hy, record.Hz, record.energy]
    }
}
/// Rates of the outputs of [`Tumbling`] by name, in SI units.
#[allow(non_snake_case)]
#[derive(
    ::core::clone::Clone,
    ::core::marker::Copy,
    ::core::fmt::Debug,
    ::core::cmp::PartialEq
)]
pub struct TumblingOutputRates<S = ::core::primitive::f64> {
    /// Rate of `w1`.
    pub w1: S,
    /// Rate of `w2`.
    pub w2: S,
    /// Rate of `w3`.
    pub w3: S,
    /// Rate of `Hx`.
    pub Hx: S,
    /// Rate of `Hy`.
    pub Hy: S,
    /// Rate of `Hz`.
    pub Hz: S,
    /// Rate of `energy`.
    pub energy: S,
}
impl<S: sim_kernel::Scalar> ::core::convert::From<[S; 7]> for TumblingOutputRates<S> {
    fn from(values: [S; 7]) -> Self {
        Self {
            w1: values[0],
            w2: values[1],
            w3: values[2],
            Hx: values[3],
            Hy: values[4],
            Hz: values[5],
            energy: values[6],
        }
    }
}
impl<S: sim_kernel::Scalar> ::core::convert::From<TumblingOutputRates<S>> for [S; 7] {
    fn from(record: TumblingOutputRates<S>) -> Self {
        [record.w1, record.w2, record.w3, record.Hx, record.Hy, record.Hz, record.energy]
    }
}
/// What the equations of motion need of the parameters of [`Tumbling`], from [`Tumbling::prepare`]; its methods are the kernels of each step.
#[allow(non_snake_case)]
#[derive(
    ::core::clone::Clone,
    ::core::marker::Copy,
    ::core::fmt::Debug,
    ::core::cmp::PartialEq
)]
pub struct TumblingPrepared<S = ::core::primitive::f64> {
    A: S,
    B: S,
    C: S,
    k: S,
    k_2: S,
    k_3: S,
    k_4: S,
    k_5: S,
    k_6: S,
    k_7: S,
    k_8: S,
    k_9: S,
    k_10: S,
    k_11: S,
    inverse_phi: S,
    k_12: S,
    k_13: S,
    k_14: S,
    k_15: S,
}
#[allow(non_snake_case, unused_variables, unused_parens, clippy::all, clippy::pedantic)]
impl<S: sim_kernel::Scalar> Tumbling<S> {
    /// What the equations of motion need of the parameters, computed once for a set of parameters.
    ///
    /// Operations: 16 additions, 3 multiplications, 1 division.
    #[inline]
    pub fn prepare(&self) -> TumblingPrepared<S> {
        let w = self.B * S::from_f64(2.0);
        let w_2 = self.A * S::from_f64(2.0);
        TumblingPrepared {
            A: self.A,
            B: self.B,
            C: self.C,
            k: self.A - self.B,
            k_2: self.C - self.B,
            k_3: self.A - self.C,
            k_4: self.B - self.A,
            k_5: w,
            k_6: w_2,
            k_7: self.C * S::from_f64(2.0),
            k_8: w - w_2,
            k_9: w_2 - w,
            k_10: self.C + self.B - self.A,
            k_11: self.B - self.A - self.C,
            inverse_phi: S::from_f64(1.0) / self.C,
            k_12: self.B - self.C,
            k_13: self.C - self.A,
            k_14: self.B - self.C - self.A,
            k_15: self.A - self.C - self.B,
        }
    }
    /// Mass matrix `T_q' M T_q`, 3 x 3, symmetric, in SI units.
    ///
    /// Operations: 4 additions, 14 multiplications, 2 sine-cosine pairs.
    #[inline]
    pub fn mass_matrix(&self, t: S, q: &[S; 3]) -> [[S; 3]; 3] {
        let [_, theta, phi] = *q;
        let ([sin_theta, sin_phi], [cos_theta, cos_phi]) = S::sin_cos_each([theta, phi]);
        let sin_phi_squared = sin_phi * sin_phi;
        let cos_phi_squared = cos_phi * cos_phi;
        let mass_theta_psi = sin_theta * sin_phi * cos_phi * (self.A - self.B);
        let mass_phi_psi = self.C * cos_theta;
        [
            [
                sin_theta * sin_theta
                    * (self.A * sin_phi_squared + self.B * cos_phi_squared)
                    + self.C * cos_theta * cos_theta,
                mass_theta_psi,
                mass_phi_psi,
            ],
            [
                mass_theta_psi,
                self.A * cos_phi_squared + sin_phi_squared * self.B,
                S::from_f64(0.0),
            ],
            [mass_phi_psi, S::from_f64(0.0), self.C],
        ]
    }
    /// Convective forces `T_q' M g`, 3, with `g = (T_q q' + T_t)_q q' + (..)_t`: joules per unit of each coordinate.
    ///
    /// Operations: 22 additions, 43 multiplications, 2 sine-cosine pairs.
    #[inline]
    pub fn convective_forces(&self, t: S, q: &[S; 3], qd: &[S; 3]) -> [S; 3] {
        let [_, theta, phi] = *q;
        let [psi_dot, theta_dot, phi_dot] = *qd;
        let ([sin_theta, sin_phi], [cos_theta, cos_phi]) = S::sin_cos_each([theta, phi]);
        let sin_phi_squared = sin_phi * sin_phi;
        let w = self.A * S::from_f64(2.0);
        let cos_phi_squared = cos_phi * cos_phi;
        let w_2 = self.B * S::from_f64(2.0);
        let w_3 = w_2 - w;
        let w_4 = sin_phi_squared * w_3;
        let w_5 = sin_theta * theta_dot
            * (psi_dot * cos_theta
                * (sin_phi_squared * w - self.C * S::from_f64(2.0)
                    + cos_phi_squared * w_2)
                + phi_dot * (self.A - self.C - self.B + w_4));
        let w_6 = sin_theta
            * (cos_theta * psi_dot * psi_dot
                * (self.C - self.B * cos_phi_squared - self.A * sin_phi_squared)
                + psi_dot * phi_dot * (w_4 + (self.A + self.C - self.B)));
        let w_7 = sin_phi * theta_dot;
        let w_8 = sin_theta * psi_dot;
        [
            w_5
                + sin_phi * cos_phi
                    * (psi_dot * phi_dot * sin_theta * sin_theta * (w - w_2)
                        + cos_theta * theta_dot * theta_dot * (self.A - self.B)),
            w_6 + cos_phi * w_7 * phi_dot * w_3,
            (cos_phi * w_8 - w_7) * (cos_phi * theta_dot + sin_phi * w_8)
                * (self.B - self.A) - sin_theta * self.C * psi_dot * theta_dot,
        ]
    }
    /// Generalised forces `T_q' F`, 3: joules per unit of each coordinate.
    ///
    /// Operations: none.
    #[inline]
    pub fn generalized_forces(&self, t: S, q: &[S; 3], qd: &[S; 3]) -> [S; 3] {
        [S::from_f64(0.0), S::from_f64(0.0), S::from_f64(0.0)]
    }
    /// Constraints `C`, 0, in SI units; zero throughout the motion.
    ///
    /// Operations: none.
    #[inline]
    pub fn constraints(&self, t: S, q: &[S; 3]) -> [S; 0] {
        []
    }
    /// The sum of the magnitudes of the terms of `C`, 0, in SI units: what its rounding is relative to.
    ///
    /// Operations: none.
    #[inline]
    pub fn constraint_magnitudes(&self, t: S, q: &[S; 3]) -> [S; 0] {
        []
    }
    /// Constraint Jacobian `C_q`, 0 x 3: units of each constraint per unit of each coordinate.
    ///
    /// Operations: none.
    #[inline]
    pub fn constraint_jacobian(&self, t: S, q: &[S; 3]) -> [[S; 3]; 0] {
        []
    }
    /// `C_t`, 0, units of `C` per second: the speeds obey `C_q q' + C_t = 0`.
    ///
    /// Operations: none.
    #[inline]
    pub fn constraint_time_derivative(&self, t: S, q: &[S; 3]) -> [S; 0] {
        []
    }
    /// `(C_q q' + C_t)_q q' + (..)_t`, 0, units of `C` per second squared: the part of `C''` without accelerations.
    ///
    /// Operations: none.
    #[inline]
    pub fn constraint_convective(&self, t: S, q: &[S; 3], qd: &[S; 3]) -> [S; 0] {
        []
    }
    /// `C` (0), `C_q` (0 x 3) and `C_t` (0) together, in SI units, for projection.
    ///
    /// Operations: none.
    #[inline]
    pub fn constraint_linearization(
        &self,
        t: S,
        q: &[S; 3],
    ) -> sim_kernel::ConstraintLinearization<[S; 0], [[S; 3]; 0]> {
        sim_kernel::ConstraintLinearization {
            values: [],
            jacobian: [],
            time_derivative: [],
        }
    }
    /// Kinetic energy `v' M v / 2`, in joules.
    ///
    /// Operations: 5 additions, 15 multiplications, 2 sine-cosine pairs.
    #[inline]
    pub fn kinetic_energy(&self, t: S, q: &[S; 3], qd: &[S; 3]) -> S {
        let [_, theta, phi] = *q;
        let [psi_dot, theta_dot, phi_dot] = *qd;
        let ([sin_phi, sin_theta], [cos_phi, cos_theta]) = S::sin_cos_each([phi, theta]);
        let w = psi_dot * sin_theta;
        let w_x = theta_dot * cos_phi + sin_phi * w;
        let w_y = cos_phi * w - theta_dot * sin_phi;
        let w_z = phi_dot + psi_dot * cos_theta;
        w_x * w_x * S::from_f64(0.5) * self.A + w_y * w_y * S::from_f64(0.5) * self.B
            + w_z * w_z * S::from_f64(0.5) * self.C
    }
    /// Power of loads and drives, `F' v + lambda' C_t + T_t' (M x'' - F)`, in watts.
    ///
    /// Operations: none.
    #[inline]
    pub fn power(
        &self,
        t: S,
        q: &[S; 3],
        qd: &[S; 3],
        qdd: &[S; 3],
        lambda: &[S; 0],
    ) -> S {
        S::from_f64(0.0)
    }
    /// Outputs, 7, in SI units.
    ///
    /// Operations: 15 additions, 43 multiplications, 3 sine-cosine pairs.
    #[inline]
    pub fn outputs(
        &self,
        t: S,
        q: &[S; 3],
        qd: &[S; 3],
        qdd: &[S; 3],
        lambda: &[S; 0],
    ) -> TumblingOutputs<S> {
        let [psi, theta, phi] = *q;
        let [psi_dot, theta_dot, phi_dot] = *qd;
        let ([sin_phi, sin_theta, sin_psi], [cos_phi, cos_theta, cos_psi]) = S::sin_cos_each([
            phi,
            theta,
            psi,
        ]);
        let w = psi_dot * sin_theta;
        let w_x = theta_dot * cos_phi + sin_phi * w;
        let w_y = cos_phi * w - theta_dot * sin_phi;
        let w_z = phi_dot + psi_dot * cos_theta;
        let w_2 = sin_phi * cos_theta;
        let w_3 = w_x * self.A;
        let w_4 = sin_theta * self.C;
        let w_5 = cos_phi * cos_theta;
        let w_6 = w_y * self.B;
        [
            w_x,
            w_y,
            w_z,
            (cos_phi * cos_psi - sin_psi * w_2) * w_3 + w_z * sin_psi * w_4
                - (sin_phi * cos_psi + sin_psi * w_5) * w_6,
            w_3 * (cos_phi * sin_psi + cos_psi * w_2)
                + w_6 * (cos_psi * w_5 - sin_phi * sin_psi) - w_z * cos_psi * w_4,
            sin_theta * (sin_phi * w_x * self.A + cos_phi * w_y * self.B)
                + cos_theta * w_z * self.C,
            w_x * w_x * self.A * S::from_f64(0.5) + w_y * w_y * self.B * S::from_f64(0.5)
                + w_z * w_z * self.C * S::from_f64(0.5),
        ]
            .into()
    }
    /// Rates of the outputs that depend on neither accelerations nor multipliers, 7, in SI units per second.
    ///
    /// Operations: 44 additions, 82 multiplications, 3 sine-cosine pairs.
    #[inline]
    pub fn output_rates(
        &self,
        t: S,
        q: &[S; 3],
        qd: &[S; 3],
        qdd: &[S; 3],
    ) -> TumblingOutputRates<S> {
        let [psi, theta, phi] = *q;
        let [psi_dot, theta_dot, phi_dot] = *qd;
        let [psi_ddot, theta_ddot, phi_ddot] = *qdd;
        let ([sin_phi, sin_theta, sin_psi], [cos_phi, cos_theta, cos_psi]) = S::sin_cos_each([
            phi,
            theta,
            psi,
        ]);
        let w = psi_dot * cos_theta;
        let w_2 = theta_dot * (w - phi_dot) + sin_theta * psi_ddot;
        let w_z = phi_dot + w;
        let w_3 = psi_dot * sin_theta;
        let w_4 = theta_ddot + phi_dot * w_3;
        let w_5 = sin_phi * w_2 + cos_phi * w_4;
        let w_6 = cos_phi * w_2;
        let w_7 = sin_phi * w_4;
        let w_8 = phi_ddot - theta_dot * w_3 + cos_theta * psi_ddot;
        let w_9 = cos_psi * w_z;
        let w_10 = theta_dot * w_z;
        let w_11 = cos_theta * w_10;
        let w_12 = cos_phi * cos_psi;
        let w_13 = sin_phi * sin_psi;
        let w_x = cos_phi * theta_dot + sin_phi * w_3;
        let w_14 = psi_dot + cos_theta * phi_dot;
        let w_15 = theta_dot * sin_theta;
        let w_16 = cos_phi * w_14 - sin_phi * w_15;
        let w_17 = self.A
            * (w_5 * (w_12 - cos_theta * w_13) - w_x * (sin_psi * w_16 + sin_phi * w_9));
        let w_18 = sin_phi * cos_psi;
        let w_19 = cos_phi * sin_psi;
        let w_20 = w_18 + cos_theta * w_19;
        let w_23 = w_19 + cos_theta * w_18;
        let w_21 = w_7 - w_6;
        let w_y = cos_phi * w_3 - theta_dot * sin_phi;
        let w_22 = self.B
            * (w_20 * w_21 - w_y * (cos_phi * (w_9 - sin_psi * w_15) - w_13 * w_14));
        let w_24 = self.B
            * (w_21 * (cos_theta * w_12 - w_13)
                + w_y * (psi_dot * w_20 + w_12 * w_15 + phi_dot * w_23));
        let w_25 = sin_theta
            * (self.A * (cos_phi * phi_dot * w_x + sin_phi * w_5)
                - self.B * (sin_phi * phi_dot * w_y + cos_phi * w_21) - self.C * w_10);
        let w_27 = self.B * w_y;
        let w_26 = self.A * w_x;
        let w_28 = w_8 * self.C;
        [
            w_5,
            w_6 - w_7,
            w_8,
            self.C * (sin_theta * (psi_dot * w_9 + w_8 * sin_psi) + sin_psi * w_11)
                + w_17 + w_22,
            self.C * (w_3 * sin_psi * w_z - cos_psi * (w_11 + sin_theta * w_8))
                + self.A * (w_5 * w_23 + w_x * (cos_psi * w_16 - w_13 * w_z)) - w_24,
            w_25 + cos_theta * (theta_dot * (sin_phi * w_26 + cos_phi * w_27) + w_28),
            w_5 * w_26 - w_21 * w_27 + w_z * w_28,
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
        q: &[S; 3],
        qd: &[S; 3],
        qdd: &[S; 3],
        lambda: &[S; 0],
    ) -> [S; 0] {
        []
    }
    /// The numbers of each shape of the drawing, in metres and radians.
    ///
    /// Operations: 13 additions, 21 multiplications, 3 sine-cosine pairs.
    #[inline]
    pub fn drawing(&self, t: S, q: &[S; 3]) -> [S; 30] {
        let [psi, theta, phi] = *q;
        let ([sin_psi, sin_phi, sin_theta], [cos_psi, cos_phi, cos_theta]) = S::sin_cos_each([
            psi,
            phi,
            theta,
        ]);
        let w = cos_psi * cos_phi;
        let w_2 = sin_psi * sin_phi;
        let w_3 = cos_theta * w_2;
        let w_4 = w - w_3;
        let w_5 = cos_phi * sin_psi;
        let w_6 = cos_psi * sin_phi;
        let w_7 = w_5 + cos_theta * w_6;
        let w_8 = sin_phi * sin_theta;
        let w_9 = S::from_f64(0.7) * (w_6 + cos_theta * w_5);
        let w_10 = S::from_f64(0.7) * (cos_theta * w - w_2);
        let w_11 = cos_phi * sin_theta * S::from_f64(0.7);
        let w_12 = sin_psi * sin_theta;
        let w_13 = cos_psi * sin_theta;
        [
            w_4,
            w_7,
            w_8,
            -w_9,
            w_10,
            w_11,
            w_3 - w,
            -w_7,
            -w_8,
            w_9,
            -w_10,
            -w_11,
            w_4,
            w_7,
            w_8,
            -(S::from_f64(0.3) * w_12),
            S::from_f64(0.3) * w_13,
            -(cos_theta * S::from_f64(0.3)),
            w_12 * S::from_f64(0.5),
            -(w_13 * S::from_f64(0.5)),
            cos_theta * S::from_f64(0.5),
            S::from_f64(0.0),
            S::from_f64(0.0),
            S::from_f64(0.0),
            S::from_f64(0.0),
            S::from_f64(0.0),
            S::from_f64(1.2),
            S::from_f64(0.0),
            S::from_f64(0.0),
            S::from_f64(0.0),
        ]
    }
    /// Declared start: values or guesses of the coordinates (3), and speeds (3), in SI units; 0 where nothing is declared.
    ///
    /// Operations: 1 addition, 3 multiplications, 3 divisions, 1 sine-cosine pair.
    #[inline]
    pub fn initial(&self) -> sim_kernel::Initial<[S; 3]> {
        let ([_], [cos_theta0]) = S::sin_cos_each([self.theta0]);
        sim_kernel::Initial {
            positions: [
                S::from_f64(0.0),
                self.theta0,
                S::from_f64(0.5) * S::from_f64(::core::f64::consts::PI),
            ],
            speeds: [
                self.H / self.A,
                S::from_f64(0.0),
                self.H * cos_theta0
                    * (S::from_f64(1.0) / self.C - S::from_f64(1.0) / self.A),
            ],
        }
    }
    /// [`TumblingPrepared::dynamics`] once; for many calls with the same parameters [`Self::prepare`] first.
    #[inline]
    pub fn dynamics(
        &self,
        t: S,
        q: &[S; 3],
        qd: &[S; 3],
    ) -> sim_kernel::Dynamics<S, [S; 3], [S; 0]> {
        self.prepare().dynamics(t, q, qd)
    }
    /// [`TumblingPrepared::dynamics_jacobian`] once; for many calls with the same parameters [`Self::prepare`] first.
    #[inline]
    pub fn dynamics_jacobian(
        &self,
        t: S,
        q: &[S; 3],
        qd: &[S; 3],
    ) -> sim_kernel::DynamicsJacobian<S, [[S; 3]; 3], [[S; 3]; 0]> {
        self.prepare().dynamics_jacobian(t, q, qd)
    }
}
#[allow(non_snake_case, unused_variables, unused_parens, clippy::all, clippy::pedantic)]
impl<S: sim_kernel::Scalar> TumblingPrepared<S> {
    /// Accelerations (3), multipliers (0) and power, from
    ///
    /// ```text
    /// [ T_q' M T_q   C_q' ] [ q''    ]   [ T_q' (F - M g)                      ]
    /// [ C_q          0    ] [ lambda ] = [ -(C_q q' + C_t)_q q' - (..)_t       ]
    /// ```
    ///
    /// by an elimination planned from the structure of the system. Where `refused` is set a pivot was too small and nothing else holds: solve that state from the other kernels.
    ///
    /// Operations: 22 additions, 60 multiplications, 2 divisions, 2 sine-cosine pairs.
    #[inline(always)]
    pub fn dynamics(
        &self,
        t: S,
        q: &[S; 3],
        qd: &[S; 3],
    ) -> sim_kernel::Dynamics<S, [S; 3], [S; 0]> {
        let [_, theta, phi] = *q;
        let [psi_dot, theta_dot, phi_dot] = *qd;
        let ([sin_theta, sin_phi], [cos_theta, cos_phi]) = S::sin_cos_each([theta, phi]);
        let sin_phi_squared = sin_phi * sin_phi;
        let cos_phi_squared = cos_phi * cos_phi;
        let w = self.A * sin_phi_squared + self.B * cos_phi_squared;
        let w_2 = sin_phi_squared * self.k_9;
        let w_3 = sin_phi * theta_dot;
        let rhs_theta = sin_theta
            * (cos_theta * psi_dot * psi_dot * (w - self.C)
                + psi_dot * phi_dot * (w_2 + self.k_11))
            + cos_phi * w_3 * phi_dot * self.k_9;
        let w_5 = sin_theta * theta_dot
            * (cos_theta * psi_dot
                * (self.k_7 - sin_phi_squared * self.k_6 - cos_phi_squared * self.k_5)
                + phi_dot * (self.k_10 + w_2));
        let mass_theta_theta = self.A * cos_phi_squared + sin_phi_squared * self.B;
        let w_4 = sin_theta * sin_phi;
        let rhs_phi = sin_theta * self.C * psi_dot * theta_dot
            + self.k * (sin_theta * cos_phi * psi_dot - w_3)
                * (cos_phi * theta_dot + w_4 * psi_dot);
        let mass_theta_psi = cos_phi * self.k * w_4;
        let sin_theta_squared = sin_theta * sin_theta;
        let mass_psi_psi = sin_theta_squared * w + self.C * cos_theta * cos_theta;
        let inverse_theta = S::from_f64(1.0) / mass_theta_theta;
        let l_psi_theta = mass_theta_psi * inverse_theta;
        let mass_phi_psi = self.C * cos_theta;
        let l_psi_phi = mass_phi_psi * self.inverse_phi;
        let rhs_psi = w_5
            + sin_phi * cos_phi
                * (sin_theta_squared * psi_dot * phi_dot * self.k_8
                    + cos_theta * self.k_4 * theta_dot * theta_dot)
            - rhs_theta * l_psi_theta - rhs_phi * l_psi_phi;
        let pivot_psi = mass_psi_psi - mass_theta_psi * l_psi_theta
            - mass_phi_psi * l_psi_phi;
        let psi_ddot = S::from_f64(1.0) / pivot_psi * rhs_psi;
        sim_kernel::Dynamics {
            accelerations: [
                psi_ddot,
                rhs_theta * inverse_theta - l_psi_theta * psi_ddot,
                rhs_phi * self.inverse_phi - l_psi_phi * psi_ddot,
            ],
            multipliers: [],
            power: S::from_f64(0.0),
            refused: sim_kernel::pivot_is_refused(mass_theta_theta, mass_theta_theta)
                | sim_kernel::pivot_is_refused(self.C, self.C)
                | sim_kernel::pivot_is_refused(pivot_psi, mass_psi_psi),
        }
    }
    /// The derivatives of accelerations (3 rows) and multipliers (0 rows) with respect to coordinates and speeds (3 columns each): with the equations of motion as `K z = r`, the solutions of `K dz = dr - dK z`. Where `refused` is set a pivot was too small and nothing else holds.
    ///
    /// Operations: 105 additions, 222 multiplications, 2 divisions, 2 sine-cosine pairs.
    #[inline]
    pub fn dynamics_jacobian(
        &self,
        t: S,
        q: &[S; 3],
        qd: &[S; 3],
    ) -> sim_kernel::DynamicsJacobian<S, [[S; 3]; 3], [[S; 3]; 0]> {
        let [_, theta, phi] = *q;
        let [psi_dot, theta_dot, phi_dot] = *qd;
        let ([sin_theta, sin_phi], [cos_theta, cos_phi]) = S::sin_cos_each([theta, phi]);
        let sin_phi_squared = sin_phi * sin_phi;
        let cos_phi_squared = cos_phi * cos_phi;
        let w = self.A * sin_phi_squared + self.B * cos_phi_squared;
        let w_2 = w - self.C;
        let w_3 = sin_phi_squared * self.k_9;
        let w_4 = cos_phi * theta_dot;
        let rhs_theta = sin_theta
            * (cos_theta * psi_dot * psi_dot * w_2
                + psi_dot * phi_dot * (w_3 + self.k_11))
            + sin_phi * phi_dot * w_4 * self.k_9;
        let w_5 = psi_dot * theta_dot;
        let w_6 = sin_theta * self.C;
        let w_7 = w_5 * w_6;
        let w_8 = sin_theta * cos_phi;
        let w_y = psi_dot * w_8 - sin_phi * theta_dot;
        let w_9 = sin_theta * sin_phi;
        let w_x = w_4 + w_9 * psi_dot;
        let w_10 = w_y * w_x;
        let rhs_phi = w_7 + self.k * w_10;
        let w_11 = sin_theta * theta_dot
            * (cos_theta * psi_dot
                * (self.k_7 - sin_phi_squared * self.k_6 - cos_phi_squared * self.k_5)
                + phi_dot * (self.k_10 + w_3));
        let mass_theta_theta = self.A * cos_phi_squared + sin_phi_squared * self.B;
        let w_39 = sin_theta * (self.k_4 + w_3);
        let sin_theta_squared = sin_theta * sin_theta;
        let mass_psi_psi = sin_theta_squared * w + self.C * cos_theta * cos_theta;
        let w_12 = cos_phi * self.k;
        let mass_theta_psi = w_9 * w_12;
        let inverse_theta = S::from_f64(1.0) / mass_theta_theta;
        let l_psi_theta = mass_theta_psi * inverse_theta;
        let mass_phi_psi = self.C * cos_theta;
        let l_psi_phi = mass_phi_psi * self.inverse_phi;
        let pivot_psi = mass_psi_psi - mass_theta_psi * l_psi_theta
            - mass_phi_psi * l_psi_phi;
        let inverse_psi = S::from_f64(1.0) / pivot_psi;
        let psi_ddot = inverse_psi
            * (w_11
                + sin_phi * cos_phi
                    * (sin_theta_squared * psi_dot * phi_dot * self.k_8
                        + cos_theta * self.k_4 * theta_dot * theta_dot)
                - rhs_theta * l_psi_theta - rhs_phi * l_psi_phi);
        let theta_ddot = rhs_theta * inverse_theta - l_psi_theta * psi_ddot;
        let w_13 = cos_theta * psi_dot;
        let w_z = phi_dot + w_13;
        let w_14 = w_z * self.k_2;
        let w_15 = cos_phi * cos_theta;
        let w_16 = psi_dot * (w_14 * w_15 + sin_theta * w_y * self.k_12)
            + self.A * psi_dot * (phi_dot * w_15 - w_9 * theta_dot);
        let w_44 = self.k_3 * (w_9 * w_z + cos_theta * w_x)
            - self.B * (w_9 * phi_dot - cos_theta * w_4);
        let w_17 = sin_phi * cos_theta;
        let w_21 = w_y * phi_dot + w_17 * w_5;
        let w_43 = self.k_2 * (w_8 * w_z + cos_theta * w_y)
            + self.A * (w_8 * phi_dot + theta_dot * w_17);
        let w_18 = w_z * self.k_3;
        let w_36 = w_y * w_z * self.k_13 + self.B * w_21;
        let w_22 = w_y * w_14 + self.A * w_21;
        let w_19 = psi_dot * (w_17 * w_18 + sin_theta * w_x * self.k_13)
            - self.B * psi_dot * (phi_dot * w_17 + sin_theta * w_4);
        let w_20 = sin_theta
            * (self.k_4 * w_10 - w_7 - sin_phi * w_16 - cos_phi * w_19
                + self.C * (rhs_phi * self.inverse_phi - l_psi_phi * psi_ddot));
        let w_23 = phi_dot * w_x - w_13 * w_4;
        let w_48 = w_13 - phi_dot;
        let w_29 = w_12 * w_17;
        let w_31 = sin_phi * w_19 - cos_phi * w_16 - psi_ddot * w_29;
        let w_24 = w_x * w_18 - self.B * w_23;
        let w_35 = w_14 * w_x + self.A * w_23;
        let w_49 = sin_phi * w_14 - self.A * sin_phi * w_48;
        let w_50 = cos_phi * w_18 + self.B * cos_phi * w_48;
        let w_25 = sin_phi * w_y + cos_phi * w_x;
        let w_26 = self.C * theta_dot;
        let w_27 = self.k_4 * w_25 - w_26;
        let w_32 = w_26 + self.k * w_25;
        let w_28 = S::from_f64(2.0) * psi_ddot;
        let w_30 = w_20
            - cos_theta * (sin_phi * w_22 + cos_phi * w_24 + cos_theta * psi_dot * w_27)
            - sin_theta * cos_theta * w_2 * w_28 - theta_ddot * w_29;
        let w_33 = cos_theta * psi_dot * w_32 + w_6 * psi_ddot;
        let w_34 = inverse_psi * (w_30 - l_psi_theta * w_31 - l_psi_phi * w_33);
        let w_46 = sin_theta * w_32;
        let w_52 = psi_dot * w_6;
        let w_37 = sin_theta
            * (sin_phi * w_24 - cos_phi * w_22 + sin_phi * w_35 + cos_phi * w_36);
        let w_x_squared = w_x * w_x;
        let w_y_squared = w_y * w_y;
        let w_38 = sin_phi * w_12;
        let w_40 = sin_phi * (w_22 - w_36) + cos_phi * (w_24 + w_35) + psi_ddot * w_39
            + S::from_f64(2.0) * theta_ddot * w_38;
        let w_41 = self.k_4 * w_x_squared + self.k * w_y_squared;
        let w_42 = inverse_psi
            * (w_37 - cos_theta * (self.k * w_x_squared + self.k_4 * w_y_squared)
                - w_28 * sin_theta_squared * w_38 + theta_ddot * w_39
                - l_psi_theta * w_40 - l_psi_phi * w_41);
        let w_45 = sin_phi * w_44 - cos_phi * w_43;
        let w_47 = inverse_psi
            * (sin_theta * (sin_phi * w_43 + cos_phi * w_44)
                + cos_theta * sin_theta * w_27 + l_psi_theta * w_45 + l_psi_phi * w_46);
        let w_51 = sin_phi * w_x;
        let w_54 = w_52 + w_12 * w_y + self.k_4 * w_51;
        let w_58 = w_x * self.k_15;
        let w_53 = cos_phi * w_49 + sin_phi * w_50;
        let w_55 = sin_theta * (sin_phi * w_49 - cos_phi * w_50)
            - cos_theta * (cos_phi * w_y * self.k_4 + self.k * w_51 - w_52)
            - l_psi_theta * w_53 - l_psi_phi * w_54;
        let w_56 = inverse_psi * w_55;
        let w_57 = w_y * self.k_14;
        let w_59 = cos_phi * w_57 + sin_phi * w_58;
        let w_60 = inverse_psi
            * (sin_theta * (sin_phi * w_57 - cos_phi * w_58) - l_psi_theta * w_59);
        sim_kernel::DynamicsJacobian {
            accelerations_by_positions: [
                [S::from_f64(0.0), w_34, w_42],
                [
                    S::from_f64(0.0),
                    inverse_theta * w_31 - l_psi_theta * w_34,
                    inverse_theta * w_40 - l_psi_theta * w_42,
                ],
                [
                    S::from_f64(0.0),
                    self.inverse_phi * w_33 - l_psi_phi * w_34,
                    self.inverse_phi * w_41 - l_psi_phi * w_42,
                ],
            ],
            accelerations_by_speeds: [
                [-w_47, w_56, w_60],
                [
                    inverse_theta * w_45 + l_psi_theta * w_47,
                    inverse_theta * w_53 - l_psi_theta * w_56,
                    inverse_theta * w_59 - l_psi_theta * w_60,
                ],
                [
                    self.inverse_phi * w_46 + l_psi_phi * w_47,
                    self.inverse_phi * w_54 - l_psi_phi * w_56,
                    -(l_psi_phi * w_60),
                ],
            ],
            multipliers_by_positions: [],
            multipliers_by_speeds: [],
            refused: sim_kernel::pivot_is_refused(mass_theta_theta, mass_theta_theta)
                | sim_kernel::pivot_is_refused(self.C, self.C)
                | sim_kernel::pivot_is_refused(pivot_psi, mass_psi_psi),
        }
    }
}
#[allow(non_snake_case, clippy::all, clippy::pedantic)]
impl<S: sim_kernel::Scalar> sim_kernel::Mechanism<S> for Tumbling<S> {
    type Q = [S; 3];
    type L = [S; 0];
    type Z = [S; 3];
    type QQ = [[S; 3]; 3];
    type LQ = [[S; 3]; 0];
    type LL = [[S; 0]; 0];
    type ZZ = [[S; 3]; 3];
    type Entries = [S; 0];
    type Envelope = [S; 0];
    type Parameters = [S; 5];
    type Outputs = [S; 7];
    type OutputRates = [S; 7];
    type Events = [S; 0];
    type EventValues = [S; 0];
    type Activities = [S; 0];
    type Drawing = [S; 30];
    type QP = [[S; 5]; 3];
    type LP = [[S; 5]; 0];
    type Inputs = [sim_kernel::Input<S>; 0];
    type Prepared = TumblingPrepared<S>;
    type On<T: sim_kernel::Scalar> = Tumbling<T>;
    const DESCRIPTION: sim_kernel::Description = sim_kernel::Description {
        name: "tumbling",
        type_name: "Tumbling",
        docs: "A free rigid body that tumbles, by Euler's angles.",
        declaration: "/// A free rigid body that tumbles, by Euler's angles.\npub Tumbling;\n\ncoordinates {\n    /// Precession about the angular momentum.\n    psi [rad];\n    /// Nutation: angle between the third axis of the body and the angular momentum.\n    theta [rad];\n    /// Spin about the third axis.\n    phi [rad];\n}\n\nparameters {\n    /// Principal moments of inertia.\n    A [kg*m^2] = 1;\n    B [kg*m^2] = 2;\n    C [kg*m^2] = 3;\n    /// Angular momentum.\n    H [N*m*s] = 6;\n    /// Nutation at the start.\n    theta0 [deg] = 28;\n}\n\nlet R = euler(zxz, psi, theta, phi);\nlet w = transpose(R)*omega(body);\n\nbodies { body: inertia [A, B, C], attitude R; }\n\ninitial {\n    psi = 0;\n    theta = theta0;\n    phi = 90 [deg];\n    dot(psi) = H/A;\n    dot(theta) = 0;\n    dot(phi) = H*cos(theta0)*(1/C - 1/A);\n}\n\noutputs {\n    angular_velocity \"Angular velocity in the frame of the body\" {\n        /// about the axis of least inertia\n        w1 [rad/s] = w.x;\n        /// about the intermediate axis\n        w2 [rad/s] = w.y;\n        /// about the axis of most inertia\n        w3 [rad/s] = w.z;\n    }\n    angular_momentum \"Angular momentum in the world\" {\n        Hx [N*m*s] = (R*[A*w.x, B*w.y, C*w.z]).x;\n        Hy [N*m*s] = (R*[A*w.x, B*w.y, C*w.z]).y;\n        Hz [N*m*s] = (R*[A*w.x, B*w.y, C*w.z]).z;\n    }\n    /// kinetic energy\n    energy [J] = (A*w.x^2 + B*w.y^2 + C*w.z^2)/2;\n}\n\ndrawing {\n    line R*[1 [m], 0, 0], R*[0, 0.7 [m], 0], R*[-1 [m], 0, 0], R*[0, -0.7 [m], 0], R*[1 [m], 0, 0];\n    line R*[0, 0, -0.3 [m]], R*[0, 0, 0.5 [m]];\n    curve [0, 0, 0], [0, 0, 1.2 [m]];\n    point [0, 0, 0];\n}\n",
        coordinates: &[
            sim_kernel::Coordinate {
                position: sim_kernel::Quantity {
                    name: "psi",
                    unit: "rad",
                    factor: 1f64,
                    is_length: false,
                    docs: "Precession about the angular momentum.",
                },
                speed: sim_kernel::Quantity {
                    name: "psi_dot",
                    unit: "rad/s",
                    factor: 1f64,
                    is_length: false,
                    docs: "",
                },
                acceleration: sim_kernel::Quantity {
                    name: "psi_ddot",
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
                    name: "theta",
                    unit: "rad",
                    factor: 1f64,
                    is_length: false,
                    docs: "Nutation: angle between the third axis of the body and the angular momentum.",
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
                    docs: "Spin about the third axis.",
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
                name: "A",
                unit: "kg*m^2",
                factor: 1f64,
                is_length: false,
                docs: "Principal moments of inertia.",
            },
            sim_kernel::Quantity {
                name: "B",
                unit: "kg*m^2",
                factor: 1f64,
                is_length: false,
                docs: "",
            },
            sim_kernel::Quantity {
                name: "C",
                unit: "kg*m^2",
                factor: 1f64,
                is_length: false,
                docs: "",
            },
            sim_kernel::Quantity {
                name: "H",
                unit: "N*m*s",
                factor: 1f64,
                is_length: false,
                docs: "Angular momentum.",
            },
            sim_kernel::Quantity {
                name: "theta0",
                unit: "deg",
                factor: 0.017453292519943295f64,
                is_length: false,
                docs: "Nutation at the start.",
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
                name: "w1",
                unit: "rad/s",
                factor: 1f64,
                is_length: false,
                docs: "about the axis of least inertia",
            },
            sim_kernel::Quantity {
                name: "w2",
                unit: "rad/s",
                factor: 1f64,
                is_length: false,
                docs: "about the intermediate axis",
            },
            sim_kernel::Quantity {
                name: "w3",
                unit: "rad/s",
                factor: 1f64,
                is_length: false,
                docs: "about the axis of most inertia",
            },
            sim_kernel::Quantity {
                name: "Hx",
                unit: "N*m*s",
                factor: 1f64,
                is_length: false,
                docs: "",
            },
            sim_kernel::Quantity {
                name: "Hy",
                unit: "N*m*s",
                factor: 1f64,
                is_length: false,
                docs: "",
            },
            sim_kernel::Quantity {
                name: "Hz",
                unit: "N*m*s",
                factor: 1f64,
                is_length: false,
                docs: "",
            },
            sim_kernel::Quantity {
                name: "energy",
                unit: "J",
                factor: 1f64,
                is_length: false,
                docs: "kinetic energy",
            },
        ],
        rated_outputs: &[0, 1, 2, 3, 4, 5, 6],
        figures: &[
            sim_kernel::Figure {
                name: "angular_velocity",
                title: "Angular velocity in the frame of the body",
                len: 3,
            },
            sim_kernel::Figure {
                name: "angular_momentum",
                title: "Angular momentum in the world",
                len: 3,
            },
            sim_kernel::Figure {
                name: "energy",
                title: "kinetic energy",
                len: 1,
            },
        ],
        optional_kernels: &["dynamics_jacobian"],
        dimension: 3,
        drawing: &[
            sim_kernel::Shape::Line(5),
            sim_kernel::Shape::Line(2),
            sim_kernel::Shape::Curve(2),
            sim_kernel::Shape::Points(1),
        ],
    };
    fn defaults() -> Self {
        Self {
            A: S::from_f64(1f64),
            B: S::from_f64(2f64),
            C: S::from_f64(3f64),
            H: S::from_f64(6f64),
            theta0: S::from_f64(0.4886921905584123f64),
        }
    }
    fn parameters(&self) -> [S; 5] {
        [self.A, self.B, self.C, self.H, self.theta0]
    }
    fn with_parameters(&self, parameters: [S; 5]) -> Self {
        Self {
            A: parameters[0],
            B: parameters[1],
            C: parameters[2],
            H: parameters[3],
            theta0: parameters[4],
            ..*self
        }
    }
    fn on<T: sim_kernel::Scalar>(
        &self,
        convert: impl ::core::ops::Fn(S) -> T,
    ) -> Tumbling<T> {
        Tumbling {
            A: convert(self.A),
            B: convert(self.B),
            C: convert(self.C),
            H: convert(self.H),
            theta0: convert(self.theta0),
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
    fn prepare(&self) -> TumblingPrepared<S> {
        self.prepare()
    }
    #[inline(always)]
    fn prepared_dynamics(
        prepared: &Self::Prepared,
        t: S,
        q: &[S; 3],
        qd: &[S; 3],
    ) -> sim_kernel::Dynamics<S, [S; 3], [S; 0]> {
        prepared.dynamics(t, q, qd)
    }
    #[inline(always)]
    fn dynamics_jacobian(
        &self,
        t: S,
        q: &[S; 3],
        qd: &[S; 3],
    ) -> sim_kernel::DynamicsJacobian<S, [[S; 3]; 3], [[S; 3]; 0]> {
        self.prepare().dynamics_jacobian(t, q, qd)
    }
    #[inline(always)]
    fn mass_matrix(&self, t: S, q: &[S; 3]) -> [[S; 3]; 3] {
        self.mass_matrix(t, q)
    }
    #[inline(always)]
    fn convective_forces(&self, t: S, q: &[S; 3], qd: &[S; 3]) -> [S; 3] {
        self.convective_forces(t, q, qd)
    }
    #[inline(always)]
    fn generalized_forces(&self, t: S, q: &[S; 3], qd: &[S; 3]) -> [S; 3] {
        self.generalized_forces(t, q, qd)
    }
    #[inline(always)]
    fn constraints(&self, t: S, q: &[S; 3]) -> [S; 0] {
        self.constraints(t, q)
    }
    #[inline(always)]
    fn constraint_magnitudes(&self, t: S, q: &[S; 3]) -> [S; 0] {
        self.constraint_magnitudes(t, q)
    }
    #[inline(always)]
    fn constraint_jacobian(&self, t: S, q: &[S; 3]) -> [[S; 3]; 0] {
        self.constraint_jacobian(t, q)
    }
    #[inline(always)]
    fn constraint_time_derivative(&self, t: S, q: &[S; 3]) -> [S; 0] {
        self.constraint_time_derivative(t, q)
    }
    #[inline(always)]
    fn constraint_convective(&self, t: S, q: &[S; 3], qd: &[S; 3]) -> [S; 0] {
        self.constraint_convective(t, q, qd)
    }
    #[inline(always)]
    fn constraint_linearization(
        &self,
        t: S,
        q: &[S; 3],
    ) -> sim_kernel::ConstraintLinearization<[S; 0], [[S; 3]; 0]> {
        self.constraint_linearization(t, q)
    }
    #[inline(always)]
    fn kinetic_energy(&self, t: S, q: &[S; 3], qd: &[S; 3]) -> S {
        self.kinetic_energy(t, q, qd)
    }
    #[inline(always)]
    fn power(&self, t: S, q: &[S; 3], qd: &[S; 3], qdd: &[S; 3], lambda: &[S; 0]) -> S {
        self.power(t, q, qd, qdd, lambda)
    }
    #[inline(always)]
    fn outputs(
        &self,
        t: S,
        q: &[S; 3],
        qd: &[S; 3],
        qdd: &[S; 3],
        lambda: &[S; 0],
    ) -> [S; 7] {
        self.outputs(t, q, qd, qdd, lambda).into()
    }
    #[inline(always)]
    fn output_rates(&self, t: S, q: &[S; 3], qd: &[S; 3], qdd: &[S; 3]) -> [S; 7] {
        self.output_rates(t, q, qd, qdd).into()
    }
    #[inline(always)]
    fn events(
        &self,
        t: S,
        q: &[S; 3],
        qd: &[S; 3],
        qdd: &[S; 3],
        lambda: &[S; 0],
    ) -> [S; 0] {
        self.events(t, q, qd, qdd, lambda)
    }
    #[inline(always)]
    fn drawing(&self, t: S, q: &[S; 3]) -> [S; 30] {
        self.drawing(t, q)
    }
    #[inline(always)]
    fn initial(&self) -> sim_kernel::Initial<[S; 3]> {
        self.initial()
    }
}
