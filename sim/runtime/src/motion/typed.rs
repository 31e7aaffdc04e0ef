//! The kernels of a mechanism of a known type, from slices to arrays and back.

use crate::model::{AnyMechanism, At, Control, Differentiable, Linear, below};
use crate::motion::equations::{accelerate_by_pivoting, planned};
use crate::motion::measures::Measures;
use crate::motion::met::is_met;
use crate::motion::mobility::mobility_of;
use crate::motion::project::project_positions;
use crate::motion::rows::Dense;
use crate::numerics::arrays::array;
use crate::state::failure::Failure;
use nalgebra::{DMatrix, DVector};
use sim_kernel::{Array, Description, Dual, Dynamics, Input, Mechanism, Scalar};

/// A mechanism with its type erased.
pub(crate) struct Any<'m, M>(pub(crate) &'m M);

impl<M: Mechanism> AnyMechanism for Any<'_, M> {
    fn description(&self) -> &'static Description {
        self.0.description()
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
        vector(&self.0.constraints(time, &array(self.0.n(), q)))
    }
    fn constraint_magnitudes(&self, time: f64, q: &[f64]) -> DVector<f64> {
        vector(&self.0.constraint_magnitudes(time, &array(self.0.n(), q)))
    }
    fn constraint_jacobian(&self, time: f64, q: &[f64]) -> DMatrix<f64> {
        matrix::<M::LQ, M::Q>(&self.0.constraint_jacobian(time, &array(self.0.n(), q)), self.0.n())
    }
    fn constraint_time_derivative(&self, time: f64, q: &[f64]) -> DVector<f64> {
        vector(&self.0.constraint_time_derivative(time, &array(self.0.n(), q)))
    }
    fn constraint_linearization(&self, time: f64, q: &[f64]) -> Linear {
        let linear = self.0.constraint_linearization(time, &array(self.0.n(), q));
        Linear {
            values: vector(&linear.values),
            jacobian: matrix::<M::LQ, M::Q>(&linear.jacobian, self.0.n()),
            time_derivative: vector(&linear.time_derivative),
        }
    }
    fn constraint_convective(&self, time: f64, q: &[f64], qd: &[f64]) -> DVector<f64> {
        vector(&self.0.constraint_convective(time, &array(self.0.n(), q), &array(self.0.n(), qd)))
    }
    fn mass_matrix(&self, time: f64, q: &[f64]) -> DMatrix<f64> {
        matrix::<M::QQ, M::Q>(&self.0.mass_matrix(time, &array(self.0.n(), q)), self.0.n())
    }
    fn convective_forces(&self, time: f64, q: &[f64], qd: &[f64]) -> DVector<f64> {
        vector(&self.0.convective_forces(time, &array(self.0.n(), q), &array(self.0.n(), qd)))
    }
    fn generalized_forces(&self, time: f64, q: &[f64], qd: &[f64]) -> DVector<f64> {
        vector(&self.0.generalized_forces(time, &array(self.0.n(), q), &array(self.0.n(), qd)))
    }
    fn kinetic_energy(&self, time: f64, q: &[f64], qd: &[f64]) -> f64 {
        self.0.kinetic_energy(time, &array(self.0.n(), q), &array(self.0.n(), qd))
    }
    fn power(&self, at: At<f64>) -> f64 {
        let (q, qd) = (array(self.0.n(), at.positions), array(self.0.n(), at.speeds));
        self.0.power(at.time, &q, &qd, &array(self.0.n(), at.accelerations), &array(self.0.m(), at.multipliers))
    }
    fn outputs(&self, at: At<f64>) -> Vec<f64> {
        outputs(self.0, at)
    }
    fn output_rates(&self, at: At<f64>) -> Vec<f64> {
        output_rates(self.0, at)
    }
    fn events(&self, at: At<f64>) -> Vec<f64> {
        let (q, qd) = (array(self.0.n(), at.positions), array(self.0.n(), at.speeds));
        self.0
            .events(at.time, &q, &qd, &array(self.0.n(), at.accelerations), &array(self.0.m(), at.multipliers))
            .as_ref()
            .to_vec()
    }
    fn switching_functions(&self, time: f64) -> Vec<f64> {
        self.0.switching_functions(time).as_ref().to_vec()
    }
    fn load_conditions(&self, at: At<f64>) -> Vec<f64> {
        let (q, qd) = (array(self.0.n(), at.positions), array(self.0.n(), at.speeds));
        self.0.load_conditions(at.time, &q, &qd).as_ref().to_vec()
    }
    fn event_values(&self, at: At<f64>) -> Vec<f64> {
        self.0.event_values(at.time, &array(self.0.n(), at.positions), &array(self.0.n(), at.speeds)).as_ref().to_vec()
    }
    fn is_met(&self, time: f64, q: &[f64]) -> bool {
        let q = array(self.0.n(), q);
        let measures = Measures::of_independent(self.0, self, time, &q);
        is_met::<f64, M, Dense>(self.0, &measures, time, &q, &self.0.constraint_linearization(time, &q))
    }
    fn project_positions(&self, time: f64, q: &mut [f64]) -> Result<(), Failure> {
        let mut projected = array(self.0.n(), q);
        let measures = Measures::of_independent(self.0, self, time, &projected);
        project_positions(self.0, &measures, time, &mut projected)?;
        q.copy_from_slice(projected.as_ref());
        Ok(())
    }
    fn accelerate_with(&self, parameters: &[f64], inputs: &[Input], at: At<f64>) -> Result<DVector<f64>, Failure> {
        let mut set = self.0.inputs();
        set.as_mut().copy_from_slice(inputs);
        let mechanism = self.0.with_parameters(self.0.parameters().like(|i| parameters[i])).with_inputs(set);
        let solved = accelerate(&mechanism, at.time, &array(self.0.n(), at.positions), &array(self.0.n(), at.speeds))?;
        Ok(stacked(solved.accelerations.as_ref(), solved.multipliers.as_ref()))
    }
    fn held_inputs(&self, time: f64, q: &[f64]) -> Vec<Input> {
        self.0.held_inputs(time, &array(self.0.n(), q)).as_ref().to_vec()
    }
}

