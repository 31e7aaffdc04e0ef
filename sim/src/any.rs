//! A mechanism whose type is forgotten: its kernels on slices, whose lengths are known when the program runs.
//!
//! What is computed a few times in a program is written for these, and so is compiled once, not once for each mechanism.

use crate::conditional::is_row_active;
use crate::equations::accelerate;
use crate::failure::{Failure, What};
use crate::least_norm::least_norm;
use crate::linearize::Control;
use crate::partition::Partition;
use crate::project::{is_met, project_positions};
use crate::trajectory::{Sample, State};
use nalgebra::{DMatrix, DVector};
use sim_kernel::{Array, Description, Dual, Input, Mechanism, Scalar};

/// C, C_q and C_t.
pub(crate) struct Linear {
    pub(crate) values: DVector<f64>,
    /// m x n.
    pub(crate) jacobian: DMatrix<f64>,
    pub(crate) time_derivative: DVector<f64>,
}

/// Time, coordinates, speeds, accelerations and multipliers, as numbers of any kind. Those that are left out are zero.
#[derive(Clone, Copy)]
pub(crate) struct At<'a, S> {
    pub(crate) time: S,
    pub(crate) positions: &'a [S],
    pub(crate) speeds: &'a [S],
    pub(crate) accelerations: &'a [S],
    pub(crate) multipliers: &'a [S],
}

impl<'a, S> At<'a, S> {
    /// Without accelerations and multipliers.
    pub(crate) fn moving(time: S, positions: &'a [S], speeds: &'a [S]) -> At<'a, S> {
        At { time, positions, speeds, accelerations: &[], multipliers: &[] }
    }
}

