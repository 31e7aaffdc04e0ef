/// Five uniform rods, each hanging on the one before, by their angles from the vertical.
///
/// The fields are its parameters, in SI units; the methods are its kernels.
///
/// Its equations of motion are printed by `codegen FILE --equations infix`.
#[allow(non_snake_case)]
#[derive(
    ::core::clone::Clone,
    ::core::marker::Copy,
    ::core::fmt::Debug,
    ::core::cmp::PartialEq
)]
pub struct Chain<S = ::core::primitive::f64> {
    /// Mass of a rod, in `kg`.
    pub m: S,
    /// Length of a rod, in `m`.
    pub l: S,
    /// Acceleration of free fall, in `m/s^2`.
    pub g: S,
}
impl<S: sim_kernel::Scalar> ::core::default::Default for Chain<S> {
    /// The declared values.
    fn default() -> Self {
        <Self as sim_kernel::Mechanism<S>>::defaults()
    }
}
/// Coordinates of [`Chain`] by name, in SI units; also for their speeds and accelerations.
#[allow(non_snake_case)]
#[derive(
    ::core::clone::Clone,
    ::core::marker::Copy,
    ::core::fmt::Debug,
    ::core::cmp::PartialEq
)]
pub struct ChainCoordinates<S = ::core::primitive::f64> {
    /// In `rad`.
    pub phi_1: S,
    /// In `rad`.
    pub phi_2: S,
    /// In `rad`.
    pub phi_3: S,
    /// In `rad`.
    pub phi_4: S,
    /// In `rad`.
    pub phi_5: S,
}
impl<S: sim_kernel::Scalar> ::core::convert::From<[S; 5]> for ChainCoordinates<S> {
    fn from(values: [S; 5]) -> Self {
        Self {
            phi_1: values[0],
            phi_2: values[1],
            phi_3: values[2],
            phi_4: values[3],
            phi_5: values[4],
        }
    }
}
impl<S: sim_kernel::Scalar> ::core::convert::From<ChainCoordinates<S>> for [S; 5] {
    fn from(record: ChainCoordinates<S>) -> Self {
        [record.phi_1, record.phi_2, record.phi_3, record.phi_4, record.phi_5]
    }
}
/// Outputs of [`Chain`] by name, in SI units.
#[allow(non_snake_case)]
#[derive(
    ::core::clone::Clone,
    ::core::marker::Copy,
    ::core::fmt::Debug,
    ::core::cmp::PartialEq
)]
pub struct ChainOutputs<S = ::core::primitive::f64> {
    /// End of the chain, in `m`.
    pub tip_x: S,
    /// In `m`.
    pub tip_y: S,
}
impl<S: sim_kernel::Scalar> ::core::convert::From<[S; 2]> for ChainOutputs<S> {
    fn from(values: [S; 2]) -> Self {
        Self {
            tip_x: values[0],
            tip_y: values[1],
        }
    }
}
impl<S: sim_kernel::Scalar> ::core::convert::From<ChainOutputs<S>> for [S; 2] {
    fn from(record: ChainOutputs<S>) -> Self {
        [record.tip_x, record.tip_y]
    }
}
/// Rates of the outputs of [`Chain`] by name, in SI units.
#[allow(non_snake_case)]
#[derive(
    ::core::clone::Clone,
    ::core::marker::Copy,
    ::core::fmt::Debug,
    ::core::cmp::PartialEq
)]
pub struct ChainOutputRates<S = ::core::primitive::f64> {
    /// Rate of `tip_x`.
    pub tip_x: S,
    /// Rate of `tip_y`.
    pub tip_y: S,
}
impl<S: sim_kernel::Scalar> ::core::convert::From<[S; 2]> for ChainOutputRates<S> {
    fn from(values: [S; 2]) -> Self {
        Self {
            tip_x: values[0],
            tip_y: values[1],
        }
    }
}
impl<S: sim_kernel::Scalar> ::core::convert::From<ChainOutputRates<S>> for [S; 2] {
    fn from(record: ChainOutputRates<S>) -> Self {
        [record.tip_x, record.tip_y]
    }
}
/// What the equations of motion need of the parameters of [`Chain`], from [`Chain::prepare`]; its methods are the kernels of each step.
#[allow(non_snake_case)]
#[derive(
    ::core::clone::Clone,
    ::core::marker::Copy,
    ::core::fmt::Debug,
    ::core::cmp::PartialEq
)]
pub struct ChainPrepared<S = ::core::primitive::f64> {
    m: S,
    l: S,
    mass_phi_1_phi_1: S,
    k: S,
    mass_phi_2_phi_2: S,
    k_2: S,
    k_3: S,
    k_4: S,
    k_5: S,
    inverse_phi_5: S,
}
#[allow(non_snake_case, unused_variables, unused_parens, clippy::all, clippy::pedantic)]
impl<S: sim_kernel::Scalar> Chain<S> {
    /// What the equations of motion need of the parameters, computed once for a set of parameters.
    ///
    /// Operations: 14 multiplications, 1 division.
    #[inline]
    pub fn prepare(&self) -> ChainPrepared<S> {
        let l_squared = self.l * self.l;
        let mass_phi_2_phi_2 = self.m * l_squared * S::from_f64(0.3333333333333333);
        let w = self.m * self.l;
        ChainPrepared {
            m: self.m,
            l: self.l,
            mass_phi_1_phi_1: S::from_f64(1.3333333333333333) * self.m * l_squared,
            k: self.m * l_squared * S::from_f64(0.5),
            mass_phi_2_phi_2: mass_phi_2_phi_2,
            k_2: S::from_f64(0.5) * w,
            k_3: w * S::from_f64(1.5) * self.g,
            k_4: S::from_f64(0.5) * w * self.g,
            k_5: self.m * self.g,
            inverse_phi_5: S::from_f64(1.0) / mass_phi_2_phi_2,
        }
    }
    /// Mass matrix `T_q' M T_q`, 5 x 5, symmetric, in SI units.
    ///
    /// Operations: 24 additions, 62 multiplications, 5 sine-cosine pairs.
    #[inline]
    pub fn mass_matrix(&self, t: S, q: &[S; 5]) -> [[S; 5]; 5] {
        let [phi_1, phi_2, phi_3, phi_4, phi_5] = *q;
        let w = self.m * self.l * self.l;
        let (
            [sin_phi_1,
            sin_phi_2,
            sin_phi_3,
            sin_phi_4,
            sin_phi_5,
            ],
            [cos_phi_1,
            cos_phi_2,
            cos_phi_3,
            cos_phi_4,
            cos_phi_5,
            ],
        ) = S::sin_cos_each([phi_1, phi_2, phi_3, phi_4, phi_5]);
        let u1_x = self.l * sin_phi_1;
        let w_2 = self.m * (S::from_f64(1.0) + S::from_f64(1.0));
        let w_3 = self.m + w_2;
        let w_4 = self.l * cos_phi_1;
        let u2_x = self.l * sin_phi_2;
        let w_5 = u2_x * w_3;
        let w_6 = self.l * cos_phi_2;
        let w_7 = w_6 * w_3;
        let w_8 = w * S::from_f64(0.5) * (cos_phi_1 * cos_phi_2 + sin_phi_1 * sin_phi_2)
            + u1_x * w_5 + w_4 * w_7;
        let w_9 = self.m * self.l;
        let w_10 = S::from_f64(0.5) * w_9;
        let w_15 = w_10 + w_9;
        let w_11 = w_10 + self.l * w_2;
        let w_12 = sin_phi_3 * w_11;
        let w_13 = cos_phi_3 * w_11;
        let w_14 = u1_x * w_12 + w_4 * w_13;
        let w_20 = u2_x * w_12 + w_6 * w_13;
        let w_16 = sin_phi_4 * w_15;
        let w_17 = cos_phi_4 * w_15;
        let w_18 = u1_x * w_16 + w_4 * w_17;
        let mass_P4_y_phi_5 = w_10 * sin_phi_5;
        let mass_P4_x_phi_5 = w_10 * cos_phi_5;
        let w_19 = mass_P4_y_phi_5 * u1_x + mass_P4_x_phi_5 * w_4;
        let mass_phi_2_phi_2 = w * S::from_f64(0.3333333333333333);
        let w_21 = u2_x * w_16 + w_6 * w_17;
        let w_22 = mass_P4_y_phi_5 * u2_x + mass_P4_x_phi_5 * w_6;
        let u3_x = self.l * sin_phi_3;
        let w_23 = self.l * cos_phi_3;
        let w_24 = u3_x * w_16 + w_23 * w_17;
        let w_25 = mass_P4_y_phi_5 * u3_x + mass_P4_x_phi_5 * w_23;
        let u4_x = self.l * sin_phi_4;
        let w_26 = self.l * cos_phi_4;
        let w_27 = mass_P4_y_phi_5 * u4_x + mass_P4_x_phi_5 * w_26;
        [
            [
                S::from_f64(1.3333333333333333) * w + u1_x * u1_x * w_3
                    + w_4 * w_4 * w_3,
                w_8,
                w_14,
                w_18,
                w_19,
            ],
            [w_8, mass_phi_2_phi_2 + u2_x * w_5 + w_6 * w_7, w_20, w_21, w_22],
            [
                w_14,
                w_20,
                mass_phi_2_phi_2 + u3_x * u3_x * w_2 + w_23 * w_23 * w_2,
                w_24,
                w_25,
            ],
            [
                w_18,
                w_21,
                w_24,
                mass_phi_2_phi_2 + u4_x * self.m * u4_x + w_26 * self.m * w_26,
                w_27,
            ],
            [w_19, w_22, w_25, w_27, mass_phi_2_phi_2],
        ]
    }
    /// Convective forces `T_q' M g`, 5, with `g = (T_q q' + T_t)_q q' + (..)_t`: joules per unit of each coordinate.
    ///
    /// Operations: 28 additions, 70 multiplications, 5 sine-cosine pairs.
    #[inline]
    pub fn convective_forces(&self, t: S, q: &[S; 5], qd: &[S; 5]) -> [S; 5] {
        let [phi_1, phi_2, phi_3, phi_4, phi_5] = *q;
        let [phi_1_dot, phi_2_dot, phi_3_dot, phi_4_dot, phi_5_dot] = *qd;
        let w = S::from_f64(0.5) * self.m;
        let w_2 = w * self.l * self.l;
        let w_4 = self.l * w;
        let phi_2_dot_squared = phi_2_dot * phi_2_dot;
        let (
            [sin_phi_1,
            sin_phi_2,
            sin_phi_3,
            sin_phi_4,
            sin_phi_5,
            ],
            [cos_phi_1,
            cos_phi_2,
            cos_phi_3,
            cos_phi_4,
            cos_phi_5,
            ],
        ) = S::sin_cos_each([phi_1, phi_2, phi_3, phi_4, phi_5]);
        let w_3 = sin_phi_1 * cos_phi_2 - cos_phi_1 * sin_phi_2;
        let phi_3_dot_squared = phi_3_dot * phi_3_dot;
        let w_5 = w_4 * phi_3_dot_squared;
        let w_7 = self.l * phi_3_dot_squared;
        let phi_1_dot_squared = phi_1_dot * phi_1_dot;
        let P2_y_convective = self.l
            * (cos_phi_1 * phi_1_dot_squared + phi_2_dot_squared * cos_phi_2);
        let phi_4_dot_squared = phi_4_dot * phi_4_dot;
        let w_6 = w_4 * phi_4_dot_squared;
        let w_10 = self.l * phi_4_dot_squared;
        let w_8 = cos_phi_3 * w_7 + P2_y_convective;
        let w_9 = w_4 * phi_5_dot * phi_5_dot;
        let w_11 = cos_phi_4 * w_10 + w_8;
        let w_12 = w_9 * cos_phi_5 + self.m * w_11;
        let w_13 = w_6 * cos_phi_4 + self.m * w_8 + w_12;
        let w_14 = w_5 * cos_phi_3 + self.m * P2_y_convective + w_13;
        let minus_P2_x_convective = self.l
            * (phi_1_dot_squared * sin_phi_1 + phi_2_dot_squared * sin_phi_2);
        let w_15 = sin_phi_3 * w_7 + minus_P2_x_convective;
        let w_16 = sin_phi_4 * w_10 + w_15;
        let w_17 = sin_phi_5 * w_9 + self.m * w_16;
        let w_18 = sin_phi_4 * w_6 + self.m * w_15 + w_17;
        let w_19 = sin_phi_3 * w_5 + self.m * minus_P2_x_convective + w_18;
        [
            w_2 * phi_2_dot_squared * w_3 + w_14 * self.l * sin_phi_1
                - w_19 * self.l * cos_phi_1,
            w_14 * self.l * sin_phi_2 - phi_1_dot_squared * w_2 * w_3
                - w_19 * self.l * cos_phi_2,
            P2_y_convective * w_4 * sin_phi_3 - minus_P2_x_convective * w_4 * cos_phi_3
                + w_13 * self.l * sin_phi_3 - w_18 * self.l * cos_phi_3,
            w_8 * w_4 * sin_phi_4 - w_15 * w_4 * cos_phi_4 + w_12 * self.l * sin_phi_4
                - w_17 * self.l * cos_phi_4,
            w_11 * w_4 * sin_phi_5 - w_16 * w_4 * cos_phi_5,
        ]
    }
    /// Generalised forces `T_q' F`, 5: joules per unit of each coordinate.
    ///
    /// Operations: 11 additions, 18 multiplications, 5 sine-cosine pairs.
    #[inline]
    pub fn generalized_forces(&self, t: S, q: &[S; 5], qd: &[S; 5]) -> [S; 5] {
        let [phi_1, phi_2, phi_3, phi_4, phi_5] = *q;
        let ([sin_phi_1, sin_phi_2, sin_phi_3, sin_phi_4, sin_phi_5], [_, _, _, _, _]) = S::sin_cos_each([
            phi_1,
            phi_2,
            phi_3,
            phi_4,
            phi_5,
        ]);
        let w = self.m * self.g;
        let w_2 = w + w;
        let w_3 = w + w_2;
        let w_4 = self.l * w * S::from_f64(0.5);
        [
            -(sin_phi_1 * S::from_f64(1.5) * self.l * w + w_3 * self.l * sin_phi_1),
            -(sin_phi_2 * w_4 + w_3 * self.l * sin_phi_2),
            -(w_4 * sin_phi_3 + w_2 * self.l * sin_phi_3),
            -(w_4 * sin_phi_4 + w * self.l * sin_phi_4),
            -(w_4 * sin_phi_5),
        ]
    }
    /// Constraints `C`, 0, in SI units; zero throughout the motion.
    ///
    /// Operations: none.
    #[inline]
    pub fn constraints(&self, t: S, q: &[S; 5]) -> [S; 0] {
        []
    }
    /// The sum of the magnitudes of the terms of `C`, 0, in SI units: what its rounding is relative to.
    ///
    /// Operations: none.
    #[inline]
    pub fn constraint_magnitudes(&self, t: S, q: &[S; 5]) -> [S; 0] {
        []
    }
    /// Constraint Jacobian `C_q`, 0 x 5: units of each constraint per unit of each coordinate.
    ///
    /// Operations: none.
    #[inline]
    pub fn constraint_jacobian(&self, t: S, q: &[S; 5]) -> [[S; 5]; 0] {
        []
    }
    /// `C_t`, 0, units of `C` per second: the speeds obey `C_q q' + C_t = 0`.
    ///
    /// Operations: none.
    #[inline]
    pub fn constraint_time_derivative(&self, t: S, q: &[S; 5]) -> [S; 0] {
        []
    }
    /// `(C_q q' + C_t)_q q' + (..)_t`, 0, units of `C` per second squared: the part of `C''` without accelerations.
    ///
    /// Operations: none.
    #[inline]
    pub fn constraint_convective(&self, t: S, q: &[S; 5], qd: &[S; 5]) -> [S; 0] {
        []
    }
    /// `C` (0), `C_q` (0 x 5) and `C_t` (0) together, in SI units, for projection.
    ///
    /// Operations: none.
    #[inline]
    pub fn constraint_linearization(
        &self,
        t: S,
        q: &[S; 5],
    ) -> sim_kernel::ConstraintLinearization<[S; 0], [[S; 5]; 0]> {
        sim_kernel::ConstraintLinearization {
            values: [],
            jacobian: [],
            time_derivative: [],
        }
    }
    /// Kinetic energy `v' M v / 2`, in joules.
    ///
    /// Operations: 26 additions, 50 multiplications, 5 sine-cosine pairs.
    #[inline]
    pub fn kinetic_energy(&self, t: S, q: &[S; 5], qd: &[S; 5]) -> S {
        let [phi_1, phi_2, phi_3, phi_4, phi_5] = *q;
        let [phi_1_dot, phi_2_dot, phi_3_dot, phi_4_dot, phi_5_dot] = *qd;
        let (
            [sin_phi_1,
            sin_phi_2,
            sin_phi_3,
            sin_phi_4,
            sin_phi_5,
            ],
            [cos_phi_1,
            cos_phi_2,
            cos_phi_3,
            cos_phi_4,
            cos_phi_5,
            ],
        ) = S::sin_cos_each([phi_1, phi_2, phi_3, phi_4, phi_5]);
        let w = phi_1_dot * self.l * S::from_f64(2.0);
        let w_2 = self.l * phi_2_dot;
        let w_3 = cos_phi_1 * w + cos_phi_2 * w_2;
        let w_4 = w * sin_phi_1 + w_2 * sin_phi_2;
        let P2_x_dot = self.l * (phi_1_dot * cos_phi_1 + phi_2_dot * cos_phi_2);
        let w_5 = self.l * phi_3_dot;
        let w_6 = cos_phi_3 * w_5;
        let w_8 = w_5 * sin_phi_3;
        let w_7 = S::from_f64(2.0) * P2_x_dot + w_6;
        let P3_x_dot = P2_x_dot + w_6;
        let P2_y_dot = self.l * (phi_1_dot * sin_phi_1 + phi_2_dot * sin_phi_2);
        let w_9 = S::from_f64(2.0) * P2_y_dot + w_8;
        let P3_y_dot = P2_y_dot + w_8;
        let w_10 = self.l * phi_4_dot;
        let w_11 = cos_phi_4 * w_10;
        let w_13 = w_10 * sin_phi_4;
        let w_12 = S::from_f64(2.0) * P3_x_dot + w_11;
        let w_14 = S::from_f64(2.0) * P3_y_dot + w_13;
        let w_15 = self.l * phi_5_dot;
        let w_16 = S::from_f64(2.0) * (P3_x_dot + w_11) + cos_phi_5 * w_15;
        let w_17 = S::from_f64(2.0) * (P3_y_dot + w_13) + w_15 * sin_phi_5;
        let w_18 = w_3 * w_3 + w_4 * w_4 + w_7 * w_7 + w_9 * w_9 + w_12 * w_12
            + w_14 * w_14 + w_16 * w_16 + w_17 * w_17;
        let l_squared = self.l * self.l;
        let w_19 = self.m * l_squared * S::from_f64(0.041666666666666664)
            * (phi_2_dot * phi_2_dot + phi_3_dot * phi_3_dot + phi_4_dot * phi_4_dot
                + phi_5_dot * phi_5_dot);
        self.m * S::from_f64(0.125) * w_18 + w_19
            + phi_1_dot * phi_1_dot * S::from_f64(0.16666666666666666) * self.m
                * l_squared
    }
    /// Power of loads and drives, `F' v + lambda' C_t + T_t' (M x'' - F)`, in watts.
    ///
    /// Operations: 11 additions, 19 multiplications, 5 sine-cosine pairs.
    #[inline]
    pub fn power(
        &self,
        t: S,
        q: &[S; 5],
        qd: &[S; 5],
        qdd: &[S; 5],
        lambda: &[S; 0],
    ) -> S {
        let [phi_1, phi_2, phi_3, phi_4, phi_5] = *q;
        let [phi_1_dot, phi_2_dot, phi_3_dot, phi_4_dot, phi_5_dot] = *qd;
        let w = self.m * self.g;
        let ([sin_phi_1, sin_phi_2, sin_phi_3, sin_phi_4, sin_phi_5], [_, _, _, _, _]) = S::sin_cos_each([
            phi_1,
            phi_2,
            phi_3,
            phi_4,
            phi_5,
        ]);
        let w_2 = phi_2_dot * sin_phi_2;
        let w_3 = S::from_f64(0.5) * self.l * w
            * (w_2 + phi_3_dot * sin_phi_3 + phi_4_dot * sin_phi_4
                + phi_5_dot * sin_phi_5);
        let P2_y_dot = self.l * (phi_1_dot * sin_phi_1 + w_2);
        let P3_y_dot = P2_y_dot + self.l * phi_3_dot * sin_phi_3;
        -(w_3 + w * (P2_y_dot + P3_y_dot + (P3_y_dot + self.l * phi_4_dot * sin_phi_4))
            + phi_1_dot * sin_phi_1 * self.l * w * S::from_f64(1.5))
    }
    /// Outputs, 2, in SI units.
    ///
    /// Operations: 9 additions, 2 multiplications, 5 sine-cosine pairs.
    #[inline]
    pub fn outputs(
        &self,
        t: S,
        q: &[S; 5],
        qd: &[S; 5],
        qdd: &[S; 5],
        lambda: &[S; 0],
    ) -> ChainOutputs<S> {
        let [phi_1, phi_2, phi_3, phi_4, phi_5] = *q;
        let (
            [sin_phi_1,
            sin_phi_2,
            sin_phi_3,
            sin_phi_4,
            sin_phi_5,
            ],
            [cos_phi_1,
            cos_phi_2,
            cos_phi_3,
            cos_phi_4,
            cos_phi_5,
            ],
        ) = S::sin_cos_each([phi_1, phi_2, phi_3, phi_4, phi_5]);
        [
            self.l * (sin_phi_1 + sin_phi_2 + sin_phi_3 + sin_phi_4 + sin_phi_5),
            -(self.l * (cos_phi_1 + cos_phi_2 + cos_phi_3 + cos_phi_4 + cos_phi_5)),
        ]
            .into()
    }
    /// Rates of the outputs that depend on neither accelerations nor multipliers, 2, in SI units per second.
    ///
    /// Operations: 8 additions, 12 multiplications, 5 sine-cosine pairs.
    #[inline]
    pub fn output_rates(
        &self,
        t: S,
        q: &[S; 5],
        qd: &[S; 5],
        qdd: &[S; 5],
    ) -> ChainOutputRates<S> {
        let [phi_1, phi_2, phi_3, phi_4, phi_5] = *q;
        let [phi_1_dot, phi_2_dot, phi_3_dot, phi_4_dot, phi_5_dot] = *qd;
        let (
            [sin_phi_1,
            sin_phi_2,
            sin_phi_3,
            sin_phi_4,
            sin_phi_5,
            ],
            [cos_phi_1,
            cos_phi_2,
            cos_phi_3,
            cos_phi_4,
            cos_phi_5,
            ],
        ) = S::sin_cos_each([phi_1, phi_2, phi_3, phi_4, phi_5]);
        [
            self.l
                * (phi_1_dot * cos_phi_1 + phi_2_dot * cos_phi_2 + phi_3_dot * cos_phi_3
                    + phi_4_dot * cos_phi_4 + phi_5_dot * cos_phi_5),
            self.l
                * (phi_1_dot * sin_phi_1 + phi_2_dot * sin_phi_2 + phi_3_dot * sin_phi_3
                    + phi_4_dot * sin_phi_4 + phi_5_dot * sin_phi_5),
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
        q: &[S; 5],
        qd: &[S; 5],
        qdd: &[S; 5],
        lambda: &[S; 0],
    ) -> [S; 0] {
        []
    }
    /// The numbers of each shape of the drawing, in metres and radians.
    ///
    /// Operations: 13 additions, 10 multiplications, 5 sine-cosine pairs.
    #[inline]
    pub fn drawing(&self, t: S, q: &[S; 5]) -> [S; 14] {
        let [phi_1, phi_2, phi_3, phi_4, phi_5] = *q;
        let (
            [sin_phi_1,
            sin_phi_2,
            sin_phi_3,
            sin_phi_4,
            sin_phi_5,
            ],
            [cos_phi_1,
            cos_phi_2,
            cos_phi_3,
            cos_phi_4,
            cos_phi_5,
            ],
        ) = S::sin_cos_each([phi_1, phi_2, phi_3, phi_4, phi_5]);
        let w = sin_phi_1 + sin_phi_2;
        let w_2 = cos_phi_1 + cos_phi_2;
        let w_3 = w + sin_phi_3;
        let w_4 = w_2 + cos_phi_3;
        let w_5 = w_3 + sin_phi_4;
        let w_6 = w_4 + cos_phi_4;
        [
            S::from_f64(0.0),
            S::from_f64(0.0),
            S::from_f64(0.0),
            S::from_f64(0.0),
            self.l * sin_phi_1,
            -(self.l * cos_phi_1),
            self.l * w,
            -(self.l * w_2),
            self.l * w_3,
            -(self.l * w_4),
            self.l * w_5,
            -(self.l * w_6),
            self.l * (w_5 + sin_phi_5),
            -(self.l * (w_6 + cos_phi_5)),
        ]
    }
    /// Declared start: values or guesses of the coordinates (5), and speeds (5), in SI units; 0 where nothing is declared.
    ///
    /// Operations: none.
    #[inline]
    pub fn initial(&self) -> sim_kernel::Initial<[S; 5]> {
        sim_kernel::Initial {
            positions: [
                S::from_f64(1.0),
                S::from_f64(1.0),
                S::from_f64(1.0),
                S::from_f64(1.0),
                S::from_f64(1.0),
            ],
            speeds: [
                S::from_f64(0.0),
                S::from_f64(0.0),
                S::from_f64(0.0),
                S::from_f64(0.0),
                S::from_f64(0.0),
            ],
        }
    }
    /// [`ChainPrepared::dynamics`] once; for many calls with the same parameters [`Self::prepare`] first.
    #[inline]
    pub fn dynamics(
        &self,
        t: S,
        q: &[S; 5],
        qd: &[S; 5],
    ) -> sim_kernel::Dynamics<S, [S; 5], [S; 0]> {
        self.prepare().dynamics(t, q, qd)
    }
}
#[allow(non_snake_case, unused_variables, unused_parens, clippy::all, clippy::pedantic)]
impl<S: sim_kernel::Scalar> ChainPrepared<S> {
    /// Accelerations (5), multipliers (0) and power, from
    ///
    /// ```text
    /// [ T_q' M T_q   C_q' ] [ q''    ]   [ T_q' (F - M g)                      ]
    /// [ C_q          0    ] [ lambda ] = [ -(C_q q' + C_t)_q q' - (..)_t       ]
    /// ```
    ///
    /// by an elimination planned from the structure of the system. Where `refused` is set a pivot was too small and nothing else holds: solve that state from the other kernels.
    ///
    /// Operations: 136 additions, 157 multiplications, 4 divisions, 5 sine-cosine pairs.
    #[inline(always)]
    pub fn dynamics(
        &self,
        t: S,
        q: &[S; 5],
        qd: &[S; 5],
    ) -> sim_kernel::Dynamics<S, [S; 5], [S; 0]> {
        let [phi_1, phi_2, phi_3, phi_4, phi_5] = *q;
        let [phi_1_dot, phi_2_dot, phi_3_dot, phi_4_dot, phi_5_dot] = *qd;
        let (
            [sin_phi_1,
            sin_phi_2,
            sin_phi_3,
            sin_phi_4,
            sin_phi_5,
            ],
            [cos_phi_1,
            cos_phi_2,
            cos_phi_3,
            cos_phi_4,
            cos_phi_5,
            ],
        ) = S::sin_cos_each([phi_1, phi_2, phi_3, phi_4, phi_5]);
        let u4_x = self.l * sin_phi_4;
        let minus_rhs_phi_5 = sin_phi_5 * self.k_4;
        let mass_P4_y_phi_5 = self.k_2 * sin_phi_5;
        let l_P4_y_phi_5 = mass_P4_y_phi_5 * self.inverse_phi_5;
        let mass_P4_x_phi_5 = self.k_2 * cos_phi_5;
        let phi_5_dot_squared = phi_5_dot * phi_5_dot;
        let w = self.l * cos_phi_4;
        let phi_4_dot_squared = phi_4_dot * phi_4_dot;
        let P4_y_convective = w * phi_4_dot_squared;
        let w_2 = self.m - mass_P4_y_phi_5 * l_P4_y_phi_5;
        let w_3 = minus_rhs_phi_5 * l_P4_y_phi_5
            - (self.k_5 + mass_P4_x_phi_5 * phi_5_dot_squared) - P4_y_convective * w_2;
        let minus_P4_x_convective = u4_x * phi_4_dot_squared;
        let w_4 = mass_P4_x_phi_5 * l_P4_y_phi_5;
        let w_5 = u4_x * w_4;
        let l_P4_x_phi_5 = mass_P4_x_phi_5 * self.inverse_phi_5;
        let w_6 = self.m - mass_P4_x_phi_5 * l_P4_x_phi_5;
        let w_7 = mass_P4_y_phi_5 * phi_5_dot_squared + minus_rhs_phi_5 * l_P4_x_phi_5
            + P4_y_convective * w_4 + minus_P4_x_convective * w_6;
        let rhs_phi_4 = u4_x * w_3 - sin_phi_4 * self.k_4 - minus_P4_x_convective * w_5
            + w * w_7;
        let u3_x = self.l * sin_phi_3;
        let mass_P3_x_phi_4 = self.k_2 * cos_phi_4;
        let w_8 = u4_x * w_2;
        let w_9 = u4_x * w_8;
        let w_10 = w * w_5;
        let w_11 = w * w_6;
        let k_P3_x_phi_4 = mass_P3_x_phi_4 - w_5 + w_11;
        let w_12 = w * w_11;
        let pivot_phi_4 = self.mass_phi_2_phi_2 + w_9 - w_10 - w_10 + w_12;
        let abs_w_10 = w_10.abs();
        let inverse_phi_4 = S::from_f64(1.0) / pivot_phi_4;
        let mass_P3_y_phi_4 = self.k_2 * sin_phi_4;
        let k_P3_y_phi_4 = mass_P3_y_phi_4 + w_8 - w * w_4;
        let l_P3_y_phi_4 = inverse_phi_4 * k_P3_y_phi_4;
        let w_14 = self.m + w_2 - k_P3_y_phi_4 * l_P3_y_phi_4;
        let w_13 = self.l * cos_phi_3;
        let phi_3_dot_squared = phi_3_dot * phi_3_dot;
        let P3_y_convective = w_13 * phi_3_dot_squared;
        let w_15 = w_3 - (self.k_5 + mass_P3_x_phi_4 * phi_4_dot_squared)
            - minus_P4_x_convective * w_4 - l_P3_y_phi_4 * rhs_phi_4
            - P3_y_convective * w_14;
        let w_16 = w_4 + k_P3_x_phi_4 * l_P3_y_phi_4;
        let minus_P3_x_convective = u3_x * phi_3_dot_squared;
        let w_17 = u3_x * w_16;
        let l_P3_x_phi_4 = inverse_phi_4 * k_P3_x_phi_4;
        let w_18 = self.m + w_6 - k_P3_x_phi_4 * l_P3_x_phi_4;
        let w_19 = mass_P3_y_phi_4 * phi_4_dot_squared + w_7 - l_P3_x_phi_4 * rhs_phi_4
            + P3_y_convective * w_16 + minus_P3_x_convective * w_18;
        let rhs_phi_3 = u3_x * w_15 - sin_phi_3 * self.k_4 - minus_P3_x_convective * w_17
            + w_13 * w_19;
        let w_20 = cos_phi_1 * self.k;
        let phi_2_dot_squared = phi_2_dot * phi_2_dot;
        let w_21 = sin_phi_2 * phi_2_dot_squared;
        let w_22 = cos_phi_2 * self.k;
        let u1_x = self.l * sin_phi_1;
        let mass_P2_x_phi_3 = cos_phi_3 * self.k_2;
        let w_23 = u3_x * w_14;
        let w_24 = u3_x * w_23;
        let w_25 = w_13 * w_17;
        let w_26 = w_13 * w_18;
        let k_P2_x_phi_3 = mass_P2_x_phi_3 - w_17 + w_26;
        let w_27 = w_13 * w_26;
        let pivot_phi_3 = self.mass_phi_2_phi_2 + w_24 - w_25 - w_25 + w_27;
        let abs_w_25 = w_25.abs();
        let inverse_phi_3 = S::from_f64(1.0) / pivot_phi_3;
        let mass_P2_y_phi_3 = self.k_2 * sin_phi_3;
        let k_P2_y_phi_3 = mass_P2_y_phi_3 + w_23 - w_13 * w_16;
        let l_P2_y_phi_3 = inverse_phi_3 * k_P2_y_phi_3;
        let w_28 = self.m + w_14 - k_P2_y_phi_3 * l_P2_y_phi_3;
        let phi_1_dot_squared = phi_1_dot * phi_1_dot;
        let P2_y_convective = self.l
            * (cos_phi_1 * phi_1_dot_squared + cos_phi_2 * phi_2_dot_squared);
        let w_29 = w_15 - (self.k_5 + mass_P2_x_phi_3 * phi_3_dot_squared)
            - minus_P3_x_convective * w_16 - l_P2_y_phi_3 * rhs_phi_3
            - P2_y_convective * w_28;
        let w_31 = w_16 + k_P2_x_phi_3 * l_P2_y_phi_3;
        let w_30 = sin_phi_1 * phi_1_dot_squared;
        let minus_P2_x_convective = self.l * (w_30 + w_21);
        let w_32 = u1_x * w_31;
        let w_33 = self.l * cos_phi_1;
        let l_P2_x_phi_3 = inverse_phi_3 * k_P2_x_phi_3;
        let w_34 = self.m + w_18 - k_P2_x_phi_3 * l_P2_x_phi_3;
        let w_35 = mass_P2_y_phi_3 * phi_3_dot_squared + w_19 - l_P2_x_phi_3 * rhs_phi_3
            + P2_y_convective * w_31 + minus_P2_x_convective * w_34;
        let rhs_phi_1 = w_20 * w_21 - sin_phi_1 * (self.k_3 + phi_2_dot_squared * w_22)
            + u1_x * w_29 - minus_P2_x_convective * w_32 + w_33 * w_35;
        let u2_x = self.l * sin_phi_2;
        let w_36 = u2_x * w_31;
        let w_37 = self.l * cos_phi_2;
        let w_38 = u1_x * u1_x * w_28;
        let w_41 = u2_x * w_28;
        let w_39 = w_33 * w_32;
        let w_40 = w_33 * w_33 * w_34;
        let w_42 = w_37 * w_34;
        let k_phi_2_phi_1 = self.k * (cos_phi_1 * cos_phi_2 + sin_phi_1 * sin_phi_2)
            + u1_x * w_41 - w_37 * w_32 - w_33 * w_36 + w_33 * w_42;
        let w_43 = u2_x * w_41;
        let w_45 = w_37 * w_42;
        let pivot_phi_1 = self.mass_phi_1_phi_1 + w_38 - w_39 - w_39 + w_40;
        let abs_w_39 = w_39.abs();
        let inverse_phi_1 = S::from_f64(1.0) / pivot_phi_1;
        let l_phi_2_phi_1 = inverse_phi_1 * k_phi_2_phi_1;
        let w_44 = w_37 * w_36;
        let pivot_phi_2 = self.mass_phi_2_phi_2 + w_43 - w_44 - w_44 + w_45
            - k_phi_2_phi_1 * l_phi_2_phi_1;
        let phi_2_ddot = S::from_f64(1.0) / pivot_phi_2
            * (w_22 * w_30 - sin_phi_2 * (self.k_4 + phi_1_dot_squared * w_20)
                + u2_x * w_29 - minus_P2_x_convective * w_36 + w_37 * w_35
                - l_phi_2_phi_1 * rhs_phi_1);
        let phi_1_ddot = inverse_phi_1 * rhs_phi_1 - l_phi_2_phi_1 * phi_2_ddot;
        let P2_x_ddot = w_33 * phi_1_ddot - minus_P2_x_convective + w_37 * phi_2_ddot;
        let P2_y_ddot = P2_y_convective + u1_x * phi_1_ddot + u2_x * phi_2_ddot;
        let phi_3_ddot = inverse_phi_3 * rhs_phi_3 - l_P2_x_phi_3 * P2_x_ddot
            - l_P2_y_phi_3 * P2_y_ddot;
        let P3_x_ddot = w_13 * phi_3_ddot - minus_P3_x_convective + P2_x_ddot;
        let P3_y_ddot = P3_y_convective + u3_x * phi_3_ddot + P2_y_ddot;
        let phi_4_ddot = inverse_phi_4 * rhs_phi_4 - l_P3_x_phi_4 * P3_x_ddot
            - l_P3_y_phi_4 * P3_y_ddot;
        let abs_w_44 = w_44.abs();
        let w_46 = sin_phi_2 * phi_2_dot;
        let w_47 = sin_phi_1 * phi_1_dot;
        let P2_y_dot = self.l * (w_47 + w_46);
        let P3_y_dot = P2_y_dot + u3_x * phi_3_dot;
        let w_48 = self.k_4
            * (w_46 + sin_phi_3 * phi_3_dot + sin_phi_4 * phi_4_dot
                + sin_phi_5 * phi_5_dot)
            + self.k_5 * (P2_y_dot + P3_y_dot + (P3_y_dot + u4_x * phi_4_dot))
            + self.k_3 * w_47;
        sim_kernel::Dynamics {
            accelerations: [
                phi_1_ddot,
                phi_2_ddot,
                phi_3_ddot,
                phi_4_ddot,
                -(minus_rhs_phi_5 * self.inverse_phi_5
                    + l_P4_x_phi_5 * (w * phi_4_ddot - minus_P4_x_convective + P3_x_ddot)
                    + l_P4_y_phi_5 * (P4_y_convective + u4_x * phi_4_ddot + P3_y_ddot)),
            ],
            multipliers: [],
            power: -w_48,
            refused: sim_kernel::pivot_is_refused(
                self.mass_phi_2_phi_2,
                self.mass_phi_2_phi_2,
            )
                | sim_kernel::pivot_is_refused(
                    pivot_phi_4,
                    self.mass_phi_2_phi_2 + w_9 + abs_w_10 + abs_w_10 + w_12,
                )
                | sim_kernel::pivot_is_refused(
                    pivot_phi_3,
                    self.mass_phi_2_phi_2 + w_24 + abs_w_25 + abs_w_25 + w_27,
                )
                | sim_kernel::pivot_is_refused(
                    pivot_phi_1,
                    self.mass_phi_1_phi_1 + w_38 + abs_w_39 + abs_w_39 + w_40,
                )
                | sim_kernel::pivot_is_refused(
                    pivot_phi_2,
                    self.mass_phi_2_phi_2 + w_43 + abs_w_44 + abs_w_44 + w_45,
                ),
        }
    }
}
#[allow(non_snake_case, clippy::all, clippy::pedantic)]
impl<S: sim_kernel::Scalar> sim_kernel::Mechanism<S> for Chain<S> {
    type Q = [S; 5];
    type L = [S; 0];
    type Z = [S; 5];
    type QQ = [[S; 5]; 5];
    type LQ = [[S; 5]; 0];
    type LL = [[S; 0]; 0];
    type ZZ = [[S; 5]; 5];
    type Entries = [S; 0];
    type Envelope = [S; 0];
    type Parameters = [S; 3];
    type Outputs = [S; 2];
    type OutputRates = [S; 2];
    type Events = [S; 0];
    type EventValues = [S; 0];
    type Activities = [S; 0];
    type Drawing = [S; 14];
    type QP = [[S; 3]; 5];
    type LP = [[S; 3]; 0];
    type Inputs = [sim_kernel::Input<S>; 0];
    type Prepared = ChainPrepared<S>;
    type On<T: sim_kernel::Scalar> = Chain<T>;
    const DESCRIPTION: sim_kernel::Description = sim_kernel::Description {
        name: "chain",
        type_name: "Chain",
        docs: "Five uniform rods, each hanging on the one before, by their angles from the vertical.",
        declaration: "/// Five uniform rods, each hanging on the one before, by their angles from the vertical.\npub Chain;\n\ncoordinates { phi_1 [rad]; phi_2 [rad]; phi_3 [rad]; phi_4 [rad]; phi_5 [rad]; }\n\nparameters {\n    /// Mass of a rod.\n    m [kg] = 1;\n    /// Length of a rod.\n    l [m] = 0.5;\n    /// Acceleration of free fall.\n    g [m/s^2] = 9.81;\n}\n\nlet J = m*l^2/12;\nlet u1 = l*[sin(phi_1), -cos(phi_1)];\nlet u2 = l*[sin(phi_2), -cos(phi_2)];\nlet u3 = l*[sin(phi_3), -cos(phi_3)];\nlet u4 = l*[sin(phi_4), -cos(phi_4)];\nlet u5 = l*[sin(phi_5), -cos(phi_5)];\nlet P1 = u1;\nlet P2 = P1 + u2;\nlet P3 = P2 + u3;\nlet P4 = P3 + u4;\nlet P5 = P4 + u5;\n\nbodies {\n    rod1: mass m at u1/2, inertia J, angle phi_1;\n    rod2: mass m at P1 + u2/2, inertia J, angle phi_2;\n    rod3: mass m at P2 + u3/2, inertia J, angle phi_3;\n    rod4: mass m at P3 + u4/2, inertia J, angle phi_4;\n    rod5: mass m at P4 + u5/2, inertia J, angle phi_5;\n}\n\nloads { gravity [0, -g]; }\ninitial { phi_1 = 1; phi_2 = 1; phi_3 = 1; phi_4 = 1; phi_5 = 1; }\noutputs {\n    /// End of the chain.\n    tip_x [m] = P5.x;\n    tip_y [m] = P5.y;\n}\ndrawing { ground [0, 0]; line [0, 0], P1, P2, P3, P4, P5; }\n",
        coordinates: &[
            sim_kernel::Coordinate {
                position: sim_kernel::Quantity {
                    name: "phi_1",
                    unit: "rad",
                    factor: 1f64,
                    is_length: false,
                    docs: "",
                },
                speed: sim_kernel::Quantity {
                    name: "phi_1_dot",
                    unit: "rad/s",
                    factor: 1f64,
                    is_length: false,
                    docs: "",
                },
                acceleration: sim_kernel::Quantity {
                    name: "phi_1_ddot",
                    unit: "rad/s^2",
                    factor: 1f64,
                    is_length: false,
                    docs: "",
                },
                start: sim_kernel::Start::Given,
                speed_given: false,
            },
            sim_kernel::Coordinate {
                position: sim_kernel::Quantity {
                    name: "phi_2",
                    unit: "rad",
                    factor: 1f64,
                    is_length: false,
                    docs: "",
                },
                speed: sim_kernel::Quantity {
                    name: "phi_2_dot",
                    unit: "rad/s",
                    factor: 1f64,
                    is_length: false,
                    docs: "",
                },
                acceleration: sim_kernel::Quantity {
                    name: "phi_2_ddot",
                    unit: "rad/s^2",
                    factor: 1f64,
                    is_length: false,
                    docs: "",
                },
                start: sim_kernel::Start::Given,
                speed_given: false,
            },
            sim_kernel::Coordinate {
                position: sim_kernel::Quantity {
                    name: "phi_3",
                    unit: "rad",
                    factor: 1f64,
                    is_length: false,
                    docs: "",
                },
                speed: sim_kernel::Quantity {
                    name: "phi_3_dot",
                    unit: "rad/s",
                    factor: 1f64,
                    is_length: false,
                    docs: "",
                },
                acceleration: sim_kernel::Quantity {
                    name: "phi_3_ddot",
                    unit: "rad/s^2",
                    factor: 1f64,
                    is_length: false,
                    docs: "",
                },
                start: sim_kernel::Start::Given,
                speed_given: false,
            },
            sim_kernel::Coordinate {
                position: sim_kernel::Quantity {
                    name: "phi_4",
                    unit: "rad",
                    factor: 1f64,
                    is_length: false,
                    docs: "",
                },
                speed: sim_kernel::Quantity {
                    name: "phi_4_dot",
                    unit: "rad/s",
                    factor: 1f64,
                    is_length: false,
                    docs: "",
                },
                acceleration: sim_kernel::Quantity {
                    name: "phi_4_ddot",
                    unit: "rad/s^2",
                    factor: 1f64,
                    is_length: false,
                    docs: "",
                },
                start: sim_kernel::Start::Given,
                speed_given: false,
            },
            sim_kernel::Coordinate {
                position: sim_kernel::Quantity {
                    name: "phi_5",
                    unit: "rad",
                    factor: 1f64,
                    is_length: false,
                    docs: "",
                },
                speed: sim_kernel::Quantity {
                    name: "phi_5_dot",
                    unit: "rad/s",
                    factor: 1f64,
                    is_length: false,
                    docs: "",
                },
                acceleration: sim_kernel::Quantity {
                    name: "phi_5_ddot",
                    unit: "rad/s^2",
                    factor: 1f64,
                    is_length: false,
                    docs: "",
                },
                start: sim_kernel::Start::Given,
                speed_given: false,
            },
        ],
        parameters: &[
            sim_kernel::Quantity {
                name: "m",
                unit: "kg",
                factor: 1f64,
                is_length: false,
                docs: "Mass of a rod.",
            },
            sim_kernel::Quantity {
                name: "l",
                unit: "m",
                factor: 1f64,
                is_length: true,
                docs: "Length of a rod.",
            },
            sim_kernel::Quantity {
                name: "g",
                unit: "m/s^2",
                factor: 1f64,
                is_length: false,
                docs: "Acceleration of free fall.",
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
                name: "tip_x",
                unit: "m",
                factor: 1f64,
                is_length: true,
                docs: "End of the chain.",
            },
            sim_kernel::Quantity {
                name: "tip_y",
                unit: "m",
                factor: 1f64,
                is_length: true,
                docs: "",
            },
        ],
        rated_outputs: &[0, 1],
        figures: &[
            sim_kernel::Figure {
                name: "tip_x",
                title: "End of the chain",
                len: 1,
            },
            sim_kernel::Figure {
                name: "tip_y",
                title: "tip y",
                len: 1,
            },
        ],
        optional_kernels: &[],
        dimension: 2,
        drawing: &[sim_kernel::Shape::Ground(1), sim_kernel::Shape::Line(6)],
    };
    fn defaults() -> Self {
        Self {
            m: S::from_f64(1f64),
            l: S::from_f64(0.5f64),
            g: S::from_f64(9.81f64),
        }
    }
    fn parameters(&self) -> [S; 3] {
        [self.m, self.l, self.g]
    }
    fn with_parameters(&self, parameters: [S; 3]) -> Self {
        Self {
            m: parameters[0],
            l: parameters[1],
            g: parameters[2],
            ..*self
        }
    }
    fn on<T: sim_kernel::Scalar>(
        &self,
        convert: impl ::core::ops::Fn(S) -> T,
    ) -> Chain<T> {
        Chain {
            m: convert(self.m),
            l: convert(self.l),
            g: convert(self.g),
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
    fn prepare(&self) -> ChainPrepared<S> {
        self.prepare()
    }
    #[inline(always)]
    fn prepared_dynamics(
        prepared: &Self::Prepared,
        t: S,
        q: &[S; 5],
        qd: &[S; 5],
    ) -> sim_kernel::Dynamics<S, [S; 5], [S; 0]> {
        prepared.dynamics(t, q, qd)
    }
    #[inline(always)]
    fn mass_matrix(&self, t: S, q: &[S; 5]) -> [[S; 5]; 5] {
        self.mass_matrix(t, q)
    }
    #[inline(always)]
    fn convective_forces(&self, t: S, q: &[S; 5], qd: &[S; 5]) -> [S; 5] {
        self.convective_forces(t, q, qd)
    }
    #[inline(always)]
    fn generalized_forces(&self, t: S, q: &[S; 5], qd: &[S; 5]) -> [S; 5] {
        self.generalized_forces(t, q, qd)
    }
    #[inline(always)]
    fn constraints(&self, t: S, q: &[S; 5]) -> [S; 0] {
        self.constraints(t, q)
    }
    #[inline(always)]
    fn constraint_magnitudes(&self, t: S, q: &[S; 5]) -> [S; 0] {
        self.constraint_magnitudes(t, q)
    }
    #[inline(always)]
    fn constraint_jacobian(&self, t: S, q: &[S; 5]) -> [[S; 5]; 0] {
        self.constraint_jacobian(t, q)
    }
    #[inline(always)]
    fn constraint_time_derivative(&self, t: S, q: &[S; 5]) -> [S; 0] {
        self.constraint_time_derivative(t, q)
    }
    #[inline(always)]
    fn constraint_convective(&self, t: S, q: &[S; 5], qd: &[S; 5]) -> [S; 0] {
        self.constraint_convective(t, q, qd)
    }
    #[inline(always)]
    fn constraint_linearization(
        &self,
        t: S,
        q: &[S; 5],
    ) -> sim_kernel::ConstraintLinearization<[S; 0], [[S; 5]; 0]> {
        self.constraint_linearization(t, q)
    }
    #[inline(always)]
    fn kinetic_energy(&self, t: S, q: &[S; 5], qd: &[S; 5]) -> S {
        self.kinetic_energy(t, q, qd)
    }
    #[inline(always)]
    fn power(&self, t: S, q: &[S; 5], qd: &[S; 5], qdd: &[S; 5], lambda: &[S; 0]) -> S {
        self.power(t, q, qd, qdd, lambda)
    }
    #[inline(always)]
    fn outputs(
        &self,
        t: S,
        q: &[S; 5],
        qd: &[S; 5],
        qdd: &[S; 5],
        lambda: &[S; 0],
    ) -> [S; 2] {
        self.outputs(t, q, qd, qdd, lambda).into()
    }
    #[inline(always)]
    fn output_rates(&self, t: S, q: &[S; 5], qd: &[S; 5], qdd: &[S; 5]) -> [S; 2] {
        self.output_rates(t, q, qd, qdd).into()
    }
    #[inline(always)]
    fn events(
        &self,
        t: S,
        q: &[S; 5],
        qd: &[S; 5],
        qdd: &[S; 5],
        lambda: &[S; 0],
    ) -> [S; 0] {
        self.events(t, q, qd, qdd, lambda)
    }
    #[inline(always)]
    fn drawing(&self, t: S, q: &[S; 5]) -> [S; 14] {
        self.drawing(t, q)
    }
    #[inline(always)]
    fn initial(&self) -> sim_kernel::Initial<[S; 5]> {
        self.initial()
    }
}
