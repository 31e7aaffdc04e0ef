//! Files with letters and words left out, doubled, exchanged and replaced: what is accepted gives what the oracle gives, and
//! nothing panics.

use crate::against_oracle::{Derivatives, compare};
use sim::DeclarationFile;
use std::path::Path;
use std::time::{Duration, Instant};
use tests::{Random, peak_memory, shipped};

/// `LINKWRIGHT_FUZZ=200` makes two hundred times as many, by `LINKWRIGHT_SEED=N` from another one on.
const CASES: usize = 500;
/// Where each accepted file is evaluated.
const STATES: usize = 3;

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

#[test]
fn mangled_files_are_refused_or_understood() {
    let texts: Vec<&str> = shipped().into_iter().map(|description| description.declaration).collect();
    let (mut accepted, mut slowest, mut derivatives) = (0, Duration::ZERO, Derivatives::default());
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
                if let Err(why) = compare(&model, STATES, random, &mut derivatives) {
                    panic!("seed {seed}: {why}\n{text}");
                }
            }
        }
        slowest = slowest.max(clock.elapsed());
    }
    println!("{cases} files, {accepted} accepted; {derivatives:?}");
    println!("the slowest file, in s: {:.3}", slowest.as_secs_f64());
    println!("the most memory, in MB: {:.1}", peak_memory().unwrap_or(0) as f64 / 1e6);
    assert!(accepted > cases / 20);
    // Where a difference quotient spans a kink, or the equations are nearly singular, two of them differ.
    assert!(derivatives.compared > 2 * derivatives.undecided, "{derivatives:?}");
}
