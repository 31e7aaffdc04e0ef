//! `sim new`.

use crate::arguments::{NewArguments, Voice};
use crate::{Stop, print};
use sim_output::WriteError;
use sim_runtime::Provenance;
use std::fs;
use std::path::{Path, PathBuf};

/// The library of a new crate: its declaration.
pub(super) const CRATE: &str = include_str!("../../assets/new/lib.rs.txt");

/// The files of a new crate; `{{..}}` in them is filled.
const FILES: [(&str, &str); 6] = [
    ("Cargo.toml", include_str!("../../assets/new/Cargo.toml.txt")),
    ("src/lib.rs", CRATE),
    ("src/main.rs", include_str!("../../assets/new/main.rs.txt")),
    ("tests/checks.rs", include_str!("../../assets/new/checks.rs.txt")),
    ("README.md", include_str!("../../assets/new/README.md.txt")),
    (".gitignore", include_str!("../../assets/new/gitignore.txt")),
];

/// The folder that this program was built from, if it still exists.
const HERE: &str = concat!(env!("CARGO_MANIFEST_DIR"), "/../..");

/// Names that Cargo refuses, or those of the crate's own dependencies.
const TAKEN: [&str; 12] = [
    "sim",
    "sim-kernel",
    "sim-runtime",
    "mechanism-macros",
    "codegen",
    "test",
    "core",
    "std",
    "alloc",
    "proc-macro",
    "build",
    "deps",
];

/// Creates a crate with a mechanism.
pub(crate) fn new(arguments: &NewArguments, voice: Voice) -> Result<(), Stop> {
    let path = &arguments.path;
    let name = path.file_name().map(|name| name.to_string_lossy().into_owned()).unwrap_or_default();
    check_name(&name)?;
    if path.exists() {
        return Err(Stop::Usage(format!("{} exists already; name a new directory", path.display())));
    }
    let (dependency, workspace) = dependency(arguments.linkwright.as_deref())?;
    let (crate_name, type_name) = (name.replace('-', "_"), type_name(&name));
    let model = model_name(&type_name);
    for (file, template) in FILES {
        let text = template
            .replace("{{name}}", &name)
            .replace("{{crate}}", &crate_name)
            .replace("{{type}}", &type_name)
            .replace("{{model}}", &model)
            .replace("{{dependency}}", &dependency)
            .replace("{{program}}", &Provenance::program());
        write(&path.join(file), &text)?;
    }
    if let Some(workspace) = workspace {
        let manifest = workspace.join("Cargo.toml");
        let alias =
            ["run", "-q", "--release", "--manifest-path", &manifest.to_string_lossy(), "-p", "codegen-command", "--"];
        // As one string if no word contains a blank: cargo joins lists with those of parent folders, but a string
        // replaces them.
        let alias = match alias.iter().any(|word| word.contains(char::is_whitespace)) {
            true => format!("{alias:?}"),
            false => format!("{:?}", alias.join(" ")),
        };
        let text = format!(
            "[alias]\n# Prints what is made of a declaration: `cargo kernels src/lib.rs`.\nkernels = {alias}\n"
        );
        write(&path.join(".cargo/config.toml"), &text)?;
        // The versions that the workspace was built with are on this machine already.
        let lock = workspace.join("Cargo.lock");
        if lock.is_file() {
            let to = path.join("Cargo.lock");
            fs::copy(lock, &to).map_err(|why| WriteError::new(&to, why))?;
        }
    }
    if voice.quiet {
        return Ok(());
    }
    if voice.json {
        return print(&format!("{:#}\n", serde_json::json!({ "directory": path, "model": model, "type": type_name })));
    }
    print(&format!(
        "made         {path}: the declaration is in src/lib.rs\nnext         cd {path}\n             cargo run --release -- run {model}\n             \
         then open out/{model}/report.html\n",
        path = path.display()
    ))
}

fn check_name(name: &str) -> Result<(), Stop> {
    let fail = |why: &str| Err(Stop::Usage(format!("`{name}` cannot be a crate's name: {why}, as in `my-linkage`")));
    let is_word = |c: char| c.is_ascii_alphanumeric() || c == '-' || c == '_';
    if !name.starts_with(|c: char| c.is_ascii_alphabetic()) {
        return fail("it has to start with a letter");
    }
    if !name.chars().all(is_word) {
        return fail("letters, digits, `-` and `_` are possible");
    }
    if TAKEN.contains(&name.replace('_', "-").as_str()) || syn_keyword(name) {
        return fail("that word is reserved");
    }
    Ok(())
}

fn syn_keyword(name: &str) -> bool {
    let words = [
        "as", "async", "await", "break", "const", "continue", "crate", "dyn", "else", "enum", "extern", "false", "fn",
        "for", "gen", "if", "impl", "in", "let", "loop", "match", "mod", "move", "mut", "pub", "ref", "return", "self",
        "static", "struct", "super", "trait", "true", "type", "unsafe", "use", "where", "while",
    ];
    words.contains(&name.to_lowercase().as_str())
}

/// `my-linkage` as `MyLinkage`.
pub(super) fn type_name(name: &str) -> String {
    let words = name.split(['-', '_']).filter(|word| !word.is_empty());
    let capital =
        |word: &str| word.chars().take(1).flat_map(char::to_uppercase).chain(word.chars().skip(1)).collect::<String>();
    let joined: String = words.map(capital).collect();
    // `S` is the scalar of generated types, and `Self` is a word of Rust.
    if ["S", "Self"].contains(&joined.as_str()) { format!("{joined}Mechanism") } else { joined }
}

/// The name of a type on the command line.
fn model_name(type_name: &str) -> String {
    codegen::description::kebab_case(type_name)
}

/// The line of `Cargo.toml`, and the workspace if it is a folder.
fn dependency(linkwright: Option<&str>) -> Result<(String, Option<PathBuf>), Stop> {
    let features = "default-features = false, features = [\"cli\"]";
    if let Some(url) = linkwright.filter(|place| place.contains("://") || place.starts_with("git@")) {
        return Ok((format!("sim = {{ git = {url:?}, {features} }}"), None));
    }
    let place = Path::new(linkwright.unwrap_or(HERE));
    let workspace = place.canonicalize().ok().filter(|place| place.join("sim/kernel/Cargo.toml").is_file());
    match workspace {
        Some(workspace) => {
            let sim = workspace.join("sim");
            Ok((format!("sim = {{ path = {:?}, {features} }}", sim.to_string_lossy()), Some(workspace)))
        }
        None => Err(Stop::Usage(format!(
            "no Linkwright at {}: give its folder or git repository with `--linkwright PATH|URL`",
            place.display()
        ))),
    }
}

fn write(path: &Path, text: &str) -> Result<(), WriteError> {
    let fail = |why: std::io::Error| WriteError::new(path, why);
    if let Some(directory) = path.parent() {
        fs::create_dir_all(directory).map_err(fail)?;
    }
    fs::write(path, text).map_err(fail)
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn types_are_named_after_crates() {
        assert_eq!(type_name("my-linkage"), "MyLinkage");
        assert_eq!(type_name("four_bar2"), "FourBar2");
        assert_eq!(type_name("s"), "SMechanism");
        assert_eq!(type_name("self-"), "SelfMechanism");
    }

    #[test]
    fn names_that_cargo_refuses_are_refused() {
        for bad in ["", "2bars", "my linkage", "sim", "sim_kernel", "proc_macro", "match", "\u{e4}"] {
            assert!(check_name(bad).is_err(), "{bad}");
        }
        assert!(check_name("my-linkage").is_ok());
    }
}
