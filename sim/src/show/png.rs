//! A scene as PNG, with two pixels to a logical one.

use std::path::Path;

use plotters::backend::{BitMapBackend, DrawingBackend};

use super::ShowError;
use super::font::Font;
use super::raster::{Canvas, Mask};
use super::scene::{Anchor, Label, Mark, Point, Scene};

/// Pixels to a logical pixel.
const SCALE: f64 = 2.0;

/// Draws the scene and writes it to the file.
pub(super) fn write(scene: &Scene, path: &Path) -> Result<(), ShowError> {
    let canvas = draw(scene)?;
    let size = (canvas.width() as u32, canvas.height() as u32);
    let mut backend = BitMapBackend::new(path, size);
    backend.blit_bitmap((0, 0), size, canvas.bytes()).map_err(|why| ShowError::write(path, why))?;
    backend.present().map_err(|why| ShowError::write(path, why))
}

fn draw(scene: &Scene) -> Result<Canvas, ShowError> {
    let mut canvas = Canvas::new((scene.width * SCALE).round() as usize, (scene.height * SCALE).round() as usize);
    for mark in &scene.marks {
        draw_mark(&mut canvas, mark)?;
    }
    Ok(canvas)
}

fn draw_mark(canvas: &mut Canvas, mark: &Mark) -> Result<(), ShowError> {
    match mark {
        Mark::Line { points, width, colour } => {
            let points = scaled(points);
            let mut mask = Mask::around(canvas, &points, width * SCALE / 2.0);
            for pair in points.windows(2) {
                mask.add_stroke(pair[0], pair[1], width * SCALE / 2.0);
            }
            canvas.lay(&mask, *colour);
        }
        Mark::Area { points, colour } => {
            let points = scaled(points);
            let mut mask = Mask::around(canvas, &points, 0.0);
            mask.add_polygon(&points);
            canvas.lay(&mask, *colour);
        }
        Mark::Disc { centre, radius, colour } => {
            let centre = (centre.0 * SCALE, centre.1 * SCALE);
            let mut mask = Mask::around(canvas, &[centre], radius * SCALE);
            mask.add_stroke(centre, centre, radius * SCALE);
            canvas.lay(&mask, *colour);
        }
        Mark::Label(label) => draw_label(canvas, label)?,
    }
    Ok(())
}

fn scaled(points: &[Point]) -> Vec<Point> {
    points.iter().map(|point| (point.0 * SCALE, point.1 * SCALE)).collect()
}

/// Letters a text: its parts of pixels come along the base line and down from it.
fn draw_label(canvas: &mut Canvas, label: &Label) -> Result<(), ShowError> {
    let font = Font::get()?;
    let size = label.size * SCALE;
    let start = match label.anchor {
        Anchor::Start => 0.0,
        Anchor::Middle => -0.5 * size * font.width(&label.text),
        Anchor::End => -size * font.width(&label.text),
    };
    let (x, y) = (label.at.0 * SCALE, label.at.1 * SCALE);
    let ends = [(start, -size), (start + size * font.width(&label.text), size)];
    let turn = |(along, down): Point| if label.upwards { (x + down, y - along) } else { (x + along, y + down) };
    let mut ink = canvas.ink_around(&ends.map(turn), size);
    font.draw(&label.text, size, |along, down, area| ink.add(turn((start + along, down)), area))?;
    canvas.lay_ink(&ink, label.colour);
    Ok(())
}
