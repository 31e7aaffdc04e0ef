//! The derivatives of inverse dynamics by the state, along a tree (Singh, Russell and Wensing, IEEE Robotics and Automation
//! Letters 7, 2022; after Carpentier and Mansard, Robotics: Science and Systems 2018).
//!
//! Motions (angular, linear) and wrenches (moment, force) are about the origin of a link, in its frame. A joint moves with
//! S = (s, d), fixed in its link, which has the velocity v and the acceleration a. With
//!
//! ```text
//! S' = v x S,   S'' = a x S + v x S',   b(x) = 2 (-K x, x x p)
//! ```
//!
//! where p is the momentum of what follows the link, I its inertia, (n, f) the wrench that it takes, and b what Coriolis' terms
//! make of a turning x, the forces Q along a joint i and along one before it, j, change by
//!
//! ```text
//! dQ_i/dq_j  = S_i (b(s_j') + I S_j''),                       dQ_i/dq_j'  = S_i (b(s_j) + 2 I S_j')
//! dQ_j/dq_i  = S_j (b(s_i') + I S_i'' + S_i x (n, f)),        dQ_j/dq_i'  = S_j (b(s_i) + 2 I S_i')
//! ```
//!
//! They write 6 x 6 matrices in the world. About the own origin b of a rigid body needs its turning alone, and with second
//! moments in place of inertias it is short: K = [w] P + [h] [l] with the velocity l of the origin.

use super::inertia::crossed;
use super::newton_euler::{Motion, total};
use super::tree::{Column, LinkTree, LinkValues, Mass};
use super::triple::{Matrix, Triple, add, apply, cross, difference, dot, inner, product, sum, transposed, zero};
use crate::program::values::{Value, Values};

/// Angular and linear, or moment and force.
type Pair = [Triple; 2];

/// The derivatives of the forces along all unknowns, by each in turn; those by the position and the linear velocity of a link that
/// moves freely are zero: nothing notices them.
pub(super) struct Derivatives {
    /// For each unknown, of all.
    pub(super) by_positions: Vec<Vec<Value>>,
    pub(super) by_speeds: Vec<Vec<Value>>,
    /// The motion of each link.
    pub(super) motions: Vec<Motion>,
}

/// A link with what follows it.
struct Subtree {
    inertia: Mass,
    wrench: Pair,
    /// p.
    momentum: Triple,
    /// K.
    coriolis: Matrix,
}

/// How a column moves its link: S, and what comes with its position and its speed.
struct Twist {
    /// S.
    along: Pair,
    /// S' as it belongs to the position.
    rate: Pair,
    /// S''.
    second: Pair,
    /// What belongs to the speed: 2 S', or the change of S with its own link.
    doubled: Pair,
}

/// What goes from a column down to the world.
struct Carried {
    /// The force along it, as what it takes from motions: I S, and b along S.
    momentum: Pair,
    turned: Triple,
    /// What its position and its speed take.
    by_position: Pair,
    by_speed: Pair,
}

impl LinkTree {
    /// The derivatives of M q'' + h - Q of the links and their weights, for joints along or about fixed axes.
    pub(super) fn derivatives(&self, values: &mut Values, accelerations: &[Value]) -> Derivatives {
        let motions = self.motions(values, Some(accelerations));
        let origins = self.velocities_of_origins(values, &motions);
        let subtrees = self.subtrees(values, &motions, &origins);
        let twists = self.links.iter().zip(motions.iter().zip(&origins));
        let twists = twists.map(|(link, (motion, origin))| {
            link.columns.iter().map(|column| link.twist(values, column, motion, origin)).collect()
        });
        let twists: Vec<Vec<Twist>> = twists.collect();
        let none = vec![vec![values.constant(0.0); self.coordinates]; self.coordinates];
        let mut derivatives = Derivatives { by_positions: none.clone(), by_speeds: none, motions };
        for (at, link) in self.links.iter().enumerate() {
            for (column, twist) in link.columns.iter().zip(&twists[at]) {
                let carried = link.carried(values, column, twist, &subtrees[at]);
                self.follow_derivatives(values, at, column.coordinate, carried, &twists, &mut derivatives);
            }
        }
        derivatives
    }

