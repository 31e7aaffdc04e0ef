//! The cost of a mechanism's kernels and of their derivation.

use codegen::description::describe;
use codegen::program::{Diagram, Kernel};
use codegen::{dsl, dynamics, emit, model, program};
use proc_macro2::TokenStream;
use quote::quote;
use std::time::{Duration, Instant};

/// Operations by kind for each kernel, what sharing saves, and the stages of the path with their times.
pub(crate) fn statistics(declaration: TokenStream) -> syn::Result<String> {
    let mut stages = Stages::default();
    let source = dsl::Source::of(declaration.clone());
    // The body of `codegen::generate`, stage by stage.
    let declaration = stages.time("parse", || codegen::parse(declaration))?;
    let resolved = stages.time("resolve", || model::resolve(&declaration))?;
    let mut equations = stages.time("derive", || dynamics::derive_cheapest(resolved));
    let program = stages.time("plan", || program::plan(&mut equations));
    let tokens = stages.time("emit", || {
        let description = describe(&equations, &program, &source);
        emit::emit(&declaration.head, &description, &equations, &program, &quote!(sim_kernel))
    });
    let formatted = stages.time("format", || emit::format(tokens))?;
    let model = &equations.model;
    let mut out = format!(
        "{}: {} coordinates, {} constraints, {} parameters; {} expressions in the graph, {} lines of code\n\n{}",
        model.name,
        model.coordinates.len(),
        model.constraints.len(),
        model.parameters.len(),
        equations.graph.len(),
        formatted.lines().count(),
        HEADER,
    );
    program.kernels.iter().for_each(|kernel| out += &row(kernel));
    Ok(out + "\n" + &stages.text())
}

const HEADER: &str =
    "kernel                           add    mul  div sincos table sqrt other  total  unshared  statements\n";

/// Without sharing, every use of a value would compute it again.
fn row(kernel: &Kernel) -> String {
    let o = &kernel.operations;
    format!(
        "{:<29} {:>6} {:>6} {:>4} {:>6} {:>5} {:>4} {:>5} {:>6} {:>9} {:>11}\n",
        kernel.id.name(),
        o.additions,
        o.multiplications,
        o.divisions,
        o.sine_cosines,
        o.table_look_ups,
        o.square_roots,
        o.other_functions,
        o.total(),
        rounded(Diagram::of(kernel).operations_without_sharing()),
        kernel.pieces.iter().map(|piece| piece.statements.len()).sum::<usize>() + kernel.statements.len(),
    )
}

fn rounded(count: f64) -> String {
    if count < 1e7 { count.to_string() } else { format!("{count:.1e}") }
}

/// Stages with their times, in order.
#[derive(Default)]
struct Stages(Vec<(&'static str, Duration)>);

impl Stages {
    fn time<T>(&mut self, name: &'static str, stage: impl FnOnce() -> T) -> T {
        let clock = Instant::now();
        let result = stage();
        self.0.push((name, clock.elapsed()));
        result
    }

    fn text(&self) -> String {
        let total: Duration = self.0.iter().map(|(_, time)| *time).sum();
        let line = |name: &str, time: Duration| format!("{name:<8} {:>9.3} ms\n", time.as_secs_f64() * 1e3);
        self.0.iter().map(|(name, time)| line(name, *time)).collect::<String>() + &line("all", total)
    }
}
