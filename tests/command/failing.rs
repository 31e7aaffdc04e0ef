//! Runs that fail: what is said, and what is kept.

use super::{column, fresh, scratch, sim, stderr, summary};
use std::fs;
use std::process::Command;

/// Steps of a fifth of the period are too large: the run ends with a message, and what was computed until then is
/// written.
#[test]
fn a_run_that_fails_keeps_what_it_computed() {
    let directory = fresh("failing");
    let output =
        sim(&["run", "quick-return", "--method", "rk4", "--steps", "12", "--out", directory.to_str().unwrap()]);
    assert_eq!(output.status.code(), Some(1));
    let message = stderr(&output);
    assert!(
        message.contains("at t = ")
            && message.contains("alpha = ")
            && message.contains(" rad, beta = ")
            && message.contains("constraint"),
        "{message}"
    );
    let summary = summary(&directory);
    assert!(message.contains(summary["failure"].as_str().unwrap()), "{summary}");
    let times = column(&directory, "t [s]");
    assert!(times.len() > 1 && *times.last().unwrap() == summary["end"]["reached"].as_f64().unwrap());
    assert!(summary["residuals"]["position"].as_f64().unwrap() <= 1e-6);
    assert!(directory.join("mechanism.png").exists());
}

#[test]
fn a_place_that_cannot_be_written_is_named() {
    let file = scratch("blocked").join("file");
    fs::write(&file, "in the way").unwrap();
    let below = file.join("out");
    let output = sim(&["run", "quick-return", "--steps", "10", "--out", below.to_str().unwrap()]);
    assert_eq!(output.status.code(), Some(1));
    assert!(
        stderr(&output).contains("cannot write") && stderr(&output).contains("blocked/file"),
        "{}",
        stderr(&output)
    );
}

#[test]
fn an_interrupted_run_keeps_what_it_has() {
    let directory = fresh("interrupted");
    let words = ["run", "double-pendulum", "--t-end", "1e7", "--rows", "10000000", "--no-figures", "--no-report"];
    let mut child = Command::new(env!("CARGO_BIN_EXE_sim"))
        .args(words)
        .args(["--out", directory.to_str().unwrap(), "--format", "jsonl"])
        .stdout(std::process::Stdio::null())
        .stderr(std::process::Stdio::piped())
        .spawn()
        .unwrap();
    std::thread::sleep(std::time::Duration::from_millis(700));
    assert!(Command::new("kill").args(["-INT", &child.id().to_string()]).status().unwrap().success());
    let mut said = String::new();
    std::io::Read::read_to_string(child.stderr.as_mut().unwrap(), &mut said).unwrap();
    assert_eq!(child.wait().unwrap().code(), Some(130), "{said}");
    assert!(said.contains("interrupted"), "{said}");
    let summary = summary(&directory);
    assert!(summary["end"]["reached"].as_f64().unwrap() > 0.0 && summary["end"]["samples"].as_u64().unwrap() > 1);
    assert!(fs::metadata(directory.join("trajectory.jsonl")).unwrap().len() > 1000);
}

#[test]
fn a_full_disk_is_an_error() {
    let directory = fresh("full");
    fs::create_dir_all(&directory).unwrap();
    std::os::unix::fs::symlink("/dev/full", directory.join("trajectory.csv")).unwrap();
    let output = sim(&["run", "quick-return", "--no-figures", "--out", directory.to_str().unwrap()]);
    assert_eq!(output.status.code(), Some(1));
    assert!(
        stderr(&output).contains("trajectory.csv") && stderr(&output).contains("No space left"),
        "{}",
        stderr(&output)
    );
}
