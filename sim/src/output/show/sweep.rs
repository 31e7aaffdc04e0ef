//! The figures of a sweep: all quantities against the driven one.

use super::figures::{Figures, POSES, draw_mechanism, draw_outputs, label, name_beside_groups};
use super::{Curve, Plot, ShowError, Size, panels_with};
use crate::output::outcome::Row;
use crate::state::provenance::Provenance;
use crate::{Column, Driven, Kinematics, Table};
use sim_kernel::{Description, Mechanism};
use std::path::Path;

/// The figures that every sweep may have, besides those of its outputs.
#[cfg(feature = "cli")]
pub(crate) const SWEEP_FIGURES: [&str; 4] = ["mechanism", "drive", "transmission", "ratios"];
/// Ratios of outputs in one figure: with more, panels would be too low.
const MOST_PANELS: usize = 5;

/// Draws every figure of a sweep into a directory: each group of outputs, the forces of the drives (`drive`), the
/// transmission index (`transmission`), and the ratios of outputs to the driven quantity (`ratios`), all against the
/// driven quantity; and the mechanism at equal intervals.
pub fn sweep_figures<M: Mechanism>(found: &Kinematics<M>, table: &Table, directory: &Path, size: Size) -> Figures {
    let (description, driven) = (const { &M::DESCRIPTION }, found.sweep.driven);
    let poses = if description.drawing.is_empty() { Vec::new() } else { spread(found) };
    draw((description, driven, &found.values), &poses, table, directory, size)
}

fn draw(
    (description, driven, values): (&'static Description, Driven, &[f64]),
    poses: &[Row],
    table: &Table,
    directory: &Path,
    size: Size,
) -> Figures {
    let driven = driven.quantity(description);
    let what = label(driven.docs, driven.name).trim_end_matches('.');
    let x_label = format!("{what} [{}]", driven.unit);
    let x: Vec<f64> = values.iter().map(|value| value / driven.factor).collect();
    let abscissa = (x_label.as_str(), x.as_slice());
    let mut figures = draw_outputs(description, table, abscissa, directory, size);
    let columns = |prefix: &str| table.columns.iter().filter(|column| column.name.starts_with(prefix)).collect();
    let mut add = |name: &str, title: &str, columns: Vec<&Column>| {
        let columns: Vec<&Column> = columns.into_iter().take(MOST_PANELS).collect();
        if !columns.is_empty() {
            let name = name_beside_groups(description, name);
            figures.add(&name, stacked(title, &columns, abscissa, directory, &name, size, &table.provenance));
        }
    };
    add("drive", "What the drive exerts", columns("drive_"));
    add("transmission", "Transmission index", columns("transmission_index"));
    add("ratios", &format!("Ratios of rates to that of {}", driven.name), columns("ratio_"));
    if !poses.is_empty() {
        let name = name_beside_groups(description, "mechanism");
        figures.add(&name, draw_mechanism(description, poses, directory, &name, size, &table.provenance));
    }
    figures
}

/// Columns in panels below each other.
fn stacked(
    title: &str,
    columns: &[&Column],
    (x_label, x): (&str, &[f64]),
    directory: &Path,
    name: &str,
    size: Size,
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
    panels_with(&plots, size, directory, name, provenance)
}

/// Samples at equal intervals, without the last of a whole turn.
fn spread<M: Mechanism>(found: &Kinematics<M>) -> Vec<Row> {
    let samples = &found.trajectory.samples;
    let intervals = if found.is_cycle() { POSES } else { POSES - 1 };
    let last = samples.len().saturating_sub(1);
    let mut places: Vec<usize> = (0..POSES).map(|i| last * i / intervals).collect();
    places.dedup();
    let samples = places.into_iter().filter_map(|i| samples.get(i));
    samples.map(|sample| Row::new(&found.mechanism, sample, 0.0)).collect()
}
