//! What several kinds of tests and benchmarks need: reference solutions, runs, random numbers, timing.

pub mod any_model;
pub mod by_hand;
pub mod called;
pub mod declarations;
pub mod digest;
pub mod engine;
pub mod extremes;
pub mod faults;
pub mod house;
pub mod mangling;
pub mod same_bits;
pub mod spectra;

use serde_json::Value;
use sim::{Compiled, Description, Mechanism, Method, Run, Settings, declared_start};
use std::time::{Duration, Instant};

/// A file of `tests/reference`.
pub fn reference(name: &str) -> Value {
    let path = format!("{}/reference/{name}", env!("CARGO_MANIFEST_DIR"));
    let text = std::fs::read_to_string(&path).unwrap_or_else(|e| fail(&path, &e));
    serde_json::from_str(&text).unwrap_or_else(|e| fail(&path, &e))
}

#[allow(clippy::panic)]
fn fail(path: &str, error: &dyn std::error::Error) -> ! {
    panic!("{path}: {error}")
}

/// A number of a reference file, which holds decimal strings.
pub fn decimal(value: &Value) -> f64 {
    value.as_str().and_then(|text| text.parse().ok()).unwrap_or(f64::NAN)
}

/// How much of a slow check is done: a part in a debug build, as the gate's is, and all in release.
pub const fn sampled<T: Copy>(part: T, all: T) -> T {
    if cfg!(debug_assertions) { part } else { all }
}

/// A run from the declared start, by the classical method of Runge and Kutta with equal steps.
///
/// # Errors
/// If it cannot be assembled.
pub fn run<M: Mechanism>(mechanism: M, end: f64, steps: usize) -> Result<Run<M>, sim::Failure> {
    run_with(mechanism, &Settings::equal_steps(Method::Rk4, end, steps))
}

/// A run from the declared start.
///
/// # Errors
/// If it cannot be assembled.
pub fn run_with<M: Mechanism>(mechanism: M, settings: &Settings) -> Result<Run<M>, sim::Failure> {
    let start = declared_start(&mechanism);
    sim::run(mechanism, &start, settings)
}

macro_rules! descriptions {
    ($($model:ty),*) => { vec![$(const { &<$model as Compiled>::DESCRIPTION }),*] };
}

/// What every shipped mechanism says of itself.
pub fn shipped() -> Vec<&'static Description> {
    models::all_models!(descriptions)
}

/// A small generator of reproducible random numbers (Steele, Lea, Flood: SplitMix64, 2014).
pub struct Random(pub u64);

impl Random {
    /// The next number in [low, high).
    pub fn between(&mut self, low: f64, high: f64) -> f64 {
        self.0 = self.0.wrapping_add(0x9e37_79b9_7f4a_7c15);
        let mut z = self.0;
        z = (z ^ (z >> 30)).wrapping_mul(0xbf58_476d_1ce4_e5b9);
        z = (z ^ (z >> 27)).wrapping_mul(0x94d0_49bb_1331_11eb);
        z ^= z >> 31;
        low + (high - low) * ((z >> 11) as f64 / (1u64 << 53) as f64)
    }
}

/// The most memory that this process has had so far, in bytes, where the system tells.
pub fn peak_memory() -> Option<usize> {
    let status = std::fs::read_to_string("/proc/self/status").ok()?;
    let line = status.lines().find_map(|line| line.strip_prefix("VmHWM:"))?;
    Some(1024 * line.trim().trim_end_matches(" kB").parse::<usize>().ok()?)
}

/// The shortest of several runs of `f`, after one that is not counted.
pub fn shortest(runs: usize, mut f: impl FnMut()) -> Duration {
    f();
    let times = (0..runs).map(|_| {
        let clock = Instant::now();
        f();
        clock.elapsed()
    });
    times.min().unwrap_or_default()
}

/// The shortest of several runs of each of these, run in turn so that what disturbs one disturbs all.
pub fn interleaved(runs: usize, work: &mut [&mut dyn FnMut()]) -> Vec<Duration> {
    work.iter_mut().for_each(|f| f());
    let mut best = vec![Duration::MAX; work.len()];
    for _ in 0..runs {
        for (f, best) in work.iter_mut().zip(&mut best) {
            let clock = Instant::now();
            f();
            *best = (*best).min(clock.elapsed());
        }
    }
    best
}
