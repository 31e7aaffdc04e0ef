//! Robots against Pinocchio: forward and inverse dynamics, and on a fixed base the mass matrix.

use nalgebra::{Quaternion, UnitQuaternion, Vector3};
use serde_json::Value;
use sim::{At, Kernel, Model, load};
use std::fs;
use std::sync::Arc;
use tests::called::{called, difference, numbers};

fn robots() -> String {
    format!("{}/robots", env!("CARGO_MANIFEST_DIR"))
}

fn declared(name: &str) -> (Arc<dyn Model>, Value) {
    let text = fs::read_to_string(format!("{}/reference.json", robots())).unwrap();
    let model = load(format!("{}/declared/{}.rs", robots(), name.to_lowercase()), None).unwrap();
    (model, serde_json::from_str(&text).unwrap())
}

fn agrees(name: &str, bound: f64) {
    let (model, reference) = declared(name);
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

/// Coordinates with their speeds and accelerations.
type Motion = [Vec<f64>; 3];

/// A state in Pinocchio's coordinates, x y z and the quaternion x y z w, with velocities in the base's own frame at its origin
/// and their rates, in those of a free body: of its centre of mass, with the scalar part of
/// the quaternion first, after the joints.
fn of_free_body(q: &[f64], v: &[f64], a: &[f64], centre: [f64; 3]) -> Motion {
    let r = UnitQuaternion::from_quaternion(Quaternion::new(q[6], q[3], q[4], q[5]));
    let of = |all: &[f64], first: usize| Vector3::new(all[first], all[first + 1], all[first + 2]);
    let (c, w, rate) = (Vector3::from(centre), of(v, 3), of(a, 3));
    let velocity = of(v, 0) + w.cross(&c);
    let acceleration = of(a, 0) + w.cross(&velocity) + rate.cross(&c);
    let turned = |by: Vector3<f64>| r.quaternion() * Quaternion::from_imag(by) * 0.5;
    // (q w)'/2 = q w'/2 + q w w/4, and w w = -w.w.
    let quaternions = [*r.quaternion(), turned(w), turned(rate) - r.quaternion() * (w.norm_squared() / 4.0)];
    let places = [of(q, 0) + r * c, r * velocity, r * acceleration];
    let joints = [&q[7..], &v[6..], &a[6..]];
    std::array::from_fn(|i| {
        let Quaternion { coords: x } = quaternions[i];
        let base = places[i].iter().copied().chain([x.w, x.x, x.y, x.z]);
        joints[i].iter().copied().chain(base).collect()
    })
}

/// Without torques: forward dynamics, and inverse dynamics, which need none.
fn agrees_with_a_free_base(name: &str, bound: f64) {
    let (model, reference) = declared(name);
    let centre = numbers(&reference[format!("{name}_base_centre_of_mass")]).try_into().unwrap();
    for state in reference[name].as_array().unwrap() {
        let of = |what: &str| numbers(&state[what]);
        let [q, qd, a] = of_free_body(&of("q"), &of("v"), &of("a"), centre);
        let at = At { time: 0.0, positions: &q, speeds: &qd, accelerations: &a, multipliers: &[0.0] };
        let found = called(&*model, Kernel::Dynamics, at);
        let [accelerations, multiplier] = [&found[..q.len()], &found[q.len()..=q.len()]];
        let found = difference(accelerations, &a);
        assert!(found < bound, "{name}: {found}");
        assert_eq!(multiplier, [0.0], "nothing acts along the quaternion");
        let largest = |row: &[f64]| row.iter().fold(0.0, |largest: f64, x| largest.max(x.abs()));
        let mass = called(&*model, Kernel::MassMatrix, at);
        let needed = called(&*model, Kernel::InverseDynamics, at);
        let found = largest(&needed) / (largest(&mass) * largest(&a));
        assert!(found < bound, "{name}: {found}");
    }
}

/// As for the arms, with worse conditions: Talos' hands weigh a thousandth of what stands behind them.
#[test]
fn anymal_and_talos_with_free_bases() {
    agrees_with_a_free_base("Anymal", 1e-12);
    agrees_with_a_free_base("Talos", 1e-11);
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
