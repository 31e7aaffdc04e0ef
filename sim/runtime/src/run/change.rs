//! Changes of parameters and inputs by the owner of a simulation.

use super::Simulation;
use crate::motion::measured::{check_bodies, mobility};
use crate::motion::measures::Measures;
use crate::motion::project::project_velocities;
use crate::motion::singular::IN;
use crate::motion::typed::accelerate;
use crate::state::failure::{Failure, What, constraint_name, largest};
use crate::state::trajectory::State;
use sim_kernel::{Array, Input, Mechanism, Quantity};

/// The largest move of the mechanism by one part of a change of parameters, in the scales of its coordinates: further
/// away may lie another branch.
const NEAR: f64 = 0.1;
/// The smallest part of a change.
const LEAST_PART: f64 = 1e-3;

impl<M: Mechanism> Simulation<M> {
    /// Sets all inputs, from here on. Unchanged inputs have no effect.
    ///
    /// # Errors
    /// [`What::NotFinite`]; [`What::SingularStart`] in a singular position, which a motion passes but cannot start from; and the
    /// earlier failure of the simulation. The simulation then stays unchanged.
    pub fn set_inputs(&mut self, inputs: M::Inputs) -> Result<(), Failure> {
        self.check_sound()?;
        let held = inputs.iter().map(|input| input.held().unwrap_or(0.0));
        self.check_finite("input", self.mechanism().description().inputs, held)?;
        if inputs.as_ref() != self.mechanism().inputs().as_ref() {
            let mechanism = self.mechanism().with_inputs(inputs);
            let State { time, positions, .. } = &self.state;
            if self.may_be_singular() {
                mobility(&mechanism, *time, positions).check_regular(&mechanism, *time, positions)?;
            }
            self.start_anew(mechanism);
        }
        Ok(())
    }

    /// Sets an input by its name, from here on; a value is in SI units.
    ///
    /// # Errors
    /// As [`set_inputs`](Simulation::set_inputs), and [`What::Unknown`].
    #[inline(never)]
    pub fn set_input(&mut self, name: &str, input: Input) -> Result<(), Failure> {
        let mut inputs = self.mechanism().inputs();
        inputs[self.place("input", self.mechanism().description().inputs, name)?] = input;
        self.set_inputs(inputs)
    }

    /// Sets a parameter by its name, in SI units, from here on.
    ///
    /// # Errors
    /// As [`set_parameters`](Simulation::set_parameters), and [`What::Unknown`].
    #[inline(never)]
    pub fn set_parameter(&mut self, name: &str, value: f64) -> Result<(), Failure> {
        let mut parameters = self.mechanism().parameters();
        parameters[self.place("parameter", self.mechanism().description().parameters, name)?] = value;
        self.set_parameters(parameters)
    }

    /// Sets all parameters, in the order of declaration and in SI units, from here on.
    ///
    /// If they open a constraint the mechanism is assembled again on its branch: the parameters change in parts so
    /// small that each moves it only a little, by the smallest change of coordinates, and the speeds follow by the
    /// smallest change too. The change of energy does not count as work.
    ///
    /// # Errors
    /// [`What::ParametersOpen`] if a constraint cannot be closed from here; impossible masses and inertias, and what
    /// [`accelerate`] refuses;
    /// [`What::SingularStart`] in a singular position, [`What::NotFinite`], and the earlier failure of the simulation.
    /// The simulation then stays unchanged.
    pub fn set_parameters(&mut self, parameters: M::Parameters) -> Result<(), Failure> {
        self.check_sound()?;
        self.check_finite("parameter", self.mechanism().description().parameters, parameters.iter().copied())?;
        if parameters.as_ref() == self.mechanism().parameters().as_ref() {
            return Ok(());
        }
        let unchanged = self.clone();
        self.change_to(parameters).inspect_err(|_| *self = unchanged)
    }

    /// Whether the last step has led so near to a singular position that it may be one. Where a motion starts has been checked.
    fn may_be_singular(&self) -> bool {
        let knows_sines = self.motion.keeps_constraints();
        self.stepper.as_ref().is_some_and(|stepper| !knows_sines || stepper.end_sine(&self.motion) < IN)
    }

