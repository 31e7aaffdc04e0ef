//! Modes whose eigenvalue is 0 but for rounding: bodies that nothing holds. Slow modes beside them are none.

use sim::{Mode, declared_start, equilibrium, linearize};
use tests::any_model::interpreted;

fn modes(declaration: &str) -> Vec<Mode> {
    let mechanism = interpreted(declaration).unwrap();
    let state = equilibrium(&mechanism, &declared_start(&mechanism)).unwrap().state;
    linearize(&mechanism, &state, &[]).unwrap().modes
}

/// The eigenvalues of modes that are not neutral, by size, and how many are.
fn others(modes: &[Mode]) -> (Vec<f64>, usize) {
    let mut others: Vec<f64> =
        modes.iter().filter(|mode| !mode.is_neutral).map(|mode| mode.eigenvalue.norm()).collect();
    others.sort_by(f64::total_cmp);
    let neutral = modes.len() - others.len();
    (others, neutral)
}

/// A box and a cart, held together by a spring alone, at any size: they drift along x, and the box turns with the spring, which
/// has no length. The other modes are those of a spring k between masses m and 3 m along x, and between m and the turning box
/// across.
#[test]
fn what_nothing_holds_neither_grows_nor_swings() {
    for [k, l] in [[100.0, 0.7], [123.7, 0.777], [3e-5, 2e-4], [7e9, 31.0]] {
        let found = modes(&format!(
            "pub Free; coordinates {{ x [m]; y [m]; phi [rad]; z [m]; }}
            parameters {{ m [kg] = 2; I [kg*m^2] = {}; k [N/m] = {k}; l [m] = {l}; }}
            let C = [x, y]; let A = C + l*[cos(phi), sin(phi)]; let B = [z, 0];
            bodies {{ box: mass m at C, inertia I, angle phi; cart: mass 3*m at B; }}
            loads {{ spring k, length 0 from A to B; }}
            initial {{ x = {}; y = 0; phi = 0; guess z = 0; }}",
            0.6 * l * l,
            -l
        ));
        let (others, neutral) = others(&found);
        let expected = [(k / 1.5f64).sqrt(), (k * (0.5 + 1.0 / 0.6)).sqrt()];
        assert!(neutral >= 2 && others.len() == 2, "{found:?}");
        for (found, expected) in others.iter().zip(expected) {
            // The four-fold eigenvalue 0 leaves others untouched, to rounding beside the largest.
            assert!((found - expected).abs() < 1e-9 * expected, "{found} {expected}");
        }
    }
}

/// Slow, but no rounding: a mass on a soft spring, in a damper so stiff that it creeps with k/c; one in a damper alone, which
/// stops with c/m and stays where it is; one that a weak spring drives away; each beside a stiff spring.
#[test]
fn what_is_slow_is_not_neutral() {
    let beside = |load: &str| {
        format!(
            "pub Slow; coordinates {{ x [m]; y [m]; }} bodies {{ a: mass 1 [kg] at [x, 0]; b: mass 1 [kg] at [0, y]; }}
            loads {{ force [{load}, 0] at [x, 0]; spring 1e6 [N/m], rest 0 [m] on y; }} initial {{ x = 0; y = 0; }}"
        )
    };
    for (load, expected, neutral) in [
        ("-1 [N/m]*x - 1e4 [N*s/m]*dot(x)", &[1e-4, 1e3, 1e4][..], 0),
        ("-0.01 [N*s/m]*dot(x)", &[0.01, 1e3], 1),
        ("0.0001 [N/m]*x", &[0.01, 0.01, 1e3], 0),
    ] {
        let found = modes(&beside(load));
        let (others, found_neutral) = others(&found);
        assert_eq!((others.len(), found_neutral), (expected.len(), neutral), "{load}: {found:?}");
        for (found, expected) in others.iter().zip(expected) {
            // k/c by the first power of k m/c^2, 1e-8, which is also the rounding of c beside it.
            assert!((found - expected).abs() < 1e-7 * expected, "{load}: {found} {expected}");
        }
    }
}

/// Rolling: rates that depend on positions alone grow or decay, also beside what swings a hundred million times as fast. A trailer that is
/// pushed jackknifes with v/L; one that is pulled straight, free to head anywhere, only comes back with its own rates.
#[test]
fn what_rolls_grows_or_decays() {
    let rates = |text: &str| {
        let model = interpreted(text).unwrap();
        let state = sim::assemble(&model, &declared_start(&model)).unwrap();
        let mut found = linearize(&model, &state, &[]).unwrap().modes;
        found.retain(|mode| !mode.is_neutral);
        found.into_iter().map(|mode| mode.eigenvalue).collect::<Vec<_>>()
    };
    for k in [1.0, 1e16] {
        let found = rates(&format!(
            "pub Rates; coordinates {{ x [m]; y [m]; z [m]; }}
             bodies {{ b: mass 1 [kg] at [x, y]; c: mass 1 [kg] at [z, 0]; }} loads {{ spring {k:e} [N/m], rest 0 on z; }}
             constraints {{ c1: dot(x) = 2 [1/s]*x; c2: dot(y) = -3 [1/s]*y; }} initial {{ x = 0; y = 0; z = 0; dot(z) = 0; }}"
        ));
        let mut real: Vec<f64> = found.iter().filter(|value| value.im == 0.0).map(|value| value.re).collect();
        real.sort_by(f64::total_cmp);
        assert_eq!((real.as_slice(), found.len()), ([-3.0, 2.0].as_slice(), 3), "{found:?}");
    }
    // Of equal ones every one.
    for (loads, expected) in [
        ("force 4 [N/m]*x on x; force 4 [N/m]*y on y; force 4 [N/m]*z on z;", [-2.0, -2.0, -2.0, 2.0, 2.0, 2.0]),
        ("spring 4 [N/m], length 0 from [0, 0, 0] to [x, y, z];", [0.0; 6]),
    ] {
        let found = rates(&format!(
            "pub Equal; coordinates {{ x [m]; y [m]; z [m]; }} bodies {{ b: mass 1 [kg] at [x, y, z]; }} loads {{ {loads} }}
             initial {{ x = 0; y = 0; z = 0; }}"
        ));
        let mut real: Vec<f64> = found.iter().map(|value| value.re).collect();
        real.sort_by(f64::total_cmp);
        assert!(real.iter().zip(expected).all(|(found, expected)| (found - expected).abs() < 1e-12), "{found:?}");
        assert!(found.iter().all(|value| (value.norm() - 2.0).abs() < 1e-12), "{found:?}");
        assert_eq!(found.len(), if expected[0] == 0.0 { 3 } else { 6 }, "{found:?}");
    }
    let trailer = "pub Trailer; coordinates { x [m]; y [m]; b [rad]; } parameters { L [m] = 1.5; v [m/s] = -2; }
        let H = [x, y]; let Q = H - L*[cos(b), sin(b)];
        bodies { t: mass 1 [kg] at H; r: mass 1 [kg] at Q, inertia 1 [kg*m^2], angle b; }
        constraints { hitch: dot(H) = [v, 0]; wheel: inner(dot(Q), [-sin(b), cos(b)]) = 0; }
        initial { x = 0; y = 0; b = 0; }";
    let found = rates(trailer);
    assert!(found.len() == 1 && (found[0].re - 2.0 / 1.5).abs() < 1e-12, "{found:?}");
}
