//! `sim info`.

use super::base_parameters::{BaseParameters, base_parameters};
use super::tree::{Link, tree};
use crate::arguments::Voice;
use crate::said::{counted, short};
use crate::settings::SettingsArguments;
use crate::{Stop, print};
use codegen::dsl::Activity;
use codegen::program::Kernel;
use serde_json::{Value, json};
use sim_kernel::event::Event;
use sim_kernel::{Array, Coordinate, Description, Mechanism, Quantity, Start};
use sim_output::happening;
use sim_runtime::{Mobility, assemble, declared_start, mobility};

/// The facts about a mechanism.
struct Facts {
    description: &'static Description,
    /// Defaults of the parameters, in SI units.
    defaults: Vec<f64>,
    /// Declared positions and speeds, in SI units.
    start: Vec<(f64, f64)>,
    /// Degrees of freedom and redundant constraints at the assembled start, or why there is none.
    mobility: Result<Mobility, String>,
    /// The tree of bodies in space, if they are one.
    tree: Vec<Link>,
    /// The inertial parameters that its motion tells apart, if it is a tree of bodies in space.
    base_parameters: Vec<BaseParameters>,
    /// Each kernel with the number of its operations, and of which kinds they are.
    kernels: Vec<(String, usize, String)>,
}

fn facts<M: Mechanism>(mechanism: &M) -> Facts {
    let start = declared_start(mechanism);
    let assembled = assemble(mechanism, &start).map_err(|failure| failure.to_string());
    let (description, defaults) = (mechanism.description(), mechanism.parameters().iter().copied().collect::<Vec<_>>());
    let derived = description.declaration.parse().ok().and_then(|tokens| codegen::derive(tokens).ok());
    let kernel =
        |kernel: &Kernel| (kernel.id.name().to_owned(), kernel.operations.total(), kernel.operations.to_string());
    Facts {
        description,
        tree: derived.as_ref().map_or(vec![], |derived| tree(&derived.equations, &defaults)),
        base_parameters: derived.as_ref().map_or(vec![], |derived| base_parameters(&derived.equations, &defaults)),
        kernels: derived.map_or(vec![], |derived| derived.program.kernels.iter().map(kernel).collect()),
        defaults,
        start: start.positions.iter().copied().zip(start.speeds.iter().copied()).collect(),
        mobility: assembled.map(|state| mobility(mechanism, state.time, &state.positions)),
    }
}

/// Prints the facts about a mechanism.
pub(crate) fn info_command<M: Mechanism>(mechanism: M, voice: Voice) -> Result<(), Stop> {
    let facts = facts(&mechanism);
    match voice.json {
        true => print(&format!("{:#}\n", as_json(&facts))),
        false => print(&as_text(&facts)),
    }
}

fn as_json(facts: &Facts) -> Value {
    let d = facts.description;
    let quantity = |q: &Quantity| json!({ "name": q.name, "unit": q.unit, "docs": q.docs });
    let valued =
        |q: &Quantity, si: f64| json!({ "name": q.name, "unit": q.unit, "default": si / q.factor, "docs": q.docs });
    let coordinates = d.coordinates.iter().zip(&facts.start).map(|(c, (position, speed))| {
        json!({
            "name": c.position.name, "unit": c.position.unit, "docs": c.position.docs,
            "start": position / c.position.factor, "start_is": told(c.start),
            "speed": c.speed.name, "speed_unit": c.speed.unit,
            "start_speed": c.speed_given.then_some(speed / c.speed.factor),
        })
    });
    let kernels = facts.kernels.iter();
    let kernels = kernels.map(|(name, total, text)| json!({ "name": name, "operations": total, "of": text }));
    json!({
        "name": d.name,
        "type": d.type_name,
        "docs": d.docs,
        "declaration_hash": d.declaration_hash,
        "degrees_of_freedom": facts.mobility.as_ref().ok().map(|mobility| mobility.degrees_of_freedom),
        "configuration_freedom": facts.mobility.as_ref().ok().map(|mobility| mobility.configuration_freedom),
        "redundant_constraints": facts.mobility.as_ref().map_or(Vec::new(), |mobility| mobility.dependent.clone()),
        "coordinates": coordinates.collect::<Vec<_>>(),
        "parameters": d.parameters.iter().zip(&facts.defaults).map(|(p, si)| valued(p, *si)).collect::<Vec<_>>(),
        "inputs": d.inputs.iter().map(quantity).collect::<Vec<_>>(),
        "speed_constraints": d.speed_constraints.iter().map(|i| d.constraints[*i].name).collect::<Vec<_>>(),
        "constraints": d.constraints.iter().map(quantity).collect::<Vec<_>>(),
        "outputs": d.outputs.iter().map(quantity).collect::<Vec<_>>(),
        "events": d.events.iter().map(|event| json!({ "name": event.name, "does": happening(event, d) })).collect::<Vec<_>>(),
        "figures": d.figures.iter().map(|figure| figure.name).collect::<Vec<_>>(),
        "run": runs(d).map(|(option, value, from)| json!({ "option": option, "value": value, "from": from })).collect::<Vec<_>>(),
        "tree": facts.tree.iter().map(Link::as_json).collect::<Vec<_>>(),
        "base_parameters": facts.base_parameters.iter().map(BaseParameters::as_json).collect::<Vec<_>>(),
        "kernels": kernels.collect::<Vec<_>>(),
    })
}

