//! Expressions.

use super::check;

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
