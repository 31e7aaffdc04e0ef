//! Simulations whose steps others attempt: on other numbers, or beside other simulations.

use super::Simulation;
use crate::integrate::{Aim, ExplicitRungeKutta, Target, jump_by};
use crate::motion::Motion;
use crate::state::failure::Failure;
use crate::state::settings::Settings;
use crate::state::trajectory::Sample;
use sim_kernel::{Mechanism, Scalar};

/// An attempt that was made elsewhere.
pub(crate) struct Attempted<M: Mechanism> {
    /// The estimate of its error, in units of the tolerance.
    pub(crate) error: f64,
    /// Its end.
    pub(crate) to: Sample<M>,
    /// What the projection found there, as [`Motion::take_projection`].
    pub(crate) closeness: f64,
    /// Likewise.
    pub(crate) longest: M::L,
    /// The number of right-hand sides evaluated, of which one at the end.
    pub(crate) evaluations: u64,
}

impl<M: Mechanism> Simulation<M> {
    /// Says what step is next on the way to a time, for others to attempt: `None` where there is none left.
    ///
    /// # Errors
    /// As [`advance_to`](Simulation::advance_to).
    pub(crate) fn aim(&mut self, until: f64) -> Result<Option<Target>, Failure> {
        let until = self.check_time(until)?;
        self.check_sound()?;
        self.aim_once(until).inspect_err(|failure| self.failure = Some(failure.clone()))
    }

    fn aim_once(&mut self, until: f64) -> Result<Option<Target>, Failure> {
        while self.state.time < until {
            match self.begin_or_head_for(until, &mut ())? {
                Some(true) => continue,
                Some(false) => break,
                None => {}
            }
            let Some(stepper) = &mut self.stepper else { break };
            match stepper.aim(&self.motion, &mut self.steps)? {
                Aim::Attempt => return Ok(Some(*stepper.target())),
                Aim::Made => self.conclude_step(&mut ())?,
                Aim::End => {
                    self.reached(until);
                    break;
                }
            }
        }
        Ok(None)
    }

    /// Makes the attempt of a step that was aimed at.
    ///
    /// # Errors
    /// As [`advance_to`](Simulation::advance_to).
    pub(crate) fn attempt(&mut self) -> Result<(), Failure> {
        let Some(stepper) = &mut self.stepper else { return Ok(()) };
        let attempted = stepper.attempt(&self.motion, self.integrator.method());
        self.judge(attempted)
    }

    /// The settings.
    pub fn settings(&self) -> &Settings {
        &self.settings
    }

    /// The present motion.
    pub(crate) fn motion(&self) -> &Motion<M> {
        &self.motion
    }

    /// How often the motion has been started anew: after an event or a change of the mechanism.
    pub(crate) fn changes(&self) -> u64 {
        self.changes
    }

    /// The sample that the step starts from which was aimed at.
    pub(crate) fn start_of_step(&mut self) -> Option<&Sample<M>> {
        self.stepper.as_mut().map(|stepper| &*stepper.ends()[0])
    }

    /// The samples before and after a jump in the last step, where a condition of loads changes its sign; none if loads are
    /// continuous there.
    ///
    /// # Errors
    /// As the dense output and the right-hand side.
    pub(crate) fn jump_by(&mut self, condition: usize) -> Result<Option<[Sample<M>; 2]>, Failure> {
        let (motion, method) = (&self.motion, self.integrator.method());
        let step = self.stepper.as_mut().and_then(|stepper| stepper.last_step(motion, method));
        step.map_or(Ok(None), |mut step| motion.aside(|| jump_by(&mut step, condition)))
    }

    /// Takes or refuses an attempt that was made elsewhere, on other numbers, by a method with these stages.
    ///
    /// # Errors
    /// As [`advance_to`](Simulation::advance_to).
    pub(crate) fn take_attempt<S: Scalar, N: Mechanism<S>>(
        &mut self,
        attempted: Attempted<M>,
        method: &ExplicitRungeKutta<N, S>,
        number: impl Fn(S) -> f64,
    ) -> Result<(), Failure> {
        let Attempted { error, to, closeness, longest, evaluations } = attempted;
        let is_kept = error <= 1.0;
        self.motion.count(evaluations - u64::from(!is_kept));
        if let Some(stepper) = self.stepper.as_mut().filter(|_| is_kept) {
            *stepper.ends()[1] = to;
            self.motion.take_projection(closeness, longest);
            self.integrator.take_stages(method, number);
        }
        self.judge(Ok(error))
    }

    /// Takes or refuses an attempt whose end stands in its place, and concludes the step if it is taken.
    ///
    /// # Errors
    /// As [`advance_to`](Simulation::advance_to).
    fn judge(&mut self, attempted: Result<f64, Failure>) -> Result<(), Failure> {
        self.judge_once(attempted).inspect_err(|failure| self.failure = Some(failure.clone()))
    }

    fn judge_once(&mut self, attempted: Result<f64, Failure>) -> Result<(), Failure> {
        let Some(stepper) = &mut self.stepper else { return Ok(()) };
        match stepper.judge(&self.motion, self.integrator.method(), &mut self.steps, attempted)? {
            true => self.conclude_step(&mut ()),
            false => Ok(()),
        }
    }
}
