//! Forward dynamics of an open tree, from its tips to the world and back: between composite bodies and articulated ones.
//!
//! In the frame of a link the accelerations that the joints beyond it add, q'', and those of the frame itself, A, are unknown,
//!
//! ```text
//! [ M   F' ] [ q'' ]   [ Q - h ]
//! [ F   K  ] [ A   ] = [ ...   ]
//! ```
//!
//! with h the forces where all q'' = 0, from Newton's and Euler's recursion, and F the momenta of the joints. Composite bodies
//! carry M, F and K down to the world, and there all is eliminated. Articulated bodies (Featherstone, Rigid Body Dynamics
//! Algorithms, 2008, chapter 7) eliminate q'' at every joint, which leaves K - F M^-1 F' and the wrench F M^-1 (Q - h) to carry
//! on: linear in the number of joints, where composite bodies take fewer operations as long as few joints follow each other.

use super::inertia::Inertia;
use super::newton_euler::{Motion, total};
use super::tree::{Column, LinkTree, LinkValues};
use super::triple::{Triple, add, apply, cross, difference, dot, product, sum, transposed, zero};
use crate::program::notes::Notes;
use crate::program::values::{Value, Values};
use rustc_hash::FxHashMap;
use std::collections::VecDeque;

/// When joints are eliminated.
#[derive(Clone, Copy, PartialEq, Eq)]
pub(in crate::program) enum Joints {
    /// All in the world, from composite bodies.
    Together,
    /// Each at its link, which leaves articulated bodies.
    OneByOne,
}

/// What acts along the unknowns beside links, each with an entry for every one.
pub(super) struct Beside {
    /// Q - h.
    pub(super) forces: Vec<Value>,
    /// The inertia along it.
    pub(super) inertias: Vec<Value>,
}

/// The accelerations along the coordinates, and the pivots with the scale of each.
pub(super) struct Forward {
    pub(super) accelerations: Vec<Value>,
    pub(super) pivots: Vec<(Value, Value)>,
}

/// A joint that waits for its elimination.
struct Waiting {
    unknown: usize,
    /// Its row of F.
    momentum: [Triple; 2],
    /// The scale of its pivot.
    size: Value,
}

/// A link with what follows it: its inertia and its wrench, and the joints that wait.
struct Branch {
    inertia: Inertia,
    moments: Vec<Triple>,
    forces: Vec<Triple>,
    waiting: VecDeque<Waiting>,
}

/// An eliminated joint: the reciprocal of its pivot, and the shares of those that wait longer and of the frame.
struct Step {
    link: usize,
    unknown: usize,
    inverse: Value,
    shares: Vec<(usize, Value)>,
    of_frame: [Triple; 2],
}

/// The elimination on its way.
struct Elimination<'a> {
    names: &'a [String],
    notes: &'a mut Notes,
    /// M of joints that wait, the larger unknown first.
    entries: FxHashMap<(usize, usize), Value>,
    right_hand_side: Vec<Value>,
    steps: Vec<Step>,
    pivots: Vec<(Value, Value)>,
}

impl LinkTree {
    /// Solves for the accelerations.
    pub(super) fn forward(
        &self,
        values: &mut Values,
        beside: Beside,
        joints: Joints,
        (names, notes): (&[String], &mut Notes),
    ) -> Forward {
        let composites = self.composites(values);
        let mut branches = self.branches(values);
        let (entries, right_hand_side) = (FxHashMap::default(), beside.forces);
        let mut elimination = Elimination { names, notes, entries, right_hand_side, steps: vec![], pivots: vec![] };
        while let Some(mut branch) = branches.pop() {
            let at = branches.len();
            let link = &self.links[at];
            for column in &link.columns {
                let [moment, force] = link.momentum(values, &composites[at], column);
                let size = link.along(values, column, &[moment, force]);
                elimination.enter(values, link, &mut branch, column, (beside.inertias[column.coordinate], size));
            }
            if link.before.is_none() || joints == Joints::OneByOne {
                elimination.eliminate(values, &mut branch, at, link.before.is_some());
            }
            if let Some(before) = link.before {
                branches[before].receive(values, link, branch);
            }
        }
        let Elimination { right_hand_side, steps, pivots, .. } = elimination;
        Forward { accelerations: self.back(values, &steps, right_hand_side), pivots }
    }

