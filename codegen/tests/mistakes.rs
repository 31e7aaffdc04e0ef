//! Mistakes in declarations: each shows at the user's own word and says what would be right.
//!
//! A row replaces one part of a sound declaration, and lists all mistakes that are then found.

#![allow(missing_docs, clippy::unwrap_used)]

use proc_macro2::TokenStream;
use quote::quote;

const SOUND: &str = "pub Pendulum;
coordinates { phi [rad]; }
parameters { l [m] = 1; m [kg] = 2; g [m/s^2] = 9.81; }
let P = l*[sin(phi), -cos(phi)];
bodies { bob: mass m at P, angle phi; }
loads { gravity [0, -g]; }
initial { phi = 0.5; }
outputs { height [m] = P.y; }
drawing { line [0, 0], P; }
";

/// The mistakes of a text as `line:column message`.
fn mistakes(text: &str) -> Vec<String> {
    let tokens: TokenStream = text.parse().unwrap();
    let place = |e: &syn::Error| format!("{}:{}", e.span().start().line, e.span().start().column + 1);
    match codegen::generate(tokens, &quote!(sim_kernel)) {
        Ok(_) => vec![],
        Err(error) => error.into_iter().map(|e| format!("{} {e}", place(&e))).collect(),
    }
}

/// Replaces one part of the sound declaration and compares all mistakes.
fn check(replace: &str, by: &str, expected: &[&str]) {
    assert!(SOUND.contains(replace), "{replace}");
    assert_eq!(mistakes(&SOUND.replacen(replace, by, 1)), expected, "\nin: {by}");
}

#[test]
fn the_sound_declaration_has_none() {
    assert_eq!(mistakes(SOUND), Vec::<String>::new());
}

#[test]
fn names() {
    check("l*[sin(phi)", "L*[sin(phi)", &["4:9 no value is called `L` (did you mean `l`?)"]);
    check("l*[sin(phi)", "l*[sine(phi)", &["4:12 no function is called `sine` (did you mean `sin`?)"]);
    check("l*[sin(phi)", "length*[sin(phi)", &["4:9 no value is called `length`; declared: `phi`, `l`, `m`, `g`"]);
    check(
        "phi [rad];",
        "phi [rad]; phi [rad];",
        &[
            "2:26 `phi` is defined twice; choose another name for one of them",
            "2:15 the first definition of `phi` is here",
        ],
    );
    check(
        "g [m/s^2] = 9.81;",
        "g [m/s^2] = 9.81; phi = 3;",
        &[
            "3:55 `phi` is defined twice; choose another name for one of them",
            "2:15 the first definition of `phi` is here",
        ],
    );
    check("phi [rad];", "phi [rad]; t [s];", &["2:26 `t` is time in the language; choose another name"]);
    check(
        "phi [rad];",
        "phi [rad]; phi_dot;",
        &["2:26 `phi_dot` is the name of a rate of `phi` in files and on the command line; choose another name"],
    );
}

#[test]
fn bodies() {
    check("m at P", "m at P.x", &["5:25 a scalar stands where a vector belongs; a vector is written `[x, y]`"]);
    check(
        "m at P",
        "P at P",
        &["5:20 a vector stands where a scalar belongs; take a component (`.x`, `.y`) or `norm(..)`"],
    );
    check(
        "mass m at P",
        "mass m",
        &["5:20 where is the mass of `bob`? Write `mass m at P`, P being its centre of mass"],
    );
    check(
        "mass m at P, angle phi",
        "inertia m*l^2",
        &[
            "5:23 about which angle does `bob` turn? Write `inertia J, angle phi`",
            "6:9 gravity acts on masses, and no body has one; write `mass m at P` in a body's line",
        ],
    );
    check(
        "mass m at P, angle phi",
        "mass m at [l, 0]",
        &["5:10 no coordinate moves body `bob`; leave it out, or let its position or angle depend on a coordinate"],
    );
    check(
        "mass m at P",
        "mass m*phi at P",
        &["5:20 a mass or inertia is made of numbers and parameters; it cannot change with the motion"],
    );
    check("mass m at P", "mass -2 at P", &["5:20 a mass or inertia cannot be negative"]);
    check(
        "mass m at P",
        "mass m at dot(P)",
        &["5:25 the position of a mass is made of coordinates, parameters and time; `dot()` cannot stand in it"],
    );
    check("mass m at P", "mass m of P", &["5:22 an operator or `;` is missing before `of`"]);
    check("mass m at P", "mass m at P, mass m at P", &["5:28 body `bob` has its mass twice"]);
}

