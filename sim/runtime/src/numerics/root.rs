//! Roots of a function of one variable in a bracket.

/// A root of `f` in [0, 1], where `at_zero` and `at_one`, its values at the ends, differ in sign; to `tolerance`
/// in the argument.
///
/// Chandrupatla's method (Advances in Engineering Software 28, 1997): bisection, or inverse quadratic interpolation
/// where that is certain to be better.
///
/// # Errors
/// The first error of `f`.
pub(crate) fn find_root<E>(
    at_zero: f64,
    at_one: f64,
    tolerance: f64,
    f: &mut dyn FnMut(f64) -> Result<f64, E>,
) -> Result<f64, E> {
    let (mut a, mut fa) = (1.0, at_one);
    let (mut b, mut fb) = (0.0, at_zero);
    let mut fraction = 0.5;
    // Bisection alone needs 53 halvings for the last bit; interpolation never takes more than three times that.
    for _ in 0..160 {
        let x = a + fraction * (b - a);
        let fx = f(x)?;
        let (c, fc) = if (fx > 0.0) == (fa > 0.0) { (a, fa) } else { (b, std::mem::replace(&mut fb, fa)) };
        if c == b {
            b = a;
        }
        (a, fa) = (x, fx);
        let best = if fa.abs() < fb.abs() { a } else { b };
        let width = (b - a).abs();
        if width <= tolerance || fa == 0.0 || fb == 0.0 {
            return Ok(best);
        }
        let (xi, phi) = ((a - b) / (c - b), (fa - fb) / (fc - fb));
        let interpolates = phi * phi < xi && (1.0 - phi) * (1.0 - phi) < 1.0 - xi;
        fraction = match interpolates {
            true => fa / (fb - fa) * fc / (fb - fc) + (c - a) / (b - a) * fa / (fc - fa) * fb / (fc - fb),
            false => 0.5,
        };
        let least = (tolerance / width / 2.0).min(0.5);
        fraction = fraction.clamp(least, 1.0 - least);
    }
    Ok(if fa.abs() < fb.abs() { a } else { b })
}

/// The place in [0, 1] of a minimum of `f`, and the value there; exact to about the root of the rounding of `f`.
///
/// Golden section: 40 evaluations narrow the interval to 5e-9.
///
/// # Errors
/// The first error of `f`.
pub(crate) fn find_minimum<E>(f: &mut dyn FnMut(f64) -> Result<f64, E>) -> Result<(f64, f64), E> {
    let golden = (5f64.sqrt() - 1.0) / 2.0;
    let (mut a, mut b) = (0.0, 1.0);
    let (mut x, mut y) = (1.0 - golden, golden);
    let (mut fx, mut fy) = (f(x)?, f(y)?);
    for _ in 0..40 {
        if fx < fy {
            (b, y, fy) = (y, x, fx);
            x = b - golden * (b - a);
            fx = f(x)?;
        } else {
            (a, x, fx) = (x, y, fy);
            y = a + golden * (b - a);
            fy = f(y)?;
        }
    }
    Ok(if fx < fy { (x, fx) } else { (y, fy) })
}

#[cfg(test)]
mod tests {
    use super::{find_minimum, find_root};

    #[test]
    fn roots_are_found_to_the_tolerance() {
        type Case = (fn(f64) -> f64, f64);
        let functions: [Case; 5] = [
            (|x| x - 0.3, 0.3),
            (|x| x * x * x - 0.2, 0.2f64.cbrt()),
            (|x| (3.0 * x).cos(), std::f64::consts::PI / 6.0),
            (|x| 1e-9 - x, 1e-9),
            (|x| (x - 0.7).powi(3), 0.7),
        ];
        for (at, (f, root)) in functions.into_iter().enumerate() {
            let mut calls = 0;
            let found = find_root(f(0.0), f(1.0), 1e-14, &mut |x| {
                calls += 1;
                Ok::<f64, ()>(f(x))
            });
            assert!((found.unwrap() - root).abs() < 2e-14 && calls < 60, "{at}: {found:?} after {calls}");
        }
    }

    #[test]
    fn minima_are_found_to_the_root_of_rounding() {
        let (place, value) = find_minimum(&mut |x: f64| Ok::<f64, ()>((x - 0.3).powi(2) + 2.0)).unwrap();
        assert!((place - 0.3).abs() < 1e-7 && value - 2.0 < 1e-14, "{place} {value}");
    }
}
