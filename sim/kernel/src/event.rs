//! The description of a mechanism's events: conditions and actions.

/// A constraint that events switch.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct Conditional {
    /// Its name.
    pub name: &'static str,
    /// The first of its rows.
    pub first_row: usize,
    /// The number of its rows.
    pub rows: usize,
    /// Whether it holds at the start.
    pub initially_active: bool,
}

/// A condition that becomes true at certain times.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct Event {
    /// Its name.
    pub name: &'static str,
    /// The crossings of left - right that count.
    pub direction: Direction,
    /// Whether the condition depends on coordinates, speeds, accelerations or multipliers; otherwise on time alone.
    pub on_motion: bool,
    /// Whether the condition depends on accelerations or multipliers.
    pub on_forces: bool,
    /// The actions, in order; those in one step happen at once.
    pub steps: &'static [Step],
}

/// The direction in which left - right of an event crosses zero.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Direction {
    /// Either way.
    Both,
    /// From below.
    Rising,
    /// From above.
    Falling,
}

/// A group of actions of an event. Values are indices into [`crate::Mechanism::event_values`], conditionals indices
/// into [`crate::Description::conditionals`].
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Step {
    /// The motion ends at this occurrence, from 1.
    Stop(usize),
    /// Parameters, coordinates and speeds are set to values computed from the state before.
    Set(&'static [Assignment]),
    /// Constraints hold from now on, or no longer.
    Switch(&'static [Switch]),
    /// Constraints are hit.
    Impact(&'static [Hit]),
}

/// A value for a parameter, a coordinate or a speed.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct Assignment {
    /// The target.
    pub target: Target,
    /// Which value.
    pub value: usize,
}

/// The target of an event's `set`, by index.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Target {
    /// A parameter.
    Parameter(usize),
    /// A coordinate.
    Position(usize),
    /// The speed of a coordinate.
    Speed(usize),
}

/// A constraint that an event switches.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct Switch {
    /// Which.
    pub conditional: usize,
    /// Whether it holds from now on.
    pub active: bool,
}

/// A constraint that is hit.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct Hit {
    /// Which.
    pub conditional: usize,
    /// The index of its coefficient of restitution.
    pub restitution: usize,
}
