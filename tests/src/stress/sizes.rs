//! Sizes, masses, loads and the speed of the start: the parameters of a draw.

use super::draw::{Parameters, happens, log_between};
use super::geometry::{Pose, pose};
use super::spatial::{self, Vector};
use super::topology::{Body, Planar, Spatial};
use tests::Random;

/// Links from 1 mm to 100 m, and what goes with them.
struct Scales {
    size: f64,
    mass: f64,
    gravity: f64,
    /// Of the first body, with its sign.
    speed: f64,
}

impl Scales {
    fn new(random: &mut Random) -> Scales {
        let (size, mass) = (log_between(random, 1e-3, 1e2), log_between(random, 1e-3, 1e3));
        let gravity = if happens(random, 0.6) { 9.81 } else { 0.0 };
        let sign = if happens(random, 0.5) { 1.0 } else { -1.0 };
        // From what gravity sways to what it hardly changes.
        let speed = match gravity {
            0.0 => log_between(random, 0.1, 100.0),
            g => (log_between(random, 0.1, 100.0) * g / size).sqrt(),
        };
        Scales { size, mass, gravity, speed: sign * speed }
    }

    fn energy(&self) -> f64 {
        self.mass * (self.size * self.speed).powi(2)
    }

    /// A mass from 1 g to 1 t.
    fn some_mass(&self, random: &mut Random) -> f64 {
        (self.mass * log_between(random, 0.1, 10.0)).clamp(1e-3, 1e3)
    }

    /// Gravity, and sometimes a torque and friction on the first body.
    fn set_loads(&self, values: &mut Parameters, random: &mut Random) {
        let mut set = |name: &str, value: f64| values.push((name.to_owned(), value));
        set("w", self.speed);
        set("g", self.gravity);
        if happens(random, 0.3) {
            set("T", self.energy() * random.between(-0.3, 0.3));
        }
        if happens(random, 0.3) {
            set("kd", self.energy() / self.speed.abs() * random.between(0.0, 0.3));
        }
    }

    /// The size, the heaviest mass, and how fast things go.
    fn natural(&self, values: &Parameters) -> [f64; 3] {
        let masses = values.iter().filter(|(name, _)| name.starts_with("m_")).map(|(_, mass)| *mass);
        [self.size, masses.fold(0.0, f64::max), (self.speed.powi(2) + self.gravity / self.size).sqrt()]
    }
}

pub(crate) fn planar(linkage: &Planar, random: &mut Random) -> (Parameters, [f64; 3]) {
    let pose = pose(linkage, random);
    let scales = Scales::new(random);
    let mut values = bodies(linkage, &pose, &scales, random);
    places(linkage, &pose, scales.size, &mut values);
    scales.set_loads(&mut values, random);
    let mut set = |name: &str, value: f64| values.push((name.to_owned(), value));
    set("e0", scales.size * pose.centres.last().map_or(0.0, |centre| centre[1]));
    set("tilt", random.between(0.1, 1.4));
    if happens(random, 0.3) {
        set("k", scales.energy() / scales.size.powi(2) * random.between(0.0, 1.0));
    }
    set("l0", scales.size * random.between(0.5, 1.5));
    set("sx", scales.size * random.between(-1.0, 1.0));
    // Out of reach, as a spring has no direction where its ends meet.
    set("sy", -6.0 * scales.size);
    let natural = scales.natural(&values);
    (values, natural)
}

fn bodies(linkage: &Planar, pose: &Pose, scales: &Scales, random: &mut Random) -> Parameters {
    let mut values = Parameters::new();
    let mut set = |name: String, value: f64| values.push((name, value));
    for b in 0..linkage.bodies.len() {
        let m = scales.some_mass(random);
        let slender = m * (scales.size * pose.extents[b]).powi(2) / 12.0;
        set(format!("m_{b}"), m);
        set(format!("J_{b}"), slender * log_between(random, 0.3, 3.0));
        set(format!("th_{b}"), pose.angles[b]);
        set(format!("X_{b}"), scales.size * pose.centres[b][0]);
        set(format!("Y_{b}"), scales.size * pose.centres[b][1]);
    }
    values
}

