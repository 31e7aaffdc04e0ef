//! Crates of one's own beside the workspace, built and run as a new user would: the README's, and what `new` makes.

#![allow(missing_docs, clippy::unwrap_used)]

mod build_script;

use std::fs;
use std::path::{Path, PathBuf};
use std::process::{Command, Output};
use std::sync::OnceLock;
use tests::{decimal, reference};

/// The first code block of this language in the README.
fn block(readme: &str, language: &str) -> String {
    let opening = format!("```{language}\n");
    let start = readme.find(&opening).unwrap() + opening.len();
    let end = readme[start..].find("\n```").unwrap();
    readme[start..start + end + 1].to_owned()
}

/// Where the workspace is built, so that what it shares with the crates here is built once.
fn shared_target() -> &'static Path {
    Path::new(env!("CARGO_TARGET_TMPDIR")).parent().unwrap()
}

/// The profile of the workspace for the packages of others, without which nothing could be shared, with [`quickly_built`]. Its
/// own packages are others to a crate beside it, and built anew: as fast as can be.
const PROFILE: [&str; 11] = [
    "profile.dev.package.'*'.opt-level=1",
    "profile.dev.package.'*'.debug=false",
    "profile.dev.build-override.opt-level=1",
    "profile.dev.package.codegen.opt-level=0",
    "profile.dev.package.sim.opt-level=0",
    "profile.dev.package.sim-import.opt-level=0",
    "profile.dev.package.sim-runtime.opt-level=0",
    "profile.dev.package.sim-output.opt-level=0",
    "profile.dev.package.sim-command.opt-level=0",
    "profile.dev.package.sim-kernel.opt-level=0",
    "profile.dev.package.mechanism-macros.opt-level=0",
];
/// What the gate sets for the workspace too, and what its manifest says otherwise.
const DEBUG: [&str; 2] = ["CARGO_PROFILE_DEV_DEBUG", "CARGO_PROFILE_DEV_BUILD_OVERRIDE_DEBUG"];

/// The packages that the workspace builds without optimisation, as its manifest lists them.
fn quickly_built() -> Vec<String> {
    let workspace = Path::new(env!("CARGO_MANIFEST_DIR")).parent().unwrap();
    let manifest = fs::read_to_string(workspace.join("Cargo.toml")).unwrap();
    let list = manifest.split("[profile.dev.package]\n").nth(1).unwrap().lines();
    let named = list.map_while(|line| line.strip_suffix(" = { opt-level = 0, debug = false }"));
    let settings: Vec<String> = named.map(|name| format!("profile.dev.package.{name}.opt-level=0")).collect();
    assert!(!settings.is_empty());
    settings
}

/// Cargo, in a folder, without network.
fn cargo(folder: &Path, words: &[&str]) -> Output {
    let mut command = Command::new(env!("CARGO"));
    command.args(PROFILE.iter().flat_map(|setting| ["--config", setting]));
    command.args(quickly_built().iter().flat_map(|setting| ["--config", setting]));
    for setting in DEBUG {
        command.env(setting, std::env::var(setting).unwrap_or_else(|_| "line-tables-only".to_owned()));
    }
    command.args(words).current_dir(folder).env("CARGO_NET_OFFLINE", "true").env("CARGO_TARGET_DIR", shared_target());
    command.output().unwrap()
}

/// The README's crate, made once.
fn double_pendulum() -> &'static Path {
    static FOLDER: OnceLock<PathBuf> = OnceLock::new();
    FOLDER.get_or_init(|| {
        let workspace = Path::new(env!("CARGO_MANIFEST_DIR")).parent().unwrap();
        let readme = fs::read_to_string(workspace.join("README.md")).unwrap();
        let source = block(&readme, "rust");
        assert!(source.lines().count() < 40);
        let folder = Path::new(env!("CARGO_TARGET_TMPDIR")).join("double-pendulum");
        fs::create_dir_all(folder.join("src")).unwrap();
        let manifest = block(&readme, "toml").replace("../linkwright", workspace.to_str().unwrap());
        fs::write(folder.join("Cargo.toml"), manifest + "\n[workspace]\n").unwrap();
        fs::write(folder.join("src/main.rs"), source).unwrap();
        // The versions that the workspace was built with are there already.
        fs::copy(workspace.join("Cargo.lock"), folder.join("Cargo.lock")).unwrap();
        folder
    })
}

