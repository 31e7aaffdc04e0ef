//! Every tableau meets the order conditions of its order, one for each rooted tree, and no more; so do the estimates and
//! the dense output (Hairer, Norsett, Wanner, Solving Ordinary Differential Equations I, theorem II.2.13).

use super::dop853_tableau::{DENSE_A, DENSE_C, DENSE_D};
use super::{DOP853, DOPRI5, EULER, ErrorEstimate, HEUN, RK3, RK4, Tableau, Weight};

/// A rooted tree: its subtrees, by their place in a list of all trees.
struct Tree {
    nodes: usize,
    subtrees: Vec<usize>,
    /// The weights must give 1/gamma.
    gamma: f64,
}

/// All rooted trees with up to so many nodes.
fn trees(most: usize) -> Vec<Tree> {
    let mut trees = vec![Tree { nodes: 1, subtrees: Vec::new(), gamma: 1.0 }];
    for nodes in 2..=most {
        let mut forests = Vec::new();
        grow(&trees, nodes - 1, 0, &mut Vec::new(), &mut forests);
        for subtrees in forests {
            let gamma = nodes as f64 * subtrees.iter().map(|at| trees[*at].gamma).product::<f64>();
            trees.push(Tree { nodes, subtrees, gamma });
        }
    }
    trees
}

/// All forests of so many nodes whose trees come in the order of the list, from `least` on.
fn grow(trees: &[Tree], nodes: usize, least: usize, forest: &mut Vec<usize>, found: &mut Vec<Vec<usize>>) {
    if nodes == 0 {
        return found.push(forest.clone());
    }
    for at in (least..trees.len()).filter(|at| trees[*at].nodes <= nodes) {
        forest.push(at);
        grow(trees, nodes - trees[at].nodes, at, forest, found);
        forest.pop();
    }
}

/// For each tree its elementary weight at every stage: the product over subtrees of sum of a_ij times theirs.
fn stage_weights(a: &[&[Weight]], trees: &[Tree]) -> Vec<Vec<f64>> {
    let mut weights: Vec<Vec<f64>> = Vec::new();
    for tree in trees {
        let inner = |i: usize, subtree: usize| a[i].iter().map(|(j, a)| a * weights[subtree][*j]).sum::<f64>();
        let at_stage = |i: usize| tree.subtrees.iter().map(|subtree| inner(i, *subtree)).product();
        let row = (0..a.len()).map(at_stage).collect();
        weights.push(row);
    }
    weights
}

/// The largest difference of sum b_i phi_i from `expected`, over trees of so many nodes, relative to the terms.
fn worst(a: &[&[Weight]], b: &[Weight], nodes: usize, expected: impl Fn(&Tree) -> f64) -> f64 {
    let trees = trees(nodes);
    let weights = stage_weights(a, &trees);
    let of_tree = |(tree, weights): (&Tree, &Vec<f64>)| {
        let terms = b.iter().map(|(i, b)| b * weights[*i]);
        let (sum, size) = terms.fold((0.0, 0.0), |(sum, size), term| (sum + term, size + f64::abs(term)));
        (sum - expected(tree)).abs() / f64::max(size, expected(tree))
    };
    trees.iter().zip(&weights).filter(|(tree, _)| tree.nodes == nodes).map(of_tree).fold(0.0, f64::max)
}

const TABLEAUS: [&Tableau; 6] = [&EULER, &HEUN, &RK3, &RK4, &DOPRI5, &DOP853];

/// Coefficients rounded to doubles, through up to seven stages whose sums cancel to a hundredth of their terms.
const ROUNDING: f64 = 1e-12;

#[test]
fn there_are_as_many_trees_as_there_are() {
    let count = |nodes: usize| trees(8).iter().filter(|tree| tree.nodes == nodes).count();
    assert_eq!([1, 2, 3, 4, 5, 6, 7, 8].map(count), [1, 1, 2, 4, 9, 20, 48, 115]);
}

#[test]
fn steps_have_their_order_and_no_more() {
    for tableau in TABLEAUS {
        for nodes in 1..=tableau.order {
            let worst = worst(tableau.a, tableau.b, nodes, |tree| 1.0 / tree.gamma);
            assert!(worst < ROUNDING, "order {}: {nodes} nodes: {worst:e}", tableau.order);
        }
        let next = worst(tableau.a, tableau.b, tableau.order + 1, |tree| 1.0 / tree.gamma);
        assert!(next > 1e-6, "order {}: {next:e}", tableau.order);
        for (row, node) in tableau.a.iter().zip(tableau.c) {
            assert!((row.iter().map(|(_, a)| a).sum::<f64>() - node).abs() < ROUNDING);
        }
    }
}

