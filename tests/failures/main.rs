//! Whatever fails, as a user meets it: what the message says, and that what was computed stands on disk, complete and
//! readable.

#![allow(missing_docs, clippy::unwrap_used)]

mod disk;
mod faults;
mod runs;
#[cfg(unix)]
mod signals;

use serde_json::Value;
use std::fs;
use std::path::{Path, PathBuf};
use std::process::{Command, Output};

/// The command line over mechanisms that fail.
fn failing(words: &[&str]) -> Output {
    Command::new(env!("CARGO_BIN_EXE_failing")).args(words).output().unwrap()
}

fn fresh(name: &str) -> PathBuf {
    let path = Path::new(env!("CARGO_TARGET_TMPDIR")).join("failures").join(name);
    let _ = fs::remove_dir_all(&path);
    path
}

fn stderr(output: &Output) -> String {
    String::from_utf8(output.stderr.clone()).unwrap()
}

fn summary(directory: &Path) -> Value {
    serde_json::from_str(&fs::read_to_string(directory.join("summary.json")).unwrap()).unwrap()
}

/// The rows of a table, all of them whole and of finite numbers.
fn rows(directory: &Path) -> Vec<Vec<f64>> {
    let text = fs::read_to_string(directory.join("trajectory.csv")).unwrap();
    assert!(text.ends_with('\n'));
    let columns = text.lines().next().unwrap().split(',').count();
    let numbers = |line: &str| line.split(',').map(|cell| cell.parse::<f64>().unwrap()).collect::<Vec<f64>>();
    let rows: Vec<Vec<f64>> = text.lines().skip(1).map(numbers).collect();
    assert!(rows.iter().all(|row| row.len() == columns && row.iter().all(|value| value.is_finite())));
    rows
}

/// That a run's files belong together: every row is there and in order, to where the summary says that it came, and what the
/// summary says of its failure was said. Gives the time reached.
fn complete(directory: &Path, said: &str) -> f64 {
    let (summary, rows) = (summary(directory), rows(directory));
    assert!(said.contains(summary["failure"].as_str().unwrap()), "{said}\n{summary:#}");
    assert_eq!(rows.len() as u64, summary["end"]["samples"].as_u64().unwrap());
    assert!(rows.windows(2).all(|pair| pair[0][0] <= pair[1][0]));
    let reached = summary["end"]["reached"].as_f64().unwrap();
    // JSON is read here to the last digit but one.
    assert!((rows.last().map_or(0.0, |row| row[0]) - reached).abs() <= 1e-15 * reached);
    // What makes the run again is there too.
    let again: Value = serde_json::from_str(&fs::read_to_string(directory.join("run.json")).unwrap()).unwrap();
    assert_eq!(again["model"], summary["model"]);
    reached
}
