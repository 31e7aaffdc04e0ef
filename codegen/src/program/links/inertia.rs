//! Articulated inertias: what a link needs to be accelerated if joints beyond it give way (Featherstone, Rigid Body Dynamics
//! Algorithms, 2008, section 7.1).

use super::composite::symmetric;
use super::tree::{Column, LinkValues, Mass};
use super::triple::{Matrix, Triple, add, apply, cross, difference, product, sum, transposed};
use crate::program::values::{Value, Values};

/// What the acceleration of a frame takes: moment and force, about the origin.
#[derive(Clone)]
pub(super) enum Inertia {
    /// As a rigid body.
    Rigid(Mass),
    /// With joints that give way.
    Articulated(Articulated),
}

/// n = I w' + H a, f = H' w' + M a.
#[derive(Clone)]
pub(super) struct Articulated {
    /// I, symmetric.
    turning: Matrix,
    /// H.
    mixed: Matrix,
    /// M, symmetric.
    shifting: Matrix,
}

impl Inertia {
    /// The momenta that a coordinate's speed gives it.
    pub(super) fn momentum(&self, values: &mut Values, link: &LinkValues, column: &Column) -> [Triple; 2] {
        match self {
            Inertia::Rigid(mass) => link.momentum(values, mass, column),
            Inertia::Articulated(own) => {
                let shift = apply(values, &transposed(&link.turn), &column.shift);
                let halves = [
                    [apply(values, &own.turning, &column.spin), apply(values, &own.mixed, &shift)],
                    [apply(values, &transposed(&own.mixed), &column.spin), apply(values, &own.shifting, &shift)],
                ];
                halves.map(|[turning, shifting]| add(values, &turning, &shifting))
            }
        }
    }

    /// The same about the origin of the frame before.
    pub(super) fn seen_from_before(&self, values: &mut Values, link: &LinkValues) -> Inertia {
        match self {
            Inertia::Rigid(mass) => Inertia::Rigid(link.seen_from_before(values, mass)),
            Inertia::Articulated(own) => Inertia::Articulated(link.articulated_from_before(values, own)),
        }
    }

    pub(super) fn add(self, values: &mut Values, other: &Inertia) -> Inertia {
        if let (Inertia::Rigid(mass), Inertia::Rigid(other)) = (&self, other) {
            let mut both = mass.clone();
            both.add(values, other);
            return Inertia::Rigid(both);
        }
        let (own, other) = (self.articulated(values), other.clone().articulated(values));
        Inertia::Articulated(Articulated {
            turning: symmetric(|(i, j)| sum(values, &[own.turning[i][j], other.turning[i][j]])),
            mixed: std::array::from_fn(|i| add(values, &own.mixed[i], &other.mixed[i])),
            shifting: symmetric(|(i, j)| sum(values, &[own.shifting[i][j], other.shifting[i][j]])),
        })
    }

    fn articulated(self, values: &mut Values) -> Articulated {
        let mass = match self {
            Inertia::Articulated(own) => return own,
            Inertia::Rigid(mass) => mass,
        };
        let zero = values.constant(0.0);
        let p = &mass.second;
        let turning = symmetric(|(i, j)| match i == j {
            true => sum(values, &[p[(i + 1) % 3][(i + 1) % 3], p[(i + 2) % 3][(i + 2) % 3]]),
            false => values.negate(p[i][j]),
        });
        let mixed = skew(values, &mass.first);
        let shifting = symmetric(|(i, j)| if i == j { mass.mass } else { zero });
        Articulated { turning, mixed, shifting }
    }

    /// What is left of it where a joint with these momenta gives way: less k k'/d, with the shares k/d.
    pub(super) fn giving_way(
        self,
        values: &mut Values,
        [moment, force]: &[Triple; 2],
        [turn, shift]: &[Triple; 2],
        pivot: Value,
    ) -> Inertia {
        let own = self.articulated(values);
        // About an axis of the frame, and along one, nothing is left.
        let about = |k: &usize| own.turning[*k] == *moment && own.mixed[*k] == *force && own.turning[*k][*k] == pivot;
        let slid = transposed(&own.mixed);
        let along = |k: &usize| slid[*k] == *moment && own.shifting[*k] == *force && own.shifting[*k][*k] == pivot;
        let (about, along) = ((0..3).find(about), (0..3).find(along));
        let zero = values.constant(0.0);
        let mut less = |of: Value, share: Value, momentum: Value| {
            let gone = product(values, share, momentum);
            difference(values, of, gone)
        };
        let turning = symmetric(|(i, j)| match about {
            Some(k) if k == i || k == j => zero,
            _ => less(own.turning[i][j], turn[i], moment[j]),
        });
        let mixed = std::array::from_fn(|i| {
            std::array::from_fn(|j| match (about, along) {
                (Some(k), _) if k == i => zero,
                (_, Some(k)) if k == j => zero,
                _ => less(own.mixed[i][j], turn[i], force[j]),
            })
        });
        let shifting = symmetric(|(i, j)| match along {
            Some(k) if k == i || k == j => zero,
            _ => less(own.shifting[i][j], shift[i], force[j]),
        });
        Inertia::Articulated(Articulated { turning, mixed, shifting })
    }
}

impl LinkValues {
    /// With H + [r] M for H: I + [r] H' - (H + [r] M) [r].
    fn articulated_from_before(&self, values: &mut Values, own: &Articulated) -> Articulated {
        let r = &self.offset[0];
        let [turning, mixed, shifting] = [&own.turning, &own.mixed, &own.shifting].map(|m| self.rotated(values, m));
        let carried = crossed(values, r, &shifting);
        let moved: Matrix = std::array::from_fn(|i| add(values, &mixed[i], &carried[i]));
        let ahead = crossed(values, r, &transposed(&mixed));
        // [r] (H + [r] M)' is -(H + [r] M) [r], transposed.
        let back = transposed(&crossed(values, r, &transposed(&moved)));
        let turning = symmetric(|(i, j)| sum(values, &[turning[i][j], ahead[i][j], back[i][j]]));
        Articulated { turning, mixed: moved, shifting }
    }
}

/// [r].
fn skew(values: &mut Values, r: &Triple) -> Matrix {
    let zero = values.constant(0.0);
    let minus = r.map(|x| values.negate(x));
    [[zero, minus[2], r[1]], [r[2], zero, minus[0]], [minus[1], r[0], zero]]
}

/// [r] A, column by column.
pub(super) fn crossed(values: &mut Values, r: &Triple, a: &Matrix) -> Matrix {
    transposed(&transposed(a).map(|column| cross(values, r, &column)))
}
