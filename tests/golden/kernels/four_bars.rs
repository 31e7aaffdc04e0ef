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
    l_lambda_loop_1_y_turned_crank_angle_0: S,
    minus_pivot_lambda_loop_1_y_turned: S,
    pivot_lambda_loop_1_y_turned: S,
    minus_inverse_lambda_loop_1_y_turned: S,
    k_7: S,
    inverse_coupler_angle_2: S,
    l_lambda_loop_2_y_turned_coupler_angle_2: S,
    minus_pivot_lambda_loop_2_y_turned: S,
    pivot_lambda_loop_2_y_turned: S,
    minus_inverse_lambda_loop_2_y_turned: S,
    k_8: S,
    k_9: S,
    k_10: S,
}
#[allow(non_snake_case, unused_variables, unused_parens, clippy::all, clippy::pedantic)]
impl<S: sim_kernel::Scalar> FourBars<S> {
    /// What the equations of motion need of the parameters, computed once for a set of parameters.
    ///
    /// Operations: 4 additions, 24 multiplications, 4 divisions.
    #[inline]
    pub fn prepare(&self) -> FourBarsPrepared<S> {
        let l_squared = self.l * self.l;
        let mass_crank_angle_0_crank_angle_0 = S::from_f64(1.3333333333333333)
            * l_squared * self.m;
        let mass_crank_angle_3_crank_angle_3 = l_squared * self.m
            * S::from_f64(0.3333333333333333);
        let w = l_squared * self.m * S::from_f64(0.5);
        let w_2 = self.l * self.m;
        let w_3 = S::from_f64(1.0) / mass_crank_angle_0_crank_angle_0;
        let w_4 = self.l * w_3;
        let w_5 = self.l * w_4;
        let w_6 = S::from_f64(1.0) / mass_crank_angle_3_crank_angle_3;
        let w_7 = self.l * w_6;
        let w_8 = self.l * w_7;
        FourBarsPrepared {
            l: self.l,
            mass_crank_angle_0_crank_angle_0: mass_crank_angle_0_crank_angle_0,
            mass_crank_angle_3_crank_angle_3: mass_crank_angle_3_crank_angle_3,
            k: w,
            k_2: self.l * S::from_f64(2.0),
            k_3: S::from_f64(0.5) * w_2,
            k_4: S::from_f64(1.5) * self.g * w_2,
            k_5: S::from_f64(0.5) * self.g * w_2,
            k_6: w_2 * S::from_f64(0.25),
            inverse_crank_angle_0: w_3,
            l_lambda_loop_1_y_turned_crank_angle_0: w_4,
            minus_pivot_lambda_loop_1_y_turned: w_5,
            pivot_lambda_loop_1_y_turned: -w_5,
            minus_inverse_lambda_loop_1_y_turned: S::from_f64(1.0) / w_5,
            k_7: self.l - w * w_4,
            inverse_coupler_angle_2: w_6,
            l_lambda_loop_2_y_turned_coupler_angle_2: w_7,
            minus_pivot_lambda_loop_2_y_turned: w_8,
            pivot_lambda_loop_2_y_turned: -w_8,
            minus_inverse_lambda_loop_2_y_turned: S::from_f64(1.0) / w_8,
            k_8: self.l - w * w_7,
            k_9: l_squared * self.m,
            k_10: l_squared * self.m * S::from_f64(0.25),
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
        let w_2 = sin_crank_angle_0 * cos_coupler_angle_1
            - cos_crank_angle_0 * sin_coupler_angle_1;
        let w_3 = sin_crank_angle_1 * cos_coupler_angle_2
            - cos_crank_angle_1 * sin_coupler_angle_2;
        let w_4 = sin_crank_angle_2 * cos_coupler_angle_3
            - cos_crank_angle_2 * sin_coupler_angle_3;
        [
            w * coupler_angle_1_dot * coupler_angle_1_dot * w_2,
            w * coupler_angle_2_dot * coupler_angle_2_dot * w_3,
            w * coupler_angle_3_dot * coupler_angle_3_dot * w_4,
            S::from_f64(0.0),
            -(crank_angle_0_dot * crank_angle_0_dot * w * w_2),
            -(w * crank_angle_1_dot * crank_angle_1_dot * w_3),
            -(w * crank_angle_2_dot * crank_angle_2_dot * w_4),
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
        let w_10 = crank_angle_2_dot * w;
        let w_7 = self.l * coupler_angle_2_dot;
        let w_8 = sin_crank_angle_1 * w_6 + sin_coupler_angle_2 * w_7;
        let w_9 = w_6 * cos_crank_angle_1 + w_7 * cos_coupler_angle_2;
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
    /// Operations: 7 additions, 14 multiplications, 7 sine-cosine pairs.
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
        let w = self.l * self.m;
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
        let w_2 = S::from_f64(0.5) * self.g * w
            * (crank_angle_3_dot * cos_crank_angle_3
                + coupler_angle_1_dot * cos_coupler_angle_1
                + coupler_angle_2_dot * cos_coupler_angle_2
                + coupler_angle_3_dot * cos_coupler_angle_3);
        -(w_2
            + self.g * w * S::from_f64(1.5)
                * (crank_angle_0_dot * cos_crank_angle_0
                    + crank_angle_1_dot * cos_crank_angle_1
                    + crank_angle_2_dot * cos_crank_angle_2))
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
            crank_2_base_x + self.l * (cos_crank_angle_2 + cos_coupler_angle_3),
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
    /// by an elimination planned from the structure of the system, with pairs of constraint rows turned along and across links. Where `refused` is set a pivot was too small and nothing else holds: solve that state from the other kernels.
    ///
    /// Operations: 122 additions, 217 multiplications, 7 divisions, 7 sine-cosine pairs.
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
        let w = sin_crank_angle_0 * cos_coupler_angle_1
            - sin_coupler_angle_1 * cos_crank_angle_0;
        let w_2 = self.k * w;
        let minus_rhs_crank_angle_0 = cos_crank_angle_0 * self.k_4
            + coupler_angle_1_dot_squared * w_2;
        let w_3 = cos_crank_angle_0 * sin_crank_angle_1
            - sin_crank_angle_0 * cos_crank_angle_1;
        let crank_angle_1_dot_squared = crank_angle_1_dot * crank_angle_1_dot;
        let rhs_lambda_loop_1_y_turned = minus_rhs_crank_angle_0
            * self.l_lambda_loop_1_y_turned_crank_angle_0
            - self.l
                * (w_3 * crank_angle_1_dot_squared + w * coupler_angle_1_dot_squared);
        let k_lambda_loop_1_x_turned_coupler_angle_1 = self.l * w;
        let w_4 = sin_coupler_angle_2 * cos_crank_angle_1
            - sin_crank_angle_1 * cos_coupler_angle_2;
        let w_5 = self.k * w_4;
        let minus_rhs_coupler_angle_2 = cos_coupler_angle_2 * self.k_5
            + crank_angle_1_dot_squared * w_5;
        let w_6 = cos_coupler_angle_2 * sin_crank_angle_2
            - sin_coupler_angle_2 * cos_crank_angle_2;
        let crank_angle_2_dot_squared = crank_angle_2_dot * crank_angle_2_dot;
        let rhs_lambda_loop_2_y_turned = minus_rhs_coupler_angle_2
            * self.l_lambda_loop_2_y_turned_coupler_angle_2
            - self.l
                * (w_4 * crank_angle_1_dot_squared + w_6 * crank_angle_2_dot_squared);
        let k_lambda_loop_2_x_turned_crank_angle_1 = self.l * w_4;
        let crank_angle_0_dot_squared = crank_angle_0_dot * crank_angle_0_dot;
        let w_7 = sin_crank_angle_0 * sin_coupler_angle_1
            + cos_crank_angle_0 * cos_coupler_angle_1;
        let mass_coupler_angle_1_crank_angle_0 = self.k * w_7;
        let l_coupler_angle_1_crank_angle_0 = mass_coupler_angle_1_crank_angle_0
            * self.inverse_crank_angle_0;
        let k_coupler_angle_1_lambda_loop_1_y_turned = w_7 * self.k_7;
        let minus_l_coupler_angle_1_lambda_loop_1_y_turned = self
            .minus_inverse_lambda_loop_1_y_turned
            * k_coupler_angle_1_lambda_loop_1_y_turned;
        let rhs_coupler_angle_1 = crank_angle_0_dot_squared * w_2
            - cos_coupler_angle_1 * self.k_5
            + minus_rhs_crank_angle_0 * l_coupler_angle_1_crank_angle_0
            + minus_l_coupler_angle_1_lambda_loop_1_y_turned
                * rhs_lambda_loop_1_y_turned;
        let w_10 = k_coupler_angle_1_lambda_loop_1_y_turned
            * minus_l_coupler_angle_1_lambda_loop_1_y_turned;
        let pivot_coupler_angle_1 = self.mass_crank_angle_3_crank_angle_3
            - mass_coupler_angle_1_crank_angle_0 * l_coupler_angle_1_crank_angle_0
            + w_10;
        let coupler_angle_2_dot_squared = coupler_angle_2_dot * coupler_angle_2_dot;
        let w_8 = sin_crank_angle_0 * sin_crank_angle_1
            + cos_crank_angle_0 * cos_crank_angle_1;
        let minus_k_crank_angle_1_lambda_loop_1_y_turned = self.l * w_8;
        let l_crank_angle_1_lambda_loop_1_y_turned = minus_k_crank_angle_1_lambda_loop_1_y_turned
            * self.minus_inverse_lambda_loop_1_y_turned;
        let w_9 = sin_crank_angle_1 * sin_coupler_angle_2
            + cos_crank_angle_1 * cos_coupler_angle_2;
        let mass_coupler_angle_2_crank_angle_1 = self.k * w_9;
        let l_crank_angle_1_coupler_angle_2 = mass_coupler_angle_2_crank_angle_1
            * self.inverse_coupler_angle_2;
        let k_crank_angle_1_lambda_loop_2_y_turned = w_9 * self.k_8;
        let minus_l_crank_angle_1_lambda_loop_2_y_turned = self
            .minus_inverse_lambda_loop_2_y_turned
            * k_crank_angle_1_lambda_loop_2_y_turned;
        let minus_k_crank_angle_1_coupler_angle_1 = minus_k_crank_angle_1_lambda_loop_1_y_turned
            * minus_l_coupler_angle_1_lambda_loop_1_y_turned;
        let w_18 = minus_k_crank_angle_1_lambda_loop_1_y_turned
            * l_crank_angle_1_lambda_loop_1_y_turned;
        let inverse_coupler_angle_1 = S::from_f64(1.0) / pivot_coupler_angle_1;
        let minus_l_crank_angle_1_coupler_angle_1 = minus_k_crank_angle_1_coupler_angle_1
            * inverse_coupler_angle_1;
        let rhs_crank_angle_1 = coupler_angle_2_dot_squared * w_5
            - cos_crank_angle_1 * self.k_4
            - l_crank_angle_1_lambda_loop_1_y_turned * rhs_lambda_loop_1_y_turned
            + minus_rhs_coupler_angle_2 * l_crank_angle_1_coupler_angle_2
            + minus_l_crank_angle_1_lambda_loop_2_y_turned * rhs_lambda_loop_2_y_turned
            + minus_l_crank_angle_1_coupler_angle_1 * rhs_coupler_angle_1;
        let w_11 = self.k * sin_crank_angle_2;
        let w_12 = self.k * sin_coupler_angle_3;
        let w_13 = cos_coupler_angle_3 * cos_crank_angle_3
            + sin_coupler_angle_3 * sin_crank_angle_3;
        let k_coupler_angle_3_lambda_loop_3_y_turned = self.l * w_13;
        let minus_l_coupler_angle_3_lambda_loop_3_y_turned = k_coupler_angle_3_lambda_loop_3_y_turned
            * self.minus_inverse_lambda_loop_2_y_turned;
        let pivot_coupler_angle_3 = self.mass_crank_angle_3_crank_angle_3
            + k_coupler_angle_3_lambda_loop_3_y_turned
                * minus_l_coupler_angle_3_lambda_loop_3_y_turned;
        let w_14 = cos_crank_angle_2 * sin_crank_angle_3
            - sin_crank_angle_2 * cos_crank_angle_3;
        let w_15 = cos_coupler_angle_3 * sin_crank_angle_3
            - sin_coupler_angle_3 * cos_crank_angle_3;
        let coupler_angle_3_dot_squared = coupler_angle_3_dot * coupler_angle_3_dot;
        let minus_rhs_crank_angle_3 = cos_crank_angle_3 * self.k_5;
        let minus_rhs_lambda_loop_3_y_turned = self.l
            * (w_14 * crank_angle_2_dot_squared + w_15 * coupler_angle_3_dot_squared)
            + minus_rhs_crank_angle_3 * self.l_lambda_loop_2_y_turned_coupler_angle_2;
        let k_lambda_loop_3_x_turned_coupler_angle_3 = self.l * w_15;
        let rhs_coupler_angle_3 = cos_coupler_angle_3
            * (crank_angle_2_dot_squared * w_11 - self.k_5)
            - cos_crank_angle_2 * crank_angle_2_dot_squared * w_12
            - minus_l_coupler_angle_3_lambda_loop_3_y_turned
                * minus_rhs_lambda_loop_3_y_turned;
        let w_16 = cos_coupler_angle_2 * cos_crank_angle_2
            + sin_coupler_angle_2 * sin_crank_angle_2;
        let minus_k_crank_angle_2_lambda_loop_2_y_turned = self.l * w_16;
        let l_crank_angle_2_lambda_loop_2_y_turned = minus_k_crank_angle_2_lambda_loop_2_y_turned
            * self.minus_inverse_lambda_loop_2_y_turned;
        let w_20 = minus_k_crank_angle_2_lambda_loop_2_y_turned
            * l_crank_angle_2_lambda_loop_2_y_turned;
        let w_17 = sin_crank_angle_2 * sin_crank_angle_3
            + cos_crank_angle_2 * cos_crank_angle_3;
        let k_crank_angle_2_lambda_loop_3_y_turned = self.l * w_17;
        let minus_l_crank_angle_2_lambda_loop_3_y_turned = k_crank_angle_2_lambda_loop_3_y_turned
            * self.minus_inverse_lambda_loop_2_y_turned;
        let minus_k_crank_angle_2_crank_angle_1 = k_crank_angle_1_lambda_loop_2_y_turned
            * l_crank_angle_2_lambda_loop_2_y_turned;
        let w_19 = k_crank_angle_1_lambda_loop_2_y_turned
            * minus_l_crank_angle_1_lambda_loop_2_y_turned;
        let pivot_crank_angle_1 = self.mass_crank_angle_0_crank_angle_0 + w_18
            - mass_coupler_angle_2_crank_angle_1 * l_crank_angle_1_coupler_angle_2 + w_19
            - minus_k_crank_angle_1_coupler_angle_1
                * minus_l_crank_angle_1_coupler_angle_1;
        let inverse_crank_angle_1 = S::from_f64(1.0) / pivot_crank_angle_1;
        let minus_l_crank_angle_2_crank_angle_1 = minus_k_crank_angle_2_crank_angle_1
            * inverse_crank_angle_1;
        let inverse_coupler_angle_3 = S::from_f64(1.0) / pivot_coupler_angle_3;
        let k_crank_angle_2_coupler_angle_3 = self.k
            * (sin_crank_angle_2 * sin_coupler_angle_3
                + cos_crank_angle_2 * cos_coupler_angle_3)
            + k_crank_angle_2_lambda_loop_3_y_turned
                * minus_l_coupler_angle_3_lambda_loop_3_y_turned;
        let w_21 = k_crank_angle_2_lambda_loop_3_y_turned
            * minus_l_crank_angle_2_lambda_loop_3_y_turned;
        let l_crank_angle_2_coupler_angle_3 = inverse_coupler_angle_3
            * k_crank_angle_2_coupler_angle_3;
        let l_lambda_loop_1_x_turned_coupler_angle_1 = k_lambda_loop_1_x_turned_coupler_angle_1
            * inverse_coupler_angle_1;
        let k_lambda_loop_1_x_turned_crank_angle_1 = self.l * w_3
            + minus_k_crank_angle_1_coupler_angle_1
                * l_lambda_loop_1_x_turned_coupler_angle_1;
        let l_lambda_loop_1_x_turned_crank_angle_1 = inverse_crank_angle_1
            * k_lambda_loop_1_x_turned_crank_angle_1;
        let minus_pivot_lambda_loop_1_x_turned = k_lambda_loop_1_x_turned_coupler_angle_1
            * l_lambda_loop_1_x_turned_coupler_angle_1
            + k_lambda_loop_1_x_turned_crank_angle_1
                * l_lambda_loop_1_x_turned_crank_angle_1;
        let minus_rhs_lambda_loop_1_x_turned = self.l
            * (w_8 * crank_angle_1_dot_squared - crank_angle_0_dot_squared
                - w_7 * coupler_angle_1_dot_squared)
            + l_lambda_loop_1_x_turned_coupler_angle_1 * rhs_coupler_angle_1
            + l_lambda_loop_1_x_turned_crank_angle_1 * rhs_crank_angle_1;
        let k_crank_angle_2_lambda_loop_1_x_turned = minus_k_crank_angle_2_crank_angle_1
            * l_lambda_loop_1_x_turned_crank_angle_1;
        let minus_inverse_lambda_loop_1_x_turned = S::from_f64(1.0)
            / minus_pivot_lambda_loop_1_x_turned;
        let minus_l_crank_angle_2_lambda_loop_1_x_turned = k_crank_angle_2_lambda_loop_1_x_turned
            * minus_inverse_lambda_loop_1_x_turned;
        let rhs_crank_angle_2 = cos_crank_angle_2
            * (coupler_angle_3_dot_squared * w_12 - self.k_4)
            - cos_coupler_angle_3 * coupler_angle_3_dot_squared * w_11
            - l_crank_angle_2_lambda_loop_2_y_turned * rhs_lambda_loop_2_y_turned
            - minus_l_crank_angle_2_lambda_loop_3_y_turned
                * minus_rhs_lambda_loop_3_y_turned
            + minus_l_crank_angle_2_crank_angle_1 * rhs_crank_angle_1
            - l_crank_angle_2_coupler_angle_3 * rhs_coupler_angle_3
            - minus_l_crank_angle_2_lambda_loop_1_x_turned
                * minus_rhs_lambda_loop_1_x_turned;
        let l_lambda_loop_2_x_turned_crank_angle_1 = k_lambda_loop_2_x_turned_crank_angle_1
            * inverse_crank_angle_1;
        let minus_k_lambda_loop_2_x_turned_lambda_loop_1_x_turned = k_lambda_loop_1_x_turned_crank_angle_1
            * l_lambda_loop_2_x_turned_crank_angle_1;
        let l_lambda_loop_2_x_turned_lambda_loop_1_x_turned = minus_k_lambda_loop_2_x_turned_lambda_loop_1_x_turned
            * minus_inverse_lambda_loop_1_x_turned;
        let k_lambda_loop_2_x_turned_crank_angle_2 = self.l * w_6
            + minus_k_crank_angle_2_crank_angle_1
                * l_lambda_loop_2_x_turned_crank_angle_1
            - k_crank_angle_2_lambda_loop_1_x_turned
                * l_lambda_loop_2_x_turned_lambda_loop_1_x_turned;
        let w_22 = k_crank_angle_2_lambda_loop_1_x_turned
            * minus_l_crank_angle_2_lambda_loop_1_x_turned;
        let pivot_crank_angle_2 = self.mass_crank_angle_0_crank_angle_0 + w_20 + w_21
            - minus_k_crank_angle_2_crank_angle_1 * minus_l_crank_angle_2_crank_angle_1
            - k_crank_angle_2_coupler_angle_3 * l_crank_angle_2_coupler_angle_3 + w_22;
        let inverse_crank_angle_2 = S::from_f64(1.0) / pivot_crank_angle_2;
        let l_lambda_loop_2_x_turned_crank_angle_2 = inverse_crank_angle_2
            * k_lambda_loop_2_x_turned_crank_angle_2;
        let rhs_lambda_loop_2_x_turned = l_lambda_loop_2_x_turned_lambda_loop_1_x_turned
            * minus_rhs_lambda_loop_1_x_turned
            - self.l
                * (w_16 * crank_angle_2_dot_squared - coupler_angle_2_dot_squared
                    - w_9 * crank_angle_1_dot_squared)
            - l_lambda_loop_2_x_turned_crank_angle_1 * rhs_crank_angle_1
            - l_lambda_loop_2_x_turned_crank_angle_2 * rhs_crank_angle_2;
        let w_23 = k_lambda_loop_2_x_turned_crank_angle_1
            * l_lambda_loop_2_x_turned_crank_angle_1
            + k_lambda_loop_2_x_turned_crank_angle_2
                * l_lambda_loop_2_x_turned_crank_angle_2;
        let pivot_lambda_loop_2_x_turned = minus_k_lambda_loop_2_x_turned_lambda_loop_1_x_turned
            * l_lambda_loop_2_x_turned_lambda_loop_1_x_turned - w_23;
        let l_lambda_loop_3_x_turned_coupler_angle_3 = k_lambda_loop_3_x_turned_coupler_angle_3
            * inverse_coupler_angle_3;
        let k_lambda_loop_3_x_turned_crank_angle_2 = self.l * w_14
            - k_crank_angle_2_coupler_angle_3 * l_lambda_loop_3_x_turned_coupler_angle_3;
        let l_lambda_loop_3_x_turned_crank_angle_2 = inverse_crank_angle_2
            * k_lambda_loop_3_x_turned_crank_angle_2;
        let minus_k_lambda_loop_3_x_turned_lambda_loop_2_x_turned = k_lambda_loop_2_x_turned_crank_angle_2
            * l_lambda_loop_3_x_turned_crank_angle_2;
        let w_24 = k_lambda_loop_3_x_turned_coupler_angle_3
            * l_lambda_loop_3_x_turned_coupler_angle_3
            + k_lambda_loop_3_x_turned_crank_angle_2
                * l_lambda_loop_3_x_turned_crank_angle_2;
        let inverse_lambda_loop_2_x_turned = S::from_f64(1.0)
            / pivot_lambda_loop_2_x_turned;
        let minus_l_lambda_loop_3_x_turned_lambda_loop_2_x_turned = minus_k_lambda_loop_3_x_turned_lambda_loop_2_x_turned
            * inverse_lambda_loop_2_x_turned;
        let minus_pivot_lambda_loop_3_x_turned = w_24
            + minus_k_lambda_loop_3_x_turned_lambda_loop_2_x_turned
                * minus_l_lambda_loop_3_x_turned_lambda_loop_2_x_turned;
        let w_25 = S::from_f64(1.0) / minus_pivot_lambda_loop_3_x_turned
            * (minus_l_lambda_loop_3_x_turned_lambda_loop_2_x_turned
                * rhs_lambda_loop_2_x_turned
                - self.l
                    * (crank_angle_3_dot * crank_angle_3_dot
                        - w_17 * crank_angle_2_dot_squared
                        - w_13 * coupler_angle_3_dot_squared)
                - l_lambda_loop_3_x_turned_coupler_angle_3 * rhs_coupler_angle_3
                - l_lambda_loop_3_x_turned_crank_angle_2 * rhs_crank_angle_2);
        let w_26 = inverse_lambda_loop_2_x_turned * rhs_lambda_loop_2_x_turned
            - minus_l_lambda_loop_3_x_turned_lambda_loop_2_x_turned * w_25;
        let crank_angle_2_ddot = inverse_crank_angle_2 * rhs_crank_angle_2
            - l_lambda_loop_2_x_turned_crank_angle_2 * w_26
            + l_lambda_loop_3_x_turned_crank_angle_2 * w_25;
        let w_27 = minus_inverse_lambda_loop_1_x_turned
            * minus_rhs_lambda_loop_1_x_turned
            + minus_l_crank_angle_2_lambda_loop_1_x_turned * crank_angle_2_ddot
            - l_lambda_loop_2_x_turned_lambda_loop_1_x_turned * w_26;
        let crank_angle_1_ddot = inverse_crank_angle_1 * rhs_crank_angle_1
            + minus_l_crank_angle_2_crank_angle_1 * crank_angle_2_ddot
            - l_lambda_loop_1_x_turned_crank_angle_1 * w_27
            - l_lambda_loop_2_x_turned_crank_angle_1 * w_26;
        let coupler_angle_1_ddot = inverse_coupler_angle_1 * rhs_coupler_angle_1
            + minus_l_crank_angle_1_coupler_angle_1 * crank_angle_1_ddot
            - l_lambda_loop_1_x_turned_coupler_angle_1 * w_27;
        let w_28 = minus_l_coupler_angle_1_lambda_loop_1_y_turned * coupler_angle_1_ddot
            - self.minus_inverse_lambda_loop_1_y_turned * rhs_lambda_loop_1_y_turned
            - l_crank_angle_1_lambda_loop_1_y_turned * crank_angle_1_ddot;
        let w_30 = minus_l_crank_angle_1_lambda_loop_2_y_turned * crank_angle_1_ddot
            - self.minus_inverse_lambda_loop_2_y_turned * rhs_lambda_loop_2_y_turned
            - l_crank_angle_2_lambda_loop_2_y_turned * crank_angle_2_ddot;
        let coupler_angle_3_ddot = inverse_coupler_angle_3 * rhs_coupler_angle_3
            - l_crank_angle_2_coupler_angle_3 * crank_angle_2_ddot
            + l_lambda_loop_3_x_turned_coupler_angle_3 * w_25;
        let w_29 = self.minus_inverse_lambda_loop_2_y_turned
            * minus_rhs_lambda_loop_3_y_turned
            + minus_l_crank_angle_2_lambda_loop_3_y_turned * crank_angle_2_ddot
            + minus_l_coupler_angle_3_lambda_loop_3_y_turned * coupler_angle_3_ddot;
        let w_31 = self.k_5
            * (cos_crank_angle_3 * crank_angle_3_dot
                + cos_coupler_angle_1 * coupler_angle_1_dot
                + cos_coupler_angle_2 * coupler_angle_2_dot
                + cos_coupler_angle_3 * coupler_angle_3_dot)
            + self.k_4
                * (cos_crank_angle_0 * crank_angle_0_dot
                    + cos_crank_angle_1 * crank_angle_1_dot
                    + cos_crank_angle_2 * crank_angle_2_dot);
        sim_kernel::Dynamics {
            accelerations: [
                -(minus_rhs_crank_angle_0 * self.inverse_crank_angle_0
                    + l_coupler_angle_1_crank_angle_0 * coupler_angle_1_ddot
                    + self.l_lambda_loop_1_y_turned_crank_angle_0 * w_28),
                crank_angle_1_ddot,
                crank_angle_2_ddot,
                self.l_lambda_loop_2_y_turned_coupler_angle_2 * w_29
                    - minus_rhs_crank_angle_3 * self.inverse_coupler_angle_2,
                coupler_angle_1_ddot,
                -(minus_rhs_coupler_angle_2 * self.inverse_coupler_angle_2
                    + l_crank_angle_1_coupler_angle_2 * crank_angle_1_ddot
                    + self.l_lambda_loop_2_y_turned_coupler_angle_2 * w_30),
                coupler_angle_3_ddot,
            ],
            multipliers: [
                cos_crank_angle_0 * w_27 - sin_crank_angle_0 * w_28,
                sin_crank_angle_0 * w_27 + cos_crank_angle_0 * w_28,
                cos_coupler_angle_2 * w_26 - sin_coupler_angle_2 * w_30,
                sin_coupler_angle_2 * w_26 + cos_coupler_angle_2 * w_30,
                -(cos_crank_angle_3 * w_25 + sin_crank_angle_3 * w_29),
                cos_crank_angle_3 * w_29 - sin_crank_angle_3 * w_25,
            ],
            power: -w_31,
            refused: sim_kernel::pivot_is_refused(
                self.mass_crank_angle_0_crank_angle_0,
                self.mass_crank_angle_0_crank_angle_0,
            )
                | sim_kernel::pivot_is_refused(
                    self.pivot_lambda_loop_1_y_turned,
                    self.minus_pivot_lambda_loop_1_y_turned,
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
                    self.pivot_lambda_loop_2_y_turned,
                    self.minus_pivot_lambda_loop_2_y_turned,
                )
                | sim_kernel::pivot_is_refused(
                    pivot_coupler_angle_1,
                    self.mass_crank_angle_3_crank_angle_3 + w_10,
                )
                | sim_kernel::pivot_is_refused(
                    self.pivot_lambda_loop_2_y_turned,
                    self.minus_pivot_lambda_loop_2_y_turned,
                )
                | sim_kernel::pivot_is_refused(
                    pivot_crank_angle_1,
                    self.mass_crank_angle_0_crank_angle_0 + w_18 + w_19,
                )
                | sim_kernel::pivot_is_refused(
                    pivot_coupler_angle_3,
                    pivot_coupler_angle_3,
                )
                | sim_kernel::pivot_is_refused(
                    -minus_pivot_lambda_loop_1_x_turned,
                    minus_pivot_lambda_loop_1_x_turned,
                )
                | sim_kernel::pivot_is_refused(
                    pivot_crank_angle_2,
                    self.mass_crank_angle_0_crank_angle_0 + w_20 + w_21 + w_22,
                ) | sim_kernel::pivot_is_refused(pivot_lambda_loop_2_x_turned, w_23)
                | sim_kernel::pivot_is_refused(-minus_pivot_lambda_loop_3_x_turned, w_24),
        }
    }
    /// The derivatives of accelerations (7 rows) and multipliers (6 rows) with respect to coordinates and speeds (7 columns each): with the equations of motion as `K z = r`, the solutions of `K dz = dr - dK z`. Where `refused` is set a pivot was too small and nothing else holds.
    ///
    /// Operations: 675 additions, 1080 multiplications, 7 divisions, 7 sine-cosine pairs.
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
        let w = sin_crank_angle_0 * cos_coupler_angle_1
            - sin_coupler_angle_1 * cos_crank_angle_0;
        let w_2 = self.k * w;
        let minus_rhs_crank_angle_0 = cos_crank_angle_0 * self.k_4
            + coupler_angle_1_dot_squared * w_2;
        let w_3 = cos_crank_angle_0 * sin_crank_angle_1
            - sin_crank_angle_0 * cos_crank_angle_1;
        let crank_angle_1_dot_squared = crank_angle_1_dot * crank_angle_1_dot;
        let w_4 = self.l
            * (w_3 * crank_angle_1_dot_squared + w * coupler_angle_1_dot_squared);
        let rhs_lambda_loop_1_y_turned = minus_rhs_crank_angle_0
            * self.l_lambda_loop_1_y_turned_crank_angle_0 - w_4;
        let w_5 = sin_coupler_angle_2 * cos_crank_angle_1
            - sin_crank_angle_1 * cos_coupler_angle_2;
        let w_6 = self.k * w_5;
        let minus_rhs_coupler_angle_2 = cos_coupler_angle_2 * self.k_5
            + crank_angle_1_dot_squared * w_6;
        let w_7 = cos_coupler_angle_2 * sin_crank_angle_2
            - sin_coupler_angle_2 * cos_crank_angle_2;
        let crank_angle_2_dot_squared = crank_angle_2_dot * crank_angle_2_dot;
        let w_8 = self.l
            * (w_5 * crank_angle_1_dot_squared + w_7 * crank_angle_2_dot_squared);
        let rhs_lambda_loop_2_y_turned = minus_rhs_coupler_angle_2
            * self.l_lambda_loop_2_y_turned_coupler_angle_2 - w_8;
        let crank_angle_0_dot_squared = crank_angle_0_dot * crank_angle_0_dot;
        let w_9 = sin_crank_angle_0 * sin_coupler_angle_1
            + cos_crank_angle_0 * cos_coupler_angle_1;
        let mass_coupler_angle_1_crank_angle_0 = self.k * w_9;
        let l_coupler_angle_1_crank_angle_0 = mass_coupler_angle_1_crank_angle_0
            * self.inverse_crank_angle_0;
        let k_coupler_angle_1_lambda_loop_1_y_turned = w_9 * self.k_7;
        let minus_l_coupler_angle_1_lambda_loop_1_y_turned = self
            .minus_inverse_lambda_loop_1_y_turned
            * k_coupler_angle_1_lambda_loop_1_y_turned;
        let rhs_coupler_angle_1 = crank_angle_0_dot_squared * w_2
            - cos_coupler_angle_1 * self.k_5
            + minus_rhs_crank_angle_0 * l_coupler_angle_1_crank_angle_0
            + minus_l_coupler_angle_1_lambda_loop_1_y_turned
                * rhs_lambda_loop_1_y_turned;
        let w_12 = k_coupler_angle_1_lambda_loop_1_y_turned
            * minus_l_coupler_angle_1_lambda_loop_1_y_turned;
        let coupler_angle_2_dot_squared = coupler_angle_2_dot * coupler_angle_2_dot;
        let w_10 = sin_crank_angle_0 * sin_crank_angle_1
            + cos_crank_angle_0 * cos_crank_angle_1;
        let minus_k_crank_angle_1_lambda_loop_1_y_turned = self.l * w_10;
        let l_crank_angle_1_lambda_loop_1_y_turned = minus_k_crank_angle_1_lambda_loop_1_y_turned
            * self.minus_inverse_lambda_loop_1_y_turned;
        let w_11 = sin_crank_angle_1 * sin_coupler_angle_2
            + cos_crank_angle_1 * cos_coupler_angle_2;
        let mass_coupler_angle_2_crank_angle_1 = self.k * w_11;
        let l_crank_angle_1_coupler_angle_2 = mass_coupler_angle_2_crank_angle_1
            * self.inverse_coupler_angle_2;
        let k_crank_angle_1_lambda_loop_2_y_turned = w_11 * self.k_8;
        let minus_l_crank_angle_1_lambda_loop_2_y_turned = self
            .minus_inverse_lambda_loop_2_y_turned
            * k_crank_angle_1_lambda_loop_2_y_turned;
        let minus_k_crank_angle_1_coupler_angle_1 = minus_k_crank_angle_1_lambda_loop_1_y_turned
            * minus_l_coupler_angle_1_lambda_loop_1_y_turned;
        let pivot_coupler_angle_1 = self.mass_crank_angle_3_crank_angle_3
            - mass_coupler_angle_1_crank_angle_0 * l_coupler_angle_1_crank_angle_0
            + w_12;
        let inverse_coupler_angle_1 = S::from_f64(1.0) / pivot_coupler_angle_1;
        let minus_l_crank_angle_1_coupler_angle_1 = minus_k_crank_angle_1_coupler_angle_1
            * inverse_coupler_angle_1;
        let rhs_crank_angle_1 = coupler_angle_2_dot_squared * w_6
            - cos_crank_angle_1 * self.k_4
            - l_crank_angle_1_lambda_loop_1_y_turned * rhs_lambda_loop_1_y_turned
            + minus_rhs_coupler_angle_2 * l_crank_angle_1_coupler_angle_2
            + minus_l_crank_angle_1_lambda_loop_2_y_turned * rhs_lambda_loop_2_y_turned
            + minus_l_crank_angle_1_coupler_angle_1 * rhs_coupler_angle_1;
        let w_13 = self.k * sin_crank_angle_2;
        let w_14 = cos_crank_angle_2 * crank_angle_2_dot_squared;
        let w_15 = self.k * sin_coupler_angle_3;
        let w_16 = cos_coupler_angle_3 * cos_crank_angle_3
            + sin_coupler_angle_3 * sin_crank_angle_3;
        let k_coupler_angle_3_lambda_loop_3_y_turned = self.l * w_16;
        let minus_l_coupler_angle_3_lambda_loop_3_y_turned = k_coupler_angle_3_lambda_loop_3_y_turned
            * self.minus_inverse_lambda_loop_2_y_turned;
        let w_17 = cos_crank_angle_2 * sin_crank_angle_3
            - sin_crank_angle_2 * cos_crank_angle_3;
        let w_18 = cos_coupler_angle_3 * sin_crank_angle_3
            - sin_coupler_angle_3 * cos_crank_angle_3;
        let coupler_angle_3_dot_squared = coupler_angle_3_dot * coupler_angle_3_dot;
        let w_19 = self.l
            * (w_17 * crank_angle_2_dot_squared + w_18 * coupler_angle_3_dot_squared);
        let minus_rhs_lambda_loop_3_y_turned = w_19
            + cos_crank_angle_3 * self.k_5
                * self.l_lambda_loop_2_y_turned_coupler_angle_2;
        let rhs_coupler_angle_3 = cos_coupler_angle_3
            * (crank_angle_2_dot_squared * w_13 - self.k_5) - w_14 * w_15
            - minus_l_coupler_angle_3_lambda_loop_3_y_turned
                * minus_rhs_lambda_loop_3_y_turned;
        let w_20 = cos_coupler_angle_2 * cos_crank_angle_2
            + sin_coupler_angle_2 * sin_crank_angle_2;
        let minus_k_crank_angle_2_lambda_loop_2_y_turned = self.l * w_20;
        let l_crank_angle_2_lambda_loop_2_y_turned = minus_k_crank_angle_2_lambda_loop_2_y_turned
            * self.minus_inverse_lambda_loop_2_y_turned;
        let w_21 = sin_crank_angle_2 * sin_crank_angle_3
            + cos_crank_angle_2 * cos_crank_angle_3;
        let k_crank_angle_2_lambda_loop_3_y_turned = self.l * w_21;
        let minus_l_crank_angle_2_lambda_loop_3_y_turned = k_crank_angle_2_lambda_loop_3_y_turned
            * self.minus_inverse_lambda_loop_2_y_turned;
        let minus_k_crank_angle_2_crank_angle_1 = k_crank_angle_1_lambda_loop_2_y_turned
            * l_crank_angle_2_lambda_loop_2_y_turned;
        let w_23 = k_crank_angle_1_lambda_loop_2_y_turned
            * minus_l_crank_angle_1_lambda_loop_2_y_turned;
        let w_22 = minus_k_crank_angle_1_lambda_loop_1_y_turned
            * l_crank_angle_1_lambda_loop_1_y_turned;
        let pivot_crank_angle_1 = self.mass_crank_angle_0_crank_angle_0 + w_22
            - mass_coupler_angle_2_crank_angle_1 * l_crank_angle_1_coupler_angle_2 + w_23
            - minus_k_crank_angle_1_coupler_angle_1
                * minus_l_crank_angle_1_coupler_angle_1;
        let inverse_crank_angle_1 = S::from_f64(1.0) / pivot_crank_angle_1;
        let minus_l_crank_angle_2_crank_angle_1 = minus_k_crank_angle_2_crank_angle_1
            * inverse_crank_angle_1;
        let pivot_coupler_angle_3 = self.mass_crank_angle_3_crank_angle_3
            + k_coupler_angle_3_lambda_loop_3_y_turned
                * minus_l_coupler_angle_3_lambda_loop_3_y_turned;
        let inverse_coupler_angle_3 = S::from_f64(1.0) / pivot_coupler_angle_3;
        let mass_coupler_angle_3_crank_angle_2 = self.k
            * (sin_crank_angle_2 * sin_coupler_angle_3
                + cos_crank_angle_2 * cos_coupler_angle_3);
        let k_crank_angle_2_coupler_angle_3 = mass_coupler_angle_3_crank_angle_2
            + k_crank_angle_2_lambda_loop_3_y_turned
                * minus_l_coupler_angle_3_lambda_loop_3_y_turned;
        let l_crank_angle_2_coupler_angle_3 = inverse_coupler_angle_3
            * k_crank_angle_2_coupler_angle_3;
        let w_24 = self.l * w_3;
        let k_lambda_loop_1_x_turned_coupler_angle_1 = self.l * w;
        let l_lambda_loop_1_x_turned_coupler_angle_1 = k_lambda_loop_1_x_turned_coupler_angle_1
            * inverse_coupler_angle_1;
        let k_lambda_loop_1_x_turned_crank_angle_1 = w_24
            + minus_k_crank_angle_1_coupler_angle_1
                * l_lambda_loop_1_x_turned_coupler_angle_1;
        let l_lambda_loop_1_x_turned_crank_angle_1 = inverse_crank_angle_1
            * k_lambda_loop_1_x_turned_crank_angle_1;
        let k_crank_angle_2_lambda_loop_1_x_turned = minus_k_crank_angle_2_crank_angle_1
            * l_lambda_loop_1_x_turned_crank_angle_1;
        let minus_pivot_lambda_loop_1_x_turned = k_lambda_loop_1_x_turned_coupler_angle_1
            * l_lambda_loop_1_x_turned_coupler_angle_1
            + k_lambda_loop_1_x_turned_crank_angle_1
                * l_lambda_loop_1_x_turned_crank_angle_1;
        let minus_inverse_lambda_loop_1_x_turned = S::from_f64(1.0)
            / minus_pivot_lambda_loop_1_x_turned;
        let minus_l_crank_angle_2_lambda_loop_1_x_turned = k_crank_angle_2_lambda_loop_1_x_turned
            * minus_inverse_lambda_loop_1_x_turned;
        let w_25 = w_10 * crank_angle_1_dot_squared;
        let w_26 = w_9 * coupler_angle_1_dot_squared;
        let minus_rhs_lambda_loop_1_x_turned = self.l
            * (w_25 - crank_angle_0_dot_squared - w_26)
            + l_lambda_loop_1_x_turned_coupler_angle_1 * rhs_coupler_angle_1
            + l_lambda_loop_1_x_turned_crank_angle_1 * rhs_crank_angle_1;
        let rhs_crank_angle_2 = cos_crank_angle_2
            * (coupler_angle_3_dot_squared * w_15 - self.k_4)
            - cos_coupler_angle_3 * coupler_angle_3_dot_squared * w_13
            - l_crank_angle_2_lambda_loop_2_y_turned * rhs_lambda_loop_2_y_turned
            - minus_l_crank_angle_2_lambda_loop_3_y_turned
                * minus_rhs_lambda_loop_3_y_turned
            + minus_l_crank_angle_2_crank_angle_1 * rhs_crank_angle_1
            - l_crank_angle_2_coupler_angle_3 * rhs_coupler_angle_3
            - minus_l_crank_angle_2_lambda_loop_1_x_turned
                * minus_rhs_lambda_loop_1_x_turned;
        let k_lambda_loop_2_x_turned_crank_angle_1 = self.l * w_5;
        let l_lambda_loop_2_x_turned_crank_angle_1 = k_lambda_loop_2_x_turned_crank_angle_1
            * inverse_crank_angle_1;
        let minus_k_lambda_loop_2_x_turned_lambda_loop_1_x_turned = k_lambda_loop_1_x_turned_crank_angle_1
            * l_lambda_loop_2_x_turned_crank_angle_1;
        let l_lambda_loop_2_x_turned_lambda_loop_1_x_turned = minus_k_lambda_loop_2_x_turned_lambda_loop_1_x_turned
            * minus_inverse_lambda_loop_1_x_turned;
        let w_27 = w_20 * crank_angle_2_dot_squared;
        let w_28 = w_11 * crank_angle_1_dot_squared;
        let w_29 = minus_k_crank_angle_2_lambda_loop_2_y_turned
            * l_crank_angle_2_lambda_loop_2_y_turned;
        let w_30 = k_crank_angle_2_lambda_loop_3_y_turned
            * minus_l_crank_angle_2_lambda_loop_3_y_turned;
        let w_31 = k_crank_angle_2_lambda_loop_1_x_turned
            * minus_l_crank_angle_2_lambda_loop_1_x_turned;
        let pivot_crank_angle_2 = self.mass_crank_angle_0_crank_angle_0 + w_29 + w_30
            - minus_k_crank_angle_2_crank_angle_1 * minus_l_crank_angle_2_crank_angle_1
            - k_crank_angle_2_coupler_angle_3 * l_crank_angle_2_coupler_angle_3 + w_31;
        let inverse_crank_angle_2 = S::from_f64(1.0) / pivot_crank_angle_2;
        let w_32 = self.l * w_7;
        let k_lambda_loop_2_x_turned_crank_angle_2 = w_32
            + minus_k_crank_angle_2_crank_angle_1
                * l_lambda_loop_2_x_turned_crank_angle_1
            - k_crank_angle_2_lambda_loop_1_x_turned
                * l_lambda_loop_2_x_turned_lambda_loop_1_x_turned;
        let l_lambda_loop_2_x_turned_crank_angle_2 = inverse_crank_angle_2
            * k_lambda_loop_2_x_turned_crank_angle_2;
        let rhs_lambda_loop_2_x_turned = l_lambda_loop_2_x_turned_lambda_loop_1_x_turned
            * minus_rhs_lambda_loop_1_x_turned
            - self.l * (w_27 - coupler_angle_2_dot_squared - w_28)
            - l_lambda_loop_2_x_turned_crank_angle_1 * rhs_crank_angle_1
            - l_lambda_loop_2_x_turned_crank_angle_2 * rhs_crank_angle_2;
        let w_33 = self.l * w_17;
        let k_lambda_loop_3_x_turned_coupler_angle_3 = self.l * w_18;
        let l_lambda_loop_3_x_turned_coupler_angle_3 = k_lambda_loop_3_x_turned_coupler_angle_3
            * inverse_coupler_angle_3;
        let k_lambda_loop_3_x_turned_crank_angle_2 = w_33
            - k_crank_angle_2_coupler_angle_3 * l_lambda_loop_3_x_turned_coupler_angle_3;
        let l_lambda_loop_3_x_turned_crank_angle_2 = inverse_crank_angle_2
            * k_lambda_loop_3_x_turned_crank_angle_2;
        let w_41 = k_lambda_loop_3_x_turned_coupler_angle_3
            * l_lambda_loop_3_x_turned_coupler_angle_3
            + k_lambda_loop_3_x_turned_crank_angle_2
                * l_lambda_loop_3_x_turned_crank_angle_2;
        let minus_k_lambda_loop_3_x_turned_lambda_loop_2_x_turned = k_lambda_loop_2_x_turned_crank_angle_2
            * l_lambda_loop_3_x_turned_crank_angle_2;
        let w_34 = k_lambda_loop_2_x_turned_crank_angle_1
            * l_lambda_loop_2_x_turned_crank_angle_1
            + k_lambda_loop_2_x_turned_crank_angle_2
                * l_lambda_loop_2_x_turned_crank_angle_2;
        let pivot_lambda_loop_2_x_turned = minus_k_lambda_loop_2_x_turned_lambda_loop_1_x_turned
            * l_lambda_loop_2_x_turned_lambda_loop_1_x_turned - w_34;
        let inverse_lambda_loop_2_x_turned = S::from_f64(1.0)
            / pivot_lambda_loop_2_x_turned;
        let minus_l_lambda_loop_3_x_turned_lambda_loop_2_x_turned = minus_k_lambda_loop_3_x_turned_lambda_loop_2_x_turned
            * inverse_lambda_loop_2_x_turned;
        let minus_pivot_lambda_loop_3_x_turned = w_41
            + minus_k_lambda_loop_3_x_turned_lambda_loop_2_x_turned
                * minus_l_lambda_loop_3_x_turned_lambda_loop_2_x_turned;
        let w_35 = w_21 * crank_angle_2_dot_squared;
        let w_36 = w_16 * coupler_angle_3_dot_squared;
        let w_37 = crank_angle_0_dot_squared * self.k_2;
        let w_38 = self.l * coupler_angle_1_dot_squared;
        let w_39 = cos_crank_angle_0 * w_37 + cos_coupler_angle_1 * w_38;
        let w_40 = sin_crank_angle_0 * w_37 + sin_coupler_angle_1 * w_38;
        let minus_inverse_lambda_loop_3_x_turned = S::from_f64(1.0)
            / minus_pivot_lambda_loop_3_x_turned;
        let w_42 = minus_inverse_lambda_loop_3_x_turned
            * (minus_l_lambda_loop_3_x_turned_lambda_loop_2_x_turned
                * rhs_lambda_loop_2_x_turned
                - self.l * (crank_angle_3_dot * crank_angle_3_dot - w_35 - w_36)
                - l_lambda_loop_3_x_turned_coupler_angle_3 * rhs_coupler_angle_3
                - l_lambda_loop_3_x_turned_crank_angle_2 * rhs_crank_angle_2);
        let w_43 = inverse_lambda_loop_2_x_turned * rhs_lambda_loop_2_x_turned
            - minus_l_lambda_loop_3_x_turned_lambda_loop_2_x_turned * w_42;
        let crank_angle_2_ddot = inverse_crank_angle_2 * rhs_crank_angle_2
            - l_lambda_loop_2_x_turned_crank_angle_2 * w_43
            + l_lambda_loop_3_x_turned_crank_angle_2 * w_42;
        let w_44 = minus_inverse_lambda_loop_1_x_turned
            * minus_rhs_lambda_loop_1_x_turned
            + minus_l_crank_angle_2_lambda_loop_1_x_turned * crank_angle_2_ddot
            - l_lambda_loop_2_x_turned_lambda_loop_1_x_turned * w_43;
        let crank_angle_1_ddot = inverse_crank_angle_1 * rhs_crank_angle_1
            + minus_l_crank_angle_2_crank_angle_1 * crank_angle_2_ddot
            - l_lambda_loop_1_x_turned_crank_angle_1 * w_44
            - l_lambda_loop_2_x_turned_crank_angle_1 * w_43;
        let coupler_angle_1_ddot = inverse_coupler_angle_1 * rhs_coupler_angle_1
            + minus_l_crank_angle_1_coupler_angle_1 * crank_angle_1_ddot
            - l_lambda_loop_1_x_turned_coupler_angle_1 * w_44;
        let w_49 = minus_l_coupler_angle_1_lambda_loop_1_y_turned * coupler_angle_1_ddot
            - self.minus_inverse_lambda_loop_1_y_turned * rhs_lambda_loop_1_y_turned
            - l_crank_angle_1_lambda_loop_1_y_turned * crank_angle_1_ddot;
        let w_77 = minus_l_crank_angle_1_lambda_loop_2_y_turned * crank_angle_1_ddot
            - self.minus_inverse_lambda_loop_2_y_turned * rhs_lambda_loop_2_y_turned
            - l_crank_angle_2_lambda_loop_2_y_turned * crank_angle_2_ddot;
        let coupler_angle_3_ddot = inverse_coupler_angle_3 * rhs_coupler_angle_3
            - l_crank_angle_2_coupler_angle_3 * crank_angle_2_ddot
            + l_lambda_loop_3_x_turned_coupler_angle_3 * w_42;
        let w_112 = self.minus_inverse_lambda_loop_2_y_turned
            * minus_rhs_lambda_loop_3_y_turned
            + minus_l_crank_angle_2_lambda_loop_3_y_turned * crank_angle_2_ddot
            + minus_l_coupler_angle_3_lambda_loop_3_y_turned * coupler_angle_3_ddot;
        let w_45 = w * self.k_9;
        let w_46 = S::from_f64(0.5) * w_45;
        let w_50 = (minus_rhs_crank_angle_0 * self.inverse_crank_angle_0
            + l_coupler_angle_1_crank_angle_0 * coupler_angle_1_ddot
            + self.l_lambda_loop_1_y_turned_crank_angle_0 * w_49) * w_46;
        let w_47 = coupler_angle_1_ddot * w_46;
        let w_48 = crank_angle_0_dot_squared * self.k_9
            - self.k_3 * (cos_crank_angle_0 * w_39 + sin_crank_angle_0 * w_40)
            + sin_crank_angle_0 * self.k_4 + w_47;
        let w_152 = mass_coupler_angle_1_crank_angle_0 * coupler_angle_1_dot_squared
            - w_47;
        let w_51 = self.l * w_9;
        let w_52 = w_51 * w_44;
        let w_62 = w_51 * coupler_angle_1_ddot;
        let w_55 = k_lambda_loop_1_x_turned_coupler_angle_1 * coupler_angle_1_ddot;
        let w_53 = k_lambda_loop_1_x_turned_coupler_angle_1 * w_49;
        let w_54 = w_24 * crank_angle_1_ddot;
        let w_56 = self.l * (w_25 - w_26) + w_54 + w_55
            - self.l_lambda_loop_1_y_turned_crank_angle_0 * w_48;
        let w_57 = mass_coupler_angle_1_crank_angle_0 * crank_angle_0_dot_squared - w_50
            - w_52 + w_53 - l_coupler_angle_1_crank_angle_0 * w_48
            + minus_l_coupler_angle_1_lambda_loop_1_y_turned * w_56;
        let w_153 = w_9 * w_38 - w_55
            - self.l_lambda_loop_1_y_turned_crank_angle_0 * w_152;
        let w_154 = w_50 + w_52 - w_53
            - self.k_6 * (cos_coupler_angle_1 * w_39 + sin_coupler_angle_1 * w_40)
            + coupler_angle_1_dot_squared * self.k_10 + sin_coupler_angle_1 * self.k_5
            - l_coupler_angle_1_crank_angle_0 * w_152
            + minus_l_coupler_angle_1_lambda_loop_1_y_turned * w_153;
        let w_59 = w_24 * w_49;
        let w_58 = minus_k_crank_angle_1_lambda_loop_1_y_turned * w_44;
        let w_61 = minus_k_crank_angle_1_lambda_loop_1_y_turned * crank_angle_1_ddot;
        let w_60 = w_58 + w_59 - l_crank_angle_1_lambda_loop_1_y_turned * w_56
            + minus_l_crank_angle_1_coupler_angle_1 * w_57;
        let w_63 = w_61 - w_4 - w_62 - l_lambda_loop_1_x_turned_coupler_angle_1 * w_57
            - l_lambda_loop_1_x_turned_crank_angle_1 * w_60;
        let w_64 = minus_l_crank_angle_2_crank_angle_1 * w_60
            + minus_l_crank_angle_2_lambda_loop_1_x_turned * w_63;
        let w_65 = l_lambda_loop_2_x_turned_crank_angle_1 * w_60
            + l_lambda_loop_2_x_turned_lambda_loop_1_x_turned * w_63
            + l_lambda_loop_2_x_turned_crank_angle_2 * w_64;
        let w_66 = minus_inverse_lambda_loop_3_x_turned
            * (l_lambda_loop_3_x_turned_crank_angle_2 * w_64
                + minus_l_lambda_loop_3_x_turned_lambda_loop_2_x_turned * w_65);
        let w_67 = minus_l_lambda_loop_3_x_turned_lambda_loop_2_x_turned * w_66
            - inverse_lambda_loop_2_x_turned * w_65;
        let w_68 = inverse_crank_angle_2 * w_64
            - l_lambda_loop_2_x_turned_crank_angle_2 * w_67
            - l_lambda_loop_3_x_turned_crank_angle_2 * w_66;
        let w_69 = minus_l_crank_angle_2_lambda_loop_1_x_turned * w_68
            - minus_inverse_lambda_loop_1_x_turned * w_63
            - l_lambda_loop_2_x_turned_lambda_loop_1_x_turned * w_67;
        let w_70 = inverse_crank_angle_1 * w_60
            + minus_l_crank_angle_2_crank_angle_1 * w_68
            - l_lambda_loop_1_x_turned_crank_angle_1 * w_69
            - l_lambda_loop_2_x_turned_crank_angle_1 * w_67;
        let w_71 = inverse_coupler_angle_1 * w_57
            + minus_l_crank_angle_1_coupler_angle_1 * w_70
            - l_lambda_loop_1_x_turned_coupler_angle_1 * w_69;
        let w_72 = minus_l_coupler_angle_1_lambda_loop_1_y_turned * w_71
            - self.minus_inverse_lambda_loop_1_y_turned * w_56
            - l_crank_angle_1_lambda_loop_1_y_turned * w_70;
        let w_73 = self.k_2 * crank_angle_1_dot_squared;
        let w_74 = self.l * coupler_angle_2_dot_squared;
        let w_75 = cos_crank_angle_1 * w_73 + cos_coupler_angle_2 * w_74;
        let w_76 = sin_crank_angle_1 * w_73 + sin_coupler_angle_2 * w_74;
        let w_78 = w_5 * self.k_9;
        let w_79 = S::from_f64(0.5) * w_78;
        let w_80 = (minus_rhs_coupler_angle_2 * self.inverse_coupler_angle_2
            + l_crank_angle_1_coupler_angle_2 * crank_angle_1_ddot
            + self.l_lambda_loop_2_y_turned_coupler_angle_2 * w_77) * w_79;
        let w_87 = crank_angle_1_ddot * w_79;
        let w_81 = k_lambda_loop_2_x_turned_crank_angle_1 * w_77;
        let w_89 = k_lambda_loop_2_x_turned_crank_angle_1 * crank_angle_1_ddot;
        let w_82 = self.l * w_11;
        let w_95 = w_82 * crank_angle_1_ddot;
        let w_83 = w_82 * w_43;
        let w_84 = crank_angle_1_dot_squared * self.k_9 - w_58 - w_59
            - self.k_3 * (cos_crank_angle_1 * w_75 + sin_crank_angle_1 * w_76)
            + sin_crank_angle_1 * self.k_4 + w_80 - w_81 + w_83;
        let w_166 = w_87
            - self.k_6 * (cos_coupler_angle_2 * w_75 + sin_coupler_angle_2 * w_76)
            + coupler_angle_2_dot_squared * self.k_10 + sin_coupler_angle_2 * self.k_5;
        let w_88 = mass_coupler_angle_2_crank_angle_1 * crank_angle_1_dot_squared - w_87;
        let w_85 = self.l * crank_angle_1_dot_squared;
        let w_86 = w_54 + w_10 * w_85;
        let w_90 = w_11 * w_85 - w_89
            - self.l_lambda_loop_2_y_turned_coupler_angle_2 * w_88;
        let w_91 = minus_l_coupler_angle_1_lambda_loop_1_y_turned * w_86;
        let w_92 = w_84 + l_crank_angle_1_lambda_loop_1_y_turned * w_86
            - l_crank_angle_1_coupler_angle_2 * w_88
            + minus_l_crank_angle_1_lambda_loop_2_y_turned * w_90
            - minus_l_crank_angle_1_coupler_angle_1 * w_91;
        let w_93 = w_3 * w_85 - w_61 + l_lambda_loop_1_x_turned_coupler_angle_1 * w_91
            - l_lambda_loop_1_x_turned_crank_angle_1 * w_92;
        let w_94 = minus_l_crank_angle_2_crank_angle_1 * w_92
            - l_crank_angle_2_lambda_loop_2_y_turned * w_90
            + minus_l_crank_angle_2_lambda_loop_1_x_turned * w_93;
        let w_96 = w_5 * w_85 + w_95 - l_lambda_loop_2_x_turned_crank_angle_1 * w_92
            - l_lambda_loop_2_x_turned_lambda_loop_1_x_turned * w_93
            - l_lambda_loop_2_x_turned_crank_angle_2 * w_94;
        let w_97 = minus_inverse_lambda_loop_3_x_turned
            * (minus_l_lambda_loop_3_x_turned_lambda_loop_2_x_turned * w_96
                - l_lambda_loop_3_x_turned_crank_angle_2 * w_94);
        let w_98 = inverse_lambda_loop_2_x_turned * w_96
            - minus_l_lambda_loop_3_x_turned_lambda_loop_2_x_turned * w_97;
        let w_99 = inverse_crank_angle_2 * w_94
            - l_lambda_loop_2_x_turned_crank_angle_2 * w_98
            + l_lambda_loop_3_x_turned_crank_angle_2 * w_97;
        let w_100 = minus_l_crank_angle_2_lambda_loop_1_x_turned * w_99
            - minus_inverse_lambda_loop_1_x_turned * w_93
            - l_lambda_loop_2_x_turned_lambda_loop_1_x_turned * w_98;
        let w_101 = inverse_crank_angle_1 * w_92
            + minus_l_crank_angle_2_crank_angle_1 * w_99
            - l_lambda_loop_1_x_turned_crank_angle_1 * w_100
            - l_lambda_loop_2_x_turned_crank_angle_1 * w_98;
        let w_102 = minus_l_crank_angle_1_coupler_angle_1 * w_101
            - inverse_coupler_angle_1 * w_91
            - l_lambda_loop_1_x_turned_coupler_angle_1 * w_100;
        let w_103 = self.minus_inverse_lambda_loop_1_y_turned * w_86
            - l_crank_angle_1_lambda_loop_1_y_turned * w_101
            + minus_l_coupler_angle_1_lambda_loop_1_y_turned * w_102;
        let w_205 = minus_l_crank_angle_1_lambda_loop_2_y_turned * w_101
            - self.minus_inverse_lambda_loop_2_y_turned * w_90
            - l_crank_angle_2_lambda_loop_2_y_turned * w_99;
        let w_104 = self.l * coupler_angle_3_dot_squared;
        let w_105 = self.k_2 * w_14 + cos_coupler_angle_3 * w_104;
        let w_106 = sin_crank_angle_2 * self.k_2 * crank_angle_2_dot_squared
            + sin_coupler_angle_3 * w_104;
        let w_107 = self.k_9
            * (sin_coupler_angle_3 * cos_crank_angle_2
                - sin_crank_angle_2 * cos_coupler_angle_3);
        let w_108 = S::from_f64(0.5) * w_107;
        let w_109 = coupler_angle_3_ddot * w_108;
        let w_122 = crank_angle_2_ddot * w_108;
        let w_110 = minus_k_crank_angle_2_lambda_loop_2_y_turned * w_43;
        let w_126 = minus_k_crank_angle_2_lambda_loop_2_y_turned * crank_angle_2_ddot;
        let w_111 = k_crank_angle_2_lambda_loop_3_y_turned * w_42;
        let w_128 = k_crank_angle_2_lambda_loop_3_y_turned * crank_angle_2_ddot;
        let w_113 = w_33 * w_112;
        let w_119 = w_33 * crank_angle_2_ddot;
        let w_117 = w_32 * crank_angle_2_ddot;
        let w_114 = w_32 * w_77;
        let w_167 = w_89 + w_117 + self.l * (w_27 - w_28)
            - self.l_lambda_loop_2_y_turned_coupler_angle_2 * w_166;
        let w_168 = w_81 - w_80 - w_83
            + mass_coupler_angle_2_crank_angle_1 * coupler_angle_2_dot_squared
            - l_crank_angle_1_coupler_angle_2 * w_166
            + minus_l_crank_angle_1_lambda_loop_2_y_turned * w_167;
        let w_115 = crank_angle_2_dot_squared * self.k_9
            - self.k_3 * (cos_crank_angle_2 * w_105 + sin_crank_angle_2 * w_106)
            + sin_crank_angle_2 * self.k_4 - w_109 - w_110 - w_111 - w_113 - w_114;
        let w_116 = self.l * crank_angle_2_dot_squared;
        let w_118 = w_20 * w_116 + w_117;
        let w_120 = w_21 * w_116 - w_119;
        let w_123 = mass_coupler_angle_3_crank_angle_2 * crank_angle_2_dot_squared
            - w_122 + minus_l_coupler_angle_3_lambda_loop_3_y_turned * w_120;
        let w_121 = minus_l_crank_angle_1_lambda_loop_2_y_turned * w_118;
        let w_124 = l_lambda_loop_1_x_turned_crank_angle_1 * w_121;
        let w_125 = w_115 + l_crank_angle_2_lambda_loop_2_y_turned * w_118
            + minus_l_crank_angle_2_lambda_loop_3_y_turned * w_120
            - minus_l_crank_angle_2_crank_angle_1 * w_121
            - l_crank_angle_2_coupler_angle_3 * w_123
            + minus_l_crank_angle_2_lambda_loop_1_x_turned * w_124;
        let w_127 = w_7 * w_116 - w_126 + l_lambda_loop_2_x_turned_crank_angle_1 * w_121
            - l_lambda_loop_2_x_turned_lambda_loop_1_x_turned * w_124
            - l_lambda_loop_2_x_turned_crank_angle_2 * w_125;
        let w_129 = minus_inverse_lambda_loop_3_x_turned
            * (w_17 * w_116 + w_128 - l_lambda_loop_3_x_turned_coupler_angle_3 * w_123
                - l_lambda_loop_3_x_turned_crank_angle_2 * w_125
                + minus_l_lambda_loop_3_x_turned_lambda_loop_2_x_turned * w_127);
        let w_130 = inverse_lambda_loop_2_x_turned * w_127
            - minus_l_lambda_loop_3_x_turned_lambda_loop_2_x_turned * w_129;
        let w_131 = inverse_crank_angle_2 * w_125
            - l_lambda_loop_2_x_turned_crank_angle_2 * w_130
            + l_lambda_loop_3_x_turned_crank_angle_2 * w_129;
        let w_132 = minus_l_crank_angle_2_lambda_loop_1_x_turned * w_131
            - minus_inverse_lambda_loop_1_x_turned * w_124
            - l_lambda_loop_2_x_turned_lambda_loop_1_x_turned * w_130;
        let w_133 = minus_l_crank_angle_2_crank_angle_1 * w_131
            - inverse_crank_angle_1 * w_121
            - l_lambda_loop_1_x_turned_crank_angle_1 * w_132
            - l_lambda_loop_2_x_turned_crank_angle_1 * w_130;
        let w_206 = self.minus_inverse_lambda_loop_2_y_turned * w_118
            + minus_l_crank_angle_1_lambda_loop_2_y_turned * w_133
            - l_crank_angle_2_lambda_loop_2_y_turned * w_131;
        let w_194 = inverse_coupler_angle_3 * w_123
            - l_crank_angle_2_coupler_angle_3 * w_131
            + l_lambda_loop_3_x_turned_coupler_angle_3 * w_129;
        let w_195 = minus_l_crank_angle_2_lambda_loop_3_y_turned * w_131
            - self.minus_inverse_lambda_loop_2_y_turned * w_120
            + minus_l_coupler_angle_3_lambda_loop_3_y_turned * w_194;
        let w_134 = minus_l_crank_angle_1_coupler_angle_1 * w_133
            - l_lambda_loop_1_x_turned_coupler_angle_1 * w_132;
        let w_135 = minus_l_coupler_angle_1_lambda_loop_1_y_turned * w_134
            - l_crank_angle_1_lambda_loop_1_y_turned * w_133;
        let w_136 = k_lambda_loop_3_x_turned_coupler_angle_3 * coupler_angle_3_ddot;
        let w_140 = k_lambda_loop_3_x_turned_coupler_angle_3 * w_112;
        let w_143 = k_coupler_angle_3_lambda_loop_3_y_turned * coupler_angle_3_ddot;
        let w_139 = k_coupler_angle_3_lambda_loop_3_y_turned * w_42;
        let w_137 = sin_crank_angle_3 * self.k_5;
        let w_138 = w_119 - self.l * (w_35 + w_36) + w_136
            + self.l_lambda_loop_2_y_turned_coupler_angle_2 * w_137;
        let w_179 = w_16 * w_104 - w_136;
        let w_180 = w_122 - w_139 - w_140
            - self.k_6 * (cos_coupler_angle_3 * w_105 + sin_coupler_angle_3 * w_106)
            + coupler_angle_3_dot_squared * self.k_10 + sin_coupler_angle_3 * self.k_5
            + minus_l_coupler_angle_3_lambda_loop_3_y_turned * w_179;
        let w_141 = w_139 + w_140
            + minus_l_coupler_angle_3_lambda_loop_3_y_turned * w_138;
        let w_142 = w_111 + w_113 + minus_l_crank_angle_2_lambda_loop_3_y_turned * w_138
            - l_crank_angle_2_coupler_angle_3 * w_141;
        let w_181 = w_109
            + mass_coupler_angle_3_crank_angle_2 * coupler_angle_3_dot_squared
            + minus_l_crank_angle_2_lambda_loop_3_y_turned * w_179
            - l_crank_angle_2_coupler_angle_3 * w_180;
        let w_144 = l_lambda_loop_2_x_turned_crank_angle_2 * w_142;
        let w_145 = minus_inverse_lambda_loop_3_x_turned
            * (w_19 + w_128 + w_143 + l_lambda_loop_3_x_turned_coupler_angle_3 * w_141
                + l_lambda_loop_3_x_turned_crank_angle_2 * w_142
                + minus_l_lambda_loop_3_x_turned_lambda_loop_2_x_turned * w_144);
        let w_146 = minus_l_lambda_loop_3_x_turned_lambda_loop_2_x_turned * w_145
            - inverse_lambda_loop_2_x_turned * w_144;
        let w_147 = inverse_crank_angle_2 * w_142
            - l_lambda_loop_2_x_turned_crank_angle_2 * w_146
            - l_lambda_loop_3_x_turned_crank_angle_2 * w_145;
        let w_196 = inverse_coupler_angle_3 * w_141
            - l_crank_angle_2_coupler_angle_3 * w_147
            - l_lambda_loop_3_x_turned_coupler_angle_3 * w_145;
        let w_197 = minus_l_crank_angle_2_lambda_loop_3_y_turned * w_147
            - self.minus_inverse_lambda_loop_2_y_turned * w_138
            + minus_l_coupler_angle_3_lambda_loop_3_y_turned * w_196;
        let w_148 = minus_l_crank_angle_2_lambda_loop_1_x_turned * w_147
            - l_lambda_loop_2_x_turned_lambda_loop_1_x_turned * w_146;
        let w_149 = minus_l_crank_angle_2_crank_angle_1 * w_147
            - l_lambda_loop_1_x_turned_crank_angle_1 * w_148
            - l_lambda_loop_2_x_turned_crank_angle_1 * w_146;
        let w_150 = minus_l_crank_angle_1_coupler_angle_1 * w_149
            - l_lambda_loop_1_x_turned_coupler_angle_1 * w_148;
        let w_151 = minus_l_coupler_angle_1_lambda_loop_1_y_turned * w_150
            - l_crank_angle_1_lambda_loop_1_y_turned * w_149;
        let w_155 = minus_l_crank_angle_1_coupler_angle_1 * w_154
            - l_crank_angle_1_lambda_loop_1_y_turned * w_153;
        let w_156 = w_62 + w * w_38 - l_lambda_loop_1_x_turned_coupler_angle_1 * w_154
            - l_lambda_loop_1_x_turned_crank_angle_1 * w_155;
        let w_157 = minus_l_crank_angle_2_crank_angle_1 * w_155
            + minus_l_crank_angle_2_lambda_loop_1_x_turned * w_156;
        let w_158 = l_lambda_loop_2_x_turned_crank_angle_1 * w_155
            + l_lambda_loop_2_x_turned_lambda_loop_1_x_turned * w_156
            + l_lambda_loop_2_x_turned_crank_angle_2 * w_157;
        let w_159 = minus_inverse_lambda_loop_3_x_turned
            * (l_lambda_loop_3_x_turned_crank_angle_2 * w_157
                + minus_l_lambda_loop_3_x_turned_lambda_loop_2_x_turned * w_158);
        let w_160 = minus_l_lambda_loop_3_x_turned_lambda_loop_2_x_turned * w_159
            - inverse_lambda_loop_2_x_turned * w_158;
        let w_161 = inverse_crank_angle_2 * w_157
            - l_lambda_loop_2_x_turned_crank_angle_2 * w_160
            - l_lambda_loop_3_x_turned_crank_angle_2 * w_159;
        let w_162 = minus_l_crank_angle_2_lambda_loop_1_x_turned * w_161
            - minus_inverse_lambda_loop_1_x_turned * w_156
            - l_lambda_loop_2_x_turned_lambda_loop_1_x_turned * w_160;
        let w_163 = inverse_crank_angle_1 * w_155
            + minus_l_crank_angle_2_crank_angle_1 * w_161
            - l_lambda_loop_1_x_turned_crank_angle_1 * w_162
            - l_lambda_loop_2_x_turned_crank_angle_1 * w_160;
        let w_164 = inverse_coupler_angle_1 * w_154
            + minus_l_crank_angle_1_coupler_angle_1 * w_163
            - l_lambda_loop_1_x_turned_coupler_angle_1 * w_162;
        let w_165 = minus_l_coupler_angle_1_lambda_loop_1_y_turned * w_164
            - self.minus_inverse_lambda_loop_1_y_turned * w_153
            - l_crank_angle_1_lambda_loop_1_y_turned * w_163;
        let w_169 = l_lambda_loop_1_x_turned_crank_angle_1 * w_168;
        let w_170 = w_110 + w_114 - l_crank_angle_2_lambda_loop_2_y_turned * w_167
            + minus_l_crank_angle_2_crank_angle_1 * w_168
            - minus_l_crank_angle_2_lambda_loop_1_x_turned * w_169;
        let w_171 = w_126 - w_8 - w_95 - l_lambda_loop_2_x_turned_crank_angle_1 * w_168
            + l_lambda_loop_2_x_turned_lambda_loop_1_x_turned * w_169
            - l_lambda_loop_2_x_turned_crank_angle_2 * w_170;
        let w_172 = minus_inverse_lambda_loop_3_x_turned
            * (minus_l_lambda_loop_3_x_turned_lambda_loop_2_x_turned * w_171
                - l_lambda_loop_3_x_turned_crank_angle_2 * w_170);
        let w_173 = inverse_lambda_loop_2_x_turned * w_171
            - minus_l_lambda_loop_3_x_turned_lambda_loop_2_x_turned * w_172;
        let w_174 = inverse_crank_angle_2 * w_170
            - l_lambda_loop_2_x_turned_crank_angle_2 * w_173
            + l_lambda_loop_3_x_turned_crank_angle_2 * w_172;
        let w_175 = minus_inverse_lambda_loop_1_x_turned * w_169
            + minus_l_crank_angle_2_lambda_loop_1_x_turned * w_174
            - l_lambda_loop_2_x_turned_lambda_loop_1_x_turned * w_173;
        let w_176 = inverse_crank_angle_1 * w_168
            + minus_l_crank_angle_2_crank_angle_1 * w_174
            - l_lambda_loop_1_x_turned_crank_angle_1 * w_175
            - l_lambda_loop_2_x_turned_crank_angle_1 * w_173;
        let w_209 = minus_l_crank_angle_1_lambda_loop_2_y_turned * w_176
            - self.minus_inverse_lambda_loop_2_y_turned * w_167
            - l_crank_angle_2_lambda_loop_2_y_turned * w_174;
        let w_177 = minus_l_crank_angle_1_coupler_angle_1 * w_176
            - l_lambda_loop_1_x_turned_coupler_angle_1 * w_175;
        let w_178 = minus_l_coupler_angle_1_lambda_loop_1_y_turned * w_177
            - l_crank_angle_1_lambda_loop_1_y_turned * w_176;
        let w_182 = l_lambda_loop_2_x_turned_crank_angle_2 * w_181;
        let w_183 = minus_inverse_lambda_loop_3_x_turned
            * (w_143 + w_18 * w_104 - l_lambda_loop_3_x_turned_coupler_angle_3 * w_180
                - l_lambda_loop_3_x_turned_crank_angle_2 * w_181
                - minus_l_lambda_loop_3_x_turned_lambda_loop_2_x_turned * w_182);
        let w_184 = inverse_lambda_loop_2_x_turned * w_182
            + minus_l_lambda_loop_3_x_turned_lambda_loop_2_x_turned * w_183;
        let w_185 = inverse_crank_angle_2 * w_181
            + l_lambda_loop_2_x_turned_crank_angle_2 * w_184
            + l_lambda_loop_3_x_turned_crank_angle_2 * w_183;
        let w_202 = inverse_coupler_angle_3 * w_180
            - l_crank_angle_2_coupler_angle_3 * w_185
            + l_lambda_loop_3_x_turned_coupler_angle_3 * w_183;
        let w_203 = minus_l_crank_angle_2_lambda_loop_3_y_turned * w_185
            - self.minus_inverse_lambda_loop_2_y_turned * w_179
            + minus_l_coupler_angle_3_lambda_loop_3_y_turned * w_202;
        let w_186 = minus_l_crank_angle_2_lambda_loop_1_x_turned * w_185
            + l_lambda_loop_2_x_turned_lambda_loop_1_x_turned * w_184;
        let w_187 = minus_l_crank_angle_2_crank_angle_1 * w_185
            - l_lambda_loop_1_x_turned_crank_angle_1 * w_186
            + l_lambda_loop_2_x_turned_crank_angle_1 * w_184;
        let w_188 = minus_l_crank_angle_1_coupler_angle_1 * w_187
            - l_lambda_loop_1_x_turned_coupler_angle_1 * w_186;
        let w_189 = minus_l_coupler_angle_1_lambda_loop_1_y_turned * w_188
            - l_crank_angle_1_lambda_loop_1_y_turned * w_187;
        let w_190 = l_crank_angle_2_coupler_angle_3 * w_68
            + l_lambda_loop_3_x_turned_coupler_angle_3 * w_66;
        let w_191 = minus_l_crank_angle_2_lambda_loop_3_y_turned * w_68
            - minus_l_coupler_angle_3_lambda_loop_3_y_turned * w_190;
        let w_192 = l_lambda_loop_3_x_turned_coupler_angle_3 * w_97
            - l_crank_angle_2_coupler_angle_3 * w_99;
        let w_193 = minus_l_crank_angle_2_lambda_loop_3_y_turned * w_99
            + minus_l_coupler_angle_3_lambda_loop_3_y_turned * w_192;
        let w_198 = l_crank_angle_2_coupler_angle_3 * w_161
            + l_lambda_loop_3_x_turned_coupler_angle_3 * w_159;
        let w_199 = minus_l_crank_angle_2_lambda_loop_3_y_turned * w_161
            - minus_l_coupler_angle_3_lambda_loop_3_y_turned * w_198;
        let w_200 = l_lambda_loop_3_x_turned_coupler_angle_3 * w_172
            - l_crank_angle_2_coupler_angle_3 * w_174;
        let w_201 = minus_l_crank_angle_2_lambda_loop_3_y_turned * w_174
            + minus_l_coupler_angle_3_lambda_loop_3_y_turned * w_200;
        let w_204 = minus_l_crank_angle_1_lambda_loop_2_y_turned * w_70
            - l_crank_angle_2_lambda_loop_2_y_turned * w_68;
        let w_207 = minus_l_crank_angle_1_lambda_loop_2_y_turned * w_149
            - l_crank_angle_2_lambda_loop_2_y_turned * w_147;
        let w_208 = minus_l_crank_angle_1_lambda_loop_2_y_turned * w_163
            - l_crank_angle_2_lambda_loop_2_y_turned * w_161;
        let w_210 = minus_l_crank_angle_1_lambda_loop_2_y_turned * w_187
            - l_crank_angle_2_lambda_loop_2_y_turned * w_185;
        let w_211 = crank_angle_0_dot * w_45;
        let w_261 = coupler_angle_1_dot * w_45;
        let w_212 = minus_l_crank_angle_1_coupler_angle_1 * w_211;
        let w_213 = crank_angle_0_dot * self.k_2
            - l_lambda_loop_1_x_turned_coupler_angle_1 * w_211
            - l_lambda_loop_1_x_turned_crank_angle_1 * w_212;
        let w_214 = minus_l_crank_angle_2_crank_angle_1 * w_212
            + minus_l_crank_angle_2_lambda_loop_1_x_turned * w_213;
        let w_215 = l_lambda_loop_2_x_turned_crank_angle_1 * w_212
            + l_lambda_loop_2_x_turned_lambda_loop_1_x_turned * w_213
            + l_lambda_loop_2_x_turned_crank_angle_2 * w_214;
        let w_216 = minus_inverse_lambda_loop_3_x_turned
            * (l_lambda_loop_3_x_turned_crank_angle_2 * w_214
                + minus_l_lambda_loop_3_x_turned_lambda_loop_2_x_turned * w_215);
        let w_217 = minus_l_lambda_loop_3_x_turned_lambda_loop_2_x_turned * w_216
            - inverse_lambda_loop_2_x_turned * w_215;
        let w_218 = inverse_crank_angle_2 * w_214
            - l_lambda_loop_2_x_turned_crank_angle_2 * w_217
            - l_lambda_loop_3_x_turned_crank_angle_2 * w_216;
        let w_219 = minus_l_crank_angle_2_lambda_loop_1_x_turned * w_218
            - minus_inverse_lambda_loop_1_x_turned * w_213
            - l_lambda_loop_2_x_turned_lambda_loop_1_x_turned * w_217;
        let w_220 = inverse_crank_angle_1 * w_212
            + minus_l_crank_angle_2_crank_angle_1 * w_218
            - l_lambda_loop_1_x_turned_crank_angle_1 * w_219
            - l_lambda_loop_2_x_turned_crank_angle_1 * w_217;
        let w_221 = inverse_coupler_angle_1 * w_211
            + minus_l_crank_angle_1_coupler_angle_1 * w_220
            - l_lambda_loop_1_x_turned_coupler_angle_1 * w_219;
        let w_222 = minus_l_coupler_angle_1_lambda_loop_1_y_turned * w_221
            - l_crank_angle_1_lambda_loop_1_y_turned * w_220;
        let w_223 = self.k_2 * crank_angle_1_dot;
        let w_224 = w_3 * w_223;
        let w_225 = crank_angle_1_dot * w_78;
        let w_226 = self.l_lambda_loop_2_y_turned_coupler_angle_2 * w_225 - w_5 * w_223;
        let w_276 = coupler_angle_2_dot * w_78;
        let w_227 = minus_l_coupler_angle_1_lambda_loop_1_y_turned * w_224;
        let w_228 = l_crank_angle_1_lambda_loop_1_y_turned * w_224
            + l_crank_angle_1_coupler_angle_2 * w_225
            + minus_l_crank_angle_1_lambda_loop_2_y_turned * w_226
            - minus_l_crank_angle_1_coupler_angle_1 * w_227;
        let w_229 = l_lambda_loop_1_x_turned_coupler_angle_1 * w_227 - w_10 * w_223
            - l_lambda_loop_1_x_turned_crank_angle_1 * w_228;
        let w_230 = minus_l_crank_angle_2_crank_angle_1 * w_228
            - l_crank_angle_2_lambda_loop_2_y_turned * w_226
            + minus_l_crank_angle_2_lambda_loop_1_x_turned * w_229;
        let w_231 = w_11 * w_223 - l_lambda_loop_2_x_turned_crank_angle_1 * w_228
            - l_lambda_loop_2_x_turned_lambda_loop_1_x_turned * w_229
            - l_lambda_loop_2_x_turned_crank_angle_2 * w_230;
        let w_232 = minus_inverse_lambda_loop_3_x_turned
            * (minus_l_lambda_loop_3_x_turned_lambda_loop_2_x_turned * w_231
                - l_lambda_loop_3_x_turned_crank_angle_2 * w_230);
        let w_233 = inverse_lambda_loop_2_x_turned * w_231
            - minus_l_lambda_loop_3_x_turned_lambda_loop_2_x_turned * w_232;
        let w_234 = inverse_crank_angle_2 * w_230
            - l_lambda_loop_2_x_turned_crank_angle_2 * w_233
            + l_lambda_loop_3_x_turned_crank_angle_2 * w_232;
        let w_235 = minus_l_crank_angle_2_lambda_loop_1_x_turned * w_234
            - minus_inverse_lambda_loop_1_x_turned * w_229
            - l_lambda_loop_2_x_turned_lambda_loop_1_x_turned * w_233;
        let w_236 = inverse_crank_angle_1 * w_228
            + minus_l_crank_angle_2_crank_angle_1 * w_234
            - l_lambda_loop_1_x_turned_crank_angle_1 * w_235
            - l_lambda_loop_2_x_turned_crank_angle_1 * w_233;
        let w_237 = minus_l_crank_angle_1_coupler_angle_1 * w_236
            - inverse_coupler_angle_1 * w_227
            - l_lambda_loop_1_x_turned_coupler_angle_1 * w_235;
        let w_238 = self.minus_inverse_lambda_loop_1_y_turned * w_224
            - l_crank_angle_1_lambda_loop_1_y_turned * w_236
            + minus_l_coupler_angle_1_lambda_loop_1_y_turned * w_237;
        let w_314 = minus_l_crank_angle_1_lambda_loop_2_y_turned * w_236
            - self.minus_inverse_lambda_loop_2_y_turned * w_226
            - l_crank_angle_2_lambda_loop_2_y_turned * w_234;
        let w_239 = self.k_2 * crank_angle_2_dot;
        let w_240 = w_7 * w_239;
        let w_241 = w_17 * w_239;
        let w_242 = minus_l_crank_angle_1_lambda_loop_2_y_turned * w_240;
        let w_243 = crank_angle_2_dot * w_107
            + minus_l_coupler_angle_3_lambda_loop_3_y_turned * w_241;
        let w_244 = l_lambda_loop_1_x_turned_crank_angle_1 * w_242;
        let w_245 = l_crank_angle_2_lambda_loop_2_y_turned * w_240
            - minus_l_crank_angle_2_lambda_loop_3_y_turned * w_241
            - minus_l_crank_angle_2_crank_angle_1 * w_242
            + l_crank_angle_2_coupler_angle_3 * w_243
            + minus_l_crank_angle_2_lambda_loop_1_x_turned * w_244;
        let w_246 = l_lambda_loop_2_x_turned_crank_angle_1 * w_242 - w_20 * w_239
            - l_lambda_loop_2_x_turned_lambda_loop_1_x_turned * w_244
            - l_lambda_loop_2_x_turned_crank_angle_2 * w_245;
        let w_247 = minus_inverse_lambda_loop_3_x_turned
            * (w_21 * w_239 + l_lambda_loop_3_x_turned_coupler_angle_3 * w_243
                - l_lambda_loop_3_x_turned_crank_angle_2 * w_245
                + minus_l_lambda_loop_3_x_turned_lambda_loop_2_x_turned * w_246);
        let w_248 = inverse_lambda_loop_2_x_turned * w_246
            - minus_l_lambda_loop_3_x_turned_lambda_loop_2_x_turned * w_247;
        let w_249 = inverse_crank_angle_2 * w_245
            - l_lambda_loop_2_x_turned_crank_angle_2 * w_248
            + l_lambda_loop_3_x_turned_crank_angle_2 * w_247;
        let w_250 = minus_l_crank_angle_2_lambda_loop_1_x_turned * w_249
            - minus_inverse_lambda_loop_1_x_turned * w_244
            - l_lambda_loop_2_x_turned_lambda_loop_1_x_turned * w_248;
        let w_251 = minus_l_crank_angle_2_crank_angle_1 * w_249
            - inverse_crank_angle_1 * w_242
            - l_lambda_loop_1_x_turned_crank_angle_1 * w_250
            - l_lambda_loop_2_x_turned_crank_angle_1 * w_248;
        let w_315 = self.minus_inverse_lambda_loop_2_y_turned * w_240
            + minus_l_crank_angle_1_lambda_loop_2_y_turned * w_251
            - l_crank_angle_2_lambda_loop_2_y_turned * w_249;
        let w_303 = l_lambda_loop_3_x_turned_coupler_angle_3 * w_247
            - inverse_coupler_angle_3 * w_243 - l_crank_angle_2_coupler_angle_3 * w_249;
        let w_304 = self.minus_inverse_lambda_loop_2_y_turned * w_241
            + minus_l_crank_angle_2_lambda_loop_3_y_turned * w_249
            + minus_l_coupler_angle_3_lambda_loop_3_y_turned * w_303;
        let w_252 = minus_l_crank_angle_1_coupler_angle_1 * w_251
            - l_lambda_loop_1_x_turned_coupler_angle_1 * w_250;
        let w_253 = minus_l_coupler_angle_1_lambda_loop_1_y_turned * w_252
            - l_crank_angle_1_lambda_loop_1_y_turned * w_251;
        let w_254 = minus_inverse_lambda_loop_3_x_turned * self.k_2 * crank_angle_3_dot;
        let w_255 = minus_l_lambda_loop_3_x_turned_lambda_loop_2_x_turned * w_254;
        let w_256 = l_lambda_loop_2_x_turned_crank_angle_2 * w_255
            + l_lambda_loop_3_x_turned_crank_angle_2 * w_254;
        let w_257 = minus_l_crank_angle_2_lambda_loop_1_x_turned * w_256
            + l_lambda_loop_2_x_turned_lambda_loop_1_x_turned * w_255;
        let w_258 = l_lambda_loop_1_x_turned_crank_angle_1 * w_257
            - minus_l_crank_angle_2_crank_angle_1 * w_256
            - l_lambda_loop_2_x_turned_crank_angle_1 * w_255;
        let w_259 = minus_l_crank_angle_1_coupler_angle_1 * w_258
            + l_lambda_loop_1_x_turned_coupler_angle_1 * w_257;
        let w_260 = minus_l_coupler_angle_1_lambda_loop_1_y_turned * w_259
            - l_crank_angle_1_lambda_loop_1_y_turned * w_258;
        let w_262 = coupler_angle_1_dot * self.k_2;
        let w_263 = self.l_lambda_loop_1_y_turned_crank_angle_0 * w_261 - w * w_262;
        let w_264 = l_coupler_angle_1_crank_angle_0 * w_261
            + minus_l_coupler_angle_1_lambda_loop_1_y_turned * w_263;
        let w_265 = minus_l_crank_angle_1_coupler_angle_1 * w_264
            - l_crank_angle_1_lambda_loop_1_y_turned * w_263;
        let w_266 = w_9 * w_262 - l_lambda_loop_1_x_turned_coupler_angle_1 * w_264
            - l_lambda_loop_1_x_turned_crank_angle_1 * w_265;
        let w_267 = minus_l_crank_angle_2_crank_angle_1 * w_265
            + minus_l_crank_angle_2_lambda_loop_1_x_turned * w_266;
        let w_268 = l_lambda_loop_2_x_turned_crank_angle_1 * w_265
            + l_lambda_loop_2_x_turned_lambda_loop_1_x_turned * w_266
            + l_lambda_loop_2_x_turned_crank_angle_2 * w_267;
        let w_269 = minus_inverse_lambda_loop_3_x_turned
            * (l_lambda_loop_3_x_turned_crank_angle_2 * w_267
                + minus_l_lambda_loop_3_x_turned_lambda_loop_2_x_turned * w_268);
        let w_270 = minus_l_lambda_loop_3_x_turned_lambda_loop_2_x_turned * w_269
            - inverse_lambda_loop_2_x_turned * w_268;
        let w_271 = inverse_crank_angle_2 * w_267
            - l_lambda_loop_2_x_turned_crank_angle_2 * w_270
            - l_lambda_loop_3_x_turned_crank_angle_2 * w_269;
        let w_272 = minus_l_crank_angle_2_lambda_loop_1_x_turned * w_271
            - minus_inverse_lambda_loop_1_x_turned * w_266
            - l_lambda_loop_2_x_turned_lambda_loop_1_x_turned * w_270;
        let w_273 = inverse_crank_angle_1 * w_265
            + minus_l_crank_angle_2_crank_angle_1 * w_271
            - l_lambda_loop_1_x_turned_crank_angle_1 * w_272
            - l_lambda_loop_2_x_turned_crank_angle_1 * w_270;
        let w_274 = inverse_coupler_angle_1 * w_264
            + minus_l_crank_angle_1_coupler_angle_1 * w_273
            - l_lambda_loop_1_x_turned_coupler_angle_1 * w_272;
        let w_275 = minus_l_coupler_angle_1_lambda_loop_1_y_turned * w_274
            - self.minus_inverse_lambda_loop_1_y_turned * w_263
            - l_crank_angle_1_lambda_loop_1_y_turned * w_273;
        let w_277 = l_lambda_loop_1_x_turned_crank_angle_1 * w_276;
        let w_278 = minus_l_crank_angle_2_crank_angle_1 * w_276
            - minus_l_crank_angle_2_lambda_loop_1_x_turned * w_277;
        let w_279 = self.k_2 * coupler_angle_2_dot
            - l_lambda_loop_2_x_turned_crank_angle_1 * w_276
            + l_lambda_loop_2_x_turned_lambda_loop_1_x_turned * w_277
            - l_lambda_loop_2_x_turned_crank_angle_2 * w_278;
        let w_280 = minus_inverse_lambda_loop_3_x_turned
            * (minus_l_lambda_loop_3_x_turned_lambda_loop_2_x_turned * w_279
                - l_lambda_loop_3_x_turned_crank_angle_2 * w_278);
        let w_281 = inverse_lambda_loop_2_x_turned * w_279
            - minus_l_lambda_loop_3_x_turned_lambda_loop_2_x_turned * w_280;
        let w_282 = inverse_crank_angle_2 * w_278
            - l_lambda_loop_2_x_turned_crank_angle_2 * w_281
            + l_lambda_loop_3_x_turned_crank_angle_2 * w_280;
        let w_283 = minus_inverse_lambda_loop_1_x_turned * w_277
            + minus_l_crank_angle_2_lambda_loop_1_x_turned * w_282
            - l_lambda_loop_2_x_turned_lambda_loop_1_x_turned * w_281;
        let w_284 = inverse_crank_angle_1 * w_276
            + minus_l_crank_angle_2_crank_angle_1 * w_282
            - l_lambda_loop_1_x_turned_crank_angle_1 * w_283
            - l_lambda_loop_2_x_turned_crank_angle_1 * w_281;
        let w_285 = minus_l_crank_angle_1_coupler_angle_1 * w_284
            - l_lambda_loop_1_x_turned_coupler_angle_1 * w_283;
        let w_286 = minus_l_coupler_angle_1_lambda_loop_1_y_turned * w_285
            - l_crank_angle_1_lambda_loop_1_y_turned * w_284;
        let w_287 = self.k_2 * coupler_angle_3_dot;
        let w_288 = w_18 * w_287;
        let w_289 = minus_l_coupler_angle_3_lambda_loop_3_y_turned * w_288;
        let w_290 = coupler_angle_3_dot * w_107
            - minus_l_crank_angle_2_lambda_loop_3_y_turned * w_288
            + l_crank_angle_2_coupler_angle_3 * w_289;
        let w_291 = l_lambda_loop_2_x_turned_crank_angle_2 * w_290;
        let w_292 = minus_inverse_lambda_loop_3_x_turned
            * (w_16 * w_287 + l_lambda_loop_3_x_turned_coupler_angle_3 * w_289
                - l_lambda_loop_3_x_turned_crank_angle_2 * w_290
                - minus_l_lambda_loop_3_x_turned_lambda_loop_2_x_turned * w_291);
        let w_293 = inverse_lambda_loop_2_x_turned * w_291
            + minus_l_lambda_loop_3_x_turned_lambda_loop_2_x_turned * w_292;
        let w_294 = inverse_crank_angle_2 * w_290
            + l_lambda_loop_2_x_turned_crank_angle_2 * w_293
            + l_lambda_loop_3_x_turned_crank_angle_2 * w_292;
        let w_295 = minus_l_crank_angle_2_lambda_loop_1_x_turned * w_294
            + l_lambda_loop_2_x_turned_lambda_loop_1_x_turned * w_293;
        let w_296 = minus_l_crank_angle_2_crank_angle_1 * w_294
            - l_lambda_loop_1_x_turned_crank_angle_1 * w_295
            + l_lambda_loop_2_x_turned_crank_angle_1 * w_293;
        let w_297 = minus_l_crank_angle_1_coupler_angle_1 * w_296
            - l_lambda_loop_1_x_turned_coupler_angle_1 * w_295;
        let w_298 = minus_l_coupler_angle_1_lambda_loop_1_y_turned * w_297
            - l_crank_angle_1_lambda_loop_1_y_turned * w_296;
        let w_311 = l_lambda_loop_3_x_turned_coupler_angle_3 * w_292
            - inverse_coupler_angle_3 * w_289 - l_crank_angle_2_coupler_angle_3 * w_294;
        let w_312 = self.minus_inverse_lambda_loop_2_y_turned * w_288
            + minus_l_crank_angle_2_lambda_loop_3_y_turned * w_294
            + minus_l_coupler_angle_3_lambda_loop_3_y_turned * w_311;
        let w_299 = l_crank_angle_2_coupler_angle_3 * w_218
            + l_lambda_loop_3_x_turned_coupler_angle_3 * w_216;
        let w_300 = minus_l_crank_angle_2_lambda_loop_3_y_turned * w_218
            - minus_l_coupler_angle_3_lambda_loop_3_y_turned * w_299;
        let w_301 = l_lambda_loop_3_x_turned_coupler_angle_3 * w_232
            - l_crank_angle_2_coupler_angle_3 * w_234;
        let w_302 = minus_l_crank_angle_2_lambda_loop_3_y_turned * w_234
            + minus_l_coupler_angle_3_lambda_loop_3_y_turned * w_301;
        let w_305 = l_crank_angle_2_coupler_angle_3 * w_256
            - l_lambda_loop_3_x_turned_coupler_angle_3 * w_254;
        let w_306 = minus_l_coupler_angle_3_lambda_loop_3_y_turned * w_305
            - minus_l_crank_angle_2_lambda_loop_3_y_turned * w_256;
        let w_307 = l_crank_angle_2_coupler_angle_3 * w_271
            + l_lambda_loop_3_x_turned_coupler_angle_3 * w_269;
        let w_309 = l_lambda_loop_3_x_turned_coupler_angle_3 * w_280
            - l_crank_angle_2_coupler_angle_3 * w_282;
        let w_308 = minus_l_crank_angle_2_lambda_loop_3_y_turned * w_271
            - minus_l_coupler_angle_3_lambda_loop_3_y_turned * w_307;
        let w_310 = minus_l_crank_angle_2_lambda_loop_3_y_turned * w_282
            + minus_l_coupler_angle_3_lambda_loop_3_y_turned * w_309;
        let w_313 = minus_l_crank_angle_1_lambda_loop_2_y_turned * w_220
            - l_crank_angle_2_lambda_loop_2_y_turned * w_218;
        let w_316 = minus_l_crank_angle_1_lambda_loop_2_y_turned * w_258
            + l_crank_angle_2_lambda_loop_2_y_turned * w_256;
        let w_317 = minus_l_crank_angle_1_lambda_loop_2_y_turned * w_273
            - l_crank_angle_2_lambda_loop_2_y_turned * w_271;
        let w_318 = minus_l_crank_angle_1_lambda_loop_2_y_turned * w_284
            - l_crank_angle_2_lambda_loop_2_y_turned * w_282;
        let w_319 = minus_l_crank_angle_1_lambda_loop_2_y_turned * w_296
            - l_crank_angle_2_lambda_loop_2_y_turned * w_294;
        sim_kernel::DynamicsJacobian {
            accelerations_by_positions: [
                [
                    self.inverse_crank_angle_0 * w_48
                        - l_coupler_angle_1_crank_angle_0 * w_71
                        - self.l_lambda_loop_1_y_turned_crank_angle_0 * w_72,
                    -(l_coupler_angle_1_crank_angle_0 * w_102
                        + self.l_lambda_loop_1_y_turned_crank_angle_0 * w_103),
                    -(l_coupler_angle_1_crank_angle_0 * w_134
                        + self.l_lambda_loop_1_y_turned_crank_angle_0 * w_135),
                    -(l_coupler_angle_1_crank_angle_0 * w_150
                        + self.l_lambda_loop_1_y_turned_crank_angle_0 * w_151),
                    self.inverse_crank_angle_0 * w_152
                        - l_coupler_angle_1_crank_angle_0 * w_164
                        - self.l_lambda_loop_1_y_turned_crank_angle_0 * w_165,
                    -(l_coupler_angle_1_crank_angle_0 * w_177
                        + self.l_lambda_loop_1_y_turned_crank_angle_0 * w_178),
                    -(l_coupler_angle_1_crank_angle_0 * w_188
                        + self.l_lambda_loop_1_y_turned_crank_angle_0 * w_189),
                ],
                [w_70, w_101, w_133, w_149, w_163, w_176, w_187],
                [w_68, w_99, w_131, w_147, w_161, w_174, w_185],
                [
                    self.l_lambda_loop_2_y_turned_coupler_angle_2 * w_191,
                    self.l_lambda_loop_2_y_turned_coupler_angle_2 * w_193,
                    self.l_lambda_loop_2_y_turned_coupler_angle_2 * w_195,
                    self.inverse_coupler_angle_2 * w_137
                        + self.l_lambda_loop_2_y_turned_coupler_angle_2 * w_197,
                    self.l_lambda_loop_2_y_turned_coupler_angle_2 * w_199,
                    self.l_lambda_loop_2_y_turned_coupler_angle_2 * w_201,
                    self.l_lambda_loop_2_y_turned_coupler_angle_2 * w_203,
                ],
                [w_71, w_102, w_134, w_150, w_164, w_177, w_188],
                [
                    -(l_crank_angle_1_coupler_angle_2 * w_70
                        + self.l_lambda_loop_2_y_turned_coupler_angle_2 * w_204),
                    self.inverse_coupler_angle_2 * w_88
                        - l_crank_angle_1_coupler_angle_2 * w_101
                        - self.l_lambda_loop_2_y_turned_coupler_angle_2 * w_205,
                    -(l_crank_angle_1_coupler_angle_2 * w_133
                        + self.l_lambda_loop_2_y_turned_coupler_angle_2 * w_206),
                    -(l_crank_angle_1_coupler_angle_2 * w_149
                        + self.l_lambda_loop_2_y_turned_coupler_angle_2 * w_207),
                    -(l_crank_angle_1_coupler_angle_2 * w_163
                        + self.l_lambda_loop_2_y_turned_coupler_angle_2 * w_208),
                    self.inverse_coupler_angle_2 * w_166
                        - l_crank_angle_1_coupler_angle_2 * w_176
                        - self.l_lambda_loop_2_y_turned_coupler_angle_2 * w_209,
                    -(l_crank_angle_1_coupler_angle_2 * w_187
                        + self.l_lambda_loop_2_y_turned_coupler_angle_2 * w_210),
                ],
                [-w_190, w_192, w_194, w_196, -w_198, w_200, w_202],
            ],
            accelerations_by_speeds: [
                [
                    -(l_coupler_angle_1_crank_angle_0 * w_221
                        + self.l_lambda_loop_1_y_turned_crank_angle_0 * w_222),
                    -(l_coupler_angle_1_crank_angle_0 * w_237
                        + self.l_lambda_loop_1_y_turned_crank_angle_0 * w_238),
                    -(l_coupler_angle_1_crank_angle_0 * w_252
                        + self.l_lambda_loop_1_y_turned_crank_angle_0 * w_253),
                    -(l_coupler_angle_1_crank_angle_0 * w_259
                        + self.l_lambda_loop_1_y_turned_crank_angle_0 * w_260),
                    -(self.inverse_crank_angle_0 * w_261
                        + l_coupler_angle_1_crank_angle_0 * w_274
                        + self.l_lambda_loop_1_y_turned_crank_angle_0 * w_275),
                    -(l_coupler_angle_1_crank_angle_0 * w_285
                        + self.l_lambda_loop_1_y_turned_crank_angle_0 * w_286),
                    -(l_coupler_angle_1_crank_angle_0 * w_297
                        + self.l_lambda_loop_1_y_turned_crank_angle_0 * w_298),
                ],
                [w_220, w_236, w_251, w_258, w_273, w_284, w_296],
                [w_218, w_234, w_249, -w_256, w_271, w_282, w_294],
                [
                    self.l_lambda_loop_2_y_turned_coupler_angle_2 * w_300,
                    self.l_lambda_loop_2_y_turned_coupler_angle_2 * w_302,
                    self.l_lambda_loop_2_y_turned_coupler_angle_2 * w_304,
                    self.l_lambda_loop_2_y_turned_coupler_angle_2 * w_306,
                    self.l_lambda_loop_2_y_turned_coupler_angle_2 * w_308,
                    self.l_lambda_loop_2_y_turned_coupler_angle_2 * w_310,
                    self.l_lambda_loop_2_y_turned_coupler_angle_2 * w_312,
                ],
                [w_221, w_237, w_252, w_259, w_274, w_285, w_297],
                [
                    -(l_crank_angle_1_coupler_angle_2 * w_220
                        + self.l_lambda_loop_2_y_turned_coupler_angle_2 * w_313),
                    -(self.inverse_coupler_angle_2 * w_225
                        + l_crank_angle_1_coupler_angle_2 * w_236
                        + self.l_lambda_loop_2_y_turned_coupler_angle_2 * w_314),
                    -(l_crank_angle_1_coupler_angle_2 * w_251
                        + self.l_lambda_loop_2_y_turned_coupler_angle_2 * w_315),
                    -(l_crank_angle_1_coupler_angle_2 * w_258
                        + self.l_lambda_loop_2_y_turned_coupler_angle_2 * w_316),
                    -(l_crank_angle_1_coupler_angle_2 * w_273
                        + self.l_lambda_loop_2_y_turned_coupler_angle_2 * w_317),
                    -(l_crank_angle_1_coupler_angle_2 * w_284
                        + self.l_lambda_loop_2_y_turned_coupler_angle_2 * w_318),
                    -(l_crank_angle_1_coupler_angle_2 * w_296
                        + self.l_lambda_loop_2_y_turned_coupler_angle_2 * w_319),
                ],
                [-w_299, w_301, w_303, w_305, -w_307, w_309, w_311],
            ],
            multipliers_by_positions: [
                [
                    cos_crank_angle_0 * w_69 - sin_crank_angle_0 * w_72
                        - (sin_crank_angle_0 * w_44 + cos_crank_angle_0 * w_49),
                    cos_crank_angle_0 * w_100 - sin_crank_angle_0 * w_103,
                    cos_crank_angle_0 * w_132 - sin_crank_angle_0 * w_135,
                    cos_crank_angle_0 * w_148 - sin_crank_angle_0 * w_151,
                    cos_crank_angle_0 * w_162 - sin_crank_angle_0 * w_165,
                    cos_crank_angle_0 * w_175 - sin_crank_angle_0 * w_178,
                    cos_crank_angle_0 * w_186 - sin_crank_angle_0 * w_189,
                ],
                [
                    sin_crank_angle_0 * w_69 + cos_crank_angle_0 * w_72
                        + (cos_crank_angle_0 * w_44 - sin_crank_angle_0 * w_49),
                    sin_crank_angle_0 * w_100 + cos_crank_angle_0 * w_103,
                    sin_crank_angle_0 * w_132 + cos_crank_angle_0 * w_135,
                    sin_crank_angle_0 * w_148 + cos_crank_angle_0 * w_151,
                    sin_crank_angle_0 * w_162 + cos_crank_angle_0 * w_165,
                    sin_crank_angle_0 * w_175 + cos_crank_angle_0 * w_178,
                    sin_crank_angle_0 * w_186 + cos_crank_angle_0 * w_189,
                ],
                [
                    cos_coupler_angle_2 * w_67 - sin_coupler_angle_2 * w_204,
                    cos_coupler_angle_2 * w_98 - sin_coupler_angle_2 * w_205,
                    cos_coupler_angle_2 * w_130 - sin_coupler_angle_2 * w_206,
                    cos_coupler_angle_2 * w_146 - sin_coupler_angle_2 * w_207,
                    cos_coupler_angle_2 * w_160 - sin_coupler_angle_2 * w_208,
                    cos_coupler_angle_2 * w_173 - sin_coupler_angle_2 * w_209
                        - (sin_coupler_angle_2 * w_43 + cos_coupler_angle_2 * w_77),
                    -(cos_coupler_angle_2 * w_184 + sin_coupler_angle_2 * w_210),
                ],
                [
                    sin_coupler_angle_2 * w_67 + cos_coupler_angle_2 * w_204,
                    sin_coupler_angle_2 * w_98 + cos_coupler_angle_2 * w_205,
                    sin_coupler_angle_2 * w_130 + cos_coupler_angle_2 * w_206,
                    sin_coupler_angle_2 * w_146 + cos_coupler_angle_2 * w_207,
                    sin_coupler_angle_2 * w_160 + cos_coupler_angle_2 * w_208,
                    sin_coupler_angle_2 * w_173 + cos_coupler_angle_2 * w_209
                        + (cos_coupler_angle_2 * w_43 - sin_coupler_angle_2 * w_77),
                    cos_coupler_angle_2 * w_210 - sin_coupler_angle_2 * w_184,
                ],
                [
                    cos_crank_angle_3 * w_66 - sin_crank_angle_3 * w_191,
                    -(cos_crank_angle_3 * w_97 + sin_crank_angle_3 * w_193),
                    -(cos_crank_angle_3 * w_129 + sin_crank_angle_3 * w_195),
                    cos_crank_angle_3 * w_145 - sin_crank_angle_3 * w_197
                        - (cos_crank_angle_3 * w_112 - sin_crank_angle_3 * w_42),
                    cos_crank_angle_3 * w_159 - sin_crank_angle_3 * w_199,
                    -(cos_crank_angle_3 * w_172 + sin_crank_angle_3 * w_201),
                    -(cos_crank_angle_3 * w_183 + sin_crank_angle_3 * w_203),
                ],
                [
                    sin_crank_angle_3 * w_66 + cos_crank_angle_3 * w_191,
                    cos_crank_angle_3 * w_193 - sin_crank_angle_3 * w_97,
                    cos_crank_angle_3 * w_195 - sin_crank_angle_3 * w_129,
                    sin_crank_angle_3 * w_145 + cos_crank_angle_3 * w_197
                        - (cos_crank_angle_3 * w_42 + sin_crank_angle_3 * w_112),
                    sin_crank_angle_3 * w_159 + cos_crank_angle_3 * w_199,
                    cos_crank_angle_3 * w_201 - sin_crank_angle_3 * w_172,
                    cos_crank_angle_3 * w_203 - sin_crank_angle_3 * w_183,
                ],
            ],
            multipliers_by_speeds: [
                [
                    cos_crank_angle_0 * w_219 - sin_crank_angle_0 * w_222,
                    cos_crank_angle_0 * w_235 - sin_crank_angle_0 * w_238,
                    cos_crank_angle_0 * w_250 - sin_crank_angle_0 * w_253,
                    -(cos_crank_angle_0 * w_257 + sin_crank_angle_0 * w_260),
                    cos_crank_angle_0 * w_272 - sin_crank_angle_0 * w_275,
                    cos_crank_angle_0 * w_283 - sin_crank_angle_0 * w_286,
                    cos_crank_angle_0 * w_295 - sin_crank_angle_0 * w_298,
                ],
                [
                    sin_crank_angle_0 * w_219 + cos_crank_angle_0 * w_222,
                    sin_crank_angle_0 * w_235 + cos_crank_angle_0 * w_238,
                    sin_crank_angle_0 * w_250 + cos_crank_angle_0 * w_253,
                    cos_crank_angle_0 * w_260 - sin_crank_angle_0 * w_257,
                    sin_crank_angle_0 * w_272 + cos_crank_angle_0 * w_275,
                    sin_crank_angle_0 * w_283 + cos_crank_angle_0 * w_286,
                    sin_crank_angle_0 * w_295 + cos_crank_angle_0 * w_298,
                ],
                [
                    cos_coupler_angle_2 * w_217 - sin_coupler_angle_2 * w_313,
                    cos_coupler_angle_2 * w_233 - sin_coupler_angle_2 * w_314,
                    cos_coupler_angle_2 * w_248 - sin_coupler_angle_2 * w_315,
                    cos_coupler_angle_2 * w_255 - sin_coupler_angle_2 * w_316,
                    cos_coupler_angle_2 * w_270 - sin_coupler_angle_2 * w_317,
                    cos_coupler_angle_2 * w_281 - sin_coupler_angle_2 * w_318,
                    -(cos_coupler_angle_2 * w_293 + sin_coupler_angle_2 * w_319),
                ],
                [
                    sin_coupler_angle_2 * w_217 + cos_coupler_angle_2 * w_313,
                    sin_coupler_angle_2 * w_233 + cos_coupler_angle_2 * w_314,
                    sin_coupler_angle_2 * w_248 + cos_coupler_angle_2 * w_315,
                    sin_coupler_angle_2 * w_255 + cos_coupler_angle_2 * w_316,
                    sin_coupler_angle_2 * w_270 + cos_coupler_angle_2 * w_317,
                    sin_coupler_angle_2 * w_281 + cos_coupler_angle_2 * w_318,
                    cos_coupler_angle_2 * w_319 - sin_coupler_angle_2 * w_293,
                ],
                [
                    cos_crank_angle_3 * w_216 - sin_crank_angle_3 * w_300,
                    -(cos_crank_angle_3 * w_232 + sin_crank_angle_3 * w_302),
                    -(cos_crank_angle_3 * w_247 + sin_crank_angle_3 * w_304),
                    cos_crank_angle_3 * w_254 - sin_crank_angle_3 * w_306,
                    cos_crank_angle_3 * w_269 - sin_crank_angle_3 * w_308,
                    -(cos_crank_angle_3 * w_280 + sin_crank_angle_3 * w_310),
                    -(cos_crank_angle_3 * w_292 + sin_crank_angle_3 * w_312),
                ],
                [
                    sin_crank_angle_3 * w_216 + cos_crank_angle_3 * w_300,
                    cos_crank_angle_3 * w_302 - sin_crank_angle_3 * w_232,
                    cos_crank_angle_3 * w_304 - sin_crank_angle_3 * w_247,
                    sin_crank_angle_3 * w_254 + cos_crank_angle_3 * w_306,
                    sin_crank_angle_3 * w_269 + cos_crank_angle_3 * w_308,
                    cos_crank_angle_3 * w_310 - sin_crank_angle_3 * w_280,
                    cos_crank_angle_3 * w_312 - sin_crank_angle_3 * w_292,
                ],
            ],
            refused: sim_kernel::pivot_is_refused(
                self.mass_crank_angle_0_crank_angle_0,
                self.mass_crank_angle_0_crank_angle_0,
            )
                | sim_kernel::pivot_is_refused(
                    self.pivot_lambda_loop_1_y_turned,
                    self.minus_pivot_lambda_loop_1_y_turned,
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
                    self.pivot_lambda_loop_2_y_turned,
                    self.minus_pivot_lambda_loop_2_y_turned,
                )
                | sim_kernel::pivot_is_refused(
                    pivot_coupler_angle_1,
                    self.mass_crank_angle_3_crank_angle_3 + w_12,
                )
                | sim_kernel::pivot_is_refused(
                    self.pivot_lambda_loop_2_y_turned,
                    self.minus_pivot_lambda_loop_2_y_turned,
                )
                | sim_kernel::pivot_is_refused(
                    pivot_crank_angle_1,
                    self.mass_crank_angle_0_crank_angle_0 + w_22 + w_23,
                )
                | sim_kernel::pivot_is_refused(
                    pivot_coupler_angle_3,
                    pivot_coupler_angle_3,
                )
                | sim_kernel::pivot_is_refused(
                    -minus_pivot_lambda_loop_1_x_turned,
                    minus_pivot_lambda_loop_1_x_turned,
                )
                | sim_kernel::pivot_is_refused(
                    pivot_crank_angle_2,
                    self.mass_crank_angle_0_crank_angle_0 + w_29 + w_30 + w_31,
                ) | sim_kernel::pivot_is_refused(pivot_lambda_loop_2_x_turned, w_34)
                | sim_kernel::pivot_is_refused(-minus_pivot_lambda_loop_3_x_turned, w_41),
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
    type Entries = [S; 0];
    type Envelope = [S; 0];
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
                    is_length: false,
                    docs: "Angle of crank 0.",
                },
                speed: sim_kernel::Quantity {
                    name: "crank_angle_0_dot",
                    unit: "rad/s",
                    factor: 1f64,
                    is_length: false,
                    docs: "",
                },
                acceleration: sim_kernel::Quantity {
                    name: "crank_angle_0_ddot",
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
                    name: "crank_angle_1",
                    unit: "rad",
                    factor: 1f64,
                    is_length: false,
                    docs: "Angle of crank 1.",
                },
                speed: sim_kernel::Quantity {
                    name: "crank_angle_1_dot",
                    unit: "rad/s",
                    factor: 1f64,
                    is_length: false,
                    docs: "",
                },
                acceleration: sim_kernel::Quantity {
                    name: "crank_angle_1_ddot",
                    unit: "rad/s^2",
                    factor: 1f64,
                    is_length: false,
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
                    is_length: false,
                    docs: "Angle of crank 2.",
                },
                speed: sim_kernel::Quantity {
                    name: "crank_angle_2_dot",
                    unit: "rad/s",
                    factor: 1f64,
                    is_length: false,
                    docs: "",
                },
                acceleration: sim_kernel::Quantity {
                    name: "crank_angle_2_ddot",
                    unit: "rad/s^2",
                    factor: 1f64,
                    is_length: false,
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
                    is_length: false,
                    docs: "Angle of crank 3.",
                },
                speed: sim_kernel::Quantity {
                    name: "crank_angle_3_dot",
                    unit: "rad/s",
                    factor: 1f64,
                    is_length: false,
                    docs: "",
                },
                acceleration: sim_kernel::Quantity {
                    name: "crank_angle_3_ddot",
                    unit: "rad/s^2",
                    factor: 1f64,
                    is_length: false,
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
                    is_length: false,
                    docs: "Angle of coupler 1.",
                },
                speed: sim_kernel::Quantity {
                    name: "coupler_angle_1_dot",
                    unit: "rad/s",
                    factor: 1f64,
                    is_length: false,
                    docs: "",
                },
                acceleration: sim_kernel::Quantity {
                    name: "coupler_angle_1_ddot",
                    unit: "rad/s^2",
                    factor: 1f64,
                    is_length: false,
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
                    is_length: false,
                    docs: "Angle of coupler 2.",
                },
                speed: sim_kernel::Quantity {
                    name: "coupler_angle_2_dot",
                    unit: "rad/s",
                    factor: 1f64,
                    is_length: false,
                    docs: "",
                },
                acceleration: sim_kernel::Quantity {
                    name: "coupler_angle_2_ddot",
                    unit: "rad/s^2",
                    factor: 1f64,
                    is_length: false,
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
                    is_length: false,
                    docs: "Angle of coupler 3.",
                },
                speed: sim_kernel::Quantity {
                    name: "coupler_angle_3_dot",
                    unit: "rad/s",
                    factor: 1f64,
                    is_length: false,
                    docs: "",
                },
                acceleration: sim_kernel::Quantity {
                    name: "coupler_angle_3_ddot",
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
                name: "l",
                unit: "m",
                factor: 1f64,
                is_length: true,
                docs: "Length of each bar.",
            },
            sim_kernel::Quantity {
                name: "m",
                unit: "kg",
                factor: 1f64,
                is_length: false,
                docs: "Mass of each bar.",
            },
            sim_kernel::Quantity {
                name: "start",
                unit: "deg",
                factor: 0.017453292519943295f64,
                is_length: false,
                docs: "Angle of the cranks at the start.",
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
                name: "loop_1_x",
                unit: "N",
                factor: 1f64,
                is_length: false,
                docs: "",
            },
            sim_kernel::Quantity {
                name: "loop_1_y",
                unit: "N",
                factor: 1f64,
                is_length: false,
                docs: "",
            },
            sim_kernel::Quantity {
                name: "loop_2_x",
                unit: "N",
                factor: 1f64,
                is_length: false,
                docs: "",
            },
            sim_kernel::Quantity {
                name: "loop_2_y",
                unit: "N",
                factor: 1f64,
                is_length: false,
                docs: "",
            },
            sim_kernel::Quantity {
                name: "loop_3_x",
                unit: "N",
                factor: 1f64,
                is_length: false,
                docs: "",
            },
            sim_kernel::Quantity {
                name: "loop_3_y",
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
                name: "first",
                unit: "deg",
                factor: 0.017453292519943295f64,
                is_length: false,
                docs: "first",
            },
            sim_kernel::Quantity {
                name: "last",
                unit: "deg",
                factor: 0.017453292519943295f64,
                is_length: false,
                docs: "last",
            },
            sim_kernel::Quantity {
                name: "Fx",
                unit: "N",
                factor: 1f64,
                is_length: false,
                docs: "along x",
            },
            sim_kernel::Quantity {
                name: "Fy",
                unit: "N",
                factor: 1f64,
                is_length: false,
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
        optional_kernels: &["dynamics_jacobian"],
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
