//! Mistakes in declarations: each shows at the user's own word and says what would be right.
//!
//! A row replaces one part of a sound declaration, and lists all mistakes that are then found.

#![allow(missing_docs, clippy::unwrap_used)]

mod auxiliary;
mod bare_degrees;
mod bases;
mod blocks;
mod bodies;
mod conditional;
mod constraints;
mod constraints_in_speeds;
mod cycles;
mod elements;
mod events;
mod expressions;
mod frames;
mod joints;
mod limits;
mod loads;
mod names;
mod new_users;
mod outputs;
mod parameters;
mod reuse;
mod run;
mod space;
mod spanning_tree;
mod speeds;
mod start;
mod tables;
mod units;
mod units_of_blocks;

use proc_macro2::TokenStream;
use quote::quote;

const SOUND: &str = "pub Pendulum;
coordinates { phi [rad]; }
parameters { l [m] = 1; m [kg] = 2; g [m/s^2] = 9.81; }
let P = l*[sin(phi), -cos(phi)];
bodies { bob: mass m at P, angle phi; }
loads { gravity [0, -g]; }
initial { phi = 0.5; }
outputs { height [m] = P.y; }
drawing { line [0, 0], P; }
";

/// The mistakes of a text as `line:column message`.
fn mistakes(text: &str) -> Vec<String> {
    let tokens: TokenStream = text.parse().unwrap();
    let place = |e: &syn::Error| format!("{}:{}", e.span().start().line, e.span().start().column + 1);
    match codegen::generate(tokens, &quote!(sim_kernel)) {
        Ok(_) => vec![],
        Err(error) => error.into_iter().map(|e| format!("{} {e}", place(&e))).collect(),
    }
}

/// Replaces one part of the sound declaration and compares all mistakes.
fn check(replace: &str, by: &str, expected: &[&str]) {
    assert!(SOUND.contains(replace), "{replace}");
    assert_eq!(mistakes(&SOUND.replacen(replace, by, 1)), expected, "\nin: {by}");
}

/// The same text without its units, which is not checked for them; a mistake in a line that has none keeps its place.
fn without_units(text: &str) -> String {
    ["rad", "m", "kg", "m/s^2"].iter().fold(text.to_owned(), |text, unit| text.replace(&format!(" [{unit}]"), ""))
}

/// As [`check`], in the declaration without units: for mistakes that have nothing to do with them.
fn check_without_units(replace: &str, by: &str, expected: &[&str]) {
    let sound = without_units(SOUND);
    assert!(sound.contains(replace), "{replace}");
    assert_eq!(mistakes(&sound.replacen(replace, by, 1)), expected, "\nin: {by}");
}

#[test]
fn the_sound_declaration_has_none() {
    assert_eq!(mistakes(SOUND), Vec::<String>::new());
}
