//! Radau IIA of order 5, for stiff mechanisms.
//!
//! Hairer, Wanner, Solving Ordinary Differential Equations II, IV.8, and their program `radau5.f`. Where we differ: each of
//! the linear systems has n unknowns instead of 2 n, because q' is the rate of q, so that
//! (c I - [0 I; A B]) (x, y) = (r, s) is (c^2 I - c B - A) x = s + (c I - B) r, y = c x - r; and the Jacobian is generated,
//! and new in each step.

use super::method::{Advance, Attempt};
use crate::motion::Motion;
use crate::numerics::lu::Lu;
use crate::state::failure::{Failure, What};
use crate::state::saved::{Bytes, Damaged};
use crate::state::settings::Tolerance;
use crate::state::trajectory::{Rates, Sample, State};
use nalgebra::Complex;
use sim_kernel::{Array, Mechanism};

const ROOT6: f64 = 2.449_489_742_783_178;
/// Nodes.
const C: [f64; 3] = [(4.0 - ROOT6) / 10.0, (4.0 + ROOT6) / 10.0, 1.0];
/// Weights of the step: the last row of the tableau.
const B: [f64; 3] = [(16.0 - ROOT6) / 36.0, (16.0 + ROOT6) / 36.0, 1.0 / 9.0];
/// The eigenvalues of the inverse of the tableau: one real, and a pair.
const REAL: f64 = 3.637_834_252_744_496;
const PAIR: Complex<f64> = Complex::new(2.681_082_873_627_752, 3.050_430_199_247_411);
/// T^-1 A^-1 T is block diagonal with them.
const T: [[f64; 3]; 3] = [
    [9.123_239_487_089_295e-2, -0.141_255_295_020_954_2, -3.002_919_410_514_742_4e-2],
    [0.241_717_932_707_107, 0.204_129_352_293_799_94, 0.382_942_112_757_261_9],
    [0.966_048_182_615_093, 1.0, 0.0],
];
const T_INVERSE: [[f64; 3]; 3] = [
    [4.325_579_890_063_155, 0.339_199_251_815_809_84, 0.541_770_539_935_874_9],
    [-4.178_718_591_551_905, -0.327_682_820_761_062_4, 0.476_623_554_500_550_44],
    [-0.502_872_634_945_786_9, 2.571_926_949_855_605, -0.596_039_204_828_225],
];
/// Weights of the stages in the estimate of the error.
const ESTIMATE: [f64; 3] = [-(13.0 + 7.0 * ROOT6) / 3.0, (-13.0 + 7.0 * ROOT6) / 3.0, -1.0 / 3.0];

const MOST_ITERATIONS: usize = 10;
/// Changes that no longer decrease are rounding, which stiffness amplifies, if they are below this fraction of the
/// tolerance.
const STAGNANT: f64 = 0.05;
/// The polynomial of a step is followed ahead by at most so many times its length.
const FARTHEST: f64 = 10.0;
/// The accuracy of the equations of equal steps.
const TIGHT: Tolerance = Tolerance::new(1e-12);

/// The method, with the stages of its last step.
#[derive(Clone, Debug)]
pub struct Radau5<M: Mechanism> {
    /// Changes of the state from the start of the step to each stage.
    stages: [Rates<M>; 3],
    /// The power at each stage.
    powers: [f64; 3],
    /// The length of the last step, whose polynomial predicts the next; 0 if there is none.
    last: f64,
    /// The time that the last step came to.
    reached: f64,
    jacobian: Blocks<M>,
    real: Lu<f64>,
    complex: Lu<Complex<f64>>,
}

/// d(q'')/dq and d(q'')/dq'.
#[derive(Clone, Debug)]
struct Blocks<M: Mechanism> {
    by_positions: M::QQ,
    by_speeds: M::QQ,
}

impl<M: Mechanism> Radau5<M> {
    /// The method.
    pub fn new(mechanism: &M) -> Radau5<M> {
        let n = mechanism.n();
        let zero = M::QQ::repeat(n, M::Q::repeat(n, 0.0));
        let jacobian = Blocks { by_positions: zero.clone(), by_speeds: zero };
        Radau5 {
            stages: std::array::from_fn(|_| Rates::zero(n)),
            powers: [0.0; 3],
            last: 0.0,
            reached: f64::NAN,
            jacobian,
            real: Lu::new(n),
            complex: Lu::new(n),
        }
    }

