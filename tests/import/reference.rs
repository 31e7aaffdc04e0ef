//! The shipped robots against Pinocchio: forward and inverse dynamics and the mass matrix, from `tests/robots/urdf/reference.json`.

use crate::{ARM, QUADRUPED, declared, imported};
use serde_json::Value;
use sim::import::urdf::{Base, Mimic, Options};
use sim::{At, Kernel};
use tests::called::{called, difference, numbers};

const REFERENCE: &str = include_str!("../robots/urdf/reference.json");

/// Quarter turns are written with 14 digits in the arm, and meant exactly here; all else is rounding.
const BOUND: f64 = 1e-12;

fn agrees(name: &str, text: &str, base: Base, mass: Kernel) {
    let options = Options { base, mimic: Mimic::Free, damping: false, ..Options::default() };
    let model = declared(&imported(text, &options).text);
    let reference: Value = serde_json::from_str(REFERENCE).unwrap();
    for state in reference[name].as_array().unwrap() {
        let of = |what: &str| numbers(&state[what]);
        let (q, qd, a) = (of("q"), of("qd"), of("qdd"));
        let multipliers = vec![0.0; model.description().constraints.len()];
        let at = At { time: 0.0, positions: &q, speeds: &qd, accelerations: &a, multipliers: &multipliers };
        let forward = called(&*model, Kernel::Dynamics, at);
        let differences = [
            difference(&forward[..q.len()], &of("forward")),
            difference(&called(&*model, Kernel::InverseDynamics, at), &of("inverse")),
            difference(&called(&*model, mass, at), &of("mass")),
        ];
        assert!(differences.iter().all(|difference| *difference < BOUND), "{name}: {differences:?}");
    }
}

#[test]
fn shipped_robots_move_as_in_pinocchio() {
    agrees("arm fixed", ARM, Base::Fixed, Kernel::MassMatrix);
    agrees("arm free", ARM, Base::Free, Kernel::SpeedMassMatrix);
    agrees("quadruped fixed", QUADRUPED, Base::Fixed, Kernel::MassMatrix);
    agrees("quadruped free", QUADRUPED, Base::Free, Kernel::SpeedMassMatrix);
}
