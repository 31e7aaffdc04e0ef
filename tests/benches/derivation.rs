//! How long it takes from a declaration to its kernels, by stage. `cargo bench -p tests --bench derivation`

#![allow(missing_docs, clippy::unwrap_used)]

use codegen::description::describe;
use codegen::dsl::Source;
use codegen::{dynamics, emit, model, program};
use proc_macro2::TokenStream;
use quote::quote;
use sim::Description;
use std::time::{Duration, Instant};

const RUNS: usize = 200;

fn main() {
    println!("derivation and emission, minimum of {RUNS}, in ms (optimised)");
    println!(
        "{:<20} {:>8} {:>8} {:>8} {:>8} {:>8} {:>8}",
        "model", "parse", "resolve", "derive", "plan", "emit", "all"
    );
    tests::shipped().into_iter().for_each(stages);
}

fn stages(description: &Description) {
    let tokens: TokenStream = description.declaration.parse().unwrap();
    let source = Source::of(tokens.clone());
    let mut best = [Duration::MAX; 6];
    for _ in 0..RUNS {
        let clock = Instant::now();
        let declaration = codegen::parse(tokens.clone()).unwrap();
        let parsed = clock.elapsed();
        let model = model::resolve(&declaration).unwrap();
        let resolved = clock.elapsed();
        let mut equations = dynamics::derive_cheapest(model);
        let derived = clock.elapsed();
        let program = program::plan(&mut equations);
        let planned = clock.elapsed();
        let rust = emit::emit(
            &declaration.head,
            &describe(&equations, &program, &source),
            &equations,
            &program,
            &quote!(sim_kernel),
        );
        let emitted = clock.elapsed();
        assert!(!rust.is_empty());
        let times = [parsed, resolved - parsed, derived - resolved, planned - derived, emitted - planned, emitted];
        best = std::array::from_fn(|i| best[i].min(times[i]));
    }
    let cells = best.map(|time| format!("{:>8.3}", 1e3 * time.as_secs_f64()));
    println!("{:<20} {}", description.name, cells.join(" "));
}
