//! Chains and rows of loops, of which Lagrange's equations are known for any number.

use models::{FourBars, HangingChain};
use sim::{Method, Settings, Table};
use std::f64::consts::PI;
use tests::Random;
use tests::any_model::run_with;

const RODS: usize = 5;

/// phi'' of n slender rods that hang in a chain, by Lagrange's equations:
/// sum_j m l^2 a_ij (cos(phi_i - phi_j) phi_j'' + sin(phi_i - phi_j) phi_j'^2) = -m g l (n + 1/2 - i) sin phi_i, with
/// a_ij = n + 1/2 - max(i, j) and a_ii = n + 1/3 - i.
fn accelerations(chain: &HangingChain, phi: &[f64; RODS], rates: &[f64; RODS]) -> [f64; RODS] {
    let n = RODS as f64;
    let coefficient = |i: usize, j: usize| n - 1.0 - i.max(j) as f64 + if i == j { 1.0 / 3.0 } else { 0.5 };
    let mut rows: Vec<Vec<f64>> = Vec::new();
    for i in 0..RODS {
        let mut row: Vec<f64> = (0..RODS).map(|j| coefficient(i, j) * (phi[i] - phi[j]).cos()).collect();
        let centrifugal: f64 = (0..RODS).map(|j| coefficient(i, j) * (phi[i] - phi[j]).sin() * rates[j].powi(2)).sum();
        row.push(-centrifugal - chain.g / chain.l * (n - 0.5 - i as f64) * phi[i].sin());
        rows.push(row);
    }
    // Symmetric and positive definite: elimination without pivoting.
    for k in 0..RODS {
        for i in k + 1..RODS {
            let factor = rows[i][k] / rows[k][k];
            for j in k..=RODS {
                rows[i][j] -= factor * rows[k][j];
            }
        }
    }
    let mut solution = [0.0; RODS];
    for k in (0..RODS).rev() {
        let known: f64 = (k + 1..RODS).map(|j| rows[k][j] * solution[j]).sum();
        solution[k] = (rows[k][RODS] - known) / rows[k][k];
    }
    solution
}

/// Rounding alone: elimination of five equations whose matrix has a condition of about 100.
#[test]
fn a_chain_accelerates_as_lagrange_says() {
    let chain: HangingChain = HangingChain::default();
    let mut random = Random(5);
    for _ in 0..200 {
        let phi = [(); RODS].map(|()| random.between(-3.0, 3.0));
        let rates = [(); RODS].map(|()| random.between(-5.0, 5.0));
        let found = chain.dynamics(0.0, &phi, &rates).accelerations;
        let expected = accelerations(&chain, &phi, &rates);
        let largest = expected.iter().fold(1.0f64, |largest, x| largest.max(x.abs()));
        for (found, expected) in found.iter().zip(expected) {
            assert!((found - expected).abs() < 1e-12 * largest, "{found} {expected}");
        }
    }
}

/// The motion by the classical method with 50,000 steps on the equations above.
#[test]
fn a_chain_moves_as_lagrange_says() {
    let chain: HangingChain = HangingChain::default();
    let run = run_with(chain, &Settings::adaptive(Method::Dop853, 1.0, 1e-12)).unwrap();
    let steps = 50_000;
    let h = 1.0 / f64::from(steps);
    let (mut phi, mut rates) = ([chain.start; RODS], [0.0; RODS]);
    let along = |a: &[f64; RODS], b: &[f64; RODS], h: f64| std::array::from_fn::<f64, RODS, _>(|i| a[i] + h * b[i]);
    for _ in 0..steps {
        let (v1, a1) = (rates, accelerations(&chain, &phi, &rates));
        let v2 = along(&rates, &a1, h / 2.0);
        let a2 = accelerations(&chain, &along(&phi, &v1, h / 2.0), &v2);
        let v3 = along(&rates, &a2, h / 2.0);
        let a3 = accelerations(&chain, &along(&phi, &v2, h / 2.0), &v3);
        let v4 = along(&rates, &a3, h);
        let a4 = accelerations(&chain, &along(&phi, &v3, h), &v4);
        for i in 0..RODS {
            phi[i] += h / 6.0 * (v1[i] + 2.0 * v2[i] + 2.0 * v3[i] + v4[i]);
            rates[i] += h / 6.0 * (a1[i] + 2.0 * a2[i] + 2.0 * a3[i] + a4[i]);
        }
    }
    let last = &run.trajectory.samples.last().unwrap().state;
    for i in 0..RODS {
        println!("rod {}: {:.1e} {:.1e}", i + 1, last.positions[i] - phi[i], last.speeds[i] - rates[i]);
        assert!((last.positions[i] - phi[i]).abs() < 1e-9 && (last.speeds[i] - rates[i]).abs() < 1e-8);
    }
    assert!(run.energy_balance < 1e-9, "{:e}", run.energy_balance);
}

/// Cranks turn alike and couplers do not turn: one pendulum, whose period is known, 2 pi sqrt(I/G)/agm(1, cos(amplitude/2)).
#[test]
fn four_bars_in_a_row_swing_as_one_pendulum() {
    let bars: FourBars = FourBars::default();
    let n = 3.0;
    let inertia = (n + 1.0) * bars.m * bars.l.powi(2) / 3.0 + n * bars.m * bars.l.powi(2);
    let weight = bars.m * bars.g * bars.l * ((n + 1.0) / 2.0 + n);
    let amplitude = bars.start + PI / 2.0;
    let (mut a, mut b) = (1.0, (amplitude / 2.0).cos());
    while (a - b).abs() > 1e-15 {
        (a, b) = ((a + b) / 2.0, f64::sqrt(a * b));
    }
    let period = 2.0 * PI * (inertia / weight).sqrt() / a;
    let run = run_with(bars, &Settings::adaptive(Method::Dop853, 1.2 * period, 1e-12)).unwrap();
    assert_eq!(run.trajectory.failure, None);
    let still: Vec<f64> = run.events.iter().filter(|e| e.name == "period").map(|e| e.state.time).collect();
    println!("period {period}: {:.1e} {:.1e}", still[0] - period / 2.0, still[1] - period);
    assert!((still[0] - period / 2.0).abs() < 1e-9 && (still[1] - period).abs() < 1e-9, "{still:?} {period}");
    for sample in &run.trajectory.samples {
        let (q, qd) = (&sample.state.positions, &sample.state.speeds);
        for i in 0..3 {
            assert!((q[i + 1] - q[0]).abs() < 1e-9 && (qd[i + 1] - qd[0]).abs() < 1e-9, "{q:?}");
            assert!(q[i + 4].abs() < 1e-9 && qd[i + 4].abs() < 1e-9, "{q:?}");
        }
        let energy = inertia / 2.0 * qd[0].powi(2) + weight * (q[0].sin() - bars.start.sin());
        assert!(energy.abs() < 1e-8, "{energy:e}");
    }
    // The last coupler pulls at the last crank; the moment about its ground pin turns the crank.
    let table = Table::of(&run.mechanism, &run.trajectory);
    let (fx, fy) = (&table.column("Fx").unwrap().values, &table.column("Fy").unwrap().values);
    for (i, sample) in run.trajectory.samples.iter().enumerate() {
        let (phi, acceleration) = (sample.state.positions[0], sample.accelerations[0]);
        let moment = bars.l * (phi.cos() * fy[i] - phi.sin() * fx[i]) - bars.m * bars.g * bars.l / 2.0 * phi.cos();
        let expected = bars.m * bars.l.powi(2) / 3.0 * acceleration;
        assert!((moment - expected).abs() < 1e-8, "{moment} {expected}");
    }
}
