//! Parameters and `let`.

use super::check;

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
    check("l [m] = 1;", "l [in] = 1;", &["3:17 `in` is not a unit; inches are `inch`"]);
    check("l [m] = 1;", "l [] = 1;", &["3:16 an empty unit; write `[m]`, or `[1]` for a pure number"]);
    check("let P = l*", "let P = Q; let Q = l*", &["4:9 `Q` is defined only below; move its line above this one"]);
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
