//! The mechanism that a word of the command line names: one of the program's own, or one of a file.

use crate::Stop;
use crate::entry::{Entry, RunCommand, find};
use crate::tell::tell;
use sim_runtime::{DeclarationFile, Model};
use std::path::{Path, PathBuf};
use std::sync::Arc;

/// A mechanism to work on.
pub(super) struct Chosen {
    pub(super) model: Arc<dyn Model>,
    /// Its runs by step loops of its own, if it has them.
    pub(super) run: Option<RunCommand>,
}

/// The mechanism of this name, or of this file. What a robot's file lacks is told, unless all is to be quiet.
pub(super) fn chosen(mechanisms: &[Entry], word: &str, quiet: bool) -> Result<Chosen, Stop> {
    match (file(word), find(mechanisms, word)) {
        (Some((path, name)), _) => declared(&path, name, quiet),
        (None, Ok(entry)) => Ok(Chosen { model: entry.model()?, run: entry.run }),
        (None, Err(unknown)) => match any_file(word) {
            Some((path, name)) => declared(&path, name, quiet),
            None => Err(unknown),
        },
    }
}

fn declared(path: &Path, name: Option<&str>, quiet: bool) -> Result<Chosen, Stop> {
    let file = DeclarationFile::read(path)?;
    let model = file.model(name)?;
    if !quiet {
        warn(&file.warnings());
    }
    Ok(Chosen { model, run: None })
}

/// Tells what is doubtful.
pub(super) fn warn(warnings: &[String]) {
    warnings.iter().for_each(|warning| tell!("warning: {warning}"));
}

/// `FILE` or `FILE:Name`, where the word is a file's: it ends in `.mech`, `.rs` or `.urdf`, or has a separator in it.
pub(super) fn file(word: &str) -> Option<(PathBuf, Option<&str>)> {
    let is_file = |path: &str| {
        let extension = Path::new(path).extension();
        extension.is_some_and(|extension| ["mech", "rs", "urdf"].iter().any(|known| extension == *known))
            || path.contains(std::path::is_separator)
    };
    let is_name = |name: &str| !name.is_empty() && name.chars().all(|c| c.is_alphanumeric() || c == '_' || c == '-');
    match word.rsplit_once(':') {
        Some((path, name)) if is_file(path) && is_name(name) => Some((path.into(), Some(name))),
        _ => is_file(word).then(|| (word.into(), None)),
    }
}

/// As [`file`], or a file of any other name that is there.
pub(super) fn any_file(word: &str) -> Option<(PathBuf, Option<&str>)> {
    file(word).or_else(|| Path::new(word).is_file().then(|| (word.into(), None)))
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn files_are_told_from_names() {
        for name in ["four-bar", "four.bar", "mech", "four-bar:FourBar"] {
            assert_eq!(file(name), None, "{name}");
        }
        let of = |word| file(word).unwrap();
        assert_eq!(of("a.mech"), ("a.mech".into(), None));
        assert_eq!(of("a.urdf"), ("a.urdf".into(), None));
        assert_eq!(of("a.rs:FourBar"), ("a.rs".into(), Some("FourBar")));
        assert_eq!(of("some/four-bar"), ("some/four-bar".into(), None));
        assert_eq!(of("some/four-bar:four-bar"), ("some/four-bar".into(), Some("four-bar")));
        assert_eq!(of("some:where/a.mech"), ("some:where/a.mech".into(), None));
    }
}
