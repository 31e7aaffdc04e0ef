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
/// What the equations of motion need of the parameters of [`Andrews`], from [`Andrews::prepare`]; its methods are the kernels of each step.
#[allow(non_snake_case)]
#[derive(
    ::core::clone::Clone,
    ::core::marker::Copy,
    ::core::fmt::Debug,
    ::core::cmp::PartialEq
)]
pub struct AndrewsPrepared<S = ::core::primitive::f64> {
    i2: S,
    m2: S,
    rr: S,
    da: S,
    k: S,
    k_2: S,
    k_3: S,
    mass_Theta_Theta: S,
    i3: S,
    m3: S,
    sa: S,
    sb: S,
    m4: S,
    ee: S,
    k_4: S,
    mass_Phi_Phi: S,
    zt: S,
    k_5: S,
    k_6: S,
    k_7: S,
    k_8: S,
    m5: S,
    ta: S,
    tb: S,
    k_9: S,
    m6: S,
    zf: S,
    k_10: S,
    mass_Omega_Omega: S,
    u: S,
    k_11: S,
    k_12: S,
    k_13: S,
    k_14: S,
    m7: S,
    ua: S,
    ub: S,
    k_15: S,
    d: S,
    ss: S,
    mom: S,
    k_16: S,
    c0: S,
    sc: S,
    sd: S,
    k_17: S,
    k_18: S,
    l0: S,
    k_19: S,
    k_20: S,
    k_21: S,
    k_22: S,
    k_23: S,
    k_24: S,
    k_25: S,
    k_26: S,
    k_27: S,
    inverse_Phi: S,
    inverse_Omega: S,
    k_28: S,
    k_29: S,
}
#[allow(non_snake_case, unused_variables, unused_parens, clippy::all, clippy::pedantic)]
impl<S: sim_kernel::Scalar> Andrews<S> {
    /// What the equations of motion need of the parameters, computed once for a set of parameters.
    ///
    /// Operations: 36 additions, 59 multiplications, 2 divisions.
    #[inline]
    pub fn prepare(&self) -> AndrewsPrepared<S> {
        let w = self.m2 * self.da;
        let w_2 = self.rr * w;
        let w_3 = self.ee - self.ea;
        let mass_Phi_Phi = self.i4 + self.m4 * w_3 * w_3;
        let w_4 = self.ee * S::from_f64(2.0);
        let w_5 = self.m4 * self.zt;
        let w_6 = self.ee * w_5;
        let w_7 = self.ea * w_5;
        let w_8 = self.zf - self.fa;
        let mass_Omega_Omega = self.i6 + self.m6 * w_8 * w_8;
        let w_9 = S::from_f64(2.0) * self.zf;
        let w_10 = self.m6 * self.u;
        let w_11 = self.zf * w_10;
        let w_12 = self.fa * w_10;
        let w_13 = self.c0 * self.sc;
        let w_14 = self.l0 * w_13;
        let w_15 = self.c0 * self.sd;
        let w_16 = self.l0 * w_15;
        AndrewsPrepared {
            i2: self.i2,
            m2: self.m2,
            rr: self.rr,
            da: self.da,
            k: self.i1 + self.i2 + self.m1 * self.ra * self.ra,
            k_2: w,
            k_3: w_2,
            mass_Theta_Theta: self.i2 + self.m2 * self.da * self.da,
            i3: self.i3,
            m3: self.m3,
            sa: self.sa,
            sb: self.sb,
            m4: self.m4,
            ee: self.ee,
            k_4: w_3,
            mass_Phi_Phi: mass_Phi_Phi,
            zt: self.zt,
            k_5: self.m4 * w_3,
            k_6: self.i4 + self.m4 * self.ee * self.ee - self.m4 * self.ea * w_4
                + self.m4 * self.ea * self.ea,
            k_7: w_6 - w_7,
            k_8: w_7 - w_6,
            m5: self.m5,
            ta: self.ta,
            tb: self.tb,
            k_9: self.i4 + self.i5,
            m6: self.m6,
            zf: self.zf,
            k_10: w_8,
            mass_Omega_Omega: mass_Omega_Omega,
            u: self.u,
            k_11: self.m6 * w_8,
            k_12: self.i6 + self.m6 * self.zf * self.zf - self.m6 * self.fa * w_9
                + self.m6 * self.fa * self.fa,
            k_13: w_11 - w_12,
            k_14: w_12 - w_11,
            m7: self.m7,
            ua: self.ua,
            ub: self.ub,
            k_15: self.i6 + self.i7,
            d: self.d,
            ss: self.ss,
            mom: self.mom,
            k_16: w_2 * S::from_f64(2.0),
            c0: self.c0,
            sc: self.sc,
            sd: self.sd,
            k_17: self.xb - self.xc,
            k_18: self.yb - self.yc,
            l0: self.l0,
            k_19: self.xb * w_14 - self.xc * w_14 + self.yb * w_16 - self.yc * w_16,
            k_20: self.xc * w_16 - self.xb * w_16 + self.yb * w_14 - self.yc * w_14,
            k_21: self.xc * w_13 - self.xb * w_13 - self.yb * w_15 + self.yc * w_15,
            k_22: self.xb * w_15 - self.xc * w_15 - self.yb * w_13 + self.yc * w_13,
            k_23: S::from_f64(2.0) * w_7 - w_5 * w_4,
            k_24: w_10 * w_9 - S::from_f64(2.0) * w_12,
            k_25: S::from_f64(2.0) * self.d,
            k_26: w_4,
            k_27: w_9,
            inverse_Phi: S::from_f64(1.0) / mass_Phi_Phi,
            inverse_Omega: S::from_f64(1.0) / mass_Omega_Omega,
            k_28: S::from_f64(2.0) * self.ss,
            k_29: S::from_f64(1.0) + S::from_f64(1.0),
        }
    }
    /// Mass matrix `T_q' M T_q`, 7 x 7, symmetric, in SI units.
    ///
    /// Operations: 52 additions, 82 multiplications, 7 sine-cosine pairs.
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
        let mass_Theta_beta = self.i2 - self.m2 * self.da * (u2_y * w_4 + u2_x * w_5);
        let w_6 = self.sa * u3_x - self.sb * u3_y;
        let w_7 = self.sa * u3_y + u3_x * self.sb;
        let w_8 = self.ee - self.ea;
        let w_9 = self.m4 * self.ee;
        let w_10 = self.i4 + self.m4 * self.ee * self.ee
            - self.ea * S::from_f64(2.0) * w_9 + self.m4 * self.ea * self.ea;
        let w_11 = self.zt * w_9;
        let w_12 = self.m4 * self.ea * self.zt;
        let mass_delta_Phi = w_10 + n4_x * u5_x * (w_11 - w_12)
            + cos_w_2 * u5_y * (w_12 - w_11);
        let w_13 = self.zt * u5_y - w_8 * cos_w_2;
        let w_14 = self.zt * u5_x + w_8 * n4_x;
        let w_15 = u5_y * self.ta + u5_x * self.tb;
        let w_16 = u5_x * self.ta - u5_y * self.tb;
        let w_17 = self.zf - self.fa;
        let w_18 = self.m6 * self.zf;
        let w_19 = self.i6 + self.m6 * self.zf * self.zf
            - S::from_f64(2.0) * self.fa * w_18 + self.m6 * self.fa * self.fa;
        let w_20 = self.u * w_18;
        let w_21 = self.m6 * self.fa * self.u;
        let mass_epsilon_Omega = w_19 + u6_x * u7_y * (w_20 - w_21)
            + u6_y * u7_x * (w_21 - w_20);
        let w_22 = self.u * u7_x - w_17 * u6_y;
        let w_23 = self.u * u7_y + w_17 * u6_x;
        let w_24 = u7_x * self.ua + u7_y * self.ub;
        let w_25 = u7_y * self.ua - u7_x * self.ub;
        [
            [
                self.i1 + self.i2 + self.m1 * self.ra * self.ra
                    + self.m2 * (w_4 * w_4 + w_5 * w_5),
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
                self.i3 + self.m3 * (w_6 * w_6 + w_7 * w_7),
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
                self.i4 + self.i5 + self.m4 * (w_13 * w_13 + w_14 * w_14)
                    + self.m5 * (w_15 * w_15 + w_16 * w_16),
                S::from_f64(0.0),
                S::from_f64(0.0),
            ],
            [
                S::from_f64(0.0),
                S::from_f64(0.0),
                S::from_f64(0.0),
                S::from_f64(0.0),
                S::from_f64(0.0),
                self.i6 + self.m6 * w_17 * w_17,
                mass_epsilon_Omega,
            ],
            [
                S::from_f64(0.0),
                S::from_f64(0.0),
                S::from_f64(0.0),
                S::from_f64(0.0),
                S::from_f64(0.0),
                mass_epsilon_Omega,
                self.i6 + self.i7 + self.m6 * (w_22 * w_22 + w_23 * w_23)
                    + self.m7 * (w_24 * w_24 + w_25 * w_25),
            ],
        ]
    }
    /// Convective forces `T_q' M g`, 7, with `g = (T_q q' + T_t)_q q' + (..)_t`: joules per unit of each coordinate.
    ///
    /// Operations: 16 additions, 49 multiplications, 6 sine-cosine pairs.
    #[inline]
    pub fn convective_forces(&self, t: S, q: &[S; 7], qd: &[S; 7]) -> [S; 7] {
        let [beta, Theta_, _, Phi_, delta, Omega_, epsilon] = *q;
        let [beta_dot, Theta_dot, _, Phi_dot, delta_dot, Omega_dot, epsilon_dot] = *qd;
        let w = self.m2 * self.rr;
        let w_2 = beta + Theta_;
        let w_3 = Phi_ + delta;
        let w_4 = Omega_ + epsilon;
        let (
            [u1_y,
            u2_y,
            n4_x,
            u5_y,
            u6_y,
            u7_y,
            ],
            [u1_x,
            u2_x,
            cos_w_3,
            u5_x,
            u6_x,
            u7_x,
            ],
        ) = S::sin_cos_each([beta, w_2, w_3, delta, w_4, epsilon]);
        let w_5 = u2_y * u1_x - u1_y * u2_x;
        let w_6 = self.da * w;
        let w_7 = self.m4 * self.zt;
        let w_8 = self.ea * w_7;
        let w_9 = self.ee * w_7;
        let w_10 = n4_x * u5_y + cos_w_3 * u5_x;
        let w_11 = self.m6 * self.u;
        let w_12 = self.zf * w_11;
        let w_13 = self.fa * w_11;
        let w_14 = u6_y * u7_y + u6_x * u7_x;
        [
            self.da * S::from_f64(2.0) * w * Theta_dot * beta_dot * w_5
                + w_6 * Theta_dot * Theta_dot * w_5,
            -(w_6 * w_5 * beta_dot * beta_dot),
            S::from_f64(0.0),
            (w_8 - w_9) * delta_dot * delta_dot * w_10,
            w_10
                * (Phi_dot * Phi_dot * (w_9 - w_8)
                    + Phi_dot * delta_dot
                        * (S::from_f64(2.0) * self.ee * w_7
                            - S::from_f64(2.0) * self.ea * w_7)),
            (w_12 - w_13) * epsilon_dot * epsilon_dot * w_14,
            w_14
                * (epsilon_dot * Omega_dot
                    * (S::from_f64(2.0) * self.fa * w_11
                        - S::from_f64(2.0) * self.zf * w_11)
                    + Omega_dot * Omega_dot * (w_13 - w_12)),
        ]
    }
    /// Generalised forces `T_q' F`, 7: joules per unit of each coordinate.
    ///
    /// Operations: 22 additions, 32 multiplications, 1 division, 1 sine-cosine pair, 1 square root.
    #[inline]
    pub fn generalized_forces(&self, t: S, q: &[S; 7], qd: &[S; 7]) -> [S; 7] {
        let [_, _, gamma, _, _, _, _] = *q;
        let ([u3_y], [u3_x]) = S::sin_cos_each([gamma]);
        let w = self.c0 * self.sc;
        let w_2 = self.xb * self.l0;
        let w_3 = self.xc * self.l0;
        let w_4 = self.c0 * self.sd;
        let w_5 = self.yb * self.l0;
        let w_6 = self.yc * self.l0;
        let w_7 = self.xb - self.xc + self.sc * u3_y + self.sd * u3_x;
        let w_8 = self.yb - self.yc - self.sc * u3_x + u3_y * self.sd;
        let w_9 = (w_7 * w_7 + w_8 * w_8).sqrt();
        let w_10 = w_9 * (self.xc * w - self.xb * w - self.yb * w_4 + self.yc * w_4);
        let w_11 = w_9 * (self.xb * w_4 - self.xc * w_4 - self.yb * w + self.yc * w);
        let w_12 = u3_y * (w_4 * w_3 - w_2 * w_4 + w * w_5 - w * w_6 + w_11);
        [
            self.mom,
            S::from_f64(0.0),
            (u3_x * (w * w_2 - w * w_3 + w_4 * w_5 - w_4 * w_6 + w_10) + w_12) / w_9,
            S::from_f64(0.0),
            S::from_f64(0.0),
            S::from_f64(0.0),
            S::from_f64(0.0),
        ]
    }
    /// Constraints `C`, 6, in SI units; zero throughout the motion.
    ///
    /// Operations: 25 additions, 14 multiplications, 7 sine-cosine pairs.
    #[inline]
    pub fn constraints(&self, t: S, q: &[S; 7]) -> [S; 6] {
        let [beta, Theta_, gamma, Phi_, delta, Omega_, epsilon] = *q;
        let w = beta + Theta_;
        let w_2 = delta + Phi_;
        let w_3 = epsilon + Omega_;
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
        let w_4 = self.rr * u1_x;
        let w_5 = self.d * u2_x;
        let w_6 = self.rr * u1_y;
        let w_7 = self.d * u2_y;
        [
            w_4 - self.xb - w_5 - self.ss * u3_y,
            w_6 - self.yb - w_7 + self.ss * u3_x,
            w_4 - w_5 - self.xa - self.zt * u5_x - self.ee * n4_x,
            w_6 - w_7 - self.ya - self.zt * u5_y + self.ee * cos_w_2,
            w_4 - w_5 - self.xa - self.u * u7_y - self.zf * u6_x,
            w_6 - w_7 - self.ya + self.u * u7_x - self.zf * u6_y,
        ]
    }
    /// The sum of the magnitudes of the terms of `C`, 6, in SI units: what its rounding is relative to.
    ///
    /// Operations: 43 additions, 14 multiplications, 7 sine-cosine pairs.
    #[inline]
    pub fn constraint_magnitudes(&self, t: S, q: &[S; 7]) -> [S; 6] {
        let [beta, Theta_, gamma, Phi_, delta, Omega_, epsilon] = *q;
        let w = beta + Theta_;
        let w_2 = delta + Phi_;
        let w_3 = epsilon + Omega_;
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
    /// Constraint Jacobian `C_q`, 6 x 7: units of each constraint per unit of each coordinate.
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
        let loop3_x_by_Theta = u2_y * self.d;
        let loop3_x_by_beta = loop3_x_by_Theta - self.rr * u1_y;
        let minus_loop3_y_by_Theta = u2_x * self.d;
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
                -(u3_x * self.ss),
                S::from_f64(0.0),
                S::from_f64(0.0),
                S::from_f64(0.0),
                S::from_f64(0.0),
            ],
            [
                P_x,
                loop3_y_by_Theta,
                -(u3_y * self.ss),
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
    /// `C_t`, 6, units of `C` per second: the speeds obey `C_q q' + C_t = 0`.
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
    /// `(C_q q' + C_t)_q q' + (..)_t`, 6, units of `C` per second squared: the part of `C''` without accelerations.
    ///
    /// Operations: 28 additions, 36 multiplications, 7 sine-cosine pairs.
    #[inline]
    pub fn constraint_convective(&self, t: S, q: &[S; 7], qd: &[S; 7]) -> [S; 6] {
        let [beta, Theta_, gamma, Phi_, delta, Omega_, epsilon] = *q;
        let [beta_dot, Theta_dot, gamma_dot, Phi_dot, delta_dot, Omega_dot, epsilon_dot,
        ] = *qd;
        let w = beta + Theta_;
        let w_2 = delta + Phi_;
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
        let w_4 = self.d * (Theta_dot + beta_dot);
        let w_5 = Theta_dot * w_4;
        let w_6 = u2_x * w_5;
        let w_10 = w_5 * u2_y;
        let w_7 = beta_dot * self.rr;
        let w_8 = beta_dot * (u1_x * w_7 - u2_x * w_4);
        let w_11 = beta_dot * (w_7 * u1_y - w_4 * u2_y);
        let w_9 = gamma_dot * gamma_dot * self.ss;
        let w_12 = delta_dot * self.zt;
        let w_13 = self.ee * (delta_dot + Phi_dot);
        let w_14 = n4_x * w_13;
        let w_15 = w_13 * cos_w_2;
        let w_16 = self.zf * (Omega_dot + epsilon_dot);
        let w_17 = Omega_dot * w_16;
        let w_18 = epsilon_dot * self.u;
        [
            w_6 - w_8 + u3_y * w_9,
            w_10 - w_11 - w_9 * u3_x,
            w_6 - w_8 + delta_dot * (u5_x * w_12 + w_14) + Phi_dot * w_14,
            w_10 - w_11 - Phi_dot * w_15 + delta_dot * (w_12 * u5_y - w_15),
            w_6 - w_8 + u6_x * w_17 + epsilon_dot * (u7_y * w_18 + u6_x * w_16),
            w_10 - w_11 + w_17 * u6_y - epsilon_dot * (w_18 * u7_x - w_16 * u6_y),
        ]
    }
    /// `C` (6), `C_q` (6 x 7) and `C_t` (6) together, in SI units, for projection.
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
        let w_2 = delta + Phi_;
        let w_3 = epsilon + Omega_;
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
        let w_4 = self.rr * u1_x;
        let minus_loop3_y_by_Theta = self.d * u2_x;
        let minus_loop3_y_by_gamma = self.ss * u3_y;
        let w_5 = self.rr * u1_y;
        let loop3_x_by_Theta = self.d * u2_y;
        let minus_loop3_x_by_gamma = self.ss * u3_x;
        let w_6 = self.zt * u5_x;
        let minus_loop4_y_by_Phi = self.ee * n4_x;
        let w_7 = self.zt * u5_y;
        let minus_loop4_x_by_Phi = self.ee * cos_w_2;
        let w_8 = self.u * u7_y;
        let minus_loop6_y_by_Omega = self.zf * u6_x;
        let w_9 = self.u * u7_x;
        let loop6_x_by_Omega = self.zf * u6_y;
        let loop3_x_by_beta = loop3_x_by_Theta - w_5;
        let P_x = w_4 - minus_loop3_y_by_Theta;
        let loop3_y_by_Theta = -minus_loop3_y_by_Theta;
        sim_kernel::ConstraintLinearization {
            values: [
                w_4 - self.xb - minus_loop3_y_by_Theta - minus_loop3_y_by_gamma,
                w_5 - self.yb - loop3_x_by_Theta + minus_loop3_x_by_gamma,
                w_4 - minus_loop3_y_by_Theta - self.xa - w_6 - minus_loop4_y_by_Phi,
                w_5 - loop3_x_by_Theta - self.ya - w_7 + minus_loop4_x_by_Phi,
                w_4 - minus_loop3_y_by_Theta - self.xa - w_8 - minus_loop6_y_by_Omega,
                w_5 - loop3_x_by_Theta - self.ya + w_9 - loop6_x_by_Omega,
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
                    w_7 - minus_loop4_x_by_Phi,
                    S::from_f64(0.0),
                    S::from_f64(0.0),
                ],
                [
                    P_x,
                    loop3_y_by_Theta,
                    S::from_f64(0.0),
                    -minus_loop4_y_by_Phi,
                    -(w_6 + minus_loop4_y_by_Phi),
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
                    loop6_x_by_Omega - w_9,
                ],
                [
                    P_x,
                    loop3_y_by_Theta,
                    S::from_f64(0.0),
                    S::from_f64(0.0),
                    S::from_f64(0.0),
                    -minus_loop6_y_by_Omega,
                    -(w_8 + minus_loop6_y_by_Omega),
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
    /// Operations: 45 additions, 87 multiplications, 7 sine-cosine pairs.
    #[inline]
    pub fn kinetic_energy(&self, t: S, q: &[S; 7], qd: &[S; 7]) -> S {
        let [beta, Theta_, gamma, Phi_, delta, Omega_, epsilon] = *q;
        let [beta_dot, Theta_dot, gamma_dot, Phi_dot, delta_dot, Omega_dot, epsilon_dot,
        ] = *qd;
        let w = beta + Theta_;
        let w_2 = Phi_ + delta;
        let w_3 = epsilon + Omega_;
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
            cos_w_2,
            u5_x,
            u7_x,
            u6_x,
            ],
        ) = S::sin_cos_each([w, beta, gamma, w_2, delta, epsilon, w_3]);
        let w_4 = self.sa * u3_x - self.sb * u3_y;
        let w_5 = self.sa * u3_y + u3_x * self.sb;
        let w_6 = gamma_dot * gamma_dot
            * (S::from_f64(0.5) * self.i3
                + S::from_f64(0.5) * self.m3 * (w_4 * w_4 + w_5 * w_5));
        let w_7 = u5_y * self.ta + u5_x * self.tb;
        let w_8 = u5_x * self.ta - u5_y * self.tb;
        let w_9 = delta_dot * delta_dot
            * (S::from_f64(0.5) * self.i5
                + S::from_f64(0.5) * self.m5 * (w_7 * w_7 + w_8 * w_8));
        let w_10 = u7_x * self.ua + u7_y * self.ub;
        let w_11 = u7_y * self.ua - u7_x * self.ub;
        let w_12 = epsilon_dot * epsilon_dot
            * (S::from_f64(0.5) * self.i7
                + S::from_f64(0.5) * self.m7 * (w_10 * w_10 + w_11 * w_11));
        let w_13 = Theta_dot * self.da;
        let w_14 = u2_y * w_13 - beta_dot * (self.rr * u1_y - self.da * u2_y);
        let w_15 = beta_dot * (self.rr * u1_x - self.da * u2_x) - w_13 * u2_x;
        let w_16 = self.ee - self.ea;
        let w_17 = Phi_dot * w_16;
        let w_18 = cos_w_2 * w_17 - delta_dot * (self.zt * u5_y - cos_w_2 * w_16);
        let w_19 = w_17 * n4_x + delta_dot * (self.zt * u5_x + w_16 * n4_x);
        let w_20 = S::from_f64(0.5) * self.m4 * (w_18 * w_18 + w_19 * w_19);
        let w_21 = self.zf - self.fa;
        let w_22 = Omega_dot * w_21;
        let w_23 = epsilon_dot * (self.u * u7_x - u6_y * w_21) - u6_y * w_22;
        let w_24 = w_22 * u6_x + epsilon_dot * (self.u * u7_y + w_21 * u6_x);
        let w_25 = S::from_f64(0.5) * self.m6 * (w_23 * w_23 + w_24 * w_24);
        let w_26 = beta_dot * beta_dot
            * (S::from_f64(0.5) * self.i1
                + S::from_f64(0.5) * self.m1 * self.ra * self.ra);
        let w_27 = beta_dot + Theta_dot;
        let w_28 = Phi_dot + delta_dot;
        let w_29 = Omega_dot + epsilon_dot;
        w_6 + w_9 + w_12 + S::from_f64(0.5) * self.m2 * (w_14 * w_14 + w_15 * w_15)
            + w_20 + w_25 + w_26 + w_27 * w_27 * S::from_f64(0.5) * self.i2
            + w_28 * w_28 * S::from_f64(0.5) * self.i4
            + w_29 * w_29 * S::from_f64(0.5) * self.i6
    }
    /// Power of loads and drives, `F' v + lambda' C_t + T_t' (M x'' - F)`, in watts.
    ///
    /// Operations: 12 additions, 12 multiplications, 1 division, 1 sine-cosine pair, 1 square root.
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
        let w_5 = u3_y * self.sd;
        let w_6 = self.yb - self.yc - w_4 + w_5;
        let w_7 = (w_3 * w_3 + w_6 * w_6).sqrt();
        self.c0 * gamma_dot * (self.l0 - w_7)
            * ((w_3 * (w_4 - w_5) + w_6 * (w + w_2)) / w_7) + beta_dot * self.mom
    }
    /// Outputs, 8, in SI units.
    ///
    /// Operations: 12 additions, 9 multiplications, 1 sine-cosine pair, 2 square roots.
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
        let w_2 = self.yb - self.yc - self.sc * u3_x + u3_y * self.sd;
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
    /// Rates of the outputs that depend on neither accelerations nor multipliers, 7, in SI units per second.
    ///
    /// Operations: 12 additions, 12 multiplications, 1 division, 1 sine-cosine pair, 1 square root.
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
        let w = self.sc * u3_y;
        let w_2 = self.sd * u3_x;
        let w_3 = self.xb - self.xc + w + w_2;
        let w_4 = self.sc * u3_x;
        let w_5 = u3_y * self.sd;
        let w_6 = self.yb - self.yc - w_4 + w_5;
        let w_7 = w_3 * w_3 + w_6 * w_6;
        [
            beta_dot,
            gamma_dot,
            Phi_dot + delta_dot,
            delta_dot,
            Omega_dot + epsilon_dot,
            epsilon_dot,
            self.c0 * w_7.sqrt()
                * (w_3 * gamma_dot * (w_4 - w_5) + w_6 * gamma_dot * (w + w_2)) / w_7,
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
        lambda: &[S; 6],
    ) -> [S; 0] {
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
        let D_y = self.yb - self.sc * u3_x + u3_y * self.sd;
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
    /// Declared start: values or guesses of the coordinates (7), and speeds (7), in SI units; 0 where nothing is declared.
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
    /// [`AndrewsPrepared::dynamics`] once; for many calls with the same parameters [`Self::prepare`] first.
    #[inline]
    pub fn dynamics(
        &self,
        t: S,
        q: &[S; 7],
        qd: &[S; 7],
    ) -> sim_kernel::Dynamics<S, [S; 7], [S; 6]> {
        self.prepare().dynamics(t, q, qd)
    }
    /// [`AndrewsPrepared::dynamics_jacobian`] once; for many calls with the same parameters [`Self::prepare`] first.
    #[inline]
    pub fn dynamics_jacobian(
        &self,
        t: S,
        q: &[S; 7],
        qd: &[S; 7],
    ) -> sim_kernel::DynamicsJacobian<S, [[S; 7]; 7], [[S; 7]; 6]> {
        self.prepare().dynamics_jacobian(t, q, qd)
    }
}
#[allow(non_snake_case, unused_variables, unused_parens, clippy::all, clippy::pedantic)]
impl<S: sim_kernel::Scalar> AndrewsPrepared<S> {
    /// Accelerations (7), multipliers (6) and power, from
    ///
    /// ```text
    /// [ T_q' M T_q   C_q' ] [ q''    ]   [ T_q' (F - M g)                      ]
    /// [ C_q          0    ] [ lambda ] = [ -(C_q q' + C_t)_q q' - (..)_t       ]
    /// ```
    ///
    /// by an elimination planned from the structure of the system. Where `refused` is set a pivot was too small and nothing else holds: solve that state from the other kernels.
    ///
    /// Operations: 233 additions, 292 multiplications, 13 divisions, 7 sine-cosine pairs, 1 square root.
    #[inline(always)]
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
        let w_4 = u1_y * u2_x - u2_y * u1_x;
        let Theta_dot_squared = Theta_dot * Theta_dot;
        let rhs_beta = self.mom + self.k_16 * Theta_dot * beta_dot * w_4
            + self.k_3 * Theta_dot_squared * w_4;
        let w_15 = Theta_dot * beta_dot * self.k_25 + self.d * Theta_dot_squared;
        let w_5 = u3_y * self.sc;
        let w_6 = u3_x * self.sd;
        let w_7 = self.k_17 + w_5 + w_6;
        let w_8 = u3_x * self.sc;
        let w_9 = u3_y * self.sd;
        let w_10 = self.k_18 - w_8 + w_9;
        let w_11 = (w_7 * w_7 + w_10 * w_10).sqrt();
        let rhs_gamma = (u3_x * (self.k_19 + w_11 * self.k_21)
            + u3_y * (self.k_20 + w_11 * self.k_22)) / w_11;
        let delta_dot_squared = delta_dot * delta_dot;
        let w_12 = n4_x * u5_y + u5_x * cos_w_2;
        let rhs_Phi = self.k_7 * delta_dot_squared * w_12;
        let minus_loop3_x_by_gamma = u3_x * self.ss;
        let w_13 = self.sa * u3_x - self.sb * u3_y;
        let w_14 = self.sa * u3_y + u3_x * self.sb;
        let mass_gamma_gamma = self.i3 + self.m3 * (w_13 * w_13 + w_14 * w_14);
        let inverse_gamma = S::from_f64(1.0) / mass_gamma_gamma;
        let minus_l_lambda_loop3_x_gamma = minus_loop3_x_by_gamma * inverse_gamma;
        let minus_loop3_y_by_gamma = u3_y * self.ss;
        let gamma_dot_squared = gamma_dot * gamma_dot;
        let w_16 = u2_x * w_15;
        let w_26 = u2_y * w_15;
        let w_17 = self.rr * u1_x;
        let minus_loop3_y_by_Theta = u2_x * self.d;
        let P_x = w_17 - minus_loop3_y_by_Theta;
        let w_21 = w_17 - self.da * u2_x;
        let beta_dot_squared = beta_dot * beta_dot;
        let w_18 = P_x * beta_dot_squared;
        let loop3_x_by_Theta = u2_y * self.d;
        let w_19 = self.rr * u1_y;
        let loop3_x_by_beta = loop3_x_by_Theta - w_19;
        let w_20 = w_19 - self.da * u2_y;
        let mass_beta_beta = self.k + self.m2 * (w_20 * w_20 + w_21 * w_21);
        let mass_Theta_beta = self.i2 - self.k_2 * (u2_y * w_20 + u2_x * w_21);
        let inverse_beta = S::from_f64(1.0) / mass_beta_beta;
        let l_lambda_loop3_x_beta = loop3_x_by_beta * inverse_beta;
        let k_lambda_loop3_x_Theta = loop3_x_by_Theta
            - mass_Theta_beta * l_lambda_loop3_x_beta;
        let w_22 = rhs_beta * l_lambda_loop3_x_beta;
        let l_Theta_beta = mass_Theta_beta * inverse_beta;
        let minus_rhs_Theta = self.k_3 * w_4 * beta_dot_squared
            + rhs_beta * l_Theta_beta;
        let w_25 = loop3_x_by_beta * beta_dot_squared;
        let pivot_Theta = self.mass_Theta_Theta - mass_Theta_beta * l_Theta_beta;
        let inverse_Theta = S::from_f64(1.0) / pivot_Theta;
        let l_lambda_loop3_x_Theta = inverse_Theta * k_lambda_loop3_x_Theta;
        let w_23 = l_lambda_loop3_x_Theta * minus_rhs_Theta;
        let rhs_lambda_loop3_x = rhs_gamma * minus_l_lambda_loop3_x_gamma
            - (minus_loop3_y_by_gamma * gamma_dot_squared + w_16 - w_18) - w_22 + w_23;
        let Phi_dot_squared = Phi_dot * Phi_dot;
        let w_24 = Phi_dot * delta_dot;
        let mass_delta_Phi = self.k_6 + n4_x * u5_x * self.k_7
            + cos_w_2 * u5_y * self.k_8;
        let l_delta_Phi = mass_delta_Phi * self.inverse_Phi;
        let rhs_delta = w_12 * (self.k_8 * Phi_dot_squared + self.k_23 * w_24)
            - rhs_Phi * l_delta_Phi;
        let w_34 = w_24 * self.k_26 + self.ee * Phi_dot_squared;
        let minus_l_lambda_loop3_y_gamma = minus_loop3_y_by_gamma * inverse_gamma;
        let l_lambda_loop3_y_beta = P_x * inverse_beta;
        let minus_k_lambda_loop3_y_Theta = minus_loop3_y_by_Theta
            + mass_Theta_beta * l_lambda_loop3_y_beta;
        let w_27 = rhs_beta * l_lambda_loop3_y_beta;
        let minus_l_lambda_loop3_y_Theta = inverse_Theta * minus_k_lambda_loop3_y_Theta;
        let w_28 = minus_l_lambda_loop3_y_Theta * minus_rhs_Theta;
        let w_29 = loop3_x_by_beta * l_lambda_loop3_x_beta;
        let w_32 = loop3_x_by_beta * l_lambda_loop3_y_beta;
        let w_30 = k_lambda_loop3_x_Theta * l_lambda_loop3_x_Theta;
        let w_31 = k_lambda_loop3_x_Theta * minus_l_lambda_loop3_y_Theta;
        let minus_pivot_lambda_loop3_x = w_29
            + minus_loop3_x_by_gamma * minus_l_lambda_loop3_x_gamma + w_30;
        let minus_inverse_lambda_loop3_x = S::from_f64(1.0) / minus_pivot_lambda_loop3_x;
        let k_lambda_loop3_y_lambda_loop3_x = w_31 - w_32
            - minus_loop3_x_by_gamma * minus_l_lambda_loop3_y_gamma;
        let minus_l_lambda_loop3_y_lambda_loop3_x = minus_inverse_lambda_loop3_x
            * k_lambda_loop3_y_lambda_loop3_x;
        let rhs_lambda_loop3_y = rhs_gamma * minus_l_lambda_loop3_y_gamma
            - (w_25 - minus_loop3_x_by_gamma * gamma_dot_squared + w_26) - w_27 - w_28
            + minus_l_lambda_loop3_y_lambda_loop3_x * rhs_lambda_loop3_x;
        let epsilon_dot_squared = epsilon_dot * epsilon_dot;
        let w_33 = u7_y * u6_y + u6_x * u7_x;
        let rhs_Omega = self.k_14 * epsilon_dot_squared * w_33;
        let w_35 = self.zt * u5_x;
        let minus_loop4_y_by_Phi = self.ee * n4_x;
        let minus_loop4_y_by_delta = w_35 + minus_loop4_y_by_Phi;
        let w_39 = w_35 + self.k_4 * n4_x;
        let minus_loop4_x_by_Phi = self.ee * cos_w_2;
        let minus_l_lambda_loop4_x_Phi = minus_loop4_x_by_Phi * self.inverse_Phi;
        let minus_k_lambda_loop4_x_lambda_loop3_x = w_29 + w_30;
        let l_lambda_loop4_x_lambda_loop3_x = minus_inverse_lambda_loop3_x
            * minus_k_lambda_loop4_x_lambda_loop3_x;
        let w_36 = l_lambda_loop4_x_lambda_loop3_x * rhs_lambda_loop3_x;
        let w_37 = self.zt * u5_y;
        let w_38 = w_37 - self.k_4 * cos_w_2;
        let loop4_x_by_delta = w_37 - minus_loop4_x_by_Phi;
        let w_40 = u5_y * self.ta + u5_x * self.tb;
        let w_41 = u5_x * self.ta - u5_y * self.tb;
        let mass_delta_delta = self.k_9 + self.m4 * (w_38 * w_38 + w_39 * w_39)
            + self.m5 * (w_40 * w_40 + w_41 * w_41);
        let pivot_delta = mass_delta_delta - mass_delta_Phi * l_delta_Phi;
        let inverse_delta = S::from_f64(1.0) / pivot_delta;
        let k_lambda_loop4_x_delta = loop4_x_by_delta
            + mass_delta_Phi * minus_l_lambda_loop4_x_Phi;
        let l_lambda_loop4_x_delta = inverse_delta * k_lambda_loop4_x_delta;
        let w_42 = P_x * l_lambda_loop3_y_beta;
        let w_46 = P_x * l_lambda_loop3_x_beta;
        let w_43 = minus_k_lambda_loop3_y_Theta * minus_l_lambda_loop3_y_Theta;
        let w_44 = w_42 + minus_loop3_y_by_gamma * minus_l_lambda_loop3_y_gamma + w_43;
        let w_45 = minus_k_lambda_loop3_y_Theta * l_lambda_loop3_x_Theta;
        let pivot_lambda_loop3_y = k_lambda_loop3_y_lambda_loop3_x
            * minus_l_lambda_loop3_y_lambda_loop3_x - w_44;
        let inverse_lambda_loop3_y = S::from_f64(1.0) / pivot_lambda_loop3_y;
        let k_lambda_loop4_x_lambda_loop3_y = w_45 - w_46
            - k_lambda_loop3_y_lambda_loop3_x * l_lambda_loop4_x_lambda_loop3_x;
        let l_lambda_loop4_x_lambda_loop3_y = inverse_lambda_loop3_y
            * k_lambda_loop4_x_lambda_loop3_y;
        let w_47 = l_lambda_loop4_x_lambda_loop3_y * rhs_lambda_loop3_y;
        let rhs_lambda_loop4_x = w_23
            - (w_16 - w_18 + n4_x * w_34 + minus_loop4_y_by_delta * delta_dot_squared)
            - w_22 + rhs_Phi * minus_l_lambda_loop4_x_Phi - w_36
            - l_lambda_loop4_x_delta * rhs_delta - w_47;
        let w_48 = epsilon_dot * Omega_dot;
        let Omega_dot_squared = Omega_dot * Omega_dot;
        let mass_epsilon_Omega = self.k_12 + u6_x * u7_y * self.k_13
            + u6_y * u7_x * self.k_14;
        let l_epsilon_Omega = mass_epsilon_Omega * self.inverse_Omega;
        let rhs_epsilon = w_33 * (self.k_24 * w_48 + self.k_13 * Omega_dot_squared)
            - rhs_Omega * l_epsilon_Omega;
        let w_56 = self.zf * Omega_dot_squared + w_48 * self.k_27;
        let minus_l_lambda_loop4_y_Phi = minus_loop4_y_by_Phi * self.inverse_Phi;
        let k_lambda_loop4_y_delta = mass_delta_Phi * minus_l_lambda_loop4_y_Phi
            - minus_loop4_y_by_delta;
        let k_lambda_loop4_y_lambda_loop3_x = w_31 - w_32;
        let minus_l_lambda_loop4_y_lambda_loop3_x = minus_inverse_lambda_loop3_x
            * k_lambda_loop4_y_lambda_loop3_x;
        let k_lambda_loop4_y_lambda_loop3_y = k_lambda_loop3_y_lambda_loop3_x
            * minus_l_lambda_loop4_y_lambda_loop3_x - w_42 - w_43;
        let w_49 = minus_l_lambda_loop4_y_lambda_loop3_x * rhs_lambda_loop3_x;
        let l_lambda_loop4_y_delta = inverse_delta * k_lambda_loop4_y_delta;
        let w_64 = w_42 + w_43 + minus_loop4_y_by_Phi * minus_l_lambda_loop4_y_Phi
            + k_lambda_loop4_y_delta * l_lambda_loop4_y_delta;
        let l_lambda_loop4_y_lambda_loop3_y = inverse_lambda_loop3_y
            * k_lambda_loop4_y_lambda_loop3_y;
        let w_50 = l_lambda_loop4_y_lambda_loop3_y * rhs_lambda_loop3_y;
        let w_51 = minus_k_lambda_loop4_x_lambda_loop3_x
            * l_lambda_loop4_x_lambda_loop3_x;
        let w_54 = minus_k_lambda_loop4_x_lambda_loop3_x
            * minus_l_lambda_loop4_y_lambda_loop3_x;
        let w_52 = w_29 + w_30 + minus_loop4_x_by_Phi * minus_l_lambda_loop4_x_Phi
            + k_lambda_loop4_x_delta * l_lambda_loop4_x_delta;
        let w_53 = k_lambda_loop4_x_lambda_loop3_y * l_lambda_loop4_x_lambda_loop3_y;
        let w_55 = k_lambda_loop4_x_lambda_loop3_y * l_lambda_loop4_y_lambda_loop3_y;
        let k_lambda_loop4_y_lambda_loop4_x = w_31 - w_32
            - minus_loop4_x_by_Phi * minus_l_lambda_loop4_y_Phi - w_54
            - k_lambda_loop4_x_delta * l_lambda_loop4_y_delta - w_55;
        let pivot_lambda_loop4_x = w_51 - w_52 - w_53;
        let inverse_lambda_loop4_x = S::from_f64(1.0) / pivot_lambda_loop4_x;
        let l_lambda_loop4_y_lambda_loop4_x = inverse_lambda_loop4_x
            * k_lambda_loop4_y_lambda_loop4_x;
        let rhs_lambda_loop4_y = rhs_Phi * minus_l_lambda_loop4_y_Phi
            - (w_25 + w_26 - cos_w_2 * w_34 + loop4_x_by_delta * delta_dot_squared)
            - w_27 - w_28 + w_49 - l_lambda_loop4_y_delta * rhs_delta - w_50
            - l_lambda_loop4_y_lambda_loop4_x * rhs_lambda_loop4_x;
        let w_57 = self.u * u7_y;
        let minus_loop6_y_by_Omega = self.zf * u6_x;
        let minus_loop6_y_by_epsilon = w_57 + minus_loop6_y_by_Omega;
        let w_60 = w_57 + self.k_10 * u6_x;
        let loop6_x_by_Omega = self.zf * u6_y;
        let l_lambda_loop6_x_Omega = loop6_x_by_Omega * self.inverse_Omega;
        let k_lambda_loop6_x_lambda_loop4_x = w_51 - w_29 - w_30 - w_53;
        let l_lambda_loop6_x_lambda_loop4_x = inverse_lambda_loop4_x
            * k_lambda_loop6_x_lambda_loop4_x;
        let k_lambda_loop6_x_lambda_loop4_y = w_45 - w_46
            - k_lambda_loop4_y_lambda_loop3_x * l_lambda_loop4_x_lambda_loop3_x
            - k_lambda_loop4_y_lambda_loop3_y * l_lambda_loop4_x_lambda_loop3_y
            - k_lambda_loop4_y_lambda_loop4_x * l_lambda_loop6_x_lambda_loop4_x;
        let w_63 = k_lambda_loop4_y_lambda_loop3_x
            * minus_l_lambda_loop4_y_lambda_loop3_x;
        let w_65 = k_lambda_loop4_y_lambda_loop3_y * l_lambda_loop4_y_lambda_loop3_y;
        let w_58 = self.u * u7_x;
        let w_59 = w_58 - self.k_10 * u6_y;
        let loop6_x_by_epsilon = loop6_x_by_Omega - w_58;
        let w_61 = u7_x * self.ua + u7_y * self.ub;
        let w_62 = u7_y * self.ua - u7_x * self.ub;
        let mass_epsilon_epsilon = self.k_15 + self.m6 * (w_59 * w_59 + w_60 * w_60)
            + self.m7 * (w_61 * w_61 + w_62 * w_62);
        let pivot_epsilon = mass_epsilon_epsilon - mass_epsilon_Omega * l_epsilon_Omega;
        let inverse_epsilon = S::from_f64(1.0) / pivot_epsilon;
        let k_lambda_loop6_x_epsilon = loop6_x_by_epsilon
            - mass_epsilon_Omega * l_lambda_loop6_x_Omega;
        let l_lambda_loop6_x_epsilon = inverse_epsilon * k_lambda_loop6_x_epsilon;
        let w_66 = w_29 + w_30 + loop6_x_by_Omega * l_lambda_loop6_x_Omega
            + k_lambda_loop6_x_epsilon * l_lambda_loop6_x_epsilon;
        let pivot_lambda_loop4_y = w_63 - w_64 - w_65
            - k_lambda_loop4_y_lambda_loop4_x * l_lambda_loop4_y_lambda_loop4_x;
        let inverse_lambda_loop4_y = S::from_f64(1.0) / pivot_lambda_loop4_y;
        let l_lambda_loop6_x_lambda_loop4_y = inverse_lambda_loop4_y
            * k_lambda_loop6_x_lambda_loop4_y;
        let rhs_lambda_loop6_x = w_23
            - (w_16 - w_18 + u6_x * w_56
                + minus_loop6_y_by_epsilon * epsilon_dot_squared) - w_22 - w_36 - w_47
            - rhs_Omega * l_lambda_loop6_x_Omega
            - l_lambda_loop6_x_lambda_loop4_x * rhs_lambda_loop4_x
            - l_lambda_loop6_x_epsilon * rhs_epsilon
            - l_lambda_loop6_x_lambda_loop4_y * rhs_lambda_loop4_y;
        let pivot_lambda_loop6_x = w_51 - w_66 - w_53
            - k_lambda_loop6_x_lambda_loop4_x * l_lambda_loop6_x_lambda_loop4_x
            - k_lambda_loop6_x_lambda_loop4_y * l_lambda_loop6_x_lambda_loop4_y;
        let minus_l_lambda_loop6_y_Omega = minus_loop6_y_by_Omega * self.inverse_Omega;
        let k_lambda_loop6_y_epsilon = mass_epsilon_Omega * minus_l_lambda_loop6_y_Omega
            - minus_loop6_y_by_epsilon;
        let k_lambda_loop6_y_lambda_loop4_x = w_31 - w_32 - w_54 - w_55;
        let l_lambda_loop6_y_lambda_loop4_x = inverse_lambda_loop4_x
            * k_lambda_loop6_y_lambda_loop4_x;
        let k_lambda_loop6_y_lambda_loop4_y = w_63 - w_42 - w_43 - w_65
            - k_lambda_loop4_y_lambda_loop4_x * l_lambda_loop6_y_lambda_loop4_x;
        let l_lambda_loop6_y_epsilon = inverse_epsilon * k_lambda_loop6_y_epsilon;
        let w_67 = w_42 + w_43 + minus_loop6_y_by_Omega * minus_l_lambda_loop6_y_Omega
            + k_lambda_loop6_y_epsilon * l_lambda_loop6_y_epsilon;
        let l_lambda_loop6_y_lambda_loop4_y = inverse_lambda_loop4_y
            * k_lambda_loop6_y_lambda_loop4_y;
        let k_lambda_loop6_y_lambda_loop6_x = w_31 - w_32 - w_54 - w_55
            + loop6_x_by_Omega * minus_l_lambda_loop6_y_Omega
            - k_lambda_loop6_x_lambda_loop4_x * l_lambda_loop6_y_lambda_loop4_x
            - k_lambda_loop6_x_epsilon * l_lambda_loop6_y_epsilon
            - k_lambda_loop6_x_lambda_loop4_y * l_lambda_loop6_y_lambda_loop4_y;
        let inverse_lambda_loop6_x = S::from_f64(1.0) / pivot_lambda_loop6_x;
        let l_lambda_loop6_y_lambda_loop6_x = inverse_lambda_loop6_x
            * k_lambda_loop6_y_lambda_loop6_x;
        let rhs_lambda_loop6_y = w_49
            - (w_25 + w_26 + u6_y * w_56 + loop6_x_by_epsilon * epsilon_dot_squared)
            - w_27 - w_28 - w_50 + rhs_Omega * minus_l_lambda_loop6_y_Omega
            - l_lambda_loop6_y_lambda_loop4_x * rhs_lambda_loop4_x
            - l_lambda_loop6_y_epsilon * rhs_epsilon
            - l_lambda_loop6_y_lambda_loop4_y * rhs_lambda_loop4_y
            - l_lambda_loop6_y_lambda_loop6_x * rhs_lambda_loop6_x;
        let pivot_lambda_loop6_y = w_63 - w_67 - w_65
            - k_lambda_loop6_y_lambda_loop4_x * l_lambda_loop6_y_lambda_loop4_x
            - k_lambda_loop6_y_lambda_loop4_y * l_lambda_loop6_y_lambda_loop4_y
            - k_lambda_loop6_y_lambda_loop6_x * l_lambda_loop6_y_lambda_loop6_x;
        let lambda_loop6_y = S::from_f64(1.0) / pivot_lambda_loop6_y
            * rhs_lambda_loop6_y;
        let lambda_loop6_x = inverse_lambda_loop6_x * rhs_lambda_loop6_x
            - l_lambda_loop6_y_lambda_loop6_x * lambda_loop6_y;
        let lambda_loop4_y = inverse_lambda_loop4_y * rhs_lambda_loop4_y
            - l_lambda_loop6_x_lambda_loop4_y * lambda_loop6_x
            - l_lambda_loop6_y_lambda_loop4_y * lambda_loop6_y;
        let lambda_loop4_x = inverse_lambda_loop4_x * rhs_lambda_loop4_x
            - l_lambda_loop4_y_lambda_loop4_x * lambda_loop4_y
            - l_lambda_loop6_x_lambda_loop4_x * lambda_loop6_x
            - l_lambda_loop6_y_lambda_loop4_x * lambda_loop6_y;
        let lambda_loop3_y = inverse_lambda_loop3_y * rhs_lambda_loop3_y
            - l_lambda_loop4_x_lambda_loop3_y * lambda_loop4_x
            - l_lambda_loop4_y_lambda_loop3_y * lambda_loop4_y
            - l_lambda_loop4_x_lambda_loop3_y * lambda_loop6_x
            - l_lambda_loop4_y_lambda_loop3_y * lambda_loop6_y;
        let lambda_loop3_x = minus_l_lambda_loop3_y_lambda_loop3_x * lambda_loop3_y
            - minus_inverse_lambda_loop3_x * rhs_lambda_loop3_x
            - l_lambda_loop4_x_lambda_loop3_x * lambda_loop4_x
            + minus_l_lambda_loop4_y_lambda_loop3_x * lambda_loop4_y
            - l_lambda_loop4_x_lambda_loop3_x * lambda_loop6_x
            + minus_l_lambda_loop4_y_lambda_loop3_x * lambda_loop6_y;
        let Theta_ddot = minus_l_lambda_loop3_y_Theta * lambda_loop3_y
            - inverse_Theta * minus_rhs_Theta - l_lambda_loop3_x_Theta * lambda_loop3_x
            - l_lambda_loop3_x_Theta * lambda_loop4_x
            + minus_l_lambda_loop3_y_Theta * lambda_loop4_y
            - l_lambda_loop3_x_Theta * lambda_loop6_x
            + minus_l_lambda_loop3_y_Theta * lambda_loop6_y;
        let delta_ddot = inverse_delta * rhs_delta
            - l_lambda_loop4_x_delta * lambda_loop4_x
            - l_lambda_loop4_y_delta * lambda_loop4_y;
        let epsilon_ddot = inverse_epsilon * rhs_epsilon
            - l_lambda_loop6_x_epsilon * lambda_loop6_x
            - l_lambda_loop6_y_epsilon * lambda_loop6_y;
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
                rhs_Phi * self.inverse_Phi - l_delta_Phi * delta_ddot
                    + minus_l_lambda_loop4_x_Phi * lambda_loop4_x
                    + minus_l_lambda_loop4_y_Phi * lambda_loop4_y,
                delta_ddot,
                rhs_Omega * self.inverse_Omega - l_epsilon_Omega * epsilon_ddot
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
            power: self.mom * beta_dot
                + gamma_dot * self.c0 * (self.l0 - w_11)
                    * (w_7 * (w_8 - w_9) + w_10 * (w_5 + w_6)) / w_11,
            refused: sim_kernel::pivot_is_refused(mass_beta_beta, mass_beta_beta)
                | sim_kernel::pivot_is_refused(mass_gamma_gamma, mass_gamma_gamma)
                | sim_kernel::pivot_is_refused(pivot_Theta, self.mass_Theta_Theta)
                | sim_kernel::pivot_is_refused(self.mass_Phi_Phi, self.mass_Phi_Phi)
                | sim_kernel::pivot_is_refused(
                    -minus_pivot_lambda_loop3_x,
                    minus_pivot_lambda_loop3_x,
                ) | sim_kernel::pivot_is_refused(pivot_delta, mass_delta_delta)
                | sim_kernel::pivot_is_refused(pivot_lambda_loop3_y, w_44)
                | sim_kernel::pivot_is_refused(
                    self.mass_Omega_Omega,
                    self.mass_Omega_Omega,
                ) | sim_kernel::pivot_is_refused(pivot_lambda_loop4_x, w_52)
                | sim_kernel::pivot_is_refused(pivot_epsilon, mass_epsilon_epsilon)
                | sim_kernel::pivot_is_refused(pivot_lambda_loop4_y, w_64)
                | sim_kernel::pivot_is_refused(pivot_lambda_loop6_x, w_66)
                | sim_kernel::pivot_is_refused(pivot_lambda_loop6_y, w_67),
        }
    }
    /// The derivatives of accelerations (7 rows) and multipliers (6 rows) with respect to coordinates and speeds (7 columns each): with the equations of motion as `K z = r`, the solutions of `K dz = dr - dK z`. Where `refused` is set a pivot was too small and nothing else holds.
    ///
    /// Operations: 1068 additions, 1364 multiplications, 15 divisions, 7 sine-cosine pairs, 1 square root.
    #[inline]
    pub fn dynamics_jacobian(
        &self,
        t: S,
        q: &[S; 7],
        qd: &[S; 7],
    ) -> sim_kernel::DynamicsJacobian<S, [[S; 7]; 7], [[S; 7]; 6]> {
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
        let w_4 = u1_y * u2_x - u2_y * u1_x;
        let Theta_dot_squared = Theta_dot * Theta_dot;
        let rhs_beta = self.mom + self.k_16 * Theta_dot * beta_dot * w_4
            + self.k_3 * Theta_dot_squared * w_4;
        let w_15 = Theta_dot * beta_dot * self.k_25 + self.d * Theta_dot_squared;
        let w_5 = u3_y * self.sc;
        let w_6 = u3_x * self.sd;
        let w_7 = self.k_17 + w_5 + w_6;
        let w_136 = w_5 + w_6;
        let w_8 = u3_x * self.sc;
        let w_9 = u3_y * self.sd;
        let w_10 = self.k_18 - w_8 + w_9;
        let w_135 = w_8 - w_9;
        let w_11 = w_7 * w_7 + w_10 * w_10;
        let sqrt_w_11 = w_11.sqrt();
        let rhs_gamma = (u3_x * (self.k_19 + sqrt_w_11 * self.k_21)
            + u3_y * (self.k_20 + sqrt_w_11 * self.k_22)) / sqrt_w_11;
        let delta_dot_squared = delta_dot * delta_dot;
        let w_12 = n4_x * u5_y + u5_x * cos_w_2;
        let rhs_Phi = self.k_7 * delta_dot_squared * w_12;
        let minus_loop3_x_by_gamma = u3_x * self.ss;
        let w_13 = self.sa * u3_x - self.sb * u3_y;
        let w_14 = self.sa * u3_y + u3_x * self.sb;
        let mass_gamma_gamma = self.i3 + self.m3 * (w_13 * w_13 + w_14 * w_14);
        let w_302 = self.m3 * (w_13 * w_14 * gamma_dot - w_14 * w_13 * gamma_dot);
        let inverse_gamma = S::from_f64(1.0) / mass_gamma_gamma;
        let minus_l_lambda_loop3_x_gamma = minus_loop3_x_by_gamma * inverse_gamma;
        let minus_loop3_y_by_gamma = u3_y * self.ss;
        let gamma_dot_squared = gamma_dot * gamma_dot;
        let w_16 = u2_x * w_15;
        let w_27 = u2_y * w_15;
        let w_17 = self.rr * u1_x;
        let minus_loop3_y_by_Theta = u2_x * self.d;
        let P_x = w_17 - minus_loop3_y_by_Theta;
        let beta_dot_squared = beta_dot * beta_dot;
        let w_18 = P_x * beta_dot_squared;
        let loop3_x_by_Theta = u2_y * self.d;
        let w_19 = self.rr * u1_y;
        let loop3_x_by_beta = loop3_x_by_Theta - w_19;
        let w_20 = self.da * u2_y;
        let w_21 = w_19 - w_20;
        let w_22 = w_17 - self.da * u2_x;
        let mass_beta_beta = self.k + self.m2 * (w_21 * w_21 + w_22 * w_22);
        let inverse_beta = S::from_f64(1.0) / mass_beta_beta;
        let l_lambda_loop3_x_beta = loop3_x_by_beta * inverse_beta;
        let w_23 = rhs_beta * l_lambda_loop3_x_beta;
        let mass_Theta_beta = self.i2 - self.k_2 * (u2_y * w_21 + u2_x * w_22);
        let l_Theta_beta = mass_Theta_beta * inverse_beta;
        let minus_rhs_Theta = self.k_3 * w_4 * beta_dot_squared
            + rhs_beta * l_Theta_beta;
        let w_26 = loop3_x_by_beta * beta_dot_squared;
        let pivot_Theta = self.mass_Theta_Theta - mass_Theta_beta * l_Theta_beta;
        let inverse_Theta = S::from_f64(1.0) / pivot_Theta;
        let k_lambda_loop3_x_Theta = loop3_x_by_Theta
            - mass_Theta_beta * l_lambda_loop3_x_beta;
        let l_lambda_loop3_x_Theta = inverse_Theta * k_lambda_loop3_x_Theta;
        let w_24 = l_lambda_loop3_x_Theta * minus_rhs_Theta;
        let rhs_lambda_loop3_x = rhs_gamma * minus_l_lambda_loop3_x_gamma
            - (minus_loop3_y_by_gamma * gamma_dot_squared + w_16 - w_18) - w_23 + w_24;
        let Phi_dot_squared = Phi_dot * Phi_dot;
        let w_25 = Phi_dot * delta_dot;
        let mass_delta_Phi = self.k_6 + n4_x * u5_x * self.k_7
            + cos_w_2 * u5_y * self.k_8;
        let l_delta_Phi = mass_delta_Phi * self.inverse_Phi;
        let rhs_delta = w_12 * (self.k_8 * Phi_dot_squared + self.k_23 * w_25)
            - rhs_Phi * l_delta_Phi;
        let w_35 = w_25 * self.k_26 + self.ee * Phi_dot_squared;
        let minus_l_lambda_loop3_y_gamma = minus_loop3_y_by_gamma * inverse_gamma;
        let l_lambda_loop3_y_beta = P_x * inverse_beta;
        let minus_k_lambda_loop3_y_Theta = minus_loop3_y_by_Theta
            + mass_Theta_beta * l_lambda_loop3_y_beta;
        let w_28 = rhs_beta * l_lambda_loop3_y_beta;
        let minus_l_lambda_loop3_y_Theta = inverse_Theta * minus_k_lambda_loop3_y_Theta;
        let w_29 = minus_l_lambda_loop3_y_Theta * minus_rhs_Theta;
        let w_30 = loop3_x_by_beta * l_lambda_loop3_x_beta;
        let w_33 = loop3_x_by_beta * l_lambda_loop3_y_beta;
        let w_31 = k_lambda_loop3_x_Theta * l_lambda_loop3_x_Theta;
        let w_32 = k_lambda_loop3_x_Theta * minus_l_lambda_loop3_y_Theta;
        let minus_pivot_lambda_loop3_x = w_30
            + minus_loop3_x_by_gamma * minus_l_lambda_loop3_x_gamma + w_31;
        let minus_inverse_lambda_loop3_x = S::from_f64(1.0) / minus_pivot_lambda_loop3_x;
        let k_lambda_loop3_y_lambda_loop3_x = w_32 - w_33
            - minus_loop3_x_by_gamma * minus_l_lambda_loop3_y_gamma;
        let minus_l_lambda_loop3_y_lambda_loop3_x = minus_inverse_lambda_loop3_x
            * k_lambda_loop3_y_lambda_loop3_x;
        let rhs_lambda_loop3_y = rhs_gamma * minus_l_lambda_loop3_y_gamma
            - (w_26 - minus_loop3_x_by_gamma * gamma_dot_squared + w_27) - w_28 - w_29
            + minus_l_lambda_loop3_y_lambda_loop3_x * rhs_lambda_loop3_x;
        let epsilon_dot_squared = epsilon_dot * epsilon_dot;
        let w_34 = u7_y * u6_y + u6_x * u7_x;
        let rhs_Omega = self.k_14 * epsilon_dot_squared * w_34;
        let w_36 = self.zt * u5_x;
        let minus_loop4_y_by_Phi = self.ee * n4_x;
        let minus_loop4_y_by_delta = w_36 + minus_loop4_y_by_Phi;
        let minus_loop4_x_by_Phi = self.ee * cos_w_2;
        let minus_l_lambda_loop4_x_Phi = minus_loop4_x_by_Phi * self.inverse_Phi;
        let minus_k_lambda_loop4_x_lambda_loop3_x = w_30 + w_31;
        let l_lambda_loop4_x_lambda_loop3_x = minus_inverse_lambda_loop3_x
            * minus_k_lambda_loop4_x_lambda_loop3_x;
        let w_37 = l_lambda_loop4_x_lambda_loop3_x * rhs_lambda_loop3_x;
        let w_38 = self.zt * u5_y;
        let w_39 = w_38 - self.k_4 * cos_w_2;
        let w_40 = self.k_4 * n4_x;
        let w_41 = w_36 + w_40;
        let w_42 = u5_y * self.ta + u5_x * self.tb;
        let w_43 = u5_x * self.ta - u5_y * self.tb;
        let mass_delta_delta = self.k_9 + self.m4 * (w_39 * w_39 + w_41 * w_41)
            + self.m5 * (w_42 * w_42 + w_43 * w_43);
        let pivot_delta = mass_delta_delta - mass_delta_Phi * l_delta_Phi;
        let inverse_delta = S::from_f64(1.0) / pivot_delta;
        let loop4_x_by_delta = w_38 - minus_loop4_x_by_Phi;
        let k_lambda_loop4_x_delta = loop4_x_by_delta
            + mass_delta_Phi * minus_l_lambda_loop4_x_Phi;
        let l_lambda_loop4_x_delta = inverse_delta * k_lambda_loop4_x_delta;
        let w_44 = P_x * l_lambda_loop3_y_beta;
        let w_45 = minus_k_lambda_loop3_y_Theta * minus_l_lambda_loop3_y_Theta;
        let w_46 = w_44 + minus_loop3_y_by_gamma * minus_l_lambda_loop3_y_gamma + w_45;
        let w_47 = minus_k_lambda_loop3_y_Theta * l_lambda_loop3_x_Theta;
        let pivot_lambda_loop3_y = k_lambda_loop3_y_lambda_loop3_x
            * minus_l_lambda_loop3_y_lambda_loop3_x - w_46;
        let inverse_lambda_loop3_y = S::from_f64(1.0) / pivot_lambda_loop3_y;
        let w_48 = P_x * l_lambda_loop3_x_beta;
        let k_lambda_loop4_x_lambda_loop3_y = w_47 - w_48
            - k_lambda_loop3_y_lambda_loop3_x * l_lambda_loop4_x_lambda_loop3_x;
        let l_lambda_loop4_x_lambda_loop3_y = inverse_lambda_loop3_y
            * k_lambda_loop4_x_lambda_loop3_y;
        let w_49 = l_lambda_loop4_x_lambda_loop3_y * rhs_lambda_loop3_y;
        let rhs_lambda_loop4_x = w_24
            - (w_16 - w_18 + n4_x * w_35 + minus_loop4_y_by_delta * delta_dot_squared)
            - w_23 + rhs_Phi * minus_l_lambda_loop4_x_Phi - w_37
            - l_lambda_loop4_x_delta * rhs_delta - w_49;
        let w_50 = epsilon_dot * Omega_dot;
        let Omega_dot_squared = Omega_dot * Omega_dot;
        let mass_epsilon_Omega = self.k_12 + u6_x * u7_y * self.k_13
            + u6_y * u7_x * self.k_14;
        let l_epsilon_Omega = mass_epsilon_Omega * self.inverse_Omega;
        let rhs_epsilon = w_34 * (self.k_24 * w_50 + self.k_13 * Omega_dot_squared)
            - rhs_Omega * l_epsilon_Omega;
        let w_58 = self.zf * Omega_dot_squared + w_50 * self.k_27;
        let minus_l_lambda_loop4_y_Phi = minus_loop4_y_by_Phi * self.inverse_Phi;
        let k_lambda_loop4_y_delta = mass_delta_Phi * minus_l_lambda_loop4_y_Phi
            - minus_loop4_y_by_delta;
        let k_lambda_loop4_y_lambda_loop3_x = w_32 - w_33;
        let minus_l_lambda_loop4_y_lambda_loop3_x = minus_inverse_lambda_loop3_x
            * k_lambda_loop4_y_lambda_loop3_x;
        let k_lambda_loop4_y_lambda_loop3_y = k_lambda_loop3_y_lambda_loop3_x
            * minus_l_lambda_loop4_y_lambda_loop3_x - w_44 - w_45;
        let w_51 = minus_l_lambda_loop4_y_lambda_loop3_x * rhs_lambda_loop3_x;
        let l_lambda_loop4_y_delta = inverse_delta * k_lambda_loop4_y_delta;
        let w_67 = w_44 + w_45 + minus_loop4_y_by_Phi * minus_l_lambda_loop4_y_Phi
            + k_lambda_loop4_y_delta * l_lambda_loop4_y_delta;
        let l_lambda_loop4_y_lambda_loop3_y = inverse_lambda_loop3_y
            * k_lambda_loop4_y_lambda_loop3_y;
        let w_52 = l_lambda_loop4_y_lambda_loop3_y * rhs_lambda_loop3_y;
        let w_53 = minus_k_lambda_loop4_x_lambda_loop3_x
            * l_lambda_loop4_x_lambda_loop3_x;
        let w_56 = minus_k_lambda_loop4_x_lambda_loop3_x
            * minus_l_lambda_loop4_y_lambda_loop3_x;
        let w_54 = w_30 + w_31 + minus_loop4_x_by_Phi * minus_l_lambda_loop4_x_Phi
            + k_lambda_loop4_x_delta * l_lambda_loop4_x_delta;
        let w_55 = k_lambda_loop4_x_lambda_loop3_y * l_lambda_loop4_x_lambda_loop3_y;
        let w_57 = k_lambda_loop4_x_lambda_loop3_y * l_lambda_loop4_y_lambda_loop3_y;
        let k_lambda_loop4_y_lambda_loop4_x = w_32 - w_33
            - minus_loop4_x_by_Phi * minus_l_lambda_loop4_y_Phi - w_56
            - k_lambda_loop4_x_delta * l_lambda_loop4_y_delta - w_57;
        let pivot_lambda_loop4_x = w_53 - w_54 - w_55;
        let inverse_lambda_loop4_x = S::from_f64(1.0) / pivot_lambda_loop4_x;
        let l_lambda_loop4_y_lambda_loop4_x = inverse_lambda_loop4_x
            * k_lambda_loop4_y_lambda_loop4_x;
        let rhs_lambda_loop4_y = rhs_Phi * minus_l_lambda_loop4_y_Phi
            - (w_26 + w_27 - cos_w_2 * w_35 + loop4_x_by_delta * delta_dot_squared)
            - w_28 - w_29 + w_51 - l_lambda_loop4_y_delta * rhs_delta - w_52
            - l_lambda_loop4_y_lambda_loop4_x * rhs_lambda_loop4_x;
        let w_59 = self.u * u7_y;
        let minus_loop6_y_by_Omega = self.zf * u6_x;
        let minus_loop6_y_by_epsilon = w_59 + minus_loop6_y_by_Omega;
        let loop6_x_by_Omega = self.zf * u6_y;
        let l_lambda_loop6_x_Omega = loop6_x_by_Omega * self.inverse_Omega;
        let k_lambda_loop6_x_lambda_loop4_x = w_53 - w_30 - w_31 - w_55;
        let l_lambda_loop6_x_lambda_loop4_x = inverse_lambda_loop4_x
            * k_lambda_loop6_x_lambda_loop4_x;
        let k_lambda_loop6_x_lambda_loop4_y = w_47 - w_48
            - k_lambda_loop4_y_lambda_loop3_x * l_lambda_loop4_x_lambda_loop3_x
            - k_lambda_loop4_y_lambda_loop3_y * l_lambda_loop4_x_lambda_loop3_y
            - k_lambda_loop4_y_lambda_loop4_x * l_lambda_loop6_x_lambda_loop4_x;
        let w_66 = k_lambda_loop4_y_lambda_loop3_x
            * minus_l_lambda_loop4_y_lambda_loop3_x;
        let w_68 = k_lambda_loop4_y_lambda_loop3_y * l_lambda_loop4_y_lambda_loop3_y;
        let w_60 = self.u * u7_x;
        let w_61 = self.k_10 * u6_y;
        let w_62 = w_60 - w_61;
        let w_63 = w_59 + self.k_10 * u6_x;
        let w_64 = u7_x * self.ua + u7_y * self.ub;
        let w_65 = u7_y * self.ua - u7_x * self.ub;
        let mass_epsilon_epsilon = self.k_15 + self.m6 * (w_62 * w_62 + w_63 * w_63)
            + self.m7 * (w_64 * w_64 + w_65 * w_65);
        let pivot_epsilon = mass_epsilon_epsilon - mass_epsilon_Omega * l_epsilon_Omega;
        let inverse_epsilon = S::from_f64(1.0) / pivot_epsilon;
        let loop6_x_by_epsilon = loop6_x_by_Omega - w_60;
        let k_lambda_loop6_x_epsilon = loop6_x_by_epsilon
            - mass_epsilon_Omega * l_lambda_loop6_x_Omega;
        let l_lambda_loop6_x_epsilon = inverse_epsilon * k_lambda_loop6_x_epsilon;
        let w_69 = w_30 + w_31 + loop6_x_by_Omega * l_lambda_loop6_x_Omega
            + k_lambda_loop6_x_epsilon * l_lambda_loop6_x_epsilon;
        let pivot_lambda_loop4_y = w_66 - w_67 - w_68
            - k_lambda_loop4_y_lambda_loop4_x * l_lambda_loop4_y_lambda_loop4_x;
        let inverse_lambda_loop4_y = S::from_f64(1.0) / pivot_lambda_loop4_y;
        let l_lambda_loop6_x_lambda_loop4_y = inverse_lambda_loop4_y
            * k_lambda_loop6_x_lambda_loop4_y;
        let rhs_lambda_loop6_x = w_24
            - (w_16 - w_18 + u6_x * w_58
                + minus_loop6_y_by_epsilon * epsilon_dot_squared) - w_23 - w_37 - w_49
            - rhs_Omega * l_lambda_loop6_x_Omega
            - l_lambda_loop6_x_lambda_loop4_x * rhs_lambda_loop4_x
            - l_lambda_loop6_x_epsilon * rhs_epsilon
            - l_lambda_loop6_x_lambda_loop4_y * rhs_lambda_loop4_y;
        let pivot_lambda_loop6_x = w_53 - w_69 - w_55
            - k_lambda_loop6_x_lambda_loop4_x * l_lambda_loop6_x_lambda_loop4_x
            - k_lambda_loop6_x_lambda_loop4_y * l_lambda_loop6_x_lambda_loop4_y;
        let minus_l_lambda_loop6_y_Omega = minus_loop6_y_by_Omega * self.inverse_Omega;
        let k_lambda_loop6_y_epsilon = mass_epsilon_Omega * minus_l_lambda_loop6_y_Omega
            - minus_loop6_y_by_epsilon;
        let k_lambda_loop6_y_lambda_loop4_x = w_32 - w_33 - w_56 - w_57;
        let l_lambda_loop6_y_lambda_loop4_x = inverse_lambda_loop4_x
            * k_lambda_loop6_y_lambda_loop4_x;
        let k_lambda_loop6_y_lambda_loop4_y = w_66 - w_44 - w_45 - w_68
            - k_lambda_loop4_y_lambda_loop4_x * l_lambda_loop6_y_lambda_loop4_x;
        let l_lambda_loop6_y_epsilon = inverse_epsilon * k_lambda_loop6_y_epsilon;
        let w_70 = w_44 + w_45 + minus_loop6_y_by_Omega * minus_l_lambda_loop6_y_Omega
            + k_lambda_loop6_y_epsilon * l_lambda_loop6_y_epsilon;
        let l_lambda_loop6_y_lambda_loop4_y = inverse_lambda_loop4_y
            * k_lambda_loop6_y_lambda_loop4_y;
        let k_lambda_loop6_y_lambda_loop6_x = w_32 - w_33 - w_56 - w_57
            + loop6_x_by_Omega * minus_l_lambda_loop6_y_Omega
            - k_lambda_loop6_x_lambda_loop4_x * l_lambda_loop6_y_lambda_loop4_x
            - k_lambda_loop6_x_epsilon * l_lambda_loop6_y_epsilon
            - k_lambda_loop6_x_lambda_loop4_y * l_lambda_loop6_y_lambda_loop4_y;
        let inverse_lambda_loop6_x = S::from_f64(1.0) / pivot_lambda_loop6_x;
        let l_lambda_loop6_y_lambda_loop6_x = inverse_lambda_loop6_x
            * k_lambda_loop6_y_lambda_loop6_x;
        let rhs_lambda_loop6_y = w_51
            - (w_26 + w_27 + u6_y * w_58 + loop6_x_by_epsilon * epsilon_dot_squared)
            - w_28 - w_29 - w_52 + rhs_Omega * minus_l_lambda_loop6_y_Omega
            - l_lambda_loop6_y_lambda_loop4_x * rhs_lambda_loop4_x
            - l_lambda_loop6_y_epsilon * rhs_epsilon
            - l_lambda_loop6_y_lambda_loop4_y * rhs_lambda_loop4_y
            - l_lambda_loop6_y_lambda_loop6_x * rhs_lambda_loop6_x;
        let pivot_lambda_loop6_y = w_66 - w_70 - w_68
            - k_lambda_loop6_y_lambda_loop4_x * l_lambda_loop6_y_lambda_loop4_x
            - k_lambda_loop6_y_lambda_loop4_y * l_lambda_loop6_y_lambda_loop4_y
            - k_lambda_loop6_y_lambda_loop6_x * l_lambda_loop6_y_lambda_loop6_x;
        let P_y = w_19 - loop3_x_by_Theta;
        let inverse_lambda_loop6_y = S::from_f64(1.0) / pivot_lambda_loop6_y;
        let lambda_loop6_y = inverse_lambda_loop6_y * rhs_lambda_loop6_y;
        let lambda_loop6_x = inverse_lambda_loop6_x * rhs_lambda_loop6_x
            - l_lambda_loop6_y_lambda_loop6_x * lambda_loop6_y;
        let lambda_loop4_y = inverse_lambda_loop4_y * rhs_lambda_loop4_y
            - l_lambda_loop6_x_lambda_loop4_y * lambda_loop6_x
            - l_lambda_loop6_y_lambda_loop4_y * lambda_loop6_y;
        let lambda_loop4_x = inverse_lambda_loop4_x * rhs_lambda_loop4_x
            - l_lambda_loop4_y_lambda_loop4_x * lambda_loop4_y
            - l_lambda_loop6_x_lambda_loop4_x * lambda_loop6_x
            - l_lambda_loop6_y_lambda_loop4_x * lambda_loop6_y;
        let lambda_loop3_y = inverse_lambda_loop3_y * rhs_lambda_loop3_y
            - l_lambda_loop4_x_lambda_loop3_y * lambda_loop4_x
            - l_lambda_loop4_y_lambda_loop3_y * lambda_loop4_y
            - l_lambda_loop4_x_lambda_loop3_y * lambda_loop6_x
            - l_lambda_loop4_y_lambda_loop3_y * lambda_loop6_y;
        let lambda_loop3_x = minus_l_lambda_loop3_y_lambda_loop3_x * lambda_loop3_y
            - minus_inverse_lambda_loop3_x * rhs_lambda_loop3_x
            - l_lambda_loop4_x_lambda_loop3_x * lambda_loop4_x
            + minus_l_lambda_loop4_y_lambda_loop3_x * lambda_loop4_y
            - l_lambda_loop4_x_lambda_loop3_x * lambda_loop6_x
            + minus_l_lambda_loop4_y_lambda_loop3_x * lambda_loop6_y;
        let Theta_ddot = minus_l_lambda_loop3_y_Theta * lambda_loop3_y
            - inverse_Theta * minus_rhs_Theta - l_lambda_loop3_x_Theta * lambda_loop3_x
            - l_lambda_loop3_x_Theta * lambda_loop4_x
            + minus_l_lambda_loop3_y_Theta * lambda_loop4_y
            - l_lambda_loop3_x_Theta * lambda_loop6_x
            + minus_l_lambda_loop3_y_Theta * lambda_loop6_y;
        let beta_ddot = rhs_beta * inverse_beta - l_Theta_beta * Theta_ddot
            - l_lambda_loop3_x_beta * lambda_loop3_x
            - l_lambda_loop3_y_beta * lambda_loop3_y
            - l_lambda_loop3_x_beta * lambda_loop4_x
            - l_lambda_loop3_y_beta * lambda_loop4_y
            - l_lambda_loop3_x_beta * lambda_loop6_x
            - l_lambda_loop3_y_beta * lambda_loop6_y;
        let gamma_ddot = rhs_gamma * inverse_gamma
            + minus_l_lambda_loop3_x_gamma * lambda_loop3_x
            + minus_l_lambda_loop3_y_gamma * lambda_loop3_y;
        let delta_ddot = inverse_delta * rhs_delta
            - l_lambda_loop4_x_delta * lambda_loop4_x
            - l_lambda_loop4_y_delta * lambda_loop4_y;
        let Phi_ddot = rhs_Phi * self.inverse_Phi - l_delta_Phi * delta_ddot
            + minus_l_lambda_loop4_x_Phi * lambda_loop4_x
            + minus_l_lambda_loop4_y_Phi * lambda_loop4_y;
        let epsilon_ddot = inverse_epsilon * rhs_epsilon
            - l_lambda_loop6_x_epsilon * lambda_loop6_x
            - l_lambda_loop6_y_epsilon * lambda_loop6_y;
        let Omega_ddot = rhs_Omega * self.inverse_Omega - l_epsilon_Omega * epsilon_ddot
            - l_lambda_loop6_x_Omega * lambda_loop6_x
            + minus_l_lambda_loop6_y_Omega * lambda_loop6_y;
        let w_71 = lambda_loop6_y + lambda_loop4_y + lambda_loop3_y;
        let w_72 = lambda_loop6_x + lambda_loop4_x + lambda_loop3_x;
        let w_73 = P_y * w_71 + P_x * w_72;
        let w_80 = self.d * (u2_x * w_72 + u2_y * w_71);
        let w_74 = w_17 * beta_dot;
        let w_75 = Theta_dot + beta_dot;
        let w_76 = u2_x * w_75;
        let w_77 = Theta_dot * w_76 + u2_y * Theta_ddot;
        let w_78 = beta_dot * (w_74 - self.d * w_76) - self.d * w_77 + beta_ddot * P_y;
        let w_114 = self.d * (w_77 + beta_dot * w_76 + u2_y * beta_ddot);
        let w_106 = self.da * w_76;
        let w_79 = l_lambda_loop3_y_beta * w_73;
        let w_81 = w_80 + l_Theta_beta * w_73;
        let w_82 = minus_l_lambda_loop3_y_Theta * w_81;
        let w_83 = u2_y * w_75;
        let w_84 = Theta_dot * w_83 - u2_x * Theta_ddot;
        let w_116 = self.d * (w_84 + beta_dot * w_83 - u2_x * beta_ddot);
        let w_85 = w_19 * beta_dot;
        let w_86 = self.d * w_84 - beta_dot * (w_85 - loop3_x_by_Theta * w_75)
            + P_x * beta_ddot;
        let w_87 = l_lambda_loop3_x_beta * w_73;
        let w_88 = l_lambda_loop3_x_Theta * w_81;
        let w_89 = w_86 - w_87 + w_88;
        let w_90 = w_78 - w_79 - w_82 + minus_l_lambda_loop3_y_lambda_loop3_x * w_89;
        let w_91 = l_lambda_loop4_x_lambda_loop3_x * w_89;
        let w_92 = l_lambda_loop4_x_lambda_loop3_y * w_90;
        let w_93 = w_86 - w_87 + w_88 - w_91 - w_92;
        let w_94 = minus_l_lambda_loop4_y_lambda_loop3_x * w_89;
        let w_95 = l_lambda_loop4_y_lambda_loop3_y * w_90;
        let w_96 = w_78 - w_79 - w_82 + w_94 - w_95
            - l_lambda_loop4_y_lambda_loop4_x * w_93;
        let w_97 = w_86 - w_87 + w_88 - w_91 - w_92
            - l_lambda_loop6_x_lambda_loop4_x * w_93
            - l_lambda_loop6_x_lambda_loop4_y * w_96;
        let w_98 = inverse_lambda_loop6_y
            * (w_78 - w_79 - w_82 + w_94 - w_95 - l_lambda_loop6_y_lambda_loop4_x * w_93
                - l_lambda_loop6_y_lambda_loop4_y * w_96
                - l_lambda_loop6_y_lambda_loop6_x * w_97);
        let w_99 = inverse_lambda_loop6_x * w_97
            - l_lambda_loop6_y_lambda_loop6_x * w_98;
        let w_100 = inverse_lambda_loop4_y * w_96
            - l_lambda_loop6_x_lambda_loop4_y * w_99
            - l_lambda_loop6_y_lambda_loop4_y * w_98;
        let w_101 = inverse_lambda_loop4_x * w_93
            - l_lambda_loop4_y_lambda_loop4_x * w_100
            - l_lambda_loop6_x_lambda_loop4_x * w_99
            - l_lambda_loop6_y_lambda_loop4_x * w_98;
        let w_102 = inverse_lambda_loop3_y * w_90
            - l_lambda_loop4_x_lambda_loop3_y * w_101
            - l_lambda_loop4_y_lambda_loop3_y * w_100
            - l_lambda_loop4_x_lambda_loop3_y * w_99
            - l_lambda_loop4_y_lambda_loop3_y * w_98;
        let w_103 = minus_l_lambda_loop3_y_lambda_loop3_x * w_102
            - minus_inverse_lambda_loop3_x * w_89
            - l_lambda_loop4_x_lambda_loop3_x * w_101
            + minus_l_lambda_loop4_y_lambda_loop3_x * w_100
            - l_lambda_loop4_x_lambda_loop3_x * w_99
            + minus_l_lambda_loop4_y_lambda_loop3_x * w_98;
        let w_104 = minus_l_lambda_loop3_y_Theta * w_102 - inverse_Theta * w_81
            - l_lambda_loop3_x_Theta * w_103 - l_lambda_loop3_x_Theta * w_101
            + minus_l_lambda_loop3_y_Theta * w_100 - l_lambda_loop3_x_Theta * w_99
            + minus_l_lambda_loop3_y_Theta * w_98;
        let w_105 = w_20 * w_75;
        let w_107 = u2_y * (beta_dot * (w_85 - w_105) - Theta_dot * w_105)
            - u2_x * (Theta_dot * w_106 - beta_dot * (w_74 - w_106));
        let w_108 = w_75 * w_105;
        let w_109 = w_75 * w_106;
        let w_247 = Theta_dot + w_75;
        let w_252 = beta_dot * (w_19 + P_y) - loop3_x_by_Theta * w_247;
        let w_249 = w_20 * w_247 - beta_dot * (w_19 + w_21);
        let w_255 = beta_dot * (w_17 + P_x) - minus_loop3_y_by_Theta * w_247;
        let w_248 = beta_dot * (w_17 + w_22) - self.da * u2_x * w_247;
        let w_275 = beta_dot + w_247;
        let w_277 = w_20 * w_275;
        let w_280 = minus_loop3_y_by_Theta * w_275;
        let w_285 = loop3_x_by_Theta * w_275;
        let w_276 = self.da * u2_x * w_275;
        let w_110 = self.k_2 * (w_21 * u2_x - u2_y * w_22);
        let w_111 = self.k_2 * w_107 - w_80 - self.m2 * (w_21 * w_108 + w_22 * w_109)
            + w_110 * (Theta_ddot + S::from_f64(2.0) * beta_ddot);
        let w_112 = self.k_2 * (w_107 + u2_y * w_108 + u2_x * w_109) - w_80
            + beta_ddot * w_110 - l_Theta_beta * w_111;
        let w_113 = minus_l_lambda_loop3_y_Theta * w_112;
        let w_115 = l_lambda_loop3_y_beta * w_111;
        let w_117 = l_lambda_loop3_x_beta * w_111;
        let w_118 = l_lambda_loop3_x_Theta * w_112;
        let w_119 = w_116 - w_117 - w_118;
        let w_120 = w_113 - w_114 - w_115
            + minus_l_lambda_loop3_y_lambda_loop3_x * w_119;
        let w_121 = l_lambda_loop4_x_lambda_loop3_x * w_119;
        let w_122 = l_lambda_loop4_x_lambda_loop3_y * w_120;
        let w_123 = w_116 - w_117 - w_118 - w_121 - w_122;
        let w_124 = minus_l_lambda_loop4_y_lambda_loop3_x * w_119;
        let w_125 = l_lambda_loop4_y_lambda_loop3_y * w_120;
        let w_126 = w_113 - w_114 - w_115 + w_124 - w_125
            - l_lambda_loop4_y_lambda_loop4_x * w_123;
        let w_127 = w_116 - w_117 - w_118 - w_121 - w_122
            - l_lambda_loop6_x_lambda_loop4_x * w_123
            - l_lambda_loop6_x_lambda_loop4_y * w_126;
        let w_128 = inverse_lambda_loop6_y
            * (w_113 - w_114 - w_115 + w_124 - w_125
                - l_lambda_loop6_y_lambda_loop4_x * w_123
                - l_lambda_loop6_y_lambda_loop4_y * w_126
                - l_lambda_loop6_y_lambda_loop6_x * w_127);
        let w_129 = inverse_lambda_loop6_x * w_127
            - l_lambda_loop6_y_lambda_loop6_x * w_128;
        let w_130 = inverse_lambda_loop4_y * w_126
            - l_lambda_loop6_x_lambda_loop4_y * w_129
            - l_lambda_loop6_y_lambda_loop4_y * w_128;
        let w_131 = inverse_lambda_loop4_x * w_123
            - l_lambda_loop4_y_lambda_loop4_x * w_130
            - l_lambda_loop6_x_lambda_loop4_x * w_129
            - l_lambda_loop6_y_lambda_loop4_x * w_128;
        let w_132 = inverse_lambda_loop3_y * w_120
            - l_lambda_loop4_x_lambda_loop3_y * w_131
            - l_lambda_loop4_y_lambda_loop3_y * w_130
            - l_lambda_loop4_x_lambda_loop3_y * w_129
            - l_lambda_loop4_y_lambda_loop3_y * w_128;
        let w_133 = minus_l_lambda_loop3_y_lambda_loop3_x * w_132
            - minus_inverse_lambda_loop3_x * w_119
            - l_lambda_loop4_x_lambda_loop3_x * w_131
            + minus_l_lambda_loop4_y_lambda_loop3_x * w_130
            - l_lambda_loop4_x_lambda_loop3_x * w_129
            + minus_l_lambda_loop4_y_lambda_loop3_x * w_128;
        let w_134 = inverse_Theta * w_112 - l_lambda_loop3_x_Theta * w_133
            + minus_l_lambda_loop3_y_Theta * w_132 - l_lambda_loop3_x_Theta * w_131
            + minus_l_lambda_loop3_y_Theta * w_130 - l_lambda_loop3_x_Theta * w_129
            + minus_l_lambda_loop3_y_Theta * w_128;
        let w_137 = w_7 * w_135 + w_10 * w_136;
        let w_138 = sqrt_w_11 * w_137 * w_137;
        let w_139 = (self.l0 - sqrt_w_11)
            * ((w_135 * w_135 + w_136 * w_136 - w_7 * w_136 + w_10 * w_135) / sqrt_w_11
                - w_138 / (w_11 * sqrt_w_11 * sqrt_w_11));
        let w_140 = self.c0 * (w_139 - w_138 / (w_11 * sqrt_w_11))
            + self.ss * (u3_x * lambda_loop3_y - u3_y * lambda_loop3_x);
        let w_141 = minus_l_lambda_loop3_x_gamma * w_140
            - self.ss * (u3_x * gamma_dot_squared + u3_y * gamma_ddot);
        let w_143 = self.ss * (u3_x * gamma_ddot - u3_y * gamma_dot_squared)
            + minus_l_lambda_loop3_y_gamma * w_140
            + minus_l_lambda_loop3_y_lambda_loop3_x * w_141;
        let w_142 = l_lambda_loop4_x_lambda_loop3_x * w_141;
        let w_144 = l_lambda_loop4_x_lambda_loop3_y * w_143;
        let w_145 = w_142 + w_144;
        let w_146 = minus_l_lambda_loop4_y_lambda_loop3_x * w_141;
        let w_147 = l_lambda_loop4_y_lambda_loop3_y * w_143;
        let w_148 = w_146 - w_147 + l_lambda_loop4_y_lambda_loop4_x * w_145;
        let w_149 = l_lambda_loop6_x_lambda_loop4_x * w_145 - w_142 - w_144
            - l_lambda_loop6_x_lambda_loop4_y * w_148;
        let w_150 = inverse_lambda_loop6_y
            * (w_146 - w_147 + l_lambda_loop6_y_lambda_loop4_x * w_145
                - l_lambda_loop6_y_lambda_loop4_y * w_148
                - l_lambda_loop6_y_lambda_loop6_x * w_149);
        let w_151 = inverse_lambda_loop6_x * w_149
            - l_lambda_loop6_y_lambda_loop6_x * w_150;
        let w_152 = inverse_lambda_loop4_y * w_148
            - l_lambda_loop6_x_lambda_loop4_y * w_151
            - l_lambda_loop6_y_lambda_loop4_y * w_150;
        let w_153 = inverse_lambda_loop4_x * w_145
            + l_lambda_loop4_y_lambda_loop4_x * w_152
            + l_lambda_loop6_x_lambda_loop4_x * w_151
            + l_lambda_loop6_y_lambda_loop4_x * w_150;
        let w_154 = inverse_lambda_loop3_y * w_143
            + l_lambda_loop4_x_lambda_loop3_y * w_153
            - l_lambda_loop4_y_lambda_loop3_y * w_152
            - l_lambda_loop4_x_lambda_loop3_y * w_151
            - l_lambda_loop4_y_lambda_loop3_y * w_150;
        let w_155 = minus_l_lambda_loop3_y_lambda_loop3_x * w_154
            - minus_inverse_lambda_loop3_x * w_141
            + l_lambda_loop4_x_lambda_loop3_x * w_153
            + minus_l_lambda_loop4_y_lambda_loop3_x * w_152
            - l_lambda_loop4_x_lambda_loop3_x * w_151
            + minus_l_lambda_loop4_y_lambda_loop3_x * w_150;
        let w_156 = minus_l_lambda_loop3_y_Theta * w_154 - l_lambda_loop3_x_Theta * w_155
            + l_lambda_loop3_x_Theta * w_153 + minus_l_lambda_loop3_y_Theta * w_152
            - l_lambda_loop3_x_Theta * w_151 + minus_l_lambda_loop3_y_Theta * w_150;
        let w_157 = Phi_dot + delta_dot;
        let w_158 = cos_w_2 * w_157;
        let w_159 = self.k_4 * w_158;
        let w_160 = w_157 * w_159;
        let w_161 = self.k_4 * Phi_dot;
        let w_162 = w_38 * delta_dot;
        let w_163 = w_158 * w_161 - delta_dot * (w_162 - w_159);
        let w_164 = n4_x * w_157;
        let w_165 = self.k_4 * w_164;
        let w_166 = w_157 * w_165;
        let w_167 = w_36 * delta_dot;
        let w_168 = w_161 * w_164 + delta_dot * (w_167 + w_165);
        let w_169 = self.ee * (cos_w_2 * lambda_loop4_y - n4_x * lambda_loop4_x);
        let w_185 = minus_loop4_y_by_delta * lambda_loop4_x
            + loop4_x_by_delta * lambda_loop4_y + l_delta_Phi * w_169;
        let w_186 = delta_dot * (w_162 - self.ee * w_158)
            - self.ee * (Phi_dot * w_158 + n4_x * Phi_ddot)
            - minus_loop4_y_by_delta * delta_ddot + minus_l_lambda_loop4_x_Phi * w_169
            + l_lambda_loop4_x_delta * w_185;
        let w_187 = self.ee * (cos_w_2 * Phi_ddot - Phi_dot * w_164)
            - delta_dot * (w_167 + self.ee * w_164) - loop4_x_by_delta * delta_ddot
            + minus_l_lambda_loop4_y_Phi * w_169 + l_lambda_loop4_y_delta * w_185
            - l_lambda_loop4_y_lambda_loop4_x * w_186;
        let w_170 = self.k_5 * (w_41 * cos_w_2 + n4_x * w_39);
        let w_171 = self.k_5 * (cos_w_2 * (w_160 - w_163) + n4_x * (w_166 - w_168))
            + w_169 - delta_ddot * w_170;
        let w_173 = w_169 - self.k_5 * (cos_w_2 * w_163 + n4_x * w_168)
            - w_170 * (Phi_ddot + S::from_f64(2.0) * delta_ddot)
            + self.m4 * (w_41 * w_166 - w_39 * w_160);
        let w_172 = delta_ddot + Phi_ddot;
        let w_174 = w_173 - l_delta_Phi * w_171;
        let w_175 = minus_l_lambda_loop4_x_Phi * w_171
            - self.ee * (w_157 * w_158 + n4_x * w_172) - l_lambda_loop4_x_delta * w_174;
        let w_176 = self.ee * (cos_w_2 * w_172 - w_157 * w_164)
            + minus_l_lambda_loop4_y_Phi * w_171 - l_lambda_loop4_y_delta * w_174
            - l_lambda_loop4_y_lambda_loop4_x * w_175;
        let w_177 = l_lambda_loop6_x_lambda_loop4_x * w_175
            + l_lambda_loop6_x_lambda_loop4_y * w_176;
        let w_178 = inverse_lambda_loop6_y
            * (l_lambda_loop6_y_lambda_loop6_x * w_177
                - l_lambda_loop6_y_lambda_loop4_x * w_175
                - l_lambda_loop6_y_lambda_loop4_y * w_176);
        let w_179 = inverse_lambda_loop6_x * w_177
            + l_lambda_loop6_y_lambda_loop6_x * w_178;
        let w_180 = inverse_lambda_loop4_y * w_176
            + l_lambda_loop6_x_lambda_loop4_y * w_179
            - l_lambda_loop6_y_lambda_loop4_y * w_178;
        let w_181 = inverse_lambda_loop4_x * w_175
            - l_lambda_loop4_y_lambda_loop4_x * w_180
            + l_lambda_loop6_x_lambda_loop4_x * w_179
            - l_lambda_loop6_y_lambda_loop4_x * w_178;
        let w_236 = inverse_delta * w_174 - l_lambda_loop4_x_delta * w_181
            - l_lambda_loop4_y_delta * w_180;
        let w_182 = l_lambda_loop4_x_lambda_loop3_y * w_179
            - l_lambda_loop4_x_lambda_loop3_y * w_181
            - l_lambda_loop4_y_lambda_loop3_y * w_180
            - l_lambda_loop4_y_lambda_loop3_y * w_178;
        let w_183 = minus_l_lambda_loop3_y_lambda_loop3_x * w_182
            - l_lambda_loop4_x_lambda_loop3_x * w_181
            + minus_l_lambda_loop4_y_lambda_loop3_x * w_180
            + l_lambda_loop4_x_lambda_loop3_x * w_179
            + minus_l_lambda_loop4_y_lambda_loop3_x * w_178;
        let w_184 = minus_l_lambda_loop3_y_Theta * w_182 - l_lambda_loop3_x_Theta * w_183
            - l_lambda_loop3_x_Theta * w_181 + minus_l_lambda_loop3_y_Theta * w_180
            + l_lambda_loop3_x_Theta * w_179 + minus_l_lambda_loop3_y_Theta * w_178;
        let w_188 = l_lambda_loop6_x_lambda_loop4_x * w_186
            + l_lambda_loop6_x_lambda_loop4_y * w_187;
        let w_189 = inverse_lambda_loop6_y
            * (l_lambda_loop6_y_lambda_loop6_x * w_188
                - l_lambda_loop6_y_lambda_loop4_x * w_186
                - l_lambda_loop6_y_lambda_loop4_y * w_187);
        let w_190 = inverse_lambda_loop6_x * w_188
            + l_lambda_loop6_y_lambda_loop6_x * w_189;
        let w_191 = inverse_lambda_loop4_y * w_187
            + l_lambda_loop6_x_lambda_loop4_y * w_190
            - l_lambda_loop6_y_lambda_loop4_y * w_189;
        let w_192 = inverse_lambda_loop4_x * w_186
            - l_lambda_loop4_y_lambda_loop4_x * w_191
            + l_lambda_loop6_x_lambda_loop4_x * w_190
            - l_lambda_loop6_y_lambda_loop4_x * w_189;
        let w_237 = inverse_delta * w_185 + l_lambda_loop4_x_delta * w_192
            + l_lambda_loop4_y_delta * w_191;
        let w_193 = l_lambda_loop4_x_lambda_loop3_y * w_190
            - l_lambda_loop4_x_lambda_loop3_y * w_192
            - l_lambda_loop4_y_lambda_loop3_y * w_191
            - l_lambda_loop4_y_lambda_loop3_y * w_189;
        let w_194 = minus_l_lambda_loop3_y_lambda_loop3_x * w_193
            - l_lambda_loop4_x_lambda_loop3_x * w_192
            + minus_l_lambda_loop4_y_lambda_loop3_x * w_191
            + l_lambda_loop4_x_lambda_loop3_x * w_190
            + minus_l_lambda_loop4_y_lambda_loop3_x * w_189;
        let w_195 = minus_l_lambda_loop3_y_Theta * w_193 - l_lambda_loop3_x_Theta * w_194
            - l_lambda_loop3_x_Theta * w_192 + minus_l_lambda_loop3_y_Theta * w_191
            + l_lambda_loop3_x_Theta * w_190 + minus_l_lambda_loop3_y_Theta * w_189;
        let w_196 = epsilon_dot + Omega_dot;
        let w_197 = u6_y * w_196;
        let w_198 = epsilon_ddot + Omega_ddot;
        let w_199 = u6_x * w_196;
        let w_200 = self.k_10 * w_199;
        let w_201 = w_196 * w_200;
        let w_202 = w_59 * epsilon_dot;
        let w_203 = self.k_10 * Omega_dot;
        let w_204 = epsilon_dot * (w_202 + w_200) + w_199 * w_203;
        let w_205 = self.k_10 * w_197;
        let w_206 = w_196 * w_205;
        let w_207 = w_60 * epsilon_dot;
        let w_208 = w_203 * w_197 - epsilon_dot * (w_207 - w_205);
        let w_209 = self.zf * (u6_x * lambda_loop6_x + u6_y * lambda_loop6_y);
        let w_210 = self.k_11 * (w_63 * u6_y + u6_x * w_62);
        let w_211 = self.k_11 * (u6_x * (w_201 - w_204) + u6_y * (w_206 - w_208)) - w_209
            + epsilon_ddot * w_210;
        let w_212 = w_210 * (Omega_ddot + S::from_f64(2.0) * epsilon_ddot) - w_209
            - self.k_11 * (u6_x * w_204 + u6_y * w_208)
            + self.m6 * (w_63 * w_201 - w_62 * w_206);
        let w_213 = w_212 - l_epsilon_Omega * w_211;
        let w_214 = self.zf * (w_196 * w_197 - u6_x * w_198)
            - l_lambda_loop6_x_Omega * w_211 - l_lambda_loop6_x_epsilon * w_213;
        let w_215 = inverse_lambda_loop6_y
            * (minus_l_lambda_loop6_y_Omega * w_211
                - self.zf * (w_196 * w_199 + u6_y * w_198)
                - l_lambda_loop6_y_epsilon * w_213
                - l_lambda_loop6_y_lambda_loop6_x * w_214);
        let w_216 = inverse_lambda_loop6_x * w_214
            - l_lambda_loop6_y_lambda_loop6_x * w_215;
        let w_245 = inverse_epsilon * w_213 - l_lambda_loop6_x_epsilon * w_216
            - l_lambda_loop6_y_epsilon * w_215;
        let w_217 = l_lambda_loop6_x_lambda_loop4_y * w_216
            + l_lambda_loop6_y_lambda_loop4_y * w_215;
        let w_218 = l_lambda_loop4_y_lambda_loop4_x * w_217
            - l_lambda_loop6_x_lambda_loop4_x * w_216
            - l_lambda_loop6_y_lambda_loop4_x * w_215;
        let w_219 = l_lambda_loop4_y_lambda_loop3_y * w_217
            - l_lambda_loop4_x_lambda_loop3_y * w_218
            - l_lambda_loop4_x_lambda_loop3_y * w_216
            - l_lambda_loop4_y_lambda_loop3_y * w_215;
        let w_220 = minus_l_lambda_loop3_y_lambda_loop3_x * w_219
            - l_lambda_loop4_x_lambda_loop3_x * w_218
            - minus_l_lambda_loop4_y_lambda_loop3_x * w_217
            - l_lambda_loop4_x_lambda_loop3_x * w_216
            + minus_l_lambda_loop4_y_lambda_loop3_x * w_215;
        let w_221 = minus_l_lambda_loop3_y_Theta * w_219 - l_lambda_loop3_x_Theta * w_220
            - l_lambda_loop3_x_Theta * w_218 - minus_l_lambda_loop3_y_Theta * w_217
            - l_lambda_loop3_x_Theta * w_216 + minus_l_lambda_loop3_y_Theta * w_215;
        let w_222 = w_60 - loop6_x_by_Omega;
        let w_223 = lambda_loop6_y * w_222 - minus_loop6_y_by_epsilon * lambda_loop6_x
            + l_epsilon_Omega * w_209;
        let w_224 = self.zf * (Omega_dot * w_197 - u6_x * Omega_ddot)
            - epsilon_dot * (w_207 - self.zf * w_197)
            - minus_loop6_y_by_epsilon * epsilon_ddot + l_lambda_loop6_x_Omega * w_209
            - l_lambda_loop6_x_epsilon * w_223;
        let w_225 = epsilon_ddot * w_222 - epsilon_dot * (w_202 + self.zf * w_199)
            - self.zf * (Omega_dot * w_199 + u6_y * Omega_ddot)
            - minus_l_lambda_loop6_y_Omega * w_209 - l_lambda_loop6_y_epsilon * w_223
            - l_lambda_loop6_y_lambda_loop6_x * w_224;
        let w_226 = inverse_lambda_loop6_y * w_225;
        let w_227 = inverse_lambda_loop6_x * w_224
            - l_lambda_loop6_y_lambda_loop6_x * w_226;
        let w_246 = inverse_epsilon * w_223 - l_lambda_loop6_x_epsilon * w_227
            - l_lambda_loop6_y_epsilon * w_226;
        let w_228 = l_lambda_loop6_x_lambda_loop4_y * w_227
            + l_lambda_loop6_y_lambda_loop4_y * w_226;
        let w_229 = l_lambda_loop4_y_lambda_loop4_x * w_228
            - l_lambda_loop6_x_lambda_loop4_x * w_227
            - l_lambda_loop6_y_lambda_loop4_x * w_226;
        let w_230 = l_lambda_loop4_y_lambda_loop3_y * w_228
            - l_lambda_loop4_x_lambda_loop3_y * w_229
            - l_lambda_loop4_x_lambda_loop3_y * w_227
            - l_lambda_loop4_y_lambda_loop3_y * w_226;
        let w_231 = minus_l_lambda_loop3_y_lambda_loop3_x * w_230
            - l_lambda_loop4_x_lambda_loop3_x * w_229
            - minus_l_lambda_loop4_y_lambda_loop3_x * w_228
            - l_lambda_loop4_x_lambda_loop3_x * w_227
            + minus_l_lambda_loop4_y_lambda_loop3_x * w_226;
        let w_232 = minus_l_lambda_loop3_y_Theta * w_230 - l_lambda_loop3_x_Theta * w_231
            - l_lambda_loop3_x_Theta * w_229 - minus_l_lambda_loop3_y_Theta * w_228
            - l_lambda_loop3_x_Theta * w_227 + minus_l_lambda_loop3_y_Theta * w_226;
        let w_233 = l_lambda_loop4_x_delta * w_101 + l_lambda_loop4_y_delta * w_100;
        let w_234 = l_lambda_loop4_x_delta * w_131 + l_lambda_loop4_y_delta * w_130;
        let w_235 = l_lambda_loop4_x_delta * w_153 - l_lambda_loop4_y_delta * w_152;
        let w_238 = l_lambda_loop4_y_delta * w_217 - l_lambda_loop4_x_delta * w_218;
        let w_239 = l_lambda_loop4_y_delta * w_228 - l_lambda_loop4_x_delta * w_229;
        let w_240 = l_lambda_loop6_x_epsilon * w_99 + l_lambda_loop6_y_epsilon * w_98;
        let w_241 = l_lambda_loop6_x_epsilon * w_129 + l_lambda_loop6_y_epsilon * w_128;
        let w_242 = l_lambda_loop6_x_epsilon * w_151 + l_lambda_loop6_y_epsilon * w_150;
        let w_243 = l_lambda_loop6_x_epsilon * w_179 - l_lambda_loop6_y_epsilon * w_178;
        let w_244 = l_lambda_loop6_x_epsilon * w_190 - l_lambda_loop6_y_epsilon * w_189;
        let w_250 = self.m2 * (w_21 * w_248 + w_22 * w_249);
        let w_251 = self.k_2 * (u2_y * w_248 + u2_x * w_249) + l_Theta_beta * w_250;
        let w_278 = self.m2 * (w_21 * w_276 - w_22 * w_277);
        let w_279 = self.k_2 * (u2_x * w_277 - u2_y * w_276) - l_Theta_beta * w_278;
        let w_253 = l_lambda_loop3_y_beta * w_250;
        let w_254 = minus_l_lambda_loop3_y_Theta * w_251;
        let w_256 = l_lambda_loop3_x_beta * w_250;
        let w_257 = l_lambda_loop3_x_Theta * w_251;
        let w_258 = w_255 + w_256 - w_257;
        let w_259 = w_252 + w_253 + w_254
            + minus_l_lambda_loop3_y_lambda_loop3_x * w_258;
        let w_260 = l_lambda_loop4_x_lambda_loop3_x * w_258;
        let w_261 = l_lambda_loop4_x_lambda_loop3_y * w_259;
        let w_262 = w_255 + w_256 - w_257 - w_260 - w_261;
        let w_263 = minus_l_lambda_loop4_y_lambda_loop3_x * w_258;
        let w_264 = l_lambda_loop4_y_lambda_loop3_y * w_259;
        let w_265 = w_252 + w_253 + w_254 + w_263 - w_264
            - l_lambda_loop4_y_lambda_loop4_x * w_262;
        let w_266 = w_255 + w_256 - w_257 - w_260 - w_261
            - l_lambda_loop6_x_lambda_loop4_x * w_262
            - l_lambda_loop6_x_lambda_loop4_y * w_265;
        let w_267 = inverse_lambda_loop6_y
            * (w_252 + w_253 + w_254 + w_263 - w_264
                - l_lambda_loop6_y_lambda_loop4_x * w_262
                - l_lambda_loop6_y_lambda_loop4_y * w_265
                - l_lambda_loop6_y_lambda_loop6_x * w_266);
        let w_268 = inverse_lambda_loop6_x * w_266
            - l_lambda_loop6_y_lambda_loop6_x * w_267;
        let w_269 = inverse_lambda_loop4_y * w_265
            - l_lambda_loop6_x_lambda_loop4_y * w_268
            - l_lambda_loop6_y_lambda_loop4_y * w_267;
        let w_270 = inverse_lambda_loop4_x * w_262
            - l_lambda_loop4_y_lambda_loop4_x * w_269
            - l_lambda_loop6_x_lambda_loop4_x * w_268
            - l_lambda_loop6_y_lambda_loop4_x * w_267;
        let w_271 = inverse_lambda_loop3_y * w_259
            - l_lambda_loop4_x_lambda_loop3_y * w_270
            - l_lambda_loop4_y_lambda_loop3_y * w_269
            - l_lambda_loop4_x_lambda_loop3_y * w_268
            - l_lambda_loop4_y_lambda_loop3_y * w_267;
        let w_272 = minus_l_lambda_loop3_y_lambda_loop3_x * w_271
            - minus_inverse_lambda_loop3_x * w_258
            - l_lambda_loop4_x_lambda_loop3_x * w_270
            + minus_l_lambda_loop4_y_lambda_loop3_x * w_269
            - l_lambda_loop4_x_lambda_loop3_x * w_268
            + minus_l_lambda_loop4_y_lambda_loop3_x * w_267;
        let w_273 = inverse_Theta * w_251 - l_lambda_loop3_x_Theta * w_272
            + minus_l_lambda_loop3_y_Theta * w_271 - l_lambda_loop3_x_Theta * w_270
            + minus_l_lambda_loop3_y_Theta * w_269 - l_lambda_loop3_x_Theta * w_268
            + minus_l_lambda_loop3_y_Theta * w_267;
        let w_274 = inverse_beta * w_250 + l_Theta_beta * w_273
            + l_lambda_loop3_x_beta * w_272 + l_lambda_loop3_y_beta * w_271
            + l_lambda_loop3_x_beta * w_270 + l_lambda_loop3_y_beta * w_269
            + l_lambda_loop3_x_beta * w_268 + l_lambda_loop3_y_beta * w_267;
        let w_281 = l_lambda_loop3_x_beta * w_278;
        let w_282 = l_lambda_loop3_x_Theta * w_279;
        let w_283 = w_280 + w_281 + w_282;
        let w_284 = minus_l_lambda_loop3_y_Theta * w_279;
        let w_286 = l_lambda_loop3_y_beta * w_278;
        let w_287 = w_284 - w_285 - w_286
            - minus_l_lambda_loop3_y_lambda_loop3_x * w_283;
        let w_288 = l_lambda_loop4_x_lambda_loop3_x * w_283;
        let w_289 = l_lambda_loop4_x_lambda_loop3_y * w_287;
        let w_290 = w_288 - w_280 - w_281 - w_282 - w_289;
        let w_291 = minus_l_lambda_loop4_y_lambda_loop3_x * w_283;
        let w_292 = l_lambda_loop4_y_lambda_loop3_y * w_287;
        let w_293 = w_284 - w_285 - w_286 - w_291 - w_292
            - l_lambda_loop4_y_lambda_loop4_x * w_290;
        let w_294 = w_288 - w_280 - w_281 - w_282 - w_289
            - l_lambda_loop6_x_lambda_loop4_x * w_290
            - l_lambda_loop6_x_lambda_loop4_y * w_293;
        let w_295 = inverse_lambda_loop6_y
            * (w_284 - w_285 - w_286 - w_291 - w_292
                - l_lambda_loop6_y_lambda_loop4_x * w_290
                - l_lambda_loop6_y_lambda_loop4_y * w_293
                - l_lambda_loop6_y_lambda_loop6_x * w_294);
        let w_296 = inverse_lambda_loop6_x * w_294
            - l_lambda_loop6_y_lambda_loop6_x * w_295;
        let w_297 = inverse_lambda_loop4_y * w_293
            - l_lambda_loop6_x_lambda_loop4_y * w_296
            - l_lambda_loop6_y_lambda_loop4_y * w_295;
        let w_298 = inverse_lambda_loop4_x * w_290
            - l_lambda_loop4_y_lambda_loop4_x * w_297
            - l_lambda_loop6_x_lambda_loop4_x * w_296
            - l_lambda_loop6_y_lambda_loop4_x * w_295;
        let w_299 = inverse_lambda_loop3_y * w_287
            - l_lambda_loop4_x_lambda_loop3_y * w_298
            - l_lambda_loop4_y_lambda_loop3_y * w_297
            - l_lambda_loop4_x_lambda_loop3_y * w_296
            - l_lambda_loop4_y_lambda_loop3_y * w_295;
        let w_300 = minus_inverse_lambda_loop3_x * w_283
            + minus_l_lambda_loop3_y_lambda_loop3_x * w_299
            - l_lambda_loop4_x_lambda_loop3_x * w_298
            + minus_l_lambda_loop4_y_lambda_loop3_x * w_297
            - l_lambda_loop4_x_lambda_loop3_x * w_296
            + minus_l_lambda_loop4_y_lambda_loop3_x * w_295;
        let w_301 = inverse_Theta * w_279 - l_lambda_loop3_x_Theta * w_300
            + minus_l_lambda_loop3_y_Theta * w_299 - l_lambda_loop3_x_Theta * w_298
            + minus_l_lambda_loop3_y_Theta * w_297 - l_lambda_loop3_x_Theta * w_296
            + minus_l_lambda_loop3_y_Theta * w_295;
        let w_303 = gamma_dot * self.k_28;
        let w_304 = minus_l_lambda_loop3_x_gamma * w_302 - u3_y * w_303;
        let w_306 = u3_x * w_303 + minus_l_lambda_loop3_y_gamma * w_302
            + minus_l_lambda_loop3_y_lambda_loop3_x * w_304;
        let w_305 = l_lambda_loop4_x_lambda_loop3_x * w_304;
        let w_307 = l_lambda_loop4_x_lambda_loop3_y * w_306;
        let w_308 = w_305 + w_307;
        let w_309 = minus_l_lambda_loop4_y_lambda_loop3_x * w_304;
        let w_310 = l_lambda_loop4_y_lambda_loop3_y * w_306;
        let w_311 = w_309 - w_310 + l_lambda_loop4_y_lambda_loop4_x * w_308;
        let w_312 = l_lambda_loop6_x_lambda_loop4_x * w_308 - w_305 - w_307
            - l_lambda_loop6_x_lambda_loop4_y * w_311;
        let w_313 = inverse_lambda_loop6_y
            * (w_309 - w_310 + l_lambda_loop6_y_lambda_loop4_x * w_308
                - l_lambda_loop6_y_lambda_loop4_y * w_311
                - l_lambda_loop6_y_lambda_loop6_x * w_312);
        let w_314 = inverse_lambda_loop6_x * w_312
            - l_lambda_loop6_y_lambda_loop6_x * w_313;
        let w_315 = inverse_lambda_loop4_y * w_311
            - l_lambda_loop6_x_lambda_loop4_y * w_314
            - l_lambda_loop6_y_lambda_loop4_y * w_313;
        let w_316 = inverse_lambda_loop4_x * w_308
            + l_lambda_loop4_y_lambda_loop4_x * w_315
            + l_lambda_loop6_x_lambda_loop4_x * w_314
            + l_lambda_loop6_y_lambda_loop4_x * w_313;
        let w_317 = inverse_lambda_loop3_y * w_306
            + l_lambda_loop4_x_lambda_loop3_y * w_316
            - l_lambda_loop4_y_lambda_loop3_y * w_315
            - l_lambda_loop4_x_lambda_loop3_y * w_314
            - l_lambda_loop4_y_lambda_loop3_y * w_313;
        let w_318 = minus_l_lambda_loop3_y_lambda_loop3_x * w_317
            - minus_inverse_lambda_loop3_x * w_304
            + l_lambda_loop4_x_lambda_loop3_x * w_316
            + minus_l_lambda_loop4_y_lambda_loop3_x * w_315
            - l_lambda_loop4_x_lambda_loop3_x * w_314
            + minus_l_lambda_loop4_y_lambda_loop3_x * w_313;
        let w_319 = minus_l_lambda_loop3_y_Theta * w_317 - l_lambda_loop3_x_Theta * w_318
            + l_lambda_loop3_x_Theta * w_316 + minus_l_lambda_loop3_y_Theta * w_315
            - l_lambda_loop3_x_Theta * w_314 + minus_l_lambda_loop3_y_Theta * w_313;
        let w_320 = w_157 * self.k_29;
        let w_337 = Phi_dot + w_157;
        let w_338 = delta_dot * (w_36 + w_41) + w_40 * w_337;
        let w_321 = n4_x * w_320;
        let w_323 = cos_w_2 * w_320;
        let w_322 = self.k_4 * w_321;
        let w_324 = self.k_4 * w_323;
        let w_325 = self.k_5 * (cos_w_2 * w_322 - n4_x * w_324);
        let w_326 = self.m4 * (w_39 * w_322 + w_41 * w_324) + l_delta_Phi * w_325;
        let w_327 = minus_l_lambda_loop4_x_Phi * w_325 - self.ee * w_321
            + l_lambda_loop4_x_delta * w_326;
        let w_328 = self.ee * w_323 + minus_l_lambda_loop4_y_Phi * w_325
            + l_lambda_loop4_y_delta * w_326 - l_lambda_loop4_y_lambda_loop4_x * w_327;
        let w_329 = l_lambda_loop6_x_lambda_loop4_x * w_327
            + l_lambda_loop6_x_lambda_loop4_y * w_328;
        let w_330 = inverse_lambda_loop6_y
            * (l_lambda_loop6_y_lambda_loop6_x * w_329
                - l_lambda_loop6_y_lambda_loop4_x * w_327
                - l_lambda_loop6_y_lambda_loop4_y * w_328);
        let w_331 = inverse_lambda_loop6_x * w_329
            + l_lambda_loop6_y_lambda_loop6_x * w_330;
        let w_332 = inverse_lambda_loop4_y * w_328
            + l_lambda_loop6_x_lambda_loop4_y * w_331
            - l_lambda_loop6_y_lambda_loop4_y * w_330;
        let w_333 = inverse_lambda_loop4_x * w_327
            - l_lambda_loop4_y_lambda_loop4_x * w_332
            + l_lambda_loop6_x_lambda_loop4_x * w_331
            - l_lambda_loop6_y_lambda_loop4_x * w_330;
        let w_383 = inverse_delta * w_326 + l_lambda_loop4_x_delta * w_333
            + l_lambda_loop4_y_delta * w_332;
        let w_334 = l_lambda_loop4_x_lambda_loop3_y * w_331
            - l_lambda_loop4_x_lambda_loop3_y * w_333
            - l_lambda_loop4_y_lambda_loop3_y * w_332
            - l_lambda_loop4_y_lambda_loop3_y * w_330;
        let w_335 = minus_l_lambda_loop3_y_lambda_loop3_x * w_334
            - l_lambda_loop4_x_lambda_loop3_x * w_333
            + minus_l_lambda_loop4_y_lambda_loop3_x * w_332
            + l_lambda_loop4_x_lambda_loop3_x * w_331
            + minus_l_lambda_loop4_y_lambda_loop3_x * w_330;
        let w_336 = minus_l_lambda_loop3_y_Theta * w_334 - l_lambda_loop3_x_Theta * w_335
            - l_lambda_loop3_x_Theta * w_333 + minus_l_lambda_loop3_y_Theta * w_332
            + l_lambda_loop3_x_Theta * w_331 + minus_l_lambda_loop3_y_Theta * w_330;
        let w_339 = self.k_4 * cos_w_2 * w_337 - delta_dot * (w_38 + w_39);
        let w_340 = self.k_5 * (cos_w_2 * w_338 - n4_x * w_339);
        let w_341 = self.m5 * (w_43 * w_42 * delta_dot - w_42 * w_43 * delta_dot)
            - self.m4 * (w_39 * w_338 + w_41 * w_339) - l_delta_Phi * w_340;
        let w_342 = minus_l_lambda_loop4_x_Phi * w_340
            - (delta_dot * (w_36 + minus_loop4_y_by_delta)
                + minus_loop4_y_by_Phi * w_337) - l_lambda_loop4_x_delta * w_341;
        let w_343 = minus_loop4_x_by_Phi * w_337 - delta_dot * (w_38 + loop4_x_by_delta)
            + minus_l_lambda_loop4_y_Phi * w_340 - l_lambda_loop4_y_delta * w_341
            - l_lambda_loop4_y_lambda_loop4_x * w_342;
        let w_344 = l_lambda_loop6_x_lambda_loop4_x * w_342
            + l_lambda_loop6_x_lambda_loop4_y * w_343;
        let w_345 = inverse_lambda_loop6_y
            * (l_lambda_loop6_y_lambda_loop6_x * w_344
                - l_lambda_loop6_y_lambda_loop4_x * w_342
                - l_lambda_loop6_y_lambda_loop4_y * w_343);
        let w_346 = inverse_lambda_loop6_x * w_344
            + l_lambda_loop6_y_lambda_loop6_x * w_345;
        let w_347 = inverse_lambda_loop4_y * w_343
            + l_lambda_loop6_x_lambda_loop4_y * w_346
            - l_lambda_loop6_y_lambda_loop4_y * w_345;
        let w_348 = inverse_lambda_loop4_x * w_342
            - l_lambda_loop4_y_lambda_loop4_x * w_347
            + l_lambda_loop6_x_lambda_loop4_x * w_346
            - l_lambda_loop6_y_lambda_loop4_x * w_345;
        let w_384 = inverse_delta * w_341 - l_lambda_loop4_x_delta * w_348
            - l_lambda_loop4_y_delta * w_347;
        let w_349 = l_lambda_loop4_x_lambda_loop3_y * w_346
            - l_lambda_loop4_x_lambda_loop3_y * w_348
            - l_lambda_loop4_y_lambda_loop3_y * w_347
            - l_lambda_loop4_y_lambda_loop3_y * w_345;
        let w_350 = minus_l_lambda_loop3_y_lambda_loop3_x * w_349
            - l_lambda_loop4_x_lambda_loop3_x * w_348
            + minus_l_lambda_loop4_y_lambda_loop3_x * w_347
            + l_lambda_loop4_x_lambda_loop3_x * w_346
            + minus_l_lambda_loop4_y_lambda_loop3_x * w_345;
        let w_351 = minus_l_lambda_loop3_y_Theta * w_349 - l_lambda_loop3_x_Theta * w_350
            - l_lambda_loop3_x_Theta * w_348 + minus_l_lambda_loop3_y_Theta * w_347
            + l_lambda_loop3_x_Theta * w_346 + minus_l_lambda_loop3_y_Theta * w_345;
        let w_352 = w_196 * self.k_29;
        let w_367 = Omega_dot + w_196;
        let w_369 = epsilon_dot * (w_60 + w_62) - w_61 * w_367;
        let w_353 = u6_x * w_352;
        let w_354 = u6_y * w_352;
        let w_355 = self.k_10 * w_354;
        let w_356 = self.k_10 * w_353;
        let w_357 = self.k_11 * (u6_x * w_355 - u6_y * w_356);
        let w_358 = self.m6 * (w_62 * w_356 + w_63 * w_355) - l_epsilon_Omega * w_357;
        let w_359 = self.zf * w_353 + l_lambda_loop6_x_Omega * w_357
            + l_lambda_loop6_x_epsilon * w_358;
        let w_360 = inverse_lambda_loop6_y
            * (minus_l_lambda_loop6_y_Omega * w_357 - self.zf * w_354
                - l_lambda_loop6_y_epsilon * w_358
                + l_lambda_loop6_y_lambda_loop6_x * w_359);
        let w_361 = inverse_lambda_loop6_x * w_359
            + l_lambda_loop6_y_lambda_loop6_x * w_360;
        let w_392 = inverse_epsilon * w_358 + l_lambda_loop6_x_epsilon * w_361
            - l_lambda_loop6_y_epsilon * w_360;
        let w_362 = l_lambda_loop6_x_lambda_loop4_y * w_361
            - l_lambda_loop6_y_lambda_loop4_y * w_360;
        let w_363 = l_lambda_loop6_x_lambda_loop4_x * w_361
            - l_lambda_loop4_y_lambda_loop4_x * w_362
            - l_lambda_loop6_y_lambda_loop4_x * w_360;
        let w_364 = l_lambda_loop4_x_lambda_loop3_y * w_361
            - l_lambda_loop4_x_lambda_loop3_y * w_363
            - l_lambda_loop4_y_lambda_loop3_y * w_362
            - l_lambda_loop4_y_lambda_loop3_y * w_360;
        let w_365 = minus_l_lambda_loop3_y_lambda_loop3_x * w_364
            - l_lambda_loop4_x_lambda_loop3_x * w_363
            + minus_l_lambda_loop4_y_lambda_loop3_x * w_362
            + l_lambda_loop4_x_lambda_loop3_x * w_361
            + minus_l_lambda_loop4_y_lambda_loop3_x * w_360;
        let w_366 = minus_l_lambda_loop3_y_Theta * w_364 - l_lambda_loop3_x_Theta * w_365
            - l_lambda_loop3_x_Theta * w_363 + minus_l_lambda_loop3_y_Theta * w_362
            + l_lambda_loop3_x_Theta * w_361 + minus_l_lambda_loop3_y_Theta * w_360;
        let w_368 = epsilon_dot * (w_59 + w_63) + self.k_10 * u6_x * w_367;
        let w_370 = self.k_11 * (u6_y * w_368 + u6_x * w_369);
        let w_371 = self.m6 * (w_62 * w_368 - w_63 * w_369)
            + self.m7 * (w_64 * w_65 * epsilon_dot - w_65 * w_64 * epsilon_dot)
            + l_epsilon_Omega * w_370;
        let w_372 = l_lambda_loop6_x_Omega * w_370
            - (epsilon_dot * (w_59 + minus_loop6_y_by_epsilon)
                + minus_loop6_y_by_Omega * w_367) - l_lambda_loop6_x_epsilon * w_371;
        let w_373 = inverse_lambda_loop6_y
            * (epsilon_dot * (w_60 + w_222) - loop6_x_by_Omega * w_367
                - minus_l_lambda_loop6_y_Omega * w_370 - l_lambda_loop6_y_epsilon * w_371
                - l_lambda_loop6_y_lambda_loop6_x * w_372);
        let w_374 = inverse_lambda_loop6_x * w_372
            - l_lambda_loop6_y_lambda_loop6_x * w_373;
        let w_375 = l_lambda_loop6_x_lambda_loop4_y * w_374
            + l_lambda_loop6_y_lambda_loop4_y * w_373;
        let w_376 = l_lambda_loop4_y_lambda_loop4_x * w_375
            - l_lambda_loop6_x_lambda_loop4_x * w_374
            - l_lambda_loop6_y_lambda_loop4_x * w_373;
        let w_377 = l_lambda_loop4_y_lambda_loop3_y * w_375
            - l_lambda_loop4_x_lambda_loop3_y * w_376
            - l_lambda_loop4_x_lambda_loop3_y * w_374
            - l_lambda_loop4_y_lambda_loop3_y * w_373;
        let w_378 = minus_l_lambda_loop3_y_lambda_loop3_x * w_377
            - l_lambda_loop4_x_lambda_loop3_x * w_376
            - minus_l_lambda_loop4_y_lambda_loop3_x * w_375
            - l_lambda_loop4_x_lambda_loop3_x * w_374
            + minus_l_lambda_loop4_y_lambda_loop3_x * w_373;
        let w_379 = minus_l_lambda_loop3_y_Theta * w_377 - l_lambda_loop3_x_Theta * w_378
            - l_lambda_loop3_x_Theta * w_376 - minus_l_lambda_loop3_y_Theta * w_375
            - l_lambda_loop3_x_Theta * w_374 + minus_l_lambda_loop3_y_Theta * w_373;
        let w_393 = inverse_epsilon * w_371 - l_lambda_loop6_x_epsilon * w_374
            - l_lambda_loop6_y_epsilon * w_373;
        let w_380 = l_lambda_loop4_x_delta * w_270 + l_lambda_loop4_y_delta * w_269;
        let w_381 = l_lambda_loop4_x_delta * w_298 + l_lambda_loop4_y_delta * w_297;
        let w_382 = l_lambda_loop4_x_delta * w_316 - l_lambda_loop4_y_delta * w_315;
        let w_385 = l_lambda_loop4_x_delta * w_363 + l_lambda_loop4_y_delta * w_362;
        let w_386 = l_lambda_loop4_y_delta * w_375 - l_lambda_loop4_x_delta * w_376;
        let w_387 = l_lambda_loop6_x_epsilon * w_268 + l_lambda_loop6_y_epsilon * w_267;
        let w_388 = l_lambda_loop6_x_epsilon * w_296 + l_lambda_loop6_y_epsilon * w_295;
        let w_389 = l_lambda_loop6_x_epsilon * w_314 + l_lambda_loop6_y_epsilon * w_313;
        let w_390 = l_lambda_loop6_x_epsilon * w_331 - l_lambda_loop6_y_epsilon * w_330;
        let w_391 = l_lambda_loop6_x_epsilon * w_346 - l_lambda_loop6_y_epsilon * w_345;
        sim_kernel::DynamicsJacobian {
            accelerations_by_positions: [
                [
                    inverse_beta * w_73 - l_Theta_beta * w_104
                        - l_lambda_loop3_x_beta * w_103 - l_lambda_loop3_y_beta * w_102
                        - l_lambda_loop3_x_beta * w_101 - l_lambda_loop3_y_beta * w_100
                        - l_lambda_loop3_x_beta * w_99 - l_lambda_loop3_y_beta * w_98,
                    inverse_beta * w_111 - l_Theta_beta * w_134
                        - l_lambda_loop3_x_beta * w_133 - l_lambda_loop3_y_beta * w_132
                        - l_lambda_loop3_x_beta * w_131 - l_lambda_loop3_y_beta * w_130
                        - l_lambda_loop3_x_beta * w_129 - l_lambda_loop3_y_beta * w_128,
                    l_lambda_loop3_x_beta * w_153 - l_Theta_beta * w_156
                        - l_lambda_loop3_x_beta * w_155 - l_lambda_loop3_y_beta * w_154
                        - l_lambda_loop3_y_beta * w_152 - l_lambda_loop3_x_beta * w_151
                        - l_lambda_loop3_y_beta * w_150,
                    l_lambda_loop3_x_beta * w_179 - l_Theta_beta * w_184
                        - l_lambda_loop3_x_beta * w_183 - l_lambda_loop3_y_beta * w_182
                        - l_lambda_loop3_x_beta * w_181 - l_lambda_loop3_y_beta * w_180
                        - l_lambda_loop3_y_beta * w_178,
                    l_lambda_loop3_x_beta * w_190 - l_Theta_beta * w_195
                        - l_lambda_loop3_x_beta * w_194 - l_lambda_loop3_y_beta * w_193
                        - l_lambda_loop3_x_beta * w_192 - l_lambda_loop3_y_beta * w_191
                        - l_lambda_loop3_y_beta * w_189,
                    l_lambda_loop3_y_beta * w_217 - l_Theta_beta * w_221
                        - l_lambda_loop3_x_beta * w_220 - l_lambda_loop3_y_beta * w_219
                        - l_lambda_loop3_x_beta * w_218 - l_lambda_loop3_x_beta * w_216
                        - l_lambda_loop3_y_beta * w_215,
                    l_lambda_loop3_y_beta * w_228 - l_Theta_beta * w_232
                        - l_lambda_loop3_x_beta * w_231 - l_lambda_loop3_y_beta * w_230
                        - l_lambda_loop3_x_beta * w_229 - l_lambda_loop3_x_beta * w_227
                        - l_lambda_loop3_y_beta * w_226,
                ],
                [w_104, w_134, w_156, w_184, w_195, w_221, w_232],
                [
                    minus_l_lambda_loop3_x_gamma * w_103
                        + minus_l_lambda_loop3_y_gamma * w_102,
                    minus_l_lambda_loop3_x_gamma * w_133
                        + minus_l_lambda_loop3_y_gamma * w_132,
                    inverse_gamma * w_140 + minus_l_lambda_loop3_x_gamma * w_155
                        + minus_l_lambda_loop3_y_gamma * w_154,
                    minus_l_lambda_loop3_x_gamma * w_183
                        + minus_l_lambda_loop3_y_gamma * w_182,
                    minus_l_lambda_loop3_x_gamma * w_194
                        + minus_l_lambda_loop3_y_gamma * w_193,
                    minus_l_lambda_loop3_x_gamma * w_220
                        + minus_l_lambda_loop3_y_gamma * w_219,
                    minus_l_lambda_loop3_x_gamma * w_231
                        + minus_l_lambda_loop3_y_gamma * w_230,
                ],
                [
                    l_delta_Phi * w_233 + minus_l_lambda_loop4_x_Phi * w_101
                        + minus_l_lambda_loop4_y_Phi * w_100,
                    l_delta_Phi * w_234 + minus_l_lambda_loop4_x_Phi * w_131
                        + minus_l_lambda_loop4_y_Phi * w_130,
                    minus_l_lambda_loop4_y_Phi * w_152 - l_delta_Phi * w_235
                        - minus_l_lambda_loop4_x_Phi * w_153,
                    self.inverse_Phi * w_171 - l_delta_Phi * w_236
                        + minus_l_lambda_loop4_x_Phi * w_181
                        + minus_l_lambda_loop4_y_Phi * w_180,
                    self.inverse_Phi * w_169 + l_delta_Phi * w_237
                        + minus_l_lambda_loop4_x_Phi * w_192
                        + minus_l_lambda_loop4_y_Phi * w_191,
                    minus_l_lambda_loop4_x_Phi * w_218 - l_delta_Phi * w_238
                        - minus_l_lambda_loop4_y_Phi * w_217,
                    minus_l_lambda_loop4_x_Phi * w_229 - l_delta_Phi * w_239
                        - minus_l_lambda_loop4_y_Phi * w_228,
                ],
                [-w_233, -w_234, w_235, w_236, -w_237, w_238, w_239],
                [
                    l_epsilon_Omega * w_240 - l_lambda_loop6_x_Omega * w_99
                        + minus_l_lambda_loop6_y_Omega * w_98,
                    l_epsilon_Omega * w_241 - l_lambda_loop6_x_Omega * w_129
                        + minus_l_lambda_loop6_y_Omega * w_128,
                    l_epsilon_Omega * w_242 - l_lambda_loop6_x_Omega * w_151
                        + minus_l_lambda_loop6_y_Omega * w_150,
                    l_lambda_loop6_x_Omega * w_179 - l_epsilon_Omega * w_243
                        + minus_l_lambda_loop6_y_Omega * w_178,
                    l_lambda_loop6_x_Omega * w_190 - l_epsilon_Omega * w_244
                        + minus_l_lambda_loop6_y_Omega * w_189,
                    self.inverse_Omega * w_211 - l_epsilon_Omega * w_245
                        - l_lambda_loop6_x_Omega * w_216
                        + minus_l_lambda_loop6_y_Omega * w_215,
                    minus_l_lambda_loop6_y_Omega * w_226 - self.inverse_Omega * w_209
                        - l_epsilon_Omega * w_246 - l_lambda_loop6_x_Omega * w_227,
                ],
                [-w_240, -w_241, -w_242, w_243, w_244, w_245, w_246],
            ],
            accelerations_by_speeds: [
                [
                    -w_274,
                    inverse_beta * w_278 - l_Theta_beta * w_301
                        - l_lambda_loop3_x_beta * w_300 - l_lambda_loop3_y_beta * w_299
                        - l_lambda_loop3_x_beta * w_298 - l_lambda_loop3_y_beta * w_297
                        - l_lambda_loop3_x_beta * w_296 - l_lambda_loop3_y_beta * w_295,
                    l_lambda_loop3_x_beta * w_316 - l_Theta_beta * w_319
                        - l_lambda_loop3_x_beta * w_318 - l_lambda_loop3_y_beta * w_317
                        - l_lambda_loop3_y_beta * w_315 - l_lambda_loop3_x_beta * w_314
                        - l_lambda_loop3_y_beta * w_313,
                    l_lambda_loop3_x_beta * w_331 - l_Theta_beta * w_336
                        - l_lambda_loop3_x_beta * w_335 - l_lambda_loop3_y_beta * w_334
                        - l_lambda_loop3_x_beta * w_333 - l_lambda_loop3_y_beta * w_332
                        - l_lambda_loop3_y_beta * w_330,
                    l_lambda_loop3_x_beta * w_346 - l_Theta_beta * w_351
                        - l_lambda_loop3_x_beta * w_350 - l_lambda_loop3_y_beta * w_349
                        - l_lambda_loop3_x_beta * w_348 - l_lambda_loop3_y_beta * w_347
                        - l_lambda_loop3_y_beta * w_345,
                    l_lambda_loop3_x_beta * w_361 - l_Theta_beta * w_366
                        - l_lambda_loop3_x_beta * w_365 - l_lambda_loop3_y_beta * w_364
                        - l_lambda_loop3_x_beta * w_363 - l_lambda_loop3_y_beta * w_362
                        - l_lambda_loop3_y_beta * w_360,
                    l_lambda_loop3_y_beta * w_375 - l_Theta_beta * w_379
                        - l_lambda_loop3_x_beta * w_378 - l_lambda_loop3_y_beta * w_377
                        - l_lambda_loop3_x_beta * w_376 - l_lambda_loop3_x_beta * w_374
                        - l_lambda_loop3_y_beta * w_373,
                ],
                [w_273, w_301, w_319, w_336, w_351, w_366, w_379],
                [
                    minus_l_lambda_loop3_x_gamma * w_272
                        + minus_l_lambda_loop3_y_gamma * w_271,
                    minus_l_lambda_loop3_x_gamma * w_300
                        + minus_l_lambda_loop3_y_gamma * w_299,
                    inverse_gamma * w_302 + minus_l_lambda_loop3_x_gamma * w_318
                        + minus_l_lambda_loop3_y_gamma * w_317,
                    minus_l_lambda_loop3_x_gamma * w_335
                        + minus_l_lambda_loop3_y_gamma * w_334,
                    minus_l_lambda_loop3_x_gamma * w_350
                        + minus_l_lambda_loop3_y_gamma * w_349,
                    minus_l_lambda_loop3_x_gamma * w_365
                        + minus_l_lambda_loop3_y_gamma * w_364,
                    minus_l_lambda_loop3_x_gamma * w_378
                        + minus_l_lambda_loop3_y_gamma * w_377,
                ],
                [
                    l_delta_Phi * w_380 + minus_l_lambda_loop4_x_Phi * w_270
                        + minus_l_lambda_loop4_y_Phi * w_269,
                    l_delta_Phi * w_381 + minus_l_lambda_loop4_x_Phi * w_298
                        + minus_l_lambda_loop4_y_Phi * w_297,
                    minus_l_lambda_loop4_y_Phi * w_315 - l_delta_Phi * w_382
                        - minus_l_lambda_loop4_x_Phi * w_316,
                    self.inverse_Phi * w_325 + l_delta_Phi * w_383
                        + minus_l_lambda_loop4_x_Phi * w_333
                        + minus_l_lambda_loop4_y_Phi * w_332,
                    self.inverse_Phi * w_340 - l_delta_Phi * w_384
                        + minus_l_lambda_loop4_x_Phi * w_348
                        + minus_l_lambda_loop4_y_Phi * w_347,
                    l_delta_Phi * w_385 + minus_l_lambda_loop4_x_Phi * w_363
                        + minus_l_lambda_loop4_y_Phi * w_362,
                    minus_l_lambda_loop4_x_Phi * w_376 - l_delta_Phi * w_386
                        - minus_l_lambda_loop4_y_Phi * w_375,
                ],
                [-w_380, -w_381, w_382, -w_383, w_384, -w_385, w_386],
                [
                    l_epsilon_Omega * w_387 - l_lambda_loop6_x_Omega * w_268
                        + minus_l_lambda_loop6_y_Omega * w_267,
                    l_epsilon_Omega * w_388 - l_lambda_loop6_x_Omega * w_296
                        + minus_l_lambda_loop6_y_Omega * w_295,
                    l_epsilon_Omega * w_389 - l_lambda_loop6_x_Omega * w_314
                        + minus_l_lambda_loop6_y_Omega * w_313,
                    l_lambda_loop6_x_Omega * w_331 - l_epsilon_Omega * w_390
                        + minus_l_lambda_loop6_y_Omega * w_330,
                    l_lambda_loop6_x_Omega * w_346 - l_epsilon_Omega * w_391
                        + minus_l_lambda_loop6_y_Omega * w_345,
                    self.inverse_Omega * w_357 - l_epsilon_Omega * w_392
                        + l_lambda_loop6_x_Omega * w_361
                        + minus_l_lambda_loop6_y_Omega * w_360,
                    minus_l_lambda_loop6_y_Omega * w_373 - self.inverse_Omega * w_370
                        - l_epsilon_Omega * w_393 - l_lambda_loop6_x_Omega * w_374,
                ],
                [-w_387, -w_388, -w_389, w_390, w_391, w_392, w_393],
            ],
            multipliers_by_positions: [
                [w_103, w_133, w_155, w_183, w_194, w_220, w_231],
                [w_102, w_132, w_154, w_182, w_193, w_219, w_230],
                [w_101, w_131, -w_153, w_181, w_192, w_218, w_229],
                [w_100, w_130, w_152, w_180, w_191, -w_217, -w_228],
                [w_99, w_129, w_151, -w_179, -w_190, w_216, w_227],
                [w_98, w_128, w_150, w_178, w_189, w_215, w_226],
            ],
            multipliers_by_speeds: [
                [w_272, w_300, w_318, w_335, w_350, w_365, w_378],
                [w_271, w_299, w_317, w_334, w_349, w_364, w_377],
                [w_270, w_298, -w_316, w_333, w_348, w_363, w_376],
                [w_269, w_297, w_315, w_332, w_347, w_362, -w_375],
                [w_268, w_296, w_314, -w_331, -w_346, -w_361, w_374],
                [w_267, w_295, w_313, w_330, w_345, w_360, w_373],
            ],
            refused: sim_kernel::pivot_is_refused(mass_beta_beta, mass_beta_beta)
                | sim_kernel::pivot_is_refused(mass_gamma_gamma, mass_gamma_gamma)
                | sim_kernel::pivot_is_refused(pivot_Theta, self.mass_Theta_Theta)
                | sim_kernel::pivot_is_refused(self.mass_Phi_Phi, self.mass_Phi_Phi)
                | sim_kernel::pivot_is_refused(
                    -minus_pivot_lambda_loop3_x,
                    minus_pivot_lambda_loop3_x,
                ) | sim_kernel::pivot_is_refused(pivot_delta, mass_delta_delta)
                | sim_kernel::pivot_is_refused(pivot_lambda_loop3_y, w_46)
                | sim_kernel::pivot_is_refused(
                    self.mass_Omega_Omega,
                    self.mass_Omega_Omega,
                ) | sim_kernel::pivot_is_refused(pivot_lambda_loop4_x, w_54)
                | sim_kernel::pivot_is_refused(pivot_epsilon, mass_epsilon_epsilon)
                | sim_kernel::pivot_is_refused(pivot_lambda_loop4_y, w_67)
                | sim_kernel::pivot_is_refused(pivot_lambda_loop6_x, w_69)
                | sim_kernel::pivot_is_refused(pivot_lambda_loop6_y, w_70),
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
    type Entries = [S; 0];
    type Envelope = [S; 0];
    type Parameters = [S; 42];
    type Outputs = [S; 8];
    type OutputRates = [S; 7];
    type Events = [S; 0];
    type EventValues = [S; 0];
    type Activities = [S; 0];
    type Drawing = [S; 38];
    type QP = [[S; 42]; 7];
    type LP = [[S; 42]; 6];
    type Inputs = [sim_kernel::Input<S>; 0];
    type Prepared = AndrewsPrepared<S>;
    type On<T: sim_kernel::Scalar> = Andrews<T>;
    const DESCRIPTION: sim_kernel::Description = sim_kernel::Description {
        name: "andrews",
        type_name: "Andrews",
        docs: "Andrews' squeezing mechanism: seven bodies, three loops; run it for 30 ms (`--t-end 30ms`).\nA constant torque turns crank 1 against a spring; the motion grows until nothing holds it.",
        declaration: "/// Andrews' squeezing mechanism: seven bodies, three loops; run it for 30 ms (`--t-end 30ms`).\n/// A constant torque turns crank 1 against a spring; the motion grows until nothing holds it.\npub Andrews;\n\ncoordinates { beta [rad]; Theta [rad]; gamma [rad]; Phi [rad]; delta [rad]; Omega [rad]; epsilon [rad]; }\n\nparameters {\n    m1 [kg] = 0.04325; m2 [kg] = 0.00365; m3 [kg] = 0.02373; m4 [kg] = 0.00706;\n    m5 [kg] = 0.0705; m6 [kg] = 0.00706; m7 [kg] = 0.05498;\n    i1 [kg*m^2] = 2.194e-6; i2 [kg*m^2] = 4.41e-7; i3 [kg*m^2] = 5.255e-6; i4 [kg*m^2] = 5.667e-7;\n    i5 [kg*m^2] = 1.169e-5; i6 [kg*m^2] = 5.667e-7; i7 [kg*m^2] = 1.912e-5;\n    xa [m] = -0.06934; ya [m] = -0.00227; xb [m] = -0.03635; yb [m] = 0.03273; xc [m] = 0.014; yc [m] = 0.072;\n    /// Stiffness of the spring.\n    c0 [N/m] = 4530;\n    /// Free length of the spring.\n    l0 [m] = 0.07785;\n    /// Torque on crank 1.\n    mom [N*m] = 0.033;\n    d [mm] = 28; da [mm] = 11.5; ee [mm] = 20; ea [mm] = 14.21; rr [mm] = 7; ra [mm] = 0.92; ss [mm] = 35;\n    sa [mm] = 18.74; sb [mm] = 10.43; sc [mm] = 18; sd [mm] = 20; ta [mm] = 23.08; tb [mm] = 9.16;\n    u [mm] = 40; ua [mm] = 12.28; ub [mm] = 4.49; zf [mm] = 20; zt [mm] = 40; fa [mm] = 14.21;\n}\n\nlet O = [0, 0];\nlet A = [xa, ya];\nlet B = [xb, yb];\nlet C = [xc, yc];\nlet u1 = [cos(beta), sin(beta)];\nlet u2 = [cos(beta + Theta), sin(beta + Theta)];\nlet u3 = [cos(gamma), sin(gamma)];\nlet n3 = [sin(gamma), -cos(gamma)];\nlet n4 = [sin(Phi + delta), -cos(Phi + delta)];\nlet u5 = [cos(delta), sin(delta)];\nlet n5 = [sin(delta), -cos(delta)];\nlet u6 = [cos(Omega + epsilon), sin(Omega + epsilon)];\nlet u7 = [cos(epsilon), sin(epsilon)];\nlet n7 = [sin(epsilon), -cos(epsilon)];\nlet F = rr*u1;\nlet P = F - d*u2;\nlet D = B + sc*n3 + sd*u3;\nlet E = A + zt*u5;\nlet G = A + u*n7;\nlet stretch = norm(D - C) - l0;\n\nbodies {\n    crank1: mass m1 at ra*u1, inertia i1, angle beta;\n    bar2: mass m2 at F - da*u2, inertia i2, angle beta + Theta;\n    plate3: mass m3 at B + sa*n3 + sb*u3, inertia i3, angle gamma;\n    bar4: mass m4 at E + (ee - ea)*n4, inertia i4, angle Phi + delta;\n    plate5: mass m5 at A + ta*u5 - tb*n5, inertia i5, angle delta;\n    bar6: mass m6 at G + (zf - fa)*u6, inertia i6, angle Omega + epsilon;\n    plate7: mass m7 at A + ua*n7 - ub*u7, inertia i7, angle epsilon;\n}\n\nloads {\n    torque mom on crank1;\n    force c0*stretch*(C - D)/norm(D - C) at D;\n}\n\nconstraints {\n    loop3: P = B + ss*n3;\n    loop4: P = E + ee*n4;\n    loop6: P = G + zf*u6;\n}\n\ninitial {\n    Theta = 0;\n    guess beta = -0.06;\n    guess gamma = 0.46;\n    guess Phi = 0.22;\n    guess delta = 0.49;\n    guess Omega = -0.22;\n    guess epsilon = 1.23;\n}\n\noutputs {\n    crank \"Crank 1\" {\n        /// angle of the crank\n        crank_angle [rad] = beta;\n    }\n    swings \"Angles of the other bodies\" {\n        /// plate 3\n        plate3_angle [rad] = gamma;\n        /// bar 4\n        bar4_angle [rad] = Phi + delta;\n        /// plate 5\n        plate5_angle [rad] = delta;\n        /// bar 6\n        bar6_angle [rad] = Omega + epsilon;\n        /// plate 7\n        plate7_angle [rad] = epsilon;\n    }\n    spring_force \"Spring\" {\n        /// force of the spring\n        pull [N] = c0*stretch;\n    }\n    /// Joint force in P on plate 3\n    joint_force [N] = norm(reaction(loop3));\n}\n\ndrawing {\n    ground O, A, B, C;\n    line O, F, P;\n    line B, P;\n    line B, D;\n    spring D, C;\n    line A, E, P;\n    line A, G, P;\n}\n",
        coordinates: &[
            sim_kernel::Coordinate {
                position: sim_kernel::Quantity {
                    name: "beta",
                    unit: "rad",
                    factor: 1f64,
                    is_length: false,
                    docs: "",
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
                    name: "Theta",
                    unit: "rad",
                    factor: 1f64,
                    is_length: false,
                    docs: "",
                },
                speed: sim_kernel::Quantity {
                    name: "Theta_dot",
                    unit: "rad/s",
                    factor: 1f64,
                    is_length: false,
                    docs: "",
                },
                acceleration: sim_kernel::Quantity {
                    name: "Theta_ddot",
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
                    name: "gamma",
                    unit: "rad",
                    factor: 1f64,
                    is_length: false,
                    docs: "",
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
            sim_kernel::Coordinate {
                position: sim_kernel::Quantity {
                    name: "Phi",
                    unit: "rad",
                    factor: 1f64,
                    is_length: false,
                    docs: "",
                },
                speed: sim_kernel::Quantity {
                    name: "Phi_dot",
                    unit: "rad/s",
                    factor: 1f64,
                    is_length: false,
                    docs: "",
                },
                acceleration: sim_kernel::Quantity {
                    name: "Phi_ddot",
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
                    name: "delta",
                    unit: "rad",
                    factor: 1f64,
                    is_length: false,
                    docs: "",
                },
                speed: sim_kernel::Quantity {
                    name: "delta_dot",
                    unit: "rad/s",
                    factor: 1f64,
                    is_length: false,
                    docs: "",
                },
                acceleration: sim_kernel::Quantity {
                    name: "delta_ddot",
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
                    name: "Omega",
                    unit: "rad",
                    factor: 1f64,
                    is_length: false,
                    docs: "",
                },
                speed: sim_kernel::Quantity {
                    name: "Omega_dot",
                    unit: "rad/s",
                    factor: 1f64,
                    is_length: false,
                    docs: "",
                },
                acceleration: sim_kernel::Quantity {
                    name: "Omega_ddot",
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
                    name: "epsilon",
                    unit: "rad",
                    factor: 1f64,
                    is_length: false,
                    docs: "",
                },
                speed: sim_kernel::Quantity {
                    name: "epsilon_dot",
                    unit: "rad/s",
                    factor: 1f64,
                    is_length: false,
                    docs: "",
                },
                acceleration: sim_kernel::Quantity {
                    name: "epsilon_ddot",
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
                name: "m1",
                unit: "kg",
                factor: 1f64,
                is_length: false,
                docs: "",
            },
            sim_kernel::Quantity {
                name: "m2",
                unit: "kg",
                factor: 1f64,
                is_length: false,
                docs: "",
            },
            sim_kernel::Quantity {
                name: "m3",
                unit: "kg",
                factor: 1f64,
                is_length: false,
                docs: "",
            },
            sim_kernel::Quantity {
                name: "m4",
                unit: "kg",
                factor: 1f64,
                is_length: false,
                docs: "",
            },
            sim_kernel::Quantity {
                name: "m5",
                unit: "kg",
                factor: 1f64,
                is_length: false,
                docs: "",
            },
            sim_kernel::Quantity {
                name: "m6",
                unit: "kg",
                factor: 1f64,
                is_length: false,
                docs: "",
            },
            sim_kernel::Quantity {
                name: "m7",
                unit: "kg",
                factor: 1f64,
                is_length: false,
                docs: "",
            },
            sim_kernel::Quantity {
                name: "i1",
                unit: "kg*m^2",
                factor: 1f64,
                is_length: false,
                docs: "",
            },
            sim_kernel::Quantity {
                name: "i2",
                unit: "kg*m^2",
                factor: 1f64,
                is_length: false,
                docs: "",
            },
            sim_kernel::Quantity {
                name: "i3",
                unit: "kg*m^2",
                factor: 1f64,
                is_length: false,
                docs: "",
            },
            sim_kernel::Quantity {
                name: "i4",
                unit: "kg*m^2",
                factor: 1f64,
                is_length: false,
                docs: "",
            },
            sim_kernel::Quantity {
                name: "i5",
                unit: "kg*m^2",
                factor: 1f64,
                is_length: false,
                docs: "",
            },
            sim_kernel::Quantity {
                name: "i6",
                unit: "kg*m^2",
                factor: 1f64,
                is_length: false,
                docs: "",
            },
            sim_kernel::Quantity {
                name: "i7",
                unit: "kg*m^2",
                factor: 1f64,
                is_length: false,
                docs: "",
            },
            sim_kernel::Quantity {
                name: "xa",
                unit: "m",
                factor: 1f64,
                is_length: true,
                docs: "",
            },
            sim_kernel::Quantity {
                name: "ya",
                unit: "m",
                factor: 1f64,
                is_length: true,
                docs: "",
            },
            sim_kernel::Quantity {
                name: "xb",
                unit: "m",
                factor: 1f64,
                is_length: true,
                docs: "",
            },
            sim_kernel::Quantity {
                name: "yb",
                unit: "m",
                factor: 1f64,
                is_length: true,
                docs: "",
            },
            sim_kernel::Quantity {
                name: "xc",
                unit: "m",
                factor: 1f64,
                is_length: true,
                docs: "",
            },
            sim_kernel::Quantity {
                name: "yc",
                unit: "m",
                factor: 1f64,
                is_length: true,
                docs: "",
            },
            sim_kernel::Quantity {
                name: "c0",
                unit: "N/m",
                factor: 1f64,
                is_length: false,
                docs: "Stiffness of the spring.",
            },
            sim_kernel::Quantity {
                name: "l0",
                unit: "m",
                factor: 1f64,
                is_length: true,
                docs: "Free length of the spring.",
            },
            sim_kernel::Quantity {
                name: "mom",
                unit: "N*m",
                factor: 1f64,
                is_length: false,
                docs: "Torque on crank 1.",
            },
            sim_kernel::Quantity {
                name: "d",
                unit: "mm",
                factor: 0.001f64,
                is_length: true,
                docs: "",
            },
            sim_kernel::Quantity {
                name: "da",
                unit: "mm",
                factor: 0.001f64,
                is_length: true,
                docs: "",
            },
            sim_kernel::Quantity {
                name: "ee",
                unit: "mm",
                factor: 0.001f64,
                is_length: true,
                docs: "",
            },
            sim_kernel::Quantity {
                name: "ea",
                unit: "mm",
                factor: 0.001f64,
                is_length: true,
                docs: "",
            },
            sim_kernel::Quantity {
                name: "rr",
                unit: "mm",
                factor: 0.001f64,
                is_length: true,
                docs: "",
            },
            sim_kernel::Quantity {
                name: "ra",
                unit: "mm",
                factor: 0.001f64,
                is_length: true,
                docs: "",
            },
            sim_kernel::Quantity {
                name: "ss",
                unit: "mm",
                factor: 0.001f64,
                is_length: true,
                docs: "",
            },
            sim_kernel::Quantity {
                name: "sa",
                unit: "mm",
                factor: 0.001f64,
                is_length: true,
                docs: "",
            },
            sim_kernel::Quantity {
                name: "sb",
                unit: "mm",
                factor: 0.001f64,
                is_length: true,
                docs: "",
            },
            sim_kernel::Quantity {
                name: "sc",
                unit: "mm",
                factor: 0.001f64,
                is_length: true,
                docs: "",
            },
            sim_kernel::Quantity {
                name: "sd",
                unit: "mm",
                factor: 0.001f64,
                is_length: true,
                docs: "",
            },
            sim_kernel::Quantity {
                name: "ta",
                unit: "mm",
                factor: 0.001f64,
                is_length: true,
                docs: "",
            },
            sim_kernel::Quantity {
                name: "tb",
                unit: "mm",
                factor: 0.001f64,
                is_length: true,
                docs: "",
            },
            sim_kernel::Quantity {
                name: "u",
                unit: "mm",
                factor: 0.001f64,
                is_length: true,
                docs: "",
            },
            sim_kernel::Quantity {
                name: "ua",
                unit: "mm",
                factor: 0.001f64,
                is_length: true,
                docs: "",
            },
            sim_kernel::Quantity {
                name: "ub",
                unit: "mm",
                factor: 0.001f64,
                is_length: true,
                docs: "",
            },
            sim_kernel::Quantity {
                name: "zf",
                unit: "mm",
                factor: 0.001f64,
                is_length: true,
                docs: "",
            },
            sim_kernel::Quantity {
                name: "zt",
                unit: "mm",
                factor: 0.001f64,
                is_length: true,
                docs: "",
            },
            sim_kernel::Quantity {
                name: "fa",
                unit: "mm",
                factor: 0.001f64,
                is_length: true,
                docs: "",
            },
        ],
        inputs: &[],
        constraints: &[
            sim_kernel::Quantity {
                name: "loop3_x",
                unit: "N",
                factor: 1f64,
                is_length: false,
                docs: "",
            },
            sim_kernel::Quantity {
                name: "loop3_y",
                unit: "N",
                factor: 1f64,
                is_length: false,
                docs: "",
            },
            sim_kernel::Quantity {
                name: "loop4_x",
                unit: "N",
                factor: 1f64,
                is_length: false,
                docs: "",
            },
            sim_kernel::Quantity {
                name: "loop4_y",
                unit: "N",
                factor: 1f64,
                is_length: false,
                docs: "",
            },
            sim_kernel::Quantity {
                name: "loop6_x",
                unit: "N",
                factor: 1f64,
                is_length: false,
                docs: "",
            },
            sim_kernel::Quantity {
                name: "loop6_y",
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
        events: &[],
        outputs: &[
            sim_kernel::Quantity {
                name: "crank_angle",
                unit: "rad",
                factor: 1f64,
                is_length: false,
                docs: "angle of the crank",
            },
            sim_kernel::Quantity {
                name: "plate3_angle",
                unit: "rad",
                factor: 1f64,
                is_length: false,
                docs: "plate 3",
            },
            sim_kernel::Quantity {
                name: "bar4_angle",
                unit: "rad",
                factor: 1f64,
                is_length: false,
                docs: "bar 4",
            },
            sim_kernel::Quantity {
                name: "plate5_angle",
                unit: "rad",
                factor: 1f64,
                is_length: false,
                docs: "plate 5",
            },
            sim_kernel::Quantity {
                name: "bar6_angle",
                unit: "rad",
                factor: 1f64,
                is_length: false,
                docs: "bar 6",
            },
            sim_kernel::Quantity {
                name: "plate7_angle",
                unit: "rad",
                factor: 1f64,
                is_length: false,
                docs: "plate 7",
            },
            sim_kernel::Quantity {
                name: "pull",
                unit: "N",
                factor: 1f64,
                is_length: false,
                docs: "force of the spring",
            },
            sim_kernel::Quantity {
                name: "joint_force",
                unit: "N",
                factor: 1f64,
                is_length: false,
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
        optional_kernels: &["dynamics_jacobian"],
        dimension: 2,
        drawing: &[
            sim_kernel::Shape::Ground(4),
            sim_kernel::Shape::Line(3),
            sim_kernel::Shape::Line(2),
            sim_kernel::Shape::Line(2),
            sim_kernel::Shape::Spring,
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
    fn with_parameters(&self, parameters: [S; 42]) -> Self {
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
            ..*self
        }
    }
    fn on<T: sim_kernel::Scalar>(
        &self,
        convert: impl ::core::ops::Fn(S) -> T,
    ) -> Andrews<T> {
        Andrews {
            m1: convert(self.m1),
            m2: convert(self.m2),
            m3: convert(self.m3),
            m4: convert(self.m4),
            m5: convert(self.m5),
            m6: convert(self.m6),
            m7: convert(self.m7),
            i1: convert(self.i1),
            i2: convert(self.i2),
            i3: convert(self.i3),
            i4: convert(self.i4),
            i5: convert(self.i5),
            i6: convert(self.i6),
            i7: convert(self.i7),
            xa: convert(self.xa),
            ya: convert(self.ya),
            xb: convert(self.xb),
            yb: convert(self.yb),
            xc: convert(self.xc),
            yc: convert(self.yc),
            c0: convert(self.c0),
            l0: convert(self.l0),
            mom: convert(self.mom),
            d: convert(self.d),
            da: convert(self.da),
            ee: convert(self.ee),
            ea: convert(self.ea),
            rr: convert(self.rr),
            ra: convert(self.ra),
            ss: convert(self.ss),
            sa: convert(self.sa),
            sb: convert(self.sb),
            sc: convert(self.sc),
            sd: convert(self.sd),
            ta: convert(self.ta),
            tb: convert(self.tb),
            u: convert(self.u),
            ua: convert(self.ua),
            ub: convert(self.ub),
            zf: convert(self.zf),
            zt: convert(self.zt),
            fa: convert(self.fa),
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
    fn prepare(&self) -> AndrewsPrepared<S> {
        self.prepare()
    }
    #[inline(always)]
    fn prepared_dynamics(
        prepared: &Self::Prepared,
        t: S,
        q: &[S; 7],
        qd: &[S; 7],
    ) -> sim_kernel::Dynamics<S, [S; 7], [S; 6]> {
        prepared.dynamics(t, q, qd)
    }
    #[inline(always)]
    fn dynamics_jacobian(
        &self,
        t: S,
        q: &[S; 7],
        qd: &[S; 7],
    ) -> sim_kernel::DynamicsJacobian<S, [[S; 7]; 7], [[S; 7]; 6]> {
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
    fn events(
        &self,
        t: S,
        q: &[S; 7],
        qd: &[S; 7],
        qdd: &[S; 7],
        lambda: &[S; 6],
    ) -> [S; 0] {
        self.events(t, q, qd, qdd, lambda)
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
