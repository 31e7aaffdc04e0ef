//! What is generated from each shipped mechanism, a chain, and a wheel in generalised speeds stands here as files, so that a
//! change is seen. Whether it is right is shown elsewhere. `cargo golden` accepts all changes.

#![allow(missing_docs, clippy::unwrap_used)]

use std::collections::BTreeSet;
use std::fs;
use std::path::{Path, PathBuf};
use std::process::{Command, Output};

/// A text that declares mechanisms, the view of it, and the file where that view stands.
struct Golden {
    declaration: PathBuf,
    view: &'static [&'static str],
    file: PathBuf,
}

fn root() -> &'static Path {
    Path::new(env!("CARGO_MANIFEST_DIR")).parent().unwrap()
}

/// Files are named from the root of the workspace.
fn codegen(arguments: &[&str], declaration: &Path) -> Output {
    Command::new(env!("CARGO_BIN_EXE_codegen")).args(arguments).arg(declaration).current_dir(root()).output().unwrap()
}

/// The kernels of every model, of the chain and of the wheel; the equations of one model in every notation.
fn all() -> Vec<Golden> {
    let files = |folder: &str| {
        let entries = fs::read_dir(root().join(folder)).unwrap();
        entries.map(|entry| Path::new(folder).join(entry.unwrap().file_name())).collect::<BTreeSet<PathBuf>>()
    };
    let is_model = |file: &PathBuf| file.file_name().unwrap() != "lib.rs";
    let declarations = files("models/src").into_iter().filter(is_model).chain(files("tests/golden/declarations"));
    let golden = |declaration: &Path, view, extension: &str| {
        let folder = if extension == "rs" { "tests/golden/kernels" } else { "tests/golden/equations" };
        let name = Path::new(declaration.file_stem().unwrap()).with_extension(extension);
        Golden { declaration: declaration.to_owned(), view, file: Path::new(folder).join(name) }
    };
    let kernels = declarations.map(|declaration| golden(&declaration, &[], "rs"));
    let model = Path::new("models/src/quick_return.rs");
    let views: [(&[&str], &str); 3] =
        [(&["--equations=infix"], "txt"), (&["--equations=latex"], "tex"), (&["--equations=mathml"], "html")];
    kernels.chain(views.map(|(view, extension)| golden(model, view, extension))).collect()
}

#[test]
fn generated_code_and_equations_are_what_they_were() {
    let mut differences = String::new();
    for golden in all() {
        let arguments = [golden.view, &["--check", golden.file.to_str().unwrap()]].concat();
        let output = codegen(&arguments, &golden.declaration);
        if !output.status.success() {
            differences += &String::from_utf8_lossy(&output.stdout);
            differences += &String::from_utf8_lossy(&output.stderr);
        }
    }
    assert!(differences.is_empty(), "{differences}\n`cargo golden` accepts the changes");
}

/// What no longer is a model has no file here.
#[test]
fn no_file_is_left_over() {
    let known: BTreeSet<PathBuf> = all().into_iter().map(|golden| root().join(golden.file)).collect();
    for folder in ["kernels", "equations"] {
        for entry in fs::read_dir(root().join("tests/golden").join(folder)).unwrap() {
            let path = entry.unwrap().path();
            assert!(known.contains(&path), "{} belongs to nothing", path.display());
        }
    }
}

#[test]
#[ignore = "accepts all changes: `cargo golden`"]
fn accept() {
    for golden in all() {
        let output = codegen(golden.view, &golden.declaration);
        assert!(output.status.success(), "{}", String::from_utf8_lossy(&output.stderr));
        fs::write(root().join(golden.file), output.stdout).unwrap();
    }
}
