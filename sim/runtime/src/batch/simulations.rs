//! Many simulations, several side by side.
//!
//! Each simulation decides on its own steps: their lengths, which are taken, events, singular positions. Only attempts
//! are made side by side, by the same operations in the same order, so each motion has the bits that it has alone. Where
//! an attempt fails in a lane, or a motion is of a kind that lanes do not have, its own simulation makes the attempt.

use super::LANES;
use super::lanes::{InLanes, Numbers, gather, lane_of, measures, mechanism, sample, sample_of};
use crate::integrate::{ExplicitRungeKutta, Reached, Target, attempt_plainly, tableau};
use crate::motion::field::Field;
use crate::motion::plain::Plain;
use crate::run::{Attempted, Simulation};
use crate::state::failure::Failure;
use crate::state::settings::{Stabilisation, Tolerance};
use crate::state::trajectory::Sample;
use sim_kernel::{Lanes, Mechanism, Vectors, Work};

/// Advances many simulations of one mechanism to a time, each with its own parameters, inputs, state and steps: each has
/// the same bits as after [`Simulation::advance_to`], but eight motions are computed at once, with the widest vector
/// instructions that the processor has.
///
/// Motions by an explicit method with projection are computed side by side, of mechanisms with up to 16 coordinates and
/// constraints, without redundant ones or generalised speeds; others one after the other.
///
/// Gives the failures with the indices of their simulations, which end there.
#[must_use = "these simulations have failed"]
pub fn advance_each<M: Mechanism>(simulations: &mut [Simulation<M>], time: f64) -> Vec<(usize, Failure)> {
    let mut failures = Vec::new();
    for (block, simulations) in simulations.chunks_mut(LANES).enumerate() {
        let failed = Block { simulations, side_by_side: None, failures: Vec::new() }.advance_to(time);
        failures.extend(failed.into_iter().map(|(lane, failure)| (block * LANES + lane, failure)));
    }
    failures
}

/// The largest n + m of motions side by side: those of larger mechanisms would need megabytes of stack without
/// optimisation, and gain little.
const MOST_ROWS: usize = 16;

/// As many simulations as there are lanes, or fewer.
struct Block<'a, M: Mechanism> {
    simulations: &'a mut [Simulation<M>],
    side_by_side: Option<SideBySide<M>>,
    failures: Vec<(usize, Failure)>,
}

/// Where each lane goes next; `None` for those that have arrived.
type Targets = [Option<Target>; LANES];

impl<M: Mechanism> Block<'_, M> {
    fn advance_to(mut self, time: f64) -> Vec<(usize, Failure)> {
        loop {
            let targets = self.aim(time);
            let Some(first) = targets.iter().position(Option::is_some) else { return self.failures };
            // Lanes without a motion repeat one that has.
            let lanes = std::array::from_fn(|lane| if targets[lane].is_some() { lane } else { first });
            let reached = self.attempt(&lanes, &targets);
            for lane in (0..LANES).filter(|lane| targets[*lane].is_some()) {
                let simulation = &mut self.simulations[lane];
                let judged = match (&reached, &self.side_by_side) {
                    (Some(reached), Some(made)) => made.give(reached, lane, simulation),
                    _ => simulation.attempt(),
                };
                judged.unwrap_or_else(|failure| self.failures.push((lane, failure)));
            }
        }
    }

    fn aim(&mut self, time: f64) -> Targets {
        std::array::from_fn(|lane| {
            let has_failed = self.failures.iter().any(|(failed, _)| *failed == lane);
            let simulation = self.simulations.get_mut(lane).filter(|_| !has_failed)?;
            simulation.aim(time).unwrap_or_else(|failure| {
                self.failures.push((lane, failure));
                None
            })
        })
    }

    /// The attempts of all lanes; `None` if they are not made side by side, or one has failed.
    fn attempt(&mut self, lanes: &[usize; LANES], targets: &Targets) -> Option<Reached<InLanes<M>, Numbers>> {
        let motions = lanes.map(|lane| (lane, self.simulations[lane].changes()));
        if self.side_by_side.as_ref().is_none_or(|made| made.motions != motions) {
            self.side_by_side = Some(SideBySide::new(motions, lanes.map(|lane| &self.simulations[lane])));
        }
        let (plain, method) = self.side_by_side.as_mut()?.motion.as_mut()?;
        let mut starts = Vec::with_capacity(LANES);
        for lane in lanes {
            starts.push(self.simulations[*lane].start_of_step()?.clone());
        }
        let longest = lanes.map(|lane| self.simulations[lane].motion().longest());
        plain.longest.set(gather(|lane| &longest[lane]));
        let from = sample::<M>(plain.mechanism(), &starts);
        let time = Lanes::from_fn(|lane| targets[lanes[lane]].map_or(f64::NAN, |target| target.time));
        let tolerance = targets[lanes[0]].and_then(|target| target.tolerance);
        let is_alike = |target: &Target| target.tolerance.is_some() == tolerance.is_some();
        if !targets.iter().flatten().all(is_alike) {
            return None;
        }
        Vectors::widest().run(Attempts::<M> { plain, method, from: &from, time, tolerance }).ok()
    }
}

