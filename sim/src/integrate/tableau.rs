//! Butcher tableaus, as data.

/// An explicit Runge-Kutta method: stage i is evaluated at t + c_i h with the state advanced by
/// h sum of a_ij k_j, and the step advances by h sum of b_i k_i.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Tableau<const STAGES: usize> {
    /// Weights of earlier stages, strictly lower triangular.
    pub a: [[f64; STAGES]; STAGES],
    /// Weights of the step.
    pub b: [f64; STAGES],
    /// Nodes.
    pub c: [f64; STAGES],
    /// Order of convergence.
    pub order: usize,
    /// Name on the command line and in files.
    pub name: &'static str,
}

/// The classical method of Runge and Kutta (Kutta 1901), of order 4.
pub const RK4: Tableau<4> = Tableau {
    a: [[0.0, 0.0, 0.0, 0.0], [0.5, 0.0, 0.0, 0.0], [0.0, 0.5, 0.0, 0.0], [0.0, 0.0, 1.0, 0.0]],
    b: [1.0 / 6.0, 1.0 / 3.0, 1.0 / 3.0, 1.0 / 6.0],
    c: [0.0, 0.5, 0.5, 1.0],
    order: 4,
    name: "rk4",
};

#[cfg(test)]
mod tests {
    use super::RK4;

    /// The eight order conditions up to order 4 (Hairer, Norsett, Wanner, Solving Ordinary Differential Equations I,
    /// table II.2.1 there), to rounding.
    #[test]
    fn rk4_meets_its_order_conditions() {
        let (a, b, c) = (RK4.a, RK4.b, RK4.c);
        let sum = |f: &dyn Fn(usize) -> f64| (0..4).map(f).sum::<f64>();
        let ac = |i: usize| sum(&|j| a[i][j] * c[j]);
        let conditions = [
            (sum(&|i| b[i]), 1.0),
            (sum(&|i| b[i] * c[i]), 1.0 / 2.0),
            (sum(&|i| b[i] * c[i] * c[i]), 1.0 / 3.0),
            (sum(&|i| b[i] * ac(i)), 1.0 / 6.0),
            (sum(&|i| b[i] * c[i].powi(3)), 1.0 / 4.0),
            (sum(&|i| b[i] * c[i] * ac(i)), 1.0 / 8.0),
            (sum(&|i| b[i] * sum(&|j| a[i][j] * c[j] * c[j])), 1.0 / 12.0),
            (sum(&|i| b[i] * sum(&|j| a[i][j] * ac(j))), 1.0 / 24.0),
        ];
        for (at, (value, expected)) in conditions.into_iter().enumerate() {
            assert!((value - expected).abs() < 4.0 * f64::EPSILON, "condition {at}: {value} instead of {expected}");
        }
        assert!((0..4).all(|i| (sum(&|j| a[i][j]) - c[i]).abs() < f64::EPSILON));
    }
}
