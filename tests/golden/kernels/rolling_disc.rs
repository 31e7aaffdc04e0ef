/// A disc rolls in a circle, leaning inwards and, unless `nod` is 0, nodding.
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
/// coordinates = [x; y; z; psi; lean; phi]
/// multipliers = [
///     lambda_ground;
///     lambda_ground_f1;
///     lambda_ground_f2
/// ]
/// constraints = 0
///
/// mass_matrix = [
///     m, 0, 0, 0, 0, 0;
///     0, m, 0, 0, 0, 0;
///     0, 0, m, 0, 0, 0;
///     0, 0, 0, mass_matrix[4, 4], 0, mass_matrix[4, 6];
///     0, 0, 0, 0, A, 0;
///     0, 0, 0, mass_matrix[4, 6], 0, C
/// ]
/// mass_matrix[4, 4] = m*r^2/4 + m*r^2*sin(lean)^2/4
/// mass_matrix[4, 6] = m*r^2*sin(lean)/2
///
/// convective_forces = [
///     0;
///     0;
///     0;
///     convective_forces[4];
///     s_10*sin(phi)/4 - s_9*cos(phi)/4;
///     m*r^2*psi_dot*lean_dot*cos(lean)/2
/// ]
/// convective_forces[4] = s_9*cos(lean)*sin(phi)/4 + m*r^2*psi_dot*lean_dot*sin(lean)*cos(lean)/2
///     + s_10*cos(lean)*cos(phi)/4
///
/// generalized_forces = [0; 0; -m*g; 0; 0; 0]
///
/// constraints = [z - r*sqrt(cos(lean)^2); 0; 0]
///
/// constraint_jacobian = [
///     0, 0, 1, 0, constraint_jacobian[1, 5], 0;
///     1, 0, 0, constraint_jacobian[2, 4], -s_7*sin(psi), constraint_jacobian[2, 6];
///     0, 1, 0, constraint_jacobian[3, 4], s_7*cos(psi), constraint_jacobian[3, 6]
/// ]
/// constraint_jacobian[1, 5] = r*sqrt(cos(lean)^2)*sin(lean)*cos(lean)/cos(lean)^2
/// constraint_jacobian[2, 4] = -r*cos(psi)*sin(lean)*cos(lean)/sqrt(cos(lean)^2)
/// constraint_jacobian[2, 6] = -r*cos(psi)*sin(lean)^2*cos(lean)/sqrt(cos(lean)^2) - s_7*cos(psi)*cos(lean)
/// constraint_jacobian[3, 4] = -r*sin(psi)*sin(lean)*cos(lean)/sqrt(cos(lean)^2)
/// constraint_jacobian[3, 6] = -r*sin(psi)*sin(lean)^2*cos(lean)/sqrt(cos(lean)^2) - s_7*sin(psi)*cos(lean)
///
/// constraint_convective = [
///     constraint_convective[1];
///     constraint_convective[2];
///     constraint_convective[3]
/// ]
/// constraint_convective[1] = 2*r*lean_dot^2*sqrt(cos(lean)^2)*sin(lean)^2*cos(lean)/cos(lean)^3
///     - 2*r*lean_dot^2*sqrt(cos(lean)^2)*sin(lean)^2/cos(lean)^2
///     - r*lean_dot^2*sqrt(cos(lean)^2)*sin(lean)^2*cos(lean)^2/cos(lean)^4
///     + r*lean_dot^2*sqrt(cos(lean)^2)/cos(lean)^2
/// constraint_convective[2] = r*s_6*psi_dot*sin(psi)*sin(lean)*cos(lean)/sqrt(cos(lean)^2)
///     - r*s_13*cos(psi)*sin(lean)*cos(lean)/sqrt(cos(lean)^2)
///     + 2*r*s_6*lean_dot*cos(psi)*sin(lean)^2/sqrt(cos(lean)^2)
///     - r*s_6*lean_dot*sqrt(cos(lean)^2)*cos(psi)*sin(lean)^2*cos(lean)^2/(sqrt(cos(lean)^2)^2*cos(lean)^2)
///     - r*s_6*lean_dot*cos(psi)/sqrt(cos(lean)^2)
///     - s_7*(s_3*psi_dot*cos(psi) + s_14*sin(psi) + s_15*cos(psi) - s_5*psi_dot*sin(psi))
///     - s_16*(s_3*sin(psi) + s_5*cos(psi))
/// constraint_convective[3] = 2*r*s_6*lean_dot*sin(psi)*sin(lean)^2/sqrt(cos(lean)^2)
///     - r*s_6*psi_dot*cos(psi)*sin(lean)*cos(lean)/sqrt(cos(lean)^2)
///     - r*s_13*sin(psi)*sin(lean)*cos(lean)/sqrt(cos(lean)^2)
///     - r*s_6*lean_dot*sqrt(cos(lean)^2)*sin(psi)*sin(lean)^2*cos(lean)^2/(sqrt(cos(lean)^2)^2*cos(lean)^2)
///     - r*s_6*lean_dot*sin(psi)/sqrt(cos(lean)^2)
///     + s_7*(s_14*cos(psi) - s_3*psi_dot*sin(psi) - s_5*psi_dot*cos(psi) - s_15*sin(psi))
///     + s_16*(s_3*cos(psi) - s_5*sin(psi))
///
/// A = m*r^2/4
/// C = m*r^2/2
/// s_1 = lean_dot*cos(phi) - psi_dot*cos(lean)*sin(phi)
/// s_2 = lean_dot*sin(phi) + psi_dot*cos(lean)*cos(phi)
/// s_3 = s_1*cos(phi) + s_2*sin(phi)
/// s_4 = s_2*cos(phi) - s_1*sin(phi)
/// s_5 = (phi_dot + psi_dot*sin(lean))*cos(lean) - s_4*sin(lean)
/// s_6 = (phi_dot + psi_dot*sin(lean))*sin(lean) + s_4*cos(lean)
/// s_7 = r/sqrt(cos(lean)^2) - r*sin(lean)^2/sqrt(cos(lean)^2)
/// s_8 = psi_dot*lean_dot*sin(lean)*sin(phi) - lean_dot*phi_dot*sin(phi)
///     - psi_dot*phi_dot*cos(lean)*cos(phi)
/// s_9 = m*r^2*s_2*(phi_dot + psi_dot*sin(lean))
///     + m*r^2*(s_2*phi_dot - psi_dot*lean_dot*sin(lean)*sin(phi))
/// s_10 = m*r^2*s_1*(phi_dot + psi_dot*sin(lean))
///     + m*r^2*(s_1*phi_dot - psi_dot*lean_dot*sin(lean)*cos(phi))
/// s_11 = psi_dot*lean_dot*sin(lean)*cos(phi) - lean_dot*phi_dot*cos(phi)
///     + psi_dot*phi_dot*cos(lean)*sin(phi)
/// s_12 = s_2*phi_dot*sin(phi) + s_11*cos(phi) + s_1*phi_dot*cos(phi) + s_8*sin(phi)
/// s_13 = lean_dot*(phi_dot + psi_dot*sin(lean))*cos(lean) + psi_dot*lean_dot*sin(lean)*cos(lean)
///     - s_4*lean_dot*sin(lean) - s_12*cos(lean)
/// s_14 = s_8*cos(phi) - s_1*phi_dot*sin(phi) + s_2*phi_dot*cos(phi) - s_11*sin(phi)
/// s_15 = psi_dot*lean_dot*cos(lean)^2 - lean_dot*(phi_dot + psi_dot*sin(lean))*sin(lean)
///     - s_4*lean_dot*cos(lean) + s_12*sin(lean)
/// s_16 = r*lean_dot*sqrt(cos(lean)^2)*sin(lean)*cos(lean)/(sqrt(cos(lean)^2)^2*cos(lean)^2)
///     - 2*r*lean_dot*sin(lean)*cos(lean)/sqrt(cos(lean)^2)
///     - r*lean_dot*sqrt(cos(lean)^2)*sin(lean)^3*cos(lean)/(sqrt(cos(lean)^2)^2*cos(lean)^2)
/// ```
#[allow(non_snake_case)]
#[derive(
    ::core::clone::Clone,
    ::core::marker::Copy,
    ::core::fmt::Debug,
    ::core::cmp::PartialEq
)]
pub struct RollingDisc<S = ::core::primitive::f64> {
    /// In `kg`.
    pub m: S,
    /// In `m`.
    pub r: S,
    /// In `m/s^2`.
    pub g: S,
    /// Lean at the start, in `1`.
    pub lean0: S,
    /// Rate of turning at the start, in `rad/s`.
    pub turning: S,
    /// Speed of leaning at the start, in `rad/s`.
    pub nod: S,
}
impl<S: sim_kernel::Scalar> ::core::default::Default for RollingDisc<S> {
    /// The declared values.
    fn default() -> Self {
        <Self as sim_kernel::Mechanism<S>>::defaults()
    }
}
/// Coordinates of [`RollingDisc`] by name, in SI units; also for their speeds and accelerations.
#[allow(non_snake_case)]
#[derive(
    ::core::clone::Clone,
    ::core::marker::Copy,
    ::core::fmt::Debug,
    ::core::cmp::PartialEq
)]
pub struct RollingDiscCoordinates<S = ::core::primitive::f64> {
    /// Place of the centre, in `m`.
    pub x: S,
    /// In `m`.
    pub y: S,
    /// In `m`.
    pub z: S,
    /// Direction of rolling, in `rad`.
    pub psi: S,
    /// Lean from the upright, in `rad`.
    pub lean: S,
    /// Turn about its own axis, in `rad`.
    pub phi: S,
}
impl<S: sim_kernel::Scalar> ::core::convert::From<[S; 6]> for RollingDiscCoordinates<S> {
    fn from(values: [S; 6]) -> Self {
        Self {
            x: values[0],
            y: values[1],
            z: values[2],
            psi: values[3],
            lean: values[4],
            phi: values[5],
        }
    }
}
impl<S: sim_kernel::Scalar> ::core::convert::From<RollingDiscCoordinates<S>> for [S; 6] {
    fn from(record: RollingDiscCoordinates<S>) -> Self {
        [record.x, record.y, record.z, record.psi, record.lean, record.phi]
    }
}
/// Outputs of [`RollingDisc`] by name, in SI units.
#[allow(non_snake_case)]
#[derive(
    ::core::clone::Clone,
    ::core::marker::Copy,
    ::core::fmt::Debug,
    ::core::cmp::PartialEq
)]
pub struct RollingDiscOutputs<S = ::core::primitive::f64> {
    /// lean, in `1`.
    pub leaning: S,
    /// speed of the centre, in `m/s`.
    pub speed: S,
    /// force on the ground, in `N`.
    pub normal_force: S,
}
impl<S: sim_kernel::Scalar> ::core::convert::From<[S; 3]> for RollingDiscOutputs<S> {
    fn from(values: [S; 3]) -> Self {
        Self {
            leaning: values[0],
            speed: values[1],
            normal_force: values[2],
        }
    }
}
impl<S: sim_kernel::Scalar> ::core::convert::From<RollingDiscOutputs<S>> for [S; 3] {
    fn from(record: RollingDiscOutputs<S>) -> Self {
        [record.leaning, record.speed, record.normal_force]
    }
}
/// Rates of the outputs of [`RollingDisc`] by name, in SI units.
#[allow(non_snake_case)]
#[derive(
    ::core::clone::Clone,
    ::core::marker::Copy,
    ::core::fmt::Debug,
    ::core::cmp::PartialEq
)]
pub struct RollingDiscOutputRates<S = ::core::primitive::f64> {
    /// Rate of `leaning`.
    pub leaning: S,
    /// Rate of `speed`.
    pub speed: S,
}
impl<S: sim_kernel::Scalar> ::core::convert::From<[S; 2]> for RollingDiscOutputRates<S> {
    fn from(values: [S; 2]) -> Self {
        Self {
            leaning: values[0],
            speed: values[1],
        }
    }
}
impl<S: sim_kernel::Scalar> ::core::convert::From<RollingDiscOutputRates<S>> for [S; 2] {
    fn from(record: RollingDiscOutputRates<S>) -> Self {
        [record.leaning, record.speed]
    }
}
/// What the equations of motion need of the parameters of [`RollingDisc`], from [`RollingDisc::prepare`]; its methods are the kernels of each step.
#[allow(non_snake_case)]
#[derive(
    ::core::clone::Clone,
    ::core::marker::Copy,
    ::core::fmt::Debug,
    ::core::cmp::PartialEq
)]
pub struct RollingDiscPrepared<S = ::core::primitive::f64> {
    m: S,
    r: S,
    A_: S,
    C_: S,
    minus_rhs_z: S,
    k: S,
    k_2: S,
    inverse_z: S,
    inverse_lean: S,
    k_3: S,
    k_4: S,
    k_5: S,
    k_6: S,
    k_7: S,
    k_8: S,
    k_9: S,
}
#[allow(non_snake_case, unused_variables, unused_parens, clippy::all, clippy::pedantic)]
impl<S: sim_kernel::Scalar> RollingDisc<S> {
    /// What the equations of motion need of the parameters, computed once for a set of parameters.
    ///
    /// Operations: 15 multiplications, 2 divisions.
    #[inline]
    pub fn prepare(&self) -> RollingDiscPrepared<S> {
        let r_squared = self.r * self.r;
        let A_ = self.m * S::from_f64(0.25) * r_squared;
        let w = self.m * self.g;
        let inverse_m = S::from_f64(1.0) / self.m;
        RollingDiscPrepared {
            m: self.m,
            r: self.r,
            A_: A_,
            C_: self.m * r_squared * S::from_f64(0.5),
            minus_rhs_z: w,
            k: self.m * r_squared,
            k_2: self.r * S::from_f64(2.0),
            inverse_z: inverse_m,
            inverse_lean: S::from_f64(1.0) / A_,
            k_3: w * inverse_m,
            k_4: self.r * S::from_f64(3.0),
            k_5: self.r * S::from_f64(4.0),
            k_6: self.r * S::from_f64(10.0),
            k_7: self.r * S::from_f64(12.0),
            k_8: self.r * S::from_f64(6.0),
            k_9: self.r * S::from_f64(7.0),
        }
    }
    /// Mass matrix `T_q' M T_q`, 6 x 6, symmetric, in SI units.
    ///
    /// Operations: 1 addition, 8 multiplications, 1 sine-cosine pair.
    #[inline]
    pub fn mass_matrix(&self, t: S, q: &[S; 6]) -> [[S; 6]; 6] {
        let [_, _, _, _, lean, _] = *q;
        let r_squared = self.r * self.r;
        let A_ = self.m * S::from_f64(0.25) * r_squared;
        let ([sin_lean], [_]) = S::sin_cos_each([lean]);
        let C_ = self.m * r_squared * S::from_f64(0.5);
        let mass_phi_psi = sin_lean * C_;
        [
            [
                self.m,
                S::from_f64(0.0),
                S::from_f64(0.0),
                S::from_f64(0.0),
                S::from_f64(0.0),
                S::from_f64(0.0),
            ],
            [
                S::from_f64(0.0),
                self.m,
                S::from_f64(0.0),
                S::from_f64(0.0),
                S::from_f64(0.0),
                S::from_f64(0.0),
            ],
            [
                S::from_f64(0.0),
                S::from_f64(0.0),
                self.m,
                S::from_f64(0.0),
                S::from_f64(0.0),
                S::from_f64(0.0),
            ],
            [
                S::from_f64(0.0),
                S::from_f64(0.0),
                S::from_f64(0.0),
                A_ * (S::from_f64(1.0) + sin_lean * sin_lean),
                S::from_f64(0.0),
                mass_phi_psi,
            ],
            [
                S::from_f64(0.0),
                S::from_f64(0.0),
                S::from_f64(0.0),
                S::from_f64(0.0),
                A_,
                S::from_f64(0.0),
            ],
            [
                S::from_f64(0.0),
                S::from_f64(0.0),
                S::from_f64(0.0),
                mass_phi_psi,
                S::from_f64(0.0),
                C_,
            ],
        ]
    }
    /// Convective forces `T_q' M g`, 6, with `g = (T_q q' + T_t)_q q' + (..)_t`: joules per unit of each coordinate.
    ///
    /// Operations: 3 additions, 18 multiplications, 1 sine-cosine pair.
    #[inline]
    pub fn convective_forces(&self, t: S, q: &[S; 6], qd: &[S; 6]) -> [S; 6] {
        let [_, _, _, _, lean, _] = *q;
        let [_, _, _, psi_dot, lean_dot, phi_dot] = *qd;
        let r_squared = self.r * self.r;
        let w = self.m * r_squared * S::from_f64(0.5);
        let ([sin_lean], [cos_lean]) = S::sin_cos_each([lean]);
        [
            S::from_f64(0.0),
            S::from_f64(0.0),
            S::from_f64(0.0),
            w * cos_lean * lean_dot * (psi_dot * sin_lean + phi_dot),
            -(cos_lean
                * (psi_dot * phi_dot * w
                    + sin_lean * psi_dot * psi_dot * S::from_f64(0.25) * self.m
                        * r_squared)),
            cos_lean * lean_dot * psi_dot * w,
        ]
    }
    /// Generalised forces `T_q' F`, 6: joules per unit of each coordinate.
    ///
    /// Operations: 1 addition, 1 multiplication.
    #[inline]
    pub fn generalized_forces(&self, t: S, q: &[S; 6], qd: &[S; 6]) -> [S; 6] {
        [
            S::from_f64(0.0),
            S::from_f64(0.0),
            -(self.m * self.g),
            S::from_f64(0.0),
            S::from_f64(0.0),
            S::from_f64(0.0),
        ]
    }
    /// Constraints `C`, 3, in SI units; zero throughout the motion.
    ///
    /// Operations: 1 addition, 2 multiplications, 1 sine-cosine pair, 1 square root.
    #[inline]
    pub fn constraints(&self, t: S, q: &[S; 6]) -> [S; 3] {
        let [_, _, z, _, lean, _] = *q;
        let ([_], [cos_lean]) = S::sin_cos_each([lean]);
        [z - self.r * (cos_lean * cos_lean).sqrt(), S::from_f64(0.0), S::from_f64(0.0)]
    }
    /// The sum of the magnitudes of the terms of `C`, 3, in SI units: what its rounding is relative to.
    ///
    /// Operations: 3 additions, 2 multiplications, 1 sine-cosine pair, 1 square root.
    #[inline]
    pub fn constraint_magnitudes(&self, t: S, q: &[S; 6]) -> [S; 3] {
        let [_, _, z, _, lean, _] = *q;
        let ([_], [cos_lean]) = S::sin_cos_each([lean]);
        [
            z.abs() + (self.r * (cos_lean * cos_lean).sqrt()).abs(),
            S::from_f64(0.0),
            S::from_f64(0.0),
        ]
    }
    /// Constraint Jacobian `C_q`, 3 x 6: units of each constraint per unit of each coordinate.
    ///
    /// Operations: 6 additions, 14 multiplications, 6 divisions, 2 sine-cosine pairs, 1 square root.
    #[inline]
    pub fn constraint_jacobian(&self, t: S, q: &[S; 6]) -> [[S; 6]; 3] {
        let [_, _, _, psi, lean, _] = *q;
        let ([sin_lean, sin_psi], [cos_lean, cos_psi]) = S::sin_cos_each([lean, psi]);
        let cos_lean_squared = cos_lean * cos_lean;
        let sqrt_cos_lean_squared = cos_lean_squared.sqrt();
        let w = self.r * cos_lean;
        let w_2 = self.r
            * ((S::from_f64(1.0) - sin_lean * sin_lean) / sqrt_cos_lean_squared);
        [
            [
                S::from_f64(0.0),
                S::from_f64(0.0),
                S::from_f64(1.0),
                S::from_f64(0.0),
                sin_lean * sqrt_cos_lean_squared * w / cos_lean_squared,
                S::from_f64(0.0),
            ],
            [
                S::from_f64(1.0),
                S::from_f64(0.0),
                S::from_f64(0.0),
                -(sin_lean * w * cos_psi / sqrt_cos_lean_squared),
                -(sin_psi * w_2),
                -(w * cos_psi / sqrt_cos_lean_squared),
            ],
            [
                S::from_f64(0.0),
                S::from_f64(1.0),
                S::from_f64(0.0),
                -(sin_lean * w * sin_psi / sqrt_cos_lean_squared),
                cos_psi * w_2,
                -(w * sin_psi / sqrt_cos_lean_squared),
            ],
        ]
    }
    /// `C_t`, 3, units of `C` per second: the speeds obey `C_q q' + C_t = 0`.
    ///
    /// Operations: none.
    #[inline]
    pub fn constraint_time_derivative(&self, t: S, q: &[S; 6]) -> [S; 3] {
        [S::from_f64(0.0), S::from_f64(0.0), S::from_f64(0.0)]
    }
    /// `(C_q q' + C_t)_q q' + (..)_t`, 3, units of `C` per second squared: the part of `C''` without accelerations.
    ///
    /// Operations: 46 additions, 90 multiplications, 16 divisions, 3 sine-cosine pairs, 1 square root.
    #[inline]
    pub fn constraint_convective(&self, t: S, q: &[S; 6], qd: &[S; 6]) -> [S; 3] {
        let [_, _, _, psi, lean, phi] = *q;
        let [_, _, _, psi_dot, lean_dot, phi_dot] = *qd;
        let ([sin_lean, sin_psi, sin_phi], [cos_lean, cos_psi, cos_phi]) = S::sin_cos_each([
            lean,
            psi,
            phi,
        ]);
        let cos_lean_squared = cos_lean * cos_lean;
        let sqrt_cos_lean_squared = cos_lean_squared.sqrt();
        let sin_lean_squared = sin_lean * sin_lean;
        let w = S::from_f64(2.0) * self.r;
        let w_2 = sin_lean * psi_dot;
        let w_3 = phi_dot + w_2;
        let w_4 = sin_lean * w_3;
        let w_5 = cos_lean * psi_dot;
        let w_6 = lean_dot * sin_phi + cos_phi * w_5;
        let w_7 = lean_dot * cos_phi - sin_phi * w_5;
        let w_8 = cos_phi * w_6 - sin_phi * w_7;
        let w_9 = cos_lean * w_8;
        let w_10 = w_4 + w_9;
        let w_11 = sin_lean * w_5;
        let w_12 = sin_lean * w_8;
        let w_13 = sin_phi * w_6;
        let w_14 = cos_phi * w_7;
        let w_15 = w_2 - phi_dot;
        let w_16 = phi_dot * w_5;
        let w_17 = lean_dot * cos_phi * w_15 + sin_phi * w_16;
        let w_18 = lean_dot * sin_phi * w_15 - cos_phi * w_16;
        let w_19 = phi_dot * (w_13 + w_14) + cos_phi * w_17 + sin_phi * w_18;
        let w_20 = (lean_dot * (cos_lean * (w_3 + w_2) - w_12) - cos_lean * w_19)
            * sin_lean * cos_lean;
        let w_21 = lean_dot * sin_lean_squared;
        let w_22 = w_10 * w_21;
        let w_23 = cos_lean_squared * sqrt_cos_lean_squared;
        let sqrt_cos_lean_squared_squared = sqrt_cos_lean_squared
            * sqrt_cos_lean_squared;
        let w_24 = cos_lean_squared * sqrt_cos_lean_squared_squared;
        let w_25 = self.r
            * (sin_psi * w_10 * w_11 / sqrt_cos_lean_squared
                - cos_psi
                    * ((w_20 + lean_dot * w_10) / sqrt_cos_lean_squared
                        + w_22 * w_23 / w_24));
        let w_26 = w * w_22;
        let w_27 = self.r
            * ((S::from_f64(1.0) - sin_lean_squared) / sqrt_cos_lean_squared);
        let w_28 = w_14 + w_13;
        let w_29 = psi_dot * w_28
            + (lean_dot * (cos_lean_squared * psi_dot - w_4 - w_9) + sin_lean * w_19);
        let w_30 = cos_lean * w_3 - w_12;
        let w_31 = cos_phi * (w_18 + phi_dot * w_6) - sin_phi * (phi_dot * w_7 + w_17)
            - psi_dot * w_30;
        let w_32 = lean_dot * cos_lean
            * (self.r * sqrt_cos_lean_squared
                * ((sin_lean - sin_lean * sin_lean_squared)
                    / sqrt_cos_lean_squared_squared / cos_lean_squared)
                - sin_lean * w / sqrt_cos_lean_squared);
        let w_33 = self.r
            * (w_10
                * ((cos_psi * w_11 + lean_dot * sin_psi) / sqrt_cos_lean_squared
                    + sin_psi * w_21 * w_23 / w_24)
                + sin_psi * w_20 / sqrt_cos_lean_squared);
        [
            lean_dot * lean_dot * sqrt_cos_lean_squared
                * (sin_lean_squared
                    * (w
                        * (cos_lean / (cos_lean * cos_lean_squared)
                            - S::from_f64(1.0) / cos_lean_squared)
                        - self.r * cos_lean_squared
                            / (cos_lean_squared * cos_lean_squared))
                    + self.r / cos_lean_squared),
            w_25 + cos_psi * w_26 / sqrt_cos_lean_squared
                - w_27 * (cos_psi * w_29 + sin_psi * w_31)
                - (sin_psi * w_28 + cos_psi * w_30) * w_32,
            sin_psi * w_26 / sqrt_cos_lean_squared - w_33
                + w_27 * (cos_psi * w_31 - sin_psi * w_29)
                + w_32 * (cos_psi * w_28 - sin_psi * w_30),
        ]
    }
    /// `C` (3), `C_q` (3 x 6) and `C_t` (3) together, in SI units, for projection.
    ///
    /// Operations: 7 additions, 15 multiplications, 6 divisions, 2 sine-cosine pairs, 1 square root.
    #[inline]
    pub fn constraint_linearization(
        &self,
        t: S,
        q: &[S; 6],
    ) -> sim_kernel::ConstraintLinearization<[S; 3], [[S; 6]; 3]> {
        let [_, _, z, psi, lean, _] = *q;
        let ([sin_lean, sin_psi], [cos_lean, cos_psi]) = S::sin_cos_each([lean, psi]);
        let cos_lean_squared = cos_lean * cos_lean;
        let sqrt_cos_lean_squared = cos_lean_squared.sqrt();
        let w = self.r * cos_lean;
        let w_2 = self.r
            * ((S::from_f64(1.0) - sin_lean * sin_lean) / sqrt_cos_lean_squared);
        sim_kernel::ConstraintLinearization {
            values: [
                z - self.r * sqrt_cos_lean_squared,
                S::from_f64(0.0),
                S::from_f64(0.0),
            ],
            jacobian: [
                [
                    S::from_f64(0.0),
                    S::from_f64(0.0),
                    S::from_f64(1.0),
                    S::from_f64(0.0),
                    sqrt_cos_lean_squared * sin_lean * w / cos_lean_squared,
                    S::from_f64(0.0),
                ],
                [
                    S::from_f64(1.0),
                    S::from_f64(0.0),
                    S::from_f64(0.0),
                    -(sin_lean * w * cos_psi / sqrt_cos_lean_squared),
                    -(sin_psi * w_2),
                    -(w * cos_psi / sqrt_cos_lean_squared),
                ],
                [
                    S::from_f64(0.0),
                    S::from_f64(1.0),
                    S::from_f64(0.0),
                    -(sin_lean * w * sin_psi / sqrt_cos_lean_squared),
                    cos_psi * w_2,
                    -(w * sin_psi / sqrt_cos_lean_squared),
                ],
            ],
            time_derivative: [S::from_f64(0.0), S::from_f64(0.0), S::from_f64(0.0)],
        }
    }
    /// Kinetic energy `v' M v / 2`, in joules.
    ///
    /// Operations: 8 additions, 21 multiplications, 2 sine-cosine pairs.
    #[inline]
    pub fn kinetic_energy(&self, t: S, q: &[S; 6], qd: &[S; 6]) -> S {
        let [_, _, _, _, lean, phi] = *q;
        let [x_dot, y_dot, z_dot, psi_dot, lean_dot, phi_dot] = *qd;
        let w = S::from_f64(0.5) * self.m
            * (x_dot * x_dot + y_dot * y_dot + z_dot * z_dot);
        let r_squared = self.r * self.r;
        let ([sin_phi, sin_lean], [cos_phi, cos_lean]) = S::sin_cos_each([phi, lean]);
        let w_2 = psi_dot * cos_lean;
        let w_3 = lean_dot * cos_phi - sin_phi * w_2;
        let w_4 = lean_dot * sin_phi + cos_phi * w_2;
        let w_5 = phi_dot + psi_dot * sin_lean;
        w + self.m * S::from_f64(0.125) * r_squared * (w_3 * w_3 + w_4 * w_4)
            + w_5 * w_5 * self.m * r_squared * S::from_f64(0.25)
    }
    /// Power of loads and drives, `F' v + lambda' C_t + T_t' (M x'' - F)`, in watts.
    ///
    /// Operations: 1 addition, 2 multiplications.
    #[inline]
    pub fn power(
        &self,
        t: S,
        q: &[S; 6],
        qd: &[S; 6],
        qdd: &[S; 6],
        lambda: &[S; 3],
    ) -> S {
        let [_, _, z_dot, _, _, _] = *qd;
        -(z_dot * self.m * self.g)
    }
    /// Outputs, 3, in SI units.
    ///
    /// Operations: 3 additions, 3 multiplications, 1 square root.
    #[inline]
    pub fn outputs(
        &self,
        t: S,
        q: &[S; 6],
        qd: &[S; 6],
        qdd: &[S; 6],
        lambda: &[S; 3],
    ) -> RollingDiscOutputs<S> {
        let [_, _, _, _, lean, _] = *q;
        let [x_dot, y_dot, z_dot, _, _, _] = *qd;
        let [lambda_ground, _, _] = *lambda;
        [lean, (x_dot * x_dot + y_dot * y_dot + z_dot * z_dot).sqrt(), -lambda_ground]
            .into()
    }
    /// Rates of the outputs that depend on neither accelerations nor multipliers, 2, in SI units per second.
    ///
    /// Operations: 4 additions, 7 multiplications, 1 division, 1 square root.
    #[inline]
    pub fn output_rates(
        &self,
        t: S,
        q: &[S; 6],
        qd: &[S; 6],
        qdd: &[S; 6],
    ) -> RollingDiscOutputRates<S> {
        let [x_dot, y_dot, z_dot, _, lean_dot, _] = *qd;
        let [x_ddot, y_ddot, z_ddot, _, _, _] = *qdd;
        let w = x_dot * x_dot + y_dot * y_dot + z_dot * z_dot;
        [lean_dot, w.sqrt() * (x_dot * x_ddot + y_dot * y_ddot + z_dot * z_ddot) / w]
            .into()
    }
    /// `left - right` of each event, 1, in SI units: zero when it happens.
    ///
    /// Operations: 1 multiplication, 1 sine-cosine pair.
    #[inline]
    pub fn events(
        &self,
        t: S,
        q: &[S; 6],
        qd: &[S; 6],
        qdd: &[S; 6],
        lambda: &[S; 3],
    ) -> [S; 1] {
        let [_, _, _, psi, _, _] = *q;
        let ([w], [_]) = S::sin_cos_each([S::from_f64(0.5) * psi]);
        [w]
    }
    /// The numbers of each shape of the drawing, in metres and radians.
    ///
    /// Operations: 12 additions, 11 multiplications, 3 sine-cosine pairs.
    #[inline]
    pub fn drawing(&self, t: S, q: &[S; 6]) -> [S; 28] {
        let [x, y, z, psi, lean, phi] = *q;
        let ([sin_psi, sin_lean, sin_phi], [cos_psi, cos_lean, cos_phi]) = S::sin_cos_each([
            psi,
            lean,
            phi,
        ]);
        let w = sin_lean * sin_phi;
        [
            -S::from_f64(1.5),
            -S::from_f64(0.5),
            S::from_f64(0.0),
            S::from_f64(1.5),
            -S::from_f64(0.5),
            S::from_f64(0.0),
            S::from_f64(1.5),
            S::from_f64(2.5),
            S::from_f64(0.0),
            -S::from_f64(1.5),
            S::from_f64(2.5),
            S::from_f64(0.0),
            -S::from_f64(1.5),
            -S::from_f64(0.5),
            S::from_f64(0.0),
            x,
            y,
            z,
            self.r,
            -(sin_psi * cos_lean),
            cos_lean * cos_psi,
            sin_lean,
            x,
            y,
            z,
            x + self.r * (cos_psi * cos_phi - sin_psi * w),
            y + self.r * (sin_psi * cos_phi + cos_psi * w),
            z - self.r * cos_lean * sin_phi,
        ]
    }
    /// Declared start: values or guesses of the coordinates (6), and speeds (6), in SI units; 0 where nothing is declared.
    ///
    /// Operations: 3 additions, 14 multiplications, 1 division, 1 sine-cosine pair.
    #[inline]
    pub fn initial(&self) -> sim_kernel::Initial<[S; 6]> {
        let ([sin_lean0], [cos_lean0]) = S::sin_cos_each([self.lean0]);
        let w = self.m * self.r * self.r;
        let w_2 = self.turning * sin_lean0
            + S::from_f64(0.16666666666666666)
                * (self.r * sin_lean0 * self.m * S::from_f64(4.0) * self.g
                    - sin_lean0 * cos_lean0 * self.turning * self.turning * w)
                / (self.turning * cos_lean0 * w);
        sim_kernel::Initial {
            positions: [
                S::from_f64(0.0),
                S::from_f64(0.0),
                self.r,
                S::from_f64(0.0),
                self.lean0,
                S::from_f64(0.0),
            ],
            speeds: [
                S::from_f64(0.0),
                S::from_f64(0.0),
                S::from_f64(0.0),
                self.turning,
                self.nod,
                -w_2,
            ],
        }
    }
    /// [`RollingDiscPrepared::dynamics`] once; for many calls with the same parameters [`Self::prepare`] first.
    #[inline]
    pub fn dynamics(
        &self,
        t: S,
        q: &[S; 6],
        qd: &[S; 6],
    ) -> sim_kernel::Dynamics<S, [S; 6], [S; 3]> {
        self.prepare().dynamics(t, q, qd)
    }
    /// [`RollingDiscPrepared::dynamics_jacobian`] once; for many calls with the same parameters [`Self::prepare`] first.
    #[inline]
    pub fn dynamics_jacobian(
        &self,
        t: S,
        q: &[S; 6],
        qd: &[S; 6],
    ) -> sim_kernel::DynamicsJacobian<S, [[S; 6]; 6], [[S; 6]; 3]> {
        self.prepare().dynamics_jacobian(t, q, qd)
    }
}
#[allow(non_snake_case, unused_variables, unused_parens, clippy::all, clippy::pedantic)]
impl<S: sim_kernel::Scalar> RollingDiscPrepared<S> {
    /// Accelerations (6), multipliers (3) and power, from
    ///
    /// ```text
    /// [ T_q' M T_q   C_q' ] [ q''    ]   [ T_q' (F - M g)                      ]
    /// [ C_q          0    ] [ lambda ] = [ -(C_q q' + C_t)_q q' - (..)_t       ]
    /// ```
    ///
    /// by an elimination planned from the structure of the system. Where `refused` is set a pivot was too small and nothing else holds: solve that state from the other kernels.
    ///
    /// Operations: 94 additions, 172 multiplications, 26 divisions, 3 sine-cosine pairs, 1 square root.
    #[inline(always)]
    pub fn dynamics(
        &self,
        t: S,
        q: &[S; 6],
        qd: &[S; 6],
    ) -> sim_kernel::Dynamics<S, [S; 6], [S; 3]> {
        let [_, _, _, psi, lean, phi] = *q;
        let [_, _, z_dot, psi_dot, lean_dot, phi_dot] = *qd;
        let ([sin_lean, sin_psi, sin_phi], [cos_lean, cos_psi, cos_phi]) = S::sin_cos_each([
            lean,
            psi,
            phi,
        ]);
        let rhs_lean = cos_lean
            * (self.C_ * psi_dot * phi_dot + sin_lean * self.A_ * psi_dot * psi_dot);
        let w = sin_lean * psi_dot;
        let minus_rhs_psi = self.C_ * cos_lean * lean_dot * (w + phi_dot);
        let mass_phi_psi = sin_lean * self.C_;
        let sin_lean_squared = sin_lean * sin_lean;
        let mass_psi_psi = self.A_ * (S::from_f64(1.0) + sin_lean_squared);
        let inverse_psi = S::from_f64(1.0) / mass_psi_psi;
        let l_phi_psi = mass_phi_psi * inverse_psi;
        let w_2 = cos_lean * psi_dot;
        let rhs_phi = minus_rhs_psi * l_phi_psi - self.C_ * lean_dot * w_2;
        let cos_lean_squared = cos_lean * cos_lean;
        let sqrt_cos_lean_squared = cos_lean_squared.sqrt();
        let w_3 = sqrt_cos_lean_squared * lean_dot * lean_dot
            * (sin_lean_squared
                * (self.k_2
                    * (cos_lean / (cos_lean * cos_lean_squared)
                        - S::from_f64(1.0) / cos_lean_squared)
                    - self.r * cos_lean_squared / (cos_lean_squared * cos_lean_squared))
                + self.r / cos_lean_squared);
        let w_4 = sin_lean * cos_lean;
        let w_5 = self.r * w_4;
        let ground_by_lean = sqrt_cos_lean_squared * w_5 / cos_lean_squared;
        let l_lambda_ground_lean = ground_by_lean * self.inverse_lean;
        let rhs_lambda_ground = self.k_3 - w_3 - rhs_lean * l_lambda_ground_lean;
        let w_6 = self.r
            * ((S::from_f64(1.0) - sin_lean_squared) / sqrt_cos_lean_squared);
        let minus_ground_f1_by_lean = sin_psi * w_6;
        let minus_l_lambda_ground_f1_lean = minus_ground_f1_by_lean * self.inverse_lean;
        let w_7 = phi_dot + w;
        let w_8 = sin_lean * w_7;
        let w_9 = cos_phi * w_2;
        let w_10 = sin_phi * lean_dot + w_9;
        let w_11 = sin_phi * w_2;
        let w_12 = lean_dot * cos_phi - w_11;
        let w_13 = cos_phi * w_10 - sin_phi * w_12;
        let w_14 = cos_lean * w_13;
        let w_15 = w_8 + w_14;
        let w_16 = w_4 * sin_psi;
        let w_17 = w_10 * phi_dot;
        let w_18 = w - phi_dot;
        let w_19 = sin_phi * lean_dot * w_18 - w_9 * phi_dot;
        let w_20 = lean_dot * cos_phi * w_18 + phi_dot * w_11;
        let w_21 = phi_dot * w_12;
        let w_22 = sin_phi * (w_17 + w_19) + cos_phi * (w_20 + w_21);
        let w_23 = sin_lean * w_13;
        let w_24 = cos_lean * (lean_dot * (w_7 + w) - w_22) - lean_dot * w_23;
        let w_25 = sin_lean_squared * lean_dot;
        let w_26 = w_15 * w_25;
        let w_27 = cos_lean_squared * sqrt_cos_lean_squared;
        let sqrt_cos_lean_squared_squared = sqrt_cos_lean_squared
            * sqrt_cos_lean_squared;
        let w_28 = cos_lean_squared * sqrt_cos_lean_squared_squared;
        let w_29 = self.r
            * (psi_dot * w_15 * w_16 / sqrt_cos_lean_squared
                - cos_psi
                    * ((w_4 * w_24 + lean_dot * w_15) / sqrt_cos_lean_squared
                        + w_26 * w_27 / w_28));
        let w_30 = self.k_2 * w_26;
        let w_31 = cos_phi * w_12 + sin_phi * w_10;
        let w_32 = psi_dot * w_31
            + (lean_dot * (cos_lean_squared * psi_dot - w_8 - w_14) + sin_lean * w_22);
        let w_33 = cos_lean * w_7 - w_23;
        let w_34 = cos_phi * (w_19 + w_17) - sin_phi * (w_21 + w_20) - psi_dot * w_33;
        let w_35 = cos_lean * lean_dot
            * (self.r * sqrt_cos_lean_squared
                * ((sin_lean - sin_lean * sin_lean_squared)
                    / sqrt_cos_lean_squared_squared / cos_lean_squared)
                - sin_lean * self.k_2 / sqrt_cos_lean_squared);
        let w_36 = w_29 + cos_psi * w_30 / sqrt_cos_lean_squared
            - w_6 * (cos_psi * w_32 + sin_psi * w_34)
            - (sin_psi * w_31 + cos_psi * w_33) * w_35;
        let minus_ground_f1_by_psi = w_5 * cos_psi / sqrt_cos_lean_squared;
        let minus_l_lambda_ground_f1_psi = minus_ground_f1_by_psi * inverse_psi;
        let pivot_phi = self.C_ - mass_phi_psi * l_phi_psi;
        let inverse_phi = S::from_f64(1.0) / pivot_phi;
        let w_37 = self.r * cos_lean;
        let k_lambda_ground_f1_phi = mass_phi_psi * minus_l_lambda_ground_f1_psi
            - cos_psi * w_37 / sqrt_cos_lean_squared;
        let l_lambda_ground_f1_phi = inverse_phi * k_lambda_ground_f1_phi;
        let k_lambda_ground_f1_lambda_ground = ground_by_lean
            * minus_l_lambda_ground_f1_lean;
        let minus_pivot_lambda_ground = self.inverse_z
            + ground_by_lean * l_lambda_ground_lean;
        let minus_inverse_lambda_ground = S::from_f64(1.0) / minus_pivot_lambda_ground;
        let minus_l_lambda_ground_f1_lambda_ground = k_lambda_ground_f1_lambda_ground
            * minus_inverse_lambda_ground;
        let rhs_lambda_ground_f1 = rhs_lean * minus_l_lambda_ground_f1_lean - w_36
            - minus_rhs_psi * minus_l_lambda_ground_f1_psi
            - l_lambda_ground_f1_phi * rhs_phi
            + minus_l_lambda_ground_f1_lambda_ground * rhs_lambda_ground;
        let w_38 = minus_ground_f1_by_psi * minus_l_lambda_ground_f1_psi
            + minus_ground_f1_by_lean * minus_l_lambda_ground_f1_lean + self.inverse_z
            + k_lambda_ground_f1_phi * l_lambda_ground_f1_phi;
        let pivot_lambda_ground_f1 = k_lambda_ground_f1_lambda_ground
            * minus_l_lambda_ground_f1_lambda_ground - w_38;
        let inverse_lambda_ground_f1 = S::from_f64(1.0) / pivot_lambda_ground_f1;
        let ground_f2_by_lean = cos_psi * w_6;
        let l_lambda_ground_f2_lean = ground_f2_by_lean * self.inverse_lean;
        let minus_ground_f2_by_psi = w_5 * sin_psi / sqrt_cos_lean_squared;
        let minus_l_lambda_ground_f2_psi = minus_ground_f2_by_psi * inverse_psi;
        let k_lambda_ground_f2_phi = mass_phi_psi * minus_l_lambda_ground_f2_psi
            - sin_psi * w_37 / sqrt_cos_lean_squared;
        let l_lambda_ground_f2_phi = inverse_phi * k_lambda_ground_f2_phi;
        let minus_k_lambda_ground_f2_lambda_ground = ground_by_lean
            * l_lambda_ground_f2_lean;
        let l_lambda_ground_f2_lambda_ground = minus_k_lambda_ground_f2_lambda_ground
            * minus_inverse_lambda_ground;
        let k_lambda_ground_f2_lambda_ground_f1 = minus_ground_f1_by_lean
            * l_lambda_ground_f2_lean
            - minus_ground_f1_by_psi * minus_l_lambda_ground_f2_psi
            - k_lambda_ground_f1_phi * l_lambda_ground_f2_phi
            - k_lambda_ground_f1_lambda_ground * l_lambda_ground_f2_lambda_ground;
        let l_lambda_ground_f2_lambda_ground_f1 = inverse_lambda_ground_f1
            * k_lambda_ground_f2_lambda_ground_f1;
        let w_39 = minus_ground_f2_by_psi * minus_l_lambda_ground_f2_psi
            + ground_f2_by_lean * l_lambda_ground_f2_lean
            + k_lambda_ground_f2_phi * l_lambda_ground_f2_phi + self.inverse_z;
        let pivot_lambda_ground_f2 = minus_k_lambda_ground_f2_lambda_ground
            * l_lambda_ground_f2_lambda_ground - w_39
            - k_lambda_ground_f2_lambda_ground_f1 * l_lambda_ground_f2_lambda_ground_f1;
        let w_40 = self.r
            * (w_15
                * ((w_4 * cos_psi * psi_dot + sin_psi * lean_dot) / sqrt_cos_lean_squared
                    + sin_psi * w_25 * w_27 / w_28)
                + w_24 * w_16 / sqrt_cos_lean_squared);
        let w_41 = sin_psi * w_30 / sqrt_cos_lean_squared - w_40
            + w_6 * (cos_psi * w_34 - sin_psi * w_32)
            + w_35 * (cos_psi * w_31 - sin_psi * w_33);
        let minus_lambda_ground_f2 = S::from_f64(1.0) / pivot_lambda_ground_f2
            * (w_41 + minus_rhs_psi * minus_l_lambda_ground_f2_psi
                + rhs_lean * l_lambda_ground_f2_lean + l_lambda_ground_f2_phi * rhs_phi
                + l_lambda_ground_f2_lambda_ground * rhs_lambda_ground
                + l_lambda_ground_f2_lambda_ground_f1 * rhs_lambda_ground_f1);
        let lambda_ground_f1 = inverse_lambda_ground_f1 * rhs_lambda_ground_f1
            + l_lambda_ground_f2_lambda_ground_f1 * minus_lambda_ground_f2;
        let lambda_ground = minus_l_lambda_ground_f1_lambda_ground * lambda_ground_f1
            - minus_inverse_lambda_ground * rhs_lambda_ground
            + l_lambda_ground_f2_lambda_ground * minus_lambda_ground_f2;
        let phi_ddot = inverse_phi * rhs_phi - l_lambda_ground_f1_phi * lambda_ground_f1
            + l_lambda_ground_f2_phi * minus_lambda_ground_f2;
        sim_kernel::Dynamics {
            accelerations: [
                -(self.inverse_z * lambda_ground_f1),
                self.inverse_z * minus_lambda_ground_f2,
                -(self.k_3 + self.inverse_z * lambda_ground),
                minus_l_lambda_ground_f1_psi * lambda_ground_f1
                    - minus_rhs_psi * inverse_psi - l_phi_psi * phi_ddot
                    - minus_l_lambda_ground_f2_psi * minus_lambda_ground_f2,
                rhs_lean * self.inverse_lean - l_lambda_ground_lean * lambda_ground
                    + minus_l_lambda_ground_f1_lean * lambda_ground_f1
                    + l_lambda_ground_f2_lean * minus_lambda_ground_f2,
                phi_ddot,
            ],
            multipliers: [lambda_ground, lambda_ground_f1, -minus_lambda_ground_f2],
            power: -(self.minus_rhs_z * z_dot),
            refused: sim_kernel::pivot_is_refused(self.m, self.m)
                | sim_kernel::pivot_is_refused(mass_psi_psi, mass_psi_psi)
                | sim_kernel::pivot_is_refused(self.A_, self.A_)
                | sim_kernel::pivot_is_refused(self.m, self.m)
                | sim_kernel::pivot_is_refused(pivot_phi, self.C_)
                | sim_kernel::pivot_is_refused(
                    -minus_pivot_lambda_ground,
                    minus_pivot_lambda_ground,
                ) | sim_kernel::pivot_is_refused(self.m, self.m)
                | sim_kernel::pivot_is_refused(pivot_lambda_ground_f1, w_38)
                | sim_kernel::pivot_is_refused(pivot_lambda_ground_f2, w_39),
        }
    }
    /// The derivatives of accelerations (6 rows) and multipliers (3 rows) with respect to coordinates and speeds (6 columns each): with the equations of motion as `K z = r`, the solutions of `K dz = dr - dK z`. Where `refused` is set a pivot was too small and nothing else holds.
    ///
    /// Operations: 401 additions, 604 multiplications, 79 divisions, 3 sine-cosine pairs, 1 square root.
    #[inline]
    pub fn dynamics_jacobian(
        &self,
        t: S,
        q: &[S; 6],
        qd: &[S; 6],
    ) -> sim_kernel::DynamicsJacobian<S, [[S; 6]; 6], [[S; 6]; 3]> {
        let [_, _, _, psi, lean, phi] = *q;
        let [_, _, _, psi_dot, lean_dot, phi_dot] = *qd;
        let ([sin_lean, sin_psi, sin_phi], [cos_lean, cos_psi, cos_phi]) = S::sin_cos_each([
            lean,
            psi,
            phi,
        ]);
        let rhs_lean = cos_lean
            * (self.C_ * psi_dot * phi_dot + sin_lean * self.A_ * psi_dot * psi_dot);
        let w = sin_lean * psi_dot;
        let minus_rhs_psi = self.C_ * cos_lean * lean_dot * (w + phi_dot);
        let mass_phi_psi = sin_lean * self.C_;
        let sin_lean_squared = sin_lean * sin_lean;
        let mass_psi_psi = self.A_ * (S::from_f64(1.0) + sin_lean_squared);
        let inverse_psi = S::from_f64(1.0) / mass_psi_psi;
        let l_phi_psi = mass_phi_psi * inverse_psi;
        let w_2 = cos_lean * psi_dot;
        let w_3 = self.C_ * lean_dot;
        let rhs_phi = minus_rhs_psi * l_phi_psi - w_2 * w_3;
        let cos_lean_squared = cos_lean * cos_lean;
        let sqrt_cos_lean_squared = cos_lean_squared.sqrt();
        let lean_dot_squared = lean_dot * lean_dot;
        let w_4 = cos_lean * cos_lean_squared;
        let w_5 = cos_lean / w_4;
        let inverse_cos_lean_squared = S::from_f64(1.0) / cos_lean_squared;
        let cos_lean_squared_squared = cos_lean_squared * cos_lean_squared;
        let w_6 = self.r * cos_lean_squared / cos_lean_squared_squared;
        let w_7 = self.r / cos_lean_squared;
        let w_8 = sin_lean * cos_lean;
        let w_9 = self.r * sqrt_cos_lean_squared;
        let ground_by_lean = w_8 * w_9 / cos_lean_squared;
        let l_lambda_ground_lean = ground_by_lean * self.inverse_lean;
        let rhs_lambda_ground = self.k_3
            - sqrt_cos_lean_squared * lean_dot_squared
                * (sin_lean_squared * (self.k_2 * (w_5 - inverse_cos_lean_squared) - w_6)
                    + w_7) - rhs_lean * l_lambda_ground_lean;
        let w_10 = self.r
            * ((S::from_f64(1.0) - sin_lean_squared) / sqrt_cos_lean_squared);
        let minus_ground_f1_by_lean = sin_psi * w_10;
        let minus_l_lambda_ground_f1_lean = minus_ground_f1_by_lean * self.inverse_lean;
        let w_11 = phi_dot + w;
        let w_12 = sin_lean * w_11;
        let w_13 = cos_phi * w_2;
        let w_14 = sin_phi * lean_dot + w_13;
        let w_15 = sin_phi * w_2;
        let w_16 = lean_dot * cos_phi - w_15;
        let w_17 = cos_phi * w_14 - sin_phi * w_16;
        let w_18 = cos_lean * w_17;
        let w_19 = w_12 + w_18;
        let w_20 = sin_psi * w_19;
        let w_21 = w_8 * psi_dot * w_20 / sqrt_cos_lean_squared;
        let w_22 = w_14 * phi_dot;
        let w_23 = w - phi_dot;
        let w_24 = sin_phi * lean_dot * w_23 - w_13 * phi_dot;
        let w_25 = lean_dot * cos_phi * w_23 + phi_dot * w_15;
        let w_26 = phi_dot * w_16;
        let w_27 = sin_phi * (w_22 + w_24) + cos_phi * (w_25 + w_26);
        let w_28 = sin_lean * lean_dot;
        let w_29 = cos_lean * (lean_dot * (w_11 + w) - w_27) - w_28 * w_17;
        let w_30 = w_8 * w_29;
        let w_31 = lean_dot * w_19;
        let w_32 = sin_lean_squared * lean_dot;
        let w_33 = cos_lean_squared * sqrt_cos_lean_squared;
        let w_34 = w_32 * w_33;
        let sqrt_cos_lean_squared_squared = sqrt_cos_lean_squared
            * sqrt_cos_lean_squared;
        let w_35 = cos_lean_squared * sqrt_cos_lean_squared_squared;
        let w_36 = w_19 * w_34 / w_35;
        let w_37 = self.k_2 * w_32;
        let w_38 = cos_psi * w_37;
        let w_39 = w_19 * w_38 / sqrt_cos_lean_squared;
        let w_40 = cos_phi * w_16;
        let w_41 = sin_phi * w_14;
        let w_42 = w_40 + w_41;
        let w_43 = cos_lean_squared * psi_dot;
        let w_44 = sin_lean * w_27;
        let w_45 = psi_dot * w_42 + (lean_dot * (w_43 - w_12 - w_18) + w_44);
        let w_46 = sin_lean * w_17;
        let w_47 = cos_lean * w_11 - w_46;
        let w_48 = cos_phi * (w_24 + w_22) - sin_phi * (w_26 + w_25) - psi_dot * w_47;
        let w_49 = cos_psi * w_45 + sin_psi * w_48;
        let w_50 = sin_psi * w_42 + cos_psi * w_47;
        let w_51 = sin_lean * sin_lean_squared;
        let w_52 = sin_lean * self.k_2 / sqrt_cos_lean_squared;
        let w_53 = cos_lean * lean_dot
            * (self.r * sqrt_cos_lean_squared
                * ((sin_lean - w_51) / sqrt_cos_lean_squared_squared / cos_lean_squared)
                - w_52);
        let w_54 = w_50 * w_53;
        let w_55 = self.r * w_8;
        let minus_ground_f1_by_psi = cos_psi * w_55 / sqrt_cos_lean_squared;
        let minus_l_lambda_ground_f1_psi = minus_ground_f1_by_psi * inverse_psi;
        let pivot_phi = self.C_ - mass_phi_psi * l_phi_psi;
        let inverse_phi = S::from_f64(1.0) / pivot_phi;
        let w_56 = self.r * cos_lean;
        let k_lambda_ground_f1_phi = mass_phi_psi * minus_l_lambda_ground_f1_psi
            - cos_psi * w_56 / sqrt_cos_lean_squared;
        let l_lambda_ground_f1_phi = inverse_phi * k_lambda_ground_f1_phi;
        let k_lambda_ground_f1_lambda_ground = ground_by_lean
            * minus_l_lambda_ground_f1_lean;
        let minus_pivot_lambda_ground = self.inverse_z
            + ground_by_lean * l_lambda_ground_lean;
        let minus_inverse_lambda_ground = S::from_f64(1.0) / minus_pivot_lambda_ground;
        let minus_l_lambda_ground_f1_lambda_ground = k_lambda_ground_f1_lambda_ground
            * minus_inverse_lambda_ground;
        let rhs_lambda_ground_f1 = rhs_lean * minus_l_lambda_ground_f1_lean
            - (self.r * (w_21 - cos_psi * ((w_30 + w_31) / sqrt_cos_lean_squared + w_36))
                + w_39 - w_10 * w_49 - w_54)
            - minus_rhs_psi * minus_l_lambda_ground_f1_psi
            - l_lambda_ground_f1_phi * rhs_phi
            + minus_l_lambda_ground_f1_lambda_ground * rhs_lambda_ground;
        let w_57 = minus_ground_f1_by_psi * minus_l_lambda_ground_f1_psi
            + minus_ground_f1_by_lean * minus_l_lambda_ground_f1_lean + self.inverse_z
            + k_lambda_ground_f1_phi * l_lambda_ground_f1_phi;
        let pivot_lambda_ground_f1 = k_lambda_ground_f1_lambda_ground
            * minus_l_lambda_ground_f1_lambda_ground - w_57;
        let inverse_lambda_ground_f1 = S::from_f64(1.0) / pivot_lambda_ground_f1;
        let w_58 = cos_psi * w_48 - sin_psi * w_45;
        let ground_f2_by_lean = cos_psi * w_10;
        let l_lambda_ground_f2_lean = ground_f2_by_lean * self.inverse_lean;
        let minus_ground_f2_by_psi = w_55 * sin_psi / sqrt_cos_lean_squared;
        let minus_l_lambda_ground_f2_psi = minus_ground_f2_by_psi * inverse_psi;
        let k_lambda_ground_f2_phi = mass_phi_psi * minus_l_lambda_ground_f2_psi
            - sin_psi * w_56 / sqrt_cos_lean_squared;
        let l_lambda_ground_f2_phi = inverse_phi * k_lambda_ground_f2_phi;
        let minus_k_lambda_ground_f2_lambda_ground = ground_by_lean
            * l_lambda_ground_f2_lean;
        let l_lambda_ground_f2_lambda_ground = minus_k_lambda_ground_f2_lambda_ground
            * minus_inverse_lambda_ground;
        let k_lambda_ground_f2_lambda_ground_f1 = minus_ground_f1_by_lean
            * l_lambda_ground_f2_lean
            - minus_ground_f1_by_psi * minus_l_lambda_ground_f2_psi
            - k_lambda_ground_f1_phi * l_lambda_ground_f2_phi
            - k_lambda_ground_f1_lambda_ground * l_lambda_ground_f2_lambda_ground;
        let l_lambda_ground_f2_lambda_ground_f1 = inverse_lambda_ground_f1
            * k_lambda_ground_f2_lambda_ground_f1;
        let w_59 = minus_ground_f2_by_psi * minus_l_lambda_ground_f2_psi
            + ground_f2_by_lean * l_lambda_ground_f2_lean
            + k_lambda_ground_f2_phi * l_lambda_ground_f2_phi + self.inverse_z;
        let pivot_lambda_ground_f2 = minus_k_lambda_ground_f2_lambda_ground
            * l_lambda_ground_f2_lambda_ground - w_59
            - k_lambda_ground_f2_lambda_ground_f1 * l_lambda_ground_f2_lambda_ground_f1;
        let inverse_lambda_ground_f2 = S::from_f64(1.0) / pivot_lambda_ground_f2;
        let w_60 = w_20 * w_37 / sqrt_cos_lean_squared;
        let w_61 = cos_psi * psi_dot;
        let w_62 = sin_psi * lean_dot;
        let w_63 = sin_psi * w_34 / w_35;
        let w_64 = cos_psi * w_42 - sin_psi * w_47;
        let w_65 = w_53 * w_64;
        let w_66 = w_60
            - self.r
                * (w_19 * ((w_8 * w_61 + w_62) / sqrt_cos_lean_squared + w_63)
                    + sin_psi * w_30 / sqrt_cos_lean_squared) + w_10 * w_58 + w_65;
        let minus_lambda_ground_f2 = inverse_lambda_ground_f2
            * (w_66 + minus_rhs_psi * minus_l_lambda_ground_f2_psi
                + rhs_lean * l_lambda_ground_f2_lean + l_lambda_ground_f2_phi * rhs_phi
                + l_lambda_ground_f2_lambda_ground * rhs_lambda_ground
                + l_lambda_ground_f2_lambda_ground_f1 * rhs_lambda_ground_f1);
        let lambda_ground_f1 = inverse_lambda_ground_f1 * rhs_lambda_ground_f1
            + l_lambda_ground_f2_lambda_ground_f1 * minus_lambda_ground_f2;
        let lambda_ground = minus_l_lambda_ground_f1_lambda_ground * lambda_ground_f1
            - minus_inverse_lambda_ground * rhs_lambda_ground
            + l_lambda_ground_f2_lambda_ground * minus_lambda_ground_f2;
        let lean_ddot = rhs_lean * self.inverse_lean
            - l_lambda_ground_lean * lambda_ground
            + minus_l_lambda_ground_f1_lean * lambda_ground_f1
            + l_lambda_ground_f2_lean * minus_lambda_ground_f2;
        let phi_ddot = inverse_phi * rhs_phi - l_lambda_ground_f1_phi * lambda_ground_f1
            + l_lambda_ground_f2_phi * minus_lambda_ground_f2;
        let psi_ddot = minus_l_lambda_ground_f1_psi * lambda_ground_f1
            - minus_rhs_psi * inverse_psi - l_phi_psi * phi_ddot
            - minus_l_lambda_ground_f2_psi * minus_lambda_ground_f2;
        let w_67 = w_29 + psi_ddot;
        let w_68 = self.r
            * ((sin_lean * cos_lean * (sin_psi * w_67 + w_19 * w_61) + lean_dot * w_20)
                / sqrt_cos_lean_squared + w_34 * w_20 / w_35);
        let w_69 = self.r * sin_lean_squared;
        let w_70 = w_69 / sqrt_cos_lean_squared + w_10;
        let w_71 = cos_lean * sin_psi * w_70;
        let w_72 = sin_psi * lambda_ground_f1;
        let w_73 = cos_psi * minus_lambda_ground_f2;
        let w_74 = self.r * sin_lean * cos_lean
            * ((w_72 + w_73) / sqrt_cos_lean_squared);
        let w_75 = cos_psi * lambda_ground_f1;
        let w_76 = sin_psi * minus_lambda_ground_f2;
        let w_77 = w_75 - w_76;
        let w_78 = w_10 * w_77;
        let w_79 = cos_lean * cos_psi * w_70;
        let w_80 = l_phi_psi * w_74
            - (w_71 * lambda_ground_f1 + w_79 * minus_lambda_ground_f2);
        let w_81 = l_lambda_ground_lean * w_78;
        let w_82 = w_10 * (w_58 + cos_psi * lean_ddot) - w_68 + w_60 + w_65
            - w_71 * phi_ddot - minus_l_lambda_ground_f1_psi * w_74
            + minus_l_lambda_ground_f1_lean * w_78 - l_lambda_ground_f1_phi * w_80
            - minus_l_lambda_ground_f1_lambda_ground * w_81;
        let w_83 = self.r
            * (cos_psi
                * ((sin_lean * cos_lean * w_67 + w_31) / sqrt_cos_lean_squared + w_36)
                - w_21) + w_10 * (w_49 + sin_psi * lean_ddot) - w_39 + w_54
            + w_79 * phi_ddot;
        let w_84 = inverse_lambda_ground_f2
            * (w_83 - minus_l_lambda_ground_f2_psi * w_74
                - l_lambda_ground_f2_lean * w_78 - l_lambda_ground_f2_phi * w_80
                + l_lambda_ground_f2_lambda_ground * w_81
                - l_lambda_ground_f2_lambda_ground_f1 * w_82);
        let w_85 = inverse_lambda_ground_f1 * w_82
            - l_lambda_ground_f2_lambda_ground_f1 * w_84;
        let w_86 = cos_lean_squared * self.k_2;
        let w_87 = self.r * w_4;
        let w_88 = sqrt_cos_lean_squared
            * ((w_51
                * (w_86 / w_4 - cos_lean * self.k_8 / cos_lean_squared
                    - w_87 / cos_lean_squared_squared)
                + w_8 * self.k_4 / cos_lean_squared) / sqrt_cos_lean_squared_squared);
        let w_89 = sqrt_cos_lean_squared * sqrt_cos_lean_squared_squared;
        let w_90 = w_19
            * (w_88 - w_8 * self.k_5 / sqrt_cos_lean_squared
                + w_4 * self.k_2 * sqrt_cos_lean_squared_squared * w_51
                    / (cos_lean_squared_squared * w_89));
        let w_91 = self.r * w_33 / w_35;
        let w_92 = self.k_2 / sqrt_cos_lean_squared;
        let w_93 = lean_dot
            * (w_90
                + w_47
                    * (sin_lean_squared * (w_91 - w_92)
                        + self.r / sqrt_cos_lean_squared));
        let w_94 = sin_lean * phi_dot;
        let w_95 = cos_lean * cos_phi;
        let w_96 = psi_dot * (sin_phi * w_94 - lean_dot * w_95);
        let w_97 = cos_lean * sin_phi;
        let w_98 = psi_dot * (cos_phi * w_94 + lean_dot * w_97);
        let w_99 = cos_phi * w_96 - sin_phi * w_98;
        let w_100 = self.r
            * (w_29
                - w_8
                    * (lean_dot
                        * (S::from_f64(2.0) * psi_dot
                            * (sin_lean_squared - S::from_f64(1.0)) + w_12 + w_18) - w_44
                        - cos_lean * w_99) + psi_ddot);
        let w_101 = psi_dot - w_12 - w_18;
        let w_102 = w_93
            + (w_100 - self.k_2 * sin_lean_squared * w_67) / sqrt_cos_lean_squared
            + self.r * sin_lean_squared * cos_lean_squared * sqrt_cos_lean_squared
                * (w_67 / sqrt_cos_lean_squared_squared / cos_lean_squared)
            + w_53 * w_101;
        let w_103 = sin_lean_squared * w_19;
        let w_104 = self.k_2 * w_103 / sqrt_cos_lean_squared;
        let w_105 = w_33 * w_103 / w_35;
        let w_106 = self.r * ((w_8 * w_47 + w_19) / sqrt_cos_lean_squared + w_105);
        let w_107 = cos_lean * (sin_lean * (w_92 - w_9 / w_35) + w_9 * w_51 / w_35);
        let w_108 = lean_ddot * w_107;
        let w_109 = cos_phi * w_98 + sin_phi * w_96 - phi_dot * w - psi_dot * w_101;
        let w_110 = cos_lean * (lean_dot * (w_11 + w * S::from_f64(2.0)) - w_27)
            + sin_lean * (w_99 - lean_dot * w_17);
        let w_111 = cos_lean * self.k_2 / w_4;
        let sin_lean_squared_squared = sin_lean_squared * sin_lean_squared;
        let w_112 = sqrt_cos_lean_squared
            * ((sin_lean_squared * (self.k_9 / cos_lean_squared - w_111 + w_6)
                + sin_lean_squared_squared * (w_111 - self.k_8 / cos_lean_squared - w_6)
                - w_7) / sqrt_cos_lean_squared_squared);
        let w_113 = lean_dot
            * (w_112
                + self.k_2
                    * (cos_lean_squared * sqrt_cos_lean_squared_squared
                        * ((sin_lean_squared_squared - sin_lean_squared) / w_89
                            / cos_lean_squared_squared)
                        + S::from_f64(1.0) / sqrt_cos_lean_squared)
                - sin_lean_squared * self.k_5 / sqrt_cos_lean_squared);
        let w_114 = self.k_4 / sqrt_cos_lean_squared;
        let w_115 = w_51 * (w_114 - w_91) + sin_lean * (w_10 - w_92) + cos_lean * w_107;
        let w_116 = cos_psi * w_115;
        let w_117 = cos_psi * w_102 + sin_psi * (psi_dot * (w_104 - w_106) - w_108)
            + w_10 * (sin_psi * w_109 - cos_psi * w_110) - w_49 * w_107 - w_50 * w_113
            - phi_ddot * w_116;
        let w_118 = lean_dot * psi_dot;
        let w_119 = sin_lean_squared
            * (self.k_2 * ((w_76 - w_75) / sqrt_cos_lean_squared)
                + self.r * cos_lean_squared * sqrt_cos_lean_squared
                    * (w_77 / sqrt_cos_lean_squared_squared / cos_lean_squared)
                + self.k * w_118);
        let w_120 = psi_dot * w_28;
        let w_121 = sin_lean
            * (sin_phi * self.k * (w_14 * w_11 + (w_22 - sin_phi * w_120))
                + cos_phi * self.k * (w_11 * w_16 + (w_26 - cos_phi * w_120)));
        let w_122 = self.k * (psi_dot * (cos_lean * w_14 - cos_phi * w_12) - w_98);
        let w_123 = self.k * (psi_dot * (sin_phi * w_12 + cos_lean * w_16) + w_96);
        let w_124 = w_119
            + S::from_f64(0.25)
                * (w_121 - cos_lean * (sin_phi * w_122 + cos_phi * w_123))
            - self.C_ * (cos_lean * (sin_lean * psi_ddot + phi_ddot) + w_118)
            + self.r * (w_77 / sqrt_cos_lean_squared);
        let w_125 = inverse_cos_lean_squared - w_5;
        let w_126 = sin_lean_squared * (self.k_2 * w_125 + w_6) - w_7;
        let w_127 = sqrt_cos_lean_squared * lambda_ground * w_126
            + S::from_f64(0.25) * (cos_phi * w_122 - sin_phi * w_123)
            - w_107 * (w_73 + w_72);
        let w_128 = sin_psi * w_115;
        let w_129 = self.C_ * (w_120 - cos_lean * psi_ddot) - lambda_ground_f1 * w_116
            + minus_lambda_ground_f2 * w_128 - l_phi_psi * w_124;
        let w_130 = w_51
            * (self.k_6 / w_4 - cos_lean * self.k_7 / cos_lean_squared_squared
                + cos_lean_squared * self.k_8 / (cos_lean * cos_lean_squared_squared)
                - w_87 / (w_4 * w_4));
        let w_131 = sqrt_cos_lean_squared
            * (lean_dot_squared
                * (w_130
                    + sin_lean
                        * (cos_lean
                            * (self.k_5 / cos_lean_squared
                                + self.k_4 / cos_lean_squared_squared) - self.k_8 / w_4))
                + lean_ddot * w_126) - l_lambda_ground_lean * w_127;
        let w_132 = w_117 + minus_l_lambda_ground_f1_psi * w_124
            + minus_l_lambda_ground_f1_lean * w_127 - l_lambda_ground_f1_phi * w_129
            + minus_l_lambda_ground_f1_lambda_ground * w_131;
        let w_133 = sin_psi * w_102 + cos_psi * (psi_dot * (w_106 - w_104) + w_108)
            - w_10 * (cos_psi * w_109 + sin_psi * w_110) + w_58 * w_107 + w_64 * w_113
            - phi_ddot * w_128;
        let w_134 = inverse_lambda_ground_f2
            * (w_133 + minus_l_lambda_ground_f2_psi * w_124
                - l_lambda_ground_f2_lean * w_127 - l_lambda_ground_f2_phi * w_129
                - l_lambda_ground_f2_lambda_ground * w_131
                - l_lambda_ground_f2_lambda_ground_f1 * w_132);
        let w_135 = inverse_lambda_ground_f1 * w_132
            - l_lambda_ground_f2_lambda_ground_f1 * w_134;
        let w_136 = minus_inverse_lambda_ground * w_81
            + minus_l_lambda_ground_f1_lambda_ground * w_85
            - l_lambda_ground_f2_lambda_ground * w_84;
        let w_137 = minus_l_lambda_ground_f1_lambda_ground * w_135
            - minus_inverse_lambda_ground * w_131
            - l_lambda_ground_f2_lambda_ground * w_134;
        let w_138 = inverse_phi * w_80 - l_lambda_ground_f1_phi * w_85
            - l_lambda_ground_f2_phi * w_84;
        let w_139 = inverse_phi * w_129 - l_lambda_ground_f1_phi * w_135
            - l_lambda_ground_f2_phi * w_134;
        let w_140 = phi_dot * w_97 + cos_phi * w_28;
        let w_141 = phi_dot * w_95 - sin_phi * w_28;
        let w_142 = cos_phi * w_140 - sin_phi * w_141;
        let w_143 = cos_lean * (w_28 - w_142);
        let w_144 = w_19 + psi_dot;
        let w_145 = self.r
            * ((sin_lean * cos_lean * (cos_psi * w_143 - sin_psi * w_144)
                + cos_psi * lean_dot) / sqrt_cos_lean_squared + cos_psi * w_34 / w_35);
        let w_146 = w_42 - (w_32 - sin_lean * w_142);
        let w_147 = w_47 + (cos_phi * w_141 + sin_phi * w_140 - cos_lean * phi_dot);
        let w_148 = self.k * (w_11 * w_95 + sin_lean * w_14 + w_141);
        let w_149 = self.k * (sin_lean * w_16 - w_11 * w_97 - w_140);
        let w_150 = cos_lean
            * (S::from_f64(0.25) * (sin_phi * w_148 + cos_phi * w_149) + self.C_ * w_28);
        let w_151 = S::from_f64(0.25) * (cos_phi * w_148 - sin_phi * w_149);
        let w_152 = l_phi_psi * w_150 - cos_lean * w_3;
        let w_153 = l_lambda_ground_lean * w_151;
        let w_154 = w_145 - w_38 / sqrt_cos_lean_squared
            + w_10 * (cos_psi * w_146 - sin_psi * w_147)
            - minus_l_lambda_ground_f1_psi * w_150
            + minus_l_lambda_ground_f1_lean * w_151 - l_lambda_ground_f1_phi * w_152
            - minus_l_lambda_ground_f1_lambda_ground * w_153;
        let w_155 = self.r
            * ((sin_lean * cos_lean * (cos_psi * w_144 + sin_psi * w_143) + w_62)
                / sqrt_cos_lean_squared + w_63);
        let w_156 = w_155 - sin_psi * w_37 / sqrt_cos_lean_squared
            + w_10 * (sin_psi * w_146 + cos_psi * w_147)
            - minus_l_lambda_ground_f2_psi * w_150 - l_lambda_ground_f2_lean * w_151
            - l_lambda_ground_f2_phi * w_152 + l_lambda_ground_f2_lambda_ground * w_153
            - l_lambda_ground_f2_lambda_ground_f1 * w_154;
        let w_157 = inverse_lambda_ground_f2 * w_156;
        let w_158 = inverse_lambda_ground_f1 * w_154
            - l_lambda_ground_f2_lambda_ground_f1 * w_157;
        let w_159 = cos_phi * (phi_dot - w);
        let w_160 = sin_phi * w_23;
        let w_161 = phi_dot - cos_phi * w_159 + sin_phi * w_160;
        let w_162 = self.r
            * ((w_8 * (cos_lean * (w_11 + w - w_161) - w_46) + w_19)
                / sqrt_cos_lean_squared + w_105) - w_104;
        let w_163 = sin_lean * (w_11 - w_161) + w_18 - w_43;
        let w_164 = cos_phi * w_160 + sin_phi * w_159;
        let w_165 = cos_psi * w_162
            + w_10 * (cos_psi * (psi_dot - w_163) + sin_psi * w_164) + sin_psi * w_53
            - w_50 * w_107;
        let w_166 = self.k * (sin_phi * w_11 - w_160);
        let w_167 = self.k * (cos_phi * w_11 + w_159);
        let w_168 = cos_lean
            * (S::from_f64(0.25) * (sin_phi * w_166 + cos_phi * w_167) + self.C_ * w);
        let w_169 = S::from_f64(0.25) * (cos_phi * w_166 - sin_phi * w_167);
        let w_170 = l_phi_psi * w_168 - self.C_ * w_2;
        let w_171 = sqrt_cos_lean_squared * lean_dot
            * (sin_lean_squared * (w_125 * self.k_5 + w_86 / cos_lean_squared_squared)
                - self.k_2 / cos_lean_squared) - l_lambda_ground_lean * w_169;
        let w_172 = w_165 - minus_l_lambda_ground_f1_psi * w_168
            + minus_l_lambda_ground_f1_lean * w_169 - l_lambda_ground_f1_phi * w_170
            + minus_l_lambda_ground_f1_lambda_ground * w_171;
        let w_173 = sin_psi * w_162
            - w_10 * (sin_psi * (w_163 - psi_dot) + cos_psi * w_164) - cos_psi * w_53
            + w_64 * w_107;
        let w_174 = inverse_lambda_ground_f2
            * (w_173 - minus_l_lambda_ground_f2_psi * w_168
                - l_lambda_ground_f2_lean * w_169 - l_lambda_ground_f2_phi * w_170
                - l_lambda_ground_f2_lambda_ground * w_171
                - l_lambda_ground_f2_lambda_ground_f1 * w_172);
        let w_175 = inverse_lambda_ground_f1 * w_172
            - l_lambda_ground_f2_lambda_ground_f1 * w_174;
        let w_176 = lean_dot * (w_51 * (w_91 - w_114) + w_52) + cos_lean * w_53;
        let w_177 = sin_psi * w_2;
        let w_178 = self.C_ * cos_lean * (w_41 + w_40);
        let w_179 = self.C_ * w_17;
        let w_180 = l_phi_psi * w_178;
        let w_181 = l_lambda_ground_lean * w_179;
        let w_182 = cos_psi * w_176 - w_69 * w_177 / sqrt_cos_lean_squared
            - w_10 * (cos_psi * w_28 + w_177) - minus_l_lambda_ground_f1_psi * w_178
            + minus_l_lambda_ground_f1_lean * w_179 - l_lambda_ground_f1_phi * w_180
            - minus_l_lambda_ground_f1_lambda_ground * w_181;
        let w_183 = cos_psi * w_2;
        let w_184 = sin_psi * w_176 + w_69 * w_183 / sqrt_cos_lean_squared
            + w_10 * (w_183 - sin_psi * w_28) - minus_l_lambda_ground_f2_psi * w_178
            - l_lambda_ground_f2_lean * w_179 - l_lambda_ground_f2_phi * w_180
            + l_lambda_ground_f2_lambda_ground * w_181
            - l_lambda_ground_f2_lambda_ground_f1 * w_182;
        let w_185 = inverse_lambda_ground_f2 * w_184;
        let w_186 = inverse_lambda_ground_f1 * w_182
            - l_lambda_ground_f2_lambda_ground_f1 * w_185;
        let w_187 = minus_inverse_lambda_ground * w_153
            + minus_l_lambda_ground_f1_lambda_ground * w_158
            - l_lambda_ground_f2_lambda_ground * w_157;
        let w_188 = minus_l_lambda_ground_f1_lambda_ground * w_175
            - minus_inverse_lambda_ground * w_171
            - l_lambda_ground_f2_lambda_ground * w_174;
        let w_189 = minus_inverse_lambda_ground * w_181
            + minus_l_lambda_ground_f1_lambda_ground * w_186
            - l_lambda_ground_f2_lambda_ground * w_185;
        let w_190 = inverse_phi * w_152 - l_lambda_ground_f1_phi * w_158
            - l_lambda_ground_f2_phi * w_157;
        let w_191 = inverse_phi * w_170 - l_lambda_ground_f1_phi * w_175
            - l_lambda_ground_f2_phi * w_174;
        let w_192 = inverse_phi * w_180 - l_lambda_ground_f1_phi * w_186
            - l_lambda_ground_f2_phi * w_185;
        sim_kernel::DynamicsJacobian {
            accelerations_by_positions: [
                [
                    S::from_f64(0.0),
                    S::from_f64(0.0),
                    S::from_f64(0.0),
                    -(self.inverse_z * w_85),
                    -(self.inverse_z * w_135),
                    S::from_f64(0.0),
                ],
                [
                    S::from_f64(0.0),
                    S::from_f64(0.0),
                    S::from_f64(0.0),
                    -(self.inverse_z * w_84),
                    -(self.inverse_z * w_134),
                    S::from_f64(0.0),
                ],
                [
                    S::from_f64(0.0),
                    S::from_f64(0.0),
                    S::from_f64(0.0),
                    -(self.inverse_z * w_136),
                    -(self.inverse_z * w_137),
                    S::from_f64(0.0),
                ],
                [
                    S::from_f64(0.0),
                    S::from_f64(0.0),
                    S::from_f64(0.0),
                    minus_l_lambda_ground_f1_psi * w_85 - inverse_psi * w_74
                        - l_phi_psi * w_138 + minus_l_lambda_ground_f2_psi * w_84,
                    inverse_psi * w_124 - l_phi_psi * w_139
                        + minus_l_lambda_ground_f1_psi * w_135
                        + minus_l_lambda_ground_f2_psi * w_134,
                    S::from_f64(0.0),
                ],
                [
                    S::from_f64(0.0),
                    S::from_f64(0.0),
                    S::from_f64(0.0),
                    self.inverse_lean * w_78 - l_lambda_ground_lean * w_136
                        + minus_l_lambda_ground_f1_lean * w_85
                        - l_lambda_ground_f2_lean * w_84,
                    self.inverse_lean * w_127 - l_lambda_ground_lean * w_137
                        + minus_l_lambda_ground_f1_lean * w_135
                        - l_lambda_ground_f2_lean * w_134,
                    S::from_f64(0.0),
                ],
                [
                    S::from_f64(0.0),
                    S::from_f64(0.0),
                    S::from_f64(0.0),
                    w_138,
                    w_139,
                    S::from_f64(0.0),
                ],
            ],
            accelerations_by_speeds: [
                [
                    S::from_f64(0.0),
                    S::from_f64(0.0),
                    S::from_f64(0.0),
                    -(self.inverse_z * w_158),
                    -(self.inverse_z * w_175),
                    -(self.inverse_z * w_186),
                ],
                [
                    S::from_f64(0.0),
                    S::from_f64(0.0),
                    S::from_f64(0.0),
                    -(self.inverse_z * w_157),
                    -(self.inverse_z * w_174),
                    -(self.inverse_z * w_185),
                ],
                [
                    S::from_f64(0.0),
                    S::from_f64(0.0),
                    S::from_f64(0.0),
                    -(self.inverse_z * w_187),
                    -(self.inverse_z * w_188),
                    -(self.inverse_z * w_189),
                ],
                [
                    S::from_f64(0.0),
                    S::from_f64(0.0),
                    S::from_f64(0.0),
                    minus_l_lambda_ground_f1_psi * w_158 - inverse_psi * w_150
                        - l_phi_psi * w_190 + minus_l_lambda_ground_f2_psi * w_157,
                    minus_l_lambda_ground_f1_psi * w_175 - inverse_psi * w_168
                        - l_phi_psi * w_191 + minus_l_lambda_ground_f2_psi * w_174,
                    minus_l_lambda_ground_f1_psi * w_186 - inverse_psi * w_178
                        - l_phi_psi * w_192 + minus_l_lambda_ground_f2_psi * w_185,
                ],
                [
                    S::from_f64(0.0),
                    S::from_f64(0.0),
                    S::from_f64(0.0),
                    self.inverse_lean * w_151 - l_lambda_ground_lean * w_187
                        + minus_l_lambda_ground_f1_lean * w_158
                        - l_lambda_ground_f2_lean * w_157,
                    self.inverse_lean * w_169 - l_lambda_ground_lean * w_188
                        + minus_l_lambda_ground_f1_lean * w_175
                        - l_lambda_ground_f2_lean * w_174,
                    self.inverse_lean * w_179 - l_lambda_ground_lean * w_189
                        + minus_l_lambda_ground_f1_lean * w_186
                        - l_lambda_ground_f2_lean * w_185,
                ],
                [
                    S::from_f64(0.0),
                    S::from_f64(0.0),
                    S::from_f64(0.0),
                    w_190,
                    w_191,
                    w_192,
                ],
            ],
            multipliers_by_positions: [
                [
                    S::from_f64(0.0),
                    S::from_f64(0.0),
                    S::from_f64(0.0),
                    w_136,
                    w_137,
                    S::from_f64(0.0),
                ],
                [
                    S::from_f64(0.0),
                    S::from_f64(0.0),
                    S::from_f64(0.0),
                    w_85,
                    w_135,
                    S::from_f64(0.0),
                ],
                [
                    S::from_f64(0.0),
                    S::from_f64(0.0),
                    S::from_f64(0.0),
                    w_84,
                    w_134,
                    S::from_f64(0.0),
                ],
            ],
            multipliers_by_speeds: [
                [
                    S::from_f64(0.0),
                    S::from_f64(0.0),
                    S::from_f64(0.0),
                    w_187,
                    w_188,
                    w_189,
                ],
                [
                    S::from_f64(0.0),
                    S::from_f64(0.0),
                    S::from_f64(0.0),
                    w_158,
                    w_175,
                    w_186,
                ],
                [
                    S::from_f64(0.0),
                    S::from_f64(0.0),
                    S::from_f64(0.0),
                    w_157,
                    w_174,
                    w_185,
                ],
            ],
            refused: sim_kernel::pivot_is_refused(self.m, self.m)
                | sim_kernel::pivot_is_refused(mass_psi_psi, mass_psi_psi)
                | sim_kernel::pivot_is_refused(self.A_, self.A_)
                | sim_kernel::pivot_is_refused(self.m, self.m)
                | sim_kernel::pivot_is_refused(pivot_phi, self.C_)
                | sim_kernel::pivot_is_refused(
                    -minus_pivot_lambda_ground,
                    minus_pivot_lambda_ground,
                ) | sim_kernel::pivot_is_refused(self.m, self.m)
                | sim_kernel::pivot_is_refused(pivot_lambda_ground_f1, w_57)
                | sim_kernel::pivot_is_refused(pivot_lambda_ground_f2, w_59),
        }
    }
}
#[allow(non_snake_case, clippy::all, clippy::pedantic)]
impl<S: sim_kernel::Scalar> sim_kernel::Mechanism<S> for RollingDisc<S> {
    type Q = [S; 6];
    type L = [S; 3];
    type Z = [S; 9];
    type QQ = [[S; 6]; 6];
    type LQ = [[S; 6]; 3];
    type LL = [[S; 3]; 3];
    type ZZ = [[S; 9]; 9];
    type Parameters = [S; 6];
    type Outputs = [S; 3];
    type OutputRates = [S; 2];
    type Events = [S; 1];
    type EventValues = [S; 0];
    type Activities = [S; 0];
    type Drawing = [S; 28];
    type QP = [[S; 6]; 6];
    type LP = [[S; 6]; 3];
    type Inputs = [sim_kernel::Input<S>; 0];
    type Prepared = RollingDiscPrepared<S>;
    type On<T: sim_kernel::Scalar> = RollingDisc<T>;
    const DESCRIPTION: sim_kernel::Description = sim_kernel::Description {
        name: "rolling-disc",
        type_name: "RollingDisc",
        docs: "A disc rolls in a circle, leaning inwards and, unless `nod` is 0, nodding.",
        declaration: "/// A disc rolls in a circle, leaning inwards and, unless `nod` is 0, nodding.\npub RollingDisc;\n\ncoordinates {\n    /// Place of the centre.\n    x [m];\n    y [m];\n    z [m];\n    /// Direction of rolling.\n    psi [rad];\n    /// Lean from the upright.\n    lean [rad];\n    /// Turn about its own axis.\n    phi [rad];\n}\n\nparameters {\n    m [kg] = 0.5;\n    r [m] = 0.2;\n    g [m/s^2] = 9.81;\n    /// Lean at the start.\n    lean0 [deg] = -20;\n    /// Rate of turning at the start.\n    turning [rad/s] = 1.5;\n    /// Speed of leaning at the start.\n    nod [rad/s] = 0.2;\n}\n\nlet A = m*r^2/4;\nlet C = m*r^2/2;\nlet axial = (A*turning^2*sin(lean0)*cos(lean0) - m*g*r*sin(lean0))/((C + m*r^2)*turning*cos(lean0));\nlet R = rotation([0, 0, 1], psi)*rotation([1, 0, 0], lean)*rotation([0, 1, 0], phi);\nlet P = [x, y, z];\n\nbodies { disc: mass m at P, inertia [A, C, A], attitude R; }\nloads { gravity [0, 0, -g]; }\njoints { ground: roll disc radius r axis [0, 1, 0] on [0, 0, 0] normal [0, 0, 1]; }\n\ninitial {\n    x = 0;\n    y = 0;\n    guess z = r;\n    psi = 0;\n    lean = lean0;\n    phi = 0;\n    dot(psi) = turning;\n    dot(lean) = nod;\n    dot(phi) = axial - turning*sin(lean0);\n}\nevents { period: sin(psi/2) = 0; }\n\noutputs {\n    /// lean\n    leaning [deg] = lean;\n    /// speed of the centre\n    speed [m/s] = norm(dot(P));\n    /// force on the ground\n    normal_force [N] = -reaction(ground);\n}\n\ndrawing {\n    curve [-1.5 [m], -0.5 [m], 0], [1.5 [m], -0.5 [m], 0], [1.5 [m], 2.5 [m], 0], [-1.5 [m], 2.5 [m], 0], [-1.5 [m], -0.5 [m], 0];\n    circle P radius r normal R*[0, 1, 0];\n    line P, on(disc, [r, 0, 0]);\n}\n",
        coordinates: &[
            sim_kernel::Coordinate {
                position: sim_kernel::Quantity {
                    name: "x",
                    unit: "m",
                    factor: 1f64,
                    docs: "Place of the centre.",
                },
                speed: sim_kernel::Quantity {
                    name: "x_dot",
                    unit: "m/s",
                    factor: 1f64,
                    docs: "",
                },
                acceleration: sim_kernel::Quantity {
                    name: "x_ddot",
                    unit: "m/s^2",
                    factor: 1f64,
                    docs: "",
                },
                start: sim_kernel::Start::Given,
                speed_given: false,
            },
            sim_kernel::Coordinate {
                position: sim_kernel::Quantity {
                    name: "y",
                    unit: "m",
                    factor: 1f64,
                    docs: "",
                },
                speed: sim_kernel::Quantity {
                    name: "y_dot",
                    unit: "m/s",
                    factor: 1f64,
                    docs: "",
                },
                acceleration: sim_kernel::Quantity {
                    name: "y_ddot",
                    unit: "m/s^2",
                    factor: 1f64,
                    docs: "",
                },
                start: sim_kernel::Start::Given,
                speed_given: false,
            },
            sim_kernel::Coordinate {
                position: sim_kernel::Quantity {
                    name: "z",
                    unit: "m",
                    factor: 1f64,
                    docs: "",
                },
                speed: sim_kernel::Quantity {
                    name: "z_dot",
                    unit: "m/s",
                    factor: 1f64,
                    docs: "",
                },
                acceleration: sim_kernel::Quantity {
                    name: "z_ddot",
                    unit: "m/s^2",
                    factor: 1f64,
                    docs: "",
                },
                start: sim_kernel::Start::Guess,
                speed_given: false,
            },
            sim_kernel::Coordinate {
                position: sim_kernel::Quantity {
                    name: "psi",
                    unit: "rad",
                    factor: 1f64,
                    docs: "Direction of rolling.",
                },
                speed: sim_kernel::Quantity {
                    name: "psi_dot",
                    unit: "rad/s",
                    factor: 1f64,
                    docs: "",
                },
                acceleration: sim_kernel::Quantity {
                    name: "psi_ddot",
                    unit: "rad/s^2",
                    factor: 1f64,
                    docs: "",
                },
                start: sim_kernel::Start::Given,
                speed_given: true,
            },
            sim_kernel::Coordinate {
                position: sim_kernel::Quantity {
                    name: "lean",
                    unit: "rad",
                    factor: 1f64,
                    docs: "Lean from the upright.",
                },
                speed: sim_kernel::Quantity {
                    name: "lean_dot",
                    unit: "rad/s",
                    factor: 1f64,
                    docs: "",
                },
                acceleration: sim_kernel::Quantity {
                    name: "lean_ddot",
                    unit: "rad/s^2",
                    factor: 1f64,
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
                    docs: "Turn about its own axis.",
                },
                speed: sim_kernel::Quantity {
                    name: "phi_dot",
                    unit: "rad/s",
                    factor: 1f64,
                    docs: "",
                },
                acceleration: sim_kernel::Quantity {
                    name: "phi_ddot",
                    unit: "rad/s^2",
                    factor: 1f64,
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
                docs: "",
            },
            sim_kernel::Quantity {
                name: "r",
                unit: "m",
                factor: 1f64,
                docs: "",
            },
            sim_kernel::Quantity {
                name: "g",
                unit: "m/s^2",
                factor: 1f64,
                docs: "",
            },
            sim_kernel::Quantity {
                name: "lean0",
                unit: "deg",
                factor: 0.017453292519943295f64,
                docs: "Lean at the start.",
            },
            sim_kernel::Quantity {
                name: "turning",
                unit: "rad/s",
                factor: 1f64,
                docs: "Rate of turning at the start.",
            },
            sim_kernel::Quantity {
                name: "nod",
                unit: "rad/s",
                factor: 1f64,
                docs: "Speed of leaning at the start.",
            },
        ],
        inputs: &[],
        constraints: &[
            sim_kernel::Quantity {
                name: "ground",
                unit: "N",
                factor: 1f64,
                docs: "",
            },
            sim_kernel::Quantity {
                name: "ground_f1",
                unit: "N",
                factor: 1f64,
                docs: "",
            },
            sim_kernel::Quantity {
                name: "ground_f2",
                unit: "N",
                factor: 1f64,
                docs: "",
            },
        ],
        speed_constraints: &[1, 2],
        norm_constraints: &[],
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
                name: "leaning",
                unit: "deg",
                factor: 0.017453292519943295f64,
                docs: "lean",
            },
            sim_kernel::Quantity {
                name: "speed",
                unit: "m/s",
                factor: 1f64,
                docs: "speed of the centre",
            },
            sim_kernel::Quantity {
                name: "normal_force",
                unit: "N",
                factor: 1f64,
                docs: "force on the ground",
            },
        ],
        rated_outputs: &[0, 1],
        figures: &[
            sim_kernel::Figure {
                name: "leaning",
                title: "lean",
                len: 1,
            },
            sim_kernel::Figure {
                name: "speed",
                title: "speed of the centre",
                len: 1,
            },
            sim_kernel::Figure {
                name: "normal_force",
                title: "force on the ground",
                len: 1,
            },
        ],
        dimension: 3,
        drawing: &[
            sim_kernel::Shape::Curve(5),
            sim_kernel::Shape::Circle,
            sim_kernel::Shape::Line(2),
        ],
    };
    fn defaults() -> Self {
        Self {
            m: S::from_f64(0.5f64),
            r: S::from_f64(0.2f64),
            g: S::from_f64(9.81f64),
            lean0: S::from_f64(-0.3490658503988659f64),
            turning: S::from_f64(1.5f64),
            nod: S::from_f64(0.2f64),
        }
    }
    fn parameters(&self) -> [S; 6] {
        [self.m, self.r, self.g, self.lean0, self.turning, self.nod]
    }
    fn with_parameters(&self, parameters: [S; 6]) -> Self {
        Self {
            m: parameters[0],
            r: parameters[1],
            g: parameters[2],
            lean0: parameters[3],
            turning: parameters[4],
            nod: parameters[5],
            ..*self
        }
    }
    fn on<T: sim_kernel::Scalar>(
        &self,
        convert: impl ::core::ops::Fn(S) -> T,
    ) -> RollingDisc<T> {
        RollingDisc {
            m: convert(self.m),
            r: convert(self.r),
            g: convert(self.g),
            lean0: convert(self.lean0),
            turning: convert(self.turning),
            nod: convert(self.nod),
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
    fn prepare(&self) -> RollingDiscPrepared<S> {
        self.prepare()
    }
    #[inline(always)]
    fn prepared_dynamics(
        prepared: &Self::Prepared,
        t: S,
        q: &[S; 6],
        qd: &[S; 6],
    ) -> sim_kernel::Dynamics<S, [S; 6], [S; 3]> {
        prepared.dynamics(t, q, qd)
    }
    #[inline(always)]
    fn dynamics_jacobian(
        &self,
        t: S,
        q: &[S; 6],
        qd: &[S; 6],
    ) -> sim_kernel::DynamicsJacobian<S, [[S; 6]; 6], [[S; 6]; 3]> {
        self.prepare().dynamics_jacobian(t, q, qd)
    }
    #[inline(always)]
    fn mass_matrix(&self, t: S, q: &[S; 6]) -> [[S; 6]; 6] {
        self.mass_matrix(t, q)
    }
    #[inline(always)]
    fn convective_forces(&self, t: S, q: &[S; 6], qd: &[S; 6]) -> [S; 6] {
        self.convective_forces(t, q, qd)
    }
    #[inline(always)]
    fn generalized_forces(&self, t: S, q: &[S; 6], qd: &[S; 6]) -> [S; 6] {
        self.generalized_forces(t, q, qd)
    }
    #[inline(always)]
    fn constraints(&self, t: S, q: &[S; 6]) -> [S; 3] {
        self.constraints(t, q)
    }
    #[inline(always)]
    fn constraint_magnitudes(&self, t: S, q: &[S; 6]) -> [S; 3] {
        self.constraint_magnitudes(t, q)
    }
    #[inline(always)]
    fn constraint_jacobian(&self, t: S, q: &[S; 6]) -> [[S; 6]; 3] {
        self.constraint_jacobian(t, q)
    }
    #[inline(always)]
    fn constraint_time_derivative(&self, t: S, q: &[S; 6]) -> [S; 3] {
        self.constraint_time_derivative(t, q)
    }
    #[inline(always)]
    fn constraint_convective(&self, t: S, q: &[S; 6], qd: &[S; 6]) -> [S; 3] {
        self.constraint_convective(t, q, qd)
    }
    #[inline(always)]
    fn constraint_linearization(
        &self,
        t: S,
        q: &[S; 6],
    ) -> sim_kernel::ConstraintLinearization<[S; 3], [[S; 6]; 3]> {
        self.constraint_linearization(t, q)
    }
    #[inline(always)]
    fn kinetic_energy(&self, t: S, q: &[S; 6], qd: &[S; 6]) -> S {
        self.kinetic_energy(t, q, qd)
    }
    #[inline(always)]
    fn power(&self, t: S, q: &[S; 6], qd: &[S; 6], qdd: &[S; 6], lambda: &[S; 3]) -> S {
        self.power(t, q, qd, qdd, lambda)
    }
    #[inline(always)]
    fn outputs(
        &self,
        t: S,
        q: &[S; 6],
        qd: &[S; 6],
        qdd: &[S; 6],
        lambda: &[S; 3],
    ) -> [S; 3] {
        self.outputs(t, q, qd, qdd, lambda).into()
    }
    #[inline(always)]
    fn output_rates(&self, t: S, q: &[S; 6], qd: &[S; 6], qdd: &[S; 6]) -> [S; 2] {
        self.output_rates(t, q, qd, qdd).into()
    }
    #[inline(always)]
    fn events(
        &self,
        t: S,
        q: &[S; 6],
        qd: &[S; 6],
        qdd: &[S; 6],
        lambda: &[S; 3],
    ) -> [S; 1] {
        self.events(t, q, qd, qdd, lambda)
    }
    #[inline(always)]
    fn drawing(&self, t: S, q: &[S; 6]) -> [S; 28] {
        self.drawing(t, q)
    }
    #[inline(always)]
    fn initial(&self) -> sim_kernel::Initial<[S; 6]> {
        self.initial()
    }
}
