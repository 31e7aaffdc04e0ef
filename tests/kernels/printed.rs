//! What `codegen` prints, as modules of a program: unlike what a macro makes, it is checked by rustc's lints.

macro_rules! printed {
    ($($module:ident)*) => {
        $(#[deny(unused, non_snake_case)]
        #[allow(dead_code, unreachable_pub)]
        mod $module {
            include!(concat!(env!("CARGO_MANIFEST_DIR"), "/golden/kernels/", stringify!($module), ".rs"));
        })*
    };
}

printed!(bouncing_ball pendulum quick_return skate slider_crank top);

/// It is compiled without warnings, and is the same mechanism.
#[test]
fn printed_kernels_are_those_of_the_macro() {
    let (printed, declared) = (quick_return::QuickReturn::default(), models::QuickReturn::default());
    let at = ([0.3, 1.1, 2.7], [7.0, 1.0, -0.4]);
    let (printed, declared) = (printed.dynamics(0.0, &at.0, &at.1), declared.dynamics(0.0, &at.0, &at.1));
    assert_eq!(printed.accelerations.map(f64::to_bits), declared.accelerations.map(f64::to_bits));
    assert_eq!(printed.multipliers.map(f64::to_bits), declared.multipliers.map(f64::to_bits));
}
