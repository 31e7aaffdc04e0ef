//! Newton's and Euler's equations along a tree (Luh, Walker and Paul, J. Dyn. Syst. Meas. Control 102, 1980; Featherstone, Rigid
//! Body Dynamics Algorithms, 2008, section 5.3).
//!
//! With B = [w'] + [w]^2, which takes points of a frame to their accelerations relative to its origin, a mass distribution needs
//! the force and the moment about the origin
//!
//! ```text
//! f = M a + B h,   n = h x a + vee(B P - P B')
//! ```
//!
//! Second moments in place of inertias: B is there already, for the origins of the links that follow.

use super::tree::{LinkTree, LinkValues, Mass};
use super::triple::{Matrix, Triple, add, apply, cross, difference, dot, inner, product, sum, transposed, zero};
use crate::program::values::{Value, Values};

/// The motion of a link, in its own frame.
pub(super) struct Motion {
    pub(super) spin: Triple,
    /// B.
    turning: Matrix,
    /// The acceleration of its origin less that of free fall.
    pub(super) proper: Triple,
    /// The rate of the components of `spin`.
    pub(super) spin_rate: Triple,
}

impl LinkTree {
    /// M q'' + h - Q of the links and their weights; without accelerations h - Q.
    pub(super) fn forces(&self, values: &mut Values, accelerations: Option<&[Value]>) -> Vec<Value> {
        let motions = self.motions(values, accelerations);
        let mut wrenches: Vec<[Vec<Triple>; 2]> = self.links.iter().map(|_| [vec![], vec![]]).collect();
        let mut forces: Vec<Vec<Value>> = vec![vec![]; self.coordinates];
        for (at, link) in self.links.iter().enumerate().rev() {
            let [mut moments, mut forces_on] = std::mem::take(&mut wrenches[at]);
            let [moment, force] = link.mass.wrench(values, &motions[at]);
            moments.push(moment);
            forces_on.push(force);
            let [moment, force] = [moments, forces_on].map(|all| total(values, &all));
            let pushed = apply(values, &link.turn, &force);
            for column in &link.columns {
                let (turning, shifting) = (dot(values, &column.spin, &moment), dot(values, &column.shift, &pushed));
                forces[column.coordinate].extend([turning, shifting]);
            }
            if let Some(before) = link.before {
                let [moment, force] = link.wrench_before(values, &[moment, force]);
                wrenches[before][0].push(moment);
                wrenches[before][1].push(force);
            }
        }
        forces.into_iter().map(|terms| sum(values, &terms)).collect()
    }

    /// The motion of each link; without accelerations where q'' = 0.
    pub(super) fn motions(&self, values: &mut Values, accelerations: Option<&[Value]>) -> Vec<Motion> {
        let none = zero(values);
        let mut motions: Vec<Motion> = Vec::with_capacity(self.links.len());
        for link in &self.links {
            let world = Motion {
                spin: none,
                turning: [none; 3],
                proper: link.gravity.map(|g| values.negate(g)),
                spin_rate: none,
            };
            let before = link.before.map_or(&world, |before| &motions[before]);
            motions.push(link.motion(values, before, accelerations));
        }
        motions
    }
}

pub(super) fn total(values: &mut Values, all: &[Triple]) -> Triple {
    std::array::from_fn(|i| sum(values, &all.iter().map(|v| v[i]).collect::<Vec<_>>()))
}

impl LinkValues {
    /// Its motion from that of the frame before.
    fn motion(&self, values: &mut Values, before: &Motion, accelerations: Option<&[Value]>) -> Motion {
        let back = transposed(&self.turn);
        let [relative_spin, mut relative_spin_rate] = self.spin;
        let [offset, offset_rate, mut offset_acceleration] = self.offset;
        for column in accelerations.iter().flat_map(|_| &self.columns) {
            let Some(given) = accelerations.and_then(|given| given.get(column.coordinate)) else { continue };
            for i in 0..3 {
                let (turned, shifted) =
                    (product(values, column.spin[i], *given), product(values, column.shift[i], *given));
                relative_spin_rate[i] = sum(values, &[relative_spin_rate[i], turned]);
                offset_acceleration[i] = sum(values, &[offset_acceleration[i], shifted]);
            }
        }
        // (S' w)' = S' w' + (S' w) x w_s
        let carried = apply(values, &back, &before.spin);
        let swept = cross(values, &carried, &relative_spin);
        let spin = add(values, &carried, &relative_spin);
        let carried_rate = apply(values, &back, &before.spin_rate);
        let spin_rate = std::array::from_fn(|i| sum(values, &[carried_rate[i], swept[i], relative_spin_rate[i]]));
        // a + B r + 2 w x r' + r''
        let two = values.constant(2.0);
        let doubled = offset_rate.map(|x| product(values, two, x));
        let coriolis = cross(values, &before.spin, &doubled);
        let turned = apply(values, &before.turning, &offset);
        let origin: Triple =
            std::array::from_fn(|i| sum(values, &[before.proper[i], turned[i], coriolis[i], offset_acceleration[i]]));
        Motion { turning: turning(values, &spin, &spin_rate), proper: apply(values, &back, &origin), spin, spin_rate }
    }
}

/// B = [w'] + [w]^2.
fn turning(values: &mut Values, w: &Triple, rate: &Triple) -> Matrix {
    let squares = w.map(|x| product(values, x, x));
    let products: Triple = std::array::from_fn(|i| product(values, w[(i + 1) % 3], w[(i + 2) % 3]));
    std::array::from_fn(|i| {
        std::array::from_fn(|j| {
            if i == j {
                let both = sum(values, &[squares[(i + 1) % 3], squares[(i + 2) % 3]]);
                return values.negate(both);
            }
            let other = 3 - i - j;
            match (j + 3 - i) % 3 {
                1 => difference(values, products[other], rate[other]),
                _ => sum(values, &[products[other], rate[other]]),
            }
        })
    })
}

impl Mass {
    /// The moment about the origin and the force that a motion takes.
    pub(super) fn wrench(&self, values: &mut Values, motion: &Motion) -> [Triple; 2] {
        let (b, p, w) = (&motion.turning, &self.second, &motion.spin);
        let arm = cross(values, &self.first, &motion.proper);
        let moment = std::array::from_fn(|i| {
            let (j, k) = ((i + 1) % 3, (i + 2) % 3);
            // (B P)_kj - (B P)_jk, in which P_jk has the factor B_kk - B_jj = w_k^2 - w_j^2.
            let squares = [w[k], w[j]].map(|x| product(values, x, x));
            let apart = difference(values, squares[0], squares[1]);
            let minus = [(b[j][i], p[i][k]), (b[j][k], p[k][k])].map(|(b, p)| (values.negate(b), p));
            let turned = inner(values, &[(b[k][i], p[i][j]), (b[k][j], p[j][j]), (apart, p[j][k]), minus[0], minus[1]]);
            sum(values, &[turned, arm[i]])
        });
        let turned = apply(values, b, &self.first);
        let force = std::array::from_fn(|i| {
            let carried = product(values, self.mass, motion.proper[i]);
            sum(values, &[turned[i], carried])
        });
        [moment, force]
    }
}
