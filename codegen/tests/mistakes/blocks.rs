//! Whole blocks.

use super::check;

#[test]
fn whole_blocks() {
    check(
        "phi [rad];",
        "phi [rad]; s [m];",
        &["2:26 coordinate `s` moves no body and stands in no constraint; use it or leave it out"],
    );
    check("phi [rad]; }", "}", &["1:5 a mechanism needs at least one coordinate: `coordinates { phi [rad]; }`"]);
    check(
        "bodies { bob: mass m at P, angle phi; }",
        "",
        &["1:5 a mechanism needs at least one body: `bodies { rod: mass m at G, inertia J, angle phi; }`"],
    );
    check(
        "line [0, 0], P;",
        "lime [0, 0], P;",
        &[
            "9:11 `lime` is not known here; expected one of `line`, `slider`, `ground`, `point`, `circle`, `curve`, `spring`, `damper`, `trace`",
        ],
    );
    check(
        "line [0, 0], P;",
        "line [0, 0], P.x;",
        &["9:24 a scalar stands where a vector belongs; a vector is written `[x, y]`"],
    );
    check("line [0, 0], P;", "spring [0, 0], P, P;", &["9:11 a drawn spring has two ends: `spring A, B;`"]);
    check("line [0, 0], P;", "line [0, 0], P; trace P; trace P, l*[1, 0];", &[]);
    check(
        "line [0, 0], P;",
        "trace;",
        &["9:16 an expression is missing here: a number, a name, a vector `[x, y]` or `(..)`"],
    );
    check(
        "line [0, 0], P;",
        "trace P, P.x;",
        &["9:20 a scalar stands where a vector belongs; a vector is written `[x, y]`"],
    );
    check("line [0, 0], P;", "slider P;", &["9:19 expected `along`: `slider A along beta;`"]);
    check("pub Pendulum;", "pub Pendulum", &["2:1 a declaration starts with the mechanism's name: `pub QuickReturn;`"]);
    check(
        "bodies { bob: mass m at P, angle phi; }",
        "bodies { bob: mass mm at P, angle fi; bar: inertia 1 [kg*m^2]; }",
        &[
            "5:20 no value is called `mm`; declared: `phi`, `l`, `m`, `g`, `P`",
            "5:35 no value is called `fi`; declared: `phi`, `l`, `m`, `g`, `P`",
            "5:52 body `bar` needs the angle that it turns by: `inertia J, angle phi`",
        ],
    );
    check(
        "phi [rad]; }",
        "phi rad; } parameters { k = ; c [1 = 2]; d [m] 3; }",
        &[
            "2:19 a unit stands in brackets: `phi [rad]`",
            "2:43 an expression is missing here: a number, a name, a vector `[x, y]` or `(..)`",
            "2:50 this is not a unit; units are written like `[kg*m^2]`, `[m/s^2]` or `[1/s]`",
            "2:62 parameter `d` needs a default: `d [unit] = value;`",
        ],
    );
}
