/// Whitworth's quick return: a crank that turns evenly drives a slotted link about a pivot inside the crank's circle,
/// and that drives a ram.
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
/// multipliers = [lambda_drive; lambda_slot; lambda_guide]
/// constraints = 0
/// [
///     J2, 0, 0, 1, constraint_jacobian[2, 1], 0;
///     0, mass_matrix[2, 2], mass_matrix[2, 3], 0, constraint_jacobian[2, 2], B_x;
///     0, mass_matrix[2, 3], mass_matrix[3, 3], 0, 0, l*rod_x;
///     1, 0, 0, 0, 0, 0;
///     constraint_jacobian[2, 1], constraint_jacobian[2, 2], 0, 0, 0, 0;
///     0, B_x, l*rod_x, 0, 0, 0
/// ] * [
///     alpha_ddot;
///     beta_ddot;
///     gamma_ddot;
///     lambda_drive;
///     lambda_slot;
///     lambda_guide
/// ] = [
///     0;
///     -convective_forces[2];
///     -convective_forces[3];
///     0;
///     ss_6*alpha_dot - ss_5*beta_dot;
///     -ss_1
/// ]
///
/// mass_matrix = [
///     J2, 0, 0;
///     0, mass_matrix[2, 2], mass_matrix[2, 3];
///     0, mass_matrix[2, 3], mass_matrix[3, 3]
/// ]
/// mass_matrix[2, 2] = J4 + c^2*m5 + c^2*m6
/// mass_matrix[2, 3] = c*l*m6*rod_x*sin(beta) - c*l*m5*link_y*rod_y/2 + c*l*m5*rod_x*sin(beta)/2
///     - c*l*m6*link_y*rod_y
/// mass_matrix[3, 3] = l^2*m5/3 + l^2*m6
///
/// convective_forces = [0; convective_forces[2]; convective_forces[3]]
/// convective_forces[2] = c*m6*ss_1*sin(beta) - c*m5*link_y*ss_2/2 + c*m5*ss_3*sin(beta)/2 - c*m6*link_y*ss_4
/// convective_forces[3] = l*m6*rod_y*ss_4 + l*m6*rod_x*ss_1 + l*m5*rod_y*ss_2/4 + l*m5*rod_x*ss_3/4
///
/// generalized_forces = [0; 0; 0]
///
/// constraints = [
///     alpha - t*w;
///     A_y*sin(beta) - r*link_y*sin(alpha);
///     C_y
/// ]
///
/// constraint_jacobian = [
///     1, 0, 0;
///     constraint_jacobian[2, 1], constraint_jacobian[2, 2], 0;
///     0, B_x, l*rod_x
/// ]
/// constraint_jacobian[2, 1] = -r*link_y*cos(alpha) - r*sin(alpha)*sin(beta)
/// constraint_jacobian[2, 2] = r*sin(alpha)*sin(beta) + A_y*link_y
///
/// constraint_convective = [0; ss_5*beta_dot - ss_6*alpha_dot; ss_1]
///
/// A_y = d + r*cos(alpha)
/// link_y = cos(beta)
/// B_x = c*sin(beta)
/// rod_x = cos(gamma)
/// rod_y = sin(gamma)
/// C_y = l*rod_y - c*link_y
/// ss_1 = c*link_y*beta_dot^2 - l*rod_y*gamma_dot^2
/// ss_2 = 2*c*beta_dot^2*sin(beta) + l*rod_x*gamma_dot^2
/// ss_3 = 2*c*link_y*beta_dot^2 - l*rod_y*gamma_dot^2
/// ss_4 = c*beta_dot^2*sin(beta) + l*rod_x*gamma_dot^2
/// ss_5 = r*alpha_dot*cos(alpha)*sin(beta) + r*link_y*beta_dot*sin(alpha)
///     - r*link_y*alpha_dot*sin(alpha) - A_y*beta_dot*sin(beta)
/// ss_6 = r*alpha_dot*cos(alpha)*sin(beta) + r*link_y*beta_dot*sin(alpha)
///     - r*link_y*alpha_dot*sin(alpha) - r*beta_dot*cos(alpha)*sin(beta)
/// ```
#[allow(non_snake_case)]
#[derive(
    ::core::clone::Clone,
    ::core::marker::Copy,
    ::core::fmt::Debug,
    ::core::cmp::PartialEq
)]
pub struct Whitworth<S = ::core::primitive::f64> {
    /// Radius of the crank, in `m`.
    pub r: S,
    /// Distance of the fixed pivots, less than the radius, in `m`.
    pub d: S,
    /// Radius at which the slotted link drives the rod, in `m`.
    pub c: S,
    /// Length of the connecting rod, in `m`.
    pub l: S,
    /// Speed of the crank, in `1/s`.
    pub w: S,
    /// Inertia of the crank and its wheel, in `kg*m^2`.
    pub J2: S,
    /// Inertia of the slotted link, in `kg*m^2`.
    pub J4: S,
    /// Mass of the connecting rod, slender, in `kg`.
    pub m5: S,
    /// Mass of the ram, in `kg`.
    pub m6: S,
    /// Length of the slotted link beyond its pivot, for drawings, in `m`.
    pub s: S,
}
impl<S: sim_kernel::Scalar> ::core::default::Default for Whitworth<S> {
    /// The declared values.
    fn default() -> Self {
        <Self as sim_kernel::Mechanism<S>>::defaults()
    }
}
/// Coordinates of [`Whitworth`] by name, in SI units; also for their speeds and accelerations.
#[allow(non_snake_case)]
#[derive(
    ::core::clone::Clone,
    ::core::marker::Copy,
    ::core::fmt::Debug,
    ::core::cmp::PartialEq
)]
pub struct WhitworthCoordinates<S = ::core::primitive::f64> {
    /// Angle of the crank, in `rad`.
    pub alpha: S,
    /// Angle of the slotted link, in `rad`.
    pub beta: S,
    /// Angle of the connecting rod, in `rad`.
    pub gamma: S,
}
impl<S: sim_kernel::Scalar> ::core::convert::From<[S; 3]> for WhitworthCoordinates<S> {
    fn from(values: [S; 3]) -> Self {
        Self {
            alpha: values[0],
            beta: values[1],
            gamma: values[2],
        }
    }
}
impl<S: sim_kernel::Scalar> ::core::convert::From<WhitworthCoordinates<S>> for [S; 3] {
    fn from(record: WhitworthCoordinates<S>) -> Self {
        [record.alpha, record.beta, record.gamma]
    }
}
/// Outputs of [`Whitworth`] by name, in SI units.
#[allow(non_snake_case)]
#[derive(
    ::core::clone::Clone,
    ::core::marker::Copy,
    ::core::fmt::Debug,
    ::core::cmp::PartialEq
)]
pub struct WhitworthOutputs<S = ::core::primitive::f64> {
    /// position, in `m`.
    pub x: S,
    /// velocity, in `m/s`.
    pub v: S,
    /// crank, in `1/s`.
    pub crank_speed: S,
    /// slotted link, in `1/s`.
    pub link_speed: S,
    /// torque, in `N*m`.
    pub T: S,
}
impl<S: sim_kernel::Scalar> ::core::convert::From<[S; 5]> for WhitworthOutputs<S> {
    fn from(values: [S; 5]) -> Self {
        Self {
            x: values[0],
            v: values[1],
            crank_speed: values[2],
            link_speed: values[3],
            T: values[4],
        }
    }
}
impl<S: sim_kernel::Scalar> ::core::convert::From<WhitworthOutputs<S>> for [S; 5] {
    fn from(record: WhitworthOutputs<S>) -> Self {
        [record.x, record.v, record.crank_speed, record.link_speed, record.T]
    }
}
/// Rates of the outputs of [`Whitworth`] by name, in SI units.
#[allow(non_snake_case)]
#[derive(
    ::core::clone::Clone,
    ::core::marker::Copy,
    ::core::fmt::Debug,
    ::core::cmp::PartialEq
)]
pub struct WhitworthOutputRates<S = ::core::primitive::f64> {
    /// Rate of `x`.
    pub x: S,
    /// Rate of `v`.
    pub v: S,
    /// Rate of `crank_speed`.
    pub crank_speed: S,
    /// Rate of `link_speed`.
    pub link_speed: S,
}
impl<S: sim_kernel::Scalar> ::core::convert::From<[S; 4]> for WhitworthOutputRates<S> {
    fn from(values: [S; 4]) -> Self {
        Self {
            x: values[0],
            v: values[1],
            crank_speed: values[2],
            link_speed: values[3],
        }
    }
}
impl<S: sim_kernel::Scalar> ::core::convert::From<WhitworthOutputRates<S>> for [S; 4] {
    fn from(record: WhitworthOutputRates<S>) -> Self {
        [record.x, record.v, record.crank_speed, record.link_speed]
    }
}
/// What the equations of motion need of the parameters of [`Whitworth`], from [`Whitworth::prepare`]; its methods are the kernels of each step.
#[allow(non_snake_case)]
#[derive(
    ::core::clone::Clone,
    ::core::marker::Copy,
    ::core::fmt::Debug,
    ::core::cmp::PartialEq
)]
pub struct WhitworthPrepared<S = ::core::primitive::f64> {
    J2: S,
    c: S,
    mass_beta_beta: S,
    l: S,
    k: S,
    k_2: S,
    mass_gamma_gamma: S,
    r: S,
    d: S,
    k_3: S,
    k_4: S,
    k_5: S,
    k_6: S,
    k_7: S,
    k_8: S,
    inverse_alpha: S,
    inverse_gamma: S,
    pivot_lambda_drive: S,
    minus_inverse_lambda_drive: S,
    w: S,
    k_9: S,
    k_10: S,
    k_11: S,
    k_12: S,
    k_13: S,
}
#[allow(non_snake_case, unused_variables, unused_parens, clippy::all, clippy::pedantic)]
impl<S: sim_kernel::Scalar> Whitworth<S> {
    /// What the equations of motion need of the parameters, computed once for a set of parameters.
    ///
    /// Operations: 10 additions, 22 multiplications, 3 divisions.
    #[inline]
    pub fn prepare(&self) -> WhitworthPrepared<S> {
        let c_squared = self.c * self.c;
        let w = c_squared * self.m5;
        let w_2 = c_squared * self.m6;
        let w_3 = self.c * self.l;
        let w_4 = self.m6 * w_3;
        let w_5 = self.m5 * S::from_f64(0.5);
        let w_6 = w_3 * w_5;
        let l_squared = self.l * self.l;
        let w_7 = self.m5 * l_squared;
        let w_8 = self.m6 * l_squared;
        let mass_gamma_gamma = S::from_f64(0.3333333333333333) * w_7 + w_8;
        let inverse_J2 = S::from_f64(1.0) / self.J2;
        let w_9 = w_4 * S::from_f64(2.0);
        let w_10 = self.m5 * w_3;
        WhitworthPrepared {
            J2: self.J2,
            c: self.c,
            mass_beta_beta: self.J4 + w + w_2,
            l: self.l,
            k: w_4 + w_6,
            k_2: w_6 + w_4,
            mass_gamma_gamma: mass_gamma_gamma,
            r: self.r,
            d: self.d,
            k_3: self.c * S::from_f64(2.0),
            k_4: self.c * self.m6,
            k_5: self.c * w_5,
            k_6: self.m6 * self.l,
            k_7: self.m5 * self.l * S::from_f64(0.25),
            k_8: self.r * S::from_f64(2.0),
            inverse_alpha: inverse_J2,
            inverse_gamma: S::from_f64(1.0) / mass_gamma_gamma,
            pivot_lambda_drive: -inverse_J2,
            minus_inverse_lambda_drive: S::from_f64(1.0) / inverse_J2,
            w: self.w,
            k_9: w_9 + w_10,
            k_10: w_10 + w_9,
            k_11: w_2 + w,
            k_12: w_7 * S::from_f64(0.25) + w_8,
            k_13: self.l * S::from_f64(2.0),
        }
    }
    /// Mass matrix `T_q' M T_q`, 3 x 3, symmetric, in SI units.
    ///
    /// Operations: 6 additions, 15 multiplications, 2 sine-cosine pairs.
    #[inline]
    pub fn mass_matrix(&self, t: S, q: &[S; 3]) -> [[S; 3]; 3] {
        let [_, beta, gamma] = *q;
        let c_squared = self.c * self.c;
        let ([sin_beta, rod_y], [link_y, rod_x]) = S::sin_cos_each([beta, gamma]);
        let w = self.c * self.l;
        let w_2 = self.m6 * w;
        let w_3 = self.m5 * S::from_f64(0.5) * w;
        let mass_gamma_beta = sin_beta * rod_x * (w_2 + w_3)
            - link_y * rod_y * (w_3 + w_2);
        let l_squared = self.l * self.l;
        [
            [self.J2, S::from_f64(0.0), S::from_f64(0.0)],
            [
                S::from_f64(0.0),
                self.J4 + c_squared * self.m5 + c_squared * self.m6,
                mass_gamma_beta,
            ],
            [
                S::from_f64(0.0),
                mass_gamma_beta,
                self.m5 * S::from_f64(0.3333333333333333) * l_squared
                    + self.m6 * l_squared,
            ],
        ]
    }
    /// Convective forces `T_q' M g`, 3, with `g = (T_q q' + T_t)_q q' + (..)_t`: joules per unit of each coordinate.
    ///
    /// Operations: 5 additions, 13 multiplications, 2 sine-cosine pairs.
    #[inline]
    pub fn convective_forces(&self, t: S, q: &[S; 3], qd: &[S; 3]) -> [S; 3] {
        let [_, beta, gamma] = *q;
        let [_, beta_dot, gamma_dot] = *qd;
        let w = self.c * self.l;
        let w_2 = self.m6 * w;
        let w_3 = S::from_f64(0.5) * self.m5 * w;
        let w_4 = w_2 + w_3;
        let ([sin_beta, rod_y], [link_y, rod_x]) = S::sin_cos_each([beta, gamma]);
        let w_5 = sin_beta * rod_y;
        let w_6 = link_y * rod_x;
        [
            S::from_f64(0.0),
            -(gamma_dot * gamma_dot * (w_4 * w_5 + (w_3 + w_2) * w_6)),
            w_4 * beta_dot * beta_dot * (w_5 + w_6),
        ]
    }
    /// Generalised forces `T_q' F`, 3: joules per unit of each coordinate.
    ///
    /// Operations: none.
    #[inline]
    pub fn generalized_forces(&self, t: S, q: &[S; 3], qd: &[S; 3]) -> [S; 3] {
        [S::from_f64(0.0), S::from_f64(0.0), S::from_f64(0.0)]
    }
    /// Constraints `C`, 3, in SI units; zero throughout the motion.
    ///
    /// Operations: 4 additions, 7 multiplications, 3 sine-cosine pairs.
    #[inline]
    pub fn constraints(&self, t: S, q: &[S; 3]) -> [S; 3] {
        let [alpha, beta, gamma] = *q;
        let ([sin_alpha, sin_beta, rod_y], [cos_alpha, link_y, _]) = S::sin_cos_each([
            alpha,
            beta,
            gamma,
        ]);
        [
            alpha - t * self.w,
            (self.d + self.r * cos_alpha) * sin_beta - self.r * sin_alpha * link_y,
            self.l * rod_y - link_y * self.c,
        ]
    }
    /// The sum of the magnitudes of the terms of `C`, 3, in SI units: what its rounding is relative to.
    ///
    /// Operations: 10 additions, 7 multiplications, 3 sine-cosine pairs.
    #[inline]
    pub fn constraint_magnitudes(&self, t: S, q: &[S; 3]) -> [S; 3] {
        let [alpha, beta, gamma] = *q;
        let ([sin_alpha, sin_beta, rod_y], [cos_alpha, link_y, _]) = S::sin_cos_each([
            alpha,
            beta,
            gamma,
        ]);
        [
            alpha.abs() + (t * self.w).abs(),
            (self.r * sin_alpha * link_y).abs()
                + ((self.d + self.r * cos_alpha) * sin_beta).abs(),
            (self.l * rod_y).abs() + (link_y * self.c).abs(),
        ]
    }
    /// Constraint Jacobian `C_q`, 3 x 3: units of each constraint per unit of each coordinate.
    ///
    /// Operations: 4 additions, 8 multiplications, 3 sine-cosine pairs.
    #[inline]
    pub fn constraint_jacobian(&self, t: S, q: &[S; 3]) -> [[S; 3]; 3] {
        let [alpha, beta, gamma] = *q;
        let ([sin_beta, _, sin_alpha], [link_y, rod_x, cos_alpha]) = S::sin_cos_each([
            beta,
            gamma,
            alpha,
        ]);
        let w = sin_beta * sin_alpha;
        [
            [S::from_f64(1.0), S::from_f64(0.0), S::from_f64(0.0)],
            [
                -(self.r * (link_y * cos_alpha + w)),
                self.r * w + link_y * (self.d + self.r * cos_alpha),
                S::from_f64(0.0),
            ],
            [S::from_f64(0.0), self.c * sin_beta, self.l * rod_x],
        ]
    }
    /// `C_t`, 3, units of `C` per second: the speeds obey `C_q q' + C_t = 0`.
    ///
    /// Operations: 1 addition.
    #[inline]
    pub fn constraint_time_derivative(&self, t: S, q: &[S; 3]) -> [S; 3] {
        [-self.w, S::from_f64(0.0), S::from_f64(0.0)]
    }
    /// `(C_q q' + C_t)_q q' + (..)_t`, 3, units of `C` per second squared: the part of `C''` without accelerations.
    ///
    /// Operations: 5 additions, 16 multiplications, 3 sine-cosine pairs.
    #[inline]
    pub fn constraint_convective(&self, t: S, q: &[S; 3], qd: &[S; 3]) -> [S; 3] {
        let [alpha, beta, gamma] = *q;
        let [alpha_dot, beta_dot, gamma_dot] = *qd;
        let ([sin_alpha, sin_beta, rod_y], [cos_alpha, link_y, _]) = S::sin_cos_each([
            alpha,
            beta,
            gamma,
        ]);
        let beta_dot_squared = beta_dot * beta_dot;
        [
            S::from_f64(0.0),
            (cos_alpha * sin_beta - sin_alpha * link_y)
                * (beta_dot * alpha_dot * self.r * S::from_f64(2.0)
                    - self.r * (beta_dot_squared + alpha_dot * alpha_dot))
                - sin_beta * self.d * beta_dot_squared,
            link_y * beta_dot_squared * self.c - gamma_dot * gamma_dot * self.l * rod_y,
        ]
    }
    /// `C` (3), `C_q` (3 x 3) and `C_t` (3) together, in SI units, for projection.
    ///
    /// Operations: 8 additions, 14 multiplications, 3 sine-cosine pairs.
    #[inline]
    pub fn constraint_linearization(
        &self,
        t: S,
        q: &[S; 3],
    ) -> sim_kernel::ConstraintLinearization<[S; 3], [[S; 3]; 3]> {
        let [alpha, beta, gamma] = *q;
        let ([sin_alpha, sin_beta, rod_y], [cos_alpha, link_y, rod_x]) = S::sin_cos_each([
            alpha,
            beta,
            gamma,
        ]);
        let A_y = self.d + self.r * cos_alpha;
        let w = self.r * sin_alpha;
        sim_kernel::ConstraintLinearization {
            values: [
                alpha - t * self.w,
                A_y * sin_beta - link_y * w,
                self.l * rod_y - link_y * self.c,
            ],
            jacobian: [
                [S::from_f64(1.0), S::from_f64(0.0), S::from_f64(0.0)],
                [
                    -(self.r * (link_y * cos_alpha + sin_alpha * sin_beta)),
                    sin_beta * w + link_y * A_y,
                    S::from_f64(0.0),
                ],
                [S::from_f64(0.0), sin_beta * self.c, self.l * rod_x],
            ],
            time_derivative: [-self.w, S::from_f64(0.0), S::from_f64(0.0)],
        }
    }
    /// Kinetic energy `v' M v / 2`, in joules.
    ///
    /// Operations: 10 additions, 29 multiplications, 2 sine-cosine pairs.
    #[inline]
    pub fn kinetic_energy(&self, t: S, q: &[S; 3], qd: &[S; 3]) -> S {
        let [_, beta, gamma] = *q;
        let [alpha_dot, beta_dot, gamma_dot] = *qd;
        let ([sin_beta, rod_y], [link_y, rod_x]) = S::sin_cos_each([beta, gamma]);
        let w = beta_dot * self.c;
        let w_2 = gamma_dot * self.l;
        let w_3 = rod_y * w_2;
        let w_4 = link_y * w - w_3;
        let w_5 = w_2 * rod_x;
        let w_6 = w * sin_beta + w_5;
        let w_7 = beta_dot * self.c * S::from_f64(2.0);
        let w_8 = link_y * w_7 - w_3;
        let w_9 = w_5 + sin_beta * w_7;
        let w_10 = self.m5 * S::from_f64(0.125) * (w_8 * w_8 + w_9 * w_9);
        let w_11 = gamma_dot * gamma_dot * S::from_f64(0.041666666666666664) * self.l
            * self.l * self.m5;
        S::from_f64(0.5) * self.m6 * (w_4 * w_4 + w_6 * w_6) + w_10
            + alpha_dot * alpha_dot * S::from_f64(0.5) * self.J2
            + beta_dot * beta_dot * S::from_f64(0.5) * self.J4 + w_11
    }
    /// Power of loads and drives, `F' v + lambda' C_t + T_t' (M x'' - F)`, in watts.
    ///
    /// Operations: 1 addition, 1 multiplication.
    #[inline]
    pub fn power(
        &self,
        t: S,
        q: &[S; 3],
        qd: &[S; 3],
        qdd: &[S; 3],
        lambda: &[S; 3],
    ) -> S {
        let [lambda_drive, _, _] = *lambda;
        -(self.w * lambda_drive)
    }
    /// Outputs, 5, in SI units.
    ///
    /// Operations: 3 additions, 6 multiplications, 2 sine-cosine pairs.
    #[inline]
    pub fn outputs(
        &self,
        t: S,
        q: &[S; 3],
        qd: &[S; 3],
        qdd: &[S; 3],
        lambda: &[S; 3],
    ) -> WhitworthOutputs<S> {
        let [_, beta, gamma] = *q;
        let [alpha_dot, beta_dot, gamma_dot] = *qd;
        let [lambda_drive, _, _] = *lambda;
        let ([sin_beta, rod_y], [link_y, rod_x]) = S::sin_cos_each([beta, gamma]);
        [
            self.c * sin_beta + self.l * rod_x,
            self.c * beta_dot * link_y - self.l * gamma_dot * rod_y,
            alpha_dot,
            beta_dot,
            -lambda_drive,
        ]
            .into()
    }
    /// Rates of the outputs that depend on neither accelerations nor multipliers, 4, in SI units per second.
    ///
    /// Operations: 4 additions, 12 multiplications, 2 sine-cosine pairs.
    #[inline]
    pub fn output_rates(
        &self,
        t: S,
        q: &[S; 3],
        qd: &[S; 3],
        qdd: &[S; 3],
    ) -> WhitworthOutputRates<S> {
        let [_, beta, gamma] = *q;
        let [_, beta_dot, gamma_dot] = *qd;
        let [alpha_ddot, beta_ddot, gamma_ddot] = *qdd;
        let ([sin_beta, rod_y], [link_y, rod_x]) = S::sin_cos_each([beta, gamma]);
        [
            beta_dot * self.c * link_y - gamma_dot * self.l * rod_y,
            self.c * (link_y * beta_ddot - beta_dot * beta_dot * sin_beta)
                - self.l * (gamma_dot * gamma_dot * rod_x + rod_y * gamma_ddot),
            alpha_ddot,
            beta_ddot,
        ]
            .into()
    }
    /// `left - right` of each event, 2, in SI units: zero when it happens.
    ///
    /// Operations: 2 additions, 5 multiplications, 2 sine-cosine pairs.
    #[inline]
    pub fn events(
        &self,
        t: S,
        q: &[S; 3],
        qd: &[S; 3],
        qdd: &[S; 3],
        lambda: &[S; 3],
    ) -> [S; 2] {
        let [alpha, beta, gamma] = *q;
        let [_, beta_dot, gamma_dot] = *qd;
        let ([_, rod_y], [link_y, _]) = S::sin_cos_each([beta, gamma]);
        [
            alpha - S::from_f64(2.0) * S::from_f64(::core::f64::consts::PI),
            beta_dot * self.c * link_y - gamma_dot * self.l * rod_y,
        ]
    }
    /// The numbers of each shape of the drawing, in metres and radians.
    ///
    /// Operations: 7 additions, 9 multiplications, 3 sine-cosine pairs.
    #[inline]
    pub fn drawing(&self, t: S, q: &[S; 3]) -> [S; 24] {
        let [alpha, beta, gamma] = *q;
        let ([sin_alpha, sin_beta, rod_y], [cos_alpha, link_y, rod_x]) = S::sin_cos_each([
            alpha,
            beta,
            gamma,
        ]);
        let A_x = -(self.r * sin_alpha);
        let A_y = self.d + self.r * cos_alpha;
        let B_x = self.c * sin_beta;
        let minus_B_y = self.c * link_y;
        let B_y = -minus_B_y;
        let C_x = B_x + self.l * rod_x;
        let C_y = self.l * rod_y - minus_B_y;
        [
            S::from_f64(0.0),
            self.d,
            S::from_f64(0.0),
            S::from_f64(0.0),
            S::from_f64(0.0),
            self.d,
            A_x,
            A_y,
            B_x,
            B_y,
            -(sin_beta * self.s),
            link_y * self.s,
            B_x,
            B_y,
            C_x,
            C_y,
            A_x,
            A_y,
            beta + S::from_f64(0.5) * S::from_f64(::core::f64::consts::PI),
            C_x,
            C_y,
            S::from_f64(0.0),
            B_x,
            B_y,
        ]
    }
    /// Declared start: values or guesses of the coordinates (3), and speeds (3), in SI units; 0 where nothing is declared.
    ///
    /// Operations: none.
    #[inline]
    pub fn initial(&self) -> sim_kernel::Initial<[S; 3]> {
        sim_kernel::Initial {
            positions: [S::from_f64(0.0), S::from_f64(0.0), S::from_f64(0.2)],
            speeds: [S::from_f64(0.0), S::from_f64(0.0), S::from_f64(0.0)],
        }
    }
    /// [`WhitworthPrepared::dynamics`] once; for many calls with the same parameters [`Self::prepare`] first.
    #[inline]
    pub fn dynamics(
        &self,
        t: S,
        q: &[S; 3],
        qd: &[S; 3],
    ) -> sim_kernel::Dynamics<S, [S; 3], [S; 3]> {
        self.prepare().dynamics(t, q, qd)
    }
    /// [`WhitworthPrepared::dynamics_jacobian`] once; for many calls with the same parameters [`Self::prepare`] first.
    #[inline]
    pub fn dynamics_jacobian(
        &self,
        t: S,
        q: &[S; 3],
        qd: &[S; 3],
    ) -> sim_kernel::DynamicsJacobian<S, [[S; 3]; 3], [[S; 3]; 3]> {
        self.prepare().dynamics_jacobian(t, q, qd)
    }
}
#[allow(non_snake_case, unused_variables, unused_parens, clippy::all, clippy::pedantic)]
impl<S: sim_kernel::Scalar> WhitworthPrepared<S> {
    /// Accelerations (3), multipliers (3) and power, from
    ///
    /// ```text
    /// [ T_q' M T_q   C_q' ] [ q''    ]   [ T_q' (F - M g)                      ]
    /// [ C_q          0    ] [ lambda ] = [ -(C_q q' + C_t)_q q' - (..)_t       ]
    /// ```
    ///
    /// by an elimination planned from the structure of the system. Where `refused` is set a pivot was too small and nothing else holds: solve that state from the other kernels.
    ///
    /// Operations: 32 additions, 68 multiplications, 3 divisions, 3 sine-cosine pairs.
    #[inline(always)]
    pub fn dynamics(
        &self,
        t: S,
        q: &[S; 3],
        qd: &[S; 3],
    ) -> sim_kernel::Dynamics<S, [S; 3], [S; 3]> {
        let [alpha, beta, gamma] = *q;
        let [alpha_dot, beta_dot, gamma_dot] = *qd;
        let gamma_dot_squared = gamma_dot * gamma_dot;
        let ([sin_beta, rod_y, sin_alpha], [link_y, rod_x, cos_alpha]) = S::sin_cos_each([
            beta,
            gamma,
            alpha,
        ]);
        let w = sin_beta * rod_y;
        let w_2 = rod_x * link_y;
        let beta_dot_squared = beta_dot * beta_dot;
        let minus_rhs_gamma = self.k * beta_dot_squared * (w + w_2);
        let mass_gamma_beta = sin_beta * rod_x * self.k - link_y * rod_y * self.k_2;
        let l_beta_gamma = mass_gamma_beta * self.inverse_gamma;
        let rhs_beta = gamma_dot_squared * (self.k * w + self.k_2 * w_2)
            + minus_rhs_gamma * l_beta_gamma;
        let guide_by_gamma = self.l * rod_x;
        let l_lambda_guide_gamma = guide_by_gamma * self.inverse_gamma;
        let pivot_beta = self.mass_beta_beta - mass_gamma_beta * l_beta_gamma;
        let k_lambda_guide_beta = self.c * sin_beta
            - mass_gamma_beta * l_lambda_guide_gamma;
        let inverse_beta = S::from_f64(1.0) / pivot_beta;
        let l_lambda_guide_beta = inverse_beta * k_lambda_guide_beta;
        let w_5 = guide_by_gamma * l_lambda_guide_gamma
            + k_lambda_guide_beta * l_lambda_guide_beta;
        let w_3 = sin_beta * sin_alpha;
        let slot_by_beta = self.r * w_3 + link_y * (self.d + self.r * cos_alpha);
        let minus_slot_by_alpha = self.r * (link_y * cos_alpha + w_3);
        let minus_k_lambda_guide_lambda_slot = slot_by_beta * l_lambda_guide_beta;
        let minus_l_lambda_slot_alpha = minus_slot_by_alpha * self.inverse_alpha;
        let minus_l_lambda_slot_lambda_drive = minus_l_lambda_slot_alpha
            * self.minus_inverse_lambda_drive;
        let l_lambda_slot_beta = slot_by_beta * inverse_beta;
        let w_4 = minus_slot_by_alpha * minus_l_lambda_slot_alpha
            + slot_by_beta * l_lambda_slot_beta;
        let pivot_lambda_slot = minus_l_lambda_slot_alpha
            * minus_l_lambda_slot_lambda_drive - w_4;
        let inverse_lambda_slot = S::from_f64(1.0) / pivot_lambda_slot;
        let minus_l_lambda_guide_lambda_slot = minus_k_lambda_guide_lambda_slot
            * inverse_lambda_slot;
        let minus_pivot_lambda_guide = w_5
            + minus_k_lambda_guide_lambda_slot * minus_l_lambda_guide_lambda_slot;
        let minus_rhs_lambda_slot = (sin_beta * cos_alpha - link_y * sin_alpha)
            * (beta_dot * alpha_dot * self.k_8
                - self.r * (beta_dot_squared + alpha_dot * alpha_dot))
            - sin_beta * self.d * beta_dot_squared + l_lambda_slot_beta * rhs_beta;
        let minus_lambda_guide = S::from_f64(1.0) / minus_pivot_lambda_guide
            * (minus_rhs_gamma * l_lambda_guide_gamma
                - (self.c * link_y * beta_dot_squared
                    - self.l * rod_y * gamma_dot_squared)
                - l_lambda_guide_beta * rhs_beta
                - minus_l_lambda_guide_lambda_slot * minus_rhs_lambda_slot);
        let minus_lambda_slot = inverse_lambda_slot * minus_rhs_lambda_slot
            + minus_l_lambda_guide_lambda_slot * minus_lambda_guide;
        let minus_lambda_drive = minus_l_lambda_slot_lambda_drive * minus_lambda_slot;
        let beta_ddot = inverse_beta * rhs_beta + l_lambda_slot_beta * minus_lambda_slot
            + l_lambda_guide_beta * minus_lambda_guide;
        sim_kernel::Dynamics {
            accelerations: [
                self.inverse_alpha * minus_lambda_drive
                    - minus_l_lambda_slot_alpha * minus_lambda_slot,
                beta_ddot,
                l_lambda_guide_gamma * minus_lambda_guide
                    - minus_rhs_gamma * self.inverse_gamma - l_beta_gamma * beta_ddot,
            ],
            multipliers: [-minus_lambda_drive, -minus_lambda_slot, -minus_lambda_guide],
            power: minus_lambda_drive * self.w,
            refused: sim_kernel::pivot_is_refused(self.J2, self.J2)
                | sim_kernel::pivot_is_refused(
                    self.mass_gamma_gamma,
                    self.mass_gamma_gamma,
                ) | sim_kernel::pivot_is_refused(pivot_beta, self.mass_beta_beta)
                | sim_kernel::pivot_is_refused(
                    self.pivot_lambda_drive,
                    self.inverse_alpha,
                ) | sim_kernel::pivot_is_refused(pivot_lambda_slot, w_4)
                | sim_kernel::pivot_is_refused(-minus_pivot_lambda_guide, w_5),
        }
    }
    /// The derivatives of accelerations (3 rows) and multipliers (3 rows) with respect to coordinates and speeds (3 columns each): with the equations of motion as `K z = r`, the solutions of `K dz = dr - dK z`. Where `refused` is set a pivot was too small and nothing else holds.
    ///
    /// Operations: 133 additions, 226 multiplications, 3 divisions, 3 sine-cosine pairs.
    #[inline]
    pub fn dynamics_jacobian(
        &self,
        t: S,
        q: &[S; 3],
        qd: &[S; 3],
    ) -> sim_kernel::DynamicsJacobian<S, [[S; 3]; 3], [[S; 3]; 3]> {
        let [alpha, beta, gamma] = *q;
        let [alpha_dot, beta_dot, gamma_dot] = *qd;
        let gamma_dot_squared = gamma_dot * gamma_dot;
        let ([sin_beta, rod_y, sin_alpha], [link_y, rod_x, cos_alpha]) = S::sin_cos_each([
            beta,
            gamma,
            alpha,
        ]);
        let w = sin_beta * rod_y;
        let w_2 = rod_x * link_y;
        let beta_dot_squared = beta_dot * beta_dot;
        let w_3 = w + w_2;
        let minus_rhs_gamma = self.k * beta_dot_squared * w_3;
        let w_59 = beta_dot * w_3 * self.k_9;
        let w_4 = sin_beta * rod_x;
        let w_5 = link_y * rod_y;
        let mass_gamma_beta = self.k * w_4 - self.k_2 * w_5;
        let l_beta_gamma = mass_gamma_beta * self.inverse_gamma;
        let rhs_beta = gamma_dot_squared * (self.k * w + self.k_2 * w_2)
            + minus_rhs_gamma * l_beta_gamma;
        let guide_by_gamma = self.l * rod_x;
        let l_lambda_guide_gamma = guide_by_gamma * self.inverse_gamma;
        let w_6 = link_y * beta_dot_squared;
        let w_7 = self.l * rod_y * gamma_dot_squared;
        let w_8 = self.c * w_6 - w_7;
        let w_31 = w_6 * self.k_3 - w_7;
        let pivot_beta = self.mass_beta_beta - mass_gamma_beta * l_beta_gamma;
        let inverse_beta = S::from_f64(1.0) / pivot_beta;
        let k_lambda_guide_beta = self.c * sin_beta
            - mass_gamma_beta * l_lambda_guide_gamma;
        let l_lambda_guide_beta = inverse_beta * k_lambda_guide_beta;
        let w_17 = guide_by_gamma * l_lambda_guide_gamma
            + k_lambda_guide_beta * l_lambda_guide_beta;
        let w_32 = guide_by_gamma * gamma_dot_squared;
        let w_9 = sin_beta * sin_alpha;
        let A_y = self.d + self.r * cos_alpha;
        let slot_by_beta = self.r * w_9 + link_y * A_y;
        let w_10 = link_y * cos_alpha + w_9;
        let w_29 = sin_beta * A_y;
        let minus_k_lambda_guide_lambda_slot = slot_by_beta * l_lambda_guide_beta;
        let minus_slot_by_alpha = self.r * w_10;
        let minus_l_lambda_slot_alpha = minus_slot_by_alpha * self.inverse_alpha;
        let minus_l_lambda_slot_lambda_drive = minus_l_lambda_slot_alpha
            * self.minus_inverse_lambda_drive;
        let l_lambda_slot_beta = slot_by_beta * inverse_beta;
        let w_11 = minus_slot_by_alpha * minus_l_lambda_slot_alpha
            + slot_by_beta * l_lambda_slot_beta;
        let pivot_lambda_slot = minus_l_lambda_slot_alpha
            * minus_l_lambda_slot_lambda_drive - w_11;
        let inverse_lambda_slot = S::from_f64(1.0) / pivot_lambda_slot;
        let minus_l_lambda_guide_lambda_slot = minus_k_lambda_guide_lambda_slot
            * inverse_lambda_slot;
        let minus_pivot_lambda_guide = w_17
            + minus_k_lambda_guide_lambda_slot * minus_l_lambda_guide_lambda_slot;
        let w_12 = sin_beta * cos_alpha;
        let w_13 = link_y * sin_alpha;
        let w_14 = w_12 - w_13;
        let w_15 = sin_beta * beta_dot_squared;
        let minus_rhs_lambda_slot = w_14
            * (beta_dot * alpha_dot * self.k_8
                - self.r * (beta_dot_squared + alpha_dot * alpha_dot)) - self.d * w_15
            + l_lambda_slot_beta * rhs_beta;
        let w_16 = self.r * w_14;
        let w_54 = alpha_dot * w_14 + beta_dot * w_13;
        let w_30 = self.r * w_13 - w_29;
        let minus_inverse_lambda_guide = S::from_f64(1.0) / minus_pivot_lambda_guide;
        let minus_lambda_guide = minus_inverse_lambda_guide
            * (minus_rhs_gamma * l_lambda_guide_gamma - w_8
                - l_lambda_guide_beta * rhs_beta
                - minus_l_lambda_guide_lambda_slot * minus_rhs_lambda_slot);
        let minus_lambda_slot = inverse_lambda_slot * minus_rhs_lambda_slot
            + minus_l_lambda_guide_lambda_slot * minus_lambda_guide;
        let beta_ddot = inverse_beta * rhs_beta + l_lambda_slot_beta * minus_lambda_slot
            + l_lambda_guide_beta * minus_lambda_guide;
        let gamma_ddot = l_lambda_guide_gamma * minus_lambda_guide
            - minus_rhs_gamma * self.inverse_gamma - l_beta_gamma * beta_ddot;
        let alpha_ddot = self.inverse_alpha * minus_l_lambda_slot_lambda_drive
            * minus_lambda_slot - minus_l_lambda_slot_alpha * minus_lambda_slot;
        let w_18 = alpha_dot - beta_dot;
        let w_19 = self.r * w_10 * w_18;
        let w_55 = self.r * (w_54 - beta_dot * w_12) + w_16 * w_18;
        let w_20 = minus_lambda_slot * w_16;
        let w_21 = minus_l_lambda_slot_alpha * w_20;
        let w_22 = self.inverse_alpha * w_20;
        let w_23 = minus_l_lambda_slot_lambda_drive * w_22;
        let w_24 = w_16 * (alpha_ddot - beta_ddot) - w_18 * w_19 - w_21
            - l_lambda_slot_beta * w_20 + w_23;
        let w_25 = minus_inverse_lambda_guide
            * (minus_l_lambda_guide_lambda_slot * w_24 - l_lambda_guide_beta * w_20);
        let w_26 = inverse_lambda_slot * w_24 - minus_l_lambda_guide_lambda_slot * w_25;
        let w_51 = inverse_beta * w_20 - l_lambda_slot_beta * w_26
            + l_lambda_guide_beta * w_25;
        let w_27 = self.minus_inverse_lambda_drive * w_22;
        let w_28 = minus_l_lambda_slot_lambda_drive * w_26 - w_27;
        let w_33 = self.k_3 * w_15 + w_32;
        let w_34 = w_32 + self.c * w_15;
        let w_35 = S::from_f64(0.5) * (w_2 * self.k_9 + w * self.k_10);
        let w_65 = gamma_dot * (w * self.k_9 + w_2 * self.k_10);
        let w_36 = gamma_ddot * w_35;
        let w_37 = link_y
            * (self.c * minus_lambda_guide - w_8 * self.k_4 - w_31 * self.k_5)
            - sin_beta * (w_33 * self.k_5 + w_34 * self.k_4) - w_36
            + minus_lambda_slot * w_30 + beta_dot_squared * self.k_11;
        let w_38 = beta_ddot * w_35;
        let w_39 = self.k * beta_dot_squared * (w_4 - w_5) - w_38;
        let w_40 = w_37 - l_beta_gamma * w_39;
        let w_41 = alpha_dot * w_19 - alpha_ddot * w_16
            - beta_dot * (minus_slot_by_alpha * alpha_dot - slot_by_beta * beta_dot)
            - beta_ddot * w_30 + w_21 - l_lambda_slot_beta * w_40 - w_23;
        let w_42 = minus_inverse_lambda_guide
            * (self.c * (w_15 - link_y * beta_ddot) - l_lambda_guide_gamma * w_39
                - l_lambda_guide_beta * w_40 + minus_l_lambda_guide_lambda_slot * w_41);
        let w_43 = inverse_lambda_slot * w_41 - minus_l_lambda_guide_lambda_slot * w_42;
        let w_44 = w_27 + minus_l_lambda_slot_lambda_drive * w_43;
        let w_52 = inverse_beta * w_40 - l_lambda_slot_beta * w_43
            + l_lambda_guide_beta * w_42;
        let w_45 = w_38
            + rod_y * (w_8 * self.k_6 + w_31 * self.k_7 - self.l * minus_lambda_guide)
            - rod_x * (w_34 * self.k_6 + w_33 * self.k_7)
            + gamma_dot_squared * self.k_12;
        let w_46 = w_36 + mass_gamma_beta * gamma_dot_squared - l_beta_gamma * w_45;
        let w_47 = l_lambda_slot_beta * w_46;
        let w_48 = minus_inverse_lambda_guide
            * (self.l * (rod_x * gamma_dot_squared + rod_y * gamma_ddot)
                - l_lambda_guide_gamma * w_45 - l_lambda_guide_beta * w_46
                - minus_l_lambda_guide_lambda_slot * w_47);
        let w_49 = inverse_lambda_slot * w_47 + minus_l_lambda_guide_lambda_slot * w_48;
        let w_53 = inverse_beta * w_46 + l_lambda_slot_beta * w_49
            + l_lambda_guide_beta * w_48;
        let w_50 = minus_l_lambda_slot_lambda_drive * w_49;
        let w_56 = minus_inverse_lambda_guide * minus_l_lambda_guide_lambda_slot * w_55;
        let w_57 = inverse_lambda_slot * w_55 - minus_l_lambda_guide_lambda_slot * w_56;
        let w_58 = minus_l_lambda_slot_lambda_drive * w_57;
        let w_60 = l_beta_gamma * w_59;
        let w_61 = beta_dot * (w_29 - w_30) - self.r * w_54 - alpha_dot * w_16
            - l_lambda_slot_beta * w_60;
        let w_62 = minus_inverse_lambda_guide
            * (l_lambda_guide_gamma * w_59 - link_y * beta_dot * self.k_3
                - l_lambda_guide_beta * w_60 + minus_l_lambda_guide_lambda_slot * w_61);
        let w_63 = inverse_lambda_slot * w_61 - minus_l_lambda_guide_lambda_slot * w_62;
        let w_71 = inverse_beta * w_60 - l_lambda_slot_beta * w_63
            + l_lambda_guide_beta * w_62;
        let w_64 = minus_l_lambda_slot_lambda_drive * w_63;
        let w_66 = l_lambda_slot_beta * w_65;
        let w_67 = minus_inverse_lambda_guide
            * (rod_y * gamma_dot * self.k_13 - l_lambda_guide_beta * w_65
                - minus_l_lambda_guide_lambda_slot * w_66);
        let w_68 = inverse_lambda_slot * w_66 + minus_l_lambda_guide_lambda_slot * w_67;
        let w_69 = minus_l_lambda_slot_lambda_drive * w_68;
        let w_72 = inverse_beta * w_65 + l_lambda_slot_beta * w_68
            + l_lambda_guide_beta * w_67;
        let w_70 = l_lambda_guide_beta * w_56 - l_lambda_slot_beta * w_57;
        sim_kernel::DynamicsJacobian {
            accelerations_by_positions: [
                [
                    minus_l_lambda_slot_alpha * w_26 - w_22 - self.inverse_alpha * w_28,
                    w_22 - self.inverse_alpha * w_44 + minus_l_lambda_slot_alpha * w_43,
                    self.inverse_alpha * w_50 - minus_l_lambda_slot_alpha * w_49,
                ],
                [w_51, w_52, w_53],
                [
                    l_lambda_guide_gamma * w_25 - l_beta_gamma * w_51,
                    self.inverse_gamma * w_39 - l_beta_gamma * w_52
                        + l_lambda_guide_gamma * w_42,
                    self.inverse_gamma * w_45 - l_beta_gamma * w_53
                        + l_lambda_guide_gamma * w_48,
                ],
            ],
            accelerations_by_speeds: [
                [
                    minus_l_lambda_slot_alpha * w_57 - self.inverse_alpha * w_58,
                    minus_l_lambda_slot_alpha * w_63 - self.inverse_alpha * w_64,
                    self.inverse_alpha * w_69 - minus_l_lambda_slot_alpha * w_68,
                ],
                [w_70, w_71, w_72],
                [
                    l_lambda_guide_gamma * w_56 - l_beta_gamma * w_70,
                    l_lambda_guide_gamma * w_62 - self.inverse_gamma * w_59
                        - l_beta_gamma * w_71,
                    l_lambda_guide_gamma * w_67 - l_beta_gamma * w_72,
                ],
            ],
            multipliers_by_positions: [
                [w_28, w_44, -w_50],
                [w_26, w_43, -w_49],
                [-w_25, -w_42, -w_48],
            ],
            multipliers_by_speeds: [
                [w_58, w_64, -w_69],
                [w_57, w_63, -w_68],
                [-w_56, -w_62, -w_67],
            ],
            refused: sim_kernel::pivot_is_refused(self.J2, self.J2)
                | sim_kernel::pivot_is_refused(
                    self.mass_gamma_gamma,
                    self.mass_gamma_gamma,
                ) | sim_kernel::pivot_is_refused(pivot_beta, self.mass_beta_beta)
                | sim_kernel::pivot_is_refused(
                    self.pivot_lambda_drive,
                    self.inverse_alpha,
                ) | sim_kernel::pivot_is_refused(pivot_lambda_slot, w_11)
                | sim_kernel::pivot_is_refused(-minus_pivot_lambda_guide, w_17),
        }
    }
}
#[allow(non_snake_case, clippy::all, clippy::pedantic)]
impl<S: sim_kernel::Scalar> sim_kernel::Mechanism<S> for Whitworth<S> {
    type Q = [S; 3];
    type L = [S; 3];
    type Z = [S; 6];
    type QQ = [[S; 3]; 3];
    type LQ = [[S; 3]; 3];
    type LL = [[S; 3]; 3];
    type ZZ = [[S; 6]; 6];
    type Entries = [S; 0];
    type Envelope = [S; 0];
    type Parameters = [S; 10];
    type Outputs = [S; 5];
    type OutputRates = [S; 4];
    type Events = [S; 2];
    type EventValues = [S; 0];
    type Activities = [S; 0];
    type Drawing = [S; 24];
    type QP = [[S; 10]; 3];
    type LP = [[S; 10]; 3];
    type Inputs = [sim_kernel::Input<S>; 0];
    type Prepared = WhitworthPrepared<S>;
    type On<T: sim_kernel::Scalar> = Whitworth<T>;
    const DESCRIPTION: sim_kernel::Description = sim_kernel::Description {
        name: "whitworth",
        type_name: "Whitworth",
        docs: "Whitworth's quick return: a crank that turns evenly drives a slotted link about a pivot inside the crank's circle,\nand that drives a ram.",
        declaration: "/// Whitworth's quick return: a crank that turns evenly drives a slotted link about a pivot inside the crank's circle,\n/// and that drives a ram.\npub Whitworth;\n\ncoordinates {\n    /// Angle of the crank.\n    alpha [rad];\n    /// Angle of the slotted link.\n    beta [rad];\n    /// Angle of the connecting rod.\n    gamma [rad];\n}\n\nparameters {\n    /// Radius of the crank.\n    r [m] = 0.2;\n    /// Distance of the fixed pivots, less than the radius.\n    d [m] = 0.09;\n    /// Radius at which the slotted link drives the rod.\n    c [m] = 0.12;\n    /// Length of the connecting rod.\n    l [m] = 0.5;\n    /// Speed of the crank.\n    w [rpm] = 60;\n    /// Inertia of the crank and its wheel.\n    J2 [kg*m^2] = 0.2;\n    /// Inertia of the slotted link.\n    J4 [kg*m^2] = 0.15;\n    /// Mass of the connecting rod, slender.\n    m5 [kg] = 2;\n    /// Mass of the ram.\n    m6 [kg] = 8;\n    /// Length of the slotted link beyond its pivot, for drawings.\n    s [m] = 0.3;\n}\n\nlet O4 = [0, 0];\nlet O2 = [0, d];\nlet A = O2 + r*[-sin(alpha), cos(alpha)];\nlet link = [-sin(beta), cos(beta)];\nlet B = -c*link;\nlet rod = [cos(gamma), sin(gamma)];\nlet C = B + l*rod;\n\nbodies {\n    crank: inertia J2, angle alpha;\n    slotted_link: inertia J4, angle beta;\n    connecting_rod: mass m5 at B + l/2*rod, inertia m5*l^2/12, angle gamma;\n    ram: mass m6 at C;\n}\n\nconstraints {\n    drive: alpha = w*t;\n    slot: A.x*link.y = A.y*link.x;\n    guide: C.y = 0;\n}\n\ninitial {\n    guess alpha = 0;\n    guess beta = 0;\n    guess gamma = 0.2;\n}\n\nevents {\n    period: alpha = 2*pi;\n    /// The ram turns back.\n    dead_point: dot(C.x) = 0;\n}\n\noutputs {\n    ram \"Position of the ram\" {\n        /// position\n        x [mm] = C.x;\n    }\n    ram_velocity \"Velocity of the ram\" {\n        /// velocity\n        v [m/s] = dot(C.x);\n    }\n    speeds \"Angular speeds\" {\n        /// crank\n        crank_speed [rpm] = dot(alpha);\n        /// slotted link\n        link_speed [rpm] = dot(beta);\n    }\n    torque \"Torque on the crank\" {\n        /// torque\n        T [N*m] = -reaction(drive);\n    }\n}\n\ndrawing {\n    ground O2, O4;\n    line O2, A;\n    line B, s*link;\n    line B, C;\n    slider A along beta + pi/2;\n    slider C along 0;\n    point B;\n}\n",
        coordinates: &[
            sim_kernel::Coordinate {
                position: sim_kernel::Quantity {
                    name: "alpha",
                    unit: "rad",
                    factor: 1f64,
                    is_length: false,
                    docs: "Angle of the crank.",
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
                start: sim_kernel::Start::Guess,
                speed_given: false,
            },
            sim_kernel::Coordinate {
                position: sim_kernel::Quantity {
                    name: "beta",
                    unit: "rad",
                    factor: 1f64,
                    is_length: false,
                    docs: "Angle of the slotted link.",
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
                    docs: "Angle of the connecting rod.",
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
                name: "r",
                unit: "m",
                factor: 1f64,
                is_length: true,
                docs: "Radius of the crank.",
            },
            sim_kernel::Quantity {
                name: "d",
                unit: "m",
                factor: 1f64,
                is_length: true,
                docs: "Distance of the fixed pivots, less than the radius.",
            },
            sim_kernel::Quantity {
                name: "c",
                unit: "m",
                factor: 1f64,
                is_length: true,
                docs: "Radius at which the slotted link drives the rod.",
            },
            sim_kernel::Quantity {
                name: "l",
                unit: "m",
                factor: 1f64,
                is_length: true,
                docs: "Length of the connecting rod.",
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
                docs: "Inertia of the crank and its wheel.",
            },
            sim_kernel::Quantity {
                name: "J4",
                unit: "kg*m^2",
                factor: 1f64,
                is_length: false,
                docs: "Inertia of the slotted link.",
            },
            sim_kernel::Quantity {
                name: "m5",
                unit: "kg",
                factor: 1f64,
                is_length: false,
                docs: "Mass of the connecting rod, slender.",
            },
            sim_kernel::Quantity {
                name: "m6",
                unit: "kg",
                factor: 1f64,
                is_length: false,
                docs: "Mass of the ram.",
            },
            sim_kernel::Quantity {
                name: "s",
                unit: "m",
                factor: 1f64,
                is_length: true,
                docs: "Length of the slotted link beyond its pivot, for drawings.",
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
                name: "slot",
                unit: "N",
                factor: 1f64,
                is_length: false,
                docs: "",
            },
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
        conditionals: &[],
        events: &[
            sim_kernel::event::Event {
                name: "period",
                direction: sim_kernel::event::Direction::Both,
                on_forces: false,
                steps: &[],
            },
            sim_kernel::event::Event {
                name: "dead_point",
                direction: sim_kernel::event::Direction::Both,
                on_forces: false,
                steps: &[],
            },
        ],
        outputs: &[
            sim_kernel::Quantity {
                name: "x",
                unit: "mm",
                factor: 0.001f64,
                is_length: true,
                docs: "position",
            },
            sim_kernel::Quantity {
                name: "v",
                unit: "m/s",
                factor: 1f64,
                is_length: false,
                docs: "velocity",
            },
            sim_kernel::Quantity {
                name: "crank_speed",
                unit: "rpm",
                factor: 0.10471975511965977f64,
                is_length: false,
                docs: "crank",
            },
            sim_kernel::Quantity {
                name: "link_speed",
                unit: "rpm",
                factor: 0.10471975511965977f64,
                is_length: false,
                docs: "slotted link",
            },
            sim_kernel::Quantity {
                name: "T",
                unit: "N*m",
                factor: 1f64,
                is_length: false,
                docs: "torque",
            },
        ],
        rated_outputs: &[0, 1, 2, 3],
        figures: &[
            sim_kernel::Figure {
                name: "ram",
                title: "Position of the ram",
                len: 1,
            },
            sim_kernel::Figure {
                name: "ram_velocity",
                title: "Velocity of the ram",
                len: 1,
            },
            sim_kernel::Figure {
                name: "speeds",
                title: "Angular speeds",
                len: 2,
            },
            sim_kernel::Figure {
                name: "torque",
                title: "Torque on the crank",
                len: 1,
            },
        ],
        optional_kernels: &["dynamics_jacobian"],
        dimension: 2,
        drawing: &[
            sim_kernel::Shape::Ground(2),
            sim_kernel::Shape::Line(2),
            sim_kernel::Shape::Line(2),
            sim_kernel::Shape::Line(2),
            sim_kernel::Shape::Slider,
            sim_kernel::Shape::Slider,
            sim_kernel::Shape::Points(1),
        ],
    };
    fn defaults() -> Self {
        Self {
            r: S::from_f64(0.2f64),
            d: S::from_f64(0.09f64),
            c: S::from_f64(0.12f64),
            l: S::from_f64(0.5f64),
            w: S::from_f64(6.283185307179586f64),
            J2: S::from_f64(0.2f64),
            J4: S::from_f64(0.15f64),
            m5: S::from_f64(2f64),
            m6: S::from_f64(8f64),
            s: S::from_f64(0.3f64),
        }
    }
    fn parameters(&self) -> [S; 10] {
        [
            self.r,
            self.d,
            self.c,
            self.l,
            self.w,
            self.J2,
            self.J4,
            self.m5,
            self.m6,
            self.s,
        ]
    }
    fn with_parameters(&self, parameters: [S; 10]) -> Self {
        Self {
            r: parameters[0],
            d: parameters[1],
            c: parameters[2],
            l: parameters[3],
            w: parameters[4],
            J2: parameters[5],
            J4: parameters[6],
            m5: parameters[7],
            m6: parameters[8],
            s: parameters[9],
            ..*self
        }
    }
    fn on<T: sim_kernel::Scalar>(
        &self,
        convert: impl ::core::ops::Fn(S) -> T,
    ) -> Whitworth<T> {
        Whitworth {
            r: convert(self.r),
            d: convert(self.d),
            c: convert(self.c),
            l: convert(self.l),
            w: convert(self.w),
            J2: convert(self.J2),
            J4: convert(self.J4),
            m5: convert(self.m5),
            m6: convert(self.m6),
            s: convert(self.s),
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
    fn prepare(&self) -> WhitworthPrepared<S> {
        self.prepare()
    }
    #[inline(always)]
    fn prepared_dynamics(
        prepared: &Self::Prepared,
        t: S,
        q: &[S; 3],
        qd: &[S; 3],
    ) -> sim_kernel::Dynamics<S, [S; 3], [S; 3]> {
        prepared.dynamics(t, q, qd)
    }
    #[inline(always)]
    fn dynamics_jacobian(
        &self,
        t: S,
        q: &[S; 3],
        qd: &[S; 3],
    ) -> sim_kernel::DynamicsJacobian<S, [[S; 3]; 3], [[S; 3]; 3]> {
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
    fn constraints(&self, t: S, q: &[S; 3]) -> [S; 3] {
        self.constraints(t, q)
    }
    #[inline(always)]
    fn constraint_magnitudes(&self, t: S, q: &[S; 3]) -> [S; 3] {
        self.constraint_magnitudes(t, q)
    }
    #[inline(always)]
    fn constraint_jacobian(&self, t: S, q: &[S; 3]) -> [[S; 3]; 3] {
        self.constraint_jacobian(t, q)
    }
    #[inline(always)]
    fn constraint_time_derivative(&self, t: S, q: &[S; 3]) -> [S; 3] {
        self.constraint_time_derivative(t, q)
    }
    #[inline(always)]
    fn constraint_convective(&self, t: S, q: &[S; 3], qd: &[S; 3]) -> [S; 3] {
        self.constraint_convective(t, q, qd)
    }
    #[inline(always)]
    fn constraint_linearization(
        &self,
        t: S,
        q: &[S; 3],
    ) -> sim_kernel::ConstraintLinearization<[S; 3], [[S; 3]; 3]> {
        self.constraint_linearization(t, q)
    }
    #[inline(always)]
    fn kinetic_energy(&self, t: S, q: &[S; 3], qd: &[S; 3]) -> S {
        self.kinetic_energy(t, q, qd)
    }
    #[inline(always)]
    fn power(&self, t: S, q: &[S; 3], qd: &[S; 3], qdd: &[S; 3], lambda: &[S; 3]) -> S {
        self.power(t, q, qd, qdd, lambda)
    }
    #[inline(always)]
    fn outputs(
        &self,
        t: S,
        q: &[S; 3],
        qd: &[S; 3],
        qdd: &[S; 3],
        lambda: &[S; 3],
    ) -> [S; 5] {
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
        lambda: &[S; 3],
    ) -> [S; 2] {
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
