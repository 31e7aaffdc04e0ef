//! Derivatives of motions over jumps of what acts on them, against closed forms and differences of whole runs.

use crate::forward::{check, direction, erased, refusal};
use sim::{Compiled, ForwardSensitivity, Mechanism, Method, Settings, declared_start};
use tests::any_model::interpreted;

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
fn check_push<M: Mechanism>(pushed: &M) {
    for method in [Method::Dopri5, Method::Dop853] {
        let settings = Settings::adaptive(method, 1.0, 1e-10);
        for (parameter, sign, ahead) in [(0, -1.0, 0.7), (1, 1.0, 0.3)] {
            let direction = direction(pushed, Some(parameter), None);
            let start = declared_start(pushed);
            let mut motion = ForwardSensitivity::new(pushed.clone(), &start, &settings, &direction).unwrap();
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

/// With its type, without it, and from its text.
#[test]
fn the_times_of_a_push_have_the_derivatives_of_the_solution() {
    check_push(&Pushed::default());
    check_push(&erased(Pushed::default()));
    check_push(&interpreted(<Pushed as Compiled>::DESCRIPTION.declaration).unwrap());
}

/// Of pulses that move by their start and by their frequency, and of a kink. The error of differences is of second order in
/// 1e-5, and that of adaptive steps is their tolerance over 1e-5.
#[test]
fn pulses_on_a_loop_have_the_derivatives_that_differences_have() {
    let settings = Settings::adaptive(Method::Dop853, 1.0, 1e-12);
    check(&erased(Struck::default()), Some(0), None, &settings, 1e-5);
    check(&erased(Struck::default()), Some(1), None, &settings, 1e-5);
    check(&erased(Struck::default()), Some(2), None, &settings, 1e-5);
}

/// Equal steps lead over jumps, so their motion does not depend on when within a step one comes.
#[test]
fn equal_steps_over_a_jump_that_moves_are_refused() {
    assert!(refusal(Pushed::default(), &Settings::equal_steps(Method::Rk4, 1.0, 64)).contains("sudden change"));
}

sim::mechanism! {
    /// A wheel that is pushed at an angle, once in each turn.
    Fired;
    coordinates { phi [rad]; }
    parameters { J [kg*m^2] = 1; T [N*m] = 0.1; s = 0.99; }
    bodies { wheel: inertia J, angle phi; }
    loads { torque if sin(phi) > s then T else 0 on phi; }
    initial { phi = 0; dot(phi) = 1; }
}

/// Behind four pushes, each over the angle 2 acos(s), J v^2/2 = J w^2/2 + 8 T acos(s).
#[test]
fn pushes_at_an_angle_have_the_derivatives_of_their_energy() {
    let fired = erased(Fired::default());
    let (half, root) = (0.99_f64.acos(), (1.0 - 0.99_f64.powi(2)).sqrt());
    let v = (1.0 + 16.0 * 0.1 * half).sqrt();
    let cases = [
        (direction(&fired, Some(0), None), -0.8 * half / v),
        (direction(&fired, Some(1), None), 8.0 * half / v),
        (direction(&fired, Some(2), None), -0.8 / (root * v)),
        (direction(&fired, None, Some(0)), 1.0 / v),
    ];
    for method in [Method::Dopri5, Method::Dop853] {
        for tolerance in [1e-6, 1e-10] {
            for (direction, expected) in &cases {
                let settings = Settings::adaptive(method, 22.0, tolerance);
                let mut motion =
                    ForwardSensitivity::new(fired.clone(), &declared_start(&fired), &settings, direction).unwrap();
                motion.advance_to(22.0).unwrap();
                let found = motion.state().speeds[0];
                assert!((found.value - v).abs() < tolerance, "{} {tolerance}: {found:?} {v}", method.name());
                // Eight jumps, each passed by a step of a tenth of the tolerance; by s they move by 7 rad.
                let error = (found.derivative - expected).abs();
                assert!(error < 10.0 * tolerance, "{} {tolerance}: {found:?} {expected}", method.name());
            }
        }
    }
}

sim::mechanism! {
    /// A pendulum in Cartesian coordinates, pushed along its way beside the lowest point, with a brake whose force depends on the
    /// direction, and a force with a kink.
    Kicked;
    coordinates { x [m]; y [m]; }
    parameters { l [m] = 1; F [N] = 5; width [m] = 0.1; B [N] = 0.2; m [kg] = 1; g [m/s^2] = 9.81; }
    constraints { rod: x^2 + y^2 = l^2; }
    bodies { bob: mass m at [x, y]; }
    loads {
        gravity [0, -g];
        force [if x > 0 then (if x < width then (if dot(x) > 0 then F else -F) else 0) else 0, 0] at [x, y];
        force [if dot(x) > 0 then -B else B, max(0, -x)*F/l] at [x, y];
    }
    initial { x = 0.5; guess y = -0.8; dot(x) = 0.1; }
}

/// Jumps at positions and at a speed, and a kink. The errors of differences are as above.
#[test]
fn pushes_along_a_way_have_the_derivatives_that_differences_have() {
    for method in [Method::Dopri5, Method::Dop853] {
        let settings = Settings::adaptive(method, 2.5, 1e-12);
        for parameter in 0..4 {
            check(&erased(Kicked::default()), Some(parameter), None, &settings, 1e-5);
        }
        check(&erased(Kicked::default()), None, Some(0), &settings, 1e-5);
    }
}

/// Where in an equal step a jump lies changes nothing, so the motion has no derivative that would be right.
#[test]
fn equal_steps_over_a_jump_at_a_position_are_refused() {
    assert!(refusal(erased(Fired::default()), &Settings::equal_steps(Method::Rk4, 2.0, 64)).contains("sudden change"));
}

/// A mass that a table moves, from a time on, and a spring: its accelerations jump at rows whose times move. Errors of differences
/// are as above.
#[test]
fn rows_of_a_table_that_moves_a_mass_have_the_derivatives_that_differences_have() {
    let led = interpreted(
        "pub Led; coordinates { y [m]; } parameters { t0 [s] = 0.02; k [N/m] = 30; m [kg] = 2; }
         tables { way [m] over [s] = monotone { 0, 0; 0.3, 0.1; 0.5, 0.5; 0.8, 0.6; 2, 1; } }
         bodies { mass: mass m at [way(t + t0) + y, 0]; } loads { spring k, rest 0 on y; } initial { y = 0.1; }",
    )
    .unwrap();
    for method in [Method::Dopri5, Method::Dop853] {
        check(&led, Some(0), None, &Settings::adaptive(method, 1.0, 1e-12), 1e-5);
    }
    assert!(refusal(led, &Settings::equal_steps(Method::Rk4, 1.0, 64)).contains("sudden change"));
}

/// The derivatives of the end by a parameter, of a mass on a line, after stops at these times.
fn end(text: &str, parameter: usize, settings: &Settings, stops: &[f64]) -> [f64; 2] {
    let model = interpreted(text).unwrap();
    let direction = direction(&model, Some(parameter), None);
    let mut motion = ForwardSensitivity::new(model.clone(), &declared_start(&model), settings, &direction).unwrap();
    for stop in stops {
        motion.advance_to(*stop).unwrap();
    }
    motion.advance_to(settings.end).unwrap();
    [motion.state().positions[0].derivative, motion.state().speeds[0].derivative]
}

fn near(found: [f64; 2], expected: [f64; 2], bound: f64, case: &str) {
    let error = (found[0] - expected[0]).abs().max((found[1] - expected[1]).abs());
    assert!(error < bound, "{case}: {found:?} for {expected:?}");
}

/// A mass under a load.
fn loaded(load: &str, tables: &str) -> String {
    format!(
        "pub Loaded; coordinates {{ x [m]; }} parameters {{ a [N] = 2; s [s] = 0.4; w = 1; }} tables {{ {tables} }}
         bodies {{ b: mass 1 [kg] at [x, 0]; }} loads {{ force {load} on x; }} initial {{ x = 0; dot(x) = 0.3; }}"
    )
}

/// Wherever a jump lies, and however far away the end is, also beside a coordinate that is far faster: v = 0.3 + a (t - s) at a time t.
#[test]
fn a_jump_anywhere_has_the_derivative_of_its_time() {
    let beside = loaded("if t < s then 0 [N] else a", "")
        .replace("coordinates {", "coordinates { z [m];")
        .replace("bodies {", "bodies { c: mass 1 [kg] at [0, z];")
        .replace("loads {", "loads { force [0, 1e6 [N]] at [0, z];");
    let alone = loaded("if t < s then 0 [N] else a", "");
    let falling = loaded("if t < s then a else 0 [N]", "");
    for (text, sign) in [(&alone, 1.0), (&beside, 1.0), (&falling, -1.0)] {
        let model = interpreted(text).unwrap();
        let by_start = direction(&model, Some(1), None);
        for (tolerance, end) in [(1e-6, 1.0), (1e-10, 2.0), (1e-10, 5.0), (1e-10, 1e9)] {
            for hundredths in 1..100 {
                let mut parameters = model.parameters();
                parameters[1] = f64::from(hundredths) / 100.0;
                let model = model.with_parameters(parameters);
                let settings = Settings::adaptive(Method::Dop853, end, tolerance);
                let start = declared_start(&model);
                let mut motion = ForwardSensitivity::new(model.clone(), &start, &settings, &by_start).unwrap();
                motion.advance_to(1.0).unwrap();
                let found = motion.state().speeds.as_ref().last().unwrap().derivative;
                assert!((found + sign * 2.0).abs() < 1e-12, "{text}, s = {hundredths}/100, end {end}: {found}");
            }
        }
    }
}

/// Where a step ends on a jump, as at a stop: x = x0 + a (T - s)^2/2.
#[test]
fn derivatives_behind_stops_at_a_jump_are_right() {
    for condition in ["t < s", "t <= s", "s - t > 0 [s]", "sin(t*1 [rad/s]) < sin(s*1 [rad/s])"] {
        let text = loaded(&format!("if {condition} then 0 [N] else a"), "");
        let settings = [(Method::Dopri5, 1.0, 1e-10), (Method::Dop853, 1.0, 1e-10), (Method::Dop853, 2.0, 1e-6)];
        for (method, last, tolerance) in settings {
            for stops in [&[][..], &[0.4], &[0.25, 0.4, 0.7], &[0.4 - 1e-15, 0.4 + 1e-15]] {
                let settings = Settings::adaptive(method, last, tolerance);
                let ahead = last - 0.4;
                near(end(&text, 1, &settings, stops), [-2.0 * ahead, -2.0], 1e-12, condition);
                near(end(&text, 0, &settings, stops), [ahead * ahead / 2.0, ahead], 1e-12, condition);
            }
        }
        // In a long motion times are coarser.
        if !condition.contains("sin") {
            for stops in [&[][..], &[0.4], &[0.4 - 1e-13, 0.4 + 1e-12]] {
                let found = end(&text, 1, &Settings::adaptive(Method::Dop853, 1000.0, 1e-10), stops);
                near(found, [-2.0 * 999.6, -2.0], 1e-9, condition);
            }
        }
        for steps in [10, 100] {
            let why = refusal(interpreted(&text).unwrap(), &Settings::equal_steps(Method::Rk4, 1.0, steps));
            assert!(why.contains("sudden change"), "{condition}: {why}");
        }
    }
}

/// Corners at ends of steps: of a table whose row is there, of an input's course, and of functions. From s = 0.4 s on the force grows,
/// so that x = x0 + a (T - s)^3/6.
#[test]
fn derivatives_behind_corners_at_ends_of_steps_are_right() {
    let ramp = "ramp over [s] = linear { 0, 0; 0.4, 0; 1, 0.6; 4, 3.6; }";
    let loads = [
        ("a*ramp(t - s + 0.4 [s])", ramp),
        ("a*max(0, (t - s)/1 [s])", ""),
        ("a*(abs(t - s) + t - s)/2 [s]", ""),
        ("if t > s then a*(t - s)/1 [s] else 0 [N]", ""),
    ];
    for (load, tables) in loads {
        let text = loaded(load, tables);
        for method in [Method::Dopri5, Method::Dop853] {
            for tolerance in [1e-6, 1e-12] {
                for stops in [&[][..], &[0.4], &[0.1, 0.2, 0.3, 0.4, 0.5]] {
                    let settings = Settings::adaptive(method, 1.0, tolerance);
                    near(end(&text, 1, &settings, stops), [-0.36, -1.2], 1e-12, load);
                }
            }
        }
        for steps in [10, 1000] {
            near(end(&text, 1, &Settings::equal_steps(Method::Rk4, 1.0, steps), &[]), [-0.36, -1.2], 1e-12, load);
        }
    }
    // Within an equal step a corner that moves is refused; a spline has none. Errors of differences are as above.
    let between = Settings::equal_steps(Method::Rk4, 1.0, 1007);
    for (load, tables) in loads {
        let why = refusal(interpreted(&loaded(load, tables)).unwrap(), &between);
        assert!(why.contains("sudden change"), "{load}: {why}");
    }
    let spline = loaded("a*ramp(t - s)", "ramp over [s] = cubic { -1, 0; 0, 0.1; 0.2, 0.3; 0.6, 0; 1, 0.6; }");
    check(&interpreted(&spline).unwrap(), Some(1), None, &between, 1e-5);
    // A corner at the start.
    let at_once = loaded("a*max(0, (t - s)/1 [s])", "").replace("s [s] = 0.4", "s [s] = 0");
    for settings in [Settings::adaptive(Method::Dop853, 1.0, 1e-10), Settings::equal_steps(Method::Rk4, 1.0, 10)] {
        near(end(&at_once, 1, &settings, &[]), [-1.0, -2.0], 1e-12, "at the start");
    }
    // The course w goes through comes sooner by it: F = 2 sh(w t).
    let text = loaded("a*sh(t*w)", "sh over [s] = linear { 0, 0; 0.1, 1; 0.3, 1; 0.5, 0; }");
    for method in [Method::Dopri5, Method::Dop853] {
        let settings = Settings::adaptive(method, 1.0, 1e-12);
        // v = (2/w) times the area 0.35 until the end; x = 2 (0.35 (1/w) - (first moment)/w^2), with the moment 0.0808333.
        let moment = 0.1 * 0.1 / 3.0 + 0.2 * 0.2 + 0.1 * (0.3 + 0.2 / 3.0);
        near(end(&text, 2, &settings, &[]), [2.0 * (2.0 * moment - 0.35), -0.7], 1e-12, "course");
    }
}
