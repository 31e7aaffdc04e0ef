//! Times of five robots' kernels beside those of Pinocchio, which stand in the file of the first argument.
//!
//! Both are the least mean of 200 rounds over 256 states, on one core. Pinocchio's mass matrix is that of the base's velocity in
//! its own frame, as `speed_mass_matrix` is.

use sim_kernel::{Mechanism, mechanism};
use std::hint::black_box;
use std::process::ExitCode;
use std::time::Instant;

include!("../../declared/ur5.rs");
include!("../../declared/talosarm.rs");
include!("../../declared/panda.rs");
include!("../../declared/anymal.rs");
include!("../../declared/talos.rs");

/// The same robots with the derivatives of forward dynamics.
mod derivatives {
    use sim_kernel::mechanism;

    include!(concat!(env!("OUT_DIR"), "/ur5.rs"));
    include!(concat!(env!("OUT_DIR"), "/talosarm.rs"));
    include!(concat!(env!("OUT_DIR"), "/panda.rs"));
    include!(concat!(env!("OUT_DIR"), "/anymal.rs"));
    include!(concat!(env!("OUT_DIR"), "/talos.rs"));
}

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

/// Forward dynamics, inverse dynamics, the mass matrix and the derivatives of forward dynamics of a robot.
macro_rules! times {
    ($robot:ident, $mass_matrix:ident, $is_free:expr) => {{
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
    }};
}

/// What Pinocchio takes for `aba`, `rnea`, `crba` and the derivatives of `aba`, from the line that names the robot's file.
fn of_pinocchio(text: &str, file: &str) -> Option<[f64; 4]> {
    let line = text.lines().find(|line| line.starts_with(file))?;
    let of = |name: &str| {
        let (_, rest) = line.split_once(&format!("{name} "))?;
        rest.split([',', ' ']).next()?.parse().ok()
    };
    Some([of(": aba")?, of(", rnea")?, of(", crba")?, of(", derivatives of aba")?])
}

fn main() -> ExitCode {
    let text = std::env::args().nth(1).and_then(|path| std::fs::read_to_string(path).ok());
    let Some(text) = text else {
        eprintln!("race: the first argument is a file with Pinocchio's times; race.sh writes it");
        return ExitCode::from(2);
    };
    let robots = [
        ("UR5", "ur5_robot", times!(Ur5, mass_matrix, false), [0.10, 0.12, 0.2, 0.5]),
        ("Talos' arm", "talos_left_arm", times!(Talosarm, mass_matrix, false), [0.22, 0.20, 0.25, 0.5]),
        ("Panda", "panda", times!(Panda, mass_matrix, false), [0.24, 0.20, 0.25, 0.5]),
        ("ANYmal", "anymal", times!(Anymal, speed_mass_matrix, true), [0.27, 0.30, 0.25, 0.5]),
        ("Talos", "talos_reduced", times!(Talos, speed_mass_matrix, true), [0.30, 0.32, 0.40, 0.8]),
    ];
    let mut missed = 0;
    for (robot, file, times, bounds) in robots {
        let Some(others) = of_pinocchio(&text, file) else {
            eprintln!("race: Pinocchio's times of `{file}` are missing");
            return ExitCode::from(2);
        };
        for (i, what) in ["forward dynamics", "inverse dynamics", "mass matrix", "derivatives"].into_iter().enumerate()
        {
            let (ratio, bound) = (times[i] / others[i], bounds[i]);
            let verdict = if ratio <= bound { "met" } else { "MISSED" };
            missed += usize::from(ratio > bound);
            println!(
                "{:<32}{:>7.0} ns beside {:>6.0}: {ratio:.3}, at most {bound:.2}  {verdict}",
                format!("{robot}: {what}"),
                times[i],
                others[i]
            );
        }
    }
    ExitCode::from(u8::from(missed > 0))
}
