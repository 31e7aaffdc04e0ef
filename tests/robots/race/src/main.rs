//! Times of five robots' kernels beside those of Pinocchio: `race PROGRAM FOLDER`, the program of `pinocchio.cpp` and the robots'
//! files.
//!
//! Both are the least mean of 200 rounds over 256 states, on one core. They take turns, since a processor may change its clock
//! between them, and each turn is a process of its own (`race ROBOT`), since where its memory lies changes times by a third.
//! Pinocchio's mass matrix is that of the base's velocity in its own frame, as `speed_mass_matrix` is.

use mechanism_macros::mechanism;
use sim_kernel::Mechanism;
use std::hint::black_box;
use std::path::Path;
use std::process::{Command, ExitCode};
use std::time::Instant;

include!("../../declared/ur5.rs");
include!("../../declared/talosarm.rs");
include!("../../declared/panda.rs");
include!("../../declared/anymal.rs");
include!("../../declared/talos.rs");

/// The same robots with the derivatives of forward dynamics.
mod derivatives {
    use mechanism_macros::mechanism;

    include!(concat!(env!("OUT_DIR"), "/ur5.rs"));
    include!(concat!(env!("OUT_DIR"), "/talosarm.rs"));
    include!(concat!(env!("OUT_DIR"), "/panda.rs"));
    include!(concat!(env!("OUT_DIR"), "/anymal.rs"));
    include!(concat!(env!("OUT_DIR"), "/talos.rs"));
}

const TURNS: usize = 5;
const ROUNDS: usize = 200;
const STATES: usize = 256;

/// The least mean time of a call at each state, in nanoseconds.
fn least(mut call: impl FnMut(usize)) -> f64 {
    let rounds = (0..ROUNDS).map(|_| {
        let clock = Instant::now();
        (0..STATES).for_each(&mut call);
        clock.elapsed().as_nanos() as f64 / STATES as f64
    });
    rounds.fold(f64::INFINITY, f64::min)
}

/// Positions and speeds of the k-th state; a free base has a quaternion in the end, of norm 1.
fn state<Q: AsMut<[f64]> + Copy>(of: Q, is_free: bool, k: usize) -> [Q; 2] {
    let (mut positions, mut speeds) = (of, of);
    let (q, qd) = (positions.as_mut(), speeds.as_mut());
    for i in 0..q.len() {
        q[i] = (0.3 + 0.61 * (7 * i + k) as f64).sin();
        qd[i] = (0.1 + 0.37 * (5 * i + k) as f64).cos();
    }
    if is_free {
        let quaternion = q.len() - 4;
        let norm = q[quaternion..].iter().map(|x| x * x).sum::<f64>().sqrt();
        q[quaternion..].iter_mut().for_each(|x| *x /= norm);
    }
    [positions, speeds]
}

/// Nanoseconds of forward dynamics, inverse dynamics, the mass matrix and the derivatives of forward dynamics.
type Times = [f64; 4];

/// Measures those of a robot.
macro_rules! times {
    ($robot:ident, $mass_matrix:ident, $is_free:expr) => {
        || -> Times {
            let robot = $robot::default();
            let prepared = robot.prepare();
            let derived = derivatives::$robot::default();
            let states: Vec<_> = (0..STATES).map(|k| state(robot.initial().positions, $is_free, k)).collect();
            [
                least(|k| {
                    let [q, qd] = &states[k];
                    black_box($robot::prepared_dynamics(black_box(&prepared), 0.0, q, qd));
                }),
                least(|k| {
                    let [q, qd] = &states[k];
                    black_box(black_box(&robot).inverse_dynamics(0.0, q, qd, qd));
                }),
                least(|k| {
                    let [q, _] = &states[k];
                    black_box(black_box(&robot).$mass_matrix(0.0, q));
                }),
                least(|k| {
                    let [q, qd] = &states[k];
                    black_box(black_box(&derived).dynamics_jacobian(0.0, q, qd));
                }),
            ]
        }
    };
}

/// Pinocchio's names of what is measured.
const ALGORITHMS: [&str; 4] = ["aba", "rnea", "crba", "derivatives of aba"];

/// A robot in both.
struct Robot {
    name: &'static str,
    /// Below the folder of the robots' files.
    file: &'static str,
    base: &'static str,
    times: fn() -> Times,
    /// The largest ratios to Pinocchio's times.
    bounds: [f64; 4],
}

