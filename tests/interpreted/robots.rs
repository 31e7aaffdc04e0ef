//! Robots on a fixed base against Pinocchio: forward and inverse dynamics and the mass matrix.

use serde_json::Value;
use sim::{At, Kernel, Model, load};
use std::fs;

fn robots() -> String {
    format!("{}/robots", env!("CARGO_MANIFEST_DIR"))
}

fn numbers(value: &Value) -> Vec<f64> {
    value.as_array().unwrap().iter().map(|number| number.as_f64().unwrap()).collect()
}

/// All numbers that a kernel gives.
fn called(model: &dyn Model, kernel: Kernel, at: At<f64>) -> Vec<f64> {
    let mut found = Vec::new();
    assert!(!model.call(kernel, at, &mut |_, row| found.extend_from_slice(row)));
    found
}

/// The greatest difference, relative to the greatest number.
fn difference(found: &[f64], expected: &[f64]) -> f64 {
    let largest = expected.iter().fold(0.0, |largest: f64, number| largest.max(number.abs()));
    found.iter().zip(expected).fold(0.0, |worst: f64, (a, b)| worst.max((a - b).abs())) / largest
}

fn agrees(name: &str, bound: f64) {
    let model = load(format!("{}/declared/{}.rs", robots(), name.to_lowercase()), None).unwrap();
    let text = fs::read_to_string(format!("{}/reference.json", robots())).unwrap();
    let reference: Value = serde_json::from_str(&text).unwrap();
    for state in reference[name].as_array().unwrap() {
        let of = |what: &str| numbers(&state[what]);
        let (q, qd, a) = (of("q"), of("qd"), of("a"));
        let at = At { time: 0.0, positions: &q, speeds: &qd, accelerations: &a, multipliers: &[] };
        let qdd = called(&*model, Kernel::Dynamics, at);
        let mass: Vec<f64> = state["mass_matrix"].as_array().unwrap().iter().flat_map(numbers).collect();
        let differences = [
            difference(&qdd[..q.len()], &of("qdd_free")),
            difference(&called(&*model, Kernel::InverseDynamics, at), &of("tau")),
            difference(&called(&*model, Kernel::MassMatrix, at), &mass),
        ];
        assert!(differences.iter().all(|difference| *difference < bound), "{name}: {differences:?}");
    }
}

/// Its file gives pi/2 to eleven digits.
#[test]
fn ur5() {
    agrees("Ur5", 3e-11);
}

/// A few roundings of sums of some hundred terms, divided by the condition of the mass matrix.
#[test]
fn arm_of_talos() {
    agrees("Talosarm", 1e-13);
}

#[test]
fn panda_with_fingers() {
    agrees("Panda", 1e-13);
}
