//! The equations of motion as a linear system of values, its solution, and the derivatives of that solution.

use super::eliminate::{Factors, System, Unknown, factorise};
use super::entries::{constraint_entries, mass_entries};
use super::links::{Joints, LinkTerms, OpenTerms, Solved};
use super::lower::Lowering;
use super::notes::Notes;
use super::planner::variable_names;
use super::results::Results;
use super::separated::separated;
use super::turns::{derivatives_turned_back, turned_back};
use super::values::Value;
use crate::dynamics::order::Multipliers;
use crate::dynamics::{Column, ConstraintForm, ConstraintRows, EquationsOfMotion, Intermediate, Links, Separation};
use crate::kernel_id::Record;
use crate::symbolic::Expr;

/// The equations of motion solved at one state.
pub(super) struct Motion<'a> {
    equations: &'a EquationsOfMotion,
    /// The solved system.
    pub(super) form: &'a ConstraintForm,
    /// Accelerations, then multipliers.
    unknowns: Vec<Value>,
    power: Value,
    /// Each pivot with the scale for its cancellation; none where there is no order to solve in.
    pivots: Option<Vec<(Value, Value)>>,
    factors: Option<Factors>,
    /// How many unknowns these have.
    unknown_count: usize,
    /// Names for what was computed, and its order.
    pub(super) notes: Notes,
}

