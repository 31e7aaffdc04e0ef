//! Coordinates in which an unsteady motion may be steady.

use sim_kernel::{Description, Mechanism};
use sim_runtime::{State, quaternions};

/// What is said of a state at a corner.
pub(crate) const CORNER: &str =
    "what acts has a corner or a jump here: small motions differ to either side, and these are those of one side";

/// The advice if these coordinates make A change; none if none do.
pub(crate) fn advice<M: Mechanism>(mechanism: &M, state: &State<M>, unsteady: &[usize]) -> Option<String> {
    if unsteady.is_empty() {
        return None;
    }
    let (q, qd) = (state.positions.as_ref(), state.speeds.as_ref());
    let advice = quaternions(mechanism).into_iter().filter(|four| four.iter().any(|j| unsteady.contains(j)));
    let advice: Vec<String> = advice.filter_map(|four| of_quaternion(mechanism.description(), four, q, qd)).collect();
    Some(match advice.is_empty() {
        false => advice.join(". "),
        true => "a steady motion changes only coordinates that nothing depends on, at constant speeds, as the angles about the \
                 axes that it turns about"
            .into(),
    })
}

/// The angles to use instead of a quaternion: the last turns about the spin axis of the body, and the middle one is far
/// from a right angle.
fn of_quaternion(description: &Description, four: [usize; 4], positions: &[f64], speeds: &[f64]) -> Option<String> {
    const AXES: [&str; 3] = ["x", "y", "z"];
    let (q, qd) = (four.map(|j| positions[j]), four.map(|j| speeds[j]));
    let spin = own_angular_velocity(q, qd);
    let fastest = (0..3).max_by(|i, j| spin[*i].abs().total_cmp(&spin[*j].abs())).filter(|i| spin[*i] != 0.0)?;
    let [first, second] = [(fastest + 1) % 3, (fastest + 2) % 3];
    let direction = axis(q, fastest);
    // The sine of the middle angle is the component along the first axis. If both sequences work, yaw comes first.
    let first_is_better = match direction[first].abs() - direction[second].abs() {
        apart if apart.abs() > 1e-9 => apart < 0.0,
        _ => second != 2,
    };
    let order =
        if first_is_better { [first, second, fastest] } else { [second, first, fastest] }.map(|i| AXES[i]).concat();
    let names = four.map(|j| description.coordinates[j].position.name).join(", ");
    Some(format!(
        "{names} turn with their body, which spins at {:.6} rad/s about its own {}: in angles, `attitude euler({order}, ..)`, or joints \
         about these axes one after the other, a steady spin changes the last angle alone",
        spin[fastest], AXES[fastest]
    ))
}

/// 2 conj(q) q' / q.q: the angular velocity in the body's frame.
fn own_angular_velocity(q: [f64; 4], qd: [f64; 4]) -> [f64; 3] {
    let square: f64 = q.iter().map(|q| q * q).sum();
    let entry = |i: usize| {
        let (j, k) = (i % 3 + 1, (i + 1) % 3 + 1);
        2.0 * (q[0] * qd[i] - qd[0] * q[i] - (q[j] * qd[k] - q[k] * qd[j])) / square
    };
    [1, 2, 3].map(entry)
}

/// A body's own axis in the world.
fn axis(q: [f64; 4], axis: usize) -> [f64; 3] {
    let square: f64 = q.iter().map(|q| q * q).sum();
    let (i, j, k) = (axis + 1, (axis + 1) % 3 + 1, (axis + 2) % 3 + 1);
    let mut direction = [0.0; 3];
    direction[i - 1] = (q[0] * q[0] + q[i] * q[i] - q[j] * q[j] - q[k] * q[k]) / square;
    direction[j - 1] = 2.0 * (q[i] * q[j] + q[0] * q[k]) / square;
    direction[k - 1] = 2.0 * (q[i] * q[k] - q[0] * q[j]) / square;
    direction
}
