//! How cost grows with the number of bodies: generated kernels of chains and N-four-bar mechanisms beside equations
//! written by hand, in one run. `cargo bench -p tests --features scale --bench scale`
//!
//! The sizes stand in `tests/src/declarations.rs`.
//!
//! The time of a long kernel depends on where its code lies, by half its value from build to build. Compare figures of
//! several builds.

#![allow(missing_docs, clippy::unwrap_used)]

use codegen::kernel_id::KernelId;
use codegen::{Derived, emit};
use quote::quote;
use sim_kernel::Compiled;
use std::hint::black_box;
use std::path::{Path, PathBuf};
use std::process::Command;
use std::time::{Duration, Instant};
use tests::by_hand::{Chain, FourBars, FourBarsSolution, chain_absolute, chain_relative, four_bars};
use tests::declarations::{self, Angles};
use tests::{Random, interleaved};

include!(concat!(env!("OUT_DIR"), "/scale.rs"));

const RUNS: usize = 100;
const STATES: usize = 64;

/// Nanoseconds of a generated and of a hand-written call, each independent of the last or depending on it.
struct Times {
    size: usize,
    generated: [f64; 2],
    by_hand: [f64; 2],
}

/// What it took to make a kernel.
struct Making {
    derivation: Duration,
    statements: usize,
    compilation: Option<Duration>,
}

fn main() {
    let sine = interleaved(
        RUNS,
        &mut [&mut || {
            for i in 0..STATES {
                black_box(black_box(0.1 * i as f64).sin_cos());
            }
        }],
    );
    println!("standard f64::sin_cos: {:.1} ns; minimum of {RUNS} runs", per_state(sine[0]));
    macro_rules! measure_chain {
        ($mechanism:ident, $rods:literal, Absolute) => {
            (Angles::Absolute, chain_times::<$mechanism, $rods>(chain_absolute::<$rods>))
        };
        ($mechanism:ident, $rods:literal, Relative) => {
            (Angles::Relative, chain_times::<$mechanism, $rods>(chain_relative::<$rods>))
        };
    }
    let measured = chains!(measure_chain);
    for angles in [Angles::Absolute, Angles::Relative] {
        let times: Vec<&Times> = measured.iter().filter(|(kind, _)| *kind == angles).map(|(_, times)| times).collect();
        let text = |rods: usize| (declarations::chain_name(rods, angles), declarations::chain(rods, angles));
        report(&format!("chain of rods, {angles:?} angles").to_lowercase(), &times, text);
    }
    macro_rules! measure_linkage {
        ($mechanism:ident, $loops:literal, $cranks:literal, $links:literal) => {
            four_bar_times::<$mechanism, $loops, $cranks, $links>()
        };
    }
    let times = linkages!(measure_linkage);
    let text = |loops: usize| (declarations::four_bars_name(loops), declarations::four_bars(loops));
    report("four-bars side by side", &times.iter().collect::<Vec<_>>(), text);
}

fn report(title: &str, times: &[&Times], declaration: impl Fn(usize) -> (String, String)) {
    println!("\n{title}: ns per right-hand side, of independent and of dependent calls");
    println!(
        "{:>5} {:>21} {:>21} {:>13} {:>16} {:>11} {:>12}",
        "n", "generated", "by hand", "ratio", "derive+emit [ms]", "statements", "rustc [s]"
    );
    let mut derivations = Vec::new();
    for Times { size, generated, by_hand } in times {
        let (name, text) = declaration(*size);
        let Making { derivation, statements, compilation } = making(&name, &text);
        derivations.push((*size, 1e3 * derivation.as_secs_f64()));
        let ratio = [generated[0] / by_hand[0], generated[1] / by_hand[1]];
        let compilation = compilation.map_or("-".to_owned(), |time| format!("{:.2}", time.as_secs_f64()));
        println!(
            "{size:>5} {:>10.1} {:>10.1} {:>10.1} {:>10.1} {:>6.2} {:>6.2} {:>16.2} {statements:>11} {compilation:>12}",
            generated[0],
            generated[1],
            by_hand[0],
            by_hand[1],
            ratio[0],
            ratio[1],
            derivations[derivations.len() - 1].1
        );
    }
    let of = |time: &dyn Fn(&Times) -> f64| exponent(&times.iter().map(|t| (t.size, time(t))).collect::<Vec<_>>());
    println!(
        "growth exponent over the larger half: generated {:.2}, by hand {:.2}, derivation {:.2}",
        of(&|t| t.generated[0]),
        of(&|t| t.by_hand[0]),
        exponent(&derivations)
    );
}

