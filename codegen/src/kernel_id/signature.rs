//! What the functions of a kernel look like: the generated method, and the one of the runtime's trait that calls it.

/// A kernel, apart from what it computes.
pub struct Signature {
    /// The name of the generated method.
    pub name: &'static str,
    /// What it is a method of.
    pub receiver: Receiver,
    /// Its arguments, which the trait's method has too.
    pub arguments: Arguments,
    /// The trait's method.
    pub method: Method,
    /// What the trait's method returns. The generated one has a struct with named fields for outputs and their rates, and plain
    /// numbers for inputs.
    pub result: Type,
    /// Whether it is made only where the block `kernels` names it, or where small mechanisms can afford it.
    pub is_optional: bool,
    /// What it computes: formula, shape, units. Sizes stand in braces: `{n}` coordinates, `{m}` constraints, `{p}` parameters,
    /// `{k}` generalised speeds, `{v}` velocities, `{r}` constraints that these leave, `{len}` entries of the result.
    pub documentation: &'static str,
}

/// A method of one of the runtime's traits.
pub struct Method {
    /// The trait.
    pub of: Trait,
    /// Its name.
    pub name: &'static str,
    /// Whether it takes `&self` or `prepared: &Self::Prepared`.
    pub receiver: Receiver,
    /// Whether the trait has a body for it, so that mechanisms may go without.
    pub is_provided: bool,
}

/// The runtime's traits.
#[derive(Clone, Copy, PartialEq, Eq, Debug)]
pub enum Trait {
    /// `Mechanism`.
    Mechanism,
    /// `GeneralizedSpeeds`, of those that declare some.
    GeneralizedSpeeds,
}

/// What a kernel is a method of.
#[derive(Clone, Copy, PartialEq, Eq, Debug)]
pub enum Receiver {
    /// The mechanism, a struct of its parameters.
    Mechanism,
    /// What was computed from the parameters before.
    Prepared,
}

/// The arguments of a kernel.
#[derive(Clone, Copy, PartialEq, Eq, Debug)]
pub enum Arguments {
    /// Only the parameters.
    Parameters,
    /// t.
    Time,
    /// t, q.
    Positions,
    /// t, q, q'.
    Speeds,
    /// t, q, q', q''.
    Accelerations,
    /// t, q, q', q'', lambda.
    Multipliers,
    /// t, q, u.
    GeneralizedSpeeds,
}

/// One argument of a kernel.
#[derive(Clone, Copy, PartialEq, Eq, Debug)]
pub enum Argument {
    /// t.
    Time,
    /// q.
    Positions,
    /// q'.
    Speeds,
    /// q''.
    Accelerations,
    /// lambda.
    Multipliers,
    /// u.
    GeneralizedSpeeds,
}

impl Arguments {
    /// The arguments one by one.
    pub fn list(self) -> &'static [Argument] {
        use Argument::{Accelerations, GeneralizedSpeeds, Multipliers, Positions, Speeds, Time};
        match self {
            Arguments::Parameters => &[],
            Arguments::Time => &[Time],
            Arguments::Positions => &[Time, Positions],
            Arguments::Speeds => &[Time, Positions, Speeds],
            Arguments::Accelerations => &[Time, Positions, Speeds, Accelerations],
            Arguments::Multipliers => &[Time, Positions, Speeds, Accelerations, Multipliers],
            Arguments::GeneralizedSpeeds => &[Time, Positions, GeneralizedSpeeds],
        }
    }
}

impl Argument {
    /// What it is called in Rust.
    pub fn name(self) -> &'static str {
        match self {
            Argument::Time => "t",
            Argument::Positions => "q",
            Argument::Speeds => "qd",
            Argument::Accelerations => "qdd",
            Argument::Multipliers => "lambda",
            Argument::GeneralizedSpeeds => "u",
        }
    }

    /// The vector that is lent; none for the time, which is a scalar.
    pub fn vector(self) -> Option<Associated> {
        match self {
            Argument::Time => None,
            Argument::Positions | Argument::Speeds | Argument::Accelerations => Some(Associated::Q),
            Argument::Multipliers => Some(Associated::L),
            Argument::GeneralizedSpeeds => Some(Associated::U),
        }
    }
}

