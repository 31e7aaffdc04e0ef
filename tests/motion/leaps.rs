//! Conditions of events that leap over zero, by a choice or a sign: no events, however unequal both sides are.

use sim::{Method, Rows, Settings};
use tests::any_model::interpreted;
use tests::run_with;

/// A carriage at 1 m/s, from x = -1 m on.
const LEAPING: &str = "pub Leaping; coordinates { x [m]; } parameters { n = 0; } bodies { a: mass 1 [kg] at [x, 0]; }
    initial { x = -1; dot(x) = 1; }
    events {
        equal: (if x > 0 then 1 else -1) = 0;
        more: (if x > 0 then 1 else -2) = 0;
        less: (if x > 0 then 3 else -1) = 0 rising { set n = n + 1; }
        little: (if x > 0 then 1 else -1e-6) = 0;
        sign: sign(x) = 0;
        shifted: sign(x) + 0.5 = 0;
        falling: (if x > 0.5 [m] then -1 [N] else 3 [N]) = 0 falling { stop; }
        by_time: (if t > 1.3 [s] then 1 else -2) = 0;
        sloping: (if x > 0.25 [m] then x - 0.3 [m] else 2*x - 1 [m]) = 0;
        pole: 1/(x - 0.4 [m]) = 0;
        plain: x = 0.6 [m];
        flat: (x/1 [m])^3 = 1e-9;
        steep: tanh((x - 0.7 [m])/1e-9 [m]) = 0.3;
        root: if x > 0.8 [m] then sqrt(x - 0.8 [m]) else -sqrt(0.8 [m] - x) = 0;
    }";

#[test]
fn leaps_over_zero_are_no_events() {
    // Where x = 0.001 m, 0.3 m and so on; steep by arctanh(0.3) nm later.
    let right = [("flat", 1.001), ("sloping", 1.3), ("plain", 1.6), ("steep", 1.7), ("root", 1.8)];
    let adaptive = |method, rows| Settings { rows, ..Settings::adaptive(method, 2.0, 1e-10) };
    let settings = [
        adaptive(Method::Dop853, Rows::Even(1024)),
        adaptive(Method::Dop853, Rows::Even(1)),
        adaptive(Method::Dopri5, Rows::Steps),
        adaptive(Method::Radau5, Rows::Even(7)),
        Settings::equal_steps(Method::Rk4, 2.0, 333),
    ];
    for settings in settings {
        let run = run_with(interpreted(LEAPING).unwrap(), &settings).unwrap();
        let found: Vec<(&str, f64)> = run.events.iter().map(|event| (event.name, event.state.time)).collect();
        assert_eq!(found.len(), right.len(), "{settings:?}: {found:?}");
        for ((found, time), (name, right)) in found.iter().zip(&right) {
            // A cube root of the rounding of the cube, 1e-9 of its slope; the nanosecond of the steep one.
            assert!(found == name && (time - right).abs() < 1e-9, "{settings:?}: {found} at {time}");
        }
    }
}

/// A load that leaps makes accelerations leap.
#[test]
fn leaps_of_accelerations_are_no_events() {
    let driven = "pub Driven; coordinates { x [m]; } parameters { F [N] = 1; } bodies { a: mass 1 [kg] at [x, 0]; }
        let drive = if x < 0.7 [m] then F else -2*F; loads { force drive on x; } initial { dot(x) = 1; }
        events { reverse: ddot(x) = 0; leap: drive = 0 falling { stop; } top: dot(x) = 0; }";
    for method in [Method::Dop853, Method::Radau5] {
        let run = run_with(interpreted(driven).unwrap(), &Settings::adaptive(method, 2.0, 1e-10)).unwrap();
        let [top] = run.events.as_slice() else { panic!("{:?}", run.events.len()) };
        // With v = sqrt(1 + 2*0.7) at 0.7 m, after v - 1 seconds; then braked at 2 m/s^2.
        let speed = 2.4f64.sqrt();
        let right = (speed - 1.0) + speed / 2.0;
        assert!(top.name == "top" && (top.state.time - right).abs() < 1e-9, "{} {right}", top.state.time);
    }
}
