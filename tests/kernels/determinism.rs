//! The same declaration gives the same bytes, in one process and in two.

use crate::all;
use quote::quote;
use std::process::Command;

fn generated() -> String {
    let texts = all::descriptions().into_iter().step_by(EVERY).map(|description| {
        let tokens = codegen::generate(description.declaration.parse().unwrap(), &quote!(sim_kernel)).unwrap();
        codegen::emit::format(tokens).unwrap()
    });
    texts.collect::<Vec<_>>().concat()
}

/// FNV-1a, so that two processes can compare by one line of output.
fn digest(text: &str) -> u64 {
    text.bytes().fold(0xcbf2_9ce4_8422_2325, |hash, byte| (hash ^ u64::from(byte)).wrapping_mul(0x0100_0000_01b3))
}

const EXPANSIONS: usize = tests::sampled(3, 10);
/// A debug build expands every so many declarations.
const EVERY: usize = tests::sampled(3, 1);

#[test]
fn expansions_in_two_processes_give_equal_bytes() {
    let first = generated();
    if std::env::var_os("DIGEST_ONLY").is_some() {
        println!("digest {:x}", digest(&first));
        return;
    }
    for _ in 1..EXPANSIONS {
        assert_eq!(first, generated());
    }
    let name = "determinism::expansions_in_two_processes_give_equal_bytes";
    let other = Command::new(std::env::current_exe().unwrap())
        .args(["--exact", name, "--nocapture"])
        .env("DIGEST_ONLY", "1")
        .output()
        .unwrap();
    let expected = format!("digest {:x}", digest(&first));
    let printed = String::from_utf8(other.stdout).unwrap();
    assert!(printed.contains(&expected), "{printed}");
}

/// The text that a mechanism carries is a declaration of the same mechanism.
#[test]
fn the_carried_text_declares_the_same_mechanism() {
    for description in all::descriptions() {
        let tokens: proc_macro2::TokenStream = description.declaration.parse().unwrap();
        assert_eq!(codegen::dsl::source_text(tokens), description.declaration, "{}", description.name);
        // The macro has seen other tokens: its own layout, and documentation as attributes.
        let tokens: proc_macro2::TokenStream = description.declaration.parse().unwrap();
        assert_eq!(codegen::dsl::hash(tokens), description.declaration_hash, "{}", description.name);
        let equations = codegen::equations(description.declaration.parse().unwrap()).unwrap();
        assert_eq!(equations.model.name, description.type_name);
    }
}
