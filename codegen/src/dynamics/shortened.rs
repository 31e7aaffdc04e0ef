//! The equations of motion written once more, to take fewer operations.
//!
//! r - K z is inverse dynamics with the constraints among the velocities, C' with the force lambda, and with C'' for their
//! rows. That forms no matrix whose derivatives would be multiplied by z, so in space and in loops its derivatives mostly take
//! fewer operations. Both ways are planned, and the one with fewer operations is taken; likewise for constraint rows by the
//! attitudes of links.

use super::attitudes::Attitudes;
use super::inverse::along_coordinates;
use super::rows::load_rows;
use super::sensitivity::MOST_COORDINATES;
use super::turns::{ConstraintForm, ConstraintRows};
use crate::model::Model;
use crate::symbolic::{Expr, Graph, Symbol};

/// Enters them in the forms of the constraints; gives the symbols that they contain with what these stand for.
pub(super) fn enter(
    graph: &mut Graph,
    model: &Model,
    forms: &mut [&mut ConstraintForm],
    with_attitudes: bool,
) -> Vec<(Symbol, Expr)> {
    let mut attitudes = match with_attitudes {
        true => Attitudes::all(graph, model),
        false => Attitudes::none(graph, model),
    };
    if attitudes.are_constrained(graph) {
        let rows = rows(graph, model, &mut attitudes);
        forms.iter_mut().for_each(|form| form.shorten(graph, &attitudes.shorthands, &rows));
    }
    let is_wanted = forms.iter().any(|form| !form.by_state.is_empty());
    if is_wanted && model.coordinates.len() <= MOST_COORDINATES {
        enter_derivatives(graph, model, forms, &mut attitudes);
    }
    attitudes.shorthands.definitions().to_vec()
}

/// The constraint rows by attitudes.
fn rows(graph: &mut Graph, model: &Model, attitudes: &mut Attitudes) -> ConstraintRows {
    let [rates, accelerated] = attitudes.constraints(graph);
    let [_, by_speeds] = attitudes.by_state(graph, &rates);
    let zero = graph.zero();
    let still = model.coordinates.iter().map(|c| (c.acceleration, zero)).collect();
    let convective = attitudes.shorthands.substitute(graph, &accelerated, still);
    let jacobian = (0..rates.len()).map(|row| by_speeds.iter().map(|column| column[row]).collect());
    ConstraintRows { jacobian: jacobian.collect(), convective }
}

/// The derivatives of r - K z, unless a velocity is no polynomial of speeds.
fn enter_derivatives(graph: &mut Graph, model: &Model, forms: &mut [&mut ConstraintForm], attitudes: &mut Attitudes) {
    let Some(residual) = residual(graph, model, attitudes) else { return };
    let columns = attitudes.by_state(graph, &residual);
    for form in forms.iter_mut().filter(|form| !form.by_state.is_empty()) {
        let columns = columns.each_ref().map(|columns| form.at_fixed_angles(graph, columns));
        form.by_state.push(columns);
    }
}

/// r - K z of the rows as declared.
fn residual(graph: &mut Graph, model: &Model, attitudes: &mut Attitudes) -> Option<Vec<Expr>> {
    let rows = load_rows(graph, model);
    let mut pairs = attitudes.velocities_and_forces(graph, &rows);
    let [rates, accelerated] = attitudes.constraints(graph);
    pairs.extend(rates.into_iter().zip(model.multipliers(graph)));
    let mut residual = along_coordinates(graph, model, &pairs, &mut attitudes.shorthands)?;
    residual.extend(accelerated);
    Some(residual.into_iter().map(|expr| graph.neg(expr)).collect())
}
