//! Matrices of many bodies that few of the others know of, against what they are by hand; and that what is derived of them grows with
//! the bodies, not with their pairs.

use sim::{Compiled, mechanism};
use tests::Random;

/// Pairs of bars.
const PAIRS: usize = 23;

mechanism! {
    /// Pairs of bars that are pinned to each other.
    pub(crate) Pairs;
    parameters { m [kg] = 2; J [kg*m^2] = 0.3; l [m] = 0.7; }
    bodies { repeat i in 1..=46 { b_[i]: free, mass m*i, inertia J; } }
    joints { repeat i in 1..=23 { p_[i]: pin on(b_[2*i - 1], [l, 0]) to on(b_[2*i], [0, l]); } }
}

#[test]
fn entries_stand_where_they_belong() {
    let (mechanism, mut random) = (Pairs::<f64>::defaults(), Random(5));
    let q: [f64; 6 * PAIRS] = std::array::from_fn(|_| random.between(-1.0, 1.0));
    let mut mass = [[0.0; 6 * PAIRS]; 6 * PAIRS];
    for (i, row) in mass.iter_mut().enumerate() {
        row[i] = if i % 3 == 2 { 0.3 } else { 2.0 * (i / 3 + 1) as f64 };
    }
    assert_eq!(mechanism.mass_matrix(0.0, &q), mass);
    let jacobian = mechanism.constraint_jacobian(0.0, &q);
    let linear = mechanism.constraint_linearization(0.0, &q);
    for pair in 0..PAIRS {
        let [first, second] = [6 * pair, 6 * pair + 3];
        let [(s1, c1), (s2, c2)] = [q[first + 2].sin_cos(), q[second + 2].sin_cos()];
        let mut rows = [[0.0; 6 * PAIRS]; 2];
        for (axis, row) in rows.iter_mut().enumerate() {
            (row[first + axis], row[second + axis]) = (1.0, -1.0);
        }
        (rows[0][first + 2], rows[1][first + 2]) = (-0.7 * s1, 0.7 * c1);
        (rows[0][second + 2], rows[1][second + 2]) = (0.7 * c2, 0.7 * s2);
        for (row, expected) in rows.iter().enumerate() {
            let found = [jacobian[2 * pair + row], linear.jacobian[2 * pair + row]];
            for (found, expected) in found.iter().flat_map(|found| found.iter().zip(expected)) {
                // Sines of two libraries.
                assert!((found - expected).abs() <= 1e-15, "{found} for {expected}");
            }
        }
    }
}

#[test]
fn code_grows_with_the_bodies() {
    let code = |bodies: usize| {
        let text = format!(
            "pub Many; parameters {{ m [kg] = 1; J [kg*m^2] = 0.1; g [m/s^2] = 9.81; }}
            bodies {{ repeat i in 1..={bodies} {{ b_[i]: free, mass m, inertia J; }} }} loads {{ gravity [0, -g]; }}"
        );
        codegen::generate_text(&text, "sim_kernel").unwrap().len()
    };
    let (few, many) = (code(100), code(400));
    // 16 times as many pairs; numbers of three digits are longer than those of two.
    assert!(many < 5 * few && many < 5_000_000, "{few} and {many} bytes");
}
