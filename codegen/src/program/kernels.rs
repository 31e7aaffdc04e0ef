//! The kernels of a mechanism.

use super::lower::Lowering;
use super::planner::Planner;
use super::prepared::prepared_kernels;
use super::reduced;
use super::results::Results;
use super::separate::separate_kernels;
use super::sparsity::Sparsity;
use super::speed_mass_matrix::speed_mass_matrix;
use super::ways::takes_rows;
use super::{Kernel, Program};
use crate::dynamics::EquationsOfMotion;
use crate::kernel_id::{KernelId, Record};
use crate::symbolic::Expr;
use crate::threads::side_by_side;
use rustc_hash::FxHashMap;

/// The largest sum allowed when multiplying out.
const LONGEST_EXPANSION: usize = 64;

/// Plans every kernel. `equations` is changed only by start values and other forms of expressions entering its graph.
pub fn plan(equations: &mut EquationsOfMotion) -> Program {
    let zero = equations.graph.zero();
    let alternatives = expansions(equations);
    let planner = Planner::new(equations, &alternatives);
    let (mut kernels, (others, sparsity)) =
        side_by_side(|| prepared_kernels(&planner), || other_kernels(&planner, zero));
    kernels.extend(others);
    Program { kernels, sparsity }
}

/// The kernels that share nothing with those of `prepare`, and which entries of C_q may differ from 0.
fn other_kernels(planner: &Planner, zero: Expr) -> (Vec<Kernel>, Option<Sparsity>) {
    let mut kernels = separate_kernels(planner, zero);
    let columns = reduced::columns_of_constraints(planner.equations, &mut planner.lowering());
    let sparsity = Sparsity::of(columns, planner.equations.model.coordinates.len());
    kernels.extend(sparsity.as_ref().map(|sparsity| sparse_linearization_kernel(planner, sparsity)));
    kernels.extend(generalized_speeds_kernel(planner));
    kernels.extend(speed_mass_matrix(planner));
    kernels.extend(event_values_kernel(planner));
    kernels.extend(switching_functions_kernel(planner));
    kernels.extend(load_conditions_kernel(planner));
    kernels.extend(input_values_kernel(planner));
    (kernels, sparsity)
}

/// Expressions with products of sums multiplied out, if terms then cancel; the power by forces along coordinates.
fn expansions(equations: &mut EquationsOfMotion) -> FxHashMap<Expr, Expr> {
    let takes_rows = takes_rows(equations);
    let EquationsOfMotion { graph, tmt, constraints, speeds, energy, .. } = equations;
    let terms = [&tmt.right_hand_side, &tmt.convective_forces, &tmt.generalized_forces];
    let terms = tmt.mass_matrix.iter().chain(terms).filter(|_| takes_rows);
    let in_speeds = speeds.iter().flat_map(|speeds| {
        let matrices = speeds.tmt.mass_matrix.iter().chain(&speeds.jacobian);
        matrices.chain([&speeds.tmt.right_hand_side, &speeds.convective]).flatten()
    });
    let constraints = constraints.jacobian.iter().chain([&constraints.convective, &constraints.time_derivative]);
    let zero = graph.zero();
    let exprs = terms.chain(constraints).flatten().chain(in_speeds).copied();
    let exprs: Vec<Expr> = exprs.filter(|expr| *expr != zero).collect();
    let expanded = exprs.into_iter().filter_map(|expr| Some((expr, graph.expand(expr, LONGEST_EXPANSION)?)));
    expanded.chain(energy.power_along_variables.map(|other| (energy.power, other))).collect()
}

/// The constraints linearised, with C_q by its entries.
fn sparse_linearization_kernel(planner: &Planner, sparsity: &Sparsity) -> Kernel {
    let e = planner.equations;
    let kernel = planner.kernel(KernelId::SparseLinearization, |lowering| {
        Results::record(
            Record::ConstraintLinearization,
            [
                ("values", Results::Vector(lowering.lower_all(&e.constraints.values))),
                ("jacobian", reduced::entries_of_constraints(e, lowering, sparsity)),
                ("time_derivative", reduced::constraint_time_derivative(e, lowering)),
            ],
        )
    });
    let entries = sparsity.rows.iter().map(|row| row.columns.len()).sum::<usize>();
    Kernel { docs: planner.documentation(kernel.id, 0, &[("entries", entries.to_string())]), ..kernel }
}

/// The generalised speeds at a state, if there are any.
fn generalized_speeds_kernel(planner: &Planner) -> Option<Kernel> {
    let speeds: Vec<Expr> = planner.equations.model.generalized_speeds.iter().map(|speed| speed.value).collect();
    let kernel = |lowering: &mut Lowering| Results::Vector(lowering.lower_all(&speeds));
    (!speeds.is_empty()).then(|| planner.kernel(KernelId::GeneralizedSpeeds, kernel))
}

/// The values that events set, if any.
fn event_values_kernel(planner: &Planner) -> Option<Kernel> {
    let values = &planner.equations.events.settings;
    let kernel = |lowering: &mut Lowering| Results::Vector(lowering.lower_all(values));
    (!values.is_empty()).then(|| planner.kernel(KernelId::EventValues, kernel))
}

/// The functions of time alone where expressions change their form, if any.
fn switching_functions_kernel(planner: &Planner) -> Option<Kernel> {
    let values: Vec<Expr> = planner.equations.switching.iter().map(|switching| switching.value).collect();
    let kernel = |lowering: &mut Lowering| Results::Vector(lowering.lower_all(&values));
    (!values.is_empty()).then(|| planner.kernel(KernelId::SwitchingFunctions, kernel))
}

/// The conditions of loads on the state, if any.
fn load_conditions_kernel(planner: &Planner) -> Option<Kernel> {
    let values: Vec<Expr> = planner.equations.load_conditions.iter().map(|condition| condition.value).collect();
    let kernel = |lowering: &mut Lowering| Results::Vector(lowering.lower_all(&values));
    (!values.is_empty()).then(|| planner.kernel(KernelId::LoadConditions, kernel))
}

/// The values of inputs, if there are any.
fn input_values_kernel(planner: &Planner) -> Option<Kernel> {
    let EquationsOfMotion { model, graph, .. } = planner.equations;
    let inputs: Vec<Expr> = model.inputs.iter().filter_map(|input| graph.existing(input.symbol)).collect();
    let kernel = |lowering: &mut Lowering| Results::Vector(lowering.lower_all(&inputs));
    (!inputs.is_empty()).then(|| planner.kernel(KernelId::InputValues, kernel))
}
