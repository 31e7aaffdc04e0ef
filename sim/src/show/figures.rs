//! The figures of a run: one for each group of outputs, and the mechanism in several positions.

use super::{Curve, Plot, Pose, ShowError, mechanism, plot};
use crate::{Column, Run, Table};
use sim_kernel::Mechanism;
use std::path::Path;

/// Positions in the picture of the mechanism.
const POSES: usize = 6;

/// Draws every figure of a run into a directory; gives their number.
///
/// # Errors
/// As [`plot`] and [`mechanism`].
pub fn figures<M: Mechanism>(run: &Run<M>, table: &Table, directory: &Path) -> Result<usize, ShowError> {
    let description = const { &M::DESCRIPTION };
    let mut outputs = table.outputs().iter().zip(description.outputs);
    let mut drawn = 0;
    for figure in description.figures {
        let group: Vec<_> = outputs.by_ref().take(figure.len).collect();
        let labels: Vec<&str> = group.iter().map(|(column, output)| label(output.docs, &column.name)).collect();
        let curves =
            group.iter().zip(&labels).map(|((column, _), label)| Curve { label, values: column.values.clone() });
        let columns: Vec<&Column> = group.iter().map(|(column, _)| *column).collect();
        let y_label = y_label(figure.name, &columns, &labels);
        let curves = curves.collect();
        plot(
            &Plot { title: figure.title, x_label: "time [s]", y_label: &y_label, x: table.times(), curves },
            directory,
            figure.name,
        )?;
        drawn += 1;
    }
    if !description.drawing.is_empty() {
        draw_mechanism(run, directory)?;
        drawn += 1;
    }
    Ok(drawn)
}

/// What a curve is called: the first line of its documentation, or its name.
fn label<'a>(docs: &'a str, name: &'a str) -> &'a str {
    docs.lines().next().filter(|line| !line.is_empty()).unwrap_or(name)
}

/// What the curves are, with their unit.
fn y_label(name: &str, columns: &[&Column], labels: &[&str]) -> String {
    let mut units: Vec<&str> = columns.iter().map(|column| column.unit).collect();
    units.dedup();
    let units: Vec<String> = units.iter().map(|unit| format!("[{unit}]")).collect();
    let what = if let [label] = labels { (*label).to_owned() } else { name.replace('_', " ") };
    format!("{what} {}", units.join(", "))
}

/// The mechanism at equal times through its period, or through the run.
fn draw_mechanism<M: Mechanism>(run: &Run<M>, directory: &Path) -> Result<(), ShowError> {
    let description = const { &M::DESCRIPTION };
    let samples = &run.trajectory.samples;
    let span = run.period().or(samples.last().map(|sample| sample.state.time)).unwrap_or(0.0);
    let drawn: Vec<(f64, M::Drawing)> = (0..POSES)
        .filter_map(|i| {
            let wanted = span * i as f64 / POSES as f64;
            let sample = samples
                .iter()
                .min_by(|a, b| (a.state.time - wanted).abs().total_cmp(&(b.state.time - wanted).abs()))?;
            Some((sample.state.time, run.mechanism.drawing(sample.state.time, &sample.state.positions)))
        })
        .collect();
    let poses: Vec<Pose> =
        drawn.iter().map(|(time, numbers)| Pose { numbers: numbers.as_ref(), time: *time }).collect();
    mechanism(
        &format!("{} in {} positions", description.type_name, poses.len()),
        description.drawing,
        &poses,
        directory,
        "mechanism",
    )
}
