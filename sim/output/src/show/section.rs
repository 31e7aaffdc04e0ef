//! The figures of a Poincaré section: speed against position of each coordinate, a dot for each crossing.

use super::figures::{Figures, label};
use super::{Curve, FigureSettings, Plot, panels_with};
use sim_kernel::{Description, Mechanism};
use sim_runtime::{At, Driven, Provenance, Section, Table};
use std::f64::consts::TAU;
use std::path::Path;

/// Draws `section_NAME` for each coordinate into a directory; the figures come from where the table does. Angles are within half a turn of the first.
pub fn section_figures<M: Mechanism>(
    found: &Section<M>,
    table: &Table,
    directory: &Path,
    settings: FigureSettings,
) -> Figures {
    let samples: Vec<At<f64>> = found.trajectory.samples.iter().map(At::sample).collect();
    draw(found.mechanism.description(), &samples, directory, settings, &table.provenance)
}

fn draw(
    description: &'static Description,
    samples: &[At<f64>],
    directory: &Path,
    settings: FigureSettings,
    provenance: &Provenance,
) -> Figures {
    let mut figures = Figures::default();
    let Some(first) = samples.first() else { return figures };
    for (j, c) in description.coordinates.iter().enumerate() {
        let turn = Driven::Coordinate(j).turn(description);
        let near = |q: f64| match turn {
            Some(_) => q - TAU * ((q - first.positions[j]) / TAU).round(),
            None => q,
        };
        // Gaps between all points: a lone point is a dot.
        let dots =
            |value: &dyn Fn(usize) -> f64| (0..samples.len()).flat_map(|i| [value(i), f64::NAN]).collect::<Vec<f64>>();
        let x = dots(&|i| near(samples[i].positions[j]) / c.position.factor);
        let values = dots(&|i| samples[i].speeds[j] / c.speed.factor);
        let what = label(c.position.docs, c.position.name).trim_end_matches('.');
        let (x_label, y_label) = (format!("{what} [{}]", c.position.unit), format!("its speed [{}]", c.speed.unit));
        let curves = vec![Curve { label: c.speed.name, values }];
        let shown = Plot { title: "Poincaré section", x_label: &x_label, y_label: &y_label, x: &x, curves };
        let name = format!("section_{}", c.position.name);
        figures.add(&name, panels_with(&[shown], settings, directory, &name, provenance));
    }
    figures
}
