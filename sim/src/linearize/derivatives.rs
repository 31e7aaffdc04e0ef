//! How accelerations, multipliers and outputs change with state and inputs.

use super::{Change, Control};
use crate::any::{AnyMechanism, At};
use crate::failure::Failure;
use nalgebra::{DMatrix, DVector};
use sim_kernel::Dual;

/// The derivatives of z = (q'', lambda) at a state.
pub(crate) struct Derivatives {
    /// z there.
    solution: DVector<f64>,
    /// By q, by q' and by the inputs: n + m rows.
    by_positions: DMatrix<f64>,
    by_speeds: DMatrix<f64>,
    by_inputs: DMatrix<f64>,
    n: usize,
}

impl Derivatives {
    /// From the generated kernels, or where these refuse a pivot, as with redundant constraints, by differences.
    pub(crate) fn at(mechanism: &dyn AnyMechanism, at: At<f64>, inputs: &[Control]) -> Result<Derivatives, Failure> {
        let n = at.positions.len();
        let solution = mechanism.accelerate(at)?;
        let by_state = mechanism.by_state(at.time, at.positions, at.speeds);
        let by_inputs = by_inputs(mechanism, at, inputs);
        match (by_state, by_inputs) {
            (Some([by_positions, by_speeds]), Some(columns)) => {
                let by_inputs = DMatrix::from_fn(solution.len(), inputs.len(), |i, k| columns[k][i]);
                Ok(Derivatives { solution, by_positions, by_speeds, by_inputs, n })
            }
            _ => differences(mechanism, at, inputs, solution),
        }
    }

    /// By q, n + m x n.
    pub(crate) fn by_positions(&self) -> &DMatrix<f64> {
        &self.by_positions
    }

    /// A change of positions and speeds with what follows from it.
    pub(super) fn follow(&self, (positions, speeds): (DVector<f64>, DVector<f64>)) -> Change {
        let solution = &self.by_positions * &positions + &self.by_speeds * &speeds;
        self.change(positions, speeds, &solution)
    }

    /// What follows from a change of an input.
    pub(super) fn forced(&self, input: usize) -> Change {
        let still = DVector::zeros(self.n);
        self.change(still.clone(), still, &self.by_inputs.column(input).into())
    }

    fn change(&self, positions: DVector<f64>, speeds: DVector<f64>, solution: &DVector<f64>) -> Change {
        let m = solution.len() - self.n;
        let accelerations = solution.rows(0, self.n).into();
        Change { positions, speeds, accelerations, multipliers: solution.rows(self.n, m).into() }
    }
}

/// How accelerations and multipliers change with each input; nothing where a pivot is refused.
fn by_inputs(mechanism: &dyn AnyMechanism, at: At<f64>, inputs: &[Control]) -> Option<Vec<DVector<f64>>> {
    let [positions, speeds] = [at.positions, at.speeds].map(constants);
    let still = At::moving(Dual::constant(at.time), &positions, &speeds);
    let column = |control: &Control| {
        let solution = mechanism.solution_along(still, Some(*control))?;
        Some(DVector::from_iterator(solution.len(), solution.iter().map(|value| value.derivative)))
    };
    inputs.iter().map(column).collect()
}

/// The same by central differences, good to some 1e-9.
#[cold]
fn differences(
    mechanism: &dyn AnyMechanism,
    at: At<f64>,
    inputs: &[Control],
    solution: DVector<f64>,
) -> Result<Derivatives, Failure> {
    let n = at.positions.len();
    let columns =
        |count: usize, at: &dyn Fn(usize, f64) -> Result<DVector<f64>, Failure>, size: &dyn Fn(usize) -> f64| {
            let mut matrix = DMatrix::zeros(solution.len(), count);
            for j in 0..count {
                let step = f64::EPSILON.cbrt() * size(j).abs().max(1.0);
                matrix.set_column(j, &((at(j, step)? - at(j, -step)?) / (2.0 * step)));
            }
            Ok(matrix)
        };
    let moved = |values: &[f64], j: usize, step: f64| {
        let mut values = values.to_vec();
        values[j] += step;
        values
    };
    let (parameters, given) = (mechanism.parameters(), mechanism.inputs());
    let held = mechanism.held_inputs(at.time, at.positions);
    let solve =
        |q: &[f64], qd: &[f64]| mechanism.accelerate_with(&parameters, &given, At { positions: q, speeds: qd, ..at });
    let changed = |k: usize, step: f64| match inputs[k] {
        Control::Parameter(p) => mechanism.accelerate_with(&moved(&parameters, p, step), &given, at),
        Control::Input(input) => {
            let mut inputs = given.clone();
            inputs[input] = held[input].map(|value| value + step);
            mechanism.accelerate_with(&parameters, &inputs, at)
        }
    };
    let size = |k: usize| match inputs[k] {
        Control::Parameter(p) => parameters[p],
        Control::Input(input) => held[input].held().unwrap_or_default(),
    };
    let (q, qd) = (at.positions, at.speeds);
    Ok(Derivatives {
        by_positions: columns(n, &|j, step| solve(&moved(q, j, step), qd), &|j| q[j])?,
        by_speeds: columns(n, &|j, step| solve(q, &moved(qd, j, step)), &|j| qd[j])?,
        by_inputs: columns(inputs.len(), &changed, &size)?,
        solution,
        n,
    })
}

/// Numbers that do not change.
pub(super) fn constants(values: &[f64]) -> Vec<Dual> {
    values.iter().map(|value| Dual::constant(*value)).collect()
}

/// Whether constraints change with a parameter, which then is no input.
pub(super) fn constraints_depend_on(mechanism: &dyn AnyMechanism, at: At<f64>, control: Control) -> bool {
    let positions = constants(at.positions);
    let still = At::moving(Dual::constant(at.time), &positions, &[]);
    mechanism.constraints_along(still, Some(control)).iter().flatten().any(|value| value.derivative != 0.0)
}

/// How the outputs change with a change of everything, and with an input.
pub(super) fn output_slopes(
    mechanism: &dyn AnyMechanism,
    at: At<f64>,
    derivatives: &Derivatives,
    change: &Change,
    input: Option<Control>,
) -> Vec<f64> {
    let moving = |values: &[f64], change: &DVector<f64>| -> Vec<Dual> {
        values.iter().zip(change).map(|(value, derivative)| Dual { value: *value, derivative: *derivative }).collect()
    };
    let (accelerations, multipliers) = derivatives.solution.as_slice().split_at(derivatives.n);
    let moving = At {
        time: Dual::constant(at.time),
        positions: &moving(at.positions, &change.positions),
        speeds: &moving(at.speeds, &change.speeds),
        accelerations: &moving(accelerations, &change.accelerations),
        multipliers: &moving(multipliers, &change.multipliers),
    };
    mechanism.outputs_along(moving, input).iter().map(|value| value.derivative).collect()
}
