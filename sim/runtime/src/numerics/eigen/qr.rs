//! From Hessenberg form to the real Schur form: blocks of size 1, and of size 2 for conjugate pairs, on the diagonal.
//!
//! Francis's implicit QR in sweeps with two shifts (The Computer Journal 4, 1961 and 1962), with exceptional shifts now
//! and then to break cycles, and a limit.

use super::hessenberg::Reflection;
use super::{Form, NoEigenvalues};
use nalgebra::DMatrix;
use std::ops::Range;

/// The number of sweeps for an eigenvalue after which it is given up; two or three are usual.
const MOST_SWEEPS: usize = 60;
/// The number of unsuccessful sweeps before exceptional shifts.
const PATIENCE: usize = 10;
/// The number of sweeps after which entries below the rounding of the largest entry count as zero, whatever their
/// neighbours.
const WEARY: usize = 25;
/// Smaller entries are zero whatever their neighbours.
const TINY: f64 = f64::MIN_POSITIVE / f64::EPSILON;

/// Brings a diagonal block in Hessenberg form to quasi-triangular form.
pub(super) fn triangularise(form: &mut Form, block: Range<usize>) -> Result<(), NoEigenvalues> {
    let (mut end, mut sweeps) = (block.end, 0);
    while end > block.start {
        let rounding =
            if sweeps < WEARY { TINY } else { f64::EPSILON * form.t.view_range(block.clone(), block.clone()).amax() };
        let start = split(&mut form.t, block.start, end, rounding);
        match end - start {
            1 => (end, sweeps) = (start, 0),
            2 => {
                separate(form, start);
                (end, sweeps) = (start, 0);
            }
            _ if sweeps == MOST_SWEEPS => {
                let (found, size) = (block.end - end, block.len());
                return Err(NoEigenvalues::NotConverged { found, size, sweeps });
            }
            _ => {
                sweeps += 1;
                let shifts = Shifts::of(&form.t, start, end, sweeps);
                sweep(form, start, end, &shifts);
            }
        }
    }
    Ok(())
}

/// The start of the last unreduced part: the subdiagonal entry before it is negligible, and set to zero.
fn split(t: &mut DMatrix<f64>, first: usize, end: usize, rounding: f64) -> usize {
    let mut start = end - 1;
    while start > first {
        if t[(start, start - 1)].abs() <= rounding || is_negligible(t, first, end, start) {
            t[(start, start - 1)] = 0.0;
            break;
        }
        start -= 1;
    }
    start
}

/// Whether the entry left of the diagonal in row k, and its effect on the eigenvalues, are rounding of its neighbours
/// (Ahues and Tisseur, LAPACK Working Note 122, 1997).
fn is_negligible(t: &DMatrix<f64>, first: usize, end: usize, k: usize) -> bool {
    let size = |i: usize, j: usize| t[(i, j)].abs();
    let (left, above) = (size(k, k - 1), size(k - 1, k));
    let mut beside = size(k - 1, k - 1) + size(k, k);
    if beside == 0.0 {
        beside += if k - 1 > first { size(k - 1, k - 2) } else { 0.0 };
        beside += if k + 1 < end { size(k + 1, k) } else { 0.0 };
    }
    if left > f64::EPSILON * beside {
        return false;
    }
    let (own, apart) = (size(k, k), (t[(k - 1, k - 1)] - t[(k, k)]).abs());
    let sum = own.max(apart) + left.max(above);
    let effect = left.min(above) * (left.max(above) / sum);
    effect <= TINY.max(f64::EPSILON * own.min(apart) * (own.max(apart) / sum))
}

/// Makes a block of size 2 triangular if its eigenvalues are real.
fn separate(form: &mut Form, k: usize) {
    let t = &mut form.t;
    let (a, b, c, d) = (t[(k, k)], t[(k, k + 1)], t[(k + 1, k)], t[(k + 1, k + 1)]);
    let half = (a - d) / 2.0;
    let square = half * half + b * c;
    if c == 0.0 || square < 0.0 {
        return;
    }
    // (far, c) is the eigenvector of d + far, the eigenvalue that is farther from d.
    let far = half + square.sqrt().copysign(half);
    let near = if far == 0.0 { 0.0 } else { -(b / far) * c };
    rotate(form, k, far, c);
    form.t[(k, k)] = d + far;
    form.t[(k + 1, k)] = 0.0;
    form.t[(k + 1, k + 1)] = d + near;
}

