//! Convective and generalised forces from rows of T, as they are derived for readers: nothing of recursions over links occurs in
//! them.

use codegen::dynamics::EquationsOfMotion;
use codegen::symbolic::{Symbol, evaluate};
use sim::{At, Model};
use std::collections::HashMap;

pub(crate) fn equations(text: &str) -> EquationsOfMotion {
    let declaration = codegen::dsl::declarations(text).unwrap().into_iter().next().unwrap();
    codegen::equations(declaration).unwrap()
}

/// h and Q, n each, with the parameters of a model.
pub(crate) fn forces(equations: &EquationsOfMotion, of: &dyn Model, at: At<f64>) -> [Vec<f64>; 2] {
    let EquationsOfMotion { model, graph, tmt, .. } = equations;
    let mut known: HashMap<Symbol, f64> = HashMap::from([(model.time, at.time)]);
    known.extend(model.parameters.iter().map(|parameter| parameter.symbol).zip(of.values().parameters));
    for (i, coordinate) in model.coordinates.iter().enumerate() {
        known.extend([(coordinate.position, at.positions[i]), (coordinate.speed, at.speeds[i])]);
    }
    [&tmt.convective_forces, &tmt.generalized_forces].map(|forces| evaluate(graph, forces, |symbol| known[&symbol]))
}