#[test]
fn the_double_pendulum_of_the_readme_builds_runs_and_is_right() {
    let folder = double_pendulum();
    let run = |words: &[&str]| {
        let run = ["run", "--quiet", "--", "run", "double-pendulum", "--t-end", "3", "--steps", "30000"];
        cargo(folder, &[&run[..], words].concat())
    };
    let output = run(&[]);
    assert!(output.status.success(), "{}", String::from_utf8_lossy(&output.stderr));
    let out = folder.join("out/double-pendulum");
    let files = ["trajectory.csv", "summary.json", "report.html", "mechanism.svg", "mechanism.png", "tip_speed.svg"];
    for name in files {
        assert!(out.join(name).exists(), "{name}");
    }
    compare_with_reference(&fs::read_to_string(out.join("trajectory.csv")).unwrap());
    // Two letters in wrong order: exit status 2 and the way out.
    let mistaken = run(&["--set", "gg=3"]);
    assert_eq!(mistaken.status.code(), Some(2));
}

/// What `new` makes builds offline, passes its own test and runs.
#[test]
fn a_new_crate_builds_tests_and_runs() {
    let folder = Path::new(env!("CARGO_TARGET_TMPDIR")).join("my-linkage");
    let _ = fs::remove_dir_all(&folder);
    let done = |output: Output| {
        assert!(output.status.success(), "{}", String::from_utf8_lossy(&output.stderr));
        String::from_utf8(output.stdout).unwrap()
    };
    let said = done(cargo(double_pendulum(), &["run", "--quiet", "--", "new", folder.to_str().unwrap()]));
    assert!(said.contains("cargo run --release -- run my-linkage"), "{said}");
    let main = fs::read_to_string(folder.join("src/main.rs")).unwrap();
    assert_eq!(main.lines().count(), 4);
    let tested = done(cargo(&folder, &["test", "--quiet"]));
    assert!(tested.contains("1 passed"), "{tested}");
    let said = done(cargo(&folder, &["run", "--quiet", "--", "run", "my-linkage"]));
    assert!(said.contains("period") && folder.join("out/my-linkage/report.html").exists(), "{said}");
}

/// Angles from the direction of gravity, as in the reference, at whole seconds.
fn compare_with_reference(csv: &str) {
    let rows: Vec<Vec<f64>> =
        csv.lines().skip(1).map(|line| line.split(',').map(|cell| cell.parse().unwrap()).collect()).collect();
    let reference = reference("double_pendulum_hw6.json");
    let mut compared = 0;
    for entry in reference["reference"].as_array().unwrap() {
        let (quantity, at) = (entry["quantity"].as_str().unwrap(), entry["at"].as_str().unwrap());
        let column = match quantity {
            "l=0.6 phi1" => 1,
            "l=0.6 phi2" => 2,
            _ => continue,
        };
        let time: f64 = at.trim_start_matches("t=").parse().unwrap();
        let row = &rows[(time * 10_000.0).round() as usize];
        assert!((row[0] - time).abs() < 1e-12);
        let error = (row[column] - decimal(&entry["value"])).abs();
        println!("{quantity} at {at}: {error:.1e}");
        // (h omega)^4 with h = 1e-4 s and speeds up to 20 rad/s is 2e-11, which this motion amplifies.
        assert!(error < 1e-8, "{quantity} at {at}: {error:e}");
        compared += 1;
    }
    assert!(compared >= 6, "{compared}");
}
