//! Places and attitudes in numbers.

use super::robot::Origin;
use nalgebra::{Matrix3, Vector3};
use std::f64::consts::FRAC_PI_2;

/// A place and an attitude.
#[derive(Clone, Copy, PartialEq, Debug)]
pub(super) struct Pose {
    pub(super) place: Vector3<f64>,
    pub(super) rotation: Matrix3<f64>,
}

impl Pose {
    pub(super) fn none() -> Pose {
        Pose { place: Vector3::zeros(), rotation: Matrix3::identity() }
    }

    /// That of a frame whose origin stands in the frame of this pose.
    pub(super) fn then(&self, origin: &Origin) -> Pose {
        Pose { place: self.place + self.rotation * origin.vector(), rotation: self.rotation * origin.rotation }
    }
}

/// The rotation by roll, pitch and yaw: about x, y and z of the frame before, in this order. Angles within `straight` of quarter
/// turns are such.
pub(super) fn roll_pitch_yaw(rpy: [f64; 3], straight: f64) -> Matrix3<f64> {
    let [(sr, cr), (sp, cp), (sy, cy)] = rpy.map(|angle| sine_cosine(angle, straight));
    let roll = Matrix3::new(1.0, 0.0, 0.0, 0.0, cr, -sr, 0.0, sr, cr);
    let pitch = Matrix3::new(cp, 0.0, sp, 0.0, 1.0, 0.0, -sp, 0.0, cp);
    let yaw = Matrix3::new(cy, -sy, 0.0, sy, cy, 0.0, 0.0, 0.0, 1.0);
    // Adding 0 makes -0 a 0.
    (yaw * pitch * roll).map(|x| x + 0.0)
}

fn sine_cosine(angle: f64, straight: f64) -> (f64, f64) {
    // Of many turns rounding leaves no quarter.
    let is_many = quarters(angle).abs() > 1e3;
    if is_many || (!is_straightened(angle, straight) && quarters(angle) * FRAC_PI_2 != angle) {
        return angle.sin_cos();
    }
    match quarters(angle).rem_euclid(4.0) as u8 {
        0 => (0.0, 1.0),
        1 => (1.0, 0.0),
        2 => (0.0, -1.0),
        _ => (-1.0, 0.0),
    }
}

fn quarters(angle: f64) -> f64 {
    (angle / FRAC_PI_2).round()
}

/// Whether an angle is taken as a number of quarter turns that it is not quite.
pub(super) fn is_straightened(angle: f64, straight: f64) -> bool {
    let exact = quarters(angle) * FRAC_PI_2;
    angle != exact && (angle - exact).abs() <= straight
}

/// The quaternion q0, q1, q2, q3 of a rotation.
pub(super) fn quaternion(rotation: &Matrix3<f64>) -> [f64; 4] {
    let rotation = nalgebra::Rotation3::from_matrix_unchecked(*rotation);
    let q = nalgebra::UnitQuaternion::from_rotation_matrix(&rotation);
    [q.w, q.i, q.j, q.k]
}

#[cfg(test)]
mod tests {
    use super::*;

    /// Against nalgebra's own angles, and quarter turns exactly.
    #[test]
    fn rotations_are_those_of_roll_pitch_and_yaw() {
        for rpy in [[0.3, -1.2, 2.0], [0.0, 0.4, 0.0], [3.0, 3.1, -3.0]] {
            let known = nalgebra::Rotation3::from_euler_angles(rpy[0], rpy[1], rpy[2]);
            assert!((roll_pitch_yaw(rpy, 1e-11) - known.matrix()).abs().max() < 1e-15, "{rpy:?}");
        }
        let exact = Matrix3::new(0.0, 0.0, 1.0, 1.0, 0.0, 0.0, 0.0, 1.0, 0.0);
        // As files write it: with 12 digits, and with 5.
        let [long, short] = [FRAC_PI_2 - 4.9e-12, FRAC_PI_2 + 3.7e-6];
        assert_eq!(roll_pitch_yaw([long, 0.0, FRAC_PI_2], 1e-11), exact);
        assert_ne!(roll_pitch_yaw([short, 0.0, FRAC_PI_2], 1e-11), exact);
        assert_eq!(roll_pitch_yaw([short, 0.0, FRAC_PI_2], 1e-5), exact);
        assert_eq!(roll_pitch_yaw([1e17, 0.0, 0.0], 1e-11)[(1, 1)], 1e17f64.cos());
        assert_eq!(roll_pitch_yaw([-3.0 * FRAC_PI_2, 0.0, -7.0 * FRAC_PI_2], 1e-11), exact);
    }

    #[test]
    fn a_rotations_quaternion_turns_as_it_does() {
        let rotation = roll_pitch_yaw([0.3, -1.2, 2.0], 1e-11);
        let [w, x, y, z] = quaternion(&rotation);
        let turned = nalgebra::UnitQuaternion::from_quaternion(nalgebra::Quaternion::new(w, x, y, z));
        assert!((turned.to_rotation_matrix().matrix() - rotation).abs().max() < 1e-15);
    }
}
