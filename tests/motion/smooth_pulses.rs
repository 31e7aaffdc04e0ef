//! Smooth pulses and steps of time that are far shorter than the steps of the motion.

use sim::{Method, Rows, Settings};
use std::f64::consts::PI;
use tests::any_model::interpreted;
use tests::run_with;

/// The speed of a mass of 2 kg at the end, pushed by a force; or by an input that has its course.
fn pushed(force: &str, as_input: bool, method: Method, rows: Rows) -> f64 {
    let (inputs, load) = match as_input {
        true => (format!("inputs {{ u [N] = {force}; }}"), "u"),
        false => (String::new(), force),
    };
    let declaration = format!(
        "pub Pushed; coordinates {{ x [m]; }}
         parameters {{ m [kg] = 2; F [N] = 20; w [ms] = 0.3; a [ms] = 770; b [ms] = 772; f [rad/s] = 2; n = 20000; }} {inputs}
         bodies {{ block: mass m at [x, 0]; }} loads {{ force {load} on x; }} initial {{ dot(x) = 0.1; }}"
    );
    let settings = Settings { rows, ..Settings::adaptive(method, 3.0, 1e-10) };
    let run = run_with(interpreted(&declaration).unwrap(), &settings).unwrap();
    run.trajectory.samples.last().unwrap().state.speeds[0]
}

/// The speed gained is the impulse over the mass. All forces are rounding at both ends of the run, but the last.
#[test]
fn no_smooth_pulse_is_passed_over() {
    let (force, w) = (20.0, 0.3e-3);
    let forces = [
        ("F*exp(-((t - a)/w)^2)", force * w * PI.sqrt()),
        ("F/cosh((t - a)/w)", force * w * PI),
        ("F*(tanh((t - a)/w) - tanh((t - b)/w))", 2.0 * force * 2e-3),
        ("F/(1 + exp(-(t - a)/w)) - F/(1 + exp(-(t - b)/w))", force * 2e-3),
        // Two peaks within 3 s, where the sine is 0 and its argument to 1e-6.
        ("F*exp(-(sin(f*(t - a))/(f*w))^2)", 2.0 * force * w * PI.sqrt()),
        ("F/(1 + ((t - a)/w)^2)", force * w * ((2.23 / w).atan() + (0.77 / w).atan())),
        // Two peaks, each sqrt(2 pi/n) (1 - 1/(4 n)) / f by the ratio of gamma functions.
        ("F*cos(f*(t - a))^20000", force * (2.0 * PI / 2e4f64).sqrt() * (1.0 - 1.0 / 8e4)),
        ("F*abs(cos(f*(t - a)))^n", force * (2.0 * PI / 2e4f64).sqrt() * (1.0 - 1.0 / 8e4)),
        ("F*(cos(f*(t - a))^2)^(n/2)", force * (2.0 * PI / 2e4f64).sqrt() * (1.0 - 1.0 / 8e4)),
    ];
    for (force, impulse) in forces {
        for method in [Method::Dop853, Method::Dopri5, Method::Radau5] {
            for (as_input, rows) in [(false, Rows::Even(1)), (true, Rows::Even(1000)), (false, Rows::Steps)] {
                let gained = pushed(force, as_input, method, rows) - 0.1;
                // The tolerance of steps, and for the sines what they are less than their arguments.
                let bound = if force.contains("sin") { 1e-6 * impulse } else { 1e-8 };
                assert!(
                    (gained - impulse / 2.0).abs() < bound,
                    "{force} by {method:?}: {gained:e}, not {:e}",
                    impulse / 2.0
                );
            }
        }
    }
}

/// A support that jerks moves a mass that is free on it backwards, by its own way; one that is held by a constraint pulls a spring.
#[test]
fn no_jerk_of_a_support_is_passed_over() {
    let free = "pub Free; coordinates { x [m]; } parameters { m [kg] = 2; A [m] = 0.1; a [ms] = 770; w [ms] = 2; }
        let P = [A*tanh((t - a)/w) + x, 0]; bodies { block: mass m at P; }";
    let pulled = "pub Pulled; coordinates { x [m]; y [m]; }
        parameters { m [kg] = 2; k [N/m] = 8; A [m] = 0.1; a [ms] = 770; w [ms] = 2; }
        bodies { block: mass m at [x, 0]; hand: mass m at [y, 0]; } loads { spring k, rest 0 [m] between x and y; }
        constraints { held: y = A*exp(-((t - a)/w)^2); }";
    // The impulse k A w sqrt(pi) of the spring swings the block at sqrt(k/m) = 2 rad/s from 0.77 s on; beside it counts (2 w)^2.
    let swing = 8.0 * 0.1 * 0.002 * PI.sqrt() / 2.0 / 2.0 * (2.0 * (3.0 - 0.77f64)).sin();
    for (declaration, place, bound) in [(free, -0.2, 1e-7), (pulled, swing, 1e-5 * swing.abs())] {
        for method in [Method::Dop853, Method::Dopri5, Method::Radau5] {
            let settings = Settings { rows: Rows::Even(3), ..Settings::adaptive(method, 3.0, 1e-10) };
            let run = run_with(interpreted(declaration).unwrap(), &settings).unwrap();
            let found = run.trajectory.samples.last().unwrap().state.positions[0];
            assert!((found - place).abs() < bound, "{method:?}: {found} {place}");
        }
    }
}

