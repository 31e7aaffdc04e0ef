//! The runtime of mechanisms declared with [`mechanism!`]: assemble a start, integrate on the constraints, locate
//! events, record, write and draw.
//!
//! Whatever can fail returns an error that says what, when and where; what was computed until then is kept.

mod act;
mod any;
mod assemble;
mod batch;
#[cfg(feature = "cli")]
pub mod cli;
mod conditional;
mod digest;
mod dyads;
mod eigen;
mod equations;
mod equilibrium;
mod events;
mod failure;
mod formats;
mod gimbal;
mod happening;
mod inertia;
mod insertion;
mod integrate;
mod interpolate;
mod kinematics;
mod least_norm;
mod level;
mod linearize;
mod measures;
mod met;
mod mobility;
mod motion;
mod nearby;
mod nearest;
mod onset;
mod outcome;
mod partition;
mod poincare;
mod project;
mod record;
mod reduction;
mod root;
mod rows;
mod run;
mod saved;
mod settings;
pub mod show;
mod singular;
mod solve;
mod table;
mod trajectory;
mod vector;
mod velocity_variables;
#[cfg(feature = "analysis")]
pub mod verify;
mod whole;
mod write;

/// The programs in the documents, compiled and run.
#[cfg(all(doctest, feature = "models", feature = "cli"))]
mod documents {
    #[doc = include_str!("../../TUTORIAL.md")]
    struct Tutorial;
    #[doc = include_str!("../../COMING-FROM.md")]
    struct ComingFrom;
}

pub use act::{Change, act};
pub use assemble::{Start, assemble, branches, declared_start};
pub use batch::{accelerate_each, accelerate_each_with};
pub use conditional::is_active;
pub use dyads::{Branches, Form, Loop};
pub use eigen::{Eigen, NoEigenvalues, eigen};
pub use equations::{accelerate, residuals};
pub use equilibrium::{Equilibrium, equilibrium};
pub use events::{Crossing, EventSearch, Occurrence};
pub use failure::{Failure, What};
pub use formats::{Format, write_table};
pub use inertia::check_inertias;
pub use integrate::{
    Advance, Attempt, Course, DOP853, DOPRI5, Dop853, EULER, ErrorEstimate, ExplicitRungeKutta, HEUN, RK3, RK4, Radau5,
    Step, Steps, Tableau, Weight, integrate,
};
pub use interpolate::hermite;
pub use kinematics::{
    Driven, Extreme, Extremes, Kinematics, Prescribed, Range, SpecialPosition, Sweep, TimeRatio, inverse_dynamics,
    kinematics, kinematics_until,
};
pub use linearize::{Control, Linearization, Mode, linearize};
pub use measures::Measures;
pub use mobility::{Mobility, check_masses, mobility};
pub use motion::Motion;
pub use poincare::{Period, Section, Sectioning, poincare};
pub use project::{project, project_positions, project_velocities, rates};
pub use record::{DeadPoint, dead_points};
pub use run::{Controller, DOUBTFUL_BALANCE, NotRestored, Run, Simulation, run, run_controlled};
pub use settings::{Method, Rows, Settings, Stabilisation, Stepping, StopAt, Tolerance};
pub use sim_kernel::{
    self, Array, Description, Dual, Dynamics, GeneralizedSpeeds, Input, Lanes, Mechanism, Scalar, mechanism,
};
pub use singular::Singularity;
pub use table::{Column, Table};
pub use trajectory::{Phase, Rates, Sample, State, Trajectory};
pub use vector::{Vectors, Work};
pub use write::{WriteError, summary, write_csv, write_json};
