//! Rows of a table to pieces: lines, and cubics by their slopes at the rows (de Boor, A Practical Guide to Splines, 2001, ch. IV).

use crate::dsl::{Between, Ends, Outside};

/// The pieces of a table of at least two rows, from before the first row to after the last, each in powers of the
/// distance from the row where it starts; the first piece from the first row.
pub(super) fn pieces(x: &[f64], y: &[f64], between: Between, ends: Option<Ends>, outside: Outside) -> Vec<[f64; 4]> {
    let rows = Rows::new(x, y);
    let slopes = match (between, outside) {
        (Between::Linear, _) => return lines(&rows, outside),
        (Between::Cubic, Outside::Periodic) => rows.periodic_slopes(),
        (Between::Cubic, _) => rows.slopes(ends),
        (Between::Monotone, _) => rows.monotone_slopes(outside == Outside::Periodic),
    };
    let inner = (0..rows.h.len()).map(|i| {
        let (h, d, s, t) = (rows.h[i], rows.d[i], slopes[i], slopes[i + 1]);
        [y[i], s, (3.0 * d - 2.0 * s - t) / h, (s + t - 2.0 * d) / (h * h)]
    });
    enclosed(&rows, inner.collect(), [slopes[0], slopes[slopes.len() - 1]], outside)
}

fn lines(rows: &Rows, outside: Outside) -> Vec<[f64; 4]> {
    let inner = rows.d.iter().zip(rows.y).map(|(d, y)| [*y, *d, 0.0, 0.0]).collect();
    enclosed(rows, inner, [rows.d[0], rows.d[rows.d.len() - 1]], outside)
}

/// The pieces with those before and after them.
fn enclosed(rows: &Rows, inner: Vec<[f64; 4]>, slopes: [f64; 2], outside: Outside) -> Vec<[f64; 4]> {
    let slopes = if outside == Outside::Continued { slopes } else { [0.0; 2] };
    let ends = [rows.y[0], rows.y[rows.y.len() - 1]];
    let [before, after] = [0, 1].map(|end| [ends[end], slopes[end], 0.0, 0.0]);
    [before].into_iter().chain(inner).chain([after]).collect()
}

/// Values with the lengths and the slopes of the lines between them.
struct Rows<'a> {
    y: &'a [f64],
    h: Vec<f64>,
    d: Vec<f64>,
}

