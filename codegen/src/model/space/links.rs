//! Links: the frames that bodies are fixed in, each with its place in the frame before, as a tree.
//!
//! They are found in what the declaration writes: the rotation of a body is a chain of steps, and its centre of mass is a sum
//! of vectors in the frames of that chain. The vectors in the frames before a link's own lead to its origin.

use super::frames::Step;
use super::triple::{Matrix, Triple, identity, zero};
use super::{Frames, Spatial, Turn};
use crate::model::bodies::TurnedBody;
use crate::model::interpreter::Interpreter;
use crate::model::{Body, Dependence};
use crate::symbolic::Graph;
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
    let moves = Dependence::COORDINATE.or(Dependence::TIME).or(Dependence::INPUT);
    let mut tree = Tree { frames, zero: zero(graph), links: vec![], known: FxHashMap::default() };
    for (at, (body, turned)) in bodies.iter().zip(turns).enumerate() {
        let (Some(Body { attitude: Some(_), .. }), Some((turn, place))) = (body, turned) else { continue };
        let nowhere = Spatial::world(tree.zero);
        let place_terms = place.as_ref().map_or(&nowhere, |(place, _)| place).terms();
        let chain = frames.chain(*turn);
        if place_terms.iter().any(|(frame, _)| *frame != Turn::NONE && !chain.contains(frame)) {
            continue;
        }
        let Some(link) = tree.link(*turn, place_terms) else { continue };
        let Some(_) = place else {
            tree.links[link].bodies.push(FixedBody { body: at, centre: None });
            continue;
        };
        let centre = tree.within(*turn, place_terms);
        match centre.iter().any(|x| dependences.of(graph, *x).meets(moves)) {
            true => tree.links.push(shifted(graph, link, centre, at)),
            false => tree.links[link].bodies.push(FixedBody { body: at, centre: Some(centre) }),
        }
    }
    tree.links
}

/// A link at a place that moves in the frame of another, for a body there.
fn shifted(graph: &mut Graph, before: usize, offset: Triple, body: usize) -> Link {
    let zero = zero(graph);
    Link {
        before: Some(before),
        offset,
        turn: identity(graph),
        spin: zero,
        spin_rate: zero,
        bodies: vec![FixedBody { body, centre: Some(zero) }],
    }
}

/// The vectors that lead to an origin, each with its frame.
type Way = Vec<(Turn, Triple)>;

struct Tree<'a> {
    frames: &'a Frames,
    zero: Triple,
    links: Vec<Link>,
    known: FxHashMap<(Turn, Way), usize>,
}

impl Tree<'_> {
    /// The link of a frame on the way to a place; none for the world.
    fn link(&mut self, turn: Turn, place: &[(Turn, Triple)]) -> Option<usize> {
        if turn == Turn::NONE {
            return None;
        }
        let before = self.frames.before(turn);
        let way = [Turn::NONE].into_iter().chain(self.frames.chain(before));
        let way: Way =
            way.map(|frame| (frame, self.within(frame, place))).filter(|(_, part)| *part != self.zero).collect();
        let key = (turn, way);
        if let Some(known) = self.known.get(&key) {
            return Some(*known);
        }
        let Step { matrix, spin, spin_rate, .. } = *self.frames.last_step(turn);
        let offset = self.within(before, place);
        let before = self.link(before, place);
        let link = Link { before, offset, turn: matrix, spin, spin_rate, bodies: vec![] };
        self.links.push(link);
        self.known.insert(key, self.links.len() - 1);
        Some(self.links.len() - 1)
    }

    fn within(&self, frame: Turn, place: &[(Turn, Triple)]) -> Triple {
        place.iter().find(|(own, _)| *own == frame).map_or(self.zero, |(_, part)| *part)
    }
}
