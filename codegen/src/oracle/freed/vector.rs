//! Vectors and matrices of three.

use super::super::measured::Measured;

pub(super) type Vector = [Measured; 3];
/// Rows.
pub(super) type Matrix = [Vector; 3];

pub(super) const ZERO: Vector = [Measured::ZERO; 3];

/// Two or three components; in the plane z is 0.
pub(super) fn filled(components: impl Iterator<Item = Measured>) -> Vector {
    let mut vector = ZERO;
    vector.iter_mut().zip(components).for_each(|(to, from)| *to = from);
    vector
}

pub(super) fn add(a: Vector, b: Vector) -> Vector {
    std::array::from_fn(|i| a[i] + b[i])
}

pub(super) fn subtract(a: Vector, b: Vector) -> Vector {
    std::array::from_fn(|i| a[i] - b[i])
}

pub(super) fn scaled(a: Vector, factor: Measured) -> Vector {
    a.map(|x| factor * x)
}

pub(super) fn inner(a: Vector, b: Vector) -> Measured {
    a[0] * b[0] + a[1] * b[1] + a[2] * b[2]
}

pub(super) fn cross(a: Vector, b: Vector) -> Vector {
    std::array::from_fn(|i| {
        let (j, k) = ((i + 1) % 3, (i + 2) % 3);
        a[j] * b[k] - a[k] * b[j]
    })
}

/// A v.
pub(super) fn times(a: &Matrix, v: Vector) -> Vector {
    a.map(|row| inner(row, v))
}

/// A B'.
pub(super) fn times_transposed(a: &Matrix, b: &Matrix) -> Matrix {
    a.map(|row| b.map(|column| inner(row, column)))
}

/// The vector w whose product w x is the skew part of A.
pub(super) fn of_skew_part(a: &Matrix) -> Vector {
    let half = Measured::given(0.5);
    std::array::from_fn(|i| {
        let (j, k) = ((i + 1) % 3, (i + 2) % 3);
        half * (a[k][j] - a[j][k])
    })
}

/// The largest magnitude of a component.
pub(super) fn magnitude(a: Vector) -> f64 {
    a.iter().fold(0.0, |size, x| size.max(x.magnitude))
}

/// The largest absolute value of a component.
pub(super) fn size(a: Vector) -> f64 {
    a.iter().fold(0.0, |size, x| size.max(x.value.abs()))
}

/// The number of independent rows, by elimination with the largest pivot first.
pub(super) fn rank(mut rows: Vec<Vec<f64>>) -> usize {
    let columns = rows.first().map_or(0, Vec::len);
    let largest = rows.iter().flatten().fold(0.0f64, |size, x| size.max(x.abs()));
    let mut rank = 0;
    for column in 0..columns {
        let size = |i: usize| rows[i][column].abs();
        let Some(pivot) = (rank..rows.len()).max_by(|a, b| size(*a).total_cmp(&size(*b))) else { break };
        if size(pivot) <= 1e-9 * largest {
            continue;
        }
        rows.swap(rank, pivot);
        let (above, below) = rows.split_at_mut(rank + 1);
        let pivot = &above[rank];
        for row in below {
            let factor = row[column] / pivot[column];
            row.iter_mut().zip(pivot).for_each(|(x, p)| *x -= factor * p);
        }
        rank += 1;
    }
    rank
}
