//! Dense output: polynomials of the integrated variables over a step, in nested form.

use crate::motion::Motion;
use crate::state::trajectory::{Rates, Sample};
use sim_kernel::{Array, Mechanism};

/// The coefficients of the cubic that has the values and rates of both ends.
pub(super) fn cubic<M: Mechanism>(
    motion: &Motion<M>,
    [from, to]: [&Sample<M>; 2],
    ends: [&Rates<M>; 2],
) -> [Rates<M>; 3] {
    let h = to.state.time - from.state.time;
    let [start, end] = [from, to].map(|sample| motion.integrated(&sample.state));
    let difference = end.change_from(&start);
    let mut second = ends[0].scaled(h);
    second.add(-1.0, &difference);
    let mut third = difference.clone();
    third.add(-h, ends[1]);
    third.add(-1.0, &second);
    [difference, second, third]
}

/// The change from the start at a fraction s: s (c0 + r (c1 + s (c2 + r (c3 + ..)))), r = 1 - s.
pub(super) fn nested<M: Mechanism>(coefficients: &[Rates<M>], s: f64) -> Rates<M> {
    let factors = [s, 1.0 - s];
    let mut sum = Rates::zero(coefficients.first().map_or(0, |first| first.speeds.len()));
    for (k, coefficient) in coefficients.iter().enumerate().rev() {
        sum.add(1.0, coefficient);
        sum.scale(factors[k % 2]);
    }
    sum
}
