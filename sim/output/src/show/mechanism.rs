//! A mechanism in several positions.

use super::frame::{Entry, Frame, Legend, Names, Style, apart, bottom_room, left_room, right_room, top_room};
use super::palette::{AXIS, INK};
use super::parts::{Part, Placed, placed};
use super::scene::{Point, Scene};
use super::text::{times, typeset};
use super::ticks::{Axis, FEW, Round};
use super::trace::{Path, paths};
use super::{Pose, Positions, ShowError, Size, symbols};

/// The largest data area, as parts of a figure's width and height.
const LARGEST: (f64, f64) = (0.75, 10.0 / 9.0);
/// Its least width and height.
const LEAST: f64 = 300.0;
/// The most poses a legend tells the values of.
const MOST_TIMES: usize = 10;
/// The margin around a spatial mechanism.
const MARGIN: f64 = 14.0;
/// The distance of ticks of the ordinate, and the least, where those of the abscissa would be few.
const TICKS: (f64, f64) = (60.0, 20.0);
/// The height of the strip below it.
const FOOT: f64 = 60.0;

/// What is drawn of a mechanism, in its unit of length.
struct Drawn {
    placed: Vec<Placed>,
    paths: Vec<Path>,
    x_range: Point,
    y_range: Point,
    /// The unit of length in logical pixels.
    scale: f64,
}

/// Lays out a drawing.
pub(super) fn scene(positions: &Positions, size: Size, name: &str) -> Result<Scene, ShowError> {
    let drawn = drawn(positions, size, name)?;
    let title = typeset(positions.title);
    if positions.shapes.dimension == 3 {
        return spatial(&title, positions, &drawn);
    }
    let Drawn { x_range, y_range, scale, .. } = drawn;
    let (width, height) = ((x_range.1 - x_range.0) * scale, (y_range.1 - y_range.0) * scale);
    let distance = apart(x_range, width, Round::Decimals)?;
    let x = Axis::new(x_range, distance, Round::Decimals);
    let y = Axis::new(y_range, distance, Round::Decimals);
    let y = if y.ticks.len() < FEW { Axis::fitted(y_range, height, TICKS, Round::Decimals) } else { y };

    let legend = legend(positions, &drawn, height)?;
    let (left, top) = (left_room(&y, true)?, top_room(&title, y.note.is_some()));
    let sheet = left + width + right_room(&x)? + legend.width();
    let frame = Frame { left, right: left + width, top, bottom: top + height, x, y, zero: false };
    let mut scene = Scene::new(sheet.ceil(), (frame.bottom + bottom_room() + legend.height(sheet.ceil())).ceil());
    let [x, y] = ["x", "y"].map(|axis| format!("{axis} [{}]", positions.unit.name));
    frame.draw(&mut scene, &Names { title: &title, x: &x, y: &y, above: false })?;
    draw(&mut scene, &frame, &drawn);
    legend.draw(&mut scene, &frame)?;
    Ok(scene)
}

/// Lays out a spatial mechanism, without axes of the sheet: a scale, and the directions of x, y and z.
fn spatial(title: &str, positions: &Positions, drawn: &Drawn) -> Result<Scene, ShowError> {
    let Drawn { x_range, y_range, scale, .. } = *drawn;
    let (width, height) = ((x_range.1 - x_range.0) * scale, (y_range.1 - y_range.0) * scale);
    let (x, y) = (Axis::bare(x_range), Axis::bare(y_range));
    let legend = legend(positions, drawn, height)?;
    let (left, top) = (MARGIN, top_room(title, false));
    let sheet = left + width + MARGIN + legend.width();
    let frame = Frame { left, right: left + width, top, bottom: top + height, x, y, zero: false };
    let foot = frame.bottom + FOOT;
    let mut scene = Scene::new(sheet.ceil(), (foot + MARGIN + legend.height(sheet.ceil())).ceil());
    frame.draw_title(&mut scene, title)?;
    draw(&mut scene, &frame, drawn);
    symbols::axes(&mut scene, (left + 50.0, foot - 26.0));
    symbols::scale(&mut scene, (left + 130.0, foot - 4.0), (positions.unit.name, scale), 0.3 * width);
    legend.draw(&mut scene, &frame)?;
    Ok(scene)
}

