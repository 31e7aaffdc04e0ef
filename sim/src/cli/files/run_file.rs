//! Run files: everything that `run` takes, as JSON. They are read as arguments of the command line, so that both mean
//! the same.

use crate::Start;
use crate::cli::arguments::{Arguments, RunArguments};
use crate::cli::files::identity;
use crate::cli::files::json;
use crate::cli::{Stop, program, unknown};
use crate::state::settings::{Method, Rows, Settings, Stepping};
use clap::CommandFactory;
use codegen::model::Unit;
use serde_json::{Map, Value, json};
use sim_kernel::{Description, Input, Mechanism, Quantity, Start as Known};
use std::ffi::OsString;
use std::fs;
use std::path::Path;

/// The format of run files.
const FORMAT: &str = "linkwright run 1";

/// Options about where to write, not what.
const NOT_OF_A_RUN: [&str; 8] = ["set", "initial", "input", "out", "json", "quiet", "help", "version"];

/// How a run is repeated.
pub(in crate::cli) struct Reproduction {
    /// The run file.
    pub(in crate::cli) file: Value,
    /// The command with every option.
    pub(in crate::cli) command: String,
}

/// The mechanism's values in a run.
struct Given<'a> {
    description: &'static Description,
    /// Parameters and their defaults.
    values: &'a [f64],
    defaults: &'a [f64],
    inputs: &'a [Input<f64>],
    initial: Vec<(&'static str, String, bool)>,
}

impl Reproduction {
    /// The run file of a run as requested, with all defaults.
    pub(in crate::cli) fn new<M: Mechanism>(
        mechanism: &M,
        start: &Start<M>,
        settings: &Settings,
        arguments: &RunArguments,
    ) -> Reproduction {
        let (values, defaults, inputs) = (mechanism.parameters(), M::defaults().parameters(), mechanism.inputs());
        let given = Given {
            description: const { &M::DESCRIPTION },
            values: values.as_ref(),
            defaults: defaults.as_ref(),
            inputs: inputs.as_ref(),
            initial: initial(mechanism, start),
        };
        Reproduction::of(given, settings, arguments)
    }

    fn of(given: Given, settings: &Settings, arguments: &RunArguments) -> Reproduction {
        let Given { description, values, defaults, inputs, initial } = given;
        let parameters: Vec<(&str, String, bool)> = description
            .parameters
            .iter()
            .enumerate()
            .map(|(i, p)| (p.name, in_si(p, values[i]), values[i] != defaults[i]))
            .collect();
        let inputs: Vec<(&str, String, bool)> = description
            .inputs
            .iter()
            .zip(inputs)
            .filter_map(|(quantity, input)| Some((quantity.name, in_si(quantity, input.held()?), true)))
            .collect();
        let options = options(settings, arguments, description.events);
        let mut command = format!("{} run {}", program(), description.name);
        for (name, value, _) in parameters.iter().filter(|entry| entry.2) {
            command += &format!(" --set {}", quoted(&format!("{name}={value}")));
        }
        for (name, value, _) in initial.iter().filter(|entry| entry.2) {
            command += &format!(" --initial {}", quoted(&format!("{name}={value}")));
        }
        for (name, value, _) in &inputs {
            command += &format!(" --input {}", quoted(&format!("{name}={value}")));
        }
        for (name, value) in &options {
            command += &match value {
                Value::Bool(true) => format!(" --{name}"),
                Value::Bool(false) => String::new(),
                value => format!(" --{name} {}", quoted(&word(value).unwrap_or_default())),
            };
        }
        let object = |entries: &[(&str, String, bool)]| {
            let entries = entries.iter().map(|(name, value, _)| ((*name).to_owned(), Value::from(value.as_str())));
            entries.collect::<Map<String, Value>>()
        };
        let mut file = json!({
            "format": FORMAT,
            "model": description.name,
            "parameters": object(&parameters),
            "initial": object(&initial),
            "options": options,
        });
        if !inputs.is_empty() {
            file["inputs"] = object(&inputs).into();
        }
        Reproduction { file, command }
    }

    /// The run file as it is written.
    pub(in crate::cli) fn text(&self) -> String {
        format!("{:#}\n", self.file)
    }
}

/// The given and guessed start values, and whether the declaration differs.
fn initial<M: Mechanism>(mechanism: &M, start: &Start<M>) -> Vec<(&'static str, String, bool)> {
    let declared = crate::declared_start(mechanism);
    let coordinates = M::DESCRIPTION.coordinates;
    let mut entries = Vec::new();
    for (i, c) in coordinates.iter().enumerate() {
        if start.position_given[i] || c.start == Known::Guess {
            let differs =
                start.positions[i] != declared.positions[i] || start.position_given[i] != declared.position_given[i];
            entries.push((c.position.name, in_si(&c.position, start.positions[i]), differs));
        }
    }
    for (i, c) in coordinates.iter().enumerate() {
        if start.speed_given[i] {
            let differs = start.speeds[i] != declared.speeds[i] || !declared.speed_given[i];
            entries.push((c.speed.name, in_si(&c.speed, start.speeds[i]), differs));
        }
    }
    entries
}

