//! Recursions over a tree of links, in the links' own frames.

mod composite;
mod newton_euler;
mod terms;
mod tree;
mod triple;

pub(super) use terms::LinkTerms;
