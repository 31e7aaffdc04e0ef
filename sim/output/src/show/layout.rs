//! What every figure has to be: labels apart and on the sheet, a few ticks, units, equal scales, paths.

use super::font::Font;
use super::palette::{AXIS, series};
use super::scene::{Anchor, Label, Mark, Point, Scene};
use super::{Curve, Length, Plot, Pose, Positions, Shapes, Size, mechanism, plot};
use sim_kernel::Shape;

/// Left, top, right, bottom.
type Bounds = (f64, f64, f64, f64);

fn labels(scene: &Scene) -> Vec<&Label> {
    scene.marks.iter().filter_map(|mark| if let Mark::Label(label) = mark { Some(label) } else { None }).collect()
}

/// From below the base line to the top of capitals.
fn reach(label: &Label) -> Bounds {
    let width = Font::get().unwrap().width(&label.text) * label.size;
    let before = match label.anchor {
        Anchor::Start => 0.0,
        Anchor::Middle => width / 2.0,
        Anchor::End => width,
    };
    let ((x, y), above, below) = (label.at, 0.72 * label.size, 0.2 * label.size);
    match label.upwards {
        true => (x - above, y - width + before, x + below, y + before),
        false => (x - before, y - above, x - before + width, y + below),
    }
}

fn assert_apart(scene: &Scene, what: &str) {
    let labels = labels(scene);
    for (index, label) in labels.iter().enumerate() {
        let (left, top, right, bottom) = reach(label);
        let inside = left >= 0.0 && top >= 0.0 && right <= scene.width && bottom <= scene.height;
        assert!(inside, "{what}: `{}` leaves the sheet", label.text);
        for other in &labels[..index] {
            let (l, t, r, b) = reach(other);
            let apart = r <= left || right <= l || b <= top || bottom <= t;
            assert!(apart, "{what}: `{}` lies over `{}`", label.text, other.text);
        }
    }
}

/// Top and bottom of each data area.
fn panels(scene: &Scene) -> Vec<(f64, f64)> {
    let corners = scene.marks.iter().filter_map(|mark| match mark {
        Mark::Line { points, colour, .. } if points.len() == 3 && *colour == AXIS => Some(points),
        _ => None,
    });
    corners.map(|points| (points[0].1, points[1].1)).collect()
}

/// Labels left of a data area.
fn ticks(scene: &Scene, (top, bottom): (f64, f64)) -> usize {
    let is_tick = |label: &&&Label| label.anchor == Anchor::End && label.at.1 >= top && label.at.1 <= bottom + 10.0;
    labels(scene).iter().filter(is_tick).count()
}

const NAMES: [&str; 6] = [
    "angle of the crank [deg]",
    "x6 [m]",
    "x6_velocity [m/s]",
    "x6_acceleration [m/s^2]",
    "normal_force_slider3 [N]",
    "the_longest_name_that_anybody_could_think_of_for_an_output [kg*m^2/s^2]",
];

/// Quantities of all sizes.
fn wave(index: usize, x: &[f64]) -> Vec<f64> {
    let (size, middle) = (10_f64.powf(1.7 * index as f64 - 5.0), [0.0, 3.0, -0.4][index % 3]);
    x.iter().map(|x| size * (middle + (9.0 * x).sin())).collect()
}

fn stack<'a>(count: usize, x: &'a [f64]) -> Vec<Plot<'a>> {
    let plot = |index: usize| {
        let curves =
            (0..=index % 3 * 3).map(|curve| Curve { label: NAMES[curve % 6], values: wave(index + curve % 2, x) });
        let title = "Quantities of a mechanism";
        Plot { title, x_label: "time [s]", y_label: NAMES[index % 6], x, curves: curves.collect() }
    };
    (0..count).map(plot).collect()
}

#[test]
fn labels_of_stacked_plots_are_apart_and_have_units_and_ticks() {
    let x: Vec<f64> = (0..=200).map(|step| 0.01 * f64::from(step)).collect();
    for (width, height) in [(960.0, 540.0), (640.0, 240.0), (2000.0, 300.0), (960.0, 3000.0)] {
        for count in [1, 2, 3, 5, 8, 12] {
            let scene = plot::scene(&stack(count, &x), Size { width, height }, "stack").unwrap();
            let what = format!("{count} on {width} x {height}");
            assert_apart(&scene, &what);
            assert!(scene.width == width && scene.height >= height);
            let panels = panels(&scene);
            assert_eq!(panels.len(), count);
            for panel in panels {
                let least = if panel.1 - panel.0 < 151.0 { 2 } else { 3 };
                assert!(ticks(&scene, panel) >= least, "{what}: {panel:?}");
            }
            let units = ["[deg]", "[m]", "[m/s]", "[m/s²]", "[N]", "[kg·m²/s²]"];
            let has = |unit: &str| labels(&scene).iter().any(|label| label.text.ends_with(unit));
            let missing: Vec<&&str> = units.iter().take(count).filter(|unit| !has(unit)).collect();
            assert!(missing.is_empty(), "{what}: {missing:?}");
        }
    }
}