/// Turns the coordinates k and k + 1 so that (x, y) lies along the first of them.
fn rotate(Form { t, z }: &mut Form, k: usize, x: f64, y: f64) {
    let n = t.nrows();
    let length = super::balance::length([x, y].into_iter());
    let (cos, sin) = (x / length, y / length);
    for j in k..n {
        let (upper, lower) = (t[(k, j)], t[(k + 1, j)]);
        t[(k, j)] = cos * upper + sin * lower;
        t[(k + 1, j)] = cos * lower - sin * upper;
    }
    for (matrix, rows) in [(t, k + 2), (z, n)] {
        for i in 0..rows {
            let (left, right) = (matrix[(i, k)], matrix[(i, k + 1)]);
            matrix[(i, k)] = cos * left + sin * right;
            matrix[(i, k + 1)] = cos * right - sin * left;
        }
    }
}

/// A conjugate pair of shifts, or two that are real.
struct Shifts {
    real: [f64; 2],
    imaginary: f64,
}

impl Shifts {
    /// The eigenvalues of the last two rows, or twice the one nearer to the last entry; after a while exceptional ones,
    /// made of subdiagonal entries at either end.
    fn of(t: &DMatrix<f64>, start: usize, end: usize, sweeps: usize) -> Shifts {
        let last = end - 1;
        let made_up = |at: usize, sub: [usize; 2]| {
            let size: f64 = sub.iter().map(|k| t[(*k, k - 1)].abs()).sum();
            let real = t[(at, at)] + 0.75 * size;
            Shifts { real: [real; 2], imaginary: 0.66 * size }
        };
        match sweeps.is_multiple_of(PATIENCE) {
            true if sweeps.is_multiple_of(2 * PATIENCE) => made_up(last, [last, last - 1]),
            true => made_up(start, [start + 1, start + 2]),
            false => {
                let (a, d) = (t[(last - 1, last - 1)], t[(last, last)]);
                let half = (a - d) / 2.0;
                let product = t[(last - 1, last)] * t[(last, last - 1)];
                let square = half * half + product;
                if square < 0.0 {
                    return Shifts { real: [d + half; 2], imaginary: (-square).sqrt() };
                }
                let far = half + square.sqrt().copysign(half);
                let near = if far == 0.0 { 0.0 } else { -product / far };
                Shifts { real: [d + near; 2], imaginary: 0.0 }
            }
        }
    }

    /// The first column of (T - s1) (T - s2), in some unit: its three entries that are not zero.
    fn first_column(&self, t: &DMatrix<f64>, k: usize) -> [f64; 3] {
        let [from_first, from_second] = self.real.map(|shift| t[(k, k)] - shift);
        let below = t[(k + 1, k)];
        let column = [
            from_first * from_second + self.imaginary * self.imaginary + t[(k, k + 1)] * below,
            below * (from_first + t[(k + 1, k + 1)] - self.real[1]),
            below * t[(k + 2, k + 1)],
        ];
        let largest = column.iter().fold(0.0, |largest: f64, entry| largest.max(entry.abs()));
        if largest > 0.0 { column.map(|entry| entry / largest) } else { [1.0, 0.0, 0.0] }
    }
}

/// One sweep over the rows from `start` to `end`: the bulge that the shifts create in the first column is chased down
/// the diagonal.
fn sweep(form: &mut Form, start: usize, end: usize, shifts: &Shifts) {
    for k in start..end - 1 {
        let reach = (k + 3).min(end);
        let column = match k == start {
            true => shifts.first_column(&form.t, k).to_vec(),
            false => (k..reach).map(|i| form.t[(i, k - 1)]).collect(),
        };
        let Some(reflection) = Reflection::of(&column) else { continue };
        reflection.apply(form, k, k, (k + 4).min(end));
        if k > start {
            form.t[(k, k - 1)] = reflection.length;
            (k + 1..reach).for_each(|i| form.t[(i, k - 1)] = 0.0);
        }
    }
}
