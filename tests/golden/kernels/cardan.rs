/// A driven shaft turns another one by a universal joint.
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
/// coordinates = [alpha; gamma]
/// multipliers = [lambda_cross]
/// constraints = 0
/// [
///     J, 0, constraint_jacobian[1, 1];
///     0, J, constraint_jacobian[1, 2];
///     constraint_jacobian[1, 1], constraint_jacobian[1, 2], 0
/// ] * [alpha_ddot; gamma_ddot; lambda_cross] = [
///     0;
///     -c*gamma_dot;
///     s_1*alpha_dot + s_2*gamma_dot
/// ]
///
/// mass_matrix = [J, 0; 0, J]
///
/// convective_forces = [0; 0]
///
/// generalized_forces = [0; -c*gamma_dot]
///
/// constraints = [constraints[1]]
/// constraints[1] = sin(alpha)*cos(gamma) - cos(alpha)*cos(beta)*sin(gamma)
///
/// constraint_jacobian = [
///     constraint_jacobian[1, 1], constraint_jacobian[1, 2]
/// ]
/// constraint_jacobian[1, 1] = cos(alpha)*cos(gamma) + sin(alpha)*cos(beta)*sin(gamma)
/// constraint_jacobian[1, 2] = -sin(alpha)*sin(gamma) - cos(alpha)*cos(beta)*cos(gamma)
///
/// constraint_convective = [-s_1*alpha_dot - s_2*gamma_dot]
///
/// s_1 = alpha_dot*sin(alpha)*cos(gamma) + gamma_dot*cos(alpha)*sin(gamma)
///     - alpha_dot*cos(alpha)*cos(beta)*sin(gamma) - gamma_dot*sin(alpha)*cos(beta)*cos(gamma)
/// s_2 = alpha_dot*cos(alpha)*sin(gamma) + gamma_dot*sin(alpha)*cos(gamma)
///     - alpha_dot*sin(alpha)*cos(beta)*cos(gamma) - gamma_dot*cos(alpha)*cos(beta)*sin(gamma)
/// ```
#[allow(non_snake_case)]
#[derive(
    ::core::clone::Clone,
    ::core::marker::Copy,
    ::core::fmt::Debug,
    ::core::cmp::PartialEq
)]
pub struct Cardan<S = ::core::primitive::f64> {
    /// Angle between the shafts, in `1`.
    pub beta: S,
    /// Moment of inertia of a shaft about its axis, in `kg*m^2`.
    pub J: S,
    /// Length that is drawn of each shaft, in `m`.
    pub l: S,
    /// Arm of the cross, in `m`.
    pub a: S,
    /// Speed of the first shaft at the start, in `1/s`.
    pub speed: S,
    /// Braking torque on the second shaft, per speed, in `N*m*s`.
    pub c: S,
}
impl<S: sim_kernel::Scalar> ::core::default::Default for Cardan<S> {
    /// The declared values.
    fn default() -> Self {
        <Self as sim_kernel::Mechanism<S>>::defaults()
    }
}
/// Coordinates of [`Cardan`] by name, in SI units; also for their speeds and accelerations.
#[allow(non_snake_case)]
#[derive(
    ::core::clone::Clone,
    ::core::marker::Copy,
    ::core::fmt::Debug,
    ::core::cmp::PartialEq
)]
pub struct CardanCoordinates<S = ::core::primitive::f64> {
    /// Turn of the first shaft, in `rad`.
    pub alpha: S,
    /// Turn of the second, in `rad`.
    pub gamma: S,
}
impl<S: sim_kernel::Scalar> ::core::convert::From<[S; 2]> for CardanCoordinates<S> {
    fn from(values: [S; 2]) -> Self {
        Self {
            alpha: values[0],
            gamma: values[1],
        }
    }
}
impl<S: sim_kernel::Scalar> ::core::convert::From<CardanCoordinates<S>> for [S; 2] {
    fn from(record: CardanCoordinates<S>) -> Self {
        [record.alpha, record.gamma]
    }
}
/// Outputs of [`Cardan`] by name, in SI units.
#[allow(non_snake_case)]
#[derive(
    ::core::clone::Clone,
    ::core::marker::Copy,
    ::core::fmt::Debug,
    ::core::cmp::PartialEq
)]
pub struct CardanOutputs<S = ::core::primitive::f64> {
    /// ratio of the speeds of the shafts, in `1`.
    pub ratio: S,
    /// torque between the arms of the cross, in `N*m`.
    pub torque: S,
}
impl<S: sim_kernel::Scalar> ::core::convert::From<[S; 2]> for CardanOutputs<S> {
    fn from(values: [S; 2]) -> Self {
        Self {
            ratio: values[0],
            torque: values[1],
        }
    }
}
impl<S: sim_kernel::Scalar> ::core::convert::From<CardanOutputs<S>> for [S; 2] {
    fn from(record: CardanOutputs<S>) -> Self {
        [record.ratio, record.torque]
    }
}
/// Rates of the outputs of [`Cardan`] by name, in SI units.
#[allow(non_snake_case)]
#[derive(
    ::core::clone::Clone,
    ::core::marker::Copy,
    ::core::fmt::Debug,
    ::core::cmp::PartialEq
)]
pub struct CardanOutputRates<S = ::core::primitive::f64> {
    /// Rate of `ratio`.
    pub ratio: S,
}
impl<S: sim_kernel::Scalar> ::core::convert::From<[S; 1]> for CardanOutputRates<S> {
    fn from(values: [S; 1]) -> Self {
        Self { ratio: values[0] }
    }
}
impl<S: sim_kernel::Scalar> ::core::convert::From<CardanOutputRates<S>> for [S; 1] {
    fn from(record: CardanOutputRates<S>) -> Self {
        [record.ratio]
    }
}
/// What the equations of motion need of the parameters of [`Cardan`], from [`Cardan::prepare`]; its methods are the kernels of each step.
#[allow(non_snake_case)]
#[derive(
    ::core::clone::Clone,
    ::core::marker::Copy,
    ::core::fmt::Debug,
    ::core::cmp::PartialEq
)]
pub struct CardanPrepared<S = ::core::primitive::f64> {
    J: S,
    cos_beta: S,
    c: S,
    k: S,
    inverse_alpha: S,
    k_2: S,
    k_3: S,
}
#[allow(non_snake_case, unused_variables, unused_parens, clippy::all, clippy::pedantic)]
impl<S: sim_kernel::Scalar> Cardan<S> {
    /// What the equations of motion need of the parameters, computed once for a set of parameters.
    ///
    /// Operations: 1 addition, 2 multiplications, 1 division, 1 sine-cosine pair.
    #[inline]
    pub fn prepare(&self) -> CardanPrepared<S> {
        let ([_], [cos_beta]) = S::sin_cos_each([self.beta]);
        let inverse_J = S::from_f64(1.0) / self.J;
        CardanPrepared {
            J: self.J,
            cos_beta: cos_beta,
            c: self.c,
            k: cos_beta * S::from_f64(2.0),
            inverse_alpha: inverse_J,
            k_2: S::from_f64(1.0) + S::from_f64(1.0),
            k_3: self.c * inverse_J,
        }
    }
    /// Mass matrix `T_q' M T_q`, 2 x 2, symmetric, in SI units.
    ///
    /// Operations: none.
    #[inline]
    pub fn mass_matrix(&self, t: S, q: &[S; 2]) -> [[S; 2]; 2] {
        [[self.J, S::from_f64(0.0)], [S::from_f64(0.0), self.J]]
    }
    /// Convective forces `T_q' M g`, 2, with `g = (T_q q' + T_t)_q q' + (..)_t`: joules per unit of each coordinate.
    ///
    /// Operations: none.
    #[inline]
    pub fn convective_forces(&self, t: S, q: &[S; 2], qd: &[S; 2]) -> [S; 2] {
        [S::from_f64(0.0), S::from_f64(0.0)]
    }
    /// Generalised forces `T_q' F`, 2: joules per unit of each coordinate.
    ///
    /// Operations: 1 addition, 1 multiplication.
    #[inline]
    pub fn generalized_forces(&self, t: S, q: &[S; 2], qd: &[S; 2]) -> [S; 2] {
        let [_, gamma_dot] = *qd;
        [S::from_f64(0.0), -(gamma_dot * self.c)]
    }
    /// Constraints `C`, 1, in SI units; zero throughout the motion.
    ///
    /// Operations: 1 addition, 3 multiplications, 3 sine-cosine pairs.
    #[inline]
    pub fn constraints(&self, t: S, q: &[S; 2]) -> [S; 1] {
        let [alpha, gamma] = *q;
        let ([sin_alpha, sin_gamma, _], [cos_alpha, cos_gamma, cos_beta]) = S::sin_cos_each([
            alpha,
            gamma,
            self.beta,
        ]);
        [sin_alpha * cos_gamma - cos_alpha * cos_beta * sin_gamma]
    }
    /// The sum of the magnitudes of the terms of `C`, 1, in SI units: what its rounding is relative to.
    ///
    /// Operations: 3 additions, 3 multiplications, 3 sine-cosine pairs.
    #[inline]
    pub fn constraint_magnitudes(&self, t: S, q: &[S; 2]) -> [S; 1] {
        let [alpha, gamma] = *q;
        let ([sin_alpha, sin_gamma, _], [cos_alpha, cos_gamma, cos_beta]) = S::sin_cos_each([
            alpha,
            gamma,
            self.beta,
        ]);
        [(sin_alpha * cos_gamma).abs() + (cos_alpha * cos_beta * sin_gamma).abs()]
    }
    /// Constraint Jacobian `C_q`, 1 x 2: units of each constraint per unit of each coordinate.
    ///
    /// Operations: 3 additions, 4 multiplications, 3 sine-cosine pairs.
    #[inline]
    pub fn constraint_jacobian(&self, t: S, q: &[S; 2]) -> [[S; 2]; 1] {
        let [alpha, gamma] = *q;
        let ([sin_alpha, sin_gamma, _], [cos_alpha, cos_gamma, cos_beta]) = S::sin_cos_each([
            alpha,
            gamma,
            self.beta,
        ]);
        let w = cos_alpha * cos_gamma;
        let w_2 = sin_alpha * sin_gamma;
        [[w + cos_beta * w_2, -(w_2 + cos_beta * w)]]
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
    /// Operations: 4 additions, 11 multiplications, 3 sine-cosine pairs.
    #[inline]
    pub fn constraint_convective(&self, t: S, q: &[S; 2], qd: &[S; 2]) -> [S; 1] {
        let [alpha, gamma] = *q;
        let [alpha_dot, gamma_dot] = *qd;
        let ([sin_alpha, sin_gamma, _], [cos_alpha, cos_gamma, cos_beta]) = S::sin_cos_each([
            alpha,
            gamma,
            self.beta,
        ]);
        let w = sin_alpha * cos_gamma;
        let w_2 = cos_alpha * sin_gamma;
        [
            alpha_dot * gamma_dot
                * (w * cos_beta * S::from_f64(2.0) - w_2 * S::from_f64(2.0))
                - (w - cos_beta * w_2) * (alpha_dot * alpha_dot + gamma_dot * gamma_dot),
        ]
    }
    /// `C` (1), `C_q` (1 x 2) and `C_t` (1) together, in SI units, for projection.
    ///
    /// Operations: 4 additions, 7 multiplications, 3 sine-cosine pairs.
    #[inline]
    pub fn constraint_linearization(
        &self,
        t: S,
        q: &[S; 2],
    ) -> sim_kernel::ConstraintLinearization<[S; 1], [[S; 2]; 1]> {
        let [alpha, gamma] = *q;
        let ([sin_alpha, sin_gamma, _], [cos_alpha, cos_gamma, cos_beta]) = S::sin_cos_each([
            alpha,
            gamma,
            self.beta,
        ]);
        let w = cos_gamma * cos_alpha;
        let w_2 = sin_alpha * sin_gamma;
        sim_kernel::ConstraintLinearization {
            values: [sin_alpha * cos_gamma - cos_alpha * cos_beta * sin_gamma],
            jacobian: [[w + cos_beta * w_2, -(w_2 + cos_beta * w)]],
            time_derivative: [S::from_f64(0.0)],
        }
    }
    /// Kinetic energy `v' M v / 2`, in joules.
    ///
    /// Operations: 1 addition, 4 multiplications.
    #[inline]
    pub fn kinetic_energy(&self, t: S, q: &[S; 2], qd: &[S; 2]) -> S {
        let [alpha_dot, gamma_dot] = *qd;
        S::from_f64(0.5) * self.J * (alpha_dot * alpha_dot + gamma_dot * gamma_dot)
    }
    /// Power of loads and drives, `F' v + lambda' C_t + T_t' (M x'' - F)`, in watts.
    ///
    /// Operations: 1 addition, 2 multiplications.
    #[inline]
    pub fn power(
        &self,
        t: S,
        q: &[S; 2],
        qd: &[S; 2],
        qdd: &[S; 2],
        lambda: &[S; 1],
    ) -> S {
        let [_, gamma_dot] = *qd;
        -(gamma_dot * gamma_dot * self.c)
    }
    /// Outputs, 2, in SI units.
    ///
    /// Operations: 1 division.
    #[inline]
    pub fn outputs(
        &self,
        t: S,
        q: &[S; 2],
        qd: &[S; 2],
        qdd: &[S; 2],
        lambda: &[S; 1],
    ) -> CardanOutputs<S> {
        let [alpha_dot, gamma_dot] = *qd;
        let [lambda_cross] = *lambda;
        [gamma_dot / alpha_dot, lambda_cross].into()
    }
    /// Rates of the outputs that depend on neither accelerations nor multipliers, 1, in SI units per second.
    ///
    /// Operations: 1 addition, 2 multiplications, 2 divisions.
    #[inline]
    pub fn output_rates(
        &self,
        t: S,
        q: &[S; 2],
        qd: &[S; 2],
        qdd: &[S; 2],
    ) -> CardanOutputRates<S> {
        let [alpha_dot, gamma_dot] = *qd;
        let [alpha_ddot, gamma_ddot] = *qdd;
        [gamma_ddot / alpha_dot - alpha_ddot * gamma_dot / (alpha_dot * alpha_dot)]
            .into()
    }
    /// `left - right` of each event, 1, in SI units: zero when it happens.
    ///
    /// Operations: 1 multiplication, 1 sine-cosine pair.
    #[inline]
    pub fn events(
        &self,
        t: S,
        q: &[S; 2],
        qd: &[S; 2],
        qdd: &[S; 2],
        lambda: &[S; 1],
    ) -> [S; 1] {
        let [alpha, _] = *q;
        let ([w], [_]) = S::sin_cos_each([S::from_f64(0.5) * alpha]);
        [w]
    }
    /// The numbers of each shape of the drawing, in metres and radians.
    ///
    /// Operations: 8 additions, 9 multiplications, 3 sine-cosine pairs.
    #[inline]
    pub fn drawing(&self, t: S, q: &[S; 2]) -> [S; 44] {
        let [alpha, gamma] = *q;
        let ([sin_beta, sin_alpha, sin_gamma], [cos_beta, cos_alpha, cos_gamma]) = S::sin_cos_each([
            self.beta,
            alpha,
            gamma,
        ]);
        let w = self.l * cos_beta;
        let w_2 = self.l * sin_beta;
        let w_3 = self.a * cos_alpha;
        let w_4 = self.a * sin_alpha;
        let w_5 = sin_beta * self.a;
        let w_6 = sin_gamma * w_5;
        let w_7 = cos_beta * self.a;
        let w_8 = sin_gamma * w_7;
        let w_9 = self.a * cos_gamma;
        [
            -self.l,
            S::from_f64(0.0),
            S::from_f64(0.0),
            w,
            w_2,
            S::from_f64(0.0),
            -self.l,
            S::from_f64(0.0),
            S::from_f64(0.0),
            S::from_f64(0.0),
            S::from_f64(0.0),
            S::from_f64(0.0),
            S::from_f64(0.0),
            S::from_f64(0.0),
            S::from_f64(0.0),
            w,
            w_2,
            S::from_f64(0.0),
            S::from_f64(0.0),
            -w_3,
            -w_4,
            S::from_f64(0.0),
            w_3,
            w_4,
            -w_6,
            w_8,
            -w_9,
            w_6,
            -w_8,
            w_9,
            -self.a,
            S::from_f64(0.0),
            S::from_f64(0.0),
            self.a,
            S::from_f64(1.0),
            S::from_f64(0.0),
            S::from_f64(0.0),
            w_7,
            w_5,
            S::from_f64(0.0),
            self.a,
            cos_beta,
            sin_beta,
            S::from_f64(0.0),
        ]
    }
    /// Declared start: values or guesses of the coordinates (2), and speeds (2), in SI units; 0 where nothing is declared.
    ///
    /// Operations: none.
    #[inline]
    pub fn initial(&self) -> sim_kernel::Initial<[S; 2]> {
        sim_kernel::Initial {
            positions: [S::from_f64(0.0), S::from_f64(0.0)],
            speeds: [self.speed, S::from_f64(0.0)],
        }
    }
    /// [`CardanPrepared::dynamics`] once; for many calls with the same parameters [`Self::prepare`] first.
    #[inline]
    pub fn dynamics(
        &self,
        t: S,
        q: &[S; 2],
        qd: &[S; 2],
    ) -> sim_kernel::Dynamics<S, [S; 2], [S; 1]> {
        self.prepare().dynamics(t, q, qd)
    }
    /// [`CardanPrepared::dynamics_jacobian`] once; for many calls with the same parameters [`Self::prepare`] first.
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
impl<S: sim_kernel::Scalar> CardanPrepared<S> {
    /// Accelerations (2), multipliers (1) and power, from
    ///
    /// ```text
    /// [ T_q' M T_q   C_q' ] [ q''    ]   [ T_q' (F - M g)                      ]
    /// [ C_q          0    ] [ lambda ] = [ -(C_q q' + C_t)_q q' - (..)_t       ]
    /// ```
    ///
    /// by an elimination planned from the structure of the system. Where `refused` is set a pivot was too small and nothing else holds: solve that state from the other kernels.
    ///
    /// Operations: 13 additions, 25 multiplications, 1 division, 2 sine-cosine pairs.
    #[inline(always)]
    pub fn dynamics(
        &self,
        t: S,
        q: &[S; 2],
        qd: &[S; 2],
    ) -> sim_kernel::Dynamics<S, [S; 2], [S; 1]> {
        let [alpha, gamma] = *q;
        let [alpha_dot, gamma_dot] = *qd;
        let ([sin_alpha, sin_gamma], [cos_alpha, cos_gamma]) = S::sin_cos_each([
            alpha,
            gamma,
        ]);
        let w = cos_alpha * cos_gamma;
        let w_2 = sin_alpha * sin_gamma;
        let cross_by_alpha = w + self.cos_beta * w_2;
        let l_lambda_cross_alpha = cross_by_alpha * self.inverse_alpha;
        let minus_cross_by_gamma = w_2 + self.cos_beta * w;
        let minus_l_lambda_cross_gamma = minus_cross_by_gamma * self.inverse_alpha;
        let minus_pivot_lambda_cross = cross_by_alpha * l_lambda_cross_alpha
            + minus_cross_by_gamma * minus_l_lambda_cross_gamma;
        let w_3 = gamma_dot * alpha_dot;
        let alpha_dot_squared = alpha_dot * alpha_dot;
        let gamma_dot_squared = gamma_dot * gamma_dot;
        let minus_rhs_gamma = gamma_dot * self.c;
        let minus_rhs_lambda_cross = cos_gamma * sin_alpha
            * (self.k * w_3 - alpha_dot_squared - gamma_dot_squared)
            + cos_alpha * sin_gamma
                * (self.cos_beta * (alpha_dot_squared + gamma_dot_squared)
                    - S::from_f64(2.0) * w_3)
            + minus_rhs_gamma * minus_l_lambda_cross_gamma;
        let lambda_cross = S::from_f64(1.0) / minus_pivot_lambda_cross
            * minus_rhs_lambda_cross;
        sim_kernel::Dynamics {
            accelerations: [
                -(l_lambda_cross_alpha * lambda_cross),
                minus_l_lambda_cross_gamma * lambda_cross
                    - minus_rhs_gamma * self.inverse_alpha,
            ],
            multipliers: [lambda_cross],
            power: -(self.c * gamma_dot_squared),
            refused: sim_kernel::pivot_is_refused(self.J, self.J)
                | sim_kernel::pivot_is_refused(self.J, self.J)
                | sim_kernel::pivot_is_refused(
                    -minus_pivot_lambda_cross,
                    minus_pivot_lambda_cross,
                ),
        }
    }
    /// The derivatives of accelerations (2 rows) and multipliers (1 rows) with respect to coordinates and speeds (2 columns each): with the equations of motion as `K z = r`, the solutions of `K dz = dr - dK z`. Where `refused` is set a pivot was too small and nothing else holds.
    ///
    /// Operations: 39 additions, 67 multiplications, 1 division, 2 sine-cosine pairs.
    #[inline]
    pub fn dynamics_jacobian(
        &self,
        t: S,
        q: &[S; 2],
        qd: &[S; 2],
    ) -> sim_kernel::DynamicsJacobian<S, [[S; 2]; 2], [[S; 2]; 1]> {
        let [alpha, gamma] = *q;
        let [alpha_dot, gamma_dot] = *qd;
        let ([sin_alpha, sin_gamma], [cos_alpha, cos_gamma]) = S::sin_cos_each([
            alpha,
            gamma,
        ]);
        let w = cos_alpha * cos_gamma;
        let w_2 = sin_alpha * sin_gamma;
        let cross_by_alpha = w + self.cos_beta * w_2;
        let minus_cross_by_gamma = w_2 + self.cos_beta * w;
        let l_lambda_cross_alpha = cross_by_alpha * self.inverse_alpha;
        let minus_l_lambda_cross_gamma = minus_cross_by_gamma * self.inverse_alpha;
        let minus_pivot_lambda_cross = cross_by_alpha * l_lambda_cross_alpha
            + minus_cross_by_gamma * minus_l_lambda_cross_gamma;
        let minus_inverse_lambda_cross = S::from_f64(1.0) / minus_pivot_lambda_cross;
        let w_3 = gamma_dot * alpha_dot;
        let alpha_dot_squared = alpha_dot * alpha_dot;
        let gamma_dot_squared = gamma_dot * gamma_dot;
        let minus_rhs_gamma = gamma_dot * self.c;
        let lambda_cross = minus_inverse_lambda_cross
            * (cos_gamma * sin_alpha
                * (self.k * w_3 - alpha_dot_squared - gamma_dot_squared)
                + cos_alpha * sin_gamma
                    * (self.cos_beta * (alpha_dot_squared + gamma_dot_squared)
                        - S::from_f64(2.0) * w_3)
                + minus_rhs_gamma * minus_l_lambda_cross_gamma);
        let gamma_ddot = minus_l_lambda_cross_gamma * lambda_cross
            - minus_rhs_gamma * self.inverse_alpha;
        let w_4 = cos_gamma * sin_alpha;
        let w_5 = cos_alpha * sin_gamma;
        let w_6 = w_4 - self.cos_beta * w_5;
        let w_11 = w_5 - self.cos_beta * w_4;
        let w_7 = lambda_cross * w_6;
        let w_8 = self.inverse_alpha * w_7;
        let w_9 = cross_by_alpha * alpha_dot - minus_cross_by_gamma * gamma_dot;
        let w_10 = minus_cross_by_gamma * alpha_dot - cross_by_alpha * gamma_dot;
        let minus_alpha_ddot = l_lambda_cross_alpha * lambda_cross;
        let w_12 = lambda_cross * w_11;
        let w_13 = minus_inverse_lambda_cross
            * (alpha_dot * w_9 - gamma_dot * w_10 - minus_alpha_ddot * w_6
                + gamma_ddot * w_11 - l_lambda_cross_alpha * w_7
                + minus_l_lambda_cross_gamma * w_12);
        let w_15 = minus_inverse_lambda_cross
            * (gamma_dot * w_9 - alpha_dot * w_10 - minus_alpha_ddot * w_11
                + gamma_ddot * w_6 - l_lambda_cross_alpha * w_12
                + minus_l_lambda_cross_gamma * w_7);
        let w_14 = self.inverse_alpha * w_12;
        let w_16 = w_6 * self.k_2;
        let w_17 = w_11 * self.k_2;
        let w_18 = minus_inverse_lambda_cross * (alpha_dot * w_16 + gamma_dot * w_17);
        let w_19 = minus_inverse_lambda_cross
            * (alpha_dot * w_17 + gamma_dot * w_16
                - self.c * minus_l_lambda_cross_gamma);
        sim_kernel::DynamicsJacobian {
            accelerations_by_positions: [
                [w_8 + l_lambda_cross_alpha * w_13, w_14 + l_lambda_cross_alpha * w_15],
                [
                    w_14 - minus_l_lambda_cross_gamma * w_13,
                    w_8 - minus_l_lambda_cross_gamma * w_15,
                ],
            ],
            accelerations_by_speeds: [
                [l_lambda_cross_alpha * w_18, l_lambda_cross_alpha * w_19],
                [
                    -(minus_l_lambda_cross_gamma * w_18),
                    -(self.k_3 + minus_l_lambda_cross_gamma * w_19),
                ],
            ],
            multipliers_by_positions: [[-w_13, -w_15]],
            multipliers_by_speeds: [[-w_18, -w_19]],
            refused: sim_kernel::pivot_is_refused(self.J, self.J)
                | sim_kernel::pivot_is_refused(self.J, self.J)
                | sim_kernel::pivot_is_refused(
                    -minus_pivot_lambda_cross,
                    minus_pivot_lambda_cross,
                ),
        }
    }
}
#[allow(non_snake_case, clippy::all, clippy::pedantic)]
impl<S: sim_kernel::Scalar> sim_kernel::Mechanism<S> for Cardan<S> {
    type Q = [S; 2];
    type L = [S; 1];
    type Z = [S; 3];
    type QQ = [[S; 2]; 2];
    type LQ = [[S; 2]; 1];
    type LL = [[S; 1]; 1];
    type ZZ = [[S; 3]; 3];
    type Entries = [S; 0];
    type Envelope = [S; 0];
    type Parameters = [S; 6];
    type Outputs = [S; 2];
    type OutputRates = [S; 1];
    type Events = [S; 1];
    type EventValues = [S; 0];
    type Activities = [S; 0];
    type Drawing = [S; 44];
    type QP = [[S; 6]; 2];
    type LP = [[S; 6]; 1];
    type Inputs = [sim_kernel::Input<S>; 0];
    type Prepared = CardanPrepared<S>;
    type On<T: sim_kernel::Scalar> = Cardan<T>;
    const DESCRIPTION: sim_kernel::Description = sim_kernel::Description {
        name: "cardan",
        type_name: "Cardan",
        docs: "A driven shaft turns another one by a universal joint.",
        declaration: "/// A driven shaft turns another one by a universal joint.\npub Cardan;\n\ncoordinates {\n    /// Turn of the first shaft.\n    alpha [rad];\n    /// Turn of the second.\n    gamma [rad];\n}\n\nparameters {\n    /// Angle between the shafts.\n    beta [deg] = 35;\n    /// Moment of inertia of a shaft about its axis.\n    J [kg*m^2] = 0.02;\n    /// Length that is drawn of each shaft.\n    l [m] = 0.3;\n    /// Arm of the cross.\n    a [m] = 0.06;\n    /// Speed of the first shaft at the start.\n    speed [rpm] = 300;\n    /// Braking torque on the second shaft, per speed.\n    c [N*m*s] = 0.002;\n}\n\nlet R1 = rotation(x, alpha);\nlet R2 = rotation(z, beta)*rotation(x, gamma);\n\nbodies {\n    driving: inertia [J, J, J], attitude R1;\n    driven: inertia [J, J, J], attitude R2;\n}\nloads { torque -c*omega(driven) on driven; }\n\nconstraints {\n    /// The arms of the cross stand at right angles.\n    cross: inner(R1*[0, 1, 0], R2*[0, 0, 1]) = 0;\n}\n\ninitial { alpha = 0; dot(alpha) = speed; guess gamma = 0; }\nevents { period: sin(alpha/2) = 0; }\n\noutputs {\n    /// ratio of the speeds of the shafts\n    ratio = dot(gamma)/dot(alpha);\n    /// torque between the arms of the cross\n    torque [N*m] = reaction(cross);\n}\n\ndrawing {\n    ground [-l, 0, 0], rotation(z, beta)*[l, 0, 0];\n    line [-l, 0, 0], [0, 0, 0];\n    line [0, 0, 0], rotation(z, beta)*[l, 0, 0];\n    curve R1*[0, -a, 0], R1*[0, a, 0];\n    curve R2*[0, 0, -a], R2*[0, 0, a];\n    circle R1*[-a, 0, 0] radius a normal [1, 0, 0];\n    circle R2*[a, 0, 0] radius a normal R2*[1, 0, 0];\n}\n",
        coordinates: &[
            sim_kernel::Coordinate {
                position: sim_kernel::Quantity {
                    name: "alpha",
                    unit: "rad",
                    factor: 1f64,
                    is_length: false,
                    docs: "Turn of the first shaft.",
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
                    name: "gamma",
                    unit: "rad",
                    factor: 1f64,
                    is_length: false,
                    docs: "Turn of the second.",
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
        parameters: &[
            sim_kernel::Quantity {
                name: "beta",
                unit: "deg",
                factor: 0.017453292519943295f64,
                is_length: false,
                docs: "Angle between the shafts.",
            },
            sim_kernel::Quantity {
                name: "J",
                unit: "kg*m^2",
                factor: 1f64,
                is_length: false,
                docs: "Moment of inertia of a shaft about its axis.",
            },
            sim_kernel::Quantity {
                name: "l",
                unit: "m",
                factor: 1f64,
                is_length: true,
                docs: "Length that is drawn of each shaft.",
            },
            sim_kernel::Quantity {
                name: "a",
                unit: "m",
                factor: 1f64,
                is_length: true,
                docs: "Arm of the cross.",
            },
            sim_kernel::Quantity {
                name: "speed",
                unit: "rpm",
                factor: 0.10471975511965977f64,
                is_length: false,
                docs: "Speed of the first shaft at the start.",
            },
            sim_kernel::Quantity {
                name: "c",
                unit: "N*m*s",
                factor: 1f64,
                is_length: false,
                docs: "Braking torque on the second shaft, per speed.",
            },
        ],
        inputs: &[],
        constraints: &[
            sim_kernel::Quantity {
                name: "cross",
                unit: "N*m",
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
                name: "ratio",
                unit: "1",
                factor: 1f64,
                is_length: false,
                docs: "ratio of the speeds of the shafts",
            },
            sim_kernel::Quantity {
                name: "torque",
                unit: "N*m",
                factor: 1f64,
                is_length: false,
                docs: "torque between the arms of the cross",
            },
        ],
        rated_outputs: &[0],
        figures: &[
            sim_kernel::Figure {
                name: "ratio",
                title: "ratio of the speeds of the shafts",
                len: 1,
            },
            sim_kernel::Figure {
                name: "torque",
                title: "torque between the arms of the cross",
                len: 1,
            },
        ],
        optional_kernels: &["dynamics_jacobian"],
        dimension: 3,
        drawing: &[
            sim_kernel::Shape::Ground(2),
            sim_kernel::Shape::Line(2),
            sim_kernel::Shape::Line(2),
            sim_kernel::Shape::Curve(2),
            sim_kernel::Shape::Curve(2),
            sim_kernel::Shape::Circle,
            sim_kernel::Shape::Circle,
        ],
    };
    fn defaults() -> Self {
        Self {
            beta: S::from_f64(0.6108652381980153f64),
            J: S::from_f64(0.02f64),
            l: S::from_f64(0.3f64),
            a: S::from_f64(0.06f64),
            speed: S::from_f64(31.41592653589793f64),
            c: S::from_f64(0.002f64),
        }
    }
    fn parameters(&self) -> [S; 6] {
        [self.beta, self.J, self.l, self.a, self.speed, self.c]
    }
    fn with_parameters(&self, parameters: [S; 6]) -> Self {
        Self {
            beta: parameters[0],
            J: parameters[1],
            l: parameters[2],
            a: parameters[3],
            speed: parameters[4],
            c: parameters[5],
            ..*self
        }
    }
    fn on<T: sim_kernel::Scalar>(
        &self,
        convert: impl ::core::ops::Fn(S) -> T,
    ) -> Cardan<T> {
        Cardan {
            beta: convert(self.beta),
            J: convert(self.J),
            l: convert(self.l),
            a: convert(self.a),
            speed: convert(self.speed),
            c: convert(self.c),
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
    fn prepare(&self) -> CardanPrepared<S> {
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
    ) -> [S; 2] {
        self.outputs(t, q, qd, qdd, lambda).into()
    }
    #[inline(always)]
    fn output_rates(&self, t: S, q: &[S; 2], qd: &[S; 2], qdd: &[S; 2]) -> [S; 1] {
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
    ) -> [S; 1] {
        self.events(t, q, qd, qdd, lambda)
    }
    #[inline(always)]
    fn drawing(&self, t: S, q: &[S; 2]) -> [S; 44] {
        self.drawing(t, q)
    }
    #[inline(always)]
    fn initial(&self) -> sim_kernel::Initial<[S; 2]> {
        self.initial()
    }
}
