//! The mechanisms that the checks of kernels run over here: the shipped ones in space and those of this folder.

use sim::Description;

/// Calls a macro with the types of all mechanisms but the overconstrained ones, of which no elimination is planned, and
/// Stewart's platform, whose six legs do not reach most random places.
macro_rules! all_mechanisms {
    ($callback:ident) => {
        $callback!(
            models::Tumbling,
            models::TumblingQuaternion,
            models::Top,
            models::Gyroscope,
            models::Cardan,
            models::RobotArm,
            models::RollingDisc,
            models::SphericalPendulum,
            models::Rssr,
            models::Rover,
            crate::mechanisms::Thrown,
            crate::mechanisms::Gimbal,
            crate::mechanisms::Leashed,
            crate::tree::Held,
            crate::tree::RssrOfJoints
        )
    };
}
pub(crate) use all_mechanisms;

/// What they say of themselves.
pub(crate) fn descriptions() -> Vec<&'static Description> {
    macro_rules! descriptions {
        ($($model:ty),*) => { vec![$(const { &<$model as sim::Compiled>::DESCRIPTION }),*] };
    }
    all_mechanisms!(descriptions)
}
