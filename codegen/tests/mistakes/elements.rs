//! Loads along scalars: springs, dampers, potentials, dissipation functions.

use super::check_without_units as check;

fn check_each(table: &[(&str, &[&str])]) {
    for (line, expected) in table {
        check("gravity [0, -g];", line, expected);
    }
}

#[test]
fn springs() {
    #[rustfmt::skip]
    check_each(&[
        ("spring 3 from [1, 0] to P;", &["6:18 a spring needs a `length` or a `rest` where it exerts no force: `spring k, length l0 from A to B;` or `spring k, rest phi0 between alpha and beta;`"]),
        ("spring 3, from [1, 0] to P;", &["6:19 `from` is not known here; expected one of `length`, `rest`"]),
        ("spring 3, rest 1 from [1, 0] to P;", &["6:19 a spring between points has a `length`: `spring k, length l0 from A to B;` or `spring k, rest phi0 between alpha and beta;`"]),
        ("spring 3, length 1 between 0 and phi;", &["6:19 a `length` belongs to a spring between points; write `rest` here: `spring k, length l0 from A to B;` or `spring k, rest phi0 between alpha and beta;`"]),
        ("spring 3, length 1 from [1, 0];", &["6:39 expected `to`: `from A to B`"]),
        ("spring 3, length 1 at P;", &["6:28 expected `from`, `between` or `on`: `spring k, length l0 from A to B;` or `spring k, rest phi0 between alpha and beta;`"]),
        ("spring 3, length 1 from 0 to P;", &["6:33 a scalar stands where a vector belongs; a vector is written `[x, y]`"]),
        ("spring [3, 0], length 1 from [1, 0] to P;", &["6:16 a vector stands where a scalar belongs; take a component (`.x`, `.y`) or `norm(..)`"]),
        ("spring 3, length 1 from [1, 0] to [l, 0];", &["6:9 no coordinate changes this extent, so the load does nothing; leave it out"]),
        ("spring 3, length 1 from [0, 0] to P;", &["6:9 no coordinate changes this extent, so the load does nothing; leave it out"]),
        ("spring 3*streth^3, length 1 from [1, 0] to P;", &["6:18 no value is called `streth`; declared: `phi`, `l`, `m`, `g`, `P`"]),
        ("spring 3, length 1 from [1, 0] to dot(P);", &["6:43 the end of an element is made of coordinates, parameters and time; `dot()` cannot stand in it"]),
        ("spring 3, rest 1 on P;", &["6:29 a vector stands where a scalar belongs; take a component (`.x`, `.y`) or `norm(..)`"]),
        ("spring 3, rest dot(dot(phi)) on phi;", &["6:24 a load is made of coordinates, speeds, parameters and time; `ddot()` cannot stand in it"]),
    ]);
}

#[test]
fn dampers_and_forces_along_scalars() {
    #[rustfmt::skip]
    check_each(&[
        ("damper 3 at P;", &["6:18 expected `from`, `between` or `on`: `damper c from A to B;`"]),
        ("damper 3*stretch from [1, 0] to P;", &["6:16 `stretch` belongs to springs; the force of a damper depends on `rate`"]),
        ("damper 3*ddot(phi) on phi;", &["6:16 a load is made of coordinates, speeds, parameters and time; `ddot()` cannot stand in it"]),
        ("damper -3*rate on dot(phi);", &["6:27 the extent of an element is made of coordinates, parameters and time; `dot()` cannot stand in it"]),
        ("dampers 3 on phi;", &["6:9 `dampers` is not known here; expected one of `force`, `torque`, `gravity`, `potential`, `dissipation`, `spring`, `damper`, `friction`"]),
        ("force 3 on bob;", &["6:20 `bob` is a body; a force on it acts at a point: `force [F, 0] at P;`"]),
        ("force [3, 0] on phi;", &["6:15 a vector stands where a scalar belongs; take a component (`.x`, `.y`) or `norm(..)`"]),
        ("force 3 between phi;", &["6:28 expected `and`: `between alpha and beta`"]),
        ("torque 3;", &["6:17 expected `on`: `torque T on body;`"]),
        ("torque 3 on l;", &["6:21 no coordinate changes this extent, so the load does nothing; leave it out"]),
        ("torque 3 on phy;", &["6:21 no body is called `phy`; declared: `bob`"]),
    ]);
}

#[test]
fn potentials_and_dissipation_functions() {
    #[rustfmt::skip]
    check_each(&[
        ("potential m*g*P.y + dot(phi);", &["6:19 a potential energy is made of coordinates, parameters and time; `dot()` cannot stand in it"]),
        ("potential [0, m*g];", &["6:19 a vector stands where a scalar belongs; take a component (`.x`, `.y`) or `norm(..)`"]),
        ("potential m*g*l;", &["6:19 this potential energy depends on no coordinate, so it exerts no force"]),
        ("dissipation m*ddot(phi)^2;", &["6:21 a load is made of coordinates, speeds, parameters and time; `ddot()` cannot stand in it"]),
        ("dissipation m*phi^2;", &["6:21 this dissipation function depends on no speed, so it exerts no force; write it with `dot(..)`"]),
        ("dissipation dot(P);", &["6:21 a vector stands where a scalar belongs; take a component (`.x`, `.y`) or `norm(..)`"]),
    ]);
}

