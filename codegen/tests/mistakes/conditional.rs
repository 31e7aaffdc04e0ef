//! Constraints that events switch or hit.

use super::check_without_units as check;

/// Constraints and events in front of `initial {` of line 7, the constraint alone on it.
fn switched(constraint: &str, events: &str, expected: &[&str]) {
    check("initial {", &format!("constraints {{ {constraint} }}\nevents {{ {events} }}\ninitial {{"), expected);
}

#[test]
fn what_holds_at_the_start() {
    switched(
        "stop: phi = 1 initially open;",
        "",
        &["7:39 `open` is not known here; expected one of `active`, `released`"],
    );
    switched(
        "stop: phi = 1 released;",
        "",
        &["7:29 a constraint that events switch is written with `initially`: `contact: y = 0 initially released;`"],
    );
    switched(
        "stop: l = 1 initially released;",
        "",
        &[
            "7:15 no coordinate moves constraint `stop`: it holds always or never; leave it out, or make it depend on a coordinate",
        ],
    );
    check(
        "parameters {",
        "constraints { stop: phi = 1 initially released; } parameters { stop_activity = 1;",
        &["3:64 `stop_activity` is the field that says whether constraint `stop` holds; choose another name"],
    );
}

#[test]
fn what_events_switch_and_hit() {
    const ALWAYS: &str = "constraint `stop` always holds; one that events switch or hit is declared \
                          `stop: .. initially released;` or `initially active`";
    let released = "stop: phi = 1 initially released;";
    switched("stop: phi = 1;", "hit: phi = 1 { activate stop; }", &[&format!("8:34 {ALWAYS}")]);
    switched("stop: phi = 1;", "hit: phi = 1 { impact stop; }", &[&format!("8:32 {ALWAYS}")]);
    switched(
        released,
        "hit: phi = 1 { activate stopp; }",
        &["8:34 no constraint is called `stopp` (did you mean `stop`?)"],
    );
    switched(
        released,
        "hit: phi = 1 { activate stop_x; }",
        &["8:34 no constraint is called `stop_x` (did you mean `stop`? Its rows are switched together)"],
    );
    switched(released, "hit: phi = 1 { activate; }", &["8:33 expected the name of a constraint: `activate contact;`"]);
    switched(
        released,
        "hit: phi = 1 { release stop; activate stop; }",
        &["8:48 this constraint is switched twice at once; keep one"],
    );
    switched(
        released,
        "hit: phi = 1 { impact stop; impact stop restitution 1; }",
        &["8:45 this constraint is hit twice at once; keep one"],
    );
    switched(
        released,
        "hit: phi = 1 { impact stop restitution -0.5; }",
        &["8:49 a coefficient of restitution is not negative: 0 for no rebound, 1 for a full one"],
    );
    switched(
        released,
        "hit: phi = 1 { impact stop restitution reaction(stop); }",
        &["8:49 a coefficient of restitution follows from coordinates, speeds, parameters and `t`"],
    );
    switched(
        released,
        "hit: phi = 1 { impact stop restitution P; }",
        &["8:49 a vector stands where a scalar belongs; take a component (`.x`, `.y`) or `norm(..)`"],
    );
}
