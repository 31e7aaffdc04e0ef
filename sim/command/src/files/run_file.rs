//! Run files: everything that `run` takes, as JSON. They are read as arguments of the command line, so that both mean
//! the same.

use crate::arguments::Arguments;
use crate::files::identity;
use crate::files::json;
use crate::{Stop, unknown};
use clap::CommandFactory;
use serde_json::{Map, Value};
use sim_kernel::Description;
use sim_runtime::{COMMIT, Method, VERSION};
use std::ffi::OsString;
use std::fs;
use std::path::Path;

/// What a run file says of itself, and what files said that can still be read: before version 2 they did not tell where they
/// come from.
pub(crate) const FORMAT: &str = "linkwright run 2";
const EARLIER: &str = "linkwright run 1";

/// Options about where to write, not what.
const NOT_OF_A_RUN: [&str; 8] = ["set", "initial", "input", "out", "json", "quiet", "help", "version"];

/// A run file that was read.
pub(crate) struct RunFile {
    path: String,
    file: Value,
}

impl RunFile {
    /// Reads a file.
    pub(crate) fn open(path: &str) -> Result<RunFile, Stop> {
        if Path::new(path).file_name().is_some_and(|name| name == "run.json") {
            identity::check(Path::new(path).parent().unwrap_or(Path::new("")))?;
        }
        let text =
            fs::read_to_string(path).map_err(|why| Stop::Usage(format!("cannot read the run file {path}: {why}")))?;
        let file = json::parse(&text).map_err(|why| Stop::Usage(format!("{path}: not JSON: {why}")))?;
        Ok(RunFile { path: path.to_owned(), file })
    }

    /// The equivalent command line, followed by the user's own arguments.
    pub(crate) fn expand(&self, words: &[OsString]) -> Result<Vec<OsString>, Stop> {
        let own: Vec<&OsString> = words.iter().skip(1).filter(|word| **word != *self.path).collect();
        let mentioned: Vec<String> = own.iter().map(|word| word.to_string_lossy().into_owned()).collect();
        let said = read(&self.file, &mentioned).map_err(|what| Stop::Usage(format!("{}: {what}", self.path)))?;
        let mut all: Vec<OsString> = words.first().cloned().into_iter().collect();
        all.push("run".into());
        all.extend(said.into_iter().map(OsString::from));
        let at = own.iter().position(|word| *word == "run");
        all.extend(own.into_iter().enumerate().filter(|(i, _)| Some(*i) != at).map(|(_, word)| word.clone()));
        Ok(all)
    }

    /// Its model, and the hash of the declaration with which it was written, where it says so.
    pub(crate) fn declaration(&self) -> Option<(&str, &str)> {
        Some((self.file.get("model")?.as_str()?, self.file.get("provenance")?.get("declaration")?.as_str()?))
    }

    /// What is to be known before it is run with a mechanism whose declaration is another.
    pub(crate) fn difference(&self, description: &Description) -> Option<String> {
        let (_, hash) = self.declaration().filter(|(_, hash)| *hash != description.declaration_hash)?;
        let said = |name: &str| self.file["provenance"].get(name).and_then(Value::as_str).unwrap_or("unknown");
        Some(format!(
            "{}: it was written with another declaration of `{}`, {hash} by Linkwright {}, commit {}; it is run with {} by \
             Linkwright {VERSION}, commit {COMMIT}",
            self.path,
            description.name,
            said("version"),
            said("commit"),
            description.declaration_hash,
        ))
    }

    /// A mistake in its arguments, with the path of the entry in question.
    pub(crate) fn blamed(&self, message: &str) -> String {
        let members = |entry: &'static str| {
            let object = self.file.get(entry).and_then(Value::as_object);
            object.into_iter().flat_map(Map::keys).map(move |name| (entry, name))
        };
        // How the command is used follows, with all of its options.
        let first = message.lines().next().unwrap_or_default();
        let is_about = |(entry, name): &(&str, &String)| *entry != "options" && first.starts_with(&format!("{name}:"));
        let mentions = |(entry, name): &(&str, &String)| match *entry {
            "options" => first.contains(&format!("--{name}")),
            _ => first.contains(&format!("`{name}`")),
        };
        let all = || ["parameters", "initial", "inputs", "options"].into_iter().flat_map(members);
        let found = all().find(is_about).or_else(|| all().find(mentions));
        let field = match found {
            Some((entry, name)) => format!("{entry}.{name}: "),
            None if message.contains("no model is called") => "model: ".to_owned(),
            None => String::new(),
        };
        format!("{}: {field}{message}", self.path)
    }
}

