//! What accuracy costs: error of the quick-return mechanism after 2 s against right-hand sides and time, for every method
//! and tolerance, projected, with the period located; beside DOP853 of the crate `differential-equations`, without
//! projection and events, on the same right-hand side. `cargo bench -p tests --bench work_precision`

#![allow(missing_docs, clippy::unwrap_used)]

use differential_equations::prelude::{ExplicitRungeKutta, IVP, ODE};
use models::QuickReturn;
use sim::{Method, Rows, Settings, State, assemble, declared_start};
use std::hint::black_box;
use std::time::Duration;
use tests::{decimal, reference, run_with, shortest};

const END: f64 = 2.0;
const RUNS: usize = 15;

struct Row {
    method: String,
    steps: u64,
    evaluations: u64,
    time: Duration,
    /// Of alpha(2 s), relative.
    error: f64,
    /// Of the period, in seconds.
    period: Option<f64>,
}

fn main() {
    println!("quick-return, {END} s, minimum of {RUNS} runs; error of alpha(2 s) relative, of the period in seconds");
    println!(
        "{:<34} {:>8} {:>9} {:>11} {:>12} {:>10} {:>10}",
        "method", "steps", "rhs", "time [ms]", "of rk4-8192", "error", "period"
    );
    let rk4 = ours(&Settings::equal_steps(Method::Rk4, END, 8192), "8192 steps");
    let baseline = rk4.time;
    print(&rk4, baseline);
    for method in [Method::Euler, Method::Heun, Method::Rk3, Method::Rk4, Method::Dop853] {
        for steps in [512, 2048, 8192, 32768] {
            print(&ours(&Settings::equal_steps(method, END, steps), &format!("{steps} steps")), baseline);
        }
    }
    for method in [Method::Dopri5, Method::Radau5, Method::Dop853] {
        for rtol in [1e-6, 1e-8, 1e-10, 1e-12] {
            print(&ours(&Settings::adaptive(method, END, rtol), &format!("rtol {rtol:e}")), baseline);
        }
    }
    for rtol in [1e-6, 1e-8, 1e-10, 1e-12] {
        print(&theirs(rtol), baseline);
    }
}

fn print(row: &Row, baseline: Duration) {
    let milliseconds = 1e3 * row.time.as_secs_f64();
    let ratio = row.time.as_secs_f64() / baseline.as_secs_f64();
    let period = row.period.map_or("-".to_owned(), |period| format!("{period:.1e}"));
    println!(
        "{:<34} {:>8} {:>9} {milliseconds:>11.3} {ratio:>12.4} {:>10.1e} {period:>10}",
        row.method, row.steps, row.evaluations, row.error
    );
}

fn error_of(alpha: f64) -> f64 {
    let exact = reference("quick_return.json");
    let expected = decimal(&exact["samples"].as_array().unwrap().last().unwrap()["alpha"]);
    ((alpha - expected) / expected).abs()
}

/// Recorded at its end alone.
fn ours(settings: &Settings, what: &str) -> Row {
    let settings = Settings { rows: Rows::Even(1), ..*settings };
    let found = run_with(QuickReturn::default(), &settings).unwrap();
    let time = (0..RUNS).map(|_| run_with(QuickReturn::default(), &settings).unwrap().integration_time).min().unwrap();
    let exact = decimal(&reference("quick_return.json")["period"]);
    Row {
        method: format!("{}, {what}", settings.method.name()),
        steps: found.steps.accepted + found.steps.rejected,
        evaluations: found.evaluations,
        time,
        error: error_of(found.trajectory.samples.last().unwrap().state.positions[0]),
        period: found.period().map(|period| (period - exact).abs()),
    }
}

struct Equations(QuickReturn);

impl ODE<f64, [f64; 6]> for Equations {
    fn diff(&self, t: f64, y: &[f64; 6], rates: &mut [f64; 6]) {
        let [a, b, c, speeds @ ..] = *y;
        let [x, y, z] = self.0.dynamics(t, &[a, b, c], &speeds).accelerations;
        *rates = [speeds[0], speeds[1], speeds[2], x, y, z];
    }
}

fn theirs(rtol: f64) -> Row {
    let mechanism = QuickReturn::default();
    let State { positions: [a, b, c], speeds: [x, y, z], .. } =
        assemble(&mechanism, &declared_start(&mechanism)).unwrap();
    let equations = Equations(mechanism);
    let solve = || {
        let method = ExplicitRungeKutta::dop853().rtol(rtol).atol(rtol);
        IVP::ode(&equations, 0.0, END, [a, b, c, x, y, z]).method(method).solve().unwrap()
    };
    let solution = solve();
    Row {
        method: format!("differential-equations, rtol {rtol:e}"),
        steps: (solution.steps.accepted + solution.steps.rejected) as u64,
        evaluations: solution.evals.function as u64,
        time: shortest(RUNS, || {
            black_box(solve());
        }),
        error: error_of(solution.y.last().unwrap()[0]),
        period: None,
    }
}
