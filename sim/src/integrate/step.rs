//! A step that was made, and what is inside it.

use super::method::Advance;
use crate::failure::{Failure, What};
use crate::motion::Motion;
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
        self.find(time).map(|(state, _)| state)
    }

    /// The state at a time inside it with what follows from it. At a singular position the equations of motion do not
    /// determine that: there accelerations are interpolated between regular positions of the step, and reactions, which have a
    /// pole, and power are those of the nearer end.
    ///
    /// # Errors
    /// As the projection and the right-hand side.
    pub fn sample(&mut self, time: f64) -> Result<Sample<M>, Failure> {
        let (state, is_singular) = self.find(time)?;
        if !is_singular {
            return self.motion.sample(state);
        }
        let fraction = (time - self.from.state.time) / self.length();
        let accelerations = self.accelerations_across(fraction)?;
        let nearer = if fraction < 0.5 { self.from } else { self.to };
        Ok(Sample { state, accelerations, ..*nearer })
    }

    /// The accelerations at a fraction of this step that is at a singular position, by the polynomial through those at regular
    /// positions on both sides of it: along the motion they are smooth.
    ///
    /// Berrut and Trefethen, Barycentric Lagrange Interpolation, SIAM Review 46 (2004), (3.3).
    fn accelerations_across(&mut self, fraction: f64) -> Result<M::Q, Failure> {
        const INTERVALS: usize = 10;
        let mut known = [(0.0, self.from.accelerations); INTERVALS + 1];
        let mut count = 1;
        for k in 1..=INTERVALS {
            let node = k as f64 / INTERVALS as f64;
            let accelerations = match k {
                INTERVALS => self.to.accelerations,
                _ => match self.find(self.from.state.time + node * self.length())? {
                    (_, true) => continue,
                    (state, false) => self.motion.sample(state)?.accelerations,
                },
            };
            known[count] = (node, accelerations);
            count += 1;
        }
        let known = &known[..count];
        let weight = |(k, (node, _)): (usize, &(f64, M::Q))| {
            let others = known.iter().enumerate().filter(|(j, _)| *j != k);
            1.0 / (fraction - node) / others.map(|(_, (other, _))| node - other).product::<f64>()
        };
        let weights: f64 = known.iter().enumerate().map(weight).sum();
        let part = |i: usize| known.iter().enumerate().map(|(k, known)| weight((k, known)) * known.1[i]).sum::<f64>();
        Ok(M::Q::from_fn(|i| part(i) / weights))
    }

    /// The state at a time, and whether it is at a singular position.
    fn find(&mut self, time: f64) -> Result<(State<M>, bool), Failure> {
        if time == self.to.state.time {
            return Ok((self.to.state, false));
        }
        let fraction = (time - self.from.state.time) / self.length();
        let mut state = self.method.inside(self.motion, self.from, self.to, fraction)?;
        state.time = time;
        let interpolated = state;
        match self.motion.keep(&mut state) {
            Ok(()) if self.motion.is_at_singularity() => Ok((interpolated, true)),
            Err(Failure { what: What::SingularPosition { .. }, .. }) => Ok((interpolated, true)),
            kept => kept.map(|()| (state, false)),
        }
    }
}
