//! Files with letters and words left out, doubled, exchanged and replaced: what is accepted solves its own equations, and
//! nothing panics.

use sim::{At, DeclarationFile, Kernel, Model};
use std::path::Path;
use std::time::{Duration, Instant};
use tests::{Random, shipped};

/// `LINKWRIGHT_FUZZ=200` makes two hundred times as many, by `LINKWRIGHT_SEED=N` from another one on.
const CASES: usize = 500;
/// The elimination refuses a pivot that has lost half of the digits, so that the rest of them are right.
const BOUND: f64 = 1e-6;

/// What is put in for other words.
const WORDS: &[&str] = &[
    "x",
    "t",
    "pi",
    "0",
    "1",
    "-1",
    "2.5",
    "1e400",
    "[m]",
    "[rad]",
    "[x, 0]",
    "()",
    "{",
    "}",
    "(",
    ")",
    ";",
    ",",
    ":",
    "=",
    "*",
    "/",
    "^",
    "dot",
    "ddot",
    "reaction",
    "norm",
    "sqrt",
    "let",
    "mass",
    "inertia",
    "angle",
    "force",
    "guess",
    "run",
    "language 2;",
    "\u{1d70b}",
    "\"",
    "//",
    "/*",
    "#",
    "'",
    "\\",
    "\0",
    "bodies",
    "constraints",
    "x^99",
    "1/0",
    "abs(x)",
    "steps",
];

fn mangled(text: &str, random: &mut Random) -> String {
    let below = |random: &mut Random, n: usize| (random.between(0.0, n as f64) as usize).min(n.saturating_sub(1));
    let mut words: Vec<String> = text.split_inclusive([' ', '\n', ';', '*', '(', ')']).map(str::to_owned).collect();
    for _ in 0..1 + below(random, 3) {
        let (at, other) = (below(random, words.len()), below(random, words.len()));
        match below(random, 5) {
            0 => words[at].clear(),
            1 => words.swap(at, other),
            2 => words[at] = words[other].clone(),
            3 => words[at] = format!("{} ", WORDS[below(random, WORDS.len())]),
            _ => {
                let letters = words[at].chars().count();
                let drop = below(random, letters.max(1));
                words[at] = words[at].chars().enumerate().filter(|(i, _)| *i != drop).map(|(_, c)| c).collect();
            }
        }
    }
    words.concat()
}

fn rows(model: &dyn Model, kernel: Kernel, at: At<f64>) -> (Vec<Vec<f64>>, bool) {
    let mut rows = Vec::new();
    let refused = model.call(kernel, at, &mut |_, row| rows.push(row.to_vec()));
    (rows, refused)
}

/// How far M q'' + C_q' lambda is off Q - h, and C_q q'' off what C'' leaves, relative to what their terms may be.
fn residual(model: &dyn Model, at: At<f64>) -> f64 {
    let (solved, refused) = rows(model, Kernel::Dynamics, at);
    if refused || solved.iter().flatten().any(|value| !value.is_finite()) {
        return 0.0;
    }
    let (accelerations, multipliers) = (&solved[0], &solved[1]);
    let of = |kernel| rows(model, kernel, at).0;
    let (mass, jacobian) = (of(Kernel::MassMatrix), of(Kernel::ConstraintJacobian));
    let [h, loads, convective] = [Kernel::ConvectiveForces, Kernel::GeneralizedForces, Kernel::ConstraintConvective]
        .map(|kernel| of(kernel).concat());
    let active = |row: usize| {
        let holds = model.values().activities;
        let conditionals = model.description().conditionals.iter().zip(holds);
        !conditionals.into_iter().any(|(c, holds)| holds == 0.0 && (c.first_row..c.first_row + c.rows).contains(&row))
    };
    let largest = |values: &[f64]| values.iter().fold(0.0, |most: f64, value| most.max(value.abs()));
    // Where reactions balance loads, accelerations are the small rest of what either would cause.
    let free = (0..accelerations.len()).map(|i| (h[i].abs() + loads[i].abs()) / mass[i][i]);
    let most = free.filter(|acceleration| acceleration.is_finite()).fold(largest(accelerations), f64::max);
    let strongest = largest(multipliers);
    let relative = |sum: f64, size: f64| if size > 0.0 && size.is_finite() { (sum / size).abs() } else { 0.0 };
    let of_coordinate = |i: usize| {
        let (mut sum, mut size) = (h[i] - loads[i], h[i].abs() + loads[i].abs());
        for (entry, acceleration) in mass[i].iter().zip(accelerations) {
            (sum, size) = (sum + entry * acceleration, size + entry.abs() * most);
        }
        for (row, lambda) in jacobian.iter().zip(multipliers) {
            (sum, size) = (sum + row[i] * lambda, size + row[i].abs() * strongest);
        }
        relative(sum, size)
    };
    let of_constraint = |row: usize| {
        let (mut sum, mut size) = (convective[row], convective[row].abs());
        for (entry, acceleration) in jacobian[row].iter().zip(accelerations) {
            (sum, size) = (sum + entry * acceleration, size + entry.abs() * most);
        }
        if active(row) { relative(sum, size) } else { 0.0 }
    };
    let coordinates = (0..accelerations.len()).map(of_coordinate);
    coordinates.chain((0..multipliers.len()).map(of_constraint)).fold(0.0, f64::max)
}

#[test]
fn mangled_files_are_refused_or_understood() {
    let texts: Vec<&str> = shipped().into_iter().map(|description| description.declaration).collect();
    let (mut accepted, mut slowest) = (0, Duration::ZERO);
    let given = |name: &str| std::env::var(name).ok().and_then(|text| text.parse::<usize>().ok());
    let (cases, first) = (CASES * given("LINKWRIGHT_FUZZ").unwrap_or(1), given("LINKWRIGHT_SEED").unwrap_or(0));
    for seed in first..first + cases {
        let random = &mut Random(seed as u64);
        let text = mangled(texts[seed % texts.len()], random);
        let clock = Instant::now();
        let file = DeclarationFile::of(Path::new("mangled.mech"), text.clone());
        match file.model(None) {
            Err(failure) => assert!(!failure.to_string().is_empty(), "{text}"),
            Ok(model) => {
                accepted += 1;
                let n = model.description().coordinates.len();
                for _ in 0..3 {
                    let [q, qd] = [0, 1].map(|_| (0..n).map(|_| random.between(-1.0, 1.0)).collect::<Vec<f64>>());
                    let multipliers = vec![1.0; model.description().constraints.len()];
                    let at =
                        At { time: 0.3, positions: &q, speeds: &qd, accelerations: &qd, multipliers: &multipliers };
                    Kernel::ALL.iter().for_each(|kernel| {
                        rows(&*model, *kernel, at);
                    });
                    let residual = residual(&*model, at);
                    assert!(residual <= BOUND, "seed {seed}: {residual:e}\n{text}");
                }
            }
        }
        slowest = slowest.max(clock.elapsed());
    }
    println!("{cases} files, {accepted} accepted, the slowest took {slowest:?}");
    assert!(accepted > cases / 20);
}
