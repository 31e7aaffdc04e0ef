//! Constraints and events.

use super::check;

#[test]
fn constraints_and_events() {
    check(
        "initial {",
        "constraints { stop: l = 1 [m]; } initial {",
        &[
            "7:15 no coordinate moves constraint `stop`: it holds always or never; leave it out, or make it depend on a coordinate",
        ],
    );
    check(
        "initial {",
        "constraints { stop: P = 1; } initial {",
        &["7:21 the left side is a vector and the right side a scalar; both must be of one kind"],
    );
    check("initial {", "constraints { stop: P.y == 1; } initial {", &["7:25 an equation is written with one `=`"]);
    check(
        "initial {",
        "constraints { stop: P.y = l; stop: P.x = l; } initial {",
        &[
            "7:30 two constraint rows would be called `stop`; choose another name for one of them",
            "7:30 `stop` is defined twice; choose another name for one of them",
            "7:15 the first definition of `stop` is here",
        ],
    );
    check(
        "initial {",
        "constraints { P.y = 1; } initial {",
        &["7:16 an equation has a name: `closure: left = right;`"],
    );
    check(
        "initial {",
        "constraint { stop: P.y = 1; } initial {",
        &[
            "7:1 `constraint` is not a block (did you mean `constraints`?); blocks are `coordinates`, `parameters`, `bodies`, `loads`, `constraints`, `initial`, `events`, `outputs`, `drawing`, `kernels`, `auxiliary`, `inputs`, `joints`, `tables`, `speeds`, `run`, `frames`",
        ],
    );
    check(
        "initial {",
        "kernels { jacobian; } initial {",
        &["7:11 `jacobian` is not known here; expected one of `dynamics_jacobian`, `dynamics_sensitivity`, \
             `inverse_dynamics`, `speed_mass_matrix`"],
    );
    check(
        "initial {",
        "events { top: l = 1 [m]; } initial {",
        &["7:10 event `top` never changes; make it depend on a coordinate, a speed, a reaction or `t`"],
    );
}