/// The arguments of a run file: the model, then options. The user's own steps and tolerances take precedence.
fn read(file: &Value, own: &[String]) -> Result<Vec<String>, String> {
    let file = file.as_object().ok_or_else(|| format!("a run file is an object, not {}", kind(file)))?;
    for key in file.keys() {
        let known = ["$schema", "run", "format", "model", "parameters", "initial", "inputs", "options", "provenance"];
        if !known.contains(&key.as_str()) {
            return Err(message(unknown("entry", key, known.into_iter())));
        }
    }
    if let Some(other) = file.get("format").filter(|format| ![FORMAT, EARLIER].iter().any(|known| *format == known)) {
        return Err(format!("format: it is {other}, but this program reads \"{FORMAT}\""));
    }
    if let Some(other) = file.get("provenance").filter(|provenance| !provenance.is_object()) {
        return Err(format!("provenance: an object is needed, not {}", kind(other)));
    }
    let model = match file.get("model") {
        Some(Value::String(model)) => model,
        Some(other) => return Err(format!("model: the name of a mechanism is needed, not {}", kind(other))),
        None => return Err("`model` is missing: the name of a mechanism".to_owned()),
    };
    let mut words = vec![model.to_owned()];
    for (entry, option) in [("parameters", "--set"), ("initial", "--initial"), ("inputs", "--input")] {
        for (name, value) in object(file, entry)? {
            let wrong = || format!("{entry}.{name}: a number, or text like \"180 mm\", is needed, not {}", kind(value));
            let value = Some(value).filter(|value| !value.is_array()).and_then(word);
            let value = value.filter(|word| !word.trim().is_empty()).ok_or_else(wrong)?;
            words.extend([option.to_owned(), format!("{name}={value}")]);
        }
    }
    let options = long_options();
    let steps = ["steps", "step", "rtol", "atol"];
    let takes_no_tolerance = has_equal_steps_method(own);
    let says_steps = own.iter().any(|word| steps.iter().any(|step| mentions(word, step)));
    for (name, value) in object(file, "options")? {
        let Some((_, takes_value)) = options.iter().find(|(known, _)| known == name) else {
            let known = options.iter().map(|(known, _)| known.as_str());
            return Err(message(unknown("option of a run file", name, known)));
        };
        if says_steps && steps.contains(&name.as_str()) || own.iter().any(|word| mentions(word, name)) {
            continue;
        }
        if takes_no_tolerance && ["rtol", "atol"].contains(&name.as_str()) {
            continue;
        }
        match (value, takes_value) {
            (Value::Bool(true), false) => words.push(format!("--{name}")),
            (Value::Bool(false), false) => {}
            (other, false) => return Err(format!("options.{name}: true or false is needed, not {}", kind(other))),
            (value, true) => {
                let wrong = || format!("options.{name}: a number or text is needed, not {}", kind(value));
                words.push(format!("--{name}={}", word(value).ok_or_else(wrong)?));
            }
        }
    }
    Ok(words)
}

/// Whether the user's own arguments select a method that does not choose its steps, so that the file's tolerances are
/// void.
fn has_equal_steps_method(own: &[String]) -> bool {
    let at = own.iter().rposition(|word| mentions(word, "method"));
    let name = at.and_then(|at| own[at].split_once('=').map(|(_, name)| name).or(own.get(at + 1).map(String::as_str)));
    Method::ALL.iter().any(|method| !method.is_adaptive() && Some(method.name()) == name)
}

/// The kind of a value.
fn kind(value: &Value) -> &'static str {
    match value {
        Value::Null => "null",
        Value::Bool(_) => "true or false",
        Value::Number(_) => "a number",
        Value::String(_) => "text",
        Value::Array(_) => "a list",
        Value::Object(_) => "an object",
    }
}

