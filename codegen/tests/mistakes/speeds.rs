//! Generalised speeds.

use super::{check as in_the_plane, mistakes};

const SOUND: &str = "pub Sledge;
coordinates { x [m]; y [m]; phi [rad]; }
parameters { m [kg] = 5; J [kg*m^2] = 1; a [m] = 1; }
let along = [cos(phi), sin(phi)];
bodies { sledge: mass m at [x, y] + a*along, inertia J, angle phi; }
constraints { blade: cos(phi)*dot(y) = sin(phi)*dot(x); }
speeds { v [m/s] = inner(dot([x, y]), along); w [rad/s] = dot(phi); }
outputs { drift [m/s] = a*dot(phi); }
";

fn check(replace: &str, by: &str, expected: &[&str]) {
    assert!(SOUND.contains(replace), "{replace}");
    assert_eq!(mistakes(&SOUND.replacen(replace, by, 1)), expected, "\nin: {by}");
}

#[test]
fn the_sound_declaration_has_none() {
    check("pub", "pub", &[]);
    // They stand wherever speeds may.
    check("outputs {", "let p = v*w; loads { torque -1 [N*m*s]*w on sledge; } outputs { p [m/s^2] = p;", &[]);
    check("outputs {", "events { slow: v = 0; } outputs {", &[]);
    // One more constraint between speeds takes one more away.
    check("w [rad/s] = dot(phi); }", "} constraints { steady: dot(phi) = 1 [rad/s]; }", &[]);
    // Squares that cancel are no squares.
    check("= dot(phi);", "= (dot(phi) + 1 [rad/s])^2/(2 [rad/s]) - dot(phi)^2/(2 [rad/s]);", &[]);
}

#[test]
fn what_is_no_generalised_speed() {
    let speed = |written: &str, expected: &[&str]| check("w [rad/s] = dot(phi);", written, expected);
    speed(
        "w [rad/s];",
        &["7:56 generalised speed `w` needs a definition: `w [unit] = expression;`, linear in `dot(..)`"],
    );
    speed(
        "w [rad/s] = phi/(1 [s]);",
        &["7:59 no rate of a coordinate stands in generalised speed `w`; write one, with `dot()`"],
    );
    speed(
        "w [rad/s] = dot(phi)^2*(1 [s]);",
        &[
            "7:59 a generalised speed is linear in the rates of coordinates, `a*dot(x) + b*dot(y) + c`; `dot(phi)` is not linear here",
        ],
    );
    speed(
        "w [rad/s] = norm(dot([x, y]))/a;",
        &[
            "7:59 a generalised speed is linear in the rates of coordinates, `a*dot(x) + b*dot(y) + c`; `dot(x)` is not linear here",
        ],
    );
    speed(
        "w [rad/s] = ddot(phi)*(1 [s]);",
        &["7:59 a generalised speed is made of the rates of coordinates; `ddot()` cannot stand in it"],
    );
    speed(
        "w [rad/s] = dot(phi)*(if t > 0.7 [s] then -1 else 1);",
        &["7:59 generalised speed `w` may jump by an `if` or `sign` in it, while no coordinate does: write it without"],
    );
    speed("w [rad/s] = dot(phi)*max(1, 2*cos(phi))*(if a > 1 [m] then 2 else 1);", &[]);
    speed(
        "w [m/s] = dot(phi);",
        &["7:57 generalised speed `w` is declared in [m/s], and `dot(phi)` is in [rad/s] (phi [rad])"],
    );
    speed(
        "w [m/s] = dot([x, y]);",
        &["7:57 generalised speed `w` is a vector; write one line for each component: `w_x = (..).x;`"],
    );
    speed("w [rad/s] = dot(psi);", &["7:63 no value is called `psi` (did you mean `phi`?)"]);
    speed(
        "x_dot [m/s] = dot(x);",
        &["7:47 `x_dot` is the name of a rate of `x` in files and on the command line; choose another name"],
    );
    speed(
        "v [m/s] = dot(x);",
        &["7:47 `v` is defined twice; choose another name for one of them", "7:10 the first definition of `v` is here"],
    );
    speed("w [rad/s] = u; u [rad/s] = dot(phi);", &["7:59 `u` is defined only below; move its line above this one"]);
    check(
        "w [rad/s] = dot(phi);",
        "w [rad/s] = dot(phi) + turn; } inputs { turn [rad/s] = 0;",
        &["7:59 a generalised speed cannot depend on an input, which may jump; use inputs in loads and outputs"],
    );
}

#[test]
fn starts_are_of_coordinates() {
    check(
        "outputs {",
        "initial { w = 3; } outputs {",
        &[
            "8:11 no coordinate is called `w` (a generalised speed follows from the rates of coordinates: `dot(..) = ..;`); only coordinates have start values",
        ],
    );
}

#[test]
fn how_many_they_are() {
    check(
        " w [rad/s] = dot(phi);",
        "",
        &[
            "7:10 generalised speeds: 1 given, 2 needed, as many as coordinates, less the constraints that hold by construction, `blade`",
        ],
    );
    check(
        "w [rad/s] = dot(phi);",
        "w [rad/s] = dot(phi); s [m/s] = dot(x); r [m/s] = dot(y);",
        &[
            "7:69 generalised speeds: 4 given, 2 needed, as many as coordinates, less the constraints that hold by construction, `blade`",
        ],
    );
    in_the_plane(
        "initial {",
        "speeds { w [rad/s] = dot(phi); v [rad/s] = 2*dot(phi); } initial {",
        &["7:32 generalised speeds: 2 given, 1 needed, as many as coordinates"],
    );
    check(
        "constraints {",
        "constraints { turn: dot(phi) = 0; ",
        &[
            "7:47 generalised speeds: 2 given, 1 needed, as many as coordinates, less the constraints that hold by construction, `turn`, `blade`",
        ],
    );
}

#[test]
fn those_that_follow_from_others() {
    check(
        "= dot(phi);",
        "= inner(dot([x, y]), along)/a;",
        &[
            "7:47 generalised speed `w` follows from those above it and the constraints, so the rates of some coordinates stay undetermined; choose an independent one",
        ],
    );
    // Across the blade nothing moves.
    check(
        "= dot(phi);",
        "= (cos(phi)*dot(y) - sin(phi)*dot(x) + 2*v)/a;",
        &[
            "7:47 generalised speed `w` follows from those above it and the constraints, so the rates of some coordinates stay undetermined; choose an independent one",
        ],
    );
    check(
        "constraints {",
        "constraints { twice: tan(phi)*dot(x) = dot(y); ",
        &[
            "7:47 generalised speeds: 2 given, 1 needed, as many as coordinates, less the constraints that hold by construction, `twice`, `blade`",
        ],
    );
    check(
        "w [rad/s] = dot(phi); }",
        "} constraints { twice: tan(phi)*dot(x) = dot(y); }",
        &[
            "7:10 constraint `twice` follows from others, so generalised speeds cannot satisfy both by construction; leave it out",
        ],
    );
}
