//! Stage 4: model to equations of motion, by the TMT method with cut loops.
//!
//! x = T(q, t) stacks the rotation and position of each body; v = T_q q' + T_t; loops are closed by
//! constraints C(q, t) = 0:
//!
//! ```text
//! [ T_q' M T_q   C_q' ] [ q''    ]   [ T_q' (F - M g)              ]
//! [ C_q          0    ] [ lambda ] = [ -(C_q q' + C_t)_q q' - (..)_t ]
//! ```
//!
//! with g = (T_q q' + T_t)_q q' + (..)_t, all of the convective accelerations. The reaction does virtual work
//! -lambda delta C on the system. Source: the TMT method as taught in TU Delft's course Multibody Dynamics B, with the full
//! convective term in place of the sum over columns.
//!
//! [`lagrange`] derives the same motion from the kinetic energy alone, to check this one.

mod attitudes;
mod auxiliary;
mod block;
mod cheapest;
mod column;
mod constraints;
mod energy;
mod events;
mod formulation;
mod free_base;
mod intermediates;
mod inverse;
mod kinematics;
mod lagrange;
mod linear;
mod link;
mod links;
mod mass_distribution;
mod open_derivatives;
mod open_tree;
pub mod order;
mod outputs;
mod parts;
mod pulses;
mod rows;
mod sensitivity;
mod separation;
mod shortened;
mod shorthands;
mod speeds;
mod switching;
mod tmt;
mod turns;
mod variables;

pub use block::{Block, Solution};
pub use column::Column;
pub use constraints::Constraints;
pub use energy::Energy;
pub use events::Events;
pub use free_base::FreeBase;
pub use intermediates::Intermediate;
pub use inverse::Inverse;
pub use kinematics::Kinematics;
pub use lagrange::{Lagrange, lagrange};
pub use link::Link;
pub use links::Links;
pub use mass_distribution::MassDistribution;
pub use open_derivatives::{BaseDerivatives, OpenDerivatives};
pub use open_tree::OpenTree;
pub use outputs::Outputs;
pub use separation::Separation;
pub use speeds::SpeedEquations;
pub use switching::{Switching, SwitchingKind};
pub use tmt::{Tmt, TmtRow};
pub use turns::{ConstraintForm, ConstraintRows, RowTurn};
pub use variables::{Differentiated, Variables};

use crate::kernel_id::KernelId;
use crate::model::{Model, Resolved};
use crate::symbolic::{Expr, Graph, Symbol};
use cheapest::cheapest;
use formulation::Formulation;
use rows::{LoadRow, load_rows};
use variables::Derivatives;

/// The equations of motion of a model, with n variables and m constraints. All expressions live in `graph`, in SI
/// units.
///
/// The variables are the coordinates, and in large mechanisms intermediate quantities after them.
pub struct EquationsOfMotion {
    /// The model that they were derived from.
    pub model: Model,
    /// Where all expressions live.
    pub graph: Graph,
    /// The variables that they are written in.
    pub variables: Variables,
    /// The intermediate quantities, each defined by coordinates and those before it.
    pub intermediates: Vec<Intermediate>,
    /// Mass matrix, convective and generalised forces.
    pub tmt: Tmt,
    /// Constraints with their derivatives.
    pub constraints: Constraints,
    /// The constraint rows as they are declared, to be solved.
    pub declared: ConstraintForm,
    /// The same with pairs turned, if any can be.
    pub turned: Option<ConstraintForm>,
    /// Kinetic energy and power.
    pub energy: Energy,
    /// Outputs and their rates.
    pub outputs: Outputs,
    /// Conditions of events and what their actions need.
    pub events: Events,
    /// Functions of time alone where expressions change their form.
    pub switching: Vec<Switching>,
    /// Functions of positions and speeds where loads change their form.
    pub load_conditions: Vec<Switching>,
    /// Inverse dynamics, if requested and without intermediates.
    pub inverse: Option<Inverse>,
    /// The links that move freely.
    pub free_bases: Vec<FreeBase>,
    /// The coordinates that parts have in common, if the equations are written to be cheap and without intermediates.
    pub separations: Vec<Separation>,
    /// The bodies of space as a tree, if the equations are written to be cheap and without intermediates.
    pub links: Option<Links>,
    /// The equations in generalised speeds, if there are any, in the coordinates alone.
    pub speeds: Option<SpeedEquations>,
    /// Symbols in some of these with what they stand for, which may contain those before them.
    pub shorthands: Vec<(Symbol, Expr)>,
}

/// Derives the equations of motion in the coordinates alone, for readers.
pub fn derive(resolved: Resolved) -> EquationsOfMotion {
    derive_as(resolved, |_, model, rows| Formulation::without(model, rows), |_, _, _, _, _| None)
}

