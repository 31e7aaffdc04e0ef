//! Signals end whatever goes on with what there is.

use crate::{complete, fresh, rows, summary};
use std::fs;
use std::path::Path;
use std::process::{Child, Command, Stdio};
use std::time::Duration;

fn start(words: &[&str], directory: &Path) -> Child {
    start_of(env!("CARGO_BIN_EXE_failing"), words, directory)
}

fn start_of(program: &str, words: &[&str], directory: &Path) -> Child {
    let mut command = Command::new(program);
    command.args(words).arg("--out").arg(directory).stdout(Stdio::null()).stderr(Stdio::piped());
    command.spawn().unwrap()
}

fn send(signal: &str, child: &Child) {
    assert!(Command::new("kill").args([signal, &child.id().to_string()]).status().unwrap().success());
}

/// Sends a signal, and gives the exit status and what was said.
fn ended_by(signal: &str, child: Child) -> (Option<i32>, String) {
    send(signal, &child);
    ended(child)
}

fn ended(mut child: Child) -> (Option<i32>, String) {
    let mut said = String::new();
    std::io::Read::read_to_string(child.stderr.as_mut().unwrap(), &mut said).unwrap();
    (child.wait().unwrap().code(), said)
}

/// Rows to where a run came, whole, and exit status 130.
#[test]
fn a_run_keeps_what_it_has() {
    for signal in ["-INT", "-TERM"] {
        let directory = fresh(&format!("interrupted{signal}"));
        let words = ["run", "quick-return", "--t-end", "1e6", "--rows", "20", "--no-figures"];
        let child = start(&words, &directory);
        std::thread::sleep(Duration::from_millis(1000));
        let (status, said) = ended_by(signal, child);
        assert_eq!(status, Some(130), "{said}");
        assert!(
            said.contains("at t = ") && said.contains("interrupted; what was computed until then is kept"),
            "{said}"
        );
        assert!(complete(&directory, &said) > 0.0);
        // A day's run that is ended after a second has rows of that second: more than 160 steps are made in it.
        assert!((21..=42).contains(&rows(&directory).len()), "{}", rows(&directory).len());
    }
}

/// A sweep that would take hours has the rows until then, and extremes.
#[test]
fn a_sweep_keeps_what_it_has() {
    let words = ["kinematics", "quick-return", "--steps", "10000000", "--no-figures"];
    for signal in ["-INT", "-TERM"] {
        let directory = fresh(&format!("swept{signal}"));
        let child = start(&words, &directory);
        std::thread::sleep(Duration::from_millis(500));
        let (status, said) = ended_by(signal, child);
        assert_eq!(status, Some(130), "{said}");
        assert!(said.contains("interrupted; what was computed until then is kept"), "{said}");
        let (table, summary) = (rows(&directory), summary(&directory));
        assert!(table.len() > 100 && summary["drive"]["samples"] == table.len(), "{}", table.len());
        assert!(summary["failure"].as_str().unwrap().contains("interrupted"), "{summary:#}");
        assert!(summary["transmission_index"]["greatest"]["value"].as_f64().unwrap() <= 1.0, "{summary:#}");
    }
}

/// A run of seventy coordinates: its numbers are whole, after one signal as after two. Its report is drawn as far as there is
/// time, and so is whole or absent; after a second signal there is none.
#[test]
fn numbers_come_before_pictures() {
    for second in [None, Some("-TERM")] {
        let directory = fresh(&format!("pressed{}", second.unwrap_or_default()));
        let child = start_of(env!("CARGO_BIN_EXE_sizes"), &["run", "chain", "--t-end", "1e6"], &directory);
        std::thread::sleep(Duration::from_millis(3000));
        send("-INT", &child);
        if let Some(signal) = second {
            std::thread::sleep(Duration::from_millis(10));
            send(signal, &child);
        }
        let (status, said) = ended(child);
        assert_eq!(status, Some(130), "{said}");
        assert!(complete(&directory, &said) > 0.0);
        assert!(!directory.join(".unfinished").exists());
        match fs::read_to_string(directory.join("report.html")) {
            Ok(report) => assert!(second.is_none() && report.trim_end().ends_with("</html>"), "{said}"),
            Err(_) => {
                let told = "interrupted; written until then: trajectory.csv, run.json, summary.json";
                assert!(said.contains(told), "{said}");
            }
        }
    }
}
