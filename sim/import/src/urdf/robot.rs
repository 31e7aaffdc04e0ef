//! A robot as its file has it.

use super::number::Number;
use nalgebra::{Matrix3, Vector3};
use std::ops::Range;

/// Where something stands in the text, by bytes.
pub(super) type Place = Range<usize>;

/// A robot: links in the order of the file, and joints.
pub(super) struct Robot {
    pub(super) name: String,
    pub(super) links: Vec<Link>,
    pub(super) joints: Vec<Joint>,
}

/// A link.
pub(super) struct Link {
    pub(super) name: String,
    pub(super) place: Place,
    pub(super) inertial: Option<Inertial>,
    pub(super) visuals: Vec<Visual>,
}

/// Mass, centre of mass and inertia of a link.
pub(super) struct Inertial {
    pub(super) place: Place,
    pub(super) origin: Origin,
    pub(super) mass: Number,
    /// xx, yy, zz, xy, xz, yz about the centre of mass, along the axes of its origin.
    pub(super) inertia: [Number; 6],
}

impl Inertial {
    /// The matrix of the inertia, along the axes of the link.
    pub(super) fn matrix(&self) -> Matrix3<f64> {
        let [xx, yy, zz, xy, xz, yz] = self.values();
        let own = Matrix3::new(xx, xy, xz, xy, yy, yz, xz, yz, zz);
        self.origin.rotation * own * self.origin.rotation.transpose()
    }

    /// xx, yy, zz, xy, xz, yz as they are written.
    pub(super) fn values(&self) -> [f64; 6] {
        self.inertia.each_ref().map(|number| number.value)
    }

    /// Whether it has neither mass nor inertia.
    pub(super) fn is_nothing(&self) -> bool {
        self.mass.value == 0.0 && self.values().iter().all(|x| *x == 0.0)
    }
}

/// A place and an attitude in the frame before.
pub(super) struct Origin {
    pub(super) xyz: [Number; 3],
    pub(super) rotation: Matrix3<f64>,
}

impl Origin {
    pub(super) fn none() -> Origin {
        Origin { xyz: [Number::ZERO; 3], rotation: Matrix3::identity() }
    }

    pub(super) fn vector(&self) -> Vector3<f64> {
        Vector3::from(self.xyz.each_ref().map(|number| number.value))
    }

    pub(super) fn is_turned(&self) -> bool {
        self.rotation != Matrix3::identity()
    }
}

/// What is seen of a link.
pub(super) struct Visual {
    pub(super) place: Place,
    pub(super) origin: Origin,
    pub(super) geometry: Geometry,
}

/// A body's form. Lengths are in metres.
pub(super) enum Geometry {
    Box([f64; 3]),
    Cylinder { radius: f64, length: f64 },
    Sphere(f64),
    Mesh { file: String, scale: [f64; 3] },
}

/// A joint, and the link that it moves.
pub(super) struct Joint {
    pub(super) name: String,
    pub(super) place: Place,
    pub(super) kind: Kind,
    /// Links by their places in the robot.
    pub(super) parent: usize,
    pub(super) child: usize,
    pub(super) origin: Origin,
    pub(super) axis: Vector3<f64>,
    pub(super) limit: Option<Limit>,
    pub(super) damping: Number,
    pub(super) friction: Number,
    pub(super) mimic: Option<Mimicked>,
}

/// A kind of joint.
#[derive(Clone, Copy, PartialEq, Eq, Debug)]
pub(super) enum Kind {
    Revolute,
    Continuous,
    Prismatic,
    Fixed,
    Floating,
    Planar,
}

impl Kind {
    pub(super) const ALL: [(&'static str, Kind); 6] = [
        ("revolute", Kind::Revolute),
        ("continuous", Kind::Continuous),
        ("prismatic", Kind::Prismatic),
        ("fixed", Kind::Fixed),
        ("floating", Kind::Floating),
        ("planar", Kind::Planar),
    ];

    /// Whether one coordinate describes it.
    pub(super) fn is_single(self) -> bool {
        matches!(self, Kind::Revolute | Kind::Continuous | Kind::Prismatic)
    }

    /// The unit of its coordinate, if one describes it.
    pub(super) fn unit(self) -> &'static str {
        if self == Kind::Prismatic { "m" } else { "rad" }
    }
}

/// The range of a joint and what its drive can do.
pub(super) struct Limit {
    pub(super) place: Place,
    /// The least and the greatest value, if there are any.
    pub(super) range: Option<[Number; 2]>,
    pub(super) effort: Option<Number>,
    pub(super) velocity: Option<Number>,
}

/// The joint that another follows, `multiplier` times its value and `offset`.
pub(super) struct Mimicked {
    pub(super) place: Place,
    pub(super) joint: String,
    pub(super) multiplier: Number,
    pub(super) offset: Number,
}
