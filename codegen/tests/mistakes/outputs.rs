//! Outputs.

use super::check;

#[test]
fn outputs() {
    check(
        "height [m] = P.y",
        "pull [N] = reaction(stop)",
        &["8:31 no constraint is called `stop`; no constraint is declared"],
    );
    check(
        "phi [rad]; }",
        "phi [rad]; x [m]; y [m]; } constraints { pin: [x, y] = P; } outputs { pull [N] = reaction(pin_x); }",
        &["2:105 no constraint is called `pin_x`; write `reaction(pin).x`"],
    );
    check("height [m] = P.y", "pull [N] = reaction(P.y)", &["8:31 `reaction(..)` takes the name of a constraint"]);
    check(
        "height [m] = P.y",
        "height [m] = P",
        &["8:24 output `height` is a vector; write one output for each component: `height_x = (..).x;`"],
    );
    check(
        "height [m] = P.y",
        "height [m] = P.z",
        &["8:26 a vector of the plane has the components `.x` and `.y`, not `.z`"],
    );
    check("height [m] = P.y", "height [m] = phi.x", &["8:28 a scalar has no component `.x`"]);
    check(
        "height [m] = P.y",
        "height [mtr] = P.y",
        &[
            "8:19 `mtr` is not a known unit; known units are m, g, s, N, J, W, Pa, bar, A, V, Hz, rad, deg, rpm, min, inch, lb and others, with SI prefixes",
        ],
    );
    check(
        "height [m] = P.y",
        "phi [rad] = phi",
        &["8:11 `phi` is already a column of the results; choose another name"],
    );
    check(
        "phi [rad]; }",
        "phi [rad]; lambda_c; drive_phi; } constraints { c: lambda_c = phi; d: drive_phi = phi; }",
        &[
            "2:26 `lambda_c` is the column of the reaction of `c`; choose another name",
            "2:36 a sweep has a column `drive_phi`; choose another name",
        ],
    );
    check(
        "height [m] = P.y",
        "h [m] = P.y; ratio_h [m] = P.x",
        &["8:24 a sweep has a column `ratio_h`; choose another name"],
    );
    for (name, taken) in [("drive_phi", true), ("transmission_index", true), ("ratio_of_h", false)] {
        let mistake = format!("8:11 a sweep has a column `{name}`; choose another name");
        let mistakes = if taken { vec![mistake.as_str()] } else { vec![] };
        check("height [m] = P.y", &format!("{name} [rad] = phi"), &mistakes);
    }
    check(
        "height [m] = P.y",
        "third = dot(ddot(phi))",
        &["8:23 a third derivative is not computed; `ddot` of positions is the highest"],
    );
    check(
        "height [m] = P.y",
        "h [m] = P.y; h [m] = P.x",
        &["8:24 `h` is defined twice; choose another name for one of them", "8:11 the first definition of `h` is here"],
    );
}
