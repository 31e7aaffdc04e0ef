//! Derivatives along trees of links against dual numbers.

use crate::links::{CONDITION, assert_close, called, vector};
use crate::trees::{ARM, BRANCHES, DRIVEN, FREE, LIMB, scaled};
use sim::{At, Kernel};
use tests::Random;

/// Derivatives along the tree are those of `dynamics`: by dual numbers where they are no kernel. The coordinates in `lengths` are
/// lengths.
pub(crate) fn derivatives_are_those_of_dynamics(text: &str, lengths: &[usize]) {
    let (before, _) = text.split_once("kernels {").unwrap();
    let [with_kernel, without] =
        ["dynamics_jacobian", "inverse_dynamics"].map(|kernel| format!("{before} kernels {{ {kernel}; }}"));
    let random = &mut Random(5);
    for (length, mass) in [(1.0, 1.0), (1e-3, 1e-3), (100.0, 1e3)] {
        let [kernel, duals] = [&with_kernel, &without].map(|text| scaled(text, length, mass));
        assert_eq!(kernel.description().optional_kernels, ["dynamics_jacobian"]);
        let size = |i: usize| if lengths.contains(&i) { length } else { 1.0 };
        for _ in 0..5 {
            let [start, _] = kernel.initial();
            let moved: Vec<f64> = (0..start.len()).map(|i| start[i] + size(i) * random.between(-0.7, 0.7)).collect();
            let qd: Vec<f64> = (0..start.len()).map(|i| size(i) * random.between(-0.7, 0.7)).collect();
            let at = At { time: 0.4, positions: &moved, speeds: &qd, accelerations: &[], multipliers: &[] };
            let [found, expected] = [&kernel, &duals].map(|model| called(&**model, Kernel::DynamicsJacobian, at));
            assert_eq!(found.len(), expected.len());
            let n = start.len();
            let m = kernel.description().constraints.len();
            let unit = |i: usize, j: usize| match i < 2 * n {
                true => size(j) / size(i % n),
                false => size(j) / (mass * length * length),
            };
            // Where nothing acts along a quaternion multipliers are roundings of other forces.
            let forces = vector(&*duals, Kernel::GeneralizedForces, at).into_iter().enumerate();
            let forces = forces.map(|(i, force)| force.abs() * size(i) / (mass * length * length)).fold(0.0, f64::max);
            let [accelerations, multipliers] = [0..2 * n, 2 * n..2 * (n + m)];
            for rows in [accelerations, multipliers] {
                let scaled = |all: &[Vec<f64>]| -> Vec<f64> {
                    let places = rows.clone().flat_map(|i| (0..n).map(move |j| (i, j)));
                    places.map(|(i, j)| all[i][j] * unit(i, j)).collect()
                };
                let [found, expected] = [scaled(&found), scaled(&expected)];
                let size = CONDITION * expected.iter().fold(forces, |size: f64, x| size.max(x.abs()));
                for (found, expected) in found.iter().zip(&expected) {
                    assert_close("derivative", *found, *expected, size);
                }
            }
        }
    }
}

#[test]
fn derivatives_of_a_free_base() {
    derivatives_are_those_of_dynamics(FREE, &[2, 3, 4]);
}

#[test]
fn derivatives_of_a_limb_of_many_joints() {
    derivatives_are_those_of_dynamics(LIMB, &[3, 11, 12, 13, 18, 19, 20]);
}

#[test]
fn derivatives_of_an_arm_on_the_ground() {
    derivatives_are_those_of_dynamics(ARM, &[2]);
    // Weights that depend on the state.
    let swung = ARM.replace("gravity [1 [m/s^2], 0,", "gravity [1 [m/s^2], 0.3 [m/s^2]*sin(b),");
    assert_ne!(swung, ARM);
    derivatives_are_those_of_dynamics(&swung, &[2]);
}

#[test]
fn derivatives_of_branches() {
    // Only the first of them turns once.
    let (once, driven) = (BRANCHES.replace("rotation(x, 0.3 - 2*b)", "rotation(x, 0.3)"), DRIVEN);
    assert_ne!(once, BRANCHES);
    derivatives_are_those_of_dynamics(&once, &[2]);
    derivatives_are_those_of_dynamics(BRANCHES, &[2]);
    derivatives_are_those_of_dynamics(driven, &[]);
}
