//! Recursions over a tree of links, in the links' own frames.

mod arrivals;
mod base;
mod branch;
mod composite;
mod coriolis;
mod extent;
mod forward;
mod frames;
mod inertia;
mod newton_euler;
mod open;
mod open_jacobian;
mod terms;
mod tree;
mod triple;
mod wrench;

pub(super) use base::Base;
pub(super) use forward::Joints;
pub(super) use open::{OpenTerms, Solved};
pub(super) use open_jacobian::StateDerivatives;
pub(super) use terms::LinkTerms;
