//! The derivatives of the equations of motion with respect to state and parameters.
//!
//! With the equations as K z = r, z = (q'', lambda), any derivative of the solution solves K dz = dr - dK z: here are
//! the right-hand sides, the derivatives of r - K z at fixed z (the implicit function theorem).
//!
//! There are two ways to write r - K z by coordinates and speeds: from mass matrix and constraint Jacobian, or as inverse
//! dynamics with the constraints among the velocities, C' with the force lambda, and with C'' for their rows. The latter
//! forms no matrix whose derivatives would be multiplied by z, so in space and in loops it mostly takes fewer operations.
//! Both are planned, and the one with fewer operations is taken.
//!
//! The factors are those of `dynamics`, if it has some. Where no kernel is generated, and always with intermediate
//! quantities, the trait gives the same numbers by running `dynamics` on dual numbers.

use super::column::Column;
use super::constraints::switched;
use super::inverse::{along_coordinates, velocities_and_forces};
use super::rows::load_rows;
use super::tmt::Tmt;
use super::turns::ConstraintForm;
use super::variables::{Derivatives, inner};
use crate::kernel_id::KernelId;
use crate::model::{Level, Model};
use crate::symbolic::{Differential, Expr, Graph, Symbol};

/// With more coordinates, the kernel of the derivatives with respect to the state is generated only on request: it
/// grows with the square of the number of coordinates.
const MOST_COORDINATES: usize = 12;

/// Whether the model asks for the derivatives by the state.
pub(super) fn is_wanted_by_state(model: &Model) -> bool {
    match model.kernels {
        Some(_) => model.wants(KernelId::DynamicsJacobian),
        None => model.coordinates.len() <= MOST_COORDINATES,
    }
}

/// Enters the derivatives that the model asks for, but those by many coordinates where links may give them by recursion: of few
/// coordinates they may take fewer operations than that.
pub(super) fn derive(
    graph: &mut Graph,
    model: &Model,
    tmt: &Tmt,
    form: &mut ConstraintForm,
    derivatives: &mut Derivatives,
) {
    if model.links.is_empty() || model.coordinates.len() <= MOST_COORDINATES {
        derive_left_out(graph, model, tmt, form, derivatives);
    }
    by_parameters(graph, model, tmt, form);
}

/// Enters the derivatives by the state, if the model asks for them and they are not there.
pub(super) fn derive_left_out(
    graph: &mut Graph,
    model: &Model,
    tmt: &Tmt,
    form: &mut ConstraintForm,
    derivatives: &mut Derivatives,
) {
    if !form.by_state.is_empty() || !is_wanted_by_state(model) {
        return;
    }
    let residual = residual(graph, model, tmt, form);
    let speeds: Vec<Symbol> = model.coordinates.iter().map(|c| c.speed).collect();
    let by_positions = columns(graph, form, &residual, &mut derivatives.by_variable);
    let mut by_speed = partials(graph, &speeds);
    form.by_state.push([by_positions, columns(graph, form, &residual, &mut by_speed)]);
}

/// Enters the derivatives by the state once more, from the residual as inverse dynamics, where there are few coordinates
/// and velocities are polynomials of speeds.
pub(super) fn derive_inversely<'a>(
    graph: &mut Graph,
    model: &Model,
    forms: impl Iterator<Item = &'a mut ConstraintForm>,
    derivatives: &mut Derivatives,
) {
    let mut forms = forms.filter(|form| !form.by_state.is_empty()).peekable();
    if forms.peek().is_none() || model.coordinates.len() > MOST_COORDINATES {
        return;
    }
    let Some(residual) = inverse_residual(graph, model) else { return };
    let speeds: Vec<Symbol> = model.coordinates.iter().map(|c| c.speed).collect();
    let mut by_speed = partials(graph, &speeds);
    let columns = [&mut derivatives.by_variable, &mut by_speed].map(|differentials| {
        let column = |d: &mut Differential| residual.iter().map(|expr| d.of(graph, *expr)).collect();
        differentials.iter_mut().map(column).collect::<Vec<Vec<Expr>>>()
    });
    for form in forms {
        let columns = columns.each_ref().map(|columns| form.at_fixed_angles(graph, columns));
        form.by_state.push(columns);
    }
}

