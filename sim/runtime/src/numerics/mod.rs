//! Numbers, arrays and matrices, without mechanics.

pub(crate) mod arrays;
pub(crate) mod cubic;
pub(crate) mod eigen;
pub(crate) mod graded;
pub(crate) mod insertion;
pub(crate) mod lu;
pub(crate) mod nearest;
pub(crate) mod numbers;
pub(crate) mod power_of_two;
pub(crate) mod root;
pub(crate) mod signs;
pub(crate) mod solve;
