//! Accelerations beside a singular position.
//!
//! These accelerations are those of the polynomial nearest to the values on the branch on both sides, weighted by the
//! fourth power of s, where it is smooth and the equations of motion give nothing better. At a cusp, or where the
//! motion comes to rest, the run ends with a message.

use crate::motion::Motion;
use crate::motion::ahead::foretold;
use crate::motion::project::project;
use crate::motion::singular::{BESIDE, Followed, weakest_constraint};
use crate::numerics::arrays::inner;
use crate::numerics::nearest::{Known, MOST_KNOWN, nearest_polynomial};
use crate::state::failure::Failure;
use crate::state::trajectory::{Sample, State};
use sim_kernel::{Array, Mechanism};
use std::f64::consts::PI;

/// The distance to look to either side, in the scales of the coordinates.
const REACH: f64 = 0.25;
/// A node that projection moves by more than this fraction of REACH may be on another branch.
const ASTRAY: f64 = 0.1;
/// The accuracy of smooth accelerations from their neighbourhood, relative to their size or that of centripetal ones:
/// near a dead point, which is not a crossing, they are not smooth.
const SMOOTH: f64 = 1e-6;

/// The neighbourhood of a state.
struct Around<'a, M: Mechanism> {
    motion: &'a Motion<M>,
    followed: Followed<'a, M>,
    state: State<M>,
    /// The accelerations that predict it.
    accelerations: M::Q,
    /// Its extent to either side, in seconds.
    reach: f64,
    /// The largest squared length in it of the independent part of each row of C_q D.
    longest: M::L,
}

