//! The scales of coordinates, equations and the parameter, which make directions and ranks dimensionless: a linkage of
//! 1 mm and one of 100 m take the same steps.

use super::driven::{Driven, is_angle};
use super::system::{Law, System};
use crate::motion::lengths::{of_constraints, of_coordinates, own_length};

/// No length is smaller than this part of the range through which a length is driven: a start near the origin, where nothing else
/// has a length, is none.
const PART: f64 = 1e-3;

/// Coordinates and constraints have the same scales as in runs. The scale of the driven quantity is 1 for an angle, the
/// mechanism's own length for a length, and otherwise its change with the coordinates.
#[derive(Clone, Debug)]
pub(super) struct Sizes {
    /// Of each coordinate.
    pub(super) coordinates: Vec<f64>,
    /// Of each row of F.
    pub(super) rows: Vec<f64>,
    /// That of p: the driven quantity moves by its own scale while p changes by this.
    pub(super) parameter: f64,
}

impl Sizes {
    /// Those of a system at a position, at the start, for p from 0 to `end`.
    pub(super) fn new(system: &System, q: &[f64], end: f64) -> Sizes {
        let (mechanism, time) = (system.mechanism, system.time(0.0));
        let mut coordinates = of_coordinates(mechanism, time, q);
        let description = mechanism.description();
        let lengths = system.laws.iter().filter(|law| law.driven.quantity(description).is_length);
        let least = PART * lengths.map(|law| (law.rate * end).abs()).fold(0.0, f64::max);
        for (coordinate, size) in description.coordinates.iter().zip(&mut coordinates) {
            *size = if coordinate.position.is_length { size.max(least) } else { *size };
        }
        let constraints = of_constraints(mechanism, time, q, &coordinates);
        let jacobian = system.linear(q, 0.0).jacobian;
        let change = |row: usize| {
            let changes = coordinates.iter().enumerate().map(|(j, size)| (jacobian[(row, j)] * size).powi(2));
            changes.sum::<f64>().sqrt()
        };
        let of_law = |(k, law): (usize, &Law)| match (law.driven, law.driven.quantity(description)) {
            (Driven::Coordinate(j), _) => coordinates[j],
            (_, quantity) if quantity.is_length => own_length(mechanism, time, q).max(least),
            (_, quantity) if is_angle(quantity.unit) => 1.0,
            _ => or_one(change(system.rows.len() + k)),
        };
        let drives: Vec<f64> = system.laws.iter().enumerate().map(of_law).collect();
        let fastest = system.laws.iter().zip(&drives).map(|(law, size)| law.rate.abs() / size).fold(0.0, f64::max);
        let rows = system.rows.iter().map(|row| constraints[*row]).chain(drives).collect();
        Sizes { coordinates, rows, parameter: or_one(fastest).recip() }
    }
}

fn or_one(size: f64) -> f64 {
    if size > 0.0 && size.is_finite() { size } else { 1.0 }
}
