//! The kernels of the derivatives of the motion beside the motion itself, for quick-return, in one run.
//! `cargo bench -p tests --features scale --bench derivatives`

#![allow(missing_docs, clippy::unwrap_used)]

include!(concat!(env!("OUT_DIR"), "/derivatives.rs"));

use sim::Mechanism;
use std::hint::black_box;
use tests::{run, shortest};

const CALLS: usize = 20_000;
const RUNS: usize = 100;

type State = ([f64; 3], [f64; 3]);

fn main() {
    let found = run(models::QuickReturn::default(), 2.0, 4096).unwrap();
    let states: Vec<State> = found.trajectory.samples.iter().map(|s| (s.state.positions, s.state.speeds)).collect();
    let mechanism = black_box(QuickReturn::default());
    let prepared = black_box(mechanism.prepare());
    let dynamics = per_call(&states, |(q, qd)| {
        black_box(prepared.dynamics(0.0, q, qd));
    });
    println!("quick-return, {} parameters; minimum of {RUNS} runs", mechanism.parameters().len());
    let print = |name: &str, time: f64| println!("{name:<32} {time:>8.1} ns {:>6.2} of dynamics", time / dynamics);
    print("dynamics", dynamics);
    let jacobian = |(q, qd): &State| {
        black_box(prepared.dynamics_jacobian(0.0, q, qd));
    };
    print("dynamics_jacobian", per_call(&states, jacobian));
    let sensitivity = |(q, qd): &State| {
        black_box(prepared.dynamics_sensitivity(0.0, q, qd));
    };
    print("dynamics_sensitivity", per_call(&states, sensitivity));
    let plain = models::QuickReturnRatio::default();
    let by_duals = |(q, qd): &State| {
        black_box(Mechanism::dynamics_sensitivity(&plain, 0.0, q, qd));
    };
    print("sensitivity from dual numbers", per_call(&states, by_duals));
}

fn per_call(states: &[State], mut f: impl FnMut(&State)) -> f64 {
    let once = || (0..CALLS).for_each(|i| f(&states[i * 7 % states.len()]));
    shortest(RUNS, once).as_secs_f64() * 1e9 / CALLS as f64
}
