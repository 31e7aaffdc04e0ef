//! Names of failures for programs.

use super::what::What;

impl What {
    /// A short name for programs, stable between versions: `E-SINGULAR-POSITION`. A failure while an event was being
    /// located has the code of its cause.
    pub fn code(&self) -> &'static str {
        match self {
            What::NotAssembled { .. } => "E-NOT-ASSEMBLED",
            What::SpeedsContradict { .. } => "E-SPEEDS-CONTRADICT",
            What::NotProjected { .. } => "E-NOT-PROJECTED",
            What::DependentConstraint { .. } => "E-DEPENDENT-CONSTRAINT",
            What::SingularPosition { .. } => "E-SINGULAR-POSITION",
            What::SingularStart { .. } => "E-SINGULAR-START",
            What::SingularState { .. } => "E-SINGULAR-STATE",
            What::NoEigenvalues { .. } => "E-NO-EIGENVALUES",
            What::Singular { .. } => "E-SINGULAR",
            What::NotDifferentiable { .. } => "E-NOT-DIFFERENTIABLE",
            What::SpeedsUndetermined => "E-SPEEDS-UNDETERMINED",
            What::GimbalLock { .. } => "E-GIMBAL-LOCK",
            What::NegativeMass { .. } => "E-NEGATIVE-MASS",
            What::ImpossibleInertia { .. } => "E-IMPOSSIBLE-INERTIA",
            What::NoEquilibrium { .. } => "E-NO-EQUILIBRIUM",
            What::SoftBesideRounding { .. } => "E-SOFT-BESIDE-ROUNDING",
            What::LimitPosition { .. } => "E-LIMIT-POSITION",
            What::DriveSingular { .. } => "E-DRIVE-SINGULAR",
            What::NotDriven { .. } => "E-NOT-DRIVEN",
            What::NotOfPositions { .. } => "E-NOT-OF-POSITIONS",
            What::MovedByTime { .. } => "E-MOVED-BY-TIME",
            What::NotHolonomic { .. } => "E-NOT-HOLONOMIC",
            What::NotAnInput { .. } => "E-NOT-AN-INPUT",
            What::NotFollowed { .. } => "E-NOT-FOLLOWED",
            What::TooManyRows { .. } => "E-TOO-MANY-ROWS",
            What::NoErrorEstimate => "E-NO-ERROR-ESTIMATE",
            What::StepTooSmall { .. } => "E-STEP-TOO-SMALL",
            What::Sticks => "E-STICKS",
            What::Driven { .. } => "E-DRIVEN",
            What::Jump { .. } => "E-JUMP",
            What::CornerInEqualStep { .. } => "E-CORNER",
            What::Kink { .. } => "E-KINK",
            What::NoConvergence => "E-NO-CONVERGENCE",
            What::Chattering { .. } => "E-CHATTERING",
            What::Accumulating { .. } => "E-ACCUMULATING",
            What::EventOpens { .. } => "E-EVENT-OPENS",
            What::ParametersOpen { .. } => "E-PARAMETERS-OPEN",
            What::Unusable { .. } => "E-UNUSABLE",
            What::Unknown { .. } => "E-UNKNOWN",
            What::Restitution { .. } => "E-RESTITUTION",
            What::InEvent { what, .. } => what.code(),
            What::Interrupted => "E-INTERRUPTED",
            What::NotFinite { .. } => "E-NOT-FINITE",
        }
    }
}
