//! Mechanisms declared in the language, one file each. The library is `no_std`, as kernels are.

#![no_std]

mod andrews;
mod bouncing_ball;
mod double_pendulum;
mod four_bar;
mod pendulum;
mod quick_return;
mod quick_return_ratio;
mod skate;
mod slider_crank;

pub use andrews::*;
pub use bouncing_ball::*;
pub use double_pendulum::*;
pub use four_bar::*;
pub use pendulum::*;
pub use quick_return::*;
pub use quick_return_ratio::*;
pub use skate::*;
pub use slider_crank::*;

/// Calls a macro with the types of all mechanisms: `all_models!(callback)` is `callback!(QuickReturn, ..)`.
#[macro_export]
macro_rules! all_models {
    ($callback:ident) => {
        $callback!(
            $crate::QuickReturn,
            $crate::QuickReturnRatio,
            $crate::Andrews,
            $crate::Pendulum,
            $crate::DoublePendulum,
            $crate::FourBar,
            $crate::Skate,
            $crate::SliderCrank,
            $crate::BouncingBall
        )
    };
}
