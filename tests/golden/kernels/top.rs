/// A heavy symmetric top on a fixed point that precesses and, unless `nod` is 0, nods.
///
/// The fields are its parameters, in SI units; the methods are its kernels.
///
/// # Equations of motion
///
/// ```text
/// mass_matrix * accelerations = generalized_forces - convective_forces
/// coordinates = [psi; theta; phi]
/// [
///     mass_matrix[1, 1], 0, C*cos(theta);
///     0, inertia_about_pivot, 0;
///     C*cos(theta), 0, C
/// ] * [psi_ddot; theta_ddot; phi_ddot] = [
///     -convective_forces[1];
///     m*l*g*sin(theta) - convective_forces[2];
///     C*psi_dot*theta_dot*sin(theta)
/// ]
///
/// mass_matrix = [
///     mass_matrix[1, 1], 0, C*cos(theta);
///     0, inertia_about_pivot, 0;
///     C*cos(theta), 0, C
/// ]
/// mass_matrix[1, 1] = C*cos(theta)^2 + A*sin(theta)^2 + m*l^2*sin(theta)^2
///
/// convective_forces = [
///     convective_forces[1];
///     convective_forces[2];
///     -C*psi_dot*theta_dot*sin(theta)
/// ]
/// convective_forces[1] = s_5*sin(theta)*sin(phi) + s_6*sin(theta)*cos(phi) + m*l^2*s_4*sin(theta)*sin(phi)
///     - C*psi_dot*theta_dot*sin(theta)*cos(theta) - m*l^2*s_3*sin(theta)*cos(phi)
/// convective_forces[2] = s_5*cos(phi) + m*l^2*s_3*sin(phi) + m*l^2*s_4*cos(phi) - s_6*sin(phi)
///
/// generalized_forces = [0; m*l*g*sin(theta); 0]
///
/// s_1 = theta_dot*cos(phi) + psi_dot*sin(theta)*sin(phi)
/// s_2 = psi_dot*sin(theta)*cos(phi) - theta_dot*sin(phi)
/// inertia_about_pivot = A + m*l^2
/// s_3 = s_1*phi_dot - s_1*(phi_dot + psi_dot*cos(theta))
///     - psi_dot*theta_dot*cos(theta)*cos(phi)
/// s_4 = s_2*phi_dot - s_2*(phi_dot + psi_dot*cos(theta))
///     + psi_dot*theta_dot*cos(theta)*sin(phi)
/// s_5 = C*s_2*(phi_dot + psi_dot*cos(theta)) - A*s_2*(phi_dot + psi_dot*cos(theta))
///     + A*(s_2*phi_dot + psi_dot*theta_dot*cos(theta)*sin(phi))
/// s_6 = A*s_1*(phi_dot + psi_dot*cos(theta)) - C*s_1*(phi_dot + psi_dot*cos(theta))
///     - A*(s_1*phi_dot - psi_dot*theta_dot*cos(theta)*cos(phi))
/// ```
#[allow(non_snake_case)]
#[derive(
    ::core::clone::Clone,
    ::core::marker::Copy,
    ::core::fmt::Debug,
    ::core::cmp::PartialEq
)]
pub struct Top<S = ::core::primitive::f64> {
    /// In `kg`.
    pub m: S,
    /// Distance of the centre of mass from the point it stands on, in `m`.
    pub l: S,
    /// Moment of inertia across the axis, about the centre of mass, in `kg*m^2`.
    pub A: S,
    /// And about the axis, in `kg*m^2`.
    pub C: S,
    /// In `m/s^2`.
    pub g: S,
    /// Nutation, in `1`.
    pub theta0: S,
    /// Angular velocity along the axis, in `rad/s`.
    pub spin: S,
    /// Speed of nutation at the start, in `rad/s`.
    pub nod: S,
}
impl<S: sim_kernel::Scalar> ::core::default::Default for Top<S> {
    /// The declared values.
    fn default() -> Self {
        <Self as sim_kernel::Compiled<S>>::defaults()
    }
}
/// Coordinates of [`Top`] by name, in SI units; also for their speeds and accelerations.
#[allow(non_snake_case)]
#[derive(
    ::core::clone::Clone,
    ::core::marker::Copy,
    ::core::fmt::Debug,
    ::core::cmp::PartialEq
)]
pub struct TopCoordinates<S = ::core::primitive::f64> {
    /// Precession about the vertical, in `rad`.
    pub psi: S,
    /// Nutation from the vertical, in `rad`.
    pub theta: S,
    /// Spin about its own axis, in `rad`.
    pub phi: S,
}
impl<S: sim_kernel::Scalar> ::core::convert::From<[S; 3]> for TopCoordinates<S> {
    fn from(values: [S; 3]) -> Self {
        Self {
            psi: values[0],
            theta: values[1],
            phi: values[2],
        }
    }
}
impl<S: sim_kernel::Scalar> ::core::convert::From<TopCoordinates<S>> for [S; 3] {
    fn from(record: TopCoordinates<S>) -> Self {
        [record.psi, record.theta, record.phi]
    }
}
/// Outputs of [`Top`] by name, in SI units.
#[allow(non_snake_case)]
#[derive(
    ::core::clone::Clone,
    ::core::marker::Copy,
    ::core::fmt::Debug,
    ::core::cmp::PartialEq
)]
pub struct TopOutputs<S = ::core::primitive::f64> {
    /// rate of precession, in `rad/s`.
    pub precession: S,
    /// nutation, in `1`.
    pub nutation: S,
    /// angular velocity along the axis, in `rad/s`.
    pub own_spin: S,
    /// height of the centre of mass, in `m`.
    pub height: S,
}
impl<S: sim_kernel::Scalar> ::core::convert::From<[S; 4]> for TopOutputs<S> {
    fn from(values: [S; 4]) -> Self {
        Self {
            precession: values[0],
            nutation: values[1],
            own_spin: values[2],
            height: values[3],
        }
    }
}
impl<S: sim_kernel::Scalar> ::core::convert::From<TopOutputs<S>> for [S; 4] {
    fn from(record: TopOutputs<S>) -> Self {
        [record.precession, record.nutation, record.own_spin, record.height]
    }
}
/// Rates of the outputs of [`Top`] by name, in SI units.
#[allow(non_snake_case)]
#[derive(
    ::core::clone::Clone,
    ::core::marker::Copy,
    ::core::fmt::Debug,
    ::core::cmp::PartialEq
)]
pub struct TopOutputRates<S = ::core::primitive::f64> {
    /// Rate of `precession`.
    pub precession: S,
    /// Rate of `nutation`.
    pub nutation: S,
    /// Rate of `own_spin`.
    pub own_spin: S,
    /// Rate of `height`.
    pub height: S,
}
impl<S: sim_kernel::Scalar> ::core::convert::From<[S; 4]> for TopOutputRates<S> {
    fn from(values: [S; 4]) -> Self {
        Self {
            precession: values[0],
            nutation: values[1],
            own_spin: values[2],
            height: values[3],
        }
    }
}
impl<S: sim_kernel::Scalar> ::core::convert::From<TopOutputRates<S>> for [S; 4] {
    fn from(record: TopOutputRates<S>) -> Self {
        [record.precession, record.nutation, record.own_spin, record.height]
    }
}
/// What the equations of motion need of the parameters of [`Top`], from [`Top::prepare`]; its methods are the kernels of each step.
#[allow(non_snake_case)]
#[derive(
    ::core::clone::Clone,
    ::core::marker::Copy,
    ::core::fmt::Debug,
    ::core::cmp::PartialEq
)]
pub struct TopPrepared<S = ::core::primitive::f64> {
    C: S,
    A: S,
    l: S,
    k: S,
    inertia_about_pivot: S,
    k_2: S,
    k_3: S,
    g: S,
    k_4: S,
    k_5: S,
    k_6: S,
    k_7: S,
    k_8: S,
    inverse_theta: S,
    k_9: S,
}
#[allow(non_snake_case, unused_variables, unused_parens, clippy::all, clippy::pedantic)]
impl<S: sim_kernel::Scalar> Top<S> {
    /// What the equations of motion need of the parameters, computed once for a set of parameters.
    ///
    /// Operations: 9 additions, 8 multiplications, 1 division.
    #[inline]
    pub fn prepare(&self) -> TopPrepared<S> {
        let l_squared = self.l * self.l;
        let w = self.m * l_squared;
        let inertia_about_pivot = self.A + w;
        let w_2 = self.m * self.l;
        let w_3 = self.C * S::from_f64(2.0);
        TopPrepared {
            C: self.C,
            A: self.A,
            l: self.l,
            k: w,
            inertia_about_pivot: inertia_about_pivot,
            k_2: self.C - self.A,
            k_3: self.A - self.C,
            g: self.g,
            k_4: w_2,
            k_5: w_3,
            k_6: w_3 - self.A * S::from_f64(2.0) - self.m * l_squared * S::from_f64(2.0),
            k_7: self.g * w_2,
            k_8: self.A - self.C + w,
            inverse_theta: S::from_f64(1.0) / inertia_about_pivot,
            k_9: self.C - self.A - w,
        }
    }
    /// Mass matrix `T_q' M T_q`, 3 x 3, symmetric, in SI units.
    ///
    /// Operations: 2 additions, 7 multiplications, 1 sine-cosine pair.
    #[inline]
    pub fn mass_matrix(&self, t: S, q: &[S; 3]) -> [[S; 3]; 3] {
        let [_, theta, _] = *q;
        let ([sin_theta], [cos_theta]) = S::sin_cos_each([theta]);
        let inertia_about_pivot = self.A + self.m * self.l * self.l;
        let mass_phi_psi = self.C * cos_theta;
        [
            [
                self.C * cos_theta * cos_theta
                    + sin_theta * sin_theta * inertia_about_pivot,
                S::from_f64(0.0),
                mass_phi_psi,
            ],
            [S::from_f64(0.0), inertia_about_pivot, S::from_f64(0.0)],
            [mass_phi_psi, S::from_f64(0.0), self.C],
        ]
    }
    /// Convective forces `T_q' M g`, 3, with `g = (T_q q' + T_t)_q q' + (..)_t`: joules per unit of each coordinate.
    ///
    /// Operations: 7 additions, 19 multiplications, 1 sine-cosine pair.
    #[inline]
    pub fn convective_forces(&self, t: S, q: &[S; 3], qd: &[S; 3]) -> [S; 3] {
        let [_, theta, _] = *q;
        let [psi_dot, theta_dot, phi_dot] = *qd;
        let ([sin_theta], [cos_theta]) = S::sin_cos_each([theta]);
        let l_squared = self.l * self.l;
        let w = self.C * psi_dot;
        [
            sin_theta * theta_dot
                * (psi_dot * cos_theta
                    * (self.A * S::from_f64(2.0) - self.C * S::from_f64(2.0)
                        + self.m * l_squared * S::from_f64(2.0)) - self.C * phi_dot),
            sin_theta
                * (cos_theta * psi_dot * psi_dot * (self.C - self.A - self.m * l_squared)
                    + phi_dot * w),
            -(sin_theta * theta_dot * w),
        ]
    }
    /// Generalised forces `T_q' F`, 3: joules per unit of each coordinate.
    ///
    /// Operations: 3 multiplications, 1 sine-cosine pair.
    #[inline]
    pub fn generalized_forces(&self, t: S, q: &[S; 3], qd: &[S; 3]) -> [S; 3] {
        let [_, theta, _] = *q;
        let ([sin_theta], [_]) = S::sin_cos_each([theta]);
        [S::from_f64(0.0), sin_theta * self.m * self.l * self.g, S::from_f64(0.0)]
    }
    /// Constraints `C`, 0, in SI units; zero throughout the motion.
    ///
    /// Operations: none.
    #[inline]
    pub fn constraints(&self, t: S, q: &[S; 3]) -> [S; 0] {
        []
    }
    /// The sum of the magnitudes of the terms of `C`, 0, in SI units: what its rounding is relative to.
    ///
    /// Operations: none.
    #[inline]
    pub fn constraint_magnitudes(&self, t: S, q: &[S; 3]) -> [S; 0] {
        []
    }
    /// Constraint Jacobian `C_q`, 0 x 3: units of each constraint per unit of each coordinate.
    ///
    /// Operations: none.
    #[inline]
    pub fn constraint_jacobian(&self, t: S, q: &[S; 3]) -> [[S; 3]; 0] {
        []
    }
    /// `C_t`, 0, units of `C` per second: the speeds obey `C_q q' + C_t = 0`.
    ///
    /// Operations: none.
    #[inline]
    pub fn constraint_time_derivative(&self, t: S, q: &[S; 3]) -> [S; 0] {
        []
    }
    /// `(C_q q' + C_t)_q q' + (..)_t`, 0, units of `C` per second squared: the part of `C''` without accelerations.
    ///
    /// Operations: none.
    #[inline]
    pub fn constraint_convective(&self, t: S, q: &[S; 3], qd: &[S; 3]) -> [S; 0] {
        []
    }
    /// `C` (0), `C_q` (0 x 3) and `C_t` (0) together, in SI units, for projection.
    ///
    /// Operations: none.
    #[inline]
    pub fn constraint_linearization(
        &self,
        t: S,
        q: &[S; 3],
    ) -> sim_kernel::ConstraintLinearization<[S; 0], [[S; 3]; 0]> {
        sim_kernel::ConstraintLinearization {
            values: [],
            jacobian: [],
            time_derivative: [],
        }
    }
    /// Kinetic energy `v' M v / 2`, in joules.
    ///
    /// Operations: 6 additions, 16 multiplications, 2 sine-cosine pairs.
    #[inline]
    pub fn kinetic_energy(&self, t: S, q: &[S; 3], qd: &[S; 3]) -> S {
        let [_, theta, phi] = *q;
        let [psi_dot, theta_dot, phi_dot] = *qd;
        let ([sin_phi, sin_theta], [cos_phi, cos_theta]) = S::sin_cos_each([phi, theta]);
        let w = psi_dot * sin_theta;
        let w_2 = theta_dot * cos_phi + sin_phi * w;
        let w_3 = cos_phi * w - theta_dot * sin_phi;
        let w_4 = phi_dot + psi_dot * cos_theta;
        (S::from_f64(0.5) * self.A + S::from_f64(0.5) * self.m * self.l * self.l)
            * (w_2 * w_2 + w_3 * w_3) + w_4 * w_4 * S::from_f64(0.5) * self.C
    }
    /// Power of loads and drives, `F' v + lambda' C_t + T_t' (M x'' - F)`, in watts.
    ///
    /// Operations: 4 multiplications, 1 sine-cosine pair.
    #[inline]
    pub fn power(
        &self,
        t: S,
        q: &[S; 3],
        qd: &[S; 3],
        qdd: &[S; 3],
        lambda: &[S; 0],
    ) -> S {
        let [_, theta, _] = *q;
        let [_, theta_dot, _] = *qd;
        let ([sin_theta], [_]) = S::sin_cos_each([theta]);
        sin_theta * theta_dot * self.m * self.l * self.g
    }
    /// Outputs, 4, in SI units.
    ///
    /// Operations: 1 addition, 2 multiplications, 1 sine-cosine pair.
    #[inline]
    pub fn outputs(
        &self,
        t: S,
        q: &[S; 3],
        qd: &[S; 3],
        qdd: &[S; 3],
        lambda: &[S; 0],
    ) -> TopOutputs<S> {
        let [_, theta, _] = *q;
        let [psi_dot, _, phi_dot] = *qd;
        let ([_], [cos_theta]) = S::sin_cos_each([theta]);
        [psi_dot, theta, phi_dot + psi_dot * cos_theta, cos_theta * self.l].into()
    }
    /// Rates of the outputs that depend on neither accelerations nor multipliers, 4, in SI units per second.
    ///
    /// Operations: 3 additions, 5 multiplications, 1 sine-cosine pair.
    #[inline]
    pub fn output_rates(
        &self,
        t: S,
        q: &[S; 3],
        qd: &[S; 3],
        qdd: &[S; 3],
    ) -> TopOutputRates<S> {
        let [_, theta, _] = *q;
        let [psi_dot, theta_dot, _] = *qd;
        let [psi_ddot, _, phi_ddot] = *qdd;
        let ([sin_theta], [cos_theta]) = S::sin_cos_each([theta]);
        [
            psi_ddot,
            theta_dot,
            phi_ddot - theta_dot * psi_dot * sin_theta + psi_ddot * cos_theta,
            -(theta_dot * sin_theta * self.l),
        ]
            .into()
    }
    /// `left - right` of each event, 1, in SI units: zero when it happens.
    ///
    /// Operations: 1 multiplication, 1 sine-cosine pair.
    #[inline]
    pub fn events(
        &self,
        t: S,
        q: &[S; 3],
        qd: &[S; 3],
        qdd: &[S; 3],
        lambda: &[S; 0],
    ) -> [S; 1] {
        let [psi, _, _] = *q;
        let ([w], [_]) = S::sin_cos_each([S::from_f64(0.5) * psi]);
        [w]
    }
    /// The numbers of each shape of the drawing, in metres and radians.
    ///
    /// Operations: 8 additions, 19 multiplications, 3 sine-cosine pairs.
    #[inline]
    pub fn drawing(&self, t: S, q: &[S; 3]) -> [S; 22] {
        let [psi, theta, phi] = *q;
        let w = S::from_f64(2.0) * self.l;
        let ([sin_psi, sin_theta, sin_phi], [cos_psi, cos_theta, cos_phi]) = S::sin_cos_each([
            psi,
            theta,
            phi,
        ]);
        let w_2 = sin_psi * sin_theta;
        let w_3 = sin_theta * cos_psi;
        let w_4 = self.l * w_2;
        let w_5 = self.l * w_3;
        let w_6 = -w_5;
        let w_7 = self.l * cos_theta;
        let w_8 = self.l * S::from_f64(0.8);
        let w_9 = cos_theta * sin_phi;
        [
            S::from_f64(0.0),
            S::from_f64(0.0),
            S::from_f64(0.0),
            S::from_f64(0.0),
            S::from_f64(0.0),
            S::from_f64(0.0),
            w * w_2,
            -(w * w_3),
            w * cos_theta,
            w_4,
            w_6,
            w_7,
            w_8,
            w_2,
            -w_3,
            cos_theta,
            w_4,
            w_6,
            w_7,
            w_4 + w_8 * (cos_psi * cos_phi - sin_psi * w_9),
            w_8 * (sin_psi * cos_phi + cos_psi * w_9) - w_5,
            w_7 + sin_theta * w_8 * sin_phi,
        ]
    }
    /// Declared start: values or guesses of the coordinates (3), and speeds (3), in SI units; 0 where nothing is declared.
    ///
    /// Operations: 4 additions, 15 multiplications, 2 divisions, 1 sine-cosine pair, 1 square root.
    #[inline]
    pub fn initial(&self) -> sim_kernel::Initial<[S; 3]> {
        let inertia_about_pivot = self.A + self.m * self.l * self.l;
        let ([_], [cos_theta0]) = S::sin_cos_each([self.theta0]);
        let w = self.C * self.spin
            - (self.C * self.C * self.spin * self.spin
                - self.m * self.l * inertia_about_pivot * cos_theta0 * S::from_f64(4.0)
                    * self.g)
                .sqrt();
        let w_2 = inertia_about_pivot * cos_theta0;
        sim_kernel::Initial {
            positions: [S::from_f64(0.0), self.theta0, S::from_f64(0.0)],
            speeds: [
                S::from_f64(0.5) * w / w_2,
                self.nod,
                self.spin - S::from_f64(0.5) * cos_theta0 * w / w_2,
            ],
        }
    }
    /// [`TopPrepared::dynamics`] once; for many calls with the same parameters [`Self::prepare`] first.
    #[inline]
    pub fn dynamics(
        &self,
        t: S,
        q: &[S; 3],
        qd: &[S; 3],
    ) -> sim_kernel::Dynamics<S, [S; 3], [S; 0]> {
        self.prepare().dynamics(t, q, qd)
    }
    /// [`TopPrepared::dynamics_jacobian`] once; for many calls with the same parameters [`Self::prepare`] first.
    #[inline]
    pub fn dynamics_jacobian(
        &self,
        t: S,
        q: &[S; 3],
        qd: &[S; 3],
    ) -> sim_kernel::DynamicsJacobian<S, [[S; 3]; 3], [[S; 3]; 0]> {
        self.prepare().dynamics_jacobian(t, q, qd)
    }
}
#[allow(non_snake_case, unused_variables, unused_parens, clippy::all, clippy::pedantic)]
impl<S: sim_kernel::Scalar> TopPrepared<S> {
    /// Accelerations (3), multipliers (0) and power, from
    ///
    /// ```text
    /// [ T_q' M T_q   C_q' ] [ q''    ]   [ T_q' (F - M g)                      ]
    /// [ C_q          0    ] [ lambda ] = [ -(C_q q' + C_t)_q q' - (..)_t       ]
    /// ```
    ///
    /// by an elimination planned from the structure of the system. Where `refused` is set a pivot was too small and nothing else holds: solve that state from the other kernels.
    ///
    /// Operations: 7 additions, 27 multiplications, 2 divisions, 1 sine-cosine pair.
    #[inline(always)]
    pub fn dynamics(
        &self,
        t: S,
        q: &[S; 3],
        qd: &[S; 3],
    ) -> sim_kernel::Dynamics<S, [S; 3], [S; 0]> {
        let [_, theta, _] = *q;
        let [psi_dot, theta_dot, phi_dot] = *qd;
        let ([sin_theta], [cos_theta]) = S::sin_cos_each([theta]);
        let rhs_psi = sin_theta * theta_dot
            * (cos_theta * psi_dot * self.k_6 + self.C * phi_dot);
        let w = self.C * psi_dot;
        let mass_phi_psi = self.C * cos_theta;
        let mass_psi_psi = self.C * cos_theta * cos_theta
            + sin_theta * sin_theta * self.inertia_about_pivot;
        let inverse_psi = S::from_f64(1.0) / mass_psi_psi;
        let l_phi_psi = mass_phi_psi * inverse_psi;
        let pivot_phi = self.C - mass_phi_psi * l_phi_psi;
        let phi_ddot = S::from_f64(1.0) / pivot_phi
            * (sin_theta * theta_dot * w - rhs_psi * l_phi_psi);
        sim_kernel::Dynamics {
            accelerations: [
                rhs_psi * inverse_psi - l_phi_psi * phi_ddot,
                sin_theta
                    * (self.k_7 + cos_theta * psi_dot * psi_dot * self.k_8 - phi_dot * w)
                    * self.inverse_theta,
                phi_ddot,
            ],
            multipliers: [],
            power: sin_theta * theta_dot * self.k_7,
            refused: sim_kernel::pivot_is_refused(mass_psi_psi, mass_psi_psi)
                | sim_kernel::pivot_is_refused(
                    self.inertia_about_pivot,
                    self.inertia_about_pivot,
                ) | sim_kernel::pivot_is_refused(pivot_phi, self.C),
        }
    }
    /// The derivatives of accelerations (3 rows) and multipliers (0 rows) with respect to coordinates and speeds (3 columns each): with the equations of motion as `K z = r`, the solutions of `K dz = dr - dK z`. Where `refused` is set a pivot was too small and nothing else holds.
    ///
    /// Operations: 78 additions, 158 multiplications, 2 divisions, 2 sine-cosine pairs.
    #[inline]
    pub fn dynamics_jacobian(
        &self,
        t: S,
        q: &[S; 3],
        qd: &[S; 3],
    ) -> sim_kernel::DynamicsJacobian<S, [[S; 3]; 3], [[S; 3]; 0]> {
        let [_, theta, phi] = *q;
        let [psi_dot, theta_dot, phi_dot] = *qd;
        let ([sin_theta, sin_phi], [cos_theta, cos_phi]) = S::sin_cos_each([theta, phi]);
        let w = cos_theta * psi_dot;
        let rhs_psi = sin_theta * theta_dot * (w * self.k_6 + self.C * phi_dot);
        let w_2 = psi_dot * theta_dot;
        let w_3 = self.C * sin_theta;
        let mass_phi_psi = self.C * cos_theta;
        let sin_theta_squared = sin_theta * sin_theta;
        let mass_psi_psi = self.C * cos_theta * cos_theta
            + sin_theta_squared * self.inertia_about_pivot;
        let inverse_psi = S::from_f64(1.0) / mass_psi_psi;
        let l_phi_psi = mass_phi_psi * inverse_psi;
        let w_4 = cos_theta * cos_phi;
        let w_5 = sin_theta * sin_phi;
        let w_6 = phi_dot * w_4 - theta_dot * w_5;
        let w_7 = phi_dot + w;
        let w_8 = sin_theta * cos_phi;
        let w_9 = sin_phi * theta_dot;
        let w_10 = psi_dot * w_8 - w_9;
        let w_11 = sin_theta * w_10;
        let w_12 = self.k_4
            * (w_4 * self.g - self.l * psi_dot * (w_6 - w_7 * w_4 + w_11));
        let w_13 = w_7 * self.k_2;
        let w_14 = w_12
            - (psi_dot * (w_13 * w_4 + self.k_3 * w_11) + self.A * psi_dot * w_6);
        let w_15 = cos_theta * sin_phi;
        let w_16 = w_7 * self.k_3;
        let w_17 = cos_phi * theta_dot;
        let w_18 = w_17 + psi_dot * w_5;
        let w_19 = sin_theta * w_18;
        let w_20 = phi_dot * w_15 + theta_dot * w_8;
        let w_21 = self.k_4
            * (w_15 * self.g - self.l * psi_dot * (w_20 - w_7 * w_15 + w_19));
        let w_22 = psi_dot * (w_15 * w_16 + self.k_2 * w_19) - self.A * psi_dot * w_20
            + w_21;
        let pivot_phi = self.C - mass_phi_psi * l_phi_psi;
        let inverse_phi = S::from_f64(1.0) / pivot_phi;
        let phi_ddot = inverse_phi * (w_2 * w_3 - rhs_psi * l_phi_psi);
        let psi_ddot = rhs_psi * inverse_psi - l_phi_psi * phi_ddot;
        let w_23 = w_15 * w_2;
        let w_25 = w_2 * w_4;
        let w_24 = phi_dot - w_7;
        let w_26 = cos_phi
            * (w_18 * w_16 - self.A * (phi_dot * w_18 - w_25)
                + (w_5 * self.g - self.l * (w_18 * w_24 - w_25)) * self.k_4);
        let w_27 = cos_theta
            * (sin_phi
                * ((w_8 * self.g - self.l * (w_23 + w_10 * w_24)) * self.k_4
                    - (w_10 * w_13 + self.A * (w_10 * phi_dot + w_23))) - w_26);
        let w_28 = sin_theta * (sin_phi * w_14 - cos_phi * w_22 + self.C * phi_ddot)
            + w_27 + psi_dot * theta_dot * (self.C - sin_theta_squared * self.k_5)
            + S::from_f64(2.0) * psi_ddot * cos_theta * sin_theta * self.k_9;
        let w_29 = inverse_phi
            * (self.C * (theta_dot * w + sin_theta * psi_ddot) - l_phi_psi * w_28);
        let w_31 = self.k_2 * (w_8 * w_7 + cos_theta * w_10)
            + self.A * (w_8 * phi_dot + theta_dot * w_15)
            + self.k * (cos_theta * (w_9 - w_10) + w_8 * w_24);
        let w_30 = self.k * (w_5 * w_24 - cos_theta * (w_17 + w_18))
            - (self.k_3 * (w_7 * w_5 + cos_theta * w_18)
                - self.A * (phi_dot * w_5 - theta_dot * w_4));
        let w_32 = sin_theta
            * (cos_phi * w_30 - sin_phi * w_31 + mass_phi_psi * theta_dot);
        let w_33 = inverse_phi * (theta_dot * w_3 - l_phi_psi * w_32);
        let w_34 = w - phi_dot;
        let w_35 = w_7 + w_34;
        let w_36 = sin_phi * w_13 - self.A * sin_phi * w_34 - self.k * sin_phi * w_35;
        let w_37 = cos_phi * w_16 + self.A * cos_phi * w_34 + self.k * cos_phi * w_35;
        let w_38 = sin_theta * (sin_phi * w_36 - cos_phi * w_37 + self.C * w);
        let w_39 = inverse_phi * (psi_dot * w_3 - l_phi_psi * w_38);
        let w_40 = w_3 * (cos_phi * w_18 - sin_phi * w_10);
        let w_41 = inverse_phi * l_phi_psi * w_40;
        sim_kernel::DynamicsJacobian {
            accelerations_by_positions: [
                [
                    S::from_f64(0.0),
                    inverse_psi * w_28 - l_phi_psi * w_29,
                    S::from_f64(0.0),
                ],
                [
                    S::from_f64(0.0),
                    self.inverse_theta * (cos_phi * w_14 + sin_phi * w_22),
                    S::from_f64(0.0),
                ],
                [S::from_f64(0.0), w_29, S::from_f64(0.0)],
            ],
            accelerations_by_speeds: [
                [
                    inverse_psi * w_32 - l_phi_psi * w_33,
                    inverse_psi * w_38 - l_phi_psi * w_39,
                    inverse_psi * w_40 + l_phi_psi * w_41,
                ],
                [
                    -(self.inverse_theta * (cos_phi * w_31 + sin_phi * w_30)),
                    self.inverse_theta * (cos_phi * w_36 + sin_phi * w_37),
                    -(self.inverse_theta * self.C * (cos_phi * w_10 + sin_phi * w_18)),
                ],
                [w_33, w_39, -w_41],
            ],
            multipliers_by_positions: [],
            multipliers_by_speeds: [],
            refused: sim_kernel::pivot_is_refused(mass_psi_psi, mass_psi_psi)
                | sim_kernel::pivot_is_refused(
                    self.inertia_about_pivot,
                    self.inertia_about_pivot,
                ) | sim_kernel::pivot_is_refused(pivot_phi, self.C),
        }
    }
}
#[allow(non_snake_case, unused_variables, clippy::all, clippy::pedantic)]
impl<S: sim_kernel::Scalar> sim_kernel::Mechanism<S> for Top<S> {
    type Q = [S; 3];
    type L = [S; 0];
    type Z = [S; 3];
    type QQ = [[S; 3]; 3];
    type V = [S; 0];
    type VV = [[S; 0]; 0];
    type LQ = [[S; 3]; 0];
    type LL = [[S; 0]; 0];
    type ZZ = [[S; 3]; 3];
    type Entries = [S; 0];
    type Envelope = [S; 0];
    type Parameters = [S; 8];
    type Outputs = [S; 4];
    type OutputRates = [S; 4];
    type Events = [S; 1];
    type EventValues = [S; 0];
    type SwitchingFunctions = [S; 0];
    type LoadConditions = [S; 0];
    type Activities = [S; 0];
    type Drawing = [S; 22];
    type QP = [[S; 8]; 3];
    type LP = [[S; 8]; 0];
    type Inputs = [sim_kernel::Input<S>; 0];
    type Prepared = TopPrepared<S>;
    type On<T: sim_kernel::Scalar> = Top<T>;
    #[inline(always)]
    fn description(&self) -> &'static sim_kernel::Description {
        const { &<Self as sim_kernel::Compiled<S>>::DESCRIPTION }
    }
    fn as_declared(&self) -> Self {
        <Self as sim_kernel::Compiled<S>>::defaults()
    }
    fn parameters(&self) -> [S; 8] {
        [self.m, self.l, self.A, self.C, self.g, self.theta0, self.spin, self.nod]
    }
    fn with_parameters(&self, parameters: [S; 8]) -> Self {
        Self {
            m: parameters[0],
            l: parameters[1],
            A: parameters[2],
            C: parameters[3],
            g: parameters[4],
            theta0: parameters[5],
            spin: parameters[6],
            nod: parameters[7],
            ..*self
        }
    }
    fn on<T: sim_kernel::Scalar>(
        &self,
        convert: impl ::core::ops::Fn(S) -> T,
    ) -> Top<T> {
        Top {
            m: convert(self.m),
            l: convert(self.l),
            A: convert(self.A),
            C: convert(self.C),
            g: convert(self.g),
            theta0: convert(self.theta0),
            spin: convert(self.spin),
            nod: convert(self.nod),
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
    fn prepare(&self) -> TopPrepared<S> {
        self.prepare()
    }
    #[inline(always)]
    fn prepared_dynamics(
        prepared: &Self::Prepared,
        t: S,
        q: &[S; 3],
        qd: &[S; 3],
    ) -> sim_kernel::Dynamics<S, [S; 3], [S; 0]> {
        prepared.dynamics(t, q, qd)
    }
    #[inline(always)]
    fn dynamics_jacobian(
        &self,
        t: S,
        q: &[S; 3],
        qd: &[S; 3],
    ) -> sim_kernel::DynamicsJacobian<S, [[S; 3]; 3], [[S; 3]; 0]> {
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
    fn constraints(&self, t: S, q: &[S; 3]) -> [S; 0] {
        self.constraints(t, q)
    }
    #[inline(always)]
    fn constraint_magnitudes(&self, t: S, q: &[S; 3]) -> [S; 0] {
        self.constraint_magnitudes(t, q)
    }
    #[inline(always)]
    fn constraint_jacobian(&self, t: S, q: &[S; 3]) -> [[S; 3]; 0] {
        self.constraint_jacobian(t, q)
    }
    #[inline(always)]
    fn constraint_time_derivative(&self, t: S, q: &[S; 3]) -> [S; 0] {
        self.constraint_time_derivative(t, q)
    }
    #[inline(always)]
    fn constraint_convective(&self, t: S, q: &[S; 3], qd: &[S; 3]) -> [S; 0] {
        self.constraint_convective(t, q, qd)
    }
    #[inline(always)]
    fn constraint_linearization(
        &self,
        t: S,
        q: &[S; 3],
    ) -> sim_kernel::ConstraintLinearization<[S; 0], [[S; 3]; 0]> {
        self.constraint_linearization(t, q)
    }
    #[inline(always)]
    fn kinetic_energy(&self, t: S, q: &[S; 3], qd: &[S; 3]) -> S {
        self.kinetic_energy(t, q, qd)
    }
    #[inline(always)]
    fn power(&self, t: S, q: &[S; 3], qd: &[S; 3], qdd: &[S; 3], lambda: &[S; 0]) -> S {
        self.power(t, q, qd, qdd, lambda)
    }
    #[inline(always)]
    fn outputs(
        &self,
        t: S,
        q: &[S; 3],
        qd: &[S; 3],
        qdd: &[S; 3],
        lambda: &[S; 0],
    ) -> [S; 4] {
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
        lambda: &[S; 0],
    ) -> [S; 1] {
        self.events(t, q, qd, qdd, lambda)
    }
    #[inline(always)]
    fn drawing(&self, t: S, q: &[S; 3]) -> [S; 22] {
        self.drawing(t, q)
    }
    #[inline(always)]
    fn initial(&self) -> sim_kernel::Initial<[S; 3]> {
        self.initial()
    }
}
#[allow(clippy::all, clippy::pedantic)]
impl<S: sim_kernel::Scalar> sim_kernel::Compiled<S> for Top<S> {
    const DESCRIPTION: sim_kernel::Description = sim_kernel::Description {
        name: "top",
        type_name: "Top",
        docs: "A heavy symmetric top on a fixed point that precesses and, unless `nod` is 0, nods.",
        declaration: "/// A heavy symmetric top on a fixed point that precesses and, unless `nod` is 0, nods.\npub Top;\n\ncoordinates {\n    /// Precession about the vertical.\n    psi [rad];\n    /// Nutation from the vertical.\n    theta [rad];\n    /// Spin about its own axis.\n    phi [rad];\n}\n\nparameters {\n    m [kg] = 0.5;\n    /// Distance of the centre of mass from the point it stands on.\n    l [m] = 0.04;\n    /// Moment of inertia across the axis, about the centre of mass.\n    A [kg*m^2] = 3e-4;\n    /// And about the axis.\n    C [kg*m^2] = 5e-4;\n    g [m/s^2] = 9.81;\n    /// Nutation.\n    theta0 [deg] = 30;\n    /// Angular velocity along the axis.\n    spin [rad/s] = 150;\n    /// Speed of nutation at the start.\n    nod [rad/s] = 0.5;\n}\n\nlet R = euler(zxz, psi, theta, phi);\nlet inertia_about_pivot = A + m*l^2;\nlet discriminant = (C*spin)^2 - 4*inertia_about_pivot*cos(theta0)*m*g*l;\nlet steady = (C*spin - sqrt(discriminant))/(2*inertia_about_pivot*cos(theta0));\n\nbodies { top: mass m at R*[0, 0, l], inertia [A, A, C], attitude R; }\nloads { gravity [0, 0, -g]; }\n\ninitial {\n    psi = 0;\n    theta = theta0;\n    phi = 0;\n    dot(psi) = steady;\n    dot(theta) = nod;\n    dot(phi) = spin - steady*cos(theta0);\n}\n\nevents { period: sin(psi/2) = 0; }\n\noutputs {\n    /// rate of precession\n    precession [rad/s] = dot(psi);\n    /// nutation\n    nutation [deg] = theta;\n    /// angular velocity along the axis\n    own_spin [rad/s] = (transpose(R)*omega(top)).z;\n    /// height of the centre of mass\n    height [m] = on(top, [0, 0, 0]).z;\n}\n\ndrawing {\n    ground [0, 0, 0];\n    line [0, 0, 0], on(top, [0, 0, l]);\n    circle on(top, [0, 0, 0]) radius 0.8*l normal R*[0, 0, 1];\n    line on(top, [0, 0, 0]), on(top, [0.8*l, 0, 0]);\n}\n",
        declaration_hash: "0f8bfb5f0836e0558defae908ea84083",
        coordinates: &[
            sim_kernel::Coordinate {
                position: sim_kernel::Quantity {
                    name: "psi",
                    unit: "rad",
                    factor: 1f64,
                    is_length: false,
                    docs: "Precession about the vertical.",
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
                speed_given: true,
            },
            sim_kernel::Coordinate {
                position: sim_kernel::Quantity {
                    name: "theta",
                    unit: "rad",
                    factor: 1f64,
                    is_length: false,
                    docs: "Nutation from the vertical.",
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
                    docs: "Spin about its own axis.",
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
                start: sim_kernel::Start::Given,
                speed_given: true,
            },
        ],
        mixes_lengths: false,
        parameters: &[
            sim_kernel::Quantity {
                name: "m",
                unit: "kg",
                factor: 1f64,
                is_length: false,
                docs: "",
            },
            sim_kernel::Quantity {
                name: "l",
                unit: "m",
                factor: 1f64,
                is_length: true,
                docs: "Distance of the centre of mass from the point it stands on.",
            },
            sim_kernel::Quantity {
                name: "A",
                unit: "kg*m^2",
                factor: 1f64,
                is_length: false,
                docs: "Moment of inertia across the axis, about the centre of mass.",
            },
            sim_kernel::Quantity {
                name: "C",
                unit: "kg*m^2",
                factor: 1f64,
                is_length: false,
                docs: "And about the axis.",
            },
            sim_kernel::Quantity {
                name: "g",
                unit: "m/s^2",
                factor: 1f64,
                is_length: false,
                docs: "",
            },
            sim_kernel::Quantity {
                name: "theta0",
                unit: "deg",
                factor: 0.017453292519943295f64,
                is_length: false,
                docs: "Nutation.",
            },
            sim_kernel::Quantity {
                name: "spin",
                unit: "rad/s",
                factor: 1f64,
                is_length: false,
                docs: "Angular velocity along the axis.",
            },
            sim_kernel::Quantity {
                name: "nod",
                unit: "rad/s",
                factor: 1f64,
                is_length: false,
                docs: "Speed of nutation at the start.",
            },
        ],
        inputs: &[],
        constraints: &[],
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
                name: "precession",
                unit: "rad/s",
                factor: 1f64,
                is_length: false,
                docs: "rate of precession",
            },
            sim_kernel::Quantity {
                name: "nutation",
                unit: "deg",
                factor: 0.017453292519943295f64,
                is_length: false,
                docs: "nutation",
            },
            sim_kernel::Quantity {
                name: "own_spin",
                unit: "rad/s",
                factor: 1f64,
                is_length: false,
                docs: "angular velocity along the axis",
            },
            sim_kernel::Quantity {
                name: "height",
                unit: "m",
                factor: 1f64,
                is_length: true,
                docs: "height of the centre of mass",
            },
        ],
        rated_outputs: &[0, 1, 2, 3],
        figures: &[
            sim_kernel::Figure {
                name: "precession",
                title: "rate of precession",
                len: 1,
            },
            sim_kernel::Figure {
                name: "nutation",
                title: "nutation",
                len: 1,
            },
            sim_kernel::Figure {
                name: "own_spin",
                title: "angular velocity along the axis",
                len: 1,
            },
            sim_kernel::Figure {
                name: "height",
                title: "height of the centre of mass",
                len: 1,
            },
        ],
        optional_kernels: &["dynamics_jacobian"],
        dimension: 3,
        drawing: &[
            sim_kernel::Shape::Ground(1),
            sim_kernel::Shape::Line(2),
            sim_kernel::Shape::Circle,
            sim_kernel::Shape::Line(2),
        ],
        run: &[],
        switching: &[],
        load_conditions: &[],
    };
    fn defaults() -> Self {
        Self {
            m: S::from_f64(0.5f64),
            l: S::from_f64(0.04f64),
            A: S::from_f64(0.0003f64),
            C: S::from_f64(0.0005f64),
            g: S::from_f64(9.81f64),
            theta0: S::from_f64(0.5235987755982988f64),
            spin: S::from_f64(150f64),
            nod: S::from_f64(0.5f64),
        }
    }
}
