//! Smooth functions on [-1, 1] as sums of Chebyshev polynomials, from their values at the roots of the next one.
//!
//! Trefethen, Approximation Theory and Approximation Practice (SIAM 2013), ch. 2 to 4 and 8: coefficients of an
//! analytic function fall geometrically, so the last ones show the error.

use crate::numerics::root::find_root;
use sim_kernel::Scalar;
use std::convert::Infallible;
use std::sync::LazyLock;

/// Values, and coefficients. An even number, so that the middle lies between two nodes.
pub(super) const NODES: usize = 12;
/// Places in [-1, 1] between which a rate is checked for sign changes.
const LOOKS: usize = 4 * NODES;

/// Nodes, and the Chebyshev polynomials there.
static TABLE: LazyLock<([f64; NODES], [[f64; NODES]; NODES])> = LazyLock::new(|| {
    let step = std::f64::consts::PI / (2 * NODES) as f64;
    let angle = |j: usize| std::f64::consts::PI - step * (2 * j + 1) as f64;
    let polynomial = |k: usize, j: usize| Scalar::cos(k as f64 * angle(j));
    let of_degree = |k: usize| std::array::from_fn(|j| polynomial(k, j));
    (std::array::from_fn(|j| Scalar::cos(angle(j))), std::array::from_fn(of_degree))
});

/// The nodes, in order.
pub(super) fn nodes() -> [f64; NODES] {
    TABLE.0
}

/// A sum of c_k T_k(x).
#[derive(Clone, Copy, Debug)]
pub(super) struct Series([f64; NODES]);

impl Series {
    /// The series with these values at the nodes.
    pub(super) fn through(values: [f64; NODES]) -> Series {
        let sum = |k: usize| TABLE.1[k].iter().zip(values).map(|(polynomial, value)| polynomial * value).sum::<f64>();
        Series(std::array::from_fn(|k| sum(k) * if k == 0 { 1.0 } else { 2.0 } / NODES as f64))
    }

    /// Its value, by Clenshaw's recurrence.
    pub(super) fn at(&self, x: f64) -> f64 {
        let (mut next, mut after) = (0.0, 0.0);
        for c in self.0[1..].iter().rev() {
            (next, after) = (c + 2.0 * x * next - after, next);
        }
        self.0[0] + x * next - after
    }

    /// Its derivative.
    pub(super) fn rate(&self) -> Series {
        let mut rate = [0.0; NODES];
        for k in (1..NODES).rev() {
            rate[k - 1] = rate.get(k + 1).copied().unwrap_or(0.0) + 2.0 * k as f64 * self.0[k];
        }
        rate[0] /= 2.0;
        Series(rate)
    }

    /// The larger of its last two coefficients, one even and one odd: its approximate error.
    pub(super) fn tail(&self) -> f64 {
        self.0[NODES - 1].abs().max(self.0[NODES - 2].abs())
    }

    /// Its turning points between -1 and 1, in order.
    pub(super) fn turns(&self) -> Vec<f64> {
        let rate = self.rate();
        let place = |i: usize| 2.0 * i as f64 / LOOKS as f64 - 1.0;
        let values: Vec<f64> = (0..=LOOKS).map(|i| rate.at(place(i))).collect();
        let turn = |i: usize| {
            let at = |fraction: f64| place(i) + fraction * (2.0 / LOOKS as f64);
            let found = find_root(values[i], values[i + 1], 1e-15, &mut |s| Ok::<f64, Infallible>(rate.at(at(s))));
            found.ok().map(at)
        };
        (0..LOOKS).filter(|i| (values[*i] > 0.0) != (values[*i + 1] > 0.0)).filter_map(turn).collect()
    }
}

#[cfg(test)]
mod tests {
    use super::{Series, nodes};

    /// A polynomial of the highest degree is its own series, and so is its derivative; the cosine to its next coefficient.
    #[test]
    fn polynomials_are_their_own_series() {
        let (p, dp) = (|x: f64| 0.3 - x + 2.0 * x.powi(11), |x: f64| 22.0 * x.powi(10) - 1.0);
        let series = Series::through(nodes().map(p));
        for x in [-1.0, -0.4, 0.0, 0.7, 1.0] {
            assert!((series.at(x) - p(x)).abs() < 1e-14 && (series.rate().at(x) - dp(x)).abs() < 1e-12, "{x}");
        }
        let turn = 22f64.powf(-0.1);
        let turns = series.turns();
        assert!(turns.len() == 2 && (turns[0] + turn).abs() < 1e-14 && (turns[1] - turn).abs() < 1e-14, "{turns:?}");
        let cosine = Series::through(nodes().map(f64::cos));
        // The coefficient of T_12 in cos x is 2 J_12(1) = 1e-12, that of T_10 5e-10.
        assert!((cosine.at(0.3) - 0.3f64.cos()).abs() < 2e-12 && (1e-10..1e-9).contains(&cosine.tail()));
    }
}
