//! Spatial vectors: sums of triples in frames.

use super::triple::{self, Triple, add, apply};
use super::{Frames, Turn};
use crate::symbolic::{Expr, Graph};

/// A vector of space: triples, each in the frame of a rotation, no two in one frame.
#[derive(Clone)]
pub(in crate::model) struct Spatial(Vec<(Turn, Triple)>);

impl Spatial {
    /// By components in the world's frame.
    pub(in crate::model) fn world(components: Triple) -> Spatial {
        Spatial::within(Turn::NONE, components)
    }

    /// By components in a frame.
    pub(in crate::model) fn within(turn: Turn, components: Triple) -> Spatial {
        Spatial(vec![(turn, components)])
    }

    /// All components, each in the frame that it is written in.
    pub(in crate::model) fn written(&self) -> Vec<Expr> {
        self.0.iter().flat_map(|(_, triple)| *triple).collect()
    }

    pub(super) fn terms(&self) -> &[(Turn, Triple)] {
        &self.0
    }

    /// The single frame that it is written in.
    pub(in crate::model) fn frame(&self) -> Option<Turn> {
        match self.0.as_slice() {
            [(turn, _)] => Some(*turn),
            _ => None,
        }
    }

    /// The same linear operation on every component.
    pub(in crate::model) fn map(self, mut f: impl FnMut(Expr) -> Expr) -> Spatial {
        Spatial(self.0.into_iter().map(|(turn, triple)| (turn, triple.map(&mut f))).collect())
    }

    /// The sum, or the difference.
    pub(in crate::model) fn combine(
        &self,
        other: &Spatial,
        graph: &mut Graph,
        operation: fn(&mut Graph, Expr, Expr) -> Expr,
    ) -> Spatial {
        let zero = graph.zero();
        let mut terms = self.0.clone();
        for (turn, triple) in &other.0 {
            let place = terms.iter().position(|(own, _)| own == turn).unwrap_or_else(|| {
                terms.push((*turn, [zero; 3]));
                terms.len() - 1
            });
            let own = terms[place].1;
            terms[place].1 = std::array::from_fn(|k| operation(graph, own[k], triple[k]));
        }
        terms.retain(|(_, triple)| !triple::is_zero(graph, triple));
        if terms.is_empty() {
            terms.push((Turn::NONE, [zero; 3]));
        }
        Spatial(terms)
    }
}

impl Frames {
    /// R v.
    pub(in crate::model) fn turned(&mut self, graph: &mut Graph, turn: Turn, v: &Spatial) -> Spatial {
        let mut turned = Spatial::world(triple::zero(graph));
        for (own, triple) in v.terms() {
            let frame = self.product(graph, turn, *own);
            turned = turned.combine(&Spatial::within(frame, *triple), graph, Graph::add);
        }
        turned
    }

    /// Components in the world's frame.
    pub(in crate::model) fn resolved(&self, graph: &mut Graph, v: &Spatial) -> Triple {
        let mut sum = triple::zero(graph);
        for (turn, triple) in v.terms() {
            let part = apply(graph, self.matrix(*turn), triple);
            sum = add(graph, sum, part);
        }
        sum
    }

    /// Components in a frame.
    pub(in crate::model) fn resolved_in(&self, graph: &mut Graph, v: &Spatial, turn: Turn) -> Triple {
        self.carried(graph, v.terms(), turn)
    }

    /// The sum of triples in frames, in one frame: each carried along the chain only as far as necessary, and together
    /// with the others on the way.
    pub(super) fn carried(&self, graph: &mut Graph, terms: &[(Turn, Triple)], to: Turn) -> Triple {
        let chain: Vec<Turn> = std::iter::once(Turn::NONE).chain(self.chain(to)).collect();
        let mut at = vec![triple::zero(graph); chain.len()];
        for (turn, v) in terms {
            let (mut turn, mut v) = (*turn, *v);
            while !chain.contains(&turn) {
                v = self.step_out(graph, turn, &v);
                turn = self.before(turn);
            }
            let place = chain.iter().position(|frame| *frame == turn).unwrap_or(0);
            at[place] = add(graph, at[place], v);
        }
        let mut sum = at[0];
        for (turn, own) in chain.into_iter().zip(at).skip(1) {
            let carried = self.step_into(graph, turn, &sum);
            sum = add(graph, carried, own);
        }
        sum
    }
}
