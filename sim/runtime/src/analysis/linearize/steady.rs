//! Whether a motion is steady in its coordinates, that is, whether its linearisation is constant.

use super::derivatives::Derivatives;
use super::reduce::Reduction;
use super::{columns, matrix};
use crate::model::{AnyMechanism, At, Differentiable};
use crate::motion::lengths::measure;
use crate::motion::typed::Any;
use crate::state::failure::Failure;
use nalgebra::{Complex, DMatrix};
use sim_kernel::Mechanism;

/// The relative change of A, while the fastest mode turns by 1 rad, below which the motion is steady: starts are given
/// in some six digits.
const STEADY: f64 = 1e-6;
/// The step of differences in time, in the time in which the fastest mode turns by 1 rad. Second-order differences,
/// which a motion from rest needs, then have a rounding error of 1e-7 if A itself is computed by differences.
const STEP: f64 = 1e-2;
/// Later times at which what rests is asked for once more, likewise and in seconds.
const LATER: [f64; 3] = [0.37, 1.3, 11.7];
/// The change of an entry of A beside the largest of its row, by a motion of a hundredth of its own time or by time alone, up to which
/// it counts as constant.
const CONSTANT: f64 = 1e-5;
/// Changes of accelerations up to this do not count, in radians and in the mechanism's own length per s^2, nor those up to this
/// times the square of the rate.
const AT_REST: f64 = 1e-8;
const ROUNDING: f64 = 1e-13;

/// The coordinates that do not move uniformly, where A changes along the motion; nothing where it does not. There are none at
/// rest, where what acts changes with time itself.
///
/// A steady motion moves along coordinates that nothing depends on, at constant speeds, and has an A that is constant.
pub(super) fn unsteady(
    derivatives: &Derivatives,
    reduction: &Reduction,
    a: &DMatrix<f64>,
    eigenvalues: &[Complex<f64>],
) -> Result<Option<Vec<usize>>, Failure> {
    let (mechanism, at) = (derivatives.mechanism(), derivatives.state());
    let sizes = measure(mechanism, at.time, at.positions).0;
    let parts = |values: &[f64]| -> Vec<f64> { values.iter().zip(&sizes).map(|(v, size)| v.abs() / size).collect() };
    let (speeds, accelerations) = (parts(at.speeds), parts(derivatives.accelerations()));
    // The rates of the motion alone, and of all that may happen, in 1/s.
    let own = speeds.iter().copied().chain(accelerations.iter().map(|a| a.sqrt())).fold(0.0, f64::max);
    let rate = eigenvalues.iter().map(|value| value.norm()).fold(own, f64::max);
    let is_still = |parts: &[f64], least: f64| parts.iter().all(|part| *part <= least);
    let beside = Beside { derivatives, reduction, a, sizes: &sizes, rate: own };
    let is_at_rest = is_still(&speeds, STEADY * rate)
        && is_still(&accelerations, STEADY * rate * rate)
        && beside.rests(&accelerations);
    if is_at_rest && !stays_at_rest(derivatives, &sizes, rate) {
        return Ok(Some(vec![]));
    }
    if rate == 0.0 || a.is_empty() {
        return Ok(None);
    }
    // What rests stays where it is, however its accelerations are rounded.
    let bending = if is_at_rest { 0.0 } else { 1.0 };
    let [before, after] = [-STEP, STEP].map(|part| later(mechanism, derivatives, reduction, (part / rate, bending)));
    let (before, after) = (before?, after?);
    let h = reduction.independent().len();
    let unit = |k: usize| beside.unit(k) * if k < h { 1.0 } else { rate };
    let is_steady = |i: usize, k: usize| {
        let size = unit(k) / unit(i) / rate;
        let slope = (after[(i, k)] - before[(i, k)]) / (2.0 * STEP);
        let bend = (after[(i, k)] + before[(i, k)] - 2.0 * a[(i, k)]) / (STEP * STEP);
        (slope * size).abs() <= STEADY && (bend * size).abs() <= STEADY
    };
    let step = if is_at_rest { f64::INFINITY } else { STEP / own };
    if (0..a.nrows()).all(|i| (0..a.ncols()).all(|k| is_steady(i, k))) && !beside.changes_along(step)? {
        return Ok(beside.changes_in_time()?.then(Vec::new));
    }
    let beyond = |parts: &[f64], least: f64| (0..parts.len()).filter(|j| parts[*j] > least).collect::<Vec<usize>>();
    let least = if is_at_rest { rate } else { own };
    let (bent, moving) = (beyond(&accelerations, STEADY * least * least), beyond(&speeds, STEADY * least));
    if bent.is_empty() {
        return Ok(Some(moving));
    }
    // Some entries of a turning quaternion may be at their turning points.
    let quaternions = quaternions_of(mechanism);
    let turns = |j: &usize| quaternions.iter().any(|four| four.contains(j) && four.iter().any(|k| bent.contains(k)));
    Ok(Some((0..sizes.len()).filter(|j| bent.contains(j) || moving.contains(j) && turns(j)).collect()))
}

/// A beside what it is elsewhere.
struct Beside<'a> {
    derivatives: &'a Derivatives<'a>,
    reduction: &'a Reduction,
    a: &'a DMatrix<f64>,
    sizes: &'a [f64],
    /// The rate of the motion, in 1/s.
    rate: f64,
}

