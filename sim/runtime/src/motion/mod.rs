//! The equations of motion of one mechanism, and how its states are kept on the constraints.

pub(crate) mod ahead;
pub(crate) mod consistent;
pub(crate) mod equations;
pub(crate) mod field;
pub(crate) mod generalized_speeds;
pub(crate) mod gimbal;
pub(crate) mod inertia;
mod keep;
mod least_norm;
pub(crate) mod lengths;
pub(crate) mod measured;
pub(crate) mod measures;
pub(crate) mod met;
pub(crate) mod mobility;
mod nearby;
pub(crate) mod partition;
pub(crate) mod plain;
pub(crate) mod project;
pub(crate) mod reduction;
pub(crate) mod residuals;
pub(crate) mod rows;
pub(crate) mod singular;
pub(crate) mod typed;
pub(crate) mod velocity_variables;

use crate::motion::equations::{accelerate_by_pivoting, solve_equations};
use crate::motion::generalized_speeds::{determine_speeds, has_generalized_speeds};
use crate::motion::measures::Measures;
use crate::motion::partition::Partition;
use crate::motion::project::{project, smallest_by_inertia};
use crate::motion::residuals::rates;
use crate::state::failure::{Failure, What};
use crate::state::saved::{Bytes, Damaged};
use crate::state::settings::Stabilisation;
use crate::state::slot::Slot;
use crate::state::trajectory::{Sample, State};
use sim_kernel::{Array, Dynamics, Mechanism};
use std::cell::{Cell, RefCell};

/// A mechanism in motion: its right-hand side, its stabilisation, and counts of their use.
#[derive(Clone, Debug)]
pub struct Motion<M: Mechanism> {
    mechanism: M,
    prepared: M::Prepared,
    stabilisation: Stabilisation,
    partition: RefCell<Partition<M>>,
    measures: Measures<M>,
    evaluations: Cell<u64>,
    /// The squares of the longest rows of C_q so far.
    longest: Slot<M::L>,
    /// With redundant constraints, the largest value so far of the smallest sine.
    widest: Cell<f64>,
    /// 1/s^2 where a state was last projected onto the constraints; s is the smallest sine between a row of C_q and
    /// those before.
    closeness: Cell<f64>,
    /// Whether states inside a step are projected onto the constraints too.
    keeps_stages: Cell<bool>,
    /// Whether the step is made in generalised speeds.
    is_in_speeds: Cell<bool>,
    /// The squares of the longest distances so far between the rows that then determine the speeds.
    farthest_of_speeds: Slot<M::Q>,
}

impl<M: Mechanism> Motion<M> {
    /// The motion of a mechanism, kept on its constraints in this way, with its scales.
    pub fn new(mechanism: M, stabilisation: Stabilisation, measures: Measures<M>) -> Motion<M> {
        Motion {
            prepared: mechanism.prepare(),
            stabilisation,
            partition: RefCell::new(Partition::new(&mechanism)),
            measures,
            evaluations: Cell::new(0),
            longest: Slot::new(M::L::repeat(mechanism.m(), 0.0)),
            widest: Cell::new(0.0),
            closeness: Cell::new(0.0),
            keeps_stages: Cell::new(false),
            is_in_speeds: Cell::new(false),
            farthest_of_speeds: Slot::new(M::Q::repeat(mechanism.n(), 0.0)),
            mechanism,
        }
    }

    /// Its state between steps as bytes, or from them. The independent parts are chosen anew for each step, and the
    /// least sine follows from its end.
    pub(crate) fn transfer(&mut self, bytes: &mut Bytes) -> Result<(), Damaged> {
        bytes.mechanism(&mut self.mechanism)?;
        self.prepared = self.mechanism.prepare();
        self.measures.transfer(bytes)?;
        bytes.tally(self.evaluations.get_mut())?;
        bytes.numbers(self.longest.get_mut().as_mut())?;
        bytes.number(self.widest.get_mut())?;
        bytes.flag(self.is_in_speeds.get_mut())?;
        bytes.numbers(self.farthest_of_speeds.get_mut().as_mut())
    }

    /// The scales of coordinates and constraints.
    pub fn measures(&self) -> &Measures<M> {
        &self.measures
    }

    /// The largest part of a change of coordinates, beside those that count as 1.
    #[inline(always)]
    pub(crate) fn size(&self, change: &M::Q) -> f64 {
        self.measures.size(&self.mechanism, change)
    }

    /// The mechanism.
    pub fn mechanism(&self) -> &M {
        &self.mechanism
    }

    /// The prepared parameters of its equations of motion.
    #[inline(always)]
    pub(crate) fn prepared(&self) -> &M::Prepared {
        &self.prepared
    }

    /// The number of evaluations of the right-hand side.
    pub fn evaluations(&self) -> u64 {
        self.evaluations.get()
    }

    /// Counts right-hand sides that were evaluated elsewhere.
    pub(crate) fn count(&self, evaluations: u64) {
        self.evaluations.set(self.evaluations.get() + evaluations);
    }

