//! What is drawn: a linkage with its sizes, masses, loads and start, and how it is run.

use super::LINKAGES;
use super::ranges::Range;
use super::sizes;
use super::topology::{PLANAR, SPATIAL};
use super::typed::{Found, Linkage};
use sim::{Method, Rows, Settings, Stabilisation, Stepping, Tolerance};
use std::f64::consts::TAU;
use tests::Random;

/// One draw.
pub(crate) struct Draw {
    pub(crate) linkage: &'static Linkage,
    pub(crate) form: usize,
    pub(crate) parameters: Parameters,
    /// Size, mass and highest angular speed, which make the natural sizes of all quantities.
    pub(crate) scales: [f64; 3],
    pub(crate) task: Task,
}

pub(crate) type Parameters = Vec<(String, f64)>;

#[derive(Clone, Debug)]
pub(crate) enum Task {
    Run(Settings),
    /// From, to and speed of the first body's angle, and the number of intervals.
    Sweep([f64; 3], usize),
}

impl Drawn {
    /// As options of the command, for one draw.
    pub(crate) fn options(&self) -> String {
        match self.turns == MOST_TURNS {
            true => format!("--seed {}", self.seed),
            false => format!("--seed {} --turns {}", self.seed, self.turns),
        }
    }
}

/// Random numbers of one draw, whatever was drawn before.
pub(crate) fn random(seed: u64, number: u64) -> Random {
    let mut mixed = Random(seed.wrapping_mul(0xd134_2543_de82_ef95) ^ number.wrapping_mul(0x2545_f491_4f6c_dd1d));
    mixed.between(0.0, 1.0);
    Random(mixed.0 ^ number)
}

fn pick<'t, T>(random: &mut Random, of: &'t [T]) -> &'t T {
    &of[random.between(0.0, of.len() as f64) as usize]
}

/// Between two positive numbers, evenly in the logarithm.
pub(crate) fn log_between(random: &mut Random, low: f64, high: f64) -> f64 {
    random.between(low.ln(), high.ln()).exp()
}

pub(crate) fn happens(random: &mut Random, probability: f64) -> bool {
    random.between(0.0, 1.0) < probability
}

/// Which draws are made.
#[derive(Clone)]
pub(crate) struct Drawn {
    pub(crate) seed: u64,
    /// The linkage, if only one is wanted.
    pub(crate) of: Option<String>,
    /// How far runs go at most, in turns of the fastest body.
    pub(crate) turns: f64,
}

/// Draws; `None` if no sound start was found, or if it is of another linkage than the one that is wanted.
pub(crate) fn draw(drawn: &Drawn, number: u64) -> Option<Draw> {
    let random = &mut random(drawn.seed, number);
    let index = random.between(0.0, LINKAGES.len() as f64) as usize;
    if drawn.of.as_ref().is_some_and(|of| of != LINKAGES[index].name) {
        return None;
    }
    let linkage = &LINKAGES[index];
    let form = random.between(0.0, linkage.forms.len() as f64) as usize;
    let kind = random.between(0.0, 1.0);
    for _ in 0..40 {
        let (parameters, [size, mass, speed]) = match PLANAR.get(index) {
            Some(planar) => sizes::planar(planar, random),
            None => sizes::spatial(&SPATIAL[index - PLANAR.len()], random),
        };
        // As many turns at the speed of the start, as far as it gets.
        let end = drawn.turns * TAU / speed;
        let ahead = Settings { rows: Rows::Even(600), ..Settings::adaptive(Method::Dop853, end, 1e-9) };
        let Ok(found) = linkage.forms[0].run(&parameters, &ahead) else { continue };
        let pace = Pace::of(&found, ahead.end, [size, mass, speed]);
        if !pace.starts_well(speed) {
            continue;
        }
        let task = if kind < 0.45 {
            Task::Run(adaptive(&pace, drawn.turns, random))
        } else if kind < 0.9 || !linkage.forms[form].is_driven() {
            let Some(settings) = equal(&pace, drawn.turns, random) else { continue };
            Task::Run(settings)
        } else {
            let from =
                parameters.iter().find(|(name, _)| name == "th_0" || name == "t_0").map_or(0.0, |(_, value)| *value);
            let turns = log_between(random, 0.05, TURNS_SWEPT * drawn.turns);
            let rows = log_between(random, 1.0, 1000.0) as usize;
            Task::Sweep([from, from + turns * TAU, speed], rows)
        };
        return Some(Draw { linkage, form, parameters, scales: [size, mass, pace.fastest()], task });
    }
    None
}

impl Draw {
    /// The form and the way, by which wrong results are counted.
    pub(crate) fn class(&self) -> String {
        let way = match &self.task {
            Task::Sweep(..) => "sweep".to_owned(),
            Task::Run(settings) => {
                let steps = if matches!(settings.stepping, Stepping::Equal(_)) { "equal" } else { "adaptive" };
                format!("{steps}, {}", settings.stabilisation)
            }
        };
        format!("{}, {way}", self.linkage.forms[self.form].name())
    }

    /// In one line.
    pub(crate) fn summary(&self) -> String {
        let how = match &self.task {
            Task::Sweep([from, to, _], rows) => format!("sweep from {from:.3} to {to:.3} in {rows}"),
            Task::Run(settings) => {
                let Settings { end, method, stepping, stabilisation, rows, .. } = settings;
                let steps = match stepping {
                    Stepping::Equal(steps) => format!("{steps} steps"),
                    Stepping::Adaptive(tolerance) => format!("rtol {:.1e}", tolerance.relative),
                };
                format!("{} {steps}, {stabilisation}, to {end:.3e} s, {rows:?}", method.name())
            }
        };
        format!("{} of {:.1e} m, {how}", self.linkage.forms[self.form].name(), self.scales[0])
    }

