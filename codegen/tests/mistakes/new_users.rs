//! What new users write first.

use super::check;

#[test]
fn what_new_users_write() {
    check("l [m] = 1;", "l [m] = 1 [kg];", &["3:22 `l` is declared in [m], and `1 [kg]` is in [kg]"]);
    check("phi = 0.5;", "phi = 2 [m];", &["7:17 `phi` is declared in [rad], and `2 [m]` is in [m]"]);
    check(
        "phi = 0.5;",
        "phi_dot = 0.5;",
        &["7:11 no coordinate is called `phi_dot` (write `dot(phi) = ..;`); only coordinates have start values"],
    );
    check(
        "height [m] = P.y",
        "h [m] = P.y; k = h",
        &["8:28 `h` is an output; to use it here too, name its expression: `let h = ..;`"],
    );
    check("height [m] = P.y", "h = phi_dot", &["8:15 the rate of `phi` is written `dot(phi)` here"]);
    check("height [m] = P.y", "h = (P.x, P.y)", &["8:19 a vector is written in square brackets: `[x, y]`"]);
    check("height [m] = P.y", "h = phi.sin()", &["8:19 functions stand in front: `sin(..)`"]);
    check("height [m] = P.y", "h = .5*phi", &["8:15 a decimal number has a digit before its point: `0.5`"]);
    check("height [m] = P.y", "h = phi % 2", &["8:19 there is no operator `%`"]);
    check(
        "height [m] = P.y",
        "H [m] = P.y; h [m] = P.x",
        &["8:24 two figures would be called `h`; choose another name for one of them", "8:11 the other one is here"],
    );
    check(
        "height [m] = P.y",
        "mechanism \"Title\" { a [m] = P.y; }",
        &["8:11 `mechanism` is the figure of the mechanism itself; choose another name"],
    );
    check("height [m] = P.y", "height [Nm] = P.y", &["8:19 `Nm` is not a known unit; write `N*m`"]);
    check(
        "bodies { bob",
        "body { bob",
        &[
            "5:1 `body` is not a block (did you mean `bodies`?); blocks are `coordinates`, `parameters`, `bodies`, `loads`, `constraints`, `initial`, `events`, `outputs`, `drawing`, `kernels`, `auxiliary`, `inputs`, `joints`, `tables`, `speeds`, `run`, `frames`",
        ],
    );
    check("pub Pendulum;", "pub S;", &["1:5 `S` is the scalar type in generated code; choose another name"]);
    check("phi = 0.5;", "phi = ddot(phi);", &["7:17 a start value is made of numbers and parameters"]);
    check(
        "l [m] = 1;",
        "l [m] = 1; p [m/s] = dot(phi);",
        &["3:35 the default of a parameter is a number; what follows from other parameters is a `let`"],
    );
    check("l [m] = 1;", "l [Gm] = 1e305;", &["3:23 this is not a finite real number"]);
    check(
        "l [m] = 1;",
        "l [m] = 1; phi_dot = 2;",
        &["3:25 `phi_dot` is the name of a rate of `phi` in files and on the command line; choose another name"],
    );
    check(
        "let P = l*",
        "let w = 1e300*phi*1e300; let P = l*",
        &["4:9 a coefficient here is outside the range of numbers (about 1e-308 to 1e308)"],
    );
    check(
        "initial {",
        "constraints { pin: P = [0, l]; pin_x: P.y = l; } initial {",
        &["7:32 two constraint rows would be called `pin_x`; choose another name for one of them"],
    );
    check(
        "initial {",
        "constraints { pin: [phi, 0] = [0, 0]; } initial {",
        &[
            "7:15 no coordinate moves constraint `pin_y`: it holds always or never; leave it out, or make it depend on a coordinate",
        ],
    );
}
