//! Drives with corners in time: speeds jump there by an impulse, in every form of a mechanism.

use sim::{Direction, ForwardSensitivity, Method, Rows, Settings, Stepping, declared_start};
use tests::any_model::interpreted;
use tests::run_with;

/// When the drive starts, in seconds.
const START: f64 = 0.7;

/// A pendulum whose pivot starts at full speed: placed by time, or held to it by a constraint.
fn pendulum(length: f64, is_placed: bool, drive: &str) -> String {
    let (x, held, start) = match is_placed {
        true => ("s", "", ""),
        false => ("x", "constraints { drive: x = s; }", "x = 0;"),
    };
    let coordinates = if is_placed { "phi [rad];" } else { "phi [rad]; x [m];" };
    format!(
        "pub Moved; coordinates {{ {coordinates} }}
         parameters {{ m [kg] = 2; l [m] = {length:e}; g [m/s^2] = {:e}; v [m/s] = {length:e}; w [s] = 1e-7; t0 [s] = {START}; }}
         let s = {drive};
         let p = [{x} + l*sin(phi), -l*cos(phi)];
         bodies {{ bob: mass m at p; trolley: mass 3 [kg] at [{x}, 0]; }}
         loads {{ gravity [0, -g]; }} {held} initial {{ phi = 0.5; {start} }}",
        9.81 * length
    )
}

const CORNER: &str = "if t < t0 then 0 else v*(t - t0)";
/// The same within 1e-7 s, whatever its unit: a logarithm of a large exponential is not finite.
const ROUNDED: &str = "v*w*(max(t - t0, 0)/w + ln(1 + exp(-abs(t - t0)/w)))";

/// Angle, its speed and the work at a time.
fn end(declaration: &str, settings: &Settings) -> [f64; 3] {
    let run = run_with(interpreted(declaration).unwrap(), settings).unwrap();
    assert_eq!(run.trajectory.failure, None, "{declaration}");
    let state = &run.trajectory.samples.last().unwrap().state;
    [state.positions[0], state.speeds[0], state.work]
}

/// The bob keeps its speed along the way that is free to it: phi' falls by v cos(phi)/l.
#[test]
fn a_pivot_that_starts_at_full_speed_strikes_its_pendulum() {
    for length in [1e-3, 1.0, 100.0] {
        for is_placed in [true, false] {
            for method in [Method::Dop853, Method::Dopri5, Method::Radau5] {
                let text = pendulum(length, is_placed, CORNER);
                let at = |end_time| end(&text, &Settings::adaptive(method, end_time, 1e-11));
                let ([angle, before, work], [_, after, done]) = (at(START - 1e-9), at(START + 1e-9));
                let jump = after - before;
                assert!(
                    (jump + angle.cos()).abs() < 1e-7,
                    "{length} {is_placed} {method:?}: {jump}, not {}",
                    angle.cos()
                );
                // The bob goes at v sin(phi) across its way, the trolley at v; along its way the bob keeps what it has.
                let across = angle.sin() * length;
                let exact = (2.0 * across * across + 3.0 * length * length) / 2.0;
                assert!((done - work - exact).abs() < 1e-7 * exact, "{length} {is_placed} {method:?}: {}", done - work);
            }
        }
    }
}

/// Beside a drive that starts within 1e-7 s, over the whole motion, and with rows at the corner itself.
#[test]
fn a_corner_is_what_fast_starts_tend_to() {
    for rows in [Rows::Even(1), Rows::Even(20), Rows::Even(1000), Rows::Steps] {
        let settings = Settings { rows, ..Settings::adaptive(Method::Dop853, 2.0, 1e-11) };
        let exact = end(&pendulum(1.0, true, ROUNDED), &settings);
        for is_placed in [true, false] {
            let found = end(&pendulum(1.0, is_placed, CORNER), &settings);
            let off = found.iter().zip(exact).map(|(found, exact)| (found - exact).abs());
            // In proportion to the time of the start.
            assert!(off.fold(0.0, f64::max) < 1e-5, "{is_placed} {rows:?}: {found:?}, not {exact:?}");
        }
    }
}

