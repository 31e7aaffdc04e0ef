//! Many states at once: the right-hand side in lanes beside one call after the other, and sines and cosines beside the
//! standard library's, all in one run. `cargo bench -p tests --bench lanes`

#![allow(missing_docs, clippy::unwrap_used)]

use models::{Andrews, QuickReturn, QuickReturnRatio};
use sim::{
    Array, Compiled, Dynamics, FixedArray, Lanes, Mechanism, Scalar, State, Vectors, Work, accelerate_each_with,
};
use std::hint::black_box;
use tests::{run, shortest};

const RUNS: usize = 200;
const STATES: usize = 256;

fn widths() -> Vec<(&'static str, Vectors)> {
    let wide = [("AVX2", Vectors::avx2()), ("AVX-512", Vectors::avx512())];
    let found = wide.into_iter().filter_map(|(name, vectors)| Some((name, vectors?)));
    [("baseline", Vectors::BASELINE)].into_iter().chain(found).collect()
}

fn main() {
    sines();
    println!(
        "\nright-hand side, ns per state; minimum of {RUNS} runs over {STATES} states; in brackets: of one by one"
    );
    let names: Vec<String> = widths().iter().map(|(name, _)| format!("{name:>15}")).collect();
    println!("{:<36} {:>10} {}", "model", "one by one", names.join(" "));
    dynamics("quick-return", QuickReturn::default(), 2.0);
    dynamics("quick-return-ratio", QuickReturnRatio::default(), 2.0);
    dynamics("andrews", Andrews::default(), 0.03);
}

fn dynamics<M: Compiled>(name: &str, mechanism: M, end: f64) {
    let found = run(mechanism, end, 4095).unwrap();
    let samples = &found.trajectory.samples;
    let states: Vec<State<M>> = (0..STATES).map(|i| samples[i * 7 % samples.len()].state.clone()).collect();
    let mechanism = black_box(mechanism);
    let prepared = black_box(mechanism.prepare());
    let scalar = per_element(|| {
        for state in &states {
            black_box(one::<M>(&prepared, state));
        }
    });
    let print = |title: &str, times: Vec<f64>| {
        let cells = times.iter().map(|time| format!("{:>15}", format!("{time:.1} ({:.2})", time / scalar)));
        println!("{:<36} {scalar:>10.1} {}", format!("{name}, {title}"), cells.collect::<Vec<_>>().join(" "));
    };
    let states_in_lanes = in_lanes(&states);
    let prepared_in_lanes = black_box(mechanism.on(Lanes::from_f64).prepare());
    let mut found = vec![None; states_in_lanes.len()];
    let times = widths().into_iter().map(|(_, vectors)| {
        per_element(|| {
            let states = black_box(&states_in_lanes[..]);
            vectors.run(Resident::<M> { prepared: &prepared_in_lanes, states, found: &mut found });
            black_box(&found);
        })
    });
    print("states in lanes", times.collect());
    let mut solved = Vec::new();
    let times = widths().into_iter().map(|(_, vectors)| {
        per_element(|| {
            let failures = accelerate_each_with(vectors, &mechanism, black_box(&states), &mut solved);
            assert!(failures.is_empty());
            black_box(&solved);
        })
    });
    print("accelerate_each", times.collect());
}

type InLanes<M> = <M as Mechanism>::On<Lanes<8>>;
type Q<M> = <InLanes<M> as Mechanism<Lanes<8>>>::Q;
/// What the kernel finds for eight trajectories.
type Solved<M> = Dynamics<Lanes<8>, Q<M>, <InLanes<M> as Mechanism<Lanes<8>>>::L>;

fn in_lanes<M: Compiled>(states: &[State<M>]) -> Vec<[Q<M>; 2]> {
    let chunk = |states: &[State<M>]| {
        let q = Q::<M>::with_len(M::Q::LEN, |i| Lanes::from_fn(|lane| states[lane].positions[i]));
        [q, Q::<M>::with_len(M::Q::LEN, |i| Lanes::from_fn(|lane| states[lane].speeds[i]))]
    };
    states.chunks_exact(8).map(chunk).collect()
}

/// The kernel where the states of the trajectories stay in lanes, as in an integration of eight of them.
struct Resident<'a, M: Compiled> {
    prepared: &'a <InLanes<M> as Mechanism<Lanes<8>>>::Prepared,
    states: &'a [[Q<M>; 2]],
    found: &'a mut [Option<Solved<M>>],
}

impl<M: Compiled> Work for Resident<'_, M> {
    type Output = ();

    #[inline(always)]
    fn run<const AT_ONCE: usize>(self) {
        for (found, [q, qd]) in self.found.iter_mut().zip(self.states) {
            *found = Some(InLanes::<M>::prepared_dynamics(self.prepared, Lanes::from_f64(0.0), q, qd));
        }
    }
}

#[inline(never)]
fn one<M: Compiled>(prepared: &M::Prepared, state: &State<M>) -> Dynamics<f64, M::Q, M::L> {
    M::prepared_dynamics(prepared, state.time, &state.positions, &state.speeds)
}

fn per_element(f: impl FnMut()) -> f64 {
    shortest(RUNS, f).as_secs_f64() * 1e9 / STATES as f64
}

fn sines() {
    let angles: Vec<f64> = (0..STATES).map(|i| 0.003 * i as f64 - 6.0).collect();
    let standard = per_element(|| {
        for angle in &angles {
            black_box(black_box(*angle).sin_cos());
        }
    });
    println!("sine and cosine, ns per angle; minimum of {RUNS} runs; in brackets: of the standard library's");
    println!("{:<30} {standard:.2}", "standard f64::sin_cos");
    let alone = per_element(|| {
        for angle in &angles {
            black_box(<f64 as Scalar>::sin_cos_each([black_box(*angle)]));
        }
    });
    println!("{:<30} {alone:.2} ({:.2})", "own, one by one", alone / standard);
    let angles: Vec<Lanes<8>> = angles.chunks_exact(8).map(|chunk| Lanes::from_fn(|lane| chunk[lane])).collect();
    let mut waves = vec![(angles[0], angles[0]); angles.len()];
    for (name, vectors) in widths() {
        let time = per_element(|| vectors.run(SinesOf { angles: black_box(&angles), waves: &mut waves }));
        black_box(&waves);
        println!("{:<30} {time:.2} ({:.2})", format!("own, Lanes<8>, {name}"), time / standard);
    }
}

struct SinesOf<'a> {
    angles: &'a [Lanes<8>],
    waves: &'a mut [(Lanes<8>, Lanes<8>)],
}

impl Work for SinesOf<'_> {
    type Output = ();

    #[inline(always)]
    fn run<const AT_ONCE: usize>(self) {
        for (wave, angle) in self.waves.iter_mut().zip(self.angles) {
            let ([sine], [cosine]) = Scalar::sin_cos_each([*angle]);
            *wave = (sine, cosine);
        }
    }
}