impl<'a> At<'a, f64> {
    /// A state, without accelerations and multipliers.
    pub(crate) fn state<M: Mechanism>(state: &'a State<M>) -> At<'a, f64> {
        At::moving(state.time, state.positions.as_ref(), state.speeds.as_ref())
    }

    /// A sample.
    pub(crate) fn sample<M: Mechanism>(sample: &'a Sample<M>) -> At<'a, f64> {
        let (accelerations, multipliers) = (sample.accelerations.as_ref(), sample.multipliers.as_ref());
        At { accelerations, multipliers, ..At::state(&sample.state) }
    }
}

/// The kernels of a mechanism; arguments and results are as those of [`Mechanism`].
pub(crate) trait AnyMechanism {
    fn description(&self) -> &'static Description;
    fn parameters(&self) -> Vec<f64>;
    fn inputs(&self) -> Vec<Input>;
    fn activities(&self) -> Vec<f64>;
    fn constraints(&self, time: f64, q: &[f64]) -> DVector<f64>;
    fn constraint_magnitudes(&self, time: f64, q: &[f64]) -> DVector<f64>;
    fn constraint_jacobian(&self, time: f64, q: &[f64]) -> DMatrix<f64>;
    fn constraint_time_derivative(&self, time: f64, q: &[f64]) -> DVector<f64>;
    fn constraint_linearization(&self, time: f64, q: &[f64]) -> Linear;
    fn constraint_convective(&self, time: f64, q: &[f64], qd: &[f64]) -> DVector<f64>;
    fn mass_matrix(&self, time: f64, q: &[f64]) -> DMatrix<f64>;
    fn convective_forces(&self, time: f64, q: &[f64], qd: &[f64]) -> DVector<f64>;
    fn generalized_forces(&self, time: f64, q: &[f64], qd: &[f64]) -> DVector<f64>;
    fn kinetic_energy(&self, time: f64, q: &[f64], qd: &[f64]) -> f64;
    fn power(&self, at: At<f64>) -> f64;
    fn outputs(&self, at: At<f64>) -> Vec<f64>;
    fn output_rates(&self, at: At<f64>) -> Vec<f64>;
    fn events(&self, at: At<f64>) -> Vec<f64>;
    fn event_values(&self, at: At<f64>) -> Vec<f64>;
    /// Whether the constraints are met, as after a projection.
    fn is_met(&self, time: f64, q: &[f64]) -> bool;
    /// As [`project_positions`].
    fn project_positions(&self, time: f64, q: &mut [f64]) -> Result<(), Failure>;
    /// The multipliers of least norm with the same forces, where so many rows are independent.
    fn least_norm(&self, time: f64, q: &[f64], multipliers: &[f64], rank: usize) -> Vec<f64>;
    /// Accelerations and multipliers, of the mechanism with other parameters and inputs.
    fn accelerate_with(&self, parameters: &[f64], inputs: &[Input], at: At<f64>) -> Result<DVector<f64>, Failure>;
    /// The inputs as they are at a time, each held at its value there.
    fn held_inputs(&self, time: f64, q: &[f64]) -> Vec<Input>;
    /// d(q'', lambda)/dq and d(q'', lambda)/dq', each n + m x n, from the generated kernels; `None` where these refuse a pivot.
    fn by_state(&self, time: f64, q: &[f64], qd: &[f64]) -> Option<[DMatrix<f64>; 2]>;
    /// The dependent coordinates and the dependent speeds that pivoting chooses.
    fn dependent(&self, at: At<f64>) -> Option<[Vec<usize>; 2]>;
    /// Accelerations and multipliers with their derivatives along a change of positions and speeds, and of a control;
    /// `None` where the elimination refuses a pivot.
    fn solution_along(&self, at: At<Dual>, control: Option<Control>) -> Option<Vec<Dual>>;
    /// C, C_q by rows, and C_t, likewise.
    fn constraints_along(&self, at: At<Dual>, control: Option<Control>) -> [Vec<Dual>; 3];
    /// The outputs, likewise.
    fn outputs_along(&self, at: At<Dual>, control: Option<Control>) -> Vec<Dual>;
    /// The rates of outputs that have one, with their derivatives along a change of positions and speeds.
    fn output_rates_along(&self, at: At<Dual>) -> Vec<Dual>;
}

/// A mechanism as one whose type is forgotten.
pub(crate) struct Any<'m, M>(pub(crate) &'m M);

impl<M: Mechanism> AnyMechanism for Any<'_, M> {
    fn description(&self) -> &'static Description {
        const { &M::DESCRIPTION }
    }
    fn parameters(&self) -> Vec<f64> {
        self.0.parameters().as_ref().to_vec()
    }
    fn inputs(&self) -> Vec<Input> {
        self.0.inputs().as_ref().to_vec()
    }
    fn activities(&self) -> Vec<f64> {
        self.0.activities().as_ref().to_vec()
    }
    fn constraints(&self, time: f64, q: &[f64]) -> DVector<f64> {
        vector(&self.0.constraints(time, &array(q)))
    }
    fn constraint_magnitudes(&self, time: f64, q: &[f64]) -> DVector<f64> {
        vector(&self.0.constraint_magnitudes(time, &array(q)))
    }
    fn constraint_jacobian(&self, time: f64, q: &[f64]) -> DMatrix<f64> {
        matrix::<M::LQ, M::Q>(&self.0.constraint_jacobian(time, &array(q)))
    }
    fn constraint_time_derivative(&self, time: f64, q: &[f64]) -> DVector<f64> {
        vector(&self.0.constraint_time_derivative(time, &array(q)))
    }
    fn constraint_linearization(&self, time: f64, q: &[f64]) -> Linear {
        let linear = self.0.constraint_linearization(time, &array(q));
        Linear {
            values: vector(&linear.values),
            jacobian: matrix::<M::LQ, M::Q>(&linear.jacobian),
            time_derivative: vector(&linear.time_derivative),
        }
    }
    fn constraint_convective(&self, time: f64, q: &[f64], qd: &[f64]) -> DVector<f64> {
        vector(&self.0.constraint_convective(time, &array(q), &array(qd)))
    }
    fn mass_matrix(&self, time: f64, q: &[f64]) -> DMatrix<f64> {
        matrix::<M::QQ, M::Q>(&self.0.mass_matrix(time, &array(q)))
    }
    fn convective_forces(&self, time: f64, q: &[f64], qd: &[f64]) -> DVector<f64> {
        vector(&self.0.convective_forces(time, &array(q), &array(qd)))
    }
    fn generalized_forces(&self, time: f64, q: &[f64], qd: &[f64]) -> DVector<f64> {
        vector(&self.0.generalized_forces(time, &array(q), &array(qd)))
    }
    fn kinetic_energy(&self, time: f64, q: &[f64], qd: &[f64]) -> f64 {
        self.0.kinetic_energy(time, &array(q), &array(qd))
    }
    fn power(&self, at: At<f64>) -> f64 {
        let (q, qd) = (array(at.positions), array(at.speeds));
        self.0.power(at.time, &q, &qd, &array(at.accelerations), &array(at.multipliers))
    }
    fn outputs(&self, at: At<f64>) -> Vec<f64> {
        outputs(self.0, at)
    }
    fn output_rates(&self, at: At<f64>) -> Vec<f64> {
        output_rates(self.0, at)
    }
    fn events(&self, at: At<f64>) -> Vec<f64> {
        let (q, qd) = (array(at.positions), array(at.speeds));
        self.0.events(at.time, &q, &qd, &array(at.accelerations), &array(at.multipliers)).as_ref().to_vec()
    }
    fn event_values(&self, at: At<f64>) -> Vec<f64> {
        self.0.event_values(at.time, &array(at.positions), &array(at.speeds)).as_ref().to_vec()
    }
    fn is_met(&self, time: f64, q: &[f64]) -> bool {
        let q = array(q);
        is_met(self.0, time, &q, &self.0.constraint_linearization(time, &q))
    }
    fn project_positions(&self, time: f64, q: &mut [f64]) -> Result<(), Failure> {
        let mut projected = array(q);
        project_positions(self.0, time, &mut projected)?;
        q.copy_from_slice(projected.as_ref());
        Ok(())
    }
    fn least_norm(&self, time: f64, q: &[f64], multipliers: &[f64], rank: usize) -> Vec<f64> {
        let jacobian = self.0.constraint_jacobian(time, &array(q));
        least_norm::<M>(jacobian, &array(multipliers), rank).as_ref().to_vec()
    }
    fn accelerate_with(&self, parameters: &[f64], inputs: &[Input], at: At<f64>) -> Result<DVector<f64>, Failure> {
        let mut set = self.0.inputs();
        set.as_mut().copy_from_slice(inputs);
        let mechanism = self.0.with_parameters(array(parameters)).with_inputs(set);
        let solved = accelerate(&mechanism, at.time, &array(at.positions), &array(at.speeds))?;
        Ok(stacked(solved.accelerations.as_ref(), solved.multipliers.as_ref()))
    }
    fn held_inputs(&self, time: f64, q: &[f64]) -> Vec<Input> {
        self.0.held_inputs(time, &array(q)).as_ref().to_vec()
    }
    fn by_state(&self, time: f64, q: &[f64], qd: &[f64]) -> Option<[DMatrix<f64>; 2]> {
        let found = self.0.dynamics_jacobian(time, &array(q), &array(qd));
        let of = |accelerations: &M::QQ, multipliers: &M::LQ| {
            below(matrix::<M::QQ, M::Q>(accelerations), matrix::<M::LQ, M::Q>(multipliers))
        };
        (!found.refused).then(|| {
            [
                of(&found.accelerations_by_positions, &found.multipliers_by_positions),
                of(&found.accelerations_by_speeds, &found.multipliers_by_speeds),
            ]
        })
    }
    fn dependent(&self, at: At<f64>) -> Option<[Vec<usize>; 2]> {
        let (positions, speeds) = (array(at.positions), array(at.speeds));
        let mut partition = Partition::default();
        partition.renew(self.0, &State { time: at.time, positions, speeds, work: 0.0 }).ok()?;
        Some(partition.dependent::<M>().map(<[usize]>::to_vec))
    }
    fn solution_along(&self, at: At<Dual>, control: Option<Control>) -> Option<Vec<Dual>> {
        let solved = self.lifted(at, control).dynamics(at.time, &array(at.positions), &array(at.speeds));
        (!solved.refused).then(|| [solved.accelerations.as_ref(), solved.multipliers.as_ref()].concat())
    }
    fn constraints_along(&self, at: At<Dual>, control: Option<Control>) -> [Vec<Dual>; 3] {
        let linear = self.lifted(at, control).constraint_linearization(at.time, &array(at.positions));
        let mut jacobian = Vec::new();
        linear.jacobian.iter().for_each(|row| jacobian.extend_from_slice(row.as_ref()));
        [linear.values.as_ref().to_vec(), jacobian, linear.time_derivative.as_ref().to_vec()]
    }
    fn outputs_along(&self, at: At<Dual>, control: Option<Control>) -> Vec<Dual> {
        outputs(&self.lifted(at, control), at)
    }
    fn output_rates_along(&self, at: At<Dual>) -> Vec<Dual> {
        output_rates(&self.0.on(Dual::constant), at)
    }
}

