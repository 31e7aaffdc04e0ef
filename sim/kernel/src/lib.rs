//! The interface shared by generated kernels and the runtime: the trait of a mechanism, the scalars that kernels run
//! on, and the description of a mechanism. `no_std`; the only dependencies are libm, and cpufeatures, which asks the processor
//! what it has.

#![no_std]

extern crate self as sim_kernel;

mod array;
mod columns;
mod description;
mod dual;
pub mod event;
mod input;
mod interval;
mod lanes;
mod mechanism;
mod root;
mod scalar;
pub mod speeds;
mod table;
mod vectors;
mod wave;

pub use array::{Array, Element, FixedArray};
pub use columns::{ColumnsStep, solve_columns};
pub use description::{
    Coordinate, Description, Figure, Quantity, RunDefault, Shape, SparseRow, Start, Switching, SwitchingKind,
};
pub use dual::Dual;
pub use input::Input;
pub use interval::{Interval, Possible};
pub use lanes::{LaneMask, Lanes};
pub use mechanism::{
    Compiled, ConstraintLinearization, Dynamics, DynamicsJacobian, DynamicsSensitivity, Initial, Kinematics, Mechanism,
    pivot_is_refused,
};
pub use scalar::{Mask, Scalar};
pub use speeds::{GeneralizedSpeeds, SpeedDynamics};
pub use table::Table;
pub use vectors::{Vectors, Work};
pub use wave::{give_sin_cos, sin_cos_of_block};
