//! Checks of whole runs.

use super::scale::scales;
use super::worst::{Worst, largest, relative};
use super::{Check, places};
use crate::model::{AnyMechanism, At};
use crate::motion::measures::Measures;
use crate::motion::typed::Any;
use crate::run::Run;
use crate::state::trajectory::{Sample, State};
use sim_kernel::{Array, Mechanism};

/// The constraints of every sample, in positions and velocities: each relative to the largest of its own terms in any
/// sample. For positions this scale is at least a thousandth of the largest among constraints whose reaction has the
/// same unit, and of a row of C_q times the positions: the height of a slider may be zero, and is then rounding of the
/// others. For velocities it is at least a row of C_q times speeds as large as that of the fastest coordinate: the row of
/// a coordinate that stands still is rounding of the others.
pub fn constraint_residuals<M: Mechanism>(run: &Run<M>) -> Check {
    let samples = &run.trajectory.samples;
    let open: Vec<[Vec<Open>; 2]> = {
        let places = places(samples);
        let scales = scales(&Any(&run.mechanism), &places);
        let speed = largest(places.iter().flat_map(|at| at.speeds.iter().zip(&scales).map(|(u, s)| s * u)));
        let rest = at_rest(&run.mechanism, samples);
        let speed = rest.iter().zip(&scales).fold(speed, |speed, (rest, s)| speed.max(s * rest));
        let with = run.trajectory.with_mechanisms(&run.mechanism).zip(&places);
        with.map(|((mechanism, _), at)| residuals(&Any(&mechanism), at, (&scales, speed), &rest)).collect()
    };
    let mut worst = Worst::<(&str, &str, f64)>::default();
    let mechanism = &run.mechanism;
    let constraints = mechanism.description().constraints;
    let largest_in = |level: usize, row: usize| largest(open.iter().map(|open| open[level][row].size));
    let of_unit = |unit: &str| {
        let rows = (0..mechanism.m()).filter(|row| constraints[*row].unit == unit);
        largest(rows.map(|row| largest_in(0, row)))
    };
    for (level, name) in ["|C|", "|C_q q' + C_t|"].into_iter().enumerate() {
        for row in 0..mechanism.m() {
            let least = if level == 0 { LEAST_PART * of_unit(constraints[row].unit) } else { 0.0 };
            let size = largest_in(level, row).max(least);
            for (open, sample) in open.iter().zip(samples) {
                let figure = relative(open[level][row].open.abs(), size);
                worst.enter(figure, (name, constraints[row].name, sample.state.time));
            }
        }
    }
    let meaning = match worst.at {
        ("", ..) => "largest |C| and |C_q q' + C_t| relative to their terms".into(),
        (what, row, time) => format!("largest {what} relative to its terms: `{row}` at t = {time:.4} s"),
    };
    Check::new("constraints along the run", worst.figure, 1e-9, meaning)
}

/// Rounding is 1e-16 of the largest terms, and 1e-13 of a thousandth of them; the bound is 1e-9.
const LEAST_PART: f64 = 1e-3;

/// A mechanism is at rest that moves by less than this part of its scales, or of them in a second: its rounding is not compared
/// with itself.
const AT_REST: f64 = 1e-6;

/// That part of the scale of each coordinate.
fn at_rest<M: Mechanism>(mechanism: &M, samples: &[Sample<M>]) -> Vec<f64> {
    let Some(State { time, positions, .. }) = samples.first().map(|sample| &sample.state) else { return Vec::new() };
    Measures::at(mechanism, *time, positions).coordinates().iter().map(|scale| AT_REST * scale).collect()
}

/// The residual of a constraint, and the magnitude of its terms.
struct Open {
    open: f64,
    size: f64,
}

/// C, then C_q q' + C_t.
fn residuals(
    mechanism: &dyn AnyMechanism,
    at: &At<f64>,
    (scales, speed): (&[f64], f64),
    rest: &[f64],
) -> [Vec<Open>; 2] {
    let (t, q) = (at.time, at.positions);
    let (values, magnitudes) = (mechanism.constraints(t, q), mechanism.constraint_magnitudes(t, q));
    let (jacobian, drift) = (mechanism.constraint_jacobian(t, q), mechanism.constraint_time_derivative(t, q));
    let position = |row: usize| {
        let moved = at.positions.iter().zip(rest).enumerate();
        let moved: f64 = moved.map(|(j, (q, rest))| jacobian[(row, j)].abs() * q.abs().max(*rest)).sum();
        Open { open: values[row], size: magnitudes[row].max(LEAST_PART * moved) }
    };
    let velocity = |row: usize| {
        let terms = at.speeds.iter().enumerate().map(|(j, u)| jacobian[(row, j)] * u);
        let open = terms.sum::<f64>() + drift[row];
        let moved = at.speeds.iter().zip(scales).enumerate();
        let size: f64 = moved.map(|(j, (u, s))| jacobian[(row, j)].abs() * u.abs().max(speed / s)).sum();
        Open { open, size: size + drift[row].abs() }
    };
    [(0..values.len()).map(position).collect(), (0..values.len()).map(velocity).collect()]
}