/// An equal step does not end at a corner; where constraints say all speeds it need not.
#[test]
fn equal_steps_over_corners_are_refused() {
    let settings = Settings { stepping: Stepping::Equal(1000), ..Settings::adaptive(Method::Rk4, 2.0, 1e-9) };
    for is_placed in [true, false] {
        let model = interpreted(&pendulum(1.0, is_placed, CORNER)).unwrap();
        let failure = run_with(model, &settings).unwrap().trajectory.failure.unwrap();
        assert_eq!(failure.what.code(), "E-CORNER", "{failure}");
    }
    let driven = "pub Driven; coordinates { x [m]; } bodies { b: mass 1 [kg] at [x, 0]; }
                  constraints { drive: x = (if t < 0.7123 [s] then 0 else 2 [m/s]*(t - 0.7123 [s])); } initial { x = 0; }";
    let [x, speed, _] = end(driven, &settings);
    assert!((x - 2.0 * (2.0 - 0.7123)).abs() < 1e-12 && (speed - 2.0).abs() < 1e-12);
}

#[test]
fn a_constraint_that_jumps_is_refused() {
    for (far, code) in [("0.1 [m/s]*t", Some("E-JUMP")), ("0.1 [m/s]*(t - 1.3 [s])", None)] {
        let text = format!(
            "pub Jumps; coordinates {{ x [m]; }} bodies {{ b: mass 1 [kg] at [x, 0]; }}
             constraints {{ drive: x = (if t < 1.3 [s] then 0 [m] else {far}); }} initial {{ x = 0; }}"
        );
        let run = run_with(interpreted(&text).unwrap(), &Settings::new(3.0)).unwrap();
        assert_eq!(run.trajectory.failure.map(|failure| failure.what.code()), code);
        assert!(run.trajectory.samples.last().unwrap().state.time >= 1.2);
    }
}

/// A corner whose time depends on parameters has a derivative that steps held in time do not show.
#[test]
fn sensitivities_end_at_corners() {
    let model = interpreted(&pendulum(1.0, true, CORNER)).unwrap();
    let (start, settings) = (declared_start(&model), Settings::new(2.0));
    let parameters = sim::Mechanism::parameters(&model);
    let direction = Direction {
        parameters: sim::Array::like(&parameters, |_| 1.0),
        positions: sim::Array::like(&start.positions, |_| 0.0),
        speeds: sim::Array::like(&start.speeds, |_| 0.0),
    };
    let mut motion = ForwardSensitivity::new(model, &start, &settings, &direction).unwrap();
    motion.advance_to(0.6).unwrap();
    assert_eq!(motion.advance_to(2.0).unwrap_err().what.code(), "E-NOT-DIFFERENTIABLE");
}

/// A mass on a support that starts at full speed keeps its own speed, in each row: V = -w sin(w t) a, whatever the support does.
#[test]
fn a_support_with_a_corner_moves_no_mass() {
    for support in ["max(0, t - 1 [s])*v", "abs(t - 1 [s])*v", "(if t < 1 [s] then 0 else 3*v*(t - 1 [s]))"] {
        let text = format!(
            "pub Support; coordinates {{ x [m]; }} parameters {{ v [m/s] = 1; }} let r = {support} - {support0};
             bodies {{ b: mass 2 [kg] at [x + r, 0]; }} loads {{ spring 8 [N/m], rest 0 on x + r; }}
             initial {{ x = 1; dot(x) = {start}; }} outputs {{ X [m] = x + r; V [m/s] = dot(x + r); }}",
            support0 = if support.starts_with("abs") { "1 [m]" } else { "0" },
            start = if support.starts_with("abs") { "v" } else { "0" }
        );
        for rows in [Rows::Even(2), Rows::Even(20), Rows::Steps] {
            let settings = Settings { rows, ..Settings::adaptive(Method::Dop853, 2.0, 1e-11) };
            let run = run_with(interpreted(&text).unwrap(), &settings).unwrap();
            assert!(run.energy_balance < 1e-9, "{support} {rows:?}: {:e}", run.energy_balance);
            let table = sim::Table::of(&run.mechanism, &run.trajectory);
            let [x, v] = ["X", "V"].map(|name| table.column(name).unwrap().values.clone());
            for (k, time) in table.times().iter().enumerate() {
                let off = (x[k] - (2.0 * time).cos()).abs() + (v[k] + 2.0 * (2.0 * time).sin()).abs();
                assert!(off < 1e-8, "{support} {rows:?} {time}: {} {}", x[k], v[k]);
            }
        }
    }
}

