/// A rotor in two gimbals that precesses under a weight on the inner one and, unless `blow` is 0, nods.
///
/// The fields are its parameters, in SI units; the methods are its kernels.
///
/// # Equations of motion
///
/// ```text
/// mass_matrix * accelerations = generalized_forces - convective_forces
/// coordinates = [turn; rise; spin]
/// [
///     mass_matrix[1, 1], 0, M*r^2*sin(rise)/2;
///     0, N_less_B, 0;
///     M*r^2*sin(rise)/2, 0, C
/// ] * [turn_ddot; rise_ddot; spin_ddot] = [
///     -convective_forces[1];
///     -m*l*g*cos(rise) - convective_forces[2];
///     -M*r^2*turn_dot*rise_dot*cos(rise)/2
/// ]
///
/// mass_matrix = [
///     mass_matrix[1, 1], 0, M*r^2*sin(rise)/2;
///     0, N_less_B, 0;
///     M*r^2*sin(rise)/2, 0, C
/// ]
/// mass_matrix[1, 1] = M*r^2/4 + inner_ring + outer_ring/2 + m*l^2*cos(rise)^2
///     - inner_mass*inner_radius^2*sin(rise)^2/2 + M*r^2*sin(rise)^2/4
///
/// convective_forces = [
///     convective_forces[1];
///     convective_forces[2];
///     M*r^2*turn_dot*rise_dot*cos(rise)/2
/// ]
/// convective_forces[1] = m*l*s_2*sin(turn)*cos(rise)
///     - inner_mass*inner_radius^2*turn_dot*rise_dot*sin(rise)*cos(rise)
///     - m*l*s_1*cos(turn)*cos(rise) + s_3*cos(rise)*sin(spin)/4
///     + M*r^2*turn_dot*rise_dot*sin(rise)*cos(rise)/2 + s_4*cos(rise)*cos(spin)/4
/// convective_forces[2] = inner_mass*inner_radius^2*turn_dot^2*sin(rise)*cos(rise)/2
///     + m*l*s_1*sin(turn)*sin(rise) + m*l*s_2*cos(turn)*sin(rise)
///     - m*l^2*rise_dot^2*sin(rise)*cos(rise) - s_3*cos(spin)/4 + s_4*sin(spin)/4
///
/// generalized_forces = [0; -m*l*g*cos(rise); 0]
///
/// w_x = rise_dot*cos(spin) - turn_dot*cos(rise)*sin(spin)
/// w_z = rise_dot*sin(spin) + turn_dot*cos(rise)*cos(spin)
/// w_y = spin_dot + turn_dot*sin(rise)
/// C = M*r^2/2
/// inner_ring = inner_mass*inner_radius^2
/// outer_ring = outer_mass*outer_radius^2
/// N_less_B = M*r^2/4 + inner_ring/2 + m*l^2
/// s_1 = 2*l*turn_dot*rise_dot*cos(turn)*sin(rise) + l*rise_dot^2*sin(turn)*cos(rise)
///     + l*turn_dot^2*sin(turn)*cos(rise)
/// s_2 = l*turn_dot^2*cos(turn)*cos(rise) - 2*l*turn_dot*rise_dot*sin(turn)*sin(rise)
///     + l*rise_dot^2*cos(turn)*cos(rise)
/// s_3 = M*r^2*w_z*w_y + M*r^2*(w_z*spin_dot - turn_dot*rise_dot*sin(rise)*sin(spin))
/// s_4 = M*r^2*w_x*w_y + M*r^2*(w_x*spin_dot - turn_dot*rise_dot*sin(rise)*cos(spin))
/// ```
#[allow(non_snake_case)]
#[derive(
    ::core::clone::Clone,
    ::core::marker::Copy,
    ::core::fmt::Debug,
    ::core::cmp::PartialEq
)]
pub struct Gyroscope<S = ::core::primitive::f64> {
    /// Mass of the rotor, a disc, in `kg`.
    pub M: S,
    /// Its radius, in `m`.
    pub r: S,
    /// Mass of the inner gimbal, a ring, in `kg`.
    pub inner_mass: S,
    /// Its radius, in `m`.
    pub inner_radius: S,
    /// Mass of the outer gimbal, a ring, in `kg`.
    pub outer_mass: S,
    /// Its radius, in `m`.
    pub outer_radius: S,
    /// Mass of the weight on the inner gimbal, in `kg`.
    pub m: S,
    /// Its distance from the centre, on the rotor's axis, in `m`.
    pub l: S,
    /// In `m/s^2`.
    pub g: S,
    /// Rise of the rotor's axis at the start, in `1`.
    pub rise0: S,
    /// Angular velocity of the rotor along its axis, in `rad/s`.
    pub own_spin: S,
    /// Speed of the inner gimbal at the start, after a blow, in `rad/s`.
    pub blow: S,
}
impl<S: sim_kernel::Scalar> ::core::default::Default for Gyroscope<S> {
    /// The declared values.
    fn default() -> Self {
        <Self as sim_kernel::Mechanism<S>>::defaults()
    }
}
/// Coordinates of [`Gyroscope`] by name, in SI units; also for their speeds and accelerations.
#[allow(non_snake_case)]
#[derive(
    ::core::clone::Clone,
    ::core::marker::Copy,
    ::core::fmt::Debug,
    ::core::cmp::PartialEq
)]
pub struct GyroscopeCoordinates<S = ::core::primitive::f64> {
    /// Turn of the outer gimbal about the vertical.
    /// Turn of `outer_gimbal` against `ground`, in `rad`.
    pub turn: S,
    /// Rise of the rotor's axis over the horizontal.
    /// Turn of `inner_gimbal` against `outer_gimbal`, in `rad`.
    pub rise: S,
    /// Turn of the rotor in the inner gimbal.
    /// Turn of `rotor` against `inner_gimbal`, in `rad`.
    pub spin: S,
}
impl<S: sim_kernel::Scalar> ::core::convert::From<[S; 3]> for GyroscopeCoordinates<S> {
    fn from(values: [S; 3]) -> Self {
        Self {
            turn: values[0],
            rise: values[1],
            spin: values[2],
        }
    }
}
impl<S: sim_kernel::Scalar> ::core::convert::From<GyroscopeCoordinates<S>> for [S; 3] {
    fn from(record: GyroscopeCoordinates<S>) -> Self {
        [record.turn, record.rise, record.spin]
    }
}
/// Outputs of [`Gyroscope`] by name, in SI units.
#[allow(non_snake_case)]
#[derive(
    ::core::clone::Clone,
    ::core::marker::Copy,
    ::core::fmt::Debug,
    ::core::cmp::PartialEq
)]
pub struct GyroscopeOutputs<S = ::core::primitive::f64> {
    /// rate of precession, in `rad/s`.
    pub precession: S,
    /// rise of the rotor's axis, in `1`.
    pub elevation: S,
    /// along its axis, in the world, in `rad/s`.
    pub along_axis: S,
    /// in the inner gimbal, in `rad/s`.
    pub in_gimbal: S,
    /// moment of the gimbals on the rotor, in `N*m`.
    pub moment: S,
}
impl<S: sim_kernel::Scalar> ::core::convert::From<[S; 5]> for GyroscopeOutputs<S> {
    fn from(values: [S; 5]) -> Self {
        Self {
            precession: values[0],
            elevation: values[1],
            along_axis: values[2],
            in_gimbal: values[3],
            moment: values[4],
        }
    }
}
impl<S: sim_kernel::Scalar> ::core::convert::From<GyroscopeOutputs<S>> for [S; 5] {
    fn from(record: GyroscopeOutputs<S>) -> Self {
        [
            record.precession,
            record.elevation,
            record.along_axis,
            record.in_gimbal,
            record.moment,
        ]
    }
}
/// Rates of the outputs of [`Gyroscope`] by name, in SI units.
#[allow(non_snake_case)]
#[derive(
    ::core::clone::Clone,
    ::core::marker::Copy,
    ::core::fmt::Debug,
    ::core::cmp::PartialEq
)]
pub struct GyroscopeOutputRates<S = ::core::primitive::f64> {
    /// Rate of `precession`.
    pub precession: S,
    /// Rate of `elevation`.
    pub elevation: S,
    /// Rate of `along_axis`.
    pub along_axis: S,
    /// Rate of `in_gimbal`.
    pub in_gimbal: S,
}
impl<S: sim_kernel::Scalar> ::core::convert::From<[S; 4]> for GyroscopeOutputRates<S> {
    fn from(values: [S; 4]) -> Self {
        Self {
            precession: values[0],
            elevation: values[1],
            along_axis: values[2],
            in_gimbal: values[3],
        }
    }
}
impl<S: sim_kernel::Scalar> ::core::convert::From<GyroscopeOutputRates<S>> for [S; 4] {
    fn from(record: GyroscopeOutputRates<S>) -> Self {
        [record.precession, record.elevation, record.along_axis, record.in_gimbal]
    }
}
/// What the equations of motion need of the parameters of [`Gyroscope`], from [`Gyroscope::prepare`]; its methods are the kernels of each step.
#[allow(non_snake_case)]
#[derive(
    ::core::clone::Clone,
    ::core::marker::Copy,
    ::core::fmt::Debug,
    ::core::cmp::PartialEq
)]
pub struct GyroscopePrepared<S = ::core::primitive::f64> {
    l: S,
    k: S,
    k_2: S,
    k_3: S,
    k_4: S,
    k_5: S,
    N_less_B: S,
    C_: S,
    k_6: S,
    k_7: S,
    k_8: S,
    k_9: S,
    k_10: S,
    k_11: S,
    k_12: S,
    k_13: S,
    k_14: S,
    inverse_rise: S,
    k_15: S,
    k_16: S,
    k_17: S,
}
#[allow(non_snake_case, unused_variables, unused_parens, clippy::all, clippy::pedantic)]
impl<S: sim_kernel::Scalar> Gyroscope<S> {
    /// What the equations of motion need of the parameters, computed once for a set of parameters.
    ///
    /// Operations: 13 additions, 20 multiplications, 1 division.
    #[inline]
    pub fn prepare(&self) -> GyroscopePrepared<S> {
        let w = self.inner_mass * self.inner_radius * self.inner_radius;
        let w_2 = self.m * self.l * self.l;
        let w_3 = S::from_f64(0.5) * w;
        let w_4 = self.M * self.r * self.r;
        let w_5 = S::from_f64(0.25) * w_4;
        let N_less_B = w_5 + w_3 + w_2;
        let C_ = S::from_f64(0.5) * w_4;
        let w_6 = self.m * self.l;
        let w_7 = w_2 * S::from_f64(2.0);
        let w_8 = w * S::from_f64(2.0);
        GyroscopePrepared {
            l: self.l,
            k: w,
            k_2: w_2,
            k_3: w_3,
            k_4: w_5 + w
                + S::from_f64(0.5) * self.outer_mass * self.outer_radius
                    * self.outer_radius,
            k_5: w_5 - w_3,
            N_less_B: N_less_B,
            C_: C_,
            k_6: self.l * S::from_f64(2.0),
            k_7: w_4,
            k_8: w_6,
            k_9: w - C_,
            k_10: w_7,
            k_11: w - C_ + w_7,
            k_12: self.m * self.g,
            k_13: w_6 * self.g,
            k_14: w_5 - w_3 - w_2,
            inverse_rise: S::from_f64(1.0) / N_less_B,
            k_15: w_2 * S::from_f64(4.0) + w_8 - w_4,
            k_16: w_4 - w_8,
            k_17: S::from_f64(2.0) * w_6,
        }
    }
    /// Mass matrix `T_q' M T_q`, 3 x 3, symmetric, in SI units.
    ///
    /// Operations: 7 additions, 19 multiplications, 1 sine-cosine pair.
    #[inline]
    pub fn mass_matrix(&self, t: S, q: &[S; 3]) -> [[S; 3]; 3] {
        let [_, rise, _] = *q;
        let r_squared = self.r * self.r;
        let w = S::from_f64(0.25) * self.M * r_squared;
        let inner_radius_squared = self.inner_radius * self.inner_radius;
        let ([sin_rise], [cos_rise]) = S::sin_cos_each([rise]);
        let w_2 = self.m * self.l * self.l;
        let w_3 = self.inner_mass * inner_radius_squared * S::from_f64(0.5);
        let C_ = self.M * r_squared * S::from_f64(0.5);
        let mass_spin_turn = sin_rise * C_;
        [
            [
                w + self.inner_mass * inner_radius_squared
                    + S::from_f64(0.5) * self.outer_mass * self.outer_radius
                        * self.outer_radius + cos_rise * cos_rise * w_2
                    + sin_rise * sin_rise * (w - w_3),
                S::from_f64(0.0),
                mass_spin_turn,
            ],
            [S::from_f64(0.0), w + w_3 + w_2, S::from_f64(0.0)],
            [mass_spin_turn, S::from_f64(0.0), C_],
        ]
    }
    /// Convective forces `T_q' M g`, 3, with `g = (T_q q' + T_t)_q q' + (..)_t`: joules per unit of each coordinate.
    ///
    /// Operations: 6 additions, 27 multiplications, 1 sine-cosine pair.
    #[inline]
    pub fn convective_forces(&self, t: S, q: &[S; 3], qd: &[S; 3]) -> [S; 3] {
        let [_, rise, _] = *q;
        let [turn_dot, rise_dot, spin_dot] = *qd;
        let ([sin_rise], [cos_rise]) = S::sin_cos_each([rise]);
        let r_squared = self.r * self.r;
        let w = self.M * r_squared * S::from_f64(0.5);
        let inner_radius_squared = self.inner_radius * self.inner_radius;
        let l_squared = self.l * self.l;
        [
            cos_rise * rise_dot
                * (turn_dot * sin_rise
                    * (w - self.inner_mass * inner_radius_squared
                        - self.m * S::from_f64(2.0) * l_squared) + spin_dot * w),
            cos_rise
                * (turn_dot * turn_dot * sin_rise
                    * (self.inner_mass * inner_radius_squared * S::from_f64(0.5)
                        + self.m * l_squared - S::from_f64(0.25) * self.M * r_squared)
                    - turn_dot * spin_dot * w),
            cos_rise * turn_dot * rise_dot * w,
        ]
    }
    /// Generalised forces `T_q' F`, 3: joules per unit of each coordinate.
    ///
    /// Operations: 1 addition, 3 multiplications, 1 sine-cosine pair.
    #[inline]
    pub fn generalized_forces(&self, t: S, q: &[S; 3], qd: &[S; 3]) -> [S; 3] {
        let [_, rise, _] = *q;
        let ([_], [cos_rise]) = S::sin_cos_each([rise]);
        [S::from_f64(0.0), -(cos_rise * self.m * self.l * self.g), S::from_f64(0.0)]
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
    /// Operations: 14 additions, 45 multiplications, 3 sine-cosine pairs.
    #[inline]
    pub fn kinetic_energy(&self, t: S, q: &[S; 3], qd: &[S; 3]) -> S {
        let [turn, rise, spin] = *q;
        let [turn_dot, rise_dot, spin_dot] = *qd;
        let w = S::from_f64(0.5) * self.m;
        let ([sin_turn, sin_rise, sin_spin], [cos_turn, cos_rise, cos_spin]) = S::sin_cos_each([
            turn,
            rise,
            spin,
        ]);
        let w_2 = rise_dot * sin_rise;
        let w_3 = turn_dot * cos_rise;
        let w_4 = self.l * (sin_turn * w_2 - cos_turn * w_3);
        let w_5 = self.l * (sin_turn * w_3 + cos_turn * w_2);
        let inner_radius_squared = self.inner_radius * self.inner_radius;
        let w_6 = S::from_f64(0.25) * self.inner_mass * inner_radius_squared;
        let w_7 = rise_dot * rise_dot
            * (w_6 + cos_rise * cos_rise * self.l * self.l * w);
        let w_8 = turn_dot * turn_dot
            * (S::from_f64(0.25) * self.outer_mass * self.outer_radius
                * self.outer_radius
                + S::from_f64(0.5) * self.inner_mass * inner_radius_squared
                - sin_rise * sin_rise * w_6);
        let r_squared = self.r * self.r;
        let w_x = rise_dot * cos_spin - w_3 * sin_spin;
        let w_z = rise_dot * sin_spin + w_3 * cos_spin;
        let w_y = spin_dot + sin_rise * turn_dot;
        w * (w_4 * w_4 + w_5 * w_5) + w_7 + w_8
            + S::from_f64(0.125) * self.M * r_squared * (w_x * w_x + w_z * w_z)
            + w_y * w_y * S::from_f64(0.25) * self.M * r_squared
    }
    /// Power of loads and drives, `F' v + lambda' C_t + T_t' (M x'' - F)`, in watts.
    ///
    /// Operations: 1 addition, 4 multiplications, 1 sine-cosine pair.
    #[inline]
    pub fn power(
        &self,
        t: S,
        q: &[S; 3],
        qd: &[S; 3],
        qdd: &[S; 3],
        lambda: &[S; 0],
    ) -> S {
        let [_, rise, _] = *q;
        let [_, rise_dot, _] = *qd;
        let ([_], [cos_rise]) = S::sin_cos_each([rise]);
        -(rise_dot * cos_rise * self.m * self.l * self.g)
    }
    /// Outputs, 5, in SI units.
    ///
    /// Operations: 14 additions, 32 multiplications, 2 sine-cosine pairs, 1 square root.
    #[inline]
    pub fn outputs(
        &self,
        t: S,
        q: &[S; 3],
        qd: &[S; 3],
        qdd: &[S; 3],
        lambda: &[S; 0],
    ) -> GyroscopeOutputs<S> {
        let [_, rise, spin] = *q;
        let [turn_dot, rise_dot, spin_dot] = *qd;
        let [turn_ddot, rise_ddot, spin_ddot] = *qdd;
        let ([sin_rise, sin_spin], [cos_rise, cos_spin]) = S::sin_cos_each([rise, spin]);
        let w = turn_dot * sin_rise;
        let w_y = spin_dot + w;
        let r_squared = self.r * self.r;
        let w_2 = self.M * r_squared;
        let w_3 = rise_dot * (w - spin_dot) - turn_ddot * cos_rise;
        let w_4 = rise_ddot - turn_dot * spin_dot * cos_rise;
        let w_5 = turn_dot * cos_rise;
        let w_6 = w_2
            * (sin_spin * w_3 + cos_spin * w_4
                - w_y * (rise_dot * sin_spin + cos_spin * w_5));
        let w_7 = w_2
            * (sin_spin * w_4 - cos_spin * w_3
                + w_y * (cos_spin * rise_dot - sin_spin * w_5));
        let w_8 = spin_ddot + turn_dot * rise_dot * cos_rise + sin_rise * turn_ddot;
        [
            turn_dot,
            rise,
            w_y,
            spin_dot,
            (S::from_f64(0.0625) * (w_6 * w_6 + w_7 * w_7)
                + w_8 * w_8 * S::from_f64(0.25) * self.M * self.M * r_squared
                    * r_squared)
                .sqrt(),
        ]
            .into()
    }
    /// Rates of the outputs that depend on neither accelerations nor multipliers, 4, in SI units per second.
    ///
    /// Operations: 2 additions, 3 multiplications, 1 sine-cosine pair.
    #[inline]
    pub fn output_rates(
        &self,
        t: S,
        q: &[S; 3],
        qd: &[S; 3],
        qdd: &[S; 3],
    ) -> GyroscopeOutputRates<S> {
        let [_, rise, _] = *q;
        let [turn_dot, rise_dot, _] = *qd;
        let [turn_ddot, _, spin_ddot] = *qdd;
        let ([sin_rise], [cos_rise]) = S::sin_cos_each([rise]);
        [
            turn_ddot,
            rise_dot,
            spin_ddot + rise_dot * turn_dot * cos_rise + turn_ddot * sin_rise,
            spin_ddot,
        ]
            .into()
    }
    /// `left - right` of each event, 2, in SI units: zero when it happens.
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
    ) -> [S; 2] {
        let [turn, _, _] = *q;
        let [_, rise_dot, _] = *qd;
        let ([w], [_]) = S::sin_cos_each([S::from_f64(0.5) * turn]);
        [w, rise_dot]
    }
    /// The numbers of each shape of the drawing, in metres and radians.
    ///
    /// Operations: 17 additions, 23 multiplications, 3 sine-cosine pairs.
    #[inline]
    pub fn drawing(&self, t: S, q: &[S; 3]) -> [S; 57] {
        let [turn, rise, spin] = *q;
        let w = -(S::from_f64(1.15) * self.outer_radius);
        let ([sin_turn, sin_rise, sin_spin], [cos_turn, cos_rise, cos_spin]) = S::sin_cos_each([
            turn,
            rise,
            spin,
        ]);
        let w_2 = self.outer_radius * cos_turn;
        let w_3 = self.outer_radius * sin_turn;
        let w_4 = cos_turn * self.inner_radius;
        let w_5 = sin_turn * self.inner_radius;
        let w_6 = sin_turn * sin_rise;
        let w_7 = cos_turn * sin_rise;
        let w_8 = sin_turn * cos_rise;
        let w_9 = cos_turn * cos_rise;
        let w_10 = -(w_8 * self.l);
        let w_11 = w_9 * self.l;
        let w_12 = sin_rise * self.l;
        let w_13 = self.r * (cos_turn * cos_spin - w_6 * sin_spin);
        let w_14 = self.r * (sin_turn * cos_spin + w_7 * sin_spin);
        let w_15 = cos_rise * self.r * sin_spin;
        [
            S::from_f64(0.0),
            S::from_f64(0.0),
            w,
            S::from_f64(0.0),
            S::from_f64(0.0),
            w,
            S::from_f64(0.0),
            S::from_f64(0.0),
            -self.outer_radius,
            S::from_f64(0.0),
            S::from_f64(0.0),
            S::from_f64(0.0),
            self.outer_radius,
            -sin_turn,
            cos_turn,
            S::from_f64(0.0),
            -w_2,
            -w_3,
            S::from_f64(0.0),
            -w_4,
            -w_5,
            S::from_f64(0.0),
            w_4,
            w_5,
            S::from_f64(0.0),
            w_2,
            w_3,
            S::from_f64(0.0),
            S::from_f64(0.0),
            S::from_f64(0.0),
            S::from_f64(0.0),
            self.inner_radius,
            w_6,
            -w_7,
            cos_rise,
            self.inner_radius * w_8,
            -(self.inner_radius * w_9),
            -(self.inner_radius * sin_rise),
            w_10,
            w_11,
            w_12,
            S::from_f64(0.0),
            S::from_f64(0.0),
            S::from_f64(0.0),
            self.r,
            -w_8,
            w_9,
            sin_rise,
            -w_13,
            -w_14,
            w_15,
            w_13,
            w_14,
            -w_15,
            w_10,
            w_11,
            w_12,
        ]
    }
    /// Declared start: values or guesses of the coordinates (3), and speeds (3), in SI units; 0 where nothing is declared.
    ///
    /// Operations: 5 additions, 23 multiplications, 2 divisions, 1 sine-cosine pair, 1 square root.
    #[inline]
    pub fn initial(&self) -> sim_kernel::Initial<[S; 3]> {
        let w = S::from_f64(4.0) * self.m;
        let w_2 = self.l * self.g;
        let w_3 = w * w_2;
        let r_squared = self.r * self.r;
        let ([sin_rise0], [_]) = S::sin_cos_each([self.rise0]);
        let w_4 = self.m
            * (self.M * r_squared
                + S::from_f64(2.0) * self.inner_mass * self.inner_radius
                    * self.inner_radius + self.l * self.l * w) * sin_rise0 * w_2;
        let w_5 = S::from_f64(2.0)
            * (S::from_f64(0.25) * self.M * self.M * r_squared * r_squared
                * self.own_spin * self.own_spin - w_4)
                .sqrt() + self.M * r_squared * self.own_spin;
        sim_kernel::Initial {
            positions: [S::from_f64(0.0), self.rise0, S::from_f64(0.0)],
            speeds: [w_3 / w_5, self.blow, self.own_spin - sin_rise0 * w_3 / w_5],
        }
    }
    /// [`GyroscopePrepared::dynamics`] once; for many calls with the same parameters [`Self::prepare`] first.
    #[inline]
    pub fn dynamics(
        &self,
        t: S,
        q: &[S; 3],
        qd: &[S; 3],
    ) -> sim_kernel::Dynamics<S, [S; 3], [S; 0]> {
        self.prepare().dynamics(t, q, qd)
    }
    /// [`GyroscopePrepared::dynamics_jacobian`] once; for many calls with the same parameters [`Self::prepare`] first.
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
impl<S: sim_kernel::Scalar> GyroscopePrepared<S> {
    /// Accelerations (3), multipliers (0) and power, from
    ///
    /// ```text
    /// [ T_q' M T_q   C_q' ] [ q''    ]   [ T_q' (F - M g)                      ]
    /// [ C_q          0    ] [ lambda ] = [ -(C_q q' + C_t)_q q' - (..)_t       ]
    /// ```
    ///
    /// by an elimination planned from the structure of the system. Where `refused` is set a pivot was too small and nothing else holds: solve that state from the other kernels.
    ///
    /// Operations: 10 additions, 27 multiplications, 2 divisions, 1 sine-cosine pair.
    #[inline(always)]
    pub fn dynamics(
        &self,
        t: S,
        q: &[S; 3],
        qd: &[S; 3],
    ) -> sim_kernel::Dynamics<S, [S; 3], [S; 0]> {
        let [_, rise, _] = *q;
        let [turn_dot, rise_dot, spin_dot] = *qd;
        let ([sin_rise], [cos_rise]) = S::sin_cos_each([rise]);
        let rhs_turn = cos_rise * rise_dot
            * (sin_rise * turn_dot * self.k_11 - self.C_ * spin_dot);
        let w = self.C_ * turn_dot;
        let mass_turn_turn = self.k_4 + cos_rise * cos_rise * self.k_2
            + sin_rise * sin_rise * self.k_5;
        let inverse_turn = S::from_f64(1.0) / mass_turn_turn;
        let mass_spin_turn = sin_rise * self.C_;
        let l_spin_turn = mass_spin_turn * inverse_turn;
        let pivot_spin = self.C_ - mass_spin_turn * l_spin_turn;
        let minus_spin_ddot = S::from_f64(1.0) / pivot_spin
            * (cos_rise * rise_dot * w + rhs_turn * l_spin_turn);
        sim_kernel::Dynamics {
            accelerations: [
                rhs_turn * inverse_turn + l_spin_turn * minus_spin_ddot,
                cos_rise
                    * (sin_rise * turn_dot * turn_dot * self.k_14 - self.k_13
                        + spin_dot * w) * self.inverse_rise,
                -minus_spin_ddot,
            ],
            multipliers: [],
            power: -(cos_rise * rise_dot * self.k_13),
            refused: sim_kernel::pivot_is_refused(mass_turn_turn, mass_turn_turn)
                | sim_kernel::pivot_is_refused(self.N_less_B, self.N_less_B)
                | sim_kernel::pivot_is_refused(pivot_spin, self.C_),
        }
    }
    /// The derivatives of accelerations (3 rows) and multipliers (0 rows) with respect to coordinates and speeds (3 columns each): with the equations of motion as `K z = r`, the solutions of `K dz = dr - dK z`. Where `refused` is set a pivot was too small and nothing else holds.
    ///
    /// Operations: 87 additions, 196 multiplications, 2 divisions, 3 sine-cosine pairs.
    #[inline]
    pub fn dynamics_jacobian(
        &self,
        t: S,
        q: &[S; 3],
        qd: &[S; 3],
    ) -> sim_kernel::DynamicsJacobian<S, [[S; 3]; 3], [[S; 3]; 0]> {
        let [turn, rise, spin] = *q;
        let [turn_dot, rise_dot, spin_dot] = *qd;
        let ([sin_rise, sin_turn, sin_spin], [cos_rise, cos_turn, cos_spin]) = S::sin_cos_each([
            rise,
            turn,
            spin,
        ]);
        let w = sin_rise * turn_dot;
        let rhs_turn = cos_rise * rise_dot * (w * self.k_11 - self.C_ * spin_dot);
        let w_2 = cos_rise * cos_rise * self.k_2;
        let sin_rise_squared = sin_rise * sin_rise;
        let mass_turn_turn = self.k_4 + w_2 + sin_rise_squared * self.k_5;
        let inverse_turn = S::from_f64(1.0) / mass_turn_turn;
        let turn_dot_squared = turn_dot * turn_dot;
        let rise_dot_squared = rise_dot * rise_dot;
        let w_3 = turn_dot_squared + rise_dot_squared;
        let w_4 = cos_turn * w_3;
        let w_11 = sin_turn * w_3;
        let w_5 = self.l * sin_rise;
        let w_6 = sin_turn * self.k_6;
        let w_7 = cos_rise * turn_dot;
        let w_8 = rise_dot * w_7;
        let w_9 = w_4 * w_5 + w_6 * w_8;
        let w_10 = cos_turn * self.k_6;
        let w_12 = w_10 * w_8 - w_11 * w_5;
        let w_z = rise_dot * sin_spin + cos_spin * w_7;
        let w_y = spin_dot + w;
        let w_13 = cos_spin * w_y;
        let w_14 = sin_rise * spin_dot;
        let w_15 = cos_rise * rise_dot;
        let w_16 = self.k_7
            * (turn_dot * (cos_rise * w_z - sin_rise * w_13)
                - turn_dot * (cos_spin * w_14 + sin_spin * w_15));
        let w_17 = sin_spin * w_y;
        let w_x = rise_dot * cos_spin - sin_spin * w_7;
        let w_18 = self.k_7
            * (turn_dot * (sin_spin * w_14 - cos_spin * w_15)
                + turn_dot * (sin_rise * w_17 + cos_rise * w_x));
        let mass_spin_turn = sin_rise * self.C_;
        let l_spin_turn = mass_spin_turn * inverse_turn;
        let pivot_spin = self.C_ - mass_spin_turn * l_spin_turn;
        let inverse_spin = S::from_f64(1.0) / pivot_spin;
        let minus_spin_ddot = inverse_spin * (self.C_ * w_8 + rhs_turn * l_spin_turn);
        let turn_ddot = rhs_turn * inverse_turn + l_spin_turn * minus_spin_ddot;
        let w_19 = cos_rise
            * (self.k_8 * (sin_turn * w_9 + cos_turn * w_12)
                - S::from_f64(0.25) * (sin_spin * w_16 + cos_spin * w_18)
                + self.C_ * minus_spin_ddot);
        let w_20 = rise_dot * w;
        let w_21 = sin_spin * self.k_7 * (w_z * spin_dot - w_20 * sin_spin + w_z * w_y)
            + cos_spin * self.k_7 * (spin_dot * w_x - w_20 * cos_spin + w_y * w_x);
        let w_22 = w_20 * w_10 + self.l * cos_rise * w_11;
        let w_23 = self.l * cos_rise * w_4 - w_20 * w_6;
        let w_24 = sin_rise
            * (S::from_f64(0.25) * w_21
                - self.k_8 * (cos_turn * w_22 - sin_turn * w_23));
        let w_25 = w_19 + w_24
            + turn_dot * rise_dot * (self.k_9 + sin_rise_squared * self.k_16)
            + S::from_f64(0.5) * turn_ddot * cos_rise * sin_rise * self.k_15;
        let w_26 = inverse_spin
            * (self.C_ * (w_20 - cos_rise * turn_ddot) - l_spin_turn * w_25);
        let w_27 = self.k_8
            * (sin_rise * (cos_turn * w_9 - sin_turn * w_12)
                - cos_rise * (sin_turn * w_22 + cos_turn * w_23));
        let w_28 = w_27 + turn_dot_squared * (sin_rise_squared * self.k - self.k_3)
            + S::from_f64(0.25) * (cos_spin * w_16 - sin_spin * w_18)
            + w_2 * rise_dot_squared
            + (self.k_12 - sin_rise * rise_dot_squared * self.k_8) * w_5;
        let w_29 = sin_rise * rise_dot;
        let w_30 = self.l * (sin_turn * w_29 - cos_turn * w_7);
        let w_31 = self.l * (sin_turn * w_7 + cos_turn * w_29);
        let w_32 = cos_rise * spin_dot;
        let w_33 = self.k_7
            * (cos_spin * w_32 - sin_spin * w_29 + cos_rise * w_13 + sin_rise * w_z);
        let w_34 = self.k_7
            * (sin_rise * w_x - (sin_spin * w_32 + cos_spin * w_29) - cos_rise * w_17);
        let w_35 = cos_rise
            * (self.k_17 * (sin_turn * w_30 + cos_turn * w_31)
                - S::from_f64(0.25) * (sin_spin * w_33 + cos_spin * w_34)
                + self.k_9 * w_29);
        let w_36 = inverse_spin * (self.C_ * w_15 + l_spin_turn * w_35);
        let w_37 = self.l * (sin_turn * w - cos_turn * w_15);
        let w_38 = self.l * (cos_turn * w + sin_turn * w_15);
        let w_39 = w - spin_dot;
        let w_40 = self.k_7 * (w_17 - sin_spin * w_39);
        let w_41 = self.k_7 * (w_13 - cos_spin * w_39);
        let w_42 = cos_rise
            * (self.k_17 * (sin_turn * w_37 + cos_turn * w_38)
                - S::from_f64(0.25) * (sin_spin * w_40 + cos_spin * w_41)
                + w * self.k_9);
        let w_43 = inverse_spin * (self.C_ * w_7 + l_spin_turn * w_42);
        let w_44 = self.C_ * cos_rise * (sin_spin * w_z + cos_spin * w_x);
        let w_45 = inverse_spin * l_spin_turn * w_44;
        sim_kernel::DynamicsJacobian {
            accelerations_by_positions: [
                [
                    S::from_f64(0.0),
                    inverse_turn * w_25 - l_spin_turn * w_26,
                    S::from_f64(0.0),
                ],
                [S::from_f64(0.0), self.inverse_rise * w_28, S::from_f64(0.0)],
                [S::from_f64(0.0), w_26, S::from_f64(0.0)],
            ],
            accelerations_by_speeds: [
                [
                    inverse_turn * w_35 + l_spin_turn * w_36,
                    inverse_turn * w_42 + l_spin_turn * w_43,
                    -(inverse_turn * w_44 + l_spin_turn * w_45),
                ],
                [
                    self.inverse_rise
                        * (sin_rise
                            * (self.k_17 * (cos_turn * w_30 - sin_turn * w_31)
                                - self.k * w_7)
                            + S::from_f64(0.25) * (cos_spin * w_33 - sin_spin * w_34)),
                    self.inverse_rise
                        * (sin_rise
                            * (self.k_17 * (cos_turn * w_37 - sin_turn * w_38)
                                + self.k_10 * w_15)
                            + S::from_f64(0.25) * (cos_spin * w_40 - sin_spin * w_41)),
                    self.inverse_rise * self.C_ * (cos_spin * w_z - sin_spin * w_x),
                ],
                [-w_36, -w_43, w_45],
            ],
            multipliers_by_positions: [],
            multipliers_by_speeds: [],
            refused: sim_kernel::pivot_is_refused(mass_turn_turn, mass_turn_turn)
                | sim_kernel::pivot_is_refused(self.N_less_B, self.N_less_B)
                | sim_kernel::pivot_is_refused(pivot_spin, self.C_),
        }
    }
}
#[allow(non_snake_case, clippy::all, clippy::pedantic)]
impl<S: sim_kernel::Scalar> sim_kernel::Mechanism<S> for Gyroscope<S> {
    type Q = [S; 3];
    type L = [S; 0];
    type Z = [S; 3];
    type QQ = [[S; 3]; 3];
    type LQ = [[S; 3]; 0];
    type LL = [[S; 0]; 0];
    type ZZ = [[S; 3]; 3];
    type Entries = [S; 0];
    type Envelope = [S; 0];
    type Parameters = [S; 12];
    type Outputs = [S; 5];
    type OutputRates = [S; 4];
    type Events = [S; 2];
    type EventValues = [S; 0];
    type Activities = [S; 0];
    type Drawing = [S; 57];
    type QP = [[S; 12]; 3];
    type LP = [[S; 12]; 0];
    type Inputs = [sim_kernel::Input<S>; 0];
    type Prepared = GyroscopePrepared<S>;
    type On<T: sim_kernel::Scalar> = Gyroscope<T>;
    const DESCRIPTION: sim_kernel::Description = sim_kernel::Description {
        name: "gyroscope",
        type_name: "Gyroscope",
        docs: "A rotor in two gimbals that precesses under a weight on the inner one and, unless `blow` is 0, nods.",
        declaration: "/// A rotor in two gimbals that precesses under a weight on the inner one and, unless `blow` is 0, nods.\npub Gyroscope;\n\nparameters {\n    /// Mass of the rotor, a disc.\n    M [kg] = 0.3;\n    /// Its radius.\n    r [m] = 0.05;\n    /// Mass of the inner gimbal, a ring.\n    inner_mass [kg] = 0.08;\n    /// Its radius.\n    inner_radius [m] = 0.07;\n    /// Mass of the outer gimbal, a ring.\n    outer_mass [kg] = 0.12;\n    /// Its radius.\n    outer_radius [m] = 0.09;\n    /// Mass of the weight on the inner gimbal.\n    m [kg] = 0.05;\n    /// Its distance from the centre, on the rotor's axis.\n    l [m] = 0.08;\n    g [m/s^2] = 9.81;\n    /// Rise of the rotor's axis at the start.\n    rise0 [deg] = 25;\n    /// Angular velocity of the rotor along its axis.\n    own_spin [rad/s] = 60;\n    /// Speed of the inner gimbal at the start, after a blow.\n    blow [rad/s] = 2;\n}\n\nlet R = attitude(rotor);\nlet w = transpose(R)*omega(rotor);\nlet A = M*r^2/4;\nlet C = M*r^2/2;\nlet inner_ring = inner_mass*inner_radius^2;\nlet outer_ring = outer_mass*outer_radius^2;\nlet H = C*own_spin;\nlet N_less_B = A + inner_ring/2 + m*l^2;\nlet discriminant = H^2 - 4*N_less_B*sin(rise0)*m*g*l;\nlet steady = 2*m*g*l/(H + sqrt(discriminant));\n\nbodies {\n    outer_gimbal: mass outer_mass, inertia [outer_ring/2, outer_ring, outer_ring/2];\n    inner_gimbal: mass inner_mass, inertia [inner_ring/2, inner_ring/2, inner_ring];\n    rotor: mass M, inertia [A, C, A];\n    weight: mass m at on(inner_gimbal, [0, l, 0]);\n}\njoints {\n    /// Turn of the outer gimbal about the vertical.\n    turn: revolute ground at [0, 0, 0] axis [0, 0, 1] to outer_gimbal at [0, 0, 0] axis [0, 0, 1];\n    /// Rise of the rotor's axis over the horizontal.\n    rise: revolute outer_gimbal at [0, 0, 0] axis [1, 0, 0] to inner_gimbal at [0, 0, 0] axis [1, 0, 0];\n    /// Turn of the rotor in the inner gimbal.\n    spin: revolute inner_gimbal at [0, 0, 0] axis [0, 1, 0] to rotor at [0, 0, 0] axis [0, 1, 0];\n}\nloads { gravity [0, 0, -g]; }\n\ninitial {\n    turn = 0;\n    rise = rise0;\n    spin = 0;\n    dot(turn) = steady;\n    dot(rise) = blow;\n    dot(spin) = own_spin - steady*sin(rise0);\n}\n\nevents {\n    period: sin(turn/2) = 0;\n    nutation: dot(rise) = 0;\n}\n\noutputs {\n    /// rate of precession\n    precession [rad/s] = dot(turn);\n    /// rise of the rotor's axis\n    elevation [deg] = rise;\n    spins \"Angular velocity of the rotor\" {\n        /// along its axis, in the world\n        along_axis [rad/s] = w.y;\n        /// in the inner gimbal\n        in_gimbal [rad/s] = dot(spin);\n    }\n    /// moment of the gimbals on the rotor\n    moment [N*m] = norm(dot(R*[A*w.x, C*w.y, A*w.z]));\n}\n\ndrawing {\n    ground [0, 0, -1.15*outer_radius];\n    curve [0, 0, -1.15*outer_radius], [0, 0, -outer_radius];\n    circle [0, 0, 0] radius outer_radius normal attitude(outer_gimbal)*[0, 1, 0];\n    curve on(outer_gimbal, [-outer_radius, 0, 0]), on(inner_gimbal, [-inner_radius, 0, 0]);\n    curve on(inner_gimbal, [inner_radius, 0, 0]), on(outer_gimbal, [outer_radius, 0, 0]);\n    circle [0, 0, 0] radius inner_radius normal attitude(inner_gimbal)*[0, 0, 1];\n    curve on(inner_gimbal, [0, -inner_radius, 0]), on(inner_gimbal, [0, l, 0]);\n    circle [0, 0, 0] radius r normal R*[0, 1, 0];\n    curve on(rotor, [-r, 0, 0]), on(rotor, [r, 0, 0]);\n    point on(inner_gimbal, [0, l, 0]);\n}\n",
        coordinates: &[
            sim_kernel::Coordinate {
                position: sim_kernel::Quantity {
                    name: "turn",
                    unit: "rad",
                    factor: 1f64,
                    is_length: false,
                    docs: "Turn of the outer gimbal about the vertical.\nTurn of `outer_gimbal` against `ground`.",
                },
                speed: sim_kernel::Quantity {
                    name: "turn_dot",
                    unit: "rad/s",
                    factor: 1f64,
                    is_length: false,
                    docs: "",
                },
                acceleration: sim_kernel::Quantity {
                    name: "turn_ddot",
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
                    name: "rise",
                    unit: "rad",
                    factor: 1f64,
                    is_length: false,
                    docs: "Rise of the rotor's axis over the horizontal.\nTurn of `inner_gimbal` against `outer_gimbal`.",
                },
                speed: sim_kernel::Quantity {
                    name: "rise_dot",
                    unit: "rad/s",
                    factor: 1f64,
                    is_length: false,
                    docs: "",
                },
                acceleration: sim_kernel::Quantity {
                    name: "rise_ddot",
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
                    name: "spin",
                    unit: "rad",
                    factor: 1f64,
                    is_length: false,
                    docs: "Turn of the rotor in the inner gimbal.\nTurn of `rotor` against `inner_gimbal`.",
                },
                speed: sim_kernel::Quantity {
                    name: "spin_dot",
                    unit: "rad/s",
                    factor: 1f64,
                    is_length: false,
                    docs: "",
                },
                acceleration: sim_kernel::Quantity {
                    name: "spin_ddot",
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
                docs: "Mass of the rotor, a disc.",
            },
            sim_kernel::Quantity {
                name: "r",
                unit: "m",
                factor: 1f64,
                is_length: true,
                docs: "Its radius.",
            },
            sim_kernel::Quantity {
                name: "inner_mass",
                unit: "kg",
                factor: 1f64,
                is_length: false,
                docs: "Mass of the inner gimbal, a ring.",
            },
            sim_kernel::Quantity {
                name: "inner_radius",
                unit: "m",
                factor: 1f64,
                is_length: true,
                docs: "Its radius.",
            },
            sim_kernel::Quantity {
                name: "outer_mass",
                unit: "kg",
                factor: 1f64,
                is_length: false,
                docs: "Mass of the outer gimbal, a ring.",
            },
            sim_kernel::Quantity {
                name: "outer_radius",
                unit: "m",
                factor: 1f64,
                is_length: true,
                docs: "Its radius.",
            },
            sim_kernel::Quantity {
                name: "m",
                unit: "kg",
                factor: 1f64,
                is_length: false,
                docs: "Mass of the weight on the inner gimbal.",
            },
            sim_kernel::Quantity {
                name: "l",
                unit: "m",
                factor: 1f64,
                is_length: true,
                docs: "Its distance from the centre, on the rotor's axis.",
            },
            sim_kernel::Quantity {
                name: "g",
                unit: "m/s^2",
                factor: 1f64,
                is_length: false,
                docs: "",
            },
            sim_kernel::Quantity {
                name: "rise0",
                unit: "deg",
                factor: 0.017453292519943295f64,
                is_length: false,
                docs: "Rise of the rotor's axis at the start.",
            },
            sim_kernel::Quantity {
                name: "own_spin",
                unit: "rad/s",
                factor: 1f64,
                is_length: false,
                docs: "Angular velocity of the rotor along its axis.",
            },
            sim_kernel::Quantity {
                name: "blow",
                unit: "rad/s",
                factor: 1f64,
                is_length: false,
                docs: "Speed of the inner gimbal at the start, after a blow.",
            },
        ],
        inputs: &[],
        constraints: &[],
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
                name: "nutation",
                direction: sim_kernel::event::Direction::Both,
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
                name: "elevation",
                unit: "deg",
                factor: 0.017453292519943295f64,
                is_length: false,
                docs: "rise of the rotor's axis",
            },
            sim_kernel::Quantity {
                name: "along_axis",
                unit: "rad/s",
                factor: 1f64,
                is_length: false,
                docs: "along its axis, in the world",
            },
            sim_kernel::Quantity {
                name: "in_gimbal",
                unit: "rad/s",
                factor: 1f64,
                is_length: false,
                docs: "in the inner gimbal",
            },
            sim_kernel::Quantity {
                name: "moment",
                unit: "N*m",
                factor: 1f64,
                is_length: false,
                docs: "moment of the gimbals on the rotor",
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
                name: "elevation",
                title: "rise of the rotor's axis",
                len: 1,
            },
            sim_kernel::Figure {
                name: "spins",
                title: "Angular velocity of the rotor",
                len: 2,
            },
            sim_kernel::Figure {
                name: "moment",
                title: "moment of the gimbals on the rotor",
                len: 1,
            },
        ],
        optional_kernels: &["dynamics_jacobian"],
        dimension: 3,
        drawing: &[
            sim_kernel::Shape::Ground(1),
            sim_kernel::Shape::Curve(2),
            sim_kernel::Shape::Circle,
            sim_kernel::Shape::Curve(2),
            sim_kernel::Shape::Curve(2),
            sim_kernel::Shape::Circle,
            sim_kernel::Shape::Curve(2),
            sim_kernel::Shape::Circle,
            sim_kernel::Shape::Curve(2),
            sim_kernel::Shape::Points(1),
        ],
    };
    fn defaults() -> Self {
        Self {
            M: S::from_f64(0.3f64),
            r: S::from_f64(0.05f64),
            inner_mass: S::from_f64(0.08f64),
            inner_radius: S::from_f64(0.07f64),
            outer_mass: S::from_f64(0.12f64),
            outer_radius: S::from_f64(0.09f64),
            m: S::from_f64(0.05f64),
            l: S::from_f64(0.08f64),
            g: S::from_f64(9.81f64),
            rise0: S::from_f64(0.4363323129985824f64),
            own_spin: S::from_f64(60f64),
            blow: S::from_f64(2f64),
        }
    }
    fn parameters(&self) -> [S; 12] {
        [
            self.M,
            self.r,
            self.inner_mass,
            self.inner_radius,
            self.outer_mass,
            self.outer_radius,
            self.m,
            self.l,
            self.g,
            self.rise0,
            self.own_spin,
            self.blow,
        ]
    }
    fn with_parameters(&self, parameters: [S; 12]) -> Self {
        Self {
            M: parameters[0],
            r: parameters[1],
            inner_mass: parameters[2],
            inner_radius: parameters[3],
            outer_mass: parameters[4],
            outer_radius: parameters[5],
            m: parameters[6],
            l: parameters[7],
            g: parameters[8],
            rise0: parameters[9],
            own_spin: parameters[10],
            blow: parameters[11],
            ..*self
        }
    }
    fn on<T: sim_kernel::Scalar>(
        &self,
        convert: impl ::core::ops::Fn(S) -> T,
    ) -> Gyroscope<T> {
        Gyroscope {
            M: convert(self.M),
            r: convert(self.r),
            inner_mass: convert(self.inner_mass),
            inner_radius: convert(self.inner_radius),
            outer_mass: convert(self.outer_mass),
            outer_radius: convert(self.outer_radius),
            m: convert(self.m),
            l: convert(self.l),
            g: convert(self.g),
            rise0: convert(self.rise0),
            own_spin: convert(self.own_spin),
            blow: convert(self.blow),
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
    fn prepare(&self) -> GyroscopePrepared<S> {
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
        lambda: &[S; 0],
    ) -> [S; 2] {
        self.events(t, q, qd, qdd, lambda)
    }
    #[inline(always)]
    fn drawing(&self, t: S, q: &[S; 3]) -> [S; 57] {
        self.drawing(t, q)
    }
    #[inline(always)]
    fn initial(&self) -> sim_kernel::Initial<[S; 3]> {
        self.initial()
    }
}
