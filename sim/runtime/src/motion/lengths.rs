//! The scales of coordinates and constraints, from the kernels: the mechanism's own length, and the size of terms.

use crate::model::AnyMechanism;
use nalgebra::DMatrix;

/// A matrix with a column per coordinate and a row per constraint, in their scales.
pub(crate) fn without_units(
    mut jacobian: DMatrix<f64>,
    (coordinates, constraints): &(Vec<f64>, Vec<f64>),
) -> DMatrix<f64> {
    for (j, change) in coordinates.iter().enumerate() {
        jacobian.column_mut(j).iter_mut().zip(constraints).for_each(|(entry, size)| *entry *= change / size);
    }
    jacobian
}

/// The scales of coordinates and constraints, n and m.
pub(crate) fn measure(mechanism: &dyn AnyMechanism, time: f64, q: &[f64]) -> (Vec<f64>, Vec<f64>) {
    let coordinates = of_coordinates(mechanism, time, q);
    let constraints = of_constraints(mechanism, time, q, &coordinates);
    (coordinates, constraints)
}

/// A row this small beside another one in the same unit is rounding: no coordinate moves it, and its terms cancel, as those of a
/// second hinge whose place is written in so many digits.
const CANCELLED: f64 = 1e-12;

/// For each constraint the largest of its terms, or of its changes by such changes of the coordinates, m; where these are but
/// rounding, the least of the others in its unit, or what counts as 1 in it.
pub(crate) fn of_constraints(mechanism: &dyn AnyMechanism, time: f64, q: &[f64], coordinates: &[f64]) -> Vec<f64> {
    let (terms, jacobian) = (mechanism.constraint_magnitudes(time, q), mechanism.constraint_jacobian(time, q));
    let of_row = |row: usize| {
        let changes = coordinates.iter().enumerate().map(|(j, change)| (jacobian[(row, j)] * change).abs());
        let size = changes.fold(terms[row].abs(), f64::max);
        if size > 0.0 && size.is_finite() { size } else { 1.0 }
    };
    let sizes: Vec<f64> = (0..jacobian.nrows()).map(of_row).collect();
    let rows = mechanism.description().constraints;
    // Mostly none is.
    let least = CANCELLED * sizes.iter().copied().fold(0.0, f64::max);
    if sizes.iter().all(|size| *size > least) {
        return sizes;
    }
    let with_others = |row: usize| {
        let alike = || (0..sizes.len()).filter(|other| rows[*other].unit == rows[row].unit).map(|other| sizes[other]);
        let cancelled = CANCELLED * alike().fold(0.0, f64::max);
        let is_alone = alike().count() == 1;
        let of_unit = match rows[row].unit {
            "N" => own_length(mechanism, time, q),
            "N*m" => 1.0,
            _ => 0.0,
        };
        match sizes[row] > cancelled {
            true if is_alone && sizes[row] <= CANCELLED * of_unit => of_unit,
            true => sizes[row],
            false => alike().filter(|size| *size > cancelled).fold(f64::INFINITY, f64::min),
        }
    };
    (0..sizes.len()).map(with_others).collect()
}

/// For each coordinate the change that counts as 1, in SI units: the mechanism's own length for lengths, 1 for angles and
/// numbers.
pub(crate) fn of_coordinates(mechanism: &dyn AnyMechanism, time: f64, q: &[f64]) -> Vec<f64> {
    let coordinates = mechanism.description().coordinates;
    let length = own_length(mechanism, time, q);
    coordinates.iter().map(|coordinate| if coordinate.position.is_length { length } else { 1.0 }).collect()
}

/// A start is rounding, and not the mechanism's own length, if it is this small relative to a length of another kind.
const NEAREST: f64 = 1e-12;
const NEAREST_OF_ROTORS: f64 = 1e-9;

/// A length of no more metres is rounding of a larger one that has cancelled.
const NONE: f64 = 1e-13;

/// A lever arm is ignored if it is this small relative to the root of moments of inertia over masses.
const SHORTEST: f64 = 0.01;

/// The mechanism's own length, in metres: it scales with the mechanism.
///
/// It is the distance that points move per change of angles: from the constraints, the median over rows with both
/// lengths and angles; otherwise from the inertia, if nothing starts nearer to the origin than that: a light part beside a heavy
/// rotor. Without angles it is the largest length in the start, or the median one among the parameters, whichever is less: the
/// radius of the earth says little of a pendulum. Otherwise it is 1 m.
pub(crate) fn own_length(mechanism: &dyn AnyMechanism, time: f64, q: &[f64]) -> f64 {
    known_length(mechanism, time, q).unwrap_or(1.0)
}

