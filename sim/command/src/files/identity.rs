//! Which files belong to one run.
//!
//! A run's name is the digest of its table and of what its run file and summary say, so the same run has the same name.
//! JSON files bear the name and may be edited. Tables and pictures have no place for a name that every reader accepts,
//! so the summary, which is moved last, lists the digests of all other files.

use crate::Stop;
use crate::files::json;
use serde_json::Value;
use sim_runtime::{Digest, Provenance, Table};
use std::fs::File;
use std::io::{self, Read};
use std::path::Path;

/// The member that names the run.
pub(crate) const RUN: &str = "run";
/// Files that name it themselves, so that they may be edited.
pub(crate) const NAMED: [&str; 3] = [SUMMARY, "run.json", "timing.json"];
const SUMMARY: &str = "summary.json";

/// Opens a regular file; devices may have no end.
fn open(path: &Path) -> io::Result<File> {
    match path.metadata()?.is_file() {
        true => File::open(path),
        false => Err(io::ErrorKind::InvalidInput.into()),
    }
}

/// The digest of a file.
pub(crate) fn digest(path: &Path) -> io::Result<String> {
    let (mut digest, mut file, mut part) = (Digest::default(), open(path)?, vec![0; 1 << 16]);
    loop {
        match file.read(&mut part)? {
            0 => return Ok(digest.text()),
            length => digest.add(&part[..length]),
        }
    }
}

/// The member that says where a file comes from.
pub(crate) const PROVENANCE: &str = "provenance";

/// What a run is known by: the digest of its table and of what else it was and found, whoever has found it.
pub(crate) fn of_run(table: &Table, values: &[&Value]) -> String {
    let mut digest = Digest::default();
    for column in &table.columns {
        digest.add(column.header().as_bytes());
        column.values.iter().for_each(|value| digest.add(&value.to_bits().to_le_bytes()));
    }
    for value in values {
        let mut value = (*value).clone();
        value.as_object_mut().and_then(|members| members.shift_remove(PROVENANCE));
        digest.add(value.to_string().as_bytes());
    }
    digest.text()
}

/// The files of the run whose summary is in a folder.
pub(crate) fn listed(directory: &Path) -> Vec<String> {
    let summary = read(&directory.join(SUMMARY));
    let names = summary.as_ref().and_then(digests).into_iter().flatten().map(|(name, _)| name.clone());
    let is_name = |name: &String| Path::new(name).file_name().is_some_and(|file| file == name.as_str());
    names.filter(is_name).chain(NAMED.map(String::from)).collect()
}

fn digests(summary: &Value) -> Option<&serde_json::Map<String, Value>> {
    summary.get("digests")?.as_object()
}

fn read(path: &Path) -> Option<Value> {
    json::parse(&io::read_to_string(open(path).ok()?).ok()?).ok()
}

/// Where the files of a folder come from, as its summary says.
pub(crate) fn provenance(directory: &Path) -> Provenance {
    let summary = read(&directory.join(SUMMARY));
    let text = |name: &str| {
        let member = summary.as_ref()?.get(PROVENANCE)?.get(name)?;
        member.as_str().map(str::to_owned)
    };
    let [model, declaration, command, run] = ["model", "declaration", "command", "run"].map(text);
    Provenance { model, declaration, command, run }
}

/// Refuses a folder whose files are not all of one run, for example after a run was killed while moving its files.
pub(crate) fn check(directory: &Path) -> Result<(), Stop> {
    match stranger(directory) {
        None => Ok(()),
        Some((one, other)) => Err(Stop::Failed(anyhow::anyhow!(
            "the files in {} are not of one run: {one} does not belong to {other}. Run it again into this folder, or copy the \
             file that you mean to another",
            directory.display()
        ))),
    }
}

/// A file that does not belong to the run of another.
fn stranger(directory: &Path) -> Option<(String, &'static str)> {
    let mut named = NAMED.into_iter().filter(|name| directory.join(name).is_file());
    let first = named.next()?;
    let told = read(&directory.join(first));
    let run = |value: &Option<Value>| value.as_ref().and_then(|value| value.get(RUN).cloned());
    if let Some(other) = named.find(|name| run(&read(&directory.join(name))) != run(&told)) {
        return Some((other.to_owned(), first));
    }
    let digests = digests(told.as_ref().filter(|_| first == SUMMARY)?)?;
    let differs = |name: &String, known: &Value| digest(&directory.join(name)).is_ok_and(|found| *known != *found);
    let changed = digests.iter().find(|(name, known)| differs(name, known)).map(|(name, _)| name.clone());
    let tables = sim_output::Format::ALL.iter().map(|format| format!("trajectory.{}", format.name()));
    let added = || tables.into_iter().find(|name| !digests.contains_key(name) && directory.join(name).is_file());
    changed.or_else(added).map(|name| (name, first))
}

#[cfg(test)]
mod tests {
    use super::*;
    use serde_json::json;

    /// A run by another commit or command that found the same is the same run.
    #[test]
    fn a_run_is_known_by_what_it_found() {
        let table = Table::from_columns(Vec::new());
        let of = |value: Value| of_run(&table, &[&value]);
        let found = of(json!({ "period": 1.0 }));
        assert_eq!(of(json!({ "period": 1.0, "provenance": { "commit": "0123456789ab" } })), found);
        assert_ne!(of(json!({ "period": 2.0 })), found);
    }
}
