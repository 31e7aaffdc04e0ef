/// Quick-return mechanism: crank 2 drives rocker 4 through slider 3; bar 5 pushes slider 6 along a guide.
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
/// coordinates = [alpha; beta; gamma]
/// multipliers = [lambda_guide; lambda_slot]
/// constraints = 0
/// [
///     J2 + O2A^2*m3, 0, 0, 0, constraint_jacobian[2, 1];
///     0, mass_matrix[2, 2], mass_matrix[2, 3], B_x, constraint_jacobian[2, 2];
///     0, mass_matrix[2, 3], mass_matrix[3, 3], BC*cos(gamma), 0;
///     0, B_x, BC*cos(gamma), 0, 0;
///     constraint_jacobian[2, 1], constraint_jacobian[2, 2], 0, 0, 0
/// ] * [
///     alpha_ddot;
///     beta_ddot;
///     gamma_ddot;
///     lambda_guide;
///     lambda_slot
/// ] = [
///     T;
///     -O4B*F*sin(beta) - convective_forces[2];
///     -BC*F*sin(gamma) - convective_forces[3];
///     -constraint_convective[1];
///     s_5*alpha_dot - s_6*beta_dot
/// ]
///
/// mass_matrix = [
///     J2 + O2A^2*m3, 0, 0;
///     0, mass_matrix[2, 2], mass_matrix[2, 3];
///     0, mass_matrix[2, 3], mass_matrix[3, 3]
/// ]
/// mass_matrix[2, 2] = J3 + J4 + O4G4^2*m4 + O4B^2*m5 + O4B^2*m6
/// mass_matrix[2, 3] = O4B*BG5*m5*sin(beta)*sin(gamma) + O4B*BG5*m5*cos(beta)*cos(gamma)
///     + O4B*BC*m6*sin(beta)*sin(gamma) + O4B*BC*m6*cos(beta)*cos(gamma)
/// mass_matrix[3, 3] = J5 + BG5^2*m5 + BC^2*m6
///
/// convective_forces = [0; convective_forces[2]; convective_forces[3]]
/// convective_forces[2] = O4B*m5*s_1*sin(beta) + O4B*m6*s_3*sin(beta) - O4B*m5*s_2*cos(beta)
///     - O4B*m6*s_4*cos(beta)
/// convective_forces[3] = BG5*m5*s_1*sin(gamma) + BC*m6*s_3*sin(gamma) - BG5*m5*s_2*cos(gamma)
///     - BC*m6*s_4*cos(gamma)
///
/// generalized_forces = [T; -O4B*F*sin(beta); -BC*F*sin(gamma)]
///
/// constraints = [B_y - yc + BC*sin(gamma); constraints[2]]
/// constraints[2] = A_y*cos(beta) - O2A*cos(alpha)*sin(beta)
///
/// constraint_jacobian = [
///     0, B_x, BC*cos(gamma);
///     constraint_jacobian[2, 1], constraint_jacobian[2, 2], 0
/// ]
/// constraint_jacobian[2, 1] = O2A*cos(alpha)*cos(beta) + O2A*sin(alpha)*sin(beta)
/// constraint_jacobian[2, 2] = -O2A*cos(alpha)*cos(beta) - A_y*sin(beta)
///
/// constraint_convective = [
///     constraint_convective[1];
///     s_6*beta_dot - s_5*alpha_dot
/// ]
/// constraint_convective[1] = -O4B*beta_dot^2*sin(beta) - BC*gamma_dot^2*sin(gamma)
///
/// A_y = O4O2 + O2A*sin(alpha)
/// B_x = O4B*cos(beta)
/// B_y = O4B*sin(beta)
/// s_1 = O4B*beta_dot^2*cos(beta) + BG5*gamma_dot^2*cos(gamma)
/// s_2 = O4B*beta_dot^2*sin(beta) + BG5*gamma_dot^2*sin(gamma)
/// s_3 = O4B*beta_dot^2*cos(beta) + BC*gamma_dot^2*cos(gamma)
/// s_4 = O4B*beta_dot^2*sin(beta) + BC*gamma_dot^2*sin(gamma)
/// s_5 = O2A*alpha_dot*sin(alpha)*cos(beta) + O2A*beta_dot*cos(alpha)*sin(beta)
///     - O2A*alpha_dot*cos(alpha)*sin(beta) - O2A*beta_dot*sin(alpha)*cos(beta)
/// s_6 = O2A*alpha_dot*sin(alpha)*cos(beta) + O2A*beta_dot*cos(alpha)*sin(beta)
///     - O2A*alpha_dot*cos(alpha)*sin(beta) - A_y*beta_dot*cos(beta)
/// ```
#[allow(non_snake_case)]
#[derive(
    ::core::clone::Clone,
    ::core::marker::Copy,
    ::core::fmt::Debug,
    ::core::cmp::PartialEq
)]
pub struct QuickReturn<S = ::core::primitive::f64> {
    /// Length of crank 2, in `m`.
    pub O2A: S,
    /// Length of rocker 4, in `m`.
    pub O4B: S,
    /// Length of bar 5, in `m`.
    pub BC: S,
    /// Distance of the fixed pivots, in `m`.
    pub O4O2: S,
    /// Centre of mass of rocker 4, in `m`.
    pub O4G4: S,
    /// Centre of mass of bar 5, in `m`.
    pub BG5: S,
    /// Height of the guide, in `m`.
    pub yc: S,
    /// Mass of slider 3, in `kg`.
    pub m3: S,
    /// Mass of rocker 4, in `kg`.
    pub m4: S,
    /// Mass of bar 5, in `kg`.
    pub m5: S,
    /// Mass of slider 6, in `kg`.
    pub m6: S,
    /// Inertia of crank 2 with its flywheel, about O2, in `kg*m^2`.
    pub J2: S,
    /// Inertia of slider 3, in `kg*m^2`.
    pub J3: S,
    /// Inertia of rocker 4, in `kg*m^2`.
    pub J4: S,
    /// Inertia of bar 5, in `kg*m^2`.
    pub J5: S,
    /// Force on slider 6, along +x, in `N`.
    pub F: S,
    /// Torque on crank 2, in `N*m`.
    pub T: S,
}
impl<S: sim_kernel::Scalar> ::core::default::Default for QuickReturn<S> {
    /// The declared values.
    fn default() -> Self {
        <Self as sim_kernel::Compiled<S>>::defaults()
    }
}
/// Coordinates of [`QuickReturn`] by name, in SI units; also for their speeds and accelerations.
#[allow(non_snake_case)]
#[derive(
    ::core::clone::Clone,
    ::core::marker::Copy,
    ::core::fmt::Debug,
    ::core::cmp::PartialEq
)]
pub struct QuickReturnCoordinates<S = ::core::primitive::f64> {
    /// Angle of crank 2, in `rad`.
    pub alpha: S,
    /// Angle of rocker 4, and of slider 3 on it, in `rad`.
    pub beta: S,
    /// Angle of bar 5, in `rad`.
    pub gamma: S,
}
impl<S: sim_kernel::Scalar> ::core::convert::From<[S; 3]> for QuickReturnCoordinates<S> {
    fn from(values: [S; 3]) -> Self {
        Self {
            alpha: values[0],
            beta: values[1],
            gamma: values[2],
        }
    }
}
impl<S: sim_kernel::Scalar> ::core::convert::From<QuickReturnCoordinates<S>> for [S; 3] {
    fn from(record: QuickReturnCoordinates<S>) -> Self {
        [record.alpha, record.beta, record.gamma]
    }
}
/// Outputs of [`QuickReturn`] by name, in SI units.
#[allow(non_snake_case)]
#[derive(
    ::core::clone::Clone,
    ::core::marker::Copy,
    ::core::fmt::Debug,
    ::core::cmp::PartialEq
)]
pub struct QuickReturnOutputs<S = ::core::primitive::f64> {
    /// crank 2, in `rad/s`.
    pub crank_speed: S,
    /// rocker 4, in `rad/s`.
    pub rocker_speed: S,
    /// bar 5, in `rad/s`.
    pub bar_speed: S,
    /// sliding speed, d|O4 A|/dt, in `m/s`.
    pub sliding_speed: S,
    /// the report's |v_A| - |v_G4|, in `m/s`.
    pub speed_difference: S,
    /// position, in `m`.
    pub x6: S,
    /// velocity, in `m/s`.
    pub x6_velocity: S,
    /// acceleration, in `m/s^2`.
    pub x6_acceleration: S,
    /// slider 3 on rocker 4, in `N`.
    pub normal_force_slider3: S,
    /// slider 6 on the ground, in `N`.
    pub normal_force_slider6: S,
}
impl<S: sim_kernel::Scalar> ::core::convert::From<[S; 10]> for QuickReturnOutputs<S> {
    fn from(values: [S; 10]) -> Self {
        Self {
            crank_speed: values[0],
            rocker_speed: values[1],
            bar_speed: values[2],
            sliding_speed: values[3],
            speed_difference: values[4],
            x6: values[5],
            x6_velocity: values[6],
            x6_acceleration: values[7],
            normal_force_slider3: values[8],
            normal_force_slider6: values[9],
        }
    }
}
impl<S: sim_kernel::Scalar> ::core::convert::From<QuickReturnOutputs<S>> for [S; 10] {
    fn from(record: QuickReturnOutputs<S>) -> Self {
        [
            record.crank_speed,
            record.rocker_speed,
            record.bar_speed,
            record.sliding_speed,
            record.speed_difference,
            record.x6,
            record.x6_velocity,
            record.x6_acceleration,
            record.normal_force_slider3,
            record.normal_force_slider6,
        ]
    }
}
/// Rates of the outputs of [`QuickReturn`] by name, in SI units.
#[allow(non_snake_case)]
#[derive(
    ::core::clone::Clone,
    ::core::marker::Copy,
    ::core::fmt::Debug,
    ::core::cmp::PartialEq
)]
pub struct QuickReturnOutputRates<S = ::core::primitive::f64> {
    /// Rate of `crank_speed`.
    pub crank_speed: S,
    /// Rate of `rocker_speed`.
    pub rocker_speed: S,
    /// Rate of `bar_speed`.
    pub bar_speed: S,
    /// Rate of `sliding_speed`.
    pub sliding_speed: S,
    /// Rate of `speed_difference`.
    pub speed_difference: S,
    /// Rate of `x6`.
    pub x6: S,
    /// Rate of `x6_velocity`.
    pub x6_velocity: S,
}
impl<S: sim_kernel::Scalar> ::core::convert::From<[S; 7]> for QuickReturnOutputRates<S> {
    fn from(values: [S; 7]) -> Self {
        Self {
            crank_speed: values[0],
            rocker_speed: values[1],
            bar_speed: values[2],
            sliding_speed: values[3],
            speed_difference: values[4],
            x6: values[5],
            x6_velocity: values[6],
        }
    }
}
impl<S: sim_kernel::Scalar> ::core::convert::From<QuickReturnOutputRates<S>> for [S; 7] {
    fn from(record: QuickReturnOutputRates<S>) -> Self {
        [
            record.crank_speed,
            record.rocker_speed,
            record.bar_speed,
            record.sliding_speed,
            record.speed_difference,
            record.x6,
            record.x6_velocity,
        ]
    }
}
/// What the equations of motion need of the parameters of [`QuickReturn`], from [`QuickReturn::prepare`]; its methods are the kernels of each step.
#[allow(non_snake_case)]
#[derive(
    ::core::clone::Clone,
    ::core::marker::Copy,
    ::core::fmt::Debug,
    ::core::cmp::PartialEq
)]
pub struct QuickReturnPrepared<S = ::core::primitive::f64> {
    O2A: S,
    mass_alpha_alpha: S,
    O4B: S,
    mass_beta_beta: S,
    BG5: S,
    BC: S,
    k: S,
    mass_gamma_gamma: S,
    O4O2: S,
    T: S,
    k_2: S,
    k_3: S,
    k_4: S,
    k_5: S,
    k_6: S,
    k_7: S,
    k_8: S,
    inverse_gamma: S,
    inverse_alpha: S,
    k_9: S,
    k_10: S,
    k_11: S,
    k_12: S,
    k_13: S,
    k_14: S,
    k_15: S,
}
#[allow(non_snake_case, unused_variables, unused_parens, clippy::all, clippy::pedantic)]
impl<S: sim_kernel::Scalar> QuickReturn<S> {
    /// What the equations of motion need of the parameters, computed once for a set of parameters.
    ///
    /// Operations: 12 additions, 25 multiplications, 2 divisions.
    #[inline]
    pub fn prepare(&self) -> QuickReturnPrepared<S> {
        let mass_alpha_alpha = self.J2 + self.O2A * self.O2A * self.m3;
        let O4B_squared = self.O4B * self.O4B;
        let w = O4B_squared * self.m5;
        let w_2 = O4B_squared * self.m6;
        let w_3 = self.O4B * self.m5;
        let w_4 = self.BG5 * w_3;
        let w_5 = self.O4B * self.m6;
        let w_6 = self.m5 * self.BG5 * self.BG5;
        let w_7 = self.m6 * self.BC * self.BC;
        let mass_gamma_gamma = self.J5 + w_6 + w_7;
        let inverse_mass_alpha_alpha = S::from_f64(1.0) / mass_alpha_alpha;
        let w_8 = self.BC * S::from_f64(2.0);
        QuickReturnPrepared {
            O2A: self.O2A,
            mass_alpha_alpha: mass_alpha_alpha,
            O4B: self.O4B,
            mass_beta_beta: self.J3 + self.J4 + self.O4G4 * self.O4G4 * self.m4 + w
                + w_2,
            BG5: self.BG5,
            BC: self.BC,
            k: w_4 + self.BC * w_5,
            mass_gamma_gamma: mass_gamma_gamma,
            O4O2: self.O4O2,
            T: self.T,
            k_2: w_3,
            k_3: w_5,
            k_4: self.O4B * self.F,
            k_5: self.m5 * self.BG5,
            k_6: self.m6 * self.BC,
            k_7: self.BC * self.F,
            k_8: self.O2A * S::from_f64(2.0),
            inverse_gamma: S::from_f64(1.0) / mass_gamma_gamma,
            inverse_alpha: inverse_mass_alpha_alpha,
            k_9: self.T * inverse_mass_alpha_alpha,
            k_10: w + w_2,
            k_11: w_6 + w_7,
            k_12: w_4 * S::from_f64(2.0) + w_5 * w_8,
            k_13: self.O4B * S::from_f64(2.0),
            k_14: S::from_f64(1.0) + S::from_f64(1.0),
            k_15: w_8,
        }
    }
    /// Mass matrix `T_q' M T_q`, 3 x 3, symmetric, in SI units.
    ///
    /// Operations: 9 additions, 18 multiplications, 2 sine-cosine pairs.
    #[inline]
    pub fn mass_matrix(&self, t: S, q: &[S; 3]) -> [[S; 3]; 3] {
        let [_, beta, gamma] = *q;
        let O4B_squared = self.O4B * self.O4B;
        let ([sin_beta, sin_gamma], [cos_beta, cos_gamma]) = S::sin_cos_each([
            beta,
            gamma,
        ]);
        let mass_gamma_beta = (self.O4B * self.m5 * self.BG5
            + self.O4B * self.m6 * self.BC)
            * (sin_beta * sin_gamma + cos_beta * cos_gamma);
        [
            [
                self.J2 + self.O2A * self.O2A * self.m3,
                S::from_f64(0.0),
                S::from_f64(0.0),
            ],
            [
                S::from_f64(0.0),
                self.J3 + self.J4 + self.O4G4 * self.O4G4 * self.m4
                    + O4B_squared * self.m5 + O4B_squared * self.m6,
                mass_gamma_beta,
            ],
            [
                S::from_f64(0.0),
                mass_gamma_beta,
                self.J5 + self.m5 * self.BG5 * self.BG5 + self.m6 * self.BC * self.BC,
            ],
        ]
    }
    /// Convective forces `T_q' M g`, 3, with `g = (T_q q' + T_t)_q q' + (..)_t`: joules per unit of each coordinate.
    ///
    /// Operations: 3 additions, 12 multiplications, 2 sine-cosine pairs.
    #[inline]
    pub fn convective_forces(&self, t: S, q: &[S; 3], qd: &[S; 3]) -> [S; 3] {
        let [_, beta, gamma] = *q;
        let [_, beta_dot, gamma_dot] = *qd;
        let w = self.O4B * self.m5 * self.BG5 + self.O4B * self.m6 * self.BC;
        let ([sin_beta, sin_gamma], [cos_beta, cos_gamma]) = S::sin_cos_each([
            beta,
            gamma,
        ]);
        let w_2 = sin_beta * cos_gamma - cos_beta * sin_gamma;
        [
            S::from_f64(0.0),
            w * gamma_dot * gamma_dot * w_2,
            -(beta_dot * beta_dot * w * w_2),
        ]
    }
    /// Generalised forces `T_q' F`, 3: joules per unit of each coordinate.
    ///
    /// Operations: 2 additions, 4 multiplications, 2 sine-cosine pairs.
    #[inline]
    pub fn generalized_forces(&self, t: S, q: &[S; 3], qd: &[S; 3]) -> [S; 3] {
        let [_, beta, gamma] = *q;
        let ([sin_beta, sin_gamma], [_, _]) = S::sin_cos_each([beta, gamma]);
        [self.T, -(sin_beta * self.O4B * self.F), -(sin_gamma * self.F * self.BC)]
    }
    /// Constraints `C`, 2, in SI units; zero throughout the motion.
    ///
    /// Operations: 4 additions, 6 multiplications, 3 sine-cosine pairs.
    #[inline]
    pub fn constraints(&self, t: S, q: &[S; 3]) -> [S; 2] {
        let [alpha, beta, gamma] = *q;
        let ([sin_beta, sin_gamma, sin_alpha], [cos_beta, _, cos_alpha]) = S::sin_cos_each([
            beta,
            gamma,
            alpha,
        ]);
        [
            self.O4B * sin_beta - self.yc + self.BC * sin_gamma,
            (self.O4O2 + self.O2A * sin_alpha) * cos_beta
                - sin_beta * self.O2A * cos_alpha,
        ]
    }
    /// The sum of the magnitudes of the terms of `C`, 2, in SI units: what its rounding is relative to.
    ///
    /// Operations: 9 additions, 6 multiplications, 3 sine-cosine pairs.
    #[inline]
    pub fn constraint_magnitudes(&self, t: S, q: &[S; 3]) -> [S; 2] {
        let [alpha, beta, gamma] = *q;
        let ([sin_beta, sin_gamma, sin_alpha], [cos_beta, _, cos_alpha]) = S::sin_cos_each([
            beta,
            gamma,
            alpha,
        ]);
        [
            self.yc.abs() + (self.O4B * sin_beta).abs() + (self.BC * sin_gamma).abs(),
            ((self.O4O2 + self.O2A * sin_alpha) * cos_beta).abs()
                + (sin_beta * self.O2A * cos_alpha).abs(),
        ]
    }
    /// Constraint Jacobian `C_q`, 2 x 3: units of each constraint per unit of each coordinate.
    ///
    /// Operations: 4 additions, 8 multiplications, 3 sine-cosine pairs.
    #[inline]
    pub fn constraint_jacobian(&self, t: S, q: &[S; 3]) -> [[S; 3]; 2] {
        let [alpha, beta, gamma] = *q;
        let ([sin_beta, _, sin_alpha], [cos_beta, cos_gamma, cos_alpha]) = S::sin_cos_each([
            beta,
            gamma,
            alpha,
        ]);
        let w = cos_beta * cos_alpha;
        [
            [S::from_f64(0.0), self.O4B * cos_beta, self.BC * cos_gamma],
            [
                self.O2A * (w + sin_alpha * sin_beta),
                -(self.O2A * w + sin_beta * (self.O4O2 + self.O2A * sin_alpha)),
                S::from_f64(0.0),
            ],
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
    /// Operations: 7 additions, 18 multiplications, 3 sine-cosine pairs.
    #[inline]
    pub fn constraint_convective(&self, t: S, q: &[S; 3], qd: &[S; 3]) -> [S; 2] {
        let [alpha, beta, gamma] = *q;
        let [alpha_dot, beta_dot, gamma_dot] = *qd;
        let beta_dot_squared = beta_dot * beta_dot;
        let ([sin_beta, sin_gamma, sin_alpha], [cos_beta, _, cos_alpha]) = S::sin_cos_each([
            beta,
            gamma,
            alpha,
        ]);
        let w = sin_beta * cos_alpha;
        let w_2 = sin_alpha * cos_beta;
        let w_3 = w - w_2;
        [
            -(beta_dot_squared * self.O4B * sin_beta
                + gamma_dot * gamma_dot * self.BC * sin_gamma),
            self.O2A * (beta_dot_squared * w_3 - (w_2 - w) * alpha_dot * alpha_dot)
                - beta_dot * alpha_dot * w_3 * self.O2A * S::from_f64(2.0)
                - beta_dot_squared * cos_beta * self.O4O2,
        ]
    }
    /// `C` (2), `C_q` (2 x 3) and `C_t` (2) together, in SI units, for projection.
    ///
    /// Operations: 7 additions, 13 multiplications, 3 sine-cosine pairs.
    #[inline]
    pub fn constraint_linearization(
        &self,
        t: S,
        q: &[S; 3],
    ) -> sim_kernel::ConstraintLinearization<[S; 2], [[S; 3]; 2]> {
        let [alpha, beta, gamma] = *q;
        let ([sin_beta, sin_gamma, sin_alpha], [cos_beta, cos_gamma, cos_alpha]) = S::sin_cos_each([
            beta,
            gamma,
            alpha,
        ]);
        let A_y = self.O4O2 + self.O2A * sin_alpha;
        let w = self.O2A * cos_alpha;
        sim_kernel::ConstraintLinearization {
            values: [
                self.O4B * sin_beta - self.yc + self.BC * sin_gamma,
                A_y * cos_beta - sin_beta * w,
            ],
            jacobian: [
                [S::from_f64(0.0), self.O4B * cos_beta, self.BC * cos_gamma],
                [
                    self.O2A * (cos_beta * cos_alpha + sin_beta * sin_alpha),
                    -(cos_beta * w + sin_beta * A_y),
                    S::from_f64(0.0),
                ],
            ],
            time_derivative: [S::from_f64(0.0), S::from_f64(0.0)],
        }
    }
    /// Kinetic energy `v' M v / 2`, in joules.
    ///
    /// Operations: 13 additions, 33 multiplications, 2 sine-cosine pairs.
    #[inline]
    pub fn kinetic_energy(&self, t: S, q: &[S; 3], qd: &[S; 3]) -> S {
        let [_, beta, gamma] = *q;
        let [alpha_dot, beta_dot, gamma_dot] = *qd;
        let ([sin_beta, sin_gamma], [cos_beta, cos_gamma]) = S::sin_cos_each([
            beta,
            gamma,
        ]);
        let w = beta_dot * self.O4B;
        let w_2 = sin_beta * w;
        let w_3 = gamma_dot * self.BG5;
        let w_4 = w_2 + sin_gamma * w_3;
        let w_5 = w * cos_beta;
        let w_6 = w_5 + w_3 * cos_gamma;
        let w_7 = gamma_dot * self.BC;
        let w_8 = w_2 + sin_gamma * w_7;
        let w_9 = w_5 + cos_gamma * w_7;
        let w_10 = alpha_dot * alpha_dot
            * (S::from_f64(0.5) * self.J2
                + S::from_f64(0.5) * self.O2A * self.O2A * self.m3);
        let w_11 = beta_dot * beta_dot
            * (S::from_f64(0.5) * self.J3 + S::from_f64(0.5) * self.J4
                + S::from_f64(0.5) * self.O4G4 * self.O4G4 * self.m4);
        S::from_f64(0.5) * self.m5 * (w_4 * w_4 + w_6 * w_6)
            + S::from_f64(0.5) * self.m6 * (w_8 * w_8 + w_9 * w_9) + w_10 + w_11
            + gamma_dot * gamma_dot * S::from_f64(0.5) * self.J5
    }
    /// Power of loads and drives, `F' v + lambda' C_t + T_t' (M x'' - F)`, in watts.
    ///
    /// Operations: 2 additions, 7 multiplications, 2 sine-cosine pairs.
    #[inline]
    pub fn power(
        &self,
        t: S,
        q: &[S; 3],
        qd: &[S; 3],
        qdd: &[S; 3],
        lambda: &[S; 2],
    ) -> S {
        let [_, beta, gamma] = *q;
        let [alpha_dot, beta_dot, gamma_dot] = *qd;
        let ([sin_beta, sin_gamma], [_, _]) = S::sin_cos_each([beta, gamma]);
        alpha_dot * self.T - beta_dot * sin_beta * self.F * self.O4B
            - gamma_dot * sin_gamma * self.F * self.BC
    }
    /// Outputs, 10, in SI units.
    ///
    /// Operations: 12 additions, 28 multiplications, 1 division, 3 sine-cosine pairs, 3 square roots.
    #[inline]
    pub fn outputs(
        &self,
        t: S,
        q: &[S; 3],
        qd: &[S; 3],
        qdd: &[S; 3],
        lambda: &[S; 2],
    ) -> QuickReturnOutputs<S> {
        let [alpha, beta, gamma] = *q;
        let [alpha_dot, beta_dot, gamma_dot] = *qd;
        let [_, beta_ddot, gamma_ddot] = *qdd;
        let [lambda_guide, lambda_slot] = *lambda;
        let ([sin_alpha, sin_beta, sin_gamma], [cos_alpha, cos_beta, cos_gamma]) = S::sin_cos_each([
            alpha,
            beta,
            gamma,
        ]);
        let A_y = self.O4O2 + self.O2A * sin_alpha;
        let O2A_squared = self.O2A * self.O2A;
        let w = A_y * A_y + O2A_squared * cos_alpha * cos_alpha;
        let beta_dot_squared = beta_dot * beta_dot;
        [
            alpha_dot,
            beta_dot,
            gamma_dot,
            -(w.sqrt() * alpha_dot * cos_alpha
                * (O2A_squared * sin_alpha - self.O2A * A_y) / w),
            (O2A_squared * alpha_dot * alpha_dot).sqrt()
                - (beta_dot_squared * self.O4G4 * self.O4G4).sqrt(),
            self.O4B * cos_beta + self.BC * cos_gamma,
            -(beta_dot * self.O4B * sin_beta + gamma_dot * self.BC * sin_gamma),
            -(self.O4B * (sin_beta * beta_ddot + beta_dot_squared * cos_beta)
                + self.BC
                    * (sin_gamma * gamma_ddot + cos_gamma * gamma_dot * gamma_dot)),
            lambda_slot,
            lambda_guide,
        ]
            .into()
    }
    /// Rates of the outputs that depend on neither accelerations nor multipliers, 7, in SI units per second.
    ///
    /// Operations: 13 additions, 40 multiplications, 4 divisions, 3 sine-cosine pairs, 3 square roots.
    #[inline]
    pub fn output_rates(
        &self,
        t: S,
        q: &[S; 3],
        qd: &[S; 3],
        qdd: &[S; 3],
    ) -> QuickReturnOutputRates<S> {
        let [alpha, beta, gamma] = *q;
        let [alpha_dot, beta_dot, gamma_dot] = *qd;
        let [alpha_ddot, beta_ddot, gamma_ddot] = *qdd;
        let ([sin_alpha, sin_beta, sin_gamma], [cos_alpha, cos_beta, cos_gamma]) = S::sin_cos_each([
            alpha,
            beta,
            gamma,
        ]);
        let w = self.O2A * sin_alpha;
        let A_y = self.O4O2 + w;
        let O2A_squared = self.O2A * self.O2A;
        let w_2 = A_y * A_y + O2A_squared * cos_alpha * cos_alpha;
        let alpha_dot_squared = alpha_dot * alpha_dot;
        let w_3 = O2A_squared * sin_alpha - self.O2A * A_y;
        let w_4 = cos_alpha * alpha_dot * w_3;
        let w_5 = O2A_squared * alpha_dot_squared;
        let O4G4_squared = self.O4G4 * self.O4G4;
        let beta_dot_squared = beta_dot * beta_dot;
        let w_6 = beta_dot_squared * O4G4_squared;
        [
            alpha_ddot,
            beta_ddot,
            gamma_ddot,
            w_2.sqrt()
                * ((alpha_dot_squared * (O2A_squared * sin_alpha * sin_alpha - w * A_y)
                    - alpha_ddot * cos_alpha * w_3) / w_2 - w_4 * w_4 / (w_2 * w_2)),
            alpha_ddot * O2A_squared * alpha_dot * w_5.sqrt() / w_5
                - beta_ddot * beta_dot * O4G4_squared * w_6.sqrt() / w_6,
            -(beta_dot * self.O4B * sin_beta + gamma_dot * self.BC * sin_gamma),
            -(self.O4B * (beta_ddot * sin_beta + beta_dot_squared * cos_beta)
                + self.BC * (gamma_ddot * sin_gamma + gamma_dot * gamma_dot * cos_gamma)),
        ]
            .into()
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
        let [alpha, _, _] = *q;
        [alpha - S::from_f64(2.0) * S::from_f64(::core::f64::consts::PI)]
    }
    /// The numbers of each shape of the drawing, in metres and radians.
    ///
    /// Operations: 5 additions, 10 multiplications, 3 sine-cosine pairs.
    #[inline]
    pub fn drawing(&self, t: S, q: &[S; 3]) -> [S; 24] {
        let [alpha, beta, gamma] = *q;
        let ([sin_alpha, sin_beta, sin_gamma], [cos_alpha, cos_beta, cos_gamma]) = S::sin_cos_each([
            alpha,
            beta,
            gamma,
        ]);
        let A_x = self.O2A * cos_alpha;
        let A_y = self.O4O2 + self.O2A * sin_alpha;
        let B_x = self.O4B * cos_beta;
        let B_y = self.O4B * sin_beta;
        let C_x = B_x + self.BC * cos_gamma;
        let C_y = B_y + self.BC * sin_gamma;
        [
            S::from_f64(0.0),
            self.O4O2,
            S::from_f64(0.0),
            S::from_f64(0.0),
            S::from_f64(0.0),
            self.O4O2,
            A_x,
            A_y,
            S::from_f64(0.0),
            S::from_f64(0.0),
            B_x,
            B_y,
            C_x,
            C_y,
            A_x,
            A_y,
            beta,
            C_x,
            C_y,
            S::from_f64(0.0),
            cos_beta * self.O4G4,
            sin_beta * self.O4G4,
            B_x + cos_gamma * self.BG5,
            B_y + sin_gamma * self.BG5,
        ]
    }
    /// Declared start: values or guesses of the coordinates (3), and speeds (3), in SI units; 0 where nothing is declared.
    ///
    /// Operations: 1 multiplication.
    #[inline]
    pub fn initial(&self) -> sim_kernel::Initial<[S; 3]> {
        sim_kernel::Initial {
            positions: [S::from_f64(0.0), S::from_f64(1.0), S::from_f64(2.6)],
            speeds: [
                S::from_f64(2.5) * S::from_f64(::core::f64::consts::PI),
                S::from_f64(0.0),
                S::from_f64(0.0),
            ],
        }
    }
    /// [`QuickReturnPrepared::dynamics`] once; for many calls with the same parameters [`Self::prepare`] first.
    #[inline]
    pub fn dynamics(
        &self,
        t: S,
        q: &[S; 3],
        qd: &[S; 3],
    ) -> sim_kernel::Dynamics<S, [S; 3], [S; 2]> {
        self.prepare().dynamics(t, q, qd)
    }
    /// [`QuickReturnPrepared::dynamics_jacobian`] once; for many calls with the same parameters [`Self::prepare`] first.
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
impl<S: sim_kernel::Scalar> QuickReturnPrepared<S> {
    /// Accelerations (3), multipliers (2) and power, from
    ///
    /// ```text
    /// [ T_q' M T_q   C_q' ] [ q''    ]   [ T_q' (F - M g)                      ]
    /// [ C_q          0    ] [ lambda ] = [ -(C_q q' + C_t)_q q' - (..)_t       ]
    /// ```
    ///
    /// by an elimination planned from the structure of the system. Where `refused` is set a pivot was too small and nothing else holds: solve that state from the other kernels.
    ///
    /// Operations: 33 additions, 73 multiplications, 3 divisions, 3 sine-cosine pairs.
    #[inline(always)]
    pub fn dynamics(
        &self,
        t: S,
        q: &[S; 3],
        qd: &[S; 3],
    ) -> sim_kernel::Dynamics<S, [S; 3], [S; 2]> {
        let [alpha, beta, gamma] = *q;
        let [alpha_dot, beta_dot, gamma_dot] = *qd;
        let ([sin_beta, sin_gamma, sin_alpha], [cos_beta, cos_gamma, cos_alpha]) = S::sin_cos_each([
            beta,
            gamma,
            alpha,
        ]);
        let beta_dot_squared = beta_dot * beta_dot;
        let w = self.k * beta_dot_squared;
        let rhs_gamma = sin_beta * cos_gamma * w - sin_gamma * (self.k_7 + cos_beta * w);
        let gamma_dot_squared = gamma_dot * gamma_dot;
        let w_2 = self.k * gamma_dot_squared;
        let mass_gamma_beta = self.k * (sin_beta * sin_gamma + cos_beta * cos_gamma);
        let l_beta_gamma = mass_gamma_beta * self.inverse_gamma;
        let rhs_beta = sin_gamma * cos_beta * w_2
            - sin_beta * (self.k_4 + cos_gamma * w_2) - rhs_gamma * l_beta_gamma;
        let guide_by_gamma = cos_gamma * self.BC;
        let l_lambda_guide_gamma = guide_by_gamma * self.inverse_gamma;
        let pivot_beta = self.mass_beta_beta - mass_gamma_beta * l_beta_gamma;
        let k_lambda_guide_beta = self.O4B * cos_beta
            - mass_gamma_beta * l_lambda_guide_gamma;
        let inverse_beta = S::from_f64(1.0) / pivot_beta;
        let l_lambda_guide_beta = inverse_beta * k_lambda_guide_beta;
        let rhs_lambda_guide = self.O4B * sin_beta * beta_dot_squared
            + sin_gamma * self.BC * gamma_dot_squared - rhs_gamma * l_lambda_guide_gamma
            - l_lambda_guide_beta * rhs_beta;
        let minus_pivot_lambda_guide = guide_by_gamma * l_lambda_guide_gamma
            + k_lambda_guide_beta * l_lambda_guide_beta;
        let w_3 = cos_beta * cos_alpha;
        let A_y = self.O4O2 + self.O2A * sin_alpha;
        let minus_slot_by_beta = self.O2A * w_3 + sin_beta * A_y;
        let slot_by_alpha = self.O2A * (w_3 + sin_beta * sin_alpha);
        let minus_l_lambda_slot_beta = minus_slot_by_beta * inverse_beta;
        let k_lambda_slot_lambda_guide = k_lambda_guide_beta * minus_l_lambda_slot_beta;
        let w_4 = sin_beta * cos_alpha;
        let w_5 = w_4 - cos_beta * sin_alpha;
        let w_6 = self.O2A * (alpha_dot * alpha_dot * w_5 + beta_dot_squared * w_4)
            - self.k_8 * beta_dot * alpha_dot * w_5 - cos_beta * A_y * beta_dot_squared;
        let l_lambda_slot_alpha = slot_by_alpha * self.inverse_alpha;
        let w_7 = minus_slot_by_beta * minus_l_lambda_slot_beta
            + slot_by_alpha * l_lambda_slot_alpha;
        let minus_inverse_lambda_guide = S::from_f64(1.0) / minus_pivot_lambda_guide;
        let minus_l_lambda_slot_lambda_guide = k_lambda_slot_lambda_guide
            * minus_inverse_lambda_guide;
        let pivot_lambda_slot = k_lambda_slot_lambda_guide
            * minus_l_lambda_slot_lambda_guide - w_7;
        let lambda_slot = S::from_f64(1.0) / pivot_lambda_slot
            * (minus_l_lambda_slot_beta * rhs_beta - w_6 - self.T * l_lambda_slot_alpha
                + minus_l_lambda_slot_lambda_guide * rhs_lambda_guide);
        let lambda_guide = minus_l_lambda_slot_lambda_guide * lambda_slot
            - minus_inverse_lambda_guide * rhs_lambda_guide;
        let beta_ddot = inverse_beta * rhs_beta - l_lambda_guide_beta * lambda_guide
            + minus_l_lambda_slot_beta * lambda_slot;
        sim_kernel::Dynamics {
            accelerations: [
                self.k_9 - l_lambda_slot_alpha * lambda_slot,
                beta_ddot,
                rhs_gamma * self.inverse_gamma - l_beta_gamma * beta_ddot
                    - l_lambda_guide_gamma * lambda_guide,
            ],
            multipliers: [lambda_guide, lambda_slot],
            power: self.T * alpha_dot - sin_beta * beta_dot * self.k_4
                - sin_gamma * gamma_dot * self.k_7,
            refused: sim_kernel::pivot_is_refused(
                self.mass_gamma_gamma,
                self.mass_gamma_gamma,
            ) | sim_kernel::pivot_is_refused(pivot_beta, self.mass_beta_beta)
                | sim_kernel::pivot_is_refused(
                    self.mass_alpha_alpha,
                    self.mass_alpha_alpha,
                )
                | sim_kernel::pivot_is_refused(
                    -minus_pivot_lambda_guide,
                    minus_pivot_lambda_guide,
                ) | sim_kernel::pivot_is_refused(pivot_lambda_slot, w_7),
        }
    }
    /// The derivatives of accelerations (3 rows) and multipliers (2 rows) with respect to coordinates and speeds (3 columns each): with the equations of motion as `K z = r`, the solutions of `K dz = dr - dK z`. Where `refused` is set a pivot was too small and nothing else holds.
    ///
    /// Operations: 119 additions, 201 multiplications, 3 divisions, 3 sine-cosine pairs.
    #[inline]
    pub fn dynamics_jacobian(
        &self,
        t: S,
        q: &[S; 3],
        qd: &[S; 3],
    ) -> sim_kernel::DynamicsJacobian<S, [[S; 3]; 3], [[S; 3]; 2]> {
        let [alpha, beta, gamma] = *q;
        let [alpha_dot, beta_dot, gamma_dot] = *qd;
        let beta_dot_squared = beta_dot * beta_dot;
        let ([sin_beta, sin_gamma, sin_alpha], [cos_beta, cos_gamma, cos_alpha]) = S::sin_cos_each([
            beta,
            gamma,
            alpha,
        ]);
        let w = sin_beta * cos_gamma;
        let w_2 = cos_beta * beta_dot_squared;
        let rhs_gamma = self.k * beta_dot_squared * w
            - sin_gamma * (self.k_7 + self.k * w_2);
        let w_24 = sin_gamma * cos_beta - w;
        let gamma_dot_squared = gamma_dot * gamma_dot;
        let w_3 = sin_gamma * gamma_dot_squared;
        let w_4 = cos_gamma * gamma_dot_squared;
        let mass_gamma_beta = self.k * (sin_beta * sin_gamma + cos_beta * cos_gamma);
        let l_beta_gamma = mass_gamma_beta * self.inverse_gamma;
        let rhs_beta = cos_beta * self.k * w_3 - sin_beta * (self.k_4 + self.k * w_4)
            - rhs_gamma * l_beta_gamma;
        let w_5 = self.O4B * sin_beta * beta_dot_squared;
        let w_6 = w_5 + self.BC * w_3;
        let w_20 = w_5 + self.BG5 * w_3;
        let guide_by_gamma = cos_gamma * self.BC;
        let l_lambda_guide_gamma = guide_by_gamma * self.inverse_gamma;
        let pivot_beta = self.mass_beta_beta - mass_gamma_beta * l_beta_gamma;
        let inverse_beta = S::from_f64(1.0) / pivot_beta;
        let k_lambda_guide_beta = self.O4B * cos_beta
            - mass_gamma_beta * l_lambda_guide_gamma;
        let l_lambda_guide_beta = inverse_beta * k_lambda_guide_beta;
        let minus_pivot_lambda_guide = guide_by_gamma * l_lambda_guide_gamma
            + k_lambda_guide_beta * l_lambda_guide_beta;
        let rhs_lambda_guide = w_6 - rhs_gamma * l_lambda_guide_gamma
            - l_lambda_guide_beta * rhs_beta;
        let w_7 = cos_beta * cos_alpha;
        let A_y = self.O4O2 + self.O2A * sin_alpha;
        let minus_slot_by_beta = self.O2A * w_7 + sin_beta * A_y;
        let slot_by_alpha = self.O2A * (w_7 + sin_beta * sin_alpha);
        let minus_l_lambda_slot_beta = minus_slot_by_beta * inverse_beta;
        let k_lambda_slot_lambda_guide = k_lambda_guide_beta * minus_l_lambda_slot_beta;
        let w_8 = sin_beta * cos_alpha;
        let w_9 = w_8 - cos_beta * sin_alpha;
        let l_lambda_slot_alpha = slot_by_alpha * self.inverse_alpha;
        let minus_inverse_lambda_guide = S::from_f64(1.0) / minus_pivot_lambda_guide;
        let minus_l_lambda_slot_lambda_guide = k_lambda_slot_lambda_guide
            * minus_inverse_lambda_guide;
        let rhs_lambda_slot = minus_l_lambda_slot_beta * rhs_beta
            - (self.O2A * (alpha_dot * alpha_dot * w_9 + beta_dot_squared * w_8)
                - self.k_8 * beta_dot * alpha_dot * w_9 - A_y * w_2)
            - self.T * l_lambda_slot_alpha
            + minus_l_lambda_slot_lambda_guide * rhs_lambda_guide;
        let w_11 = self.O2A * w_9;
        let w_19 = cos_beta * A_y - self.O2A * w_8;
        let w_10 = minus_slot_by_beta * minus_l_lambda_slot_beta
            + slot_by_alpha * l_lambda_slot_alpha;
        let pivot_lambda_slot = k_lambda_slot_lambda_guide
            * minus_l_lambda_slot_lambda_guide - w_10;
        let inverse_lambda_slot = S::from_f64(1.0) / pivot_lambda_slot;
        let lambda_slot = inverse_lambda_slot * rhs_lambda_slot;
        let lambda_guide = minus_l_lambda_slot_lambda_guide * lambda_slot
            - minus_inverse_lambda_guide * rhs_lambda_guide;
        let beta_ddot = inverse_beta * rhs_beta - l_lambda_guide_beta * lambda_guide
            + minus_l_lambda_slot_beta * lambda_slot;
        let gamma_ddot = rhs_gamma * self.inverse_gamma - l_beta_gamma * beta_ddot
            - l_lambda_guide_gamma * lambda_guide;
        let w_12 = lambda_slot * w_11;
        let w_13 = self.inverse_alpha * w_12;
        let alpha_ddot = self.k_9 - l_lambda_slot_alpha * lambda_slot;
        let w_14 = alpha_dot - beta_dot;
        let w_15 = slot_by_alpha * w_14;
        let w_16 = l_lambda_slot_alpha * w_12;
        let w_17 = l_lambda_guide_beta * w_12;
        let w_18 = inverse_lambda_slot
            * (w_11 * (beta_ddot - alpha_ddot) + w_14 * w_15
                + minus_l_lambda_slot_beta * w_12 + w_16
                - minus_l_lambda_slot_lambda_guide * w_17);
        let w_38 = minus_inverse_lambda_guide * w_17
            + minus_l_lambda_slot_lambda_guide * w_18;
        let w_39 = inverse_beta * w_12 - l_lambda_guide_beta * w_38
            + minus_l_lambda_slot_beta * w_18;
        let w_21 = self.O4B * w_2;
        let w_22 = w_21 + self.BG5 * w_4;
        let w_23 = w_21 + self.BC * w_4;
        let w_25 = self.k * w_24;
        let w_46 = w_24 * self.k_12;
        let w_26 = gamma_ddot * w_25;
        let w_27 = sin_beta
            * (self.O4B * lambda_guide - (w_20 * self.k_2 + w_6 * self.k_3))
            - cos_beta * (self.k_4 + w_22 * self.k_2 + w_23 * self.k_3) - w_26
            + lambda_slot * w_19 + beta_dot_squared * self.k_10;
        let w_28 = beta_ddot * w_25;
        let w_29 = mass_gamma_beta * beta_dot_squared - w_28;
        let w_30 = w_27 - l_beta_gamma * w_29;
        let w_31 = self.O4B * (sin_beta * beta_ddot + w_2) - l_lambda_guide_gamma * w_29
            - l_lambda_guide_beta * w_30;
        let w_32 = alpha_ddot * w_11 - alpha_dot * w_15
            + beta_dot * (slot_by_alpha * alpha_dot - minus_slot_by_beta * beta_dot)
            + beta_ddot * w_19 + minus_l_lambda_slot_beta * w_30 - w_16
            + minus_l_lambda_slot_lambda_guide * w_31;
        let w_33 = inverse_lambda_slot * w_32;
        let w_40 = minus_l_lambda_slot_lambda_guide * w_33
            - minus_inverse_lambda_guide * w_31;
        let w_41 = inverse_beta * w_30 - l_lambda_guide_beta * w_40
            + minus_l_lambda_slot_beta * w_33;
        let w_44 = w_11 + w_11;
        let w_45 = inverse_lambda_slot * w_14 * w_44;
        let w_34 = w_28 - cos_gamma * (self.k_7 + w_22 * self.k_5 + w_23 * self.k_6)
            + sin_gamma * (self.BC * lambda_guide - (w_20 * self.k_5 + w_6 * self.k_6))
            + gamma_dot_squared * self.k_11;
        let w_35 = w_26 + mass_gamma_beta * gamma_dot_squared - l_beta_gamma * w_34;
        let w_36 = self.BC * (sin_gamma * gamma_ddot + w_4) - l_lambda_guide_gamma * w_34
            - l_lambda_guide_beta * w_35;
        let w_37 = inverse_lambda_slot
            * (minus_l_lambda_slot_beta * w_35
                + minus_l_lambda_slot_lambda_guide * w_36);
        let w_42 = minus_l_lambda_slot_lambda_guide * w_37
            - minus_inverse_lambda_guide * w_36;
        let w_43 = inverse_beta * w_35 - l_lambda_guide_beta * w_42
            + minus_l_lambda_slot_beta * w_37;
        let w_47 = beta_dot * w_46;
        let w_51 = gamma_dot * w_46;
        let w_48 = l_beta_gamma * w_47;
        let w_49 = sin_beta * beta_dot * self.k_13 + l_lambda_guide_gamma * w_47
            - l_lambda_guide_beta * w_48;
        let w_50 = inverse_lambda_slot
            * (beta_dot * w_19 * self.k_14 + alpha_dot * w_44
                + minus_l_lambda_slot_beta * w_48
                + minus_l_lambda_slot_lambda_guide * w_49);
        let w_56 = minus_l_lambda_slot_lambda_guide * w_50
            - minus_inverse_lambda_guide * w_49;
        let w_57 = inverse_beta * w_48 - l_lambda_guide_beta * w_56
            + minus_l_lambda_slot_beta * w_50;
        let w_52 = sin_gamma * gamma_dot * self.k_15 - l_lambda_guide_beta * w_51;
        let w_53 = inverse_lambda_slot
            * (minus_l_lambda_slot_beta * w_51
                + minus_l_lambda_slot_lambda_guide * w_52);
        let w_58 = minus_l_lambda_slot_lambda_guide * w_53
            - minus_inverse_lambda_guide * w_52;
        let w_54 = minus_l_lambda_slot_lambda_guide * w_45;
        let w_59 = inverse_beta * w_51 - l_lambda_guide_beta * w_58
            + minus_l_lambda_slot_beta * w_53;
        let w_55 = l_lambda_guide_beta * w_54 - minus_l_lambda_slot_beta * w_45;
        sim_kernel::DynamicsJacobian {
            accelerations_by_positions: [
                [
                    -(w_13 + l_lambda_slot_alpha * w_18),
                    w_13 - l_lambda_slot_alpha * w_33,
                    -(l_lambda_slot_alpha * w_37),
                ],
                [w_39, w_41, w_43],
                [
                    -(l_beta_gamma * w_39 + l_lambda_guide_gamma * w_38),
                    self.inverse_gamma * w_29 - l_beta_gamma * w_41
                        - l_lambda_guide_gamma * w_40,
                    self.inverse_gamma * w_34 - l_beta_gamma * w_43
                        - l_lambda_guide_gamma * w_42,
                ],
            ],
            accelerations_by_speeds: [
                [
                    l_lambda_slot_alpha * w_45,
                    -(l_lambda_slot_alpha * w_50),
                    -(l_lambda_slot_alpha * w_53),
                ],
                [w_55, w_57, w_59],
                [
                    l_lambda_guide_gamma * w_54 - l_beta_gamma * w_55,
                    -(self.inverse_gamma * w_47 + l_beta_gamma * w_57
                        + l_lambda_guide_gamma * w_56),
                    -(l_beta_gamma * w_59 + l_lambda_guide_gamma * w_58),
                ],
            ],
            multipliers_by_positions: [[w_38, w_40, w_42], [w_18, w_33, w_37]],
            multipliers_by_speeds: [[-w_54, w_56, w_58], [-w_45, w_50, w_53]],
            refused: sim_kernel::pivot_is_refused(
                self.mass_gamma_gamma,
                self.mass_gamma_gamma,
            ) | sim_kernel::pivot_is_refused(pivot_beta, self.mass_beta_beta)
                | sim_kernel::pivot_is_refused(
                    self.mass_alpha_alpha,
                    self.mass_alpha_alpha,
                )
                | sim_kernel::pivot_is_refused(
                    -minus_pivot_lambda_guide,
                    minus_pivot_lambda_guide,
                ) | sim_kernel::pivot_is_refused(pivot_lambda_slot, w_10),
        }
    }
}
#[allow(non_snake_case, unused_variables, clippy::all, clippy::pedantic)]
impl<S: sim_kernel::Scalar> sim_kernel::Mechanism<S> for QuickReturn<S> {
    type Q = [S; 3];
    type L = [S; 2];
    type Z = [S; 5];
    type QQ = [[S; 3]; 3];
    type V = [S; 0];
    type VV = [[S; 0]; 0];
    type LQ = [[S; 3]; 2];
    type LL = [[S; 2]; 2];
    type ZZ = [[S; 5]; 5];
    type Entries = [S; 0];
    type Envelope = [S; 0];
    type Parameters = [S; 17];
    type Outputs = [S; 10];
    type OutputRates = [S; 7];
    type Events = [S; 1];
    type EventValues = [S; 0];
    type SwitchingFunctions = [S; 0];
    type LoadConditions = [S; 0];
    type Activities = [S; 0];
    type Drawing = [S; 24];
    type QP = [[S; 17]; 3];
    type LP = [[S; 17]; 2];
    type Inputs = [sim_kernel::Input<S>; 0];
    type Prepared = QuickReturnPrepared<S>;
    type On<T: sim_kernel::Scalar> = QuickReturn<T>;
    #[inline(always)]
    fn description(&self) -> &'static sim_kernel::Description {
        const { &<Self as sim_kernel::Compiled<S>>::DESCRIPTION }
    }
    fn as_declared(&self) -> Self {
        <Self as sim_kernel::Compiled<S>>::defaults()
    }
    fn parameters(&self) -> [S; 17] {
        [
            self.O2A,
            self.O4B,
            self.BC,
            self.O4O2,
            self.O4G4,
            self.BG5,
            self.yc,
            self.m3,
            self.m4,
            self.m5,
            self.m6,
            self.J2,
            self.J3,
            self.J4,
            self.J5,
            self.F,
            self.T,
        ]
    }
    fn with_parameters(&self, parameters: [S; 17]) -> Self {
        Self {
            O2A: parameters[0],
            O4B: parameters[1],
            BC: parameters[2],
            O4O2: parameters[3],
            O4G4: parameters[4],
            BG5: parameters[5],
            yc: parameters[6],
            m3: parameters[7],
            m4: parameters[8],
            m5: parameters[9],
            m6: parameters[10],
            J2: parameters[11],
            J3: parameters[12],
            J4: parameters[13],
            J5: parameters[14],
            F: parameters[15],
            T: parameters[16],
            ..*self
        }
    }
    fn on<T: sim_kernel::Scalar>(
        &self,
        convert: impl ::core::ops::Fn(S) -> T,
    ) -> QuickReturn<T> {
        QuickReturn {
            O2A: convert(self.O2A),
            O4B: convert(self.O4B),
            BC: convert(self.BC),
            O4O2: convert(self.O4O2),
            O4G4: convert(self.O4G4),
            BG5: convert(self.BG5),
            yc: convert(self.yc),
            m3: convert(self.m3),
            m4: convert(self.m4),
            m5: convert(self.m5),
            m6: convert(self.m6),
            J2: convert(self.J2),
            J3: convert(self.J3),
            J4: convert(self.J4),
            J5: convert(self.J5),
            F: convert(self.F),
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
    fn prepare(&self) -> QuickReturnPrepared<S> {
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
    ) -> [S; 10] {
        self.outputs(t, q, qd, qdd, lambda).into()
    }
    #[inline(always)]
    fn output_rates(&self, t: S, q: &[S; 3], qd: &[S; 3], qdd: &[S; 3]) -> [S; 7] {
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
    fn drawing(&self, t: S, q: &[S; 3]) -> [S; 24] {
        self.drawing(t, q)
    }
    #[inline(always)]
    fn initial(&self) -> sim_kernel::Initial<[S; 3]> {
        self.initial()
    }
}
#[allow(clippy::all, clippy::pedantic)]
impl<S: sim_kernel::Scalar> sim_kernel::Compiled<S> for QuickReturn<S> {
    const DESCRIPTION: sim_kernel::Description = sim_kernel::Description {
        name: "quick-return",
        type_name: "QuickReturn",
        docs: "Quick-return mechanism: crank 2 drives rocker 4 through slider 3; bar 5 pushes slider 6 along a guide.",
        declaration: "/// Quick-return mechanism: crank 2 drives rocker 4 through slider 3; bar 5 pushes slider 6 along a guide.\npub QuickReturn;\n\ncoordinates {\n    /// Angle of crank 2.\n    alpha [rad];\n    /// Angle of rocker 4, and of slider 3 on it.\n    beta [rad];\n    /// Angle of bar 5.\n    gamma [rad];\n}\n\nparameters {\n    /// Length of crank 2.\n    O2A [m] = 0.2;\n    /// Length of rocker 4.\n    O4B [m] = 0.7;\n    /// Length of bar 5.\n    BC [m] = 0.6;\n    /// Distance of the fixed pivots.\n    O4O2 [m] = 0.3;\n    /// Centre of mass of rocker 4.\n    O4G4 [m] = 0.4;\n    /// Centre of mass of bar 5.\n    BG5 [m] = 0.3;\n    /// Height of the guide.\n    yc [m] = 0.9;\n    /// Mass of slider 3.\n    m3 [kg] = 0.5;\n    /// Mass of rocker 4.\n    m4 [kg] = 6;\n    /// Mass of bar 5.\n    m5 [kg] = 4;\n    /// Mass of slider 6.\n    m6 [kg] = 2;\n    /// Inertia of crank 2 with its flywheel, about O2.\n    J2 [kg*m^2] = 100;\n    /// Inertia of slider 3.\n    J3 [kg*m^2] = 0;\n    /// Inertia of rocker 4.\n    J4 [kg*m^2] = 10;\n    /// Inertia of bar 5.\n    J5 [kg*m^2] = 6;\n    /// Force on slider 6, along +x.\n    F [N] = 1000;\n    /// Torque on crank 2.\n    T [N*m] = 0;\n}\n\nlet O4 = [0, 0];\nlet O2 = [0, O4O2];\nlet A = O2 + O2A*[cos(alpha), sin(alpha)];\nlet G4 = O4G4*[cos(beta), sin(beta)];\nlet B = O4B*[cos(beta), sin(beta)];\nlet G5 = B + BG5*[cos(gamma), sin(gamma)];\nlet C = B + BC*[cos(gamma), sin(gamma)];\n\nbodies {\n    crank2: inertia J2, angle alpha;\n    slider3: mass m3 at A, inertia J3, angle beta;\n    rocker4: mass m4 at G4, inertia J4, angle beta;\n    bar5: mass m5 at G5, inertia J5, angle gamma;\n    slider6: mass m6 at C;\n}\n\nloads {\n    force [F, 0] at C;\n    torque T on crank2;\n}\n\nconstraints {\n    guide: C.y = yc;\n    slot: A.y*cos(beta) = A.x*sin(beta);\n}\n\ninitial {\n    alpha = 0;\n    dot(alpha) = 75 [rpm];\n    guess beta = 1;\n    guess gamma = 2.6;\n}\n\nevents {\n    period: alpha = 2*pi;\n}\n\noutputs {\n    angular_speeds \"Angular speeds\" {\n        /// crank 2\n        crank_speed [rad/s] = dot(alpha);\n        /// rocker 4\n        rocker_speed [rad/s] = dot(beta);\n        /// bar 5\n        bar_speed [rad/s] = dot(gamma);\n    }\n    slider3_speed \"Sliding speed of slider 3 on rocker 4\" {\n        /// sliding speed, d|O4 A|/dt\n        sliding_speed [m/s] = dot(norm(A));\n        /// the report's |v_A| - |v_G4|\n        speed_difference [m/s] = norm(dot(A)) - norm(dot(G4));\n    }\n    slider6_position \"Position of slider 6\" {\n        /// position\n        x6 [m] = C.x;\n    }\n    slider6_velocity \"Velocity of slider 6\" {\n        /// velocity\n        x6_velocity [m/s] = dot(C.x);\n    }\n    slider6_acceleration \"Acceleration of slider 6\" {\n        /// acceleration\n        x6_acceleration [m/s^2] = ddot(C.x);\n    }\n    normal_forces \"Normal forces\" {\n        /// slider 3 on rocker 4\n        normal_force_slider3 [N] = reaction(slot);\n        /// slider 6 on the ground\n        normal_force_slider6 [N] = reaction(guide);\n    }\n}\n\ndrawing {\n    ground O2, O4;\n    line O2, A;\n    line O4, B, C;\n    slider A along beta;\n    slider C along 0;\n    point G4, G5;\n}\n",
        declaration_hash: "679854050a4474e732b0a1ae464641fb",
        coordinates: &[
            sim_kernel::Coordinate {
                position: sim_kernel::Quantity {
                    name: "alpha",
                    unit: "rad",
                    factor: 1f64,
                    is_length: false,
                    docs: "Angle of crank 2.",
                },
                speed: sim_kernel::Quantity {
                    name: "alpha_dot",
                    unit: "rad/s",
                    factor: 1f64,
                    is_length: false,
                    docs: "",
                },
                acceleration: sim_kernel::Quantity {
                    name: "alpha_ddot",
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
                    name: "beta",
                    unit: "rad",
                    factor: 1f64,
                    is_length: false,
                    docs: "Angle of rocker 4, and of slider 3 on it.",
                },
                speed: sim_kernel::Quantity {
                    name: "beta_dot",
                    unit: "rad/s",
                    factor: 1f64,
                    is_length: false,
                    docs: "",
                },
                acceleration: sim_kernel::Quantity {
                    name: "beta_ddot",
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
                    name: "gamma",
                    unit: "rad",
                    factor: 1f64,
                    is_length: false,
                    docs: "Angle of bar 5.",
                },
                speed: sim_kernel::Quantity {
                    name: "gamma_dot",
                    unit: "rad/s",
                    factor: 1f64,
                    is_length: false,
                    docs: "",
                },
                acceleration: sim_kernel::Quantity {
                    name: "gamma_ddot",
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
                name: "O2A",
                unit: "m",
                factor: 1f64,
                is_length: true,
                docs: "Length of crank 2.",
            },
            sim_kernel::Quantity {
                name: "O4B",
                unit: "m",
                factor: 1f64,
                is_length: true,
                docs: "Length of rocker 4.",
            },
            sim_kernel::Quantity {
                name: "BC",
                unit: "m",
                factor: 1f64,
                is_length: true,
                docs: "Length of bar 5.",
            },
            sim_kernel::Quantity {
                name: "O4O2",
                unit: "m",
                factor: 1f64,
                is_length: true,
                docs: "Distance of the fixed pivots.",
            },
            sim_kernel::Quantity {
                name: "O4G4",
                unit: "m",
                factor: 1f64,
                is_length: true,
                docs: "Centre of mass of rocker 4.",
            },
            sim_kernel::Quantity {
                name: "BG5",
                unit: "m",
                factor: 1f64,
                is_length: true,
                docs: "Centre of mass of bar 5.",
            },
            sim_kernel::Quantity {
                name: "yc",
                unit: "m",
                factor: 1f64,
                is_length: true,
                docs: "Height of the guide.",
            },
            sim_kernel::Quantity {
                name: "m3",
                unit: "kg",
                factor: 1f64,
                is_length: false,
                docs: "Mass of slider 3.",
            },
            sim_kernel::Quantity {
                name: "m4",
                unit: "kg",
                factor: 1f64,
                is_length: false,
                docs: "Mass of rocker 4.",
            },
            sim_kernel::Quantity {
                name: "m5",
                unit: "kg",
                factor: 1f64,
                is_length: false,
                docs: "Mass of bar 5.",
            },
            sim_kernel::Quantity {
                name: "m6",
                unit: "kg",
                factor: 1f64,
                is_length: false,
                docs: "Mass of slider 6.",
            },
            sim_kernel::Quantity {
                name: "J2",
                unit: "kg*m^2",
                factor: 1f64,
                is_length: false,
                docs: "Inertia of crank 2 with its flywheel, about O2.",
            },
            sim_kernel::Quantity {
                name: "J3",
                unit: "kg*m^2",
                factor: 1f64,
                is_length: false,
                docs: "Inertia of slider 3.",
            },
            sim_kernel::Quantity {
                name: "J4",
                unit: "kg*m^2",
                factor: 1f64,
                is_length: false,
                docs: "Inertia of rocker 4.",
            },
            sim_kernel::Quantity {
                name: "J5",
                unit: "kg*m^2",
                factor: 1f64,
                is_length: false,
                docs: "Inertia of bar 5.",
            },
            sim_kernel::Quantity {
                name: "F",
                unit: "N",
                factor: 1f64,
                is_length: false,
                docs: "Force on slider 6, along +x.",
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
                name: "guide",
                unit: "N",
                factor: 1f64,
                is_length: false,
                docs: "",
            },
            sim_kernel::Quantity {
                name: "slot",
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
                name: "rocker_speed",
                unit: "rad/s",
                factor: 1f64,
                is_length: false,
                docs: "rocker 4",
            },
            sim_kernel::Quantity {
                name: "bar_speed",
                unit: "rad/s",
                factor: 1f64,
                is_length: false,
                docs: "bar 5",
            },
            sim_kernel::Quantity {
                name: "sliding_speed",
                unit: "m/s",
                factor: 1f64,
                is_length: false,
                docs: "sliding speed, d|O4 A|/dt",
            },
            sim_kernel::Quantity {
                name: "speed_difference",
                unit: "m/s",
                factor: 1f64,
                is_length: false,
                docs: "the report's |v_A| - |v_G4|",
            },
            sim_kernel::Quantity {
                name: "x6",
                unit: "m",
                factor: 1f64,
                is_length: true,
                docs: "position",
            },
            sim_kernel::Quantity {
                name: "x6_velocity",
                unit: "m/s",
                factor: 1f64,
                is_length: false,
                docs: "velocity",
            },
            sim_kernel::Quantity {
                name: "x6_acceleration",
                unit: "m/s^2",
                factor: 1f64,
                is_length: false,
                docs: "acceleration",
            },
            sim_kernel::Quantity {
                name: "normal_force_slider3",
                unit: "N",
                factor: 1f64,
                is_length: false,
                docs: "slider 3 on rocker 4",
            },
            sim_kernel::Quantity {
                name: "normal_force_slider6",
                unit: "N",
                factor: 1f64,
                is_length: false,
                docs: "slider 6 on the ground",
            },
        ],
        rated_outputs: &[0, 1, 2, 3, 4, 5, 6],
        figures: &[
            sim_kernel::Figure {
                name: "angular_speeds",
                title: "Angular speeds",
                len: 3,
            },
            sim_kernel::Figure {
                name: "slider3_speed",
                title: "Sliding speed of slider 3 on rocker 4",
                len: 2,
            },
            sim_kernel::Figure {
                name: "slider6_position",
                title: "Position of slider 6",
                len: 1,
            },
            sim_kernel::Figure {
                name: "slider6_velocity",
                title: "Velocity of slider 6",
                len: 1,
            },
            sim_kernel::Figure {
                name: "slider6_acceleration",
                title: "Acceleration of slider 6",
                len: 1,
            },
            sim_kernel::Figure {
                name: "normal_forces",
                title: "Normal forces",
                len: 2,
            },
        ],
        optional_kernels: &["dynamics_jacobian"],
        dimension: 2,
        drawing: &[
            sim_kernel::Shape::Ground(2),
            sim_kernel::Shape::Line(2),
            sim_kernel::Shape::Line(3),
            sim_kernel::Shape::Slider,
            sim_kernel::Shape::Slider,
            sim_kernel::Shape::Points(2),
        ],
        run: &[],
        switching: &[],
        load_conditions: &[],
    };
    fn defaults() -> Self {
        Self {
            O2A: S::from_f64(0.2f64),
            O4B: S::from_f64(0.7f64),
            BC: S::from_f64(0.6f64),
            O4O2: S::from_f64(0.3f64),
            O4G4: S::from_f64(0.4f64),
            BG5: S::from_f64(0.3f64),
            yc: S::from_f64(0.9f64),
            m3: S::from_f64(0.5f64),
            m4: S::from_f64(6f64),
            m5: S::from_f64(4f64),
            m6: S::from_f64(2f64),
            J2: S::from_f64(100f64),
            J3: S::from_f64(0f64),
            J4: S::from_f64(10f64),
            J5: S::from_f64(6f64),
            F: S::from_f64(1000f64),
            T: S::from_f64(0f64),
        }
    }
}
