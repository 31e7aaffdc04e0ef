//! Auxiliary displacements leave everything else as it is, to the last letter of the generated code.

#![allow(missing_docs, clippy::unwrap_used)]

/// A four-bar with a skate on its coupler: constraints between positions and between speeds.
const DECLARATION: &str = "pub Bar;
coordinates { a [rad]; b [rad]; c [rad]; x [m]; }
parameters { l [m] = 1; m [kg] = 2; }
AUXILIARY
let A = [x, 0] + l*[cos(a), sin(a)] + SHIFT;
let B = A + 2*l*[cos(b), sin(b)];
bodies { one: mass m at A/2, inertia 1 [kg*m^2], angle a; two: mass 3*m at (A + B)/2 + SHIFT, inertia m*l^2, angle b + TURN;
    three: inertia 2 [kg*m^2], angle c; }
loads { gravity [0, -9.81 [m/s^2]]; force 1 [N]*[sin(1 [rad/s]*t), 1] at B + SHIFT; torque 2 [N*m*s]*dot(b) on two; }
constraints { closure: B + SHIFT = [3 [m], 0] + l*[cos(c), sin(c)]; blade: inner(dot(A), [sin(b), cos(b)]) = 0; }
outputs { height [m] = B.y; pull [N] = reaction(closure).x; REACTIONS }
drawing { line A, B; }
";

/// The generated code without the text of the declaration.
fn generated(auxiliary: &str, shift: &str, turn: &str, reactions: &str) -> String {
    let text = DECLARATION.replace("AUXILIARY", auxiliary).replace("SHIFT", shift);
    let text = text.replace("TURN", turn).replace("REACTIONS", reactions);
    let code = codegen::generate_text(&text, "sim_kernel").unwrap();
    code.lines()
        .filter(|line| !line.contains("declaration: ") && !line.contains("declaration_hash: "))
        .collect::<Vec<_>>()
        .join("\n")
}

/// One function of the code.
fn function<'c>(code: &'c str, name: &str) -> &'c str {
    let start = code.find(&format!("pub fn {name}")).unwrap();
    let rest = &code[start..];
    &rest[..rest.find("\n    }\n").unwrap()]
}

#[test]
fn auxiliary_displacements_change_no_letter() {
    let plain = generated("", "[0, 0]", "0", "");
    let displaced = generated("auxiliary { s [m]; r [mm]; turn [rad]; }", "[s, r]", "turn", "");
    assert!(plain == displaced, "the code differs");
    let asked = generated(
        "auxiliary { s [m]; r [mm]; turn [rad]; }",
        "[s, r]",
        "turn",
        "along [N] = reaction(s); moment [N*m] = reaction(turn);",
    );
    for kernel in [
        "dynamics",
        "mass_matrix",
        "convective_forces",
        "generalized_forces",
        "constraints",
        "constraint_jacobian",
        "power",
    ] {
        assert_eq!(function(&plain, kernel), function(&asked, kernel));
    }
    assert_ne!(function(&plain, "outputs"), function(&asked, "outputs"));
}
