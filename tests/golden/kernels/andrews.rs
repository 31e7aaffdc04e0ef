/// Andrews' squeezing mechanism: seven bodies, three loops; run it for 30 ms (`--t-end 30ms`).
/// A constant torque turns crank 1 against a spring; the motion grows until nothing holds it.
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
///     beta;
///     Theta;
///     gamma;
///     Phi;
///     delta;
///     Omega;
///     epsilon
/// ]
/// multipliers = [
///     lambda_loop3_x;
///     lambda_loop3_y;
///     lambda_loop4_x;
///     lambda_loop4_y;
///     lambda_loop6_x;
///     lambda_loop6_y
/// ]
/// constraints = 0
///
/// mass_matrix = [
///     mass_matrix[1, 1], mass_matrix[1, 2], 0, 0, 0, 0, 0;
///     mass_matrix[1, 2], mass_matrix[2, 2], 0, 0, 0, 0, 0;
///     0, 0, mass_matrix[3, 3], 0, 0, 0, 0;
///     0, 0, 0, mass_matrix[4, 4], mass_matrix[4, 5], 0, 0;
///     0, 0, 0, mass_matrix[4, 5], mass_matrix[5, 5], 0, 0;
///     0, 0, 0, 0, 0, mass_matrix[6, 6], mass_matrix[6, 7];
///     0, 0, 0, 0, 0, mass_matrix[6, 7], mass_matrix[7, 7]
/// ]
/// mass_matrix[1, 1] = i1 + i2 + m2*(F_y - da*u2_y)^2 + m2*(F_x - da*u2_x)^2 + m1*ra^2
/// mass_matrix[1, 2] = i2 - m2*da*u2_y*(F_y - da*u2_y) - m2*da*u2_x*(F_x - da*u2_x)
/// mass_matrix[2, 2] = i2 + m2*da^2
/// mass_matrix[3, 3] = i3 + m3*(sa*u3_x - sb*u3_y)^2 + m3*(sa*u3_y + sb*u3_x)^2
/// mass_matrix[4, 4] = i4 + m4*(ee - ea)^2
/// mass_matrix[4, 5] = i4 + m4*n4_x*s_5*(ee - ea) - m4*s_4*(ee - ea)*cos(Phi + delta)
/// mass_matrix[5, 5] = i4 + i5 + m4*s_4^2 + m4*s_5^2 + m5*(ta*u5_y + tb*u5_x)^2 + m5*(ta*u5_x - tb*u5_y)^2
/// mass_matrix[6, 6] = i6 + m6*(zf - fa)^2
/// mass_matrix[6, 7] = i6 + m6*u6_x*s_8*(zf - fa) - m6*u6_y*s_7*(zf - fa)
/// mass_matrix[7, 7] = i6 + i7 + m6*s_7^2 + m6*s_8^2 + m7*(ua*u7_x + ub*u7_y)^2 + m7*(ua*u7_y - ub*u7_x)^2
///
/// convective_forces = [
///     convective_forces[1];
///     convective_forces[2];
///     convective_forces[3];
///     convective_forces[4];
///     convective_forces[5];
///     convective_forces[6];
///     convective_forces[7]
/// ]
/// convective_forces[1] = -m2*s_3*(F_y - da*u2_y) - m2*s_9*(F_x - da*u2_x)
/// convective_forces[2] = m2*da*u2_y*s_3 + m2*da*u2_x*s_9
/// convective_forces[3] = m3*gamma_dot*(sa*u3_y + sb*u3_x)*(sa*u3_x*gamma_dot - sb*u3_y*gamma_dot)
///     - m3*gamma_dot*(sa*u3_x - sb*u3_y)*(sa*u3_y*gamma_dot + sb*u3_x*gamma_dot)
/// convective_forces[4] = m4*n4_x*s_6*(ee - ea) - m4*s_10*(ee - ea)*cos(Phi + delta)
/// convective_forces[5] = m4*s_4*s_10 + m4*s_5*s_6
///     + m5*delta_dot*(ta*u5_y + tb*u5_x)*(ta*u5_x*delta_dot - tb*u5_y*delta_dot)
///     - m5*delta_dot*(ta*u5_x - tb*u5_y)*(ta*u5_y*delta_dot + tb*u5_x*delta_dot)
/// convective_forces[6] = m6*u6_y*s_11*(zf - fa) - m6*u6_x*s_12*(zf - fa)
/// convective_forces[7] = m7*epsilon_dot*(ua*u7_y - ub*u7_x)*(ua*u7_x*epsilon_dot + ub*u7_y*epsilon_dot)
///     - m6*s_7*s_11 - m6*s_8*s_12
///     - m7*epsilon_dot*(ua*u7_x + ub*u7_y)*(ua*u7_y*epsilon_dot - ub*u7_x*epsilon_dot)
///
/// generalized_forces = [mom; 0; generalized_forces[3]; 0; 0; 0; 0]
/// generalized_forces[3] = c0*s_1*(l0 - sqrt(s_1^2 + s_2^2))*(sc*u3_x - sd*u3_y)/sqrt(s_1^2 + s_2^2)
///     + c0*s_2*(l0 - sqrt(s_1^2 + s_2^2))*(sc*u3_y + sd*u3_x)/sqrt(s_1^2 + s_2^2)
///
/// constraints = [
///     F_x - xb - d*u2_x - ss*u3_y;
///     F_y - yb - d*u2_y + ss*u3_x;
///     constraints[3];
///     constraints[4];
///     constraints[5];
///     constraints[6]
/// ]
/// constraints[3] = F_x - xa - d*u2_x - zt*u5_x - ee*n4_x
/// constraints[4] = F_y - ya - d*u2_y - zt*u5_y + ee*cos(Phi + delta)
/// constraints[5] = F_x - xa - d*u2_x - u*u7_y - zf*u6_x
/// constraints[6] = F_y - ya - d*u2_y + u*u7_x - zf*u6_y
///
/// constraint_jacobian = [
///     constraint_jacobian[1, 1], d*u2_y, -ss*u3_x, 0, 0, 0, 0;
///     P_x, -d*u2_x, -ss*u3_y, 0, 0, 0, 0;
///     constraint_jacobian[1, 1], d*u2_y, 0, constraint_jacobian[3, 4], constraint_jacobian[3, 5], 0, 0;
///     P_x, -d*u2_x, 0, -ee*n4_x, constraint_jacobian[4, 5], 0, 0;
///     constraint_jacobian[1, 1], d*u2_y, 0, 0, 0, zf*u6_y, constraint_jacobian[5, 7];
///     P_x, -d*u2_x, 0, 0, 0, -zf*u6_x, constraint_jacobian[6, 7]
/// ]
/// constraint_jacobian[1, 1] = d*u2_y - F_y
/// constraint_jacobian[3, 4] = -ee*cos(Phi + delta)
/// constraint_jacobian[3, 5] = zt*u5_y - ee*cos(Phi + delta)
/// constraint_jacobian[4, 5] = -zt*u5_x - ee*n4_x
/// constraint_jacobian[5, 7] = zf*u6_y - u*u7_x
/// constraint_jacobian[6, 7] = -u*u7_y - zf*u6_x
///
/// constraint_convective = [
///     constraint_convective[1];
///     constraint_convective[2];
///     constraint_convective[3];
///     constraint_convective[4];
///     constraint_convective[5];
///     constraint_convective[6]
/// ]
/// constraint_convective[1] = d*u2_x*Theta_dot*(beta_dot + Theta_dot) - s_13 + ss*u3_y*gamma_dot^2
/// constraint_convective[2] = d*u2_y*Theta_dot*(beta_dot + Theta_dot) - s_14 - ss*u3_x*gamma_dot^2
/// constraint_convective[3] = d*u2_x*Theta_dot*(beta_dot + Theta_dot) - s_13
///     + delta_dot*(zt*u5_x*delta_dot + ee*n4_x*(Phi_dot + delta_dot))
///     + ee*n4_x*Phi_dot*(Phi_dot + delta_dot)
/// constraint_convective[4] = d*u2_y*Theta_dot*(beta_dot + Theta_dot) - s_14
///     - ee*Phi_dot*(Phi_dot + delta_dot)*cos(Phi + delta)
///     + delta_dot*(zt*u5_y*delta_dot - ee*(Phi_dot + delta_dot)*cos(Phi + delta))
/// constraint_convective[5] = d*u2_x*Theta_dot*(beta_dot + Theta_dot) - s_13
///     + zf*u6_x*Omega_dot*(Omega_dot + epsilon_dot)
///     + epsilon_dot*(u*u7_y*epsilon_dot + zf*u6_x*(Omega_dot + epsilon_dot))
/// constraint_convective[6] = d*u2_y*Theta_dot*(beta_dot + Theta_dot) - s_14
///     + zf*u6_y*Omega_dot*(Omega_dot + epsilon_dot)
///     - epsilon_dot*(u*u7_x*epsilon_dot - zf*u6_y*(Omega_dot + epsilon_dot))
///
/// u1_x = cos(beta)
/// u1_y = sin(beta)
/// u2_x = cos(beta + Theta)
/// u2_y = sin(beta + Theta)
/// u3_x = cos(gamma)
/// u3_y = sin(gamma)
/// n4_x = sin(Phi + delta)
/// u5_x = cos(delta)
/// u5_y = sin(delta)
/// u6_x = cos(Omega + epsilon)
/// u6_y = sin(Omega + epsilon)
/// u7_x = cos(epsilon)
/// u7_y = sin(epsilon)
/// F_x = rr*u1_x
/// F_y = rr*u1_y
/// P_x = F_x - d*u2_x
/// s_1 = xb - xc + sc*u3_y + sd*u3_x
/// s_2 = yb - yc - sc*u3_x + sd*u3_y
/// s_3 = da*u2_x*Theta_dot*(beta_dot + Theta_dot)
///     - beta_dot*(rr*u1_x*beta_dot - da*u2_x*(beta_dot + Theta_dot))
/// s_4 = zt*u5_y - (ee - ea)*cos(Phi + delta)
/// s_5 = zt*u5_x + n4_x*(ee - ea)
/// s_6 = Phi_dot*(ee - ea)*(Phi_dot + delta_dot)*cos(Phi + delta)
///     - delta_dot*(zt*u5_y*delta_dot - (ee - ea)*(Phi_dot + delta_dot)*cos(Phi + delta))
/// s_7 = u*u7_x - u6_y*(zf - fa)
/// s_8 = u*u7_y + u6_x*(zf - fa)
/// s_9 = beta_dot*(rr*u1_y*beta_dot - da*u2_y*(beta_dot + Theta_dot))
///     - da*u2_y*Theta_dot*(beta_dot + Theta_dot)
/// s_10 = n4_x*Phi_dot*(ee - ea)*(Phi_dot + delta_dot)
///     + delta_dot*(zt*u5_x*delta_dot + n4_x*(ee - ea)*(Phi_dot + delta_dot))
/// s_11 = epsilon_dot*(u*u7_y*epsilon_dot + u6_x*(zf - fa)*(Omega_dot + epsilon_dot))
///     + u6_x*Omega_dot*(zf - fa)*(Omega_dot + epsilon_dot)
/// s_12 = u6_y*Omega_dot*(zf - fa)*(Omega_dot + epsilon_dot)
///     - epsilon_dot*(u*u7_x*epsilon_dot - u6_y*(zf - fa)*(Omega_dot + epsilon_dot))
/// s_13 = beta_dot*(rr*u1_x*beta_dot - d*u2_x*(beta_dot + Theta_dot))
/// s_14 = beta_dot*(rr*u1_y*beta_dot - d*u2_y*(beta_dot + Theta_dot))
/// ```
#[allow(non_snake_case)]
#[derive(
    ::core::clone::Clone,
    ::core::marker::Copy,
    ::core::fmt::Debug,
    ::core::cmp::PartialEq
)]
pub struct Andrews<S = ::core::primitive::f64> {
    /// In `kg`.
    pub m1: S,
    /// In `kg`.
    pub m2: S,
    /// In `kg`.
    pub m3: S,
    /// In `kg`.
    pub m4: S,
    /// In `kg`.
    pub m5: S,
    /// In `kg`.
    pub m6: S,
    /// In `kg`.
    pub m7: S,
    /// In `kg*m^2`.
    pub i1: S,
    /// In `kg*m^2`.
    pub i2: S,
    /// In `kg*m^2`.
    pub i3: S,
    /// In `kg*m^2`.
    pub i4: S,
    /// In `kg*m^2`.
    pub i5: S,
    /// In `kg*m^2`.
    pub i6: S,
    /// In `kg*m^2`.
    pub i7: S,
    /// In `m`.
    pub xa: S,
    /// In `m`.
    pub ya: S,
    /// In `m`.
    pub xb: S,
    /// In `m`.
    pub yb: S,
    /// In `m`.
    pub xc: S,
    /// In `m`.
    pub yc: S,
    /// Stiffness of the spring, in `N/m`.
    pub c0: S,
    /// Free length of the spring, in `m`.
    pub l0: S,
    /// Torque on crank 1, in `N*m`.
    pub mom: S,
    /// In `m`.
    pub d: S,
    /// In `m`.
    pub da: S,
    /// In `m`.
    pub ee: S,
    /// In `m`.
    pub ea: S,
    /// In `m`.
    pub rr: S,
    /// In `m`.
    pub ra: S,
    /// In `m`.
    pub ss: S,
    /// In `m`.
    pub sa: S,
    /// In `m`.
    pub sb: S,
    /// In `m`.
    pub sc: S,
    /// In `m`.
    pub sd: S,
    /// In `m`.
    pub ta: S,
    /// In `m`.
    pub tb: S,
    /// In `m`.
    pub u: S,
    /// In `m`.
    pub ua: S,
    /// In `m`.
    pub ub: S,
    /// In `m`.
    pub zf: S,
    /// In `m`.
    pub zt: S,
    /// In `m`.
    pub fa: S,
}
impl<S: sim_kernel::Scalar> ::core::default::Default for Andrews<S> {
    /// The declared values.
    fn default() -> Self {
        <Self as sim_kernel::Mechanism<S>>::defaults()
    }
}
/// Coordinates of [`Andrews`] by name, in SI units; also for their speeds and accelerations.
#[allow(non_snake_case)]
#[derive(
    ::core::clone::Clone,
    ::core::marker::Copy,
    ::core::fmt::Debug,
    ::core::cmp::PartialEq
)]
pub struct AndrewsCoordinates<S = ::core::primitive::f64> {
    /// In `rad`.
    pub beta: S,
    /// In `rad`.
    pub Theta: S,
    /// In `rad`.
    pub gamma: S,
    /// In `rad`.
    pub Phi: S,
    /// In `rad`.
    pub delta: S,
    /// In `rad`.
    pub Omega: S,
    /// In `rad`.
    pub epsilon: S,
}
impl<S: sim_kernel::Scalar> ::core::convert::From<[S; 7]> for AndrewsCoordinates<S> {
    fn from(values: [S; 7]) -> Self {
        Self {
            beta: values[0],
            Theta: values[1],
            gamma: values[2],
            Phi: values[3],
            delta: values[4],
            Omega: values[5],
            epsilon: values[6],
        }
    }
}
impl<S: sim_kernel::Scalar> ::core::convert::From<AndrewsCoordinates<S>> for [S; 7] {
    fn from(record: AndrewsCoordinates<S>) -> Self {
        [
            record.beta,
            record.Theta,
            record.gamma,
            record.Phi,
            record.delta,
            record.Omega,
            record.epsilon,
        ]
    }
}
/// Outputs of [`Andrews`] by name, in SI units.
#[allow(non_snake_case)]
#[derive(
    ::core::clone::Clone,
    ::core::marker::Copy,
    ::core::fmt::Debug,
    ::core::cmp::PartialEq
)]
pub struct AndrewsOutputs<S = ::core::primitive::f64> {
    /// angle of the crank, in `rad`.
    pub crank_angle: S,
    /// plate 3, in `rad`.
    pub plate3_angle: S,
    /// bar 4, in `rad`.
    pub bar4_angle: S,
    /// plate 5, in `rad`.
    pub plate5_angle: S,
    /// bar 6, in `rad`.
    pub bar6_angle: S,
    /// plate 7, in `rad`.
    pub plate7_angle: S,
    /// force of the spring, in `N`.
    pub pull: S,
    /// Joint force in P on plate 3, in `N`.
    pub joint_force: S,
}
impl<S: sim_kernel::Scalar> ::core::convert::From<[S; 8]> for AndrewsOutputs<S> {
    fn from(values: [S; 8]) -> Self {
        Self {
            crank_angle: values[0],
            plate3_angle: values[1],
            bar4_angle: values[2],
            plate5_angle: values[3],
            bar6_angle: values[4],
            plate7_angle: values[5],
            pull: values[6],
            joint_force: values[7],
        }
    }
}
impl<S: sim_kernel::Scalar> ::core::convert::From<AndrewsOutputs<S>> for [S; 8] {
    fn from(record: AndrewsOutputs<S>) -> Self {
        [
            record.crank_angle,
            record.plate3_angle,
            record.bar4_angle,
            record.plate5_angle,
            record.bar6_angle,
            record.plate7_angle,
            record.pull,
            record.joint_force,
        ]
    }
}
/// Rates of the outputs of [`Andrews`] by name, in SI units.
#[allow(non_snake_case)]
#[derive(
    ::core::clone::Clone,
    ::core::marker::Copy,
    ::core::fmt::Debug,
    ::core::cmp::PartialEq
)]
pub struct AndrewsOutputRates<S = ::core::primitive::f64> {
    /// Rate of `crank_angle`.
    pub crank_angle: S,
    /// Rate of `plate3_angle`.
    pub plate3_angle: S,
    /// Rate of `bar4_angle`.
    pub bar4_angle: S,
    /// Rate of `plate5_angle`.
    pub plate5_angle: S,
    /// Rate of `bar6_angle`.
    pub bar6_angle: S,
    /// Rate of `plate7_angle`.
    pub plate7_angle: S,
    /// Rate of `pull`.
    pub pull: S,
}
impl<S: sim_kernel::Scalar> ::core::convert::From<[S; 7]> for AndrewsOutputRates<S> {
    fn from(values: [S; 7]) -> Self {
        Self {
            crank_angle: values[0],
            plate3_angle: values[1],
            bar4_angle: values[2],
            plate5_angle: values[3],
            bar6_angle: values[4],
            plate7_angle: values[5],
            pull: values[6],
        }
    }
}
impl<S: sim_kernel::Scalar> ::core::convert::From<AndrewsOutputRates<S>> for [S; 7] {
    fn from(record: AndrewsOutputRates<S>) -> Self {
        [
            record.crank_angle,
            record.plate3_angle,
            record.bar4_angle,
            record.plate5_angle,
            record.bar6_angle,
            record.plate7_angle,
            record.pull,
        ]
    }
}
#[allow(non_snake_case, unused_variables, unused_parens, clippy::all, clippy::pedantic)]
impl<S: sim_kernel::Scalar> Andrews<S> {
    /// Accelerations (7), multipliers (6) and power, from
    ///
    /// ```text
    /// [ T_q' M T_q   C_q' ] [ q''    ]   [ T_q' (F - M g)                      ]
    /// [ C_q          0    ] [ lambda ] = [ -(C_q q' + C_t)_q q' - (..)_t       ]
    /// ```
    ///
    /// by an elimination planned from the structure of the system. Where `refused` is set a pivot was too small and nothing else holds: solve that state from the other kernels.
    ///
    /// Operations: 341 additions, 426 multiplications, 17 divisions, 7 sine-cosine pairs, 1 square roots.
    #[inline]
    pub fn dynamics(
        &self,
        t: S,
        q: &[S; 7],
        qd: &[S; 7],
    ) -> sim_kernel::Dynamics<S, [S; 7], [S; 6]> {
        let [beta, Theta_, gamma, Phi_, delta, Omega_, epsilon] = *q;
        let [beta_dot, Theta_dot, gamma_dot, Phi_dot, delta_dot, Omega_dot, epsilon_dot,
        ] = *qd;
        let w = beta + Theta_;
        let w_2 = Phi_ + delta;
        let w_3 = Omega_ + epsilon;
        let (
            [u1_y,
            u2_y,
            u3_y,
            n4_x,
            u5_y,
            u6_y,
            u7_y,
            ],
            [u1_x,
            u2_x,
            u3_x,
            cos_w_2,
            u5_x,
            u6_x,
            u7_x,
            ],
        ) = S::sin_cos_each([beta, w, gamma, w_2, delta, w_3, epsilon]);
        let F_y = self.rr * u1_y;
        let w_4 = F_y - self.da * u2_y;
        let F_x = self.rr * u1_x;
        let w_5 = F_x - self.da * u2_x;
        let mass_beta_beta = self.i1 + self.i2 + self.m2 * w_4 * w_4
            + self.m2 * w_5 * w_5 + self.m1 * self.ra * self.ra;
        let mass_Theta_beta = self.i2 - self.m2 * self.da * u2_y * w_4
            - self.m2 * self.da * u2_x * w_5;
        let mass_Theta_Theta = self.i2 + self.m2 * self.da * self.da;
        let w_6 = self.sa * u3_x - self.sb * u3_y;
        let w_7 = self.sa * u3_y + self.sb * u3_x;
        let mass_gamma_gamma = self.i3 + self.m3 * w_6 * w_6 + self.m3 * w_7 * w_7;
        let w_8 = self.ee - self.ea;
        let mass_Phi_Phi = self.i4 + self.m4 * w_8 * w_8;
        let w_9 = self.zt * u5_x;
        let w_10 = w_9 + n4_x * w_8;
        let w_11 = self.zt * u5_y;
        let w_12 = w_11 - cos_w_2 * w_8;
        let mass_delta_Phi = self.i4 + self.m4 * n4_x * w_8 * w_10
            - self.m4 * cos_w_2 * w_8 * w_12;
        let w_13 = self.ta * u5_y + self.tb * u5_x;
        let w_14 = self.ta * u5_x - self.tb * u5_y;
        let mass_delta_delta = self.i4 + self.i5 + self.m4 * w_12 * w_12
            + self.m4 * w_10 * w_10 + self.m5 * w_13 * w_13 + self.m5 * w_14 * w_14;
        let w_15 = self.zf - self.fa;
        let mass_Omega_Omega = self.i6 + self.m6 * w_15 * w_15;
        let w_16 = self.u * u7_y;
        let w_17 = w_16 + u6_x * w_15;
        let w_18 = self.u * u7_x;
        let w_19 = w_18 - u6_y * w_15;
        let mass_epsilon_Omega = self.i6 + self.m6 * u6_x * w_15 * w_17
            - self.m6 * u6_y * w_15 * w_19;
        let w_20 = self.ua * u7_x + self.ub * u7_y;
        let w_21 = self.ua * u7_y - self.ub * u7_x;
        let mass_epsilon_epsilon = self.i6 + self.i7 + self.m6 * w_19 * w_19
            + self.m6 * w_17 * w_17 + self.m7 * w_20 * w_20 + self.m7 * w_21 * w_21;
        let loop3_x_by_Theta = self.d * u2_y;
        let loop3_x_by_beta = loop3_x_by_Theta - F_y;
        let minus_loop3_x_by_gamma = self.ss * u3_x;
        let minus_loop3_y_by_Theta = self.d * u2_x;
        let P_x = F_x - minus_loop3_y_by_Theta;
        let minus_loop3_y_by_gamma = self.ss * u3_y;
        let minus_loop4_x_by_Phi = self.ee * cos_w_2;
        let minus_loop4_y_by_Phi = self.ee * n4_x;
        let loop6_x_by_Omega = self.zf * u6_y;
        let minus_loop6_y_by_Omega = self.zf * u6_x;
        let w_22 = beta_dot + Theta_dot;
        let w_23 = beta_dot * self.rr * u1_x;
        let w_24 = Theta_dot * self.da * u2_x * w_22
            - beta_dot * (w_23 - self.da * u2_x * w_22);
        let w_25 = beta_dot * self.rr * u1_y;
        let w_26 = beta_dot * (w_25 - self.da * u2_y * w_22)
            - Theta_dot * self.da * u2_y * w_22;
        let rhs_beta = self.mom + self.m2 * w_4 * w_24 + self.m2 * w_5 * w_26;
        let w_27 = gamma_dot * self.m3 * w_7
            * (gamma_dot * self.sa * u3_x - gamma_dot * self.sb * u3_y);
        let w_28 = gamma_dot * self.m3 * w_6
            * (gamma_dot * self.sa * u3_y + gamma_dot * self.sb * u3_x);
        let w_29 = self.sc * u3_y;
        let w_30 = self.sd * u3_x;
        let w_31 = self.xb - self.xc + w_29 + w_30;
        let w_32 = self.sc * u3_x;
        let w_33 = self.sd * u3_y;
        let w_34 = self.yb - self.yc - w_32 + w_33;
        let w_35 = (w_31 * w_31 + w_34 * w_34).sqrt();
        let w_36 = self.l0 - w_35;
        let w_37 = w_32 - w_33;
        let w_38 = w_29 + w_30;
        let rhs_gamma = w_28 - w_27 + self.c0 * w_31 * w_36 * w_37 / w_35
            + self.c0 * w_34 * w_36 * w_38 / w_35;
        let w_39 = Phi_dot + delta_dot;
        let w_40 = delta_dot * self.zt * u5_y;
        let w_41 = Phi_dot * cos_w_2 * w_8 * w_39
            - delta_dot * (w_40 - cos_w_2 * w_8 * w_39);
        let w_42 = delta_dot * self.zt * u5_x;
        let w_43 = Phi_dot * n4_x * w_8 * w_39 + delta_dot * (w_42 + n4_x * w_8 * w_39);
        let rhs_Phi = self.m4 * cos_w_2 * w_8 * w_43 - self.m4 * n4_x * w_8 * w_41;
        let w_44 = delta_dot * self.m5 * w_13
            * (delta_dot * self.ta * u5_x - delta_dot * self.tb * u5_y);
        let w_45 = delta_dot * self.m5 * w_14
            * (delta_dot * self.ta * u5_y + delta_dot * self.tb * u5_x)
            - self.m4 * w_12 * w_43 - self.m4 * w_10 * w_41 - w_44;
        let w_46 = epsilon_dot * self.u * u7_y;
        let w_47 = Omega_dot + epsilon_dot;
        let w_48 = epsilon_dot * (w_46 + u6_x * w_15 * w_47)
            + Omega_dot * u6_x * w_15 * w_47;
        let w_49 = epsilon_dot * self.u * u7_x;
        let w_50 = Omega_dot * u6_y * w_15 * w_47
            - epsilon_dot * (w_49 - u6_y * w_15 * w_47);
        let rhs_Omega = self.m6 * u6_x * w_15 * w_50 - self.m6 * u6_y * w_15 * w_48;
        let w_51 = epsilon_dot * self.m7 * w_20
            * (epsilon_dot * self.ua * u7_y - epsilon_dot * self.ub * u7_x);
        let w_52 = self.m6 * w_19 * w_48
            - epsilon_dot * self.m7 * w_21
                * (epsilon_dot * self.ua * u7_x + epsilon_dot * self.ub * u7_y)
            + self.m6 * w_17 * w_50 + w_51;
        let w_53 = Theta_dot * self.d * u2_x * w_22;
        let w_54 = beta_dot * (w_23 - self.d * u2_x * w_22);
        let gamma_dot_squared = gamma_dot * gamma_dot;
        let w_55 = beta_dot * (w_25 - self.d * u2_y * w_22);
        let w_56 = Theta_dot * self.d * u2_y * w_22;
        let w_57 = w_56 - w_55 + Omega_dot * self.zf * u6_y * w_47
            - epsilon_dot * (w_49 - self.zf * u6_y * w_47);
        let inverse_gamma = S::from_f64(1.0) / mass_gamma_gamma;
        let minus_l_lambda_loop3_x_gamma = minus_loop3_x_by_gamma * inverse_gamma;
        let w_58 = minus_l_lambda_loop3_x_gamma * minus_loop3_x_by_gamma;
        let minus_l_lambda_loop3_y_gamma = minus_loop3_y_by_gamma * inverse_gamma;
        let w_59 = minus_l_lambda_loop3_y_gamma * minus_loop3_y_by_gamma;
        let inverse_Phi = S::from_f64(1.0) / mass_Phi_Phi;
        let l_delta_Phi = mass_delta_Phi * inverse_Phi;
        let w_60 = l_delta_Phi * mass_delta_Phi;
        let minus_l_lambda_loop4_x_Phi = minus_loop4_x_by_Phi * inverse_Phi;
        let w_61 = minus_l_lambda_loop4_x_Phi * minus_loop4_x_by_Phi;
        let minus_l_lambda_loop4_y_Phi = minus_loop4_y_by_Phi * inverse_Phi;
        let w_62 = minus_l_lambda_loop4_y_Phi * minus_loop4_y_by_Phi;
        let pivot_delta = mass_delta_delta - w_60;
        let inverse_delta = S::from_f64(1.0) / pivot_delta;
        let rhs_delta = w_45 - l_delta_Phi * rhs_Phi;
        let k_lambda_loop4_x_delta = w_11 - minus_loop4_x_by_Phi
            + minus_l_lambda_loop4_x_Phi * mass_delta_Phi;
        let l_lambda_loop4_x_delta = k_lambda_loop4_x_delta * inverse_delta;
        let w_63 = l_lambda_loop4_x_delta * k_lambda_loop4_x_delta;
        let k_lambda_loop4_y_delta = minus_l_lambda_loop4_y_Phi * mass_delta_Phi
            - (w_9 + minus_loop4_y_by_Phi);
        let l_lambda_loop4_y_delta = k_lambda_loop4_y_delta * inverse_delta;
        let w_64 = l_lambda_loop4_y_delta * k_lambda_loop4_y_delta;
        let inverse_Omega = S::from_f64(1.0) / mass_Omega_Omega;
        let l_epsilon_Omega = mass_epsilon_Omega * inverse_Omega;
        let w_65 = l_epsilon_Omega * mass_epsilon_Omega;
        let l_lambda_loop6_x_Omega = loop6_x_by_Omega * inverse_Omega;
        let w_66 = l_lambda_loop6_x_Omega * loop6_x_by_Omega;
        let minus_l_lambda_loop6_y_Omega = minus_loop6_y_by_Omega * inverse_Omega;
        let w_67 = minus_l_lambda_loop6_y_Omega * minus_loop6_y_by_Omega;
        let pivot_epsilon = mass_epsilon_epsilon - w_65;
        let inverse_epsilon = S::from_f64(1.0) / pivot_epsilon;
        let rhs_epsilon = w_52 - l_epsilon_Omega * rhs_Omega;
        let k_lambda_loop6_x_epsilon = loop6_x_by_Omega - w_18
            - l_lambda_loop6_x_Omega * mass_epsilon_Omega;
        let l_lambda_loop6_x_epsilon = k_lambda_loop6_x_epsilon * inverse_epsilon;
        let w_68 = l_lambda_loop6_x_epsilon * k_lambda_loop6_x_epsilon;
        let k_lambda_loop6_y_epsilon = minus_l_lambda_loop6_y_Omega * mass_epsilon_Omega
            - (w_16 + minus_loop6_y_by_Omega);
        let l_lambda_loop6_y_epsilon = k_lambda_loop6_y_epsilon * inverse_epsilon;
        let w_69 = l_lambda_loop6_y_epsilon * k_lambda_loop6_y_epsilon;
        let inverse_beta = S::from_f64(1.0) / mass_beta_beta;
        let l_Theta_beta = mass_Theta_beta * inverse_beta;
        let w_70 = l_Theta_beta * mass_Theta_beta;
        let l_lambda_loop3_x_beta = loop3_x_by_beta * inverse_beta;
        let w_71 = l_lambda_loop3_x_beta * rhs_beta;
        let w_72 = l_lambda_loop3_x_beta * loop3_x_by_beta;
        let l_lambda_loop3_y_beta = P_x * inverse_beta;
        let w_73 = l_lambda_loop3_y_beta * rhs_beta;
        let w_74 = l_lambda_loop3_y_beta * loop3_x_by_beta;
        let w_75 = l_lambda_loop3_y_beta * P_x;
        let w_76 = l_lambda_loop3_x_beta * P_x;
        let pivot_Theta = mass_Theta_Theta - w_70;
        let inverse_Theta = S::from_f64(1.0) / pivot_Theta;
        let minus_rhs_Theta = self.m2 * self.da * u2_y * w_24
            + self.m2 * self.da * u2_x * w_26 + l_Theta_beta * rhs_beta;
        let k_lambda_loop3_x_Theta = loop3_x_by_Theta
            - l_lambda_loop3_x_beta * mass_Theta_beta;
        let l_lambda_loop3_x_Theta = k_lambda_loop3_x_Theta * inverse_Theta;
        let w_77 = l_lambda_loop3_x_Theta * minus_rhs_Theta;
        let w_78 = l_lambda_loop3_x_Theta * k_lambda_loop3_x_Theta;
        let minus_k_lambda_loop3_y_Theta = minus_loop3_y_by_Theta
            + l_lambda_loop3_y_beta * mass_Theta_beta;
        let minus_l_lambda_loop3_y_Theta = minus_k_lambda_loop3_y_Theta * inverse_Theta;
        let w_79 = minus_l_lambda_loop3_y_Theta * minus_rhs_Theta;
        let w_80 = minus_l_lambda_loop3_y_Theta * k_lambda_loop3_x_Theta;
        let w_81 = minus_l_lambda_loop3_y_Theta * minus_k_lambda_loop3_y_Theta;
        let w_82 = l_lambda_loop3_x_Theta * minus_k_lambda_loop3_y_Theta;
        let minus_pivot_lambda_loop3_x = w_58 + w_72 + w_78;
        let abs_w_72 = w_72.abs();
        let abs_w_78 = w_78.abs();
        let minus_inverse_lambda_loop3_x = S::from_f64(1.0) / minus_pivot_lambda_loop3_x;
        let rhs_lambda_loop3_x = minus_l_lambda_loop3_x_gamma * rhs_gamma
            - (w_53 - w_54 + gamma_dot_squared * self.ss * u3_y) - w_71 + w_77;
        let k_lambda_loop3_y_lambda_loop3_x = w_80
            - minus_l_lambda_loop3_y_gamma * minus_loop3_x_by_gamma - w_74;
        let minus_l_lambda_loop3_y_lambda_loop3_x = k_lambda_loop3_y_lambda_loop3_x
            * minus_inverse_lambda_loop3_x;
        let w_83 = minus_l_lambda_loop3_y_lambda_loop3_x
            * k_lambda_loop3_y_lambda_loop3_x;
        let minus_k_lambda_loop4_x_lambda_loop3_x = w_72 + w_78;
        let l_lambda_loop4_x_lambda_loop3_x = minus_k_lambda_loop4_x_lambda_loop3_x
            * minus_inverse_lambda_loop3_x;
        let w_84 = l_lambda_loop4_x_lambda_loop3_x * rhs_lambda_loop3_x;
        let w_85 = l_lambda_loop4_x_lambda_loop3_x
            * minus_k_lambda_loop4_x_lambda_loop3_x;
        let k_lambda_loop4_y_lambda_loop3_x = w_80 - w_74;
        let minus_l_lambda_loop4_y_lambda_loop3_x = k_lambda_loop4_y_lambda_loop3_x
            * minus_inverse_lambda_loop3_x;
        let w_86 = minus_l_lambda_loop4_y_lambda_loop3_x * rhs_lambda_loop3_x;
        let w_87 = minus_l_lambda_loop4_y_lambda_loop3_x
            * minus_k_lambda_loop4_x_lambda_loop3_x;
        let w_88 = minus_l_lambda_loop4_y_lambda_loop3_x
            * k_lambda_loop4_y_lambda_loop3_x;
        let pivot_lambda_loop3_y = w_83 - w_59 - w_75 - w_81;
        let abs_w_75 = w_75.abs();
        let abs_w_81 = w_81.abs();
        let inverse_lambda_loop3_y = S::from_f64(1.0) / pivot_lambda_loop3_y;
        let rhs_lambda_loop3_y = minus_l_lambda_loop3_y_gamma * rhs_gamma
            - (w_56 - w_55 - gamma_dot_squared * self.ss * u3_x) - w_73 - w_79
            + minus_l_lambda_loop3_y_lambda_loop3_x * rhs_lambda_loop3_x;
        let k_lambda_loop4_x_lambda_loop3_y = w_82 - w_76
            - l_lambda_loop4_x_lambda_loop3_x * k_lambda_loop3_y_lambda_loop3_x;
        let l_lambda_loop4_x_lambda_loop3_y = k_lambda_loop4_x_lambda_loop3_y
            * inverse_lambda_loop3_y;
        let w_89 = l_lambda_loop4_x_lambda_loop3_y * rhs_lambda_loop3_y;
        let w_90 = l_lambda_loop4_x_lambda_loop3_y * k_lambda_loop4_x_lambda_loop3_y;
        let k_lambda_loop4_y_lambda_loop3_y = minus_l_lambda_loop4_y_lambda_loop3_x
            * k_lambda_loop3_y_lambda_loop3_x - w_75 - w_81;
        let l_lambda_loop4_y_lambda_loop3_y = k_lambda_loop4_y_lambda_loop3_y
            * inverse_lambda_loop3_y;
        let w_91 = l_lambda_loop4_y_lambda_loop3_y * rhs_lambda_loop3_y;
        let w_92 = l_lambda_loop4_y_lambda_loop3_y * k_lambda_loop4_x_lambda_loop3_y;
        let w_93 = l_lambda_loop4_y_lambda_loop3_y * k_lambda_loop4_y_lambda_loop3_y;
        let pivot_lambda_loop4_x = w_85 - w_61 - w_63 - w_72 - w_78 - w_90;
        let abs_w_85 = w_85.abs();
        let abs_w_90 = w_90.abs();
        let inverse_lambda_loop4_x = S::from_f64(1.0) / pivot_lambda_loop4_x;
        let rhs_lambda_loop4_x = minus_l_lambda_loop4_x_Phi * rhs_Phi
            - (w_53 - w_54 + delta_dot * (w_42 + self.ee * n4_x * w_39)
                + Phi_dot * self.ee * n4_x * w_39) - l_lambda_loop4_x_delta * rhs_delta
            - w_71 + w_77 - w_84 - w_89;
        let k_lambda_loop4_y_lambda_loop4_x = w_80
            - minus_l_lambda_loop4_y_Phi * minus_loop4_x_by_Phi
            - l_lambda_loop4_y_delta * k_lambda_loop4_x_delta - w_74 - w_87 - w_92;
        let l_lambda_loop4_y_lambda_loop4_x = k_lambda_loop4_y_lambda_loop4_x
            * inverse_lambda_loop4_x;
        let w_94 = l_lambda_loop4_y_lambda_loop4_x * k_lambda_loop4_y_lambda_loop4_x;
        let k_lambda_loop6_x_lambda_loop4_x = w_85 - w_72 - w_78 - w_90;
        let l_lambda_loop6_x_lambda_loop4_x = k_lambda_loop6_x_lambda_loop4_x
            * inverse_lambda_loop4_x;
        let w_95 = l_lambda_loop6_x_lambda_loop4_x * k_lambda_loop6_x_lambda_loop4_x;
        let k_lambda_loop6_y_lambda_loop4_x = w_80 - w_74 - w_87 - w_92;
        let l_lambda_loop6_y_lambda_loop4_x = k_lambda_loop6_y_lambda_loop4_x
            * inverse_lambda_loop4_x;
        let w_96 = l_lambda_loop6_y_lambda_loop4_x * k_lambda_loop6_y_lambda_loop4_x;
        let pivot_lambda_loop4_y = w_88 - w_62 - w_64 - w_75 - w_81 - w_93 - w_94;
        let abs_w_88 = w_88.abs();
        let abs_w_93 = w_93.abs();
        let inverse_lambda_loop4_y = S::from_f64(1.0) / pivot_lambda_loop4_y;
        let rhs_lambda_loop4_y = minus_l_lambda_loop4_y_Phi * rhs_Phi
            - (w_56 - w_55 - Phi_dot * self.ee * cos_w_2 * w_39
                + delta_dot * (w_40 - self.ee * cos_w_2 * w_39))
            - l_lambda_loop4_y_delta * rhs_delta - w_73 - w_79 + w_86 - w_91
            - l_lambda_loop4_y_lambda_loop4_x * rhs_lambda_loop4_x;
        let k_lambda_loop6_x_lambda_loop4_y = w_82 - w_76
            - l_lambda_loop4_x_lambda_loop3_x * k_lambda_loop4_y_lambda_loop3_x
            - l_lambda_loop4_x_lambda_loop3_y * k_lambda_loop4_y_lambda_loop3_y
            - l_lambda_loop6_x_lambda_loop4_x * k_lambda_loop4_y_lambda_loop4_x;
        let l_lambda_loop6_x_lambda_loop4_y = k_lambda_loop6_x_lambda_loop4_y
            * inverse_lambda_loop4_y;
        let w_97 = l_lambda_loop6_x_lambda_loop4_y * k_lambda_loop6_x_lambda_loop4_y;
        let k_lambda_loop6_y_lambda_loop4_y = w_88 - w_75 - w_81 - w_93
            - l_lambda_loop6_y_lambda_loop4_x * k_lambda_loop4_y_lambda_loop4_x;
        let l_lambda_loop6_y_lambda_loop4_y = k_lambda_loop6_y_lambda_loop4_y
            * inverse_lambda_loop4_y;
        let w_98 = l_lambda_loop6_y_lambda_loop4_y * k_lambda_loop6_y_lambda_loop4_y;
        let pivot_lambda_loop6_x = w_85 - w_66 - w_68 - w_72 - w_78 - w_90 - w_95 - w_97;
        let inverse_lambda_loop6_x = S::from_f64(1.0) / pivot_lambda_loop6_x;
        let rhs_lambda_loop6_x = w_77
            - (w_53 - w_54 + Omega_dot * self.zf * u6_x * w_47
                + epsilon_dot * (w_46 + self.zf * u6_x * w_47))
            - l_lambda_loop6_x_Omega * rhs_Omega - l_lambda_loop6_x_epsilon * rhs_epsilon
            - w_71 - w_84 - w_89 - l_lambda_loop6_x_lambda_loop4_x * rhs_lambda_loop4_x
            - l_lambda_loop6_x_lambda_loop4_y * rhs_lambda_loop4_y;
        let k_lambda_loop6_y_lambda_loop6_x = minus_l_lambda_loop6_y_Omega
            * loop6_x_by_Omega - l_lambda_loop6_y_epsilon * k_lambda_loop6_x_epsilon
            - w_74 + w_80 - w_87 - w_92
            - l_lambda_loop6_y_lambda_loop4_x * k_lambda_loop6_x_lambda_loop4_x
            - l_lambda_loop6_y_lambda_loop4_y * k_lambda_loop6_x_lambda_loop4_y;
        let l_lambda_loop6_y_lambda_loop6_x = k_lambda_loop6_y_lambda_loop6_x
            * inverse_lambda_loop6_x;
        let w_99 = l_lambda_loop6_y_lambda_loop6_x * k_lambda_loop6_y_lambda_loop6_x;
        let pivot_lambda_loop6_y = w_88 - w_67 - w_69 - w_75 - w_81 - w_93 - w_96 - w_98
            - w_99;
        let rhs_lambda_loop6_y = minus_l_lambda_loop6_y_Omega * rhs_Omega - w_57
            - l_lambda_loop6_y_epsilon * rhs_epsilon - w_73 - w_79 + w_86 - w_91
            - l_lambda_loop6_y_lambda_loop4_x * rhs_lambda_loop4_x
            - l_lambda_loop6_y_lambda_loop4_y * rhs_lambda_loop4_y
            - l_lambda_loop6_y_lambda_loop6_x * rhs_lambda_loop6_x;
        let lambda_loop6_y = rhs_lambda_loop6_y
            * (S::from_f64(1.0) / pivot_lambda_loop6_y);
        let lambda_loop6_x = rhs_lambda_loop6_x * inverse_lambda_loop6_x
            - l_lambda_loop6_y_lambda_loop6_x * lambda_loop6_y;
        let lambda_loop4_y = rhs_lambda_loop4_y * inverse_lambda_loop4_y
            - l_lambda_loop6_x_lambda_loop4_y * lambda_loop6_x
            - l_lambda_loop6_y_lambda_loop4_y * lambda_loop6_y;
        let lambda_loop4_x = rhs_lambda_loop4_x * inverse_lambda_loop4_x
            - l_lambda_loop4_y_lambda_loop4_x * lambda_loop4_y
            - l_lambda_loop6_x_lambda_loop4_x * lambda_loop6_x
            - l_lambda_loop6_y_lambda_loop4_x * lambda_loop6_y;
        let lambda_loop3_y = rhs_lambda_loop3_y * inverse_lambda_loop3_y
            - l_lambda_loop4_x_lambda_loop3_y * lambda_loop4_x
            - l_lambda_loop4_y_lambda_loop3_y * lambda_loop4_y
            - l_lambda_loop4_x_lambda_loop3_y * lambda_loop6_x
            - l_lambda_loop4_y_lambda_loop3_y * lambda_loop6_y;
        let lambda_loop3_x = minus_l_lambda_loop3_y_lambda_loop3_x * lambda_loop3_y
            - rhs_lambda_loop3_x * minus_inverse_lambda_loop3_x
            - l_lambda_loop4_x_lambda_loop3_x * lambda_loop4_x
            + minus_l_lambda_loop4_y_lambda_loop3_x * lambda_loop4_y
            - l_lambda_loop4_x_lambda_loop3_x * lambda_loop6_x
            + minus_l_lambda_loop4_y_lambda_loop3_x * lambda_loop6_y;
        let Theta_ddot = minus_l_lambda_loop3_y_Theta * lambda_loop3_y
            - minus_rhs_Theta * inverse_Theta - l_lambda_loop3_x_Theta * lambda_loop3_x
            - l_lambda_loop3_x_Theta * lambda_loop4_x
            + minus_l_lambda_loop3_y_Theta * lambda_loop4_y
            - l_lambda_loop3_x_Theta * lambda_loop6_x
            + minus_l_lambda_loop3_y_Theta * lambda_loop6_y;
        let epsilon_ddot = rhs_epsilon * inverse_epsilon
            - l_lambda_loop6_x_epsilon * lambda_loop6_x
            - l_lambda_loop6_y_epsilon * lambda_loop6_y;
        let delta_ddot = rhs_delta * inverse_delta
            - l_lambda_loop4_x_delta * lambda_loop4_x
            - l_lambda_loop4_y_delta * lambda_loop4_y;
        let refused = sim_kernel::pivot_is_refused(
            mass_gamma_gamma,
            mass_gamma_gamma.abs(),
        ) | sim_kernel::pivot_is_refused(mass_Phi_Phi, mass_Phi_Phi.abs())
            | sim_kernel::pivot_is_refused(
                pivot_delta,
                mass_delta_delta.abs() + w_60.abs(),
            ) | sim_kernel::pivot_is_refused(mass_Omega_Omega, mass_Omega_Omega.abs())
            | sim_kernel::pivot_is_refused(
                pivot_epsilon,
                mass_epsilon_epsilon.abs() + w_65.abs(),
            ) | sim_kernel::pivot_is_refused(mass_beta_beta, mass_beta_beta.abs())
            | sim_kernel::pivot_is_refused(
                pivot_Theta,
                mass_Theta_Theta.abs() + w_70.abs(),
            )
            | sim_kernel::pivot_is_refused(
                -minus_pivot_lambda_loop3_x,
                w_58.abs() + abs_w_72 + abs_w_78,
            )
            | sim_kernel::pivot_is_refused(
                pivot_lambda_loop3_y,
                w_59.abs() + abs_w_75 + abs_w_81 + w_83.abs(),
            )
            | sim_kernel::pivot_is_refused(
                pivot_lambda_loop4_x,
                w_61.abs() + w_63.abs() + abs_w_72 + abs_w_78 + abs_w_85 + abs_w_90,
            )
            | sim_kernel::pivot_is_refused(
                pivot_lambda_loop4_y,
                w_62.abs() + w_64.abs() + abs_w_75 + abs_w_81 + abs_w_88 + abs_w_93
                    + w_94.abs(),
            )
            | sim_kernel::pivot_is_refused(
                pivot_lambda_loop6_x,
                w_66.abs() + w_68.abs() + abs_w_72 + abs_w_78 + abs_w_85 + abs_w_90
                    + w_95.abs() + w_97.abs(),
            )
            | sim_kernel::pivot_is_refused(
                pivot_lambda_loop6_y,
                w_67.abs() + w_69.abs() + abs_w_75 + abs_w_81 + abs_w_88 + abs_w_93
                    + w_96.abs() + w_98.abs() + w_99.abs(),
            );
        sim_kernel::Dynamics {
            accelerations: [
                rhs_beta * inverse_beta - l_Theta_beta * Theta_ddot
                    - l_lambda_loop3_x_beta * lambda_loop3_x
                    - l_lambda_loop3_y_beta * lambda_loop3_y
                    - l_lambda_loop3_x_beta * lambda_loop4_x
                    - l_lambda_loop3_y_beta * lambda_loop4_y
                    - l_lambda_loop3_x_beta * lambda_loop6_x
                    - l_lambda_loop3_y_beta * lambda_loop6_y,
                Theta_ddot,
                rhs_gamma * inverse_gamma + minus_l_lambda_loop3_x_gamma * lambda_loop3_x
                    + minus_l_lambda_loop3_y_gamma * lambda_loop3_y,
                rhs_Phi * inverse_Phi - l_delta_Phi * delta_ddot
                    + minus_l_lambda_loop4_x_Phi * lambda_loop4_x
                    + minus_l_lambda_loop4_y_Phi * lambda_loop4_y,
                delta_ddot,
                rhs_Omega * inverse_Omega - l_epsilon_Omega * epsilon_ddot
                    - l_lambda_loop6_x_Omega * lambda_loop6_x
                    + minus_l_lambda_loop6_y_Omega * lambda_loop6_y,
                epsilon_ddot,
            ],
            multipliers: [
                lambda_loop3_x,
                lambda_loop3_y,
                lambda_loop4_x,
                lambda_loop4_y,
                lambda_loop6_x,
                lambda_loop6_y,
            ],
            power: beta_dot * self.mom + gamma_dot * self.c0 * w_31 * w_36 * w_37 / w_35
                + gamma_dot * self.c0 * w_34 * w_36 * w_38 / w_35,
            refused,
        }
    }
    /// Mass matrix `T_q' M T_q`, 7 x 7, symmetric, in SI units.
    ///
    /// Operations: 42 additions, 74 multiplications, 7 sine-cosine pairs.
    #[inline]
    pub fn mass_matrix(&self, t: S, q: &[S; 7]) -> [[S; 7]; 7] {
        let [beta, Theta_, gamma, Phi_, delta, Omega_, epsilon] = *q;
        let w = beta + Theta_;
        let w_2 = Phi_ + delta;
        let w_3 = Omega_ + epsilon;
        let (
            [u1_y,
            u2_y,
            u3_y,
            n4_x,
            u5_y,
            u6_y,
            u7_y,
            ],
            [u1_x,
            u2_x,
            u3_x,
            cos_w_2,
            u5_x,
            u6_x,
            u7_x,
            ],
        ) = S::sin_cos_each([beta, w, gamma, w_2, delta, w_3, epsilon]);
        let w_4 = self.rr * u1_y - self.da * u2_y;
        let w_5 = self.rr * u1_x - self.da * u2_x;
        let mass_Theta_beta = self.i2 - self.m2 * self.da * u2_y * w_4
            - self.m2 * self.da * u2_x * w_5;
        let w_6 = self.sa * u3_x - self.sb * u3_y;
        let w_7 = self.sa * u3_y + self.sb * u3_x;
        let w_8 = self.ee - self.ea;
        let w_9 = self.zt * u5_x + n4_x * w_8;
        let w_10 = self.zt * u5_y - cos_w_2 * w_8;
        let mass_delta_Phi = self.i4 + self.m4 * n4_x * w_8 * w_9
            - self.m4 * cos_w_2 * w_8 * w_10;
        let w_11 = self.ta * u5_y + self.tb * u5_x;
        let w_12 = self.ta * u5_x - self.tb * u5_y;
        let w_13 = self.zf - self.fa;
        let w_14 = self.u * u7_y + u6_x * w_13;
        let w_15 = self.u * u7_x - u6_y * w_13;
        let mass_epsilon_Omega = self.i6 + self.m6 * u6_x * w_13 * w_14
            - self.m6 * u6_y * w_13 * w_15;
        let w_16 = self.ua * u7_x + self.ub * u7_y;
        let w_17 = self.ua * u7_y - self.ub * u7_x;
        [
            [
                self.i1 + self.i2 + self.m2 * w_4 * w_4 + self.m2 * w_5 * w_5
                    + self.m1 * self.ra * self.ra,
                mass_Theta_beta,
                S::from_f64(0.0),
                S::from_f64(0.0),
                S::from_f64(0.0),
                S::from_f64(0.0),
                S::from_f64(0.0),
            ],
            [
                mass_Theta_beta,
                self.i2 + self.m2 * self.da * self.da,
                S::from_f64(0.0),
                S::from_f64(0.0),
                S::from_f64(0.0),
                S::from_f64(0.0),
                S::from_f64(0.0),
            ],
            [
                S::from_f64(0.0),
                S::from_f64(0.0),
                self.i3 + self.m3 * w_6 * w_6 + self.m3 * w_7 * w_7,
                S::from_f64(0.0),
                S::from_f64(0.0),
                S::from_f64(0.0),
                S::from_f64(0.0),
            ],
            [
                S::from_f64(0.0),
                S::from_f64(0.0),
                S::from_f64(0.0),
                self.i4 + self.m4 * w_8 * w_8,
                mass_delta_Phi,
                S::from_f64(0.0),
                S::from_f64(0.0),
            ],
            [
                S::from_f64(0.0),
                S::from_f64(0.0),
                S::from_f64(0.0),
                mass_delta_Phi,
                self.i4 + self.i5 + self.m4 * w_10 * w_10 + self.m4 * w_9 * w_9
                    + self.m5 * w_11 * w_11 + self.m5 * w_12 * w_12,
                S::from_f64(0.0),
                S::from_f64(0.0),
            ],
            [
                S::from_f64(0.0),
                S::from_f64(0.0),
                S::from_f64(0.0),
                S::from_f64(0.0),
                S::from_f64(0.0),
                self.i6 + self.m6 * w_13 * w_13,
                mass_epsilon_Omega,
            ],
            [
                S::from_f64(0.0),
                S::from_f64(0.0),
                S::from_f64(0.0),
                S::from_f64(0.0),
                S::from_f64(0.0),
                mass_epsilon_Omega,
                self.i6 + self.i7 + self.m6 * w_15 * w_15 + self.m6 * w_14 * w_14
                    + self.m7 * w_16 * w_16 + self.m7 * w_17 * w_17,
            ],
        ]
    }
    /// Convective forces `T_q' M g`, 7, with `g = (T_q q' + T_t)_q q' + (..)_t`.
    ///
    /// Operations: 50 additions, 144 multiplications, 7 sine-cosine pairs.
    #[inline]
    pub fn convective_forces(&self, t: S, q: &[S; 7], qd: &[S; 7]) -> [S; 7] {
        let [beta, Theta_, gamma, Phi_, delta, Omega_, epsilon] = *q;
        let [beta_dot, Theta_dot, gamma_dot, Phi_dot, delta_dot, Omega_dot, epsilon_dot,
        ] = *qd;
        let w = beta + Theta_;
        let w_2 = Phi_ + delta;
        let w_3 = Omega_ + epsilon;
        let (
            [u1_y,
            u2_y,
            u3_y,
            n4_x,
            u5_y,
            u6_y,
            u7_y,
            ],
            [u1_x,
            u2_x,
            u3_x,
            cos_w_2,
            u5_x,
            u6_x,
            u7_x,
            ],
        ) = S::sin_cos_each([beta, w, gamma, w_2, delta, w_3, epsilon]);
        let w_4 = beta_dot + Theta_dot;
        let w_5 = Theta_dot * self.da * u2_x * w_4
            - beta_dot * (beta_dot * self.rr * u1_x - self.da * u2_x * w_4);
        let w_6 = beta_dot * (beta_dot * self.rr * u1_y - self.da * u2_y * w_4)
            - Theta_dot * self.da * u2_y * w_4;
        let w_7 = gamma_dot * self.m3 * (self.sa * u3_x - self.sb * u3_y)
            * (gamma_dot * self.sa * u3_y + gamma_dot * self.sb * u3_x);
        let w_8 = self.ee - self.ea;
        let w_9 = Phi_dot + delta_dot;
        let w_10 = Phi_dot * cos_w_2 * w_8 * w_9
            - delta_dot * (delta_dot * self.zt * u5_y - cos_w_2 * w_8 * w_9);
        let w_11 = Phi_dot * n4_x * w_8 * w_9
            + delta_dot * (delta_dot * self.zt * u5_x + n4_x * w_8 * w_9);
        let w_12 = delta_dot * self.m5 * (self.ta * u5_y + self.tb * u5_x)
            * (delta_dot * self.ta * u5_x - delta_dot * self.tb * u5_y);
        let w_13 = delta_dot * self.m5 * (self.ta * u5_x - self.tb * u5_y)
            * (delta_dot * self.ta * u5_y + delta_dot * self.tb * u5_x);
        let w_14 = self.zf - self.fa;
        let w_15 = Omega_dot + epsilon_dot;
        let w_16 = epsilon_dot * (epsilon_dot * self.u * u7_y + u6_x * w_14 * w_15)
            + Omega_dot * u6_x * w_14 * w_15;
        let w_17 = Omega_dot * u6_y * w_14 * w_15
            - epsilon_dot * (epsilon_dot * self.u * u7_x - u6_y * w_14 * w_15);
        let w_18 = epsilon_dot * self.m7 * (self.ua * u7_y - self.ub * u7_x)
            * (epsilon_dot * self.ua * u7_x + epsilon_dot * self.ub * u7_y);
        let w_19 = epsilon_dot * self.m7 * (self.ua * u7_x + self.ub * u7_y)
            * (epsilon_dot * self.ua * u7_y - epsilon_dot * self.ub * u7_x);
        [
            -(self.m2 * (self.rr * u1_y - self.da * u2_y) * w_5
                + self.m2 * (self.rr * u1_x - self.da * u2_x) * w_6),
            self.m2 * self.da * u2_y * w_5 + self.m2 * self.da * u2_x * w_6,
            gamma_dot * self.m3 * (self.sa * u3_y + self.sb * u3_x)
                * (gamma_dot * self.sa * u3_x - gamma_dot * self.sb * u3_y) - w_7,
            self.m4 * n4_x * w_8 * w_10 - self.m4 * cos_w_2 * w_8 * w_11,
            self.m4 * (self.zt * u5_y - cos_w_2 * w_8) * w_11
                + self.m4 * (self.zt * u5_x + n4_x * w_8) * w_10 + w_12 - w_13,
            self.m6 * u6_y * w_14 * w_16 - self.m6 * u6_x * w_14 * w_17,
            w_18 - self.m6 * (self.u * u7_x - u6_y * w_14) * w_16
                - self.m6 * (self.u * u7_y + u6_x * w_14) * w_17 - w_19,
        ]
    }
    /// Generalised forces `T_q' F`, 7: joules per unit of each coordinate.
    ///
    /// Operations: 11 additions, 12 multiplications, 2 divisions, 1 sine-cosine pairs, 1 square roots.
    #[inline]
    pub fn generalized_forces(&self, t: S, q: &[S; 7], qd: &[S; 7]) -> [S; 7] {
        let [_, _, gamma, _, _, _, _] = *q;
        let ([u3_y], [u3_x]) = S::sin_cos_each([gamma]);
        let w = self.sc * u3_y;
        let w_2 = self.sd * u3_x;
        let w_3 = self.xb - self.xc + w + w_2;
        let w_4 = self.sc * u3_x;
        let w_5 = self.sd * u3_y;
        let w_6 = self.yb - self.yc - w_4 + w_5;
        let w_7 = (w_3 * w_3 + w_6 * w_6).sqrt();
        let w_8 = self.l0 - w_7;
        [
            self.mom,
            S::from_f64(0.0),
            self.c0 * w_3 * w_8 * (w_4 - w_5) / w_7
                + self.c0 * w_6 * w_8 * (w + w_2) / w_7,
            S::from_f64(0.0),
            S::from_f64(0.0),
            S::from_f64(0.0),
            S::from_f64(0.0),
        ]
    }
    /// Constraints `C`, 6; zero throughout the motion.
    ///
    /// Operations: 25 additions, 14 multiplications, 7 sine-cosine pairs.
    #[inline]
    pub fn constraints(&self, t: S, q: &[S; 7]) -> [S; 6] {
        let [beta, Theta_, gamma, Phi_, delta, Omega_, epsilon] = *q;
        let w = beta + Theta_;
        let w_2 = Phi_ + delta;
        let w_3 = Omega_ + epsilon;
        let (
            [u1_y,
            u2_y,
            u3_y,
            u5_y,
            n4_x,
            u7_y,
            u6_y,
            ],
            [u1_x,
            u2_x,
            u3_x,
            u5_x,
            cos_w_2,
            u7_x,
            u6_x,
            ],
        ) = S::sin_cos_each([beta, w, gamma, delta, w_2, epsilon, w_3]);
        let F_x = self.rr * u1_x;
        let w_4 = self.d * u2_x;
        let F_y = self.rr * u1_y;
        let loop3_x_by_Theta = self.d * u2_y;
        [
            F_x - self.xb - w_4 - self.ss * u3_y,
            F_y - self.yb - loop3_x_by_Theta + self.ss * u3_x,
            F_x - self.xa - w_4 - self.zt * u5_x - self.ee * n4_x,
            F_y - self.ya - loop3_x_by_Theta - self.zt * u5_y + self.ee * cos_w_2,
            F_x - self.xa - w_4 - self.u * u7_y - self.zf * u6_x,
            F_y - self.ya - loop3_x_by_Theta + self.u * u7_x - self.zf * u6_y,
        ]
    }
    /// The sum of the magnitudes of the terms of `C`, 6: what its rounding is relative to.
    ///
    /// Operations: 43 additions, 14 multiplications, 7 sine-cosine pairs.
    #[inline]
    pub fn constraint_magnitudes(&self, t: S, q: &[S; 7]) -> [S; 6] {
        let [beta, Theta_, gamma, Phi_, delta, Omega_, epsilon] = *q;
        let w = beta + Theta_;
        let w_2 = Phi_ + delta;
        let w_3 = Omega_ + epsilon;
        let (
            [u1_y,
            u2_y,
            u3_y,
            u5_y,
            n4_x,
            u7_y,
            u6_y,
            ],
            [u1_x,
            u2_x,
            u3_x,
            u5_x,
            cos_w_2,
            u7_x,
            u6_x,
            ],
        ) = S::sin_cos_each([beta, w, gamma, delta, w_2, epsilon, w_3]);
        let abs_F_x = (self.rr * u1_x).abs();
        let w_4 = (self.d * u2_x).abs();
        let abs_F_y = (self.rr * u1_y).abs();
        let abs_loop3_x_by_Theta = (self.d * u2_y).abs();
        let abs_xa = self.xa.abs();
        let abs_ya = self.ya.abs();
        [
            self.xb.abs() + abs_F_x + w_4 + (self.ss * u3_y).abs(),
            self.yb.abs() + abs_F_y + abs_loop3_x_by_Theta + (self.ss * u3_x).abs(),
            abs_F_x + w_4 + abs_xa + (self.zt * u5_x).abs() + (self.ee * n4_x).abs(),
            abs_F_y + abs_loop3_x_by_Theta + abs_ya + (self.zt * u5_y).abs()
                + (self.ee * cos_w_2).abs(),
            abs_F_x + w_4 + abs_xa + (self.u * u7_y).abs() + (self.zf * u6_x).abs(),
            abs_F_y + abs_loop3_x_by_Theta + abs_ya + (self.u * u7_x).abs()
                + (self.zf * u6_y).abs(),
        ]
    }
    /// Constraint Jacobian `C_q`, 6 x 7.
    ///
    /// Operations: 17 additions, 14 multiplications, 7 sine-cosine pairs.
    #[inline]
    pub fn constraint_jacobian(&self, t: S, q: &[S; 7]) -> [[S; 7]; 6] {
        let [beta, Theta_, gamma, Phi_, delta, Omega_, epsilon] = *q;
        let w = beta + Theta_;
        let w_2 = Phi_ + delta;
        let w_3 = Omega_ + epsilon;
        let (
            [u1_y,
            u2_y,
            u3_y,
            n4_x,
            u5_y,
            u6_y,
            u7_y,
            ],
            [u1_x,
            u2_x,
            u3_x,
            cos_w_2,
            u5_x,
            u6_x,
            u7_x,
            ],
        ) = S::sin_cos_each([beta, w, gamma, w_2, delta, w_3, epsilon]);
        let loop3_x_by_Theta = self.d * u2_y;
        let loop3_x_by_beta = loop3_x_by_Theta - self.rr * u1_y;
        let minus_loop3_y_by_Theta = self.d * u2_x;
        let P_x = self.rr * u1_x - minus_loop3_y_by_Theta;
        let loop3_y_by_Theta = -minus_loop3_y_by_Theta;
        let minus_loop4_x_by_Phi = self.ee * cos_w_2;
        let minus_loop4_y_by_Phi = self.ee * n4_x;
        let loop6_x_by_Omega = self.zf * u6_y;
        let minus_loop6_y_by_Omega = self.zf * u6_x;
        [
            [
                loop3_x_by_beta,
                loop3_x_by_Theta,
                -(self.ss * u3_x),
                S::from_f64(0.0),
                S::from_f64(0.0),
                S::from_f64(0.0),
                S::from_f64(0.0),
            ],
            [
                P_x,
                loop3_y_by_Theta,
                -(self.ss * u3_y),
                S::from_f64(0.0),
                S::from_f64(0.0),
                S::from_f64(0.0),
                S::from_f64(0.0),
            ],
            [
                loop3_x_by_beta,
                loop3_x_by_Theta,
                S::from_f64(0.0),
                -minus_loop4_x_by_Phi,
                self.zt * u5_y - minus_loop4_x_by_Phi,
                S::from_f64(0.0),
                S::from_f64(0.0),
            ],
            [
                P_x,
                loop3_y_by_Theta,
                S::from_f64(0.0),
                -minus_loop4_y_by_Phi,
                -(self.zt * u5_x + minus_loop4_y_by_Phi),
                S::from_f64(0.0),
                S::from_f64(0.0),
            ],
            [
                loop3_x_by_beta,
                loop3_x_by_Theta,
                S::from_f64(0.0),
                S::from_f64(0.0),
                S::from_f64(0.0),
                loop6_x_by_Omega,
                loop6_x_by_Omega - self.u * u7_x,
            ],
            [
                P_x,
                loop3_y_by_Theta,
                S::from_f64(0.0),
                S::from_f64(0.0),
                S::from_f64(0.0),
                -minus_loop6_y_by_Omega,
                -(self.u * u7_y + minus_loop6_y_by_Omega),
            ],
        ]
    }
    /// `C_t`, 6: the speeds obey `C_q q' + C_t = 0`.
    ///
    /// Operations: none.
    #[inline]
    pub fn constraint_time_derivative(&self, t: S, q: &[S; 7]) -> [S; 6] {
        [
            S::from_f64(0.0),
            S::from_f64(0.0),
            S::from_f64(0.0),
            S::from_f64(0.0),
            S::from_f64(0.0),
            S::from_f64(0.0),
        ]
    }
    /// `(C_q q' + C_t)_q q' + (..)_t`, 6: the part of `C''` without accelerations.
    ///
    /// Operations: 28 additions, 53 multiplications, 7 sine-cosine pairs.
    #[inline]
    pub fn constraint_convective(&self, t: S, q: &[S; 7], qd: &[S; 7]) -> [S; 6] {
        let [beta, Theta_, gamma, Phi_, delta, Omega_, epsilon] = *q;
        let [beta_dot, Theta_dot, gamma_dot, Phi_dot, delta_dot, Omega_dot, epsilon_dot,
        ] = *qd;
        let w = beta + Theta_;
        let w_2 = Phi_ + delta;
        let w_3 = Omega_ + epsilon;
        let (
            [u2_y,
            u1_y,
            u3_y,
            u5_y,
            n4_x,
            u6_y,
            u7_y,
            ],
            [u2_x,
            u1_x,
            u3_x,
            u5_x,
            cos_w_2,
            u6_x,
            u7_x,
            ],
        ) = S::sin_cos_each([w, beta, gamma, delta, w_2, w_3, epsilon]);
        let w_4 = beta_dot + Theta_dot;
        let w_5 = Theta_dot * self.d * u2_x * w_4;
        let w_6 = beta_dot * (beta_dot * self.rr * u1_x - self.d * u2_x * w_4);
        let gamma_dot_squared = gamma_dot * gamma_dot;
        let w_7 = beta_dot * (beta_dot * self.rr * u1_y - self.d * u2_y * w_4);
        let w_8 = Theta_dot * self.d * u2_y * w_4;
        let w_9 = Phi_dot + delta_dot;
        let w_10 = Omega_dot + epsilon_dot;
        [
            w_5 - w_6 + gamma_dot_squared * self.ss * u3_y,
            w_8 - w_7 - gamma_dot_squared * self.ss * u3_x,
            w_5 - w_6 + delta_dot * (delta_dot * self.zt * u5_x + self.ee * n4_x * w_9)
                + Phi_dot * self.ee * n4_x * w_9,
            w_8 - w_7 - Phi_dot * self.ee * cos_w_2 * w_9
                + delta_dot * (delta_dot * self.zt * u5_y - self.ee * cos_w_2 * w_9),
            w_5 - w_6 + Omega_dot * self.zf * u6_x * w_10
                + epsilon_dot * (epsilon_dot * self.u * u7_y + self.zf * u6_x * w_10),
            w_8 - w_7 + Omega_dot * self.zf * u6_y * w_10
                - epsilon_dot * (epsilon_dot * self.u * u7_x - self.zf * u6_y * w_10),
        ]
    }
    /// `C` (6), `C_q` (6 x 7) and `C_t` (6) together, for projection.
    ///
    /// Operations: 39 additions, 14 multiplications, 7 sine-cosine pairs.
    #[inline]
    pub fn constraint_linearization(
        &self,
        t: S,
        q: &[S; 7],
    ) -> sim_kernel::ConstraintLinearization<[S; 6], [[S; 7]; 6]> {
        let [beta, Theta_, gamma, Phi_, delta, Omega_, epsilon] = *q;
        let w = beta + Theta_;
        let w_2 = Phi_ + delta;
        let w_3 = Omega_ + epsilon;
        let (
            [u1_y,
            u2_y,
            u3_y,
            u5_y,
            n4_x,
            u7_y,
            u6_y,
            ],
            [u1_x,
            u2_x,
            u3_x,
            u5_x,
            cos_w_2,
            u7_x,
            u6_x,
            ],
        ) = S::sin_cos_each([beta, w, gamma, delta, w_2, epsilon, w_3]);
        let F_x = self.rr * u1_x;
        let minus_loop3_y_by_Theta = self.d * u2_x;
        let minus_loop3_y_by_gamma = self.ss * u3_y;
        let F_y = self.rr * u1_y;
        let loop3_x_by_Theta = self.d * u2_y;
        let minus_loop3_x_by_gamma = self.ss * u3_x;
        let w_4 = self.zt * u5_x;
        let minus_loop4_y_by_Phi = self.ee * n4_x;
        let w_5 = self.zt * u5_y;
        let minus_loop4_x_by_Phi = self.ee * cos_w_2;
        let w_6 = self.u * u7_y;
        let minus_loop6_y_by_Omega = self.zf * u6_x;
        let w_7 = self.u * u7_x;
        let loop6_x_by_Omega = self.zf * u6_y;
        let loop3_x_by_beta = loop3_x_by_Theta - F_y;
        let P_x = F_x - minus_loop3_y_by_Theta;
        let loop3_y_by_Theta = -minus_loop3_y_by_Theta;
        sim_kernel::ConstraintLinearization {
            values: [
                F_x - self.xb - minus_loop3_y_by_Theta - minus_loop3_y_by_gamma,
                F_y - self.yb - loop3_x_by_Theta + minus_loop3_x_by_gamma,
                F_x - self.xa - minus_loop3_y_by_Theta - w_4 - minus_loop4_y_by_Phi,
                F_y - self.ya - loop3_x_by_Theta - w_5 + minus_loop4_x_by_Phi,
                F_x - self.xa - minus_loop3_y_by_Theta - w_6 - minus_loop6_y_by_Omega,
                F_y - self.ya - loop3_x_by_Theta + w_7 - loop6_x_by_Omega,
            ],
            jacobian: [
                [
                    loop3_x_by_beta,
                    loop3_x_by_Theta,
                    -minus_loop3_x_by_gamma,
                    S::from_f64(0.0),
                    S::from_f64(0.0),
                    S::from_f64(0.0),
                    S::from_f64(0.0),
                ],
                [
                    P_x,
                    loop3_y_by_Theta,
                    -minus_loop3_y_by_gamma,
                    S::from_f64(0.0),
                    S::from_f64(0.0),
                    S::from_f64(0.0),
                    S::from_f64(0.0),
                ],
                [
                    loop3_x_by_beta,
                    loop3_x_by_Theta,
                    S::from_f64(0.0),
                    -minus_loop4_x_by_Phi,
                    w_5 - minus_loop4_x_by_Phi,
                    S::from_f64(0.0),
                    S::from_f64(0.0),
                ],
                [
                    P_x,
                    loop3_y_by_Theta,
                    S::from_f64(0.0),
                    -minus_loop4_y_by_Phi,
                    -(w_4 + minus_loop4_y_by_Phi),
                    S::from_f64(0.0),
                    S::from_f64(0.0),
                ],
                [
                    loop3_x_by_beta,
                    loop3_x_by_Theta,
                    S::from_f64(0.0),
                    S::from_f64(0.0),
                    S::from_f64(0.0),
                    loop6_x_by_Omega,
                    loop6_x_by_Omega - w_7,
                ],
                [
                    P_x,
                    loop3_y_by_Theta,
                    S::from_f64(0.0),
                    S::from_f64(0.0),
                    S::from_f64(0.0),
                    -minus_loop6_y_by_Omega,
                    -(w_6 + minus_loop6_y_by_Omega),
                ],
            ],
            time_derivative: [
                S::from_f64(0.0),
                S::from_f64(0.0),
                S::from_f64(0.0),
                S::from_f64(0.0),
                S::from_f64(0.0),
                S::from_f64(0.0),
            ],
        }
    }
    /// Kinetic energy `v' M v / 2`, in joules.
    ///
    /// Operations: 45 additions, 109 multiplications, 7 sine-cosine pairs.
    #[inline]
    pub fn kinetic_energy(&self, t: S, q: &[S; 7], qd: &[S; 7]) -> S {
        let [beta, Theta_, gamma, Phi_, delta, Omega_, epsilon] = *q;
        let [beta_dot, Theta_dot, gamma_dot, Phi_dot, delta_dot, Omega_dot, epsilon_dot,
        ] = *qd;
        let beta_dot_squared = beta_dot * beta_dot;
        let w = beta_dot + Theta_dot;
        let w_2 = beta + Theta_;
        let w_3 = Phi_ + delta;
        let w_4 = Omega_ + epsilon;
        let (
            [u2_y,
            u1_y,
            u3_y,
            n4_x,
            u5_y,
            u7_y,
            u6_y,
            ],
            [u2_x,
            u1_x,
            u3_x,
            cos_w_3,
            u5_x,
            u7_x,
            u6_x,
            ],
        ) = S::sin_cos_each([w_2, beta, gamma, w_3, delta, epsilon, w_4]);
        let w_5 = Theta_dot * self.da * u2_y
            - beta_dot * (self.rr * u1_y - self.da * u2_y);
        let w_6 = beta_dot * (self.rr * u1_x - self.da * u2_x)
            - Theta_dot * self.da * u2_x;
        let w_7 = S::from_f64(0.5) * self.m2 * w_6 * w_6;
        let gamma_dot_squared = gamma_dot * gamma_dot;
        let w_8 = self.sa * u3_x - self.sb * u3_y;
        let w_9 = S::from_f64(0.5) * gamma_dot_squared * self.m3 * w_8 * w_8;
        let w_10 = self.sa * u3_y + self.sb * u3_x;
        let w_11 = S::from_f64(0.5) * gamma_dot_squared * self.m3 * w_10 * w_10;
        let w_12 = Phi_dot + delta_dot;
        let w_13 = S::from_f64(0.5) * self.i4 * w_12 * w_12;
        let w_14 = self.ee - self.ea;
        let w_15 = Phi_dot * cos_w_3 * w_14
            - delta_dot * (self.zt * u5_y - cos_w_3 * w_14);
        let w_16 = S::from_f64(0.5) * self.m4 * w_15 * w_15;
        let w_17 = Phi_dot * n4_x * w_14 + delta_dot * (self.zt * u5_x + n4_x * w_14);
        let w_18 = S::from_f64(0.5) * self.m4 * w_17 * w_17;
        let delta_dot_squared = delta_dot * delta_dot;
        let w_19 = self.ta * u5_y + self.tb * u5_x;
        let w_20 = S::from_f64(0.5) * delta_dot_squared * self.m5 * w_19 * w_19;
        let w_21 = self.ta * u5_x - self.tb * u5_y;
        let w_22 = S::from_f64(0.5) * delta_dot_squared * self.m5 * w_21 * w_21;
        let w_23 = Omega_dot + epsilon_dot;
        let w_24 = S::from_f64(0.5) * self.i6 * w_23 * w_23;
        let w_25 = self.zf - self.fa;
        let w_26 = epsilon_dot * (self.u * u7_x - u6_y * w_25) - Omega_dot * u6_y * w_25;
        let w_27 = S::from_f64(0.5) * self.m6 * w_26 * w_26;
        let w_28 = Omega_dot * u6_x * w_25 + epsilon_dot * (self.u * u7_y + u6_x * w_25);
        let w_29 = S::from_f64(0.5) * self.m6 * w_28 * w_28;
        let epsilon_dot_squared = epsilon_dot * epsilon_dot;
        let w_30 = self.ua * u7_x + self.ub * u7_y;
        let w_31 = S::from_f64(0.5) * epsilon_dot_squared * self.m7 * w_30 * w_30;
        let w_32 = self.ua * u7_y - self.ub * u7_x;
        let w_33 = S::from_f64(0.5) * epsilon_dot_squared * self.m7 * w_32 * w_32;
        let w_34 = S::from_f64(0.5) * beta_dot_squared * self.m1 * self.ra * self.ra;
        S::from_f64(0.5) * beta_dot_squared * self.i1
            + S::from_f64(0.5) * self.i2 * w * w + S::from_f64(0.5) * self.m2 * w_5 * w_5
            + w_7 + S::from_f64(0.5) * gamma_dot_squared * self.i3 + w_9 + w_11 + w_13
            + w_16 + w_18 + S::from_f64(0.5) * delta_dot_squared * self.i5 + w_20 + w_22
            + w_24 + w_27 + w_29 + S::from_f64(0.5) * epsilon_dot_squared * self.i7
            + w_31 + w_33 + w_34
    }
    /// Power of loads and drives, `F' v + lambda' C_t + T_t' (M x'' - F)`, in watts.
    ///
    /// Operations: 12 additions, 15 multiplications, 2 divisions, 1 sine-cosine pairs, 1 square roots.
    #[inline]
    pub fn power(
        &self,
        t: S,
        q: &[S; 7],
        qd: &[S; 7],
        qdd: &[S; 7],
        lambda: &[S; 6],
    ) -> S {
        let [_, _, gamma, _, _, _, _] = *q;
        let [beta_dot, _, gamma_dot, _, _, _, _] = *qd;
        let ([u3_y], [u3_x]) = S::sin_cos_each([gamma]);
        let w = self.sc * u3_y;
        let w_2 = self.sd * u3_x;
        let w_3 = self.xb - self.xc + w + w_2;
        let w_4 = self.sc * u3_x;
        let w_5 = self.sd * u3_y;
        let w_6 = self.yb - self.yc - w_4 + w_5;
        let w_7 = (w_3 * w_3 + w_6 * w_6).sqrt();
        let w_8 = self.l0 - w_7;
        beta_dot * self.mom + gamma_dot * self.c0 * w_3 * w_8 * (w_4 - w_5) / w_7
            + gamma_dot * self.c0 * w_6 * w_8 * (w + w_2) / w_7
    }
    /// Outputs, in SI units.
    ///
    /// Operations: 12 additions, 9 multiplications, 1 sine-cosine pairs, 2 square roots.
    #[inline]
    pub fn outputs(
        &self,
        t: S,
        q: &[S; 7],
        qd: &[S; 7],
        qdd: &[S; 7],
        lambda: &[S; 6],
    ) -> AndrewsOutputs<S> {
        let [beta, _, gamma, Phi_, delta, Omega_, epsilon] = *q;
        let [lambda_loop3_x, lambda_loop3_y, _, _, _, _] = *lambda;
        let ([u3_y], [u3_x]) = S::sin_cos_each([gamma]);
        let w = self.xb - self.xc + self.sc * u3_y + self.sd * u3_x;
        let w_2 = self.yb - self.yc - self.sc * u3_x + self.sd * u3_y;
        [
            beta,
            gamma,
            Phi_ + delta,
            delta,
            Omega_ + epsilon,
            epsilon,
            -(self.c0 * (self.l0 - (w * w + w_2 * w_2).sqrt())),
            (lambda_loop3_x * lambda_loop3_x + lambda_loop3_y * lambda_loop3_y).sqrt(),
        ]
            .into()
    }
    /// Rates of the outputs that depend on neither accelerations nor multipliers, in SI units.
    ///
    /// Operations: 12 additions, 18 multiplications, 1 divisions, 1 sine-cosine pairs, 1 square roots.
    #[inline]
    pub fn output_rates(
        &self,
        t: S,
        q: &[S; 7],
        qd: &[S; 7],
        qdd: &[S; 7],
    ) -> AndrewsOutputRates<S> {
        let [_, _, gamma, _, _, _, _] = *q;
        let [beta_dot, _, gamma_dot, Phi_dot, delta_dot, Omega_dot, epsilon_dot] = *qd;
        let ([u3_y], [u3_x]) = S::sin_cos_each([gamma]);
        let w = self.xb - self.xc + self.sc * u3_y + self.sd * u3_x;
        let w_2 = self.yb - self.yc - self.sc * u3_x + self.sd * u3_y;
        let w_3 = w * w + w_2 * w_2;
        let w_4 = self.c0 * w_3.sqrt()
            * (w * (gamma_dot * self.sc * u3_x - gamma_dot * self.sd * u3_y)
                + w_2 * (gamma_dot * self.sc * u3_y + gamma_dot * self.sd * u3_x));
        [
            beta_dot,
            gamma_dot,
            Phi_dot + delta_dot,
            delta_dot,
            Omega_dot + epsilon_dot,
            epsilon_dot,
            w_4 / w_3,
        ]
            .into()
    }
    /// `left - right` of each event, zero when it happens.
    ///
    /// Operations: none.
    #[inline]
    pub fn events(&self, t: S, q: &[S; 7], qd: &[S; 7]) -> [S; 0] {
        []
    }
    /// The numbers of each shape of the drawing, in metres and radians.
    ///
    /// Operations: 11 additions, 12 multiplications, 5 sine-cosine pairs.
    #[inline]
    pub fn drawing(&self, t: S, q: &[S; 7]) -> [S; 38] {
        let [beta, Theta_, gamma, _, delta, _, epsilon] = *q;
        let w = beta + Theta_;
        let ([u1_y, u2_y, u3_y, u5_y, u7_y], [u1_x, u2_x, u3_x, u5_x, u7_x]) = S::sin_cos_each([
            beta,
            w,
            gamma,
            delta,
            epsilon,
        ]);
        let F_x = self.rr * u1_x;
        let F_y = self.rr * u1_y;
        let P_x = F_x - self.d * u2_x;
        let P_y = F_y - self.d * u2_y;
        let D_x = self.xb + self.sc * u3_y + self.sd * u3_x;
        let D_y = self.yb - self.sc * u3_x + self.sd * u3_y;
        [
            S::from_f64(0.0),
            S::from_f64(0.0),
            self.xa,
            self.ya,
            self.xb,
            self.yb,
            self.xc,
            self.yc,
            S::from_f64(0.0),
            S::from_f64(0.0),
            F_x,
            F_y,
            P_x,
            P_y,
            self.xb,
            self.yb,
            P_x,
            P_y,
            self.xb,
            self.yb,
            D_x,
            D_y,
            D_x,
            D_y,
            self.xc,
            self.yc,
            self.xa,
            self.ya,
            self.xa + self.zt * u5_x,
            self.ya + self.zt * u5_y,
            P_x,
            P_y,
            self.xa,
            self.ya,
            self.xa + self.u * u7_y,
            self.ya - self.u * u7_x,
            P_x,
            P_y,
        ]
    }
    /// Declared start: values or guesses of the coordinates, and speeds; 0 where nothing is declared.
    ///
    /// Operations: 2 additions.
    #[inline]
    pub fn initial(&self) -> sim_kernel::Initial<[S; 7]> {
        sim_kernel::Initial {
            positions: [
                -S::from_f64(0.06),
                S::from_f64(0.0),
                S::from_f64(0.46),
                S::from_f64(0.22),
                S::from_f64(0.49),
                -S::from_f64(0.22),
                S::from_f64(1.23),
            ],
            speeds: [
                S::from_f64(0.0),
                S::from_f64(0.0),
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
impl<S: sim_kernel::Scalar> sim_kernel::Mechanism<S> for Andrews<S> {
    type Q = [S; 7];
    type L = [S; 6];
    type Z = [S; 13];
    type QQ = [[S; 7]; 7];
    type LQ = [[S; 7]; 6];
    type LL = [[S; 6]; 6];
    type ZZ = [[S; 13]; 13];
    type Parameters = [S; 42];
    type Outputs = [S; 8];
    type OutputRates = [S; 7];
    type Events = [S; 0];
    type Drawing = [S; 38];
    const DESCRIPTION: sim_kernel::Description = sim_kernel::Description {
        name: "andrews",
        type_name: "Andrews",
        docs: "Andrews' squeezing mechanism: seven bodies, three loops; run it for 30 ms (`--t-end 30ms`).\nA constant torque turns crank 1 against a spring; the motion grows until nothing holds it.",
        declaration: "/// Andrews' squeezing mechanism: seven bodies, three loops; run it for 30 ms (`--t-end 30ms`).\n/// A constant torque turns crank 1 against a spring; the motion grows until nothing holds it.\npub Andrews;\n\ncoordinates { beta [rad]; Theta [rad]; gamma [rad]; Phi [rad]; delta [rad]; Omega [rad]; epsilon [rad]; }\n\nparameters {\n    m1 [kg] = 0.04325; m2 [kg] = 0.00365; m3 [kg] = 0.02373; m4 [kg] = 0.00706;\n    m5 [kg] = 0.0705; m6 [kg] = 0.00706; m7 [kg] = 0.05498;\n    i1 [kg*m^2] = 2.194e-6; i2 [kg*m^2] = 4.41e-7; i3 [kg*m^2] = 5.255e-6; i4 [kg*m^2] = 5.667e-7;\n    i5 [kg*m^2] = 1.169e-5; i6 [kg*m^2] = 5.667e-7; i7 [kg*m^2] = 1.912e-5;\n    xa [m] = -0.06934; ya [m] = -0.00227; xb [m] = -0.03635; yb [m] = 0.03273; xc [m] = 0.014; yc [m] = 0.072;\n    /// Stiffness of the spring.\n    c0 [N/m] = 4530;\n    /// Free length of the spring.\n    l0 [m] = 0.07785;\n    /// Torque on crank 1.\n    mom [N*m] = 0.033;\n    d [mm] = 28; da [mm] = 11.5; ee [mm] = 20; ea [mm] = 14.21; rr [mm] = 7; ra [mm] = 0.92; ss [mm] = 35;\n    sa [mm] = 18.74; sb [mm] = 10.43; sc [mm] = 18; sd [mm] = 20; ta [mm] = 23.08; tb [mm] = 9.16;\n    u [mm] = 40; ua [mm] = 12.28; ub [mm] = 4.49; zf [mm] = 20; zt [mm] = 40; fa [mm] = 14.21;\n}\n\nlet O = [0, 0];\nlet A = [xa, ya];\nlet B = [xb, yb];\nlet C = [xc, yc];\nlet u1 = [cos(beta), sin(beta)];\nlet u2 = [cos(beta + Theta), sin(beta + Theta)];\nlet u3 = [cos(gamma), sin(gamma)];\nlet n3 = [sin(gamma), -cos(gamma)];\nlet n4 = [sin(Phi + delta), -cos(Phi + delta)];\nlet u5 = [cos(delta), sin(delta)];\nlet n5 = [sin(delta), -cos(delta)];\nlet u6 = [cos(Omega + epsilon), sin(Omega + epsilon)];\nlet u7 = [cos(epsilon), sin(epsilon)];\nlet n7 = [sin(epsilon), -cos(epsilon)];\nlet F = rr*u1;\nlet P = F - d*u2;\nlet D = B + sc*n3 + sd*u3;\nlet E = A + zt*u5;\nlet G = A + u*n7;\nlet stretch = norm(D - C) - l0;\n\nbodies {\n    crank1: mass m1 at ra*u1, inertia i1, angle beta;\n    bar2: mass m2 at F - da*u2, inertia i2, angle beta + Theta;\n    plate3: mass m3 at B + sa*n3 + sb*u3, inertia i3, angle gamma;\n    bar4: mass m4 at E + (ee - ea)*n4, inertia i4, angle Phi + delta;\n    plate5: mass m5 at A + ta*u5 - tb*n5, inertia i5, angle delta;\n    bar6: mass m6 at G + (zf - fa)*u6, inertia i6, angle Omega + epsilon;\n    plate7: mass m7 at A + ua*n7 - ub*u7, inertia i7, angle epsilon;\n}\n\nloads {\n    torque mom on crank1;\n    force c0*stretch*(C - D)/norm(D - C) at D;\n}\n\nconstraints {\n    loop3: P = B + ss*n3;\n    loop4: P = E + ee*n4;\n    loop6: P = G + zf*u6;\n}\n\ninitial {\n    Theta = 0;\n    guess beta = -0.06;\n    guess gamma = 0.46;\n    guess Phi = 0.22;\n    guess delta = 0.49;\n    guess Omega = -0.22;\n    guess epsilon = 1.23;\n}\n\noutputs {\n    crank \"Crank 1\" {\n        /// angle of the crank\n        crank_angle [rad] = beta;\n    }\n    swings \"Angles of the other bodies\" {\n        /// plate 3\n        plate3_angle [rad] = gamma;\n        /// bar 4\n        bar4_angle [rad] = Phi + delta;\n        /// plate 5\n        plate5_angle [rad] = delta;\n        /// bar 6\n        bar6_angle [rad] = Omega + epsilon;\n        /// plate 7\n        plate7_angle [rad] = epsilon;\n    }\n    spring_force \"Spring\" {\n        /// force of the spring\n        pull [N] = c0*stretch;\n    }\n    /// Joint force in P on plate 3\n    joint_force [N] = norm(reaction(loop3));\n}\n\ndrawing {\n    ground O, A, B, C;\n    line O, F, P;\n    line B, P;\n    line B, D;\n    line D, C;\n    line A, E, P;\n    line A, G, P;\n}\n",
        coordinates: &[
            sim_kernel::Coordinate {
                position: sim_kernel::Quantity {
                    name: "beta",
                    unit: "rad",
                    factor: 1f64,
                    docs: "",
                },
                speed: sim_kernel::Quantity {
                    name: "beta_dot",
                    unit: "rad/s",
                    factor: 1f64,
                    docs: "",
                },
                acceleration: sim_kernel::Quantity {
                    name: "beta_ddot",
                    unit: "rad/s^2",
                    factor: 1f64,
                    docs: "",
                },
                start: sim_kernel::Start::Guess,
                speed_given: false,
            },
            sim_kernel::Coordinate {
                position: sim_kernel::Quantity {
                    name: "Theta",
                    unit: "rad",
                    factor: 1f64,
                    docs: "",
                },
                speed: sim_kernel::Quantity {
                    name: "Theta_dot",
                    unit: "rad/s",
                    factor: 1f64,
                    docs: "",
                },
                acceleration: sim_kernel::Quantity {
                    name: "Theta_ddot",
                    unit: "rad/s^2",
                    factor: 1f64,
                    docs: "",
                },
                start: sim_kernel::Start::Given,
                speed_given: false,
            },
            sim_kernel::Coordinate {
                position: sim_kernel::Quantity {
                    name: "gamma",
                    unit: "rad",
                    factor: 1f64,
                    docs: "",
                },
                speed: sim_kernel::Quantity {
                    name: "gamma_dot",
                    unit: "rad/s",
                    factor: 1f64,
                    docs: "",
                },
                acceleration: sim_kernel::Quantity {
                    name: "gamma_ddot",
                    unit: "rad/s^2",
                    factor: 1f64,
                    docs: "",
                },
                start: sim_kernel::Start::Guess,
                speed_given: false,
            },
            sim_kernel::Coordinate {
                position: sim_kernel::Quantity {
                    name: "Phi",
                    unit: "rad",
                    factor: 1f64,
                    docs: "",
                },
                speed: sim_kernel::Quantity {
                    name: "Phi_dot",
                    unit: "rad/s",
                    factor: 1f64,
                    docs: "",
                },
                acceleration: sim_kernel::Quantity {
                    name: "Phi_ddot",
                    unit: "rad/s^2",
                    factor: 1f64,
                    docs: "",
                },
                start: sim_kernel::Start::Guess,
                speed_given: false,
            },
            sim_kernel::Coordinate {
                position: sim_kernel::Quantity {
                    name: "delta",
                    unit: "rad",
                    factor: 1f64,
                    docs: "",
                },
                speed: sim_kernel::Quantity {
                    name: "delta_dot",
                    unit: "rad/s",
                    factor: 1f64,
                    docs: "",
                },
                acceleration: sim_kernel::Quantity {
                    name: "delta_ddot",
                    unit: "rad/s^2",
                    factor: 1f64,
                    docs: "",
                },
                start: sim_kernel::Start::Guess,
                speed_given: false,
            },
            sim_kernel::Coordinate {
                position: sim_kernel::Quantity {
                    name: "Omega",
                    unit: "rad",
                    factor: 1f64,
                    docs: "",
                },
                speed: sim_kernel::Quantity {
                    name: "Omega_dot",
                    unit: "rad/s",
                    factor: 1f64,
                    docs: "",
                },
                acceleration: sim_kernel::Quantity {
                    name: "Omega_ddot",
                    unit: "rad/s^2",
                    factor: 1f64,
                    docs: "",
                },
                start: sim_kernel::Start::Guess,
                speed_given: false,
            },
            sim_kernel::Coordinate {
                position: sim_kernel::Quantity {
                    name: "epsilon",
                    unit: "rad",
                    factor: 1f64,
                    docs: "",
                },
                speed: sim_kernel::Quantity {
                    name: "epsilon_dot",
                    unit: "rad/s",
                    factor: 1f64,
                    docs: "",
                },
                acceleration: sim_kernel::Quantity {
                    name: "epsilon_ddot",
                    unit: "rad/s^2",
                    factor: 1f64,
                    docs: "",
                },
                start: sim_kernel::Start::Guess,
                speed_given: false,
            },
        ],
        parameters: &[
            sim_kernel::Quantity {
                name: "m1",
                unit: "kg",
                factor: 1f64,
                docs: "",
            },
            sim_kernel::Quantity {
                name: "m2",
                unit: "kg",
                factor: 1f64,
                docs: "",
            },
            sim_kernel::Quantity {
                name: "m3",
                unit: "kg",
                factor: 1f64,
                docs: "",
            },
            sim_kernel::Quantity {
                name: "m4",
                unit: "kg",
                factor: 1f64,
                docs: "",
            },
            sim_kernel::Quantity {
                name: "m5",
                unit: "kg",
                factor: 1f64,
                docs: "",
            },
            sim_kernel::Quantity {
                name: "m6",
                unit: "kg",
                factor: 1f64,
                docs: "",
            },
            sim_kernel::Quantity {
                name: "m7",
                unit: "kg",
                factor: 1f64,
                docs: "",
            },
            sim_kernel::Quantity {
                name: "i1",
                unit: "kg*m^2",
                factor: 1f64,
                docs: "",
            },
            sim_kernel::Quantity {
                name: "i2",
                unit: "kg*m^2",
                factor: 1f64,
                docs: "",
            },
            sim_kernel::Quantity {
                name: "i3",
                unit: "kg*m^2",
                factor: 1f64,
                docs: "",
            },
            sim_kernel::Quantity {
                name: "i4",
                unit: "kg*m^2",
                factor: 1f64,
                docs: "",
            },
            sim_kernel::Quantity {
                name: "i5",
                unit: "kg*m^2",
                factor: 1f64,
                docs: "",
            },
            sim_kernel::Quantity {
                name: "i6",
                unit: "kg*m^2",
                factor: 1f64,
                docs: "",
            },
            sim_kernel::Quantity {
                name: "i7",
                unit: "kg*m^2",
                factor: 1f64,
                docs: "",
            },
            sim_kernel::Quantity {
                name: "xa",
                unit: "m",
                factor: 1f64,
                docs: "",
            },
            sim_kernel::Quantity {
                name: "ya",
                unit: "m",
                factor: 1f64,
                docs: "",
            },
            sim_kernel::Quantity {
                name: "xb",
                unit: "m",
                factor: 1f64,
                docs: "",
            },
            sim_kernel::Quantity {
                name: "yb",
                unit: "m",
                factor: 1f64,
                docs: "",
            },
            sim_kernel::Quantity {
                name: "xc",
                unit: "m",
                factor: 1f64,
                docs: "",
            },
            sim_kernel::Quantity {
                name: "yc",
                unit: "m",
                factor: 1f64,
                docs: "",
            },
            sim_kernel::Quantity {
                name: "c0",
                unit: "N/m",
                factor: 1f64,
                docs: "Stiffness of the spring.",
            },
            sim_kernel::Quantity {
                name: "l0",
                unit: "m",
                factor: 1f64,
                docs: "Free length of the spring.",
            },
            sim_kernel::Quantity {
                name: "mom",
                unit: "N*m",
                factor: 1f64,
                docs: "Torque on crank 1.",
            },
            sim_kernel::Quantity {
                name: "d",
                unit: "mm",
                factor: 0.001f64,
                docs: "",
            },
            sim_kernel::Quantity {
                name: "da",
                unit: "mm",
                factor: 0.001f64,
                docs: "",
            },
            sim_kernel::Quantity {
                name: "ee",
                unit: "mm",
                factor: 0.001f64,
                docs: "",
            },
            sim_kernel::Quantity {
                name: "ea",
                unit: "mm",
                factor: 0.001f64,
                docs: "",
            },
            sim_kernel::Quantity {
                name: "rr",
                unit: "mm",
                factor: 0.001f64,
                docs: "",
            },
            sim_kernel::Quantity {
                name: "ra",
                unit: "mm",
                factor: 0.001f64,
                docs: "",
            },
            sim_kernel::Quantity {
                name: "ss",
                unit: "mm",
                factor: 0.001f64,
                docs: "",
            },
            sim_kernel::Quantity {
                name: "sa",
                unit: "mm",
                factor: 0.001f64,
                docs: "",
            },
            sim_kernel::Quantity {
                name: "sb",
                unit: "mm",
                factor: 0.001f64,
                docs: "",
            },
            sim_kernel::Quantity {
                name: "sc",
                unit: "mm",
                factor: 0.001f64,
                docs: "",
            },
            sim_kernel::Quantity {
                name: "sd",
                unit: "mm",
                factor: 0.001f64,
                docs: "",
            },
            sim_kernel::Quantity {
                name: "ta",
                unit: "mm",
                factor: 0.001f64,
                docs: "",
            },
            sim_kernel::Quantity {
                name: "tb",
                unit: "mm",
                factor: 0.001f64,
                docs: "",
            },
            sim_kernel::Quantity {
                name: "u",
                unit: "mm",
                factor: 0.001f64,
                docs: "",
            },
            sim_kernel::Quantity {
                name: "ua",
                unit: "mm",
                factor: 0.001f64,
                docs: "",
            },
            sim_kernel::Quantity {
                name: "ub",
                unit: "mm",
                factor: 0.001f64,
                docs: "",
            },
            sim_kernel::Quantity {
                name: "zf",
                unit: "mm",
                factor: 0.001f64,
                docs: "",
            },
            sim_kernel::Quantity {
                name: "zt",
                unit: "mm",
                factor: 0.001f64,
                docs: "",
            },
            sim_kernel::Quantity {
                name: "fa",
                unit: "mm",
                factor: 0.001f64,
                docs: "",
            },
        ],
        constraints: &[
            sim_kernel::Quantity {
                name: "loop3_x",
                unit: "N",
                factor: 1f64,
                docs: "",
            },
            sim_kernel::Quantity {
                name: "loop3_y",
                unit: "N",
                factor: 1f64,
                docs: "",
            },
            sim_kernel::Quantity {
                name: "loop4_x",
                unit: "N",
                factor: 1f64,
                docs: "",
            },
            sim_kernel::Quantity {
                name: "loop4_y",
                unit: "N",
                factor: 1f64,
                docs: "",
            },
            sim_kernel::Quantity {
                name: "loop6_x",
                unit: "N",
                factor: 1f64,
                docs: "",
            },
            sim_kernel::Quantity {
                name: "loop6_y",
                unit: "N",
                factor: 1f64,
                docs: "",
            },
        ],
        events: &[],
        outputs: &[
            sim_kernel::Quantity {
                name: "crank_angle",
                unit: "rad",
                factor: 1f64,
                docs: "angle of the crank",
            },
            sim_kernel::Quantity {
                name: "plate3_angle",
                unit: "rad",
                factor: 1f64,
                docs: "plate 3",
            },
            sim_kernel::Quantity {
                name: "bar4_angle",
                unit: "rad",
                factor: 1f64,
                docs: "bar 4",
            },
            sim_kernel::Quantity {
                name: "plate5_angle",
                unit: "rad",
                factor: 1f64,
                docs: "plate 5",
            },
            sim_kernel::Quantity {
                name: "bar6_angle",
                unit: "rad",
                factor: 1f64,
                docs: "bar 6",
            },
            sim_kernel::Quantity {
                name: "plate7_angle",
                unit: "rad",
                factor: 1f64,
                docs: "plate 7",
            },
            sim_kernel::Quantity {
                name: "pull",
                unit: "N",
                factor: 1f64,
                docs: "force of the spring",
            },
            sim_kernel::Quantity {
                name: "joint_force",
                unit: "N",
                factor: 1f64,
                docs: "Joint force in P on plate 3",
            },
        ],
        rated_outputs: &[0, 1, 2, 3, 4, 5, 6],
        figures: &[
            sim_kernel::Figure {
                name: "crank",
                title: "Crank 1",
                len: 1,
            },
            sim_kernel::Figure {
                name: "swings",
                title: "Angles of the other bodies",
                len: 5,
            },
            sim_kernel::Figure {
                name: "spring_force",
                title: "Spring",
                len: 1,
            },
            sim_kernel::Figure {
                name: "joint_force",
                title: "Joint force in P on plate 3",
                len: 1,
            },
        ],
        drawing: &[
            sim_kernel::Shape::Ground(4),
            sim_kernel::Shape::Line(3),
            sim_kernel::Shape::Line(2),
            sim_kernel::Shape::Line(2),
            sim_kernel::Shape::Line(2),
            sim_kernel::Shape::Line(3),
            sim_kernel::Shape::Line(3),
        ],
    };
    fn defaults() -> Self {
        Self {
            m1: S::from_f64(0.04325f64),
            m2: S::from_f64(0.00365f64),
            m3: S::from_f64(0.02373f64),
            m4: S::from_f64(0.00706f64),
            m5: S::from_f64(0.0705f64),
            m6: S::from_f64(0.00706f64),
            m7: S::from_f64(0.05498f64),
            i1: S::from_f64(0.000002194f64),
            i2: S::from_f64(0.000000441f64),
            i3: S::from_f64(0.000005255f64),
            i4: S::from_f64(0.0000005667f64),
            i5: S::from_f64(0.00001169f64),
            i6: S::from_f64(0.0000005667f64),
            i7: S::from_f64(0.00001912f64),
            xa: S::from_f64(-0.06934f64),
            ya: S::from_f64(-0.00227f64),
            xb: S::from_f64(-0.03635f64),
            yb: S::from_f64(0.03273f64),
            xc: S::from_f64(0.014f64),
            yc: S::from_f64(0.072f64),
            c0: S::from_f64(4530f64),
            l0: S::from_f64(0.07785f64),
            mom: S::from_f64(0.033f64),
            d: S::from_f64(0.028f64),
            da: S::from_f64(0.0115f64),
            ee: S::from_f64(0.02f64),
            ea: S::from_f64(0.01421f64),
            rr: S::from_f64(0.007f64),
            ra: S::from_f64(0.00092f64),
            ss: S::from_f64(0.035f64),
            sa: S::from_f64(0.01874f64),
            sb: S::from_f64(0.01043f64),
            sc: S::from_f64(0.018f64),
            sd: S::from_f64(0.02f64),
            ta: S::from_f64(0.02308f64),
            tb: S::from_f64(0.00916f64),
            u: S::from_f64(0.04f64),
            ua: S::from_f64(0.01228f64),
            ub: S::from_f64(0.00449f64),
            zf: S::from_f64(0.02f64),
            zt: S::from_f64(0.04f64),
            fa: S::from_f64(0.01421f64),
        }
    }
    fn parameters(&self) -> [S; 42] {
        [
            self.m1,
            self.m2,
            self.m3,
            self.m4,
            self.m5,
            self.m6,
            self.m7,
            self.i1,
            self.i2,
            self.i3,
            self.i4,
            self.i5,
            self.i6,
            self.i7,
            self.xa,
            self.ya,
            self.xb,
            self.yb,
            self.xc,
            self.yc,
            self.c0,
            self.l0,
            self.mom,
            self.d,
            self.da,
            self.ee,
            self.ea,
            self.rr,
            self.ra,
            self.ss,
            self.sa,
            self.sb,
            self.sc,
            self.sd,
            self.ta,
            self.tb,
            self.u,
            self.ua,
            self.ub,
            self.zf,
            self.zt,
            self.fa,
        ]
    }
    fn with_parameters(parameters: [S; 42]) -> Self {
        Self {
            m1: parameters[0],
            m2: parameters[1],
            m3: parameters[2],
            m4: parameters[3],
            m5: parameters[4],
            m6: parameters[5],
            m7: parameters[6],
            i1: parameters[7],
            i2: parameters[8],
            i3: parameters[9],
            i4: parameters[10],
            i5: parameters[11],
            i6: parameters[12],
            i7: parameters[13],
            xa: parameters[14],
            ya: parameters[15],
            xb: parameters[16],
            yb: parameters[17],
            xc: parameters[18],
            yc: parameters[19],
            c0: parameters[20],
            l0: parameters[21],
            mom: parameters[22],
            d: parameters[23],
            da: parameters[24],
            ee: parameters[25],
            ea: parameters[26],
            rr: parameters[27],
            ra: parameters[28],
            ss: parameters[29],
            sa: parameters[30],
            sb: parameters[31],
            sc: parameters[32],
            sd: parameters[33],
            ta: parameters[34],
            tb: parameters[35],
            u: parameters[36],
            ua: parameters[37],
            ub: parameters[38],
            zf: parameters[39],
            zt: parameters[40],
            fa: parameters[41],
        }
    }
    #[inline(always)]
    fn dynamics(
        &self,
        t: S,
        q: &[S; 7],
        qd: &[S; 7],
    ) -> sim_kernel::Dynamics<S, [S; 7], [S; 6]> {
        self.dynamics(t, q, qd)
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
    fn constraints(&self, t: S, q: &[S; 7]) -> [S; 6] {
        self.constraints(t, q)
    }
    #[inline(always)]
    fn constraint_magnitudes(&self, t: S, q: &[S; 7]) -> [S; 6] {
        self.constraint_magnitudes(t, q)
    }
    #[inline(always)]
    fn constraint_jacobian(&self, t: S, q: &[S; 7]) -> [[S; 7]; 6] {
        self.constraint_jacobian(t, q)
    }
    #[inline(always)]
    fn constraint_time_derivative(&self, t: S, q: &[S; 7]) -> [S; 6] {
        self.constraint_time_derivative(t, q)
    }
    #[inline(always)]
    fn constraint_convective(&self, t: S, q: &[S; 7], qd: &[S; 7]) -> [S; 6] {
        self.constraint_convective(t, q, qd)
    }
    #[inline(always)]
    fn constraint_linearization(
        &self,
        t: S,
        q: &[S; 7],
    ) -> sim_kernel::ConstraintLinearization<[S; 6], [[S; 7]; 6]> {
        self.constraint_linearization(t, q)
    }
    #[inline(always)]
    fn kinetic_energy(&self, t: S, q: &[S; 7], qd: &[S; 7]) -> S {
        self.kinetic_energy(t, q, qd)
    }
    #[inline(always)]
    fn power(&self, t: S, q: &[S; 7], qd: &[S; 7], qdd: &[S; 7], lambda: &[S; 6]) -> S {
        self.power(t, q, qd, qdd, lambda)
    }
    #[inline(always)]
    fn outputs(
        &self,
        t: S,
        q: &[S; 7],
        qd: &[S; 7],
        qdd: &[S; 7],
        lambda: &[S; 6],
    ) -> [S; 8] {
        self.outputs(t, q, qd, qdd, lambda).into()
    }
    #[inline(always)]
    fn output_rates(&self, t: S, q: &[S; 7], qd: &[S; 7], qdd: &[S; 7]) -> [S; 7] {
        self.output_rates(t, q, qd, qdd).into()
    }
    #[inline(always)]
    fn events(&self, t: S, q: &[S; 7], qd: &[S; 7]) -> [S; 0] {
        self.events(t, q, qd)
    }
    #[inline(always)]
    fn drawing(&self, t: S, q: &[S; 7]) -> [S; 38] {
        self.drawing(t, q)
    }
    #[inline(always)]
    fn initial(&self) -> sim_kernel::Initial<[S; 7]> {
        self.initial()
    }
}
