//! What is generated from each shipped mechanism, a chain, and a wheel in generalised speeds stands here, so that a change is
//! seen: six of them whole, to be read, and of all others a line for each kernel in `kernels.txt`. Whether it is right is shown
//! elsewhere. `cargo golden` accepts all changes.

#![allow(missing_docs, clippy::unwrap_used, clippy::panic)]

use std::collections::BTreeSet;
use std::fs;
use std::path::{Path, PathBuf};
use std::process::{Command, Output};

/// Those whose kernels stand here whole: one coordinate, loops in the plane with a slot and with a slider, a body in space,
/// constraints between speeds, events.
const WHOLE: [&str; 6] = ["pendulum", "quick_return", "slider_crank", "top", "skate", "bouncing_ball"];

/// Where a line for each kernel of all others stands.
const LINES: &str = "tests/golden/kernels.txt";

/// A text that declares mechanisms, the view of it, and the file where that view stands.
struct Golden {
    declaration: PathBuf,
    view: &'static [&'static str],
    file: PathBuf,
}

fn root() -> &'static Path {
    Path::new(env!("CARGO_MANIFEST_DIR")).ancestors().nth(2).unwrap()
}

/// Files are named from the root of the workspace.
fn codegen(arguments: &[&str], declaration: &Path) -> Output {
    Command::new(env!("CARGO_BIN_EXE_codegen")).args(arguments).arg(declaration).current_dir(root()).output().unwrap()
}

/// A print without the lines on top that say what made it: they name the commit.
fn without_header(print: Vec<u8>) -> String {
    let print = String::from_utf8(print).unwrap();
    print.split_once("\n\n").filter(|(header, _)| header.contains("Made by Linkwright")).unwrap().1.to_owned()
}

/// The files with declarations: every model, the chain and the wheel.
fn declarations() -> Vec<PathBuf> {
    let files = |folder: &str| {
        let entries = fs::read_dir(root().join(folder)).unwrap();
        entries.map(|entry| Path::new(folder).join(entry.unwrap().file_name())).collect::<BTreeSet<PathBuf>>()
    };
    let is_model = |file: &PathBuf| file.file_name().unwrap() != "lib.rs";
    files("models/src").into_iter().filter(is_model).chain(files("tests/golden/declarations")).collect()
}

fn is_whole(declaration: &Path) -> bool {
    WHOLE.iter().any(|name| declaration.file_stem().unwrap() == *name)
}

/// The kernels of six models; the equations of one in every notation.
fn all() -> Vec<Golden> {
    let golden = |declaration: &Path, view, extension: &str| {
        let folder = if extension == "rs" { "tests/golden/kernels" } else { "tests/golden/equations" };
        let name = Path::new(declaration.file_stem().unwrap()).with_extension(extension);
        Golden { declaration: declaration.to_owned(), view, file: Path::new(folder).join(name) }
    };
    let whole = declarations().into_iter().filter(|declaration| is_whole(declaration));
    let kernels = whole.map(|declaration| golden(&declaration, &[], "rs"));
    let model = Path::new("models/src/quick_return.rs");
    let views: [(&[&str], &str); 3] =
        [(&["--equations=infix"], "txt"), (&["--equations=latex"], "tex"), (&["--equations=mathml"], "html")];
    kernels.chain(views.map(|(view, extension)| golden(model, view, extension))).collect()
}

/// A line for each kernel of the models that do not stand here whole: its operations, statements and a hash of its code; and one
/// for all that is generated from them.
fn lines() -> Vec<String> {
    let mut lines = vec![format!("{:<22} {:<28} {:>10} {:>10}  hash", "model", "kernel", "operations", "statements")];
    for declaration in declarations().into_iter().filter(|declaration| !is_whole(declaration)) {
        let model = declaration.file_stem().unwrap().to_str().unwrap();
        let said = |arguments: &[&str]| codegen(arguments, &declaration).stdout;
        let (code, statistics) = (without_header(said(&[])), String::from_utf8(said(&["--statistics"])).unwrap());
        let mut line = |kernel: &str, [operations, statements]: [&str; 2], code: &str| {
            lines.push(format!("{model:<22} {kernel:<28} {operations:>10} {statements:>10}  {:016x}", fnv(code)));
        };
        let rows = statistics.lines().skip_while(|line| !line.starts_with("kernel ")).skip(1);
        for row in rows.take_while(|line| !line.is_empty()) {
            let words: Vec<&str> = row.split_whitespace().collect();
            let [kernel, .., operations, _, statements] = words[..] else { panic!("{row}") };
            line(kernel, [operations, statements], &functions(&code, kernel));
        }
        line("all", ["-", "-"], &code);
    }
    lines
}

/// The functions that a kernel is, as text.
fn functions(code: &str, kernel: &str) -> String {
    let is_kernel = |line: &str| {
        let after = line.trim_start().trim_start_matches("pub ").strip_prefix("fn ");
        let name = after.map(|rest| rest.split(['(', '<']).next().unwrap());
        name.is_some_and(|name| name.strip_prefix("prepared_").unwrap_or(name) == kernel)
    };
    let mut found = String::new();
    let mut rest = code.lines();
    while let Some(first) = rest.by_ref().find(|line| is_kernel(line)) {
        let indent = first.len() - first.trim_start().len();
        found += first;
        for line in rest.by_ref() {
            found += line;
            found.push('\n');
            if line.trim() == "}" && line.len() - line.trim_start().len() == indent {
                break;
            }
        }
    }
    found
}

/// Fowler, Noll and Vo's hash, FNV-1a.
fn fnv(text: &str) -> u64 {
    text.bytes().fold(0xcbf2_9ce4_8422_2325, |hash, byte| (hash ^ u64::from(byte)).wrapping_mul(0x0000_0100_0000_01b3))
}

#[test]
fn kernels_of_all_others_are_what_they_were() {
    let (expected, found) = (fs::read_to_string(root().join(LINES)).unwrap(), lines());
    let expected: Vec<&str> = expected.lines().collect();
    let gone = expected.iter().filter(|line| !found.iter().any(|other| other == *line)).map(|line| format!("- {line}"));
    let new = found.iter().filter(|line| !expected.contains(&line.as_str())).map(|line| format!("+ {line}"));
    let differences: Vec<String> = gone.chain(new).collect();
    assert!(differences.is_empty(), "{}\n`cargo golden` accepts the changes", differences.join("\n"));
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
        fs::write(root().join(golden.file), without_header(output.stdout)).unwrap();
    }
    fs::write(root().join(LINES), lines().join("\n") + "\n").unwrap();
}
