//! The commands.

mod base_parameters;
pub(super) mod check;
pub(super) mod compare;
pub(super) mod evaluate;
pub(super) mod generate;
pub(super) mod import;
pub(super) mod info;
pub(super) mod kinematics;
pub(super) mod linearize;
pub(super) mod list;
pub(super) mod new;
pub(super) mod new_file;
pub(super) mod plot;
pub(super) mod poincare;
pub(super) mod run;
pub(super) mod statics;
pub(super) mod steady;
mod tree;
pub(super) mod verify;
pub(super) mod watch;
