//! Bodies.

use super::check;

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
        &[
            "5:20 the mass of body `bob` needs a position: write `mass m at P`, P being its centre of mass, or make the body `free`",
        ],
    );
    check(
        "mass m at P, angle phi",
        "inertia m*l^2",
        &[
            "5:23 body `bob` needs the angle that it turns by: `inertia J, angle phi`",
            "6:9 gravity acts on masses, and no body has one; write `mass m at P` in a body's line",
        ],
    );
    check(
        "mass m at P, angle phi",
        "mass m at [l, 0]",
        &["5:10 no coordinate moves body `bob`; leave it out, or make its position or angle depend on a coordinate"],
    );
    check(
        "mass m at P",
        "mass m*phi at P",
        &["5:20 a mass or inertia is made of numbers and parameters; it cannot change with the motion"],
    );
    check("mass m at P", "mass -2 [kg] at P", &["5:20 a mass or inertia cannot be negative"]);
    check(
        "mass m at P",
        "mass m at dot(P)",
        &["5:25 the position of a mass is made of coordinates, parameters and time; `dot()` cannot stand in it"],
    );
    check("mass m at P", "mass m of P", &["5:22 an operator or `;` is missing before `of`"]);
    check("mass m at P", "mass m at P, mass m at P", &["5:28 body `bob` has its mass twice"]);
}
