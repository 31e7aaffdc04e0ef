//! The command `codegen` as a user meets it: views, files and standard input, mistakes, exit statuses.

#![allow(missing_docs, clippy::unwrap_used, clippy::panic)]

use std::fs;
use std::io::Write;
use std::path::{Path, PathBuf};
use std::process::{Command, Stdio};

const PENDULUM: &str = "/// 100 % a pendulum & nothing else.
pub Pendulum;
coordinates { phi [rad]; }
parameters { l [m] = 1; }
bodies { bob: mass 1 [kg] at l*[sin(phi), -cos(phi)]; }
loads { gravity [0, -9.81 [m/s^2]]; }
";

/// The lines on top that say what made a print, and the print.
fn parts(print: &str) -> (&str, &str) {
    print.split_once("\n\n").unwrap()
}

struct Outcome {
    status: i32,
    stdout: String,
    stderr: String,
}

fn codegen(arguments: &[&str], input: &str) -> Outcome {
    let mut child = Command::new(env!("CARGO_BIN_EXE_codegen"))
        .args(arguments)
        .stdin(Stdio::piped())
        .stdout(Stdio::piped())
        .stderr(Stdio::piped())
        .spawn()
        .unwrap();
    // One that is wrong about its arguments reads nothing.
    let _ = child.stdin.take().unwrap().write_all(input.as_bytes());
    let output = child.wait_with_output().unwrap();
    let text = |bytes| String::from_utf8(bytes).unwrap();
    Outcome { status: output.status.code().unwrap(), stdout: text(output.stdout), stderr: text(output.stderr) }
}

fn file(name: &str, text: &str) -> PathBuf {
    let path = Path::new(env!("CARGO_TARGET_TMPDIR")).join(name);
    fs::write(&path, text).unwrap();
    path
}

#[test]
fn kernels_of_a_file_and_of_standard_input_are_the_same() {
    let path = file("pendulum.txt", PENDULUM);
    let of_file = codegen(&[path.to_str().unwrap()], "");
    assert_eq!(of_file.status, 0, "{}", of_file.stderr);
    assert!(of_file.stdout.contains("pub struct Pendulum"));
    for arguments in [vec![], vec!["-"]] {
        assert_eq!(codegen(&arguments, PENDULUM).stdout, of_file.stdout);
    }
    let elsewhere = codegen(&["--path", "other::place"], PENDULUM);
    assert!(elsewhere.stdout.contains("other::place::Scalar") && !elsewhere.stdout.contains("sim_kernel"));
}

#[test]
fn a_file_may_declare_several_mechanisms() {
    let second = PENDULUM.replace("Pendulum", "Second");
    let text = format!(
        "use sim::mechanism;\nsim::mechanism! {{\n{PENDULUM}}}\nmod inner {{ use sim::mechanism;\nmechanism! {{ {second} }} }}\nfn main() {{}}\n"
    );
    let kernels = codegen(&[], &text);
    assert!(kernels.stdout.contains("pub struct Pendulum") && kernels.stdout.contains("pub struct Second"));
    let equations = codegen(&["--equations", "infix"], &text).stdout;
    let (header, equations) = parts(&equations);
    assert!(header.contains("Declaration of Pendulum: ") && header.contains("Declaration of Second: "), "{header}");
    assert!(equations.starts_with("Pendulum\n========\n") && equations.contains("\nSecond\n======\n"), "{equations}");
}

#[test]
fn documents_stand_by_themselves() {
    let latex = codegen(&["--equations", "latex"], PENDULUM).stdout;
    let latex = parts(&latex).1;
    assert!(latex.starts_with("\\documentclass") && latex.ends_with("\\end{document}\n"));
    assert!(latex.contains("100 \\% a pendulum \\& nothing else."));
    assert!(latex.contains("\\left(\\begin{array}{c} l^{2} \\end{array}\\right)"), "{latex}");
    let page = codegen(&["--equations", "mathml"], PENDULUM).stdout;
    let page = parts(&page).1;
    assert!(page.starts_with("<!DOCTYPE html>") && page.contains("a pendulum &amp; nothing else."));
    assert!(page.contains("<msup><mi>l</mi><mn>2</mn></msup>"), "{page}");
}

/// Program, commit, declaration and options, as a comment of the language that is printed.
#[test]
fn prints_say_what_made_them() {
    let hash = codegen::dsl::hash(PENDULUM.parse().unwrap());
    let rows: [(&[&str], &str, &str); 5] = [
        (&["--path", "other::place"], "// ", "path other::place"),
        (&["--graph", "mass_matrix"], "// ", "graph mass_matrix"),
        (&["--equations", "latex"], "% ", "equations latex"),
        (&["--equations", "mathml"], "<!-- ", "equations mathml"),
        (&["--equations", "infix"], "", "equations infix"),
    ];
    for (arguments, comment, options) in rows {
        let text = codegen(arguments, PENDULUM).stdout;
        let lines: Vec<&str> = parts(&text).0.lines().collect();
        let [made, declaration, last] = lines[..] else { panic!("{text}") };
        assert!(lines.iter().all(|line| line.starts_with(comment)), "{text}");
        let version = format!("Made by Linkwright {}, commit ", env!("CARGO_PKG_VERSION"));
        let commit = made.split_once(&version).unwrap().1.split('.').next().unwrap();
        let is_known = commit.trim_end_matches("-dirty").chars().all(|digit| digit.is_ascii_hexdigit());
        assert!(is_known && commit.len() >= 12 || commit == "unknown", "{commit}");
        assert!(declaration.contains(&format!("Declaration of Pendulum: {hash}.")), "{text}");
        assert!(last.contains(&format!("Options: {options}.")), "{text}");
    }
    assert!(!codegen(&["--statistics"], PENDULUM).stdout.contains("Made by"));
}