/// Where each joint is on its bodies.
fn places(linkage: &Planar, pose: &Pose, size: f64, values: &mut Parameters) {
    for (j, joint) in linkage.joints.iter().enumerate() {
        for (side, body) in [('a', joint.0), ('b', Some(joint.1))] {
            let [x, y] = pose.joints[j];
            let (centre, angle) = body.map_or(([0.0; 2], 0.0), |b| (pose.centres[b], pose.angles[b]));
            let (dx, dy, (sin, cos)) = (x - centre[0], y - centre[1], angle.sin_cos());
            let is_plate = body.is_none_or(|b| linkage.bodies[b] == Body::Plate);
            values.push((format!("{side}x_{j}"), size * (cos * dx + sin * dy)));
            values.push((format!("{side}y_{j}"), if is_plate { size * (cos * dy - sin * dx) } else { 0.0 }));
        }
    }
}

pub(crate) fn spatial(linkage: &Spatial, random: &mut Random) -> (Parameters, [f64; 3]) {
    let pose = spatial::pose(linkage, random);
    let scales = Scales::new(random);
    let mut values = Parameters::new();
    for (b, [length, twist]) in pose.bars.iter().enumerate() {
        let mass = scales.some_mass(random);
        let slender = mass * (scales.size * length).powi(2) / 12.0;
        // Each moment is less than the sum of the others.
        let moments: Vector = std::array::from_fn(|_| slender * random.between(0.5, 1.0));
        let aside: Vector = std::array::from_fn(|_| random.between(-0.1, 0.1));
        let centre = [length / 2.0 + aside[0], aside[1], aside[2]];
        let (attitude, place) = pose.frames[b];
        let way = attitude.turned(centre);
        set_vector(&mut values, ["X", "Y", "Z"], b, std::array::from_fn(|i| place[i] + way[i]), scales.size);
        set_vector(&mut values, ["cx", "cy", "cz"], b, centre, scales.size);
        set_vector(&mut values, ["J1", "J2", "J3"], b, moments, 1.0);
        let mut set = |name: String, value: f64| values.push((name, value));
        set(format!("m_{b}"), mass);
        set(format!("l_{b}"), scales.size * length);
        set(format!("tw_{b}"), *twist);
        (0..4).for_each(|i| set(format!("q{i}_{b}"), attitude.0[i]));
    }
    let mut set = |name: String, value: f64| values.push((name, value));
    let (ground, twist) = pose.ground;
    ["lx", "ly", "lz"].iter().zip(ground).for_each(|(name, x)| set((*name).to_owned(), scales.size * x));
    set("tw".to_owned(), twist);
    for (j, [first, second]) in pose.turns.iter().enumerate() {
        set(format!("t_{j}"), *first);
        set(format!("u_{j}"), *second);
    }
    if let [_, (coupler, _), (rocker, _)] = pose.frames[..] {
        let between = coupler.inverse() * rocker;
        (0..4).for_each(|i| set(format!("p{i}"), between.0[i]));
    }
    let (slope, bearing) = (random.between(-1.5, 1.5), random.between(-3.0, 3.0));
    set("gx".to_owned(), scales.gravity * slope.cos() * bearing.cos());
    set("gy".to_owned(), scales.gravity * slope.cos() * bearing.sin());
    set("gz".to_owned(), scales.gravity * slope.sin());
    ["w1", "w2", "w3"].iter().for_each(|name| set((*name).to_owned(), scales.speed * random.between(-0.6, 0.6)));
    scales.set_loads(&mut values, random);
    let natural = scales.natural(&values);
    (values, natural)
}

/// Sets the three components of a vector, times a factor.
fn set_vector(values: &mut Parameters, names: [&str; 3], k: usize, vector: Vector, factor: f64) {
    (0..3).for_each(|i| values.push((format!("{}_{k}", names[i]), factor * vector[i])));
}
