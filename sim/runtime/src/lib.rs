//! The runtime of mechanisms declared with `mechanism!`: assemble a start, integrate on the constraints, locate
//! events, record and analyse.
//!
//! Every function that can fail returns an error that says what, when and where; results up to then are kept.

// Without declarations read at run time, some shared code has no user.
#![cfg_attr(not(feature = "analysis"), allow(dead_code, unused_imports))]

mod analysis;
mod batch;
#[cfg(not(test))]
mod compiled;
mod events;
mod integrate;
#[cfg(feature = "analysis")]
mod interpreted;
mod model;
mod motion;
mod numerics;
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
    Stability, Step, Steps, SuddenChanges, Tableau, Weight, integrate,
};
#[cfg(feature = "analysis")]
pub use interpreted::{DeclarationFile, LoadError, interpret, load};
pub use model::conditional::is_active;
pub use model::erased::{
    Bounded, Erased, ErasedPrepared, Found, InPlace, Kernel, List, Model, OnHeap, Prepared, Results, Shared, Small,
    States, Storage, Values, erase,
};
pub use model::{At, Control};
pub use motion::Motion;
pub use motion::inertia::check_inertias;
pub use motion::measured::{check_bodies, check_masses, mobility};
pub use motion::measures::Measures;
pub use motion::mobility::Mobility;
pub use motion::project::{project, project_positions, project_velocities};
pub use motion::residuals::{rates, residuals};
pub use motion::singular::Singularity;
pub use motion::typed::accelerate;
pub use numerics::eigen::{Eigen, NoEigenvalues, eigen};
pub use record::DeadPoint;
pub use record::table::{Column, Table};
pub use run::{
    Apart, Controller, DOUBTFUL_BALANCE, NotRestored, Run, Simulation, Unresolved, dead_points, run, run_compared,
    run_controlled, run_while,
};
/// Other formats to declarations.
#[cfg(feature = "analysis")]
pub use sim_import as import;
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
pub use state::readable::readable;
pub use state::settings::{Method, Rows, Settings, Stabilisation, Stepping, StopAt, Tolerance};
pub use state::trajectory::{Phase, Rates, Sample, State, Trajectory};

// For the packages on top of this one.
#[doc(hidden)]
pub use analysis::kinematics::{prescribed_coordinate, quotient};
#[doc(hidden)]
pub use analysis::linearize::quaternions;
#[doc(hidden)]
pub use state::digest::Digest;
