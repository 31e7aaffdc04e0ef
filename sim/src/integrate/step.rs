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
        self.find(time).map(|found| if found.is_singular { found.interpolated } else { found.kept })
    }

    /// The state at a time inside it with what follows from it. At a singular position the equations of motion do not
    /// determine that: there accelerations are interpolated between regular positions of the step, unless that is known no
    /// better, and reactions, which have a pole, and power are those of the nearer end.
    ///
    /// # Errors
    /// As the projection and the right-hand side.
    pub fn sample(&mut self, time: f64) -> Result<Sample<M>, Failure> {
        let found = self.find(time)?;
        if !found.is_singular {
            return self.motion.sample(found.kept);
        }
        let fraction = (time - self.from.state.time) / self.length();
        let (accelerations, known_to) = self.accelerations_across(fraction)?;
        let size = |a: &M::Q, b: &M::Q| self.motion.measures().size(&M::Q::from_fn(|i| a[i] - b[i]));
        let direct = self.motion.sample(found.kept).ok();
        if let Some(direct) = direct.filter(|direct| size(&direct.accelerations, &accelerations) <= known_to) {
            return Ok(direct);
        }
        let nearer = if fraction < 0.5 { self.from } else { self.to };
        Ok(Sample { state: found.interpolated, accelerations, ..*nearer })
    }

    /// The accelerations at a fraction of this step that is at a singular position, by the polynomial through those at regular
    /// positions on both sides of it: along the motion they are smooth. With it about how well that knows them: what the
    /// nearest of these positions changes.
    fn accelerations_across(&mut self, fraction: f64) -> Result<(M::Q, f64), Failure> {
        const INTERVALS: usize = 10;
        let mut known = [(0.0, self.from.accelerations); INTERVALS + 1];
        let mut count = 1;
        for k in 1..=INTERVALS {
            let node = k as f64 / INTERVALS as f64;
            let accelerations = match k {
                INTERVALS => self.to.accelerations,
                _ => match self.find(self.from.state.time + node * self.length())? {
                    found if found.is_singular => continue,
                    found => self.motion.sample(found.kept)?.accelerations,
                },
            };
            known[count] = (node, accelerations);
            count += 1;
        }
        let known = &mut known[..count];
        let all = through::<M>(known, fraction);
        let away = |known: &(f64, M::Q)| -(known.0 - fraction).abs();
        known.sort_by(|a, b| away(a).total_cmp(&away(b)));
        let fewer = through::<M>(&known[..count - 1], fraction);
        Ok((all, self.motion.measures().size(&M::Q::from_fn(|i| all[i] - fewer[i]))))
    }

    fn find(&mut self, time: f64) -> Result<Inside<M>, Failure> {
        if time == self.to.state.time {
            return Ok(Inside { kept: self.to.state, interpolated: self.to.state, is_singular: false });
        }
        let fraction = (time - self.from.state.time) / self.length();
        let mut kept = self.method.inside(self.motion, self.from, self.to, fraction)?;
        kept.time = time;
        let interpolated = kept;
        match self.motion.keep(&mut kept) {
            Ok(()) => Ok(Inside { kept, interpolated, is_singular: self.motion.is_at_singularity() }),
            Err(Failure { what: What::SingularPosition { .. }, .. }) => {
                Ok(Inside { kept: interpolated, interpolated, is_singular: true })
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
}

/// The polynomial through accelerations at some fractions of a step, at another one.
///
/// Berrut and Trefethen, Barycentric Lagrange Interpolation, SIAM Review 46 (2004), (3.3).
fn through<M: Mechanism>(known: &[(f64, M::Q)], fraction: f64) -> M::Q {
    let weight = |(k, (node, _)): (usize, &(f64, M::Q))| {
        let others = known.iter().enumerate().filter(|(j, _)| *j != k);
        1.0 / (fraction - node) / others.map(|(_, (other, _))| node - other).product::<f64>()
    };
    let weights: f64 = known.iter().enumerate().map(weight).sum();
    let part = |i: usize| known.iter().enumerate().map(|(k, known)| weight((k, known)) * known.1[i]).sum::<f64>();
    M::Q::from_fn(|i| part(i) / weights)
}
