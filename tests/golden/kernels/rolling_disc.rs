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
    pivot_lambda_ground: S,
    minus_inverse_lambda_ground: S,
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
    /// Operations: 1 addition, 15 multiplications, 2 divisions.
    #[inline]
    pub fn prepare(&self) -> RollingDiscPrepared<S> {
        let r_squared = self.r * self.r;
        let w = self.m * self.g;
        let inverse_m = S::from_f64(1.0) / self.m;
        RollingDiscPrepared {
            m: self.m,
            r: self.r,
            A_: self.m * S::from_f64(0.25) * r_squared,
            C_: self.m * r_squared * S::from_f64(0.5),
            minus_rhs_z: w,
            k: self.m * r_squared,
            k_2: self.r * S::from_f64(2.0),
            inverse_z: inverse_m,
            pivot_lambda_ground: -inverse_m,
            minus_inverse_lambda_ground: S::from_f64(1.0) / inverse_m,
            k_3: w * inverse_m,
            k_4: self.r * S::from_f64(4.0),
            k_5: self.r * S::from_f64(10.0),
            k_6: self.r * S::from_f64(12.0),
            k_7: self.r * S::from_f64(6.0),
            k_8: self.r * S::from_f64(3.0),
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
                A_ * (sin_lean * sin_lean + S::from_f64(1.0)),
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
    /// Operations: 3 additions, 17 multiplications, 1 sine-cosine pair.
    #[inline]
    pub fn convective_forces(&self, t: S, q: &[S; 6], qd: &[S; 6]) -> [S; 6] {
        let [_, _, _, _, lean, _] = *q;
        let [_, _, _, psi_dot, lean_dot, phi_dot] = *qd;
        let ([sin_lean], [cos_lean]) = S::sin_cos_each([lean]);
        let r_squared = self.r * self.r;
        let w = self.m * r_squared * S::from_f64(0.5);
        let w_2 = lean_dot * w;
        [
            S::from_f64(0.0),
            S::from_f64(0.0),
            S::from_f64(0.0),
            cos_lean * (phi_dot + psi_dot * sin_lean) * w_2,
            -(cos_lean
                * (psi_dot * phi_dot * w
                    + sin_lean * psi_dot * psi_dot * S::from_f64(0.25) * self.m
                        * r_squared)),
            cos_lean * psi_dot * w_2,
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
    /// Operations: 41 additions, 85 multiplications, 16 divisions, 3 sine-cosine pairs, 1 square root.
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
        let w_4 = lean_dot * sin_phi;
        let w_5 = cos_lean * psi_dot;
        let w_6 = w_4 + cos_phi * w_5;
        let w_15 = w_2 * w_4 - phi_dot * w_6;
        let w_7 = lean_dot * cos_phi;
        let w_8 = w_7 - sin_phi * w_5;
        let w_14 = w_2 * w_7 - phi_dot * w_8;
        let w_9 = cos_phi * w_6 - sin_phi * w_8;
        let w_13 = sin_phi * w_6 + cos_phi * w_8;
        let w_10 = sin_lean * w_3 + cos_lean * w_9;
        let w_11 = cos_lean * w_2;
        let w_12 = sin_lean * w_9;
        let w_16 = phi_dot * w_13 + cos_phi * w_14 + sin_phi * w_15;
        let w_17 = sin_lean * cos_lean
            * (lean_dot * (cos_lean * (w_2 + w_3) - w_12) - cos_lean * w_16)
            + lean_dot * w_10;
        let w_25 = lean_dot * (cos_lean_squared * psi_dot - w_10) + sin_lean * w_16
            + psi_dot * w_13;
        let w_26 = cos_lean * w_3 - w_12;
        let w_27 = cos_phi * w_15 + phi_dot * w_9 - sin_phi * w_14 - psi_dot * w_26;
        let w_18 = lean_dot * sin_lean_squared;
        let w_19 = w_10 * w_18;
        let w_20 = cos_lean_squared * sqrt_cos_lean_squared;
        let sqrt_cos_lean_squared_squared = sqrt_cos_lean_squared
            * sqrt_cos_lean_squared;
        let w_21 = cos_lean_squared * sqrt_cos_lean_squared_squared;
        let w_28 = lean_dot * cos_lean
            * (self.r * sqrt_cos_lean_squared
                * ((sin_lean - sin_lean * sin_lean_squared)
                    / sqrt_cos_lean_squared_squared / cos_lean_squared)
                - sin_lean * w / sqrt_cos_lean_squared);
        let w_29 = self.r
            * (w_10
                * (cos_psi * w_11 / sqrt_cos_lean_squared + sin_psi * w_18 * w_20 / w_21)
                + sin_psi * w_17 / sqrt_cos_lean_squared);
        let w_22 = self.r
            * (sin_psi * w_10 * w_11 / sqrt_cos_lean_squared
                - cos_psi * (w_17 / sqrt_cos_lean_squared + w_19 * w_20 / w_21));
        let w_23 = w * w_19;
        let w_24 = self.r
            * ((S::from_f64(1.0) - sin_lean_squared) / sqrt_cos_lean_squared);
        [
            lean_dot * lean_dot * sqrt_cos_lean_squared
                * (sin_lean_squared
                    * (w
                        * (cos_lean / (cos_lean * cos_lean_squared)
                            - S::from_f64(1.0) / cos_lean_squared)
                        - self.r * cos_lean_squared
                            / (cos_lean_squared * cos_lean_squared))
                    + self.r / cos_lean_squared),
            w_22 + cos_psi * w_23 / sqrt_cos_lean_squared
                - w_24 * (cos_psi * w_25 + sin_psi * w_27)
                - (w_13 * sin_psi + cos_psi * w_26) * w_28,
            sin_psi * w_23 / sqrt_cos_lean_squared - w_29
                + w_24 * (cos_psi * w_27 - sin_psi * w_25)
                + w_28 * (cos_psi * w_13 - sin_psi * w_26),
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
    /// by an elimination planned from the structure of the system, with two constraint rows turned along and across a link. Where `refused` is set a pivot was too small and nothing else holds: solve that state from the other kernels.
    ///
    /// Operations: 77 additions, 149 multiplications, 24 divisions, 3 sine-cosine pairs, 1 square root.
    #[inline(always)]
    pub fn dynamics(
        &self,
        t: S,
        q: &[S; 6],
        qd: &[S; 6],
    ) -> sim_kernel::Dynamics<S, [S; 6], [S; 3]> {
        let [_, _, _, psi, lean, phi] = *q;
        let [_, _, z_dot, psi_dot, lean_dot, phi_dot] = *qd;
        let (
            [sin_lean,
            minus_k_lambda_ground_f2_turned_x,
            sin_phi,
            ],
            [cos_lean,
            k_lambda_ground_f1_turned_x,
            cos_phi,
            ],
        ) = S::sin_cos_each([lean, psi, phi]);
        let cos_lean_squared = cos_lean * cos_lean;
        let sqrt_cos_lean_squared = cos_lean_squared.sqrt();
        let sin_lean_squared = sin_lean * sin_lean;
        let w = sqrt_cos_lean_squared * lean_dot * lean_dot
            * (sin_lean_squared
                * (self.k_2
                    * (cos_lean / (cos_lean * cos_lean_squared)
                        - S::from_f64(1.0) / cos_lean_squared)
                    - self.r * cos_lean_squared / (cos_lean_squared * cos_lean_squared))
                + self.r / cos_lean_squared);
        let rhs_lambda_ground = self.k_3 - w;
        let w_2 = sin_lean * cos_lean;
        let w_3 = self.r * w_2;
        let ground_by_lean = sqrt_cos_lean_squared * w_3 / cos_lean_squared;
        let minus_k_lambda_ground_f1_turned_psi = w_3 / sqrt_cos_lean_squared;
        let minus_l_lean_lambda_ground = ground_by_lean
            * self.minus_inverse_lambda_ground;
        let pivot_lean = self.A_ + ground_by_lean * minus_l_lean_lambda_ground;
        let rhs_lean = cos_lean
            * (self.C_ * psi_dot * phi_dot + sin_lean * self.A_ * psi_dot * psi_dot)
            + minus_l_lean_lambda_ground * rhs_lambda_ground;
        let w_4 = self.C_ * lean_dot;
        let w_5 = sin_lean * psi_dot;
        let w_6 = phi_dot + w_5;
        let w_7 = cos_lean * w_6;
        let minus_rhs_psi = w_4 * w_7;
        let mass_phi_psi = sin_lean * self.C_;
        let mass_psi_psi = self.A_ * (sin_lean_squared + S::from_f64(1.0));
        let inverse_psi = S::from_f64(1.0) / mass_psi_psi;
        let l_phi_psi = mass_phi_psi * inverse_psi;
        let w_8 = cos_lean * psi_dot;
        let rhs_phi = minus_rhs_psi * l_phi_psi - w_8 * w_4;
        let w_9 = sin_phi * lean_dot + cos_phi * w_8;
        let w_14 = lean_dot * cos_phi - sin_phi * w_8;
        let w_10 = w_9 * phi_dot;
        let w_11 = sin_lean * lean_dot;
        let w_12 = psi_dot * w_11;
        let w_13 = w_10 + (sin_phi * w_12 - w_10);
        let w_15 = phi_dot * w_14;
        let w_16 = w_15 + (cos_phi * w_12 - w_15);
        let w_17 = sin_phi * w_13 + cos_phi * w_16;
        let w_18 = cos_phi * w_9 - sin_phi * w_14;
        let w_28 = cos_phi * w_14 + sin_phi * w_9;
        let w_30 = w_7 - sin_lean * w_18;
        let w_31 = cos_phi * w_13 - sin_phi * w_16 - psi_dot * w_30;
        let w_19 = sin_lean * w_6 + cos_lean * w_18;
        let w_20 = w_2 * (cos_lean * (lean_dot * (w_5 + w_6) - w_17) - w_11 * w_18)
            + lean_dot * w_19;
        let w_25 = w_2 * psi_dot;
        let w_29 = lean_dot * (cos_lean_squared * psi_dot - w_19) + sin_lean * w_17
            + psi_dot * w_28;
        let w_21 = sin_lean_squared * lean_dot;
        let w_22 = w_19 * w_21;
        let w_23 = cos_lean_squared * sqrt_cos_lean_squared;
        let sqrt_cos_lean_squared_squared = sqrt_cos_lean_squared
            * sqrt_cos_lean_squared;
        let w_24 = cos_lean_squared * sqrt_cos_lean_squared_squared;
        let w_32 = cos_lean * lean_dot
            * (self.r * sqrt_cos_lean_squared
                * ((sin_lean - sin_lean * sin_lean_squared)
                    / sqrt_cos_lean_squared_squared / cos_lean_squared)
                - sin_lean * self.k_2 / sqrt_cos_lean_squared);
        let k_lambda_ground_f2_turned_lean = self.r
            * ((S::from_f64(1.0) - sin_lean_squared) / sqrt_cos_lean_squared);
        let w_34 = self.r
            * (w_19
                * (k_lambda_ground_f1_turned_x * w_25 / sqrt_cos_lean_squared
                    + minus_k_lambda_ground_f2_turned_x * w_21 * w_23 / w_24)
                + minus_k_lambda_ground_f2_turned_x * w_20 / sqrt_cos_lean_squared);
        let w_26 = self.r
            * (k_lambda_ground_f1_turned_x
                * (w_20 / sqrt_cos_lean_squared + w_22 * w_23 / w_24)
                - minus_k_lambda_ground_f2_turned_x * w_19 * w_25
                    / sqrt_cos_lean_squared);
        let w_27 = self.k_2 * w_22;
        let w_33 = w_26 - k_lambda_ground_f1_turned_x * w_27 / sqrt_cos_lean_squared
            + k_lambda_ground_f2_turned_lean
                * (k_lambda_ground_f1_turned_x * w_29
                    + minus_k_lambda_ground_f2_turned_x * w_31)
            + (minus_k_lambda_ground_f2_turned_x * w_28
                + k_lambda_ground_f1_turned_x * w_30) * w_32;
        let w_35 = w_34
            - minus_k_lambda_ground_f2_turned_x * w_27 / sqrt_cos_lean_squared
            - k_lambda_ground_f2_turned_lean
                * (k_lambda_ground_f1_turned_x * w_31
                    - minus_k_lambda_ground_f2_turned_x * w_29)
            - w_32
                * (k_lambda_ground_f1_turned_x * w_28
                    - minus_k_lambda_ground_f2_turned_x * w_30);
        let minus_l_lambda_ground_f1_turned_psi = minus_k_lambda_ground_f1_turned_psi
            * inverse_psi;
        let k_lambda_ground_f1_turned_phi = mass_phi_psi
            * minus_l_lambda_ground_f1_turned_psi
            - self.r * cos_lean / sqrt_cos_lean_squared;
        let pivot_phi = self.C_ - mass_phi_psi * l_phi_psi;
        let inverse_lean = S::from_f64(1.0) / pivot_lean;
        let l_lambda_ground_f2_turned_lean = k_lambda_ground_f2_turned_lean
            * inverse_lean;
        let minus_l_lambda_ground_f2_turned_x = minus_k_lambda_ground_f2_turned_x
            * self.inverse_z;
        let w_36 = minus_k_lambda_ground_f2_turned_x * minus_l_lambda_ground_f2_turned_x;
        let l_lambda_ground_f1_turned_x = k_lambda_ground_f1_turned_x * self.inverse_z;
        let w_37 = k_lambda_ground_f1_turned_x * l_lambda_ground_f1_turned_x;
        let minus_pivot_lambda_ground_f2_turned = k_lambda_ground_f2_turned_lean
            * l_lambda_ground_f2_turned_lean + w_36 + w_37;
        let minus_inverse_lambda_ground_f2_turned = S::from_f64(1.0)
            / minus_pivot_lambda_ground_f2_turned;
        let k_lambda_ground_f1_turned_lambda_ground_f2_turned = k_lambda_ground_f1_turned_x
            * minus_l_lambda_ground_f2_turned_x
            - minus_k_lambda_ground_f2_turned_x * l_lambda_ground_f1_turned_x;
        let minus_l_lambda_ground_f1_turned_lambda_ground_f2_turned = minus_inverse_lambda_ground_f2_turned
            * k_lambda_ground_f1_turned_lambda_ground_f2_turned;
        let minus_rhs_lambda_ground_f2_turned = minus_k_lambda_ground_f2_turned_x * w_33
            - k_lambda_ground_f1_turned_x * w_35
            + l_lambda_ground_f2_turned_lean * rhs_lean;
        let inverse_phi = S::from_f64(1.0) / pivot_phi;
        let l_lambda_ground_f1_turned_phi = inverse_phi * k_lambda_ground_f1_turned_phi;
        let w_38 = w_37 + w_36
            + minus_k_lambda_ground_f1_turned_psi * minus_l_lambda_ground_f1_turned_psi
            + k_lambda_ground_f1_turned_phi * l_lambda_ground_f1_turned_phi;
        let pivot_lambda_ground_f1_turned = k_lambda_ground_f1_turned_lambda_ground_f2_turned
            * minus_l_lambda_ground_f1_turned_lambda_ground_f2_turned - w_38;
        let w_39 = S::from_f64(1.0) / pivot_lambda_ground_f1_turned
            * (k_lambda_ground_f1_turned_x * w_33
                + minus_k_lambda_ground_f2_turned_x * w_35
                - minus_rhs_psi * minus_l_lambda_ground_f1_turned_psi
                - minus_l_lambda_ground_f1_turned_lambda_ground_f2_turned
                    * minus_rhs_lambda_ground_f2_turned
                - l_lambda_ground_f1_turned_phi * rhs_phi);
        let w_40 = minus_inverse_lambda_ground_f2_turned
            * minus_rhs_lambda_ground_f2_turned
            + minus_l_lambda_ground_f1_turned_lambda_ground_f2_turned * w_39;
        let lean_ddot = inverse_lean * rhs_lean - l_lambda_ground_f2_turned_lean * w_40;
        let lambda_ground = minus_l_lean_lambda_ground * lean_ddot
            - self.minus_inverse_lambda_ground * rhs_lambda_ground;
        let phi_ddot = inverse_phi * rhs_phi - l_lambda_ground_f1_turned_phi * w_39;
        sim_kernel::Dynamics {
            accelerations: [
                minus_l_lambda_ground_f2_turned_x * w_40
                    - l_lambda_ground_f1_turned_x * w_39,
                -(minus_l_lambda_ground_f2_turned_x * w_39
                    + l_lambda_ground_f1_turned_x * w_40),
                -(self.k_3 + self.inverse_z * lambda_ground),
                minus_l_lambda_ground_f1_turned_psi * w_39 - minus_rhs_psi * inverse_psi
                    - l_phi_psi * phi_ddot,
                lean_ddot,
                phi_ddot,
            ],
            multipliers: [
                lambda_ground,
                k_lambda_ground_f1_turned_x * w_39
                    - minus_k_lambda_ground_f2_turned_x * w_40,
                minus_k_lambda_ground_f2_turned_x * w_39
                    + k_lambda_ground_f1_turned_x * w_40,
            ],
            power: -(self.minus_rhs_z * z_dot),
            refused: sim_kernel::pivot_is_refused(self.m, self.m)
                | sim_kernel::pivot_is_refused(self.pivot_lambda_ground, self.inverse_z)
                | sim_kernel::pivot_is_refused(pivot_lean, pivot_lean)
                | sim_kernel::pivot_is_refused(self.m, self.m)
                | sim_kernel::pivot_is_refused(self.m, self.m)
                | sim_kernel::pivot_is_refused(mass_psi_psi, mass_psi_psi)
                | sim_kernel::pivot_is_refused(
                    -minus_pivot_lambda_ground_f2_turned,
                    minus_pivot_lambda_ground_f2_turned,
                ) | sim_kernel::pivot_is_refused(pivot_phi, self.C_)
                | sim_kernel::pivot_is_refused(pivot_lambda_ground_f1_turned, w_38),
        }
    }
    /// The derivatives of accelerations (6 rows) and multipliers (3 rows) with respect to coordinates and speeds (6 columns each): with the equations of motion as `K z = r`, the solutions of `K dz = dr - dK z`. Where `refused` is set a pivot was too small and nothing else holds.
    ///
    /// Operations: 338 additions, 539 multiplications, 72 divisions, 3 sine-cosine pairs, 1 square root.
    #[inline]
    pub fn dynamics_jacobian(
        &self,
        t: S,
        q: &[S; 6],
        qd: &[S; 6],
    ) -> sim_kernel::DynamicsJacobian<S, [[S; 6]; 6], [[S; 6]; 3]> {
        let [_, _, _, psi, lean, phi] = *q;
        let [_, _, _, psi_dot, lean_dot, phi_dot] = *qd;
        let (
            [sin_lean,
            minus_k_lambda_ground_f2_turned_x,
            sin_phi,
            ],
            [cos_lean,
            k_lambda_ground_f1_turned_x,
            cos_phi,
            ],
        ) = S::sin_cos_each([lean, psi, phi]);
        let cos_lean_squared = cos_lean * cos_lean;
        let sqrt_cos_lean_squared = cos_lean_squared.sqrt();
        let lean_dot_squared = lean_dot * lean_dot;
        let sin_lean_squared = sin_lean * sin_lean;
        let w = cos_lean * cos_lean_squared;
        let w_2 = cos_lean / w;
        let inverse_cos_lean_squared = S::from_f64(1.0) / cos_lean_squared;
        let cos_lean_squared_squared = cos_lean_squared * cos_lean_squared;
        let w_3 = self.r * cos_lean_squared / cos_lean_squared_squared;
        let w_4 = self.r / cos_lean_squared;
        let rhs_lambda_ground = self.k_3
            - sqrt_cos_lean_squared * lean_dot_squared
                * (sin_lean_squared * (self.k_2 * (w_2 - inverse_cos_lean_squared) - w_3)
                    + w_4);
        let w_115 = inverse_cos_lean_squared - w_2;
        let w_5 = sin_lean * cos_lean;
        let w_6 = self.r * w_5;
        let ground_by_lean = sqrt_cos_lean_squared * w_6 / cos_lean_squared;
        let minus_l_lean_lambda_ground = ground_by_lean
            * self.minus_inverse_lambda_ground;
        let pivot_lean = self.A_ + ground_by_lean * minus_l_lean_lambda_ground;
        let rhs_lean = cos_lean
            * (self.C_ * psi_dot * phi_dot + sin_lean * self.A_ * psi_dot * psi_dot)
            + minus_l_lean_lambda_ground * rhs_lambda_ground;
        let w_7 = sin_lean * psi_dot;
        let w_8 = phi_dot + w_7;
        let w_9 = self.C_ * cos_lean;
        let w_10 = lean_dot * w_9;
        let minus_rhs_psi = w_8 * w_10;
        let mass_phi_psi = sin_lean * self.C_;
        let mass_psi_psi = self.A_ * (sin_lean_squared + S::from_f64(1.0));
        let inverse_psi = S::from_f64(1.0) / mass_psi_psi;
        let l_phi_psi = mass_phi_psi * inverse_psi;
        let w_11 = cos_lean * psi_dot;
        let w_12 = self.C_ * lean_dot;
        let rhs_phi = minus_rhs_psi * l_phi_psi - w_11 * w_12;
        let w_113 = psi_dot * w_12;
        let w_13 = w_7 + w_8;
        let w_14 = sin_phi * lean_dot + cos_phi * w_11;
        let w_15 = w_14 * phi_dot;
        let w_16 = sin_lean * lean_dot;
        let w_17 = sin_phi * w_16;
        let w_18 = psi_dot * w_17;
        let w_19 = w_15 + (w_18 - w_15);
        let w_20 = lean_dot * cos_phi - sin_phi * w_11;
        let w_21 = phi_dot * w_20;
        let w_22 = cos_phi * w_16;
        let w_23 = psi_dot * w_22;
        let w_112 = S::from_f64(0.25) * sin_lean
            * (sin_phi * self.k * (w_15 - w_18 + w_14 * w_8)
                + cos_phi * self.k * (w_21 - w_23 + w_8 * w_20));
        let w_24 = w_21 + (w_23 - w_21);
        let w_25 = sin_phi * w_19 + cos_phi * w_24;
        let w_26 = cos_phi * w_14 - sin_phi * w_20;
        let w_27 = cos_lean * (lean_dot * w_13 - w_25) - w_16 * w_26;
        let w_28 = sin_lean * w_8;
        let w_29 = cos_lean * w_26;
        let w_30 = w_28 + w_29;
        let w_31 = w_5 * w_27 + lean_dot * w_30;
        let w_32 = sin_lean_squared * lean_dot;
        let w_33 = cos_lean_squared * sqrt_cos_lean_squared;
        let w_34 = w_32 * w_33;
        let sqrt_cos_lean_squared_squared = sqrt_cos_lean_squared
            * sqrt_cos_lean_squared;
        let w_35 = cos_lean_squared * sqrt_cos_lean_squared_squared;
        let w_36 = w_5 * psi_dot;
        let w_37 = minus_k_lambda_ground_f2_turned_x * w_30;
        let w_38 = self.k_2 * w_32;
        let w_39 = k_lambda_ground_f1_turned_x * w_38;
        let k_lambda_ground_f2_turned_lean = self.r
            * ((S::from_f64(1.0) - sin_lean_squared) / sqrt_cos_lean_squared);
        let w_40 = cos_lean_squared * psi_dot;
        let w_41 = sin_lean * w_25;
        let w_42 = cos_phi * w_20 + sin_phi * w_14;
        let w_43 = lean_dot * (w_40 - w_30) + w_41 + psi_dot * w_42;
        let w_44 = sin_lean * w_26;
        let w_175 = self.C_ * w_26;
        let w_45 = cos_lean * w_8 - w_44;
        let w_46 = cos_phi * w_19 - sin_phi * w_24 - psi_dot * w_45;
        let w_47 = k_lambda_ground_f1_turned_x * w_43
            + minus_k_lambda_ground_f2_turned_x * w_46;
        let w_55 = k_lambda_ground_f1_turned_x * w_46
            - minus_k_lambda_ground_f2_turned_x * w_43;
        let w_48 = minus_k_lambda_ground_f2_turned_x * w_42
            + k_lambda_ground_f1_turned_x * w_45;
        let w_49 = sin_lean * sin_lean_squared;
        let w_50 = sin_lean - w_49;
        let w_51 = sin_lean * self.k_2 / sqrt_cos_lean_squared;
        let w_52 = cos_lean * lean_dot
            * (self.r * sqrt_cos_lean_squared
                * (w_50 / sqrt_cos_lean_squared_squared / cos_lean_squared) - w_51);
        let w_99 = cos_lean * (w_51 - self.r * sqrt_cos_lean_squared * w_50 / w_35);
        let w_53 = self.r
            * (k_lambda_ground_f1_turned_x
                * (w_31 / sqrt_cos_lean_squared + w_30 * w_34 / w_35)
                - w_36 * w_37 / sqrt_cos_lean_squared)
            - w_30 * w_39 / sqrt_cos_lean_squared + k_lambda_ground_f2_turned_lean * w_47
            + w_48 * w_52;
        let w_54 = minus_k_lambda_ground_f2_turned_x * w_34 / w_35;
        let w_56 = k_lambda_ground_f1_turned_x * w_42
            - minus_k_lambda_ground_f2_turned_x * w_45;
        let w_57 = self.r
            * (w_30 * (k_lambda_ground_f1_turned_x * w_36 / sqrt_cos_lean_squared + w_54)
                + minus_k_lambda_ground_f2_turned_x * w_31 / sqrt_cos_lean_squared)
            - w_37 * w_38 / sqrt_cos_lean_squared - k_lambda_ground_f2_turned_lean * w_55
            - w_52 * w_56;
        let minus_k_lambda_ground_f1_turned_psi = w_6 / sqrt_cos_lean_squared;
        let minus_l_lambda_ground_f1_turned_psi = minus_k_lambda_ground_f1_turned_psi
            * inverse_psi;
        let inverse_lean = S::from_f64(1.0) / pivot_lean;
        let l_lambda_ground_f2_turned_lean = k_lambda_ground_f2_turned_lean
            * inverse_lean;
        let minus_l_lambda_ground_f2_turned_x = minus_k_lambda_ground_f2_turned_x
            * self.inverse_z;
        let w_58 = minus_k_lambda_ground_f2_turned_x * minus_l_lambda_ground_f2_turned_x;
        let l_lambda_ground_f1_turned_x = k_lambda_ground_f1_turned_x * self.inverse_z;
        let w_59 = k_lambda_ground_f1_turned_x * l_lambda_ground_f1_turned_x;
        let minus_pivot_lambda_ground_f2_turned = k_lambda_ground_f2_turned_lean
            * l_lambda_ground_f2_turned_lean + w_58 + w_59;
        let minus_inverse_lambda_ground_f2_turned = S::from_f64(1.0)
            / minus_pivot_lambda_ground_f2_turned;
        let k_lambda_ground_f1_turned_lambda_ground_f2_turned = k_lambda_ground_f1_turned_x
            * minus_l_lambda_ground_f2_turned_x
            - minus_k_lambda_ground_f2_turned_x * l_lambda_ground_f1_turned_x;
        let minus_l_lambda_ground_f1_turned_lambda_ground_f2_turned = minus_inverse_lambda_ground_f2_turned
            * k_lambda_ground_f1_turned_lambda_ground_f2_turned;
        let minus_rhs_lambda_ground_f2_turned = minus_k_lambda_ground_f2_turned_x * w_53
            - k_lambda_ground_f1_turned_x * w_57
            + l_lambda_ground_f2_turned_lean * rhs_lean;
        let pivot_phi = self.C_ - mass_phi_psi * l_phi_psi;
        let k_lambda_ground_f1_turned_phi = mass_phi_psi
            * minus_l_lambda_ground_f1_turned_psi
            - self.r * cos_lean / sqrt_cos_lean_squared;
        let inverse_phi = S::from_f64(1.0) / pivot_phi;
        let l_lambda_ground_f1_turned_phi = inverse_phi * k_lambda_ground_f1_turned_phi;
        let w_60 = w_59 + w_58
            + minus_k_lambda_ground_f1_turned_psi * minus_l_lambda_ground_f1_turned_psi
            + k_lambda_ground_f1_turned_phi * l_lambda_ground_f1_turned_phi;
        let pivot_lambda_ground_f1_turned = k_lambda_ground_f1_turned_lambda_ground_f2_turned
            * minus_l_lambda_ground_f1_turned_lambda_ground_f2_turned - w_60;
        let inverse_lambda_ground_f1_turned = S::from_f64(1.0)
            / pivot_lambda_ground_f1_turned;
        let w_61 = inverse_lambda_ground_f1_turned
            * (k_lambda_ground_f1_turned_x * w_53
                + minus_k_lambda_ground_f2_turned_x * w_57
                - minus_rhs_psi * minus_l_lambda_ground_f1_turned_psi
                - minus_l_lambda_ground_f1_turned_lambda_ground_f2_turned
                    * minus_rhs_lambda_ground_f2_turned
                - l_lambda_ground_f1_turned_phi * rhs_phi);
        let w_62 = minus_inverse_lambda_ground_f2_turned
            * minus_rhs_lambda_ground_f2_turned
            + minus_l_lambda_ground_f1_turned_lambda_ground_f2_turned * w_61;
        let lean_ddot = inverse_lean * rhs_lean - l_lambda_ground_f2_turned_lean * w_62;
        let phi_ddot = inverse_phi * rhs_phi - l_lambda_ground_f1_turned_phi * w_61;
        let psi_ddot = minus_l_lambda_ground_f1_turned_psi * w_61
            - minus_rhs_psi * inverse_psi - l_phi_psi * phi_ddot;
        let lambda_ground_f2 = minus_k_lambda_ground_f2_turned_x * w_61
            + k_lambda_ground_f1_turned_x * w_62;
        let minus_y_ddot = minus_l_lambda_ground_f2_turned_x * w_61
            + l_lambda_ground_f1_turned_x * w_62;
        let x_ddot = minus_l_lambda_ground_f2_turned_x * w_62
            - l_lambda_ground_f1_turned_x * w_61;
        let w_63 = minus_k_lambda_ground_f2_turned_x * w_62;
        let w_64 = k_lambda_ground_f1_turned_x * w_61;
        let w_65 = w_63 - w_64;
        let w_66 = k_lambda_ground_f1_turned_x * x_ddot
            - minus_k_lambda_ground_f2_turned_x * minus_y_ddot
            + minus_l_lambda_ground_f2_turned_x * lambda_ground_f2
            - l_lambda_ground_f1_turned_x * w_65;
        let w_67 = inverse_lambda_ground_f1_turned
            * (k_lambda_ground_f1_turned_x * minus_y_ddot
                + minus_k_lambda_ground_f2_turned_x * x_ddot
                - l_lambda_ground_f1_turned_x * lambda_ground_f2
                - minus_l_lambda_ground_f2_turned_x * w_65
                + minus_l_lambda_ground_f1_turned_lambda_ground_f2_turned * w_66);
        let w_68 = minus_l_lambda_ground_f1_turned_lambda_ground_f2_turned * w_67
            - minus_inverse_lambda_ground_f2_turned * w_66;
        let w_69 = sin_lean * phi_ddot;
        let w_70 = cos_lean * self.k_7 / cos_lean_squared;
        let w_71 = cos_lean_squared * self.k_2;
        let w_72 = w_71 / w;
        let w_161 = sqrt_cos_lean_squared * lean_dot
            * (sin_lean_squared * (w_115 * self.k_4 + w_71 / cos_lean_squared_squared)
                - self.k_2 / cos_lean_squared);
        let w_116 = sin_lean_squared * (w_3 + self.k_2 * w_115) - w_4;
        let w_73 = self.r * w;
        let w_74 = w_73 / cos_lean_squared_squared;
        let w_117 = w_49
            * (self.k_5 / w - cos_lean * self.k_6 / cos_lean_squared_squared
                + cos_lean_squared * self.k_7 / (cos_lean * cos_lean_squared_squared)
                - w_73 / (w * w));
        let w_118 = sqrt_cos_lean_squared
            * (lean_dot_squared
                * (w_117
                    + sin_lean
                        * (cos_lean
                            * (self.k_4 / cos_lean_squared
                                + self.k_8 / cos_lean_squared_squared) - self.k_7 / w))
                + lean_ddot * w_116);
        let w_75 = w_5 * self.k_8 / cos_lean_squared;
        let w_76 = w_5 * self.k_4 / sqrt_cos_lean_squared;
        let w_77 = sqrt_cos_lean_squared * sqrt_cos_lean_squared_squared;
        let w_78 = w * self.k_2 * sqrt_cos_lean_squared_squared * w_49
            / (cos_lean_squared_squared * w_77);
        let w_100 = cos_lean * self.k_2 / w;
        let w_79 = self.k_2 / sqrt_cos_lean_squared;
        let w_80 = self.r * w_33 / w_35;
        let w_81 = self.r / sqrt_cos_lean_squared;
        let w_82 = sin_lean_squared * (w_79 - w_80) - w_81;
        let w_104 = w_80 - w_79;
        let w_105 = w_81 + sin_lean_squared * w_104;
        let w_83 = sin_lean * phi_dot;
        let w_84 = cos_lean * cos_phi;
        let w_132 = phi_dot * w_84 - w_17;
        let w_85 = psi_dot * (sin_phi * w_83 - lean_dot * w_84);
        let w_141 = self.k * (w_132 + w_8 * w_84 + sin_lean * w_14);
        let w_86 = cos_lean * sin_phi;
        let w_87 = psi_dot * (cos_phi * w_83 + lean_dot * w_86);
        let w_109 = self.k * (psi_dot * (cos_lean * w_14 - cos_phi * w_28) - w_87);
        let w_131 = phi_dot * w_86 + w_22;
        let w_142 = self.k * (sin_lean * w_20 - w_131 - w_8 * w_86);
        let w_110 = self.k * (w_85 + psi_dot * (sin_phi * w_28 + cos_lean * w_20));
        let w_90 = psi_dot - w_28 - w_29;
        let w_111 = cos_lean
            * (S::from_f64(0.25) * (sin_phi * w_109 + cos_phi * w_110)
                + self.C_ * (phi_ddot + sin_lean * psi_ddot));
        let w_114 = sin_lean_squared * (w_61 * w_104 + lean_dot * psi_dot * self.k)
            - w_111 + w_112 - w_113 + self.r * w_61 / sqrt_cos_lean_squared;
        let w_119 = sqrt_cos_lean_squared
            * (minus_l_lean_lambda_ground * lean_ddot
                - self.minus_inverse_lambda_ground * rhs_lambda_ground) * w_116
            + S::from_f64(0.25) * (cos_phi * w_109 - sin_phi * w_110) + w_62 * w_99
            + minus_l_lean_lambda_ground * w_118;
        let w_88 = cos_phi * w_85 - sin_phi * w_87;
        let w_89 = w_6
            * (lean_dot
                * (w_30
                    + S::from_f64(2.0) * psi_dot * (sin_lean_squared - S::from_f64(1.0)))
                - w_41 - cos_lean * w_88) / sqrt_cos_lean_squared;
        let w_98 = lean_dot * (w_45 + S::from_f64(2.0) * w_36) - cos_lean * w_25
            + sin_lean * w_88;
        let w_97 = cos_phi * w_87 + sin_phi * w_85 - phi_dot * w_7 - psi_dot * w_90;
        let w_91 = w_52 * w_90;
        let w_92 = lean_dot
            * (w_30
                * (sqrt_cos_lean_squared
                    * ((w_49 * (w_70 - w_72 + w_74) - w_75)
                        / sqrt_cos_lean_squared_squared) + w_76 - w_78) + w_45 * w_82)
            + w_27 * w_82 + w_89 - w_91;
        let w_106 = w_91 - w_89
            + lean_dot
                * (w_30
                    * (w_78 - w_76
                        + sqrt_cos_lean_squared
                            * ((w_75 + w_49 * (w_72 - w_70 - w_74))
                                / sqrt_cos_lean_squared_squared)) + w_45 * w_105)
            + w_27 * w_105;
        let w_93 = sin_lean_squared * w_30 * w_33 / w_35;
        let w_94 = sin_lean_squared * self.k_2;
        let w_95 = w_30 * w_94 / sqrt_cos_lean_squared;
        let w_96 = psi_dot
            * (self.r * ((w_30 + w_5 * w_45) / sqrt_cos_lean_squared + w_93) - w_95);
        let w_137 = w_45 + (cos_phi * w_132 + sin_phi * w_131 - cos_lean * phi_dot);
        let w_133 = cos_phi * w_131 - sin_phi * w_132;
        let w_136 = w_42 - (w_32 - sin_lean * w_133);
        let w_134 = cos_lean * (w_16 - w_133);
        let w_174 = w_9 * w_42;
        let sin_lean_squared_squared = sin_lean_squared * sin_lean_squared;
        let w_101 = sqrt_cos_lean_squared
            * ((sin_lean_squared * (w_3 + self.k_9 / cos_lean_squared - w_100) - w_4
                + sin_lean_squared_squared * (w_100 - w_3 - self.k_7 / cos_lean_squared))
                / sqrt_cos_lean_squared_squared);
        let inverse_sqrt_cos_lean_squared = S::from_f64(1.0) / sqrt_cos_lean_squared;
        let w_102 = lean_dot
            * (w_101
                + self.k_2
                    * (inverse_sqrt_cos_lean_squared
                        + cos_lean_squared * sqrt_cos_lean_squared_squared
                            * ((sin_lean_squared_squared - sin_lean_squared) / w_77
                                / cos_lean_squared_squared))
                - sin_lean_squared * self.k_4 / sqrt_cos_lean_squared);
        let w_103 = k_lambda_ground_f1_turned_x * w_92
            + minus_k_lambda_ground_f2_turned_x * w_96
            - k_lambda_ground_f2_turned_lean
                * (minus_k_lambda_ground_f2_turned_x * w_97
                    - k_lambda_ground_f1_turned_x * w_98) + w_47 * w_99 + w_48 * w_102;
        let w_107 = minus_k_lambda_ground_f2_turned_x * w_106
            + k_lambda_ground_f1_turned_x * w_96
            - k_lambda_ground_f2_turned_lean
                * (k_lambda_ground_f1_turned_x * w_97
                    + minus_k_lambda_ground_f2_turned_x * w_98) + w_55 * w_99
            + w_56 * w_102;
        let w_108 = self.r
            * (cos_lean_squared * sqrt_cos_lean_squared
                * ((sin_lean_squared * psi_ddot + w_69) / sqrt_cos_lean_squared_squared
                    / cos_lean_squared) + (psi_ddot - w_69) / sqrt_cos_lean_squared)
            - k_lambda_ground_f1_turned_x * w_103
            + minus_k_lambda_ground_f2_turned_x * w_107
            - psi_ddot * w_94 / sqrt_cos_lean_squared;
        let w_120 = k_lambda_ground_f1_turned_x * w_107
            + minus_k_lambda_ground_f2_turned_x * w_103 + lean_ddot * w_99
            - l_lambda_ground_f2_turned_lean * w_119;
        let w_121 = sin_lean
            * (w_113 + self.r * w_61 * (w_33 / w_35 - inverse_sqrt_cos_lean_squared))
            - w_9 * psi_ddot - l_phi_psi * w_114;
        let w_122 = inverse_lambda_ground_f1_turned
            * (w_108 + minus_l_lambda_ground_f1_turned_psi * w_114
                + minus_l_lambda_ground_f1_turned_lambda_ground_f2_turned * w_120
                - l_lambda_ground_f1_turned_phi * w_121);
        let w_123 = minus_l_lambda_ground_f1_turned_lambda_ground_f2_turned * w_122
            - minus_inverse_lambda_ground_f2_turned * w_120;
        let w_126 = inverse_lean * w_119 - l_lambda_ground_f2_turned_lean * w_123;
        let w_127 = minus_l_lean_lambda_ground * w_126
            - self.minus_inverse_lambda_ground * w_118;
        let w_129 = inverse_phi * w_121 - l_lambda_ground_f1_turned_phi * w_122;
        let w_169 = self.r * sin_lean_squared;
        let w_124 = l_lambda_ground_f2_turned_lean * w_68;
        let w_125 = minus_l_lean_lambda_ground * w_124;
        let w_128 = l_lambda_ground_f1_turned_phi * w_67;
        let w_130 = psi_dot + w_30;
        let w_135 = self.r
            * (w_54
                + (sin_lean * cos_lean
                    * (k_lambda_ground_f1_turned_x * w_130
                        + minus_k_lambda_ground_f2_turned_x * w_134)
                    + minus_k_lambda_ground_f2_turned_x * lean_dot)
                    / sqrt_cos_lean_squared);
        let w_138 = w_135
            - minus_k_lambda_ground_f2_turned_x * w_38 / sqrt_cos_lean_squared
            + k_lambda_ground_f2_turned_lean
                * (minus_k_lambda_ground_f2_turned_x * w_136
                    + k_lambda_ground_f1_turned_x * w_137);
        let w_139 = self.r
            * ((sin_lean * cos_lean
                * (minus_k_lambda_ground_f2_turned_x * w_130
                    - k_lambda_ground_f1_turned_x * w_134)
                - k_lambda_ground_f1_turned_x * lean_dot) / sqrt_cos_lean_squared
                - k_lambda_ground_f1_turned_x * w_34 / w_35);
        let w_140 = w_139 + w_39 / sqrt_cos_lean_squared
            - k_lambda_ground_f2_turned_lean
                * (k_lambda_ground_f1_turned_x * w_136
                    - minus_k_lambda_ground_f2_turned_x * w_137);
        let w_143 = cos_lean
            * (S::from_f64(0.25) * (sin_phi * w_141 + cos_phi * w_142) + self.C_ * w_16);
        let w_144 = S::from_f64(0.25) * (cos_phi * w_141 - sin_phi * w_142);
        let w_146 = l_phi_psi * w_143 - w_10;
        let w_145 = k_lambda_ground_f1_turned_x * w_138
            + minus_k_lambda_ground_f2_turned_x * w_140
            - l_lambda_ground_f2_turned_lean * w_144;
        let w_147 = inverse_lambda_ground_f1_turned
            * (minus_k_lambda_ground_f2_turned_x * w_138
                - k_lambda_ground_f1_turned_x * w_140
                - minus_l_lambda_ground_f1_turned_psi * w_143
                + minus_l_lambda_ground_f1_turned_lambda_ground_f2_turned * w_145
                - l_lambda_ground_f1_turned_phi * w_146);
        let w_148 = minus_l_lambda_ground_f1_turned_lambda_ground_f2_turned * w_147
            - minus_inverse_lambda_ground_f2_turned * w_145;
        let w_180 = inverse_lean * w_144 - l_lambda_ground_f2_turned_lean * w_148;
        let w_186 = inverse_phi * w_146 - l_lambda_ground_f1_turned_phi * w_147;
        let w_149 = w_7 - phi_dot;
        let w_150 = cos_phi * w_149;
        let w_151 = sin_phi * w_149;
        let w_152 = phi_dot + cos_phi * w_150 + sin_phi * w_151;
        let w_153 = self.r
            * (w_93
                + (w_30 + w_5 * (cos_lean * (w_13 - w_152) - w_44))
                    / sqrt_cos_lean_squared) - w_95;
        let w_154 = psi_dot - (w_29 - w_40 + sin_lean * (w_8 - w_152));
        let w_155 = cos_phi * w_151 - sin_phi * w_150;
        let w_156 = k_lambda_ground_f1_turned_x * w_153
            + k_lambda_ground_f2_turned_lean
                * (k_lambda_ground_f1_turned_x * w_154
                    + minus_k_lambda_ground_f2_turned_x * w_155)
            + minus_k_lambda_ground_f2_turned_x * w_52 - w_48 * w_99;
        let w_157 = minus_k_lambda_ground_f2_turned_x * w_153
            - k_lambda_ground_f2_turned_lean
                * (k_lambda_ground_f1_turned_x * w_155
                    - minus_k_lambda_ground_f2_turned_x * w_154)
            - k_lambda_ground_f1_turned_x * w_52 + w_56 * w_99;
        let w_167 = cos_lean * w_52;
        let w_158 = self.k * (sin_phi * w_8 - w_151);
        let w_159 = self.k * (cos_phi * w_8 - w_150);
        let w_160 = cos_lean
            * (S::from_f64(0.25) * (sin_phi * w_158 + cos_phi * w_159) + self.C_ * w_7);
        let w_162 = S::from_f64(0.25) * (cos_phi * w_158 - sin_phi * w_159)
            + minus_l_lean_lambda_ground * w_161;
        let w_163 = k_lambda_ground_f1_turned_x * w_157
            - minus_k_lambda_ground_f2_turned_x * w_156
            - l_lambda_ground_f2_turned_lean * w_162;
        let w_164 = l_phi_psi * w_160 - self.C_ * w_11;
        let w_165 = inverse_lambda_ground_f1_turned
            * (k_lambda_ground_f1_turned_x * w_156
                + minus_k_lambda_ground_f2_turned_x * w_157
                - minus_l_lambda_ground_f1_turned_psi * w_160
                + minus_l_lambda_ground_f1_turned_lambda_ground_f2_turned * w_163
                - l_lambda_ground_f1_turned_phi * w_164);
        let w_166 = minus_l_lambda_ground_f1_turned_lambda_ground_f2_turned * w_165
            - minus_inverse_lambda_ground_f2_turned * w_163;
        let w_182 = inverse_lean * w_162 - l_lambda_ground_f2_turned_lean * w_166;
        let w_183 = minus_l_lean_lambda_ground * w_182
            - self.minus_inverse_lambda_ground * w_161;
        let w_187 = inverse_phi * w_164 - l_lambda_ground_f1_turned_phi * w_165;
        let w_168 = self.k_8 / sqrt_cos_lean_squared;
        let w_170 = k_lambda_ground_f1_turned_x * w_11;
        let w_171 = minus_k_lambda_ground_f2_turned_x
            * (w_167 + lean_dot * (w_51 + w_49 * (w_80 - w_168)))
            + w_169 * w_170 / sqrt_cos_lean_squared
            + k_lambda_ground_f2_turned_lean
                * (w_170 - minus_k_lambda_ground_f2_turned_x * w_16);
        let w_172 = minus_k_lambda_ground_f2_turned_x * w_11;
        let w_173 = k_lambda_ground_f1_turned_x
            * (lean_dot * (w_49 * (w_168 - w_80) - w_51) - w_167)
            + w_172 * w_169 / sqrt_cos_lean_squared
            + k_lambda_ground_f2_turned_lean
                * (k_lambda_ground_f1_turned_x * w_16 + w_172);
        let w_176 = k_lambda_ground_f1_turned_x * w_171
            + minus_k_lambda_ground_f2_turned_x * w_173
            - l_lambda_ground_f2_turned_lean * w_175;
        let w_177 = l_phi_psi * w_174;
        let w_178 = inverse_lambda_ground_f1_turned
            * (minus_k_lambda_ground_f2_turned_x * w_171
                - k_lambda_ground_f1_turned_x * w_173
                - minus_l_lambda_ground_f1_turned_psi * w_174
                + minus_l_lambda_ground_f1_turned_lambda_ground_f2_turned * w_176
                - l_lambda_ground_f1_turned_phi * w_177);
        let w_179 = minus_l_lambda_ground_f1_turned_lambda_ground_f2_turned * w_178
            - minus_inverse_lambda_ground_f2_turned * w_176;
        let w_184 = inverse_lean * w_175 - l_lambda_ground_f2_turned_lean * w_179;
        let w_188 = inverse_phi * w_177 - l_lambda_ground_f1_turned_phi * w_178;
        let w_181 = minus_l_lean_lambda_ground * w_180;
        let w_185 = minus_l_lean_lambda_ground * w_184;
        sim_kernel::DynamicsJacobian {
            accelerations_by_positions: [
                [
                    S::from_f64(0.0),
                    S::from_f64(0.0),
                    S::from_f64(0.0),
                    self.inverse_z * lambda_ground_f2
                        - l_lambda_ground_f1_turned_x * w_67
                        + minus_l_lambda_ground_f2_turned_x * w_68,
                    minus_l_lambda_ground_f2_turned_x * w_123
                        - l_lambda_ground_f1_turned_x * w_122,
                    S::from_f64(0.0),
                ],
                [
                    S::from_f64(0.0),
                    S::from_f64(0.0),
                    S::from_f64(0.0),
                    self.inverse_z * w_65 - minus_l_lambda_ground_f2_turned_x * w_67
                        - l_lambda_ground_f1_turned_x * w_68,
                    -(minus_l_lambda_ground_f2_turned_x * w_122
                        + l_lambda_ground_f1_turned_x * w_123),
                    S::from_f64(0.0),
                ],
                [
                    S::from_f64(0.0),
                    S::from_f64(0.0),
                    S::from_f64(0.0),
                    self.inverse_z * w_125,
                    -(self.inverse_z * w_127),
                    S::from_f64(0.0),
                ],
                [
                    S::from_f64(0.0),
                    S::from_f64(0.0),
                    S::from_f64(0.0),
                    l_phi_psi * w_128 + minus_l_lambda_ground_f1_turned_psi * w_67,
                    inverse_psi * w_114 - l_phi_psi * w_129
                        + minus_l_lambda_ground_f1_turned_psi * w_122,
                    S::from_f64(0.0),
                ],
                [
                    S::from_f64(0.0),
                    S::from_f64(0.0),
                    S::from_f64(0.0),
                    -w_124,
                    w_126,
                    S::from_f64(0.0),
                ],
                [
                    S::from_f64(0.0),
                    S::from_f64(0.0),
                    S::from_f64(0.0),
                    -w_128,
                    w_129,
                    S::from_f64(0.0),
                ],
            ],
            accelerations_by_speeds: [
                [
                    S::from_f64(0.0),
                    S::from_f64(0.0),
                    S::from_f64(0.0),
                    minus_l_lambda_ground_f2_turned_x * w_148
                        - l_lambda_ground_f1_turned_x * w_147,
                    minus_l_lambda_ground_f2_turned_x * w_166
                        - l_lambda_ground_f1_turned_x * w_165,
                    minus_l_lambda_ground_f2_turned_x * w_179
                        - l_lambda_ground_f1_turned_x * w_178,
                ],
                [
                    S::from_f64(0.0),
                    S::from_f64(0.0),
                    S::from_f64(0.0),
                    -(minus_l_lambda_ground_f2_turned_x * w_147
                        + l_lambda_ground_f1_turned_x * w_148),
                    -(minus_l_lambda_ground_f2_turned_x * w_165
                        + l_lambda_ground_f1_turned_x * w_166),
                    -(minus_l_lambda_ground_f2_turned_x * w_178
                        + l_lambda_ground_f1_turned_x * w_179),
                ],
                [
                    S::from_f64(0.0),
                    S::from_f64(0.0),
                    S::from_f64(0.0),
                    -(self.inverse_z * w_181),
                    -(self.inverse_z * w_183),
                    -(self.inverse_z * w_185),
                ],
                [
                    S::from_f64(0.0),
                    S::from_f64(0.0),
                    S::from_f64(0.0),
                    minus_l_lambda_ground_f1_turned_psi * w_147 - inverse_psi * w_143
                        - l_phi_psi * w_186,
                    minus_l_lambda_ground_f1_turned_psi * w_165 - inverse_psi * w_160
                        - l_phi_psi * w_187,
                    minus_l_lambda_ground_f1_turned_psi * w_178 - inverse_psi * w_174
                        - l_phi_psi * w_188,
                ],
                [
                    S::from_f64(0.0),
                    S::from_f64(0.0),
                    S::from_f64(0.0),
                    w_180,
                    w_182,
                    w_184,
                ],
                [
                    S::from_f64(0.0),
                    S::from_f64(0.0),
                    S::from_f64(0.0),
                    w_186,
                    w_187,
                    w_188,
                ],
            ],
            multipliers_by_positions: [
                [
                    S::from_f64(0.0),
                    S::from_f64(0.0),
                    S::from_f64(0.0),
                    -w_125,
                    w_127,
                    S::from_f64(0.0),
                ],
                [
                    S::from_f64(0.0),
                    S::from_f64(0.0),
                    S::from_f64(0.0),
                    k_lambda_ground_f1_turned_x * w_67
                        - minus_k_lambda_ground_f2_turned_x * w_68 - lambda_ground_f2,
                    k_lambda_ground_f1_turned_x * w_122
                        - minus_k_lambda_ground_f2_turned_x * w_123,
                    S::from_f64(0.0),
                ],
                [
                    S::from_f64(0.0),
                    S::from_f64(0.0),
                    S::from_f64(0.0),
                    minus_k_lambda_ground_f2_turned_x * w_67
                        + k_lambda_ground_f1_turned_x * w_68 + (w_64 - w_63),
                    minus_k_lambda_ground_f2_turned_x * w_122
                        + k_lambda_ground_f1_turned_x * w_123,
                    S::from_f64(0.0),
                ],
            ],
            multipliers_by_speeds: [
                [
                    S::from_f64(0.0),
                    S::from_f64(0.0),
                    S::from_f64(0.0),
                    w_181,
                    w_183,
                    w_185,
                ],
                [
                    S::from_f64(0.0),
                    S::from_f64(0.0),
                    S::from_f64(0.0),
                    k_lambda_ground_f1_turned_x * w_147
                        - minus_k_lambda_ground_f2_turned_x * w_148,
                    k_lambda_ground_f1_turned_x * w_165
                        - minus_k_lambda_ground_f2_turned_x * w_166,
                    k_lambda_ground_f1_turned_x * w_178
                        - minus_k_lambda_ground_f2_turned_x * w_179,
                ],
                [
                    S::from_f64(0.0),
                    S::from_f64(0.0),
                    S::from_f64(0.0),
                    minus_k_lambda_ground_f2_turned_x * w_147
                        + k_lambda_ground_f1_turned_x * w_148,
                    minus_k_lambda_ground_f2_turned_x * w_165
                        + k_lambda_ground_f1_turned_x * w_166,
                    minus_k_lambda_ground_f2_turned_x * w_178
                        + k_lambda_ground_f1_turned_x * w_179,
                ],
            ],
            refused: sim_kernel::pivot_is_refused(self.m, self.m)
                | sim_kernel::pivot_is_refused(self.pivot_lambda_ground, self.inverse_z)
                | sim_kernel::pivot_is_refused(pivot_lean, pivot_lean)
                | sim_kernel::pivot_is_refused(self.m, self.m)
                | sim_kernel::pivot_is_refused(self.m, self.m)
                | sim_kernel::pivot_is_refused(mass_psi_psi, mass_psi_psi)
                | sim_kernel::pivot_is_refused(
                    -minus_pivot_lambda_ground_f2_turned,
                    minus_pivot_lambda_ground_f2_turned,
                ) | sim_kernel::pivot_is_refused(pivot_phi, self.C_)
                | sim_kernel::pivot_is_refused(pivot_lambda_ground_f1_turned, w_60),
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
    type Entries = [S; 0];
    type Envelope = [S; 0];
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
                    is_length: true,
                    docs: "Place of the centre.",
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
                speed_given: false,
            },
            sim_kernel::Coordinate {
                position: sim_kernel::Quantity {
                    name: "y",
                    unit: "m",
                    factor: 1f64,
                    is_length: true,
                    docs: "",
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
                speed_given: false,
            },
            sim_kernel::Coordinate {
                position: sim_kernel::Quantity {
                    name: "z",
                    unit: "m",
                    factor: 1f64,
                    is_length: true,
                    docs: "",
                },
                speed: sim_kernel::Quantity {
                    name: "z_dot",
                    unit: "m/s",
                    factor: 1f64,
                    is_length: false,
                    docs: "",
                },
                acceleration: sim_kernel::Quantity {
                    name: "z_ddot",
                    unit: "m/s^2",
                    factor: 1f64,
                    is_length: false,
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
                    is_length: false,
                    docs: "Direction of rolling.",
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
                    name: "lean",
                    unit: "rad",
                    factor: 1f64,
                    is_length: false,
                    docs: "Lean from the upright.",
                },
                speed: sim_kernel::Quantity {
                    name: "lean_dot",
                    unit: "rad/s",
                    factor: 1f64,
                    is_length: false,
                    docs: "",
                },
                acceleration: sim_kernel::Quantity {
                    name: "lean_ddot",
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
                    docs: "Turn about its own axis.",
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
                name: "r",
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
                name: "lean0",
                unit: "deg",
                factor: 0.017453292519943295f64,
                is_length: false,
                docs: "Lean at the start.",
            },
            sim_kernel::Quantity {
                name: "turning",
                unit: "rad/s",
                factor: 1f64,
                is_length: false,
                docs: "Rate of turning at the start.",
            },
            sim_kernel::Quantity {
                name: "nod",
                unit: "rad/s",
                factor: 1f64,
                is_length: false,
                docs: "Speed of leaning at the start.",
            },
        ],
        inputs: &[],
        constraints: &[
            sim_kernel::Quantity {
                name: "ground",
                unit: "N",
                factor: 1f64,
                is_length: false,
                docs: "",
            },
            sim_kernel::Quantity {
                name: "ground_f1",
                unit: "N",
                factor: 1f64,
                is_length: false,
                docs: "",
            },
            sim_kernel::Quantity {
                name: "ground_f2",
                unit: "N",
                factor: 1f64,
                is_length: false,
                docs: "",
            },
        ],
        speed_constraints: &[1, 2],
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
                name: "leaning",
                unit: "deg",
                factor: 0.017453292519943295f64,
                is_length: false,
                docs: "lean",
            },
            sim_kernel::Quantity {
                name: "speed",
                unit: "m/s",
                factor: 1f64,
                is_length: false,
                docs: "speed of the centre",
            },
            sim_kernel::Quantity {
                name: "normal_force",
                unit: "N",
                factor: 1f64,
                is_length: false,
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
        optional_kernels: &["dynamics_jacobian"],
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