    /// The links without what follows them, where all q'' = 0.
    fn branches(&self, values: &mut Values) -> Vec<Branch> {
        let motions = self.motions(values, None);
        let branch = |(link, motion): (&LinkValues, &Motion)| {
            let [moment, force] = link.mass.wrench(values, motion);
            let inertia = Inertia::Rigid(link.mass.clone());
            Branch { inertia, moments: vec![moment], forces: vec![force], waiting: VecDeque::new() }
        };
        self.links.iter().zip(&motions).map(branch).collect()
    }

    /// The unknowns from the world to the tips.
    fn back(&self, values: &mut Values, steps: &[Step], right_hand_side: Vec<Value>) -> Vec<Value> {
        let mut solved = right_hand_side;
        let mut frames = Frames { tree: self, carried: vec![None; self.links.len()] };
        for Step { link, unknown, inverse, shares, of_frame } in steps.iter().rev() {
            let first = product(values, solved[*unknown], *inverse);
            let mut terms = vec![first];
            for (other, share) in shares {
                let product = product(values, *share, solved[*other]);
                terms.push(values.negate(product));
            }
            let [turning, shifting] = frames.carried(values, *link, &solved);
            let of_frame = [dot(values, &of_frame[0], &turning), dot(values, &of_frame[1], &shifting)];
            terms.extend(of_frame.map(|term| values.negate(term)));
            solved[*unknown] = sum(values, &terms);
        }
        solved
    }
}

impl Branch {
    fn wrench(&mut self, values: &mut Values) -> [Triple; 2] {
        let wrench = [total(values, &self.moments), total(values, &self.forces)];
        (self.moments, self.forces) = (vec![wrench[0]], vec![wrench[1]]);
        wrench
    }

    /// Takes over what follows, about the origin of this link.
    fn receive(&mut self, values: &mut Values, link: &LinkValues, mut outer: Branch) {
        let wrench = outer.wrench(values);
        let [moment, force] = link.wrench_before(values, &wrench);
        self.moments.push(moment);
        self.forces.push(force);
        for mut joint in outer.waiting {
            joint.momentum = link.wrench_before(values, &joint.momentum);
            self.waiting.push_back(joint);
        }
        let seen = outer.inertia.seen_from_before(values, link);
        self.inertia = std::mem::replace(&mut self.inertia, seen.clone()).add(values, &seen);
    }
}

impl Elimination<'_> {
    /// A joint of a link, with the inertia along it beside the link's and the scale of its pivot.
    fn enter(
        &mut self,
        values: &mut Values,
        link: &LinkValues,
        branch: &mut Branch,
        column: &Column,
        (beside, size): (Value, Value),
    ) {
        let unknown = column.coordinate;
        let wrench = branch.wrench(values);
        let needed = link.along(values, column, &wrench);
        self.right_hand_side[unknown] = difference(values, self.right_hand_side[unknown], needed);
        for joint in &branch.waiting {
            let entry = link.along(values, column, &joint.momentum);
            self.set(unknown, joint.unknown, entry);
        }
        let momentum = branch.inertia.momentum(values, link, column);
        let own = link.along(values, column, &momentum);
        let (own, size) = (sum(values, &[own, beside]), sum(values, &[size, beside]));
        self.set(unknown, unknown, own);
        branch.waiting.push_back(Waiting { unknown, momentum, size });
    }

    fn set(&mut self, i: usize, j: usize, entry: Value) {
        self.entries.insert((i.max(j), i.min(j)), entry);
    }

    fn entry(&self, values: &mut Values, i: usize, j: usize) -> Value {
        self.entries.get(&(i.max(j), i.min(j))).copied().unwrap_or_else(|| values.constant(0.0))
    }

    /// Eliminates the joints that wait at a link, from the tips on.
    fn eliminate(&mut self, values: &mut Values, branch: &mut Branch, at: usize, has_frame: bool) {
        while let Some(Waiting { unknown, momentum, size }) = branch.waiting.pop_front() {
            let pivot = self.entry(values, unknown, unknown);
            let one = values.constant(1.0);
            let inverse = values.quotient(one, pivot);
            let (name, force) = (&self.names[unknown], self.right_hand_side[unknown]);
            self.notes.name(pivot, format!("pivot_{name}"));
            self.notes.name(inverse, format!("inverse_{name}"));
            self.notes.right_hand_side(force, name);
            self.pivots.push((pivot, size));
            let shares = self.shared_by_joints(values, branch, unknown, inverse);
            let of_frame = match has_frame {
                true => momentum.map(|part| part.map(|x| product(values, x, inverse))),
                false => [zero(values); 2],
            };
            if has_frame {
                branch.give_way(values, &momentum, &shares, &of_frame, (pivot, force));
            }
            self.steps.push(Step { link: at, unknown, inverse, shares, of_frame });
        }
    }

    /// The shares of a joint that those that wait longer take over, with what they take: of M and of its force.
    fn shared_by_joints(
        &mut self,
        values: &mut Values,
        branch: &Branch,
        unknown: usize,
        inverse: Value,
    ) -> Vec<(usize, Value)> {
        let met = branch.waiting.iter().filter_map(|other| {
            let entry = self.entry(values, other.unknown, unknown);
            (!values.is_zero(entry)).then_some((other.unknown, entry))
        });
        let met: Vec<(usize, Value)> = met.collect();
        let mut shares = Vec::with_capacity(met.len());
        for (at, (other, entry)) in met.iter().enumerate() {
            let share = product(values, *entry, inverse);
            self.notes.name(share, format!("l_{}_{}", self.names[*other], self.names[unknown]));
            let passed_on = product(values, share, self.right_hand_side[unknown]);
            self.right_hand_side[*other] = difference(values, self.right_hand_side[*other], passed_on);
            for (second, entry) in &met[..=at] {
                let (old, gone) = (self.entry(values, *other, *second), product(values, share, *entry));
                let new = difference(values, old, gone);
                self.set(*other, *second, new);
            }
            shares.push((*other, share));
        }
        shares
    }
}

