//! How a run is made again: its run file, and the command with every option.

use crate::arguments::RunArguments;
use crate::files::asked::quoted;
use crate::files::run_file::{FORMAT, word};
use crate::program;
use codegen::model::Unit;
use serde_json::{Map, Value, json};
use sim_kernel::{Description, Input, Mechanism, Quantity, Start as Known};
use sim_runtime::{Rows, Settings, Start, Stepping};

/// How a run is made again.
pub(crate) struct Reproduction {
    /// The run file.
    pub(crate) file: Value,
    /// The command with every option.
    pub(crate) command: String,
}

/// What a run is given of its mechanism.
struct Given<'a> {
    description: &'static Description,
    /// Parameters and their defaults.
    values: &'a [f64],
    defaults: &'a [f64],
    inputs: &'a [Input<f64>],
    initial: Vec<(&'static str, String, bool)>,
}

impl Reproduction {
    /// Of a run as it was asked for, defaults and all.
    pub(crate) fn new<M: Mechanism>(
        mechanism: &M,
        start: &Start<M>,
        settings: &Settings,
        arguments: &RunArguments,
    ) -> Reproduction {
        let (values, defaults, inputs) =
            (mechanism.parameters(), mechanism.as_declared().parameters(), mechanism.inputs());
        let given = Given {
            description: mechanism.description(),
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
        let mut command = format!("{} run {}", program(), quoted(&arguments.model));
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
            "model": arguments.model,
            "parameters": object(&parameters),
            // What is declared follows the parameters, and the declaration tells it.
            "initial": object(&initial.into_iter().filter(|entry| entry.2).collect::<Vec<_>>()),
            "options": options,
        });
        if !inputs.is_empty() {
            file["inputs"] = object(&inputs).into();
        }
        Reproduction { file, command }
    }

    /// The run file as it is written.
    pub(crate) fn text(&self) -> String {
        format!("{:#}\n", self.file)
    }
}

/// What is given or guessed of the start, and whether the declaration says otherwise.
fn initial<M: Mechanism>(mechanism: &M, start: &Start<M>) -> Vec<(&'static str, String, bool)> {
    let declared = sim_runtime::declared_start(mechanism);
    let coordinates = mechanism.description().coordinates;
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
pub(crate) fn in_si(quantity: &Quantity, value: f64) -> String {
    let Ok(unit) = Unit::parse(quantity.unit) else { return format!("{value:?} {}", quantity.unit) };
    match unit.si_text().as_str() {
        "1" if quantity.factor == 1.0 => format!("{value:?}"),
        "1" if unit.is_of_angles() => format!("{value:?} rad"),
        "1" => format!("{value:?} [1]"),
        coherent => format!("{value:?} {coherent}"),
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
    if !arguments.written.columns.is_empty() {
        put("columns", arguments.written.columns.clone().into());
    }
    put("size", arguments.written.size.to_string().into());
    put("csv-comments", arguments.written.csv_comments.into());
    put("no-figures", arguments.written.no_figures.into());
    put("no-png", arguments.written.no_png.into());
    put("no-report", arguments.no_report.into());
    put("no-comparison", arguments.no_comparison.into());
    options
}
