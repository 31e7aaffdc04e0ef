//! The derivatives of accelerations, multipliers and outputs with respect to state and inputs.

use super::Change;
use super::differences::{Difference, Solved, quotient, refined};
use super::reduce::Reduction;
use crate::model::{At, Control, Differentiable, constants};
use crate::motion::lengths::measure;
use crate::state::failure::Failure;
use nalgebra::{DMatrix, DVector};
use sim_kernel::Dual;
use std::cell::Cell;

/// The derivatives of z = (q'', lambda) at a state.
pub(crate) struct Derivatives<'m> {
    mechanism: &'m dyn Differentiable,
    at: At<'m, f64>,
    inputs: &'m [Control],
    /// z there.
    solution: DVector<f64>,
    /// By q and by q', each n + m x n, from the generated kernels; these refuse a pivot if constraints are redundant, and may have no
    /// value where their law has, as that of the cube of a norm at zero.
    by_state: Option<[DMatrix<f64>; 2]>,
    /// Whether a difference has not settled: what acts has no derivative, or changes within a tiny way.
    is_unsettled: Cell<bool>,
}

impl<'m> Derivatives<'m> {
    pub(crate) fn at(
        mechanism: &'m dyn Differentiable,
        at: At<'m, f64>,
        inputs: &'m [Control],
    ) -> Result<Derivatives<'m>, Failure> {
        let solution = mechanism.accelerate(at)?;
        let is_finite = |parts: &[DMatrix<f64>; 2]| parts.iter().flatten().all(|entry| entry.is_finite());
        let by_state = mechanism.by_state(at.time, at.positions, at.speeds).filter(is_finite);
        Ok(Derivatives { mechanism, at, inputs, solution, by_state, is_unsettled: Cell::new(false) })
    }

    pub(super) fn mechanism(&self) -> &'m dyn Differentiable {
        self.mechanism
    }

    /// Where they are.
    pub(super) fn state(&self) -> At<'m, f64> {
        self.at
    }

    /// The accelerations, n.
    pub(crate) fn accelerations(&self) -> &[f64] {
        &self.solution.as_slice()[..self.at.positions.len()]
    }

    /// Whether a difference asked for so far has not settled.
    pub(super) fn are_unsettled(&self) -> bool {
        self.is_unsettled.get()
    }

    /// By differences, if they settle.
    fn refined(&self, size: f64, f: &Solved) -> Result<DVector<f64>, Failure> {
        let (found, has_settled) = refined(size, self.at.positions.len(), f)?;
        self.is_unsettled.set(self.is_unsettled.get() || !has_settled);
        Ok(found)
    }

    /// Whether generated kernels give those by the state; otherwise they are differences.
    pub(super) fn are_exact(&self) -> bool {
        self.by_state.is_some()
    }

    /// The change of all quantities with entry k of x: exact, or where kernels refuse, by differences along the
    /// constraints, which are accurate to some 1e-11, or 1e-8 of laws that are smooth but for their second derivative.
    ///
    /// # Errors
    /// As the right-hand side, near the state too.
    pub(crate) fn along(&self, reduction: &Reduction, k: usize) -> Result<Change, Failure> {
        self.along_by(reduction, k, &|size, f| self.refined(size, f))
    }

    /// The same on the way of a search, where differences need not be known so well.
    ///
    /// # Errors
    /// As [`along`](Derivatives::along).
    pub(super) fn along_roughly(&self, reduction: &Reduction, k: usize) -> Result<Change, Failure> {
        self.along_by(reduction, k, &quotient)
    }

    fn along_by(&self, reduction: &Reduction, k: usize, difference: &Difference) -> Result<Change, Failure> {
        let (positions, speeds) = reduction.change(k);
        let solution = match &self.by_state {
            Some([by_positions, by_speeds]) => by_positions * &positions + by_speeds * &speeds,
            None => self.difference_along(reduction, k, difference)?,
        };
        Ok(self.change(positions, speeds, &solution))
    }

    /// The change of the solution with an input.
    pub(super) fn forced(&self, input: usize) -> Result<Change, Failure> {
        let still = DVector::zeros(self.at.positions.len());
        Ok(self.change(still.clone(), still, &self.by_input(self.inputs[input])?))
    }

    fn change(&self, positions: DVector<f64>, speeds: DVector<f64>, solution: &DVector<f64>) -> Change {
        let n = self.at.positions.len();
        let accelerations = solution.rows(0, n).into();
        Change { positions, speeds, accelerations, multipliers: solution.rows(n, solution.len() - n).into() }
    }

    #[cold]
    fn difference_along(
        &self,
        reduction: &Reduction,
        k: usize,
        difference: &Difference,
    ) -> Result<DVector<f64>, Failure> {
        let At { time, positions, speeds, .. } = self.at;
        let h = reduction.independent().len();
        let size = match k < h {
            true => measure(self.mechanism, time, positions).0[reduction.independent()[k]],
            false => {
                let j = reduction.independent_speeds()[k - h];
                measure(self.mechanism, time, positions).0[j].max(speeds[j].abs())
            }
        };
        difference(size, &|step| {
            let (mut q, mut qd) = (positions.to_vec(), speeds.to_vec());
            match k < h {
                true => q[reduction.independent()[k]] += step,
                false => qd[reduction.independent_speeds()[k - h]] += step,
            }
            reduction.follow(self.mechanism, time, (&mut q, &mut qd))?;
            self.mechanism.accelerate(At::moving(time, &q, &qd))
        })
    }

    /// The derivative of z by an input.
    fn by_input(&self, control: Control) -> Result<DVector<f64>, Failure> {
        let [positions, speeds] = [self.at.positions, self.at.speeds].map(constants);
        let still = At::moving(Dual::constant(self.at.time), &positions, &speeds);
        match self.mechanism.solution_along(still, Some(control)) {
            Some(solution) => Ok(DVector::from_iterator(solution.len(), solution.iter().map(|value| value.derivative))),
            None => self.difference_by_input(control),
        }
    }

    #[cold]
    fn difference_by_input(&self, control: Control) -> Result<DVector<f64>, Failure> {
        let Derivatives { mechanism, at, .. } = self;
        let (parameters, inputs) = (mechanism.parameters(), mechanism.inputs());
        let description = mechanism.description();
        match control {
            Control::Parameter(p) => self.refined(parameters[p].abs().max(description.parameters[p].factor), &|step| {
                let mut parameters = parameters.clone();
                parameters[p] += step;
                mechanism.accelerate_with(&parameters, &inputs, *at)
            }),
            Control::Input(input) => {
                let held = mechanism.held_inputs(at.time, at.positions)[input];
                let size = held.held().unwrap_or_default().abs();
                self.refined(size.max(description.inputs[input].factor), &|step| {
                    let mut inputs = inputs.clone();
                    inputs[input] = held.map(|value| value + step);
                    mechanism.accelerate_with(&parameters, &inputs, *at)
                })
            }
        }
    }
}

