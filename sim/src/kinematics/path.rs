//! The curve F(q, p) = 0, followed by its arc length, so that a dead point of the drive is a point like any other.
//!
//! Keller, Numerical solution of bifurcation and nonlinear eigenvalue problems (1977); Allgower and Georg, Introduction
//! to Numerical Continuation Methods (SIAM 2003), ch. 2, 5 and 8. Steps are as long as the direction of the curve allows and
//! know nothing of what is recorded. One is made when the curve over it is a polynomial to rounding, with every node on the
//! curve: what was stepped over cannot be another branch then.

use super::algebra::{bordered, is_rounding, least_squares, singular_values};
use super::crossing::{crossings, find_dip};
use super::motion::Beside;
use super::series::{Series, nodes};
use super::sizes::Sizes;
use super::system::System;
use crate::failure::{Failure, What};
use crate::interpolate::cubic;
use crate::root::find_root;
use nalgebra::{DMatrix, DVector};
use std::cell::OnceCell;
use std::convert::Infallible;

/// Newton steps of a correction.
pub(super) const MOST_CORRECTIONS: usize = 12;
/// What steps may be off at first and turn; longer ones might lead to another branch.
const ALONG: Limits = Limits { correction: 0.1, cosine: 0.98 };
/// The longest step: about so much of a turn that a step of a crank is a fiftieth of it or less.
const LONGEST_STEP: f64 = 0.25;
/// A step this small is given up.
const SMALLEST_STEP: f64 = 1e-9;
/// A step to where the curve ends need not be shorter.
const SHORT: f64 = 1e-3;
/// The last coefficients of a curve that is a polynomial to rounding, and what they may be where rounding is amplified.
const RESOLVED: f64 = 1e-12;
const LEAST_RESOLVED: f64 = 1e-9;
/// A step so short may have a corner in it, as a table has or a modulus, and this part of it may be no polynomial.
const SHORTEST: f64 = 1e-6;
const CORNER: f64 = 0.01;
/// How far from the middle of a step another branch may cross: nodes are 0.13 of half a step away. Of several their middle
/// counts, if they lie so near to each other that most nodes are far from all of them.
const CENTRED: f64 = 0.02;
const TOGETHER: f64 = 0.5;
/// Half of the length of a step about a crossing, or a part of it, and how often it is laid anew. It is as long as may be:
/// rounding is amplified by the square of the distance, and the motion is known from the ends of the step.
const AROUND: f64 = 0.8;
const MOST_LAYINGS: usize = 4;
/// What such a step may turn, and be off at first: it is checked at every node.
const ACROSS: Limits = Limits { correction: 0.3, cosine: 0.88 };
/// Where rounding is amplified so much, another branch may cross nearby.
const NEAR: f64 = 1e3;
/// A point of the curve: z = (q, p), each in its size, and its unit tangent.
#[derive(Clone, Debug)]
pub(super) struct Point {
    pub(super) z: DVector<f64>,
    tangent: DVector<f64>,
    /// How far F_z is from a lower rank there, without units.
    pub(super) regularity: f64,
    /// How far rounding may be amplified there.
    condition: f64,
}

/// A step along the curve, for x from -1 to 1.
pub(super) struct Piece {
    pub(super) from: Point,
    pub(super) to: Point,
    length: f64,
    /// z(x).
    pub(super) curve: Vec<Series>,
    /// Where other branches cross, in order.
    pub(super) crossings: Vec<f64>,
    /// Where the drive turns back.
    pub(super) limit: Option<f64>,
    /// What is computed once of a step in which another branch crosses.
    pub(super) beside: OnceCell<Option<Vec<Beside>>>,
}

/// When a step is refused.
#[derive(Clone, Copy)]
struct Limits {
    /// The largest first correction, as a part of the step.
    correction: f64,
    /// The least cosine between the tangents at both ends.
    cosine: f64,
}

/// A curve.
pub(super) struct Path<'s> {
    pub(super) system: &'s System<'s>,
    pub(super) sizes: Sizes,
    /// Where it ends, as p.
    pub(super) end: f64,
}