    fn change_to(&mut self, parameters: M::Parameters) -> Result<(), Failure> {
        let (before, state) = (self.mechanism().clone(), self.state.clone());
        let mechanism = before.with_parameters(parameters.clone());
        check_bodies(&mechanism, state.time, &state.positions)?;
        let state = if moves_constraints(&before, &mechanism, &state) { self.closed(&parameters)? } else { state };
        self.go_over(mechanism, state)?;
        let State { time, positions, speeds, .. } = &self.state;
        accelerate(self.mechanism(), *time, positions, speeds).map(|_| ())
    }

    /// The state with these parameters, on the branch of this one.
    fn closed(&self, parameters: &M::Parameters) -> Result<State<M>, Failure> {
        let old = self.mechanism().parameters();
        let with = |part: f64| {
            let mixed = |i: usize| old[i] + part * (parameters[i] - old[i]);
            let parameters = if part == 1.0 { parameters.clone() } else { parameters.like(mixed) };
            self.mechanism().with_parameters(parameters)
        };
        let (mut state, mut done, mut part) = (self.state.clone(), 0.0, 1.0f64);
        while done < 1.0 {
            let next = (done + part).min(1.0);
            match closed_nearby(&with(next), &state) {
                Some(closed) => (state, done, part) = (closed, next, 2.0 * part),
                None if part > LEAST_PART => part /= 2.0,
                None => {
                    let values = with(1.0).constraints(state.time, &state.positions);
                    let (row, residual) = largest(values.iter()).unwrap_or((0, f64::NAN));
                    let what = What::ParametersOpen { constraint: constraint_name(self.mechanism(), row), residual };
                    return Err(Failure::at(self.mechanism(), what, state.time, &state.positions));
                }
            }
        }
        Ok(state)
    }

    /// The place of a name.
    fn place(&self, kind: &'static str, known: &[Quantity], name: &str) -> Result<usize, Failure> {
        known.iter().position(|quantity| quantity.name == name).ok_or_else(|| {
            let names: Vec<&str> = known.iter().map(|quantity| quantity.name).collect();
            self.refused(What::Unknown { kind, name: name.to_owned(), known: names.join(", ") })
        })
    }

    /// Checks that all values to be set are finite.
    fn check_finite(&self, kind: &str, of: &[Quantity], values: impl Iterator<Item = f64>) -> Result<(), Failure> {
        match of.iter().zip(values).find(|(_, value)| !value.is_finite()) {
            None => Ok(()),
            Some((quantity, _)) => {
                Err(self.refused(What::NotFinite { quantity: format!("{kind} `{}`", quantity.name) }))
            }
        }
    }

    fn refused(&self, what: What) -> Failure {
        Failure::at(self.mechanism(), what, self.state.time, &self.state.positions)
    }
}

/// Whether parameters that change open a constraint at a state, or the rate of one.
fn moves_constraints<M: Mechanism>(before: &M, after: &M, state: &State<M>) -> bool {
    let [was, is] = [before, after].map(|m| m.constraint_linearization(state.time, &state.positions));
    let rates = |linear| crate::motion::residuals::rates(before, linear, &state.speeds);
    was.values.as_ref() != is.values.as_ref() || rates(&was).as_ref() != rates(&is).as_ref()
}

/// The nearest state on the constraints, if it is near.
fn closed_nearby<M: Mechanism>(mechanism: &M, state: &State<M>) -> Option<State<M>> {
    let (time, mut closed) = (state.time, state.clone());
    let measures = Measures::at(mechanism, time, &state.positions);
    let linear = crate::motion::project::project_positions(mechanism, &measures, time, &mut closed.positions).ok()?;
    project_velocities(mechanism, &measures, &linear, time, &closed.positions, &mut closed.speeds).ok()?;
    let moved = closed.positions.like(|i| closed.positions[i] - state.positions[i]);
    (closed.is_finite() && measures.size(mechanism, &moved) <= NEAR).then_some(closed)
}
