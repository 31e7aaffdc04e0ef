//! Smooth functions from values of unequal accuracy.

use sim_kernel::Array;

/// The largest number of values used.
pub(crate) const MOST_KNOWN: usize = 12;

/// Values at a fraction of an interval, with the inverse of their variance.
#[derive(Clone, Debug)]
pub(crate) struct Known<A> {
    pub(crate) fraction: f64,
    pub(crate) weight: f64,
    pub(crate) values: A,
}

/// The value, at another fraction, of the polynomial nearest to known values, with its approximate error. Terms are cut
/// where those on both sides of the cut are smallest.
///
/// Forsythe, Journal of the Society for Industrial and Applied Mathematics 5 (1957), pp. 74-88: polynomials that are orthogonal
/// over the fractions, by recurrence.
pub(crate) fn nearest_polynomial<A: Array<f64>>(
    known: &[Known<A>],
    at: f64,
    none: A,
    size: impl Fn(&A) -> f64,
) -> (A, f64) {
    // The last terms predict the first omitted one up to a factor.
    const DOUBT: f64 = 10.0;
    let (mut before, mut here) = ([0.0; MOST_KNOWN], [1.0; MOST_KNOWN]);
    let (mut before_at, mut here_at, mut norm_before) = (0.0, 1.0, f64::INFINITY);
    let (mut sum, mut last) = (none.clone(), f64::INFINITY);
    let mut best = (sum.clone(), f64::INFINITY);
    for _ in known {
        let weighed = |f: &dyn Fn(usize) -> f64| -> f64 {
            known.iter().enumerate().map(|(k, known)| known.weight * here[k] * f(k)).sum()
        };
        let norm = weighed(&|k| here[k]);
        let term = none.like(|i| weighed(&|k| known[k].values[i]) / norm * here_at);
        let found = size(&term);
        if found.max(last) < best.1 {
            best = (sum.clone(), found.max(last));
        }
        (sum, last) = (sum.like(|i| sum[i] + term[i]), found);
        let (middle, share) = (weighed(&|k| known[k].fraction * here[k]) / norm, norm / norm_before);
        let step = |x: f64, here: f64, before: f64| (x - middle) * here - share * before;
        let next = std::array::from_fn(|k| known.get(k).map_or(0.0, |known| step(known.fraction, here[k], before[k])));
        let next_at = step(at, here_at, before_at);
        (before, here, before_at, here_at, norm_before) = (here, next, here_at, next_at, norm);
    }
    (best.0, DOUBT * best.1)
}

#[cfg(test)]
mod tests {
    use super::*;

    fn known(values: impl Fn(f64) -> [f64; 2], weight: impl Fn(f64) -> f64) -> Vec<Known<[f64; 2]>> {
        let fractions = (0..MOST_KNOWN).map(|k| k as f64 / (MOST_KNOWN - 1) as f64);
        fractions.map(|fraction| Known { fraction, weight: weight(fraction), values: values(fraction) }).collect()
    }

    fn size(values: &[f64; 2]) -> f64 {
        values[0].abs().max(values[1].abs())
    }

    #[test]
    fn polynomials_are_found_and_what_is_left_over_is_foretold() {
        let cubic = |x: f64| [3.0 - x + 5.0 * x.powi(3), x * x];
        let (found, off) = nearest_polynomial(&known(cubic, |x| 1.0 + x), 0.43, [0.0; 2], size);
        let exact = cubic(0.43);
        assert!(size(&[found[0] - exact[0], found[1] - exact[1]]) < 1e-13 && off < 1e-12, "{found:?} {off:e}");
        // A sine is not a polynomial: the error is within the bound.
        let sine = |x: f64| [(3.0 * x).sin(), (3.0 * x).cos()];
        let (found, off) = nearest_polynomial(&known(sine, |_| 1.0), 0.43, [0.0; 2], size);
        let lacking = size(&[found[0] - sine(0.43)[0], found[1] - sine(0.43)[1]]);
        assert!(lacking < off && off < 1e-4, "{lacking:e} {off:e}");
    }

    /// Values in the middle have errors of 1e-3, and weights according to its square.
    #[test]
    fn what_is_known_badly_counts_for_little() {
        let is_bad = |x: f64| (x - 0.5).abs() < 0.15;
        let noisy = |x: f64| {
            let noise = if is_bad(x) { 1e-3 * (40.0 * x).sin() } else { 0.0 };
            [1.0 + x * x + noise, 0.0]
        };
        let weight = |x: f64| if is_bad(x) { 1e-16 } else { 1.0 };
        let (found, off) = nearest_polynomial(&known(noisy, weight), 0.5, [0.0; 2], size);
        assert!((found[0] - 1.25).abs() < 1e-9 && off < 1e-6, "{found:?} {off:e}");
    }
}
