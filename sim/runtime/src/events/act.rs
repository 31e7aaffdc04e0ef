//! The actions of events: switching constraints, setting parameters and coordinates, impacts.
//!
//! An impact changes the speeds by the impulsive equations (Pfeiffer and Glocker, Multibody Dynamics with Unilateral
//! Contacts, 1996, chapter 8, for bilateral rows and Newton's coefficient e):
//!
//! ```text
//! M (v+ - v-) + C_q' L = 0        C_q v+ + C_t = -e (C_q v- + C_t)
//! ```
//!
//! with e = 0 for every row that holds already. Where a constraint becomes active, or speeds are set that the
//! constraints do not allow, the same equations with e = 0 for all rows bring the speeds onto them.

use crate::model::conditional::is_active;
use crate::motion::equations::impulse;
use crate::motion::lengths::of_constraints;
use crate::motion::measured::check_masses;
use crate::motion::measures::Measures;
use crate::motion::project::project_positions;
use crate::motion::residuals::rates;
use crate::motion::typed::Any;
use crate::state::failure::{Failure, What, constraint_name};
use crate::state::saved::{Bytes, Damaged};
use crate::state::trajectory::State;
use sim_kernel::event::{Assignment, Event, Hit, Step, Switch, Target};
use sim_kernel::{Array, Mechanism};

/// The changes by an event.
#[derive(Clone, Debug)]
pub struct Change<M: Mechanism> {
    /// The mechanism from then on.
    pub mechanism: M,
    /// The state after, at the same time.
    pub state: State<M>,
    /// The impulse of each constraint row: its multiplier, summed up over the time of the impact.
    pub impulses: M::L,
    /// The lost kinetic energy, in joules.
    pub energy_taken: f64,
    /// Whether the motion ends here.
    pub ends: bool,
}

/// How well a state at an event is known.
#[derive(Debug)]
pub struct Located<'a, M: Mechanism> {
    /// The scales of the motion.
    pub measures: &'a Measures<M>,
    /// The accuracy of its time, in seconds.
    pub within: f64,
}

/// Carries out the actions of an event for this occurrence.
///
/// # Errors
/// [`What::NotFinite`], [`What::Restitution`], [`What::EventOpens`], and as the equations of an impact.
pub fn act<M: Mechanism>(
    mechanism: &M,
    located: &Located<M>,
    before: &State<M>,
    event: &'static Event,
    occurrence: usize,
) -> Result<Change<M>, Failure> {
    let mut change = Change::none(mechanism.clone(), before.clone());
    let mut is_set = false;
    for step in event.steps {
        // What strikes has speeds that the constraints allow.
        if is_set && matches!(step, Step::Impact(_)) {
            change.settle(located, event)?;
        }
        is_set = matches!(step, Step::Set(_));
        match step {
            Step::Stop(after) => change.ends |= occurrence >= *after,
            Step::Set(assignments) => change.set(assignments, event)?,
            Step::Switch(switches) => change.switch(switches, located, event)?,
            Step::Impact(hits) => change.hit(hits, located, event)?,
        }
    }
    change.settle(located, event)?;
    // The norm of a quaternion is no force's to keep.
    mechanism.description().norm_constraints.iter().for_each(|row| change.impulses[*row] = 0.0);
    change.energy_taken = kinetic_energy(mechanism, before) - kinetic_energy(&change.mechanism, &change.state);
    Ok(change)
}

fn kinetic_energy<M: Mechanism>(mechanism: &M, state: &State<M>) -> f64 {
    mechanism.kinetic_energy(state.time, &state.positions, &state.speeds)
}

impl<M: Mechanism> Change<M> {
    /// None.
    pub(crate) fn none(mechanism: M, state: State<M>) -> Change<M> {
        let impulses = M::L::repeat(mechanism.m(), 0.0);
        Change { mechanism, state, impulses, energy_taken: 0.0, ends: false }
    }

    /// All of it as bytes, or from them.
    pub(crate) fn transfer(&mut self, bytes: &mut Bytes) -> Result<(), Damaged> {
        bytes.mechanism(&mut self.mechanism)?;
        bytes.state(&mut self.state)?;
        bytes.numbers(self.impulses.as_mut())?;
        bytes.number(&mut self.energy_taken)?;
        bytes.flag(&mut self.ends)
    }

    fn fail<T>(&self, what: What) -> Result<T, Failure> {
        Err(Failure::at(&self.mechanism, what, self.state.time, &self.state.positions))
    }

    fn values(&self) -> M::EventValues {
        self.mechanism.event_values(self.state.time, &self.state.positions, &self.state.speeds)
    }

    fn set(&mut self, assignments: &[Assignment], event: &'static Event) -> Result<(), Failure> {
        let values = self.values();
        let mut parameters = self.mechanism.parameters();
        for Assignment { target, value } in assignments {
            let value = values[*value];
            if !value.is_finite() {
                let quantity = format!("what event `{}` sets", event.name);
                return self.fail(What::NotFinite { quantity });
            }
            match *target {
                Target::Parameter(index) => parameters[index] = value,
                Target::Position(index) => self.state.positions[index] = value,
                Target::Speed(index) => self.state.speeds[index] = value,
            }
        }
        self.mechanism = self.mechanism.with_parameters(parameters);
        check_masses(&self.mechanism, self.state.time, &self.state.positions)
    }

