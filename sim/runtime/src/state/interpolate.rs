//! The motion between two samples.

use crate::numerics::cubic::cubic;
use crate::state::trajectory::{Sample, State};
use sim_kernel::{Array, Mechanism};

/// The state at `fraction` of the way between two samples, not projected.
///
/// Positions by the quintic that has the positions, speeds and accelerations of both ends (error of order 6 in
/// the step), speeds by its derivative, work by the cubic of its values and of the power (error of order 4).
pub fn hermite<M: Mechanism>(from: &Sample<M>, to: &Sample<M>, fraction: f64) -> State<M> {
    let (a, b) = (&from.state, &to.state);
    let h = b.time - a.time;
    let ends = |i: usize| Ends {
        value: [a.positions[i], b.positions[i]],
        rate: [h * a.speeds[i], h * b.speeds[i]],
        second: [h * h * from.accelerations[i], h * h * to.accelerations[i]],
    };
    State {
        time: a.time + fraction * h,
        positions: a.positions.like(|i| ends(i).at(fraction).0),
        speeds: a.speeds.like(|i| ends(i).at(fraction).1 / h),
        work: cubic([a.work, b.work], [h * from.power, h * to.power], fraction),
    }
}

/// The state at `fraction` of the way between two samples by a straight line, not projected.
pub(crate) fn linear<M: Mechanism>(from: &Sample<M>, to: &Sample<M>, fraction: f64) -> State<M> {
    let (a, b) = (&from.state, &to.state);
    let between = |a: f64, b: f64| a + fraction * (b - a);
    State {
        time: between(a.time, b.time),
        positions: a.positions.zip_with(&b.positions, |a, b| between(*a, *b)),
        speeds: a.speeds.zip_with(&b.speeds, |a, b| between(*a, *b)),
        work: between(a.work, b.work),
    }
}

/// A quantity at both ends of an interval of length 1.
struct Ends {
    value: [f64; 2],
    rate: [f64; 2],
    second: [f64; 2],
}

impl Ends {
    /// Value and derivative of the quintic Hermite interpolant.
    fn at(&self, s: f64) -> (f64, f64) {
        // Newton's form about the left end: a + b s + c s^2 + s^3 (d + e (s - 1) + f (s - 1)^2).
        let (a, b, c) = (self.value[0], self.rate[0], self.second[0] / 2.0);
        let d = self.value[1] - a - b - c;
        let e = self.rate[1] - b - 2.0 * c - 3.0 * d;
        let f = self.second[1] / 2.0 - c - 3.0 * d - 3.0 * e;
        let r = s - 1.0;
        let tail = d + r * (e + r * f);
        let tail_rate = e + 2.0 * f * r;
        (a + s * (b + s * (c + s * tail)), b + 2.0 * c * s + s * s * (3.0 * tail + s * tail_rate))
    }
}

#[cfg(test)]
mod tests {
    use super::Ends;

    /// A quintic is its own interpolant.
    #[test]
    fn quintics_are_reproduced() {
        let p = |s: f64| 1.0 - 2.0 * s + 3.0 * s.powi(2) - 0.5 * s.powi(3) + 0.25 * s.powi(4) + 2.0 * s.powi(5);
        let dp = |s: f64| -2.0 + 6.0 * s - 1.5 * s.powi(2) + s.powi(3) + 10.0 * s.powi(4);
        let ddp = |s: f64| 6.0 - 3.0 * s + 3.0 * s.powi(2) + 40.0 * s.powi(3);
        let ends = Ends { value: [p(0.0), p(1.0)], rate: [dp(0.0), dp(1.0)], second: [ddp(0.0), ddp(1.0)] };
        for s in [0.0, 0.1, 0.37, 0.5, 0.93, 1.0] {
            let (value, rate) = ends.at(s);
            // A few roundings of numbers below 30.
            assert!((value - p(s)).abs() < 1e-13 && (rate - dp(s)).abs() < 1e-13, "{s}: {value} {rate}");
        }
    }
}
