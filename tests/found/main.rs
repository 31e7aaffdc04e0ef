//! Small declarations on which wrong numbers were found, with a command line of their own. Each is a plain use of the
//! language; what is right for them stands in `src/figures/numbers/known.rs`.

#![allow(missing_docs)]

mod planar;
mod space;

use sim::cli::entry;

fn main() -> std::process::ExitCode {
    sim::cli::main(&[
        entry::<planar::Engine>(),
        entry::<planar::FourBarSmall>(),
        entry::<planar::Rhombus>(),
        entry::<planar::Swing>(),
        entry::<planar::TwoFourBars>(),
        entry::<planar::TwoFourBarsFree>(),
        entry::<planar::SliderCrankSingular>(),
        entry::<planar::BarsAtAWall>(),
        entry::<planar::PendulumIndex3>(),
        entry::<planar::CrankShaper>(),
        entry::<space::BricardJoints>(),
        entry::<space::FlyballJoints>(),
        entry::<space::TopXyz>(),
        entry::<space::TopBall>(),
        entry::<space::DiscFree>(),
        entry::<planar::JansenLeg>(),
        entry::<planar::SliderCrankTiny>(),
        entry::<planar::SliderCrankTinyAngles>(),
        entry::<space::SpinningBrick>(),
        entry::<planar::FourBarTiny>(),
        entry::<space::FourBarInSpace>(),
    ])
}
