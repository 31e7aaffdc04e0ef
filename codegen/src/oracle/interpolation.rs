//! Tables by their own formulas: cubics from the second derivatives at the rows, found by relaxation.

use super::error::{OracleError, Result};
use super::function::Derivatives;
use super::jet::Jet;
use crate::dsl::{Between, DeclaredTable, Ends, Outside};

/// Sweeps of relaxation. If rows are evenly spaced each sweep at least halves the error; if neighbouring intervals
/// differ tenfold, it takes it to three quarters.
const SWEEPS: usize = 200;

/// A function given by rows.
pub(super) struct Function {
    x: Vec<f64>,
    y: Vec<f64>,
    shape: Shape,
    outside: Outside,
    /// Of the values and their derivatives.
    sizes: [f64; 3],
}

enum Shape {
    Lines,
    /// By the second derivatives at the rows.
    Curvatures(Vec<f64>),
    /// By the first derivatives there.
    Slopes(Vec<f64>),
}

impl Function {
    /// The function of a table with these rows in SI units.
    pub(super) fn new(table: &DeclaredTable, rows: &[[f64; 2]]) -> Result<Function> {
        if rows.len() < 2 || rows.windows(2).any(|pair| pair[1][0] <= pair[0][0]) {
            return Err(OracleError::new(format!("the rows of table `{}` do not increase", table.name)));
        }
        let [x, y] = [0, 1].map(|column| rows.iter().map(|row| row[column]).collect::<Vec<f64>>());
        let is_periodic = table.outside == Outside::Periodic;
        let shape = match table.between {
            Between::Linear => Shape::Lines,
            Between::Cubic => Shape::Curvatures(curvatures(&x, &y, table.ends.map(|(ends, _)| ends), is_periodic)),
            Between::Monotone => Shape::Slopes(slopes(&x, &y, is_periodic)),
        };
        let size = y.iter().fold(0.0, |size: f64, y| size.max(y.abs()));
        let step = x.windows(2).fold(f64::INFINITY, |step, x| step.min(x[1] - x[0]));
        let sizes = [size, 2.0 * size / step, 4.0 * size / (step * step)];
        Ok(Function { x, y, shape, outside: table.outside, sizes })
    }

    /// The function of a jet. Its coefficients are differences of the values, and as exact as those.
    pub(super) fn at(&self, argument: &Jet) -> Jet {
        argument.compose_of_size(self.derivatives(argument.value().value), self.sizes)
    }

    fn derivatives(&self, x: f64) -> Derivatives {
        let (first, last) = (self.x[0], self.x[self.x.len() - 1]);
        match self.outside {
            Outside::Periodic => {
                let turns = ((x - first) / (last - first)).floor();
                self.inside(x - turns * (last - first))
            }
            _ if x >= first && x < last => self.inside(x),
            _ if x.is_nan() => [f64::NAN; 4],
            outside => {
                let end = if x < first { 0 } else { self.x.len() - 1 };
                let slope = if outside == Outside::Held { 0.0 } else { self.slope_at(end) };
                [self.y[end] + slope * (x - self.x[end]), slope, 0.0, 0.0]
            }
        }
    }

    fn slope_at(&self, row: usize) -> f64 {
        let interval = row.min(self.x.len() - 2);
        self.on(interval, self.x[row])[1]
    }

    fn inside(&self, x: f64) -> Derivatives {
        let interval = self.x[1..self.x.len() - 1].partition_point(|row| *row <= x);
        self.on(interval, x)
    }

    /// By the values and derivatives at both ends of an interval.
    fn on(&self, i: usize, x: f64) -> Derivatives {
        let h = self.x[i + 1] - self.x[i];
        let (a, b) = ((self.x[i + 1] - x) / h, (x - self.x[i]) / h);
        let (y, z) = (self.y[i], self.y[i + 1]);
        match &self.shape {
            Shape::Lines => [a * y + b * z, (z - y) / h, 0.0, 0.0],
            Shape::Curvatures(m) => {
                let (m, n) = (m[i] * h * h / 6.0, m[i + 1] * h * h / 6.0);
                [
                    a * y + b * z + (a * a * a - a) * m + (b * b * b - b) * n,
                    (z - y - (3.0 * a * a - 1.0) * m + (3.0 * b * b - 1.0) * n) / h,
                    6.0 * (a * m + b * n) / (h * h),
                    6.0 * (n - m) / (h * h * h),
                ]
            }
            Shape::Slopes(s) => {
                let (s, t) = (s[i] * h, s[i + 1] * h);
                [
                    a * a * (1.0 + 2.0 * b) * y + b * b * (1.0 + 2.0 * a) * z + a * a * b * s - a * b * b * t,
                    (6.0 * a * b * (z - y) + a * (a - 2.0 * b) * s + b * (b - 2.0 * a) * t) / h,
                    (6.0 * (a - b) * (z - y) + (2.0 * b - 4.0 * a) * s + (4.0 * b - 2.0 * a) * t) / (h * h),
                    (12.0 * (y - z) + 6.0 * (s + t)) / (h * h * h),
                ]
            }
        }
    }
}

