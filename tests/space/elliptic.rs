//! Jacobi's elliptic functions, by the arithmetic-geometric mean (Abramowitz and Stegun, Handbook of Mathematical Functions,
//! 16.4 and 17.6).

use std::f64::consts::PI;

/// The scale of the arithmetic-geometric mean of 1 and sqrt(1 - k^2): a and c, step by step.
fn scale(k: f64) -> Vec<(f64, f64)> {
    let (mut a, mut b, mut c) = (1.0f64, (1.0 - k * k).sqrt(), k);
    let mut scale = vec![(a, c)];
    while c.abs() > 1e-17 {
        (a, b, c) = ((a + b) / 2.0, (a * b).sqrt(), (a - b) / 2.0);
        scale.push((a, c));
        if scale.len() > 12 {
            break;
        }
    }
    scale
}

/// K(k), a quarter of the period.
pub(crate) fn quarter(k: f64) -> f64 {
    PI / (2.0 * scale(k).last().unwrap().0)
}

/// sn, cn and dn of u, at modulus k.
pub(crate) fn jacobi(u: f64, k: f64) -> [f64; 3] {
    let scale = scale(k);
    let n = scale.len() - 1;
    let mut phi = scale[n].0 * u * f64::powi(2.0, n as i32);
    for (a, c) in scale[1..].iter().rev() {
        phi = (phi + (c / a * phi.sin()).asin()) / 2.0;
    }
    let (sn, cn) = phi.sin_cos();
    [sn, cn, (1.0 - (k * sn).powi(2)).sqrt()]
}

#[test]
fn limits_and_identities() {
    // At k = 0 the circle, at k -> 1 hyperbolic functions; K(sqrt(1/2)) is Gauss's.
    assert!((quarter(0.5f64.sqrt()) - 1.854_074_677_301_371_9).abs() < 1e-15);
    for u in [0.1, 0.7, 2.9] {
        let [sn, cn, dn] = jacobi(u, 0.0);
        assert!((sn - f64::sin(u)).abs() + (cn - f64::cos(u)).abs() + (dn - 1.0).abs() < 1e-14);
        let [sn, cn, _] = jacobi(u, 0.8);
        let half = jacobi(u + 2.0 * quarter(0.8), 0.8);
        assert!((half[0] + sn).abs() + (half[1] + cn).abs() < 1e-13);
    }
    let [sn, cn, _] = jacobi(1.0, 1.0 - 1e-13);
    assert!((sn - 1f64.tanh()).abs() + (cn - 1.0 / 1f64.cosh()).abs() < 1e-11);
}
