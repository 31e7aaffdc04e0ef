//! Axes of joints: by name or in place, and the pose from which joint coordinates count.

#![allow(missing_docs, clippy::unwrap_used)]

use codegen::notation::Notation;
use codegen::symbolic::evaluate;

fn arm(lets: &str, joint: &str) -> String {
    format!(
        "pub Arm; parameters {{ alpha [rad] = 0.3; m [kg] = 1; J [kg*m^2] = 0.1; }} {lets}
        bodies {{ link: mass m, inertia [J, 2*J, 2.5*J]; }}
        joints {{ hip: {joint}; }}
        loads {{ gravity [0, 0, -9.81 [m/s^2]]; }}
        initial {{ }}"
    )
}

fn equations(text: &str) -> Vec<String> {
    let parts = codegen::equations_as(Notation::Infix, text).unwrap();
    parts.into_iter().map(|part| part.text).collect()
}

#[test]
fn an_axis_by_name_is_the_axis_in_place() {
    for (lets, named, in_place) in [
        ("let s = [0.6, 0, 0.8];", "s", "[0.6, 0, 0.8]"),
        ("let s = [0.6, 0, 0.8]; let u = s;", "-u", "[-0.6, 0, -0.8]"),
        ("let s = [0, sin(alpha), cos(alpha)];", "s", "[0, sin(alpha), cos(alpha)]"),
        ("let h = 3/5; let k = -h;", "[h, 0, 4/5]", "[0.6, 0, 0.8]"),
    ] {
        let joint =
            |axis: &str| format!("revolute ground at [0, 0, 0] axis {axis} to link at [0, 0, 0.2 [m]] axis [0, 0, 1]");
        assert_eq!(equations(&arm(lets, &joint(named))), equations(&arm(lets, &joint(in_place))), "{lets}");
    }
}

#[test]
fn what_is_no_axis_is_said_at_its_name() {
    let joint = |axis: &str| format!("revolute ground at [0, 0, 0] axis {axis} to link at [0, 0, 0.2 [m]]");
    for (lets, axis) in [("", "s"), ("let s = 2;", "s"), ("let s = [alpha, alpha, 1];", "s"), ("let s = s;", "s")] {
        let text = arm(lets, &joint(axis));
        let mistakes: Vec<_> =
            codegen::generate(text.parse().unwrap(), &quote::quote!(k)).unwrap_err().into_iter().collect();
        let first = mistakes[0].span().start();
        let word = text.lines().nth(first.line - 1).unwrap()[first.column..].chars().next();
        assert!(mistakes[0].to_string().contains("or as the name of such a vector"), "{lets}: {}", mistakes[0]);
        assert_eq!(word, Some('s'), "{lets}");
    }
}

/// The attitude of the link where all coordinates are 0, by rows.
fn upright(joint: &str) -> [[f64; 3]; 3] {
    let equations = codegen::equations(arm("", joint).parse().unwrap()).unwrap();
    let matrix = equations.model.bodies[0].attitude.as_ref().unwrap().matrix;
    let parameter = |symbol| equations.model.parameters.iter().any(|p| p.symbol == symbol);
    matrix.map(|row| {
        let values = evaluate(&equations.graph, &row, |symbol| if parameter(symbol) { 0.3 } else { 0.0 });
        [values[0], values[1], values[2]]
    })
}

#[test]
fn crossed_axes_leave_the_frames_aligned() {
    for (n, m) in [
        ("[1, 0, 0]", "[0, 1, 0]"),
        ("[0, 1, 0]", "[1, 0, 0]"),
        ("[0, 0, 1]", "[1, 0, 0]"),
        ("[1, 0, 0]", "[0, 0, -2]"),
        ("[0.6, 0, 0.8]", "[0.8, 0, -0.6]"),
        ("[1, 1, 1]", "[1, -1, 0]"),
    ] {
        for joint in [
            format!("universal ground at [0, 0, 0] axis {n} to link at [0, 0, 0] axis {m}"),
            format!("universal link at [0, 0, 0] axis {n} to ground at [0, 0, 0] axis {m}"),
        ] {
            for (i, row) in upright(&joint).iter().enumerate() {
                for (j, entry) in row.iter().enumerate() {
                    // Roots of 2 and 3 are rounded.
                    assert!((entry - f64::from(u8::from(i == j))).abs() < 1e-15, "{joint}: {entry} at {i}, {j}");
                }
            }
        }
    }
}

#[test]
fn other_axes_align_their_marks() {
    // Of z and z: m, t1 and t2 of the second, z, x and y, lie along t1, t2 and n of the first, x, y and z.
    let turned = upright("universal ground at [0, 0, 0] axis [0, 0, 1] to link at [0, 0, 0] axis [0, 0, 1]");
    assert_eq!(turned, [[0.0, 0.0, 1.0], [1.0, 0.0, 0.0], [0.0, 1.0, 0.0]]);
}
