//! The quick-return mechanism against its exact solution: 40-digit quadrature of the energy integral, forces by
//! Newton-Euler on each body.

use models::{QuickReturn, QuickReturnRatio};
use serde_json::Value;
use sim::{Mechanism, Run, Table};
use tests::any_model::run;
use tests::{decimal, reference};

const END: f64 = 2.0;

/// Columns of the run with the names that the reference has for them.
const COLUMNS: [(&str, &str); 16] = [
    ("alpha", "alpha"),
    ("beta", "beta"),
    ("gamma", "gamma"),
    ("alpha_dot", "alpha_dot"),
    ("beta_dot", "beta_dot"),
    ("gamma_dot", "gamma_dot"),
    ("alpha_ddot", "alpha_ddot"),
    ("beta_ddot", "beta_ddot"),
    ("gamma_ddot", "gamma_ddot"),
    ("sliding_speed", "sliding_velocity"),
    ("speed_difference", "seed_speed_difference"),
    ("x6", "x6"),
    ("x6_velocity", "x6_dot"),
    ("x6_acceleration", "x6_ddot"),
    ("normal_force_slider3", "normal_force_slider3_on_rocker4"),
    ("normal_force_slider6", "normal_force_slider6_on_ground"),
];

fn exact() -> Value {
    reference("quick_return.json")
}

/// The largest error of a column at the reference times, relative to the column's largest magnitude.
fn column_error(table: &Table, exact: &Value, name: &str, exact_name: &str) -> f64 {
    let samples = exact["samples"].as_array().unwrap();
    let column = table.column(name).unwrap();
    let steps_per_sample = (table.times().len() - 1) / (samples.len() - 1);
    let (mut error, mut largest) = (0.0f64, 0.0f64);
    for (i, sample) in samples.iter().enumerate() {
        let row = i * steps_per_sample;
        assert_eq!(table.times()[row], decimal(&sample["t"]));
        let expected = decimal(&sample[exact_name]);
        error = error.max((column.values[row] - expected).abs());
        largest = largest.max(expected.abs());
    }
    error / largest
}

fn table<M: Mechanism>(run: &Run<M>) -> Table {
    assert_eq!(run.trajectory.failure, None);
    Table::of(&run.mechanism, &run.trajectory)
}

/// 1e-8 is what the project asks of 8192 steps; the method itself leaves about 1e-10.
#[test]
fn every_column_is_that_of_the_exact_solution() {
    let exact = exact();
    let run = run(QuickReturn::default(), END, 8192).unwrap();
    let table = table(&run);
    for (name, exact_name) in COLUMNS {
        let error = column_error(&table, &exact, name, exact_name);
        println!("{name:<22} {error:.1e}");
        assert!(error < 1e-8, "{name}: {error:e}");
    }
    let period_error = (run.period().unwrap() - decimal(&exact["period"])).abs();
    println!("period                 {period_error:.1e} s");
    assert!(period_error < 1e-10, "{period_error:e}");
}

#[test]
fn constraints_hold_at_every_step_and_energy_balances() {
    for (position, velocity, balance) in [
        residuals(&run(QuickReturn::default(), END, 8192).unwrap()),
        residuals(&run(QuickReturnRatio::default(), END, 8192).unwrap()),
    ] {
        println!("positions {position:.1e}, velocities {velocity:.1e}, energy {balance:.1e}");
        assert!(position <= 1e-12 && velocity <= 1e-12 && balance <= 1e-9);
    }
}

fn residuals<M: Mechanism>(run: &Run<M>) -> (f64, f64, f64) {
    (run.position_residual, run.velocity_residual, run.energy_balance)
}

/// The two forms of the slot describe one mechanism: same motion, and the multiplier of one, an energy, is worth
/// the force that the other gives.
#[test]
fn both_forms_of_the_slot_agree() {
    let metres = table(&run(QuickReturn::default(), END, 8192).unwrap());
    let ratio = table(&run(QuickReturnRatio::default(), END, 8192).unwrap());
    for (name, _) in COLUMNS {
        let (a, b) = (&metres.column(name).unwrap().values, &ratio.column(name).unwrap().values);
        let largest = a.iter().fold(0.0f64, |m, x| m.max(x.abs()));
        let difference = a.iter().zip(b).fold(0.0f64, |m, (x, y)| m.max((x - y).abs()));
        println!("{name:<22} {:.1e}", difference / largest);
        assert!(difference < 1e-9 * largest, "{name}: {difference:e}");
    }
    let multiplier = ratio.column("lambda_slot").unwrap();
    assert_eq!(multiplier.unit, "N*m");
    // -664.28 N m in the report, there plotted as newtons.
    assert!((multiplier.values[0] + 664.28).abs() < 0.005, "{}", multiplier.values[0]);
    assert_eq!(metres.column("lambda_slot").unwrap().unit, "N");
}

/// The classical Runge-Kutta method has order 4, and projection must not spoil it.
#[test]
fn the_observed_order_is_four() {
    let exact = exact();
    let errors: Vec<f64> = [1024, 2048, 4096, 8192]
        .into_iter()
        .map(|steps| {
            let table = table(&run(QuickReturn::default(), END, steps).unwrap());
            let state = &COLUMNS[..6];
            state.iter().map(|(name, exact_name)| column_error(&table, &exact, name, exact_name)).fold(0.0, f64::max)
        })
        .collect();
    for pair in errors.windows(2) {
        println!("error {:.3e}, order {:.3}", pair[1], (pair[0] / pair[1]).log2());
    }
    let order = (errors[0] / errors[3]).log2() / 3.0;
    println!("order from 1024 to 8192 steps: {order:.3}");
    assert!((order - 4.0).abs() < 0.1, "{order}");
}

/// The report's own figures, each read off the corrected mechanism.
#[test]
fn the_start_is_assembled_on_the_right_branch() {
    let exact = &exact()["initial"];
    let run = run(QuickReturn::default(), END, 16).unwrap();
    let start = &run.trajectory.samples[0].state;
    for (i, name) in ["alpha", "beta", "gamma"].into_iter().enumerate() {
        // Newton's method converges to a few roundings.
        assert!((start.positions[i] - decimal(&exact[name])).abs() < 1e-14, "{name}");
        assert!((start.speeds[i] - decimal(&exact[format!("{name}_dot")])).abs() < 1e-14, "{name}_dot");
    }
}