/// The poses and paths, the ranges of the axes and the scale.
fn drawn(positions: &Positions, size: Size, name: &str) -> Result<Drawn, ShowError> {
    let (placed, paths) = (placed(positions, name)?, paths(positions));
    let parts = placed.iter().flat_map(|pose| &pose.parts).flat_map(Part::extent);
    let points: Vec<Point> = parts.chain(paths.iter().flat_map(|path| path.points.iter().copied())).collect();
    let (x, y) = (extent(points.iter().map(|point| point.0)), extent(points.iter().map(|point| point.1)));
    let fill = |largest: f64, range: Point| (largest - 2.0 * symbols::REACH) / (range.1 - range.0);
    let room = |part: f64, side: f64| (part * side).max(LEAST);
    let scale = fill(room(LARGEST.0, size.width), x).min(fill(room(LARGEST.1, size.height), y));
    if points.is_empty() || scale == 0.0 {
        return Err(ShowError::empty(name, "no position is finite"));
    }
    // All in one point: any scale will do.
    let scale = if scale < 1e200 { scale } else { LEAST };
    let widened = |range: Point| {
        let middle = range.0 / 2.0 + range.1 / 2.0;
        let half = LEAST.max((range.1 - range.0) * scale + 2.0 * symbols::REACH) / scale / 2.0;
        (middle - half, middle + half)
    };
    Ok(Drawn { placed, paths, x_range: widened(x), y_range: widened(y), scale })
}

/// What the poses differ in, and their values.
fn legend(positions: &Positions, drawn: &Drawn, height: f64) -> Result<Legend, ShowError> {
    Legend::new(entries(positions.poses, &drawn.placed), Some(typeset(positions.heading)), height)
}

fn extent(values: impl Iterator<Item = f64>) -> Point {
    values.fold((f64::INFINITY, f64::NEG_INFINITY), |(low, high), value| (low.min(value), high.max(value)))
}

/// The values of the poses, of some where they are many.
fn entries(poses: &[Pose], placed: &[Placed]) -> Vec<Entry> {
    let last = poses.len().saturating_sub(1);
    let told = poses.len().min(MOST_TIMES);
    let indices: Vec<usize> = (0..told).map(|entry| entry * last / told.saturating_sub(1).max(1)).collect();
    let labels = times(&indices.iter().map(|index| poses[*index].at).collect::<Vec<_>>());
    let entry = |(index, label): (usize, String)| {
        let colour = INK.on_white(placed[index].strength);
        Entry { label, colour, width: if placed[index].plain { 2.0 } else { 4.0 }, style: Style::Solid }
    };
    indices.into_iter().zip(labels).map(entry).collect()
}

/// Draws curves, guides, supports and paths, then the poses from the last to the first, each from its guides up to its marked points.
fn draw(scene: &mut Scene, frame: &Frame, Drawn { placed, paths, scale, .. }: &Drawn) {
    let mut supports: Vec<Point> = Vec::new();
    for pose in placed.iter().rev() {
        for part in &pose.parts {
            match part {
                Part::Slider { centre, angle } => {
                    symbols::guide(scene, frame.place(*centre), *angle, pose.strength);
                }
                Part::Curve(points) => {
                    let points = points.iter().map(|point| frame.place(*point)).collect();
                    let draw = if pose.plain { symbols::plain } else { symbols::curve };
                    draw(scene, points, AXIS.on_white(pose.strength));
                }
                Part::Ground(points) => supports.extend(points.iter().map(|point| frame.place(*point))),
                _ => {}
            }
        }
    }
    for support in distinct(supports) {
        symbols::ground(scene, support);
    }
    for Path { points, colour } in paths {
        symbols::trace(scene, thinned(points.iter().map(|point| frame.place(*point))), *colour);
    }
    for pose in placed.iter().rev() {
        if pose.plain {
            draw_plainly(scene, frame, *scale, pose);
        } else {
            draw_bodies(scene, frame, *scale, pose);
            draw_marks(scene, frame, pose);
        }
    }
}

