/// A two-wheeled cart under the torques of its motors, against their friction.
///
/// The fields are its parameters and inputs, in SI units; the methods are its kernels.
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
/// coordinates = [x; y; psi; left; right]
/// multipliers = [
///     lambda_left_rolls;
///     lambda_right_rolls;
///     lambda_sideways
/// ]
/// constraints = 0
/// [
///     M + 2*m, 0, 0, 0, 0, cos(psi), cos(psi), -sin(psi);
///     0, M + 2*m, 0, 0, 0, sin(psi), sin(psi), cos(psi);
///     0, 0, mass_matrix[3, 3], 0, 0, -b, b, 0;
///     0, 0, 0, m*r^2/2, 0, -r, 0, 0;
///     0, 0, 0, 0, m*r^2/2, 0, -r, 0;
///     cos(psi), sin(psi), -b, -r, 0, 0, 0, 0;
///     cos(psi), sin(psi), b, 0, -r, 0, 0, 0;
///     -sin(psi), cos(psi), 0, 0, 0, 0, 0, 0
/// ] * [
///     x_ddot;
///     y_ddot;
///     psi_ddot;
///     left_ddot;
///     right_ddot;
///     lambda_left_rolls;
///     lambda_right_rolls;
///     lambda_sideways
/// ] = [
///     0;
///     0;
///     0;
///     tau_left - c*left_dot;
///     tau_right - c*right_dot;
///     -constraint_convective[1];
///     -constraint_convective[2];
///     y_dot*psi_dot*sin(psi) + x_dot*psi_dot*cos(psi)
/// ]
///
/// mass_matrix = [
///     M + 2*m, 0, 0, 0, 0;
///     0, M + 2*m, 0, 0, 0;
///     0, 0, mass_matrix[3, 3], 0, 0;
///     0, 0, 0, m*r^2/2, 0;
///     0, 0, 0, 0, m*r^2/2
/// ]
/// mass_matrix[3, 3] = J + m*r^2/2 + 2*m*b^2
///
/// convective_forces = [0; 0; 0; 0; 0]
///
/// generalized_forces = [
///     0;
///     0;
///     0;
///     tau_left - c*left_dot;
///     tau_right - c*right_dot
/// ]
///
/// constraints = [0; 0; 0]
///
/// constraint_jacobian = [
///     cos(psi), sin(psi), -b, -r, 0;
///     cos(psi), sin(psi), b, 0, -r;
///     -sin(psi), cos(psi), 0, 0, 0
/// ]
///
/// constraint_convective = [
///     constraint_convective[1];
///     constraint_convective[2];
///     -y_dot*psi_dot*sin(psi) - x_dot*psi_dot*cos(psi)
/// ]
/// constraint_convective[1] = (b*psi_dot^2*sin(psi) + r*psi_dot*left_dot*sin(psi))*cos(psi)
///     - psi_dot*(x_dot - b*psi_dot*cos(psi) - r*left_dot*cos(psi))*sin(psi)
///     + psi_dot*(y_dot - b*psi_dot*sin(psi) - r*left_dot*sin(psi))*cos(psi)
///     - (b*psi_dot^2*cos(psi) + r*psi_dot*left_dot*cos(psi))*sin(psi)
/// constraint_convective[2] = psi_dot*(y_dot + b*psi_dot*sin(psi) - r*right_dot*sin(psi))*cos(psi)
///     - psi_dot*(x_dot + b*psi_dot*cos(psi) - r*right_dot*cos(psi))*sin(psi)
///     - (b*psi_dot^2*sin(psi) - r*psi_dot*right_dot*sin(psi))*cos(psi)
///     + (b*psi_dot^2*cos(psi) - r*psi_dot*right_dot*cos(psi))*sin(psi)
/// ```
#[allow(non_snake_case)]
#[derive(
    ::core::clone::Clone,
    ::core::marker::Copy,
    ::core::fmt::Debug,
    ::core::cmp::PartialEq
)]
pub struct Rover<S = ::core::primitive::f64> {
    /// Mass of the cart without wheels, in the middle of the axle, in `kg`.
    pub M: S,
    /// Its moment of inertia about the vertical, in `kg*m^2`.
    pub J: S,
    /// Mass of a wheel, in `kg`.
    pub m: S,
    /// Radius of the wheels, in `m`.
    pub r: S,
    /// Half of their distance, in `m`.
    pub b: S,
    /// Friction of the motors, in `N*m*s`.
    pub c: S,
    /// In `m/s^2`.
    pub g: S,
    /// In `N*m`.
    pub tau_left: sim_kernel::Input<S>,
    /// In `N*m`.
    pub tau_right: sim_kernel::Input<S>,
}
impl<S: sim_kernel::Scalar> ::core::default::Default for Rover<S> {
    /// The declared values.
    fn default() -> Self {
        <Self as sim_kernel::Mechanism<S>>::defaults()
    }
}
/// Coordinates of [`Rover`] by name, in SI units; also for their speeds and accelerations.
#[allow(non_snake_case)]
#[derive(
    ::core::clone::Clone,
    ::core::marker::Copy,
    ::core::fmt::Debug,
    ::core::cmp::PartialEq
)]
pub struct RoverCoordinates<S = ::core::primitive::f64> {
    /// Middle of the axle, in `m`.
    pub x: S,
    /// In `m`.
    pub y: S,
    /// Direction, in `rad`.
    pub psi: S,
    /// Turn of the left wheel, in `rad`.
    pub left: S,
    /// Turn of the right wheel, in `rad`.
    pub right: S,
}
impl<S: sim_kernel::Scalar> ::core::convert::From<[S; 5]> for RoverCoordinates<S> {
    fn from(values: [S; 5]) -> Self {
        Self {
            x: values[0],
            y: values[1],
            psi: values[2],
            left: values[3],
            right: values[4],
        }
    }
}
impl<S: sim_kernel::Scalar> ::core::convert::From<RoverCoordinates<S>> for [S; 5] {
    fn from(record: RoverCoordinates<S>) -> Self {
        [record.x, record.y, record.psi, record.left, record.right]
    }
}
/// Outputs of [`Rover`] by name, in SI units.
#[allow(non_snake_case)]
#[derive(
    ::core::clone::Clone,
    ::core::marker::Copy,
    ::core::fmt::Debug,
    ::core::cmp::PartialEq
)]
pub struct RoverOutputs<S = ::core::primitive::f64> {
    /// speed, in `m/s`.
    pub speed: S,
    /// rate of turning, in `rad/s`.
    pub turning: S,
    /// force of the wheels on the ground, sideways, in `N`.
    pub side_force: S,
}
impl<S: sim_kernel::Scalar> ::core::convert::From<[S; 3]> for RoverOutputs<S> {
    fn from(values: [S; 3]) -> Self {
        Self {
            speed: values[0],
            turning: values[1],
            side_force: values[2],
        }
    }
}
impl<S: sim_kernel::Scalar> ::core::convert::From<RoverOutputs<S>> for [S; 3] {
    fn from(record: RoverOutputs<S>) -> Self {
        [record.speed, record.turning, record.side_force]
    }
}
/// Rates of the outputs of [`Rover`] by name, in SI units.
#[allow(non_snake_case)]
#[derive(
    ::core::clone::Clone,
    ::core::marker::Copy,
    ::core::fmt::Debug,
    ::core::cmp::PartialEq
)]
pub struct RoverOutputRates<S = ::core::primitive::f64> {
    /// Rate of `speed`.
    pub speed: S,
    /// Rate of `turning`.
    pub turning: S,
}
impl<S: sim_kernel::Scalar> ::core::convert::From<[S; 2]> for RoverOutputRates<S> {
    fn from(values: [S; 2]) -> Self {
        Self {
            speed: values[0],
            turning: values[1],
        }
    }
}
impl<S: sim_kernel::Scalar> ::core::convert::From<RoverOutputRates<S>> for [S; 2] {
    fn from(record: RoverOutputRates<S>) -> Self {
        [record.speed, record.turning]
    }
}
/// What the equations of motion need of the parameters of [`Rover`], from [`Rover::prepare`]; its methods are the kernels of each step.
#[allow(non_snake_case)]
#[derive(
    ::core::clone::Clone,
    ::core::marker::Copy,
    ::core::fmt::Debug,
    ::core::cmp::PartialEq
)]
pub struct RoverPrepared<S = ::core::primitive::f64> {
    mass_x_x: S,
    r: S,
    b: S,
    mass_left_left: S,
    mass_psi_psi: S,
    c: S,
    inverse_left: S,
    minus_l_lambda_left_rolls_left: S,
    minus_l_lambda_left_rolls_psi: S,
    k: S,
    inverse_x: S,
    k_2: S,
    k_3: S,
    k_4: S,
    k_5: S,
    k_6: S,
    /// In `N*m`.
    pub tau_left: sim_kernel::Input<S>,
    /// In `N*m`.
    pub tau_right: sim_kernel::Input<S>,
}
#[allow(non_snake_case, unused_variables, unused_parens, clippy::all, clippy::pedantic)]
impl<S: sim_kernel::Scalar> Rover<S> {
    /// What the equations of motion need of the parameters, computed once for a set of parameters.
    ///
    /// Operations: 5 additions, 13 multiplications, 3 divisions.
    #[inline]
    pub fn prepare(&self) -> RoverPrepared<S> {
        let w = S::from_f64(2.0) * self.m;
        let mass_x_x = self.M + w;
        let mass_left_left = self.m * S::from_f64(0.5) * self.r * self.r;
        let mass_psi_psi = self.J + mass_left_left + w * self.b * self.b;
        let inverse_mass_left_left = S::from_f64(1.0) / mass_left_left;
        let w_2 = self.r * inverse_mass_left_left;
        let w_3 = self.b * (S::from_f64(1.0) / mass_psi_psi);
        let w_4 = self.b * w_3;
        let w_5 = self.r * w_2;
        RoverPrepared {
            mass_x_x: mass_x_x,
            r: self.r,
            b: self.b,
            mass_left_left: mass_left_left,
            mass_psi_psi: mass_psi_psi,
            c: self.c,
            inverse_left: inverse_mass_left_left,
            minus_l_lambda_left_rolls_left: w_2,
            minus_l_lambda_left_rolls_psi: w_3,
            k: w_4,
            inverse_x: S::from_f64(1.0) / mass_x_x,
            k_2: w_5 + w_4,
            k_3: w_4 + w_5,
            k_4: S::from_f64(2.0) * self.b,
            k_5: self.c * w_2,
            k_6: self.c * inverse_mass_left_left,
            tau_left: self.tau_left,
            tau_right: self.tau_right,
        }
    }
    /// Mass matrix `T_q' M T_q`, 5 x 5, symmetric, in SI units.
    ///
    /// Operations: 3 additions, 6 multiplications.
    #[inline]
    pub fn mass_matrix(&self, t: S, q: &[S; 5]) -> [[S; 5]; 5] {
        let w = S::from_f64(2.0) * self.m;
        let mass_x_x = self.M + w;
        let mass_left_left = self.m * S::from_f64(0.5) * self.r * self.r;
        [
            [
                mass_x_x,
                S::from_f64(0.0),
                S::from_f64(0.0),
                S::from_f64(0.0),
                S::from_f64(0.0),
            ],
            [
                S::from_f64(0.0),
                mass_x_x,
                S::from_f64(0.0),
                S::from_f64(0.0),
                S::from_f64(0.0),
            ],
            [
                S::from_f64(0.0),
                S::from_f64(0.0),
                self.J + mass_left_left + w * self.b * self.b,
                S::from_f64(0.0),
                S::from_f64(0.0),
            ],
            [
                S::from_f64(0.0),
                S::from_f64(0.0),
                S::from_f64(0.0),
                mass_left_left,
                S::from_f64(0.0),
            ],
            [
                S::from_f64(0.0),
                S::from_f64(0.0),
                S::from_f64(0.0),
                S::from_f64(0.0),
                mass_left_left,
            ],
        ]
    }
    /// Convective forces `T_q' M g`, 5, with `g = (T_q q' + T_t)_q q' + (..)_t`: joules per unit of each coordinate.
    ///
    /// Operations: none.
    #[inline]
    pub fn convective_forces(&self, t: S, q: &[S; 5], qd: &[S; 5]) -> [S; 5] {
        [
            S::from_f64(0.0),
            S::from_f64(0.0),
            S::from_f64(0.0),
            S::from_f64(0.0),
            S::from_f64(0.0),
        ]
    }
    /// Generalised forces `T_q' F`, 5: joules per unit of each coordinate.
    ///
    /// Operations: 2 additions, 2 multiplications.
    #[inline]
    pub fn generalized_forces(&self, t: S, q: &[S; 5], qd: &[S; 5]) -> [S; 5] {
        let [_, _, _, left_dot, right_dot] = *qd;
        [
            S::from_f64(0.0),
            S::from_f64(0.0),
            S::from_f64(0.0),
            self.tau_left.or(S::from_f64(0.2)) - left_dot * self.c,
            self.tau_right.or(S::from_f64(0.3)) - self.c * right_dot,
        ]
    }
    /// Constraints `C`, 3, in SI units; zero throughout the motion.
    ///
    /// Operations: none.
    #[inline]
    pub fn constraints(&self, t: S, q: &[S; 5]) -> [S; 3] {
        [S::from_f64(0.0), S::from_f64(0.0), S::from_f64(0.0)]
    }
    /// The sum of the magnitudes of the terms of `C`, 3, in SI units: what its rounding is relative to.
    ///
    /// Operations: none.
    #[inline]
    pub fn constraint_magnitudes(&self, t: S, q: &[S; 5]) -> [S; 3] {
        [S::from_f64(0.0), S::from_f64(0.0), S::from_f64(0.0)]
    }
    /// Constraint Jacobian `C_q`, 3 x 5: units of each constraint per unit of each coordinate.
    ///
    /// Operations: 4 additions, 1 sine-cosine pair.
    #[inline]
    pub fn constraint_jacobian(&self, t: S, q: &[S; 5]) -> [[S; 5]; 3] {
        let [_, _, psi, _, _] = *q;
        let ([left_rolls_by_y], [left_rolls_by_x]) = S::sin_cos_each([psi]);
        [
            [left_rolls_by_x, left_rolls_by_y, -self.b, -self.r, S::from_f64(0.0)],
            [left_rolls_by_x, left_rolls_by_y, self.b, S::from_f64(0.0), -self.r],
            [
                -left_rolls_by_y,
                left_rolls_by_x,
                S::from_f64(0.0),
                S::from_f64(0.0),
                S::from_f64(0.0),
            ],
        ]
    }
    /// `C_t`, 3, units of `C` per second: the speeds obey `C_q q' + C_t = 0`.
    ///
    /// Operations: none.
    #[inline]
    pub fn constraint_time_derivative(&self, t: S, q: &[S; 5]) -> [S; 3] {
        [S::from_f64(0.0), S::from_f64(0.0), S::from_f64(0.0)]
    }
    /// `(C_q q' + C_t)_q q' + (..)_t`, 3, units of `C` per second squared: the part of `C''` without accelerations.
    ///
    /// Operations: 3 additions, 6 multiplications, 1 sine-cosine pair.
    #[inline]
    pub fn constraint_convective(&self, t: S, q: &[S; 5], qd: &[S; 5]) -> [S; 3] {
        let [_, _, psi, _, _] = *q;
        let [x_dot, y_dot, psi_dot, _, _] = *qd;
        let ([left_rolls_by_y], [left_rolls_by_x]) = S::sin_cos_each([psi]);
        let w = psi_dot * (left_rolls_by_x * y_dot - left_rolls_by_y * x_dot);
        [w, w, -(psi_dot * (left_rolls_by_y * y_dot + left_rolls_by_x * x_dot))]
    }
    /// `C` (3), `C_q` (3 x 5) and `C_t` (3) together, in SI units, for projection.
    ///
    /// Operations: 4 additions, 1 sine-cosine pair.
    #[inline]
    pub fn constraint_linearization(
        &self,
        t: S,
        q: &[S; 5],
    ) -> sim_kernel::ConstraintLinearization<[S; 3], [[S; 5]; 3]> {
        let [_, _, psi, _, _] = *q;
        let ([left_rolls_by_y], [left_rolls_by_x]) = S::sin_cos_each([psi]);
        sim_kernel::ConstraintLinearization {
            values: [S::from_f64(0.0), S::from_f64(0.0), S::from_f64(0.0)],
            jacobian: [
                [left_rolls_by_x, left_rolls_by_y, -self.b, -self.r, S::from_f64(0.0)],
                [left_rolls_by_x, left_rolls_by_y, self.b, S::from_f64(0.0), -self.r],
                [
                    -left_rolls_by_y,
                    left_rolls_by_x,
                    S::from_f64(0.0),
                    S::from_f64(0.0),
                    S::from_f64(0.0),
                ],
            ],
            time_derivative: [S::from_f64(0.0), S::from_f64(0.0), S::from_f64(0.0)],
        }
    }
    /// Kinetic energy `v' M v / 2`, in joules.
    ///
    /// Operations: 13 additions, 22 multiplications, 1 sine-cosine pair.
    #[inline]
    pub fn kinetic_energy(&self, t: S, q: &[S; 5], qd: &[S; 5]) -> S {
        let [_, _, psi, _, _] = *q;
        let [x_dot, y_dot, psi_dot, left_dot, right_dot] = *qd;
        let ([left_rolls_by_y], [left_rolls_by_x]) = S::sin_cos_each([psi]);
        let w = psi_dot * self.b;
        let w_2 = left_rolls_by_x * w;
        let w_3 = x_dot - w_2;
        let w_4 = w * left_rolls_by_y;
        let w_5 = y_dot - w_4;
        let w_6 = x_dot + w_2;
        let w_7 = y_dot + w_4;
        let w_8 = S::from_f64(0.5) * self.m
            * (w_3 * w_3 + w_5 * w_5 + w_6 * w_6 + w_7 * w_7);
        let w_9 = self.m * S::from_f64(0.25) * self.r * self.r;
        w_8 + S::from_f64(0.5) * self.M * (x_dot * x_dot + y_dot * y_dot)
            + w_9 * (left_dot * left_dot + right_dot * right_dot)
            + psi_dot * psi_dot * (S::from_f64(0.5) * self.J + w_9)
    }
    /// Power of loads and drives, `F' v + lambda' C_t + T_t' (M x'' - F)`, in watts.
    ///
    /// Operations: 3 additions, 4 multiplications.
    #[inline]
    pub fn power(
        &self,
        t: S,
        q: &[S; 5],
        qd: &[S; 5],
        qdd: &[S; 5],
        lambda: &[S; 3],
    ) -> S {
        let [_, _, _, left_dot, right_dot] = *qd;
        left_dot * (self.tau_left.or(S::from_f64(0.2)) - left_dot * self.c)
            + right_dot * (self.tau_right.or(S::from_f64(0.3)) - self.c * right_dot)
    }
    /// Outputs, 3, in SI units.
    ///
    /// Operations: 1 addition, 2 multiplications, 1 sine-cosine pair.
    #[inline]
    pub fn outputs(
        &self,
        t: S,
        q: &[S; 5],
        qd: &[S; 5],
        qdd: &[S; 5],
        lambda: &[S; 3],
    ) -> RoverOutputs<S> {
        let [_, _, psi, _, _] = *q;
        let [x_dot, y_dot, psi_dot, _, _] = *qd;
        let [_, _, lambda_sideways] = *lambda;
        let ([left_rolls_by_y], [left_rolls_by_x]) = S::sin_cos_each([psi]);
        [x_dot * left_rolls_by_x + y_dot * left_rolls_by_y, psi_dot, lambda_sideways]
            .into()
    }
    /// Rates of the outputs that depend on neither accelerations nor multipliers, 2, in SI units per second.
    ///
    /// Operations: 3 additions, 4 multiplications, 1 sine-cosine pair.
    #[inline]
    pub fn output_rates(
        &self,
        t: S,
        q: &[S; 5],
        qd: &[S; 5],
        qdd: &[S; 5],
    ) -> RoverOutputRates<S> {
        let [_, _, psi, _, _] = *q;
        let [x_dot, y_dot, psi_dot, _, _] = *qd;
        let [x_ddot, y_ddot, psi_ddot, _, _] = *qdd;
        let ([left_rolls_by_y], [left_rolls_by_x]) = S::sin_cos_each([psi]);
        [
            left_rolls_by_x * (x_ddot + psi_dot * y_dot)
                + left_rolls_by_y * (y_ddot - x_dot * psi_dot),
            psi_ddot,
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
        lambda: &[S; 3],
    ) -> [S; 0] {
        []
    }
    /// The numbers of each shape of the drawing, in metres and radians.
    ///
    /// Operations: 23 additions, 12 multiplications, 3 sine-cosine pairs.
    #[inline]
    pub fn drawing(&self, t: S, q: &[S; 5]) -> [S; 53] {
        let [x, y, psi, left, right] = *q;
        let (
            [left_rolls_by_y,
            sin_left,
            sin_right,
            ],
            [left_rolls_by_x,
            cos_left,
            cos_right,
            ],
        ) = S::sin_cos_each([psi, left, right]);
        let w = self.b * left_rolls_by_y;
        let L_x = x - w;
        let w_2 = self.b * left_rolls_by_x;
        let L_y = y + w_2;
        let sideways_by_x = -left_rolls_by_y;
        let Q_x = x + w;
        let Q_y = y - w_2;
        let w_3 = left_rolls_by_x * self.r;
        let w_4 = left_rolls_by_y * self.r;
        [
            -S::from_f64(1.0),
            -S::from_f64(1.0),
            S::from_f64(0.0),
            S::from_f64(3.0),
            -S::from_f64(1.0),
            S::from_f64(0.0),
            S::from_f64(3.0),
            S::from_f64(3.0),
            S::from_f64(0.0),
            -S::from_f64(1.0),
            S::from_f64(3.0),
            S::from_f64(0.0),
            -S::from_f64(1.0),
            -S::from_f64(1.0),
            S::from_f64(0.0),
            L_x,
            L_y,
            self.r,
            self.r,
            sideways_by_x,
            left_rolls_by_x,
            S::from_f64(0.0),
            Q_x,
            Q_y,
            self.r,
            self.r,
            sideways_by_x,
            left_rolls_by_x,
            S::from_f64(0.0),
            L_x,
            L_y,
            self.r,
            x - w + cos_left * w_3,
            y + w_2 + cos_left * w_4,
            self.r * (S::from_f64(1.0) - sin_left),
            Q_x,
            Q_y,
            self.r,
            x + w + w_3 * cos_right,
            y - w_2 + w_4 * cos_right,
            self.r * (S::from_f64(1.0) - sin_right),
            L_x,
            L_y,
            self.r,
            x + left_rolls_by_x * S::from_f64(0.3),
            y + left_rolls_by_y * S::from_f64(0.3),
            self.r,
            Q_x,
            Q_y,
            self.r,
            L_x,
            L_y,
            self.r,
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
                S::from_f64(0.0),
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
            ],
        }
    }
    /// The inputs, 2, in SI units: what each is held at, or its declared course.
    ///
    /// Operations: none.
    #[inline]
    pub fn input_values(&self, t: S, q: &[S; 5]) -> [S; 2] {
        [self.tau_left.or(S::from_f64(0.2)), self.tau_right.or(S::from_f64(0.3))]
    }
    /// [`RoverPrepared::dynamics`] once; for many calls with the same parameters [`Self::prepare`] first.
    #[inline]
    pub fn dynamics(
        &self,
        t: S,
        q: &[S; 5],
        qd: &[S; 5],
    ) -> sim_kernel::Dynamics<S, [S; 5], [S; 3]> {
        self.prepare().dynamics(t, q, qd)
    }
    /// [`RoverPrepared::dynamics_jacobian`] once; for many calls with the same parameters [`Self::prepare`] first.
    #[inline]
    pub fn dynamics_jacobian(
        &self,
        t: S,
        q: &[S; 5],
        qd: &[S; 5],
    ) -> sim_kernel::DynamicsJacobian<S, [[S; 5]; 5], [[S; 5]; 3]> {
        self.prepare().dynamics_jacobian(t, q, qd)
    }
}
#[allow(non_snake_case, unused_variables, unused_parens, clippy::all, clippy::pedantic)]
impl<S: sim_kernel::Scalar> RoverPrepared<S> {
    /// Accelerations (5), multipliers (3) and power, from
    ///
    /// ```text
    /// [ T_q' M T_q   C_q' ] [ q''    ]   [ T_q' (F - M g)                      ]
    /// [ C_q          0    ] [ lambda ] = [ -(C_q q' + C_t)_q q' - (..)_t       ]
    /// ```
    ///
    /// by an elimination planned from the structure of the system. Where `refused` is set a pivot was too small and nothing else holds: solve that state from the other kernels.
    ///
    /// Operations: 35 additions, 46 multiplications, 3 divisions, 1 sine-cosine pair.
    #[inline(always)]
    pub fn dynamics(
        &self,
        t: S,
        q: &[S; 5],
        qd: &[S; 5],
    ) -> sim_kernel::Dynamics<S, [S; 5], [S; 3]> {
        let [_, _, psi, _, _] = *q;
        let [x_dot, y_dot, psi_dot, left_dot, right_dot] = *qd;
        let rhs_left = self.tau_left.or(S::from_f64(0.2)) - left_dot * self.c;
        let rhs_right = self.tau_right.or(S::from_f64(0.3)) - self.c * right_dot;
        let ([left_rolls_by_y], [left_rolls_by_x]) = S::sin_cos_each([psi]);
        let w = psi_dot * (left_rolls_by_x * y_dot - left_rolls_by_y * x_dot);
        let rhs_lambda_left_rolls = rhs_left * self.minus_l_lambda_left_rolls_left - w;
        let l_lambda_left_rolls_x = left_rolls_by_x * self.inverse_x;
        let w_2 = left_rolls_by_x * l_lambda_left_rolls_x;
        let minus_l_lambda_sideways_x = left_rolls_by_y * self.inverse_x;
        let w_3 = left_rolls_by_y * minus_l_lambda_sideways_x;
        let minus_pivot_lambda_left_rolls = self.k_2 + w_2 + w_3;
        let minus_inverse_lambda_left_rolls = S::from_f64(1.0)
            / minus_pivot_lambda_left_rolls;
        let k_lambda_right_rolls_lambda_left_rolls = self.k - w_2 - w_3;
        let minus_l_lambda_right_rolls_lambda_left_rolls = minus_inverse_lambda_left_rolls
            * k_lambda_right_rolls_lambda_left_rolls;
        let rhs_lambda_right_rolls = rhs_right * self.minus_l_lambda_left_rolls_left - w
            + minus_l_lambda_right_rolls_lambda_left_rolls * rhs_lambda_left_rolls;
        let w_4 = left_rolls_by_x * minus_l_lambda_sideways_x;
        let w_5 = left_rolls_by_y * l_lambda_left_rolls_x;
        let k_lambda_sideways_lambda_left_rolls = w_4 - w_5;
        let minus_l_lambda_sideways_lambda_left_rolls = minus_inverse_lambda_left_rolls
            * k_lambda_sideways_lambda_left_rolls;
        let k_lambda_sideways_lambda_right_rolls = w_4 - w_5
            + k_lambda_right_rolls_lambda_left_rolls
                * minus_l_lambda_sideways_lambda_left_rolls;
        let w_6 = self.k_3 + w_2 + w_3;
        let pivot_lambda_right_rolls = k_lambda_right_rolls_lambda_left_rolls
            * minus_l_lambda_right_rolls_lambda_left_rolls - w_6;
        let w_7 = w_3 + w_2;
        let inverse_lambda_right_rolls = S::from_f64(1.0) / pivot_lambda_right_rolls;
        let l_lambda_sideways_lambda_right_rolls = inverse_lambda_right_rolls
            * k_lambda_sideways_lambda_right_rolls;
        let pivot_lambda_sideways = k_lambda_sideways_lambda_left_rolls
            * minus_l_lambda_sideways_lambda_left_rolls - w_7
            - k_lambda_sideways_lambda_right_rolls
                * l_lambda_sideways_lambda_right_rolls;
        let lambda_sideways = S::from_f64(1.0) / pivot_lambda_sideways
            * (psi_dot * (left_rolls_by_y * y_dot + left_rolls_by_x * x_dot)
                + minus_l_lambda_sideways_lambda_left_rolls * rhs_lambda_left_rolls
                - l_lambda_sideways_lambda_right_rolls * rhs_lambda_right_rolls);
        let lambda_right_rolls = inverse_lambda_right_rolls * rhs_lambda_right_rolls
            - l_lambda_sideways_lambda_right_rolls * lambda_sideways;
        let lambda_left_rolls = minus_l_lambda_right_rolls_lambda_left_rolls
            * lambda_right_rolls
            - minus_inverse_lambda_left_rolls * rhs_lambda_left_rolls
            + minus_l_lambda_sideways_lambda_left_rolls * lambda_sideways;
        sim_kernel::Dynamics {
            accelerations: [
                minus_l_lambda_sideways_x * lambda_sideways
                    - l_lambda_left_rolls_x * lambda_left_rolls
                    - l_lambda_left_rolls_x * lambda_right_rolls,
                -(minus_l_lambda_sideways_x * lambda_left_rolls
                    + minus_l_lambda_sideways_x * lambda_right_rolls
                    + l_lambda_left_rolls_x * lambda_sideways),
                self.minus_l_lambda_left_rolls_psi * lambda_left_rolls
                    - self.minus_l_lambda_left_rolls_psi * lambda_right_rolls,
                rhs_left * self.inverse_left
                    + self.minus_l_lambda_left_rolls_left * lambda_left_rolls,
                rhs_right * self.inverse_left
                    + self.minus_l_lambda_left_rolls_left * lambda_right_rolls,
            ],
            multipliers: [lambda_left_rolls, lambda_right_rolls, lambda_sideways],
            power: left_dot * rhs_left + right_dot * rhs_right,
            refused: sim_kernel::pivot_is_refused(
                self.mass_left_left,
                self.mass_left_left,
            ) | sim_kernel::pivot_is_refused(self.mass_psi_psi, self.mass_psi_psi)
                | sim_kernel::pivot_is_refused(self.mass_x_x, self.mass_x_x)
                | sim_kernel::pivot_is_refused(self.mass_x_x, self.mass_x_x)
                | sim_kernel::pivot_is_refused(self.mass_left_left, self.mass_left_left)
                | sim_kernel::pivot_is_refused(
                    -minus_pivot_lambda_left_rolls,
                    minus_pivot_lambda_left_rolls,
                ) | sim_kernel::pivot_is_refused(pivot_lambda_right_rolls, w_6)
                | sim_kernel::pivot_is_refused(pivot_lambda_sideways, w_7),
        }
    }
    /// The derivatives of accelerations (5 rows) and multipliers (3 rows) with respect to coordinates and speeds (5 columns each): with the equations of motion as `K z = r`, the solutions of `K dz = dr - dK z`. Where `refused` is set a pivot was too small and nothing else holds.
    ///
    /// Operations: 137 additions, 187 multiplications, 3 divisions, 1 sine-cosine pair.
    #[inline]
    pub fn dynamics_jacobian(
        &self,
        t: S,
        q: &[S; 5],
        qd: &[S; 5],
    ) -> sim_kernel::DynamicsJacobian<S, [[S; 5]; 5], [[S; 5]; 3]> {
        let [_, _, psi, _, _] = *q;
        let [x_dot, y_dot, psi_dot, left_dot, right_dot] = *qd;
        let ([left_rolls_by_y], [left_rolls_by_x]) = S::sin_cos_each([psi]);
        let w = psi_dot * (left_rolls_by_x * y_dot - left_rolls_by_y * x_dot);
        let rhs_lambda_left_rolls = (self.tau_left.or(S::from_f64(0.2))
            - left_dot * self.c) * self.minus_l_lambda_left_rolls_left - w;
        let l_lambda_left_rolls_x = left_rolls_by_x * self.inverse_x;
        let w_2 = left_rolls_by_x * l_lambda_left_rolls_x;
        let minus_l_lambda_sideways_x = left_rolls_by_y * self.inverse_x;
        let w_3 = left_rolls_by_y * minus_l_lambda_sideways_x;
        let minus_pivot_lambda_left_rolls = self.k_2 + w_2 + w_3;
        let minus_inverse_lambda_left_rolls = S::from_f64(1.0)
            / minus_pivot_lambda_left_rolls;
        let k_lambda_right_rolls_lambda_left_rolls = self.k - w_2 - w_3;
        let minus_l_lambda_right_rolls_lambda_left_rolls = minus_inverse_lambda_left_rolls
            * k_lambda_right_rolls_lambda_left_rolls;
        let rhs_lambda_right_rolls = (self.tau_right.or(S::from_f64(0.3))
            - self.c * right_dot) * self.minus_l_lambda_left_rolls_left - w
            + minus_l_lambda_right_rolls_lambda_left_rolls * rhs_lambda_left_rolls;
        let w_4 = left_rolls_by_y * y_dot + left_rolls_by_x * x_dot;
        let w_5 = left_rolls_by_x * minus_l_lambda_sideways_x;
        let w_6 = left_rolls_by_y * l_lambda_left_rolls_x;
        let k_lambda_sideways_lambda_left_rolls = w_5 - w_6;
        let minus_l_lambda_sideways_lambda_left_rolls = minus_inverse_lambda_left_rolls
            * k_lambda_sideways_lambda_left_rolls;
        let k_lambda_sideways_lambda_right_rolls = w_5 - w_6
            + k_lambda_right_rolls_lambda_left_rolls
                * minus_l_lambda_sideways_lambda_left_rolls;
        let w_7 = self.k_3 + w_2 + w_3;
        let pivot_lambda_right_rolls = k_lambda_right_rolls_lambda_left_rolls
            * minus_l_lambda_right_rolls_lambda_left_rolls - w_7;
        let w_8 = w_3 + w_2;
        let inverse_lambda_right_rolls = S::from_f64(1.0) / pivot_lambda_right_rolls;
        let l_lambda_sideways_lambda_right_rolls = inverse_lambda_right_rolls
            * k_lambda_sideways_lambda_right_rolls;
        let pivot_lambda_sideways = k_lambda_sideways_lambda_left_rolls
            * minus_l_lambda_sideways_lambda_left_rolls - w_8
            - k_lambda_sideways_lambda_right_rolls
                * l_lambda_sideways_lambda_right_rolls;
        let inverse_lambda_sideways = S::from_f64(1.0) / pivot_lambda_sideways;
        let lambda_sideways = inverse_lambda_sideways
            * (psi_dot * w_4
                + minus_l_lambda_sideways_lambda_left_rolls * rhs_lambda_left_rolls
                - l_lambda_sideways_lambda_right_rolls * rhs_lambda_right_rolls);
        let lambda_right_rolls = inverse_lambda_right_rolls * rhs_lambda_right_rolls
            - l_lambda_sideways_lambda_right_rolls * lambda_sideways;
        let lambda_left_rolls = minus_l_lambda_right_rolls_lambda_left_rolls
            * lambda_right_rolls
            - minus_inverse_lambda_left_rolls * rhs_lambda_left_rolls
            + minus_l_lambda_sideways_lambda_left_rolls * lambda_sideways;
        let w_9 = lambda_right_rolls + lambda_left_rolls;
        let w_10 = left_rolls_by_y * w_9 + left_rolls_by_x * lambda_sideways;
        let w_21 = left_rolls_by_y * lambda_sideways - left_rolls_by_x * w_9;
        let minus_y_ddot = minus_l_lambda_sideways_x * lambda_left_rolls
            + minus_l_lambda_sideways_x * lambda_right_rolls
            + l_lambda_left_rolls_x * lambda_sideways;
        let x_ddot = minus_l_lambda_sideways_x * lambda_sideways
            - l_lambda_left_rolls_x * lambda_left_rolls
            - l_lambda_left_rolls_x * lambda_right_rolls;
        let w_11 = left_rolls_by_x * minus_y_ddot;
        let w_12 = left_rolls_by_y * x_ddot;
        let w_13 = self.b * psi_dot;
        let w_14 = self.r * right_dot;
        let w_15 = w_13 - w_14;
        let w_16 = left_rolls_by_x * w_15;
        let w_18 = left_rolls_by_y * w_15;
        let w_17 = x_dot + w_16;
        let w_19 = y_dot + w_18;
        let w_20 = l_lambda_left_rolls_x * w_10;
        let w_22 = minus_l_lambda_sideways_x * w_21;
        let w_23 = self.r * left_dot;
        let w_24 = w_13 + w_23;
        let w_25 = left_rolls_by_x * w_24;
        let w_27 = left_rolls_by_y * w_24;
        let w_26 = x_dot - w_25;
        let w_28 = y_dot - w_27;
        let w_29 = psi_dot
            * (left_rolls_by_x * (w_25 + w_26) + left_rolls_by_y * (w_27 + w_28)) + w_11
            + w_12 - w_20 - w_22;
        let w_30 = w_11 + w_12
            + psi_dot
                * (left_rolls_by_x * (w_17 - w_16) + left_rolls_by_y * (w_19 - w_18))
            - w_20 - w_22 + minus_l_lambda_right_rolls_lambda_left_rolls * w_29;
        let w_31 = inverse_lambda_sideways
            * (w + left_rolls_by_x * x_ddot - left_rolls_by_y * minus_y_ddot
                + minus_l_lambda_sideways_x * w_10 - l_lambda_left_rolls_x * w_21
                + minus_l_lambda_sideways_lambda_left_rolls * w_29
                - l_lambda_sideways_lambda_right_rolls * w_30);
        let w_32 = inverse_lambda_right_rolls * w_30
            - l_lambda_sideways_lambda_right_rolls * w_31;
        let w_33 = minus_l_lambda_right_rolls_lambda_left_rolls * w_32
            - minus_inverse_lambda_left_rolls * w_29
            + minus_l_lambda_sideways_lambda_left_rolls * w_31;
        let w_34 = left_rolls_by_x * psi_dot;
        let w_35 = left_rolls_by_y * psi_dot;
        let w_36 = w_35 + minus_l_lambda_right_rolls_lambda_left_rolls * w_35;
        let w_37 = inverse_lambda_sideways
            * (w_34 + minus_l_lambda_sideways_lambda_left_rolls * w_35
                - l_lambda_sideways_lambda_right_rolls * w_36);
        let w_38 = inverse_lambda_right_rolls * w_36
            - l_lambda_sideways_lambda_right_rolls * w_37;
        let w_39 = minus_l_lambda_right_rolls_lambda_left_rolls * w_38
            - minus_inverse_lambda_left_rolls * w_35
            + minus_l_lambda_sideways_lambda_left_rolls * w_37;
        let w_40 = w_34 + minus_l_lambda_right_rolls_lambda_left_rolls * w_34;
        let w_41 = inverse_lambda_sideways
            * (w_35 - minus_l_lambda_sideways_lambda_left_rolls * w_34
                + l_lambda_sideways_lambda_right_rolls * w_40);
        let w_42 = inverse_lambda_right_rolls * w_40
            + l_lambda_sideways_lambda_right_rolls * w_41;
        let w_43 = minus_inverse_lambda_left_rolls * w_34
            - minus_l_lambda_right_rolls_lambda_left_rolls * w_42
            + minus_l_lambda_sideways_lambda_left_rolls * w_41;
        let w_44 = psi_dot * self.k_4;
        let w_45 = w_23 + w_44;
        let w_46 = left_rolls_by_y * (w_26 + left_rolls_by_x * w_45)
            - left_rolls_by_x * (w_28 + left_rolls_by_y * w_45);
        let w_47 = w_44 - w_14;
        let w_48 = left_rolls_by_y * (w_17 - left_rolls_by_x * w_47)
            + left_rolls_by_x * (left_rolls_by_y * w_47 - w_19)
            + minus_l_lambda_right_rolls_lambda_left_rolls * w_46;
        let w_49 = inverse_lambda_sideways
            * (w_4 + minus_l_lambda_sideways_lambda_left_rolls * w_46
                - l_lambda_sideways_lambda_right_rolls * w_48);
        let w_50 = inverse_lambda_right_rolls * w_48
            - l_lambda_sideways_lambda_right_rolls * w_49;
        let w_51 = minus_l_lambda_right_rolls_lambda_left_rolls * w_50
            - minus_inverse_lambda_left_rolls * w_46
            + minus_l_lambda_sideways_lambda_left_rolls * w_49;
        let w_52 = minus_l_lambda_right_rolls_lambda_left_rolls * self.k_5;
        let w_53 = inverse_lambda_sideways
            * (l_lambda_sideways_lambda_right_rolls * w_52
                - minus_l_lambda_sideways_lambda_left_rolls * self.k_5);
        let w_54 = inverse_lambda_right_rolls * w_52
            + l_lambda_sideways_lambda_right_rolls * w_53;
        let w_55 = minus_inverse_lambda_left_rolls * self.k_5
            - minus_l_lambda_right_rolls_lambda_left_rolls * w_54
            + minus_l_lambda_sideways_lambda_left_rolls * w_53;
        let w_56 = inverse_lambda_sideways * l_lambda_sideways_lambda_right_rolls
            * self.k_5;
        let w_57 = inverse_lambda_right_rolls * self.k_5
            + l_lambda_sideways_lambda_right_rolls * w_56;
        let w_58 = minus_l_lambda_sideways_lambda_left_rolls * w_56
            - minus_l_lambda_right_rolls_lambda_left_rolls * w_57;
        sim_kernel::DynamicsJacobian {
            accelerations_by_positions: [
                [
                    S::from_f64(0.0),
                    S::from_f64(0.0),
                    self.inverse_x * w_10 - l_lambda_left_rolls_x * w_33
                        - l_lambda_left_rolls_x * w_32
                        + minus_l_lambda_sideways_x * w_31,
                    S::from_f64(0.0),
                    S::from_f64(0.0),
                ],
                [
                    S::from_f64(0.0),
                    S::from_f64(0.0),
                    self.inverse_x * w_21 - minus_l_lambda_sideways_x * w_33
                        - minus_l_lambda_sideways_x * w_32
                        - l_lambda_left_rolls_x * w_31,
                    S::from_f64(0.0),
                    S::from_f64(0.0),
                ],
                [
                    S::from_f64(0.0),
                    S::from_f64(0.0),
                    self.minus_l_lambda_left_rolls_psi * w_33
                        - self.minus_l_lambda_left_rolls_psi * w_32,
                    S::from_f64(0.0),
                    S::from_f64(0.0),
                ],
                [
                    S::from_f64(0.0),
                    S::from_f64(0.0),
                    self.minus_l_lambda_left_rolls_left * w_33,
                    S::from_f64(0.0),
                    S::from_f64(0.0),
                ],
                [
                    S::from_f64(0.0),
                    S::from_f64(0.0),
                    self.minus_l_lambda_left_rolls_left * w_32,
                    S::from_f64(0.0),
                    S::from_f64(0.0),
                ],
            ],
            accelerations_by_speeds: [
                [
                    minus_l_lambda_sideways_x * w_37 - l_lambda_left_rolls_x * w_39
                        - l_lambda_left_rolls_x * w_38,
                    l_lambda_left_rolls_x * w_42 - l_lambda_left_rolls_x * w_43
                        + minus_l_lambda_sideways_x * w_41,
                    minus_l_lambda_sideways_x * w_49 - l_lambda_left_rolls_x * w_51
                        - l_lambda_left_rolls_x * w_50,
                    l_lambda_left_rolls_x * w_54 - l_lambda_left_rolls_x * w_55
                        + minus_l_lambda_sideways_x * w_53,
                    l_lambda_left_rolls_x * w_57 - l_lambda_left_rolls_x * w_58
                        + minus_l_lambda_sideways_x * w_56,
                ],
                [
                    -(minus_l_lambda_sideways_x * w_39 + minus_l_lambda_sideways_x * w_38
                        + l_lambda_left_rolls_x * w_37),
                    minus_l_lambda_sideways_x * w_42 - minus_l_lambda_sideways_x * w_43
                        - l_lambda_left_rolls_x * w_41,
                    -(minus_l_lambda_sideways_x * w_51 + minus_l_lambda_sideways_x * w_50
                        + l_lambda_left_rolls_x * w_49),
                    minus_l_lambda_sideways_x * w_54 - minus_l_lambda_sideways_x * w_55
                        - l_lambda_left_rolls_x * w_53,
                    minus_l_lambda_sideways_x * w_57 - minus_l_lambda_sideways_x * w_58
                        - l_lambda_left_rolls_x * w_56,
                ],
                [
                    self.minus_l_lambda_left_rolls_psi * w_39
                        - self.minus_l_lambda_left_rolls_psi * w_38,
                    self.minus_l_lambda_left_rolls_psi * w_43
                        + self.minus_l_lambda_left_rolls_psi * w_42,
                    self.minus_l_lambda_left_rolls_psi * w_51
                        - self.minus_l_lambda_left_rolls_psi * w_50,
                    self.minus_l_lambda_left_rolls_psi * w_55
                        + self.minus_l_lambda_left_rolls_psi * w_54,
                    self.minus_l_lambda_left_rolls_psi * w_58
                        + self.minus_l_lambda_left_rolls_psi * w_57,
                ],
                [
                    self.minus_l_lambda_left_rolls_left * w_39,
                    self.minus_l_lambda_left_rolls_left * w_43,
                    self.minus_l_lambda_left_rolls_left * w_51,
                    self.minus_l_lambda_left_rolls_left * w_55 - self.k_6,
                    self.minus_l_lambda_left_rolls_left * w_58,
                ],
                [
                    self.minus_l_lambda_left_rolls_left * w_38,
                    -(self.minus_l_lambda_left_rolls_left * w_42),
                    self.minus_l_lambda_left_rolls_left * w_50,
                    -(self.minus_l_lambda_left_rolls_left * w_54),
                    -(self.k_6 + self.minus_l_lambda_left_rolls_left * w_57),
                ],
            ],
            multipliers_by_positions: [
                [
                    S::from_f64(0.0),
                    S::from_f64(0.0),
                    w_33,
                    S::from_f64(0.0),
                    S::from_f64(0.0),
                ],
                [
                    S::from_f64(0.0),
                    S::from_f64(0.0),
                    w_32,
                    S::from_f64(0.0),
                    S::from_f64(0.0),
                ],
                [
                    S::from_f64(0.0),
                    S::from_f64(0.0),
                    w_31,
                    S::from_f64(0.0),
                    S::from_f64(0.0),
                ],
            ],
            multipliers_by_speeds: [
                [w_39, w_43, w_51, w_55, w_58],
                [w_38, -w_42, w_50, -w_54, -w_57],
                [w_37, w_41, w_49, w_53, w_56],
            ],
            refused: sim_kernel::pivot_is_refused(
                self.mass_left_left,
                self.mass_left_left,
            ) | sim_kernel::pivot_is_refused(self.mass_psi_psi, self.mass_psi_psi)
                | sim_kernel::pivot_is_refused(self.mass_x_x, self.mass_x_x)
                | sim_kernel::pivot_is_refused(self.mass_x_x, self.mass_x_x)
                | sim_kernel::pivot_is_refused(self.mass_left_left, self.mass_left_left)
                | sim_kernel::pivot_is_refused(
                    -minus_pivot_lambda_left_rolls,
                    minus_pivot_lambda_left_rolls,
                ) | sim_kernel::pivot_is_refused(pivot_lambda_right_rolls, w_7)
                | sim_kernel::pivot_is_refused(pivot_lambda_sideways, w_8),
        }
    }
}
#[allow(non_snake_case, clippy::all, clippy::pedantic)]
impl<S: sim_kernel::Scalar> sim_kernel::Mechanism<S> for Rover<S> {
    type Q = [S; 5];
    type L = [S; 3];
    type Z = [S; 8];
    type QQ = [[S; 5]; 5];
    type LQ = [[S; 5]; 3];
    type LL = [[S; 3]; 3];
    type ZZ = [[S; 8]; 8];
    type Entries = [S; 0];
    type Envelope = [S; 0];
    type Parameters = [S; 7];
    type Outputs = [S; 3];
    type OutputRates = [S; 2];
    type Events = [S; 0];
    type EventValues = [S; 0];
    type Activities = [S; 0];
    type Drawing = [S; 53];
    type QP = [[S; 7]; 5];
    type LP = [[S; 7]; 3];
    type Inputs = [sim_kernel::Input<S>; 2];
    type Prepared = RoverPrepared<S>;
    type On<T: sim_kernel::Scalar> = Rover<T>;
    const DESCRIPTION: sim_kernel::Description = sim_kernel::Description {
        name: "rover",
        type_name: "Rover",
        docs: "A two-wheeled cart under the torques of its motors, against their friction.",
        declaration: "/// A two-wheeled cart under the torques of its motors, against their friction.\npub Rover;\n\ncoordinates {\n    /// Middle of the axle.\n    x [m];\n    y [m];\n    /// Direction.\n    psi [rad];\n    /// Turn of the left wheel.\n    left [rad];\n    /// Turn of the right wheel.\n    right [rad];\n}\n\nparameters {\n    /// Mass of the cart without wheels, in the middle of the axle.\n    M [kg] = 8;\n    /// Its moment of inertia about the vertical.\n    J [kg*m^2] = 0.2;\n    /// Mass of a wheel.\n    m [kg] = 0.5;\n    /// Radius of the wheels.\n    r [m] = 0.1;\n    /// Half of their distance.\n    b [m] = 0.2;\n    /// Friction of the motors.\n    c [N*m*s] = 0.05;\n    g [m/s^2] = 9.81;\n}\n\ninputs { tau_left [N*m] = 0.2; tau_right [N*m] = 0.3; }\n\nlet R = rotation([0, 0, 1], psi);\nlet P = [x, y, r];\nlet L = P + R*[0, b, 0];\nlet Q = P + R*[0, -b, 0];\nlet left_frame = R*rotation([0, 1, 0], left);\nlet right_frame = R*rotation([0, 1, 0], right);\n\nbodies {\n    cart: mass M at P, inertia [J/2, J/2, J], attitude R;\n    left_wheel: mass m at L, inertia [m*r^2/4, m*r^2/2, m*r^2/4], attitude left_frame;\n    right_wheel: mass m at Q, inertia [m*r^2/4, m*r^2/2, m*r^2/4], attitude right_frame;\n}\nloads {\n    gravity [0, 0, -g];\n    torque tau_left - c*dot(left) on left;\n    torque tau_right - c*dot(right) on right;\n}\nconstraints {\n    /// The rim of each wheel stands still where it touches the ground, and neither slips sideways.\n    left_rolls: inner(dot(L) + cross(omega(left_wheel), [0, 0, -r]), R*[1, 0, 0]) = 0;\n    right_rolls: inner(dot(Q) + cross(omega(right_wheel), [0, 0, -r]), R*[1, 0, 0]) = 0;\n    sideways: inner(dot(P), R*[0, 1, 0]) = 0;\n}\ninitial { x = 0; y = 0; psi = 0; left = 0; right = 0; dot(left) = 0; dot(right) = 0; }\n\noutputs {\n    /// speed\n    speed [m/s] = inner(dot(P), R*[1, 0, 0]);\n    /// rate of turning\n    turning [rad/s] = dot(psi);\n    /// force of the wheels on the ground, sideways\n    side_force [N] = reaction(sideways);\n}\n\ndrawing {\n    curve [-1 [m], -1 [m], 0], [3 [m], -1 [m], 0], [3 [m], 3 [m], 0], [-1 [m], 3 [m], 0], [-1 [m], -1 [m], 0];\n    circle L radius r normal R*[0, 1, 0];\n    circle Q radius r normal R*[0, 1, 0];\n    line L, on(left_wheel, [r, 0, 0]);\n    line Q, on(right_wheel, [r, 0, 0]);\n    curve L, P + R*[0.3 [m], 0, 0], Q, L;\n}\n",
        coordinates: &[
            sim_kernel::Coordinate {
                position: sim_kernel::Quantity {
                    name: "x",
                    unit: "m",
                    factor: 1f64,
                    is_length: true,
                    docs: "Middle of the axle.",
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
                    name: "psi",
                    unit: "rad",
                    factor: 1f64,
                    is_length: false,
                    docs: "Direction.",
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
                speed_given: false,
            },
            sim_kernel::Coordinate {
                position: sim_kernel::Quantity {
                    name: "left",
                    unit: "rad",
                    factor: 1f64,
                    is_length: false,
                    docs: "Turn of the left wheel.",
                },
                speed: sim_kernel::Quantity {
                    name: "left_dot",
                    unit: "rad/s",
                    factor: 1f64,
                    is_length: false,
                    docs: "",
                },
                acceleration: sim_kernel::Quantity {
                    name: "left_ddot",
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
                    name: "right",
                    unit: "rad",
                    factor: 1f64,
                    is_length: false,
                    docs: "Turn of the right wheel.",
                },
                speed: sim_kernel::Quantity {
                    name: "right_dot",
                    unit: "rad/s",
                    factor: 1f64,
                    is_length: false,
                    docs: "",
                },
                acceleration: sim_kernel::Quantity {
                    name: "right_ddot",
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
                name: "M",
                unit: "kg",
                factor: 1f64,
                is_length: false,
                docs: "Mass of the cart without wheels, in the middle of the axle.",
            },
            sim_kernel::Quantity {
                name: "J",
                unit: "kg*m^2",
                factor: 1f64,
                is_length: false,
                docs: "Its moment of inertia about the vertical.",
            },
            sim_kernel::Quantity {
                name: "m",
                unit: "kg",
                factor: 1f64,
                is_length: false,
                docs: "Mass of a wheel.",
            },
            sim_kernel::Quantity {
                name: "r",
                unit: "m",
                factor: 1f64,
                is_length: true,
                docs: "Radius of the wheels.",
            },
            sim_kernel::Quantity {
                name: "b",
                unit: "m",
                factor: 1f64,
                is_length: true,
                docs: "Half of their distance.",
            },
            sim_kernel::Quantity {
                name: "c",
                unit: "N*m*s",
                factor: 1f64,
                is_length: false,
                docs: "Friction of the motors.",
            },
            sim_kernel::Quantity {
                name: "g",
                unit: "m/s^2",
                factor: 1f64,
                is_length: false,
                docs: "",
            },
        ],
        inputs: &[
            sim_kernel::Quantity {
                name: "tau_left",
                unit: "N*m",
                factor: 1f64,
                is_length: false,
                docs: "",
            },
            sim_kernel::Quantity {
                name: "tau_right",
                unit: "N*m",
                factor: 1f64,
                is_length: false,
                docs: "",
            },
        ],
        constraints: &[
            sim_kernel::Quantity {
                name: "left_rolls",
                unit: "N",
                factor: 1f64,
                is_length: false,
                docs: "",
            },
            sim_kernel::Quantity {
                name: "right_rolls",
                unit: "N",
                factor: 1f64,
                is_length: false,
                docs: "",
            },
            sim_kernel::Quantity {
                name: "sideways",
                unit: "N",
                factor: 1f64,
                is_length: false,
                docs: "",
            },
        ],
        speed_constraints: &[0, 1, 2],
        norm_constraints: &[],
        sparsity: &[],
        conditionals: &[],
        events: &[],
        outputs: &[
            sim_kernel::Quantity {
                name: "speed",
                unit: "m/s",
                factor: 1f64,
                is_length: false,
                docs: "speed",
            },
            sim_kernel::Quantity {
                name: "turning",
                unit: "rad/s",
                factor: 1f64,
                is_length: false,
                docs: "rate of turning",
            },
            sim_kernel::Quantity {
                name: "side_force",
                unit: "N",
                factor: 1f64,
                is_length: false,
                docs: "force of the wheels on the ground, sideways",
            },
        ],
        rated_outputs: &[0, 1],
        figures: &[
            sim_kernel::Figure {
                name: "speed",
                title: "speed",
                len: 1,
            },
            sim_kernel::Figure {
                name: "turning",
                title: "rate of turning",
                len: 1,
            },
            sim_kernel::Figure {
                name: "side_force",
                title: "force of the wheels on the ground, sideways",
                len: 1,
            },
        ],
        optional_kernels: &["dynamics_jacobian"],
        dimension: 3,
        drawing: &[
            sim_kernel::Shape::Curve(5),
            sim_kernel::Shape::Circle,
            sim_kernel::Shape::Circle,
            sim_kernel::Shape::Line(2),
            sim_kernel::Shape::Line(2),
            sim_kernel::Shape::Curve(4),
        ],
    };
    fn defaults() -> Self {
        Self {
            M: S::from_f64(8f64),
            J: S::from_f64(0.2f64),
            m: S::from_f64(0.5f64),
            r: S::from_f64(0.1f64),
            b: S::from_f64(0.2f64),
            c: S::from_f64(0.05f64),
            g: S::from_f64(9.81f64),
            tau_left: sim_kernel::Input::Declared,
            tau_right: sim_kernel::Input::Declared,
        }
    }
    fn parameters(&self) -> [S; 7] {
        [self.M, self.J, self.m, self.r, self.b, self.c, self.g]
    }
    fn with_parameters(&self, parameters: [S; 7]) -> Self {
        Self {
            M: parameters[0],
            J: parameters[1],
            m: parameters[2],
            r: parameters[3],
            b: parameters[4],
            c: parameters[5],
            g: parameters[6],
            ..*self
        }
    }
    fn on<T: sim_kernel::Scalar>(
        &self,
        convert: impl ::core::ops::Fn(S) -> T,
    ) -> Rover<T> {
        Rover {
            M: convert(self.M),
            J: convert(self.J),
            m: convert(self.m),
            r: convert(self.r),
            b: convert(self.b),
            c: convert(self.c),
            g: convert(self.g),
            tau_left: self.tau_left.map(&convert),
            tau_right: self.tau_right.map(&convert),
        }
    }
    fn inputs(&self) -> [sim_kernel::Input<S>; 2] {
        [self.tau_left, self.tau_right]
    }
    fn with_inputs(&self, inputs: [sim_kernel::Input<S>; 2]) -> Self {
        Self {
            tau_left: inputs[0],
            tau_right: inputs[1],
            ..*self
        }
    }
    fn set_inputs(prepared: &mut Self::Prepared, inputs: [sim_kernel::Input<S>; 2]) {
        prepared.tau_left = inputs[0];
        prepared.tau_right = inputs[1];
    }
    #[inline(always)]
    fn prepare(&self) -> RoverPrepared<S> {
        self.prepare()
    }
    #[inline(always)]
    fn prepared_dynamics(
        prepared: &Self::Prepared,
        t: S,
        q: &[S; 5],
        qd: &[S; 5],
    ) -> sim_kernel::Dynamics<S, [S; 5], [S; 3]> {
        prepared.dynamics(t, q, qd)
    }
    #[inline(always)]
    fn dynamics_jacobian(
        &self,
        t: S,
        q: &[S; 5],
        qd: &[S; 5],
    ) -> sim_kernel::DynamicsJacobian<S, [[S; 5]; 5], [[S; 5]; 3]> {
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
    fn constraints(&self, t: S, q: &[S; 5]) -> [S; 3] {
        self.constraints(t, q)
    }
    #[inline(always)]
    fn constraint_magnitudes(&self, t: S, q: &[S; 5]) -> [S; 3] {
        self.constraint_magnitudes(t, q)
    }
    #[inline(always)]
    fn constraint_jacobian(&self, t: S, q: &[S; 5]) -> [[S; 5]; 3] {
        self.constraint_jacobian(t, q)
    }
    #[inline(always)]
    fn constraint_time_derivative(&self, t: S, q: &[S; 5]) -> [S; 3] {
        self.constraint_time_derivative(t, q)
    }
    #[inline(always)]
    fn constraint_convective(&self, t: S, q: &[S; 5], qd: &[S; 5]) -> [S; 3] {
        self.constraint_convective(t, q, qd)
    }
    #[inline(always)]
    fn constraint_linearization(
        &self,
        t: S,
        q: &[S; 5],
    ) -> sim_kernel::ConstraintLinearization<[S; 3], [[S; 5]; 3]> {
        self.constraint_linearization(t, q)
    }
    #[inline(always)]
    fn kinetic_energy(&self, t: S, q: &[S; 5], qd: &[S; 5]) -> S {
        self.kinetic_energy(t, q, qd)
    }
    #[inline(always)]
    fn power(&self, t: S, q: &[S; 5], qd: &[S; 5], qdd: &[S; 5], lambda: &[S; 3]) -> S {
        self.power(t, q, qd, qdd, lambda)
    }
    #[inline(always)]
    fn outputs(
        &self,
        t: S,
        q: &[S; 5],
        qd: &[S; 5],
        qdd: &[S; 5],
        lambda: &[S; 3],
    ) -> [S; 3] {
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
        lambda: &[S; 3],
    ) -> [S; 0] {
        self.events(t, q, qd, qdd, lambda)
    }
    #[inline(always)]
    fn drawing(&self, t: S, q: &[S; 5]) -> [S; 53] {
        self.drawing(t, q)
    }
    #[inline(always)]
    fn initial(&self) -> sim_kernel::Initial<[S; 5]> {
        self.initial()
    }
    fn held_inputs(&self, t: S, q: &[S; 5]) -> Self::Inputs {
        self.input_values(t, q).map(sim_kernel::Input::Held)
    }
}
