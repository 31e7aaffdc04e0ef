//! Writes the kernels of mechanisms of several sizes for the benchmark `scale`, from their declarations' text.

#![allow(missing_docs, unreachable_pub)]

#[cfg(feature = "scale")]
#[path = "src/declarations.rs"]
mod declarations;

#[cfg(not(feature = "scale"))]
fn main() {
    println!("cargo::rerun-if-changed=build.rs");
}

#[cfg(feature = "scale")]
fn main() -> Result<(), Box<dyn std::error::Error>> {
    use declarations::{Angles, CHAIN_SIZES, FOUR_BAR_SIZES, chain, chain_name, four_bars, four_bars_name};
    println!("cargo::rerun-if-changed=src/declarations.rs");
    let (mut mechanisms, mut chains, mut linkages) = (Vec::new(), Vec::new(), Vec::new());
    for rods in CHAIN_SIZES {
        for angles in [Angles::Absolute, Angles::Relative] {
            mechanisms.push(chain(*rods, angles));
            chains.push(format!("{}, {rods}, {angles:?}", chain_name(*rods, angles)));
        }
    }
    for loops in FOUR_BAR_SIZES {
        mechanisms.push(four_bars(*loops));
        linkages.push(format!("{}, {loops}, {}, {}", four_bars_name(*loops), loops + 1, 2 * loops + 1));
    }
    let mut text = String::new();
    for declaration in mechanisms {
        let tokens: proc_macro2::TokenStream = declaration.parse()?;
        text += &codegen::generate(tokens, &quote::quote!(sim_kernel))?.to_string();
        text.push('\n');
    }
    for (name, rows) in [("chains", chains), ("linkages", linkages)] {
        let calls: Vec<String> = rows.iter().map(|row| format!("$measure!({row})")).collect();
        text += &format!("macro_rules! {name} {{ ($measure:ident) => {{ vec![{}] }} }}\n", calls.join(", "));
    }
    let out = std::path::PathBuf::from(std::env::var("OUT_DIR")?);
    std::fs::write(out.join("scale.rs"), text)?;
    std::fs::write(out.join("derivatives.rs"), quick_return_with_derivatives()?)?;
    Ok(())
}

/// The shipped quick-return mechanism with all kernels that not everyone needs.
#[cfg(feature = "scale")]
fn quick_return_with_derivatives() -> Result<String, Box<dyn std::error::Error>> {
    let path = concat!(env!("CARGO_MANIFEST_DIR"), "/../models/src/quick_return.rs");
    println!("cargo::rerun-if-changed={path}");
    let text = std::fs::read_to_string(path)?;
    let inside = text.split_once("mechanism! {").and_then(|(_, rest)| rest.rsplit_once('}'));
    let (declaration, _) = inside.ok_or("no declaration in quick_return.rs")?;
    let wanted = format!("{declaration} kernels {{ dynamics_jacobian; dynamics_sensitivity; }}");
    Ok(codegen::generate(wanted.parse()?, &quote::quote!(sim_kernel))?.to_string())
}
