//! The origin of a file: the program that wrote it, the declaration, the options, and the run. It contains no time of day, so
//! the same run gives the same bytes.
//!
//! A table carries its origin to every file made of it. Formats without a place for it keep their bytes plain: `#` lines stop the
//! default readers of CSV, a row of another shape those of JSON lines, and numpy allows no other key in the header of `.npy`.
//! There `summary.json` names it, with the digest of each file. The commit is found by the build scripts of `sim` and `codegen`,
//! in one text that stands twice, since a package may not reach outside its folder.

use serde_json::{Map, Value};
use sim_kernel::Description;

/// The program.
const PROGRAM: &str = "Linkwright";
/// The version of this library.
pub const VERSION: &str = env!("CARGO_PKG_VERSION");
/// The commit that this library was built from: twelve digits, with `-dirty` where its sources differed from the commit; or what
/// the variable LINKWRIGHT_COMMIT said where it was built; or `unknown`.
pub const COMMIT: &str = env!("LINKWRIGHT_COMMIT");

/// Where a file comes from; version and commit of the program are known by themselves.
#[derive(Clone, Debug, Default, PartialEq, Eq)]
pub struct Provenance {
    /// The mechanism's name.
    pub model: Option<String>,
    /// The hash of its declaration.
    pub declaration: Option<String>,
    /// The command with the options that made it.
    pub command: Option<String>,
    /// What all files of a run bear.
    pub run: Option<String>,
}

impl Provenance {
    /// That of a file on a mechanism.
    pub fn of(description: &Description) -> Provenance {
        let [model, declaration] = [description.name, description.declaration_hash].map(|text| Some(text.to_owned()));
        Provenance { model, declaration, ..Provenance::default() }
    }

    /// The program with its version and commit, in words.
    pub fn program() -> String {
        format!("{PROGRAM} {VERSION}, commit {COMMIT}")
    }

    /// All of it by name; what is not known is left out.
    pub fn to_json(&self) -> Value {
        let program = [("program", PROGRAM), ("version", VERSION), ("commit", COMMIT)];
        let all = program.into_iter().chain(self.known());
        all.map(|(name, text)| (name.to_owned(), Value::from(text))).collect::<Map<_, _>>().into()
    }

    /// The same in lines, for comments.
    pub fn lines(&self) -> Vec<String> {
        // One line each, whatever a name or a path has in it.
        let line = |(name, text): (&str, &str)| format!("{name}: {}", text.replace(['\n', '\r'], " "));
        [Provenance::program()].into_iter().chain(self.known().map(line)).collect()
    }

    fn known(&self) -> impl Iterator<Item = (&'static str, &str)> {
        let all = [
            ("model", &self.model),
            ("declaration", &self.declaration),
            ("command", &self.command),
            ("run", &self.run),
        ];
        all.into_iter().filter_map(|(name, text)| Some((name, text.as_deref()?)))
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn what_is_not_known_is_left_out() {
        let nothing = Provenance::default();
        assert_eq!(nothing.to_json(), serde_json::json!({ "program": PROGRAM, "version": VERSION, "commit": COMMIT }));
        assert_eq!(nothing.lines(), [format!("Linkwright {VERSION}, commit {COMMIT}")]);
        let plotted = Provenance { command: Some("sim plot a\nb".into()), ..Provenance::default() };
        assert_eq!(plotted.to_json()["command"], "sim plot a\nb");
        assert_eq!(plotted.lines()[1..], ["command: sim plot a b"]);
    }

    /// The build script has found one, or says that there is none.
    #[test]
    fn a_commit_is_twelve_digits() {
        let digits = COMMIT.trim_end_matches("-dirty");
        let is_commit = digits.len() >= 12 && digits.chars().all(|digit| digit.is_ascii_hexdigit());
        assert!(is_commit || std::env::var_os("LINKWRIGHT_COMMIT").is_some() || COMMIT == "unknown", "{COMMIT}");
    }
}
