//! A model with the interface of a compiled mechanism, so that the same loops run both.

use super::arrays::{List, OnHeap, Shared, Storage};
use super::entered::{Entered, Rows, enter, matrices, vectors};
use super::model::{Kernel, Model, Prepared, Values};
use super::place::Place;
use sim_kernel::{
    Array, ConstraintLinearization, Description, Dual, Dynamics, DynamicsJacobian, DynamicsSensitivity, Initial, Input,
    Interval, Kinematics, Mechanism, Scalar,
};
use std::any::Any;
use std::marker::PhantomData;
use std::slice;
use std::sync::Arc;

/// A model with at most `K::MOST` coordinates, constraints, inputs and events.
///
/// Its kernels are for `f64` and [`Dual`]; on other numbers they refuse, with NaN.
#[derive(Clone, Debug)]
pub struct Erased<K: Storage, S: Scalar = f64> {
    model: Arc<dyn Model>,
    /// The model's, asked for once: loops need the sizes all the time.
    description: &'static Description,
    rows_left: Option<&'static [usize]>,
    values: Arc<Values<S>>,
    inputs: Shared<Input<S>>,
    storage: PhantomData<K>,
}

impl Erased<OnHeap> {
    /// The model.
    pub fn of(model: Arc<dyn Model>) -> Erased<OnHeap> {
        Erased::over(model)
    }
}

impl<K: Storage> Erased<K> {
    /// The model with its values now, and the constraints that events have switched.
    pub fn model(&self) -> Arc<dyn Model> {
        self.model.clone()
    }

    /// The model, if it has at most `K::MOST` coordinates, constraints, inputs and events.
    pub fn new(model: Arc<dyn Model>) -> Option<Erased<K>> {
        let Description { coordinates, constraints, inputs, events, .. } = model.description();
        let sizes = [coordinates.len(), constraints.len(), inputs.len(), events.len()];
        sizes.iter().all(|size| *size <= K::MOST).then(|| Erased::over(model))
    }

    fn over(model: Arc<dyn Model>) -> Erased<K> {
        let (description, rows_left) = (model.description(), model.rows_left());
        let values = Arc::new(model.values());
        let inputs = shared(&values.inputs);
        Erased { model, description, rows_left, values, inputs, storage: PhantomData }
    }
}

type Vector<K, S> = <K as Storage>::Array<S>;
type Matrix<K, S> = <K as Storage>::Array<Vector<K, S>>;

impl<K: Storage, S: Scalar> Erased<K, S> {
    /// The same model with other values.
    fn with(&self, values: Values<S>) -> Self {
        let model = match (&values as &dyn Any).downcast_ref::<Values>() {
            Some(values) => self.model.with_values(values),
            None => self.model.clone(),
        };
        Erased { model, inputs: shared(&values.inputs), values: Arc::new(values), ..*self }
    }

    /// Calls a kernel, and enters what it finds.
    #[inline]
    fn call(&self, kernel: Kernel, at: &Place<K, S>, found: &mut impl Entered<S>) -> bool {
        if let Some(at) = at.on::<f64>() {
            return self.model.call(kernel, at, &mut |row, numbers| enter(found, row, numbers));
        }
        match (at.on::<Dual>(), (&*self.values as &dyn Any).downcast_ref::<Values<Dual>>()) {
            (Some(at), Some(values)) => {
                self.model.call_on_duals(values, kernel, at, &mut |row, numbers| enter(found, row, numbers))
            }
            _ => match at.on::<Dual<Interval>>() {
                Some(at) => self.model.call_on_intervals(kernel, at, &mut |row, numbers| enter(found, row, numbers)),
                None => true,
            },
        }
    }

    #[inline]
    fn scalar(&self, kernel: Kernel, at: &Place<K, S>) -> S {
        let mut number = nan();
        self.call(kernel, at, &mut vectors([slice::from_mut(&mut number)]));
        number
    }

    #[inline]
    fn vector(&self, kernel: Kernel, at: &Place<K, S>, len: usize) -> Vector<K, S> {
        let mut vector = Vector::<K, S>::repeat(len, nan());
        self.call(kernel, at, &mut vectors([vector.as_mut()]));
        vector
    }

    #[inline]
    fn list(&self, kernel: Kernel, at: &Place<K, S>, len: usize) -> List<S> {
        let mut list = List::repeat(len, nan());
        self.call(kernel, at, &mut vectors([list.as_mut()]));
        list
    }

    #[inline]
    fn matrix(&self, kernel: Kernel, at: &Place<K, S>, rows: usize) -> Matrix<K, S> {
        let mut matrix = Matrix::<K, S>::repeat(rows, Vector::<K, S>::repeat(self.n(), nan()));
        self.call(kernel, at, &mut matrices([matrix.as_mut()]));
        matrix
    }
}

