//! Triples and 3 x 3 matrices of expressions.

use crate::symbolic::{Expr, Graph};

/// Three components.
pub(in crate::model) type Triple = [Expr; 3];
/// Three rows.
pub(in crate::model) type Matrix = [Triple; 3];

pub(in crate::model) fn zero(graph: &mut Graph) -> Triple {
    [graph.zero(); 3]
}

pub(in crate::model) fn identity(graph: &mut Graph) -> Matrix {
    let (one, zero) = (graph.one(), graph.zero());
    [[one, zero, zero], [zero, one, zero], [zero, zero, one]]
}

pub(in crate::model) fn is_zero(graph: &Graph, a: &Triple) -> bool {
    a.iter().all(|x| graph.is_zero(*x))
}

pub(in crate::model) fn add(graph: &mut Graph, a: Triple, b: Triple) -> Triple {
    std::array::from_fn(|i| graph.add(a[i], b[i]))
}

pub(in crate::model) fn sub(graph: &mut Graph, a: Triple, b: Triple) -> Triple {
    std::array::from_fn(|i| graph.sub(a[i], b[i]))
}

pub(in crate::model) fn negate(graph: &mut Graph, a: Triple) -> Triple {
    a.map(|x| graph.neg(x))
}

pub(in crate::model) fn scaled(graph: &mut Graph, factor: Expr, a: Triple) -> Triple {
    a.map(|x| graph.mul(factor, x))
}

pub(in crate::model) fn inner(graph: &mut Graph, a: &Triple, b: &Triple) -> Expr {
    let products: Vec<Expr> = a.iter().zip(b).map(|(x, y)| graph.mul(*x, *y)).collect();
    graph.sum(&products)
}

pub(in crate::model) fn cross(graph: &mut Graph, a: &Triple, b: &Triple) -> Triple {
    std::array::from_fn(|i| {
        let (j, k) = ((i + 1) % 3, (i + 2) % 3);
        let (ahead, back) = (graph.mul(a[j], b[k]), graph.mul(a[k], b[j]));
        graph.sub(ahead, back)
    })
}

/// A v.
pub(in crate::model) fn apply(graph: &mut Graph, a: &Matrix, v: &Triple) -> Triple {
    a.map(|row| inner(graph, &row, v))
}

pub(in crate::model) fn transposed(a: &Matrix) -> Matrix {
    std::array::from_fn(|i| std::array::from_fn(|j| a[j][i]))
}

/// A B.
pub(in crate::model) fn product(graph: &mut Graph, a: &Matrix, b: &Matrix) -> Matrix {
    let columns = transposed(b);
    a.map(|row| columns.map(|column| inner(graph, &row, &column)))
}
