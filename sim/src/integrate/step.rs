//! A step that was made, and what is inside it.

use super::method::Advance;
use crate::failure::{Failure, What};
use crate::motion::Motion;
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
    pub(super) method: &'s mut dyn Advance<M>,
}

/// Accelerations beside a singular position are known by those at the ends of so many parts of a step.
const INTERVALS: usize = 10;

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
    /// that is known no better. In it reactions, which have a pole, and power are those of the nearer end.
    ///
    /// # Errors
    /// As the projection and the right-hand side.
    pub fn sample(&mut self, time: f64) -> Result<Sample<M>, Failure> {
        let found = self.find(time)?;
        if !found.is_beside {
            return self.motion.sample(found.kept);
        }
        let fraction = (time - self.from.state.time) / self.length();
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
        let nearer = if fraction < 0.5 { self.from } else { self.to };
        Ok(Sample { state: found.interpolated, accelerations, ..*nearer })
    }

    /// The accelerations at a fraction of this step that is at a singular position, by the polynomial nearest to those at
    /// regular positions on both sides of it: along the motion they are smooth, and known the better the farther away. With it
    /// about how well that knows them.
    fn accelerations_across(&mut self, fraction: f64) -> Result<(M::Q, f64), Failure> {
        let mut known = [Known { fraction: 0.0, weight: 0.0, accelerations: self.from.accelerations }; INTERVALS + 1];
        let mut count = 0;
        for k in 0..=INTERVALS {
            let fraction = k as f64 / INTERVALS as f64;
            let (state, accelerations) = match k {
                0 => (self.from.state, self.from.accelerations),
                INTERVALS => (self.to.state, self.to.accelerations),
                _ => match self.find(self.from.state.time + fraction * self.length())? {
                    found if found.is_singular => continue,
                    found => (found.kept, self.motion.sample(found.kept)?.accelerations),
                },
            };
            let sine = weakest_constraint(self.motion, &state).map_or(1.0, |(_, sine)| sine);
            known[count] = Known { fraction, weight: sine.powi(4), accelerations };
            count += 1;
        }
        let size = |change: &M::Q| self.motion.measures().size(change);
        Ok(nearest_polynomial::<M>(&known[..count], fraction, size))
    }

    fn find(&mut self, time: f64) -> Result<Inside<M>, Failure> {
        if time == self.to.state.time {
            let end = self.to.state;
            return Ok(Inside { kept: end, interpolated: end, is_singular: false, is_beside: false });
        }
        let fraction = (time - self.from.state.time) / self.length();
        let mut kept = self.method.inside(self.motion, self.from, self.to, fraction)?;
        kept.time = time;
        let interpolated = kept;
        match self.motion.keep(&mut kept) {
            Ok(()) => {
                let (is_singular, is_beside) = (self.motion.is_at_singularity(), self.motion.is_beside_singularity());
                Ok(Inside { kept, interpolated, is_singular, is_beside })
            }
            Err(Failure { what: What::SingularPosition { .. }, .. }) => {
                Ok(Inside { kept: interpolated, interpolated, is_singular: true, is_beside: true })
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
}

/// Accelerations at a fraction of a step, with the inverse of their variance: rounding is amplified by the inverse square of
/// the sine between constraints.
#[derive(Clone, Copy)]
struct Known<M: Mechanism> {
    fraction: f64,
    weight: f64,
    accelerations: M::Q,
}

/// What the polynomial that is nearest to the known accelerations has at another fraction, with about how far that may be off:
/// it has as many terms as leave the smallest on both sides of where they end.
///
/// Forsythe, Journal of the Society for Industrial and Applied Mathematics 5 (1957), pp. 74-88: polynomials that are orthogonal
/// over the fractions, by recurrence.
fn nearest_polynomial<M: Mechanism>(known: &[Known<M>], at: f64, size: impl Fn(&M::Q) -> f64) -> (M::Q, f64) {
    // The last terms foretell the first that is left out, but for a factor.
    const DOUBT: f64 = 10.0;
    let (mut before, mut here) = ([0.0; INTERVALS + 1], [1.0; INTERVALS + 1]);
    let (mut before_at, mut here_at, mut norm_before) = (0.0, 1.0, f64::INFINITY);
    let (mut sum, mut last) = (M::Q::filled(0.0), f64::INFINITY);
    let mut best = (sum, f64::INFINITY);
    for _ in known {
        let weighed = |f: &dyn Fn(usize) -> f64| -> f64 {
            known.iter().enumerate().map(|(k, known)| known.weight * here[k] * f(k)).sum()
        };
        let norm = weighed(&|k| here[k]);
        let term = M::Q::from_fn(|i| weighed(&|k| known[k].accelerations[i]) / norm * here_at);
        let found = size(&term);
        if found.max(last) < best.1 {
            best = (sum, found.max(last));
        }
        (sum, last) = (M::Q::from_fn(|i| sum[i] + term[i]), found);
        let (middle, share) = (weighed(&|k| known[k].fraction * here[k]) / norm, norm / norm_before);
        let step = |x: f64, here: f64, before: f64| (x - middle) * here - share * before;
        let next = std::array::from_fn(|k| known.get(k).map_or(0.0, |known| step(known.fraction, here[k], before[k])));
        let next_at = step(at, here_at, before_at);
        (before, here, before_at, here_at, norm_before) = (here, next, here_at, next_at, norm);
    }
    (best.0, DOUBT * best.1)
}
