//! What coordinates, equations and the parameter are measured by, so that directions and ranks have no units: a linkage of
//! 1 mm and one of 100 m take the same steps.

use super::driven::{Driven, has_length, is_angle};
use super::system::System;

/// Angles and pure numbers are measured by 1, lengths by the mechanism's own, equations by their terms.
#[derive(Clone, Debug)]
pub(super) struct Sizes {
    /// Of each coordinate.
    pub(super) coordinates: Vec<f64>,
    /// Of each row of F.
    pub(super) rows: Vec<f64>,
    /// Of p: what is driven moves by its own size while p changes by this.
    pub(super) parameter: f64,
}

impl Sizes {
    /// Those at a position, of a system whose parameter goes from 0 to `end`.
    pub(super) fn new(system: &System, q: &[f64], end: f64) -> Sizes {
        let (mechanism, linear) = (system.mechanism, system.linear(q, 0.0));
        let description = mechanism.description();
        let is_pure = |j: usize| {
            is_angle(description.coordinates[j].position.unit) || description.coordinates[j].position.unit == "1"
        };
        let magnitudes = mechanism.constraint_magnitudes(system.time(0.0), q);
        let of_row = |k: usize, counts: &dyn Fn(usize) -> bool| {
            let squares = (0..q.len()).filter(|j| counts(*j)).map(|j| linear.jacobian[(k, j)].powi(2));
            squares.sum::<f64>().sqrt()
        };
        // A row of lengths x and angles: its terms by what a length adds to it.
        let length_in = |(k, row): (usize, &usize)| {
            let terms = magnitudes[*row].max(of_row(k, &is_pure));
            let by_lengths = of_row(k, &|j| !is_pure(j));
            if by_lengths > 0.0 { terms / by_lengths } else { 0.0 }
        };
        let travel = |law: &super::system::Law| (law.rate * end).abs();
        let moved = || system.laws.iter().map(travel).fold(0.0, f64::max);
        let length = [system.rows.iter().enumerate().map(length_in).fold(0.0, f64::max), moved()];
        let length = length.into_iter().find(|length| *length > 0.0 && length.is_finite()).unwrap_or(1.0);
        let coordinates: Vec<f64> = (0..q.len()).map(|j| if is_pure(j) { 1.0 } else { length }).collect();
        let scaled = |k: usize| {
            let squares = (0..q.len()).map(|j| (linear.jacobian[(k, j)] * coordinates[j]).powi(2));
            squares.sum::<f64>().sqrt()
        };
        let or_one = |size: f64| if size > 0.0 && size.is_finite() { size } else { 1.0 };
        let constraints = system.rows.iter().enumerate().map(|(k, row)| or_one(magnitudes[*row].max(scaled(k))));
        let driven = |driven: Driven, k: usize| match driven.quantity(description).unit {
            unit if is_angle(unit) || unit == "1" => 1.0,
            unit if has_length(unit) => length,
            _ => or_one(scaled(k)),
        };
        let drives = system.laws.iter().enumerate().map(|(k, law)| driven(law.driven, system.rows.len() + k));
        let drives: Vec<f64> = drives.collect();
        let fastest = system.laws.iter().zip(&drives).map(|(law, size)| law.rate.abs() / size).fold(0.0, f64::max);
        Sizes {
            rows: constraints.chain(drives.iter().copied()).collect(),
            parameter: 1.0 / or_one(fastest),
            coordinates,
        }
    }
}