    /// Takes what a projection elsewhere found: 1/s^2, as [`keep`](Motion::keep), and the greatest squared lengths of rows.
    pub(crate) fn take_projection(&self, closeness: f64, longest: M::L) {
        self.closeness.set(closeness);
        self.longest.set(longest);
    }

    /// The right-hand side at a state inside a step. With partitioning, the dependent parts of the coordinates are
    /// first made to follow.
    ///
    /// # Errors
    /// As [`accelerate`](crate::accelerate), and as the solution of the constraints.
    pub fn sample(&self, state: State<M>) -> Result<Sample<M>, Failure> {
        self.sample_in_place(state)
    }

    /// The same, compiled into its caller: states then stay in registers instead of going through memory in pieces,
    /// which saves a quarter of a run.
    #[inline(always)]
    pub(crate) fn sample_in_place(&self, mut state: State<M>) -> Result<Sample<M>, Failure> {
        let dynamics = self.dynamics(&mut state)?;
        Ok(Sample::new(state, dynamics, self.mechanism.inputs()))
    }

    /// Accelerations, multipliers and power at a state inside a step, after it was brought to the constraints if it has to be.
    #[inline(always)]
    pub(crate) fn dynamics(&self, state: &mut State<M>) -> Result<Dynamics<f64, M::Q, M::L>, Failure> {
        self.evaluations.set(self.evaluations.get() + 1);
        if self.stabilisation == Stabilisation::Partitioning || self.keeps_stages.get() {
            *state = self.brought_to_constraints(state.clone())?;
        }
        let mut dynamics = match self.measures.is_redundant() {
            false => solve_equations(&self.mechanism, &self.prepared, state.time, &state.positions, &state.speeds)?,
            // By value, as below, so that other states stay in registers.
            true => {
                let State { time, positions, speeds, .. } = state.clone();
                accelerate_by_pivoting(&self.mechanism, Some(&self.measures), time, positions, speeds)?
            }
        };
        if let Stabilisation::Baumgarte(rate) = self.stabilisation {
            let push = baumgarte(&self.mechanism, &self.measures, state.clone(), rate)?;
            dynamics.accelerations = dynamics.accelerations.like(|i| dynamics.accelerations[i] - push[i]);
        }
        Ok(dynamics)
    }

    /// By value, so that the state of every other stage stays in registers.
    #[cold]
    fn brought_to_constraints(&self, mut state: State<M>) -> Result<State<M>, Failure> {
        let bring = |state: &mut State<M>| match self.stabilisation {
            Stabilisation::Partitioning => self.partition.borrow().follow(&self.mechanism, &self.measures, state),
            _ => project(&self.mechanism, &self.measures, state),
        };
        match self.is_in_generalized_speeds() {
            false => bring(&mut state)?,
            true => self.with_velocity_variables_kept(&mut state, bring)?,
        }
        Ok(state)
    }

    /// d(q'')/dq and d(q'')/dq' at a sample: the generated kernel, or difference quotients if that refuses a pivot, is
    /// not finite, or does not describe the integrated equations.
    ///
    /// # Errors
    /// As the right-hand side.
    pub fn jacobian(&self, at: &Sample<M>) -> Result<(M::QQ, M::QQ), Failure> {
        let state = &at.state;
        let is_projected = matches!(self.stabilisation, Stabilisation::Projection | Stabilisation::MassProjection);
        if !is_projected || self.measures.is_redundant() {
            return self.difference_quotients(at);
        }
        let generated = self.mechanism.dynamics_jacobian(state.time, &state.positions, &state.speeds);
        let (by_positions, by_speeds) = (generated.accelerations_by_positions, generated.accelerations_by_speeds);
        // Far from its pulse a derivative may be the quotient of two infinities, as that of 1/cosh(x) for x > 710. Newton's method,
        // for which this matrix is, needs it about right; its solution does not depend on it.
        let is_finite = |matrix: &M::QQ| matrix.iter().all(|row| row.iter().all(|entry| entry.is_finite()));
        match !generated.refused && is_finite(&by_positions) && is_finite(&by_speeds) {
            true => Ok((by_positions, by_speeds)),
            false => self.difference_quotients(at),
        }
    }

    #[cold]
    fn difference_quotients(&self, at: &Sample<M>) -> Result<(M::QQ, M::QQ), Failure> {
        let n = self.mechanism.n();
        let zero = M::QQ::repeat(n, M::Q::repeat(n, 0.0));
        let (mut by_positions, mut by_speeds) = (zero.clone(), zero);
        for j in 0..n {
            let (mut moved, mut hastened) = (at.state.clone(), at.state.clone());
            let step = |x: f64| f64::EPSILON.sqrt() * x.abs().max(self.measures.coordinates()[j]);
            let steps = [step(moved.positions[j]), step(hastened.speeds[j])];
            moved.positions[j] += steps[0];
            hastened.speeds[j] += steps[1];
            let [moved, hastened] = [self.sample(moved)?.accelerations, self.sample(hastened)?.accelerations];
            for i in 0..n {
                by_positions[i][j] = (moved[i] - at.accelerations[i]) / steps[0];
                by_speeds[i][j] = (hastened[i] - at.accelerations[i]) / steps[1];
            }
        }
        Ok((by_positions, by_speeds))
    }

