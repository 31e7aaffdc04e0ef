/// Parallel cranks side by side, joined by couplers: three four-bars in a row, which swing as one pendulum.
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
/// coordinates = [
///     crank_angle_0;
///     crank_angle_1;
///     crank_angle_2;
///     crank_angle_3;
///     coupler_angle_1;
///     coupler_angle_2;
///     coupler_angle_3
/// ]
/// multipliers = [
///     lambda_loop_1_x;
///     lambda_loop_1_y;
///     lambda_loop_2_x;
///     lambda_loop_2_y;
///     lambda_loop_3_x;
///     lambda_loop_3_y
/// ]
/// constraints = 0
///
/// mass_matrix = [
///     4*l^2*m/3, 0, 0, 0, mass_matrix[1, 5], 0, 0;
///     0, 4*l^2*m/3, 0, 0, 0, mass_matrix[2, 6], 0;
///     0, 0, 4*l^2*m/3, 0, 0, 0, mass_matrix[3, 7];
///     0, 0, 0, l^2*m/3, 0, 0, 0;
///     mass_matrix[1, 5], 0, 0, 0, l^2*m/3, 0, 0;
///     0, mass_matrix[2, 6], 0, 0, 0, l^2*m/3, 0;
///     0, 0, mass_matrix[3, 7], 0, 0, 0, l^2*m/3
/// ]
/// mass_matrix[1, 5] = l^2*m*sin(crank_angle_0)*sin(coupler_angle_1)/2
///     + l^2*m*cos(crank_angle_0)*cos(coupler_angle_1)/2
/// mass_matrix[2, 6] = l^2*m*sin(crank_angle_1)*sin(coupler_angle_2)/2
///     + l^2*m*cos(crank_angle_1)*cos(coupler_angle_2)/2
/// mass_matrix[3, 7] = l^2*m*sin(crank_angle_2)*sin(coupler_angle_3)/2
///     + l^2*m*cos(crank_angle_2)*cos(coupler_angle_3)/2
///
/// convective_forces = [
///     convective_forces[1];
///     convective_forces[2];
///     convective_forces[3];
///     0;
///     convective_forces[5];
///     convective_forces[6];
///     convective_forces[7]
/// ]
/// convective_forces[1] = l*m*(2*s_1 + s_7)*sin(crank_angle_0)/2 - l*m*(2*s_2 + s_8)*cos(crank_angle_0)/2
/// convective_forces[2] = l*m*(2*s_3 + s_9)*sin(crank_angle_1)/2 - l*m*(2*s_4 + s_10)*cos(crank_angle_1)/2
/// convective_forces[3] = l*m*(2*s_5 + s_11)*sin(crank_angle_2)/2 - l*m*(2*s_6 + s_12)*cos(crank_angle_2)/2
/// convective_forces[5] = l*m*(2*s_1 + s_7)*sin(coupler_angle_1)/4 - l*m*(2*s_2 + s_8)*cos(coupler_angle_1)/4
/// convective_forces[6] = l*m*(2*s_3 + s_9)*sin(coupler_angle_2)/4 - l*m*(2*s_4 + s_10)*cos(coupler_angle_2)/4
/// convective_forces[7] = l*m*(2*s_5 + s_11)*sin(coupler_angle_3)/4 - l*m*(2*s_6 + s_12)*cos(coupler_angle_3)/4
///
/// generalized_forces = [
///     -3*l*m*g*cos(crank_angle_0)/2;
///     -3*l*m*g*cos(crank_angle_1)/2;
///     -3*l*m*g*cos(crank_angle_2)/2;
///     -l*m*g*cos(crank_angle_3)/2;
///     -l*m*g*cos(coupler_angle_1)/2;
///     -l*m*g*cos(coupler_angle_2)/2;
///     -l*m*g*cos(coupler_angle_3)/2
/// ]
///
/// constraints = [
///     constraints[1];
///     constraints[2];
///     constraints[3];
///     constraints[4];
///     constraints[5];
///     constraints[6]
/// ]
/// constraints[1] = crank_0_tip_x - l - constraint_jacobian[4, 2] + constraint_jacobian[2, 5]
/// constraints[2] = crank_0_tip_y - crank_1_tip_y + l*sin(coupler_angle_1)
/// constraints[3] = constraint_jacobian[4, 2] - l - constraint_jacobian[6, 3] + constraint_jacobian[4, 6]
/// constraints[4] = crank_1_tip_y - crank_2_tip_y + l*sin(coupler_angle_2)
/// constraints[5] = constraint_jacobian[6, 3] - l - l*cos(crank_angle_3) + constraint_jacobian[6, 7]
/// constraints[6] = crank_2_tip_y - crank_3_tip_y + l*sin(coupler_angle_3)
///
/// constraint_jacobian = [
///     constraint_jacobian[1, 1], crank_1_tip_y, 0, 0, constraint_jacobian[1, 5], 0, 0;
///     crank_0_tip_x, constraint_jacobian[2, 2], 0, 0, constraint_jacobian[2, 5], 0, 0;
///     0, constraint_jacobian[3, 2], crank_2_tip_y, 0, 0, constraint_jacobian[3, 6], 0;
///     0, constraint_jacobian[4, 2], constraint_jacobian[4, 3], 0, 0, constraint_jacobian[4, 6], 0;
///     0, 0, constraint_jacobian[5, 3], crank_3_tip_y, 0, 0, constraint_jacobian[5, 7];
///     0, 0, constraint_jacobian[6, 3], constraint_jacobian[6, 4], 0, 0, constraint_jacobian[6, 7]
/// ]
/// constraint_jacobian[1, 1] = -l*sin(crank_angle_0)
/// constraint_jacobian[1, 5] = -l*sin(coupler_angle_1)
/// constraint_jacobian[2, 2] = -l*cos(crank_angle_1)
/// constraint_jacobian[2, 5] = l*cos(coupler_angle_1)
/// constraint_jacobian[3, 2] = -l*sin(crank_angle_1)
/// constraint_jacobian[3, 6] = -l*sin(coupler_angle_2)
/// constraint_jacobian[4, 2] = l*cos(crank_angle_1)
/// constraint_jacobian[4, 3] = -l*cos(crank_angle_2)
/// constraint_jacobian[4, 6] = l*cos(coupler_angle_2)
/// constraint_jacobian[5, 3] = -l*sin(crank_angle_2)
/// constraint_jacobian[5, 7] = -l*sin(coupler_angle_3)
/// constraint_jacobian[6, 3] = l*cos(crank_angle_2)
/// constraint_jacobian[6, 4] = -l*cos(crank_angle_3)
/// constraint_jacobian[6, 7] = l*cos(coupler_angle_3)
///
/// constraint_convective = [
///     s_3 - s_1 - s_7;
///     s_4 - s_2 - s_8;
///     s_5 - s_3 - s_9;
///     s_6 - s_4 - s_10;
///     constraint_convective[5];
///     constraint_convective[6]
/// ]
/// constraint_convective[5] = l*crank_angle_3_dot^2*cos(crank_angle_3) - s_5 - s_11
/// constraint_convective[6] = l*crank_angle_3_dot^2*sin(crank_angle_3) - s_6 - s_12
///
/// crank_0_tip_x = l*cos(crank_angle_0)
/// crank_0_tip_y = l*sin(crank_angle_0)
/// crank_1_tip_y = l*sin(crank_angle_1)
/// crank_2_tip_y = l*sin(crank_angle_2)
/// crank_3_tip_y = l*sin(crank_angle_3)
/// s_1 = l*crank_angle_0_dot^2*cos(crank_angle_0)
/// s_2 = l*crank_angle_0_dot^2*sin(crank_angle_0)
/// s_3 = l*crank_angle_1_dot^2*cos(crank_angle_1)
/// s_4 = l*crank_angle_1_dot^2*sin(crank_angle_1)
/// s_5 = l*crank_angle_2_dot^2*cos(crank_angle_2)
/// s_6 = l*crank_angle_2_dot^2*sin(crank_angle_2)
/// s_7 = l*coupler_angle_1_dot^2*cos(coupler_angle_1)
/// s_8 = l*coupler_angle_1_dot^2*sin(coupler_angle_1)
/// s_9 = l*coupler_angle_2_dot^2*cos(coupler_angle_2)
/// s_10 = l*coupler_angle_2_dot^2*sin(coupler_angle_2)
/// s_11 = l*coupler_angle_3_dot^2*cos(coupler_angle_3)
/// s_12 = l*coupler_angle_3_dot^2*sin(coupler_angle_3)
/// ```
#[allow(non_snake_case)]
#[derive(
    ::core::clone::Clone,
    ::core::marker::Copy,
    ::core::fmt::Debug,
    ::core::cmp::PartialEq
)]
pub struct FourBars<S = ::core::primitive::f64> {
    /// Length of each bar, in `m`.
    pub l: S,
    /// Mass of each bar, in `kg`.
    pub m: S,
    /// Angle of the cranks at the start, in `1`.
    pub start: S,
    /// In `m/s^2`.
    pub g: S,
}
impl<S: sim_kernel::Scalar> ::core::default::Default for FourBars<S> {
    /// The declared values.
    fn default() -> Self {
        <Self as sim_kernel::Mechanism<S>>::defaults()
    }
}
/// Coordinates of [`FourBars`] by name, in SI units; also for their speeds and accelerations.
#[allow(non_snake_case)]
#[derive(
    ::core::clone::Clone,
    ::core::marker::Copy,
    ::core::fmt::Debug,
    ::core::cmp::PartialEq
)]
pub struct FourBarsCoordinates<S = ::core::primitive::f64> {
    /// Angle of crank 0, in `rad`.
    pub crank_angle_0: S,
    /// Angle of crank 1, in `rad`.
    pub crank_angle_1: S,
    /// Angle of crank 2, in `rad`.
    pub crank_angle_2: S,
    /// Angle of crank 3, in `rad`.
    pub crank_angle_3: S,
    /// Angle of coupler 1, in `rad`.
    pub coupler_angle_1: S,
    /// Angle of coupler 2, in `rad`.
    pub coupler_angle_2: S,
    /// Angle of coupler 3, in `rad`.
    pub coupler_angle_3: S,
}
impl<S: sim_kernel::Scalar> ::core::convert::From<[S; 7]> for FourBarsCoordinates<S> {
    fn from(values: [S; 7]) -> Self {
        Self {
            crank_angle_0: values[0],
            crank_angle_1: values[1],
            crank_angle_2: values[2],
            crank_angle_3: values[3],
            coupler_angle_1: values[4],
            coupler_angle_2: values[5],
            coupler_angle_3: values[6],
        }
    }
}
impl<S: sim_kernel::Scalar> ::core::convert::From<FourBarsCoordinates<S>> for [S; 7] {
    fn from(record: FourBarsCoordinates<S>) -> Self {
        [
            record.crank_angle_0,
            record.crank_angle_1,
            record.crank_angle_2,
            record.crank_angle_3,
            record.coupler_angle_1,
            record.coupler_angle_2,
            record.coupler_angle_3,
        ]
    }
}
/// Outputs of [`FourBars`] by name, in SI units.
#[allow(non_snake_case)]
#[derive(
    ::core::clone::Clone,
    ::core::marker::Copy,
    ::core::fmt::Debug,
    ::core::cmp::PartialEq
)]
pub struct FourBarsOutputs<S = ::core::primitive::f64> {
    /// first, in `1`.
    pub first: S,
    /// last, in `1`.
    pub last: S,
    /// along x, in `N`.
    pub Fx: S,
    /// along y, in `N`.
    pub Fy: S,
}
impl<S: sim_kernel::Scalar> ::core::convert::From<[S; 4]> for FourBarsOutputs<S> {
    fn from(values: [S; 4]) -> Self {
        Self {
            first: values[0],
            last: values[1],
            Fx: values[2],
            Fy: values[3],
        }
    }
}
impl<S: sim_kernel::Scalar> ::core::convert::From<FourBarsOutputs<S>> for [S; 4] {
    fn from(record: FourBarsOutputs<S>) -> Self {
        [record.first, record.last, record.Fx, record.Fy]
    }
}
/// Rates of the outputs of [`FourBars`] by name, in SI units.
#[allow(non_snake_case)]
#[derive(
    ::core::clone::Clone,
    ::core::marker::Copy,
    ::core::fmt::Debug,
    ::core::cmp::PartialEq
)]
pub struct FourBarsOutputRates<S = ::core::primitive::f64> {
    /// Rate of `first`.
    pub first: S,
    /// Rate of `last`.
    pub last: S,
}
impl<S: sim_kernel::Scalar> ::core::convert::From<[S; 2]> for FourBarsOutputRates<S> {
    fn from(values: [S; 2]) -> Self {
        Self {
            first: values[0],
            last: values[1],
        }
    }
}
impl<S: sim_kernel::Scalar> ::core::convert::From<FourBarsOutputRates<S>> for [S; 2] {
    fn from(record: FourBarsOutputRates<S>) -> Self {
        [record.first, record.last]
    }
}
/// What the equations of motion need of the parameters of [`FourBars`], from [`FourBars::prepare`]; its methods are the kernels of each step.
#[allow(non_snake_case)]
#[derive(
    ::core::clone::Clone,
    ::core::marker::Copy,
    ::core::fmt::Debug,
    ::core::cmp::PartialEq
)]
pub struct FourBarsPrepared<S = ::core::primitive::f64> {
    l: S,
    mass_crank_angle_0_crank_angle_0: S,
    mass_crank_angle_3_crank_angle_3: S,
    k: S,
    k_2: S,
    k_3: S,
    k_4: S,
    k_5: S,
    k_6: S,
    inverse_crank_angle_0: S,
    inverse_coupler_angle_2: S,
    k_7: S,
    k_8: S,
    k_9: S,
}
#[allow(non_snake_case, unused_variables, unused_parens, clippy::all, clippy::pedantic)]
impl<S: sim_kernel::Scalar> FourBars<S> {
    /// What the equations of motion need of the parameters, computed once for a set of parameters.
    ///
    /// Operations: 15 multiplications, 2 divisions.
    #[inline]
    pub fn prepare(&self) -> FourBarsPrepared<S> {
        let w = self.l * self.l * self.m;
        let mass_crank_angle_0_crank_angle_0 = S::from_f64(1.3333333333333333) * w;
        let mass_crank_angle_3_crank_angle_3 = w * S::from_f64(0.3333333333333333);
        let w_2 = self.l * self.m;
        let w_3 = S::from_f64(0.5) * self.g;
        FourBarsPrepared {
            l: self.l,
            mass_crank_angle_0_crank_angle_0: mass_crank_angle_0_crank_angle_0,
            mass_crank_angle_3_crank_angle_3: mass_crank_angle_3_crank_angle_3,
            k: w * S::from_f64(0.5),
            k_2: self.l * S::from_f64(2.0),
            k_3: S::from_f64(0.5) * w_2,
            k_4: S::from_f64(1.5) * self.g * w_2,
            k_5: w_2 * w_3,
            k_6: w_2 * S::from_f64(0.25),
            inverse_crank_angle_0: S::from_f64(1.0) / mass_crank_angle_0_crank_angle_0,
            inverse_coupler_angle_2: S::from_f64(1.0) / mass_crank_angle_3_crank_angle_3,
            k_7: self.m * w_3,
            k_8: w,
            k_9: w * S::from_f64(0.25),
        }
    }
    /// Mass matrix `T_q' M T_q`, 7 x 7, symmetric, in SI units.
    ///
    /// Operations: 3 additions, 16 multiplications, 6 sine-cosine pairs.
    #[inline]
    pub fn mass_matrix(&self, t: S, q: &[S; 7]) -> [[S; 7]; 7] {
        let [crank_angle_0, crank_angle_1, crank_angle_2, _, coupler_angle_1,
        coupler_angle_2, coupler_angle_3] = *q;
        let l_squared = self.l * self.l;
        let mass_crank_angle_0_crank_angle_0 = S::from_f64(1.3333333333333333)
            * l_squared * self.m;
        let w = l_squared * self.m * S::from_f64(0.5);
        let (
            [sin_crank_angle_0,
            sin_coupler_angle_1,
            sin_crank_angle_1,
            sin_coupler_angle_2,
            sin_crank_angle_2,
            sin_coupler_angle_3,
            ],
            [cos_crank_angle_0,
            cos_coupler_angle_1,
            cos_crank_angle_1,
            cos_coupler_angle_2,
            cos_crank_angle_2,
            cos_coupler_angle_3,
            ],
        ) = S::sin_cos_each([
            crank_angle_0,
            coupler_angle_1,
            crank_angle_1,
            coupler_angle_2,
            crank_angle_2,
            coupler_angle_3,
        ]);
        let mass_coupler_angle_1_crank_angle_0 = w
            * (sin_crank_angle_0 * sin_coupler_angle_1
                + cos_crank_angle_0 * cos_coupler_angle_1);
        let mass_coupler_angle_2_crank_angle_1 = w
            * (sin_crank_angle_1 * sin_coupler_angle_2
                + cos_crank_angle_1 * cos_coupler_angle_2);
        let mass_coupler_angle_3_crank_angle_2 = w
            * (sin_crank_angle_2 * sin_coupler_angle_3
                + cos_crank_angle_2 * cos_coupler_angle_3);
        let mass_crank_angle_3_crank_angle_3 = l_squared * self.m
            * S::from_f64(0.3333333333333333);
        [
            [
                mass_crank_angle_0_crank_angle_0,
                S::from_f64(0.0),
                S::from_f64(0.0),
                S::from_f64(0.0),
                mass_coupler_angle_1_crank_angle_0,
                S::from_f64(0.0),
                S::from_f64(0.0),
            ],
            [
                S::from_f64(0.0),
                mass_crank_angle_0_crank_angle_0,
                S::from_f64(0.0),
                S::from_f64(0.0),
                S::from_f64(0.0),
                mass_coupler_angle_2_crank_angle_1,
                S::from_f64(0.0),
            ],
            [
                S::from_f64(0.0),
                S::from_f64(0.0),
                mass_crank_angle_0_crank_angle_0,
                S::from_f64(0.0),
                S::from_f64(0.0),
                S::from_f64(0.0),
                mass_coupler_angle_3_crank_angle_2,
            ],
            [
                S::from_f64(0.0),
                S::from_f64(0.0),
                S::from_f64(0.0),
                mass_crank_angle_3_crank_angle_3,
                S::from_f64(0.0),
                S::from_f64(0.0),
                S::from_f64(0.0),
            ],
            [
                mass_coupler_angle_1_crank_angle_0,
                S::from_f64(0.0),
                S::from_f64(0.0),
                S::from_f64(0.0),
                mass_crank_angle_3_crank_angle_3,
                S::from_f64(0.0),
                S::from_f64(0.0),
            ],
            [
                S::from_f64(0.0),
                mass_coupler_angle_2_crank_angle_1,
                S::from_f64(0.0),
                S::from_f64(0.0),
                S::from_f64(0.0),
                mass_crank_angle_3_crank_angle_3,
                S::from_f64(0.0),
            ],
            [
                S::from_f64(0.0),
                S::from_f64(0.0),
                mass_coupler_angle_3_crank_angle_2,
                S::from_f64(0.0),
                S::from_f64(0.0),
                S::from_f64(0.0),
                mass_crank_angle_3_crank_angle_3,
            ],
        ]
    }
    /// Convective forces `T_q' M g`, 7, with `g = (T_q q' + T_t)_q q' + (..)_t`: joules per unit of each coordinate.
    ///
    /// Operations: 6 additions, 27 multiplications, 6 sine-cosine pairs.
    #[inline]
    pub fn convective_forces(&self, t: S, q: &[S; 7], qd: &[S; 7]) -> [S; 7] {
        let [crank_angle_0, crank_angle_1, crank_angle_2, _, coupler_angle_1,
        coupler_angle_2, coupler_angle_3] = *q;
        let [crank_angle_0_dot, crank_angle_1_dot, crank_angle_2_dot, _,
        coupler_angle_1_dot, coupler_angle_2_dot, coupler_angle_3_dot] = *qd;
        let w = S::from_f64(0.5) * self.m * self.l * self.l;
        let (
            [sin_crank_angle_0,
            sin_coupler_angle_1,
            sin_crank_angle_1,
            sin_coupler_angle_2,
            sin_crank_angle_2,
            sin_coupler_angle_3,
            ],
            [cos_crank_angle_0,
            cos_coupler_angle_1,
            cos_crank_angle_1,
            cos_coupler_angle_2,
            cos_crank_angle_2,
            cos_coupler_angle_3,
            ],
        ) = S::sin_cos_each([
            crank_angle_0,
            coupler_angle_1,
            crank_angle_1,
            coupler_angle_2,
            crank_angle_2,
            coupler_angle_3,
        ]);
        let w_2 = sin_crank_angle_0 * cos_coupler_angle_1;
        let w_3 = cos_crank_angle_0 * sin_coupler_angle_1;
        let w_4 = sin_crank_angle_1 * cos_coupler_angle_2;
        let w_5 = cos_crank_angle_1 * sin_coupler_angle_2;
        let w_6 = sin_crank_angle_2 * cos_coupler_angle_3;
        let w_7 = cos_crank_angle_2 * sin_coupler_angle_3;
        [
            w * coupler_angle_1_dot * coupler_angle_1_dot * (w_2 - w_3),
            w * coupler_angle_2_dot * coupler_angle_2_dot * (w_4 - w_5),
            w * coupler_angle_3_dot * coupler_angle_3_dot * (w_6 - w_7),
            S::from_f64(0.0),
            w * crank_angle_0_dot * crank_angle_0_dot * (w_3 - w_2),
            w * crank_angle_1_dot * crank_angle_1_dot * (w_5 - w_4),
            w * crank_angle_2_dot * crank_angle_2_dot * (w_7 - w_6),
        ]
    }
    /// Generalised forces `T_q' F`, 7: joules per unit of each coordinate.
    ///
    /// Operations: 7 additions, 12 multiplications, 7 sine-cosine pairs.
    #[inline]
    pub fn generalized_forces(&self, t: S, q: &[S; 7], qd: &[S; 7]) -> [S; 7] {
        let [crank_angle_0, crank_angle_1, crank_angle_2, crank_angle_3, coupler_angle_1,
        coupler_angle_2, coupler_angle_3] = *q;
        let (
            [_,
            _,
            _,
            _,
            _,
            _,
            _,
            ],
            [cos_crank_angle_0,
            cos_crank_angle_1,
            cos_crank_angle_2,
            cos_crank_angle_3,
            cos_coupler_angle_1,
            cos_coupler_angle_2,
            cos_coupler_angle_3,
            ],
        ) = S::sin_cos_each([
            crank_angle_0,
            crank_angle_1,
            crank_angle_2,
            crank_angle_3,
            coupler_angle_1,
            coupler_angle_2,
            coupler_angle_3,
        ]);
        let w = self.l * self.m;
        let w_2 = S::from_f64(1.5) * self.g * w;
        let w_3 = self.g * w * S::from_f64(0.5);
        [
            -(cos_crank_angle_0 * w_2),
            -(w_2 * cos_crank_angle_1),
            -(w_2 * cos_crank_angle_2),
            -(cos_crank_angle_3 * w_3),
            -(w_3 * cos_coupler_angle_1),
            -(w_3 * cos_coupler_angle_2),
            -(w_3 * cos_coupler_angle_3),
        ]
    }
    /// Constraints `C`, 6, in SI units; zero throughout the motion.
    ///
    /// Operations: 15 additions, 6 multiplications, 7 sine-cosine pairs.
    #[inline]
    pub fn constraints(&self, t: S, q: &[S; 7]) -> [S; 6] {
        let [crank_angle_0, crank_angle_1, crank_angle_2, crank_angle_3, coupler_angle_1,
        coupler_angle_2, coupler_angle_3] = *q;
        let (
            [sin_crank_angle_0,
            sin_crank_angle_1,
            sin_coupler_angle_1,
            sin_crank_angle_2,
            sin_coupler_angle_2,
            sin_crank_angle_3,
            sin_coupler_angle_3,
            ],
            [cos_crank_angle_0,
            cos_crank_angle_1,
            cos_coupler_angle_1,
            cos_crank_angle_2,
            cos_coupler_angle_2,
            cos_crank_angle_3,
            cos_coupler_angle_3,
            ],
        ) = S::sin_cos_each([
            crank_angle_0,
            crank_angle_1,
            coupler_angle_1,
            crank_angle_2,
            coupler_angle_2,
            crank_angle_3,
            coupler_angle_3,
        ]);
        [
            self.l
                * (cos_crank_angle_0 - S::from_f64(1.0) - cos_crank_angle_1
                    + cos_coupler_angle_1),
            self.l * (sin_crank_angle_0 - sin_crank_angle_1 + sin_coupler_angle_1),
            self.l
                * (cos_crank_angle_1 - S::from_f64(1.0) - cos_crank_angle_2
                    + cos_coupler_angle_2),
            self.l * (sin_crank_angle_1 - sin_crank_angle_2 + sin_coupler_angle_2),
            self.l
                * (cos_crank_angle_2 - S::from_f64(1.0) - cos_crank_angle_3
                    + cos_coupler_angle_3),
            self.l * (sin_crank_angle_2 - sin_crank_angle_3 + sin_coupler_angle_3),
        ]
    }
    /// The sum of the magnitudes of the terms of `C`, 6, in SI units: what its rounding is relative to.
    ///
    /// Operations: 30 additions, 14 multiplications, 7 sine-cosine pairs.
    #[inline]
    pub fn constraint_magnitudes(&self, t: S, q: &[S; 7]) -> [S; 6] {
        let [crank_angle_0, crank_angle_1, crank_angle_2, crank_angle_3, coupler_angle_1,
        coupler_angle_2, coupler_angle_3] = *q;
        let abs_l = self.l.abs();
        let (
            [sin_crank_angle_0,
            sin_crank_angle_1,
            sin_coupler_angle_1,
            sin_crank_angle_2,
            sin_coupler_angle_2,
            sin_crank_angle_3,
            sin_coupler_angle_3,
            ],
            [cos_crank_angle_0,
            cos_crank_angle_1,
            cos_coupler_angle_1,
            cos_crank_angle_2,
            cos_coupler_angle_2,
            cos_crank_angle_3,
            cos_coupler_angle_3,
            ],
        ) = S::sin_cos_each([
            crank_angle_0,
            crank_angle_1,
            coupler_angle_1,
            crank_angle_2,
            coupler_angle_2,
            crank_angle_3,
            coupler_angle_3,
        ]);
        let w = (self.l * cos_crank_angle_1).abs();
        let abs_crank_1_tip_y = (self.l * sin_crank_angle_1).abs();
        let w_2 = (self.l * cos_crank_angle_2).abs();
        let abs_crank_2_tip_y = (self.l * sin_crank_angle_2).abs();
        [
            abs_l + (self.l * cos_crank_angle_0).abs() + w
                + (self.l * cos_coupler_angle_1).abs(),
            (self.l * sin_crank_angle_0).abs() + abs_crank_1_tip_y
                + (self.l * sin_coupler_angle_1).abs(),
            abs_l + w + w_2 + (self.l * cos_coupler_angle_2).abs(),
            abs_crank_1_tip_y + abs_crank_2_tip_y + (self.l * sin_coupler_angle_2).abs(),
            abs_l + w_2 + (self.l * cos_crank_angle_3).abs()
                + (self.l * cos_coupler_angle_3).abs(),
            abs_crank_2_tip_y + (self.l * sin_crank_angle_3).abs()
                + (self.l * sin_coupler_angle_3).abs(),
        ]
    }
    /// Constraint Jacobian `C_q`, 6 x 7: units of each constraint per unit of each coordinate.
    ///
    /// Operations: 9 additions, 14 multiplications, 7 sine-cosine pairs.
    #[inline]
    pub fn constraint_jacobian(&self, t: S, q: &[S; 7]) -> [[S; 7]; 6] {
        let [crank_angle_0, crank_angle_1, crank_angle_2, crank_angle_3, coupler_angle_1,
        coupler_angle_2, coupler_angle_3] = *q;
        let (
            [sin_crank_angle_0,
            sin_coupler_angle_1,
            sin_crank_angle_1,
            sin_coupler_angle_2,
            sin_crank_angle_2,
            sin_coupler_angle_3,
            sin_crank_angle_3,
            ],
            [cos_crank_angle_0,
            cos_coupler_angle_1,
            cos_crank_angle_1,
            cos_coupler_angle_2,
            cos_crank_angle_2,
            cos_coupler_angle_3,
            cos_crank_angle_3,
            ],
        ) = S::sin_cos_each([
            crank_angle_0,
            coupler_angle_1,
            crank_angle_1,
            coupler_angle_2,
            crank_angle_2,
            coupler_angle_3,
            crank_angle_3,
        ]);
        let crank_1_tip_y = self.l * sin_crank_angle_1;
        let minus_loop_1_y_by_crank_angle_1 = self.l * cos_crank_angle_1;
        let crank_2_tip_y = self.l * sin_crank_angle_2;
        let minus_loop_2_y_by_crank_angle_2 = self.l * cos_crank_angle_2;
        [
            [
                -(self.l * sin_crank_angle_0),
                crank_1_tip_y,
                S::from_f64(0.0),
                S::from_f64(0.0),
                -(self.l * sin_coupler_angle_1),
                S::from_f64(0.0),
                S::from_f64(0.0),
            ],
            [
                self.l * cos_crank_angle_0,
                -minus_loop_1_y_by_crank_angle_1,
                S::from_f64(0.0),
                S::from_f64(0.0),
                self.l * cos_coupler_angle_1,
                S::from_f64(0.0),
                S::from_f64(0.0),
            ],
            [
                S::from_f64(0.0),
                -crank_1_tip_y,
                crank_2_tip_y,
                S::from_f64(0.0),
                S::from_f64(0.0),
                -(self.l * sin_coupler_angle_2),
                S::from_f64(0.0),
            ],
            [
                S::from_f64(0.0),
                minus_loop_1_y_by_crank_angle_1,
                -minus_loop_2_y_by_crank_angle_2,
                S::from_f64(0.0),
                S::from_f64(0.0),
                self.l * cos_coupler_angle_2,
                S::from_f64(0.0),
            ],
            [
                S::from_f64(0.0),
                S::from_f64(0.0),
                -crank_2_tip_y,
                self.l * sin_crank_angle_3,
                S::from_f64(0.0),
                S::from_f64(0.0),
                -(self.l * sin_coupler_angle_3),
            ],
            [
                S::from_f64(0.0),
                S::from_f64(0.0),
                minus_loop_2_y_by_crank_angle_2,
                -(self.l * cos_crank_angle_3),
                S::from_f64(0.0),
                S::from_f64(0.0),
                self.l * cos_coupler_angle_3,
            ],
        ]
    }
    /// `C_t`, 6, units of `C` per second: the speeds obey `C_q q' + C_t = 0`.
    ///
    /// Operations: none.
    #[inline]
    pub fn constraint_time_derivative(&self, t: S, q: &[S; 7]) -> [S; 6] {
        [
            S::from_f64(0.0),
            S::from_f64(0.0),
            S::from_f64(0.0),
            S::from_f64(0.0),
            S::from_f64(0.0),
            S::from_f64(0.0),
        ]
    }
    /// `(C_q q' + C_t)_q q' + (..)_t`, 6, units of `C` per second squared: the part of `C''` without accelerations.
    ///
    /// Operations: 12 additions, 27 multiplications, 7 sine-cosine pairs.
    #[inline]
    pub fn constraint_convective(&self, t: S, q: &[S; 7], qd: &[S; 7]) -> [S; 6] {
        let [crank_angle_0, crank_angle_1, crank_angle_2, crank_angle_3, coupler_angle_1,
        coupler_angle_2, coupler_angle_3] = *q;
        let [crank_angle_0_dot, crank_angle_1_dot, crank_angle_2_dot, crank_angle_3_dot,
        coupler_angle_1_dot, coupler_angle_2_dot, coupler_angle_3_dot] = *qd;
        let crank_angle_1_dot_squared = crank_angle_1_dot * crank_angle_1_dot;
        let (
            [sin_crank_angle_0,
            sin_crank_angle_1,
            sin_coupler_angle_1,
            sin_crank_angle_2,
            sin_coupler_angle_2,
            sin_crank_angle_3,
            sin_coupler_angle_3,
            ],
            [cos_crank_angle_0,
            cos_crank_angle_1,
            cos_coupler_angle_1,
            cos_crank_angle_2,
            cos_coupler_angle_2,
            cos_crank_angle_3,
            cos_coupler_angle_3,
            ],
        ) = S::sin_cos_each([
            crank_angle_0,
            crank_angle_1,
            coupler_angle_1,
            crank_angle_2,
            coupler_angle_2,
            crank_angle_3,
            coupler_angle_3,
        ]);
        let w = crank_angle_1_dot_squared * cos_crank_angle_1;
        let crank_angle_0_dot_squared = crank_angle_0_dot * crank_angle_0_dot;
        let coupler_angle_1_dot_squared = coupler_angle_1_dot * coupler_angle_1_dot;
        let w_2 = crank_angle_1_dot_squared * sin_crank_angle_1;
        let crank_angle_2_dot_squared = crank_angle_2_dot * crank_angle_2_dot;
        let w_3 = crank_angle_2_dot_squared * cos_crank_angle_2;
        let coupler_angle_2_dot_squared = coupler_angle_2_dot * coupler_angle_2_dot;
        let w_4 = crank_angle_2_dot_squared * sin_crank_angle_2;
        let crank_angle_3_dot_squared = crank_angle_3_dot * crank_angle_3_dot;
        let coupler_angle_3_dot_squared = coupler_angle_3_dot * coupler_angle_3_dot;
        [
            self.l
                * (w - crank_angle_0_dot_squared * cos_crank_angle_0
                    - coupler_angle_1_dot_squared * cos_coupler_angle_1),
            self.l
                * (w_2 - crank_angle_0_dot_squared * sin_crank_angle_0
                    - coupler_angle_1_dot_squared * sin_coupler_angle_1),
            self.l * (w_3 - w - coupler_angle_2_dot_squared * cos_coupler_angle_2),
            self.l * (w_4 - w_2 - coupler_angle_2_dot_squared * sin_coupler_angle_2),
            self.l
                * (crank_angle_3_dot_squared * cos_crank_angle_3 - w_3
                    - coupler_angle_3_dot_squared * cos_coupler_angle_3),
            self.l
                * (crank_angle_3_dot_squared * sin_crank_angle_3 - w_4
                    - coupler_angle_3_dot_squared * sin_coupler_angle_3),
        ]
    }
    /// `C` (6), `C_q` (6 x 7) and `C_t` (6) together, in SI units, for projection.
    ///
    /// Operations: 24 additions, 20 multiplications, 7 sine-cosine pairs.
    #[inline]
    pub fn constraint_linearization(
        &self,
        t: S,
        q: &[S; 7],
    ) -> sim_kernel::ConstraintLinearization<[S; 6], [[S; 7]; 6]> {
        let [crank_angle_0, crank_angle_1, crank_angle_2, crank_angle_3, coupler_angle_1,
        coupler_angle_2, coupler_angle_3] = *q;
        let (
            [sin_crank_angle_0,
            sin_crank_angle_1,
            sin_coupler_angle_1,
            sin_crank_angle_2,
            sin_coupler_angle_2,
            sin_crank_angle_3,
            sin_coupler_angle_3,
            ],
            [cos_crank_angle_0,
            cos_crank_angle_1,
            cos_coupler_angle_1,
            cos_crank_angle_2,
            cos_coupler_angle_2,
            cos_crank_angle_3,
            cos_coupler_angle_3,
            ],
        ) = S::sin_cos_each([
            crank_angle_0,
            crank_angle_1,
            coupler_angle_1,
            crank_angle_2,
            coupler_angle_2,
            crank_angle_3,
            coupler_angle_3,
        ]);
        let crank_1_tip_y = self.l * sin_crank_angle_1;
        let minus_loop_1_y_by_crank_angle_1 = self.l * cos_crank_angle_1;
        let crank_2_tip_y = self.l * sin_crank_angle_2;
        let minus_loop_2_y_by_crank_angle_2 = self.l * cos_crank_angle_2;
        sim_kernel::ConstraintLinearization {
            values: [
                self.l
                    * (cos_crank_angle_0 - S::from_f64(1.0) - cos_crank_angle_1
                        + cos_coupler_angle_1),
                self.l * (sin_crank_angle_0 - sin_crank_angle_1 + sin_coupler_angle_1),
                self.l
                    * (cos_crank_angle_1 - S::from_f64(1.0) - cos_crank_angle_2
                        + cos_coupler_angle_2),
                self.l * (sin_crank_angle_1 - sin_crank_angle_2 + sin_coupler_angle_2),
                self.l
                    * (cos_crank_angle_2 - S::from_f64(1.0) - cos_crank_angle_3
                        + cos_coupler_angle_3),
                self.l * (sin_crank_angle_2 - sin_crank_angle_3 + sin_coupler_angle_3),
            ],
            jacobian: [
                [
                    -(self.l * sin_crank_angle_0),
                    crank_1_tip_y,
                    S::from_f64(0.0),
                    S::from_f64(0.0),
                    -(self.l * sin_coupler_angle_1),
                    S::from_f64(0.0),
                    S::from_f64(0.0),
                ],
                [
                    self.l * cos_crank_angle_0,
                    -minus_loop_1_y_by_crank_angle_1,
                    S::from_f64(0.0),
                    S::from_f64(0.0),
                    self.l * cos_coupler_angle_1,
                    S::from_f64(0.0),
                    S::from_f64(0.0),
                ],
                [
                    S::from_f64(0.0),
                    -crank_1_tip_y,
                    crank_2_tip_y,
                    S::from_f64(0.0),
                    S::from_f64(0.0),
                    -(self.l * sin_coupler_angle_2),
                    S::from_f64(0.0),
                ],
                [
                    S::from_f64(0.0),
                    minus_loop_1_y_by_crank_angle_1,
                    -minus_loop_2_y_by_crank_angle_2,
                    S::from_f64(0.0),
                    S::from_f64(0.0),
                    self.l * cos_coupler_angle_2,
                    S::from_f64(0.0),
                ],
                [
                    S::from_f64(0.0),
                    S::from_f64(0.0),
                    -crank_2_tip_y,
                    self.l * sin_crank_angle_3,
                    S::from_f64(0.0),
                    S::from_f64(0.0),
                    -(self.l * sin_coupler_angle_3),
                ],
                [
                    S::from_f64(0.0),
                    S::from_f64(0.0),
                    minus_loop_2_y_by_crank_angle_2,
                    -(self.l * cos_crank_angle_3),
                    S::from_f64(0.0),
                    S::from_f64(0.0),
                    self.l * cos_coupler_angle_3,
                ],
            ],
            time_derivative: [
                S::from_f64(0.0),
                S::from_f64(0.0),
                S::from_f64(0.0),
                S::from_f64(0.0),
                S::from_f64(0.0),
                S::from_f64(0.0),
            ],
        }
    }
    /// Kinetic energy `v' M v / 2`, in joules.
    ///
    /// Operations: 18 additions, 41 multiplications, 6 sine-cosine pairs.
    #[inline]
    pub fn kinetic_energy(&self, t: S, q: &[S; 7], qd: &[S; 7]) -> S {
        let [crank_angle_0, crank_angle_1, crank_angle_2, _, coupler_angle_1,
        coupler_angle_2, coupler_angle_3] = *q;
        let [crank_angle_0_dot, crank_angle_1_dot, crank_angle_2_dot, crank_angle_3_dot,
        coupler_angle_1_dot, coupler_angle_2_dot, coupler_angle_3_dot] = *qd;
        let (
            [sin_crank_angle_0,
            sin_coupler_angle_1,
            sin_crank_angle_1,
            sin_coupler_angle_2,
            sin_crank_angle_2,
            sin_coupler_angle_3,
            ],
            [cos_crank_angle_0,
            cos_coupler_angle_1,
            cos_crank_angle_1,
            cos_coupler_angle_2,
            cos_crank_angle_2,
            cos_coupler_angle_3,
            ],
        ) = S::sin_cos_each([
            crank_angle_0,
            coupler_angle_1,
            crank_angle_1,
            coupler_angle_2,
            crank_angle_2,
            coupler_angle_3,
        ]);
        let w = self.l * S::from_f64(2.0);
        let w_2 = crank_angle_0_dot * w;
        let w_3 = self.l * coupler_angle_1_dot;
        let w_4 = sin_crank_angle_0 * w_2 + sin_coupler_angle_1 * w_3;
        let w_5 = w_2 * cos_crank_angle_0 + w_3 * cos_coupler_angle_1;
        let w_6 = crank_angle_1_dot * w;
        let w_7 = self.l * coupler_angle_2_dot;
        let w_8 = sin_crank_angle_1 * w_6 + sin_coupler_angle_2 * w_7;
        let w_9 = w_6 * cos_crank_angle_1 + w_7 * cos_coupler_angle_2;
        let w_10 = crank_angle_2_dot * w;
        let w_11 = self.l * coupler_angle_3_dot;
        let w_12 = sin_crank_angle_2 * w_10 + sin_coupler_angle_3 * w_11;
        let w_13 = w_10 * cos_crank_angle_2 + w_11 * cos_coupler_angle_3;
        let w_14 = self.m * S::from_f64(0.125)
            * (w_4 * w_4 + w_5 * w_5 + w_8 * w_8 + w_9 * w_9 + w_12 * w_12
                + w_13 * w_13);
        let l_squared = self.l * self.l;
        let w_15 = S::from_f64(0.16666666666666666) * l_squared * self.m
            * (crank_angle_0_dot * crank_angle_0_dot
                + crank_angle_1_dot * crank_angle_1_dot
                + crank_angle_2_dot * crank_angle_2_dot
                + crank_angle_3_dot * crank_angle_3_dot);
        w_14 + w_15
            + l_squared * self.m * S::from_f64(0.041666666666666664)
                * (coupler_angle_1_dot * coupler_angle_1_dot
                    + coupler_angle_2_dot * coupler_angle_2_dot
                    + coupler_angle_3_dot * coupler_angle_3_dot)
    }
    /// Power of loads and drives, `F' v + lambda' C_t + T_t' (M x'' - F)`, in watts.
    ///
    /// Operations: 10 additions, 23 multiplications, 7 sine-cosine pairs.
    #[inline]
    pub fn power(
        &self,
        t: S,
        q: &[S; 7],
        qd: &[S; 7],
        qdd: &[S; 7],
        lambda: &[S; 6],
    ) -> S {
        let [crank_angle_0, crank_angle_1, crank_angle_2, crank_angle_3, coupler_angle_1,
        coupler_angle_2, coupler_angle_3] = *q;
        let [crank_angle_0_dot, crank_angle_1_dot, crank_angle_2_dot, crank_angle_3_dot,
        coupler_angle_1_dot, coupler_angle_2_dot, coupler_angle_3_dot] = *qd;
        let w = S::from_f64(0.5) * self.m;
        let (
            [_,
            _,
            _,
            _,
            _,
            _,
            _,
            ],
            [cos_crank_angle_0,
            cos_crank_angle_1,
            cos_crank_angle_2,
            cos_crank_angle_3,
            cos_coupler_angle_1,
            cos_coupler_angle_2,
            cos_coupler_angle_3,
            ],
        ) = S::sin_cos_each([
            crank_angle_0,
            crank_angle_1,
            crank_angle_2,
            crank_angle_3,
            coupler_angle_1,
            coupler_angle_2,
            coupler_angle_3,
        ]);
        let w_2 = self.l * S::from_f64(2.0);
        let w_3 = crank_angle_2_dot * cos_crank_angle_2 * w_2
            + self.l * coupler_angle_3_dot * cos_coupler_angle_3;
        let w_4 = self.g * w
            * (crank_angle_0_dot * cos_crank_angle_0 * w_2
                + self.l * coupler_angle_1_dot * cos_coupler_angle_1
                + (crank_angle_1_dot * cos_crank_angle_1 * w_2
                    + self.l * coupler_angle_2_dot * cos_coupler_angle_2) + w_3);
        -(self.l * self.g * w
            * (crank_angle_0_dot * cos_crank_angle_0
                + crank_angle_1_dot * cos_crank_angle_1
                + crank_angle_2_dot * cos_crank_angle_2
                + crank_angle_3_dot * cos_crank_angle_3) + w_4)
    }
    /// Outputs, 4, in SI units.
    ///
    /// Operations: none.
    #[inline]
    pub fn outputs(
        &self,
        t: S,
        q: &[S; 7],
        qd: &[S; 7],
        qdd: &[S; 7],
        lambda: &[S; 6],
    ) -> FourBarsOutputs<S> {
        let [crank_angle_0, _, _, crank_angle_3, _, _, _] = *q;
        let [_, _, _, _, lambda_loop_3_x, lambda_loop_3_y] = *lambda;
        [crank_angle_0, crank_angle_3, lambda_loop_3_x, lambda_loop_3_y].into()
    }
    /// Rates of the outputs that depend on neither accelerations nor multipliers, 2, in SI units per second.
    ///
    /// Operations: none.
    #[inline]
    pub fn output_rates(
        &self,
        t: S,
        q: &[S; 7],
        qd: &[S; 7],
        qdd: &[S; 7],
    ) -> FourBarsOutputRates<S> {
        let [crank_angle_0_dot, _, _, crank_angle_3_dot, _, _, _] = *qd;
        [crank_angle_0_dot, crank_angle_3_dot].into()
    }
    /// `left - right` of each event, 1, in SI units: zero when it happens.
    ///
    /// Operations: none.
    #[inline]
    pub fn events(
        &self,
        t: S,
        q: &[S; 7],
        qd: &[S; 7],
        qdd: &[S; 7],
        lambda: &[S; 6],
    ) -> [S; 1] {
        let [crank_angle_0_dot, _, _, _, _, _, _] = *qd;
        [crank_angle_0_dot]
    }
    /// The numbers of each shape of the drawing, in metres and radians.
    ///
    /// Operations: 11 additions, 16 multiplications, 7 sine-cosine pairs.
    #[inline]
    pub fn drawing(&self, t: S, q: &[S; 7]) -> [S; 42] {
        let [crank_angle_0, crank_angle_1, crank_angle_2, crank_angle_3, coupler_angle_1,
        coupler_angle_2, coupler_angle_3] = *q;
        let (
            [sin_crank_angle_0,
            sin_crank_angle_1,
            sin_crank_angle_2,
            sin_crank_angle_3,
            sin_coupler_angle_1,
            sin_coupler_angle_2,
            sin_coupler_angle_3,
            ],
            [cos_crank_angle_0,
            cos_crank_angle_1,
            cos_crank_angle_2,
            cos_crank_angle_3,
            cos_coupler_angle_1,
            cos_coupler_angle_2,
            cos_coupler_angle_3,
            ],
        ) = S::sin_cos_each([
            crank_angle_0,
            crank_angle_1,
            crank_angle_2,
            crank_angle_3,
            coupler_angle_1,
            coupler_angle_2,
            coupler_angle_3,
        ]);
        let crank_0_tip_x = self.l * cos_crank_angle_0;
        let crank_0_tip_y = self.l * sin_crank_angle_0;
        let crank_1_tip_x = self.l * (S::from_f64(1.0) + cos_crank_angle_1);
        let crank_1_tip_y = self.l * sin_crank_angle_1;
        let crank_2_base_x = self.l * S::from_f64(2.0);
        let crank_2_tip_x = crank_2_base_x + self.l * cos_crank_angle_2;
        let crank_2_tip_y = self.l * sin_crank_angle_2;
        let crank_3_base_x = self.l * S::from_f64(3.0);
        let crank_3_tip_x = crank_3_base_x + self.l * cos_crank_angle_3;
        let crank_3_tip_y = self.l * sin_crank_angle_3;
        [
            S::from_f64(0.0),
            S::from_f64(0.0),
            crank_0_tip_x,
            crank_0_tip_y,
            S::from_f64(0.0),
            S::from_f64(0.0),
            self.l,
            S::from_f64(0.0),
            crank_1_tip_x,
            crank_1_tip_y,
            self.l,
            S::from_f64(0.0),
            crank_2_base_x,
            S::from_f64(0.0),
            crank_2_tip_x,
            crank_2_tip_y,
            crank_2_base_x,
            S::from_f64(0.0),
            crank_3_base_x,
            S::from_f64(0.0),
            crank_3_tip_x,
            crank_3_tip_y,
            crank_3_base_x,
            S::from_f64(0.0),
            crank_0_tip_x,
            crank_0_tip_y,
            self.l * (cos_crank_angle_0 + cos_coupler_angle_1),
            self.l * (sin_crank_angle_0 + sin_coupler_angle_1),
            crank_1_tip_x,
            crank_1_tip_y,
            crank_1_tip_x,
            crank_1_tip_y,
            self.l * (S::from_f64(1.0) + cos_crank_angle_1 + cos_coupler_angle_2),
            self.l * (sin_crank_angle_1 + sin_coupler_angle_2),
            crank_2_tip_x,
            crank_2_tip_y,
            crank_2_tip_x,
            crank_2_tip_y,
            self.l * (cos_crank_angle_2 + cos_coupler_angle_3) + crank_2_base_x,
            self.l * (sin_crank_angle_2 + sin_coupler_angle_3),
            crank_3_tip_x,
            crank_3_tip_y,
        ]
    }
    /// Declared start: values or guesses of the coordinates (7), and speeds (7), in SI units; 0 where nothing is declared.
    ///
    /// Operations: none.
    #[inline]
    pub fn initial(&self) -> sim_kernel::Initial<[S; 7]> {
        sim_kernel::Initial {
            positions: [
                self.start,
                self.start,
                self.start,
                self.start,
                S::from_f64(0.0),
                S::from_f64(0.0),
                S::from_f64(0.0),
            ],
            speeds: [
                S::from_f64(0.0),
                S::from_f64(0.0),
                S::from_f64(0.0),
                S::from_f64(0.0),
                S::from_f64(0.0),
                S::from_f64(0.0),
                S::from_f64(0.0),
            ],
        }
    }
    /// [`FourBarsPrepared::dynamics`] once; for many calls with the same parameters [`Self::prepare`] first.
    #[inline]
    pub fn dynamics(
        &self,
        t: S,
        q: &[S; 7],
        qd: &[S; 7],
    ) -> sim_kernel::Dynamics<S, [S; 7], [S; 6]> {
        self.prepare().dynamics(t, q, qd)
    }
    /// [`FourBarsPrepared::dynamics_jacobian`] once; for many calls with the same parameters [`Self::prepare`] first.
    #[inline]
    pub fn dynamics_jacobian(
        &self,
        t: S,
        q: &[S; 7],
        qd: &[S; 7],
    ) -> sim_kernel::DynamicsJacobian<S, [[S; 7]; 7], [[S; 7]; 6]> {
        self.prepare().dynamics_jacobian(t, q, qd)
    }
}
#[allow(non_snake_case, unused_variables, unused_parens, clippy::all, clippy::pedantic)]
impl<S: sim_kernel::Scalar> FourBarsPrepared<S> {
    /// Accelerations (7), multipliers (6) and power, from
    ///
    /// ```text
    /// [ T_q' M T_q   C_q' ] [ q''    ]   [ T_q' (F - M g)                      ]
    /// [ C_q          0    ] [ lambda ] = [ -(C_q q' + C_t)_q q' - (..)_t       ]
    /// ```
    ///
    /// by an elimination planned from the structure of the system. Where `refused` is set a pivot was too small and nothing else holds: solve that state from the other kernels.
    ///
    /// Operations: 149 additions, 259 multiplications, 9 divisions, 7 sine-cosine pairs.
    #[inline(always)]
    pub fn dynamics(
        &self,
        t: S,
        q: &[S; 7],
        qd: &[S; 7],
    ) -> sim_kernel::Dynamics<S, [S; 7], [S; 6]> {
        let [crank_angle_0, crank_angle_1, crank_angle_2, crank_angle_3, coupler_angle_1,
        coupler_angle_2, coupler_angle_3] = *q;
        let [crank_angle_0_dot, crank_angle_1_dot, crank_angle_2_dot, crank_angle_3_dot,
        coupler_angle_1_dot, coupler_angle_2_dot, coupler_angle_3_dot] = *qd;
        let (
            [sin_crank_angle_0,
            sin_coupler_angle_1,
            sin_crank_angle_1,
            sin_coupler_angle_2,
            sin_crank_angle_2,
            sin_coupler_angle_3,
            sin_crank_angle_3,
            ],
            [cos_crank_angle_0,
            cos_coupler_angle_1,
            cos_crank_angle_1,
            cos_coupler_angle_2,
            cos_crank_angle_2,
            cos_coupler_angle_3,
            cos_crank_angle_3,
            ],
        ) = S::sin_cos_each([
            crank_angle_0,
            coupler_angle_1,
            crank_angle_1,
            coupler_angle_2,
            crank_angle_2,
            coupler_angle_3,
            crank_angle_3,
        ]);
        let coupler_angle_1_dot_squared = coupler_angle_1_dot * coupler_angle_1_dot;
        let w = sin_coupler_angle_1 * self.k;
        let w_2 = sin_crank_angle_0 * self.k;
        let w_3 = cos_coupler_angle_1 * coupler_angle_1_dot_squared;
        let rhs_crank_angle_0 = cos_crank_angle_0
            * (coupler_angle_1_dot_squared * w - self.k_4) - w_2 * w_3;
        let crank_angle_1_dot_squared = crank_angle_1_dot * crank_angle_1_dot;
        let w_4 = self.k * sin_crank_angle_1;
        let w_5 = self.k * sin_coupler_angle_2;
        let w_6 = cos_crank_angle_1 * crank_angle_1_dot_squared;
        let rhs_coupler_angle_2 = cos_coupler_angle_2
            * (crank_angle_1_dot_squared * w_4 - self.k_5) - w_5 * w_6;
        let crank_angle_2_dot_squared = crank_angle_2_dot * crank_angle_2_dot;
        let w_7 = self.k * sin_crank_angle_2;
        let w_8 = self.k * sin_coupler_angle_3;
        let w_9 = cos_crank_angle_2 * crank_angle_2_dot_squared;
        let rhs_coupler_angle_3 = cos_coupler_angle_3
            * (crank_angle_2_dot_squared * w_7 - self.k_5) - w_8 * w_9;
        let crank_angle_0_dot_squared = crank_angle_0_dot * crank_angle_0_dot;
        let w_10 = cos_crank_angle_0 * crank_angle_0_dot_squared;
        let mass_coupler_angle_1_crank_angle_0 = self.k
            * (sin_crank_angle_0 * sin_coupler_angle_1
                + cos_crank_angle_0 * cos_coupler_angle_1);
        let l_coupler_angle_1_crank_angle_0 = mass_coupler_angle_1_crank_angle_0
            * self.inverse_crank_angle_0;
        let rhs_coupler_angle_1 = cos_coupler_angle_1
            * (crank_angle_0_dot_squared * w_2 - self.k_5) - w * w_10
            - rhs_crank_angle_0 * l_coupler_angle_1_crank_angle_0;
        let coupler_angle_2_dot_squared = coupler_angle_2_dot * coupler_angle_2_dot;
        let w_11 = cos_coupler_angle_2 * coupler_angle_2_dot_squared;
        let mass_coupler_angle_2_crank_angle_1 = self.k
            * (sin_crank_angle_1 * sin_coupler_angle_2
                + cos_crank_angle_1 * cos_coupler_angle_2);
        let l_crank_angle_1_coupler_angle_2 = mass_coupler_angle_2_crank_angle_1
            * self.inverse_coupler_angle_2;
        let rhs_crank_angle_1 = cos_crank_angle_1
            * (coupler_angle_2_dot_squared * w_5 - self.k_4) - w_4 * w_11
            - rhs_coupler_angle_2 * l_crank_angle_1_coupler_angle_2;
        let coupler_angle_3_dot_squared = coupler_angle_3_dot * coupler_angle_3_dot;
        let w_12 = cos_coupler_angle_3 * coupler_angle_3_dot_squared;
        let mass_coupler_angle_3_crank_angle_2 = self.k
            * (sin_crank_angle_2 * sin_coupler_angle_3
                + cos_crank_angle_2 * cos_coupler_angle_3);
        let l_crank_angle_2_coupler_angle_3 = mass_coupler_angle_3_crank_angle_2
            * self.inverse_coupler_angle_2;
        let rhs_crank_angle_2 = cos_crank_angle_2
            * (coupler_angle_3_dot_squared * w_8 - self.k_4) - w_7 * w_12
            - rhs_coupler_angle_3 * l_crank_angle_2_coupler_angle_3;
        let minus_loop_1_x_by_crank_angle_0 = self.l * sin_crank_angle_0;
        let minus_l_lambda_loop_1_x_crank_angle_0 = minus_loop_1_x_by_crank_angle_0
            * self.inverse_crank_angle_0;
        let pivot_coupler_angle_1 = self.mass_crank_angle_3_crank_angle_3
            - mass_coupler_angle_1_crank_angle_0 * l_coupler_angle_1_crank_angle_0;
        let inverse_coupler_angle_1 = S::from_f64(1.0) / pivot_coupler_angle_1;
        let k_lambda_loop_1_x_coupler_angle_1 = mass_coupler_angle_1_crank_angle_0
            * minus_l_lambda_loop_1_x_crank_angle_0 - self.l * sin_coupler_angle_1;
        let l_lambda_loop_1_x_coupler_angle_1 = inverse_coupler_angle_1
            * k_lambda_loop_1_x_coupler_angle_1;
        let crank_1_tip_y = self.l * sin_crank_angle_1;
        let pivot_crank_angle_1 = self.mass_crank_angle_0_crank_angle_0
            - mass_coupler_angle_2_crank_angle_1 * l_crank_angle_1_coupler_angle_2;
        let inverse_crank_angle_1 = S::from_f64(1.0) / pivot_crank_angle_1;
        let l_lambda_loop_1_x_crank_angle_1 = crank_1_tip_y * inverse_crank_angle_1;
        let rhs_lambda_loop_1_x = rhs_crank_angle_0
            * minus_l_lambda_loop_1_x_crank_angle_0 - self.l * (w_6 - w_10 - w_3)
            - l_lambda_loop_1_x_coupler_angle_1 * rhs_coupler_angle_1
            - l_lambda_loop_1_x_crank_angle_1 * rhs_crank_angle_1;
        let minus_loop_3_x_by_coupler_angle_3 = self.l * sin_coupler_angle_3;
        let minus_l_lambda_loop_3_x_coupler_angle_3 = minus_loop_3_x_by_coupler_angle_3
            * self.inverse_coupler_angle_2;
        let crank_angle_3_dot_squared = crank_angle_3_dot * crank_angle_3_dot;
        let minus_rhs_crank_angle_3 = cos_crank_angle_3 * self.k_5;
        let crank_3_tip_y = self.l * sin_crank_angle_3;
        let l_lambda_loop_3_x_crank_angle_3 = crank_3_tip_y
            * self.inverse_coupler_angle_2;
        let pivot_crank_angle_2 = self.mass_crank_angle_0_crank_angle_0
            - mass_coupler_angle_3_crank_angle_2 * l_crank_angle_2_coupler_angle_3;
        let inverse_crank_angle_2 = S::from_f64(1.0) / pivot_crank_angle_2;
        let crank_2_tip_y = self.l * sin_crank_angle_2;
        let k_lambda_loop_3_x_crank_angle_2 = mass_coupler_angle_3_crank_angle_2
            * minus_l_lambda_loop_3_x_coupler_angle_3 - crank_2_tip_y;
        let l_lambda_loop_3_x_crank_angle_2 = inverse_crank_angle_2
            * k_lambda_loop_3_x_crank_angle_2;
        let rhs_lambda_loop_3_x = rhs_coupler_angle_3
            * minus_l_lambda_loop_3_x_coupler_angle_3
            - self.l * (cos_crank_angle_3 * crank_angle_3_dot_squared - w_9 - w_12)
            + minus_rhs_crank_angle_3 * l_lambda_loop_3_x_crank_angle_3
            - l_lambda_loop_3_x_crank_angle_2 * rhs_crank_angle_2;
        let minus_loop_1_y_by_crank_angle_1 = self.l * cos_crank_angle_1;
        let minus_l_lambda_loop_1_y_crank_angle_1 = minus_loop_1_y_by_crank_angle_1
            * inverse_crank_angle_1;
        let w_13 = sin_crank_angle_1 * crank_angle_1_dot_squared;
        let crank_0_tip_x = self.l * cos_crank_angle_0;
        let l_lambda_loop_1_y_crank_angle_0 = crank_0_tip_x * self.inverse_crank_angle_0;
        let loop_1_y_by_coupler_angle_1 = self.l * cos_coupler_angle_1;
        let k_lambda_loop_1_y_coupler_angle_1 = loop_1_y_by_coupler_angle_1
            - mass_coupler_angle_1_crank_angle_0 * l_lambda_loop_1_y_crank_angle_0;
        let l_lambda_loop_1_y_coupler_angle_1 = inverse_coupler_angle_1
            * k_lambda_loop_1_y_coupler_angle_1;
        let minus_pivot_lambda_loop_1_x = minus_loop_1_x_by_crank_angle_0
            * minus_l_lambda_loop_1_x_crank_angle_0
            + k_lambda_loop_1_x_coupler_angle_1 * l_lambda_loop_1_x_coupler_angle_1
            + crank_1_tip_y * l_lambda_loop_1_x_crank_angle_1;
        let minus_inverse_lambda_loop_1_x = S::from_f64(1.0)
            / minus_pivot_lambda_loop_1_x;
        let k_lambda_loop_1_y_lambda_loop_1_x = minus_loop_1_x_by_crank_angle_0
            * l_lambda_loop_1_y_crank_angle_0
            - k_lambda_loop_1_x_coupler_angle_1 * l_lambda_loop_1_y_coupler_angle_1
            + crank_1_tip_y * minus_l_lambda_loop_1_y_crank_angle_1;
        let minus_l_lambda_loop_1_y_lambda_loop_1_x = minus_inverse_lambda_loop_1_x
            * k_lambda_loop_1_y_lambda_loop_1_x;
        let rhs_lambda_loop_1_y = minus_l_lambda_loop_1_y_crank_angle_1
            * rhs_crank_angle_1
            - self.l
                * (w_13 - sin_crank_angle_0 * crank_angle_0_dot_squared
                    - sin_coupler_angle_1 * coupler_angle_1_dot_squared)
            - rhs_crank_angle_0 * l_lambda_loop_1_y_crank_angle_0
            - l_lambda_loop_1_y_coupler_angle_1 * rhs_coupler_angle_1
            + minus_l_lambda_loop_1_y_lambda_loop_1_x * rhs_lambda_loop_1_x;
        let minus_pivot_lambda_loop_3_x = minus_loop_3_x_by_coupler_angle_3
            * minus_l_lambda_loop_3_x_coupler_angle_3
            + crank_3_tip_y * l_lambda_loop_3_x_crank_angle_3
            + k_lambda_loop_3_x_crank_angle_2 * l_lambda_loop_3_x_crank_angle_2;
        let minus_inverse_lambda_loop_3_x = S::from_f64(1.0)
            / minus_pivot_lambda_loop_3_x;
        let loop_3_y_by_coupler_angle_3 = self.l * cos_coupler_angle_3;
        let l_lambda_loop_3_y_coupler_angle_3 = loop_3_y_by_coupler_angle_3
            * self.inverse_coupler_angle_2;
        let minus_loop_3_y_by_crank_angle_3 = self.l * cos_crank_angle_3;
        let minus_l_lambda_loop_3_y_crank_angle_3 = minus_loop_3_y_by_crank_angle_3
            * self.inverse_coupler_angle_2;
        let minus_loop_2_y_by_crank_angle_2 = self.l * cos_crank_angle_2;
        let k_lambda_loop_3_y_crank_angle_2 = minus_loop_2_y_by_crank_angle_2
            - mass_coupler_angle_3_crank_angle_2 * l_lambda_loop_3_y_coupler_angle_3;
        let l_lambda_loop_3_y_crank_angle_2 = inverse_crank_angle_2
            * k_lambda_loop_3_y_crank_angle_2;
        let k_lambda_loop_3_y_lambda_loop_3_x = minus_loop_3_x_by_coupler_angle_3
            * l_lambda_loop_3_y_coupler_angle_3
            + crank_3_tip_y * minus_l_lambda_loop_3_y_crank_angle_3
            - k_lambda_loop_3_x_crank_angle_2 * l_lambda_loop_3_y_crank_angle_2;
        let minus_l_lambda_loop_3_y_lambda_loop_3_x = minus_inverse_lambda_loop_3_x
            * k_lambda_loop_3_y_lambda_loop_3_x;
        let w_14 = sin_crank_angle_2 * crank_angle_2_dot_squared;
        let rhs_lambda_loop_3_y = minus_l_lambda_loop_3_y_lambda_loop_3_x
            * rhs_lambda_loop_3_x
            - self.l
                * (sin_crank_angle_3 * crank_angle_3_dot_squared - w_14
                    - sin_coupler_angle_3 * coupler_angle_3_dot_squared)
            - rhs_coupler_angle_3 * l_lambda_loop_3_y_coupler_angle_3
            - minus_rhs_crank_angle_3 * minus_l_lambda_loop_3_y_crank_angle_3
            - l_lambda_loop_3_y_crank_angle_2 * rhs_crank_angle_2;
        let minus_loop_2_x_by_coupler_angle_2 = self.l * sin_coupler_angle_2;
        let minus_l_lambda_loop_2_x_coupler_angle_2 = minus_loop_2_x_by_coupler_angle_2
            * self.inverse_coupler_angle_2;
        let k_lambda_loop_2_x_crank_angle_1 = mass_coupler_angle_2_crank_angle_1
            * minus_l_lambda_loop_2_x_coupler_angle_2 - crank_1_tip_y;
        let l_lambda_loop_2_x_crank_angle_1 = inverse_crank_angle_1
            * k_lambda_loop_2_x_crank_angle_1;
        let l_lambda_loop_2_x_crank_angle_2 = crank_2_tip_y * inverse_crank_angle_2;
        let minus_k_lambda_loop_2_x_lambda_loop_1_x = crank_1_tip_y
            * l_lambda_loop_2_x_crank_angle_1;
        let l_lambda_loop_2_x_lambda_loop_1_x = minus_k_lambda_loop_2_x_lambda_loop_1_x
            * minus_inverse_lambda_loop_1_x;
        let minus_k_lambda_loop_2_x_lambda_loop_3_x = crank_2_tip_y
            * l_lambda_loop_3_x_crank_angle_2;
        let l_lambda_loop_2_x_lambda_loop_3_x = minus_k_lambda_loop_2_x_lambda_loop_3_x
            * minus_inverse_lambda_loop_3_x;
        let w_15 = crank_0_tip_x * l_lambda_loop_1_y_crank_angle_0
            + k_lambda_loop_1_y_coupler_angle_1 * l_lambda_loop_1_y_coupler_angle_1
            + minus_loop_1_y_by_crank_angle_1 * minus_l_lambda_loop_1_y_crank_angle_1;
        let pivot_lambda_loop_1_y = k_lambda_loop_1_y_lambda_loop_1_x
            * minus_l_lambda_loop_1_y_lambda_loop_1_x - w_15;
        let inverse_lambda_loop_1_y = S::from_f64(1.0) / pivot_lambda_loop_1_y;
        let k_lambda_loop_2_x_lambda_loop_1_y = minus_loop_1_y_by_crank_angle_1
            * l_lambda_loop_2_x_crank_angle_1
            - k_lambda_loop_1_y_lambda_loop_1_x * l_lambda_loop_2_x_lambda_loop_1_x;
        let l_lambda_loop_2_x_lambda_loop_1_y = inverse_lambda_loop_1_y
            * k_lambda_loop_2_x_lambda_loop_1_y;
        let w_16 = loop_3_y_by_coupler_angle_3 * l_lambda_loop_3_y_coupler_angle_3
            + minus_loop_3_y_by_crank_angle_3 * minus_l_lambda_loop_3_y_crank_angle_3
            + k_lambda_loop_3_y_crank_angle_2 * l_lambda_loop_3_y_crank_angle_2;
        let pivot_lambda_loop_3_y = k_lambda_loop_3_y_lambda_loop_3_x
            * minus_l_lambda_loop_3_y_lambda_loop_3_x - w_16;
        let inverse_lambda_loop_3_y = S::from_f64(1.0) / pivot_lambda_loop_3_y;
        let minus_k_lambda_loop_2_x_lambda_loop_3_y = crank_2_tip_y
            * l_lambda_loop_3_y_crank_angle_2
            + minus_k_lambda_loop_2_x_lambda_loop_3_x
                * minus_l_lambda_loop_3_y_lambda_loop_3_x;
        let minus_l_lambda_loop_2_x_lambda_loop_3_y = inverse_lambda_loop_3_y
            * minus_k_lambda_loop_2_x_lambda_loop_3_y;
        let rhs_lambda_loop_2_x = rhs_coupler_angle_2
            * minus_l_lambda_loop_2_x_coupler_angle_2 - self.l * (w_9 - w_6 - w_11)
            - l_lambda_loop_2_x_crank_angle_1 * rhs_crank_angle_1
            - l_lambda_loop_2_x_crank_angle_2 * rhs_crank_angle_2
            - l_lambda_loop_2_x_lambda_loop_1_x * rhs_lambda_loop_1_x
            - l_lambda_loop_2_x_lambda_loop_3_x * rhs_lambda_loop_3_x
            - l_lambda_loop_2_x_lambda_loop_1_y * rhs_lambda_loop_1_y
            + minus_l_lambda_loop_2_x_lambda_loop_3_y * rhs_lambda_loop_3_y;
        let minus_l_lambda_loop_2_y_crank_angle_2 = minus_loop_2_y_by_crank_angle_2
            * inverse_crank_angle_2;
        let loop_2_y_by_coupler_angle_2 = self.l * cos_coupler_angle_2;
        let l_lambda_loop_2_y_coupler_angle_2 = loop_2_y_by_coupler_angle_2
            * self.inverse_coupler_angle_2;
        let k_lambda_loop_2_y_crank_angle_1 = minus_loop_1_y_by_crank_angle_1
            - mass_coupler_angle_2_crank_angle_1 * l_lambda_loop_2_y_coupler_angle_2;
        let l_lambda_loop_2_y_crank_angle_1 = inverse_crank_angle_1
            * k_lambda_loop_2_y_crank_angle_1;
        let minus_k_lambda_loop_2_y_lambda_loop_1_x = crank_1_tip_y
            * l_lambda_loop_2_y_crank_angle_1;
        let l_lambda_loop_2_y_lambda_loop_1_x = minus_k_lambda_loop_2_y_lambda_loop_1_x
            * minus_inverse_lambda_loop_1_x;
        let k_lambda_loop_2_y_lambda_loop_3_x = minus_loop_2_y_by_crank_angle_2
            * l_lambda_loop_3_x_crank_angle_2;
        let minus_l_lambda_loop_2_y_lambda_loop_3_x = k_lambda_loop_2_y_lambda_loop_3_x
            * minus_inverse_lambda_loop_3_x;
        let k_lambda_loop_2_y_lambda_loop_1_y = minus_loop_1_y_by_crank_angle_1
            * l_lambda_loop_2_y_crank_angle_1
            - k_lambda_loop_1_y_lambda_loop_1_x * l_lambda_loop_2_y_lambda_loop_1_x;
        let l_lambda_loop_2_y_lambda_loop_1_y = inverse_lambda_loop_1_y
            * k_lambda_loop_2_y_lambda_loop_1_y;
        let k_lambda_loop_2_y_lambda_loop_3_y = minus_loop_2_y_by_crank_angle_2
            * l_lambda_loop_3_y_crank_angle_2
            + k_lambda_loop_2_y_lambda_loop_3_x
                * minus_l_lambda_loop_3_y_lambda_loop_3_x;
        let l_lambda_loop_2_y_lambda_loop_3_y = inverse_lambda_loop_3_y
            * k_lambda_loop_2_y_lambda_loop_3_y;
        let w_17 = minus_loop_2_x_by_coupler_angle_2
            * minus_l_lambda_loop_2_x_coupler_angle_2
            + k_lambda_loop_2_x_crank_angle_1 * l_lambda_loop_2_x_crank_angle_1
            + crank_2_tip_y * l_lambda_loop_2_x_crank_angle_2;
        let pivot_lambda_loop_2_x = minus_k_lambda_loop_2_x_lambda_loop_1_x
            * l_lambda_loop_2_x_lambda_loop_1_x - w_17
            + minus_k_lambda_loop_2_x_lambda_loop_3_x * l_lambda_loop_2_x_lambda_loop_3_x
            - k_lambda_loop_2_x_lambda_loop_1_y * l_lambda_loop_2_x_lambda_loop_1_y
            - minus_k_lambda_loop_2_x_lambda_loop_3_y
                * minus_l_lambda_loop_2_x_lambda_loop_3_y;
        let inverse_lambda_loop_2_x = S::from_f64(1.0) / pivot_lambda_loop_2_x;
        let k_lambda_loop_2_y_lambda_loop_2_x = minus_loop_2_x_by_coupler_angle_2
            * l_lambda_loop_2_y_coupler_angle_2
            - k_lambda_loop_2_x_crank_angle_1 * l_lambda_loop_2_y_crank_angle_1
            + crank_2_tip_y * minus_l_lambda_loop_2_y_crank_angle_2
            + minus_k_lambda_loop_2_x_lambda_loop_1_x * l_lambda_loop_2_y_lambda_loop_1_x
            - minus_k_lambda_loop_2_x_lambda_loop_3_x
                * minus_l_lambda_loop_2_y_lambda_loop_3_x
            - k_lambda_loop_2_x_lambda_loop_1_y * l_lambda_loop_2_y_lambda_loop_1_y
            + minus_k_lambda_loop_2_x_lambda_loop_3_y
                * l_lambda_loop_2_y_lambda_loop_3_y;
        let l_lambda_loop_2_y_lambda_loop_2_x = inverse_lambda_loop_2_x
            * k_lambda_loop_2_y_lambda_loop_2_x;
        let rhs_lambda_loop_2_y = minus_l_lambda_loop_2_y_crank_angle_2
            * rhs_crank_angle_2
            - self.l * (w_14 - w_13 - sin_coupler_angle_2 * coupler_angle_2_dot_squared)
            - rhs_coupler_angle_2 * l_lambda_loop_2_y_coupler_angle_2
            - l_lambda_loop_2_y_crank_angle_1 * rhs_crank_angle_1
            - l_lambda_loop_2_y_lambda_loop_1_x * rhs_lambda_loop_1_x
            + minus_l_lambda_loop_2_y_lambda_loop_3_x * rhs_lambda_loop_3_x
            - l_lambda_loop_2_y_lambda_loop_1_y * rhs_lambda_loop_1_y
            - l_lambda_loop_2_y_lambda_loop_3_y * rhs_lambda_loop_3_y
            - l_lambda_loop_2_y_lambda_loop_2_x * rhs_lambda_loop_2_x;
        let w_18 = loop_2_y_by_coupler_angle_2 * l_lambda_loop_2_y_coupler_angle_2
            + k_lambda_loop_2_y_crank_angle_1 * l_lambda_loop_2_y_crank_angle_1
            + minus_loop_2_y_by_crank_angle_2 * minus_l_lambda_loop_2_y_crank_angle_2;
        let pivot_lambda_loop_2_y = minus_k_lambda_loop_2_y_lambda_loop_1_x
            * l_lambda_loop_2_y_lambda_loop_1_x - w_18
            + k_lambda_loop_2_y_lambda_loop_3_x * minus_l_lambda_loop_2_y_lambda_loop_3_x
            - k_lambda_loop_2_y_lambda_loop_1_y * l_lambda_loop_2_y_lambda_loop_1_y
            - k_lambda_loop_2_y_lambda_loop_3_y * l_lambda_loop_2_y_lambda_loop_3_y
            - k_lambda_loop_2_y_lambda_loop_2_x * l_lambda_loop_2_y_lambda_loop_2_x;
        let lambda_loop_2_y = S::from_f64(1.0) / pivot_lambda_loop_2_y
            * rhs_lambda_loop_2_y;
        let lambda_loop_2_x = inverse_lambda_loop_2_x * rhs_lambda_loop_2_x
            - l_lambda_loop_2_y_lambda_loop_2_x * lambda_loop_2_y;
        let lambda_loop_1_y = inverse_lambda_loop_1_y * rhs_lambda_loop_1_y
            - l_lambda_loop_2_x_lambda_loop_1_y * lambda_loop_2_x
            - l_lambda_loop_2_y_lambda_loop_1_y * lambda_loop_2_y;
        let lambda_loop_1_x = minus_l_lambda_loop_1_y_lambda_loop_1_x * lambda_loop_1_y
            - minus_inverse_lambda_loop_1_x * rhs_lambda_loop_1_x
            - l_lambda_loop_2_x_lambda_loop_1_x * lambda_loop_2_x
            - l_lambda_loop_2_y_lambda_loop_1_x * lambda_loop_2_y;
        let coupler_angle_1_ddot = inverse_coupler_angle_1 * rhs_coupler_angle_1
            - l_lambda_loop_1_x_coupler_angle_1 * lambda_loop_1_x
            - l_lambda_loop_1_y_coupler_angle_1 * lambda_loop_1_y;
        let crank_angle_1_ddot = inverse_crank_angle_1 * rhs_crank_angle_1
            - l_lambda_loop_1_x_crank_angle_1 * lambda_loop_1_x
            + minus_l_lambda_loop_1_y_crank_angle_1 * lambda_loop_1_y
            - l_lambda_loop_2_x_crank_angle_1 * lambda_loop_2_x
            - l_lambda_loop_2_y_crank_angle_1 * lambda_loop_2_y;
        let lambda_loop_3_y = inverse_lambda_loop_3_y * rhs_lambda_loop_3_y
            + minus_l_lambda_loop_2_x_lambda_loop_3_y * lambda_loop_2_x
            - l_lambda_loop_2_y_lambda_loop_3_y * lambda_loop_2_y;
        let lambda_loop_3_x = minus_l_lambda_loop_2_y_lambda_loop_3_x * lambda_loop_2_y
            - minus_inverse_lambda_loop_3_x * rhs_lambda_loop_3_x
            - l_lambda_loop_2_x_lambda_loop_3_x * lambda_loop_2_x
            + minus_l_lambda_loop_3_y_lambda_loop_3_x * lambda_loop_3_y;
        let crank_angle_2_ddot = inverse_crank_angle_2 * rhs_crank_angle_2
            - l_lambda_loop_2_x_crank_angle_2 * lambda_loop_2_x
            + minus_l_lambda_loop_2_y_crank_angle_2 * lambda_loop_2_y
            - l_lambda_loop_3_x_crank_angle_2 * lambda_loop_3_x
            - l_lambda_loop_3_y_crank_angle_2 * lambda_loop_3_y;
        let w_19 = cos_crank_angle_0 * crank_angle_0_dot;
        let w_20 = cos_crank_angle_1 * crank_angle_1_dot;
        let w_21 = cos_crank_angle_2 * crank_angle_2_dot;
        let w_22 = self.k_7
            * (self.k_2 * w_19 + loop_1_y_by_coupler_angle_1 * coupler_angle_1_dot
                + (self.k_2 * w_20 + loop_2_y_by_coupler_angle_2 * coupler_angle_2_dot)
                + (self.k_2 * w_21 + loop_3_y_by_coupler_angle_3 * coupler_angle_3_dot));
        sim_kernel::Dynamics {
            accelerations: [
                rhs_crank_angle_0 * self.inverse_crank_angle_0
                    - l_coupler_angle_1_crank_angle_0 * coupler_angle_1_ddot
                    + minus_l_lambda_loop_1_x_crank_angle_0 * lambda_loop_1_x
                    - l_lambda_loop_1_y_crank_angle_0 * lambda_loop_1_y,
                crank_angle_1_ddot,
                crank_angle_2_ddot,
                minus_l_lambda_loop_3_y_crank_angle_3 * lambda_loop_3_y
                    - minus_rhs_crank_angle_3 * self.inverse_coupler_angle_2
                    - l_lambda_loop_3_x_crank_angle_3 * lambda_loop_3_x,
                coupler_angle_1_ddot,
                rhs_coupler_angle_2 * self.inverse_coupler_angle_2
                    - l_crank_angle_1_coupler_angle_2 * crank_angle_1_ddot
                    + minus_l_lambda_loop_2_x_coupler_angle_2 * lambda_loop_2_x
                    - l_lambda_loop_2_y_coupler_angle_2 * lambda_loop_2_y,
                rhs_coupler_angle_3 * self.inverse_coupler_angle_2
                    - l_crank_angle_2_coupler_angle_3 * crank_angle_2_ddot
                    + minus_l_lambda_loop_3_x_coupler_angle_3 * lambda_loop_3_x
                    - l_lambda_loop_3_y_coupler_angle_3 * lambda_loop_3_y,
            ],
            multipliers: [
                lambda_loop_1_x,
                lambda_loop_1_y,
                lambda_loop_2_x,
                lambda_loop_2_y,
                lambda_loop_3_x,
                lambda_loop_3_y,
            ],
            power: -(self.k_5
                * (w_19 + w_20 + w_21 + cos_crank_angle_3 * crank_angle_3_dot) + w_22),
            refused: sim_kernel::pivot_is_refused(
                self.mass_crank_angle_0_crank_angle_0,
                self.mass_crank_angle_0_crank_angle_0,
            )
                | sim_kernel::pivot_is_refused(
                    self.mass_crank_angle_3_crank_angle_3,
                    self.mass_crank_angle_3_crank_angle_3,
                )
                | sim_kernel::pivot_is_refused(
                    self.mass_crank_angle_3_crank_angle_3,
                    self.mass_crank_angle_3_crank_angle_3,
                )
                | sim_kernel::pivot_is_refused(
                    self.mass_crank_angle_3_crank_angle_3,
                    self.mass_crank_angle_3_crank_angle_3,
                )
                | sim_kernel::pivot_is_refused(
                    pivot_coupler_angle_1,
                    self.mass_crank_angle_3_crank_angle_3,
                )
                | sim_kernel::pivot_is_refused(
                    pivot_crank_angle_1,
                    self.mass_crank_angle_0_crank_angle_0,
                )
                | sim_kernel::pivot_is_refused(
                    pivot_crank_angle_2,
                    self.mass_crank_angle_0_crank_angle_0,
                )
                | sim_kernel::pivot_is_refused(
                    -minus_pivot_lambda_loop_1_x,
                    minus_pivot_lambda_loop_1_x,
                )
                | sim_kernel::pivot_is_refused(
                    -minus_pivot_lambda_loop_3_x,
                    minus_pivot_lambda_loop_3_x,
                ) | sim_kernel::pivot_is_refused(pivot_lambda_loop_1_y, w_15)
                | sim_kernel::pivot_is_refused(pivot_lambda_loop_3_y, w_16)
                | sim_kernel::pivot_is_refused(pivot_lambda_loop_2_x, w_17)
                | sim_kernel::pivot_is_refused(pivot_lambda_loop_2_y, w_18),
        }
    }
    /// The derivatives of accelerations (7 rows) and multipliers (6 rows) with respect to coordinates and speeds (7 columns each): with the equations of motion as `K z = r`, the solutions of `K dz = dr - dK z`. Where `refused` is set a pivot was too small and nothing else holds.
    ///
    /// Operations: 722 additions, 1073 multiplications, 9 divisions, 7 sine-cosine pairs.
    #[inline]
    pub fn dynamics_jacobian(
        &self,
        t: S,
        q: &[S; 7],
        qd: &[S; 7],
    ) -> sim_kernel::DynamicsJacobian<S, [[S; 7]; 7], [[S; 7]; 6]> {
        let [crank_angle_0, crank_angle_1, crank_angle_2, crank_angle_3, coupler_angle_1,
        coupler_angle_2, coupler_angle_3] = *q;
        let [crank_angle_0_dot, crank_angle_1_dot, crank_angle_2_dot, crank_angle_3_dot,
        coupler_angle_1_dot, coupler_angle_2_dot, coupler_angle_3_dot] = *qd;
        let (
            [sin_crank_angle_0,
            sin_coupler_angle_1,
            sin_crank_angle_1,
            sin_coupler_angle_2,
            sin_crank_angle_2,
            sin_coupler_angle_3,
            sin_crank_angle_3,
            ],
            [cos_crank_angle_0,
            cos_coupler_angle_1,
            cos_crank_angle_1,
            cos_coupler_angle_2,
            cos_crank_angle_2,
            cos_coupler_angle_3,
            cos_crank_angle_3,
            ],
        ) = S::sin_cos_each([
            crank_angle_0,
            coupler_angle_1,
            crank_angle_1,
            coupler_angle_2,
            crank_angle_2,
            coupler_angle_3,
            crank_angle_3,
        ]);
        let coupler_angle_1_dot_squared = coupler_angle_1_dot * coupler_angle_1_dot;
        let w = sin_coupler_angle_1 * coupler_angle_1_dot_squared;
        let w_2 = cos_coupler_angle_1 * coupler_angle_1_dot_squared;
        let rhs_crank_angle_0 = cos_crank_angle_0 * (self.k * w - self.k_4)
            - sin_crank_angle_0 * self.k * w_2;
        let crank_angle_1_dot_squared = crank_angle_1_dot * crank_angle_1_dot;
        let w_3 = sin_crank_angle_1 * crank_angle_1_dot_squared;
        let w_4 = cos_crank_angle_1 * crank_angle_1_dot_squared;
        let rhs_coupler_angle_2 = cos_coupler_angle_2 * (self.k * w_3 - self.k_5)
            - self.k * sin_coupler_angle_2 * w_4;
        let crank_angle_2_dot_squared = crank_angle_2_dot * crank_angle_2_dot;
        let w_5 = sin_crank_angle_2 * crank_angle_2_dot_squared;
        let w_6 = cos_crank_angle_2 * crank_angle_2_dot_squared;
        let rhs_coupler_angle_3 = cos_coupler_angle_3 * (self.k * w_5 - self.k_5)
            - self.k * sin_coupler_angle_3 * w_6;
        let crank_angle_0_dot_squared = crank_angle_0_dot * crank_angle_0_dot;
        let w_7 = sin_crank_angle_0 * crank_angle_0_dot_squared;
        let w_8 = cos_crank_angle_0 * crank_angle_0_dot_squared;
        let w_9 = sin_crank_angle_0 * sin_coupler_angle_1
            + cos_crank_angle_0 * cos_coupler_angle_1;
        let mass_coupler_angle_1_crank_angle_0 = self.k * w_9;
        let l_coupler_angle_1_crank_angle_0 = mass_coupler_angle_1_crank_angle_0
            * self.inverse_crank_angle_0;
        let rhs_coupler_angle_1 = cos_coupler_angle_1 * (self.k * w_7 - self.k_5)
            - sin_coupler_angle_1 * self.k * w_8
            - rhs_crank_angle_0 * l_coupler_angle_1_crank_angle_0;
        let coupler_angle_2_dot_squared = coupler_angle_2_dot * coupler_angle_2_dot;
        let w_10 = sin_coupler_angle_2 * coupler_angle_2_dot_squared;
        let w_11 = cos_coupler_angle_2 * coupler_angle_2_dot_squared;
        let w_12 = sin_crank_angle_1 * sin_coupler_angle_2
            + cos_crank_angle_1 * cos_coupler_angle_2;
        let mass_coupler_angle_2_crank_angle_1 = self.k * w_12;
        let l_crank_angle_1_coupler_angle_2 = mass_coupler_angle_2_crank_angle_1
            * self.inverse_coupler_angle_2;
        let rhs_crank_angle_1 = cos_crank_angle_1 * (self.k * w_10 - self.k_4)
            - self.k * sin_crank_angle_1 * w_11
            - rhs_coupler_angle_2 * l_crank_angle_1_coupler_angle_2;
        let coupler_angle_3_dot_squared = coupler_angle_3_dot * coupler_angle_3_dot;
        let w_13 = sin_coupler_angle_3 * coupler_angle_3_dot_squared;
        let w_14 = cos_coupler_angle_3 * coupler_angle_3_dot_squared;
        let w_15 = sin_crank_angle_2 * sin_coupler_angle_3
            + cos_crank_angle_2 * cos_coupler_angle_3;
        let mass_coupler_angle_3_crank_angle_2 = self.k * w_15;
        let l_crank_angle_2_coupler_angle_3 = mass_coupler_angle_3_crank_angle_2
            * self.inverse_coupler_angle_2;
        let rhs_crank_angle_2 = cos_crank_angle_2 * (self.k * w_13 - self.k_4)
            - self.k * sin_crank_angle_2 * w_14
            - rhs_coupler_angle_3 * l_crank_angle_2_coupler_angle_3;
        let minus_loop_1_x_by_crank_angle_0 = self.l * sin_crank_angle_0;
        let minus_l_lambda_loop_1_x_crank_angle_0 = minus_loop_1_x_by_crank_angle_0
            * self.inverse_crank_angle_0;
        let pivot_coupler_angle_1 = self.mass_crank_angle_3_crank_angle_3
            - mass_coupler_angle_1_crank_angle_0 * l_coupler_angle_1_crank_angle_0;
        let inverse_coupler_angle_1 = S::from_f64(1.0) / pivot_coupler_angle_1;
        let k_lambda_loop_1_x_coupler_angle_1 = mass_coupler_angle_1_crank_angle_0
            * minus_l_lambda_loop_1_x_crank_angle_0 - self.l * sin_coupler_angle_1;
        let l_lambda_loop_1_x_coupler_angle_1 = inverse_coupler_angle_1
            * k_lambda_loop_1_x_coupler_angle_1;
        let crank_1_tip_y = self.l * sin_crank_angle_1;
        let pivot_crank_angle_1 = self.mass_crank_angle_0_crank_angle_0
            - mass_coupler_angle_2_crank_angle_1 * l_crank_angle_1_coupler_angle_2;
        let inverse_crank_angle_1 = S::from_f64(1.0) / pivot_crank_angle_1;
        let l_lambda_loop_1_x_crank_angle_1 = crank_1_tip_y * inverse_crank_angle_1;
        let rhs_lambda_loop_1_x = rhs_crank_angle_0
            * minus_l_lambda_loop_1_x_crank_angle_0 - self.l * (w_4 - w_8 - w_2)
            - l_lambda_loop_1_x_coupler_angle_1 * rhs_coupler_angle_1
            - l_lambda_loop_1_x_crank_angle_1 * rhs_crank_angle_1;
        let minus_loop_3_x_by_coupler_angle_3 = self.l * sin_coupler_angle_3;
        let minus_l_lambda_loop_3_x_coupler_angle_3 = minus_loop_3_x_by_coupler_angle_3
            * self.inverse_coupler_angle_2;
        let crank_angle_3_dot_squared = crank_angle_3_dot * crank_angle_3_dot;
        let w_16 = cos_crank_angle_3 * crank_angle_3_dot_squared;
        let minus_rhs_crank_angle_3 = cos_crank_angle_3 * self.k_5;
        let crank_3_tip_y = self.l * sin_crank_angle_3;
        let l_lambda_loop_3_x_crank_angle_3 = crank_3_tip_y
            * self.inverse_coupler_angle_2;
        let pivot_crank_angle_2 = self.mass_crank_angle_0_crank_angle_0
            - mass_coupler_angle_3_crank_angle_2 * l_crank_angle_2_coupler_angle_3;
        let inverse_crank_angle_2 = S::from_f64(1.0) / pivot_crank_angle_2;
        let crank_2_tip_y = self.l * sin_crank_angle_2;
        let k_lambda_loop_3_x_crank_angle_2 = mass_coupler_angle_3_crank_angle_2
            * minus_l_lambda_loop_3_x_coupler_angle_3 - crank_2_tip_y;
        let l_lambda_loop_3_x_crank_angle_2 = inverse_crank_angle_2
            * k_lambda_loop_3_x_crank_angle_2;
        let rhs_lambda_loop_3_x = rhs_coupler_angle_3
            * minus_l_lambda_loop_3_x_coupler_angle_3 - self.l * (w_16 - w_6 - w_14)
            + minus_rhs_crank_angle_3 * l_lambda_loop_3_x_crank_angle_3
            - l_lambda_loop_3_x_crank_angle_2 * rhs_crank_angle_2;
        let minus_loop_1_y_by_crank_angle_1 = self.l * cos_crank_angle_1;
        let minus_l_lambda_loop_1_y_crank_angle_1 = minus_loop_1_y_by_crank_angle_1
            * inverse_crank_angle_1;
        let crank_0_tip_x = self.l * cos_crank_angle_0;
        let l_lambda_loop_1_y_crank_angle_0 = crank_0_tip_x * self.inverse_crank_angle_0;
        let k_lambda_loop_1_y_coupler_angle_1 = self.l * cos_coupler_angle_1
            - mass_coupler_angle_1_crank_angle_0 * l_lambda_loop_1_y_crank_angle_0;
        let l_lambda_loop_1_y_coupler_angle_1 = inverse_coupler_angle_1
            * k_lambda_loop_1_y_coupler_angle_1;
        let minus_pivot_lambda_loop_1_x = minus_loop_1_x_by_crank_angle_0
            * minus_l_lambda_loop_1_x_crank_angle_0
            + k_lambda_loop_1_x_coupler_angle_1 * l_lambda_loop_1_x_coupler_angle_1
            + crank_1_tip_y * l_lambda_loop_1_x_crank_angle_1;
        let minus_inverse_lambda_loop_1_x = S::from_f64(1.0)
            / minus_pivot_lambda_loop_1_x;
        let k_lambda_loop_1_y_lambda_loop_1_x = minus_loop_1_x_by_crank_angle_0
            * l_lambda_loop_1_y_crank_angle_0
            - k_lambda_loop_1_x_coupler_angle_1 * l_lambda_loop_1_y_coupler_angle_1
            + crank_1_tip_y * minus_l_lambda_loop_1_y_crank_angle_1;
        let minus_l_lambda_loop_1_y_lambda_loop_1_x = minus_inverse_lambda_loop_1_x
            * k_lambda_loop_1_y_lambda_loop_1_x;
        let rhs_lambda_loop_1_y = minus_l_lambda_loop_1_y_crank_angle_1
            * rhs_crank_angle_1 - self.l * (w_3 - w_7 - w)
            - rhs_crank_angle_0 * l_lambda_loop_1_y_crank_angle_0
            - l_lambda_loop_1_y_coupler_angle_1 * rhs_coupler_angle_1
            + minus_l_lambda_loop_1_y_lambda_loop_1_x * rhs_lambda_loop_1_x;
        let minus_pivot_lambda_loop_3_x = minus_loop_3_x_by_coupler_angle_3
            * minus_l_lambda_loop_3_x_coupler_angle_3
            + crank_3_tip_y * l_lambda_loop_3_x_crank_angle_3
            + k_lambda_loop_3_x_crank_angle_2 * l_lambda_loop_3_x_crank_angle_2;
        let minus_inverse_lambda_loop_3_x = S::from_f64(1.0)
            / minus_pivot_lambda_loop_3_x;
        let loop_3_y_by_coupler_angle_3 = self.l * cos_coupler_angle_3;
        let l_lambda_loop_3_y_coupler_angle_3 = loop_3_y_by_coupler_angle_3
            * self.inverse_coupler_angle_2;
        let minus_loop_3_y_by_crank_angle_3 = self.l * cos_crank_angle_3;
        let minus_l_lambda_loop_3_y_crank_angle_3 = minus_loop_3_y_by_crank_angle_3
            * self.inverse_coupler_angle_2;
        let minus_loop_2_y_by_crank_angle_2 = self.l * cos_crank_angle_2;
        let k_lambda_loop_3_y_crank_angle_2 = minus_loop_2_y_by_crank_angle_2
            - mass_coupler_angle_3_crank_angle_2 * l_lambda_loop_3_y_coupler_angle_3;
        let l_lambda_loop_3_y_crank_angle_2 = inverse_crank_angle_2
            * k_lambda_loop_3_y_crank_angle_2;
        let k_lambda_loop_3_y_lambda_loop_3_x = minus_loop_3_x_by_coupler_angle_3
            * l_lambda_loop_3_y_coupler_angle_3
            + crank_3_tip_y * minus_l_lambda_loop_3_y_crank_angle_3
            - k_lambda_loop_3_x_crank_angle_2 * l_lambda_loop_3_y_crank_angle_2;
        let minus_l_lambda_loop_3_y_lambda_loop_3_x = minus_inverse_lambda_loop_3_x
            * k_lambda_loop_3_y_lambda_loop_3_x;
        let w_17 = sin_crank_angle_3 * crank_angle_3_dot_squared;
        let rhs_lambda_loop_3_y = minus_l_lambda_loop_3_y_lambda_loop_3_x
            * rhs_lambda_loop_3_x - self.l * (w_17 - w_5 - w_13)
            - rhs_coupler_angle_3 * l_lambda_loop_3_y_coupler_angle_3
            - minus_rhs_crank_angle_3 * minus_l_lambda_loop_3_y_crank_angle_3
            - l_lambda_loop_3_y_crank_angle_2 * rhs_crank_angle_2;
        let minus_loop_2_x_by_coupler_angle_2 = self.l * sin_coupler_angle_2;
        let minus_l_lambda_loop_2_x_coupler_angle_2 = minus_loop_2_x_by_coupler_angle_2
            * self.inverse_coupler_angle_2;
        let k_lambda_loop_2_x_crank_angle_1 = mass_coupler_angle_2_crank_angle_1
            * minus_l_lambda_loop_2_x_coupler_angle_2 - crank_1_tip_y;
        let l_lambda_loop_2_x_crank_angle_1 = inverse_crank_angle_1
            * k_lambda_loop_2_x_crank_angle_1;
        let l_lambda_loop_2_x_crank_angle_2 = crank_2_tip_y * inverse_crank_angle_2;
        let minus_k_lambda_loop_2_x_lambda_loop_1_x = crank_1_tip_y
            * l_lambda_loop_2_x_crank_angle_1;
        let l_lambda_loop_2_x_lambda_loop_1_x = minus_k_lambda_loop_2_x_lambda_loop_1_x
            * minus_inverse_lambda_loop_1_x;
        let minus_k_lambda_loop_2_x_lambda_loop_3_x = crank_2_tip_y
            * l_lambda_loop_3_x_crank_angle_2;
        let l_lambda_loop_2_x_lambda_loop_3_x = minus_k_lambda_loop_2_x_lambda_loop_3_x
            * minus_inverse_lambda_loop_3_x;
        let w_18 = crank_0_tip_x * l_lambda_loop_1_y_crank_angle_0
            + k_lambda_loop_1_y_coupler_angle_1 * l_lambda_loop_1_y_coupler_angle_1
            + minus_loop_1_y_by_crank_angle_1 * minus_l_lambda_loop_1_y_crank_angle_1;
        let pivot_lambda_loop_1_y = k_lambda_loop_1_y_lambda_loop_1_x
            * minus_l_lambda_loop_1_y_lambda_loop_1_x - w_18;
        let inverse_lambda_loop_1_y = S::from_f64(1.0) / pivot_lambda_loop_1_y;
        let k_lambda_loop_2_x_lambda_loop_1_y = minus_loop_1_y_by_crank_angle_1
            * l_lambda_loop_2_x_crank_angle_1
            - k_lambda_loop_1_y_lambda_loop_1_x * l_lambda_loop_2_x_lambda_loop_1_x;
        let l_lambda_loop_2_x_lambda_loop_1_y = inverse_lambda_loop_1_y
            * k_lambda_loop_2_x_lambda_loop_1_y;
        let w_19 = loop_3_y_by_coupler_angle_3 * l_lambda_loop_3_y_coupler_angle_3
            + minus_loop_3_y_by_crank_angle_3 * minus_l_lambda_loop_3_y_crank_angle_3
            + k_lambda_loop_3_y_crank_angle_2 * l_lambda_loop_3_y_crank_angle_2;
        let pivot_lambda_loop_3_y = k_lambda_loop_3_y_lambda_loop_3_x
            * minus_l_lambda_loop_3_y_lambda_loop_3_x - w_19;
        let inverse_lambda_loop_3_y = S::from_f64(1.0) / pivot_lambda_loop_3_y;
        let minus_k_lambda_loop_2_x_lambda_loop_3_y = crank_2_tip_y
            * l_lambda_loop_3_y_crank_angle_2
            + minus_k_lambda_loop_2_x_lambda_loop_3_x
                * minus_l_lambda_loop_3_y_lambda_loop_3_x;
        let minus_l_lambda_loop_2_x_lambda_loop_3_y = inverse_lambda_loop_3_y
            * minus_k_lambda_loop_2_x_lambda_loop_3_y;
        let rhs_lambda_loop_2_x = rhs_coupler_angle_2
            * minus_l_lambda_loop_2_x_coupler_angle_2 - self.l * (w_6 - w_4 - w_11)
            - l_lambda_loop_2_x_crank_angle_1 * rhs_crank_angle_1
            - l_lambda_loop_2_x_crank_angle_2 * rhs_crank_angle_2
            - l_lambda_loop_2_x_lambda_loop_1_x * rhs_lambda_loop_1_x
            - l_lambda_loop_2_x_lambda_loop_3_x * rhs_lambda_loop_3_x
            - l_lambda_loop_2_x_lambda_loop_1_y * rhs_lambda_loop_1_y
            + minus_l_lambda_loop_2_x_lambda_loop_3_y * rhs_lambda_loop_3_y;
        let minus_l_lambda_loop_2_y_crank_angle_2 = minus_loop_2_y_by_crank_angle_2
            * inverse_crank_angle_2;
        let loop_2_y_by_coupler_angle_2 = self.l * cos_coupler_angle_2;
        let l_lambda_loop_2_y_coupler_angle_2 = loop_2_y_by_coupler_angle_2
            * self.inverse_coupler_angle_2;
        let k_lambda_loop_2_y_crank_angle_1 = minus_loop_1_y_by_crank_angle_1
            - mass_coupler_angle_2_crank_angle_1 * l_lambda_loop_2_y_coupler_angle_2;
        let l_lambda_loop_2_y_crank_angle_1 = inverse_crank_angle_1
            * k_lambda_loop_2_y_crank_angle_1;
        let minus_k_lambda_loop_2_y_lambda_loop_1_x = crank_1_tip_y
            * l_lambda_loop_2_y_crank_angle_1;
        let l_lambda_loop_2_y_lambda_loop_1_x = minus_k_lambda_loop_2_y_lambda_loop_1_x
            * minus_inverse_lambda_loop_1_x;
        let k_lambda_loop_2_y_lambda_loop_3_x = minus_loop_2_y_by_crank_angle_2
            * l_lambda_loop_3_x_crank_angle_2;
        let minus_l_lambda_loop_2_y_lambda_loop_3_x = k_lambda_loop_2_y_lambda_loop_3_x
            * minus_inverse_lambda_loop_3_x;
        let k_lambda_loop_2_y_lambda_loop_1_y = minus_loop_1_y_by_crank_angle_1
            * l_lambda_loop_2_y_crank_angle_1
            - k_lambda_loop_1_y_lambda_loop_1_x * l_lambda_loop_2_y_lambda_loop_1_x;
        let l_lambda_loop_2_y_lambda_loop_1_y = inverse_lambda_loop_1_y
            * k_lambda_loop_2_y_lambda_loop_1_y;
        let k_lambda_loop_2_y_lambda_loop_3_y = minus_loop_2_y_by_crank_angle_2
            * l_lambda_loop_3_y_crank_angle_2
            + k_lambda_loop_2_y_lambda_loop_3_x
                * minus_l_lambda_loop_3_y_lambda_loop_3_x;
        let l_lambda_loop_2_y_lambda_loop_3_y = inverse_lambda_loop_3_y
            * k_lambda_loop_2_y_lambda_loop_3_y;
        let w_20 = minus_loop_2_x_by_coupler_angle_2
            * minus_l_lambda_loop_2_x_coupler_angle_2
            + k_lambda_loop_2_x_crank_angle_1 * l_lambda_loop_2_x_crank_angle_1
            + crank_2_tip_y * l_lambda_loop_2_x_crank_angle_2;
        let pivot_lambda_loop_2_x = minus_k_lambda_loop_2_x_lambda_loop_1_x
            * l_lambda_loop_2_x_lambda_loop_1_x - w_20
            + minus_k_lambda_loop_2_x_lambda_loop_3_x * l_lambda_loop_2_x_lambda_loop_3_x
            - k_lambda_loop_2_x_lambda_loop_1_y * l_lambda_loop_2_x_lambda_loop_1_y
            - minus_k_lambda_loop_2_x_lambda_loop_3_y
                * minus_l_lambda_loop_2_x_lambda_loop_3_y;
        let inverse_lambda_loop_2_x = S::from_f64(1.0) / pivot_lambda_loop_2_x;
        let k_lambda_loop_2_y_lambda_loop_2_x = minus_loop_2_x_by_coupler_angle_2
            * l_lambda_loop_2_y_coupler_angle_2
            - k_lambda_loop_2_x_crank_angle_1 * l_lambda_loop_2_y_crank_angle_1
            + crank_2_tip_y * minus_l_lambda_loop_2_y_crank_angle_2
            + minus_k_lambda_loop_2_x_lambda_loop_1_x * l_lambda_loop_2_y_lambda_loop_1_x
            - minus_k_lambda_loop_2_x_lambda_loop_3_x
                * minus_l_lambda_loop_2_y_lambda_loop_3_x
            - k_lambda_loop_2_x_lambda_loop_1_y * l_lambda_loop_2_y_lambda_loop_1_y
            + minus_k_lambda_loop_2_x_lambda_loop_3_y
                * l_lambda_loop_2_y_lambda_loop_3_y;
        let l_lambda_loop_2_y_lambda_loop_2_x = inverse_lambda_loop_2_x
            * k_lambda_loop_2_y_lambda_loop_2_x;
        let rhs_lambda_loop_2_y = minus_l_lambda_loop_2_y_crank_angle_2
            * rhs_crank_angle_2 - self.l * (w_5 - w_3 - w_10)
            - rhs_coupler_angle_2 * l_lambda_loop_2_y_coupler_angle_2
            - l_lambda_loop_2_y_crank_angle_1 * rhs_crank_angle_1
            - l_lambda_loop_2_y_lambda_loop_1_x * rhs_lambda_loop_1_x
            + minus_l_lambda_loop_2_y_lambda_loop_3_x * rhs_lambda_loop_3_x
            - l_lambda_loop_2_y_lambda_loop_1_y * rhs_lambda_loop_1_y
            - l_lambda_loop_2_y_lambda_loop_3_y * rhs_lambda_loop_3_y
            - l_lambda_loop_2_y_lambda_loop_2_x * rhs_lambda_loop_2_x;
        let w_21 = self.k_2 * w_7 + self.l * w;
        let w_22 = loop_2_y_by_coupler_angle_2 * l_lambda_loop_2_y_coupler_angle_2
            + k_lambda_loop_2_y_crank_angle_1 * l_lambda_loop_2_y_crank_angle_1
            + minus_loop_2_y_by_crank_angle_2 * minus_l_lambda_loop_2_y_crank_angle_2;
        let pivot_lambda_loop_2_y = minus_k_lambda_loop_2_y_lambda_loop_1_x
            * l_lambda_loop_2_y_lambda_loop_1_x - w_22
            + k_lambda_loop_2_y_lambda_loop_3_x * minus_l_lambda_loop_2_y_lambda_loop_3_x
            - k_lambda_loop_2_y_lambda_loop_1_y * l_lambda_loop_2_y_lambda_loop_1_y
            - k_lambda_loop_2_y_lambda_loop_3_y * l_lambda_loop_2_y_lambda_loop_3_y
            - k_lambda_loop_2_y_lambda_loop_2_x * l_lambda_loop_2_y_lambda_loop_2_x;
        let inverse_lambda_loop_2_y = S::from_f64(1.0) / pivot_lambda_loop_2_y;
        let lambda_loop_2_y = inverse_lambda_loop_2_y * rhs_lambda_loop_2_y;
        let lambda_loop_2_x = inverse_lambda_loop_2_x * rhs_lambda_loop_2_x
            - l_lambda_loop_2_y_lambda_loop_2_x * lambda_loop_2_y;
        let lambda_loop_1_y = inverse_lambda_loop_1_y * rhs_lambda_loop_1_y
            - l_lambda_loop_2_x_lambda_loop_1_y * lambda_loop_2_x
            - l_lambda_loop_2_y_lambda_loop_1_y * lambda_loop_2_y;
        let w_23 = self.l * lambda_loop_1_y;
        let lambda_loop_1_x = minus_l_lambda_loop_1_y_lambda_loop_1_x * lambda_loop_1_y
            - minus_inverse_lambda_loop_1_x * rhs_lambda_loop_1_x
            - l_lambda_loop_2_x_lambda_loop_1_x * lambda_loop_2_x
            - l_lambda_loop_2_y_lambda_loop_1_x * lambda_loop_2_y;
        let w_24 = self.l * lambda_loop_1_x;
        let w_25 = self.k_2 * w_8 + self.l * w_2;
        let coupler_angle_1_ddot = inverse_coupler_angle_1 * rhs_coupler_angle_1
            - l_lambda_loop_1_x_coupler_angle_1 * lambda_loop_1_x
            - l_lambda_loop_1_y_coupler_angle_1 * lambda_loop_1_y;
        let w_26 = sin_coupler_angle_1 * cos_crank_angle_0;
        let w_27 = sin_crank_angle_0 * cos_coupler_angle_1;
        let w_28 = w_26 - w_27;
        let w_29 = S::from_f64(0.5) * self.k_8 * w_28;
        let w_30 = coupler_angle_1_ddot * w_29;
        let w_31 = sin_crank_angle_0 * (self.k_4 - w_21 * self.k_3 + w_23)
            + cos_crank_angle_0 * (w_24 - w_25 * self.k_3)
            + crank_angle_0_dot_squared * self.k_8 - w_30;
        let crank_angle_0_ddot = rhs_crank_angle_0 * self.inverse_crank_angle_0
            - l_coupler_angle_1_crank_angle_0 * coupler_angle_1_ddot
            + minus_l_lambda_loop_1_x_crank_angle_0 * lambda_loop_1_x
            - l_lambda_loop_1_y_crank_angle_0 * lambda_loop_1_y;
        let w_32 = crank_angle_0_ddot * w_29;
        let w_33 = self.k * w_9 * crank_angle_0_dot_squared - w_32
            - l_coupler_angle_1_crank_angle_0 * w_31;
        let w_34 = self.l * (cos_crank_angle_0 * crank_angle_0_ddot - w_7)
            + minus_l_lambda_loop_1_x_crank_angle_0 * w_31
            - l_lambda_loop_1_x_coupler_angle_1 * w_33;
        let w_35 = self.l * (w_8 + sin_crank_angle_0 * crank_angle_0_ddot)
            - l_lambda_loop_1_y_crank_angle_0 * w_31
            - l_lambda_loop_1_y_coupler_angle_1 * w_33
            + minus_l_lambda_loop_1_y_lambda_loop_1_x * w_34;
        let w_36 = l_lambda_loop_2_x_lambda_loop_1_x * w_34
            + l_lambda_loop_2_x_lambda_loop_1_y * w_35;
        let w_37 = inverse_lambda_loop_2_y
            * (l_lambda_loop_2_y_lambda_loop_2_x * w_36
                - l_lambda_loop_2_y_lambda_loop_1_x * w_34
                - l_lambda_loop_2_y_lambda_loop_1_y * w_35);
        let w_38 = inverse_lambda_loop_2_x * w_36
            + l_lambda_loop_2_y_lambda_loop_2_x * w_37;
        let w_39 = inverse_lambda_loop_1_y * w_35
            + l_lambda_loop_2_x_lambda_loop_1_y * w_38
            - l_lambda_loop_2_y_lambda_loop_1_y * w_37;
        let w_40 = minus_l_lambda_loop_1_y_lambda_loop_1_x * w_39
            - minus_inverse_lambda_loop_1_x * w_34
            + l_lambda_loop_2_x_lambda_loop_1_x * w_38
            - l_lambda_loop_2_y_lambda_loop_1_x * w_37;
        let w_41 = inverse_coupler_angle_1 * w_33
            - l_lambda_loop_1_x_coupler_angle_1 * w_40
            - l_lambda_loop_1_y_coupler_angle_1 * w_39;
        let w_42 = self.k_2 * w_3 + self.l * w_10;
        let w_43 = self.k_2 * w_4 + self.l * w_11;
        let crank_angle_1_ddot = inverse_crank_angle_1 * rhs_crank_angle_1
            - l_lambda_loop_1_x_crank_angle_1 * lambda_loop_1_x
            + minus_l_lambda_loop_1_y_crank_angle_1 * lambda_loop_1_y
            - l_lambda_loop_2_x_crank_angle_1 * lambda_loop_2_x
            - l_lambda_loop_2_y_crank_angle_1 * lambda_loop_2_y;
        let coupler_angle_2_ddot = rhs_coupler_angle_2 * self.inverse_coupler_angle_2
            - l_crank_angle_1_coupler_angle_2 * crank_angle_1_ddot
            + minus_l_lambda_loop_2_x_coupler_angle_2 * lambda_loop_2_x
            - l_lambda_loop_2_y_coupler_angle_2 * lambda_loop_2_y;
        let w_44 = sin_coupler_angle_2 * cos_crank_angle_1;
        let w_45 = sin_crank_angle_1 * cos_coupler_angle_2;
        let w_46 = w_44 - w_45;
        let w_47 = S::from_f64(0.5) * self.k_8 * w_46;
        let w_48 = coupler_angle_2_ddot * w_47;
        let w_49 = sin_crank_angle_1
            * (self.l * (lambda_loop_2_y - lambda_loop_1_y) - self.k_3 * w_42 + self.k_4)
            + cos_crank_angle_1
                * (self.l * (lambda_loop_2_x - lambda_loop_1_x) - self.k_3 * w_43)
            + crank_angle_1_dot_squared * self.k_8 - w_48;
        let w_50 = crank_angle_1_ddot * w_47;
        let w_51 = self.k * w_12 * crank_angle_1_dot_squared - w_50;
        let w_52 = w_49 - l_crank_angle_1_coupler_angle_2 * w_51;
        let w_53 = self.l * (w_4 + sin_crank_angle_1 * crank_angle_1_ddot);
        let w_54 = cos_crank_angle_1 * crank_angle_1_ddot;
        let w_55 = self.l * (w_3 - w_54) - l_lambda_loop_1_x_crank_angle_1 * w_52;
        let w_56 = minus_l_lambda_loop_1_y_crank_angle_1 * w_52 - w_53
            + minus_l_lambda_loop_1_y_lambda_loop_1_x * w_55;
        let w_57 = self.l * (w_54 - w_3) + minus_l_lambda_loop_2_x_coupler_angle_2 * w_51
            - l_lambda_loop_2_x_crank_angle_1 * w_52
            - l_lambda_loop_2_x_lambda_loop_1_x * w_55
            - l_lambda_loop_2_x_lambda_loop_1_y * w_56;
        let w_58 = inverse_lambda_loop_2_y
            * (w_53 - l_lambda_loop_2_y_coupler_angle_2 * w_51
                - l_lambda_loop_2_y_crank_angle_1 * w_52
                - l_lambda_loop_2_y_lambda_loop_1_x * w_55
                - l_lambda_loop_2_y_lambda_loop_1_y * w_56
                - l_lambda_loop_2_y_lambda_loop_2_x * w_57);
        let w_59 = inverse_lambda_loop_2_x * w_57
            - l_lambda_loop_2_y_lambda_loop_2_x * w_58;
        let w_60 = inverse_lambda_loop_1_y * w_56
            - l_lambda_loop_2_x_lambda_loop_1_y * w_59
            - l_lambda_loop_2_y_lambda_loop_1_y * w_58;
        let w_61 = minus_l_lambda_loop_1_y_lambda_loop_1_x * w_60
            - minus_inverse_lambda_loop_1_x * w_55
            - l_lambda_loop_2_x_lambda_loop_1_x * w_59
            - l_lambda_loop_2_y_lambda_loop_1_x * w_58;
        let w_62 = l_lambda_loop_1_x_coupler_angle_1 * w_61
            + l_lambda_loop_1_y_coupler_angle_1 * w_60;
        let lambda_loop_3_y = inverse_lambda_loop_3_y * rhs_lambda_loop_3_y
            + minus_l_lambda_loop_2_x_lambda_loop_3_y * lambda_loop_2_x
            - l_lambda_loop_2_y_lambda_loop_3_y * lambda_loop_2_y;
        let lambda_loop_3_x = minus_l_lambda_loop_2_y_lambda_loop_3_x * lambda_loop_2_y
            - minus_inverse_lambda_loop_3_x * rhs_lambda_loop_3_x
            - l_lambda_loop_2_x_lambda_loop_3_x * lambda_loop_2_x
            + minus_l_lambda_loop_3_y_lambda_loop_3_x * lambda_loop_3_y;
        let crank_angle_2_ddot = inverse_crank_angle_2 * rhs_crank_angle_2
            - l_lambda_loop_2_x_crank_angle_2 * lambda_loop_2_x
            + minus_l_lambda_loop_2_y_crank_angle_2 * lambda_loop_2_y
            - l_lambda_loop_3_x_crank_angle_2 * lambda_loop_3_x
            - l_lambda_loop_3_y_crank_angle_2 * lambda_loop_3_y;
        let w_63 = cos_crank_angle_2 * crank_angle_2_ddot;
        let w_64 = self.k_2 * w_5 + self.l * w_13;
        let w_65 = self.k_2 * w_6 + self.l * w_14;
        let coupler_angle_3_ddot = rhs_coupler_angle_3 * self.inverse_coupler_angle_2
            - l_crank_angle_2_coupler_angle_3 * crank_angle_2_ddot
            + minus_l_lambda_loop_3_x_coupler_angle_3 * lambda_loop_3_x
            - l_lambda_loop_3_y_coupler_angle_3 * lambda_loop_3_y;
        let w_66 = sin_coupler_angle_3 * cos_crank_angle_2;
        let w_67 = sin_crank_angle_2 * cos_coupler_angle_3;
        let w_68 = w_66 - w_67;
        let w_69 = S::from_f64(0.5) * self.k_8 * w_68;
        let w_70 = coupler_angle_3_ddot * w_69;
        let w_71 = sin_crank_angle_2
            * (self.l * (lambda_loop_3_y - lambda_loop_2_y) - self.k_3 * w_64 + self.k_4)
            + cos_crank_angle_2
                * (self.l * (lambda_loop_3_x - lambda_loop_2_x) - self.k_3 * w_65)
            + crank_angle_2_dot_squared * self.k_8 - w_70;
        let w_72 = crank_angle_2_ddot * w_69;
        let w_73 = self.k * w_15 * crank_angle_2_dot_squared - w_72;
        let w_74 = w_71 - l_crank_angle_2_coupler_angle_3 * w_73;
        let w_75 = self.l * (w_63 - w_5) + minus_l_lambda_loop_3_x_coupler_angle_3 * w_73
            - l_lambda_loop_3_x_crank_angle_2 * w_74;
        let w_76 = self.l * (w_6 + sin_crank_angle_2 * crank_angle_2_ddot);
        let w_77 = w_76 - l_lambda_loop_3_y_coupler_angle_3 * w_73
            - l_lambda_loop_3_y_crank_angle_2 * w_74
            + minus_l_lambda_loop_3_y_lambda_loop_3_x * w_75;
        let w_78 = self.l * (w_5 - w_63) - l_lambda_loop_2_x_crank_angle_2 * w_74
            - l_lambda_loop_2_x_lambda_loop_3_x * w_75
            + minus_l_lambda_loop_2_x_lambda_loop_3_y * w_77;
        let w_79 = inverse_lambda_loop_2_y
            * (minus_l_lambda_loop_2_y_crank_angle_2 * w_74 - w_76
                + minus_l_lambda_loop_2_y_lambda_loop_3_x * w_75
                - l_lambda_loop_2_y_lambda_loop_3_y * w_77
                - l_lambda_loop_2_y_lambda_loop_2_x * w_78);
        let w_80 = inverse_lambda_loop_2_x * w_78
            - l_lambda_loop_2_y_lambda_loop_2_x * w_79;
        let w_81 = l_lambda_loop_2_x_lambda_loop_1_y * w_80
            + l_lambda_loop_2_y_lambda_loop_1_y * w_79;
        let w_82 = minus_l_lambda_loop_1_y_lambda_loop_1_x * w_81
            + l_lambda_loop_2_x_lambda_loop_1_x * w_80
            + l_lambda_loop_2_y_lambda_loop_1_x * w_79;
        let w_83 = l_lambda_loop_1_x_coupler_angle_1 * w_82
            + l_lambda_loop_1_y_coupler_angle_1 * w_81;
        let w_84 = self.l * lambda_loop_3_y;
        let w_85 = sin_crank_angle_3 * (self.k_5 - w_84)
            - minus_loop_3_y_by_crank_angle_3 * lambda_loop_3_x;
        let crank_angle_3_ddot = minus_l_lambda_loop_3_y_crank_angle_3 * lambda_loop_3_y
            - minus_rhs_crank_angle_3 * self.inverse_coupler_angle_2
            - l_lambda_loop_3_x_crank_angle_3 * lambda_loop_3_x;
        let w_86 = self.l * (w_17 - cos_crank_angle_3 * crank_angle_3_ddot)
            - l_lambda_loop_3_x_crank_angle_3 * w_85;
        let w_87 = minus_l_lambda_loop_3_y_crank_angle_3 * w_85
            - self.l * (w_16 + sin_crank_angle_3 * crank_angle_3_ddot)
            + minus_l_lambda_loop_3_y_lambda_loop_3_x * w_86;
        let w_88 = minus_l_lambda_loop_2_x_lambda_loop_3_y * w_87
            - l_lambda_loop_2_x_lambda_loop_3_x * w_86;
        let w_89 = inverse_lambda_loop_2_y
            * (minus_l_lambda_loop_2_y_lambda_loop_3_x * w_86
                - l_lambda_loop_2_y_lambda_loop_3_y * w_87
                - l_lambda_loop_2_y_lambda_loop_2_x * w_88);
        let w_90 = inverse_lambda_loop_2_x * w_88
            - l_lambda_loop_2_y_lambda_loop_2_x * w_89;
        let w_91 = l_lambda_loop_2_x_lambda_loop_1_y * w_90
            + l_lambda_loop_2_y_lambda_loop_1_y * w_89;
        let w_92 = minus_l_lambda_loop_1_y_lambda_loop_1_x * w_91
            + l_lambda_loop_2_x_lambda_loop_1_x * w_90
            + l_lambda_loop_2_y_lambda_loop_1_x * w_89;
        let w_93 = l_lambda_loop_1_x_coupler_angle_1 * w_92
            + l_lambda_loop_1_y_coupler_angle_1 * w_91;
        let w_94 = self.k * w_9 * coupler_angle_1_dot_squared + w_30;
        let w_95 = sin_coupler_angle_1 * (self.k_5 - w_21 * self.k_6 + w_23)
            + cos_coupler_angle_1 * (w_24 - w_25 * self.k_6)
            + coupler_angle_1_dot_squared * self.k_9 + w_32
            - l_coupler_angle_1_crank_angle_0 * w_94;
        let w_96 = self.l * (cos_coupler_angle_1 * coupler_angle_1_ddot - w)
            + minus_l_lambda_loop_1_x_crank_angle_0 * w_94
            - l_lambda_loop_1_x_coupler_angle_1 * w_95;
        let w_97 = self.l * (w_2 + sin_coupler_angle_1 * coupler_angle_1_ddot)
            - l_lambda_loop_1_y_crank_angle_0 * w_94
            - l_lambda_loop_1_y_coupler_angle_1 * w_95
            + minus_l_lambda_loop_1_y_lambda_loop_1_x * w_96;
        let w_98 = l_lambda_loop_2_x_lambda_loop_1_x * w_96
            + l_lambda_loop_2_x_lambda_loop_1_y * w_97;
        let w_99 = inverse_lambda_loop_2_y
            * (l_lambda_loop_2_y_lambda_loop_2_x * w_98
                - l_lambda_loop_2_y_lambda_loop_1_x * w_96
                - l_lambda_loop_2_y_lambda_loop_1_y * w_97);
        let w_100 = inverse_lambda_loop_2_x * w_98
            + l_lambda_loop_2_y_lambda_loop_2_x * w_99;
        let w_101 = inverse_lambda_loop_1_y * w_97
            + l_lambda_loop_2_x_lambda_loop_1_y * w_100
            - l_lambda_loop_2_y_lambda_loop_1_y * w_99;
        let w_102 = minus_l_lambda_loop_1_y_lambda_loop_1_x * w_101
            - minus_inverse_lambda_loop_1_x * w_96
            + l_lambda_loop_2_x_lambda_loop_1_x * w_100
            - l_lambda_loop_2_y_lambda_loop_1_x * w_99;
        let w_103 = inverse_coupler_angle_1 * w_95
            - l_lambda_loop_1_x_coupler_angle_1 * w_102
            - l_lambda_loop_1_y_coupler_angle_1 * w_101;
        let w_104 = sin_coupler_angle_2
            * (self.k_5 - w_42 * self.k_6 + self.l * lambda_loop_2_y)
            + cos_coupler_angle_2 * (self.l * lambda_loop_2_x - w_43 * self.k_6)
            + coupler_angle_2_dot_squared * self.k_9 + w_50;
        let w_105 = self.k * w_12 * coupler_angle_2_dot_squared + w_48
            - l_crank_angle_1_coupler_angle_2 * w_104;
        let w_106 = l_lambda_loop_1_x_crank_angle_1 * w_105;
        let w_107 = minus_l_lambda_loop_1_y_crank_angle_1 * w_105
            - minus_l_lambda_loop_1_y_lambda_loop_1_x * w_106;
        let w_108 = self.l * (cos_coupler_angle_2 * coupler_angle_2_ddot - w_10)
            + minus_l_lambda_loop_2_x_coupler_angle_2 * w_104
            - l_lambda_loop_2_x_crank_angle_1 * w_105
            + l_lambda_loop_2_x_lambda_loop_1_x * w_106
            - l_lambda_loop_2_x_lambda_loop_1_y * w_107;
        let w_109 = inverse_lambda_loop_2_y
            * (self.l * (w_11 + sin_coupler_angle_2 * coupler_angle_2_ddot)
                - l_lambda_loop_2_y_coupler_angle_2 * w_104
                - l_lambda_loop_2_y_crank_angle_1 * w_105
                + l_lambda_loop_2_y_lambda_loop_1_x * w_106
                - l_lambda_loop_2_y_lambda_loop_1_y * w_107
                - l_lambda_loop_2_y_lambda_loop_2_x * w_108);
        let w_110 = inverse_lambda_loop_2_x * w_108
            - l_lambda_loop_2_y_lambda_loop_2_x * w_109;
        let w_111 = inverse_lambda_loop_1_y * w_107
            - l_lambda_loop_2_x_lambda_loop_1_y * w_110
            - l_lambda_loop_2_y_lambda_loop_1_y * w_109;
        let w_112 = minus_inverse_lambda_loop_1_x * w_106
            + minus_l_lambda_loop_1_y_lambda_loop_1_x * w_111
            - l_lambda_loop_2_x_lambda_loop_1_x * w_110
            - l_lambda_loop_2_y_lambda_loop_1_x * w_109;
        let w_113 = l_lambda_loop_1_x_coupler_angle_1 * w_112
            + l_lambda_loop_1_y_coupler_angle_1 * w_111;
        let w_114 = sin_coupler_angle_3 * (self.k_5 - w_64 * self.k_6 + w_84)
            + cos_coupler_angle_3 * (self.l * lambda_loop_3_x - w_65 * self.k_6)
            + coupler_angle_3_dot_squared * self.k_9 + w_72;
        let w_115 = self.k * w_15 * coupler_angle_3_dot_squared + w_70
            - l_crank_angle_2_coupler_angle_3 * w_114;
        let w_116 = self.l * (cos_coupler_angle_3 * coupler_angle_3_ddot - w_13)
            + minus_l_lambda_loop_3_x_coupler_angle_3 * w_114
            - l_lambda_loop_3_x_crank_angle_2 * w_115;
        let w_117 = self.l * (w_14 + sin_coupler_angle_3 * coupler_angle_3_ddot)
            - l_lambda_loop_3_y_coupler_angle_3 * w_114
            - l_lambda_loop_3_y_crank_angle_2 * w_115
            + minus_l_lambda_loop_3_y_lambda_loop_3_x * w_116;
        let w_118 = minus_l_lambda_loop_2_x_lambda_loop_3_y * w_117
            - l_lambda_loop_2_x_crank_angle_2 * w_115
            - l_lambda_loop_2_x_lambda_loop_3_x * w_116;
        let w_119 = inverse_lambda_loop_2_y
            * (minus_l_lambda_loop_2_y_crank_angle_2 * w_115
                + minus_l_lambda_loop_2_y_lambda_loop_3_x * w_116
                - l_lambda_loop_2_y_lambda_loop_3_y * w_117
                - l_lambda_loop_2_y_lambda_loop_2_x * w_118);
        let w_120 = inverse_lambda_loop_2_x * w_118
            - l_lambda_loop_2_y_lambda_loop_2_x * w_119;
        let w_121 = l_lambda_loop_2_x_lambda_loop_1_y * w_120
            + l_lambda_loop_2_y_lambda_loop_1_y * w_119;
        let w_122 = minus_l_lambda_loop_1_y_lambda_loop_1_x * w_121
            + l_lambda_loop_2_x_lambda_loop_1_x * w_120
            + l_lambda_loop_2_y_lambda_loop_1_x * w_119;
        let w_123 = l_lambda_loop_1_x_coupler_angle_1 * w_122
            + l_lambda_loop_1_y_coupler_angle_1 * w_121;
        let w_124 = minus_l_lambda_loop_1_y_crank_angle_1 * w_39
            - l_lambda_loop_1_x_crank_angle_1 * w_40
            + l_lambda_loop_2_x_crank_angle_1 * w_38
            - l_lambda_loop_2_y_crank_angle_1 * w_37;
        let w_125 = inverse_crank_angle_1 * w_52 - l_lambda_loop_1_x_crank_angle_1 * w_61
            + minus_l_lambda_loop_1_y_crank_angle_1 * w_60
            - l_lambda_loop_2_x_crank_angle_1 * w_59
            - l_lambda_loop_2_y_crank_angle_1 * w_58;
        let w_126 = l_lambda_loop_1_x_crank_angle_1 * w_82
            - minus_l_lambda_loop_1_y_crank_angle_1 * w_81
            - l_lambda_loop_2_x_crank_angle_1 * w_80
            - l_lambda_loop_2_y_crank_angle_1 * w_79;
        let w_127 = l_lambda_loop_1_x_crank_angle_1 * w_92
            - minus_l_lambda_loop_1_y_crank_angle_1 * w_91
            - l_lambda_loop_2_x_crank_angle_1 * w_90
            - l_lambda_loop_2_y_crank_angle_1 * w_89;
        let w_128 = minus_l_lambda_loop_1_y_crank_angle_1 * w_101
            - l_lambda_loop_1_x_crank_angle_1 * w_102
            + l_lambda_loop_2_x_crank_angle_1 * w_100
            - l_lambda_loop_2_y_crank_angle_1 * w_99;
        let w_129 = inverse_crank_angle_1 * w_105
            - l_lambda_loop_1_x_crank_angle_1 * w_112
            + minus_l_lambda_loop_1_y_crank_angle_1 * w_111
            - l_lambda_loop_2_x_crank_angle_1 * w_110
            - l_lambda_loop_2_y_crank_angle_1 * w_109;
        let w_130 = l_lambda_loop_1_x_crank_angle_1 * w_122
            - minus_l_lambda_loop_1_y_crank_angle_1 * w_121
            - l_lambda_loop_2_x_crank_angle_1 * w_120
            - l_lambda_loop_2_y_crank_angle_1 * w_119;
        let w_131 = minus_l_lambda_loop_2_x_lambda_loop_3_y * w_38
            + l_lambda_loop_2_y_lambda_loop_3_y * w_37;
        let w_132 = l_lambda_loop_2_x_lambda_loop_3_x * w_38
            + minus_l_lambda_loop_2_y_lambda_loop_3_x * w_37
            - minus_l_lambda_loop_3_y_lambda_loop_3_x * w_131;
        let w_133 = l_lambda_loop_2_x_crank_angle_2 * w_38
            + minus_l_lambda_loop_2_y_crank_angle_2 * w_37
            - l_lambda_loop_3_x_crank_angle_2 * w_132
            + l_lambda_loop_3_y_crank_angle_2 * w_131;
        let w_134 = minus_l_lambda_loop_2_x_lambda_loop_3_y * w_59
            - l_lambda_loop_2_y_lambda_loop_3_y * w_58;
        let w_135 = minus_l_lambda_loop_2_y_lambda_loop_3_x * w_58
            - l_lambda_loop_2_x_lambda_loop_3_x * w_59
            + minus_l_lambda_loop_3_y_lambda_loop_3_x * w_134;
        let w_136 = minus_l_lambda_loop_2_y_crank_angle_2 * w_58
            - l_lambda_loop_2_x_crank_angle_2 * w_59
            - l_lambda_loop_3_x_crank_angle_2 * w_135
            - l_lambda_loop_3_y_crank_angle_2 * w_134;
        let w_137 = inverse_lambda_loop_3_y * w_77
            + minus_l_lambda_loop_2_x_lambda_loop_3_y * w_80
            - l_lambda_loop_2_y_lambda_loop_3_y * w_79;
        let w_138 = minus_l_lambda_loop_2_y_lambda_loop_3_x * w_79
            - minus_inverse_lambda_loop_3_x * w_75
            - l_lambda_loop_2_x_lambda_loop_3_x * w_80
            + minus_l_lambda_loop_3_y_lambda_loop_3_x * w_137;
        let w_139 = inverse_crank_angle_2 * w_74 - l_lambda_loop_2_x_crank_angle_2 * w_80
            + minus_l_lambda_loop_2_y_crank_angle_2 * w_79
            - l_lambda_loop_3_x_crank_angle_2 * w_138
            - l_lambda_loop_3_y_crank_angle_2 * w_137;
        let w_140 = inverse_lambda_loop_3_y * w_87
            + minus_l_lambda_loop_2_x_lambda_loop_3_y * w_90
            - l_lambda_loop_2_y_lambda_loop_3_y * w_89;
        let w_141 = minus_l_lambda_loop_2_y_lambda_loop_3_x * w_89
            - minus_inverse_lambda_loop_3_x * w_86
            - l_lambda_loop_2_x_lambda_loop_3_x * w_90
            + minus_l_lambda_loop_3_y_lambda_loop_3_x * w_140;
        let w_142 = minus_l_lambda_loop_2_y_crank_angle_2 * w_89
            - l_lambda_loop_2_x_crank_angle_2 * w_90
            - l_lambda_loop_3_x_crank_angle_2 * w_141
            - l_lambda_loop_3_y_crank_angle_2 * w_140;
        let w_143 = minus_l_lambda_loop_2_x_lambda_loop_3_y * w_100
            + l_lambda_loop_2_y_lambda_loop_3_y * w_99;
        let w_144 = l_lambda_loop_2_x_lambda_loop_3_x * w_100
            + minus_l_lambda_loop_2_y_lambda_loop_3_x * w_99
            - minus_l_lambda_loop_3_y_lambda_loop_3_x * w_143;
        let w_145 = l_lambda_loop_2_x_crank_angle_2 * w_100
            + minus_l_lambda_loop_2_y_crank_angle_2 * w_99
            - l_lambda_loop_3_x_crank_angle_2 * w_144
            + l_lambda_loop_3_y_crank_angle_2 * w_143;
        let w_146 = minus_l_lambda_loop_2_x_lambda_loop_3_y * w_110
            - l_lambda_loop_2_y_lambda_loop_3_y * w_109;
        let w_147 = minus_l_lambda_loop_2_y_lambda_loop_3_x * w_109
            - l_lambda_loop_2_x_lambda_loop_3_x * w_110
            + minus_l_lambda_loop_3_y_lambda_loop_3_x * w_146;
        let w_148 = minus_l_lambda_loop_2_y_crank_angle_2 * w_109
            - l_lambda_loop_2_x_crank_angle_2 * w_110
            - l_lambda_loop_3_x_crank_angle_2 * w_147
            - l_lambda_loop_3_y_crank_angle_2 * w_146;
        let w_149 = inverse_lambda_loop_3_y * w_117
            + minus_l_lambda_loop_2_x_lambda_loop_3_y * w_120
            - l_lambda_loop_2_y_lambda_loop_3_y * w_119;
        let w_150 = minus_l_lambda_loop_2_y_lambda_loop_3_x * w_119
            - minus_inverse_lambda_loop_3_x * w_116
            - l_lambda_loop_2_x_lambda_loop_3_x * w_120
            + minus_l_lambda_loop_3_y_lambda_loop_3_x * w_149;
        let w_151 = inverse_crank_angle_2 * w_115
            - l_lambda_loop_2_x_crank_angle_2 * w_120
            + minus_l_lambda_loop_2_y_crank_angle_2 * w_119
            - l_lambda_loop_3_x_crank_angle_2 * w_150
            - l_lambda_loop_3_y_crank_angle_2 * w_149;
        let w_152 = crank_angle_0_dot * self.k_2;
        let w_153 = self.k_8 * crank_angle_0_dot * (w_27 - w_26);
        let w_154 = cos_crank_angle_0 * w_152
            - l_lambda_loop_1_x_coupler_angle_1 * w_153;
        let w_155 = sin_crank_angle_0 * w_152 - l_lambda_loop_1_y_coupler_angle_1 * w_153
            + minus_l_lambda_loop_1_y_lambda_loop_1_x * w_154;
        let w_156 = l_lambda_loop_2_x_lambda_loop_1_x * w_154
            + l_lambda_loop_2_x_lambda_loop_1_y * w_155;
        let w_157 = inverse_lambda_loop_2_y
            * (l_lambda_loop_2_y_lambda_loop_2_x * w_156
                - l_lambda_loop_2_y_lambda_loop_1_x * w_154
                - l_lambda_loop_2_y_lambda_loop_1_y * w_155);
        let w_158 = inverse_lambda_loop_2_x * w_156
            + l_lambda_loop_2_y_lambda_loop_2_x * w_157;
        let w_159 = inverse_lambda_loop_1_y * w_155
            + l_lambda_loop_2_x_lambda_loop_1_y * w_158
            - l_lambda_loop_2_y_lambda_loop_1_y * w_157;
        let w_160 = minus_l_lambda_loop_1_y_lambda_loop_1_x * w_159
            - minus_inverse_lambda_loop_1_x * w_154
            + l_lambda_loop_2_x_lambda_loop_1_x * w_158
            - l_lambda_loop_2_y_lambda_loop_1_x * w_157;
        let w_161 = inverse_coupler_angle_1 * w_153
            - l_lambda_loop_1_x_coupler_angle_1 * w_160
            - l_lambda_loop_1_y_coupler_angle_1 * w_159;
        let w_162 = self.k_8 * crank_angle_1_dot * (w_45 - w_44);
        let w_163 = l_crank_angle_1_coupler_angle_2 * w_162;
        let w_164 = self.k_2 * crank_angle_1_dot;
        let w_165 = cos_crank_angle_1 * w_164;
        let w_166 = l_lambda_loop_1_x_crank_angle_1 * w_163 - w_165;
        let w_167 = sin_crank_angle_1 * w_164;
        let w_168 = minus_l_lambda_loop_1_y_lambda_loop_1_x * w_166 - w_167
            - minus_l_lambda_loop_1_y_crank_angle_1 * w_163;
        let w_169 = w_165 + minus_l_lambda_loop_2_x_coupler_angle_2 * w_162
            + l_lambda_loop_2_x_crank_angle_1 * w_163
            - l_lambda_loop_2_x_lambda_loop_1_x * w_166
            - l_lambda_loop_2_x_lambda_loop_1_y * w_168;
        let w_170 = inverse_lambda_loop_2_y
            * (w_167 - l_lambda_loop_2_y_coupler_angle_2 * w_162
                + l_lambda_loop_2_y_crank_angle_1 * w_163
                - l_lambda_loop_2_y_lambda_loop_1_x * w_166
                - l_lambda_loop_2_y_lambda_loop_1_y * w_168
                - l_lambda_loop_2_y_lambda_loop_2_x * w_169);
        let w_171 = inverse_lambda_loop_2_x * w_169
            - l_lambda_loop_2_y_lambda_loop_2_x * w_170;
        let w_172 = inverse_lambda_loop_1_y * w_168
            - l_lambda_loop_2_x_lambda_loop_1_y * w_171
            - l_lambda_loop_2_y_lambda_loop_1_y * w_170;
        let w_173 = minus_l_lambda_loop_1_y_lambda_loop_1_x * w_172
            - minus_inverse_lambda_loop_1_x * w_166
            - l_lambda_loop_2_x_lambda_loop_1_x * w_171
            - l_lambda_loop_2_y_lambda_loop_1_x * w_170;
        let w_174 = l_lambda_loop_1_x_coupler_angle_1 * w_173
            + l_lambda_loop_1_y_coupler_angle_1 * w_172;
        let w_175 = self.k_8 * crank_angle_2_dot * (w_67 - w_66);
        let w_176 = l_crank_angle_2_coupler_angle_3 * w_175;
        let w_177 = self.k_2 * crank_angle_2_dot;
        let w_178 = cos_crank_angle_2 * w_177;
        let w_179 = w_178 + minus_l_lambda_loop_3_x_coupler_angle_3 * w_175
            + l_lambda_loop_3_x_crank_angle_2 * w_176;
        let w_180 = sin_crank_angle_2 * w_177;
        let w_181 = w_180 - l_lambda_loop_3_y_coupler_angle_3 * w_175
            + l_lambda_loop_3_y_crank_angle_2 * w_176
            + minus_l_lambda_loop_3_y_lambda_loop_3_x * w_179;
        let w_182 = l_lambda_loop_2_x_crank_angle_2 * w_176 - w_178
            - l_lambda_loop_2_x_lambda_loop_3_x * w_179
            + minus_l_lambda_loop_2_x_lambda_loop_3_y * w_181;
        let w_183 = inverse_lambda_loop_2_y
            * (minus_l_lambda_loop_2_y_lambda_loop_3_x * w_179 - w_180
                - minus_l_lambda_loop_2_y_crank_angle_2 * w_176
                - l_lambda_loop_2_y_lambda_loop_3_y * w_181
                - l_lambda_loop_2_y_lambda_loop_2_x * w_182);
        let w_184 = inverse_lambda_loop_2_x * w_182
            - l_lambda_loop_2_y_lambda_loop_2_x * w_183;
        let w_185 = l_lambda_loop_2_x_lambda_loop_1_y * w_184
            + l_lambda_loop_2_y_lambda_loop_1_y * w_183;
        let w_186 = minus_l_lambda_loop_1_y_lambda_loop_1_x * w_185
            + l_lambda_loop_2_x_lambda_loop_1_x * w_184
            + l_lambda_loop_2_y_lambda_loop_1_x * w_183;
        let w_187 = l_lambda_loop_1_x_coupler_angle_1 * w_186
            + l_lambda_loop_1_y_coupler_angle_1 * w_185;
        let w_188 = self.k_2 * crank_angle_3_dot;
        let w_189 = cos_crank_angle_3 * w_188;
        let w_190 = sin_crank_angle_3 * w_188
            + minus_l_lambda_loop_3_y_lambda_loop_3_x * w_189;
        let w_191 = l_lambda_loop_2_x_lambda_loop_3_x * w_189
            - minus_l_lambda_loop_2_x_lambda_loop_3_y * w_190;
        let w_192 = inverse_lambda_loop_2_y
            * (l_lambda_loop_2_y_lambda_loop_3_y * w_190
                - minus_l_lambda_loop_2_y_lambda_loop_3_x * w_189
                - l_lambda_loop_2_y_lambda_loop_2_x * w_191);
        let w_193 = inverse_lambda_loop_2_x * w_191
            - l_lambda_loop_2_y_lambda_loop_2_x * w_192;
        let w_194 = l_lambda_loop_2_x_lambda_loop_1_y * w_193
            + l_lambda_loop_2_y_lambda_loop_1_y * w_192;
        let w_195 = minus_l_lambda_loop_1_y_lambda_loop_1_x * w_194
            + l_lambda_loop_2_x_lambda_loop_1_x * w_193
            + l_lambda_loop_2_y_lambda_loop_1_x * w_192;
        let w_196 = l_lambda_loop_1_x_coupler_angle_1 * w_195
            + l_lambda_loop_1_y_coupler_angle_1 * w_194;
        let w_197 = self.k_8 * coupler_angle_1_dot * w_28;
        let w_198 = l_coupler_angle_1_crank_angle_0 * w_197;
        let w_199 = coupler_angle_1_dot * self.k_2;
        let w_200 = cos_coupler_angle_1 * w_199
            + minus_l_lambda_loop_1_x_crank_angle_0 * w_197
            + l_lambda_loop_1_x_coupler_angle_1 * w_198;
        let w_201 = sin_coupler_angle_1 * w_199 - l_lambda_loop_1_y_crank_angle_0 * w_197
            + l_lambda_loop_1_y_coupler_angle_1 * w_198
            + minus_l_lambda_loop_1_y_lambda_loop_1_x * w_200;
        let w_202 = l_lambda_loop_2_x_lambda_loop_1_x * w_200
            + l_lambda_loop_2_x_lambda_loop_1_y * w_201;
        let w_203 = inverse_lambda_loop_2_y
            * (l_lambda_loop_2_y_lambda_loop_2_x * w_202
                - l_lambda_loop_2_y_lambda_loop_1_x * w_200
                - l_lambda_loop_2_y_lambda_loop_1_y * w_201);
        let w_204 = inverse_lambda_loop_2_x * w_202
            + l_lambda_loop_2_y_lambda_loop_2_x * w_203;
        let w_205 = inverse_lambda_loop_1_y * w_201
            + l_lambda_loop_2_x_lambda_loop_1_y * w_204
            - l_lambda_loop_2_y_lambda_loop_1_y * w_203;
        let w_206 = minus_l_lambda_loop_1_y_lambda_loop_1_x * w_205
            - minus_inverse_lambda_loop_1_x * w_200
            + l_lambda_loop_2_x_lambda_loop_1_x * w_204
            - l_lambda_loop_2_y_lambda_loop_1_x * w_203;
        let w_207 = inverse_coupler_angle_1 * w_198
            + l_lambda_loop_1_x_coupler_angle_1 * w_206
            + l_lambda_loop_1_y_coupler_angle_1 * w_205;
        let w_208 = self.k_8 * coupler_angle_2_dot * w_46;
        let w_209 = l_lambda_loop_1_x_crank_angle_1 * w_208;
        let w_210 = minus_l_lambda_loop_1_y_crank_angle_1 * w_208
            - minus_l_lambda_loop_1_y_lambda_loop_1_x * w_209;
        let w_211 = self.k_2 * coupler_angle_2_dot;
        let w_212 = cos_coupler_angle_2 * w_211 - l_lambda_loop_2_x_crank_angle_1 * w_208
            + l_lambda_loop_2_x_lambda_loop_1_x * w_209
            - l_lambda_loop_2_x_lambda_loop_1_y * w_210;
        let w_213 = inverse_lambda_loop_2_y
            * (sin_coupler_angle_2 * w_211 - l_lambda_loop_2_y_crank_angle_1 * w_208
                + l_lambda_loop_2_y_lambda_loop_1_x * w_209
                - l_lambda_loop_2_y_lambda_loop_1_y * w_210
                - l_lambda_loop_2_y_lambda_loop_2_x * w_212);
        let w_214 = inverse_lambda_loop_2_x * w_212
            - l_lambda_loop_2_y_lambda_loop_2_x * w_213;
        let w_215 = inverse_lambda_loop_1_y * w_210
            - l_lambda_loop_2_x_lambda_loop_1_y * w_214
            - l_lambda_loop_2_y_lambda_loop_1_y * w_213;
        let w_216 = minus_inverse_lambda_loop_1_x * w_209
            + minus_l_lambda_loop_1_y_lambda_loop_1_x * w_215
            - l_lambda_loop_2_x_lambda_loop_1_x * w_214
            - l_lambda_loop_2_y_lambda_loop_1_x * w_213;
        let w_217 = l_lambda_loop_1_x_coupler_angle_1 * w_216
            + l_lambda_loop_1_y_coupler_angle_1 * w_215;
        let w_218 = self.k_2 * coupler_angle_3_dot;
        let w_219 = self.k_8 * coupler_angle_3_dot * w_68;
        let w_220 = cos_coupler_angle_3 * w_218
            - l_lambda_loop_3_x_crank_angle_2 * w_219;
        let w_221 = sin_coupler_angle_3 * w_218 - l_lambda_loop_3_y_crank_angle_2 * w_219
            + minus_l_lambda_loop_3_y_lambda_loop_3_x * w_220;
        let w_222 = minus_l_lambda_loop_2_x_lambda_loop_3_y * w_221
            - l_lambda_loop_2_x_crank_angle_2 * w_219
            - l_lambda_loop_2_x_lambda_loop_3_x * w_220;
        let w_223 = inverse_lambda_loop_2_y
            * (minus_l_lambda_loop_2_y_crank_angle_2 * w_219
                + minus_l_lambda_loop_2_y_lambda_loop_3_x * w_220
                - l_lambda_loop_2_y_lambda_loop_3_y * w_221
                - l_lambda_loop_2_y_lambda_loop_2_x * w_222);
        let w_224 = inverse_lambda_loop_2_x * w_222
            - l_lambda_loop_2_y_lambda_loop_2_x * w_223;
        let w_225 = l_lambda_loop_2_x_lambda_loop_1_y * w_224
            + l_lambda_loop_2_y_lambda_loop_1_y * w_223;
        let w_226 = minus_l_lambda_loop_1_y_lambda_loop_1_x * w_225
            + l_lambda_loop_2_x_lambda_loop_1_x * w_224
            + l_lambda_loop_2_y_lambda_loop_1_x * w_223;
        let w_227 = l_lambda_loop_1_x_coupler_angle_1 * w_226
            + l_lambda_loop_1_y_coupler_angle_1 * w_225;
        let w_228 = minus_l_lambda_loop_1_y_crank_angle_1 * w_159
            - l_lambda_loop_1_x_crank_angle_1 * w_160
            + l_lambda_loop_2_x_crank_angle_1 * w_158
            - l_lambda_loop_2_y_crank_angle_1 * w_157;
        let w_229 = minus_l_lambda_loop_1_y_crank_angle_1 * w_172
            - inverse_crank_angle_1 * w_163 - l_lambda_loop_1_x_crank_angle_1 * w_173
            - l_lambda_loop_2_x_crank_angle_1 * w_171
            - l_lambda_loop_2_y_crank_angle_1 * w_170;
        let w_230 = l_lambda_loop_1_x_crank_angle_1 * w_186
            - minus_l_lambda_loop_1_y_crank_angle_1 * w_185
            - l_lambda_loop_2_x_crank_angle_1 * w_184
            - l_lambda_loop_2_y_crank_angle_1 * w_183;
        let w_231 = l_lambda_loop_1_x_crank_angle_1 * w_195
            - minus_l_lambda_loop_1_y_crank_angle_1 * w_194
            - l_lambda_loop_2_x_crank_angle_1 * w_193
            - l_lambda_loop_2_y_crank_angle_1 * w_192;
        let w_232 = minus_l_lambda_loop_1_y_crank_angle_1 * w_205
            - l_lambda_loop_1_x_crank_angle_1 * w_206
            + l_lambda_loop_2_x_crank_angle_1 * w_204
            - l_lambda_loop_2_y_crank_angle_1 * w_203;
        let w_233 = inverse_crank_angle_1 * w_208
            - l_lambda_loop_1_x_crank_angle_1 * w_216
            + minus_l_lambda_loop_1_y_crank_angle_1 * w_215
            - l_lambda_loop_2_x_crank_angle_1 * w_214
            - l_lambda_loop_2_y_crank_angle_1 * w_213;
        let w_234 = l_lambda_loop_1_x_crank_angle_1 * w_226
            - minus_l_lambda_loop_1_y_crank_angle_1 * w_225
            - l_lambda_loop_2_x_crank_angle_1 * w_224
            - l_lambda_loop_2_y_crank_angle_1 * w_223;
        let w_235 = minus_l_lambda_loop_2_x_lambda_loop_3_y * w_158
            + l_lambda_loop_2_y_lambda_loop_3_y * w_157;
        let w_236 = l_lambda_loop_2_x_lambda_loop_3_x * w_158
            + minus_l_lambda_loop_2_y_lambda_loop_3_x * w_157
            - minus_l_lambda_loop_3_y_lambda_loop_3_x * w_235;
        let w_237 = l_lambda_loop_2_x_crank_angle_2 * w_158
            + minus_l_lambda_loop_2_y_crank_angle_2 * w_157
            - l_lambda_loop_3_x_crank_angle_2 * w_236
            + l_lambda_loop_3_y_crank_angle_2 * w_235;
        let w_238 = minus_l_lambda_loop_2_x_lambda_loop_3_y * w_171
            - l_lambda_loop_2_y_lambda_loop_3_y * w_170;
        let w_239 = minus_l_lambda_loop_2_y_lambda_loop_3_x * w_170
            - l_lambda_loop_2_x_lambda_loop_3_x * w_171
            + minus_l_lambda_loop_3_y_lambda_loop_3_x * w_238;
        let w_240 = minus_l_lambda_loop_2_y_crank_angle_2 * w_170
            - l_lambda_loop_2_x_crank_angle_2 * w_171
            - l_lambda_loop_3_x_crank_angle_2 * w_239
            - l_lambda_loop_3_y_crank_angle_2 * w_238;
        let w_241 = inverse_lambda_loop_3_y * w_181
            + minus_l_lambda_loop_2_x_lambda_loop_3_y * w_184
            - l_lambda_loop_2_y_lambda_loop_3_y * w_183;
        let w_242 = minus_l_lambda_loop_2_y_lambda_loop_3_x * w_183
            - minus_inverse_lambda_loop_3_x * w_179
            - l_lambda_loop_2_x_lambda_loop_3_x * w_184
            + minus_l_lambda_loop_3_y_lambda_loop_3_x * w_241;
        let w_243 = minus_l_lambda_loop_2_y_crank_angle_2 * w_183
            - inverse_crank_angle_2 * w_176 - l_lambda_loop_2_x_crank_angle_2 * w_184
            - l_lambda_loop_3_x_crank_angle_2 * w_242
            - l_lambda_loop_3_y_crank_angle_2 * w_241;
        let w_244 = minus_l_lambda_loop_2_x_lambda_loop_3_y * w_193
            - inverse_lambda_loop_3_y * w_190
            - l_lambda_loop_2_y_lambda_loop_3_y * w_192;
        let w_245 = minus_inverse_lambda_loop_3_x * w_189
            - l_lambda_loop_2_x_lambda_loop_3_x * w_193
            + minus_l_lambda_loop_2_y_lambda_loop_3_x * w_192
            + minus_l_lambda_loop_3_y_lambda_loop_3_x * w_244;
        let w_246 = minus_l_lambda_loop_2_y_crank_angle_2 * w_192
            - l_lambda_loop_2_x_crank_angle_2 * w_193
            - l_lambda_loop_3_x_crank_angle_2 * w_245
            - l_lambda_loop_3_y_crank_angle_2 * w_244;
        let w_247 = minus_l_lambda_loop_2_x_lambda_loop_3_y * w_204
            + l_lambda_loop_2_y_lambda_loop_3_y * w_203;
        let w_248 = l_lambda_loop_2_x_lambda_loop_3_x * w_204
            + minus_l_lambda_loop_2_y_lambda_loop_3_x * w_203
            - minus_l_lambda_loop_3_y_lambda_loop_3_x * w_247;
        let w_249 = l_lambda_loop_2_x_crank_angle_2 * w_204
            + minus_l_lambda_loop_2_y_crank_angle_2 * w_203
            - l_lambda_loop_3_x_crank_angle_2 * w_248
            + l_lambda_loop_3_y_crank_angle_2 * w_247;
        let w_250 = minus_l_lambda_loop_2_x_lambda_loop_3_y * w_214
            - l_lambda_loop_2_y_lambda_loop_3_y * w_213;
        let w_251 = minus_l_lambda_loop_2_y_lambda_loop_3_x * w_213
            - l_lambda_loop_2_x_lambda_loop_3_x * w_214
            + minus_l_lambda_loop_3_y_lambda_loop_3_x * w_250;
        let w_252 = minus_l_lambda_loop_2_y_crank_angle_2 * w_213
            - l_lambda_loop_2_x_crank_angle_2 * w_214
            - l_lambda_loop_3_x_crank_angle_2 * w_251
            - l_lambda_loop_3_y_crank_angle_2 * w_250;
        let w_253 = inverse_lambda_loop_3_y * w_221
            + minus_l_lambda_loop_2_x_lambda_loop_3_y * w_224
            - l_lambda_loop_2_y_lambda_loop_3_y * w_223;
        let w_254 = minus_l_lambda_loop_2_y_lambda_loop_3_x * w_223
            - minus_inverse_lambda_loop_3_x * w_220
            - l_lambda_loop_2_x_lambda_loop_3_x * w_224
            + minus_l_lambda_loop_3_y_lambda_loop_3_x * w_253;
        let w_255 = inverse_crank_angle_2 * w_219
            - l_lambda_loop_2_x_crank_angle_2 * w_224
            + minus_l_lambda_loop_2_y_crank_angle_2 * w_223
            - l_lambda_loop_3_x_crank_angle_2 * w_254
            - l_lambda_loop_3_y_crank_angle_2 * w_253;
        sim_kernel::DynamicsJacobian {
            accelerations_by_positions: [
                [
                    self.inverse_crank_angle_0 * w_31
                        - l_coupler_angle_1_crank_angle_0 * w_41
                        + minus_l_lambda_loop_1_x_crank_angle_0 * w_40
                        - l_lambda_loop_1_y_crank_angle_0 * w_39,
                    l_coupler_angle_1_crank_angle_0 * w_62
                        + minus_l_lambda_loop_1_x_crank_angle_0 * w_61
                        - l_lambda_loop_1_y_crank_angle_0 * w_60,
                    l_lambda_loop_1_y_crank_angle_0 * w_81
                        - l_coupler_angle_1_crank_angle_0 * w_83
                        - minus_l_lambda_loop_1_x_crank_angle_0 * w_82,
                    l_lambda_loop_1_y_crank_angle_0 * w_91
                        - l_coupler_angle_1_crank_angle_0 * w_93
                        - minus_l_lambda_loop_1_x_crank_angle_0 * w_92,
                    self.inverse_crank_angle_0 * w_94
                        - l_coupler_angle_1_crank_angle_0 * w_103
                        + minus_l_lambda_loop_1_x_crank_angle_0 * w_102
                        - l_lambda_loop_1_y_crank_angle_0 * w_101,
                    l_coupler_angle_1_crank_angle_0 * w_113
                        + minus_l_lambda_loop_1_x_crank_angle_0 * w_112
                        - l_lambda_loop_1_y_crank_angle_0 * w_111,
                    l_lambda_loop_1_y_crank_angle_0 * w_121
                        - l_coupler_angle_1_crank_angle_0 * w_123
                        - minus_l_lambda_loop_1_x_crank_angle_0 * w_122,
                ],
                [w_124, w_125, w_126, w_127, w_128, w_129, w_130],
                [w_133, w_136, w_139, w_142, w_145, w_148, w_151],
                [
                    -(l_lambda_loop_3_x_crank_angle_3 * w_132
                        + minus_l_lambda_loop_3_y_crank_angle_3 * w_131),
                    minus_l_lambda_loop_3_y_crank_angle_3 * w_134
                        - l_lambda_loop_3_x_crank_angle_3 * w_135,
                    minus_l_lambda_loop_3_y_crank_angle_3 * w_137
                        - l_lambda_loop_3_x_crank_angle_3 * w_138,
                    self.inverse_coupler_angle_2 * w_85
                        - l_lambda_loop_3_x_crank_angle_3 * w_141
                        + minus_l_lambda_loop_3_y_crank_angle_3 * w_140,
                    -(l_lambda_loop_3_x_crank_angle_3 * w_144
                        + minus_l_lambda_loop_3_y_crank_angle_3 * w_143),
                    minus_l_lambda_loop_3_y_crank_angle_3 * w_146
                        - l_lambda_loop_3_x_crank_angle_3 * w_147,
                    minus_l_lambda_loop_3_y_crank_angle_3 * w_149
                        - l_lambda_loop_3_x_crank_angle_3 * w_150,
                ],
                [w_41, -w_62, w_83, w_93, w_103, -w_113, w_123],
                [
                    -(l_crank_angle_1_coupler_angle_2 * w_124
                        + minus_l_lambda_loop_2_x_coupler_angle_2 * w_38
                        + l_lambda_loop_2_y_coupler_angle_2 * w_37),
                    self.inverse_coupler_angle_2 * w_51
                        - l_crank_angle_1_coupler_angle_2 * w_125
                        + minus_l_lambda_loop_2_x_coupler_angle_2 * w_59
                        - l_lambda_loop_2_y_coupler_angle_2 * w_58,
                    minus_l_lambda_loop_2_x_coupler_angle_2 * w_80
                        - l_crank_angle_1_coupler_angle_2 * w_126
                        - l_lambda_loop_2_y_coupler_angle_2 * w_79,
                    minus_l_lambda_loop_2_x_coupler_angle_2 * w_90
                        - l_crank_angle_1_coupler_angle_2 * w_127
                        - l_lambda_loop_2_y_coupler_angle_2 * w_89,
                    -(l_crank_angle_1_coupler_angle_2 * w_128
                        + minus_l_lambda_loop_2_x_coupler_angle_2 * w_100
                        + l_lambda_loop_2_y_coupler_angle_2 * w_99),
                    self.inverse_coupler_angle_2 * w_104
                        - l_crank_angle_1_coupler_angle_2 * w_129
                        + minus_l_lambda_loop_2_x_coupler_angle_2 * w_110
                        - l_lambda_loop_2_y_coupler_angle_2 * w_109,
                    minus_l_lambda_loop_2_x_coupler_angle_2 * w_120
                        - l_crank_angle_1_coupler_angle_2 * w_130
                        - l_lambda_loop_2_y_coupler_angle_2 * w_119,
                ],
                [
                    minus_l_lambda_loop_3_x_coupler_angle_3 * w_132
                        - l_crank_angle_2_coupler_angle_3 * w_133
                        + l_lambda_loop_3_y_coupler_angle_3 * w_131,
                    minus_l_lambda_loop_3_x_coupler_angle_3 * w_135
                        - l_crank_angle_2_coupler_angle_3 * w_136
                        - l_lambda_loop_3_y_coupler_angle_3 * w_134,
                    self.inverse_coupler_angle_2 * w_73
                        - l_crank_angle_2_coupler_angle_3 * w_139
                        + minus_l_lambda_loop_3_x_coupler_angle_3 * w_138
                        - l_lambda_loop_3_y_coupler_angle_3 * w_137,
                    minus_l_lambda_loop_3_x_coupler_angle_3 * w_141
                        - l_crank_angle_2_coupler_angle_3 * w_142
                        - l_lambda_loop_3_y_coupler_angle_3 * w_140,
                    minus_l_lambda_loop_3_x_coupler_angle_3 * w_144
                        - l_crank_angle_2_coupler_angle_3 * w_145
                        + l_lambda_loop_3_y_coupler_angle_3 * w_143,
                    minus_l_lambda_loop_3_x_coupler_angle_3 * w_147
                        - l_crank_angle_2_coupler_angle_3 * w_148
                        - l_lambda_loop_3_y_coupler_angle_3 * w_146,
                    self.inverse_coupler_angle_2 * w_114
                        - l_crank_angle_2_coupler_angle_3 * w_151
                        + minus_l_lambda_loop_3_x_coupler_angle_3 * w_150
                        - l_lambda_loop_3_y_coupler_angle_3 * w_149,
                ],
            ],
            accelerations_by_speeds: [
                [
                    minus_l_lambda_loop_1_x_crank_angle_0 * w_160
                        - l_coupler_angle_1_crank_angle_0 * w_161
                        - l_lambda_loop_1_y_crank_angle_0 * w_159,
                    l_coupler_angle_1_crank_angle_0 * w_174
                        + minus_l_lambda_loop_1_x_crank_angle_0 * w_173
                        - l_lambda_loop_1_y_crank_angle_0 * w_172,
                    l_lambda_loop_1_y_crank_angle_0 * w_185
                        - l_coupler_angle_1_crank_angle_0 * w_187
                        - minus_l_lambda_loop_1_x_crank_angle_0 * w_186,
                    l_lambda_loop_1_y_crank_angle_0 * w_194
                        - l_coupler_angle_1_crank_angle_0 * w_196
                        - minus_l_lambda_loop_1_x_crank_angle_0 * w_195,
                    self.inverse_crank_angle_0 * w_197
                        + l_coupler_angle_1_crank_angle_0 * w_207
                        + minus_l_lambda_loop_1_x_crank_angle_0 * w_206
                        - l_lambda_loop_1_y_crank_angle_0 * w_205,
                    l_coupler_angle_1_crank_angle_0 * w_217
                        + minus_l_lambda_loop_1_x_crank_angle_0 * w_216
                        - l_lambda_loop_1_y_crank_angle_0 * w_215,
                    l_lambda_loop_1_y_crank_angle_0 * w_225
                        - l_coupler_angle_1_crank_angle_0 * w_227
                        - minus_l_lambda_loop_1_x_crank_angle_0 * w_226,
                ],
                [w_228, w_229, w_230, w_231, w_232, w_233, w_234],
                [w_237, w_240, w_243, w_246, w_249, w_252, w_255],
                [
                    -(l_lambda_loop_3_x_crank_angle_3 * w_236
                        + minus_l_lambda_loop_3_y_crank_angle_3 * w_235),
                    minus_l_lambda_loop_3_y_crank_angle_3 * w_238
                        - l_lambda_loop_3_x_crank_angle_3 * w_239,
                    minus_l_lambda_loop_3_y_crank_angle_3 * w_241
                        - l_lambda_loop_3_x_crank_angle_3 * w_242,
                    minus_l_lambda_loop_3_y_crank_angle_3 * w_244
                        - l_lambda_loop_3_x_crank_angle_3 * w_245,
                    -(l_lambda_loop_3_x_crank_angle_3 * w_248
                        + minus_l_lambda_loop_3_y_crank_angle_3 * w_247),
                    minus_l_lambda_loop_3_y_crank_angle_3 * w_250
                        - l_lambda_loop_3_x_crank_angle_3 * w_251,
                    minus_l_lambda_loop_3_y_crank_angle_3 * w_253
                        - l_lambda_loop_3_x_crank_angle_3 * w_254,
                ],
                [w_161, -w_174, w_187, w_196, -w_207, -w_217, w_227],
                [
                    -(l_crank_angle_1_coupler_angle_2 * w_228
                        + minus_l_lambda_loop_2_x_coupler_angle_2 * w_158
                        + l_lambda_loop_2_y_coupler_angle_2 * w_157),
                    self.inverse_coupler_angle_2 * w_162
                        - l_crank_angle_1_coupler_angle_2 * w_229
                        + minus_l_lambda_loop_2_x_coupler_angle_2 * w_171
                        - l_lambda_loop_2_y_coupler_angle_2 * w_170,
                    minus_l_lambda_loop_2_x_coupler_angle_2 * w_184
                        - l_crank_angle_1_coupler_angle_2 * w_230
                        - l_lambda_loop_2_y_coupler_angle_2 * w_183,
                    minus_l_lambda_loop_2_x_coupler_angle_2 * w_193
                        - l_crank_angle_1_coupler_angle_2 * w_231
                        - l_lambda_loop_2_y_coupler_angle_2 * w_192,
                    -(l_crank_angle_1_coupler_angle_2 * w_232
                        + minus_l_lambda_loop_2_x_coupler_angle_2 * w_204
                        + l_lambda_loop_2_y_coupler_angle_2 * w_203),
                    minus_l_lambda_loop_2_x_coupler_angle_2 * w_214
                        - l_crank_angle_1_coupler_angle_2 * w_233
                        - l_lambda_loop_2_y_coupler_angle_2 * w_213,
                    minus_l_lambda_loop_2_x_coupler_angle_2 * w_224
                        - l_crank_angle_1_coupler_angle_2 * w_234
                        - l_lambda_loop_2_y_coupler_angle_2 * w_223,
                ],
                [
                    minus_l_lambda_loop_3_x_coupler_angle_3 * w_236
                        - l_crank_angle_2_coupler_angle_3 * w_237
                        + l_lambda_loop_3_y_coupler_angle_3 * w_235,
                    minus_l_lambda_loop_3_x_coupler_angle_3 * w_239
                        - l_crank_angle_2_coupler_angle_3 * w_240
                        - l_lambda_loop_3_y_coupler_angle_3 * w_238,
                    self.inverse_coupler_angle_2 * w_175
                        - l_crank_angle_2_coupler_angle_3 * w_243
                        + minus_l_lambda_loop_3_x_coupler_angle_3 * w_242
                        - l_lambda_loop_3_y_coupler_angle_3 * w_241,
                    minus_l_lambda_loop_3_x_coupler_angle_3 * w_245
                        - l_crank_angle_2_coupler_angle_3 * w_246
                        - l_lambda_loop_3_y_coupler_angle_3 * w_244,
                    minus_l_lambda_loop_3_x_coupler_angle_3 * w_248
                        - l_crank_angle_2_coupler_angle_3 * w_249
                        + l_lambda_loop_3_y_coupler_angle_3 * w_247,
                    minus_l_lambda_loop_3_x_coupler_angle_3 * w_251
                        - l_crank_angle_2_coupler_angle_3 * w_252
                        - l_lambda_loop_3_y_coupler_angle_3 * w_250,
                    minus_l_lambda_loop_3_x_coupler_angle_3 * w_254
                        - l_crank_angle_2_coupler_angle_3 * w_255
                        - l_lambda_loop_3_y_coupler_angle_3 * w_253,
                ],
            ],
            multipliers_by_positions: [
                [w_40, w_61, -w_82, -w_92, w_102, w_112, -w_122],
                [w_39, w_60, -w_81, -w_91, w_101, w_111, -w_121],
                [-w_38, w_59, w_80, w_90, -w_100, w_110, w_120],
                [w_37, w_58, w_79, w_89, w_99, w_109, w_119],
                [w_132, w_135, w_138, w_141, w_144, w_147, w_150],
                [-w_131, w_134, w_137, w_140, -w_143, w_146, w_149],
            ],
            multipliers_by_speeds: [
                [w_160, w_173, -w_186, -w_195, w_206, w_216, -w_226],
                [w_159, w_172, -w_185, -w_194, w_205, w_215, -w_225],
                [-w_158, w_171, w_184, w_193, -w_204, w_214, w_224],
                [w_157, w_170, w_183, w_192, w_203, w_213, w_223],
                [w_236, w_239, w_242, w_245, w_248, w_251, w_254],
                [-w_235, w_238, w_241, w_244, -w_247, w_250, w_253],
            ],
            refused: sim_kernel::pivot_is_refused(
                self.mass_crank_angle_0_crank_angle_0,
                self.mass_crank_angle_0_crank_angle_0,
            )
                | sim_kernel::pivot_is_refused(
                    self.mass_crank_angle_3_crank_angle_3,
                    self.mass_crank_angle_3_crank_angle_3,
                )
                | sim_kernel::pivot_is_refused(
                    self.mass_crank_angle_3_crank_angle_3,
                    self.mass_crank_angle_3_crank_angle_3,
                )
                | sim_kernel::pivot_is_refused(
                    self.mass_crank_angle_3_crank_angle_3,
                    self.mass_crank_angle_3_crank_angle_3,
                )
                | sim_kernel::pivot_is_refused(
                    pivot_coupler_angle_1,
                    self.mass_crank_angle_3_crank_angle_3,
                )
                | sim_kernel::pivot_is_refused(
                    pivot_crank_angle_1,
                    self.mass_crank_angle_0_crank_angle_0,
                )
                | sim_kernel::pivot_is_refused(
                    pivot_crank_angle_2,
                    self.mass_crank_angle_0_crank_angle_0,
                )
                | sim_kernel::pivot_is_refused(
                    -minus_pivot_lambda_loop_1_x,
                    minus_pivot_lambda_loop_1_x,
                )
                | sim_kernel::pivot_is_refused(
                    -minus_pivot_lambda_loop_3_x,
                    minus_pivot_lambda_loop_3_x,
                ) | sim_kernel::pivot_is_refused(pivot_lambda_loop_1_y, w_18)
                | sim_kernel::pivot_is_refused(pivot_lambda_loop_3_y, w_19)
                | sim_kernel::pivot_is_refused(pivot_lambda_loop_2_x, w_20)
                | sim_kernel::pivot_is_refused(pivot_lambda_loop_2_y, w_22),
        }
    }
}
#[allow(non_snake_case, clippy::all, clippy::pedantic)]
impl<S: sim_kernel::Scalar> sim_kernel::Mechanism<S> for FourBars<S> {
    type Q = [S; 7];
    type L = [S; 6];
    type Z = [S; 13];
    type QQ = [[S; 7]; 7];
    type LQ = [[S; 7]; 6];
    type LL = [[S; 6]; 6];
    type ZZ = [[S; 13]; 13];
    type Parameters = [S; 4];
    type Outputs = [S; 4];
    type OutputRates = [S; 2];
    type Events = [S; 1];
    type EventValues = [S; 0];
    type Activities = [S; 0];
    type Drawing = [S; 42];
    type QP = [[S; 4]; 7];
    type LP = [[S; 4]; 6];
    type Inputs = [sim_kernel::Input<S>; 0];
    type Prepared = FourBarsPrepared<S>;
    type On<T: sim_kernel::Scalar> = FourBars<T>;
    const DESCRIPTION: sim_kernel::Description = sim_kernel::Description {
        name: "four-bars",
        type_name: "FourBars",
        docs: "Parallel cranks side by side, joined by couplers: three four-bars in a row, which swing as one pendulum.",
        declaration: "/// Parallel cranks side by side, joined by couplers: three four-bars in a row, which swing as one pendulum.\npub FourBars;\n\nconst N = 3;\n\n/// A slender bar from a point, turned by an angle.\nfragment Bar(base, phi) {\n    let tip = base + l*[cos(phi), sin(phi)];\n    bodies { bar: mass m at (base + tip)/2, inertia m*l^2/12, angle phi; }\n    drawing { line base, tip; }\n}\n\ncoordinates {\n    repeat i in 0..=N {\n        /// Angle of crank {i}.\n        crank_angle_[i] [rad];\n    }\n    repeat i in 1..=N {\n        /// Angle of coupler {i}.\n        coupler_angle_[i] [rad];\n    }\n}\n\nparameters {\n    /// Length of each bar.\n    l [m] = 1;\n    /// Mass of each bar.\n    m [kg] = 1;\n    /// Angle of the cranks at the start.\n    start [deg] = -40;\n    g [m/s^2] = 9.81;\n}\n\nrepeat i in 0..=N {\n    use Bar([i*l, 0], crank_angle_[i]) as crank_[i];\n    drawing { ground [i*l, 0]; }\n}\nrepeat i in 1..=N {\n    use Bar(crank_[i-1]_tip, coupler_angle_[i]) as coupler_[i];\n    constraints { loop_[i]: coupler_[i]_tip = crank_[i]_tip; }\n    drawing { point crank_[i]_tip; }\n}\n\nloads { gravity [0, -g]; }\n\ninitial {\n    crank_angle_0 = start;\n    repeat i in 1..=N {\n        guess crank_angle_[i] = start;\n        guess coupler_angle_[i] = 0;\n    }\n}\n\nevents { period: dot(crank_angle_0) = 0; }\n\noutputs {\n    cranks \"Angles of the cranks\" {\n        /// first\n        first [deg] = crank_angle_0;\n        /// last\n        last [deg] = crank_angle_[N];\n    }\n    pins \"Force on the last crank\" {\n        /// along x\n        Fx [N] = reaction(loop_[N]).x;\n        /// along y\n        Fy [N] = reaction(loop_[N]).y;\n    }\n}\n",
        coordinates: &[
            sim_kernel::Coordinate {
                position: sim_kernel::Quantity {
                    name: "crank_angle_0",
                    unit: "rad",
                    factor: 1f64,
                    docs: "Angle of crank 0.",
                },
                speed: sim_kernel::Quantity {
                    name: "crank_angle_0_dot",
                    unit: "rad/s",
                    factor: 1f64,
                    docs: "",
                },
                acceleration: sim_kernel::Quantity {
                    name: "crank_angle_0_ddot",
                    unit: "rad/s^2",
                    factor: 1f64,
                    docs: "",
                },
                start: sim_kernel::Start::Given,
                speed_given: false,
            },
            sim_kernel::Coordinate {
                position: sim_kernel::Quantity {
                    name: "crank_angle_1",
                    unit: "rad",
                    factor: 1f64,
                    docs: "Angle of crank 1.",
                },
                speed: sim_kernel::Quantity {
                    name: "crank_angle_1_dot",
                    unit: "rad/s",
                    factor: 1f64,
                    docs: "",
                },
                acceleration: sim_kernel::Quantity {
                    name: "crank_angle_1_ddot",
                    unit: "rad/s^2",
                    factor: 1f64,
                    docs: "",
                },
                start: sim_kernel::Start::Guess,
                speed_given: false,
            },
            sim_kernel::Coordinate {
                position: sim_kernel::Quantity {
                    name: "crank_angle_2",
                    unit: "rad",
                    factor: 1f64,
                    docs: "Angle of crank 2.",
                },
                speed: sim_kernel::Quantity {
                    name: "crank_angle_2_dot",
                    unit: "rad/s",
                    factor: 1f64,
                    docs: "",
                },
                acceleration: sim_kernel::Quantity {
                    name: "crank_angle_2_ddot",
                    unit: "rad/s^2",
                    factor: 1f64,
                    docs: "",
                },
                start: sim_kernel::Start::Guess,
                speed_given: false,
            },
            sim_kernel::Coordinate {
                position: sim_kernel::Quantity {
                    name: "crank_angle_3",
                    unit: "rad",
                    factor: 1f64,
                    docs: "Angle of crank 3.",
                },
                speed: sim_kernel::Quantity {
                    name: "crank_angle_3_dot",
                    unit: "rad/s",
                    factor: 1f64,
                    docs: "",
                },
                acceleration: sim_kernel::Quantity {
                    name: "crank_angle_3_ddot",
                    unit: "rad/s^2",
                    factor: 1f64,
                    docs: "",
                },
                start: sim_kernel::Start::Guess,
                speed_given: false,
            },
            sim_kernel::Coordinate {
                position: sim_kernel::Quantity {
                    name: "coupler_angle_1",
                    unit: "rad",
                    factor: 1f64,
                    docs: "Angle of coupler 1.",
                },
                speed: sim_kernel::Quantity {
                    name: "coupler_angle_1_dot",
                    unit: "rad/s",
                    factor: 1f64,
                    docs: "",
                },
                acceleration: sim_kernel::Quantity {
                    name: "coupler_angle_1_ddot",
                    unit: "rad/s^2",
                    factor: 1f64,
                    docs: "",
                },
                start: sim_kernel::Start::Guess,
                speed_given: false,
            },
            sim_kernel::Coordinate {
                position: sim_kernel::Quantity {
                    name: "coupler_angle_2",
                    unit: "rad",
                    factor: 1f64,
                    docs: "Angle of coupler 2.",
                },
                speed: sim_kernel::Quantity {
                    name: "coupler_angle_2_dot",
                    unit: "rad/s",
                    factor: 1f64,
                    docs: "",
                },
                acceleration: sim_kernel::Quantity {
                    name: "coupler_angle_2_ddot",
                    unit: "rad/s^2",
                    factor: 1f64,
                    docs: "",
                },
                start: sim_kernel::Start::Guess,
                speed_given: false,
            },
            sim_kernel::Coordinate {
                position: sim_kernel::Quantity {
                    name: "coupler_angle_3",
                    unit: "rad",
                    factor: 1f64,
                    docs: "Angle of coupler 3.",
                },
                speed: sim_kernel::Quantity {
                    name: "coupler_angle_3_dot",
                    unit: "rad/s",
                    factor: 1f64,
                    docs: "",
                },
                acceleration: sim_kernel::Quantity {
                    name: "coupler_angle_3_ddot",
                    unit: "rad/s^2",
                    factor: 1f64,
                    docs: "",
                },
                start: sim_kernel::Start::Guess,
                speed_given: false,
            },
        ],
        parameters: &[
            sim_kernel::Quantity {
                name: "l",
                unit: "m",
                factor: 1f64,
                docs: "Length of each bar.",
            },
            sim_kernel::Quantity {
                name: "m",
                unit: "kg",
                factor: 1f64,
                docs: "Mass of each bar.",
            },
            sim_kernel::Quantity {
                name: "start",
                unit: "deg",
                factor: 0.017453292519943295f64,
                docs: "Angle of the cranks at the start.",
            },
            sim_kernel::Quantity {
                name: "g",
                unit: "m/s^2",
                factor: 1f64,
                docs: "",
            },
        ],
        inputs: &[],
        constraints: &[
            sim_kernel::Quantity {
                name: "loop_1_x",
                unit: "N",
                factor: 1f64,
                docs: "",
            },
            sim_kernel::Quantity {
                name: "loop_1_y",
                unit: "N",
                factor: 1f64,
                docs: "",
            },
            sim_kernel::Quantity {
                name: "loop_2_x",
                unit: "N",
                factor: 1f64,
                docs: "",
            },
            sim_kernel::Quantity {
                name: "loop_2_y",
                unit: "N",
                factor: 1f64,
                docs: "",
            },
            sim_kernel::Quantity {
                name: "loop_3_x",
                unit: "N",
                factor: 1f64,
                docs: "",
            },
            sim_kernel::Quantity {
                name: "loop_3_y",
                unit: "N",
                factor: 1f64,
                docs: "",
            },
        ],
        speed_constraints: &[],
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
                name: "first",
                unit: "deg",
                factor: 0.017453292519943295f64,
                docs: "first",
            },
            sim_kernel::Quantity {
                name: "last",
                unit: "deg",
                factor: 0.017453292519943295f64,
                docs: "last",
            },
            sim_kernel::Quantity {
                name: "Fx",
                unit: "N",
                factor: 1f64,
                docs: "along x",
            },
            sim_kernel::Quantity {
                name: "Fy",
                unit: "N",
                factor: 1f64,
                docs: "along y",
            },
        ],
        rated_outputs: &[0, 1],
        figures: &[
            sim_kernel::Figure {
                name: "cranks",
                title: "Angles of the cranks",
                len: 2,
            },
            sim_kernel::Figure {
                name: "pins",
                title: "Force on the last crank",
                len: 2,
            },
        ],
        dimension: 2,
        drawing: &[
            sim_kernel::Shape::Line(2),
            sim_kernel::Shape::Ground(1),
            sim_kernel::Shape::Line(2),
            sim_kernel::Shape::Ground(1),
            sim_kernel::Shape::Line(2),
            sim_kernel::Shape::Ground(1),
            sim_kernel::Shape::Line(2),
            sim_kernel::Shape::Ground(1),
            sim_kernel::Shape::Line(2),
            sim_kernel::Shape::Points(1),
            sim_kernel::Shape::Line(2),
            sim_kernel::Shape::Points(1),
            sim_kernel::Shape::Line(2),
            sim_kernel::Shape::Points(1),
        ],
    };
    fn defaults() -> Self {
        Self {
            l: S::from_f64(1f64),
            m: S::from_f64(1f64),
            start: S::from_f64(-0.6981317007977318f64),
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
    ) -> FourBars<T> {
        FourBars {
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
    fn prepare(&self) -> FourBarsPrepared<S> {
        self.prepare()
    }
    #[inline(always)]
    fn prepared_dynamics(
        prepared: &Self::Prepared,
        t: S,
        q: &[S; 7],
        qd: &[S; 7],
    ) -> sim_kernel::Dynamics<S, [S; 7], [S; 6]> {
        prepared.dynamics(t, q, qd)
    }
    #[inline(always)]
    fn dynamics_jacobian(
        &self,
        t: S,
        q: &[S; 7],
        qd: &[S; 7],
    ) -> sim_kernel::DynamicsJacobian<S, [[S; 7]; 7], [[S; 7]; 6]> {
        self.prepare().dynamics_jacobian(t, q, qd)
    }
    #[inline(always)]
    fn mass_matrix(&self, t: S, q: &[S; 7]) -> [[S; 7]; 7] {
        self.mass_matrix(t, q)
    }
    #[inline(always)]
    fn convective_forces(&self, t: S, q: &[S; 7], qd: &[S; 7]) -> [S; 7] {
        self.convective_forces(t, q, qd)
    }
    #[inline(always)]
    fn generalized_forces(&self, t: S, q: &[S; 7], qd: &[S; 7]) -> [S; 7] {
        self.generalized_forces(t, q, qd)
    }
    #[inline(always)]
    fn constraints(&self, t: S, q: &[S; 7]) -> [S; 6] {
        self.constraints(t, q)
    }
    #[inline(always)]
    fn constraint_magnitudes(&self, t: S, q: &[S; 7]) -> [S; 6] {
        self.constraint_magnitudes(t, q)
    }
    #[inline(always)]
    fn constraint_jacobian(&self, t: S, q: &[S; 7]) -> [[S; 7]; 6] {
        self.constraint_jacobian(t, q)
    }
    #[inline(always)]
    fn constraint_time_derivative(&self, t: S, q: &[S; 7]) -> [S; 6] {
        self.constraint_time_derivative(t, q)
    }
    #[inline(always)]
    fn constraint_convective(&self, t: S, q: &[S; 7], qd: &[S; 7]) -> [S; 6] {
        self.constraint_convective(t, q, qd)
    }
    #[inline(always)]
    fn constraint_linearization(
        &self,
        t: S,
        q: &[S; 7],
    ) -> sim_kernel::ConstraintLinearization<[S; 6], [[S; 7]; 6]> {
        self.constraint_linearization(t, q)
    }
    #[inline(always)]
    fn kinetic_energy(&self, t: S, q: &[S; 7], qd: &[S; 7]) -> S {
        self.kinetic_energy(t, q, qd)
    }
    #[inline(always)]
    fn power(&self, t: S, q: &[S; 7], qd: &[S; 7], qdd: &[S; 7], lambda: &[S; 6]) -> S {
        self.power(t, q, qd, qdd, lambda)
    }
    #[inline(always)]
    fn outputs(
        &self,
        t: S,
        q: &[S; 7],
        qd: &[S; 7],
        qdd: &[S; 7],
        lambda: &[S; 6],
    ) -> [S; 4] {
        self.outputs(t, q, qd, qdd, lambda).into()
    }
    #[inline(always)]
    fn output_rates(&self, t: S, q: &[S; 7], qd: &[S; 7], qdd: &[S; 7]) -> [S; 2] {
        self.output_rates(t, q, qd, qdd).into()
    }
    #[inline(always)]
    fn events(
        &self,
        t: S,
        q: &[S; 7],
        qd: &[S; 7],
        qdd: &[S; 7],
        lambda: &[S; 6],
    ) -> [S; 1] {
        self.events(t, q, qd, qdd, lambda)
    }
    #[inline(always)]
    fn drawing(&self, t: S, q: &[S; 7]) -> [S; 42] {
        self.drawing(t, q)
    }
    #[inline(always)]
    fn initial(&self) -> sim_kernel::Initial<[S; 7]> {
        self.initial()
    }
}
