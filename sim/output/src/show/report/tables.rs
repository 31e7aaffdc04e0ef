//! Tables of a report: parameters, start, method and accuracy, events, constraints.

use super::html::{escaped, number, table, unit};
use crate::happening::{does, impulses};
use crate::outcome::{Happening, Outcome};
use serde_json::Value;
use sim_kernel::{Description, Quantity, Start};
use sim_runtime::SuddenChanges;

/// Events that are listed.
const MOST_EVENTS: usize = 24;

/// All tables of a run.
pub(super) fn tables(run: &Outcome, summary: &Value) -> String {
    let description = run.description;
    [
        parameters(description, &run.parameters, &run.defaults),
        start(run, description),
        method(summary),
        accuracy(run, summary),
        events(run, description),
        constraints(description),
        outputs(description),
    ]
    .concat()
}

fn named(q: &Quantity, value: f64, class: &str, more: &str) -> String {
    format!(
        "<tr{class}><th>{}</th><td class=\"number\">{}</td><td class=\"unit\">{}</td>{more}<td class=\"about\">{}</td></tr>",
        escaped(q.name),
        number(value / q.factor, 12),
        unit(q.unit),
        escaped(&q.docs.replace('\n', " "))
    )
}

pub(super) fn parameters(description: &Description, values: &[f64], defaults: &[f64]) -> String {
    let changed = values != defaults;
    let row = |(i, q): (usize, &Quantity)| {
        let class = if values[i] == defaults[i] { "" } else { " class=\"changed\"" };
        let default = number(defaults[i] / q.factor, 12);
        named(q, values[i], class, &format!("<td class=\"number about\">{default}</td>"))
    };
    let rows: Vec<String> = description.parameters.iter().enumerate().map(row).collect();
    let note = if changed { "• differs from the declared default" } else { "" };
    let head = [("", "name"), ("number", "value"), ("", ""), ("number", "default"), ("", "")];
    table("Parameters", &head, &rows, note)
}

fn start(run: &Outcome, description: &Description) -> String {
    let Some(first) = &run.start else { return String::new() };
    let mut rows = Vec::new();
    for (i, c) in description.coordinates.iter().enumerate() {
        let kind = match c.start {
            Start::Given => "given",
            Start::Guess => "guess",
            Start::Free => "free",
        };
        rows.push(started(&c.position, first.positions[i], kind));
    }
    for (i, c) in description.coordinates.iter().enumerate() {
        let kind = if c.speed_given { "given" } else { "free" };
        rows.push(started(&c.speed, first.speeds[i], kind));
    }
    let head = [("", "name"), ("number", "value"), ("", ""), ("", "in the declaration")];
    table("Start", &head, &rows, "")
}

fn started(q: &Quantity, value: f64, kind: &str) -> String {
    let docs = escaped(&q.docs.replace('\n', " "));
    let about = if docs.is_empty() { kind.to_owned() } else { format!("{kind}: {docs}") };
    format!(
        "<tr><th>{}</th><td class=\"number\">{}</td><td class=\"unit\">{}</td><td class=\"about\">{about}</td></tr>",
        escaped(q.name),
        number(value / q.factor, 10),
        unit(q.unit)
    )
}

/// The summary's entries about the method.
fn method(summary: &Value) -> String {
    let entries = summary["method"].as_object().into_iter().flatten();
    let rows: Vec<String> =
        entries.filter(|(_, value)| !value.is_null()).map(|(name, value)| pair(name, &told(value))).collect();
    let end = &summary["end"];
    let reached = |name: &str| end[name].as_f64().map(|time| format!("{} s", number(time, 12)));
    let times = [("end asked for", reached("asked")), ("end reached", reached("reached"))];
    let times = times.into_iter().filter_map(|(name, time)| Some(pair(name, &time?)));
    let samples = end["samples"].as_u64().map(|samples| pair("samples", &samples.to_string()));
    table("Method", &[], &rows.into_iter().chain(times).chain(samples).collect::<Vec<_>>(), "")
}

pub(super) fn pair(name: &str, value: &str) -> String {
    format!("<tr><th>{}</th><td>{}</td></tr>", escaped(&name.replace('_', " ")), escaped(value))
}

