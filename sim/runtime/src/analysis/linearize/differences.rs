//! Derivatives by differences, of laws that may be smooth once but not twice.

use crate::state::failure::Failure;
use nalgebra::DVector;

/// The step of differences of fourth order, as a fraction of the scale of a variable: the fifth root of rounding.
const STEP: f64 = 1e-3;
/// Shorter steps, as parts of that, for laws that are not smooth. Quotients converge if each differs by less than this part of the
/// difference before.
const SHORTER: [f64; 8] = [1e-2, 1e-3, 1e-4, 1e-5, 1e-6, 1e-7, 1e-8, 1e-9];
const SHRINKS: f64 = 0.5;
/// The rounding of what is solved for, as a part of the largest, and how many times as much it may explain.
const LAST_DIGITS: f64 = 16.0 * f64::EPSILON;
const EXPLAINED: f64 = 10.0;
/// A derivative has not settled whose quotients differ by this part of it, or of a small part of the largest.
const COARSE: f64 = 1e-2;
const SMALL: f64 = 1e-3;

/// f'(0), of a variable of this scale.
pub(super) type Difference<'d> = dyn Fn(f64, &Solved) -> Result<DVector<f64>, Failure> + 'd;

/// What is solved for, so far from a state.
pub(super) type Solved<'s> = dyn Fn(f64) -> Result<DVector<f64>, Failure> + 's;

/// f'(0) by central differences of fourth order.
pub(super) fn quotient(size: f64, f: &Solved) -> Result<DVector<f64>, Failure> {
    let step = STEP * size;
    let apart = |steps: f64| Ok::<_, Failure>(f(steps * step)? - f(-steps * step)?);
    Ok((8.0 * apart(1.0)? - apart(2.0)?) / (12.0 * step))
}

/// f'(0), and whether it has settled. A smooth law has the quotient of fourth order. For one like x |x|, whose second derivative jumps,
/// quotients by shorter steps are better: their differences shrink with the step, until rounding explains them. The first entries of f
/// are so many accelerations.
pub(super) fn refined(size: f64, accelerations: usize, f: &Solved) -> Result<(DVector<f64>, bool), Failure> {
    let here = f(0.0)?;
    let (first, others) = (here.rows(0, accelerations), here.rows(accelerations, here.len() - accelerations));
    let largest = [&first, &others].map(|part| part.iter().fold(0.0, |most: f64, value| most.max(value.abs())));
    let rounding = |i: usize| LAST_DIGITS * largest[usize::from(i >= accelerations)];
    let mut best = quotient(size, f)?;
    let (mut last, mut left, far) = (best.clone(), vec![f64::INFINITY; best.len()], best.amax());
    let mut open: Vec<usize> = (0..best.len()).collect();
    for step in SHORTER.map(|shorter| shorter * STEP * size) {
        let next: DVector<f64> = (f(step)? - f(-step)?) / (2.0 * step);
        open.retain(|i| {
            let differ = (next[*i] - last[*i]).abs();
            let (shrinks, is_explained) = (differ < SHRINKS * left[*i], differ <= EXPLAINED * rounding(*i) / step);
            if shrinks {
                best[*i] = last[*i];
            }
            left[*i] = if is_explained { 0.0 } else { left[*i].min(differ) };
            shrinks && !is_explained
        });
        if open.is_empty() {
            break;
        }
        last = next;
    }
    let enough = SMALL * best.amax().max(far);
    let has_settled = (0..best.len()).all(|i| left[i] <= COARSE * best[i].abs().max(enough));
    Ok((best, has_settled))
}
