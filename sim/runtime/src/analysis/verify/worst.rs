//! The largest of several figures.

/// A figure and where it is.
#[derive(Clone, Debug, Default)]
pub(super) struct Worst<W> {
    pub(super) figure: f64,
    pub(super) at: W,
}

impl<W> Worst<W> {
    /// Enters a figure. NaN counts as infinite: `f64::max` would drop it, and so would a comparison.
    pub(super) fn enter(&mut self, figure: f64, at: W) {
        let figure = if figure.is_nan() { f64::INFINITY } else { figure };
        if figure > self.figure {
            (self.figure, self.at) = (figure, at);
        }
    }
}

/// `part` of `size`; 0 of nothing.
pub(super) fn relative(part: f64, size: f64) -> f64 {
    if part == 0.0 { 0.0 } else { part / size }
}

/// The largest magnitude; NaN and infinities show in the figures that they affect.
pub(super) fn largest(values: impl Iterator<Item = f64>) -> f64 {
    values.filter(|value| value.is_finite()).fold(0.0, |largest: f64, value| largest.max(value.abs()))
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn what_has_no_value_is_worst_whatever_follows() {
        let mut worst = Worst::<usize>::default();
        [1.0, f64::NAN, 2.0].into_iter().enumerate().for_each(|(at, figure)| worst.enter(figure, at));
        assert_eq!((worst.figure, worst.at), (f64::INFINITY, 1));
    }

    #[test]
    fn nothing_is_no_part_of_nothing() {
        assert_eq!([relative(0.0, 0.0), relative(1.0, 0.0), relative(1.0, 4.0)], [0.0, f64::INFINITY, 0.25]);
        assert!(relative(f64::NAN, 1.0).is_nan());
        assert_eq!(largest([-3.0, f64::NAN, 2.0].into_iter()), 3.0);
    }
}
