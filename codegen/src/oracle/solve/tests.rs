use super::{Factors, residual};

type Outcome = Result<(), Box<dyn std::error::Error>>;

/// The Hilbert matrix of size 6 times 360360, so that its entries are integers: condition number 1.5e7.
fn hilbert() -> Vec<Vec<f64>> {
    (0..6).map(|i| (0..6).map(|j| 360_360.0 / f64::from(i + j + 1)).collect()).collect()
}

/// Elimination alone is off by 1.5e7 * 1e-16; one refinement with accurate residuals brings that below rounding.
#[test]
fn refinement_reaches_the_last_digits() -> Outcome {
    let exact = [1.0, -2.0, 3.0, -4.0, 5.0, -6.0];
    let right: Vec<f64> = hilbert().iter().map(|row| row.iter().zip(exact).map(|(a, x)| a * x).sum()).collect();
    let solution = Factors::new(hilbert())?.solve(&right);
    for (found, exact) in solution.iter().zip(exact) {
        assert!((found - exact).abs() <= 1e-15 * exact.abs(), "{solution:?}");
    }
    Ok(())
}

/// [2, 1, 0; 1, 0, 1; 0, 1, 3] with rows and columns in other units: entries 50 orders of magnitude apart are no reason
/// to refuse, and scaling by powers of two costs no digit.
#[test]
fn scale_does_not_matter() -> Outcome {
    let matrix = vec![vec![2e-20, 1e-25, 0.0], vec![1e5, 0.0, 1e-8], vec![0.0, 1e10, 3e2]];
    let exact = [3e-5, 5.0, 7e8];
    let right: Vec<f64> = matrix.iter().map(|row| -residual(0.0, row, &exact)).collect();
    let solution = Factors::new(matrix)?.solve(&right);
    for (found, exact) in solution.iter().zip(exact) {
        // The right-hand sides are rounded, 1e-16, and the matrix in equal units has condition number about 10.
        assert!((found - exact).abs() <= 1e-14 * exact, "{solution:?}");
    }
    Ok(())
}

#[test]
fn a_singular_matrix_is_refused() {
    let dependent = vec![vec![0.1, 0.2, 0.3], vec![0.4, 0.5, 0.6], vec![0.5, 0.7, 0.9]];
    assert!(Factors::new(dependent).is_err());
    assert!(Factors::new(vec![vec![1.0, 0.0], vec![0.0, 0.0]]).is_err());
    assert!(Factors::new(vec![vec![1.0, f64::NAN], vec![0.0, 1.0]]).is_err());
    assert!(Factors::new(vec![vec![0.0, 1.0], vec![1.0, 0.0]]).is_ok());
    assert!(Factors::new(vec![]).is_ok());
}

/// The inverse of [2, 1; 1, 1] is [1, -1; -1, 2].
#[test]
fn amplification_is_the_absolute_inverse() -> Outcome {
    let bound = Factors::new(vec![vec![2.0, 1.0], vec![1.0, 1.0]])?.amplify(&[10.0, 1.0]);
    assert_eq!(bound, [11.0, 12.0]);
    Ok(())
}

/// 1 - (1 + 2^-30)(1 - 2^-30) = 2^-60, all of which is lost in ordinary arithmetic.
#[test]
fn residuals_keep_what_rounding_loses() {
    let small = 2f64.powi(-30);
    assert_eq!(residual(1.0, &[1.0 + small], &[1.0 - small]), small * small);
    assert_eq!(residual(1.0, &[1e17, 1.0, -1e17], &[1.0, 3.0, 1.0]), -2.0);
}