/// The square of the speed of a mass of 1 kg after 2 m at about 1 m/s past a force by its position; or of a wheel past a torque.
fn passed(force: &str, is_wheel: bool, method: Method, rows: Rows) -> f64 {
    let declaration = match is_wheel {
        false => format!(
            "pub Passed; coordinates {{ x [m]; }} parameters {{ F [N] = 10; a [m] = 1.3; b [m] = 1.31; w [mm] = 1; }}
             bodies {{ slider: mass 1 [kg] at [x, 0]; }} loads {{ force {force} on x; }} initial {{ dot(x) = 1; }}"
        ),
        true => format!(
            "pub Wheel; coordinates {{ phi [rad]; }} parameters {{ T [N*m] = 10; w = 0.001; n = 20000; }}
             bodies {{ wheel: inertia 1 [kg*m^2], angle phi; }} loads {{ torque {force} on phi; }}
             initial {{ phi = 0.2; dot(phi) = 1; }}"
        ),
    };
    let settings = Settings { rows, ..Settings::adaptive(method, 2.0, 1e-10) };
    let run = run_with(interpreted(&declaration).unwrap(), &settings).unwrap();
    run.trajectory.samples.last().unwrap().state.speeds[0].powi(2)
}

/// The kinetic energy gained is the work, the integral of the force over the way.
#[test]
fn no_smooth_pulse_by_position_is_passed_over() {
    let (force, w) = (10.0, 1e-3);
    let pulses = [
        ("F*exp(-((x - a)/w)^2)", false, force * w * PI.sqrt()),
        ("-0.1*F*exp(-((x - a)/w)^2)", false, -0.1 * force * w * PI.sqrt()),
        ("F/cosh((x - a)/(2*w))^2", false, 4.0 * force * w),
        ("F*(tanh((x - a)/w) - tanh((x - b)/w))/2", false, force * 0.01),
        ("F/(1 + exp((a - x)/(2*w))) - F/(1 + exp((b - x)/(2*w)))", false, force * 0.01),
        // Beside a kink, and twice.
        ("F*exp(-((x - a)/w)^2) + 0*abs(x - b)*F/a", false, force * w * PI.sqrt()),
        ("F*exp(-((x - a)/w)^2) + F*exp(-((x - b)/w)^2)", false, 2.0 * force * w * PI.sqrt()),
        ("T*exp(-((phi - 1.3)/w)^2)", true, force * w * PI.sqrt()),
        // Within 1e-6 a Gauss curve of the angle, of the width 1e-3.
        ("T*exp((cos(phi - 1.3) - 1)/w^2*2)", true, force * w * PI.sqrt()),
        // By the ratio of gamma functions, but for 1/n^2.
        ("T*cos(phi - 1.3)^20000", true, force * (2.0 * PI / 2e4f64).sqrt() * (1.0 - 1.0 / 8e4)),
        ("T*abs(cos(phi - 1.3))^n", true, force * (2.0 * PI / 2e4f64).sqrt() * (1.0 - 1.0 / 8e4)),
    ];
    for (pulse, is_wheel, work) in pulses {
        for method in [Method::Dop853, Method::Dopri5, Method::Radau5] {
            for rows in [Rows::Even(1), Rows::Even(1000), Rows::Steps] {
                let gained = passed(pulse, is_wheel, method, rows) - 1.0;
                let bound = if pulse.contains("cos") { 1e-6 * work } else { 2e-8 };
                assert!((gained - 2.0 * work).abs() < bound, "{pulse} by {method:?}, {rows:?}: {gained:e} {work:e}");
            }
        }
    }
}

