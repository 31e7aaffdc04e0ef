//! The figures of a run: one for each group of outputs, and the mechanism in several positions.

use super::{Curve, FigureSettings, Length, Plot, Pose, Positions, Shapes, ShowError, mechanism_with, panels_with};
use crate::outcome::{Outcome, Recorded, Row};
use sim_kernel::{Description, Figure, Mechanism, Quantity, Shape};
use sim_runtime::{Column, Provenance, Run, Table};
use std::num::NonZeroUsize;
use std::ops::Range;
use std::panic::resume_unwind;
use std::path::Path;

/// Positions in the picture of the mechanism.
const POSES: usize = 6;
/// Where more of them would be a tangle.
const FEW_POSES: usize = 4;
/// Samples among which they are chosen.
const MOST_CANDIDATES: usize = 2000;
/// Samples through which a path is drawn.
const MOST_PLACES: usize = 20_000;

/// The outcome of drawing.
#[derive(Debug, Default)]
pub struct Figures {
    /// The names of those that were drawn.
    pub names: Vec<String>,
    /// Why others were not.
    pub failures: Vec<ShowError>,
}

impl Figures {
    pub(super) fn add(&mut self, name: &str, result: Result<(), ShowError>) {
        match result {
            Ok(()) => self.names.push(name.to_owned()),
            Err(failure) => self.failures.push(failure),
        }
    }
}

/// Draws every figure of a run into a directory. A group of outputs without any finite value has none.
pub fn figures<M: Mechanism>(run: &Run<M>, table: &Table, directory: &Path, settings: FigureSettings) -> Figures {
    figures_of(run, &run.outcome(), table, directory, settings)
}

/// The same of a run whose mechanism has no type.
pub fn figures_of(
    run: &dyn Recorded,
    outcome: &Outcome,
    table: &Table,
    directory: &Path,
    settings: FigureSettings,
) -> Figures {
    let description = outcome.description;
    let mut figures = draw_outputs(description, table, ("time [s]", table.times()), directory, settings);
    if !description.drawing.is_empty() {
        let rows = chosen(run, outcome, table.times(), poses(description));
        let poses = rows.iter().map(|row| (row.time, row.drawing.as_slice())).collect();
        let motion = motion(description, outcome.samples, |index| run.row(index).drawing);
        let name = name_beside_groups(description, "mechanism");
        let sheet = Sheet { directory, name: &name, settings, provenance: &table.provenance };
        figures.add(&name, draw_mechanism(description, ("t [s]", poses), &motion, &sheet));
    }
    figures
}

/// A figure for each group of outputs, over an abscissa with its label.
pub(super) fn draw_outputs(
    description: &Description,
    table: &Table,
    (x_label, x): (&str, &[f64]),
    directory: &Path,
    settings: FigureSettings,
) -> Figures {
    let outputs: Vec<_> = table.outputs().iter().zip(description.outputs).collect();
    let is_shown = |group: &[(&Column, &Quantity)]| {
        group.iter().any(|(column, _)| column.values.iter().any(|value| value.is_finite()))
    };
    let groups = groups(description).map(|(figure, indices)| (figure, &outputs[indices]));
    let shown: Vec<_> = groups.filter(|(_, group)| is_shown(group)).collect();
    let mut figures = Figures::default();
    // Side by side, as PNG take long.
    let processors = std::thread::available_parallelism().map_or(1, NonZeroUsize::get);
    for some in shown.chunks(processors) {
        let drawn = std::thread::scope(|scope| {
            let mut threads = Vec::new();
            for (figure, group) in some {
                let draw = move || draw_group(figure, group, (x_label, x), (directory, settings), &table.provenance);
                threads.push(scope.spawn(draw));
            }
            threads.into_iter().map(|thread| thread.join().unwrap_or_else(|panic| resume_unwind(panic))).collect()
        });
        let drawn: Vec<Result<(), ShowError>> = drawn;
        some.iter().zip(drawn).for_each(|((figure, _), result)| figures.add(figure.name, result));
    }
    figures
}

/// The figure of one group of outputs.
fn draw_group(
    figure: &Figure,
    group: &[(&Column, &Quantity)],
    (x_label, x): (&str, &[f64]),
    (directory, settings): (&Path, FigureSettings),
    provenance: &Provenance,
) -> Result<(), ShowError> {
    let labels: Vec<&str> = group.iter().map(|(column, output)| label(output.docs, &column.name)).collect();
    let curves = group.iter().zip(&labels).map(|((column, _), label)| Curve { label, values: column.values.clone() });
    let columns: Vec<&Column> = group.iter().map(|(column, _)| *column).collect();
    let y_label = y_label(figure.name, &columns, &labels);
    let shown = Plot { title: figure.title, x_label, y_label: &y_label, x, curves: curves.collect() };
    panels_with(&[shown], settings, directory, figure.name, provenance)
}

