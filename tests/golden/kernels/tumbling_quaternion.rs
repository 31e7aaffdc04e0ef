/// A free rigid body that tumbles, by a quaternion.
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
/// coordinates = [
///     body_x;
///     body_y;
///     body_z;
///     body_q0;
///     body_q1;
///     body_q2;
///     body_q3
/// ]
/// multipliers = [lambda_body_norm]
/// constraints = 0
/// [
///     m, 0, 0, 0, 0, 0, 0, 0;
///     0, m, 0, 0, 0, 0, 0, 0;
///     0, 0, m, 0, 0, 0, 0, 0;
///     0, 0, 0, mass_matrix[4, 4], mass_matrix[4, 5], mass_matrix[4, 6], mass_matrix[4, 7], 2*body_q0;
///     0, 0, 0, mass_matrix[4, 5], mass_matrix[5, 5], mass_matrix[5, 6], mass_matrix[5, 7], 2*body_q1;
///     0, 0, 0, mass_matrix[4, 6], mass_matrix[5, 6], mass_matrix[6, 6], mass_matrix[6, 7], 2*body_q2;
///     0, 0, 0, mass_matrix[4, 7], mass_matrix[5, 7], mass_matrix[6, 7], mass_matrix[7, 7], 2*body_q3;
///     0, 0, 0, 2*body_q0, 2*body_q1, 2*body_q2, 2*body_q3, 0
/// ] * [
///     body_x_ddot;
///     body_y_ddot;
///     body_z_ddot;
///     body_q0_ddot;
///     body_q1_ddot;
///     body_q2_ddot;
///     body_q3_ddot;
///     lambda_body_norm
/// ] = [
///     0;
///     0;
///     0;
///     -convective_forces[4];
///     -convective_forces[5];
///     -convective_forces[6];
///     -convective_forces[7];
///     -constraint_convective[1]
/// ]
///
/// mass_matrix = [
///     m, 0, 0, 0, 0, 0, 0;
///     0, m, 0, 0, 0, 0, 0;
///     0, 0, m, 0, 0, 0, 0;
///     0, 0, 0, mass_matrix[4, 4], mass_matrix[4, 5], mass_matrix[4, 6], mass_matrix[4, 7];
///     0, 0, 0, mass_matrix[4, 5], mass_matrix[5, 5], mass_matrix[5, 6], mass_matrix[5, 7];
///     0, 0, 0, mass_matrix[4, 6], mass_matrix[5, 6], mass_matrix[6, 6], mass_matrix[6, 7];
///     0, 0, 0, mass_matrix[4, 7], mass_matrix[5, 7], mass_matrix[6, 7], mass_matrix[7, 7]
/// ]
/// mass_matrix[4, 4] = 4*body_q1^2*A/ss_1^2 + 4*body_q2^2*B/ss_1^2 + 4*body_q3^2*C/ss_1^2
///     + 4*body_q0^2*(A + B + C)/3
/// mass_matrix[4, 5] = 4*body_q2*body_q3*B/ss_1^2 - 4*body_q0*body_q1*A/ss_1^2 - 4*body_q2*body_q3*C/ss_1^2
///     + 4*body_q0*body_q1*(A + B + C)/3
/// mass_matrix[4, 6] = 4*body_q1*body_q3*C/ss_1^2 - 4*body_q1*body_q3*A/ss_1^2 - 4*body_q0*body_q2*B/ss_1^2
///     + 4*body_q0*body_q2*(A + B + C)/3
/// mass_matrix[4, 7] = 4*body_q1*body_q2*A/ss_1^2 - 4*body_q1*body_q2*B/ss_1^2 - 4*body_q0*body_q3*C/ss_1^2
///     + 4*body_q0*body_q3*(A + B + C)/3
/// mass_matrix[5, 5] = 4*body_q0^2*A/ss_1^2 + 4*body_q3^2*B/ss_1^2 + 4*body_q2^2*C/ss_1^2
///     + 4*body_q1^2*(A + B + C)/3
/// mass_matrix[5, 6] = 4*body_q0*body_q3*A/ss_1^2 - 4*body_q0*body_q3*B/ss_1^2 - 4*body_q1*body_q2*C/ss_1^2
///     + 4*body_q1*body_q2*(A + B + C)/3
/// mass_matrix[5, 7] = 4*body_q0*body_q2*C/ss_1^2 - 4*body_q0*body_q2*A/ss_1^2 - 4*body_q1*body_q3*B/ss_1^2
///     + 4*body_q1*body_q3*(A + B + C)/3
/// mass_matrix[6, 6] = 4*body_q3^2*A/ss_1^2 + 4*body_q0^2*B/ss_1^2 + 4*body_q1^2*C/ss_1^2
///     + 4*body_q2^2*(A + B + C)/3
/// mass_matrix[6, 7] = 4*body_q0*body_q1*B/ss_1^2 - 4*body_q2*body_q3*A/ss_1^2 - 4*body_q0*body_q1*C/ss_1^2
///     + 4*body_q2*body_q3*(A + B + C)/3
/// mass_matrix[7, 7] = 4*body_q2^2*A/ss_1^2 + 4*body_q1^2*B/ss_1^2 + 4*body_q0^2*C/ss_1^2
///     + 4*body_q3^2*(A + B + C)/3
///
/// convective_forces = [
///     0;
///     0;
///     0;
///     convective_forces[4];
///     convective_forces[5];
///     convective_forces[6];
///     convective_forces[7]
/// ]
/// convective_forces[4] = 4*body_q0*ss_6*(A + B + C)/3 - 8*body_q1*ss_7/ss_1 - 8*body_q2*ss_8/ss_1
///     - 8*body_q3*ss_9/ss_1
/// convective_forces[5] = 8*body_q0*ss_7/ss_1 - 8*body_q3*ss_8/ss_1 + 8*body_q2*ss_9/ss_1
///     + 4*body_q1*ss_6*(A + B + C)/3
/// convective_forces[6] = 8*body_q3*ss_7/ss_1 + 8*body_q0*ss_8/ss_1 - 8*body_q1*ss_9/ss_1
///     + 4*body_q2*ss_6*(A + B + C)/3
/// convective_forces[7] = 8*body_q1*ss_8/ss_1 - 8*body_q2*ss_7/ss_1 + 8*body_q0*ss_9/ss_1
///     + 4*body_q3*ss_6*(A + B + C)/3
///
/// generalized_forces = [0; 0; 0; 0; 0; 0; 0]
///
/// constraints = [constraints[1]]
/// constraints[1] = body_q0^2 + body_q1^2 + body_q2^2 + body_q3^2 - 1
///
/// constraint_jacobian = [
///     0, 0, 0, 2*body_q0, 2*body_q1, 2*body_q2, 2*body_q3
/// ]
///
/// constraint_convective = [constraint_convective[1]]
/// constraint_convective[1] = 2*body_q0_dot^2 + 2*body_q1_dot^2 + 2*body_q2_dot^2 + 2*body_q3_dot^2
///
/// ss_1 = body_q0^2 + body_q1^2 + body_q2^2 + body_q3^2
/// ss_2 = body_q0*body_q1_dot - body_q1*body_q0_dot - body_q2*body_q3_dot + body_q3*body_q2_dot
/// ss_3 = body_q0*body_q2_dot - body_q2*body_q0_dot - body_q3*body_q1_dot + body_q1*body_q3_dot
/// ss_4 = body_q0*body_q3_dot - body_q3*body_q0_dot - body_q1*body_q2_dot + body_q2*body_q1_dot
/// ss_5 = body_q0*body_q0_dot + body_q1*body_q1_dot + body_q2*body_q2_dot + body_q3*body_q3_dot
/// ss_6 = body_q0_dot^2 + body_q1_dot^2 + body_q2_dot^2 + body_q3_dot^2
/// ss_7 = C*ss_3*ss_4/ss_1^2 - B*ss_3*ss_4/ss_1^2 - A*ss_2*ss_5/ss_1^2
/// ss_8 = A*ss_2*ss_4/ss_1^2 - C*ss_2*ss_4/ss_1^2 - B*ss_3*ss_5/ss_1^2
/// ss_9 = B*ss_2*ss_3/ss_1^2 - A*ss_2*ss_3/ss_1^2 - C*ss_4*ss_5/ss_1^2
/// ```
#[allow(non_snake_case)]
#[derive(
    ::core::clone::Clone,
    ::core::marker::Copy,
    ::core::fmt::Debug,
    ::core::cmp::PartialEq
)]
pub struct TumblingQuaternion<S = ::core::primitive::f64> {
    /// Principal moments of inertia, in `kg*m^2`.
    pub A: S,
    /// In `kg*m^2`.
    pub B: S,
    /// In `kg*m^2`.
    pub C: S,
    /// In `kg`.
    pub m: S,
    /// Angular momentum, in `N*m*s`.
    pub H: S,
    /// Angle between the third axis and the angular momentum at the start, in `1`.
    pub theta0: S,
}
impl<S: sim_kernel::Scalar> ::core::default::Default for TumblingQuaternion<S> {
    /// The declared values.
    fn default() -> Self {
        <Self as sim_kernel::Mechanism<S>>::defaults()
    }
}
/// Coordinates of [`TumblingQuaternion`] by name, in SI units; also for their speeds and accelerations.
#[allow(non_snake_case)]
#[derive(
    ::core::clone::Clone,
    ::core::marker::Copy,
    ::core::fmt::Debug,
    ::core::cmp::PartialEq
)]
pub struct TumblingQuaternionCoordinates<S = ::core::primitive::f64> {
    /// In `m`.
    pub body_x: S,
    /// In `m`.
    pub body_y: S,
    /// In `m`.
    pub body_z: S,
    /// In `1`.
    pub body_q0: S,
    /// In `1`.
    pub body_q1: S,
    /// In `1`.
    pub body_q2: S,
    /// In `1`.
    pub body_q3: S,
}
impl<S: sim_kernel::Scalar> ::core::convert::From<[S; 7]>
for TumblingQuaternionCoordinates<S> {
    fn from(values: [S; 7]) -> Self {
        Self {
            body_x: values[0],
            body_y: values[1],
            body_z: values[2],
            body_q0: values[3],
            body_q1: values[4],
            body_q2: values[5],
            body_q3: values[6],
        }
    }
}
impl<S: sim_kernel::Scalar> ::core::convert::From<TumblingQuaternionCoordinates<S>>
for [S; 7] {
    fn from(record: TumblingQuaternionCoordinates<S>) -> Self {
        [
            record.body_x,
            record.body_y,
            record.body_z,
            record.body_q0,
            record.body_q1,
            record.body_q2,
            record.body_q3,
        ]
    }
}
/// Outputs of [`TumblingQuaternion`] by name, in SI units.
#[allow(non_snake_case)]
#[derive(
    ::core::clone::Clone,
    ::core::marker::Copy,
    ::core::fmt::Debug,
    ::core::cmp::PartialEq
)]
pub struct TumblingQuaternionOutputs<S = ::core::primitive::f64> {
    /// about the axis of least inertia, in `rad/s`.
    pub w1: S,
    /// about the intermediate axis, in `rad/s`.
    pub w2: S,
    /// about the axis of most inertia, in `rad/s`.
    pub w3: S,
    /// In `N*m*s`.
    pub Hx: S,
    /// In `N*m*s`.
    pub Hy: S,
    /// In `N*m*s`.
    pub Hz: S,
    /// kinetic energy, in `J`.
    pub energy: S,
    /// what keeps the norm: nothing, in `J`.
    pub norm_force: S,
}
impl<S: sim_kernel::Scalar> ::core::convert::From<[S; 8]>
for TumblingQuaternionOutputs<S> {
    fn from(values: [S; 8]) -> Self {
        Self {
            w1: values[0],
            w2: values[1],
            w3: values[2],
            Hx: values[3],
            Hy: values[4],
            Hz: values[5],
            energy: values[6],
            norm_force: values[7],
        }
    }
}
impl<S: sim_kernel::Scalar> ::core::convert::From<TumblingQuaternionOutputs<S>>
for [S; 8] {
    fn from(record: TumblingQuaternionOutputs<S>) -> Self {
        [
            record.w1,
            record.w2,
            record.w3,
            record.Hx,
            record.Hy,
            record.Hz,
            record.energy,
            record.norm_force,
        ]
    }
}
/// Rates of the outputs of [`TumblingQuaternion`] by name, in SI units.
#[allow(non_snake_case)]
#[derive(
    ::core::clone::Clone,
    ::core::marker::Copy,
    ::core::fmt::Debug,
    ::core::cmp::PartialEq
)]
pub struct TumblingQuaternionOutputRates<S = ::core::primitive::f64> {
    /// Rate of `w1`.
    pub w1: S,
    /// Rate of `w2`.
    pub w2: S,
    /// Rate of `w3`.
    pub w3: S,
    /// Rate of `Hx`.
    pub Hx: S,
    /// Rate of `Hy`.
    pub Hy: S,
    /// Rate of `Hz`.
    pub Hz: S,
    /// Rate of `energy`.
    pub energy: S,
}
impl<S: sim_kernel::Scalar> ::core::convert::From<[S; 7]>
for TumblingQuaternionOutputRates<S> {
    fn from(values: [S; 7]) -> Self {
        Self {
            w1: values[0],
            w2: values[1],
            w3: values[2],
            Hx: values[3],
            Hy: values[4],
            Hz: values[5],
            energy: values[6],
        }
    }
}
impl<S: sim_kernel::Scalar> ::core::convert::From<TumblingQuaternionOutputRates<S>>
for [S; 7] {
    fn from(record: TumblingQuaternionOutputRates<S>) -> Self {
        [record.w1, record.w2, record.w3, record.Hx, record.Hy, record.Hz, record.energy]
    }
}
/// What the equations of motion need of the parameters of [`TumblingQuaternion`], from [`TumblingQuaternion::prepare`]; its methods are the kernels of each step.
#[allow(non_snake_case)]
#[derive(
    ::core::clone::Clone,
    ::core::marker::Copy,
    ::core::fmt::Debug,
    ::core::cmp::PartialEq
)]
pub struct TumblingQuaternionPrepared<S = ::core::primitive::f64> {
    m: S,
    A: S,
    B: S,
    C: S,
    k: S,
    k_2: S,
    k_3: S,
    k_4: S,
    k_5: S,
    k_6: S,
    k_7: S,
    k_8: S,
    k_9: S,
    k_10: S,
    k_11: S,
    k_12: S,
    k_13: S,
    k_14: S,
    k_15: S,
    k_16: S,
    k_17: S,
    k_18: S,
    k_19: S,
    k_20: S,
    k_21: S,
    k_22: S,
    k_23: S,
    k_24: S,
    k_25: S,
    k_26: S,
    k_27: S,
    k_28: S,
    k_29: S,
    k_30: S,
    k_31: S,
    k_32: S,
    k_33: S,
    k_34: S,
    k_35: S,
    k_36: S,
}
#[allow(non_snake_case, unused_variables, unused_parens, clippy::all, clippy::pedantic)]
impl<S: sim_kernel::Scalar> TumblingQuaternion<S> {
    /// What the equations of motion need of the parameters, computed once for a set of parameters.
    ///
    /// Operations: 20 additions, 17 multiplications.
    #[inline]
    pub fn prepare(&self) -> TumblingQuaternionPrepared<S> {
        let w = self.A + self.B + self.C;
        let w_2 = S::from_f64(4.0) * self.A;
        let w_3 = S::from_f64(4.0) * self.B;
        let w_4 = S::from_f64(4.0) * self.C;
        let w_5 = self.A * S::from_f64(12.0);
        let w_6 = self.B * S::from_f64(12.0);
        let w_7 = self.C * S::from_f64(12.0);
        TumblingQuaternionPrepared {
            m: self.m,
            A: self.A,
            B: self.B,
            C: self.C,
            k: w,
            k_2: w_2,
            k_3: w_3,
            k_4: w_4,
            k_5: S::from_f64(1.3333333333333333) * w,
            k_6: w_3 - w_4,
            k_7: w_4 - w_2,
            k_8: w_2 - w_3,
            k_9: self.C - self.B,
            k_10: self.A - self.C,
            k_11: self.B - self.A,
            k_12: self.A * S::from_f64(6.0),
            k_13: self.B * S::from_f64(6.0),
            k_14: self.C * S::from_f64(6.0),
            k_15: self.A * S::from_f64(3.0),
            k_16: w_5,
            k_17: w_6,
            k_18: w_7,
            k_19: w_6 - w_7,
            k_20: self.B * S::from_f64(3.0),
            k_21: w_5 - w_7,
            k_22: self.C * S::from_f64(3.0),
            k_23: w_5 - w_6,
            k_24: self.A * S::from_f64(2.0),
            k_25: self.B * S::from_f64(2.0),
            k_26: self.C * S::from_f64(2.0),
            k_27: self.A - self.B,
            k_28: w_3 - w_2,
            k_29: self.B - self.C,
            k_30: w_4 - w_3,
            k_31: w_2 - w_4,
            k_32: w_7 - w_6,
            k_33: self.C - self.A,
            k_34: w_6 - w_5,
            k_35: w_7 - w_5,
            k_36: w * S::from_f64(2.6666666666666665),
        }
    }
    /// Mass matrix `T_q' M T_q`, 7 x 7, symmetric, in SI units.
    ///
    /// Operations: 31 additions, 58 multiplications, 1 division.
    #[inline]
    pub fn mass_matrix(&self, t: S, q: &[S; 7]) -> [[S; 7]; 7] {
        let [_, _, _, body_q0, body_q1, body_q2, body_q3] = *q;
        let body_q1_squared = body_q1 * body_q1;
        let body_q0_squared = body_q0 * body_q0;
        let body_q2_squared = body_q2 * body_q2;
        let body_q3_squared = body_q3 * body_q3;
        let w = S::from_f64(1.0)
            / (body_q1_squared + body_q0_squared + body_q2_squared + body_q3_squared);
        let w_squared = w * w;
        let w_2 = S::from_f64(4.0) * self.A;
        let w_3 = S::from_f64(4.0) * self.B;
        let w_4 = S::from_f64(4.0) * self.C;
        let w_5 = S::from_f64(1.3333333333333333) * (self.A + self.B + self.C);
        let w_6 = w_5 - w_squared * w_2;
        let w_7 = body_q2 * body_q3;
        let w_8 = w_squared * (w_3 - w_4);
        let mass_body_q1_body_q0 = body_q1 * body_q0 * w_6 + w_7 * w_8;
        let mass_body_q3_body_q2 = w_6 * w_7 + body_q1 * body_q0 * w_8;
        let w_9 = w_4 - w_2;
        let w_10 = body_q1 * body_q3;
        let w_11 = body_q0 * body_q2;
        let mass_body_q2_body_q0 = w_squared * (w_9 * w_10 - w_3 * w_11) + w_5 * w_11;
        let mass_body_q3_body_q1 = w_squared * (w_9 * w_11 - w_3 * w_10) + w_5 * w_10;
        let w_12 = w_2 - w_3;
        let w_13 = body_q1 * body_q2;
        let w_14 = body_q0 * body_q3;
        let mass_body_q3_body_q0 = w_squared * (w_12 * w_13 - w_4 * w_14) + w_5 * w_14;
        let mass_body_q2_body_q1 = w_squared * (w_12 * w_14 - w_4 * w_13) + w_5 * w_13;
        [
            [
                self.m,
                S::from_f64(0.0),
                S::from_f64(0.0),
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
                S::from_f64(0.0),
                S::from_f64(0.0),
            ],
            [
                S::from_f64(0.0),
                S::from_f64(0.0),
                self.m,
                S::from_f64(0.0),
                S::from_f64(0.0),
                S::from_f64(0.0),
                S::from_f64(0.0),
            ],
            [
                S::from_f64(0.0),
                S::from_f64(0.0),
                S::from_f64(0.0),
                w_squared
                    * (body_q1_squared * w_2 + body_q2_squared * w_3
                        + body_q3_squared * w_4) + body_q0_squared * w_5,
                mass_body_q1_body_q0,
                mass_body_q2_body_q0,
                mass_body_q3_body_q0,
            ],
            [
                S::from_f64(0.0),
                S::from_f64(0.0),
                S::from_f64(0.0),
                mass_body_q1_body_q0,
                w_squared
                    * (body_q0_squared * w_2 + body_q3_squared * w_3
                        + body_q2_squared * w_4) + body_q1_squared * w_5,
                mass_body_q2_body_q1,
                mass_body_q3_body_q1,
            ],
            [
                S::from_f64(0.0),
                S::from_f64(0.0),
                S::from_f64(0.0),
                mass_body_q2_body_q0,
                mass_body_q2_body_q1,
                w_squared
                    * (body_q3_squared * w_2 + body_q0_squared * w_3
                        + body_q1_squared * w_4) + body_q2_squared * w_5,
                mass_body_q3_body_q2,
            ],
            [
                S::from_f64(0.0),
                S::from_f64(0.0),
                S::from_f64(0.0),
                mass_body_q3_body_q0,
                mass_body_q3_body_q1,
                mass_body_q3_body_q2,
                w_squared
                    * (body_q2_squared * w_2 + body_q1_squared * w_3
                        + body_q0_squared * w_4) + body_q3_squared * w_5,
            ],
        ]
    }
    /// Convective forces `T_q' M g`, 7, with `g = (T_q q' + T_t)_q q' + (..)_t`: joules per unit of each coordinate.
    ///
    /// Operations: 38 additions, 66 multiplications, 1 division.
    #[inline]
    pub fn convective_forces(&self, t: S, q: &[S; 7], qd: &[S; 7]) -> [S; 7] {
        let [_, _, _, body_q0, body_q1, body_q2, body_q3] = *q;
        let [_, _, _, body_q0_dot, body_q1_dot, body_q2_dot, body_q3_dot] = *qd;
        let w = (body_q0_dot * body_q0_dot + body_q1_dot * body_q1_dot
            + body_q2_dot * body_q2_dot + body_q3_dot * body_q3_dot)
            * S::from_f64(1.3333333333333333) * (self.A + self.B + self.C);
        let w_2 = S::from_f64(1.0)
            / (body_q0 * body_q0 + body_q1 * body_q1 + body_q2 * body_q2
                + body_q3 * body_q3);
        let w_2_squared = w_2 * w_2;
        let w_3 = body_q0 * body_q2_dot - body_q2 * body_q0_dot - body_q3 * body_q1_dot
            + body_q1 * body_q3_dot;
        let w_4 = body_q0 * body_q3_dot - body_q3 * body_q0_dot - body_q1 * body_q2_dot
            + body_q2 * body_q1_dot;
        let w_5 = body_q0 * body_q1_dot - body_q1 * body_q0_dot - body_q2 * body_q3_dot
            + body_q3 * body_q2_dot;
        let w_6 = body_q0 * body_q0_dot + body_q1 * body_q1_dot + body_q2 * body_q2_dot
            + body_q3 * body_q3_dot;
        let w_7 = w_2_squared * (w_3 * w_4 * (self.C - self.B) - self.A * w_5 * w_6);
        let w_8 = w_2_squared * (w_4 * w_5 * (self.A - self.C) - w_3 * self.B * w_6);
        let w_9 = w_2_squared * (w_3 * w_5 * (self.B - self.A) - self.C * w_4 * w_6);
        [
            S::from_f64(0.0),
            S::from_f64(0.0),
            S::from_f64(0.0),
            body_q0 * w
                - S::from_f64(8.0) * w_2
                    * (body_q1 * w_7 + body_q2 * w_8 + body_q3 * w_9),
            S::from_f64(8.0) * w_2 * (body_q0 * w_7 - body_q3 * w_8 + body_q2 * w_9)
                + body_q1 * w,
            S::from_f64(8.0) * w_2 * (body_q3 * w_7 + body_q0 * w_8 - body_q1 * w_9)
                + body_q2 * w,
            S::from_f64(8.0) * w_2 * (body_q1 * w_8 - body_q2 * w_7 + body_q0 * w_9)
                + body_q3 * w,
        ]
    }
    /// Generalised forces `T_q' F`, 7: joules per unit of each coordinate.
    ///
    /// Operations: none.
    #[inline]
    pub fn generalized_forces(&self, t: S, q: &[S; 7], qd: &[S; 7]) -> [S; 7] {
        [
            S::from_f64(0.0),
            S::from_f64(0.0),
            S::from_f64(0.0),
            S::from_f64(0.0),
            S::from_f64(0.0),
            S::from_f64(0.0),
            S::from_f64(0.0),
        ]
    }
    /// Constraints `C`, 1, in SI units; zero throughout the motion.
    ///
    /// Operations: 4 additions, 4 multiplications.
    #[inline]
    pub fn constraints(&self, t: S, q: &[S; 7]) -> [S; 1] {
        let [_, _, _, body_q0, body_q1, body_q2, body_q3] = *q;
        [
            body_q0 * body_q0 - S::from_f64(1.0) + body_q1 * body_q1 + body_q2 * body_q2
                + body_q3 * body_q3,
        ]
    }
    /// The sum of the magnitudes of the terms of `C`, 1, in SI units: what its rounding is relative to.
    ///
    /// Operations: 8 additions, 4 multiplications.
    #[inline]
    pub fn constraint_magnitudes(&self, t: S, q: &[S; 7]) -> [S; 1] {
        let [_, _, _, body_q0, body_q1, body_q2, body_q3] = *q;
        [
            S::from_f64(1.0) + (body_q0 * body_q0).abs() + (body_q1 * body_q1).abs()
                + (body_q2 * body_q2).abs() + (body_q3 * body_q3).abs(),
        ]
    }
    /// Constraint Jacobian `C_q`, 1 x 7: units of each constraint per unit of each coordinate.
    ///
    /// Operations: 4 multiplications.
    #[inline]
    pub fn constraint_jacobian(&self, t: S, q: &[S; 7]) -> [[S; 7]; 1] {
        let [_, _, _, body_q0, body_q1, body_q2, body_q3] = *q;
        [
            [
                S::from_f64(0.0),
                S::from_f64(0.0),
                S::from_f64(0.0),
                body_q0 * S::from_f64(2.0),
                body_q1 * S::from_f64(2.0),
                body_q2 * S::from_f64(2.0),
                body_q3 * S::from_f64(2.0),
            ],
        ]
    }
    /// `C_t`, 1, units of `C` per second: the speeds obey `C_q q' + C_t = 0`.
    ///
    /// Operations: none.
    #[inline]
    pub fn constraint_time_derivative(&self, t: S, q: &[S; 7]) -> [S; 1] {
        [S::from_f64(0.0)]
    }
    /// `(C_q q' + C_t)_q q' + (..)_t`, 1, units of `C` per second squared: the part of `C''` without accelerations.
    ///
    /// Operations: 3 additions, 5 multiplications.
    #[inline]
    pub fn constraint_convective(&self, t: S, q: &[S; 7], qd: &[S; 7]) -> [S; 1] {
        let [_, _, _, body_q0_dot, body_q1_dot, body_q2_dot, body_q3_dot] = *qd;
        [
            S::from_f64(2.0)
                * (body_q0_dot * body_q0_dot + body_q1_dot * body_q1_dot
                    + body_q2_dot * body_q2_dot + body_q3_dot * body_q3_dot),
        ]
    }
    /// `C` (1), `C_q` (1 x 7) and `C_t` (1) together, in SI units, for projection.
    ///
    /// Operations: 4 additions, 8 multiplications.
    #[inline]
    pub fn constraint_linearization(
        &self,
        t: S,
        q: &[S; 7],
    ) -> sim_kernel::ConstraintLinearization<[S; 1], [[S; 7]; 1]> {
        let [_, _, _, body_q0, body_q1, body_q2, body_q3] = *q;
        sim_kernel::ConstraintLinearization {
            values: [
                body_q0 * body_q0 - S::from_f64(1.0) + body_q1 * body_q1
                    + body_q2 * body_q2 + body_q3 * body_q3,
            ],
            jacobian: [
                [
                    S::from_f64(0.0),
                    S::from_f64(0.0),
                    S::from_f64(0.0),
                    body_q0 * S::from_f64(2.0),
                    body_q1 * S::from_f64(2.0),
                    body_q2 * S::from_f64(2.0),
                    body_q3 * S::from_f64(2.0),
                ],
            ],
            time_derivative: [S::from_f64(0.0)],
        }
    }
    /// Kinetic energy `v' M v / 2`, in joules.
    ///
    /// Operations: 23 additions, 39 multiplications, 1 division.
    #[inline]
    pub fn kinetic_energy(&self, t: S, q: &[S; 7], qd: &[S; 7]) -> S {
        let [_, _, _, body_q0, body_q1, body_q2, body_q3] = *q;
        let [body_x_dot, body_y_dot, body_z_dot, body_q0_dot, body_q1_dot, body_q2_dot,
        body_q3_dot] = *qd;
        let w = S::from_f64(1.0)
            / (body_q0 * body_q0 + body_q1 * body_q1 + body_q2 * body_q2
                + body_q3 * body_q3);
        let w_2 = body_q0 * body_q1_dot - body_q1 * body_q0_dot - body_q2 * body_q3_dot
            + body_q3 * body_q2_dot;
        let w_3 = body_q0 * body_q2_dot - body_q2 * body_q0_dot - body_q3 * body_q1_dot
            + body_q1 * body_q3_dot;
        let w_4 = body_q0 * body_q3_dot - body_q3 * body_q0_dot - body_q1 * body_q2_dot
            + body_q2 * body_q1_dot;
        let w_5 = w * w
            * (w_2 * w_2 * S::from_f64(2.0) * self.A
                + w_3 * w_3 * S::from_f64(2.0) * self.B
                + w_4 * w_4 * S::from_f64(2.0) * self.C);
        let w_6 = body_q0 * body_q0_dot + body_q1 * body_q1_dot + body_q2 * body_q2_dot
            + body_q3 * body_q3_dot;
        w_5
            + S::from_f64(0.5) * self.m
                * (body_x_dot * body_x_dot + body_y_dot * body_y_dot
                    + body_z_dot * body_z_dot)
            + w_6 * w_6 * S::from_f64(0.6666666666666666) * (self.A + self.B + self.C)
    }
    /// Power of loads and drives, `F' v + lambda' C_t + T_t' (M x'' - F)`, in watts.
    ///
    /// Operations: none.
    #[inline]
    pub fn power(
        &self,
        t: S,
        q: &[S; 7],
        qd: &[S; 7],
        qdd: &[S; 7],
        lambda: &[S; 1],
    ) -> S {
        S::from_f64(0.0)
    }
    /// Outputs, 8, in SI units.
    ///
    /// Operations: 32 additions, 64 multiplications, 1 division.
    #[inline]
    pub fn outputs(
        &self,
        t: S,
        q: &[S; 7],
        qd: &[S; 7],
        qdd: &[S; 7],
        lambda: &[S; 1],
    ) -> TumblingQuaternionOutputs<S> {
        let [_, _, _, body_q0, body_q1, body_q2, body_q3] = *q;
        let [_, _, _, body_q0_dot, body_q1_dot, body_q2_dot, body_q3_dot] = *qd;
        let [lambda_body_norm] = *lambda;
        let w = body_q0 * body_q1_dot - body_q1 * body_q0_dot - body_q2 * body_q3_dot
            + body_q3 * body_q2_dot;
        let body_q1_squared = body_q1 * body_q1;
        let body_q2_squared = body_q2 * body_q2;
        let body_q3_squared = body_q3 * body_q3;
        let w_2 = S::from_f64(1.0)
            / (body_q0 * body_q0 + body_q1_squared + body_q2_squared + body_q3_squared);
        let w_3 = S::from_f64(2.0) * w_2;
        let w_4 = body_q0 * body_q2_dot - body_q2 * body_q0_dot - body_q3 * body_q1_dot
            + body_q1 * body_q3_dot;
        let w_5 = body_q0 * body_q3_dot - body_q3 * body_q0_dot - body_q1 * body_q2_dot
            + body_q2 * body_q1_dot;
        let w_2_squared = w_2 * w_2;
        let w_6 = body_q1 * body_q2;
        let w_7 = body_q0 * body_q3;
        let w_8 = w_4 * S::from_f64(4.0) * self.B;
        let w_9 = body_q1 * body_q3;
        let w_10 = body_q0 * body_q2;
        let w_11 = w_5 * S::from_f64(4.0) * self.C;
        let w_12 = S::from_f64(2.0) * self.A;
        let w_13 = w * self.A * S::from_f64(4.0);
        let w_14 = body_q2 * body_q3;
        let w_15 = body_q0 * body_q1;
        let w_16 = S::from_f64(2.0) * self.B;
        let w_17 = S::from_f64(2.0) * self.C;
        [
            w * w_3,
            w_3 * w_4,
            w_3 * w_5,
            w_2_squared * ((w_6 - w_7) * w_8 + (w_9 + w_10) * w_11)
                - w_2 * w
                    * (w_3 * (body_q2_squared + body_q3_squared) - S::from_f64(1.0))
                    * w_12,
            w_2_squared * ((w_6 + w_7) * w_13 + w_11 * (w_14 - w_15))
                - w_2 * w_4
                    * (w_3 * (body_q1_squared + body_q3_squared) - S::from_f64(1.0))
                    * w_16,
            w_2_squared * (w_13 * (w_9 - w_10) + w_8 * (w_14 + w_15))
                - w_2 * w_5
                    * (w_3 * (body_q1_squared + body_q2_squared) - S::from_f64(1.0))
                    * w_17,
            w_2_squared * (w_12 * w * w + w_16 * w_4 * w_4 + w_17 * w_5 * w_5),
            lambda_body_norm,
        ]
            .into()
    }
    /// Rates of the outputs that depend on neither accelerations nor multipliers, 7, in SI units per second.
    ///
    /// Operations: 92 additions, 142 multiplications, 1 division.
    #[inline]
    pub fn output_rates(
        &self,
        t: S,
        q: &[S; 7],
        qd: &[S; 7],
        qdd: &[S; 7],
    ) -> TumblingQuaternionOutputRates<S> {
        let [_, _, _, body_q0, body_q1, body_q2, body_q3] = *q;
        let [_, _, _, body_q0_dot, body_q1_dot, body_q2_dot, body_q3_dot] = *qd;
        let [_, _, _, body_q0_ddot, body_q1_ddot, body_q2_ddot, body_q3_ddot] = *qdd;
        let w = body_q0 * body_q1_ddot - body_q1 * body_q0_ddot - body_q2 * body_q3_ddot
            + body_q3 * body_q2_ddot;
        let body_q1_squared = body_q1 * body_q1;
        let body_q2_squared = body_q2 * body_q2;
        let body_q3_squared = body_q3 * body_q3;
        let w_2 = S::from_f64(1.0)
            / (body_q0 * body_q0 + body_q1_squared + body_q2_squared + body_q3_squared);
        let w_3 = S::from_f64(2.0) * w_2;
        let w_4 = body_q0 * body_q1_dot;
        let w_5 = body_q1 * body_q0_dot;
        let w_6 = body_q2 * body_q3_dot;
        let w_7 = body_q3 * body_q2_dot;
        let w_8 = w_4 - w_5 - w_6 + w_7;
        let w_2_squared = w_2 * w_2;
        let w_9 = body_q1 * body_q1_dot;
        let w_10 = body_q2 * body_q2_dot;
        let w_11 = body_q3 * body_q3_dot;
        let w_12 = body_q0 * body_q0_dot + w_9 + w_10 + w_11;
        let w_13 = w_2_squared * w_12;
        let w_14 = S::from_f64(4.0) * w_13;
        let w_15 = body_q0 * body_q2_ddot - body_q2 * body_q0_ddot
            - body_q3 * body_q1_ddot + body_q1 * body_q3_ddot;
        let w_16 = body_q0 * body_q2_dot;
        let w_17 = body_q2 * body_q0_dot;
        let w_18 = body_q3 * body_q1_dot;
        let w_19 = body_q1 * body_q3_dot;
        let w_20 = w_16 - w_17 - w_18 + w_19;
        let w_21 = body_q0 * body_q3_ddot - body_q3 * body_q0_ddot
            - body_q1 * body_q2_ddot + body_q2 * body_q1_ddot;
        let w_22 = body_q0 * body_q3_dot;
        let w_23 = body_q3 * body_q0_dot;
        let w_24 = body_q1 * body_q2_dot;
        let w_25 = body_q2 * body_q1_dot;
        let w_26 = w_22 - w_23 - w_24 + w_25;
        let w_27 = S::from_f64(4.0) * self.B;
        let w_28 = body_q1 * body_q2;
        let w_29 = body_q0 * body_q3;
        let w_30 = w_28 - w_29;
        let w_46 = w_28 + w_29;
        let w_31 = S::from_f64(4.0) * self.C;
        let w_32 = body_q1 * body_q3;
        let w_33 = body_q0 * body_q2;
        let w_34 = w_32 + w_33;
        let w_58 = w_32 - w_33;
        let w_35 = w_31 * (w_26 * (w_16 + w_17 + w_18 + w_19) + w_21 * w_34);
        let w_36 = body_q2_squared + body_q3_squared;
        let w_51 = body_q1_squared + body_q3_squared;
        let w_61 = body_q1_squared + body_q2_squared;
        let w_37 = w_3 * w_36 - S::from_f64(1.0);
        let w_38 = S::from_f64(4.0) * self.A;
        let w_39 = w_8 * w_38;
        let w_40 = w_2_squared
            * (w_27 * (w_15 * w_30 - w_20 * (w_22 + w_23 - w_24 - w_25)) + w_35
                + w_12 * w_37 * w_39);
        let w_41 = self.A * S::from_f64(8.0);
        let w_42 = w_2
            * (w_8 * (w_13 * w_36 - w_2 * (w_10 + w_11)) * w_41
                - w * w_37 * S::from_f64(2.0) * self.A);
        let w_43 = w_2 * w_2_squared;
        let w_44 = w_20 * self.B * S::from_f64(16.0);
        let w_45 = w_26 * S::from_f64(16.0) * self.C;
        let w_47 = body_q2 * body_q3;
        let w_48 = body_q0 * body_q1;
        let w_49 = w_47 - w_48;
        let w_59 = w_47 + w_48;
        let w_50 = w_31 * (w_21 * w_49 - w_26 * (w_4 + w_5 - w_6 - w_7));
        let w_60 = w_27 * (w_20 * (w_4 + w_5 + w_6 + w_7) + w_15 * w_59);
        let w_53 = w_20 * w_27;
        let w_63 = w_26 * w_31;
        let w_52 = w_3 * w_51 - S::from_f64(1.0);
        let w_54 = w_2_squared
            * (w_38 * (w_8 * (w_22 + w_23 + w_24 + w_25) + w * w_46) + w_50
                + w_12 * w_52 * w_53);
        let w_55 = w_8 * self.A * S::from_f64(16.0);
        let w_56 = S::from_f64(8.0) * self.B;
        let w_57 = w_2
            * (w_20 * (w_13 * w_51 - w_2 * (w_9 + w_11)) * w_56
                - w_15 * w_52 * S::from_f64(2.0) * self.B);
        let w_62 = w_3 * w_61 - S::from_f64(1.0);
        let w_64 = w_2_squared
            * (w_38 * (w * w_58 - w_8 * (w_16 + w_17 - w_18 - w_19)) + w_60
                + w_12 * w_62 * w_63);
        let w_65 = S::from_f64(8.0) * self.C;
        let w_66 = w_2
            * (w_26 * (w_13 * w_61 - w_2 * (w_9 + w_10)) * w_65
                - w_21 * w_62 * S::from_f64(2.0) * self.C);
        let w_67 = w_12 * w_43
            * (w_41 * w_8 * w_8 + w_56 * w_20 * w_20 + w_65 * w_26 * w_26);
        [
            w * w_3 - w_8 * w_14,
            w_3 * w_15 - w_14 * w_20,
            w_3 * w_21 - w_14 * w_26,
            w_40 + w_42 - w_12 * w_43 * (w_30 * w_44 + w_34 * w_45),
            w_54 - w_12 * w_43 * (w_46 * w_55 + w_45 * w_49) + w_57,
            w_64 - w_12 * w_43 * (w_55 * w_58 + w_44 * w_59) + w_66,
            w_2_squared * (w * w_39 + w_15 * w_53 + w_21 * w_63) - w_67,
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
        q: &[S; 7],
        qd: &[S; 7],
        qdd: &[S; 7],
        lambda: &[S; 1],
    ) -> [S; 0] {
        []
    }
    /// The numbers of each shape of the drawing, in metres and radians.
    ///
    /// Operations: 36 additions, 25 multiplications, 1 division.
    #[inline]
    pub fn drawing(&self, t: S, q: &[S; 7]) -> [S; 30] {
        let [body_x, body_y, body_z, body_q0, body_q1, body_q2, body_q3] = *q;
        let body_q2_squared = body_q2 * body_q2;
        let body_q3_squared = body_q3 * body_q3;
        let body_q1_squared = body_q1 * body_q1;
        let w = S::from_f64(1.0)
            / (body_q0 * body_q0 + body_q1_squared + body_q2_squared + body_q3_squared);
        let w_2 = S::from_f64(2.0) * w;
        let w_3 = (body_q2_squared + body_q3_squared) * w_2;
        let w_22 = body_q1_squared + body_q2_squared;
        let w_4 = S::from_f64(1.0) + body_x - w_3;
        let w_5 = body_q1 * body_q2;
        let w_6 = body_q0 * body_q3;
        let w_7 = w_2 * (w_5 + w_6);
        let w_8 = body_y + w_7;
        let w_9 = body_q1 * body_q3;
        let w_10 = body_q0 * body_q2;
        let w_11 = w_2 * (w_9 - w_10);
        let w_19 = w_9 + w_10;
        let w_12 = body_z + w_11;
        let w_13 = w * S::from_f64(1.4);
        let w_14 = (w_5 - w_6) * w_13;
        let w_15 = w_13 * (body_q1_squared + body_q3_squared);
        let w_16 = body_q2 * body_q3;
        let w_17 = body_q0 * body_q1;
        let w_18 = w_13 * (w_16 + w_17);
        let w_21 = w_16 - w_17;
        let w_20 = w * S::from_f64(0.6);
        [
            w_4,
            w_8,
            w_12,
            body_x + w_14,
            body_y + S::from_f64(0.7) - w_15,
            body_z + w_18,
            body_x - S::from_f64(1.0) + w_3,
            body_y - w_7,
            body_z - w_11,
            body_x - w_14,
            body_y - S::from_f64(0.7) + w_15,
            body_z - w_18,
            w_4,
            w_8,
            w_12,
            body_x - w_19 * w_20,
            body_y - w_20 * w_21,
            body_z - S::from_f64(0.3) + w_20 * w_22,
            body_x + w * w_19,
            body_y + w * w_21,
            body_z + S::from_f64(0.5) - w * w_22,
            S::from_f64(0.0),
            S::from_f64(0.0),
            S::from_f64(0.0),
            S::from_f64(0.0),
            S::from_f64(0.0),
            S::from_f64(1.2),
            body_x,
            body_y,
            body_z,
        ]
    }
    /// Declared start: values or guesses of the coordinates (7), and speeds (7), in SI units; 0 where nothing is declared.
    ///
    /// Operations: 4 additions, 15 multiplications, 4 divisions, 3 sine-cosine pairs.
    #[inline]
    pub fn initial(&self) -> sim_kernel::Initial<[S; 7]> {
        let w = S::from_f64(0.5) * self.theta0;
        let ([sin_w, _, sin_theta0], [cos_w, w_2, cos_theta0]) = S::sin_cos_each([
            w,
            S::from_f64(0.25) * S::from_f64(::core::f64::consts::PI),
            self.theta0,
        ]);
        let c = cos_w * w_2;
        let s = w_2 * sin_w;
        let w_3 = S::from_f64(0.5) * w_2;
        let w_4 = self.H * sin_theta0;
        let w_5 = self.H * cos_theta0;
        let w_6 = sin_w * w_3 * w_4 / self.A + cos_w * w_3 * w_5 / self.C;
        let w_7 = cos_w * w_3 * w_4 / self.A - sin_w * w_3 * w_5 / self.C;
        sim_kernel::Initial {
            positions: [
                S::from_f64(0.0),
                S::from_f64(0.0),
                S::from_f64(0.0),
                c,
                s,
                -s,
                c,
            ],
            speeds: [
                S::from_f64(0.0),
                S::from_f64(0.0),
                S::from_f64(0.0),
                -w_6,
                w_7,
                w_7,
                w_6,
            ],
        }
    }
    /// [`TumblingQuaternionPrepared::dynamics`] once; for many calls with the same parameters [`Self::prepare`] first.
    #[inline]
    pub fn dynamics(
        &self,
        t: S,
        q: &[S; 7],
        qd: &[S; 7],
    ) -> sim_kernel::Dynamics<S, [S; 7], [S; 1]> {
        self.prepare().dynamics(t, q, qd)
    }
    /// [`TumblingQuaternionPrepared::dynamics_jacobian`] once; for many calls with the same parameters [`Self::prepare`] first.
    #[inline]
    pub fn dynamics_jacobian(
        &self,
        t: S,
        q: &[S; 7],
        qd: &[S; 7],
    ) -> sim_kernel::DynamicsJacobian<S, [[S; 7]; 7], [[S; 7]; 1]> {
        self.prepare().dynamics_jacobian(t, q, qd)
    }
}
#[allow(non_snake_case, unused_variables, unused_parens, clippy::all, clippy::pedantic)]
impl<S: sim_kernel::Scalar> TumblingQuaternionPrepared<S> {
    /// Accelerations (7), multipliers (1) and power, from
    ///
    /// ```text
    /// [ T_q' M T_q   C_q' ] [ q''    ]   [ T_q' (F - M g)                      ]
    /// [ C_q          0    ] [ lambda ] = [ -(C_q q' + C_t)_q q' - (..)_t       ]
    /// ```
    ///
    /// by an elimination planned from the structure of the system. Where `refused` is set a pivot was too small and nothing else holds: solve that state from the other kernels.
    ///
    /// Operations: 96 additions, 174 multiplications, 6 divisions.
    #[inline(always)]
    pub fn dynamics(
        &self,
        t: S,
        q: &[S; 7],
        qd: &[S; 7],
    ) -> sim_kernel::Dynamics<S, [S; 7], [S; 1]> {
        let [_, _, _, body_q0, body_q1, body_q2, body_q3] = *q;
        let [_, _, _, body_q0_dot, body_q1_dot, body_q2_dot, body_q3_dot] = *qd;
        let body_q1_squared = body_q1 * body_q1;
        let body_q0_squared = body_q0 * body_q0;
        let body_q2_squared = body_q2 * body_q2;
        let body_q3_squared = body_q3 * body_q3;
        let w = S::from_f64(1.0)
            / (body_q1_squared + body_q0_squared + body_q2_squared + body_q3_squared);
        let w_squared = w * w;
        let w_2 = body_q0 * body_q2_dot - body_q2 * body_q0_dot - body_q3 * body_q1_dot
            + body_q1 * body_q3_dot;
        let w_3 = body_q0 * body_q3_dot - body_q3 * body_q0_dot - body_q1 * body_q2_dot
            + body_q2 * body_q1_dot;
        let w_4 = body_q0 * body_q1_dot - body_q1 * body_q0_dot - body_q2 * body_q3_dot
            + body_q3 * body_q2_dot;
        let w_5 = body_q0 * body_q0_dot + body_q1 * body_q1_dot + body_q2 * body_q2_dot
            + body_q3 * body_q3_dot;
        let w_6 = w_squared * (w_2 * w_3 * self.k_9 - self.A * w_4 * w_5);
        let w_7 = w_squared * (w_3 * w_4 * self.k_10 - self.B * w_2 * w_5);
        let w_8 = w_squared * (w_2 * w_4 * self.k_11 - self.C * w_3 * w_5);
        let w_9 = body_q0_dot * body_q0_dot + body_q1_dot * body_q1_dot
            + body_q2_dot * body_q2_dot + body_q3_dot * body_q3_dot;
        let w_10 = self.k_5 * w_9;
        let rhs_body_q0 = S::from_f64(8.0) * w
            * (body_q1 * w_6 + body_q2 * w_7 + body_q3 * w_8) - body_q0 * w_10;
        let w_11 = self.k_5 - w_squared * self.k_2;
        let w_12 = body_q2 * body_q3;
        let w_13 = w_squared * self.k_6;
        let mass_body_q1_body_q0 = body_q1 * body_q0 * w_11 + w_12 * w_13;
        let mass_body_q0_body_q0 = w_squared
            * (body_q1_squared * self.k_2 + body_q2_squared * self.k_3
                + body_q3_squared * self.k_4) + body_q0_squared * self.k_5;
        let inverse_body_q0 = S::from_f64(1.0) / mass_body_q0_body_q0;
        let l_body_q1_body_q0 = mass_body_q1_body_q0 * inverse_body_q0;
        let rhs_body_q1 = S::from_f64(8.0) * w
            * (body_q3 * w_7 - body_q0 * w_6 - body_q2 * w_8) - body_q1 * w_10
            - rhs_body_q0 * l_body_q1_body_q0;
        let w_14 = body_q1 * body_q3;
        let w_15 = body_q0 * body_q2;
        let mass_body_q2_body_q0 = w_squared * (self.k_7 * w_14 - self.k_3 * w_15)
            + self.k_5 * w_15;
        let l_body_q2_body_q0 = mass_body_q2_body_q0 * inverse_body_q0;
        let mass_body_q1_body_q1 = w_squared
            * (body_q0_squared * self.k_2 + body_q3_squared * self.k_3
                + body_q2_squared * self.k_4) + body_q1_squared * self.k_5;
        let pivot_body_q1 = mass_body_q1_body_q1
            - mass_body_q1_body_q0 * l_body_q1_body_q0;
        let inverse_body_q1 = S::from_f64(1.0) / pivot_body_q1;
        let w_16 = body_q0 * body_q3;
        let w_17 = body_q1 * body_q2;
        let k_body_q2_body_q1 = w_squared * (self.k_8 * w_16 - self.k_4 * w_17)
            + self.k_5 * w_17 - mass_body_q1_body_q0 * l_body_q2_body_q0;
        let mass_body_q3_body_q0 = w_squared * (self.k_8 * w_17 - self.k_4 * w_16)
            + self.k_5 * w_16;
        let l_body_q2_body_q1 = inverse_body_q1 * k_body_q2_body_q1;
        let rhs_body_q2 = S::from_f64(8.0) * w
            * (body_q1 * w_8 - body_q3 * w_6 - body_q0 * w_7) - body_q2 * w_10
            - rhs_body_q0 * l_body_q2_body_q0 - l_body_q2_body_q1 * rhs_body_q1;
        let l_body_q3_body_q0 = mass_body_q3_body_q0 * inverse_body_q0;
        let k_body_q3_body_q1 = w_squared * (self.k_7 * w_15 - self.k_3 * w_14)
            + self.k_5 * w_14 - mass_body_q1_body_q0 * l_body_q3_body_q0;
        let l_body_q3_body_q1 = inverse_body_q1 * k_body_q3_body_q1;
        let k_body_q3_body_q2 = w_11 * w_12 + body_q1 * body_q0 * w_13
            - mass_body_q2_body_q0 * l_body_q3_body_q0
            - k_body_q2_body_q1 * l_body_q3_body_q1;
        let mass_body_q2_body_q2 = w_squared
            * (body_q3_squared * self.k_2 + body_q0_squared * self.k_3
                + body_q1_squared * self.k_4) + body_q2_squared * self.k_5;
        let mass_body_q3_body_q3 = w_squared
            * (body_q2_squared * self.k_2 + body_q1_squared * self.k_3
                + body_q0_squared * self.k_4) + body_q3_squared * self.k_5;
        let pivot_body_q2 = mass_body_q2_body_q2
            - mass_body_q2_body_q0 * l_body_q2_body_q0
            - k_body_q2_body_q1 * l_body_q2_body_q1;
        let inverse_body_q2 = S::from_f64(1.0) / pivot_body_q2;
        let l_body_q3_body_q2 = inverse_body_q2 * k_body_q3_body_q2;
        let rhs_body_q3 = S::from_f64(8.0) * w
            * (body_q2 * w_6 - body_q1 * w_7 - body_q0 * w_8) - body_q3 * w_10
            - rhs_body_q0 * l_body_q3_body_q0 - l_body_q3_body_q1 * rhs_body_q1
            - l_body_q3_body_q2 * rhs_body_q2;
        let pivot_body_q3 = mass_body_q3_body_q3
            - mass_body_q3_body_q0 * l_body_q3_body_q0
            - k_body_q3_body_q1 * l_body_q3_body_q1
            - k_body_q3_body_q2 * l_body_q3_body_q2;
        let inverse_body_q3 = S::from_f64(1.0) / pivot_body_q3;
        let body_norm_by_body_q0 = body_q0 * S::from_f64(2.0);
        let l_lambda_body_norm_body_q0 = body_norm_by_body_q0 * inverse_body_q0;
        let k_lambda_body_norm_body_q1 = body_q1 * S::from_f64(2.0)
            - mass_body_q1_body_q0 * l_lambda_body_norm_body_q0;
        let l_lambda_body_norm_body_q1 = inverse_body_q1 * k_lambda_body_norm_body_q1;
        let k_lambda_body_norm_body_q2 = body_q2 * S::from_f64(2.0)
            - mass_body_q2_body_q0 * l_lambda_body_norm_body_q0
            - k_body_q2_body_q1 * l_lambda_body_norm_body_q1;
        let l_lambda_body_norm_body_q2 = inverse_body_q2 * k_lambda_body_norm_body_q2;
        let k_lambda_body_norm_body_q3 = body_q3 * S::from_f64(2.0)
            - mass_body_q3_body_q0 * l_lambda_body_norm_body_q0
            - k_body_q3_body_q1 * l_lambda_body_norm_body_q1
            - k_body_q3_body_q2 * l_lambda_body_norm_body_q2;
        let l_lambda_body_norm_body_q3 = inverse_body_q3 * k_lambda_body_norm_body_q3;
        let minus_pivot_lambda_body_norm = body_norm_by_body_q0
            * l_lambda_body_norm_body_q0
            + k_lambda_body_norm_body_q1 * l_lambda_body_norm_body_q1
            + k_lambda_body_norm_body_q2 * l_lambda_body_norm_body_q2
            + k_lambda_body_norm_body_q3 * l_lambda_body_norm_body_q3;
        let lambda_body_norm = S::from_f64(1.0) / minus_pivot_lambda_body_norm
            * (S::from_f64(2.0) * w_9 + rhs_body_q0 * l_lambda_body_norm_body_q0
                + l_lambda_body_norm_body_q1 * rhs_body_q1
                + l_lambda_body_norm_body_q2 * rhs_body_q2
                + l_lambda_body_norm_body_q3 * rhs_body_q3);
        let body_q3_ddot = inverse_body_q3 * rhs_body_q3
            - l_lambda_body_norm_body_q3 * lambda_body_norm;
        let body_q2_ddot = inverse_body_q2 * rhs_body_q2
            - l_body_q3_body_q2 * body_q3_ddot
            - l_lambda_body_norm_body_q2 * lambda_body_norm;
        let body_q1_ddot = inverse_body_q1 * rhs_body_q1
            - l_body_q2_body_q1 * body_q2_ddot - l_body_q3_body_q1 * body_q3_ddot
            - l_lambda_body_norm_body_q1 * lambda_body_norm;
        sim_kernel::Dynamics {
            accelerations: [
                S::from_f64(0.0),
                S::from_f64(0.0),
                S::from_f64(0.0),
                rhs_body_q0 * inverse_body_q0 - l_body_q1_body_q0 * body_q1_ddot
                    - l_body_q2_body_q0 * body_q2_ddot - l_body_q3_body_q0 * body_q3_ddot
                    - l_lambda_body_norm_body_q0 * lambda_body_norm,
                body_q1_ddot,
                body_q2_ddot,
                body_q3_ddot,
            ],
            multipliers: [lambda_body_norm],
            power: S::from_f64(0.0),
            refused: sim_kernel::pivot_is_refused(
                mass_body_q0_body_q0,
                mass_body_q0_body_q0,
            ) | sim_kernel::pivot_is_refused(pivot_body_q1, mass_body_q1_body_q1)
                | sim_kernel::pivot_is_refused(pivot_body_q2, mass_body_q2_body_q2)
                | sim_kernel::pivot_is_refused(pivot_body_q3, mass_body_q3_body_q3)
                | sim_kernel::pivot_is_refused(self.m, self.m)
                | sim_kernel::pivot_is_refused(self.m, self.m)
                | sim_kernel::pivot_is_refused(self.m, self.m)
                | sim_kernel::pivot_is_refused(
                    -minus_pivot_lambda_body_norm,
                    minus_pivot_lambda_body_norm,
                ),
        }
    }
    /// The derivatives of accelerations (7 rows) and multipliers (1 rows) with respect to coordinates and speeds (7 columns each): with the equations of motion as `K z = r`, the solutions of `K dz = dr - dK z`. Where `refused` is set a pivot was too small and nothing else holds.
    ///
    /// Operations: 663 additions, 1039 multiplications, 6 divisions.
    #[inline]
    pub fn dynamics_jacobian(
        &self,
        t: S,
        q: &[S; 7],
        qd: &[S; 7],
    ) -> sim_kernel::DynamicsJacobian<S, [[S; 7]; 7], [[S; 7]; 1]> {
        let [_, _, _, body_q0, body_q1, body_q2, body_q3] = *q;
        let [_, _, _, body_q0_dot, body_q1_dot, body_q2_dot, body_q3_dot] = *qd;
        let body_q1_squared = body_q1 * body_q1;
        let body_q0_squared = body_q0 * body_q0;
        let body_q2_squared = body_q2 * body_q2;
        let body_q3_squared = body_q3 * body_q3;
        let w = S::from_f64(1.0)
            / (body_q1_squared + body_q0_squared + body_q2_squared + body_q3_squared);
        let w_squared = w * w;
        let w_2 = body_q0 * body_q2_dot - body_q2 * body_q0_dot - body_q3 * body_q1_dot
            + body_q1 * body_q3_dot;
        let w_3 = body_q0 * body_q3_dot - body_q3 * body_q0_dot - body_q1 * body_q2_dot
            + body_q2 * body_q1_dot;
        let w_4 = w_3 * self.k_9;
        let w_5 = body_q0 * body_q1_dot - body_q1 * body_q0_dot - body_q2 * body_q3_dot
            + body_q3 * body_q2_dot;
        let w_6 = body_q0 * body_q0_dot + body_q1 * body_q1_dot + body_q2 * body_q2_dot
            + body_q3 * body_q3_dot;
        let w_7 = w_5 * w_6;
        let w_8 = w_squared * (w_2 * w_4 - self.A * w_7);
        let w_43 = self.k_2 * w_7;
        let w_9 = body_q1 * w_8;
        let w_10 = w_5 * self.k_10;
        let w_11 = w_2 * w_6;
        let w_12 = w_squared * (w_3 * w_10 - self.B * w_11);
        let w_51 = self.k_3 * w_11;
        let w_13 = body_q2 * w_12;
        let w_14 = w_2 * self.k_11;
        let w_15 = w_3 * w_6;
        let w_16 = w_squared * (w_5 * w_14 - self.C * w_15);
        let w_59 = self.k_4 * w_15;
        let w_17 = body_q3 * w_16;
        let w_18 = w_9 + w_13 + w_17;
        let w_19 = body_q0_dot * body_q0_dot + body_q1_dot * body_q1_dot
            + body_q2_dot * body_q2_dot + body_q3_dot * body_q3_dot;
        let w_20 = self.k_5 * w_19;
        let rhs_body_q0 = S::from_f64(8.0) * w * w_18 - body_q0 * w_20;
        let w_21 = body_q3 * w_12;
        let w_22 = body_q0 * w_8;
        let w_23 = body_q2 * w_16;
        let w_24 = self.k_5 - w_squared * self.k_2;
        let w_25 = body_q2 * body_q3;
        let w_26 = w_squared * self.k_6;
        let mass_body_q1_body_q0 = body_q1 * body_q0 * w_24 + w_25 * w_26;
        let mass_body_q0_body_q0 = w_squared
            * (body_q1_squared * self.k_2 + body_q2_squared * self.k_3
                + body_q3_squared * self.k_4) + body_q0_squared * self.k_5;
        let inverse_body_q0 = S::from_f64(1.0) / mass_body_q0_body_q0;
        let l_body_q1_body_q0 = mass_body_q1_body_q0 * inverse_body_q0;
        let rhs_body_q1 = S::from_f64(8.0) * w * (w_21 - w_22 - w_23) - body_q1 * w_20
            - rhs_body_q0 * l_body_q1_body_q0;
        let w_27 = body_q1 * w_16;
        let w_28 = body_q3 * w_8;
        let w_29 = body_q0 * w_12;
        let w_30 = body_q1 * body_q3;
        let w_31 = body_q0 * body_q2;
        let mass_body_q2_body_q0 = w_squared * (self.k_7 * w_30 - self.k_3 * w_31)
            + self.k_5 * w_31;
        let l_body_q2_body_q0 = mass_body_q2_body_q0 * inverse_body_q0;
        let mass_body_q1_body_q1 = w_squared
            * (body_q0_squared * self.k_2 + body_q3_squared * self.k_3
                + body_q2_squared * self.k_4) + body_q1_squared * self.k_5;
        let pivot_body_q1 = mass_body_q1_body_q1
            - mass_body_q1_body_q0 * l_body_q1_body_q0;
        let inverse_body_q1 = S::from_f64(1.0) / pivot_body_q1;
        let w_32 = body_q0 * body_q3;
        let w_33 = body_q1 * body_q2;
        let k_body_q2_body_q1 = w_squared * (self.k_8 * w_32 - self.k_4 * w_33)
            + self.k_5 * w_33 - mass_body_q1_body_q0 * l_body_q2_body_q0;
        let l_body_q2_body_q1 = inverse_body_q1 * k_body_q2_body_q1;
        let rhs_body_q2 = S::from_f64(8.0) * w * (w_27 - w_28 - w_29) - body_q2 * w_20
            - rhs_body_q0 * l_body_q2_body_q0 - l_body_q2_body_q1 * rhs_body_q1;
        let w_34 = body_q2 * w_8;
        let w_35 = body_q1 * w_12;
        let w_36 = body_q0 * w_16;
        let mass_body_q3_body_q0 = w_squared * (self.k_8 * w_33 - self.k_4 * w_32)
            + self.k_5 * w_32;
        let w_97 = self.k_2 * w_32;
        let l_body_q3_body_q0 = mass_body_q3_body_q0 * inverse_body_q0;
        let k_body_q3_body_q1 = w_squared * (self.k_7 * w_31 - self.k_3 * w_30)
            + self.k_5 * w_30 - mass_body_q1_body_q0 * l_body_q3_body_q0;
        let l_body_q3_body_q1 = inverse_body_q1 * k_body_q3_body_q1;
        let k_body_q3_body_q2 = w_24 * w_25 + body_q1 * body_q0 * w_26
            - mass_body_q2_body_q0 * l_body_q3_body_q0
            - k_body_q2_body_q1 * l_body_q3_body_q1;
        let mass_body_q2_body_q2 = w_squared
            * (body_q3_squared * self.k_2 + body_q0_squared * self.k_3
                + body_q1_squared * self.k_4) + body_q2_squared * self.k_5;
        let pivot_body_q2 = mass_body_q2_body_q2
            - mass_body_q2_body_q0 * l_body_q2_body_q0
            - k_body_q2_body_q1 * l_body_q2_body_q1;
        let inverse_body_q2 = S::from_f64(1.0) / pivot_body_q2;
        let l_body_q3_body_q2 = inverse_body_q2 * k_body_q3_body_q2;
        let rhs_body_q3 = S::from_f64(8.0) * w * (w_34 - w_35 - w_36) - body_q3 * w_20
            - rhs_body_q0 * l_body_q3_body_q0 - l_body_q3_body_q1 * rhs_body_q1
            - l_body_q3_body_q2 * rhs_body_q2;
        let w_37 = body_q2_dot * w_3;
        let w_38 = body_q3_dot * w_2;
        let w_39 = body_q1_dot * w_6;
        let w_40 = body_q0_dot * w_5;
        let w_41 = w * w_squared;
        let w_42 = w_2 * w_3;
        let w_44 = w_41 * (self.k_6 * w_42 + w_43);
        let w_153 = w_42 * self.k_30 - w_43;
        let w_45 = w_squared * (self.k_9 * (w_37 + w_38) - self.A * (w_39 + w_40))
            + body_q0 * w_44;
        let w_46 = body_q1_dot * w_3;
        let w_47 = body_q3_dot * w_5;
        let w_48 = body_q2_dot * w_6;
        let w_49 = body_q0_dot * w_2;
        let w_50 = w_3 * w_5;
        let w_52 = self.k_7 * w_50 + w_51;
        let w_117 = w_50 * self.k_31 - w_51;
        let w_53 = w_squared * (self.k_10 * (w_46 + w_47) - self.B * (w_48 + w_49))
            + body_q0 * w_41 * w_52;
        let w_54 = body_q1_dot * w_2;
        let w_55 = body_q2_dot * w_5;
        let w_56 = body_q3_dot * w_6;
        let w_57 = body_q0_dot * w_3;
        let w_58 = w_2 * w_5;
        let w_60 = w_squared * (self.k_11 * (w_54 + w_55) - self.C * (w_56 + w_57))
            + body_q0 * w_41 * (self.k_8 * w_58 + w_59);
        let w_118 = w_squared * (self.B * (w_54 + w_56) + self.k_10 * (w_55 + w_57))
            + body_q1 * w_41 * w_117;
        let w_154 = w_squared
            * (self.A * (w_55 - w_56) + w_54 * self.k_29 + body_q0_dot * w_4)
            + body_q2 * w_41 * w_153;
        let w_120 = w_58 * self.k_28 - w_59;
        let w_61 = S::from_f64(8.0) * w
            * (body_q1 * w_45 + body_q2 * w_53 + body_q3 * w_60);
        let mass_body_q3_body_q3 = w_squared
            * (body_q2_squared * self.k_2 + body_q1_squared * self.k_3
                + body_q0_squared * self.k_4) + body_q3_squared * self.k_5;
        let pivot_body_q3 = mass_body_q3_body_q3
            - mass_body_q3_body_q0 * l_body_q3_body_q0
            - k_body_q3_body_q1 * l_body_q3_body_q1
            - k_body_q3_body_q2 * l_body_q3_body_q2;
        let inverse_body_q3 = S::from_f64(1.0) / pivot_body_q3;
        let body_norm_by_body_q0 = body_q0 * S::from_f64(2.0);
        let l_lambda_body_norm_body_q0 = body_norm_by_body_q0 * inverse_body_q0;
        let k_lambda_body_norm_body_q1 = body_q1 * S::from_f64(2.0)
            - mass_body_q1_body_q0 * l_lambda_body_norm_body_q0;
        let l_lambda_body_norm_body_q1 = inverse_body_q1 * k_lambda_body_norm_body_q1;
        let k_lambda_body_norm_body_q2 = body_q2 * S::from_f64(2.0)
            - mass_body_q2_body_q0 * l_lambda_body_norm_body_q0
            - k_body_q2_body_q1 * l_lambda_body_norm_body_q1;
        let l_lambda_body_norm_body_q2 = inverse_body_q2 * k_lambda_body_norm_body_q2;
        let k_lambda_body_norm_body_q3 = body_q3 * S::from_f64(2.0)
            - mass_body_q3_body_q0 * l_lambda_body_norm_body_q0
            - k_body_q3_body_q1 * l_lambda_body_norm_body_q1
            - k_body_q3_body_q2 * l_lambda_body_norm_body_q2;
        let l_lambda_body_norm_body_q3 = inverse_body_q3 * k_lambda_body_norm_body_q3;
        let minus_pivot_lambda_body_norm = body_norm_by_body_q0
            * l_lambda_body_norm_body_q0
            + k_lambda_body_norm_body_q1 * l_lambda_body_norm_body_q1
            + k_lambda_body_norm_body_q2 * l_lambda_body_norm_body_q2
            + k_lambda_body_norm_body_q3 * l_lambda_body_norm_body_q3;
        let minus_inverse_lambda_body_norm = S::from_f64(1.0)
            / minus_pivot_lambda_body_norm;
        let lambda_body_norm = minus_inverse_lambda_body_norm
            * (S::from_f64(2.0) * w_19 + rhs_body_q0 * l_lambda_body_norm_body_q0
                + l_lambda_body_norm_body_q1 * rhs_body_q1
                + l_lambda_body_norm_body_q2 * rhs_body_q2
                + l_lambda_body_norm_body_q3 * rhs_body_q3);
        let body_q3_ddot = inverse_body_q3 * rhs_body_q3
            - l_lambda_body_norm_body_q3 * lambda_body_norm;
        let body_q2_ddot = inverse_body_q2 * rhs_body_q2
            - l_body_q3_body_q2 * body_q3_ddot
            - l_lambda_body_norm_body_q2 * lambda_body_norm;
        let body_q1_ddot = inverse_body_q1 * rhs_body_q1
            - l_body_q2_body_q1 * body_q2_ddot - l_body_q3_body_q1 * body_q3_ddot
            - l_lambda_body_norm_body_q1 * lambda_body_norm;
        let body_q0_ddot = rhs_body_q0 * inverse_body_q0
            - l_body_q1_body_q0 * body_q1_ddot - l_body_q2_body_q0 * body_q2_ddot
            - l_body_q3_body_q0 * body_q3_ddot
            - l_lambda_body_norm_body_q0 * lambda_body_norm;
        let w_75 = S::from_f64(2.0) * lambda_body_norm;
        let w_62 = w_squared * self.k_15;
        let w_63 = body_q0_squared * w_41;
        let w_64 = body_q3 * w_41;
        let w_187 = w_squared * (self.A * (w_47 + w_48) + self.k_9 * (w_46 + w_49))
            + w_64 * w_153;
        let w_65 = body_q0 * w_64;
        let w_66 = body_q2 * w_65;
        let w_69 = body_q1 * w_65;
        let w_67 = body_q1 * (w_62 - self.k - self.k_16 * w_63) + self.k_19 * w_66;
        let w_68 = w_squared * self.k_20;
        let w_70 = body_q2 * (self.k - w_68 + self.k_17 * w_63) + self.k_21 * w_69;
        let w_71 = w_squared * self.k_22;
        let w_72 = body_q0 * w_33;
        let w_129 = w_33 * w_64;
        let w_73 = w_41 * w_72;
        let w_74 = body_q3 * (w_71 - self.k - self.k_18 * w_63) + self.k_23 * w_73;
        let w_76 = body_q0_ddot * S::from_f64(2.6666666666666665) * body_q0
            * (w_41
                * (body_q1_squared * self.k_12 + body_q2_squared * self.k_13
                    + body_q3_squared * self.k_14) - self.k);
        let w_77 = w_61 - S::from_f64(16.0) * body_q0 * w_squared * w_18
            + S::from_f64(1.3333333333333333)
                * (body_q1_ddot * w_67 - body_q2_ddot * w_70 + body_q3_ddot * w_74)
            - w_75 - w_20 + w_76;
        let w_78 = self.A * w_squared;
        let w_79 = body_q3_squared * self.k_25;
        let w_80 = body_q2_squared * self.k_26;
        let w_81 = body_q0 * body_q0_squared;
        let w_82 = w_41 * self.k_24;
        let w_83 = w * (body_q3 * w_53 - w_8 - body_q0 * w_45 - body_q2 * w_60)
            - body_q1_ddot * (body_q0 * (w_78 - w_41 * (w_79 + w_80)) - w_81 * w_82);
        let w_84 = w_23 - w_21;
        let w_85 = w_squared * self.k_10;
        let w_86 = body_q2 * (w_85 + self.k_7 * w_63) - self.k_3 * w_69;
        let w_87 = w_squared * self.k_27;
        let w_88 = body_q3 * (w_87 + w_63 * self.k_28) + self.k_4 * w_73;
        let w_89 = S::from_f64(1.3333333333333333) * body_q0_ddot;
        let w_90 = S::from_f64(8.0) * w_83
            + S::from_f64(16.0) * w_squared * (body_q0 * w_84 + body_q0_squared * w_8)
            + S::from_f64(4.0) * (body_q3_ddot * w_86 - body_q2_ddot * w_88)
            + w_67 * w_89;
        let w_91 = w_90 - l_body_q1_body_q0 * w_77;
        let w_92 = body_q3_squared * self.k_24;
        let w_93 = body_q1_squared * self.k_26;
        let w_94 = w_squared * self.B;
        let w_95 = w_41 * self.k_25;
        let w_96 = w * (body_q1 * w_60 - w_12 - body_q3 * w_45 - body_q0 * w_53)
            + body_q2_ddot * (body_q0 * (w_41 * (w_92 + w_93) - w_94) + w_81 * w_95);
        let w_98 = w_squared * self.k_29;
        let w_99 = w_41 * (body_q2 * w_97 + body_q1 * body_q0_squared * self.k_30)
            + body_q1 * w_98;
        let w_100 = S::from_f64(8.0) * w_96
            + S::from_f64(16.0) * w_squared
                * (body_q0 * (w_28 - w_27) + body_q0_squared * w_12)
            - S::from_f64(4.0) * (body_q1_ddot * w_88 + body_q3_ddot * w_99)
            - w_70 * w_89;
        let w_101 = w_100 - l_body_q2_body_q0 * w_77 - l_body_q2_body_q1 * w_91;
        let w_141 = w_28 + w_29;
        let w_194 = w_41 * (body_q1 * w_97 + body_q2 * body_q3_squared * self.k_30)
            + body_q2 * w_98;
        let w_102 = body_q2_squared * self.k_24;
        let w_103 = body_q1_squared * self.k_25;
        let w_104 = w_squared * self.C;
        let w_105 = w_41 * self.k_26;
        let w_106 = w * (body_q2 * w_45 - w_16 - body_q1 * w_53 - body_q0 * w_60)
            + body_q3_ddot * (body_q0 * (w_41 * (w_102 + w_103) - w_104) + w_81 * w_105);
        let w_107 = S::from_f64(8.0) * w_106
            + S::from_f64(16.0) * w_squared
                * (body_q0 * (w_35 - w_34) + body_q0_squared * w_16)
            + S::from_f64(4.0) * (body_q1_ddot * w_86 - body_q2_ddot * w_99)
            + w_74 * w_89;
        let w_108 = w_107 - l_body_q3_body_q0 * w_77 - l_body_q3_body_q1 * w_91
            - l_body_q3_body_q2 * w_101;
        let w_180 = w_35 + w_36;
        let w_109 = minus_inverse_lambda_body_norm
            * (S::from_f64(2.0) * body_q0_ddot + l_lambda_body_norm_body_q0 * w_77
                + l_lambda_body_norm_body_q1 * w_91 + l_lambda_body_norm_body_q2 * w_101
                + l_lambda_body_norm_body_q3 * w_108);
        let w_110 = inverse_body_q3 * w_108 - l_lambda_body_norm_body_q3 * w_109;
        let w_111 = inverse_body_q2 * w_101 - l_body_q3_body_q2 * w_110
            - l_lambda_body_norm_body_q2 * w_109;
        let w_112 = inverse_body_q1 * w_91 - l_body_q2_body_q1 * w_111
            - l_body_q3_body_q1 * w_110 - l_lambda_body_norm_body_q1 * w_109;
        let w_113 = body_q0_dot * w_6;
        let w_114 = body_q1_dot * w_5;
        let w_115 = body_q2_dot * w_2;
        let w_116 = w_squared
            * (self.A * (w_113 - w_114) + body_q3_dot * w_4 + self.k_29 * w_115)
            + body_q1 * w_44;
        let w_189 = w_squared
            * (self.C * (body_q3_dot * w_3 - w_113) + self.k_27 * w_115
                + self.k_11 * w_114) + w_64 * w_120;
        let w_119 = w_5 * self.k_27;
        let w_121 = w_squared
            * (self.C * (w_46 - w_48) + body_q3_dot * w_119 + body_q0_dot * w_14)
            + body_q1 * w_41 * w_120;
        let w_122 = body_q2_squared * self.k_25;
        let w_123 = body_q3_squared * self.k_26;
        let w_124 = body_q1 * body_q1_squared;
        let w_125 = w * (w_8 + body_q1 * w_116 - body_q2 * w_118 - body_q3 * w_121)
            - body_q0_ddot * (body_q1 * (w_78 - w_41 * (w_122 + w_123)) - w_82 * w_124);
        let w_126 = body_q1_squared * w_41;
        let w_127 = body_q2 * (w_squared * self.k_11 + self.k_8 * w_126)
            - self.k_4 * w_69;
        let w_128 = w_41 * (self.k_3 * w_72 + body_q1_squared * body_q3 * self.k_31)
            + body_q3 * w_squared * self.k_33;
        let w_162 = w_41 * (self.k_2 * w_72 + body_q2_squared * body_q3 * self.k_30)
            + body_q3 * w_98;
        let w_142 = body_q0 * (w_98 + self.k_30 * w_126) + self.k_2 * w_129;
        let w_130 = body_q0 * (self.k - w_62 + self.k_16 * w_126) + self.k_32 * w_129;
        let w_131 = S::from_f64(1.3333333333333333) * body_q1_ddot;
        let w_132 = S::from_f64(8.0) * w_125
            - S::from_f64(16.0) * w_squared
                * (body_q1 * (w_13 + w_17) + body_q1_squared * w_8)
            + S::from_f64(4.0) * (body_q3_ddot * w_127 - body_q2_ddot * w_128)
            - w_130 * w_131;
        let w_133 = S::from_f64(8.0) * w
            * (body_q2 * w_121 - body_q0 * w_116 - body_q3 * w_118);
        let w_134 = body_q2 * (w_71 - self.k - self.k_18 * w_126) + w_69 * self.k_23;
        let w_135 = body_q3 * (self.k - w_68 + self.k_17 * w_126) + self.k_21 * w_73;
        let w_136 = body_q1_ddot * S::from_f64(2.6666666666666665) * body_q1
            * (w_41
                * (body_q0_squared * self.k_12 + body_q3_squared * self.k_13
                    + body_q2_squared * self.k_14) - self.k);
        let w_137 = w_133 - w_75 - w_20
            + S::from_f64(1.3333333333333333)
                * (body_q2_ddot * w_134 - body_q0_ddot * w_130 - body_q3_ddot * w_135)
            + S::from_f64(16.0) * body_q1 * w_squared * (w_22 + w_84) + w_136;
        let w_138 = w_137 - l_body_q1_body_q0 * w_132;
        let w_139 = body_q0_squared * self.k_25;
        let w_140 = w * (w_16 - body_q3 * w_116 + body_q0 * w_118 - body_q1 * w_121)
            + body_q2_ddot * (body_q1 * (w_41 * (w_92 + w_139) - w_104) + w_105 * w_124);
        let w_143 = S::from_f64(8.0) * w_140
            + S::from_f64(16.0) * w_squared * (body_q1 * w_141 - body_q1_squared * w_16)
            - S::from_f64(4.0) * (body_q0_ddot * w_128 + body_q3_ddot * w_142)
            + w_131 * w_134;
        let w_144 = w_143 - l_body_q2_body_q0 * w_132 - l_body_q2_body_q1 * w_138;
        let w_145 = body_q0_squared * self.k_26;
        let w_146 = w * (body_q2 * w_116 - w_12 + body_q1 * w_118 + body_q0 * w_121)
            - body_q3_ddot * (body_q1 * (w_94 - w_41 * (w_102 + w_145)) - w_95 * w_124);
        let w_147 = S::from_f64(8.0) * w_146
            + S::from_f64(16.0) * w_squared
                * (body_q1 * (w_36 - w_34) + body_q1_squared * w_12)
            + S::from_f64(4.0) * (body_q0_ddot * w_127 - body_q2_ddot * w_142)
            - w_131 * w_135;
        let w_148 = w_147 - l_body_q3_body_q0 * w_132 - l_body_q3_body_q1 * w_138
            - l_body_q3_body_q2 * w_144;
        let w_149 = minus_inverse_lambda_body_norm
            * (S::from_f64(2.0) * body_q1_ddot + l_lambda_body_norm_body_q0 * w_132
                + l_lambda_body_norm_body_q1 * w_138 + l_lambda_body_norm_body_q2 * w_144
                + l_lambda_body_norm_body_q3 * w_148);
        let w_150 = inverse_body_q3 * w_148 - l_lambda_body_norm_body_q3 * w_149;
        let w_151 = inverse_body_q2 * w_144 - l_body_q3_body_q2 * w_150
            - l_lambda_body_norm_body_q2 * w_149;
        let w_152 = inverse_body_q1 * w_138 - l_body_q2_body_q1 * w_151
            - l_body_q3_body_q1 * w_150 - l_lambda_body_norm_body_q1 * w_149;
        let w_155 = w_3 * self.k_33;
        let w_188 = w_squared
            * (self.B * (w_38 - w_39) + body_q2_dot * w_155 + body_q0_dot * w_10)
            + w_64 * w_117;
        let w_156 = body_q2 * w_41;
        let w_157 = w_squared
            * (self.B * (w_113 - w_115) + body_q3_dot * w_155 + body_q1_dot * w_10)
            + w_52 * w_156;
        let w_158 = w_squared * (self.C * (w_37 + w_39) + self.k_11 * (w_38 + w_40))
            + w_120 * w_156;
        let w_159 = body_q1_squared * self.k_24;
        let w_160 = body_q2 * body_q2_squared;
        let w_161 = w * (w_12 - body_q1 * w_154 + body_q2 * w_157 - body_q3 * w_158)
            - body_q0_ddot * (body_q2 * (w_94 - w_41 * (w_123 + w_159)) - w_95 * w_160);
        let w_179 = w * (w_8 - body_q2 * w_154 - body_q1 * w_157 + body_q0 * w_158)
            - body_q3_ddot * (body_q2 * (w_78 - w_41 * (w_103 + w_145)) - w_82 * w_160);
        let w_163 = body_q2_squared * w_41;
        let w_175 = body_q3 * (w_62 - self.k - self.k_16 * w_163) + self.k_19 * w_73;
        let w_164 = body_q1 * (w_87 + self.k_28 * w_163) + self.k_4 * w_66;
        let w_165 = body_q0 * (self.k - w_68 + self.k_17 * w_163) + self.k_21 * w_129;
        let w_166 = S::from_f64(1.3333333333333333) * body_q2_ddot;
        let w_167 = S::from_f64(8.0) * w_161
            - S::from_f64(16.0) * w_squared
                * (body_q2 * (w_9 + w_17) + body_q2_squared * w_12)
            - S::from_f64(4.0) * (body_q1_ddot * w_162 + body_q3_ddot * w_164)
            - w_165 * w_166;
        let w_168 = body_q0_squared * self.k_24;
        let w_169 = w * (body_q0 * w_154 - w_16 + body_q3 * w_157 + body_q2 * w_158)
            + body_q1_ddot * (body_q2 * (w_41 * (w_79 + w_168) - w_104) + w_105 * w_160);
        let w_174 = S::from_f64(8.0) * w
            * (body_q3 * w_154 - body_q0 * w_157 - body_q1 * w_158);
        let w_170 = body_q0 * (w_85 + self.k_7 * w_163) - self.k_3 * w_129;
        let w_171 = body_q1 * (self.k - w_71 + self.k_18 * w_163) + w_66 * self.k_34;
        let w_172 = S::from_f64(8.0) * w_169
            + S::from_f64(16.0) * w_squared
                * (body_q2 * (w_22 - w_21) + body_q2_squared * w_16)
            + S::from_f64(4.0) * (body_q3_ddot * w_170 - body_q0_ddot * w_162)
            - w_166 * w_171;
        let w_173 = w_172 - l_body_q1_body_q0 * w_167;
        let w_181 = S::from_f64(8.0) * w_179
            + S::from_f64(16.0) * w_squared * (body_q2 * w_180 - body_q2_squared * w_8)
            + S::from_f64(4.0) * (body_q1_ddot * w_170 - body_q0_ddot * w_164)
            + w_166 * w_175;
        let w_208 = body_q3_ddot * S::from_f64(2.6666666666666665) * body_q3
            * (w_41
                * (body_q0_squared * self.k_14 + body_q1_squared * self.k_13
                    + body_q2_squared * self.k_12) - self.k);
        let w_176 = body_q2_ddot * S::from_f64(2.6666666666666665) * body_q2
            * (w_41
                * (body_q0_squared * self.k_13 + body_q1_squared * self.k_14
                    + body_q3_squared * self.k_12) - self.k);
        let w_177 = w_174 - w_75 - w_20
            + S::from_f64(1.3333333333333333)
                * (body_q3_ddot * w_175 - body_q0_ddot * w_165 - body_q1_ddot * w_171)
            + S::from_f64(16.0) * body_q2 * w_squared * (w_141 - w_27) + w_176;
        let w_178 = w_177 - l_body_q2_body_q0 * w_167 - l_body_q2_body_q1 * w_173;
        let w_182 = w_181 - l_body_q3_body_q0 * w_167 - l_body_q3_body_q1 * w_173
            - l_body_q3_body_q2 * w_178;
        let w_183 = minus_inverse_lambda_body_norm
            * (S::from_f64(2.0) * body_q2_ddot + l_lambda_body_norm_body_q0 * w_167
                + l_lambda_body_norm_body_q1 * w_173 + l_lambda_body_norm_body_q2 * w_178
                + l_lambda_body_norm_body_q3 * w_182);
        let w_184 = inverse_body_q3 * w_182 - l_lambda_body_norm_body_q3 * w_183;
        let w_185 = inverse_body_q2 * w_178 - l_body_q3_body_q2 * w_184
            - l_lambda_body_norm_body_q2 * w_183;
        let w_186 = inverse_body_q1 * w_173 - l_body_q2_body_q1 * w_185
            - l_body_q3_body_q1 * w_184 - l_lambda_body_norm_body_q1 * w_183;
        let w_190 = body_q3 * body_q3_squared;
        let w_191 = w * (w_16 - body_q1 * w_187 - body_q2 * w_188 - body_q3 * w_189)
            - body_q0_ddot
                * (body_q3 * (w_104 - w_41 * (w_122 + w_159)) - w_105 * w_190);
        let w_198 = w * (w_12 + body_q0 * w_187 - body_q3 * w_188 + body_q2 * w_189)
            + body_q1_ddot * (body_q3 * (w_41 * (w_80 + w_168) - w_94) + w_95 * w_190);
        let w_203 = w * (body_q3 * w_187 - w_8 + body_q0 * w_188 - body_q1 * w_189)
            - body_q2_ddot * (body_q3 * (w_78 - w_41 * (w_93 + w_139)) - w_82 * w_190);
        let w_192 = body_q3_squared * w_41;
        let w_193 = body_q1 * (w_85 + self.k_7 * w_192) - self.k_3 * w_66;
        let w_200 = body_q1 * (w_68 - self.k - self.k_17 * w_192) + w_66 * self.k_35;
        let w_195 = body_q0 * (self.k - w_71 + self.k_18 * w_192) + w_129 * self.k_34;
        let w_199 = body_q0 * (w_87 + self.k_28 * w_192) + self.k_4 * w_129;
        let w_204 = body_q2 * (self.k - w_62 + self.k_16 * w_192) + w_69 * self.k_32;
        let w_207 = S::from_f64(8.0) * w
            * (body_q1 * w_188 - body_q2 * w_187 + body_q0 * w_189);
        let w_209 = w_207 - w_75 - w_20
            + S::from_f64(1.3333333333333333)
                * (body_q1_ddot * w_200 - body_q0_ddot * w_195 - body_q2_ddot * w_204)
            + S::from_f64(16.0) * body_q3 * w_squared * (w_180 - w_34) + w_208;
        let w_196 = S::from_f64(1.3333333333333333) * body_q3_ddot;
        let w_197 = S::from_f64(8.0) * w_191
            - S::from_f64(16.0) * w_squared
                * (body_q3 * (w_9 + w_13) + body_q3_squared * w_16)
            + S::from_f64(4.0) * (body_q2_ddot * w_193 - body_q1_ddot * w_194)
            - w_195 * w_196;
        let w_201 = S::from_f64(8.0) * w_198
            + S::from_f64(16.0) * w_squared
                * (body_q3 * (w_22 + w_23) - body_q3_squared * w_12)
            - S::from_f64(4.0) * (body_q0_ddot * w_194 + body_q2_ddot * w_199)
            + w_196 * w_200;
        let w_202 = w_201 - l_body_q1_body_q0 * w_197;
        let w_205 = S::from_f64(8.0) * w_203
            + S::from_f64(16.0) * w_squared
                * (body_q3 * (w_29 - w_27) + body_q3_squared * w_8)
            + S::from_f64(4.0) * (body_q0_ddot * w_193 - body_q1_ddot * w_199)
            - w_196 * w_204;
        let w_206 = w_205 - l_body_q2_body_q0 * w_197 - l_body_q2_body_q1 * w_202;
        let w_210 = w_209 - l_body_q3_body_q0 * w_197 - l_body_q3_body_q1 * w_202
            - l_body_q3_body_q2 * w_206;
        let w_211 = minus_inverse_lambda_body_norm
            * (S::from_f64(2.0) * body_q3_ddot + l_lambda_body_norm_body_q0 * w_197
                + l_lambda_body_norm_body_q1 * w_202 + l_lambda_body_norm_body_q2 * w_206
                + l_lambda_body_norm_body_q3 * w_210);
        let w_212 = inverse_body_q3 * w_210 - l_lambda_body_norm_body_q3 * w_211;
        let w_213 = inverse_body_q2 * w_206 - l_body_q3_body_q2 * w_212
            - l_lambda_body_norm_body_q2 * w_211;
        let w_214 = inverse_body_q1 * w_202 - l_body_q2_body_q1 * w_213
            - l_body_q3_body_q1 * w_212 - l_lambda_body_norm_body_q1 * w_211;
        let w_215 = body_q2 * w_3;
        let w_216 = body_q3 * w_2;
        let w_217 = body_q0 * w_5;
        let w_218 = body_q1 * w_6;
        let w_219 = w_squared * (self.k_9 * (w_215 + w_216) + self.A * (w_217 - w_218));
        let w_258 = w_squared * (self.C * (w_215 - w_218) + self.k_27 * (w_216 + w_217));
        let w_267 = w_squared
            * (body_q2 * w_155 - self.B * (w_216 + w_218) + body_q0 * w_10);
        let w_220 = body_q1 * w_3;
        let w_221 = body_q3 * w_5;
        let w_222 = body_q0 * w_2;
        let w_223 = body_q2 * w_6;
        let w_224 = w_squared * (self.k_10 * (w_220 + w_221) + self.B * (w_222 - w_223));
        let w_268 = w_squared * (self.A * (w_221 - w_223) + self.k_29 * (w_220 + w_222));
        let w_247 = w_squared
            * (body_q3 * w_119 - self.C * (w_220 + w_223) + body_q0 * w_14);
        let w_225 = body_q1 * w_2;
        let w_242 = body_q2 * w_2;
        let w_226 = body_q2 * w_5;
        let w_227 = body_q0 * w_3;
        let w_244 = body_q3 * w_3;
        let w_228 = body_q3 * w_6;
        let w_243 = body_q0 * w_6;
        let w_245 = w_squared
            * (self.k_9 * w_242 - self.A * (w_243 + body_q1 * w_5) + self.k_29 * w_244);
        let w_257 = w_squared
            * (self.B * (w_243 + w_242) + body_q3 * w_155 + body_q1 * w_10);
        let w_269 = w_squared
            * (self.C * (w_243 + w_244) + body_q2 * w_14 + body_q1 * w_119);
        let w_256 = w_squared
            * (self.k_29 * w_225 - self.A * (w_226 + w_228) + body_q0 * w_4);
        let w_229 = w_squared * (self.k_11 * (w_225 + w_226) + self.C * (w_227 - w_228));
        let w_246 = w_squared * (self.B * (w_225 - w_228) + self.k_33 * (w_226 + w_227));
        let w_230 = body_q0 * self.k_36;
        let w_231 = S::from_f64(8.0) * w
            * (body_q1 * w_219 + body_q2 * w_224 + body_q3 * w_229)
            + body_q0_dot * w_230;
        let w_232 = body_q1 * self.k_36;
        let w_233 = S::from_f64(8.0) * w
            * (body_q0 * w_219 - body_q3 * w_224 + body_q2 * w_229) - body_q0_dot * w_232
            + l_body_q1_body_q0 * w_231;
        let w_234 = body_q2 * self.k_36;
        let w_235 = S::from_f64(8.0) * w
            * (body_q3 * w_219 + body_q0 * w_224 - body_q1 * w_229) - body_q0_dot * w_234
            + l_body_q2_body_q0 * w_231 - l_body_q2_body_q1 * w_233;
        let w_236 = body_q3 * self.k_36;
        let w_237 = S::from_f64(8.0) * w
            * (body_q1 * w_224 - body_q2 * w_219 + body_q0 * w_229) - body_q0_dot * w_236
            + l_body_q3_body_q0 * w_231 - l_body_q3_body_q1 * w_233
            - l_body_q3_body_q2 * w_235;
        let w_238 = minus_inverse_lambda_body_norm
            * (l_lambda_body_norm_body_q0 * w_231 - S::from_f64(4.0) * body_q0_dot
                - l_lambda_body_norm_body_q1 * w_233 - l_lambda_body_norm_body_q2 * w_235
                - l_lambda_body_norm_body_q3 * w_237);
        let w_239 = inverse_body_q3 * w_237 + l_lambda_body_norm_body_q3 * w_238;
        let w_240 = inverse_body_q2 * w_235 - l_body_q3_body_q2 * w_239
            + l_lambda_body_norm_body_q2 * w_238;
        let w_241 = inverse_body_q1 * w_233 - l_body_q2_body_q1 * w_240
            - l_body_q3_body_q1 * w_239 + l_lambda_body_norm_body_q1 * w_238;
        let w_248 = S::from_f64(8.0) * w
            * (body_q1 * w_245 - body_q2 * w_246 + body_q3 * w_247)
            - body_q1_dot * w_230;
        let w_249 = S::from_f64(8.0) * w
            * (body_q0 * w_245 + body_q3 * w_246 + body_q2 * w_247) + body_q1_dot * w_232
            + l_body_q1_body_q0 * w_248;
        let w_250 = S::from_f64(8.0) * w
            * (body_q0 * w_246 - body_q3 * w_245 + body_q1 * w_247) - body_q1_dot * w_234
            - l_body_q2_body_q0 * w_248 + l_body_q2_body_q1 * w_249;
        let w_251 = S::from_f64(8.0) * w
            * (body_q2 * w_245 + body_q1 * w_246 - body_q0 * w_247) - body_q1_dot * w_236
            - l_body_q3_body_q0 * w_248 + l_body_q3_body_q1 * w_249
            - l_body_q3_body_q2 * w_250;
        let w_252 = minus_inverse_lambda_body_norm
            * (l_lambda_body_norm_body_q1 * w_249 - S::from_f64(4.0) * body_q1_dot
                - l_lambda_body_norm_body_q0 * w_248 - l_lambda_body_norm_body_q2 * w_250
                - l_lambda_body_norm_body_q3 * w_251);
        let w_253 = inverse_body_q3 * w_251 + l_lambda_body_norm_body_q3 * w_252;
        let w_254 = inverse_body_q2 * w_250 - l_body_q3_body_q2 * w_253
            + l_lambda_body_norm_body_q2 * w_252;
        let w_255 = l_lambda_body_norm_body_q1 * w_252 - inverse_body_q1 * w_249
            - l_body_q2_body_q1 * w_254 - l_body_q3_body_q1 * w_253;
        let w_259 = S::from_f64(8.0) * w
            * (body_q1 * w_256 - body_q2 * w_257 - body_q3 * w_258)
            - body_q2_dot * w_230;
        let w_270 = S::from_f64(8.0) * w
            * (body_q2 * w_267 - body_q1 * w_268 - body_q3 * w_269)
            - body_q3_dot * w_230;
        let w_260 = S::from_f64(8.0) * w
            * (body_q2 * w_258 - body_q0 * w_256 - body_q3 * w_257) - body_q2_dot * w_232
            - l_body_q1_body_q0 * w_259;
        let w_271 = S::from_f64(8.0) * w
            * (body_q0 * w_268 + body_q3 * w_267 + body_q2 * w_269) - body_q3_dot * w_232
            - l_body_q1_body_q0 * w_270;
        let w_261 = S::from_f64(8.0) * w
            * (body_q0 * w_257 - body_q3 * w_256 - body_q1 * w_258) - body_q2_dot * w_234
            - l_body_q2_body_q0 * w_259 - l_body_q2_body_q1 * w_260;
        let w_262 = S::from_f64(8.0) * w
            * (body_q2 * w_256 + body_q1 * w_257 + body_q0 * w_258) - body_q2_dot * w_236
            - l_body_q3_body_q0 * w_259 - l_body_q3_body_q1 * w_260
            - l_body_q3_body_q2 * w_261;
        let w_272 = S::from_f64(8.0) * w
            * (body_q3 * w_268 - body_q0 * w_267 - body_q1 * w_269) - body_q3_dot * w_234
            - l_body_q2_body_q0 * w_270 - l_body_q2_body_q1 * w_271;
        let w_273 = S::from_f64(8.0) * w
            * (body_q0 * w_269 - body_q2 * w_268 - body_q1 * w_267) - body_q3_dot * w_236
            - l_body_q3_body_q0 * w_270 - l_body_q3_body_q1 * w_271
            - l_body_q3_body_q2 * w_272;
        let w_263 = minus_inverse_lambda_body_norm
            * (S::from_f64(4.0) * body_q2_dot + l_lambda_body_norm_body_q0 * w_259
                + l_lambda_body_norm_body_q1 * w_260 + l_lambda_body_norm_body_q2 * w_261
                + l_lambda_body_norm_body_q3 * w_262);
        let w_264 = inverse_body_q3 * w_262 - l_lambda_body_norm_body_q3 * w_263;
        let w_265 = inverse_body_q2 * w_261 - l_body_q3_body_q2 * w_264
            - l_lambda_body_norm_body_q2 * w_263;
        let w_266 = inverse_body_q1 * w_260 - l_body_q2_body_q1 * w_265
            - l_body_q3_body_q1 * w_264 - l_lambda_body_norm_body_q1 * w_263;
        let w_274 = minus_inverse_lambda_body_norm
            * (S::from_f64(4.0) * body_q3_dot + l_lambda_body_norm_body_q0 * w_270
                + l_lambda_body_norm_body_q1 * w_271 + l_lambda_body_norm_body_q2 * w_272
                + l_lambda_body_norm_body_q3 * w_273);
        let w_275 = inverse_body_q3 * w_273 - l_lambda_body_norm_body_q3 * w_274;
        let w_276 = inverse_body_q2 * w_272 - l_body_q3_body_q2 * w_275
            - l_lambda_body_norm_body_q2 * w_274;
        let w_277 = inverse_body_q1 * w_271 - l_body_q2_body_q1 * w_276
            - l_body_q3_body_q1 * w_275 - l_lambda_body_norm_body_q1 * w_274;
        sim_kernel::DynamicsJacobian {
            accelerations_by_positions: [
                [
                    S::from_f64(0.0),
                    S::from_f64(0.0),
                    S::from_f64(0.0),
                    S::from_f64(0.0),
                    S::from_f64(0.0),
                    S::from_f64(0.0),
                    S::from_f64(0.0),
                ],
                [
                    S::from_f64(0.0),
                    S::from_f64(0.0),
                    S::from_f64(0.0),
                    S::from_f64(0.0),
                    S::from_f64(0.0),
                    S::from_f64(0.0),
                    S::from_f64(0.0),
                ],
                [
                    S::from_f64(0.0),
                    S::from_f64(0.0),
                    S::from_f64(0.0),
                    S::from_f64(0.0),
                    S::from_f64(0.0),
                    S::from_f64(0.0),
                    S::from_f64(0.0),
                ],
                [
                    S::from_f64(0.0),
                    S::from_f64(0.0),
                    S::from_f64(0.0),
                    inverse_body_q0 * w_77 - l_body_q1_body_q0 * w_112
                        - l_body_q2_body_q0 * w_111 - l_body_q3_body_q0 * w_110
                        - l_lambda_body_norm_body_q0 * w_109,
                    inverse_body_q0 * w_132 - l_body_q1_body_q0 * w_152
                        - l_body_q2_body_q0 * w_151 - l_body_q3_body_q0 * w_150
                        - l_lambda_body_norm_body_q0 * w_149,
                    inverse_body_q0 * w_167 - l_body_q1_body_q0 * w_186
                        - l_body_q2_body_q0 * w_185 - l_body_q3_body_q0 * w_184
                        - l_lambda_body_norm_body_q0 * w_183,
                    inverse_body_q0 * w_197 - l_body_q1_body_q0 * w_214
                        - l_body_q2_body_q0 * w_213 - l_body_q3_body_q0 * w_212
                        - l_lambda_body_norm_body_q0 * w_211,
                ],
                [
                    S::from_f64(0.0),
                    S::from_f64(0.0),
                    S::from_f64(0.0),
                    w_112,
                    w_152,
                    w_186,
                    w_214,
                ],
                [
                    S::from_f64(0.0),
                    S::from_f64(0.0),
                    S::from_f64(0.0),
                    w_111,
                    w_151,
                    w_185,
                    w_213,
                ],
                [
                    S::from_f64(0.0),
                    S::from_f64(0.0),
                    S::from_f64(0.0),
                    w_110,
                    w_150,
                    w_184,
                    w_212,
                ],
            ],
            accelerations_by_speeds: [
                [
                    S::from_f64(0.0),
                    S::from_f64(0.0),
                    S::from_f64(0.0),
                    S::from_f64(0.0),
                    S::from_f64(0.0),
                    S::from_f64(0.0),
                    S::from_f64(0.0),
                ],
                [
                    S::from_f64(0.0),
                    S::from_f64(0.0),
                    S::from_f64(0.0),
                    S::from_f64(0.0),
                    S::from_f64(0.0),
                    S::from_f64(0.0),
                    S::from_f64(0.0),
                ],
                [
                    S::from_f64(0.0),
                    S::from_f64(0.0),
                    S::from_f64(0.0),
                    S::from_f64(0.0),
                    S::from_f64(0.0),
                    S::from_f64(0.0),
                    S::from_f64(0.0),
                ],
                [
                    S::from_f64(0.0),
                    S::from_f64(0.0),
                    S::from_f64(0.0),
                    l_lambda_body_norm_body_q0 * w_238 - inverse_body_q0 * w_231
                        - l_body_q1_body_q0 * w_241 - l_body_q2_body_q0 * w_240
                        - l_body_q3_body_q0 * w_239,
                    inverse_body_q0 * w_248 - l_body_q1_body_q0 * w_255
                        - l_body_q2_body_q0 * w_254 - l_body_q3_body_q0 * w_253
                        + l_lambda_body_norm_body_q0 * w_252,
                    inverse_body_q0 * w_259 - l_body_q1_body_q0 * w_266
                        - l_body_q2_body_q0 * w_265 - l_body_q3_body_q0 * w_264
                        - l_lambda_body_norm_body_q0 * w_263,
                    inverse_body_q0 * w_270 - l_body_q1_body_q0 * w_277
                        - l_body_q2_body_q0 * w_276 - l_body_q3_body_q0 * w_275
                        - l_lambda_body_norm_body_q0 * w_274,
                ],
                [
                    S::from_f64(0.0),
                    S::from_f64(0.0),
                    S::from_f64(0.0),
                    w_241,
                    w_255,
                    w_266,
                    w_277,
                ],
                [
                    S::from_f64(0.0),
                    S::from_f64(0.0),
                    S::from_f64(0.0),
                    w_240,
                    w_254,
                    w_265,
                    w_276,
                ],
                [
                    S::from_f64(0.0),
                    S::from_f64(0.0),
                    S::from_f64(0.0),
                    w_239,
                    w_253,
                    w_264,
                    w_275,
                ],
            ],
            multipliers_by_positions: [
                [
                    S::from_f64(0.0),
                    S::from_f64(0.0),
                    S::from_f64(0.0),
                    w_109,
                    w_149,
                    w_183,
                    w_211,
                ],
            ],
            multipliers_by_speeds: [
                [
                    S::from_f64(0.0),
                    S::from_f64(0.0),
                    S::from_f64(0.0),
                    -w_238,
                    -w_252,
                    w_263,
                    w_274,
                ],
            ],
            refused: sim_kernel::pivot_is_refused(
                mass_body_q0_body_q0,
                mass_body_q0_body_q0,
            ) | sim_kernel::pivot_is_refused(pivot_body_q1, mass_body_q1_body_q1)
                | sim_kernel::pivot_is_refused(pivot_body_q2, mass_body_q2_body_q2)
                | sim_kernel::pivot_is_refused(pivot_body_q3, mass_body_q3_body_q3)
                | sim_kernel::pivot_is_refused(self.m, self.m)
                | sim_kernel::pivot_is_refused(self.m, self.m)
                | sim_kernel::pivot_is_refused(self.m, self.m)
                | sim_kernel::pivot_is_refused(
                    -minus_pivot_lambda_body_norm,
                    minus_pivot_lambda_body_norm,
                ),
        }
    }
}
#[allow(non_snake_case, clippy::all, clippy::pedantic)]
impl<S: sim_kernel::Scalar> sim_kernel::Mechanism<S> for TumblingQuaternion<S> {
    type Q = [S; 7];
    type L = [S; 1];
    type Z = [S; 8];
    type QQ = [[S; 7]; 7];
    type LQ = [[S; 7]; 1];
    type LL = [[S; 1]; 1];
    type ZZ = [[S; 8]; 8];
    type Entries = [S; 0];
    type Envelope = [S; 0];
    type Parameters = [S; 6];
    type Outputs = [S; 8];
    type OutputRates = [S; 7];
    type Events = [S; 0];
    type EventValues = [S; 0];
    type Activities = [S; 0];
    type Drawing = [S; 30];
    type QP = [[S; 6]; 7];
    type LP = [[S; 6]; 1];
    type Inputs = [sim_kernel::Input<S>; 0];
    type Prepared = TumblingQuaternionPrepared<S>;
    type On<T: sim_kernel::Scalar> = TumblingQuaternion<T>;
    const DESCRIPTION: sim_kernel::Description = sim_kernel::Description {
        name: "tumbling-quaternion",
        type_name: "TumblingQuaternion",
        docs: "A free rigid body that tumbles, by a quaternion.",
        declaration: "/// A free rigid body that tumbles, by a quaternion.\npub TumblingQuaternion;\n\nparameters {\n    /// Principal moments of inertia.\n    A [kg*m^2] = 1;\n    B [kg*m^2] = 2;\n    C [kg*m^2] = 3;\n    m [kg] = 1;\n    /// Angular momentum.\n    H [N*m*s] = 6;\n    /// Angle between the third axis and the angular momentum at the start.\n    theta0 [deg] = 28;\n}\n\nlet c = cos(theta0/2)*cos(45 [deg]);\nlet s = sin(theta0/2)*cos(45 [deg]);\nlet W1 = H*sin(theta0)/A;\nlet W3 = H*cos(theta0)/C;\nlet w = transpose(attitude(body))*omega(body);\n\nbodies { body: free, mass m, inertia [A, B, C]; }\n\ninitial {\n    body_x = 0; body_y = 0; body_z = 0;\n    body_q0 = c; body_q1 = s; body_q2 = -s; body_q3 = c;\n    dot(body_q0) = -(s*W1 + c*W3)/2;\n    dot(body_q1) = (c*W1 - s*W3)/2;\n    dot(body_q2) = (c*W1 - s*W3)/2;\n    dot(body_q3) = (c*W3 + s*W1)/2;\n}\n\noutputs {\n    angular_velocity \"Angular velocity in the frame of the body\" {\n        /// about the axis of least inertia\n        w1 [rad/s] = w.x;\n        /// about the intermediate axis\n        w2 [rad/s] = w.y;\n        /// about the axis of most inertia\n        w3 [rad/s] = w.z;\n    }\n    angular_momentum \"Angular momentum in the world\" {\n        Hx [N*m*s] = (attitude(body)*[A*w.x, B*w.y, C*w.z]).x;\n        Hy [N*m*s] = (attitude(body)*[A*w.x, B*w.y, C*w.z]).y;\n        Hz [N*m*s] = (attitude(body)*[A*w.x, B*w.y, C*w.z]).z;\n    }\n    /// kinetic energy\n    energy [J] = (A*w.x^2 + B*w.y^2 + C*w.z^2)/2;\n    /// what keeps the norm: nothing\n    norm_force [J] = reaction(body_norm);\n}\n\ndrawing {\n    line on(body, [1 [m], 0, 0]), on(body, [0, 0.7 [m], 0]), on(body, [-1 [m], 0, 0]), on(body, [0, -0.7 [m], 0]), on(body, [1 [m], 0, 0]);\n    line on(body, [0, 0, -0.3 [m]]), on(body, [0, 0, 0.5 [m]]);\n    curve [0, 0, 0], [0, 0, 1.2 [m]];\n    point on(body, [0, 0, 0]);\n}\n",
        coordinates: &[
            sim_kernel::Coordinate {
                position: sim_kernel::Quantity {
                    name: "body_x",
                    unit: "m",
                    factor: 1f64,
                    is_length: true,
                    docs: "",
                },
                speed: sim_kernel::Quantity {
                    name: "body_x_dot",
                    unit: "m/s",
                    factor: 1f64,
                    is_length: false,
                    docs: "",
                },
                acceleration: sim_kernel::Quantity {
                    name: "body_x_ddot",
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
                    name: "body_y",
                    unit: "m",
                    factor: 1f64,
                    is_length: true,
                    docs: "",
                },
                speed: sim_kernel::Quantity {
                    name: "body_y_dot",
                    unit: "m/s",
                    factor: 1f64,
                    is_length: false,
                    docs: "",
                },
                acceleration: sim_kernel::Quantity {
                    name: "body_y_ddot",
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
                    name: "body_z",
                    unit: "m",
                    factor: 1f64,
                    is_length: true,
                    docs: "",
                },
                speed: sim_kernel::Quantity {
                    name: "body_z_dot",
                    unit: "m/s",
                    factor: 1f64,
                    is_length: false,
                    docs: "",
                },
                acceleration: sim_kernel::Quantity {
                    name: "body_z_ddot",
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
                    name: "body_q0",
                    unit: "1",
                    factor: 1f64,
                    is_length: false,
                    docs: "",
                },
                speed: sim_kernel::Quantity {
                    name: "body_q0_dot",
                    unit: "1/s",
                    factor: 1f64,
                    is_length: false,
                    docs: "",
                },
                acceleration: sim_kernel::Quantity {
                    name: "body_q0_ddot",
                    unit: "1/s^2",
                    factor: 1f64,
                    is_length: false,
                    docs: "",
                },
                start: sim_kernel::Start::Given,
                speed_given: true,
            },
            sim_kernel::Coordinate {
                position: sim_kernel::Quantity {
                    name: "body_q1",
                    unit: "1",
                    factor: 1f64,
                    is_length: false,
                    docs: "",
                },
                speed: sim_kernel::Quantity {
                    name: "body_q1_dot",
                    unit: "1/s",
                    factor: 1f64,
                    is_length: false,
                    docs: "",
                },
                acceleration: sim_kernel::Quantity {
                    name: "body_q1_ddot",
                    unit: "1/s^2",
                    factor: 1f64,
                    is_length: false,
                    docs: "",
                },
                start: sim_kernel::Start::Given,
                speed_given: true,
            },
            sim_kernel::Coordinate {
                position: sim_kernel::Quantity {
                    name: "body_q2",
                    unit: "1",
                    factor: 1f64,
                    is_length: false,
                    docs: "",
                },
                speed: sim_kernel::Quantity {
                    name: "body_q2_dot",
                    unit: "1/s",
                    factor: 1f64,
                    is_length: false,
                    docs: "",
                },
                acceleration: sim_kernel::Quantity {
                    name: "body_q2_ddot",
                    unit: "1/s^2",
                    factor: 1f64,
                    is_length: false,
                    docs: "",
                },
                start: sim_kernel::Start::Given,
                speed_given: true,
            },
            sim_kernel::Coordinate {
                position: sim_kernel::Quantity {
                    name: "body_q3",
                    unit: "1",
                    factor: 1f64,
                    is_length: false,
                    docs: "",
                },
                speed: sim_kernel::Quantity {
                    name: "body_q3_dot",
                    unit: "1/s",
                    factor: 1f64,
                    is_length: false,
                    docs: "",
                },
                acceleration: sim_kernel::Quantity {
                    name: "body_q3_ddot",
                    unit: "1/s^2",
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
                name: "A",
                unit: "kg*m^2",
                factor: 1f64,
                is_length: false,
                docs: "Principal moments of inertia.",
            },
            sim_kernel::Quantity {
                name: "B",
                unit: "kg*m^2",
                factor: 1f64,
                is_length: false,
                docs: "",
            },
            sim_kernel::Quantity {
                name: "C",
                unit: "kg*m^2",
                factor: 1f64,
                is_length: false,
                docs: "",
            },
            sim_kernel::Quantity {
                name: "m",
                unit: "kg",
                factor: 1f64,
                is_length: false,
                docs: "",
            },
            sim_kernel::Quantity {
                name: "H",
                unit: "N*m*s",
                factor: 1f64,
                is_length: false,
                docs: "Angular momentum.",
            },
            sim_kernel::Quantity {
                name: "theta0",
                unit: "deg",
                factor: 0.017453292519943295f64,
                is_length: false,
                docs: "Angle between the third axis and the angular momentum at the start.",
            },
        ],
        inputs: &[],
        constraints: &[
            sim_kernel::Quantity {
                name: "body_norm",
                unit: "N*m",
                factor: 1f64,
                is_length: false,
                docs: "",
            },
        ],
        speed_constraints: &[],
        norm_constraints: &[0],
        sparsity: &[],
        conditionals: &[],
        events: &[],
        outputs: &[
            sim_kernel::Quantity {
                name: "w1",
                unit: "rad/s",
                factor: 1f64,
                is_length: false,
                docs: "about the axis of least inertia",
            },
            sim_kernel::Quantity {
                name: "w2",
                unit: "rad/s",
                factor: 1f64,
                is_length: false,
                docs: "about the intermediate axis",
            },
            sim_kernel::Quantity {
                name: "w3",
                unit: "rad/s",
                factor: 1f64,
                is_length: false,
                docs: "about the axis of most inertia",
            },
            sim_kernel::Quantity {
                name: "Hx",
                unit: "N*m*s",
                factor: 1f64,
                is_length: false,
                docs: "",
            },
            sim_kernel::Quantity {
                name: "Hy",
                unit: "N*m*s",
                factor: 1f64,
                is_length: false,
                docs: "",
            },
            sim_kernel::Quantity {
                name: "Hz",
                unit: "N*m*s",
                factor: 1f64,
                is_length: false,
                docs: "",
            },
            sim_kernel::Quantity {
                name: "energy",
                unit: "J",
                factor: 1f64,
                is_length: false,
                docs: "kinetic energy",
            },
            sim_kernel::Quantity {
                name: "norm_force",
                unit: "J",
                factor: 1f64,
                is_length: false,
                docs: "what keeps the norm: nothing",
            },
        ],
        rated_outputs: &[0, 1, 2, 3, 4, 5, 6],
        figures: &[
            sim_kernel::Figure {
                name: "angular_velocity",
                title: "Angular velocity in the frame of the body",
                len: 3,
            },
            sim_kernel::Figure {
                name: "angular_momentum",
                title: "Angular momentum in the world",
                len: 3,
            },
            sim_kernel::Figure {
                name: "energy",
                title: "kinetic energy",
                len: 1,
            },
            sim_kernel::Figure {
                name: "norm_force",
                title: "what keeps the norm: nothing",
                len: 1,
            },
        ],
        optional_kernels: &["dynamics_jacobian"],
        dimension: 3,
        drawing: &[
            sim_kernel::Shape::Line(5),
            sim_kernel::Shape::Line(2),
            sim_kernel::Shape::Curve(2),
            sim_kernel::Shape::Points(1),
        ],
    };
    fn defaults() -> Self {
        Self {
            A: S::from_f64(1f64),
            B: S::from_f64(2f64),
            C: S::from_f64(3f64),
            m: S::from_f64(1f64),
            H: S::from_f64(6f64),
            theta0: S::from_f64(0.4886921905584123f64),
        }
    }
    fn parameters(&self) -> [S; 6] {
        [self.A, self.B, self.C, self.m, self.H, self.theta0]
    }
    fn with_parameters(&self, parameters: [S; 6]) -> Self {
        Self {
            A: parameters[0],
            B: parameters[1],
            C: parameters[2],
            m: parameters[3],
            H: parameters[4],
            theta0: parameters[5],
            ..*self
        }
    }
    fn on<T: sim_kernel::Scalar>(
        &self,
        convert: impl ::core::ops::Fn(S) -> T,
    ) -> TumblingQuaternion<T> {
        TumblingQuaternion {
            A: convert(self.A),
            B: convert(self.B),
            C: convert(self.C),
            m: convert(self.m),
            H: convert(self.H),
            theta0: convert(self.theta0),
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
    fn prepare(&self) -> TumblingQuaternionPrepared<S> {
        self.prepare()
    }
    #[inline(always)]
    fn prepared_dynamics(
        prepared: &Self::Prepared,
        t: S,
        q: &[S; 7],
        qd: &[S; 7],
    ) -> sim_kernel::Dynamics<S, [S; 7], [S; 1]> {
        prepared.dynamics(t, q, qd)
    }
    #[inline(always)]
    fn dynamics_jacobian(
        &self,
        t: S,
        q: &[S; 7],
        qd: &[S; 7],
    ) -> sim_kernel::DynamicsJacobian<S, [[S; 7]; 7], [[S; 7]; 1]> {
        self.prepare().dynamics_jacobian(t, q, qd)
    }
    #[inline(always)]
    fn mass_matrix(&self, t: S, q: &[S; 7]) -> [[S; 7]; 7] {
        self.mass_matrix(t, q)
    }
    #[inline(always)]
    fn convective_forces(&self, t: S, q: &[S; 7], qd: &[S; 7]) -> [S; 7] {
        self.convective_forces(t, q, qd)
    }
    #[inline(always)]
    fn generalized_forces(&self, t: S, q: &[S; 7], qd: &[S; 7]) -> [S; 7] {
        self.generalized_forces(t, q, qd)
    }
    #[inline(always)]
    fn constraints(&self, t: S, q: &[S; 7]) -> [S; 1] {
        self.constraints(t, q)
    }
    #[inline(always)]
    fn constraint_magnitudes(&self, t: S, q: &[S; 7]) -> [S; 1] {
        self.constraint_magnitudes(t, q)
    }
    #[inline(always)]
    fn constraint_jacobian(&self, t: S, q: &[S; 7]) -> [[S; 7]; 1] {
        self.constraint_jacobian(t, q)
    }
    #[inline(always)]
    fn constraint_time_derivative(&self, t: S, q: &[S; 7]) -> [S; 1] {
        self.constraint_time_derivative(t, q)
    }
    #[inline(always)]
    fn constraint_convective(&self, t: S, q: &[S; 7], qd: &[S; 7]) -> [S; 1] {
        self.constraint_convective(t, q, qd)
    }
    #[inline(always)]
    fn constraint_linearization(
        &self,
        t: S,
        q: &[S; 7],
    ) -> sim_kernel::ConstraintLinearization<[S; 1], [[S; 7]; 1]> {
        self.constraint_linearization(t, q)
    }
    #[inline(always)]
    fn kinetic_energy(&self, t: S, q: &[S; 7], qd: &[S; 7]) -> S {
        self.kinetic_energy(t, q, qd)
    }
    #[inline(always)]
    fn power(&self, t: S, q: &[S; 7], qd: &[S; 7], qdd: &[S; 7], lambda: &[S; 1]) -> S {
        self.power(t, q, qd, qdd, lambda)
    }
    #[inline(always)]
    fn outputs(
        &self,
        t: S,
        q: &[S; 7],
        qd: &[S; 7],
        qdd: &[S; 7],
        lambda: &[S; 1],
    ) -> [S; 8] {
        self.outputs(t, q, qd, qdd, lambda).into()
    }
    #[inline(always)]
    fn output_rates(&self, t: S, q: &[S; 7], qd: &[S; 7], qdd: &[S; 7]) -> [S; 7] {
        self.output_rates(t, q, qd, qdd).into()
    }
    #[inline(always)]
    fn events(
        &self,
        t: S,
        q: &[S; 7],
        qd: &[S; 7],
        qdd: &[S; 7],
        lambda: &[S; 1],
    ) -> [S; 0] {
        self.events(t, q, qd, qdd, lambda)
    }
    #[inline(always)]
    fn drawing(&self, t: S, q: &[S; 7]) -> [S; 30] {
        self.drawing(t, q)
    }
    #[inline(always)]
    fn initial(&self) -> sim_kernel::Initial<[S; 7]> {
        self.initial()
    }
}
