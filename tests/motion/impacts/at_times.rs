//! Blows at times and at places that they do not turn back.

use super::all_settings;
use tests::any_model::interpreted;
use tests::run_with;

/// A puck that flies at 1 m/s is stopped at 1.3 s by a blow that throws it back at half its speed; it happens once.
#[test]
fn a_blow_at_a_time_happens_once() {
    let declaration = "pub Puck; coordinates { x [m]; } bodies { puck: mass 1 [kg] at [x, 0]; }
        constraints { hand: dot(x) = 0 initially released; } initial { x = 0; dot(x) = 1; }
        events { blow: t = 1.3 [s] rising { impact hand restitution 0.5; } }";
    for settings in all_settings(2.0) {
        let run = run_with(interpreted(declaration).unwrap(), &settings).unwrap();
        assert_eq!(run.trajectory.failure, None);
        assert_eq!(run.events.len(), 1);
        let x = run.trajectory.samples.last().unwrap().state.positions[0];
        assert!((x - (1.3 - 0.5 * 0.7)).abs() < 1e-11, "{x}");
    }
}

/// A wheel turns at 2 rad/s, whatever happens to a puck beside it, which a blow throws back at each turn of the wheel.
#[test]
fn a_blow_by_what_it_does_not_touch_happens_once() {
    let declaration = "pub Beside; coordinates { x [m]; phi [rad]; }
        bodies { puck: mass 1 [kg] at [x, 0]; wheel: inertia 1 [kg*m^2], angle phi; }
        constraints { hand: dot(x) = 0 initially released; } initial { x = 0; dot(x) = 1; phi = 0; dot(phi) = 2; }
        events { blow: sin(phi) = 0.5 rising { impact hand restitution 0.5; } }";
    for settings in all_settings(7.0) {
        let run = run_with(interpreted(declaration).unwrap(), &settings).unwrap();
        assert_eq!(run.trajectory.failure, None);
        // At pi/12, and pi later each: at 1, -1/2, 1/4 and -1/8 m/s.
        assert_eq!(run.events.len(), 3);
        let (first, turn) = (std::f64::consts::PI / 12.0, std::f64::consts::PI);
        let expected = first - turn / 2.0 + turn / 4.0 - (7.0 - first - 2.0 * turn) / 8.0;
        let x = run.trajectory.samples.last().unwrap().state.positions[0];
        assert!((x - expected).abs() < 1e-10, "{x} {expected}");
    }
}

/// What is set is brought onto the constraints before a blow: two bodies that are tied go at (5 + 3)/4 m/s then, and back at half of it.
#[test]
fn what_is_set_is_tied_before_it_strikes() {
    let text = "pub Jump; coordinates { x [m]; y [m]; } bodies { a: mass 1 [kg] at [x, 0]; b: mass 3 [kg] at [y, 0]; }
        constraints { tie: x = y initially active; wall: x = 2 [m] initially released; }
        initial { x = 0; dot(x) = 1; guess y = 0; }
        events { e: t = 2 [s] rising { set dot(x) = 5; impact wall restitution 0.5; } }";
    for settings in all_settings(3.0) {
        let run = run_with(interpreted(text).unwrap(), &settings).unwrap();
        let speeds = &run.trajectory.samples.last().unwrap().state.speeds;
        assert!((speeds[0] + 1.0).abs() < 1e-9 && (speeds[1] + 1.0).abs() < 1e-9, "{speeds:?}");
    }
}

/// A brake that grips and that another event lets go at the same time: x moves by 1 m once and goes on by the force alone.
#[test]
fn a_switch_at_a_time_happens_once() {
    let declaration =
        "pub Braked; coordinates { x [m]; } bodies { sled: mass 2 [kg] at [x, 0]; } loads { force 2 [N] on x; }
        constraints { brake: dot(x) = 0 initially released; } initial { dot(x) = 1; }
        events { on: t = 0.5 [s] rising { set x = x + 1 [m]; activate brake; } off: t = 0.5 [s] { release brake; } }";
    for settings in all_settings(1.0) {
        let run = run_with(interpreted(declaration).unwrap(), &settings).unwrap();
        assert_eq!(run.trajectory.failure, None);
        assert_eq!(run.events.iter().map(|event| event.name).collect::<Vec<_>>(), ["on", "off"]);
        // 0.5 + 1/8 before, 1 by the event, and 1/8 from rest.
        let x = run.trajectory.samples.last().unwrap().state.positions[0];
        assert!((x - 1.75).abs() < 1e-11, "{x}");
    }
}

/// A clutch that is beyond its limit when it closes lets go at once, and stays open.
#[test]
fn a_clutch_beyond_its_limit_closes_once() {
    let declaration = "pub Clutch; coordinates { x [m]; phi [rad]; }
        bodies { sled: mass 2 [kg] at [x, 0]; drum: inertia 0.1 [kg*m^2], angle phi; } loads { force 10 [N] on x; }
        constraints { clutch: dot(x) = 0.1 [m]*dot(phi) initially released; } initial { x = 0; phi = 0; }
        events { close: t = 0.5 [s] rising { activate clutch; } slip: reaction(clutch) = 5 [N] rising { release clutch; } }";
    for settings in all_settings(1.0) {
        let run = run_with(interpreted(declaration).unwrap(), &settings).unwrap();
        assert_eq!(run.trajectory.failure, None);
        assert_eq!(run.events.iter().map(|event| event.name).collect::<Vec<_>>(), ["close", "slip"]);
        // 2.5 m/s of 2 kg are shared with J/r^2 = 10 kg; from then on 5 m/s^2 again.
        let speeds = &run.trajectory.samples.last().unwrap().state.speeds;
        let shared = 2.5 * 2.0 / 12.0;
        let off = [speeds[0] - (shared + 2.5), speeds[1] - shared / 0.1];
        assert!(off.iter().all(|off| off.abs() < 1e-10), "{speeds:?}");
    }
}
