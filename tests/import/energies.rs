//! Energies against the links by themselves: their places by a chain of isometries, their velocities by differences.

use crate::{ARM, KINDS, QUADRUPED, declared, imported};
use nalgebra::{Isometry3, Matrix3, Quaternion, Rotation3, Translation3, Unit, UnitQuaternion, Vector3};
use roxmltree::{Document, Node};
use sim::import::urdf::{Base, Mimic, Options};
use sim::{At, Kernel, Model};
use std::collections::HashMap;
use tests::Random;
use tests::called::called;

const GRAVITY: f64 = 9.81;
/// Errors of central differences are its square, times those of speeds of some rad/s.
const STEP: f64 = 1e-5;
/// A hundred times that, and rounding by 1e-16 / STEP.
const BOUND: f64 = 1e-8;

fn three(node: Option<Node>, name: &str, otherwise: [f64; 3]) -> Vector3<f64> {
    let Some(text) = node.and_then(|node| node.attribute(name)) else { return otherwise.into() };
    Vector3::from_iterator(text.split_whitespace().map(|x| x.parse::<f64>().unwrap()))
}

fn child<'a, 'i>(node: Node<'a, 'i>, name: &str) -> Option<Node<'a, 'i>> {
    node.children().find(|child| child.has_tag_name(name))
}

fn number(node: Option<Node>, name: &str, otherwise: f64) -> f64 {
    node.and_then(|node| node.attribute(name)).map_or(otherwise, |text| text.parse().unwrap())
}

fn origin(node: Node) -> Isometry3<f64> {
    let origin = child(node, "origin");
    let [roll, pitch, yaw] = three(origin, "rpy", [0.0; 3]).into();
    let place = three(origin, "xyz", [0.0; 3]);
    Isometry3::from_parts(Translation3::from(place), UnitQuaternion::from_euler_angles(roll, pitch, yaw))
}

/// All links at values of the coordinates, each with its mass, and its inertia along its own axes.
struct Links<'a> {
    robot: Node<'a, 'a>,
    coordinates: Vec<String>,
    names: Vec<&'static str>,
    base: Option<String>,
}

