//! A motion that its owner advances.
//!
//! [`run`](crate::run()), with a controller or without, is a loop over a simulation with a recorder. The time to which
//! a simulation is advanced is the end of a step and not interpolated, as inputs and parameters may change there.

use crate::events::{EventHandler, Occurrence};
use crate::integrate::{Course, Integrator, Stepper, Steps, first_sample};
use crate::motion::Motion;
use crate::motion::measured::{check_bodies, mobility};
use crate::motion::measures::Measures;
use crate::motion::mobility::Mobility;
use crate::record::Watch;
use crate::start::assemble::{Start, assemble};
use crate::state::failure::{Failure, What};
use crate::state::settings::Settings;
use crate::state::trajectory::{Sample, State};
use sim_kernel::Mechanism;

/// A motion that its owner advances, step by step or to a time. In between, inputs and parameters may be set.
///
/// It uses neither threads nor clocks nor files. It carries out the actions of events and remembers them, but records
/// no rows: the caller takes them as needed. [`run`](crate::run()) is a loop over it.
///
/// ```
/// use sim::{Input, Settings, Simulation, declared_start};
/// # sim::mechanism! {
/// #     Cart;
/// #     coordinates { x [m]; }
/// #     parameters { m [kg] = 2; }
/// #     inputs { F [N] = 0; }
/// #     bodies { cart: mass m at [x, 0]; }
/// #     loads { force [F, 0] at [x, 0]; }
/// #     initial { x = 0; dot(x) = 0; }
/// # }
/// let cart = Cart::default();
/// let mut simulation = Simulation::new(cart, &declared_start(&cart), &Settings::new(2.0))?;
/// simulation.advance_to(1.0)?;
/// simulation.set_inputs([Input::Held(4.0)])?;
/// simulation.advance_to(2.0)?;
/// assert!((simulation.state().positions[0] - 1.0).abs() < 1e-12);
/// # Ok::<(), sim::Failure>(())
/// ```
#[derive(Clone, Debug)]
pub struct Simulation<M: Mechanism> {
    pub(super) settings: Settings,
    /// When it began, in seconds.
    pub(super) begin: f64,
    pub(super) mobility: Mobility,
    pub(super) state: State<M>,
    pub(super) measures: Measures<M>,
    pub(super) motion: Motion<M>,
    pub(super) integrator: Integrator<M>,
    /// None if the motion is to start again.
    pub(super) stepper: Option<Stepper<M>>,
    /// Whether a phase begins there.
    pub(super) begins_phase: bool,
    /// How often the motion has been started anew.
    pub(super) changes: u64,
    pub(super) events: EventHandler<M>,
    pub(super) steps: Steps,
    /// Right-hand sides of motions before this one.
    pub(super) evaluations: u64,
    /// Why it cannot continue: the actions of an event have failed.
    pub(super) failure: Option<Failure>,
}

impl<M: Mechanism> Simulation<M> {
    /// A motion that has not begun yet. Its settings limit its duration; their rows are for
    /// [`run`](crate::run()).
    ///
    /// # Errors
    /// If no start can be assembled, or it is singular; [`What::Unusable`] settings.
    #[inline(never)]
    pub fn new(mechanism: M, start: &Start<M>, settings: &Settings) -> Result<Simulation<M>, Failure> {
        let state = assemble(&mechanism, start)?;
        settings
            .check(mechanism.description().events.len())
            .map_err(|setting| Failure::at(&mechanism, What::Unusable { setting }, state.time, &state.positions))?;
        check_bodies(&mechanism, state.time, &state.positions)?;
        let mobility = mobility(&mechanism, state.time, &state.positions);
        mobility.check_regular(&mechanism, state.time, &state.positions)?;
        let measures = Measures::with_mobility(&mechanism, state.time, &state.positions, &mobility);
        let integrator = Integrator::new(&mechanism, settings.method);
        let events = EventHandler::new(&mechanism, settings, state.time);
        Ok(Simulation {
            settings: *settings,
            begin: state.time,
            mobility,
            state,
            measures: measures.clone(),
            motion: Motion::new(mechanism, settings.stabilisation, measures),
            integrator,
            stepper: None,
            begins_phase: true,
            changes: 0,
            events,
            steps: Steps::default(),
            evaluations: 0,
            failure: None,
        })
    }

    /// The mechanism with its present parameters and inputs.
    pub fn mechanism(&self) -> &M {
        self.motion.mechanism()
    }

