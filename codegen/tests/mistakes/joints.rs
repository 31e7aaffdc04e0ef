//! Joints, and points on bodies.

use super::{SOUND, check_without_units as check, mistakes, without_units};

fn joint(written: &str, expected: &[&str]) {
    check("initial {", &format!("joints {{ {written} }} initial {{"), expected);
}

#[test]
fn joints() {
    joint("pivot: slot P through [0, 1] along phi;", &[]);
    joint("pivot: slot on(bob, [l, 0]) through [0, 1] along phi;", &[]);
    joint(
        "pivot: glue P to [0, 1];",
        &[
            "7:17 `glue` is not known here; expected one of `pin`, `link`, `slot`, `slide`, `gear`, `rack`, `cam`, `roll`, `ball`, \
             `revolute`, `cylindrical`, `prismatic`, `universal`, `planar`, `screw`, `weld`",
        ],
    );
    joint("pivot: pin P and [0, 1];", &["7:23 expected `to`: `pin P to Q;`"]);
    joint("pivot: pin P;", &["7:22 expected `to`: `pin P to Q;`"]);
    joint("pivot: link P to [0, 1];", &["7:33 expected `, length l`: `link P to Q, length l;`"]);
    joint("pivot: slot P along 1;", &["7:24 expected `through`: `slot P through O along beta;`"]);
    joint(
        "pin P to [0, 1];",
        &[
            "7:14 a joint is written `name: pin P to Q;`, with `pin`, `link`, `slot`, `slide`, `gear`, `rack`, `cam` or `roll`",
        ],
    );
    joint("pivot: pin on(bab, [1, 0]) to [0, 1];", &["7:24 no body above is called `bab` (did you mean `bob`?)"]);
    joint(
        "pivot: pin on(bob) to [0, 1];",
        &["7:21 a point on a body is written `on(body, [u, v])`, in space `on(body, [u, v, w])`"],
    );
    joint(
        "pivot: pin P to 1;",
        &["7:21 the left side is a vector and the right side a scalar; both must be of one kind"],
    );
    joint("mesh: gear bob radius 1 to wheel radius 2;", &["7:37 no body above is called `wheel`"]);
}

/// The sound declaration with another body.
fn body(line: &str, expected: &[&str]) {
    let text = without_units(SOUND).replacen("bodies {", &format!("bodies {{ {line}"), 1);
    assert_eq!(mistakes(&text), expected, "\nin: {text}");
}

#[test]
fn frames() {
    body("rod: free, mass m, inertia 1;", &[]);
    body(
        "rod: free, mass m at P, inertia 1;",
        &["5:31 body `rod` is free and has a position of its own, [rod_x, rod_y]; leave out `at ..`, or `free`"],
    );
    body(
        "rod: free, mass m, inertia 1, angle phi;",
        &["5:46 body `rod` is free and has an angle of its own, rod_phi; leave out `angle ..`, or `free`"],
    );
    body("rod: free, inertia 1;", &["5:15 the mass of free body `rod` is missing: `rod: free, mass m, inertia J;`"]);
    body("rod: free, mass m;", &["5:15 the inertia of free body `rod` is missing: `rod: free, mass m, inertia J;`"]);
    body("rod: mass 1 at on(bob, [1, 0]);", &["5:28 no body above is called `bob`"]);
    body(
        "rod: mass 1 at P; tip: mass 1 at on(rod, [1, 0]);",
        &["5:46 body `rod` has no angle; write `angle phi` in its line, or make it `free`"],
    );
    body(
        "rod: inertia 1, angle phi; tip: mass 1 at on(rod, [1, 0]);",
        &["5:55 body `rod` has no position; write `mass m at P` in its line, or make it `free`"],
    );
}
