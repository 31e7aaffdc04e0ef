//! Linear systems of real or complex numbers, factorised in place.

use nalgebra::ComplexField;

/// L U factors with partial pivoting of an n x n matrix; its memory is reused from one matrix to the next.
#[derive(Clone, Debug)]
pub(crate) struct Lu<T> {
    n: usize,
    /// By rows.
    entries: Vec<T>,
    /// Which row came to each place.
    exchanged: Vec<usize>,
    scratch: Vec<T>,
}

impl<T: ComplexField<RealField = f64> + Copy> Lu<T> {
    pub(crate) fn new(n: usize) -> Lu<T> {
        Lu { n, entries: vec![T::zero(); n * n], exchanged: vec![0; n], scratch: vec![T::zero(); n] }
    }

    /// Factorises the matrix with these entries. False if it is singular or not finite.
    pub(crate) fn factorise(&mut self, entry: &dyn Fn(usize, usize) -> T) -> bool {
        let n = self.n;
        for i in 0..n {
            for j in 0..n {
                self.entries[i * n + j] = entry(i, j);
            }
        }
        (0..n).all(|k| self.eliminate(k))
    }

    fn eliminate(&mut self, k: usize) -> bool {
        let (n, entries) = (self.n, &mut self.entries);
        let mut row = k;
        for i in k + 1..n {
            if entries[i * n + k].modulus() > entries[row * n + k].modulus() {
                row = i;
            }
        }
        self.exchanged[k] = row;
        (0..n).for_each(|j| entries.swap(k * n + j, row * n + j));
        let pivot = entries[k * n + k];
        for i in k + 1..n {
            let factor = entries[i * n + k] / pivot;
            entries[i * n + k] = factor;
            for j in k + 1..n {
                let known = factor * entries[k * n + j];
                entries[i * n + j] -= known;
            }
        }
        pivot.modulus() > 0.0 && pivot.modulus().is_finite()
    }

    /// The solution for a right-hand side.
    pub(crate) fn solve(&mut self, rhs: &dyn Fn(usize) -> T) -> &[T] {
        let (n, entries, x) = (self.n, &self.entries, &mut self.scratch);
        (0..n).for_each(|i| x[i] = rhs(i));
        // All exchanges first: later ones have moved the multipliers of earlier rows too.
        (0..n).for_each(|k| x.swap(k, self.exchanged[k]));
        for k in 0..n {
            for i in k + 1..n {
                let known = entries[i * n + k] * x[k];
                x[i] -= known;
            }
        }
        for k in (0..n).rev() {
            for j in k + 1..n {
                let known = entries[k * n + j] * x[j];
                x[k] -= known;
            }
            x[k] /= entries[k * n + k];
        }
        x
    }
}

#[cfg(test)]
mod tests {
    use super::Lu;
    use nalgebra::Complex;

    /// Exchanges in every column, the second among rows that already have multipliers from the first.
    #[test]
    fn systems_are_solved() {
        let matrix = [[1.0, 1.0, 8.0], [2.0, 2.0, 1.0], [4.0, 1.0, 0.0]];
        let mut real = Lu::new(3);
        assert!(real.factorise(&|i, j| matrix[i][j]));
        let rhs = [27.0, 9.0, 6.0];
        let expected = [1.0f64, 2.0, 3.0];
        assert!(real.solve(&|i| rhs[i]).iter().zip(expected).all(|(x, e)| (x - e).abs() < 1e-14));
        let mut complex = Lu::new(1);
        assert!(complex.factorise(&|_, _| Complex::new(0.0, 2.0)));
        assert_eq!(complex.solve(&|_| Complex::new(2.0, 0.0)), [Complex::new(0.0, -1.0)]);
        assert!(!real.factorise(&|_, _| 1.0));
    }
}
