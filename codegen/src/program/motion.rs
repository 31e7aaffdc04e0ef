//! The equations of motion as a linear system of values, its solution, and the derivatives of that solution.

use super::eliminate::{Factors, Labels, System, Unknown, factorise};
use super::lower::Lowering;
use super::results::{Record, Results};
use super::values::{Input, Value};
use crate::dynamics::EquationsOfMotion;
use crate::symbolic::Expr;

/// The equations of motion solved at one state.
pub(super) struct Motion<'a> {
    equations: &'a EquationsOfMotion,
    /// Accelerations, then multipliers.
    unknowns: Vec<Value>,
    power: Value,
    factors: Option<Factors>,
    /// Names for what was computed.
    pub(super) labels: Labels,
}

impl<'a> Motion<'a> {
    pub(super) fn solve(equations: &'a EquationsOfMotion, lowering: &mut Lowering) -> Motion<'a> {
        let names = unknown_names(equations);
        let mut labels = Labels::new();
        let system = system(equations, lowering);
        let rhs = right_hand_side(equations, lowering);
        let factors = factorise(&mut lowering.values, &system, &names, &mut labels);
        let zero = lowering.values.constant(0.0);
        let constants = vec![zero; names.len()];
        let unknowns = match &factors {
            Some(factors) => factors.solve(&mut lowering.values, rhs, &constants, |value, k| {
                labels.push((value, format!("rhs_{}", names[k])));
            }),
            None => constants,
        };
        let n = equations.model.coordinates.len();
        for (i, value) in unknowns.iter().enumerate() {
            let name = if i < n { format!("{}_ddot", names[i]) } else { names[i].clone() };
            labels.push((*value, name));
        }
        let inputs = (0..n).map(Input::Acceleration).chain((0..names.len() - n).map(Input::Multiplier));
        lowering.replace_inputs(inputs.zip(unknowns.iter().copied()).collect());
        let power = lowering.lower(equations.energy.power);
        Motion { equations, unknowns, power, factors, labels }
    }

    /// q'', lambda and power.
    pub(super) fn dynamics(&self) -> Results<Value> {
        let (accelerations, multipliers) = self.unknowns.split_at(self.equations.model.coordinates.len());
        Results::record(
            Record::Dynamics,
            [
                ("accelerations", Results::Vector(accelerations.to_vec())),
                ("multipliers", Results::Vector(multipliers.to_vec())),
                ("power", Results::Scalar(self.power)),
                ("refused", self.refused()),
            ],
        )
    }

    /// d(q'', lambda)/d(q, q').
    pub(super) fn jacobian(&self, lowering: &mut Lowering) -> Results<Value> {
        let sensitivity = &self.equations.sensitivity;
        let [accelerations_by_positions, multipliers_by_positions] =
            self.derivatives(lowering, &sensitivity.by_positions);
        let [accelerations_by_speeds, multipliers_by_speeds] = self.derivatives(lowering, &sensitivity.by_speeds);
        Results::record(
            Record::DynamicsJacobian,
            [
                ("accelerations_by_positions", accelerations_by_positions),
                ("accelerations_by_speeds", accelerations_by_speeds),
                ("multipliers_by_positions", multipliers_by_positions),
                ("multipliers_by_speeds", multipliers_by_speeds),
                ("refused", self.refused()),
            ],
        )
    }

    /// d(q'', lambda)/d(parameters).
    pub(super) fn sensitivity(&self, lowering: &mut Lowering) -> Results<Value> {
        let [accelerations, multipliers] = self.derivatives(lowering, &self.equations.sensitivity.by_parameters);
        Results::record(
            Record::DynamicsSensitivity,
            [("accelerations", accelerations), ("multipliers", multipliers), ("refused", self.refused())],
        )
    }

    /// Solves K dz = d(r - K z) for each column; gives the rows of q'' and those of lambda.
    fn derivatives(&self, lowering: &mut Lowering, columns: &[Vec<Expr>]) -> [Results<Value>; 2] {
        let zero = lowering.values.constant(0.0);
        let constants = vec![zero; self.unknowns.len()];
        let solved: Vec<Vec<Value>> = columns
            .iter()
            .map(|column| {
                let rhs = lowering.lower_all(column);
                match &self.factors {
                    Some(factors) => factors.solve(&mut lowering.values, rhs, &constants, |_, _| ()),
                    None => constants.clone(),
                }
            })
            .collect();
        let row = |i: usize| solved.iter().map(|column| column[i]).collect();
        let n = self.equations.model.coordinates.len();
        let matrix = |rows: std::ops::Range<usize>| Results::Matrix(columns.len(), rows.map(row).collect());
        [matrix(0..n), matrix(n..self.unknowns.len())]
    }

    fn refused(&self) -> Results<Value> {
        Results::Refused(self.factors.as_ref().map(|factors| factors.pivots.clone()))
    }
}

fn unknown_names(equations: &EquationsOfMotion) -> Vec<String> {
    let model = &equations.model;
    let coordinates = model.coordinates.iter().map(|c| c.name.clone());
    coordinates.chain(model.constraints.iter().map(|c| format!("lambda_{}", c.name))).collect()
}

/// Mass matrix and constraint Jacobian.
fn system(equations: &EquationsOfMotion, lowering: &mut Lowering) -> System {
    let EquationsOfMotion { model, tmt, constraints, .. } = equations;
    let n = model.coordinates.len();
    let mut entries = Vec::new();
    let mut enter = |i: usize, j: usize, expr: Expr| {
        if !model.graph.is_zero(expr) {
            entries.push((i, j, lowering.lower(expr)));
        }
    };
    for (i, row) in tmt.mass_matrix.iter().enumerate() {
        row[..=i].iter().enumerate().for_each(|(j, expr)| enter(i, j, *expr));
    }
    for (i, row) in constraints.jacobian.iter().enumerate() {
        row.iter().enumerate().for_each(|(j, expr)| enter(n + i, j, *expr));
    }
    let coordinates = (0..n).map(|_| Unknown::Coordinate);
    System { unknowns: coordinates.chain(model.constraints.iter().map(|_| Unknown::Multiplier)).collect(), entries }
}

/// T_q' (F - M g), then -((C_q q' + C_t)_q q' + (..)_t).
fn right_hand_side(equations: &EquationsOfMotion, lowering: &mut Lowering) -> Vec<Value> {
    let mut rhs = lowering.lower_all(&equations.tmt.right_hand_side);
    for expr in &equations.constraints.convective {
        let value = lowering.lower(*expr);
        rhs.push(lowering.values.negate(value));
    }
    rhs
}
