//! What words of the language mean: defaults, units, events, and what is refused.

use super::{Mechanism, Outcome, assert_value, assert_values, si_factor};
use codegen::oracle::{Oracle, State};

#[test]
fn defaults_are_in_si_units() -> Outcome {
    let mechanism = Mechanism::parse(
        "pub Defaults;
        parameters {
            plain = 2; length [mm] = 500; own_unit [m] = 20 [mm]; negative [deg] = -90; computed [deg] = 2*pi/pi;
            earlier [mm] = 2*length; mixed [mm] = 3*40 [mm]; speed [rad/s] = 75 [rpm]; tiny = 1.5e-3;
        }",
    )?;
    let pi = std::f64::consts::PI;
    let expected = [2.0, 0.5, 0.02, -pi / 2.0, 2.0 * (pi / 180.0), 1.0, 0.12, 75.0 * pi / 30.0, 1.5e-3];
    let defaults = mechanism.oracle().default_parameters()?;
    assert_eq!(defaults.len(), expected.len());
    for (found, expected) in defaults.iter().zip(expected) {
        // Each takes at most three operations.
        assert!((found - expected).abs() <= 4e-16 * expected.abs(), "{found} is not {expected}");
    }
    Ok(())
}

#[test]
fn numbers_with_units_are_in_si_units() -> Outcome {
    let mechanism = Mechanism::parse(
        "pub Units; coordinates { x [mm]; } bodies { b: mass 2 at [x, 0]; } loads { force [300 [mm], 0] at [x, 0]; }
        outputs { sum [mm] = x + 5 [mm]; a { turn [rpm] = 30 [rpm]; } last = e^x - pi; }",
    )?;
    let answer = mechanism.at(0.0, &[0.1], &[0.0])?;
    assert_values(&answer.solution.accelerations, &[0.15]);
    assert_values(&answer.outputs, &[0.105, std::f64::consts::PI, 0.1f64.exp() - std::f64::consts::PI]);
    Ok(())
}

#[test]
fn events_are_left_minus_right_in_order() -> Outcome {
    let mechanism = Mechanism::parse(
        "pub Events; coordinates { x [m]; } bodies { b: mass 1 at [x, 0]; }
        events { turning: dot(x)^2 = 4; late: 3*x = t; }",
    )?;
    let state = State { time: 0.5, parameters: &[], inputs: &[], coordinates: &[0.7], speeds: &[3.0] };
    let solution = mechanism.oracle().accelerations(&mechanism.oracle().terms(&state)?)?;
    assert_values(&mechanism.oracle().events(&state, &solution)?, &[5.0, 3.0 * 0.7 - 0.5]);
    Ok(())
}

/// Parameters are those of the state, not the defaults.
#[test]
fn parameters_are_variable() -> Outcome {
    let mechanism = Mechanism::parse(
        "pub Variable; coordinates { x; } parameters { m = 1; F = 1; } bodies { b: mass m at [x, 0]; }
        loads { force [F, 0] at [x, 0]; }",
    )?;
    let state = State { time: 0.0, parameters: &[4.0, 6.0], inputs: &[], coordinates: &[0.0], speeds: &[0.0] };
    let terms = mechanism.oracle().terms(&state)?;
    assert_value(terms.mass_matrix[0][0], 4.0);
    assert_values(&mechanism.oracle().accelerations(&terms)?.accelerations, &[1.5]);
    Ok(())
}

/// A `let` is seen below its line only, and by everything outside the `let`s.
#[test]
fn lets_see_those_above() -> Outcome {
    let answer = |lets: &str| -> Outcome<_> {
        let text = format!("pub Lets; coordinates {{ x; }} bodies {{ b: mass 1 at P; }} {lets}");
        Mechanism::parse(&text)?.at(0.0, &[0.3], &[0.0])
    };
    assert!(answer("let s = 2*x; let P = [s, s^2];").is_ok());
    assert!(answer("let P = [s, s^2]; let s = 2*x;").is_err());
    assert!(answer("let P = [P.x, x];").is_err());
    Ok(())
}

#[test]
fn what_has_no_meaning_is_refused() -> Outcome {
    const REST: &str = "coordinates { x; } parameters { m = 1; } let P = [x, 0];";
    let refused = [
        "bodies { b: mass m*x at P; }",
        "bodies { b: mass m*t at P; }",
        "bodies { b: mass m; }",
        "bodies { b: mass m at x; }",
        "bodies { b: mass m at dot(P); }",
        "bodies { b: mass m at P, inertia 1; }",
        "bodies { b: mass m at P; } loads { torque 1 on b; }",
        "bodies { b: mass m at P; } loads { torque 1 on c; }",
        "bodies { b: mass m at P; } loads { force [ddot(x), 0] at P; }",
        "bodies { b: mass m at P; } loads { force x at P; }",
        "bodies { b: mass m at P; } loads { force [reaction(c), 0] at P; } constraints { c: x = 0; }",
        "bodies { b: mass m at P; } constraints { c: P = 0; }",
        "bodies { b: mass m at P; } outputs { v = P; }",
        "bodies { b: mass m at P; } outputs { v = reaction(x); }",
        "bodies { b: mass m at P; } outputs { v = dot(ddot(x)); }",
        "",
        "bodies { b: mass m at P; } constraints { c: x = 0; d: 2*x = 0; }",
    ];
    for blocks in refused {
        let mechanism = Mechanism::parse(&format!("pub Refused; {REST} {blocks}"))?;
        assert!(mechanism.at(0.0, &[0.3], &[0.1]).is_err(), "{blocks}");
    }
    let fine = Mechanism::parse(&format!("pub Fine; {REST} bodies {{ b: mass m at P; }}"))?;
    assert!(fine.at(0.0, &[0.3], &[0.1]).is_ok());
    assert!(fine.at(0.0, &[0.3, 0.4], &[0.1]).is_err() && fine.at(0.0, &[0.3], &[]).is_err());
    let later = Mechanism::parse("pub Later; parameters { a = b; b = 1; }")?;
    assert!(Oracle::new(&later.declaration, &si_factor).default_parameters().is_err());
    Ok(())
}
