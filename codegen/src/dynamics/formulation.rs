//! The rows and the constraints in terms of coordinates and intermediates, and the cost of solving them in this form.

use super::intermediates::{Intermediate, total_time_derivative};
use super::order::{Entry, Kind, Multipliers, Pattern, cost, order};
use super::rows::LoadRow;
use super::variables::{Derivatives, Variables, inner};
use crate::model::{Constraint, Level, Model};
use crate::symbolic::{Expr, Graph, Symbol};
use std::collections::BTreeSet;

/// Rows and constraints with intermediates in them.
pub(super) struct Formulation {
    pub(super) rows: Vec<LoadRow>,
    pub(super) constraints: Vec<Expr>,
    /// The definitions, each of coordinates and those before it.
    pub(super) definitions: Vec<Expr>,
    pub(super) symbols: Vec<[Symbol; 4]>,
    pub(super) names: Vec<String>,
}

impl Formulation {
    /// In coordinates alone.
    pub(super) fn without(model: &Model, rows: Vec<LoadRow>) -> Formulation {
        let constraints = model.constraints.iter().map(|constraint| constraint.value).collect();
        Formulation { rows, constraints, definitions: vec![], symbols: vec![], names: vec![] }
    }

    /// The coordinates and the intermediates.
    pub(super) fn variables(&self, model: &Model) -> Variables {
        let mut variables = Variables::coordinates(model);
        for [position, speed, acceleration, _] in &self.symbols {
            variables.positions.push(*position);
            variables.speeds.push(*speed);
            variables.accelerations.push(*acceleration);
        }
        variables
    }

    /// The intermediates with their derivatives.
    pub(super) fn intermediates(
        &self,
        graph: &mut Graph,
        model: &Model,
        variables: &Variables,
        derivatives: &mut Derivatives,
    ) -> Vec<Intermediate> {
        let accelerations: Vec<Expr> = variables.accelerations.iter().map(|a| graph.variable(*a)).collect();
        let mut drifts = vec![graph.zero(); variables.len()];
        let mut intermediates = Vec::new();
        for (i, definition) in self.definitions.iter().enumerate() {
            let definition = derivatives.of_quantity(graph, variables, *definition);
            let moving = inner(graph, &definition.jacobian, &accelerations);
            let acceleration = graph.add(moving, definition.convective);
            let time_derivative = total_time_derivative(graph, &definition, &drifts);
            let (name, symbols) = (self.names[i].clone(), self.symbols[i]);
            let intermediate = Intermediate { name, symbols, definition, acceleration, time_derivative };
            drifts[model.coordinates.len() + i] = intermediate.drift(graph);
            intermediates.push(intermediate);
        }
        intermediates
    }

    /// The approximate number of multiplications to form and solve the equations.
    pub(super) fn cost(&self, graph: &Graph, model: &Model) -> usize {
        let variables = self.variables(model).positions;
        let (n, p) = (model.coordinates.len(), self.symbols.len());
        let occurring = |expr: Expr| -> Vec<usize> {
            let symbols = graph.symbols_of(&[expr]);
            (0..variables.len()).filter(|i| symbols.binary_search(&variables[*i]).is_ok()).collect()
        };
        let rows: Vec<Vec<usize>> = self.rows.iter().map(|row| occurring(row.quantity())).collect();
        // A row between speeds constrains the variables whose speeds occur in it.
        let speeds = self.variables(model).speeds;
        let constrained = |(value, constraint): (&Expr, &Constraint)| match constraint.level {
            Level::Positions => occurring(*value),
            Level::Speeds => {
                let symbols = graph.symbols_of(&[*value]);
                (0..speeds.len()).filter(|i| symbols.binary_search(&speeds[*i]).is_ok()).collect()
            }
        };
        let constraints: Vec<Vec<usize>> = self.constraints.iter().zip(&model.constraints).map(constrained).collect();
        let mut kinds = vec![Kind::Coordinate; n];
        kinds.extend(self.definitions.iter().map(|definition| Kind::Intermediate(occurring(*definition))));
        kinds.extend(constraints.iter().map(|_| Kind::Multiplier));
        let mut entries = BTreeSet::new();
        for row in &rows {
            entries.extend(row.iter().flat_map(|i| row.iter().map(|j| (*i, *j))));
        }
        for (i, constraint) in constraints.iter().enumerate() {
            entries.extend(constraint.iter().map(|j| (n + p + i, *j)));
        }
        let formed: usize = rows.iter().map(|row| row.len() * (row.len() + 3) / 2).sum();
        // Without an order every state would be solved by pivoting.
        let entries = entries.into_iter().map(|place| Entry { place, is_moving: true });
        order(Pattern::new(kinds.clone(), entries), Multipliers::Last)
            .map_or(usize::MAX, |actions| formed + cost(&kinds, &actions))
    }
}
