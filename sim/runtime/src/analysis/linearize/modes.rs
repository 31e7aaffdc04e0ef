//! Eigenvalues and modes.

use crate::numerics::eigen::{NoEigenvalues, eigen};
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
/// Accelerations this small beside the terms that they are a sum of are rounding: they come of a mass matrix that is solved with.
const ROUNDING: f64 = 1e-12;

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
/// The first so many of its unknowns are positions, the others speeds; `positions` makes the changes of all coordinates of an
/// eigenvector.
pub(super) fn modes(
    a: &DMatrix<f64>,
    independent: usize,
    positions: impl Fn(&DVector<Complex<f64>>) -> DVector<Complex<f64>>,
) -> Result<(Vec<Complex<f64>>, Vec<Mode>), NoEigenvalues> {
    let found = eigen(a)?;
    let mut order: Vec<usize> = (0..found.values.len()).collect();
    order.sort_by(|i, j| {
        let (a, b) = (found.values[*i], found.values[*j]);
        a.im.abs().total_cmp(&b.im.abs()).then(a.im.total_cmp(&b.im)).then(a.re.total_cmp(&b.re))
    });
    let largest = found.values.iter().map(|value| value.norm()).fold(0.0, f64::max);
    let mode = |k: &usize| {
        let (eigenvalue, vector): (_, DVector<_>) = (found.values[*k], found.vectors.column(*k).into());
        let is_neutral = eigenvalue.norm() <= LEAST * largest || is_neutral(a, independent, eigenvalue, &vector);
        Mode { eigenvalue, shape: normalised(positions(&vector)), is_neutral }
    };
    let shown = order.iter().filter(|k| found.values[**k].im >= 0.0);
    Ok((order.iter().map(|k| found.values[*k]).collect(), shown.map(mode).collect()))
}

/// Whether the accelerations of an eigenvector and the forces upon its displacement are both rounding. A double eigenvalue 0, which
/// belongs to a body that nothing holds, is found with an error of the root of the rounding of A.
fn is_neutral(a: &DMatrix<f64>, independent: usize, value: Complex<f64>, vector: &DVector<Complex<f64>>) -> bool {
    let is_rounding = |row: usize| {
        let terms = (0..independent).map(|j| vector[j] * a[(row, j)]);
        let (sum, size) =
            terms.fold((Complex::new(0.0, 0.0), 0.0), |(sum, size), term| (sum + term, size + term.norm()));
        sum.norm().max((value * vector[row]).norm()) <= ROUNDING * size
    };
    let acts = |row: &usize| a.row(*row).iter().any(|entry| *entry != 0.0);
    value.norm() == 0.0 || (independent..a.nrows()).filter(acts).all(is_rounding)
}

/// The largest entry 1.
fn normalised(shape: DVector<Complex<f64>>) -> Vec<Complex<f64>> {
    let largest = shape.iter().copied().fold(Complex::new(0.0, 0.0), |a, b| if b.norm() > a.norm() { b } else { a });
    shape.iter().map(|entry| if largest.norm() == 0.0 { *entry } else { entry / largest }).collect()
}