    /// The smallest sine between a row of C_q and those before it, where a state was last projected; for combinations
    /// of redundant rows not yet [`relative`](Motion::relative).
    #[inline]
    pub(crate) fn least_sine(&self) -> f64 {
        1.0 / self.closeness.get().sqrt()
    }

    /// A least sine relative to its largest value so far, if constraints are redundant.
    #[inline]
    pub(crate) fn relative(&self, sine: f64) -> f64 {
        if self.measures.is_redundant() { sine / self.widest.get() } else { sine }
    }

    /// The relative [`least_sine`](Motion::least_sine).
    pub(crate) fn relative_sine(&self) -> f64 {
        self.relative(self.least_sine())
    }

    /// Whether states are projected onto the constraints at all.
    pub(crate) fn keeps_constraints(&self) -> bool {
        !matches!(self.stabilisation, Stabilisation::Baumgarte(_) | Stabilisation::None)
    }

    /// Sets whether states inside a step are projected onto the constraints too.
    pub(crate) fn keep_stages(&self, keeps: bool) {
        self.keeps_stages
            .set(keeps && matches!(self.stabilisation, Stabilisation::Projection | Stabilisation::MassProjection));
    }

    /// The squares of the longest rows of C_q so far.
    pub(crate) fn longest(&self) -> M::L {
        self.longest.get()
    }

    /// Records a smallest sine: for combinations of redundant constraints its regular value depends on the mechanism,
    /// and is taken to be the largest.
    pub(crate) fn widen(&self, sine: f64) {
        if sine.is_finite() {
            self.widest.set(self.widest.get().max(sine));
        }
    }

    /// What a look at states says, without a trace of it in what the motion records of its rows.
    pub(crate) fn aside<T>(&self, look: impl FnOnce() -> T) -> T {
        let (longest, widest, closeness) = (self.longest.get(), self.widest.get(), self.closeness.get());
        let found = look();
        self.longest.set(longest);
        self.widest.set(widest);
        self.closeness.set(closeness);
        found
    }

    /// Goes back to these squares of the longest rows: where a refused step has led says nothing of those on the way.
    pub(crate) fn forget(&self, longest: &M::L) {
        self.longest.set(longest.clone());
    }

    /// Records the squares of the lengths of rows.
    pub(crate) fn lengthen(&self, square: impl Fn(usize) -> f64) {
        let mut longest = self.longest.take();
        longest.as_mut().iter_mut().enumerate().for_each(|(row, longest)| *longest = longest.max(square(row)));
        self.longest.set(longest);
    }

    /// Whether the step is made in generalised speeds.
    #[inline(always)]
    pub(crate) fn is_in_generalized_speeds(&self) -> bool {
        has_generalized_speeds(&self.mechanism) && self.is_in_speeds.get()
    }

    /// Switches to the speeds themselves if the step fails because generalised speeds do not determine them.
    pub(crate) fn falls_back(&self, failure: &Failure) -> bool {
        failure.what == What::SpeedsUndetermined && self.is_in_speeds.replace(false)
    }

    /// Prepares for states near this one: chooses the independent parts by it.
    pub fn start(&self, state: &State<M>) {
        if self.stabilisation == Stabilisation::Partitioning {
            self.partition.borrow_mut().choose(&self.mechanism, &self.measures, state.time, &state.positions);
        }
    }

    /// Chooses whether the step from a sample to a time is made in generalised speeds, if its method can.
    pub(crate) fn choose_velocity_variables(&self, from: &Sample<M>, time: f64, may_be_in_speeds: bool) {
        let determine = || determine_speeds(&self.mechanism, &self.measures, (from, time), &self.farthest_of_speeds);
        self.is_in_speeds.set(may_be_in_speeds && determine());
    }

    /// Prepares for a step from a sample to a time: chooses the independent parts for it.
    #[inline]
    pub fn prepare(&self, from: &Sample<M>, time: f64) {
        if self.stabilisation == Stabilisation::Partitioning {
            self.partition.borrow_mut().renew(&self.mechanism, &self.measures, from, time);
        }
    }
}

/// The correction that Baumgarte's method subtracts from the accelerations: x with
/// [M C_q'; C_q 0] [x; .] = [0; 2 a C' + a^2 C].
#[cold]
fn baumgarte<M: Mechanism>(mechanism: &M, measures: &Measures<M>, state: State<M>, rate: f64) -> Result<M::Q, Failure> {
    let linear = mechanism.constraint_linearization(state.time, &state.positions);
    let speeds = rates(mechanism, &linear, &state.speeds);
    let open = speeds.like(|i| 2.0 * rate * speeds[i] + rate * rate * linear.values[i]);
    smallest_by_inertia(mechanism, measures, state.time, &state.positions, (&linear.jacobian, &open), measures.rank())
}
