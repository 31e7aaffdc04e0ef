//! The magnitudes of products with rotations, by norms.
//!
//! Entry by entry, |A||B| of two rotations is up to sqrt(3) in each row, and along a chain of joints the magnitudes
//! would grow like a power, until no difference in a kernel showed. But a rotation keeps lengths: errors dA in A and
//! dB in B make the error dA B + A dB in A B, of size |dA| |B| + |A| |dB| (Higham, Accuracy and Stability of Numerical
//! Algorithms, 2nd ed., 3.5 and 19.2). So the magnitudes of a chain grow like the number of its joints.

use super::jet::Jet;
use super::measured::Measured;
use std::ops::Add;

/// The size of a matrix or vector, and the size of its errors in units of rounding.
///
/// Rows and columns stand for the 2-norm, and the largest magnitude of an entry for the norm of the errors: each is
/// right within a factor of 3.
#[derive(Clone, Copy, Default)]
pub(super) struct Size {
    value: f64,
    magnitude: f64,
}

impl Size {
    /// Of a 3 by 3 matrix row by row, or of a vector.
    fn of(entries: &[Measured]) -> Size {
        let columns = entries.len() / 3;
        let rows = entries.chunks(columns.max(1)).map(|row| length(row.iter()));
        let lines = rows.chain((0..columns).map(|j| length(entries.iter().skip(j).step_by(columns))));
        Size { value: lines.fold(0.0, f64::max), magnitude: entries.iter().map(|x| x.magnitude).fold(0.0, f64::max) }
    }

    fn times(self, other: Size) -> Size {
        let magnitude = self.magnitude * other.value + self.value * other.magnitude;
        Size { value: self.value * other.value, magnitude }
    }
}

fn length<'a>(line: impl Iterator<Item = &'a Measured>) -> f64 {
    line.map(|x| x.value * x.value).sum::<f64>().sqrt()
}

impl Add for Size {
    type Output = Size;
    fn add(self, other: Size) -> Size {
        Size { value: self.value + other.value, magnitude: self.magnitude + other.magnitude }
    }
}

/// The sizes of a matrix or vector of jets and of its derivatives: as a [`Jet`].
pub(super) struct Sizes {
    value: Size,
    gradient: Vec<Size>,
    hessian: Vec<Size>,
}

impl Sizes {
    /// Of a 3 by 3 matrix row by row, or of a vector of three components.
    pub(super) fn of(entries: &[Jet]) -> Sizes {
        let each = |count: usize, of: &dyn Fn(&Jet, usize) -> Measured| {
            (0..count).map(|k| Size::of(&entries.iter().map(|x| of(x, k)).collect::<Vec<_>>())).collect()
        };
        let variables = entries.first().map_or(0, |x| x.gradient().len());
        Sizes {
            value: Size::of(&entries.iter().map(Jet::value).collect::<Vec<_>>()),
            gradient: each(variables, &|x, k| x.gradient()[k]),
            hessian: each(variables * variables, &|x, k| x.hessian()[k]),
        }
    }

    /// Of the product A B, by the product rule.
    pub(super) fn times(&self, other: &Sizes) -> Sizes {
        let (a, b, variables) = (self, other, self.gradient.len());
        let first = |k: usize| a.gradient[k].times(b.value) + a.value.times(b.gradient[k]);
        let second = |at: usize| {
            let (i, j) = (at / variables, at % variables);
            let mixed = a.gradient[i].times(b.gradient[j]) + a.gradient[j].times(b.gradient[i]);
            a.hessian[at].times(b.value) + mixed + a.value.times(b.hessian[at])
        };
        Sizes {
            value: a.value.times(b.value),
            gradient: (0..variables).map(first).collect(),
            hessian: (0..variables * variables).map(second).collect(),
        }
    }

    /// Entries of the product, with magnitudes of at most its own.
    pub(super) fn bound(&self, entries: &[Jet]) -> Vec<Jet> {
        let magnitudes = |sizes: &[Size]| -> Vec<f64> { sizes.iter().map(|size| size.magnitude).collect() };
        let (gradient, hessian) = (magnitudes(&self.gradient), magnitudes(&self.hessian));
        entries.iter().map(|entry| entry.bounded(self.value.magnitude, &gradient, &hessian)).collect()
    }
}
