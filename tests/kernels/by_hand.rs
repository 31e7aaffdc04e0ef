//! The hand-written equations that kernels are measured against, against the oracle's equations of the same mechanisms.

use codegen::dsl;
use codegen::model::Unit;
use codegen::oracle::{Oracle, State, Terms};
use nalgebra::{DMatrix, DVector};
use tests::Random;
use tests::by_hand::{Chain, FourBars, chain_absolute, chain_relative, four_bars};
use tests::declarations::{self, Angles};

#[test]
fn chains_by_hand_are_their_declarations() {
    chain::<1>();
    chain::<2>();
    chain::<5>();
    chain::<20>();
}

fn chain<const N: usize>() {
    let mut random = Random(21);
    for angles in [Angles::Absolute, Angles::Relative] {
        let by_hand = if angles == Angles::Absolute { chain_absolute::<N> } else { chain_relative::<N> };
        for _ in 0..20 {
            let [m, l, g] = [1.3, 0.7, 9.81].map(|x| x * random.between(0.8, 1.2));
            let (q, qd) = (each(&mut random, 3.0), each(&mut random, 3.0));
            let found = by_hand(&Chain { m, l, g }, &q, &qd);
            solves(&declarations::chain(N, angles), &[m, l, g], &q, &qd, &found);
        }
    }
}

#[test]
fn four_bars_by_hand_are_their_declaration() {
    loops::<1, 2>();
    loops::<2, 3>();
    loops::<10, 11>();
}

fn loops<const N: usize, const K: usize>() {
    let mut random = Random(22);
    for _ in 0..20 {
        let [m, l, g] = [1.3, 0.7, 9.81].map(|x| x * random.between(0.8, 1.2));
        // Near the parallelograms, but not on the constraints: the equations hold there too.
        let cranks: [f64; K] = std::array::from_fn(|_| random.between(0.9, 1.9));
        let couplers: [f64; N] = std::array::from_fn(|_| random.between(-0.3, 0.3));
        let (crank_rates, coupler_rates) = (each::<K>(&mut random, 3.0), each::<N>(&mut random, 3.0));
        let found = four_bars(&FourBars { m, l, g }, &cranks, &couplers, &crank_rates, &coupler_rates);
        let z = [&found.cranks[..], &found.couplers, found.reactions.as_flattened()].concat();
        let (q, qd) = ([&cranks[..], &couplers].concat(), [&crank_rates[..], &coupler_rates].concat());
        solves(&declarations::four_bars(N), &[m, l, g], &q, &qd, &z);
    }
}

fn each<const N: usize>(random: &mut Random, size: f64) -> [f64; N] {
    std::array::from_fn(|_| random.between(-size, size))
}

/// The backward error of z, unknown by unknown what a stable elimination leaves: 100 n roundings.
fn solves(declaration: &str, parameters: &[f64], q: &[f64], qd: &[f64], z: &[f64]) {
    let declaration = codegen::parse(declaration.parse().unwrap()).unwrap();
    let si_factor = |unit: &dsl::Unit| Unit::resolve(unit).unwrap().factor();
    let terms = Oracle::new(&declaration, &si_factor)
        .terms(&State { time: 0.0, parameters, inputs: &[], coordinates: q, speeds: qd })
        .unwrap();
    let (matrix, rhs) = system(&terms);
    let z = DVector::from_column_slice(z);
    let residual = (&matrix * &z - &rhs).amax();
    let size = matrix.abs().column_sum().amax() * z.amax() + rhs.amax();
    assert!(residual <= 100.0 * z.len() as f64 * f64::EPSILON * size, "{residual:e} of {size:e}");
    // The equations have one solution, or the residual would say nothing.
    let exact = matrix.clone().lu().solve(&rhs).unwrap();
    let singular = matrix.singular_values();
    let condition = singular.max() / singular.min();
    assert!(
        condition < 1e8 && (&exact - &z).norm() <= 100.0 * f64::EPSILON * condition * exact.norm(),
        "{condition:e}"
    );
}

fn system(terms: &Terms) -> (DMatrix<f64>, DVector<f64>) {
    let (n, m) = (terms.mass_matrix.len(), terms.constraint_jacobian.len());
    let matrix = DMatrix::from_fn(n + m, n + m, |i, j| match (i < n, j < n) {
        (true, true) => terms.mass_matrix[i][j].value,
        (true, false) => terms.constraint_jacobian[j - n][i].value,
        (false, true) => terms.constraint_jacobian[i - n][j].value,
        (false, false) => 0.0,
    });
    let rhs = DVector::from_fn(n + m, |i, _| match i < n {
        true => terms.generalized_forces[i].value,
        false => -terms.constraint_convective[i - n].value,
    });
    (matrix, rhs)
}
