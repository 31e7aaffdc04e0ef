//! What is told of a mechanism besides its kernels: names, units, documentation, starts, events, figures, drawing.
//!
//! The runtime's description of a mechanism has the same fields. Emission prints this one as a constant; a program that
//! reads declarations itself takes it as it is.

mod describe;
mod events;
mod kebab_case;

pub use crate::dynamics::SwitchingKind;
pub use crate::model::{RunDefault, Target};
pub use crate::program::SparseRow;
pub use describe::describe;
pub use kebab_case::kebab_case;

use crate::dsl::Source;

/// Everything about a mechanism that is known once it is derived, in the runtime's terms.
#[derive(Default)]
pub struct Description {
    /// The name on the command line: `quick-return`.
    pub name: String,
    /// The type's name: `QuickReturn`.
    pub type_name: String,
    /// Documentation.
    pub docs: String,
    /// The text it was declared with, and its hash.
    pub source: Source,
    /// Generalised coordinates.
    pub coordinates: Vec<Coordinate>,
    /// Whether some coordinates are lengths and some are not.
    pub mixes_lengths: bool,
    /// Parameters.
    pub parameters: Vec<Quantity>,
    /// Inputs.
    pub inputs: Vec<Quantity>,
    /// Constraint rows. The unit is that of the multiplier.
    pub constraints: Vec<Quantity>,
    /// The constraint rows, by index, that hold between speeds alone.
    pub speed_constraints: Vec<usize>,
    /// The constraint rows, by index, that keep the norm of a quaternion.
    pub norm_constraints: Vec<usize>,
    /// The rows of C_q in the order of elimination, if C_q is so sparse that this pays off.
    pub sparsity: Vec<SparseRow>,
    /// The column that parts of these rows have in common, if they fall into parts.
    pub common_column: Option<usize>,
    /// Constraints that events switch.
    pub conditionals: Vec<Conditional>,
    /// Events.
    pub events: Vec<Event>,
    /// Outputs.
    pub outputs: Vec<Quantity>,
    /// The outputs, by index, whose rates are computed.
    pub rated_outputs: Vec<usize>,
    /// Which outputs belong in one figure, in order.
    pub figures: Vec<Figure>,
    /// The names of those kernels that are made where a declaration asks for them.
    pub optional_kernels: Vec<&'static str>,
    /// 2 in the plane, 3 in space.
    pub dimension: usize,
    /// The drawing, in the order of its kernel's numbers.
    pub drawing: Vec<Shape>,
    /// How it is run where nothing else is said.
    pub run: Vec<RunDefault>,
    /// The functions of time alone where expressions change their form or have a pulse, in the order of their kernel.
    pub switching: Vec<Switching>,
    /// Those of positions and speeds where loads do, likewise.
    pub load_conditions: Vec<Switching>,
}

/// A function at whose zeros, or at the rows of a table, expressions change their form.
pub struct Switching {
    /// The table whose rows count; if there is none, its zeros do.
    pub table: Option<NamedTable>,
    /// Whether it is of the first degree in time; where it is one of the state, in positions and speeds too.
    pub is_affine: bool,
    /// What is there.
    pub kind: SwitchingKind,
}

/// A table.
pub struct NamedTable {
    /// Its index among all tables.
    pub index: usize,
    /// Its name.
    pub name: String,
}

/// A named quantity.
pub struct Quantity {
    /// Its name.
    pub name: String,
    /// The unit it is shown in.
    pub unit: String,
    /// The size of that unit in SI units.
    pub factor: f64,
    /// Whether it is a length.
    pub is_length: bool,
    /// Documentation.
    pub docs: String,
}

/// A generalised coordinate.
pub struct Coordinate {
    /// The coordinate.
    pub position: Quantity,
    /// Its speed.
    pub speed: Quantity,
    /// Its acceleration.
    pub acceleration: Quantity,
    /// How its start is declared.
    pub start: Start,
    /// Whether the declaration gives its starting speed.
    pub speed_given: bool,
}

/// How the start of a coordinate is declared.
#[derive(Clone, Copy, PartialEq, Eq, Debug)]
pub enum Start {
    /// Its value.
    Given,
    /// A value near it.
    Guess,
    /// Nothing.
    Free,
}

/// A constraint that events switch.
pub struct Conditional {
    /// Its name.
    pub name: String,
    /// The first of its rows.
    pub first_row: usize,
    /// The number of its rows.
    pub rows: usize,
    /// Whether it holds at the start.
    pub initially_active: bool,
}

/// A condition that becomes true at certain times.
pub struct Event {
    /// Its name.
    pub name: String,
    /// The crossings that count.
    pub direction: Direction,
    /// Whether the condition depends on coordinates, speeds, accelerations or multipliers; otherwise on time alone.
    pub on_motion: bool,
    /// Whether the condition depends on accelerations or multipliers.
    pub on_forces: bool,
    /// The actions, in order; those in one step happen at once.
    pub steps: Vec<Step>,
}

/// The direction in which left - right of an event crosses zero.
#[derive(Clone, Copy, PartialEq, Eq, Debug)]
pub enum Direction {
    /// Either way.
    Both,
    /// From below.
    Rising,
    /// From above.
    Falling,
}

/// A group of actions of an event. Values are numbered as the kernel of event values gives them, conditionals as they are
/// declared.
pub enum Step {
    /// The motion ends at this occurrence, from 1.
    Stop(usize),
    /// Each target is set to a value.
    Set(Vec<(Target, usize)>),
    /// Each conditional holds from now on, or no longer.
    Switch(Vec<(usize, bool)>),
    /// Each conditional is hit, with a coefficient of restitution among the values.
    Impact(Vec<(usize, usize)>),
}

/// Consecutive outputs that share a figure.
pub struct Figure {
    /// The name of its file.
    pub name: String,
    /// Its title.
    pub title: String,
    /// The number of outputs it shows.
    pub len: usize,
}

/// Something to draw, with the number of its points where that may vary.
#[derive(Clone, Copy, PartialEq, Eq, Debug)]
#[allow(missing_docs)]
pub enum Shape {
    Line(usize),
    Curve(usize),
    Spring,
    Damper,
    Slider,
    Ground(usize),
    Points(usize),
    Trace(usize),
    Circle,
}
