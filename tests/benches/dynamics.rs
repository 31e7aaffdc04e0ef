//! The generated right-hand side of quick-return beside what an expert derives on paper for this one mechanism, and
//! beside a dense solution of the generated matrices, all in one run. `cargo bench -p tests --bench dynamics`

#![allow(missing_docs, clippy::unwrap_used)]

use models::QuickReturn;
use nalgebra::{SMatrix, SVector};
use sim::Mechanism;
use std::hint::black_box;
use tests::{run, shortest};

const CALLS: usize = 20_000;
const RUNS: usize = 100;

type Solved = ([f64; 3], [f64; 2]);
type Route = fn(&Parameters, &[f64; 3], &[f64; 3]) -> Solved;

/// One set of parameters, and what each route makes of it once.
struct Parameters {
    mechanism: QuickReturn,
    prepared: <QuickReturn as Mechanism>::Prepared,
    combined: Combined,
}

impl Parameters {
    fn new(mechanism: QuickReturn) -> Self {
        Parameters { mechanism, prepared: mechanism.prepare(), combined: Combined::new(&mechanism) }
    }
}

fn main() {
    let routes: [(&str, Route); 4] = [
        ("generated", generated),
        ("by hand", by_hand),
        ("by hand, constants combined", by_hand_combined),
        ("generated matrices, dense LU", dense),
    ];
    let found = run(QuickReturn::default(), 2.0, 4096).unwrap();
    let states: Vec<([f64; 3], [f64; 3])> =
        found.trajectory.samples.iter().map(|s| (s.state.positions, s.state.speeds)).collect();
    for (name, route) in routes {
        agree(name, route, &states);
    }
    let sine = per_call(|i| {
        black_box((0.001 * i as f64).sin_cos());
    });
    println!(
        "standard f64::sin_cos: {sine:.1} ns; minimum of {RUNS} runs; in brackets: in sin_cos, and relative to by hand"
    );
    println!("{:<30} {:>28} {:>28}", "quick-return, one rhs", "independent calls [ns]", "dependent calls [ns]");
    let parameters = black_box(Parameters::new(QuickReturn::default()));
    let times =
        routes.map(|(_, route)| (independent(route, &parameters, &states), dependent(route, &parameters, &states)));
    for ((name, _), (free, chained)) in routes.iter().zip(times) {
        let cell = |time: f64, hand: f64| format!("{time:.1} ({:.2}, {:.2})", time / sine, time / hand);
        println!("{name:<30} {:>28} {:>28}", cell(free, times[1].0), cell(chained, times[1].1));
    }
}

fn per_call(mut f: impl FnMut(usize)) -> f64 {
    shortest(RUNS, || (0..CALLS).for_each(&mut f)).as_secs_f64() * 1e9 / CALLS as f64
}

#[inline(always)]
fn independent(route: Route, parameters: &Parameters, states: &[([f64; 3], [f64; 3])]) -> f64 {
    per_call(|i| {
        let (q, qd) = &states[i * 7 % states.len()];
        black_box(route(parameters, q, qd));
    })
}

/// Each call gets a state that the one before has changed, by nothing.
#[inline(always)]
fn dependent(route: Route, parameters: &Parameters, states: &[([f64; 3], [f64; 3])]) -> f64 {
    let mut last = 0.0;
    per_call(|i| {
        let (mut q, qd) = states[i * 7 % states.len()];
        q.iter_mut().for_each(|q| *q += 1e-300 * last);
        last = black_box(route(parameters, &q, &qd)).0[0];
    })
}

fn agree(name: &str, route: Route, states: &[([f64; 3], [f64; 3])]) {
    let parameters = Parameters::new(QuickReturn::default());
    for (q, qd) in states {
        let (found, expected) = (route(&parameters, q, qd), dense(&parameters, q, qd));
        let close = |a: &[f64], b: &[f64]| a.iter().zip(b).all(|(a, b)| (a - b).abs() < 1e-9 * (1.0 + b.abs()));
        assert!(close(&found.0, &expected.0) && close(&found.1, &expected.1), "{name}: {found:?} {expected:?}");
    }
}

#[inline(never)]
fn generated(p: &Parameters, q: &[f64; 3], qd: &[f64; 3]) -> Solved {
    let solved = QuickReturn::prepared_dynamics(&p.prepared, 0.0, q, qd);
    assert!(!solved.refused);
    (solved.accelerations, solved.multipliers)
}

/// What an expert would take out of the loop: the terms of the mass matrix that are constant.
struct Combined {
    coupling: f64,
    m_aa: f64,
    m_bb: f64,
    m_gg: f64,
}

