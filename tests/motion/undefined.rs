//! Events whose conditions are undefined in a part of the motion, and those of a method of order 1.

use sim::{Method, Settings, mechanism};
use std::f64::consts::PI;
use tests::any_model::{self, interpreted};
use tests::run_with;

/// A mass on a spring, x = cos(sqrt(40) t), with an event.
fn oscillator(condition: &str) -> String {
    format!(
        "pub Oscillator; coordinates {{ x [m]; }} bodies {{ mass: mass 1 [kg] at [x, 0]; }}
         loads {{ force -40 [N/m]*x on x; }} initial {{ x = 1; }} events {{ met: {condition}; }}"
    )
}

/// Where x has a value, twice in each period.
fn times(value: f64, end: f64) -> Vec<f64> {
    let (w, phase) = (40f64.sqrt(), value.acos());
    let each = (0..).flat_map(|turn| [2.0 * PI * f64::from(turn) + phase, 2.0 * PI * f64::from(turn + 1) - phase]);
    each.map(|angle| angle / w).take_while(|time| *time < end).collect()
}

/// Conditions that are defined on one side, close to the border and far from it, or between two borders.
#[test]
fn events_are_found_up_to_where_their_conditions_are_defined() {
    let conditions = [
        ("sqrt(x/(1 [m])) = 0.3", 0.09),
        ("sqrt(x/(1 [m])) = 0.02", 4e-4),
        ("sqrt(x/(1 [m]) - 0.5) = 0.1", 0.51),
        ("sqrt(x/(1 [m]) - 0.99) = 0.05", 0.9925),
        ("sqrt(-x/(1 [m]) - 0.9) = 0.2", -0.94),
        ("ln(x/(1 [m])) = -1", (-1f64).exp()),
        ("asin(1.2*x/(1 [m])) = 0.9", 0.9f64.sin() / 1.2),
        ("acos(5*x/(1 [m])) = 0.2", 0.2f64.cos() / 5.0),
        ("1/x = 1.5 [1/m]", 1.0 / 1.5),
    ];
    let end = 10.0;
    let adaptive = |method, tolerance| Settings::adaptive(method, end, tolerance);
    let settings = [
        adaptive(Method::Dop853, 1e-10),
        adaptive(Method::Dop853, 1e-6),
        adaptive(Method::Dopri5, 1e-9),
        adaptive(Method::Radau5, 1e-9),
        Settings::equal_steps(Method::Rk4, end, 4000),
    ];
    for (condition, value) in conditions {
        let right = times(value, end);
        for settings in &settings {
            let run = run_with(interpreted(&oscillator(condition)).unwrap(), settings).unwrap();
            let found: Vec<f64> = run.events.iter().map(|event| event.state.time).collect();
            assert_eq!(found.len(), right.len(), "{condition} by {settings:?}: {found:?}");
            for (found, right) in found.iter().zip(&right) {
                // The loosest tolerance, over ten periods, where x is slowest at the value: x' = 6 sqrt(1 - x^2).
                assert!((found - right).abs() < 1e-4, "{condition} by {settings:?}: {found} {right}");
            }
        }
    }
}

mechanism! {
    /// A mass on a spring that turns at both ends.
    Swinging;
    coordinates { x [m]; }
    bodies { mass: mass 1 [kg] at [x, 0]; }
    loads { force -40 [N/m]*x on x; }
    initial { x = 1; }
    events { rest: dot(x) = 0; period: dot(x) = 0 falling; }
}

/// Euler's positions contradict its speeds by a part of the step, which no polynomial between them may turn into a rest.
#[test]
fn no_step_of_order_1_has_a_rest_of_its_own() {
    let (end, half) = (2.3, PI / 40f64.sqrt());
    for count in [2_000, 20_000, 200_000] {
        let run = any_model::run_with(Swinging::default(), &Settings::equal_steps(Method::Euler, end, count)).unwrap();
        let rests: Vec<f64> =
            run.events.iter().filter(|event| event.name == "rest").map(|event| event.state.time).collect();
        assert_eq!(rests.len(), 4, "{rests:?}");
        for (k, rest) in rests.iter().enumerate() {
            // Damped by -h w^2/2, the frequency is off by parts of (h w)^2, and a place in a step by h.
            let off = rest - (k + 1) as f64 * half;
            assert!(off.abs() < 2.0 * end / count as f64, "{rests:?}");
        }
        assert!((run.period().unwrap() - 2.0 * half).abs() < 2.0 * end / count as f64);
    }
}
