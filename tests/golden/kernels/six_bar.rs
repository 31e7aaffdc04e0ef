/// Stephenson's six-bar, third kind: a point of the coupler of a crank-rocker drives a second rocker by a link. The
/// crank turns evenly.
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
/// coordinates = [theta2; theta3; theta4; theta5; theta6]
/// multipliers = [
///     lambda_drive;
///     lambda_first_loop_x;
///     lambda_first_loop_y;
///     lambda_second_loop_x;
///     lambda_second_loop_y
/// ]
/// constraints = 0
///
/// mass_matrix = [
///     mass_matrix[1, 1], mass_matrix[1, 2], 0, mass_matrix[1, 4], 0;
///     mass_matrix[1, 2], mass_matrix[2, 2], 0, mass_matrix[2, 4], 0;
///     0, 0, c^2*m4/3, 0, 0;
///     mass_matrix[1, 4], mass_matrix[2, 4], 0, f^2*m5/3, 0;
///     0, 0, 0, 0, h^2*m6/3
/// ]
/// mass_matrix[1, 1] = J2 + a^2*m3 + a^2*m5
/// mass_matrix[1, 2] = a*p*m5*sin(theta2)*sin(theta3 + delta) + a*p*m5*cos(theta2)*cos(theta3 + delta)
///     + a*m3*s_1*sin(theta2)/3 + a*m3*s_2*cos(theta2)/3
/// mass_matrix[1, 4] = a*f*m5*u5_y*sin(theta2)/2 + a*f*m5*u5_x*cos(theta2)/2
/// mass_matrix[2, 2] = J3 + m3*s_1^2/9 + m3*s_2^2/9 + p^2*m5
/// mass_matrix[2, 4] = p*f*m5*u5_y*sin(theta3 + delta)/2 + p*f*m5*u5_x*cos(theta3 + delta)/2
///
/// convective_forces = [
///     convective_forces[1];
///     convective_forces[2];
///     0;
///     convective_forces[4];
///     0
/// ]
/// convective_forces[1] = a*m3*s_3*sin(theta2)/3 - a*m3*s_4*cos(theta2)/3 + a*m5*s_5*sin(theta2)/2
///     - a*m5*s_6*cos(theta2)/2
/// convective_forces[2] = m3*s_1*s_3/9 - m3*s_2*s_4/9 + p*m5*s_5*sin(theta3 + delta)/2
///     - p*m5*s_6*cos(theta3 + delta)/2
/// convective_forces[4] = f*m5*u5_y*s_5/4 - f*m5*u5_x*s_6/4
///
/// generalized_forces = [
///     generalized_forces[1];
///     generalized_forces[2];
///     -c*m4*g*u4_x/2;
///     -f*m5*g*u5_x/2;
///     -h*m6*g*u6_x/2
/// ]
/// generalized_forces[1] = -a*m3*g*cos(theta2) - a*m5*g*cos(theta2)
/// generalized_forces[2] = -m3*g*s_2/3 - p*m5*g*cos(theta3 + delta)
///
/// constraints = [
///     theta2 - t*w;
///     A_x - d + b*u3_x - c*u4_x;
///     A_y + b*u3_y - c*u4_y;
///     constraints[4];
///     constraints[5]
/// ]
/// constraints[4] = A_x - O6x + constraint_jacobian[5, 2] + f*u5_x - h*u6_x
/// constraints[5] = A_y - O6y + p*sin(theta3 + delta) + f*u5_y - h*u6_y
///
/// constraint_jacobian = [
///     1, 0, 0, 0, 0;
///     -a*sin(theta2), -b*u3_y, c*u4_y, 0, 0;
///     A_x, b*u3_x, -c*u4_x, 0, 0;
///     -a*sin(theta2), constraint_jacobian[4, 2], 0, -f*u5_y, h*u6_y;
///     A_x, constraint_jacobian[5, 2], 0, f*u5_x, -h*u6_x
/// ]
/// constraint_jacobian[4, 2] = -p*sin(theta3 + delta)
/// constraint_jacobian[5, 2] = p*cos(theta3 + delta)
///
/// constraint_convective = [
///     0;
///     constraint_convective[2];
///     constraint_convective[3];
///     constraint_convective[4];
///     constraint_convective[5]
/// ]
/// constraint_convective[2] = c*u4_x*theta4_dot^2 - a*theta2_dot^2*cos(theta2) - b*u3_x*theta3_dot^2
/// constraint_convective[3] = c*u4_y*theta4_dot^2 - a*theta2_dot^2*sin(theta2) - b*u3_y*theta3_dot^2
/// constraint_convective[4] = h*u6_x*theta6_dot^2 - a*theta2_dot^2*cos(theta2) - p*theta3_dot^2*cos(theta3 + delta)
///     - f*u5_x*theta5_dot^2
/// constraint_convective[5] = h*u6_y*theta6_dot^2 - a*theta2_dot^2*sin(theta2) - p*theta3_dot^2*sin(theta3 + delta)
///     - f*u5_y*theta5_dot^2
///
/// u3_x = cos(theta3)
/// u3_y = sin(theta3)
/// u4_x = cos(theta4)
/// u4_y = sin(theta4)
/// u5_x = cos(theta5)
/// u5_y = sin(theta5)
/// u6_x = cos(theta6)
/// u6_y = sin(theta6)
/// A_x = a*cos(theta2)
/// A_y = a*sin(theta2)
/// s_1 = b*u3_y + p*sin(theta3 + delta)
/// s_2 = b*u3_x + constraint_jacobian[5, 2]
/// s_3 = 3*a*theta2_dot^2*cos(theta2)
///     + theta3_dot*(p*theta3_dot*cos(theta3 + delta) + b*u3_x*theta3_dot)
/// s_4 = 3*a*theta2_dot^2*sin(theta2)
///     + theta3_dot*(p*theta3_dot*sin(theta3 + delta) + b*u3_y*theta3_dot)
/// s_5 = 2*a*theta2_dot^2*cos(theta2) + 2*p*theta3_dot^2*cos(theta3 + delta)
///     + f*u5_x*theta5_dot^2
/// s_6 = 2*a*theta2_dot^2*sin(theta2) + 2*p*theta3_dot^2*sin(theta3 + delta)
///     + f*u5_y*theta5_dot^2
/// ```
#[allow(non_snake_case)]
#[derive(
    ::core::clone::Clone,
    ::core::marker::Copy,
    ::core::fmt::Debug,
    ::core::cmp::PartialEq
)]
pub struct SixBar<S = ::core::primitive::f64> {
    /// Length of crank 2, in `m`.
    pub a: S,
    /// Length of coupler 3, from crank to rocker, in `m`.
    pub b: S,
    /// Length of rocker 4, in `m`.
    pub c: S,
    /// Distance of the pivots of crank 2 and rocker 4, in `m`.
    pub d: S,
    /// Distance of the coupler point from the crank's pin, in `m`.
    pub p: S,
    /// Angle of the coupler point above the coupler, in `1`.
    pub delta: S,
    /// Length of link 5, in `m`.
    pub f: S,
    /// Length of rocker 6, in `m`.
    pub h: S,
    /// Pivot of rocker 6, in `m`.
    pub O6x: S,
    /// Pivot of rocker 6, in `m`.
    pub O6y: S,
    /// Speed of the crank, in `1/s`.
    pub w: S,
    /// Inertia of the crank about its pivot, in `kg*m^2`.
    pub J2: S,
    /// Mass of the coupler, at its centre of mass, in `kg`.
    pub m3: S,
    /// Inertia of the coupler about its centre of mass, in `kg*m^2`.
    pub J3: S,
    /// Mass of rocker 4, slender, in `kg`.
    pub m4: S,
    /// Mass of link 5, slender, in `kg`.
    pub m5: S,
    /// Mass of rocker 6, slender, in `kg`.
    pub m6: S,
    /// In `m/s^2`.
    pub g: S,
}
impl<S: sim_kernel::Scalar> ::core::default::Default for SixBar<S> {
    /// The declared values.
    fn default() -> Self {
        <Self as sim_kernel::Mechanism<S>>::defaults()
    }
}
/// Coordinates of [`SixBar`] by name, in SI units; also for their speeds and accelerations.
#[allow(non_snake_case)]
#[derive(
    ::core::clone::Clone,
    ::core::marker::Copy,
    ::core::fmt::Debug,
    ::core::cmp::PartialEq
)]
pub struct SixBarCoordinates<S = ::core::primitive::f64> {
    /// Angle of crank 2, in `rad`.
    pub theta2: S,
    /// Angle of coupler 3, in `rad`.
    pub theta3: S,
    /// Angle of rocker 4, in `rad`.
    pub theta4: S,
    /// Angle of link 5, in `rad`.
    pub theta5: S,
    /// Angle of rocker 6, in `rad`.
    pub theta6: S,
}
impl<S: sim_kernel::Scalar> ::core::convert::From<[S; 5]> for SixBarCoordinates<S> {
    fn from(values: [S; 5]) -> Self {
        Self {
            theta2: values[0],
            theta3: values[1],
            theta4: values[2],
            theta5: values[3],
            theta6: values[4],
        }
    }
}
impl<S: sim_kernel::Scalar> ::core::convert::From<SixBarCoordinates<S>> for [S; 5] {
    fn from(record: SixBarCoordinates<S>) -> Self {
        [record.theta2, record.theta3, record.theta4, record.theta5, record.theta6]
    }
}
/// Outputs of [`SixBar`] by name, in SI units.
#[allow(non_snake_case)]
#[derive(
    ::core::clone::Clone,
    ::core::marker::Copy,
    ::core::fmt::Debug,
    ::core::cmp::PartialEq
)]
pub struct SixBarOutputs<S = ::core::primitive::f64> {
    /// rocker 4, in `1`.
    pub rocker4_angle: S,
    /// rocker 6, in `1`.
    pub rocker6_angle: S,
    /// rocker 4, in `rad/s`.
    pub rocker4_speed: S,
    /// rocker 6, in `rad/s`.
    pub rocker6_speed: S,
    /// torque, in `N*m`.
    pub T: S,
    /// along x, in `N`.
    pub Dx: S,
    /// along y, in `N`.
    pub Dy: S,
}
impl<S: sim_kernel::Scalar> ::core::convert::From<[S; 7]> for SixBarOutputs<S> {
    fn from(values: [S; 7]) -> Self {
        Self {
            rocker4_angle: values[0],
            rocker6_angle: values[1],
            rocker4_speed: values[2],
            rocker6_speed: values[3],
            T: values[4],
            Dx: values[5],
            Dy: values[6],
        }
    }
}
impl<S: sim_kernel::Scalar> ::core::convert::From<SixBarOutputs<S>> for [S; 7] {
    fn from(record: SixBarOutputs<S>) -> Self {
        [
            record.rocker4_angle,
            record.rocker6_angle,
            record.rocker4_speed,
            record.rocker6_speed,
            record.T,
            record.Dx,
            record.Dy,
        ]
    }
}
/// Rates of the outputs of [`SixBar`] by name, in SI units.
#[allow(non_snake_case)]
#[derive(
    ::core::clone::Clone,
    ::core::marker::Copy,
    ::core::fmt::Debug,
    ::core::cmp::PartialEq
)]
pub struct SixBarOutputRates<S = ::core::primitive::f64> {
    /// Rate of `rocker4_angle`.
    pub rocker4_angle: S,
    /// Rate of `rocker6_angle`.
    pub rocker6_angle: S,
    /// Rate of `rocker4_speed`.
    pub rocker4_speed: S,
    /// Rate of `rocker6_speed`.
    pub rocker6_speed: S,
}
impl<S: sim_kernel::Scalar> ::core::convert::From<[S; 4]> for SixBarOutputRates<S> {
    fn from(values: [S; 4]) -> Self {
        Self {
            rocker4_angle: values[0],
            rocker6_angle: values[1],
            rocker4_speed: values[2],
            rocker6_speed: values[3],
        }
    }
}
impl<S: sim_kernel::Scalar> ::core::convert::From<SixBarOutputRates<S>> for [S; 4] {
    fn from(record: SixBarOutputRates<S>) -> Self {
        [
            record.rocker4_angle,
            record.rocker6_angle,
            record.rocker4_speed,
            record.rocker6_speed,
        ]
    }
}
/// What the equations of motion need of the parameters of [`SixBar`], from [`SixBar::prepare`]; its methods are the kernels of each step.
#[allow(non_snake_case)]
#[derive(
    ::core::clone::Clone,
    ::core::marker::Copy,
    ::core::fmt::Debug,
    ::core::cmp::PartialEq
)]
pub struct SixBarPrepared<S = ::core::primitive::f64> {
    a: S,
    mass_theta2_theta2: S,
    p: S,
    delta: S,
    b: S,
    k: S,
    k_2: S,
    k_3: S,
    k_4: S,
    k_5: S,
    c: S,
    mass_theta4_theta4: S,
    f: S,
    k_6: S,
    k_7: S,
    mass_theta5_theta5: S,
    h: S,
    mass_theta6_theta6: S,
    k_8: S,
    k_9: S,
    k_10: S,
    k_11: S,
    k_12: S,
    k_13: S,
    k_14: S,
    k_15: S,
    k_16: S,
    k_17: S,
    k_18: S,
    k_19: S,
    k_20: S,
    k_21: S,
    k_22: S,
    k_23: S,
    inverse_theta4: S,
    minus_l_lambda_first_loop_y_turned_theta4: S,
    minus_pivot_lambda_first_loop_y_turned: S,
    pivot_lambda_first_loop_y_turned: S,
    minus_inverse_lambda_first_loop_y_turned: S,
    inverse_theta5: S,
    l_lambda_second_loop_y_turned_theta5: S,
    k_24: S,
    k_25: S,
    k_26: S,
    inverse_theta6: S,
    w: S,
    k_27: S,
    k_28: S,
    k_29: S,
    k_30: S,
    k_31: S,
    k_32: S,
    k_33: S,
    k_34: S,
    k_35: S,
    k_36: S,
    k_37: S,
    k_38: S,
    k_39: S,
    k_40: S,
}
#[allow(non_snake_case, unused_variables, unused_parens, clippy::all, clippy::pedantic)]
impl<S: sim_kernel::Scalar> SixBar<S> {
    /// What the equations of motion need of the parameters, computed once for a set of parameters.
    ///
    /// Operations: 11 additions, 62 multiplications, 4 divisions.
    #[inline]
    pub fn prepare(&self) -> SixBarPrepared<S> {
        let a_squared = self.a * self.a;
        let w = a_squared * self.m3;
        let w_2 = a_squared * self.m5;
        let w_3 = self.a * self.m5;
        let w_4 = self.p * w_3;
        let w_5 = self.a * self.m3;
        let w_6 = S::from_f64(0.3333333333333333) * w_5;
        let w_7 = self.m5 * self.p * self.p;
        let mass_theta4_theta4 = S::from_f64(0.3333333333333333) * self.c * self.c
            * self.m4;
        let w_8 = S::from_f64(0.5) * self.f;
        let w_9 = w_3 * w_8;
        let w_10 = self.m5 * self.p;
        let w_11 = w_8 * w_10;
        let w_12 = self.m5 * self.f * self.f;
        let mass_theta5_theta5 = S::from_f64(0.3333333333333333) * w_12;
        let mass_theta6_theta6 = S::from_f64(0.3333333333333333) * self.h * self.h
            * self.m6;
        let w_13 = self.g * self.m3 * S::from_f64(0.3333333333333333);
        let w_14 = w_10 * self.g;
        let w_15 = S::from_f64(0.5) * self.g;
        let w_16 = self.m5 * self.f;
        let inverse_mass_theta4_theta4 = S::from_f64(1.0) / mass_theta4_theta4;
        let w_17 = self.c * inverse_mass_theta4_theta4;
        let w_18 = self.c * w_17;
        let inverse_mass_theta5_theta5 = S::from_f64(1.0) / mass_theta5_theta5;
        let w_19 = self.f * inverse_mass_theta5_theta5;
        SixBarPrepared {
            a: self.a,
            mass_theta2_theta2: self.J2 + w + w_2,
            p: self.p,
            delta: self.delta,
            b: self.b,
            k: w_4,
            k_2: w_6,
            k_3: self.m3 * S::from_f64(0.1111111111111111),
            k_4: w_7,
            k_5: self.J3 + w_7,
            c: self.c,
            mass_theta4_theta4: mass_theta4_theta4,
            f: self.f,
            k_6: w_9,
            k_7: w_11,
            mass_theta5_theta5: mass_theta5_theta5,
            h: self.h,
            mass_theta6_theta6: mass_theta6_theta6,
            k_8: self.a * S::from_f64(3.0),
            k_9: self.a * S::from_f64(2.0),
            k_10: self.p * S::from_f64(2.0),
            k_11: w_3 * S::from_f64(0.5),
            k_12: w_5 * self.g + w_3 * self.g,
            k_13: self.b * w_6,
            k_14: self.p * w_6 + w_4,
            k_15: S::from_f64(0.5) * w_10,
            k_16: w_13,
            k_17: w_14,
            k_18: self.b * w_13,
            k_19: w_14 + self.p * w_13,
            k_20: self.c * self.m4 * w_15,
            k_21: S::from_f64(0.25) * w_16,
            k_22: w_15 * w_16,
            k_23: self.h * self.m6 * w_15,
            inverse_theta4: inverse_mass_theta4_theta4,
            minus_l_lambda_first_loop_y_turned_theta4: w_17,
            minus_pivot_lambda_first_loop_y_turned: w_18,
            pivot_lambda_first_loop_y_turned: -w_18,
            minus_inverse_lambda_first_loop_y_turned: S::from_f64(1.0) / w_18,
            inverse_theta5: inverse_mass_theta5_theta5,
            l_lambda_second_loop_y_turned_theta5: w_19,
            k_24: self.f * w_19,
            k_25: self.p - w_11 * w_19,
            k_26: self.a - w_9 * w_19,
            inverse_theta6: S::from_f64(1.0) / mass_theta6_theta6,
            w: self.w,
            k_27: self.m5 * w_15,
            k_28: w_4 * S::from_f64(3.0),
            k_29: w_5,
            k_30: w_3 * self.f,
            k_31: w + w_2,
            k_32: self.f * w_10,
            k_33: w_12 * S::from_f64(0.25),
            k_34: w_5 * S::from_f64(0.6666666666666666),
            k_35: w_4 * S::from_f64(2.0),
            k_36: S::from_f64(1.0) + S::from_f64(1.0),
            k_37: self.b * S::from_f64(2.0),
            k_38: self.c * S::from_f64(2.0),
            k_39: self.f * S::from_f64(2.0),
            k_40: self.h * S::from_f64(2.0),
        }
    }
    /// Mass matrix `T_q' M T_q`, 5 x 5, symmetric, in SI units.
    ///
    /// Operations: 13 additions, 42 multiplications, 4 sine-cosine pairs.
    #[inline]
    pub fn mass_matrix(&self, t: S, q: &[S; 5]) -> [[S; 5]; 5] {
        let [theta2, theta3, _, theta5, _] = *q;
        let a_squared = self.a * self.a;
        let w = self.a * self.m5;
        let w_2 = theta3 + self.delta;
        let ([sin_theta2, sin_w_2, u3_y, u5_y], [cos_theta2, cos_w_2, u3_x, u5_x]) = S::sin_cos_each([
            theta2,
            w_2,
            theta3,
            theta5,
        ]);
        let w_3 = self.b * u3_y + self.p * sin_w_2;
        let w_4 = self.b * u3_x + self.p * cos_w_2;
        let mass_theta3_theta2 = self.p * w
            * (sin_theta2 * sin_w_2 + cos_theta2 * cos_w_2)
            + self.a * self.m3 * S::from_f64(0.3333333333333333)
                * (sin_theta2 * w_3 + cos_theta2 * w_4);
        let w_5 = S::from_f64(0.5) * self.f;
        let mass_theta5_theta2 = w * w_5 * (sin_theta2 * u5_y + cos_theta2 * u5_x);
        let mass_theta5_theta3 = self.m5 * self.p * w_5
            * (sin_w_2 * u5_y + cos_w_2 * u5_x);
        [
            [
                self.J2 + a_squared * self.m3 + a_squared * self.m5,
                mass_theta3_theta2,
                S::from_f64(0.0),
                mass_theta5_theta2,
                S::from_f64(0.0),
            ],
            [
                mass_theta3_theta2,
                self.J3 + self.m5 * self.p * self.p
                    + self.m3 * S::from_f64(0.1111111111111111)
                        * (w_3 * w_3 + w_4 * w_4),
                S::from_f64(0.0),
                mass_theta5_theta3,
                S::from_f64(0.0),
            ],
            [
                S::from_f64(0.0),
                S::from_f64(0.0),
                S::from_f64(0.3333333333333333) * self.c * self.c * self.m4,
                S::from_f64(0.0),
                S::from_f64(0.0),
            ],
            [
                mass_theta5_theta2,
                mass_theta5_theta3,
                S::from_f64(0.0),
                self.m5 * S::from_f64(0.3333333333333333) * self.f * self.f,
                S::from_f64(0.0),
            ],
            [
                S::from_f64(0.0),
                S::from_f64(0.0),
                S::from_f64(0.0),
                S::from_f64(0.0),
                S::from_f64(0.3333333333333333) * self.h * self.h * self.m6,
            ],
        ]
    }
    /// Convective forces `T_q' M g`, 5, with `g = (T_q q' + T_t)_q q' + (..)_t`: joules per unit of each coordinate.
    ///
    /// Operations: 11 additions, 34 multiplications, 4 sine-cosine pairs.
    #[inline]
    pub fn convective_forces(&self, t: S, q: &[S; 5], qd: &[S; 5]) -> [S; 5] {
        let [theta2, theta3, _, theta5, _] = *q;
        let [theta2_dot, theta3_dot, _, theta5_dot, _] = *qd;
        let theta3_dot_squared = theta3_dot * theta3_dot;
        let w = S::from_f64(0.3333333333333333) * self.a;
        let w_2 = self.a * self.m5;
        let w_3 = theta3 + self.delta;
        let ([sin_theta2, sin_w_3, u3_y, u5_y], [cos_theta2, cos_w_3, u3_x, u5_x]) = S::sin_cos_each([
            theta2,
            w_3,
            theta3,
            theta5,
        ]);
        let w_4 = (self.m3 * self.p * w + self.p * w_2)
            * (sin_theta2 * cos_w_3 - cos_theta2 * sin_w_3)
            + self.m3 * self.b * w * (sin_theta2 * u3_x - cos_theta2 * u3_y);
        let w_5 = S::from_f64(0.5) * self.f;
        let w_6 = w_2 * w_5;
        let theta5_dot_squared = theta5_dot * theta5_dot;
        let w_7 = sin_theta2 * u5_x - cos_theta2 * u5_y;
        let w_8 = self.p * self.m5 * w_5;
        let w_9 = sin_w_3 * u5_x - cos_w_3 * u5_y;
        let theta2_dot_squared = theta2_dot * theta2_dot;
        [
            theta3_dot_squared * w_4 + w_6 * theta5_dot_squared * w_7,
            w_8 * theta5_dot_squared * w_9 - theta2_dot_squared * w_4,
            S::from_f64(0.0),
            -(theta2_dot_squared * w_6 * w_7 + theta3_dot_squared * w_8 * w_9),
            S::from_f64(0.0),
        ]
    }
    /// Generalised forces `T_q' F`, 5: joules per unit of each coordinate.
    ///
    /// Operations: 9 additions, 21 multiplications, 6 sine-cosine pairs.
    #[inline]
    pub fn generalized_forces(&self, t: S, q: &[S; 5], qd: &[S; 5]) -> [S; 5] {
        let [theta2, theta3, theta4, theta5, theta6] = *q;
        let ([_, _, _, _, _, _], [cos_theta2, u3_x, w, u4_x, u5_x, u6_x]) = S::sin_cos_each([
            theta2,
            theta3,
            theta3 + self.delta,
            theta4,
            theta5,
            theta6,
        ]);
        let w_2 = self.m3 * self.g;
        let w_3 = self.g * self.m5;
        let w_4 = self.g * S::from_f64(0.5);
        [
            -(cos_theta2 * (self.a * w_2 + self.a * w_3)),
            -((self.b * u3_x + self.p * w) * w_2 * S::from_f64(0.3333333333333333)
                + w * w_3 * self.p),
            -(u4_x * self.c * self.m4 * w_4),
            -(u5_x * w_3 * S::from_f64(0.5) * self.f),
            -(u6_x * w_4 * self.h * self.m6),
        ]
    }
    /// Constraints `C`, 5, in SI units; zero throughout the motion.
    ///
    /// Operations: 15 additions, 13 multiplications, 6 sine-cosine pairs.
    #[inline]
    pub fn constraints(&self, t: S, q: &[S; 5]) -> [S; 5] {
        let [theta2, theta3, theta4, theta5, theta6] = *q;
        let w = theta3 + self.delta;
        let (
            [sin_theta2,
            u3_y,
            u4_y,
            sin_w,
            u5_y,
            u6_y,
            ],
            [cos_theta2,
            u3_x,
            u4_x,
            cos_w,
            u5_x,
            u6_x,
            ],
        ) = S::sin_cos_each([theta2, theta3, theta4, w, theta5, theta6]);
        let w_2 = self.a * cos_theta2;
        let w_3 = self.a * sin_theta2;
        [
            theta2 - t * self.w,
            w_2 - self.d + self.b * u3_x - self.c * u4_x,
            w_3 + self.b * u3_y - self.c * u4_y,
            w_2 - self.O6x + self.p * cos_w + self.f * u5_x - self.h * u6_x,
            w_3 - self.O6y + self.p * sin_w + self.f * u5_y - self.h * u6_y,
        ]
    }
    /// The sum of the magnitudes of the terms of `C`, 5, in SI units: what its rounding is relative to.
    ///
    /// Operations: 32 additions, 13 multiplications, 6 sine-cosine pairs.
    #[inline]
    pub fn constraint_magnitudes(&self, t: S, q: &[S; 5]) -> [S; 5] {
        let [theta2, theta3, theta4, theta5, theta6] = *q;
        let w = theta3 + self.delta;
        let (
            [sin_theta2,
            u3_y,
            u4_y,
            sin_w,
            u5_y,
            u6_y,
            ],
            [cos_theta2,
            u3_x,
            u4_x,
            cos_w,
            u5_x,
            u6_x,
            ],
        ) = S::sin_cos_each([theta2, theta3, theta4, w, theta5, theta6]);
        let abs_A_x = (self.a * cos_theta2).abs();
        let abs_A_y = (self.a * sin_theta2).abs();
        [
            theta2.abs() + (t * self.w).abs(),
            self.d.abs() + abs_A_x + (self.b * u3_x).abs() + (self.c * u4_x).abs(),
            abs_A_y + (self.b * u3_y).abs() + (self.c * u4_y).abs(),
            abs_A_x + self.O6x.abs() + (self.p * cos_w).abs() + (self.f * u5_x).abs()
                + (self.h * u6_x).abs(),
            abs_A_y + self.O6y.abs() + (self.p * sin_w).abs() + (self.f * u5_y).abs()
                + (self.h * u6_y).abs(),
        ]
    }
    /// Constraint Jacobian `C_q`, 5 x 5: units of each constraint per unit of each coordinate.
    ///
    /// Operations: 7 additions, 12 multiplications, 6 sine-cosine pairs.
    #[inline]
    pub fn constraint_jacobian(&self, t: S, q: &[S; 5]) -> [[S; 5]; 5] {
        let [theta2, theta3, theta4, theta5, theta6] = *q;
        let w = theta3 + self.delta;
        let (
            [sin_theta2,
            sin_w,
            u3_y,
            u5_y,
            u4_y,
            u6_y,
            ],
            [cos_theta2,
            cos_w,
            u3_x,
            u5_x,
            u4_x,
            u6_x,
            ],
        ) = S::sin_cos_each([theta2, w, theta3, theta5, theta4, theta6]);
        let first_loop_x_by_theta2 = -(self.a * sin_theta2);
        let A_x = self.a * cos_theta2;
        [
            [
                S::from_f64(1.0),
                S::from_f64(0.0),
                S::from_f64(0.0),
                S::from_f64(0.0),
                S::from_f64(0.0),
            ],
            [
                first_loop_x_by_theta2,
                -(self.b * u3_y),
                self.c * u4_y,
                S::from_f64(0.0),
                S::from_f64(0.0),
            ],
            [A_x, self.b * u3_x, -(self.c * u4_x), S::from_f64(0.0), S::from_f64(0.0)],
            [
                first_loop_x_by_theta2,
                -(self.p * sin_w),
                S::from_f64(0.0),
                -(self.f * u5_y),
                self.h * u6_y,
            ],
            [A_x, self.p * cos_w, S::from_f64(0.0), self.f * u5_x, -(self.h * u6_x)],
        ]
    }
    /// `C_t`, 5, units of `C` per second: the speeds obey `C_q q' + C_t = 0`.
    ///
    /// Operations: 1 addition.
    #[inline]
    pub fn constraint_time_derivative(&self, t: S, q: &[S; 5]) -> [S; 5] {
        [-self.w, S::from_f64(0.0), S::from_f64(0.0), S::from_f64(0.0), S::from_f64(0.0)]
    }
    /// `(C_q q' + C_t)_q q' + (..)_t`, 5, units of `C` per second squared: the part of `C''` without accelerations.
    ///
    /// Operations: 11 additions, 23 multiplications, 6 sine-cosine pairs.
    #[inline]
    pub fn constraint_convective(&self, t: S, q: &[S; 5], qd: &[S; 5]) -> [S; 5] {
        let [theta2, theta3, theta4, theta5, theta6] = *q;
        let [theta2_dot, theta3_dot, theta4_dot, theta5_dot, theta6_dot] = *qd;
        let w = theta3 + self.delta;
        let (
            [sin_theta2,
            u4_y,
            u3_y,
            sin_w,
            u5_y,
            u6_y,
            ],
            [cos_theta2,
            u4_x,
            u3_x,
            cos_w,
            u5_x,
            u6_x,
            ],
        ) = S::sin_cos_each([theta2, theta4, theta3, w, theta5, theta6]);
        let w_2 = theta4_dot * theta4_dot * self.c;
        let w_3 = theta2_dot * theta2_dot * self.a;
        let w_4 = cos_theta2 * w_3;
        let theta3_dot_squared = theta3_dot * theta3_dot;
        let w_5 = theta3_dot_squared * self.b;
        let w_6 = w_3 * sin_theta2;
        let w_7 = theta6_dot * theta6_dot * self.h;
        let w_8 = theta3_dot_squared * self.p;
        let w_9 = theta5_dot * theta5_dot * self.f;
        [
            S::from_f64(0.0),
            u4_x * w_2 - w_4 - u3_x * w_5,
            w_2 * u4_y - w_6 - w_5 * u3_y,
            u6_x * w_7 - w_4 - cos_w * w_8 - u5_x * w_9,
            w_7 * u6_y - w_6 - w_8 * sin_w - w_9 * u5_y,
        ]
    }
    /// `C` (5), `C_q` (5 x 5) and `C_t` (5) together, in SI units, for projection.
    ///
    /// Operations: 22 additions, 13 multiplications, 6 sine-cosine pairs.
    #[inline]
    pub fn constraint_linearization(
        &self,
        t: S,
        q: &[S; 5],
    ) -> sim_kernel::ConstraintLinearization<[S; 5], [[S; 5]; 5]> {
        let [theta2, theta3, theta4, theta5, theta6] = *q;
        let w = theta3 + self.delta;
        let (
            [sin_theta2,
            u3_y,
            u4_y,
            sin_w,
            u5_y,
            u6_y,
            ],
            [cos_theta2,
            u3_x,
            u4_x,
            cos_w,
            u5_x,
            u6_x,
            ],
        ) = S::sin_cos_each([theta2, theta3, theta4, w, theta5, theta6]);
        let A_x = self.a * cos_theta2;
        let first_loop_y_by_theta3 = self.b * u3_x;
        let minus_first_loop_y_by_theta4 = self.c * u4_x;
        let minus_first_loop_x_by_theta2 = self.a * sin_theta2;
        let minus_first_loop_x_by_theta3 = self.b * u3_y;
        let first_loop_x_by_theta4 = self.c * u4_y;
        let second_loop_y_by_theta3 = self.p * cos_w;
        let second_loop_y_by_theta5 = self.f * u5_x;
        let minus_second_loop_y_by_theta6 = self.h * u6_x;
        let minus_second_loop_x_by_theta3 = self.p * sin_w;
        let minus_second_loop_x_by_theta5 = self.f * u5_y;
        let second_loop_x_by_theta6 = self.h * u6_y;
        let first_loop_x_by_theta2 = -minus_first_loop_x_by_theta2;
        sim_kernel::ConstraintLinearization {
            values: [
                theta2 - t * self.w,
                A_x - self.d + first_loop_y_by_theta3 - minus_first_loop_y_by_theta4,
                minus_first_loop_x_by_theta2 + minus_first_loop_x_by_theta3
                    - first_loop_x_by_theta4,
                A_x - self.O6x + second_loop_y_by_theta3 + second_loop_y_by_theta5
                    - minus_second_loop_y_by_theta6,
                minus_first_loop_x_by_theta2 - self.O6y + minus_second_loop_x_by_theta3
                    + minus_second_loop_x_by_theta5 - second_loop_x_by_theta6,
            ],
            jacobian: [
                [
                    S::from_f64(1.0),
                    S::from_f64(0.0),
                    S::from_f64(0.0),
                    S::from_f64(0.0),
                    S::from_f64(0.0),
                ],
                [
                    first_loop_x_by_theta2,
                    -minus_first_loop_x_by_theta3,
                    first_loop_x_by_theta4,
                    S::from_f64(0.0),
                    S::from_f64(0.0),
                ],
                [
                    A_x,
                    first_loop_y_by_theta3,
                    -minus_first_loop_y_by_theta4,
                    S::from_f64(0.0),
                    S::from_f64(0.0),
                ],
                [
                    first_loop_x_by_theta2,
                    -minus_second_loop_x_by_theta3,
                    S::from_f64(0.0),
                    -minus_second_loop_x_by_theta5,
                    second_loop_x_by_theta6,
                ],
                [
                    A_x,
                    second_loop_y_by_theta3,
                    S::from_f64(0.0),
                    second_loop_y_by_theta5,
                    -minus_second_loop_y_by_theta6,
                ],
            ],
            time_derivative: [
                -self.w,
                S::from_f64(0.0),
                S::from_f64(0.0),
                S::from_f64(0.0),
                S::from_f64(0.0),
            ],
        }
    }
    /// Kinetic energy `v' M v / 2`, in joules.
    ///
    /// Operations: 17 additions, 50 multiplications, 4 sine-cosine pairs.
    #[inline]
    pub fn kinetic_energy(&self, t: S, q: &[S; 5], qd: &[S; 5]) -> S {
        let [theta2, theta3, _, theta5, _] = *q;
        let [theta2_dot, theta3_dot, theta4_dot, theta5_dot, theta6_dot] = *qd;
        let w = theta3 + self.delta;
        let ([sin_theta2, u3_y, sin_w, u5_y], [cos_theta2, u3_x, cos_w, u5_x]) = S::sin_cos_each([
            theta2,
            theta3,
            w,
            theta5,
        ]);
        let w_2 = theta2_dot * S::from_f64(3.0) * self.a;
        let w_3 = sin_theta2 * w_2 + theta3_dot * (self.b * u3_y + self.p * sin_w);
        let w_4 = w_2 * cos_theta2 + theta3_dot * (self.b * u3_x + self.p * cos_w);
        let w_5 = theta2_dot * self.a * S::from_f64(2.0);
        let w_6 = theta3_dot * self.p * S::from_f64(2.0);
        let w_7 = theta5_dot * self.f;
        let w_8 = sin_theta2 * w_5 + sin_w * w_6 + u5_y * w_7;
        let w_9 = cos_theta2 * w_5 + cos_w * w_6 + w_7 * u5_x;
        let w_10 = self.m5 * S::from_f64(0.125) * (w_8 * w_8 + w_9 * w_9);
        let w_11 = theta4_dot * theta4_dot * S::from_f64(0.16666666666666666) * self.c
            * self.c * self.m4;
        let w_12 = theta5_dot * theta5_dot * S::from_f64(0.041666666666666664) * self.f
            * self.f * self.m5;
        let w_13 = theta6_dot * theta6_dot * S::from_f64(0.16666666666666666) * self.h
            * self.h * self.m6;
        S::from_f64(0.05555555555555555) * self.m3 * (w_3 * w_3 + w_4 * w_4) + w_10
            + theta2_dot * theta2_dot * S::from_f64(0.5) * self.J2
            + theta3_dot * theta3_dot * S::from_f64(0.5) * self.J3 + w_11 + w_12 + w_13
    }
    /// Power of loads and drives, `F' v + lambda' C_t + T_t' (M x'' - F)`, in watts.
    ///
    /// Operations: 10 additions, 29 multiplications, 6 sine-cosine pairs.
    #[inline]
    pub fn power(
        &self,
        t: S,
        q: &[S; 5],
        qd: &[S; 5],
        qdd: &[S; 5],
        lambda: &[S; 5],
    ) -> S {
        let [theta2, theta3, theta4, theta5, theta6] = *q;
        let [theta2_dot, theta3_dot, theta4_dot, theta5_dot, theta6_dot] = *qd;
        let [lambda_drive, _, _, _, _] = *lambda;
        let ([_, _, _, _, _, _], [cos_theta2, u3_x, w, u4_x, u5_x, u6_x]) = S::sin_cos_each([
            theta2,
            theta3,
            theta3 + self.delta,
            theta4,
            theta5,
            theta6,
        ]);
        let w_2 = (theta2_dot * cos_theta2 * S::from_f64(3.0) * self.a
            + theta3_dot * (self.b * u3_x + self.p * w))
            * S::from_f64(0.3333333333333333) * self.m3 * self.g;
        let w_3 = self.g * S::from_f64(0.5);
        let w_4 = (theta2_dot * cos_theta2 * self.a * S::from_f64(2.0)
            + theta3_dot * w * self.p * S::from_f64(2.0) + theta5_dot * self.f * u5_x)
            * self.m5 * w_3;
        -(w_2 + theta4_dot * u4_x * self.c * self.m4 * w_3 + w_4
            + theta6_dot * u6_x * self.h * self.m6 * w_3 + self.w * lambda_drive)
    }
    /// Outputs, 7, in SI units.
    ///
    /// Operations: 1 addition.
    #[inline]
    pub fn outputs(
        &self,
        t: S,
        q: &[S; 5],
        qd: &[S; 5],
        qdd: &[S; 5],
        lambda: &[S; 5],
    ) -> SixBarOutputs<S> {
        let [_, _, theta4, _, theta6] = *q;
        let [_, _, theta4_dot, _, theta6_dot] = *qd;
        let [lambda_drive, _, _, lambda_second_loop_x, lambda_second_loop_y] = *lambda;
        [
            theta4,
            theta6,
            theta4_dot,
            theta6_dot,
            -lambda_drive,
            lambda_second_loop_x,
            lambda_second_loop_y,
        ]
            .into()
    }
    /// Rates of the outputs that depend on neither accelerations nor multipliers, 4, in SI units per second.
    ///
    /// Operations: none.
    #[inline]
    pub fn output_rates(
        &self,
        t: S,
        q: &[S; 5],
        qd: &[S; 5],
        qdd: &[S; 5],
    ) -> SixBarOutputRates<S> {
        let [_, _, theta4_dot, _, theta6_dot] = *qd;
        let [_, _, theta4_ddot, _, theta6_ddot] = *qdd;
        [theta4_dot, theta6_dot, theta4_ddot, theta6_ddot].into()
    }
    /// `left - right` of each event, 2, in SI units: zero when it happens.
    ///
    /// Operations: 1 addition, 1 multiplication.
    #[inline]
    pub fn events(
        &self,
        t: S,
        q: &[S; 5],
        qd: &[S; 5],
        qdd: &[S; 5],
        lambda: &[S; 5],
    ) -> [S; 2] {
        let [theta2, _, _, _, _] = *q;
        let [_, _, _, _, theta6_dot] = *qd;
        [theta2 - S::from_f64(2.0) * S::from_f64(::core::f64::consts::PI), theta6_dot]
    }
    /// The numbers of each shape of the drawing, in metres and radians.
    ///
    /// Operations: 9 additions, 8 multiplications, 4 sine-cosine pairs.
    #[inline]
    pub fn drawing(&self, t: S, q: &[S; 5]) -> [S; 36] {
        let [theta2, theta3, _, theta5, _] = *q;
        let w = theta3 + self.delta;
        let ([sin_theta2, u3_y, sin_w, u5_y], [cos_theta2, u3_x, cos_w, u5_x]) = S::sin_cos_each([
            theta2,
            theta3,
            w,
            theta5,
        ]);
        let A_x = self.a * cos_theta2;
        let A_y = self.a * sin_theta2;
        let B_x = A_x + self.b * u3_x;
        let B_y = A_y + self.b * u3_y;
        let w_2 = self.p * cos_w;
        let P_x = A_x + w_2;
        let w_3 = self.p * sin_w;
        let P_y = A_y + w_3;
        let D_x = A_x + w_2 + self.f * u5_x;
        let D_y = A_y + w_3 + self.f * u5_y;
        [
            S::from_f64(0.0),
            S::from_f64(0.0),
            self.d,
            S::from_f64(0.0),
            self.O6x,
            self.O6y,
            S::from_f64(0.0),
            S::from_f64(0.0),
            A_x,
            A_y,
            A_x,
            A_y,
            B_x,
            B_y,
            P_x,
            P_y,
            A_x,
            A_y,
            self.d,
            S::from_f64(0.0),
            B_x,
            B_y,
            P_x,
            P_y,
            D_x,
            D_y,
            self.O6x,
            self.O6y,
            A_x,
            A_y,
            B_x,
            B_y,
            P_x,
            P_y,
            D_x,
            D_y,
        ]
    }
    /// Declared start: values or guesses of the coordinates (5), and speeds (5), in SI units; 0 where nothing is declared.
    ///
    /// Operations: none.
    #[inline]
    pub fn initial(&self) -> sim_kernel::Initial<[S; 5]> {
        sim_kernel::Initial {
            positions: [
                S::from_f64(0.0),
                S::from_f64(0.9),
                S::from_f64(1.7),
                S::from_f64(1.0),
                S::from_f64(2.4),
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
    /// [`SixBarPrepared::dynamics`] once; for many calls with the same parameters [`Self::prepare`] first.
    #[inline]
    pub fn dynamics(
        &self,
        t: S,
        q: &[S; 5],
        qd: &[S; 5],
    ) -> sim_kernel::Dynamics<S, [S; 5], [S; 5]> {
        self.prepare().dynamics(t, q, qd)
    }
    /// [`SixBarPrepared::dynamics_jacobian`] once; for many calls with the same parameters [`Self::prepare`] first.
    #[inline]
    pub fn dynamics_jacobian(
        &self,
        t: S,
        q: &[S; 5],
        qd: &[S; 5],
    ) -> sim_kernel::DynamicsJacobian<S, [[S; 5]; 5], [[S; 5]; 5]> {
        self.prepare().dynamics_jacobian(t, q, qd)
    }
}
#[allow(non_snake_case, unused_variables, unused_parens, clippy::all, clippy::pedantic)]
impl<S: sim_kernel::Scalar> SixBarPrepared<S> {
    /// Accelerations (5), multipliers (5) and power, from
    ///
    /// ```text
    /// [ T_q' M T_q   C_q' ] [ q''    ]   [ T_q' (F - M g)                      ]
    /// [ C_q          0    ] [ lambda ] = [ -(C_q q' + C_t)_q q' - (..)_t       ]
    /// ```
    ///
    /// by an elimination planned from the structure of the system, with pairs of constraint rows turned along and across links. Where `refused` is set a pivot was too small and nothing else holds: solve that state from the other kernels.
    ///
    /// Operations: 125 additions, 212 multiplications, 6 divisions, 6 sine-cosine pairs.
    #[inline(always)]
    pub fn dynamics(
        &self,
        t: S,
        q: &[S; 5],
        qd: &[S; 5],
    ) -> sim_kernel::Dynamics<S, [S; 5], [S; 5]> {
        let [theta2, theta3, theta4, theta5, theta6] = *q;
        let [theta2_dot, theta3_dot, theta4_dot, theta5_dot, theta6_dot] = *qd;
        let theta5_dot_squared = theta5_dot * theta5_dot;
        let w = theta3 + self.delta;
        let (
            [sin_theta2,
            sin_w,
            u3_y,
            u5_y,
            u4_y,
            u6_y,
            ],
            [cos_theta2,
            cos_w,
            u3_x,
            u5_x,
            u4_x,
            u6_x,
            ],
        ) = S::sin_cos_each([theta2, w, theta3, theta5, theta4, theta6]);
        let w_2 = cos_w * u5_y - sin_w * u5_x;
        let w_3 = self.k_7 * w_2;
        let k_lambda_second_loop_x_turned_theta3 = self.p * w_2;
        let theta2_dot_squared = theta2_dot * theta2_dot;
        let w_4 = self.k_14 * (sin_w * cos_theta2 - sin_theta2 * cos_w)
            + self.k_13 * (cos_theta2 * u3_y - sin_theta2 * u3_x);
        let k_theta3_lambda_first_loop_y_turned = self.b * (u3_x * u4_x + u3_y * u4_y);
        let minus_l_theta3_lambda_first_loop_y_turned = k_theta3_lambda_first_loop_y_turned
            * self.minus_inverse_lambda_first_loop_y_turned;
        let w_5 = cos_theta2 * u4_y - sin_theta2 * u4_x;
        let w_6 = self.a * theta2_dot_squared;
        let k_lambda_first_loop_x_turned_theta3 = self.b * (u3_x * u4_y - u3_y * u4_x);
        let theta3_dot_squared = theta3_dot * theta3_dot;
        let minus_rhs_theta4 = u4_x * self.k_20;
        let minus_rhs_lambda_first_loop_y_turned = w_5 * w_6
            + k_lambda_first_loop_x_turned_theta3 * theta3_dot_squared
            + minus_rhs_theta4 * self.minus_l_lambda_first_loop_y_turned_theta4;
        let w_7 = cos_theta2 * u5_y - sin_theta2 * u5_x;
        let w_8 = self.k_6 * w_7;
        let minus_rhs_theta5 = u5_x * self.k_22 + theta2_dot_squared * w_8
            + theta3_dot_squared * w_3;
        let w_9 = sin_w * u5_y + cos_w * u5_x;
        let mass_theta5_theta3 = self.k_7 * w_9;
        let l_theta3_theta5 = mass_theta5_theta3 * self.inverse_theta5;
        let rhs_theta3 = theta5_dot_squared * w_3 - cos_w * self.k_19
            - theta2_dot_squared * w_4 - u3_x * self.k_18
            - minus_l_theta3_lambda_first_loop_y_turned
                * minus_rhs_lambda_first_loop_y_turned
            + minus_rhs_theta5 * l_theta3_theta5;
        let w_10 = cos_theta2 * u4_x + sin_theta2 * u4_y;
        let k_theta2_lambda_first_loop_y_turned = self.a * w_10;
        let minus_l_theta2_lambda_first_loop_y_turned = k_theta2_lambda_first_loop_y_turned
            * self.minus_inverse_lambda_first_loop_y_turned;
        let w_11 = sin_theta2 * u5_y + cos_theta2 * u5_x;
        let mass_theta5_theta2 = self.k_6 * w_11;
        let l_theta2_theta5 = mass_theta5_theta2 * self.inverse_theta5;
        let w_12 = self.b * u3_y + self.p * sin_w;
        let w_13 = self.b * u3_x + self.p * cos_w;
        let mass_theta3_theta3 = self.k_5 + self.k_3 * (w_12 * w_12 + w_13 * w_13);
        let k_theta2_theta3 = self.k * (sin_theta2 * sin_w + cos_theta2 * cos_w)
            + self.k_2 * (sin_theta2 * w_12 + cos_theta2 * w_13)
            + k_theta2_lambda_first_loop_y_turned
                * minus_l_theta3_lambda_first_loop_y_turned
            - mass_theta5_theta2 * l_theta3_theta5;
        let w_15 = k_theta2_lambda_first_loop_y_turned
            * minus_l_theta2_lambda_first_loop_y_turned;
        let w_14 = k_theta3_lambda_first_loop_y_turned
            * minus_l_theta3_lambda_first_loop_y_turned;
        let pivot_theta3 = mass_theta3_theta3 + w_14
            - mass_theta5_theta3 * l_theta3_theta5;
        let inverse_theta3 = S::from_f64(1.0) / pivot_theta3;
        let l_theta2_theta3 = inverse_theta3 * k_theta2_theta3;
        let rhs_theta2 = theta3_dot_squared * w_4 - cos_theta2 * self.k_12
            + theta5_dot_squared * w_8
            - minus_l_theta2_lambda_first_loop_y_turned
                * minus_rhs_lambda_first_loop_y_turned
            + minus_rhs_theta5 * l_theta2_theta5 - l_theta2_theta3 * rhs_theta3;
        let pivot_theta2 = self.mass_theta2_theta2 + w_15
            - mass_theta5_theta2 * l_theta2_theta5 - k_theta2_theta3 * l_theta2_theta3;
        let inverse_theta2 = S::from_f64(1.0) / pivot_theta2;
        let l_lambda_first_loop_x_turned_theta3 = k_lambda_first_loop_x_turned_theta3
            * inverse_theta3;
        let k_lambda_first_loop_x_turned_theta2 = self.a * w_5
            - k_theta2_theta3 * l_lambda_first_loop_x_turned_theta3;
        let l_lambda_first_loop_x_turned_theta2 = inverse_theta2
            * k_lambda_first_loop_x_turned_theta2;
        let minus_inverse_lambda_drive = S::from_f64(1.0) / inverse_theta2;
        let l_lambda_first_loop_x_turned_lambda_drive = l_lambda_first_loop_x_turned_theta2
            * minus_inverse_lambda_drive;
        let minus_rhs_lambda_drive = inverse_theta2 * rhs_theta2;
        let rhs_lambda_first_loop_x_turned = l_lambda_first_loop_x_turned_lambda_drive
            * minus_rhs_lambda_drive
            - (self.c * theta4_dot * theta4_dot - w_10 * w_6
                - k_theta3_lambda_first_loop_y_turned * theta3_dot_squared)
            - l_lambda_first_loop_x_turned_theta3 * rhs_theta3
            - l_lambda_first_loop_x_turned_theta2 * rhs_theta2;
        let l_lambda_second_loop_x_turned_theta3 = k_lambda_second_loop_x_turned_theta3
            * inverse_theta3;
        let k_lambda_second_loop_x_turned_theta2 = self.a * w_7
            - k_theta2_theta3 * l_lambda_second_loop_x_turned_theta3;
        let l_lambda_second_loop_x_turned_theta2 = inverse_theta2
            * k_lambda_second_loop_x_turned_theta2;
        let l_lambda_second_loop_x_turned_lambda_drive = l_lambda_second_loop_x_turned_theta2
            * minus_inverse_lambda_drive;
        let minus_k_lambda_second_loop_y_turned_theta6 = self.h
            * (u5_y * u6_y + u5_x * u6_x);
        let theta6_dot_squared = theta6_dot * theta6_dot;
        let minus_rhs_theta6 = u6_x * self.k_23;
        let k_lambda_second_loop_x_turned_theta6 = self.h * (u5_x * u6_y - u5_y * u6_x);
        let l_lambda_second_loop_x_turned_theta6 = k_lambda_second_loop_x_turned_theta6
            * self.inverse_theta6;
        let w_16 = k_lambda_first_loop_x_turned_theta3
            * l_lambda_first_loop_x_turned_theta3
            + k_lambda_first_loop_x_turned_theta2 * l_lambda_first_loop_x_turned_theta2;
        let pivot_lambda_first_loop_x_turned = l_lambda_first_loop_x_turned_theta2
            * l_lambda_first_loop_x_turned_lambda_drive - w_16;
        let inverse_lambda_first_loop_x_turned = S::from_f64(1.0)
            / pivot_lambda_first_loop_x_turned;
        let k_lambda_second_loop_x_turned_lambda_first_loop_x_turned = l_lambda_first_loop_x_turned_theta2
            * l_lambda_second_loop_x_turned_lambda_drive
            - k_lambda_first_loop_x_turned_theta3 * l_lambda_second_loop_x_turned_theta3
            - k_lambda_first_loop_x_turned_theta2 * l_lambda_second_loop_x_turned_theta2;
        let l_lambda_second_loop_x_turned_lambda_first_loop_x_turned = inverse_lambda_first_loop_x_turned
            * k_lambda_second_loop_x_turned_lambda_first_loop_x_turned;
        let rhs_lambda_second_loop_x_turned = l_lambda_second_loop_x_turned_lambda_drive
            * minus_rhs_lambda_drive
            - (minus_k_lambda_second_loop_y_turned_theta6 * theta6_dot_squared
                - w_11 * w_6 - self.p * w_9 * theta3_dot_squared
                - self.f * theta5_dot_squared)
            - l_lambda_second_loop_x_turned_theta3 * rhs_theta3
            - l_lambda_second_loop_x_turned_theta2 * rhs_theta2
            + minus_rhs_theta6 * l_lambda_second_loop_x_turned_theta6
            - l_lambda_second_loop_x_turned_lambda_first_loop_x_turned
                * rhs_lambda_first_loop_x_turned;
        let k_lambda_second_loop_y_turned_theta3 = w_9 * self.k_25;
        let l_lambda_second_loop_y_turned_theta3 = inverse_theta3
            * k_lambda_second_loop_y_turned_theta3;
        let k_lambda_second_loop_y_turned_theta2 = w_11 * self.k_26
            - k_theta2_theta3 * l_lambda_second_loop_y_turned_theta3;
        let l_lambda_second_loop_y_turned_theta2 = inverse_theta2
            * k_lambda_second_loop_y_turned_theta2;
        let l_lambda_second_loop_y_turned_lambda_drive = l_lambda_second_loop_y_turned_theta2
            * minus_inverse_lambda_drive;
        let k_lambda_second_loop_y_turned_lambda_first_loop_x_turned = l_lambda_first_loop_x_turned_theta2
            * l_lambda_second_loop_y_turned_lambda_drive
            - k_lambda_first_loop_x_turned_theta3 * l_lambda_second_loop_y_turned_theta3
            - k_lambda_first_loop_x_turned_theta2 * l_lambda_second_loop_y_turned_theta2;
        let minus_l_lambda_second_loop_y_turned_theta6 = minus_k_lambda_second_loop_y_turned_theta6
            * self.inverse_theta6;
        let w_18 = self.k_24
            + k_lambda_second_loop_y_turned_theta3 * l_lambda_second_loop_y_turned_theta3
            + k_lambda_second_loop_y_turned_theta2 * l_lambda_second_loop_y_turned_theta2
            + minus_k_lambda_second_loop_y_turned_theta6
                * minus_l_lambda_second_loop_y_turned_theta6;
        let l_lambda_second_loop_y_turned_lambda_first_loop_x_turned = inverse_lambda_first_loop_x_turned
            * k_lambda_second_loop_y_turned_lambda_first_loop_x_turned;
        let w_17 = k_lambda_second_loop_x_turned_theta3
            * l_lambda_second_loop_x_turned_theta3
            + k_lambda_second_loop_x_turned_theta2 * l_lambda_second_loop_x_turned_theta2
            + k_lambda_second_loop_x_turned_theta6
                * l_lambda_second_loop_x_turned_theta6;
        let k_lambda_second_loop_y_turned_lambda_second_loop_x_turned = l_lambda_second_loop_x_turned_theta2
            * l_lambda_second_loop_y_turned_lambda_drive
            - k_lambda_second_loop_x_turned_theta3 * l_lambda_second_loop_y_turned_theta3
            - k_lambda_second_loop_x_turned_theta2 * l_lambda_second_loop_y_turned_theta2
            + k_lambda_second_loop_x_turned_theta6
                * minus_l_lambda_second_loop_y_turned_theta6
            - k_lambda_second_loop_x_turned_lambda_first_loop_x_turned
                * l_lambda_second_loop_y_turned_lambda_first_loop_x_turned;
        let pivot_lambda_second_loop_x_turned = l_lambda_second_loop_x_turned_theta2
            * l_lambda_second_loop_x_turned_lambda_drive - w_17
            - k_lambda_second_loop_x_turned_lambda_first_loop_x_turned
                * l_lambda_second_loop_x_turned_lambda_first_loop_x_turned;
        let inverse_lambda_second_loop_x_turned = S::from_f64(1.0)
            / pivot_lambda_second_loop_x_turned;
        let l_lambda_second_loop_y_turned_lambda_second_loop_x_turned = inverse_lambda_second_loop_x_turned
            * k_lambda_second_loop_y_turned_lambda_second_loop_x_turned;
        let rhs_lambda_second_loop_y_turned = minus_rhs_theta5
            * self.l_lambda_second_loop_y_turned_theta5
            - (w_7 * w_6 + k_lambda_second_loop_x_turned_theta3 * theta3_dot_squared
                + k_lambda_second_loop_x_turned_theta6 * theta6_dot_squared)
            - l_lambda_second_loop_y_turned_theta3 * rhs_theta3
            - l_lambda_second_loop_y_turned_theta2 * rhs_theta2
            + l_lambda_second_loop_y_turned_lambda_drive * minus_rhs_lambda_drive
            - minus_rhs_theta6 * minus_l_lambda_second_loop_y_turned_theta6
            - l_lambda_second_loop_y_turned_lambda_first_loop_x_turned
                * rhs_lambda_first_loop_x_turned
            - l_lambda_second_loop_y_turned_lambda_second_loop_x_turned
                * rhs_lambda_second_loop_x_turned;
        let pivot_lambda_second_loop_y_turned = l_lambda_second_loop_y_turned_theta2
            * l_lambda_second_loop_y_turned_lambda_drive - w_18
            - k_lambda_second_loop_y_turned_lambda_first_loop_x_turned
                * l_lambda_second_loop_y_turned_lambda_first_loop_x_turned
            - k_lambda_second_loop_y_turned_lambda_second_loop_x_turned
                * l_lambda_second_loop_y_turned_lambda_second_loop_x_turned;
        let w_19 = S::from_f64(1.0) / pivot_lambda_second_loop_y_turned
            * rhs_lambda_second_loop_y_turned;
        let w_20 = inverse_lambda_second_loop_x_turned * rhs_lambda_second_loop_x_turned
            - l_lambda_second_loop_y_turned_lambda_second_loop_x_turned * w_19;
        let w_21 = inverse_lambda_first_loop_x_turned * rhs_lambda_first_loop_x_turned
            - l_lambda_second_loop_x_turned_lambda_first_loop_x_turned * w_20
            - l_lambda_second_loop_y_turned_lambda_first_loop_x_turned * w_19;
        let lambda_drive = minus_inverse_lambda_drive * minus_rhs_lambda_drive
            - l_lambda_first_loop_x_turned_lambda_drive * w_21
            - l_lambda_second_loop_x_turned_lambda_drive * w_20
            - l_lambda_second_loop_y_turned_lambda_drive * w_19;
        let theta2_ddot = minus_rhs_lambda_drive - inverse_theta2 * lambda_drive
            - l_lambda_first_loop_x_turned_theta2 * w_21
            - l_lambda_second_loop_x_turned_theta2 * w_20
            - l_lambda_second_loop_y_turned_theta2 * w_19;
        let theta3_ddot = inverse_theta3 * rhs_theta3 - l_theta2_theta3 * theta2_ddot
            - l_lambda_first_loop_x_turned_theta3 * w_21
            - l_lambda_second_loop_x_turned_theta3 * w_20
            - l_lambda_second_loop_y_turned_theta3 * w_19;
        let w_22 = self.minus_inverse_lambda_first_loop_y_turned
            * minus_rhs_lambda_first_loop_y_turned
            + minus_l_theta2_lambda_first_loop_y_turned * theta2_ddot
            + minus_l_theta3_lambda_first_loop_y_turned * theta3_ddot;
        let w_23 = cos_theta2 * theta2_dot;
        let w_24 = (self.k_9 * w_23 + cos_w * theta3_dot * self.k_10
            + self.f * u5_x * theta5_dot) * self.k_27;
        sim_kernel::Dynamics {
            accelerations: [
                theta2_ddot,
                theta3_ddot,
                self.minus_l_lambda_first_loop_y_turned_theta4 * w_22
                    - minus_rhs_theta4 * self.inverse_theta4,
                -(minus_rhs_theta5 * self.inverse_theta5 + l_theta2_theta5 * theta2_ddot
                    + l_theta3_theta5 * theta3_ddot
                    + self.l_lambda_second_loop_y_turned_theta5 * w_19),
                minus_l_lambda_second_loop_y_turned_theta6 * w_19
                    - minus_rhs_theta6 * self.inverse_theta6
                    - l_lambda_second_loop_x_turned_theta6 * w_20,
            ],
            multipliers: [
                lambda_drive,
                u4_x * w_21 - u4_y * w_22,
                u4_y * w_21 + u4_x * w_22,
                u5_x * w_20 - u5_y * w_19,
                u5_y * w_20 + u5_x * w_19,
            ],
            power: -(self.k_16 * (w_13 * theta3_dot + self.k_8 * w_23)
                + minus_rhs_theta4 * theta4_dot + w_24 + minus_rhs_theta6 * theta6_dot
                + lambda_drive * self.w),
            refused: sim_kernel::pivot_is_refused(
                self.mass_theta4_theta4,
                self.mass_theta4_theta4,
            )
                | sim_kernel::pivot_is_refused(
                    self.pivot_lambda_first_loop_y_turned,
                    self.minus_pivot_lambda_first_loop_y_turned,
                )
                | sim_kernel::pivot_is_refused(
                    self.mass_theta5_theta5,
                    self.mass_theta5_theta5,
                ) | sim_kernel::pivot_is_refused(pivot_theta3, mass_theta3_theta3 + w_14)
                | sim_kernel::pivot_is_refused(
                    pivot_theta2,
                    self.mass_theta2_theta2 + w_15,
                ) | sim_kernel::pivot_is_refused(-inverse_theta2, inverse_theta2)
                | sim_kernel::pivot_is_refused(
                    self.mass_theta6_theta6,
                    self.mass_theta6_theta6,
                ) | sim_kernel::pivot_is_refused(pivot_lambda_first_loop_x_turned, w_16)
                | sim_kernel::pivot_is_refused(pivot_lambda_second_loop_x_turned, w_17)
                | sim_kernel::pivot_is_refused(pivot_lambda_second_loop_y_turned, w_18),
        }
    }
    /// The derivatives of accelerations (5 rows) and multipliers (5 rows) with respect to coordinates and speeds (5 columns each): with the equations of motion as `K z = r`, the solutions of `K dz = dr - dK z`. Where `refused` is set a pivot was too small and nothing else holds.
    ///
    /// Operations: 554 additions, 805 multiplications, 6 divisions, 6 sine-cosine pairs.
    #[inline]
    pub fn dynamics_jacobian(
        &self,
        t: S,
        q: &[S; 5],
        qd: &[S; 5],
    ) -> sim_kernel::DynamicsJacobian<S, [[S; 5]; 5], [[S; 5]; 5]> {
        let [theta2, theta3, theta4, theta5, theta6] = *q;
        let [theta2_dot, theta3_dot, theta4_dot, theta5_dot, theta6_dot] = *qd;
        let theta5_dot_squared = theta5_dot * theta5_dot;
        let w = theta3 + self.delta;
        let (
            [sin_theta2,
            sin_w,
            u3_y,
            u5_y,
            u4_y,
            u6_y,
            ],
            [cos_theta2,
            cos_w,
            u3_x,
            u5_x,
            u4_x,
            u6_x,
            ],
        ) = S::sin_cos_each([theta2, w, theta3, theta5, theta4, theta6]);
        let w_2 = cos_w * u5_y - sin_w * u5_x;
        let w_3 = self.k_7 * w_2;
        let theta2_dot_squared = theta2_dot * theta2_dot;
        let w_4 = sin_w * cos_theta2 - sin_theta2 * cos_w;
        let w_5 = self.k_14 * w_4 + self.k_13 * (cos_theta2 * u3_y - sin_theta2 * u3_x);
        let w_6 = u3_x * u4_x + u3_y * u4_y;
        let k_theta3_lambda_first_loop_y_turned = self.b * w_6;
        let minus_l_theta3_lambda_first_loop_y_turned = k_theta3_lambda_first_loop_y_turned
            * self.minus_inverse_lambda_first_loop_y_turned;
        let w_7 = cos_theta2 * u4_y - sin_theta2 * u4_x;
        let w_8 = self.a * theta2_dot_squared;
        let w_9 = w_7 * w_8;
        let w_10 = u3_x * u4_y - u3_y * u4_x;
        let k_lambda_first_loop_x_turned_theta3 = self.b * w_10;
        let theta3_dot_squared = theta3_dot * theta3_dot;
        let w_11 = k_lambda_first_loop_x_turned_theta3 * theta3_dot_squared;
        let minus_rhs_lambda_first_loop_y_turned = w_9 + w_11
            + u4_x * self.k_20 * self.minus_l_lambda_first_loop_y_turned_theta4;
        let w_12 = cos_theta2 * u5_y - sin_theta2 * u5_x;
        let w_13 = self.k_6 * w_12;
        let minus_rhs_theta5 = u5_x * self.k_22 + theta2_dot_squared * w_13
            + theta3_dot_squared * w_3;
        let w_14 = sin_w * u5_y + cos_w * u5_x;
        let mass_theta5_theta3 = self.k_7 * w_14;
        let l_theta3_theta5 = mass_theta5_theta3 * self.inverse_theta5;
        let rhs_theta3 = theta5_dot_squared * w_3 - cos_w * self.k_19
            - theta2_dot_squared * w_5 - u3_x * self.k_18
            - minus_l_theta3_lambda_first_loop_y_turned
                * minus_rhs_lambda_first_loop_y_turned
            + minus_rhs_theta5 * l_theta3_theta5;
        let w_15 = cos_theta2 * u4_x + sin_theta2 * u4_y;
        let k_theta2_lambda_first_loop_y_turned = self.a * w_15;
        let minus_l_theta2_lambda_first_loop_y_turned = k_theta2_lambda_first_loop_y_turned
            * self.minus_inverse_lambda_first_loop_y_turned;
        let w_16 = sin_theta2 * u5_y + cos_theta2 * u5_x;
        let mass_theta5_theta2 = self.k_6 * w_16;
        let l_theta2_theta5 = mass_theta5_theta2 * self.inverse_theta5;
        let w_17 = self.b * u3_y + self.p * sin_w;
        let w_18 = self.b * u3_x + self.p * cos_w;
        let mass_theta3_theta3 = self.k_5 + self.k_3 * (w_17 * w_17 + w_18 * w_18);
        let w_19 = k_theta3_lambda_first_loop_y_turned
            * minus_l_theta3_lambda_first_loop_y_turned;
        let pivot_theta3 = mass_theta3_theta3 + w_19
            - mass_theta5_theta3 * l_theta3_theta5;
        let inverse_theta3 = S::from_f64(1.0) / pivot_theta3;
        let w_20 = self.k * (sin_theta2 * sin_w + cos_theta2 * cos_w);
        let mass_theta3_theta2 = w_20
            + self.k_2 * (sin_theta2 * w_17 + cos_theta2 * w_18);
        let k_theta2_theta3 = mass_theta3_theta2
            + k_theta2_lambda_first_loop_y_turned
                * minus_l_theta3_lambda_first_loop_y_turned
            - mass_theta5_theta2 * l_theta3_theta5;
        let l_theta2_theta3 = inverse_theta3 * k_theta2_theta3;
        let rhs_theta2 = theta3_dot_squared * w_5 - cos_theta2 * self.k_12
            + theta5_dot_squared * w_13
            - minus_l_theta2_lambda_first_loop_y_turned
                * minus_rhs_lambda_first_loop_y_turned
            + minus_rhs_theta5 * l_theta2_theta5 - l_theta2_theta3 * rhs_theta3;
        let w_21 = k_theta2_lambda_first_loop_y_turned
            * minus_l_theta2_lambda_first_loop_y_turned;
        let pivot_theta2 = self.mass_theta2_theta2 + w_21
            - mass_theta5_theta2 * l_theta2_theta5 - k_theta2_theta3 * l_theta2_theta3;
        let inverse_theta2 = S::from_f64(1.0) / pivot_theta2;
        let w_22 = self.a * w_7;
        let l_lambda_first_loop_x_turned_theta3 = k_lambda_first_loop_x_turned_theta3
            * inverse_theta3;
        let k_lambda_first_loop_x_turned_theta2 = w_22
            - k_theta2_theta3 * l_lambda_first_loop_x_turned_theta3;
        let l_lambda_first_loop_x_turned_theta2 = inverse_theta2
            * k_lambda_first_loop_x_turned_theta2;
        let minus_inverse_lambda_drive = S::from_f64(1.0) / inverse_theta2;
        let l_lambda_first_loop_x_turned_lambda_drive = l_lambda_first_loop_x_turned_theta2
            * minus_inverse_lambda_drive;
        let minus_rhs_lambda_drive = inverse_theta2 * rhs_theta2;
        let w_23 = w_15 * w_8;
        let w_24 = k_theta3_lambda_first_loop_y_turned * theta3_dot_squared;
        let rhs_lambda_first_loop_x_turned = l_lambda_first_loop_x_turned_lambda_drive
            * minus_rhs_lambda_drive - (self.c * theta4_dot * theta4_dot - w_23 - w_24)
            - l_lambda_first_loop_x_turned_theta3 * rhs_theta3
            - l_lambda_first_loop_x_turned_theta2 * rhs_theta2;
        let w_25 = self.a * w_12;
        let k_lambda_second_loop_x_turned_theta3 = self.p * w_2;
        let l_lambda_second_loop_x_turned_theta3 = k_lambda_second_loop_x_turned_theta3
            * inverse_theta3;
        let k_lambda_second_loop_x_turned_theta2 = w_25
            - k_theta2_theta3 * l_lambda_second_loop_x_turned_theta3;
        let l_lambda_second_loop_x_turned_theta2 = inverse_theta2
            * k_lambda_second_loop_x_turned_theta2;
        let l_lambda_second_loop_x_turned_lambda_drive = l_lambda_second_loop_x_turned_theta2
            * minus_inverse_lambda_drive;
        let w_26 = u5_y * u6_y + u5_x * u6_x;
        let minus_k_lambda_second_loop_y_turned_theta6 = self.h * w_26;
        let theta6_dot_squared = theta6_dot * theta6_dot;
        let w_27 = minus_k_lambda_second_loop_y_turned_theta6 * theta6_dot_squared;
        let w_28 = w_16 * w_8;
        let w_34 = w_12 * w_8;
        let w_29 = self.p * w_14;
        let w_30 = w_29 * theta3_dot_squared;
        let w_31 = self.f * theta5_dot_squared;
        let minus_rhs_theta6 = u6_x * self.k_23;
        let w_32 = u5_x * u6_y - u5_y * u6_x;
        let k_lambda_second_loop_x_turned_theta6 = self.h * w_32;
        let w_36 = k_lambda_second_loop_x_turned_theta6 * theta6_dot_squared;
        let l_lambda_second_loop_x_turned_theta6 = k_lambda_second_loop_x_turned_theta6
            * self.inverse_theta6;
        let w_33 = k_lambda_first_loop_x_turned_theta3
            * l_lambda_first_loop_x_turned_theta3
            + k_lambda_first_loop_x_turned_theta2 * l_lambda_first_loop_x_turned_theta2;
        let pivot_lambda_first_loop_x_turned = l_lambda_first_loop_x_turned_theta2
            * l_lambda_first_loop_x_turned_lambda_drive - w_33;
        let inverse_lambda_first_loop_x_turned = S::from_f64(1.0)
            / pivot_lambda_first_loop_x_turned;
        let k_lambda_second_loop_x_turned_lambda_first_loop_x_turned = l_lambda_first_loop_x_turned_theta2
            * l_lambda_second_loop_x_turned_lambda_drive
            - k_lambda_first_loop_x_turned_theta3 * l_lambda_second_loop_x_turned_theta3
            - k_lambda_first_loop_x_turned_theta2 * l_lambda_second_loop_x_turned_theta2;
        let l_lambda_second_loop_x_turned_lambda_first_loop_x_turned = inverse_lambda_first_loop_x_turned
            * k_lambda_second_loop_x_turned_lambda_first_loop_x_turned;
        let rhs_lambda_second_loop_x_turned = l_lambda_second_loop_x_turned_lambda_drive
            * minus_rhs_lambda_drive - (w_27 - w_28 - w_30 - w_31)
            - l_lambda_second_loop_x_turned_theta3 * rhs_theta3
            - l_lambda_second_loop_x_turned_theta2 * rhs_theta2
            + minus_rhs_theta6 * l_lambda_second_loop_x_turned_theta6
            - l_lambda_second_loop_x_turned_lambda_first_loop_x_turned
                * rhs_lambda_first_loop_x_turned;
        let w_35 = k_lambda_second_loop_x_turned_theta3 * theta3_dot_squared;
        let k_lambda_second_loop_y_turned_theta3 = w_14 * self.k_25;
        let l_lambda_second_loop_y_turned_theta3 = inverse_theta3
            * k_lambda_second_loop_y_turned_theta3;
        let k_lambda_second_loop_y_turned_theta2 = w_16 * self.k_26
            - k_theta2_theta3 * l_lambda_second_loop_y_turned_theta3;
        let l_lambda_second_loop_y_turned_theta2 = inverse_theta2
            * k_lambda_second_loop_y_turned_theta2;
        let l_lambda_second_loop_y_turned_lambda_drive = l_lambda_second_loop_y_turned_theta2
            * minus_inverse_lambda_drive;
        let k_lambda_second_loop_y_turned_lambda_first_loop_x_turned = l_lambda_first_loop_x_turned_theta2
            * l_lambda_second_loop_y_turned_lambda_drive
            - k_lambda_first_loop_x_turned_theta3 * l_lambda_second_loop_y_turned_theta3
            - k_lambda_first_loop_x_turned_theta2 * l_lambda_second_loop_y_turned_theta2;
        let minus_l_lambda_second_loop_y_turned_theta6 = minus_k_lambda_second_loop_y_turned_theta6
            * self.inverse_theta6;
        let w_49 = self.k_24
            + k_lambda_second_loop_y_turned_theta3 * l_lambda_second_loop_y_turned_theta3
            + k_lambda_second_loop_y_turned_theta2 * l_lambda_second_loop_y_turned_theta2
            + minus_k_lambda_second_loop_y_turned_theta6
                * minus_l_lambda_second_loop_y_turned_theta6;
        let l_lambda_second_loop_y_turned_lambda_first_loop_x_turned = inverse_lambda_first_loop_x_turned
            * k_lambda_second_loop_y_turned_lambda_first_loop_x_turned;
        let w_37 = k_lambda_second_loop_x_turned_theta3
            * l_lambda_second_loop_x_turned_theta3
            + k_lambda_second_loop_x_turned_theta2 * l_lambda_second_loop_x_turned_theta2
            + k_lambda_second_loop_x_turned_theta6
                * l_lambda_second_loop_x_turned_theta6;
        let k_lambda_second_loop_y_turned_lambda_second_loop_x_turned = l_lambda_second_loop_x_turned_theta2
            * l_lambda_second_loop_y_turned_lambda_drive
            - k_lambda_second_loop_x_turned_theta3 * l_lambda_second_loop_y_turned_theta3
            - k_lambda_second_loop_x_turned_theta2 * l_lambda_second_loop_y_turned_theta2
            + k_lambda_second_loop_x_turned_theta6
                * minus_l_lambda_second_loop_y_turned_theta6
            - k_lambda_second_loop_x_turned_lambda_first_loop_x_turned
                * l_lambda_second_loop_y_turned_lambda_first_loop_x_turned;
        let pivot_lambda_second_loop_x_turned = l_lambda_second_loop_x_turned_theta2
            * l_lambda_second_loop_x_turned_lambda_drive - w_37
            - k_lambda_second_loop_x_turned_lambda_first_loop_x_turned
                * l_lambda_second_loop_x_turned_lambda_first_loop_x_turned;
        let inverse_lambda_second_loop_x_turned = S::from_f64(1.0)
            / pivot_lambda_second_loop_x_turned;
        let l_lambda_second_loop_y_turned_lambda_second_loop_x_turned = inverse_lambda_second_loop_x_turned
            * k_lambda_second_loop_y_turned_lambda_second_loop_x_turned;
        let rhs_lambda_second_loop_y_turned = minus_rhs_theta5
            * self.l_lambda_second_loop_y_turned_theta5 - (w_34 + w_35 + w_36)
            - l_lambda_second_loop_y_turned_theta3 * rhs_theta3
            - l_lambda_second_loop_y_turned_theta2 * rhs_theta2
            + l_lambda_second_loop_y_turned_lambda_drive * minus_rhs_lambda_drive
            - minus_rhs_theta6 * minus_l_lambda_second_loop_y_turned_theta6
            - l_lambda_second_loop_y_turned_lambda_first_loop_x_turned
                * rhs_lambda_first_loop_x_turned
            - l_lambda_second_loop_y_turned_lambda_second_loop_x_turned
                * rhs_lambda_second_loop_x_turned;
        let pivot_lambda_second_loop_y_turned = l_lambda_second_loop_y_turned_theta2
            * l_lambda_second_loop_y_turned_lambda_drive - w_49
            - k_lambda_second_loop_y_turned_lambda_first_loop_x_turned
                * l_lambda_second_loop_y_turned_lambda_first_loop_x_turned
            - k_lambda_second_loop_y_turned_lambda_second_loop_x_turned
                * l_lambda_second_loop_y_turned_lambda_second_loop_x_turned;
        let w_38 = sin_theta2 * theta2_dot_squared;
        let w_39 = w_17 * theta3_dot;
        let w_40 = theta3_dot * w_39;
        let w_41 = self.k_8 * w_38 + w_40;
        let w_42 = theta3_dot_squared * self.k_10;
        let w_43 = w_38 * self.k_9 + sin_w * w_42 + u5_y * w_31;
        let w_44 = cos_theta2 * theta2_dot_squared;
        let w_48 = w_44 * self.k_9 + cos_w * w_42 + u5_x * w_31;
        let w_45 = w_18 * theta3_dot;
        let w_46 = theta3_dot * w_45;
        let w_47 = self.k_8 * w_44 + w_46;
        let inverse_lambda_second_loop_y_turned = S::from_f64(1.0)
            / pivot_lambda_second_loop_y_turned;
        let w_50 = inverse_lambda_second_loop_y_turned * rhs_lambda_second_loop_y_turned;
        let w_51 = inverse_lambda_second_loop_x_turned * rhs_lambda_second_loop_x_turned
            - l_lambda_second_loop_y_turned_lambda_second_loop_x_turned * w_50;
        let w_52 = inverse_lambda_first_loop_x_turned * rhs_lambda_first_loop_x_turned
            - l_lambda_second_loop_x_turned_lambda_first_loop_x_turned * w_51
            - l_lambda_second_loop_y_turned_lambda_first_loop_x_turned * w_50;
        let theta2_ddot = minus_rhs_lambda_drive
            - inverse_theta2
                * (minus_inverse_lambda_drive * minus_rhs_lambda_drive
                    - l_lambda_first_loop_x_turned_lambda_drive * w_52
                    - l_lambda_second_loop_x_turned_lambda_drive * w_51
                    - l_lambda_second_loop_y_turned_lambda_drive * w_50)
            - l_lambda_first_loop_x_turned_theta2 * w_52
            - l_lambda_second_loop_x_turned_theta2 * w_51
            - l_lambda_second_loop_y_turned_theta2 * w_50;
        let theta3_ddot = inverse_theta3 * rhs_theta3 - l_theta2_theta3 * theta2_ddot
            - l_lambda_first_loop_x_turned_theta3 * w_52
            - l_lambda_second_loop_x_turned_theta3 * w_51
            - l_lambda_second_loop_y_turned_theta3 * w_50;
        let w_57 = S::from_f64(0.5)
            * (minus_rhs_theta5 * self.inverse_theta5 + l_theta2_theta5 * theta2_ddot
                + l_theta3_theta5 * theta3_ddot
                + self.l_lambda_second_loop_y_turned_theta5 * w_50);
        let w_60 = self.minus_inverse_lambda_first_loop_y_turned
            * minus_rhs_lambda_first_loop_y_turned
            + minus_l_theta2_lambda_first_loop_y_turned * theta2_ddot
            + minus_l_theta3_lambda_first_loop_y_turned * theta3_ddot;
        let theta6_ddot = minus_l_lambda_second_loop_y_turned_theta6 * w_50
            - minus_rhs_theta6 * self.inverse_theta6
            - l_lambda_second_loop_x_turned_theta6 * w_51;
        let w_53 = cos_theta2 * w_17 - sin_theta2 * w_18;
        let w_54 = S::from_f64(0.3333333333333333)
            * (self.k_29 * w_53 + w_4 * self.k_28);
        let w_157 = w_4 * self.k_35;
        let w_55 = theta3_ddot * w_54;
        let w_70 = theta2_ddot * w_54;
        let w_56 = w_12 * self.k_30;
        let w_58 = w_56 * w_57;
        let w_59 = k_theta2_lambda_first_loop_y_turned * w_52;
        let w_74 = k_theta2_lambda_first_loop_y_turned * theta2_ddot;
        let w_61 = w_22 * w_60;
        let w_66 = w_22 * theta2_ddot;
        let w_62 = self.a * w_16;
        let w_63 = w_62 * w_51;
        let w_76 = w_62 * theta2_ddot;
        let w_64 = w_25 * w_50;
        let w_78 = w_25 * theta2_ddot;
        let w_68 = theta2_ddot * w_56;
        let w_65 = sin_theta2 * (self.k_12 - self.k_2 * w_41 - w_43 * self.k_11)
            - cos_theta2 * (self.k_2 * w_47 + w_48 * self.k_11) - w_55 + w_58
            + theta2_dot_squared * self.k_31 + w_59 - w_61 + w_63 - w_64;
        let w_67 = w_23 - w_66;
        let w_69 = mass_theta5_theta2 * theta2_dot_squared - S::from_f64(0.5) * w_68;
        let w_71 = mass_theta3_theta2 * theta2_dot_squared - w_70
            + minus_l_theta3_lambda_first_loop_y_turned * w_67 - l_theta3_theta5 * w_69;
        let w_72 = w_65 + minus_l_theta2_lambda_first_loop_y_turned * w_67
            - l_theta2_theta5 * w_69 - l_theta2_theta3 * w_71;
        let w_73 = inverse_theta2 * w_72;
        let w_75 = w_9 + w_74 - l_lambda_first_loop_x_turned_theta3 * w_71
            - l_lambda_first_loop_x_turned_theta2 * w_72
            + l_lambda_first_loop_x_turned_lambda_drive * w_73;
        let w_77 = w_34 + w_76 - l_lambda_second_loop_x_turned_theta3 * w_71
            - l_lambda_second_loop_x_turned_theta2 * w_72
            + l_lambda_second_loop_x_turned_lambda_drive * w_73
            - l_lambda_second_loop_x_turned_lambda_first_loop_x_turned * w_75;
        let w_79 = inverse_lambda_second_loop_y_turned
            * (w_28 - w_78 - self.l_lambda_second_loop_y_turned_theta5 * w_69
                - l_lambda_second_loop_y_turned_theta3 * w_71
                - l_lambda_second_loop_y_turned_theta2 * w_72
                + l_lambda_second_loop_y_turned_lambda_drive * w_73
                - l_lambda_second_loop_y_turned_lambda_first_loop_x_turned * w_75
                - l_lambda_second_loop_y_turned_lambda_second_loop_x_turned * w_77);
        let w_80 = inverse_lambda_second_loop_x_turned * w_77
            - l_lambda_second_loop_y_turned_lambda_second_loop_x_turned * w_79;
        let w_81 = inverse_lambda_first_loop_x_turned * w_75
            - l_lambda_second_loop_x_turned_lambda_first_loop_x_turned * w_80
            - l_lambda_second_loop_y_turned_lambda_first_loop_x_turned * w_79;
        let w_82 = minus_inverse_lambda_drive * w_73
            - l_lambda_first_loop_x_turned_lambda_drive * w_81
            - l_lambda_second_loop_x_turned_lambda_drive * w_80
            - l_lambda_second_loop_y_turned_lambda_drive * w_79;
        let w_83 = w_73 - inverse_theta2 * w_82
            - l_lambda_first_loop_x_turned_theta2 * w_81
            - l_lambda_second_loop_x_turned_theta2 * w_80
            - l_lambda_second_loop_y_turned_theta2 * w_79;
        let w_144 = inverse_theta3 * w_71 - l_theta2_theta3 * w_83
            - l_lambda_first_loop_x_turned_theta3 * w_81
            - l_lambda_second_loop_x_turned_theta3 * w_80
            - l_lambda_second_loop_y_turned_theta3 * w_79;
        let w_149 = minus_l_theta2_lambda_first_loop_y_turned * w_83
            - self.minus_inverse_lambda_first_loop_y_turned * w_67
            + minus_l_theta3_lambda_first_loop_y_turned * w_144;
        let w_84 = k_lambda_first_loop_x_turned_theta3 * theta3_ddot;
        let w_91 = k_lambda_first_loop_x_turned_theta3 * w_60;
        let w_85 = w_24 - w_84;
        let w_86 = w_2 * self.k_32;
        let w_89 = w_57 * w_86;
        let w_87 = theta3_ddot * w_86;
        let w_120 = S::from_f64(0.5) * (w_68 + w_87)
            - self.k_21 * (u5_x * w_48 + u5_y * w_43) + theta5_dot_squared * self.k_33
            + u5_y * self.k_22;
        let w_88 = mass_theta5_theta3 * theta3_dot_squared - S::from_f64(0.5) * w_87;
        let w_90 = k_theta3_lambda_first_loop_y_turned * w_52;
        let w_98 = k_theta3_lambda_first_loop_y_turned * theta3_ddot;
        let w_92 = w_29 * w_51;
        let w_100 = w_29 * theta3_ddot;
        let w_102 = k_lambda_second_loop_x_turned_theta3 * theta3_ddot;
        let w_93 = k_lambda_second_loop_x_turned_theta3 * w_50;
        let w_94 = w_70 + self.k_3 * (w_18 * (w_46 - w_47) + w_17 * (w_40 - w_41))
            - self.k_15 * (cos_w * w_48 + sin_w * w_43) + w_17 * self.k_16
            + sin_w * self.k_17 + w_89 + self.k_4 * theta3_dot_squared + w_90 - w_91
            + w_92 - w_93;
        let w_95 = w_94 + minus_l_theta3_lambda_first_loop_y_turned * w_85
            - l_theta3_theta5 * w_88;
        let w_96 = w_55 + self.k_2 * theta3_dot * (sin_theta2 * w_39 + cos_theta2 * w_45)
            + w_20 * theta3_dot_squared
            + minus_l_theta2_lambda_first_loop_y_turned * w_85 - l_theta2_theta5 * w_88
            - l_theta2_theta3 * w_95;
        let w_121 = w_93 - w_89 - w_92 + mass_theta5_theta3 * theta5_dot_squared
            - l_theta3_theta5 * w_120;
        let w_122 = w_64 - w_58 - w_63 + mass_theta5_theta2 * theta5_dot_squared
            - l_theta2_theta5 * w_120 - l_theta2_theta3 * w_121;
        let w_97 = inverse_theta2 * w_96;
        let w_99 = w_11 + w_98 - l_lambda_first_loop_x_turned_theta3 * w_95
            - l_lambda_first_loop_x_turned_theta2 * w_96
            + l_lambda_first_loop_x_turned_lambda_drive * w_97;
        let w_101 = w_35 + w_100 - l_lambda_second_loop_x_turned_theta3 * w_95
            - l_lambda_second_loop_x_turned_theta2 * w_96
            + l_lambda_second_loop_x_turned_lambda_drive * w_97
            - l_lambda_second_loop_x_turned_lambda_first_loop_x_turned * w_99;
        let w_103 = inverse_lambda_second_loop_y_turned
            * (w_30 - w_102 - self.l_lambda_second_loop_y_turned_theta5 * w_88
                - l_lambda_second_loop_y_turned_theta3 * w_95
                - l_lambda_second_loop_y_turned_theta2 * w_96
                + l_lambda_second_loop_y_turned_lambda_drive * w_97
                - l_lambda_second_loop_y_turned_lambda_first_loop_x_turned * w_99
                - l_lambda_second_loop_y_turned_lambda_second_loop_x_turned * w_101);
        let w_104 = inverse_lambda_second_loop_x_turned * w_101
            - l_lambda_second_loop_y_turned_lambda_second_loop_x_turned * w_103;
        let w_105 = inverse_lambda_first_loop_x_turned * w_99
            - l_lambda_second_loop_x_turned_lambda_first_loop_x_turned * w_104
            - l_lambda_second_loop_y_turned_lambda_first_loop_x_turned * w_103;
        let w_106 = minus_inverse_lambda_drive * w_97
            - l_lambda_first_loop_x_turned_lambda_drive * w_105
            - l_lambda_second_loop_x_turned_lambda_drive * w_104
            - l_lambda_second_loop_y_turned_lambda_drive * w_103;
        let w_107 = w_97 - inverse_theta2 * w_106
            - l_lambda_first_loop_x_turned_theta2 * w_105
            - l_lambda_second_loop_x_turned_theta2 * w_104
            - l_lambda_second_loop_y_turned_theta2 * w_103;
        let w_145 = inverse_theta3 * w_95 - l_theta2_theta3 * w_107
            - l_lambda_first_loop_x_turned_theta3 * w_105
            - l_lambda_second_loop_x_turned_theta3 * w_104
            - l_lambda_second_loop_y_turned_theta3 * w_103;
        let w_150 = minus_l_theta2_lambda_first_loop_y_turned * w_107
            - self.minus_inverse_lambda_first_loop_y_turned * w_85
            + minus_l_theta3_lambda_first_loop_y_turned * w_145;
        let w_108 = u4_y * self.k_20;
        let w_109 = w_66 - w_23 - w_24 + w_84
            + self.minus_l_lambda_first_loop_y_turned_theta4 * w_108;
        let w_110 = w_91 - w_90 + minus_l_theta3_lambda_first_loop_y_turned * w_109;
        let w_111 = w_61 - w_59 + minus_l_theta2_lambda_first_loop_y_turned * w_109
            - l_theta2_theta3 * w_110;
        let w_112 = inverse_theta2 * w_111;
        let w_113 = l_lambda_first_loop_x_turned_lambda_drive * w_112
            - (w_9 + w_11 + w_74 + w_98) - l_lambda_first_loop_x_turned_theta3 * w_110
            - l_lambda_first_loop_x_turned_theta2 * w_111;
        let w_114 = l_lambda_second_loop_x_turned_lambda_drive * w_112
            - l_lambda_second_loop_x_turned_theta3 * w_110
            - l_lambda_second_loop_x_turned_theta2 * w_111
            - l_lambda_second_loop_x_turned_lambda_first_loop_x_turned * w_113;
        let w_115 = inverse_lambda_second_loop_y_turned
            * (l_lambda_second_loop_y_turned_lambda_drive * w_112
                - l_lambda_second_loop_y_turned_theta3 * w_110
                - l_lambda_second_loop_y_turned_theta2 * w_111
                - l_lambda_second_loop_y_turned_lambda_first_loop_x_turned * w_113
                - l_lambda_second_loop_y_turned_lambda_second_loop_x_turned * w_114);
        let w_116 = inverse_lambda_second_loop_x_turned * w_114
            - l_lambda_second_loop_y_turned_lambda_second_loop_x_turned * w_115;
        let w_117 = inverse_lambda_first_loop_x_turned * w_113
            - l_lambda_second_loop_x_turned_lambda_first_loop_x_turned * w_116
            - l_lambda_second_loop_y_turned_lambda_first_loop_x_turned * w_115;
        let w_118 = minus_inverse_lambda_drive * w_112
            - l_lambda_first_loop_x_turned_lambda_drive * w_117
            - l_lambda_second_loop_x_turned_lambda_drive * w_116
            - l_lambda_second_loop_y_turned_lambda_drive * w_115;
        let w_119 = w_112 - inverse_theta2 * w_118
            - l_lambda_first_loop_x_turned_theta2 * w_117
            - l_lambda_second_loop_x_turned_theta2 * w_116
            - l_lambda_second_loop_y_turned_theta2 * w_115;
        let w_146 = inverse_theta3 * w_110 - l_theta2_theta3 * w_119
            - l_lambda_first_loop_x_turned_theta3 * w_117
            - l_lambda_second_loop_x_turned_theta3 * w_116
            - l_lambda_second_loop_y_turned_theta3 * w_115;
        let w_151 = minus_l_theta2_lambda_first_loop_y_turned * w_119
            - self.minus_inverse_lambda_first_loop_y_turned * w_109
            + minus_l_theta3_lambda_first_loop_y_turned * w_146;
        let w_123 = inverse_theta2 * w_122;
        let w_124 = l_lambda_first_loop_x_turned_lambda_drive * w_123
            - l_lambda_first_loop_x_turned_theta3 * w_121
            - l_lambda_first_loop_x_turned_theta2 * w_122;
        let w_125 = minus_k_lambda_second_loop_y_turned_theta6 * theta6_ddot;
        let w_126 = minus_k_lambda_second_loop_y_turned_theta6 * w_51;
        let w_130 = k_lambda_second_loop_x_turned_theta6 * theta6_ddot;
        let w_127 = k_lambda_second_loop_x_turned_theta6 * w_50;
        let w_128 = w_126 + w_127;
        let w_129 = w_125 - w_34 - w_35 - w_36 - w_76 - w_100
            - l_lambda_second_loop_x_turned_theta3 * w_121
            - l_lambda_second_loop_x_turned_theta2 * w_122
            + l_lambda_second_loop_x_turned_lambda_drive * w_123
            - l_lambda_second_loop_x_turned_theta6 * w_128
            - l_lambda_second_loop_x_turned_lambda_first_loop_x_turned * w_124;
        let w_131 = w_27 - w_28 - w_30 + w_78 + w_102 + w_130
            - self.l_lambda_second_loop_y_turned_theta5 * w_120
            - l_lambda_second_loop_y_turned_theta3 * w_121
            - l_lambda_second_loop_y_turned_theta2 * w_122
            + l_lambda_second_loop_y_turned_lambda_drive * w_123
            + minus_l_lambda_second_loop_y_turned_theta6 * w_128
            - l_lambda_second_loop_y_turned_lambda_first_loop_x_turned * w_124
            - l_lambda_second_loop_y_turned_lambda_second_loop_x_turned * w_129;
        let w_132 = inverse_lambda_second_loop_y_turned * w_131;
        let w_133 = inverse_lambda_second_loop_x_turned * w_129
            - l_lambda_second_loop_y_turned_lambda_second_loop_x_turned * w_132;
        let w_134 = inverse_lambda_first_loop_x_turned * w_124
            - l_lambda_second_loop_x_turned_lambda_first_loop_x_turned * w_133
            - l_lambda_second_loop_y_turned_lambda_first_loop_x_turned * w_132;
        let w_137 = u6_y * self.k_23 - w_126 - w_127;
        let w_138 = w_36 - w_125 - l_lambda_second_loop_x_turned_theta6 * w_137;
        let w_139 = inverse_lambda_second_loop_y_turned
            * (minus_l_lambda_second_loop_y_turned_theta6 * w_137 - (w_27 + w_130)
                - l_lambda_second_loop_y_turned_lambda_second_loop_x_turned * w_138);
        let w_140 = inverse_lambda_second_loop_x_turned * w_138
            - l_lambda_second_loop_y_turned_lambda_second_loop_x_turned * w_139;
        let w_135 = minus_inverse_lambda_drive * w_123
            - l_lambda_first_loop_x_turned_lambda_drive * w_134
            - l_lambda_second_loop_x_turned_lambda_drive * w_133
            - l_lambda_second_loop_y_turned_lambda_drive * w_132;
        let w_136 = w_123 - inverse_theta2 * w_135
            - l_lambda_first_loop_x_turned_theta2 * w_134
            - l_lambda_second_loop_x_turned_theta2 * w_133
            - l_lambda_second_loop_y_turned_theta2 * w_132;
        let w_147 = inverse_theta3 * w_121 - l_theta2_theta3 * w_136
            - l_lambda_first_loop_x_turned_theta3 * w_134
            - l_lambda_second_loop_x_turned_theta3 * w_133
            - l_lambda_second_loop_y_turned_theta3 * w_132;
        let w_141 = l_lambda_second_loop_x_turned_lambda_first_loop_x_turned * w_140
            + l_lambda_second_loop_y_turned_lambda_first_loop_x_turned * w_139;
        let w_142 = l_lambda_first_loop_x_turned_lambda_drive * w_141
            - l_lambda_second_loop_x_turned_lambda_drive * w_140
            - l_lambda_second_loop_y_turned_lambda_drive * w_139;
        let w_143 = l_lambda_first_loop_x_turned_theta2 * w_141 - inverse_theta2 * w_142
            - l_lambda_second_loop_x_turned_theta2 * w_140
            - l_lambda_second_loop_y_turned_theta2 * w_139;
        let w_148 = l_lambda_first_loop_x_turned_theta3 * w_141 - l_theta2_theta3 * w_143
            - l_lambda_second_loop_x_turned_theta3 * w_140
            - l_lambda_second_loop_y_turned_theta3 * w_139;
        let w_152 = minus_l_theta2_lambda_first_loop_y_turned * w_136
            + minus_l_theta3_lambda_first_loop_y_turned * w_147;
        let w_153 = minus_l_theta2_lambda_first_loop_y_turned * w_143
            + minus_l_theta3_lambda_first_loop_y_turned * w_148;
        let w_154 = theta2_dot * w_56;
        let w_155 = theta2_dot * self.k_9;
        let w_156 = w_7 * w_155;
        let w_158 = l_theta3_theta5 * w_154 - theta2_dot * (w_53 * self.k_34 + w_157)
            - minus_l_theta3_lambda_first_loop_y_turned * w_156;
        let w_159 = l_theta2_theta5 * w_154
            - minus_l_theta2_lambda_first_loop_y_turned * w_156
            - l_theta2_theta3 * w_158;
        let w_160 = inverse_theta2 * w_159;
        let w_161 = w_15 * w_155 - l_lambda_first_loop_x_turned_theta3 * w_158
            - l_lambda_first_loop_x_turned_theta2 * w_159
            + l_lambda_first_loop_x_turned_lambda_drive * w_160;
        let w_162 = w_16 * w_155 - l_lambda_second_loop_x_turned_theta3 * w_158
            - l_lambda_second_loop_x_turned_theta2 * w_159
            + l_lambda_second_loop_x_turned_lambda_drive * w_160
            - l_lambda_second_loop_x_turned_lambda_first_loop_x_turned * w_161;
        let w_163 = inverse_lambda_second_loop_y_turned
            * (self.l_lambda_second_loop_y_turned_theta5 * w_154 - w_12 * w_155
                - l_lambda_second_loop_y_turned_theta3 * w_158
                - l_lambda_second_loop_y_turned_theta2 * w_159
                + l_lambda_second_loop_y_turned_lambda_drive * w_160
                - l_lambda_second_loop_y_turned_lambda_first_loop_x_turned * w_161
                - l_lambda_second_loop_y_turned_lambda_second_loop_x_turned * w_162);
        let w_164 = inverse_lambda_second_loop_x_turned * w_162
            - l_lambda_second_loop_y_turned_lambda_second_loop_x_turned * w_163;
        let w_165 = inverse_lambda_first_loop_x_turned * w_161
            - l_lambda_second_loop_x_turned_lambda_first_loop_x_turned * w_164
            - l_lambda_second_loop_y_turned_lambda_first_loop_x_turned * w_163;
        let w_166 = minus_inverse_lambda_drive * w_160
            - l_lambda_first_loop_x_turned_lambda_drive * w_165
            - l_lambda_second_loop_x_turned_lambda_drive * w_164
            - l_lambda_second_loop_y_turned_lambda_drive * w_163;
        let w_167 = w_160 - inverse_theta2 * w_166
            - l_lambda_first_loop_x_turned_theta2 * w_165
            - l_lambda_second_loop_x_turned_theta2 * w_164
            - l_lambda_second_loop_y_turned_theta2 * w_163;
        let w_208 = inverse_theta3 * w_158 - l_theta2_theta3 * w_167
            - l_lambda_first_loop_x_turned_theta3 * w_165
            - l_lambda_second_loop_x_turned_theta3 * w_164
            - l_lambda_second_loop_y_turned_theta3 * w_163;
        let w_213 = self.minus_inverse_lambda_first_loop_y_turned * w_156
            + minus_l_theta2_lambda_first_loop_y_turned * w_167
            + minus_l_theta3_lambda_first_loop_y_turned * w_208;
        let w_168 = theta3_dot * w_17 * self.k_36;
        let w_169 = theta3_dot * w_18 * self.k_36;
        let w_170 = theta3_dot * self.k_37;
        let w_171 = w_10 * w_170;
        let w_172 = theta3_dot * w_86;
        let w_173 = self.k_3 * (w_18 * w_168 - w_17 * w_169)
            - minus_l_theta3_lambda_first_loop_y_turned * w_171
            + l_theta3_theta5 * w_172;
        let w_174 = self.k_2 * (cos_theta2 * w_168 - sin_theta2 * w_169)
            + theta3_dot * w_157 - minus_l_theta2_lambda_first_loop_y_turned * w_171
            + l_theta2_theta5 * w_172 - l_theta2_theta3 * w_173;
        let w_191 = theta5_dot * w_86;
        let w_192 = theta5_dot * w_56 - l_theta2_theta3 * w_191;
        let w_175 = inverse_theta2 * w_174;
        let w_176 = w_6 * w_170 - l_lambda_first_loop_x_turned_theta3 * w_173
            - l_lambda_first_loop_x_turned_theta2 * w_174
            + l_lambda_first_loop_x_turned_lambda_drive * w_175;
        let w_177 = theta3_dot * self.k_10;
        let w_178 = w_14 * w_177 - l_lambda_second_loop_x_turned_theta3 * w_173
            - l_lambda_second_loop_x_turned_theta2 * w_174
            + l_lambda_second_loop_x_turned_lambda_drive * w_175
            - l_lambda_second_loop_x_turned_lambda_first_loop_x_turned * w_176;
        let w_179 = inverse_lambda_second_loop_y_turned
            * (self.l_lambda_second_loop_y_turned_theta5 * w_172 - w_2 * w_177
                - l_lambda_second_loop_y_turned_theta3 * w_173
                - l_lambda_second_loop_y_turned_theta2 * w_174
                + l_lambda_second_loop_y_turned_lambda_drive * w_175
                - l_lambda_second_loop_y_turned_lambda_first_loop_x_turned * w_176
                - l_lambda_second_loop_y_turned_lambda_second_loop_x_turned * w_178);
        let w_180 = inverse_lambda_second_loop_x_turned * w_178
            - l_lambda_second_loop_y_turned_lambda_second_loop_x_turned * w_179;
        let w_181 = inverse_lambda_first_loop_x_turned * w_176
            - l_lambda_second_loop_x_turned_lambda_first_loop_x_turned * w_180
            - l_lambda_second_loop_y_turned_lambda_first_loop_x_turned * w_179;
        let w_182 = minus_inverse_lambda_drive * w_175
            - l_lambda_first_loop_x_turned_lambda_drive * w_181
            - l_lambda_second_loop_x_turned_lambda_drive * w_180
            - l_lambda_second_loop_y_turned_lambda_drive * w_179;
        let w_183 = w_175 - inverse_theta2 * w_182
            - l_lambda_first_loop_x_turned_theta2 * w_181
            - l_lambda_second_loop_x_turned_theta2 * w_180
            - l_lambda_second_loop_y_turned_theta2 * w_179;
        let w_209 = inverse_theta3 * w_173 - l_theta2_theta3 * w_183
            - l_lambda_first_loop_x_turned_theta3 * w_181
            - l_lambda_second_loop_x_turned_theta3 * w_180
            - l_lambda_second_loop_y_turned_theta3 * w_179;
        let w_214 = self.minus_inverse_lambda_first_loop_y_turned * w_171
            + minus_l_theta2_lambda_first_loop_y_turned * w_183
            + minus_l_theta3_lambda_first_loop_y_turned * w_209;
        let w_184 = theta4_dot * self.k_38;
        let w_185 = l_lambda_second_loop_x_turned_lambda_first_loop_x_turned * w_184;
        let w_186 = inverse_lambda_second_loop_y_turned
            * (l_lambda_second_loop_y_turned_lambda_first_loop_x_turned * w_184
                - l_lambda_second_loop_y_turned_lambda_second_loop_x_turned * w_185);
        let w_187 = inverse_lambda_second_loop_x_turned * w_185
            - l_lambda_second_loop_y_turned_lambda_second_loop_x_turned * w_186;
        let w_188 = inverse_lambda_first_loop_x_turned * w_184
            + l_lambda_second_loop_x_turned_lambda_first_loop_x_turned * w_187
            + l_lambda_second_loop_y_turned_lambda_first_loop_x_turned * w_186;
        let w_189 = l_lambda_first_loop_x_turned_lambda_drive * w_188
            - l_lambda_second_loop_x_turned_lambda_drive * w_187
            - l_lambda_second_loop_y_turned_lambda_drive * w_186;
        let w_190 = l_lambda_first_loop_x_turned_theta2 * w_188 - inverse_theta2 * w_189
            - l_lambda_second_loop_x_turned_theta2 * w_187
            - l_lambda_second_loop_y_turned_theta2 * w_186;
        let w_193 = inverse_theta2 * w_192;
        let w_194 = l_lambda_first_loop_x_turned_lambda_drive * w_193
            - l_lambda_first_loop_x_turned_theta3 * w_191
            - l_lambda_first_loop_x_turned_theta2 * w_192;
        let w_195 = theta5_dot * self.k_39 - l_lambda_second_loop_x_turned_theta3 * w_191
            - l_lambda_second_loop_x_turned_theta2 * w_192
            + l_lambda_second_loop_x_turned_lambda_drive * w_193
            - l_lambda_second_loop_x_turned_lambda_first_loop_x_turned * w_194;
        let w_196 = inverse_lambda_second_loop_y_turned
            * (l_lambda_second_loop_y_turned_lambda_drive * w_193
                - l_lambda_second_loop_y_turned_theta3 * w_191
                - l_lambda_second_loop_y_turned_theta2 * w_192
                - l_lambda_second_loop_y_turned_lambda_first_loop_x_turned * w_194
                - l_lambda_second_loop_y_turned_lambda_second_loop_x_turned * w_195);
        let w_197 = inverse_lambda_second_loop_x_turned * w_195
            - l_lambda_second_loop_y_turned_lambda_second_loop_x_turned * w_196;
        let w_198 = inverse_lambda_first_loop_x_turned * w_194
            - l_lambda_second_loop_x_turned_lambda_first_loop_x_turned * w_197
            - l_lambda_second_loop_y_turned_lambda_first_loop_x_turned * w_196;
        let w_199 = minus_inverse_lambda_drive * w_193
            - l_lambda_first_loop_x_turned_lambda_drive * w_198
            - l_lambda_second_loop_x_turned_lambda_drive * w_197
            - l_lambda_second_loop_y_turned_lambda_drive * w_196;
        let w_200 = w_193 - inverse_theta2 * w_199
            - l_lambda_first_loop_x_turned_theta2 * w_198
            - l_lambda_second_loop_x_turned_theta2 * w_197
            - l_lambda_second_loop_y_turned_theta2 * w_196;
        let w_211 = inverse_theta3 * w_191 - l_theta2_theta3 * w_200
            - l_lambda_first_loop_x_turned_theta3 * w_198
            - l_lambda_second_loop_x_turned_theta3 * w_197
            - l_lambda_second_loop_y_turned_theta3 * w_196;
        let w_201 = theta6_dot * self.k_40;
        let w_202 = w_26 * w_201;
        let w_203 = inverse_lambda_second_loop_y_turned
            * (l_lambda_second_loop_y_turned_lambda_second_loop_x_turned * w_202
                - w_32 * w_201);
        let w_204 = inverse_lambda_second_loop_x_turned * w_202
            + l_lambda_second_loop_y_turned_lambda_second_loop_x_turned * w_203;
        let w_205 = l_lambda_second_loop_x_turned_lambda_first_loop_x_turned * w_204
            - l_lambda_second_loop_y_turned_lambda_first_loop_x_turned * w_203;
        let w_206 = l_lambda_second_loop_x_turned_lambda_drive * w_204
            - l_lambda_first_loop_x_turned_lambda_drive * w_205
            - l_lambda_second_loop_y_turned_lambda_drive * w_203;
        let w_207 = l_lambda_second_loop_x_turned_theta2 * w_204 - inverse_theta2 * w_206
            - l_lambda_first_loop_x_turned_theta2 * w_205
            - l_lambda_second_loop_y_turned_theta2 * w_203;
        let w_210 = l_lambda_first_loop_x_turned_theta3 * w_188 - l_theta2_theta3 * w_190
            - l_lambda_second_loop_x_turned_theta3 * w_187
            - l_lambda_second_loop_y_turned_theta3 * w_186;
        let w_212 = l_lambda_second_loop_x_turned_theta3 * w_204
            - l_theta2_theta3 * w_207 - l_lambda_first_loop_x_turned_theta3 * w_205
            - l_lambda_second_loop_y_turned_theta3 * w_203;
        let w_215 = minus_l_theta2_lambda_first_loop_y_turned * w_190
            + minus_l_theta3_lambda_first_loop_y_turned * w_210;
        let w_216 = minus_l_theta2_lambda_first_loop_y_turned * w_200
            + minus_l_theta3_lambda_first_loop_y_turned * w_211;
        let w_217 = minus_l_theta2_lambda_first_loop_y_turned * w_207
            + minus_l_theta3_lambda_first_loop_y_turned * w_212;
        sim_kernel::DynamicsJacobian {
            accelerations_by_positions: [
                [w_83, w_107, w_119, w_136, w_143],
                [w_144, w_145, w_146, w_147, w_148],
                [
                    self.minus_l_lambda_first_loop_y_turned_theta4 * w_149,
                    self.minus_l_lambda_first_loop_y_turned_theta4 * w_150,
                    self.inverse_theta4 * w_108
                        + self.minus_l_lambda_first_loop_y_turned_theta4 * w_151,
                    self.minus_l_lambda_first_loop_y_turned_theta4 * w_152,
                    self.minus_l_lambda_first_loop_y_turned_theta4 * w_153,
                ],
                [
                    self.inverse_theta5 * w_69 - l_theta2_theta5 * w_83
                        - l_theta3_theta5 * w_144
                        - self.l_lambda_second_loop_y_turned_theta5 * w_79,
                    self.inverse_theta5 * w_88 - l_theta2_theta5 * w_107
                        - l_theta3_theta5 * w_145
                        - self.l_lambda_second_loop_y_turned_theta5 * w_103,
                    -(l_theta2_theta5 * w_119 + l_theta3_theta5 * w_146
                        + self.l_lambda_second_loop_y_turned_theta5 * w_115),
                    self.inverse_theta5 * w_120 - l_theta2_theta5 * w_136
                        - l_theta3_theta5 * w_147
                        - self.l_lambda_second_loop_y_turned_theta5 * w_132,
                    -(l_theta2_theta5 * w_143 + l_theta3_theta5 * w_148
                        + self.l_lambda_second_loop_y_turned_theta5 * w_139),
                ],
                [
                    minus_l_lambda_second_loop_y_turned_theta6 * w_79
                        - l_lambda_second_loop_x_turned_theta6 * w_80,
                    minus_l_lambda_second_loop_y_turned_theta6 * w_103
                        - l_lambda_second_loop_x_turned_theta6 * w_104,
                    minus_l_lambda_second_loop_y_turned_theta6 * w_115
                        - l_lambda_second_loop_x_turned_theta6 * w_116,
                    self.inverse_theta6 * w_128
                        - l_lambda_second_loop_x_turned_theta6 * w_133
                        + minus_l_lambda_second_loop_y_turned_theta6 * w_132,
                    self.inverse_theta6 * w_137
                        - l_lambda_second_loop_x_turned_theta6 * w_140
                        + minus_l_lambda_second_loop_y_turned_theta6 * w_139,
                ],
            ],
            accelerations_by_speeds: [
                [w_167, w_183, w_190, w_200, w_207],
                [w_208, w_209, w_210, w_211, w_212],
                [
                    self.minus_l_lambda_first_loop_y_turned_theta4 * w_213,
                    self.minus_l_lambda_first_loop_y_turned_theta4 * w_214,
                    self.minus_l_lambda_first_loop_y_turned_theta4 * w_215,
                    self.minus_l_lambda_first_loop_y_turned_theta4 * w_216,
                    self.minus_l_lambda_first_loop_y_turned_theta4 * w_217,
                ],
                [
                    -(self.inverse_theta5 * w_154 + l_theta2_theta5 * w_167
                        + l_theta3_theta5 * w_208
                        + self.l_lambda_second_loop_y_turned_theta5 * w_163),
                    -(self.inverse_theta5 * w_172 + l_theta2_theta5 * w_183
                        + l_theta3_theta5 * w_209
                        + self.l_lambda_second_loop_y_turned_theta5 * w_179),
                    -(l_theta2_theta5 * w_190 + l_theta3_theta5 * w_210
                        + self.l_lambda_second_loop_y_turned_theta5 * w_186),
                    -(l_theta2_theta5 * w_200 + l_theta3_theta5 * w_211
                        + self.l_lambda_second_loop_y_turned_theta5 * w_196),
                    -(l_theta2_theta5 * w_207 + l_theta3_theta5 * w_212
                        + self.l_lambda_second_loop_y_turned_theta5 * w_203),
                ],
                [
                    minus_l_lambda_second_loop_y_turned_theta6 * w_163
                        - l_lambda_second_loop_x_turned_theta6 * w_164,
                    minus_l_lambda_second_loop_y_turned_theta6 * w_179
                        - l_lambda_second_loop_x_turned_theta6 * w_180,
                    minus_l_lambda_second_loop_y_turned_theta6 * w_186
                        - l_lambda_second_loop_x_turned_theta6 * w_187,
                    minus_l_lambda_second_loop_y_turned_theta6 * w_196
                        - l_lambda_second_loop_x_turned_theta6 * w_197,
                    l_lambda_second_loop_x_turned_theta6 * w_204
                        + minus_l_lambda_second_loop_y_turned_theta6 * w_203,
                ],
            ],
            multipliers_by_positions: [
                [w_82, w_106, w_118, w_135, w_142],
                [
                    u4_x * w_81 - u4_y * w_149,
                    u4_x * w_105 - u4_y * w_150,
                    u4_x * w_117 - u4_y * w_151 - (u4_y * w_52 + u4_x * w_60),
                    u4_x * w_134 - u4_y * w_152,
                    -(u4_x * w_141 + u4_y * w_153),
                ],
                [
                    u4_y * w_81 + u4_x * w_149,
                    u4_y * w_105 + u4_x * w_150,
                    u4_y * w_117 + u4_x * w_151 + (u4_x * w_52 - u4_y * w_60),
                    u4_y * w_134 + u4_x * w_152,
                    u4_x * w_153 - u4_y * w_141,
                ],
                [
                    u5_x * w_80 - u5_y * w_79,
                    u5_x * w_104 - u5_y * w_103,
                    u5_x * w_116 - u5_y * w_115,
                    u5_x * w_133 - u5_y * w_132 - (u5_y * w_51 + u5_x * w_50),
                    u5_x * w_140 - u5_y * w_139,
                ],
                [
                    u5_y * w_80 + u5_x * w_79,
                    u5_y * w_104 + u5_x * w_103,
                    u5_y * w_116 + u5_x * w_115,
                    u5_y * w_133 + u5_x * w_132 + (u5_x * w_51 - u5_y * w_50),
                    u5_y * w_140 + u5_x * w_139,
                ],
            ],
            multipliers_by_speeds: [
                [w_166, w_182, w_189, w_199, w_206],
                [
                    u4_x * w_165 - u4_y * w_213,
                    u4_x * w_181 - u4_y * w_214,
                    -(u4_x * w_188 + u4_y * w_215),
                    u4_x * w_198 - u4_y * w_216,
                    u4_x * w_205 - u4_y * w_217,
                ],
                [
                    u4_y * w_165 + u4_x * w_213,
                    u4_y * w_181 + u4_x * w_214,
                    u4_x * w_215 - u4_y * w_188,
                    u4_y * w_198 + u4_x * w_216,
                    u4_y * w_205 + u4_x * w_217,
                ],
                [
                    u5_x * w_164 - u5_y * w_163,
                    u5_x * w_180 - u5_y * w_179,
                    u5_x * w_187 - u5_y * w_186,
                    u5_x * w_197 - u5_y * w_196,
                    -(u5_x * w_204 + u5_y * w_203),
                ],
                [
                    u5_y * w_164 + u5_x * w_163,
                    u5_y * w_180 + u5_x * w_179,
                    u5_y * w_187 + u5_x * w_186,
                    u5_y * w_197 + u5_x * w_196,
                    u5_x * w_203 - u5_y * w_204,
                ],
            ],
            refused: sim_kernel::pivot_is_refused(
                self.mass_theta4_theta4,
                self.mass_theta4_theta4,
            )
                | sim_kernel::pivot_is_refused(
                    self.pivot_lambda_first_loop_y_turned,
                    self.minus_pivot_lambda_first_loop_y_turned,
                )
                | sim_kernel::pivot_is_refused(
                    self.mass_theta5_theta5,
                    self.mass_theta5_theta5,
                ) | sim_kernel::pivot_is_refused(pivot_theta3, mass_theta3_theta3 + w_19)
                | sim_kernel::pivot_is_refused(
                    pivot_theta2,
                    self.mass_theta2_theta2 + w_21,
                ) | sim_kernel::pivot_is_refused(-inverse_theta2, inverse_theta2)
                | sim_kernel::pivot_is_refused(
                    self.mass_theta6_theta6,
                    self.mass_theta6_theta6,
                ) | sim_kernel::pivot_is_refused(pivot_lambda_first_loop_x_turned, w_33)
                | sim_kernel::pivot_is_refused(pivot_lambda_second_loop_x_turned, w_37)
                | sim_kernel::pivot_is_refused(pivot_lambda_second_loop_y_turned, w_49),
        }
    }
}
#[allow(non_snake_case, clippy::all, clippy::pedantic)]
impl<S: sim_kernel::Scalar> sim_kernel::Mechanism<S> for SixBar<S> {
    type Q = [S; 5];
    type L = [S; 5];
    type Z = [S; 10];
    type QQ = [[S; 5]; 5];
    type LQ = [[S; 5]; 5];
    type LL = [[S; 5]; 5];
    type ZZ = [[S; 10]; 10];
    type Entries = [S; 0];
    type Envelope = [S; 0];
    type Parameters = [S; 18];
    type Outputs = [S; 7];
    type OutputRates = [S; 4];
    type Events = [S; 2];
    type EventValues = [S; 0];
    type Activities = [S; 0];
    type Drawing = [S; 36];
    type QP = [[S; 18]; 5];
    type LP = [[S; 18]; 5];
    type Inputs = [sim_kernel::Input<S>; 0];
    type Prepared = SixBarPrepared<S>;
    type On<T: sim_kernel::Scalar> = SixBar<T>;
    const DESCRIPTION: sim_kernel::Description = sim_kernel::Description {
        name: "six-bar",
        type_name: "SixBar",
        docs: "Stephenson's six-bar, third kind: a point of the coupler of a crank-rocker drives a second rocker by a link. The\ncrank turns evenly.",
        declaration: "/// Stephenson's six-bar, third kind: a point of the coupler of a crank-rocker drives a second rocker by a link. The\n/// crank turns evenly.\npub SixBar;\n\ncoordinates {\n    /// Angle of crank 2.\n    theta2 [rad];\n    /// Angle of coupler 3.\n    theta3 [rad];\n    /// Angle of rocker 4.\n    theta4 [rad];\n    /// Angle of link 5.\n    theta5 [rad];\n    /// Angle of rocker 6.\n    theta6 [rad];\n}\n\nparameters {\n    /// Length of crank 2.\n    a [m] = 0.1;\n    /// Length of coupler 3, from crank to rocker.\n    b [m] = 0.3;\n    /// Length of rocker 4.\n    c [m] = 0.25;\n    /// Distance of the pivots of crank 2 and rocker 4.\n    d [m] = 0.3;\n    /// Distance of the coupler point from the crank's pin.\n    p [m] = 0.2;\n    /// Angle of the coupler point above the coupler.\n    delta [deg] = 30;\n    /// Length of link 5.\n    f [m] = 0.3;\n    /// Length of rocker 6.\n    h [m] = 0.25;\n    /// Pivot of rocker 6.\n    O6x [m] = 0.45;\n    /// Pivot of rocker 6.\n    O6y [m] = 0.3;\n    /// Speed of the crank.\n    w [rpm] = 60;\n    /// Inertia of the crank about its pivot.\n    J2 [kg*m^2] = 0.01;\n    /// Mass of the coupler, at its centre of mass.\n    m3 [kg] = 1.5;\n    /// Inertia of the coupler about its centre of mass.\n    J3 [kg*m^2] = 0.015;\n    /// Mass of rocker 4, slender.\n    m4 [kg] = 1;\n    /// Mass of link 5, slender.\n    m5 [kg] = 1;\n    /// Mass of rocker 6, slender.\n    m6 [kg] = 2;\n    g [m/s^2] = 9.81;\n}\n\nlet O2 = [0, 0];\nlet O4 = [d, 0];\nlet O6 = [O6x, O6y];\nlet u3 = [cos(theta3), sin(theta3)];\nlet u4 = [cos(theta4), sin(theta4)];\nlet u5 = [cos(theta5), sin(theta5)];\nlet u6 = [cos(theta6), sin(theta6)];\nlet A = a*[cos(theta2), sin(theta2)];\nlet B = A + b*u3;\nlet P = A + p*[cos(theta3 + delta), sin(theta3 + delta)];\nlet D = P + f*u5;\n\nbodies {\n    crank2: inertia J2, angle theta2;\n    coupler3: mass m3 at (A + B + P)/3, inertia J3, angle theta3;\n    rocker4: mass m4 at O4 + c/2*u4, inertia m4*c^2/12, angle theta4;\n    link5: mass m5 at P + f/2*u5, inertia m5*f^2/12, angle theta5;\n    rocker6: mass m6 at O6 + h/2*u6, inertia m6*h^2/12, angle theta6;\n}\n\nloads { gravity [0, -g]; }\n\nconstraints {\n    drive: theta2 = w*t;\n    first_loop: B = O4 + c*u4;\n    second_loop: D = O6 + h*u6;\n}\n\ninitial {\n    guess theta2 = 0;\n    guess theta3 = 0.9;\n    guess theta4 = 1.7;\n    guess theta5 = 1;\n    guess theta6 = 2.4;\n}\n\nevents {\n    period: theta2 = 2*pi;\n    /// Rocker 6 turns back.\n    turn: dot(theta6) = 0;\n}\n\noutputs {\n    rockers \"Angles of the rockers\" {\n        /// rocker 4\n        rocker4_angle [deg] = theta4;\n        /// rocker 6\n        rocker6_angle [deg] = theta6;\n    }\n    rocker_speeds \"Angular speeds of the rockers\" {\n        /// rocker 4\n        rocker4_speed [rad/s] = dot(theta4);\n        /// rocker 6\n        rocker6_speed [rad/s] = dot(theta6);\n    }\n    torque \"Torque on the crank\" {\n        /// torque\n        T [N*m] = -reaction(drive);\n    }\n    pin_D \"Force of link 5 on rocker 6\" {\n        /// along x\n        Dx [N] = reaction(second_loop).x;\n        /// along y\n        Dy [N] = reaction(second_loop).y;\n    }\n}\n\ndrawing {\n    ground O2, O4, O6;\n    line O2, A;\n    line A, B, P, A;\n    line O4, B;\n    line P, D, O6;\n    point A, B, P, D;\n}\n",
        coordinates: &[
            sim_kernel::Coordinate {
                position: sim_kernel::Quantity {
                    name: "theta2",
                    unit: "rad",
                    factor: 1f64,
                    is_length: false,
                    docs: "Angle of crank 2.",
                },
                speed: sim_kernel::Quantity {
                    name: "theta2_dot",
                    unit: "rad/s",
                    factor: 1f64,
                    is_length: false,
                    docs: "",
                },
                acceleration: sim_kernel::Quantity {
                    name: "theta2_ddot",
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
                    name: "theta3",
                    unit: "rad",
                    factor: 1f64,
                    is_length: false,
                    docs: "Angle of coupler 3.",
                },
                speed: sim_kernel::Quantity {
                    name: "theta3_dot",
                    unit: "rad/s",
                    factor: 1f64,
                    is_length: false,
                    docs: "",
                },
                acceleration: sim_kernel::Quantity {
                    name: "theta3_ddot",
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
                    name: "theta4",
                    unit: "rad",
                    factor: 1f64,
                    is_length: false,
                    docs: "Angle of rocker 4.",
                },
                speed: sim_kernel::Quantity {
                    name: "theta4_dot",
                    unit: "rad/s",
                    factor: 1f64,
                    is_length: false,
                    docs: "",
                },
                acceleration: sim_kernel::Quantity {
                    name: "theta4_ddot",
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
                    name: "theta5",
                    unit: "rad",
                    factor: 1f64,
                    is_length: false,
                    docs: "Angle of link 5.",
                },
                speed: sim_kernel::Quantity {
                    name: "theta5_dot",
                    unit: "rad/s",
                    factor: 1f64,
                    is_length: false,
                    docs: "",
                },
                acceleration: sim_kernel::Quantity {
                    name: "theta5_ddot",
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
                    name: "theta6",
                    unit: "rad",
                    factor: 1f64,
                    is_length: false,
                    docs: "Angle of rocker 6.",
                },
                speed: sim_kernel::Quantity {
                    name: "theta6_dot",
                    unit: "rad/s",
                    factor: 1f64,
                    is_length: false,
                    docs: "",
                },
                acceleration: sim_kernel::Quantity {
                    name: "theta6_ddot",
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
                docs: "Length of crank 2.",
            },
            sim_kernel::Quantity {
                name: "b",
                unit: "m",
                factor: 1f64,
                is_length: true,
                docs: "Length of coupler 3, from crank to rocker.",
            },
            sim_kernel::Quantity {
                name: "c",
                unit: "m",
                factor: 1f64,
                is_length: true,
                docs: "Length of rocker 4.",
            },
            sim_kernel::Quantity {
                name: "d",
                unit: "m",
                factor: 1f64,
                is_length: true,
                docs: "Distance of the pivots of crank 2 and rocker 4.",
            },
            sim_kernel::Quantity {
                name: "p",
                unit: "m",
                factor: 1f64,
                is_length: true,
                docs: "Distance of the coupler point from the crank's pin.",
            },
            sim_kernel::Quantity {
                name: "delta",
                unit: "deg",
                factor: 0.017453292519943295f64,
                is_length: false,
                docs: "Angle of the coupler point above the coupler.",
            },
            sim_kernel::Quantity {
                name: "f",
                unit: "m",
                factor: 1f64,
                is_length: true,
                docs: "Length of link 5.",
            },
            sim_kernel::Quantity {
                name: "h",
                unit: "m",
                factor: 1f64,
                is_length: true,
                docs: "Length of rocker 6.",
            },
            sim_kernel::Quantity {
                name: "O6x",
                unit: "m",
                factor: 1f64,
                is_length: true,
                docs: "Pivot of rocker 6.",
            },
            sim_kernel::Quantity {
                name: "O6y",
                unit: "m",
                factor: 1f64,
                is_length: true,
                docs: "Pivot of rocker 6.",
            },
            sim_kernel::Quantity {
                name: "w",
                unit: "rpm",
                factor: 0.10471975511965977f64,
                is_length: false,
                docs: "Speed of the crank.",
            },
            sim_kernel::Quantity {
                name: "J2",
                unit: "kg*m^2",
                factor: 1f64,
                is_length: false,
                docs: "Inertia of the crank about its pivot.",
            },
            sim_kernel::Quantity {
                name: "m3",
                unit: "kg",
                factor: 1f64,
                is_length: false,
                docs: "Mass of the coupler, at its centre of mass.",
            },
            sim_kernel::Quantity {
                name: "J3",
                unit: "kg*m^2",
                factor: 1f64,
                is_length: false,
                docs: "Inertia of the coupler about its centre of mass.",
            },
            sim_kernel::Quantity {
                name: "m4",
                unit: "kg",
                factor: 1f64,
                is_length: false,
                docs: "Mass of rocker 4, slender.",
            },
            sim_kernel::Quantity {
                name: "m5",
                unit: "kg",
                factor: 1f64,
                is_length: false,
                docs: "Mass of link 5, slender.",
            },
            sim_kernel::Quantity {
                name: "m6",
                unit: "kg",
                factor: 1f64,
                is_length: false,
                docs: "Mass of rocker 6, slender.",
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
                name: "drive",
                unit: "N*m",
                factor: 1f64,
                is_length: false,
                docs: "",
            },
            sim_kernel::Quantity {
                name: "first_loop_x",
                unit: "N",
                factor: 1f64,
                is_length: false,
                docs: "",
            },
            sim_kernel::Quantity {
                name: "first_loop_y",
                unit: "N",
                factor: 1f64,
                is_length: false,
                docs: "",
            },
            sim_kernel::Quantity {
                name: "second_loop_x",
                unit: "N",
                factor: 1f64,
                is_length: false,
                docs: "",
            },
            sim_kernel::Quantity {
                name: "second_loop_y",
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
            sim_kernel::event::Event {
                name: "turn",
                direction: sim_kernel::event::Direction::Both,
                on_forces: false,
                steps: &[],
            },
        ],
        outputs: &[
            sim_kernel::Quantity {
                name: "rocker4_angle",
                unit: "deg",
                factor: 0.017453292519943295f64,
                is_length: false,
                docs: "rocker 4",
            },
            sim_kernel::Quantity {
                name: "rocker6_angle",
                unit: "deg",
                factor: 0.017453292519943295f64,
                is_length: false,
                docs: "rocker 6",
            },
            sim_kernel::Quantity {
                name: "rocker4_speed",
                unit: "rad/s",
                factor: 1f64,
                is_length: false,
                docs: "rocker 4",
            },
            sim_kernel::Quantity {
                name: "rocker6_speed",
                unit: "rad/s",
                factor: 1f64,
                is_length: false,
                docs: "rocker 6",
            },
            sim_kernel::Quantity {
                name: "T",
                unit: "N*m",
                factor: 1f64,
                is_length: false,
                docs: "torque",
            },
            sim_kernel::Quantity {
                name: "Dx",
                unit: "N",
                factor: 1f64,
                is_length: false,
                docs: "along x",
            },
            sim_kernel::Quantity {
                name: "Dy",
                unit: "N",
                factor: 1f64,
                is_length: false,
                docs: "along y",
            },
        ],
        rated_outputs: &[0, 1, 2, 3],
        figures: &[
            sim_kernel::Figure {
                name: "rockers",
                title: "Angles of the rockers",
                len: 2,
            },
            sim_kernel::Figure {
                name: "rocker_speeds",
                title: "Angular speeds of the rockers",
                len: 2,
            },
            sim_kernel::Figure {
                name: "torque",
                title: "Torque on the crank",
                len: 1,
            },
            sim_kernel::Figure {
                name: "pin_D",
                title: "Force of link 5 on rocker 6",
                len: 2,
            },
        ],
        optional_kernels: &["dynamics_jacobian"],
        dimension: 2,
        drawing: &[
            sim_kernel::Shape::Ground(3),
            sim_kernel::Shape::Line(2),
            sim_kernel::Shape::Line(4),
            sim_kernel::Shape::Line(2),
            sim_kernel::Shape::Line(3),
            sim_kernel::Shape::Points(4),
        ],
    };
    fn defaults() -> Self {
        Self {
            a: S::from_f64(0.1f64),
            b: S::from_f64(0.3f64),
            c: S::from_f64(0.25f64),
            d: S::from_f64(0.3f64),
            p: S::from_f64(0.2f64),
            delta: S::from_f64(0.5235987755982988f64),
            f: S::from_f64(0.3f64),
            h: S::from_f64(0.25f64),
            O6x: S::from_f64(0.45f64),
            O6y: S::from_f64(0.3f64),
            w: S::from_f64(6.283185307179586f64),
            J2: S::from_f64(0.01f64),
            m3: S::from_f64(1.5f64),
            J3: S::from_f64(0.015f64),
            m4: S::from_f64(1f64),
            m5: S::from_f64(1f64),
            m6: S::from_f64(2f64),
            g: S::from_f64(9.81f64),
        }
    }
    fn parameters(&self) -> [S; 18] {
        [
            self.a,
            self.b,
            self.c,
            self.d,
            self.p,
            self.delta,
            self.f,
            self.h,
            self.O6x,
            self.O6y,
            self.w,
            self.J2,
            self.m3,
            self.J3,
            self.m4,
            self.m5,
            self.m6,
            self.g,
        ]
    }
    fn with_parameters(&self, parameters: [S; 18]) -> Self {
        Self {
            a: parameters[0],
            b: parameters[1],
            c: parameters[2],
            d: parameters[3],
            p: parameters[4],
            delta: parameters[5],
            f: parameters[6],
            h: parameters[7],
            O6x: parameters[8],
            O6y: parameters[9],
            w: parameters[10],
            J2: parameters[11],
            m3: parameters[12],
            J3: parameters[13],
            m4: parameters[14],
            m5: parameters[15],
            m6: parameters[16],
            g: parameters[17],
            ..*self
        }
    }
    fn on<T: sim_kernel::Scalar>(
        &self,
        convert: impl ::core::ops::Fn(S) -> T,
    ) -> SixBar<T> {
        SixBar {
            a: convert(self.a),
            b: convert(self.b),
            c: convert(self.c),
            d: convert(self.d),
            p: convert(self.p),
            delta: convert(self.delta),
            f: convert(self.f),
            h: convert(self.h),
            O6x: convert(self.O6x),
            O6y: convert(self.O6y),
            w: convert(self.w),
            J2: convert(self.J2),
            m3: convert(self.m3),
            J3: convert(self.J3),
            m4: convert(self.m4),
            m5: convert(self.m5),
            m6: convert(self.m6),
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
    fn prepare(&self) -> SixBarPrepared<S> {
        self.prepare()
    }
    #[inline(always)]
    fn prepared_dynamics(
        prepared: &Self::Prepared,
        t: S,
        q: &[S; 5],
        qd: &[S; 5],
    ) -> sim_kernel::Dynamics<S, [S; 5], [S; 5]> {
        prepared.dynamics(t, q, qd)
    }
    #[inline(always)]
    fn dynamics_jacobian(
        &self,
        t: S,
        q: &[S; 5],
        qd: &[S; 5],
    ) -> sim_kernel::DynamicsJacobian<S, [[S; 5]; 5], [[S; 5]; 5]> {
        self.prepare().dynamics_jacobian(t, q, qd)
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
    fn constraints(&self, t: S, q: &[S; 5]) -> [S; 5] {
        self.constraints(t, q)
    }
    #[inline(always)]
    fn constraint_magnitudes(&self, t: S, q: &[S; 5]) -> [S; 5] {
        self.constraint_magnitudes(t, q)
    }
    #[inline(always)]
    fn constraint_jacobian(&self, t: S, q: &[S; 5]) -> [[S; 5]; 5] {
        self.constraint_jacobian(t, q)
    }
    #[inline(always)]
    fn constraint_time_derivative(&self, t: S, q: &[S; 5]) -> [S; 5] {
        self.constraint_time_derivative(t, q)
    }
    #[inline(always)]
    fn constraint_convective(&self, t: S, q: &[S; 5], qd: &[S; 5]) -> [S; 5] {
        self.constraint_convective(t, q, qd)
    }
    #[inline(always)]
    fn constraint_linearization(
        &self,
        t: S,
        q: &[S; 5],
    ) -> sim_kernel::ConstraintLinearization<[S; 5], [[S; 5]; 5]> {
        self.constraint_linearization(t, q)
    }
    #[inline(always)]
    fn kinetic_energy(&self, t: S, q: &[S; 5], qd: &[S; 5]) -> S {
        self.kinetic_energy(t, q, qd)
    }
    #[inline(always)]
    fn power(&self, t: S, q: &[S; 5], qd: &[S; 5], qdd: &[S; 5], lambda: &[S; 5]) -> S {
        self.power(t, q, qd, qdd, lambda)
    }
    #[inline(always)]
    fn outputs(
        &self,
        t: S,
        q: &[S; 5],
        qd: &[S; 5],
        qdd: &[S; 5],
        lambda: &[S; 5],
    ) -> [S; 7] {
        self.outputs(t, q, qd, qdd, lambda).into()
    }
    #[inline(always)]
    fn output_rates(&self, t: S, q: &[S; 5], qd: &[S; 5], qdd: &[S; 5]) -> [S; 4] {
        self.output_rates(t, q, qd, qdd).into()
    }
    #[inline(always)]
    fn events(
        &self,
        t: S,
        q: &[S; 5],
        qd: &[S; 5],
        qdd: &[S; 5],
        lambda: &[S; 5],
    ) -> [S; 2] {
        self.events(t, q, qd, qdd, lambda)
    }
    #[inline(always)]
    fn drawing(&self, t: S, q: &[S; 5]) -> [S; 36] {
        self.drawing(t, q)
    }
    #[inline(always)]
    fn initial(&self) -> sim_kernel::Initial<[S; 5]> {
        self.initial()
    }
}
