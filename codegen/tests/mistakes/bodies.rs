//! Bodies.

use super::{check, mistakes};

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

/// What is placed, and energies, may have corners but no jumps.
#[test]
fn jumps() {
    let declared = |s: &str, rest: &str| {
        format!(
            "pub Support; coordinates {{ y [m]; }} parameters {{ h [m] = 0.1; E [J] = 2; k [N/m] = 3; }}
let s = {s};
{rest}"
        )
    };
    let placed = "bodies { b: mass 1 [kg] at [y + s, 0]; }";
    let told =
        "3:28 the position of a mass jumps here, and nothing moves so far in no time: let it change within some time";
    for (s, expected) in [
        ("if t < 1.3 [s] then 0 [m] else h", vec![told]),
        ("2*h*(if t < 1 [s] then 0 else if t < 2 [s] then 1 else 3)", vec![told]),
        ("if y < h then 0 [m] else h", vec![told]),
        ("h*sign(t - 1 [s])", vec![told]),
        ("if t < 1 [s] then 0 [m] else h*(t/(1 [s]) - 1)", vec![]),
        ("h*max(0, t - 1 [s])/(1 [s])", vec![]),
        ("(y - h)*(if y > h then 2 else 1)", vec![]),
        ("h*abs(t/(1 [s]) - 1)", vec![]),
        ("if h > 1 [m] then h else 2*h", vec![]),
    ] {
        assert_eq!(mistakes(&declared(s, placed)), expected, "{s}");
    }
    let told = "3:56 this potential energy jumps where a position does not, so that no force is its slope: let it change within some way";
    for (energy, expected) in [
        ("if y > h then E else 0", vec![told]),
        ("E*sign(y - h)", vec![told]),
        ("if y > h then k*(y - h)^2 else 0", vec![]),
        ("k*y^2*(if t > 1 [s] then 2 else 1)", vec![]),
    ] {
        let loads = format!("bodies {{ b: mass 1 [kg] at [y, 0]; }} loads {{ potential {energy}; }}");
        assert_eq!(mistakes(&declared("h", &loads)), expected, "{energy}");
    }
}
