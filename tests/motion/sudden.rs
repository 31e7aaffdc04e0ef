//! What begins and ends within a step that a method could take if nothing happened.

use sim::{Method, Rows, Settings, mechanism};
use std::f64::consts::PI;
use tests::any_model::{interpreted, run_with};

mechanism! {
    /// A mass on a spring, at rest until a blow that lasts 11 ms: half of it rising, half falling.
    Struck;
    coordinates { x [m]; }
    parameters { m [kg] = 1; k [N/m] = 400; }
    tables {
        blow [N] over [ms] = linear { 0, 0; 1000, 0; 1005.5, 500; 1011, 0; }
        knock [N] over [s] = linear, periodic { 0, 0; 0.001, 1; 0.002, 0; 1, 0; }
    }
    bodies { b: mass m at [x, 0]; }
    loads { spring k, rest 0 on x; force blow(t) on x; force 0*knock(t) on x; }
}

/// The response to a force that rises by 1 N/s from 0 on.
fn ramp(time: f64, k: f64, omega: f64) -> f64 {
    if time > 0.0 { (time - (omega * time).sin() / omega) / k } else { 0.0 }
}

/// x by Duhamel's integral.
#[test]
fn a_short_blow_is_not_stepped_over() {
    let slope = 500.0 / 5.5e-3;
    for method in [Method::Dopri5, Method::Dop853, Method::Radau5] {
        for rows in [1, 7, 1000] {
            let settings = Settings { rows: Rows::Even(rows), ..Settings::adaptive(method, 2.0, 1e-10) };
            let run = run_with(Struck::default(), &settings).unwrap();
            assert_eq!(run.trajectory.failure, None);
            for sample in &run.trajectory.samples {
                let t = sample.state.time;
                let [first, second, third] = [1.0, 1.0055, 1.011].map(|begin| ramp(t - begin, 400.0, 20.0));
                let exact = slope * (first - 2.0 * second + third);
                // A thousand steps' errors of at most 1e-10 of its own length.
                assert!((sample.state.positions[0] - exact).abs() < 1e-7, "{}, {t}: {exact}", method.name());
            }
        }
    }
}

mechanism! {
    /// The same mass, pushed in turn by forces that are written in other ways, each for a moment.
    Pushed;
    coordinates { x [m]; }
    parameters { m [kg] = 1; k [N/m] = 400; F [N] = 100; begin [s] = 1; length [s] = 0.01; slow = 2; }
    tables { hat = linear { -1, 0; 0, 1; 1, 0; } }
    bodies { b: mass m at [x, 0]; }
    loads {
        spring k, rest 0 on x;
        force if t < begin then 0 else (if t >= begin + length then 0 else F) on x;
        force F*hat((t - 2*begin)/length) on x;
        force F*hat((3*begin - t)/length) on x;
        force F*max(0, 1 - abs(t - 4*begin)/length) on x;
        force if slow*(t/begin)^2 - 24.99*slow > 0 then (if t < 5*begin then F else 0) else 0 on x;
    }
}

/// x by Duhamel's integral: a jump of the force is the rate of a ramp of it.
#[test]
fn short_forces_are_not_stepped_over() {
    let step = |time: f64| if time > 0.0 { (1.0 - (20.0 * time).cos()) / 400.0 } else { 0.0 };
    let hat = |time: f64, l: f64| [-l, 0.0, l].map(|at| ramp(time - at, 400.0, 20.0));
    let hats = |time: f64| {
        let [rise, fall, end] = hat(time, 0.01);
        (rise - 2.0 * fall + end) / 0.01
    };
    for method in [Method::Dopri5, Method::Dop853, Method::Radau5] {
        for rows in [1, 7, 1000] {
            let settings = Settings { rows: Rows::Even(rows), ..Settings::adaptive(method, 6.0, 1e-10) };
            let run = run_with(Pushed::default(), &settings).unwrap();
            assert_eq!(run.trajectory.failure, None);
            for sample in &run.trajectory.samples {
                let t = sample.state.time;
                let jumps = step(t - 1.0) - step(t - 1.01) + step(t - 24.99f64.sqrt()) - step(t - 5.0);
                let exact = 100.0 * (jumps + hats(t - 2.0) + hats(t - 3.0) + hats(t - 4.0));
                // As above.
                assert!((sample.state.positions[0] - exact).abs() < 1e-7, "{}, {t}: {exact}", method.name());
            }
            // A jump that is met by chance is refused until steps are as short as the tolerance.
            let most = if method == Method::Radau5 { 40 } else { 20 };
            assert!(run.steps.rejected < most, "{}: {} refused", method.name(), run.steps.rejected);
        }
    }
}