/// The difference of two methods has weight 0 up to the lower order.
#[test]
fn estimates_have_their_order() {
    let mut rows: Vec<(&Tableau, &[Weight], usize)> = Vec::new();
    for tableau in TABLEAUS {
        match tableau.error {
            ErrorEstimate::None => {}
            ErrorEstimate::Embedded(weights) => rows.push((tableau, weights, 4)),
            ErrorEstimate::Embedded53(fifth, third) => rows.extend([(tableau, fifth, 5), (tableau, third, 3)]),
        }
    }
    assert_eq!(rows.len(), 3);
    for (tableau, weights, order) in rows {
        for nodes in 1..=order {
            let worst = worst(tableau.a, weights, nodes, |_| 0.0);
            assert!(worst < ROUNDING, "order {order}: {nodes} nodes: {worst:e}");
        }
        assert!(worst(tableau.a, weights, order + 1, |_| 0.0) > 1e-6, "order {order}");
    }
}

/// Weights of the stages at a fraction s of the step: sum b_i(s) phi_i = s^nodes / gamma up to order 7.
#[test]
fn dense_output_of_dop853_has_order_seven() {
    let a: Vec<&[Weight]> = DOP853.a.iter().copied().chain([DOP853.b]).chain(DENSE_A).collect();
    for (row, node) in DENSE_A.iter().zip(DENSE_C) {
        assert!((row.iter().map(|(_, a)| a).sum::<f64>() - node).abs() < ROUNDING);
    }
    for s in [0.1, 0.37, 0.5, 0.9] {
        let weights = dense_weights(s);
        for nodes in 1..=7 {
            let worst = worst(&a, &weights, nodes, |tree| f64::powi(s, nodes as i32) / tree.gamma);
            assert!(worst < 10.0 * ROUNDING, "{nodes} nodes at {s}: {worst:e}");
        }
        assert!(worst(&a, &weights, 8, |tree| s.powi(8) / tree.gamma) > 1e-9);
    }
}

/// The stages of DOPRI5 include the end, so its dense output needs no more. It has order 4, and at both ends that of the step.
#[test]
fn dense_output_of_dopri5_has_order_four() {
    for s in [0.1, 0.37, 0.5, 0.9] {
        let weights = dense_weights_of_dopri5(s);
        for nodes in 1..=4 {
            let worst = worst(DOPRI5.a, &weights, nodes, |tree| f64::powi(s, nodes as i32) / tree.gamma);
            assert!(worst < ROUNDING, "{nodes} nodes at {s}: {worst:e}");
        }
        assert!(worst(DOPRI5.a, &weights, 5, |tree| s.powi(5) / tree.gamma) > 1e-6);
    }
}

/// s (d + r (e + s (f + r D))), with d = h sum b_i k_i, e = h k_1 - d and f = d - h k_7 - e.
fn dense_weights_of_dopri5(s: f64) -> Vec<Weight> {
    let r = 1.0 - s;
    let [mut d, mut last] = [[0.0; 7]; 2];
    DOPRI5.b.iter().for_each(|(stage, weight)| d[*stage] += weight);
    DOPRI5.dense.iter().for_each(|(stage, weight)| last[*stage] += weight);
    let unit = |i: usize, stage: usize| f64::from(u8::from(i == stage));
    let e = |i: usize| unit(i, 0) - d[i];
    let f = |i: usize| d[i] - unit(i, 6) - e(i);
    (0..7).map(|i| (i, s * (d[i] + r * (e(i) + s * (f(i) + r * last[i]))))).collect()
}

/// y(s) - y = s (d + r (e + s (f + r (D4 + s (D5 + r (D6 + s D7)))))), r = 1 - s, with d = h sum b_i k_i, e = h k_1 - d and
/// f = d - h k_13 - e.
fn dense_weights(s: f64) -> Vec<Weight> {
    let r = 1.0 - s;
    let dense = |weights: &[Weight]| {
        let mut row = [0.0; 16];
        weights.iter().for_each(|(stage, weight)| row[*stage] += weight);
        row
    };
    let d = dense(DOP853.b);
    let e: [f64; 16] = std::array::from_fn(|i| f64::from(u8::from(i == 0)) - d[i]);
    let f: [f64; 16] = std::array::from_fn(|i| d[i] - f64::from(u8::from(i == 12)) - e[i]);
    let [d4, d5, d6, d7] = DENSE_D.map(dense);
    let at = |i: usize| s * (d[i] + r * (e[i] + s * (f[i] + r * (d4[i] + s * (d5[i] + r * (d6[i] + s * d7[i]))))));
    (0..16).map(|i| (i, at(i))).collect()
}
