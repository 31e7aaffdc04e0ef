//! A link with what follows it, as elimination goes from the tips to the world.

use super::arrivals::Arrivals;
use super::inertia::Inertia;
use super::newton_euler::{Motion, total};
use super::tree::{LinkValues, Mass};
use super::triple::{Triple, add, apply, difference, product, sum};
use super::wrench::{Wrench, moved};
use crate::program::values::{Value, Values};
use std::collections::VecDeque;

/// A joint that waits for its elimination.
pub(super) struct Waiting {
    pub(super) unknown: usize,
    /// Its row of F.
    pub(super) momentum: [Triple; 2],
    /// The scale of its pivot.
    pub(super) size: Value,
}

/// A link with what follows it: its inertia and its wrench, and the joints that wait.
pub(super) struct Branch {
    /// What follows, as far as it is not yet part of these.
    arrivals: Arrivals<(Inertia, Wrench)>,
    pub(super) inertia: Inertia,
    moments: Vec<Triple>,
    forces: Vec<Triple>,
    pub(super) waiting: VecDeque<Waiting>,
}

impl Branch {
    /// A link without what follows it, in this motion.
    pub(super) fn of(values: &mut Values, mass: &Mass, motion: &Motion) -> Branch {
        let [moment, force] = mass.wrench(values, motion);
        Branch {
            arrivals: Arrivals::default(),
            inertia: Inertia::Rigid(mass.clone()),
            moments: vec![moment],
            forces: vec![force],
            waiting: VecDeque::new(),
        }
    }

    pub(super) fn wrench(&mut self, values: &mut Values) -> Wrench {
        let wrench = [total(values, &self.moments), total(values, &self.forces)];
        (self.moments, self.forces) = (vec![wrench[0]], vec![wrench[1]]);
        wrench
    }

    /// Takes over what follows.
    pub(super) fn receive(&mut self, values: &mut Values, link: &LinkValues, mut outer: Branch) {
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
    pub(super) fn settle(&mut self, values: &mut Values) {
        for (place, (inertia, wrench)) in std::mem::take(&mut self.arrivals).into_places() {
            let [moment, force] = moved(values, &place, &wrench);
            self.moments.push(moment);
            self.forces.push(force);
            let inertia = inertia.moved(values, &place);
            self.inertia = self.inertia.add(values, &inertia);
        }
    }

    /// What a joint with this momentum leaves of the frame's inertia and of the momenta of those that wait.
    pub(super) fn give_way(
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
    pub(super) fn take_over(&mut self, values: &mut Values, of_frame: &Wrench, force: Value, applied: Value) {
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