/// Accelerations, multipliers and power at a state, by the generated elimination; if that refuses a pivot, by complete
/// pivoting on the mass matrix and the constraint Jacobian. Redundant constraints are then met in least squares, and the
/// multipliers are those of least norm, in SI units.
///
/// # Errors
/// [`What::Singular`](crate::What::Singular) if no unique solution exists, [`What::NotFinite`](crate::What::NotFinite)
/// if an expression leaves its domain.
#[inline]
pub fn accelerate<M: Mechanism>(
    mechanism: &M,
    time: f64,
    q: &M::Q,
    qd: &M::Q,
) -> Result<Dynamics<f64, M::Q, M::L>, Failure> {
    planned::<M>(&mechanism.prepare(), time, q, qd).map_or_else(|| accelerate_refused(mechanism, time, q, qd), Ok)
}

#[cold]
fn accelerate_refused<M: Mechanism>(
    mechanism: &M,
    time: f64,
    q: &M::Q,
    qd: &M::Q,
) -> Result<Dynamics<f64, M::Q, M::L>, Failure> {
    let any = &Any(mechanism);
    let measures = Measures::of(mechanism, any, (time, q), &mobility_of(any, time, q.as_ref()));
    let redundant = measures.is_redundant().then_some(&measures);
    accelerate_by_pivoting(mechanism, redundant, time, q.clone(), qd.clone())
}

impl<M: Mechanism> Differentiable for Any<'_, M> {
    fn by_state(&self, time: f64, q: &[f64], qd: &[f64]) -> Option<[DMatrix<f64>; 2]> {
        let found = self.0.dynamics_jacobian(time, &array(self.0.n(), q), &array(self.0.n(), qd));
        let of = |accelerations: &M::QQ, multipliers: &M::LQ| {
            below(matrix::<M::QQ, M::Q>(accelerations, self.0.n()), matrix::<M::LQ, M::Q>(multipliers, self.0.n()))
        };
        (!found.refused).then(|| {
            [
                of(&found.accelerations_by_positions, &found.multipliers_by_positions),
                of(&found.accelerations_by_speeds, &found.multipliers_by_speeds),
            ]
        })
    }
    fn solution_along(&self, at: At<Dual>, control: Option<Control>) -> Option<Vec<Dual>> {
        let solved =
            self.lifted(at, control).dynamics(at.time, &array(self.0.n(), at.positions), &array(self.0.n(), at.speeds));
        (!solved.refused).then(|| [solved.accelerations.as_ref(), solved.multipliers.as_ref()].concat())
    }
    fn constraints_along(&self, at: At<Dual>, control: Option<Control>) -> [Vec<Dual>; 3] {
        let linear = self.lifted(at, control).constraint_linearization(at.time, &array(self.0.n(), at.positions));
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
                let q = M::Q::with_len(self.0.n(), |j| at.positions[j].value);
                let held = self.0.held_inputs(at.time.value, &q);
                let mut inputs = constant.inputs();
                inputs[input] = held[input].map(Dual::variable);
                constant.with_inputs(inputs)
            }
        }
    }
}

/// One vector below the other.
fn stacked(above: &[f64], below: &[f64]) -> DVector<f64> {
    DVector::from_vec([above, below].concat())
}

fn vector<A: Array<f64>>(values: &A) -> DVector<f64> {
    DVector::from_column_slice(values.as_ref())
}

fn matrix<A: Array<R>, R: Array<f64>>(rows: &A, columns: usize) -> DMatrix<f64> {
    let mut matrix = DMatrix::zeros(rows.len(), columns);
    for i in 0..rows.len() {
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
    let (q, qd) = (array(mechanism.n(), at.positions), array(mechanism.n(), at.speeds));
    mechanism
        .outputs(at.time, &q, &qd, &array(mechanism.n(), at.accelerations), &array(mechanism.m(), at.multipliers))
        .as_ref()
        .to_vec()
}

fn output_rates<S: Scalar, M: Mechanism<S>>(mechanism: &M, at: At<S>) -> Vec<S> {
    let (q, qd) = (array(mechanism.n(), at.positions), array(mechanism.n(), at.speeds));
    mechanism.output_rates(at.time, &q, &qd, &array(mechanism.n(), at.accelerations)).as_ref().to_vec()
}