impl Links<'_> {
    fn value(&self, name: &str, q: &[f64]) -> Option<f64> {
        // Names of the file are mapped, but those of these robots' joints.
        self.coordinates.iter().position(|coordinate| coordinate == name).map(|at| q[at])
    }

    fn joint(&self, joint: Node, q: &[f64]) -> Isometry3<f64> {
        let name = joint.attribute("name").unwrap();
        let axis = Unit::new_normalize(three(child(joint, "axis"), "xyz", [1.0, 0.0, 0.0]));
        let mimic = child(joint, "mimic");
        let own = self.value(name, q);
        let value = own.or_else(|| {
            let other = self.value(mimic?.attribute("joint")?, q)?;
            Some(number(mimic, "multiplier", 1.0) * other + number(mimic, "offset", 0.0))
        });
        let moved = match joint.attribute("type").unwrap() {
            "fixed" => Isometry3::identity(),
            "prismatic" => Translation3::from(axis.into_inner() * value.unwrap()).into(),
            "planar" => {
                let of = |ending: &str| self.value(&format!("{name}{ending}"), q).unwrap();
                // Across an axis against x, whose component is the smallest.
                let across = axis.cross(&Vector3::x()).normalize();
                let shift = across * of("_x") + axis.cross(&across) * of("_y");
                Isometry3::from_parts(shift.into(), UnitQuaternion::from_axis_angle(&axis, of("_turn")))
            }
            _ => {
                Isometry3::from_parts(Translation3::identity(), UnitQuaternion::from_axis_angle(&axis, value.unwrap()))
            }
        };
        origin(joint) * moved
    }

    /// The frame of each link.
    fn frames(&self, q: &[f64]) -> HashMap<String, Isometry3<f64>> {
        let joints: Vec<Node> = self.robot.children().filter(|node| node.has_tag_name("joint")).collect();
        let end = |joint: &Node, what: &str| child(*joint, what).unwrap().attribute("link").unwrap().to_owned();
        let root = self.names.iter().find(|name| joints.iter().all(|joint| end(joint, "child") != **name)).unwrap();
        let mut frames = HashMap::from([(root.to_string(), self.root(q))]);
        while frames.len() < self.names.len() {
            for joint in &joints {
                if let Some(parent) = frames.get(&end(joint, "parent")) {
                    let frame = parent * self.joint(*joint, q);
                    frames.insert(end(joint, "child"), frame);
                }
            }
        }
        frames
    }

    /// A free base by the place of its body's centre of mass and its quaternion.
    fn root(&self, q: &[f64]) -> Isometry3<f64> {
        let Some(base) = &self.base else { return Isometry3::identity() };
        let [x, y, z, w, i, j, k] =
            ["x", "y", "z", "q0", "q1", "q2", "q3"].map(|what| self.value(&format!("{base}_{what}"), q).unwrap());
        let turn = UnitQuaternion::from_quaternion(Quaternion::new(w, i, j, k));
        let centre = self.base_centre();
        Isometry3::from_parts(Translation3::from(Vector3::new(x, y, z) - turn * centre), turn)
    }

    /// The joint that holds a link.
    fn holding(&self, link: &str) -> Option<Node<'_, '_>> {
        let is_held = |node: &Node| child(*node, "child").is_some_and(|child| child.attribute("link") == Some(link));
        self.robot.children().find(|node| node.has_tag_name("joint") && is_held(node))
    }

    /// A link in the root's frame, if it is fixed to it.
    fn fixed(&self, link: &str) -> Option<Isometry3<f64>> {
        let (mut place, mut at) = (Isometry3::identity(), link.to_owned());
        while let Some(joint) = self.holding(&at) {
            if joint.attribute("type") != Some("fixed") {
                return None;
            }
            place = origin(joint) * place;
            at = child(joint, "parent")?.attribute("link")?.to_owned();
        }
        Some(place)
    }

    /// Of the root and of what is fixed to it.
    fn base_centre(&self) -> Vector3<f64> {
        let (mut mass, mut moment) = (0.0, Vector3::zeros());
        for link in self.robot.children().filter(|node| node.has_tag_name("link")) {
            let fixed = self.fixed(link.attribute("name").unwrap());
            let Some((inertial, place)) = child(link, "inertial").zip(fixed) else { continue };
            let own = number(child(inertial, "mass"), "value", 0.0);
            mass += own;
            moment += (place * origin(inertial)).translation.vector * own;
        }
        moment / mass
    }

    /// As a fixed root stands.
    fn root_starts_at_the_origin(&self, model: &dyn Model) {
        let [start, _] = model.initial();
        // What is not said starts at 0, but quaternions do at 1.
        let root = self.root(&start);
        assert!(root.translation.vector.norm() < 1e-15 && root.rotation.angle() < 1e-15, "{root}");
    }

    /// Kinetic energy, and the potential energy of those that move.
    fn energies(&self, q: &[f64], qd: &[f64]) -> [f64; 2] {
        let moved = |by: f64| self.frames(&q.iter().zip(qd).map(|(q, qd)| q + by * qd).collect::<Vec<_>>());
        let (before, now, after) = (moved(-STEP), moved(0.0), moved(STEP));
        let mut energies = [0.0; 2];
        for link in self.robot.children().filter(|node| node.has_tag_name("link")) {
            let Some(inertial) = child(link, "inertial") else { continue };
            let name = link.attribute("name").unwrap();
            let own = origin(inertial);
            let [a, b, c] = [&before, &now, &after].map(|frames| frames[name] * own);
            let velocity = (c.translation.vector - a.translation.vector) / (2.0 * STEP);
            // In the axes of the inertia.
            let spin = (a.rotation.inverse() * c.rotation).scaled_axis() / (2.0 * STEP);
            let entry = |name: &str| number(child(inertial, "inertia"), name, 0.0);
            let [xx, yy, zz] = ["ixx", "iyy", "izz"].map(entry);
            let [xy, xz, yz] = ["ixy", "ixz", "iyz"].map(entry);
            let inertia = Matrix3::new(xx, xy, xz, xy, yy, yz, xz, yz, zz);
            let mass = number(child(inertial, "mass"), "value", 0.0);
            energies[0] += 0.5 * mass * velocity.norm_squared() + 0.5 * spin.dot(&(inertia * spin));
            if velocity.norm() > 0.0 {
                energies[1] += mass * GRAVITY * b.translation.z;
            }
        }
        energies
    }
}

