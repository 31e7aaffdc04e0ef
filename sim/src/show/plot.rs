//! Curves over a common abscissa.

use super::decimate::decimate;
use super::frame::{Entry, Frame, Legend, Names, Style, apart, bottom_room, left_room, right_room, top_room};
use super::palette::{round, series};
use super::scene::{Point, Scene};
use super::text::typeset;
use super::ticks::{Axis, padded, range, shown};
use super::{Plot, ShowError};

const WIDTH: f64 = 960.0;
const HEIGHT: f64 = 540.0;

/// The width of curves.
const STROKE: f64 = 2.0;
/// The width of columns in which curves are thinned out: half a logical pixel.
const COLUMN: f64 = 0.5;
/// The least distance of ticks of the ordinate.
const APART: f64 = 42.0;
/// Curves longer than this are not broken: they would be all pieces.
const LONGEST_BROKEN: f64 = 20_000.0;

/// Lays out a plot.
pub(super) fn scene(plot: &Plot, name: &str) -> Result<Scene, ShowError> {
    check(plot, name)?;
    let nothing = || ShowError::empty(name, "no value is finite");
    let values = plot.curves.iter().flat_map(|curve| pieces(plot.x, &curve.values)).flatten();
    let x_range = range(plot.x.iter().copied()).ok_or_else(nothing)?;
    let y_range = padded(range(values.map(|point| point.1)).ok_or_else(nothing)?, 0.05);

    let (title, names) = (typeset(plot.title), names(plot));
    let legend = Legend::new(entries(plot), None, HEIGHT - 100.0)?;
    let height = HEIGHT + legend.height(WIDTH);
    let bottom = HEIGHT - bottom_room();
    // Whether there is a note above, which depends on the ticks, takes little room from them.
    let distance = APART / (bottom - 60.0) * (y_range.1 - y_range.0);
    let y = Axis::new(y_range, distance);
    let (left, top) = (left_room(&y)?, top_room(&title, &y));
    let widest = WIDTH - left - legend.width();
    let x = Axis::new(x_range, apart(x_range, widest - 30.0)?);
    let right = left + widest - right_room(&x)?;
    let frame = Frame { left, right, top, bottom, x, y, zero: true };

    let mut scene = Scene::new(WIDTH, height);
    frame.draw(&mut scene, &Names { title: &title, x: &names.0, y: &names.1 })?;
    for (index, curve) in plot.curves.iter().enumerate() {
        for piece in pieces(plot.x, &curve.values) {
            draw(&mut scene, piece.into_iter().map(|point| frame.place(point)).collect(), index);
        }
    }
    legend.draw(&mut scene, &frame)?;
    Ok(scene)
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
