//! The command line as a user meets it: the binary, its words, its files and its exit statuses.

#![allow(missing_docs, clippy::unwrap_used)]

mod analysis;
mod commit;
mod digits;
mod failing;
mod files;
mod info;
mod inputs;
mod kernels;
mod provenance;
mod run_files;
mod warnings;
mod watch;

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
    expected.extend(["report.html", "run.json", "summary.json", "timing.json", "trajectory.csv"].map(String::from));
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
    assert_eq!(headers[10..13], ["lambda_guide [N]", "lambda_slot [N]", "work [J]"]);
    assert_eq!(headers.len(), 13 + 10);
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
    let rows: [(&[&str], &str); 23] = [
        (&["run", "quick-retrun"], "no model is called `quick-retrun` (did you mean `quick-return`?)"),
        (&["run", "quick-return", "--set", "O2B=1"], "no parameter is called `O2B` (did you mean `O2A`?)"),
        (&["run", "quick-return", "--input", "push=1"], "no input is called `push`: there is none"),
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
        (&["run", "quick-return", "--method", "rk4", "--rtol", "1e-5"], "rk4 takes equal steps and estimates no error"),
        (&["run", "quick-return", "--method", "euler", "--atol", "1e-5"], "dopri5, radau5, dop853"),
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

/// A run that is to end with an event that does not come says so.
#[test]
fn an_event_that_never_comes_is_told() {
    let directory = fresh("never");
    let words = ["run", "quick-return", "--until", "period:3", "--no-figures", "--no-report", "--out"];
    let output = sim(&[&words[..], &[directory.to_str().unwrap()]].concat());
    assert!(output.status.success(), "{}", stderr(&output));
    let told = "until        `period` has happened 1 time, not 3: the run went on to its end";
    assert!(stdout(&output).contains(told), "{}", stdout(&output));
}

#[test]
fn programs_read_json_and_quiet_is_quiet() {
    let directory = fresh("json");
    let words = ["run", "four-bar", "--out", directory.to_str().unwrap(), "--no-figures", "--no-report"];
    let said: Value = serde_json::from_str(&stdout(&sim(&[&words[..], &["--json"]].concat()))).unwrap();
    assert_eq!(said["model"], "four-bar");
    assert!(said["files"].as_array().unwrap().iter().any(|file| file == "trajectory.csv"));
    let quiet = sim(&[&words[..], &["--quiet"]].concat());
    assert!(quiet.status.success() && quiet.stdout.is_empty() && quiet.stderr.is_empty());
    for model in serde_json::from_str::<Value>(&stdout(&sim(&["list", "--json"]))).unwrap().as_array().unwrap() {
        let name = model["name"].as_str().unwrap();
        let info: Value = serde_json::from_str(&stdout(&sim(&["info", name, "--json"]))).unwrap();
        assert_eq!(info["coordinates"].as_array().unwrap().len() as u64, model["coordinates"].as_u64().unwrap());
        assert!(info["kernels"].as_array().unwrap().iter().any(|kernel| kernel["name"] == "dynamics"), "{name}");
        // A mechanism that time drives has none.
        assert!(info["degrees_of_freedom"].is_u64(), "{name}");
        let assembled: Value = serde_json::from_str(&stdout(&sim(&["assemble", name, "--json"]))).unwrap();
        assert_eq!(assembled["degrees_of_freedom"], info["degrees_of_freedom"], "{name}");
    }
}

#[test]
fn plots_and_comparisons_are_drawn_from_runs() {
    let (one, other) = (fresh("one"), fresh("other"));
    for (directory, length) in [(&one, "O2A=200mm"), (&other, "O2A=180mm")] {
        let words = ["run", "quick-return", "--set", length, "--no-figures", "--no-report", "--rows", "200"];
        assert!(sim(&[&words[..], &["--out", directory.to_str().unwrap()]].concat()).status.success());
    }
    let (one, other) = (one.to_str().unwrap(), other.to_str().unwrap());
    let output = sim(&["plot", one, "x6", "x6_velocity", "alpha_dot", "--size", "500x600"]);
    assert!(output.status.success(), "{}", stderr(&output));
    let svg = fs::read_to_string(format!("{one}/plot-x6-x6_velocity-alpha_dot.svg")).unwrap();
    // Three panels over one time axis.
    assert!(svg.contains("width=\"500\" height=\"600\"") && svg.matches("time [s]").count() == 1, "{svg}");
    for label in ["x6 [m]", "x6_velocity [m/s]", "alpha_dot [rad/s]"] {
        assert!(svg.contains(label), "{label}");
    }
    assert!(sim(&["plot", one, "alpha_dot", "--against", "alpha"]).status.success());
    let phase = fs::read_to_string(format!("{one}/plot-alpha_dot-against-alpha.svg")).unwrap();
    assert!(phase.contains("alpha [rad]") && !phase.contains("time"));

    let out = fresh("compared");
    let output = sim(&["compare", one, other, "--quantity", "x6", "--out", out.to_str().unwrap()]);
    assert!(output.status.success(), "{}", stderr(&output));
    let svg = fs::read_to_string(out.join("x6.svg")).unwrap();
    assert!(svg.contains(">one<") && svg.contains(">other<") && out.join("x6.png").exists(), "{svg}");

    let rows: [(&[&str], &str); 4] = [
        (&["plot", one, "x66"], "did you mean `x6`?"),
        (&["plot", "nowhere", "x6"], "no run at nowhere"),
        (&["plot", one, "x6", "--size", "9x9"], "as in 960x540"),
        (&["compare", one], "2 values required"),
    ];
    for (words, expected) in rows {
        let output = sim(words);
        assert_eq!(output.status.code(), Some(2), "{words:?}: {}", stderr(&output));
        assert!(stderr(&output).contains(expected), "{words:?}: {}", stderr(&output));
    }
}

/// Ctrl-C ends a run with what there is: exit status 130.
#[cfg(unix)]
#[test]
fn what_installs_with_the_program_is_generated() {
    for (words, expected) in [
        (&["generate", "completions", "bash"][..], "quick-return|complete"),
        (&["generate", "completions", "zsh"], "compdef"),
        (&["generate", "completions", "fish"], "quick-return"),
        (&["generate", "man"], ".TH sim"),
        (&["generate", "schema"], "Linkwright run file"),
    ] {
        let output = sim(words);
        assert!(output.status.success());
        assert!(expected.split('|').any(|word| stdout(&output).contains(word)), "{words:?}");
    }
}

#[test]
fn new_says_what_is_in_the_way() {
    let place = scratch("new");
    let taken = place.to_str().unwrap();
    let rows: [(&[&str], &str); 3] = [
        (&["new", taken], "exists already"),
        (&["new", "2bars"], "start with a letter"),
        (&["new", "bars", "--linkwright", "/nowhere"], "--linkwright PATH|URL"),
    ];
    for (words, expected) in rows {
        let output = sim(words);
        assert_eq!(output.status.code(), Some(2), "{words:?}");
        assert!(stderr(&output).contains(expected), "{words:?}: {}", stderr(&output));
    }
}

/// NumPy's own reader finds in both archives what the CSV says, to the last bit.
#[test]
#[ignore = "needs Python with NumPy; .ci/run installs it and runs this"]
fn numpy_reads_what_the_csv_says() {
    let directory = fresh("numpy");
    let words = ["run", "quick-return", "--no-figures", "--no-report", "--format", "csv,npy,npz"];
    assert!(sim(&[&words[..], &["--out", directory.to_str().unwrap()]].concat()).status.success());
    let script = "
import csv, numpy, sys
rows = list(csv.reader(open('trajectory.csv')))
archive, records = numpy.load('trajectory.npz'), numpy.load('trajectory.npy')
for i, header in enumerate(rows[0]):
    name = header.split(' [')[0]
    column = numpy.array([float(row[i]) for row in rows[1:]])
    assert archive[name].dtype == numpy.float64 and len(column) > 1000
    assert numpy.array_equal(archive[name], column), name
    assert numpy.array_equal(records[name], column), name
print(len(rows[0]), 'columns of', len(rows) - 1)
";
    let python = std::env::var("PYTHON").unwrap_or_else(|_| "python3".into());
    let output = Command::new(python).args(["-c", script]).current_dir(&directory).output().unwrap();
    assert!(output.status.success(), "{}", stderr(&output));
    assert!(stdout(&output).contains("23 columns"), "{}", stdout(&output));
}

/// A full disk is an error that names the file, not a short file.
#[cfg(target_os = "linux")]
#[test]
fn verify_prints_a_row_for_each_check() {
    let output = sim(&["verify", "quick-return", "--t-end", "0.2"]);
    assert!(output.status.success(), "{}", stderr(&output));
    let text = stdout(&output);
    for row in ["TMT against Lagrange", "kernels against the oracle", "projection against partitioning", "reactions"] {
        assert!(text.lines().any(|line| line.starts_with(row) && line.contains(" ok ")), "{row}:\n{text}");
    }
}

#[test]
fn assemble_and_equilibrium_print_what_they_find() {
    let output = sim(&["assemble", "quick-return"]);
    let text = stdout(&output);
    assert!(text.contains("1 degree of freedom") && text.contains("gamma") && text.contains("1.843"), "{text}");
    let output = sim(&["assemble", "four-bar", "--set", "d=3m"]);
    assert_eq!(output.status.code(), Some(1));
    assert!(stderr(&output).contains("cannot be assembled"), "{}", stderr(&output));
    let output = sim(&["equilibrium", "pendulum", "--initial", "phi=20deg"]);
    assert!(stdout(&output).contains("3.132"), "{}", stdout(&output));
}