/// Whoever has the text written as it is elsewhere has the same hash; a number changes it.
#[test]
fn kernels_carry_the_hash_of_their_declaration() {
    let hash_in = |code: &str| {
        let line = code.lines().find(|line| line.trim_start().starts_with("declaration_hash: ")).unwrap();
        line.split('"').nth(1).unwrap().to_owned()
    };
    let hash = hash_in(&codegen(&[], PENDULUM).stdout);
    assert_eq!(hash.len(), 32);
    let laid_out = PENDULUM.replace("; ", ";\n\n    // Here.\n").replace(" = 1", "=1");
    assert_eq!(hash_in(&codegen(&[], &format!("mod m {{ mechanism! {{ {laid_out} }} }}")).stdout), hash);
    assert_eq!(hash_in(&codegen::generate_text(&laid_out, "elsewhere").unwrap()), hash);
    assert_ne!(hash_in(&codegen(&[], &PENDULUM.replace("9.81", "9.82")).stdout), hash);
}

#[test]
fn statistics_count_what_sharing_saves() {
    let text = codegen(&["--statistics"], PENDULUM).stdout;
    let row = text.lines().find(|line| line.starts_with("mass_matrix")).unwrap();
    let counts: Vec<&str> = row.split_whitespace().skip(1).collect();
    // l*l, once: no other operation, and no name.
    assert_eq!(counts, ["0", "1", "0", "0", "0", "0", "0", "1", "1", "0"], "{text}");
    for stage in ["parse", "resolve", "derive", "plan", "emit", "format", "all"] {
        assert!(text.lines().any(|line| line.starts_with(stage) && line.ends_with(" ms")), "{text}");
    }
}

#[test]
fn a_graph_is_of_one_kernel() {
    let graph = codegen(&["--graph", "mass_matrix"], PENDULUM).stdout;
    let graph = parts(&graph).1;
    assert!(graph.starts_with("digraph \"Pendulum.mass_matrix\" {\n"), "{graph}");
    assert_eq!(graph.matches(" -> v").count(), 2, "both factors of l*l: {graph}");
    let unknown = codegen(&["--graph", "mass_matrx"], PENDULUM);
    assert_eq!(unknown.status, 2);
    assert!(unknown.stderr.contains("did you mean `mass_matrix`?"), "{}", unknown.stderr);
}

#[test]
fn a_check_says_where_it_differs() {
    let text = codegen(&[], PENDULUM).stdout;
    let path = file("checked.rs", &text);
    let arguments = ["--check", path.to_str().unwrap()];
    let same = codegen(&arguments, PENDULUM);
    assert_eq!((same.status, same.stdout.as_str()), (0, ""));
    let different = codegen(&arguments, &PENDULUM.replace("-9.81", "-9.8"));
    assert_eq!(different.status, 1);
    let line = 1 + text.lines().position(|line| line.contains("9.81")).unwrap();
    let place = format!("checked.rs:{line}: differs");
    assert!(different.stdout.lines().next().unwrap().contains(&place), "{place}: {}", different.stdout);
    assert!(different.stdout.lines().count() < 60, "{}", different.stdout);
    // What another commit has made is the same where nothing else differs, and so is what has lost its header.
    let (header, code) = parts(&text);
    for other in [text.replace("commit ", "commit 0"), code.to_owned()] {
        assert!(other != text && header.contains("commit "));
        let path = file("other.rs", &other);
        assert_eq!(codegen(&["--check", path.to_str().unwrap()], PENDULUM).status, 0);
    }
    let missing = codegen(&["--check", "/nowhere/at/all.rs"], PENDULUM);
    assert_eq!(missing.status, 2);
    assert!(missing.stderr.contains("cannot read /nowhere/at/all.rs"), "{}", missing.stderr);
}

#[test]
fn mistakes_have_a_file_a_line_and_a_column() {
    let path = file("mistaken.txt", &PENDULUM.replace("l*[", "k*["));
    let mistaken = codegen(&[path.to_str().unwrap()], "");
    assert_eq!((mistaken.status, mistaken.stdout.as_str()), (2, ""));
    let expected = format!("{}:5:30: no value is called `k`", path.display());
    assert!(mistaken.stderr.starts_with(&expected), "{}", mistaken.stderr);
    let rows = [
        ("pub M; coordinates { x [m]; ", "<stdin>:1:"),
        ("fn main() {}", "<stdin>:1:1: no mechanism is declared here"),
        ("", "<stdin>:1:1: no mechanism is declared here"),
        ("mechanism! { pub M; }", "<stdin>:1:18: "),
        ("/// A pendulum.\npub S; coordinates { x [m]; }", "<stdin>:2:5: `S` is the scalar type in generated code"),
        ("S; coordinates { x [m]; }", "<stdin>:1:1: `S` is the scalar type in generated code"),
    ];
    for (text, expected) in rows {
        let outcome = codegen(&[], text);
        assert_eq!(outcome.status, 2, "{text}");
        assert!(outcome.stderr.starts_with(expected), "{text}: {}", outcome.stderr);
    }
    assert_eq!(codegen(&["/nowhere.rs"], "").status, 2);
    assert_eq!(codegen(&["--equations", "roman"], PENDULUM).status, 2);
    assert_eq!(codegen(&["--statistics", "--equations", "infix"], PENDULUM).status, 2);
}
