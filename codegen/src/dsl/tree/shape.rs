//! Shapes that are drawn.

use crate::dsl::Expression;

/// One line of `drawing`.
pub enum Shape {
    /// `line O4, B, C;` and what else is drawn through or at points alone.
    Points {
        /// Its style.
        mark: Mark,
        /// Its points; a spring and a damper have two.
        points: Vec<Expression>,
    },
    /// `slider A along beta;`
    Slider {
        /// Its centre.
        at: Expression,
        /// The angle of its guide, in space its direction.
        along: Expression,
    },
    /// `circle O2 radius r;`
    Circle {
        /// Its centre.
        at: Expression,
        /// Its radius.
        radius: Expression,
        /// `normal n`, in space.
        normal: Option<Expression>,
    },
}

/// The style of a shape through or at points.
#[derive(Clone, Copy, PartialEq, Eq, Debug)]
pub enum Mark {
    /// `line`: a link with a joint at each point.
    Line,
    /// `curve`: a road, a wall, a guide.
    Curve,
    /// `spring`
    Spring,
    /// `damper`
    Damper,
    /// `ground`: a fixed support at each point.
    Ground,
    /// `point`: a mark at each point.
    Point,
    /// `trace`: the path of each point.
    Trace,
}
