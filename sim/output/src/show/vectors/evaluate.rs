//! The arrows of a run in numbers.

use super::Vector;
use super::arrows::{Source, arrows};
use super::expressions::REACH;
use crate::outcome::{Row, Rows};
use codegen::dsl::{self, OutputGroup};
use codegen::oracle::{Measured, Oracle, State};
use sim_kernel::Description;

/// The forces of a motion, each with its point and its components, at each of some samples. None where the declaration
/// cannot be read again.
pub(in crate::show) fn vectors(
    run: &dyn Rows,
    description: &Description,
    samples: &[usize],
) -> Vec<(Vector, Vec<f64>)> {
    let tokens = description.declaration.parse().ok();
    let Some(mut declaration) = tokens.and_then(|tokens| codegen::parse(tokens).ok()) else { return Vec::new() };
    let mut outputs = Vec::new();
    let sources = arrows(&mut declaration, description, &mut outputs);
    declaration.outputs = vec![OutputGroup { name: None, title: None, outputs }];
    let si = |unit: &dsl::Unit| codegen::model::Unit::resolve(unit).map_or(f64::NAN, |unit| unit.factor());
    let oracle = Oracle::new(&declaration, &si);
    let mut numbers = vec![Vec::with_capacity(2 * description.dimension * samples.len()); sources.len()];
    for index in samples {
        let row = run.row(*index);
        let values = evaluate(&oracle, &row).unwrap_or_default();
        for ((_, source), numbers) in sources.iter().zip(&mut numbers) {
            numbers.extend(arrow(source, &values, &row.multipliers, description.dimension));
        }
    }
    sources.into_iter().map(|(vector, _)| vector).zip(numbers).collect()
}

/// The outputs at a sample.
fn evaluate(oracle: &Oracle, row: &Row) -> Option<Vec<f64>> {
    let Row { time, parameters, inputs, positions: coordinates, speeds, .. } = row;
    let state = State { time: *time, parameters, inputs, coordinates, speeds };
    let accelerations: Vec<Measured> = row.accelerations.iter().copied().map(Measured::given).collect();
    // Most arrows need no rate.
    let outputs =
        oracle.outputs_of_positions(&state).or_else(|_| oracle.outputs_of_motion(&state, &accelerations)).ok()?;
    Some(outputs.into_iter().map(|output| output.value).collect())
}

/// The components of the point, then those of the force.
fn arrow(source: &Source, values: &[f64], multipliers: &[f64], dimension: usize) -> Vec<f64> {
    let at = |index: usize| values.get(index).copied().unwrap_or(f64::NAN);
    let (Source::Load(first) | Source::Reaction { first, .. } | Source::Joint { first, .. }) = *source;
    let force = |axis: usize| match *source {
        Source::Load(first) => at(first + dimension + axis),
        Source::Reaction { first, row } => -multipliers[row] / (2.0 * REACH) * at(first + dimension + axis),
        Source::Joint { row, .. } => -multipliers[row + axis],
    };
    (0..dimension).map(|axis| at(first + axis)).chain((0..dimension).map(force)).collect()
}
