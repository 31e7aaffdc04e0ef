//! Space: rotations, vectors written in frames, and their motion.
//!
//! A rotation is a chain of steps, each elementary, about an axis or by a quaternion, and a spatial vector is a sum of
//! triples, each written in the frame that a rotation gives. Neither is multiplied out before its components are
//! needed: velocities and accelerations are carried along the chain from frame to frame, which is the recursion of
//! Newton and Euler's equations (Featherstone, Rigid Body Dynamics Algorithms, 2008, chapter 5), and a rotation cancels
//! with its own inverse.

mod agreement;
mod basis;
mod components;
mod frames;
mod inertia;
mod links;
mod motion;
mod norms;
mod parts;
mod quaternion;
mod rotation;
pub(crate) mod triple;
mod vector;

pub(super) use basis::Bases;
pub(super) use frames::{Frames, Turn};
pub use inertia::impossible_inertia;
pub(super) use inertia::resolve_inertia;
pub(super) use links::links;
pub use links::{FixedBody, Link};
pub(super) use norms::{Quaternion, check_norms};
pub use parts::{Attitude, Fall, Norm, Push, Pushed, Rates, Tensor};
pub(super) use quaternion::norm_square;
pub(super) use vector::Spatial;
