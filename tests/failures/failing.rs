//! A program whose mechanisms fail, each in its own way; with the whole command line, as a user's own program has it.

#![allow(missing_docs)]

use models::{BouncingBall, QuickReturn};
use sim::cli::entry;
use sim::mechanism;
use std::process::ExitCode;

mechanism! {
    /// A bead whose load is a root that leaves its domain at x = 0.5.
    pub Root;
    coordinates { x [m]; }
    parameters { m [kg] = 1; at [m] = 0.5; }
    bodies { bead: mass m at [x, 0]; }
    loads { force [1 [N]*sqrt((at - x)/1 [m]), 0] at [x, 0]; }
    initial { dot(x) = 1; }
}

mechanism! {
    /// A bead whose load grows with the cube of x, so that x is infinite after a finite time.
    pub BlowUp;
    coordinates { x [m]; }
    parameters { m [kg] = 1; k [N/m^3] = 100; }
    bodies { bead: mass m at [x, 0]; }
    loads { force [k*x^3, 0] at [x, 0]; }
    initial { x = 1; }
}

mechanism! {
    /// A block on a spring with dry friction that jumps where it comes to rest, and holds it there.
    pub Stiction;
    coordinates { x [m]; }
    parameters { m [kg] = 1; k [N/m] = 100; friction [N] = 20; }
    bodies { block: mass m at [x, 0]; }
    loads { force [-k*x - friction*sign(dot(x)), 0] at [x, 0]; }
    initial { x = 0.3; }
}

mechanism! {
    /// Two beads, of which one has no mass.
    pub Weightless;
    coordinates { x [m]; y [m]; }
    parameters { m [kg] = 1; n [kg] = 0; }
    bodies { one: mass m at [x, 0]; two: mass n at [0, y]; }
    loads { force [1 [N], 0] at [x, 0]; force [0, 1 [N]] at [0, y]; }
}

mechanism! {
    /// A wheel with a condition that changes a million times as fast as the wheel, from a quarter of a turn on.
    pub Rattle;
    coordinates { phi [rad]; }
    parameters { J [kg*m^2] = 1; }
    bodies { wheel: inertia J, angle phi; }
    initial { dot(phi) = 1; }
    events { rattle: (1 + sign(phi - 0.5))*sin(1e9*phi) + 1 - sign(phi - 0.5) = 0; }
}

mechanism! {
    /// A parallelogram, flat.
    pub Flat;
    coordinates { crank [rad]; coupler [rad]; rocker [rad]; }
    parameters { a [m] = 0.2; b [m] = 0.5; }
    let A = a*[cos(crank), sin(crank)];
    let B = A + b*[cos(coupler), sin(coupler)];
    bodies {
        one: inertia 0.01 [kg*m^2], angle crank;
        two: mass 1 [kg] at (A + B)/2, inertia 0.02 [kg*m^2], angle coupler;
        three: inertia 0.01 [kg*m^2], angle rocker;
    }
    constraints { closure: B = [b, 0] + a*[cos(rocker), sin(rocker)]; }
    initial { crank = 0; dot(crank) = 10; guess coupler = 0; guess rocker = 0; }
}

fn main() -> ExitCode {
    sim::cli::main(&[
        entry::<Root>(),
        entry::<BlowUp>(),
        entry::<Stiction>(),
        entry::<Weightless>(),
        entry::<Rattle>(),
        entry::<Flat>(),
        entry::<QuickReturn>(),
        entry::<BouncingBall>(),
    ])
}