    /// The same as parameters of the command line.
    pub(crate) fn command(&self) -> String {
        let set: Vec<String> = self.parameters.iter().map(|(name, value)| format!("--set {name}={value:e}")).collect();
        format!("{} {}", self.summary(), set.join(" "))
    }
}

/// How fast a linkage moves.
struct Pace {
    times: Vec<f64>,
    /// The highest angular speed until then.
    highest: Vec<f64>,
    /// The highest pace of all columns until then, where a column's is twice its steepest slope beside its range: the angular
    /// speed of a sine, and more where it changes within a part of a turn. Infinite from where these times are too far apart
    /// to tell.
    sharpest: Vec<f64>,
}

impl Pace {
    fn of(found: &Found, end: f64, scales: [f64; 3]) -> Pace {
        let rows = found.columns.first().map_or(0, Vec::len);
        let step = end / (rows - 1) as f64;
        let mut pace = Pace {
            times: (0..rows).map(|i| step * i as f64).collect(),
            highest: vec![0.0; rows],
            sharpest: vec![0.0; rows],
        };
        for (name, column) in found.names.iter().zip(&found.columns) {
            let all = Range::of(name, scales, column).size(1e-3);
            let (mut range, mut steepest, mut fastest) = (Range::of(name, scales, &[]), 0.0f64, 0.0f64);
            for i in 0..rows {
                range.take(column[i]);
                let change = (column[i] - column[i.saturating_sub(1)]).abs();
                steepest = steepest.max(if change > JUMP * all { f64::INFINITY } else { change / step });
                pace.sharpest[i] = pace.sharpest[i].max(2.0 * steepest / range.size(1e-3));
                if name.starts_with('w') {
                    fastest = fastest.max(column[i].abs());
                    pace.highest[i] = pace.highest[i].max(fastest);
                }
            }
        }
        pace
    }

    fn fastest(&self) -> f64 {
        self.highest.last().copied().unwrap_or(0.0)
    }

    /// No body moves much faster than the first one at the start, as all do beside a dead point.
    fn starts_well(&self, speed: f64) -> bool {
        self.highest.first().is_some_and(|highest| *highest <= 6.0 * speed)
    }

    /// The last time at which the fastest body so far would have made at most so many turns.
    fn until(&self, turns: f64) -> usize {
        let within = |i: &usize| self.times[*i] * self.highest[*i] <= turns * TAU;
        (1..self.times.len()).take_while(within).last().unwrap_or(1)
    }
}

/// Baumgarte's method and none let the constraints drift, which is what they are offered to show.
fn stabilisation(random: &mut Random) -> Stabilisation {
    match random.between(0.0, 1.0) {
        x if x < 0.45 => Stabilisation::Projection,
        x if x < 0.7 => Stabilisation::MassProjection,
        _ => Stabilisation::Partitioning,
    }
}

fn adaptive(pace: &Pace, turns: f64, random: &mut Random) -> Settings {
    let last = pace.until(log_between(random, 0.1, turns));
    let method = *pick(random, &[Method::Dopri5, Method::Dop853, Method::Radau5]);
    let tightest = if method == Method::Radau5 { 1e-10 } else { 1e-12 };
    let relative = log_between(random, tightest, 1e-5);
    Settings {
        stepping: Stepping::Adaptive(Tolerance::new(relative)),
        stabilisation: stabilisation(random),
        rows: Rows::Even(log_between(random, 1.0, 1001.0) as usize),
        ..Settings::adaptive(method, pace.times[last], relative)
    }
}

/// More steps than these are not drawn, to keep the time of a draw small.
const MOST_STEPS: f64 = 3000.0;
/// The implicit method asks for many right-hand sides in a step.
const MOST_IMPLICIT_STEPS: f64 = 500.0;
/// A column that changes by this part of its range from one row to the next has more between them.
const JUMP: f64 = 0.25;
/// The longest runs where nothing else is asked for, in turns.
pub(crate) const MOST_TURNS: f64 = 4.0;
/// Sweeps go so many times as far, and runs of equal steps so far.
const TURNS_SWEPT: f64 = 12.5;
const TURNS_IN_EQUAL_STEPS: f64 = 0.5;

fn equal(pace: &Pace, turns: f64, random: &mut Random) -> Option<Settings> {
    let method = *pick(random, &Method::ALL);
    // Of fewer steps a fifth of a range may be the error of Euler's method itself.
    let fewest = if method == Method::Euler { 600.0 } else { 400.0 };
    let turns = log_between(random, 0.1, TURNS_IN_EQUAL_STEPS * turns);
    let per_turn = log_between(random, fewest, 1600.0);
    // In a turn of the fastest body, or of what changes fastest.
    let steps = |i: usize| (pace.times[i] * pace.highest[i].max(pace.sharpest[i]) / TAU * per_turn).ceil();
    let most = if method == Method::Radau5 { MOST_IMPLICIT_STEPS } else { MOST_STEPS };
    let last = (1..=pace.until(turns)).rev().find(|i| steps(*i) <= most)?;
    Some(Settings {
        stabilisation: stabilisation(random),
        rows: Rows::Even(log_between(random, 1.0, 1001.0) as usize),
        ..Settings::equal_steps(method, pace.times[last], steps(last) as usize)
    })
}