#[test]
fn own_names_for_the_words_of_laws() {
    check(
        "loads { gravity [0, -g]; }",
        "let stretch = 3; loads { spring 3*stretch, length 1 from [1, 0] to P; }",
        &["6:33 in the law of an element `stretch` has its own meaning", "6:5 choose another name for this `stretch`"],
    );
    check(
        "loads { gravity [0, -g]; }",
        "let rate = 3; loads { spring 3, length 1 from [1, 0] to P; damper 3*rate on phi; }",
        &["6:67 in the law of an element `rate` has its own meaning", "6:5 choose another name for this `rate`"],
    );
}

#[test]
fn friction() {
    #[rustfmt::skip]
    check_each(&[
        ("friction 3 on phi;", &["6:20 dry friction needs the speed v0 over which it is smoothed, as in F*tanh(x'/v0): `friction F, smooth v0 on x;`"]),
        ("friction 3, within 1 on phi;", &["6:21 expected `smooth`: `friction F, smooth v0 on x;`"]),
        ("friction 3, smooth 0 on phi;", &["6:28 the speed over which friction is smoothed must be above 0: a force that jumps cannot be integrated"]),
        ("friction 3, smooth 1 on P;", &["6:33 a vector stands where a scalar belongs; take a component (`.x`, `.y`) or `norm(..)`"]),
    ]);
}

#[test]
fn choices() {
    #[rustfmt::skip]
    check_each(&[
        ("torque if phi > 0 then 1 on bob;", &["6:34 expected `else`: `if a > b then x else y`"]),
        ("torque if phi then 1 else 2 on bob;", &["6:23 expected a comparison, `<`, `<=`, `>` or `>=`: `if a > b then x else y`"]),
        ("torque if phi == 0 then 1 else 2 on bob;", &["6:23 varying quantities are equal only for an instant; compare with `<`, `<=`, `>` or `>=`"]),
        ("torque if 0 < phi < 1 then 1 else 2 on bob;", &["6:27 one comparison at a time; for a range write one `if` inside another"]),
        ("torque if P > 0 then 1 else 2 on bob;", &["6:19 a vector stands where a scalar belongs; take a component (`.x`, `.y`) or `norm(..)`"]),
        ("torque if phi > 0 then P else 2 on bob;", &["6:32 `then` gives a vector and `else` a scalar; both must be of one kind"]),
        ("torque phi > 0 on bob;", &["6:20 a comparison stands in a choice: `if a > b then x else y`"]),
        ("torque 1 + if phi > 0 then 1 else 2 on bob;", &["6:20 a choice inside an operation stands in parentheses: `a + (if b > c then x else y)`"]),
        ("torque if(phi > 0, 1, 2) on bob;", &["6:23 a comparison stands in a choice: `if a > b then x else y`"]),
        ("torque if (phi > 0) then 1 else 2 on bob;", &[]),
        ("torque max(phi) on bob;", &["6:16 `max` is written `max(a, b)`, of two values or more"]),
        ("torque min(phi, P) on bob;", &["6:25 a vector stands where a scalar belongs; take a component (`.x`, `.y`) or `norm(..)`"]),
        ("torque sign(phi, 1) on bob;", &["6:16 `sign` is written `sign(x)`: 1 wanted, 2 given"]),
    ]);
}

#[test]
fn inputs() {
    let table: [(&str, &str, &[&str]); 9] = [
        (
            "let P = l",
            "inputs { tau [N*m]; } let P = l",
            &[
                "4:19 input `tau` needs a course, which it follows until it is set: `tau [unit] = expression;`, of numbers, parameters and `t`",
            ],
        ),
        (
            "let P = l",
            "inputs { tau [N*m] = phi; } let P = l",
            &[
                "4:22 the declared course of an input is made of numbers, parameters and `t`; what depends on the motion is set at run time, or is a load",
            ],
        ),
        (
            "let P = l",
            "inputs { tau [N*m] = 3 [N]; } let P = l",
            &["4:22 `tau` is declared in [N*m], and `3 [N]` is in [N]"],
        ),
        (
            "let P = l",
            "inputs { tau [N*m] = 3; m = 1; } let P = l",
            &[
                "4:25 `m` is defined twice; choose another name for one of them",
                "3:25 the first definition of `m` is here",
            ],
        ),
        (
            "let P = l",
            "inputs { u [m] = 0; } let P = (l + u)",
            &[
                "5:25 the position of a mass cannot depend on an input, which may jump; use inputs in loads and outputs",
                "9:24 a drawn point cannot depend on an input, which may jump; use inputs in loads and outputs",
            ],
        ),
        ("let P = l*", "inputs { u = 0; } let P = l*", &[]),
        ("mass m at P", "mass m*u at P", &["5:22 no value is called `u`; declared: `phi`, `l`, `m`, `g`, `P`"]),
        (
            "outputs { height [m] = P.y; }",
            "outputs { height [m] = P.y; } inputs { u = 0; } constraints { c: phi = u; }",
            &["8:66 a constraint cannot depend on an input, which may jump; use inputs in loads and outputs"],
        ),
        (
            "outputs { height [m] = P.y; }",
            "outputs { height [m] = P.y; v = dot(u); } inputs { u = 0; } events { e: u = 1; }",
            &[
                "8:73 an event cannot depend on an input, which may jump; use inputs in loads and outputs",
                "8:37 the rate of an input is not known: it may jump",
            ],
        ),
    ];
    for (replace, by, expected) in table {
        super::check(replace, by, expected);
    }
}
