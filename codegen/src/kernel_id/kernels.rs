//! The table: an entry for each kernel.

use super::signature::{Arguments, Associated, Record, Signature, Type};
use Arguments::{Accelerations, GeneralizedSpeeds, Multipliers, Parameters, Positions, Speeds, Time};
use Type::Scalar;

/// `Kernel = signature, documentation;` for each: an enum, and what its kernels are.
macro_rules! kernels {
    ($($kernel:ident = $signature:expr, $documentation:literal;)*) => {
        /// A kernel.
        #[derive(Clone, Copy, PartialEq, Eq, PartialOrd, Ord, Hash, Debug)]
        pub enum KernelId {
            $(#[doc = $documentation] $kernel,)*
        }

        impl KernelId {
            /// All of them.
            pub const ALL: &'static [KernelId] = &[$(KernelId::$kernel),*];

            /// What it is, apart from what it computes.
            pub fn signature(self) -> &'static Signature {
                match self {
                    $(KernelId::$kernel => const { &Signature { documentation: $documentation, ..$signature } },)*
                }
            }
        }
    };
}

const Q: Type = Type::Associated(Associated::Q);
const L: Type = Type::Associated(Associated::L);
const QQ: Type = Type::Associated(Associated::QQ);
const VV: Type = Type::Associated(Associated::VV);
const LQ: Type = Type::Associated(Associated::LQ);
const QP: Type = Type::Associated(Associated::QP);
const LP: Type = Type::Associated(Associated::LP);
const U: Type = Type::Associated(Associated::U);
const R: Type = Type::Associated(Associated::R);
const ENTRIES: Type = Type::Associated(Associated::Entries);

const fn mechanism(name: &'static str, arguments: Arguments, result: Type) -> Signature {
    Signature::of_mechanism(name, arguments, result)
}

const fn prepared(name: &'static str, arguments: Arguments, result: Type) -> Signature {
    Signature::of_prepared(name, arguments, result)
}

const fn named(of: Associated) -> Type {
    Type::Associated(of)
}

const fn record(record: Record, arguments: &'static [Type]) -> Type {
    Type::Record(record, arguments)
}

