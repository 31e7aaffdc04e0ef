//! 8. A robot from its URDF under computed torque: an arm goes through a list of poses.
//!
//! The torques come from the kernel of inverse dynamics, generated for this robot, and are held for a millisecond each.
//!
//! `cargo run --release --example 08_robot_arm`

use sim::show::{Curve, Plot, Size, panels};
use sim::{At, Erased, Input, Kernel, Model, Settings, Simulation, declared_start, load};
use std::path::Path;

/// Where the arm is to be, in its coordinates: five angles and the opening of its gripper.
const POSES: [[f64; 6]; 4] = [
    [0.0, 0.0, 0.0, 0.0, 1.2, 0.0],
    [0.8, 0.6, 0.9, -1.0, 0.7, 0.03],
    [-0.6, 1.1, 0.4, 1.5, 1.8, 0.0],
    [0.0, 0.3, 1.4, 0.0, 1.2, 0.02],
];
/// Seconds from pose to pose.
const EACH: f64 = 1.0;
/// How often torques are set, in s.
const PERIOD: f64 = 1e-3;
/// Errors fall like those of a spring and a damper of this frequency, in rad/s, without overshoot.
const FREQUENCY: f64 = 30.0;

/// The wanted position, speed and acceleration: from pose to pose with both at rest, by a polynomial of fifth degree.
fn wanted(time: f64) -> [[f64; 6]; 3] {
    let at = ((time / EACH) as usize).min(POSES.len() - 2);
    let s = (time / EACH - at as f64).min(1.0);
    let share = s.powi(3) * (10.0 - 15.0 * s + 6.0 * s * s);
    let rate = 30.0 * (s * (1.0 - s)).powi(2) / EACH;
    let change = 60.0 * s * (1.0 - s) * (1.0 - 2.0 * s) / (EACH * EACH);
    let way = |k: usize| POSES[at + 1][k] - POSES[at][k];
    [
        std::array::from_fn(|k| POSES[at][k] + share * way(k)),
        std::array::from_fn(|k| rate * way(k)),
        std::array::from_fn(|k| change * way(k)),
    ]
}

/// The torques that make errors of position and speed die out.
fn torques(arm: &dyn Model, time: f64, q: &[f64], qd: &[f64]) -> Vec<f64> {
    let [position, speed, acceleration] = wanted(time);
    let commanded: Vec<f64> = (0..q.len())
        .map(|k| {
            let (error, rate) = (position[k] - q[k], speed[k] - qd[k]);
            acceleration[k] + FREQUENCY * FREQUENCY * error + 2.0 * FREQUENCY * rate
        })
        .collect();
    let at = At { time, positions: q, speeds: qd, accelerations: &commanded, multipliers: &[] };
    let mut found = Vec::new();
    arm.call(Kernel::InverseDynamics, at, &mut |_, row| found.extend_from_slice(row));
    found
}

fn main() -> Result<(), Box<dyn std::error::Error>> {
    let arm = load(concat!(env!("CARGO_MANIFEST_DIR"), "/examples/robots/arm.urdf"), None)?;
    let names = arm.description().coordinates.iter().map(|coordinate| coordinate.position.name);
    let names: Vec<&str> = names.collect();
    let robot = Erased::of(arm.clone());
    let end = EACH * (POSES.len() - 1) as f64;
    let mut start = declared_start(&robot);
    for (k, angle) in POSES[0].into_iter().enumerate() {
        (start.positions[k], start.position_given[k]) = (angle, true);
    }
    let mut simulation = Simulation::new(robot, &start, &Settings::new(end))?;
    let (mut times, mut errors) = (Vec::new(), vec![Vec::new(); names.len()]);
    let mut largest = vec![0.0f64; names.len()];
    for sample in 0..(end / PERIOD).round() as usize {
        let time = sample as f64 * PERIOD;
        let (q, qd) = (simulation.state().positions.as_ref().to_vec(), simulation.state().speeds.as_ref().to_vec());
        for (k, torque) in torques(&*arm, time, &q, &qd).into_iter().enumerate() {
            simulation.set_input(&format!("tau_{}", names[k]), Input::Held(torque))?;
            let error = wanted(time)[0][k] - q[k];
            largest[k] = largest[k].max(error.abs());
            errors[k].push(1e3 * error);
        }
        times.push(time);
        simulation.advance_to(time + PERIOD)?;
    }
    println!("{} poses in {end} s, torques each {} ms; largest errors on the way:", POSES.len(), 1e3 * PERIOD);
    for (name, largest) in names.iter().zip(&largest) {
        println!("  {name:<12} {largest:.1e}");
    }
    let curves = names.iter().zip(errors).map(|(name, values)| Curve { label: name, values }).collect();
    let (x_label, y_label) = ("time [s]", "error [mrad, mm]");
    let plot = Plot { title: "Errors on the way from pose to pose", x_label, y_label, x: &times, curves };
    panels(&[plot], Size::default(), Path::new("out/example-08"), "errors")?;
    println!("see out/example-08/errors.svg");
    Ok(())
}
