//! The graph of a kernel's operations, in the language of Graphviz.

use crate::source::Source;
use anyhow::{Result, bail};
use codegen::program::{Diagram, Program, plan};
use codegen::{dynamics, model, nearest};
use proc_macro2::TokenStream;
use std::fmt::Write;

/// The graph of one kernel, of each mechanism.
pub(crate) fn graph(source: &Source, kernel: &str) -> Result<String> {
    let mut out = String::new();
    for declaration in source.located(source.declarations())? {
        let (name, program) = source.located(program(declaration))?;
        let Some(found) = program.kernels.iter().find(|candidate| candidate.id.name() == kernel) else {
            bail!(unknown(kernel, &program));
        };
        out += &digraph(&format!("{name}.{kernel}"), &Diagram::of(found))?;
    }
    Ok(out)
}

/// The kernels that are generated, and the name of the mechanism.
fn program(declaration: TokenStream) -> syn::Result<(String, Program)> {
    let mut equations = dynamics::derive_cheapest(model::resolve(&codegen::parse(declaration)?)?);
    let program = plan(&mut equations);
    Ok((equations.model.name, program))
}

fn unknown(kernel: &str, program: &Program) -> String {
    let names = || program.kernels.iter().map(|kernel| kernel.id.name());
    let near = nearest::suggestion(kernel, names());
    format!("no kernel is called `{kernel}`{near}; there are {}", names().collect::<Vec<_>>().join(", "))
}

/// Inputs are boxes, operations circles under the name that they have, results double circles.
fn digraph(title: &str, diagram: &Diagram) -> Result<String> {
    let mut out = format!("digraph \"{title}\" {{\n  rankdir = LR;\n");
    for (at, vertex) in diagram.vertices.iter().enumerate() {
        let shape = if vertex.operands.is_empty() { "box" } else { "ellipse" };
        let label = match &vertex.name {
            Some(name) => format!("{name} = {}", vertex.label),
            None => vertex.label.clone(),
        };
        writeln!(out, "  v{at} [label = \"{label}\", shape = {shape}];")?;
        for (subtracted, operand) in &vertex.operands {
            let sign = if *subtracted { " [label = \"-\"]" } else { "" };
            writeln!(out, "  v{operand} -> v{at}{sign};")?;
        }
    }
    for (at, result) in diagram.results.iter().enumerate() {
        writeln!(out, "  r{at} [label = \"result {}\", shape = box, peripheries = 2];\n  v{result} -> r{at};", at + 1)?;
    }
    Ok(out + "}\n")
}
