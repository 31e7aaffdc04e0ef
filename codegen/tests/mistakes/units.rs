//! Units: what is added, compared or put in a place is of the dimension that belongs there. A mistake says what is in which
//! unit, and where that comes from.

use super::{SOUND, check, mistakes, without_units};

/// Sums, differences, and what else is compared.
#[test]
fn sums() {
    check(
        "height [m] = P.y",
        "h [m] = l + m",
        &[
            "8:23 `l` is in [m] and `m` is in [kg]; only quantities of one dimension can be added",
            "3:14 `l` is declared in [m] here",
            "3:25 `m` is declared in [kg] here",
        ],
    );
    check(
        "height [m] = P.y",
        "h [m] = l - m*g",
        &[
            "8:23 `l` is in [m] and `m*g` is in [N] (m [kg], g [m/s^2]); only quantities of one dimension can be subtracted",
            "3:14 `l` is declared in [m] here",
        ],
    );
    check(
        "height [m] = P.y",
        "h [m] = m*g*l - m*g",
        &[
            "8:27 `m*g*l` is in [N*m] (m [kg], g [m/s^2], l [m]) and `m*g` is in [N] (m [kg], g [m/s^2]); only quantities of one dimension can be subtracted",
        ],
    );
    check(
        "height [m] = P.y",
        "h [m] = P.x + 1",
        &[
            "8:25 `P.x` is in [m] and `1` is a pure number; only quantities of one dimension can be added; write `1 [m]`",
            "4:5 `P` is defined here (l [m], phi [rad])",
        ],
    );
    check(
        "height [m] = P.y",
        "h [m] = 1 + l^2/l",
        &[
            "8:19 `1` is a pure number and `l^2/l` is in [m] (l [m]); only quantities of one dimension can be added; write `1 [m]`",
        ],
    );
    check(
        "height [m] = P.y",
        "h [m^2] = l^2 + 2*l*P.x + m + g*dot(phi)^2/sin(phi)*abs(cos(phi) + sin(phi))",
        &[
            "8:37 `l^2 + 2*l*P.x` is in [m^2] (l [m], P [m]) and `m` is in [kg]; only quantities of one dimension can be added",
            "3:25 `m` is declared in [kg] here",
        ],
    );
    check(
        "height [m] = P.y",
        "h [m] = l + dot(P.x)",
        &[
            "8:23 `l` is in [m] and `dot(P.x)` is in [m/s] (P [m]); only quantities of one dimension can be added",
            "3:14 `l` is declared in [m] here",
        ],
    );
    check(
        "height [m] = P.y",
        "h [m] = l^(1/2)*l^0.5 + l^2",
        &[
            "8:35 `l^(1/2)*l^0.5` is in [m] (l [m]) and `l^2` is in [m^2] (l [m]); only quantities of one dimension can be added",
        ],
    );
    check(
        "height [m] = P.y",
        "h [rad] = atan2(P.y, phi)",
        &[
            "8:32 `P.y` is in [m] and `phi` is in [rad]; `atan2(y, x)` takes two of one dimension",
            "4:5 `P` is defined here (l [m], phi [rad])",
            "2:15 `phi` is declared in [rad] here",
        ],
    );
    check(
        "height [m] = P.y",
        "h [m] = norm([l, phi])",
        &[
            "8:28 `l` is in [m] and `phi` is in [rad]; both components of a vector are of one dimension",
            "3:14 `l` is declared in [m] here",
            "2:15 `phi` is declared in [rad] here",
        ],
    );
    check(
        "height [m] = P.y",
        "h [m] = norm([P.x, 1])",
        &[
            "8:30 `P.x` is in [m] and `1` is a pure number; both components of a vector are of one dimension; write `1 [m]`",
            "4:5 `P` is defined here (l [m], phi [rad])",
        ],
    );
}

/// Functions and powers.
#[test]
fn functions() {
    check(
        "height [m] = P.y",
        "h [m] = l*sin(t)",
        &["8:25 `sin(..)` takes an angle (a rate times `t`: `w*t` with `w [rad/s]`), and `t` is in [s]"],
    );
    check(
        "height [m] = P.y",
        "h [m] = l*sin(P.y)",
        &["8:25 `sin(..)` takes an angle, and `P.y` is in [m]", "4:5 `P` is defined here (l [m], phi [rad])"],
    );
    check(
        "height [m] = P.y",
        "h [m] = l*exp(-l)",
        &["8:25 `exp(..)` takes a pure number, and `-l` is in [m]", "3:14 `l` is declared in [m] here"],
    );
    check(
        "height [m] = P.y",
        "h [m] = l^P.x",
        &["8:21 an exponent is a pure number, and `P.x` is in [m]", "4:5 `P` is defined here (l [m], phi [rad])"],
    );
    check(
        "height [m] = P.y",
        "h [m] = l^phi",
        &["8:21 `l` is in [m]; its exponent must be a number such as `2` or `1/3`, since the unit depends on it"],
    );
}

