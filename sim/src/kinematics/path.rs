//! The curve F(q, p) = 0, followed by its arc length, so that a dead point of the drive is a point like any other.
//!
//! Keller, Numerical solution of bifurcation and nonlinear eigenvalue problems (1977); Allgower and Georg, Introduction
//! to Numerical Continuation Methods (SIAM 2003), ch. 2, 5 and 8: where the component of the tangent along p changes sign
//! the curve turns back (a limit position); where det [F_z; tangent'] does, another branch crosses it.

use super::system::System;
use crate::failure::{Failure, What};
use crate::root::find_root;
use nalgebra::{DMatrix, DVector};

/// Newton steps of a correction.
const MOST_CORRECTIONS: usize = 12;
/// The first correction of a step, as a part of it, beyond which the step is refused: it might lead to another branch.
const LARGEST_CORRECTION: f64 = 0.1;
/// The least cosine between the tangents at both ends of a step.
const STRAIGHT: f64 = 0.98;
/// A step this small, as a part of the longest, is given up.
const SMALLEST_STEP: f64 = 1e-10;
/// The longest step, as a part of the range of p.
const LONGEST_STEP: f64 = 0.02;
/// To what special positions are located, as a part of a step.
const PLACE: f64 = 1e-14;

/// A point of the curve: z = (q, w p), its unit tangent, and the sign of det [F_z; tangent'].
#[derive(Clone, Debug)]
pub(super) struct Point {
    z: DVector<f64>,
    tangent: DVector<f64>,
    orientation: f64,
}

/// A step along the curve.
pub(super) struct Span<'a> {
    from: &'a Point,
    to: &'a Point,
    length: f64,
}

/// A place where the curve is special.
#[derive(Clone, Debug)]
pub(super) enum Special {
    /// The drive cannot go further.
    Limit,
    /// Another branch crosses.
    Branch,
}

/// A curve, and how p is scaled on it.
pub(super) struct Path<'s> {
    system: &'s System<'s>,
    /// w: the largest rate of a drive, so that p weighs what it moves.
    weight: f64,
    longest: f64,
}