/// A step that ends in the middle of a pulse, or at its flank, is not drawn on to the end of the run just behind it.
#[test]
fn a_pulse_just_before_the_end_does_not_stop_a_run() {
    for (force, middle) in
        [("1e-9 [N]*exp(-((x - 0.5 [m])/0.1 [m])^2)", 0.5), ("1e-9 [N]*tanh((x - 0.5 [m])/0.1 [m])", 0.5)]
    {
        let text = format!(
            "pub Beside; coordinates {{ x [m]; }} bodies {{ b: mass 1 [kg] at [x, 0]; }}
             loads {{ force {force} on x; }} initial {{ dot(x) = 1; }}"
        );
        for (place, behind) in
            [-0.1, 0.0, 0.1].into_iter().flat_map(|off| [1e-6, 1e-5, 1e-4, 1e-3].map(|d| (middle + off, d)))
        {
            for method in [Method::Dop853, Method::Dopri5, Method::Radau5] {
                let run =
                    run_with(interpreted(&text).unwrap(), &Settings::adaptive(method, place + behind, 1e-10)).unwrap();
                assert_eq!(run.trajectory.failure, None, "{force} to {place} + {behind} by {method:?}");
                assert!(
                    run.steps.accepted < 50 && run.steps.rejected < 50,
                    "{force} to {place} + {behind}: {:?}",
                    run.steps
                );
                let end = run.trajectory.samples.last().unwrap().state.positions[0];
                assert!((end - place - behind).abs() < 1e-9, "{end}");
            }
        }
    }
}

/// What a mass of 2 kg at about 1 m/s gains in momentum from a push of 1 N by equal steps of 1 ms, as a part of the push's impulse,
/// and whether a step is counted as too long for it.
fn by_equal_steps(force: &str, impulse: f64, [w, a]: [f64; 2], method: Method) -> (f64, bool) {
    let declaration = format!(
        "pub Pushed; coordinates {{ x [m]; }} parameters {{ F [N] = 1; w [s] = {w}; a [s] = {a}; v [m/s] = 1; }}
         bodies {{ block: mass 2 [kg] at [x, 0]; }} loads {{ force {force} on x; }} initial {{ dot(x) = v; }}"
    );
    let run = run_with(interpreted(&declaration).unwrap(), &Settings::equal_steps(method, 0.1, 100)).unwrap();
    assert!(run.trajectory.failure.is_none(), "{:?}", run.trajectory.failure);
    let gained = 2.0 * (run.trajectory.samples.last().unwrap().state.speeds[0] - 1.0);
    (gained / (impulse * w), run.steps.sudden_changes.is_some())
}

/// Pulses of time and of the place, wherever they lie in a step.
#[test]
fn equal_steps_that_are_too_long_for_a_pulse_are_counted() {
    let forces = [
        ("F*exp(-((t - a)/w)^2)", PI.sqrt()),
        ("F*exp(-((x/v - a)/w)^2)", PI.sqrt()),
        ("F/cosh((t - a)/w)", PI),
        ("F/cosh((x/v - a)/w)", PI),
        ("F/(1 + ((t - a)/w)^2)", PI),
    ];
    for (force, impulse) in forces {
        for (of_step, offset) in [0.03, 0.3, 1.0, 1.5, 4.0].into_iter().flat_map(|w| (0..6).map(move |k| (w, k))) {
            let place = [of_step * 1e-3, 0.05 + 1e-3 / 6.0 * f64::from(offset)];
            for method in [Method::Rk4, Method::Dopri5, Method::Radau5] {
                let (gained, is_counted) = by_equal_steps(force, impulse, place, method);
                // Of the last one a twentieth is before and after the run.
                let is_wrong = (gained - 1.0).abs() > 0.06;
                let what = format!("{force}, {place:?}, {method:?}: {gained}");
                assert!(is_counted || !is_wrong, "wrong without a word: {what}");
                assert!(!is_counted || of_step < 1.5, "counted for nothing: {what}");
            }
        }
    }
}

/// A coordinate without a unit that goes to infinity, with a load that begins on the way: each step is looked into in a moment.
#[test]
fn a_motion_to_infinity_ends_soon() {
    let declaration = "pub Blown; coordinates { z; } parameters { m [kg] = 1; k [N*m] = 1; L [m] = 1; }
        bodies { block: mass m at [L*z, 0]; } loads { force (if z > 2 then k*z^3 else 0) on z; }
        initial { z = 1; dot(z) = 1 [1/s]; }";
    let settings = Settings { rows: Rows::Steps, ..Settings::adaptive(Method::Dop853, 10.0, 1e-10) };
    let run = run_with(interpreted(declaration).unwrap(), &settings).unwrap();
    let last = run.trajectory.samples.last().unwrap();
    // z'^2 = z^4/2 - 7 from z = 2 at 1 s on; with u = 1/z the integral of sqrt(2) du/sqrt(1 - 14 u^4) up to 1/2, by its series.
    let terms = (0..200).scan(1.0, |binomial, k| {
        let term = *binomial * 0.875f64.powi(k) / 2.0 / f64::from(4 * k + 1);
        *binomial *= f64::from(2 * k + 1) / f64::from(2 * k + 2);
        Some(term)
    });
    let blown = 1.0 + 2f64.sqrt() * terms.sum::<f64>();
    assert!(run.trajectory.failure.is_some() && last.state.positions[0] > 1e9);
    // What is left when z is 1e9 is 1.4e-9; the rest is the tolerance.
    assert!((last.state.time - blown).abs() < 1e-8, "{} {blown}", last.state.time);
}
