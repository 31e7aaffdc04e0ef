//! The way ahead of a step: whether a singular position lies within it, as predicted from positions, speeds and
//! accelerations, and where steps over it begin and end.

use crate::motion::Motion;
use crate::motion::rows::mixed_pivots;
use crate::motion::singular::{Followed, root_between};
use crate::numerics::arrays::inner;
use crate::state::trajectory::{Sample, State};
use sim_kernel::{Array, Mechanism};

/// A row of C_q this short, relative to its length, vanishes within the error of the prediction.
const FORETOLD: f64 = 0.1;
/// The least distance before a singular position at which the step over it may start, in units of the longest.
const APPROACH: f64 = 0.9;

/// The factors by which a step over a singular position is lengthened if its end would lie beside the next one, or
/// beside this one because that is just ahead: they keep it in wide gaps between stages.
const LONGER: [f64; 4] = [1.25, 2.6, 18.0, 64.0];
/// The fraction of the least sine that is sufficient at its end.
const FAR_ENOUGH: f64 = 0.7;
/// The factor by which an insufficient sine must grow at another end, for the step to be lengthened.
const MUCH_FARTHER: f64 = 2.0;

/// The horizon for predicting the sines at the ends of steps, in steps as long as the last.
const FORESIGHT: f64 = 3.0;
/// The predicted sine below which the way ahead is searched.
const LOOK: f64 = 0.3;
/// The tolerance of the time to a singular position beyond the next step, as predicted from the sine and its rate: a
/// sine that falls to zero does so linearly in the end.
const UNEVEN: f64 = 2.0;

/// How far the way over a singular position is searched, in lengths of the step over it.
const REACH: f64 = 1.5;

/// If a step changes the sine by less than this fraction, the sine tells the distance of the position.
const EVEN: f64 = 0.02;
/// The falling sine below which the way ahead is then searched: a step over a singular position begins at about half of
/// it.
const LOOK_EVENLY: f64 = 0.2;

/// Whether a singular position may lie within the next steps, after two that ended at these sines. Before there have
/// been two, it may.
#[inline]
pub(crate) fn may_be_ahead([before, now]: [f64; 2]) -> bool {
    let falls = before - now;
    match falls.abs() < EVEN * now {
        true => falls > 0.0 && now < LOOK_EVENLY,
        false => before.is_infinite() || now - FORESIGHT * falls < LOOK,
    }
}

/// The placement of steps over singular positions.
#[derive(Clone, Copy, Debug)]
pub(crate) struct Lie {
    /// The longest ordinary step, in seconds.
    pub(crate) longest: f64,
    /// The place in a step that is farthest from its stages.
    pub(crate) gap: f64,
    /// The least sine at the ends of a step over a singular position; the step may be lengthened for it.
    pub(crate) least_sine: f64,
}

impl Lie {
    /// The possible length of a step over a singular position, if the sine falls by this much over the longest ordinary
    /// step.
    fn length(&self, falls: f64) -> f64 {
        let needed = self.least_sine / (APPROACH * self.gap * falls) * self.longest;
        if needed > self.longest { needed } else { self.longest }
    }
}

/// The way ahead within about a step.
#[derive(Clone, Copy, Debug, PartialEq)]
pub(crate) enum Ahead {
    /// No singular position.
    Nothing,
    /// One that a step to this time leads up to, so that the next one leads over it.
    UpTo(f64),
    /// One that a step to this time leads over.
    Over(f64),
}

/// How to continue from a sample so that stages avoid the singular position ahead, if there is one.
pub(crate) fn look_ahead<M: Mechanism>(motion: &Motion<M>, from: &Sample<M>, lie: &Lie) -> Ahead {
    let now = from.state.time;
    match singularity_ahead(motion, from, lie) {
        None => Ahead::Nothing,
        Some((ahead, h)) if ahead <= lie.gap * h => Ahead::Over(now + far_enough(motion, from, lie, ahead / lie.gap)),
        Some((ahead, h)) => Ahead::UpTo(now + ahead - APPROACH * lie.gap * h),
    }
}

/// The length of a step over a singular position whose end is far enough from any.
fn far_enough<M: Mechanism>(motion: &Motion<M>, from: &Sample<M>, lie: &Lie, length: f64) -> f64 {
    let followed = Followed::at(motion, &from.state);
    let least_sine = |longer: f64| {
        let ahead = longer * length;
        let parts = followed.parts(from.state.time + ahead, &foretold(&from.state, &from.accelerations, ahead));
        followed.weakest(&parts).map_or(f64::INFINITY, |(_, sine)| sine)
    };
    let mut best = (1.0, least_sine(1.0));
    for longer in LONGER {
        if best.1 >= FAR_ENOUGH * lie.least_sine {
            break;
        }
        let sine = least_sine(longer);
        if sine >= MUCH_FARTHER * best.1 {
            best = (longer, sine);
        }
    }
    best.0 * length
}