impl<'s> Path<'s> {
    /// The curve of a system from a position, for p from 0 to `end`.
    pub(super) fn new(system: &'s System<'s>, q: &[f64], end: f64) -> Path<'s> {
        Path { system, sizes: Sizes::new(system, q), end }
    }

    /// A position and its p.
    pub(super) fn place(&self, z: &DVector<f64>) -> (Vec<f64>, f64) {
        let n = z.len() - 1;
        (self.sizes.coordinates.iter().zip(z).map(|(size, z)| size * z).collect(), z[n] * self.sizes.parameter)
    }

    /// The position and p at a place of a step.
    pub(super) fn at(&self, piece: &Piece, x: f64) -> (Vec<f64>, f64) {
        self.place(&piece.z(x))
    }

    /// p at the end of a step.
    pub(super) fn reached(&self, piece: &Piece) -> f64 {
        self.place(&piece.to.z).1
    }

    /// Where the curve starts, with p growing.
    ///
    /// # Errors
    /// [`What::DriveSingular`] where the drive does not determine the motion.
    pub(super) fn start(&self, q: &[f64]) -> Result<Point, Failure> {
        let n = q.len();
        let z = DVector::from_fn(n + 1, |j, _| if j < n { q[j] / self.sizes.coordinates[j] } else { 0.0 });
        let along = DVector::from_fn(n + 1, |j, _| f64::from(u8::from(j == n)));
        let is_regular = |point: &Point| point.tangent[n] > 1e-9 && point.condition < 1e9;
        self.tangent(z, &along).filter(is_regular).ok_or_else(|| self.system.singular(q, 0.0))
    }

    /// The next step, of at most `length` where nothing is special; where another branch crosses, it does so in the middle.
    ///
    /// # Errors
    /// [`What::NotFollowed`] if no step is small enough.
    pub(super) fn next(&self, from: &Point, length: &mut f64) -> Result<Piece, Failure> {
        let (longest, to_the_end) = (length.min(LONGEST_STEP), self.to_the_end(from));
        let mut piece = self.followed(from, longest.min(to_the_end))?;
        // What is known of the motion beside a crossing is known from both sides of it, beyond the end too.
        if to_the_end < longest && piece.crossings.is_empty() && piece.to.condition >= NEAR {
            piece = self.followed(from, longest).unwrap_or(piece);
        }
        *length = 1.5 * piece.length;
        Ok(self.with_limit(piece))
    }

    /// A step of at most this length, or one over a crossing.
    fn followed(&self, from: &Point, longest: f64) -> Result<Piece, Failure> {
        let mut tried = longest;
        while tried > SMALLEST_STEP {
            let Some(piece) = self.step(from, tried, ALONG) else {
                tried /= 2.0;
                continue;
            };
            let found = match find_dip(self, &piece) {
                Some(dip) if dip.is_crossing => self.across(from, tried * (1.0 + dip.x) / 2.0),
                Some(dip) if !dip.is_closed && dip.x <= 1.0 => None,
                _ => Some(piece),
            };
            if let Some(piece) = found {
                return Ok(piece);
            }
            tried /= 2.0;
        }
        let (q, p) = self.place(&from.z);
        let (mechanism, driven) = (self.system.mechanism, self.system.drive());
        Err(mechanism.failure(What::NotFollowed { driven }, self.system.time(p), &q))
    }

    /// A step with a crossing in its middle, or several near to each other, that is about so far ahead of a point, or one that
    /// ends well before it; `None` where the branch does not go straight on. It may begin before the point, never beyond it.
    fn across(&self, from: &Point, mut ahead: f64) -> Option<Piece> {
        let mut half = AROUND;
        while half > SMALLEST_STEP {
            if half < 0.9 * ahead {
                return self.step(from, ahead - half, ALONG);
            }
            // What a step foretold is a little off: the middle is met in a few trials.
            for _ in 0..MOST_LAYINGS {
                let around = half.max(ahead);
                let Some(mut piece) =
                    self.behind(from, around - ahead).and_then(|base| self.step(&base, 2.0 * around, ACROSS))
                else {
                    break;
                };
                let found = crossings(self, &piece);
                let (Some(first), Some(last)) = (found.first(), found.last()) else { break };
                let are_together = last.x - first.x <= TOGETHER;
                let middle = if are_together { (first.x + last.x) / 2.0 } else { first.x };
                let is_centred = middle.abs() <= CENTRED;
                let is_earlier_crossing = from.tangent.dot(&(&piece.to.z - &from.z)) < half / 2.0;
                if is_centred && are_together && !is_earlier_crossing {
                    piece.crossings = found.iter().map(|dip| dip.x).collect();
                    return found.iter().all(|dip| dip.is_closed).then_some(piece);
                }
                if is_centred || ahead + around * middle <= 0.0 {
                    break;
                }
                ahead += around * middle;
            }
            half /= 2.0;
        }
        None
    }

    /// The point of the curve so far behind another.
    fn behind(&self, point: &Point, distance: f64) -> Option<Point> {
        if distance <= SMALLEST_STEP {
            return Some(point.clone());
        }
        let back = Point { tangent: -&point.tangent, ..point.clone() };
        let found = self.step(&back, distance, ACROSS)?.to;
        Some(Point { tangent: -found.tangent, ..found })
    }

    /// About how far it is to the end of the curve.
    fn to_the_end(&self, from: &Point) -> f64 {
        let n = from.z.len() - 1;
        let left = self.end / self.sizes.parameter - from.z[n];
        (1.02 * left / from.tangent[n]).max(SHORT)
    }

    /// A step of this length, if it is short enough.
    fn step(&self, from: &Point, length: f64, limits: Limits) -> Option<Piece> {
        let (z, first) = self.correct(from, &from.z + length * &from.tangent, length)?;
        if first > limits.correction * length {
            return None;
        }
        let to = self.tangent(z, &from.tangent)?;
        if !(to.tangent.dot(&from.tangent) > limits.cosine) {
            return None;
        }
        let curve = self.curve(from, &to, length, limits)?;
        Some(Piece {
            from: from.clone(),
            to,
            length,
            curve,
            crossings: Vec::new(),
            limit: None,
            beside: OnceCell::new(),
        })
    }

    /// The curve between two points, if it is a polynomial to rounding.
    fn curve(&self, from: &Point, to: &Point, length: f64, limits: Limits) -> Option<Vec<Series>> {
        let slope = |point: &Point, j: usize| length * point.tangent[j] / from.tangent.dot(&point.tangent);
        let between = |j: usize, s: f64| cubic([from.z[j], to.z[j]], [slope(from, j), slope(to, j)], s);
        let node = |x: f64| {
            let s = (1.0 + x) / 2.0;
            let guess = DVector::from_fn(from.z.len(), |j, _| between(j, s));
            let (z, _) = self.correct(from, guess.clone(), s * length)?;
            ((&z - guess).norm() <= limits.correction * length).then_some(z)
        };
        let places: Vec<DVector<f64>> = nodes().into_iter().map(node).collect::<Option<_>>()?;
        let series = |j: usize| Series::through(std::array::from_fn(|k: usize| places[k][j]));
        let curve: Vec<Series> = (0..from.z.len()).map(series).collect();
        let rounding = 16.0 * f64::EPSILON * from.condition.max(to.condition) * (1.0 + from.z.amax());
        let corner = if length <= SHORTEST { CORNER * length } else { 0.0 };
        let bound = (RESOLVED + rounding).min(LEAST_RESOLVED).max(corner);
        curve.iter().all(|series| series.tail() <= bound).then_some(curve)
    }

    /// The point of the curve at this distance along the tangent of another, and the size of the first correction.
    fn correct(&self, from: &Point, mut z: DVector<f64>, length: f64) -> Option<(DVector<f64>, f64)> {
        let (mut first, mut last) = (None, f64::INFINITY);
        for _ in 0..MOST_CORRECTIONS {
            let (values, jacobian) = self.linear(&z);
            let ahead = from.tangent.dot(&(&z - &from.z)) - length;
            let m = values.len();
            let change = least_squares(bordered(jacobian, &from.tangent), values.insert_row(m, ahead))?;
            z -= &change;
            let size = change.norm();
            first = first.or(Some(size));
            if is_rounding(size, last, &z) {
                return first.map(|first| (z, first));
            }
            if !(size < last) {
                return None;
            }
            last = size;
        }
        None
    }

    /// F and F_z, without units.
    pub(super) fn linear(&self, z: &DVector<f64>) -> (DVector<f64>, DMatrix<f64>) {
        let (q, p) = self.place(z);
        let (n, sizes, linear) = (q.len(), &self.sizes, self.system.linear(&q, p));
        let jacobian = DMatrix::from_fn(linear.values.len(), n + 1, |i, j| match j < n {
            true => linear.jacobian[(i, j)] * sizes.coordinates[j] / sizes.rows[i],
            false => linear.by_parameter[i] * sizes.parameter / sizes.rows[i],
        });
        (DVector::from_fn(linear.values.len(), |i, _| linear.values[i] / sizes.rows[i]), jacobian)
    }

    /// A point with its tangent, in the direction of another.
    fn tangent(&self, z: DVector<f64>, along: &DVector<f64>) -> Option<Point> {
        let (values, jacobian) = self.linear(&z);
        let singular = singular_values(&jacobian)?;
        let rhs = DVector::zeros(values.len()).insert_row(values.len(), 1.0);
        let tangent = least_squares(bordered(jacobian, along), rhs)?.normalize();
        let regularity = singular[z.len() - 2];
        let point = Point { z, tangent, regularity, condition: singular[0] / regularity };
        point.tangent.iter().all(|entry| entry.is_finite()).then_some(point)
    }

    /// How far F_z is from a lower rank at a place of a step, without units.
    pub(super) fn regularity(&self, piece: &Piece, x: f64) -> f64 {
        let z = piece.z(x);
        singular_values(&self.linear(&z).1).map_or(0.0, |values| values[z.len() - 2])
    }

    /// The logarithm of the product of the singular values of F_z at a place of a step, without units.
    pub(super) fn volume(&self, piece: &Piece, x: f64) -> f64 {
        let z = piece.z(x);
        let logarithm = |values: DVector<f64>| values.iter().take(z.len() - 1).map(|value| value.ln()).sum();
        singular_values(&self.linear(&z).1).map_or(f64::NEG_INFINITY, logarithm)
    }

    /// How far the equations are open at a place of a step, without units.
    pub(super) fn open(&self, piece: &Piece, x: f64) -> f64 {
        self.linear(&piece.z(x)).0.amax()
    }

    /// A step with the limit position in it, if there is one.
    fn with_limit(&self, mut piece: Piece) -> Piece {
        let n = piece.from.z.len() - 1;
        piece.limit = piece.curve[n].turns().first().map(|turn| self.limit(&piece, *turn));
        piece
    }

    /// The place of a limit position near one: where the tangent has no part along p.
    fn limit(&self, piece: &Piece, near: f64) -> f64 {
        let n = piece.from.z.len() - 1;
        let along = |x: f64| {
            let length = piece.length * (1.0 + x) / 2.0;
            let point =
                self.correct(&piece.from, piece.z(x), length).and_then(|(z, _)| self.tangent(z, &piece.from.tangent));
            point.map_or(f64::NAN, |point| point.tangent[n])
        };
        let width = 1e-3;
        let place = |s: f64| near + width * (2.0 * s - 1.0);
        let [before, after] = [along(place(0.0)), along(place(1.0))];
        if !(before > 0.0 && after < 0.0) {
            return near;
        }
        find_root(before, after, 1e-13, &mut |s| Ok::<f64, Infallible>(along(place(s)))).map_or(near, place)
    }

    /// A point of the curve some way before another, if branches may cross near that: what is known of the motion beside a
    /// crossing is known from both sides of it.
    pub(super) fn before(&self, point: Point) -> Point {
        if point.condition < NEAR {
            return point;
        }
        let lengths = (0..8).map(|halvings| AROUND / f64::from(1 << halvings));
        lengths.into_iter().find_map(|length| self.behind(&point, length)).unwrap_or(point)
    }
}

impl Piece {
    /// How far rounding may be amplified at its ends.
    pub(super) fn condition(&self) -> f64 {
        self.from.condition.max(self.to.condition)
    }

    pub(super) fn z(&self, x: f64) -> DVector<f64> {
        DVector::from_fn(self.curve.len(), |j, _| self.curve[j].at(x))
    }
}
