//! Block triangular form, by an order of rows and columns that decouples as much as possible.

use nalgebra::DMatrix;
use std::cmp::Reverse;
use std::ops::Range;

/// An order of rows and columns in which a matrix is block upper triangular, and its diagonal blocks. The blocks cannot
/// be decoupled further: they are the strongly connected components of the graph with an edge from i to j where entry
/// ij is not zero.
///
/// Zero rows and columns, and variables that only follow from others, as a position from its speed, become blocks of
/// size 1 with exact eigenvalues.
pub(super) fn block_triangular(a: &DMatrix<f64>) -> (Vec<usize>, Vec<Range<usize>>) {
    let n = a.nrows();
    let reached = reached(a);
    let first = |i: usize| (0..n).find(|j| *j == i || reached[i][*j] && reached[*j][i]).unwrap_or(i);
    // Nodes that lead to a component reach more nodes than its members, which all reach the same.
    let count = |i: usize| reached[i].iter().filter(|reached| **reached).count();
    let keys: Vec<(Reverse<usize>, usize)> = (0..n).map(|i| (Reverse(count(i)), first(i))).collect();
    let mut order: Vec<usize> = (0..n).collect();
    order.sort_by_key(|i| keys[*i]);
    let mut blocks: Vec<Range<usize>> = Vec::new();
    for (at, i) in order.iter().enumerate() {
        match blocks.last_mut() {
            Some(block) if keys[order[block.start]] == keys[*i] => block.end = at + 1,
            _ => blocks.push(at..at + 1),
        }
    }
    (order, blocks)
}

/// Which j can be reached from each i, including i itself. (Warshall, Journal of the ACM 9, 1962.)
fn reached(a: &DMatrix<f64>) -> Vec<Vec<bool>> {
    let n = a.nrows();
    let mut reached: Vec<Vec<bool>> = (0..n).map(|i| (0..n).map(|j| i == j || a[(i, j)] != 0.0).collect()).collect();
    for by in 0..n {
        let through = reached[by].clone();
        for row in reached.iter_mut().filter(|row| row[by]) {
            row.iter_mut().zip(&through).for_each(|(reached, further)| *reached |= further);
        }
    }
    reached
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn chains_fall_apart_and_cycles_stay_together() {
        // 0 -> 2 -> 1 -> 2, 3 alone.
        let mut a = DMatrix::zeros(4, 4);
        [(0, 2), (2, 1), (1, 2)].into_iter().for_each(|at| a[at] = 1.0);
        let (order, blocks) = block_triangular(&a);
        assert_eq!((order, blocks), (vec![0, 1, 2, 3], vec![0..1, 1..3, 3..4]));
    }
    /// They reach equally many nodes, but not each other.
    #[test]
    fn cycles_of_one_length_stay_apart() {
        // 0 <-> 2 and 1 <-> 3.
        let mut a = DMatrix::zeros(4, 4);
        [(0, 2), (2, 0), (1, 3), (3, 1)].into_iter().for_each(|at| a[at] = 1.0);
        let (order, blocks) = block_triangular(&a);
        assert_eq!((order, blocks), (vec![0, 2, 1, 3], vec![0..2, 2..4]));
    }
}
