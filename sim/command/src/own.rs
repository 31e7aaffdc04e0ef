//! Help and completions with the name and the mechanisms of the program that shows them.

use crate::Entry;
use crate::arguments::Arguments;
use clap::builder::PossibleValuesParser;
use clap::{Command, CommandFactory};

/// The program that examples are written for, with mechanisms that it has.
const WRITTEN_FOR: &str = "sim ";
const THEIRS: [&str; 6] = ["quick-return", "four-bar", "slider-crank", "cart-pole", "double-pendulum", "pendulum"];
/// Words of examples that only these mechanisms have.
const THEIR_OWN: [&str; 8] = ["O2A", "alpha", "x6", "phi", "--input", "--event", "--drive", "shorter"];

/// The command line of a program with these mechanisms.
pub(super) fn command(mechanisms: &[Entry], program: &str) -> Command {
    let command = Arguments::command().name("sim").bin_name(program.to_owned()).display_name(program.to_owned());
    let has = |name: &str| mechanisms.iter().any(|entry| entry.name() == name);
    if THEIRS.into_iter().all(has) {
        return command;
    }
    let model = mechanisms.first().map_or("MODEL", |entry| entry.name());
    let of_all = |text: &str| spoken(text, program, model, &format!("{program} run {model}"));
    let command = match command.get_after_help().map(ToString::to_string) {
        Some(text) => command.after_help(of_all(&text)),
        None => command,
    };
    command.mut_subcommands(|sub| match sub.get_after_help().map(ToString::to_string) {
        Some(text) => {
            let plain = format!("{program} {} {model}", sub.get_name());
            sub.after_help(spoken(&text, program, model, &plain))
        }
        None => sub,
    })
}

/// The same, with the names of all mechanisms in place of any.
pub(super) fn with_names(mechanisms: &[Entry], program: &str) -> Command {
    let names = || PossibleValuesParser::new(mechanisms.iter().map(|entry| entry.name()));
    command(mechanisms, program).mut_subcommands(|sub| {
        let has_model = sub.get_arguments().any(|argument| argument.get_id() == "model");
        if has_model { sub.mut_arg("model", |model| model.value_parser(names())) } else { sub }
    })
}

/// Help with the examples translated to this program and its mechanisms; `plain` if none is left.
fn spoken(text: &str, program: &str, model: &str, plain: &str) -> String {
    let mut lines: Vec<String> = Vec::new();
    let mut heading = None;
    for line in text.lines() {
        let Some(example) = line.trim_start().strip_prefix(WRITTEN_FOR) else {
            if line.starts_with("Example") {
                heading = Some(lines.len());
                lines.push("Examples:".to_owned());
            } else {
                lines.push(line.replace("`sim ", &format!("`{program} ")));
            }
            continue;
        };
        let theirs = THEIRS.into_iter().find(|name| example.contains(name)).unwrap_or(model);
        let own = format!("  {program} {}", example.replace(theirs, model));
        if !THEIR_OWN.iter().any(|word| example.contains(word)) && !lines.contains(&own) {
            lines.push(own);
        }
    }
    if let Some(at) = heading
        && !lines.get(at + 1).is_some_and(|line| line.starts_with(&format!("  {program} ")))
    {
        lines.insert(at + 1, format!("  {plain}"));
    }
    lines.join("\n")
}

#[cfg(test)]
mod tests {
    use super::spoken;

    #[test]
    fn examples_are_of_what_the_program_has() {
        let said = |text: &str| spoken(text, "arm", "robot", "arm plot robot");
        let text = "Examples, for a mechanism that `list` shows as quick-return:\n  sim list\n  sim run quick-return\n  \
                    sim run quick-return --set O2A=180mm\n  sim run four-bar\n\nWrites `sim run DIR/run.json`.";
        assert_eq!(said(text), "Examples:\n  arm list\n  arm run robot\n\nWrites `arm run DIR/run.json`.");
        assert_eq!(said("Example:\n  sim plot out/quick-return x6\n\nRows."), "Examples:\n  arm plot robot\n\nRows.");
    }
}
