//! The kernels' solution in Lagrange's equations.

use super::declared::{Declared, held, solved, uninterpreted};
use super::scale::scales;
use super::worst::{Worst, largest, relative};
use super::{Check, VerifyError, places};
use crate::model::{AnyMechanism, At};
use crate::motion::typed::Any;
use crate::state::trajectory::Sample;
use codegen::oracle::State;
use codegen::symbolic::{Expr, evaluate};
use sim_kernel::Mechanism;

/// The largest residual of an equation. For a row of K z = r, with z the kernels' solution, it is at most some n eps of
/// |K||z| + |r|, in the norm in which the elimination is stable: rows and columns scaled by the inertia of their
/// coordinates. |r| counts the terms of loads, which may cancel, as in stiff springs about their rest (from the
/// oracle). That leaves five digits for elimination in a planned order.
const BOUND: f64 = 1e-10;

/// q'' and lambda of the generated kernels, by TMT, in Lagrange's equations with constraints of their own derivation.
///
/// # Errors
/// If the equations of motion cannot be solved at a sample, or the oracle cannot interpret the declaration.
pub fn lagrange_against_kernels<M: Mechanism>(
    mechanism: &M,
    declared: &Declared,
    samples: &[Sample<M>],
) -> Result<Check, VerifyError> {
    compare_with_lagrange(&Any(mechanism), declared, &places(samples))
}

pub(super) fn compare_with_lagrange(
    mechanism: &dyn AnyMechanism,
    declared: &Declared,
    samples: &[At<f64>],
) -> Result<Check, VerifyError> {
    let scales = scales(mechanism, samples);
    let mut rows = Vec::new();
    for sample in samples {
        rows.push((sample.time, equations(mechanism, declared, sample)?));
    }
    let n = scales.len();
    let coordinate = |row: &Row, j: usize| row.size / scales[j];
    // |r| in sqrt(kg)*m/s^2, over all coordinates and samples.
    let force = largest(rows.iter().flat_map(|(_, rows)| rows[..n].iter().enumerate().map(|(j, r)| coordinate(r, j))));
    let mut worst = Worst::<(f64, &str)>::default();
    let names = mechanism.description();
    for (time, rows) in &rows {
        for (i, row) in rows.iter().enumerate() {
            let (size, name) = match i.checked_sub(n) {
                None => (force * scales[i], names.coordinates[i].position.name),
                // The size of C_q q'' for accelerations of that size.
                Some(k) => {
                    let moved = (0..n).map(|j| row.slopes[j].abs() * force / scales[j]).sum::<f64>();
                    (row.size.max(moved), mechanism.constraint_name(k))
                }
            };
            worst.enter(relative(row.missing.abs(), size), (*time, name));
        }
    }
    let (time, name) = worst.at;
    let place = if name.is_empty() { String::new() } else { format!(", along `{name}` at t = {time:.4} s") };
    let meaning = format!("residual of Lagrange's equations for q'' and lambda, relative to their terms{place}");
    Ok(Check::new("TMT against Lagrange", worst.figure, BOUND, meaning))
}

/// One of Lagrange's equations, or one of the constraints' accelerations.
struct Row {
    missing: f64,
    /// The sum of the magnitudes of its terms.
    size: f64,
    /// Of a constraint, its row of C_q.
    slopes: Vec<f64>,
}

/// M q'' + C_q' lambda - Q along each coordinate, then C_q q'' and the rest of each constraint.
fn equations(mechanism: &dyn AnyMechanism, declared: &Declared, sample: &At<f64>) -> Result<Vec<Row>, VerifyError> {
    let (n, m) = (sample.positions.len(), mechanism.description().constraints.len());
    let solution = solved(mechanism, sample)?;
    let (parameters, inputs) = (mechanism.parameters(), held(mechanism));
    let at = State {
        time: sample.time,
        parameters: &parameters,
        inputs: &inputs,
        coordinates: sample.positions,
        speeds: sample.speeds,
    };
    let sizes = declared.oracle(mechanism).freed(&at, &solution).map_err(uninterpreted)?;
    let lagrange = &declared.lagrange;
    let values = |exprs: &[Expr]| value(mechanism, declared, sample, exprs);
    let (mass, force) = (values(&lagrange.mass_matrix.concat()), values(&lagrange.right_hand_side));
    let (jacobian, convective) =
        (values(&lagrange.constraint_jacobian.concat()), values(&lagrange.constraint_convective));
    let active: Vec<usize> = (0..m).filter(|row| mechanism.is_active(*row)).collect();
    let accelerations: Vec<f64> = solution.accelerations.iter().map(|x| x.value).collect();
    let lambda: Vec<f64> = solution.multipliers.iter().map(|x| x.value).collect();
    let mut rows = Vec::new();
    for j in 0..n {
        let inertial = (0..n).map(|i| mass[j * n + i] * accelerations[i]);
        let reactions = active.iter().map(|k| jacobian[k * n + j] * lambda[*k]);
        let terms: Vec<f64> = inertial.chain(reactions).chain([-force[j]]).collect();
        let size = terms.iter().map(|x| x.abs()).sum::<f64>() + sizes[j].size;
        rows.push(Row { missing: terms.iter().sum(), size, slopes: vec![] });
    }
    for k in 0..m {
        let slopes = jacobian[k * n..(k + 1) * n].to_vec();
        let terms: Vec<f64> = slopes.iter().zip(&accelerations).map(|(c, a)| c * a).chain([convective[k]]).collect();
        let is_active = active.contains(&k);
        let size = terms.iter().map(|x| x.abs()).sum::<f64>();
        rows.push(Row { missing: if is_active { terms.iter().sum() } else { 0.0 }, size, slopes });
    }
    Ok(rows)
}

/// The values of the model's expressions at a state of the mechanism.
fn value(mechanism: &dyn AnyMechanism, declared: &Declared, state: &At<f64>, exprs: &[Expr]) -> Vec<f64> {
    let (parameters, inputs, activities) = (mechanism.parameters(), mechanism.inputs(), mechanism.activities());
    let model = &declared.model;
    let given = |symbol| {
        let of_parameter = || model.parameters.iter().position(|p| p.symbol == symbol).map(|i| parameters[i]);
        let of_time = || (symbol == model.time).then_some(state.time);
        of_parameter().or_else(of_time).unwrap_or(f64::NAN)
    };
    let course = |i: usize| evaluate(&declared.graph, &[model.inputs[i].course], given)[0];
    evaluate(&declared.graph, exprs, |symbol| {
        let of_coordinate = model.coordinates.iter().enumerate().find_map(|(i, c)| match symbol {
            _ if symbol == c.position => Some(state.positions[i]),
            _ if symbol == c.speed => Some(state.speeds[i]),
            _ => None,
        });
        let of_input = || model.inputs.iter().position(|input| input.symbol == symbol).map(|i| inputs[i].or(course(i)));
        let of_activity = || model.conditionals.iter().position(|c| c.symbol == symbol).map(|i| activities[i]);
        of_coordinate.or_else(of_input).or_else(of_activity).unwrap_or_else(|| given(symbol))
    })
}
