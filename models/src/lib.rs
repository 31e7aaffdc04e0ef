//! Mechanisms declared in the language, one file each. The library is `no_std`, as kernels are.

#![no_std]

#[cfg(feature = "erased")]
extern crate alloc;

mod andrews;
mod bennett;
mod bouncing_ball;
mod cam_follower;
mod cardan;
mod cart_pole;
mod double_pendulum;
mod four_bar;
mod four_bars;
mod gyroscope;
mod half_car;
mod hanging_chain;
mod pendulum;
mod quick_return;
mod quick_return_ratio;
mod robot_arm;
mod rolling_disc;
mod rover;
mod rssr;
mod scotch_yoke;
mod six_bar;
mod skate;
mod slider_crank;
mod spherical_pendulum;
mod spring_follower;
mod stewart;
mod top;
mod tumbling;
mod tumbling_quaternion;
mod whitworth;

pub use andrews::*;
pub use bennett::*;
pub use bouncing_ball::*;
pub use cam_follower::*;
pub use cardan::*;
pub use cart_pole::*;
pub use double_pendulum::*;
pub use four_bar::*;
pub use four_bars::*;
pub use gyroscope::*;
pub use half_car::*;
pub use hanging_chain::*;
pub use pendulum::*;
pub use quick_return::*;
pub use quick_return_ratio::*;
pub use robot_arm::*;
pub use rolling_disc::*;
pub use rover::*;
pub use rssr::*;
pub use scotch_yoke::*;
pub use six_bar::*;
pub use skate::*;
pub use slider_crank::*;
pub use spherical_pendulum::*;
pub use spring_follower::*;
pub use stewart::*;
pub use top::*;
pub use tumbling::*;
pub use tumbling_quaternion::*;
pub use whitworth::*;

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
            $crate::SliderCrank,
            $crate::ScotchYoke,
            $crate::Whitworth,
            $crate::SixBar,
            $crate::HangingChain,
            $crate::FourBars,
            $crate::SpringFollower,
            $crate::CamFollower,
            $crate::HalfCar,
            $crate::CartPole,
            $crate::Skate,
            $crate::BouncingBall,
            $crate::Tumbling,
            $crate::TumblingQuaternion,
            $crate::Top,
            $crate::Gyroscope,
            $crate::Cardan,
            $crate::Bennett,
            $crate::RobotArm,
            $crate::RollingDisc,
            $crate::SphericalPendulum,
            $crate::Stewart,
            $crate::Rssr,
            $crate::Rover
        )
    };
}

/// A mechanism's name, and the mechanism with its declared values as a model.
#[cfg(feature = "erased")]
pub type Shipped = (&'static str, fn() -> alloc::sync::Arc<dyn sim_runtime::Model>);

/// All mechanisms as models of one type, which commands and tests share: their kernels are compiled here, once.
#[cfg(feature = "erased")]
pub fn erased() -> impl ExactSizeIterator<Item = Shipped> {
    fn erased<M: sim_kernel::Compiled>() -> Shipped {
        (const { &M::DESCRIPTION }.name, || sim_runtime::erase(M::defaults()))
    }
    macro_rules! all {
        ($($model:ty),*) => { [$(erased::<$model>()),*] };
    }
    all_models!(all).into_iter()
}
