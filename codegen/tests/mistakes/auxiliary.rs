//! Auxiliary displacements.

use super::{SOUND, mistakes};

/// The sound declaration with such a block, and with P and the outputs as given.
fn check(block: &str, point: &str, output: &str, expected: &[&str]) {
    let text = SOUND
        .replacen("let P = l*[sin(phi), -cos(phi)];", &format!("auxiliary {{ {block} }}\nlet P = {point};"), 1)
        .replacen("height [m] = P.y;", output, 1);
    assert_eq!(mistakes(&text), expected, "\nin: {text}");
}

#[test]
fn auxiliary_displacements() {
    let displaced = "[s, 0] + l*[sin(phi), -cos(phi)]";
    check("s [m];", displaced, "pin [N] = reaction(s);", &[]);
    check("s [m];", displaced, "speed [m/s] = dot(P.x) + dot(s); second [m/s^2] = ddot(s);", &[]);
    check(
        "s [m];",
        "l*[sin(phi), -cos(phi)]",
        "pin [N] = reaction(s);",
        &[
            "4:13 `s` displaces nothing; add it to the position of a body or of a load's point, or to a point in a constraint: `let B = A + [s, 0];`",
        ],
    );
    check(
        "s [m] = 0;",
        displaced,
        "pin [N] = reaction(s);",
        &["4:19 an auxiliary displacement is always zero; write `s [m];`"],
    );
    check(
        "phi_dot [m];",
        "[phi_dot, 0] + l*[sin(phi), -cos(phi)]",
        "pin [N] = reaction(phi_dot);",
        &["4:13 `phi_dot` is the name of a rate of `phi` in files and on the command line; choose another name"],
    );
    check(
        "l [m];",
        "[0, 0] + l*[sin(phi), -cos(phi)]",
        "pin [N] = reaction(l);",
        &["4:13 `l` is defined twice; choose another name for one of them", "3:14 the first definition of `l` is here"],
    );
    check(
        "s [m];",
        displaced,
        "pin [N] = reaction(r);",
        &["9:30 no constraint or auxiliary displacement is called `r`; declared: `s`"],
    );
    check("s [m];", "[1/s, 0] + l*[sin(phi), -cos(phi)]", "pin [N] = reaction(s);", &["5:12 division by zero"]);
    check("t [s]; s [m];", displaced, "x = 1;", &["4:13 `t` is time in the language; choose another name"]);
    check(
        "s [m]; s [m];",
        displaced,
        "x = 1;",
        &["4:20 `s` is defined twice; choose another name for one of them", "4:13 the first definition of `s` is here"],
    );
    let inertia = SOUND.replacen("let P =", "auxiliary { s [m]; }\nlet P = [0, s] +", 1).replacen(
        "mass m at P",
        "mass m*(1 + s/l) at P",
        1,
    );
    assert_eq!(
        mistakes(&inertia),
        ["6:20 a mass or inertia is made of numbers and parameters; it cannot change with the motion"]
    );
    let start = SOUND.replacen("let P =", "auxiliary { s [m]; }\nlet P = [0, s] +", 1).replacen(
        "phi = 0.5",
        "phi = s/l + 1",
        1,
    );
    assert_eq!(mistakes(&start), ["8:17 a start value is made of numbers and parameters"]);
}
