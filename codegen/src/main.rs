//! `codegen FILE`: prints the kernels of the mechanisms declared in a Rust file, formatted.

use anyhow::{Context, Result, bail};
use quote::quote;
use std::io::Write;
use std::process::ExitCode;

fn main() -> ExitCode {
    match run() {
        Ok(()) => ExitCode::SUCCESS,
        Err(error) => {
            eprintln!("codegen: {error:#}");
            ExitCode::from(2)
        }
    }
}

fn run() -> Result<()> {
    let arguments: Vec<String> = std::env::args().skip(1).collect();
    let [file] = arguments.as_slice() else {
        bail!("usage: codegen FILE.rs\nprints the generated code of each `mechanism! {{ .. }}` in the file");
    };
    let text = std::fs::read_to_string(file).with_context(|| format!("cannot read {file}"))?;
    let parsed = syn::parse_file(&text).map_err(|e| located(file, e))?;
    let mut found = false;
    for item in parsed.items {
        if let syn::Item::Macro(item) = item
            && item.mac.path.segments.last().is_some_and(|name| name.ident == "mechanism")
        {
            found = true;
            let tokens = codegen::generate(item.mac.tokens, &quote!(sim_kernel)).map_err(|e| located(file, e))?;
            let text = codegen::emit::format(tokens).map_err(|e| located(file, e))?;
            std::io::stdout().write_all(text.as_bytes())?;
        }
    }
    if !found {
        bail!("{file} declares no mechanism: no `mechanism! {{ .. }}` at its top level");
    }
    Ok(())
}

/// Every mistake as `file:line:column: message`.
fn located(file: &str, mistakes: syn::Error) -> anyhow::Error {
    let lines = mistakes.into_iter().map(|mistake| {
        let start = mistake.span().start();
        format!("{file}:{}:{}: {mistake}", start.line, start.column + 1)
    });
    anyhow::anyhow!(lines.collect::<Vec<_>>().join("\n"))
}
