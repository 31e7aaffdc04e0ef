//! Space: vectors, rotations, attitudes and inertias.

use super::{check as in_the_plane, mistakes};

const SOUND: &str = "pub Top;
coordinates { psi [rad]; theta [rad]; phi [rad]; }
parameters { m [kg] = 1; l [m] = 1; J [kg*m^2] = 2; g [m/s^2] = 9.81; }
let R = euler(zxz, psi, theta, phi);
let P = R*[0, 0, l];
bodies { top: mass m at P, inertia [J, J, J/2], attitude R; }
loads { gravity [0, 0, -g]; }
outputs { height [m] = P.z; }
drawing { line [0, 0, 0], P; }
";

fn check(replace: &str, by: &str, expected: &[&str]) {
    assert!(SOUND.contains(replace), "{replace}");
    assert_eq!(mistakes(&SOUND.replacen(replace, by, 1)), expected, "\nin: {by}");
}

fn load(line: &str, expected: &[&str]) {
    check("loads {", &format!("loads {{ {line}"), expected);
}

fn output(value: &str, expected: &[&str]) {
    check("height [m] = P.z;", &format!("height [m] = {value};"), expected);
}

#[test]
fn the_sound_declaration_has_none() {
    check("pub", "pub", &[]);
    load("torque R*[0, 0, 1 [N*m]] on top; force [1 [N], 0, 0] at on(top, [l, 0, 0]);", &[]);
    check("[J, J, J/2]", "[J, J, J/2, J/10, 0, -J/20]", &[]);
    check("euler(zxz, psi, theta, phi)", "rotation(z, psi)*rotation([3/5, 4/5, 0], theta)*rotation(x, phi)", &[]);
}

#[test]
fn vectors_of_the_wrong_length() {
    let first = "5:11 the first vector stands here";
    check(
        "[0, 0, -g]",
        "[0, -g]",
        &[
            "7:17 this vector has two components, but the first vector makes the mechanism spatial; write `[x, y, 0]`, or \
             two components everywhere",
            first,
        ],
    );
    in_the_plane(
        "[0, -g]",
        "[0, 0, -g]",
        &[
            "6:17 this vector has three components, but the first vector makes the mechanism planar; write `[x, y]`, or \
             three components everywhere",
            "4:11 the first vector stands here",
        ],
    );
    output(
        "(P + [0, 0, 0, l]).z",
        &["8:29 a vector of the plane has two components, `[x, y]`, and one of space three, `[x, y, z]`; this has 4"],
    );
    output("P.w", &["8:26 a vector of space has the components `.x`, `.y` and `.z`, not `.w`"]);
    output(
        "(P + l).z",
        &[
            "8:25 a vector of space and a scalar cannot be added or subtracted; take a component (`.x`, `.y`) or build a vector \
           `[x, y]`",
        ],
    );
    output(
        "P*P",
        &["8:24 two vectors cannot be multiplied with `*`; the scalar product is `inner(a, b)`, the vector product \
           `cross(a, b)`"],
    );
    output("P", &["8:24 output `height` is a vector; write one output for each component: `height_x = (..).x;`"]);
    in_the_plane(
        "P.y;",
        "cross(P, P).y;",
        &[
            "8:30 a vector of the plane stands where one of space belongs, `[x, y, z]`",
            "8:33 a vector of the plane stands where one of space belongs, `[x, y, z]`",
        ],
    );
}

