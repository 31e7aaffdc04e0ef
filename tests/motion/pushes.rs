//! Loads that change at positions and speeds: pushes at an angle, strips, kinks.

use sim::{Method, Rows, Settings, mechanism};
use std::f64::consts::PI;
use tests::any_model::{interpreted, run_with};

mechanism! {
    /// A wheel that is pushed at an angle, as an engine fires, by forces that are written in several ways.
    Fired;
    coordinates { phi [rad]; }
    parameters { J [kg*m^2] = 1; w [rad/s] = 1; T [N*m] = 0.1; s = 0.99; form = 0; from = 1.3; to = 1.4; }
    tables { fire = linear, periodic { 0, 0; 1.3, 0; 1.31, 5; 1.32, 0; 6.283185307179586, 0; } }
    bodies { wheel: inertia J, angle phi; }
    loads {
        torque if form > 2.5 then T*fire(phi) else 0 on phi;
        torque if form < 0.5 then (if sin(phi) > s then T else 0) else 0 on phi;
        torque if form > 0.5 then (if form < 1.5 then T*max(0, sin(phi) - s) else 0) else 0 on phi;
        torque if form > 1.5 then (if form < 2.5 then (if phi > from then (if phi < to then T else 0) else 0) else 0) else 0 on phi;
    }
    initial { phi = 0; dot(phi) = w; }
}

/// The kinetic energy is what the load has done, which depends on the angle alone.
#[test]
fn pushes_at_an_angle_are_not_stepped_over() {
    let half = 0.99_f64.acos();
    let each = [0.1 * 2.0 * half, 0.1 * (2.0 * half.sin() - 0.99 * 2.0 * half), 0.01, 0.1 * 0.05];
    for method in [Method::Dopri5, Method::Dop853, Method::Radau5] {
        for (form, each) in each.iter().enumerate() {
            for (w, rtol) in [(1.0, 1e-10), (1.0, 1e-6), (1.0, 1e-4), (30.0, 1e-8)] {
                let wheel = Fired { w, form: form as f64, ..Fired::default() };
                let settings = Settings { rows: Rows::Even(3), ..Settings::adaptive(method, 200.0 / w, rtol) };
                let run = run_with(wheel, &settings).unwrap();
                let last = &run.trajectory.samples.last().unwrap().state;
                let (phi, speed) = (last.positions[0], last.speeds[0]);
                let turns = ((phi - PI / 2.0 - half) / (2.0 * PI)).floor() + 1.0;
                let pushes = if form == 2 { 1.0 } else { turns };
                let gained = pushes * each / (w * w / 2.0);
                let found = speed * speed / (w * w) - 1.0;
                // In each turn two jumps, each to a tenth of the tolerance, or two or three kinks, which estimates of errors find. Of a
                // kink before the second stage of dopri5 its estimate sees a hundredth.
                let tolerances = if form % 2 == 0 { 0.2 } else { 100.0 };
                let error = (found - gained).abs();
                assert!(
                    error < tolerances * turns * rtol,
                    "{}, form {form}, {w}, {rtol}: {found} for {gained}",
                    method.name()
                );
            }
        }
    }
}

/// What equal steps of this length say of a wheel with the angle phi = t, whose torque is too small to matter.
fn noted(form: usize, step: f64) -> Option<u64> {
    let wheel = Fired { form: form as f64, T: 1e-9, ..Fired::default() };
    let settings = Settings::equal_steps(Method::Rk4, 20.0, (20.0 / step).round() as usize);
    run_with(wheel, &settings).unwrap().steps.sudden_changes.map(|changes| changes.steps)
}

/// Of pushes at an angle, three in three turns, those that jump count in every step over an edge. Others are continuous: they
/// count where all of a push lies within a step.
#[test]
fn equal_steps_over_pushes_at_an_angle_are_counted() {
    // sin(phi) > 0.99 from 1.429 to 1.712, and 2 pi and 4 pi later; phi from 1.3 to 1.4, and a table from 1.3 to 1.32.
    assert_eq!(noted(0, 0.01), Some(6));
    assert_eq!(noted(0, 1.25), Some(3));
    assert_eq!(noted(1, 0.01), None);
    assert_eq!(noted(1, 1.25), Some(3));
    assert_eq!(noted(2, 0.01), Some(2));
    assert_eq!(noted(2, 1.25), Some(1));
    assert_eq!(noted(3, 0.001), None);
    assert_eq!(noted(3, 0.1), Some(3));
}

mechanism! {
    /// A mass that goes through a narrow strip, in which it is pushed.
    Strip;
    coordinates { x [m]; }
    parameters { m [kg] = 1; F [N] = 1000; from [m] = 1; to [m] = 1.001; }
    bodies { b: mass m at [x, 0]; }
    loads { force if x > from then (if x < to then F else 0) else 0 on x; }
    initial { x = 0; dot(x) = 1; }
}

