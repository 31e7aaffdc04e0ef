//! Curves over a common abscissa, in one panel or several.

use super::decimate::decimate;
use super::frame::{Entry, Frame, LINE, Legend, Names, Style, apart, bottom_room, left_room, right_room, top_room};
use super::palette::{round, series};
use super::scene::{Point, Scene};
use super::text::typeset;
use super::ticks::{Axis, Round, padded, range, shown};
use super::{Plot, ShowError, Size};

/// The width of curves.
const STROKE: f64 = 2.0;
/// The width of the columns for thinning curves: half a logical pixel.
const COLUMN: f64 = 0.5;
/// The distance of ticks of the ordinate, and the least where they would be few.
const TICKS: (f64, f64) = (42.0, 20.0);
/// The height of the lowest panels, which have three ticks nearly always and two in any case.
const LOWEST: f64 = 120.0;
/// From one panel to the name of the next.
const GAP: f64 = 20.0;
/// The share of its range by which the ordinate goes beyond it at both ends.
const PADDING: f64 = 0.05;
/// Curves longer than this are not dashed: they would be all pieces.
const LONGEST_BROKEN: f64 = 20_000.0;

/// Lays out plots: one alone, or several as panels below each other, over one abscissa that the last of them names.
pub(super) fn scene(panels: &[Plot], size: Size, name: &str) -> Result<Scene, ShowError> {
    match panels {
        [] => Err(ShowError::empty(name, "no panels")),
        [plot] => alone(plot, None, size, name),
        _ => stacked(panels, size, name),
    }
}

/// Lays out a plot of lengths against a length, both to one scale: `ratio` is the ordinate's unit by the abscissa's.
pub(super) fn path(plot: &Plot, ratio: f64, size: Size, name: &str) -> Result<Scene, ShowError> {
    alone(plot, Some(ratio), size, name)
}

fn alone(plot: &Plot, ratio: Option<f64>, size: Size, name: &str) -> Result<Scene, ShowError> {
    check(plot, name)?;
    let (title, (x_name, y_name)) = (typeset(plot.title), names(plot));
    let rounds = (Round::of(&x_name), Round::of(&y_name));
    let found = (x_range(std::slice::from_ref(plot), name)?, y_range(plot, name)?);
    let legend = Legend::new(entries(plot), None, size.height - 100.0)?;
    let bottom = size.height - bottom_room();
    // With a note there is a little less room than ticks are chosen for.
    let y_axis = |range: Point| Axis::fitted(range, bottom - top_room(&title, true), TICKS, rounds.1);
    let mut y = y_axis(found.1);
    let (mut left, mut right, mut x) = (0.0, 0.0, y.clone());
    // To one scale both ranges depend on the room that the labels leave.
    for _ in 0..if ratio.is_some() { 3 } else { 1 } {
        left = left_room(&y, true)?;
        let widest = size.width - left - legend.width();
        let room = (widest - 30.0, bottom - top_room(&title, y.note.is_some()));
        let ranges = ratio.map_or(found, |ratio| to_one_scale((padded(found.0, PADDING), found.1), ratio, room));
        x = Axis::new(ranges.0, apart(ranges.0, room.0, rounds.0)?, rounds.0);
        right = left + widest - right_room(&x)?;
        y = y_axis(ranges.1);
    }
    let top = top_room(&title, y.note.is_some());
    if let Some(ratio) = ratio {
        let (x_range, y_range) = to_one_scale(((x.low, x.high), (y.low, y.high)), ratio, (right - left, bottom - top));
        (x.low, x.high) = x_range;
        (y.low, y.high) = y_range;
    }
    let mut scene = Scene::new(size.width, size.height + legend.height(size.width));
    let frame = Frame { left, right, top, bottom, x, y, zero: true };
    frame.draw(&mut scene, &Names { title: &title, x: &x_name, y: &y_name, above: false })?;
    draw_curves(&mut scene, &frame, plot);
    legend.draw(&mut scene, &frame)?;
    Ok(scene)
}

