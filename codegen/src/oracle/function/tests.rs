//! The table of derivatives against dual numbers of third order.

use super::{Derivatives, elementary, power, reciprocal};
use num_dual::{Dual3_64, DualNum, third_derivative};

/// Both sides take at most some ten operations of half an ulp, and the argument is felt through the next derivative:
/// 1e-14 of the derivatives' sizes together covers both.
#[track_caller]
fn assert_table(found: Derivatives, function: impl Fn(Dual3_64) -> Dual3_64, u: f64, what: &str) {
    let (f, f1, f2, f3) = third_derivative(function, u);
    let size: f64 = found.iter().map(|derivative| derivative.abs()).sum();
    for (order, (found, expected)) in found.iter().zip([f, f1, f2, f3]).enumerate() {
        let error = (found - expected).abs();
        assert!(error <= 1e-14 * size, "derivative {order} of {what} at {u}: {found} is not {expected}");
    }
}

#[test]
fn three_derivatives_of_every_function() -> Result<(), String> {
    type Function = fn(Dual3_64) -> Dual3_64;
    let functions: [(&str, Function); 14] = [
        ("sin", |u| u.sin()),
        ("cos", |u| u.cos()),
        ("tan", |u| u.tan()),
        ("asin", |u| u.asin()),
        ("acos", |u| u.acos()),
        ("atan", |u| u.atan()),
        ("sinh", |u| u.sinh()),
        ("cosh", |u| u.cosh()),
        ("tanh", |u| u.tanh()),
        ("exp", |u| u.exp()),
        ("ln", |u| u.ln()),
        ("sqrt", |u| u.sqrt()),
        ("abs", |u| u * u.re.signum()),
        ("sign", |u| Dual3_64::from(u.re.signum())),
    ];
    for (name, function) in functions {
        for u in [-0.9, -0.5, -0.01, 0.02, 0.3, 0.7, 0.95].into_iter().filter(|u| *u > 0.0 || !"ln sqrt".contains(name))
        {
            let found = elementary(name, u).ok_or(format!("no {name}"))?;
            assert_table(found, function, u, name);
        }
    }
    assert!(elementary("cosine", 0.3).is_none());
    Ok(())
}

#[test]
fn three_derivatives_of_powers() {
    for u in [-1.7, -0.4, 0.3, 1.0, 2.5] {
        assert_table(reciprocal(u), |u| u.recip(), u, "1/u");
        for exponent in [-3, -2, -1, 0, 1, 2, 3, 4, 7] {
            assert_table(power(u, exponent.into()), |u| u.powi(exponent), u, "an integer power");
        }
    }
    for u in [0.3, 1.0, 2.5] {
        for exponent in [-1.5, 0.5, 1.0 / 3.0, 2.2] {
            assert_table(power(u, exponent), |u| u.powf(exponent), u, "a real power");
        }
    }
}

/// Where a factor of the derivative of u^n is zero, it stays zero at u = 0.
#[test]
fn powers_at_zero() {
    assert_eq!(power(0.0, 0.0), [1.0, 0.0, 0.0, 0.0]);
    assert_eq!(power(0.0, 1.0), [0.0, 1.0, 0.0, 0.0]);
    assert_eq!(power(0.0, 2.0), [0.0, 0.0, 2.0, 0.0]);
    assert_eq!(elementary("abs", 0.0), Some([0.0; 4]));
    assert_eq!(elementary("sign", 0.0), Some([0.0; 4]));
}
