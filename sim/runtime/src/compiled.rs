//! What is compiled here for the packages on top: runs and analyses of mechanisms whose sizes are known at run time.
//!
//! Rust shares the code of a generic function that is never inlined, if the crate that defines it uses it. So these loops are
//! compiled once, and with the optimisation of this crate; a command line, which waits for the disk and its reader, needs none.

use crate::analysis::equilibrium::equilibrium;
use crate::analysis::kinematics::{Driven, Kinematics, kinematics_until, prescribed_coordinate};
use crate::analysis::linearize::{linearize, quaternions};
use crate::analysis::poincare::poincare_while;
use crate::model::erased::{Erased, OnHeap, Small};
use crate::motion::measured::{check_bodies, mobility};
use crate::motion::residuals::residuals;
use crate::record::table::Table;
use crate::run::{Run, Simulation, run_compared, run_while};
use crate::start::assemble::{assemble, branches, declared_start};
use sim_kernel::Mechanism;
use std::hint::black_box;

/// Uses them.
#[used]
static COMPILED: [fn(); 4] = [runs::<Erased<Small>>, runs::<Erased<OnHeap>>, analyses::<Erased<OnHeap>>, verify];

macro_rules! used {
    ($($function:expr),* $(,)?) => { $( black_box($function as *const ()); )* };
}

fn runs<M: Mechanism>() {
    used! {
        run_compared::<M>,
        run_while::<M>,
        poincare_while::<M>,
        Table::of::<M>,
        assemble::<M>,
        declared_start::<M>,
        check_bodies::<M>,
        Run::<M>::farthest_unmeasured,
        Run::<M>::unresolved,
        mobility::<M>,
        Simulation::<M>::new,
        Simulation::<M>::sample,
        Simulation::<M>::step,
        Simulation::<M>::advance_while,
        Simulation::<M>::set_input,
        Simulation::<M>::set_parameter,
        Simulation::<M>::save,
        Simulation::<M>::restore,
    }
}

fn analyses<M: Mechanism>() {
    used! {
        branches::<M>,
        Driven::value::<M>,
        equilibrium::<M>,
        kinematics_until::<M>,
        Kinematics::<M>::table,
        linearize::<M>,
        prescribed_coordinate::<M>,
        quaternions::<M>,
        residuals::<M>,
    }
}

#[cfg(feature = "analysis")]
fn verify() {
    used! { crate::analysis::verify::verify_while::<Erased<OnHeap>> }
}

#[cfg(not(feature = "analysis"))]
fn verify() {}