/// A value in the coherent SI unit, so that it reads back as the same number.
fn in_si(quantity: &Quantity, value: f64) -> String {
    let unit = Unit::parse(quantity.unit).map_or_else(|_| quantity.unit.to_owned(), |unit| unit.si_text());
    match unit.as_str() {
        // Degrees have the dimension 1; their coherent unit is the radian.
        "1" if quantity.factor != 1.0 => format!("{value:?} rad"),
        "1" => format!("{value:?}"),
        unit => format!("{value:?} {unit}"),
    }
}

/// The options of a run by their long names.
fn options(settings: &Settings, arguments: &RunArguments, events: &[sim_kernel::event::Event]) -> Map<String, Value> {
    let mut options = Map::new();
    let mut put = |name: &str, value: Value| options.insert(name.to_owned(), value);
    put("t-end", format!("{:?} s", settings.end).into());
    put("method", settings.method.name().into());
    match settings.stepping {
        Stepping::Equal(steps) => put("steps", steps.into()),
        Stepping::Adaptive(tolerance) => {
            put("rtol", tolerance.relative.into());
            put("atol", tolerance.absolute.into())
        }
    };
    put("projection", settings.stabilisation.to_string().into());
    put(
        "rows",
        match settings.rows {
            Rows::Steps => "steps".into(),
            Rows::Even(rows) => rows.into(),
        },
    );
    if let Some((stop, name)) = settings.stop.and_then(|stop| Some((stop, events.get(stop.event)?.name))) {
        put("until", format!("{name}:{}", stop.occurrence).into());
    }
    put("format", arguments.written.format.iter().map(|format| format.name()).collect::<Vec<_>>().into());
    put("size", arguments.written.size.to_string().into());
    put("no-figures", arguments.written.no_figures.into());
    put("no-report", arguments.no_report.into());
    options
}

fn quoted(text: &str) -> String {
    let plain = |c: char| c.is_alphanumeric() || "._-+=,:/^%".contains(c);
    if text.chars().all(plain) { text.to_owned() } else { format!("'{}'", text.replace('\'', "'\\''")) }
}

/// A run file that was read.
pub(in crate::cli) struct RunFile {
    path: String,
    file: Value,
}

impl RunFile {
    /// Reads a file.
    pub(in crate::cli) fn open(path: &str) -> Result<RunFile, Stop> {
        if Path::new(path).file_name().is_some_and(|name| name == "run.json") {
            identity::check(Path::new(path).parent().unwrap_or(Path::new("")))?;
        }
        let text =
            fs::read_to_string(path).map_err(|why| Stop::Usage(format!("cannot read the run file {path}: {why}")))?;
        let file = json::parse(&text).map_err(|why| Stop::Usage(format!("{path}: not JSON: {why}")))?;
        Ok(RunFile { path: path.to_owned(), file })
    }

    /// The equivalent command line, followed by the user's own arguments.
    pub(in crate::cli) fn expand(&self, words: &[OsString]) -> Result<Vec<OsString>, Stop> {
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

    /// A mistake in its arguments, with the path of the entry in question.
    pub(in crate::cli) fn blamed(&self, message: &str) -> String {
        let members = |entry: &'static str| {
            let object = self.file.get(entry).and_then(Value::as_object);
            object.into_iter().flat_map(Map::keys).map(move |name| (entry, name))
        };
        let speaks_of = |(entry, name): &(&str, &String)| match *entry {
            "options" => message.contains(&format!("--{name}")),
            _ => message.contains(&format!("`{name}`")) || message.starts_with(&format!("{name}:")),
        };
        let found = ["parameters", "initial", "inputs", "options"].into_iter().flat_map(members).find(speaks_of);
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
        let known = ["$schema", "run", "format", "model", "parameters", "initial", "inputs", "options"];
        if !known.contains(&key.as_str()) {
            return Err(message(unknown("entry", key, known.into_iter())));
        }
    }
    if let Some(other) = file.get("format").filter(|format| *format != FORMAT) {
        return Err(format!("format: it is {other}, but this program reads \"{FORMAT}\""));
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
fn word(value: &Value) -> Option<String> {
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
pub(in crate::cli) const SCHEMA: &str = include_str!("../../../assets/run.schema.json");

#[cfg(test)]
mod tests {
    use super::*;

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
        assert_eq!(schema["properties"]["format"]["const"], FORMAT);
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
