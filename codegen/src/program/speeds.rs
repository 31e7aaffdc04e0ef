//! The kernels of generalised speeds: q' = N u + n, and u' with the remaining multipliers.

use super::eliminate::{Factors, System, Unknown, factorise};
use super::entries::{constraint_entries, mass_entries};
use super::lower::Lowering;
use super::motion::right_hand_side;
use super::notes::Notes;
use super::results::Results;
use super::values::Value;
use crate::dynamics::order::Multipliers;
use crate::dynamics::{Block, Solution, SpeedEquations};
use crate::kernel_id::{KernelId, Record};
use crate::model::Model;
use crate::symbolic::Graph;

/// Pivots, each with the scale for its cancellation; none without an elimination.
type Pivots = Option<Vec<(Value, Value)>>;

/// `kinematics` and `speed_dynamics`.
pub(super) fn kernels(
    graph: &Graph,
    model: &Model,
    equations: &SpeedEquations,
    lowering: &mut Lowering,
    notes: &mut Notes,
) -> [(KernelId, Results<Value>); 2] {
    let pivots = solve_blocks(graph, model, &equations.kinematics.blocks, lowering, notes);
    let rates = lowering.lower_all(&equations.kinematics.rates);
    let kinematics = Results::record(
        Record::Kinematics,
        [("rates", Results::Vector(rates)), ("refused", Results::Refused(pivots.clone()))],
    );
    let dynamics = dynamics(graph, model, equations, pivots, lowering, notes);
    [(KernelId::Kinematics, kinematics), (KernelId::SpeedDynamics, dynamics)]
}

/// Sets the values of the rates that are solved for at run time, and of their derivatives.
pub(super) fn solve_blocks(
    graph: &Graph,
    model: &Model,
    blocks: &[Block],
    lowering: &mut Lowering,
    notes: &mut Notes,
) -> Pivots {
    let factors: Vec<Option<Factors>> =
        blocks.iter().map(|block| factorise_block(graph, model, block, lowering, notes)).collect();
    let mut solve = |factors: &Option<Factors>, solution: &Solution| {
        let right_hand_side = lowering.lower_all(&solution.right_hand_side);
        let solved = solve(factors.as_ref(), right_hand_side, lowering, &mut |_, _| ());
        let names = solution.symbols.iter().map(|symbol| graph.symbol_name(*symbol).to_owned());
        solved.iter().zip(names).for_each(|(value, name)| notes.name(*value, name));
        lowering.replace(solution.symbols.iter().copied().zip(solved).collect());
    };
    for (block, factors) in blocks.iter().zip(&factors) {
        solve(factors, &block.rates);
        block.by_speed.iter().for_each(|(_, by_speed)| solve(factors, by_speed));
    }
    // It contains the rates of all blocks.
    for (block, factors) in blocks.iter().zip(&factors) {
        solve(factors, &block.convective);
    }
    let all: Option<Vec<Factors>> = factors.into_iter().collect();
    all.map(distinct_pivots)
}

fn factorise_block(
    graph: &Graph,
    model: &Model,
    block: &Block,
    lowering: &mut Lowering,
    notes: &mut Notes,
) -> Option<Factors> {
    let names: Vec<String> = block.coordinates.iter().map(|j| format!("{}_dot", model.coordinates[*j].name)).collect();
    let entries = mass_entries(lowering, graph, &block.matrix);
    let unknowns = names.iter().map(|_| Unknown::Coordinate).collect();
    factorise(&mut lowering.values, &System { unknowns, entries, multipliers: Multipliers::Last }, &names, notes)
}

fn distinct_pivots(factors: Vec<Factors>) -> Vec<(Value, Value)> {
    let mut pivots: Vec<_> = factors.into_iter().flat_map(|factors| factors.pivots).collect();
    pivots.sort();
    pivots.dedup();
    pivots
}

/// u' and lambda.
fn dynamics(
    graph: &Graph,
    model: &Model,
    equations: &SpeedEquations,
    kinematic: Pivots,
    lowering: &mut Lowering,
    notes: &mut Notes,
) -> Results<Value> {
    let SpeedEquations { tmt, rows, jacobian, convective, .. } = equations;
    let speeds = model.generalized_speeds.iter().map(|speed| format!("{}_dot", speed.name));
    let multipliers = rows.iter().map(|row| format!("lambda_{}", model.constraints[*row].name));
    let names: Vec<String> = speeds.chain(multipliers).collect();
    let activities = rows.iter().map(|row| model.constraints[*row].activity);
    let mut entries = mass_entries(lowering, graph, &tmt.mass_matrix);
    entries.extend(constraint_entries(lowering, graph, tmt.mass_matrix.len(), jacobian, activities));
    let coordinates = model.generalized_speeds.iter().map(|_| Unknown::Coordinate);
    let unknowns = coordinates.chain(rows.iter().map(|_| Unknown::Multiplier)).collect();
    let rhs = right_hand_side(lowering, &tmt.right_hand_side, convective);
    let factors =
        factorise(&mut lowering.values, &System { unknowns, entries, multipliers: Multipliers::Last }, &names, notes);
    let solved = solve(factors.as_ref(), rhs, lowering, &mut |value, k| {
        notes.right_hand_side(value, &names[k]);
    });
    solved.iter().zip(&names).for_each(|(value, name)| notes.name(*value, name.clone()));
    let own = factors.map(|factors| distinct_pivots(vec![factors]));
    let refused = if needs_blocks(graph, equations) {
        own.zip(kinematic).map(|(own, kinematic)| [own, kinematic].concat())
    } else {
        own
    };
    let (rates, multipliers) = solved.split_at(model.generalized_speeds.len());
    Results::record(
        Record::SpeedDynamics,
        [
            ("rates", Results::Vector(rates.to_vec())),
            ("multipliers", Results::Vector(multipliers.to_vec())),
            ("refused", Results::Refused(refused)),
        ],
    )
}

/// Zeros where no elimination could be planned.
fn solve(
    factors: Option<&Factors>,
    rhs: Vec<Value>,
    lowering: &mut Lowering,
    label: &mut dyn FnMut(Value, usize),
) -> Vec<Value> {
    let zeros = vec![lowering.values.constant(0.0); rhs.len()];
    match factors {
        Some(factors) => factors.solve(&mut lowering.values, rhs, &zeros, label),
        None => zeros,
    }
}

/// Whether the equations of motion depend on rates that are solved for at run time.
fn needs_blocks(graph: &Graph, equations: &SpeedEquations) -> bool {
    let SpeedEquations { kinematics, tmt, jacobian, convective, .. } = equations;
    let matrices = tmt.mass_matrix.iter().chain(jacobian).chain([&tmt.right_hand_side, convective]);
    let used = graph.symbols_of(&matrices.flatten().copied().collect::<Vec<_>>());
    let mut solutions = kinematics.blocks.iter().flat_map(Block::solutions);
    solutions.any(|solution| solution.symbols.iter().any(|symbol| used.binary_search(symbol).is_ok()))
}
