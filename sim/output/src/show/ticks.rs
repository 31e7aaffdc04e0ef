//! Axes: their range, and round ticks whose labels are exact decimals.

use super::text::{decimal, power_of_ten};

/// Values from here on count as infinite.
const HUGE: f64 = 1e300;

/// Degrees.
const TURN: i64 = 360;

/// Below this share of the values, their differences are rounding.
const ROUNDING: f64 = 1e-12;

/// Axes have so many ticks at least, if there is room for them.
pub(super) const FEW: usize = 3;

/// What steps of ticks are round in.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(super) enum Round {
    /// 1, 2, 5 and 10.
    Decimals,
    /// The same up to ten degrees, then parts and multiples of a turn.
    Degrees,
}

impl Round {
    /// What suits an axis with this label: `angle [deg]`.
    pub(super) fn of(label: &str) -> Round {
        if label.ends_with("[deg]") && label.matches('[').count() == 1 { Round::Degrees } else { Round::Decimals }
    }
}

/// A range and its ticks.
#[derive(Clone, Debug)]
pub(super) struct Axis {
    /// Its least value.
    pub(super) low: f64,
    /// Its greatest value.
    pub(super) high: f64,
    /// Its ticks, in order.
    pub(super) ticks: Vec<Tick>,
    /// The factor and offset of the labels, if any: `×10³ + 2`.
    pub(super) note: Option<String>,
}

impl Axis {
    /// A range without ticks.
    pub(super) fn bare((low, high): (f64, f64)) -> Axis {
        Axis { low, high, ticks: Vec::new(), note: None }
    }

    /// The same ticks without labels.
    pub(super) fn without_labels(&self) -> Axis {
        let ticks = self.ticks.iter().map(|tick| Tick { at: tick.at, label: String::new() }).collect();
        Axis { ticks, note: None, ..*self }
    }
}

/// A tick.
#[derive(Clone, Debug)]
pub(super) struct Tick {
    /// Its value.
    pub(super) at: f64,
    /// Its label.
    pub(super) label: String,
}

/// Whether a value can be shown.
pub(super) fn shown(value: f64) -> bool {
    value.abs() < HUGE
}

/// The range of the finite values, if there are any, widened around a constant.
pub(super) fn range(values: impl Iterator<Item = f64>) -> Option<(f64, f64)> {
    let (low, high) = values
        .filter(|value| shown(*value))
        .fold((f64::INFINITY, f64::NEG_INFINITY), |(low, high), value| (low.min(value), high.max(value)));
    if low > high {
        return None;
    }
    let size = low.abs().max(high.abs());
    if high - low > ROUNDING * size && high - low > 1e-290 {
        return Some((low, high));
    }
    let (middle, half) = (low / 2.0 + high / 2.0, if size < 1e-280 { 1.0 } else { 0.1 * size });
    Some((middle - half, middle + half))
}

/// The range with this share of it added at both ends.
pub(super) fn padded((low, high): (f64, f64), share: f64) -> (f64, f64) {
    let more = share * (high - low);
    (low - more, high + more)
}

impl Axis {
    /// An axis over a range, with ticks at least this far apart.
    pub(super) fn new((low, high): (f64, f64), apart: f64, round: Round) -> Self {
        let (unit, exponent) = step(apart, round);
        let step = unit as f64 * ten_to(exponent);
        let first = (low / step - 1e-6).ceil() as i64;
        let last = (high / step + 1e-6).floor() as i64;
        let counts: Vec<i64> = (first..=last).map(|count| count.saturating_mul(unit)).collect();
        let base = base(&counts);
        let farthest = counts.iter().map(|count| (count - base).unsigned_abs()).max().unwrap_or(0);
        let factor = factor(farthest, exponent);
        let ticks = counts
            .iter()
            .map(|count| Tick { at: scaled(*count, exponent), label: decimal(count - base, exponent - factor) });
        Axis { low, high, ticks: ticks.collect(), note: note(factor, base, exponent) }
    }

    /// An axis that is so long on the sheet, with ticks so far apart there. Where they would be few, they are nearer to each
    /// other, but no nearer than the last distance.
    pub(super) fn fitted(range: (f64, f64), length: f64, (wanted, least): (f64, f64), round: Round) -> Self {
        let unit = (range.1 - range.0) / length;
        let mut apart = wanted;
        loop {
            let axis = Axis::new(range, apart * unit, round);
            if axis.ticks.len() >= FEW || apart <= least {
                return axis;
            }
            apart = (apart - 1.0).max(least);
        }
    }

    /// The position of a value between its ends, 0 and 1.
    pub(super) fn share(&self, value: f64) -> f64 {
        (value - self.low) / (self.high - self.low)
    }
}

