//! What free bodies cost, for `figures -- numbers coupling`: without an argument a right-hand side of each chain in angles, and one
//! with its projection as free bodies, in nanoseconds; with a number, what the derivation of so many uncoupled bodies takes, in
//! bytes of memory and of code.

#![allow(missing_docs)]

use sim::{Compiled, FixedArray, Measures, State, project};
use std::hint::black_box;
use tests::{interleaved, peak_memory};

/// The kernels, whose names are documented where they are declared.
#[allow(unreachable_pub)]
mod chains {
    include!(concat!(env!("OUT_DIR"), "/coupling.rs"));
}

fn main() -> Result<(), Box<dyn std::error::Error>> {
    if let Some(bodies) = std::env::args().nth(1) {
        let code = codegen::generate_text(&uncoupled(bodies.parse()?), "sim_kernel")?;
        println!("{} {}", peak_memory().ok_or("no peak of memory")?, code.len());
        return Ok(());
    }
    // Dense matrices of 300 coordinates and 200 constraints, which measures are found from, take much of a stack.
    let measured = std::thread::Builder::new().stack_size(64 << 20).spawn(|| {
        println!("{}", times::<chains::ChainAbsolute20, chains::ChainFree20>());
        println!("{}", times::<chains::ChainAbsolute100, chains::ChainFree100>());
    })?;
    measured.join().map_err(|_| "the measurement stopped".into())
}

/// Free bodies that nothing couples.
fn uncoupled(bodies: usize) -> String {
    format!(
        "/// {bodies} free bodies.
        pub Uncoupled;
        parameters {{ m [kg] = 1; J [kg*m^2] = 1; g [m/s^2] = 9.81; }}
        repeat i in 1..={bodies} {{ bodies {{ b_[i]: free, mass m, inertia J; }} }}
        loads {{ gravity [0, -g]; }}"
    )
}

/// So far is a step off the constraints at its end, beside what coordinates are measured by: at a tolerance of 1e-9.
const OFF: f64 = 1e-9;

/// Nanoseconds of a right-hand side in angles, and of one with its projection as free bodies, of the same state.
fn times<A: Compiled, F: Compiled>() -> String {
    const CALLS: usize = 100;
    let angles = A::Q::from_fn(|i| 0.3 * (1.7 * i as f64).sin());
    let rates = A::Q::from_fn(|i| 0.5 * (0.9 * i as f64).cos());
    let [on, rates_on] = as_free_bodies::<A, F>(&angles, &rates);
    let measures = Measures::at(&F::defaults(), 0.0, &on);
    let off = |values: &F::Q, phase: f64| F::Q::from_fn(|j| values[j] + OFF * (j as f64 + phase).sin());
    let end = State { time: 0.0, positions: off(&on, 0.0), speeds: off(&rates_on, 1.0), work: 0.0 };
    let (in_angles, as_free) = (A::defaults().prepare(), F::defaults().prepare());
    let found = interleaved(
        1000,
        &mut [
            &mut || {
                for _ in 0..CALLS {
                    let (q, qd) = (black_box(&angles), black_box(&rates));
                    black_box(A::prepared_dynamics(&in_angles, 0.0, q, qd));
                }
            },
            &mut || {
                for _ in 0..CALLS {
                    let mut state: State<F> = black_box(&end).clone();
                    let kept = project(&F::defaults(), &measures, &mut state);
                    black_box(F::prepared_dynamics(&as_free, 0.0, &state.positions, &state.speeds));
                    black_box(kept.is_ok());
                }
            },
        ],
    );
    let [angles, free] = [found[0], found[1]].map(|time| 1e9 * time.as_secs_f64() / CALLS as f64);
    format!("{} {angles:.0} {free:.0}", A::Q::LEN)
}

/// Positions and speeds of the rods of a chain from their angles, rods of 1 m.
fn as_free_bodies<A: Compiled, F: Compiled>(angles: &A::Q, rates: &A::Q) -> [F::Q; 2] {
    let [mut positions, mut speeds] = [F::Q::from_fn(|_| 0.0); 2];
    let (mut end, mut end_speed) = ([0.0; 2], [0.0; 2]);
    for i in 0..A::Q::LEN {
        let ((sin, cos), rate) = (angles[i].sin_cos(), rates[i]);
        let (along, turning) = ([cos, sin], [-sin * rate, cos * rate]);
        for axis in 0..2 {
            positions[3 * i + axis] = end[axis] + along[axis] / 2.0;
            speeds[3 * i + axis] = end_speed[axis] + turning[axis] / 2.0;
            end[axis] += along[axis];
            end_speed[axis] += turning[axis];
        }
        (positions[3 * i + 2], speeds[3 * i + 2]) = (angles[i], rate);
    }
    [positions, speeds]
}