fn mentions(word: &str, option: &str) -> bool {
    word.strip_prefix("--").is_some_and(|rest| rest == option || rest.starts_with(&format!("{option}=")))
}

fn message(stop: Stop) -> String {
    match stop {
        Stop::Usage(message) => message,
        Stop::Failed(error) | Stop::Interrupted(error) => error.to_string(),
        Stop::Told => String::new(),
    }
}

fn object<'a>(file: &'a Map<String, Value>, entry: &str) -> Result<Vec<(&'a String, &'a Value)>, String> {
    match file.get(entry) {
        None => Ok(Vec::new()),
        Some(value) => value
            .as_object()
            .map(|o| o.iter().collect())
            .ok_or_else(|| format!("{entry}: an object is needed, not {}", kind(value))),
    }
}

/// A value as an argument of the command line.
pub(crate) fn word(value: &Value) -> Option<String> {
    match value {
        Value::String(text) => Some(text.clone()),
        Value::Number(number) => Some(number.to_string()),
        Value::Array(items) => items.iter().map(word).collect::<Option<Vec<_>>>().map(|items| items.join(",")),
        _ => None,
    }
}

/// The possible `options` of a run file: the long options of `run`, except those that have entries of their own; with
/// whether they take a value.
fn long_options() -> Vec<(String, bool)> {
    let command = Arguments::command();
    let run = command.find_subcommand("run");
    let options = run.into_iter().flat_map(clap::Command::get_arguments);
    let named = options.filter_map(|option| Some((option.get_long()?.to_owned(), option.get_action().takes_values())));
    named.filter(|(name, _)| !NOT_OF_A_RUN.contains(&name.as_str())).collect()
}

/// The schema of run files.
pub(crate) const SCHEMA: &str = include_str!("../../assets/run.schema.json");

#[cfg(test)]
mod tests {
    use super::*;
    use serde_json::json;

    /// The schema names the options of `run`, all of them and no others.
    #[test]
    fn the_schema_is_that_of_the_command_line() {
        let schema: Value = serde_json::from_str(SCHEMA).unwrap();
        let options = schema["properties"]["options"]["properties"].as_object().unwrap();
        let mut described: Vec<&String> = options.keys().collect();
        let options_of_run = long_options();
        let mut known: Vec<&String> = options_of_run.iter().map(|(name, _)| name).collect();
        described.sort();
        known.sort();
        assert_eq!(described, known);
        assert_eq!(schema["properties"]["format"]["enum"], json!([EARLIER, FORMAT]));
    }

    #[test]
    fn files_are_words() {
        let file = json!({
            "model": "m", "parameters": { "a": "180 mm", "b": 2 }, "initial": { "x": -1.5 },
            "options": { "t-end": "3 s", "rtol": 1e-9, "no-figures": true, "no-report": false, "format": ["csv", "npz"] },
        });
        let words = read(&file, &[]).unwrap().join(" ");
        assert_eq!(
            words,
            "m --set a=180 mm --set b=2 --initial x=-1.5 --t-end=3 s --rtol=1e-9 --no-figures --format=csv,npz"
        );
        let own = read(&file, &["--steps".to_owned(), "--t-end=4".to_owned()]).unwrap().join(" ");
        assert!(!own.contains("rtol") && !own.contains("t-end"), "{own}");
    }

    #[test]
    fn mistakes_say_what_is_known() {
        let fails = |file: Value| read(&file, &[]).unwrap_err();
        assert!(fails(json!([])).contains("an object"));
        assert!(fails(json!({ "parameters": {} })).contains("`model` is missing"));
        assert!(fails(json!({ "model": "m", "parameter": {} })).contains("did you mean `parameters`?"));
        assert!(fails(json!({ "model": "m", "options": { "tend": "1 s" } })).contains("did you mean `t-end`?"));
        assert!(fails(json!({ "model": "m", "format": "other 2" })).contains(FORMAT));
        assert!(fails(json!({ "model": "m", "parameters": { "a": null } })).contains("180 mm"));
    }
}
