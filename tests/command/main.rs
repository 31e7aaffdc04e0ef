//! The command line as a user meets it: the binary, its words, its files and its exit statuses.

#![allow(missing_docs, clippy::unwrap_used)]

use serde_json::Value;
use std::fs;
use std::path::{Path, PathBuf};
use std::process::{Command, Output};

/// Runs the binary in a directory of its own.
fn sim(arguments: &[&str]) -> Output {
    let directory = scratch("work");
    Command::new(env!("CARGO_BIN_EXE_sim")).args(arguments).current_dir(directory).output().unwrap()
}

fn scratch(name: &str) -> PathBuf {
    let path = Path::new(env!("CARGO_TARGET_TMPDIR")).join(name);
    fs::create_dir_all(&path).unwrap();
    path
}

fn fresh(name: &str) -> PathBuf {
    let path = Path::new(env!("CARGO_TARGET_TMPDIR")).join(name);
    let _ = fs::remove_dir_all(&path);
    path
}

fn stderr(output: &Output) -> String {
    String::from_utf8(output.stderr.clone()).unwrap()
}

fn stdout(output: &Output) -> String {
    String::from_utf8(output.stdout.clone()).unwrap()
}

fn summary(directory: &Path) -> Value {
    serde_json::from_str(&fs::read_to_string(directory.join("summary.json")).unwrap()).unwrap()
}

/// Columns of a CSV by header.
fn column(directory: &Path, header: &str) -> Vec<f64> {
    let mut reader = csv::Reader::from_path(directory.join("trajectory.csv")).unwrap();
    let at = reader.headers().unwrap().iter().position(|cell| cell == header).unwrap();
    reader.records().map(|record| record.unwrap()[at].parse().unwrap()).collect()
}

#[test]
fn list_names_the_mechanisms() {
    let output = sim(&["list"]);
    assert!(output.status.success());
    let text = stdout(&output);
    assert!(
        text.contains("quick-return ")
            && text.contains("quick-return-ratio")
            && text.contains("3 coordinates, 2 constraints")
    );
}

/// 0.877997139511 s: the exact period, which the default tolerance of 1e-10 finds to 1e-12 s or so.
#[test]
fn run_writes_motion_summary_and_figures() {
    let directory = fresh("run");
    let output = sim(&["run", "quick-return", "--out", directory.to_str().unwrap()]);
    assert!(output.status.success(), "{}", stderr(&output));
    assert!(stdout(&output).contains("period       0.87799713951"));
    let mut files: Vec<String> =
        fs::read_dir(&directory).unwrap().map(|entry| entry.unwrap().file_name().into_string().unwrap()).collect();
    files.sort();
    let figures = [
        "angular_speeds",
        "mechanism",
        "normal_forces",
        "slider3_speed",
        "slider6_acceleration",
        "slider6_position",
        "slider6_velocity",
    ];
    let mut expected: Vec<String> =
        figures.iter().flat_map(|name| [format!("{name}.png"), format!("{name}.svg")]).collect();
    expected.extend(["summary.json", "timing.json", "trajectory.csv"].map(String::from));
    expected.sort();
    assert_eq!(files, expected);

    let mut reader = csv::Reader::from_path(directory.join("trajectory.csv")).unwrap();
    let headers: Vec<String> = reader.headers().unwrap().iter().map(String::from).collect();
    assert_eq!(headers[..4], ["t [s]", "alpha [rad]", "beta [rad]", "gamma [rad]"]);
    assert_eq!(
        headers[4..10],
        [
            "alpha_dot [rad/s]",
            "beta_dot [rad/s]",
            "gamma_dot [rad/s]",
            "alpha_ddot [rad/s^2]",
            "beta_ddot [rad/s^2]",
            "gamma_ddot [rad/s^2]"
        ]
    );
    assert_eq!(headers[10..12], ["lambda_guide [N]", "lambda_slot [N]"]);
    assert_eq!(headers.len(), 12 + 10);
    assert_eq!(reader.records().count(), 1025);

    let summary = summary(&directory);
    assert!((summary["period"].as_f64().unwrap() - 0.877_997_139_511_224_4).abs() < 1e-10);
    assert_eq!(summary["events"][0]["name"], "period");
    assert_eq!(summary["parameters"]["O2A"], serde_json::json!({ "value": 0.2, "unit": "m" }));
    assert!(summary["residuals"]["position"].as_f64().unwrap() <= 1e-12);
    assert_eq!(summary["failure"], Value::Null);
}

/// All files but the timing are the same bytes run after run.
#[test]
fn runs_repeat_to_the_byte() {
    let directories = [fresh("first"), fresh("second")];
    for directory in &directories {
        let output = sim(&["run", "quick-return-ratio", "--steps", "500", "--out", directory.to_str().unwrap()]);
        assert!(output.status.success());
    }
    for entry in fs::read_dir(&directories[0]).unwrap() {
        let name = entry.unwrap().file_name();
        if name != "timing.json" {
            let [first, second] = directories.each_ref().map(|directory| fs::read(directory.join(&name)).unwrap());
            assert!(first == second, "{name:?}");
        }
    }
}

