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
//!
//! A pivot is measured by what its joint would move if no other gave way: by the composite body, where there is one, and else by
//! a bound of it (`extent`), which may refuse a pivot that has its digits, but costs next to nothing.

use super::branch::{Branch, Waiting};
use super::extent::Extent;
use super::frames::Frames;
use super::inertia::Inertia;
use super::tree::{Column, LinkTree, LinkValues};
use super::triple::{Triple, difference, dot, product, sum, zero};
use crate::program::notes::Notes;
use crate::program::values::{Value, Values};
use rustc_hash::FxHashMap;

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
    /// Q - h, less what joints that gave way have taken over.
    right_hand_side: Vec<Value>,
    /// Q beside links.
    applied: Vec<Value>,
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
        let extents = self.extents(values);
        // Where all q'' = 0.
        let motions = self.motions(values, None);
        let branches = self.links.iter().zip(&motions).map(|(link, motion)| Branch::of(values, &link.mass, motion));
        let mut branches: Vec<Branch> = branches.collect();
        let mut elimination = Elimination {
            names,
            notes,
            entries: FxHashMap::default(),
            right_hand_side: beside.forces.clone(),
            applied: beside.forces,
            steps: vec![],
            pivots: vec![],
        };
        while let Some(mut branch) = branches.pop() {
            branch.settle(values);
            let at = branches.len();
            let link = &self.links[at];
            for column in &link.columns {
                let beside = beside.inertias[column.coordinate];
                elimination.enter(values, (link, &extents[at]), &mut branch, column, beside);
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

    /// The unknowns from the world to the tips.
    fn back(&self, values: &mut Values, steps: &[Step], right_hand_side: Vec<Value>) -> Vec<Value> {
        let mut solved = right_hand_side;
        let mut frames = Frames::of(self);
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

impl Elimination<'_> {
    /// A joint of a link that so much follows, with the inertia along it beside the link's.
    fn enter(
        &mut self,
        values: &mut Values,
        (link, followers): (&LinkValues, &Extent),
        branch: &mut Branch,
        column: &Column,
        beside: Value,
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
        let size = match branch.inertia {
            Inertia::Rigid(_) => own,
            Inertia::Articulated(_) => followers.along(values, link, column),
        };
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
                true => momentum.map(|part| part.map(|x| if x == pivot { one } else { product(values, x, inverse) })),
                false => [zero(values); 2],
            };
            if has_frame {
                branch.give_way(values, &momentum, &shares, &of_frame, pivot);
                branch.take_over(values, &of_frame, force, self.applied[unknown]);
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
