/// A crank pin that turns evenly lifts a follower through a spring and a damper: motion prescribed by time alone.
///
/// The fields are its parameters, in SI units; the methods are its kernels.
///
/// # Equations of motion
///
/// ```text
/// mass_matrix * accelerations = generalized_forces - convective_forces
/// coordinates = [y]
/// [m] * [y_ddot] = [generalized_forces[1]]
///
/// mass_matrix = [m]
///
/// convective_forces = [0]
///
/// generalized_forces = [generalized_forces[1]]
/// generalized_forces[1] = -k*(y - l0 - A_y) - c*(y_dot - r*w*cos(t*w)) - m*g
///
/// A_y = r*sin(t*w)
/// ```
#[allow(non_snake_case)]
#[derive(
    ::core::clone::Clone,
    ::core::marker::Copy,
    ::core::fmt::Debug,
    ::core::cmp::PartialEq
)]
pub struct SpringFollower<S = ::core::primitive::f64> {
    /// Radius of the crank, in `m`.
    pub r: S,
    /// Speed of the crank, in `1/s`.
    pub w: S,
    /// Mass of the crank pin and its yoke, in `kg`.
    pub m_pin: S,
    /// Mass of the follower, in `kg`.
    pub m: S,
    /// Stiffness of the spring, in `N/m`.
    pub k: S,
    /// Damping, in `N*s/m`.
    pub c: S,
    /// Length of the spring without load, in `m`.
    pub l0: S,
    /// In `m/s^2`.
    pub g: S,
}
impl<S: sim_kernel::Scalar> ::core::default::Default for SpringFollower<S> {
    /// The declared values.
    fn default() -> Self {
        <Self as sim_kernel::Mechanism<S>>::defaults()
    }
}
/// Coordinates of [`SpringFollower`] by name, in SI units; also for their speeds and accelerations.
#[allow(non_snake_case)]
#[derive(
    ::core::clone::Clone,
    ::core::marker::Copy,
    ::core::fmt::Debug,
    ::core::cmp::PartialEq
)]
pub struct SpringFollowerCoordinates<S = ::core::primitive::f64> {
    /// Height of the follower, in `m`.
    pub y: S,
}
impl<S: sim_kernel::Scalar> ::core::convert::From<[S; 1]>
for SpringFollowerCoordinates<S> {
    fn from(values: [S; 1]) -> Self {
        Self { y: values[0] }
    }
}
impl<S: sim_kernel::Scalar> ::core::convert::From<SpringFollowerCoordinates<S>>
for [S; 1] {
    fn from(record: SpringFollowerCoordinates<S>) -> Self {
        [record.y]
    }
}
/// Outputs of [`SpringFollower`] by name, in SI units.
#[allow(non_snake_case)]
#[derive(
    ::core::clone::Clone,
    ::core::marker::Copy,
    ::core::fmt::Debug,
    ::core::cmp::PartialEq
)]
pub struct SpringFollowerOutputs<S = ::core::primitive::f64> {
    /// pin, in `m`.
    pub pin_height: S,
    /// follower, in `m`.
    pub follower_height: S,
    /// spring, in `N`.
    pub spring_force: S,
    /// damper, in `N`.
    pub damper_force: S,
}
impl<S: sim_kernel::Scalar> ::core::convert::From<[S; 4]> for SpringFollowerOutputs<S> {
    fn from(values: [S; 4]) -> Self {
        Self {
            pin_height: values[0],
            follower_height: values[1],
            spring_force: values[2],
            damper_force: values[3],
        }
    }
}
impl<S: sim_kernel::Scalar> ::core::convert::From<SpringFollowerOutputs<S>> for [S; 4] {
    fn from(record: SpringFollowerOutputs<S>) -> Self {
        [
            record.pin_height,
            record.follower_height,
            record.spring_force,
            record.damper_force,
        ]
    }
}
/// Rates of the outputs of [`SpringFollower`] by name, in SI units.
#[allow(non_snake_case)]
#[derive(
    ::core::clone::Clone,
    ::core::marker::Copy,
    ::core::fmt::Debug,
    ::core::cmp::PartialEq
)]
pub struct SpringFollowerOutputRates<S = ::core::primitive::f64> {
    /// Rate of `pin_height`.
    pub pin_height: S,
    /// Rate of `follower_height`.
    pub follower_height: S,
    /// Rate of `spring_force`.
    pub spring_force: S,
    /// Rate of `damper_force`.
    pub damper_force: S,
}
impl<S: sim_kernel::Scalar> ::core::convert::From<[S; 4]>
for SpringFollowerOutputRates<S> {
    fn from(values: [S; 4]) -> Self {
        Self {
            pin_height: values[0],
            follower_height: values[1],
            spring_force: values[2],
            damper_force: values[3],
        }
    }
}
impl<S: sim_kernel::Scalar> ::core::convert::From<SpringFollowerOutputRates<S>>
for [S; 4] {
    fn from(record: SpringFollowerOutputRates<S>) -> Self {
        [
            record.pin_height,
            record.follower_height,
            record.spring_force,
            record.damper_force,
        ]
    }
}
/// What the equations of motion need of the parameters of [`SpringFollower`], from [`SpringFollower::prepare`]; its methods are the kernels of each step.
#[allow(non_snake_case)]
#[derive(
    ::core::clone::Clone,
    ::core::marker::Copy,
    ::core::fmt::Debug,
    ::core::cmp::PartialEq
)]
pub struct SpringFollowerPrepared<S = ::core::primitive::f64> {
    m: S,
    k: S,
    l0: S,
    r: S,
    w: S,
    c: S,
    k_2: S,
    k_3: S,
    inverse_y: S,
    k_4: S,
    k_5: S,
    k_6: S,
    k_7: S,
    k_8: S,
    k_9: S,
}
#[allow(non_snake_case, unused_variables, unused_parens, clippy::all, clippy::pedantic)]
impl<S: sim_kernel::Scalar> SpringFollower<S> {
    /// What the equations of motion need of the parameters, computed once for a set of parameters.
    ///
    /// Operations: 2 additions, 13 multiplications, 1 division.
    #[inline]
    pub fn prepare(&self) -> SpringFollowerPrepared<S> {
        let w = self.r * self.w;
        let inverse_m = S::from_f64(1.0) / self.m;
        let w_2 = self.g * self.m_pin;
        let w_squared = self.w * self.w;
        SpringFollowerPrepared {
            m: self.m,
            k: self.k,
            l0: self.l0,
            r: self.r,
            w: self.w,
            c: self.c,
            k_2: w,
            k_3: self.m * self.g,
            inverse_y: inverse_m,
            k_4: w_2,
            k_5: self.r * w_squared * self.m_pin,
            k_6: self.r * self.r * self.w * w_squared * self.m_pin,
            k_7: w * w_2,
            k_8: -(self.k * inverse_m),
            k_9: -(self.c * inverse_m),
        }
    }
    /// Mass matrix `T_q' M T_q`, 1 x 1, symmetric, in SI units.
    ///
    /// Operations: none.
    #[inline]
    pub fn mass_matrix(&self, t: S, q: &[S; 1]) -> [[S; 1]; 1] {
        [[self.m]]
    }
    /// Convective forces `T_q' M g`, 1, with `g = (T_q q' + T_t)_q q' + (..)_t`: joules per unit of each coordinate.
    ///
    /// Operations: none.
    #[inline]
    pub fn convective_forces(&self, t: S, q: &[S; 1], qd: &[S; 1]) -> [S; 1] {
        [S::from_f64(0.0)]
    }
    /// Generalised forces `T_q' F`, 1: joules per unit of each coordinate.
    ///
    /// Operations: 6 additions, 7 multiplications, 1 sine-cosine pair.
    #[inline]
    pub fn generalized_forces(&self, t: S, q: &[S; 1], qd: &[S; 1]) -> [S; 1] {
        let [y] = *q;
        let [y_dot] = *qd;
        let w = t * self.w;
        let ([sin_w], [cos_w]) = S::sin_cos_each([w]);
        [
            -(self.m * self.g + self.k * (y - self.l0 - self.r * sin_w)
                + self.c * (y_dot - cos_w * self.r * self.w)),
        ]
    }
    /// Constraints `C`, 0, in SI units; zero throughout the motion.
    ///
    /// Operations: none.
    #[inline]
    pub fn constraints(&self, t: S, q: &[S; 1]) -> [S; 0] {
        []
    }
    /// The sum of the magnitudes of the terms of `C`, 0, in SI units: what its rounding is relative to.
    ///
    /// Operations: none.
    #[inline]
    pub fn constraint_magnitudes(&self, t: S, q: &[S; 1]) -> [S; 0] {
        []
    }
    /// Constraint Jacobian `C_q`, 0 x 1: units of each constraint per unit of each coordinate.
    ///
    /// Operations: none.
    #[inline]
    pub fn constraint_jacobian(&self, t: S, q: &[S; 1]) -> [[S; 1]; 0] {
        []
    }
    /// `C_t`, 0, units of `C` per second: the speeds obey `C_q q' + C_t = 0`.
    ///
    /// Operations: none.
    #[inline]
    pub fn constraint_time_derivative(&self, t: S, q: &[S; 1]) -> [S; 0] {
        []
    }
    /// `(C_q q' + C_t)_q q' + (..)_t`, 0, units of `C` per second squared: the part of `C''` without accelerations.
    ///
    /// Operations: none.
    #[inline]
    pub fn constraint_convective(&self, t: S, q: &[S; 1], qd: &[S; 1]) -> [S; 0] {
        []
    }
    /// `C` (0), `C_q` (0 x 1) and `C_t` (0) together, in SI units, for projection.
    ///
    /// Operations: none.
    #[inline]
    pub fn constraint_linearization(
        &self,
        t: S,
        q: &[S; 1],
    ) -> sim_kernel::ConstraintLinearization<[S; 0], [[S; 1]; 0]> {
        sim_kernel::ConstraintLinearization {
            values: [],
            jacobian: [],
            time_derivative: [],
        }
    }
    /// Kinetic energy `v' M v / 2`, in joules.
    ///
    /// Operations: 1 addition, 8 multiplications.
    #[inline]
    pub fn kinetic_energy(&self, t: S, q: &[S; 1], qd: &[S; 1]) -> S {
        let [y_dot] = *qd;
        S::from_f64(0.5) * self.r * self.r * self.w * self.w * self.m_pin
            + y_dot * y_dot * S::from_f64(0.5) * self.m
    }
    /// Power of loads and drives, `F' v + lambda' C_t + T_t' (M x'' - F)`, in watts.
    ///
    /// Operations: 10 additions, 22 multiplications, 1 sine-cosine pair.
    #[inline]
    pub fn power(
        &self,
        t: S,
        q: &[S; 1],
        qd: &[S; 1],
        qdd: &[S; 1],
        lambda: &[S; 0],
    ) -> S {
        let [y] = *q;
        let [y_dot] = *qd;
        let w = self.w * t;
        let ([sin_w], [cos_w]) = S::sin_cos_each([w]);
        let w_2 = self.r * self.w;
        let w_3 = self.m_pin * self.g;
        let w_squared = self.w * self.w;
        let w_4 = y_dot - cos_w * w_2;
        let w_5 = self.k * (y - self.l0 - self.r * sin_w) + w_4 * self.c;
        let w_6 = cos_w
            * (w_2 * (w_3 - sin_w * self.r * w_squared * self.m_pin - w_5) - w_3 * w_2
                + sin_w * self.r * self.r * self.w * w_squared * self.m_pin);
        w_6 - y_dot * self.g * self.m - w_4 * w_5
    }
    /// Outputs, 4, in SI units.
    ///
    /// Operations: 5 additions, 6 multiplications, 1 sine-cosine pair.
    #[inline]
    pub fn outputs(
        &self,
        t: S,
        q: &[S; 1],
        qd: &[S; 1],
        qdd: &[S; 1],
        lambda: &[S; 0],
    ) -> SpringFollowerOutputs<S> {
        let [y] = *q;
        let [y_dot] = *qd;
        let w = t * self.w;
        let ([sin_w], [cos_w]) = S::sin_cos_each([w]);
        let A_y = self.r * sin_w;
        [
            A_y,
            y,
            -(self.k * (y - A_y - self.l0)),
            -(self.c * (y_dot - cos_w * self.r * self.w)),
        ]
            .into()
    }
    /// Rates of the outputs that depend on neither accelerations nor multipliers, 4, in SI units per second.
    ///
    /// Operations: 4 additions, 8 multiplications, 1 sine-cosine pair.
    #[inline]
    pub fn output_rates(
        &self,
        t: S,
        q: &[S; 1],
        qd: &[S; 1],
        qdd: &[S; 1],
    ) -> SpringFollowerOutputRates<S> {
        let [y_dot] = *qd;
        let [y_ddot] = *qdd;
        let w = self.w * t;
        let ([sin_w], [cos_w]) = S::sin_cos_each([w]);
        let w_2 = cos_w * self.r * self.w;
        [
            w_2,
            y_dot,
            -(self.k * (y_dot - w_2)),
            -(self.c * (y_ddot + sin_w * self.r * self.w * self.w)),
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
        q: &[S; 1],
        qd: &[S; 1],
        qdd: &[S; 1],
        lambda: &[S; 0],
    ) -> [S; 2] {
        let [y_dot] = *qd;
        let ([w], [_]) = S::sin_cos_each([t * self.w]);
        [w, y_dot]
    }
    /// The numbers of each shape of the drawing, in metres and radians.
    ///
    /// Operations: 2 additions, 4 multiplications, 1 sine-cosine pair.
    #[inline]
    pub fn drawing(&self, t: S, q: &[S; 1]) -> [S; 26] {
        let [y] = *q;
        let w = t * self.w;
        let ([sin_w], [cos_w]) = S::sin_cos_each([w]);
        let A_x = self.r * cos_w;
        let A_y = self.r * sin_w;
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
            A_x,
            A_y,
            S::from_f64(0.0),
            A_y,
            -S::from_f64(0.008),
            A_y,
            -S::from_f64(0.008),
            y,
            S::from_f64(0.008),
            A_y,
            S::from_f64(0.008),
            y,
            A_x,
            A_y,
            S::from_f64(0.0),
            y,
            S::from_f64(0.5) * S::from_f64(::core::f64::consts::PI),
        ]
    }
    /// Declared start: values or guesses of the coordinates (1), and speeds (1), in SI units; 0 where nothing is declared.
    ///
    /// Operations: none.
    #[inline]
    pub fn initial(&self) -> sim_kernel::Initial<[S; 1]> {
        sim_kernel::Initial {
            positions: [S::from_f64(0.15)],
            speeds: [S::from_f64(0.0)],
        }
    }
    /// [`SpringFollowerPrepared::dynamics`] once; for many calls with the same parameters [`Self::prepare`] first.
    #[inline]
    pub fn dynamics(
        &self,
        t: S,
        q: &[S; 1],
        qd: &[S; 1],
    ) -> sim_kernel::Dynamics<S, [S; 1], [S; 0]> {
        self.prepare().dynamics(t, q, qd)
    }
    /// [`SpringFollowerPrepared::dynamics_jacobian`] once; for many calls with the same parameters [`Self::prepare`] first.
    #[inline]
    pub fn dynamics_jacobian(
        &self,
        t: S,
        q: &[S; 1],
        qd: &[S; 1],
    ) -> sim_kernel::DynamicsJacobian<S, [[S; 1]; 1], [[S; 1]; 0]> {
        self.prepare().dynamics_jacobian(t, q, qd)
    }
}
#[allow(non_snake_case, unused_variables, unused_parens, clippy::all, clippy::pedantic)]
impl<S: sim_kernel::Scalar> SpringFollowerPrepared<S> {
    /// Accelerations (1), multipliers (0) and power, from
    ///
    /// ```text
    /// [ T_q' M T_q   C_q' ] [ q''    ]   [ T_q' (F - M g)                      ]
    /// [ C_q          0    ] [ lambda ] = [ -(C_q q' + C_t)_q q' - (..)_t       ]
    /// ```
    ///
    /// by an elimination planned from the structure of the system. Where `refused` is set a pivot was too small and nothing else holds: solve that state from the other kernels.
    ///
    /// Operations: 13 additions, 12 multiplications, 1 sine-cosine pair.
    #[inline(always)]
    pub fn dynamics(
        &self,
        t: S,
        q: &[S; 1],
        qd: &[S; 1],
    ) -> sim_kernel::Dynamics<S, [S; 1], [S; 0]> {
        let [y] = *q;
        let [y_dot] = *qd;
        let w = t * self.w;
        let ([sin_w], [cos_w]) = S::sin_cos_each([w]);
        let w_2 = self.k * (y - self.l0 - self.r * sin_w);
        let w_3 = y_dot - cos_w * self.k_2;
        let w_4 = self.c * w_3;
        let w_5 = w_2 + w_4;
        sim_kernel::Dynamics {
            accelerations: [-((self.k_3 + w_2 + w_4) * self.inverse_y)],
            multipliers: [],
            power: cos_w
                * (self.k_2 * (self.k_4 - sin_w * self.k_5 - w_5) - self.k_7
                    + sin_w * self.k_6) - y_dot * self.k_3 - w_3 * w_5,
            refused: sim_kernel::pivot_is_refused(self.m, self.m),
        }
    }
    /// The derivatives of accelerations (1 rows) and multipliers (0 rows) with respect to coordinates and speeds (1 columns each): with the equations of motion as `K z = r`, the solutions of `K dz = dr - dK z`. Where `refused` is set a pivot was too small and nothing else holds.
    ///
    /// Operations: none.
    #[inline]
    pub fn dynamics_jacobian(
        &self,
        t: S,
        q: &[S; 1],
        qd: &[S; 1],
    ) -> sim_kernel::DynamicsJacobian<S, [[S; 1]; 1], [[S; 1]; 0]> {
        sim_kernel::DynamicsJacobian {
            accelerations_by_positions: [[self.k_8]],
            accelerations_by_speeds: [[self.k_9]],
            multipliers_by_positions: [],
            multipliers_by_speeds: [],
            refused: sim_kernel::pivot_is_refused(self.m, self.m),
        }
    }
}
#[allow(non_snake_case, clippy::all, clippy::pedantic)]
impl<S: sim_kernel::Scalar> sim_kernel::Mechanism<S> for SpringFollower<S> {
    type Q = [S; 1];
    type L = [S; 0];
    type Z = [S; 1];
    type QQ = [[S; 1]; 1];
    type LQ = [[S; 1]; 0];
    type LL = [[S; 0]; 0];
    type ZZ = [[S; 1]; 1];
    type Entries = [S; 0];
    type Envelope = [S; 0];
    type Parameters = [S; 8];
    type Outputs = [S; 4];
    type OutputRates = [S; 4];
    type Events = [S; 2];
    type EventValues = [S; 0];
    type Activities = [S; 0];
    type Drawing = [S; 26];
    type QP = [[S; 8]; 1];
    type LP = [[S; 8]; 0];
    type Inputs = [sim_kernel::Input<S>; 0];
    type Prepared = SpringFollowerPrepared<S>;
    type On<T: sim_kernel::Scalar> = SpringFollower<T>;
    const DESCRIPTION: sim_kernel::Description = sim_kernel::Description {
        name: "spring-follower",
        type_name: "SpringFollower",
        docs: "A crank pin that turns evenly lifts a follower through a spring and a damper: motion prescribed by time alone.",
        declaration: "/// A crank pin that turns evenly lifts a follower through a spring and a damper: motion prescribed by time alone.\npub SpringFollower;\n\ncoordinates {\n    /// Height of the follower.\n    y [m];\n}\n\nparameters {\n    /// Radius of the crank.\n    r [mm] = 40;\n    /// Speed of the crank.\n    w [rpm] = 240;\n    /// Mass of the crank pin and its yoke.\n    m_pin [kg] = 0.4;\n    /// Mass of the follower.\n    m [kg] = 0.8;\n    /// Stiffness of the spring.\n    k [N/m] = 1200;\n    /// Damping.\n    c [N*s/m] = 6;\n    /// Length of the spring without load.\n    l0 [mm] = 150;\n    g [m/s^2] = 9.81;\n}\n\nlet O = [0, 0];\nlet A = r*[cos(w*t), sin(w*t)];\nlet yoke = [0, A.y];\nlet P = [0, y];\n\nbodies {\n    pin: mass m_pin at A;\n    follower: mass m at P;\n}\n\nloads {\n    gravity [0, -g];\n    spring k, rest l0 between A.y and y;\n    damper c between A.y and y;\n}\n\ninitial {\n    y = 150 [mm];\n    dot(y) = 0;\n}\n\nevents {\n    period: sin(w*t) = 0;\n    /// The follower turns back.\n    turn: dot(y) = 0;\n}\n\noutputs {\n    heights \"Heights\" {\n        /// pin\n        pin_height [mm] = A.y;\n        /// follower\n        follower_height [mm] = y;\n    }\n    forces \"Forces on the follower\" {\n        /// spring\n        spring_force [N] = k*(l0 - (y - A.y));\n        /// damper\n        damper_force [N] = -c*dot(y - A.y);\n    }\n}\n\nlet side = [8 [mm], 0];\n\ndrawing {\n    ground O;\n    circle O radius r;\n    line O, A;\n    line A, yoke;\n    spring yoke - side, P - side;\n    damper yoke + side, P + side;\n    point A;\n    slider P along pi/2;\n}\n",
        coordinates: &[
            sim_kernel::Coordinate {
                position: sim_kernel::Quantity {
                    name: "y",
                    unit: "m",
                    factor: 1f64,
                    is_length: true,
                    docs: "Height of the follower.",
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
        ],
        parameters: &[
            sim_kernel::Quantity {
                name: "r",
                unit: "mm",
                factor: 0.001f64,
                is_length: true,
                docs: "Radius of the crank.",
            },
            sim_kernel::Quantity {
                name: "w",
                unit: "rpm",
                factor: 0.10471975511965977f64,
                is_length: false,
                docs: "Speed of the crank.",
            },
            sim_kernel::Quantity {
                name: "m_pin",
                unit: "kg",
                factor: 1f64,
                is_length: false,
                docs: "Mass of the crank pin and its yoke.",
            },
            sim_kernel::Quantity {
                name: "m",
                unit: "kg",
                factor: 1f64,
                is_length: false,
                docs: "Mass of the follower.",
            },
            sim_kernel::Quantity {
                name: "k",
                unit: "N/m",
                factor: 1f64,
                is_length: false,
                docs: "Stiffness of the spring.",
            },
            sim_kernel::Quantity {
                name: "c",
                unit: "N*s/m",
                factor: 1f64,
                is_length: false,
                docs: "Damping.",
            },
            sim_kernel::Quantity {
                name: "l0",
                unit: "mm",
                factor: 0.001f64,
                is_length: true,
                docs: "Length of the spring without load.",
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
        events: &[
            sim_kernel::event::Event {
                name: "period",
                direction: sim_kernel::event::Direction::Both,
                on_forces: false,
                steps: &[],
            },
            sim_kernel::event::Event {
                name: "turn",
                direction: sim_kernel::event::Direction::Both,
                on_forces: false,
                steps: &[],
            },
        ],
        outputs: &[
            sim_kernel::Quantity {
                name: "pin_height",
                unit: "mm",
                factor: 0.001f64,
                is_length: true,
                docs: "pin",
            },
            sim_kernel::Quantity {
                name: "follower_height",
                unit: "mm",
                factor: 0.001f64,
                is_length: true,
                docs: "follower",
            },
            sim_kernel::Quantity {
                name: "spring_force",
                unit: "N",
                factor: 1f64,
                is_length: false,
                docs: "spring",
            },
            sim_kernel::Quantity {
                name: "damper_force",
                unit: "N",
                factor: 1f64,
                is_length: false,
                docs: "damper",
            },
        ],
        rated_outputs: &[0, 1, 2, 3],
        figures: &[
            sim_kernel::Figure {
                name: "heights",
                title: "Heights",
                len: 2,
            },
            sim_kernel::Figure {
                name: "forces",
                title: "Forces on the follower",
                len: 2,
            },
        ],
        optional_kernels: &["dynamics_jacobian"],
        dimension: 2,
        drawing: &[
            sim_kernel::Shape::Ground(1),
            sim_kernel::Shape::Circle,
            sim_kernel::Shape::Line(2),
            sim_kernel::Shape::Line(2),
            sim_kernel::Shape::Spring,
            sim_kernel::Shape::Damper,
            sim_kernel::Shape::Points(1),
            sim_kernel::Shape::Slider,
        ],
    };
    fn defaults() -> Self {
        Self {
            r: S::from_f64(0.04f64),
            w: S::from_f64(25.132741228718345f64),
            m_pin: S::from_f64(0.4f64),
            m: S::from_f64(0.8f64),
            k: S::from_f64(1200f64),
            c: S::from_f64(6f64),
            l0: S::from_f64(0.15f64),
            g: S::from_f64(9.81f64),
        }
    }
    fn parameters(&self) -> [S; 8] {
        [self.r, self.w, self.m_pin, self.m, self.k, self.c, self.l0, self.g]
    }
    fn with_parameters(&self, parameters: [S; 8]) -> Self {
        Self {
            r: parameters[0],
            w: parameters[1],
            m_pin: parameters[2],
            m: parameters[3],
            k: parameters[4],
            c: parameters[5],
            l0: parameters[6],
            g: parameters[7],
            ..*self
        }
    }
    fn on<T: sim_kernel::Scalar>(
        &self,
        convert: impl ::core::ops::Fn(S) -> T,
    ) -> SpringFollower<T> {
        SpringFollower {
            r: convert(self.r),
            w: convert(self.w),
            m_pin: convert(self.m_pin),
            m: convert(self.m),
            k: convert(self.k),
            c: convert(self.c),
            l0: convert(self.l0),
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
    fn prepare(&self) -> SpringFollowerPrepared<S> {
        self.prepare()
    }
    #[inline(always)]
    fn prepared_dynamics(
        prepared: &Self::Prepared,
        t: S,
        q: &[S; 1],
        qd: &[S; 1],
    ) -> sim_kernel::Dynamics<S, [S; 1], [S; 0]> {
        prepared.dynamics(t, q, qd)
    }
    #[inline(always)]
    fn dynamics_jacobian(
        &self,
        t: S,
        q: &[S; 1],
        qd: &[S; 1],
    ) -> sim_kernel::DynamicsJacobian<S, [[S; 1]; 1], [[S; 1]; 0]> {
        self.prepare().dynamics_jacobian(t, q, qd)
    }
    #[inline(always)]
    fn mass_matrix(&self, t: S, q: &[S; 1]) -> [[S; 1]; 1] {
        self.mass_matrix(t, q)
    }
    #[inline(always)]
    fn convective_forces(&self, t: S, q: &[S; 1], qd: &[S; 1]) -> [S; 1] {
        self.convective_forces(t, q, qd)
    }
    #[inline(always)]
    fn generalized_forces(&self, t: S, q: &[S; 1], qd: &[S; 1]) -> [S; 1] {
        self.generalized_forces(t, q, qd)
    }
    #[inline(always)]
    fn constraints(&self, t: S, q: &[S; 1]) -> [S; 0] {
        self.constraints(t, q)
    }
    #[inline(always)]
    fn constraint_magnitudes(&self, t: S, q: &[S; 1]) -> [S; 0] {
        self.constraint_magnitudes(t, q)
    }
    #[inline(always)]
    fn constraint_jacobian(&self, t: S, q: &[S; 1]) -> [[S; 1]; 0] {
        self.constraint_jacobian(t, q)
    }
    #[inline(always)]
    fn constraint_time_derivative(&self, t: S, q: &[S; 1]) -> [S; 0] {
        self.constraint_time_derivative(t, q)
    }
    #[inline(always)]
    fn constraint_convective(&self, t: S, q: &[S; 1], qd: &[S; 1]) -> [S; 0] {
        self.constraint_convective(t, q, qd)
    }
    #[inline(always)]
    fn constraint_linearization(
        &self,
        t: S,
        q: &[S; 1],
    ) -> sim_kernel::ConstraintLinearization<[S; 0], [[S; 1]; 0]> {
        self.constraint_linearization(t, q)
    }
    #[inline(always)]
    fn kinetic_energy(&self, t: S, q: &[S; 1], qd: &[S; 1]) -> S {
        self.kinetic_energy(t, q, qd)
    }
    #[inline(always)]
    fn power(&self, t: S, q: &[S; 1], qd: &[S; 1], qdd: &[S; 1], lambda: &[S; 0]) -> S {
        self.power(t, q, qd, qdd, lambda)
    }
    #[inline(always)]
    fn outputs(
        &self,
        t: S,
        q: &[S; 1],
        qd: &[S; 1],
        qdd: &[S; 1],
        lambda: &[S; 0],
    ) -> [S; 4] {
        self.outputs(t, q, qd, qdd, lambda).into()
    }
    #[inline(always)]
    fn output_rates(&self, t: S, q: &[S; 1], qd: &[S; 1], qdd: &[S; 1]) -> [S; 4] {
        self.output_rates(t, q, qd, qdd).into()
    }
    #[inline(always)]
    fn events(
        &self,
        t: S,
        q: &[S; 1],
        qd: &[S; 1],
        qdd: &[S; 1],
        lambda: &[S; 0],
    ) -> [S; 2] {
        self.events(t, q, qd, qdd, lambda)
    }
    #[inline(always)]
    fn drawing(&self, t: S, q: &[S; 1]) -> [S; 26] {
        self.drawing(t, q)
    }
    #[inline(always)]
    fn initial(&self) -> sim_kernel::Initial<[S; 1]> {
        self.initial()
    }
}