    /// Its state between steps as bytes, or from them: the polynomial of the last one. Jacobian and factors are new in
    /// each step.
    pub(super) fn transfer(&mut self, bytes: &mut Bytes) -> Result<(), Damaged> {
        for stage in &mut self.stages {
            bytes.numbers(stage.positions.as_mut())?;
            bytes.numbers(stage.speeds.as_mut())?;
            bytes.number(&mut stage.work)?;
        }
        bytes.number(&mut self.last)?;
        bytes.number(&mut self.reached)
    }

    /// Factorises both systems for a step of length h.
    fn factorise(&mut self, h: f64) -> bool {
        let Blocks { by_positions: a, by_speeds: b } = &self.jacobian;
        let unit = |i: usize, j: usize| f64::from(u8::from(i == j));
        let (real, pair) = (REAL / h, PAIR / h);
        let is_regular = self.real.factorise(&|i, j| real * real * unit(i, j) - real * b[i][j] - a[i][j]);
        is_regular && self.complex.factorise(&|i, j| pair * pair * unit(i, j) - pair * b[i][j] - a[i][j])
    }

    /// x with (c I - J) x = r, for the real eigenvalue c.
    fn solve_real(&mut self, c: f64, r: &Rates<M>) -> Rates<M> {
        let b = &self.jacobian.by_speeds;
        let solution = self.real.solve(&|i| {
            r.speeds[i] + c * r.positions[i] - b[i].iter().zip(r.positions.iter()).map(|(b, r)| b * r).sum::<f64>()
        });
        let positions = r.positions.like(|i| solution[i]);
        Rates { positions: positions.clone(), speeds: positions.like(|i| c * positions[i] - r.positions[i]), work: 0.0 }
    }

    /// The same for the complex eigenvalue; real and imaginary part of the right-hand side and of the solution.
    fn solve_complex(&mut self, c: Complex<f64>, r: [&Rates<M>; 2]) -> [Rates<M>; 2] {
        let b = &self.jacobian.by_speeds;
        let position = |i: usize| Complex::new(r[0].positions[i], r[1].positions[i]);
        let speed = |i: usize| Complex::new(r[0].speeds[i], r[1].speeds[i]);
        let solution = self.complex.solve(&|i| {
            let damped: Complex<f64> = (0..b.len()).map(|j| position(j) * b[i][j]).sum();
            speed(i) + c * position(i) - damped
        });
        let part = |of: fn(Complex<f64>) -> f64| Rates {
            positions: r[0].positions.like(|i| of(solution[i])),
            speeds: r[0].speeds.like(|i| of(c * solution[i] - position(i))),
            work: 0.0,
        };
        [part(|z| z.re), part(|z| z.im)]
    }

    /// The prediction of the next step's stages by the polynomial of the last one.
    fn foretell(&mut self, from: &Sample<M>, h: f64) {
        let last = self.last;
        // A refused step predicts nothing, and a short one, as up to a sudden change, nothing of a much longer one.
        if last == 0.0 || self.reached != from.state.time || h > FARTHEST * last {
            self.stages.fill(Rates::zero(from.accelerations.len()));
            return;
        }
        let [.., end] = &self.stages;
        self.stages = C.map(|node| {
            let mut ahead = polynomial(&self.stages, 1.0 + node * h / last);
            ahead.add(-1.0, end);
            ahead
        });
    }

    /// Newton's method for the stages; the right-hand sides there, or nothing if it does not converge.
    fn solve_stages(
        &mut self,
        motion: &Motion<M>,
        from: &State<M>,
        h: f64,
        tolerance: &Tolerance,
    ) -> Result<Option<[Rates<M>; 3]>, Failure> {
        let enough = (10.0 * f64::EPSILON / tolerance.relative).max(tolerance.relative.sqrt().min(0.03));
        let mut last_change = f64::NAN;
        for iteration in 0..MOST_ITERATIONS {
            let mut rates = self.stages.clone();
            for i in 0..3 {
                let stage = from.changed(from.time + C[i] * h, 1.0, &self.stages[i]);
                if !stage.is_finite() {
                    return Ok(None);
                }
                rates[i] = motion.sample(stage)?.rates();
            }
            let (f, w) = (combined(&T_INVERSE, &rates), combined(&T_INVERSE, &self.stages));
            let (real, pair) = (REAL / h, PAIR / h);
            let residual = |i: usize, weights: [(f64, usize); 2]| {
                let mut residual = f[i].clone();
                weights.into_iter().for_each(|(weight, j)| residual.add(-weight, &w[j]));
                residual
            };
            let first = self.solve_real(real, &residual(0, [(real, 0), (0.0, 0)]));
            let second = residual(1, [(pair.re, 1), (-pair.im, 2)]);
            let third = residual(2, [(pair.re, 2), (pair.im, 1)]);
            let [second, third] = self.solve_complex(pair, [&second, &third]);
            let changes = combined(&T, &[first, second, third]);
            let size = |change: &Rates<M>| {
                tolerance.norm(motion.measures(), from, from, [&change.positions, &change.speeds]).powi(2)
            };
            let change = (changes.iter().map(size).sum::<f64>() / 3.0).sqrt();
            self.stages.iter_mut().zip(&changes).for_each(|(stage, change)| stage.add(1.0, change));
            let ratio = change / last_change;
            let left = if iteration == 0 { f64::INFINITY } else { change * ratio / (1.0 - ratio) };
            // If the prediction is accurate to rounding, changes do not decrease any more.
            let is_small = change <= if iteration == 0 { 1e-2 * enough } else { enough };
            if is_small || (ratio < 1.0 && left <= enough) {
                return Ok(Some(rates));
            }
            if iteration > 0 && !(ratio < 0.99) {
                return Ok((change <= STAGNANT).then_some(rates));
            }
            last_change = change;
        }
        Ok(None)
    }