/// The speed behind it is the root of 3, and equal steps are off in its second digit, however short: they say so.
#[test]
fn equal_steps_through_a_strip_are_counted() {
    for (steps, counted) in [(13, 1), (1000, 2), (20_000, 2)] {
        let run = run_with(Strip::default(), &Settings::equal_steps(Method::Rk4, 1.5, steps)).unwrap();
        let changes = run.steps.sudden_changes.unwrap();
        assert_eq!(changes.steps, counted, "{steps} steps");
        // It is there at 1 s.
        assert!((changes.first - 1.0).abs() < 1.5 / steps as f64, "{steps} steps: {}", changes.first);
        assert!((run.trajectory.samples.last().unwrap().state.speeds[0] - 3f64.sqrt()).abs() > 0.01);
    }
}

mechanism! {
    /// A mass that bounces on a ground that only pushes, and one on a spring in a fluid.
    Kinked;
    coordinates { y [m]; z [m]; }
    parameters { m [kg] = 1; k [N/m] = 10000; g [m/s^2] = 9.81; c [kg/m] = 5; slow [N*s/m] = 0; }
    bodies { b: mass m at [y, 0]; d: mass m at [z, 0]; }
    loads {
        force -m*g + max(0, -k*y) on y;
        force if y < 0 then -slow*dot(y) else 0 on y;
        force -k/100*z - c*abs(dot(z))*dot(z) on z;
    }
    initial { y = 0.1; z = 0.4; }
}

/// Kinks leave equal steps their second order, and are no news where a contact takes 30 steps. The force of a damper jumps where a
/// contact begins and ends, by 0.014 of 9.8 m/s^2: from a fall of 0.143 s on every 0.318 s, of which the contact takes 0.033 s, nine
/// times in 3 s.
#[test]
fn equal_steps_over_kinks_are_not_counted() {
    let noted = |slow: f64| {
        let settings = Settings::equal_steps(Method::Rk4, 3.0, 3000);
        run_with(Kinked { slow, ..Kinked::default() }, &settings).unwrap().steps.sudden_changes
    };
    assert_eq!(noted(0.0), None);
    assert_eq!(noted(0.01).unwrap().steps, 18);
}

/// A wheel with teeth is pushed at each, and a mass at each mark of a bar: the kinetic energy is what as many pushes have done as lie
/// behind. Of each, its two jumps may be wrong by a tenth of the tolerance.
#[test]
fn pushes_that_come_often_in_a_turn_are_not_stepped_over() {
    let height = 0.9999_f64;
    let wheel = |teeth: f64| {
        let load = format!("torque (if sin({teeth}*p) > {height} then 25 [N*m] else 0) on b;");
        (format!("coordinates {{ p [rad]; }} bodies {{ b: inertia 1 [kg*m^2], angle p; }} loads {{ {load} }}"), teeth)
    };
    let bar = |pitch: f64| {
        let load = format!("force (if sin(2*pi*p/({pitch} [m])) > {height} then 25 [N] else 0) on p;");
        (
            format!("coordinates {{ p [m]; }} bodies {{ b: mass 1 [kg] at [p, 0]; }} loads {{ {load} }}"),
            2.0 * PI / pitch,
        )
    };
    for (declared, frequency) in [wheel(5.0), wheel(12.0), wheel(48.0), bar(0.1), bar(3.0)] {
        let declared = format!("pub Often; {declared} initial {{ p = 0.01; dot(p) = 50; }}");
        for method in [Method::Dopri5, Method::Dop853, Method::Radau5] {
            let settings = Settings { rows: Rows::Even(1), ..Settings::adaptive(method, 0.5, 1e-10) };
            let run = tests::run_with(interpreted(&declared).unwrap(), &settings).unwrap();
            let last = &run.trajectory.samples.last().unwrap().state;
            let width = 2.0 * height.acos() / frequency;
            let behind = ((frequency * last.positions[0] - PI / 2.0) / (2.0 * PI)).floor() + 1.0;
            let expected = (2500.0 + 2.0 * 25.0 * width * behind).sqrt();
            let error = (last.speeds[0] - expected).abs();
            assert!(behind >= 8.0 && error < 0.2 * behind * 1e-10 * 50.0, "{declared} {}: {error:e}", method.name());
        }
    }
}

