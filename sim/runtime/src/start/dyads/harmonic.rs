//! Functions of one coordinate in constraints: of an angle, a + b cos + c sin; of a length, a + b s.

use std::f64::consts::{FRAC_PI_2, PI, TAU};

/// The residual, relative to the largest coefficient, above which a function does not have the fitted form.
const ROUNDING: f64 = 1e-12;
/// A cosine this little above 1 counts as 1: the links only just reach each other.
const STRETCHED: f64 = 1e-12;

/// A function of an angle without its constant: cosine cos + sine sin.
#[derive(Clone, Copy, Debug)]
pub(super) struct Harmonic {
    pub(super) cosine: f64,
    pub(super) sine: f64,
}

/// Such a function and its constant, if it is one.
pub(super) fn fit_harmonic(f: &dyn Fn(f64) -> f64) -> Option<(Harmonic, f64)> {
    let (front, back) = (f(0.0), f(PI));
    let constant = (front + back) / 2.0;
    let fitted = Harmonic { cosine: (front - back) / 2.0, sine: f(FRAC_PI_2) - constant };
    let size = constant.abs() + fitted.cosine.abs() + fitted.sine.abs();
    let is_fitted =
        |x: f64| (constant + fitted.cosine * x.cos() + fitted.sine * x.sin() - f(x)).abs() <= ROUNDING * size;
    [0.7, 2.5, 4.3].into_iter().all(is_fitted).then_some((fitted, constant))
}

/// The slope and the constant of a function of a length, if it is linear.
pub(super) fn fit_linear(f: &dyn Fn(f64) -> f64) -> Option<(f64, f64)> {
    let constant = f(0.0);
    let slope = f(1.0) - constant;
    let size = constant.abs() + slope.abs();
    let is_fitted = |x: f64| (constant + slope * x - f(x)).abs() <= 4.0 * ROUNDING * size;
    [-2.7, 0.3].into_iter().all(is_fitted).then_some((slope, constant))
}

/// The angles where a function is `value`, within half a turn of a guess: two, one, or none. `None` where it is a constant.
pub(super) fn angles(of: Harmonic, value: f64, guess: f64) -> Option<Vec<f64>> {
    let amplitude = of.cosine.hypot(of.sine);
    if !(amplitude > ROUNDING * value.abs()) {
        return None;
    }
    let cosine = value / amplitude;
    if cosine.abs() > 1.0 + STRETCHED {
        return Some(Vec::new());
    }
    let (middle, half) = (of.sine.atan2(of.cosine), cosine.clamp(-1.0, 1.0).acos());
    let both = [middle + half, middle - half].map(|angle| near(angle, guess));
    Some(if half == 0.0 || half == PI { vec![both[0]] } else { both.to_vec() })
}

/// The same angle within half a turn of another.
pub(super) fn near(angle: f64, guess: f64) -> f64 {
    angle - ((angle - guess) / TAU).round() * TAU
}