impl Combined {
    #[inline(always)]
    fn new(p: &QuickReturn) -> Self {
        Combined {
            coupling: p.O4B * (p.m5 * p.BG5 + p.m6 * p.BC),
            m_aa: p.J2 + p.m3 * p.O2A * p.O2A,
            m_bb: p.J3 + p.J4 + p.m4 * p.O4G4 * p.O4G4 + (p.m5 + p.m6) * p.O4B * p.O4B,
            m_gg: p.J5 + p.m5 * p.BG5 * p.BG5 + p.m6 * p.BC * p.BC,
        }
    }
}

#[inline(never)]
fn by_hand(p: &Parameters, q: &[f64; 3], qd: &[f64; 3]) -> Solved {
    eliminate(&p.mechanism, &Combined::new(&p.mechanism), q, qd)
}

#[inline(never)]
fn by_hand_combined(p: &Parameters, q: &[f64; 3], qd: &[f64; 3]) -> Solved {
    eliminate(&p.mechanism, &p.combined, q, qd)
}

/// Slot and guide give beta'' = kappa alpha'' + e and gamma'' = mu beta'' + f; the equations of the three coordinates,
/// weighted by 1, kappa and kappa mu, lose their multipliers.
#[inline(always)]
fn eliminate(p: &QuickReturn, c: &Combined, [alpha, beta, gamma]: &[f64; 3], [da, db, dg]: &[f64; 3]) -> Solved {
    let ((sa, ca), (sb, cb), (sg, cg)) = (alpha.sin_cos(), beta.sin_cos(), gamma.sin_cos());
    let (xa, ya) = (p.O2A * ca, p.O4O2 + p.O2A * sa);
    let (cos_ab, sin_ab) = (ca * cb + sa * sb, sa * cb - ca * sb);
    let (cos_bg, sin_bg) = (cb * cg + sb * sg, sb * cg - cb * sg);
    let (da2, db2, dg2) = (da * da, db * db, dg * dg);
    let rho = xa * cb + ya * sb;
    let h_guide = -p.O4B * sb * db2 - p.BC * sg * dg2;
    let h_slot = p.O2A * sin_ab * (2.0 * da * db - da2) - db2 * (ya * cb - xa * sb);
    let (over_rho, over_bar) = (1.0 / rho, 1.0 / (p.BC * cg));
    let (kappa, e) = (p.O2A * cos_ab * over_rho, h_slot * over_rho);
    let (mu, f) = (-p.O4B * cb * over_bar, -h_guide * over_bar);
    let m_bg = c.coupling * cos_bg;
    let r_b = -p.F * p.O4B * sb - c.coupling * sin_bg * dg2;
    let r_g = -p.F * p.BC * sg + c.coupling * sin_bg * db2;
    let g = m_bg + mu * c.m_gg;
    let d = c.m_bb + mu * m_bg + mu * g;
    let dda = (p.T + kappa * (r_b + mu * r_g - g * f - d * e)) / (c.m_aa + kappa * kappa * d);
    let ddb = kappa * dda + e;
    let ddg = mu * ddb + f;
    let guide = (r_g - m_bg * ddb - c.m_gg * ddg) * over_bar;
    let slot = (c.m_bb * ddb + m_bg * ddg + p.O4B * cb * guide - r_b) * over_rho;
    ([dda, ddb, ddg], [guide, slot])
}

#[inline(never)]
fn dense(p: &Parameters, q: &[f64; 3], qd: &[f64; 3]) -> Solved {
    let mechanism = &p.mechanism;
    let (mass, jacobian) = (mechanism.mass_matrix(0.0, q), mechanism.constraint_jacobian(0.0, q));
    let (force, convective) = (mechanism.generalized_forces(0.0, q, qd), mechanism.convective_forces(0.0, q, qd));
    let constraint = mechanism.constraint_convective(0.0, q, qd);
    let matrix = SMatrix::<f64, 5, 5>::from_fn(|i, j| match (i < 3, j < 3) {
        (true, true) => mass[i][j],
        (true, false) => jacobian[j - 3][i],
        (false, true) => jacobian[i - 3][j],
        (false, false) => 0.0,
    });
    let rhs = SVector::<f64, 5>::from_fn(|i, _| if i < 3 { force[i] - convective[i] } else { -constraint[i - 3] });
    let z = matrix.lu().solve(&rhs).unwrap_or_else(SVector::zeros);
    ([z[0], z[1], z[2]], [z[3], z[4]])
}
