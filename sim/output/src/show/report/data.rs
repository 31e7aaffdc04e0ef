//! The data for the page's script.

use super::Shown;
use super::rows::{chosen, doubles, floats};
use crate::outcome::Rows;
use crate::show::figures::{groups, label};
use crate::show::parts::is_coloured;
use crate::show::typeset;
use serde_json::{Value, json};
use sim_kernel::{Description, Shape};
use sim_runtime::{Column, Table};

/// Times of events that are marked along the scrubber.
const MOST_MARKS: usize = 200;

/// A column with what it is called.
struct Labelled {
    column: Column,
    label: String,
}

/// A figure's title and its columns, without time.
pub(super) struct Group {
    pub(super) title: String,
    pub(super) columns: Vec<usize>,
}

/// The motion as JSON: columns and drawing as packed floats, figures as lists of columns.
pub(super) fn data(shown: &Shown) -> Value {
    let Shown { description, rows: all_rows, table, times, .. } = shown;
    let mut columns = labelled(description, table);
    let is_zero = |group: &Group| group.columns.iter().all(|k| table.columns[k + 1].values.iter().all(|v| *v == 0.0));
    let figures = declared(description, table).into_iter().filter(|group| !(shown.is_at_rest && is_zero(group)));
    let figures: Vec<Group> = figures.chain((shown.figures)()).collect();
    let mut more = states(description, shown.is_at_rest);
    if shown.has_energy {
        let work = 3 * description.coordinates.len() + description.constraints.len();
        columns[work].label = "work of loads and drives since the start".into();
        more.push(Group { title: "Energy".into(), columns: vec![columns.len(), work] });
        more.push(Group { title: "Change of kinetic energy minus work".into(), columns: vec![columns.len() + 1] });
        columns.extend(energy(*all_rows, times.len()));
    }
    let width = drawing_width(description);
    let all: Vec<&Column> = columns.iter().map(|labelled| &labelled.column).collect();
    let rows = chosen(&all, times.len(), all.len() + width + 4 * description.constraints.len().max(4));
    let arrow_rows = every_nth(&rows);
    let vectors = crate::show::vectors::vectors(*all_rows, description, &arrow_rows);
    let pick = |values: &[f64]| floats(rows.iter().map(|row| values[*row]));
    let (open, closed) = if figures.is_empty() { more.split_at(more.len().min(2)) } else { (&figures[..], &more[..]) };
    let abscissa = shown.abscissa.as_ref().map(|abscissa| {
        json!({
            "name": abscissa.name, "unit": printed_unit(abscissa.unit), "label": typeset(&abscissa.label),
            "from": abscissa.from, "rate": abscissa.rate,
        })
    });
    json!({
        "times": doubles(rows.iter().map(|row| times[*row])),
        "abscissa": abscissa,
        "columns": columns.iter().map(|Labelled { column, label }| json!({
            "name": column.name, "label": typeset(label), "unit": printed_unit(&column.unit), "values": pick(&column.values),
        })).collect::<Vec<_>>(),
        "figures": open.iter().map(figure).collect::<Vec<_>>(),
        "more": closed.iter().map(figure).collect::<Vec<_>>(),
        "phase": [0, description.coordinates.len()],
        "drawing": drawing(*all_rows, description, &rows),
        "vector_times": doubles(arrow_rows.iter().map(|row| times[*row])),
        "vectors": vectors.into_iter().map(|(vector, numbers)| json!({
            "label": vector.label, "about": vector.about, "kind": vector.kind, "numbers": floats(numbers),
        })).collect::<Vec<_>>(),
        "events": shown.marks.iter().take(MOST_MARKS).collect::<Vec<_>>(),
        "period": shown.period,
    })
}

/// Rows at which arrows are evaluated: at most 601, evenly chosen, with the last.
fn every_nth(rows: &[usize]) -> Vec<usize> {
    let stride = rows.len().div_ceil(600).max(1);
    let mut chosen: Vec<usize> = rows.iter().copied().step_by(stride).collect();
    chosen.extend(rows.last().filter(|last| chosen.last() != Some(last)));
    chosen
}

fn printed_unit(unit: &str) -> String {
    typeset(&format!("[{unit}]")).trim_matches(['[', ']']).to_owned()
}

fn figure(group: &Group) -> Value {
    json!({ "title": typeset(&group.title), "columns": group.columns })
}

/// The columns of the table except time.
fn labelled(description: &Description, table: &Table) -> Vec<Labelled> {
    let outputs = description.outputs.len();
    let first_output = table.columns.len() - outputs;
    let columns = table.columns.iter().enumerate().skip(1);
    let called = |index: usize, column: &Column| match index.checked_sub(first_output) {
        Some(output) => label(description.outputs[output].docs, &column.name).to_owned(),
        None => column.name.clone(),
    };
    columns.map(|(index, column)| Labelled { column: column.clone(), label: called(index, column) }).collect()
}

