//! Figures that tests and scripts print, each as `NAME: NUMBER`.

use super::Table;
use std::io;
use std::path::Path;
use std::process::Command;

/// A line that is printed, and the most that it may say.
pub(super) type Bounded = (&'static str, f64);

/// A line on tests that `cargo` runs and that print no figure.
pub(super) fn passes(table: &mut Table, what: &str, arguments: &str) {
    match output(Command::new("cargo").args(arguments.split(' '))) {
        Ok(_) => table.line(what, "passed", "passed", true),
        Err(why) => table.line(what, why, "passed", false),
    }
}

/// A line for each figure that a command prints, run in the workspace's folder.
pub(super) fn tell(table: &mut Table, command: &mut Command, lines: &[Bounded]) {
    let printed = output(command);
    for (name, bound) in lines {
        match &printed {
            Ok(text) => match figure(text, name) {
                Some(value) => table.at_most(name, value, *bound),
                None => table.line(name, "not printed", format!("at most {bound}"), false),
            },
            Err(why) => table.line(name, why, format!("at most {bound}"), false),
        }
    }
}

/// A line for the greatest of each figure that a test prints over many cases. They are taken in parts, each `cases` times `times`
/// in a process of its own: what is told of a mechanism stays in memory as long as a process does.
pub(super) fn tell_of_parts(table: &mut Table, test: &str, [parts, times, cases]: [usize; 3], lines: &[Bounded]) {
    let mut greatest = vec![0.0_f64; lines.len()];
    for part in 0..parts {
        let mut command = Command::new("cargo");
        let seed = part * times * cases;
        command
            .args(test.split(' '))
            .env("LINKWRIGHT_FUZZ", times.to_string())
            .env("LINKWRIGHT_SEED", seed.to_string());
        match output(&mut command) {
            Ok(text) => {
                for (greatest, (name, _)) in greatest.iter_mut().zip(lines) {
                    *greatest = greatest.max(figure(&text, name).unwrap_or(f64::INFINITY));
                }
            }
            Err(why) => {
                table.line(&format!("part {part}"), why, "passed", false);
                greatest.fill(f64::INFINITY);
            }
        }
    }
    greatest.into_iter().zip(lines).for_each(|(greatest, (name, bound))| table.at_most(name, greatest, *bound));
}

/// The number that a text gives a name.
pub(super) fn figure(text: &str, name: &str) -> Option<f64> {
    let after = |line: &str| line.split_once(&format!("{name}: "))?.1.split(' ').next()?.parse().ok();
    text.lines().find_map(after)
}

/// What a command prints if it succeeds.
pub(super) fn output(command: &mut Command) -> io::Result<String> {
    let workspace = Path::new(env!("CARGO_MANIFEST_DIR")).join("..");
    let output = command.current_dir(workspace).output()?;
    let text = |bytes: &[u8]| String::from_utf8_lossy(bytes).into_owned();
    match output.status.success() {
        true => Ok(text(&output.stdout)),
        false => Err(io::Error::other(format!("failed\n{}{}", text(&output.stdout), text(&output.stderr)))),
    }
}
