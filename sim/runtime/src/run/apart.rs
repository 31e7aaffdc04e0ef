//! How far a run is from one with a smaller tolerance: equal steps do not know their error, and steps with a tolerance know only
//! their own, which unstable motions make grow.

use super::{Run, run_while};
use crate::motion::measures::Measures;
use crate::start::assemble::Start;
use crate::state::failure::Failure;
use crate::state::settings::{Method, Rows, Settings, Stabilisation, Stepping, Tolerance};
use crate::state::trajectory::Sample;
use sim_kernel::Mechanism;

/// The tolerance of the run beside one of equal steps.
const OF_EQUAL_STEPS: f64 = 1e-11;
/// The tolerance of the run beside one with a tolerance, as a part of that one's; that of the least one, and what the run beside
/// it has in its place.
const SMALLER: f64 = 1e-2;
const LEAST: f64 = 1e-14;
const LARGER: f64 = 10.0;
/// How far two runs may be apart, as a part of the extent of a coordinate.
const DOUBTFUL: f64 = 1e-3;
/// The other run makes so many steps at most, or so many times as many as this one if these are more: RADAU5 makes 3.2 times as many.
const STEPS: usize = 10_000;
const TIMES: usize = 4;
/// It is compared at so many rows, or at a part of them where they are many more.
const MANY_ROWS: usize = 10_000;
const MOST_ROWS: usize = 100_000;
/// Rows so near to events, as a part of their time, are not compared: coordinates may jump there.
const AT_EVENT: f64 = 1e-9;
/// What a coordinate moves by less than this part of what counts as 1 is compared with that part: it may be rounding.
const SMALL: f64 = 1e-6;
/// Unless the other run shows by its tolerance that it moves, by so many times this, and this run is off by no more than it moves.
const SHOWN: f64 = 1e2;

/// Where a run is farthest from one with a smaller tolerance.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Apart {
    /// The other's tolerance.
    pub tolerance: f64,
    /// The coordinate, by index.
    pub coordinate: usize,
    /// By how much.
    pub by: f64,
    /// How far the coordinate goes from where it starts.
    pub extent: f64,
    /// When, in seconds.
    pub time: f64,
    /// When any coordinate has first been off, in seconds.
    pub since: f64,
}

/// As [`run_while`], and compares the run with one with a smaller tolerance: [`Run::apart`] says where a coordinate is off by more
/// than a thousandth of its way. Where the other run fails, or takes much longer, nothing is known ([`Run::compared`]).
///
/// # Errors
/// As [`run_while`].
#[inline(never)]
pub fn run_compared<M: Mechanism>(
    mechanism: M,
    start: &Start<M>,
    settings: &Settings,
    goes_on: &mut dyn FnMut(f64) -> bool,
) -> Result<Run<M>, Failure> {
    let mut run = run_while(mechanism, start, settings, goes_on)?;
    if run.trajectory.failure.is_some() {
        return Ok(run);
    }
    let (tolerance, rows) = (other_tolerance(settings.stepping), other_rows(settings));
    let method = if settings.method == Method::Radau5 { Method::Radau5 } else { Method::Dop853 };
    let stepping = Stepping::Adaptive(tolerance);
    let settings = Settings { method, stepping, rows, stabilisation: Stabilisation::Projection, ..*settings };
    let mut left = STEPS.max(TIMES * run.steps.accepted as usize);
    let other = run_while(run.mechanism.clone(), start, &settings, &mut |time| {
        left = left.saturating_sub(1);
        left > 0 && goes_on(time)
    });
    if let Some(other) = other.ok().filter(|other| other.trajectory.failure.is_none()) {
        run.compared = Some(tolerance.relative);
        run.apart = run.apart_from(&other, tolerance.relative);
    }
    Ok(run)
}

/// The tolerance to compare with.
fn other_tolerance(stepping: Stepping) -> Tolerance {
    let Stepping::Adaptive(tolerance) = stepping else { return Tolerance::new(OF_EQUAL_STEPS) };
    let part = match tolerance.relative > LEAST {
        true => (LEAST / tolerance.relative).max(SMALLER),
        false => LARGER,
    };
    Tolerance { relative: part * tolerance.relative, absolute: part * tolerance.absolute }
}

/// Rows at the same times, or at some of them: the second run takes little memory.
fn other_rows(settings: &Settings) -> Rows {
    match (settings.rows, settings.stepping) {
        (Rows::Even(many), _) | (Rows::Steps, Stepping::Equal(many)) if many > MOST_ROWS => {
            let parts = (many.div_ceil(MANY_ROWS)..=many).find(|parts| many.is_multiple_of(*parts));
            Rows::Even(many / parts.unwrap_or(many))
        }
        (Rows::Steps, Stepping::Equal(many)) => Rows::Even(many),
        (rows, _) => rows,
    }
}

impl<M: Mechanism> Run<M> {
    /// Where it is off, at times that both have.
    fn apart_from(&self, other: &Run<M>, tolerance: f64) -> Option<Apart> {
        let others = &other.trajectory.samples;
        let start = &others.first()?.state;
        let measures = Measures::at(&self.mechanism, start.time, &start.positions);
        let extent = |j: usize| {
            let way = |other: &Sample<M>| (other.state.positions[j] - start.positions[j]).abs();
            others.iter().map(way).fold(0.0, f64::max)
        };
        let extents: Vec<f64> = (0..self.mechanism.n()).map(extent).collect();
        // By how many times what is doubtful.
        let doubt = |apart: &Apart| {
            let (j, scale) = (apart.coordinate, measures.coordinates()[apart.coordinate]);
            let is_set_out = start.positions[j] != 0.0 || start.speeds[j] != 0.0;
            let moves = is_set_out && apart.extent > SHOWN * tolerance * scale && apart.by < apart.extent;
            apart.by / (DOUBTFUL * if moves { apart.extent } else { apart.extent.max(SMALL * scale) })
        };
        let pairs = self.trajectory.samples.iter().filter_map(|one| Some((one, self.counterpart(one, others)?)));
        let all = pairs.flat_map(|(one, other)| {
            let (extents, time) = (&extents, one.state.time);
            (0..extents.len()).map(move |coordinate| Apart {
                tolerance,
                coordinate,
                by: (one.state.positions[coordinate] - other.state.positions[coordinate]).abs(),
                extent: extents[coordinate],
                time,
                since: time,
            })
        });
        let mut doubtful = all.map(|apart| (doubt(&apart), apart)).filter(|(doubt, _)| *doubt > 1.0).peekable();
        let since = doubtful.peek()?.1.time;
        let (_, worst) = doubtful.max_by(|a, b| a.0.total_cmp(&b.0))?;
        Some(Apart { since, ..worst })
    }

    /// The sample of another run at the time of this one, unless that is the time of an event.
    pub(crate) fn counterpart<'o>(&self, one: &Sample<M>, others: &'o [Sample<M>]) -> Option<&'o Sample<M>> {
        let time = one.state.time;
        let [rounding, at_event] = [4.0 * f64::EPSILON, AT_EVENT].map(|part| part * time.abs());
        let event = self.events.partition_point(|event| event.state.time < time - at_event);
        let is_at_event = self.events.get(event).is_some_and(|event| event.state.time <= time + at_event);
        let at = others.partition_point(|other| other.state.time < time - rounding);
        others.get(at).filter(|other| !is_at_event && other.state.time <= time + rounding)
    }
}
