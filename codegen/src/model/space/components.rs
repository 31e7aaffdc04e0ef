//! Vectors of space in the frame that suits them.

use super::triple::Triple;
use super::{Spatial, Turn};
use crate::model::Dependence;
use crate::model::interpreter::Interpreter;

impl Interpreter {
    /// The components in the world's frame.
    pub(in crate::model) fn resolved(&mut self, v: &Spatial) -> Triple {
        self.frames.resolved(&mut self.graph, v)
    }

    /// A point and the frame in which its velocity is short: that of its body if rotations move it, and the world's if
    /// it moves there in several directions.
    pub(in crate::model) fn with_frame(&mut self, place: Spatial, turn: Turn) -> (Spatial, Turn) {
        let moves = Dependence::COORDINATE.or(Dependence::TIME);
        let own = place.terms().iter().filter(|(frame, _)| *frame == Turn::NONE).flat_map(|(_, u)| u);
        let moving = own.filter(|x| self.dependences.of(&self.graph, **x).meets(moves)).count();
        let frame = if moving > 1 { Turn::NONE } else { turn };
        (place, frame)
    }

    /// The components of two vectors in a common frame, the world's if there is no other.
    pub(in crate::model) fn in_common(&mut self, a: &Spatial, b: &Spatial) -> (Turn, Triple, Triple) {
        let turn = a.frame().filter(|frame| b.frame() == Some(*frame)).unwrap_or(Turn::NONE);
        let a = self.frames.resolved_in(&mut self.graph, a, turn);
        (turn, a, self.frames.resolved_in(&mut self.graph, b, turn))
    }
}
