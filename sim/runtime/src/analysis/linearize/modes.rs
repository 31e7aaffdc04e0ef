//! Eigenvalues and modes.

use crate::numerics::eigen::{Eigen, NoEigenvalues, eigen};
use nalgebra::{Complex, DMatrix, DVector};

/// A small motion that keeps its shape: dq = Re(shape e^(eigenvalue t)).
#[derive(Clone, Debug)]
pub struct Mode {
    /// The eigenvalue, in 1/s; the one with positive imaginary part of a pair.
    pub eigenvalue: Complex<f64>,
    /// The change of each coordinate, the largest being 1; in SI units.
    pub shape: Vec<Complex<f64>>,
    /// Whether the eigenvalue is 0 but for rounding: nothing brings the motion back or drives it away, and it stays where it is or
    /// goes on at its speed.
    pub is_neutral: bool,
}

/// An eigenvalue this small beside the largest is rounding.
const LEAST: f64 = 64.0 * f64::EPSILON;
/// The rounding of an entry of A, as a part of it: accelerations come of a mass matrix that is solved with.
const ROUNDING: f64 = 1e-12;
/// The least |y'x| that counts, beside the products of its terms: that of three equal eigenvalues with one eigenvector, which are known
/// to the cube root of rounding.
const DEFECTIVE: f64 = 1e-8;

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

/// The eigenvalues of a matrix, by imaginary part, and its modes: one for each pair of conjugate eigenvalues and each real one.
/// `positions` makes the changes of all coordinates of an eigenvector.
pub(super) fn modes(
    a: &DMatrix<f64>,
    positions: impl Fn(&DVector<Complex<f64>>) -> DVector<Complex<f64>>,
) -> Result<(Vec<Complex<f64>>, Vec<Mode>), NoEigenvalues> {
    let (found, left) = (eigen(a)?, eigen(&a.transpose())?);
    let mut order: Vec<usize> = (0..found.values.len()).collect();
    order.sort_by(|i, j| {
        let (a, b) = (found.values[*i], found.values[*j]);
        a.im.abs().total_cmp(&b.im.abs()).then(a.im.total_cmp(&b.im)).then(a.re.total_cmp(&b.re))
    });
    let largest = found.values.iter().map(|value| value.norm()).fold(0.0, f64::max);
    let mode = |k: &usize| {
        let (eigenvalue, vector): (_, DVector<_>) = (found.values[*k], found.vectors.column(*k).into());
        let is_neutral = eigenvalue.norm() <= LEAST * largest || is_rounding(a, &left, eigenvalue, &vector);
        Mode { eigenvalue, shape: normalised(positions(&vector)), is_neutral }
    };
    let shown = order.iter().filter(|k| found.values[**k].im >= 0.0);
    Ok((order.iter().map(|k| found.values[*k]).collect(), shown.map(mode).collect()))
}

/// Whether the rounding of the entries of A makes an eigenvalue of 0: by |y|'|A||x| / |y'x|, with the left eigenvector y (Golub and Van
/// Loan, Matrix Computations, 2013, section 7.2.2, with the rounding of each entry in place of that of the norm). A double eigenvalue 0,
/// which belongs to a body that nothing holds, is found with an error of the root of the rounding, and then y'x is as small.
fn is_rounding(a: &DMatrix<f64>, left: &Eigen, value: Complex<f64>, x: &DVector<Complex<f64>>) -> bool {
    let sum = |term: &dyn Fn(usize) -> f64| (0..x.len()).map(term).sum::<f64>();
    // Left eigenvectors of other eigenvalues are orthogonal to x; of equal ones, one is not.
    let products = |k: usize| {
        let y = left.vectors.column(k);
        let terms = sum(&|i| y[i].norm() * x[i].norm());
        if terms > 0.0 { [y.dot(x).norm() / terms, terms] } else { [0.0; 2] }
    };
    let all = (0..left.values.len()).map(|k| (k, products(k)));
    let Some((k, [part, terms])) = all.max_by(|(_, a), (_, b)| a[0].total_cmp(&b[0])) else { return false };
    let y = left.vectors.column(k);
    let change = sum(&|i| y[i].norm() * sum(&|j| a[(i, j)].abs() * x[j].norm()));
    value.norm() * part.max(DEFECTIVE) * terms < ROUNDING * change
}

/// The largest entry 1.
fn normalised(shape: DVector<Complex<f64>>) -> Vec<Complex<f64>> {
    let largest = shape.iter().copied().fold(Complex::new(0.0, 0.0), |a, b| if b.norm() > a.norm() { b } else { a });
    shape.iter().map(|entry| if largest.norm() == 0.0 { *entry } else { entry / largest }).collect()
}
