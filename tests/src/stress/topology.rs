//! The linkages: which bodies there are and what joins them. The build script reads this file too, and writes each of them
//! down in several forms; all sizes are numbers that are drawn at run time.

/// Bodies in a plane, numbered from 0, and their joints.
pub(crate) struct Planar {
    pub(crate) name: &'static str,
    pub(crate) bodies: &'static [Body],
    /// Joints that place a body, and after them those that close loops.
    pub(crate) joints: &'static [Joint],
    pub(crate) forms: &'static [Form],
    /// Whether the constraints determine the forces in the joints.
    pub(crate) has_reactions: bool,
}

#[derive(Clone, Copy, PartialEq, Eq)]
pub(crate) enum Body {
    /// A link with two joints.
    Bar,
    /// A link with more.
    Plate,
    /// What slides along the line y = e0 of the ground, on a pin of the body before it.
    Piston,
}

/// A pin between two bodies; `None` is the ground.
#[derive(Clone, Copy)]
pub(crate) struct Joint(pub(crate) Option<usize>, pub(crate) usize);

/// How a linkage is written down.
#[derive(Clone, Copy, PartialEq, Eq, Debug)]
pub(crate) enum Form {
    /// Angles from the ground, loops cut at their last joints.
    Absolute,
    /// Angles from the body before.
    Relative,
    /// Free bodies and pins.
    Free,
    /// In space, on a tilted plane: joints as coordinates, the last ones as constraints.
    Joints,
    /// In space, on a tilted plane: free bodies with quaternions, held by hinges.
    Quaternions,
    /// All cranks turn by one angle and couplers keep theirs: for parallelograms, without any constraint.
    Reduced,
}

use Body::{Bar, Piston, Plate};
use Form::{Absolute, Free, Joints, Quaternions, Reduced, Relative};

pub(crate) const PLANAR: &[Planar] = &[
    Planar {
        name: "FourBar",
        bodies: &[Bar, Bar, Bar],
        joints: &[Joint(None, 0), Joint(Some(0), 1), Joint(None, 2), Joint(Some(1), 2)],
        forms: &[Absolute, Relative, Free, Joints, Quaternions],
        has_reactions: true,
    },
    Planar {
        name: "SliderCrank",
        bodies: &[Bar, Bar, Piston],
        joints: &[Joint(None, 0), Joint(Some(0), 1), Joint(Some(1), 2)],
        forms: &[Absolute, Relative, Free],
        has_reactions: true,
    },
    // Both loops have the plates 0 and 2 in common.
    Planar {
        name: "Watt",
        bodies: &[Bar, Plate, Plate, Bar, Bar],
        joints: &[
            Joint(None, 0),
            Joint(Some(0), 1),
            Joint(None, 2),
            Joint(Some(1), 3),
            Joint(Some(2), 4),
            Joint(Some(1), 2),
            Joint(Some(3), 4),
        ],
        forms: &[Absolute, Relative, Free],
        has_reactions: true,
    },
    // A point of a coupler drives a second rocker by a link: the third kind.
    Planar {
        name: "Stephenson",
        bodies: &[Bar, Plate, Bar, Bar, Bar],
        joints: &[
            Joint(None, 0),
            Joint(Some(0), 1),
            Joint(None, 2),
            Joint(Some(1), 3),
            Joint(None, 4),
            Joint(Some(1), 2),
            Joint(Some(3), 4),
        ],
        forms: &[Absolute, Relative, Free],
        has_reactions: true,
    },
    // Three cranks carry one plate: a row of the constraints is redundant.
    Planar {
        name: "ParallelCranks",
        bodies: &[Bar, Plate, Bar, Bar],
        joints: &[
            Joint(None, 0),
            Joint(Some(0), 1),
            Joint(None, 2),
            Joint(None, 3),
            Joint(Some(1), 2),
            Joint(Some(1), 3),
        ],
        forms: &[Reduced, Absolute, Relative, Free],
        has_reactions: false,
    },
    // Two parallelograms side by side, with flat positions in which they could fold.
    Planar {
        name: "Parallelograms",
        bodies: &[Bar, Bar, Bar, Bar, Bar],
        joints: &[
            Joint(None, 0),
            Joint(Some(0), 1),
            Joint(None, 2),
            Joint(Some(2), 3),
            Joint(None, 4),
            Joint(Some(1), 2),
            Joint(Some(3), 4),
        ],
        forms: &[Reduced, Absolute, Relative, Free],
        has_reactions: false,
    },
];

