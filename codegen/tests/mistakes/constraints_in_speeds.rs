//! Constraints between speeds.

use super::check_without_units as check;

/// In place of the block of start values.
fn constraint(written: &str, expected: &[&str]) {
    check("initial {", &format!("constraints {{ {written} }} initial {{"), expected);
}

#[test]
fn constraints_between_speeds() {
    constraint("stop: dot(phi) = 1;", &[]);
    constraint("stop: l*dot(phi) + t = sin(phi);", &[]);
    // Squares that cancel are no squares.
    constraint("stop: (dot(phi) + 1)^2 - dot(phi)^2 = 3;", &[]);
    constraint(
        "stop: dot(phi)^2 = 1;",
        &[
            "7:21 a constraint between speeds must be linear in them, `a*dot(x) + b*dot(y) = c`; `dot(phi)` is not linear here",
        ],
    );
    constraint(
        "stop: norm(dot(P)) = 1;",
        &[
            "7:21 a constraint between speeds must be linear in them, `a*dot(x) + b*dot(y) = c`; `dot(phi)` is not linear here",
        ],
    );
    constraint(
        "stop: ddot(phi) = 1;",
        &[
            "7:21 a constraint holds between positions or speeds; `ddot()` cannot stand in it: write its integral, with `dot()`",
        ],
    );
    constraint(
        "stop: dot(l)*phi = 1;",
        &[
            "7:15 no speed is left in constraint row `stop`, though `dot()` is written; write it between positions, without `dot()`",
        ],
    );
    constraint(
        "stop: dot([phi, l]) = [0, 0];",
        &[
            "7:15 no speed is left in constraint row `stop_y`, though `dot()` is written; write it between positions, without `dot()`",
        ],
    );
    constraint(
        "stop: dot(phi) = P;",
        &["7:21 the left side is a scalar and the right side a vector; both must be of one kind"],
    );
    constraint("stop: reaction(stop) = dot(phi);", &["7:21 `reaction(..)` can stand only in outputs"]);
    constraint("stop: phi_dot = 1;", &["7:21 the rate of `phi` is written `dot(phi)` here"]);
}