#[test]
fn loads() {
    check(
        "gravity [0, -g]",
        "gravity -g",
        &["6:17 a scalar stands where a vector belongs; a vector is written `[x, y]`"],
    );
    check(
        "gravity [0, -g]",
        "gravity [0, 0, -g]",
        &["6:17 a vector of the plane has two components, `[x, y]`; this has 3"],
    );
    check(
        "gravity [0, -g]",
        "gravitation [0, -g]",
        &["6:9 `gravitation` is not known here; expected one of `force`, `torque`, `gravity`"],
    );
    check("gravity [0, -g]", "torque 3 on bop", &["6:21 no body is called `bop` (did you mean `bob`?)"]);
    check(
        "gravity [0, -g]",
        "force [ddot(phi), 0] at P",
        &["6:15 a load is made of coordinates, speeds, parameters and time; `ddot()` cannot stand in it"],
    );
    check("gravity [0, -g]", "force [1, 0]", &["6:21 expected `at`: `force [F, 0] at P;`"]);
    check(
        "gravity [0, -g];",
        "gravity [0, -g]; gravity [g, 0];",
        &["6:26 gravity is declared twice; keep one", "6:9 it is first declared here"],
    );
}

#[test]
fn constraints_and_events() {
    check(
        "initial {",
        "constraints { stop: l = 1; } initial {",
        &[
            "7:15 no coordinate moves constraint `stop`: it holds always or never; leave it out, or let it depend on a coordinate",
        ],
    );
    check(
        "initial {",
        "constraints { stop: dot(phi) = 1; } initial {",
        &["7:21 a constraint holds between positions; `dot()` cannot stand in it"],
    );
    check(
        "initial {",
        "constraints { stop: P = 1; } initial {",
        &["7:21 a vector stands left and a scalar right; both sides are of one kind"],
    );
    check("initial {", "constraints { stop: P.y == 1; } initial {", &["7:25 an equation is written with one `=`"]);
    check(
        "initial {",
        "constraints { stop: P.y = 1; stop: P.x = 1; } initial {",
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
            "7:1 `constraint` is not a block (did you mean `constraints`?); blocks are `coordinates`, `parameters`, `bodies`, `loads`, `constraints`, `initial`, `events`, `outputs`, `drawing`, `kernels`",
        ],
    );
    check(
        "initial {",
        "kernels { jacobian; } initial {",
        &["7:11 `jacobian` is not known here; expected one of `dynamics_jacobian`, `dynamics_sensitivity`"],
    );
    check(
        "initial {",
        "events { top: l = 1; } initial {",
        &["7:10 event `top` never changes; let it depend on a coordinate, a speed or `t`"],
    );
}

