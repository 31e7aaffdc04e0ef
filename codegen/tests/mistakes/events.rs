//! Events: directions and actions.

use super::check_without_units as check;

/// Replaces `initial {` of line 7 by a block of events in front of it.
fn events(block: &str, expected: &[&str]) {
    check("initial {", &format!("events {{ {block} }} initial {{"), expected);
}

#[test]
fn conditions_and_directions() {
    events(
        "top: phi = 0 upwards;",
        &["7:23 crossings in one direction are written `rising` or `falling`: `top: dot(y) = 0 falling;`"],
    );
    events(
        "top: phi = 0 rising falling;",
        &["7:30 expected `;` at the end of this line, or `rising`, `falling`, `{ .. }` with what happens then"],
    );
    events(
        "top: P = 0 rising;",
        &["7:15 the left side is a vector and the right side a scalar; both must be of one kind"],
    );
    events("top: P = [0, 0] rising;", &["7:15 an event is an equation between scalars; take a component (`.x`, `.y`)"]);
    events(
        "top: l = 1 rising { stop; }",
        &["7:10 event `top` never changes; make it depend on a coordinate, a speed, a reaction or `t`"],
    );
    events("top: reaction(rod) = 0;", &["7:24 no constraint is called `rod`; no constraint is declared"]);
}

#[test]
fn actions() {
    events(
        "top: phi = 0 { halt; }",
        &[
            "7:25 `halt` is not known here; expected one of `record`, `stop`, `set`, `swap`, `activate`, `release`, `impact`",
        ],
    );
    events("top: phi = 0 { stop }", &["7:30 expected `;` at the end of this line"]);
    events(
        "top: phi = 0 { stop after 0; }",
        &["7:36 `stop after` takes the number of an occurrence, a whole number from 1: `stop after 3;`"],
    );
    events(
        "top: phi = 0 { stop after l; }",
        &["7:36 `stop after` takes the number of an occurrence, a whole number from 1: `stop after 3;`"],
    );
    events(
        "top: phi = 0 { set height = 1; }",
        &["7:29 no coordinate or parameter is called `height`; coordinates, their speeds and parameters are set"],
    );
    events(
        "top: phi = 0 { set phi_dot = 1; }",
        &[
            "7:29 no coordinate or parameter is called `phi_dot` (write `set dot(phi) = ..;`); coordinates, their speeds and parameters are set",
        ],
    );
    events("top: phi = 0 { set dot(m) = 1; }", &["7:33 `m` is a parameter and has no speed: `set m = ..;`"]);
    events(
        "top: phi = 0 { set dot(P.x) = 1; }",
        &["7:34 only the speed of a coordinate can be set, `set dot(alpha) = ..;`, not that of an expression"],
    );
    events("top: phi = 0 { set phi 1; }", &["7:33 what is set: `set x = 0;`, `set dot(x) = 0;` or `set m = 2;`"]);
    events("top: phi = 0 { set m = m*1.5; set m = 2; }", &["7:44 `m` is set twice at once; keep one"]);
    events(
        "top: phi = 0 { set dot(phi) = ddot(phi); }",
        &[
            "7:40 an event sets values made of coordinates, speeds, parameters and `t`; accelerations and reactions are not known there",
        ],
    );
    events("top: phi = 0 { swap phi; }", &["7:33 two coordinates are swapped: `swap q1, q2;`"]);
    events("top: phi = 0 { swap phi, m; }", &["7:35 no coordinate is called `m`"]);
    events("top: phi = 0 { swap phi, phi; }", &["7:35 a coordinate is swapped with another one, not with itself"]);
}