/// A type of the runtime's traits.
pub enum Type {
    /// `S`.
    Scalar,
    /// One that the mechanism says: `Self::Q`.
    Associated(Associated),
    /// A struct of the runtime with its arguments: `Initial<Self::Q>`.
    Record(Record, &'static [Type]),
}

macro_rules! associated_types {
    ($($(#[$about:meta])* $name:ident of $of:ident,)*) => {
        /// The types that a mechanism says, by their names in the traits.
        #[derive(Clone, Copy, PartialEq, Eq, Debug)]
        pub enum Associated {
            $($(#[$about])* $name,)*
        }

        impl Associated {
            /// All of them, in the order in which an impl has them.
            pub const ALL: &[Associated] = &[$(Associated::$name,)*];

            /// The trait that has it.
            pub fn of(self) -> Trait {
                match self {
                    $(Associated::$name => Trait::$of,)*
                }
            }
        }
    };
}

associated_types! {
    /// Coordinates, speeds or accelerations.
    Q of Mechanism,
    /// Constraints or multipliers.
    L of Mechanism,
    /// Both, one after the other.
    Z of Mechanism,
    /// A row for each coordinate, a column for each.
    QQ of Mechanism,
    /// Velocities of the mass matrix in speeds.
    V of Mechanism,
    /// A row for each velocity, a column for each.
    VV of Mechanism,
    /// A row for each constraint, a column for each coordinate.
    LQ of Mechanism,
    /// A row for each constraint, a column for each.
    LL of Mechanism,
    /// As `QQ`, for both.
    ZZ of Mechanism,
    /// The entries of C_q that need not be 0.
    Entries of Mechanism,
    /// The envelope of C_q C_q'.
    Envelope of Mechanism,
    /// Parameters.
    Parameters of Mechanism,
    /// Outputs.
    Outputs of Mechanism,
    /// Rates of the outputs that have one.
    OutputRates of Mechanism,
    /// Events.
    Events of Mechanism,
    /// What the actions of events need.
    EventValues of Mechanism,
    /// Functions of time alone where expressions change their form.
    SwitchingFunctions of Mechanism,
    /// Conditions of loads on positions and speeds.
    LoadConditions of Mechanism,
    /// Constraints that events switch.
    Activities of Mechanism,
    /// Numbers of the drawing.
    Drawing of Mechanism,
    /// A row for each coordinate, a column for each parameter.
    QP of Mechanism,
    /// A row for each constraint, a column for each parameter.
    LP of Mechanism,
    /// Inputs, each following its course or held.
    Inputs of Mechanism,
    /// What the equations of motion need of the parameters.
    Prepared of Mechanism,
    /// Generalised speeds.
    U of GeneralizedSpeeds,
    /// Multipliers of the constraints that generalised speeds leave.
    R of GeneralizedSpeeds,
}

/// The structs that kernels return.
#[derive(Clone, Copy, PartialEq, Eq, Debug)]
pub enum Record {
    /// The start.
    Initial,
    /// C, C_q and C_t.
    ConstraintLinearization,
    /// The solved equations of motion.
    Dynamics,
    /// Their derivatives with respect to the state.
    DynamicsJacobian,
    /// Their derivatives with respect to the parameters.
    DynamicsSensitivity,
    /// q' of generalised speeds.
    Kinematics,
    /// The equations of motion in generalised speeds, solved.
    SpeedDynamics,
    /// The mechanism's own: what `dynamics` needs of the parameters.
    Prepared,
}

impl Signature {
    /// A kernel of the mechanism, and the trait's method of its name.
    pub(super) const fn of_mechanism(name: &'static str, arguments: Arguments, result: Type) -> Signature {
        let method = Method { of: Trait::Mechanism, name, receiver: Receiver::Mechanism, is_provided: false };
        let receiver = Receiver::Mechanism;
        Signature { name, receiver, arguments, method, result, is_optional: false, documentation: "" }
    }

    /// A kernel of what is prepared. The trait's method of its name prepares for one call.
    pub(super) const fn of_prepared(name: &'static str, arguments: Arguments, result: Type) -> Signature {
        Signature { receiver: Receiver::Prepared, ..Signature::of_mechanism(name, arguments, result) }
    }

    /// Its method has a body in the trait.
    pub(super) const fn provided(self) -> Signature {
        Signature { method: Method { is_provided: true, ..self.method }, ..self }
    }

    /// It is made where the block `kernels` names it.
    pub(super) const fn optional(self) -> Signature {
        Signature { is_optional: true, ..self }
    }

    /// Its method is one of the trait of generalised speeds.
    pub(super) const fn in_speeds(self) -> Signature {
        Signature { method: Method { of: Trait::GeneralizedSpeeds, ..self.method }, ..self }
    }

    /// The method of the trait has another name.
    pub(super) const fn called(self, name: &'static str) -> Signature {
        Signature { method: Method { name, ..self.method }, ..self }
    }

    /// The method of the trait has another name, and takes what is prepared.
    pub(super) const fn called_with_prepared(self, name: &'static str) -> Signature {
        Signature { method: Method { name, receiver: Receiver::Prepared, ..self.method }, ..self }
    }
}