/// Where a jump is the end of a run, that ends there and not beyond.
#[test]
fn a_jump_at_the_end_is_not_crossed() {
    for end in [1.0, 1.01, 2.0] {
        let run = run_with(Pushed::default(), &Settings::adaptive(Method::Dop853, end, 1e-10)).unwrap();
        assert_eq!(run.trajectory.samples.last().unwrap().state.time, end);
    }
}

mechanism! {
    /// A wheel that turns evenly.
    Wheel;
    coordinates { phi [rad]; }
    parameters { J [kg*m^2] = 1; w [rad/s] = 1; }
    bodies { wheel: inertia J, angle phi; }
    initial { phi = 0.1; dot(phi) = w; }
    events {
        plain: sin(phi) = 0 rising;
        flat: max(sin(phi), 0.5) = 0.7 rising;
        sharp: exp(20*(cos(phi) - 1)) = 0.5 rising;
    }
}

/// In each turn every event happens once, at the same angle, however long the steps are and however many turns they make.
#[test]
fn events_of_each_turn_are_found() {
    for (turns, w) in [(1.0, 2.0), (10.0, 60.0), (800.0, 300.0)] {
        for method in [Method::Dopri5, Method::Dop853, Method::Radau5] {
            let end = turns * 2.0 * PI / w;
            let run = run_with(Wheel { w, ..Wheel::default() }, &Settings::adaptive(method, end, 1e-10)).unwrap();
            assert_eq!(run.trajectory.failure, None);
            let sharp = 2.0 * PI - (1.0 + 0.5f64.ln() / 20.0).acos();
            for (name, angle) in [("plain", 2.0 * PI), ("flat", 0.7f64.asin()), ("sharp", sharp)] {
                let times: Vec<f64> = run.events.iter().filter(|e| e.name == name).map(|e| e.state.time).collect();
                assert_eq!(times.len(), turns as usize, "{name}, {}", method.name());
                for (k, time) in times.iter().enumerate() {
                    let exact = (angle - 0.1 + 2.0 * PI * k as f64) / w;
                    assert!((time - exact).abs() < 1e-11 * (1.0 + exact), "{name}: {time} for {exact}");
                }
            }
        }
    }
}

mechanism! {
    /// A ball thrown down from the floor itself.
    Thrown;
    coordinates { y [m]; }
    bodies { ball: mass 1 [kg] at [0, y]; }
    constraints { floor: y = 0 initially released; }
    initial { y = 0; dot(y) = -1; }
    events { hit: y = 0 falling { impact floor restitution 0.5; stop; } }
}

/// The state after an impact is a row, also where it happens at the start and ends the run.
#[test]
fn what_an_event_at_the_start_does_is_a_row() {
    let run = run_with(Thrown::default(), &Settings::equal_steps(Method::Rk4, 1.0, 10)).unwrap();
    assert_eq!(run.events.len(), 1);
    assert_eq!(run.trajectory.failure, None);
    let speeds: Vec<f64> = run.trajectory.samples.iter().map(|sample| sample.state.speeds[0]).collect();
    assert_eq!(speeds, [-1.0, 0.5]);
}

mechanism! {
    /// A flywheel whose acceleration depends on nothing.
    Flywheel;
    parameters { T [N*m] = 0.5; C [kg*m^2] = 0.02; }
    bodies { wheel: mass 2 [kg], inertia [0.01 [kg*m^2], 0.01 [kg*m^2], C]; }
    joints { shaft: revolute ground at [0, 0, 0] axis [0, 0, 1] to wheel at [0, 0, 0] axis [0, 0, 1]; }
    loads { torque T on shaft; gravity [0, 0, -9.81 [m/s^2]]; }
    kernels { dynamics_jacobian; }
}