/// How it is run where nothing else is said: options, values, and where these come from.
fn runs(d: &Description) -> impl Iterator<Item = (&'static str, &'static str, &'static str)> {
    let from = |declared: bool| if declared { "declaration" } else { "default" };
    SettingsArguments::defaults(d).into_iter().map(move |(option, value, declared)| (option, value, from(declared)))
}

const fn told(start: Start) -> &'static str {
    match start {
        Start::Given => "given",
        Start::Guess => "guess",
        Start::Free => "free",
    }
}

fn as_text(facts: &Facts) -> String {
    let d = facts.description;
    let mut text = format!("{}\n{}\n\n{}declaration {}\n", d.name, d.docs, size(facts), d.declaration_hash);
    text += &section("Coordinates", coordinates(facts));
    let parameters = d.parameters.iter().zip(&facts.defaults);
    let parameters = parameters.map(|(p, si)| [p.name.to_owned(), short(si / p.factor), unit(p), p.docs.to_owned()]);
    text += &section("Parameters, with their defaults", parameters.collect());
    let inputs =
        d.inputs.iter().map(|input| [input.name.to_owned(), unit(input), String::new(), input.docs.to_owned()]);
    text += &section("Inputs", inputs.collect());
    text += &constraints(d);
    let outputs = d.outputs.iter().map(|o| [o.name.to_owned(), unit(o), o.docs.to_owned(), String::new()]);
    text += &section("Outputs", outputs.collect());
    let run =
        runs(d).map(|(option, value, from)| [format!("--{option}"), value.to_owned(), from.to_owned(), String::new()]);
    text += &section("Runs, where nothing else is said", run.collect());
    if !d.events.is_empty() {
        let noted = |event: &Event| if event.steps.is_empty() { ", noted; the motion goes on" } else { "" };
        let event =
            |event: &Event| [event.name.to_owned(), happening(event, d) + noted(event), String::new(), String::new()];
        text += &section("Events", d.events.iter().map(event).collect());
    }
    text += &section("Tree of bodies, with their masses", facts.tree.iter().map(Link::line).collect());
    let base = facts.base_parameters.iter().map(BaseParameters::line).collect();
    text += &section(
        "Base parameters of links: mass, first moments h and second moments P about the origin, in the link's frame",
        base,
    );
    let kernels = facts.kernels.iter();
    let kernels = kernels.map(|(name, total, of)| [name.clone(), total.to_string(), of.clone(), String::new()]);
    text + &section("Operations of each kernel", kernels.collect())
}

/// The numbers of coordinates, constraints and parameters, and the degrees of freedom.
fn size(facts: &Facts) -> String {
    let d = facts.description;
    let size = format!(
        "{}, {}, {}",
        counted(d.coordinates.len(), "coordinate"),
        counted(d.constraints.len(), "constraint row"),
        counted(d.parameters.len(), "parameter")
    );
    match &facts.mobility {
        Ok(mobility) => {
            let mut text = format!("{size}; {}\n", freedom(mobility));
            mobility.redundancies().iter().for_each(|line| text += &format!("redundant: {line}\n"));
            mobility.singularities().iter().for_each(|line| text += &format!("singular: {line}\n"));
            text
        }
        Err(why) => format!("{size}\nnot assembled from its declared start: {why}\n"),
    }
}