    /// The present state.
    pub fn state(&self) -> &State<M> {
        &self.state
    }

    /// The same with accelerations and multipliers, as in a row of a run.
    ///
    /// # Errors
    /// As the right-hand side.
    #[inline(never)]
    pub fn sample(&self) -> Result<Sample<M>, Failure> {
        match &self.stepper {
            // An event that ends the motion lies within the last step.
            Some(stepper) if !self.events.has_ended() => stepper.sample(&self.motion, self.integrator.clone().method()),
            _ => first_sample(
                &Motion::new(self.mechanism().clone(), self.settings.stabilisation, self.measures.clone()),
                self.state.clone(),
            ),
        }
    }

    /// The past events, in order of time.
    pub fn events(&self) -> &[Occurrence<M>] {
        self.events.found()
    }

    /// Degrees of freedom and dependent constraints at the start.
    pub fn mobility(&self) -> &Mobility {
        &self.mobility
    }

    /// The scales of its coordinates and constraints.
    pub(crate) fn measures(&self) -> &Measures<M> {
        self.motion.measures()
    }

    /// The number of steps made.
    pub fn steps(&self) -> &Steps {
        &self.steps
    }

    /// The number of evaluations of the right-hand side.
    pub fn evaluations(&self) -> u64 {
        self.evaluations + self.motion.evaluations()
    }

    /// The kinetic energy that events have taken, in joules.
    pub fn energy_taken(&self) -> f64 {
        self.events.energy_taken()
    }

    /// Whether the motion has come to the end of its settings, or to an event that ends it.
    pub fn has_ended(&self) -> bool {
        self.events.has_ended() || self.state.time >= self.settings.end
    }

    /// Makes one step, and carries out the actions of events in it; gives whether a step was left to make.
    ///
    /// # Errors
    /// The first failure that smaller steps do not avoid, and failures of events. The motion ends there: every further
    /// step fails likewise.
    #[inline(never)]
    pub fn step(&mut self) -> Result<bool, Failure> {
        while self.stepper.is_none() {
            if !self.advance(self.settings.end, &mut ())? {
                return Ok(false);
            }
        }
        self.advance(self.settings.end, &mut ())
    }

    /// Advances to a time, at which a step ends, or to the end of the motion if that is earlier. One that is past changes nothing.
    ///
    /// # Errors
    /// As [`step`](Simulation::step), and [`What::Unusable`] if the time is NaN.
    pub fn advance_to(&mut self, time: f64) -> Result<(), Failure> {
        self.advance_while(time, &mut || true)
    }

    /// The same for as long as `goes_on` says so, which is asked before each step.
    ///
    /// # Errors
    /// As [`advance_to`](Simulation::advance_to).
    #[inline(never)]
    pub fn advance_while(&mut self, time: f64, goes_on: &mut dyn FnMut() -> bool) -> Result<(), Failure> {
        let time = self.check_time(time)?;
        self.check_sound()?;
        while self.state.time < time && goes_on() && self.advance(time, &mut ())? {}
        Ok(())
    }

    /// Begins a motion, or makes one step that ends at a time or before it, and passes it to the watcher. It is
    /// compiled for each watcher, together with the step: that saves a tenth of a run.
    ///
    /// # Errors
    /// As [`step`](Simulation::step), and failures of the watcher.
    pub(crate) fn advance(&mut self, until: f64, watch: &mut impl Watch<M>) -> Result<bool, Failure> {
        self.check_sound()?;
        self.advance_once(until, watch).inspect_err(|failure| self.failure = Some(failure.clone()))
    }

    fn advance_once(&mut self, until: f64, watch: &mut impl Watch<M>) -> Result<bool, Failure> {
        if let Some(goes_on) = self.begin_or_head_for(until, watch)? {
            return Ok(goes_on);
        }
        let Some(stepper) = &mut self.stepper else { return Ok(false) };
        if !stepper.advance(&self.motion, self.integrator.method(), &mut self.steps)? {
            self.reached(until);
            return Ok(false);
        }
        self.conclude_step(watch)?;
        Ok(true)
    }

