//! Rows of verification, and the faults that make them fail.

use super::programs::{program, programs_are_built};
use crate::figures::Table;
use serde_json::Value;
use sim::verify::{Check, verify};
use sim::{Compiled, declared_start};
use std::process::Command;

/// The declarations of `found` whose motion cannot be followed to its end, and why.
const REFUSED: &[(&str, &str)] = &[("rhombus", "singular position"), ("bars-at-a-wall", "chatters")];

pub(super) fn measure(table: &mut Table) {
    table.heading("Verification");
    let mut failing = Vec::new();
    macro_rules! all {
        ($($model:ty),*) => { $(failing.extend(rows_that_fail(<$model>::default()));)* };
    }
    models::all_models!(all);
    failing.iter().for_each(|row| println!("{row}"));
    table.at_most("rows of shipped mechanisms that fail", failing.len() as f64, 0.0);
    let failing = declarations_that_fail();
    failing.iter().for_each(|words| println!("{words}"));
    table.at_most("declarations of `found` not verified rightly", failing.len() as f64, 0.0);
    table.elsewhere(
        "rows that a planted fault fails by 100 times the bound",
        "cargo test -p tests --test motion verification",
    );
}

/// Rows that fail, or why there are none.
fn rows_that_fail<M: Compiled>(mechanism: M) -> Vec<String> {
    let name = M::DESCRIPTION.name;
    match verify(mechanism, &declared_start(&mechanism), 2.0) {
        Ok(checks) => checks
            .iter()
            .filter(|check| !check.passes())
            .map(|Check { name: row, figure, bound, .. }| format!("{name}: {row} {figure:?} of {bound:e}"))
            .collect(),
        Err(error) => vec![format!("{name}: {error}")],
    }
}

/// The declarations of `found` that fail, unless it is said rightly why they are refused.
fn declarations_that_fail() -> Vec<String> {
    let run = |arguments: &[&str]| {
        let output = program("found").and_then(|found| Command::new(found).args(arguments).output());
        output.map_err(|error| error.to_string())
    };
    if !programs_are_built() {
        return vec!["`found` is not built".to_owned()];
    }
    let listed = run(&["list", "--json"]).map(|output| serde_json::from_slice::<Value>(&output.stdout));
    let Ok(Ok(Value::Array(listed))) = listed else { return vec!["`found list --json` gives no list".to_owned()] };
    let fails = |name: &str| {
        let output = match run(&["verify", name]) {
            Ok(output) => output,
            Err(error) => return Some(error),
        };
        let words = String::from_utf8_lossy(&output.stderr).into_owned();
        let is_right = match REFUSED.iter().find(|(refused, _)| *refused == name) {
            Some((_, why)) => !output.status.success() && words.contains(why),
            None => output.status.success(),
        };
        (!is_right).then(|| format!("{name}: {words}"))
    };
    listed.iter().filter_map(|entry| fails(entry["name"].as_str()?)).collect()
}