impl<'s> Path<'s> {
    /// The curve of a system, for p from 0 to `end`.
    pub(super) fn new(system: &'s System<'s>, end: f64) -> Path<'s> {
        let weight = system.laws.iter().fold(0.0f64, |most, law| most.max(law.rate.abs())).max(f64::MIN_POSITIVE);
        Path { system, weight, longest: LONGEST_STEP * weight * end }
    }

    pub(super) fn place(&self, point: &Point) -> (Vec<f64>, f64) {
        self.split(&point.z)
    }

    fn split(&self, z: &DVector<f64>) -> (Vec<f64>, f64) {
        let n = z.len() - 1;
        (z.as_slice()[..n].to_vec(), z[n] / self.weight)
    }

    /// Where the curve starts, with p growing.
    ///
    /// # Errors
    /// [`What::DriveSingular`] where the drive does not determine the motion.
    pub(super) fn start(&self, q: &[f64]) -> Result<Point, Failure> {
        let n = q.len();
        let z = DVector::from_fn(n + 1, |j, _| if j < n { q[j] } else { 0.0 });
        let along = DVector::from_fn(n + 1, |j, _| f64::from(u8::from(j == n)));
        let point = self.tangent(z, &along).filter(|point| point.tangent[n] > 1e-9);
        point.ok_or_else(|| self.system.singular(q, 0.0))
    }

    /// The next point, at most `length` away.
    ///
    /// # Errors
    /// [`What::NotFollowed`] if no step is small enough.
    pub(super) fn next(&self, from: &Point, length: &mut f64) -> Result<(Point, f64), Failure> {
        *length = length.min(self.longest);
        loop {
            if let Some(to) = self.step(from, *length) {
                let taken = *length;
                *length *= 1.5;
                return Ok((to, taken));
            }
            *length /= 2.0;
            if !(*length > SMALLEST_STEP * self.longest) {
                let (q, p) = self.place(from);
                let mechanism = self.system.mechanism;
                let driven = self.system.laws[0].driven.quantity(mechanism.description()).name;
                return Err(mechanism.failure(What::NotFollowed { driven }, self.system.time(p), &q));
            }
        }
    }

    pub(super) fn first_length(&self) -> f64 {
        self.longest
    }

    fn step(&self, from: &Point, length: f64) -> Option<Point> {
        let (z, first) = self.correct(from, &from.z + length * &from.tangent, length)?;
        if first > LARGEST_CORRECTION * length {
            return None;
        }
        let to = self.tangent(z, &from.tangent)?;
        (to.tangent.dot(&from.tangent) > STRAIGHT).then_some(to)
    }

    /// The point of the curve at this distance along the tangent of another, and the size of the first correction.
    fn correct(&self, from: &Point, mut z: DVector<f64>, length: f64) -> Option<(DVector<f64>, f64)> {
        let n = z.len() - 1;
        let (mut first, mut last) = (None, f64::INFINITY);
        for _ in 0..MOST_CORRECTIONS {
            let (q, p) = self.split(&z);
            let values = self.system.linear(&q, p).values;
            let ahead = from.tangent.dot(&(&z - &from.z)) - length;
            let rhs = DVector::from_fn(n + 1, |i, _| if i < n { values[i] } else { ahead });
            let change = self.bordered(&z, &from.tangent).lu().solve(&rhs)?;
            z -= &change;
            let size = change.norm();
            first = first.or(Some(size));
            let floor = 4.0 * f64::EPSILON * (1.0 + z.norm());
            // Corrections that no longer shrink are rounding.
            if size <= floor || (size <= 1e3 * floor && size >= 0.25 * last) {
                return first.map(|first| (z, first));
            }
            if !(size < last) {
                return None;
            }
            last = size;
        }
        None
    }

    /// [F_q, F_p / w; along'].
    fn bordered(&self, z: &DVector<f64>, along: &DVector<f64>) -> DMatrix<f64> {
        let n = z.len() - 1;
        let (q, p) = self.split(z);
        let linear = self.system.linear(&q, p);
        DMatrix::from_fn(n + 1, n + 1, |i, j| match (i < n, j < n) {
            (false, _) => along[j],
            (true, true) => linear.jacobian[(i, j)],
            (true, false) => linear.by_parameter[i] / self.weight,
        })
    }

    /// A point with its tangent, in the direction of another.
    fn tangent(&self, z: DVector<f64>, along: &DVector<f64>) -> Option<Point> {
        let n = z.len() - 1;
        let last = DVector::from_fn(n + 1, |i, _| f64::from(u8::from(i == n)));
        let tangent = self.bordered(&z, along).lu().solve(&last)?.normalize();
        if tangent.iter().any(|entry| !entry.is_finite()) {
            return None;
        }
        let orientation = self.bordered(&z, &tangent).determinant().signum();
        Some(Point { z, tangent, orientation })
    }

    /// What is special in a step, and where.
    pub(super) fn special(&self, span: &Span) -> Option<(Special, Vec<f64>, f64)> {
        let n = span.from.z.len() - 1;
        let (kind, [before, after]) = if span.from.orientation != span.to.orientation {
            (Special::Branch, [span.from.orientation, span.to.orientation])
        } else if span.to.tangent[n] <= 0.0 {
            (Special::Limit, [span.from.tangent[n], span.to.tangent[n]])
        } else {
            return None;
        };
        let value = |fraction: f64| {
            let point = self.inside(span, fraction);
            match kind {
                Special::Limit => point.tangent[n],
                Special::Branch => self.bordered(&point.z, &point.tangent).determinant() * before.signum(),
            }
        };
        let ends = match kind {
            Special::Limit => [before, after],
            Special::Branch => [value(0.0), value(1.0)],
        };
        let found = find_root::<std::convert::Infallible>(ends[0], ends[1], PLACE, &mut |fraction| Ok(value(fraction)));
        let fraction = found.unwrap_or(1.0);
        let (q, p) = self.place(&self.inside(span, fraction));
        Some((kind, q, p))
    }

    /// The point of the curve inside a step; next to a crossing branch, where none can be found, that of the cubic through
    /// both ends.
    fn inside(&self, span: &Span, fraction: f64) -> Point {
        let guess = span.cubic(fraction);
        let length = span.from.tangent.dot(&(&guess - &span.from.z));
        let close = |z: &DVector<f64>| (z - &guess).norm() <= LARGEST_CORRECTION * span.length;
        let z = self.correct(span.from, guess.clone(), length).map(|(z, _)| z).filter(close).unwrap_or(guess.clone());
        let along = span.from.tangent.lerp(&span.to.tangent, fraction);
        self.tangent(z, &along).unwrap_or_else(|| Point {
            z: guess,
            tangent: along.normalize(),
            orientation: span.to.orientation,
        })
    }

    /// The position in a step at a given p; `None` if it is singular there.
    pub(super) fn at(&self, span: &Span, p: f64) -> Option<Vec<f64>> {
        let n = span.from.z.len() - 1;
        let wanted = self.weight * p;
        let mut ahead = |fraction: f64| Ok::<f64, std::convert::Infallible>(span.cubic(fraction)[n] - wanted);
        let ends = [span.from.z[n] - wanted, span.to.z[n] - wanted];
        let fraction = match () {
            _ if ends[0] == 0.0 => 0.0,
            _ if ends[1] == 0.0 => 1.0,
            _ => find_root(ends[0], ends[1], PLACE, &mut ahead).unwrap_or(1.0),
        };
        let guess = self.inside(span, fraction);
        let (q, _) = self.place(&guess);
        self.at_parameter(&q, p, LARGEST_CORRECTION * span.length)
    }

    /// The solution at a given p, next to a guess, by Newton's method; `None` if it is further away than allowed.
    pub(super) fn at_parameter(&self, guess: &[f64], p: f64, furthest: f64) -> Option<Vec<f64>> {
        let mut q = guess.to_vec();
        let mut last = f64::INFINITY;
        for _ in 0..MOST_CORRECTIONS {
            let linear = self.system.linear(&q, p);
            let change = linear.jacobian.lu().solve(&linear.values)?;
            q.iter_mut().zip(&change).for_each(|(q, change)| *q -= change);
            let size = change.norm();
            let floor = 4.0 * f64::EPSILON * (1.0 + q.iter().map(|value| value * value).sum::<f64>().sqrt());
            if size <= floor || (size <= 1e3 * floor && size >= 0.25 * last) {
                return Some(q);
            }
            if !(size < last.min(furthest)) {
                return None;
            }
            last = size;
        }
        None
    }
}

impl<'a> Span<'a> {
    pub(super) fn new(from: &'a Point, to: &'a Point, length: f64) -> Span<'a> {
        Span { from, to, length }
    }

    /// The cubic with the points and tangents of both ends.
    fn cubic(&self, s: f64) -> DVector<f64> {
        let r = 1.0 - s;
        let ends = &self.from.z * (1.0 + 2.0 * s) * r * r + &self.to.z * (3.0 - 2.0 * s) * s * s;
        ends + (&self.from.tangent * r - &self.to.tangent * s) * (s * r * self.length)
    }
}