impl<'a> Motion<'a> {
    /// By a factorisation of the system in one of its forms.
    pub(super) fn factorised(
        equations: &'a EquationsOfMotion,
        form: &'a ConstraintForm,
        rows: &ConstraintRows,
        links: Option<&Links>,
        separations: &[Separation],
        lowering: &mut Lowering,
    ) -> Motion<'a> {
        let mut names = unknown_names(equations, form);
        let mut notes = Notes::default();
        let links = links.map(|links| LinkTerms::of(lowering, links));
        let (system, mut rhs) = match &links {
            None => {
                let system = system(equations, form, rows, lowering);
                (system, right_hand_side(lowering, &equations.tmt.right_hand_side, &rows.convective))
            }
            Some(links) => by_links(equations, form, rows, links, lowering),
        };
        let system = match separations {
            [] => system,
            _ => separated(lowering, separations, system, &mut names, &mut rhs),
        };
        let mut constants = constants(equations, lowering);
        constants.resize(names.len(), lowering.values.constant(0.0));
        let factors = factorise(&mut lowering.values, &system, &names, &mut notes);
        let mut solved = match &factors {
            Some(factors) => factors.solve(&mut lowering.values, rhs, &constants, &mut |value, k| {
                notes.right_hand_side(value, &names[k]);
            }),
            None => vec![lowering.values.constant(0.0); names.len()],
        };
        solved.truncate(unknown_count(equations));
        let variables = equations.variables.len();
        let symbols = equations.variables.accelerations.iter().chain(&form.multipliers).copied();
        lowering.replace(symbols.zip(solved.iter().copied()).collect());
        turned_back(lowering, form, &mut solved[variables..]);
        for (i, value) in solved.iter().enumerate() {
            let name = match i.checked_sub(variables) {
                None => format!("{}_ddot", names[i]),
                Some(row) => format!("lambda_{}", equations.model.constraints[row].name),
            };
            notes.name(*value, name);
        }
        let multipliers = equations.model.constraints.iter().map(|c| c.multiplier);
        lowering.replace(multipliers.zip(solved[variables..].iter().copied()).collect());
        let power = match &links {
            Some(links) if equations.energy.power_along_variables.is_some() => links.power(lowering),
            _ => lowering.lower(equations.energy.power),
        };
        let intermediates = equations.model.coordinates.len()..variables;
        let unknowns = solved.into_iter().enumerate().filter(|(i, _)| !intermediates.contains(i)).map(|(_, x)| x);
        let pivots = factors.as_ref().map(|factors| factors.pivots.clone());
        let (unknown_count, unknowns) = (names.len(), unknowns.collect());
        Motion { equations, form, unknowns, power, pivots, factors, unknown_count, notes }
    }

    /// From the tips of a tree to the world and back; nothing where it is not open.
    pub(super) fn of_open_tree(
        equations: &'a EquationsOfMotion,
        links: &Links,
        joints: Joints,
        lowering: &mut Lowering,
    ) -> Option<Motion<'a>> {
        let terms = OpenTerms::of(lowering, equations, links)?;
        let form = &equations.declared;
        let mut notes = Notes::default();
        let Solved { accelerations, multipliers, pivots } = terms.solve(lowering, joints, &mut notes);
        let mut unknowns = accelerations;
        unknowns.extend(multipliers);
        let symbols = equations.variables.accelerations.iter().chain(&form.multipliers).copied();
        lowering.replace(symbols.zip(unknowns.iter().copied()).collect());
        let names = unknown_names(equations, form);
        let n = equations.model.coordinates.len();
        for (i, (value, name)) in unknowns.iter().zip(&names).enumerate() {
            notes.name(*value, if i < n { format!("{name}_ddot") } else { name.clone() });
        }
        let power = match equations.energy.power_along_variables {
            Some(_) => terms.power(lowering),
            None => lowering.lower(equations.energy.power),
        };
        Some(Motion { equations, form, unknowns, power, pivots: Some(pivots), factors: None, unknown_count: 0, notes })
    }

    /// Whether it comes from the tips of a tree.
    pub(super) fn is_of_open_tree(&self) -> bool {
        self.is_planned() && self.factors.is_none()
    }

    /// Whether there is an order to solve them in; without one every state is refused.
    pub(super) fn is_planned(&self) -> bool {
        self.pivots.is_some()
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
    pub(super) fn jacobian(
        &self,
        lowering: &mut Lowering,
        [by_positions, by_speeds]: &[Vec<Column>; 2],
    ) -> Results<Value> {
        let [accelerations_by_positions, multipliers_by_positions] = self.derivatives(lowering, by_positions);
        let [accelerations_by_speeds, multipliers_by_speeds] = self.derivatives(lowering, by_speeds);
        let accelerations = [accelerations_by_positions, accelerations_by_speeds];
        state_derivatives(accelerations, [multipliers_by_positions, multipliers_by_speeds], self.refused())
    }

    /// d(q'', lambda)/d(parameters).
    pub(super) fn sensitivity(&self, lowering: &mut Lowering, by_parameters: &[Column]) -> Results<Value> {
        let [accelerations, multipliers] = self.derivatives(lowering, by_parameters);
        Results::record(
            Record::DynamicsSensitivity,
            [("accelerations", accelerations), ("multipliers", multipliers), ("refused", self.refused())],
        )
    }

    /// Solves K dz = d(r - K z) for each column, with the same form of K; gives the rows of q'' and those of lambda.
    fn derivatives(&self, lowering: &mut Lowering, columns: &[Column]) -> [Results<Value>; 2] {
        let zero = lowering.values.constant(0.0);
        let constants = vec![zero; self.unknown_count];
        let n = self.equations.model.coordinates.len();
        let solved: Vec<Vec<Value>> = columns
            .iter()
            .map(|column| {
                let mut rhs = lowering.lower_all(&column.residual);
                rhs.resize(self.unknown_count, zero);
                let Some(factors) = &self.factors else { return constants.clone() };
                let mut solved = factors.solve(&mut lowering.values, rhs, &constants, &mut |_, _| ());
                solved.truncate(unknown_count(self.equations));
                derivatives_turned_back(lowering, self.form, &self.unknowns[n..], &column.angles, &mut solved[n..]);
                solved
            })
            .collect();
        let (accelerations, multipliers): (Vec<_>, Vec<_>) =
            solved.iter().map(|column| column.split_at(n)).map(|(a, b)| (a.to_vec(), b.to_vec())).unzip();
        [columns_of(&accelerations), columns_of(&multipliers)]
    }

    fn refused(&self) -> Results<Value> {
        Results::Refused(self.pivots.clone())
    }
}

/// Derivatives by positions and by speeds.
pub(super) fn state_derivatives(
    accelerations: [Results<Value>; 2],
    multipliers: [Results<Value>; 2],
    refused: Results<Value>,
) -> Results<Value> {
    let ([by_positions, by_speeds], [multipliers_by_positions, multipliers_by_speeds]) = (accelerations, multipliers);
    Results::record(
        Record::DynamicsJacobian,
        [
            ("accelerations_by_positions", by_positions),
            ("accelerations_by_speeds", by_speeds),
            ("multipliers_by_positions", multipliers_by_positions),
            ("multipliers_by_speeds", multipliers_by_speeds),
            ("refused", refused),
        ],
    )
}

/// The matrix of these columns, of which there is at least one.
pub(super) fn columns_of(columns: &[Vec<Value>]) -> Results<Value> {
    let rows = columns.first().map_or(0, Vec::len);
    Results::Matrix(columns.len(), (0..rows).map(|i| columns.iter().map(|column| column[i]).collect()).collect())
}

