/// Five uniform rods, each hanging on the one before, by their angles from the vertical.
///
/// The fields are its parameters, in SI units; the methods are its kernels.
///
/// # Equations of motion
///
/// ```text
/// mass_matrix * accelerations = generalized_forces - convective_forces
/// coordinates = [phi_1; phi_2; phi_3; phi_4; phi_5]
/// [
///     13*m*l^2/3, mass_matrix[1, 2], mass_matrix[1, 3], mass_matrix[1, 4], mass_matrix[1, 5];
///     mass_matrix[1, 2], 10*m*l^2/3, mass_matrix[2, 3], mass_matrix[2, 4], mass_matrix[2, 5];
///     mass_matrix[1, 3], mass_matrix[2, 3], 7*m*l^2/3, mass_matrix[3, 4], mass_matrix[3, 5];
///     mass_matrix[1, 4], mass_matrix[2, 4], mass_matrix[3, 4], 4*m*l^2/3, mass_matrix[4, 5];
///     mass_matrix[1, 5], mass_matrix[2, 5], mass_matrix[3, 5], mass_matrix[4, 5], m*l^2/3
/// ] * [
///     phi_1_ddot;
///     phi_2_ddot;
///     phi_3_ddot;
///     phi_4_ddot;
///     phi_5_ddot
/// ] = [
///     -9*m*l*g*sin(phi_1)/2 - convective_forces[1];
///     -7*m*l*g*sin(phi_2)/2 - convective_forces[2];
///     -5*m*l*g*sin(phi_3)/2 - convective_forces[3];
///     -3*m*l*g*sin(phi_4)/2 - convective_forces[4];
///     -m*l*g*sin(phi_5)/2 - convective_forces[5]
/// ]
///
/// mass_matrix = [
///     13*m*l^2/3, mass_matrix[1, 2], mass_matrix[1, 3], mass_matrix[1, 4], mass_matrix[1, 5];
///     mass_matrix[1, 2], 10*m*l^2/3, mass_matrix[2, 3], mass_matrix[2, 4], mass_matrix[2, 5];
///     mass_matrix[1, 3], mass_matrix[2, 3], 7*m*l^2/3, mass_matrix[3, 4], mass_matrix[3, 5];
///     mass_matrix[1, 4], mass_matrix[2, 4], mass_matrix[3, 4], 4*m*l^2/3, mass_matrix[4, 5];
///     mass_matrix[1, 5], mass_matrix[2, 5], mass_matrix[3, 5], mass_matrix[4, 5], m*l^2/3
/// ]
/// mass_matrix[1, 2] = 7*m*l^2*cos(phi_1)*cos(phi_2)/2 + 7*m*l^2*sin(phi_1)*sin(phi_2)/2
/// mass_matrix[1, 3] = 5*m*l^2*cos(phi_1)*cos(phi_3)/2 + 5*m*l^2*sin(phi_1)*sin(phi_3)/2
/// mass_matrix[1, 4] = 3*m*l^2*cos(phi_1)*cos(phi_4)/2 + 3*m*l^2*sin(phi_1)*sin(phi_4)/2
/// mass_matrix[1, 5] = m*l^2*cos(phi_1)*cos(phi_5)/2 + m*l^2*sin(phi_1)*sin(phi_5)/2
/// mass_matrix[2, 3] = 5*m*l^2*cos(phi_2)*cos(phi_3)/2 + 5*m*l^2*sin(phi_2)*sin(phi_3)/2
/// mass_matrix[2, 4] = 3*m*l^2*cos(phi_2)*cos(phi_4)/2 + 3*m*l^2*sin(phi_2)*sin(phi_4)/2
/// mass_matrix[2, 5] = m*l^2*cos(phi_2)*cos(phi_5)/2 + m*l^2*sin(phi_2)*sin(phi_5)/2
/// mass_matrix[3, 4] = 3*m*l^2*cos(phi_3)*cos(phi_4)/2 + 3*m*l^2*sin(phi_3)*sin(phi_4)/2
/// mass_matrix[3, 5] = m*l^2*cos(phi_3)*cos(phi_5)/2 + m*l^2*sin(phi_3)*sin(phi_5)/2
/// mass_matrix[4, 5] = m*l^2*cos(phi_4)*cos(phi_5)/2 + m*l^2*sin(phi_4)*sin(phi_5)/2
///
/// convective_forces = [
///     convective_forces[1];
///     convective_forces[2];
///     convective_forces[3];
///     convective_forces[4];
///     convective_forces[5]
/// ]
/// convective_forces[1] = m*l*s_2*sin(phi_1)/2 - m*l*s_1*cos(phi_1)/2 - m*l*s_3*cos(phi_1)/2
///     + m*l*s_4*sin(phi_1)/2 - m*l*s_5*cos(phi_1)/2 + m*l*s_6*sin(phi_1)/2
///     - m*l*s_7*cos(phi_1)/2 + m*l*s_8*sin(phi_1)/2
/// convective_forces[2] = m*l*s_2*sin(phi_2)/4 - m*l*s_1*cos(phi_2)/4 - m*l*s_3*cos(phi_2)/2
///     + m*l*s_4*sin(phi_2)/2 - m*l*s_5*cos(phi_2)/2 + m*l*s_6*sin(phi_2)/2
///     - m*l*s_7*cos(phi_2)/2 + m*l*s_8*sin(phi_2)/2
/// convective_forces[3] = m*l*s_4*sin(phi_3)/4 - m*l*s_3*cos(phi_3)/4 - m*l*s_5*cos(phi_3)/2
///     + m*l*s_6*sin(phi_3)/2 - m*l*s_7*cos(phi_3)/2 + m*l*s_8*sin(phi_3)/2
/// convective_forces[4] = m*l*s_6*sin(phi_4)/4 - m*l*s_5*cos(phi_4)/4 - m*l*s_7*cos(phi_4)/2
///     + m*l*s_8*sin(phi_4)/2
/// convective_forces[5] = m*l*s_8*sin(phi_5)/4 - m*l*s_7*cos(phi_5)/4
///
/// generalized_forces = [
///     -9*m*l*g*sin(phi_1)/2;
///     -7*m*l*g*sin(phi_2)/2;
///     -5*m*l*g*sin(phi_3)/2;
///     -3*m*l*g*sin(phi_4)/2;
///     -m*l*g*sin(phi_5)/2
/// ]
///
/// s_1 = 2*l*phi_1_dot^2*sin(phi_1) + l*phi_2_dot^2*sin(phi_2)
/// s_2 = 2*l*phi_1_dot^2*cos(phi_1) + l*phi_2_dot^2*cos(phi_2)
/// s_3 = 2*l*phi_1_dot^2*sin(phi_1) + 2*l*phi_2_dot^2*sin(phi_2) + l*phi_3_dot^2*sin(phi_3)
/// s_4 = 2*l*phi_1_dot^2*cos(phi_1) + 2*l*phi_2_dot^2*cos(phi_2) + l*phi_3_dot^2*cos(phi_3)
/// s_5 = 2*l*phi_1_dot^2*sin(phi_1) + 2*l*phi_2_dot^2*sin(phi_2) + 2*l*phi_3_dot^2*sin(phi_3)
///     + l*phi_4_dot^2*sin(phi_4)
/// s_6 = 2*l*phi_1_dot^2*cos(phi_1) + 2*l*phi_2_dot^2*cos(phi_2) + 2*l*phi_3_dot^2*cos(phi_3)
///     + l*phi_4_dot^2*cos(phi_4)
/// s_7 = 2*l*phi_1_dot^2*sin(phi_1) + 2*l*phi_2_dot^2*sin(phi_2) + 2*l*phi_3_dot^2*sin(phi_3)
///     + 2*l*phi_4_dot^2*sin(phi_4) + l*phi_5_dot^2*sin(phi_5)
/// s_8 = 2*l*phi_1_dot^2*cos(phi_1) + 2*l*phi_2_dot^2*cos(phi_2) + 2*l*phi_3_dot^2*cos(phi_3)
///     + 2*l*phi_4_dot^2*cos(phi_4) + l*phi_5_dot^2*cos(phi_5)
/// ```
#[allow(non_snake_case)]
#[derive(
    ::core::clone::Clone,
    ::core::marker::Copy,
    ::core::fmt::Debug,
    ::core::cmp::PartialEq
)]
pub struct Chain<S = ::core::primitive::f64> {
    /// Mass of a rod, in `kg`.
    pub m: S,
    /// Length of a rod, in `m`.
    pub l: S,
    /// Acceleration of free fall, in `m/s^2`.
    pub g: S,
}
impl<S: sim_kernel::Scalar> ::core::default::Default for Chain<S> {
    /// The declared values.
    fn default() -> Self {
        <Self as sim_kernel::Mechanism<S>>::defaults()
    }
}
/// Coordinates of [`Chain`] by name, in SI units; also for their speeds and accelerations.
#[allow(non_snake_case)]
#[derive(
    ::core::clone::Clone,
    ::core::marker::Copy,
    ::core::fmt::Debug,
    ::core::cmp::PartialEq
)]
pub struct ChainCoordinates<S = ::core::primitive::f64> {
    /// In `rad`.
    pub phi_1: S,
    /// In `rad`.
    pub phi_2: S,
    /// In `rad`.
    pub phi_3: S,
    /// In `rad`.
    pub phi_4: S,
    /// In `rad`.
    pub phi_5: S,
}
impl<S: sim_kernel::Scalar> ::core::convert::From<[S; 5]> for ChainCoordinates<S> {
    fn from(values: [S; 5]) -> Self {
        Self {
            phi_1: values[0],
            phi_2: values[1],
            phi_3: values[2],
            phi_4: values[3],
            phi_5: values[4],
        }
    }
}
impl<S: sim_kernel::Scalar> ::core::convert::From<ChainCoordinates<S>> for [S; 5] {
    fn from(record: ChainCoordinates<S>) -> Self {
        [record.phi_1, record.phi_2, record.phi_3, record.phi_4, record.phi_5]
    }
}
/// Outputs of [`Chain`] by name, in SI units.
#[allow(non_snake_case)]
#[derive(
    ::core::clone::Clone,
    ::core::marker::Copy,
    ::core::fmt::Debug,
    ::core::cmp::PartialEq
)]
pub struct ChainOutputs<S = ::core::primitive::f64> {
    /// End of the chain, in `m`.
    pub tip_x: S,
    /// In `m`.
    pub tip_y: S,
}
impl<S: sim_kernel::Scalar> ::core::convert::From<[S; 2]> for ChainOutputs<S> {
    fn from(values: [S; 2]) -> Self {
        Self {
            tip_x: values[0],
            tip_y: values[1],
        }
    }
}
impl<S: sim_kernel::Scalar> ::core::convert::From<ChainOutputs<S>> for [S; 2] {
    fn from(record: ChainOutputs<S>) -> Self {
        [record.tip_x, record.tip_y]
    }
}
/// Rates of the outputs of [`Chain`] by name, in SI units.
#[allow(non_snake_case)]
#[derive(
    ::core::clone::Clone,
    ::core::marker::Copy,
    ::core::fmt::Debug,
    ::core::cmp::PartialEq
)]
pub struct ChainOutputRates<S = ::core::primitive::f64> {
    /// Rate of `tip_x`.
    pub tip_x: S,
    /// Rate of `tip_y`.
    pub tip_y: S,
}
impl<S: sim_kernel::Scalar> ::core::convert::From<[S; 2]> for ChainOutputRates<S> {
    fn from(values: [S; 2]) -> Self {
        Self {
            tip_x: values[0],
            tip_y: values[1],
        }
    }
}
impl<S: sim_kernel::Scalar> ::core::convert::From<ChainOutputRates<S>> for [S; 2] {
    fn from(record: ChainOutputRates<S>) -> Self {
        [record.tip_x, record.tip_y]
    }
}
#[allow(non_snake_case, unused_variables, unused_parens, clippy::all, clippy::pedantic)]
impl<S: sim_kernel::Scalar> Chain<S> {
    /// Accelerations (5), multipliers (0) and power, from
    ///
    /// ```text
    /// [ T_q' M T_q   C_q' ] [ q''    ]   [ T_q' (F - M g)                      ]
    /// [ C_q          0    ] [ lambda ] = [ -(C_q q' + C_t)_q q' - (..)_t       ]
    /// ```
    ///
    /// by an elimination planned from the structure of the system. Where `refused` is set a pivot was too small and nothing else holds: solve that state from the other kernels.
    ///
    /// Operations: 138 additions, 342 multiplications, 5 divisions, 5 sine-cosine pairs.
    #[inline]
    pub fn dynamics(
        &self,
        t: S,
        q: &[S; 5],
        qd: &[S; 5],
    ) -> sim_kernel::Dynamics<S, [S; 5], [S; 0]> {
        let [phi_1, phi_2, phi_3, phi_4, phi_5] = *q;
        let [phi_1_dot, phi_2_dot, phi_3_dot, phi_4_dot, phi_5_dot] = *qd;
        let l_squared = self.l * self.l;
        let mass_phi_1_phi_1 = S::from_f64(4.333333333333333) * self.m * l_squared;
        let (
            [sin_phi_1,
            sin_phi_2,
            sin_phi_3,
            sin_phi_4,
            sin_phi_5,
            ],
            [cos_phi_1,
            cos_phi_2,
            cos_phi_3,
            cos_phi_4,
            cos_phi_5,
            ],
        ) = S::sin_cos_each([phi_1, phi_2, phi_3, phi_4, phi_5]);
        let mass_phi_2_phi_1 = S::from_f64(3.5) * self.m * l_squared * cos_phi_1
            * cos_phi_2 + S::from_f64(3.5) * self.m * l_squared * sin_phi_1 * sin_phi_2;
        let mass_phi_2_phi_2 = S::from_f64(3.3333333333333335) * self.m * l_squared;
        let mass_phi_3_phi_1 = S::from_f64(2.5) * self.m * l_squared * cos_phi_1
            * cos_phi_3 + S::from_f64(2.5) * self.m * l_squared * sin_phi_1 * sin_phi_3;
        let mass_phi_3_phi_3 = S::from_f64(2.3333333333333335) * self.m * l_squared;
        let mass_phi_4_phi_1 = S::from_f64(1.5) * self.m * l_squared * cos_phi_1
            * cos_phi_4 + S::from_f64(1.5) * self.m * l_squared * sin_phi_1 * sin_phi_4;
        let mass_phi_4_phi_4 = S::from_f64(1.3333333333333333) * self.m * l_squared;
        let mass_phi_5_phi_1 = S::from_f64(0.5) * self.m * l_squared * cos_phi_1
            * cos_phi_5 + S::from_f64(0.5) * self.m * l_squared * sin_phi_1 * sin_phi_5;
        let mass_phi_5_phi_5 = S::from_f64(0.3333333333333333) * self.m * l_squared;
        let phi_1_dot_squared = phi_1_dot * phi_1_dot;
        let w = S::from_f64(2.0) * phi_1_dot_squared * self.l * sin_phi_1;
        let phi_2_dot_squared = phi_2_dot * phi_2_dot;
        let w_2 = phi_2_dot_squared * self.l * sin_phi_2;
        let w_3 = w + w_2;
        let w_4 = S::from_f64(2.0) * phi_1_dot_squared * self.l * cos_phi_1;
        let w_5 = phi_2_dot_squared * self.l * cos_phi_2;
        let w_6 = w_4 + w_5;
        let w_7 = S::from_f64(2.0) * w_2;
        let phi_3_dot_squared = phi_3_dot * phi_3_dot;
        let w_8 = phi_3_dot_squared * self.l * sin_phi_3;
        let w_9 = w + w_7 + w_8;
        let w_10 = S::from_f64(2.0) * w_5;
        let w_11 = phi_3_dot_squared * self.l * cos_phi_3;
        let w_12 = w_4 + w_10 + w_11;
        let w_13 = S::from_f64(0.5) * self.m * self.l * sin_phi_1 * w_12;
        let w_14 = S::from_f64(2.0) * w_8;
        let phi_4_dot_squared = phi_4_dot * phi_4_dot;
        let w_15 = phi_4_dot_squared * self.l * sin_phi_4;
        let w_16 = w + w_7 + w_14 + w_15;
        let w_17 = S::from_f64(0.5) * self.m * self.l * cos_phi_1 * w_16;
        let w_18 = S::from_f64(2.0) * w_11;
        let w_19 = phi_4_dot_squared * self.l * cos_phi_4;
        let w_20 = w_4 + w_10 + w_18 + w_19;
        let w_21 = S::from_f64(0.5) * self.m * self.l * sin_phi_1 * w_20;
        let phi_5_dot_squared = phi_5_dot * phi_5_dot;
        let w_22 = w + w_7 + w_14 + S::from_f64(2.0) * w_15
            + phi_5_dot_squared * self.l * sin_phi_5;
        let w_23 = S::from_f64(0.5) * self.m * self.l * cos_phi_1 * w_22;
        let w_24 = w_4 + w_10 + w_18 + S::from_f64(2.0) * w_19
            + phi_5_dot_squared * self.l * cos_phi_5;
        let w_25 = S::from_f64(0.5) * self.m * self.l * sin_phi_1 * w_24;
        let w_26 = S::from_f64(4.5) * self.m * self.l * self.g * sin_phi_1;
        let rhs_phi_1 = S::from_f64(0.5) * self.m * self.l * cos_phi_1 * w_3
            - S::from_f64(0.5) * self.m * self.l * sin_phi_1 * w_6
            + S::from_f64(0.5) * self.m * self.l * cos_phi_1 * w_9 - w_13 + w_17 - w_21
            + w_23 - w_25 - w_26;
        let w_27 = S::from_f64(0.5) * self.m * self.l * sin_phi_2 * w_12;
        let w_28 = S::from_f64(0.5) * self.m * self.l * cos_phi_2 * w_16;
        let w_29 = S::from_f64(0.5) * self.m * self.l * sin_phi_2 * w_20;
        let w_30 = S::from_f64(0.5) * self.m * self.l * cos_phi_2 * w_22;
        let w_31 = S::from_f64(0.5) * self.m * self.l * sin_phi_2 * w_24;
        let w_32 = S::from_f64(3.5) * self.m * self.l * self.g * sin_phi_2;
        let w_33 = S::from_f64(0.25) * self.m * self.l * cos_phi_2 * w_3
            - S::from_f64(0.25) * self.m * self.l * sin_phi_2 * w_6
            + S::from_f64(0.5) * self.m * self.l * cos_phi_2 * w_9 - w_27 + w_28 - w_29
            + w_30 - w_31 - w_32;
        let w_34 = S::from_f64(0.5) * self.m * self.l * sin_phi_3 * w_20;
        let w_35 = S::from_f64(0.5) * self.m * self.l * cos_phi_3 * w_22;
        let w_36 = S::from_f64(0.5) * self.m * self.l * sin_phi_3 * w_24;
        let w_37 = S::from_f64(2.5) * self.m * self.l * self.g * sin_phi_3;
        let w_38 = S::from_f64(0.25) * self.m * self.l * cos_phi_3 * w_9
            - S::from_f64(0.25) * self.m * self.l * sin_phi_3 * w_12
            + S::from_f64(0.5) * self.m * self.l * cos_phi_3 * w_16 - w_34 + w_35 - w_36
            - w_37;
        let w_39 = S::from_f64(0.5) * self.m * self.l * sin_phi_4 * w_24;
        let w_40 = S::from_f64(1.5) * self.m * self.l * self.g * sin_phi_4;
        let w_41 = S::from_f64(0.25) * self.m * self.l * cos_phi_4 * w_16
            - S::from_f64(0.25) * self.m * self.l * sin_phi_4 * w_20
            + S::from_f64(0.5) * self.m * self.l * cos_phi_4 * w_22 - w_39 - w_40;
        let w_42 = S::from_f64(0.25) * self.m * self.l * cos_phi_5 * w_22
            - S::from_f64(0.25) * self.m * self.l * sin_phi_5 * w_24
            - S::from_f64(0.5) * self.m * self.l * self.g * sin_phi_5;
        let inverse_phi_1 = S::from_f64(1.0) / mass_phi_1_phi_1;
        let l_phi_2_phi_1 = mass_phi_2_phi_1 * inverse_phi_1;
        let w_43 = l_phi_2_phi_1 * mass_phi_2_phi_1;
        let l_phi_3_phi_1 = mass_phi_3_phi_1 * inverse_phi_1;
        let w_44 = l_phi_3_phi_1 * mass_phi_3_phi_1;
        let l_phi_4_phi_1 = mass_phi_4_phi_1 * inverse_phi_1;
        let w_45 = l_phi_4_phi_1 * mass_phi_4_phi_1;
        let l_phi_5_phi_1 = mass_phi_5_phi_1 * inverse_phi_1;
        let w_46 = l_phi_5_phi_1 * mass_phi_5_phi_1;
        let pivot_phi_2 = mass_phi_2_phi_2 - w_43;
        let inverse_phi_2 = S::from_f64(1.0) / pivot_phi_2;
        let rhs_phi_2 = w_33 - l_phi_2_phi_1 * rhs_phi_1;
        let k_phi_3_phi_2 = S::from_f64(2.5) * self.m * l_squared * cos_phi_2 * cos_phi_3
            + S::from_f64(2.5) * self.m * l_squared * sin_phi_2 * sin_phi_3
            - l_phi_3_phi_1 * mass_phi_2_phi_1;
        let l_phi_3_phi_2 = k_phi_3_phi_2 * inverse_phi_2;
        let w_47 = l_phi_3_phi_2 * k_phi_3_phi_2;
        let k_phi_4_phi_2 = S::from_f64(1.5) * self.m * l_squared * cos_phi_2 * cos_phi_4
            + S::from_f64(1.5) * self.m * l_squared * sin_phi_2 * sin_phi_4
            - l_phi_4_phi_1 * mass_phi_2_phi_1;
        let l_phi_4_phi_2 = k_phi_4_phi_2 * inverse_phi_2;
        let w_48 = l_phi_4_phi_2 * k_phi_4_phi_2;
        let k_phi_5_phi_2 = S::from_f64(0.5) * self.m * l_squared * cos_phi_2 * cos_phi_5
            + S::from_f64(0.5) * self.m * l_squared * sin_phi_2 * sin_phi_5
            - l_phi_5_phi_1 * mass_phi_2_phi_1;
        let l_phi_5_phi_2 = k_phi_5_phi_2 * inverse_phi_2;
        let w_49 = l_phi_5_phi_2 * k_phi_5_phi_2;
        let pivot_phi_3 = mass_phi_3_phi_3 - w_44 - w_47;
        let inverse_phi_3 = S::from_f64(1.0) / pivot_phi_3;
        let rhs_phi_3 = w_38 - l_phi_3_phi_1 * rhs_phi_1 - l_phi_3_phi_2 * rhs_phi_2;
        let k_phi_4_phi_3 = S::from_f64(1.5) * self.m * l_squared * cos_phi_3 * cos_phi_4
            + S::from_f64(1.5) * self.m * l_squared * sin_phi_3 * sin_phi_4
            - l_phi_4_phi_1 * mass_phi_3_phi_1 - l_phi_4_phi_2 * k_phi_3_phi_2;
        let l_phi_4_phi_3 = k_phi_4_phi_3 * inverse_phi_3;
        let w_50 = l_phi_4_phi_3 * k_phi_4_phi_3;
        let k_phi_5_phi_3 = S::from_f64(0.5) * self.m * l_squared * cos_phi_3 * cos_phi_5
            + S::from_f64(0.5) * self.m * l_squared * sin_phi_3 * sin_phi_5
            - l_phi_5_phi_1 * mass_phi_3_phi_1 - l_phi_5_phi_2 * k_phi_3_phi_2;
        let l_phi_5_phi_3 = k_phi_5_phi_3 * inverse_phi_3;
        let w_51 = l_phi_5_phi_3 * k_phi_5_phi_3;
        let pivot_phi_4 = mass_phi_4_phi_4 - w_45 - w_48 - w_50;
        let inverse_phi_4 = S::from_f64(1.0) / pivot_phi_4;
        let rhs_phi_4 = w_41 - l_phi_4_phi_1 * rhs_phi_1 - l_phi_4_phi_2 * rhs_phi_2
            - l_phi_4_phi_3 * rhs_phi_3;
        let k_phi_5_phi_4 = S::from_f64(0.5) * self.m * l_squared * cos_phi_4 * cos_phi_5
            + S::from_f64(0.5) * self.m * l_squared * sin_phi_4 * sin_phi_5
            - l_phi_5_phi_1 * mass_phi_4_phi_1 - l_phi_5_phi_2 * k_phi_4_phi_2
            - l_phi_5_phi_3 * k_phi_4_phi_3;
        let l_phi_5_phi_4 = k_phi_5_phi_4 * inverse_phi_4;
        let w_52 = l_phi_5_phi_4 * k_phi_5_phi_4;
        let pivot_phi_5 = mass_phi_5_phi_5 - w_46 - w_49 - w_51 - w_52;
        let phi_5_ddot = (w_42 - l_phi_5_phi_1 * rhs_phi_1 - l_phi_5_phi_2 * rhs_phi_2
            - l_phi_5_phi_3 * rhs_phi_3 - l_phi_5_phi_4 * rhs_phi_4)
            * (S::from_f64(1.0) / pivot_phi_5);
        let phi_4_ddot = rhs_phi_4 * inverse_phi_4 - l_phi_5_phi_4 * phi_5_ddot;
        let phi_3_ddot = rhs_phi_3 * inverse_phi_3 - l_phi_4_phi_3 * phi_4_ddot
            - l_phi_5_phi_3 * phi_5_ddot;
        let phi_2_ddot = rhs_phi_2 * inverse_phi_2 - l_phi_3_phi_2 * phi_3_ddot
            - l_phi_4_phi_2 * phi_4_ddot - l_phi_5_phi_2 * phi_5_ddot;
        let w_53 = S::from_f64(2.0) * phi_1_dot * self.l * sin_phi_1;
        let w_54 = phi_2_dot * self.l * sin_phi_2;
        let w_55 = S::from_f64(2.0) * w_54;
        let w_56 = phi_3_dot * self.l * sin_phi_3;
        let w_57 = S::from_f64(2.0) * w_56;
        let w_58 = phi_4_dot * self.l * sin_phi_4;
        let w_59 = S::from_f64(0.5) * self.m * self.g * (w_53 + w_55 + w_57 + w_58);
        let w_60 = S::from_f64(0.5) * self.m * self.g
            * (w_53 + w_55 + w_57 + S::from_f64(2.0) * w_58
                + phi_5_dot * self.l * sin_phi_5);
        let w_61 = S::from_f64(0.5) * phi_1_dot * self.m * self.l * self.g * sin_phi_1
            + S::from_f64(0.5) * self.m * self.g * (w_53 + w_54)
            + S::from_f64(0.5) * self.m * self.g * (w_53 + w_55 + w_56) + w_59 + w_60;
        let refused = sim_kernel::pivot_is_refused(
            mass_phi_1_phi_1,
            mass_phi_1_phi_1.abs(),
        )
            | sim_kernel::pivot_is_refused(
                pivot_phi_2,
                mass_phi_2_phi_2.abs() + w_43.abs(),
            )
            | sim_kernel::pivot_is_refused(
                pivot_phi_3,
                mass_phi_3_phi_3.abs() + w_44.abs() + w_47.abs(),
            )
            | sim_kernel::pivot_is_refused(
                pivot_phi_4,
                mass_phi_4_phi_4.abs() + w_45.abs() + w_48.abs() + w_50.abs(),
            )
            | sim_kernel::pivot_is_refused(
                pivot_phi_5,
                mass_phi_5_phi_5.abs() + w_46.abs() + w_49.abs() + w_51.abs()
                    + w_52.abs(),
            );
        sim_kernel::Dynamics {
            accelerations: [
                rhs_phi_1 * inverse_phi_1 - l_phi_2_phi_1 * phi_2_ddot
                    - l_phi_3_phi_1 * phi_3_ddot - l_phi_4_phi_1 * phi_4_ddot
                    - l_phi_5_phi_1 * phi_5_ddot,
                phi_2_ddot,
                phi_3_ddot,
                phi_4_ddot,
                phi_5_ddot,
            ],
            multipliers: [],
            power: -w_61,
            refused,
        }
    }
    /// Mass matrix `T_q' M T_q`, 5 x 5, symmetric, in SI units.
    ///
    /// Operations: 10 additions, 91 multiplications, 5 sine-cosine pairs.
    #[inline]
    pub fn mass_matrix(&self, t: S, q: &[S; 5]) -> [[S; 5]; 5] {
        let [phi_1, phi_2, phi_3, phi_4, phi_5] = *q;
        let l_squared = self.l * self.l;
        let (
            [sin_phi_1,
            sin_phi_2,
            sin_phi_3,
            sin_phi_4,
            sin_phi_5,
            ],
            [cos_phi_1,
            cos_phi_2,
            cos_phi_3,
            cos_phi_4,
            cos_phi_5,
            ],
        ) = S::sin_cos_each([phi_1, phi_2, phi_3, phi_4, phi_5]);
        let mass_phi_2_phi_1 = S::from_f64(3.5) * self.m * l_squared * cos_phi_1
            * cos_phi_2 + S::from_f64(3.5) * self.m * l_squared * sin_phi_1 * sin_phi_2;
        let mass_phi_3_phi_1 = S::from_f64(2.5) * self.m * l_squared * cos_phi_1
            * cos_phi_3 + S::from_f64(2.5) * self.m * l_squared * sin_phi_1 * sin_phi_3;
        let mass_phi_4_phi_1 = S::from_f64(1.5) * self.m * l_squared * cos_phi_1
            * cos_phi_4 + S::from_f64(1.5) * self.m * l_squared * sin_phi_1 * sin_phi_4;
        let mass_phi_5_phi_1 = S::from_f64(0.5) * self.m * l_squared * cos_phi_1
            * cos_phi_5 + S::from_f64(0.5) * self.m * l_squared * sin_phi_1 * sin_phi_5;
        let mass_phi_3_phi_2 = S::from_f64(2.5) * self.m * l_squared * cos_phi_2
            * cos_phi_3 + S::from_f64(2.5) * self.m * l_squared * sin_phi_2 * sin_phi_3;
        let mass_phi_4_phi_2 = S::from_f64(1.5) * self.m * l_squared * cos_phi_2
            * cos_phi_4 + S::from_f64(1.5) * self.m * l_squared * sin_phi_2 * sin_phi_4;
        let mass_phi_5_phi_2 = S::from_f64(0.5) * self.m * l_squared * cos_phi_2
            * cos_phi_5 + S::from_f64(0.5) * self.m * l_squared * sin_phi_2 * sin_phi_5;
        let mass_phi_4_phi_3 = S::from_f64(1.5) * self.m * l_squared * cos_phi_3
            * cos_phi_4 + S::from_f64(1.5) * self.m * l_squared * sin_phi_3 * sin_phi_4;
        let mass_phi_5_phi_3 = S::from_f64(0.5) * self.m * l_squared * cos_phi_3
            * cos_phi_5 + S::from_f64(0.5) * self.m * l_squared * sin_phi_3 * sin_phi_5;
        let mass_phi_5_phi_4 = S::from_f64(0.5) * self.m * l_squared * cos_phi_4
            * cos_phi_5 + S::from_f64(0.5) * self.m * l_squared * sin_phi_4 * sin_phi_5;
        [
            [
                S::from_f64(4.333333333333333) * self.m * l_squared,
                mass_phi_2_phi_1,
                mass_phi_3_phi_1,
                mass_phi_4_phi_1,
                mass_phi_5_phi_1,
            ],
            [
                mass_phi_2_phi_1,
                S::from_f64(3.3333333333333335) * self.m * l_squared,
                mass_phi_3_phi_2,
                mass_phi_4_phi_2,
                mass_phi_5_phi_2,
            ],
            [
                mass_phi_3_phi_1,
                mass_phi_3_phi_2,
                S::from_f64(2.3333333333333335) * self.m * l_squared,
                mass_phi_4_phi_3,
                mass_phi_5_phi_3,
            ],
            [
                mass_phi_4_phi_1,
                mass_phi_4_phi_2,
                mass_phi_4_phi_3,
                S::from_f64(1.3333333333333333) * self.m * l_squared,
                mass_phi_5_phi_4,
            ],
            [
                mass_phi_5_phi_1,
                mass_phi_5_phi_2,
                mass_phi_5_phi_3,
                mass_phi_5_phi_4,
                S::from_f64(0.3333333333333333) * self.m * l_squared,
            ],
        ]
    }
    /// Convective forces `T_q' M g`, 5, with `g = (T_q q' + T_t)_q q' + (..)_t`.
    ///
    /// Operations: 43 additions, 145 multiplications, 5 sine-cosine pairs.
    #[inline]
    pub fn convective_forces(&self, t: S, q: &[S; 5], qd: &[S; 5]) -> [S; 5] {
        let [phi_1, phi_2, phi_3, phi_4, phi_5] = *q;
        let [phi_1_dot, phi_2_dot, phi_3_dot, phi_4_dot, phi_5_dot] = *qd;
        let (
            [sin_phi_1,
            sin_phi_2,
            sin_phi_3,
            sin_phi_4,
            sin_phi_5,
            ],
            [cos_phi_1,
            cos_phi_2,
            cos_phi_3,
            cos_phi_4,
            cos_phi_5,
            ],
        ) = S::sin_cos_each([phi_1, phi_2, phi_3, phi_4, phi_5]);
        let phi_1_dot_squared = phi_1_dot * phi_1_dot;
        let w = S::from_f64(2.0) * phi_1_dot_squared * self.l * sin_phi_1;
        let phi_2_dot_squared = phi_2_dot * phi_2_dot;
        let w_2 = phi_2_dot_squared * self.l * sin_phi_2;
        let w_3 = w + w_2;
        let w_4 = S::from_f64(2.0) * phi_1_dot_squared * self.l * cos_phi_1;
        let w_5 = phi_2_dot_squared * self.l * cos_phi_2;
        let w_6 = w_4 + w_5;
        let w_7 = S::from_f64(2.0) * w_2;
        let phi_3_dot_squared = phi_3_dot * phi_3_dot;
        let w_8 = phi_3_dot_squared * self.l * sin_phi_3;
        let w_9 = w + w_7 + w_8;
        let w_10 = S::from_f64(2.0) * w_5;
        let w_11 = phi_3_dot_squared * self.l * cos_phi_3;
        let w_12 = w_4 + w_10 + w_11;
        let w_13 = S::from_f64(0.5) * self.m * self.l * sin_phi_1 * w_12;
        let w_14 = S::from_f64(2.0) * w_8;
        let phi_4_dot_squared = phi_4_dot * phi_4_dot;
        let w_15 = phi_4_dot_squared * self.l * sin_phi_4;
        let w_16 = w + w_7 + w_14 + w_15;
        let w_17 = S::from_f64(0.5) * self.m * self.l * cos_phi_1 * w_16;
        let w_18 = S::from_f64(2.0) * w_11;
        let w_19 = phi_4_dot_squared * self.l * cos_phi_4;
        let w_20 = w_4 + w_10 + w_18 + w_19;
        let w_21 = S::from_f64(0.5) * self.m * self.l * sin_phi_1 * w_20;
        let phi_5_dot_squared = phi_5_dot * phi_5_dot;
        let w_22 = w + w_7 + w_14 + S::from_f64(2.0) * w_15
            + phi_5_dot_squared * self.l * sin_phi_5;
        let w_23 = S::from_f64(0.5) * self.m * self.l * cos_phi_1 * w_22;
        let w_24 = w_4 + w_10 + w_18 + S::from_f64(2.0) * w_19
            + phi_5_dot_squared * self.l * cos_phi_5;
        let w_25 = S::from_f64(0.5) * self.m * self.l * sin_phi_1 * w_24;
        let w_26 = S::from_f64(0.5) * self.m * self.l * sin_phi_2 * w_12;
        let w_27 = S::from_f64(0.5) * self.m * self.l * cos_phi_2 * w_16;
        let w_28 = S::from_f64(0.5) * self.m * self.l * sin_phi_2 * w_20;
        let w_29 = S::from_f64(0.5) * self.m * self.l * cos_phi_2 * w_22;
        let w_30 = S::from_f64(0.5) * self.m * self.l * sin_phi_2 * w_24;
        let w_31 = S::from_f64(0.5) * self.m * self.l * sin_phi_3 * w_20;
        let w_32 = S::from_f64(0.5) * self.m * self.l * cos_phi_3 * w_22;
        let w_33 = S::from_f64(0.5) * self.m * self.l * sin_phi_3 * w_24;
        let w_34 = S::from_f64(0.5) * self.m * self.l * sin_phi_4 * w_24;
        [
            S::from_f64(0.5) * self.m * self.l * sin_phi_1 * w_6
                - S::from_f64(0.5) * self.m * self.l * cos_phi_1 * w_3
                - S::from_f64(0.5) * self.m * self.l * cos_phi_1 * w_9 + w_13 - w_17
                + w_21 - w_23 + w_25,
            S::from_f64(0.25) * self.m * self.l * sin_phi_2 * w_6
                - S::from_f64(0.25) * self.m * self.l * cos_phi_2 * w_3
                - S::from_f64(0.5) * self.m * self.l * cos_phi_2 * w_9 + w_26 - w_27
                + w_28 - w_29 + w_30,
            S::from_f64(0.25) * self.m * self.l * sin_phi_3 * w_12
                - S::from_f64(0.25) * self.m * self.l * cos_phi_3 * w_9
                - S::from_f64(0.5) * self.m * self.l * cos_phi_3 * w_16 + w_31 - w_32
                + w_33,
            S::from_f64(0.25) * self.m * self.l * sin_phi_4 * w_20
                - S::from_f64(0.25) * self.m * self.l * cos_phi_4 * w_16
                - S::from_f64(0.5) * self.m * self.l * cos_phi_4 * w_22 + w_34,
            S::from_f64(0.25) * self.m * self.l * sin_phi_5 * w_24
                - S::from_f64(0.25) * self.m * self.l * cos_phi_5 * w_22,
        ]
    }
    /// Generalised forces `T_q' F`, 5: joules per unit of each coordinate.
    ///
    /// Operations: 5 additions, 20 multiplications, 5 sine-cosine pairs.
    #[inline]
    pub fn generalized_forces(&self, t: S, q: &[S; 5], qd: &[S; 5]) -> [S; 5] {
        let [phi_1, phi_2, phi_3, phi_4, phi_5] = *q;
        let ([sin_phi_1, sin_phi_2, sin_phi_3, sin_phi_4, sin_phi_5], [_, _, _, _, _]) = S::sin_cos_each([
            phi_1,
            phi_2,
            phi_3,
            phi_4,
            phi_5,
        ]);
        [
            -(S::from_f64(4.5) * self.m * self.l * self.g * sin_phi_1),
            -(S::from_f64(3.5) * self.m * self.l * self.g * sin_phi_2),
            -(S::from_f64(2.5) * self.m * self.l * self.g * sin_phi_3),
            -(S::from_f64(1.5) * self.m * self.l * self.g * sin_phi_4),
            -(S::from_f64(0.5) * self.m * self.l * self.g * sin_phi_5),
        ]
    }
    /// Constraints `C`, 0; zero throughout the motion.
    ///
    /// Operations: none.
    #[inline]
    pub fn constraints(&self, t: S, q: &[S; 5]) -> [S; 0] {
        []
    }
    /// The sum of the magnitudes of the terms of `C`, 0: what its rounding is relative to.
    ///
    /// Operations: none.
    #[inline]
    pub fn constraint_magnitudes(&self, t: S, q: &[S; 5]) -> [S; 0] {
        []
    }
    /// Constraint Jacobian `C_q`, 0 x 5.
    ///
    /// Operations: none.
    #[inline]
    pub fn constraint_jacobian(&self, t: S, q: &[S; 5]) -> [[S; 5]; 0] {
        []
    }
    /// `C_t`, 0: the speeds obey `C_q q' + C_t = 0`.
    ///
    /// Operations: none.
    #[inline]
    pub fn constraint_time_derivative(&self, t: S, q: &[S; 5]) -> [S; 0] {
        []
    }
    /// `(C_q q' + C_t)_q q' + (..)_t`, 0: the part of `C''` without accelerations.
    ///
    /// Operations: none.
    #[inline]
    pub fn constraint_convective(&self, t: S, q: &[S; 5], qd: &[S; 5]) -> [S; 0] {
        []
    }
    /// `C` (0), `C_q` (0 x 5) and `C_t` (0) together, for projection.
    ///
    /// Operations: none.
    #[inline]
    pub fn constraint_linearization(
        &self,
        t: S,
        q: &[S; 5],
    ) -> sim_kernel::ConstraintLinearization<[S; 0], [[S; 5]; 0]> {
        sim_kernel::ConstraintLinearization {
            values: [],
            jacobian: [],
            time_derivative: [],
        }
    }
    /// Kinetic energy `v' M v / 2`, in joules.
    ///
    /// Operations: 32 additions, 73 multiplications, 5 sine-cosine pairs.
    #[inline]
    pub fn kinetic_energy(&self, t: S, q: &[S; 5], qd: &[S; 5]) -> S {
        let [phi_1, phi_2, phi_3, phi_4, phi_5] = *q;
        let [phi_1_dot, phi_2_dot, phi_3_dot, phi_4_dot, phi_5_dot] = *qd;
        let l_squared = self.l * self.l;
        let w = S::from_f64(0.16666666666666666) * phi_1_dot * phi_1_dot * self.m
            * l_squared;
        let w_2 = S::from_f64(0.041666666666666664) * phi_2_dot * phi_2_dot * self.m
            * l_squared;
        let (
            [sin_phi_1,
            sin_phi_2,
            sin_phi_3,
            sin_phi_4,
            sin_phi_5,
            ],
            [cos_phi_1,
            cos_phi_2,
            cos_phi_3,
            cos_phi_4,
            cos_phi_5,
            ],
        ) = S::sin_cos_each([phi_1, phi_2, phi_3, phi_4, phi_5]);
        let w_3 = S::from_f64(2.0) * phi_1_dot * self.l * cos_phi_1;
        let w_4 = phi_2_dot * self.l * cos_phi_2;
        let w_5 = w_3 + w_4;
        let w_6 = S::from_f64(2.0) * phi_1_dot * self.l * sin_phi_1;
        let w_7 = phi_2_dot * self.l * sin_phi_2;
        let w_8 = w_6 + w_7;
        let w_9 = S::from_f64(0.041666666666666664) * phi_3_dot * phi_3_dot * self.m
            * l_squared;
        let w_10 = S::from_f64(2.0) * w_4;
        let w_11 = phi_3_dot * self.l * cos_phi_3;
        let w_12 = w_3 + w_10 + w_11;
        let w_13 = S::from_f64(2.0) * w_7;
        let w_14 = phi_3_dot * self.l * sin_phi_3;
        let w_15 = w_6 + w_13 + w_14;
        let w_16 = S::from_f64(0.041666666666666664) * phi_4_dot * phi_4_dot * self.m
            * l_squared;
        let w_17 = S::from_f64(2.0) * w_11;
        let w_18 = phi_4_dot * self.l * cos_phi_4;
        let w_19 = w_3 + w_10 + w_17 + w_18;
        let w_20 = S::from_f64(0.125) * self.m * w_19 * w_19;
        let w_21 = S::from_f64(2.0) * w_14;
        let w_22 = phi_4_dot * self.l * sin_phi_4;
        let w_23 = w_6 + w_13 + w_21 + w_22;
        let w_24 = S::from_f64(0.125) * self.m * w_23 * w_23;
        let w_25 = S::from_f64(0.041666666666666664) * phi_5_dot * phi_5_dot * self.m
            * l_squared;
        let w_26 = w_3 + w_10 + w_17 + S::from_f64(2.0) * w_18
            + phi_5_dot * self.l * cos_phi_5;
        let w_27 = S::from_f64(0.125) * self.m * w_26 * w_26;
        let w_28 = w_6 + w_13 + w_21 + S::from_f64(2.0) * w_22
            + phi_5_dot * self.l * sin_phi_5;
        let w_29 = S::from_f64(0.125) * self.m * w_28 * w_28;
        w + w_2 + S::from_f64(0.125) * self.m * w_5 * w_5
            + S::from_f64(0.125) * self.m * w_8 * w_8 + w_9
            + S::from_f64(0.125) * self.m * w_12 * w_12
            + S::from_f64(0.125) * self.m * w_15 * w_15 + w_16 + w_20 + w_24 + w_25
            + w_27 + w_29
    }
    /// Power of loads and drives, `F' v + lambda' C_t + T_t' (M x'' - F)`, in watts.
    ///
    /// Operations: 15 additions, 31 multiplications, 5 sine-cosine pairs.
    #[inline]
    pub fn power(
        &self,
        t: S,
        q: &[S; 5],
        qd: &[S; 5],
        qdd: &[S; 5],
        lambda: &[S; 0],
    ) -> S {
        let [phi_1, phi_2, phi_3, phi_4, phi_5] = *q;
        let [phi_1_dot, phi_2_dot, phi_3_dot, phi_4_dot, phi_5_dot] = *qd;
        let ([sin_phi_1, sin_phi_2, sin_phi_3, sin_phi_4, sin_phi_5], [_, _, _, _, _]) = S::sin_cos_each([
            phi_1,
            phi_2,
            phi_3,
            phi_4,
            phi_5,
        ]);
        let w = S::from_f64(2.0) * phi_1_dot * self.l * sin_phi_1;
        let w_2 = phi_2_dot * self.l * sin_phi_2;
        let w_3 = S::from_f64(2.0) * w_2;
        let w_4 = phi_3_dot * self.l * sin_phi_3;
        let w_5 = S::from_f64(2.0) * w_4;
        let w_6 = phi_4_dot * self.l * sin_phi_4;
        let w_7 = S::from_f64(0.5) * self.m * self.g * (w + w_3 + w_5 + w_6);
        let w_8 = S::from_f64(0.5) * self.m * self.g
            * (w + w_3 + w_5 + S::from_f64(2.0) * w_6 + phi_5_dot * self.l * sin_phi_5);
        let w_9 = S::from_f64(0.5) * phi_1_dot * self.m * self.l * self.g * sin_phi_1
            + S::from_f64(0.5) * self.m * self.g * (w + w_2)
            + S::from_f64(0.5) * self.m * self.g * (w + w_3 + w_4) + w_7 + w_8;
        -w_9
    }
    /// Outputs, in SI units.
    ///
    /// Operations: 9 additions, 10 multiplications, 5 sine-cosine pairs.
    #[inline]
    pub fn outputs(
        &self,
        t: S,
        q: &[S; 5],
        qd: &[S; 5],
        qdd: &[S; 5],
        lambda: &[S; 0],
    ) -> ChainOutputs<S> {
        let [phi_1, phi_2, phi_3, phi_4, phi_5] = *q;
        let (
            [sin_phi_1,
            sin_phi_2,
            sin_phi_3,
            sin_phi_4,
            sin_phi_5,
            ],
            [cos_phi_1,
            cos_phi_2,
            cos_phi_3,
            cos_phi_4,
            cos_phi_5,
            ],
        ) = S::sin_cos_each([phi_1, phi_2, phi_3, phi_4, phi_5]);
        [
            self.l * sin_phi_1 + self.l * sin_phi_2 + self.l * sin_phi_3
                + self.l * sin_phi_4 + self.l * sin_phi_5,
            -(self.l * cos_phi_1 + self.l * cos_phi_2 + self.l * cos_phi_3
                + self.l * cos_phi_4 + self.l * cos_phi_5),
        ]
            .into()
    }
    /// Rates of the outputs that depend on neither accelerations nor multipliers, in SI units.
    ///
    /// Operations: 8 additions, 20 multiplications, 5 sine-cosine pairs.
    #[inline]
    pub fn output_rates(
        &self,
        t: S,
        q: &[S; 5],
        qd: &[S; 5],
        qdd: &[S; 5],
    ) -> ChainOutputRates<S> {
        let [phi_1, phi_2, phi_3, phi_4, phi_5] = *q;
        let [phi_1_dot, phi_2_dot, phi_3_dot, phi_4_dot, phi_5_dot] = *qd;
        let (
            [sin_phi_1,
            sin_phi_2,
            sin_phi_3,
            sin_phi_4,
            sin_phi_5,
            ],
            [cos_phi_1,
            cos_phi_2,
            cos_phi_3,
            cos_phi_4,
            cos_phi_5,
            ],
        ) = S::sin_cos_each([phi_1, phi_2, phi_3, phi_4, phi_5]);
        [
            phi_1_dot * self.l * cos_phi_1 + phi_2_dot * self.l * cos_phi_2
                + phi_3_dot * self.l * cos_phi_3 + phi_4_dot * self.l * cos_phi_4
                + phi_5_dot * self.l * cos_phi_5,
            phi_1_dot * self.l * sin_phi_1 + phi_2_dot * self.l * sin_phi_2
                + phi_3_dot * self.l * sin_phi_3 + phi_4_dot * self.l * sin_phi_4
                + phi_5_dot * self.l * sin_phi_5,
        ]
            .into()
    }
    /// `left - right` of each event, zero when it happens.
    ///
    /// Operations: none.
    #[inline]
    pub fn events(&self, t: S, q: &[S; 5], qd: &[S; 5]) -> [S; 0] {
        []
    }
    /// The numbers of each shape of the drawing, in metres and radians.
    ///
    /// Operations: 25 additions, 10 multiplications, 5 sine-cosine pairs.
    #[inline]
    pub fn drawing(&self, t: S, q: &[S; 5]) -> [S; 14] {
        let [phi_1, phi_2, phi_3, phi_4, phi_5] = *q;
        let (
            [sin_phi_1,
            sin_phi_2,
            sin_phi_3,
            sin_phi_4,
            sin_phi_5,
            ],
            [cos_phi_1,
            cos_phi_2,
            cos_phi_3,
            cos_phi_4,
            cos_phi_5,
            ],
        ) = S::sin_cos_each([phi_1, phi_2, phi_3, phi_4, phi_5]);
        let u1_x = self.l * sin_phi_1;
        let minus_u1_y = self.l * cos_phi_1;
        let u2_x = self.l * sin_phi_2;
        let w = self.l * cos_phi_2;
        let u3_x = self.l * sin_phi_3;
        let w_2 = self.l * cos_phi_3;
        let u4_x = self.l * sin_phi_4;
        let w_3 = self.l * cos_phi_4;
        [
            S::from_f64(0.0),
            S::from_f64(0.0),
            S::from_f64(0.0),
            S::from_f64(0.0),
            u1_x,
            -minus_u1_y,
            u1_x + u2_x,
            -(minus_u1_y + w),
            u1_x + u2_x + u3_x,
            -(minus_u1_y + w + w_2),
            u1_x + u2_x + u3_x + u4_x,
            -(minus_u1_y + w + w_2 + w_3),
            u1_x + u2_x + u3_x + u4_x + self.l * sin_phi_5,
            -(minus_u1_y + w + w_2 + w_3 + self.l * cos_phi_5),
        ]
    }
    /// Declared start: values or guesses of the coordinates, and speeds; 0 where nothing is declared.
    ///
    /// Operations: none.
    #[inline]
    pub fn initial(&self) -> sim_kernel::Initial<[S; 5]> {
        sim_kernel::Initial {
            positions: [
                S::from_f64(1.0),
                S::from_f64(1.0),
                S::from_f64(1.0),
                S::from_f64(1.0),
                S::from_f64(1.0),
            ],
            speeds: [
                S::from_f64(0.0),
                S::from_f64(0.0),
                S::from_f64(0.0),
                S::from_f64(0.0),
                S::from_f64(0.0),
            ],
        }
    }
}
#[allow(non_snake_case, clippy::all, clippy::pedantic)]
impl<S: sim_kernel::Scalar> sim_kernel::Mechanism<S> for Chain<S> {
    type Q = [S; 5];
    type L = [S; 0];
    type Z = [S; 5];
    type QQ = [[S; 5]; 5];
    type LQ = [[S; 5]; 0];
    type LL = [[S; 0]; 0];
    type ZZ = [[S; 5]; 5];
    type Parameters = [S; 3];
    type Outputs = [S; 2];
    type OutputRates = [S; 2];
    type Events = [S; 0];
    type Drawing = [S; 14];
    const DESCRIPTION: sim_kernel::Description = sim_kernel::Description {
        name: "chain",
        type_name: "Chain",
        docs: "Five uniform rods, each hanging on the one before, by their angles from the vertical.",
        declaration: "/// Five uniform rods, each hanging on the one before, by their angles from the vertical.\npub Chain;\n\ncoordinates { phi_1 [rad]; phi_2 [rad]; phi_3 [rad]; phi_4 [rad]; phi_5 [rad]; }\n\nparameters {\n    /// Mass of a rod.\n    m [kg] = 1;\n    /// Length of a rod.\n    l [m] = 0.5;\n    /// Acceleration of free fall.\n    g [m/s^2] = 9.81;\n}\n\nlet J = m*l^2/12;\nlet u1 = l*[sin(phi_1), -cos(phi_1)];\nlet u2 = l*[sin(phi_2), -cos(phi_2)];\nlet u3 = l*[sin(phi_3), -cos(phi_3)];\nlet u4 = l*[sin(phi_4), -cos(phi_4)];\nlet u5 = l*[sin(phi_5), -cos(phi_5)];\nlet P1 = u1;\nlet P2 = P1 + u2;\nlet P3 = P2 + u3;\nlet P4 = P3 + u4;\nlet P5 = P4 + u5;\n\nbodies {\n    rod1: mass m at u1/2, inertia J, angle phi_1;\n    rod2: mass m at P1 + u2/2, inertia J, angle phi_2;\n    rod3: mass m at P2 + u3/2, inertia J, angle phi_3;\n    rod4: mass m at P3 + u4/2, inertia J, angle phi_4;\n    rod5: mass m at P4 + u5/2, inertia J, angle phi_5;\n}\n\nloads { gravity [0, -g]; }\ninitial { phi_1 = 1; phi_2 = 1; phi_3 = 1; phi_4 = 1; phi_5 = 1; }\noutputs {\n    /// End of the chain.\n    tip_x [m] = P5.x;\n    tip_y [m] = P5.y;\n}\ndrawing { ground [0, 0]; line [0, 0], P1, P2, P3, P4, P5; }\n",
        coordinates: &[
            sim_kernel::Coordinate {
                position: sim_kernel::Quantity {
                    name: "phi_1",
                    unit: "rad",
                    factor: 1f64,
                    docs: "",
                },
                speed: sim_kernel::Quantity {
                    name: "phi_1_dot",
                    unit: "rad/s",
                    factor: 1f64,
                    docs: "",
                },
                acceleration: sim_kernel::Quantity {
                    name: "phi_1_ddot",
                    unit: "rad/s^2",
                    factor: 1f64,
                    docs: "",
                },
                start: sim_kernel::Start::Given,
                speed_given: false,
            },
            sim_kernel::Coordinate {
                position: sim_kernel::Quantity {
                    name: "phi_2",
                    unit: "rad",
                    factor: 1f64,
                    docs: "",
                },
                speed: sim_kernel::Quantity {
                    name: "phi_2_dot",
                    unit: "rad/s",
                    factor: 1f64,
                    docs: "",
                },
                acceleration: sim_kernel::Quantity {
                    name: "phi_2_ddot",
                    unit: "rad/s^2",
                    factor: 1f64,
                    docs: "",
                },
                start: sim_kernel::Start::Given,
                speed_given: false,
            },
            sim_kernel::Coordinate {
                position: sim_kernel::Quantity {
                    name: "phi_3",
                    unit: "rad",
                    factor: 1f64,
                    docs: "",
                },
                speed: sim_kernel::Quantity {
                    name: "phi_3_dot",
                    unit: "rad/s",
                    factor: 1f64,
                    docs: "",
                },
                acceleration: sim_kernel::Quantity {
                    name: "phi_3_ddot",
                    unit: "rad/s^2",
                    factor: 1f64,
                    docs: "",
                },
                start: sim_kernel::Start::Given,
                speed_given: false,
            },
            sim_kernel::Coordinate {
                position: sim_kernel::Quantity {
                    name: "phi_4",
                    unit: "rad",
                    factor: 1f64,
                    docs: "",
                },
                speed: sim_kernel::Quantity {
                    name: "phi_4_dot",
                    unit: "rad/s",
                    factor: 1f64,
                    docs: "",
                },
                acceleration: sim_kernel::Quantity {
                    name: "phi_4_ddot",
                    unit: "rad/s^2",
                    factor: 1f64,
                    docs: "",
                },
                start: sim_kernel::Start::Given,
                speed_given: false,
            },
            sim_kernel::Coordinate {
                position: sim_kernel::Quantity {
                    name: "phi_5",
                    unit: "rad",
                    factor: 1f64,
                    docs: "",
                },
                speed: sim_kernel::Quantity {
                    name: "phi_5_dot",
                    unit: "rad/s",
                    factor: 1f64,
                    docs: "",
                },
                acceleration: sim_kernel::Quantity {
                    name: "phi_5_ddot",
                    unit: "rad/s^2",
                    factor: 1f64,
                    docs: "",
                },
                start: sim_kernel::Start::Given,
                speed_given: false,
            },
        ],
        parameters: &[
            sim_kernel::Quantity {
                name: "m",
                unit: "kg",
                factor: 1f64,
                docs: "Mass of a rod.",
            },
            sim_kernel::Quantity {
                name: "l",
                unit: "m",
                factor: 1f64,
                docs: "Length of a rod.",
            },
            sim_kernel::Quantity {
                name: "g",
                unit: "m/s^2",
                factor: 1f64,
                docs: "Acceleration of free fall.",
            },
        ],
        constraints: &[],
        events: &[],
        outputs: &[
            sim_kernel::Quantity {
                name: "tip_x",
                unit: "m",
                factor: 1f64,
                docs: "End of the chain.",
            },
            sim_kernel::Quantity {
                name: "tip_y",
                unit: "m",
                factor: 1f64,
                docs: "",
            },
        ],
        rated_outputs: &[0, 1],
        figures: &[
            sim_kernel::Figure {
                name: "tip_x",
                title: "End of the chain",
                len: 1,
            },
            sim_kernel::Figure {
                name: "tip_y",
                title: "tip y",
                len: 1,
            },
        ],
        drawing: &[sim_kernel::Shape::Ground(1), sim_kernel::Shape::Line(6)],
    };
    fn defaults() -> Self {
        Self {
            m: S::from_f64(1f64),
            l: S::from_f64(0.5f64),
            g: S::from_f64(9.81f64),
        }
    }
    fn parameters(&self) -> [S; 3] {
        [self.m, self.l, self.g]
    }
    fn with_parameters(parameters: [S; 3]) -> Self {
        Self {
            m: parameters[0],
            l: parameters[1],
            g: parameters[2],
        }
    }
    #[inline(always)]
    fn dynamics(
        &self,
        t: S,
        q: &[S; 5],
        qd: &[S; 5],
    ) -> sim_kernel::Dynamics<S, [S; 5], [S; 0]> {
        self.dynamics(t, q, qd)
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
    fn constraints(&self, t: S, q: &[S; 5]) -> [S; 0] {
        self.constraints(t, q)
    }
    #[inline(always)]
    fn constraint_magnitudes(&self, t: S, q: &[S; 5]) -> [S; 0] {
        self.constraint_magnitudes(t, q)
    }
    #[inline(always)]
    fn constraint_jacobian(&self, t: S, q: &[S; 5]) -> [[S; 5]; 0] {
        self.constraint_jacobian(t, q)
    }
    #[inline(always)]
    fn constraint_time_derivative(&self, t: S, q: &[S; 5]) -> [S; 0] {
        self.constraint_time_derivative(t, q)
    }
    #[inline(always)]
    fn constraint_convective(&self, t: S, q: &[S; 5], qd: &[S; 5]) -> [S; 0] {
        self.constraint_convective(t, q, qd)
    }
    #[inline(always)]
    fn constraint_linearization(
        &self,
        t: S,
        q: &[S; 5],
    ) -> sim_kernel::ConstraintLinearization<[S; 0], [[S; 5]; 0]> {
        self.constraint_linearization(t, q)
    }
    #[inline(always)]
    fn kinetic_energy(&self, t: S, q: &[S; 5], qd: &[S; 5]) -> S {
        self.kinetic_energy(t, q, qd)
    }
    #[inline(always)]
    fn power(&self, t: S, q: &[S; 5], qd: &[S; 5], qdd: &[S; 5], lambda: &[S; 0]) -> S {
        self.power(t, q, qd, qdd, lambda)
    }
    #[inline(always)]
    fn outputs(
        &self,
        t: S,
        q: &[S; 5],
        qd: &[S; 5],
        qdd: &[S; 5],
        lambda: &[S; 0],
    ) -> [S; 2] {
        self.outputs(t, q, qd, qdd, lambda).into()
    }
    #[inline(always)]
    fn output_rates(&self, t: S, q: &[S; 5], qd: &[S; 5], qdd: &[S; 5]) -> [S; 2] {
        self.output_rates(t, q, qd, qdd).into()
    }
    #[inline(always)]
    fn events(&self, t: S, q: &[S; 5], qd: &[S; 5]) -> [S; 0] {
        self.events(t, q, qd)
    }
    #[inline(always)]
    fn drawing(&self, t: S, q: &[S; 5]) -> [S; 14] {
        self.drawing(t, q)
    }
    #[inline(always)]
    fn initial(&self) -> sim_kernel::Initial<[S; 5]> {
        self.initial()
    }
}
