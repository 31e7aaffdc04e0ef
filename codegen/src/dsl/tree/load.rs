//! Loads, and the laws of elements.

use crate::dsl::{Expression, Region};
use syn::Ident;

/// One line of `loads`.
pub enum Load {
    /// `force [F, 0] at C;`
    Force {
        /// The force vector.
        force: Expression,
        /// The point it acts at.
        point: Expression,
    },
    /// `torque T on crank2;`
    Torque {
        /// The moment, positive as the body's angle.
        moment: Expression,
        /// The body's name, or that of an angle.
        body: Ident,
    },
    /// `gravity [0, -9.81];`
    Gravity {
        /// The word `gravity`.
        keyword: Region,
        /// The acceleration of free fall.
        acceleration: Expression,
    },
    /// `potential V;`: the generalised force is -dV/dq.
    Potential(Expression),
    /// `dissipation R;`: the generalised force is -dR/dq'.
    Dissipation(Expression),
    /// `spring k, length l0 from A to B;` and its like.
    Element(Box<Element>),
}

/// A force along a scalar.
pub struct Element {
    /// The word it starts with.
    pub keyword: Region,
    /// Its law.
    pub law: Law,
    /// Its extent.
    pub extent: Extent,
}

/// The force or torque of an element along its extent.
pub enum Law {
    /// `force F ..`, positive where it lets the extent grow.
    Force(Expression),
    /// `spring k, length l0 ..` or `spring k, rest l0 ..`: a stiffness, or the force where `stretch` or `rate` stands in it.
    Spring(Expression, Expression),
    /// `friction F, smooth v0 ..`: dry friction, F tanh(x'/v0).
    Friction(Expression, Expression),
    /// `damper c ..`: a coefficient, or the force where `rate` stands in it.
    Damper(Expression),
}

/// The extent of an element.
pub enum Extent {
    /// `from A to B`: the distance of two points.
    Distance(Expression, Expression),
    /// `between alpha and beta`: beta - alpha.
    Difference(Expression, Expression),
    /// `on x`: a scalar.
    Quantity(Expression),
}