/// The slope of the logarithms from the middle size to the largest.
fn exponent(values: &[(usize, f64)]) -> f64 {
    let ((small, less), (large, more)) = (values[(values.len() - 1) / 2], values[values.len() - 1]);
    (more / less).ln() / (large as f64 / small as f64).ln()
}

fn per_state(time: Duration) -> f64 {
    time.as_secs_f64() * 1e9 / STATES as f64
}

fn chain_times<M, const N: usize>(by_hand: fn(&Chain, &[f64; N], &[f64; N]) -> [f64; N]) -> Times
where
    M: Compiled<Q = [f64; N], Parameters = [f64; 3]>,
{
    let mut random = Random(31);
    let states = std::array::from_fn(|_| [3.0, 3.0].map(|size| std::array::from_fn(|_| random.between(-size, size))));
    let [m, l, g] = M::defaults().parameters();
    let (prepared, parameters) = (black_box(M::defaults().prepare()), black_box(Chain { m, l, g }));
    let generated = |[q, qd]: &[[f64; N]; 2]| M::prepared_dynamics(&prepared, 0.0, q, qd).accelerations;
    times(N, &states, &generated, &|[q, qd]| by_hand(&parameters, q, qd))
}

fn four_bar_times<M, const N: usize, const K: usize, const LINKS: usize>() -> Times
where
    M: Compiled<Q = [f64; LINKS], Parameters = [f64; 3]>,
{
    let mut random = Random(32);
    let states = std::array::from_fn(|_| {
        let mut angle = |i: usize| if i < K { random.between(0.9, 1.9) } else { random.between(-0.3, 0.3) };
        let q = std::array::from_fn(&mut angle);
        [q, std::array::from_fn(|_| random.between(-3.0, 3.0))]
    });
    let [m, l, g] = M::defaults().parameters();
    let (prepared, parameters) = (black_box(M::defaults().prepare()), black_box(FourBars { m, l, g }));
    let generated = |[q, qd]: &[[f64; LINKS]; 2]| {
        let solved = M::prepared_dynamics(&prepared, 0.0, q, qd);
        black_box(solved.multipliers);
        solved.accelerations
    };
    let by_hand = |[q, qd]: &[[f64; LINKS]; 2]| {
        let (cranks, couplers) = (q.first_chunk::<K>().unwrap(), q.last_chunk::<N>().unwrap());
        let (crank_rates, coupler_rates) = (qd.first_chunk::<K>().unwrap(), qd.last_chunk::<N>().unwrap());
        let found: FourBarsSolution<N, K> = four_bars(&parameters, cranks, couplers, crank_rates, coupler_rates);
        black_box(found.reactions);
        std::array::from_fn(|i| if i < K { found.cranks[i] } else { found.couplers[i - K] })
    };
    times(N, &states, &generated, &by_hand)
}

/// Both routes in turn, after seeing that they agree.
fn times<const Q: usize>(
    size: usize,
    states: &[[[f64; Q]; 2]; STATES],
    generated: &impl Fn(&[[f64; Q]; 2]) -> [f64; Q],
    by_hand: &impl Fn(&[[f64; Q]; 2]) -> [f64; Q],
) -> Times {
    for state in states {
        let (found, expected) = (generated(state), by_hand(state));
        let norm = expected.iter().fold(0.0f64, |norm, x| norm.max(x.abs()));
        // Rounding times the condition of such systems, which tests bound by 1e8.
        assert!(found.iter().zip(expected).all(|(a, b)| (a - b).abs() <= 1e-7 * norm), "{found:?} {expected:?}");
    }
    let found = interleaved(
        RUNS,
        &mut [
            &mut || independent(states, generated),
            &mut || independent(states, by_hand),
            &mut || dependent(states, generated),
            &mut || dependent(states, by_hand),
        ],
    );
    let ns: Vec<f64> = found.into_iter().map(per_state).collect();
    Times { size, generated: [ns[0], ns[2]], by_hand: [ns[1], ns[3]] }
}

