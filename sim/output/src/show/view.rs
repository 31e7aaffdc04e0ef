//! The projection of spatial figures: from afar, with z upwards.

use super::scene::Point;

/// The direction of view, in radians: about z from x, and above the plane of x and y.
const AZIMUTH: f64 = -1.05;
const ELEVATION: f64 = 0.4;
/// The corners of a circle.
const CORNERS: u32 = 90;

/// A point or vector of the plane or of space as it lies on the sheet, right and upwards.
pub(super) fn seen(place: &[f64]) -> Point {
    match *place {
        [x, y, z] => {
            let ((sin_a, cos_a), (sin_e, cos_e)) = (AZIMUTH.sin_cos(), ELEVATION.sin_cos());
            (cos_a * y - sin_a * x, cos_e * z - sin_e * (cos_a * x + sin_a * y))
        }
        [x, y] => (x, y),
        _ => (f64::NAN, f64::NAN),
    }
}

/// The direction of a vector of space on the sheet.
pub(super) fn angle(direction: &[f64]) -> f64 {
    let (x, y) = seen(direction);
    y.atan2(x)
}

/// A circle of space by centre, radius and normal, as a closed polyline on the sheet.
pub(super) fn circle(centre: &[f64], radius: f64, normal: &[f64]) -> Vec<Point> {
    let (u, v) = across(normal);
    let corner = |step: u32| {
        let (sine, cosine) = (std::f64::consts::TAU * f64::from(step) / f64::from(CORNERS)).sin_cos();
        let place: Vec<f64> = (0..3).map(|i| centre[i] + radius * (cosine * u[i] + sine * v[i])).collect();
        seen(&place)
    };
    (0..=CORNERS).map(corner).collect()
}

/// Two unit vectors at right angles to a vector and to each other.
fn across(normal: &[f64]) -> ([f64; 3], [f64; 3]) {
    let [x, y, z] = unit([normal[0], normal[1], normal[2]]);
    // The axis farthest from the normal.
    let other = if x.abs() <= y.abs() && x.abs() <= z.abs() {
        [1.0, 0.0, 0.0]
    } else if y.abs() <= z.abs() {
        [0.0, 1.0, 0.0]
    } else {
        [0.0, 0.0, 1.0]
    };
    let u = unit(cross([x, y, z], other));
    (u, cross([x, y, z], u))
}

fn unit(vector: [f64; 3]) -> [f64; 3] {
    let length = vector.iter().map(|part| part * part).sum::<f64>().sqrt();
    vector.map(|part| part / length)
}

fn cross(a: [f64; 3], b: [f64; 3]) -> [f64; 3] {
    [a[1] * b[2] - a[2] * b[1], a[2] * b[0] - a[0] * b[2], a[0] * b[1] - a[1] * b[0]]
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn the_sheet_shows_z_upwards_x_and_y_to_the_right_and_keeps_lengths_across_the_view() {
        let [x, y, z] = [[1.0, 0.0, 0.0], [0.0, 1.0, 0.0], [0.0, 0.0, 1.0]].map(|axis| seen(&axis));
        assert!(z.0 == 0.0 && z.1 > 0.9 && x.0 > 0.0 && y.0 > 0.0 && x.1 > 0.0 && y.1 < 0.0 || y.1 > 0.0);
        // The columns of a projection along a unit vector: its squares sum to two.
        let sum: f64 = [x, y, z].iter().map(|p| p.0 * p.0 + p.1 * p.1).sum();
        assert!((sum - 2.0).abs() < 1e-14);
    }

    #[test]
    fn a_circle_seen_has_its_radius_at_its_widest() {
        for normal in [[0.0, 0.0, 2.0], [1.0, 0.0, 0.0], [0.3, -0.4, 0.5], [1.0, 1.0, 1.0]] {
            let points = circle(&[0.0, 0.0, 0.0], 0.5, &normal);
            let widest = points.iter().map(|p| p.0.hypot(p.1)).fold(0.0, f64::max);
            assert!((widest - 0.5).abs() < 2e-3, "{normal:?}: {widest}");
            assert_eq!(points.len(), CORNERS as usize + 1);
        }
    }
}