const ROBOTS: [Robot; 5] = [
    robot("UR5", UR5, "fixed", times!(Ur5, mass_matrix, false), [0.10, 0.12, 0.2, 0.5]),
    robot("Talos' arm", ARM, "fixed", times!(Talosarm, mass_matrix, false), [0.22, 0.20, 0.25, 0.5]),
    robot("Panda", PANDA, "fixed", times!(Panda, mass_matrix, false), [0.24, 0.20, 0.25, 0.5]),
    robot("ANYmal", ANYMAL, "free", times!(Anymal, speed_mass_matrix, true), [0.27, 0.30, 0.25, 0.5]),
    robot("Talos", TALOS, "free", times!(Talos, speed_mass_matrix, true), [0.30, 0.32, 0.40, 0.8]),
];

const UR5: &str = "ur_description/urdf/ur5_robot.urdf";
const ARM: &str = "talos_data/robots/talos_left_arm.urdf";
const PANDA: &str = "panda_description/urdf/panda.urdf";
const ANYMAL: &str = "anymal_b_simple_description/robots/anymal.urdf";
const TALOS: &str = "talos_data/robots/talos_reduced.urdf";

const fn robot(
    name: &'static str,
    file: &'static str,
    base: &'static str,
    times: fn() -> Times,
    bounds: [f64; 4],
) -> Robot {
    Robot { name, file, base, times, bounds }
}

/// What a program takes for `aba`, `rnea`, `crba` and the derivatives of `aba`, from the line that it prints.
fn times_of(command: &mut Command) -> Result<Times, String> {
    let output = command.output().map_err(|error| format!("cannot run {command:?}: {error}"))?;
    let line = String::from_utf8_lossy(&output.stdout);
    let of = |name: &str| {
        let (_, rest) = [": ", ", "].iter().find_map(|before| line.split_once(&format!("{before}{name} ")))?;
        rest.split([',', ' ']).next()?.parse().ok()
    };
    match ALGORITHMS.map(of) {
        [Some(aba), Some(rnea), Some(crba), Some(derivatives)] => Ok([aba, rnea, crba, derivatives]),
        _ => Err(format!("{command:?} gives no times: {}", String::from_utf8_lossy(&output.stderr))),
    }
}

/// The times of both, ours first.
fn turn(own: &Path, program: &str, folder: &Path, robot: &Robot) -> Result<[Times; 2], String> {
    let ours = times_of(Command::new(own).arg(robot.name))?;
    Ok([ours, times_of(Command::new(program).arg(folder.join(robot.file)).arg(robot.base))?])
}

/// Races all robots in turns, prints the ratios of the least times, and says how many are too large.
fn race(program: &str, folder: &Path) -> Result<usize, String> {
    let own = std::env::current_exe().map_err(|error| error.to_string())?;
    let mut best = [[[f64::INFINITY; 4]; 2]; ROBOTS.len()];
    for _ in 0..TURNS {
        for (robot, best) in ROBOTS.iter().zip(&mut best) {
            let times = turn(&own, program, folder, robot)?;
            for (best, time) in best.as_flattened_mut().iter_mut().zip(times.as_flattened()) {
                *best = best.min(*time);
            }
        }
    }
    Ok(ROBOTS.iter().zip(&best).map(|(robot, [ours, others])| print_ratios(robot, ours, others)).sum())
}

/// How many ratios are too large.
fn print_ratios(robot: &Robot, ours: &Times, others: &Times) -> usize {
    let mut missed = 0;
    for (i, what) in ["forward dynamics", "inverse dynamics", "mass matrix", "derivatives"].into_iter().enumerate() {
        let (ratio, bound) = (ours[i] / others[i], robot.bounds[i]);
        let verdict = if ratio <= bound { "met" } else { "MISSED" };
        missed += usize::from(ratio > bound);
        println!(
            "{:<32}{:>7.0} ns beside {:>6.0}: {ratio:.3}, at most {bound:.2}  {verdict}",
            format!("{}: {what}", robot.name),
            ours[i],
            others[i]
        );
    }
    missed
}

/// Prints our times of a robot, as Pinocchio's program does.
fn print_times(name: &str) -> Result<(), String> {
    let robot = ROBOTS.iter().find(|robot| robot.name == name).ok_or(format!("no robot is called {name}"))?;
    let times = ALGORITHMS.iter().zip((robot.times)()).map(|(name, time)| format!("{name} {time}"));
    println!("{name}: {} ns", times.collect::<Vec<_>>().join(", "));
    Ok(())
}

fn main() -> ExitCode {
    let arguments: Vec<String> = std::env::args().skip(1).collect();
    let done = match arguments.as_slice() {
        [robot] => print_times(robot).map(|()| 0),
        [program, folder] => race(program, Path::new(folder)),
        _ => Err("expected Pinocchio's program and the folder of the robots' files; race.sh gives both".into()),
    };
    match done {
        Ok(missed) => ExitCode::from(u8::from(missed > 0)),
        Err(message) => {
            eprintln!("race: {message}");
            ExitCode::from(2)
        }
    }
}
