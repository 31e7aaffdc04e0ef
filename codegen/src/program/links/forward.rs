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

use super::arrivals::Arrivals;
use super::extent::Extent;
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
    arrivals: Arrivals<(Inertia, Wrench)>,
    inertia: Inertia,
    moments: Vec<Triple>,
    forces: Vec<Triple>,
    waiting: VecDeque<Waiting>,
}

/// Moment and force.
type Wrench = [Triple; 2];

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
        let mut branches = self.branches(values);
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

    /// The links without what follows them, where all q'' = 0.
    fn branches(&self, values: &mut Values) -> Vec<Branch> {
        let motions = self.motions(values, None);
        let branch = |(link, motion): (&LinkValues, &Motion)| {
            let [moment, force] = link.mass.wrench(values, motion);
            let inertia = Inertia::Rigid(link.mass.clone());
            Branch {
                arrivals: Arrivals::default(),
                inertia,
                moments: vec![moment],
                forces: vec![force],
                waiting: VecDeque::new(),
            }
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

    /// Takes over what follows.
    fn receive(&mut self, values: &mut Values, link: &LinkValues, mut outer: Branch) {
        let wrench = outer.wrench(values).map(|part| apply(values, &link.turn, &part));
        for mut joint in outer.waiting {
            joint.momentum = link.wrench_before(values, &joint.momentum);
            self.waiting.push_back(joint);
        }
        let turned = (outer.inertia.turned(values, link), wrench);
        self.arrivals.enter(link.offset[0], turned, |(inertia, wrench), (other, added)| {
            let wrench = std::array::from_fn(|part| add(values, &wrench[part], &added[part]));
            (inertia.add(values, other), wrench)
        });
    }

    /// Adds up what has arrived, about its own origin.
    fn settle(&mut self, values: &mut Values) {
        for (place, (inertia, wrench)) in std::mem::take(&mut self.arrivals).into_places() {
            let [moment, force] = moved(values, &place, &wrench);
            self.moments.push(moment);
            self.forces.push(force);
            let inertia = inertia.moved(values, &place);
            self.inertia = self.inertia.add(values, &inertia);
        }
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

impl Branch {
    /// What a joint with this momentum leaves of the frame's inertia and of the momenta of those that wait.
    fn give_way(
        &mut self,
        values: &mut Values,
        momentum: &[Triple; 2],
        shares: &[(usize, Value)],
        of_frame: &[Triple; 2],
        pivot: Value,
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
        self.inertia = self.inertia.giving_way(values, momentum, of_frame, pivot);
    }

    /// The wrench where a joint gives way: its shares of the force on the joint come to it. Along a joint about an axis of the frame,
    /// or along one, that leaves what is applied there.
    fn take_over(&mut self, values: &mut Values, of_frame: &Wrench, force: Value, applied: Value) {
        let wrench = self.wrench(values);
        let [moment, force] = std::array::from_fn(|part| {
            std::array::from_fn(|i| {
                let (own, share) = (wrench[part][i], of_frame[part][i]);
                if values.is_constant(share, 1.0) && difference(values, applied, own) == force {
                    return applied;
                }
                let taken = product(values, share, force);
                sum(values, &[own, taken])
            })
        });
        (self.moments, self.forces) = (vec![moment], vec![force]);
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
    pub(super) fn wrench_before(&self, values: &mut Values, wrench: &Wrench) -> Wrench {
        let turned = wrench.map(|part| apply(values, &self.turn, &part));
        moved(values, &self.offset[0], &turned)
    }
}

/// A wrench about an origin from which its own stands at r.
fn moved(values: &mut Values, r: &Triple, [moment, force]: &Wrench) -> Wrench {
    let arm = cross(values, r, force);
    [add(values, moment, &arm), *force]
}
