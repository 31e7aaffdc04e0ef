//! A step that was made, and what is inside it.

use super::method::Advance;
use crate::failure::{Failure, What};
use crate::motion::Motion;
use crate::nearest::{Known, nearest_polynomial};
use crate::singular::weakest_constraint;
use crate::trajectory::{Sample, State};
use sim_kernel::{Array, Mechanism};

/// A step that was made.
pub struct Step<'s, M: Mechanism> {
    /// The motion.
    pub motion: &'s Motion<'s, M>,
    /// Its start.
    pub from: &'s Sample<M>,
    /// Its end, on the constraints.
    pub to: &'s Sample<M>,
    /// Where the method has gone to: beyond the end where that lies beside a singular position.
    pub(super) reached: &'s Sample<M>,
    pub(super) method: &'s mut dyn Advance<M>,
}

impl<M: Mechanism> Step<'_, M> {
    /// Its length in seconds.
    pub fn length(&self) -> f64 {
        self.to.state.time - self.from.state.time
    }

    /// The state at a time inside it, on the constraints; at a singular position as the method interpolates it.
    ///
    /// # Errors
    /// As the projection and the right-hand side.
    pub fn at(&mut self, time: f64) -> Result<State<M>, Failure> {
        self.find(time).map(|found| if found.is_singular { found.interpolated } else { found.kept })
    }

    /// The state at a time inside it with what follows from it. Beside a singular position the equations of motion determine
    /// that badly, and in it not at all: there accelerations are those that regular positions of the step make likely, unless
    /// that is known no better. Reactions, which may have a pole, and power are what the equations give; where these are lost in
    /// rounding, those of the nearer end.
    ///
    /// # Errors
    /// As the projection and the right-hand side.
    pub fn sample(&mut self, time: f64) -> Result<Sample<M>, Failure> {
        let found = self.find(time)?;
        if !found.is_beside {
            return self.motion.sample(found.kept);
        }
        let fraction = self.fraction(time);
        let (accelerations, known_to) = self.accelerations_across(fraction)?;
        let off = |direct: &Sample<M>| {
            let off = |i: usize| direct.accelerations[i] - accelerations[i];
            self.motion.measures().size(&M::Q::from_fn(off))
        };
        match self.motion.sample(found.kept) {
            Ok(direct) if off(&direct) <= known_to => return Ok(direct),
            Ok(direct) if !found.is_singular => return Ok(Sample { accelerations, ..direct }),
            Err(failure) if !found.is_singular => return Err(failure),
            _ => {}
        }
        if let (Ok(direct), false) = (self.motion.sample(found.kept), found.is_lost) {
            return Ok(Sample { state: found.interpolated, accelerations, ..direct });
        }
        let nearer = if fraction < 0.5 { self.from } else { self.reached };
        Ok(Sample { state: found.interpolated, accelerations, ..*nearer })
    }

    /// The accelerations at a fraction of this step that is at a singular position, by the polynomial nearest to those at
    /// regular positions on both sides of it: along the motion they are smooth, and known the better the farther away. With it
    /// about how well that knows them.
    fn accelerations_across(&mut self, fraction: f64) -> Result<(M::Q, f64), Failure> {
        const LAST: usize = 10;
        let mut known = [Known { fraction: 0.0, weight: 0.0, values: self.from.accelerations }; LAST + 1];
        let mut count = 0;
        for k in 0..=LAST {
            let fraction = k as f64 / LAST as f64;
            let (state, accelerations) = match k {
                0 => (self.from.state, self.from.accelerations),
                LAST => (self.reached.state, self.reached.accelerations),
                _ => {
                    let state = self.find(self.from.state.time + fraction * self.made())?.kept;
                    let Ok(sample) = self.motion.sample(state) else { continue };
                    (state, sample.accelerations)
                }
            };
            let sine = weakest_constraint(self.motion, &state).map_or(1.0, |(_, sine)| sine);
            // Rounding is amplified by the inverse square of the sine.
            known[count] = Known { fraction, weight: sine.powi(4), values: accelerations };
            count += 1;
        }
        let size = |change: &M::Q| self.motion.measures().size(change);
        Ok(nearest_polynomial(&known[..count], fraction, size))
    }

    /// How long a step the method has made, in seconds.
    fn made(&self) -> f64 {
        self.reached.state.time - self.from.state.time
    }

    fn fraction(&self, time: f64) -> f64 {
        (time - self.from.state.time) / self.made()
    }

    fn find(&mut self, time: f64) -> Result<Inside<M>, Failure> {
        if time == self.to.state.time {
            let end = self.to.state;
            return Ok(Inside { kept: end, interpolated: end, is_singular: false, is_beside: false, is_lost: false });
        }
        let mut kept = self.method.inside(self.motion, self.from, self.reached, self.fraction(time))?;
        kept.time = time;
        let interpolated = kept;
        match self.motion.keep(&mut kept) {
            Ok(()) => {
                let (is_singular, is_beside) = (self.motion.is_at_singularity(), self.motion.is_beside_singularity());
                Ok(Inside { kept, interpolated, is_singular, is_beside, is_lost: self.motion.is_in_singularity() })
            }
            Err(Failure { what: What::SingularPosition { .. }, .. }) => {
                Ok(Inside { kept: interpolated, interpolated, is_singular: true, is_beside: true, is_lost: true })
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
    /// Whether that is known better than what is on the constraints.
    is_singular: bool,
    /// Whether accelerations may be known better by those along the motion.
    is_beside: bool,
    /// Whether rounding leaves nothing of reactions.
    is_lost: bool,
}