/// phi = T/C t^2/2, also by the method that asks how accelerations change.
#[test]
fn what_nothing_changes_has_no_derivative() {
    let run = run_with(Flywheel::default(), &Settings::adaptive(Method::Radau5, 1.0, 1e-10)).unwrap();
    let last = run.trajectory.samples.last().unwrap();
    assert!((last.state.positions[0] - 12.5).abs() < 1e-8, "{:?}", last.state.positions);
}

mechanism! {
    /// A mass pushed for 4 ms, and struck for as long.
    Knocked;
    coordinates { x [m]; }
    parameters { m [kg] = 1; F [N] = 100; begin [s] = 0.5031; }
    tables { knock [N] over [s] = linear { 0, 0; 0.7012, 0; 0.7034, 50; 0.7056, 0; } }
    bodies { b: mass m at [x, 0]; }
    loads {
        force if t < begin then 0 else (if t < begin + 4 [ms] then F else 0) on x;
        force knock(t) on x;
    }
}

/// Both lie within a step each of 10 ms; of those of 1 ms the push begins and ends in two, and none has two rows of the table.
#[test]
fn equal_steps_over_sudden_changes_are_counted() {
    let changes = |settings: &Settings| {
        let found = run_with(Knocked::default(), settings).unwrap().steps.sudden_changes;
        found.map(|changes| (changes.steps, (changes.first * 1e4).round()))
    };
    for method in [Method::Rk4, Method::Radau5] {
        assert_eq!(changes(&Settings::equal_steps(method, 1.0, 100)), Some((2, 5031.0)));
        assert_eq!(changes(&Settings::equal_steps(method, 1.0, 1000)), Some((2, 5031.0)));
        assert_eq!(changes(&Settings::equal_steps(method, 0.5, 50)), None);
    }
    assert_eq!(changes(&Settings::adaptive(Method::Dopri5, 1.0, 1e-8)), None);
}

mechanism! {
    /// A mass with drag, pushed by one half of a sine.
    Rectified;
    coordinates { x [m]; }
    parameters { m [kg] = 2; F [N] = 10; c [N*s/m] = 0.7; }
    bodies { block: mass m at [x, 0]; }
    loads { force F*max(0, sin(3 [rad/s]*t)) on x; force -c*dot(x) on x; }
    initial { x = 0.3; dot(x) = 20; }
}

/// A step that ends at a sudden change may be far shorter than the next one, which its polynomial must not foretell.
#[test]
fn work_is_right_after_a_short_step() {
    for tolerance in [1e-4, 1e-7, 1e-8, 1e-9, 1e-10, 1e-11] {
        let run = run_with(Rectified::default(), &Settings::adaptive(Method::Radau5, 2.0, tolerance)).unwrap();
        let samples = &run.trajectory.samples;
        let [first, last] = [samples.first().unwrap(), samples.last().unwrap()];
        let gained = last.state.speeds[0].powi(2) - first.state.speeds[0].powi(2);
        // Of 258 J, by some ten steps of that tolerance.
        assert!((last.state.work - gained).abs() < 1e3 * tolerance, "{tolerance}: {} {gained}", last.state.work);
    }
}

mechanism! {
    /// Free masses, pushed for moments that conditions and tables of other forms than `t < T` tell.
    Jolted;
    coordinates { a [m]; b [m]; c [m]; d [m]; e_ [m]; }
    parameters { m [kg] = 1; F [N] = 100; w [1/s] = 7; s = 0.999; late [s] = 5; length [s] = 0.001; wide [s] = 0.1; unit [s] = 1; }
    tables { pulse = linear { 0, 0; 1e-5, 1; 2e-5, 0; } }
    bodies {
        a: mass m at [a, 0]; b: mass m at [b, 0]; c: mass m at [c, 0]; d: mass m at [d, 0]; e_: mass m at [e_, 0];
    }
    loads {
        force if sin(w*t) > s then F else 0 on a;
        force if (t - late)^2 < length^2 then F else 0 on b;
        force if exp(-((t - late)/wide)^2) > 0.9999 then F else 0 on c;
        force F*pulse(((t - late)/unit)^2) on d;
        force F*max(0, sin(w*t) - s) on e_;
    }
}

