//! Places that cannot be written.

use crate::{complete, failing, fresh, rows, stderr, summary};
use std::fs;

/// A place that cannot be is refused before anything is computed: this run would take days.
#[test]
fn a_path_below_a_regular_file() {
    let file = fresh("blocked").join("file");
    fs::create_dir_all(file.parent().unwrap()).unwrap();
    fs::write(&file, "in the way").unwrap();
    let below = file.join("out");
    let output = failing(&["run", "quick-return", "--t-end", "1e9", "--out", below.to_str().unwrap()]);
    let said = stderr(&output);
    assert_eq!(output.status.code(), Some(1));
    assert!(
        said.contains("cannot write") && said.contains("blocked/file/out") && said.contains("Not a directory"),
        "{said}"
    );
    assert_eq!(fs::read_to_string(&file).unwrap(), "in the way");
}

/// Where nobody can hear what is wrong, the exit status tells.
#[cfg(target_os = "linux")]
#[test]
fn errors_that_cannot_be_told() {
    for (words, status) in [(["run", "no-such-model"], 2), (["check", "no-such-file.urdf"], 1)] {
        let full = fs::OpenOptions::new().write(true).open("/dev/full").unwrap();
        let mut command = std::process::Command::new(env!("CARGO_BIN_EXE_failing"));
        assert_eq!(command.args(words).stderr(full).status().unwrap().code(), Some(status), "{words:?}");
    }
}

/// A full disk is an error that names the file; every other file is written, whole.
#[cfg(target_os = "linux")]
#[test]
fn a_full_disk() {
    let files = [
        "run.json",
        "trajectory.csv",
        "trajectory.npz",
        "summary.json",
        "report.html",
        "mechanism.svg",
        "mechanism.png",
        "timing.json",
    ];
    for full in files {
        let directory = fresh("full");
        fs::create_dir_all(&directory).unwrap();
        std::os::unix::fs::symlink("/dev/full", directory.join(full)).unwrap();
        let output = failing(&[
            "run",
            "quick-return",
            "--format",
            "csv,npz",
            "--t-end",
            "0.1",
            "--out",
            directory.to_str().unwrap(),
        ]);
        let said = stderr(&output);
        println!("{said}");
        assert_eq!(output.status.code(), Some(1), "{full}: {said}");
        assert!(
            said.contains("cannot write") && said.contains(full) && said.contains("No space left"),
            "{full}: {said}"
        );
        assert_eq!(said.lines().count(), 1, "{said}");
        // What is rendered from a figure that could not be written is not there either.
        let stem = |name: &str| name.split_once('.').map(|(stem, _)| stem.to_owned());
        let is_other = |other: &&&str| stem(other) != stem(full) || !full.starts_with("mechanism");
        for other in files.iter().filter(|other| **other != full).filter(is_other) {
            assert!(fs::metadata(directory.join(other)).is_ok_and(|file| file.len() > 0), "{full}: {other} is missing");
        }
        if !["trajectory.csv", "summary.json"].contains(&full) {
            assert_eq!(rows(&directory).len() as u64, summary(&directory)["end"]["samples"].as_u64().unwrap());
        }
    }
}

/// A run that fails on a full disk says both.
#[cfg(target_os = "linux")]
#[test]
fn a_run_that_fails_on_a_full_disk() {
    let directory = fresh("full-failing");
    fs::create_dir_all(&directory).unwrap();
    std::os::unix::fs::symlink("/dev/full", directory.join("report.html")).unwrap();
    let output = failing(&["run", "root", "--no-figures", "--out", directory.to_str().unwrap()]);
    let said = stderr(&output);
    assert_eq!(output.status.code(), Some(1));
    assert!(said.contains("report.html") && said.contains("is not finite"), "{said}");
    assert!(complete(&directory, &said) > 0.0);
}
