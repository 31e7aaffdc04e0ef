/// A point mass on a rod without mass, let go from rest at its amplitude.
///
/// The fields are its parameters, in SI units; the methods are its kernels.
///
/// # Equations of motion
///
/// ```text
/// mass_matrix * accelerations = generalized_forces - convective_forces
/// coordinates = [phi]
/// [l^2*m] * [phi_ddot] = [-l*m*g*sin(phi)]
///
/// mass_matrix = [l^2*m]
///
/// convective_forces = [0]
///
/// generalized_forces = [-l*m*g*sin(phi)]
/// ```
#[allow(non_snake_case)]
#[derive(
    ::core::clone::Clone,
    ::core::marker::Copy,
    ::core::fmt::Debug,
    ::core::cmp::PartialEq
)]
pub struct Pendulum<S = ::core::primitive::f64> {
    /// Length of the rod, in `m`.
    pub l: S,
    /// Mass of the bob, in `kg`.
    pub m: S,
    /// In `m/s^2`.
    pub g: S,
    /// Where it is let go, in `1`.
    pub amplitude: S,
}
impl<S: sim_kernel::Scalar> ::core::default::Default for Pendulum<S> {
    /// The declared values.
    fn default() -> Self {
        <Self as sim_kernel::Compiled<S>>::defaults()
    }
}
/// Coordinates of [`Pendulum`] by name, in SI units; also for their speeds and accelerations.
#[allow(non_snake_case)]
#[derive(
    ::core::clone::Clone,
    ::core::marker::Copy,
    ::core::fmt::Debug,
    ::core::cmp::PartialEq
)]
pub struct PendulumCoordinates<S = ::core::primitive::f64> {
    /// Angle of the rod from the vertical, in `rad`.
    pub phi: S,
}
impl<S: sim_kernel::Scalar> ::core::convert::From<[S; 1]> for PendulumCoordinates<S> {
    fn from(values: [S; 1]) -> Self {
        Self { phi: values[0] }
    }
}
impl<S: sim_kernel::Scalar> ::core::convert::From<PendulumCoordinates<S>> for [S; 1] {
    fn from(record: PendulumCoordinates<S>) -> Self {
        [record.phi]
    }
}
/// Outputs of [`Pendulum`] by name, in SI units.
#[allow(non_snake_case)]
#[derive(
    ::core::clone::Clone,
    ::core::marker::Copy,
    ::core::fmt::Debug,
    ::core::cmp::PartialEq
)]
pub struct PendulumOutputs<S = ::core::primitive::f64> {
    /// angle of the rod, in `1`.
    pub angle: S,
    /// speed of the bob, in `m/s`.
    pub speed: S,
    /// force in the rod, positive in tension, in `N`.
    pub tension: S,
}
impl<S: sim_kernel::Scalar> ::core::convert::From<[S; 3]> for PendulumOutputs<S> {
    fn from(values: [S; 3]) -> Self {
        Self {
            angle: values[0],
            speed: values[1],
            tension: values[2],
        }
    }
}
impl<S: sim_kernel::Scalar> ::core::convert::From<PendulumOutputs<S>> for [S; 3] {
    fn from(record: PendulumOutputs<S>) -> Self {
        [record.angle, record.speed, record.tension]
    }
}
/// Rates of the outputs of [`Pendulum`] by name, in SI units.
#[allow(non_snake_case)]
#[derive(
    ::core::clone::Clone,
    ::core::marker::Copy,
    ::core::fmt::Debug,
    ::core::cmp::PartialEq
)]
pub struct PendulumOutputRates<S = ::core::primitive::f64> {
    /// Rate of `angle`.
    pub angle: S,
    /// Rate of `speed`.
    pub speed: S,
    /// Rate of `tension`.
    pub tension: S,
}
impl<S: sim_kernel::Scalar> ::core::convert::From<[S; 3]> for PendulumOutputRates<S> {
    fn from(values: [S; 3]) -> Self {
        Self {
            angle: values[0],
            speed: values[1],
            tension: values[2],
        }
    }
}
impl<S: sim_kernel::Scalar> ::core::convert::From<PendulumOutputRates<S>> for [S; 3] {
    fn from(record: PendulumOutputRates<S>) -> Self {
        [record.angle, record.speed, record.tension]
    }
}
/// What the equations of motion need of the parameters of [`Pendulum`], from [`Pendulum::prepare`]; its methods are the kernels of each step.
#[allow(non_snake_case)]
#[derive(
    ::core::clone::Clone,
    ::core::marker::Copy,
    ::core::fmt::Debug,
    ::core::cmp::PartialEq
)]
pub struct PendulumPrepared<S = ::core::primitive::f64> {
    mass_phi_phi: S,
    k: S,
    inverse_phi: S,
}
#[allow(non_snake_case, unused_variables, unused_parens, clippy::all, clippy::pedantic)]
impl<S: sim_kernel::Scalar> Pendulum<S> {
    /// What the equations of motion need of the parameters, computed once for a set of parameters.
    ///
    /// Operations: 4 multiplications, 1 division.
    #[inline]
    pub fn prepare(&self) -> PendulumPrepared<S> {
        let mass_phi_phi = self.l * self.l * self.m;
        PendulumPrepared {
            mass_phi_phi: mass_phi_phi,
            k: self.l * self.m * self.g,
            inverse_phi: S::from_f64(1.0) / mass_phi_phi,
        }
    }
    /// Mass matrix `T_q' M T_q`, 1 x 1, symmetric, in SI units.
    ///
    /// Operations: 2 multiplications.
    #[inline]
    pub fn mass_matrix(&self, t: S, q: &[S; 1]) -> [[S; 1]; 1] {
        [[self.l * self.l * self.m]]
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
    /// Operations: 1 addition, 3 multiplications, 1 sine-cosine pair.
    #[inline]
    pub fn generalized_forces(&self, t: S, q: &[S; 1], qd: &[S; 1]) -> [S; 1] {
        let [phi] = *q;
        let ([sin_phi], [_]) = S::sin_cos_each([phi]);
        [-(sin_phi * self.l * self.m * self.g)]
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
    /// Operations: 5 multiplications.
    #[inline]
    pub fn kinetic_energy(&self, t: S, q: &[S; 1], qd: &[S; 1]) -> S {
        let [phi_dot] = *qd;
        phi_dot * phi_dot * S::from_f64(0.5) * self.l * self.l * self.m
    }
    /// Power of loads and drives, `F' v + lambda' C_t + T_t' (M x'' - F)`, in watts.
    ///
    /// Operations: 1 addition, 4 multiplications, 1 sine-cosine pair.
    #[inline]
    pub fn power(
        &self,
        t: S,
        q: &[S; 1],
        qd: &[S; 1],
        qdd: &[S; 1],
        lambda: &[S; 0],
    ) -> S {
        let [phi] = *q;
        let [phi_dot] = *qd;
        let ([sin_phi], [_]) = S::sin_cos_each([phi]);
        -(phi_dot * sin_phi * self.l * self.m * self.g)
    }
    /// Outputs, 3, in SI units.
    ///
    /// Operations: 1 addition, 5 multiplications, 1 sine-cosine pair.
    #[inline]
    pub fn outputs(
        &self,
        t: S,
        q: &[S; 1],
        qd: &[S; 1],
        qdd: &[S; 1],
        lambda: &[S; 0],
    ) -> PendulumOutputs<S> {
        let [phi] = *q;
        let [phi_dot] = *qd;
        let ([_], [cos_phi]) = S::sin_cos_each([phi]);
        [phi, phi_dot * self.l, self.m * (self.l * phi_dot * phi_dot + self.g * cos_phi)]
            .into()
    }
    /// Rates of the outputs that depend on neither accelerations nor multipliers, 3, in SI units per second.
    ///
    /// Operations: 1 addition, 6 multiplications, 1 sine-cosine pair.
    #[inline]
    pub fn output_rates(
        &self,
        t: S,
        q: &[S; 1],
        qd: &[S; 1],
        qdd: &[S; 1],
    ) -> PendulumOutputRates<S> {
        let [phi] = *q;
        let [phi_dot] = *qd;
        let [phi_ddot] = *qdd;
        let ([sin_phi], [_]) = S::sin_cos_each([phi]);
        [
            phi_dot,
            phi_ddot * self.l,
            self.m * phi_dot * (phi_ddot * self.l * S::from_f64(2.0) - self.g * sin_phi),
        ]
            .into()
    }
    /// `left - right` of each event, 2, in SI units: zero when it happens.
    ///
    /// Operations: none.
    #[inline]
    pub fn events(
        &self,
        t: S,
        q: &[S; 1],
        qd: &[S; 1],
        qdd: &[S; 1],
        lambda: &[S; 0],
    ) -> [S; 2] {
        let [phi] = *q;
        let [phi_dot] = *qd;
        [phi, phi_dot]
    }
    /// The numbers of each shape of the drawing, in metres and radians.
    ///
    /// Operations: 1 addition, 3 multiplications, 1 sine-cosine pair.
    #[inline]
    pub fn drawing(&self, t: S, q: &[S; 1]) -> [S; 9] {
        let [phi] = *q;
        let ([sin_phi], [cos_phi]) = S::sin_cos_each([phi]);
        let P_x = self.l * sin_phi;
        let P_y = -(self.l * cos_phi);
        [
            S::from_f64(0.0),
            S::from_f64(0.0),
            S::from_f64(0.0),
            S::from_f64(0.0),
            P_x,
            P_y,
            P_x,
            P_y,
            self.l * S::from_f64(0.05),
        ]
    }
    /// Declared start: values or guesses of the coordinates (1), and speeds (1), in SI units; 0 where nothing is declared.
    ///
    /// Operations: none.
    #[inline]
    pub fn initial(&self) -> sim_kernel::Initial<[S; 1]> {
        sim_kernel::Initial {
            positions: [self.amplitude],
            speeds: [S::from_f64(0.0)],
        }
    }
    /// [`PendulumPrepared::dynamics`] once; for many calls with the same parameters [`Self::prepare`] first.
    #[inline]
    pub fn dynamics(
        &self,
        t: S,
        q: &[S; 1],
        qd: &[S; 1],
    ) -> sim_kernel::Dynamics<S, [S; 1], [S; 0]> {
        self.prepare().dynamics(t, q, qd)
    }
    /// [`PendulumPrepared::dynamics_jacobian`] once; for many calls with the same parameters [`Self::prepare`] first.
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
impl<S: sim_kernel::Scalar> PendulumPrepared<S> {
    /// Accelerations (1), multipliers (0) and power, from
    ///
    /// ```text
    /// [ T_q' M T_q   C_q' ] [ q''    ]   [ T_q' (F - M g)                      ]
    /// [ C_q          0    ] [ lambda ] = [ -(C_q q' + C_t)_q q' - (..)_t       ]
    /// ```
    ///
    /// by an elimination planned from the structure of the system. Where `refused` is set a pivot was too small and nothing else holds: solve that state from the other kernels.
    ///
    /// Operations: 2 additions, 4 multiplications, 1 sine-cosine pair.
    #[inline(always)]
    pub fn dynamics(
        &self,
        t: S,
        q: &[S; 1],
        qd: &[S; 1],
    ) -> sim_kernel::Dynamics<S, [S; 1], [S; 0]> {
        let [phi] = *q;
        let [phi_dot] = *qd;
        let ([sin_phi], [_]) = S::sin_cos_each([phi]);
        sim_kernel::Dynamics {
            accelerations: [-(sin_phi * self.k * self.inverse_phi)],
            multipliers: [],
            power: -(sin_phi * self.k * phi_dot),
            refused: sim_kernel::pivot_is_refused(self.mass_phi_phi, self.mass_phi_phi),
        }
    }
    /// The derivatives of accelerations (1 rows) and multipliers (0 rows) with respect to coordinates and speeds (1 columns each): with the equations of motion as `K z = r`, the solutions of `K dz = dr - dK z`. Where `refused` is set a pivot was too small and nothing else holds.
    ///
    /// Operations: 1 addition, 2 multiplications, 1 sine-cosine pair.
    #[inline]
    pub fn dynamics_jacobian(
        &self,
        t: S,
        q: &[S; 1],
        qd: &[S; 1],
    ) -> sim_kernel::DynamicsJacobian<S, [[S; 1]; 1], [[S; 1]; 0]> {
        let [phi] = *q;
        let ([_], [cos_phi]) = S::sin_cos_each([phi]);
        sim_kernel::DynamicsJacobian {
            accelerations_by_positions: [[-(self.inverse_phi * self.k * cos_phi)]],
            accelerations_by_speeds: [[S::from_f64(0.0)]],
            multipliers_by_positions: [],
            multipliers_by_speeds: [],
            refused: sim_kernel::pivot_is_refused(self.mass_phi_phi, self.mass_phi_phi),
        }
    }
}
#[allow(non_snake_case, unused_variables, clippy::all, clippy::pedantic)]
impl<S: sim_kernel::Scalar> sim_kernel::Mechanism<S> for Pendulum<S> {
    type Q = [S; 1];
    type L = [S; 0];
    type Z = [S; 1];
    type QQ = [[S; 1]; 1];
    type V = [S; 0];
    type VV = [[S; 0]; 0];
    type LQ = [[S; 1]; 0];
    type LL = [[S; 0]; 0];
    type ZZ = [[S; 1]; 1];
    type Entries = [S; 0];
    type Envelope = [S; 0];
    type Parameters = [S; 4];
    type Outputs = [S; 3];
    type OutputRates = [S; 3];
    type Events = [S; 2];
    type EventValues = [S; 0];
    type SwitchingFunctions = [S; 0];
    type LoadConditions = [S; 0];
    type Activities = [S; 0];
    type Drawing = [S; 9];
    type QP = [[S; 4]; 1];
    type LP = [[S; 4]; 0];
    type Inputs = [sim_kernel::Input<S>; 0];
    type Prepared = PendulumPrepared<S>;
    type On<T: sim_kernel::Scalar> = Pendulum<T>;
    #[inline(always)]
    fn description(&self) -> &'static sim_kernel::Description {
        const { &<Self as sim_kernel::Compiled<S>>::DESCRIPTION }
    }
    fn as_declared(&self) -> Self {
        <Self as sim_kernel::Compiled<S>>::defaults()
    }
    fn parameters(&self) -> [S; 4] {
        [self.l, self.m, self.g, self.amplitude]
    }
    fn with_parameters(&self, parameters: [S; 4]) -> Self {
        Self {
            l: parameters[0],
            m: parameters[1],
            g: parameters[2],
            amplitude: parameters[3],
            ..*self
        }
    }
    fn on<T: sim_kernel::Scalar>(
        &self,
        convert: impl ::core::ops::Fn(S) -> T,
    ) -> Pendulum<T> {
        Pendulum {
            l: convert(self.l),
            m: convert(self.m),
            g: convert(self.g),
            amplitude: convert(self.amplitude),
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
    fn prepare(&self) -> PendulumPrepared<S> {
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
    ) -> [S; 3] {
        self.outputs(t, q, qd, qdd, lambda).into()
    }
    #[inline(always)]
    fn output_rates(&self, t: S, q: &[S; 1], qd: &[S; 1], qdd: &[S; 1]) -> [S; 3] {
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
    fn drawing(&self, t: S, q: &[S; 1]) -> [S; 9] {
        self.drawing(t, q)
    }
    #[inline(always)]
    fn initial(&self) -> sim_kernel::Initial<[S; 1]> {
        self.initial()
    }
}
#[allow(clippy::all, clippy::pedantic)]
impl<S: sim_kernel::Scalar> sim_kernel::Compiled<S> for Pendulum<S> {
    const DESCRIPTION: sim_kernel::Description = sim_kernel::Description {
        name: "pendulum",
        type_name: "Pendulum",
        docs: "A point mass on a rod without mass, let go from rest at its amplitude.",
        declaration: "/// A point mass on a rod without mass, let go from rest at its amplitude.\npub Pendulum;\n\ncoordinates {\n    /// Angle of the rod from the vertical.\n    phi [rad];\n}\n\nparameters {\n    /// Length of the rod.\n    l [m] = 1;\n    /// Mass of the bob.\n    m [kg] = 1;\n    g [m/s^2] = 9.81;\n    /// Where it is let go.\n    amplitude [deg] = 90;\n}\n\nlet O = [0, 0];\nlet P = l*[sin(phi), -cos(phi)];\n\nbodies { bob: mass m at P; }\nloads { gravity [0, -g]; }\ninitial { phi = amplitude; }\n\nevents {\n    /// The bob passes its lowest point.\n    bottom: phi = 0;\n    /// The bob stands still.\n    rest: dot(phi) = 0;\n}\n\noutputs {\n    /// angle of the rod\n    angle [deg] = phi;\n    /// speed of the bob\n    speed [m/s] = l*dot(phi);\n    /// force in the rod, positive in tension\n    tension [N] = m*(l*dot(phi)^2 + g*cos(phi));\n}\n\ndrawing {\n    ground O;\n    line O, P;\n    circle P radius l/20;\n}\n",
        declaration_hash: "9df940c645f5acc94d477a4bcf2c3411",
        coordinates: &[
            sim_kernel::Coordinate {
                position: sim_kernel::Quantity {
                    name: "phi",
                    unit: "rad",
                    factor: 1f64,
                    is_length: false,
                    docs: "Angle of the rod from the vertical.",
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
        mixes_lengths: false,
        parameters: &[
            sim_kernel::Quantity {
                name: "l",
                unit: "m",
                factor: 1f64,
                is_length: true,
                docs: "Length of the rod.",
            },
            sim_kernel::Quantity {
                name: "m",
                unit: "kg",
                factor: 1f64,
                is_length: false,
                docs: "Mass of the bob.",
            },
            sim_kernel::Quantity {
                name: "g",
                unit: "m/s^2",
                factor: 1f64,
                is_length: false,
                docs: "",
            },
            sim_kernel::Quantity {
                name: "amplitude",
                unit: "deg",
                factor: 0.017453292519943295f64,
                is_length: false,
                docs: "Where it is let go.",
            },
        ],
        inputs: &[],
        constraints: &[],
        speed_constraints: &[],
        norm_constraints: &[],
        sparsity: &[],
        common_column: ::core::option::Option::None,
        conditionals: &[],
        events: &[
            sim_kernel::event::Event {
                name: "bottom",
                direction: sim_kernel::event::Direction::Both,
                on_motion: true,
                on_forces: false,
                steps: &[],
            },
            sim_kernel::event::Event {
                name: "rest",
                direction: sim_kernel::event::Direction::Both,
                on_motion: true,
                on_forces: false,
                steps: &[],
            },
        ],
        outputs: &[
            sim_kernel::Quantity {
                name: "angle",
                unit: "deg",
                factor: 0.017453292519943295f64,
                is_length: false,
                docs: "angle of the rod",
            },
            sim_kernel::Quantity {
                name: "speed",
                unit: "m/s",
                factor: 1f64,
                is_length: false,
                docs: "speed of the bob",
            },
            sim_kernel::Quantity {
                name: "tension",
                unit: "N",
                factor: 1f64,
                is_length: false,
                docs: "force in the rod, positive in tension",
            },
        ],
        rated_outputs: &[0, 1, 2],
        figures: &[
            sim_kernel::Figure {
                name: "angle",
                title: "angle of the rod",
                len: 1,
            },
            sim_kernel::Figure {
                name: "speed",
                title: "speed of the bob",
                len: 1,
            },
            sim_kernel::Figure {
                name: "tension",
                title: "force in the rod, positive in tension",
                len: 1,
            },
        ],
        optional_kernels: &["dynamics_jacobian"],
        dimension: 2,
        drawing: &[
            sim_kernel::Shape::Ground(1),
            sim_kernel::Shape::Line(2),
            sim_kernel::Shape::Circle,
        ],
        run: &[],
        switching: &[],
        load_conditions: &[],
    };
    fn defaults() -> Self {
        Self {
            l: S::from_f64(1f64),
            m: S::from_f64(1f64),
            g: S::from_f64(9.81f64),
            amplitude: S::from_f64(1.5707963267948966f64),
        }
    }
}
