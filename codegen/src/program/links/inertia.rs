//! Articulated inertias: what a link needs to be accelerated if joints beyond it give way (Featherstone, Rigid Body Dynamics
//! Algorithms, 2008, section 7.1).

use super::composite::symmetric;
use super::tree::{Column, LinkValues, Mass};
use super::triple::{Matrix, Triple, add, apply, cross, difference, inner, product, sum, transposed};
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

    /// In the frame before its link's, about the same place.
    pub(super) fn turned(&self, values: &mut Values, link: &LinkValues) -> Inertia {
        match self {
            Inertia::Rigid(mass) => Inertia::Rigid(mass.turned(values, link)),
            Inertia::Articulated(own) => Inertia::Articulated(own.turned(values, link)),
        }
    }

    /// About an origin from which its own stands at r.
    pub(super) fn moved(&self, values: &mut Values, r: &Triple) -> Inertia {
        match self {
            Inertia::Rigid(mass) => Inertia::Rigid(mass.moved(values, r)),
            Inertia::Articulated(own) => Inertia::Articulated(own.moved(values, r)),
        }
    }

    pub(super) fn add(&self, values: &mut Values, other: &Inertia) -> Inertia {
        if let (Inertia::Rigid(mass), Inertia::Rigid(other)) = (self, other) {
            return Inertia::Rigid(mass.add(values, other));
        }
        let (own, other) = (self.articulated(values), other.articulated(values));
        Inertia::Articulated(Articulated {
            turning: symmetric(|(i, j)| sum(values, &[own.turning[i][j], other.turning[i][j]])),
            mixed: std::array::from_fn(|i| add(values, &own.mixed[i], &other.mixed[i])),
            shifting: symmetric(|(i, j)| sum(values, &[own.shifting[i][j], other.shifting[i][j]])),
        })
    }

    fn articulated(&self, values: &mut Values) -> Articulated {
        let mass = match self {
            Inertia::Articulated(own) => return own.clone(),
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
        &self,
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

impl Articulated {
    fn turned(&self, values: &mut Values, link: &LinkValues) -> Articulated {
        let [turning, mixed, shifting] = [&self.turning, &self.mixed, &self.shifting].map(|m| link.rotated(values, m));
        Articulated { turning, mixed, shifting }
    }

    /// With V = H + [r] M for H: I + [r] H' - V [r].
    fn moved(&self, values: &mut Values, r: &Triple) -> Articulated {
        let h = &self.mixed;
        let carried = crossed(values, r, &self.shifting);
        let v: Matrix = std::array::from_fn(|i| add(values, &h[i], &carried[i]));
        // Its entries, those of each component of r together.
        let turning = symmetric(|(i, j)| {
            let moved = if i == j {
                let (j, k) = ((i + 1) % 3, (i + 2) % 3);
                let [ahead, back] = [k, j].map(|other| sum(values, &[h[i][other], v[i][other]]));
                let back = values.negate(back);
                inner(values, &[(r[j], ahead), (r[k], back)])
            } else {
                let k = 3 - i - j;
                let (i, j) = ((k + 1) % 3, (k + 2) % 3);
                let apart = difference(values, v[i][i], h[j][j]);
                let back = values.negate(v[i][k]);
                inner(values, &[(r[k], apart), (r[j], h[j][k]), (r[i], back)])
            };
            sum(values, &[self.turning[i][j], moved])
        });
        Articulated { turning, mixed: v, shifting: self.shifting }
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