fn told(value: &Value) -> String {
    match value {
        Value::String(text) => text.clone(),
        Value::Number(n) => n.as_f64().filter(|_| !n.is_u64()).map_or(n.to_string(), |value| number(value, 12)),
        Value::Object(entries) => {
            entries.iter().map(|(name, value)| format!("{name} {}", told(value))).collect::<Vec<_>>().join(", ")
        }
        other => other.to_string(),
    }
}

fn accuracy(run: &Outcome, summary: &Value) -> String {
    let mut rows = Vec::new();
    let mut row = |name: &str, value: f64, about: &str| {
        let value = number(value, 2);
        rows.push(format!("<tr><th>{name}</th><td class=\"number\">{value}</td><td class=\"about\">{about}</td></tr>"));
    };
    if !run.description.constraints.is_empty() {
        row("position residual", run.position_residual, "largest |C| at any sample");
        row("velocity residual", run.velocity_residual, "largest |C<sub>q</sub> q′ + C<sub>t</sub>| at any sample");
    }
    row("energy balance", run.energy_balance, "largest change of kinetic energy minus work, relative");
    if run.energy_taken != 0.0 {
        row("impact loss", run.energy_taken, "J of kinetic energy that events have taken");
    }
    for passed in run.steps.singularities.iter().take(MOST_EVENTS) {
        let (name, time) = (escaped(passed.constraint), number(passed.time, 9));
        rows.push(format!(
            "<tr><th>singular position</th><td colspan=\"2\">{name} depends on other constraints at t = {time} s; passed straight through</td></tr>"
        ));
    }
    if let Some(SuddenChanges { steps, first, .. }) = run.steps.sudden_changes {
        rows.push(format!(
            "<tr><th>sudden changes</th><td colspan=\"2\">within {steps} of the equal steps, the first at t = {} s; what begins and ends within a step is not seen</td></tr>",
            number(first, 9)
        ));
    }
    if let Some(line) = run.corners() {
        rows.push(format!("<tr><th>corner</th><td colspan=\"2\">{line}</td></tr>"));
    }
    let undefined = summary["undefined_outputs"].as_object().into_iter().flatten();
    for (name, from) in undefined {
        let from = from["from"].as_f64().map_or(String::new(), |time| number(time, 6));
        rows.push(format!("<tr><th>{}</th><td colspan=\"2\">not finite from t = {from} s</td></tr>", escaped(name)));
    }
    table("Accuracy", &[], &rows, "")
}

fn events(run: &Outcome, description: &Description) -> String {
    let row = |event: &Happening| {
        let time = number(event.time, 12);
        let does = does(&description.events[event.event], description);
        let impulses = impulses(event, description).into_iter().map(|(name, value, impulse_unit)| {
            format!("; impulse of {name} {} {}", number(value, 6), unit(&impulse_unit))
        });
        format!(
            "<tr><th>{}</th><td class=\"number\">{time}</td><td class=\"unit\">s</td><td class=\"about\">{}{}</td></tr>",
            escaped(event.name),
            escaped(&does),
            impulses.collect::<String>()
        )
    };
    let rows: Vec<String> = run.events.iter().take(MOST_EVENTS).map(row).collect();
    let more = run.events.len().saturating_sub(MOST_EVENTS);
    let note = if more > 0 { format!("and {more} more, in summary.json") } else { String::new() };
    table("Events", &[], &rows, &note)
}

fn described(q: &Quantity) -> String {
    let (name, docs) = (escaped(q.name), escaped(&q.docs.replace('\n', " ")));
    format!("<tr><th>{name}</th><td class=\"unit\">{}</td><td class=\"about\">{docs}</td></tr>", unit(q.unit))
}

pub(super) fn constraints(description: &Description) -> String {
    let rows: Vec<String> = description.constraints.iter().map(described).collect();
    let head = [("", "name"), ("", "multiplier in"), ("", "")];
    table("Constraints", &head, &rows, "The reaction does the virtual work −λ δC on the mechanism.")
}

pub(super) fn outputs(description: &Description) -> String {
    let rows: Vec<String> = description.outputs.iter().map(described).collect();
    table("Outputs", &[("", "name"), ("", "unit"), ("", "")], &rows, "")
}
