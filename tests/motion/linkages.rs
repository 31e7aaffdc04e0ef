//! Four-bar, slider-crank, double pendulum and pendulum against solutions of 18 digits and more.

use models::{DoublePendulum, FourBar, Pendulum, SliderCrank};
use serde_json::Value;
use sim::{Mechanism, Run, Table};
use tests::any_model::run;
use tests::{decimal, reference};

/// What the project asks of every reference value, relative to the largest of its column.
const TOLERANCE: f64 = 1e-9;

/// The entries of a reference that have a time, of one quantity: (t, value).
pub(crate) fn history(reference: &Value, quantity: &str) -> Vec<(f64, f64)> {
    let entries = reference["reference"].as_array().unwrap();
    let time = |entry: &Value| entry["at"].as_str().and_then(|at| at.strip_prefix("t=")?.parse().ok());
    let entries = entries.iter().filter(|entry| entry["quantity"] == quantity);
    let found: Vec<(f64, f64)> = entries.filter_map(|entry| Some((time(entry)?, decimal(&entry["value"])))).collect();
    assert!(!found.is_empty(), "{quantity}");
    found
}

/// Every column of a run that has a history in the reference agrees with it. A sign turns the reference's direction.
pub(crate) fn compare<M: Mechanism>(run: &Run<M>, reference: &Value, columns: &[(&str, &str, f64)]) {
    assert_eq!(run.trajectory.failure, None);
    let table = Table::of(&run.mechanism, &run.trajectory);
    for (name, quantity, sign) in columns {
        let column = table.column(name).unwrap();
        let largest = column.values.iter().fold(0.0f64, |largest, value| largest.max(value.abs()));
        for (time, expected) in history(reference, quantity) {
            let row = table.times().iter().position(|t| (t - time).abs() < 1e-12).unwrap();
            let error = (column.values[row] - sign * expected).abs() / largest;
            println!("{:<16} {name:<16} t = {time:<4} {error:.1e}", run.mechanism.description().name);
            assert!(error < TOLERANCE, "{name} at {time}: {} instead of {expected}", column.values[row]);
        }
    }
}

fn single(reference: &Value, quantity: &str) -> f64 {
    let entries = reference["reference"].as_array().unwrap();
    decimal(&entries.iter().find(|entry| entry["quantity"] == quantity).unwrap()["value"])
}

#[test]
fn a_four_bar_under_gravity_with_its_joint_forces() {
    let reference = reference("fourbar_free.json");
    let run = run(FourBar::default(), 2.0, 20_000).unwrap();
    let force = |joint: &str| format!("multiplier {joint} (M a + C^T lam = F)");
    // The reference counts forces on the ground and on the crank, the model those by the ground and by the crank.
    let signs = [
        ("O2x", -1.0),
        ("O2y", -1.0),
        ("O4x", -1.0),
        ("O4y", -1.0),
        ("Ax", -1.0),
        ("Ay", -1.0),
        ("Bx", 1.0),
        ("By", 1.0),
    ];
    let joints = signs.map(|(joint, sign)| (joint, force(joint), sign));
    let mut columns: Vec<(&str, &str, f64)> =
        ["theta2", "theta3", "theta4"].into_iter().map(|name| (name, name, 1.0)).collect();
    columns.extend([("theta2_dot", "omega2", 1.0), ("theta3_dot", "omega3", 1.0), ("theta4_dot", "omega4", 1.0)]);
    columns.extend([("theta2_ddot", "alpha2", 1.0), ("theta3_ddot", "alpha3", 1.0), ("theta4_ddot", "alpha4", 1.0)]);
    columns.extend(joints.iter().map(|(joint, quantity, sign)| (*joint, quantity.as_str(), *sign)));
    compare(&run, &reference, &columns);
    assert!((run.period().unwrap() - single(&reference, "period of the free motion")).abs() < 1e-9);
}

#[test]
fn a_slider_crank_under_gravity_with_its_wall_force() {
    let reference = reference("slider_crank_free.json");
    let run = run(SliderCrank::default(), 1.0, 20_000).unwrap();
    let columns = [
        ("theta", "theta", 1.0),
        ("phi", "phi", 1.0),
        ("x", "x", 1.0),
        ("theta_dot", "omega", 1.0),
        ("phi_dot", "phi'", 1.0),
        ("x_velocity", "x'", 1.0),
        ("theta_ddot", "alpha", 1.0),
        ("phi_ddot", "phi''", 1.0),
        ("x_acceleration", "x''", 1.0),
        ("wall_force", "wall force on the piston, +y", 1.0),
    ];
    compare(&run, &reference, &columns);
    assert!((run.period().unwrap() - single(&reference, "period of the free motion")).abs() < 1e-9);
}

/// The reference's angles are from the direction of gravity, as the model's are.
#[test]
fn a_double_pendulum_of_two_lengths() {
    let reference = reference("double_pendulum_hw6.json");
    for l in [0.6, 0.55] {
        let run = run(DoublePendulum { l, ..Default::default() }, 3.0, 30_000).unwrap();
        let quantities = ["phi1", "phi2", "omega1", "omega2"].map(|name| format!("l={l} {name}"));
        let columns: Vec<_> = ["phi1", "phi2", "phi1_dot", "phi2_dot"]
            .into_iter()
            .zip(&quantities)
            .map(|(name, quantity)| (name, quantity.as_str(), 1.0))
            .collect();
        compare(&run, &reference, &columns);
    }
}

#[test]
fn a_pendulum_keeps_its_period_at_every_amplitude() {
    let reference = reference("pendulum_period.json");
    let unit = 2.0 * std::f64::consts::PI / 9.81f64.sqrt();
    for entry in reference["reference"].as_array().unwrap() {
        let quantity = entry["quantity"].as_str().unwrap();
        let Some(degrees) = quantity.split("amplitude ").nth(1).and_then(|rest| rest.strip_suffix(" deg")) else {
            continue;
        };
        let amplitude = degrees.parse::<f64>().unwrap().to_radians();
        let period = decimal(&entry["value"]) * unit;
        let run = run(Pendulum { amplitude, ..Default::default() }, 0.6 * period, 5000).unwrap();
        let half = run.events.iter().find(|event| event.name == "rest").unwrap().state.time;
        println!("{degrees:>6} deg: {:.1e}", (2.0 * half - period) / period);
        assert!((2.0 * half - period).abs() < TOLERANCE * period, "{degrees}: {half} {period}");
    }
}
