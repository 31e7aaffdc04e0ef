//! What coordinates and constraints are measured by, from the kernels: the mechanism's own length, and the size of terms.

use crate::model::AnyMechanism;
use nalgebra::DMatrix;

/// A matrix of columns for coordinates and rows for constraints in what these are measured by.
pub(crate) fn without_units(
    mut jacobian: DMatrix<f64>,
    (coordinates, constraints): &(Vec<f64>, Vec<f64>),
) -> DMatrix<f64> {
    for (j, change) in coordinates.iter().enumerate() {
        jacobian.column_mut(j).iter_mut().zip(constraints).for_each(|(entry, size)| *entry *= change / size);
    }
    jacobian
}

/// What coordinates and constraints are measured by, n and m.
pub(crate) fn measure(mechanism: &dyn AnyMechanism, time: f64, q: &[f64]) -> (Vec<f64>, Vec<f64>) {
    let coordinates = of_coordinates(mechanism, time, q);
    let (terms, jacobian) = (mechanism.constraint_magnitudes(time, q), mechanism.constraint_jacobian(time, q));
    let of_row = |row: usize| {
        let changes = coordinates.iter().enumerate().map(|(j, change)| (jacobian[(row, j)] * change).abs());
        let size = changes.fold(terms[row].abs(), f64::max);
        if size > 0.0 && size.is_finite() { size } else { 1.0 }
    };
    let constraints = (0..jacobian.nrows()).map(of_row).collect();
    (coordinates, constraints)
}

/// For each coordinate the change that counts as 1, in SI units: the mechanism's own length for lengths, 1 for angles and
/// numbers.
fn of_coordinates(mechanism: &dyn AnyMechanism, time: f64, q: &[f64]) -> Vec<f64> {
    let coordinates = mechanism.description().coordinates;
    let length = own_length(mechanism, time, q);
    coordinates.iter().map(|coordinate| if coordinate.position.is_length { length } else { 1.0 }).collect()
}

/// An arm by which an angle moves a point is no measure where it is this small beside the root of moments of inertia over masses.
const SHORTEST: f64 = 0.01;

/// The mechanism's own length, in metres: all lengths of the same mechanism twice as large make it twice as large.
///
/// How far its points move for a change of its angles: by the constraints, the median of rows in which both lengths and
/// angles stand; else by its inertia; else the largest length that it starts at, or that is a parameter of it; else 1 m.
pub(crate) fn own_length(mechanism: &dyn AnyMechanism, time: f64, q: &[f64]) -> f64 {
    let coordinates = mechanism.description().coordinates;
    let is_length: Vec<bool> = coordinates.iter().map(|coordinate| coordinate.position.is_length).collect();
    let sources: [&dyn Fn() -> f64; 3] = [
        &|| {
            // An arm that is short beside its inertia is one in a dead point.
            let shortest = SHORTEST * gyration(&mechanism.mass_matrix(time, q), &is_length);
            let mut arms = lever_arms(&mechanism.constraint_jacobian(time, q), &is_length);
            arms.retain(|arm| !(*arm < shortest && shortest.is_finite()));
            median(arms)
        },
        &|| gyration(&mechanism.mass_matrix(time, q), &is_length),
        &|| {
            let description = mechanism.description();
            let starts = q.iter().zip(&is_length).filter(|(_, is_length)| **is_length).map(|(q, _)| q.abs());
            let parameters = description.parameters.iter().zip(mechanism.parameters());
            let lengths = parameters.filter(|(parameter, _)| parameter.is_length).map(|(_, value)| value.abs());
            starts.chain(lengths).fold(0.0, f64::max)
        },
    ];
    sources.iter().map(|length| length()).find(|length| *length > 0.0 && length.is_finite()).unwrap_or(1.0)
}

/// For each row with both kinds of coordinates how long its part of angles is beside that of lengths.
fn lever_arms(jacobian: &DMatrix<f64>, is_length: &[bool]) -> Vec<f64> {
    let part = |row: usize, of_lengths: bool| {
        let columns = (0..is_length.len()).filter(|j| is_length[*j] == of_lengths);
        columns.map(|j| jacobian[(row, j)].powi(2)).sum::<f64>().sqrt()
    };
    let arms = (0..jacobian.nrows()).map(|row| part(row, false) / part(row, true));
    arms.filter(|arm| *arm > 0.0 && arm.is_finite()).collect()
}

/// The larger of the two in the middle; 0 of none.
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
