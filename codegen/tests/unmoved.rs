//! Rows of joints that no coordinate moves: they are redundant, also where that does not show in symbols.

#![allow(missing_docs, clippy::unwrap_used)]

/// Two shafts in hinges of the ground, at an angle, and a universal joint that closes the loop.
fn cardan(first_at: &str, second_at: &str, cross: &str) -> String {
    format!(
        "pub Cardan; parameters {{ beta [deg] = 30; J [kg*m^2] = 0.02; l [m] = 0.3; k [m] = 0.2; }}
        bodies {{ first: mass 1 [kg], inertia [J, J, J]; second: mass 1 [kg], inertia [J, J, J]; }}
        joints {{
            a: revolute ground at {first_at} axis [1, 0, 0] to first at [0, 0, 0] axis [1, 0, 0];
            b: revolute ground at {second_at} axis [cos(beta), sin(beta), 0] to second at [0, 0, 0] axis [1, 0, 0];
            cross: universal {cross};
        }}
        initial {{ a = 0; guess b = 0; }}
        outputs {{ force [N] = norm(reaction(cross)); moment [N*m] = reaction(cross_m); }}"
    )
}

/// Of each row whether it is 0, and whether a coordinate moves it.
fn rows(text: &str) -> Vec<(bool, bool)> {
    let equations = codegen::equations(text.parse().unwrap()).unwrap();
    let (graph, constraints) = (&equations.graph, &equations.constraints);
    let rows = constraints.values.iter().zip(&constraints.jacobian);
    rows.map(|(value, by)| (graph.is_zero(*value), by.iter().any(|entry| !graph.is_zero(*entry)))).collect()
}

#[test]
fn rows_that_hold_always_are_zero() {
    let always = [(true, false), (true, false), (true, false), (false, true)];
    let at_the_centre = "first at [0, 0, 0] axis [0, 0, 1] to second at [0, 0, 0] axis [0, 1, 0]";
    assert_eq!(rows(&cardan("[0, 0, 0]", "[0, 0, 0]", at_the_centre)), always);
    // The points lie on the axes, which shows by l cos(beta)(cos(beta)^2 + sin(beta)^2 ..) alone.
    let apart = "first at [l, 0, 0] axis [0, 0, 1] to second at [-l, 0, 0] axis [0, 1, 0]";
    assert_eq!(rows(&cardan("[-l, 0, 0]", "[l*cos(beta), l*sin(beta), 0]", apart)), always);
}

#[test]
fn rows_that_parameters_alone_can_close_stay() {
    let open = "first at [l, 0, 0] axis [0, 0, 1] to second at [-k, 0, 0] axis [0, 1, 0]";
    let rows = rows(&cardan("[-l, 0, 0]", "[l*cos(beta), l*sin(beta), 0]", open));
    assert_eq!(rows, [(false, false), (false, false), (true, false), (false, true)]);
}

#[test]
fn rows_that_something_moves_stay_as_they_are() {
    // The second point is beside its axis by so little that it is nearly rounding.
    let beside = "first at [l, 0, 0] axis [0, 0, 1] to second at [-l, 1e-9*l, 0] axis [0, 1, 0]";
    let rows = rows(&cardan("[-l, 0, 0]", "[l*cos(beta), l*sin(beta), 0]", beside));
    assert!(rows.iter().all(|(is_zero, is_moved)| !is_zero && *is_moved), "{rows:?}");
}

/// Far from rounding, beside products on the way that are 1e12 times as large and are scaled down before they count.
#[test]
fn rows_with_large_numbers_on_the_way_stay_as_they_are() {
    let text = "pub Tied; parameters { p = 0.833; }
        bodies { loose: free, mass 0.9, inertia [0.458, 0.526, 0.559]; }
        bodies { upper: mass 1.1, inertia [0.474, 0.608, 0.684]; lower: mass 1.1, inertia [0.710, 0.714, 0.809]; }
        joints {
            hinge: universal ground at [-0.52, 0, 0] axis [0, -1, 0] to upper at [0.24, 0, 0] axis [0.48, -0.6, 0.64];
            screw: screw upper at [0, -0.29, -0.30] axis [0, 0, 1] to lower at [-0.04, p/4, -0.53] axis [0.48, -0.6, 0.64] pitch 0.1;
            tie: link on(loose, [0, p/4, 0.03]) to on(lower, [-0.25, 0, 0]) + [9, 7, 0], length 5;
        }
        loads { gravity [0, 0, -9.81]; }";
    let rows = rows(text);
    assert!(rows.iter().all(|(is_zero, is_moved)| !is_zero && *is_moved), "{rows:?}");
}