impl<M: Mechanism> Any<'_, M> {
    /// The mechanism on dual numbers, with an input or a parameter that changes.
    fn lifted(&self, at: At<Dual>, control: Option<Control>) -> M::On<Dual> {
        let constant = self.0.on(Dual::constant);
        match control {
            None => constant,
            Some(Control::Parameter(p)) => {
                let mut parameters = constant.parameters();
                parameters[p] = Dual::variable(parameters[p].value);
                constant.with_parameters(parameters)
            }
            Some(Control::Input(input)) => {
                let q = M::Q::from_fn(|j| at.positions[j].value);
                let held = self.0.held_inputs(at.time.value, &q);
                let mut inputs = constant.inputs();
                inputs[input] = held[input].map(Dual::variable);
                constant.with_inputs(inputs)
            }
        }
    }
}

impl dyn AnyMechanism + '_ {
    /// Whether a row of the constraints holds: all do but those of released ones.
    pub(crate) fn is_active(&self, row: usize) -> bool {
        is_row_active(self.description(), &self.activities(), row)
    }

    /// Accelerations and, below them, multipliers.
    pub(crate) fn accelerate(&self, at: At<f64>) -> Result<DVector<f64>, Failure> {
        self.accelerate_with(&self.parameters(), &self.inputs(), at)
    }

    /// C_q with zeros in the rows between speeds alone: what positions are corrected by.
    pub(crate) fn between_positions(&self, mut jacobian: DMatrix<f64>) -> DMatrix<f64> {
        self.description().speed_constraints.iter().for_each(|row| jacobian.row_mut(*row).fill(0.0));
        jacobian
    }

    /// The name of a constraint row.
    pub(crate) fn constraint_name(&self, row: usize) -> &'static str {
        self.description().constraints.get(row).map_or("?", |constraint| constraint.name)
    }

    /// A failure at a position.
    pub(crate) fn failure(&self, what: What, time: f64, q: &[f64]) -> Failure {
        Failure::of(self.description(), what, time, q)
    }
}

