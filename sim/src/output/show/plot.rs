//! Curves over a common abscissa, in one panel or several.

use super::decimate::decimate;
use super::frame::{Entry, Frame, Legend, Names, Style, apart, bottom_room, left_room, right_room, top_room};
use super::palette::{round, series};
use super::scene::{Point, Scene};
use super::text::typeset;
use super::ticks::{Axis, Round, padded, range, shown};
use super::{Plot, ShowError, Size};

/// The width of curves.
const STROKE: f64 = 2.0;
/// The width of columns in which curves are thinned out: half a logical pixel.
const COLUMN: f64 = 0.5;
/// The distance of ticks of the ordinate, and the least where they would be few.
const TICKS: (f64, f64) = (42.0, 20.0);
/// From one panel to the next.
const GAP: f64 = 22.0;
/// Curves longer than this are not broken: they would be all pieces.
const LONGEST_BROKEN: f64 = 20_000.0;

/// Lays out plots as panels below each other, over one abscissa: that of the last names it.
pub(super) fn scene(panels: &[Plot], size: Size, name: &str) -> Result<Scene, ShowError> {
    let Some(last) = panels.last() else { return Err(ShowError::empty(name, "no panels")) };
    panels.iter().try_for_each(|panel| check(panel, name))?;
    let x_range = range(panels.iter().flat_map(|panel| panel.x.iter().copied()));
    let x_range = x_range.ok_or_else(|| ShowError::empty(name, "no value is finite"))?;
    let y_ranges: Vec<Point> = panels.iter().map(|panel| y_range(panel, name)).collect::<Result<_, _>>()?;

    let title = typeset(panels.iter().map(|panel| panel.title).find(|title| !title.is_empty()).unwrap_or(""));
    let room = size.height - bottom_room() - 60.0;
    let share = (room - GAP * (panels.len() - 1) as f64) / panels.len() as f64;
    if share < 60.0 {
        return Err(ShowError::Draw(format!("{} panels need a figure higher than {}", panels.len(), size.height)));
    }
    // Whether there is a note above, which depends on the ticks, takes little room from them.
    let axis = |(range, panel): (&Point, &Plot)| Axis::fitted(*range, share, TICKS, Round::of(&names(panel).1));
    let axes: Vec<Axis> = y_ranges.iter().zip(panels).map(axis).collect();
    let legends: Vec<Legend> = panels
        .iter()
        .map(|panel| match panels.len() {
            1 => Legend::new(entries(panel), None, size.height - 100.0),
            _ => Legend::beside(entries(panel)),
        })
        .collect::<Result<_, _>>()?;
    let left = axes.iter().map(left_room).try_fold(0.0, |most: f64, room| room.map(|room| most.max(room)))?;
    let widest = size.width - left - legends.iter().map(Legend::width).fold(0.0, f64::max);
    let x_name = names(last).0;
    let round = Round::of(&x_name);
    let x = Axis::new(x_range, apart(x_range, widest - 30.0, round)?, round);
    let right = left + widest - right_room(&x)?;
    let notes: Vec<f64> = axes.iter().map(|axis| top_room("", axis) - top_room("", &axis.without_note())).collect();
    let first_top = top_room(&title, &axes[0]);
    let height =
        (size.height - bottom_room() - first_top - GAP * (panels.len() - 1) as f64 - notes.iter().skip(1).sum::<f64>())
            / panels.len() as f64;

    let below = if panels.len() == 1 { legends[0].height(size.width) } else { 0.0 };
    let mut scene = Scene::new(size.width, size.height + below);
    let mut top = first_top;
    for (index, (panel, y)) in panels.iter().zip(axes).enumerate() {
        let is_last = index + 1 == panels.len();
        let x = if is_last { x.clone() } else { x.without_labels() };
        let frame = Frame { left, right, top, bottom: top + height, x, y, zero: true };
        let shown = Names {
            title: if index == 0 { &title } else { "" },
            x: if is_last { &x_name } else { "" },
            y: &names(panel).1,
        };
        frame.draw(&mut scene, &shown)?;
        for (index, curve) in panel.curves.iter().enumerate() {
            for piece in pieces(panel.x, &curve.values) {
                draw(&mut scene, piece.into_iter().map(|point| frame.place(point)).collect(), index);
            }
        }
        legends[index].draw(&mut scene, &frame)?;
        top = frame.bottom + GAP + notes.get(index + 1).copied().unwrap_or(0.0);
    }
    Ok(scene)
}

fn y_range(plot: &Plot, name: &str) -> Result<Point, ShowError> {
    let values = plot.curves.iter().flat_map(|curve| pieces(plot.x, &curve.values)).flatten();
    let found = range(values.map(|point| point.1)).ok_or_else(|| ShowError::empty(name, "no value is finite"))?;
    Ok(padded(found, 0.05))
}

fn check(plot: &Plot, name: &str) -> Result<(), ShowError> {
    if plot.curves.is_empty() {
        return Err(ShowError::empty(name, "no curves"));
    }
    if plot.x.is_empty() {
        return Err(ShowError::empty(name, "no abscissae"));
    }
    match plot.curves.iter().find(|curve| curve.values.len() != plot.x.len()) {
        None => Ok(()),
        Some(curve) => Err(ShowError::Curve {
            figure: name.to_owned(),
            curve: curve.label.to_owned(),
            values: curve.values.len(),
            abscissae: plot.x.len(),
        }),
    }
}

/// What the axes are called.
fn names(plot: &Plot) -> (String, String) {
    let y = match plot.curves.as_slice() {
        [curve] if plot.y_label.is_empty() => curve.label,
        _ => plot.y_label,
    };
    (typeset(plot.x_label), typeset(y))
}

/// The legend's entries: none for a single curve.
fn entries(plot: &Plot) -> Vec<Entry> {
    let curves = if plot.curves.len() > 1 { plot.curves.as_slice() } else { &[] };
    let entry = |(index, label)| Entry { label, colour: series(index), width: 2.5, style: style(index) };
    curves.iter().map(|curve| typeset(curve.label)).enumerate().map(entry).collect()
}

fn style(index: usize) -> Style {
    match round(index) {
        0 => Style::Solid,
        1 => Style::Dashed,
        _ => Style::Dotted,
    }
}

/// The pieces of a curve between its gaps.
fn pieces(x: &[f64], values: &[f64]) -> Vec<Vec<Point>> {
    let points: Vec<Point> = x.iter().copied().zip(values.iter().copied()).collect();
    let pieces = points.split(|point| !shown(point.0) || !shown(point.1));
    pieces.filter(|piece| !piece.is_empty()).map(<[Point]>::to_vec).collect()
}

/// Draws a piece of a curve; a lone point as a dot.
fn draw(scene: &mut Scene, piece: Vec<Point>, index: usize) {
    let points = decimate(&piece, COLUMN);
    if let [lone] = points.as_slice() {
        scene.disc(*lone, 1.5 * STROKE, series(index));
        return;
    }
    let length: f64 = points.windows(2).map(|pair| (pair[1].0 - pair[0].0).hypot(pair[1].1 - pair[0].1)).sum();
    let style = if length > LONGEST_BROKEN { Style::Solid } else { style(index) };
    for line in style.lines(points) {
        scene.line(line, STROKE, series(index));
    }
}
