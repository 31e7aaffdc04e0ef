//! Event conditions and their actions.

use super::{Activity, Equation};
use crate::dsl::{Expression, Region};
use syn::Ident;

/// `landing: y = r falling { impact floor; }`
pub struct Event {
    /// The condition.
    pub condition: Equation,
    /// The crossings of left - right that count; `None` for all.
    pub direction: Option<Direction>,
    /// Its actions.
    pub actions: Vec<Action>,
}

/// The direction of a zero crossing.
#[derive(Clone, Copy, PartialEq, Eq, Debug)]
pub enum Direction {
    /// `rising`
    Rising,
    /// `falling`
    Falling,
}

/// One line of what an event does.
pub enum Action {
    /// `record;`
    Record,
    /// `stop;` or `stop after 3;`
    Stop {
        /// At which of its occurrences.
        after: usize,
        /// Its place in the text.
        place: Region,
    },
    /// `set x = 0;` or `set dot(x) = -dot(x);`
    Set {
        /// A coordinate or a parameter.
        name: Ident,
        /// Whether the speed of the coordinate is meant.
        is_speed: bool,
        /// Its new value.
        value: Expression,
    },
    /// `swap q1, q2;`
    Swap(Ident, Ident),
    /// `activate contact;` or `release contact;`
    Switch {
        /// The constraint.
        constraint: Ident,
        /// Its new state.
        to: Activity,
    },
    /// `impact floor restitution e;`
    Impact {
        /// The constraint that is hit.
        constraint: Ident,
        /// The ratio of speeds after and before, 0 if it is not given.
        restitution: Option<Expression>,
    },
}
