//! Random linkages: how many of 20,000 are wrong, refused in vain, or undecided.

use crate::figures::Table;
use std::io::{BufRead, BufReader};
use std::process::{Command, Stdio};
use std::time::Instant;

const RUNS: f64 = 20_000.0;

pub(super) fn measure(table: &mut Table) {
    table.heading("Random linkages");
    let begun = Instant::now();
    match last_line() {
        Ok(line) => {
            let minutes = begun.elapsed().as_secs_f64() / 60.0;
            let count = |word: &str| {
                let after = line.split(word).nth(1).unwrap_or_default().trim_start();
                let digits = after.split(|c: char| !c.is_ascii_digit()).next().unwrap_or_default();
                digits.parse::<f64>().unwrap_or(f64::NAN)
            };
            println!("{line}");
            table.at_most("wrong", count("wrong "), 0.0);
            table.at_most("% refused though there is an answer", 100.0 * count("refused ") / RUNS, 1.0);
            table.at_most("% undecided", 100.0 * count("undecided ") / RUNS, 2.0);
            table.at_most("minutes", minutes, 40.0);
        }
        Err(why) => table.line("20,000 runs", why, "measured", false),
    }
}

/// What the command says at its end. What it says before is passed on.
fn last_line() -> std::io::Result<String> {
    let cargo = std::env::var_os("CARGO").unwrap_or_else(|| "cargo".into());
    let mut command = Command::new(cargo);
    command.args(["run", "--release", "--quiet", "-p", "tests", "--bin", "stress", "--", "20000", "--seed", "1"]);
    let mut child = command.stdout(Stdio::piped()).spawn()?;
    let mut last = String::new();
    if let Some(output) = child.stdout.take() {
        for line in BufReader::new(output).lines() {
            let line = line?;
            if !line.starts_with("tried") {
                println!("{line}");
            }
            last = line;
        }
    }
    child.wait()?;
    Ok(last)
}
