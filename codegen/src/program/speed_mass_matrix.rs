//! The mass matrix in speeds, N' M N.

use super::Kernel;
use super::entries::mass_entries;
use super::links::{Base, OpenTerms};
use super::lower::Lowering;
use super::notes::Notes;
use super::numbers::numbers_together;
use super::planner::Planner;
use super::reduced;
use super::results::Results;
use super::speeds::solve_blocks;
use super::values::{Value, Values};
use super::ways::can_be_by_rows;
use crate::dynamics::EquationsOfMotion;
use crate::kernel_id::KernelId;

/// On request: in the generalised speeds that are declared; otherwise with the velocities of free bodies, by composite bodies in
/// an open tree if that takes fewer operations.
pub(super) fn speed_mass_matrix(planner: &Planner) -> Option<Kernel> {
    let equations = planner.equations;
    if !equations.model.wants(KernelId::SpeedMassMatrix) {
        return None;
    }
    let kernel = |wanted: fn(&EquationsOfMotion, &mut Lowering) -> Option<Vec<Vec<Value>>>| {
        let mut lowering = planner.lowering();
        let rows = wanted(equations, &mut lowering)?;
        let count = rows.len();
        let results = Results::Matrix(count, rows);
        let kernel =
            planner.finish(KernelId::SpeedMassMatrix, &lowering, &results, &Notes::default(), Default::default());
        Some(Kernel { docs: planner.documentation(kernel.id, 0, &[("v", count.to_string())]), ..kernel })
    };
    let kernels = [in_generalized_speeds, by_links].into_iter().filter_map(kernel);
    let known = kernels.min_by_key(|kernel| kernel.operations.total());
    let by_rates = (known.is_none() || can_be_by_rows(equations)).then(|| kernel(by_rates)).flatten();
    known.into_iter().chain(by_rates).min_by_key(|kernel| kernel.operations.total())
}

fn in_generalized_speeds(equations: &EquationsOfMotion, lowering: &mut Lowering) -> Option<Vec<Vec<Value>>> {
    let speeds = equations.speeds.as_ref()?;
    let EquationsOfMotion { graph, model, .. } = equations;
    solve_blocks(graph, model, &speeds.kinematics.blocks, lowering, &mut Notes::default());
    let entries = mass_entries(lowering, graph, &speeds.tmt.mass_matrix);
    let unknowns: Vec<usize> = (0..model.generalized_speeds.len()).collect();
    Some(dense(&mut lowering.values, &unknowns, entries))
}

fn by_links(equations: &EquationsOfMotion, lowering: &mut Lowering) -> Option<Vec<Vec<Value>>> {
    let links = equations.links.as_ref().filter(|_| equations.speeds.is_none())?;
    let terms = OpenTerms::of(lowering, equations, links)?;
    let entries = terms.mass_matrix(lowering);
    Some(dense(&mut lowering.values, &terms.velocities(), entries))
}

/// From M and the rates that belong to each velocity, the columns of N.
fn by_rates(equations: &EquationsOfMotion, lowering: &mut Lowering) -> Option<Vec<Vec<Value>>> {
    if equations.speeds.is_some() {
        return None;
    }
    let mass = reduced::dense_mass_matrix(equations, lowering);
    let one = lowering.values.constant(1.0);
    let mut columns: Vec<Option<Rates>> = (0..mass.len()).map(|j| Some((vec![j], vec![one]))).collect();
    for declared in &equations.free_bases {
        let base = Base::of(lowering, equations, declared, 0);
        let [scalar, vector @ ..] = declared.quaternion;
        columns[scalar] = None;
        let places = declared.place.into_iter().chain(vector);
        places.zip(base.rates(&mut lowering.values)).for_each(|(place, rates)| columns[place] = Some(rates));
    }
    let columns: Vec<Rates> = columns.into_iter().flatten().collect();
    let values = &mut lowering.values;
    let mut rows = vec![vec![one; columns.len()]; columns.len()];
    for (j, column) in columns.iter().enumerate() {
        let momenta: Vec<Value> = mass.iter().map(|row| along(values, column, row)).collect();
        for (i, other) in columns[..=j].iter().enumerate() {
            rows[i][j] = along(values, other, &momenta);
            rows[j][i] = rows[i][j];
        }
    }
    Some(rows)
}

/// Coordinates with their rates.
type Rates = (Vec<usize>, Vec<Value>);

/// The sum of rates with what belongs to their coordinates.
fn along(values: &mut Values, (coordinates, rates): &Rates, of: &[Value]) -> Value {
    let terms = coordinates.iter().zip(rates).map(|(i, rate)| (false, values.product(vec![*rate, of[*i]])));
    let terms = terms.collect();
    values.sum(terms)
}

/// The matrix of these unknowns.
pub(super) fn dense(values: &mut Values, unknowns: &[usize], entries: Vec<(usize, usize, Value)>) -> Vec<Vec<Value>> {
    let place = |unknown: usize| unknowns.iter().position(|other| *other == unknown);
    let mut matrix = vec![vec![values.constant(0.0); unknowns.len()]; unknowns.len()];
    for (i, j, entry) in entries {
        let (Some(i), Some(j)) = (place(i), place(j)) else { continue };
        matrix[i][j] = values.sum(vec![(false, matrix[i][j]), (false, entry)]);
        matrix[j][i] = matrix[i][j];
    }
    let roots: Vec<Value> = matrix.concat();
    let moved = numbers_together(values, &roots);
    matrix.iter().map(|row| row.iter().map(|entry| moved[entry]).collect()).collect()
}