/// The ranges with one of them widened, so that one scale fills the room with both.
fn to_one_scale((x, y): (Point, Point), ratio: f64, (width, height): (f64, f64)) -> (Point, Point) {
    let (x_scale, y_scale) = (width / (x.1 - x.0), height / (y.1 - y.0) / ratio);
    let widened = |range: Point, by: f64| padded(range, (by - 1.0) / 2.0);
    if x_scale > y_scale { (widened(x, x_scale / y_scale), y) } else { (x, widened(y, y_scale / x_scale)) }
}

/// Panels that are too low for their ticks or their legends make the figure higher.
fn stacked(panels: &[Plot], size: Size, name: &str) -> Result<Scene, ShowError> {
    panels.iter().try_for_each(|panel| check(panel, name))?;
    let x_range = x_range(panels, name)?;
    let title = typeset(panels.iter().map(|panel| panel.title).find(|title| !title.is_empty()).unwrap_or(""));
    let names: Vec<(String, String)> = panels.iter().map(names).collect();
    let legends: Vec<Legend> = panels.iter().map(|panel| Legend::beside(entries(panel))).collect::<Result<_, _>>()?;
    let between = GAP + LINE;
    let all = size.height - top_room(&title, true) - bottom_room() - between * (panels.len() - 1) as f64;
    let share = all / panels.len() as f64;
    let heights: Vec<f64> = legends.iter().map(|legend| share.max(LOWEST).max(legend.rows())).collect();
    let mut axes = Vec::with_capacity(panels.len());
    for ((panel, name_of), height) in panels.iter().zip(&names).zip(&heights) {
        axes.push(Axis::fitted(y_range(panel, name)?, *height, TICKS, Round::of(&name_of.1)));
    }

    let left =
        axes.iter().map(|y| left_room(y, false)).try_fold(0.0, |most: f64, room| room.map(|room| most.max(room)))?;
    let widest = size.width - left - legends.iter().map(Legend::width).fold(0.0, f64::max);
    let x_name = names.last().map_or("", |names| &names.0);
    let round = Round::of(x_name);
    let x = Axis::new(x_range, apart(x_range, widest - 30.0, round)?, round);
    let right = left + widest - right_room(&x)?;

    let mut top = top_room(&title, true);
    let below = top + heights.iter().sum::<f64>() + between * (panels.len() - 1) as f64 + bottom_room();
    let mut scene = Scene::new(size.width, below.max(size.height).ceil());
    for (index, (panel, y)) in panels.iter().zip(axes).enumerate() {
        let is_last = index + 1 == panels.len();
        let x = if is_last { x.clone() } else { x.without_labels() };
        let frame = Frame { left, right, top, bottom: top + heights[index], x, y, zero: true };
        let title = if index == 0 { title.as_str() } else { "" };
        let x = if is_last { x_name } else { "" };
        frame.draw(&mut scene, &Names { title, x, y: &names[index].1, above: true })?;
        draw_curves(&mut scene, &frame, panel);
        legends[index].draw(&mut scene, &frame)?;
        top = frame.bottom + between;
    }
    Ok(scene)
}

fn draw_curves(scene: &mut Scene, frame: &Frame, plot: &Plot) {
    for (index, curve) in plot.curves.iter().enumerate() {
        for piece in pieces(plot.x, &curve.values) {
            draw(scene, piece.into_iter().map(|point| frame.place(point)).collect(), index);
        }
    }
}

fn x_range(panels: &[Plot], name: &str) -> Result<Point, ShowError> {
    let found = range(panels.iter().flat_map(|panel| panel.x.iter().copied()));
    found.ok_or_else(|| ShowError::empty(name, "no value is finite"))
}

fn y_range(plot: &Plot, name: &str) -> Result<Point, ShowError> {
    let values = plot.curves.iter().flat_map(|curve| pieces(plot.x, &curve.values)).flatten();
    let found = range(values.map(|point| point.1)).ok_or_else(|| ShowError::empty(name, "no value is finite"))?;
    Ok(padded(found, PADDING))
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

/// The labels of the axes.
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