    /// The velocities of the links' origins in their frames; of a link that moves freely it makes no difference and is zero.
    fn velocities_of_origins(&self, values: &mut Values, motions: &[Motion]) -> Vec<Triple> {
        let none = zero(values);
        let mut origins: Vec<Triple> = Vec::with_capacity(self.links.len());
        for link in &self.links {
            let before = link.before.map_or([none; 2], |before| [motions[before].spin, origins[before]]);
            let arm = cross(values, &before[0], &link.offset[0]);
            let moved: Triple = std::array::from_fn(|i| sum(values, &[before[1][i], arm[i], link.offset[1][i]]));
            origins.push(apply(values, &transposed(&link.turn), &moved));
        }
        origins
    }

    fn subtrees(&self, values: &mut Values, motions: &[Motion], origins: &[Triple]) -> Vec<Subtree> {
        let composites = self.composites(values);
        let mut parts: Vec<Parts> = self.links.iter().map(|_| Parts::default()).collect();
        let mut subtrees = Vec::with_capacity(self.links.len());
        for (at, (link, inertia)) in self.links.iter().zip(composites).enumerate().rev() {
            let mut own = std::mem::take(&mut parts[at]);
            own.add(values, &link.mass, &motions[at], &origins[at]);
            let subtree = own.together(values, inertia);
            if let Some(before) = link.before {
                parts[before].receive(values, link, &subtree);
            }
            subtrees.push(subtree);
        }
        subtrees.reverse();
        subtrees
    }

    /// Enters the derivatives between a column and those of its link and of the links before it.
    fn follow_derivatives(
        &self,
        values: &mut Values,
        from: usize,
        own: usize,
        mut carried: Carried,
        twists: &[Vec<Twist>],
        derivatives: &mut Derivatives,
    ) {
        let Derivatives { by_positions, by_speeds, .. } = derivatives;
        let mut at = from;
        loop {
            let link = &self.links[at];
            for (column, twist) in link.columns.iter().zip(&twists[at]) {
                let other = column.coordinate;
                by_positions[own][other] = link.along(values, column, &carried.by_position);
                by_speeds[own][other] = link.along(values, column, &carried.by_speed);
                if at != from {
                    let [turned, moved] =
                        [dot(values, &carried.turned, &twist.rate[0]), carried.taken(values, &twist.second)];
                    by_positions[other][own] = sum(values, &[turned, moved]);
                    let [turned, moved] =
                        [dot(values, &carried.turned, &twist.along[0]), carried.taken(values, &twist.doubled)];
                    by_speeds[other][own] = sum(values, &[turned, moved]);
                }
            }
            let Some(before) = link.before else { return };
            carried = carried.before(values, link);
            at = before;
        }
    }
}

/// The terms of a subtree, to be added up.
#[derive(Default)]
struct Parts {
    wrench: [Vec<Triple>; 2],
    momentum: Vec<Triple>,
    coriolis: Vec<Matrix>,
}

impl Parts {
    /// Those of a link itself.
    fn add(&mut self, values: &mut Values, mass: &Mass, motion: &Motion, origin: &Triple) {
        let [moment, force] = mass.wrench(values, motion);
        self.wrench[0].push(moment);
        self.wrench[1].push(force);
        let swept = cross(values, &motion.spin, &mass.first);
        let carried = origin.map(|x| product(values, mass.mass, x));
        self.momentum.extend([carried, swept]);
        let turned = crossed(values, &motion.spin, &mass.second);
        self.coriolis.extend([turned, crossed_twice(values, &mass.first, origin)]);
    }

    /// Those of what follows, about the origin of the link before: S K S' + [r] [S p] for K.
    fn receive(&mut self, values: &mut Values, link: &LinkValues, outer: &Subtree) {
        let [moment, force] = link.wrench_before(values, &outer.wrench);
        self.wrench[0].push(moment);
        self.wrench[1].push(force);
        let momentum = apply(values, &link.turn, &outer.momentum);
        self.momentum.push(momentum);
        let turned = link.rotated(values, &outer.coriolis);
        self.coriolis.extend([turned, crossed_twice(values, &link.offset[0], &momentum)]);
    }

    fn together(self, values: &mut Values, inertia: Mass) -> Subtree {
        let [moments, forces] = self.wrench;
        let coriolis = std::array::from_fn(|i| total(values, &self.coriolis.iter().map(|k| k[i]).collect::<Vec<_>>()));
        Subtree {
            inertia,
            wrench: [total(values, &moments), total(values, &forces)],
            momentum: total(values, &self.momentum),
            coriolis,
        }
    }
}

