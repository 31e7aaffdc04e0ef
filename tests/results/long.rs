//! Long runs: constraints stay at the floor of the projection, and the balance of energy does not drift beyond what the
//! tolerance of each step allows.

use models::{FourBar, QuickReturn};
use sim::{Compiled, Method, Rows, Settings};
use tests::run_with;

/// Prints the balance over time; gives the largest residuals and imbalance.
fn check<M: Compiled>(mechanism: M, end: f64) -> (f64, f64, f64) {
    let settings = Settings { rows: Rows::Even(500), ..Settings::adaptive(Method::Dop853, end, 1e-12) };
    let run = run_with(mechanism, &settings).unwrap();
    assert_eq!(run.trajectory.failure, None);
    let kinetic = |state: &sim::State<M>| mechanism.kinetic_energy(state.time, &state.positions, &state.speeds);
    let start = run.trajectory.samples[0].state.clone();
    for sample in run.trajectory.samples.iter().step_by(100) {
        let state = &sample.state;
        let change = (kinetic(state) - state.work - kinetic(&start) + start.work) / kinetic(&start);
        println!("{:<14} t = {:>7} s: energy off by {change:+.1e}", M::DESCRIPTION.name, state.time);
    }
    println!("{} steps, C {:.1e}, C' {:.1e}", run.steps.accepted, run.position_residual, run.velocity_residual);
    (run.position_residual, run.velocity_residual, run.energy_balance)
}

/// `cargo bench -p tests --bench long` prints the same, optimised. Angles grow to 70,000 rad, of which a double knows 1e-11; the projection can do no better.
#[test]
#[ignore = "takes a minute without optimisation: cargo test -p tests --release --test results long -- --ignored --nocapture"]
fn quick_return_for_ten_thousand_seconds() {
    let (position, velocity, energy) = check(QuickReturn::default(), 10_000.0);
    assert!(position < 1e-10 && velocity < 1e-10 && energy < 1e-6, "{position:e} {velocity:e} {energy:e}");
}

/// A thousand seconds, or a quarter of that in a debug build.
#[test]
fn a_four_bar_under_gravity_for_many_minutes() {
    let (position, velocity, energy) = check(FourBar::default(), tests::sampled(250.0, 1000.0));
    assert!(position < 1e-11 && velocity < 1e-11 && energy < 1e-7, "{position:e} {velocity:e} {energy:e}");
}
