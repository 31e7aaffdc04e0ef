//! Positions and motion at a place of the curve.

use super::algebra::{in_regular_directions, is_rounding, least_squares};
use super::beside::Beside;
use super::inverse::{AnyPrescribed, Factors, prescribed};
use super::path::{MOST_CORRECTIONS, Path};
use super::piece::Piece;
use super::series::nodes;
use crate::numerics::nearest::Known;
use crate::numerics::root::find_root;
use crate::state::failure::{Failure, What};
use nalgebra::DVector;
use std::convert::Infallible;

/// The distance from a crossing, in half steps, within which the motion is taken from the nodes around it.
const BESIDE: f64 = 0.5;
/// The distance within which the drive itself leaves reactions undetermined.
const AT: f64 = 1e-9;
/// The number of nodes needed around crossings.
const FEWEST: usize = 8;
/// The largest distance from a position of the curve to the one found for a value of p.
const SAME: f64 = 1e-6;
/// The largest residual of a constraint, relative to its terms.
const CLOSED: f64 = 1e-12;

impl Piece {
    fn is_beside_crossing(&self, x: f64) -> bool {
        self.to_crossing(x) < BESIDE
    }

    /// The distance to the nearest crossing, in half steps.
    fn to_crossing(&self, x: f64) -> f64 {
        self.crossings.iter().fold(f64::INFINITY, |least, crossing| least.min((x - crossing).abs()))
    }
}

