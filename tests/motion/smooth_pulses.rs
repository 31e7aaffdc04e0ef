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
         parameters {{ m [kg] = 2; F [N] = 20; w [ms] = 0.3; a [ms] = 770; b [ms] = 772; f [rad/s] = 2; }} {inputs}
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
            "pub Wheel; coordinates {{ phi [rad]; }} parameters {{ T [N*m] = 10; w = 0.001; }}
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