/// The declared figures that have a finite value.
fn declared(description: &Description, table: &Table) -> Vec<Group> {
    let first_output = table.columns.len() - 1 - description.outputs.len();
    let finite = |group: &&(&sim_kernel::Figure, std::ops::Range<usize>)| {
        table.outputs()[group.1.clone()].iter().any(|column| column.values.iter().any(|value| value.is_finite()))
    };
    let groups: Vec<_> = groups(description).collect();
    let title = |figure: &sim_kernel::Figure| {
        capital(&if figure.title.is_empty() { figure.name.replace('_', " ") } else { figure.title.to_owned() })
    };
    let shown = groups.iter().filter(finite);
    shown
        .map(|(figure, outputs)| Group {
            title: title(figure),
            columns: outputs.clone().map(|output| first_output + output).collect(),
        })
        .collect()
}

/// With a capital letter at the start.
fn capital(text: &str) -> String {
    let mut letters = text.chars();
    letters.next().map_or(String::new(), |first| first.to_uppercase().chain(letters).collect())
}

/// Coordinates, speeds, accelerations and multipliers, those of one unit together; without what is 0 at rest.
fn states(description: &Description, is_at_rest: bool) -> Vec<Group> {
    let (n, m) = (description.coordinates.len(), description.constraints.len());
    let unit = |index: usize| match (index / n.max(1), index % n.max(1)) {
        (0, i) => description.coordinates[i].position.unit,
        (1, i) => description.coordinates[i].speed.unit,
        (2, i) => description.coordinates[i].acceleration.unit,
        _ => description.constraints[index - 3 * n].unit,
    };
    let kinds = [
        ("Coordinates", 0..n),
        ("Speeds", n..2 * n),
        ("Accelerations", 2 * n..3 * n),
        ("Multipliers", 3 * n..3 * n + m),
    ];
    let moves = |title: &str| matches!(title, "Speeds" | "Accelerations");
    let kinds = kinds.into_iter().filter(|(title, _)| !(is_at_rest && moves(title)));
    kinds.flat_map(|(title, indices)| of_one_unit(title, indices.collect(), unit)).collect()
}

fn of_one_unit(title: &str, indices: Vec<usize>, unit: impl Fn(usize) -> &'static str) -> Vec<Group> {
    let mut groups: Vec<(&str, Vec<usize>)> = Vec::new();
    for index in indices {
        match groups.iter_mut().find(|group| group.0 == unit(index)) {
            Some((_, group)) => group.push(index),
            None => groups.push((unit(index), vec![index])),
        }
    }
    let alone = groups.len() == 1;
    let titled = |unit: &str| if alone { title.to_owned() } else { format!("{title} [{unit}]") };
    groups.into_iter().map(|(unit, columns)| Group { title: titled(unit), columns }).collect()
}

/// Kinetic energy, and the change of its difference from work.
fn energy(run: &dyn Rows, samples: usize) -> [Labelled; 2] {
    let (mut kinetic, mut change, mut start) = (Vec::new(), Vec::new(), None);
    for index in 0..samples {
        let row = run.row(index);
        let balance = row.kinetic_energy - row.work + row.energy_taken;
        kinetic.push(row.kinetic_energy);
        change.push(balance - *start.get_or_insert(balance));
    }
    let column = |name: &str, label: &str, values| {
        let column = Column { name: name.into(), unit: "J".into(), values };
        Labelled { column, label: label.into() }
    };
    [column("kinetic_energy", "kinetic energy", kinetic), column("energy_change", "change", change)]
}

fn drawing_width(description: &Description) -> usize {
    description.drawing.iter().map(|shape| shape.numbers(description.dimension)).sum()
}

/// The shapes with the names of their points, and their numbers row by row.
fn drawing(run: &dyn Rows, description: &Description, rows: &[usize]) -> Value {
    let names = crate::show::names::points(description);
    let (mut first, mut colour, mut shapes) = (0, 0, Vec::new());
    for (index, (shape, points)) in description.drawing.iter().zip(&names).enumerate() {
        let kind = kind(*shape);
        let label = format!("{kind} {}", points.join(", "));
        shapes.push(
            json!({ "kind": kind, "index": index, "first": first, "points": points, "colour": colour, "label": label }),
        );
        first += shape.numbers(description.dimension);
        colour += usize::from(is_coloured(*shape));
    }
    let numbers = rows.iter().flat_map(|row| run.row(*row).drawing);
    let named =
        names.iter().flatten().filter(|name| name.len() <= 4).count() > 0 && names.iter().flatten().count() <= 40;
    json!({ "dimension": description.dimension, "shapes": shapes, "width": first, "named": named, "numbers": floats(numbers) })
}

fn kind(shape: Shape) -> &'static str {
    match shape {
        Shape::Line(_) => "line",
        Shape::Curve(_) => "curve",
        Shape::Spring => "spring",
        Shape::Damper => "damper",
        Shape::Slider => "slider",
        Shape::Ground(_) => "ground",
        Shape::Points(_) => "points",
        Shape::Circle => "circle",
        Shape::Trace(_) => "trace",
    }
}