/// A path without places that are less than half a pixel from the one before, but with its end.
fn thinned(places: impl Iterator<Item = Point>) -> Vec<Point> {
    let mut thinned: Vec<Point> = Vec::new();
    let mut end = None;
    for place in places {
        let near = thinned.last().is_some_and(|last| (place.0 - last.0).hypot(place.1 - last.1) < 0.5);
        end = near.then_some(place);
        if !near {
            thinned.push(place);
        }
    }
    thinned.extend(end);
    thinned
}

/// Places more than half a pixel apart.
fn distinct(places: Vec<Point>) -> Vec<Point> {
    let mut distinct: Vec<Point> = Vec::new();
    for place in places {
        if distinct.iter().all(|other| (place.0 - other.0).hypot(place.1 - other.1) > 0.5) {
            distinct.push(place);
        }
    }
    distinct
}

fn draw_bodies(scene: &mut Scene, frame: &Frame, scale: f64, pose: &Placed) {
    for part in &pose.parts {
        match part {
            Part::Line { points, colour } => {
                let points = points.iter().map(|point| frame.place(*point)).collect();
                symbols::link(scene, points, colour.on_white(pose.strength));
            }
            Part::Circle { centre, radius, colour } => {
                let radius = radius.abs() * scale;
                symbols::circle(scene, frame.place(*centre), radius, colour.on_white(pose.strength));
            }
            Part::Ring { points, colour } => {
                let points = points.iter().map(|point| frame.place(*point)).collect();
                symbols::ring(scene, points, colour.on_white(pose.strength));
            }
            Part::Spring(ends) => symbols::spring(scene, ends.map(|end| frame.place(end)), INK.on_white(pose.strength)),
            Part::Damper(ends) => symbols::damper(scene, ends.map(|end| frame.place(end)), INK.on_white(pose.strength)),
            _ => {}
        }
    }
    for part in &pose.parts {
        if let Part::Slider { centre, angle } = part {
            symbols::slider(scene, frame.place(*centre), *angle, pose.strength);
        }
    }
}

/// Draws what tells a position by thin lines.
fn draw_plainly(scene: &mut Scene, frame: &Frame, scale: f64, pose: &Placed) {
    let places = |points: &[Point]| points.iter().map(|point| frame.place(*point)).collect();
    for part in &pose.parts {
        match part {
            Part::Line { points, colour } | Part::Ring { points, colour } => {
                symbols::plain(scene, places(points), colour.on_white(pose.strength));
            }
            Part::Circle { centre, radius, colour } => {
                let outline = symbols::around(frame.place(*centre), radius.abs() * scale);
                symbols::plain(scene, outline, colour.on_white(pose.strength));
            }
            Part::Spring(ends) | Part::Damper(ends) => {
                symbols::plain(scene, places(ends), INK.on_white(pose.strength));
            }
            Part::Slider { centre, angle } => symbols::slider(scene, frame.place(*centre), *angle, pose.strength),
            Part::Curve(_) | Part::Ground(_) | Part::Points(_) => {}
        }
    }
}

fn draw_marks(scene: &mut Scene, frame: &Frame, pose: &Placed) {
    for part in &pose.parts {
        if let Part::Line { points, colour } = part {
            for point in points {
                symbols::pin(scene, frame.place(*point), colour.on_white(pose.strength));
            }
        }
    }
    for part in &pose.parts {
        if let Part::Points(points) = part {
            for point in points {
                symbols::mass(scene, frame.place(*point), pose.strength);
            }
        }
    }
}