/// Outputs in the wrong unit.
#[test]
fn outputs() {
    check(
        "height [m] = P.y",
        "h [N] = P.y",
        &["8:19 output `h` is declared in [N], and `P.y` is in [m]", "4:5 `P` is defined here (l [m], phi [rad])"],
    );
    check(
        "height [m] = P.y",
        "h [N] = m*g*P.y",
        &["8:19 output `h` is declared in [N], and `m*g*P.y` is in [N*m] (m [kg], g [m/s^2], P [m])"],
    );
    check(
        "height [m] = P.y",
        "h = P.y",
        &[
            "8:15 output `h` is declared without a unit (write `h [m]`), and `P.y` is in [m]",
            "4:5 `P` is defined here (l [m], phi [rad])",
        ],
    );
    check(
        "height [m] = P.y",
        "h = dot(phi)",
        &["8:15 output `h` is declared without a unit (write `h [rad/s]`), and `dot(phi)` is in [rad/s] (phi [rad])"],
    );
    check(
        "height [m] = P.y",
        "h [m] = phi",
        &["8:19 output `h` is declared in [m], and `phi` is in [rad]", "2:15 `phi` is declared in [rad] here"],
    );
    check(
        "height [m] = P.y",
        "h [m] = 5",
        &["8:19 output `h` is declared in [m], and `5` is a pure number; write `5 [m]`"],
    );
    check(
        "height [m] = P.y",
        "h [m] = sqrt(l)",
        &["8:19 output `h` is declared in [m], and `sqrt(l)` is in [m^(1/2)] (l [m])"],
    );
    check(
        "height [m] = P.y",
        "h = sqrt(l)",
        &["8:15 output `h` is declared without a unit (write `h [m^(1/2)]`), and `sqrt(l)` is in [m^(1/2)] (l [m])"],
    );
    check(
        "height [m] = P.y",
        "h [m] = inner(P, dot(P))",
        &["8:19 output `h` is declared in [m], and `inner(P, dot(P))` is in [m^2/s] (P [m])"],
    );
    check(
        "initial {",
        "constraints { stop: P.x = 0; } outputs { pull [N] = reaction(stop)*l; } initial {",
        &["7:53 output `pull` is declared in [N], and `reaction(stop)*l` is in [N*m] (reaction(stop) [N], l [m])"],
    );
    check(
        "initial {",
        "constraints { stop: P.x = 0; } outputs { pull [J] = reaction(stop); } initial {",
        &[
            "7:53 output `pull` is declared in [J], and `reaction(stop)` is in [N]",
            "7:15 the reaction of `stop`, here, is in [N]: work per unit of its sides",
        ],
    );
    check(
        "initial {",
        "constraints { stop: phi = 0; } outputs { pull [N] = reaction(stop); } initial {",
        &[
            "7:53 output `pull` is declared in [N], and `reaction(stop)` is in [N*m]",
            "7:15 the reaction of `stop`, here, is in [N*m]: work per unit of its sides",
        ],
    );
    check(
        "initial {",
        "constraints { stop: P.x = m; } outputs { pull [N] = reaction(stop); } initial {",
        &[
            "7:27 `P.x` is in [m] and `m` is in [kg]; both sides of an equation are of one dimension",
            "4:5 `P` is defined here (l [m], phi [rad])",
            "3:25 `m` is declared in [kg] here",
        ],
    );
}