/// Equations of motion in all lanes, and their method.
type Motions<M> = (Plain<InLanes<M>, Numbers>, ExplicitRungeKutta<InLanes<M>, Numbers>);

/// Motions side by side.
struct SideBySide<M: Mechanism> {
    /// The simulation in each lane, and how often it had been changed.
    motions: [(usize, u64); LANES],
    /// None if lanes do not have motions of this kind.
    motion: Option<Motions<M>>,
}

impl<M: Mechanism> SideBySide<M> {
    fn new(motions: [(usize, u64); LANES], simulations: [&Simulation<M>; LANES]) -> SideBySide<M> {
        SideBySide { motions, motion: side_by_side(simulations) }
    }

    /// Gives a lane's attempt to its simulation.
    fn give(
        &self,
        reached: &Reached<InLanes<M>, Numbers>,
        lane: usize,
        simulation: &mut Simulation<M>,
    ) -> Result<(), Failure> {
        let Some((plain, method)) = &self.motion else { return simulation.attempt() };
        let in_lane = |numbers: Numbers| numbers.lane(lane);
        let attempted = Attempted {
            error: reached.error(in_lane),
            to: sample_of::<M>(&reached.to, lane, simulation.mechanism().inputs()),
            closeness: in_lane(reached.closeness),
            longest: lane_of(&plain.longest.get(), lane),
            evaluations: reached.evaluations,
        };
        simulation.take_attempt(attempted, method, in_lane)
    }
}

/// The motions of simulations side by side; `None` if lanes do not have motions of this kind.
fn side_by_side<M: Mechanism>(simulations: [&Simulation<M>; LANES]) -> Option<Motions<M>> {
    let settings = simulations[0].settings();
    let is_plain = |simulation: &&Simulation<M>| {
        let other = simulation.settings();
        let is_alike = other.method == settings.method && other.stepping == settings.stepping;
        is_alike && other.stabilisation == Stabilisation::Projection && simulation.mechanism().rows_left().is_none()
    };
    let is_small = simulations[0].mechanism().n() + simulations[0].mechanism().m() <= MOST_ROWS;
    let tableau = tableau(settings.method).filter(|_| is_small && simulations.iter().all(is_plain))?;
    let mechanism = mechanism(simulations.map(Simulation::mechanism))?;
    let measures = measures(simulations.map(|simulation| simulation.motion().measures()))?;
    let method = ExplicitRungeKutta::new(&mechanism, tableau);
    Some((Plain::new(mechanism, measures), method))
}

/// Attempts in all lanes.
struct Attempts<'a, M: Mechanism> {
    plain: &'a Plain<InLanes<M>, Numbers>,
    method: &'a mut ExplicitRungeKutta<InLanes<M>, Numbers>,
    from: &'a Sample<InLanes<M>, Numbers>,
    time: Numbers,
    tolerance: Option<Tolerance>,
}

impl<M: Mechanism> Work for Attempts<'_, M> {
    type Output = Result<Reached<InLanes<M>, Numbers>, Failure>;

    #[inline(always)]
    fn run<const AT_ONCE: usize>(self) -> Self::Output {
        attempt_plainly(self.plain, self.method, self.from, self.time, self.tolerance.as_ref())
    }
}
