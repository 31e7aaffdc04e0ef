//! Declarations through rustc: what it shows where, that one mistake shows once, and that what the language
//! reference shows compiles.

#![allow(missing_docs, clippy::unwrap_used)]

mod names_of_mechanisms;
mod names_of_rust;

use std::path::Path;
use std::{env, fs};

#[test]
fn declarations_through_rustc() {
    let cases = trybuild::TestCases::new();
    cases.pass(examples_of_the_reference());
    cases.compile_fail("../tests/language/fail/*.rs");
}

/// A program of all complete declarations in LANGUAGE.md.
fn examples_of_the_reference() -> String {
    let text = fs::read_to_string("../LANGUAGE.md").unwrap();
    let examples: Vec<&str> = text.split("```rust\n").skip(1).filter_map(|rest| rest.split("```").next()).collect();
    assert!(!examples.is_empty());
    let program = format!("use mechanism_macros::mechanism;\n{}\nfn main() {{}}\n", examples.concat());
    let path = Path::new(env!("CARGO_TARGET_TMPDIR")).join("language_reference.rs");
    fs::write(&path, program).unwrap();
    path.to_str().unwrap().to_owned()
}
