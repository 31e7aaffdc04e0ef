//! Kinds of failures, with messages and codes.

use super::readable::readable;
use crate::numerics::eigen::NoEigenvalues;

/// The kind of failure.
#[derive(Clone, Debug, PartialEq, thiserror::Error)]
pub enum What {
    /// No configuration near the guesses satisfies the constraints.
    #[error(
        "the mechanism cannot be assembled: constraint `{constraint}` stays open by {residual:.3e}{others}. \
             The state shown is the closest one found. Give better guesses, free a given coordinate, or check the lengths"
    )]
    NotAssembled {
        /// The constraint with the largest residual.
        constraint: &'static str,
        /// That residual.
        residual: f64,
        /// The other constraints that stay open, with their residuals.
        others: String,
    },
    /// The given speeds contradict the constraints.
    #[error(
        "the given speeds contradict constraint `{constraint}`: it would open at a rate of {residual:.3e}. Give fewer speeds"
    )]
    SpeedsContradict {
        /// The constraint.
        constraint: &'static str,
        /// C_q q' + C_t.
        residual: f64,
    },
    /// The position projection did not reach its tolerance.
    #[error(
        "the constraints could not be met: `{constraint}` is open by {residual:.3e} after {iterations} corrections. \
             Take smaller steps; if that does not help the mechanism has reached a position that it cannot leave this way"
    )]
    NotProjected {
        /// The constraint with the largest residual.
        constraint: &'static str,
        /// That residual.
        residual: f64,
        /// Corrections made.
        iterations: usize,
    },
    /// Constraints are not independent here.
    #[error(
        "constraint `{constraint}` is not independent of the others here: it is redundant, or the mechanism is in a \
             singular position. Leave the constraint out if it says what others say already"
    )]
    DependentConstraint {
        /// The constraint.
        constraint: &'static str,
    },
    /// Constraints that are independent elsewhere depend on each other here.
    #[error(
        "the mechanism has reached a singular position: constraint `{constraint}` is not independent of the others here. It \
             comes to rest or turns back here, or more than one way leads on, and the equations do not say which. Change a length \
             or the start a little"
    )]
    SingularPosition {
        /// The constraint.
        constraint: &'static str,
    },
    /// The same at the start of a motion.
    #[error(
        "the mechanism cannot start in a singular position: constraint `{constraint}` is not independent of the others here, \
             though it is nearby. More than one motion may lead on, and the equations do not say which. Start beside it: change \
             a given coordinate or a guess a little"
    )]
    SingularStart {
        /// The constraint.
        constraint: &'static str,
    },
    /// The same where small motions, or reactions at rest, are requested.
    #[error(
        "the position is singular: constraint `{constraint}` is not independent of the others here, though it is nearby. Branches of \
             the motion cross here: small motions have no linear equations, and the reactions are not determined. Choose a state beside it"
    )]
    SingularState {
        /// The constraint.
        constraint: &'static str,
    },
    /// The linearised motion has no eigenvalues that could be found.
    #[error("the eigenvalues of the small motions about this state were not found: {why}")]
    NoEigenvalues {
        /// Why.
        why: NoEigenvalues,
    },
    /// The equations of motion do not determine the accelerations.
    #[error(
        "the equations of motion are singular: {unknown} is not determined. A coordinate needs a mass or inertia that it \
             moves, and constraints must be independent"
    )]
    Singular {
        /// The unknown that no equation determines: an acceleration or a reaction.
        unknown: String,
    },
    /// Generalised speeds do not determine the rates of the coordinates here.
    #[error(
        "the generalised speeds do not determine the speeds of the coordinates here. Declare others, or leave them out, \
             to integrate coordinates and their speeds"
    )]
    SpeedsUndetermined,
    /// What is asked for is found only of motions without this.
    #[error("this motion cannot be differentiated step by step: {why}")]
    NotDifferentiable {
        /// What stands in the way.
        why: &'static str,
    },
    /// The angles of an attitude do not determine its motion here.
    #[error(
        "gimbal lock: {angles} turn about the same axis here, and together they turn nothing, so their accelerations are not \
             determined. Write the attitude as a quaternion, which has no such position (`body: free, ..` does), or with a \
             sequence of axes whose middle angle stays away from it"
    )]
    GimbalLock {
        /// The angles.
        angles: String,
    },
    /// Some motion has no or negative kinetic energy.
    #[error(
        "the mass matrix is not positive: moving `{coordinate}` would have negative kinetic energy. Masses and inertias \
             must not be negative{suspects}"
    )]
    NegativeMass {
        /// The coordinate that moves most.
        coordinate: &'static str,
        /// Negative parameters, as a part of a sentence.
        suspects: String,
    },
    /// An impossible inertia tensor.
    #[error("the inertia of body `{body}` is impossible with these parameters: {why}")]
    ImpossibleInertia {
        /// The body.
        body: String,
        /// The reason.
        why: String,
    },
    /// No equilibrium was found.
    #[error(
        "no equilibrium was found: the nearest position still has an acceleration of {acceleration:.3e} along `{coordinate}`. \
             Start closer to one, or constrain what nothing holds"
    )]
    NoEquilibrium {
        /// The coordinate that accelerates most.
        coordinate: &'static str,
        /// Its acceleration, in SI units.
        acceleration: f64,
    },
    /// Rounding of stiff forces is more than what a soft one can balance.
    #[error("where `{coordinate}` rests is lost in rounding: what holds it is too soft beside the rest")]
    SoftBesideRounding {
        /// The coordinate that moves most in the soft direction.
        coordinate: &'static str,
    },
    /// A driven quantity, or one that is to be held elsewhere, cannot be moved further.
    #[error(
        "`{driven}` cannot go beyond {value}: the mechanism is in a limit position (dead point) there. End the range, or hold it, \
             before that, or drive another quantity through it"
    )]
    LimitPosition {
        /// The driven quantity.
        driven: &'static str,
        /// Where it has to turn back, with its unit.
        value: String,
    },
    /// The drive does not determine the motion.
    #[error(
        "driving `{driven}` does not determine the motion here: the mechanism is at a dead point, or branches of its motion \
             cross. Begin elsewhere, or drive another quantity"
    )]
    DriveSingular {
        /// The driven quantity.
        driven: &'static str,
    },
    /// A degree of freedom without a drive, or a drive without one.
    #[error(
        "each degree of freedom needs exactly one drive or hold: there are {freedoms} of them here, and {driven} quantities \
             driven or held. Hold what is free, or drive fewer"
    )]
    NotDriven {
        /// Degrees of freedom.
        freedoms: usize,
        /// Driven and held quantities.
        driven: usize,
    },
    /// An output that is no function of positions cannot be driven.
    #[error("output `{output}` depends on speeds, accelerations or reactions: drive a function of positions")]
    NotOfPositions {
        /// Its name.
        output: &'static str,
    },
    /// What may feel how fast something moves with t is not that of a mechanism at rest.
    #[error("{what} depends on t and on speeds: what moves with t may act on it even at rest. Give the drive a speed")]
    MovedByTime {
        /// The load or output.
        what: String,
    },
    /// Constraints between speeds do not determine positions along a drive.
    #[error(
        "constraint `{constraint}` holds between speeds: where the mechanism ends up depends on its path, so no sweep can follow it. \
             Use `run`, with a load that drives it"
    )]
    NotHolonomic {
        /// The constraint.
        constraint: &'static str,
    },
    /// A parameter that constraints depend on cannot be an input.
    #[error("constraints depend on `{parameter}`: it cannot be an input, since an input may jump and positions cannot")]
    NotAnInput {
        /// Its name.
        parameter: &'static str,
    },
    /// The branch of the motion could not be followed.
    #[error(
        "the motion could not be followed further while `{driven}` was driven: steps have become too small. A constraint may leave its \
             domain here, or several branches of the motion meet"
    )]
    NotFollowed {
        /// The driven quantity.
        driven: &'static str,
    },
    /// The samples would not fit in memory.
    #[error("{rows} rows do not fit in memory; record fewer")]
    TooManyRows {
        /// The rows asked for.
        rows: usize,
    },
    /// The method cannot choose its steps.
    #[error("this method does not estimate its error and cannot choose its steps: give the number of steps")]
    NoErrorEstimate,
    /// The tolerance cannot be met by any step.
    #[error(
        "the tolerance cannot be met: the step has shrunk to {step:.1e} s. Allow a larger tolerance, or use `--method radau5` \
             if the mechanism is stiff; at a jump of a load, or a kink of a constraint, no step is small enough"
    )]
    StepTooSmall {
        /// The step that was refused, in seconds.
        step: f64,
    },
    /// A load that jumps with a speed holds the motion at the jump.
    #[error(
        "a load that jumps with a speed drives it back to the jump from both sides, as dry friction `-F*sign(dot(x))` does that \
             sticks, and no step is small enough. Smooth it, as `friction F, smooth v0 on x` does, or let an event hold the body by a \
             constraint and let it go when the reaction exceeds F"
    )]
    Sticks,
    /// Nothing is at rest on a constraint that time moves.
    #[error(
        "constraint `{constraint}` moves with time, so nothing is at rest. `linearize --at initial` and `--at TIME` take a state \
             of the motion, such as a steady one"
    )]
    Driven {
        /// Its name.
        constraint: &'static str,
    },
    /// Time moves a constraint by a jump.
    #[error(
        "constraint `{constraint}` jumps by {by:.3e} here, in SI units, since what it says of time does: nothing moves so far in no \
             time. Let it change within some time, as by a table or `tanh`, or let an event set positions"
    )]
    Jump {
        /// Its name.
        constraint: &'static str,
        /// By how much.
        by: f64,
    },
    /// An equal step leads over a jump of speeds.
    #[error(
        "speeds jump at {} s, where what time drives has a corner, and equal steps do not see where: choose a tolerance \
             (`--rtol`), or a drive without corners",
        readable(*time, 9)
    )]
    CornerInEqualStep {
        /// The time of the corner, in seconds.
        time: f64,
    },
    /// A step is taken back by the projection onto the constraints, however short it is.
    #[error(
        "constraint `{constraint}` has a kink here, as `abs`, `min` and `max` have: speeds would jump, and no law says to what. \
             Write it smoothly, or let an event set the speeds"
    )]
    Kink {
        /// The constraint that such a step opens most.
        constraint: &'static str,
    },
    /// The implicit method's equations were not solved.
    #[error("the equations of an implicit step were not solved: Newton's method does not converge. Take smaller steps")]
    NoConvergence,
    /// An event happens without end.
    #[error(
        "event `{event}` chatters: it happened {count} times within one step. Its condition changes faster than the motion; \
             make it smooth"
    )]
    Chattering {
        /// Its name.
        event: &'static str,
        /// How often it happened.
        count: usize,
    },
    /// Events happen again and again, at times that accumulate.
    #[error(
        "event `{event}` chatters: its actions trigger it again at once, {count} times so far. The times of its \
             occurrences accumulate here, and the motion cannot continue. Stop the run (`stop`), hold what it \
             hits (`activate`), or change the condition"
    )]
    Accumulating {
        /// Its name.
        event: &'static str,
        /// How often it has happened.
        count: usize,
    },
    /// An event activates a constraint, or moves coordinates, where the constraint is open.
    #[error(
        "event `{event}` leaves constraint `{constraint}` open by {residual:.3e}: when a constraint is activated the positions \
             must satisfy it already, and so must coordinates that an event sets"
    )]
    EventOpens {
        /// The event.
        event: &'static str,
        /// The constraint.
        constraint: &'static str,
        /// C there.
        residual: f64,
    },
    /// Parameters set during the motion open a constraint.
    #[error(
        "with these parameters constraint `{constraint}` is open by {residual:.3e}, and the mechanism cannot be moved there on \
             this branch of its motion. Change them less, or start anew with them"
    )]
    ParametersOpen {
        /// The constraint with the largest residual.
        constraint: &'static str,
        /// That residual.
        residual: f64,
    },
    /// An invalid setting.
    #[error("{setting}")]
    Unusable {
        /// Which, why, and how to correct it.
        setting: String,
    },
    /// A name that the mechanism does not have.
    #[error("there is no {kind} `{name}`; there are: {known}")]
    Unknown {
        /// The kind of thing.
        kind: &'static str,
        /// Its name.
        name: String,
        /// All known ones.
        known: String,
    },
    /// An invalid coefficient of restitution.
    #[error(
        "event `{event}`: the coefficient of restitution with `{constraint}` is {coefficient}, and must be a number that is not \
             negative"
    )]
    Restitution {
        /// The event.
        event: &'static str,
        /// The constraint that is hit.
        constraint: &'static str,
        /// The coefficient.
        coefficient: f64,
    },
    /// Something failed while an event was being located.
    #[error("while event `{event}` was being located: {what}")]
    InEvent {
        /// The event.
        event: &'static str,
        /// The cause.
        what: Box<What>,
    },
    /// The run was interrupted.
    #[error("interrupted; what was computed until then is kept")]
    Interrupted,
    /// A number that is not finite.
    #[error(
        "{quantity} is not finite. A load or an expression leaves its domain (division by zero, root of a negative number), \
             or the step is too large"
    )]
    NotFinite {
        /// Which.
        quantity: String,
    },
}