/// What is said of a check that compares motions, where there is none.
pub(super) const RESTS: &str = "not checked: the mechanism is at rest, or moves by too little beside its size";

/// Kinetic energy less the work of loads and drives.
pub fn energy_balance<M: Mechanism>(run: &Run<M>) -> Check {
    let (name, bound) = ("energy and work", 1e-7);
    if Sizes::of(&run.mechanism, &run.trajectory.samples).at_rest {
        return Check::unmade(name, bound, RESTS.into());
    }
    let meaning = "change of kinetic energy less work and what events take, relative to the largest of them".into();
    Check::new(name, run.energy_balance, bound, meaning)
}

/// Two runs of one mechanism.
pub fn runs_agree<M: Mechanism>(name: &'static str, one: &Run<M>, other: &Run<M>) -> Check {
    let bound = 1e-6;
    if Sizes::of(&one.mechanism, &one.trajectory.samples).at_rest {
        return Check::unmade(name, bound, RESTS.into());
    }
    let (figure, worst) = difference(one, other);
    let meaning = format!("largest difference of a coordinate or speed, relative to its largest: `{worst}`");
    Check::new(name, figure, bound, meaning)
}

/// The largest difference of any coordinate or speed between two runs with the same rows, relative to its extent, and
/// its name. An event at the time of a row, or beside it but for rounding, makes one row more or less: then rows are compared by
/// their times.
pub fn difference<M: Mechanism>(one: &Run<M>, other: &Run<M>) -> (f64, &'static str) {
    let (a, b) = (&one.trajectory.samples, &other.trajectory.samples);
    let is_same = a.len() == b.len();
    if !is_same && one.events.len() != other.events.len() {
        return (f64::INFINITY, "number of rows");
    }
    let sizes = Sizes::of(&one.mechanism, a);
    let mut worst = Worst::default();
    for (row, a) in a.iter().enumerate() {
        if let Some(b) = if is_same { b.get(row) } else { one.counterpart(a, b) } {
            sizes.compare(&one.mechanism, &a.state, &b.state, &mut worst);
        }
    }
    (worst.figure, worst.at)
}

/// A coordinate with less than this fraction of the others' extent, in sqrt(kg)*m, is compared with that fraction: the
/// error of a step is bounded for the whole state, and projection spreads it.
const SHARE: f64 = 1e-2;

/// The extent of each coordinate and each speed.
pub(super) struct Sizes {
    positions: Vec<f64>,
    speeds: Vec<f64>,
    /// Whether the mechanism is at rest.
    pub(super) at_rest: bool,
}

impl Sizes {
    /// In these samples of one run.
    pub(super) fn of<M: Mechanism>(mechanism: &M, samples: &[Sample<M>]) -> Sizes {
        let places = places(samples);
        let scales = scales(&Any(mechanism), &places);
        let rest = at_rest(mechanism, samples);
        let sizes = |values: &dyn Fn(&At<f64>, usize) -> f64| {
            let own =
                rest.iter().enumerate().map(|(i, rest)| largest(places.iter().map(|at| values(at, i))).max(*rest));
            let own: Vec<f64> = own.collect();
            let all = largest(own.iter().zip(&scales).map(|(size, scale)| scale * size));
            own.iter().zip(&scales).map(|(size, scale)| size.max(SHARE * all / scale)).collect()
        };
        let is_at_rest = |at: &At<f64>| at.speeds.iter().zip(&rest).all(|(speed, rest)| speed.abs() <= *rest);
        Sizes {
            positions: sizes(&|at, i| at.positions[i]),
            speeds: sizes(&|at, i| at.speeds[i]),
            at_rest: places.iter().all(is_at_rest),
        }
    }

    /// Enters the differences of two states.
    pub(super) fn compare<M: Mechanism>(
        &self,
        mechanism: &M,
        a: &State<M>,
        b: &State<M>,
        worst: &mut Worst<&'static str>,
    ) {
        for (i, coordinate) in mechanism.description().coordinates.iter().enumerate() {
            let Sizes { positions, speeds, .. } = self;
            worst.enter(relative((a.positions[i] - b.positions[i]).abs(), positions[i]), coordinate.position.name);
            worst.enter(relative((a.speeds[i] - b.speeds[i]).abs(), speeds[i]), coordinate.speed.name);
        }
    }
}
