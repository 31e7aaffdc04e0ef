/// Four-bar linkage: crank 2 turns, coupler 3 swings rocker 4. Three uniform slender rods under gravity, let go
/// with the crank along the ground link at 10 rad/s.
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
/// coordinates = [theta2; theta3; theta4]
/// multipliers = [lambda_closure_x; lambda_closure_y]
/// constraints = 0
/// [
///     mass_matrix[1, 1], mass_matrix[1, 2], 0, -a*u2_y, A_x;
///     mass_matrix[1, 2], b^2*m3/3, 0, -b*u3_y, b*u3_x;
///     0, 0, c^2*m4/3, B_y, -c*u4_x;
///     -a*u2_y, -b*u3_y, B_y, 0, 0;
///     A_x, b*u3_x, -c*u4_x, 0, 0
/// ] * [
///     theta2_ddot;
///     theta3_ddot;
///     theta4_ddot;
///     lambda_closure_x;
///     lambda_closure_y
/// ] = [
///     generalized_forces[1] - convective_forces[1];
///     -b*m3*g*u3_x/2 - convective_forces[2];
///     -c*m4*g*u4_x/2;
///     -constraint_convective[1];
///     -constraint_convective[2]
/// ]
///
/// mass_matrix = [
///     mass_matrix[1, 1], mass_matrix[1, 2], 0;
///     mass_matrix[1, 2], b^2*m3/3, 0;
///     0, 0, c^2*m4/3
/// ]
/// mass_matrix[1, 1] = a^2*m2/3 + a^2*m3
/// mass_matrix[1, 2] = a*b*m3*u2_y*u3_y/2 + a*b*m3*u2_x*u3_x/2
///
/// convective_forces = [convective_forces[1]; convective_forces[2]; 0]
/// convective_forces[1] = a*m3*u2_y*s_1/2 - a*m3*u2_x*s_2/2
/// convective_forces[2] = b*m3*u3_y*s_1/4 - b*m3*u3_x*s_2/4
///
/// generalized_forces = [
///     generalized_forces[1];
///     -b*m3*g*u3_x/2;
///     -c*m4*g*u4_x/2
/// ]
/// generalized_forces[1] = T - a*m2*g*u2_x/2 - a*m3*g*u2_x
///
/// constraints = [A_x - d - c*u4_x + b*u3_x; A_y - B_y + b*u3_y]
///
/// constraint_jacobian = [-a*u2_y, -b*u3_y, B_y; A_x, b*u3_x, -c*u4_x]
///
/// constraint_convective = [
///     constraint_convective[1];
///     constraint_convective[2]
/// ]
/// constraint_convective[1] = c*u4_x*theta4_dot^2 - a*u2_x*theta2_dot^2 - b*u3_x*theta3_dot^2
/// constraint_convective[2] = c*u4_y*theta4_dot^2 - a*u2_y*theta2_dot^2 - b*u3_y*theta3_dot^2
///
/// u2_x = cos(theta2)
/// u2_y = sin(theta2)
/// u3_x = cos(theta3)
/// u3_y = sin(theta3)
/// u4_x = cos(theta4)
/// u4_y = sin(theta4)
/// A_x = a*u2_x
/// A_y = a*u2_y
/// B_y = c*u4_y
/// s_1 = 2*a*u2_x*theta2_dot^2 + b*u3_x*theta3_dot^2
/// s_2 = 2*a*u2_y*theta2_dot^2 + b*u3_y*theta3_dot^2
/// ```
#[allow(non_snake_case)]
#[derive(
    ::core::clone::Clone,
    ::core::marker::Copy,
    ::core::fmt::Debug,
    ::core::cmp::PartialEq
)]
pub struct FourBar<S = ::core::primitive::f64> {
    /// Length of crank 2, in `m`.
    pub a: S,
    /// Length of coupler 3, in `m`.
    pub b: S,
    /// Length of rocker 4, in `m`.
    pub c: S,
    /// Distance of the fixed pivots, in `m`.
    pub d: S,
    /// Mass of crank 2, in `kg`.
    pub m2: S,
    /// Mass of coupler 3, in `kg`.
    pub m3: S,
    /// Mass of rocker 4, in `kg`.
    pub m4: S,
    /// In `m/s^2`.
    pub g: S,
    /// Torque on crank 2, in `N*m`.
    pub T: S,
}
impl<S: sim_kernel::Scalar> ::core::default::Default for FourBar<S> {
    /// The declared values.
    fn default() -> Self {
        <Self as sim_kernel::Mechanism<S>>::defaults()
    }
}
/// Coordinates of [`FourBar`] by name, in SI units; also for their speeds and accelerations.
#[allow(non_snake_case)]
#[derive(
    ::core::clone::Clone,
    ::core::marker::Copy,
    ::core::fmt::Debug,
    ::core::cmp::PartialEq
)]
pub struct FourBarCoordinates<S = ::core::primitive::f64> {
    /// Angle of crank 2, in `rad`.
    pub theta2: S,
    /// Angle of coupler 3, in `rad`.
    pub theta3: S,
    /// Angle of rocker 4, in `rad`.
    pub theta4: S,
}
impl<S: sim_kernel::Scalar> ::core::convert::From<[S; 3]> for FourBarCoordinates<S> {
    fn from(values: [S; 3]) -> Self {
        Self {
            theta2: values[0],
            theta3: values[1],
            theta4: values[2],
        }
    }
}
impl<S: sim_kernel::Scalar> ::core::convert::From<FourBarCoordinates<S>> for [S; 3] {
    fn from(record: FourBarCoordinates<S>) -> Self {
        [record.theta2, record.theta3, record.theta4]
    }
}
/// Outputs of [`FourBar`] by name, in SI units.
#[allow(non_snake_case)]
#[derive(
    ::core::clone::Clone,
    ::core::marker::Copy,
    ::core::fmt::Debug,
    ::core::cmp::PartialEq
)]
pub struct FourBarOutputs<S = ::core::primitive::f64> {
    /// crank 2, in `rad/s`.
    pub crank_speed: S,
    /// coupler 3, in `rad/s`.
    pub coupler_speed: S,
    /// rocker 4, in `rad/s`.
    pub rocker_speed: S,
    /// angle, in `1`.
    pub rocker: S,
    /// along x, in `N`.
    pub Bx: S,
    /// along y, in `N`.
    pub By: S,
    /// along x, in `N`.
    pub Ax: S,
    /// along y, in `N`.
    pub Ay: S,
    /// along x, in `N`.
    pub O2x: S,
    /// along y, in `N`.
    pub O2y: S,
    /// along x, in `N`.
    pub O4x: S,
    /// along y, in `N`.
    pub O4y: S,
}
impl<S: sim_kernel::Scalar> ::core::convert::From<[S; 12]> for FourBarOutputs<S> {
    fn from(values: [S; 12]) -> Self {
        Self {
            crank_speed: values[0],
            coupler_speed: values[1],
            rocker_speed: values[2],
            rocker: values[3],
            Bx: values[4],
            By: values[5],
            Ax: values[6],
            Ay: values[7],
            O2x: values[8],
            O2y: values[9],
            O4x: values[10],
            O4y: values[11],
        }
    }
}
impl<S: sim_kernel::Scalar> ::core::convert::From<FourBarOutputs<S>> for [S; 12] {
    fn from(record: FourBarOutputs<S>) -> Self {
        [
            record.crank_speed,
            record.coupler_speed,
            record.rocker_speed,
            record.rocker,
            record.Bx,
            record.By,
            record.Ax,
            record.Ay,
            record.O2x,
            record.O2y,
            record.O4x,
            record.O4y,
        ]
    }
}
/// Rates of the outputs of [`FourBar`] by name, in SI units.
#[allow(non_snake_case)]
#[derive(
    ::core::clone::Clone,
    ::core::marker::Copy,
    ::core::fmt::Debug,
    ::core::cmp::PartialEq
)]
pub struct FourBarOutputRates<S = ::core::primitive::f64> {
    /// Rate of `crank_speed`.
    pub crank_speed: S,
    /// Rate of `coupler_speed`.
    pub coupler_speed: S,
    /// Rate of `rocker_speed`.
    pub rocker_speed: S,
    /// Rate of `rocker`.
    pub rocker: S,
}
impl<S: sim_kernel::Scalar> ::core::convert::From<[S; 4]> for FourBarOutputRates<S> {
    fn from(values: [S; 4]) -> Self {
        Self {
            crank_speed: values[0],
            coupler_speed: values[1],
            rocker_speed: values[2],
            rocker: values[3],
        }
    }
}
impl<S: sim_kernel::Scalar> ::core::convert::From<FourBarOutputRates<S>> for [S; 4] {
    fn from(record: FourBarOutputRates<S>) -> Self {
        [record.crank_speed, record.coupler_speed, record.rocker_speed, record.rocker]
    }
}
/// What the equations of motion need of the parameters of [`FourBar`], from [`FourBar::prepare`]; its methods are the kernels of each step.
#[allow(non_snake_case)]
#[derive(
    ::core::clone::Clone,
    ::core::marker::Copy,
    ::core::fmt::Debug,
    ::core::cmp::PartialEq
)]
pub struct FourBarPrepared<S = ::core::primitive::f64> {
    a: S,
    k: S,
    mass_theta2_theta2: S,
    b: S,
    k_2: S,
    mass_theta3_theta3: S,
    c: S,
    mass_theta4_theta4: S,
    T: S,
    k_3: S,
    k_4: S,
    k_5: S,
    k_6: S,
    k_7: S,
    k_8: S,
    inverse_theta2: S,
    l_lambda_closure_y_turned_theta2: S,
    minus_pivot_lambda_closure_y_turned: S,
    pivot_lambda_closure_y_turned: S,
    minus_inverse_lambda_closure_y_turned: S,
    k_9: S,
    k_10: S,
    k_11: S,
    k_12: S,
    k_13: S,
    k_14: S,
    k_15: S,
}
#[allow(non_snake_case, unused_variables, unused_parens, clippy::all, clippy::pedantic)]
impl<S: sim_kernel::Scalar> FourBar<S> {
    /// What the equations of motion need of the parameters, computed once for a set of parameters.
    ///
    /// Operations: 5 additions, 33 multiplications, 2 divisions.
    #[inline]
    pub fn prepare(&self) -> FourBarPrepared<S> {
        let a_squared = self.a * self.a;
        let w = a_squared * self.m3;
        let mass_theta2_theta2 = S::from_f64(0.3333333333333333) * a_squared * self.m2
            + w;
        let w_2 = self.a * self.m3;
        let w_3 = S::from_f64(0.5) * w_2;
        let w_4 = self.b * w_3;
        let w_5 = self.m3 * self.b * self.b;
        let w_6 = S::from_f64(0.5) * self.g;
        let w_7 = self.a * self.m2;
        let w_8 = w_2 * self.g;
        let w_9 = self.m3 * self.b;
        let inverse_mass_theta2_theta2 = S::from_f64(1.0) / mass_theta2_theta2;
        let w_10 = self.a * inverse_mass_theta2_theta2;
        let w_11 = self.a * w_10;
        FourBarPrepared {
            a: self.a,
            k: w,
            mass_theta2_theta2: mass_theta2_theta2,
            b: self.b,
            k_2: w_4,
            mass_theta3_theta3: S::from_f64(0.3333333333333333) * w_5,
            c: self.c,
            mass_theta4_theta4: S::from_f64(0.3333333333333333) * self.c * self.c
                * self.m4,
            T: self.T,
            k_3: self.a * S::from_f64(2.0),
            k_4: w_3,
            k_5: w_6 * w_7 + w_8,
            k_6: S::from_f64(0.25) * w_9,
            k_7: w_6 * w_9,
            k_8: self.c * self.m4 * w_6,
            inverse_theta2: inverse_mass_theta2_theta2,
            l_lambda_closure_y_turned_theta2: w_10,
            minus_pivot_lambda_closure_y_turned: w_11,
            pivot_lambda_closure_y_turned: -w_11,
            minus_inverse_lambda_closure_y_turned: S::from_f64(1.0) / w_11,
            k_9: self.b - w_4 * w_10,
            k_10: self.T * S::from_f64(2.0),
            k_11: self.g * w_7 + S::from_f64(2.0) * w_8,
            k_12: self.b * w_2,
            k_13: w_5 * S::from_f64(0.25),
            k_14: self.b * S::from_f64(2.0),
            k_15: self.c * S::from_f64(2.0),
        }
    }
    /// Mass matrix `T_q' M T_q`, 3 x 3, symmetric, in SI units.
    ///
    /// Operations: 2 additions, 16 multiplications, 2 sine-cosine pairs.
    #[inline]
    pub fn mass_matrix(&self, t: S, q: &[S; 3]) -> [[S; 3]; 3] {
        let [theta2, theta3, _] = *q;
        let a_squared = self.a * self.a;
        let ([u2_y, u3_y], [u2_x, u3_x]) = S::sin_cos_each([theta2, theta3]);
        let mass_theta3_theta2 = self.a * self.m3 * S::from_f64(0.5) * self.b
            * (u2_y * u3_y + u2_x * u3_x);
        [
            [
                S::from_f64(0.3333333333333333) * a_squared * self.m2
                    + a_squared * self.m3,
                mass_theta3_theta2,
                S::from_f64(0.0),
            ],
            [
                mass_theta3_theta2,
                S::from_f64(0.3333333333333333) * self.m3 * self.b * self.b,
                S::from_f64(0.0),
            ],
            [
                S::from_f64(0.0),
                S::from_f64(0.0),
                S::from_f64(0.3333333333333333) * self.c * self.c * self.m4,
            ],
        ]
    }
    /// Convective forces `T_q' M g`, 3, with `g = (T_q q' + T_t)_q q' + (..)_t`: joules per unit of each coordinate.
    ///
    /// Operations: 2 additions, 11 multiplications, 2 sine-cosine pairs.
    #[inline]
    pub fn convective_forces(&self, t: S, q: &[S; 3], qd: &[S; 3]) -> [S; 3] {
        let [theta2, theta3, _] = *q;
        let [theta2_dot, theta3_dot, _] = *qd;
        let w = S::from_f64(0.5) * self.a * self.m3 * self.b;
        let ([u2_y, u3_y], [u2_x, u3_x]) = S::sin_cos_each([theta2, theta3]);
        let w_2 = u2_y * u3_x - u2_x * u3_y;
        [
            w * theta3_dot * theta3_dot * w_2,
            -(theta2_dot * theta2_dot * w * w_2),
            S::from_f64(0.0),
        ]
    }
    /// Generalised forces `T_q' F`, 3: joules per unit of each coordinate.
    ///
    /// Operations: 4 additions, 12 multiplications, 3 sine-cosine pairs.
    #[inline]
    pub fn generalized_forces(&self, t: S, q: &[S; 3], qd: &[S; 3]) -> [S; 3] {
        let [theta2, theta3, theta4] = *q;
        let ([_, _, _], [u2_x, u3_x, u4_x]) = S::sin_cos_each([theta2, theta3, theta4]);
        let w = S::from_f64(0.5) * self.g;
        [
            self.T - u2_x * (self.a * self.m2 * w + self.a * self.g * self.m3),
            -(u3_x * self.m3 * w * self.b),
            -(u4_x * w * self.c * self.m4),
        ]
    }
    /// Constraints `C`, 2, in SI units; zero throughout the motion.
    ///
    /// Operations: 5 additions, 6 multiplications, 3 sine-cosine pairs.
    #[inline]
    pub fn constraints(&self, t: S, q: &[S; 3]) -> [S; 2] {
        let [theta2, theta3, theta4] = *q;
        let ([u2_y, u4_y, u3_y], [u2_x, u4_x, u3_x]) = S::sin_cos_each([
            theta2,
            theta4,
            theta3,
        ]);
        [
            self.a * u2_x - self.d - self.c * u4_x + self.b * u3_x,
            self.a * u2_y - self.c * u4_y + self.b * u3_y,
        ]
    }
    /// The sum of the magnitudes of the terms of `C`, 2, in SI units: what its rounding is relative to.
    ///
    /// Operations: 12 additions, 6 multiplications, 3 sine-cosine pairs.
    #[inline]
    pub fn constraint_magnitudes(&self, t: S, q: &[S; 3]) -> [S; 2] {
        let [theta2, theta3, theta4] = *q;
        let ([u2_y, u4_y, u3_y], [u2_x, u4_x, u3_x]) = S::sin_cos_each([
            theta2,
            theta4,
            theta3,
        ]);
        [
            self.d.abs() + (self.a * u2_x).abs() + (self.c * u4_x).abs()
                + (self.b * u3_x).abs(),
            (self.a * u2_y).abs() + (self.c * u4_y).abs() + (self.b * u3_y).abs(),
        ]
    }
    /// Constraint Jacobian `C_q`, 2 x 3: units of each constraint per unit of each coordinate.
    ///
    /// Operations: 3 additions, 6 multiplications, 3 sine-cosine pairs.
    #[inline]
    pub fn constraint_jacobian(&self, t: S, q: &[S; 3]) -> [[S; 3]; 2] {
        let [theta2, theta3, theta4] = *q;
        let ([u2_y, u3_y, u4_y], [u2_x, u3_x, u4_x]) = S::sin_cos_each([
            theta2,
            theta3,
            theta4,
        ]);
        [
            [-(self.a * u2_y), -(self.b * u3_y), self.c * u4_y],
            [self.a * u2_x, self.b * u3_x, -(self.c * u4_x)],
        ]
    }
    /// `C_t`, 2, units of `C` per second: the speeds obey `C_q q' + C_t = 0`.
    ///
    /// Operations: none.
    #[inline]
    pub fn constraint_time_derivative(&self, t: S, q: &[S; 3]) -> [S; 2] {
        [S::from_f64(0.0), S::from_f64(0.0)]
    }
    /// `(C_q q' + C_t)_q q' + (..)_t`, 2, units of `C` per second squared: the part of `C''` without accelerations.
    ///
    /// Operations: 4 additions, 12 multiplications, 3 sine-cosine pairs.
    #[inline]
    pub fn constraint_convective(&self, t: S, q: &[S; 3], qd: &[S; 3]) -> [S; 2] {
        let [theta2, theta3, theta4] = *q;
        let [theta2_dot, theta3_dot, theta4_dot] = *qd;
        let ([u2_y, u3_y, u4_y], [u2_x, u3_x, u4_x]) = S::sin_cos_each([
            theta2,
            theta3,
            theta4,
        ]);
        let w = theta4_dot * theta4_dot * self.c;
        let w_2 = theta2_dot * theta2_dot * self.a;
        let w_3 = theta3_dot * theta3_dot * self.b;
        [u4_x * w - u2_x * w_2 - u3_x * w_3, w * u4_y - w_2 * u2_y - w_3 * u3_y]
    }
    /// `C` (2), `C_q` (2 x 3) and `C_t` (2) together, in SI units, for projection.
    ///
    /// Operations: 8 additions, 6 multiplications, 3 sine-cosine pairs.
    #[inline]
    pub fn constraint_linearization(
        &self,
        t: S,
        q: &[S; 3],
    ) -> sim_kernel::ConstraintLinearization<[S; 2], [[S; 3]; 2]> {
        let [theta2, theta3, theta4] = *q;
        let ([u2_y, u4_y, u3_y], [u2_x, u4_x, u3_x]) = S::sin_cos_each([
            theta2,
            theta4,
            theta3,
        ]);
        let A_x = self.a * u2_x;
        let minus_closure_y_by_theta4 = self.c * u4_x;
        let closure_y_by_theta3 = self.b * u3_x;
        let minus_closure_x_by_theta2 = self.a * u2_y;
        let B_y = self.c * u4_y;
        let minus_closure_x_by_theta3 = self.b * u3_y;
        sim_kernel::ConstraintLinearization {
            values: [
                A_x - self.d - minus_closure_y_by_theta4 + closure_y_by_theta3,
                minus_closure_x_by_theta2 - B_y + minus_closure_x_by_theta3,
            ],
            jacobian: [
                [-minus_closure_x_by_theta2, -minus_closure_x_by_theta3, B_y],
                [A_x, closure_y_by_theta3, -minus_closure_y_by_theta4],
            ],
            time_derivative: [S::from_f64(0.0), S::from_f64(0.0)],
        }
    }
    /// Kinetic energy `v' M v / 2`, in joules.
    ///
    /// Operations: 6 additions, 26 multiplications, 2 sine-cosine pairs.
    #[inline]
    pub fn kinetic_energy(&self, t: S, q: &[S; 3], qd: &[S; 3]) -> S {
        let [theta2, theta3, _] = *q;
        let [theta2_dot, theta3_dot, theta4_dot] = *qd;
        let ([u2_y, u3_y], [u2_x, u3_x]) = S::sin_cos_each([theta2, theta3]);
        let w = theta2_dot * self.a * S::from_f64(2.0);
        let w_2 = theta3_dot * self.b;
        let w_3 = u2_y * w + u3_y * w_2;
        let w_4 = w * u2_x + w_2 * u3_x;
        let w_5 = theta3_dot * theta3_dot * S::from_f64(0.041666666666666664) * self.b
            * self.b * self.m3;
        let w_6 = theta4_dot * theta4_dot * S::from_f64(0.16666666666666666) * self.c
            * self.c * self.m4;
        self.m3 * S::from_f64(0.125) * (w_3 * w_3 + w_4 * w_4)
            + theta2_dot * theta2_dot * S::from_f64(0.16666666666666666) * self.a
                * self.a * self.m2 + w_5 + w_6
    }
    /// Power of loads and drives, `F' v + lambda' C_t + T_t' (M x'' - F)`, in watts.
    ///
    /// Operations: 4 additions, 17 multiplications, 3 sine-cosine pairs.
    #[inline]
    pub fn power(
        &self,
        t: S,
        q: &[S; 3],
        qd: &[S; 3],
        qdd: &[S; 3],
        lambda: &[S; 2],
    ) -> S {
        let [theta2, theta3, theta4] = *q;
        let [theta2_dot, theta3_dot, theta4_dot] = *qd;
        let ([_, _, _], [u4_x, u2_x, u3_x]) = S::sin_cos_each([theta4, theta2, theta3]);
        let w = self.g * self.a;
        let w_2 = theta2_dot * S::from_f64(0.5)
            * (self.T * S::from_f64(2.0)
                - u2_x * (self.m2 * w + self.m3 * S::from_f64(2.0) * w));
        let w_3 = S::from_f64(0.5) * self.g;
        w_2 - theta4_dot * u4_x * self.c * self.m4 * w_3
            - theta3_dot * u3_x * self.m3 * self.b * w_3
    }
    /// Outputs, 12, in SI units.
    ///
    /// Operations: 20 additions, 34 multiplications, 3 sine-cosine pairs.
    #[inline]
    pub fn outputs(
        &self,
        t: S,
        q: &[S; 3],
        qd: &[S; 3],
        qdd: &[S; 3],
        lambda: &[S; 2],
    ) -> FourBarOutputs<S> {
        let [theta2, theta3, theta4] = *q;
        let [theta2_dot, theta3_dot, theta4_dot] = *qd;
        let [theta2_ddot, theta3_ddot, theta4_ddot] = *qdd;
        let [lambda_closure_x, lambda_closure_y] = *lambda;
        let w = S::from_f64(2.0) * self.a;
        let ([u2_y, u3_y, u4_y], [u2_x, u3_x, u4_x]) = S::sin_cos_each([
            theta2,
            theta3,
            theta4,
        ]);
        let theta2_dot_squared = theta2_dot * theta2_dot;
        let w_2 = theta2_ddot * u2_y + theta2_dot_squared * u2_x;
        let theta3_dot_squared = theta3_dot * theta3_dot;
        let w_3 = S::from_f64(0.5) * self.m3;
        let w_4 = (w * w_2 + self.b * (theta3_ddot * u3_y + theta3_dot_squared * u3_x))
            * w_3;
        let w_5 = S::from_f64(2.0) * self.g;
        let w_6 = theta2_ddot * u2_x - u2_y * theta2_dot_squared;
        let w_7 = w_3
            * (w_5 + w * w_6
                + self.b * (theta3_ddot * u3_x - u3_y * theta3_dot_squared));
        let w_8 = S::from_f64(0.5) * self.m2;
        let theta4_dot_squared = theta4_dot * theta4_dot;
        let w_9 = S::from_f64(0.5) * self.m4;
        [
            theta2_dot,
            theta3_dot,
            theta4_dot,
            theta4,
            lambda_closure_x,
            lambda_closure_y,
            lambda_closure_x - w_4,
            lambda_closure_y + w_7,
            lambda_closure_x - w_4 - self.a * w_2 * w_8,
            lambda_closure_y + w_7 + w_8 * (w_5 + self.a * w_6),
            -(lambda_closure_x
                + self.c * (theta4_ddot * u4_y + theta4_dot_squared * u4_x) * w_9),
            w_9 * (w_5 + self.c * (theta4_ddot * u4_x - u4_y * theta4_dot_squared))
                - lambda_closure_y,
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
        q: &[S; 3],
        qd: &[S; 3],
        qdd: &[S; 3],
    ) -> FourBarOutputRates<S> {
        let [_, _, theta4_dot] = *qd;
        let [theta2_ddot, theta3_ddot, theta4_ddot] = *qdd;
        [theta2_ddot, theta3_ddot, theta4_ddot, theta4_dot].into()
    }
    /// `left - right` of each event, 1, in SI units: zero when it happens.
    ///
    /// Operations: 1 addition, 1 multiplication.
    #[inline]
    pub fn events(
        &self,
        t: S,
        q: &[S; 3],
        qd: &[S; 3],
        qdd: &[S; 3],
        lambda: &[S; 2],
    ) -> [S; 1] {
        let [theta2, _, _] = *q;
        [theta2 - S::from_f64(2.0) * S::from_f64(::core::f64::consts::PI)]
    }
    /// The numbers of each shape of the drawing, in metres and radians.
    ///
    /// Operations: 4 additions, 13 multiplications, 3 sine-cosine pairs.
    #[inline]
    pub fn drawing(&self, t: S, q: &[S; 3]) -> [S; 18] {
        let [theta2, theta3, theta4] = *q;
        let ([u2_y, u4_y, u3_y], [u2_x, u4_x, u3_x]) = S::sin_cos_each([
            theta2,
            theta4,
            theta3,
        ]);
        let A_x = self.a * u2_x;
        let A_y = self.a * u2_y;
        let w = self.a * S::from_f64(0.5);
        let w_2 = S::from_f64(0.5) * self.b;
        let w_3 = self.c * S::from_f64(0.5);
        [
            S::from_f64(0.0),
            S::from_f64(0.0),
            self.d,
            S::from_f64(0.0),
            S::from_f64(0.0),
            S::from_f64(0.0),
            A_x,
            A_y,
            self.d + self.c * u4_x,
            self.c * u4_y,
            self.d,
            S::from_f64(0.0),
            u2_x * w,
            u2_y * w,
            A_x + u3_x * w_2,
            A_y + w_2 * u3_y,
            self.d + u4_x * w_3,
            u4_y * w_3,
        ]
    }
    /// Declared start: values or guesses of the coordinates (3), and speeds (3), in SI units; 0 where nothing is declared.
    ///
    /// Operations: none.
    #[inline]
    pub fn initial(&self) -> sim_kernel::Initial<[S; 3]> {
        sim_kernel::Initial {
            positions: [S::from_f64(0.0), S::from_f64(1.0), S::from_f64(1.7)],
            speeds: [S::from_f64(10.0), S::from_f64(0.0), S::from_f64(0.0)],
        }
    }
    /// [`FourBarPrepared::dynamics`] once; for many calls with the same parameters [`Self::prepare`] first.
    #[inline]
    pub fn dynamics(
        &self,
        t: S,
        q: &[S; 3],
        qd: &[S; 3],
    ) -> sim_kernel::Dynamics<S, [S; 3], [S; 2]> {
        self.prepare().dynamics(t, q, qd)
    }
    /// [`FourBarPrepared::dynamics_jacobian`] once; for many calls with the same parameters [`Self::prepare`] first.
    #[inline]
    pub fn dynamics_jacobian(
        &self,
        t: S,
        q: &[S; 3],
        qd: &[S; 3],
    ) -> sim_kernel::DynamicsJacobian<S, [[S; 3]; 3], [[S; 3]; 2]> {
        self.prepare().dynamics_jacobian(t, q, qd)
    }
}
#[allow(non_snake_case, unused_variables, unused_parens, clippy::all, clippy::pedantic)]
impl<S: sim_kernel::Scalar> FourBarPrepared<S> {
    /// Accelerations (3), multipliers (2) and power, from
    ///
    /// ```text
    /// [ T_q' M T_q   C_q' ] [ q''    ]   [ T_q' (F - M g)                      ]
    /// [ C_q          0    ] [ lambda ] = [ -(C_q q' + C_t)_q q' - (..)_t       ]
    /// ```
    ///
    /// by an elimination planned from the structure of the system, with two constraint rows turned along and across a link. Where `refused` is set a pivot was too small and nothing else holds: solve that state from the other kernels.
    ///
    /// Operations: 38 additions, 74 multiplications, 3 divisions, 3 sine-cosine pairs.
    #[inline(always)]
    pub fn dynamics(
        &self,
        t: S,
        q: &[S; 3],
        qd: &[S; 3],
    ) -> sim_kernel::Dynamics<S, [S; 3], [S; 2]> {
        let [theta2, theta3, theta4] = *q;
        let [theta2_dot, theta3_dot, theta4_dot] = *qd;
        let ([u2_y, u3_y, u4_y], [u2_x, u3_x, u4_x]) = S::sin_cos_each([
            theta2,
            theta3,
            theta4,
        ]);
        let w = u2_y * u3_x - u3_y * u2_x;
        let theta3_dot_squared = theta3_dot * theta3_dot;
        let rhs_theta2 = self.T - u2_x * self.k_5 - self.k_2 * w * theta3_dot_squared;
        let w_3 = self.b * theta3_dot_squared;
        let theta2_dot_squared = theta2_dot * theta2_dot;
        let w_2 = u2_y * u3_y + u2_x * u3_x;
        let mass_theta3_theta2 = self.k_2 * w_2;
        let l_theta3_theta2 = mass_theta3_theta2 * self.inverse_theta2;
        let k_theta3_lambda_closure_y_turned = w_2 * self.k_9;
        let minus_l_theta3_lambda_closure_y_turned = self
            .minus_inverse_lambda_closure_y_turned * k_theta3_lambda_closure_y_turned;
        let w_4 = u2_x * u4_y - u2_y * u4_x;
        let w_5 = self.c * theta4_dot * theta4_dot;
        let minus_rhs_lambda_closure_y_turned = w * w_3 + w_4 * w_5
            + rhs_theta2 * self.l_lambda_closure_y_turned_theta2;
        let rhs_theta3 = self.k_2 * w * theta2_dot_squared - u3_x * self.k_7
            - rhs_theta2 * l_theta3_theta2
            - minus_l_theta3_lambda_closure_y_turned * minus_rhs_lambda_closure_y_turned;
        let k_lambda_closure_x_turned_theta3 = self.b * w;
        let w_6 = u2_y * u4_y + u2_x * u4_x;
        let minus_k_theta4_lambda_closure_y_turned = self.c * w_6;
        let l_theta4_lambda_closure_y_turned = minus_k_theta4_lambda_closure_y_turned
            * self.minus_inverse_lambda_closure_y_turned;
        let w_8 = minus_k_theta4_lambda_closure_y_turned
            * l_theta4_lambda_closure_y_turned;
        let minus_k_theta4_theta3 = k_theta3_lambda_closure_y_turned
            * l_theta4_lambda_closure_y_turned;
        let w_7 = k_theta3_lambda_closure_y_turned
            * minus_l_theta3_lambda_closure_y_turned;
        let pivot_theta3 = self.mass_theta3_theta3 - mass_theta3_theta2 * l_theta3_theta2
            + w_7;
        let inverse_theta3 = S::from_f64(1.0) / pivot_theta3;
        let minus_l_theta4_theta3 = minus_k_theta4_theta3 * inverse_theta3;
        let rhs_theta4 = l_theta4_lambda_closure_y_turned
            * minus_rhs_lambda_closure_y_turned - u4_x * self.k_8
            + minus_l_theta4_theta3 * rhs_theta3;
        let pivot_theta4 = self.mass_theta4_theta4 + w_8
            - minus_k_theta4_theta3 * minus_l_theta4_theta3;
        let inverse_theta4 = S::from_f64(1.0) / pivot_theta4;
        let l_lambda_closure_x_turned_theta3 = k_lambda_closure_x_turned_theta3
            * inverse_theta3;
        let k_lambda_closure_x_turned_theta4 = self.c * w_4
            + minus_k_theta4_theta3 * l_lambda_closure_x_turned_theta3;
        let l_lambda_closure_x_turned_theta4 = inverse_theta4
            * k_lambda_closure_x_turned_theta4;
        let minus_pivot_lambda_closure_x_turned = k_lambda_closure_x_turned_theta3
            * l_lambda_closure_x_turned_theta3
            + k_lambda_closure_x_turned_theta4 * l_lambda_closure_x_turned_theta4;
        let w_9 = S::from_f64(1.0) / minus_pivot_lambda_closure_x_turned
            * (w_6 * w_5 - w_2 * w_3 - self.a * theta2_dot_squared
                + l_lambda_closure_x_turned_theta3 * rhs_theta3
                + l_lambda_closure_x_turned_theta4 * rhs_theta4);
        let theta4_ddot = inverse_theta4 * rhs_theta4
            - l_lambda_closure_x_turned_theta4 * w_9;
        let theta3_ddot = inverse_theta3 * rhs_theta3
            + minus_l_theta4_theta3 * theta4_ddot
            - l_lambda_closure_x_turned_theta3 * w_9;
        let w_10 = self.minus_inverse_lambda_closure_y_turned
            * minus_rhs_lambda_closure_y_turned
            + minus_l_theta3_lambda_closure_y_turned * theta3_ddot
            - l_theta4_lambda_closure_y_turned * theta4_ddot;
        sim_kernel::Dynamics {
            accelerations: [
                rhs_theta2 * self.inverse_theta2 - l_theta3_theta2 * theta3_ddot
                    - self.l_lambda_closure_y_turned_theta2 * w_10,
                theta3_ddot,
                theta4_ddot,
            ],
            multipliers: [u2_x * w_9 - u2_y * w_10, u2_y * w_9 + u2_x * w_10],
            power: S::from_f64(0.5) * theta2_dot * (self.k_10 - u2_x * self.k_11)
                - u4_x * self.k_8 * theta4_dot - u3_x * theta3_dot * self.k_7,
            refused: sim_kernel::pivot_is_refused(
                self.mass_theta2_theta2,
                self.mass_theta2_theta2,
            )
                | sim_kernel::pivot_is_refused(
                    self.pivot_lambda_closure_y_turned,
                    self.minus_pivot_lambda_closure_y_turned,
                )
                | sim_kernel::pivot_is_refused(
                    pivot_theta3,
                    self.mass_theta3_theta3 + w_7,
                )
                | sim_kernel::pivot_is_refused(
                    pivot_theta4,
                    self.mass_theta4_theta4 + w_8,
                )
                | sim_kernel::pivot_is_refused(
                    -minus_pivot_lambda_closure_x_turned,
                    minus_pivot_lambda_closure_x_turned,
                ),
        }
    }
    /// The derivatives of accelerations (3 rows) and multipliers (2 rows) with respect to coordinates and speeds (3 columns each): with the equations of motion as `K z = r`, the solutions of `K dz = dr - dK z`. Where `refused` is set a pivot was too small and nothing else holds.
    ///
    /// Operations: 153 additions, 231 multiplications, 3 divisions, 3 sine-cosine pairs.
    #[inline]
    pub fn dynamics_jacobian(
        &self,
        t: S,
        q: &[S; 3],
        qd: &[S; 3],
    ) -> sim_kernel::DynamicsJacobian<S, [[S; 3]; 3], [[S; 3]; 2]> {
        let [theta2, theta3, theta4] = *q;
        let [theta2_dot, theta3_dot, theta4_dot] = *qd;
        let ([u2_y, u3_y, u4_y], [u2_x, u3_x, u4_x]) = S::sin_cos_each([
            theta2,
            theta3,
            theta4,
        ]);
        let theta3_dot_squared = theta3_dot * theta3_dot;
        let w = u2_y * u3_x - u3_y * u2_x;
        let w_2 = self.k_2 * w;
        let rhs_theta2 = self.T - u2_x * self.k_5 - theta3_dot_squared * w_2;
        let theta2_dot_squared = theta2_dot * theta2_dot;
        let w_3 = u2_y * u3_y + u2_x * u3_x;
        let mass_theta3_theta2 = self.k_2 * w_3;
        let l_theta3_theta2 = mass_theta3_theta2 * self.inverse_theta2;
        let k_theta3_lambda_closure_y_turned = w_3 * self.k_9;
        let minus_l_theta3_lambda_closure_y_turned = self
            .minus_inverse_lambda_closure_y_turned * k_theta3_lambda_closure_y_turned;
        let w_4 = self.b * theta3_dot_squared;
        let w_5 = w * w_4;
        let w_6 = u2_x * u4_y - u2_y * u4_x;
        let w_7 = self.c * w_6;
        let theta4_dot_squared = theta4_dot * theta4_dot;
        let w_8 = w_7 * theta4_dot_squared;
        let minus_rhs_lambda_closure_y_turned = w_5 + w_8
            + rhs_theta2 * self.l_lambda_closure_y_turned_theta2;
        let rhs_theta3 = theta2_dot_squared * w_2 - u3_x * self.k_7
            - rhs_theta2 * l_theta3_theta2
            - minus_l_theta3_lambda_closure_y_turned * minus_rhs_lambda_closure_y_turned;
        let w_9 = u2_y * u4_y + u2_x * u4_x;
        let minus_k_theta4_lambda_closure_y_turned = self.c * w_9;
        let w_15 = minus_k_theta4_lambda_closure_y_turned * theta4_dot_squared;
        let l_theta4_lambda_closure_y_turned = minus_k_theta4_lambda_closure_y_turned
            * self.minus_inverse_lambda_closure_y_turned;
        let minus_k_theta4_theta3 = k_theta3_lambda_closure_y_turned
            * l_theta4_lambda_closure_y_turned;
        let w_10 = k_theta3_lambda_closure_y_turned
            * minus_l_theta3_lambda_closure_y_turned;
        let pivot_theta3 = self.mass_theta3_theta3 - mass_theta3_theta2 * l_theta3_theta2
            + w_10;
        let inverse_theta3 = S::from_f64(1.0) / pivot_theta3;
        let minus_l_theta4_theta3 = minus_k_theta4_theta3 * inverse_theta3;
        let rhs_theta4 = l_theta4_lambda_closure_y_turned
            * minus_rhs_lambda_closure_y_turned - u4_x * self.k_8
            + minus_l_theta4_theta3 * rhs_theta3;
        let w_11 = theta2_dot_squared * self.k_3;
        let w_12 = u2_x * w_11 + u3_x * w_4;
        let w_13 = u2_y * w_11 + u3_y * w_4;
        let w_16 = w_3 * w_4;
        let w_14 = minus_k_theta4_lambda_closure_y_turned
            * l_theta4_lambda_closure_y_turned;
        let pivot_theta4 = self.mass_theta4_theta4 + w_14
            - minus_k_theta4_theta3 * minus_l_theta4_theta3;
        let inverse_theta4 = S::from_f64(1.0) / pivot_theta4;
        let k_lambda_closure_x_turned_theta3 = self.b * w;
        let l_lambda_closure_x_turned_theta3 = k_lambda_closure_x_turned_theta3
            * inverse_theta3;
        let k_lambda_closure_x_turned_theta4 = w_7
            + minus_k_theta4_theta3 * l_lambda_closure_x_turned_theta3;
        let l_lambda_closure_x_turned_theta4 = inverse_theta4
            * k_lambda_closure_x_turned_theta4;
        let minus_pivot_lambda_closure_x_turned = k_lambda_closure_x_turned_theta3
            * l_lambda_closure_x_turned_theta3
            + k_lambda_closure_x_turned_theta4 * l_lambda_closure_x_turned_theta4;
        let minus_inverse_lambda_closure_x_turned = S::from_f64(1.0)
            / minus_pivot_lambda_closure_x_turned;
        let w_17 = minus_inverse_lambda_closure_x_turned
            * (w_15 - w_16 - self.a * theta2_dot_squared
                + l_lambda_closure_x_turned_theta3 * rhs_theta3
                + l_lambda_closure_x_turned_theta4 * rhs_theta4);
        let theta4_ddot = inverse_theta4 * rhs_theta4
            - l_lambda_closure_x_turned_theta4 * w_17;
        let theta3_ddot = inverse_theta3 * rhs_theta3
            + minus_l_theta4_theta3 * theta4_ddot
            - l_lambda_closure_x_turned_theta3 * w_17;
        let w_22 = self.minus_inverse_lambda_closure_y_turned
            * minus_rhs_lambda_closure_y_turned
            + minus_l_theta3_lambda_closure_y_turned * theta3_ddot
            - l_theta4_lambda_closure_y_turned * theta4_ddot;
        let w_18 = w * self.k_12;
        let w_19 = S::from_f64(0.5) * w_18;
        let w_23 = (rhs_theta2 * self.inverse_theta2 - l_theta3_theta2 * theta3_ddot
            - self.l_lambda_closure_y_turned_theta2 * w_22) * w_19;
        let w_20 = theta3_ddot * w_19;
        let w_21 = u2_y * self.k_5 - self.k_4 * (u2_x * w_12 + u2_y * w_13) + w_20
            + self.k * theta2_dot_squared;
        let w_40 = mass_theta3_theta2 * theta3_dot_squared - w_20;
        let w_24 = self.b * w_3;
        let w_25 = w_24 * w_17;
        let w_35 = w_24 * theta3_ddot;
        let w_27 = k_lambda_closure_x_turned_theta3 * theta3_ddot;
        let w_26 = k_lambda_closure_x_turned_theta3 * w_22;
        let w_28 = w_7 * theta4_ddot;
        let w_32 = w_7 * w_22;
        let w_34 = minus_k_theta4_lambda_closure_y_turned * theta4_ddot;
        let w_31 = minus_k_theta4_lambda_closure_y_turned * w_17;
        let w_29 = w_15 - w_16 + w_27 + w_28
            - self.l_lambda_closure_y_turned_theta2 * w_21;
        let w_30 = mass_theta3_theta2 * theta2_dot_squared + w_23 - w_25 + w_26
            - l_theta3_theta2 * w_21 + minus_l_theta3_lambda_closure_y_turned * w_29;
        let w_41 = w_16 - w_27 - self.l_lambda_closure_y_turned_theta2 * w_40;
        let w_42 = w_25 - w_23 - w_26 - self.k_6 * (u3_x * w_12 + u3_y * w_13)
            + theta3_dot_squared * self.k_13 + u3_y * self.k_7 - l_theta3_theta2 * w_40
            + minus_l_theta3_lambda_closure_y_turned * w_41;
        let w_48 = w_15 + w_28;
        let w_33 = w_31 + w_32 - l_theta4_lambda_closure_y_turned * w_29
            + minus_l_theta4_theta3 * w_30;
        let w_36 = minus_inverse_lambda_closure_x_turned
            * (w_34 - w_5 - w_8 - w_35 - l_lambda_closure_x_turned_theta3 * w_30
                - l_lambda_closure_x_turned_theta4 * w_33);
        let w_37 = inverse_theta4 * w_33 + l_lambda_closure_x_turned_theta4 * w_36;
        let w_38 = inverse_theta3 * w_30 + minus_l_theta4_theta3 * w_37
            + l_lambda_closure_x_turned_theta3 * w_36;
        let w_39 = minus_l_theta3_lambda_closure_y_turned * w_38
            - self.minus_inverse_lambda_closure_y_turned * w_29
            - l_theta4_lambda_closure_y_turned * w_37;
        let w_43 = minus_l_theta4_theta3 * w_42
            - l_theta4_lambda_closure_y_turned * w_41;
        let w_44 = minus_inverse_lambda_closure_x_turned
            * (w_5 + w_35 - l_lambda_closure_x_turned_theta3 * w_42
                - l_lambda_closure_x_turned_theta4 * w_43);
        let w_45 = inverse_theta4 * w_43 + l_lambda_closure_x_turned_theta4 * w_44;
        let w_46 = inverse_theta3 * w_42 + minus_l_theta4_theta3 * w_45
            + l_lambda_closure_x_turned_theta3 * w_44;
        let w_47 = minus_l_theta3_lambda_closure_y_turned * w_46
            - self.minus_inverse_lambda_closure_y_turned * w_41
            - l_theta4_lambda_closure_y_turned * w_45;
        let w_49 = minus_l_theta3_lambda_closure_y_turned * w_48;
        let w_50 = u4_y * self.k_8 - w_31 - w_32
            + l_theta4_lambda_closure_y_turned * w_48 - minus_l_theta4_theta3 * w_49;
        let w_51 = minus_inverse_lambda_closure_x_turned
            * (w_8 - w_34 + l_lambda_closure_x_turned_theta3 * w_49
                - l_lambda_closure_x_turned_theta4 * w_50);
        let w_52 = inverse_theta4 * w_50 + l_lambda_closure_x_turned_theta4 * w_51;
        let w_53 = minus_l_theta4_theta3 * w_52 - inverse_theta3 * w_49
            + l_lambda_closure_x_turned_theta3 * w_51;
        let w_54 = self.minus_inverse_lambda_closure_y_turned * w_48
            + minus_l_theta3_lambda_closure_y_turned * w_53
            - l_theta4_lambda_closure_y_turned * w_52;
        let w_55 = theta2_dot * w_18;
        let w_61 = theta3_dot * w_18;
        let w_56 = minus_l_theta4_theta3 * w_55;
        let w_57 = minus_inverse_lambda_closure_x_turned
            * (theta2_dot * self.k_3 - l_lambda_closure_x_turned_theta3 * w_55
                - l_lambda_closure_x_turned_theta4 * w_56);
        let w_58 = inverse_theta4 * w_56 + l_lambda_closure_x_turned_theta4 * w_57;
        let w_59 = inverse_theta3 * w_55 + minus_l_theta4_theta3 * w_58
            + l_lambda_closure_x_turned_theta3 * w_57;
        let w_60 = minus_l_theta3_lambda_closure_y_turned * w_59
            - l_theta4_lambda_closure_y_turned * w_58;
        let w_62 = theta3_dot * self.k_14;
        let w_63 = self.l_lambda_closure_y_turned_theta2 * w_61 - w * w_62;
        let w_64 = l_theta3_theta2 * w_61
            + minus_l_theta3_lambda_closure_y_turned * w_63;
        let w_65 = minus_l_theta4_theta3 * w_64
            - l_theta4_lambda_closure_y_turned * w_63;
        let w_66 = minus_inverse_lambda_closure_x_turned
            * (w_3 * w_62 - l_lambda_closure_x_turned_theta3 * w_64
                - l_lambda_closure_x_turned_theta4 * w_65);
        let w_67 = inverse_theta4 * w_65 + l_lambda_closure_x_turned_theta4 * w_66;
        let w_68 = inverse_theta3 * w_64 + minus_l_theta4_theta3 * w_67
            + l_lambda_closure_x_turned_theta3 * w_66;
        let w_69 = minus_l_theta3_lambda_closure_y_turned * w_68
            - self.minus_inverse_lambda_closure_y_turned * w_63
            - l_theta4_lambda_closure_y_turned * w_67;
        let w_70 = theta4_dot * self.k_15;
        let w_71 = w_6 * w_70;
        let w_72 = minus_l_theta3_lambda_closure_y_turned * w_71;
        let w_73 = l_theta4_lambda_closure_y_turned * w_71
            - minus_l_theta4_theta3 * w_72;
        let w_74 = minus_inverse_lambda_closure_x_turned
            * (l_lambda_closure_x_turned_theta3 * w_72 - w_9 * w_70
                - l_lambda_closure_x_turned_theta4 * w_73);
        let w_75 = inverse_theta4 * w_73 + l_lambda_closure_x_turned_theta4 * w_74;
        let w_76 = minus_l_theta4_theta3 * w_75 - inverse_theta3 * w_72
            + l_lambda_closure_x_turned_theta3 * w_74;
        let w_77 = self.minus_inverse_lambda_closure_y_turned * w_71
            + minus_l_theta3_lambda_closure_y_turned * w_76
            - l_theta4_lambda_closure_y_turned * w_75;
        sim_kernel::DynamicsJacobian {
            accelerations_by_positions: [
                [
                    self.inverse_theta2 * w_21 - l_theta3_theta2 * w_38
                        - self.l_lambda_closure_y_turned_theta2 * w_39,
                    self.inverse_theta2 * w_40 - l_theta3_theta2 * w_46
                        - self.l_lambda_closure_y_turned_theta2 * w_47,
                    -(l_theta3_theta2 * w_53
                        + self.l_lambda_closure_y_turned_theta2 * w_54),
                ],
                [w_38, w_46, w_53],
                [w_37, w_45, w_52],
            ],
            accelerations_by_speeds: [
                [
                    -(l_theta3_theta2 * w_59
                        + self.l_lambda_closure_y_turned_theta2 * w_60),
                    -(self.inverse_theta2 * w_61 + l_theta3_theta2 * w_68
                        + self.l_lambda_closure_y_turned_theta2 * w_69),
                    -(l_theta3_theta2 * w_76
                        + self.l_lambda_closure_y_turned_theta2 * w_77),
                ],
                [w_59, w_68, w_76],
                [w_58, w_67, w_75],
            ],
            multipliers_by_positions: [
                [
                    -(u2_x * w_36 + u2_y * w_39 + (u2_y * w_17 + u2_x * w_22)),
                    -(u2_x * w_44 + u2_y * w_47),
                    -(u2_x * w_51 + u2_y * w_54),
                ],
                [
                    u2_x * w_39 - u2_y * w_36 + (u2_x * w_17 - u2_y * w_22),
                    u2_x * w_47 - u2_y * w_44,
                    u2_x * w_54 - u2_y * w_51,
                ],
            ],
            multipliers_by_speeds: [
                [
                    -(u2_x * w_57 + u2_y * w_60),
                    -(u2_x * w_66 + u2_y * w_69),
                    -(u2_x * w_74 + u2_y * w_77),
                ],
                [
                    u2_x * w_60 - u2_y * w_57,
                    u2_x * w_69 - u2_y * w_66,
                    u2_x * w_77 - u2_y * w_74,
                ],
            ],
            refused: sim_kernel::pivot_is_refused(
                self.mass_theta2_theta2,
                self.mass_theta2_theta2,
            )
                | sim_kernel::pivot_is_refused(
                    self.pivot_lambda_closure_y_turned,
                    self.minus_pivot_lambda_closure_y_turned,
                )
                | sim_kernel::pivot_is_refused(
                    pivot_theta3,
                    self.mass_theta3_theta3 + w_10,
                )
                | sim_kernel::pivot_is_refused(
                    pivot_theta4,
                    self.mass_theta4_theta4 + w_14,
                )
                | sim_kernel::pivot_is_refused(
                    -minus_pivot_lambda_closure_x_turned,
                    minus_pivot_lambda_closure_x_turned,
                ),
        }
    }
}
#[allow(non_snake_case, clippy::all, clippy::pedantic)]
impl<S: sim_kernel::Scalar> sim_kernel::Mechanism<S> for FourBar<S> {
    type Q = [S; 3];
    type L = [S; 2];
    type Z = [S; 5];
    type QQ = [[S; 3]; 3];
    type LQ = [[S; 3]; 2];
    type LL = [[S; 2]; 2];
    type ZZ = [[S; 5]; 5];
    type Entries = [S; 0];
    type Envelope = [S; 0];
    type Parameters = [S; 9];
    type Outputs = [S; 12];
    type OutputRates = [S; 4];
    type Events = [S; 1];
    type EventValues = [S; 0];
    type Activities = [S; 0];
    type Drawing = [S; 18];
    type QP = [[S; 9]; 3];
    type LP = [[S; 9]; 2];
    type Inputs = [sim_kernel::Input<S>; 0];
    type Prepared = FourBarPrepared<S>;
    type On<T: sim_kernel::Scalar> = FourBar<T>;
    const DESCRIPTION: sim_kernel::Description = sim_kernel::Description {
        name: "four-bar",
        type_name: "FourBar",
        docs: "Four-bar linkage: crank 2 turns, coupler 3 swings rocker 4. Three uniform slender rods under gravity, let go\nwith the crank along the ground link at 10 rad/s.",
        declaration: "/// Four-bar linkage: crank 2 turns, coupler 3 swings rocker 4. Three uniform slender rods under gravity, let go\n/// with the crank along the ground link at 10 rad/s.\npub FourBar;\n\ncoordinates {\n    /// Angle of crank 2.\n    theta2 [rad];\n    /// Angle of coupler 3.\n    theta3 [rad];\n    /// Angle of rocker 4.\n    theta4 [rad];\n}\n\nparameters {\n    /// Length of crank 2.\n    a [m] = 0.2;\n    /// Length of coupler 3.\n    b [m] = 0.6;\n    /// Length of rocker 4.\n    c [m] = 0.5;\n    /// Distance of the fixed pivots.\n    d [m] = 0.6;\n    /// Mass of crank 2.\n    m2 [kg] = 2;\n    /// Mass of coupler 3.\n    m3 [kg] = 4;\n    /// Mass of rocker 4.\n    m4 [kg] = 3;\n    g [m/s^2] = 9.81;\n    /// Torque on crank 2.\n    T [N*m] = 0;\n}\n\nlet O2 = [0, 0];\nlet O4 = [d, 0];\nlet u2 = [cos(theta2), sin(theta2)];\nlet u3 = [cos(theta3), sin(theta3)];\nlet u4 = [cos(theta4), sin(theta4)];\nlet A = a*u2;\nlet B = O4 + c*u4;\nlet G2 = a/2*u2;\nlet G3 = A + b/2*u3;\nlet G4 = O4 + c/2*u4;\nlet weight = [0, g];\n\nbodies {\n    crank2: mass m2 at G2, inertia m2*a^2/12, angle theta2;\n    coupler3: mass m3 at G3, inertia m3*b^2/12, angle theta3;\n    rocker4: mass m4 at G4, inertia m4*c^2/12, angle theta4;\n}\n\nloads {\n    gravity [0, -g];\n    torque T on crank2;\n}\n\nconstraints { closure: A + b*u3 = B; }\n\ninitial {\n    theta2 = 0;\n    dot(theta2) = 10;\n    guess theta3 = 1;\n    guess theta4 = 1.7;\n}\n\nevents { period: theta2 = 2*pi; }\n\nlet effort3 = m3*(ddot(G3) + weight);\nlet effort2 = m2*(ddot(G2) + weight);\nlet effort4 = m4*(ddot(G4) + weight);\n\noutputs {\n    angular_speeds \"Angular speeds\" {\n        /// crank 2\n        crank_speed [rad/s] = dot(theta2);\n        /// coupler 3\n        coupler_speed [rad/s] = dot(theta3);\n        /// rocker 4\n        rocker_speed [rad/s] = dot(theta4);\n    }\n    rocker_angle \"Angle of rocker 4\" {\n        /// angle\n        rocker [deg] = theta4;\n    }\n    forces_in_B \"Force of coupler 3 on rocker 4, in B\" {\n        /// along x\n        Bx [N] = reaction(closure).x;\n        /// along y\n        By [N] = reaction(closure).y;\n    }\n    forces_in_A \"Force of crank 2 on coupler 3, in A\" {\n        /// along x\n        Ax [N] = effort3.x + reaction(closure).x;\n        /// along y\n        Ay [N] = effort3.y + reaction(closure).y;\n    }\n    forces_in_O2 \"Force of the ground on crank 2, in O2\" {\n        /// along x\n        O2x [N] = effort2.x + effort3.x + reaction(closure).x;\n        /// along y\n        O2y [N] = effort2.y + effort3.y + reaction(closure).y;\n    }\n    forces_in_O4 \"Force of the ground on rocker 4, in O4\" {\n        /// along x\n        O4x [N] = effort4.x - reaction(closure).x;\n        /// along y\n        O4y [N] = effort4.y - reaction(closure).y;\n    }\n}\n\ndrawing {\n    ground O2, O4;\n    line O2, A, B, O4;\n    point G2, G3, G4;\n}\n",
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
                start: sim_kernel::Start::Given,
                speed_given: true,
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
                docs: "Length of coupler 3.",
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
                docs: "Distance of the fixed pivots.",
            },
            sim_kernel::Quantity {
                name: "m2",
                unit: "kg",
                factor: 1f64,
                is_length: false,
                docs: "Mass of crank 2.",
            },
            sim_kernel::Quantity {
                name: "m3",
                unit: "kg",
                factor: 1f64,
                is_length: false,
                docs: "Mass of coupler 3.",
            },
            sim_kernel::Quantity {
                name: "m4",
                unit: "kg",
                factor: 1f64,
                is_length: false,
                docs: "Mass of rocker 4.",
            },
            sim_kernel::Quantity {
                name: "g",
                unit: "m/s^2",
                factor: 1f64,
                is_length: false,
                docs: "",
            },
            sim_kernel::Quantity {
                name: "T",
                unit: "N*m",
                factor: 1f64,
                is_length: false,
                docs: "Torque on crank 2.",
            },
        ],
        inputs: &[],
        constraints: &[
            sim_kernel::Quantity {
                name: "closure_x",
                unit: "N",
                factor: 1f64,
                is_length: false,
                docs: "",
            },
            sim_kernel::Quantity {
                name: "closure_y",
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
                name: "crank_speed",
                unit: "rad/s",
                factor: 1f64,
                is_length: false,
                docs: "crank 2",
            },
            sim_kernel::Quantity {
                name: "coupler_speed",
                unit: "rad/s",
                factor: 1f64,
                is_length: false,
                docs: "coupler 3",
            },
            sim_kernel::Quantity {
                name: "rocker_speed",
                unit: "rad/s",
                factor: 1f64,
                is_length: false,
                docs: "rocker 4",
            },
            sim_kernel::Quantity {
                name: "rocker",
                unit: "deg",
                factor: 0.017453292519943295f64,
                is_length: false,
                docs: "angle",
            },
            sim_kernel::Quantity {
                name: "Bx",
                unit: "N",
                factor: 1f64,
                is_length: false,
                docs: "along x",
            },
            sim_kernel::Quantity {
                name: "By",
                unit: "N",
                factor: 1f64,
                is_length: false,
                docs: "along y",
            },
            sim_kernel::Quantity {
                name: "Ax",
                unit: "N",
                factor: 1f64,
                is_length: false,
                docs: "along x",
            },
            sim_kernel::Quantity {
                name: "Ay",
                unit: "N",
                factor: 1f64,
                is_length: false,
                docs: "along y",
            },
            sim_kernel::Quantity {
                name: "O2x",
                unit: "N",
                factor: 1f64,
                is_length: false,
                docs: "along x",
            },
            sim_kernel::Quantity {
                name: "O2y",
                unit: "N",
                factor: 1f64,
                is_length: false,
                docs: "along y",
            },
            sim_kernel::Quantity {
                name: "O4x",
                unit: "N",
                factor: 1f64,
                is_length: false,
                docs: "along x",
            },
            sim_kernel::Quantity {
                name: "O4y",
                unit: "N",
                factor: 1f64,
                is_length: false,
                docs: "along y",
            },
        ],
        rated_outputs: &[0, 1, 2, 3],
        figures: &[
            sim_kernel::Figure {
                name: "angular_speeds",
                title: "Angular speeds",
                len: 3,
            },
            sim_kernel::Figure {
                name: "rocker_angle",
                title: "Angle of rocker 4",
                len: 1,
            },
            sim_kernel::Figure {
                name: "forces_in_B",
                title: "Force of coupler 3 on rocker 4, in B",
                len: 2,
            },
            sim_kernel::Figure {
                name: "forces_in_A",
                title: "Force of crank 2 on coupler 3, in A",
                len: 2,
            },
            sim_kernel::Figure {
                name: "forces_in_O2",
                title: "Force of the ground on crank 2, in O2",
                len: 2,
            },
            sim_kernel::Figure {
                name: "forces_in_O4",
                title: "Force of the ground on rocker 4, in O4",
                len: 2,
            },
        ],
        optional_kernels: &["dynamics_jacobian"],
        dimension: 2,
        drawing: &[
            sim_kernel::Shape::Ground(2),
            sim_kernel::Shape::Line(4),
            sim_kernel::Shape::Points(3),
        ],
    };
    fn defaults() -> Self {
        Self {
            a: S::from_f64(0.2f64),
            b: S::from_f64(0.6f64),
            c: S::from_f64(0.5f64),
            d: S::from_f64(0.6f64),
            m2: S::from_f64(2f64),
            m3: S::from_f64(4f64),
            m4: S::from_f64(3f64),
            g: S::from_f64(9.81f64),
            T: S::from_f64(0f64),
        }
    }
    fn parameters(&self) -> [S; 9] {
        [self.a, self.b, self.c, self.d, self.m2, self.m3, self.m4, self.g, self.T]
    }
    fn with_parameters(&self, parameters: [S; 9]) -> Self {
        Self {
            a: parameters[0],
            b: parameters[1],
            c: parameters[2],
            d: parameters[3],
            m2: parameters[4],
            m3: parameters[5],
            m4: parameters[6],
            g: parameters[7],
            T: parameters[8],
            ..*self
        }
    }
    fn on<T: sim_kernel::Scalar>(
        &self,
        convert: impl ::core::ops::Fn(S) -> T,
    ) -> FourBar<T> {
        FourBar {
            a: convert(self.a),
            b: convert(self.b),
            c: convert(self.c),
            d: convert(self.d),
            m2: convert(self.m2),
            m3: convert(self.m3),
            m4: convert(self.m4),
            g: convert(self.g),
            T: convert(self.T),
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
    fn prepare(&self) -> FourBarPrepared<S> {
        self.prepare()
    }
    #[inline(always)]
    fn prepared_dynamics(
        prepared: &Self::Prepared,
        t: S,
        q: &[S; 3],
        qd: &[S; 3],
    ) -> sim_kernel::Dynamics<S, [S; 3], [S; 2]> {
        prepared.dynamics(t, q, qd)
    }
    #[inline(always)]
    fn dynamics_jacobian(
        &self,
        t: S,
        q: &[S; 3],
        qd: &[S; 3],
    ) -> sim_kernel::DynamicsJacobian<S, [[S; 3]; 3], [[S; 3]; 2]> {
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
    fn constraints(&self, t: S, q: &[S; 3]) -> [S; 2] {
        self.constraints(t, q)
    }
    #[inline(always)]
    fn constraint_magnitudes(&self, t: S, q: &[S; 3]) -> [S; 2] {
        self.constraint_magnitudes(t, q)
    }
    #[inline(always)]
    fn constraint_jacobian(&self, t: S, q: &[S; 3]) -> [[S; 3]; 2] {
        self.constraint_jacobian(t, q)
    }
    #[inline(always)]
    fn constraint_time_derivative(&self, t: S, q: &[S; 3]) -> [S; 2] {
        self.constraint_time_derivative(t, q)
    }
    #[inline(always)]
    fn constraint_convective(&self, t: S, q: &[S; 3], qd: &[S; 3]) -> [S; 2] {
        self.constraint_convective(t, q, qd)
    }
    #[inline(always)]
    fn constraint_linearization(
        &self,
        t: S,
        q: &[S; 3],
    ) -> sim_kernel::ConstraintLinearization<[S; 2], [[S; 3]; 2]> {
        self.constraint_linearization(t, q)
    }
    #[inline(always)]
    fn kinetic_energy(&self, t: S, q: &[S; 3], qd: &[S; 3]) -> S {
        self.kinetic_energy(t, q, qd)
    }
    #[inline(always)]
    fn power(&self, t: S, q: &[S; 3], qd: &[S; 3], qdd: &[S; 3], lambda: &[S; 2]) -> S {
        self.power(t, q, qd, qdd, lambda)
    }
    #[inline(always)]
    fn outputs(
        &self,
        t: S,
        q: &[S; 3],
        qd: &[S; 3],
        qdd: &[S; 3],
        lambda: &[S; 2],
    ) -> [S; 12] {
        self.outputs(t, q, qd, qdd, lambda).into()
    }
    #[inline(always)]
    fn output_rates(&self, t: S, q: &[S; 3], qd: &[S; 3], qdd: &[S; 3]) -> [S; 4] {
        self.output_rates(t, q, qd, qdd).into()
    }
    #[inline(always)]
    fn events(
        &self,
        t: S,
        q: &[S; 3],
        qd: &[S; 3],
        qdd: &[S; 3],
        lambda: &[S; 2],
    ) -> [S; 1] {
        self.events(t, q, qd, qdd, lambda)
    }
    #[inline(always)]
    fn drawing(&self, t: S, q: &[S; 3]) -> [S; 18] {
        self.drawing(t, q)
    }
    #[inline(always)]
    fn initial(&self) -> sim_kernel::Initial<[S; 3]> {
        self.initial()
    }
}
