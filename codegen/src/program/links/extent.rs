//! How much inertia follows a link at most, wherever its joints stand: what the pivots of articulated bodies are measured by.
//!
//! A pivot's rounding is that of what gave way before, in all directions, and the trace of second moments bounds the inertia about
//! any axis. Moved by r it grows by r (2 h + M r), so that along joints which turn all is made of parameters.

use super::tree::{Column, LinkTree, LinkValues, Mass};
use super::triple::{Triple, dot, product, sum};
use crate::program::values::{Value, Values};

/// Bounds of a mass distribution: its mass, and the sizes of its first moment and of its second moments' trace.
#[derive(Clone, Copy)]
pub(super) struct Extent {
    mass: Value,
    first: Value,
    second: Value,
}

impl LinkTree {
    /// What follows each link, without its own bodies, about its origin.
    pub(super) fn extents(&self, values: &mut Values) -> Vec<Extent> {
        let none = values.constant(0.0);
        let mut extents = vec![Extent { mass: none, first: none, second: none }; self.links.len()];
        for (at, link) in self.links.iter().enumerate().rev() {
            let Some(before) = link.before else { continue };
            let own = Extent::of(values, &link.mass);
            let all = extents[at].add(values, &own);
            let moved = all.moved(values, &link.offset[0]);
            extents[before] = extents[before].add(values, &moved);
        }
        extents
    }
}

impl Extent {
    fn of(values: &mut Values, Mass { mass, first, second }: &Mass) -> Extent {
        let trace = sum(values, &[second[0][0], second[1][1], second[2][2]]);
        Extent { mass: *mass, first: length(values, first), second: trace }
    }

    fn add(&self, values: &mut Values, other: &Extent) -> Extent {
        Extent {
            mass: sum(values, &[self.mass, other.mass]),
            first: sum(values, &[self.first, other.first]),
            second: sum(values, &[self.second, other.second]),
        }
    }

    /// About an origin that lies so far away.
    fn moved(&self, values: &mut Values, offset: &Triple) -> Extent {
        let r = length(values, offset);
        let carried = product(values, self.mass, r);
        let first = sum(values, &[self.first, carried]);
        let both = sum(values, &[self.first, first]);
        let grown = product(values, r, both);
        Extent { mass: self.mass, first, second: sum(values, &[self.second, grown]) }
    }

    /// The inertia along a column of a link that this follows, with the link's own: the scale of its pivot.
    pub(super) fn along(&self, values: &mut Values, link: &LinkValues, column: &Column) -> Value {
        let own = link.momentum(values, &link.mass, column);
        let own = link.along(values, column, &own);
        let [turned, shifted] = [(&column.spin, self.second), (&column.shift, self.mass)].map(|(by, inertia)| {
            let square = dot(values, by, by);
            product(values, square, inertia)
        });
        sum(values, &[own, turned, shifted])
    }
}

/// The sum of the sizes of the components, which is at least the length.
fn length(values: &mut Values, vector: &Triple) -> Value {
    let sizes = vector.map(|x| match values.number(x) {
        Some(number) => values.constant(number.abs()),
        None => values.magnitude(x),
    });
    sum(values, &sizes)
}