/// Each coordinate with where and how fast it starts.
fn coordinates(facts: &Facts) -> Vec<[String; 4]> {
    let number = |si: f64, q: &Quantity| format!("{} {}", short(si / q.factor), unit(q));
    let line = |(c, (position, speed)): (&Coordinate, &(f64, f64))| {
        let speed =
            if c.speed_given { format!(", {} = {}", c.speed.name, number(*speed, &c.speed)) } else { String::new() };
        let start = match c.start {
            Start::Given => format!("starts at {}{speed}", number(*position, &c.position)),
            Start::Guess => format!("starts near {}{speed}", number(*position, &c.position)),
            // Nothing moves it away from there.
            Start::Free if facts.description.constraints.is_empty() => {
                format!("starts at {}{speed}", number(*position, &c.position))
            }
            Start::Free => format!("start found{speed}"),
        };
        [c.position.name.to_owned(), unit(&c.position), start, c.position.docs.to_owned()]
    };
    facts.description.coordinates.iter().zip(&facts.start).map(line).collect()
}

/// Each constraint with its equation and its multiplier, and the definition of a reaction.
fn constraints(d: &Description) -> String {
    let equations = equations(d);
    let equation_of = |name: &str| {
        let of_component = |of: &str| name.strip_suffix(['x', 'y']).is_some_and(|s| s.trim_end_matches('_') == of);
        let found = equations.iter().find(|(of, _)| of == name || of_component(of));
        found.map_or(String::new(), |(_, equation)| equation.clone())
    };
    let line = |c: &Quantity| [c.name.to_owned(), equation_of(c.name), format!("lambda_{}", c.name), unit(c)];
    let lines = d.constraints.iter().map(line).collect();
    let mut text = section("Constraints, with their multipliers and units", lines);
    if !d.constraints.is_empty() {
        text += "  A reaction does the virtual work -lambda times the change of C = left - right on the mechanism.\n";
    }
    if !d.speed_constraints.is_empty() {
        let names: Vec<&str> = d.speed_constraints.iter().map(|i| d.constraints[*i].name).collect();
        text += &format!(
            "  Between speeds alone: {}; their reactions have the power -lambda times left - right.\n",
            names.join(", ")
        );
    }
    text
}

/// Degrees of freedom; of speeds and positions, where these differ.
pub(crate) fn freedom(mobility: &Mobility) -> String {
    let counted = match mobility.degrees_of_freedom {
        1 => "1 degree of freedom".to_owned(),
        n => format!("{n} degrees of freedom"),
    };
    match mobility.configuration_freedom {
        same if same == mobility.degrees_of_freedom => counted,
        more => format!("{counted} in its speeds, {more} in its positions"),
    }
}

fn unit(quantity: &Quantity) -> String {
    if quantity.unit == "1" { String::new() } else { quantity.unit.to_owned() }
}

/// Rows with aligned columns under a heading; nothing without rows.
fn section(heading: &str, rows: Vec<[String; 4]>) -> String {
    if rows.is_empty() {
        return String::new();
    }
    let width = |column: usize| rows.iter().map(|row| row[column].chars().count()).max().unwrap_or(0);
    let widths = [width(0), width(1), width(2)];
    let mut text = format!("\n{heading}\n");
    for row in &rows {
        let cells: Vec<String> = row[..3].iter().zip(widths).map(|(cell, width)| format!("{cell:<width$}")).collect();
        let line = format!("  {}  {}", cells.join("  "), row[3].replace('\n', " "));
        text += line.trim_end();
        text.push('\n');
    }
    text
}

/// The constraints as they were declared.
fn equations(description: &Description) -> Vec<(String, String)> {
    let parsed = description.declaration.parse().ok().and_then(|tokens| codegen::parse(tokens).ok());
    let constraints = parsed.map_or(Vec::new(), |declaration| declaration.constraints);
    let switched = |activity: Option<Activity>| match activity {
        None => "",
        Some(Activity::Active) => ", initially active",
        Some(Activity::Released) => ", initially released",
    };
    let equation = |c: &codegen::dsl::Equation| format!("{} = {}{}", c.left, c.right, switched(c.initially));
    constraints.iter().map(|c| (c.name.to_string(), equation(c))).collect()
}
