//! The command as it was asked for.

use crate::{program, words};
use std::ffi::OsString;
use std::path::Path;

/// The user's own words, but for those that say where to write and how much to tell: the same files come of it. Folders are named
/// by their last part, as curves of them are.
pub(crate) fn command() -> String {
    of_words(&program(), words().into_iter().skip(1))
}

/// The same of other words.
pub(crate) fn of_words(program: &str, words: impl Iterator<Item = OsString>) -> String {
    let mut command = program.to_owned();
    let mut is_place = false;
    for word in words {
        let text = word.to_string_lossy();
        match text.as_ref() {
            _ if is_place => is_place = false,
            "--out" => is_place = true,
            "--json" | "--quiet" | "-q" => {}
            text if text.starts_with("--out=") => {}
            text => command += &format!(" {}", quoted(short(text))),
        }
    }
    command
}

/// The last part of a path that is there.
fn short(word: &str) -> &str {
    let name = Path::new(word).file_name().and_then(|name| name.to_str());
    name.filter(|_| Path::new(word).exists()).unwrap_or(word)
}

/// A word as a shell takes it.
pub(crate) fn quoted(text: &str) -> String {
    let plain = |c: char| c.is_alphanumeric() || "._-+=,:/^%".contains(c);
    if text.chars().all(plain) { text.to_owned() } else { format!("'{}'", text.replace('\'', "'\\''")) }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn where_to_is_left_out() {
        let command = |words: &[&str]| of_words("sim", words.iter().map(OsString::from));
        assert_eq!(
            command(&["poincare", "pendulum", "--out", "a b", "--count", "3"]),
            "sim poincare pendulum --count 3"
        );
        assert_eq!(command(&["--json", "run", "m", "--out=x", "--set", "l=2 m", "-q"]), "sim run m --set 'l=2 m'");
        let folder = std::env::temp_dir();
        let name = folder.file_name().unwrap().to_str().unwrap();
        assert_eq!(command(&["plot", folder.to_str().unwrap(), "x/y"]), format!("sim plot {name} x/y"));
    }
}