#[inline(never)]
fn independent<const Q: usize>(states: &[[[f64; Q]; 2]; STATES], route: &impl Fn(&[[f64; Q]; 2]) -> [f64; Q]) {
    for state in states {
        black_box(route(black_box(state)));
    }
}

/// Each call gets a state that the one before has changed, by nothing.
#[inline(never)]
fn dependent<const Q: usize>(states: &[[[f64; Q]; 2]; STATES], route: &impl Fn(&[[f64; Q]; 2]) -> [f64; Q]) {
    let mut last = 0.0;
    for state in states {
        let mut state = *state;
        state[0].iter_mut().for_each(|q| *q += 1e-300 * last);
        last = black_box(route(&state))[0];
    }
}

fn making(name: &str, declaration: &str) -> Making {
    let derive = || {
        let derived = codegen::derive(declaration.parse().unwrap()).unwrap();
        let Derived { head, description, equations, program } = &derived;
        let rust = emit::emit(head, description, equations, program, &quote!(sim_kernel));
        (derived.program, rust)
    };
    let derivation = (0..3).map(|_| {
        let clock = Instant::now();
        black_box(derive());
        clock.elapsed()
    });
    let derivation = derivation.min().unwrap();
    let (program, rust) = derive();
    let kernel = program.kernels.iter().find(|kernel| kernel.id == KernelId::Dynamics).unwrap();
    let statements = kernel.statements.len() + kernel.pieces.iter().map(|piece| piece.statements.len()).sum::<usize>();
    Making {
        derivation,
        statements,
        compilation: compilation(name, &codegen::emit::format(rust).ok().unwrap_or_default()),
    }
}

/// rustc on the emitted file alone, optimised, `dynamics` in numbers of type f64; none if it cannot be run.
fn compilation(name: &str, rust: &str) -> Option<Duration> {
    let dependencies = std::env::current_exe().ok()?.parent()?.to_owned();
    let kernel = newest(&dependencies, "libsim_kernel-", ".rlib")?;
    let directory = std::env::temp_dir().join(format!("linkwright-scale-{}", std::process::id()));
    std::fs::create_dir_all(&directory).ok()?;
    let source = directory.join(format!("{}.rs", name.to_lowercase()));
    let call = format!(
        "type M = {name}; type Of<T> = T; use sim_kernel::Mechanism;\n\
         pub fn call(p: &Of<<M as Mechanism>::Prepared>, q: &<M as Mechanism>::Q, qd: &<M as Mechanism>::Q)\n\
         -> sim_kernel::Dynamics<f64, <M as Mechanism>::Q, <M as Mechanism>::L> {{\n\
         <M as Mechanism>::prepared_dynamics(p, 0.0, q, qd) }}\n"
    );
    std::fs::write(&source, format!("{rust}\n{call}")).ok()?;
    let clock = Instant::now();
    let output = Command::new("rustc")
        .args(["--edition", "2024", "--crate-type", "lib", "-C", "opt-level=3", "--emit", "link", "-A", "warnings"])
        .arg("--extern")
        .arg(format!("sim_kernel={}", kernel.display()))
        .arg("-L")
        .arg(format!("dependency={}", dependencies.display()))
        .arg("--out-dir")
        .arg(&directory)
        .arg(&source)
        .output()
        .ok()?;
    let time = clock.elapsed();
    if !output.status.success() {
        eprintln!("{}", String::from_utf8_lossy(&output.stderr));
    }
    let _ = std::fs::remove_dir_all(&directory);
    output.status.success().then_some(time)
}

fn newest(directory: &Path, prefix: &str, suffix: &str) -> Option<PathBuf> {
    let files = std::fs::read_dir(directory).ok()?.flatten().map(|entry| entry.path());
    let wanted = files.filter(|path| {
        let name = path.file_name().map(|name| name.to_string_lossy().into_owned()).unwrap_or_default();
        name.starts_with(prefix) && name.ends_with(suffix)
    });
    wanted.max_by_key(|path| path.metadata().and_then(|data| data.modified()).ok())
}