/// Enters the derivatives by the parameters, if the model asks for them.
fn by_parameters(graph: &mut Graph, model: &Model, tmt: &Tmt, form: &mut ConstraintForm) {
    // Whether an input follows its declared course is known at run time alone.
    let courses: Vec<Expr> = model.inputs.iter().map(|input| input.course).collect();
    let occurring = graph.symbols_of(&courses);
    let is_wanted = model.wants(KernelId::DynamicsSensitivity);
    if !is_wanted || model.parameters.iter().any(|p| occurring.contains(&p.symbol)) {
        return;
    }
    let residual = residual(graph, model, tmt, form);
    let parameters: Vec<Symbol> = model.parameters.iter().map(|p| p.symbol).collect();
    let mut by_parameter = partials(graph, &parameters);
    form.by_parameters = Some(columns(graph, form, &residual, &mut by_parameter));
}

fn columns(
    graph: &mut Graph,
    form: &ConstraintForm,
    residual: &[Expr],
    differentials: &mut [Differential],
) -> Vec<Column> {
    let angles: Vec<Expr> = form.turns.iter().map(|turn| turn.angle).collect();
    let mut all =
        |d: &mut Differential, exprs: &[Expr]| -> Vec<Expr> { exprs.iter().map(|expr| d.of(graph, *expr)).collect() };
    differentials.iter_mut().map(|d| Column { residual: all(d, residual), angles: all(d, &angles) }).collect()
}

fn partials(graph: &mut Graph, symbols: &[Symbol]) -> Vec<Differential> {
    symbols.iter().map(|symbol| Differential::partial(graph, *symbol)).collect()
}

/// T_q' (F - M (T_q q'' + g)) - C_q' lambda, then -(C_q q'' + (C_q q' + C_t)_q q' + (..)_t).
fn residual(graph: &mut Graph, model: &Model, tmt: &Tmt, form: &ConstraintForm) -> Vec<Expr> {
    let accelerations = model.accelerations(graph);
    let multipliers: Vec<Expr> = form.multipliers.iter().map(|symbol| graph.variable(*symbol)).collect();
    let mut rows = Vec::new();
    for (j, rhs) in tmt.right_hand_side.iter().enumerate() {
        let inertial = inner(graph, &tmt.mass_matrix[j], &accelerations);
        let column: Vec<Expr> = form.jacobian.iter().map(|row| row[j]).collect();
        let reaction = inner(graph, &column, &multipliers);
        let known = graph.sub(*rhs, inertial);
        rows.push(graph.sub(known, reaction));
    }
    for (row, convective) in form.jacobian.iter().zip(&form.convective) {
        let moving = inner(graph, row, &accelerations);
        let sum = graph.add(moving, *convective);
        rows.push(graph.neg(sum));
    }
    rows
}

/// The same as inverse dynamics of the rows as declared; none where velocities are no polynomials of speeds.
fn inverse_residual(graph: &mut Graph, model: &Model) -> Option<Vec<Expr>> {
    let mut motion = model.time_derivative(graph);
    let rows = load_rows(graph, model);
    let mut pairs = velocities_and_forces(graph, &mut motion, &rows);
    let mut accelerations = vec![];
    for constraint in &model.constraints {
        let rate = match constraint.level {
            Level::Positions => motion.of(graph, constraint.value),
            Level::Speeds => constraint.value,
        };
        let acceleration = motion.of(graph, rate);
        let mut switched = |expr: Expr| constraint.activity.map_or(expr, |activity| switched(graph, activity, expr));
        let (rate, acceleration) = (switched(rate), switched(acceleration));
        pairs.push((rate, graph.variable(constraint.multiplier)));
        accelerations.push(acceleration);
    }
    let mut residual = along_coordinates(graph, model, &pairs)?;
    residual.extend(accelerations);
    Some(residual.into_iter().map(|expr| graph.neg(expr)).collect())
}
