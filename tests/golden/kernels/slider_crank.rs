/// Offset slider-crank: crank, connecting rod and piston under gravity, let go with the crank along the guide
/// at 20 rad/s.
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
/// coordinates = [theta; phi]
/// multipliers = [lambda_guide]
/// constraints = 0
/// [
///     r^2*m1/3 + r^2*m2 + r^2*m3, mass_matrix[1, 2], A_x;
///     mass_matrix[1, 2], l^2*m2/3 + l^2*m3, l*rod_x;
///     A_x, l*rod_x, 0
/// ] * [theta_ddot; phi_ddot; lambda_guide] = [
///     generalized_forces[1] - convective_forces[1];
///     generalized_forces[2] - convective_forces[2];
///     r*theta_dot^2*sin(theta) + l*rod_y*phi_dot^2
/// ]
///
/// mass_matrix = [
///     r^2*m1/3 + r^2*m2 + r^2*m3, mass_matrix[1, 2];
///     mass_matrix[1, 2], l^2*m2/3 + l^2*m3
/// ]
/// mass_matrix[1, 2] = r*l*m3*rod_y*sin(theta) + r*l*m3*rod_x*cos(theta) + r*l*m2*rod_y*sin(theta)/2
///     + r*l*m2*rod_x*cos(theta)/2
///
/// convective_forces = [convective_forces[1]; convective_forces[2]]
/// convective_forces[1] = r*m3*s_3*sin(theta) + r*m2*s_1*sin(theta)/2 - r*m2*s_2*cos(theta)/2
///     - r*m3*s_4*cos(theta)
/// convective_forces[2] = l*m3*rod_y*s_3 + l*m2*rod_y*s_1/4 - l*m2*rod_x*s_2/4 - l*m3*rod_x*s_4
///
/// generalized_forces = [generalized_forces[1]; generalized_forces[2]]
/// generalized_forces[1] = T - r*m1*g*cos(theta)/2 - r*m2*g*cos(theta) - r*m3*g*cos(theta)
/// generalized_forces[2] = -l*m2*g*rod_x/2 - l*m3*g*rod_x
///
/// constraints = [A_y - offset + l*rod_y]
///
/// constraint_jacobian = [A_x, l*rod_x]
///
/// constraint_convective = [-r*theta_dot^2*sin(theta) - l*rod_y*phi_dot^2]
///
/// A_x = r*cos(theta)
/// A_y = r*sin(theta)
/// rod_x = cos(phi)
/// rod_y = sin(phi)
/// s_1 = 2*r*theta_dot^2*cos(theta) + l*rod_x*phi_dot^2
/// s_2 = 2*r*theta_dot^2*sin(theta) + l*rod_y*phi_dot^2
/// s_3 = r*theta_dot^2*cos(theta) + l*rod_x*phi_dot^2
/// s_4 = r*theta_dot^2*sin(theta) + l*rod_y*phi_dot^2
/// ```
#[allow(non_snake_case)]
#[derive(
    ::core::clone::Clone,
    ::core::marker::Copy,
    ::core::fmt::Debug,
    ::core::cmp::PartialEq
)]
pub struct SliderCrank<S = ::core::primitive::f64> {
    /// Length of the crank, in `m`.
    pub r: S,
    /// Length of the rod, in `m`.
    pub l: S,
    /// Height of the guide, in `m`.
    pub offset: S,
    /// Mass of the crank, a slender rod, in `kg`.
    pub m1: S,
    /// Mass of the rod, slender, in `kg`.
    pub m2: S,
    /// Mass of the piston, in `kg`.
    pub m3: S,
    /// In `m/s^2`.
    pub g: S,
    /// Torque on the crank, in `N*m`.
    pub T: S,
}
impl<S: sim_kernel::Scalar> ::core::default::Default for SliderCrank<S> {
    /// The declared values.
    fn default() -> Self {
        <Self as sim_kernel::Compiled<S>>::defaults()
    }
}
/// Coordinates of [`SliderCrank`] by name, in SI units; also for their speeds and accelerations.
#[allow(non_snake_case)]
#[derive(
    ::core::clone::Clone,
    ::core::marker::Copy,
    ::core::fmt::Debug,
    ::core::cmp::PartialEq
)]
pub struct SliderCrankCoordinates<S = ::core::primitive::f64> {
    /// Angle of the crank, in `rad`.
    pub theta: S,
    /// Angle of the rod, in `rad`.
    pub phi: S,
}
impl<S: sim_kernel::Scalar> ::core::convert::From<[S; 2]> for SliderCrankCoordinates<S> {
    fn from(values: [S; 2]) -> Self {
        Self {
            theta: values[0],
            phi: values[1],
        }
    }
}
impl<S: sim_kernel::Scalar> ::core::convert::From<SliderCrankCoordinates<S>> for [S; 2] {
    fn from(record: SliderCrankCoordinates<S>) -> Self {
        [record.theta, record.phi]
    }
}
/// Outputs of [`SliderCrank`] by name, in SI units.
#[allow(non_snake_case)]
#[derive(
    ::core::clone::Clone,
    ::core::marker::Copy,
    ::core::fmt::Debug,
    ::core::cmp::PartialEq
)]
pub struct SliderCrankOutputs<S = ::core::primitive::f64> {
    /// crank, in `rad/s`.
    pub crank_speed: S,
    /// rod, in `rad/s`.
    pub rod_speed: S,
    /// position, in `m`.
    pub x: S,
    /// velocity, in `m/s`.
    pub x_velocity: S,
    /// acceleration, in `m/s^2`.
    pub x_acceleration: S,
    /// along +y, in `N`.
    pub wall_force: S,
}
impl<S: sim_kernel::Scalar> ::core::convert::From<[S; 6]> for SliderCrankOutputs<S> {
    fn from(values: [S; 6]) -> Self {
        Self {
            crank_speed: values[0],
            rod_speed: values[1],
            x: values[2],
            x_velocity: values[3],
            x_acceleration: values[4],
            wall_force: values[5],
        }
    }
}
impl<S: sim_kernel::Scalar> ::core::convert::From<SliderCrankOutputs<S>> for [S; 6] {
    fn from(record: SliderCrankOutputs<S>) -> Self {
        [
            record.crank_speed,
            record.rod_speed,
            record.x,
            record.x_velocity,
            record.x_acceleration,
            record.wall_force,
        ]
    }
}
/// Rates of the outputs of [`SliderCrank`] by name, in SI units.
#[allow(non_snake_case)]
#[derive(
    ::core::clone::Clone,
    ::core::marker::Copy,
    ::core::fmt::Debug,
    ::core::cmp::PartialEq
)]
pub struct SliderCrankOutputRates<S = ::core::primitive::f64> {
    /// Rate of `crank_speed`.
    pub crank_speed: S,
    /// Rate of `rod_speed`.
    pub rod_speed: S,
    /// Rate of `x`.
    pub x: S,
    /// Rate of `x_velocity`.
    pub x_velocity: S,
}
impl<S: sim_kernel::Scalar> ::core::convert::From<[S; 4]> for SliderCrankOutputRates<S> {
    fn from(values: [S; 4]) -> Self {
        Self {
            crank_speed: values[0],
            rod_speed: values[1],
            x: values[2],
            x_velocity: values[3],
        }
    }
}
impl<S: sim_kernel::Scalar> ::core::convert::From<SliderCrankOutputRates<S>> for [S; 4] {
    fn from(record: SliderCrankOutputRates<S>) -> Self {
        [record.crank_speed, record.rod_speed, record.x, record.x_velocity]
    }
}
/// What the equations of motion need of the parameters of [`SliderCrank`], from [`SliderCrank::prepare`]; its methods are the kernels of each step.
#[allow(non_snake_case)]
#[derive(
    ::core::clone::Clone,
    ::core::marker::Copy,
    ::core::fmt::Debug,
    ::core::cmp::PartialEq
)]
pub struct SliderCrankPrepared<S = ::core::primitive::f64> {
    r: S,
    mass_theta_theta: S,
    l: S,
    k: S,
    mass_phi_phi: S,
    T: S,
    k_2: S,
    k_3: S,
    k_4: S,
    k_5: S,
    k_6: S,
    k_7: S,
    k_8: S,
    k_9: S,
    inverse_theta: S,
    k_10: S,
    k_11: S,
    k_12: S,
    k_13: S,
    k_14: S,
    k_15: S,
    k_16: S,
    k_17: S,
}
#[allow(non_snake_case, unused_variables, unused_parens, clippy::all, clippy::pedantic)]
impl<S: sim_kernel::Scalar> SliderCrank<S> {
    /// What the equations of motion need of the parameters, computed once for a set of parameters.
    ///
    /// Operations: 15 additions, 34 multiplications, 1 division.
    #[inline]
    pub fn prepare(&self) -> SliderCrankPrepared<S> {
        let r_squared = self.r * self.r;
        let w = r_squared * self.m2;
        let w_2 = r_squared * self.m3;
        let mass_theta_theta = S::from_f64(0.3333333333333333) * r_squared * self.m1 + w
            + w_2;
        let w_3 = self.m3 * self.l;
        let w_4 = self.r * w_3;
        let w_5 = self.m2 * self.l;
        let w_6 = self.r * S::from_f64(0.5);
        let w_7 = w_5 * w_6;
        let l_squared = self.l * self.l;
        let w_8 = self.m2 * l_squared;
        let w_9 = self.m3 * l_squared;
        let w_10 = self.r * S::from_f64(2.0);
        let w_11 = self.r * self.g;
        let w_12 = self.m1 * w_11;
        let w_13 = self.m2 * w_11;
        let w_14 = self.m3 * w_11;
        let w_15 = w_5 * self.g;
        let w_16 = w_3 * self.g;
        let w_17 = w_3 * w_10;
        let w_18 = self.r * w_5;
        SliderCrankPrepared {
            r: self.r,
            mass_theta_theta: mass_theta_theta,
            l: self.l,
            k: w_4 + w_7,
            mass_phi_phi: S::from_f64(0.3333333333333333) * w_8 + w_9,
            T: self.T,
            k_2: w_10,
            k_3: self.r * self.m3,
            k_4: self.m2 * w_6,
            k_5: S::from_f64(0.5) * w_12 + w_13 + w_14,
            k_6: w_7 + w_4,
            k_7: w_3,
            k_8: w_5 * S::from_f64(0.25),
            k_9: S::from_f64(0.5) * w_15 + w_16,
            inverse_theta: S::from_f64(1.0) / mass_theta_theta,
            k_10: self.T * S::from_f64(2.0),
            k_11: w_12 + S::from_f64(2.0) * w_13 + S::from_f64(2.0) * w_14,
            k_12: w_15 + S::from_f64(2.0) * w_16,
            k_13: w_17 + w_18,
            k_14: w_2 + w,
            k_15: w_8 * S::from_f64(0.25) + w_9,
            k_16: w_18 + w_17,
            k_17: self.l * S::from_f64(2.0),
        }
    }
    /// Mass matrix `T_q' M T_q`, 2 x 2, symmetric, in SI units.
    ///
    /// Operations: 5 additions, 16 multiplications, 2 sine-cosine pairs.
    #[inline]
    pub fn mass_matrix(&self, t: S, q: &[S; 2]) -> [[S; 2]; 2] {
        let [theta, phi] = *q;
        let r_squared = self.r * self.r;
        let w = self.r * self.l;
        let ([sin_theta, rod_y], [cos_theta, rod_x]) = S::sin_cos_each([theta, phi]);
        let mass_phi_theta = (self.m3 * w + self.m2 * S::from_f64(0.5) * w)
            * (sin_theta * rod_y + cos_theta * rod_x);
        let l_squared = self.l * self.l;
        [
            [
                S::from_f64(0.3333333333333333) * r_squared * self.m1
                    + r_squared * self.m2 + r_squared * self.m3,
                mass_phi_theta,
            ],
            [
                mass_phi_theta,
                S::from_f64(0.3333333333333333) * self.m2 * l_squared
                    + self.m3 * l_squared,
            ],
        ]
    }
    /// Convective forces `T_q' M g`, 2, with `g = (T_q q' + T_t)_q q' + (..)_t`: joules per unit of each coordinate.
    ///
    /// Operations: 4 additions, 14 multiplications, 2 sine-cosine pairs.
    #[inline]
    pub fn convective_forces(&self, t: S, q: &[S; 2], qd: &[S; 2]) -> [S; 2] {
        let [theta, phi] = *q;
        let [theta_dot, phi_dot] = *qd;
        let w = self.r * self.l;
        let w_2 = self.m3 * w;
        let w_3 = S::from_f64(0.5) * self.m2 * w;
        let w_4 = w_2 + w_3;
        let ([sin_theta, rod_y], [cos_theta, rod_x]) = S::sin_cos_each([theta, phi]);
        let w_5 = sin_theta * rod_x;
        let w_6 = w_3 + w_2;
        let w_7 = cos_theta * rod_y;
        [
            phi_dot * phi_dot * (w_4 * w_5 - w_6 * w_7),
            theta_dot * theta_dot * (w_4 * w_7 - w_6 * w_5),
        ]
    }
    /// Generalised forces `T_q' F`, 2: joules per unit of each coordinate.
    ///
    /// Operations: 5 additions, 11 multiplications, 2 sine-cosine pairs.
    #[inline]
    pub fn generalized_forces(&self, t: S, q: &[S; 2], qd: &[S; 2]) -> [S; 2] {
        let [theta, phi] = *q;
        let ([_, _], [cos_theta, rod_x]) = S::sin_cos_each([theta, phi]);
        let w = self.r * self.g;
        let w_2 = self.g * self.l;
        [
            self.T
                - cos_theta
                    * (S::from_f64(0.5) * self.m1 * w + self.m2 * w + self.m3 * w),
            -(rod_x * (S::from_f64(0.5) * self.m2 * w_2 + self.m3 * w_2)),
        ]
    }
    /// Constraints `C`, 1, in SI units; zero throughout the motion.
    ///
    /// Operations: 2 additions, 2 multiplications, 2 sine-cosine pairs.
    #[inline]
    pub fn constraints(&self, t: S, q: &[S; 2]) -> [S; 1] {
        let [theta, phi] = *q;
        let ([sin_theta, rod_y], [_, _]) = S::sin_cos_each([theta, phi]);
        [self.r * sin_theta - self.offset + self.l * rod_y]
    }
    /// The sum of the magnitudes of the terms of `C`, 1, in SI units: what its rounding is relative to.
    ///
    /// Operations: 5 additions, 2 multiplications, 2 sine-cosine pairs.
    #[inline]
    pub fn constraint_magnitudes(&self, t: S, q: &[S; 2]) -> [S; 1] {
        let [theta, phi] = *q;
        let ([sin_theta, rod_y], [_, _]) = S::sin_cos_each([theta, phi]);
        [self.offset.abs() + (self.r * sin_theta).abs() + (self.l * rod_y).abs()]
    }
    /// Constraint Jacobian `C_q`, 1 x 2: units of each constraint per unit of each coordinate.
    ///
    /// Operations: 2 multiplications, 2 sine-cosine pairs.
    #[inline]
    pub fn constraint_jacobian(&self, t: S, q: &[S; 2]) -> [[S; 2]; 1] {
        let [theta, phi] = *q;
        let ([_, _], [cos_theta, rod_x]) = S::sin_cos_each([theta, phi]);
        [[self.r * cos_theta, self.l * rod_x]]
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
    /// Operations: 2 additions, 6 multiplications, 2 sine-cosine pairs.
    #[inline]
    pub fn constraint_convective(&self, t: S, q: &[S; 2], qd: &[S; 2]) -> [S; 1] {
        let [theta, phi] = *q;
        let [theta_dot, phi_dot] = *qd;
        let ([sin_theta, rod_y], [_, _]) = S::sin_cos_each([theta, phi]);
        [
            -(theta_dot * theta_dot * self.r * sin_theta
                + phi_dot * phi_dot * self.l * rod_y),
        ]
    }
    /// `C` (1), `C_q` (1 x 2) and `C_t` (1) together, in SI units, for projection.
    ///
    /// Operations: 2 additions, 4 multiplications, 2 sine-cosine pairs.
    #[inline]
    pub fn constraint_linearization(
        &self,
        t: S,
        q: &[S; 2],
    ) -> sim_kernel::ConstraintLinearization<[S; 1], [[S; 2]; 1]> {
        let [theta, phi] = *q;
        let ([sin_theta, rod_y], [cos_theta, rod_x]) = S::sin_cos_each([theta, phi]);
        sim_kernel::ConstraintLinearization {
            values: [self.r * sin_theta - self.offset + self.l * rod_y],
            jacobian: [[self.r * cos_theta, self.l * rod_x]],
            time_derivative: [S::from_f64(0.0)],
        }
    }
    /// Kinetic energy `v' M v / 2`, in joules.
    ///
    /// Operations: 9 additions, 28 multiplications, 2 sine-cosine pairs.
    #[inline]
    pub fn kinetic_energy(&self, t: S, q: &[S; 2], qd: &[S; 2]) -> S {
        let [theta, phi] = *q;
        let [theta_dot, phi_dot] = *qd;
        let ([sin_theta, rod_y], [cos_theta, rod_x]) = S::sin_cos_each([theta, phi]);
        let w = theta_dot * self.r;
        let w_2 = phi_dot * self.l;
        let w_3 = rod_y * w_2;
        let w_4 = sin_theta * w + w_3;
        let w_5 = w_2 * rod_x;
        let w_6 = w * cos_theta + w_5;
        let w_7 = theta_dot * self.r * S::from_f64(2.0);
        let w_8 = w_3 + sin_theta * w_7;
        let w_9 = w_5 + cos_theta * w_7;
        let w_10 = theta_dot * theta_dot * S::from_f64(0.16666666666666666) * self.r
            * self.r * self.m1;
        let w_11 = phi_dot * phi_dot * S::from_f64(0.041666666666666664) * self.l
            * self.l * self.m2;
        S::from_f64(0.5) * self.m3 * (w_4 * w_4 + w_6 * w_6)
            + self.m2 * S::from_f64(0.125) * (w_8 * w_8 + w_9 * w_9) + w_10 + w_11
    }
    /// Power of loads and drives, `F' v + lambda' C_t + T_t' (M x'' - F)`, in watts.
    ///
    /// Operations: 5 additions, 15 multiplications, 2 sine-cosine pairs.
    #[inline]
    pub fn power(
        &self,
        t: S,
        q: &[S; 2],
        qd: &[S; 2],
        qdd: &[S; 2],
        lambda: &[S; 1],
    ) -> S {
        let [theta, phi] = *q;
        let [theta_dot, phi_dot] = *qd;
        let ([_, _], [cos_theta, rod_x]) = S::sin_cos_each([theta, phi]);
        let w = self.r * self.g;
        let w_2 = S::from_f64(2.0) * self.m3;
        let w_3 = theta_dot
            * (self.T * S::from_f64(2.0)
                - cos_theta * (self.m1 * w + self.m2 * S::from_f64(2.0) * w + w * w_2));
        let w_4 = self.g * self.l;
        S::from_f64(0.5) * (w_3 - phi_dot * rod_x * (self.m2 * w_4 + w_2 * w_4))
    }
    /// Outputs, 6, in SI units.
    ///
    /// Operations: 8 additions, 14 multiplications, 2 sine-cosine pairs.
    #[inline]
    pub fn outputs(
        &self,
        t: S,
        q: &[S; 2],
        qd: &[S; 2],
        qdd: &[S; 2],
        lambda: &[S; 1],
    ) -> SliderCrankOutputs<S> {
        let [theta, phi] = *q;
        let [theta_dot, phi_dot] = *qd;
        let [theta_ddot, phi_ddot] = *qdd;
        let [lambda_guide] = *lambda;
        let ([sin_theta, rod_y], [cos_theta, rod_x]) = S::sin_cos_each([theta, phi]);
        [
            theta_dot,
            phi_dot,
            self.r * cos_theta + self.l * rod_x,
            -(theta_dot * self.r * sin_theta + phi_dot * self.l * rod_y),
            -(self.r * (sin_theta * theta_ddot + cos_theta * theta_dot * theta_dot)
                + self.l * (rod_y * phi_ddot + rod_x * phi_dot * phi_dot)),
            -lambda_guide,
        ]
            .into()
    }
    /// Rates of the outputs that depend on neither accelerations nor multipliers, 4, in SI units per second.
    ///
    /// Operations: 6 additions, 12 multiplications, 2 sine-cosine pairs.
    #[inline]
    pub fn output_rates(
        &self,
        t: S,
        q: &[S; 2],
        qd: &[S; 2],
        qdd: &[S; 2],
    ) -> SliderCrankOutputRates<S> {
        let [theta, phi] = *q;
        let [theta_dot, phi_dot] = *qd;
        let [theta_ddot, phi_ddot] = *qdd;
        let ([sin_theta, rod_y], [cos_theta, rod_x]) = S::sin_cos_each([theta, phi]);
        [
            theta_ddot,
            phi_ddot,
            -(theta_dot * self.r * sin_theta + phi_dot * self.l * rod_y),
            -(self.r * (theta_ddot * sin_theta + theta_dot * theta_dot * cos_theta)
                + self.l * (phi_ddot * rod_y + phi_dot * phi_dot * rod_x)),
        ]
            .into()
    }
    /// `left - right` of each event, 2, in SI units: zero when it happens.
    ///
    /// Operations: 3 additions, 5 multiplications, 2 sine-cosine pairs.
    #[inline]
    pub fn events(
        &self,
        t: S,
        q: &[S; 2],
        qd: &[S; 2],
        qdd: &[S; 2],
        lambda: &[S; 1],
    ) -> [S; 2] {
        let [theta, phi] = *q;
        let [theta_dot, phi_dot] = *qd;
        let ([sin_theta, rod_y], [_, _]) = S::sin_cos_each([theta, phi]);
        [
            theta - S::from_f64(2.0) * S::from_f64(::core::f64::consts::PI),
            -(theta_dot * self.r * sin_theta + phi_dot * self.l * rod_y),
        ]
    }
    /// The numbers of each shape of the drawing, in metres and radians.
    ///
    /// Operations: 2 additions, 4 multiplications, 2 sine-cosine pairs.
    #[inline]
    pub fn drawing(&self, t: S, q: &[S; 2]) -> [S; 11] {
        let [theta, phi] = *q;
        let ([sin_theta, rod_y], [cos_theta, rod_x]) = S::sin_cos_each([theta, phi]);
        let A_x = self.r * cos_theta;
        let A_y = self.r * sin_theta;
        let C_x = A_x + self.l * rod_x;
        let C_y = A_y + self.l * rod_y;
        [
            S::from_f64(0.0),
            S::from_f64(0.0),
            S::from_f64(0.0),
            S::from_f64(0.0),
            A_x,
            A_y,
            C_x,
            C_y,
            C_x,
            C_y,
            S::from_f64(0.0),
        ]
    }
    /// Declared start: values or guesses of the coordinates (2), and speeds (2), in SI units; 0 where nothing is declared.
    ///
    /// Operations: none.
    #[inline]
    pub fn initial(&self) -> sim_kernel::Initial<[S; 2]> {
        sim_kernel::Initial {
            positions: [S::from_f64(0.0), S::from_f64(0.07)],
            speeds: [S::from_f64(20.0), S::from_f64(0.0)],
        }
    }
    /// [`SliderCrankPrepared::dynamics`] once; for many calls with the same parameters [`Self::prepare`] first.
    #[inline]
    pub fn dynamics(
        &self,
        t: S,
        q: &[S; 2],
        qd: &[S; 2],
    ) -> sim_kernel::Dynamics<S, [S; 2], [S; 1]> {
        self.prepare().dynamics(t, q, qd)
    }
    /// [`SliderCrankPrepared::dynamics_jacobian`] once; for many calls with the same parameters [`Self::prepare`] first.
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
impl<S: sim_kernel::Scalar> SliderCrankPrepared<S> {
    /// Accelerations (2), multipliers (1) and power, from
    ///
    /// ```text
    /// [ T_q' M T_q   C_q' ] [ q''    ]   [ T_q' (F - M g)                      ]
    /// [ C_q          0    ] [ lambda ] = [ -(C_q q' + C_t)_q q' - (..)_t       ]
    /// ```
    ///
    /// by an elimination planned from the structure of the system. Where `refused` is set a pivot was too small and nothing else holds: solve that state from the other kernels.
    ///
    /// Operations: 20 additions, 44 multiplications, 2 divisions, 2 sine-cosine pairs.
    #[inline(always)]
    pub fn dynamics(
        &self,
        t: S,
        q: &[S; 2],
        qd: &[S; 2],
    ) -> sim_kernel::Dynamics<S, [S; 2], [S; 1]> {
        let [theta, phi] = *q;
        let [theta_dot, phi_dot] = *qd;
        let ([sin_theta, rod_y], [cos_theta, rod_x]) = S::sin_cos_each([theta, phi]);
        let phi_dot_squared = phi_dot * phi_dot;
        let rhs_theta = self.T
            + cos_theta * (rod_y * phi_dot_squared * self.k_6 - self.k_5)
            - sin_theta * rod_x * self.k * phi_dot_squared;
        let theta_dot_squared = theta_dot * theta_dot;
        let mass_phi_theta = self.k * (sin_theta * rod_y + cos_theta * rod_x);
        let l_phi_theta = mass_phi_theta * self.inverse_theta;
        let rhs_phi = rod_x * (sin_theta * theta_dot_squared * self.k_6 - self.k_9)
            - rod_y * cos_theta * self.k * theta_dot_squared - rhs_theta * l_phi_theta;
        let A_x = self.r * cos_theta;
        let l_lambda_guide_theta = A_x * self.inverse_theta;
        let pivot_phi = self.mass_phi_phi - mass_phi_theta * l_phi_theta;
        let inverse_phi = S::from_f64(1.0) / pivot_phi;
        let k_lambda_guide_phi = self.l * rod_x - mass_phi_theta * l_lambda_guide_theta;
        let l_lambda_guide_phi = inverse_phi * k_lambda_guide_phi;
        let minus_pivot_lambda_guide = A_x * l_lambda_guide_theta
            + k_lambda_guide_phi * l_lambda_guide_phi;
        let minus_lambda_guide = S::from_f64(1.0) / minus_pivot_lambda_guide
            * (self.l * rod_y * phi_dot_squared + self.r * sin_theta * theta_dot_squared
                - rhs_theta * l_lambda_guide_theta - l_lambda_guide_phi * rhs_phi);
        let phi_ddot = inverse_phi * rhs_phi + l_lambda_guide_phi * minus_lambda_guide;
        sim_kernel::Dynamics {
            accelerations: [
                rhs_theta * self.inverse_theta - l_phi_theta * phi_ddot
                    + l_lambda_guide_theta * minus_lambda_guide,
                phi_ddot,
            ],
            multipliers: [-minus_lambda_guide],
            power: S::from_f64(0.5)
                * (theta_dot * (self.k_10 - cos_theta * self.k_11)
                    - phi_dot * rod_x * self.k_12),
            refused: sim_kernel::pivot_is_refused(
                self.mass_theta_theta,
                self.mass_theta_theta,
            ) | sim_kernel::pivot_is_refused(pivot_phi, self.mass_phi_phi)
                | sim_kernel::pivot_is_refused(
                    -minus_pivot_lambda_guide,
                    minus_pivot_lambda_guide,
                ),
        }
    }
    /// The derivatives of accelerations (2 rows) and multipliers (1 rows) with respect to coordinates and speeds (2 columns each): with the equations of motion as `K z = r`, the solutions of `K dz = dr - dK z`. Where `refused` is set a pivot was too small and nothing else holds.
    ///
    /// Operations: 66 additions, 114 multiplications, 2 divisions, 2 sine-cosine pairs.
    #[inline]
    pub fn dynamics_jacobian(
        &self,
        t: S,
        q: &[S; 2],
        qd: &[S; 2],
    ) -> sim_kernel::DynamicsJacobian<S, [[S; 2]; 2], [[S; 2]; 1]> {
        let [theta, phi] = *q;
        let [theta_dot, phi_dot] = *qd;
        let ([sin_theta, rod_y], [cos_theta, rod_x]) = S::sin_cos_each([theta, phi]);
        let phi_dot_squared = phi_dot * phi_dot;
        let w = rod_y * phi_dot_squared;
        let w_2 = sin_theta * rod_x;
        let rhs_theta = self.T + cos_theta * (w * self.k_6 - self.k_5)
            - self.k * phi_dot_squared * w_2;
        let w_7 = self.l * w;
        let theta_dot_squared = theta_dot * theta_dot;
        let w_3 = sin_theta * theta_dot_squared;
        let w_4 = rod_y * cos_theta;
        let w_5 = sin_theta * rod_y;
        let w_6 = cos_theta * rod_x;
        let mass_phi_theta = self.k * (w_5 + w_6);
        let w_17 = self.k * w_5 + w_6 * self.k_6;
        let l_phi_theta = mass_phi_theta * self.inverse_theta;
        let rhs_phi = rod_x * (w_3 * self.k_6 - self.k_9)
            - self.k * theta_dot_squared * w_4 - rhs_theta * l_phi_theta;
        let w_8 = w_7 + self.r * w_3;
        let w_9 = self.k_2 * w_3 + w_7;
        let A_x = self.r * cos_theta;
        let l_lambda_guide_theta = A_x * self.inverse_theta;
        let pivot_phi = self.mass_phi_phi - mass_phi_theta * l_phi_theta;
        let inverse_phi = S::from_f64(1.0) / pivot_phi;
        let guide_by_phi = self.l * rod_x;
        let k_lambda_guide_phi = guide_by_phi - mass_phi_theta * l_lambda_guide_theta;
        let w_11 = guide_by_phi * phi_dot_squared;
        let l_lambda_guide_phi = inverse_phi * k_lambda_guide_phi;
        let minus_pivot_lambda_guide = A_x * l_lambda_guide_theta
            + k_lambda_guide_phi * l_lambda_guide_phi;
        let minus_inverse_lambda_guide = S::from_f64(1.0) / minus_pivot_lambda_guide;
        let minus_lambda_guide = minus_inverse_lambda_guide
            * (w_8 - rhs_theta * l_lambda_guide_theta - l_lambda_guide_phi * rhs_phi);
        let phi_ddot = inverse_phi * rhs_phi + l_lambda_guide_phi * minus_lambda_guide;
        let theta_ddot = rhs_theta * self.inverse_theta - l_phi_theta * phi_ddot
            + l_lambda_guide_theta * minus_lambda_guide;
        let w_10 = cos_theta * theta_dot_squared;
        let w_12 = self.r * w_10 + w_11;
        let w_13 = w_11 + w_10 * self.k_2;
        let w_14 = S::from_f64(0.5) * self.k_13 * (w_4 - w_2);
        let w_15 = phi_ddot * w_14;
        let w_18 = theta_ddot * w_14;
        let w_16 = sin_theta
            * (self.k_5 - w_9 * self.k_4 - w_8 * self.k_3 - self.r * minus_lambda_guide)
            - cos_theta * (w_12 * self.k_3 + w_13 * self.k_4) - w_15
            + theta_dot_squared * self.k_14;
        let w_19 = theta_dot_squared * w_17 - w_18 - l_phi_theta * w_16;
        let w_20 = minus_inverse_lambda_guide
            * (self.r * (sin_theta * theta_ddot + w_10) - l_lambda_guide_theta * w_16
                - l_lambda_guide_phi * w_19);
        let w_21 = inverse_phi * w_19 + l_lambda_guide_phi * w_20;
        let w_22 = w_15 + phi_dot_squared * w_17;
        let w_23 = w_18
            + rod_y
                * (self.k_9 - w_9 * self.k_8 - w_8 * self.k_7
                    - self.l * minus_lambda_guide) + phi_dot_squared * self.k_15
            - rod_x * (w_12 * self.k_7 + w_13 * self.k_8);
        let w_24 = w_23 - l_phi_theta * w_22;
        let w_25 = minus_inverse_lambda_guide
            * (self.l * (rod_y * phi_ddot + rod_x * phi_dot_squared)
                - l_lambda_guide_theta * w_22 - l_lambda_guide_phi * w_24);
        let w_26 = inverse_phi * w_24 + l_lambda_guide_phi * w_25;
        let w_27 = theta_dot * (w_2 * self.k_16 - w_4 * self.k_13);
        let w_30 = phi_dot * (w_4 * self.k_16 - w_2 * self.k_13);
        let w_28 = minus_inverse_lambda_guide
            * (sin_theta * theta_dot * self.k_2 - l_lambda_guide_phi * w_27);
        let w_29 = inverse_phi * w_27 + l_lambda_guide_phi * w_28;
        let w_31 = l_phi_theta * w_30;
        let w_32 = minus_inverse_lambda_guide
            * (rod_y * phi_dot * self.k_17 - l_lambda_guide_theta * w_30
                + l_lambda_guide_phi * w_31);
        let w_33 = l_lambda_guide_phi * w_32 - inverse_phi * w_31;
        sim_kernel::DynamicsJacobian {
            accelerations_by_positions: [
                [
                    self.inverse_theta * w_16 - l_phi_theta * w_21
                        + l_lambda_guide_theta * w_20,
                    self.inverse_theta * w_22 - l_phi_theta * w_26
                        + l_lambda_guide_theta * w_25,
                ],
                [w_21, w_26],
            ],
            accelerations_by_speeds: [
                [
                    l_lambda_guide_theta * w_28 - l_phi_theta * w_29,
                    self.inverse_theta * w_30 - l_phi_theta * w_33
                        + l_lambda_guide_theta * w_32,
                ],
                [w_29, w_33],
            ],
            multipliers_by_positions: [[-w_20, -w_25]],
            multipliers_by_speeds: [[-w_28, -w_32]],
            refused: sim_kernel::pivot_is_refused(
                self.mass_theta_theta,
                self.mass_theta_theta,
            ) | sim_kernel::pivot_is_refused(pivot_phi, self.mass_phi_phi)
                | sim_kernel::pivot_is_refused(
                    -minus_pivot_lambda_guide,
                    minus_pivot_lambda_guide,
                ),
        }
    }
}
#[allow(non_snake_case, unused_variables, clippy::all, clippy::pedantic)]
impl<S: sim_kernel::Scalar> sim_kernel::Mechanism<S> for SliderCrank<S> {
    type Q = [S; 2];
    type L = [S; 1];
    type Z = [S; 3];
    type QQ = [[S; 2]; 2];
    type V = [S; 0];
    type VV = [[S; 0]; 0];
    type LQ = [[S; 2]; 1];
    type LL = [[S; 1]; 1];
    type ZZ = [[S; 3]; 3];
    type Entries = [S; 0];
    type Envelope = [S; 0];
    type Parameters = [S; 8];
    type Outputs = [S; 6];
    type OutputRates = [S; 4];
    type Events = [S; 2];
    type EventValues = [S; 0];
    type SwitchingFunctions = [S; 0];
    type LoadConditions = [S; 0];
    type Activities = [S; 0];
    type Drawing = [S; 11];
    type QP = [[S; 8]; 2];
    type LP = [[S; 8]; 1];
    type Inputs = [sim_kernel::Input<S>; 0];
    type Prepared = SliderCrankPrepared<S>;
    type On<T: sim_kernel::Scalar> = SliderCrank<T>;
    #[inline(always)]
    fn description(&self) -> &'static sim_kernel::Description {
        const { &<Self as sim_kernel::Compiled<S>>::DESCRIPTION }
    }
    fn as_declared(&self) -> Self {
        <Self as sim_kernel::Compiled<S>>::defaults()
    }
    fn parameters(&self) -> [S; 8] {
        [self.r, self.l, self.offset, self.m1, self.m2, self.m3, self.g, self.T]
    }
    fn with_parameters(&self, parameters: [S; 8]) -> Self {
        Self {
            r: parameters[0],
            l: parameters[1],
            offset: parameters[2],
            m1: parameters[3],
            m2: parameters[4],
            m3: parameters[5],
            g: parameters[6],
            T: parameters[7],
            ..*self
        }
    }
    fn on<T: sim_kernel::Scalar>(
        &self,
        convert: impl ::core::ops::Fn(S) -> T,
    ) -> SliderCrank<T> {
        SliderCrank {
            r: convert(self.r),
            l: convert(self.l),
            offset: convert(self.offset),
            m1: convert(self.m1),
            m2: convert(self.m2),
            m3: convert(self.m3),
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
    fn prepare(&self) -> SliderCrankPrepared<S> {
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
    ) -> [S; 6] {
        self.outputs(t, q, qd, qdd, lambda).into()
    }
    #[inline(always)]
    fn output_rates(&self, t: S, q: &[S; 2], qd: &[S; 2], qdd: &[S; 2]) -> [S; 4] {
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
    ) -> [S; 2] {
        self.events(t, q, qd, qdd, lambda)
    }
    #[inline(always)]
    fn drawing(&self, t: S, q: &[S; 2]) -> [S; 11] {
        self.drawing(t, q)
    }
    #[inline(always)]
    fn initial(&self) -> sim_kernel::Initial<[S; 2]> {
        self.initial()
    }
}
#[allow(clippy::all, clippy::pedantic)]
impl<S: sim_kernel::Scalar> sim_kernel::Compiled<S> for SliderCrank<S> {
    const DESCRIPTION: sim_kernel::Description = sim_kernel::Description {
        name: "slider-crank",
        type_name: "SliderCrank",
        docs: "Offset slider-crank: crank, connecting rod and piston under gravity, let go with the crank along the guide\nat 20 rad/s.",
        declaration: "/// Offset slider-crank: crank, connecting rod and piston under gravity, let go with the crank along the guide\n/// at 20 rad/s.\npub SliderCrank;\n\ncoordinates {\n    /// Angle of the crank.\n    theta [rad];\n    /// Angle of the rod.\n    phi [rad];\n}\n\nparameters {\n    /// Length of the crank.\n    r [m] = 0.15;\n    /// Length of the rod.\n    l [m] = 0.45;\n    /// Height of the guide.\n    offset [m] = 0.03;\n    /// Mass of the crank, a slender rod.\n    m1 [kg] = 1;\n    /// Mass of the rod, slender.\n    m2 [kg] = 2;\n    /// Mass of the piston.\n    m3 [kg] = 1.5;\n    g [m/s^2] = 9.81;\n    /// Torque on the crank.\n    T [N*m] = 0;\n}\n\nlet O = [0, 0];\nlet A = r*[cos(theta), sin(theta)];\nlet rod = [cos(phi), sin(phi)];\nlet C = A + l*rod;\n\nbodies {\n    crank: mass m1 at A/2, inertia m1*r^2/12, angle theta;\n    connecting_rod: mass m2 at A + l/2*rod, inertia m2*l^2/12, angle phi;\n    piston: mass m3 at C;\n}\n\nloads {\n    gravity [0, -g];\n    torque T on crank;\n}\n\nconstraints { guide: C.y = offset; }\n\ninitial {\n    theta = 0;\n    dot(theta) = 20;\n    guess phi = 0.07;\n}\n\nevents {\n    period: theta = 2*pi;\n    /// The piston turns back.\n    dead_point: dot(C.x) = 0;\n}\n\noutputs {\n    angular_speeds \"Angular speeds\" {\n        /// crank\n        crank_speed [rad/s] = dot(theta);\n        /// rod\n        rod_speed [rad/s] = dot(phi);\n    }\n    piston_position \"Position of the piston\" {\n        /// position\n        x [m] = C.x;\n    }\n    piston_velocity \"Velocity of the piston\" {\n        /// velocity\n        x_velocity [m/s] = dot(C.x);\n    }\n    piston_acceleration \"Acceleration of the piston\" {\n        /// acceleration\n        x_acceleration [m/s^2] = ddot(C.x);\n    }\n    wall \"Force of the wall on the piston\" {\n        /// along +y\n        wall_force [N] = -reaction(guide);\n    }\n}\n\ndrawing {\n    ground O;\n    line O, A, C;\n    slider C along 0;\n}\n",
        declaration_hash: "55d30af3ac0589edc11f3e72d83a2667",
        coordinates: &[
            sim_kernel::Coordinate {
                position: sim_kernel::Quantity {
                    name: "theta",
                    unit: "rad",
                    factor: 1f64,
                    is_length: false,
                    docs: "Angle of the crank.",
                },
                speed: sim_kernel::Quantity {
                    name: "theta_dot",
                    unit: "rad/s",
                    factor: 1f64,
                    is_length: false,
                    docs: "",
                },
                acceleration: sim_kernel::Quantity {
                    name: "theta_ddot",
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
                    docs: "Angle of the rod.",
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
                start: sim_kernel::Start::Guess,
                speed_given: false,
            },
        ],
        mixes_lengths: false,
        parameters: &[
            sim_kernel::Quantity {
                name: "r",
                unit: "m",
                factor: 1f64,
                is_length: true,
                docs: "Length of the crank.",
            },
            sim_kernel::Quantity {
                name: "l",
                unit: "m",
                factor: 1f64,
                is_length: true,
                docs: "Length of the rod.",
            },
            sim_kernel::Quantity {
                name: "offset",
                unit: "m",
                factor: 1f64,
                is_length: true,
                docs: "Height of the guide.",
            },
            sim_kernel::Quantity {
                name: "m1",
                unit: "kg",
                factor: 1f64,
                is_length: false,
                docs: "Mass of the crank, a slender rod.",
            },
            sim_kernel::Quantity {
                name: "m2",
                unit: "kg",
                factor: 1f64,
                is_length: false,
                docs: "Mass of the rod, slender.",
            },
            sim_kernel::Quantity {
                name: "m3",
                unit: "kg",
                factor: 1f64,
                is_length: false,
                docs: "Mass of the piston.",
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
                docs: "Torque on the crank.",
            },
        ],
        inputs: &[],
        constraints: &[
            sim_kernel::Quantity {
                name: "guide",
                unit: "N",
                factor: 1f64,
                is_length: false,
                docs: "",
            },
        ],
        speed_constraints: &[],
        norm_constraints: &[],
        sparsity: &[],
        common_column: ::core::option::Option::None,
        conditionals: &[],
        events: &[
            sim_kernel::event::Event {
                name: "period",
                direction: sim_kernel::event::Direction::Both,
                on_motion: true,
                on_forces: false,
                steps: &[],
            },
            sim_kernel::event::Event {
                name: "dead_point",
                direction: sim_kernel::event::Direction::Both,
                on_motion: true,
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
                docs: "crank",
            },
            sim_kernel::Quantity {
                name: "rod_speed",
                unit: "rad/s",
                factor: 1f64,
                is_length: false,
                docs: "rod",
            },
            sim_kernel::Quantity {
                name: "x",
                unit: "m",
                factor: 1f64,
                is_length: true,
                docs: "position",
            },
            sim_kernel::Quantity {
                name: "x_velocity",
                unit: "m/s",
                factor: 1f64,
                is_length: false,
                docs: "velocity",
            },
            sim_kernel::Quantity {
                name: "x_acceleration",
                unit: "m/s^2",
                factor: 1f64,
                is_length: false,
                docs: "acceleration",
            },
            sim_kernel::Quantity {
                name: "wall_force",
                unit: "N",
                factor: 1f64,
                is_length: false,
                docs: "along +y",
            },
        ],
        rated_outputs: &[0, 1, 2, 3],
        figures: &[
            sim_kernel::Figure {
                name: "angular_speeds",
                title: "Angular speeds",
                len: 2,
            },
            sim_kernel::Figure {
                name: "piston_position",
                title: "Position of the piston",
                len: 1,
            },
            sim_kernel::Figure {
                name: "piston_velocity",
                title: "Velocity of the piston",
                len: 1,
            },
            sim_kernel::Figure {
                name: "piston_acceleration",
                title: "Acceleration of the piston",
                len: 1,
            },
            sim_kernel::Figure {
                name: "wall",
                title: "Force of the wall on the piston",
                len: 1,
            },
        ],
        optional_kernels: &["dynamics_jacobian"],
        dimension: 2,
        drawing: &[
            sim_kernel::Shape::Ground(1),
            sim_kernel::Shape::Line(3),
            sim_kernel::Shape::Slider,
        ],
        run: &[],
        switching: &[],
        load_conditions: &[],
    };
    fn defaults() -> Self {
        Self {
            r: S::from_f64(0.15f64),
            l: S::from_f64(0.45f64),
            offset: S::from_f64(0.03f64),
            m1: S::from_f64(1f64),
            m2: S::from_f64(2f64),
            m3: S::from_f64(1.5f64),
            g: S::from_f64(9.81f64),
            T: S::from_f64(0f64),
        }
    }
}