impl<'a, M: Mechanism> Around<'a, M> {
    /// The neighbourhood of a state up to a distance in seconds, predicted from these accelerations.
    fn new(motion: &'a Motion<M>, state: State<M>, accelerations: M::Q, reach: f64) -> Around<'a, M> {
        let followed = Followed::at(motion, &state);
        let squares = |ahead: f64| {
            let parts = followed.parts(state.time + ahead, &foretold(&state, &accelerations, ahead));
            motion.longest().like(|row| inner(&parts[row], &parts[row]))
        };
        let [before, here, after] = [-reach, 0.0, reach].map(squares);
        let longest = before.like(|row| before[row].max(here[row]).max(after[row]));
        Around { motion, followed, state, accelerations, reach, longest }
    }

    /// The smallest sine of the angle between a row of C_q D and those before it; rows count relative to the longest in the
    /// neighbourhood.
    fn least_sine(&self, state: &State<M>) -> f64 {
        let parts = self.followed.parts(state.time, &state.positions);
        let sine = |row: usize| (inner(&parts[row], &parts[row]) / self.longest[row]).sqrt();
        (0..self.longest.len()).filter(|row| self.longest[*row] > 0.0).map(sine).fold(f64::INFINITY, f64::min)
    }

    /// The polynomial nearest to the accelerations in the neighbourhood, with its approximate error. Along the branch
    /// accelerations are smooth, and more accurate farther from the singular position. The states need not be those of
    /// the motion, but lie on its branch.
    fn extrapolated(&self) -> (M::Q, f64) {
        let (state, measures) = (&self.state, self.motion.measures());
        let none = |_| Known { fraction: 0.0, weight: 0.0, values: self.accelerations.clone() };
        let mut known: [Known<M::Q>; MOST_KNOWN] = std::array::from_fn(none);
        let mut count = 0;
        for node in 0..MOST_KNOWN {
            // Chebyshev's, denser towards the ends.
            let fraction = ((node as f64 + 0.5) / MOST_KNOWN as f64 * PI).cos();
            let ahead = fraction * self.reach;
            let guess = foretold(state, &self.accelerations, ahead);
            let speeds = state.speeds.like(|i| state.speeds[i] + ahead * self.accelerations[i]);
            let mut there = State { time: state.time + ahead, positions: guess.clone(), speeds, ..*state };
            let kept = project(self.motion.mechanism(), measures, &mut there);
            let astray = there.positions.like(|i| there.positions[i] - guess[i]);
            if self.motion.size(&astray) > ASTRAY * REACH {
                continue;
            }
            let Ok(sample) = kept.and_then(|()| self.motion.sample(there.clone())) else { continue };
            // Rounding is amplified by the inverse square of the sine.
            let weight = self.least_sine(&there).powi(4);
            known[count] = Known { fraction, weight, values: sample.accelerations };
            count += 1;
        }
        nearest_polynomial(&known[..count], 0.0, self.accelerations.like(|_| 0.0), |change: &M::Q| {
            self.motion.size(change)
        })
    }
}

/// The time over which smooth accelerations may be extrapolated, in seconds. `None` if nothing moves, or if states are
/// not projected.
fn natural_reach<M: Mechanism>(motion: &Motion<M>, state: &State<M>, accelerations: &M::Q) -> Option<f64> {
    let [speed, acceleration] = [&state.speeds, accelerations].map(|rates| motion.size(rates));
    let reach = (REACH / speed).min((REACH / acceleration).sqrt());
    (motion.mechanism().m() > 0 && motion.keeps_constraints() && reach.is_finite()).then_some(reach)
}

/// Accelerations at a state beside a singular position that are more accurate than those of the equations of motion, if
/// there are any. `rough` ones predict the neighbourhood; over `resolved` seconds to both sides the motion is known to
/// be smooth.
pub(super) fn better_accelerations<M: Mechanism>(
    motion: &Motion<M>,
    state: State<M>,
    direct: Option<M::Q>,
    rough: M::Q,
    resolved: f64,
) -> Option<M::Q> {
    let size = |rates: &M::Q| motion.size(rates);
    let reach = natural_reach(motion, &state, &rough)?;
    let mut best = (rough.clone(), f64::INFINITY);
    let scale = size(&rough) + size(&state.speeds).powi(2);
    for reach in [reach.max(resolved), resolved].into_iter().filter(|reach| *reach > 0.0) {
        let found = Around::new(motion, state.clone(), rough.clone(), reach).extrapolated();
        if found.1 < best.1 && found.0.iter().all(|acceleration| acceleration.is_finite()) {
            best = found;
        }
        if best.1 <= SMOOTH * scale {
            break;
        }
    }
    let (found, known_to) = best;
    let is_better = |direct: M::Q| {
        let off = size(&direct.like(|i| direct[i] - found[i]));
        known_to <= SMOOTH * scale && known_to < off
    };
    (known_to.is_finite() && direct.is_none_or(is_better)).then_some(found)
}

/// The first sample of a motion; beside a singular position its accelerations are more accurate than those of the
/// equations of motion. The motion records the lengths of the rows of C_q.
///
/// # Errors
/// As the right-hand side.
pub(crate) fn first_sample<M: Mechanism>(motion: &Motion<M>, state: State<M>) -> Result<Sample<M>, Failure> {
    let direct = motion.sample(state.clone())?;
    let note = |state: State<M>| {
        weakest_constraint(motion, &state);
    };
    note(state.clone());
    let Some(reach) = natural_reach(motion, &state, &direct.accelerations) else { return Ok(direct) };
    let sine = Around::new(motion, state.clone(), direct.accelerations.clone(), reach).least_sine(&state);
    if sine >= BESIDE {
        return Ok(direct);
    }
    for ahead in [-reach, reach] {
        let positions = foretold(&state, &direct.accelerations, ahead);
        note(State { time: state.time + ahead, positions, ..state.clone() });
    }
    let known = direct.accelerations.clone();
    let better = better_accelerations(motion, state, Some(known.clone()), known, 0.0);
    Ok(match better {
        Some(accelerations) => Sample { accelerations, ..direct },
        None => direct,
    })
}