kernels! {
    Prepare = mechanism("prepare", Parameters, named(Associated::Prepared)),
        "What the equations of motion need of the parameters, computed once for a set of parameters.";

    Dynamics = prepared("dynamics", Speeds, record(Record::Dynamics, &[Scalar, Q, L]))
        .called_with_prepared("prepared_dynamics"),
        "Accelerations ({n}), multipliers ({m}) and power, from\n\n```text\n\
         [ T_q' M T_q   C_q' ] [ q''    ]   [ T_q' (F - M g)                      ]\n\
         [ C_q          0    ] [ lambda ] = [ -(C_q q' + C_t)_q q' - (..)_t       ]\n```\n\n\
         by an elimination planned from the structure of the system{turned}. {refused}: solve that state from the other kernels.";

    DynamicsJacobian = prepared("dynamics_jacobian", Speeds, record(Record::DynamicsJacobian, &[Scalar, QQ, LQ]))
        .provided().optional(),
        "The derivatives of accelerations ({n} rows) and multipliers ({m} rows) with respect to coordinates and speeds \
         ({n} columns each): with the equations of motion as `K z = r`, the solutions of `K dz = dr - dK z`. {refused}.";

    DynamicsSensitivity = prepared("dynamics_sensitivity", Speeds, record(Record::DynamicsSensitivity, &[Scalar, QP, LP]))
        .provided().optional(),
        "The derivatives of accelerations ({n} rows) and multipliers ({m} rows) with respect to the parameters ({p} \
         columns): with the equations of motion as `K z = r`, the solutions of `K dz = dr - dK z`. {refused}.";

    InverseDynamics = prepared("inverse_dynamics", Accelerations, Q).provided().optional(),
        "Inverse dynamics `T_q' (M x'' - F)`, {n}: the forces along the coordinates that must be added for these accelerations \
         where there are no constraints, joules per unit of each coordinate.";

    Kinematics = prepared("kinematics", GeneralizedSpeeds, record(Record::Kinematics, &[Scalar, Q]))
        .in_speeds().called_with_prepared("prepared_kinematics"),
        "The kinematic differential equations `q' = N u + n`: speeds ({n}) of generalised speeds `u` ({k}), from `u = W q' + w` \
         and what they satisfy by construction. {refused}: no generalised speeds determine the speeds there.";

    SpeedDynamics = prepared("speed_dynamics", GeneralizedSpeeds, record(Record::SpeedDynamics, &[Scalar, U, R]))
        .in_speeds().called_with_prepared("prepared_speed_dynamics"),
        "The rates of the generalised speeds ({k}) and the multipliers of those constraints that they do not satisfy by \
         construction ({r}), from Kane's equations\n\n```text\n\
         [ N' M N  N' C_q' ] [ u'     ]   [ N' (Q - h - M c)                       ]\n\
         [ C_q N   0       ] [ lambda ] = [ -(C_q q' + C_t)_q q' - (..)_t - C_q c  ]\n```\n\n\
         with `M = T_q' M T_q`, `h = T_q' M g`, `Q = T_q' F`, and `c` the accelerations where `u' = 0`. {refused}.";

    MassMatrix = mechanism("mass_matrix", Positions, QQ),
        "Mass matrix `T_q' M T_q`, {n} x {n}, symmetric, in SI units.";

    SpeedMassMatrix = mechanism("speed_mass_matrix", Positions, VV).provided().optional(),
        "Mass matrix `N' M N` in speeds, {v} x {v}, symmetric, in SI units: in the generalised speeds `u` of `q' = N u + n`, or, \
         where none are declared, in `q'` with the velocities of free bodies. Those stand in the place of their coordinates: \
         the velocity of the origin, then the angular velocity, both in the body's own frame.";

    ConvectiveForces = mechanism("convective_forces", Speeds, Q),
        "Convective forces `T_q' M g`, {n}, with `g = (T_q q' + T_t)_q q' + (..)_t`: joules per unit of each coordinate.";

    GeneralizedForces = mechanism("generalized_forces", Speeds, Q),
        "Generalised forces `T_q' F`, {n}: joules per unit of each coordinate.";

    Constraints = mechanism("constraints", Positions, L),
        "Constraints `C`, {m}, in SI units; zero throughout the motion.";

    ConstraintMagnitudes = mechanism("constraint_magnitudes", Positions, L),
        "The sum of the magnitudes of the terms of `C`, {m}, in SI units: what its rounding is relative to.";

    ConstraintJacobian = mechanism("constraint_jacobian", Positions, LQ),
        "Constraint Jacobian `C_q`, {m} x {n}: units of each constraint per unit of each coordinate.";

    ConstraintTimeDerivative = mechanism("constraint_time_derivative", Positions, L),
        "`C_t`, {m}, units of `C` per second: the speeds obey `C_q q' + C_t = 0`.";

    ConstraintConvective = mechanism("constraint_convective", Speeds, L),
        "`(C_q q' + C_t)_q q' + (..)_t`, {m}, units of `C` per second squared: the part of `C''` without accelerations.";

    ConstraintLinearization =
        mechanism("constraint_linearization", Positions, record(Record::ConstraintLinearization, &[L, LQ])),
        "`C` ({m}), `C_q` ({m} x {n}) and `C_t` ({m}) together, in SI units, for projection.";

    SparseLinearization =
        mechanism("sparse_linearization", Positions, record(Record::ConstraintLinearization, &[L, ENTRIES])).provided(),
        "`C` ({m}), the {entries} entries of `C_q` that need not be 0, row after row in the order of elimination, and `C_t` \
         ({m}) together, in SI units, for projection.";

    KineticEnergy = mechanism("kinetic_energy", Speeds, Scalar),
        "Kinetic energy `v' M v / 2`, in joules.";

    Power = mechanism("power", Multipliers, Scalar),
        "Power of loads and drives, `F' v + lambda' C_t + T_t' (M x'' - F)`, in watts.";

    Outputs = mechanism("outputs", Multipliers, named(Associated::Outputs)),
        "Outputs, {len}, in SI units.";

    OutputRates = mechanism("output_rates", Accelerations, named(Associated::OutputRates)),
        "Rates of the outputs that depend on neither accelerations nor multipliers, {len}, in SI units per second.";

    Events = mechanism("events", Multipliers, named(Associated::Events)),
        "`left - right` of each event, {len}, in SI units: zero when it happens.";

    EventValues = mechanism("event_values", Speeds, named(Associated::EventValues)).provided(),
        "What the actions of events set, and the coefficients of restitution of impacts, {len}, in SI units, in the order of \
         declaration.";

    SwitchingFunctions = mechanism("switching_functions", Time, named(Associated::SwitchingFunctions)).provided(),
        "Functions of time alone, {len}, in SI units: where one is zero, or at a row of its table, expressions change their \
         form.";

    LoadConditions = mechanism("load_conditions", Speeds, named(Associated::LoadConditions)).provided(),
        "Conditions of loads on positions and speeds, {len}, in SI units: where one is zero, or at a row of its table, a load \
         changes its form.";

    Drawing = mechanism("drawing", Positions, named(Associated::Drawing)),
        "The numbers of each shape of the drawing, in metres and radians.";

    Initial = mechanism("initial", Parameters, record(Record::Initial, &[Q])),
        "Declared start: values or guesses of the coordinates ({n}), and speeds ({n}), in SI units; 0 where nothing is \
         declared.";

    GeneralizedSpeeds = mechanism("generalized_speeds", Speeds, U).in_speeds(),
        "The generalised speeds `u = W q' + w`, {len}, in SI units, in the order of declaration.";

    InputValues = mechanism("input_values", Positions, named(Associated::Inputs)).provided().called("held_inputs"),
        "The inputs, {len}, in SI units: what each is held at, or its declared course.";
}
