//! The README's own mechanism: a crate beside the workspace, built and run as a new user would.

#![allow(missing_docs, clippy::unwrap_used)]

mod build_script;

use std::fs;
use std::path::Path;
use std::process::Command;
use tests::{decimal, reference};

/// The first code block of this language in the README.
fn block(readme: &str, language: &str) -> String {
    let opening = format!("```{language}\n");
    let start = readme.find(&opening).unwrap() + opening.len();
    let end = readme[start..].find("\n```").unwrap();
    readme[start..start + end + 1].to_owned()
}

#[test]
fn the_double_pendulum_of_the_readme_builds_runs_and_is_right() {
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
    let run = |words: &[&str]| {
        Command::new(env!("CARGO"))
            .args(["run", "--quiet", "--offline", "--", "run", "double-pendulum", "--t-end", "3", "--steps", "30000"])
            .args(words)
            .current_dir(&folder)
            .env("CARGO_TARGET_DIR", folder.join("target"))
            .output()
            .unwrap()
    };
    let output = run(&[]);
    assert!(output.status.success(), "{}", String::from_utf8_lossy(&output.stderr));
    let out = folder.join("out/double-pendulum");
    for name in ["trajectory.csv", "summary.json", "mechanism.svg", "mechanism.png", "tip_speed.svg", "height.png"] {
        assert!(out.join(name).exists(), "{name}");
    }
    compare_with_reference(&fs::read_to_string(out.join("trajectory.csv")).unwrap());
    // Two letters in wrong order: exit status 2 and the way out.
    let mistaken = run(&["--set", "gg=3"]);
    assert_eq!(mistaken.status.code(), Some(2));
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
