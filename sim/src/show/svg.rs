//! A scene as SVG.

use std::fmt::Display;

use plotters::backend::{DrawingBackend, SVGBackend};
use plotters::style::text_anchor::{HPos, Pos, VPos};
use plotters::style::{Color, FontDesc, FontFamily, FontStyle, FontTransform, RGBColor, TextStyle};

use super::ShowError;
use super::palette::{Colour, WHITE};
use super::scene::{Anchor, Label, Mark, Point, Scene};

/// Coordinates are whole numbers: tenths of a logical pixel.
const SCALE: f64 = 10.0;

/// The backend writes fonts smaller than they are given, by this factor.
const FONT_SCALE: f64 = 1.24;

/// The backend puts the base line of text anchored at its top this far down, in em.
const BASE_LINE: f64 = 0.76;

/// The document.
pub(super) fn draw(scene: &Scene) -> Result<String, ShowError> {
    let mut document = String::new();
    let size = (whole(scene.width).unsigned_abs(), whole(scene.height).unsigned_abs());
    let mut backend = SVGBackend::with_string(&mut document, size);
    let paper = RGBColor::from(WHITE).filled();
    backend.draw_rect((0, 0), (size.0 as i32, size.1 as i32), &paper, true).map_err(failed)?;
    for mark in &scene.marks {
        draw_mark(&mut backend, mark)?;
    }
    backend.present().map_err(failed)?;
    drop(backend);
    let written = format!("<svg width=\"{}\" height=\"{}\"", size.0, size.1);
    let wanted = format!(
        "<svg width=\"{}\" height=\"{}\" stroke-linejoin=\"round\" stroke-linecap=\"round\"",
        scene.width, scene.height
    );
    Ok(document.replacen(&written, &wanted, 1))
}

fn failed(why: impl Display) -> ShowError {
    ShowError::Draw(why.to_string())
}

fn whole(length: f64) -> i32 {
    (length * SCALE).round() as i32
}

fn place(point: &Point) -> (i32, i32) {
    (whole(point.0), whole(point.1))
}

fn draw_mark(backend: &mut SVGBackend, mark: &Mark) -> Result<(), ShowError> {
    match mark {
        Mark::Line { points, width, colour } => {
            let mut path: Vec<_> = points.iter().map(place).collect();
            path.dedup();
            let style = RGBColor::from(*colour).stroke_width(whole(*width).unsigned_abs());
            backend.draw_path(path, &style).map_err(failed)
        }
        Mark::Area { points, colour } => {
            backend.fill_polygon(points.iter().map(place), &filled(*colour)).map_err(failed)
        }
        Mark::Disc { centre, radius, colour } => {
            let radius = whole(*radius).unsigned_abs();
            backend.draw_circle(place(centre), radius, &filled(*colour), true).map_err(failed)
        }
        Mark::Label(label) => draw_label(backend, label),
    }
}

fn filled(colour: Colour) -> plotters::style::ShapeStyle {
    RGBColor::from(colour).filled()
}

fn draw_label(backend: &mut SVGBackend, label: &Label) -> Result<(), ShowError> {
    let font = FontDesc::new(FontFamily::SansSerif, label.size * SCALE * FONT_SCALE, FontStyle::Normal);
    let anchor = match label.anchor {
        Anchor::Start => HPos::Left,
        Anchor::Middle => HPos::Center,
        Anchor::End => HPos::Right,
    };
    let lift = BASE_LINE * label.size;
    let (transform, at) = if label.upwards {
        (FontTransform::Rotate270, (label.at.0 - lift, label.at.1))
    } else {
        (FontTransform::None, (label.at.0, label.at.1 - lift))
    };
    let colour = RGBColor::from(label.colour);
    let style = TextStyle::from(font.transform(transform)).color(&colour).pos(Pos::new(anchor, VPos::Top));
    backend.draw_text(&label.text, &style, place(&at)).map_err(failed)
}