    /// Begins a motion, and gives whether it goes on; `None` if one is on its way to a time already.
    #[inline(always)]
    pub(super) fn begin_or_head_for(&mut self, until: f64, watch: &mut impl Watch<M>) -> Result<Option<bool>, Failure> {
        // A phase after an event begins, even if the event ends the motion.
        if self.events.has_ended() && !self.begins_phase {
            return Ok(Some(false));
        }
        let Some(stepper) = &mut self.stepper else {
            let course = self.course(until);
            self.stepper = self.begin(&course, watch)?;
            return Ok(Some(self.stepper.is_some() || self.begins_phase || !self.has_ended()));
        };
        if stepper.end() != until {
            stepper.head_for(&Course::new(&self.settings, self.begin, until));
        }
        Ok(None)
    }

    /// Comes to the end of a course. With equal steps the remainder is rounding.
    pub(super) fn reached(&mut self, until: f64) {
        self.state.time = self.state.time.max(until);
    }

    /// Looks for events in the last step, and carries them out.
    #[inline(always)]
    pub(super) fn conclude_step(&mut self, watch: &mut impl Watch<M>) -> Result<(), Failure> {
        let Some(stepper) = &mut self.stepper else { return Ok(()) };
        let Some(mut step) = stepper.last_step(&self.motion, self.integrator.method()) else { return Ok(()) };
        let ended = self.events.search(&mut step)?;
        watch.steps(&mut step, ended)?;
        match ended {
            None => self.state = step.to.state.clone(),
            Some(state) => {
                self.state = state.clone();
                self.events.act(&self.motion)?;
                self.change_phase()?;
            }
        }
        Ok(())
    }

    /// A time to advance to, as far as the motion goes.
    pub(super) fn check_time(&self, time: f64) -> Result<f64, Failure> {
        if time.is_nan() {
            let what = What::Unusable { setting: "the time to advance to is not a number".to_owned() };
            return Err(Failure::at(self.mechanism(), what, self.state.time, &self.state.positions));
        }
        Ok(time.min(self.settings.end))
    }

    /// Checks that it can continue.
    #[inline(always)]
    pub(super) fn check_sound(&self) -> Result<(), Failure> {
        match &self.failure {
            None => Ok(()),
            Some(failure) => Err(failure.clone()),
        }
    }

    /// The course to a time.
    pub(super) fn course(&self, until: f64) -> Course {
        Course::new(&self.settings, self.begin, until)
    }

    /// Begins a motion, and carries out the actions of events that happen there; `None` if these change or end it.
    fn begin(&mut self, course: &Course, watch: &mut impl Watch<M>) -> Result<Option<Stepper<M>>, Failure> {
        self.motion.start(&self.state);
        let sample = first_sample(&self.motion, self.state.clone())?;
        if self.begins_phase {
            self.begins_phase = false;
            watch.starts(&self.motion, &sample, self.events.energy_taken());
            self.events.start(&self.motion, &sample)?;
        } else {
            self.events.resume(&self.motion, &sample)?;
        }
        if self.change_phase()? {
            return Ok(None);
        }
        if self.has_ended() {
            return Ok(None);
        }
        self.integrator = Integrator::new(self.motion.mechanism(), self.settings.method);
        Stepper::new(&self.motion, self.integrator.method(), course, sample).map(Some)
    }

    /// Moves on to the next phase, if events have started one; its first state may be singular.
    fn change_phase(&mut self) -> Result<bool, Failure> {
        let Some((mechanism, state)) = self.events.next_phase() else { return Ok(false) };
        self.begins_phase = true;
        self.go_over(mechanism, state)?;
        Ok(true)
    }

    /// Continues from a state with another mechanism.
    pub(super) fn go_over(&mut self, mechanism: M, state: State<M>) -> Result<(), Failure> {
        self.state = state.clone();
        let found = mobility(&mechanism, state.time, &state.positions);
        let at = (state.time, &state.positions);
        self.measures = Measures::after_with_mobility(&self.measures, &mechanism, at, &found);
        self.start_anew(mechanism);
        found.check_regular(self.mechanism(), state.time, &state.positions)
    }

    /// Makes the next step start a motion of this mechanism.
    pub(super) fn start_anew(&mut self, mechanism: M) {
        self.changes += 1;
        self.evaluations += self.motion.evaluations();
        self.motion = Motion::new(mechanism, self.settings.stabilisation, self.measures.clone());
        self.stepper = None;
    }

    /// The past events, at the end, and the number of steps.
    pub(crate) fn conclude(self) -> (Vec<Occurrence<M>>, Steps) {
        (self.events.into_found(), self.steps)
    }
}
