//! Eigenvalues and modes.

use nalgebra::{Complex, DMatrix, DVector};

/// Eigenvalues this close, as a part of the largest, are one.
const EQUAL: f64 = 1e-7;

/// A small motion that keeps its shape: dq = Re(shape e^(eigenvalue t)).
#[derive(Clone, Debug)]
pub struct Mode {
    /// The eigenvalue, in 1/s; the one with positive imaginary part of a pair.
    pub eigenvalue: Complex<f64>,
    /// The change of each coordinate, the largest being 1; in SI units.
    pub shape: Vec<Complex<f64>>,
}

impl Mode {
    /// The frequency of the motion in Hz: |Im| / 2 pi; 0 if it does not oscillate.
    pub fn frequency(&self) -> f64 {
        self.eigenvalue.im.abs() / std::f64::consts::TAU
    }

    /// -Re / |eigenvalue|: 0 undamped, 1 from critical damping on, negative where it grows.
    pub fn damping_ratio(&self) -> f64 {
        let size = self.eigenvalue.norm();
        if size == 0.0 { 0.0 } else { -self.eigenvalue.re / size }
    }
}

/// The eigenvalues of a matrix, by imaginary part.
pub(super) fn eigenvalues(a: &DMatrix<f64>) -> Vec<Complex<f64>> {
    if a.is_empty() {
        return Vec::new();
    }
    let mut eigenvalues: Vec<Complex<f64>> = a.complex_eigenvalues().iter().copied().collect();
    eigenvalues
        .sort_by(|a, b| a.im.abs().total_cmp(&b.im.abs()).then(a.im.total_cmp(&b.im)).then(a.re.total_cmp(&b.re)));
    eigenvalues
}

/// The modes of a matrix with these eigenvalues; `positions` makes the changes of all coordinates of an eigenvector.
pub(super) fn modes(
    a: &DMatrix<f64>,
    eigenvalues: &[Complex<f64>],
    positions: impl Fn(&DVector<Complex<f64>>) -> DVector<Complex<f64>>,
) -> Vec<Mode> {
    let largest = eigenvalues.iter().map(|value| value.norm()).fold(0.0, f64::max);
    let shown: Vec<Complex<f64>> = eigenvalues.iter().filter(|value| value.im >= 0.0).copied().collect();
    let mut modes = Vec::new();
    for (i, eigenvalue) in shown.iter().enumerate() {
        let same = |other: &&Complex<f64>| (*other - eigenvalue).norm() <= EQUAL * largest;
        let copy = shown[..i].iter().filter(same).count();
        let shape = positions(&null_vector(a, *eigenvalue, copy));
        modes.push(Mode { eigenvalue: *eigenvalue, shape: normalised(shape) });
    }
    modes
}

/// The vector that A - lambda I takes nearest to zero; of several, one after the other.
fn null_vector(a: &DMatrix<f64>, eigenvalue: Complex<f64>, copy: usize) -> DVector<Complex<f64>> {
    let n = a.nrows();
    let shifted = a.map(|entry| Complex::new(entry, 0.0)) - DMatrix::from_diagonal_element(n, n, eigenvalue);
    let svd = shifted.svd(false, true);
    let mut order: Vec<usize> = (0..n).collect();
    order.sort_by(|i, j| svd.singular_values[*i].total_cmp(&svd.singular_values[*j]));
    match svd.v_t {
        Some(v_t) => v_t.row(order[copy.min(n - 1)]).adjoint(),
        None => DVector::zeros(n),
    }
}

/// The largest entry 1.
fn normalised(shape: DVector<Complex<f64>>) -> Vec<Complex<f64>> {
    let largest = shape.iter().copied().fold(Complex::new(0.0, 0.0), |a, b| if b.norm() > a.norm() { b } else { a });
    shape.iter().map(|entry| if largest.norm() == 0.0 { *entry } else { entry / largest }).collect()
}
