//! The mass matrix of a tree by composite bodies (Walker and Orin, J. Dyn. Syst. Meas. Control 104, 1982; Featherstone, Rigid
//! Body Dynamics Algorithms, 2008, section 6.2): a speed accelerates all that follows its link as one body, and the momentum of
//! that goes down to the world. Entries between branches are zero and not computed.

use super::arrivals::Arrivals;
use super::tree::{Column, LinkTree, LinkValues, Mass};
use super::triple::{Matrix, Triple, add, apply, cross, difference, dot, inner, product, sum, transposed};
use crate::program::values::{Value, Values};
use indexmap::IndexMap;

impl LinkTree {
    /// The entries (i, j), j <= i, that are not always zero, as sums.
    pub(super) fn mass_matrix(&self, values: &mut Values) -> Vec<(usize, usize, Value)> {
        let composites = self.composites(values);
        let mut terms: IndexMap<(usize, usize), Vec<Value>> = IndexMap::new();
        for (at, link) in self.links.iter().enumerate() {
            for column in &link.columns {
                let momentum = link.momentum(values, &composites[at], column);
                self.follow(values, at, column.coordinate, momentum, &mut terms);
            }
        }
        let mut entries: Vec<_> = terms.into_iter().map(|((i, j), terms)| (i, j, sum(values, &terms))).collect();
        entries.retain(|(_, _, value)| !values.is_zero(*value));
        entries
    }

    /// The generalised forces of the weights.
    pub(super) fn weights(&self, values: &mut Values) -> Vec<Value> {
        let composites = self.composites(values);
        let mut falls: Vec<Triple> = Vec::with_capacity(self.links.len());
        let mut forces: Vec<Vec<Value>> = vec![vec![]; self.coordinates];
        for (link, composite) in self.links.iter().zip(&composites) {
            let fall_before = link.before.map_or(link.gravity, |before| falls[before]);
            let fall = apply(values, &transposed(&link.turn), &fall_before);
            for column in &link.columns {
                let arm = cross(values, &column.spin, &composite.first);
                let carried = column.shift.map(|x| product(values, composite.mass, x));
                forces[column.coordinate].extend([dot(values, &arm, &fall), dot(values, &carried, &fall_before)]);
            }
            falls.push(fall);
        }
        forces.into_iter().map(|terms| sum(values, &terms)).collect()
    }

    /// Each link with all that follows it, about its origin.
    pub(super) fn composites(&self, values: &mut Values) -> Vec<Mass> {
        let mut composites: Vec<Mass> = self.links.iter().map(|link| link.mass.clone()).collect();
        let mut arrivals: Vec<Arrivals<Mass>> = self.links.iter().map(|_| Arrivals::default()).collect();
        for (at, link) in self.links.iter().enumerate().rev() {
            for (place, mass) in std::mem::take(&mut arrivals[at]).into_places() {
                let moved = mass.moved(values, &place);
                composites[at] = composites[at].add(values, &moved);
            }
            if let Some(before) = link.before {
                let turned = composites[at].turned(values, link);
                arrivals[before].enter(link.offset[0], turned, |sum, own| sum.add(values, own));
            }
        }
        composites
    }

    /// Enters what the momentum of a coordinate's speed, at a link, does to the coordinates of this link and those before.
    fn follow(
        &self,
        values: &mut Values,
        from: usize,
        coordinate: usize,
        [mut moment, mut force]: [Triple; 2],
        terms: &mut IndexMap<(usize, usize), Vec<Value>>,
    ) {
        let mut at = from;
        loop {
            let link = &self.links[at];
            let pushed = apply(values, &link.turn, &force);
            for column in &link.columns {
                let other = column.coordinate;
                // At its own link every pair is met twice.
                if at == from && other > coordinate {
                    continue;
                }
                let parts = [dot(values, &column.spin, &moment), dot(values, &column.shift, &pushed)];
                let place = (coordinate.max(other), coordinate.min(other));
                let entry = terms.entry(place).or_default();
                entry.extend(parts);
                if at != from && other == coordinate {
                    entry.extend(parts);
                }
            }
            let Some(before) = link.before else { return };
            [moment, force] = link.wrench_before(values, &[moment, force]);
            at = before;
        }
    }
}

impl LinkValues {
    /// The momenta about the origin that a coordinate's speed gives a composite body.
    pub(super) fn momentum(&self, values: &mut Values, body: &Mass, column: &Column) -> [Triple; 2] {
        let shift = apply(values, &transposed(&self.turn), &column.shift);
        body.momentum(values, &[column.spin, shift])
    }

