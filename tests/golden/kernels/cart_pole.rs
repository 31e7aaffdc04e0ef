/// A cart on a rail with a pole that stands on it, pushed by a drive.
///
/// The fields are its parameters and inputs, in SI units; the methods are its kernels.
///
/// # Equations of motion
///
/// ```text
/// mass_matrix * accelerations = generalized_forces - convective_forces
/// coordinates = [x; phi]
/// [M + m, m*l*cos(phi); m*l*cos(phi), m*l^2] * [x_ddot; phi_ddot] = [push + m*l*phi_dot^2*sin(phi); m*l*g*sin(phi)]
///
/// mass_matrix = [M + m, m*l*cos(phi); m*l*cos(phi), m*l^2]
///
/// convective_forces = [-m*l*phi_dot^2*sin(phi); 0]
///
/// generalized_forces = [push; m*l*g*sin(phi)]
/// ```
#[allow(non_snake_case)]
#[derive(
    ::core::clone::Clone,
    ::core::marker::Copy,
    ::core::fmt::Debug,
    ::core::cmp::PartialEq
)]
pub struct CartPole<S = ::core::primitive::f64> {
    /// Mass of the cart, in `kg`.
    pub M: S,
    /// Mass at the end of the pole, in `kg`.
    pub m: S,
    /// Length of the pole, in `m`.
    pub l: S,
    /// Angle of the pole at the start, in `1`.
    pub start: S,
    /// In `m/s^2`.
    pub g: S,
    /// Force of the drive, to the right, in `N`.
    pub push: sim_kernel::Input<S>,
}
impl<S: sim_kernel::Scalar> ::core::default::Default for CartPole<S> {
    /// The declared values.
    fn default() -> Self {
        <Self as sim_kernel::Mechanism<S>>::defaults()
    }
}
/// Coordinates of [`CartPole`] by name, in SI units; also for their speeds and accelerations.
#[allow(non_snake_case)]
#[derive(
    ::core::clone::Clone,
    ::core::marker::Copy,
    ::core::fmt::Debug,
    ::core::cmp::PartialEq
)]
pub struct CartPoleCoordinates<S = ::core::primitive::f64> {
    /// Position of the cart, in `m`.
    pub x: S,
    /// Angle of the pole from upright, to the right, in `rad`.
    pub phi: S,
}
impl<S: sim_kernel::Scalar> ::core::convert::From<[S; 2]> for CartPoleCoordinates<S> {
    fn from(values: [S; 2]) -> Self {
        Self {
            x: values[0],
            phi: values[1],
        }
    }
}
impl<S: sim_kernel::Scalar> ::core::convert::From<CartPoleCoordinates<S>> for [S; 2] {
    fn from(record: CartPoleCoordinates<S>) -> Self {
        [record.x, record.phi]
    }
}
/// Outputs of [`CartPole`] by name, in SI units.
#[allow(non_snake_case)]
#[derive(
    ::core::clone::Clone,
    ::core::marker::Copy,
    ::core::fmt::Debug,
    ::core::cmp::PartialEq
)]
pub struct CartPoleOutputs<S = ::core::primitive::f64> {
    /// position, in `m`.
    pub position: S,
    /// from upright, in `1`.
    pub angle: S,
    /// power, in `W`.
    pub power: S,
}
impl<S: sim_kernel::Scalar> ::core::convert::From<[S; 3]> for CartPoleOutputs<S> {
    fn from(values: [S; 3]) -> Self {
        Self {
            position: values[0],
            angle: values[1],
            power: values[2],
        }
    }
}
impl<S: sim_kernel::Scalar> ::core::convert::From<CartPoleOutputs<S>> for [S; 3] {
    fn from(record: CartPoleOutputs<S>) -> Self {
        [record.position, record.angle, record.power]
    }
}
/// Rates of the outputs of [`CartPole`] by name, in SI units.
#[allow(non_snake_case)]
#[derive(
    ::core::clone::Clone,
    ::core::marker::Copy,
    ::core::fmt::Debug,
    ::core::cmp::PartialEq
)]
pub struct CartPoleOutputRates<S = ::core::primitive::f64> {
    /// Rate of `position`.
    pub position: S,
    /// Rate of `angle`.
    pub angle: S,
}
impl<S: sim_kernel::Scalar> ::core::convert::From<[S; 2]> for CartPoleOutputRates<S> {
    fn from(values: [S; 2]) -> Self {
        Self {
            position: values[0],
            angle: values[1],
        }
    }
}
impl<S: sim_kernel::Scalar> ::core::convert::From<CartPoleOutputRates<S>> for [S; 2] {
    fn from(record: CartPoleOutputRates<S>) -> Self {
        [record.position, record.angle]
    }
}
/// What the equations of motion need of the parameters of [`CartPole`], from [`CartPole::prepare`]; its methods are the kernels of each step.
#[allow(non_snake_case)]
#[derive(
    ::core::clone::Clone,
    ::core::marker::Copy,
    ::core::fmt::Debug,
    ::core::cmp::PartialEq
)]
pub struct CartPolePrepared<S = ::core::primitive::f64> {
    mass_x_x: S,
    k: S,
    mass_phi_phi: S,
    k_2: S,
    inverse_x: S,
    k_3: S,
    /// Force of the drive, to the right, in `N`.
    pub push: sim_kernel::Input<S>,
}
#[allow(non_snake_case, unused_variables, unused_parens, clippy::all, clippy::pedantic)]
impl<S: sim_kernel::Scalar> CartPole<S> {
    /// What the equations of motion need of the parameters, computed once for a set of parameters.
    ///
    /// Operations: 1 addition, 5 multiplications, 1 division.
    #[inline]
    pub fn prepare(&self) -> CartPolePrepared<S> {
        let mass_x_x = self.M + self.m;
        let w = self.m * self.l;
        CartPolePrepared {
            mass_x_x: mass_x_x,
            k: w,
            mass_phi_phi: self.m * self.l * self.l,
            k_2: w * self.g,
            inverse_x: S::from_f64(1.0) / mass_x_x,
            k_3: w * S::from_f64(2.0),
            push: self.push,
        }
    }
    /// Mass matrix `T_q' M T_q`, 2 x 2, symmetric, in SI units.
    ///
    /// Operations: 1 addition, 4 multiplications, 1 sine-cosine pair.
    #[inline]
    pub fn mass_matrix(&self, t: S, q: &[S; 2]) -> [[S; 2]; 2] {
        let [_, phi] = *q;
        let ([_], [cos_phi]) = S::sin_cos_each([phi]);
        let mass_phi_x = cos_phi * self.m * self.l;
        [[self.M + self.m, mass_phi_x], [mass_phi_x, self.m * self.l * self.l]]
    }
    /// Convective forces `T_q' M g`, 2, with `g = (T_q q' + T_t)_q q' + (..)_t`: joules per unit of each coordinate.
    ///
    /// Operations: 1 addition, 4 multiplications, 1 sine-cosine pair.
    #[inline]
    pub fn convective_forces(&self, t: S, q: &[S; 2], qd: &[S; 2]) -> [S; 2] {
        let [_, phi] = *q;
        let [_, phi_dot] = *qd;
        let ([sin_phi], [_]) = S::sin_cos_each([phi]);
        [-(phi_dot * phi_dot * sin_phi * self.m * self.l), S::from_f64(0.0)]
    }
    /// Generalised forces `T_q' F`, 2: joules per unit of each coordinate.
    ///
    /// Operations: 5 multiplications, 2 sine-cosine pairs.
    #[inline]
    pub fn generalized_forces(&self, t: S, q: &[S; 2], qd: &[S; 2]) -> [S; 2] {
        let [_, phi] = *q;
        let ([w, sin_phi], [_, _]) = S::sin_cos_each([S::from_f64(4.0) * t, phi]);
        [self.push.or(S::from_f64(3.0) * w), sin_phi * self.m * self.l * self.g]
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
    /// Operations: 3 additions, 14 multiplications, 1 sine-cosine pair.
    #[inline]
    pub fn kinetic_energy(&self, t: S, q: &[S; 2], qd: &[S; 2]) -> S {
        let [_, phi] = *q;
        let [x_dot, phi_dot] = *qd;
        let ([sin_phi], [cos_phi]) = S::sin_cos_each([phi]);
        let w = x_dot + phi_dot * self.l * cos_phi;
        let w_2 = S::from_f64(0.5) * self.m;
        x_dot * x_dot * S::from_f64(0.5) * self.M + w * w * w_2
            + phi_dot * phi_dot * sin_phi * sin_phi * self.l * self.l * w_2
    }
    /// Power of loads and drives, `F' v + lambda' C_t + T_t' (M x'' - F)`, in watts.
    ///
    /// Operations: 1 addition, 7 multiplications, 2 sine-cosine pairs.
    #[inline]
    pub fn power(
        &self,
        t: S,
        q: &[S; 2],
        qd: &[S; 2],
        qdd: &[S; 2],
        lambda: &[S; 0],
    ) -> S {
        let [_, phi] = *q;
        let [x_dot, phi_dot] = *qd;
        let ([w, sin_phi], [_, _]) = S::sin_cos_each([S::from_f64(4.0) * t, phi]);
        x_dot * self.push.or(S::from_f64(3.0) * w)
            + phi_dot * sin_phi * self.m * self.l * self.g
    }
    /// Outputs, 3, in SI units.
    ///
    /// Operations: 3 multiplications, 1 sine-cosine pair.
    #[inline]
    pub fn outputs(
        &self,
        t: S,
        q: &[S; 2],
        qd: &[S; 2],
        qdd: &[S; 2],
        lambda: &[S; 0],
    ) -> CartPoleOutputs<S> {
        let [x, phi] = *q;
        let [x_dot, _] = *qd;
        let ([w], [_]) = S::sin_cos_each([S::from_f64(4.0) * t]);
        [x, phi, x_dot * self.push.or(S::from_f64(3.0) * w)].into()
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
    ) -> CartPoleOutputRates<S> {
        let [x_dot, phi_dot] = *qd;
        [x_dot, phi_dot].into()
    }
    /// `left - right` of each event, 0, in SI units: zero when it happens.
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
    ) -> [S; 0] {
        []
    }
    /// The numbers of each shape of the drawing, in metres and radians.
    ///
    /// Operations: 1 addition, 2 multiplications, 1 sine-cosine pair.
    #[inline]
    pub fn drawing(&self, t: S, q: &[S; 2]) -> [S; 9] {
        let [x, phi] = *q;
        let ([sin_phi], [cos_phi]) = S::sin_cos_each([phi]);
        let P_x = x + self.l * sin_phi;
        let P_y = self.l * cos_phi;
        [x, S::from_f64(0.0), P_x, P_y, P_x, P_y, x, S::from_f64(0.0), S::from_f64(0.0)]
    }
    /// Declared start: values or guesses of the coordinates (2), and speeds (2), in SI units; 0 where nothing is declared.
    ///
    /// Operations: none.
    #[inline]
    pub fn initial(&self) -> sim_kernel::Initial<[S; 2]> {
        sim_kernel::Initial {
            positions: [S::from_f64(0.0), self.start],
            speeds: [S::from_f64(0.0), S::from_f64(0.0)],
        }
    }
    /// The inputs, 1, in SI units: what each is held at, or its declared course.
    ///
    /// Operations: 2 multiplications, 1 sine-cosine pair.
    #[inline]
    pub fn input_values(&self, t: S, q: &[S; 2]) -> [S; 1] {
        let ([w], [_]) = S::sin_cos_each([S::from_f64(4.0) * t]);
        [self.push.or(S::from_f64(3.0) * w)]
    }
    /// [`CartPolePrepared::dynamics`] once; for many calls with the same parameters [`Self::prepare`] first.
    #[inline]
    pub fn dynamics(
        &self,
        t: S,
        q: &[S; 2],
        qd: &[S; 2],
    ) -> sim_kernel::Dynamics<S, [S; 2], [S; 0]> {
        self.prepare().dynamics(t, q, qd)
    }
    /// [`CartPolePrepared::dynamics_jacobian`] once; for many calls with the same parameters [`Self::prepare`] first.
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
impl<S: sim_kernel::Scalar> CartPolePrepared<S> {
    /// Accelerations (2), multipliers (0) and power, from
    ///
    /// ```text
    /// [ T_q' M T_q   C_q' ] [ q''    ]   [ T_q' (F - M g)                      ]
    /// [ C_q          0    ] [ lambda ] = [ -(C_q q' + C_t)_q q' - (..)_t       ]
    /// ```
    ///
    /// by an elimination planned from the structure of the system. Where `refused` is set a pivot was too small and nothing else holds: solve that state from the other kernels.
    ///
    /// Operations: 5 additions, 16 multiplications, 1 division, 2 sine-cosine pairs.
    #[inline(always)]
    pub fn dynamics(
        &self,
        t: S,
        q: &[S; 2],
        qd: &[S; 2],
    ) -> sim_kernel::Dynamics<S, [S; 2], [S; 0]> {
        let [_, phi] = *q;
        let [x_dot, phi_dot] = *qd;
        let ([sin_phi, w], [cos_phi, _]) = S::sin_cos_each([phi, S::from_f64(4.0) * t]);
        let push = self.push.or(S::from_f64(3.0) * w);
        let rhs_x = push + self.k * phi_dot * phi_dot * sin_phi;
        let mass_phi_x = cos_phi * self.k;
        let l_phi_x = mass_phi_x * self.inverse_x;
        let pivot_phi = self.mass_phi_phi - mass_phi_x * l_phi_x;
        let phi_ddot = S::from_f64(1.0) / pivot_phi
            * (sin_phi * self.k_2 - rhs_x * l_phi_x);
        sim_kernel::Dynamics {
            accelerations: [rhs_x * self.inverse_x - l_phi_x * phi_ddot, phi_ddot],
            multipliers: [],
            power: push * x_dot + phi_dot * sin_phi * self.k_2,
            refused: sim_kernel::pivot_is_refused(self.mass_x_x, self.mass_x_x)
                | sim_kernel::pivot_is_refused(pivot_phi, self.mass_phi_phi),
        }
    }
    /// The derivatives of accelerations (2 rows) and multipliers (0 rows) with respect to coordinates and speeds (2 columns each): with the equations of motion as `K z = r`, the solutions of `K dz = dr - dK z`. Where `refused` is set a pivot was too small and nothing else holds.
    ///
    /// Operations: 10 additions, 29 multiplications, 1 division, 2 sine-cosine pairs.
    #[inline]
    pub fn dynamics_jacobian(
        &self,
        t: S,
        q: &[S; 2],
        qd: &[S; 2],
    ) -> sim_kernel::DynamicsJacobian<S, [[S; 2]; 2], [[S; 2]; 0]> {
        let [_, phi] = *q;
        let [_, phi_dot] = *qd;
        let ([sin_phi, w], [cos_phi, _]) = S::sin_cos_each([phi, S::from_f64(4.0) * t]);
        let phi_dot_squared = phi_dot * phi_dot;
        let rhs_x = self.push.or(S::from_f64(3.0) * w)
            + self.k * phi_dot_squared * sin_phi;
        let mass_phi_x = cos_phi * self.k;
        let l_phi_x = mass_phi_x * self.inverse_x;
        let pivot_phi = self.mass_phi_phi - mass_phi_x * l_phi_x;
        let inverse_phi = S::from_f64(1.0) / pivot_phi;
        let phi_ddot = inverse_phi * (sin_phi * self.k_2 - rhs_x * l_phi_x);
        let w_2 = self.k * (cos_phi * phi_dot_squared + sin_phi * phi_ddot);
        let w_3 = inverse_phi
            * (cos_phi * self.k_2
                + self.k * sin_phi * (rhs_x * self.inverse_x - l_phi_x * phi_ddot)
                - l_phi_x * w_2);
        let w_4 = phi_dot * sin_phi * self.k_3;
        let w_5 = inverse_phi * l_phi_x * w_4;
        sim_kernel::DynamicsJacobian {
            accelerations_by_positions: [
                [S::from_f64(0.0), self.inverse_x * w_2 - l_phi_x * w_3],
                [S::from_f64(0.0), w_3],
            ],
            accelerations_by_speeds: [
                [S::from_f64(0.0), self.inverse_x * w_4 + l_phi_x * w_5],
                [S::from_f64(0.0), -w_5],
            ],
            multipliers_by_positions: [],
            multipliers_by_speeds: [],
            refused: sim_kernel::pivot_is_refused(self.mass_x_x, self.mass_x_x)
                | sim_kernel::pivot_is_refused(pivot_phi, self.mass_phi_phi),
        }
    }
}
#[allow(non_snake_case, clippy::all, clippy::pedantic)]
impl<S: sim_kernel::Scalar> sim_kernel::Mechanism<S> for CartPole<S> {
    type Q = [S; 2];
    type L = [S; 0];
    type Z = [S; 2];
    type QQ = [[S; 2]; 2];
    type LQ = [[S; 2]; 0];
    type LL = [[S; 0]; 0];
    type ZZ = [[S; 2]; 2];
    type Entries = [S; 0];
    type Envelope = [S; 0];
    type Parameters = [S; 5];
    type Outputs = [S; 3];
    type OutputRates = [S; 2];
    type Events = [S; 0];
    type EventValues = [S; 0];
    type Activities = [S; 0];
    type Drawing = [S; 9];
    type QP = [[S; 5]; 2];
    type LP = [[S; 5]; 0];
    type Inputs = [sim_kernel::Input<S>; 1];
    type Prepared = CartPolePrepared<S>;
    type On<T: sim_kernel::Scalar> = CartPole<T>;
    const DESCRIPTION: sim_kernel::Description = sim_kernel::Description {
        name: "cart-pole",
        type_name: "CartPole",
        docs: "A cart on a rail with a pole that stands on it, pushed by a drive.",
        declaration: "/// A cart on a rail with a pole that stands on it, pushed by a drive.\npub CartPole;\n\ncoordinates {\n    /// Position of the cart.\n    x [m];\n    /// Angle of the pole from upright, to the right.\n    phi [rad];\n}\n\nparameters {\n    /// Mass of the cart.\n    M [kg] = 1;\n    /// Mass at the end of the pole.\n    m [kg] = 0.2;\n    /// Length of the pole.\n    l [m] = 0.5;\n    /// Angle of the pole at the start.\n    start [deg] = 170;\n    g [m/s^2] = 9.81;\n}\n\ninputs {\n    /// Force of the drive, to the right.\n    push [N] = 3 [N]*sin(4 [rad/s]*t);\n}\n\nlet O = [x, 0];\nlet P = O + l*[sin(phi), cos(phi)];\n\nbodies {\n    cart: mass M at O;\n    pole: mass m at P;\n}\n\nloads {\n    gravity [0, -g];\n    force push on x;\n}\n\ninitial { x = 0; phi = start; }\n\noutputs {\n    cart \"Position of the cart\" {\n        /// position\n        position [m] = x;\n    }\n    pole \"Angle of the pole\" {\n        /// from upright\n        angle [deg] = phi;\n    }\n    drive \"Power of the drive\" {\n        /// power\n        power [W] = push*dot(x);\n    }\n}\n\ndrawing {\n    line O, P;\n    point P;\n    slider O along 0;\n}\n",
        coordinates: &[
            sim_kernel::Coordinate {
                position: sim_kernel::Quantity {
                    name: "x",
                    unit: "m",
                    factor: 1f64,
                    is_length: true,
                    docs: "Position of the cart.",
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
                    name: "phi",
                    unit: "rad",
                    factor: 1f64,
                    is_length: false,
                    docs: "Angle of the pole from upright, to the right.",
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
                speed_given: false,
            },
        ],
        parameters: &[
            sim_kernel::Quantity {
                name: "M",
                unit: "kg",
                factor: 1f64,
                is_length: false,
                docs: "Mass of the cart.",
            },
            sim_kernel::Quantity {
                name: "m",
                unit: "kg",
                factor: 1f64,
                is_length: false,
                docs: "Mass at the end of the pole.",
            },
            sim_kernel::Quantity {
                name: "l",
                unit: "m",
                factor: 1f64,
                is_length: true,
                docs: "Length of the pole.",
            },
            sim_kernel::Quantity {
                name: "start",
                unit: "deg",
                factor: 0.017453292519943295f64,
                is_length: false,
                docs: "Angle of the pole at the start.",
            },
            sim_kernel::Quantity {
                name: "g",
                unit: "m/s^2",
                factor: 1f64,
                is_length: false,
                docs: "",
            },
        ],
        inputs: &[
            sim_kernel::Quantity {
                name: "push",
                unit: "N",
                factor: 1f64,
                is_length: false,
                docs: "Force of the drive, to the right.",
            },
        ],
        constraints: &[],
        speed_constraints: &[],
        norm_constraints: &[],
        sparsity: &[],
        conditionals: &[],
        events: &[],
        outputs: &[
            sim_kernel::Quantity {
                name: "position",
                unit: "m",
                factor: 1f64,
                is_length: true,
                docs: "position",
            },
            sim_kernel::Quantity {
                name: "angle",
                unit: "deg",
                factor: 0.017453292519943295f64,
                is_length: false,
                docs: "from upright",
            },
            sim_kernel::Quantity {
                name: "power",
                unit: "W",
                factor: 1f64,
                is_length: false,
                docs: "power",
            },
        ],
        rated_outputs: &[0, 1],
        figures: &[
            sim_kernel::Figure {
                name: "cart",
                title: "Position of the cart",
                len: 1,
            },
            sim_kernel::Figure {
                name: "pole",
                title: "Angle of the pole",
                len: 1,
            },
            sim_kernel::Figure {
                name: "drive",
                title: "Power of the drive",
                len: 1,
            },
        ],
        optional_kernels: &["dynamics_jacobian"],
        dimension: 2,
        drawing: &[
            sim_kernel::Shape::Line(2),
            sim_kernel::Shape::Points(1),
            sim_kernel::Shape::Slider,
        ],
    };
    fn defaults() -> Self {
        Self {
            M: S::from_f64(1f64),
            m: S::from_f64(0.2f64),
            l: S::from_f64(0.5f64),
            start: S::from_f64(2.96705972839036f64),
            g: S::from_f64(9.81f64),
            push: sim_kernel::Input::Declared,
        }
    }
    fn parameters(&self) -> [S; 5] {
        [self.M, self.m, self.l, self.start, self.g]
    }
    fn with_parameters(&self, parameters: [S; 5]) -> Self {
        Self {
            M: parameters[0],
            m: parameters[1],
            l: parameters[2],
            start: parameters[3],
            g: parameters[4],
            ..*self
        }
    }
    fn on<T: sim_kernel::Scalar>(
        &self,
        convert: impl ::core::ops::Fn(S) -> T,
    ) -> CartPole<T> {
        CartPole {
            M: convert(self.M),
            m: convert(self.m),
            l: convert(self.l),
            start: convert(self.start),
            g: convert(self.g),
            push: self.push.map(&convert),
        }
    }
    fn inputs(&self) -> [sim_kernel::Input<S>; 1] {
        [self.push]
    }
    fn with_inputs(&self, inputs: [sim_kernel::Input<S>; 1]) -> Self {
        Self { push: inputs[0], ..*self }
    }
    fn set_inputs(prepared: &mut Self::Prepared, inputs: [sim_kernel::Input<S>; 1]) {
        prepared.push = inputs[0];
    }
    #[inline(always)]
    fn prepare(&self) -> CartPolePrepared<S> {
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
        lambda: &[S; 0],
    ) -> [S; 0] {
        self.events(t, q, qd, qdd, lambda)
    }
    #[inline(always)]
    fn drawing(&self, t: S, q: &[S; 2]) -> [S; 9] {
        self.drawing(t, q)
    }
    #[inline(always)]
    fn initial(&self) -> sim_kernel::Initial<[S; 2]> {
        self.initial()
    }
    fn held_inputs(&self, t: S, q: &[S; 2]) -> Self::Inputs {
        self.input_values(t, q).map(sim_kernel::Input::Held)
    }
}
