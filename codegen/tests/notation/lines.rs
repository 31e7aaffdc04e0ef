//! Lines that a page holds.

use codegen::notation::{Notation, equations};

#[test]
fn long_sums_are_broken() {
    for model in super::every_model() {
        let parts = equations(&model, Notation::Infix);
        for line in parts.iter().filter(|part| part.name != "system").flat_map(|part| part.text.lines()) {
            // One term may be wider than what is aimed at, and so may a row of a matrix.
            assert!(line.chars().count() <= 160, "{line}");
        }
    }
}

/// A chain's sub-expressions are shared over and over: as a tree, its equations grow without bound.
#[test]
fn text_grows_with_the_graph_and_not_with_the_tree() {
    let length = |n: usize| {
        let parts = codegen::equations_as(Notation::Infix, &chain(n)).unwrap();
        parts.iter().map(|part| part.text.len()).sum::<usize>()
    };
    let [five, ten] = [length(5), length(10)];
    println!("{five} and {ten} letters");
    // n^2 entries of up to n terms.
    assert!(ten < 10 * five, "{five} {ten}");
}

/// n rods in relative angles.
fn chain(n: usize) -> String {
    let coordinates: String = (1..=n).map(|i| format!("a{i}; ")).collect();
    let mut text = format!("Chain; coordinates {{ {coordinates} }} let P0 = [0, 0]; let p0 = 0;");
    let mut bodies = String::new();
    for i in 1..=n {
        let j = i - 1;
        text += &format!("let p{i} = p{j} + a{i}; let P{i} = P{j} + [sin(p{i}), -cos(p{i})];");
        bodies += &format!("rod{i}: mass 1 at (P{i} + P{j})/2, inertia 1/12, angle p{i};");
    }
    format!("{text} bodies {{ {bodies} }} loads {{ gravity [0, -9.81]; }}")
}
