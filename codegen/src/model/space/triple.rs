//! Triples and 3 x 3 matrices of expressions.

use crate::symbolic::{Expr, Graph};

/// Three components.
pub(crate) type Triple = [Expr; 3];
/// Three rows.
pub(crate) type Matrix = [Triple; 3];

pub(crate) fn zero(graph: &mut Graph) -> Triple {
    [graph.zero(); 3]
}

pub(crate) fn identity(graph: &mut Graph) -> Matrix {
    let (one, zero) = (graph.one(), graph.zero());
    [[one, zero, zero], [zero, one, zero], [zero, zero, one]]
}

pub(crate) fn is_zero(graph: &Graph, a: &Triple) -> bool {
    a.iter().all(|x| graph.is_zero(*x))
}

pub(crate) fn add(graph: &mut Graph, a: Triple, b: Triple) -> Triple {
    std::array::from_fn(|i| graph.add(a[i], b[i]))
}

pub(crate) fn sub(graph: &mut Graph, a: Triple, b: Triple) -> Triple {
    std::array::from_fn(|i| graph.sub(a[i], b[i]))
}

pub(crate) fn negate(graph: &mut Graph, a: Triple) -> Triple {
    a.map(|x| graph.neg(x))
}

pub(crate) fn scaled(graph: &mut Graph, factor: Expr, a: Triple) -> Triple {
    a.map(|x| graph.mul(factor, x))
}

pub(crate) fn inner(graph: &mut Graph, a: &Triple, b: &Triple) -> Expr {
    let products: Vec<Expr> = a.iter().zip(b).map(|(x, y)| graph.mul(*x, *y)).collect();
    graph.sum(&products)
}

pub(crate) fn cross(graph: &mut Graph, a: &Triple, b: &Triple) -> Triple {
    std::array::from_fn(|i| {
        let (j, k) = ((i + 1) % 3, (i + 2) % 3);
        let (ahead, back) = (graph.mul(a[j], b[k]), graph.mul(a[k], b[j]));
        graph.sub(ahead, back)
    })
}

/// A v.
pub(crate) fn apply(graph: &mut Graph, a: &Matrix, v: &Triple) -> Triple {
    a.map(|row| inner(graph, &row, v))
}

pub(crate) fn transposed(a: &Matrix) -> Matrix {
    std::array::from_fn(|i| std::array::from_fn(|j| a[j][i]))
}

/// A B.
pub(crate) fn product(graph: &mut Graph, a: &Matrix, b: &Matrix) -> Matrix {
    let columns = transposed(b);
    a.map(|row| columns.map(|column| inner(graph, &row, &column)))
}
