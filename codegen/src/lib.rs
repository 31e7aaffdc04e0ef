//! Mechanism declarations to specialised Rust kernels.
//!
//! [`generate`] runs the whole path, and its body names the stages. The macro, the command and the tests all call it.
//! The folders follow the data flow, and no stage imports a later one. [`symbolic`] serves them all and knows no
//! mechanics; [`oracle`] shares only the parsed declaration with the code that it checks.

pub mod description;
pub mod dsl;
pub mod dynamics;
pub mod emit;
pub mod joints;
pub mod kernel_id;
pub mod mistakes;
pub mod model;
pub mod nearest;
pub mod notation;
pub mod oracle;
pub mod program;
pub mod symbolic;
mod threads;

use notation::{Notation, Section};
use proc_macro2::{TokenStream, TokenTree};
use quote::{ToTokens, quote};
use std::path::{Path, PathBuf};

/// All mistakes that a stage finds, each at its word.
pub type Mistaken = syn::Error;

/// A declaration's tokens to the Rust items of the mechanism. `path` is where `sim_kernel` is found.
///
/// # Errors
/// All mistakes of the first stage that finds any, each at the user's own word.
pub fn generate(tokens: TokenStream, path: &TokenStream) -> syn::Result<TokenStream> {
    let Derived { head, description, equations, program } = derive(tokens)?;
    Ok(emit::emit(&head, &description, &equations, &program, path))
}

/// All that is derived from a declaration, before it is written in another language.
pub struct Derived {
    /// Its name and visibility.
    pub head: dsl::Head,
    /// What is told of it.
    pub description: description::Description,
    /// Its equations of motion.
    pub equations: dynamics::EquationsOfMotion,
    /// Its kernels.
    pub program: program::Program,
}

/// A declaration's tokens to its programs.
///
/// # Errors
/// As [`generate`].
pub fn derive(tokens: TokenStream) -> syn::Result<Derived> {
    let (declaration, resolved) = resolved(tokens.clone())?;
    let mut equations = dynamics::derive_cheapest(resolved);
    let program = program::plan(&mut equations);
    let description = description::describe(&equations, &program, &dsl::Source::of(tokens));
    Ok(Derived { head: declaration.head, description, equations, program })
}

/// The formatted items of every mechanism that a text declares: a Rust file with `mechanism! { .. }` in it, or a bare
/// declaration. For build scripts; the file that they write is `include!`d.
///
/// ```
/// // In build.rs, where `text` is read from a file and the result written into OUT_DIR:
/// let text = "pub Pendulum; coordinates { phi [rad]; } parameters { l [m] = 1; }
///     bodies { bob: mass 1 [kg] at l*[sin(phi), -cos(phi)]; } loads { gravity [0, -9.81 [m/s^2]]; }";
/// match codegen::generate_text(text, "sim_kernel") {
///     Ok(items) => assert!(items.contains("pub struct Pendulum")),
///     Err(mistakes) => {
///         let lines = codegen::mistakes::located("pendulum.txt", mistakes);
///         lines.lines().for_each(|line| println!("cargo::error={line}"));
///     }
/// }
/// ```
///
/// Files of tables are sought in the crate's folder; the script must print `cargo::rerun-if-changed` for them.
///
/// # Errors
/// As [`generate`], for the first declaration with mistakes; and if there is none.
pub fn generate_text(text: &str, path: &str) -> syn::Result<String> {
    generate_text_in(text, path, &crate_folder())
}

/// The same with files sought in a folder.
///
/// # Errors
/// As [`generate_text`].
pub fn generate_text_in(text: &str, path: &str, folder: &Path) -> syn::Result<String> {
    let path: TokenStream = path.parse()?;
    let mut items = String::new();
    for declaration in dsl::declarations(text)? {
        let (declaration, _) = dsl::read_files(declaration, folder)?;
        items += &emit::format(generate(declaration, &path)?)?;
    }
    Ok(items)
}

/// The folder of the crate that is being built, by its build script or by a macro.
fn crate_folder() -> PathBuf {
    std::env::var_os("CARGO_MANIFEST_DIR").map(PathBuf::from).unwrap_or_default()
}

/// The symbolic equations of motion of a declaration.
///
/// # Errors
/// As [`generate`].
pub fn equations(tokens: TokenStream) -> syn::Result<dynamics::EquationsOfMotion> {
    Ok(dynamics::derive(resolved(tokens)?.1))
}

/// The first two stages: a parsed declaration with its joints written out.
///
/// # Errors
/// All mistakes of the first stage that finds any, each at the user's own word.
pub fn parse(tokens: TokenStream) -> syn::Result<dsl::Declaration> {
    joints::write_out(dsl::read(tokens)?)
}

/// The first three stages.
fn resolved(tokens: TokenStream) -> syn::Result<(dsl::Declaration, model::Resolved)> {
    dsl::attributed(tokens, |tokens| {
        let declaration = parse(tokens)?;
        let resolved = model::resolve(&declaration)?;
        Ok((declaration, resolved))
    })
}

/// The equations of motion of a declaration's text, to be read.
///
/// # Errors
/// As [`generate`], and if the text is not made of Rust's tokens.
pub fn equations_as(notation: Notation, declaration: &str) -> syn::Result<Vec<Section>> {
    let (_, mut resolved) = resolved(declaration.parse()?)?;
    // What they need is not read.
    resolved.model.kernels = Some(Vec::new());
    Ok(notation::equations(&dynamics::derive(resolved), notation))
}

/// The body of the procedural macro: `path; declaration` to items, or to errors and a stub.
pub fn expand(input: TokenStream) -> TokenStream {
    let mut tokens = input.into_iter();
    let is_semicolon = |token: &TokenTree| matches!(token, TokenTree::Punct(punct) if punct.as_char() == ';');
    let path: TokenStream = tokens.by_ref().take_while(|token| !is_semicolon(token)).collect();
    let declaration: TokenStream = tokens.collect();
    let read = dsl::version::without(declaration.clone());
    let generated =
        read.and_then(|declaration| dsl::read_files(declaration, &crate_folder())).and_then(|(declaration, files)| {
            let items = generate(declaration, &path)?;
            // So that cargo rebuilds when a file has changed.
            Ok(quote! {
                #items
                #(const _: &[::core::primitive::u8] =
                    ::core::include_bytes!(::core::concat!(::core::env!("CARGO_MANIFEST_DIR"), "/", #files));)*
            })
        });
    generated.unwrap_or_else(|mistakes| {
        let mistakes = mistakes.to_compile_error();
        let declaration = dsl::version::without(declaration.clone()).unwrap_or(declaration);
        let stub = dsl::parse_head(declaration).map(|head| emit::stub(&head, &path)).ok();
        let stub = stub.map(ToTokens::into_token_stream);
        quote! { #mistakes #stub }
    })
}
