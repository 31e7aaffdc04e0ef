//! Rotating bodies and loads in space, in symbols.

use crate::model::Point;
use crate::symbolic::Expr;

/// Three speeds that are linear in q', as components of a velocity or an angular velocity in some frame, with the
/// matching accelerations: their rates, plus the terms of a rotating frame.
#[derive(Clone, Copy)]
pub struct Rates {
    /// A q' + b.
    pub velocity: [Expr; 3],
    /// A q'' and the rest.
    pub acceleration: [Expr; 3],
    /// The angular velocity of the frame, in it.
    pub turning: [Expr; 3],
}

/// A symmetric 3 x 3 tensor.
#[derive(Clone, Copy)]
pub struct Tensor {
    /// xx, yy, zz.
    pub moments: [Expr; 3],
    /// yz, zx, xy.
    pub products: [Expr; 3],
}

impl Tensor {
    /// Entry (i, j).
    pub fn entry(&self, i: usize, j: usize) -> Expr {
        if i == j { self.moments[i] } else { self.products[3 - i - j] }
    }

    /// xx, yy, zz, yz, zx, xy.
    pub fn entries(&self) -> [Expr; 6] {
        let ([xx, yy, zz], [yz, zx, xy]) = (self.moments, self.products);
        [xx, yy, zz, yz, zx, xy]
    }
}

/// The rotation of a body in space.
pub struct Attitude {
    /// About its centre of mass, in its own frame.
    pub inertia: Tensor,
    /// R, from the body's frame to the world's.
    pub matrix: [[Expr; 3]; 3],
    /// Angular velocity and acceleration, in the body's frame.
    pub spin: Rates,
    /// Velocity and acceleration of its centre of mass, in the frame where they are shorter: the body's or the world's.
    pub centre: Option<Rates>,
    /// The action of gravity on its mass.
    pub fall: Option<Fall>,
}

/// Free fall, in the frame of a body's centre of mass.
#[derive(Clone, Copy)]
pub struct Fall {
    /// Its acceleration.
    pub gravity: [Expr; 3],
    /// The acceleration of the centre of mass less that of free fall.
    pub proper: [Expr; 3],
}

/// A force at a point of space, or a torque on a rotating body: its power is `effort` times the velocity.
pub struct Push {
    /// The force or torque.
    pub effort: [Expr; 3],
    /// The velocity that it acts along, in the same frame.
    pub along: Rates,
    /// The same without frames and velocities.
    pub in_world: Pushed,
}

/// A load in world components.
pub enum Pushed {
    /// A force at a point.
    Force {
        /// The force.
        force: Point,
        /// The point at which it acts.
        at: Point,
    },
    /// A torque on a body with an attitude.
    Torque {
        /// The moment.
        moment: Point,
        /// The body, by index.
        body: usize,
    },
}

/// A quaternion of coordinates. It has an inertia along its norm, without which the mass matrix would be singular. The
/// norm constraint keeps this inertia from affecting the motion.
pub struct Norm {
    /// q.q
    pub square: Expr,
    /// The inertia along it.
    pub inertia: Expr,
}