fn agrees(text: &'static str, options: &Options, base: Option<&str>) {
    let document = Document::parse(text).unwrap();
    let robot = document.root_element();
    let names = robot.children().filter(|node| node.has_tag_name("link")).map(|link| link.attribute("name").unwrap());
    let model = declared(&imported(text, options).text);
    let coordinates = model.description().coordinates.iter().map(|c| c.position.name.to_owned()).collect();
    // Texts of tests live as long as the program.
    let names: Vec<&'static str> = names.map(|name| &*name.to_owned().leak()).collect();
    let links = Links { robot, coordinates, names, base: base.map(str::to_owned) };
    links.root_starts_at_the_origin(&*model);
    let random = &mut Random(3);
    let n = links.coordinates.len();
    for _ in 0..5 {
        let [mut q, mut qd] = [(); 2].map(|()| (0..n).map(|_| random.between(-1.0, 1.0)).collect::<Vec<f64>>());
        if base.is_some() {
            // The quaternion comes last. Its length is 1 and stays so.
            let (turn, rate) = (&mut q[n - 4..], &mut qd[n - 4..]);
            let length = turn.iter().map(|x| x * x).sum::<f64>().sqrt();
            turn.iter_mut().for_each(|x| *x /= length);
            let growth: f64 = turn.iter().zip(&*rate).map(|(x, y)| x * y).sum();
            rate.iter_mut().zip(turn).for_each(|(y, x)| *y -= growth * *x);
        }
        let zeros = vec![0.0; n];
        let multipliers = vec![0.0; model.description().constraints.len()];
        let at = At { time: 0.0, positions: &q, speeds: &qd, accelerations: &zeros, multipliers: &multipliers };
        let [kinetic, _] = links.energies(&q, &qd);
        let found = called(&*model, Kernel::KineticEnergy, at)[0];
        assert!(
            (found - kinetic).abs() < BOUND * kinetic,
            "kinetic energy {found}, and that of the links is {kinetic}"
        );
        weights_do_the_work_of_a_falling_potential(&*model, &links, at);
    }
}

/// The generalised forces of a robot at rest are those of its weight.
fn weights_do_the_work_of_a_falling_potential(model: &dyn Model, links: &Links, at: At<f64>) {
    let zeros = vec![0.0; at.positions.len()];
    let forces = called(model, Kernel::GeneralizedForces, At { speeds: &zeros, ..at });
    let work: f64 = forces.iter().zip(at.speeds).map(|(force, speed)| force * speed).sum();
    let potential = |by: f64| {
        let moved: Vec<f64> = at.positions.iter().zip(at.speeds).map(|(q, qd)| q + by * qd).collect();
        links.energies(&moved, at.speeds)[1]
    };
    let falling = -(potential(STEP) - potential(-STEP)) / (2.0 * STEP);
    let size: f64 = forces.iter().zip(at.speeds).map(|(force, speed)| (force * speed).abs()).sum();
    assert!(
        (work - falling).abs() < BOUND * size,
        "the weights' power is {work}, and the potential falls by {falling}"
    );
}

#[test]
fn every_kind_of_joint_moves_its_link_as_the_file_says() {
    let plain = Options { damping: false, ..Options::default() };
    agrees(KINDS, &plain, None);
    agrees(KINDS, &Options { mimic: Mimic::Free, ..plain.clone() }, None);
    agrees(KINDS, &Options { mimic: Mimic::Couple, ..plain }, None);
}

#[test]
fn shipped_robots_move_as_their_files_say() {
    let free = Options { base: Base::Free, ..Options::default() };
    agrees(ARM, &Options::default(), None);
    agrees(ARM, &free, Some("table_body"));
    agrees(QUADRUPED, &Options::default(), None);
    agrees(QUADRUPED, &free, Some("trunk_body"));
}

/// Rotations of the file against nalgebra's, for the convention: about the fixed axes x, y and z.
#[test]
fn roll_pitch_and_yaw_are_about_fixed_axes() {
    let ours = Rotation3::from_euler_angles(0.3, -0.2, 0.5);
    let each = [(Vector3::z_axis(), 0.5), (Vector3::y_axis(), -0.2), (Vector3::x_axis(), 0.3)];
    let product =
        each.iter().fold(Rotation3::identity(), |turn, (axis, angle)| turn * Rotation3::from_axis_angle(axis, *angle));
    assert!((ours.matrix() - product.matrix()).abs().max() < 1e-15);
}