/// The name of a figure that is not a group of outputs; names of groups have no hyphen.
pub(super) fn name_beside_groups(description: &Description, name: &str) -> String {
    match description.figures.iter().any(|figure| figure.name == name) {
        true => format!("{name}-figure"),
        false => name.to_owned(),
    }
}

/// Each declared figure with the indices of its outputs.
pub(super) fn groups(description: &Description) -> impl Iterator<Item = (&Figure, Range<usize>)> {
    description.figures.iter().scan(0, |first, figure| {
        let outputs = *first..*first + figure.len;
        *first = outputs.end;
        Some((figure, outputs))
    })
}

/// The label of a curve: the first line of its documentation, or its name.
pub(super) fn label<'a>(docs: &'a str, name: &'a str) -> &'a str {
    docs.lines().next().filter(|line| !line.is_empty()).unwrap_or(name)
}

/// The quantity of the curves, with its unit.
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

/// The file of a figure.
pub(super) struct Sheet<'a> {
    pub(super) directory: &'a Path,
    pub(super) name: &'a str,
    pub(super) settings: FigureSettings,
    pub(super) provenance: &'a Provenance,
}

/// The mechanism at several samples, each by its value under the heading and its drawing, and what its traced points do in a motion.
pub(super) fn draw_mechanism(
    description: &Description,
    (heading, poses): (&str, Vec<(f64, &[f64])>),
    motion: &[Vec<f64>],
    sheet: &Sheet,
) -> Result<(), ShowError> {
    let poses: Vec<Pose> = poses.into_iter().map(|(at, numbers)| Pose { numbers, at }).collect();
    let title = match poses.len() {
        1 => description.name.to_owned(),
        n => format!("{} in {n} positions", description.name),
    };
    let (shapes, unit) = (Shapes::of(description), Length::of(description));
    let positions = Positions { title: &title, shapes, unit, heading, poses: &poses, motion };
    mechanism_with(&positions, sheet.settings, sheet.directory, sheet.name, sheet.provenance)
}

/// The drawing at so many samples, of some at equal distances where they are many, with the last; none where nothing is traced.
pub(super) fn motion(description: &Description, samples: usize, drawing: impl Fn(usize) -> Vec<f64>) -> Vec<Vec<f64>> {
    if !description.drawing.iter().any(|shape| matches!(shape, Shape::Trace(_))) {
        return Vec::new();
    }
    let stride = samples.div_ceil(MOST_PLACES).max(1);
    let last = samples.checked_sub(1).filter(|last| last % stride != 0);
    (0..samples).step_by(stride).chain(last).map(drawing).collect()
}

/// How many positions of a mechanism are drawn.
pub(super) fn poses(description: &Description) -> usize {
    if Shapes::of(description).are_crowded() { FEW_POSES } else { POSES }
}

/// So many samples at equal times through the period, or where positions differ most, in the order of time.
fn chosen(run: &dyn Recorded, outcome: &Outcome, times: &[f64], poses: usize) -> Vec<Row> {
    let Some(period) = outcome.period else { return most_different(run, outcome.samples, poses) };
    let nearest = |wanted: f64| {
        let apart = |index: &usize| (times[*index] - wanted).abs();
        (0..times.len()).min_by(|a, b| apart(a).total_cmp(&apart(b)))
    };
    let mut chosen: Vec<usize> = (0..poses).filter_map(|i| nearest(period * i as f64 / poses as f64)).collect();
    chosen.dedup_by(|a, b| times[*a] == times[*b]);
    chosen.into_iter().map(|index| run.row(index)).collect()
}

/// The first sample, then repeatedly the one whose drawing differs most from all before: at equal times an oscillation
/// could seem to stand still.
fn most_different(run: &dyn Recorded, samples: usize, poses: usize) -> Vec<Row> {
    let stride = samples.div_ceil(MOST_CANDIDATES).max(1);
    let candidates: Vec<Row> = (0..samples).step_by(stride).map(|index| run.row(index)).collect();
    let apart = |a: usize, b: usize| {
        let squares = candidates[a].drawing.iter().zip(&candidates[b].drawing).map(|(x, y)| (x - y) * (x - y));
        squares.filter(|square| square.is_finite()).sum::<f64>()
    };
    let mut nearest = vec![f64::INFINITY; candidates.len()];
    let mut taken: Vec<usize> = Vec::new();
    let mut next = (!candidates.is_empty()).then_some(0);
    while let Some(index) = next.filter(|_| taken.len() < poses) {
        taken.push(index);
        nearest.iter_mut().enumerate().for_each(|(other, best)| *best = best.min(apart(index, other)));
        let farthest = (0..candidates.len()).max_by(|a, b| nearest[*a].total_cmp(&nearest[*b]).then(b.cmp(a)));
        next = farthest.filter(|farthest| nearest[*farthest] > 0.0);
    }
    candidates.into_iter().enumerate().filter(|(index, _)| taken.contains(index)).map(|(_, row)| row).collect()
}
