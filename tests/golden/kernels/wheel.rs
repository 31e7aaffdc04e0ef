/// A disc that rolls and leans, by the components of its angular velocity in the frame that does not spin with it.
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
/// coordinates = [x; y; psi; lean; phi]
/// multipliers = [lambda_slip_x; lambda_slip_y]
/// constraints = 0
/// [
///     m, 0, 0, 0, 0, 1, 0;
///     0, m, 0, 0, 0, 0, 1;
///     0, 0, mass_matrix[3, 3], 0, mass_matrix[3, 5], constraint_jacobian[1, 3], constraint_jacobian[2, 3];
///     0, 0, 0, mass_matrix[4, 4], 0, constraint_jacobian[1, 4], constraint_jacobian[2, 4];
///     0, 0, mass_matrix[3, 5], 0, m*r^2/2, -r*cos(psi), -r*sin(psi);
///     1, 0, constraint_jacobian[1, 3], constraint_jacobian[1, 4], -r*cos(psi), 0, 0;
///     0, 1, constraint_jacobian[2, 3], constraint_jacobian[2, 4], -r*sin(psi), 0, 0
/// ] * [
///     x_ddot;
///     y_ddot;
///     psi_ddot;
///     lean_ddot;
///     phi_ddot;
///     lambda_slip_x;
///     lambda_slip_y
/// ] = [
///     0;
///     0;
///     -convective_forces[3];
///     m*r*g*sin(lean) - convective_forces[4];
///     -m*r^2*psi_dot*lean_dot*cos(lean)/2;
///     -constraint_convective[1];
///     -constraint_convective[2]
/// ]
///
/// mass_matrix = [
///     m, 0, 0, 0, 0;
///     0, m, 0, 0, 0;
///     0, 0, mass_matrix[3, 3], 0, mass_matrix[3, 5];
///     0, 0, 0, mass_matrix[4, 4], 0;
///     0, 0, mass_matrix[3, 5], 0, m*r^2/2
/// ]
/// mass_matrix[3, 3] = m*r^2/4 + m*r^2*sin(lean)^2/4
/// mass_matrix[3, 5] = m*r^2*sin(lean)/2
/// mass_matrix[4, 4] = m*r^2/4 + m*r^2*sin(lean)^2
///
/// convective_forces = [
///     0;
///     0;
///     convective_forces[3];
///     convective_forces[4];
///     m*r^2*psi_dot*lean_dot*cos(lean)/2
/// ]
/// convective_forces[3] = s_6*cos(lean)*sin(phi)/4 + m*r^2*psi_dot*lean_dot*sin(lean)*cos(lean)/2
///     + s_7*cos(lean)*cos(phi)/4
/// convective_forces[4] = m*r^2*lean_dot^2*sin(lean)*cos(lean) - s_6*cos(phi)/4 + s_7*sin(phi)/4
///
/// generalized_forces = [0; 0; 0; m*r*g*sin(lean); 0]
///
/// constraints = [0; 0]
///
/// constraint_jacobian = [
///     1, 0, constraint_jacobian[1, 3], constraint_jacobian[1, 4], -r*cos(psi);
///     0, 1, constraint_jacobian[2, 3], constraint_jacobian[2, 4], -r*sin(psi)
/// ]
/// constraint_jacobian[1, 3] = -r*cos(psi)*sin(lean)
/// constraint_jacobian[1, 4] = -r*sin(psi)*cos(lean)
/// constraint_jacobian[2, 3] = -r*sin(psi)*sin(lean)
/// constraint_jacobian[2, 4] = r*cos(psi)*cos(lean)
///
/// constraint_convective = [
///     constraint_convective[1];
///     constraint_convective[2]
/// ]
/// constraint_convective[1] = r*s_4*psi_dot*sin(psi)*sin(lean) - r*s_4*lean_dot*cos(psi)*cos(lean)
///     - r*s_10*cos(psi)*sin(lean) - s_13 + r*lean_dot*(w_x*sin(psi) + s_3*cos(psi))*sin(lean)
/// constraint_convective[2] = s_14 - r*s_4*psi_dot*cos(psi)*sin(lean) - r*s_4*lean_dot*sin(psi)*cos(lean)
///     - r*s_10*sin(psi)*sin(lean) - r*lean_dot*(w_x*cos(psi) - s_3*sin(psi))*sin(lean)
///
/// s_1 = lean_dot*cos(phi) - psi_dot*cos(lean)*sin(phi)
/// s_2 = lean_dot*sin(phi) + psi_dot*cos(lean)*cos(phi)
/// w_y = phi_dot + psi_dot*sin(lean)
/// w_x = s_1*cos(phi) + s_2*sin(phi)
/// w_z = s_2*cos(phi) - s_1*sin(phi)
/// s_3 = w_y*cos(lean) - w_z*sin(lean)
/// s_4 = w_y*sin(lean) + w_z*cos(lean)
/// s_5 = psi_dot*lean_dot*sin(lean)*sin(phi) - lean_dot*phi_dot*sin(phi)
///     - psi_dot*phi_dot*cos(lean)*cos(phi)
/// s_6 = m*r^2*s_2*w_y + m*r^2*(s_2*phi_dot - psi_dot*lean_dot*sin(lean)*sin(phi))
/// s_7 = m*r^2*s_1*w_y + m*r^2*(s_1*phi_dot - psi_dot*lean_dot*sin(lean)*cos(phi))
/// s_8 = psi_dot*lean_dot*sin(lean)*cos(phi) - lean_dot*phi_dot*cos(phi)
///     + psi_dot*phi_dot*cos(lean)*sin(phi)
/// s_9 = s_2*phi_dot*sin(phi) + s_8*cos(phi) + s_1*phi_dot*cos(phi) + s_5*sin(phi)
/// s_10 = w_y*lean_dot*cos(lean) + psi_dot*lean_dot*sin(lean)*cos(lean) - w_z*lean_dot*sin(lean)
///     - s_9*cos(lean)
/// s_11 = s_5*cos(phi) - s_1*phi_dot*sin(phi) + s_2*phi_dot*cos(phi) - s_8*sin(phi)
/// s_12 = psi_dot*lean_dot*cos(lean)^2 - w_y*lean_dot*sin(lean) - w_z*lean_dot*cos(lean)
///     + s_9*sin(lean)
/// s_13 = r*(w_x*psi_dot*cos(psi) + s_11*sin(psi) + s_12*cos(psi) - s_3*psi_dot*sin(psi))*cos(lean)
/// s_14 = r*(s_11*cos(psi) - w_x*psi_dot*sin(psi) - s_3*psi_dot*cos(psi) - s_12*sin(psi))*cos(lean)
/// ```
#[allow(non_snake_case)]
#[derive(
    ::core::clone::Clone,
    ::core::marker::Copy,
    ::core::fmt::Debug,
    ::core::cmp::PartialEq
)]
pub struct Wheel<S = ::core::primitive::f64> {
    /// In `kg`.
    pub m: S,
    /// In `m`.
    pub r: S,
    /// In `m/s^2`.
    pub g: S,
}
impl<S: sim_kernel::Scalar> ::core::default::Default for Wheel<S> {
    /// The declared values.
    fn default() -> Self {
        <Self as sim_kernel::Mechanism<S>>::defaults()
    }
}
/// Coordinates of [`Wheel`] by name, in SI units; also for their speeds and accelerations.
#[allow(non_snake_case)]
#[derive(
    ::core::clone::Clone,
    ::core::marker::Copy,
    ::core::fmt::Debug,
    ::core::cmp::PartialEq
)]
pub struct WheelCoordinates<S = ::core::primitive::f64> {
    /// In `m`.
    pub x: S,
    /// In `m`.
    pub y: S,
    /// In `rad`.
    pub psi: S,
    /// In `rad`.
    pub lean: S,
    /// In `rad`.
    pub phi: S,
}
impl<S: sim_kernel::Scalar> ::core::convert::From<[S; 5]> for WheelCoordinates<S> {
    fn from(values: [S; 5]) -> Self {
        Self {
            x: values[0],
            y: values[1],
            psi: values[2],
            lean: values[3],
            phi: values[4],
        }
    }
}
impl<S: sim_kernel::Scalar> ::core::convert::From<WheelCoordinates<S>> for [S; 5] {
    fn from(record: WheelCoordinates<S>) -> Self {
        [record.x, record.y, record.psi, record.lean, record.phi]
    }
}
/// What the equations of motion need of the parameters of [`Wheel`], from [`Wheel::prepare`]; its methods are the kernels of each step.
#[allow(non_snake_case)]
#[derive(
    ::core::clone::Clone,
    ::core::marker::Copy,
    ::core::fmt::Debug,
    ::core::cmp::PartialEq
)]
pub struct WheelPrepared<S = ::core::primitive::f64> {
    m: S,
    r: S,
    k: S,
    k_2: S,
    mass_phi_phi: S,
    g: S,
    k_3: S,
    k_4: S,
    inverse_x: S,
    k_5: S,
    pivot_roll_dot: S,
    pivot_nod_dot: S,
    inverse_roll_dot: S,
    inverse_nod_dot: S,
}
#[allow(non_snake_case, unused_variables, unused_parens, clippy::all, clippy::pedantic)]
impl<S: sim_kernel::Scalar> Wheel<S> {
    /// What the equations of motion need of the parameters, computed once for a set of parameters.
    ///
    /// Operations: 14 multiplications, 3 divisions.
    #[inline]
    pub fn prepare(&self) -> WheelPrepared<S> {
        let r_squared = self.r * self.r;
        let w = self.m * self.r;
        let w_2 = self.m * r_squared * S::from_f64(1.5);
        let w_3 = self.m * r_squared * S::from_f64(1.25);
        WheelPrepared {
            m: self.m,
            r: self.r,
            k: self.m * S::from_f64(0.25) * r_squared,
            k_2: self.m * r_squared,
            mass_phi_phi: self.m * r_squared * S::from_f64(0.5),
            g: self.g,
            k_3: w,
            k_4: self.g * w,
            inverse_x: S::from_f64(1.0) / self.m,
            k_5: self.m * r_squared * S::from_f64(2.0),
            pivot_roll_dot: w_2,
            pivot_nod_dot: w_3,
            inverse_roll_dot: S::from_f64(1.0) / w_2,
            inverse_nod_dot: S::from_f64(1.0) / w_3,
        }
    }
    /// Mass matrix `T_q' M T_q`, 5 x 5, symmetric, in SI units.
    ///
    /// Operations: 2 additions, 10 multiplications, 1 sine-cosine pair.
    #[inline]
    pub fn mass_matrix(&self, t: S, q: &[S; 5]) -> [[S; 5]; 5] {
        let [_, _, _, lean, _] = *q;
        let r_squared = self.r * self.r;
        let w = self.m * S::from_f64(0.25) * r_squared;
        let ([sin_lean], [_]) = S::sin_cos_each([lean]);
        let sin_lean_squared = sin_lean * sin_lean;
        let mass_phi_phi = self.m * r_squared * S::from_f64(0.5);
        let mass_phi_psi = sin_lean * mass_phi_phi;
        [
            [
                self.m,
                S::from_f64(0.0),
                S::from_f64(0.0),
                S::from_f64(0.0),
                S::from_f64(0.0),
            ],
            [
                S::from_f64(0.0),
                self.m,
                S::from_f64(0.0),
                S::from_f64(0.0),
                S::from_f64(0.0),
            ],
            [
                S::from_f64(0.0),
                S::from_f64(0.0),
                w * (sin_lean_squared + S::from_f64(1.0)),
                S::from_f64(0.0),
                mass_phi_psi,
            ],
            [
                S::from_f64(0.0),
                S::from_f64(0.0),
                S::from_f64(0.0),
                w + sin_lean_squared * self.m * r_squared,
                S::from_f64(0.0),
            ],
            [
                S::from_f64(0.0),
                S::from_f64(0.0),
                mass_phi_psi,
                S::from_f64(0.0),
                mass_phi_phi,
            ],
        ]
    }
    /// Convective forces `T_q' M g`, 5, with `g = (T_q q' + T_t)_q q' + (..)_t`: joules per unit of each coordinate.
    ///
    /// Operations: 3 additions, 20 multiplications, 1 sine-cosine pair.
    #[inline]
    pub fn convective_forces(&self, t: S, q: &[S; 5], qd: &[S; 5]) -> [S; 5] {
        let [_, _, _, lean, _] = *q;
        let [_, _, psi_dot, lean_dot, phi_dot] = *qd;
        let ([sin_lean], [cos_lean]) = S::sin_cos_each([lean]);
        let r_squared = self.r * self.r;
        let w = self.m * r_squared * S::from_f64(0.5);
        let w_2 = lean_dot * w;
        [
            S::from_f64(0.0),
            S::from_f64(0.0),
            cos_lean * (phi_dot + psi_dot * sin_lean) * w_2,
            cos_lean
                * (sin_lean
                    * (self.m * r_squared * lean_dot * lean_dot
                        - psi_dot * psi_dot * S::from_f64(0.25) * self.m * r_squared)
                    - psi_dot * phi_dot * w),
            cos_lean * psi_dot * w_2,
        ]
    }
    /// Generalised forces `T_q' F`, 5: joules per unit of each coordinate.
    ///
    /// Operations: 3 multiplications, 1 sine-cosine pair.
    #[inline]
    pub fn generalized_forces(&self, t: S, q: &[S; 5], qd: &[S; 5]) -> [S; 5] {
        let [_, _, _, lean, _] = *q;
        let ([sin_lean], [_]) = S::sin_cos_each([lean]);
        [
            S::from_f64(0.0),
            S::from_f64(0.0),
            S::from_f64(0.0),
            sin_lean * self.m * self.r * self.g,
            S::from_f64(0.0),
        ]
    }
    /// Constraints `C`, 2, in SI units; zero throughout the motion.
    ///
    /// Operations: none.
    #[inline]
    pub fn constraints(&self, t: S, q: &[S; 5]) -> [S; 2] {
        [S::from_f64(0.0), S::from_f64(0.0)]
    }
    /// The sum of the magnitudes of the terms of `C`, 2, in SI units: what its rounding is relative to.
    ///
    /// Operations: none.
    #[inline]
    pub fn constraint_magnitudes(&self, t: S, q: &[S; 5]) -> [S; 2] {
        [S::from_f64(0.0), S::from_f64(0.0)]
    }
    /// Constraint Jacobian `C_q`, 2 x 5: units of each constraint per unit of each coordinate.
    ///
    /// Operations: 5 additions, 6 multiplications, 2 sine-cosine pairs.
    #[inline]
    pub fn constraint_jacobian(&self, t: S, q: &[S; 5]) -> [[S; 5]; 2] {
        let [_, _, psi, lean, _] = *q;
        let ([sin_lean, sin_psi], [cos_lean, cos_psi]) = S::sin_cos_each([lean, psi]);
        let minus_slip_x_by_phi = self.r * cos_psi;
        let minus_slip_y_by_phi = self.r * sin_psi;
        [
            [
                S::from_f64(1.0),
                S::from_f64(0.0),
                -(sin_lean * minus_slip_x_by_phi),
                -(cos_lean * minus_slip_y_by_phi),
                -minus_slip_x_by_phi,
            ],
            [
                S::from_f64(0.0),
                S::from_f64(1.0),
                -(sin_lean * minus_slip_y_by_phi),
                minus_slip_x_by_phi * cos_lean,
                -minus_slip_y_by_phi,
            ],
        ]
    }
    /// `C_t`, 2, units of `C` per second: the speeds obey `C_q q' + C_t = 0`.
    ///
    /// Operations: none.
    #[inline]
    pub fn constraint_time_derivative(&self, t: S, q: &[S; 5]) -> [S; 2] {
        [S::from_f64(0.0), S::from_f64(0.0)]
    }
    /// `(C_q q' + C_t)_q q' + (..)_t`, 2, units of `C` per second squared: the part of `C''` without accelerations.
    ///
    /// Operations: 32 additions, 59 multiplications, 3 sine-cosine pairs.
    #[inline]
    pub fn constraint_convective(&self, t: S, q: &[S; 5], qd: &[S; 5]) -> [S; 2] {
        let [_, _, psi, lean, phi] = *q;
        let [_, _, psi_dot, lean_dot, phi_dot] = *qd;
        let ([sin_psi, sin_lean, sin_phi], [cos_psi, cos_lean, cos_phi]) = S::sin_cos_each([
            psi,
            lean,
            phi,
        ]);
        let w = sin_lean * psi_dot;
        let w_y = phi_dot + w;
        let w_2 = lean_dot * sin_phi;
        let w_3 = cos_lean * psi_dot;
        let w_4 = w_2 + cos_phi * w_3;
        let w_10 = w * w_2 - phi_dot * w_4;
        let w_5 = lean_dot * cos_phi;
        let w_6 = w_5 - sin_phi * w_3;
        let w_9 = w * w_5 - phi_dot * w_6;
        let w_z = cos_phi * w_4 - sin_phi * w_6;
        let w_x = sin_phi * w_4 + cos_phi * w_6;
        let w_7 = sin_lean * w_y + cos_lean * w_z;
        let w_8 = sin_lean * w_z;
        let w_11 = phi_dot * w_x + cos_phi * w_9 + sin_phi * w_10;
        let w_12 = lean_dot * (cos_lean * (w + w_y) - w_8) - cos_lean * w_11;
        let w_13 = cos_lean * w_y - w_8;
        let w_16 = cos_phi * w_10 + phi_dot * w_z - sin_phi * w_9 - psi_dot * w_13;
        let w_15 = lean_dot * (psi_dot * cos_lean * cos_lean - w_7) + sin_lean * w_11
            + psi_dot * w_x;
        let w_14 = sin_lean
            * (psi_dot * w_7 * sin_psi - cos_psi * w_12
                + lean_dot * (w_x * sin_psi + cos_psi * w_13));
        let w_17 = sin_lean
            * (cos_psi * psi_dot * w_7 + w_12 * sin_psi
                + lean_dot * (cos_psi * w_x - sin_psi * w_13));
        [
            self.r
                * (w_14
                    - cos_lean
                        * (cos_psi * w_15 + sin_psi * w_16 + lean_dot * cos_psi * w_7)),
            self.r
                * (cos_lean
                    * (cos_psi * w_16 - sin_psi * w_15 - lean_dot * w_7 * sin_psi)
                    - w_17),
        ]
    }
    /// `C` (2), `C_q` (2 x 5) and `C_t` (2) together, in SI units, for projection.
    ///
    /// Operations: 5 additions, 6 multiplications, 2 sine-cosine pairs.
    #[inline]
    pub fn constraint_linearization(
        &self,
        t: S,
        q: &[S; 5],
    ) -> sim_kernel::ConstraintLinearization<[S; 2], [[S; 5]; 2]> {
        let [_, _, psi, lean, _] = *q;
        let ([sin_lean, sin_psi], [cos_lean, cos_psi]) = S::sin_cos_each([lean, psi]);
        let minus_slip_x_by_phi = self.r * cos_psi;
        let minus_slip_y_by_phi = self.r * sin_psi;
        sim_kernel::ConstraintLinearization {
            values: [S::from_f64(0.0), S::from_f64(0.0)],
            jacobian: [
                [
                    S::from_f64(1.0),
                    S::from_f64(0.0),
                    -(sin_lean * minus_slip_x_by_phi),
                    -(cos_lean * minus_slip_y_by_phi),
                    -minus_slip_x_by_phi,
                ],
                [
                    S::from_f64(0.0),
                    S::from_f64(1.0),
                    -(sin_lean * minus_slip_y_by_phi),
                    minus_slip_x_by_phi * cos_lean,
                    -minus_slip_y_by_phi,
                ],
            ],
            time_derivative: [S::from_f64(0.0), S::from_f64(0.0)],
        }
    }
    /// Kinetic energy `v' M v / 2`, in joules.
    ///
    /// Operations: 8 additions, 25 multiplications, 2 sine-cosine pairs.
    #[inline]
    pub fn kinetic_energy(&self, t: S, q: &[S; 5], qd: &[S; 5]) -> S {
        let [_, _, _, lean, phi] = *q;
        let [x_dot, y_dot, psi_dot, lean_dot, phi_dot] = *qd;
        let w = S::from_f64(0.5) * self.m;
        let r_squared = self.r * self.r;
        let ([sin_lean, sin_phi], [cos_lean, cos_phi]) = S::sin_cos_each([lean, phi]);
        let w_2 = psi_dot * cos_lean;
        let w_3 = lean_dot * cos_phi - sin_phi * w_2;
        let w_4 = lean_dot * sin_phi + cos_phi * w_2;
        let w_5 = self.m * r_squared * S::from_f64(0.125) * (w_3 * w_3 + w_4 * w_4);
        let w_y = phi_dot + sin_lean * psi_dot;
        w * (x_dot * x_dot + y_dot * y_dot) + w_5
            + lean_dot * lean_dot * sin_lean * sin_lean * r_squared * w
            + w_y * w_y * self.m * r_squared * S::from_f64(0.25)
    }
    /// Power of loads and drives, `F' v + lambda' C_t + T_t' (M x'' - F)`, in watts.
    ///
    /// Operations: 4 multiplications, 1 sine-cosine pair.
    #[inline]
    pub fn power(
        &self,
        t: S,
        q: &[S; 5],
        qd: &[S; 5],
        qdd: &[S; 5],
        lambda: &[S; 2],
    ) -> S {
        let [_, _, _, lean, _] = *q;
        let [_, _, _, lean_dot, _] = *qd;
        let ([sin_lean], [_]) = S::sin_cos_each([lean]);
        lean_dot * sin_lean * self.m * self.r * self.g
    }
    /// Outputs, 0, in SI units.
    ///
    /// Operations: none.
    #[inline]
    pub fn outputs(
        &self,
        t: S,
        q: &[S; 5],
        qd: &[S; 5],
        qdd: &[S; 5],
        lambda: &[S; 2],
    ) -> [S; 0] {
        []
    }
    /// Rates of the outputs that depend on neither accelerations nor multipliers, 0, in SI units per second.
    ///
    /// Operations: none.
    #[inline]
    pub fn output_rates(&self, t: S, q: &[S; 5], qd: &[S; 5], qdd: &[S; 5]) -> [S; 0] {
        []
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
        lambda: &[S; 2],
    ) -> [S; 0] {
        []
    }
    /// The numbers of each shape of the drawing, in metres and radians.
    ///
    /// Operations: none.
    #[inline]
    pub fn drawing(&self, t: S, q: &[S; 5]) -> [S; 0] {
        []
    }
    /// Declared start: values or guesses of the coordinates (5), and speeds (5), in SI units; 0 where nothing is declared.
    ///
    /// Operations: 1 addition.
    #[inline]
    pub fn initial(&self) -> sim_kernel::Initial<[S; 5]> {
        sim_kernel::Initial {
            positions: [
                S::from_f64(0.0),
                S::from_f64(0.0),
                S::from_f64(0.0),
                -S::from_f64(0.3),
                S::from_f64(0.0),
            ],
            speeds: [
                S::from_f64(0.0),
                S::from_f64(0.0),
                S::from_f64(1.5),
                S::from_f64(0.0),
                S::from_f64(0.0),
            ],
        }
    }
    /// The generalised speeds `u = W q' + w`, 3, in SI units, in the order of declaration.
    ///
    /// Operations: 5 additions, 10 multiplications, 2 sine-cosine pairs.
    #[inline]
    pub fn generalized_speeds(&self, t: S, q: &[S; 5], qd: &[S; 5]) -> [S; 3] {
        let [_, _, _, lean, phi] = *q;
        let [_, _, psi_dot, lean_dot, phi_dot] = *qd;
        let ([sin_lean, sin_phi], [cos_lean, cos_phi]) = S::sin_cos_each([lean, phi]);
        let w = psi_dot * cos_lean;
        let w_2 = cos_phi * lean_dot - sin_phi * w;
        let w_3 = lean_dot * sin_phi + cos_phi * w;
        [
            phi_dot + psi_dot * sin_lean,
            cos_phi * w_2 + sin_phi * w_3,
            cos_phi * w_3 - sin_phi * w_2,
        ]
    }
    /// [`WheelPrepared::dynamics`] once; for many calls with the same parameters [`Self::prepare`] first.
    #[inline]
    pub fn dynamics(
        &self,
        t: S,
        q: &[S; 5],
        qd: &[S; 5],
    ) -> sim_kernel::Dynamics<S, [S; 5], [S; 2]> {
        self.prepare().dynamics(t, q, qd)
    }
    /// [`WheelPrepared::dynamics_jacobian`] once; for many calls with the same parameters [`Self::prepare`] first.
    #[inline]
    pub fn dynamics_jacobian(
        &self,
        t: S,
        q: &[S; 5],
        qd: &[S; 5],
    ) -> sim_kernel::DynamicsJacobian<S, [[S; 5]; 5], [[S; 5]; 2]> {
        self.prepare().dynamics_jacobian(t, q, qd)
    }
    /// [`WheelPrepared::kinematics`] once; for many calls with the same parameters [`Self::prepare`] first.
    #[inline]
    pub fn kinematics(
        &self,
        t: S,
        q: &[S; 5],
        u: &[S; 3],
    ) -> sim_kernel::Kinematics<S, [S; 5]> {
        self.prepare().kinematics(t, q, u)
    }
    /// [`WheelPrepared::speed_dynamics`] once; for many calls with the same parameters [`Self::prepare`] first.
    #[inline]
    pub fn speed_dynamics(
        &self,
        t: S,
        q: &[S; 5],
        u: &[S; 3],
    ) -> sim_kernel::SpeedDynamics<S, [S; 3], [S; 0]> {
        self.prepare().speed_dynamics(t, q, u)
    }
}
#[allow(non_snake_case, unused_variables, unused_parens, clippy::all, clippy::pedantic)]
impl<S: sim_kernel::Scalar> WheelPrepared<S> {
    /// Accelerations (5), multipliers (2) and power, from
    ///
    /// ```text
    /// [ T_q' M T_q   C_q' ] [ q''    ]   [ T_q' (F - M g)                      ]
    /// [ C_q          0    ] [ lambda ] = [ -(C_q q' + C_t)_q q' - (..)_t       ]
    /// ```
    ///
    /// by an elimination planned from the structure of the system, with two constraint rows turned along and across a link. Where `refused` is set a pivot was too small and nothing else holds: solve that state from the other kernels.
    ///
    /// Operations: 64 additions, 119 multiplications, 5 divisions, 3 sine-cosine pairs.
    #[inline(always)]
    pub fn dynamics(
        &self,
        t: S,
        q: &[S; 5],
        qd: &[S; 5],
    ) -> sim_kernel::Dynamics<S, [S; 5], [S; 2]> {
        let [_, _, psi, lean, phi] = *q;
        let [_, _, psi_dot, lean_dot, phi_dot] = *qd;
        let (
            [sin_lean,
            minus_k_lambda_slip_y_turned_x,
            sin_phi,
            ],
            [cos_lean,
            k_lambda_slip_x_turned_x,
            cos_phi,
            ],
        ) = S::sin_cos_each([lean, psi, phi]);
        let w = cos_lean * psi_dot;
        let rhs_lean = sin_lean
            * (self.k_4
                + cos_lean
                    * (self.k * psi_dot * psi_dot - self.k_2 * lean_dot * lean_dot))
            + self.mass_phi_phi * w * phi_dot;
        let w_2 = self.mass_phi_phi * lean_dot;
        let w_3 = sin_lean * psi_dot;
        let w_y = phi_dot + w_3;
        let w_4 = cos_lean * w_y;
        let minus_rhs_psi = w_2 * w_4;
        let mass_phi_psi = sin_lean * self.mass_phi_phi;
        let sin_lean_squared = sin_lean * sin_lean;
        let mass_psi_psi = self.k * (sin_lean_squared + S::from_f64(1.0));
        let mass_lean_lean = self.k + sin_lean_squared * self.k_2;
        let inverse_psi = S::from_f64(1.0) / mass_psi_psi;
        let l_phi_psi = mass_phi_psi * inverse_psi;
        let rhs_phi = minus_rhs_psi * l_phi_psi - w * w_2;
        let w_5 = sin_phi * lean_dot + cos_phi * w;
        let w_10 = lean_dot * cos_phi - sin_phi * w;
        let w_6 = w_5 * phi_dot;
        let w_7 = sin_lean * lean_dot;
        let w_8 = psi_dot * w_7;
        let w_9 = w_6 + (sin_phi * w_8 - w_6);
        let w_11 = phi_dot * w_10;
        let w_12 = w_11 + (cos_phi * w_8 - w_11);
        let w_13 = sin_phi * w_9 + cos_phi * w_12;
        let w_z = cos_phi * w_5 - sin_phi * w_10;
        let w_14 = cos_lean * (lean_dot * (w_3 + w_y) - w_13) - w_7 * w_z;
        let w_15 = sin_lean * w_y + cos_lean * w_z;
        let w_17 = w_4 - sin_lean * w_z;
        let w_20 = cos_phi * w_9 - sin_phi * w_12 - psi_dot * w_17;
        let w_x = cos_phi * w_10 + sin_phi * w_5;
        let w_19 = lean_dot * (psi_dot * cos_lean * cos_lean - w_15) + sin_lean * w_13
            + psi_dot * w_x;
        let w_16 = minus_k_lambda_slip_y_turned_x * w_15;
        let w_21 = k_lambda_slip_x_turned_x * w_15;
        let w_18 = sin_lean
            * (k_lambda_slip_x_turned_x * w_14 - psi_dot * w_16
                - lean_dot
                    * (minus_k_lambda_slip_y_turned_x * w_x
                        + k_lambda_slip_x_turned_x * w_17));
        let w_22 = self.r
            * (w_18
                + cos_lean
                    * (k_lambda_slip_x_turned_x * w_19
                        + minus_k_lambda_slip_y_turned_x * w_20 + lean_dot * w_21));
        let w_23 = sin_lean
            * (psi_dot * w_21 + minus_k_lambda_slip_y_turned_x * w_14
                + lean_dot
                    * (k_lambda_slip_x_turned_x * w_x
                        - minus_k_lambda_slip_y_turned_x * w_17));
        let w_24 = self.r
            * (w_23
                + cos_lean
                    * (lean_dot * w_16
                        - (k_lambda_slip_x_turned_x * w_20
                            - minus_k_lambda_slip_y_turned_x * w_19)));
        let minus_k_lambda_slip_x_turned_psi = self.r * sin_lean;
        let minus_l_lambda_slip_x_turned_psi = minus_k_lambda_slip_x_turned_psi
            * inverse_psi;
        let P_z = self.r * cos_lean;
        let inverse_lean = S::from_f64(1.0) / mass_lean_lean;
        let l_lambda_slip_y_turned_lean = P_z * inverse_lean;
        let minus_l_lambda_slip_y_turned_x = minus_k_lambda_slip_y_turned_x
            * self.inverse_x;
        let w_25 = minus_k_lambda_slip_y_turned_x * minus_l_lambda_slip_y_turned_x;
        let l_lambda_slip_x_turned_x = k_lambda_slip_x_turned_x * self.inverse_x;
        let w_26 = k_lambda_slip_x_turned_x * l_lambda_slip_x_turned_x;
        let minus_pivot_lambda_slip_y_turned = P_z * l_lambda_slip_y_turned_lean + w_25
            + w_26;
        let minus_inverse_lambda_slip_y_turned = S::from_f64(1.0)
            / minus_pivot_lambda_slip_y_turned;
        let k_lambda_slip_x_turned_lambda_slip_y_turned = k_lambda_slip_x_turned_x
            * minus_l_lambda_slip_y_turned_x
            - minus_k_lambda_slip_y_turned_x * l_lambda_slip_x_turned_x;
        let minus_l_lambda_slip_x_turned_lambda_slip_y_turned = minus_inverse_lambda_slip_y_turned
            * k_lambda_slip_x_turned_lambda_slip_y_turned;
        let minus_rhs_lambda_slip_y_turned = minus_k_lambda_slip_y_turned_x * w_22
            - k_lambda_slip_x_turned_x * w_24 + rhs_lean * l_lambda_slip_y_turned_lean;
        let pivot_phi = self.mass_phi_phi - mass_phi_psi * l_phi_psi;
        let k_lambda_slip_x_turned_phi = mass_phi_psi * minus_l_lambda_slip_x_turned_psi
            - self.r;
        let inverse_phi = S::from_f64(1.0) / pivot_phi;
        let l_lambda_slip_x_turned_phi = inverse_phi * k_lambda_slip_x_turned_phi;
        let w_27 = w_26 + w_25
            + minus_k_lambda_slip_x_turned_psi * minus_l_lambda_slip_x_turned_psi
            + k_lambda_slip_x_turned_phi * l_lambda_slip_x_turned_phi;
        let pivot_lambda_slip_x_turned = k_lambda_slip_x_turned_lambda_slip_y_turned
            * minus_l_lambda_slip_x_turned_lambda_slip_y_turned - w_27;
        let w_28 = S::from_f64(1.0) / pivot_lambda_slip_x_turned
            * (k_lambda_slip_x_turned_x * w_22 + minus_k_lambda_slip_y_turned_x * w_24
                - minus_rhs_psi * minus_l_lambda_slip_x_turned_psi
                - minus_l_lambda_slip_x_turned_lambda_slip_y_turned
                    * minus_rhs_lambda_slip_y_turned
                - l_lambda_slip_x_turned_phi * rhs_phi);
        let w_29 = minus_inverse_lambda_slip_y_turned * minus_rhs_lambda_slip_y_turned
            + minus_l_lambda_slip_x_turned_lambda_slip_y_turned * w_28;
        let phi_ddot = inverse_phi * rhs_phi - l_lambda_slip_x_turned_phi * w_28;
        sim_kernel::Dynamics {
            accelerations: [
                minus_l_lambda_slip_y_turned_x * w_29 - l_lambda_slip_x_turned_x * w_28,
                -(minus_l_lambda_slip_y_turned_x * w_28
                    + l_lambda_slip_x_turned_x * w_29),
                minus_l_lambda_slip_x_turned_psi * w_28 - minus_rhs_psi * inverse_psi
                    - l_phi_psi * phi_ddot,
                rhs_lean * inverse_lean - l_lambda_slip_y_turned_lean * w_29,
                phi_ddot,
            ],
            multipliers: [
                k_lambda_slip_x_turned_x * w_28 - minus_k_lambda_slip_y_turned_x * w_29,
                minus_k_lambda_slip_y_turned_x * w_28 + k_lambda_slip_x_turned_x * w_29,
            ],
            power: w_7 * self.k_4,
            refused: sim_kernel::pivot_is_refused(mass_lean_lean, mass_lean_lean)
                | sim_kernel::pivot_is_refused(self.m, self.m)
                | sim_kernel::pivot_is_refused(self.m, self.m)
                | sim_kernel::pivot_is_refused(mass_psi_psi, mass_psi_psi)
                | sim_kernel::pivot_is_refused(
                    -minus_pivot_lambda_slip_y_turned,
                    minus_pivot_lambda_slip_y_turned,
                ) | sim_kernel::pivot_is_refused(pivot_phi, self.mass_phi_phi)
                | sim_kernel::pivot_is_refused(pivot_lambda_slip_x_turned, w_27),
        }
    }
    /// The derivatives of accelerations (5 rows) and multipliers (2 rows) with respect to coordinates and speeds (5 columns each): with the equations of motion as `K z = r`, the solutions of `K dz = dr - dK z`. Where `refused` is set a pivot was too small and nothing else holds.
    ///
    /// Operations: 263 additions, 423 multiplications, 5 divisions, 3 sine-cosine pairs.
    #[inline]
    pub fn dynamics_jacobian(
        &self,
        t: S,
        q: &[S; 5],
        qd: &[S; 5],
    ) -> sim_kernel::DynamicsJacobian<S, [[S; 5]; 5], [[S; 5]; 2]> {
        let [_, _, psi, lean, phi] = *q;
        let [_, _, psi_dot, lean_dot, phi_dot] = *qd;
        let (
            [sin_lean,
            minus_k_lambda_slip_y_turned_x,
            sin_phi,
            ],
            [cos_lean,
            k_lambda_slip_x_turned_x,
            cos_phi,
            ],
        ) = S::sin_cos_each([lean, psi, phi]);
        let lean_dot_squared = lean_dot * lean_dot;
        let w = cos_lean * psi_dot;
        let w_2 = self.mass_phi_phi * w;
        let rhs_lean = sin_lean
            * (self.k_4
                + cos_lean * (self.k * psi_dot * psi_dot - self.k_2 * lean_dot_squared))
            + phi_dot * w_2;
        let w_3 = sin_lean * psi_dot;
        let w_y = phi_dot + w_3;
        let w_4 = cos_lean * lean_dot;
        let w_5 = self.mass_phi_phi * w_4;
        let minus_rhs_psi = w_y * w_5;
        let mass_phi_psi = sin_lean * self.mass_phi_phi;
        let sin_lean_squared = sin_lean * sin_lean;
        let mass_psi_psi = self.k * (sin_lean_squared + S::from_f64(1.0));
        let inverse_psi = S::from_f64(1.0) / mass_psi_psi;
        let l_phi_psi = mass_phi_psi * inverse_psi;
        let rhs_phi = minus_rhs_psi * l_phi_psi - lean_dot * w_2;
        let w_6 = w_3 + w_y;
        let w_7 = sin_phi * lean_dot + cos_phi * w;
        let w_8 = w_7 * phi_dot;
        let w_9 = sin_lean * lean_dot;
        let w_10 = psi_dot * w_9;
        let w_11 = sin_phi * w_10;
        let w_12 = w_8 + (w_11 - w_8);
        let w_13 = lean_dot * cos_phi - sin_phi * w;
        let w_14 = phi_dot * w_13;
        let w_15 = cos_phi * w_10;
        let w_68 = S::from_f64(0.25) * sin_lean
            * (sin_phi * self.k_2 * (w_8 - w_11 + w_7 * w_y)
                + cos_phi * self.k_2 * (w_14 - w_15 + w_y * w_13));
        let w_16 = w_14 + (w_15 - w_14);
        let w_17 = sin_phi * w_12 + cos_phi * w_16;
        let w_z = cos_phi * w_7 - sin_phi * w_13;
        let w_18 = cos_lean * (lean_dot * w_6 - w_17) - w_9 * w_z;
        let w_19 = sin_lean * w_y;
        let w_20 = cos_lean * w_z;
        let w_21 = w_19 + w_20;
        let w_22 = minus_k_lambda_slip_y_turned_x * psi_dot;
        let w_23 = w_21 * w_22;
        let w_x = cos_phi * w_13 + sin_phi * w_7;
        let w_24 = cos_lean * w_y;
        let w_25 = sin_lean * w_z;
        let w_117 = self.mass_phi_phi * w_z;
        let w_26 = w_24 - w_25;
        let w_32 = cos_phi * w_12 - sin_phi * w_16 - psi_dot * w_26;
        let w_27 = minus_k_lambda_slip_y_turned_x * w_x
            + k_lambda_slip_x_turned_x * w_26;
        let w_28 = lean_dot * w_27;
        let w_29 = psi_dot * cos_lean * cos_lean;
        let w_30 = sin_lean * w_17;
        let w_31 = lean_dot * (w_29 - w_21) + w_30 + psi_dot * w_x;
        let w_33 = k_lambda_slip_x_turned_x * lean_dot;
        let w_34 = k_lambda_slip_x_turned_x * w_31
            + minus_k_lambda_slip_y_turned_x * w_32 + w_21 * w_33;
        let w_35 = self.r
            * (sin_lean * (k_lambda_slip_x_turned_x * w_18 - w_23 - w_28)
                + cos_lean * w_34);
        let w_36 = k_lambda_slip_x_turned_x * psi_dot;
        let w_37 = w_21 * w_36;
        let w_38 = k_lambda_slip_x_turned_x * w_x
            - minus_k_lambda_slip_y_turned_x * w_26;
        let w_39 = lean_dot * w_38;
        let w_40 = minus_k_lambda_slip_y_turned_x * lean_dot;
        let w_41 = w_21 * w_40
            - (k_lambda_slip_x_turned_x * w_32 - minus_k_lambda_slip_y_turned_x * w_31);
        let w_42 = self.r
            * (sin_lean * (w_37 + minus_k_lambda_slip_y_turned_x * w_18 + w_39)
                + cos_lean * w_41);
        let w_62 = w_18 + lean_dot * w_26;
        let minus_k_lambda_slip_x_turned_psi = self.r * sin_lean;
        let minus_l_lambda_slip_x_turned_psi = minus_k_lambda_slip_x_turned_psi
            * inverse_psi;
        let P_z = self.r * cos_lean;
        let w_43 = sin_lean_squared * self.k_2;
        let mass_lean_lean = self.k + w_43;
        let inverse_lean = S::from_f64(1.0) / mass_lean_lean;
        let l_lambda_slip_y_turned_lean = P_z * inverse_lean;
        let minus_l_lambda_slip_y_turned_x = minus_k_lambda_slip_y_turned_x
            * self.inverse_x;
        let w_44 = minus_k_lambda_slip_y_turned_x * minus_l_lambda_slip_y_turned_x;
        let l_lambda_slip_x_turned_x = k_lambda_slip_x_turned_x * self.inverse_x;
        let w_45 = k_lambda_slip_x_turned_x * l_lambda_slip_x_turned_x;
        let minus_pivot_lambda_slip_y_turned = P_z * l_lambda_slip_y_turned_lean + w_44
            + w_45;
        let minus_inverse_lambda_slip_y_turned = S::from_f64(1.0)
            / minus_pivot_lambda_slip_y_turned;
        let k_lambda_slip_x_turned_lambda_slip_y_turned = k_lambda_slip_x_turned_x
            * minus_l_lambda_slip_y_turned_x
            - minus_k_lambda_slip_y_turned_x * l_lambda_slip_x_turned_x;
        let minus_l_lambda_slip_x_turned_lambda_slip_y_turned = minus_inverse_lambda_slip_y_turned
            * k_lambda_slip_x_turned_lambda_slip_y_turned;
        let minus_rhs_lambda_slip_y_turned = minus_k_lambda_slip_y_turned_x * w_35
            - k_lambda_slip_x_turned_x * w_42 + rhs_lean * l_lambda_slip_y_turned_lean;
        let pivot_phi = self.mass_phi_phi - mass_phi_psi * l_phi_psi;
        let k_lambda_slip_x_turned_phi = mass_phi_psi * minus_l_lambda_slip_x_turned_psi
            - self.r;
        let inverse_phi = S::from_f64(1.0) / pivot_phi;
        let l_lambda_slip_x_turned_phi = inverse_phi * k_lambda_slip_x_turned_phi;
        let w_46 = w_45 + w_44
            + minus_k_lambda_slip_x_turned_psi * minus_l_lambda_slip_x_turned_psi
            + k_lambda_slip_x_turned_phi * l_lambda_slip_x_turned_phi;
        let pivot_lambda_slip_x_turned = k_lambda_slip_x_turned_lambda_slip_y_turned
            * minus_l_lambda_slip_x_turned_lambda_slip_y_turned - w_46;
        let inverse_lambda_slip_x_turned = S::from_f64(1.0) / pivot_lambda_slip_x_turned;
        let w_47 = inverse_lambda_slip_x_turned
            * (k_lambda_slip_x_turned_x * w_35 + minus_k_lambda_slip_y_turned_x * w_42
                - minus_rhs_psi * minus_l_lambda_slip_x_turned_psi
                - minus_l_lambda_slip_x_turned_lambda_slip_y_turned
                    * minus_rhs_lambda_slip_y_turned
                - l_lambda_slip_x_turned_phi * rhs_phi);
        let w_48 = minus_inverse_lambda_slip_y_turned * minus_rhs_lambda_slip_y_turned
            + minus_l_lambda_slip_x_turned_lambda_slip_y_turned * w_47;
        let lean_ddot = rhs_lean * inverse_lean - l_lambda_slip_y_turned_lean * w_48;
        let phi_ddot = inverse_phi * rhs_phi - l_lambda_slip_x_turned_phi * w_47;
        let psi_ddot = minus_l_lambda_slip_x_turned_psi * w_47
            - minus_rhs_psi * inverse_psi - l_phi_psi * phi_ddot;
        let lambda_slip_y = minus_k_lambda_slip_y_turned_x * w_47
            + k_lambda_slip_x_turned_x * w_48;
        let minus_y_ddot = minus_l_lambda_slip_y_turned_x * w_47
            + l_lambda_slip_x_turned_x * w_48;
        let x_ddot = minus_l_lambda_slip_y_turned_x * w_48
            - l_lambda_slip_x_turned_x * w_47;
        let w_49 = minus_k_lambda_slip_y_turned_x * w_48;
        let w_50 = k_lambda_slip_x_turned_x * w_47;
        let w_51 = w_49 - w_50;
        let w_52 = k_lambda_slip_x_turned_x * x_ddot
            - minus_k_lambda_slip_y_turned_x * minus_y_ddot
            + minus_l_lambda_slip_y_turned_x * lambda_slip_y
            - l_lambda_slip_x_turned_x * w_51;
        let w_53 = inverse_lambda_slip_x_turned
            * (k_lambda_slip_x_turned_x * minus_y_ddot
                + minus_k_lambda_slip_y_turned_x * x_ddot
                - l_lambda_slip_x_turned_x * lambda_slip_y
                - minus_l_lambda_slip_y_turned_x * w_51
                + minus_l_lambda_slip_x_turned_lambda_slip_y_turned * w_52);
        let w_54 = minus_l_lambda_slip_x_turned_lambda_slip_y_turned * w_53
            - minus_inverse_lambda_slip_y_turned * w_52;
        let w_55 = sin_lean * phi_dot;
        let w_56 = psi_dot * (cos_phi * w_55 + sin_phi * w_4);
        let w_57 = psi_dot * (sin_phi * w_55 - cos_phi * w_4);
        let w_58 = psi_dot - w_19 - w_20;
        let w_59 = cos_phi * w_56 + sin_phi * w_57 - phi_dot * w_3 - psi_dot * w_58;
        let w_60 = cos_phi * w_57 - sin_phi * w_56;
        let w_61 = lean_dot * (w_26 + sin_lean * w * S::from_f64(2.0)) - cos_lean * w_17
            + sin_lean * w_60;
        let w_63 = lean_dot
            * (w_21 + S::from_f64(2.0) * psi_dot * (sin_lean_squared - S::from_f64(1.0)))
            - w_30 - cos_lean * w_60 + lean_dot * w_58;
        let w_64 = self.r
            * (cos_lean
                * (minus_k_lambda_slip_y_turned_x * w_59
                    - k_lambda_slip_x_turned_x * w_61 - w_23 - w_28
                    + k_lambda_slip_x_turned_x * w_62)
                - sin_lean * (w_34 + k_lambda_slip_x_turned_x * w_63 + w_26 * w_22));
        let w_65 = self.r
            * (cos_lean
                * (w_37 + w_39
                    - (k_lambda_slip_x_turned_x * w_59
                        + minus_k_lambda_slip_y_turned_x * w_61)
                    + minus_k_lambda_slip_y_turned_x * w_62)
                + sin_lean
                    * (w_26 * w_36 - w_41 - minus_k_lambda_slip_y_turned_x * w_63));
        let w_66 = self.k_2 * (psi_dot * (cos_lean * w_7 - cos_phi * w_19) - w_56);
        let w_67 = self.k_2 * (w_57 + psi_dot * (sin_phi * w_19 + cos_lean * w_13));
        let w_69 = cos_lean
            * (self.r * w_47 - S::from_f64(0.25) * (sin_phi * w_66 + cos_phi * w_67)
                - self.mass_phi_phi * (phi_ddot + sin_lean * psi_ddot))
            + lean_dot * psi_dot * (w_43 - self.mass_phi_phi) + w_68;
        let w_70 = S::from_f64(0.25) * (cos_phi * w_66 - sin_phi * w_67)
            + cos_lean
                * ((self.g - P_z * lean_dot_squared) * self.k_3
                    - sin_lean * lean_ddot * self.k_5) + w_43 * lean_dot_squared
            + minus_k_lambda_slip_x_turned_psi * w_48;
        let w_71 = minus_k_lambda_slip_x_turned_psi * lean_ddot
            + k_lambda_slip_x_turned_x * w_65 - minus_k_lambda_slip_y_turned_x * w_64
            - l_lambda_slip_y_turned_lean * w_70;
        let w_72 = self.mass_phi_phi * (w_10 - cos_lean * psi_ddot) - l_phi_psi * w_69;
        let w_73 = inverse_lambda_slip_x_turned
            * (k_lambda_slip_x_turned_x * w_64 + minus_k_lambda_slip_y_turned_x * w_65
                + P_z * psi_ddot + minus_l_lambda_slip_x_turned_psi * w_69
                + minus_l_lambda_slip_x_turned_lambda_slip_y_turned * w_71
                - l_lambda_slip_x_turned_phi * w_72);
        let w_74 = minus_l_lambda_slip_x_turned_lambda_slip_y_turned * w_73
            - minus_inverse_lambda_slip_y_turned * w_71;
        let w_76 = inverse_phi * w_72 - l_lambda_slip_x_turned_phi * w_73;
        let w_75 = l_lambda_slip_x_turned_phi * w_53;
        let w_77 = psi_dot + w_21;
        let w_78 = cos_lean * phi_dot;
        let w_79 = sin_phi * w_78 + cos_phi * w_9;
        let w_88 = self.k_2 * (sin_lean * w_13 - w_79 - sin_phi * w_24);
        let w_80 = cos_phi * w_78 - sin_phi * w_9;
        let w_84 = w_26 + (cos_phi * w_80 + sin_phi * w_79 - w_78);
        let w_81 = cos_phi * w_79 - sin_phi * w_80;
        let w_87 = self.k_2 * (w_80 + cos_phi * w_24 + sin_lean * w_7);
        let w_82 = cos_lean * (w_9 - w_81);
        let w_83 = w_x - (sin_lean_squared * lean_dot - sin_lean * w_81);
        let w_116 = self.mass_phi_phi * cos_lean * w_x;
        let w_85 = self.r
            * (sin_lean
                * (k_lambda_slip_x_turned_x * w_77
                    + minus_k_lambda_slip_y_turned_x * w_82)
                + cos_lean
                    * (minus_k_lambda_slip_y_turned_x * w_83
                        + k_lambda_slip_x_turned_x * w_84 + w_40));
        let w_86 = self.r
            * (sin_lean
                * (minus_k_lambda_slip_y_turned_x * w_77
                    - k_lambda_slip_x_turned_x * w_82)
                - cos_lean
                    * (k_lambda_slip_x_turned_x * w_83
                        - minus_k_lambda_slip_y_turned_x * w_84 + w_33));
        let w_89 = cos_lean
            * (S::from_f64(0.25) * (sin_phi * w_87 + cos_phi * w_88)
                + self.mass_phi_phi * w_9);
        let w_90 = S::from_f64(0.25) * (cos_phi * w_87 - sin_phi * w_88);
        let w_92 = l_phi_psi * w_89 - w_5;
        let w_91 = k_lambda_slip_x_turned_x * w_85
            + minus_k_lambda_slip_y_turned_x * w_86 - l_lambda_slip_y_turned_lean * w_90;
        let w_93 = inverse_lambda_slip_x_turned
            * (minus_k_lambda_slip_y_turned_x * w_85 - k_lambda_slip_x_turned_x * w_86
                - minus_l_lambda_slip_x_turned_psi * w_89
                + minus_l_lambda_slip_x_turned_lambda_slip_y_turned * w_91
                - l_lambda_slip_x_turned_phi * w_92);
        let w_94 = minus_l_lambda_slip_x_turned_lambda_slip_y_turned * w_93
            - minus_inverse_lambda_slip_y_turned * w_91;
        let w_122 = inverse_phi * w_92 - l_lambda_slip_x_turned_phi * w_93;
        let w_95 = w_3 - phi_dot;
        let w_96 = cos_phi * w_95;
        let w_97 = sin_phi * w_95;
        let w_98 = phi_dot + cos_phi * w_96 + sin_phi * w_97;
        let w_99 = cos_lean * (w_6 - w_98) - w_25;
        let w_100 = psi_dot - (w_20 - w_29 + sin_lean * (w_y - w_98));
        let w_101 = cos_phi * w_97 - sin_phi * w_96;
        let w_102 = self.r
            * (sin_lean * (k_lambda_slip_x_turned_x * w_99 - w_27 - w_40)
                + cos_lean
                    * (k_lambda_slip_x_turned_x * w_100
                        + minus_k_lambda_slip_y_turned_x * w_101
                        + k_lambda_slip_x_turned_x * w_21));
        let w_103 = self.r
            * (sin_lean * (w_38 + w_33 + minus_k_lambda_slip_y_turned_x * w_99)
                + cos_lean
                    * (minus_k_lambda_slip_y_turned_x * w_21
                        - (k_lambda_slip_x_turned_x * w_101
                            - minus_k_lambda_slip_y_turned_x * w_100)));
        let w_104 = self.k_2 * (sin_phi * w_y - w_97);
        let w_105 = self.k_2 * (cos_phi * w_y - w_96);
        let w_106 = cos_lean
            * (S::from_f64(0.25) * (sin_phi * w_104 + cos_phi * w_105)
                + self.mass_phi_phi * w_3);
        let w_107 = S::from_f64(0.25) * (cos_phi * w_104 - sin_phi * w_105)
            - cos_lean * w_9 * self.k_5;
        let w_109 = l_phi_psi * w_106 - w_2;
        let w_108 = k_lambda_slip_x_turned_x * w_103
            - minus_k_lambda_slip_y_turned_x * w_102
            - l_lambda_slip_y_turned_lean * w_107;
        let w_110 = inverse_lambda_slip_x_turned
            * (k_lambda_slip_x_turned_x * w_102 + minus_k_lambda_slip_y_turned_x * w_103
                - minus_l_lambda_slip_x_turned_psi * w_106
                + minus_l_lambda_slip_x_turned_lambda_slip_y_turned * w_108
                - l_lambda_slip_x_turned_phi * w_109);
        let w_111 = minus_l_lambda_slip_x_turned_lambda_slip_y_turned * w_110
            - minus_inverse_lambda_slip_y_turned * w_108;
        let w_123 = inverse_phi * w_109 - l_lambda_slip_x_turned_phi * w_110;
        let w_112 = k_lambda_slip_x_turned_x * w_9;
        let w_113 = self.r
            * (cos_lean * (w_112 - (w_112 + minus_k_lambda_slip_y_turned_x * w))
                - sin_lean_squared * w_22);
        let w_114 = minus_k_lambda_slip_y_turned_x * w_9;
        let w_115 = self.r
            * (cos_lean * (w_114 + (k_lambda_slip_x_turned_x * w - w_114))
                + sin_lean_squared * w_36);
        let w_118 = k_lambda_slip_x_turned_x * w_115
            - minus_k_lambda_slip_y_turned_x * w_113
            - l_lambda_slip_y_turned_lean * w_117;
        let w_119 = l_phi_psi * w_116;
        let w_120 = inverse_lambda_slip_x_turned
            * (k_lambda_slip_x_turned_x * w_113 + minus_k_lambda_slip_y_turned_x * w_115
                - minus_l_lambda_slip_x_turned_psi * w_116
                + minus_l_lambda_slip_x_turned_lambda_slip_y_turned * w_118
                - l_lambda_slip_x_turned_phi * w_119);
        let w_121 = minus_l_lambda_slip_x_turned_lambda_slip_y_turned * w_120
            - minus_inverse_lambda_slip_y_turned * w_118;
        let w_124 = inverse_phi * w_119 - l_lambda_slip_x_turned_phi * w_120;
        sim_kernel::DynamicsJacobian {
            accelerations_by_positions: [
                [
                    S::from_f64(0.0),
                    S::from_f64(0.0),
                    self.inverse_x * lambda_slip_y - l_lambda_slip_x_turned_x * w_53
                        + minus_l_lambda_slip_y_turned_x * w_54,
                    minus_l_lambda_slip_y_turned_x * w_74
                        - l_lambda_slip_x_turned_x * w_73,
                    S::from_f64(0.0),
                ],
                [
                    S::from_f64(0.0),
                    S::from_f64(0.0),
                    self.inverse_x * w_51 - minus_l_lambda_slip_y_turned_x * w_53
                        - l_lambda_slip_x_turned_x * w_54,
                    -(minus_l_lambda_slip_y_turned_x * w_73
                        + l_lambda_slip_x_turned_x * w_74),
                    S::from_f64(0.0),
                ],
                [
                    S::from_f64(0.0),
                    S::from_f64(0.0),
                    l_phi_psi * w_75 + minus_l_lambda_slip_x_turned_psi * w_53,
                    inverse_psi * w_69 - l_phi_psi * w_76
                        + minus_l_lambda_slip_x_turned_psi * w_73,
                    S::from_f64(0.0),
                ],
                [
                    S::from_f64(0.0),
                    S::from_f64(0.0),
                    -(l_lambda_slip_y_turned_lean * w_54),
                    inverse_lean * w_70 - l_lambda_slip_y_turned_lean * w_74,
                    S::from_f64(0.0),
                ],
                [S::from_f64(0.0), S::from_f64(0.0), -w_75, w_76, S::from_f64(0.0)],
            ],
            accelerations_by_speeds: [
                [
                    S::from_f64(0.0),
                    S::from_f64(0.0),
                    minus_l_lambda_slip_y_turned_x * w_94
                        - l_lambda_slip_x_turned_x * w_93,
                    minus_l_lambda_slip_y_turned_x * w_111
                        - l_lambda_slip_x_turned_x * w_110,
                    minus_l_lambda_slip_y_turned_x * w_121
                        - l_lambda_slip_x_turned_x * w_120,
                ],
                [
                    S::from_f64(0.0),
                    S::from_f64(0.0),
                    -(minus_l_lambda_slip_y_turned_x * w_93
                        + l_lambda_slip_x_turned_x * w_94),
                    -(minus_l_lambda_slip_y_turned_x * w_110
                        + l_lambda_slip_x_turned_x * w_111),
                    -(minus_l_lambda_slip_y_turned_x * w_120
                        + l_lambda_slip_x_turned_x * w_121),
                ],
                [
                    S::from_f64(0.0),
                    S::from_f64(0.0),
                    minus_l_lambda_slip_x_turned_psi * w_93 - inverse_psi * w_89
                        - l_phi_psi * w_122,
                    minus_l_lambda_slip_x_turned_psi * w_110 - inverse_psi * w_106
                        - l_phi_psi * w_123,
                    minus_l_lambda_slip_x_turned_psi * w_120 - inverse_psi * w_116
                        - l_phi_psi * w_124,
                ],
                [
                    S::from_f64(0.0),
                    S::from_f64(0.0),
                    inverse_lean * w_90 - l_lambda_slip_y_turned_lean * w_94,
                    inverse_lean * w_107 - l_lambda_slip_y_turned_lean * w_111,
                    inverse_lean * w_117 - l_lambda_slip_y_turned_lean * w_121,
                ],
                [S::from_f64(0.0), S::from_f64(0.0), w_122, w_123, w_124],
            ],
            multipliers_by_positions: [
                [
                    S::from_f64(0.0),
                    S::from_f64(0.0),
                    k_lambda_slip_x_turned_x * w_53
                        - minus_k_lambda_slip_y_turned_x * w_54 - lambda_slip_y,
                    k_lambda_slip_x_turned_x * w_73
                        - minus_k_lambda_slip_y_turned_x * w_74,
                    S::from_f64(0.0),
                ],
                [
                    S::from_f64(0.0),
                    S::from_f64(0.0),
                    minus_k_lambda_slip_y_turned_x * w_53
                        + k_lambda_slip_x_turned_x * w_54 + (w_50 - w_49),
                    minus_k_lambda_slip_y_turned_x * w_73
                        + k_lambda_slip_x_turned_x * w_74,
                    S::from_f64(0.0),
                ],
            ],
            multipliers_by_speeds: [
                [
                    S::from_f64(0.0),
                    S::from_f64(0.0),
                    k_lambda_slip_x_turned_x * w_93
                        - minus_k_lambda_slip_y_turned_x * w_94,
                    k_lambda_slip_x_turned_x * w_110
                        - minus_k_lambda_slip_y_turned_x * w_111,
                    k_lambda_slip_x_turned_x * w_120
                        - minus_k_lambda_slip_y_turned_x * w_121,
                ],
                [
                    S::from_f64(0.0),
                    S::from_f64(0.0),
                    minus_k_lambda_slip_y_turned_x * w_93
                        + k_lambda_slip_x_turned_x * w_94,
                    minus_k_lambda_slip_y_turned_x * w_110
                        + k_lambda_slip_x_turned_x * w_111,
                    minus_k_lambda_slip_y_turned_x * w_120
                        + k_lambda_slip_x_turned_x * w_121,
                ],
            ],
            refused: sim_kernel::pivot_is_refused(mass_lean_lean, mass_lean_lean)
                | sim_kernel::pivot_is_refused(self.m, self.m)
                | sim_kernel::pivot_is_refused(self.m, self.m)
                | sim_kernel::pivot_is_refused(mass_psi_psi, mass_psi_psi)
                | sim_kernel::pivot_is_refused(
                    -minus_pivot_lambda_slip_y_turned,
                    minus_pivot_lambda_slip_y_turned,
                ) | sim_kernel::pivot_is_refused(pivot_phi, self.mass_phi_phi)
                | sim_kernel::pivot_is_refused(pivot_lambda_slip_x_turned, w_46),
        }
    }
    /// The kinematic differential equations `q' = N u + n`: speeds (5) of generalised speeds `u` (3), from `u = W q' + w` and what they satisfy by construction. Where `refused` is set a pivot was too small and nothing else holds: no generalised speeds determine the speeds there.
    ///
    /// Operations: 3 additions, 11 multiplications, 1 division, 2 sine-cosine pairs.
    #[inline]
    pub fn kinematics(
        &self,
        t: S,
        q: &[S; 5],
        u: &[S; 3],
    ) -> sim_kernel::Kinematics<S, [S; 5]> {
        let [_, _, psi, lean, _] = *q;
        let [roll, nod, turn] = *u;
        let (
            [sin_lean,
            minus_k_lambda_slip_y_turned_x,
            ],
            [cos_lean,
            k_lambda_slip_x_turned_x,
            ],
        ) = S::sin_cos_each([lean, psi]);
        let w = cos_lean * nod;
        let pivot_psi_dot = cos_lean * cos_lean;
        let psi_dot = S::from_f64(1.0) / pivot_psi_dot * cos_lean * turn;
        sim_kernel::Kinematics {
            rates: [
                self.r
                    * (minus_k_lambda_slip_y_turned_x * w
                        + k_lambda_slip_x_turned_x * roll),
                self.r
                    * (minus_k_lambda_slip_y_turned_x * roll
                        - k_lambda_slip_x_turned_x * w),
                psi_dot,
                nod,
                roll - sin_lean * psi_dot,
            ],
            refused: sim_kernel::pivot_is_refused(pivot_psi_dot, pivot_psi_dot),
        }
    }
    /// The rates of the generalised speeds (3) and the multipliers of those constraints that they do not satisfy by construction (0), from Kane's equations
    ///
    /// ```text
    /// [ N' M N  N' C_q' ] [ u'     ]   [ N' (Q - h - M c)                       ]
    /// [ C_q N   0       ] [ lambda ] = [ -(C_q q' + C_t)_q q' - (..)_t - C_q c  ]
    /// ```
    ///
    /// with `M = T_q' M T_q`, `h = T_q' M g`, `Q = T_q' F`, and `c` the accelerations where `u' = 0`. Where `refused` is set a pivot was too small and nothing else holds.
    ///
    /// Operations: 6 additions, 28 multiplications, 2 divisions, 1 sine-cosine pair.
    #[inline]
    pub fn speed_dynamics(
        &self,
        t: S,
        q: &[S; 5],
        u: &[S; 3],
    ) -> sim_kernel::SpeedDynamics<S, [S; 3], [S; 0]> {
        let [_, _, _, lean, _] = *q;
        let [roll, nod, turn] = *u;
        let ([sin_lean], [cos_lean]) = S::sin_cos_each([lean]);
        let pivot_psi_dot = cos_lean * cos_lean;
        let inverse_psi_dot = S::from_f64(1.0) / pivot_psi_dot;
        let psi_dot = inverse_psi_dot * cos_lean * turn;
        let w = cos_lean * nod;
        let psi_by_turn = cos_lean * inverse_psi_dot;
        let w_2 = self.k * pivot_psi_dot;
        let pivot_turn_dot = psi_by_turn * psi_by_turn * w_2;
        sim_kernel::SpeedDynamics {
            rates: [
                -(self.k_2 * psi_dot * w * self.inverse_roll_dot),
                (sin_lean * (self.k_4 - self.k * cos_lean * psi_dot * psi_dot)
                    + cos_lean * psi_dot * roll * self.pivot_roll_dot)
                    * self.inverse_nod_dot,
                -(psi_by_turn
                    * (self.mass_phi_phi * w * (roll - sin_lean * psi_dot)
                        + inverse_psi_dot * sin_lean * psi_dot * w * w_2)
                    * (S::from_f64(1.0) / pivot_turn_dot)),
            ],
            multipliers: [],
            refused: sim_kernel::pivot_is_refused(
                self.pivot_roll_dot,
                self.pivot_roll_dot,
            ) | sim_kernel::pivot_is_refused(self.pivot_nod_dot, self.pivot_nod_dot)
                | sim_kernel::pivot_is_refused(pivot_turn_dot, pivot_turn_dot)
                | sim_kernel::pivot_is_refused(pivot_psi_dot, pivot_psi_dot),
        }
    }
}
#[allow(non_snake_case, clippy::all, clippy::pedantic)]
impl<S: sim_kernel::Scalar> sim_kernel::Mechanism<S> for Wheel<S> {
    type Q = [S; 5];
    type L = [S; 2];
    type Z = [S; 7];
    type QQ = [[S; 5]; 5];
    type LQ = [[S; 5]; 2];
    type LL = [[S; 2]; 2];
    type ZZ = [[S; 7]; 7];
    type Entries = [S; 0];
    type Envelope = [S; 0];
    type Parameters = [S; 3];
    type Outputs = [S; 0];
    type OutputRates = [S; 0];
    type Events = [S; 0];
    type EventValues = [S; 0];
    type Activities = [S; 0];
    type Drawing = [S; 0];
    type QP = [[S; 3]; 5];
    type LP = [[S; 3]; 2];
    type Inputs = [sim_kernel::Input<S>; 0];
    type Prepared = WheelPrepared<S>;
    type On<T: sim_kernel::Scalar> = Wheel<T>;
    const DESCRIPTION: sim_kernel::Description = sim_kernel::Description {
        name: "wheel",
        type_name: "Wheel",
        docs: "A disc that rolls and leans, by the components of its angular velocity in the frame that does not spin with it.",
        declaration: "/// A disc that rolls and leans, by the components of its angular velocity in the frame that does not spin with it.\npub Wheel;\n\ncoordinates { x [m]; y [m]; psi [rad]; lean [rad]; phi [rad]; }\n\nparameters { m [kg] = 0.5; r [m] = 0.2; g [m/s^2] = 9.81; }\n\nlet S = rotation([0, 0, 1], psi)*rotation([1, 0, 0], lean);\nlet P = [x, y, r*cos(lean)];\nbodies { disc: mass m at P, inertia [m*r^2/4, m*r^2/2, m*r^2/4], attitude S*rotation([0, 1, 0], phi); }\nloads { gravity [0, 0, -g]; }\n\nlet slip = dot(P) + cross(omega(disc), S*[0, 0, -r]);\nconstraints { slip_x: slip.x = 0; slip_y: slip.y = 0; }\n\nlet w = transpose(S)*omega(disc);\nspeeds {\n    /// About the axis.\n    roll [rad/s] = w.y;\n    nod [rad/s] = w.x;\n    turn [rad/s] = w.z;\n}\n\ninitial { lean = -0.3; dot(psi) = 1.5; }\n",
        coordinates: &[
            sim_kernel::Coordinate {
                position: sim_kernel::Quantity {
                    name: "x",
                    unit: "m",
                    factor: 1f64,
                    is_length: true,
                    docs: "",
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
                start: sim_kernel::Start::Free,
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
                start: sim_kernel::Start::Free,
                speed_given: false,
            },
            sim_kernel::Coordinate {
                position: sim_kernel::Quantity {
                    name: "psi",
                    unit: "rad",
                    factor: 1f64,
                    is_length: false,
                    docs: "",
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
                start: sim_kernel::Start::Free,
                speed_given: true,
            },
            sim_kernel::Coordinate {
                position: sim_kernel::Quantity {
                    name: "lean",
                    unit: "rad",
                    factor: 1f64,
                    is_length: false,
                    docs: "",
                },
                speed: sim_kernel::Quantity {
                    name: "lean_dot",
                    unit: "rad/s",
                    factor: 1f64,
                    is_length: false,
                    docs: "",
                },
                acceleration: sim_kernel::Quantity {
                    name: "lean_ddot",
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
                    name: "phi",
                    unit: "rad",
                    factor: 1f64,
                    is_length: false,
                    docs: "",
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
                start: sim_kernel::Start::Free,
                speed_given: false,
            },
        ],
        parameters: &[
            sim_kernel::Quantity {
                name: "m",
                unit: "kg",
                factor: 1f64,
                is_length: false,
                docs: "",
            },
            sim_kernel::Quantity {
                name: "r",
                unit: "m",
                factor: 1f64,
                is_length: true,
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
                name: "slip_x",
                unit: "N",
                factor: 1f64,
                is_length: false,
                docs: "",
            },
            sim_kernel::Quantity {
                name: "slip_y",
                unit: "N",
                factor: 1f64,
                is_length: false,
                docs: "",
            },
        ],
        speed_constraints: &[0, 1],
        norm_constraints: &[],
        sparsity: &[],
        conditionals: &[],
        events: &[],
        outputs: &[],
        rated_outputs: &[],
        figures: &[],
        optional_kernels: &["dynamics_jacobian"],
        dimension: 3,
        drawing: &[],
    };
    fn defaults() -> Self {
        Self {
            m: S::from_f64(0.5f64),
            r: S::from_f64(0.2f64),
            g: S::from_f64(9.81f64),
        }
    }
    fn parameters(&self) -> [S; 3] {
        [self.m, self.r, self.g]
    }
    fn with_parameters(&self, parameters: [S; 3]) -> Self {
        Self {
            m: parameters[0],
            r: parameters[1],
            g: parameters[2],
            ..*self
        }
    }
    fn on<T: sim_kernel::Scalar>(
        &self,
        convert: impl ::core::ops::Fn(S) -> T,
    ) -> Wheel<T> {
        Wheel {
            m: convert(self.m),
            r: convert(self.r),
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
    const ROWS_LEFT: ::core::option::Option<&'static [::core::primitive::usize]> = ::core::option::Option::Some(
        <Self as sim_kernel::GeneralizedSpeeds<S>>::ROWS,
    );
    #[inline(always)]
    fn velocity_variables(&self, t: S, q: &[S; 5], qd: &[S; 5]) -> [S; 5] {
        sim_kernel::speeds::velocity_variables(self, t, q, qd)
    }
    #[inline(always)]
    fn prepared_velocities(
        prepared: &Self::Prepared,
        t: S,
        q: &[S; 5],
        v: &[S; 5],
    ) -> sim_kernel::Kinematics<S, [S; 5]> {
        sim_kernel::speeds::prepared_velocities::<S, Self>(prepared, t, q, v)
    }
    #[inline(always)]
    fn prepare(&self) -> WheelPrepared<S> {
        self.prepare()
    }
    #[inline(always)]
    fn prepared_dynamics(
        prepared: &Self::Prepared,
        t: S,
        q: &[S; 5],
        qd: &[S; 5],
    ) -> sim_kernel::Dynamics<S, [S; 5], [S; 2]> {
        prepared.dynamics(t, q, qd)
    }
    #[inline(always)]
    fn dynamics_jacobian(
        &self,
        t: S,
        q: &[S; 5],
        qd: &[S; 5],
    ) -> sim_kernel::DynamicsJacobian<S, [[S; 5]; 5], [[S; 5]; 2]> {
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
    fn constraints(&self, t: S, q: &[S; 5]) -> [S; 2] {
        self.constraints(t, q)
    }
    #[inline(always)]
    fn constraint_magnitudes(&self, t: S, q: &[S; 5]) -> [S; 2] {
        self.constraint_magnitudes(t, q)
    }
    #[inline(always)]
    fn constraint_jacobian(&self, t: S, q: &[S; 5]) -> [[S; 5]; 2] {
        self.constraint_jacobian(t, q)
    }
    #[inline(always)]
    fn constraint_time_derivative(&self, t: S, q: &[S; 5]) -> [S; 2] {
        self.constraint_time_derivative(t, q)
    }
    #[inline(always)]
    fn constraint_convective(&self, t: S, q: &[S; 5], qd: &[S; 5]) -> [S; 2] {
        self.constraint_convective(t, q, qd)
    }
    #[inline(always)]
    fn constraint_linearization(
        &self,
        t: S,
        q: &[S; 5],
    ) -> sim_kernel::ConstraintLinearization<[S; 2], [[S; 5]; 2]> {
        self.constraint_linearization(t, q)
    }
    #[inline(always)]
    fn kinetic_energy(&self, t: S, q: &[S; 5], qd: &[S; 5]) -> S {
        self.kinetic_energy(t, q, qd)
    }
    #[inline(always)]
    fn power(&self, t: S, q: &[S; 5], qd: &[S; 5], qdd: &[S; 5], lambda: &[S; 2]) -> S {
        self.power(t, q, qd, qdd, lambda)
    }
    #[inline(always)]
    fn outputs(
        &self,
        t: S,
        q: &[S; 5],
        qd: &[S; 5],
        qdd: &[S; 5],
        lambda: &[S; 2],
    ) -> [S; 0] {
        self.outputs(t, q, qd, qdd, lambda).into()
    }
    #[inline(always)]
    fn output_rates(&self, t: S, q: &[S; 5], qd: &[S; 5], qdd: &[S; 5]) -> [S; 0] {
        self.output_rates(t, q, qd, qdd).into()
    }
    #[inline(always)]
    fn events(
        &self,
        t: S,
        q: &[S; 5],
        qd: &[S; 5],
        qdd: &[S; 5],
        lambda: &[S; 2],
    ) -> [S; 0] {
        self.events(t, q, qd, qdd, lambda)
    }
    #[inline(always)]
    fn drawing(&self, t: S, q: &[S; 5]) -> [S; 0] {
        self.drawing(t, q)
    }
    #[inline(always)]
    fn initial(&self) -> sim_kernel::Initial<[S; 5]> {
        self.initial()
    }
}
/// Generalised speeds of [`Wheel`] by name, in SI units; also for their rates.
#[allow(non_snake_case)]
#[derive(
    ::core::clone::Clone,
    ::core::marker::Copy,
    ::core::fmt::Debug,
    ::core::cmp::PartialEq
)]
pub struct WheelSpeeds<S = ::core::primitive::f64> {
    /// About the axis, in `rad/s`.
    pub roll: S,
    /// In `rad/s`.
    pub nod: S,
    /// In `rad/s`.
    pub turn: S,
}
impl<S: sim_kernel::Scalar> ::core::convert::From<[S; 3]> for WheelSpeeds<S> {
    fn from(values: [S; 3]) -> Self {
        Self {
            roll: values[0],
            nod: values[1],
            turn: values[2],
        }
    }
}
impl<S: sim_kernel::Scalar> ::core::convert::From<WheelSpeeds<S>> for [S; 3] {
    fn from(record: WheelSpeeds<S>) -> Self {
        [record.roll, record.nod, record.turn]
    }
}
#[allow(non_snake_case, clippy::all, clippy::pedantic)]
impl<S: sim_kernel::Scalar> sim_kernel::GeneralizedSpeeds<S> for Wheel<S> {
    type U = [S; 3];
    type R = [S; 0];
    const SPEEDS: &'static [sim_kernel::Quantity] = &[
        sim_kernel::Quantity {
            name: "roll",
            unit: "rad/s",
            factor: 1f64,
            is_length: false,
            docs: "About the axis.",
        },
        sim_kernel::Quantity {
            name: "nod",
            unit: "rad/s",
            factor: 1f64,
            is_length: false,
            docs: "",
        },
        sim_kernel::Quantity {
            name: "turn",
            unit: "rad/s",
            factor: 1f64,
            is_length: false,
            docs: "",
        },
    ];
    const ROWS: &'static [::core::primitive::usize] = &[];
    #[inline(always)]
    fn prepared_kinematics(
        prepared: &Self::Prepared,
        t: S,
        q: &[S; 5],
        u: &[S; 3],
    ) -> sim_kernel::Kinematics<S, [S; 5]> {
        prepared.kinematics(t, q, u)
    }
    #[inline(always)]
    fn prepared_speed_dynamics(
        prepared: &Self::Prepared,
        t: S,
        q: &[S; 5],
        u: &[S; 3],
    ) -> sim_kernel::SpeedDynamics<S, [S; 3], [S; 0]> {
        prepared.speed_dynamics(t, q, u)
    }
    #[inline(always)]
    fn generalized_speeds(&self, t: S, q: &[S; 5], qd: &[S; 5]) -> [S; 3] {
        self.generalized_speeds(t, q, qd)
    }
}
