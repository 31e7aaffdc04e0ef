//! The derivatives of the equations of motion with respect to state and parameters.
//!
//! With the equations as K z = r, z = (q'', lambda), any derivative of the solution solves K dz = dr - dK z: here are
//! the right-hand sides, the derivatives of r - K z at fixed z (the implicit function theorem).
//!
//! For those by the state r - K z is written in another way too (`shortened`).
//!
//! The factors are those of `dynamics`, if it has some. Where no kernel is generated, and always with intermediate
//! quantities, the trait gives the same numbers by running `dynamics` on dual numbers.

use super::column::Column;
use super::tmt::Tmt;
use super::turns::ConstraintForm;
use super::variables::{Derivatives, inner};
use crate::kernel_id::KernelId;
use crate::model::Model;
use crate::symbolic::{Differential, Expr, Graph, Symbol};

/// With more coordinates, the kernel of the derivatives with respect to the state is generated only on request: it
/// grows with the square of the number of coordinates.
pub(super) const MOST_COORDINATES: usize = 12;

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
    forms: &mut [&mut ConstraintForm],
    derivatives: &mut Derivatives,
) {
    for form in forms {
        if model.links.is_empty() || model.coordinates.len() <= MOST_COORDINATES {
            derive_by_state(graph, model, tmt, &mut [form], derivatives);
        }
        by_parameters(graph, model, tmt, form);
    }
}

/// Enters the derivatives by the state, if the model asks for them, where they are not there.
pub(super) fn derive_by_state(
    graph: &mut Graph,
    model: &Model,
    tmt: &Tmt,
    forms: &mut [&mut ConstraintForm],
    derivatives: &mut Derivatives,
) {
    if !is_wanted_by_state(model) {
        return;
    }
    for form in forms.iter_mut().filter(|form| form.by_state.is_empty()) {
        let residual = residual(graph, model, tmt, form);
        let speeds: Vec<Symbol> = model.coordinates.iter().map(|c| c.speed).collect();
        let by_positions = columns(graph, form, &residual, &mut derivatives.by_variable);
        let mut by_speed = partials(graph, &speeds);
        form.by_state.push([by_positions, columns(graph, form, &residual, &mut by_speed)]);
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
        let column: Vec<Expr> = form.rows.jacobian.iter().map(|row| row[j]).collect();
        let reaction = inner(graph, &column, &multipliers);
        let known = graph.sub(*rhs, inertial);
        rows.push(graph.sub(known, reaction));
    }
    for (row, convective) in form.rows.jacobian.iter().zip(&form.rows.convective) {
        let moving = inner(graph, row, &accelerations);
        let sum = graph.add(moving, *convective);
        rows.push(graph.neg(sum));
    }
    rows
}
