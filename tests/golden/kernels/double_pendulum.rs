/// Two equal slender bars, let go from the horizontal.
///
/// The fields are its parameters, in SI units; the methods are its kernels.
///
/// # Equations of motion
///
/// ```text
/// mass_matrix * accelerations = generalized_forces - convective_forces
/// coordinates = [phi1; phi2]
/// [
///     4*l^3*rho*width*thickness/3, mass_matrix[1, 2];
///     mass_matrix[1, 2], l^3*rho*width*thickness/3
/// ] * [phi1_ddot; phi2_ddot] = [
///     generalized_forces[1] - convective_forces[1];
///     -l^2*rho*width*thickness*g*v_x/2 - convective_forces[2]
/// ]
///
/// mass_matrix = [
///     4*l^3*rho*width*thickness/3, mass_matrix[1, 2];
///     mass_matrix[1, 2], l^3*rho*width*thickness/3
/// ]
/// mass_matrix[1, 2] = l^3*rho*width*thickness*cos(phi1)*cos(phi2)/2 + l^3*rho*width*thickness*u_x*v_x/2
///
/// convective_forces = [convective_forces[1]; convective_forces[2]]
/// convective_forces[1] = l^2*rho*width*thickness*u_x*s_2/2 - l^2*rho*width*thickness*s_1*cos(phi1)/2
/// convective_forces[2] = l^2*rho*width*thickness*v_x*s_2/4 - l^2*rho*width*thickness*s_1*cos(phi2)/4
///
/// generalized_forces = [
///     generalized_forces[1];
///     -l^2*rho*width*thickness*g*v_x/2
/// ]
/// generalized_forces[1] = -3*l^2*rho*width*thickness*g*u_x/2
///
/// u_x = sin(phi1)
/// v_x = sin(phi2)
/// s_1 = 2*l*u_x*phi1_dot^2 + l*v_x*phi2_dot^2
/// s_2 = 2*l*phi1_dot^2*cos(phi1) + l*phi2_dot^2*cos(phi2)
/// ```
#[allow(non_snake_case)]
#[derive(
    ::core::clone::Clone,
    ::core::marker::Copy,
    ::core::fmt::Debug,
    ::core::cmp::PartialEq
)]
pub struct DoublePendulum<S = ::core::primitive::f64> {
    /// Length of each bar, in `m`.
    pub l: S,
    /// Density of the bars, in `kg/m^3`.
    pub rho: S,
    /// Width of the bars, in `m`.
    pub width: S,
    /// Thickness of the bars, in `m`.
    pub thickness: S,
    /// In `m/s^2`.
    pub g: S,
}
impl<S: sim_kernel::Scalar> ::core::default::Default for DoublePendulum<S> {
    /// The declared values.
    fn default() -> Self {
        <Self as sim_kernel::Mechanism<S>>::defaults()
    }
}
/// Coordinates of [`DoublePendulum`] by name, in SI units; also for their speeds and accelerations.
#[allow(non_snake_case)]
#[derive(
    ::core::clone::Clone,
    ::core::marker::Copy,
    ::core::fmt::Debug,
    ::core::cmp::PartialEq
)]
pub struct DoublePendulumCoordinates<S = ::core::primitive::f64> {
    /// Angle of the upper bar from the vertical, in `rad`.
    pub phi1: S,
    /// Angle of the lower bar from the vertical, in `rad`.
    pub phi2: S,
}
impl<S: sim_kernel::Scalar> ::core::convert::From<[S; 2]>
for DoublePendulumCoordinates<S> {
    fn from(values: [S; 2]) -> Self {
        Self {
            phi1: values[0],
            phi2: values[1],
        }
    }
}
impl<S: sim_kernel::Scalar> ::core::convert::From<DoublePendulumCoordinates<S>>
for [S; 2] {
    fn from(record: DoublePendulumCoordinates<S>) -> Self {
        [record.phi1, record.phi2]
    }
}
/// Outputs of [`DoublePendulum`] by name, in SI units.
#[allow(non_snake_case)]
#[derive(
    ::core::clone::Clone,
    ::core::marker::Copy,
    ::core::fmt::Debug,
    ::core::cmp::PartialEq
)]
pub struct DoublePendulumOutputs<S = ::core::primitive::f64> {
    /// upper bar, in `rad`.
    pub upper_angle: S,
    /// lower bar, in `rad`.
    pub lower_angle: S,
    /// speed, in `m/s`.
    pub speed: S,
    /// potential energy, zero at the support, in `J`.
    pub potential: S,
}
impl<S: sim_kernel::Scalar> ::core::convert::From<[S; 4]> for DoublePendulumOutputs<S> {
    fn from(values: [S; 4]) -> Self {
        Self {
            upper_angle: values[0],
            lower_angle: values[1],
            speed: values[2],
            potential: values[3],
        }
    }
}
impl<S: sim_kernel::Scalar> ::core::convert::From<DoublePendulumOutputs<S>> for [S; 4] {
    fn from(record: DoublePendulumOutputs<S>) -> Self {
        [record.upper_angle, record.lower_angle, record.speed, record.potential]
    }
}
/// Rates of the outputs of [`DoublePendulum`] by name, in SI units.
#[allow(non_snake_case)]
#[derive(
    ::core::clone::Clone,
    ::core::marker::Copy,
    ::core::fmt::Debug,
    ::core::cmp::PartialEq
)]
pub struct DoublePendulumOutputRates<S = ::core::primitive::f64> {
    /// Rate of `upper_angle`.
    pub upper_angle: S,
    /// Rate of `lower_angle`.
    pub lower_angle: S,
    /// Rate of `speed`.
    pub speed: S,
    /// Rate of `potential`.
    pub potential: S,
}
impl<S: sim_kernel::Scalar> ::core::convert::From<[S; 4]>
for DoublePendulumOutputRates<S> {
    fn from(values: [S; 4]) -> Self {
        Self {
            upper_angle: values[0],
            lower_angle: values[1],
            speed: values[2],
            potential: values[3],
        }
    }
}
impl<S: sim_kernel::Scalar> ::core::convert::From<DoublePendulumOutputRates<S>>
for [S; 4] {
    fn from(record: DoublePendulumOutputRates<S>) -> Self {
        [record.upper_angle, record.lower_angle, record.speed, record.potential]
    }
}
/// What the equations of motion need of the parameters of [`DoublePendulum`], from [`DoublePendulum::prepare`]; its methods are the kernels of each step.
#[allow(non_snake_case)]
#[derive(
    ::core::clone::Clone,
    ::core::marker::Copy,
    ::core::fmt::Debug,
    ::core::cmp::PartialEq
)]
pub struct DoublePendulumPrepared<S = ::core::primitive::f64> {
    l: S,
    mass_phi1_phi1: S,
    k: S,
    mass_phi2_phi2: S,
    k_2: S,
    k_3: S,
    k_4: S,
    k_5: S,
    k_6: S,
    inverse_phi1: S,
    k_7: S,
    k_8: S,
}
#[allow(non_snake_case, unused_variables, unused_parens, clippy::all, clippy::pedantic)]
impl<S: sim_kernel::Scalar> DoublePendulum<S> {
    /// What the equations of motion need of the parameters, computed once for a set of parameters.
    ///
    /// Operations: 16 multiplications, 1 division.
    #[inline]
    pub fn prepare(&self) -> DoublePendulumPrepared<S> {
        let l_squared = self.l * self.l;
        let w = self.thickness * self.rho * self.width;
        let w_2 = self.l * l_squared * w;
        let mass_phi1_phi1 = S::from_f64(1.3333333333333333) * w_2;
        let w_3 = l_squared * w;
        let w_4 = S::from_f64(0.5) * w_3;
        DoublePendulumPrepared {
            l: self.l,
            mass_phi1_phi1: mass_phi1_phi1,
            k: w_2 * S::from_f64(0.5),
            mass_phi2_phi2: w_2 * S::from_f64(0.3333333333333333),
            k_2: self.l * S::from_f64(2.0),
            k_3: w_4,
            k_4: S::from_f64(1.5) * self.g * w_3,
            k_5: w_3 * S::from_f64(0.25),
            k_6: self.g * w_4,
            inverse_phi1: S::from_f64(1.0) / mass_phi1_phi1,
            k_7: w_2,
            k_8: w_2 * S::from_f64(0.25),
        }
    }
    /// Mass matrix `T_q' M T_q`, 2 x 2, symmetric, in SI units.
    ///
    /// Operations: 1 addition, 13 multiplications, 2 sine-cosine pairs.
    #[inline]
    pub fn mass_matrix(&self, t: S, q: &[S; 2]) -> [[S; 2]; 2] {
        let [phi1, phi2] = *q;
        let w = self.l * self.l * self.l * self.rho;
        let w_2 = self.width * self.thickness;
        let ([u_x, v_x], [cos_phi1, cos_phi2]) = S::sin_cos_each([phi1, phi2]);
        let mass_phi2_phi1 = w * w_2 * S::from_f64(0.5)
            * (cos_phi1 * cos_phi2 + u_x * v_x);
        [
            [S::from_f64(1.3333333333333333) * w * w_2, mass_phi2_phi1],
            [mass_phi2_phi1, w * w_2 * S::from_f64(0.3333333333333333)],
        ]
    }
    /// Convective forces `T_q' M g`, 2, with `g = (T_q q' + T_t)_q q' + (..)_t`: joules per unit of each coordinate.
    ///
    /// Operations: 2 additions, 14 multiplications, 2 sine-cosine pairs.
    #[inline]
    pub fn convective_forces(&self, t: S, q: &[S; 2], qd: &[S; 2]) -> [S; 2] {
        let [phi1, phi2] = *q;
        let [phi1_dot, phi2_dot] = *qd;
        let w = S::from_f64(0.5) * self.rho * self.width * self.thickness * self.l
            * self.l * self.l;
        let ([u_x, v_x], [cos_phi1, cos_phi2]) = S::sin_cos_each([phi1, phi2]);
        let w_2 = u_x * cos_phi2 - cos_phi1 * v_x;
        [w * phi2_dot * phi2_dot * w_2, -(phi1_dot * phi1_dot * w * w_2)]
    }
    /// Generalised forces `T_q' F`, 2: joules per unit of each coordinate.
    ///
    /// Operations: 2 additions, 11 multiplications, 2 sine-cosine pairs.
    #[inline]
    pub fn generalized_forces(&self, t: S, q: &[S; 2], qd: &[S; 2]) -> [S; 2] {
        let [phi1, phi2] = *q;
        let ([u_x, v_x], [_, _]) = S::sin_cos_each([phi1, phi2]);
        let w = self.l * self.l * self.rho;
        let w_2 = self.width * self.thickness;
        [
            -(u_x * S::from_f64(1.5) * self.g * w * w_2),
            -(v_x * self.g * w * w_2 * S::from_f64(0.5)),
        ]
    }
    /// Constraints `C`, 0, in SI units; zero throughout the motion.
    ///
    /// Operations: none.
    #[inline]
    pub fn constraints(&self, t: S, q: &[S; 2]) -> [S; 0] {
        []
    }
    /// The sum of the magnitudes of the terms of `C`, 0, in SI units: what its rounding is relative to.
    ///
    /// Operations: none.
    #[inline]
    pub fn constraint_magnitudes(&self, t: S, q: &[S; 2]) -> [S; 0] {
        []
    }
    /// Constraint Jacobian `C_q`, 0 x 2: units of each constraint per unit of each coordinate.
    ///
    /// Operations: none.
    #[inline]
    pub fn constraint_jacobian(&self, t: S, q: &[S; 2]) -> [[S; 2]; 0] {
        []
    }
    /// `C_t`, 0, units of `C` per second: the speeds obey `C_q q' + C_t = 0`.
    ///
    /// Operations: none.
    #[inline]
    pub fn constraint_time_derivative(&self, t: S, q: &[S; 2]) -> [S; 0] {
        []
    }
    /// `(C_q q' + C_t)_q q' + (..)_t`, 0, units of `C` per second squared: the part of `C''` without accelerations.
    ///
    /// Operations: none.
    #[inline]
    pub fn constraint_convective(&self, t: S, q: &[S; 2], qd: &[S; 2]) -> [S; 0] {
        []
    }
    /// `C` (0), `C_q` (0 x 2) and `C_t` (0) together, in SI units, for projection.
    ///
    /// Operations: none.
    #[inline]
    pub fn constraint_linearization(
        &self,
        t: S,
        q: &[S; 2],
    ) -> sim_kernel::ConstraintLinearization<[S; 0], [[S; 2]; 0]> {
        sim_kernel::ConstraintLinearization {
            values: [],
            jacobian: [],
            time_derivative: [],
        }
    }
    /// Kinetic energy `v' M v / 2`, in joules.
    ///
    /// Operations: 5 additions, 26 multiplications, 2 sine-cosine pairs.
    #[inline]
    pub fn kinetic_energy(&self, t: S, q: &[S; 2], qd: &[S; 2]) -> S {
        let [phi1, phi2] = *q;
        let [phi1_dot, phi2_dot] = *qd;
        let w = self.rho * self.width;
        let ([u_x, v_x], [cos_phi1, cos_phi2]) = S::sin_cos_each([phi1, phi2]);
        let w_2 = phi1_dot * self.l * S::from_f64(2.0);
        let w_3 = self.l * phi2_dot;
        let w_4 = cos_phi1 * w_2 + cos_phi2 * w_3;
        let w_5 = w_2 * u_x + w_3 * v_x;
        let w_6 = self.l * self.thickness * S::from_f64(0.125) * w
            * (w_4 * w_4 + w_5 * w_5);
        let w_7 = self.l * self.l * self.l;
        w_6
            + phi1_dot * phi1_dot * S::from_f64(0.16666666666666666) * w_7
                * self.thickness * w
            + phi2_dot * phi2_dot * w_7 * self.thickness
                * S::from_f64(0.041666666666666664) * w
    }
    /// Power of loads and drives, `F' v + lambda' C_t + T_t' (M x'' - F)`, in watts.
    ///
    /// Operations: 2 additions, 13 multiplications, 2 sine-cosine pairs.
    #[inline]
    pub fn power(
        &self,
        t: S,
        q: &[S; 2],
        qd: &[S; 2],
        qdd: &[S; 2],
        lambda: &[S; 0],
    ) -> S {
        let [phi1, phi2] = *q;
        let [phi1_dot, phi2_dot] = *qd;
        let ([u_x, v_x], [_, _]) = S::sin_cos_each([phi1, phi2]);
        let w = self.l * self.l * self.rho;
        let w_2 = self.width * self.thickness;
        -(phi1_dot * u_x * self.g * w * w_2 * S::from_f64(1.5)
            + phi2_dot * v_x * S::from_f64(0.5) * self.g * w * w_2)
    }
    /// Outputs, 4, in SI units.
    ///
    /// Operations: 5 additions, 17 multiplications, 2 sine-cosine pairs, 1 square root.
    #[inline]
    pub fn outputs(
        &self,
        t: S,
        q: &[S; 2],
        qd: &[S; 2],
        qdd: &[S; 2],
        lambda: &[S; 0],
    ) -> DoublePendulumOutputs<S> {
        let [phi1, phi2] = *q;
        let [phi1_dot, phi2_dot] = *qd;
        let ([u_x, v_x], [cos_phi1, cos_phi2]) = S::sin_cos_each([phi1, phi2]);
        let w = self.l * (phi1_dot * cos_phi1 + phi2_dot * cos_phi2);
        let w_2 = self.l * (phi1_dot * u_x + phi2_dot * v_x);
        [
            phi1,
            phi2,
            (w * w + w_2 * w_2).sqrt(),
            -((cos_phi1 * self.l * S::from_f64(3.0) + self.l * cos_phi2) * self.l
                * S::from_f64(0.5) * self.rho * self.width * self.thickness * self.g),
        ]
            .into()
    }
    /// Rates of the outputs that depend on neither accelerations nor multipliers, 4, in SI units per second.
    ///
    /// Operations: 12 additions, 34 multiplications, 1 division, 2 sine-cosine pairs, 1 square root.
    #[inline]
    pub fn output_rates(
        &self,
        t: S,
        q: &[S; 2],
        qd: &[S; 2],
        qdd: &[S; 2],
    ) -> DoublePendulumOutputRates<S> {
        let [phi1, phi2] = *q;
        let [phi1_dot, phi2_dot] = *qd;
        let [phi1_ddot, phi2_ddot] = *qdd;
        let ([u_x, v_x], [cos_phi1, cos_phi2]) = S::sin_cos_each([phi1, phi2]);
        let w = self.l * (phi1_dot * cos_phi1 + phi2_dot * cos_phi2);
        let w_2 = self.l * (phi1_dot * u_x + phi2_dot * v_x);
        let w_3 = w * w + w_2 * w_2;
        let phi1_dot_squared = phi1_dot * phi1_dot;
        let phi2_dot_squared = phi2_dot * phi2_dot;
        let w_4 = w_2 * self.l
            * (cos_phi1 * phi1_dot_squared + cos_phi2 * phi2_dot_squared
                + u_x * phi1_ddot + v_x * phi2_ddot);
        [
            phi1_dot,
            phi2_dot,
            -(w_3.sqrt()
                * (w * self.l
                    * (u_x * phi1_dot_squared + v_x * phi2_dot_squared
                        - cos_phi1 * phi1_ddot - cos_phi2 * phi2_ddot) - w_4) / w_3),
            (phi1_dot * u_x * self.l * S::from_f64(3.0) + phi2_dot * self.l * v_x)
                * self.l * S::from_f64(0.5) * self.rho * self.width * self.thickness
                * self.g,
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
        q: &[S; 2],
        qd: &[S; 2],
        qdd: &[S; 2],
        lambda: &[S; 0],
    ) -> [S; 0] {
        []
    }
    /// The numbers of each shape of the drawing, in metres and radians.
    ///
    /// Operations: 4 additions, 4 multiplications, 2 sine-cosine pairs.
    #[inline]
    pub fn drawing(&self, t: S, q: &[S; 2]) -> [S; 10] {
        let [phi1, phi2] = *q;
        let ([u_x, v_x], [cos_phi1, cos_phi2]) = S::sin_cos_each([phi1, phi2]);
        let elbow_x = self.l * u_x;
        let elbow_y = -(self.l * cos_phi1);
        [
            S::from_f64(0.0),
            S::from_f64(0.0),
            S::from_f64(0.0),
            S::from_f64(0.0),
            elbow_x,
            elbow_y,
            self.l * (u_x + v_x),
            -(self.l * (cos_phi1 + cos_phi2)),
            elbow_x,
            elbow_y,
        ]
    }
    /// Declared start: values or guesses of the coordinates (2), and speeds (2), in SI units; 0 where nothing is declared.
    ///
    /// Operations: 1 multiplication.
    #[inline]
    pub fn initial(&self) -> sim_kernel::Initial<[S; 2]> {
        let w = S::from_f64(0.5) * S::from_f64(::core::f64::consts::PI);
        sim_kernel::Initial {
            positions: [w, w],
            speeds: [S::from_f64(0.0), S::from_f64(0.0)],
        }
    }
    /// [`DoublePendulumPrepared::dynamics`] once; for many calls with the same parameters [`Self::prepare`] first.
    #[inline]
    pub fn dynamics(
        &self,
        t: S,
        q: &[S; 2],
        qd: &[S; 2],
    ) -> sim_kernel::Dynamics<S, [S; 2], [S; 0]> {
        self.prepare().dynamics(t, q, qd)
    }
    /// [`DoublePendulumPrepared::dynamics_jacobian`] once; for many calls with the same parameters [`Self::prepare`] first.
    #[inline]
    pub fn dynamics_jacobian(
        &self,
        t: S,
        q: &[S; 2],
        qd: &[S; 2],
    ) -> sim_kernel::DynamicsJacobian<S, [[S; 2]; 2], [[S; 2]; 0]> {
        self.prepare().dynamics_jacobian(t, q, qd)
    }
}
#[allow(non_snake_case, unused_variables, unused_parens, clippy::all, clippy::pedantic)]
impl<S: sim_kernel::Scalar> DoublePendulumPrepared<S> {
    /// Accelerations (2), multipliers (0) and power, from
    ///
    /// ```text
    /// [ T_q' M T_q   C_q' ] [ q''    ]   [ T_q' (F - M g)                      ]
    /// [ C_q          0    ] [ lambda ] = [ -(C_q q' + C_t)_q q' - (..)_t       ]
    /// ```
    ///
    /// by an elimination planned from the structure of the system. Where `refused` is set a pivot was too small and nothing else holds: solve that state from the other kernels.
    ///
    /// Operations: 10 additions, 25 multiplications, 1 division, 2 sine-cosine pairs.
    #[inline(always)]
    pub fn dynamics(
        &self,
        t: S,
        q: &[S; 2],
        qd: &[S; 2],
    ) -> sim_kernel::Dynamics<S, [S; 2], [S; 0]> {
        let [phi1, phi2] = *q;
        let [phi1_dot, phi2_dot] = *qd;
        let ([u_x, v_x], [cos_phi1, cos_phi2]) = S::sin_cos_each([phi1, phi2]);
        let w = self.k * phi2_dot * phi2_dot;
        let rhs_phi1 = cos_phi1 * v_x * w - u_x * (self.k_4 + cos_phi2 * w);
        let w_2 = self.k * phi1_dot * phi1_dot;
        let mass_phi2_phi1 = self.k * (cos_phi1 * cos_phi2 + u_x * v_x);
        let l_phi2_phi1 = mass_phi2_phi1 * self.inverse_phi1;
        let pivot_phi2 = self.mass_phi2_phi2 - mass_phi2_phi1 * l_phi2_phi1;
        let phi2_ddot = S::from_f64(1.0) / pivot_phi2
            * (cos_phi2 * u_x * w_2 - v_x * (self.k_6 + cos_phi1 * w_2)
                - rhs_phi1 * l_phi2_phi1);
        sim_kernel::Dynamics {
            accelerations: [
                rhs_phi1 * self.inverse_phi1 - l_phi2_phi1 * phi2_ddot,
                phi2_ddot,
            ],
            multipliers: [],
            power: -(u_x * phi1_dot * self.k_4 + v_x * phi2_dot * self.k_6),
            refused: sim_kernel::pivot_is_refused(
                self.mass_phi1_phi1,
                self.mass_phi1_phi1,
            ) | sim_kernel::pivot_is_refused(pivot_phi2, self.mass_phi2_phi2),
        }
    }
    /// The derivatives of accelerations (2 rows) and multipliers (0 rows) with respect to coordinates and speeds (2 columns each): with the equations of motion as `K z = r`, the solutions of `K dz = dr - dK z`. Where `refused` is set a pivot was too small and nothing else holds.
    ///
    /// Operations: 28 additions, 61 multiplications, 1 division, 2 sine-cosine pairs.
    #[inline]
    pub fn dynamics_jacobian(
        &self,
        t: S,
        q: &[S; 2],
        qd: &[S; 2],
    ) -> sim_kernel::DynamicsJacobian<S, [[S; 2]; 2], [[S; 2]; 0]> {
        let [phi1, phi2] = *q;
        let [phi1_dot, phi2_dot] = *qd;
        let phi2_dot_squared = phi2_dot * phi2_dot;
        let w = self.k * phi2_dot_squared;
        let ([u_x, v_x], [cos_phi1, cos_phi2]) = S::sin_cos_each([phi1, phi2]);
        let w_2 = cos_phi1 * v_x;
        let rhs_phi1 = w * w_2 - u_x * (self.k_4 + cos_phi2 * w);
        let phi1_dot_squared = phi1_dot * phi1_dot;
        let w_3 = self.k * phi1_dot_squared;
        let w_4 = cos_phi2 * u_x;
        let w_10 = w_4 - w_2;
        let w_5 = cos_phi1 * cos_phi2 + u_x * v_x;
        let mass_phi2_phi1 = self.k * w_5;
        let l_phi2_phi1 = mass_phi2_phi1 * self.inverse_phi1;
        let pivot_phi2 = self.mass_phi2_phi2 - mass_phi2_phi1 * l_phi2_phi1;
        let w_6 = phi1_dot_squared * self.k_2;
        let w_7 = self.l * phi2_dot_squared;
        let w_8 = u_x * w_6 + v_x * w_7;
        let w_9 = cos_phi1 * w_6 + cos_phi2 * w_7;
        let inverse_phi2 = S::from_f64(1.0) / pivot_phi2;
        let phi2_ddot = inverse_phi2
            * (w_3 * w_4 - v_x * (self.k_6 + cos_phi1 * w_3) - rhs_phi1 * l_phi2_phi1);
        let w_11 = S::from_f64(0.5) * self.k_7 * w_10;
        let w_14 = (rhs_phi1 * self.inverse_phi1 - l_phi2_phi1 * phi2_ddot) * w_11;
        let w_12 = phi2_ddot * w_11;
        let w_13 = phi1_dot_squared * self.k_7 - self.k_3 * (u_x * w_8 + cos_phi1 * w_9)
            - cos_phi1 * self.k_4 + w_12;
        let w_15 = inverse_phi2 * (w_5 * w_3 + w_14 - l_phi2_phi1 * w_13);
        let w_16 = w_5 * w - w_12;
        let w_17 = inverse_phi2
            * (phi2_dot_squared * self.k_8 - w_14
                - self.k_5 * (v_x * w_8 + cos_phi2 * w_9) - cos_phi2 * self.k_6
                - l_phi2_phi1 * w_16);
        let w_18 = inverse_phi2 * phi1_dot * self.k_7 * w_10;
        let w_19 = phi2_dot * self.k_7 * w_10;
        let w_20 = inverse_phi2 * l_phi2_phi1 * w_19;
        sim_kernel::DynamicsJacobian {
            accelerations_by_positions: [
                [
                    self.inverse_phi1 * w_13 - l_phi2_phi1 * w_15,
                    self.inverse_phi1 * w_16 - l_phi2_phi1 * w_17,
                ],
                [w_15, w_17],
            ],
            accelerations_by_speeds: [
                [
                    -(l_phi2_phi1 * w_18),
                    -(self.inverse_phi1 * w_19 + l_phi2_phi1 * w_20),
                ],
                [w_18, w_20],
            ],
            multipliers_by_positions: [],
            multipliers_by_speeds: [],
            refused: sim_kernel::pivot_is_refused(
                self.mass_phi1_phi1,
                self.mass_phi1_phi1,
            ) | sim_kernel::pivot_is_refused(pivot_phi2, self.mass_phi2_phi2),
        }
    }
}
#[allow(non_snake_case, clippy::all, clippy::pedantic)]
impl<S: sim_kernel::Scalar> sim_kernel::Mechanism<S> for DoublePendulum<S> {
    type Q = [S; 2];
    type L = [S; 0];
    type Z = [S; 2];
    type QQ = [[S; 2]; 2];
    type LQ = [[S; 2]; 0];
    type LL = [[S; 0]; 0];
    type ZZ = [[S; 2]; 2];
    type Entries = [S; 0];
    type Envelope = [S; 0];
    type Parameters = [S; 5];
    type Outputs = [S; 4];
    type OutputRates = [S; 4];
    type Events = [S; 0];
    type EventValues = [S; 0];
    type Activities = [S; 0];
    type Drawing = [S; 10];
    type QP = [[S; 5]; 2];
    type LP = [[S; 5]; 0];
    type Inputs = [sim_kernel::Input<S>; 0];
    type Prepared = DoublePendulumPrepared<S>;
    type On<T: sim_kernel::Scalar> = DoublePendulum<T>;
    const DESCRIPTION: sim_kernel::Description = sim_kernel::Description {
        name: "double-pendulum",
        type_name: "DoublePendulum",
        docs: "Two equal slender bars, let go from the horizontal.",
        declaration: "/// Two equal slender bars, let go from the horizontal.\npub DoublePendulum;\n\ncoordinates {\n    /// Angle of the upper bar from the vertical.\n    phi1 [rad];\n    /// Angle of the lower bar from the vertical.\n    phi2 [rad];\n}\n\nparameters {\n    /// Length of each bar.\n    l [m] = 0.6;\n    /// Density of the bars.\n    rho [kg/m^3] = 670;\n    /// Width of the bars.\n    width [m] = 0.05;\n    /// Thickness of the bars.\n    thickness [m] = 0.003;\n    g [m/s^2] = 9.81;\n}\n\nlet m = rho*l*width*thickness;\nlet u = [sin(phi1), -cos(phi1)];\nlet v = [sin(phi2), -cos(phi2)];\nlet O = [0, 0];\nlet elbow = l*u;\nlet tip = elbow + l*v;\n\nbodies {\n    upper: mass m at l/2*u, inertia m*l^2/12, angle phi1;\n    lower: mass m at elbow + l/2*v, inertia m*l^2/12, angle phi2;\n}\n\nloads { gravity [0, -g]; }\ninitial { phi1 = pi/2; phi2 = pi/2; }\n\noutputs {\n    angles \"Angles of the bars\" {\n        /// upper bar\n        upper_angle [rad] = phi1;\n        /// lower bar\n        lower_angle [rad] = phi2;\n    }\n    tip_speed \"Speed of the tip\" {\n        /// speed\n        speed [m/s] = norm(dot(tip));\n    }\n    energy \"Energy\" {\n        /// potential energy, zero at the support\n        potential [J] = m*g*(l/2*u.y + elbow.y + l/2*v.y);\n    }\n}\n\ndrawing {\n    ground O;\n    line O, elbow, tip;\n    point elbow;\n}\n",
        coordinates: &[
            sim_kernel::Coordinate {
                position: sim_kernel::Quantity {
                    name: "phi1",
                    unit: "rad",
                    factor: 1f64,
                    is_length: false,
                    docs: "Angle of the upper bar from the vertical.",
                },
                speed: sim_kernel::Quantity {
                    name: "phi1_dot",
                    unit: "rad/s",
                    factor: 1f64,
                    is_length: false,
                    docs: "",
                },
                acceleration: sim_kernel::Quantity {
                    name: "phi1_ddot",
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
                    name: "phi2",
                    unit: "rad",
                    factor: 1f64,
                    is_length: false,
                    docs: "Angle of the lower bar from the vertical.",
                },
                speed: sim_kernel::Quantity {
                    name: "phi2_dot",
                    unit: "rad/s",
                    factor: 1f64,
                    is_length: false,
                    docs: "",
                },
                acceleration: sim_kernel::Quantity {
                    name: "phi2_ddot",
                    unit: "rad/s^2",
                    factor: 1f64,
                    is_length: false,
                    docs: "",
                },
                start: sim_kernel::Start::Given,
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
                name: "rho",
                unit: "kg/m^3",
                factor: 1f64,
                is_length: false,
                docs: "Density of the bars.",
            },
            sim_kernel::Quantity {
                name: "width",
                unit: "m",
                factor: 1f64,
                is_length: true,
                docs: "Width of the bars.",
            },
            sim_kernel::Quantity {
                name: "thickness",
                unit: "m",
                factor: 1f64,
                is_length: true,
                docs: "Thickness of the bars.",
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
        constraints: &[],
        speed_constraints: &[],
        norm_constraints: &[],
        sparsity: &[],
        conditionals: &[],
        events: &[],
        outputs: &[
            sim_kernel::Quantity {
                name: "upper_angle",
                unit: "rad",
                factor: 1f64,
                is_length: false,
                docs: "upper bar",
            },
            sim_kernel::Quantity {
                name: "lower_angle",
                unit: "rad",
                factor: 1f64,
                is_length: false,
                docs: "lower bar",
            },
            sim_kernel::Quantity {
                name: "speed",
                unit: "m/s",
                factor: 1f64,
                is_length: false,
                docs: "speed",
            },
            sim_kernel::Quantity {
                name: "potential",
                unit: "J",
                factor: 1f64,
                is_length: false,
                docs: "potential energy, zero at the support",
            },
        ],
        rated_outputs: &[0, 1, 2, 3],
        figures: &[
            sim_kernel::Figure {
                name: "angles",
                title: "Angles of the bars",
                len: 2,
            },
            sim_kernel::Figure {
                name: "tip_speed",
                title: "Speed of the tip",
                len: 1,
            },
            sim_kernel::Figure {
                name: "energy",
                title: "Energy",
                len: 1,
            },
        ],
        optional_kernels: &["dynamics_jacobian"],
        dimension: 2,
        drawing: &[
            sim_kernel::Shape::Ground(1),
            sim_kernel::Shape::Line(3),
            sim_kernel::Shape::Points(1),
        ],
    };
    fn defaults() -> Self {
        Self {
            l: S::from_f64(0.6f64),
            rho: S::from_f64(670f64),
            width: S::from_f64(0.05f64),
            thickness: S::from_f64(0.003f64),
            g: S::from_f64(9.81f64),
        }
    }
    fn parameters(&self) -> [S; 5] {
        [self.l, self.rho, self.width, self.thickness, self.g]
    }
    fn with_parameters(&self, parameters: [S; 5]) -> Self {
        Self {
            l: parameters[0],
            rho: parameters[1],
            width: parameters[2],
            thickness: parameters[3],
            g: parameters[4],
            ..*self
        }
    }
    fn on<T: sim_kernel::Scalar>(
        &self,
        convert: impl ::core::ops::Fn(S) -> T,
    ) -> DoublePendulum<T> {
        DoublePendulum {
            l: convert(self.l),
            rho: convert(self.rho),
            width: convert(self.width),
            thickness: convert(self.thickness),
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
    fn prepare(&self) -> DoublePendulumPrepared<S> {
        self.prepare()
    }
    #[inline(always)]
    fn prepared_dynamics(
        prepared: &Self::Prepared,
        t: S,
        q: &[S; 2],
        qd: &[S; 2],
    ) -> sim_kernel::Dynamics<S, [S; 2], [S; 0]> {
        prepared.dynamics(t, q, qd)
    }
    #[inline(always)]
    fn dynamics_jacobian(
        &self,
        t: S,
        q: &[S; 2],
        qd: &[S; 2],
    ) -> sim_kernel::DynamicsJacobian<S, [[S; 2]; 2], [[S; 2]; 0]> {
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
    fn constraints(&self, t: S, q: &[S; 2]) -> [S; 0] {
        self.constraints(t, q)
    }
    #[inline(always)]
    fn constraint_magnitudes(&self, t: S, q: &[S; 2]) -> [S; 0] {
        self.constraint_magnitudes(t, q)
    }
    #[inline(always)]
    fn constraint_jacobian(&self, t: S, q: &[S; 2]) -> [[S; 2]; 0] {
        self.constraint_jacobian(t, q)
    }
    #[inline(always)]
    fn constraint_time_derivative(&self, t: S, q: &[S; 2]) -> [S; 0] {
        self.constraint_time_derivative(t, q)
    }
    #[inline(always)]
    fn constraint_convective(&self, t: S, q: &[S; 2], qd: &[S; 2]) -> [S; 0] {
        self.constraint_convective(t, q, qd)
    }
    #[inline(always)]
    fn constraint_linearization(
        &self,
        t: S,
        q: &[S; 2],
    ) -> sim_kernel::ConstraintLinearization<[S; 0], [[S; 2]; 0]> {
        self.constraint_linearization(t, q)
    }
    #[inline(always)]
    fn kinetic_energy(&self, t: S, q: &[S; 2], qd: &[S; 2]) -> S {
        self.kinetic_energy(t, q, qd)
    }
    #[inline(always)]
    fn power(&self, t: S, q: &[S; 2], qd: &[S; 2], qdd: &[S; 2], lambda: &[S; 0]) -> S {
        self.power(t, q, qd, qdd, lambda)
    }
    #[inline(always)]
    fn outputs(
        &self,
        t: S,
        q: &[S; 2],
        qd: &[S; 2],
        qdd: &[S; 2],
        lambda: &[S; 0],
    ) -> [S; 4] {
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
        lambda: &[S; 0],
    ) -> [S; 0] {
        self.events(t, q, qd, qdd, lambda)
    }
    #[inline(always)]
    fn drawing(&self, t: S, q: &[S; 2]) -> [S; 10] {
        self.drawing(t, q)
    }
    #[inline(always)]
    fn initial(&self) -> sim_kernel::Initial<[S; 2]> {
        self.initial()
    }
}