/// The least round step that is no less than a distance: a number, and the power of ten to multiply it with.
fn step(apart: f64, round: Round) -> (i64, i32) {
    const DEGREES: [i64; 6] = [15, 30, 45, 90, 180, TURN];
    let decimals = decimal_step(apart);
    if round == Round::Decimals || scaled(decimals.0, decimals.1) <= 10.0 {
        return decimals;
    }
    let part = DEGREES.into_iter().find(|step| *step as f64 >= apart * (1.0 - 1e-9));
    part.map_or_else(
        || {
            let (turns, exponent) = decimal_step(apart / TURN as f64);
            (TURN * turns, exponent)
        },
        |step| (step, 0),
    )
}

/// The least of 1, 2, 5 and 10 times a power of ten that is no less than a distance.
fn decimal_step(apart: f64) -> (i64, i32) {
    let exponent = apart.log10().floor() as i32;
    let unit = [1, 2, 5].into_iter().find(|unit| *unit as f64 * ten_to(exponent) >= apart * (1.0 - 1e-9));
    unit.map_or((1, exponent + 1), |unit| (unit, exponent))
}

fn ten_to(exponent: i32) -> f64 {
    10_f64.powi(exponent)
}

/// The number count · 10^exponent, rounded once where powers of ten are exact.
fn scaled(count: i64, exponent: i32) -> f64 {
    if exponent < 0 { count as f64 / ten_to(-exponent) } else { count as f64 * ten_to(exponent) }
}

/// The offset moved from the labels to the note: none, unless they would differ only from the seventh digit on.
fn base(counts: &[i64]) -> i64 {
    let (Some(first), Some(last)) = (counts.first(), counts.last()) else { return 0 };
    let size = first.unsigned_abs().max(last.unsigned_abs());
    if size < 1_000_000 || last.abs_diff(*first) > size / 1000 { 0 } else { counts[counts.len() / 2] }
}

/// The power of a thousand moved out of labels up to a count.
fn factor(farthest: u64, exponent: i32) -> i32 {
    let magnitude = farthest.checked_ilog10().map_or(0, |digits| digits as i32 + exponent);
    if (-3..5).contains(&magnitude) { 0 } else { 3 * magnitude.div_euclid(3) }
}

fn note(factor: i32, base: i64, exponent: i32) -> Option<String> {
    let times = (factor != 0).then(|| format!("×{}", power_of_ten(factor)));
    let sign = if base < 0 { '\u{2212}' } else { '+' };
    let plus = (base != 0).then(|| format!("{sign} {}", magnitude(base.saturating_abs(), exponent)));
    match (times, plus) {
        (Some(times), Some(plus)) => Some(format!("{times} {plus}")),
        (times, plus) => times.or(plus),
    }
}

