//! The functions of the language with their first three derivatives.
//!
//! The second derivative makes the Hessian of a jet; the third serves only the magnitude of that Hessian.

/// f, f', f'' and f''' at one point.
pub(super) type Derivatives = [f64; 4];

/// The function of one argument with this name, at `u`; `None` if the language has none of that name.
pub(super) fn elementary(name: &str, u: f64) -> Option<Derivatives> {
    let (sin, cos) = u.sin_cos();
    Some(match name {
        "sin" => [sin, cos, -sin, -cos],
        "cos" => [cos, -sin, -cos, sin],
        "tan" => tangent(u.tan()),
        "asin" => arc_sine(u),
        "acos" => arc_cosine(u),
        "atan" => arctangent(u),
        "sinh" => [u.sinh(), u.cosh(), u.sinh(), u.cosh()],
        "cosh" => [u.cosh(), u.sinh(), u.cosh(), u.sinh()],
        "tanh" => hyperbolic_tangent(u),
        "exp" => exponential(u),
        "ln" => logarithm(u),
        "sqrt" => square_root(u),
        "abs" => [u.abs(), sign(u), 0.0, 0.0],
        "sign" => [sign(u), 0.0, 0.0, 0.0],
        _ => return None,
    })
}

/// Whether the language has a function of this name that takes plain numbers.
pub(super) fn is_function(name: &str) -> bool {
    elementary(name, 0.0).is_some() || ["atan2", "min", "max", "norm", "inner"].contains(&name)
}

/// 1/u.
pub(super) fn reciprocal(u: f64) -> Derivatives {
    let r = 1.0 / u;
    [r, -r * r, 2.0 * r * r * r, -6.0 * r * r * r * r]
}

/// e^u.
pub(super) fn exponential(u: f64) -> Derivatives {
    [u.exp(); 4]
}

/// The natural logarithm.
pub(super) fn logarithm(u: f64) -> Derivatives {
    [u.ln(), 1.0 / u, -1.0 / (u * u), 2.0 / (u * u * u)]
}

/// The arc tangent.
pub(super) fn arctangent(u: f64) -> Derivatives {
    let w = 1.0 / (1.0 + u * u);
    [u.atan(), w, -2.0 * u * w * w, (6.0 * u * u - 2.0) * w.powi(3)]
}

/// u^exponent for an exponent that does not vary: repeated multiplication if it is an integer, else real (NaN for u < 0).
pub(super) fn power(u: f64, exponent: f64) -> Derivatives {
    let falling = [1.0, exponent, exponent * (exponent - 1.0), exponent * (exponent - 1.0) * (exponent - 2.0)];
    let term = |k: usize| if falling[k] == 0.0 { 0.0 } else { falling[k] * real_power(u, exponent - k as f64) };
    [term(0), term(1), term(2), term(3)]
}

fn real_power(u: f64, exponent: f64) -> f64 {
    if exponent.fract() == 0.0 && exponent.abs() <= f64::from(i32::MAX) {
        u.powi(exponent as i32)
    } else {
        u.powf(exponent)
    }
}

fn sign(u: f64) -> f64 {
    if u == 0.0 { 0.0 } else { u.signum() }
}

fn tangent(tan: f64) -> Derivatives {
    let slope = 1.0 + tan * tan;
    [tan, slope, 2.0 * tan * slope, 2.0 * slope * (1.0 + 3.0 * tan * tan)]
}

fn arc_sine(u: f64) -> Derivatives {
    let w = 1.0 / ((1.0 - u) * (1.0 + u)).sqrt();
    [u.asin(), w, u * w.powi(3), (1.0 + 2.0 * u * u) * w.powi(5)]
}

fn arc_cosine(u: f64) -> Derivatives {
    let [_, first, second, third] = arc_sine(u);
    [u.acos(), -first, -second, -third]
}

fn hyperbolic_tangent(u: f64) -> Derivatives {
    let tanh = u.tanh();
    let slope = 1.0 / u.cosh().powi(2);
    [tanh, slope, -2.0 * tanh * slope, slope * (6.0 * tanh * tanh - 2.0)]
}

fn square_root(u: f64) -> Derivatives {
    let root = u.sqrt();
    [root, 0.5 / root, -0.25 / (root * u), 0.375 / (root * u * u)]
}

#[cfg(test)]
mod tests;
