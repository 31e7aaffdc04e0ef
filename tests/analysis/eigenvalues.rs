//! Eigenvalues and eigenvectors of matrices.

use nalgebra::{Complex, DMatrix};
use sim::{NoEigenvalues, eigen};
use tests::spectra::Exact;

/// A share of those that `figures numbers` takes.
#[test]
fn exact_spectra_are_found_to_what_they_are_worth() {
    for (what, value, bound) in tests::spectra::lines(60) {
        println!("{what}: {value:.1e}");
        assert!(value <= bound, "{what}: {value:e}");
    }
}

/// The roots of unity are those of a cycle, which QR with its usual shifts maps onto itself.
#[test]
fn cycles_are_left() {
    for n in [2, 3, 4, 5, 8, 40] {
        let cycle = DMatrix::from_fn(n, n, |i, j| f64::from(u8::from(i == (j + 1) % n)));
        for value in eigen(&cycle).unwrap().values {
            // n roundings or so, n times as many in the power.
            assert!((value.powu(n as u32) - 1.0).norm() < 1e-15 * (n * n) as f64, "{n}: {value}");
        }
    }
}

/// What is left of nilpotent blocks beside larger ones is rounding everywhere, and never small beside its neighbours.
#[test]
fn rounding_is_not_iterated_on() {
    for number in [2138, 5458, 9009] {
        let exact = Exact::numbered(number);
        assert!(exact.errors(&eigen(&exact.matrix).unwrap())[..2].iter().all(|error| *error <= 1.0), "{number}");
    }
}

/// A chain of integrators at the end of an oscillator and beside it, in units far apart: what is cyclic has eigenvalues of
/// exactly zero, and costs the others no digit.
#[test]
fn zeros_are_zero_and_cost_nothing() {
    for unit in [1e-9, 1.0, 1e9] {
        // y''' = x, x'' = -9 x - 2 x' + 0 y.
        let mut a = DMatrix::zeros(5, 5);
        (a[(0, 1)], a[(1, 2)], a[(2, 3)]) = (1.0, 1.0, unit);
        (a[(3, 4)], a[(4, 3)], a[(4, 4)]) = (1.0, -9.0, -2.0);
        let found = eigen(&a).unwrap();
        let zeros = found.values.iter().filter(|value| value.norm() == 0.0).count();
        assert_eq!(zeros, 3, "{:?}", found.values);
        let exact = Complex::new(-1.0, 8.0f64.sqrt());
        for value in found.values.iter().filter(|value| value.norm() > 0.0) {
            // A 2 x 2 block by itself: a few roundings.
            assert!((value.re - exact.re).abs() < 4e-16 && (value.im.abs() - exact.im).abs() < 4e-15, "{value}");
        }
        assert!(found.vectors.iter().all(|entry| entry.re.is_finite() && entry.im.is_finite()));
    }
}

#[test]
fn multiple_eigenvalues_keep_their_vectors_apart() {
    // Two equal oscillators, coupled in coordinates that are turned.
    let (c, s) = (0.6, 0.8);
    let turn = DMatrix::from_row_slice(2, 2, &[c, -s, s, c]);
    let stiffness = &turn * DMatrix::from_diagonal_element(2, 2, 4.0) * turn.transpose();
    let mut a = DMatrix::zeros(4, 4);
    a.view_mut((0, 2), (2, 2)).fill_with_identity();
    a.view_mut((2, 0), (2, 2)).copy_from(&-stiffness);
    let found = eigen(&a).unwrap();
    let rank = found.vectors.svd(false, false).singular_values;
    assert!(found.values.iter().all(|value| value.re.abs() < 1e-15 && (value.im.abs() - 2.0).abs() < 1e-14));
    assert!(rank.iter().all(|value| *value > 0.1), "{rank}");
}

#[test]
fn what_has_no_eigenvalues_says_why() {
    assert_eq!(eigen(&DMatrix::zeros(2, 3)).unwrap_err(), NoEigenvalues::NotSquare { rows: 2, columns: 3 });
    assert_eq!(eigen(&DMatrix::from_element(2, 2, f64::NAN)).unwrap_err(), NoEigenvalues::NotFinite);
    assert!(eigen(&DMatrix::zeros(0, 0)).unwrap().values.is_empty());
}
