//! The symbolic engine against arithmetic that shares nothing with it: expressions are drawn at random as
//! plain trees, and what the engine makes of a tree is compared with what the tree itself says.
#![allow(missing_docs, clippy::unwrap_used, clippy::expect_used, clippy::panic)]

mod canonical;
mod derivatives;
mod directed;
mod harness;
mod numbers;
mod reader;
mod rounding;
mod rules;
mod tracked;
mod tree;