/// The system and its right-hand side by recursions over links.
fn by_links(
    equations: &EquationsOfMotion,
    form: &ConstraintForm,
    rows: &ConstraintRows,
    links: &LinkTerms,
    lowering: &mut Lowering,
) -> (System, Vec<Value>) {
    let entries = links.mass_matrix(&equations.graph, lowering);
    let system = system_with(equations, entries, form, rows, lowering);
    let mut rhs = links.right_hand_side(lowering);
    rhs.extend(negated(lowering, &rows.convective));
    (system, rhs)
}

fn unknown_names(equations: &EquationsOfMotion, form: &ConstraintForm) -> Vec<String> {
    let mut names = variable_names(equations);
    names.extend(equations.model.constraints.iter().map(|c| format!("lambda_{}", c.name)));
    for row in form.turns.iter().flat_map(|turn| turn.rows) {
        names[equations.variables.len() + row].push_str("_turned");
    }
    names
}

fn unknown_count(equations: &EquationsOfMotion) -> usize {
    equations.variables.len() + equations.model.constraints.len()
}

/// Mass matrix and constraint Jacobian over coordinates, intermediates and multipliers; on the diagonal, activity - 1
/// for the multiplier of a constraint that events switch, so that it is 0 where the constraint is released, and -1 for
/// that of a row that nothing moves.
pub(super) fn system(
    equations: &EquationsOfMotion,
    form: &ConstraintForm,
    rows: &ConstraintRows,
    lowering: &mut Lowering,
) -> System {
    let entries = mass_entries(lowering, &equations.graph, &equations.tmt.mass_matrix);
    system_with(equations, entries, form, rows, lowering)
}

/// The same without the mass matrix, which the constraint Jacobian of many constraints does not need. Its entries decide
/// the order in which intermediates are eliminated, so they stay where there are any.
pub(super) fn constraint_system(equations: &EquationsOfMotion, lowering: &mut Lowering) -> System {
    let declared = &equations.declared;
    match equations.intermediates.is_empty() {
        true => system_with(equations, Vec::new(), declared, &declared.rows, lowering),
        false => system(equations, declared, &declared.rows, lowering),
    }
}

/// The same with the entries of the mass matrix given.
fn system_with(
    equations: &EquationsOfMotion,
    mut entries: Vec<(usize, usize, Value)>,
    form: &ConstraintForm,
    rows: &ConstraintRows,
    lowering: &mut Lowering,
) -> System {
    let EquationsOfMotion { model, intermediates, graph, variables, .. } = equations;
    let activities = model.constraints.iter().map(|constraint| constraint.activity);
    entries.extend(constraint_entries(lowering, graph, variables.len(), &rows.jacobian, activities));
    let mut unknowns: Vec<Unknown> = model.coordinates.iter().map(|_| Unknown::Coordinate).collect();
    for y in intermediates {
        unknowns.push(Unknown::Intermediate(definition(equations, lowering, y)));
    }
    unknowns.extend(model.constraints.iter().map(|_| Unknown::Multiplier));
    let multipliers = if form.turns.is_empty() { Multipliers::Last } else { Multipliers::Soon };
    System { unknowns, entries, multipliers }
}

/// The variables that an intermediate is defined by, with their coefficients.
pub(super) fn definition(
    equations: &EquationsOfMotion,
    lowering: &mut Lowering,
    intermediate: &Intermediate,
) -> Vec<(usize, Value)> {
    let entries = intermediate.definition.jacobian.iter().copied().enumerate();
    let entries = entries.filter(|(_, expr)| !equations.graph.is_zero(*expr));
    entries.map(|(j, expr)| (j, lowering.lower(expr))).collect()
}

/// Forces, then the negated constraint terms.
pub(super) fn right_hand_side(lowering: &mut Lowering, forces: &[Expr], constraint_terms: &[Expr]) -> Vec<Value> {
    let mut rhs = lowering.lower_all(forces);
    rhs.extend(negated(lowering, constraint_terms));
    rhs
}

fn negated(lowering: &mut Lowering, exprs: &[Expr]) -> Vec<Value> {
    lowering.lower_all(exprs).into_iter().map(|value| lowering.values.negate(value)).collect()
}

/// The acceleration-free terms of the definitions of the intermediates, at their places; 0 elsewhere.
fn constants(equations: &EquationsOfMotion, lowering: &mut Lowering) -> Vec<Value> {
    let mut constants = vec![lowering.values.constant(0.0); unknown_count(equations)];
    for (i, y) in equations.intermediates.iter().enumerate() {
        constants[equations.model.coordinates.len() + i] = lowering.lower(y.definition.convective);
    }
    constants
}