fn nan<S: Scalar>() -> S {
    S::from_f64(f64::NAN)
}

/// A truth value as a mask.
fn mask<S: Scalar>(value: bool) -> S::Mask {
    S::from_f64(f64::from(u8::from(value))).greater(S::ZERO)
}

/// The equations of motion of an erased mechanism, prepared.
#[derive(Debug)]
pub struct ErasedPrepared<K: Storage, S: Scalar> {
    mechanism: Erased<K, S>,
    kernels: Box<dyn Prepared>,
}

impl<K: Storage, S: Scalar> Clone for ErasedPrepared<K, S> {
    fn clone(&self) -> Self {
        ErasedPrepared { mechanism: self.mechanism.clone(), kernels: self.kernels.copied() }
    }
}

impl<K: Storage, S: Scalar> ErasedPrepared<K, S> {
    #[inline]
    fn call(&self, kernel: Kernel, at: &Place<K, S>, found: &mut impl Entered<S>) -> bool {
        match at.on::<f64>() {
            Some(at) => self.kernels.call(kernel, at, &mut |row, numbers| enter(found, row, numbers)),
            None => self.mechanism.call(kernel, at, found),
        }
    }
}

impl<K: Storage, S: Scalar> Mechanism<S> for Erased<K, S> {
    type Q = Vector<K, S>;
    type L = Vector<K, S>;
    type Z = List<S>;
    type QQ = Matrix<K, S>;
    type V = List<S>;
    type VV = List<List<S>>;
    type LQ = Matrix<K, S>;
    type LL = Matrix<K, S>;
    type ZZ = List<List<S>>;
    type Entries = List<S>;
    type Envelope = List<S>;
    type Parameters = List<S>;
    type Inputs = Shared<Input<S>>;
    type Outputs = List<S>;
    type OutputRates = List<S>;
    type Events = Vector<K, S>;
    type EventValues = List<S>;
    type SwitchingFunctions = List<S>;
    type LoadConditions = List<S>;
    type Activities = List<S>;
    type Drawing = List<S>;
    type QP = List<List<S>>;
    type LP = List<List<S>>;
    type Prepared = ErasedPrepared<K, S>;
    type On<T: Scalar> = Erased<K, T>;

