//! The figures of a sweep: all quantities against the driven one.

use super::figures::{Figures, Sheet, draw_mechanism, draw_outputs, label, motion, name_beside_groups, poses};
use super::{Curve, FigureSettings, Plot, ShowError, panels_with};
use crate::outcome::Row;
use sim_kernel::{Description, Mechanism};
use sim_runtime::{Column, Driven, Kinematics, Provenance, Table};
use std::path::Path;

/// The figures that every sweep may have, besides those of its outputs.
pub const SWEEP_FIGURES: [&str; 4] = ["mechanism", "drive", "transmission", "ratios"];
/// Ratios of outputs in one figure: with more, panels would be too low.
const MOST_PANELS: usize = 5;

/// Draws every figure of a sweep into a directory: each group of outputs, the forces of the drives (`drive`), the
/// transmission index (`transmission`), and the ratios of outputs to the driven quantity (`ratios`), all against the
/// driven quantity; and the mechanism at equal intervals.
pub fn sweep_figures<M: Mechanism>(
    found: &Kinematics<M>,
    table: &Table,
    directory: &Path,
    settings: FigureSettings,
) -> Figures {
    let drawing = |index: usize| Row::new(&found.mechanism, &found.trajectory.samples[index], 0.0).drawing;
    let swept = Swept {
        description: found.mechanism.description(),
        driven: found.sweep.driven,
        values: &found.values,
        is_cycle: found.is_cycle(),
        drawing: &drawing,
    };
    draw(&swept, table, directory, settings)
}

/// A sweep without the type of its mechanism.
struct Swept<'a> {
    description: &'static Description,
    driven: Driven,
    /// Of what is driven, at each sample.
    values: &'a [f64],
    is_cycle: bool,
    /// The numbers of the drawing at a sample.
    drawing: &'a dyn Fn(usize) -> Vec<f64>,
}

fn draw(swept: &Swept, table: &Table, directory: &Path, settings: FigureSettings) -> Figures {
    let Swept { description, driven, values, .. } = *swept;
    let driven = driven.quantity(description);
    let what = label(driven.docs, driven.name).trim_end_matches('.');
    let x_label = format!("{what} [{}]", driven.unit);
    let x: Vec<f64> = values.iter().map(|value| value / driven.factor).collect();
    let abscissa = (x_label.as_str(), x.as_slice());
    let mut figures = draw_outputs(description, table, abscissa, directory, settings);
    let columns = |prefix: &str| table.columns.iter().filter(|column| column.name.starts_with(prefix)).collect();
    let mut add = |name: &str, title: &str, columns: Vec<&Column>| {
        let columns: Vec<&Column> = columns.into_iter().take(MOST_PANELS).collect();
        if !columns.is_empty() {
            let name = name_beside_groups(description, name);
            figures.add(&name, stacked(title, &columns, abscissa, directory, &name, settings, &table.provenance));
        }
    };
    add("drive", "What the drive exerts", columns("drive_"));
    add("transmission", "Transmission index", columns("transmission_index"));
    add("ratios", &format!("Ratios of rates to that of {}", driven.name), columns("ratio_"));
    if !description.drawing.is_empty() && !values.is_empty() {
        let name = name_beside_groups(description, "mechanism");
        let sheet = Sheet { directory, name: &name, settings, provenance: &table.provenance };
        figures.add(&name, draw_positions(swept, &sheet));
    }
    figures
}

/// The mechanism at equal intervals.
fn draw_positions(swept: &Swept, sheet: &Sheet) -> Result<(), ShowError> {
    let Swept { description, driven, values, .. } = *swept;
    let driven = driven.quantity(description);
    let places = spread(values.len(), poses(description), swept.is_cycle);
    let drawn: Vec<Vec<f64>> = places.iter().map(|index| (swept.drawing)(*index)).collect();
    let at = places.iter().map(|index| values[*index] / driven.factor);
    let poses = at.zip(drawn.iter().map(Vec::as_slice)).collect();
    let heading = format!("{} [{}]", driven.name, driven.unit);
    let motion = motion(description, values.len(), swept.drawing);
    draw_mechanism(description, (&heading, poses), &motion, sheet)
}

/// Columns in panels below each other.
fn stacked(
    title: &str,
    columns: &[&Column],
    (x_label, x): (&str, &[f64]),
    directory: &Path,
    name: &str,
    settings: FigureSettings,
    provenance: &Provenance,
) -> Result<(), ShowError> {
    let labels: Vec<String> = columns.iter().map(|column| column.header()).collect();
    let plots: Vec<Plot> = columns
        .iter()
        .zip(&labels)
        .map(|(column, label)| {
            let curves = vec![Curve { label: &column.name, values: column.values.clone() }];
            Plot { title, x_label, y_label: label, x, curves }
        })
        .collect();
    panels_with(&plots, settings, directory, name, provenance)
}

/// So many samples at equal intervals, without the last of a whole turn.
fn spread(samples: usize, poses: usize, is_cycle: bool) -> Vec<usize> {
    let intervals = if is_cycle { poses } else { poses - 1 };
    let last = samples.saturating_sub(1);
    let mut places: Vec<usize> = (0..poses).map(|i| last * i / intervals).collect();
    places.dedup();
    places
}
