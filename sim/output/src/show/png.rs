//! A scene as PNG.

use std::path::Path;

use tiny_skia::{FillRule, LineCap, LineJoin, Paint, PathBuilder, Pixmap, Stroke, Transform};

use super::ShowError;
use super::chunks::with_provenance;
use super::font::Font;
use super::palette::{Colour, WHITE};
use super::scene::{Anchor, Label, Mark, Point, Scene};
use crate::whole::whole_bytes;
use sim_runtime::Provenance;

/// Pixels to a logical pixel.
const SCALE: f64 = 2.0;

/// Draws a scene and writes it to the file.
pub(super) fn write(scene: &Scene, provenance: &Provenance, path: &Path) -> Result<(), ShowError> {
    let sheet = draw(scene, Font::get()?)?;
    let bytes = sheet.encode_png().map_err(|why| ShowError::Draw(why.to_string()))?;
    whole_bytes(path, &with_provenance(bytes, provenance)).map_err(|why| ShowError::write(path, why))
}

fn draw(scene: &Scene, font: &Font) -> Result<Pixmap, ShowError> {
    let pixels = |length: f64| (length * SCALE).round() as u32;
    let sheet = Pixmap::new(pixels(scene.width), pixels(scene.height));
    let mut sheet = sheet.ok_or_else(|| ShowError::Draw("it is too large".into()))?;
    sheet.fill(colour(WHITE));
    for mark in &scene.marks {
        match mark {
            Mark::Line { points, width, colour } => line(&mut sheet, points, *width, *colour),
            Mark::Area { points, colour } => fill(&mut sheet, polyline(points, true), *colour, scaled()),
            Mark::Disc { centre, radius, colour } => disc(&mut sheet, *centre, *radius, *colour),
            Mark::Label(words) => label(&mut sheet, words, font),
        }
    }
    Ok(sheet)
}

fn line(sheet: &mut Pixmap, points: &[Point], width: f64, colour: Colour) {
    // A line without length consists of its round ends.
    if let [first, rest @ ..] = points
        && rest.iter().all(|point| point == first)
    {
        return disc(sheet, *first, width / 2.0, colour);
    }
    let Some(path) = polyline(points, false) else { return };
    let stroke =
        Stroke { width: width as f32, line_cap: LineCap::Round, line_join: LineJoin::Round, ..Stroke::default() };
    sheet.stroke_path(&path, &paint(colour), &stroke, scaled(), None);
}

fn disc(sheet: &mut Pixmap, (x, y): Point, radius: f64, colour: Colour) {
    fill(sheet, PathBuilder::from_circle(x as f32, y as f32, radius as f32), colour, scaled());
}

fn label(sheet: &mut Pixmap, label: &Label, font: &Font) {
    let width = label.size * font.width(&label.text);
    let before = match label.anchor {
        Anchor::Start => 0.0,
        Anchor::Middle => width / 2.0,
        Anchor::End => width,
    };
    let turn = if label.upwards { Transform::from_rotate(-90.0) } else { Transform::identity() };
    let place = Transform::from_translate(label.at.0 as f32, label.at.1 as f32);
    let whole = scaled().pre_concat(place).pre_concat(turn).pre_translate(-before as f32, 0.0);
    fill(sheet, font.outlines(&label.text, label.size), label.colour, whole);
}

fn fill(sheet: &mut Pixmap, path: Option<tiny_skia::Path>, colour: Colour, place: Transform) {
    if let Some(path) = path {
        sheet.fill_path(&path, &paint(colour), FillRule::Winding, place, None);
    }
}

fn polyline(points: &[Point], is_closed: bool) -> Option<tiny_skia::Path> {
    let mut path = PathBuilder::new();
    for (i, (x, y)) in points.iter().enumerate() {
        match i {
            0 => path.move_to(*x as f32, *y as f32),
            _ => path.line_to(*x as f32, *y as f32),
        }
    }
    if is_closed {
        path.close();
    }
    path.finish()
}

fn paint(of: Colour) -> Paint<'static> {
    let mut paint = Paint::default();
    paint.set_color(colour(of));
    paint
}

fn colour(Colour(red, green, blue): Colour) -> tiny_skia::Color {
    tiny_skia::Color::from_rgba8(red, green, blue, u8::MAX)
}

/// From logical pixels to those of the sheet.
fn scaled() -> Transform {
    Transform::from_scale(SCALE as f32, SCALE as f32)
}

#[cfg(test)]
mod tests {
    use super::*;

    const GREEN: Colour = Colour(0, 158, 115);

    fn is_green(sheet: &Pixmap, x: f64, y: f64) -> bool {
        let pixel = sheet.pixel((SCALE * x) as u32, (SCALE * y) as u32).unwrap();
        (pixel.red(), pixel.green(), pixel.blue()) == (0, 158, 115)
    }

    #[test]
    fn marks_are_where_they_belong() {
        let mut scene = Scene::new(100.0, 50.0);
        scene.line(vec![(10.0, 10.0), (40.0, 10.0)], 4.0, GREEN);
        scene.line(vec![(60.0, 10.0), (60.0, 10.0)], 6.0, GREEN);
        scene.area(vec![(10.0, 20.0), (30.0, 20.0), (30.0, 40.0), (10.0, 40.0)], GREEN);
        let sheet = draw(&scene, Font::get().unwrap()).unwrap();
        assert_eq!((sheet.width(), sheet.height()), (200, 100));
        for (x, y) in [(25.0, 10.0), (60.0, 10.0), (20.0, 30.0), (11.0, 21.0)] {
            assert!(is_green(&sheet, x, y), "{x}, {y}");
        }
        for (x, y) in [(25.0, 13.5), (60.0, 15.0), (32.0, 30.0), (90.0, 45.0)] {
            assert!(!is_green(&sheet, x, y), "{x}, {y}");
        }
    }

    /// A text covers the space before, around or after its place.
    #[test]
    fn texts_are_anchored() {
        let covered = |anchor, upwards| {
            let mut scene = Scene::new(100.0, 100.0);
            let (text, at) = ("HHHH".to_owned(), (50.0, 50.0));
            scene.label(Label { text, at, size: 10.0, anchor, upwards, colour: GREEN });
            let sheet = draw(&scene, Font::get().unwrap()).unwrap();
            let columns = (0..200).map(|x| (0..200).any(|y| is_green(&sheet, f64::from(x) / 2.0, f64::from(y) / 2.0)));
            let columns: Vec<bool> = columns.collect();
            [columns[..98].contains(&true), columns[102..].contains(&true)]
        };
        assert_eq!(covered(Anchor::Start, false), [false, true]);
        assert_eq!(covered(Anchor::Middle, false), [true, true]);
        assert_eq!(covered(Anchor::End, false), [true, false]);
        assert_eq!(covered(Anchor::Start, true), [true, false]);
    }
}