    /// (IV.8.20); once more through the right-hand side where the error is too large, (IV.8.21).
    fn error(
        &mut self,
        motion: &Motion<M>,
        from: &Sample<M>,
        end: &State<M>,
        h: f64,
        tolerance: &Tolerance,
    ) -> Result<f64, Failure> {
        let mut stages = Rates::zero(from.accelerations.len());
        self.stages.iter().zip(ESTIMATE).for_each(|(stage, weight)| stages.add(weight / h, stage));
        let mut rates = from.rates();
        rates.add(1.0, &stages);
        let norm =
            |error: &Rates<M>| tolerance.norm(motion.measures(), &from.state, end, [&error.positions, &error.speeds]);
        let error = self.solve_real(REAL / h, &rates);
        if norm(&error) < 1.0 {
            return Ok(norm(&error));
        }
        let mut rates = motion.sample(from.state.changed(from.state.time, 1.0, &error))?.rates();
        rates.add(1.0, &stages);
        let error = self.solve_real(REAL / h, &rates);
        Ok(norm(&error))
    }
}

impl<M: Mechanism> Advance<M> for Radau5<M> {
    /// Between its first two nodes, (4 - sqrt 6)/10 and (4 + sqrt 6)/10.
    fn gap(&self) -> f64 {
        0.4
    }

    fn is_explicit(&self) -> bool {
        false
    }

    fn control_order(&self) -> Option<f64> {
        Some(4.0)
    }

    fn step(
        &mut self,
        motion: &Motion<M>,
        from: &Sample<M>,
        time: f64,
        tolerance: Option<&Tolerance>,
    ) -> Result<Attempt<M>, Failure> {
        let h = time - from.state.time;
        let fail = || Failure::at(motion.mechanism(), What::NoConvergence, from.state.time, &from.state.positions);
        let (by_positions, by_speeds) = motion.jacobian(from)?;
        self.jacobian = Blocks { by_positions, by_speeds };
        self.foretell(from, h);
        // Unless the step succeeds, the next one starts without a prediction.
        self.last = 0.0;
        if !self.factorise(h) {
            return Err(fail());
        }
        let rates = self.solve_stages(motion, &from.state, h, tolerance.unwrap_or(&TIGHT))?.ok_or_else(fail)?;
        self.powers = rates.map(|rates| rates.work);
        let mut change = self.stages[2].clone();
        change.work = h * self.powers.iter().zip(B).map(|(power, weight)| weight * power).sum::<f64>();
        let end = from.state.changed(time, 1.0, &change);
        let error = tolerance.map_or(Ok(0.0), |tolerance| self.error(motion, from, &end, h, tolerance))?;
        (self.last, self.reached) = (h, time);
        Ok(Attempt { end, error })
    }

    /// The collocation polynomial, of order 3, with the projected end.
    fn inside(&mut self, _: &Motion<M>, from: &Sample<M>, to: &Sample<M>, fraction: f64) -> Result<State<M>, Failure> {
        let (a, b) = (&from.state, &to.state);
        let difference = Rates {
            positions: b.positions.like(|i| b.positions[i] - a.positions[i]),
            speeds: b.speeds.like(|i| b.speeds[i] - a.speeds[i]),
            work: 0.0,
        };
        let h = b.time - a.time;
        let change = polynomial(&[self.stages[0].clone(), self.stages[1].clone(), difference], fraction);
        let mut state = a.changed(a.time + fraction * h, 1.0, &change);
        state.work = a.work + h * integrated(from.power, &self.powers, fraction);
        Ok(state)
    }
}

