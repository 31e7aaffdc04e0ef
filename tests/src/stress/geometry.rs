//! Where the joints of a linkage are at its start, and what follows for each body.

use super::topology::{Body, Joint, Planar};
use tests::Random;

/// A linkage of size 1 at its start.
pub(crate) struct Pose {
    /// Where each joint is.
    pub(crate) joints: Vec<[f64; 2]>,
    /// The angle of each body's frame.
    pub(crate) angles: Vec<f64>,
    /// Its centre of mass.
    pub(crate) centres: Vec<[f64; 2]>,
    /// The largest distance between two of its joints.
    pub(crate) extents: Vec<f64>,
}

/// A random pose. Joints are drawn first and sizes follow from them, so that every pose closes.
pub(crate) fn pose(linkage: &Planar, random: &mut Random) -> Pose {
    loop {
        let joints = joints(linkage, random);
        let of_bodies: Vec<Vec<[f64; 2]>> = (0..linkage.bodies.len()).map(|b| of_body(linkage, &joints, b)).collect();
        let nearest = of_bodies.iter().flat_map(|points| distances(points)).fold(f64::INFINITY, f64::min);
        // Shorter links beside longer ones make motions of two time scales.
        if nearest < 0.25 {
            continue;
        }
        let angle = |(b, points): (usize, &Vec<[f64; 2]>)| match linkage.bodies[b] {
            Body::Bar => (points[1][1] - points[0][1]).atan2(points[1][0] - points[0][0]),
            Body::Plate => random.between(-3.0, 3.0),
            Body::Piston => 0.0,
        };
        let angles = of_bodies.iter().enumerate().map(angle).collect();
        let share = |points: &Vec<[f64; 2]>| {
            let sum = points.iter().fold([0.0; 2], |sum, point| [sum[0] + point[0], sum[1] + point[1]]);
            sum.map(|sum| sum / points.len() as f64)
        };
        let extents = of_bodies.iter().map(|points| distances(points).fold(0.3, f64::max)).collect();
        return Pose { joints, angles, centres: of_bodies.iter().map(share).collect(), extents };
    }
}

fn of_body(linkage: &Planar, joints: &[[f64; 2]], body: usize) -> Vec<[f64; 2]> {
    let holds = |Joint(a, b): &Joint| *a == Some(body) || *b == body;
    (0..joints.len()).filter(|j| holds(&linkage.joints[*j])).map(|j| joints[j]).collect()
}

/// The distances of points that are not the same.
fn distances(points: &[[f64; 2]]) -> impl Iterator<Item = f64> {
    let between = |i: usize, j: usize| (points[i][0] - points[j][0]).hypot(points[i][1] - points[j][1]);
    (0..points.len()).flat_map(move |i| (0..i).map(move |j| between(i, j))).filter(|distance| *distance > 0.0)
}

fn joints(linkage: &Planar, random: &mut Random) -> Vec<[f64; 2]> {
    let mut point = || [random.between(-1.0, 1.0), random.between(-1.0, 1.0)];
    let mut joints: Vec<[f64; 2]> = linkage.joints.iter().map(|_| point()).collect();
    if linkage.has_reactions {
        return joints;
    }
    // Parallelograms: all cranks are one vector. Half of them stand in one line.
    let crank = [random.between(-0.6, 0.6), random.between(0.3, 0.8)];
    let in_line = random.between(0.0, 1.0) < 0.5;
    for j in 0..joints.len() {
        if linkage.joints[j].0.is_none() && in_line {
            joints[j][1] = 0.0;
        }
    }
    let base = |b: usize| joints[linkage.placing(b)];
    let carried = |Joint(a, b): &Joint, own: [f64; 2]| match a {
        None => own,
        Some(a) => {
            let from = base(if linkage.is_crank(*a) { *a } else { *b });
            [from[0] + crank[0], from[1] + crank[1]]
        }
    };
    (0..joints.len()).map(|j| carried(&linkage.joints[j], joints[j])).collect()
}
