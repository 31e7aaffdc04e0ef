//! The curve F(q, p) = 0, followed by its arc length, so that a dead point of the drive is a point like any other.
//!
//! Keller, Numerical solution of bifurcation and nonlinear eigenvalue problems (1977); Allgower and Georg, Introduction
//! to Numerical Continuation Methods (SIAM 2003), ch. 2, 5 and 8. Steps are as long as the direction of the curve
//! allows, independent of the recorded rows. A step is accepted when the curve over it is a polynomial to rounding,
//! with every node on the curve: then it cannot have stepped onto another branch.

use super::algebra::{bordered, dependence_of_rows, is_rounding, least_squares, singular_values};
use super::piece::{Piece, Point};
use super::series::{Series, nodes};
use super::sizes::Sizes;
use super::system::System;
use crate::numerics::cubic::cubic;
use crate::numerics::root::find_root;
use crate::state::failure::Failure;
use nalgebra::{DMatrix, DVector};
use std::cell::OnceCell;
use std::convert::Infallible;

/// Newton steps of a correction.
pub(super) const MOST_CORRECTIONS: usize = 12;
/// The largest first correction and turn of a step; longer steps might lead to another branch.
pub(super) const ALONG: Limits = Limits { correction: 0.1, cosine: 0.98 };
/// A step this small is given up.
pub(super) const SMALLEST_STEP: f64 = 1e-9;
/// The size of the last coefficients of a curve that is a polynomial to rounding, and their bound where rounding is
/// amplified.
const RESOLVED: f64 = 1e-12;
const LEAST_RESOLVED: f64 = 1e-9;
/// The length of a step that may contain a corner, as of a table or a modulus, and the allowed deviation from a
/// polynomial.
const SHORTEST: f64 = 1e-6;
const CORNER: f64 = 0.01;
/// The largest turn and first correction of such a step, which is checked at every node.
pub(super) const ACROSS: Limits = Limits { correction: 0.3, cosine: 0.88 };

/// When a step is refused.
#[derive(Clone, Copy)]
pub(super) struct Limits {
    /// The largest first correction, as a fraction of the step.
    correction: f64,
    /// The least cosine between the tangents at both ends.
    cosine: f64,
}

/// A curve.
pub(super) struct Path<'s> {
    pub(super) system: &'s System<'s>,
    pub(super) sizes: Sizes,
    /// Its end, as p.
    pub(super) end: f64,
}

impl<'s> Path<'s> {
    /// The curve of a system from a position, for p from 0 to `end`.
    pub(super) fn new(system: &'s System<'s>, q: &[f64], end: f64) -> Path<'s> {
        Path { system, sizes: Sizes::new(system, q, end), end }
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

    /// The start of the curve, with p growing.
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

    /// A step of this length, if it is short enough.
    pub(super) fn step(&self, from: &Point, length: f64, limits: Limits) -> Option<Piece> {
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

    /// The dimensionless distance of F_z from a lower rank at a place of a step.
    pub(super) fn regularity(&self, piece: &Piece, x: f64) -> f64 {
        let z = piece.z(x);
        singular_values(&self.linear(&z).1).map_or(0.0, |values| values[z.len() - 2])
    }

    /// The logarithm of the product of the dimensionless singular values of F_z at a place of a step.
    pub(super) fn volume(&self, piece: &Piece, x: f64) -> f64 {
        let z = piece.z(x);
        let logarithm = |values: DVector<f64>| values.iter().take(z.len() - 1).map(|value| value.ln()).sum();
        singular_values(&self.linear(&z).1).map_or(f64::NEG_INFINITY, logarithm)
    }

    /// The dimensionless residual of the equations at a place of a step.
    pub(super) fn open(&self, piece: &Piece, x: f64) -> f64 {
        self.linear(&piece.z(x)).0.amax()
    }

    /// Which law stands still in a limit position: the one that takes most part in the dependence of the rows of F_q on each other,
    /// which its motion contradicts.
    pub(super) fn stopped(&self, piece: &Piece, limit: f64) -> usize {
        let (_, jacobian) = self.linear(&piece.z(limit));
        let (rows, n) = (self.system.rows.len(), jacobian.ncols() - 1);
        let by_parameter = jacobian.column(n).into_owned();
        let Some(dependence) = dependence_of_rows(jacobian.remove_column(n)) else { return 0 };
        let part = |law: &usize| (dependence[rows + law] * by_parameter[rows + law]).abs();
        (0..self.system.laws.len()).max_by(|a, b| part(a).total_cmp(&part(b))).unwrap_or(0)
    }

    /// The place of a limit position near one: where the tangent has no part along p.
    pub(super) fn limit(&self, piece: &Piece, near: f64) -> f64 {
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
}
