//! The `outputs` block.

use super::interpreter::Interpreter;
use super::quantities::resolve_unit;
use super::scope::{Names, plain};
use super::value::Shape;
use super::{Constraint, Coordinate, Output, OutputGroup, Unit};
use crate::dsl::{self, Declaration, Region};
use crate::symbolic::Expr;
use syn::Ident;

pub(super) fn resolve_outputs(
    declaration: &Declaration,
    coordinates: &[Coordinate],
    constraints: &[Constraint],
    interpreter: &mut Interpreter,
) -> (Vec<Output>, Vec<OutputGroup>) {
    let mut columns: Vec<String> = vec!["t".into()];
    columns.extend(
        coordinates.iter().flat_map(|c| [c.name.clone(), format!("{}_dot", c.name), format!("{}_ddot", c.name)]),
    );
    let multipliers: Vec<String> = constraints.iter().map(|c| format!("lambda_{}", c.name)).collect();
    let of_sweeps = columns_of_sweeps(declaration, coordinates);
    refuse_taken(declaration, [&multipliers, &of_sweeps], interpreter);
    columns.extend(multipliers);
    let mut names = Names::new("output");
    let mut figures = Vec::new();
    let (mut outputs, mut groups) = (Vec::new(), Vec::new());
    for group in &declaration.outputs {
        if let Some(name) = group.name.as_ref().or(group.outputs.first().map(|output| &output.name)) {
            let defined_twice = group.name.is_none() && names.get_region(&plain(name)).is_some();
            if !defined_twice {
                define_figure(name, &mut figures, interpreter);
            }
        }
        let first = outputs.len();
        for output in &group.outputs {
            let name = plain(&output.name);
            names.define(&output.name, Some(()), &mut interpreter.mistakes);
            if columns.contains(&name) {
                interpreter.mistakes.add(
                    Region::from(&output.name)
                        .error(format!("`{name}` is already a column of the results; choose another name")),
                );
            }
            if of_sweeps.contains(&name) {
                interpreter.mistakes.add(
                    Region::from(&output.name).error(format!("a sweep has a column `{name}`; choose another name")),
                );
            }
            let unit = resolve_unit(&output.unit, interpreter);
            let value = output_value(output, &name, unit.as_ref(), interpreter);
            if let (Some(value), Some(unit)) = (value, unit) {
                outputs.push(Output { name, docs: output.docs.clone(), unit, value });
            }
        }
        if let Some(output) = group.outputs.first() {
            let name = plain(group.name.as_ref().unwrap_or(&output.name));
            let title = group.title.clone().unwrap_or_else(|| default_title(group, output));
            groups.push(OutputGroup { name, title, len: outputs.len() - first });
        }
    }
    (outputs, groups)
}

/// Refuses coordinates whose columns are those of multipliers, or of sweeps.
fn refuse_taken(declaration: &Declaration, [multipliers, of_sweeps]: [&[String]; 2], interpreter: &mut Interpreter) {
    for coordinate in &declaration.coordinates {
        let name = plain(&coordinate.name);
        let own = ["", "_dot", "_ddot"].map(|suffix| format!("{name}{suffix}"));
        let mut refuse = |message: String| interpreter.mistakes.add(Region::from(&coordinate.name).error(message));
        if let Some(column) = own.iter().find(|column| multipliers.contains(column)) {
            let constraint = &column["lambda_".len()..];
            refuse(format!("`{column}` is the column of the reaction of `{constraint}`; choose another name"));
        } else if let Some(column) = own.iter().find(|column| of_sweeps.contains(column)) {
            refuse(format!("a sweep has a column `{column}`; choose another name"));
        }
    }
}

/// The columns of sweeps beyond those of runs.
fn columns_of_sweeps(declaration: &Declaration, coordinates: &[Coordinate]) -> Vec<String> {
    let outputs = declaration.outputs.iter().flat_map(|group| &group.outputs).map(|output| plain(&output.name));
    let outputs: Vec<String> = outputs.collect();
    let driven = coordinates.iter().map(|c| &c.name).chain(&outputs).map(|name| format!("drive_{name}"));
    let ratios = outputs.iter().flat_map(|name| [format!("ratio_{name}"), format!("advantage_{name}")]);
    driven.chain(ratios).chain(["transmission_index".to_owned()]).collect()
}

/// Figures are files, and some file systems do not tell letter case apart.
fn define_figure(name: &Ident, figures: &mut Vec<(String, Region)>, interpreter: &mut Interpreter) {
    let file = plain(name).to_lowercase();
    if file == "mechanism" {
        interpreter
            .mistakes
            .add(Region::from(name).error("`mechanism` is the figure of the mechanism itself; choose another name"));
    }
    if let Some((_, first)) = figures.iter().find(|(other, _)| *other == file) {
        let mut mistake = Region::from(name)
            .error(format!("two figures would be called `{file}`; choose another name for one of them"));
        mistake.combine(first.error("the other one is here"));
        interpreter.mistakes.add(mistake);
    }
    figures.push((file, name.into()));
}

fn output_value(output: &dsl::Output, name: &str, unit: Option<&Unit>, interpreter: &mut Interpreter) -> Option<Expr> {
    let value = interpreter.value(&output.value)?;
    match value.shape {
        Shape::Scalar(scalar) => {
            interpreter.expect_unit(
                value.measured(&output.value),
                &format!("output `{name}` is declared"),
                name,
                unit?,
            );
            Some(scalar)
        }
        Shape::Rotation(_) => {
            interpreter.refuse(output.value.region, format!("output `{name}` is a rotation; an output is a scalar"))
        }
        Shape::Vector(_) | Shape::Spatial(_) => interpreter.refuse(
            output.value.region,
            format!("output `{name}` is a vector; write one output for each component: `{name}_x = (..).x;`"),
        ),
    }
}

/// The first line of an output's documentation, or its name.
fn default_title(group: &dsl::OutputGroup, output: &dsl::Output) -> String {
    match (&group.name, output.docs.lines().next()) {
        (None, Some(line)) if !line.is_empty() => line.trim_end_matches('.').to_owned(),
        (Some(name), _) => plain(name).replace('_', " "),
        (None, _) => plain(&output.name).replace('_', " "),
    }
}
