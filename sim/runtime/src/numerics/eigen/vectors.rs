//! Eigenvectors from the Schur form, by substitution.

use super::Form;
use nalgebra::{Complex, DMatrix};

type Number = Complex<f64>;

/// The replacement of a zero divisor: so small that the quotient dominates the vector, and still finite.
const TINY: f64 = 1e-100;
/// The size at which a vector is scaled down.
const LONG: f64 = 1e100;

/// The eigenvalues, in the order of the diagonal, each with Z x where T x = lambda x.
pub(super) fn eigenvectors(form: &Form) -> Vec<(Number, Vec<Number>)> {
    let mut found = Vec::new();
    let mut k = 0;
    while k < form.t.nrows() {
        let size = size_of_block(&form.t, k);
        match size {
            1 => found.push((form.t[(k, k)].into(), vector(form, k, form.t[(k, k)].into(), &[1.0.into()]))),
            _ => found.extend(pair(form, k)),
        }
        k += size;
    }
    found
}

/// The conjugate pair of a block of size 2.
fn pair(form: &Form, k: usize) -> [(Number, Vec<Number>); 2] {
    let t = &form.t;
    let (a, b, c, d) = (t[(k, k)], t[(k, k + 1)], t[(k + 1, k)], t[(k + 1, k + 1)]);
    let half = (a - d) / 2.0;
    // Entries below the diagonal exist only if this is positive.
    let imaginary = (-(half * half + b * c)).max(0.0).sqrt();
    let value = Number::new(d + half, imaginary);
    let start = match b.abs() > c.abs() {
        true => [b.into(), value - a],
        false => [value - d, c.into()],
    };
    let vector = vector(form, k, value, &start);
    let conjugate = vector.iter().map(Number::conj).collect();
    [(value, vector), (value.conj(), conjugate)]
}

/// Z x, where x ends, in the rows from k on, with an eigenvector of the block there.
fn vector(form: &Form, k: usize, value: Number, end: &[Number]) -> Vec<Number> {
    let t = &form.t;
    let n = t.nrows();
    let mut x = vec![Number::default(); n];
    x[k..k + end.len()].copy_from_slice(end);
    // No matrix is closer to singular than the rounding of its eigenvalue, except for an exact zero.
    let least = (f64::EPSILON * magnitude(value)).max(TINY);
    let mut i = k;
    while i > 0 {
        let size = if i > 1 && t[(i - 1, i - 2)] != 0.0 { 2 } else { 1 };
        i -= size;
        let known = |row: usize| (i + size..k + end.len()).map(|j| x[j] * t[(row, j)]).sum::<Number>();
        match size {
            1 => x[i] = divide(-known(i), away(value, t[(i, i)].into(), least)),
            _ => [x[i], x[i + 1]] = solve_block(t, i, value, [-known(i), -known(i + 1)], least),
        }
        let longest = x[i..].iter().fold(0.0, |longest: f64, entry| longest.max(magnitude(*entry)));
        if longest > LONG {
            x[i..].iter_mut().for_each(|entry| *entry /= longest);
        }
    }
    let length = length(&x);
    let of_row = |i: usize| (0..k + end.len()).map(|j| x[j] * form.z[(i, j)]).sum::<Number>() / length;
    (0..n).map(of_row).collect()
}

/// The solution of (T_i - lambda) x = r for a block of size 2, by Cramer's rule.
fn solve_block(t: &DMatrix<f64>, i: usize, value: Number, r: [Number; 2], least: f64) -> [Number; 2] {
    let (a, d) = (t[(i, i)] - value, t[(i + 1, i + 1)] - value);
    let (b, c) = (t[(i, i + 1)], t[(i + 1, i)]);
    let determinant = a * d - b * c;
    let smallest = least * (magnitude(a) + magnitude(d) + b.abs() + c.abs());
    let determinant = away(0.0.into(), determinant, smallest);
    [divide(d * r[0] - r[1] * b, determinant), divide(a * r[1] - r[0] * c, determinant)]
}

/// entry - value, kept this far from zero.
fn away(value: Number, entry: Number, least: f64) -> Number {
    let apart = entry - value;
    if magnitude(apart) < least { least.into() } else { apart }
}

/// A quotient, whose divisor may be too small to be squared.
fn divide(number: Number, by: Number) -> Number {
    let size = magnitude(by);
    number / size / (by / size)
}

fn size_of_block(t: &DMatrix<f64>, k: usize) -> usize {
    if k + 1 < t.nrows() && t[(k + 1, k)] != 0.0 { 2 } else { 1 }
}

fn magnitude(number: Number) -> f64 {
    number.re.abs() + number.im.abs()
}

/// The length of a complex vector.
pub(super) fn length(x: &[Number]) -> f64 {
    super::balance::length(x.iter().flat_map(|entry| [entry.re, entry.im]))
}