    /// S A S'. About an axis of the frame, by the double angle.
    pub(super) fn rotated(&self, values: &mut Values, a: &Matrix) -> Matrix {
        let s = &self.turn;
        let is_symmetric = (0..3).all(|i| a[i][(i + 1) % 3] == a[(i + 1) % 3][i]);
        let Some(axis) = self.axis(values) else {
            let half: Matrix = std::array::from_fn(|i| apply(values, s, &a[i]));
            let mut entry = |i: usize, j: usize| {
                inner(values, &[(s[i][0], half[0][j]), (s[i][1], half[1][j]), (s[i][2], half[2][j])])
            };
            return match is_symmetric {
                true => symmetric(|(i, j)| entry(i, j)),
                false => std::array::from_fn(|i| std::array::from_fn(|j| entry(i, j))),
            };
        };
        let (i, j, k) = ((axis + 1) % 3, (axis + 2) % 3, axis);
        let (cos, sin) = (s[i][i], s[j][i]);
        // t = sin (sin (a - b) + 2 cos h) goes from a to b, and h becomes cos (sin (a - b) + 2 cos h) - h. Without symmetry 2 h
        // is the sum of both, and each becomes what the other is less.
        let apart = difference(values, a[i][i], a[j][j]);
        let doubled = match a[i][j] == a[j][i] {
            true => {
                let two = values.constant(2.0);
                product(values, two, a[i][j])
            }
            false => sum(values, &[a[i][j], a[j][i]]),
        };
        let doubled = product(values, cos, doubled);
        let swung = product(values, sin, apart);
        let common = sum(values, &[swung, doubled]);
        let (gone, turned) = (product(values, sin, common), product(values, cos, common));
        let mut rotated = *a;
        rotated[i][i] = difference(values, a[i][i], gone);
        rotated[j][j] = sum(values, &[a[j][j], gone]);
        rotated[i][j] = difference(values, turned, a[j][i]);
        rotated[j][i] = difference(values, turned, a[i][j]);
        let minus = values.negate(sin);
        let mut turn =
            |x: Value, y: Value| [inner(values, &[(cos, x), (minus, y)]), inner(values, &[(sin, x), (cos, y)])];
        [rotated[k][i], rotated[k][j]] = turn(a[k][i], a[k][j]);
        [rotated[i][k], rotated[j][k]] = turn(a[i][k], a[j][k]);
        rotated
    }

    /// The axis of its frame that its turning leaves where it is, if there is one.
    fn axis(&self, values: &Values) -> Option<usize> {
        let s = &self.turn;
        (0..3).find(|axis| {
            let others = [(axis + 1) % 3, (axis + 2) % 3];
            let [i, j] = others;
            values.is_constant(s[*axis][*axis], 1.0)
                && others.iter().all(|other| values.is_zero(s[*axis][*other]) && values.is_zero(s[*other][*axis]))
                && s[i][i] == s[j][j]
                && (values.opposite(s[i][j]) == Some(s[j][i]) || values.opposite(s[j][i]) == Some(s[i][j]))
                && !values.is_parametric(s[i][i])
        })
    }
}

impl Mass {
    /// The momenta about its origin that an angular velocity and a velocity of that origin give it.
    pub(super) fn momentum(&self, values: &mut Values, [spin, shift]: &[Triple; 2]) -> [Triple; 2] {
        let arm = cross(values, &self.first, shift);
        let p = &self.second;
        let turned: Triple = std::array::from_fn(|i| {
            let (j, k) = ((i + 1) % 3, (i + 2) % 3);
            // tr(P) - P.
            let moment = sum(values, &[p[j][j], p[k][k]]);
            let minus = [p[i][j], p[i][k]].map(|x| values.negate(x));
            inner(values, &[(moment, spin[i]), (minus[0], spin[j]), (minus[1], spin[k])])
        });
        let swept = cross(values, spin, &self.first);
        let carried = shift.map(|x| product(values, self.mass, x));
        [add(values, &turned, &arm), add(values, &swept, &carried)]
    }

    /// In the frame before its link's, about the same place.
    pub(super) fn turned(&self, values: &mut Values, link: &LinkValues) -> Mass {
        let first = apply(values, &link.turn, &self.first);
        Mass { mass: self.mass, first, second: link.rotated(values, &self.second) }
    }

    /// About an origin from which its own stands at r: h + M r, P + r s' + s r' with s = h + M r/2.
    pub(super) fn moved(&self, values: &mut Values, r: &Triple) -> Mass {
        let (half, two) = (values.constant(0.5), values.constant(2.0));
        let carried = r.map(|x| product(values, self.mass, x));
        let middle: Triple = std::array::from_fn(|i| {
            let half = product(values, half, carried[i]);
            sum(values, &[self.first[i], half])
        });
        let second = symmetric(|(i, j)| {
            let mixed = if i == j {
                let doubled = product(values, two, r[i]);
                product(values, doubled, middle[i])
            } else {
                inner(values, &[(r[i], middle[j]), (r[j], middle[i])])
            };
            sum(values, &[self.second[i][j], mixed])
        });
        Mass { mass: self.mass, first: add(values, &self.first, &carried), second }
    }

    pub(super) fn add(&self, values: &mut Values, other: &Mass) -> Mass {
        Mass {
            mass: sum(values, &[self.mass, other.mass]),
            first: add(values, &self.first, &other.first),
            second: symmetric(|(i, j)| sum(values, &[self.second[i][j], other.second[i][j]])),
        }
    }
}

/// A symmetric matrix, each entry computed once.
pub(super) fn symmetric(entry: impl FnMut((usize, usize)) -> Value) -> Matrix {
    let entries = [(0, 0), (1, 1), (2, 2), (1, 2), (0, 2), (0, 1)].map(entry);
    std::array::from_fn(|i| std::array::from_fn(|j| entries[if i == j { i } else { 6 - i - j }]))
}
