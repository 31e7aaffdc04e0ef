//! Commands give the numbers of the library's functions, whatever the size that they are compiled for.

#![allow(missing_docs, clippy::unwrap_used)]

#[path = "declared.rs"]
mod declared;

use declared::{Chain, Row};
use sim::{Compiled, Method, Rows, Settings, Stepping, Table, declared_start, run};
use std::fs;
use std::path::{Path, PathBuf};
use std::process::{Command, Output};

fn scratch(name: &str) -> PathBuf {
    let path = Path::new(env!("CARGO_TARGET_TMPDIR")).join("sizes").join(name);
    let _ = fs::remove_dir_all(&path);
    path
}

fn sizes(words: &[&str], out: &Path) -> Output {
    let output = Command::new(env!("CARGO_BIN_EXE_sizes")).args(words).arg("--out").arg(out).output().unwrap();
    assert!(output.status.success(), "{}", String::from_utf8_lossy(&output.stderr));
    output
}

/// The columns of a table as it was written.
fn written(folder: &Path) -> Vec<Vec<f64>> {
    let text = fs::read_to_string(folder.join("trajectory.csv")).unwrap();
    let rows: Vec<Vec<f64>> =
        text.lines().skip(1).map(|line| line.split(',').map(|cell| cell.parse().unwrap()).collect()).collect();
    (0..rows[0].len()).map(|column| rows.iter().map(|row| row[column]).collect()).collect()
}

/// A run by the command has the bits of a run by the loops that are compiled for the mechanism.
fn agrees<M: Compiled>(name: &str, options: &[&str], settings: &Settings) {
    let out = scratch(name);
    sizes(&[&["run", name, "--no-figures", "--no-report"], options].concat(), &out);
    let mechanism = M::defaults();
    let found = run(mechanism, &declared_start(&mechanism), settings).unwrap();
    let table = Table::of(&found.mechanism, &found.trajectory);
    let bits = |column: &[f64]| column.iter().map(|value| value.to_bits()).collect::<Vec<u64>>();
    let written = written(&out);
    assert_eq!(written.len(), table.columns.len());
    for (written, column) in written.iter().zip(&table.columns) {
        assert_eq!(bits(written), bits(&column.values), "{name}: {}", column.name);
    }
}

fn in_steps(end: f64, steps: usize) -> Settings {
    Settings { method: Method::Rk4, stepping: Stepping::Equal(steps), rows: Rows::Even(10), ..Settings::new(end) }
}

#[test]
fn twelve_coordinates_run_as_in_loops_of_their_own() {
    let options = ["--t-end", "1", "--method", "rk4", "--steps", "100", "--rows", "10"];
    agrees::<Row>("row", &options, &in_steps(1.0, 100));
}

#[test]
fn seventy_coordinates_run_as_in_loops_of_their_own() {
    let options = ["--t-end", "0.1", "--method", "rk4", "--steps", "20", "--rows", "10"];
    agrees::<Chain>("chain", &options, &in_steps(0.1, 20));
}

#[test]
fn a_program_may_have_loops_of_its_own() {
    agrees::<models::QuickReturn>("quick-return", &[], &Settings::new(2.0));
}

#[test]
fn seventy_coordinates_are_analysed() {
    for command in ["assemble", "info"] {
        let output = Command::new(env!("CARGO_BIN_EXE_sizes")).args([command, "chain", "--json"]).output().unwrap();
        let said: serde_json::Value = serde_json::from_slice(&output.stdout).unwrap();
        assert_eq!(said["degrees_of_freedom"], 35, "{command}");
    }
    let words = ["linearize", "chain", "--json", "--at", "equilibrium"];
    let said: serde_json::Value = serde_json::from_slice(&sizes(&words, &scratch("linear")).stdout).unwrap();
    let frequencies = said["modes"].as_array().unwrap().iter().map(|mode| mode["frequency_hz"].as_f64().unwrap());
    let lowest = frequencies.filter(|frequency| *frequency > 0.0).fold(f64::INFINITY, f64::min);
    // The fastest mode has 110 rad/s, so rounding moves eigenvalues of 70 rows by about 70 * 110 * 2e-16 = 2e-12. The rest is
    // left to the equilibrium, which is iterated to.
    assert!((lowest - hanging_chain(35, 0.1)).abs() < 1e-9, "{lowest}");
}

/// The lowest frequency of equal masses on rods of equal length l, in Hz: `g/l x` is the least zero of the Laguerre
/// polynomial L_n, by its recurrence and bisection.
fn hanging_chain(masses: usize, length: f64) -> f64 {
    let laguerre = |x: f64| {
        let (mut before, mut value) = (1.0, 1.0 - x);
        for k in 1..masses {
            let k = k as f64;
            (before, value) = (value, ((2.0 * k + 1.0 - x) * value - k * before) / (k + 1.0));
        }
        value
    };
    // L_n(0) = 1, and its least zero is below 3/(n + 1/2).
    let [mut below, mut above] = [0.0, 3.0 / (masses as f64 + 0.5)];
    for _ in 0..100 {
        let middle = 0.5 * (below + above);
        if laguerre(middle) > 0.0 { below = middle } else { above = middle }
    }
    (9.81 / length * below).sqrt() / std::f64::consts::TAU
}