/// A mass flies against a wall that repels it by V = k/(1 - x)^12, too weak to be seen from afar, and is thrown back at its own speed:
/// it turns where V is its energy. The pole itself is no wall for a force that is finite there, as sin(x)/x.
#[test]
fn no_step_leads_over_a_pole() {
    let wall = "pub Wall; coordinates { x [m]; } bodies { b: mass 1 [kg] at [x, 0]; }
        loads { potential 1e-25 [J*m^12]/(1 [m] - x)^12; } initial { x = -10; dot(x) = 1; }";
    for (method, rtol) in
        [(Method::Dopri5, 1e-8), (Method::Dop853, 1e-10), (Method::Dop853, 1e-13), (Method::Radau5, 1e-10)]
    {
        let run = tests::run_with(interpreted(wall).unwrap(), &Settings::adaptive(method, 22.0, rtol)).unwrap();
        let last = &run.trajectory.samples.last().unwrap().state;
        // By an integration with steps of 1 ms at most, SciPy's DOP853 at 1e-12: the potential is a wall 2.1 mm wide.
        assert!((last.positions[0] + 10.015380).abs() < 1e-5 && (last.speeds[0] + 1.0).abs() < 1e-5, "{last:?}");
    }
    // A wall of 10 micrometres, towards which a steady force drives: back at its start after twice the time that it takes to 1 m.
    let driven = wall.replace("1e-25", "1e-60").replace("^12;", "^12; force 0.1 [N] on x;");
    let there = (1.0_f64 + 0.2 * 11.0).sqrt() / 0.1 - 10.0;
    let run = tests::run_with(interpreted(&driven).unwrap(), &Settings::new(2.0 * there)).unwrap();
    let last = &run.trajectory.samples.last().unwrap().state;
    assert!((last.positions[0] + 10.0).abs() < 1e-4 && (last.speeds[0] + 1.0).abs() < 1e-4, "{last:?}");
    // A pole where the load has a condition too, as it is written for both directions.
    let both = "pub Both; coordinates { x [m]; } bodies { b: mass 1 [kg] at [x, 0]; }
        loads { spring 10 [N/m], rest 0 on x; force 1e-9 [N*m^2]/x^2*sign(x) on x; } initial { x = 1; }";
    let run = tests::run_with(interpreted(both).unwrap(), &Settings::adaptive(Method::Dopri5, 20.0, 1e-8)).unwrap();
    let all = || run.trajectory.samples.iter().map(|sample| sample.state.positions[0]);
    assert!(run.trajectory.failure.is_none() && all().all(|x| x > 0.0) && all().any(|x| x < 0.1));
    // A denominator that is never zero costs nothing, however far a step turns.
    let turning = "pub Turning; coordinates { a [rad]; g [rad]; } bodies { b: inertia 1 [kg*m^2], angle a; c: inertia 1 [kg*m^2], angle g; }
        loads { torque 0 [N*m]/(1 - sin(g)^2*cos(a)^2) on b; torque 1e-30 [N*m]*tan(a - g)/(1 - sin(g)^2*cos(a)^2) on c; }
        initial { a = 0; g = 0; dot(a) = 3000; dot(g) = 3000; }";
    let run = tests::run_with(interpreted(turning).unwrap(), &Settings { rows: Rows::Even(1), ..Settings::new(600.0) })
        .unwrap();
    assert!(run.evaluations < 1000, "{}", run.evaluations);
    let smooth = "pub Smooth; coordinates { x [m]; } bodies { b: mass 1 [kg] at [x, 0]; }
        loads { force -3 [N]*sin(x/(1 [m]))*(1 [m])/x on x; } initial { x = -1; dot(x) = 4; }";
    let run = tests::run_with(interpreted(smooth).unwrap(), &Settings::adaptive(Method::Dop853, 1.0, 1e-11)).unwrap();
    assert!(run.trajectory.failure.is_none() && run.trajectory.samples.last().unwrap().state.positions[0] > 1.5);
    assert!(run.steps.accepted < 40, "{}", run.steps.accepted);
}

/// The angle goes from 1 to 13 rad.
#[test]
fn equal_steps_over_the_cut_of_atan2_are_counted() {
    let declared = "pub Cut; coordinates { p [rad]; x [m]; }
        bodies { wheel: inertia 1 [kg*m^2], angle p; b: mass 1 [kg] at [x, 0]; }
        loads { force 1 [N]*atan2(sin(p), cos(p)) on x; } initial { p = 1; dot(p) = 3; x = 0; }";
    let run = tests::run_with(interpreted(declared).unwrap(), &Settings::equal_steps(Method::Rk4, 4.0, 4001)).unwrap();
    // pi and 3 pi are passed; at 2 pi and 4 pi nothing jumps.
    let changes = run.steps.sudden_changes.unwrap();
    assert_eq!(changes.steps, 2);
    assert!((changes.first - (PI - 1.0) / 3.0).abs() < 1e-3, "{}", changes.first);
}
