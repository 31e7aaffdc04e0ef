/// A crank drives a rocker on another axis by a coupler with two ball joints.
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
/// coordinates = [phi; psi]
/// multipliers = [lambda_coupling]
/// constraints = 0
/// [
///     a^2*m/4 + 0.02, a*b*m*sin(phi)*cos(psi)/4, s_3*sqrt(s_1)/s_1;
///     a*b*m*sin(phi)*cos(psi)/4, 7*b^2*m/12, -s_4*sqrt(s_1)/s_1;
///     s_3*sqrt(s_1)/s_1, -s_4*sqrt(s_1)/s_1, 0
/// ] * [phi_ddot; psi_ddot; lambda_coupling] = [
///     -convective_forces[1];
///     -b*m*g*sin(psi) - convective_forces[2];
///     -constraint_convective[1]
/// ]
///
/// mass_matrix = [
///     a^2*m/4 + 0.02, a*b*m*sin(phi)*cos(psi)/4;
///     a*b*m*sin(phi)*cos(psi)/4, 7*b^2*m/12
/// ]
///
/// convective_forces = [convective_forces[1]; convective_forces[2]]
/// convective_forces[1] = a*m*s_2*sin(phi)/4 - a^2*m*phi_dot^2*cos(phi)*sin(phi)/4
/// convective_forces[2] = b*m*s_2*cos(psi)/4 + b^2*m*psi_dot^2*sin(psi)*cos(psi)/4
///
/// generalized_forces = [0; -b*m*g*sin(psi)]
///
/// constraints = [sqrt(s_1) - c]
///
/// constraint_jacobian = [s_3*sqrt(s_1)/s_1, -s_4*sqrt(s_1)/s_1]
///
/// constraint_convective = [constraint_convective[1]]
/// constraint_convective[1] = s_7*phi_dot*sqrt(s_1)/s_1 - s_3*s_6*phi_dot*sqrt(s_1)/s_1^2
///     + s_4*s_6*psi_dot*sqrt(s_1)/s_1^2 - s_8*psi_dot*sqrt(s_1)/s_1
///
/// A_x = a*cos(phi)
/// B_z = dz - b*cos(psi)
/// s_1 = (dx - A_x - b*sin(psi))^2 + a^2*sin(phi)^2 + B_z^2
/// s_2 = a*phi_dot^2*cos(phi) - b*psi_dot^2*sin(psi)
/// s_3 = a*(dx - A_x - b*sin(psi))*sin(phi) + a^2*cos(phi)*sin(phi)
/// s_4 = b*(dx - A_x - b*sin(psi))*cos(psi) - b*B_z*sin(psi)
/// s_5 = a*phi_dot*sin(phi) - b*psi_dot*cos(psi)
/// s_6 = s_5*(dx - A_x - b*sin(psi)) + a^2*phi_dot*cos(phi)*sin(phi) + b*B_z*psi_dot*sin(psi)
/// s_7 = a*phi_dot*(dx - A_x - b*sin(psi))*cos(phi) + a*s_5*sin(phi) - 2*a^2*phi_dot*sin(phi)^2
///     + a^2*phi_dot
/// s_8 = b*s_5*cos(psi) - b*psi_dot*(dx - A_x - b*sin(psi))*sin(psi) - b*B_z*psi_dot*cos(psi)
///     - b^2*psi_dot*sin(psi)^2
/// ```
#[allow(non_snake_case)]
#[derive(
    ::core::clone::Clone,
    ::core::marker::Copy,
    ::core::fmt::Debug,
    ::core::cmp::PartialEq
)]
pub struct Rssr<S = ::core::primitive::f64> {
    /// Crank, in `m`.
    pub a: S,
    /// Coupler, in `m`.
    pub c: S,
    /// Rocker, in `m`.
    pub b: S,
    /// Place of the rocker's axis, in `m`.
    pub dx: S,
    /// In `m`.
    pub dz: S,
    /// In `kg`.
    pub m: S,
    /// In `m/s^2`.
    pub g: S,
    /// Speed of the crank at the start, in `1/s`.
    pub speed: S,
}
impl<S: sim_kernel::Scalar> ::core::default::Default for Rssr<S> {
    /// The declared values.
    fn default() -> Self {
        <Self as sim_kernel::Mechanism<S>>::defaults()
    }
}
/// Coordinates of [`Rssr`] by name, in SI units; also for their speeds and accelerations.
#[allow(non_snake_case)]
#[derive(
    ::core::clone::Clone,
    ::core::marker::Copy,
    ::core::fmt::Debug,
    ::core::cmp::PartialEq
)]
pub struct RssrCoordinates<S = ::core::primitive::f64> {
    /// Turn of the crank, about the vertical, in `rad`.
    pub phi: S,
    /// Swing of the rocker, about an axis along y, in `rad`.
    pub psi: S,
}
impl<S: sim_kernel::Scalar> ::core::convert::From<[S; 2]> for RssrCoordinates<S> {
    fn from(values: [S; 2]) -> Self {
        Self {
            phi: values[0],
            psi: values[1],
        }
    }
}
impl<S: sim_kernel::Scalar> ::core::convert::From<RssrCoordinates<S>> for [S; 2] {
    fn from(record: RssrCoordinates<S>) -> Self {
        [record.phi, record.psi]
    }
}
/// Outputs of [`Rssr`] by name, in SI units.
#[allow(non_snake_case)]
#[derive(
    ::core::clone::Clone,
    ::core::marker::Copy,
    ::core::fmt::Debug,
    ::core::cmp::PartialEq
)]
pub struct RssrOutputs<S = ::core::primitive::f64> {
    /// swing of the rocker, in `1`.
    pub swing: S,
    /// force in the coupler, positive in tension, in `N`.
    pub coupler_force: S,
}
impl<S: sim_kernel::Scalar> ::core::convert::From<[S; 2]> for RssrOutputs<S> {
    fn from(values: [S; 2]) -> Self {
        Self {
            swing: values[0],
            coupler_force: values[1],
        }
    }
}
impl<S: sim_kernel::Scalar> ::core::convert::From<RssrOutputs<S>> for [S; 2] {
    fn from(record: RssrOutputs<S>) -> Self {
        [record.swing, record.coupler_force]
    }
}
/// Rates of the outputs of [`Rssr`] by name, in SI units.
#[allow(non_snake_case)]
#[derive(
    ::core::clone::Clone,
    ::core::marker::Copy,
    ::core::fmt::Debug,
    ::core::cmp::PartialEq
)]
pub struct RssrOutputRates<S = ::core::primitive::f64> {
    /// Rate of `swing`.
    pub swing: S,
}
impl<S: sim_kernel::Scalar> ::core::convert::From<[S; 1]> for RssrOutputRates<S> {
    fn from(values: [S; 1]) -> Self {
        Self { swing: values[0] }
    }
}
impl<S: sim_kernel::Scalar> ::core::convert::From<RssrOutputRates<S>> for [S; 1] {
    fn from(record: RssrOutputRates<S>) -> Self {
        [record.swing]
    }
}
/// What the equations of motion need of the parameters of [`Rssr`], from [`Rssr::prepare`]; its methods are the kernels of each step.
#[allow(non_snake_case)]
#[derive(
    ::core::clone::Clone,
    ::core::marker::Copy,
    ::core::fmt::Debug,
    ::core::cmp::PartialEq
)]
pub struct RssrPrepared<S = ::core::primitive::f64> {
    a: S,
    a_squared: S,
    k: S,
    mass_phi_phi: S,
    b: S,
    k_2: S,
    b_squared: S,
    mass_psi_psi: S,
    dx: S,
    dz: S,
    k_3: S,
    k_4: S,
    k_5: S,
    k_6: S,
    k_7: S,
    k_8: S,
    k_9: S,
    k_10: S,
    inverse_phi: S,
    k_11: S,
    k_12: S,
    k_13: S,
}
#[allow(non_snake_case, unused_variables, unused_parens, clippy::all, clippy::pedantic)]
impl<S: sim_kernel::Scalar> Rssr<S> {
    /// What the equations of motion need of the parameters, computed once for a set of parameters.
    ///
    /// Operations: 1 addition, 20 multiplications, 1 division.
    #[inline]
    pub fn prepare(&self) -> RssrPrepared<S> {
        let a_squared = self.a * self.a;
        let w = S::from_f64(0.25) * self.m;
        let w_2 = a_squared * w;
        let mass_phi_phi = w_2 + S::from_f64(0.02);
        let w_3 = self.m * self.b;
        let w_4 = S::from_f64(0.25) * w_3;
        let b_squared = self.b * self.b;
        let w_5 = w_3 * S::from_f64(0.5);
        RssrPrepared {
            a: self.a,
            a_squared: a_squared,
            k: w_2,
            mass_phi_phi: mass_phi_phi,
            b: self.b,
            k_2: self.a * w_4,
            b_squared: b_squared,
            mass_psi_psi: self.m * S::from_f64(0.5833333333333334) * b_squared,
            dx: self.dx,
            dz: self.dz,
            k_3: self.a * w,
            k_4: self.m * self.g * S::from_f64(2.0),
            k_5: w_3,
            k_6: w_4,
            k_7: self.g * w_5,
            k_8: S::from_f64(0.25) * self.b,
            k_9: w_3 * self.g,
            k_10: a_squared * S::from_f64(2.0),
            inverse_phi: S::from_f64(1.0) / mass_phi_phi,
            k_11: self.a * self.b,
            k_12: w * b_squared,
            k_13: self.a * w_5,
        }
    }
    /// Mass matrix `T_q' M T_q`, 2 x 2, symmetric, in SI units.
    ///
    /// Operations: 1 addition, 10 multiplications, 2 sine-cosine pairs.
    #[inline]
    pub fn mass_matrix(&self, t: S, q: &[S; 2]) -> [[S; 2]; 2] {
        let [phi, psi] = *q;
        let w = S::from_f64(0.25) * self.m;
        let ([sin_phi, _], [_, cos_psi]) = S::sin_cos_each([phi, psi]);
        let mass_psi_phi = sin_phi * cos_psi * self.a * w * self.b;
        [
            [self.a * self.a * w + S::from_f64(0.02), mass_psi_phi],
            [mass_psi_phi, self.m * S::from_f64(0.5833333333333334) * self.b * self.b],
        ]
    }
    /// Convective forces `T_q' M g`, 2, with `g = (T_q q' + T_t)_q q' + (..)_t`: joules per unit of each coordinate.
    ///
    /// Operations: 1 addition, 11 multiplications, 2 sine-cosine pairs.
    #[inline]
    pub fn convective_forces(&self, t: S, q: &[S; 2], qd: &[S; 2]) -> [S; 2] {
        let [phi, psi] = *q;
        let [phi_dot, psi_dot] = *qd;
        let ([sin_phi, sin_psi], [cos_phi, cos_psi]) = S::sin_cos_each([phi, psi]);
        let w = S::from_f64(0.25) * self.a * self.m * self.b;
        [
            -(sin_phi * psi_dot * psi_dot * sin_psi * w),
            phi_dot * phi_dot * cos_phi * w * cos_psi,
        ]
    }
    /// Generalised forces `T_q' F`, 2: joules per unit of each coordinate.
    ///
    /// Operations: 1 addition, 3 multiplications, 1 sine-cosine pair.
    #[inline]
    pub fn generalized_forces(&self, t: S, q: &[S; 2], qd: &[S; 2]) -> [S; 2] {
        let [_, psi] = *q;
        let ([sin_psi], [_]) = S::sin_cos_each([psi]);
        [S::from_f64(0.0), -(sin_psi * self.b * self.m * self.g)]
    }
    /// Constraints `C`, 1, in SI units; zero throughout the motion.
    ///
    /// Operations: 6 additions, 8 multiplications, 2 sine-cosine pairs, 1 square root.
    #[inline]
    pub fn constraints(&self, t: S, q: &[S; 2]) -> [S; 1] {
        let [phi, psi] = *q;
        let ([sin_phi, sin_psi], [cos_phi, cos_psi]) = S::sin_cos_each([phi, psi]);
        let w = self.dx - self.a * cos_phi - self.b * sin_psi;
        let B_z = self.dz - self.b * cos_psi;
        [(w * w + B_z * B_z + self.a * self.a * sin_phi * sin_phi).sqrt() - self.c]
    }
    /// The sum of the magnitudes of the terms of `C`, 1, in SI units: what its rounding is relative to.
    ///
    /// Operations: 8 additions, 8 multiplications, 2 sine-cosine pairs, 1 square root.
    #[inline]
    pub fn constraint_magnitudes(&self, t: S, q: &[S; 2]) -> [S; 1] {
        let [phi, psi] = *q;
        let ([sin_phi, sin_psi], [cos_phi, cos_psi]) = S::sin_cos_each([phi, psi]);
        let w = self.dx - self.a * cos_phi - self.b * sin_psi;
        let B_z = self.dz - self.b * cos_psi;
        [
            self.c.abs()
                + (w * w + B_z * B_z + self.a * self.a * sin_phi * sin_phi).sqrt().abs(),
        ]
    }
    /// Constraint Jacobian `C_q`, 1 x 2: units of each constraint per unit of each coordinate.
    ///
    /// Operations: 8 additions, 16 multiplications, 2 divisions, 2 sine-cosine pairs, 1 square root.
    #[inline]
    pub fn constraint_jacobian(&self, t: S, q: &[S; 2]) -> [[S; 2]; 1] {
        let [phi, psi] = *q;
        let ([sin_phi, sin_psi], [cos_phi, cos_psi]) = S::sin_cos_each([phi, psi]);
        let w = self.dx - self.a * cos_phi - self.b * sin_psi;
        let B_z = self.dz - self.b * cos_psi;
        let a_squared = self.a * self.a;
        let w_2 = w * w + B_z * B_z + a_squared * sin_phi * sin_phi;
        let sqrt_w_2 = w_2.sqrt();
        [
            [
                sqrt_w_2 * sin_phi * (self.a * w + a_squared * cos_phi) / w_2,
                -(sqrt_w_2 * self.b * (cos_psi * w - sin_psi * B_z) / w_2),
            ],
        ]
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
    /// Operations: 19 additions, 44 multiplications, 4 divisions, 2 sine-cosine pairs, 1 square root.
    #[inline]
    pub fn constraint_convective(&self, t: S, q: &[S; 2], qd: &[S; 2]) -> [S; 1] {
        let [phi, psi] = *q;
        let [phi_dot, psi_dot] = *qd;
        let ([sin_phi, sin_psi], [cos_phi, cos_psi]) = S::sin_cos_each([phi, psi]);
        let w = self.a * cos_phi;
        let w_2 = self.b * sin_psi;
        let w_3 = self.dx - w - w_2;
        let B_z = self.dz - self.b * cos_psi;
        let a_squared = self.a * self.a;
        let sin_phi_squared = sin_phi * sin_phi;
        let w_4 = w_3 * w_3 + B_z * B_z + a_squared * sin_phi_squared;
        let w_5 = phi_dot * self.a * sin_phi - self.b * cos_psi * psi_dot;
        let w_6 = (phi_dot
            * (a_squared + w * w_3 - sin_phi_squared * a_squared * S::from_f64(2.0))
            + self.a * sin_phi * w_5) / w_4;
        let w_7 = cos_phi * a_squared;
        let w_8 = w_3 * w_5 + phi_dot * sin_phi * w_7 + w_2 * B_z * psi_dot;
        let w_4_squared = w_4 * w_4;
        let w_9 = (self.b * (cos_psi * (w_5 - B_z * psi_dot) - sin_psi * w_3 * psi_dot)
            - psi_dot * self.b * self.b * sin_psi * sin_psi) / w_4;
        let w_10 = psi_dot
            * (w_8 * self.b * (w_3 * cos_psi - sin_psi * B_z) / w_4_squared - w_9);
        [
            w_4.sqrt()
                * (phi_dot * (w_6 - sin_phi * (self.a * w_3 + w_7) * w_8 / w_4_squared)
                    + w_10),
        ]
    }
    /// `C` (1), `C_q` (1 x 2) and `C_t` (1) together, in SI units, for projection.
    ///
    /// Operations: 9 additions, 16 multiplications, 2 divisions, 2 sine-cosine pairs, 1 square root.
    #[inline]
    pub fn constraint_linearization(
        &self,
        t: S,
        q: &[S; 2],
    ) -> sim_kernel::ConstraintLinearization<[S; 1], [[S; 2]; 1]> {
        let [phi, psi] = *q;
        let ([sin_phi, sin_psi], [cos_phi, cos_psi]) = S::sin_cos_each([phi, psi]);
        let w = self.dx - self.a * cos_phi - self.b * sin_psi;
        let B_z = self.dz - self.b * cos_psi;
        let a_squared = self.a * self.a;
        let w_2 = w * w + B_z * B_z + a_squared * sin_phi * sin_phi;
        let sqrt_w_2 = w_2.sqrt();
        sim_kernel::ConstraintLinearization {
            values: [sqrt_w_2 - self.c],
            jacobian: [
                [
                    sqrt_w_2 * sin_phi * (self.a * w + cos_phi * a_squared) / w_2,
                    -(sqrt_w_2 * self.b * (w * cos_psi - sin_psi * B_z) / w_2),
                ],
            ],
            time_derivative: [S::from_f64(0.0)],
        }
    }
    /// Kinetic energy `v' M v / 2`, in joules.
    ///
    /// Operations: 5 additions, 21 multiplications, 2 sine-cosine pairs.
    #[inline]
    pub fn kinetic_energy(&self, t: S, q: &[S; 2], qd: &[S; 2]) -> S {
        let [phi, psi] = *q;
        let [phi_dot, psi_dot] = *qd;
        let ([sin_phi, sin_psi], [cos_phi, cos_psi]) = S::sin_cos_each([phi, psi]);
        let w = S::from_f64(0.125) * self.m;
        let b_squared = self.b * self.b;
        let w_2 = psi_dot * psi_dot
            * (self.m * b_squared * S::from_f64(0.16666666666666666)
                + sin_psi * sin_psi * b_squared * w);
        let w_3 = phi_dot * self.a * sin_phi + psi_dot * self.b * cos_psi;
        phi_dot * phi_dot * (S::from_f64(0.01) + cos_phi * cos_phi * self.a * self.a * w)
            + w_2 + w_3 * w_3 * w
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
        lambda: &[S; 1],
    ) -> S {
        let [_, psi] = *q;
        let [_, psi_dot] = *qd;
        let ([sin_psi], [_]) = S::sin_cos_each([psi]);
        -(psi_dot * sin_psi * self.b * self.m * self.g)
    }
    /// Outputs, 2, in SI units.
    ///
    /// Operations: none.
    #[inline]
    pub fn outputs(
        &self,
        t: S,
        q: &[S; 2],
        qd: &[S; 2],
        qdd: &[S; 2],
        lambda: &[S; 1],
    ) -> RssrOutputs<S> {
        let [_, psi] = *q;
        let [lambda_coupling] = *lambda;
        [psi, lambda_coupling].into()
    }
    /// Rates of the outputs that depend on neither accelerations nor multipliers, 1, in SI units per second.
    ///
    /// Operations: none.
    #[inline]
    pub fn output_rates(
        &self,
        t: S,
        q: &[S; 2],
        qd: &[S; 2],
        qdd: &[S; 2],
    ) -> RssrOutputRates<S> {
        let [_, psi_dot] = *qd;
        [psi_dot].into()
    }
    /// `left - right` of each event, 1, in SI units: zero when it happens.
    ///
    /// Operations: 1 multiplication, 1 sine-cosine pair.
    #[inline]
    pub fn events(
        &self,
        t: S,
        q: &[S; 2],
        qd: &[S; 2],
        qdd: &[S; 2],
        lambda: &[S; 1],
    ) -> [S; 1] {
        let [phi, _] = *q;
        let ([w], [_]) = S::sin_cos_each([S::from_f64(0.5) * phi]);
        [w]
    }
    /// The numbers of each shape of the drawing, in metres and radians.
    ///
    /// Operations: 2 additions, 4 multiplications, 2 sine-cosine pairs.
    #[inline]
    pub fn drawing(&self, t: S, q: &[S; 2]) -> [S; 31] {
        let [phi, psi] = *q;
        let ([sin_phi, sin_psi], [cos_phi, cos_psi]) = S::sin_cos_each([phi, psi]);
        let A_x = self.a * cos_phi;
        let A_y = self.a * sin_phi;
        let B_x = self.dx - self.b * sin_psi;
        let B_z = self.dz - self.b * cos_psi;
        [
            S::from_f64(0.0),
            S::from_f64(0.0),
            S::from_f64(0.0),
            self.dx,
            S::from_f64(0.0),
            self.dz,
            S::from_f64(0.0),
            S::from_f64(0.0),
            S::from_f64(0.0),
            A_x,
            A_y,
            S::from_f64(0.0),
            A_x,
            A_y,
            S::from_f64(0.0),
            B_x,
            S::from_f64(0.0),
            B_z,
            B_x,
            S::from_f64(0.0),
            B_z,
            self.dx,
            S::from_f64(0.0),
            self.dz,
            S::from_f64(0.0),
            S::from_f64(0.0),
            S::from_f64(0.0),
            self.a,
            S::from_f64(0.0),
            S::from_f64(0.0),
            S::from_f64(1.0),
        ]
    }
    /// Declared start: values or guesses of the coordinates (2), and speeds (2), in SI units; 0 where nothing is declared.
    ///
    /// Operations: none.
    #[inline]
    pub fn initial(&self) -> sim_kernel::Initial<[S; 2]> {
        sim_kernel::Initial {
            positions: [S::from_f64(0.0), S::from_f64(0.3)],
            speeds: [self.speed, S::from_f64(0.0)],
        }
    }
    /// [`RssrPrepared::dynamics`] once; for many calls with the same parameters [`Self::prepare`] first.
    #[inline]
    pub fn dynamics(
        &self,
        t: S,
        q: &[S; 2],
        qd: &[S; 2],
    ) -> sim_kernel::Dynamics<S, [S; 2], [S; 1]> {
        self.prepare().dynamics(t, q, qd)
    }
    /// [`RssrPrepared::dynamics_jacobian`] once; for many calls with the same parameters [`Self::prepare`] first.
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
impl<S: sim_kernel::Scalar> RssrPrepared<S> {
    /// Accelerations (2), multipliers (1) and power, from
    ///
    /// ```text
    /// [ T_q' M T_q   C_q' ] [ q''    ]   [ T_q' (F - M g)                      ]
    /// [ C_q          0    ] [ lambda ] = [ -(C_q q' + C_t)_q q' - (..)_t       ]
    /// ```
    ///
    /// by an elimination planned from the structure of the system. Where `refused` is set a pivot was too small and nothing else holds: solve that state from the other kernels.
    ///
    /// Operations: 31 additions, 71 multiplications, 8 divisions, 2 sine-cosine pairs, 1 square root.
    #[inline(always)]
    pub fn dynamics(
        &self,
        t: S,
        q: &[S; 2],
        qd: &[S; 2],
    ) -> sim_kernel::Dynamics<S, [S; 2], [S; 1]> {
        let [phi, psi] = *q;
        let [phi_dot, psi_dot] = *qd;
        let ([sin_phi, sin_psi], [cos_phi, cos_psi]) = S::sin_cos_each([phi, psi]);
        let w = sin_phi * self.k_2;
        let rhs_phi = w * sin_psi * psi_dot * psi_dot;
        let mass_psi_phi = cos_psi * w;
        let l_psi_phi = mass_psi_phi * self.inverse_phi;
        let pivot_psi = self.mass_psi_psi - mass_psi_phi * l_psi_phi;
        let inverse_psi = S::from_f64(1.0) / pivot_psi;
        let w_2 = self.a * cos_phi;
        let w_3 = self.b * sin_psi;
        let w_4 = self.dx - w_2 - w_3;
        let B_z = self.dz - self.b * cos_psi;
        let sin_phi_squared = sin_phi * sin_phi;
        let w_5 = w_4 * w_4 + B_z * B_z + self.a_squared * sin_phi_squared;
        let sqrt_w_5 = w_5.sqrt();
        let w_6 = self.b * (cos_psi * w_4 - sin_psi * B_z);
        let w_7 = self.a_squared * cos_phi;
        let w_8 = sin_phi * (self.a * w_4 + w_7);
        let coupling_by_phi = sqrt_w_5 * w_8 / w_5;
        let l_lambda_coupling_phi = coupling_by_phi * self.inverse_phi;
        let minus_k_lambda_coupling_psi = sqrt_w_5 * w_6 / w_5
            + mass_psi_phi * l_lambda_coupling_phi;
        let minus_l_lambda_coupling_psi = inverse_psi * minus_k_lambda_coupling_psi;
        let minus_pivot_lambda_coupling = coupling_by_phi * l_lambda_coupling_phi
            + minus_k_lambda_coupling_psi * minus_l_lambda_coupling_psi;
        let w_9 = self.a * sin_phi * phi_dot - self.b * cos_psi * psi_dot;
        let w_10 = w_4 * w_9 + sin_phi * w_7 * phi_dot + w_3 * B_z * psi_dot;
        let w_5_squared = w_5 * w_5;
        let w_11 = w_6 * w_10 / w_5_squared
            - (self.b * (cos_psi * (w_9 - B_z * psi_dot) - sin_psi * w_4 * psi_dot)
                - self.b_squared * psi_dot * sin_psi * sin_psi) / w_5;
        let w_12 = phi_dot
            * ((phi_dot * (self.a_squared + w_2 * w_4 - sin_phi_squared * self.k_10)
                + self.a * sin_phi * w_9) / w_5 - w_8 * w_10 / w_5_squared)
            + psi_dot * w_11;
        let minus_rhs_psi = sin_psi * self.k_9
            + cos_psi * self.k_2 * cos_phi * phi_dot * phi_dot + rhs_phi * l_psi_phi;
        let lambda_coupling = S::from_f64(1.0) / minus_pivot_lambda_coupling
            * (sqrt_w_5 * w_12 + rhs_phi * l_lambda_coupling_phi
                + minus_l_lambda_coupling_psi * minus_rhs_psi);
        let psi_ddot = minus_l_lambda_coupling_psi * lambda_coupling
            - inverse_psi * minus_rhs_psi;
        sim_kernel::Dynamics {
            accelerations: [
                rhs_phi * self.inverse_phi - l_psi_phi * psi_ddot
                    - l_lambda_coupling_phi * lambda_coupling,
                psi_ddot,
            ],
            multipliers: [lambda_coupling],
            power: -(sin_psi * psi_dot * self.k_9),
            refused: sim_kernel::pivot_is_refused(self.mass_phi_phi, self.mass_phi_phi)
                | sim_kernel::pivot_is_refused(pivot_psi, self.mass_psi_psi)
                | sim_kernel::pivot_is_refused(
                    -minus_pivot_lambda_coupling,
                    minus_pivot_lambda_coupling,
                ),
        }
    }
    /// The derivatives of accelerations (2 rows) and multipliers (1 rows) with respect to coordinates and speeds (2 columns each): with the equations of motion as `K z = r`, the solutions of `K dz = dr - dK z`. Where `refused` is set a pivot was too small and nothing else holds.
    ///
    /// Operations: 115 additions, 198 multiplications, 25 divisions, 2 sine-cosine pairs, 1 square root.
    #[inline]
    pub fn dynamics_jacobian(
        &self,
        t: S,
        q: &[S; 2],
        qd: &[S; 2],
    ) -> sim_kernel::DynamicsJacobian<S, [[S; 2]; 2], [[S; 2]; 1]> {
        let [phi, psi] = *q;
        let [phi_dot, psi_dot] = *qd;
        let ([sin_phi, sin_psi], [cos_phi, cos_psi]) = S::sin_cos_each([phi, psi]);
        let psi_dot_squared = psi_dot * psi_dot;
        let w = sin_phi * self.k_2;
        let rhs_phi = sin_psi * psi_dot_squared * w;
        let phi_dot_squared = phi_dot * phi_dot;
        let sin_phi_squared = sin_phi * sin_phi;
        let w_2 = self.a * cos_phi;
        let w_3 = self.b * sin_psi;
        let w_4 = w_2 * phi_dot_squared - w_3 * psi_dot_squared;
        let w_6 = self.dx - w_2 - w_3;
        let w_5 = sin_phi * cos_psi;
        let mass_psi_phi = self.k_2 * w_5;
        let w_33 = w_5 * self.k_11;
        let l_psi_phi = mass_psi_phi * self.inverse_phi;
        let pivot_psi = self.mass_psi_psi - mass_psi_phi * l_psi_phi;
        let inverse_psi = S::from_f64(1.0) / pivot_psi;
        let w_7 = self.b * cos_psi;
        let B_z = self.dz - w_7;
        let w_8 = w_6 * w_6 + B_z * B_z + self.a_squared * sin_phi_squared;
        let sqrt_w_8 = w_8.sqrt();
        let w_9 = cos_psi * w_6;
        let w_10 = self.b * (w_9 - sin_psi * B_z);
        let w_11 = self.a * w_6;
        let w_12 = self.a_squared * cos_phi;
        let w_13 = sin_phi * (w_11 + w_12);
        let coupling_by_phi = sqrt_w_8 * w_13 / w_8;
        let l_lambda_coupling_phi = coupling_by_phi * self.inverse_phi;
        let minus_k_lambda_coupling_psi = sqrt_w_8 * w_10 / w_8
            + mass_psi_phi * l_lambda_coupling_phi;
        let minus_l_lambda_coupling_psi = inverse_psi * minus_k_lambda_coupling_psi;
        let minus_pivot_lambda_coupling = coupling_by_phi * l_lambda_coupling_phi
            + minus_k_lambda_coupling_psi * minus_l_lambda_coupling_psi;
        let minus_inverse_lambda_coupling = S::from_f64(1.0)
            / minus_pivot_lambda_coupling;
        let w_14 = w_2 * w_6;
        let w_15 = self.a * sin_phi;
        let w_16 = phi_dot * w_15 - w_7 * psi_dot;
        let w_17 = phi_dot * (self.a_squared + w_14 - sin_phi_squared * self.k_10)
            + w_15 * w_16;
        let w_26 = self.a_squared * (sin_phi_squared - S::from_f64(1.0)) - w_14;
        let w_18 = sin_psi * psi_dot;
        let w_19 = w_6 * w_16 + sin_phi * w_12 * phi_dot + self.b * B_z * w_18;
        let w_20 = w_13 * w_19;
        let w_8_squared = w_8 * w_8;
        let w_21 = w_10 * w_19;
        let w_22 = w_16 - B_z * psi_dot;
        let w_46 = self.b_squared + self.b * (sin_psi * w_6 + cos_psi * B_z);
        let w_23 = self.b * (cos_psi * w_22 - w_6 * w_18)
            - self.b_squared * psi_dot * sin_psi * sin_psi;
        let w_24 = cos_psi * cos_phi;
        let minus_rhs_psi = sin_psi * self.k_9 + self.k_2 * phi_dot_squared * w_24
            + rhs_phi * l_psi_phi;
        let w_37 = phi_dot * w_24;
        let lambda_coupling = minus_inverse_lambda_coupling
            * (sqrt_w_8
                * (phi_dot * (w_17 / w_8 - w_20 / w_8_squared)
                    + psi_dot * (w_21 / w_8_squared - w_23 / w_8))
                + rhs_phi * l_lambda_coupling_phi
                + minus_l_lambda_coupling_psi * minus_rhs_psi);
        let psi_ddot = minus_l_lambda_coupling_psi * lambda_coupling
            - inverse_psi * minus_rhs_psi;
        let phi_ddot = rhs_phi * self.inverse_phi - l_psi_phi * psi_ddot
            - l_lambda_coupling_phi * lambda_coupling;
        let w_25 = self.k_2 * psi_ddot;
        let w_13_squared = w_13 * w_13;
        let w_27 = self.k * phi_dot_squared * (S::from_f64(1.0) - sin_phi_squared)
            - cos_phi * (w_4 * self.k_3 + cos_psi * w_25)
            + sqrt_w_8 * lambda_coupling * (w_13_squared / w_8_squared + w_26 / w_8);
        let w_28 = sqrt_w_8 * lambda_coupling;
        let w_29 = self.k_11 * w_28;
        let w_30 = w_13 * w_10;
        let w_31 = w_28 * w_30 / w_8_squared;
        let w_32 = cos_psi
            * (self.k_2 * (sin_phi * phi_dot_squared - cos_phi * phi_ddot)
                + sin_phi * w_29 / w_8) - w_31 - l_psi_phi * w_27;
        let w_45 = sin_phi
            * (cos_psi * (w_29 / w_8 + self.k_2 * psi_dot_squared) + sin_psi * w_25)
            - w_31;
        let w_34 = phi_dot * w_26 + psi_dot * w_33;
        let w_35 = w_10 * w_17;
        let w_36 = (w_13
            * (phi_dot * S::from_f64(2.0) * w_17 - psi_dot * w_23 - w_10 * psi_ddot)
            - w_19 * w_34 - psi_dot * w_35 + phi_ddot * w_13_squared) / w_8_squared;
        let w_41 = psi_dot * w_30 - phi_dot * w_13_squared;
        let w_38 = sin_phi * w_18;
        let w_39 = self.k_11 * (w_37 - w_38);
        let w_40 = (phi_dot
            * (sin_phi * phi_dot * (w_11 + cos_phi * self.k_10) - w_2 * w_16)
            + psi_dot * w_39 + phi_ddot * w_26 + psi_ddot * w_33) / w_8;
        let w_50 = (phi_dot * w_39
            - psi_dot
                * (self.b * (sin_psi * w_22 + w_9 * psi_dot)
                    + cos_psi * self.b_squared * w_18) + phi_ddot * w_33
            - psi_ddot * w_46) / w_8;
        let w_54 = w_37 * self.k_13;
        let w_55 = minus_inverse_lambda_coupling
            * (sqrt_w_8 * ((w_20 - w_41) / w_8_squared + (w_34 - w_17) / w_8)
                - minus_l_lambda_coupling_psi * w_54);
        let w_56 = inverse_psi * w_54 + minus_l_lambda_coupling_psi * w_55;
        let w_57 = w_38 * self.k_13;
        let w_42 = w_8 * w_8_squared;
        let w_43 = minus_inverse_lambda_coupling
            * (sqrt_w_8 * (w_36 + w_40 + S::from_f64(3.0) * w_19 * (w_41 / w_42))
                - l_lambda_coupling_phi * w_27 + minus_l_lambda_coupling_psi * w_32);
        let w_44 = inverse_psi * w_32 - minus_l_lambda_coupling_psi * w_43;
        let w_10_squared = w_10 * w_10;
        let w_49 = psi_dot * (w_19 * w_46 + w_10 * S::from_f64(2.0) * w_23)
            - phi_dot * (w_19 * w_33 + w_13 * w_23 + w_35) - phi_ddot * w_30
            + psi_ddot * w_10_squared;
        let w_51 = phi_dot * w_30 - psi_dot * w_10_squared;
        let w_47 = cos_psi
            * (self.k_7 + (self.k_4 + cos_psi * psi_dot_squared * self.k_5) * self.k_8);
        let w_48 = sin_psi * (w_4 * self.k_6 + w * phi_ddot)
            + sqrt_w_8 * lambda_coupling * (w_10_squared / w_8_squared - w_46 / w_8)
            + psi_dot_squared * self.k_12 - w_47 - l_psi_phi * w_45;
        let w_52 = minus_inverse_lambda_coupling
            * (sqrt_w_8
                * (w_49 / w_8_squared + w_50 + S::from_f64(3.0) * w_19 * (w_51 / w_42))
                - l_lambda_coupling_phi * w_45 + minus_l_lambda_coupling_psi * w_48);
        let w_53 = inverse_psi * w_48 - minus_l_lambda_coupling_psi * w_52;
        let w_58 = l_psi_phi * w_57;
        let w_59 = minus_inverse_lambda_coupling
            * (sqrt_w_8
                * ((w_23 + phi_dot * w_33 - psi_dot * w_46) / w_8
                    - (w_21 + w_51) / w_8_squared) - l_lambda_coupling_phi * w_57
                - minus_l_lambda_coupling_psi * w_58);
        let w_60 = inverse_psi * w_58 + minus_l_lambda_coupling_psi * w_59;
        sim_kernel::DynamicsJacobian {
            accelerations_by_positions: [
                [
                    self.inverse_phi * w_27 - l_psi_phi * w_44
                        + l_lambda_coupling_phi * w_43,
                    self.inverse_phi * w_45 - l_psi_phi * w_53
                        + l_lambda_coupling_phi * w_52,
                ],
                [w_44, w_53],
            ],
            accelerations_by_speeds: [
                [
                    l_psi_phi * w_56 + l_lambda_coupling_phi * w_55,
                    self.inverse_phi * w_57 + l_psi_phi * w_60
                        + l_lambda_coupling_phi * w_59,
                ],
                [-w_56, -w_60],
            ],
            multipliers_by_positions: [[-w_43, -w_52]],
            multipliers_by_speeds: [[-w_55, -w_59]],
            refused: sim_kernel::pivot_is_refused(self.mass_phi_phi, self.mass_phi_phi)
                | sim_kernel::pivot_is_refused(pivot_psi, self.mass_psi_psi)
                | sim_kernel::pivot_is_refused(
                    -minus_pivot_lambda_coupling,
                    minus_pivot_lambda_coupling,
                ),
        }
    }
}
#[allow(non_snake_case, clippy::all, clippy::pedantic)]
impl<S: sim_kernel::Scalar> sim_kernel::Mechanism<S> for Rssr<S> {
    type Q = [S; 2];
    type L = [S; 1];
    type Z = [S; 3];
    type QQ = [[S; 2]; 2];
    type LQ = [[S; 2]; 1];
    type LL = [[S; 1]; 1];
    type ZZ = [[S; 3]; 3];
    type Entries = [S; 0];
    type Envelope = [S; 0];
    type Parameters = [S; 8];
    type Outputs = [S; 2];
    type OutputRates = [S; 1];
    type Events = [S; 1];
    type EventValues = [S; 0];
    type Activities = [S; 0];
    type Drawing = [S; 31];
    type QP = [[S; 8]; 2];
    type LP = [[S; 8]; 1];
    type Inputs = [sim_kernel::Input<S>; 0];
    type Prepared = RssrPrepared<S>;
    type On<T: sim_kernel::Scalar> = Rssr<T>;
    const DESCRIPTION: sim_kernel::Description = sim_kernel::Description {
        name: "rssr",
        type_name: "Rssr",
        docs: "A crank drives a rocker on another axis by a coupler with two ball joints.",
        declaration: "/// A crank drives a rocker on another axis by a coupler with two ball joints.\npub Rssr;\n\ncoordinates {\n    /// Turn of the crank, about the vertical.\n    phi [rad];\n    /// Swing of the rocker, about an axis along y.\n    psi [rad];\n}\n\nparameters {\n    /// Crank.\n    a [m] = 0.15;\n    /// Coupler.\n    c [m] = 0.7;\n    /// Rocker.\n    b [m] = 0.4;\n    /// Place of the rocker's axis.\n    dx [m] = 0.5;\n    dz [m] = 0.3;\n    m [kg] = 1;\n    g [m/s^2] = 9.81;\n    /// Speed of the crank at the start.\n    speed [rpm] = 120;\n}\n\nlet A = a*[cos(phi), sin(phi), 0];\nlet O = [dx, 0, dz];\nlet rocker_frame = rotation(y, psi);\nlet B = O + rocker_frame*[0, 0, -b];\n\nbodies {\n    crank: inertia [0.01 [kg*m^2], 0.01 [kg*m^2], 0.02 [kg*m^2]], attitude rotation(z, phi);\n    coupler: mass m at (A + B)/2;\n    rocker: mass m at O + rocker_frame*[0, 0, -b/2], inertia [m*b^2/12, m*b^2/12, 0], attitude rocker_frame;\n}\nloads { gravity [0, 0, -g]; }\njoints { coupling: link A to B, length c; }\ninitial { phi = 0; dot(phi) = speed; guess psi = 0.3; }\nevents { period: sin(phi/2) = 0; }\n\noutputs {\n    /// swing of the rocker\n    swing [deg] = psi;\n    /// force in the coupler, positive in tension\n    coupler_force [N] = reaction(coupling);\n}\n\ndrawing {\n    ground [0, 0, 0], O;\n    line [0, 0, 0], A;\n    line A, B;\n    line B, O;\n    circle [0, 0, 0] radius a normal [0, 0, 1];\n}\n",
        coordinates: &[
            sim_kernel::Coordinate {
                position: sim_kernel::Quantity {
                    name: "phi",
                    unit: "rad",
                    factor: 1f64,
                    is_length: false,
                    docs: "Turn of the crank, about the vertical.",
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
            sim_kernel::Coordinate {
                position: sim_kernel::Quantity {
                    name: "psi",
                    unit: "rad",
                    factor: 1f64,
                    is_length: false,
                    docs: "Swing of the rocker, about an axis along y.",
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
                start: sim_kernel::Start::Guess,
                speed_given: false,
            },
        ],
        parameters: &[
            sim_kernel::Quantity {
                name: "a",
                unit: "m",
                factor: 1f64,
                is_length: true,
                docs: "Crank.",
            },
            sim_kernel::Quantity {
                name: "c",
                unit: "m",
                factor: 1f64,
                is_length: true,
                docs: "Coupler.",
            },
            sim_kernel::Quantity {
                name: "b",
                unit: "m",
                factor: 1f64,
                is_length: true,
                docs: "Rocker.",
            },
            sim_kernel::Quantity {
                name: "dx",
                unit: "m",
                factor: 1f64,
                is_length: true,
                docs: "Place of the rocker's axis.",
            },
            sim_kernel::Quantity {
                name: "dz",
                unit: "m",
                factor: 1f64,
                is_length: true,
                docs: "",
            },
            sim_kernel::Quantity {
                name: "m",
                unit: "kg",
                factor: 1f64,
                is_length: false,
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
                name: "speed",
                unit: "rpm",
                factor: 0.10471975511965977f64,
                is_length: false,
                docs: "Speed of the crank at the start.",
            },
        ],
        inputs: &[],
        constraints: &[
            sim_kernel::Quantity {
                name: "coupling",
                unit: "N",
                factor: 1f64,
                is_length: false,
                docs: "",
            },
        ],
        speed_constraints: &[],
        norm_constraints: &[],
        sparsity: &[],
        conditionals: &[],
        events: &[
            sim_kernel::event::Event {
                name: "period",
                direction: sim_kernel::event::Direction::Both,
                on_forces: false,
                steps: &[],
            },
        ],
        outputs: &[
            sim_kernel::Quantity {
                name: "swing",
                unit: "deg",
                factor: 0.017453292519943295f64,
                is_length: false,
                docs: "swing of the rocker",
            },
            sim_kernel::Quantity {
                name: "coupler_force",
                unit: "N",
                factor: 1f64,
                is_length: false,
                docs: "force in the coupler, positive in tension",
            },
        ],
        rated_outputs: &[0],
        figures: &[
            sim_kernel::Figure {
                name: "swing",
                title: "swing of the rocker",
                len: 1,
            },
            sim_kernel::Figure {
                name: "coupler_force",
                title: "force in the coupler, positive in tension",
                len: 1,
            },
        ],
        optional_kernels: &["dynamics_jacobian"],
        dimension: 3,
        drawing: &[
            sim_kernel::Shape::Ground(2),
            sim_kernel::Shape::Line(2),
            sim_kernel::Shape::Line(2),
            sim_kernel::Shape::Line(2),
            sim_kernel::Shape::Circle,
        ],
    };
    fn defaults() -> Self {
        Self {
            a: S::from_f64(0.15f64),
            c: S::from_f64(0.7f64),
            b: S::from_f64(0.4f64),
            dx: S::from_f64(0.5f64),
            dz: S::from_f64(0.3f64),
            m: S::from_f64(1f64),
            g: S::from_f64(9.81f64),
            speed: S::from_f64(12.566370614359172f64),
        }
    }
    fn parameters(&self) -> [S; 8] {
        [self.a, self.c, self.b, self.dx, self.dz, self.m, self.g, self.speed]
    }
    fn with_parameters(&self, parameters: [S; 8]) -> Self {
        Self {
            a: parameters[0],
            c: parameters[1],
            b: parameters[2],
            dx: parameters[3],
            dz: parameters[4],
            m: parameters[5],
            g: parameters[6],
            speed: parameters[7],
            ..*self
        }
    }
    fn on<T: sim_kernel::Scalar>(
        &self,
        convert: impl ::core::ops::Fn(S) -> T,
    ) -> Rssr<T> {
        Rssr {
            a: convert(self.a),
            c: convert(self.c),
            b: convert(self.b),
            dx: convert(self.dx),
            dz: convert(self.dz),
            m: convert(self.m),
            g: convert(self.g),
            speed: convert(self.speed),
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
    fn prepare(&self) -> RssrPrepared<S> {
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
    ) -> [S; 2] {
        self.outputs(t, q, qd, qdd, lambda).into()
    }
    #[inline(always)]
    fn output_rates(&self, t: S, q: &[S; 2], qd: &[S; 2], qdd: &[S; 2]) -> [S; 1] {
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
    ) -> [S; 1] {
        self.events(t, q, qd, qdd, lambda)
    }
    #[inline(always)]
    fn drawing(&self, t: S, q: &[S; 2]) -> [S; 31] {
        self.drawing(t, q)
    }
    #[inline(always)]
    fn initial(&self) -> sim_kernel::Initial<[S; 2]> {
        self.initial()
    }
}
