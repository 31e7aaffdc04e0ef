//! Where the joints and axes of a spatial linkage are at its start.

use super::topology::Spatial;
use tests::Random;

pub(crate) type Vector = [f64; 3];

/// A spatial linkage of size 1 at its start, turned at random.
pub(crate) struct SpatialPose {
    /// Where each joint is.
    pub(crate) places: Vec<Vector>,
    /// Its axis, and at right angles to that the second one of a universal joint.
    pub(crate) axes: Vec<[Vector; 2]>,
    /// The centre of mass of each body.
    pub(crate) centres: Vec<Vector>,
    /// The length of each body.
    pub(crate) lengths: Vec<f64>,
}

pub(crate) fn pose(linkage: &Spatial, random: &mut Random) -> SpatialPose {
    let (places, axes) = match linkage.name {
        "Bennett" => bennett(random),
        "Bricard" => bricard(),
        _ => anywhere(linkage, random),
    };
    let rows = random_rotation(random);
    let turn = |v: &Vector| rows.map(|row| inner(&row, v));
    let places: Vec<Vector> = places.iter().map(turn).collect();
    let second = |axis: Vector| {
        // Any direction that is not along the axis.
        let across = if axis[0].abs() < 0.7 { [1.0, 0.0, 0.0] } else { [0.0, 1.0, 0.0] };
        unit(cross(&axis, &across))
    };
    let axes = axes.iter().map(turn).map(unit).map(|axis| [axis, second(axis)]).collect();
    let is_top = linkage.joints.len() == 1;
    let end = |b: usize| if is_top { std::array::from_fn(|i| places[0][i] + 0.6 * rows[0][i]) } else { places[b + 1] };
    let ends: Vec<[Vector; 2]> = (0..linkage.bodies()).map(|b| [places[b], end(b)]).collect();
    SpatialPose {
        axes,
        centres: ends.iter().map(|[p, q]| std::array::from_fn(|i| (p[i] + q[i]) / 2.0)).collect(),
        lengths: ends.iter().map(|[p, q]| length(&std::array::from_fn(|i| q[i] - p[i]))).collect(),
        places,
    }
}

fn anywhere(linkage: &Spatial, random: &mut Random) -> (Vec<Vector>, Vec<Vector>) {
    let count = linkage.joints.len();
    loop {
        let mut vector = || std::array::from_fn::<f64, 3, _>(|_| random.between(-1.0, 1.0));
        let places: Vec<Vector> = (0..count).map(|_| vector()).collect();
        let axes: Vec<Vector> = (0..count).map(|_| vector()).collect();
        let apart = |i: usize, j: usize| length(&std::array::from_fn(|k| places[i][k] - places[j][k]));
        let is_spread = (0..count).all(|i| (0..i).all(|j| apart(i, j) > 0.4));
        if is_spread && axes.iter().all(|axis| length(axis) > 0.3) {
            return (places, axes);
        }
    }
}

/// Bennett's loop: bars a, b, a, b with twists alpha and beta, b sin(alpha) = a sin(beta), by its closed form (Hunt,
/// Kinematic Geometry of Mechanisms, 1978, section 10.3).
fn bennett(random: &mut Random) -> (Vec<Vector>, Vec<Vector>) {
    let (a, b) = (random.between(0.5, 1.0), random.between(0.5, 1.0));
    let (shorter, longer) = (a.min(b), a.max(b));
    let alpha: f64 = random.between(0.3, 1.2);
    // The longer pair has the larger twist.
    let (alpha, beta) = if a > b {
        (alpha, (shorter * alpha.sin() / longer).asin())
    } else {
        ((shorter * alpha.sin() / longer).asin(), alpha)
    };
    let theta1: f64 = random.between(0.6, 2.4);
    let product = ((beta + alpha) / 2.0).sin() / ((beta - alpha) / 2.0).sin();
    let theta2 = 2.0 * (product / (theta1 / 2.0).tan()).atan();
    let r1 = about_z(theta1);
    let r1_twisted = times(&r1, &about_x(alpha));
    let r2 = times(&r1_twisted, &about_z(theta2));
    let p2 = r1.map(|row| a * row[0]);
    let p3 = std::array::from_fn(|i| p2[i] + b * r2[i][0]);
    let third = times(&r2, &about_x(beta));
    let axis = |r: &[Vector; 3]| r.map(|row| row[2]);
    let places = vec![[0.0; 3], p2, p3, [-b, 0.0, 0.0]];
    (places, vec![[0.0, 0.0, 1.0], axis(&r1_twisted), axis(&third), [0.0, beta.sin(), beta.cos()]])
}

/// Bricard's loop of six equal bars at right angles (problem A05 of the IFToMM benchmark library).
fn bricard() -> (Vec<Vector>, Vec<Vector>) {
    let places =
        vec![[0.0, 0.0, 0.0], [1.0, 0.0, 0.0], [1.0, -1.0, 0.0], [1.0, -1.0, 1.0], [0.0, -1.0, 1.0], [0.0, 0.0, 1.0]];
    let [x, y, z] = [[1.0, 0.0, 0.0], [0.0, 1.0, 0.0], [0.0, 0.0, 1.0]];
    (places, vec![y, z, x, y, z, x])
}

fn about_x(angle: f64) -> [Vector; 3] {
    let (s, c) = angle.sin_cos();
    [[1.0, 0.0, 0.0], [0.0, c, -s], [0.0, s, c]]
}

fn about_z(angle: f64) -> [Vector; 3] {
    let (s, c) = angle.sin_cos();
    [[c, -s, 0.0], [s, c, 0.0], [0.0, 0.0, 1.0]]
}

fn times(a: &[Vector; 3], b: &[Vector; 3]) -> [Vector; 3] {
    a.map(|row| std::array::from_fn(|j| (0..3).map(|k| row[k] * b[k][j]).sum()))
}

fn random_rotation(random: &mut Random) -> [Vector; 3] {
    let u = unit(std::array::from_fn(|_| random.between(-1.0, 1.0)));
    let v = unit(cross(&u, &std::array::from_fn(|_| random.between(-1.0, 1.0))));
    [u, v, cross(&u, &v)]
}

fn inner(a: &Vector, b: &Vector) -> f64 {
    a.iter().zip(b).map(|(a, b)| a * b).sum()
}

fn length(a: &Vector) -> f64 {
    inner(a, a).sqrt()
}

fn unit(a: Vector) -> Vector {
    let length = length(&a);
    a.map(|a| a / length)
}

fn cross(a: &Vector, b: &Vector) -> Vector {
    [a[1] * b[2] - a[2] * b[1], a[2] * b[0] - a[0] * b[2], a[0] * b[1] - a[1] * b[0]]
}