/// An event starts the drive of a cart where its pendulum passes its lowest point: the bob is as much slower beside the cart as this is
/// faster, and swings with its energy from then on, whichever side the drive belongs to at that time.
#[test]
fn a_drive_that_an_event_starts_strikes_at_once() {
    let drives = [
        "max(0, t - t0)",
        "max(t - t0, 0)",
        "(if t <= t0 then 0 else t - t0)",
        "(if t > t0 then t - t0 else 0)",
        "(if t < t0 then 0 else t - t0)",
    ];
    for (drive, length) in drives.into_iter().flat_map(|drive| [1e-3, 1.0, 100.0].map(|length| (drive, length))) {
        let text = format!(
            "pub Late; coordinates {{ x [m]; p [rad]; }}
             parameters {{ l [m] = {length:e}; g [m/s^2] = {:e}; v [m/s] = {length:e}; t0 [s] = 100; }}
             bodies {{ cart: mass 5 [kg] at [x, 0]; bob: mass 1 [kg] at [x, 0] + l*[sin(p), -cos(p)]; }}
             loads {{ gravity [0, -g]; }} constraints {{ drive: x = v*{drive}; }}
             initial {{ p = 1; guess x = 0; }} events {{ start: p = 0 falling {{ set t0 = t; }} }}",
            9.81 * length
        );
        let fall = 9.81 * (1.0 - 1.0f64.cos());
        let energy = (-(2.0 * fall).sqrt() - 1.0).powi(2) / 2.0 - 9.81;
        for method in [Method::Dop853, Method::Dopri5, Method::Radau5] {
            let run = run_with(interpreted(&text).unwrap(), &Settings::adaptive(method, 2.0, 1e-11)).unwrap();
            assert_eq!(run.trajectory.failure, None, "{text}");
            let state = &run.trajectory.samples.last().unwrap().state;
            let swings = state.speeds[1].powi(2) / 2.0 - 9.81 * state.positions[1].cos();
            assert!((swings - energy).abs() < 1e-6, "{drive} {length} {method:?}: {swings}, not {energy}");
        }
        let equal = run_with(interpreted(&text).unwrap(), &Settings::equal_steps(Method::Rk4, 2.0, 400)).unwrap();
        match equal.trajectory.failure {
            Some(failure) => assert_eq!(failure.what.code(), "E-CORNER", "{drive}"),
            None => assert!(!equal.events[0].change.as_ref().unwrap().impulses.as_ref()[0].is_nan(), "{drive}"),
        }
    }
}

/// A drive that has its corner at the very start, or at the very end.
#[test]
fn corners_at_ends_do_their_work() {
    for (drive, from) in [("max(0, t)", 0.0), ("max(t - 1 [s], 0)", 1.0), ("max(0, t - 0.5 [s])", 0.5)] {
        let text = format!(
            "pub Ends; coordinates {{ x [m]; }} bodies {{ b: mass 3 [kg] at [x, 0]; }}
             constraints {{ drive: x = 2 [m/s]*{drive}; }} initial {{ guess x = 0; }}"
        );
        let run = run_with(interpreted(&text).unwrap(), &Settings::new(1.0)).unwrap();
        assert_eq!(run.trajectory.failure, None, "{drive}");
        let state = &run.trajectory.samples.last().unwrap().state;
        let [way, speed, work] = [state.positions[0] - 2.0 * (1.0 - from), state.speeds[0] - 2.0, state.work - 6.0];
        assert!([way, speed, work].iter().all(|off| off.abs() < 1e-12), "{drive}: {way} {speed} {work}");
    }
}
