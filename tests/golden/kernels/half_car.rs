/// Half a car, seen from the side, drives over a bump: bounce and pitch from equilibrium.
///
/// The fields are its parameters, in SI units; the methods are its kernels.
///
/// # Equations of motion
///
/// ```text
/// mass_matrix * accelerations = generalized_forces - convective_forces
/// coordinates = [y; phi]
/// [m, 0; 0, J] * [y_ddot; phi_ddot] = [-s_3 - s_4 - s_5 - s_6; generalized_forces[2]]
///
/// mass_matrix = [m, 0; 0, J]
///
/// convective_forces = [0; 0]
///
/// generalized_forces = [-s_3 - s_4 - s_5 - s_6; generalized_forces[2]]
/// generalized_forces[2] = lr*(s_4 + s_6) - lf*(s_3 + s_5)
///
/// s_1 = exp(-(lf - s0 + t*v)^2/w^2)
/// front_road = H*s_1
/// s_2 = exp(-(lr + s0 - t*v)^2/w^2)
/// rear_road = H*s_2
/// s_3 = kf*(y - front_road + phi*lf)
/// s_4 = kr*(y - rear_road - phi*lr)
/// s_5 = cf*(y_dot + 2*v*H*s_1*(lf - s0 + t*v)/w^2 + lf*phi_dot)
/// s_6 = cr*(y_dot - 2*v*H*s_2*(lr + s0 - t*v)/w^2 - lr*phi_dot)
/// ```
#[allow(non_snake_case)]
#[derive(
    ::core::clone::Clone,
    ::core::marker::Copy,
    ::core::fmt::Debug,
    ::core::cmp::PartialEq
)]
pub struct HalfCar<S = ::core::primitive::f64> {
    /// Mass of the body, in `kg`.
    pub m: S,
    /// Inertia of the body, in `kg*m^2`.
    pub J: S,
    /// From the centre of mass to the front axle, in `m`.
    pub lf: S,
    /// From the centre of mass to the rear axle, in `m`.
    pub lr: S,
    /// Stiffness of the front spring, in `N/m`.
    pub kf: S,
    /// Stiffness of the rear spring, in `N/m`.
    pub kr: S,
    /// Damping in front, in `N*s/m`.
    pub cf: S,
    /// Damping behind, in `N*s/m`.
    pub cr: S,
    /// Speed, in `m/s`.
    pub v: S,
    /// Height of the bump, in `m`.
    pub H: S,
    /// Half of its width, where it has fallen to a third, in `m`.
    pub w: S,
    /// Where its top is, in `m`.
    pub s0: S,
    /// Radius of the wheels, for drawings, in `m`.
    pub R: S,
}
impl<S: sim_kernel::Scalar> ::core::default::Default for HalfCar<S> {
    /// The declared values.
    fn default() -> Self {
        <Self as sim_kernel::Mechanism<S>>::defaults()
    }
}
/// Coordinates of [`HalfCar`] by name, in SI units; also for their speeds and accelerations.
#[allow(non_snake_case)]
#[derive(
    ::core::clone::Clone,
    ::core::marker::Copy,
    ::core::fmt::Debug,
    ::core::cmp::PartialEq
)]
pub struct HalfCarCoordinates<S = ::core::primitive::f64> {
    /// Bounce of the centre of mass, in `m`.
    pub y: S,
    /// Pitch, the front upwards, in `rad`.
    pub phi: S,
}
impl<S: sim_kernel::Scalar> ::core::convert::From<[S; 2]> for HalfCarCoordinates<S> {
    fn from(values: [S; 2]) -> Self {
        Self {
            y: values[0],
            phi: values[1],
        }
    }
}
impl<S: sim_kernel::Scalar> ::core::convert::From<HalfCarCoordinates<S>> for [S; 2] {
    fn from(record: HalfCarCoordinates<S>) -> Self {
        [record.y, record.phi]
    }
}
/// Outputs of [`HalfCar`] by name, in SI units.
#[allow(non_snake_case)]
#[derive(
    ::core::clone::Clone,
    ::core::marker::Copy,
    ::core::fmt::Debug,
    ::core::cmp::PartialEq
)]
pub struct HalfCarOutputs<S = ::core::primitive::f64> {
    /// body, in `m`.
    pub body: S,
    /// road at the front axle, in `m`.
    pub road: S,
    /// pitch, in `1`.
    pub pitch_angle: S,
    /// acceleration, in `m/s^2`.
    pub acceleration: S,
    /// front, in `N`.
    pub front_force: S,
    /// rear, in `N`.
    pub rear_force: S,
}
impl<S: sim_kernel::Scalar> ::core::convert::From<[S; 6]> for HalfCarOutputs<S> {
    fn from(values: [S; 6]) -> Self {
        Self {
            body: values[0],
            road: values[1],
            pitch_angle: values[2],
            acceleration: values[3],
            front_force: values[4],
            rear_force: values[5],
        }
    }
}
impl<S: sim_kernel::Scalar> ::core::convert::From<HalfCarOutputs<S>> for [S; 6] {
    fn from(record: HalfCarOutputs<S>) -> Self {
        [
            record.body,
            record.road,
            record.pitch_angle,
            record.acceleration,
            record.front_force,
            record.rear_force,
        ]
    }
}
/// Rates of the outputs of [`HalfCar`] by name, in SI units.
#[allow(non_snake_case)]
#[derive(
    ::core::clone::Clone,
    ::core::marker::Copy,
    ::core::fmt::Debug,
    ::core::cmp::PartialEq
)]
pub struct HalfCarOutputRates<S = ::core::primitive::f64> {
    /// Rate of `body`.
    pub body: S,
    /// Rate of `road`.
    pub road: S,
    /// Rate of `pitch_angle`.
    pub pitch_angle: S,
    /// Rate of `front_force`.
    pub front_force: S,
    /// Rate of `rear_force`.
    pub rear_force: S,
}
impl<S: sim_kernel::Scalar> ::core::convert::From<[S; 5]> for HalfCarOutputRates<S> {
    fn from(values: [S; 5]) -> Self {
        Self {
            body: values[0],
            road: values[1],
            pitch_angle: values[2],
            front_force: values[3],
            rear_force: values[4],
        }
    }
}
impl<S: sim_kernel::Scalar> ::core::convert::From<HalfCarOutputRates<S>> for [S; 5] {
    fn from(record: HalfCarOutputRates<S>) -> Self {
        [
            record.body,
            record.road,
            record.pitch_angle,
            record.front_force,
            record.rear_force,
        ]
    }
}
/// What the equations of motion need of the parameters of [`HalfCar`], from [`HalfCar::prepare`]; its methods are the kernels of each step.
#[allow(non_snake_case)]
#[derive(
    ::core::clone::Clone,
    ::core::marker::Copy,
    ::core::fmt::Debug,
    ::core::cmp::PartialEq
)]
pub struct HalfCarPrepared<S = ::core::primitive::f64> {
    m: S,
    J: S,
    kf: S,
    H: S,
    lf: S,
    v: S,
    k: S,
    k_2: S,
    kr: S,
    lr: S,
    k_3: S,
    cf: S,
    k_4: S,
    cr: S,
    inverse_y: S,
    inverse_phi: S,
    k_5: S,
    k_6: S,
    k_7: S,
    k_8: S,
    k_9: S,
    k_10: S,
    k_11: S,
    k_12: S,
}
#[allow(non_snake_case, unused_variables, unused_parens, clippy::all, clippy::pedantic)]
impl<S: sim_kernel::Scalar> HalfCar<S> {
    /// What the equations of motion need of the parameters, computed once for a set of parameters.
    ///
    /// Operations: 12 additions, 21 multiplications, 3 divisions.
    #[inline]
    pub fn prepare(&self) -> HalfCarPrepared<S> {
        let inverse_m = S::from_f64(1.0) / self.m;
        let inverse_J = S::from_f64(1.0) / self.J;
        let w = self.kr * self.lr - self.kf * self.lf;
        let lr_squared = self.lr * self.lr;
        let lf_squared = self.lf * self.lf;
        let w_2 = self.lr * self.cr - self.lf * self.cf;
        HalfCarPrepared {
            m: self.m,
            J: self.J,
            kf: self.kf,
            H: self.H,
            lf: self.lf,
            v: self.v,
            k: self.lf - self.s0,
            k_2: S::from_f64(1.0) / (self.w * self.w),
            kr: self.kr,
            lr: self.lr,
            k_3: self.lr + self.s0,
            cf: self.cf,
            k_4: self.H * self.v * S::from_f64(2.0),
            cr: self.cr,
            inverse_y: inverse_m,
            inverse_phi: inverse_J,
            k_5: inverse_J * w,
            k_6: -(inverse_m * (self.kf + self.kr)),
            k_7: -(inverse_J * (self.kr * lr_squared + self.kf * lf_squared)),
            k_8: inverse_m * w,
            k_9: inverse_J * w_2,
            k_10: -(inverse_m * (self.cf + self.cr)),
            k_11: -(inverse_J * (self.cr * lr_squared + self.cf * lf_squared)),
            k_12: inverse_m * w_2,
        }
    }
    /// Mass matrix `T_q' M T_q`, 2 x 2, symmetric, in SI units.
    ///
    /// Operations: none.
    #[inline]
    pub fn mass_matrix(&self, t: S, q: &[S; 2]) -> [[S; 2]; 2] {
        [[self.m, S::from_f64(0.0)], [S::from_f64(0.0), self.J]]
    }
    /// Convective forces `T_q' M g`, 2, with `g = (T_q q' + T_t)_q q' + (..)_t`: joules per unit of each coordinate.
    ///
    /// Operations: none.
    #[inline]
    pub fn convective_forces(&self, t: S, q: &[S; 2], qd: &[S; 2]) -> [S; 2] {
        [S::from_f64(0.0), S::from_f64(0.0)]
    }
    /// Generalised forces `T_q' F`, 2: joules per unit of each coordinate.
    ///
    /// Operations: 21 additions, 26 multiplications, 1 division, 2 other functions.
    #[inline]
    pub fn generalized_forces(&self, t: S, q: &[S; 2], qd: &[S; 2]) -> [S; 2] {
        let [y, phi] = *q;
        let [y_dot, phi_dot] = *qd;
        let w = t * self.v;
        let w_2 = self.lf - self.s0 + w;
        let w_3 = S::from_f64(1.0) / (self.w * self.w);
        let w_4 = (-(w_2 * w_2 * w_3)).exp();
        let w_5 = self.kf * (y - self.H * w_4 + self.lf * phi);
        let w_6 = self.lr + self.s0 - w;
        let w_7 = (-(w_3 * w_6 * w_6)).exp();
        let w_8 = self.kr * (y - self.H * w_7 - phi * self.lr);
        let w_9 = self.H * self.v * S::from_f64(2.0);
        let w_10 = self.cf * (y_dot + w_3 * w_2 * w_4 * w_9 + self.lf * phi_dot);
        let w_11 = self.cr * (y_dot - w_3 * w_6 * w_7 * w_9 - self.lr * phi_dot);
        [-(w_5 + w_8 + w_10 + w_11), self.lr * (w_8 + w_11) - self.lf * (w_5 + w_10)]
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
    /// Operations: 1 addition, 6 multiplications.
    #[inline]
    pub fn kinetic_energy(&self, t: S, q: &[S; 2], qd: &[S; 2]) -> S {
        let [y_dot, phi_dot] = *qd;
        phi_dot * phi_dot * S::from_f64(0.5) * self.J
            + y_dot * y_dot * S::from_f64(0.5) * self.m
    }
    /// Power of loads and drives, `F' v + lambda' C_t + T_t' (M x'' - F)`, in watts.
    ///
    /// Operations: 19 additions, 26 multiplications, 1 division, 2 other functions.
    #[inline]
    pub fn power(
        &self,
        t: S,
        q: &[S; 2],
        qd: &[S; 2],
        qdd: &[S; 2],
        lambda: &[S; 0],
    ) -> S {
        let [y, phi] = *q;
        let [y_dot, phi_dot] = *qd;
        let w = self.v * t;
        let w_2 = self.lf - self.s0 + w;
        let w_3 = S::from_f64(1.0) / (self.w * self.w);
        let w_4 = (-(w_2 * w_2 * w_3)).exp();
        let w_5 = S::from_f64(2.0) * self.v * self.H;
        let w_6 = w_3 * w_2 * w_4 * w_5;
        let w_7 = y_dot + w_6 + self.lf * phi_dot;
        let w_8 = self.lr + self.s0 - w;
        let w_9 = (-(w_3 * w_8 * w_8)).exp();
        let w_10 = w_3 * w_5 * w_8 * w_9;
        let w_11 = y_dot - w_10 - phi_dot * self.lr;
        let w_12 = (self.kr * (y - self.H * w_9 - phi * self.lr) + w_11 * self.cr)
            * (w_10 + w_11);
        (self.kf * (y - self.H * w_4 + self.lf * phi) + w_7 * self.cf) * (w_6 - w_7)
            - w_12
    }
    /// Outputs, 6, in SI units.
    ///
    /// Operations: 18 additions, 24 multiplications, 1 division, 2 other functions.
    #[inline]
    pub fn outputs(
        &self,
        t: S,
        q: &[S; 2],
        qd: &[S; 2],
        qdd: &[S; 2],
        lambda: &[S; 0],
    ) -> HalfCarOutputs<S> {
        let [y, phi] = *q;
        let [y_dot, phi_dot] = *qd;
        let [y_ddot, _] = *qdd;
        let w = t * self.v;
        let w_2 = self.lf - self.s0 + w;
        let w_3 = S::from_f64(1.0) / (self.w * self.w);
        let w_4 = (-(w_2 * w_2 * w_3)).exp();
        let front_road = self.H * w_4;
        let w_5 = self.H * self.v * S::from_f64(2.0);
        let w_6 = self.lr + self.s0 - w;
        let w_7 = (-(w_3 * w_6 * w_6)).exp();
        [
            y,
            front_road,
            phi,
            y_ddot,
            -(self.kf * (y - front_road + self.lf * phi)
                + self.cf * (y_dot + w_3 * w_2 * w_4 * w_5 + self.lf * phi_dot)),
            -(self.kr * (y - self.H * w_7 - phi * self.lr)
                + self.cr * (y_dot - w_3 * w_5 * w_6 * w_7 - phi_dot * self.lr)),
        ]
            .into()
    }
    /// Rates of the outputs that depend on neither accelerations nor multipliers, 5, in SI units per second.
    ///
    /// Operations: 21 additions, 33 multiplications, 3 divisions, 2 other functions.
    #[inline]
    pub fn output_rates(
        &self,
        t: S,
        q: &[S; 2],
        qd: &[S; 2],
        qdd: &[S; 2],
    ) -> HalfCarOutputRates<S> {
        let [y_dot, phi_dot] = *qd;
        let [y_ddot, phi_ddot] = *qdd;
        let w_squared = self.w * self.w;
        let inverse_w_squared = S::from_f64(1.0) / w_squared;
        let w = self.v * t;
        let w_2 = self.lf - self.s0 + w;
        let w_10 = self.lr + self.s0 - w;
        let w_2_squared = w_2 * w_2;
        let w_3 = (-(w_2_squared * inverse_w_squared)).exp();
        let w_4 = S::from_f64(2.0) * self.H;
        let w_5 = self.v * w_4;
        let w_6 = inverse_w_squared * w_2 * w_3 * w_5;
        let v_squared = self.v * self.v;
        let w_7 = w_4 * v_squared / w_squared;
        let w_8 = self.H * v_squared * S::from_f64(4.0);
        let w_9 = S::from_f64(1.0) / (w_squared * w_squared);
        let w_10_squared = w_10 * w_10;
        let w_11 = (-(inverse_w_squared * w_10_squared)).exp();
        let w_12 = self.cr
            * (y_ddot + w_11 * (w_7 - w_9 * w_8 * w_10_squared) - phi_ddot * self.lr);
        [
            y_dot,
            -w_6,
            phi_dot,
            -(self.kf * (y_dot + w_6 + self.lf * phi_dot)
                + self.cf
                    * (y_ddot + w_3 * (w_7 - w_2_squared * w_8 * w_9)
                        + self.lf * phi_ddot)),
            -(self.kr
                * (y_dot - inverse_w_squared * w_5 * w_10 * w_11 - phi_dot * self.lr)
                + w_12),
        ]
            .into()
    }
    /// `left - right` of each event, 1, in SI units: zero when it happens.
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
    ) -> [S; 1] {
        let [y_dot, _] = *qd;
        [y_dot]
    }
    /// The numbers of each shape of the drawing, in metres and radians.
    ///
    /// Operations: 182 additions, 200 multiplications, 1 division, 35 other functions.
    #[inline]
    pub fn drawing(&self, t: S, q: &[S; 2]) -> [S; 156] {
        let [y, phi] = *q;
        let minus_x_0 = S::from_f64(1.3333333333333333) * self.lf
            + S::from_f64(1.3333333333333333) * self.lr;
        let w = self.lf * S::from_f64(4.0);
        let w_2 = self.lr * S::from_f64(4.0);
        let w_3 = S::from_f64(3.0) * self.s0;
        let w_4 = t * S::from_f64(3.0) * self.v;
        let w_5 = w + w_2 + w_3 - w_4;
        let w_59 = w_4 + (w + w_2 - w_3);
        let w_6 = S::from_f64(1.0) / (self.w * self.w);
        let minus_x_1 = self.lf * S::from_f64(1.25) + self.lr * S::from_f64(1.25);
        let x_1 = -minus_x_1;
        let w_7 = self.lf * S::from_f64(5.0);
        let w_8 = self.lr * S::from_f64(5.0);
        let w_9 = S::from_f64(4.0) * self.s0;
        let w_10 = t * S::from_f64(4.0) * self.v;
        let w_11 = w_7 + w_8 + w_9 - w_10;
        let road_1_y = self.H * (-(w_6 * S::from_f64(0.0625) * w_11 * w_11)).exp();
        let minus_x_2 = self.lf * S::from_f64(1.1666666666666667)
            + self.lr * S::from_f64(1.1666666666666667);
        let x_2 = -minus_x_2;
        let w_12 = self.lf * S::from_f64(7.0);
        let w_13 = self.lr * S::from_f64(7.0);
        let w_14 = self.s0 * S::from_f64(6.0);
        let w_15 = t * self.v * S::from_f64(6.0);
        let w_16 = w_12 + w_13 + w_14 - w_15;
        let road_2_y = self.H
            * (-(w_6 * S::from_f64(0.027777777777777776) * w_16 * w_16)).exp();
        let minus_x_3 = self.lf * S::from_f64(1.0833333333333333)
            + self.lr * S::from_f64(1.0833333333333333);
        let x_3 = -minus_x_3;
        let w_17 = self.lf * S::from_f64(13.0);
        let w_18 = self.lr * S::from_f64(13.0);
        let w_19 = self.s0 * S::from_f64(12.0);
        let w_20 = t * self.v * S::from_f64(12.0);
        let w_21 = w_17 + w_18 + w_19 - w_20;
        let road_3_y = self.H
            * (-(w_6 * S::from_f64(0.006944444444444444) * w_21 * w_21)).exp();
        let w_56 = w_20 + (w_17 + w_18 - w_19);
        let road_29_y = self.H
            * (-(w_6 * S::from_f64(0.006944444444444444) * w_56 * w_56)).exp();
        let minus_x_4 = self.lf + self.lr;
        let x_4 = -minus_x_4;
        let w_22 = t * self.v;
        let w_23 = self.lf + self.lr + self.s0 - w_22;
        let road_4_y = self.H * (-(w_6 * w_23 * w_23)).exp();
        let minus_x_5 = self.lf * S::from_f64(0.9166666666666666)
            + self.lr * S::from_f64(0.9166666666666666);
        let x_5 = -minus_x_5;
        let w_24 = self.lf * S::from_f64(11.0);
        let w_25 = self.lr * S::from_f64(11.0);
        let w_26 = w_24 + w_25 + w_19 - w_20;
        let road_5_y = self.H
            * (-(w_6 * S::from_f64(0.006944444444444444) * w_26 * w_26)).exp();
        let w_54 = w_20 + (w_24 + w_25 - w_19);
        let road_27_y = self.H
            * (-(w_6 * S::from_f64(0.006944444444444444) * w_54 * w_54)).exp();
        let minus_x_6 = self.lf * S::from_f64(0.8333333333333334)
            + self.lr * S::from_f64(0.8333333333333334);
        let x_6 = -minus_x_6;
        let w_27 = w_7 + w_8 + w_14 - w_15;
        let road_6_y = self.H
            * (-(w_6 * S::from_f64(0.027777777777777776) * w_27 * w_27)).exp();
        let minus_x_7 = self.lf * S::from_f64(0.75) + self.lr * S::from_f64(0.75);
        let x_7 = -minus_x_7;
        let w_28 = self.lf * S::from_f64(3.0);
        let w_29 = self.lr * S::from_f64(3.0);
        let w_30 = w_28 + w_29 + w_9 - w_10;
        let road_7_y = self.H * (-(w_6 * S::from_f64(0.0625) * w_30 * w_30)).exp();
        let w_52 = w_10 + (w_28 + w_29 - w_9);
        let road_25_y = self.H * (-(w_6 * S::from_f64(0.0625) * w_52 * w_52)).exp();
        let minus_x_8 = self.lf * S::from_f64(0.6666666666666666)
            + self.lr * S::from_f64(0.6666666666666666);
        let x_8 = -minus_x_8;
        let w_31 = self.lf * S::from_f64(2.0);
        let w_32 = self.lr * S::from_f64(2.0);
        let w_33 = w_31 + w_32 + w_3 - w_4;
        let road_8_y = self.H
            * (-(w_6 * S::from_f64(0.1111111111111111) * w_33 * w_33)).exp();
        let w_51 = w_4 + (w_31 + w_32 - w_3);
        let road_24_y = self.H
            * (-(w_6 * S::from_f64(0.1111111111111111) * w_51 * w_51)).exp();
        let minus_x_9 = self.lf * S::from_f64(0.5833333333333334)
            + self.lr * S::from_f64(0.5833333333333334);
        let x_9 = -minus_x_9;
        let w_34 = w_12 + w_13 + w_19 - w_20;
        let road_9_y = self.H
            * (-(w_6 * S::from_f64(0.006944444444444444) * w_34 * w_34)).exp();
        let minus_x_10 = self.lf * S::from_f64(0.5) + self.lr * S::from_f64(0.5);
        let x_10 = -minus_x_10;
        let w_35 = self.s0 * S::from_f64(2.0);
        let w_36 = t * self.v * S::from_f64(2.0);
        let w_37 = self.lf + self.lr + w_35 - w_36;
        let road_10_y = self.H * (-(w_6 * S::from_f64(0.25) * w_37 * w_37)).exp();
        let w_49 = w_36 + (self.lf + self.lr - w_35);
        let road_22_y = self.H * (-(w_6 * S::from_f64(0.25) * w_49 * w_49)).exp();
        let minus_x_11 = self.lf * S::from_f64(0.4166666666666667)
            + self.lr * S::from_f64(0.4166666666666667);
        let x_11 = -minus_x_11;
        let w_38 = w_7 + w_8 + w_19 - w_20;
        let road_11_y = self.H
            * (-(w_6 * S::from_f64(0.006944444444444444) * w_38 * w_38)).exp();
        let minus_x_12 = self.lf * S::from_f64(0.3333333333333333)
            + self.lr * S::from_f64(0.3333333333333333);
        let x_12 = -minus_x_12;
        let w_39 = self.lf + self.lr + w_3 - w_4;
        let road_12_y = self.H
            * (-(w_6 * S::from_f64(0.1111111111111111) * w_39 * w_39)).exp();
        let w_47 = w_4 + (self.lf + self.lr - w_3);
        let road_20_y = self.H
            * (-(w_6 * S::from_f64(0.1111111111111111) * w_47 * w_47)).exp();
        let minus_x_13 = self.lf * S::from_f64(0.25) + self.lr * S::from_f64(0.25);
        let x_13 = -minus_x_13;
        let w_40 = self.lf + self.lr + w_9 - w_10;
        let road_13_y = self.H * (-(w_6 * S::from_f64(0.0625) * w_40 * w_40)).exp();
        let minus_x_14 = self.lf * S::from_f64(0.16666666666666666)
            + self.lr * S::from_f64(0.16666666666666666);
        let x_14 = -minus_x_14;
        let w_41 = self.lf + self.lr + w_14 - w_15;
        let road_14_y = self.H
            * (-(w_6 * S::from_f64(0.027777777777777776) * w_41 * w_41)).exp();
        let minus_x_15 = self.lf * S::from_f64(0.08333333333333333)
            + self.lr * S::from_f64(0.08333333333333333);
        let x_15 = -minus_x_15;
        let w_42 = self.lf + self.lr + w_19 - w_20;
        let road_15_y = self.H
            * (-(w_6 * S::from_f64(0.006944444444444444) * w_42 * w_42)).exp();
        let w_43 = self.s0 - w_22;
        let road_16_y = self.H * (-(w_6 * w_43 * w_43)).exp();
        let w_44 = w_20 + (self.lf + self.lr - w_19);
        let road_17_y = self.H
            * (-(w_6 * S::from_f64(0.006944444444444444) * w_44 * w_44)).exp();
        let w_45 = w_15 + (self.lf + self.lr - w_14);
        let road_18_y = self.H
            * (-(w_6 * S::from_f64(0.027777777777777776) * w_45 * w_45)).exp();
        let w_46 = w_10 + (self.lf + self.lr - w_9);
        let road_19_y = self.H * (-(w_6 * S::from_f64(0.0625) * w_46 * w_46)).exp();
        let w_58 = w_10 + (w_7 + w_8 - w_9);
        let road_31_y = self.H * (-(w_6 * S::from_f64(0.0625) * w_58 * w_58)).exp();
        let w_48 = w_20 + (w_7 + w_8 - w_19);
        let road_21_y = self.H
            * (-(w_6 * S::from_f64(0.006944444444444444) * w_48 * w_48)).exp();
        let w_50 = w_20 + (w_12 + w_13 - w_19);
        let road_23_y = self.H
            * (-(w_6 * S::from_f64(0.006944444444444444) * w_50 * w_50)).exp();
        let w_57 = w_15 + (w_12 + w_13 - w_14);
        let w_53 = w_15 + (w_7 + w_8 - w_14);
        let road_26_y = self.H
            * (-(w_6 * S::from_f64(0.027777777777777776) * w_53 * w_53)).exp();
        let road_30_y = self.H
            * (-(w_6 * S::from_f64(0.027777777777777776) * w_57 * w_57)).exp();
        let w_55 = w_22 + (self.lf + self.lr - self.s0);
        let road_28_y = self.H * (-(w_6 * w_55 * w_55)).exp();
        let w_60 = w_22 + (self.lf - self.s0);
        let front_wheel_y = self.R + self.H * (-(w_6 * w_60 * w_60)).exp();
        let w_61 = self.lr + self.s0 - w_22;
        let rear_wheel_y = self.R + self.H * (-(w_6 * w_61 * w_61)).exp();
        let w_62 = self.R * S::from_f64(2.5);
        let rear_end_y = y + w_62 - self.lr * phi;
        let front_end_y = y + w_62 + self.lf * phi;
        let w_63 = S::from_f64(0.25) * self.R;
        let w_64 = -(self.lr + w_63);
        let w_65 = w_63 - self.lr;
        let w_66 = self.lf - w_63;
        let w_67 = self.lf + w_63;
        [
            -minus_x_0,
            self.H * (-(S::from_f64(0.1111111111111111) * w_5 * w_5 * w_6)).exp(),
            x_1,
            road_1_y,
            x_1,
            road_1_y,
            x_2,
            road_2_y,
            x_2,
            road_2_y,
            x_3,
            road_3_y,
            x_3,
            road_3_y,
            x_4,
            road_4_y,
            x_4,
            road_4_y,
            x_5,
            road_5_y,
            x_5,
            road_5_y,
            x_6,
            road_6_y,
            x_6,
            road_6_y,
            x_7,
            road_7_y,
            x_7,
            road_7_y,
            x_8,
            road_8_y,
            x_8,
            road_8_y,
            x_9,
            road_9_y,
            x_9,
            road_9_y,
            x_10,
            road_10_y,
            x_10,
            road_10_y,
            x_11,
            road_11_y,
            x_11,
            road_11_y,
            x_12,
            road_12_y,
            x_12,
            road_12_y,
            x_13,
            road_13_y,
            x_13,
            road_13_y,
            x_14,
            road_14_y,
            x_14,
            road_14_y,
            x_15,
            road_15_y,
            x_15,
            road_15_y,
            S::from_f64(0.0),
            road_16_y,
            S::from_f64(0.0),
            road_16_y,
            minus_x_15,
            road_17_y,
            minus_x_15,
            road_17_y,
            minus_x_14,
            road_18_y,
            minus_x_14,
            road_18_y,
            minus_x_13,
            road_19_y,
            minus_x_13,
            road_19_y,
            minus_x_12,
            road_20_y,
            minus_x_12,
            road_20_y,
            minus_x_11,
            road_21_y,
            minus_x_11,
            road_21_y,
            minus_x_10,
            road_22_y,
            minus_x_10,
            road_22_y,
            minus_x_9,
            road_23_y,
            minus_x_9,
            road_23_y,
            minus_x_8,
            road_24_y,
            minus_x_8,
            road_24_y,
            minus_x_7,
            road_25_y,
            minus_x_7,
            road_25_y,
            minus_x_6,
            road_26_y,
            minus_x_6,
            road_26_y,
            minus_x_5,
            road_27_y,
            minus_x_5,
            road_27_y,
            minus_x_4,
            road_28_y,
            minus_x_4,
            road_28_y,
            minus_x_3,
            road_29_y,
            minus_x_3,
            road_29_y,
            minus_x_2,
            road_30_y,
            minus_x_2,
            road_30_y,
            minus_x_1,
            road_31_y,
            minus_x_1,
            road_31_y,
            minus_x_0,
            self.H * (-(w_6 * S::from_f64(0.1111111111111111) * w_59 * w_59)).exp(),
            self.lf,
            front_wheel_y,
            self.R,
            -self.lr,
            rear_wheel_y,
            self.R,
            -self.lr,
            rear_end_y,
            self.lf,
            front_end_y,
            w_64,
            rear_wheel_y,
            w_64,
            rear_end_y,
            w_65,
            rear_wheel_y,
            w_65,
            rear_end_y,
            w_66,
            front_wheel_y,
            w_66,
            front_end_y,
            w_67,
            front_wheel_y,
            w_67,
            front_end_y,
            S::from_f64(0.0),
            y + w_62,
        ]
    }
    /// Declared start: values or guesses of the coordinates (2), and speeds (2), in SI units; 0 where nothing is declared.
    ///
    /// Operations: none.
    #[inline]
    pub fn initial(&self) -> sim_kernel::Initial<[S; 2]> {
        sim_kernel::Initial {
            positions: [S::from_f64(0.0), S::from_f64(0.0)],
            speeds: [S::from_f64(0.0), S::from_f64(0.0)],
        }
    }
    /// [`HalfCarPrepared::dynamics`] once; for many calls with the same parameters [`Self::prepare`] first.
    #[inline]
    pub fn dynamics(
        &self,
        t: S,
        q: &[S; 2],
        qd: &[S; 2],
    ) -> sim_kernel::Dynamics<S, [S; 2], [S; 0]> {
        self.prepare().dynamics(t, q, qd)
    }
    /// [`HalfCarPrepared::dynamics_jacobian`] once; for many calls with the same parameters [`Self::prepare`] first.
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
impl<S: sim_kernel::Scalar> HalfCarPrepared<S> {
    /// Accelerations (2), multipliers (0) and power, from
    ///
    /// ```text
    /// [ T_q' M T_q   C_q' ] [ q''    ]   [ T_q' (F - M g)                      ]
    /// [ C_q          0    ] [ lambda ] = [ -(C_q q' + C_t)_q q' - (..)_t       ]
    /// ```
    ///
    /// by an elimination planned from the structure of the system. Where `refused` is set a pivot was too small and nothing else holds: solve that state from the other kernels.
    ///
    /// Operations: 22 additions, 27 multiplications, 2 other functions.
    #[inline(always)]
    pub fn dynamics(
        &self,
        t: S,
        q: &[S; 2],
        qd: &[S; 2],
    ) -> sim_kernel::Dynamics<S, [S; 2], [S; 0]> {
        let [y, phi] = *q;
        let [y_dot, phi_dot] = *qd;
        let w = t * self.v;
        let w_2 = self.k_3 - w;
        let w_3 = (-(self.k_2 * w_2 * w_2)).exp();
        let w_4 = self.kr * (y - self.H * w_3 - phi * self.lr);
        let w_5 = self.k_2 * w_2 * w_3 * self.k_4;
        let w_6 = y_dot - w_5 - self.lr * phi_dot;
        let w_7 = self.cr * w_6;
        let w_8 = w_4 + w_7;
        let w_9 = self.k + w;
        let w_10 = (-(w_9 * w_9 * self.k_2)).exp();
        let w_11 = self.kf * (y - self.H * w_10 + self.lf * phi);
        let w_12 = self.k_2 * w_9 * w_10 * self.k_4;
        let w_13 = y_dot + w_12 + self.lf * phi_dot;
        let w_14 = self.cf * w_13;
        let w_15 = w_11 + w_14;
        sim_kernel::Dynamics {
            accelerations: [
                -((w_11 + w_4 + w_14 + w_7) * self.inverse_y),
                (self.lr * w_8 - self.lf * w_15) * self.inverse_phi,
            ],
            multipliers: [],
            power: w_15 * (w_12 - w_13) - w_8 * (w_5 + w_6),
            refused: sim_kernel::pivot_is_refused(self.m, self.m)
                | sim_kernel::pivot_is_refused(self.J, self.J),
        }
    }
    /// The derivatives of accelerations (2 rows) and multipliers (0 rows) with respect to coordinates and speeds (2 columns each): with the equations of motion as `K z = r`, the solutions of `K dz = dr - dK z`. Where `refused` is set a pivot was too small and nothing else holds.
    ///
    /// Operations: none.
    #[inline]
    pub fn dynamics_jacobian(
        &self,
        t: S,
        q: &[S; 2],
        qd: &[S; 2],
    ) -> sim_kernel::DynamicsJacobian<S, [[S; 2]; 2], [[S; 2]; 0]> {
        sim_kernel::DynamicsJacobian {
            accelerations_by_positions: [[self.k_6, self.k_8], [self.k_5, self.k_7]],
            accelerations_by_speeds: [[self.k_10, self.k_12], [self.k_9, self.k_11]],
            multipliers_by_positions: [],
            multipliers_by_speeds: [],
            refused: sim_kernel::pivot_is_refused(self.m, self.m)
                | sim_kernel::pivot_is_refused(self.J, self.J),
        }
    }
}
#[allow(non_snake_case, clippy::all, clippy::pedantic)]
impl<S: sim_kernel::Scalar> sim_kernel::Mechanism<S> for HalfCar<S> {
    type Q = [S; 2];
    type L = [S; 0];
    type Z = [S; 2];
    type QQ = [[S; 2]; 2];
    type LQ = [[S; 2]; 0];
    type LL = [[S; 0]; 0];
    type ZZ = [[S; 2]; 2];
    type Entries = [S; 0];
    type Envelope = [S; 0];
    type Parameters = [S; 13];
    type Outputs = [S; 6];
    type OutputRates = [S; 5];
    type Events = [S; 1];
    type EventValues = [S; 0];
    type Activities = [S; 0];
    type Drawing = [S; 156];
    type QP = [[S; 13]; 2];
    type LP = [[S; 13]; 0];
    type Inputs = [sim_kernel::Input<S>; 0];
    type Prepared = HalfCarPrepared<S>;
    type On<T: sim_kernel::Scalar> = HalfCar<T>;
    const DESCRIPTION: sim_kernel::Description = sim_kernel::Description {
        name: "half-car",
        type_name: "HalfCar",
        docs: "Half a car, seen from the side, drives over a bump: bounce and pitch from equilibrium.",
        declaration: "/// Half a car, seen from the side, drives over a bump: bounce and pitch from equilibrium.\npub HalfCar;\n\nconst n = 32;\n\ncoordinates {\n    /// Bounce of the centre of mass.\n    y [m];\n    /// Pitch, the front upwards.\n    phi [rad];\n}\n\nparameters {\n    /// Mass of the body.\n    m [kg] = 700;\n    /// Inertia of the body.\n    J [kg*m^2] = 1000;\n    /// From the centre of mass to the front axle.\n    lf [m] = 1.2;\n    /// From the centre of mass to the rear axle.\n    lr [m] = 1.5;\n    /// Stiffness of the front spring.\n    kf [kN/m] = 18;\n    /// Stiffness of the rear spring.\n    kr [kN/m] = 20;\n    /// Damping in front.\n    cf [N*s/m] = 1200;\n    /// Damping behind.\n    cr [N*s/m] = 1400;\n    /// Speed.\n    v [m/s] = 10;\n    /// Height of the bump.\n    H [mm] = 80;\n    /// Half of its width, where it has fallen to a third.\n    w [m] = 0.5;\n    /// Where its top is.\n    s0 [m] = 6;\n    /// Radius of the wheels, for drawings.\n    R [m] = 0.3;\n}\n\nlet front_road = H*exp(-((v*t + lf - s0)/w)^2);\nlet rear_road = H*exp(-((v*t - lr - s0)/w)^2);\nlet front = y + lf*phi;\nlet rear = y - lr*phi;\n\nbodies { car: mass m at [0, y], inertia J, angle phi; }\n\nloads {\n    spring kf, rest 0 between front_road and front;\n    spring kr, rest 0 between rear_road and rear;\n    damper cf between front_road and front;\n    damper cr between rear_road and rear;\n}\n\ninitial { y = 0; phi = 0; dot(y) = 0; dot(phi) = 0; }\n\nevents {\n    /// The body is highest or lowest.\n    turn: dot(y) = 0;\n}\n\noutputs {\n    bounce \"Bounce\" {\n        /// body\n        body [mm] = y;\n        /// road at the front axle\n        road [mm] = front_road;\n    }\n    pitch \"Pitch\" {\n        /// pitch\n        pitch_angle [deg] = phi;\n    }\n    comfort \"Acceleration of the body\" {\n        /// acceleration\n        acceleration [m/s^2] = ddot(y);\n    }\n    suspension \"Forces of the suspension, beyond the weight\" {\n        /// front\n        front_force [N] = -kf*(front - front_road) - cf*dot(front - front_road);\n        /// rear\n        rear_force [N] = -kr*(rear - rear_road) - cr*dot(rear - rear_road);\n    }\n}\n\nrepeat i in 0..=n {\n    let x_[i] = (i - n/2)*0.125*(lf + lr)/1.5;\n    let road_[i] = [x_[i], H*exp(-((v*t + x_[i] - s0)/w)^2)];\n}\nlet front_end = [lf, 2.5*R + front];\nlet rear_end = [-lr, 2.5*R + rear];\nlet front_wheel = [lf, R + front_road];\nlet rear_wheel = [-lr, R + rear_road];\n\nlet side = [R/4, 0];\n\ndrawing {\n    repeat i in 1..=n { curve road_[i-1], road_[i]; }\n    circle front_wheel radius R;\n    circle rear_wheel radius R;\n    line rear_end, front_end;\n    spring rear_wheel - side, rear_end - side;\n    damper rear_wheel + side, rear_end + side;\n    spring front_wheel - side, front_end - side;\n    damper front_wheel + side, front_end + side;\n    point [0, 2.5*R + y];\n}\n",
        coordinates: &[
            sim_kernel::Coordinate {
                position: sim_kernel::Quantity {
                    name: "y",
                    unit: "m",
                    factor: 1f64,
                    is_length: true,
                    docs: "Bounce of the centre of mass.",
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
                speed_given: true,
            },
            sim_kernel::Coordinate {
                position: sim_kernel::Quantity {
                    name: "phi",
                    unit: "rad",
                    factor: 1f64,
                    is_length: false,
                    docs: "Pitch, the front upwards.",
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
        parameters: &[
            sim_kernel::Quantity {
                name: "m",
                unit: "kg",
                factor: 1f64,
                is_length: false,
                docs: "Mass of the body.",
            },
            sim_kernel::Quantity {
                name: "J",
                unit: "kg*m^2",
                factor: 1f64,
                is_length: false,
                docs: "Inertia of the body.",
            },
            sim_kernel::Quantity {
                name: "lf",
                unit: "m",
                factor: 1f64,
                is_length: true,
                docs: "From the centre of mass to the front axle.",
            },
            sim_kernel::Quantity {
                name: "lr",
                unit: "m",
                factor: 1f64,
                is_length: true,
                docs: "From the centre of mass to the rear axle.",
            },
            sim_kernel::Quantity {
                name: "kf",
                unit: "kN/m",
                factor: 1000f64,
                is_length: false,
                docs: "Stiffness of the front spring.",
            },
            sim_kernel::Quantity {
                name: "kr",
                unit: "kN/m",
                factor: 1000f64,
                is_length: false,
                docs: "Stiffness of the rear spring.",
            },
            sim_kernel::Quantity {
                name: "cf",
                unit: "N*s/m",
                factor: 1f64,
                is_length: false,
                docs: "Damping in front.",
            },
            sim_kernel::Quantity {
                name: "cr",
                unit: "N*s/m",
                factor: 1f64,
                is_length: false,
                docs: "Damping behind.",
            },
            sim_kernel::Quantity {
                name: "v",
                unit: "m/s",
                factor: 1f64,
                is_length: false,
                docs: "Speed.",
            },
            sim_kernel::Quantity {
                name: "H",
                unit: "mm",
                factor: 0.001f64,
                is_length: true,
                docs: "Height of the bump.",
            },
            sim_kernel::Quantity {
                name: "w",
                unit: "m",
                factor: 1f64,
                is_length: true,
                docs: "Half of its width, where it has fallen to a third.",
            },
            sim_kernel::Quantity {
                name: "s0",
                unit: "m",
                factor: 1f64,
                is_length: true,
                docs: "Where its top is.",
            },
            sim_kernel::Quantity {
                name: "R",
                unit: "m",
                factor: 1f64,
                is_length: true,
                docs: "Radius of the wheels, for drawings.",
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
                name: "turn",
                direction: sim_kernel::event::Direction::Both,
                on_forces: false,
                steps: &[],
            },
        ],
        outputs: &[
            sim_kernel::Quantity {
                name: "body",
                unit: "mm",
                factor: 0.001f64,
                is_length: true,
                docs: "body",
            },
            sim_kernel::Quantity {
                name: "road",
                unit: "mm",
                factor: 0.001f64,
                is_length: true,
                docs: "road at the front axle",
            },
            sim_kernel::Quantity {
                name: "pitch_angle",
                unit: "deg",
                factor: 0.017453292519943295f64,
                is_length: false,
                docs: "pitch",
            },
            sim_kernel::Quantity {
                name: "acceleration",
                unit: "m/s^2",
                factor: 1f64,
                is_length: false,
                docs: "acceleration",
            },
            sim_kernel::Quantity {
                name: "front_force",
                unit: "N",
                factor: 1f64,
                is_length: false,
                docs: "front",
            },
            sim_kernel::Quantity {
                name: "rear_force",
                unit: "N",
                factor: 1f64,
                is_length: false,
                docs: "rear",
            },
        ],
        rated_outputs: &[0, 1, 2, 4, 5],
        figures: &[
            sim_kernel::Figure {
                name: "bounce",
                title: "Bounce",
                len: 2,
            },
            sim_kernel::Figure {
                name: "pitch",
                title: "Pitch",
                len: 1,
            },
            sim_kernel::Figure {
                name: "comfort",
                title: "Acceleration of the body",
                len: 1,
            },
            sim_kernel::Figure {
                name: "suspension",
                title: "Forces of the suspension, beyond the weight",
                len: 2,
            },
        ],
        optional_kernels: &["dynamics_jacobian"],
        dimension: 2,
        drawing: &[
            sim_kernel::Shape::Curve(2),
            sim_kernel::Shape::Curve(2),
            sim_kernel::Shape::Curve(2),
            sim_kernel::Shape::Curve(2),
            sim_kernel::Shape::Curve(2),
            sim_kernel::Shape::Curve(2),
            sim_kernel::Shape::Curve(2),
            sim_kernel::Shape::Curve(2),
            sim_kernel::Shape::Curve(2),
            sim_kernel::Shape::Curve(2),
            sim_kernel::Shape::Curve(2),
            sim_kernel::Shape::Curve(2),
            sim_kernel::Shape::Curve(2),
            sim_kernel::Shape::Curve(2),
            sim_kernel::Shape::Curve(2),
            sim_kernel::Shape::Curve(2),
            sim_kernel::Shape::Curve(2),
            sim_kernel::Shape::Curve(2),
            sim_kernel::Shape::Curve(2),
            sim_kernel::Shape::Curve(2),
            sim_kernel::Shape::Curve(2),
            sim_kernel::Shape::Curve(2),
            sim_kernel::Shape::Curve(2),
            sim_kernel::Shape::Curve(2),
            sim_kernel::Shape::Curve(2),
            sim_kernel::Shape::Curve(2),
            sim_kernel::Shape::Curve(2),
            sim_kernel::Shape::Curve(2),
            sim_kernel::Shape::Curve(2),
            sim_kernel::Shape::Curve(2),
            sim_kernel::Shape::Curve(2),
            sim_kernel::Shape::Curve(2),
            sim_kernel::Shape::Circle,
            sim_kernel::Shape::Circle,
            sim_kernel::Shape::Line(2),
            sim_kernel::Shape::Spring,
            sim_kernel::Shape::Damper,
            sim_kernel::Shape::Spring,
            sim_kernel::Shape::Damper,
            sim_kernel::Shape::Points(1),
        ],
    };
    fn defaults() -> Self {
        Self {
            m: S::from_f64(700f64),
            J: S::from_f64(1000f64),
            lf: S::from_f64(1.2f64),
            lr: S::from_f64(1.5f64),
            kf: S::from_f64(18000f64),
            kr: S::from_f64(20000f64),
            cf: S::from_f64(1200f64),
            cr: S::from_f64(1400f64),
            v: S::from_f64(10f64),
            H: S::from_f64(0.08f64),
            w: S::from_f64(0.5f64),
            s0: S::from_f64(6f64),
            R: S::from_f64(0.3f64),
        }
    }
    fn parameters(&self) -> [S; 13] {
        [
            self.m,
            self.J,
            self.lf,
            self.lr,
            self.kf,
            self.kr,
            self.cf,
            self.cr,
            self.v,
            self.H,
            self.w,
            self.s0,
            self.R,
        ]
    }
    fn with_parameters(&self, parameters: [S; 13]) -> Self {
        Self {
            m: parameters[0],
            J: parameters[1],
            lf: parameters[2],
            lr: parameters[3],
            kf: parameters[4],
            kr: parameters[5],
            cf: parameters[6],
            cr: parameters[7],
            v: parameters[8],
            H: parameters[9],
            w: parameters[10],
            s0: parameters[11],
            R: parameters[12],
            ..*self
        }
    }
    fn on<T: sim_kernel::Scalar>(
        &self,
        convert: impl ::core::ops::Fn(S) -> T,
    ) -> HalfCar<T> {
        HalfCar {
            m: convert(self.m),
            J: convert(self.J),
            lf: convert(self.lf),
            lr: convert(self.lr),
            kf: convert(self.kf),
            kr: convert(self.kr),
            cf: convert(self.cf),
            cr: convert(self.cr),
            v: convert(self.v),
            H: convert(self.H),
            w: convert(self.w),
            s0: convert(self.s0),
            R: convert(self.R),
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
    fn prepare(&self) -> HalfCarPrepared<S> {
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
    ) -> [S; 6] {
        self.outputs(t, q, qd, qdd, lambda).into()
    }
    #[inline(always)]
    fn output_rates(&self, t: S, q: &[S; 2], qd: &[S; 2], qdd: &[S; 2]) -> [S; 5] {
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
    ) -> [S; 1] {
        self.events(t, q, qd, qdd, lambda)
    }
    #[inline(always)]
    fn drawing(&self, t: S, q: &[S; 2]) -> [S; 156] {
        self.drawing(t, q)
    }
    #[inline(always)]
    fn initial(&self) -> sim_kernel::Initial<[S; 2]> {
        self.initial()
    }
}