impl Planar {
    /// The joint that places a body.
    pub(crate) fn placing(&self, body: usize) -> usize {
        self.joints.iter().position(|joint| joint.1 == body).unwrap_or(0)
    }

    /// The joints that close loops.
    pub(crate) fn cuts(&self) -> impl Iterator<Item = usize> {
        (0..self.joints.len()).filter(|j| self.placing(self.joints[*j].1) != *j)
    }

    /// Whether a body turns with the first one where all loops are parallelograms.
    pub(crate) fn is_crank(&self, body: usize) -> bool {
        self.joints[self.placing(body)].0.is_none()
    }
}

/// A chain of bodies in space between two places of the ground, or one body on one joint. Joint j is between body j - 1 and
/// body j.
///
/// Frames are those of Denavit and Hartenberg: a hinge is the z axis of the body after it; in the body before, whose x axis
/// goes from joint to joint, it is turned about x by a twist. The ground comes before the first body and after the last.
pub(crate) struct Spatial {
    pub(crate) name: &'static str,
    pub(crate) joints: &'static [Held],
    /// The joint that is a constraint in the form `Joints`.
    pub(crate) cut: usize,
    pub(crate) forms: &'static [SpatialForm],
}

/// How two bodies of space are joined.
#[derive(Clone, Copy, PartialEq, Eq)]
pub(crate) enum Held {
    Hinge,
    Ball,
    /// Its second axis is y of the body after it.
    Universal,
}

/// How a linkage of space is written down.
#[derive(Clone, Copy, PartialEq, Eq, Debug)]
pub(crate) enum SpatialForm {
    /// Rotations about axes as coordinates, one joint as constraint.
    Turns,
    /// Joints as coordinates, another one as constraint.
    Joints,
    /// Free bodies with quaternions.
    Free,
    /// A quaternion as coordinates, for a body on a ball joint.
    Attitude,
}

use Held::{Ball, Hinge, Universal};

pub(crate) const SPATIAL: &[Spatial] = &[
    // An RSSR linkage whose coupler cannot turn about itself.
    Spatial {
        name: "SpatialFourBar",
        joints: &[Hinge, Universal, Ball, Hinge],
        cut: 1,
        forms: &[SpatialForm::Turns, SpatialForm::Joints, SpatialForm::Free],
    },
    Spatial {
        name: "Bennett",
        joints: &[Hinge; 4],
        cut: 2,
        forms: &[SpatialForm::Turns, SpatialForm::Joints, SpatialForm::Free],
    },
    Spatial {
        name: "Bricard",
        joints: &[Hinge; 6],
        cut: 3,
        forms: &[SpatialForm::Turns, SpatialForm::Joints, SpatialForm::Free],
    },
    Spatial {
        name: "Top",
        joints: &[Ball],
        cut: 0,
        forms: &[SpatialForm::Joints, SpatialForm::Attitude, SpatialForm::Free],
    },
];

impl Spatial {
    pub(crate) fn is_top(&self) -> bool {
        self.joints.len() == 1
    }

    /// A top has one body on one joint; loops have a body less than joints.
    pub(crate) fn bodies(&self) -> usize {
        (self.joints.len() - 1).max(1)
    }

    /// The bodies that a joint joins; `None` is the ground.
    pub(crate) fn joined(&self, joint: usize) -> [Option<usize>; 2] {
        [joint.checked_sub(1), (joint < self.bodies()).then_some(joint)]
    }

    /// The bodies in the order in which turns place them, each with the joint that it hangs on. A ball is no turn: what
    /// follows it is placed from the other end.
    pub(crate) fn placed(&self) -> Vec<[usize; 2]> {
        let count = self.bodies();
        let ball = self.joints.iter().position(|held| *held == Ball).unwrap_or(count).min(count);
        let ahead = (0..ball).map(|b| [b, b]);
        ahead.chain((ball..count).rev().map(|b| [b, b + 1])).collect()
    }
}
