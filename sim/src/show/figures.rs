//! The figures of a run: one for each group of outputs, and the mechanism in several positions.

use super::{Curve, Plot, Pose, ShowError, mechanism, plot};
use crate::{Column, Run, Table};
use sim_kernel::{Description, Figure, Mechanism};
use std::ops::Range;
use std::path::Path;

/// Positions in the picture of the mechanism.
const POSES: usize = 6;

/// What came of drawing.
#[derive(Debug, Default)]
pub struct Figures {
    /// How many figures were drawn.
    pub drawn: usize,
    /// Why others were not.
    pub failures: Vec<ShowError>,
}

impl Figures {
    fn add(&mut self, result: Result<(), ShowError>) {
        match result {
            Ok(()) => self.drawn += 1,
            Err(failure) => self.failures.push(failure),
        }
    }
}

/// Draws every figure of a run into a directory. A group of outputs without any finite value has none.
pub fn figures<M: Mechanism>(run: &Run<M>, table: &Table, directory: &Path) -> Figures {
    let description = const { &M::DESCRIPTION };
    let outputs: Vec<_> = table.outputs().iter().zip(description.outputs).collect();
    let mut figures = Figures::default();
    for (figure, indices) in groups(description) {
        let group = &outputs[indices];
        if group.iter().all(|(column, _)| column.values.iter().all(|value| !value.is_finite())) {
            continue;
        }
        let labels: Vec<&str> = group.iter().map(|(column, output)| label(output.docs, &column.name)).collect();
        let curves =
            group.iter().zip(&labels).map(|((column, _), label)| Curve { label, values: column.values.clone() });
        let columns: Vec<&Column> = group.iter().map(|(column, _)| *column).collect();
        let y_label = y_label(figure.name, &columns, &labels);
        let (x_label, x, curves) = ("time [s]", table.times(), curves.collect());
        let shown = Plot { title: figure.title, x_label, y_label: &y_label, x, curves };
        figures.add(plot(&shown, directory, figure.name));
    }
    if !description.drawing.is_empty() {
        figures.add(draw_mechanism(run, directory));
    }
    figures
}

/// Each declared figure with the indices of its outputs.
pub(super) fn groups(description: &Description) -> impl Iterator<Item = (&Figure, Range<usize>)> {
    description.figures.iter().scan(0, |first, figure| {
        let outputs = *first..*first + figure.len;
        *first = outputs.end;
        Some((figure, outputs))
    })
}

/// What a curve is called: the first line of its documentation, or its name.
pub(super) fn label<'a>(docs: &'a str, name: &'a str) -> &'a str {
    docs.lines().next().filter(|line| !line.is_empty()).unwrap_or(name)
}

/// What the curves are, with their unit.
fn y_label(name: &str, columns: &[&Column], labels: &[&str]) -> String {
    let mut units: Vec<String> = Vec::new();
    for column in columns {
        let unit = format!("[{}]", column.unit);
        if !units.contains(&unit) {
            units.push(unit);
        }
    }
    let what = if let [label] = labels { (*label).to_owned() } else { name.replace('_', " ") };
    format!("{what} {}", units.join(", "))
}

/// The mechanism at equal times through its period, or through the run.
fn draw_mechanism<M: Mechanism>(run: &Run<M>, directory: &Path) -> Result<(), ShowError> {
    let description = const { &M::DESCRIPTION };
    let samples = &run.trajectory.samples;
    let span = run.period().or(samples.last().map(|sample| sample.state.time)).unwrap_or(0.0);
    let mut drawn: Vec<(f64, M::Drawing)> = (0..POSES)
        .filter_map(|i| {
            let wanted = span * i as f64 / POSES as f64;
            let sample = samples
                .iter()
                .min_by(|a, b| (a.state.time - wanted).abs().total_cmp(&(b.state.time - wanted).abs()))?;
            Some((sample.state.time, run.mechanism.drawing(sample.state.time, &sample.state.positions)))
        })
        .collect();
    drawn.dedup_by(|a, b| a.0 == b.0);
    let poses: Vec<Pose> =
        drawn.iter().map(|(time, numbers)| Pose { numbers: numbers.as_ref(), time: *time }).collect();
    let title = match poses.len() {
        1 => description.type_name.to_owned(),
        n => format!("{} in {n} positions", description.type_name),
    };
    mechanism(&title, description.drawing, &poses, directory, "mechanism")
}
