//! What grows with coupled pairs: uncoupled free bodies, chains of free bodies.

use crate::figures::Table;
use std::process::Command;

/// Links of a chain, and how many right-hand sides in angles one of free bodies with its projection may cost.
const BOUNDS: [(&str, f64); 2] = [("20", 10.0), ("100", 25.0)];

pub(super) fn measure(table: &mut Table) {
    table.heading("Free bodies");
    match (said(&["400"]), said(&[])) {
        (Ok(uncoupled), Ok(chains)) => tell(table, &uncoupled, &chains),
        (Err(why), _) | (_, Err(why)) => table.line("memory, code and times", why, "measured", false),
    }
}

fn tell(table: &mut Table, uncoupled: &str, chains: &str) {
    let numbers = |line: &str| line.split(' ').map(|word| word.parse().unwrap_or(f64::NAN)).collect::<Vec<f64>>();
    let at = |numbers: &[f64], i: usize| numbers.get(i).copied().unwrap_or(f64::NAN);
    let sizes = numbers(uncoupled.trim());
    table.at_most("400 free bodies without coupling: MB of memory to derive", at(&sizes, 0) / 1e6, 300.0);
    table.at_most("400 free bodies without coupling: MB of code", at(&sizes, 1) / 1e6, 5.0);
    for (links, bound) in BOUNDS {
        let line = chains.lines().find(|line| line.split(' ').next() == Some(links)).unwrap_or_default();
        let (angles, free) = (at(&numbers(line), 1), at(&numbers(line), 2));
        println!("a chain of {links} links: {angles} ns in angles, {free} ns as free bodies, projected");
        table.at_most(&format!("the ratio for {links} links"), free / angles, bound);
    }
}

/// What the program that measures says.
fn said(arguments: &[&str]) -> std::io::Result<String> {
    let cargo = std::env::var_os("CARGO").unwrap_or_else(|| "cargo".into());
    let mut run = Command::new(cargo);
    run.args(["run", "--release", "--quiet", "-p", "tests", "--bin", "coupling", "--features", "tests/scale", "--"]);
    let output = run.args(arguments).output()?;
    match output.status.success() {
        true => Ok(String::from_utf8_lossy(&output.stdout).into_owned()),
        false => Err(std::io::Error::other(String::from_utf8_lossy(&output.stderr).into_owned())),
    }
}