/// h m_(i-1) + 2 (h + g) m_i + g m_(i+1) = 6 (slope right - slope left) at every row, with the end conditions inserted.
fn curvatures(x: &[f64], y: &[f64], ends: Option<Ends>, is_periodic: bool) -> Vec<f64> {
    let n = x.len() - 1;
    let h = |i: usize| x[i + 1] - x[i];
    let d = |i: usize| (y[i + 1] - y[i]) / h(i);
    if n == 2 && ends.is_none() && !is_periodic {
        return vec![2.0 * (d(1) - d(0)) / (h(0) + h(1)); 3];
    }
    let mut m = vec![0.0; n + 1];
    if n == 1 && ends != Some(Ends::Clamped) {
        return m;
    }
    for _ in 0..SWEEPS {
        for i in 1..n {
            let (left, right) = (h(i - 1), h(i));
            let value = 6.0 * (d(i) - d(i - 1));
            // The end condition of the second derivative: a multiple of m_i, and one of the next.
            let (mut at, mut before, mut after) = (2.0 * (left + right), left * m[i - 1], right * m[i + 1]);
            if ends.is_none() && !is_periodic && i == 1 {
                at += left * (1.0 + left / right);
                before = -left * left / right * m[2];
            }
            if ends.is_none() && !is_periodic && i == n - 1 {
                at += right * (1.0 + right / left);
                after = -right * right / left * m[n - 2];
            }
            m[i] = (value - before - after) / at;
        }
        match ends {
            _ if is_periodic => {
                let (left, right) = (h(n - 1), h(0));
                let neighbours = left * m[n - 1] + right * m[1 % n];
                m[0] = (6.0 * (d(0) - d(n - 1)) - neighbours) / (2.0 * (left + right));
                m[n] = m[0];
            }
            Some(Ends::Natural) => {}
            Some(Ends::Clamped) => {
                m[0] = (6.0 * d(0) / h(0) - m[1]) / 2.0;
                m[n] = (-6.0 * d(n - 1) / h(n - 1) - m[n - 1]) / 2.0;
            }
            None => {
                m[0] = m[1] + (m[1] - m[2]) * h(0) / h(1);
                m[n] = m[n - 1] + (m[n - 1] - m[n - 2]) * h(n - 1) / h(n - 2);
            }
        }
    }
    m
}

/// Weighted harmonic means of the slopes beside each row; at the ends that of the parabola, limited to stay monotone.
fn slopes(x: &[f64], y: &[f64], is_periodic: bool) -> Vec<f64> {
    let n = x.len() - 1;
    let h = |i: usize| x[i + 1] - x[i];
    let d = |i: usize| (y[i + 1] - y[i]) / h(i);
    let mean = |i: usize, j: usize| {
        let (p, q) = (2.0 * h(j) + h(i), h(j) + 2.0 * h(i));
        let agree = d(i).signum() == d(j).signum() && d(i) != 0.0 && d(j) != 0.0;
        if agree { (p + q) * d(i) * d(j) / (p * d(j) + q * d(i)) } else { 0.0 }
    };
    let end = |i: usize, j: usize| {
        let slope = ((2.0 * h(i) + h(j)) * d(i) - h(i) * d(j)) / (h(i) + h(j));
        match () {
            _ if slope.signum() != d(i).signum() || slope == 0.0 || d(i) == 0.0 => 0.0,
            _ if d(i) * d(j) <= 0.0 => slope.signum() * slope.abs().min(3.0 * d(i).abs()),
            _ => slope,
        }
    };
    (0..=n)
        .map(|i| match i {
            _ if is_periodic && (i == 0 || i == n) => mean(n - 1, 0),
            _ if n == 1 => d(0),
            0 => end(0, 1),
            _ if i == n => end(n - 1, n - 2),
            _ => mean(i - 1, i),
        })
        .collect()
}
