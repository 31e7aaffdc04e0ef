//! Rotations as chains of steps, interned.

use super::triple::{Matrix, Triple, add, apply, cross, identity, negate, product, transposed, zero};
use crate::symbolic::{Expr, Graph};
use rustc_hash::FxHashMap;

/// A rotation: an index into [`Frames`]. Equal chains are equal.
#[derive(Clone, Copy, PartialEq, Eq, Hash, Debug)]
pub(in crate::model) struct Turn(u32);

impl Turn {
    /// The identity: the world frame.
    pub(in crate::model) const NONE: Turn = Turn(0);
}

/// One factor of a rotation, with its angular velocity and acceleration in the frame that it turns to.
#[derive(Clone)]
pub(super) struct Step {
    pub(super) matrix: Matrix,
    pub(super) spin: Triple,
    pub(super) spin_rate: Triple,
    /// The components of its quaternion.
    pub(super) quaternion: Option<[Expr; 4]>,
}

/// A rotation as a whole.
struct Frame {
    before: Turn,
    /// The last step, and whether it is turned back.
    last: (usize, bool),
    depth: usize,
    step: Step,
    matrix: Matrix,
    spin: Triple,
    spin_rate: Triple,
}

/// All rotations of a declaration. Empty until there are vectors of space.
#[derive(Default)]
pub(in crate::model) struct Frames {
    frames: Vec<Frame>,
    steps: Vec<Step>,
    known: FxHashMap<(Turn, usize, bool), Turn>,
}

impl Frames {
    /// Creates the world frame, the root of all others.
    pub(in crate::model) fn begin(&mut self, graph: &mut Graph) {
        if !self.frames.is_empty() {
            return;
        }
        let (one, still) = (identity(graph), zero(graph));
        let step = Step { matrix: one, spin: still, spin_rate: still, quaternion: None };
        let world = Frame {
            before: Turn::NONE,
            last: (usize::MAX, false),
            depth: 0,
            step,
            matrix: one,
            spin: still,
            spin_rate: still,
        };
        self.frames.push(world);
    }

    fn frame(&self, turn: Turn) -> &Frame {
        &self.frames[turn.0 as usize]
    }

    /// R, whose columns are the axes of the frame in the world.
    pub(in crate::model) fn matrix(&self, turn: Turn) -> &Matrix {
        &self.frame(turn).matrix
    }

    /// vee(R' R'), the angular velocity in the frame itself.
    pub(in crate::model) fn spin(&self, turn: Turn) -> Triple {
        self.frame(turn).spin
    }

    /// Its rate, the angular acceleration in the frame itself.
    pub(in crate::model) fn spin_rate(&self, turn: Turn) -> Triple {
        self.frame(turn).spin_rate
    }

    /// The last step of a rotation: S, its angular velocity in the frame that it turns to, and the rate of that.
    pub(super) fn last_step(&self, turn: Turn) -> &Step {
        &self.frame(turn).step
    }

    /// The quaternion of the last step, if that turns forward and its components are coordinates.
    pub(super) fn last_quaternion(&self, turn: Turn) -> Option<[Expr; 4]> {
        let frame = self.frame(turn);
        frame.step.quaternion.filter(|_| !frame.last.1)
    }

    /// The rotation of one step.
    pub(super) fn single(&mut self, graph: &mut Graph, step: Step) -> Turn {
        self.begin(graph);
        if step.matrix == identity(graph) {
            return Turn::NONE;
        }
        let same = self.steps.iter().position(|other| other.matrix == step.matrix);
        let index = same.unwrap_or(self.steps.len());
        if same.is_none() {
            self.steps.push(step);
        }
        self.then(graph, Turn::NONE, index, false)
    }

    /// R S.
    pub(super) fn product(&mut self, graph: &mut Graph, first: Turn, second: Turn) -> Turn {
        self.chain(second).into_iter().fold(first, |turn, next| {
            let (index, back) = self.frame(next).last;
            self.then(graph, turn, index, back)
        })
    }

    /// R'.
    pub(super) fn inverse(&mut self, graph: &mut Graph, turn: Turn) -> Turn {
        self.chain(turn).into_iter().rev().fold(Turn::NONE, |inverse, next| {
            let (index, back) = self.frame(next).last;
            self.then(graph, inverse, index, !back)
        })
    }

    /// The frames on the way from the world to a frame, this one last, the world left out.
    pub(super) fn chain(&self, turn: Turn) -> Vec<Turn> {
        let mut chain = Vec::with_capacity(self.frame(turn).depth);
        let mut at = turn;
        while at != Turn::NONE {
            chain.push(at);
            at = self.frame(at).before;
        }
        chain.reverse();
        chain
    }

    /// The frame that another one is turned from.
    pub(super) fn before(&self, turn: Turn) -> Turn {
        self.frame(turn).before
    }

    /// Components in the frame before, in the frame itself.
    pub(super) fn step_into(&self, graph: &mut Graph, turn: Turn, v: &Triple) -> Triple {
        apply(graph, &transposed(&self.frame(turn).step.matrix), v)
    }

    /// Components in a frame, in the one before.
    pub(super) fn step_out(&self, graph: &mut Graph, turn: Turn, v: &Triple) -> Triple {
        apply(graph, &self.frame(turn).step.matrix, v)
    }

    /// The quaternions in a rotation.
    pub(in crate::model) fn quaternions(&self, turn: Turn) -> Vec<[Expr; 4]> {
        self.chain(turn).into_iter().filter_map(|at| self.frame(at).step.quaternion).collect()
    }

    /// One more step; a step and its own inverse cancel.
    fn then(&mut self, graph: &mut Graph, before: Turn, index: usize, back: bool) -> Turn {
        if self.frame(before).last == (index, !back) {
            return self.frame(before).before;
        }
        if let Some(known) = self.known.get(&(before, index, back)) {
            return *known;
        }
        let step = self.steps[index].clone();
        let step = if back { turned_back(graph, step) } else { step };
        let from = self.frame(before);
        let (matrix, spin, spin_rate, depth) = (from.matrix, from.spin, from.spin_rate, from.depth + 1);
        let into = transposed(&step.matrix);
        let carried = apply(graph, &into, &spin);
        // (S' w)' = S' w' + (S' w) x w_s
        let swept = cross(graph, &carried, &step.spin);
        let carried_rate = apply(graph, &into, &spin_rate);
        let relative = add(graph, swept, step.spin_rate);
        let frame = Frame {
            before,
            last: (index, back),
            depth,
            matrix: product(graph, &matrix, &step.matrix),
            spin: add(graph, carried, step.spin),
            spin_rate: add(graph, carried_rate, relative),
            step,
        };
        let turn = Turn(self.frames.len() as u32);
        self.frames.push(frame);
        self.known.insert((before, index, back), turn);
        turn
    }
}

/// R' has the angular velocity -R w in its own frame, and -R w' is its rate.
fn turned_back(graph: &mut Graph, step: Step) -> Step {
    let back = |graph: &mut Graph, v: &Triple| {
        let out = apply(graph, &step.matrix, v);
        negate(graph, out)
    };
    Step {
        spin: back(graph, &step.spin),
        spin_rate: back(graph, &step.spin_rate),
        matrix: transposed(&step.matrix),
        quaternion: step.quaternion,
    }
}
