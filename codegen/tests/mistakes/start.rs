//! Start values.

use super::check;

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
