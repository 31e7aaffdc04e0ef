//! A link of a tree.

use super::mass_distribution::MassDistribution;
use crate::model::triple::{Matrix, Triple, identity, transposed};
use crate::symbolic::Graph;

/// A frame, its motion in the one before, and the mass in it.
pub struct Link {
    /// The link before it, by index; none if that is the world.
    pub before: Option<usize>,
    /// S, from its own frame to the one before.
    pub turn: Matrix,
    /// Its angular velocity in the frame before, in its own; and the rate of these components where q'' = 0.
    pub spin: [Triple; 2],
    /// Its origin in the frame before, r, with r'; and r'' where q'' = 0.
    pub offset: [Triple; 3],
    /// For each coordinate that moves it in the frame before: the derivatives of `spin` and r' by its speed.
    pub columns: Vec<(usize, [Triple; 2])>,
    /// The mass that moves with it, regrouped.
    pub mass: MassDistribution,
}

impl Link {
    /// Whether its turning leaves an axis of its frame at rest.
    pub(super) fn turns_about(&self, graph: &mut Graph, axis: usize) -> bool {
        let unit = identity(graph)[axis];
        self.turn[axis] == unit && transposed(&self.turn)[axis] == unit
    }
}
