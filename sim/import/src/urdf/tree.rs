//! The links of a robot as a tree, and what moves together.

use super::Base;
use super::number::Number;
use super::pose::Pose;
use super::robot::{Kind, Robot};
use super::warnings::CODE;
use codegen::mistakes::Mistake;
use nalgebra::{Matrix3, Vector3};

/// The tree of links, each by its place in the robot.
pub(super) struct Tree {
    pub(super) root: usize,
    pub(super) base: Base,
    /// All links, each after the one that holds it.
    pub(super) order: Vec<usize>,
    /// The joint that holds each link; none for the root.
    pub(super) holding: Vec<Option<usize>>,
    /// The link that each is fixed to: one that moves by itself, or the root.
    heads: Vec<usize>,
    /// Each link in the frame of its head.
    poses: Vec<Pose>,
    /// Whether anything beyond a link, itself included, has mass or inertia; by link.
    has_mass: Vec<bool>,
}

/// Finds the tree.
///
/// # Errors
/// Two roots, and loops.
pub(super) fn tree(text: &str, robot: &Robot, base: Base) -> Result<Tree, Vec<Mistake>> {
    let refuse =
        |place: &std::ops::Range<usize>, message: String| Err(vec![Mistake::at(text, CODE, place.clone(), message)]);
    let links = robot.links.len();
    let (mut holding, mut held) = (vec![None; links], vec![Vec::new(); links]);
    for (at, joint) in robot.joints.iter().enumerate() {
        let link = &robot.links[joint.child].name;
        if let Some(first) = holding[joint.child].replace(at) {
            let first = &robot.joints[first].name;
            let message = format!(
                "link `{link}` is held by two joints, `{first}` and this one: URDF describes trees. Leave this joint out, and \
                 close the loop in the imported declaration, by `joints {{ .. }}`"
            );
            return refuse(&joint.place, message);
        }
        held[joint.parent].push(at);
    }
    let mut roots = (0..links).filter(|link| holding[*link].is_none());
    let Some(root) = roots.next() else {
        return refuse(&robot.links[0].place, "every link is held by another: the joints form a loop".into());
    };
    if let Some(other) = roots.next() {
        let [first, other] = [root, other].map(|link| &robot.links[link]);
        let message =
            format!("two links are held by no joint, `{}` and `{}`; a robot has one root", first.name, other.name);
        return refuse(&other.place, message);
    }
    let order = depth_first(root, |link| held[link].iter().map(|joint| robot.joints[*joint].child).collect());
    if let Some(lost) = (0..links).find(|link| !order.contains(link)) {
        let link = &robot.links[lost];
        return refuse(
            &link.place,
            format!("link `{}` is held by links that it holds itself: the joints form a loop", link.name),
        );
    }
    Ok(Tree::of(robot, base, root, order, holding))
}

fn depth_first(root: usize, held_by: impl Fn(usize) -> Vec<usize>) -> Vec<usize> {
    let (mut order, mut waiting) = (Vec::new(), vec![root]);
    while let Some(link) = waiting.pop() {
        order.push(link);
        waiting.extend(held_by(link).into_iter().rev());
    }
    order
}

impl Tree {
    fn of(robot: &Robot, base: Base, root: usize, order: Vec<usize>, holding: Vec<Option<usize>>) -> Tree {
        let mut heads: Vec<usize> = (0..robot.links.len()).collect();
        let mut poses = vec![Pose::none(); robot.links.len()];
        let mut has_mass: Vec<bool> =
            robot.links.iter().map(|link| link.inertial.as_ref().is_some_and(|own| !own.is_nothing())).collect();
        let joint = |link: usize| holding[link].map(|joint: usize| &robot.joints[joint]);
        for link in &order {
            if let Some(joint) = joint(*link).filter(|joint| joint.kind == Kind::Fixed) {
                heads[*link] = heads[joint.parent];
                poses[*link] = poses[joint.parent].then(&joint.origin);
            }
        }
        for link in order.iter().rev() {
            // What floats is not moved by what is before it.
            if let Some(joint) = joint(*link).filter(|joint| joint.kind != Kind::Floating) {
                has_mass[joint.parent] |= has_mass[*link];
            }
        }
        Tree { root, base, order, holding, heads, poses, has_mass }
    }

    /// Whether a link is the first of those that move together.
    pub(super) fn is_head(&self, link: usize) -> bool {
        self.heads[link] == link
    }

    /// Whether a link stands on the ground.
    pub(super) fn is_grounded(&self, link: usize) -> bool {
        self.base == Base::Fixed && self.heads[link] == self.root
    }

    /// Whether anything beyond a link, itself included, has mass or inertia.
    pub(super) fn has_mass_beyond(&self, link: usize) -> bool {
        self.has_mass[link]
    }

    /// All that moves with a head as one body, in the head's frame.
    pub(super) fn body(&self, robot: &Robot, head: usize) -> Lump {
        let own =
            |link: &usize| robot.links[*link].inertial.as_ref().filter(|own| !own.is_nothing()).map(|own| (*link, own));
        let parts: Vec<_> =
            (0..robot.links.len()).filter(|link| self.heads[*link] == head).filter_map(|link| own(&link)).collect();
        if let [(link, own)] = parts.as_slice()
            && *link == head
        {
            let inertia = if own.origin.is_turned() { entries(&own.matrix()) } else { own.inertia.clone() };
            return Lump { mass: own.mass.clone(), centre: own.origin.xyz.clone(), inertia };
        }
        let placed = |(link, own): &(usize, &super::robot::Inertial)| {
            let pose = self.poses[*link];
            let matrix = pose.rotation * own.matrix() * pose.rotation.transpose();
            (own.mass.value, pose.then(&own.origin).place, matrix)
        };
        let parts: Vec<(f64, Vector3<f64>, Matrix3<f64>)> = parts.iter().map(placed).collect();
        let mass: f64 = parts.iter().map(|(mass, ..)| mass).sum();
        let moment: Vector3<f64> = parts.iter().map(|(mass, centre, _)| *mass * centre).sum();
        let centre = if mass > 0.0 { moment / mass } else { Vector3::zeros() };
        let matrix: Matrix3<f64> = parts.iter().map(|(mass, at, own)| own + steiner(*mass, at - centre)).sum();
        Lump {
            mass: Number::of(mass),
            centre: std::array::from_fn(|k| Number::of(centre[k])),
            inertia: entries(&matrix),
        }
    }
}

/// Several links as one body: mass, centre of mass, and xx, yy, zz, xy, xz, yz about it.
pub(super) struct Lump {
    pub(super) mass: Number,
    pub(super) centre: [Number; 3],
    pub(super) inertia: [Number; 6],
}

/// The inertia of a point mass about a point at a distance (Steiner).
fn steiner(mass: f64, arm: Vector3<f64>) -> Matrix3<f64> {
    (Matrix3::identity() * arm.norm_squared() - arm * arm.transpose()) * mass
}

/// xx, yy, zz, xy, xz, yz
fn entries(matrix: &Matrix3<f64>) -> [Number; 6] {
    [(0, 0), (1, 1), (2, 2), (0, 1), (0, 2), (1, 2)].map(|at| Number::of(matrix[at]))
}