/// The array that begins with these numbers; those that are left out are zero.
pub(crate) fn array<S: Scalar, A: Array<S>>(values: &[S]) -> A {
    let mut array = A::filled(S::ZERO);
    copy(values, array.as_mut());
    array
}

fn copy<S: Scalar>(from: &[S], to: &mut [S]) {
    to.iter_mut().zip(from).for_each(|(to, from)| *to = *from);
}

/// One vector below the other.
fn stacked(above: &[f64], below: &[f64]) -> DVector<f64> {
    DVector::from_vec([above, below].concat())
}

/// One matrix below the other.
pub(crate) fn below(above: DMatrix<f64>, below: DMatrix<f64>) -> DMatrix<f64> {
    let (n, m) = (above.nrows(), below.nrows());
    let mut both = above.resize_vertically(n + m, 0.0);
    both.rows_mut(n, m).copy_from(&below);
    both
}

fn vector<A: Array<f64>>(values: &A) -> DVector<f64> {
    DVector::from_column_slice(values.as_ref())
}

fn matrix<A: Array<R>, R: Array<f64>>(rows: &A) -> DMatrix<f64> {
    let mut matrix = DMatrix::zeros(A::LEN, R::LEN);
    for i in 0..A::LEN {
        set_row(&mut matrix, i, rows[i].as_ref());
    }
    matrix
}

fn set_row(matrix: &mut DMatrix<f64>, i: usize, row: &[f64]) {
    for (j, entry) in row.iter().enumerate() {
        matrix[(i, j)] = *entry;
    }
}

fn outputs<S: Scalar, M: Mechanism<S>>(mechanism: &M, at: At<S>) -> Vec<S> {
    let (q, qd) = (array(at.positions), array(at.speeds));
    mechanism.outputs(at.time, &q, &qd, &array(at.accelerations), &array(at.multipliers)).as_ref().to_vec()
}

fn output_rates<S: Scalar, M: Mechanism<S>>(mechanism: &M, at: At<S>) -> Vec<S> {
    let (q, qd) = (array(at.positions), array(at.speeds));
    mechanism.output_rates(at.time, &q, &qd, &array(at.accelerations)).as_ref().to_vec()
}