#[test]
fn rotations() {
    check(
        "euler(zxz, psi, theta, phi)",
        "euler(zyy, psi, theta, phi)",
        &["4:15 `zyy` turns about the same axis twice in a row"],
    );
    check(
        "euler(zxz, psi, theta, phi)",
        "rotation([1, 1, 0], psi)",
        &["4:18 an axis is a vector of length 1, and this one has 1.4142135623730951; write `u/norm(u)`"],
    );
    check(
        "euler(zxz, psi, theta, phi)",
        "rotation([cos(phi), sin(theta), 0], psi)",
        &["4:18 an axis is a vector of length 1; write `u/norm(u)`"],
    );
    check(
        "euler(zxz, psi, theta, phi)",
        "rotation(z, dot(psi))",
        &["4:21 the angle of a rotation is made of coordinates, parameters and time; `dot()` cannot stand in it"],
    );
    output("R", &["8:24 output `height` is a rotation; an output is a scalar"]);
    output(
        "(P*R).z",
        &[
            "8:25 a rotation is written to the left of what it turns: `R*v`, and `transpose(R)*v` for the other way round",
        ],
    );
    output("(R*l).z", &["8:27 a rotation turns vectors of three components and other rotations, not a scalar"]);
    output("norm(dot(R))", &["8:33 the rate of a rotation is an angular velocity: `angular_velocity(R)`"]);
    output("l*norm(omega(tap))", &["8:31 `omega(..)` takes the name of a body that turns"]);
    output(
        "l*(quaternion(0, 0, 0, 0)*[1, 0, 0]).x",
        &["8:27 four zeros are no quaternion: they have no direction; `quaternion(1, 0, 0, 0)` turns nothing"],
    );
    load("torque 1 [N*m] on top;", &["7:16 a scalar stands where a vector belongs; a vector is written `[x, y, z]`"]);
}

#[test]
fn quaternions_need_their_norm() {
    let sound = SOUND.replacen("phi [rad];", "phi [rad]; a; b; c; d;", 1);
    let sound =
        sound.replacen("euler(zxz, psi, theta, phi)", "quaternion(a, b, c, d)*rotation(x, psi + theta + phi)", 1);
    assert_eq!(
        mistakes(&sound),
        ["4:9 no constraint keeps the norm of this quaternion at 1; add \
          `constraints { a_norm: a^2 + b^2 + c^2 + d^2 = 1; }`"]
    );
    for (constraint, is_right) in [
        ("a^2 + b^2 + c^2 + d^2 = 1", true),
        ("sqrt(a^2 + b^2 + c^2 + d^2) = 1", true),
        ("3 = 3*(a^2 + b^2 + c^2 + d^2)", true),
        ("a^2 + b^2 + c^2 + d^2 = 2", false),
        ("a^2 + b^2 + c^2 = 1", false),
        ("a + b + c + d = 1", false),
    ] {
        let text = format!("{sound}constraints {{ unit: {constraint}; }}");
        assert_eq!(mistakes(&text).is_empty(), is_right, "{constraint}");
    }
}

#[test]
fn inertias_that_no_body_has() {
    let inertia = |written: &str, expected: &[&str]| check("[J, J, J/2]", written, expected);
    inertia(
        "J",
        &["6:36 the inertia of a body in space is `inertia [A, B, C]`, its principal moments, or \
           `inertia [Jxx, Jyy, Jzz, Jxy, Jxz, Jyz]`, in its own frame about its centre of mass"],
    );
    inertia(
        "[J, J]",
        &[
            "6:36 2 numbers are given; the inertia of a body in space is `inertia [A, B, C]`, its principal moments, or \
           `inertia [Jxx, Jyy, Jzz, Jxy, Jxz, Jyz]`, in its own frame about its centre of mass",
        ],
    );
    inertia("[J, J, -1 [kg*m^2]]", &["6:43 a mass or inertia cannot be negative"]);
    inertia("[J, J, m*l]", &["6:43 an inertia is in [kg*m^2], and `m*l` is in [kg*m] (m [kg], l [m])"]);
    inertia(
        "[J, J, J*phi]",
        &["6:43 a mass or inertia is made of numbers and parameters; it cannot change with the motion"],
    );
    let u = "[kg*m^2]";
    inertia(
        &format!("[1 {u}, 2 {u}, 4 {u}]"),
        &[
            "6:36 no body has this inertia: a principal moment is at most the sum of the other two: 4 is more than 1 + 2 (is it \
           about the centre of mass, in [kg*m^2]?)",
        ],
    );
    inertia(&format!("[1 {u}, 2 {u}, 2 {u}, 1.5 {u}, 0, 0]"), &["6:36 about some axis this inertia is negative"]);
    inertia(
        &format!("[1 {u}, 3 {u}, 3 {u}, 0, 0, 1 {u}]"),
        &[
            "6:36 no body has this inertia: a principal moment is at most the sum of the other two (is it about the centre of \
           mass, in [kg*m^2]?)",
        ],
    );
    // A thin rod.
    inertia(&format!("[0, 2 {u}, 2 {u}]"), &[]);
}

