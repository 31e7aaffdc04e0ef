//! One or two constraints in as many unknown coordinates, solved in closed form.

use super::harmonic::{Harmonic, angles, fit_harmonic, fit_linear, near};
use std::fmt;

/// Matrices of a dyad are turned and scaled unit matrices up to this.
const ROUNDING: f64 = 1e-12;

/// The form of a loop.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Form {
    /// One equation in an angle: a link whose end is on a line.
    Angle,
    /// One equation in a length.
    Length,
    /// Two links with a joint between them: two equations in two angles, l1 u(phi1) + l2 u(phi2) = known.
    Rrr,
    /// A link and a slider on a straight guide: two equations in an angle and a length.
    Rrp,
    /// Two equations in two lengths.
    Pp,
}

impl fmt::Display for Form {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        f.write_str(match self {
            Form::Angle => "one angle",
            Form::Length => "one length",
            Form::Rrr => "RRR dyad",
            Form::Rrp => "RRP dyad",
            Form::Pp => "two lengths",
        })
    }
}

type Vector = [f64; 2];

/// The dependence of both rows of a pair on an unknown.
enum Column {
    /// By cosine and sine: the columns of a matrix by rows.
    Angle([Vector; 2]),
    /// By a length along this vector.
    Length(Vector),
}

/// All values of the unknowns where the residuals are zero; `None` if their form is unknown.
pub(super) fn close(residual: &dyn Fn(&[f64]) -> Vec<f64>, guesses: &[f64]) -> Option<(Form, Vec<Vec<f64>>)> {
    match guesses {
        [guess] => close_one(&|x| residual(&[x])[0], *guess),
        [first, second] => {
            CHOICES.iter().find_map(|choice| close_chosen(&|x, y| residual(&[x, y]), [*first, *second], choice))
        }
        _ => None,
    }
}

/// Two unknowns of which the coordinates x and y of a pair are combinations, because angles may be measured from a link
/// as well as from the ground: (x, y) = C (u, v), with C by rows, and its inverse.
type Choice = ([Vector; 2], [Vector; 2]);

const CHOICES: [Choice; 5] = [
    ([[1.0, 0.0], [0.0, 1.0]], [[1.0, 0.0], [0.0, 1.0]]),
    ([[1.0, 0.0], [-1.0, 1.0]], [[1.0, 0.0], [1.0, 1.0]]),
    ([[1.0, -1.0], [0.0, 1.0]], [[1.0, 1.0], [0.0, 1.0]]),
    ([[1.0, 0.0], [1.0, -1.0]], [[1.0, 0.0], [1.0, -1.0]]),
    ([[1.0, 1.0], [0.0, 1.0]], [[1.0, -1.0], [0.0, 1.0]]),
];

fn close_chosen(
    f: &dyn Fn(f64, f64) -> Vec<f64>,
    guesses: Vector,
    (choice, inverse): &Choice,
) -> Option<(Form, Vec<Vec<f64>>)> {
    let chosen = |u: f64, v: f64| {
        let [x, y] = times(*choice, [u, v]);
        f(x, y)
    };
    let (form, found) = close_two(&chosen, times(*inverse, guesses))?;
    let back = |values: &Vec<f64>| {
        let coordinates = times(*choice, [values[0], values[1]]);
        let is_angle = form == Form::Rrr;
        [0, 1].map(|j| if is_angle { near(coordinates[j], guesses[j]) } else { coordinates[j] }).to_vec()
    };
    Some((form, found.iter().map(back).collect()))
}

fn close_one(f: &dyn Fn(f64) -> f64, guess: f64) -> Option<(Form, Vec<Vec<f64>>)> {
    if let Some((harmonic, constant)) = fit_harmonic(f) {
        let found = angles(harmonic, -constant, guess)?;
        return Some((Form::Angle, found.into_iter().map(|angle| vec![angle]).collect()));
    }
    let (slope, constant) = fit_linear(f)?;
    (slope != 0.0).then(|| (Form::Length, vec![vec![-constant / slope]]))
}

fn close_two(f: &dyn Fn(f64, f64) -> Vec<f64>, guesses: Vector) -> Option<(Form, Vec<Vec<f64>>)> {
    let first = column(&|x| f(x, 0.0))?;
    let second = column(&|y| f(0.0, y))?;
    if !is_sum(f) {
        return None;
    }
    let origin = f(0.0, 0.0);
    let constant = [0, 1].map(|i| origin[i] - first.at_zero(i) - second.at_zero(i));
    match (first, second) {
        (Column::Angle(a), Column::Angle(b)) => two_angles([a, b], constant, guesses).map(|found| (Form::Rrr, found)),
        (Column::Angle(a), Column::Length(w)) => angle_and_length(a, w, constant, guesses[0])
            .map(|found| (Form::Rrp, found.into_iter().map(|[angle, length]| vec![angle, length]).collect())),
        (Column::Length(w), Column::Angle(a)) => angle_and_length(a, w, constant, guesses[1])
            .map(|found| (Form::Rrp, found.into_iter().map(|[angle, length]| vec![length, angle]).collect())),
        (Column::Length(v), Column::Length(w)) => two_lengths(v, w, constant).map(|found| (Form::Pp, vec![found])),
    }
}

