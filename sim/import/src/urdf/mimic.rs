//! Joints that follow others.

use super::Mimic;
use super::number::Number;
use super::robot::{Kind, Mimicked, Robot};
use super::warnings::Warnings;
use std::collections::HashMap;

/// What each joint follows, by its place.
pub(super) struct Followers(Vec<Option<Law>>);

/// The value of a joint: that of another one times a number, and an offset.
#[derive(Clone)]
pub(super) struct Law {
    pub(super) joint: usize,
    pub(super) multiplier: Number,
    pub(super) offset: Number,
}

impl Law {
    fn of(joint: usize, mimic: &Mimicked) -> Law {
        Law { joint, multiplier: mimic.multiplier.clone(), offset: mimic.offset.clone() }
    }

    pub(super) fn value(&self, other: f64) -> f64 {
        self.multiplier.value * other + self.offset.value
    }

    /// By what the other one follows itself.
    fn after(&self, other: &Law) -> Law {
        let multiplier = Number::of(self.multiplier.value * other.multiplier.value);
        Law { joint: other.joint, multiplier, offset: Number::of(self.value(other.offset.value)) }
    }

    fn is_finite(&self) -> bool {
        self.multiplier.value.is_finite() && self.offset.value.is_finite()
    }
}

impl Followers {
    /// The law that a joint follows, if it follows any.
    pub(super) fn law(&self, joint: usize) -> Option<&Law> {
        self.0[joint].as_ref()
    }

    /// Whether any joint follows this one.
    pub(super) fn are_led_by(&self, joint: usize) -> bool {
        self.0.iter().flatten().any(|law| law.joint == joint)
    }
}

/// Finds what joints follow: where values are substituted, the last of a chain. One that follows what is not there, or itself, moves
/// by itself.
pub(super) fn followers(robot: &Robot, how: Mimic, warnings: &mut Warnings) -> Followers {
    let names: HashMap<&str, usize> =
        robot.joints.iter().enumerate().map(|(at, joint)| (joint.name.as_str(), at)).collect();
    let mut laws: Vec<Option<Law>> = vec![None; robot.joints.len()];
    for (at, joint) in robot.joints.iter().enumerate().filter(|_| how != Mimic::Free) {
        let Some(mimic) = joint.mimic.as_ref().filter(|_| joint.kind != Kind::Fixed) else { continue };
        let target = names.get(mimic.joint.as_str()).copied();
        let why = match target.map(|target| (target, robot.joints[target].kind)) {
            _ if !joint.kind.is_single() => Some("has several coordinates".to_owned()),
            _ if mimic.multiplier.is_zero() => Some(format!("mimics `{}` by 0 times its value", mimic.joint)),
            None => Some(format!("mimics `{}`, and no joint is called so", mimic.joint)),
            Some((_, Kind::Fixed)) => Some(format!("mimics `{}`, which is fixed", mimic.joint)),
            Some((_, kind)) if !kind.is_single() => {
                Some(format!("mimics `{}`, which has several coordinates", mimic.joint))
            }
            Some((target, _)) if leads_to(&laws, target, at) => {
                Some(format!("mimics `{}`, which mimics it", mimic.joint))
            }
            Some(_) => None,
        };
        match why {
            Some(why) => warnings.add(&mimic.place, format!("joint `{}` {why}: it moves by itself", joint.name)),
            None => laws[at] = target.map(|target| Law::of(target, mimic)),
        }
    }
    if how == Mimic::Substitute {
        (0..laws.len()).for_each(|at| shorten(&mut laws, at));
    }
    for (law, joint) in laws.iter_mut().zip(&robot.joints) {
        if law.as_ref().is_some_and(|law| !law.is_finite()) {
            let message = format!("joint `{}` follows beyond the range of numbers: it moves by itself", joint.name);
            warnings.add(&joint.place, message);
            *law = None;
        }
    }
    Followers(laws)
}

/// Whether a joint is or follows another.
fn leads_to(laws: &[Option<Law>], from: usize, to: usize) -> bool {
    std::iter::successors(Some(from), |joint| laws[*joint].as_ref().map(|law| law.joint)).any(|joint| joint == to)
}

/// Lets a joint, and those between, follow the last of its chain.
fn shorten(laws: &mut [Option<Law>], from: usize) {
    let chain = std::iter::successors(Some(from), |joint| laws[*joint].as_ref().map(|law| law.joint));
    let chain: Vec<usize> = chain.collect();
    for at in chain.into_iter().rev() {
        if let Some(law) = &laws[at]
            && let Some(next) = &laws[law.joint]
        {
            laws[at] = Some(law.after(next));
        }
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn a_chain_is_followed_to_its_end() {
        let law = |joint, multiplier, offset| {
            Some(Law { joint, multiplier: Number::of(multiplier), offset: Number::of(offset) })
        };
        let mut laws = vec![law(1, 2.0, 0.5), law(2, -3.0, 0.25), None];
        (0..3).for_each(|at| shorten(&mut laws, at));
        let [first, second, _] = laws.as_slice() else { unreachable!() };
        let (first, second) = (first.as_ref().unwrap(), second.as_ref().unwrap());
        assert_eq!((first.joint, second.joint), (2, 2));
        assert_eq!((first.value(1.5), second.value(1.5)), (2.0 * (-3.0 * 1.5 + 0.25) + 0.5, -3.0 * 1.5 + 0.25));
    }
}