/// A number of many digits, with a power of ten if it is very large or small.
fn magnitude(mut digits: i64, mut exponent: i32) -> String {
    while digits % 10 == 0 && digits != 0 {
        digits /= 10;
        exponent += 1;
    }
    let places = digits.checked_ilog10().map_or(0, |places| places as i32);
    if (-6..12).contains(&(places + exponent)) {
        decimal(digits, exponent)
    } else {
        format!("{}·{}", decimal(digits, -places), power_of_ten(places + exponent))
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    fn labels(low: f64, high: f64, most: f64) -> Vec<String> {
        let axis = Axis::new((low, high), (high - low) / most, Round::Decimals);
        axis.ticks.into_iter().map(|tick| tick.label).collect()
    }

    fn note(low: f64, high: f64) -> Option<String> {
        Axis::new((low, high), (high - low) / 6.0, Round::Decimals).note
    }

    #[test]
    fn ticks_are_round_and_exact() {
        assert_eq!(labels(0.0, 0.5, 5.0), ["0.0", "0.1", "0.2", "0.3", "0.4", "0.5"]);
        assert_eq!(labels(-1.04, 1.04, 6.0), ["−1.0", "−0.5", "0.0", "0.5", "1.0"]);
        assert_eq!(labels(0.0, 24_000.0, 6.0), ["0", "5000", "10\u{2009}000", "15\u{2009}000", "20\u{2009}000"]);
        let axis = Axis::new((0.0, 1.0), 0.1, Round::Decimals);
        assert_eq!(axis.ticks[3].at, 0.3);
    }

    #[test]
    fn large_and_small_values_share_a_factor() {
        assert_eq!(labels(0.0, 2.5e6, 6.0), ["0.0", "0.5", "1.0", "1.5", "2.0", "2.5"]);
        assert_eq!(note(0.0, 2.5e6).as_deref(), Some("×10⁶"));
        assert_eq!(labels(0.0, 3e-6, 3.0), ["0", "1", "2", "3"]);
        assert_eq!(note(0.0, 3e-6).as_deref(), Some("×10⁻⁶"));
        assert_eq!(note(0.0, 25_000.0), None);
        assert_eq!(note(0.0, 1e-2), None);
    }

    #[test]
    fn small_differences_of_large_values_keep_their_labels_apart() {
        let (low, high) = (12.345_678, 12.345_678_000_4);
        let labels = labels(low, high, 6.0);
        assert!(labels.len() >= 3, "{labels:?}");
        assert!(labels.windows(2).all(|pair| pair[0] != pair[1]), "{labels:?}");
        assert!(labels.iter().all(|label| label.chars().count() <= 6), "{labels:?}");
        assert_eq!(note(low, high).as_deref(), Some("×10⁻¹² + 12.3456780002"));
    }

    #[test]
    fn every_range_has_a_few_distinct_ticks() {
        let mut seed = 1_u64;
        for _ in 0..20_000 {
            let mut random = || {
                seed = seed.wrapping_mul(6_364_136_223_846_793_005).wrapping_add(1_442_695_040_888_963_407);
                (seed >> 11) as f64 / (1_u64 << 53) as f64
            };
            let middle = (random() - 0.5) * 10_f64.powf(600.0 * random() - 300.0);
            let half = middle.abs() * 10_f64.powf(-11.5 * random());
            let Some((low, high)) = range([middle - half, middle + half].into_iter()) else { continue };
            for round in [Round::Decimals, Round::Degrees] {
                let axis = Axis::new((low, high), (high - low) / 6.0, round);
                assert!((2..=8).contains(&axis.ticks.len()), "{low:e} {high:e} {axis:?}");
                for pair in axis.ticks.windows(2) {
                    assert!(pair[0].label != pair[1].label && pair[0].at < pair[1].at, "{low:e} {high:e} {axis:?}");
                }
                assert!(axis.ticks.iter().all(|tick| tick.label.chars().count() <= 12), "{low:e} {high:e} {axis:?}");
            }
        }
    }

    /// Ticks as many as there are places for, over a range that begins at 0.
    fn degrees(high: f64, most: f64) -> Vec<String> {
        Axis::new((0.0, high), high / most, Round::Degrees).ticks.into_iter().map(|tick| tick.label).collect()
    }

    #[test]
    fn ticks_of_angles_are_parts_of_a_turn() {
        assert_eq!(degrees(360.0, 8.0), ["0", "45", "90", "135", "180", "225", "270", "315", "360"]);
        assert_eq!(degrees(360.0, 5.0), ["0", "90", "180", "270", "360"]);
        assert_eq!(degrees(360.0, 2.0), ["0", "180", "360"]);
        assert_eq!(degrees(130.0, 5.0), ["0", "30", "60", "90", "120"]);
        assert_eq!(degrees(60.0, 5.0), ["0", "15", "30", "45", "60"]);
        assert_eq!(degrees(40.0, 5.0), ["0", "10", "20", "30", "40"]);
        assert_eq!(degrees(8.0, 5.0), ["0", "2", "4", "6", "8"]);
        assert_eq!(degrees(0.4, 5.0), ["0.0", "0.1", "0.2", "0.3", "0.4"]);
        assert_eq!(degrees(3600.0, 6.0), ["0", "720", "1440", "2160", "2880", "3600"]);
        assert_eq!([Round::of("angle [deg]"), Round::of("[deg]")], [Round::Degrees; 2]);
        assert_eq!([Round::of("speed [deg/s]"), Round::of("both [m], [deg]"), Round::of("")], [Round::Decimals; 3]);
    }

    /// The next step may be two and a half times as far: of three ticks two are certain in a hundred pixels.
    #[test]
    fn every_panel_has_ticks() {
        for round in [Round::Decimals, Round::Degrees] {
            for size in (0..4000).map(|step| 10_f64.powf(f64::from(step) / 500.0 - 4.0)) {
                for (from, length, least) in [(-0.3, 101.0, 2), (0.0, 101.0, 2), (0.37, 151.0, FEW), (-1.0, 600.0, FEW)]
                {
                    let axis = Axis::fitted((from * size, (from + 1.0) * size), length, (42.0, 20.0), round);
                    assert!(axis.ticks.len() >= least, "{size} {length}: {axis:?}");
                    let pixels = |tick: &Tick| length * axis.share(tick.at);
                    let apart = axis.ticks.windows(2).map(|pair| pixels(&pair[1]) - pixels(&pair[0]));
                    assert!(apart.fold(f64::INFINITY, f64::min) >= 19.99, "{size} {length}: {axis:?}");
                }
            }
        }
    }

    #[test]
    fn constants_get_a_range() {
        assert_eq!(range([5.0, 5.0].into_iter()), Some((4.5, 5.5)));
        assert_eq!(range([0.0].into_iter()), Some((-1.0, 1.0)));
        assert_eq!(range([f64::NAN, f64::INFINITY].into_iter()), None);
        assert_eq!(range([f64::NAN, 1.0, f64::NEG_INFINITY, 3.0].into_iter()), Some((1.0, 3.0)));
        let (low, high) = range([0.1 + 0.2, 0.3].into_iter()).unwrap();
        assert!(high - low > 0.01);
    }
}