    fn description(&self) -> &'static Description {
        self.description
    }
    fn rows_left(&self) -> Option<&'static [usize]> {
        self.rows_left
    }
    fn as_declared(&self) -> Self {
        let model = self.model.as_declared();
        let values = Arc::new(model.values().map(S::from_f64));
        Erased { model, inputs: shared(&values.inputs), values, ..*self }
    }
    fn parameters(&self) -> List<S> {
        list(&self.values.parameters)
    }
    fn with_parameters(&self, parameters: List<S>) -> Self {
        self.with(Values { parameters: parameters.as_ref().to_vec(), ..Values::clone(&self.values) })
    }
    fn activities(&self) -> List<S> {
        list(&self.values.activities)
    }
    fn with_activities(self, activities: List<S>) -> Self {
        self.with(Values { activities: activities.as_ref().to_vec(), ..Values::clone(&self.values) })
    }
    fn inputs(&self) -> Shared<Input<S>> {
        self.inputs.clone()
    }
    fn with_inputs(&self, inputs: Shared<Input<S>>) -> Self {
        match inputs.is_empty() {
            true => self.clone(),
            false => self.with(Values { inputs: inputs.as_ref().to_vec(), ..Values::clone(&self.values) }),
        }
    }
    fn held_inputs(&self, t: S, q: &Self::Q) -> Shared<Input<S>> {
        match Place::<K, S>::of(t, q).on::<f64>() {
            Some(at) => {
                let held = self.model.held_inputs(at.time, at.positions);
                Shared::with_len(held.len(), |i| held[i].map(S::from_f64))
            }
            None => self.inputs(),
        }
    }
    fn set_inputs(prepared: &mut Self::Prepared, inputs: Shared<Input<S>>) {
        prepared.mechanism = prepared.mechanism.with_inputs(inputs);
        if let Some(values) = (&*prepared.mechanism.values as &dyn Any).downcast_ref::<Values>() {
            prepared.kernels.set_inputs(&values.inputs);
        }
    }
    fn on<T: Scalar>(&self, convert: impl Fn(S) -> T) -> Erased<K, T> {
        let Erased { description, rows_left, .. } = *self;
        let (model, values) = (self.model.clone(), Arc::new(self.values.map(convert)));
        let inputs = shared(&values.inputs);
        Erased { model, description, rows_left, values, inputs, storage: PhantomData }
    }
    fn initial(&self) -> Initial<Self::Q> {
        let [positions, speeds] =
            self.model.initial().map(|values| K::Array::with_len(values.len(), |i| S::from_f64(values[i])));
        Initial { positions, speeds }
    }

    fn mass_matrix(&self, t: S, q: &Self::Q) -> Self::QQ {
        self.matrix(Kernel::MassMatrix, &Place::of(t, q), self.n())
    }
    fn speed_mass_matrix(&self, t: S, q: &Self::Q) -> List<List<S>> {
        let rows = self.found(Kernel::SpeedMassMatrix, &Place::of(t, q));
        List::with_len(rows.len(), |i| list(&rows[i]))
    }
    fn convective_forces(&self, t: S, q: &Self::Q, qd: &Self::Q) -> Self::Q {
        self.vector(Kernel::ConvectiveForces, &Place::moving(t, q, qd), self.n())
    }
    fn generalized_forces(&self, t: S, q: &Self::Q, qd: &Self::Q) -> Self::Q {
        self.vector(Kernel::GeneralizedForces, &Place::moving(t, q, qd), self.n())
    }
    fn constraints(&self, t: S, q: &Self::Q) -> Self::L {
        self.vector(Kernel::Constraints, &Place::of(t, q), self.m())
    }
    fn constraint_magnitudes(&self, t: S, q: &Self::Q) -> Self::L {
        self.vector(Kernel::ConstraintMagnitudes, &Place::of(t, q), self.m())
    }
    fn constraint_jacobian(&self, t: S, q: &Self::Q) -> Self::LQ {
        self.matrix(Kernel::ConstraintJacobian, &Place::of(t, q), self.m())
    }
    fn constraint_time_derivative(&self, t: S, q: &Self::Q) -> Self::L {
        self.vector(Kernel::ConstraintTimeDerivative, &Place::of(t, q), self.m())
    }
    fn constraint_convective(&self, t: S, q: &Self::Q, qd: &Self::Q) -> Self::L {
        self.vector(Kernel::ConstraintConvective, &Place::moving(t, q, qd), self.m())
    }
    fn constraint_linearization(&self, t: S, q: &Self::Q) -> ConstraintLinearization<Self::L, Self::LQ> {
        let (n, m) = (self.n(), self.m());
        let [mut values, mut time_derivative] = [(); 2].map(|()| Vector::<K, S>::repeat(m, nan()));
        let mut jacobian = Matrix::<K, S>::repeat(m, Vector::<K, S>::repeat(n, nan()));
        let vectors = [values.as_mut(), time_derivative.as_mut()];
        let found = &mut Rows { vectors, matrices: [jacobian.as_mut()] };
        self.call(Kernel::ConstraintLinearization, &Place::of(t, q), found);
        ConstraintLinearization { values, jacobian, time_derivative }
    }
    fn sparse_linearization(&self, t: S, q: &Self::Q) -> ConstraintLinearization<Self::L, List<S>> {
        let [mut values, mut time_derivative] = [(); 2].map(|()| Vector::<K, S>::repeat(self.m(), nan()));
        let count = self.description().sparsity.iter().map(|row| row.columns.len()).sum();
        let mut jacobian = List::repeat(count, nan());
        let found = &mut vectors([values.as_mut(), time_derivative.as_mut(), jacobian.as_mut()]);
        self.call(Kernel::SparseLinearization, &Place::of(t, q), found);
        ConstraintLinearization { values, jacobian, time_derivative }
    }
    fn kinetic_energy(&self, t: S, q: &Self::Q, qd: &Self::Q) -> S {
        self.scalar(Kernel::KineticEnergy, &Place::moving(t, q, qd))
    }
    fn prepare(&self) -> Self::Prepared {
        ErasedPrepared { mechanism: self.clone(), kernels: self.model.prepare() }
    }
    #[inline]
    fn prepared_dynamics(prepared: &Self::Prepared, t: S, q: &Self::Q, qd: &Self::Q) -> Dynamics<S, Self::Q, Self::L> {
        let mechanism = &prepared.mechanism;
        let (mut accelerations, mut multipliers, mut power) =
            (Vector::<K, S>::repeat(q.len(), nan()), Vector::<K, S>::repeat(mechanism.m(), nan()), nan());
        let found = &mut vectors([accelerations.as_mut(), multipliers.as_mut(), slice::from_mut(&mut power)]);
        let refused = prepared.call(Kernel::Dynamics, &Place::moving(t, q, qd), found);
        Dynamics { accelerations, multipliers, power, refused: mask::<S>(refused) }
    }
    fn inverse_dynamics(&self, t: S, q: &Self::Q, qd: &Self::Q, qdd: &Self::Q) -> Self::Q {
        self.vector(Kernel::InverseDynamics, &Place::moving(t, q, qd).with_accelerations(qdd), self.n())
    }
    fn dynamics_jacobian(&self, t: S, q: &Self::Q, qd: &Self::Q) -> DynamicsJacobian<S, Self::QQ, Self::LQ> {
        let (n, m) = (self.n(), self.m());
        let rows = |count| Matrix::<K, S>::repeat(count, Vector::<K, S>::repeat(n, nan()));
        let mut parts = [rows(n), rows(n), rows(m), rows(m)];
        let found = &mut matrices(parts.each_mut().map(AsMut::as_mut));
        let refused = self.call(Kernel::DynamicsJacobian, &Place::moving(t, q, qd), found);
        let [accelerations_by_positions, accelerations_by_speeds, multipliers_by_positions, multipliers_by_speeds] =
            parts;
        DynamicsJacobian {
            accelerations_by_positions,
            accelerations_by_speeds,
            multipliers_by_positions,
            multipliers_by_speeds,
            refused: mask::<S>(refused),
        }
    }
    fn dynamics_sensitivity(&self, t: S, q: &Self::Q, qd: &Self::Q) -> DynamicsSensitivity<S, Self::QP, Self::LP> {
        let (n, m) = (self.n(), self.m());
        let rows = |count| List::repeat(count, List::repeat(self.values.parameters.len(), nan()));
        let (mut accelerations, mut multipliers) = (rows(n), rows(m));
        let found = &mut matrices([accelerations.as_mut(), multipliers.as_mut()]);
        let refused = self.call(Kernel::DynamicsSensitivity, &Place::moving(t, q, qd), found);
        DynamicsSensitivity { accelerations, multipliers, refused: mask::<S>(refused) }
    }
    fn velocity_variables(&self, t: S, q: &Self::Q, qd: &Self::Q) -> Self::Q {
        match self.rows_left() {
            None => qd.clone(),
            Some(_) => self.vector(Kernel::VelocityVariables, &Place::moving(t, q, qd), self.n()),
        }
    }
    fn prepared_velocities(prepared: &Self::Prepared, t: S, q: &Self::Q, v: &Self::Q) -> Kinematics<S, Self::Q> {
        if prepared.mechanism.rows_left().is_none() {
            return Kinematics { rates: v.clone(), refused: mask::<S>(false) };
        }
        let mut rates = Vector::<K, S>::repeat(q.len(), nan());
        let refused = prepared.call(Kernel::Velocities, &Place::moving(t, q, v), &mut vectors([rates.as_mut()]));
        Kinematics { rates, refused: mask::<S>(refused) }
    }
    fn power(&self, t: S, q: &Self::Q, qd: &Self::Q, qdd: &Self::Q, lambda: &Self::L) -> S {
        self.scalar(Kernel::Power, &Place::of_all(t, [q, qd, qdd, lambda]))
    }
    fn outputs(&self, t: S, q: &Self::Q, qd: &Self::Q, qdd: &Self::Q, lambda: &Self::L) -> List<S> {
        self.list(Kernel::Outputs, &Place::of_all(t, [q, qd, qdd, lambda]), self.description().outputs.len())
    }
    fn output_rates(&self, t: S, q: &Self::Q, qd: &Self::Q, qdd: &Self::Q) -> List<S> {
        let place = Place::moving(t, q, qd).with_accelerations(qdd);
        self.list(Kernel::OutputRates, &place, self.description().rated_outputs.len())
    }
    fn events(&self, t: S, q: &Self::Q, qd: &Self::Q, qdd: &Self::Q, lambda: &Self::L) -> Self::Events {
        self.vector(Kernel::Events, &Place::of_all(t, [q, qd, qdd, lambda]), self.description().events.len())
    }
    fn event_values(&self, t: S, q: &Self::Q, qd: &Self::Q) -> List<S> {
        list(&self.found(Kernel::EventValues, &Place::moving(t, q, qd)).concat())
    }
    fn switching_functions(&self, t: S) -> List<S> {
        self.list(Kernel::SwitchingFunctions, &Place::at(t), self.description().switching.len())
    }
    fn load_conditions(&self, t: S, q: &Self::Q, qd: &Self::Q) -> List<S> {
        self.list(Kernel::LoadConditions, &Place::moving(t, q, qd), self.description().load_conditions.len())
    }
    fn drawing(&self, t: S, q: &Self::Q) -> List<S> {
        list(&self.found(Kernel::Drawing, &Place::of(t, q)).concat())
    }
}

impl<K: Storage, S: Scalar> Erased<K, S> {
    /// As many rows and numbers as the kernel finds.
    fn found(&self, kernel: Kernel, at: &Place<K, S>) -> Vec<Vec<S>> {
        let mut rows = Vec::new();
        self.call(kernel, at, &mut rows);
        rows
    }
}

fn list<S: Scalar>(numbers: &[S]) -> List<S> {
    List::with_len(numbers.len(), |i| numbers[i])
}

fn shared<S: Scalar>(inputs: &[Input<S>]) -> Shared<Input<S>> {
    Shared::with_len(inputs.len(), |i| inputs[i])
}
