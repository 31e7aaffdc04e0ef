//! Loads.

use super::check;

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
        &[
            "6:17 this vector has three components, but the first vector makes the mechanism planar; write `[x, y]`, or \
             three components everywhere",
            "4:11 the first vector stands here",
        ],
    );
    check(
        "gravity [0, -g]",
        "gravitation [0, -g]",
        &[
            "6:9 `gravitation` is not known here; expected one of `force`, `torque`, `gravity`, `potential`, `dissipation`, `spring`, `damper`, `friction`",
        ],
    );
    check("gravity [0, -g]", "torque 3 [N*m] on bop", &["6:27 no body is called `bop` (did you mean `bob`?)"]);
    check(
        "gravity [0, -g]",
        "force [m*l*ddot(phi), 0] at P",
        &["6:15 a load is made of coordinates, speeds, parameters and time; `ddot()` cannot stand in it"],
    );
    check("gravity [0, -g]", "force [1, 0]", &["6:21 expected `at`: `force [F, 0] at P;`"]);
    check(
        "gravity [0, -g];",
        "gravity [0, -g]; gravity [g, 0];",
        &["6:26 gravity is declared twice; keep one", "6:9 it is first declared here"],
    );
}
