//! Eigenvalues and eigenvectors of a real matrix that need not be symmetric.
//!
//! The matrix is permuted to block triangular form, each diagonal block is balanced, brought to Hessenberg form and from there
//! to the real Schur form by shifted QR; eigenvectors follow by substitution. (Golub and Van Loan, Matrix Computations, 2013,
//! sections 7.4 to 7.6.)
//!
//! Our own, because matrices of linearised motions have cyclic coordinates, hence zero rows and defective zeros, and mix units:
//! nalgebra neither balances nor limits its iterations, and does not return from some of them; faer brings some seventy crates.

mod balance;
mod components;
mod hessenberg;
mod qr;
mod vectors;

use super::power_of_two::power_of_two;
use nalgebra::{Complex, DMatrix};

/// The eigenvalues of a matrix, with an eigenvector of each.
#[derive(Clone, Debug)]
pub struct Eigen {
    /// n of them, repeated by multiplicity; those of a pair are conjugate to the last bit.
    pub values: Vec<Complex<f64>>,
    /// n x n; column k belongs to value k and has length 1. Where a matrix is defective, columns repeat to rounding.
    pub vectors: DMatrix<Complex<f64>>,
}

/// Why a matrix has no eigenvalues here.
#[derive(Clone, Copy, PartialEq, Eq, Debug, thiserror::Error)]
pub enum NoEigenvalues {
    /// It is not square.
    #[error("the matrix is {rows} x {columns}; only a square one has eigenvalues")]
    NotSquare {
        /// Its rows.
        rows: usize,
        /// Its columns.
        columns: usize,
    },
    /// It has an entry that is infinite or NaN.
    #[error("an entry of the matrix is not finite")]
    NotFinite,
    /// The iteration did not end.
    #[error("the QR iteration did not converge: {found} of {size} eigenvalues were found in {sweeps} sweeps")]
    NotConverged {
        /// The number found.
        found: usize,
        /// The total number.
        size: usize,
        /// Sweeps made.
        sweeps: usize,
    },
}

/// A real Schur form under construction: A = Z T Z^-1.
struct Form {
    /// T, n x n.
    t: DMatrix<f64>,
    /// Z, n x n.
    z: DMatrix<f64>,
}

/// The eigenvalues and eigenvectors of a square matrix.
///
/// Eigenvalues are those of a matrix that differs from the balanced one by some n roundings of its norm. The error of a
/// simple eigenvalue is that over |y'x|, with x and y its unit eigenvectors after balancing; the same holds for the
/// mean of those into which a defective one splits.
///
/// # Errors
/// [`NoEigenvalues`].
pub fn eigen(a: &DMatrix<f64>) -> Result<Eigen, NoEigenvalues> {
    let (n, columns) = a.shape();
    if n != columns {
        return Err(NoEigenvalues::NotSquare { rows: n, columns });
    }
    if !a.iter().all(|entry| entry.is_finite()) {
        return Err(NoEigenvalues::NotFinite);
    }
    // Numbers of order 1 have squares that neither overflow nor underflow.
    let unit = power_of_two(a.amax());
    let (order, blocks) = components::block_triangular(a);
    let mut t = DMatrix::from_fn(n, n, |i, j| a[(order[i], order[j])] / unit);
    let scales = balance::balance(&mut t, &blocks);
    let mut form = Form { t, z: DMatrix::identity(n, n) };
    for block in blocks {
        hessenberg::reduce(&mut form, block.clone());
        qr::triangularise(&mut form, block)?;
    }
    let found = vectors::eigenvectors(&form);
    let mut vectors = DMatrix::zeros(n, n);
    for (k, (_, vector)) in found.iter().enumerate() {
        let scaled: Vec<Complex<f64>> = vector.iter().zip(&scales).map(|(entry, scale)| entry * *scale).collect();
        let length = vectors::length(&scaled);
        order.iter().zip(scaled).for_each(|(i, entry)| vectors[(*i, k)] = entry / length);
    }
    Ok(Eigen { values: found.into_iter().map(|(value, _)| value * unit).collect(), vectors })
}
