//! Writes the declarations of random linkages for the command `stress`, and the kernels of mechanisms of several sizes for
//! the benchmark `scale`, from their declarations' text.

#![allow(missing_docs, unreachable_pub)]

#[cfg(feature = "scale")]
#[path = "src/declarations.rs"]
mod declarations;

#[path = "src/stress/declare.rs"]
mod declare;
#[path = "src/stress/declare_spatial.rs"]
mod declare_spatial;
#[allow(dead_code)]
#[path = "src/stress/topology.rs"]
mod topology;

fn main() -> Result<(), Box<dyn std::error::Error>> {
    println!("cargo::rerun-if-changed=build.rs");
    stress()?;
    #[cfg(feature = "scale")]
    scale()?;
    Ok(())
}

/// What derives a declaration when it is first asked for. Panics of the command say nothing.
const INTERPRETED: &str =
    "        static MODEL: std::sync::OnceLock<tests::any_model::AnyModel> = std::sync::OnceLock::new();
        let derived = |text| tests::any_model::interpreted(text).unwrap_or_else(|mistakes| {
            eprintln!(\"{mistakes}\");
            std::process::exit(2)
        });
        MODEL.get_or_init(|| derived";

/// The linkages of the command `stress`, each in its forms, and the list of them: compiled in a release build, otherwise as
/// text that is interpreted, which gives the same bits and takes the compiler no time.
fn stress() -> Result<(), Box<dyn std::error::Error>> {
    println!("cargo::rerun-if-changed=src/stress/declare.rs");
    println!("cargo::rerun-if-changed=src/stress/declare_spatial.rs");
    println!("cargo::rerun-if-changed=src/stress/topology.rs");
    let is_compiled = std::env::var("PROFILE")? == "release";
    let (mut text, mut list) = (String::new(), String::new());
    let planar = topology::PLANAR.iter().map(|linkage| (linkage.name, declare::declarations(linkage)));
    let spatial = topology::SPATIAL.iter().map(|linkage| (linkage.name, declare_spatial::declarations(linkage)));
    for (name, forms) in planar.chain(spatial) {
        list += &format!("Linkage {{ name: {name:?}, forms: &[\n");
        for declare::Declared { type_name, text: declaration } in forms {
            if is_compiled {
                text += &format!("sim::mechanism! {{\n{declaration}}}\n\n");
                list += &format!("    &Typed(<{type_name} as sim::Compiled>::defaults),\n");
            } else {
                list += &format!("    &Typed(|| {{\n{INTERPRETED}({declaration:?})).clone()\n}}),\n");
            }
        }
        list += "] },\n";
    }
    text += &format!("pub(crate) const LINKAGES: &[Linkage] = &[\n{list}];\n");
    let out = std::path::PathBuf::from(std::env::var("OUT_DIR")?);
    Ok(std::fs::write(out.join("stress.rs"), text)?)
}

#[cfg(feature = "scale")]
fn scale() -> Result<(), Box<dyn std::error::Error>> {
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
        // In lines: in one line of megabytes rustc looks for columns for minutes.
        text += &codegen::generate_text(&declaration, "sim_kernel")?;
        text.push('\n');
    }
    for (name, rows) in [("chains", chains), ("linkages", linkages)] {
        let calls: Vec<String> = rows.iter().map(|row| format!("$measure!({row})")).collect();
        text += &format!("macro_rules! {name} {{ ($measure:ident) => {{ vec![{}] }} }}\n", calls.join(", "));
    }
    let out = std::path::PathBuf::from(std::env::var("OUT_DIR")?);
    std::fs::write(out.join("scale.rs"), text)?;
    std::fs::write(out.join("derivatives.rs"), quick_return_with_derivatives()?)?;
    std::fs::write(out.join("coupling.rs"), free_chains()?)?;
    Ok(())
}

/// Chains of free bodies beside the same ones in angles.
#[cfg(feature = "scale")]
fn free_chains() -> Result<String, Box<dyn std::error::Error>> {
    use declarations::{Angles, FREE_CHAIN_SIZES, chain, free_chain};
    let mut text = String::new();
    for rods in FREE_CHAIN_SIZES {
        for declaration in [chain(*rods, Angles::Absolute), free_chain(*rods)] {
            text += &codegen::generate_text(&declaration, "sim::sim_kernel")?;
            text.push('\n');
        }
    }
    Ok(text)
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
    Ok(codegen::generate_text(&wanted, "sim_kernel")?)
}
