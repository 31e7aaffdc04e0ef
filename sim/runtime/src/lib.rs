//! The runtime of mechanisms declared with `mechanism!`: assemble a start, integrate on the constraints, locate
//! events, record, write and draw.
//!
//! Every function that can fail returns an error that says what, when and where; results up to then are kept.

// Without the command line, some shared code has no user.
#![cfg_attr(not(feature = "cli"), allow(dead_code, unused_imports))]

mod analysis;
mod batch;
#[cfg(feature = "cli")]
pub mod cli;
mod events;
#[cfg(feature = "analysis")]
pub mod import;
mod integrate;
#[cfg(feature = "analysis")]
mod interpreted;
mod model;
mod motion;
mod numerics;
mod output;
mod record;
mod run;
mod start;
mod state;

pub use analysis::equilibrium::{Equilibrium, equilibrium};
pub use analysis::kinematics::{
    Driven, Extreme, Extremes, Kinematics, Prescribed, Range, SpecialPosition, Sweep, TimeRatio, inverse_dynamics,
    kinematics, kinematics_until,
};
pub use analysis::linearize::{Linearization, Mode, linearize};
pub use analysis::poincare::{Period, Section, Sectioning, poincare, poincare_while};
pub use analysis::sensitivity::ForwardSensitivity;
#[cfg(feature = "analysis")]
pub use analysis::verify;
pub use batch::{accelerate_each, accelerate_each_with, advance_each, solve_each};
pub use events::{Change, Crossing, EventSearch, Located, Occurrence, act};
pub use integrate::{
    Advance, Attempt, Course, DOP853, DOPRI5, Dop853, EULER, ErrorEstimate, ExplicitRungeKutta, HEUN, RK3, RK4, Radau5,
    Step, Steps, SuddenChanges, Tableau, Weight, integrate,
};
#[cfg(feature = "analysis")]
pub use interpreted::{DeclarationFile, LoadError, interpret, load};
pub use model::conditional::is_active;
pub use model::erased::{
    Bounded, Erased, ErasedPrepared, Found, InPlace, Kernel, List, Model, OnHeap, Prepared, Results, Shared, States,
    Storage, Values, erase,
};
pub use model::{At, Control};
pub use motion::Motion;
pub use motion::inertia::check_inertias;
pub use motion::measured::{check_masses, mobility};
pub use motion::measures::Measures;
pub use motion::mobility::Mobility;
pub use motion::project::{project, project_positions, project_velocities};
pub use motion::residuals::{rates, residuals};
pub use motion::singular::Singularity;
pub use motion::typed::accelerate;
pub use numerics::eigen::{Eigen, NoEigenvalues, eigen};
pub use output::formats::{Format, write_table};
pub use output::show;
pub use output::write::{WriteError, summary, write_commented_csv, write_csv, write_json};
pub use record::DeadPoint;
pub use record::table::{Column, Table};
pub use run::{
    Controller, DOUBTFUL_BALANCE, NotRestored, Run, Simulation, dead_points, run, run_controlled, run_while,
};
pub use sim_kernel::{
    self, Array, Compiled, Description, Dual, Dynamics, FixedArray, GeneralizedSpeeds, Input, Interval, Lanes,
    Mechanism, Scalar, Vectors, Work,
};
pub use start::assemble::{Start, assemble, branches, declared_start};
pub use start::derivative::Direction;
pub use start::dyads::{Branches, Form, Loop};
pub use state::failure::{Failure, What};
pub use state::interpolate::hermite;
pub use state::provenance::{COMMIT, Provenance, VERSION};
pub use state::settings::{Method, Rows, Settings, Stabilisation, Stepping, StopAt, Tolerance};
pub use state::trajectory::{Phase, Rates, Sample, State, Trajectory};