#[test]
fn outputs() {
    check(
        "height [m] = P.y",
        "pull [N] = reaction(stop)",
        &["8:31 no constraint is called `stop`; no constraint is declared"],
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
    check("height [m] = P.y", "height [mtr] = P.y", &["8:19 `mtr` is not a known unit"]);
    check("height [m] = P.y", "phi [rad] = phi", &["8:11 `phi` is recorded already, under this name; choose another"]);
    check(
        "height [m] = P.y",
        "third = dot(ddot(phi))",
        &["8:23 a third derivative is not computed; `ddot` of positions is the highest"],
    );
    check(
        "height [m] = P.y",
        "h = P.y; h = P.x",
        &["8:20 `h` is defined twice; choose another name for one of them", "8:11 the first definition of `h` is here"],
    );
}

#[test]
fn expressions() {
    check(
        "height [m] = P.y",
        "h = P*P",
        &["8:15 two vectors cannot be multiplied with `*`; the scalar product is `inner(a, b)`"],
    );
    check(
        "height [m] = P.y",
        "h = P + 1",
        &[
            "8:15 a vector and a scalar cannot be added or subtracted; take a component (`.x`, `.y`) or build a vector `[x, y]`",
        ],
    );
    check("height [m] = P.y", "h = 1/P", &["8:17 a vector cannot divide; divide by `norm(..)` or by a component"]);
    check(
        "height [m] = P.y",
        "h = P^2",
        &["8:15 a vector cannot be raised to a power; the square of its length is `inner(a, a)`"],
    );
    check("height [m] = P.y", "h = phi**2", &["8:19 a power is written `^`: `x^2`, not `x**2`"]);
    check("height [m] = P.y", "h = 1/(phi - phi)", &["8:17 division by zero"]);
    check("height [m] = P.y", "h = sqrt(-1)*phi", &["8:15 this is not a finite real number"]);
    check("height [m] = P.y", "h = atan2(phi)", &["8:15 `atan2` is written `atan2(y, x)`: 2 wanted, 1 given"]);
    check("height [m] = P.y", "h = sin*phi", &["8:15 `sin` is a function; call it: `sin(..)`"]);
    check("height [m] = P.y", "h = phi(3)", &["8:15 `phi` is not a function; a product is written `phi*(..)`"]);
    check(
        "height [m] = P.y",
        "h = 9.81 m/s^2",
        &["8:20 a unit stands in brackets: `9.81 [m/s^2]`; a product is written `9.81*m`"],
    );
    check("height [m] = P.y", "h = 2m*phi", &["8:15 a unit stands in brackets: `2 [m]`; a product is written `2*m`"]);
    check(
        "height [m] = P.y",
        "h = phi [rad]",
        &[
            "8:19 a unit stands after a number or in a declaration; a name has the unit it was declared with. For a product with a vector write `*` before `[`",
        ],
    );
    check(
        "height [m] = P.y",
        "h = 2 phi",
        &["8:17 a unit stands in brackets: `2 [phi]`; a product is written `2*phi`"],
    );
    check("height [m] = P.y", "h = (phi + 1) 2", &["8:25 an operator is missing here; a product is written `a*b`"]);
    check("height [m] = P.y", "h = (phi 3)", &["8:20 an operator is missing here; a product is written `a*b`"]);
    check(
        "height [m] = P.y",
        "h = ",
        &["8:15 an expression is missing here: a number, a name, a vector `[x, y]` or `(..)`"],
    );
    check(
        "height [m] = P.y",
        "h = 1e999*phi",
        &["8:15 `1e999` is outside the range of numbers (about 1e-308 to 1e308)"],
    );
    check("height [m] = P.y", "h = \"text\"", &["8:15 a number is written like `9.81` or `1.5e-3`"]);
}

#[test]
fn start_values() {
    check(
        "phi = 0.5;",
        "phy = 0.5;",
        &["7:11 no coordinate is called `phy` (did you mean `phi`?); only coordinates have start values"],
    );
    check(
        "phi = 0.5;",
        "phi = 0.5; phi = 0.6;",
        &["7:22 the start of `phi` is given twice; keep one", "7:11 it is first given here"],
    );
    check("phi = 0.5;", "phi = dot(phi);", &["7:17 a start value is made of numbers and parameters"]);
    check("phi = 0.5;", "guess dot(phi) = 1;", &["7:17 speeds need no guess: they follow from linear equations"]);
}

#[test]
fn parameters_and_lets() {
    check("l [m] = 1;", "l [m];", &["3:19 parameter `l` needs a default: `l [unit] = value;`"]);
    check(
        "l [m] = 1;",
        "l [m] = 1; k = 2*l;",
        &["3:29 the default of a parameter is a number; what follows from other parameters is a `let`"],
    );
    check("l [m] = 1;", "l [m] = 1 m = 3;", &["3:24 a unit stands in brackets: `1 [m]`; a product is written `1*m`"]);
    check(
        "l [m] = 1;",
        "l [m*] = 1;",
        &["3:19 this is not a unit; units are written like `[kg*m^2]`, `[m/s^2]` or `[1/s]`"],
    );
    check("l [m] = 1;", "l [] = 1;", &["3:16 an empty unit; write `[m]`, or `[1]` for a pure number"]);
    check("let P = l*", "let P = Q; let Q = l*", &["4:9 `Q` is defined only below; move its `let` above this line"]);
    check("let P = l*", "let P = P + l*", &["4:9 `P` is defined by itself"]);
    check(
        "let P = l*",
        "let P = 0*q1 + q2*r*",
        &[
            "4:11 no value is called `q1`; declared: `phi`, `l`, `m`, `g`",
            "4:16 no value is called `q2`; declared: `phi`, `l`, `m`, `g`",
            "4:19 no value is called `r`; declared: `phi`, `l`, `m`, `g`",
        ],
    );
}

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
        &["9:11 `lime` is not known here; expected one of `line`, `slider`, `ground`, `point`, `circle`"],
    );
    check(
        "line [0, 0], P;",
        "line [0, 0], P.x;",
        &["9:24 a scalar stands where a vector belongs; a vector is written `[x, y]`"],
    );
    check("line [0, 0], P;", "slider P;", &["9:19 expected `along`: `slider A along beta;`"]);
    check("pub Pendulum;", "pub Pendulum", &["2:1 a declaration starts with the mechanism's name: `pub QuickReturn;`"]);
    check(
        "bodies { bob: mass m at P, angle phi; }",
        "bodies { bob: mass mm at P, angle fi; bar: inertia 1; }",
        &[
            "5:20 no value is called `mm`; declared: `phi`, `l`, `m`, `g`, `P`",
            "5:35 no value is called `fi`; declared: `phi`, `l`, `m`, `g`, `P`",
            "5:52 about which angle does `bar` turn? Write `inertia J, angle phi`",
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

#[test]
fn what_new_users_write() {
    check("l [m] = 1;", "l [m] = 1 [kg];", &["3:22 a value in `[m]` belongs here, and this is one in `[kg]`"]);
    check("phi = 0.5;", "phi = 2 [m];", &["7:17 a value in `[rad]` belongs here, and this is one in `[m]`"]);
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
        "H = P.y; h = P.x",
        &["8:20 two figures would be called `h`; choose another name for one of them", "8:11 the other one is here"],
    );
    check(
        "height [m] = P.y",
        "mechanism \"Title\" { a = P.y; }",
        &["8:11 `mechanism` is the figure of the mechanism itself; choose another name"],
    );
    check("height [m] = P.y", "height [Nm] = P.y", &["8:19 `Nm` is not a known unit; write `N*m`"]);
    check(
        "bodies { bob",
        "body { bob",
        &[
            "5:1 `body` is not a block (did you mean `bodies`?); blocks are `coordinates`, `parameters`, `bodies`, `loads`, `constraints`, `initial`, `events`, `outputs`, `drawing`, `kernels`",
        ],
    );
    check("pub Pendulum;", "pub S;", &["1:5 `S` stands for the scalar in what is generated; choose another name"]);
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
        "constraints { pin: P = [0, 1]; pin_x: P.y = 1; } initial {",
        &["7:32 two constraint rows would be called `pin_x`; choose another name for one of them"],
    );
    check(
        "initial {",
        "constraints { pin: [phi, 0] = [0, 0]; } initial {",
        &[
            "7:15 no coordinate moves constraint `pin_y`: it holds always or never; leave it out, or let it depend on a coordinate",
        ],
    );
}