/// Derives the equations of motion in whichever form costs less to solve.
pub fn derive_cheapest(resolved: Resolved) -> EquationsOfMotion {
    derive_as(resolved, cheapest, Links::derive)
}

/// The functions of time alone at whose zeros, or at the rows of whose tables, steps end.
fn switching_in_time(graph: &mut Graph, model: &Model) -> Vec<Switching> {
    let mut all = switching::of_time(graph, model);
    all.extend(pulses::middles_in_time(graph, model, &all));
    all
}

/// The functions of positions and speeds in loads for whose zeros, or the rows of whose tables, each step is searched, and those of
/// outputs, for which sweeps are.
fn load_conditions(graph: &mut Graph, model: &Model, rows: &[LoadRow]) -> Vec<Switching> {
    let mut all = switching::of_loads(graph, model, rows);
    all.extend(pulses::middles_by_positions(graph, model, &switching::searched(model, rows), &all));
    all.extend(switching::phases(graph, model, &all));
    all.extend(switching::of_outputs(graph, model, &all));
    let pulses = pulses::middles_by_positions(graph, model, &switching::output_values(model), &all);
    all.extend(pulses.into_iter().map(|pulse| Switching { kind: SwitchingKind::Output, ..pulse }));
    all
}

fn derive_as(
    resolved: Resolved,
    formulation: fn(&mut Graph, &Model, Vec<LoadRow>) -> Formulation,
    links: fn(&mut Graph, &Model, &Variables, &mut Derivatives, &[FreeBase]) -> Option<Links>,
) -> EquationsOfMotion {
    let Resolved { model, mut graph, displaced } = resolved;
    let (switching, rows) = (switching_in_time(&mut graph, &model), load_rows(&mut graph, &model));
    let load_conditions = load_conditions(&mut graph, &model, &rows);
    let speeds = speeds::derive(&mut graph, &model, &rows);
    let formulation = formulation(&mut graph, &model, rows);
    let variables = formulation.variables(&model);
    let mut derivatives = Derivatives::of(&mut graph, &model, &variables);
    let intermediates = formulation.intermediates(&mut graph, &model, &variables, &mut derivatives);
    let (is_plain, Formulation { rows, constraints, .. }) = (intermediates.is_empty(), formulation);
    let has_inverse = is_plain && model.wants(KernelId::InverseDynamics);
    let inverse = has_inverse.then(|| inverse::derive(&mut graph, &model, &rows)).flatten();
    let tmt = Tmt::derive(&mut graph, &variables, &mut derivatives, rows);
    let constraints = Constraints::derive(&mut graph, &model, &variables, &mut derivatives, constraints);
    let drifts = drifts(&mut graph, &model, &intermediates);
    let energy = Energy::derive(&mut graph, &model, &variables, &drifts, &tmt, &constraints);
    let (mut outputs, mut events) = (Outputs::derive(&mut graph, &model), Events::of(&model));
    let mut declared = ConstraintForm::declared(&model, &constraints);
    let mut turned = is_plain.then(|| ConstraintForm::turned(&mut graph, &model, &constraints)).flatten();
    let mut forms: Vec<&mut ConstraintForm> = [&mut declared].into_iter().chain(&mut turned).collect();
    if is_plain {
        sensitivity::derive(&mut graph, &model, &tmt, &mut forms, &mut derivatives);
    }
    // Last, so that nothing above notices.
    auxiliary::enter(&mut graph, &model, displaced, &mut outputs, &mut events);
    let free_bases = free_base::free_bases(&mut graph, &model, &constraints);
    let separations = if is_plain { separation::separations(&mut graph, &tmt, &constraints) } else { vec![] };
    let links = is_plain.then(|| links(&mut graph, &model, &variables, &mut derivatives, &free_bases)).flatten();
    let are_along_links = links.as_ref().is_some_and(Links::have_derivatives);
    if is_plain && !are_along_links {
        sensitivity::derive_by_state(&mut graph, &model, &tmt, &mut forms, &mut derivatives);
    }
    let with_attitudes = links.is_some() && !are_along_links;
    let shorthands = if is_plain { shortened::enter(&mut graph, &model, &mut forms, with_attitudes) } else { vec![] };
    EquationsOfMotion {
        model,
        graph,
        variables,
        intermediates,
        tmt,
        constraints,
        declared,
        turned,
        energy,
        outputs,
        events,
        switching,
        load_conditions,
        inverse,
        free_bases,
        separations,
        links,
        speeds,
        shorthands,
    }
}

/// The partial time derivatives of the variables.
fn drifts(graph: &mut Graph, model: &Model, intermediates: &[Intermediate]) -> Vec<Expr> {
    let mut drifts = vec![graph.zero(); model.coordinates.len()];
    drifts.extend(intermediates.iter().map(|y| y.drift(graph)));
    drifts
}
