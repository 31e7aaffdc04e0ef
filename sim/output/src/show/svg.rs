//! A scene as SVG.

use std::fmt::{self, Write};

use super::palette::{Colour, WHITE};
use super::scene::{Anchor, Label, Mark, Point, Scene};
use sim_runtime::Provenance;

/// The document; where it comes from is its metadata, as JSON.
pub(super) fn document(scene: &Scene, provenance: &Provenance) -> String {
    let (width, height) = (scene.width, scene.height);
    let mut svg = format!(
        "<svg xmlns=\"http://www.w3.org/2000/svg\" width=\"{width}\" height=\"{height}\" \
         viewBox=\"0 0 {width} {height}\" fill=\"none\" stroke-linejoin=\"round\" stroke-linecap=\"round\" \
         font-family=\"Roboto, sans-serif\">\n<metadata>{}</metadata>\n\
         <rect width=\"{width}\" height=\"{height}\" fill=\"{WHITE}\"/>\n",
        escaped(&provenance.to_json().to_string())
    );
    for mark in &scene.marks {
        // Writing to a string does not fail.
        let _ = write_mark(&mut svg, mark);
    }
    svg.push_str("</svg>\n");
    svg
}

fn write_mark(svg: &mut String, mark: &Mark) -> fmt::Result {
    match mark {
        Mark::Line { points, width, colour } => {
            let mut places: Vec<String> = points.iter().map(place).collect();
            places.dedup();
            // A line shorter than a tenth consists of its round ends.
            if let ([_], [lone, ..]) = (places.as_slice(), points.as_slice()) {
                return write_disc(svg, lone, width / 2.0, colour);
            }
            let width = decimal(*width, 100.0);
            writeln!(svg, "<polyline points=\"{}\" stroke=\"{colour}\" stroke-width=\"{width}\"/>", places.join(" "))
        }
        Mark::Area { points, colour } => {
            let places: Vec<String> = points.iter().map(place).collect();
            writeln!(svg, "<polygon points=\"{}\" fill=\"{colour}\"/>", places.join(" "))
        }
        Mark::Disc { centre, radius, colour } => write_disc(svg, centre, *radius, colour),
        Mark::Label(label) => write_label(svg, label),
    }
}

fn write_disc(svg: &mut String, centre: &Point, radius: f64, colour: &Colour) -> fmt::Result {
    let (x, y, radius) = (decimal(centre.0, 10.0), decimal(centre.1, 10.0), decimal(radius, 100.0));
    writeln!(svg, "<circle cx=\"{x}\" cy=\"{y}\" r=\"{radius}\" fill=\"{colour}\"/>")
}

fn write_label(svg: &mut String, label: &Label) -> fmt::Result {
    let anchor = match label.anchor {
        Anchor::Start => "start",
        Anchor::Middle => "middle",
        Anchor::End => "end",
    };
    let (x, y, size) = (decimal(label.at.0, 10.0), decimal(label.at.1, 10.0), decimal(label.size, 100.0));
    let turn = if label.upwards { format!(" transform=\"rotate(-90 {x} {y})\"") } else { String::new() };
    writeln!(
        svg,
        "<text x=\"{x}\" y=\"{y}\"{turn} text-anchor=\"{anchor}\" font-size=\"{size}\" fill=\"{}\">{}</text>",
        label.colour,
        escaped(&label.text)
    )
}

fn place(point: &Point) -> String {
    format!("{},{}", decimal(point.0, 10.0), decimal(point.1, 10.0))
}

/// A length to tenths or hundredths, where 0 has no sign.
fn decimal(length: f64, parts: f64) -> f64 {
    (length * parts).round() / parts + 0.0
}

/// The text escaped for XML, without control characters.
fn escaped(text: &str) -> String {
    let mut escaped = String::with_capacity(text.len());
    for letter in text.chars() {
        match letter {
            '&' => escaped.push_str("&amp;"),
            '<' => escaped.push_str("&lt;"),
            '>' => escaped.push_str("&gt;"),
            '\u{fffe}' | '\u{ffff}' => escaped.push('\u{fffd}'),
            _ if letter.is_control() => escaped.push(' '),
            _ => escaped.push(letter),
        }
    }
    escaped
}

#[cfg(test)]
mod tests {
    use super::*;

    fn lines(scene: &Scene) -> Vec<String> {
        document(scene, &Provenance::default()).lines().skip(3).map(str::to_owned).collect()
    }

    #[test]
    fn marks_are_elements() {
        let mut scene = Scene::new(100.0, 50.0);
        scene.line(vec![(0.0, -0.01), (1.26, 2.0), (1.31, 2.04), (1.0 / 3.0, 9.0)], 1.25, Colour(0, 158, 115));
        scene.line(vec![(4.0, 4.0), (4.01, 4.0)], 3.0, WHITE);
        scene.area(vec![(0.0, 0.0), (1.0, 0.0), (0.0, 1.0)], WHITE);
        let written = lines(&scene);
        assert_eq!(written[0], "<polyline points=\"0,0 1.3,2 0.3,9\" stroke=\"#009e73\" stroke-width=\"1.25\"/>");
        assert_eq!(written[1], "<circle cx=\"4\" cy=\"4\" r=\"1.5\" fill=\"#ffffff\"/>");
        assert_eq!(written[2], "<polygon points=\"0,0 1,0 0,1\" fill=\"#ffffff\"/>");
        assert_eq!(written[3..], ["</svg>"]);
    }

    #[test]
    fn any_text_can_be_written() {
        let mut scene = Scene::new(100.0, 50.0);
        let (text, at, anchor) = ("a<b & \"c\"\u{0}\u{ffff}>".to_owned(), (5.0, 20.0), Anchor::End);
        scene.label(Label { text, at, size: 15.0, anchor, upwards: true, colour: WHITE });
        let written = lines(&scene);
        assert!(written[0].starts_with("<text x=\"5\" y=\"20\" transform=\"rotate(-90 5 20)\" text-anchor=\"end\""));
        assert!(written[0].ends_with(">a&lt;b &amp; \"c\" \u{fffd}&gt;</text>"), "{written:?}");
        let provenance = Provenance { command: Some("sim plot --title 'a<b & \"c\"'".into()), ..Provenance::default() };
        let text = document(&scene, &provenance);
        let read = roxmltree::Document::parse(&text).unwrap();
        let metadata = read.descendants().find(|node| node.has_tag_name("metadata")).and_then(|node| node.text());
        assert_eq!(serde_json::from_str::<serde_json::Value>(metadata.unwrap()).unwrap(), provenance.to_json());
    }
}
