//! A spatial linkage at its start, in the frames of Denavit and Hartenberg.

use super::topology::Spatial;
use std::f64::consts::FRAC_PI_2;
use tests::Random;

pub(crate) type Vector = [f64; 3];

/// A spatial linkage of size 1 at its start.
pub(crate) struct SpatialPose {
    /// Length and twist of each body, from joint to joint.
    pub(crate) bars: Vec<[f64; 2]>,
    /// Where the ground has the last joint, and its twist.
    pub(crate) ground: (Vector, f64),
    /// The turn at each joint, and the second turn of a universal joint.
    pub(crate) turns: Vec<[f64; 2]>,
    /// The attitude of each body, and where its first joint is.
    pub(crate) frames: Vec<(Quaternion, Vector)>,
}

pub(crate) fn pose(linkage: &Spatial, random: &mut Random) -> SpatialPose {
    match linkage.name {
        "Bennett" => bennett(random),
        "Bricard" => bricard(),
        "Top" => SpatialPose {
            bars: vec![[1.0, 0.0]],
            ground: ([1.0, 0.0, 0.0], 0.0),
            turns: vec![[0.0; 2]],
            frames: vec![(Quaternion([1.0, 0.0, 0.0, 0.0]), [0.0; 3])],
        },
        _ => four_bar(random),
    }
}

/// A crank, a coupler on a universal joint, a ball, and a rocker, anywhere.
fn four_bar(random: &mut Random) -> SpatialPose {
    loop {
        let mut some = |low: f64, high: f64| random.between(low, high);
        let ground = ([some(-1.0, 1.0), some(-1.0, 1.0), some(-1.0, 1.0)], some(-1.5, 1.5));
        let (crank, rocker) = ([some(0.2, 0.6), some(-1.5, 1.5)], [some(0.4, 1.0), some(-1.5, 1.5)]);
        let (first, last) = (some(-3.0, 3.0), some(-3.0, 3.0));
        let start = Quaternion::about(2, first);
        let end = Quaternion::about(0, -ground.1) * Quaternion::about(2, -last) * Quaternion::about(0, -rocker[1]);
        let pin = start.turned([crank[0], 0.0, 0.0]);
        let reach = end.turned([rocker[0], 0.0, 0.0]);
        let ball: Vector = std::array::from_fn(|i| ground.0[i] - reach[i]);
        let way: Vector = std::array::from_fn(|i| ball[i] - pin[i]);
        let length = way.iter().map(|x| x * x).sum::<f64>().sqrt();
        let bearing = start * Quaternion::about(0, crank[1]);
        let [x, y, z] = bearing.inverse().turned(way).map(|x| x / length);
        // Neither a short coupler nor one beside the universal joint's lock.
        if length < 0.4 || z.abs() > 0.8 {
            continue;
        }
        let (about_z, about_y) = (y.atan2(x), -z.asin());
        let middle = bearing * Quaternion::about(2, about_z) * Quaternion::about(1, about_y);
        return SpatialPose {
            bars: vec![crank, [length, 0.0], rocker],
            ground,
            turns: vec![[first, 0.0], [about_z, about_y], [0.0; 2], [last, 0.0]],
            frames: vec![(start, [0.0; 3]), (middle, pin), (end, ball)],
        };
    }
}

/// Bars a, b, a, b with twists alpha, beta, and a sin(beta) = b sin(alpha) (Hunt, Kinematic Geometry of Mechanisms, 1978,
/// section 10.3).
fn bennett(random: &mut Random) -> SpatialPose {
    let b = random.between(0.4, 0.8);
    let a = b * random.between(1.1, 1.8);
    let alpha: f64 = random.between(0.3, 1.2);
    let beta = (b * alpha.sin() / a).asin();
    let theta1: f64 = random.between(0.6, 2.4);
    let product = ((beta + alpha) / 2.0).sin() / ((beta - alpha) / 2.0).sin();
    let theta2 = 2.0 * (product / (theta1 / 2.0).tan()).atan();
    let bars = vec![[a, alpha], [b, beta], [a, alpha]];
    chain(bars, ([-b, 0.0, 0.0], beta), &[theta1, theta2, -theta1, -theta2])
}

/// Bricard's loop of six equal bars at right angles (problem A05 of the IFToMM benchmark library), along edges of a cube.
fn bricard() -> SpatialPose {
    let quarters = |counts: [f64; 6]| counts.map(|count| count * FRAC_PI_2);
    let twists = quarters(BRICARD_TWISTS);
    let bars = twists[..5].iter().map(|twist| [1.0, *twist]).collect();
    chain(bars, ([-1.0, 0.0, 0.0], twists[5]), &quarters(BRICARD_TURNS))
}

/// In right angles.
const BRICARD_TWISTS: [f64; 6] = [1.0, -1.0, 1.0, -1.0, 1.0, -1.0];
const BRICARD_TURNS: [f64; 6] = [-1.0; 6];

/// A loop of hinges from its turns.
fn chain(bars: Vec<[f64; 2]>, ground: (Vector, f64), turns: &[f64]) -> SpatialPose {
    let (mut frames, mut frame, mut place) = (Vec::new(), Quaternion([1.0, 0.0, 0.0, 0.0]), [0.0; 3]);
    for ([length, twist], turn) in bars.iter().zip(turns) {
        frame = frame * Quaternion::about(2, *turn);
        frames.push((frame, place));
        let way = frame.turned([*length, 0.0, 0.0]);
        place = std::array::from_fn(|i| place[i] + way[i]);
        frame = frame * Quaternion::about(0, *twist);
    }
    SpatialPose { bars, ground, turns: turns.iter().map(|turn| [*turn, 0.0]).collect(), frames }
}

/// A rotation, scalar part first.
#[derive(Clone, Copy)]
pub(crate) struct Quaternion(pub(crate) [f64; 4]);

impl Quaternion {
    /// About one of the axes x, y, z.
    fn about(axis: usize, angle: f64) -> Quaternion {
        let mut parts = [(angle / 2.0).cos(), 0.0, 0.0, 0.0];
        parts[axis + 1] = (angle / 2.0).sin();
        Quaternion(parts)
    }

    pub(crate) fn inverse(self) -> Quaternion {
        let [a, b, c, d] = self.0;
        Quaternion([a, -b, -c, -d])
    }

    pub(crate) fn turned(self, [x, y, z]: Vector) -> Vector {
        let [_, x, y, z] = (self * Quaternion([0.0, x, y, z]) * self.inverse()).0;
        [x, y, z]
    }
}

impl std::ops::Mul for Quaternion {
    type Output = Quaternion;

    fn mul(self, other: Quaternion) -> Quaternion {
        let ([a, b, c, d], [e, f, g, h]) = (self.0, other.0);
        Quaternion([
            a * e - b * f - c * g - d * h,
            a * f + b * e + c * h - d * g,
            a * g - b * h + c * e + d * f,
            a * h + b * g - c * f + d * e,
        ])
    }
}
