//! Files with letters and words left out, doubled, exchanged and replaced: what is accepted gives what the oracle gives, and
//! nothing panics.

use crate::against_oracle::{Derivatives, compare};
use sim::DeclarationFile;
use std::path::Path;
use std::time::{Duration, Instant};
use tests::mangling::{mangled, seeds};
use tests::{Random, peak_memory, shipped};

/// `LINKWRIGHT_FUZZ` and `LINKWRIGHT_SEED` choose others.
const CASES: usize = 500;
/// Where each accepted file is evaluated.
const STATES: usize = 3;

/// Words end with these.
const SEPARATORS: [char; 6] = [' ', '\n', ';', '*', '(', ')'];

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

#[test]
fn mangled_files_are_refused_or_understood() {
    let texts: Vec<&str> = shipped().into_iter().map(|description| description.declaration).collect();
    let (mut accepted, mut slowest, mut derivatives) = (0, Duration::ZERO, Derivatives::default());
    let seeds = seeds(CASES);
    let cases = seeds.len();
    for seed in seeds {
        let random = &mut Random(seed as u64);
        let text = mangled(texts[seed % texts.len()], &SEPARATORS, WORDS, random);
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
