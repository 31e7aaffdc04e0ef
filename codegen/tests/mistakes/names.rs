//! Names: unknown, taken, reserved.

use super::check;

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
fn what_is_generated_has_names_of_its_own() {
    let expected = ["1:5 `S` is the scalar type in generated code; choose another name"];
    check("pub Pendulum;", "pub S;", &expected);
    for name in ["sim", "sim_kernel", "core", "alloc", "std", "r#std"] {
        let expected = format!("1:5 `{name}` is a crate that generated code refers to; choose another name");
        check("pub Pendulum;", &format!("pub {name};"), &[&expected]);
    }
    for name in ["self", "Self", "super", "crate", "_"] {
        check(
            "pub Pendulum;",
            &format!("pub {name};"),
            &["1:5 a declaration starts with the mechanism's name: `pub QuickReturn;`"],
        );
    }
    // These are compiled in `tests/language/names_of_mechanisms.rs`.
    for name in ["T", "U", "Mechanism", "Option", "f64"] {
        check("pub Pendulum;", &format!("pub {name};"), &[]);
    }
}

#[test]
fn uses_of_a_reserved_name_are_no_mistakes_too() {
    let expected = ["3:14 `e` is Euler's number in the language; choose another name"];
    check("l [m] = 1;", "e [m] = 0.1; l [m] = 1;", &expected);
    let used = ["4:5 `e` is Euler's number in the language; choose another name"];
    check("let P = l*[sin(phi), -cos(phi)];", "let e = 0.1*l; let P = e*[sin(phi), -cos(phi)] + [e, l + e];", &used);
    check("phi [rad];", "phi [rad]; t [m];", &["2:26 `t` is time in the language; choose another name"]);
}
