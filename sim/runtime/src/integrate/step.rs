//! An accepted step, with its dense output.
//!
//! Dense output uses the projected end and the right-hand side there, and each point taken from it is projected. DOP853
//! has its own interpolant of order 7, Radau its collocation polynomial, with the work from the power at its stages; all
//! others use the quintic of both ends, with DOPRI5's own polynomial of order 4 for speeds and work.

use super::beside::better_accelerations;
use super::corners::apart;
use super::method::Advance;
use crate::motion::Motion;
use crate::motion::consistent::consistent;
use crate::motion::singular::{AT, BESIDE, IN};
use crate::state::failure::{Failure, What};
use crate::state::trajectory::{Sample, State};
use sim_kernel::Mechanism;

/// The largest change of an angle in a part of a step that is searched as a whole: steps of a motion that is simple may go
/// through many turns.
pub(super) const MOST_CHANGE: f64 = 1.0;
/// What differs by this part of what the other side of a corner does has the same form.
const SAME_FORM: f64 = 1e-6;
/// The largest number of parts.
pub(crate) const MOST_PARTS: f64 = 1e6;

/// A step that was made.
pub struct Step<'s, M: Mechanism> {
    /// The motion.
    pub motion: &'s Motion<M>,
    /// Its start.
    pub from: &'s Sample<M>,
    /// Its end, on the constraints.
    pub to: &'s Sample<M>,
    /// The ends of the method's own step: before the start and beyond the end if those lie beside a singular position.
    pub(super) begun: &'s Sample<M>,
    pub(super) reached: &'s Sample<M>,
    /// The smallest sine between a constraint and those before it at `to`.
    pub(super) end_sine: f64,
    pub(super) method: &'s mut dyn Advance<M>,
    /// Whether it leads over a corner, where speeds jump: all of it but its start is as its end.
    pub(super) is_jump: bool,
}

impl<M: Mechanism> Step<'_, M> {
    /// Its length in seconds.
    pub fn length(&self) -> f64 {
        self.to.state.time - self.from.state.time
    }

    /// Into how many parts of equal time it is searched at least, for its changes of angles.
    pub(crate) fn parts_by_angles(&self) -> f64 {
        let (from, to) = (&self.from.state.positions, &self.to.state.positions);
        let coordinates = self.motion.mechanism().description().coordinates.iter().enumerate();
        let angles = coordinates.filter(|(_, coordinate)| !coordinate.position.is_length);
        let change = angles.fold(0.0, |most: f64, (j, _)| most.max((to[j] - from[j]).abs()));
        let parts = (change / MOST_CHANGE).ceil();
        if parts >= 1.0 { parts.min(MOST_PARTS) } else { 1.0 }
    }

    /// The state at a time inside it, on the constraints; at a singular position as the method interpolates it.
    ///
    /// # Errors
    /// As the projection and the right-hand side.
    pub fn at(&mut self, time: f64) -> Result<State<M>, Failure> {
        self.find(time).map(|found| found.state())
    }

    /// The sample at a time inside it. Beside a singular position the equations of motion determine it badly, and at
    /// the position not at all: there accelerations are fitted to regular positions on both sides, if that is more
    /// accurate. Reactions, which may have a pole, and power come from the equations; where they are lost in rounding,
    /// from the nearer end; both as far as the accelerations do not say them.
    ///
    /// # Errors
    /// As the projection and the right-hand side.
    #[inline]
    pub fn sample(&mut self, time: f64) -> Result<Sample<M>, Failure> {
        match self.regular_end(time) {
            Some(end) => Ok(end.clone()),
            None => self.find_sample(time),
        }
    }

    /// Its end, if that is this time and does not lie beside a singular position.
    #[inline(always)]
    pub(crate) fn regular_end(&self, time: f64) -> Option<&Sample<M>> {
        (time == self.to.state.time && self.end_sine >= BESIDE).then_some(self.to)
    }

    fn find_sample(&mut self, time: f64) -> Result<Sample<M>, Failure> {
        let found = self.find(time)?;
        match found.sine >= BESIDE && time != self.to.state.time {
            true => self.motion.sample(found.kept),
            false => self.find_beside(time, found),
        }
    }

    /// The sample at its end, or beside a singular position.
    #[cold]
    fn find_beside(&self, time: f64, found: Inside<M>) -> Result<Sample<M>, Failure> {
        let direct =
            if time == self.to.state.time { Ok(self.to.clone()) } else { self.motion.sample(found.kept.clone()) };
        if found.sine >= BESIDE {
            return direct;
        }
        if direct.is_err() && found.sine >= AT {
            return direct;
        }
        let nearer = if self.fraction(time) < 0.5 { self.begun } else { self.reached };
        let known = direct.as_ref().ok().map(|direct| direct.accelerations.clone());
        let better =
            better_accelerations(self.motion, found.state(), known, nearer.accelerations.clone(), self.made() / 2.0);
        let Some(accelerations) = better else { return direct };
        let (state, known) = match direct {
            Ok(direct) if found.sine >= IN => (found.state(), direct),
            _ => (found.state(), nearer.clone()),
        };
        let multipliers = consistent(self.motion, &state, &accelerations, &known.multipliers);
        Ok(Sample { state, accelerations, multipliers, ..known })
    }

    /// The length of the method's own step, in seconds.
    fn made(&self) -> f64 {
        self.reached.state.time - self.begun.state.time
    }

    fn fraction(&self, time: f64) -> f64 {
        (time - self.begun.state.time) / self.made()
    }

    /// The state at a time within a corner: that of the side with which it has its form in common. The corner itself may be like
    /// neither, as of `abs`; then it is that behind it, at its own time.
    fn side(&self, time: f64) -> State<M> {
        let [behind, before] = [self.to, self.from].map(|side| apart(self.motion, &side.state, time));
        match behind.min(before) <= SAME_FORM * behind.max(before) {
            _ if time <= self.from.state.time => self.from.state.clone(),
            false => self.to.state.clone(),
            true if behind <= before => State { time, ..self.to.state.clone() },
            true => State { time, ..self.from.state.clone() },
        }
    }

    fn find(&mut self, time: f64) -> Result<Inside<M>, Failure> {
        if time == self.to.state.time {
            let end = self.to.state.clone();
            return Ok(Inside { kept: end.clone(), interpolated: end, sine: self.end_sine });
        }
        if self.is_jump {
            let state = self.side(time);
            return Ok(Inside { kept: state.clone(), interpolated: state, sine: self.end_sine });
        }
        let mut kept = self.method.inside(self.motion, self.begun, self.reached, self.fraction(time))?;
        kept.time = time;
        let interpolated = kept.clone();
        match self.motion.keep(&mut kept) {
            Ok(()) => Ok(Inside { kept, interpolated, sine: self.motion.relative_sine() }),
            Err(Failure { what: What::SingularPosition { .. }, .. }) => {
                Ok(Inside { kept: interpolated.clone(), interpolated, sine: 0.0 })
            }
            Err(failure) => Err(failure),
        }
    }
}

/// A state inside a step.
struct Inside<M: Mechanism> {
    /// On the constraints.
    kept: State<M>,
    /// As the method has it.
    interpolated: State<M>,
    /// The smallest sine between a constraint and those before it.
    sine: f64,
}

impl<M: Mechanism> Inside<M> {
    /// The more accurate one.
    fn state(&self) -> State<M> {
        if self.sine < AT { self.interpolated.clone() } else { self.kept.clone() }
    }
}
