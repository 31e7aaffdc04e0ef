//! The description of a mechanism: names, units, documentation, figures, drawing.

use crate::Table;
use crate::event::{Conditional, Event};

/// Everything about a mechanism that is known at build time.
#[derive(Debug)]
pub struct Description {
    /// The name on the command line: `quick-return`.
    pub name: &'static str,
    /// The type's name: `QuickReturn`.
    pub type_name: &'static str,
    /// Documentation.
    pub docs: &'static str,
    /// The text it was declared with, without comments.
    pub declaration: &'static str,
    /// FNV-1a, 128 bits, of its words, in 32 hexadecimal digits: the same for the same words however they are laid out, whether
    /// the macro, a build script or the command has read them.
    pub declaration_hash: &'static str,
    /// Generalised coordinates.
    pub coordinates: &'static [Coordinate],
    /// Whether some coordinates are lengths and some are not.
    pub mixes_lengths: bool,
    /// Parameters.
    pub parameters: &'static [Quantity],
    /// Inputs.
    pub inputs: &'static [Quantity],
    /// Constraint rows. The unit is that of the multiplier.
    pub constraints: &'static [Quantity],
    /// The constraint rows, by index, that hold between speeds alone: they do not correct positions.
    pub speed_constraints: &'static [usize],
    /// The constraint rows, by index, that keep the norm of a quaternion.
    pub norm_constraints: &'static [usize],
    /// The rows of C_q in the order of elimination, if C_q is so sparse that this pays off; none otherwise.
    pub sparsity: &'static [SparseRow],
    /// The column that parts of these rows have in common, if they fall into parts.
    pub common_column: Option<usize>,
    /// Constraints that events switch.
    pub conditionals: &'static [Conditional],
    /// Events.
    pub events: &'static [Event],
    /// Outputs.
    pub outputs: &'static [Quantity],
    /// The outputs, by index, whose rates are computed: all that depend on neither accelerations nor multipliers.
    pub rated_outputs: &'static [usize],
    /// Which outputs belong in one figure, in order.
    pub figures: &'static [Figure],
    /// Which of `dynamics_jacobian`, `dynamics_sensitivity`, `inverse_dynamics` and `speed_mass_matrix` are kernels of their
    /// own. The others come from other kernels, the derivatives by dual numbers; only the last has to be requested.
    pub optional_kernels: &'static [&'static str],
    /// 2 if its vectors are planar, 3 if they are spatial.
    pub dimension: usize,
    /// The drawing, in the order of the numbers of [`crate::Mechanism::drawing`].
    pub drawing: &'static [Shape],
    /// How it is run where nothing else is said, from its block `run`.
    pub run: &'static [RunDefault],
    /// The functions of time alone, in the order of [`crate::Mechanism::switching_functions`], where what acts on the mechanism
    /// changes its form or has the middle of a pulse: there the steps end that a method chooses.
    pub switching: &'static [Switching],
    /// The functions of positions and speeds, in the order of [`crate::Mechanism::load_conditions`], where loads change their form:
    /// a step in which they do so more than once may miss what is between. Then those of outputs, likewise for sweeps.
    pub load_conditions: &'static [Switching],
}

impl Description {
    /// Whether loads have conditions, and not only outputs.
    pub fn has_load_conditions(&self) -> bool {
        self.load_conditions.iter().any(|condition| condition.kind.is_of_loads())
    }
}

/// A function where expressions change their form: the condition of an `if`, or the argument of a table.
#[derive(Clone, Copy, Debug)]
pub struct Switching {
    /// The table whose rows count; if there is none, the function's zeros do.
    pub table: Option<&'static Table>,
    /// Whether it is of the first degree in time; where it is one of the state, in positions and speeds too.
    pub is_affine: bool,
    /// What is where it is zero.
    pub kind: SwitchingKind,
}

/// What is where a [`Switching`] is zero.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum SwitchingKind {
    /// Expressions change their form.
    Form,
    /// A load may be infinite.
    Pole,
    /// The middle of a smooth pulse or step, which a long step might not see; expressions keep their form.
    Middle,
    /// A flank of one.
    Flank,
    /// Nothing: it is what a sine, cosine or tangent in one of the others is of, in radians. Where that changes by much in a step, the
    /// other goes to and fro.
    Phase,
    /// An output changes its form, or has the middle of a pulse or a flank of one; what acts does not.
    Output,
}

