//! A mechanism whose type is forgotten: its kernels on slices, whose lengths are known when the program runs.
//!
//! What is computed a few times in a program is written for these, and so is compiled once, not once for each mechanism.

use crate::conditional::is_row_active;
use crate::equations::accelerate;
use crate::failure::{Failure, What};
use crate::least_norm::least_norm;
use crate::project::{is_met, project_positions};
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

/// The kernels of a mechanism; arguments and results are as those of [`Mechanism`].
pub(crate) trait AnyMechanism {
    fn description(&self) -> &'static Description;
    fn parameters(&self) -> Vec<f64>;
    fn inputs(&self) -> Vec<Input>;
    fn activities(&self) -> Vec<f64>;
    fn constraints(&self, time: f64, q: &[f64]) -> DVector<f64>;
    fn constraint_magnitudes(&self, time: f64, q: &[f64]) -> DVector<f64>;
    fn constraint_jacobian(&self, time: f64, q: &[f64]) -> DMatrix<f64>;
    fn constraint_linearization(&self, time: f64, q: &[f64]) -> Linear;
    fn constraint_convective(&self, time: f64, q: &[f64], qd: &[f64]) -> DVector<f64>;
    fn mass_matrix(&self, time: f64, q: &[f64]) -> DMatrix<f64>;
    fn convective_forces(&self, time: f64, q: &[f64], qd: &[f64]) -> DVector<f64>;
    fn generalized_forces(&self, time: f64, q: &[f64], qd: &[f64]) -> DVector<f64>;
    fn kinetic_energy(&self, time: f64, q: &[f64], qd: &[f64]) -> f64;
    fn power(&self, at: At<f64>) -> f64;
    fn outputs(&self, at: At<f64>) -> Vec<f64>;
    fn output_rates(&self, at: At<f64>) -> Vec<f64>;
    /// Accelerations and multipliers.
    fn accelerate(&self, time: f64, q: &[f64], qd: &[f64]) -> Result<[DVector<f64>; 2], Failure>;
    /// Whether the constraints are met, as after a projection.
    fn is_met(&self, time: f64, q: &[f64]) -> bool;
    /// As [`project_positions`].
    fn project_positions(&self, time: f64, q: &mut [f64]) -> Result<(), Failure>;
    /// The multipliers of least norm with the same forces, where so many rows are independent.
    fn least_norm(&self, time: f64, q: &[f64], multipliers: &[f64], rank: usize) -> Vec<f64>;
    /// The outputs with their derivatives along a change of everything.
    fn outputs_along(&self, at: At<Dual>) -> Vec<Dual>;
    /// The same with second derivatives.
    fn outputs_along_twice(&self, at: At<Dual<Dual>>) -> Vec<Dual<Dual>>;
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
        let (q, qd) = (array(at.positions), array(at.speeds));
        self.0.output_rates(at.time, &q, &qd, &array(at.accelerations)).as_ref().to_vec()
    }
    fn accelerate(&self, time: f64, q: &[f64], qd: &[f64]) -> Result<[DVector<f64>; 2], Failure> {
        let solved = accelerate(self.0, time, &array(q), &array(qd))?;
        Ok([vector(&solved.accelerations), vector(&solved.multipliers)])
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
    fn outputs_along(&self, at: At<Dual>) -> Vec<Dual> {
        outputs(&self.0.on(Dual::constant), at)
    }
    fn outputs_along_twice(&self, at: At<Dual<Dual>>) -> Vec<Dual<Dual>> {
        outputs(&self.0.on(|value| Dual::constant(Dual::constant(value))), at)
    }
}

impl dyn AnyMechanism + '_ {
    /// Whether a row of the constraints holds: all do but those of released ones.
    pub(crate) fn is_active(&self, row: usize) -> bool {
        is_row_active(self.description(), &self.activities(), row)
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
