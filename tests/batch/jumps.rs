//! Derivatives of motions by the time of a jump of what acts on them, against closed forms and differences of whole runs.

use crate::forward::{check, direction, refusal};
use sim::{ForwardSensitivity, Method, Settings, declared_start};

sim::mechanism! {
    /// A mass that is pushed from one time to another.
    Pushed;
    coordinates { x [m]; }
    parameters { t1 [s] = 0.3; t2 [s] = 0.7; m [kg] = 2; F [N] = 4; }
    bodies { mass: mass m at [x, 0]; }
    loads { force [if t < t1 then 0 else (if t < t2 then F else 0), 0] at [x, 0]; }
    initial { x = 0; dot(x) = 0; }
}

sim::mechanism! {
    /// A pendulum in Cartesian coordinates, struck now and then.
    Struck;
    coordinates { x [m]; y [m]; }
    parameters { t1 [s] = 0.21; w [rad/s] = 17; m [kg] = 2; l [m] = 0.5; g [m/s^2] = 9.81; F [N] = 40; }
    constraints { rod: x^2 + y^2 = l^2; }
    bodies { bob: mass m at [x, y]; }
    loads {
        gravity [0, -g];
        force [if sin(w*(t - t1)) > 0.9 then F else 0, 0] at [x, y];
        force [F*max(0, (t - t1)/(1 [s])), 0] at [x, y];
    }
    initial { x = 0.3; guess y = -0.4; dot(x) = 0; }
}

/// v = F (t2 - t1)/m behind the push, x = F ((T - t1)^2 - (T - t2)^2)/(2 m), and the work is m v^2/2.
#[test]
fn the_times_of_a_push_have_the_derivatives_of_the_solution() {
    let pushed = Pushed::default();
    for method in [Method::Dopri5, Method::Dop853] {
        let settings = Settings::adaptive(method, 1.0, 1e-10);
        for (parameter, sign, ahead) in [(0, -1.0, 0.7), (1, 1.0, 0.3)] {
            let direction = direction(&pushed, Some(parameter), None);
            let mut motion = ForwardSensitivity::new(pushed, &declared_start(&pushed), &settings, &direction).unwrap();
            motion.advance_to(1.0).unwrap();
            let (state, v) = (motion.state(), 4.0 * 0.4 / 2.0);
            let found = [state.positions[0].derivative, state.speeds[0].derivative, state.work.derivative];
            for (found, expected) in found.into_iter().zip([sign * 2.0 * ahead, sign * 2.0, sign * 4.0 * v]) {
                // Steps over a jump are a few rounding errors of time long; the motion between is a polynomial.
                assert!((found - expected).abs() < 1e-13 * expected.abs(), "{parameter}: {found} {expected}");
            }
        }
    }
}

/// Of pulses that move by their start and by their frequency, and of a kink. The error of differences is of second order in
/// 1e-5, and that of adaptive steps is their tolerance over 1e-5.
#[test]
fn pulses_on_a_loop_have_the_derivatives_that_differences_have() {
    let settings = Settings::adaptive(Method::Dop853, 1.0, 1e-12);
    check(&Struck::default(), Some(0), None, &settings, 1e-5);
    check(&Struck::default(), Some(1), None, &settings, 1e-5);
    check(&Struck::default(), Some(2), None, &settings, 1e-5);
}

/// Equal steps lead over jumps, so their motion does not depend on when within a step one comes.
#[test]
fn equal_steps_over_a_jump_that_moves_are_refused() {
    assert!(refusal::<Pushed>(&Settings::equal_steps(Method::Rk4, 1.0, 64)).contains("sudden change"));
}