/// Constraints and events.
#[test]
fn equations() {
    check(
        "initial {",
        "constraints { stop: P.y = -m; } initial {",
        &[
            "7:27 `P.y` is in [m] and `-m` is in [kg]; both sides of an equation are of one dimension",
            "4:5 `P` is defined here (l [m], phi [rad])",
            "3:25 `m` is declared in [kg] here",
        ],
    );
    check(
        "initial {",
        "constraints { stop: P.y = -0.5; } initial {",
        &[
            "7:28 `P.y` is in [m] and `-0.5` is a pure number; both sides of an equation are of one dimension; write `0.5 [m]`",
            "4:5 `P` is defined here (l [m], phi [rad])",
        ],
    );
    check(
        "initial {",
        "constraints { stop: P = [0.1, 0.2]; } initial {",
        &[
            "7:26 `P` is in [m] and `[0.1, 0.2]` is a pure number; both sides of an equation are of one dimension; write `0.1 [m]`",
            "4:5 `P` is defined here (l [m], phi [rad])",
        ],
    );
    check(
        "initial {",
        "events { top: dot(phi) = P.y; } initial {",
        &[
            "7:26 `dot(phi)` is in [rad/s] (phi [rad]) and `P.y` is in [m]; both sides of an equation are of one dimension",
            "4:5 `P` is defined here (l [m], phi [rad])",
        ],
    );
    check(
        "initial {",
        "events { top: dot(phi) = 3; } initial {",
        &[
            "7:26 `dot(phi)` is in [rad/s] (phi [rad]) and `3` is a pure number; both sides of an equation are of one dimension; write `3 [rad/s]`",
        ],
    );
    check(
        "phi [rad]; }",
        "phi [rad]; x [mm]; } constraints { s: x = 10; }",
        &[
            "2:57 `x` is in [mm] and `10` is a pure number; both sides of an equation are of one dimension; write `10 [mm]`",
            "2:26 `x` is declared in [mm] here",
        ],
    );
    check(
        "phi [rad]; }",
        "phi [rad]; x [mm]; } constraints { s: x*phi = 10 + l; }",
        &[
            "2:61 `10` is a pure number and `l` is in [m]; only quantities of one dimension can be added; write `10 [m]`",
            "3:14 `l` is declared in [m] here",
        ],
    );
}

/// What is declared without its unit, or in the wrong one; no mistake goes on to others.
#[test]
fn declared() {
    check(
        "l [m] = 1;",
        "l = 1;",
        &[
            "5:25 the position of a mass is in [m], and `P` is a pure number",
            "4:5 `P` is defined here (l without a unit, phi [rad])",
        ],
    );
    check(
        "l [m] = 1;",
        "l [mtr] = 1 [m];",
        &[
            "3:17 `mtr` is not a known unit; known units are m, g, s, N, J, W, Pa, bar, A, V, Hz, rad, deg, rpm, min, inch, lb and others, with SI prefixes",
        ],
    );
    check("phi [rad];", "phi [red];", &["2:20 `red` is not a known unit (did you mean `rad`?)"]);
    check(
        "let P = l*",
        "let q = l + m; let P = q*",
        &[
            "4:13 `l` is in [m] and `m` is in [kg]; only quantities of one dimension can be added",
            "3:14 `l` is declared in [m] here",
            "3:25 `m` is declared in [kg] here",
        ],
    );
    check(
        "let P = l*",
        "let P = (l + m*t)*",
        &[
            "4:14 `l` is in [m] and `m*t` is in [kg*s] (m [kg], t [s]); only quantities of one dimension can be added",
            "3:14 `l` is declared in [m] here",
        ],
    );
    check(
        "m [kg] = 2;",
        "m = 2;",
        &[
            "5:20 a mass is in [kg], and `m` is a pure number; declare it as `m [kg]`",
            "3:25 `m` is declared without a unit here",
        ],
    );
    check(
        "g [m/s^2] = 9.81;",
        "g = 9.81;",
        &["6:17 gravity is in [m/s^2], and `[0, -g]` is a pure number (g without a unit)"],
    );
    check("phi [rad];", "phi;", &[]);
    check(
        "phi [rad];",
        "phi [m];",
        &[
            "4:16 `sin(..)` takes an angle, and `phi` is in [m]",
            "2:15 `phi` is declared in [m] here",
            "4:27 `cos(..)` takes an angle, and `phi` is in [m]",
            "5:34 the angle of a body is in [rad] or [deg] or a pure number, and `phi` is in [m]",
        ],
    );
}

/// Without any unit nothing is checked.
#[test]
fn no_units() {
    let unlike = SOUND.replace("height [m] = P.y", "height [m] = P.y + m + sin(l) + t; pull = norm([l, phi])");
    assert!(mistakes(&unlike).len() > 1);
    assert_eq!(mistakes(&without_units(&unlike)), Vec::<String>::new());
}

/// What is to be written is in the unit of the place, prefix and all.
#[test]
fn advice_keeps_prefixes() {
    check(
        "height [m] = P.y",
        "h [mJ] = 300*sin(phi)",
        &["8:20 output `h` is declared in [mJ], and `300*sin(phi)` is a pure number (phi [rad]); write `300 [mJ]`"],
    );
    check(
        "height [m] = P.y",
        "h [mJ] = 3*t",
        &["8:20 output `h` is declared in [mJ], and `3*t` is in [s] (t [s]); if a unit is missing, write `3 [mJ/s]`"],
    );
}