#[test]
fn settings_have_units() {
    let directory = fresh("set");
    let out = directory.to_str().unwrap();
    let settings =
        ["--set", "O2A=180mm", "--set", "F=0.5 kN", "--initial", "alpha=30deg", "--initial", "alpha_dot=-60rpm"];
    let grid = ["--t-end", "250ms", "--step", "1ms", "--no-figures"];
    let output = sim(&[&["run", "quick-return", "--out", out], &settings[..], &grid[..]].concat());
    assert!(output.status.success(), "{}", stderr(&output));
    let summary = summary(&directory);
    assert_eq!(summary["parameters"]["O2A"]["value"], 0.18);
    assert_eq!(summary["parameters"]["F"]["value"], 500.0);
    assert_eq!(summary["method"]["accepted_steps"], 250);
    let start = |header: &str| column(&directory, header)[0];
    assert!((start("alpha [rad]") - std::f64::consts::FRAC_PI_6).abs() < 1e-15);
    assert!((start("alpha_dot [rad/s]") + 2.0 * std::f64::consts::PI).abs() < 1e-14);
    assert_eq!(column(&directory, "t [s]").last(), Some(&0.25));
    assert!(!directory.join("mechanism.svg").exists());
}

/// Words that cannot be understood: exit status 2, and the way out.
#[test]
fn unknown_words_name_the_nearest_known() {
    let rows: [(&[&str], &str); 20] = [
        (&["run", "quick-retrun"], "no model is called `quick-retrun` (did you mean `quick-return`?)"),
        (&["run", "quick-return", "--set", "O2B=1"], "no parameter is called `O2B` (did you mean `O2A`?)"),
        (&["run", "quick-return", "--set", "O2A=1 mtr"], "`mtr` is not a known unit"),
        (&["run", "quick-return", "--set", "O2A=1 kgg"], "did you mean `kg`?"),
        (&["run", "quick-return", "--set", "O2A=1kg"], "`kg` is a unit of dimension kg, but m is needed"),
        (&["run", "quick-return", "--set", "O2A"], "expected NAME=VALUE"),
        (&["run", "quick-return", "--initial", "alpha_dott=1"], "did you mean `alpha_dot`?"),
        (&["run", "quick-return", "--t-end", "-1"], "a time above 0"),
        (&["run", "quick-return", "--steps", "0"], "a whole number above 0"),
        (&["run", "quick-return", "--steps", "1e3"], "a whole number above 0"),
        (&["run", "quick-return", "--set", "alpha=1"], "`--initial alpha=1`"),
        (&["run", "quick-return", "--initial", "O2A=1"], "`--set O2A=1`"),
        (&["run", "quick-return", "--step", "1e-12"], "steps are asked for"),
        (&["run", "quick-return", "--method", "rk5"], "no method is called `rk5` (did you mean `rk3`?)"),
        (&["run", "quick-return", "--rtol", "1e-20"], "--rtol from 1e-14 to 0.1"),
        (&["run", "quick-return", "--rtol", "1e-8", "--steps", "100"], "cannot be used with"),
        (&["run", "quick-return", "--projection", "baumgart"], "known: projection, mass-projection, partitioning"),
        (&["run", "quick-return", "--rows", "0"], "a whole number from 1"),
        (&["run", "quick-return", "--until", "perod"], "no event is called `perod` (did you mean `period`?)"),
        (&["rum", "quick-return"], "unrecognized subcommand"),
    ];
    for (arguments, expected) in rows {
        let output = sim(arguments);
        assert_eq!(output.status.code(), Some(2), "{arguments:?}: {}", stderr(&output));
        assert!(stderr(&output).contains(expected), "{arguments:?}: {}", stderr(&output));
    }
}

/// Steps of a fifth of the period are too large: the run ends with a message, and what was computed until then is
/// written.
#[test]
fn a_run_that_fails_keeps_what_it_computed() {
    let directory = fresh("failing");
    let output =
        sim(&["run", "quick-return", "--method", "rk4", "--steps", "12", "--out", directory.to_str().unwrap()]);
    assert_eq!(output.status.code(), Some(1));
    let message = stderr(&output);
    assert!(message.contains("at t = ") && message.contains("alpha = ") && message.contains("constraint"), "{message}");
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

/// The period does not depend on the method, and `--until` ends the run there.
#[test]
fn methods_and_projections_find_the_same_period() {
    let directory = fresh("methods");
    let rows: [&[&str]; 4] = [
        &[],
        &["--method", "rk4", "--steps", "8192"],
        &["--method", "dopri5", "--rtol", "1e-11"],
        &["--projection", "partitioning"],
    ];
    for options in rows {
        let arguments =
            ["run", "quick-return", "--no-figures", "--until", "period", "--out", directory.to_str().unwrap()];
        let output = sim(&[&arguments[..], options].concat());
        assert!(output.status.success(), "{}", stderr(&output));
        let period = summary(&directory)["period"].as_f64().unwrap();
        // The tolerance of a step, 1e-11 rad and more, at 7 rad/s.
        assert!((period - 0.877_997_139_511_224_4).abs() < 1e-10, "{options:?}: {period}");
        assert_eq!(column(&directory, "t [s]").last(), Some(&period), "{options:?}");
    }
}