/// The same, if anything tells it.
pub(super) fn known_length(mechanism: &dyn AnyMechanism, time: f64, q: &[f64]) -> Option<f64> {
    let coordinates = mechanism.description().coordinates;
    let is_length: Vec<bool> = coordinates.iter().map(|coordinate| coordinate.position.is_length).collect();
    let start = || {
        let lengths = q.iter().zip(&is_length).filter(|(_, is_length)| **is_length);
        lengths.map(|(q, _)| q.abs()).filter(|length| *length > NONE).fold(0.0, f64::max)
    };
    let sources: [&dyn Fn() -> f64; 4] = [
        &|| {
            // An arm that is short relative to the inertia belongs to a dead point.
            let shortest = SHORTEST * gyration(&mechanism.mass_matrix(time, q), &is_length);
            let terms = mechanism.constraint_magnitudes(time, q);
            let jacobian = without_rounding(mechanism, mechanism.constraint_jacobian(time, q), &is_length);
            let mut arms = lever_arms(&jacobian, terms.as_slice(), &is_length);
            arms.retain(|arm| !(*arm < shortest && shortest.is_finite()));
            median(arms)
        },
        &|| lesser(gyration(&mechanism.mass_matrix(time, q), &is_length), start(), NEAREST_OF_ROTORS),
        &|| lesser(of_parameters(mechanism), start(), NEAREST),
        &start,
    ];
    sources.iter().map(|length| length()).find(|length| *length > 0.0 && length.is_finite())
}

/// A length, or that of the start if it is less without being rounding.
fn lesser(length: f64, start: f64, nearest: f64) -> f64 {
    if start > nearest * length { length.min(start) } else { length }
}

/// The lower median of the lengths among the parameters; 0 for none.
fn of_parameters(mechanism: &dyn AnyMechanism) -> f64 {
    let parameters = mechanism.description().parameters.iter().zip(mechanism.parameters());
    let lengths = parameters.filter(|(parameter, _)| parameter.is_length).map(|(_, value)| value.abs());
    let mut lengths: Vec<f64> = lengths.filter(|length| *length > NONE).collect();
    lengths.sort_unstable_by(f64::total_cmp);
    lengths.get(lengths.len().saturating_sub(1) / 2).copied().unwrap_or(0.0)
}

/// A length moves a row by rounding alone if it moves others by so much more, beside their terms, or a length by so small a part of
/// itself: cos(90 deg) is 6e-17.
const ROUNDED: f64 = 1e-12;

/// The constraint Jacobian without what is rounding in the rows of lengths, whose multipliers are forces.
fn without_rounding(mechanism: &dyn AnyMechanism, mut jacobian: DMatrix<f64>, is_length: &[bool]) -> DMatrix<f64> {
    let constraints = mechanism.description().constraints;
    for (row, _) in constraints.iter().enumerate().filter(|(_, constraint)| constraint.unit == "N") {
        for (j, _) in is_length.iter().enumerate().filter(|(_, is_length)| **is_length) {
            if jacobian[(row, j)].abs() <= ROUNDED {
                jacobian[(row, j)] = 0.0;
            }
        }
    }
    jacobian
}

/// For each row with both kinds of coordinates, the length of its angular part relative to that of its linear part.
fn lever_arms(jacobian: &DMatrix<f64>, terms: &[f64], is_length: &[bool]) -> Vec<f64> {
    let size = |row: usize, columns: &[usize]| columns.iter().map(|j| jacobian[(row, *j)].powi(2)).sum::<f64>().sqrt();
    let (lengths, others): (Vec<usize>, Vec<usize>) = (0..is_length.len()).partition(|j| is_length[*j]);
    let angular: Vec<f64> = (0..terms.len()).map(|row| size(row, &others)).collect();
    let share = |row: usize, j: usize| jacobian[(row, j)].abs() / terms[row].abs().max(angular[row]);
    let most =
        |j: usize| (0..terms.len()).map(|row| share(row, j)).filter(|share| share.is_finite()).fold(0.0, f64::max);
    let least: Vec<f64> = lengths.iter().map(|j| ROUNDED * most(*j)).collect();
    let arms = (0..terms.len()).map(|row| {
        let moving = lengths.iter().zip(&least).filter(|(j, least)| share(row, **j) > **least).map(|(j, _)| *j);
        angular[row] / size(row, &moving.collect::<Vec<_>>())
    });
    arms.filter(|arm| *arm > 0.0 && arm.is_finite()).collect()
}

/// The upper median; 0 for none.
fn median(mut values: Vec<f64>) -> f64 {
    values.sort_unstable_by(f64::total_cmp);
    values.get(values.len() / 2).copied().unwrap_or(0.0)
}

/// The root of the moments of inertia over the masses.
fn gyration(mass: &DMatrix<f64>, is_length: &[bool]) -> f64 {
    let sum = |of_lengths: bool| {
        (0..is_length.len()).filter(|j| is_length[*j] == of_lengths).map(|j| mass[(j, j)]).sum::<f64>()
    };
    (sum(false) / sum(true)).sqrt()
}
