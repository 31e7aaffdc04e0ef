//! How long right-hand sides, projections and runs take, beside the standard library's sine and cosine in the same
//! run. `cargo bench -p tests --bench run`

#![allow(missing_docs, clippy::unwrap_used)]

use models::{QuickReturn, QuickReturnRatio};
use sim::{Compiled, Measures};
use std::hint::black_box;
use tests::{Random, run, shortest};

const CALLS: usize = 100_000;
const RUNS: usize = 25;

fn main() {
    let sine = per_call(|i| {
        black_box((0.001 * i as f64).sin_cos());
    });
    println!("standard f64::sin_cos: {sine:.1} ns; all times are the minimum of {RUNS} runs");
    println!(
        "{:<20} {:>22} {:>12} {:>12} {:>16} {:>22}",
        "model", "dynamics [ns]", "sin_cos", "project [ns]", "8192 steps [ms]", "per step, in sin_cos"
    );
    measure("quick-return", QuickReturn::default(), sine);
    measure("quick-return-ratio", QuickReturnRatio::default(), sine);
}

/// Nanoseconds for one of many calls.
fn per_call(mut f: impl FnMut(usize)) -> f64 {
    shortest(RUNS, || (0..CALLS).for_each(&mut f)).as_secs_f64() * 1e9 / CALLS as f64
}

fn measure<M: Compiled>(name: &str, mechanism: M, sine: f64) {
    let found = run(mechanism, 2.0, 8192).unwrap();
    let samples = &found.trajectory.samples;
    let mut random = Random(1);
    let order: Vec<usize> = (0..1024).map(|_| random.between(0.0, samples.len() as f64) as usize).collect();
    let state = |i: usize| &samples[order[i % order.len()]].state;
    let dynamics = per_call(|i| {
        let s = state(i);
        black_box(mechanism.dynamics(s.time, &s.positions, &s.speeds));
    });
    let first = &state(0);
    let measures = Measures::at(&mechanism, first.time, &first.positions);
    let project = per_call(|i| {
        let mut state = state(i).clone();
        sim::project(&mechanism, &measures, &mut state).unwrap();
        black_box(state);
    });
    let integration = (0..RUNS).map(|_| run(mechanism, 2.0, 8192).unwrap().integration_time).min().unwrap();
    let milliseconds = 1e3 * integration.as_secs_f64();
    let per_step = 1e6 * milliseconds / 8192.0 / sine;
    println!(
        "{name:<20} {dynamics:>22.1} {:>12.1} {project:>12.1} {milliseconds:>16.2} {per_step:>22.1}",
        dynamics / sine
    );
}
