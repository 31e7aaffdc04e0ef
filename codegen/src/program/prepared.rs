//! The kernels that run at each step, and the values that they need of the parameters, computed once for each set of
//! parameters.

use super::links::{LinkTerms, OpenTerms, StateDerivatives};
use super::lower::Lowering;
use super::motion::{Motion, columns_of, state_derivatives};
use super::names::Names;
use super::notes::Notes;
use super::planner::Planner;
use super::results::Results;
use super::schedule::derived_name;
use super::speeds;
use super::values::{Input, Leaves, Operation, Value, Values};
use super::ways::{Solution, can_be_by_rows, operations};
use super::{Kernel, Name, Tree, reduced};
use crate::dynamics::{EquationsOfMotion, Inverse};
use crate::kernel_id::{KernelId, Record};
use indexmap::IndexMap;
use std::collections::BTreeSet;

/// `prepare`, and the kernels of what it returns.
pub(super) fn prepared_kernels(planner: &Planner) -> Vec<Kernel> {
    let Some(Solution { mut lowering, mut motion, mut differentiable }) = Solution::cheapest(planner) else {
        return vec![];
    };
    let inverse = inverse_dynamics(planner, &mut lowering);
    let differentiated = differentiable.as_ref().unwrap_or(&motion);
    let by_state = jacobian(differentiated, &mut lowering);
    let by_parameters = differentiated.form.by_parameters.as_ref();
    let by_parameters = by_parameters.map(|columns| differentiated.sensitivity(&mut lowering, columns));
    let mut notes = std::mem::take(&mut motion.notes);
    notes.extend(differentiable.as_mut().map(|motion| std::mem::take(&mut motion.notes)));
    let EquationsOfMotion { model, graph, speeds, .. } = planner.equations;
    let in_speeds = speeds.as_ref().map(|speeds| speeds::kernels(graph, model, speeds, &mut lowering, &mut notes));
    let along_tree = open_jacobian(planner, &mut lowering);
    let by_state = cheaper(&lowering.values, by_state, along_tree, &mut notes);
    let mut planned = vec![(KernelId::Dynamics, motion.dynamics())];
    planned.extend(inverse.map(|forces| (KernelId::InverseDynamics, Results::Vector(forces))));
    planned.extend(by_state.map(|results| (KernelId::DynamicsJacobian, results)));
    planned.extend(by_parameters.map(|results| (KernelId::DynamicsSensitivity, results)));
    planned.extend(in_speeds.into_iter().flatten());
    let roots: Vec<Value> = planned.iter().flat_map(|(_, results)| results.entries()).copied().collect();
    let fields = fields(planner, &lowering, &notes, &roots);
    let leaves: Leaves = fields.iter().map(|(name, value)| (*value, Tree::Field(name.clone()))).collect();
    let results = fields.into_iter().map(|(name, value)| (name.to_string(), Results::Scalar(value))).collect();
    let prepare = planner.finish(
        KernelId::Prepare,
        &lowering,
        &Results::Record(Record::Prepared, results),
        &Notes::default(),
        Leaves::default(),
    );
    let kernels = planned.into_iter().map(|(kernel, results)| {
        let finished = planner.finish(kernel, &lowering, &results, &notes, leaves.clone());
        match kernel == KernelId::Dynamics {
            true => Kernel { docs: dynamics_docs(planner, &motion), ..finished },
            false => finished,
        }
    });
    [prepare].into_iter().chain(kernels).collect()
}

/// d(q'', lambda)/d(q, q') from the factors of the equations of motion, by the way to write their residual that takes fewer
/// operations.
fn jacobian(motion: &Motion, lowering: &mut Lowering) -> Option<Results<Value>> {
    let ways = motion.form.by_state.iter().map(|columns| {
        let results = motion.jacobian(lowering, columns);
        (operations(&lowering.values, results.entries()), results)
    });
    ways.min_by_key(|(cost, _)| *cost).map(|(_, results)| results)
}

/// The derivatives from the factors of the equations of motion, or those along the tree with what is noted of them.
fn cheaper(
    values: &Values,
    by_factors: Option<Results<Value>>,
    along_tree: Option<(Results<Value>, Notes)>,
    notes: &mut Notes,
) -> Option<Results<Value>> {
    let cost = |results: &Results<Value>| operations(values, results.entries());
    match (by_factors, along_tree) {
        (Some(own), Some((other, _))) if cost(&own) <= cost(&other) => Some(own),
        (_, Some((other, more))) => {
            notes.extend([more]);
            Some(other)
        }
        (own, None) => own,
    }
}

