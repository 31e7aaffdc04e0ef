//! What a mechanism says of itself: names, units, documentation, figures, drawing.

use crate::event::{Conditional, Event};

/// Everything about a mechanism that is known when it is built.
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
    /// Generalised coordinates.
    pub coordinates: &'static [Coordinate],
    /// Parameters.
    pub parameters: &'static [Quantity],
    /// Inputs.
    pub inputs: &'static [Quantity],
    /// Constraint rows. The unit is that of the multiplier.
    pub constraints: &'static [Quantity],
    /// Those constraint rows, by index, that hold between speeds alone: positions are not corrected by them.
    pub speed_constraints: &'static [usize],
    /// Constraints that events switch.
    pub conditionals: &'static [Conditional],
    /// Events.
    pub events: &'static [Event],
    /// Outputs.
    pub outputs: &'static [Quantity],
    /// Those outputs, by index, whose rates are computed: all that depend on neither accelerations nor multipliers.
    pub rated_outputs: &'static [usize],
    /// Which outputs belong in one figure, in order.
    pub figures: &'static [Figure],
    /// What to draw, in the order of the numbers of [`crate::Mechanism::drawing`].
    pub drawing: &'static [Shape],
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
    /// What the declaration says of its start.
    pub start: Start,
    /// Whether the declaration gives its starting speed.
    pub speed_given: bool,
}

/// What is known of where a coordinate starts.
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
    /// How many outputs it shows.
    pub len: usize,
}

/// Something to draw; each takes its numbers, in metres and radians, from the drawing kernel.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Shape {
    /// A polyline through this many points (x, y).
    Line(usize),
    /// A slider: its centre (x, y) and the angle of its guide.
    Slider,
    /// This many fixed supports (x, y).
    Ground(usize),
    /// This many marked points (x, y).
    Points(usize),
    /// A circle: its centre (x, y) and its radius.
    Circle,
}

impl Shape {
    /// How many numbers it takes.
    pub const fn len(self) -> usize {
        match self {
            Shape::Line(points) | Shape::Ground(points) | Shape::Points(points) => 2 * points,
            Shape::Slider | Shape::Circle => 3,
        }
    }

    /// Whether it takes none.
    pub const fn is_empty(self) -> bool {
        self.len() == 0
    }
}