#[test]
fn ticks_of_angles_are_parts_of_a_turn() {
    let x: Vec<f64> = (0..=360).map(f64::from).collect();
    let curves = vec![Curve { label: "rocker", values: x.iter().map(|x| x / 2.0).collect() }];
    let plot = Plot { title: "", x_label: "crank [deg]", y_label: "rocker [deg]", x: &x, curves };
    let scene = plot::scene(&[plot], Size::default(), "angles").unwrap();
    let found: Vec<&str> = labels(&scene).iter().map(|label| label.text.as_str()).collect();
    let ticks: Vec<i32> = found.iter().filter_map(|text| text.parse().ok()).collect();
    assert!(ticks.contains(&90) && ticks.contains(&180) && ticks.contains(&360), "{found:?}");
    assert!(ticks.iter().all(|tick| [15, 30, 45].iter().any(|part| tick % part == 0)), "{found:?}");
}

/// The extent of what is drawn in the colour of the first curve or link.
fn extent(scene: &Scene, width: f64) -> Point {
    let drawn = scene.marks.iter().filter_map(|mark| match mark {
        Mark::Line { points, width: own, colour } if *colour == series(0) && *own == width => Some(points),
        _ => None,
    });
    let points: Vec<Point> = drawn.flatten().copied().collect();
    let range = |part: fn(&Point) -> f64| {
        let values = points.iter().map(part);
        values.clone().fold(f64::NEG_INFINITY, f64::max) - values.fold(f64::INFINITY, f64::min)
    };
    (range(|point| point.0), range(|point| point.1))
}

/// An ellipse of 3 m by 1000 mm, lying and upright, on sheets of both kinds.
#[test]
fn paths_are_to_one_scale() {
    let turns: Vec<f64> = (0..=720).map(|step| f64::from(step).to_radians() / 2.0).collect();
    for (width, height) in [(960.0, 540.0), (400.0, 900.0)] {
        for (a, b) in [(3.0, 1.0), (1.0, 3.0), (1.0, 40.0)] {
            let x: Vec<f64> = turns.iter().map(|turn| 7.0 + a / 2.0 * turn.cos()).collect();
            let values = turns.iter().map(|turn| 500.0 * b * turn.sin()).collect();
            let curves = vec![Curve { label: "y [mm]", values }];
            let plot = Plot { title: "Path", x_label: "x [m]", y_label: "", x: &x, curves };
            let scene = plot::path(&plot, 1e-3, Size { width, height }, "path").unwrap();
            let found = extent(&scene, 2.0);
            assert!((found.1 * a - found.0 * b).abs() < 1.5 * a.max(b), "{found:?}");
            assert!(found.0 > 0.6 * (width - 150.0) || found.1 > 0.6 * (height - 150.0), "{found:?}");
            assert_apart(&scene, "path");
        }
    }
}

/// A link of 0.4 m that turns about the origin, and its end's path.
#[test]
fn mechanisms_are_drawn_in_their_unit_with_the_paths_of_traced_points() {
    let numbers = |turn: f64| vec![0.0, 0.0, 0.4 * turn.cos(), 0.4 * turn.sin(), 0.4 * turn.cos(), 0.4 * turn.sin()];
    let mut motion: Vec<Vec<f64>> = (0..=360).map(|turn| numbers(f64::from(turn).to_radians())).collect();
    motion[90][5] = f64::NAN;
    let first = motion[0].clone();
    let poses = [Pose { numbers: &first, at: 0.0 }];
    let shapes = Shapes { dimension: 2, shapes: &[Shape::Line(2), Shape::Trace(1)] };
    let unit = Length { name: "mm", metres: 1e-3 };
    let positions = Positions { title: "link", shapes, unit, heading: "alpha [deg]", poses: &poses, motion: &motion };
    let scene = mechanism::scene(&positions, Size::default(), "link").unwrap();
    let found: Vec<&str> = labels(&scene).iter().map(|label| label.text.as_str()).collect();
    assert!(["x [mm]", "y [mm]", "alpha [deg]", "200", "400"].iter().all(|text| found.contains(text)), "{found:?}");
    assert_apart(&scene, "link");

    let link = extent(&scene, 4.0).0;
    let paths: Vec<&Vec<Point>> = scene
        .marks
        .iter()
        .filter_map(|mark| match mark {
            Mark::Line { points, colour, width } if *colour == series(1) && *width == 1.5 => Some(points),
            _ => None,
        })
        .collect();
    assert_eq!(paths.len(), 2, "a gap");
    let centre = (paths[0][0].0 - link, paths[0][0].1);
    for point in paths.into_iter().flatten() {
        let radius = (point.0 - centre.0).hypot(point.1 - centre.1);
        assert!((radius - link).abs() < 0.01 * link, "{radius} {link}");
    }
    let bare = Positions { motion: &[], ..positions };
    assert!(mechanism::scene(&bare, Size::default(), "link").unwrap().height < scene.height, "the path is not framed");
}