impl SwitchingKind {
    /// Whether expressions keep their form there.
    pub fn is_smooth(self) -> bool {
        !matches!(self, SwitchingKind::Form | SwitchingKind::Pole)
    }

    /// Whether what acts on the mechanism is another there, or may be seen badly from afar.
    pub fn is_of_loads(self) -> bool {
        !matches!(self, SwitchingKind::Phase | SwitchingKind::Output)
    }
}

/// A setting of a run, as a program takes it on its command line.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct RunDefault {
    /// The option, without the dashes in front: `t-end`.
    pub option: &'static str,
    /// Its value: `30 ms`.
    pub value: &'static str,
}

/// A row of C_q by its entries that may be nonzero, and its place in C_q C_q': the factors fill only the envelope of
/// the lower triangle, which begins in each row at the first entry of C_q C_q' (George and Liu, Computer Solution of
/// Large Sparse Positive Definite Systems, 1981, chapter 4).
#[derive(Clone, Copy, Debug)]
pub struct SparseRow {
    /// The constraint.
    pub constraint: usize,
    /// The columns of its entries.
    pub columns: &'static [usize],
    /// The place of its first entry in [`Mechanism::Entries`](crate::Mechanism::Entries).
    pub entries: usize,
    /// The first row of its part, in the order of elimination, with which it has a column in common.
    pub first: usize,
    /// The first row of its part. Parts have [`Description::common_column`] alone in common.
    pub part: usize,
    /// The place of its diagonal entry in [`Mechanism::Envelope`](crate::Mechanism::Envelope).
    pub diagonal: usize,
}

/// A named quantity.
#[derive(Debug)]
pub struct Quantity {
    /// Its name.
    pub name: &'static str,
    /// The unit it is shown in.
    pub unit: &'static str,
    /// The size of that unit in SI units.
    pub factor: f64,
    /// Whether it is a length.
    pub is_length: bool,
    /// Documentation.
    pub docs: &'static str,
}

/// A generalised coordinate.
#[derive(Debug)]
pub struct Coordinate {
    /// The coordinate.
    pub position: Quantity,
    /// Its speed.
    pub speed: Quantity,
    /// Its acceleration.
    pub acceleration: Quantity,
    /// Its declared start.
    pub start: Start,
    /// Whether the declaration gives its starting speed.
    pub speed_given: bool,
}

/// The declared start of a coordinate.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Start {
    /// Its value.
    Given,
    /// A value near it.
    Guess,
    /// Nothing; assembly looks near 0.
    Free,
}

/// Consecutive outputs that share a figure.
#[derive(Debug)]
pub struct Figure {
    /// The name of its file.
    pub name: &'static str,
    /// Its title.
    pub title: &'static str,
    /// The number of outputs it shows.
    pub len: usize,
}

/// Something to draw; each takes its numbers, in metres and radians, from the drawing kernel. A point is (x, y) in the
/// plane, (x, y, z) in space.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Shape {
    /// A link through this many points, with a joint at each.
    Line(usize),
    /// A polyline through this many points.
    Curve(usize),
    /// A spring between two points.
    Spring,
    /// A damper between two points.
    Damper,
    /// A slider: its centre, and the angle of its guide in the plane, the direction of its guide in space.
    Slider,
    /// This many fixed supports.
    Ground(usize),
    /// This many marked points.
    Points(usize),
    /// This many points whose paths are drawn.
    Trace(usize),
    /// A circle: its centre and its radius, and in space the normal of its plane.
    Circle,
}

impl Shape {
    /// The number of its points.
    pub const fn points(self) -> usize {
        match self {
            Shape::Line(points) | Shape::Curve(points) | Shape::Ground(points) => points,
            Shape::Points(points) | Shape::Trace(points) => points,
            Shape::Spring | Shape::Damper => 2,
            Shape::Slider | Shape::Circle => 1,
        }
    }

    /// The number of its numbers in the plane (2) or in space (3).
    pub const fn numbers(self, dimension: usize) -> usize {
        let more = match self {
            Shape::Slider => {
                if dimension == 3 {
                    3
                } else {
                    1
                }
            }
            Shape::Circle => {
                if dimension == 3 {
                    4
                } else {
                    1
                }
            }
            _ => 0,
        };
        dimension * self.points() + more
    }
}
