//! Equilibria and small motions about them against closed forms.

use models::{DoublePendulum, Pendulum};
use sim::{Erased, declared_start, equilibrium, erase, mechanism};
use tests::any_model::run_with;

mechanism! {
    /// A bead on a circle, hung from a spring: one constraint, damped.
    Hung;
    coordinates { x [m]; y [m]; }
    parameters { l [m] = 0.5; m [kg] = 2; c [N*s/m] = 0.3; g [m/s^2] = 9.81; }
    bodies { bead: mass m at [x, y]; }
    loads { gravity [0, -g]; force [-c*dot(x), -c*dot(y)] at [x, y]; }
    constraints { rod: norm([x, y]) = l; }
    initial { guess x = 0.3; guess y = -0.4; }
}

#[test]
fn pendulums_hang_and_swing_as_they_should() {
    let pendulum = Pendulum::default();
    // Down it swings, up it falls.
    for (near, place) in [(0.3, 0.0), (3.0, std::f64::consts::PI)] {
        let start = sim::Start { positions: [near], ..declared_start(&pendulum) };
        let found = equilibrium(&pendulum, &start).unwrap();
        let last = found.eigenvalues[1];
        let size = if place == 0.0 { last.im } else { last.re };
        assert!((found.state.positions[0] - place).abs() < 1e-9 && (size - 9.81f64.sqrt()).abs() < 1e-9, "{found:?}");
    }
    // From the horizontal it hangs, to the side that it leans to.
    let found = equilibrium(&pendulum, &declared_start(&pendulum)).unwrap();
    assert!((found.state.positions[0] / std::f64::consts::TAU).fract().abs() < 1e-9, "{found:?}");
    let double = DoublePendulum::default();
    let mut start = declared_start(&double);
    start.positions = [0.1, -0.1];
    let found = equilibrium(&double, &start).unwrap();
    // (4/3) a'' + b''/2 + (3/2)(g/l) a = 0 and a''/2 + b''/3 + (g/l) b/2 = 0 with w^2 = s g/l: 7 s^2/36 - 7 s/6 + 3/4 = 0.
    let squares = [-1.0, 1.0].map(|sign: f64| (7.0 / 6.0 + sign * (49.0f64 / 36.0 - 7.0 / 12.0).sqrt()) / (7.0 / 18.0));
    for (pair, square) in found.eigenvalues.chunks(2).zip(squares) {
        let expected = (square * 9.81 / 0.6).sqrt();
        assert!((pair[1].im - expected).abs() < 1e-9 * expected && pair[1].re.abs() < 1e-9, "{pair:?} {expected}");
    }
}

/// x'' + c/m x' + g/l x = 0 on the circle; the rod carries m g.
#[test]
fn a_constrained_bead_hangs_and_is_damped() {
    let hung = Hung::default();
    let found = equilibrium(&hung, &declared_start(&hung)).unwrap();
    assert!(found.state.positions[0].abs() < 1e-9 && (found.state.positions[1] + 0.5).abs() < 1e-12, "{found:?}");
    assert!((found.multipliers[0] - 2.0 * 9.81).abs() < 1e-9);
    let (damping, square) = (0.3 / 2.0 / 2.0, 9.81 / 0.5);
    let last = found.eigenvalues[1];
    assert!(found.eigenvalues.len() == 2 && (last.re + damping).abs() < 1e-9, "{found:?}");
    assert!((last.im - f64::sqrt(square - damping * damping)).abs() < 1e-9, "{found:?}");
}

mechanism! {
    /// A truss of two links that cannot move, loaded at its apex.
    Truss;
    coordinates { a [deg]; b [deg]; }
    parameters { s [mm] = 800; m [kg] = 1; P [kN] = 3; H [kN] = 1; }
    let A = s*[cos(a), sin(a)];
    let B = [s, 0] + s*[cos(b), sin(b)];
    bodies { left: mass m at A; right: mass m at B; }
    loads { force [H, -P] at A; }
    constraints { apex: A = B; }
    initial { guess a = 50; guess b = 130; }
}

/// What rounding moves is not compared with itself: neither the balance of energy nor verification raises an alarm.
#[test]
fn nothing_is_wrong_with_what_stands_still() {
    let run = run_with(Truss::default(), &sim::Settings::new(2.0)).unwrap();
    // Both links are at 60 degrees.
    let forces = &run.trajectory.samples[0].multipliers;
    let (right, down) = (1000.0, 3000.0);
    let expected = [(right + down / 3f64.sqrt()) / 2.0, -(down + right * 3f64.sqrt()) / 2.0];
    assert!((0..2).all(|i| (forces[i] - expected[i]).abs() < 1e-9 * down), "{forces:?} {expected:?}");
    assert!(run.energy_balance < 1e-4, "{}", run.energy_balance);
    let truss = Erased::of(erase(Truss::default()));
    for check in sim::verify::verify(truss.clone(), &declared_start(&truss), 2.0).unwrap() {
        assert!(check.passes() || check.name == "energy and work", "{}: {:?}", check.name, check.figure);
    }
}
