/// A skate on sloping ice, let go turning: a cycloid across the slope.
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
/// coordinates = [x; y; phi]
/// multipliers = [lambda_blade]
/// constraints = 0
/// [
///     m, 0, -m*a*along_y, across_x;
///     0, m, m*a*along_x, along_x;
///     -m*a*along_y, m*a*along_x, J + m*a^2, 0;
///     across_x, along_x, 0, 0
/// ] * [x_ddot; y_ddot; phi_ddot; lambda_blade] = [
///     m*g*sin(slope) + m*a*along_x*phi_dot^2;
///     m*a*along_y*phi_dot^2;
///     -m*a*g*along_y*sin(slope);
///     along_y*y_dot*phi_dot + along_x*x_dot*phi_dot
/// ]
///
/// mass_matrix = [
///     m, 0, -m*a*along_y;
///     0, m, m*a*along_x;
///     -m*a*along_y, m*a*along_x, J + m*a^2
/// ]
///
/// convective_forces = [
///     -m*a*along_x*phi_dot^2;
///     -m*a*along_y*phi_dot^2;
///     0
/// ]
///
/// generalized_forces = [m*g*sin(slope); 0; -m*a*g*along_y*sin(slope)]
///
/// constraints = [0]
///
/// constraint_jacobian = [across_x, along_x, 0]
///
/// constraint_convective = [
///     -along_y*y_dot*phi_dot - along_x*x_dot*phi_dot
/// ]
///
/// along_x = cos(phi)
/// along_y = sin(phi)
/// across_x = -along_y
/// ```
#[allow(non_snake_case)]
#[derive(
    ::core::clone::Clone,
    ::core::marker::Copy,
    ::core::fmt::Debug,
    ::core::cmp::PartialEq
)]
pub struct Skate<S = ::core::primitive::f64> {
    /// In `kg`.
    pub m: S,
    /// Moment of inertia about the centre of mass, in `kg*m^2`.
    pub J: S,
    /// How far the centre of mass is ahead of the blade, in `m`.
    pub a: S,
    /// In `1`.
    pub slope: S,
    /// In `m/s^2`.
    pub g: S,
}
impl<S: sim_kernel::Scalar> ::core::default::Default for Skate<S> {
    /// The declared values.
    fn default() -> Self {
        <Self as sim_kernel::Compiled<S>>::defaults()
    }
}
/// Coordinates of [`Skate`] by name, in SI units; also for their speeds and accelerations.
#[allow(non_snake_case)]
#[derive(
    ::core::clone::Clone,
    ::core::marker::Copy,
    ::core::fmt::Debug,
    ::core::cmp::PartialEq
)]
pub struct SkateCoordinates<S = ::core::primitive::f64> {
    /// Where the blade touches the ice, down the slope, in `m`.
    pub x: S,
    /// And across it, in `m`.
    pub y: S,
    /// Direction of the blade, from straight down, in `rad`.
    pub phi: S,
}
impl<S: sim_kernel::Scalar> ::core::convert::From<[S; 3]> for SkateCoordinates<S> {
    fn from(values: [S; 3]) -> Self {
        Self {
            x: values[0],
            y: values[1],
            phi: values[2],
        }
    }
}
impl<S: sim_kernel::Scalar> ::core::convert::From<SkateCoordinates<S>> for [S; 3] {
    fn from(record: SkateCoordinates<S>) -> Self {
        [record.x, record.y, record.phi]
    }
}
/// Outputs of [`Skate`] by name, in SI units.
#[allow(non_snake_case)]
#[derive(
    ::core::clone::Clone,
    ::core::marker::Copy,
    ::core::fmt::Debug,
    ::core::cmp::PartialEq
)]
pub struct SkateOutputs<S = ::core::primitive::f64> {
    /// Speed along the blade, in `m/s`.
    pub speed: S,
    /// Force of the skate on the ice, to its left, in `N`.
    pub side_force: S,
}
impl<S: sim_kernel::Scalar> ::core::convert::From<[S; 2]> for SkateOutputs<S> {
    fn from(values: [S; 2]) -> Self {
        Self {
            speed: values[0],
            side_force: values[1],
        }
    }
}
impl<S: sim_kernel::Scalar> ::core::convert::From<SkateOutputs<S>> for [S; 2] {
    fn from(record: SkateOutputs<S>) -> Self {
        [record.speed, record.side_force]
    }
}
/// Rates of the outputs of [`Skate`] by name, in SI units.
#[allow(non_snake_case)]
#[derive(
    ::core::clone::Clone,
    ::core::marker::Copy,
    ::core::fmt::Debug,
    ::core::cmp::PartialEq
)]
pub struct SkateOutputRates<S = ::core::primitive::f64> {
    /// Rate of `speed`.
    pub speed: S,
}
impl<S: sim_kernel::Scalar> ::core::convert::From<[S; 1]> for SkateOutputRates<S> {
    fn from(values: [S; 1]) -> Self {
        Self { speed: values[0] }
    }
}
impl<S: sim_kernel::Scalar> ::core::convert::From<SkateOutputRates<S>> for [S; 1] {
    fn from(record: SkateOutputRates<S>) -> Self {
        [record.speed]
    }
}
/// What the equations of motion need of the parameters of [`Skate`], from [`Skate::prepare`]; its methods are the kernels of each step.
#[allow(non_snake_case)]
#[derive(
    ::core::clone::Clone,
    ::core::marker::Copy,
    ::core::fmt::Debug,
    ::core::cmp::PartialEq
)]
pub struct SkatePrepared<S = ::core::primitive::f64> {
    m: S,
    a: S,
    k: S,
    mass_phi_phi: S,
    k_2: S,
    k_3: S,
    inverse_x: S,
    k_4: S,
}
#[allow(non_snake_case, unused_variables, unused_parens, clippy::all, clippy::pedantic)]
impl<S: sim_kernel::Scalar> Skate<S> {
    /// What the equations of motion need of the parameters, computed once for a set of parameters.
    ///
    /// Operations: 1 addition, 8 multiplications, 1 division, 1 sine-cosine pair.
    #[inline]
    pub fn prepare(&self) -> SkatePrepared<S> {
        let w = self.m * self.a;
        let ([sin_slope], [_]) = S::sin_cos_each([self.slope]);
        SkatePrepared {
            m: self.m,
            a: self.a,
            k: w,
            mass_phi_phi: self.J + self.m * self.a * self.a,
            k_2: self.m * self.g * sin_slope,
            k_3: w * self.g * sin_slope,
            inverse_x: S::from_f64(1.0) / self.m,
            k_4: w * S::from_f64(2.0),
        }
    }
    /// Mass matrix `T_q' M T_q`, 3 x 3, symmetric, in SI units.
    ///
    /// Operations: 2 additions, 5 multiplications, 1 sine-cosine pair.
    #[inline]
    pub fn mass_matrix(&self, t: S, q: &[S; 3]) -> [[S; 3]; 3] {
        let [_, _, phi] = *q;
        let ([along_y], [along_x]) = S::sin_cos_each([phi]);
        let w = self.m * self.a;
        let mass_phi_x = -(along_y * w);
        let mass_phi_y = w * along_x;
        [
            [self.m, S::from_f64(0.0), mass_phi_x],
            [S::from_f64(0.0), self.m, mass_phi_y],
            [mass_phi_x, mass_phi_y, self.J + self.m * self.a * self.a],
        ]
    }
    /// Convective forces `T_q' M g`, 3, with `g = (T_q q' + T_t)_q q' + (..)_t`: joules per unit of each coordinate.
    ///
    /// Operations: 2 additions, 5 multiplications, 1 sine-cosine pair.
    #[inline]
    pub fn convective_forces(&self, t: S, q: &[S; 3], qd: &[S; 3]) -> [S; 3] {
        let [_, _, phi] = *q;
        let [_, _, phi_dot] = *qd;
        let ([along_y], [along_x]) = S::sin_cos_each([phi]);
        let w = phi_dot * phi_dot * self.m * self.a;
        [-(along_x * w), -(w * along_y), S::from_f64(0.0)]
    }
    /// Generalised forces `T_q' F`, 3: joules per unit of each coordinate.
    ///
    /// Operations: 1 addition, 5 multiplications, 2 sine-cosine pairs.
    #[inline]
    pub fn generalized_forces(&self, t: S, q: &[S; 3], qd: &[S; 3]) -> [S; 3] {
        let [_, _, phi] = *q;
        let ([sin_slope, along_y], [_, _]) = S::sin_cos_each([self.slope, phi]);
        let w = self.m * self.g;
        [sin_slope * w, S::from_f64(0.0), -(along_y * sin_slope * w * self.a)]
    }
    /// Constraints `C`, 1, in SI units; zero throughout the motion.
    ///
    /// Operations: none.
    #[inline]
    pub fn constraints(&self, t: S, q: &[S; 3]) -> [S; 1] {
        [S::from_f64(0.0)]
    }
    /// The sum of the magnitudes of the terms of `C`, 1, in SI units: what its rounding is relative to.
    ///
    /// Operations: none.
    #[inline]
    pub fn constraint_magnitudes(&self, t: S, q: &[S; 3]) -> [S; 1] {
        [S::from_f64(0.0)]
    }
    /// Constraint Jacobian `C_q`, 1 x 3: units of each constraint per unit of each coordinate.
    ///
    /// Operations: 1 addition, 1 sine-cosine pair.
    #[inline]
    pub fn constraint_jacobian(&self, t: S, q: &[S; 3]) -> [[S; 3]; 1] {
        let [_, _, phi] = *q;
        let ([along_y], [along_x]) = S::sin_cos_each([phi]);
        [[-along_y, along_x, S::from_f64(0.0)]]
    }
    /// `C_t`, 1, units of `C` per second: the speeds obey `C_q q' + C_t = 0`.
    ///
    /// Operations: none.
    #[inline]
    pub fn constraint_time_derivative(&self, t: S, q: &[S; 3]) -> [S; 1] {
        [S::from_f64(0.0)]
    }
    /// `(C_q q' + C_t)_q q' + (..)_t`, 1, units of `C` per second squared: the part of `C''` without accelerations.
    ///
    /// Operations: 2 additions, 3 multiplications, 1 sine-cosine pair.
    #[inline]
    pub fn constraint_convective(&self, t: S, q: &[S; 3], qd: &[S; 3]) -> [S; 1] {
        let [_, _, phi] = *q;
        let [x_dot, y_dot, phi_dot] = *qd;
        let ([along_y], [along_x]) = S::sin_cos_each([phi]);
        [-(phi_dot * (y_dot * along_y + x_dot * along_x))]
    }
    /// `C` (1), `C_q` (1 x 3) and `C_t` (1) together, in SI units, for projection.
    ///
    /// Operations: 1 addition, 1 sine-cosine pair.
    #[inline]
    pub fn constraint_linearization(
        &self,
        t: S,
        q: &[S; 3],
    ) -> sim_kernel::ConstraintLinearization<[S; 1], [[S; 3]; 1]> {
        let [_, _, phi] = *q;
        let ([along_y], [along_x]) = S::sin_cos_each([phi]);
        sim_kernel::ConstraintLinearization {
            values: [S::from_f64(0.0)],
            jacobian: [[-along_y, along_x, S::from_f64(0.0)]],
            time_derivative: [S::from_f64(0.0)],
        }
    }
    /// Kinetic energy `v' M v / 2`, in joules.
    ///
    /// Operations: 4 additions, 10 multiplications, 1 sine-cosine pair.
    #[inline]
    pub fn kinetic_energy(&self, t: S, q: &[S; 3], qd: &[S; 3]) -> S {
        let [_, _, phi] = *q;
        let [x_dot, y_dot, phi_dot] = *qd;
        let ([along_y], [along_x]) = S::sin_cos_each([phi]);
        let w = phi_dot * self.a;
        let w_2 = x_dot - along_y * w;
        let w_3 = y_dot + w * along_x;
        S::from_f64(0.5) * self.m * (w_2 * w_2 + w_3 * w_3)
            + phi_dot * phi_dot * S::from_f64(0.5) * self.J
    }
    /// Power of loads and drives, `F' v + lambda' C_t + T_t' (M x'' - F)`, in watts.
    ///
    /// Operations: 1 addition, 5 multiplications, 2 sine-cosine pairs.
    #[inline]
    pub fn power(
        &self,
        t: S,
        q: &[S; 3],
        qd: &[S; 3],
        qdd: &[S; 3],
        lambda: &[S; 1],
    ) -> S {
        let [_, _, phi] = *q;
        let [x_dot, _, phi_dot] = *qd;
        let ([sin_slope, along_y], [_, _]) = S::sin_cos_each([self.slope, phi]);
        (x_dot - phi_dot * self.a * along_y) * self.m * self.g * sin_slope
    }
    /// Outputs, 2, in SI units.
    ///
    /// Operations: 1 addition, 2 multiplications, 1 sine-cosine pair.
    #[inline]
    pub fn outputs(
        &self,
        t: S,
        q: &[S; 3],
        qd: &[S; 3],
        qdd: &[S; 3],
        lambda: &[S; 1],
    ) -> SkateOutputs<S> {
        let [_, _, phi] = *q;
        let [x_dot, y_dot, _] = *qd;
        let [lambda_blade] = *lambda;
        let ([along_y], [along_x]) = S::sin_cos_each([phi]);
        [x_dot * along_x + y_dot * along_y, lambda_blade].into()
    }
    /// Rates of the outputs that depend on neither accelerations nor multipliers, 1, in SI units per second.
    ///
    /// Operations: 3 additions, 4 multiplications, 1 sine-cosine pair.
    #[inline]
    pub fn output_rates(
        &self,
        t: S,
        q: &[S; 3],
        qd: &[S; 3],
        qdd: &[S; 3],
    ) -> SkateOutputRates<S> {
        let [_, _, phi] = *q;
        let [x_dot, y_dot, phi_dot] = *qd;
        let [x_ddot, y_ddot, _] = *qdd;
        let ([along_y], [along_x]) = S::sin_cos_each([phi]);
        [along_x * (x_ddot + phi_dot * y_dot) + along_y * (y_ddot - x_dot * phi_dot)]
            .into()
    }
    /// `left - right` of each event, 1, in SI units: zero when it happens.
    ///
    /// Operations: 1 addition, 2 multiplications, 1 sine-cosine pair.
    #[inline]
    pub fn events(
        &self,
        t: S,
        q: &[S; 3],
        qd: &[S; 3],
        qdd: &[S; 3],
        lambda: &[S; 1],
    ) -> [S; 1] {
        let [_, _, phi] = *q;
        let [x_dot, y_dot, _] = *qd;
        let ([along_y], [along_x]) = S::sin_cos_each([phi]);
        [x_dot * along_x + y_dot * along_y]
    }
    /// The numbers of each shape of the drawing, in metres and radians.
    ///
    /// Operations: 6 additions, 4 multiplications, 1 sine-cosine pair.
    #[inline]
    pub fn drawing(&self, t: S, q: &[S; 3]) -> [S; 8] {
        let [x, y, phi] = *q;
        let ([along_y], [along_x]) = S::sin_cos_each([phi]);
        let w = S::from_f64(0.15) * along_x;
        let w_2 = S::from_f64(0.15) * along_y;
        [
            x - w,
            y - w_2,
            x + w,
            y + w_2,
            x,
            y,
            x + along_x * self.a,
            y + along_y * self.a,
        ]
    }
    /// Declared start: values or guesses of the coordinates (3), and speeds (3), in SI units; 0 where nothing is declared.
    ///
    /// Operations: none.
    #[inline]
    pub fn initial(&self) -> sim_kernel::Initial<[S; 3]> {
        sim_kernel::Initial {
            positions: [S::from_f64(0.0), S::from_f64(0.0), S::from_f64(0.0)],
            speeds: [S::from_f64(0.0), S::from_f64(0.0), S::from_f64(3.0)],
        }
    }
    /// [`SkatePrepared::dynamics`] once; for many calls with the same parameters [`Self::prepare`] first.
    #[inline]
    pub fn dynamics(
        &self,
        t: S,
        q: &[S; 3],
        qd: &[S; 3],
    ) -> sim_kernel::Dynamics<S, [S; 3], [S; 1]> {
        self.prepare().dynamics(t, q, qd)
    }
    /// [`SkatePrepared::dynamics_jacobian`] once; for many calls with the same parameters [`Self::prepare`] first.
    #[inline]
    pub fn dynamics_jacobian(
        &self,
        t: S,
        q: &[S; 3],
        qd: &[S; 3],
    ) -> sim_kernel::DynamicsJacobian<S, [[S; 3]; 3], [[S; 3]; 1]> {
        self.prepare().dynamics_jacobian(t, q, qd)
    }
}
#[allow(non_snake_case, unused_variables, unused_parens, clippy::all, clippy::pedantic)]
impl<S: sim_kernel::Scalar> SkatePrepared<S> {
    /// Accelerations (3), multipliers (1) and power, from
    ///
    /// ```text
    /// [ T_q' M T_q   C_q' ] [ q''    ]   [ T_q' (F - M g)                      ]
    /// [ C_q          0    ] [ lambda ] = [ -(C_q q' + C_t)_q q' - (..)_t       ]
    /// ```
    ///
    /// by an elimination planned from the structure of the system. Where `refused` is set a pivot was too small and nothing else holds: solve that state from the other kernels.
    ///
    /// Operations: 20 additions, 39 multiplications, 2 divisions, 1 sine-cosine pair.
    #[inline(always)]
    pub fn dynamics(
        &self,
        t: S,
        q: &[S; 3],
        qd: &[S; 3],
    ) -> sim_kernel::Dynamics<S, [S; 3], [S; 1]> {
        let [_, _, phi] = *q;
        let [x_dot, y_dot, phi_dot] = *qd;
        let ([along_y], [along_x]) = S::sin_cos_each([phi]);
        let w = self.k * phi_dot * phi_dot;
        let rhs_x = self.k_2 + along_x * w;
        let rhs_y = along_y * w;
        let minus_mass_phi_x = along_y * self.k;
        let minus_l_phi_x = minus_mass_phi_x * self.inverse_x;
        let mass_phi_y = self.k * along_x;
        let l_phi_y = mass_phi_y * self.inverse_x;
        let rhs_phi = rhs_x * minus_l_phi_x - along_y * self.k_3 - rhs_y * l_phi_y;
        let minus_l_lambda_blade_x = along_y * self.inverse_x;
        let l_lambda_blade_y = along_x * self.inverse_x;
        let pivot_phi = self.mass_phi_phi - minus_mass_phi_x * minus_l_phi_x
            - mass_phi_y * l_phi_y;
        let minus_k_lambda_blade_phi = minus_mass_phi_x * minus_l_lambda_blade_x
            + mass_phi_y * l_lambda_blade_y;
        let inverse_phi = S::from_f64(1.0) / pivot_phi;
        let minus_l_lambda_blade_phi = inverse_phi * minus_k_lambda_blade_phi;
        let minus_pivot_lambda_blade = along_y * minus_l_lambda_blade_x
            + along_x * l_lambda_blade_y
            + minus_k_lambda_blade_phi * minus_l_lambda_blade_phi;
        let minus_lambda_blade = S::from_f64(1.0) / minus_pivot_lambda_blade
            * (phi_dot * (along_y * y_dot + along_x * x_dot)
                + rhs_x * minus_l_lambda_blade_x - rhs_y * l_lambda_blade_y
                + minus_l_lambda_blade_phi * rhs_phi);
        let phi_ddot = inverse_phi * rhs_phi
            - minus_l_lambda_blade_phi * minus_lambda_blade;
        sim_kernel::Dynamics {
            accelerations: [
                rhs_x * self.inverse_x + minus_l_phi_x * phi_ddot
                    - minus_l_lambda_blade_x * minus_lambda_blade,
                rhs_y * self.inverse_x - l_phi_y * phi_ddot
                    + l_lambda_blade_y * minus_lambda_blade,
                phi_ddot,
            ],
            multipliers: [-minus_lambda_blade],
            power: self.k_2 * (x_dot - self.a * along_y * phi_dot),
            refused: sim_kernel::pivot_is_refused(self.m, self.m)
                | sim_kernel::pivot_is_refused(self.m, self.m)
                | sim_kernel::pivot_is_refused(pivot_phi, self.mass_phi_phi)
                | sim_kernel::pivot_is_refused(
                    -minus_pivot_lambda_blade,
                    minus_pivot_lambda_blade,
                ),
        }
    }
    /// The derivatives of accelerations (3 rows) and multipliers (1 rows) with respect to coordinates and speeds (3 columns each): with the equations of motion as `K z = r`, the solutions of `K dz = dr - dK z`. Where `refused` is set a pivot was too small and nothing else holds.
    ///
    /// Operations: 58 additions, 96 multiplications, 2 divisions, 1 sine-cosine pair.
    #[inline]
    pub fn dynamics_jacobian(
        &self,
        t: S,
        q: &[S; 3],
        qd: &[S; 3],
    ) -> sim_kernel::DynamicsJacobian<S, [[S; 3]; 3], [[S; 3]; 1]> {
        let [_, _, phi] = *q;
        let [x_dot, y_dot, phi_dot] = *qd;
        let ([along_y], [along_x]) = S::sin_cos_each([phi]);
        let phi_dot_squared = phi_dot * phi_dot;
        let w = self.k * phi_dot_squared;
        let rhs_x = self.k_2 + along_x * w;
        let rhs_y = along_y * w;
        let minus_mass_phi_x = along_y * self.k;
        let minus_l_phi_x = minus_mass_phi_x * self.inverse_x;
        let mass_phi_y = self.k * along_x;
        let l_phi_y = mass_phi_y * self.inverse_x;
        let rhs_phi = rhs_x * minus_l_phi_x - along_y * self.k_3 - rhs_y * l_phi_y;
        let w_2 = along_y * y_dot + along_x * x_dot;
        let minus_l_lambda_blade_x = along_y * self.inverse_x;
        let l_lambda_blade_y = along_x * self.inverse_x;
        let pivot_phi = self.mass_phi_phi - minus_mass_phi_x * minus_l_phi_x
            - mass_phi_y * l_phi_y;
        let minus_k_lambda_blade_phi = minus_mass_phi_x * minus_l_lambda_blade_x
            + mass_phi_y * l_lambda_blade_y;
        let inverse_phi = S::from_f64(1.0) / pivot_phi;
        let minus_l_lambda_blade_phi = inverse_phi * minus_k_lambda_blade_phi;
        let minus_pivot_lambda_blade = along_y * minus_l_lambda_blade_x
            + along_x * l_lambda_blade_y
            + minus_k_lambda_blade_phi * minus_l_lambda_blade_phi;
        let minus_inverse_lambda_blade = S::from_f64(1.0) / minus_pivot_lambda_blade;
        let minus_lambda_blade = minus_inverse_lambda_blade
            * (phi_dot * w_2 + rhs_x * minus_l_lambda_blade_x - rhs_y * l_lambda_blade_y
                + minus_l_lambda_blade_phi * rhs_phi);
        let phi_ddot = inverse_phi * rhs_phi
            - minus_l_lambda_blade_phi * minus_lambda_blade;
        let x_ddot = rhs_x * self.inverse_x + minus_l_phi_x * phi_ddot
            - minus_l_lambda_blade_x * minus_lambda_blade;
        let y_ddot = rhs_y * self.inverse_x - l_phi_y * phi_ddot
            + l_lambda_blade_y * minus_lambda_blade;
        let w_3 = self.k * (along_x * phi_ddot - along_y * phi_dot_squared)
            - along_x * minus_lambda_blade;
        let w_4 = self.k * (along_x * phi_dot_squared + along_y * phi_ddot)
            - along_y * minus_lambda_blade;
        let w_5 = along_x * (self.k * x_ddot - self.k_3) + minus_mass_phi_x * y_ddot
            + minus_l_phi_x * w_3 - l_phi_y * w_4;
        let w_6 = minus_inverse_lambda_blade
            * (along_x * (x_ddot + phi_dot * y_dot)
                + along_y * (y_ddot - phi_dot * x_dot) + minus_l_lambda_blade_x * w_3
                - l_lambda_blade_y * w_4 + minus_l_lambda_blade_phi * w_5);
        let w_7 = inverse_phi * w_5 - minus_l_lambda_blade_phi * w_6;
        let w_8 = minus_inverse_lambda_blade * along_x * phi_dot;
        let w_9 = minus_l_lambda_blade_phi * w_8;
        let w_10 = minus_inverse_lambda_blade * along_y * phi_dot;
        let w_11 = minus_l_lambda_blade_phi * w_10;
        let w_12 = phi_dot * self.k_4;
        let w_13 = along_x * w_12;
        let w_14 = along_y * w_12;
        let w_15 = minus_l_phi_x * w_13 - l_phi_y * w_14;
        let w_16 = minus_inverse_lambda_blade
            * (w_2 + minus_l_lambda_blade_x * w_13 - l_lambda_blade_y * w_14
                + minus_l_lambda_blade_phi * w_15);
        let w_17 = inverse_phi * w_15 - minus_l_lambda_blade_phi * w_16;
        sim_kernel::DynamicsJacobian {
            accelerations_by_positions: [
                [
                    S::from_f64(0.0),
                    S::from_f64(0.0),
                    self.inverse_x * w_3 + minus_l_phi_x * w_7
                        - minus_l_lambda_blade_x * w_6,
                ],
                [
                    S::from_f64(0.0),
                    S::from_f64(0.0),
                    self.inverse_x * w_4 - l_phi_y * w_7 + l_lambda_blade_y * w_6,
                ],
                [S::from_f64(0.0), S::from_f64(0.0), w_7],
            ],
            accelerations_by_speeds: [
                [
                    -(minus_l_phi_x * w_9 + minus_l_lambda_blade_x * w_8),
                    -(minus_l_phi_x * w_11 + minus_l_lambda_blade_x * w_10),
                    self.inverse_x * w_13 + minus_l_phi_x * w_17
                        - minus_l_lambda_blade_x * w_16,
                ],
                [
                    l_phi_y * w_9 + l_lambda_blade_y * w_8,
                    l_phi_y * w_11 + l_lambda_blade_y * w_10,
                    self.inverse_x * w_14 - l_phi_y * w_17 + l_lambda_blade_y * w_16,
                ],
                [-w_9, -w_11, w_17],
            ],
            multipliers_by_positions: [[S::from_f64(0.0), S::from_f64(0.0), -w_6]],
            multipliers_by_speeds: [[-w_8, -w_10, -w_16]],
            refused: sim_kernel::pivot_is_refused(self.m, self.m)
                | sim_kernel::pivot_is_refused(self.m, self.m)
                | sim_kernel::pivot_is_refused(pivot_phi, self.mass_phi_phi)
                | sim_kernel::pivot_is_refused(
                    -minus_pivot_lambda_blade,
                    minus_pivot_lambda_blade,
                ),
        }
    }
}
#[allow(non_snake_case, unused_variables, clippy::all, clippy::pedantic)]
impl<S: sim_kernel::Scalar> sim_kernel::Mechanism<S> for Skate<S> {
    type Q = [S; 3];
    type L = [S; 1];
    type Z = [S; 4];
    type QQ = [[S; 3]; 3];
    type V = [S; 0];
    type VV = [[S; 0]; 0];
    type LQ = [[S; 3]; 1];
    type LL = [[S; 1]; 1];
    type ZZ = [[S; 4]; 4];
    type Entries = [S; 0];
    type Envelope = [S; 0];
    type Parameters = [S; 5];
    type Outputs = [S; 2];
    type OutputRates = [S; 1];
    type Events = [S; 1];
    type EventValues = [S; 0];
    type SwitchingFunctions = [S; 0];
    type LoadConditions = [S; 0];
    type Activities = [S; 0];
    type Drawing = [S; 8];
    type QP = [[S; 5]; 3];
    type LP = [[S; 5]; 1];
    type Inputs = [sim_kernel::Input<S>; 0];
    type Prepared = SkatePrepared<S>;
    type On<T: sim_kernel::Scalar> = Skate<T>;
    #[inline(always)]
    fn description(&self) -> &'static sim_kernel::Description {
        const { &<Self as sim_kernel::Compiled<S>>::DESCRIPTION }
    }
    fn as_declared(&self) -> Self {
        <Self as sim_kernel::Compiled<S>>::defaults()
    }
    fn parameters(&self) -> [S; 5] {
        [self.m, self.J, self.a, self.slope, self.g]
    }
    fn with_parameters(&self, parameters: [S; 5]) -> Self {
        Self {
            m: parameters[0],
            J: parameters[1],
            a: parameters[2],
            slope: parameters[3],
            g: parameters[4],
            ..*self
        }
    }
    fn on<T: sim_kernel::Scalar>(
        &self,
        convert: impl ::core::ops::Fn(S) -> T,
    ) -> Skate<T> {
        Skate {
            m: convert(self.m),
            J: convert(self.J),
            a: convert(self.a),
            slope: convert(self.slope),
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
    fn prepare(&self) -> SkatePrepared<S> {
        self.prepare()
    }
    #[inline(always)]
    fn prepared_dynamics(
        prepared: &Self::Prepared,
        t: S,
        q: &[S; 3],
        qd: &[S; 3],
    ) -> sim_kernel::Dynamics<S, [S; 3], [S; 1]> {
        prepared.dynamics(t, q, qd)
    }
    #[inline(always)]
    fn dynamics_jacobian(
        &self,
        t: S,
        q: &[S; 3],
        qd: &[S; 3],
    ) -> sim_kernel::DynamicsJacobian<S, [[S; 3]; 3], [[S; 3]; 1]> {
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
    fn constraints(&self, t: S, q: &[S; 3]) -> [S; 1] {
        self.constraints(t, q)
    }
    #[inline(always)]
    fn constraint_magnitudes(&self, t: S, q: &[S; 3]) -> [S; 1] {
        self.constraint_magnitudes(t, q)
    }
    #[inline(always)]
    fn constraint_jacobian(&self, t: S, q: &[S; 3]) -> [[S; 3]; 1] {
        self.constraint_jacobian(t, q)
    }
    #[inline(always)]
    fn constraint_time_derivative(&self, t: S, q: &[S; 3]) -> [S; 1] {
        self.constraint_time_derivative(t, q)
    }
    #[inline(always)]
    fn constraint_convective(&self, t: S, q: &[S; 3], qd: &[S; 3]) -> [S; 1] {
        self.constraint_convective(t, q, qd)
    }
    #[inline(always)]
    fn constraint_linearization(
        &self,
        t: S,
        q: &[S; 3],
    ) -> sim_kernel::ConstraintLinearization<[S; 1], [[S; 3]; 1]> {
        self.constraint_linearization(t, q)
    }
    #[inline(always)]
    fn kinetic_energy(&self, t: S, q: &[S; 3], qd: &[S; 3]) -> S {
        self.kinetic_energy(t, q, qd)
    }
    #[inline(always)]
    fn power(&self, t: S, q: &[S; 3], qd: &[S; 3], qdd: &[S; 3], lambda: &[S; 1]) -> S {
        self.power(t, q, qd, qdd, lambda)
    }
    #[inline(always)]
    fn outputs(
        &self,
        t: S,
        q: &[S; 3],
        qd: &[S; 3],
        qdd: &[S; 3],
        lambda: &[S; 1],
    ) -> [S; 2] {
        self.outputs(t, q, qd, qdd, lambda).into()
    }
    #[inline(always)]
    fn output_rates(&self, t: S, q: &[S; 3], qd: &[S; 3], qdd: &[S; 3]) -> [S; 1] {
        self.output_rates(t, q, qd, qdd).into()
    }
    #[inline(always)]
    fn events(
        &self,
        t: S,
        q: &[S; 3],
        qd: &[S; 3],
        qdd: &[S; 3],
        lambda: &[S; 1],
    ) -> [S; 1] {
        self.events(t, q, qd, qdd, lambda)
    }
    #[inline(always)]
    fn drawing(&self, t: S, q: &[S; 3]) -> [S; 8] {
        self.drawing(t, q)
    }
    #[inline(always)]
    fn initial(&self) -> sim_kernel::Initial<[S; 3]> {
        self.initial()
    }
}
#[allow(clippy::all, clippy::pedantic)]
impl<S: sim_kernel::Scalar> sim_kernel::Compiled<S> for Skate<S> {
    const DESCRIPTION: sim_kernel::Description = sim_kernel::Description {
        name: "skate",
        type_name: "Skate",
        docs: "A skate on sloping ice, let go turning: a cycloid across the slope.",
        declaration: "/// A skate on sloping ice, let go turning: a cycloid across the slope.\npub Skate;\n\ncoordinates {\n    /// Where the blade touches the ice, down the slope.\n    x [m];\n    /// And across it.\n    y [m];\n    /// Direction of the blade, from straight down.\n    phi [rad];\n}\n\nparameters {\n    m [kg] = 2;\n    /// Moment of inertia about the centre of mass.\n    J [kg*m^2] = 0.05;\n    /// How far the centre of mass is ahead of the blade.\n    a [m] = 0;\n    slope [deg] = 5;\n    g [m/s^2] = 9.81;\n}\n\nlet P = [x, y];\nlet along = [cos(phi), sin(phi)];\nlet across = [-sin(phi), cos(phi)];\nlet G = P + a*along;\n\nbodies { skate: mass m at G, inertia J, angle phi; }\nloads { gravity [g*sin(slope), 0]; }\n\nconstraints {\n    /// The blade does not slip sideways.\n    blade: inner(dot(P), across) = 0;\n}\n\ninitial { x = 0; y = 0; phi = 0; dot(phi) = 3; }\n\nevents {\n    /// The skate stands still and turns.\n    turn: inner(dot(P), along) = 0;\n}\n\noutputs {\n    /// Speed along the blade\n    speed [m/s] = inner(dot(P), along);\n    /// Force of the skate on the ice, to its left\n    side_force [N] = reaction(blade);\n}\n\ndrawing {\n    line P - 0.15 [m]*along, P + 0.15 [m]*along;\n    point P, G;\n}\n",
        declaration_hash: "688ab7a971cb93681a34bb97f8a8d691",
        coordinates: &[
            sim_kernel::Coordinate {
                position: sim_kernel::Quantity {
                    name: "x",
                    unit: "m",
                    factor: 1f64,
                    is_length: true,
                    docs: "Where the blade touches the ice, down the slope.",
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
                    docs: "And across it.",
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
                    name: "phi",
                    unit: "rad",
                    factor: 1f64,
                    is_length: false,
                    docs: "Direction of the blade, from straight down.",
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
        mixes_lengths: true,
        parameters: &[
            sim_kernel::Quantity {
                name: "m",
                unit: "kg",
                factor: 1f64,
                is_length: false,
                docs: "",
            },
            sim_kernel::Quantity {
                name: "J",
                unit: "kg*m^2",
                factor: 1f64,
                is_length: false,
                docs: "Moment of inertia about the centre of mass.",
            },
            sim_kernel::Quantity {
                name: "a",
                unit: "m",
                factor: 1f64,
                is_length: true,
                docs: "How far the centre of mass is ahead of the blade.",
            },
            sim_kernel::Quantity {
                name: "slope",
                unit: "deg",
                factor: 0.017453292519943295f64,
                is_length: false,
                docs: "",
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
                name: "blade",
                unit: "N",
                factor: 1f64,
                is_length: false,
                docs: "",
            },
        ],
        speed_constraints: &[0],
        norm_constraints: &[],
        sparsity: &[],
        common_column: ::core::option::Option::None,
        conditionals: &[],
        events: &[
            sim_kernel::event::Event {
                name: "turn",
                direction: sim_kernel::event::Direction::Both,
                on_motion: true,
                on_forces: false,
                steps: &[],
            },
        ],
        outputs: &[
            sim_kernel::Quantity {
                name: "speed",
                unit: "m/s",
                factor: 1f64,
                is_length: false,
                docs: "Speed along the blade",
            },
            sim_kernel::Quantity {
                name: "side_force",
                unit: "N",
                factor: 1f64,
                is_length: false,
                docs: "Force of the skate on the ice, to its left",
            },
        ],
        rated_outputs: &[0],
        figures: &[
            sim_kernel::Figure {
                name: "speed",
                title: "Speed along the blade",
                len: 1,
            },
            sim_kernel::Figure {
                name: "side_force",
                title: "Force of the skate on the ice, to its left",
                len: 1,
            },
        ],
        optional_kernels: &["dynamics_jacobian"],
        dimension: 2,
        drawing: &[sim_kernel::Shape::Line(2), sim_kernel::Shape::Points(2)],
        run: &[],
        switching: &[],
        load_conditions: &[],
    };
    fn defaults() -> Self {
        Self {
            m: S::from_f64(2f64),
            J: S::from_f64(0.05f64),
            a: S::from_f64(0f64),
            slope: S::from_f64(0.08726646259971647f64),
            g: S::from_f64(9.81f64),
        }
    }
}