impl Path<'_> {
    /// The place in a step where p has a value.
    pub(super) fn locate(&self, piece: &Piece, p: f64) -> f64 {
        let (n, last) = (piece.curve.len() - 1, piece.limit.unwrap_or(1.0));
        let place = |s: f64| s * (1.0 + last) - 1.0;
        let mut short = |s: f64| Ok::<f64, Infallible>(piece.curve[n].at(place(s)) - p / self.sizes.parameter);
        let Ok([first, end]) = short(0.0).and_then(|first| Ok([first, short(1.0)?]));
        match () {
            _ if first >= 0.0 => -1.0,
            _ if end <= 0.0 => last,
            _ => find_root(first, end, 1e-15, &mut short).map_or(last, place),
        }
    }

    /// The position at a value of p that a step has at x; `None` if p does not determine it, or if it is elsewhere.
    pub(super) fn solve(&self, piece: &Piece, x: f64, p: f64) -> Option<Vec<f64>> {
        let n = piece.curve.len() - 1;
        let is_beside = piece.is_beside_crossing(x);
        let mut z = piece.z(x);
        let guess = z.clone();
        z[n] = p / self.sizes.parameter;
        let mut last = f64::INFINITY;
        for _ in 0..MOST_CORRECTIONS {
            let (values, jacobian) = self.linear(&z);
            let change = match is_beside {
                false => least_squares(jacobian.remove_column(n), values)?,
                true => in_regular_directions(jacobian.remove_column(n), &values)?,
            };
            z.rows_mut(0, n).axpy(-1.0, &change, 1.0);
            let size = change.norm();
            if is_rounding(size, last, &z) {
                let same = (&z - &guess).norm() <= SAME * (1.0 + guess.amax());
                let mut q = DVector::from_vec(self.place(&z).0);
                self.system.prescribe(|k| self.system.laws[k].at(p), &mut q);
                return same.then(|| q.as_slice().to_vec());
            }
            if !(size < last) {
                return None;
            }
            last = size;
        }
        None
    }

    /// A value of p within the sweep, snapped to an end within rounding.
    pub(super) fn within(&self, p: f64) -> f64 {
        let ends = [0.0, self.end];
        ends.into_iter().find(|end| (p - end).abs() <= 1e-13 * self.end).unwrap_or(p)
    }

    /// The motion at a place of a step, where p has this value.
    ///
    /// # Errors
    /// [`What::DriveSingular`] where the drive does not determine it, [`What::NotProjected`], [`What::NotFinite`].
    pub(super) fn motion(&self, piece: &Piece, x: f64, p: f64) -> Result<AnyPrescribed, Failure> {
        let Some(q) = self.solve(piece, x, p) else { return Err(self.system.singular(&self.at(piece, x).0, p)) };
        self.check(&q, p)?;
        match piece.is_beside_crossing(x) {
            false => prescribed(self.system, &self.sizes, (&q, p), &[]),
            true => self.beside(piece, x, (q, p)),
        }
    }

    /// The motion at a place of a step, for any p.
    ///
    /// # Errors
    /// As [`Path::motion`].
    pub(super) fn motion_at(&self, piece: &Piece, x: f64) -> Result<AnyPrescribed, Failure> {
        let (_, p) = self.at(piece, x);
        self.motion(piece, x, p)
    }

    /// Checks that all constraints hold, redundant ones too.
    fn check(&self, q: &[f64], p: f64) -> Result<(), Failure> {
        let (system, linear) = (self.system, self.system.linear(q, p));
        let (mechanism, time) = (system.mechanism, system.time(p));
        let magnitudes = mechanism.constraint_magnitudes(time, q);
        let rounding = |k: usize, row: usize| {
            let moved: f64 = linear.jacobian.row(k).iter().zip(q).map(|(c, q)| (c * q).abs()).sum();
            8.0 * f64::EPSILON * (magnitudes[row] + moved) + CLOSED * self.sizes.rows[k]
        };
        let is_open = |(k, row): &(usize, &usize)| !(linear.values[*k].abs() <= rounding(*k, **row));
        let Some((k, row)) = system.rows.iter().enumerate().find(is_open) else { return Ok(()) };
        let (constraint, residual) = (mechanism.constraint_name(*row), linear.values[k]);
        Err(mechanism.failure(What::NotProjected { constraint, residual, iterations: 1 }, time, q))
    }

    /// The motion beside a crossing, where the equations do not determine it or amplify rounding: it goes straight on,
    /// as the polynomial nearest to the nodes on both sides. A reaction that grows without bound towards the crossing, or the part of
    /// the motion by time alone, is taken from the equations, and is infinite in it.
    fn beside(&self, piece: &Piece, x: f64, (q, p): (Vec<f64>, f64)) -> Result<AnyPrescribed, Failure> {
        let singular = || self.system.singular(&q, p);
        let beside = piece.beside.get_or_init(|| self.nodes(piece)).as_ref().ok_or_else(singular)?;
        let direct =
            if piece.to_crossing(x) > AT { prescribed(self.system, &self.sizes, (&q, p), &[]).ok() } else { None };
        let direct = direct.map(|found| numbers(&found));
        let (n, m) = (q.len(), self.system.mechanism.description().constraints.len());
        let value = |(k, beside): (usize, &Beside)| match k >= 2 * n && beside.has_pole {
            false => beside.at(x).0,
            true => direct.as_ref().map_or(f64::INFINITY, |direct| direct[k]),
        };
        let values: Vec<f64> = beside.iter().enumerate().map(value).collect();
        let factors = Factors::new(&self.system.linear(&q, p).jacobian, &self.sizes);
        let found = AnyPrescribed {
            parameter: p,
            time: self.system.time(p),
            positions: q,
            direction: values[..n].to_vec(),
            speeds: if self.system.rests { vec![0.0; n] } else { values[..n].to_vec() },
            accelerations: values[n..2 * n].to_vec(),
            drift: values[2 * n..3 * n].to_vec(),
            multipliers: values[3 * n..3 * n + m].to_vec(),
            power: 0.0,
            forces: values[3 * n + m..].to_vec(),
            volume: factors.volume,
            columns: factors.columns,
        };
        Ok(found.with_power(self.system))
    }

    /// Speeds, accelerations, drifts, multipliers and forces at the nodes of a step, of which rounding amplifies those near a
    /// crossing by the inverse square of the regularity there.
    fn nodes(&self, piece: &Piece) -> Option<Vec<Beside>> {
        let at = |x: f64| {
            let (_, p) = self.at(piece, x);
            let q = self.solve(piece, x, p)?;
            let values = numbers(&prescribed(self.system, &self.sizes, (&q, p), &[]).ok()?);
            Some((x, self.regularity(piece, x).powi(4), values))
        };
        let nodes: Vec<(f64, f64, Vec<f64>)> = nodes().into_iter().filter_map(at).collect();
        let known = |k: usize| nodes.iter().map(move |(x, weight, values)| (*x, *weight, values[k]));
        let known = |k: usize| known(k).map(|(fraction, weight, value)| Known { fraction, weight, values: [value] });
        let beside = |k: usize| Beside::new(known(k).collect(), &piece.crossings);
        (nodes.len() >= FEWEST).then(|| (0..nodes[0].2.len()).map(beside).collect())
    }
}

/// The parts of a motion that are known from both sides of a crossing: the first two pass it smoothly.
fn numbers(found: &AnyPrescribed) -> Vec<f64> {
    [&found.direction[..], &found.accelerations, &found.drift, &found.multipliers, &found.forces].concat()
}
