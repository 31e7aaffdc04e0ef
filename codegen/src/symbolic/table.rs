//! Functions given by rows: cubic pieces between knots.

/// A function of one argument in pieces: lines, or cubics.
#[derive(Clone, PartialEq, Debug)]
pub struct Table {
    /// Its name.
    pub name: String,
    /// Documentation.
    pub docs: String,
    /// Where pieces join, n of them, increasing.
    pub knots: Vec<f64>,
    /// n + 1 pieces `[c0, c1, c2, c3]`, one before the first knot and one from each on: c0 + c1 u + c2 u^2 + c3 u^3
    /// with u the distance from the knot where the piece starts; for the first piece, from the first knot.
    pub pieces: Vec<[f64; 4]>,
    /// Whether the pieces between the first and the last knot repeat themselves.
    pub is_periodic: bool,
    /// The order of the highest derivative that is not zero: 1 of lines, 3 of cubics.
    pub degree: u8,
    /// The number of derivatives that are continuous where pieces join.
    pub smoothness: u8,
}

/// A table of a [`Graph`](super::Graph).
#[derive(Clone, Copy, PartialEq, Eq, Hash, PartialOrd, Ord, Debug)]
pub struct TableId(pub(super) u32);

impl TableId {
    /// Its place among the tables of the graph.
    pub fn index(self) -> usize {
        self.0 as usize
    }
}

impl Table {
    /// The derivative of some order at x; at a knot that of the piece to the right.
    pub fn derivative(&self, order: u8, x: f64) -> f64 {
        let (knots, period) = (&self.knots, self.period());
        let turns = period.map_or(0.0, |period| ((x - knots[0]) / period).floor() * period);
        let place = knots.iter().take_while(|knot| **knot <= x - turns).count();
        let place = if self.is_periodic { place.clamp(1, knots.len() - 1) } else { place };
        let [c0, c1, c2, c3] = self.pieces[place];
        let u = x - (self.start(place) + turns);
        match order {
            0 => c0 + u * (c1 + u * (c2 + u * c3)),
            1 => c1 + u * (2.0 * c2 + u * (3.0 * c3)),
            2 => 2.0 * c2 + u * (6.0 * c3),
            3 => 6.0 * c3,
            _ => 0.0,
        }
    }

    /// The knot that a piece is written from.
    pub fn start(&self, place: usize) -> f64 {
        self.knots[place.saturating_sub(1)]
    }

    /// The distance of the last knot from the first, if the function repeats itself after it.
    pub fn period(&self) -> Option<f64> {
        self.is_periodic.then(|| self.knots[self.knots.len() - 1] - self.knots[0])
    }
}