/// Rows of a matrix times stages.
fn combined<M: Mechanism>(matrix: &[[f64; 3]; 3], stages: &[Rates<M>; 3]) -> [Rates<M>; 3] {
    matrix.map(|row| {
        let mut sum = Rates::zero(stages[0].positions.len());
        row.iter().zip(stages).for_each(|(weight, stage)| sum.add(*weight, stage));
        sum
    })
}

/// The cubic through 0 at 0 and the stages at their nodes, at s.
fn polynomial<M: Mechanism>(stages: &[Rates<M>; 3], s: f64) -> Rates<M> {
    let mut sum = Rates::zero(stages[0].positions.len());
    weights(s).into_iter().zip(stages).for_each(|(weight, stage)| sum.add(weight, stage));
    sum
}

/// The weights of the stages in the cubic that is 0 at 0.
fn weights(s: f64) -> [f64; 3] {
    std::array::from_fn(|i| {
        let others = (0..3).filter(|j| *j != i);
        let weight: f64 = others.map(|j| (s - C[j]) / (C[i] - C[j])).product();
        weight * s / C[i]
    })
}

/// The integral from 0 to s of the cubic through a value at 0 and those at the nodes; up to 1 it is that of the step's weights.
/// Gauss's two nodes integrate it exactly.
fn integrated(start: f64, at_nodes: &[f64; 3], s: f64) -> f64 {
    let cubic = |s: f64| weights(s).iter().zip(at_nodes).fold(start, |sum, (w, value)| sum + w * (value - start));
    let [before, after] = [-0.5, 0.5].map(|side| cubic(s * (0.5 + side / 3f64.sqrt())));
    s * (before + after) / 2.0
}

#[cfg(test)]
mod tests {
    use super::*;

    fn product(a: &[[f64; 3]; 3], b: &[[f64; 3]; 3]) -> [[f64; 3]; 3] {
        a.map(|row| std::array::from_fn(|j| (0..3).map(|k| row[k] * b[k][j]).sum()))
    }

    /// A (T L T^-1) = I, where A is the tableau of collocation at the nodes: sum a_ij c_j^k = c_i^(k+1)/(k+1).
    #[test]
    fn the_transformation_is_that_of_the_tableau() {
        let blocks = [[REAL, 0.0, 0.0], [0.0, PAIR.re, -PAIR.im], [0.0, PAIR.im, PAIR.re]];
        let inverse = product(&product(&T, &blocks), &T_INVERSE);
        for k in 0..3 {
            for i in 0..3 {
                // A applied to powers of the nodes gives their integrals, and its inverse takes them back.
                let found: f64 = (0..3).map(|j| inverse[i][j] * C[j].powi(k + 1) / f64::from(k + 1)).sum();
                assert!((found - C[i].powi(k)).abs() < 1e-13, "{k} {i}: {found}");
            }
            let weight: f64 = (0..3).map(|j| B[j] * C[j].powi(k)).sum();
            assert!((weight - 1.0 / f64::from(k + 1)).abs() < 1e-15);
        }
    }
    #[test]
    fn cubics_are_integrated_exactly() {
        let p = |s: f64| 2.0 - s + 3.0 * s.powi(2) + 4.0 * s.powi(3);
        let integral = |s: f64| 2.0 * s - s.powi(2) / 2.0 + s.powi(3) + s.powi(4);
        for s in [0.1, 0.37, 0.9, 1.0] {
            // A few roundings of numbers below 10.
            assert!((integrated(p(0.0), &C.map(p), s) - integral(s)).abs() < 1e-14);
        }
        let values = [0.3, -1.7, 2.9];
        let weighted: f64 = values.iter().zip(B).map(|(value, weight)| weight * value).sum();
        assert!((integrated(123.0, &values, 1.0) - weighted).abs() < 1e-13);
    }

    /// The estimate takes the slope of the polynomial through the stages from that at the start, so the rest is of
    /// order 3.
    #[test]
    fn the_estimate_compares_slopes_at_the_start() {
        for k in 1..4 {
            let found: f64 = (0..3).map(|j| ESTIMATE[j] * C[j].powi(k)).sum();
            let slope = if k == 1 { 1.0 } else { 0.0 };
            assert!((found + slope).abs() < 1e-14, "s^{k}: {found}");
        }
    }
}