/// The positions at this time after a state, predicted from positions, speeds and accelerations.
pub(crate) fn foretold<M: Mechanism>(state: &State<M>, accelerations: &M::Q, ahead: f64) -> M::Q {
    state.positions.like(|i| state.positions[i] + ahead * (state.speeds[i] + ahead / 2.0 * accelerations[i]))
}

/// The time to the first singular position within about a step, predicted from positions, speeds and accelerations, and
/// the possible length of a step over it.
fn singularity_ahead<M: Mechanism>(motion: &Motion<M>, from: &Sample<M>, lie: &Lie) -> Option<(f64, f64)> {
    let state = &from.state;
    let followed = Followed::at(motion, state);
    let outlook = followed.is_sparse().then(|| Outlook::new(&followed, from, lie));
    let may_reverse = |row: &usize| outlook.as_ref().is_none_or(|outlook| outlook.may_reverse(*row));
    let mut rows = (0..motion.mechanism().m()).filter(may_reverse).peekable();
    rows.peek()?;
    let parts = |ahead: f64| followed.parts_at(state.time + ahead, &foretold(state, &from.accelerations, ahead));
    let (here, next) = (parts(0.0), parts(lie.longest));
    let of_row = |row: usize| {
        let here = here.of(motion.mechanism(), row);
        let along = |part: &M::Q| inner(part, &here);
        let part = |ahead: f64| parts(ahead).of(motion.mechanism(), row);
        let sine = followed.sine(row, &here);
        let falls = sine * (1.0 - along(&next.of(motion.mechanism(), row)) / along(&here));
        if !may_be_ahead([sine + falls, sine]) {
            return None;
        }
        let (slope, h) = (falls / lie.longest, lie.length(falls));
        let reach = REACH * h;
        let root =
            root_between(along(&here), along(&part(reach)), 1e-4, &mut |s| Ok(along(&part(s * reach)))).ok()??;
        let ahead = root * reach;
        let is_even = (1.0 / UNEVEN..=UNEVEN).contains(&(ahead * slope / sine));
        let is_found = followed.sine(row, &part(ahead)) < FORETOLD && (ahead <= lie.longest || is_even);
        is_found.then_some((ahead, h))
    };
    rows.filter_map(of_row).min_by(|(a, _), (b, _)| a.total_cmp(b))
}

/// Pivots between sparse rows here and ahead, which exclude almost all rows that do not reverse, in the time of a few
/// projections.
struct Outlook<'a, M: Mechanism> {
    followed: &'a Followed<'a, M>,
    from: &'a Sample<M>,
    lie: &'a Lie,
    here: M::Entries,
    /// With those here, after the longest ordinary step, and as far as the way over a position in it is searched.
    pivots: [M::L; 3],
    longest: M::L,
}

impl<'a, M: Mechanism> Outlook<'a, M> {
    fn new(followed: &'a Followed<'a, M>, from: &'a Sample<M>, lie: &'a Lie) -> Outlook<'a, M> {
        let here = followed.entries(from.state.time, &from.state.positions);
        let pivots = [0.0, lie.longest, REACH * lie.longest].map(|ahead| pivots(followed, from, &here, ahead));
        Outlook { followed, from, lie, here, pivots, longest: followed.motion.longest() }
    }

    /// Whether a row may reverse on the way that is searched for it.
    fn may_reverse(&self, row: usize) -> bool {
        let [here, next, beyond] = self.pivots.each_ref().map(|pivots| pivots[row]);
        let sine = (here / self.longest[row]).sqrt();
        let falls = sine * (1.0 - next / here);
        let length = self.lie.length(falls);
        let is_clear = match () {
            () if !falls.is_finite() => false,
            () if !may_be_ahead([sine + falls, sine]) => true,
            () if length > self.lie.longest => pivots(self.followed, self.from, &self.here, REACH * length)[row] > 0.0,
            () => beyond > 0.0,
        };
        !is_clear
    }
}

/// The pivots between these rows and those after so many seconds.
fn pivots<M: Mechanism>(followed: &Followed<M>, from: &Sample<M>, here: &M::Entries, ahead: f64) -> M::L {
    let there = foretold(&from.state, &from.accelerations, ahead);
    mixed_pivots(followed.motion.mechanism(), here, &followed.entries(from.state.time + ahead, &there))
}
