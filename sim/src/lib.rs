//! The runtime of mechanisms declared with [`mechanism!`]: assemble a start, integrate on the constraints, locate
//! events, record, write and draw.
//!
//! Whatever can fail returns an error that says what, when and where; what was computed until then is kept.

mod assemble;
#[cfg(feature = "cli")]
pub mod cli;
mod events;
mod failure;
mod integrate;
mod interpolate;
mod motion;
mod project;
mod root;
mod run;
pub mod show;
mod solve;
mod table;
mod trajectory;
mod write;

pub use assemble::{Start, assemble, declared_start};
pub use events::{Occurrence, locate_events};
pub use failure::{Failure, What};
pub use integrate::{RK4, Tableau, integrate};
pub use interpolate::interpolate;
pub use motion::{accelerate, residuals};
pub use project::{project_positions, project_velocities};
pub use run::{DOUBTFUL_BALANCE, Grid, Run, run};
pub use sim_kernel::{self, Array, Description, Dynamics, Mechanism, Scalar, mechanism};
pub use table::{Column, Table};
pub use trajectory::{Sample, State, Trajectory};
pub use write::{WriteError, summary, write_csv, write_json};
