//! Prints the figures of an area, each beside its bound: `cargo run --release -p tests --bin figures -- AREA`.

#[path = "../figures/mod.rs"]
mod figures;

use figures::{AREAS, Table};
use std::process::ExitCode;

fn main() -> ExitCode {
    let arguments: Vec<String> = std::env::args().skip(1).collect();
    let [wanted] = arguments.as_slice() else { return usage("Say which area.") };
    let Some(area) = AREAS.iter().find(|area| area.name == wanted) else {
        return usage(&format!("There is no area `{wanted}`."));
    };
    println!("{}: {}", area.name, area.about);
    let Some(measure) = area.measure else { return ExitCode::SUCCESS };
    let mut table = Table::default();
    measure(&mut table);
    if table.conclude() { ExitCode::SUCCESS } else { ExitCode::FAILURE }
}

/// What can be asked for; exit status 2, as of every command that is not understood.
fn usage(why: &str) -> ExitCode {
    eprintln!("{why} Areas are:");
    AREAS.iter().for_each(|area| eprintln!("  {:<10} {}", area.name, area.about));
    ExitCode::from(2)
}