#[test]
fn attitudes() {
    check(
        "attitude R",
        "attitude psi",
        &[
            "6:58 a scalar stands where a rotation is needed; a rotation is written `rotation(axis, angle)`, `euler(zxz, a, b, c)` \
           or `quaternion(q0, q1, q2, q3)`",
        ],
    );
    check("attitude R", "attitude R, angle psi", &["6:58 body `top` has an angle and an attitude; keep one of them"]);
    check(
        ", attitude R",
        "",
        &["6:36 body `top` needs an attitude, as its inertia has several moments: `inertia [A, B, C], attitude R`"],
    );
    check(
        ", inertia [J, J, J/2]",
        "",
        &["6:10 the inertia of `top` is missing: `inertia [A, B, C]`, its principal moments, stands with an attitude"],
    );
    check(
        "attitude R",
        "attitude R, free",
        &["6:25 body `top` is free and has a position of its own, [top_x, top_y]; leave out `at ..`, or `free`"],
    );
}

#[test]
fn drawings() {
    let drawn = |line: &str, expected: &[&str]| check("line [0, 0, 0], P;", line, expected);
    drawn("circle P radius l normal R*[0, 0, 1]; slider P along [1, 0, 0];", &[]);
    drawn("circle P radius l;", &["9:18 a circle in space has a normal: `circle P radius r normal n;`"]);
    drawn("slider P along psi;", &["9:26 a scalar stands where a vector belongs; a vector is written `[x, y, z]`"]);
    in_the_plane(
        "line [0, 0], P;",
        "circle P radius l normal 1;",
        &["9:36 a circle in the plane has no normal; leave it out"],
    );
}

#[test]
fn joints() {
    let joint =
        |line: &str, expected: &[&str]| check("drawing {", &format!("joints {{ {line} }}\ndrawing {{"), expected);
    joint("j: revolute ground at [l, 0, 0] axis [0, 3/5, 4/5] to top at [0, 0, l] axis [0, 0, -1];", &[]);
    joint("j: screw ground at [l, 0, 0] axis [0, sin(l/(2 [m])), cos(l/(2 [m]))] to top at [0, 0, l] pitch l;", &[]);
    joint("j: roll top radius l axis [0, 0, 1] on [0, 0, 0] normal [0, 0, 1];", &[]);
    joint(
        "j: revolute ground to top;",
        &["9:29 expected `at`: `revolute a at [u, v, w] axis [0, 0, 1] to b at [u, v, w] axis [0, 0, 1];`"],
    );
    joint(
        "j: ball ground at [0, 0, 0] to tip at [0, 0, 0];",
        &["9:41 no body above is called `tip` (did you mean `top`?)"],
    );
    joint(
        "j: screw ground at [0, 0, 0] to top at [0, 0, 0];",
        &["9:58 expected `pitch`: `screw nut at P axis n to bolt at Q axis n pitch p;`"],
    );
    joint(
        "j: revolute ground at [0, 0, 0] axis [0, 0, 0] to top at [0, 0, 0];",
        &["9:47 an axis of length 0 has no direction; write `[0, 0, 1]`"],
    );
    joint(
        "j: revolute ground at [0, 0, 0] axis P to top at [0, 0, 0];",
        &[
            "9:47 the axis of a joint is written in the frame of its body, with numbers, `[0.6, 0, 0.8]`, or with a plain 0 among its \
           components, `[0, sin(a), cos(a)]`, or as the name of such a vector; turn the body's frame instead",
        ],
    );
    in_the_plane(
        "initial {",
        "joints { j: ball ground at [0, 0] to bob at [0, 0]; } initial {",
        &["7:38 body `bob` has no attitude; write `attitude R` in its line, or make it `free`"],
    );
}
