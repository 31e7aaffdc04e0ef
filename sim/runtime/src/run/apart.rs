//! How far a run of equal steps is from one whose steps meet a tolerance: equal steps do not know their own error.

use super::{Run, run_while};
use crate::motion::measures::Measures;
use crate::start::assemble::Start;
use crate::state::failure::Failure;
use crate::state::settings::{Method, Rows, Settings, Stabilisation, Stepping, Tolerance};
use crate::state::trajectory::Sample;
use sim_kernel::Mechanism;

/// The tolerance of the other run, and how far it may be from this one, as a part of the extent of a coordinate.
const RELATIVE: f64 = 1e-9;
const DOUBTFUL: f64 = 1e-3;
/// The other run makes so many steps at most, or as many as this one if these are more.
const STEPS: usize = 10_000;
/// It is compared at so many rows at most.
const MOST_ROWS: usize = 10_000;
/// A motion within this part of what counts as 1 has no extent.
const STILL: f64 = 1e-6;

/// Where two runs are farthest apart.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Apart {
    /// The coordinate, by index.
    pub coordinate: usize,
    /// By how much.
    pub by: f64,
    /// How far the coordinate goes from where it starts.
    pub extent: f64,
    /// When, in seconds.
    pub time: f64,
}

/// As [`run_while`], and compares a run of equal steps with one whose steps meet a tolerance: [`Run::apart`] says where it is off by
/// more than a thousandth of the way of a coordinate. Where the other run fails, or takes much longer, nothing is known.
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
    let (Stepping::Equal(steps), None) = (settings.stepping, &run.trajectory.failure) else { return Ok(run) };
    let method = if settings.method == Method::Radau5 { Method::Radau5 } else { Method::Dop853 };
    let stepping = Stepping::Adaptive(Tolerance::new(RELATIVE));
    let rows = fewer(settings.rows);
    let settings = Settings { method, stepping, rows, stabilisation: Stabilisation::Projection, ..*settings };
    let mut left = STEPS.max(steps);
    let other = run_while(run.mechanism.clone(), start, &settings, &mut |time| {
        left = left.saturating_sub(1);
        left > 0 && goes_on(time)
    });
    run.apart = other.ok().filter(|other| other.trajectory.failure.is_none()).and_then(|other| run.apart_from(&other));
    Ok(run)
}

/// Rows at some of the same times: the second run takes little memory.
fn fewer(rows: Rows) -> Rows {
    match rows {
        Rows::Even(many) if many > MOST_ROWS => {
            let parts = (many.div_ceil(MOST_ROWS)..=many).find(|parts| many.is_multiple_of(*parts));
            Rows::Even(many / parts.unwrap_or(many))
        }
        rows => rows,
    }
}

impl<M: Mechanism> Run<M> {
    /// Where it is off, at times that both have.
    fn apart_from(&self, other: &Run<M>) -> Option<Apart> {
        let (samples, others) = (&self.trajectory.samples, &other.trajectory.samples);
        let start = &others.first()?.state;
        let measures = Measures::at(&self.mechanism, start.time, &start.positions);
        let extents = |j: usize| {
            let way = |sample: &Sample<M>| (sample.state.positions[j] - start.positions[j]).abs();
            others.iter().map(way).fold(STILL * measures.coordinates()[j], f64::max)
        };
        let extents: Vec<f64> = (0..self.mechanism.n()).map(extents).collect();
        let same = |one: &Sample<M>| {
            let at = others.partition_point(|other| other.state.time < one.state.time);
            others.get(at).filter(|other| other.state.time == one.state.time)
        };
        let apart = samples.iter().filter_map(|one| Some((one, same(one)?))).flat_map(|(one, other)| {
            (0..extents.len()).map(|coordinate| Apart {
                coordinate,
                by: (one.state.positions[coordinate] - other.state.positions[coordinate]).abs(),
                extent: extents[coordinate],
                time: one.state.time,
            })
        });
        apart
            .filter(|apart| apart.by > DOUBTFUL * apart.extent)
            .max_by(|a, b| (a.by / a.extent).total_cmp(&(b.by / b.extent)))
    }
}