impl Rows<'_> {
    fn new<'a>(x: &[f64], y: &'a [f64]) -> Rows<'a> {
        let h: Vec<f64> = x.windows(2).map(|x| x[1] - x[0]).collect();
        let d = y.windows(2).zip(&h).map(|(y, h)| (y[1] - y[0]) / h).collect();
        Rows { y, h, d }
    }

    /// h_i s_(i-1) + 2 (h_(i-1) + h_i) s_i + h_(i-1) s_(i+1) = 3 (h_i d_(i-1) + h_(i-1) d_i), for second derivatives that are
    /// equal on both sides of row i; `left` and `right` are the intervals beside it.
    fn smooth(&self, left: usize, right: usize) -> Equation {
        let (h, g) = (self.h[left], self.h[right]);
        Equation { below: g, at: 2.0 * (h + g), above: h, value: 3.0 * (g * self.d[left] + h * self.d[right]) }
    }

    /// The slopes of a cubic spline. By default the third derivative is continuous at the second row and the last but
    /// one, so cubics are reproduced exactly.
    fn slopes(&self, ends: Option<Ends>) -> Vec<f64> {
        let n = self.y.len();
        if ends.is_none() && n < 4 {
            return self.parabola();
        }
        let [first, last] = [(0, 1), (n - 2, n.saturating_sub(3))].map(|(own, next)| self.end(ends, own, next));
        let inner = (1..n - 1).map(|i| self.smooth(i - 1, i));
        let last = Equation { below: last.above, above: 0.0, ..last };
        solve(&[first].into_iter().chain(inner).chain([last]).collect::<Vec<_>>())
    }

    /// The equation of an end, beside the interval `own` and that after it.
    fn end(&self, ends: Option<Ends>, own: usize, next: usize) -> Equation {
        match ends {
            Some(Ends::Clamped) => Equation { below: 0.0, at: 1.0, above: 0.0, value: 0.0 },
            Some(Ends::Natural) => Equation { below: 0.0, at: 2.0, above: 1.0, value: 3.0 * self.d[own] },
            None => {
                let (h, g) = (self.h[own], self.h[next]);
                let value = ((h + 2.0 * (h + g)) * g * self.d[own] + h * h * self.d[next]) / (h + g);
                Equation { below: 0.0, at: g, above: h + g, value }
            }
        }
    }

    /// The slopes of the line through two rows or of the parabola through three.
    fn parabola(&self) -> Vec<f64> {
        let [h, g, d, e] = match (self.h.as_slice(), self.d.as_slice()) {
            ([h, g, ..], [d, e, ..]) => [*h, *g, *d, *e],
            _ => return vec![self.d[0]; 2],
        };
        let curvature = (e - d) / (h + g);
        vec![d - h * curvature, d + h * curvature, e + g * curvature]
    }

    /// The slopes of a periodic spline: with that of the first row known the others follow, and are linear in it.
    fn periodic_slopes(&self) -> Vec<f64> {
        let n = self.h.len();
        if n == 1 {
            return vec![0.0; 2];
        }
        let own: Vec<Equation> = (1..n).map(|i| self.smooth(i - 1, i)).collect();
        let by_first = |i: usize, equation: &Equation| {
            let first = if i == 0 { equation.below } else { 0.0 };
            let last = if i == n - 2 { equation.above } else { 0.0 };
            Equation { value: -(first + last), ..*equation }
        };
        let by_first: Vec<Equation> = own.iter().enumerate().map(|(i, equation)| by_first(i, equation)).collect();
        let (base, by_first) = (solve(&own), solve(&by_first));
        let closing = self.smooth(n - 1, 0);
        let known = closing.below * base[n - 2] + closing.above * base[0];
        let slope =
            (closing.value - known) / (closing.at + closing.below * by_first[n - 2] + closing.above * by_first[0]);
        let inner = base.iter().zip(&by_first).map(|(base, by_first)| base + slope * by_first);
        [slope].into_iter().chain(inner).chain([slope]).collect()
    }

    /// Slopes with which no piece rises where the rows fall (Fritsch, Butland: A method for constructing local monotone
    /// piecewise cubic interpolants, SIAM J. Sci. Stat. Comput. 5, 1984).
    fn monotone_slopes(&self, is_periodic: bool) -> Vec<f64> {
        let n = self.h.len();
        let [first, last] = match (is_periodic, n) {
            (true, _) => [self.harmonic(n - 1, 0); 2],
            (false, 1) => [self.d[0]; 2],
            (false, _) => [self.one_sided(0, 1), self.one_sided(n - 1, n - 2)],
        };
        let inner = (1..n).map(|i| self.harmonic(i - 1, i));
        [first].into_iter().chain(inner).chain([last]).collect()
    }

    /// The weighted harmonic mean of the slopes of two intervals, or 0 where they differ in sign.
    fn harmonic(&self, left: usize, right: usize) -> f64 {
        let (h, g, d, e) = (self.h[left], self.h[right], self.d[left], self.d[right]);
        if d * e <= 0.0 {
            return 0.0;
        }
        3.0 * (h + g) / ((h + 2.0 * g) / d + (2.0 * h + g) / e)
    }

    /// The slope of the parabola at an end, limited so that the piece stays monotone.
    fn one_sided(&self, own: usize, next: usize) -> f64 {
        let (h, g, d, e) = (self.h[own], self.h[next], self.d[own], self.d[next]);
        let slope = d + h * (d - e) / (h + g);
        match () {
            _ if slope * d <= 0.0 => 0.0,
            _ if d * e <= 0.0 && slope.abs() > 3.0 * d.abs() => 3.0 * d,
            _ => slope,
        }
    }
}

/// below s_(i-1) + at s_i + above s_(i+1) = value
struct Equation {
    below: f64,
    at: f64,
    above: f64,
    value: f64,
}

/// The solution of tridiagonal equations, eliminated from above.
fn solve(equations: &[Equation]) -> Vec<f64> {
    let mut reduced: Vec<(f64, f64)> = Vec::with_capacity(equations.len());
    for equation in equations {
        let (factor, known) = reduced.last().copied().unwrap_or((0.0, 0.0));
        let pivot = equation.at - equation.below * factor;
        reduced.push((equation.above / pivot, (equation.value - equation.below * known) / pivot));
    }
    let mut solution = vec![0.0; equations.len()];
    let mut next = 0.0;
    for (i, (factor, known)) in reduced.iter().enumerate().rev() {
        next = known - factor * next;
        solution[i] = next;
    }
    solution
}
