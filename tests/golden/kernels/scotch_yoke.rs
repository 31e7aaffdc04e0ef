/// Scotch yoke: the pin of a crank with its flywheel drives a yoke along a guide. It turns freely, faster where the
/// yoke is slow.
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
/// coordinates = [alpha; x]
/// multipliers = [lambda_slot]
/// constraints = 0
/// [
///     J, 0, -r*sin(alpha);
///     0, m, -1;
///     -r*sin(alpha), -1, 0
/// ] * [alpha_ddot; x_ddot; lambda_slot] = [0; 0; r*alpha_dot^2*cos(alpha)]
///
/// mass_matrix = [J, 0; 0, m]
///
/// convective_forces = [0; 0]
///
/// generalized_forces = [0; 0]
///
/// constraints = [A_x - x]
///
/// constraint_jacobian = [-r*sin(alpha), -1]
///
/// constraint_convective = [-r*alpha_dot^2*cos(alpha)]
///
/// A_x = r*cos(alpha)
/// ```
#[allow(non_snake_case)]
#[derive(
    ::core::clone::Clone,
    ::core::marker::Copy,
    ::core::fmt::Debug,
    ::core::cmp::PartialEq
)]
pub struct ScotchYoke<S = ::core::primitive::f64> {
    /// Radius of the crank, in `m`.
    pub r: S,
    /// Inertia of the crank and its flywheel, in `kg*m^2`.
    pub J: S,
    /// Mass of the yoke, in `kg`.
    pub m: S,
    /// Half the length of the slot, for drawings, in `m`.
    pub h: S,
    /// Length of the rod on the yoke, for drawings, in `m`.
    pub s: S,
}
impl<S: sim_kernel::Scalar> ::core::default::Default for ScotchYoke<S> {
    /// The declared values.
    fn default() -> Self {
        <Self as sim_kernel::Mechanism<S>>::defaults()
    }
}
/// Coordinates of [`ScotchYoke`] by name, in SI units; also for their speeds and accelerations.
#[allow(non_snake_case)]
#[derive(
    ::core::clone::Clone,
    ::core::marker::Copy,
    ::core::fmt::Debug,
    ::core::cmp::PartialEq
)]
pub struct ScotchYokeCoordinates<S = ::core::primitive::f64> {
    /// Angle of the crank, in `rad`.
    pub alpha: S,
    /// Displacement of the yoke, in `m`.
    pub x: S,
}
impl<S: sim_kernel::Scalar> ::core::convert::From<[S; 2]> for ScotchYokeCoordinates<S> {
    fn from(values: [S; 2]) -> Self {
        Self {
            alpha: values[0],
            x: values[1],
        }
    }
}
impl<S: sim_kernel::Scalar> ::core::convert::From<ScotchYokeCoordinates<S>> for [S; 2] {
    fn from(record: ScotchYokeCoordinates<S>) -> Self {
        [record.alpha, record.x]
    }
}
/// Outputs of [`ScotchYoke`] by name, in SI units.
#[allow(non_snake_case)]
#[derive(
    ::core::clone::Clone,
    ::core::marker::Copy,
    ::core::fmt::Debug,
    ::core::cmp::PartialEq
)]
pub struct ScotchYokeOutputs<S = ::core::primitive::f64> {
    /// speed, in `1/s`.
    pub speed: S,
    /// displacement, in `m`.
    pub displacement: S,
    /// along x, in `N`.
    pub force: S,
}
impl<S: sim_kernel::Scalar> ::core::convert::From<[S; 3]> for ScotchYokeOutputs<S> {
    fn from(values: [S; 3]) -> Self {
        Self {
            speed: values[0],
            displacement: values[1],
            force: values[2],
        }
    }
}
impl<S: sim_kernel::Scalar> ::core::convert::From<ScotchYokeOutputs<S>> for [S; 3] {
    fn from(record: ScotchYokeOutputs<S>) -> Self {
        [record.speed, record.displacement, record.force]
    }
}
/// Rates of the outputs of [`ScotchYoke`] by name, in SI units.
#[allow(non_snake_case)]
#[derive(
    ::core::clone::Clone,
    ::core::marker::Copy,
    ::core::fmt::Debug,
    ::core::cmp::PartialEq
)]
pub struct ScotchYokeOutputRates<S = ::core::primitive::f64> {
    /// Rate of `speed`.
    pub speed: S,
    /// Rate of `displacement`.
    pub displacement: S,
}
impl<S: sim_kernel::Scalar> ::core::convert::From<[S; 2]> for ScotchYokeOutputRates<S> {
    fn from(values: [S; 2]) -> Self {
        Self {
            speed: values[0],
            displacement: values[1],
        }
    }
}
impl<S: sim_kernel::Scalar> ::core::convert::From<ScotchYokeOutputRates<S>> for [S; 2] {
    fn from(record: ScotchYokeOutputRates<S>) -> Self {
        [record.speed, record.displacement]
    }
}
/// What the equations of motion need of the parameters of [`ScotchYoke`], from [`ScotchYoke::prepare`]; its methods are the kernels of each step.
#[allow(non_snake_case)]
#[derive(
    ::core::clone::Clone,
    ::core::marker::Copy,
    ::core::fmt::Debug,
    ::core::cmp::PartialEq
)]
pub struct ScotchYokePrepared<S = ::core::primitive::f64> {
    J: S,
    m: S,
    r: S,
    inverse_alpha: S,
    inverse_x: S,
    k: S,
}
#[allow(non_snake_case, unused_variables, unused_parens, clippy::all, clippy::pedantic)]
impl<S: sim_kernel::Scalar> ScotchYoke<S> {
    /// What the equations of motion need of the parameters, computed once for a set of parameters.
    ///
    /// Operations: 1 multiplication, 2 divisions.
    #[inline]
    pub fn prepare(&self) -> ScotchYokePrepared<S> {
        ScotchYokePrepared {
            J: self.J,
            m: self.m,
            r: self.r,
            inverse_alpha: S::from_f64(1.0) / self.J,
            inverse_x: S::from_f64(1.0) / self.m,
            k: self.r * S::from_f64(2.0),
        }
    }
    /// Mass matrix `T_q' M T_q`, 2 x 2, symmetric, in SI units.
    ///
    /// Operations: none.
    #[inline]
    pub fn mass_matrix(&self, t: S, q: &[S; 2]) -> [[S; 2]; 2] {
        [[self.J, S::from_f64(0.0)], [S::from_f64(0.0), self.m]]
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
    /// Operations: none.
    #[inline]
    pub fn generalized_forces(&self, t: S, q: &[S; 2], qd: &[S; 2]) -> [S; 2] {
        [S::from_f64(0.0), S::from_f64(0.0)]
    }
    /// Constraints `C`, 1, in SI units; zero throughout the motion.
    ///
    /// Operations: 1 addition, 1 multiplication, 1 sine-cosine pair.
    #[inline]
    pub fn constraints(&self, t: S, q: &[S; 2]) -> [S; 1] {
        let [alpha, x] = *q;
        let ([_], [cos_alpha]) = S::sin_cos_each([alpha]);
        [self.r * cos_alpha - x]
    }
    /// The sum of the magnitudes of the terms of `C`, 1, in SI units: what its rounding is relative to.
    ///
    /// Operations: 3 additions, 1 multiplication, 1 sine-cosine pair.
    #[inline]
    pub fn constraint_magnitudes(&self, t: S, q: &[S; 2]) -> [S; 1] {
        let [alpha, x] = *q;
        let ([_], [cos_alpha]) = S::sin_cos_each([alpha]);
        [x.abs() + (self.r * cos_alpha).abs()]
    }
    /// Constraint Jacobian `C_q`, 1 x 2: units of each constraint per unit of each coordinate.
    ///
    /// Operations: 2 additions, 1 multiplication, 1 sine-cosine pair.
    #[inline]
    pub fn constraint_jacobian(&self, t: S, q: &[S; 2]) -> [[S; 2]; 1] {
        let [alpha, _] = *q;
        let ([sin_alpha], [_]) = S::sin_cos_each([alpha]);
        [[-(self.r * sin_alpha), -S::from_f64(1.0)]]
    }
    /// `C_t`, 1, units of `C` per second: the speeds obey `C_q q' + C_t = 0`.
    ///
    /// Operations: none.
    #[inline]
    pub fn constraint_time_derivative(&self, t: S, q: &[S; 2]) -> [S; 1] {
        [S::from_f64(0.0)]
    }
    /// `(C_q q' + C_t)_q q' + (..)_t`, 1, units of `C` per second squared: the part of `C''` without accelerations.
    ///
    /// Operations: 1 addition, 3 multiplications, 1 sine-cosine pair.
    #[inline]
    pub fn constraint_convective(&self, t: S, q: &[S; 2], qd: &[S; 2]) -> [S; 1] {
        let [alpha, _] = *q;
        let [alpha_dot, _] = *qd;
        let ([_], [cos_alpha]) = S::sin_cos_each([alpha]);
        [-(alpha_dot * alpha_dot * self.r * cos_alpha)]
    }
    /// `C` (1), `C_q` (1 x 2) and `C_t` (1) together, in SI units, for projection.
    ///
    /// Operations: 3 additions, 2 multiplications, 1 sine-cosine pair.
    #[inline]
    pub fn constraint_linearization(
        &self,
        t: S,
        q: &[S; 2],
    ) -> sim_kernel::ConstraintLinearization<[S; 1], [[S; 2]; 1]> {
        let [alpha, x] = *q;
        let ([sin_alpha], [cos_alpha]) = S::sin_cos_each([alpha]);
        sim_kernel::ConstraintLinearization {
            values: [self.r * cos_alpha - x],
            jacobian: [[-(self.r * sin_alpha), -S::from_f64(1.0)]],
            time_derivative: [S::from_f64(0.0)],
        }
    }
    /// Kinetic energy `v' M v / 2`, in joules.
    ///
    /// Operations: 1 addition, 6 multiplications.
    #[inline]
    pub fn kinetic_energy(&self, t: S, q: &[S; 2], qd: &[S; 2]) -> S {
        let [alpha_dot, x_dot] = *qd;
        alpha_dot * alpha_dot * S::from_f64(0.5) * self.J
            + x_dot * x_dot * S::from_f64(0.5) * self.m
    }
    /// Power of loads and drives, `F' v + lambda' C_t + T_t' (M x'' - F)`, in watts.
    ///
    /// Operations: none.
    #[inline]
    pub fn power(
        &self,
        t: S,
        q: &[S; 2],
        qd: &[S; 2],
        qdd: &[S; 2],
        lambda: &[S; 1],
    ) -> S {
        S::from_f64(0.0)
    }
    /// Outputs, 3, in SI units.
    ///
    /// Operations: none.
    #[inline]
    pub fn outputs(
        &self,
        t: S,
        q: &[S; 2],
        qd: &[S; 2],
        qdd: &[S; 2],
        lambda: &[S; 1],
    ) -> ScotchYokeOutputs<S> {
        let [_, x] = *q;
        let [alpha_dot, _] = *qd;
        let [lambda_slot] = *lambda;
        [alpha_dot, x, lambda_slot].into()
    }
    /// Rates of the outputs that depend on neither accelerations nor multipliers, 2, in SI units per second.
    ///
    /// Operations: none.
    #[inline]
    pub fn output_rates(
        &self,
        t: S,
        q: &[S; 2],
        qd: &[S; 2],
        qdd: &[S; 2],
    ) -> ScotchYokeOutputRates<S> {
        let [_, x_dot] = *qd;
        let [alpha_ddot, _] = *qdd;
        [alpha_ddot, x_dot].into()
    }
    /// `left - right` of each event, 2, in SI units: zero when it happens.
    ///
    /// Operations: 1 addition, 1 multiplication.
    #[inline]
    pub fn events(
        &self,
        t: S,
        q: &[S; 2],
        qd: &[S; 2],
        qdd: &[S; 2],
        lambda: &[S; 1],
    ) -> [S; 2] {
        let [alpha, _] = *q;
        let [_, x_dot] = *qd;
        [alpha - S::from_f64(2.0) * S::from_f64(::core::f64::consts::PI), x_dot]
    }
    /// The numbers of each shape of the drawing, in metres and radians.
    ///
    /// Operations: 2 additions, 2 multiplications, 1 sine-cosine pair.
    #[inline]
    pub fn drawing(&self, t: S, q: &[S; 2]) -> [S; 22] {
        let [alpha, x] = *q;
        let ([sin_alpha], [cos_alpha]) = S::sin_cos_each([alpha]);
        let A_x = self.r * cos_alpha;
        let A_y = self.r * sin_alpha;
        let rod_x = x + self.s;
        [
            S::from_f64(0.0),
            S::from_f64(0.0),
            S::from_f64(0.0),
            S::from_f64(0.0),
            self.r,
            S::from_f64(0.0),
            S::from_f64(0.0),
            A_x,
            A_y,
            x,
            -self.h,
            x,
            self.h,
            x,
            S::from_f64(0.0),
            rod_x,
            S::from_f64(0.0),
            rod_x,
            S::from_f64(0.0),
            S::from_f64(0.0),
            A_x,
            A_y,
        ]
    }
    /// Declared start: values or guesses of the coordinates (2), and speeds (2), in SI units; 0 where nothing is declared.
    ///
    /// Operations: 1 multiplication.
    #[inline]
    pub fn initial(&self) -> sim_kernel::Initial<[S; 2]> {
        sim_kernel::Initial {
            positions: [S::from_f64(0.0), S::from_f64(0.0)],
            speeds: [
                S::from_f64(4.0) * S::from_f64(::core::f64::consts::PI),
                S::from_f64(0.0),
            ],
        }
    }
    /// [`ScotchYokePrepared::dynamics`] once; for many calls with the same parameters [`Self::prepare`] first.
    #[inline]
    pub fn dynamics(
        &self,
        t: S,
        q: &[S; 2],
        qd: &[S; 2],
    ) -> sim_kernel::Dynamics<S, [S; 2], [S; 1]> {
        self.prepare().dynamics(t, q, qd)
    }
    /// [`ScotchYokePrepared::dynamics_jacobian`] once; for many calls with the same parameters [`Self::prepare`] first.
    #[inline]
    pub fn dynamics_jacobian(
        &self,
        t: S,
        q: &[S; 2],
        qd: &[S; 2],
    ) -> sim_kernel::DynamicsJacobian<S, [[S; 2]; 2], [[S; 2]; 1]> {
        self.prepare().dynamics_jacobian(t, q, qd)
    }
}
#[allow(non_snake_case, unused_variables, unused_parens, clippy::all, clippy::pedantic)]
impl<S: sim_kernel::Scalar> ScotchYokePrepared<S> {
    /// Accelerations (2), multipliers (1) and power, from
    ///
    /// ```text
    /// [ T_q' M T_q   C_q' ] [ q''    ]   [ T_q' (F - M g)                      ]
    /// [ C_q          0    ] [ lambda ] = [ -(C_q q' + C_t)_q q' - (..)_t       ]
    /// ```
    ///
    /// by an elimination planned from the structure of the system. Where `refused` is set a pivot was too small and nothing else holds: solve that state from the other kernels.
    ///
    /// Operations: 5 additions, 9 multiplications, 1 division, 1 sine-cosine pair.
    #[inline(always)]
    pub fn dynamics(
        &self,
        t: S,
        q: &[S; 2],
        qd: &[S; 2],
    ) -> sim_kernel::Dynamics<S, [S; 2], [S; 1]> {
        let [alpha, _] = *q;
        let [alpha_dot, _] = *qd;
        let ([sin_alpha], [cos_alpha]) = S::sin_cos_each([alpha]);
        let minus_slot_by_alpha = self.r * sin_alpha;
        let minus_l_lambda_slot_alpha = minus_slot_by_alpha * self.inverse_alpha;
        let minus_pivot_lambda_slot = minus_slot_by_alpha * minus_l_lambda_slot_alpha
            + self.inverse_x;
        let minus_lambda_slot = self.r * alpha_dot * alpha_dot * cos_alpha
            * (S::from_f64(1.0) / minus_pivot_lambda_slot);
        sim_kernel::Dynamics {
            accelerations: [
                -(minus_l_lambda_slot_alpha * minus_lambda_slot),
                -(self.inverse_x * minus_lambda_slot),
            ],
            multipliers: [-minus_lambda_slot],
            power: S::from_f64(0.0),
            refused: sim_kernel::pivot_is_refused(self.J, self.J)
                | sim_kernel::pivot_is_refused(self.m, self.m)
                | sim_kernel::pivot_is_refused(
                    -minus_pivot_lambda_slot,
                    minus_pivot_lambda_slot,
                ),
        }
    }
    /// The derivatives of accelerations (2 rows) and multipliers (1 rows) with respect to coordinates and speeds (2 columns each): with the equations of motion as `K z = r`, the solutions of `K dz = dr - dK z`. Where `refused` is set a pivot was too small and nothing else holds.
    ///
    /// Operations: 8 additions, 23 multiplications, 1 division, 1 sine-cosine pair.
    #[inline]
    pub fn dynamics_jacobian(
        &self,
        t: S,
        q: &[S; 2],
        qd: &[S; 2],
    ) -> sim_kernel::DynamicsJacobian<S, [[S; 2]; 2], [[S; 2]; 1]> {
        let [alpha, _] = *q;
        let [alpha_dot, _] = *qd;
        let alpha_dot_squared = alpha_dot * alpha_dot;
        let ([sin_alpha], [cos_alpha]) = S::sin_cos_each([alpha]);
        let minus_slot_by_alpha = self.r * sin_alpha;
        let minus_l_lambda_slot_alpha = minus_slot_by_alpha * self.inverse_alpha;
        let minus_pivot_lambda_slot = minus_slot_by_alpha * minus_l_lambda_slot_alpha
            + self.inverse_x;
        let minus_inverse_lambda_slot = S::from_f64(1.0) / minus_pivot_lambda_slot;
        let minus_lambda_slot = self.r * alpha_dot_squared * cos_alpha
            * minus_inverse_lambda_slot;
        let w = self.r * cos_alpha * minus_lambda_slot;
        let w_2 = minus_inverse_lambda_slot
            * (self.r
                * (sin_alpha * alpha_dot_squared
                    + cos_alpha * minus_l_lambda_slot_alpha * minus_lambda_slot)
                + minus_l_lambda_slot_alpha * w);
        let w_3 = minus_inverse_lambda_slot * alpha_dot * cos_alpha * self.k;
        sim_kernel::DynamicsJacobian {
            accelerations_by_positions: [
                [
                    minus_l_lambda_slot_alpha * w_2 - self.inverse_alpha * w,
                    S::from_f64(0.0),
                ],
                [self.inverse_x * w_2, S::from_f64(0.0)],
            ],
            accelerations_by_speeds: [
                [-(minus_l_lambda_slot_alpha * w_3), S::from_f64(0.0)],
                [-(self.inverse_x * w_3), S::from_f64(0.0)],
            ],
            multipliers_by_positions: [[w_2, S::from_f64(0.0)]],
            multipliers_by_speeds: [[-w_3, S::from_f64(0.0)]],
            refused: sim_kernel::pivot_is_refused(self.J, self.J)
                | sim_kernel::pivot_is_refused(self.m, self.m)
                | sim_kernel::pivot_is_refused(
                    -minus_pivot_lambda_slot,
                    minus_pivot_lambda_slot,
                ),
        }
    }
}
#[allow(non_snake_case, clippy::all, clippy::pedantic)]
impl<S: sim_kernel::Scalar> sim_kernel::Mechanism<S> for ScotchYoke<S> {
    type Q = [S; 2];
    type L = [S; 1];
    type Z = [S; 3];
    type QQ = [[S; 2]; 2];
    type LQ = [[S; 2]; 1];
    type LL = [[S; 1]; 1];
    type ZZ = [[S; 3]; 3];
    type Entries = [S; 0];
    type Envelope = [S; 0];
    type Parameters = [S; 5];
    type Outputs = [S; 3];
    type OutputRates = [S; 2];
    type Events = [S; 2];
    type EventValues = [S; 0];
    type Activities = [S; 0];
    type Drawing = [S; 22];
    type QP = [[S; 5]; 2];
    type LP = [[S; 5]; 1];
    type Inputs = [sim_kernel::Input<S>; 0];
    type Prepared = ScotchYokePrepared<S>;
    type On<T: sim_kernel::Scalar> = ScotchYoke<T>;
    const DESCRIPTION: sim_kernel::Description = sim_kernel::Description {
        name: "scotch-yoke",
        type_name: "ScotchYoke",
        docs: "Scotch yoke: the pin of a crank with its flywheel drives a yoke along a guide. It turns freely, faster where the\nyoke is slow.",
        declaration: "/// Scotch yoke: the pin of a crank with its flywheel drives a yoke along a guide. It turns freely, faster where the\n/// yoke is slow.\npub ScotchYoke;\n\ncoordinates {\n    /// Angle of the crank.\n    alpha [rad];\n    /// Displacement of the yoke.\n    x [m];\n}\n\nparameters {\n    /// Radius of the crank.\n    r [m] = 0.1;\n    /// Inertia of the crank and its flywheel.\n    J [kg*m^2] = 0.02;\n    /// Mass of the yoke.\n    m [kg] = 3;\n    /// Half the length of the slot, for drawings.\n    h [m] = 0.13;\n    /// Length of the rod on the yoke, for drawings.\n    s [m] = 0.25;\n}\n\nlet O = [0, 0];\nlet A = r*[cos(alpha), sin(alpha)];\nlet yoke = [x, 0];\nlet rod = yoke + [s, 0];\n\nbodies {\n    crank: inertia J, angle alpha;\n    yoke: mass m at yoke;\n}\n\nconstraints { slot: A.x = x; }\n\ninitial {\n    alpha = 0;\n    dot(alpha) = 120 [rpm];\n}\n\nevents {\n    period: alpha = 2*pi;\n    /// The yoke turns back.\n    dead_point: dot(x) = 0;\n}\n\noutputs {\n    crank_speed \"Speed of the crank\" {\n        /// speed\n        speed [rpm] = dot(alpha);\n    }\n    yoke_position \"Displacement of the yoke\" {\n        /// displacement\n        displacement [mm] = x;\n    }\n    slot_force \"Force of the pin on the slot\" {\n        /// along x\n        force [N] = reaction(slot);\n    }\n}\n\ndrawing {\n    ground O;\n    circle O radius r;\n    line O, A;\n    line yoke - [0, h], yoke + [0, h];\n    line yoke, rod;\n    slider rod along 0;\n    point A;\n}\n",
        coordinates: &[
            sim_kernel::Coordinate {
                position: sim_kernel::Quantity {
                    name: "alpha",
                    unit: "rad",
                    factor: 1f64,
                    is_length: false,
                    docs: "Angle of the crank.",
                },
                speed: sim_kernel::Quantity {
                    name: "alpha_dot",
                    unit: "rad/s",
                    factor: 1f64,
                    is_length: false,
                    docs: "",
                },
                acceleration: sim_kernel::Quantity {
                    name: "alpha_ddot",
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
                    name: "x",
                    unit: "m",
                    factor: 1f64,
                    is_length: true,
                    docs: "Displacement of the yoke.",
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
        ],
        parameters: &[
            sim_kernel::Quantity {
                name: "r",
                unit: "m",
                factor: 1f64,
                is_length: true,
                docs: "Radius of the crank.",
            },
            sim_kernel::Quantity {
                name: "J",
                unit: "kg*m^2",
                factor: 1f64,
                is_length: false,
                docs: "Inertia of the crank and its flywheel.",
            },
            sim_kernel::Quantity {
                name: "m",
                unit: "kg",
                factor: 1f64,
                is_length: false,
                docs: "Mass of the yoke.",
            },
            sim_kernel::Quantity {
                name: "h",
                unit: "m",
                factor: 1f64,
                is_length: true,
                docs: "Half the length of the slot, for drawings.",
            },
            sim_kernel::Quantity {
                name: "s",
                unit: "m",
                factor: 1f64,
                is_length: true,
                docs: "Length of the rod on the yoke, for drawings.",
            },
        ],
        inputs: &[],
        constraints: &[
            sim_kernel::Quantity {
                name: "slot",
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
        events: &[
            sim_kernel::event::Event {
                name: "period",
                direction: sim_kernel::event::Direction::Both,
                on_forces: false,
                steps: &[],
            },
            sim_kernel::event::Event {
                name: "dead_point",
                direction: sim_kernel::event::Direction::Both,
                on_forces: false,
                steps: &[],
            },
        ],
        outputs: &[
            sim_kernel::Quantity {
                name: "speed",
                unit: "rpm",
                factor: 0.10471975511965977f64,
                is_length: false,
                docs: "speed",
            },
            sim_kernel::Quantity {
                name: "displacement",
                unit: "mm",
                factor: 0.001f64,
                is_length: true,
                docs: "displacement",
            },
            sim_kernel::Quantity {
                name: "force",
                unit: "N",
                factor: 1f64,
                is_length: false,
                docs: "along x",
            },
        ],
        rated_outputs: &[0, 1],
        figures: &[
            sim_kernel::Figure {
                name: "crank_speed",
                title: "Speed of the crank",
                len: 1,
            },
            sim_kernel::Figure {
                name: "yoke_position",
                title: "Displacement of the yoke",
                len: 1,
            },
            sim_kernel::Figure {
                name: "slot_force",
                title: "Force of the pin on the slot",
                len: 1,
            },
        ],
        optional_kernels: &["dynamics_jacobian"],
        dimension: 2,
        drawing: &[
            sim_kernel::Shape::Ground(1),
            sim_kernel::Shape::Circle,
            sim_kernel::Shape::Line(2),
            sim_kernel::Shape::Line(2),
            sim_kernel::Shape::Line(2),
            sim_kernel::Shape::Slider,
            sim_kernel::Shape::Points(1),
        ],
    };
    fn defaults() -> Self {
        Self {
            r: S::from_f64(0.1f64),
            J: S::from_f64(0.02f64),
            m: S::from_f64(3f64),
            h: S::from_f64(0.13f64),
            s: S::from_f64(0.25f64),
        }
    }
    fn parameters(&self) -> [S; 5] {
        [self.r, self.J, self.m, self.h, self.s]
    }
    fn with_parameters(&self, parameters: [S; 5]) -> Self {
        Self {
            r: parameters[0],
            J: parameters[1],
            m: parameters[2],
            h: parameters[3],
            s: parameters[4],
            ..*self
        }
    }
    fn on<T: sim_kernel::Scalar>(
        &self,
        convert: impl ::core::ops::Fn(S) -> T,
    ) -> ScotchYoke<T> {
        ScotchYoke {
            r: convert(self.r),
            J: convert(self.J),
            m: convert(self.m),
            h: convert(self.h),
            s: convert(self.s),
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
    fn prepare(&self) -> ScotchYokePrepared<S> {
        self.prepare()
    }
    #[inline(always)]
    fn prepared_dynamics(
        prepared: &Self::Prepared,
        t: S,
        q: &[S; 2],
        qd: &[S; 2],
    ) -> sim_kernel::Dynamics<S, [S; 2], [S; 1]> {
        prepared.dynamics(t, q, qd)
    }
    #[inline(always)]
    fn dynamics_jacobian(
        &self,
        t: S,
        q: &[S; 2],
        qd: &[S; 2],
    ) -> sim_kernel::DynamicsJacobian<S, [[S; 2]; 2], [[S; 2]; 1]> {
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
    fn constraints(&self, t: S, q: &[S; 2]) -> [S; 1] {
        self.constraints(t, q)
    }
    #[inline(always)]
    fn constraint_magnitudes(&self, t: S, q: &[S; 2]) -> [S; 1] {
        self.constraint_magnitudes(t, q)
    }
    #[inline(always)]
    fn constraint_jacobian(&self, t: S, q: &[S; 2]) -> [[S; 2]; 1] {
        self.constraint_jacobian(t, q)
    }
    #[inline(always)]
    fn constraint_time_derivative(&self, t: S, q: &[S; 2]) -> [S; 1] {
        self.constraint_time_derivative(t, q)
    }
    #[inline(always)]
    fn constraint_convective(&self, t: S, q: &[S; 2], qd: &[S; 2]) -> [S; 1] {
        self.constraint_convective(t, q, qd)
    }
    #[inline(always)]
    fn constraint_linearization(
        &self,
        t: S,
        q: &[S; 2],
    ) -> sim_kernel::ConstraintLinearization<[S; 1], [[S; 2]; 1]> {
        self.constraint_linearization(t, q)
    }
    #[inline(always)]
    fn kinetic_energy(&self, t: S, q: &[S; 2], qd: &[S; 2]) -> S {
        self.kinetic_energy(t, q, qd)
    }
    #[inline(always)]
    fn power(&self, t: S, q: &[S; 2], qd: &[S; 2], qdd: &[S; 2], lambda: &[S; 1]) -> S {
        self.power(t, q, qd, qdd, lambda)
    }
    #[inline(always)]
    fn outputs(
        &self,
        t: S,
        q: &[S; 2],
        qd: &[S; 2],
        qdd: &[S; 2],
        lambda: &[S; 1],
    ) -> [S; 3] {
        self.outputs(t, q, qd, qdd, lambda).into()
    }
    #[inline(always)]
    fn output_rates(&self, t: S, q: &[S; 2], qd: &[S; 2], qdd: &[S; 2]) -> [S; 2] {
        self.output_rates(t, q, qd, qdd).into()
    }
    #[inline(always)]
    fn events(
        &self,
        t: S,
        q: &[S; 2],
        qd: &[S; 2],
        qdd: &[S; 2],
        lambda: &[S; 1],
    ) -> [S; 2] {
        self.events(t, q, qd, qdd, lambda)
    }
    #[inline(always)]
    fn drawing(&self, t: S, q: &[S; 2]) -> [S; 22] {
        self.drawing(t, q)
    }
    #[inline(always)]
    fn initial(&self) -> sim_kernel::Initial<[S; 2]> {
        self.initial()
    }
}
