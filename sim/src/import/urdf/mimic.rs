//! Joints that follow others.

use super::Mimic;
use super::robot::{Kind, Mimicked, Robot};
use super::warnings::Warnings;

/// What each joint follows, by its place, or nothing.
pub(super) struct Followers(Vec<Option<usize>>);

impl Followers {
    /// The joint that another follows, with the law.
    pub(super) fn of<'r>(&self, robot: &'r Robot, joint: usize) -> Option<(usize, &'r Mimicked)> {
        self.0[joint].zip(robot.joints[joint].mimic.as_ref())
    }
}

/// Finds what joints follow. One that follows what is not there, or itself, moves by itself.
pub(super) fn followers(robot: &Robot, how: Mimic, warnings: &mut Warnings) -> Followers {
    let mut all = Followers(vec![None; robot.joints.len()]);
    for (at, joint) in robot.joints.iter().enumerate().filter(|_| how != Mimic::Free) {
        let Some(mimic) = joint.mimic.as_ref().filter(|_| joint.kind != Kind::Fixed) else { continue };
        let target = robot.joints.iter().position(|other| other.name == mimic.joint);
        let why = match target.map(|target| (target, robot.joints[target].kind)) {
            _ if !joint.kind.is_single() => Some("has several coordinates".to_owned()),
            None => Some(format!("mimics `{}`, and no joint is called so", mimic.joint)),
            Some((_, Kind::Fixed)) => Some(format!("mimics `{}`, which is fixed", mimic.joint)),
            Some((_, kind)) if !kind.is_single() => {
                Some(format!("mimics `{}`, which has several coordinates", mimic.joint))
            }
            Some((target, _)) if leads_to(&all, target, at) => {
                Some(format!("mimics `{}`, which mimics it", mimic.joint))
            }
            Some(_) => None,
        };
        match why {
            Some(why) => warnings.add(&mimic.place, format!("joint `{}` {why}: it moves by itself", joint.name)),
            None => all.0[at] = target,
        }
    }
    all
}

/// Whether a joint is or follows another.
fn leads_to(followers: &Followers, from: usize, to: usize) -> bool {
    std::iter::successors(Some(from), |joint| followers.0[*joint]).any(|joint| joint == to)
}