impl Beside<'_> {
    /// Whether accelerations of independent speeds are small beside what a change that counts as 1 makes of them.
    fn rests(&self, accelerations: &[f64]) -> bool {
        let h = self.reduction.independent().len();
        let independent = self.reduction.independent_speeds().iter().enumerate();
        independent.map(|(k, j)| (h + k, *j)).all(|(i, j)| {
            let stiffness: f64 = (0..h).map(|k| (self.a[(i, k)] * self.unit(k)).abs()).sum();
            accelerations[j] <= AT_REST + STEADY * stiffness / self.sizes[j]
        })
    }

    /// Whether A differs at some later times, to which the motion goes on at constant speeds.
    fn changes_in_time(&self) -> Result<bool, Failure> {
        let (mechanism, at) = (self.derivatives.mechanism(), self.derivatives.state());
        let mut differs = false;
        for time in LATER {
            let positions: Vec<f64> = at.positions.iter().zip(at.speeds).map(|(q, speed)| q + time * speed).collect();
            let later = At { time: at.time + time, positions: &positions, ..at };
            if mechanism.is_met(later.time, &positions) {
                let reduction = self.reduction.moved(mechanism, later);
                differs |=
                    self.differs(&matrix(&reduction, &columns(&Derivatives::at(mechanism, later, &[])?, &reduction)?));
            }
        }
        Ok(differs)
    }

    /// The change of an independent coordinate, or speed, that counts as 1.
    fn unit(&self, k: usize) -> f64 {
        let h = self.reduction.independent().len();
        match k < h {
            true => self.sizes[self.reduction.independent()[k]],
            false => self.sizes[self.reduction.independent_speeds()[k - h]],
        }
    }

    /// Whether A differs so much later along the motion from what it was as much earlier.
    fn changes_along(&self, step: f64) -> Result<bool, Failure> {
        if !step.is_finite() {
            return Ok(false);
        }
        let along = |step: f64| later(self.derivatives.mechanism(), self.derivatives, self.reduction, (step, 1.0));
        Ok(self.differs(&along(step)?) || self.differs(&along(-step)?))
    }

    /// Whether an entry differs beside the largest in its row, by changes that count as 1: rows of fast motions say nothing of slow
    /// ones.
    fn differs(&self, other: &DMatrix<f64>) -> bool {
        let h = self.reduction.independent().len();
        (h..self.a.nrows()).any(|i| {
            let rate = |k: usize| if k < h { 1.0 } else { self.rate };
            let row = |matrix: &DMatrix<f64>, k: usize| matrix[(i, k)] * self.unit(k) * rate(k);
            let all = 0..self.a.ncols();
            let largest = all.clone().fold(0.0, |most: f64, k| most.max(row(self.a, k).abs()).max(row(other, k).abs()));
            let least = (CONSTANT * largest).max(ROUNDING * self.unit(i) * self.rate * self.rate);
            all.into_iter().any(|k| (row(other, k) - row(self.a, k)).abs() > least)
        })
    }
}

/// Whether what rests now does so at other times too, as it does not under a load that comes and goes.
fn stays_at_rest(derivatives: &Derivatives, sizes: &[f64], rate: f64) -> bool {
    let (at, least) = (derivatives.state(), AT_REST + ROUNDING * rate * rate);
    let later = LATER.into_iter().flat_map(|time| [time, time / rate]).filter(|time| time.is_finite());
    later.map(|time| derivatives.mechanism().accelerate(At { time: at.time + time, ..at })).all(|there| {
        there.is_ok_and(|there| {
            let changes = there.iter().zip(derivatives.accelerations()).map(|(there, here)| (there - here).abs());
            changes.zip(sizes).all(|(change, size)| change <= least * size)
        })
    })
}

/// The coordinates of each quaternion.
#[inline(never)]
pub fn quaternions<M: Mechanism>(mechanism: &M) -> Vec<[usize; 4]> {
    quaternions_of(&Any(mechanism))
}

fn quaternions_of(mechanism: &dyn AnyMechanism) -> Vec<[usize; 4]> {
    let description = mechanism.description();
    let n = description.coordinates.len();
    // The slopes of q.q are twice the entries: here not zero.
    let jacobian = mechanism.constraint_jacobian(0.0, &vec![1.0; n]);
    let four = |row: &usize| (0..n).filter(|j| jacobian[(*row, *j)] != 0.0).collect::<Vec<usize>>().try_into().ok();
    description.norm_constraints.iter().filter_map(four).collect()
}

/// A a little later along the motion, or earlier, in the same coordinates; accelerations count by this factor.
fn later(
    mechanism: &dyn Differentiable,
    derivatives: &Derivatives,
    reduction: &Reduction,
    (step, bending): (f64, f64),
) -> Result<DMatrix<f64>, Failure> {
    let At { time, positions, speeds, .. } = derivatives.state();
    let accelerations: Vec<f64> = derivatives.accelerations().iter().map(|a| bending * a).collect();
    let mut q: Vec<f64> =
        (0..positions.len()).map(|j| positions[j] + step * (speeds[j] + step / 2.0 * accelerations[j])).collect();
    let mut qd: Vec<f64> = (0..positions.len()).map(|j| speeds[j] + step * accelerations[j]).collect();
    reduction.follow(mechanism, time + step, (&mut q, &mut qd))?;
    let at = At::moving(time + step, &q, &qd);
    let reduction = reduction.moved(mechanism, at);
    Ok(matrix(&reduction, &columns(&Derivatives::at(mechanism, at, &[])?, &reduction)?))
}