impl Column {
    fn at_zero(&self, row: usize) -> f64 {
        match self {
            Column::Angle(matrix) => matrix[row][0],
            Column::Length(_) => 0.0,
        }
    }
}

/// The dependence of both rows on one unknown.
fn column(f: &dyn Fn(f64) -> Vec<f64>) -> Option<Column> {
    let harmonic = |row: usize| fit_harmonic(&|x| f(x)[row]).map(|(Harmonic { cosine, sine }, _)| [cosine, sine]);
    let linear = |row: usize| fit_linear(&|x| f(x)[row]).map(|(slope, _)| slope);
    match (harmonic(0), harmonic(1)) {
        (Some(a), Some(b)) => Some(Column::Angle([a, b])),
        _ => Some(Column::Length([linear(0)?, linear(1)?])),
    }
}

/// Whether f(x, y) is the sum of a function of x and one of y.
fn is_sum(f: &dyn Fn(f64, f64) -> Vec<f64>) -> bool {
    let origin = f(0.0, 0.0);
    [(0.9, 2.3), (-1.7, 0.4)].into_iter().all(|(x, y)| {
        let (both, first, second) = (f(x, y), f(x, 0.0), f(0.0, y));
        (0..2).all(|i| {
            let size = both[i].abs() + first[i].abs() + second[i].abs() + origin[i].abs();
            (both[i] - first[i] - second[i] + origin[i]).abs() <= ROUNDING * size
        })
    })
}

/// k + A u(phi1) + B u(phi2) = 0 with |A u| and |B u| constant: |k + B u2| is the length of the first link.
fn two_angles([a, b]: [[Vector; 2]; 2], k: Vector, guesses: Vector) -> Option<Vec<Vec<f64>>> {
    let (first, second) = (length_of_link(a)?, length_of_link(b)?);
    let [cosine, sine] = transposed(b, k).map(|entry| 2.0 * entry);
    let value = first * first - second * second - inner(k, k);
    let found = angles(Harmonic { cosine, sine }, value, guesses[1])?;
    let other = |angle: &f64| {
        let turned = times(b, [angle.cos(), angle.sin()]);
        let [x, y] = transposed(a, [-k[0] - turned[0], -k[1] - turned[1]]);
        near(y.atan2(x), guesses[0])
    };
    Some(found.iter().map(|angle| vec![other(angle), *angle]).collect())
}

/// k + A u(phi) + w s = 0: across w, an equation in the angle.
fn angle_and_length(a: [Vector; 2], w: Vector, k: Vector, guess: f64) -> Option<Vec<[f64; 2]>> {
    let across = [-w[1], w[0]];
    if inner(w, w) == 0.0 {
        return None;
    }
    let [cosine, sine] = transposed(a, across);
    let found = angles(Harmonic { cosine, sine }, -inner(across, k), guess)?;
    let length = |angle: f64| {
        let turned = times(a, [angle.cos(), angle.sin()]);
        -inner(w, [k[0] + turned[0], k[1] + turned[1]]) / inner(w, w)
    };
    Some(found.into_iter().map(|angle| [angle, length(angle)]).collect())
}

/// k + v r + w s = 0.
fn two_lengths(v: Vector, w: Vector, k: Vector) -> Option<Vec<f64>> {
    let cross = |a: Vector, b: Vector| a[0] * b[1] - a[1] * b[0];
    let determinant = cross(v, w);
    let is_regular = determinant.abs() > ROUNDING * (inner(v, v) * inner(w, w)).sqrt();
    is_regular.then(|| vec![-cross(k, w) / determinant, -cross(v, k) / determinant])
}

/// l, if A is l times a rotation or reflection.
fn length_of_link(a: [Vector; 2]) -> Option<f64> {
    let column = |j: usize| [a[0][j], a[1][j]];
    let (one, two) = (inner(column(0), column(0)), inner(column(1), column(1)));
    let is_similarity = (one - two).abs() <= ROUNDING * one && inner(column(0), column(1)).abs() <= ROUNDING * one;
    (is_similarity && one > 0.0).then(|| one.sqrt())
}

fn times(a: [Vector; 2], x: Vector) -> Vector {
    [inner(a[0], x), inner(a[1], x)]
}

fn transposed(a: [Vector; 2], x: Vector) -> Vector {
    [0, 1].map(|j| a[0][j] * x[0] + a[1][j] * x[1])
}

fn inner(a: Vector, b: Vector) -> f64 {
    a[0] * b[0] + a[1] * b[1]
}