/// Whether constraints change with a parameter, which then cannot be an input.
pub(super) fn constraints_depend_on(mechanism: &dyn Differentiable, at: At<f64>, control: Control) -> bool {
    let positions = constants(at.positions);
    let still = At::moving(Dual::constant(at.time), &positions, &[]);
    mechanism.constraints_along(still, Some(control)).iter().flatten().any(|value| value.derivative != 0.0)
}

/// The change of the outputs with a change of all quantities, and with an input.
pub(super) fn output_slopes(derivatives: &Derivatives, change: &Change, input: Option<Control>) -> Vec<f64> {
    outputs_along(derivatives, (change, 0.0), input).iter().map(|value| value.derivative).collect()
}

/// The outputs where all quantities have changed by so many times a change, with their derivatives along it.
pub(super) fn outputs_beside(derivatives: &Derivatives, change: &Change, by: f64) -> Vec<Dual> {
    outputs_along(derivatives, (change, by), None)
}

fn outputs_along(derivatives: &Derivatives, (change, by): (&Change, f64), input: Option<Control>) -> Vec<Dual> {
    let moving = |values: &[f64], change: &DVector<f64>| -> Vec<Dual> {
        let moved =
            |(value, derivative): (&f64, &f64)| Dual { value: value + by * derivative, derivative: *derivative };
        values.iter().zip(change).map(moved).collect()
    };
    let Derivatives { mechanism, at, solution, .. } = derivatives;
    let (accelerations, multipliers) = solution.as_slice().split_at(at.positions.len());
    let moving = At {
        time: Dual::constant(at.time),
        positions: &moving(at.positions, &change.positions),
        speeds: &moving(at.speeds, &change.speeds),
        accelerations: &moving(accelerations, &change.accelerations),
        multipliers: &moving(multipliers, &change.multipliers),
    };
    mechanism.outputs_along(moving, input)
}