impl LinkValues {
    fn twist(&self, values: &mut Values, column: &Column, motion: &Motion, origin: &Triple) -> Twist {
        let (none, two) = (zero(values), values.constant(2.0));
        let along = [column.spin, apply(values, &transposed(&self.turn), &column.shift)];
        let velocity = [motion.spin, *origin];
        let rate = moved(values, &velocity, &along);
        if self.moves_freely {
            // Its linear velocity is not noticed, nor is its place.
            let turns = column.spin.iter().any(|x| !values.is_zero(*x));
            return Twist { along, rate: [none; 2], second: [none; 2], doubled: if turns { rate } else { [none; 2] } };
        }
        let swept = cross(values, &motion.spin, origin);
        let proper = std::array::from_fn(|i| difference(values, motion.proper[i], swept[i]));
        let of_axis = moved(values, &[motion.spin_rate, proper], &along);
        let of_rate = moved(values, &velocity, &rate);
        let second = [add(values, &of_axis[0], &of_rate[0]), add(values, &of_axis[1], &of_rate[1])];
        Twist { along, rate, second, doubled: rate.map(|part| part.map(|x| product(values, two, x))) }
    }

    fn carried(&self, values: &mut Values, column: &Column, twist: &Twist, subtree: &Subtree) -> Carried {
        let Subtree { inertia, wrench, momentum, coriolis } = subtree;
        let Twist { along, rate, second, doubled } = twist;
        let (two, minus_two) = (values.constant(2.0), values.constant(-2.0));
        let turned = apply(values, &transposed(coriolis), &along[0]);
        let swept = cross(values, momentum, &along[1]);
        let turned = std::array::from_fn(|i| inner(values, &[(minus_two, turned[i]), (two, swept[i])]));
        let (coriolis, inertial) = (subtree.coriolis_of(values, &along[0]), inertia.momentum(values, doubled));
        let by_speed = [add(values, &coriolis[0], &inertial[0]), add(values, &coriolis[1], &inertial[1])];
        let by_position = match self.moves_freely {
            true => [zero(values); 2],
            false => {
                let of_rate = subtree.coriolis_of(values, &rate[0]);
                let inertial = inertia.momentum(values, second);
                let pushed = [cross(values, &along[1], &wrench[1]), cross(values, &along[0], &wrench[1])];
                let turned = cross(values, &along[0], &wrench[0]);
                [
                    std::array::from_fn(|i| sum(values, &[of_rate[0][i], inertial[0][i], turned[i], pushed[0][i]])),
                    std::array::from_fn(|i| sum(values, &[of_rate[1][i], inertial[1][i], pushed[1][i]])),
                ]
            }
        };
        Carried { momentum: self.momentum(values, inertia, column), turned, by_position, by_speed }
    }
}

impl Subtree {
    /// b(x).
    fn coriolis_of(&self, values: &mut Values, turning: &Triple) -> Pair {
        let (two, minus_two) = (values.constant(2.0), values.constant(-2.0));
        let moment = apply(values, &self.coriolis, turning).map(|x| product(values, minus_two, x));
        let force = cross(values, turning, &self.momentum).map(|x| product(values, two, x));
        [moment, force]
    }
}

impl Carried {
    fn before(self, values: &mut Values, link: &LinkValues) -> Carried {
        Carried {
            momentum: link.wrench_before(values, &self.momentum),
            turned: apply(values, &link.turn, &self.turned),
            by_position: link.wrench_before(values, &self.by_position),
            by_speed: link.wrench_before(values, &self.by_speed),
        }
    }

    /// What the force along the column takes for a motion.
    fn taken(&self, values: &mut Values, motion: &Pair) -> Value {
        let parts = [dot(values, &self.momentum[0], &motion[0]), dot(values, &self.momentum[1], &motion[1])];
        sum(values, &parts)
    }
}

/// The rate of a motion that moves with a frame: (w x s, w x d + l x s).
fn moved(values: &mut Values, [spin, origin]: &Pair, [turning, shifting]: &Pair) -> Pair {
    let (swept, carried) = (cross(values, spin, shifting), cross(values, origin, turning));
    [cross(values, spin, turning), add(values, &swept, &carried)]
}

/// [a] [b] = b a' - a.b
fn crossed_twice(values: &mut Values, a: &Triple, b: &Triple) -> Matrix {
    let own: Triple = std::array::from_fn(|i| product(values, a[i], b[i]));
    std::array::from_fn(|i| {
        std::array::from_fn(|j| match i == j {
            true => {
                let both = sum(values, &[own[(i + 1) % 3], own[(i + 2) % 3]]);
                values.negate(both)
            }
            false => product(values, b[i], a[j]),
        })
    })
}
