//! Functions given by rows: the piece that an argument is in is looked up, and a cubic evaluated.

use crate::Scalar;

/// A function of one argument in cubic pieces, as a declaration's `tables` gives it. In SI units.
///
/// Derivatives of every order are those of the piece; at a row it is the piece to the right.
#[derive(Debug)]
pub struct Table {
    knots: &'static [f64],
    pieces: &'static [[f64; 5]],
    period: f64,
    scale: f64,
}

impl Table {
    /// A table of n `knots`, which increase, and n + 1 `pieces`: one before the first knot, one from each on. A piece
    /// `[s, c0, c1, c2, c3]` has the value c0 + c1 u + c2 u^2 + c3 u^3 with u = x - s. A nonzero `period` is that of
    /// the function, the distance of the last knot from the first.
    pub const fn new(knots: &'static [f64], pieces: &'static [[f64; 5]], period: f64) -> Table {
        let scale = match knots {
            [first, .., last] => (knots.len() - 1) as f64 / (*last - *first),
            _ => 0.0,
        };
        Table { knots, pieces, period, scale }
    }

    /// The value at x and its derivatives, up to the order N - 1.
    #[inline(always)]
    pub fn at<S: Scalar, const N: usize>(&self, x: S) -> [S; N] {
        let [start, c0, c1, c2, c3] = x.gather(|x| self.piece(x));
        let [two, three, six] = [2.0, 3.0, 6.0].map(S::from_f64);
        let u = x - start;
        core::array::from_fn(|order| match order {
            0 => c0 + u * (c1 + u * (c2 + u * c3)),
            1 => c1 + u * (two * c2 + u * (three * c3)),
            2 => two * c2 + u * (six * c3),
            3 => six * c3,
            _ => S::from_f64(0.0),
        })
    }

    /// The first row after x, of a periodic table too; infinite after the last one.
    pub fn next_row(&self, x: f64) -> f64 {
        let Some(first) = self.knots.first() else { return f64::INFINITY };
        let turns = if self.period == 0.0 { 0.0 } else { libm::floor((x - first) / self.period) * self.period };
        let after = |turns: f64| {
            let place = self.knots.partition_point(|row| row + turns <= x);
            self.knots.get(place).map(|row| row + turns)
        };
        // Rounding may put the last row of a period before x: the first of the next one is the same.
        after(turns).or_else(|| after(turns + self.period)).unwrap_or(f64::INFINITY)
    }

    /// The last row before x, of a periodic table too; infinite before the first one.
    pub fn last_row(&self, x: f64) -> f64 {
        let Some(first) = self.knots.first() else { return f64::NEG_INFINITY };
        let turns = if self.period == 0.0 { 0.0 } else { libm::floor((x - first) / self.period) * self.period };
        let before = |turns: f64| {
            let place = self.knots.partition_point(|row| row + turns < x);
            place.checked_sub(1).and_then(|place| self.knots.get(place)).map(|row| row + turns)
        };
        before(turns).or_else(|| before(turns - self.period)).unwrap_or(f64::NEG_INFINITY)
    }

    /// The piece that x is in, its start moved by whole periods.
    fn piece(&self, x: f64) -> [f64; 5] {
        let Some(first) = self.knots.first() else { return [f64::NAN; 5] };
        if self.period == 0.0 {
            return self.pieces.get(self.place(x, *first)).copied().unwrap_or([f64::NAN; 5]);
        }
        let turns = libm::floor((x - first) / self.period) * self.period;
        // Rounding may move the reduced x out of the rows.
        let place = self.place(x - turns, *first).clamp(1, self.knots.len() - 1);
        let [start, rest @ ..] = self.pieces.get(place).copied().unwrap_or([f64::NAN; 5]);
        let [c0, c1, c2, c3] = rest;
        [start + turns, c0, c1, c2, c3]
    }

    /// The number of knots up to x. Where rows are evenly spaced the first guess is right.
    fn place(&self, x: f64, first: f64) -> usize {
        let guess = ((x - first) * self.scale) as usize;
        match (self.knots.get(guess), self.knots.get(guess + 1)) {
            (Some(left), Some(right)) if *left <= x && x < *right => guess + 1,
            _ => self.knots.partition_point(|knot| *knot <= x),
        }
    }
}
