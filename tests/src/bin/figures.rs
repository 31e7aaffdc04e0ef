//! Prints the figures of an area, each beside its bound: `cargo run --release -p tests --bin figures -- AREA`, or of one
//! of its subjects alone: `AREA SUBJECT`.

#[path = "../figures/mod.rs"]
mod figures;

use figures::{AREAS, Table};
use std::process::ExitCode;

fn main() -> ExitCode {
    let arguments: Vec<String> = std::env::args().skip(1).collect();
    let (wanted, subject) = match arguments.as_slice() {
        [area] => (area, None),
        [area, subject] => (area, Some(subject)),
        _ => return usage("Say which area."),
    };
    let Some(area) = AREAS.iter().find(|area| area.name == wanted) else {
        return usage(&format!("There is no area `{wanted}`."));
    };
    let is_wanted = |name: &str| subject.is_none_or(|subject| subject == name);
    if let (Some(subject), false) = (subject, area.subjects.iter().any(|(name, _)| is_wanted(name))) {
        return usage(&format!("`{wanted}` has no subject `{subject}`."));
    }
    println!("{}: {}", area.name, area.about);
    let mut table = Table::default();
    area.subjects.iter().filter(|(name, _)| is_wanted(name)).for_each(|(_, measure)| measure(&mut table));
    if table.conclude() { ExitCode::SUCCESS } else { ExitCode::FAILURE }
}

/// What can be asked for; exit status 2, as of every command that is not understood.
fn usage(why: &str) -> ExitCode {
    eprintln!("{why} Areas are:");
    for area in AREAS {
        let subjects: Vec<&str> = area.subjects.iter().map(|(name, _)| *name).collect();
        eprintln!("  {:<10} {}: {}", area.name, area.about, subjects.join(", "));
    }
    ExitCode::from(2)
}