impl Branch {
    /// What a joint with this momentum leaves of the frame's inertia, of its wrench, and of the momenta of those that wait.
    fn give_way(
        &mut self,
        values: &mut Values,
        momentum: &[Triple; 2],
        shares: &[(usize, Value)],
        of_frame: &[Triple; 2],
        (pivot, force): (Value, Value),
    ) {
        for joint in &mut self.waiting {
            let Some((_, share)) = shares.iter().find(|(other, _)| *other == joint.unknown) else { continue };
            joint.momentum = std::array::from_fn(|part| {
                std::array::from_fn(|i| {
                    let gone = product(values, *share, momentum[part][i]);
                    difference(values, joint.momentum[part][i], gone)
                })
            });
        }
        self.moments.push(of_frame[0].map(|share| product(values, share, force)));
        self.forces.push(of_frame[1].map(|share| product(values, share, force)));
        self.inertia = self.inertia.clone().giving_way(values, momentum, of_frame, pivot);
    }
}

/// The accelerations of frames that joints add.
struct Frames<'a> {
    tree: &'a LinkTree,
    /// What each link gets from the one before, as far as it is known.
    carried: Vec<Option<[Triple; 2]>>,
}

impl Frames<'_> {
    /// Of the angular velocity and the origin, in the frame of a link, without its own joints.
    fn carried(&mut self, values: &mut Values, at: usize, solved: &[Value]) -> [Triple; 2] {
        if let Some(known) = self.carried[at] {
            return known;
        }
        let link = &self.tree.links[at];
        let Some(before) = link.before else { return [zero(values); 2] };
        let [mut turning, mut shifting] = self.carried(values, before, solved);
        let inner = &self.tree.links[before];
        for column in &inner.columns {
            let shift = apply(values, &transposed(&inner.turn), &column.shift);
            for i in 0..3 {
                let [turned, shifted] =
                    [column.spin[i], shift[i]].map(|x| product(values, x, solved[column.coordinate]));
                turning[i] = sum(values, &[turning[i], turned]);
                shifting[i] = sum(values, &[shifting[i], shifted]);
            }
        }
        let arm = cross(values, &turning, &link.offset[0]);
        let origin = add(values, &shifting, &arm);
        let back = transposed(&link.turn);
        let carried = [apply(values, &back, &turning), apply(values, &back, &origin)];
        self.carried[at] = Some(carried);
        carried
    }
}

impl LinkValues {
    /// The work of a wrench along a column.
    pub(super) fn along(&self, values: &mut Values, column: &Column, [moment, force]: &[Triple; 2]) -> Value {
        let pushed = apply(values, &self.turn, force);
        let parts = [dot(values, &column.spin, moment), dot(values, &column.shift, &pushed)];
        sum(values, &parts)
    }

    /// A wrench in the frame before, about the origin there.
    pub(super) fn wrench_before(&self, values: &mut Values, [moment, force]: &[Triple; 2]) -> [Triple; 2] {
        let (turned, pushed) = (apply(values, &self.turn, moment), apply(values, &self.turn, force));
        let arm = cross(values, &self.offset[0], &pushed);
        [add(values, &turned, &arm), pushed]
    }
}
