/// A chain of five equal slender rods, let go from the side.
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
pub struct HangingChain<S = ::core::primitive::f64> {
    /// Length of each rod, in `m`.
    pub l: S,
    /// Mass of each rod, in `kg`.
    pub m: S,
    /// Angle of all rods at the start, in `1`.
    pub start: S,
    /// In `m/s^2`.
    pub g: S,
}
impl<S: sim_kernel::Scalar> ::core::default::Default for HangingChain<S> {
    /// The declared values.
    fn default() -> Self {
        <Self as sim_kernel::Mechanism<S>>::defaults()
    }
}
/// Coordinates of [`HangingChain`] by name, in SI units; also for their speeds and accelerations.
#[allow(non_snake_case)]
#[derive(
    ::core::clone::Clone,
    ::core::marker::Copy,
    ::core::fmt::Debug,
    ::core::cmp::PartialEq
)]
pub struct HangingChainCoordinates<S = ::core::primitive::f64> {
    /// Angle of rod 1 from the vertical, in `rad`.
    pub phi_1: S,
    /// Angle of rod 2 from the vertical, in `rad`.
    pub phi_2: S,
    /// Angle of rod 3 from the vertical, in `rad`.
    pub phi_3: S,
    /// Angle of rod 4 from the vertical, in `rad`.
    pub phi_4: S,
    /// Angle of rod 5 from the vertical, in `rad`.
    pub phi_5: S,
}
impl<S: sim_kernel::Scalar> ::core::convert::From<[S; 5]>
for HangingChainCoordinates<S> {
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
impl<S: sim_kernel::Scalar> ::core::convert::From<HangingChainCoordinates<S>>
for [S; 5] {
    fn from(record: HangingChainCoordinates<S>) -> Self {
        [record.phi_1, record.phi_2, record.phi_3, record.phi_4, record.phi_5]
    }
}
/// Outputs of [`HangingChain`] by name, in SI units.
#[allow(non_snake_case)]
#[derive(
    ::core::clone::Clone,
    ::core::marker::Copy,
    ::core::fmt::Debug,
    ::core::cmp::PartialEq
)]
pub struct HangingChainOutputs<S = ::core::primitive::f64> {
    /// rod 1, in `1`.
    pub angle_1: S,
    /// rod 2, in `1`.
    pub angle_2: S,
    /// rod 3, in `1`.
    pub angle_3: S,
    /// rod 4, in `1`.
    pub angle_4: S,
    /// rod 5, in `1`.
    pub angle_5: S,
    /// speed, in `m/s`.
    pub tip_speed: S,
    /// zero at the support, in `J`.
    pub potential: S,
}
impl<S: sim_kernel::Scalar> ::core::convert::From<[S; 7]> for HangingChainOutputs<S> {
    fn from(values: [S; 7]) -> Self {
        Self {
            angle_1: values[0],
            angle_2: values[1],
            angle_3: values[2],
            angle_4: values[3],
            angle_5: values[4],
            tip_speed: values[5],
            potential: values[6],
        }
    }
}
impl<S: sim_kernel::Scalar> ::core::convert::From<HangingChainOutputs<S>> for [S; 7] {
    fn from(record: HangingChainOutputs<S>) -> Self {
        [
            record.angle_1,
            record.angle_2,
            record.angle_3,
            record.angle_4,
            record.angle_5,
            record.tip_speed,
            record.potential,
        ]
    }
}
/// Rates of the outputs of [`HangingChain`] by name, in SI units.
#[allow(non_snake_case)]
#[derive(
    ::core::clone::Clone,
    ::core::marker::Copy,
    ::core::fmt::Debug,
    ::core::cmp::PartialEq
)]
pub struct HangingChainOutputRates<S = ::core::primitive::f64> {
    /// Rate of `angle_1`.
    pub angle_1: S,
    /// Rate of `angle_2`.
    pub angle_2: S,
    /// Rate of `angle_3`.
    pub angle_3: S,
    /// Rate of `angle_4`.
    pub angle_4: S,
    /// Rate of `angle_5`.
    pub angle_5: S,
    /// Rate of `tip_speed`.
    pub tip_speed: S,
    /// Rate of `potential`.
    pub potential: S,
}
impl<S: sim_kernel::Scalar> ::core::convert::From<[S; 7]>
for HangingChainOutputRates<S> {
    fn from(values: [S; 7]) -> Self {
        Self {
            angle_1: values[0],
            angle_2: values[1],
            angle_3: values[2],
            angle_4: values[3],
            angle_5: values[4],
            tip_speed: values[5],
            potential: values[6],
        }
    }
}
impl<S: sim_kernel::Scalar> ::core::convert::From<HangingChainOutputRates<S>>
for [S; 7] {
    fn from(record: HangingChainOutputRates<S>) -> Self {
        [
            record.angle_1,
            record.angle_2,
            record.angle_3,
            record.angle_4,
            record.angle_5,
            record.tip_speed,
            record.potential,
        ]
    }
}
/// What the equations of motion need of the parameters of [`HangingChain`], from [`HangingChain::prepare`]; its methods are the kernels of each step.
#[allow(non_snake_case)]
#[derive(
    ::core::clone::Clone,
    ::core::marker::Copy,
    ::core::fmt::Debug,
    ::core::cmp::PartialEq
)]
pub struct HangingChainPrepared<S = ::core::primitive::f64> {
    l: S,
    m: S,
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
impl<S: sim_kernel::Scalar> HangingChain<S> {
    /// What the equations of motion need of the parameters, computed once for a set of parameters.
    ///
    /// Operations: 14 multiplications, 1 division.
    #[inline]
    pub fn prepare(&self) -> HangingChainPrepared<S> {
        let l_squared = self.l * self.l;
        let mass_phi_2_phi_2 = l_squared * self.m * S::from_f64(0.3333333333333333);
        let w = self.l * self.m;
        HangingChainPrepared {
            l: self.l,
            m: self.m,
            mass_phi_1_phi_1: S::from_f64(1.3333333333333333) * l_squared * self.m,
            k: l_squared * self.m * S::from_f64(0.5),
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
        let w = self.l * self.l * self.m;
        let (
            [u_1_x,
            u_2_x,
            u_3_x,
            u_4_x,
            u_5_x,
            ],
            [cos_phi_1,
            cos_phi_2,
            cos_phi_3,
            cos_phi_4,
            cos_phi_5,
            ],
        ) = S::sin_cos_each([phi_1, phi_2, phi_3, phi_4, phi_5]);
        let P_1_x = self.l * u_1_x;
        let w_2 = self.m * (S::from_f64(1.0) + S::from_f64(1.0));
        let w_3 = self.m + w_2;
        let w_4 = self.l * cos_phi_1;
        let w_5 = self.l * u_2_x;
        let w_6 = w_5 * w_3;
        let w_7 = self.l * cos_phi_2;
        let w_8 = w_7 * w_3;
        let w_9 = w * S::from_f64(0.5) * (cos_phi_1 * cos_phi_2 + u_1_x * u_2_x)
            + P_1_x * w_6 + w_4 * w_8;
        let w_10 = self.l * self.m;
        let w_11 = S::from_f64(0.5) * w_10;
        let w_16 = w_11 + w_10;
        let w_12 = w_11 + self.l * w_2;
        let w_13 = u_3_x * w_12;
        let w_14 = cos_phi_3 * w_12;
        let w_15 = P_1_x * w_13 + w_4 * w_14;
        let w_21 = w_5 * w_13 + w_7 * w_14;
        let w_17 = u_4_x * w_16;
        let w_18 = cos_phi_4 * w_16;
        let w_19 = P_1_x * w_17 + w_4 * w_18;
        let mass_P_4_y_phi_5 = w_11 * u_5_x;
        let mass_P_4_x_phi_5 = w_11 * cos_phi_5;
        let w_20 = mass_P_4_y_phi_5 * P_1_x + mass_P_4_x_phi_5 * w_4;
        let mass_phi_2_phi_2 = w * S::from_f64(0.3333333333333333);
        let w_22 = w_5 * w_17 + w_7 * w_18;
        let w_23 = mass_P_4_y_phi_5 * w_5 + mass_P_4_x_phi_5 * w_7;
        let w_24 = self.l * u_3_x;
        let w_25 = self.l * cos_phi_3;
        let w_26 = w_24 * w_17 + w_25 * w_18;
        let w_27 = mass_P_4_y_phi_5 * w_24 + mass_P_4_x_phi_5 * w_25;
        let w_28 = self.l * u_4_x;
        let w_29 = self.l * cos_phi_4;
        let w_30 = mass_P_4_y_phi_5 * w_28 + mass_P_4_x_phi_5 * w_29;
        [
            [
                S::from_f64(1.3333333333333333) * w + P_1_x * P_1_x * w_3
                    + w_4 * w_4 * w_3,
                w_9,
                w_15,
                w_19,
                w_20,
            ],
            [w_9, mass_phi_2_phi_2 + w_5 * w_6 + w_7 * w_8, w_21, w_22, w_23],
            [
                w_15,
                w_21,
                mass_phi_2_phi_2 + w_24 * w_24 * w_2 + w_25 * w_25 * w_2,
                w_26,
                w_27,
            ],
            [
                w_19,
                w_22,
                w_26,
                mass_phi_2_phi_2 + w_28 * self.m * w_28 + w_29 * self.m * w_29,
                w_30,
            ],
            [w_20, w_23, w_27, w_30, mass_phi_2_phi_2],
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
            [u_1_x,
            u_2_x,
            u_3_x,
            u_4_x,
            u_5_x,
            ],
            [cos_phi_1,
            cos_phi_2,
            cos_phi_3,
            cos_phi_4,
            cos_phi_5,
            ],
        ) = S::sin_cos_each([phi_1, phi_2, phi_3, phi_4, phi_5]);
        let w_3 = u_1_x * cos_phi_2 - cos_phi_1 * u_2_x;
        let phi_3_dot_squared = phi_3_dot * phi_3_dot;
        let w_5 = w_4 * phi_3_dot_squared;
        let w_7 = self.l * phi_3_dot_squared;
        let phi_1_dot_squared = phi_1_dot * phi_1_dot;
        let P_2_y_convective = self.l
            * (cos_phi_1 * phi_1_dot_squared + phi_2_dot_squared * cos_phi_2);
        let phi_4_dot_squared = phi_4_dot * phi_4_dot;
        let w_6 = w_4 * phi_4_dot_squared;
        let w_10 = self.l * phi_4_dot_squared;
        let w_8 = cos_phi_3 * w_7 + P_2_y_convective;
        let w_9 = w_4 * phi_5_dot * phi_5_dot;
        let w_11 = cos_phi_4 * w_10 + w_8;
        let w_12 = w_9 * cos_phi_5 + self.m * w_11;
        let w_13 = w_6 * cos_phi_4 + self.m * w_8 + w_12;
        let w_14 = w_5 * cos_phi_3 + self.m * P_2_y_convective + w_13;
        let minus_P_2_x_convective = self.l
            * (phi_1_dot_squared * u_1_x + phi_2_dot_squared * u_2_x);
        let w_15 = u_3_x * w_7 + minus_P_2_x_convective;
        let w_16 = u_4_x * w_10 + w_15;
        let w_17 = u_5_x * w_9 + self.m * w_16;
        let w_18 = u_4_x * w_6 + self.m * w_15 + w_17;
        let w_19 = u_3_x * w_5 + self.m * minus_P_2_x_convective + w_18;
        [
            w_2 * phi_2_dot_squared * w_3 + w_14 * self.l * u_1_x
                - w_19 * self.l * cos_phi_1,
            w_14 * self.l * u_2_x - phi_1_dot_squared * w_2 * w_3
                - w_19 * self.l * cos_phi_2,
            P_2_y_convective * w_4 * u_3_x - minus_P_2_x_convective * w_4 * cos_phi_3
                + w_13 * self.l * u_3_x - w_18 * self.l * cos_phi_3,
            w_8 * w_4 * u_4_x - w_15 * w_4 * cos_phi_4 + w_12 * self.l * u_4_x
                - w_17 * self.l * cos_phi_4,
            w_11 * w_4 * u_5_x - w_16 * w_4 * cos_phi_5,
        ]
    }
    /// Generalised forces `T_q' F`, 5: joules per unit of each coordinate.
    ///
    /// Operations: 11 additions, 18 multiplications, 5 sine-cosine pairs.
    #[inline]
    pub fn generalized_forces(&self, t: S, q: &[S; 5], qd: &[S; 5]) -> [S; 5] {
        let [phi_1, phi_2, phi_3, phi_4, phi_5] = *q;
        let ([u_1_x, u_2_x, u_3_x, u_4_x, u_5_x], [_, _, _, _, _]) = S::sin_cos_each([
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
            -(u_1_x * S::from_f64(1.5) * self.l * w + w_3 * self.l * u_1_x),
            -(u_2_x * w_4 + w_3 * self.l * u_2_x),
            -(w_4 * u_3_x + w_2 * self.l * u_3_x),
            -(w_4 * u_4_x + w * self.l * u_4_x),
            -(w_4 * u_5_x),
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
            [u_1_x,
            u_2_x,
            u_3_x,
            u_4_x,
            u_5_x,
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
        let w_4 = w * u_1_x + w_2 * u_2_x;
        let w_5 = self.l * phi_3_dot;
        let w_6 = cos_phi_3 * w_5;
        let w_8 = w_5 * u_3_x;
        let P_2_x_dot = self.l * (phi_1_dot * cos_phi_1 + phi_2_dot * cos_phi_2);
        let w_7 = w_6 + S::from_f64(2.0) * P_2_x_dot;
        let P_3_x_dot = P_2_x_dot + w_6;
        let P_2_y_dot = self.l * (phi_1_dot * u_1_x + phi_2_dot * u_2_x);
        let w_9 = w_8 + S::from_f64(2.0) * P_2_y_dot;
        let P_3_y_dot = P_2_y_dot + w_8;
        let w_10 = self.l * phi_4_dot;
        let w_11 = cos_phi_4 * w_10;
        let w_13 = w_10 * u_4_x;
        let w_12 = w_11 + S::from_f64(2.0) * P_3_x_dot;
        let w_14 = w_13 + S::from_f64(2.0) * P_3_y_dot;
        let w_15 = self.l * phi_5_dot;
        let w_16 = cos_phi_5 * w_15 + S::from_f64(2.0) * (P_3_x_dot + w_11);
        let w_17 = w_15 * u_5_x + S::from_f64(2.0) * (P_3_y_dot + w_13);
        let w_18 = w_3 * w_3 + w_4 * w_4 + w_7 * w_7 + w_9 * w_9 + w_12 * w_12
            + w_14 * w_14 + w_16 * w_16 + w_17 * w_17;
        let l_squared = self.l * self.l;
        let w_19 = l_squared * self.m * S::from_f64(0.041666666666666664)
            * (phi_2_dot * phi_2_dot + phi_3_dot * phi_3_dot + phi_4_dot * phi_4_dot
                + phi_5_dot * phi_5_dot);
        self.m * S::from_f64(0.125) * w_18 + w_19
            + phi_1_dot * phi_1_dot * S::from_f64(0.16666666666666666) * l_squared
                * self.m
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
        let ([u_1_x, u_2_x, u_3_x, u_4_x, u_5_x], [_, _, _, _, _]) = S::sin_cos_each([
            phi_1,
            phi_2,
            phi_3,
            phi_4,
            phi_5,
        ]);
        let w_2 = phi_2_dot * u_2_x;
        let w_3 = S::from_f64(0.5) * self.l * w
            * (w_2 + phi_3_dot * u_3_x + phi_4_dot * u_4_x + phi_5_dot * u_5_x);
        let P_2_y_dot = self.l * (phi_1_dot * u_1_x + w_2);
        let P_3_y_dot = P_2_y_dot + self.l * phi_3_dot * u_3_x;
        -(w_3 + w * (P_2_y_dot + P_3_y_dot + (P_3_y_dot + self.l * phi_4_dot * u_4_x))
            + phi_1_dot * u_1_x * self.l * w * S::from_f64(1.5))
    }
    /// Outputs, 7, in SI units.
    ///
    /// Operations: 14 additions, 26 multiplications, 5 sine-cosine pairs, 1 square root.
    #[inline]
    pub fn outputs(
        &self,
        t: S,
        q: &[S; 5],
        qd: &[S; 5],
        qdd: &[S; 5],
        lambda: &[S; 0],
    ) -> HangingChainOutputs<S> {
        let [phi_1, phi_2, phi_3, phi_4, phi_5] = *q;
        let [phi_1_dot, phi_2_dot, phi_3_dot, phi_4_dot, phi_5_dot] = *qd;
        let (
            [u_1_x,
            u_2_x,
            u_3_x,
            u_4_x,
            u_5_x,
            ],
            [cos_phi_1,
            cos_phi_2,
            cos_phi_3,
            cos_phi_4,
            cos_phi_5,
            ],
        ) = S::sin_cos_each([phi_1, phi_2, phi_3, phi_4, phi_5]);
        let w = self.l
            * (phi_1_dot * cos_phi_1 + phi_2_dot * cos_phi_2 + phi_3_dot * cos_phi_3
                + phi_4_dot * cos_phi_4 + phi_5_dot * cos_phi_5);
        let w_2 = self.l
            * (phi_1_dot * u_1_x + phi_2_dot * u_2_x + phi_3_dot * u_3_x
                + phi_4_dot * u_4_x + phi_5_dot * u_5_x);
        let w_3 = cos_phi_1 * self.l * S::from_f64(9.0)
            + cos_phi_2 * self.l * S::from_f64(7.0)
            + cos_phi_3 * self.l * S::from_f64(5.0)
            + cos_phi_4 * self.l * S::from_f64(3.0) + self.l * cos_phi_5;
        [
            phi_1,
            phi_2,
            phi_3,
            phi_4,
            phi_5,
            (w * w + w_2 * w_2).sqrt(),
            -(w_3 * S::from_f64(0.5) * self.m * self.g),
        ]
            .into()
    }
    /// Rates of the outputs that depend on neither accelerations nor multipliers, 7, in SI units per second.
    ///
    /// Operations: 33 additions, 61 multiplications, 1 division, 5 sine-cosine pairs, 1 square root.
    #[inline]
    pub fn output_rates(
        &self,
        t: S,
        q: &[S; 5],
        qd: &[S; 5],
        qdd: &[S; 5],
    ) -> HangingChainOutputRates<S> {
        let [phi_1, phi_2, phi_3, phi_4, phi_5] = *q;
        let [phi_1_dot, phi_2_dot, phi_3_dot, phi_4_dot, phi_5_dot] = *qd;
        let [phi_1_ddot, phi_2_ddot, phi_3_ddot, phi_4_ddot, phi_5_ddot] = *qdd;
        let (
            [u_1_x,
            u_2_x,
            u_3_x,
            u_4_x,
            u_5_x,
            ],
            [cos_phi_1,
            cos_phi_2,
            cos_phi_3,
            cos_phi_4,
            cos_phi_5,
            ],
        ) = S::sin_cos_each([phi_1, phi_2, phi_3, phi_4, phi_5]);
        let w = self.l
            * (phi_1_dot * cos_phi_1 + phi_2_dot * cos_phi_2 + phi_3_dot * cos_phi_3
                + phi_4_dot * cos_phi_4 + phi_5_dot * cos_phi_5);
        let w_2 = self.l
            * (phi_1_dot * u_1_x + phi_2_dot * u_2_x + phi_3_dot * u_3_x
                + phi_4_dot * u_4_x + phi_5_dot * u_5_x);
        let w_3 = w * w + w_2 * w_2;
        let phi_1_dot_squared = phi_1_dot * phi_1_dot;
        let phi_2_dot_squared = phi_2_dot * phi_2_dot;
        let phi_3_dot_squared = phi_3_dot * phi_3_dot;
        let phi_4_dot_squared = phi_4_dot * phi_4_dot;
        let phi_5_dot_squared = phi_5_dot * phi_5_dot;
        let w_4 = u_1_x * phi_1_dot_squared + u_2_x * phi_2_dot_squared
            - cos_phi_1 * phi_1_ddot - cos_phi_2 * phi_2_ddot + u_3_x * phi_3_dot_squared
            - cos_phi_3 * phi_3_ddot + u_4_x * phi_4_dot_squared - cos_phi_4 * phi_4_ddot
            + u_5_x * phi_5_dot_squared - cos_phi_5 * phi_5_ddot;
        let w_5 = cos_phi_1 * phi_1_dot_squared + cos_phi_2 * phi_2_dot_squared
            + u_1_x * phi_1_ddot + u_2_x * phi_2_ddot + cos_phi_3 * phi_3_dot_squared
            + u_3_x * phi_3_ddot + cos_phi_4 * phi_4_dot_squared + u_4_x * phi_4_ddot
            + cos_phi_5 * phi_5_dot_squared + u_5_x * phi_5_ddot;
        let w_6 = phi_1_dot * u_1_x * self.l * S::from_f64(9.0)
            + phi_2_dot * u_2_x * self.l * S::from_f64(7.0)
            + phi_3_dot * u_3_x * self.l * S::from_f64(5.0)
            + phi_4_dot * u_4_x * self.l * S::from_f64(3.0) + phi_5_dot * self.l * u_5_x;
        [
            phi_1_dot,
            phi_2_dot,
            phi_3_dot,
            phi_4_dot,
            phi_5_dot,
            -(w_3.sqrt() * (w * self.l * w_4 - w_2 * self.l * w_5) / w_3),
            w_6 * S::from_f64(0.5) * self.m * self.g,
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
    pub fn drawing(&self, t: S, q: &[S; 5]) -> [S; 30] {
        let [phi_1, phi_2, phi_3, phi_4, phi_5] = *q;
        let (
            [u_1_x,
            u_2_x,
            u_3_x,
            u_4_x,
            u_5_x,
            ],
            [cos_phi_1,
            cos_phi_2,
            cos_phi_3,
            cos_phi_4,
            cos_phi_5,
            ],
        ) = S::sin_cos_each([phi_1, phi_2, phi_3, phi_4, phi_5]);
        let P_1_x = self.l * u_1_x;
        let P_1_y = -(self.l * cos_phi_1);
        let w = u_1_x + u_2_x;
        let P_2_x = self.l * w;
        let w_2 = cos_phi_1 + cos_phi_2;
        let P_2_y = -(self.l * w_2);
        let w_3 = w + u_3_x;
        let P_3_x = self.l * w_3;
        let w_4 = w_2 + cos_phi_3;
        let P_3_y = -(self.l * w_4);
        let w_5 = w_3 + u_4_x;
        let P_4_x = self.l * w_5;
        let w_6 = w_4 + cos_phi_4;
        let P_4_y = -(self.l * w_6);
        [
            S::from_f64(0.0),
            S::from_f64(0.0),
            S::from_f64(0.0),
            S::from_f64(0.0),
            P_1_x,
            P_1_y,
            P_1_x,
            P_1_y,
            P_2_x,
            P_2_y,
            P_2_x,
            P_2_y,
            P_3_x,
            P_3_y,
            P_3_x,
            P_3_y,
            P_4_x,
            P_4_y,
            P_4_x,
            P_4_y,
            self.l * (w_5 + u_5_x),
            -(self.l * (w_6 + cos_phi_5)),
            P_1_x,
            P_1_y,
            P_2_x,
            P_2_y,
            P_3_x,
            P_3_y,
            P_4_x,
            P_4_y,
        ]
    }
    /// Declared start: values or guesses of the coordinates (5), and speeds (5), in SI units; 0 where nothing is declared.
    ///
    /// Operations: none.
    #[inline]
    pub fn initial(&self) -> sim_kernel::Initial<[S; 5]> {
        sim_kernel::Initial {
            positions: [self.start, self.start, self.start, self.start, self.start],
            speeds: [
                S::from_f64(0.0),
                S::from_f64(0.0),
                S::from_f64(0.0),
                S::from_f64(0.0),
                S::from_f64(0.0),
            ],
        }
    }
    /// [`HangingChainPrepared::dynamics`] once; for many calls with the same parameters [`Self::prepare`] first.
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
impl<S: sim_kernel::Scalar> HangingChainPrepared<S> {
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
            [u_1_x,
            u_2_x,
            u_3_x,
            u_4_x,
            u_5_x,
            ],
            [cos_phi_1,
            cos_phi_2,
            cos_phi_3,
            cos_phi_4,
            cos_phi_5,
            ],
        ) = S::sin_cos_each([phi_1, phi_2, phi_3, phi_4, phi_5]);
        let w = self.l * u_4_x;
        let minus_rhs_phi_5 = u_5_x * self.k_4;
        let mass_P_4_y_phi_5 = self.k_2 * u_5_x;
        let l_P_4_y_phi_5 = mass_P_4_y_phi_5 * self.inverse_phi_5;
        let mass_P_4_x_phi_5 = self.k_2 * cos_phi_5;
        let phi_5_dot_squared = phi_5_dot * phi_5_dot;
        let w_2 = self.l * cos_phi_4;
        let phi_4_dot_squared = phi_4_dot * phi_4_dot;
        let P_4_y_convective = w_2 * phi_4_dot_squared;
        let w_3 = self.m - mass_P_4_y_phi_5 * l_P_4_y_phi_5;
        let w_4 = minus_rhs_phi_5 * l_P_4_y_phi_5
            - (self.k_5 + mass_P_4_x_phi_5 * phi_5_dot_squared) - P_4_y_convective * w_3;
        let minus_P_4_x_convective = w * phi_4_dot_squared;
        let w_5 = mass_P_4_x_phi_5 * l_P_4_y_phi_5;
        let w_6 = w * w_5;
        let l_P_4_x_phi_5 = mass_P_4_x_phi_5 * self.inverse_phi_5;
        let w_7 = self.m - mass_P_4_x_phi_5 * l_P_4_x_phi_5;
        let w_8 = mass_P_4_y_phi_5 * phi_5_dot_squared + minus_rhs_phi_5 * l_P_4_x_phi_5
            + P_4_y_convective * w_5 + minus_P_4_x_convective * w_7;
        let rhs_phi_4 = w * w_4 - u_4_x * self.k_4 - minus_P_4_x_convective * w_6
            + w_2 * w_8;
        let w_9 = self.l * u_3_x;
        let mass_P_3_x_phi_4 = self.k_2 * cos_phi_4;
        let w_10 = w * w_3;
        let w_11 = w * w_10;
        let w_12 = w_2 * w_6;
        let w_13 = w_2 * w_7;
        let k_P_3_x_phi_4 = mass_P_3_x_phi_4 - w_6 + w_13;
        let w_14 = w_2 * w_13;
        let pivot_phi_4 = self.mass_phi_2_phi_2 + w_11 - w_12 - w_12 + w_14;
        let abs_w_12 = w_12.abs();
        let inverse_phi_4 = S::from_f64(1.0) / pivot_phi_4;
        let mass_P_3_y_phi_4 = self.k_2 * u_4_x;
        let k_P_3_y_phi_4 = mass_P_3_y_phi_4 + w_10 - w_2 * w_5;
        let l_P_3_y_phi_4 = inverse_phi_4 * k_P_3_y_phi_4;
        let w_16 = self.m + w_3 - k_P_3_y_phi_4 * l_P_3_y_phi_4;
        let w_15 = self.l * cos_phi_3;
        let phi_3_dot_squared = phi_3_dot * phi_3_dot;
        let P_3_y_convective = w_15 * phi_3_dot_squared;
        let w_17 = w_4 - (self.k_5 + mass_P_3_x_phi_4 * phi_4_dot_squared)
            - minus_P_4_x_convective * w_5 - l_P_3_y_phi_4 * rhs_phi_4
            - P_3_y_convective * w_16;
        let w_18 = w_5 + k_P_3_x_phi_4 * l_P_3_y_phi_4;
        let minus_P_3_x_convective = w_9 * phi_3_dot_squared;
        let w_19 = w_9 * w_18;
        let l_P_3_x_phi_4 = inverse_phi_4 * k_P_3_x_phi_4;
        let w_20 = self.m + w_7 - k_P_3_x_phi_4 * l_P_3_x_phi_4;
        let w_21 = mass_P_3_y_phi_4 * phi_4_dot_squared + w_8 - l_P_3_x_phi_4 * rhs_phi_4
            + P_3_y_convective * w_18 + minus_P_3_x_convective * w_20;
        let rhs_phi_3 = w_9 * w_17 - u_3_x * self.k_4 - minus_P_3_x_convective * w_19
            + w_15 * w_21;
        let w_22 = cos_phi_1 * self.k;
        let phi_2_dot_squared = phi_2_dot * phi_2_dot;
        let w_23 = u_2_x * phi_2_dot_squared;
        let w_24 = cos_phi_2 * self.k;
        let P_1_x = self.l * u_1_x;
        let mass_P_2_x_phi_3 = cos_phi_3 * self.k_2;
        let w_25 = w_9 * w_16;
        let w_26 = w_9 * w_25;
        let w_27 = w_15 * w_19;
        let w_28 = w_15 * w_20;
        let k_P_2_x_phi_3 = mass_P_2_x_phi_3 - w_19 + w_28;
        let w_29 = w_15 * w_28;
        let pivot_phi_3 = self.mass_phi_2_phi_2 + w_26 - w_27 - w_27 + w_29;
        let abs_w_27 = w_27.abs();
        let inverse_phi_3 = S::from_f64(1.0) / pivot_phi_3;
        let mass_P_2_y_phi_3 = self.k_2 * u_3_x;
        let k_P_2_y_phi_3 = mass_P_2_y_phi_3 + w_25 - w_15 * w_18;
        let l_P_2_y_phi_3 = inverse_phi_3 * k_P_2_y_phi_3;
        let w_30 = self.m + w_16 - k_P_2_y_phi_3 * l_P_2_y_phi_3;
        let phi_1_dot_squared = phi_1_dot * phi_1_dot;
        let P_2_y_convective = self.l
            * (cos_phi_1 * phi_1_dot_squared + cos_phi_2 * phi_2_dot_squared);
        let w_31 = w_17 - (self.k_5 + mass_P_2_x_phi_3 * phi_3_dot_squared)
            - minus_P_3_x_convective * w_18 - l_P_2_y_phi_3 * rhs_phi_3
            - P_2_y_convective * w_30;
        let w_33 = w_18 + k_P_2_x_phi_3 * l_P_2_y_phi_3;
        let w_32 = u_1_x * phi_1_dot_squared;
        let minus_P_2_x_convective = self.l * (w_32 + w_23);
        let w_34 = P_1_x * w_33;
        let w_35 = self.l * cos_phi_1;
        let l_P_2_x_phi_3 = inverse_phi_3 * k_P_2_x_phi_3;
        let w_36 = self.m + w_20 - k_P_2_x_phi_3 * l_P_2_x_phi_3;
        let w_37 = mass_P_2_y_phi_3 * phi_3_dot_squared + w_21
            - l_P_2_x_phi_3 * rhs_phi_3 + P_2_y_convective * w_33
            + minus_P_2_x_convective * w_36;
        let rhs_phi_1 = w_22 * w_23 - u_1_x * (self.k_3 + phi_2_dot_squared * w_24)
            + P_1_x * w_31 - minus_P_2_x_convective * w_34 + w_35 * w_37;
        let w_38 = self.l * u_2_x;
        let w_39 = w_38 * w_33;
        let w_40 = self.l * cos_phi_2;
        let w_41 = P_1_x * P_1_x * w_30;
        let w_44 = w_38 * w_30;
        let w_42 = w_35 * w_34;
        let w_43 = w_35 * w_35 * w_36;
        let w_45 = w_40 * w_36;
        let k_phi_2_phi_1 = self.k * (cos_phi_1 * cos_phi_2 + u_1_x * u_2_x)
            + P_1_x * w_44 - w_40 * w_34 - w_35 * w_39 + w_35 * w_45;
        let w_46 = w_38 * w_44;
        let w_48 = w_40 * w_45;
        let pivot_phi_1 = self.mass_phi_1_phi_1 + w_41 - w_42 - w_42 + w_43;
        let abs_w_42 = w_42.abs();
        let inverse_phi_1 = S::from_f64(1.0) / pivot_phi_1;
        let l_phi_2_phi_1 = inverse_phi_1 * k_phi_2_phi_1;
        let w_47 = w_40 * w_39;
        let pivot_phi_2 = self.mass_phi_2_phi_2 + w_46 - w_47 - w_47 + w_48
            - k_phi_2_phi_1 * l_phi_2_phi_1;
        let phi_2_ddot = S::from_f64(1.0) / pivot_phi_2
            * (w_24 * w_32 - u_2_x * (self.k_4 + phi_1_dot_squared * w_22) + w_38 * w_31
                - minus_P_2_x_convective * w_39 + w_40 * w_37
                - l_phi_2_phi_1 * rhs_phi_1);
        let phi_1_ddot = inverse_phi_1 * rhs_phi_1 - l_phi_2_phi_1 * phi_2_ddot;
        let P_2_x_ddot = w_35 * phi_1_ddot - minus_P_2_x_convective + w_40 * phi_2_ddot;
        let P_2_y_ddot = P_2_y_convective + P_1_x * phi_1_ddot + w_38 * phi_2_ddot;
        let phi_3_ddot = inverse_phi_3 * rhs_phi_3 - l_P_2_x_phi_3 * P_2_x_ddot
            - l_P_2_y_phi_3 * P_2_y_ddot;
        let P_3_x_ddot = w_15 * phi_3_ddot - minus_P_3_x_convective + P_2_x_ddot;
        let P_3_y_ddot = P_3_y_convective + w_9 * phi_3_ddot + P_2_y_ddot;
        let phi_4_ddot = inverse_phi_4 * rhs_phi_4 - l_P_3_x_phi_4 * P_3_x_ddot
            - l_P_3_y_phi_4 * P_3_y_ddot;
        let abs_w_47 = w_47.abs();
        let w_49 = u_2_x * phi_2_dot;
        let w_50 = u_1_x * phi_1_dot;
        let P_2_y_dot = self.l * (w_50 + w_49);
        let P_3_y_dot = P_2_y_dot + w_9 * phi_3_dot;
        let w_51 = self.k_4
            * (w_49 + u_3_x * phi_3_dot + u_4_x * phi_4_dot + u_5_x * phi_5_dot)
            + self.k_5 * (P_2_y_dot + P_3_y_dot + (P_3_y_dot + w * phi_4_dot))
            + self.k_3 * w_50;
        sim_kernel::Dynamics {
            accelerations: [
                phi_1_ddot,
                phi_2_ddot,
                phi_3_ddot,
                phi_4_ddot,
                -(minus_rhs_phi_5 * self.inverse_phi_5
                    + l_P_4_x_phi_5
                        * (w_2 * phi_4_ddot - minus_P_4_x_convective + P_3_x_ddot)
                    + l_P_4_y_phi_5 * (P_4_y_convective + w * phi_4_ddot + P_3_y_ddot)),
            ],
            multipliers: [],
            power: -w_51,
            refused: sim_kernel::pivot_is_refused(
                self.mass_phi_2_phi_2,
                self.mass_phi_2_phi_2,
            )
                | sim_kernel::pivot_is_refused(
                    pivot_phi_4,
                    self.mass_phi_2_phi_2 + w_11 + abs_w_12 + abs_w_12 + w_14,
                )
                | sim_kernel::pivot_is_refused(
                    pivot_phi_3,
                    self.mass_phi_2_phi_2 + w_26 + abs_w_27 + abs_w_27 + w_29,
                )
                | sim_kernel::pivot_is_refused(
                    pivot_phi_1,
                    self.mass_phi_1_phi_1 + w_41 + abs_w_42 + abs_w_42 + w_43,
                )
                | sim_kernel::pivot_is_refused(
                    pivot_phi_2,
                    self.mass_phi_2_phi_2 + w_46 + abs_w_47 + abs_w_47 + w_48,
                ),
        }
    }
}
#[allow(non_snake_case, clippy::all, clippy::pedantic)]
impl<S: sim_kernel::Scalar> sim_kernel::Mechanism<S> for HangingChain<S> {
    type Q = [S; 5];
    type L = [S; 0];
    type Z = [S; 5];
    type QQ = [[S; 5]; 5];
    type LQ = [[S; 5]; 0];
    type LL = [[S; 0]; 0];
    type ZZ = [[S; 5]; 5];
    type Entries = [S; 0];
    type Envelope = [S; 0];
    type Parameters = [S; 4];
    type Outputs = [S; 7];
    type OutputRates = [S; 7];
    type Events = [S; 0];
    type EventValues = [S; 0];
    type Activities = [S; 0];
    type Drawing = [S; 30];
    type QP = [[S; 4]; 5];
    type LP = [[S; 4]; 0];
    type Inputs = [sim_kernel::Input<S>; 0];
    type Prepared = HangingChainPrepared<S>;
    type On<T: sim_kernel::Scalar> = HangingChain<T>;
    const DESCRIPTION: sim_kernel::Description = sim_kernel::Description {
        name: "hanging-chain",
        type_name: "HangingChain",
        docs: "A chain of five equal slender rods, let go from the side.",
        declaration: "/// A chain of five equal slender rods, let go from the side.\npub HangingChain;\n\nconst n = 5;\n\ncoordinates {\n    repeat i in 1..=n {\n        /// Angle of rod {i} from the vertical.\n        phi_[i] [rad];\n    }\n}\n\nparameters {\n    /// Length of each rod.\n    l [m] = 0.3;\n    /// Mass of each rod.\n    m [kg] = 0.2;\n    /// Angle of all rods at the start.\n    start [deg] = 60;\n    g [m/s^2] = 9.81;\n}\n\nlet P_[0] = [0, 0];\nrepeat i in 1..=n {\n    let u_[i] = [sin(phi_[i]), -cos(phi_[i])];\n    let P_[i] = P_[i-1] + l*u_[i];\n    bodies { rod_[i]: mass m at P_[i] - l/2*u_[i], inertia m*l^2/12, angle phi_[i]; }\n}\n\nloads { gravity [0, -g]; }\ninitial { repeat i in 1..=n { phi_[i] = start; } }\n\noutputs {\n    angles \"Angles of the rods\" {\n        repeat i in 1..=n {\n            /// rod {i}\n            angle_[i] [deg] = phi_[i];\n        }\n    }\n    tip \"Speed of the tip\" {\n        /// speed\n        tip_speed [m/s] = norm(dot(P_[n]));\n    }\n    energy \"Potential energy\" {\n        /// zero at the support\n        potential [J] = m*g*sum(i in 1..=n, P_[i].y - l/2*u_[i].y);\n    }\n}\n\ndrawing {\n    ground P_[0];\n    repeat i in 1..=n { line P_[i-1], P_[i]; }\n    repeat i in 1..n { point P_[i]; }\n}\n",
        coordinates: &[
            sim_kernel::Coordinate {
                position: sim_kernel::Quantity {
                    name: "phi_1",
                    unit: "rad",
                    factor: 1f64,
                    is_length: false,
                    docs: "Angle of rod 1 from the vertical.",
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
                    docs: "Angle of rod 2 from the vertical.",
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
                    docs: "Angle of rod 3 from the vertical.",
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
                    docs: "Angle of rod 4 from the vertical.",
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
                    docs: "Angle of rod 5 from the vertical.",
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
                name: "l",
                unit: "m",
                factor: 1f64,
                is_length: true,
                docs: "Length of each rod.",
            },
            sim_kernel::Quantity {
                name: "m",
                unit: "kg",
                factor: 1f64,
                is_length: false,
                docs: "Mass of each rod.",
            },
            sim_kernel::Quantity {
                name: "start",
                unit: "deg",
                factor: 0.017453292519943295f64,
                is_length: false,
                docs: "Angle of all rods at the start.",
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
        constraints: &[],
        speed_constraints: &[],
        norm_constraints: &[],
        sparsity: &[],
        conditionals: &[],
        events: &[],
        outputs: &[
            sim_kernel::Quantity {
                name: "angle_1",
                unit: "deg",
                factor: 0.017453292519943295f64,
                is_length: false,
                docs: "rod 1",
            },
            sim_kernel::Quantity {
                name: "angle_2",
                unit: "deg",
                factor: 0.017453292519943295f64,
                is_length: false,
                docs: "rod 2",
            },
            sim_kernel::Quantity {
                name: "angle_3",
                unit: "deg",
                factor: 0.017453292519943295f64,
                is_length: false,
                docs: "rod 3",
            },
            sim_kernel::Quantity {
                name: "angle_4",
                unit: "deg",
                factor: 0.017453292519943295f64,
                is_length: false,
                docs: "rod 4",
            },
            sim_kernel::Quantity {
                name: "angle_5",
                unit: "deg",
                factor: 0.017453292519943295f64,
                is_length: false,
                docs: "rod 5",
            },
            sim_kernel::Quantity {
                name: "tip_speed",
                unit: "m/s",
                factor: 1f64,
                is_length: false,
                docs: "speed",
            },
            sim_kernel::Quantity {
                name: "potential",
                unit: "J",
                factor: 1f64,
                is_length: false,
                docs: "zero at the support",
            },
        ],
        rated_outputs: &[0, 1, 2, 3, 4, 5, 6],
        figures: &[
            sim_kernel::Figure {
                name: "angles",
                title: "Angles of the rods",
                len: 5,
            },
            sim_kernel::Figure {
                name: "tip",
                title: "Speed of the tip",
                len: 1,
            },
            sim_kernel::Figure {
                name: "energy",
                title: "Potential energy",
                len: 1,
            },
        ],
        optional_kernels: &[],
        dimension: 2,
        drawing: &[
            sim_kernel::Shape::Ground(1),
            sim_kernel::Shape::Line(2),
            sim_kernel::Shape::Line(2),
            sim_kernel::Shape::Line(2),
            sim_kernel::Shape::Line(2),
            sim_kernel::Shape::Line(2),
            sim_kernel::Shape::Points(1),
            sim_kernel::Shape::Points(1),
            sim_kernel::Shape::Points(1),
            sim_kernel::Shape::Points(1),
        ],
    };
    fn defaults() -> Self {
        Self {
            l: S::from_f64(0.3f64),
            m: S::from_f64(0.2f64),
            start: S::from_f64(1.0471975511965976f64),
            g: S::from_f64(9.81f64),
        }
    }
    fn parameters(&self) -> [S; 4] {
        [self.l, self.m, self.start, self.g]
    }
    fn with_parameters(&self, parameters: [S; 4]) -> Self {
        Self {
            l: parameters[0],
            m: parameters[1],
            start: parameters[2],
            g: parameters[3],
            ..*self
        }
    }
    fn on<T: sim_kernel::Scalar>(
        &self,
        convert: impl ::core::ops::Fn(S) -> T,
    ) -> HangingChain<T> {
        HangingChain {
            l: convert(self.l),
            m: convert(self.m),
            start: convert(self.start),
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
    fn prepare(&self) -> HangingChainPrepared<S> {
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
    ) -> [S; 7] {
        self.outputs(t, q, qd, qdd, lambda).into()
    }
    #[inline(always)]
    fn output_rates(&self, t: S, q: &[S; 5], qd: &[S; 5], qdd: &[S; 5]) -> [S; 7] {
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
    fn drawing(&self, t: S, q: &[S; 5]) -> [S; 30] {
        self.drawing(t, q)
    }
    #[inline(always)]
    fn initial(&self) -> sim_kernel::Initial<[S; 5]> {
        self.initial()
    }
}