/// The speeds behind all of it are the impulses over the mass.
#[test]
fn moments_of_any_form_are_not_stepped_over() {
    let (w, s, end) = (7.0, 0.999_f64, 20.0);
    let half = s.acos() / w;
    // sin(w t) is at its largest at (pi/2 + 2 pi k)/w, here 23 times, all around the last one before the end.
    let times = ((w * end - PI / 2.0) / (2.0 * PI)).floor() + 1.0;
    let (inner, outer) = (1e-5_f64.sqrt(), 2e-5_f64.sqrt());
    let hat = inner.powi(3) / 3e-5 + 2.0 * (outer - inner) - (outer.powi(3) - inner.powi(3)) / 3e-5;
    let exact = [
        times * 2.0 * half,
        2.0 * 0.001,
        2.0 * 0.1 * (-0.9999_f64.ln()).sqrt(),
        2.0 * hat,
        times * 2.0 * ((w * half).sin() / w - s * half),
    ];
    for method in [Method::Dopri5, Method::Dop853, Method::Radau5] {
        for rows in [1, 7, 1000] {
            let settings = Settings { rows: Rows::Even(rows), ..Settings::adaptive(method, end, 1e-10) };
            let run = run_with(Jolted::default(), &settings).unwrap();
            assert_eq!(run.trajectory.failure, None);
            let last = &run.trajectory.samples.last().unwrap().state;
            for (k, exact) in exact.iter().enumerate() {
                // Jumps are met to some ticks of time, and each pulse within the tolerance.
                let error = (last.speeds[k] - 100.0 * exact).abs();
                assert!(
                    error < 1e-8 * (1.0 + 100.0 * exact),
                    "{}, {rows} rows, {k}: {}",
                    method.name(),
                    last.speeds[k]
                );
            }
        }
    }
}

/// Equal steps say that they have led over all of them.
#[test]
fn equal_steps_over_moments_are_counted() {
    let run = run_with(Jolted::default(), &Settings::equal_steps(Method::Rk4, 20.0, 50)).unwrap();
    // 23 maxima of the sine, one of them at the end of a step and so in two, and what comes at 5 s.
    assert_eq!(run.steps.sudden_changes.unwrap().steps, 25);
}

/// A force that an event switches on, on the one side of its time or on the other: steps with a tolerance begin behind it, and of equal
/// steps those are counted that take the force of before.
#[test]
fn what_begins_at_once_is_not_missed() {
    for (condition, counted) in [("t > t0", 1), ("t >= t0", 0)] {
        for (start, begin) in [("t0 [s] = 100;", 0.5), ("t0 [s] = 0;", 0.0)] {
            let text = format!(
                "pub Switched; coordinates {{ x [m]; y [m]; }} parameters {{ {start} F [N] = 10; }}
                 bodies {{ b: mass 1 [kg] at [x, 0]; c: mass 1 [kg] at [y, 0]; }}
                 loads {{ force (if {condition} then F else 0) on x; }} initial {{ dot(y) = 1; }}
                 events {{ e: y = 0.5 [m] rising {{ {} }} }}",
                if begin > 0.0 { "set t0 = t;" } else { "set F = F;" }
            );
            let run = |settings: &Settings| tests::run_with(interpreted(&text).unwrap(), settings).unwrap();
            for method in [Method::Dop853, Method::Dopri5, Method::Radau5] {
                let end = run(&Settings::adaptive(method, 2.0, 1e-11)).trajectory.samples.pop().unwrap().state;
                let off = [end.speeds[0] - 10.0 * (2.0 - begin), end.work - 50.0 * (2.0 - begin).powi(2)];
                // Events are located to 1e-12 s.
                assert!(off.iter().all(|off| off.abs() < 1e-8), "{text} {method:?}: {off:?}");
            }
            let changes = run(&Settings::equal_steps(Method::Rk4, 2.0, 1000)).steps.sudden_changes;
            assert_eq!(changes.map_or(0, |changes| changes.steps), counted, "{text}");
        }
    }
}
