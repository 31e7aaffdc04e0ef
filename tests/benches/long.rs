//! Long runs: whether constraints stay where the projection puts them, and what becomes of the energy. Quick-return for
//! 10,000 s and a four-bar under gravity for 1,000 s; then 100,000 periods of mechanisms that keep their energy, by methods
//! that are not made for that: what the decision against a symplectic or variational method rests on.
//! `cargo bench -p tests --bench long`

#![allow(missing_docs, clippy::unwrap_used)]

use models::{FourBar, Pendulum, QuickReturn};
use sim::{Compiled, Method, Rows, Settings, State};
use std::time::Instant;
use tests::run_with;

const ROWS: usize = 10;

fn main() {
    println!("change of kinetic energy less work, relative to the largest kinetic energy of the run, over time");
    over_time("quick-return, 10,000 s", QuickReturn::default(), &Settings::adaptive(Method::Dop853, 10_000.0, 1e-12));
    over_time("quick-return, 10,000 s", QuickReturn::default(), &Settings::adaptive(Method::Dop853, 10_000.0, 1e-10));
    over_time("four-bar, 1,000 s", FourBar::default(), &Settings::adaptive(Method::Dop853, 1000.0, 1e-12));
    println!("\n100,000 periods of mechanisms that keep their energy");
    periods("pendulum", Pendulum::default());
    periods("four-bar", FourBar::default());
}

/// By DOP853 at several tolerances and by RK4 with equal steps.
fn periods<M: Compiled>(name: &str, mechanism: M) {
    let (period, steps) = (period(mechanism), 1e5);
    println!("{name}: a period is {period:.4} s");
    for rtol in [1e-8, 1e-10, 1e-12] {
        over_time(name, mechanism, &Settings::adaptive(Method::Dop853, steps * period, rtol));
    }
    over_time(name, mechanism, &Settings::equal_steps(Method::Rk4, steps * period, 10_000_000));
}

/// Twice the time between the first two turns of the first coordinate, or the time of one revolution.
fn period<M: Compiled>(mechanism: M) -> f64 {
    let settings = Settings { rows: Rows::Even(20_000), ..Settings::new(20.0) };
    let samples = run_with(mechanism, &settings).unwrap().trajectory.samples;
    let start = samples[0].state.positions[0];
    let revolution = samples.iter().find(|s| (s.state.positions[0] - start).abs() >= std::f64::consts::TAU);
    let mut turns = samples.windows(2).filter(|pair| pair[0].state.speeds[0] * pair[1].state.speeds[0] < 0.0);
    match (revolution, turns.next(), turns.next()) {
        (Some(sample), _, _) => sample.state.time,
        (None, Some(first), Some(second)) => 2.0 * (second[0].state.time - first[0].state.time),
        _ => 20.0,
    }
}

fn over_time<M: Compiled>(name: &str, mechanism: M, settings: &Settings) {
    let clock = Instant::now();
    let run = run_with(mechanism, &Settings { rows: Rows::Even(ROWS * 50), ..*settings }).unwrap();
    let seconds = clock.elapsed().as_secs_f64();
    assert_eq!(run.trajectory.failure, None);
    let samples = &run.trajectory.samples;
    let kinetic = |s: &State<M>| mechanism.kinetic_energy(s.time, &s.positions, &s.speeds);
    let largest = samples.iter().map(|sample| kinetic(&sample.state)).fold(0.0, f64::max);
    let balance = |s: &State<M>| kinetic(s) - s.work;
    let start = balance(&samples[0].state);
    println!(
        "{name}, {} {:?}: {} steps in {seconds:.1} s, C {:.0e}, C' {:.0e}",
        settings.method.name(),
        settings.stepping,
        run.steps.accepted,
        run.position_residual,
        run.velocity_residual
    );
    let changes = samples.iter().skip(50).step_by(50);
    let changes = changes.map(|s| format!("{:.0}: {:+.1e}", s.state.time, (balance(&s.state) - start) / largest));
    println!("    {}", changes.collect::<Vec<_>>().join(", "));
}
