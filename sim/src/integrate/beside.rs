//! Accelerations beside a singular position.

use crate::failure::Failure;
use crate::motion::Motion;
use crate::nearest::{Known, MOST_KNOWN, nearest_polynomial};
use crate::project::{inner, project};
use crate::singular::{BESIDE, Followed, foretold, weakest_constraint};
use crate::trajectory::{Sample, State};
use sim_kernel::{Array, Mechanism};
use std::f64::consts::PI;

/// How far is looked to both sides, in what coordinates are measured by.
const REACH: f64 = 0.25;

/// What projection moves by more than this part of that may lie on another branch.
const ASTRAY: f64 = 0.1;

/// What lies to both sides of a state, as far as is looked.
struct Around<'a, 'm, M: Mechanism> {
    motion: &'a Motion<'m, M>,
    followed: Followed<'a, 'm, M>,
    /// The state and the accelerations that foretell what lies around it.
    centre: (State<M>, M::Q),
    /// In seconds.
    reach: f64,
    /// The squares of the longest that the independent part of each row of C_q D is there.
    longest: M::L,
}

impl<'a, 'm, M: Mechanism> Around<'a, 'm, M> {
    /// Nothing where nothing moves.
    fn new(motion: &'a Motion<'m, M>, state: State<M>, accelerations: M::Q) -> Option<Around<'a, 'm, M>> {
        let [speed, acceleration] = [state.speeds, accelerations].map(|rates| motion.measures().size(&rates));
        let reach = (REACH / speed).min((REACH / acceleration).sqrt());
        if M::L::LEN == 0 || !reach.is_finite() {
            return None;
        }
        let followed = Followed::at(motion, &state);
        let squares = |ahead: f64| {
            let parts = followed.parts(state.time + ahead, &foretold(&state, &accelerations, ahead));
            M::L::from_fn(|row| inner(&parts[row], &parts[row]))
        };
        let [before, here, after] = [-reach, 0.0, reach].map(squares);
        let longest = M::L::from_fn(|row| before[row].max(here[row]).max(after[row]));
        Some(Around { motion, followed, centre: (state, accelerations), reach, longest })
    }

    /// The smallest sine of the angle between a row of C_q D and those before it; rows count beside the longest around.
    fn least_sine(&self, state: &State<M>) -> f64 {
        let parts = self.followed.parts(state.time, &state.positions);
        let sine = |row: usize| (inner(&parts[row], &parts[row]) / self.longest[row]).sqrt();
        (0..M::L::LEN).map(sine).filter(|sine| *sine > 0.0).fold(f64::INFINITY, f64::min)
    }

    /// The accelerations at the state, by the polynomial nearest to those around it: along the branch they are smooth, and known
    /// the better the farther from the singular position. With it about how well that knows them. States to both sides need not
    /// be those of the motion, but lie on its branch.
    fn accelerations(&self) -> (M::Q, f64) {
        let (state, accelerations) = &self.centre;
        let mut known = [Known { fraction: 0.0, weight: 0.0, values: *accelerations }; MOST_KNOWN];
        let mut count = 0;
        for node in 0..MOST_KNOWN {
            // Chebyshev's, denser towards the ends.
            let fraction = ((node as f64 + 0.5) / MOST_KNOWN as f64 * PI).cos();
            let ahead = fraction * self.reach;
            let mut there = State {
                time: state.time + ahead,
                positions: foretold(state, accelerations, ahead),
                speeds: M::Q::from_fn(|i| state.speeds[i] + ahead * accelerations[i]),
                ..*state
            };
            let guess = there.positions;
            let kept = project(self.motion.mechanism(), self.motion.measures(), &mut there);
            let moved = M::Q::from_fn(|i| there.positions[i] - guess[i]);
            if self.motion.measures().size(&moved) > ASTRAY * REACH {
                continue;
            }
            let Ok(sample) = kept.and_then(|()| self.motion.sample(there)) else { continue };
            // Rounding is amplified by the inverse square of the sine.
            known[count] = Known { fraction, weight: self.least_sine(&there).powi(4), values: sample.accelerations };
            count += 1;
        }
        nearest_polynomial(&known[..count], 0.0, |change: &M::Q| self.motion.measures().size(change))
    }
}

/// The accelerations that what lies around a state beside a singular position makes likely, where these are known better than
/// those that the equations of motion give, if they do. `rough` ones foretell what lies around.
pub(super) fn better_known<M: Mechanism>(
    motion: &Motion<M>,
    state: State<M>,
    rough: M::Q,
    direct: Option<M::Q>,
) -> Option<M::Q> {
    let (accelerations, known_to) = Around::new(motion, state, rough)?.accelerations();
    let off = |direct: M::Q| motion.measures().size(&M::Q::from_fn(|i| direct[i] - accelerations[i]));
    direct.is_none_or(|direct| off(direct) > known_to).then_some(accelerations)
}

/// The sample that a motion starts with: where that is beside a singular position, with the accelerations that are known better.
/// The motion then takes note of how long rows of C_q are around it.
///
/// # Errors
/// As the right-hand side.
pub(crate) fn first_sample<M: Mechanism>(motion: &Motion<M>, state: State<M>) -> Result<Sample<M>, Failure> {
    let direct = motion.sample(state)?;
    let is_beside = |around: &Around<M>| around.least_sine(&state) < BESIDE;
    let Some(around) = Around::new(motion, state, direct.accelerations).filter(is_beside) else { return Ok(direct) };
    for ahead in [-around.reach, around.reach] {
        let positions = foretold(&state, &direct.accelerations, ahead);
        weakest_constraint(motion, &State { time: state.time + ahead, positions, ..state });
    }
    let better = better_known(motion, state, direct.accelerations, Some(direct.accelerations));
    Ok(Sample { accelerations: better.unwrap_or(direct.accelerations), ..direct })
}
