//! Links: the frames that bodies are fixed in, each with its place in the frame before, as a tree.
//!
//! They are found in what the declaration writes: the rotation of a body is a chain of steps, and its centre of mass is a sum
//! of vectors in the frames of that chain. The vectors in the frames before a link's own lead to its origin. Those parts of them
//! that move are links of their own, which slide.

use super::frames::Step;
use super::triple::{Matrix, Triple, identity, zero};
use super::{Frames, Spatial, Turn};
use crate::model::bodies::TurnedBody;
use crate::model::interpreter::Interpreter;
use crate::model::{Body, Dependence, Dependences};
use crate::symbolic::{Expr, Graph, Node, Number};
use rustc_hash::FxHashMap;

/// A frame with its motion in the one before.
pub struct Link {
    /// The link before it, by index; none if that is the world.
    pub before: Option<usize>,
    /// r, its origin in the frame before.
    pub offset: Triple,
    /// S, from its own frame to the one before.
    pub turn: Matrix,
    /// vee(S' S'), the angular velocity of its frame in the one before, in its own.
    pub spin: Triple,
    /// The rate of these components.
    pub spin_rate: Triple,
    /// The components of the quaternion that turns it, the scalar part first, if they are coordinates.
    pub quaternion: Option<[Expr; 4]>,
    /// The bodies that are fixed in it.
    pub bodies: Vec<FixedBody>,
}

/// A body fixed in a link.
pub struct FixedBody {
    /// Which body.
    pub body: usize,
    /// Its centre of mass in the frame of the link, if it has a mass.
    pub centre: Option<Triple>,
}

/// The links of those bodies with attitudes whose centres of mass are given in the frames of their rotations; links come after
/// those before them.
pub(in crate::model) fn links(
    bodies: &[Option<Body>],
    turns: &[TurnedBody],
    interpreter: &mut Interpreter,
) -> Vec<Link> {
    if turns.iter().all(Option::is_none) {
        return vec![];
    }
    let Interpreter { graph, frames, dependences, .. } = interpreter;
    let zero = zero(graph);
    let mut tree = Tree { frames, graph, dependences, zero, links: vec![], known: FxHashMap::default() };
    for (at, (body, turned)) in bodies.iter().zip(turns).enumerate() {
        let (Some(Body { attitude: Some(_), .. }), Some((turn, place))) = (body, turned) else { continue };
        let nowhere = Spatial::world(tree.zero);
        let place_terms = place.as_ref().map_or(&nowhere, |(place, _)| place).terms();
        let chain = tree.frames.chain(*turn);
        if place_terms.iter().any(|(frame, _)| *frame != Turn::NONE && !chain.contains(frame)) {
            continue;
        }
        let Some(link) = tree.link(*turn, place_terms) else { continue };
        let Some(_) = place else {
            tree.links[link].bodies.push(FixedBody { body: at, centre: None });
            continue;
        };
        let (link, centre) = tree.slid(Some(link), tree.within(*turn, place_terms));
        if let Some(link) = link {
            tree.links[link].bodies.push(FixedBody { body: at, centre: Some(centre) });
        }
    }
    tree.links
}

struct Tree<'a> {
    frames: &'a Frames,
    graph: &'a mut Graph,
    dependences: &'a mut Dependences,
    zero: Triple,
    links: Vec<Link>,
    known: FxHashMap<(Option<usize>, Turn, Triple), usize>,
}

impl Tree<'_> {
    /// The link of a frame on the way to a place; none for the world.
    fn link(&mut self, turn: Turn, place: &[(Turn, Triple)]) -> Option<usize> {
        if turn == Turn::NONE {
            return None;
        }
        let before = self.frames.before(turn);
        let mut offset = self.within(before, place);
        let mut link = self.link(before, place);
        let quaternion = self.frames.last_quaternion(turn);
        // What a quaternion turns may move freely, and is one link then.
        if quaternion.is_none() {
            (link, offset) = self.slid(link, offset);
        }
        let Step { matrix, spin, spin_rate, .. } = *self.frames.last_step(turn);
        let bodies = vec![];
        Some(self.found(turn, Link { before: link, offset, turn: matrix, spin, spin_rate, quaternion, bodies }))
    }

    /// What slides in a link is a link of its own, if the moving part of a place in it says so; with the rest of that place.
    fn slid(&mut self, link: Option<usize>, place: Triple) -> (Option<usize>, Triple) {
        let (moving, rest) = self.parted(place);
        if moving == self.zero {
            return (link, place);
        }
        let (turn, zero) = (identity(self.graph), self.zero);
        let slid =
            Link { before: link, offset: moving, turn, spin: zero, spin_rate: zero, quaternion: None, bodies: vec![] };
        (Some(self.found(Turn::NONE, slid)), rest)
    }

    /// The same link as one that is known, or a new one.
    fn found(&mut self, turn: Turn, link: Link) -> usize {
        *self.known.entry((link.before, turn, link.offset)).or_insert_with(|| {
            self.links.push(link);
            self.links.len() - 1
        })
    }

    /// The terms of a vector that move, and those that are fixed.
    fn parted(&mut self, of: Triple) -> (Triple, Triple) {
        let moves = Dependence::COORDINATE.or(Dependence::TIME).or(Dependence::INPUT);
        let moving = of.map(|x| {
            let mut terms = match self.graph.node(x) {
                Node::Sum { terms, .. } => terms.to_vec(),
                _ => vec![(x, Number::ONE)],
            };
            terms.retain(|(term, _)| self.dependences.of(self.graph, *term).meets(moves));
            self.graph.linear_combination(&terms)
        });
        (moving, std::array::from_fn(|i| self.graph.sub(of[i], moving[i])))
    }

    fn within(&self, frame: Turn, place: &[(Turn, Triple)]) -> Triple {
        place.iter().find(|(own, _)| *own == frame).map_or(self.zero, |(_, part)| *part)
    }
}
