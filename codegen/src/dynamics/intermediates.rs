//! Intermediate quantities: parts of long sums that get variables of their own.
//!
//! In a chain the position of each body is that of the one before and a little more. Written in coordinates alone each
//! row of T depends on all coordinates before it, and T_q' M T_q costs the cube of their number. With the positions
//! in between as variables y = phi(y, q, t), each row depends on a few variables, and elimination from the tip costs
//! as much as there are bodies. Which sums are worth it is counted, not declared.

use super::order::{Entry, Kind, Multipliers, Pattern, cost, order};
use super::parts::Candidates;
use super::rows::LoadRow;
use super::variables::{Derivatives, Differentiated, Variables, inner};
use crate::model::{Constraint, Level, Model};
use crate::symbolic::{Expr, Graph, Symbol};
use std::collections::BTreeSet;

/// A variable y with its definition in terms of coordinates and of the intermediates before it.
pub struct Intermediate {
    /// The user's name for it, or one of ours.
    pub name: String,
    /// y, y', y'' and y_t.
    pub symbols: [Symbol; 4],
    /// phi with its derivatives.
    pub definition: Differentiated,
    /// y'' = phi_y y'' + phi_q q'' + ..
    pub acceleration: Expr,
    /// The partial derivative with respect to explicit time, at fixed coordinates: phi_y y_t + phi_t.
    pub time_derivative: Expr,
}

impl Intermediate {
    /// y_t as it occurs in what depends on y: 0 or its symbol.
    pub(super) fn drift(&self, graph: &mut Graph) -> Expr {
        if graph.is_zero(self.time_derivative) { self.time_derivative } else { graph.variable(self.symbols[3]) }
    }
}

/// x_t at fixed coordinates, of a quantity over variables that may have a `drifts` y_t of their own.
pub(super) fn total_time_derivative(model: &mut Model, quantity: &Differentiated, drifts: &[Expr]) -> Expr {
    let carried = inner(model, drifts, &quantity.jacobian);
    model.graph.add(carried, quantity.time_derivative)
}

/// Rows and constraints with intermediates in them.
pub(super) struct Formulation {
    pub(super) rows: Vec<LoadRow>,
    pub(super) constraints: Vec<Expr>,
    /// The definitions, each of coordinates and those before it.
    pub(super) definitions: Vec<Expr>,
    pub(super) symbols: Vec<[Symbol; 4]>,
    pub(super) names: Vec<String>,
}

/// With fewer coordinates the equations are short whatever is done.
const FEWEST_COORDINATES: usize = 5;

/// Of how many coordinates an intermediate must be made to be tried.
const DEPTHS: [usize; 4] = [2, 3, 4, 6];

/// The cheapest way to write rows and constraints.
pub(super) fn cheapest(model: &mut Model, rows: Vec<LoadRow>) -> Formulation {
    let plain = Formulation::without(model, rows);
    // Along chains of bodies in space velocities are carried from frame to frame, which is as short.
    if model.coordinates.len() < FEWEST_COORDINATES || model.dimension == 3 {
        return plain;
    }
    let mut best = (plain.cost(model), None);
    let candidates = Candidates::of(model, &plain);
    for depth in DEPTHS {
        let Some(formulation) = candidates.formulation(model, &plain, depth) else { continue };
        let cost = formulation.cost(model);
        if cost < best.0 {
            best = (cost, Some(formulation));
        }
    }
    best.1.unwrap_or(plain)
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
        model: &mut Model,
        variables: &Variables,
        derivatives: &mut Derivatives,
    ) -> Vec<Intermediate> {
        let accelerations: Vec<Expr> = variables.accelerations.iter().map(|a| model.graph.variable(*a)).collect();
        let mut drifts = vec![model.graph.zero(); variables.len()];
        let mut intermediates = Vec::new();
        for (i, definition) in self.definitions.iter().enumerate() {
            let definition = derivatives.of_quantity(model, variables, *definition);
            let moving = inner(model, &definition.jacobian, &accelerations);
            let acceleration = model.graph.add(moving, definition.convective);
            let time_derivative = total_time_derivative(model, &definition, &drifts);
            let (name, symbols) = (self.names[i].clone(), self.symbols[i]);
            let intermediate = Intermediate { name, symbols, definition, acceleration, time_derivative };
            drifts[model.coordinates.len() + i] = intermediate.drift(&mut model.graph);
            intermediates.push(intermediate);
        }
        intermediates
    }

    /// About how many multiplications it takes to form and to solve the equations.
    fn cost(&self, model: &Model) -> usize {
        let variables = self.variables(model).positions;
        let (n, p) = (model.coordinates.len(), self.symbols.len());
        let occurring = |expr: Expr| -> Vec<usize> {
            let symbols = model.graph.symbols_of(&[expr]);
            (0..variables.len()).filter(|i| symbols.binary_search(&variables[*i]).is_ok()).collect()
        };
        let rows: Vec<Vec<usize>> = self.rows.iter().map(|row| occurring(row.quantity())).collect();
        // What a row between speeds constrains are the variables whose speeds stand in it.
        let speeds = self.variables(model).speeds;
        let constrained = |(value, constraint): (&Expr, &Constraint)| match constraint.level {
            Level::Positions => occurring(*value),
            Level::Speeds => {
                let symbols = model.graph.symbols_of(&[*value]);
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
