//! The parts of a model, in symbols and SI units.

use super::{Attitude, Direction, Point, Unit};
use crate::symbolic::{Expr, Symbol};

/// A generalised coordinate with its rates and its start.
pub struct Coordinate {
    /// Its name.
    pub name: String,
    /// Documentation.
    pub docs: String,
    /// The unit it is shown in.
    pub unit: Unit,
    /// q
    pub position: Symbol,
    /// q'
    pub speed: Symbol,
    /// q''
    pub acceleration: Symbol,
    /// Its start.
    pub start: Start,
    /// The speed it starts with, if that is given.
    pub start_speed: Option<Expr>,
}

/// The declared start of a coordinate.
#[derive(Clone, Copy, PartialEq, Eq, Debug)]
pub enum Start {
    /// Exactly here.
    Given(Expr),
    /// Near here.
    Guess(Expr),
    /// Nothing.
    Free,
}

/// A parameter: a symbol with a default.
pub struct Parameter {
    /// Its name.
    pub name: String,
    /// Documentation.
    pub docs: String,
    /// The unit it is shown and set in.
    pub unit: Unit,
    /// Its symbol.
    pub symbol: Symbol,
    /// Its default, a constant.
    pub default: Expr,
}

/// An input: a symbol that follows its declared course until it is set.
pub struct Input {
    /// Its name.
    pub name: String,
    /// Documentation.
    pub docs: String,
    /// The unit it is shown and set in.
    pub unit: Unit,
    /// Its symbol.
    pub symbol: Symbol,
    /// Its declared course, of numbers, parameters and time.
    pub course: Expr,
}

/// A body: a mass at a point, an inertia about an angle, or both.
pub struct Body {
    /// Its name.
    pub name: String,
    /// Mass and where its centre is.
    pub mass: Option<(Expr, Point)>,
    /// Moment of inertia, 0 if only the angle is declared, and the angle.
    pub rotation: Option<(Expr, Expr)>,
    /// Its rotation in space, in place of the angle.
    pub attitude: Option<Attitude>,
}

/// A force at a point.
pub struct Force {
    /// The force.
    pub force: Point,
    /// The point at which it acts.
    pub at: Point,
}

/// A load with the virtual work `force` times the variation of `along`: a torque about an angle, a spring along a
/// distance; of a potential V, -1 along V itself.
pub struct Effort {
    /// The generalised force.
    pub force: Expr,
    /// The scalar that it is conjugate to.
    pub along: Expr,
}

/// One constraint row, C = 0.
pub struct Constraint {
    /// Its name; `closure_x` for a row of a vector equation.
    pub name: String,
    /// Whether it holds between positions or speeds.
    pub level: Level,
    /// C = left - right; for a row between speeds w = left - right, linear in q'.
    pub value: Expr,
    /// The multiplier's symbol.
    pub multiplier: Symbol,
    /// The multiplier's unit, joules per unit of C or watts per unit of a row between speeds: `N` for a constraint between
    /// lengths, `N*m` for one between angles or other pure numbers. `1` where the constraint's own unit is not known.
    pub unit: Unit,
    /// 1 while it holds and 0 while it does not, if events switch it.
    pub activity: Option<Expr>,
}

/// A constraint that events switch.
pub struct Conditional {
    /// Its name.
    pub name: String,
    /// The name of its activity.
    pub field: String,
    /// Its activity, 1 or 0.
    pub symbol: Symbol,
    /// Its rows.
    pub rows: std::ops::Range<usize>,
    /// Whether it holds at the start.
    pub initially_active: bool,
}

/// A generalised speed u = W q' + w.
pub struct GeneralizedSpeed {
    /// Its name.
    pub name: String,
    /// Documentation.
    pub docs: String,
    /// The unit it is shown in.
    pub unit: Unit,
    /// W q' + w.
    pub value: Expr,
    /// u, where it is a variable of its own.
    pub symbol: Symbol,
}

/// Whether a constraint holds between positions or speeds.
#[derive(Clone, Copy, PartialEq, Eq, Debug)]
pub enum Level {
    /// Positions: C(q, t) = 0.
    Positions,
    /// Speeds: w(q, q', t) = 0, whether or not it could be integrated.
    Speeds,
}

/// A zero displacement, whose conjugate force is computed.
pub struct Auxiliary {
    /// Its name.
    pub name: String,
    /// s, where it is a variable.
    pub displacement: Symbol,
    /// s', where it is one.
    pub rate: Symbol,
    /// The symbol of the conjugate force in outputs.
    pub reaction: Symbol,
}

/// A condition that becomes true at certain times.
pub struct Event {
    /// Its name.
    pub name: String,
    /// left - right, zero when the event happens.
    pub value: Expr,
    /// The crossings that count; `None` for all.
    pub direction: Option<Direction>,
    /// Whether the condition depends on coordinates, speeds, accelerations or multipliers; otherwise on time alone.
    pub on_motion: bool,
    /// Whether the condition depends on accelerations or multipliers.
    pub on_forces: bool,
    /// The actions, in order.
    pub steps: Vec<EventStep>,
}

/// A group of actions of an event that happen at once.
pub enum EventStep {
    /// The motion ends at this occurrence, from 1.
    Stop(usize),
    /// Parameters and coordinates change.
    Set(Vec<(Target, Expr)>),
    /// Constraints, by index, hold from now on or no longer.
    Switch(Vec<(usize, bool)>),
    /// Constraints, by index, are hit, with coefficients of restitution.
    Impact(Vec<(usize, Expr)>),
}

/// The target of a `set`, by index.
#[derive(Clone, Copy, PartialEq, Eq, Debug)]
pub enum Target {
    /// A parameter.
    Parameter(usize),
    /// A coordinate.
    Position(usize),
    /// Its speed.
    Speed(usize),
}

/// A quantity to watch.
pub struct Output {
    /// Its name.
    pub name: String,
    /// Documentation.
    pub docs: String,
    /// The unit it is reported in.
    pub unit: Unit,
    /// Its value, in SI units.
    pub value: Expr,
}

/// Consecutive outputs that belong in one figure.
pub struct OutputGroup {
    /// Its name, for files.
    pub name: String,
    /// Its title.
    pub title: String,
    /// The number of its outputs.
    pub len: usize,
}

/// Something to draw.
pub enum Shape {
    /// Shapes drawn through or at points alone.
    Points(crate::dsl::Mark, Vec<Point>),
    /// A slider at a point, turned by an angle; in space, along a direction.
    Slider(Point, Point),
    /// A circle by centre and radius, and in space its normal.
    Circle(Point, Expr, Point),
}