    fn switch(&mut self, switches: &[Switch], located: &Located<M>, event: &'static Event) -> Result<(), Failure> {
        let mut activities = self.mechanism.activities();
        for Switch { conditional, active } in switches {
            activities[*conditional] = f64::from(u8::from(*active));
        }
        self.mechanism = self.mechanism.clone().with_activities(activities);
        self.settle(located, event)
    }

    /// An impact on constraints that hold for its instant.
    fn hit(&mut self, hits: &[Hit], located: &Located<M>, event: &'static Event) -> Result<(), Failure> {
        let values = self.values();
        let mut activities = self.mechanism.activities();
        let mut restitution = self.impulses.like(|_| 0.0);
        for Hit { conditional, restitution: value } in hits {
            activities[*conditional] = 1.0;
            let (described, coefficient) = (&self.mechanism.description().conditionals[*conditional], values[*value]);
            if !(coefficient >= 0.0 && coefficient.is_finite()) {
                return self.fail(What::Restitution { event: event.name, constraint: described.name, coefficient });
            }
            let rows = described.first_row..described.first_row + described.rows;
            rows.for_each(|row| restitution[row] = coefficient);
        }
        let struck = self.mechanism.clone().with_activities(activities);
        self.check_closed(&struck, located, event)?;
        self.push(&struck, |row, rate| (1.0 + restitution[row]) * rate)
    }

    /// Brings the state onto the constraints that hold.
    fn settle(&mut self, located: &Located<M>, event: &'static Event) -> Result<(), Failure> {
        let mechanism = self.mechanism.clone();
        self.check_closed(&mechanism, located, event)?;
        let measures = Measures::after(located.measures, &mechanism, self.state.time, &self.state.positions);
        project_positions(&mechanism, &measures, self.state.time, &mut self.state.positions)?;
        let linear = mechanism.constraint_linearization(self.state.time, &self.state.positions);
        let open = rates(&mechanism, &linear, &self.state.speeds);
        let size = |row: usize| {
            let terms = linear.jacobian[row].iter().zip(self.state.speeds.iter());
            terms.map(|(c, v)| (c * v).abs()).sum::<f64>() + linear.time_derivative[row].abs()
        };
        match (0..mechanism.m()).any(|row| !(open[row].abs() <= ROUNDING * size(row) + f64::EPSILON)) {
            true => self.push(&mechanism, |_, rate| rate),
            false => Ok(()),
        }
    }

    /// Changes the speeds by an impulse, so that the rates of the constraints of `mechanism` fall by `fall`.
    fn push(&mut self, mechanism: &M, fall: impl Fn(usize, f64) -> f64) -> Result<(), Failure> {
        let (time, q) = (self.state.time, &self.state.positions);
        let linear = mechanism.constraint_linearization(time, q);
        let open = rates(mechanism, &linear, &self.state.speeds);
        let fall = M::L::with_len(mechanism.m(), |row| fall(row, open[row]));
        let (speeds, impulses) = impulse(mechanism, time, q, &linear.jacobian, (&q.like(|_| 0.0), &fall))?;
        self.state.speeds = self.state.speeds.like(|j| self.state.speeds[j] - speeds[j]);
        self.impulses = self.impulses.like(|row| self.impulses[row] - impulses[row]);
        Ok(())
    }

    /// Checks that the positions satisfy the constraints, to the accuracy of locating an event.
    fn check_closed(&self, mechanism: &M, located: &Located<M>, event: &'static Event) -> Result<(), Failure> {
        let (time, q) = (self.state.time, &self.state.positions);
        let linear = mechanism.constraint_linearization(time, q);
        let (values, rates) = (&linear.values, rates(mechanism, &linear, &self.state.speeds));
        let magnitudes = mechanism.constraint_magnitudes(time, q);
        let sizes = of_constraints(&Any(mechanism), time, q.as_ref(), located.measures.coordinates().as_ref());
        let most =
            |row: usize| LOCATED * magnitudes[row] + CLOSED * sizes[row] + 2.0 * located.within * rates[row].abs();
        let open = |row: &usize| !(values[*row].abs() <= most(*row));
        match (0..mechanism.m()).filter(|row| is_active(mechanism, *row)).find(open) {
            None => Ok(()),
            Some(row) => {
                let (constraint, residual) = (constraint_name(mechanism, row), values[row]);
                self.fail(What::EventOpens { event: event.name, constraint, residual })
            }
        }
    }
}

/// A rate this small relative to its terms is rounding.
const ROUNDING: f64 = 1e-12;
/// The largest residual of a constraint at an event, relative to its terms, that a projection closes.
const LOCATED: f64 = 1e-7;
/// The same relative to its changes by those of the coordinates that count as 1: all terms of y = 0 are small at a contact.
const CLOSED: f64 = 1e-9;