/// d(q'', lambda)/d(q, q') of an open tree, if that is wanted.
fn open_jacobian(planner: &Planner, lowering: &mut Lowering) -> Option<(Results<Value>, Notes)> {
    let mut notes = Notes::default();
    let terms = OpenTerms::of(lowering, planner.equations, planner.equations.links.as_ref()?)?;
    let StateDerivatives { accelerations, multipliers, pivots } = terms.jacobian(lowering, &mut notes)?;
    let [accelerations, multipliers] = [accelerations, multipliers].map(|by| by.map(|columns| columns_of(&columns)));
    Some((state_derivatives(accelerations, multipliers, Results::Refused(Some(pivots))), notes))
}

/// Inverse dynamics on request: as equations of bodies, by a recursion over links, or with intermediates.
fn inverse_dynamics(planner: &Planner, lowering: &mut Lowering) -> Option<Vec<Value>> {
    let EquationsOfMotion { model, inverse, intermediates, links, .. } = planner.equations;
    if model.wants(KernelId::InverseDynamics) && !intermediates.is_empty() {
        return Some(reduced::inverse_dynamics(planner.equations, lowering));
    }
    let Inverse { forces, .. } = inverse.as_ref()?;
    if let Some(links) = links.as_ref().filter(|_| !can_be_by_rows(planner.equations)) {
        return Some(LinkTerms::of(lowering, links).inverse_dynamics(lowering));
    }
    let forces = lowering.lower_all(forces);
    let Some(links) = links else { return Some(forces) };
    let by_links = LinkTerms::of(lowering, links).inverse_dynamics(lowering);
    let cost = |forces: &[Value]| operations(&lowering.values, forces.iter().collect());
    Some(if cost(&by_links) < cost(&forces) { by_links } else { forces })
}

/// Values that depend on parameters alone and that others need, and the parameters that are needed themselves.
fn fields(planner: &Planner, lowering: &Lowering, notes: &Notes, roots: &[Value]) -> Vec<(Name, Value)> {
    let values = &lowering.values;
    let is_computed = |value: Value| match values.operation(value) {
        Operation::Constant(_) | Operation::Input(_) => false,
        Operation::Negate(operand) => values.operands(*operand).next().is_some(),
        _ => true,
    };
    let needed = values.reachable(roots, &Leaves::default());
    let variable = needed.iter().filter(|value| !values.is_parametric(**value));
    let operands = variable.flat_map(|value| values.operands(*value)).chain(roots.to_vec());
    let computed = operands.filter(|value| values.is_parametric(*value) && is_computed(*value));
    let mut fields: BTreeSet<Value> = computed.collect();
    let leaves = fields.iter().map(|value| (*value, Tree::Constant(0.0))).collect();
    let is_parameter =
        |value: &Value| matches!(values.operation(*value), Operation::Input(Input::Parameter(_) | Input::Activity(_)));
    fields.extend(values.reachable(roots, &leaves).into_iter().filter(is_parameter));
    name_fields(planner, lowering, notes, fields)
}

/// Parameters keep their names; computed values are named after their expressions.
fn name_fields(planner: &Planner, lowering: &Lowering, notes: &Notes, fields: BTreeSet<Value>) -> Vec<(Name, Value)> {
    let values = &lowering.values;
    let (parameters, conditionals) = (&planner.equations.model.parameters, &planner.equations.model.conditionals);
    let wished = planner.names_wished(lowering, notes);
    let mut names = Names::default();
    parameters.iter().map(|p| &p.name).chain(conditionals.iter().map(|c| &c.field)).for_each(|name| {
        names.unique(name);
    });
    planner.equations.model.inputs.iter().for_each(|input| {
        names.unique(&input.name);
    });
    let mut named: IndexMap<Value, Name> = IndexMap::new();
    for value in fields {
        let name = match values.operation(value) {
            Operation::Input(Input::Parameter(i)) => parameters[*i].name.as_str().into(),
            Operation::Input(Input::Activity(i)) => conditionals[*i].field.as_str().into(),
            _ => {
                let known = |value: Value| match values.operation(value) {
                    Operation::Input(Input::Parameter(i)) => Some(parameters[*i].name.as_str()),
                    Operation::Input(Input::Activity(i)) => Some(conditionals[*i].field.as_str()),
                    _ => named.get(&value).map(|name| &**name).or_else(|| wished.get(&value).map(|name| &**name)),
                };
                match wished.get(&value) {
                    Some(wish) => names.unique(wish),
                    None => names.unique(derived_name(values, value, known).as_deref().unwrap_or("k")),
                }
            }
        };
        named.insert(value, name);
    }
    named.into_iter().map(|(value, name)| (name, value)).collect()
}

fn dynamics_docs(planner: &Planner, motion: &Motion) -> String {
    let turned = match motion.form.turns.len() {
        _ if motion.is_of_open_tree() => ", from the tips of a tree of bodies to the world and back",
        0 => "",
        1 => ", with two constraint rows turned along and across a link",
        _ => ", with pairs of constraint rows turned along and across links",
    };
    planner.documentation(KernelId::Dynamics, 0, &[("turned", turned.to_owned())])
}
