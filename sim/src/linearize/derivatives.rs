//! How accelerations, multipliers and outputs change with state and inputs.

use super::{Change, Control};
use crate::equations::accelerate;
use crate::failure::Failure;
use crate::trajectory::State;
use nalgebra::{DMatrix, DVector};
use sim_kernel::{Array, Dual, Dynamics, Mechanism, Scalar};

/// The derivatives of z = (q'', lambda) at a state.
pub(super) struct Derivatives {
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
    pub(super) fn at<M: Mechanism>(
        mechanism: &M,
        state: &State<M>,
        inputs: &[Control],
    ) -> Result<Derivatives, Failure> {
        let (n, m) = (M::Q::LEN, M::L::LEN);
        let State { time, positions, speeds, .. } = state;
        let solution = stacked::<M>(&accelerate(mechanism, *time, positions, speeds)?);
        let by_state = mechanism.dynamics_jacobian(*time, positions, speeds);
        let by_parameters = mechanism.dynamics_sensitivity(*time, positions, speeds);
        let by_inputs: Vec<_> = inputs.iter().map(|input| by_input(mechanism, state, *input)).collect();
        if by_state.refused || by_parameters.refused || by_inputs.iter().any(Option::is_none) {
            return differences(mechanism, state, inputs, solution);
        }
        let (qq, qv) = (&by_state.accelerations_by_positions, &by_state.accelerations_by_speeds);
        let (lq, lv) = (&by_state.multipliers_by_positions, &by_state.multipliers_by_speeds);
        let forced = |i: usize, k: usize| match (inputs[k], &by_inputs[k]) {
            (Control::Parameter(p), _) if i < n => by_parameters.accelerations[i][p],
            (Control::Parameter(p), _) => by_parameters.multipliers[i - n][p],
            (Control::Input(_), column) => column.as_ref().map_or(f64::NAN, |column| column[i]),
        };
        Ok(Derivatives {
            solution,
            by_positions: DMatrix::from_fn(n + m, n, |i, j| if i < n { qq[i][j] } else { lq[i - n][j] }),
            by_speeds: DMatrix::from_fn(n + m, n, |i, j| if i < n { qv[i][j] } else { lv[i - n][j] }),
            by_inputs: DMatrix::from_fn(n + m, inputs.len(), forced),
            n,
        })
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

/// The same by central differences, good to some 1e-9.
#[cold]
fn differences<M: Mechanism>(
    mechanism: &M,
    state: &State<M>,
    inputs: &[Control],
    solution: DVector<f64>,
) -> Result<Derivatives, Failure> {
    let n = M::Q::LEN;
    let columns =
        |count: usize, at: &dyn Fn(usize, f64) -> Result<DVector<f64>, Failure>, size: &dyn Fn(usize) -> f64| {
            let mut matrix = DMatrix::zeros(solution.len(), count);
            for j in 0..count {
                let step = f64::EPSILON.cbrt() * size(j).abs().max(1.0);
                matrix.set_column(j, &((at(j, step)? - at(j, -step)?) / (2.0 * step)));
            }
            Ok(matrix)
        };
    let solve = |mechanism: &M, q: &M::Q, qd: &M::Q| Ok(stacked::<M>(&accelerate(mechanism, state.time, q, qd)?));
    let moved = |values: &M::Q, j: usize, step: f64| {
        let mut values = *values;
        values[j] += step;
        values
    };
    let (q, qd, parameters) = (&state.positions, &state.speeds, mechanism.parameters());
    let held = mechanism.held_inputs(state.time, q);
    let changed = |k: usize, step: f64| match inputs[k] {
        Control::Parameter(p) => {
            let mut parameters = parameters;
            parameters[p] += step;
            mechanism.with_parameters(parameters)
        }
        Control::Input(input) => {
            let mut inputs = mechanism.inputs();
            inputs[input] = held[input].map(|value| value + step);
            mechanism.with_inputs(inputs)
        }
    };
    let size = |k: usize| match inputs[k] {
        Control::Parameter(p) => parameters[p],
        Control::Input(input) => held[input].held().unwrap_or_default(),
    };
    Ok(Derivatives {
        by_positions: columns(n, &|j, step| solve(mechanism, &moved(q, j, step), qd), &|j| q[j])?,
        by_speeds: columns(n, &|j, step| solve(mechanism, q, &moved(qd, j, step)), &|j| qd[j])?,
        by_inputs: columns(inputs.len(), &|k, step| solve(&changed(k, step), q, qd), &size)?,
        solution,
        n,
    })
}

fn stacked<M: Mechanism>(solved: &Dynamics<f64, M::Q, M::L>) -> DVector<f64> {
    DVector::from_iterator(M::Q::LEN + M::L::LEN, solved.accelerations.iter().chain(solved.multipliers.iter()).copied())
}

/// The mechanism on dual numbers, with an input or a parameter that changes.
fn lifted<M: Mechanism>(mechanism: &M, state: &State<M>, control: Option<Control>) -> M::On<Dual> {
    let constant = mechanism.on(Dual::constant);
    match control {
        None => constant,
        Some(Control::Parameter(p)) => {
            let mut parameters = constant.parameters();
            parameters[p] = Dual::variable(parameters[p].value);
            constant.with_parameters(parameters)
        }
        Some(Control::Input(input)) => {
            let held = mechanism.held_inputs(state.time, &state.positions);
            let mut inputs = constant.inputs();
            inputs[input] = held[input].map(Dual::variable);
            constant.with_inputs(inputs)
        }
    }
}

/// How accelerations and multipliers change with an input, an empty column for a parameter; nothing where a pivot is refused.
fn by_input<M: Mechanism>(mechanism: &M, state: &State<M>, control: Control) -> Option<Vec<f64>> {
    fn solve<M: Mechanism<Dual>>(mechanism: &M, time: f64, of: [&dyn Fn(usize) -> f64; 2]) -> Option<Vec<f64>> {
        let [q, qd] = of.map(|of| M::Q::from_fn(|j| Dual::constant(of(j))));
        let solved = mechanism.dynamics(Dual::constant(time), &q, &qd);
        let all = solved.accelerations.iter().chain(solved.multipliers.iter());
        (!solved.refused).then(|| all.map(|value| value.derivative).collect())
    }
    match control {
        Control::Parameter(_) => Some(vec![]),
        Control::Input(_) => {
            let lifted = lifted(mechanism, state, Some(control));
            solve(&lifted, state.time, [&|j| state.positions[j], &|j| state.speeds[j]])
        }
    }
}

/// Whether constraints change with a parameter, which then is no input.
pub(super) fn constraints_depend_on<M: Mechanism>(mechanism: &M, state: &State<M>, control: Control) -> bool {
    fn changes<M: Mechanism<Dual>>(mechanism: &M, time: f64, q: impl Fn(usize) -> f64) -> bool {
        let q = M::Q::from_fn(|j| Dual::constant(q(j)));
        let linear = mechanism.constraint_linearization(Dual::constant(time), &q);
        let jacobian = linear.jacobian.iter().flat_map(|row| row.iter());
        let all = linear.values.iter().chain(linear.time_derivative.iter()).chain(jacobian);
        all.into_iter().any(|value| value.derivative != 0.0)
    }
    changes(&lifted(mechanism, state, Some(control)), state.time, |j| state.positions[j])
}

/// How an output changes with a change of everything, and with an input.
pub(super) fn output_slope<M: Mechanism>(
    mechanism: &M,
    state: &State<M>,
    derivatives: &Derivatives,
    change: &Change,
    input: Option<Control>,
    output: usize,
) -> f64 {
    fn slope<M: Mechanism<Dual>>(mechanism: &M, time: f64, of: [&dyn Fn(usize) -> Dual; 4], output: usize) -> f64 {
        let [q, qd, qdd] = [of[0], of[1], of[2]].map(M::Q::from_fn);
        mechanism.outputs(Dual::from_f64(time), &q, &qd, &qdd, &M::L::from_fn(of[3]))[output].derivative
    }
    let dual = |value: f64, derivative: f64| Dual { value, derivative };
    let of: [&dyn Fn(usize) -> Dual; 4] = [
        &|j| dual(state.positions[j], change.positions[j]),
        &|j| dual(state.speeds[j], change.speeds[j]),
        &|j| dual(derivatives.solution[j], change.accelerations[j]),
        &|i| dual(derivatives.solution[derivatives.n + i], change.multipliers[i]),
    ];
    slope(&lifted(mechanism, state, input), state.time, of, output)
}
