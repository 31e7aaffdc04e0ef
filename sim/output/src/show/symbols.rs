//! The parts of a mechanism as they are drawn, in logical pixels. Drawings are scaled to fill the sheet, so
//! that these sizes are shares of a drawing's extent.

use std::f64::consts::{FRAC_PI_2, TAU};

use super::dash::dashes;
use super::palette::{AXIS, Colour, INK, WHITE};
use super::scene::{Anchor, Point, Scene};
use super::text::decimal;
use super::view;

/// The room symbols take around the points they belong to.
pub(super) const REACH: f64 = 62.0;

const LINK: f64 = 4.0;
const OUTLINE: f64 = 1.8;
const TRACE: f64 = 1.5;
/// Whatever is drawn plainly.
const PLAIN: f64 = 1.6;
const PIN: f64 = 5.0;
const MASS: f64 = 7.5;
/// Half the length and half the width of a slider.
const SLIDER: (f64, f64) = (21.0, 11.5);
/// Half the length of its guide.
const GUIDE: f64 = 58.0;
/// Half the width of springs and dampers.
const SPRING: f64 = 9.0;
/// That of short ones, relative to their length.
const STOUTEST: f64 = 0.2;
/// The length of the axes of space.
const AXES: f64 = 34.0;
/// Half the width and the height of a support.
const GROUND: (f64, f64) = (14.0, 21.0);

/// A link.
pub(super) fn link(scene: &mut Scene, points: Vec<Point>, colour: Colour) {
    scene.line(points, LINK, colour);
}

/// A link, a spring, a circle without more than its line.
pub(super) fn plain(scene: &mut Scene, points: Vec<Point>, colour: Colour) {
    scene.line(points, PLAIN, colour);
}

/// A joint.
pub(super) fn pin(scene: &mut Scene, at: Point, colour: Colour) {
    scene.disc(at, PIN + OUTLINE / 2.0, colour);
    scene.disc(at, PIN - OUTLINE / 2.0, WHITE);
}

/// A marked point, such as a centre of mass: quarters alternately dark and white.
pub(super) fn mass(scene: &mut Scene, at: Point, strength: f64) {
    let ink = INK.on_white(strength);
    scene.disc(at, MASS, ink);
    for start in [0.0, 2.0] {
        let mut quarter = arc(at, MASS - OUTLINE, start * FRAC_PI_2, FRAC_PI_2, 12);
        quarter.push(at);
        scene.area(quarter, WHITE);
    }
}

/// A slider's body.
pub(super) fn slider(scene: &mut Scene, at: Point, angle: f64, strength: f64) {
    let corner = |along: f64, across: f64| turned(at, angle, (along * SLIDER.0, across * SLIDER.1));
    let mut corners = vec![corner(-1.0, -1.0), corner(1.0, -1.0), corner(1.0, 1.0), corner(-1.0, 1.0)];
    scene.area(corners.clone(), INK.on_white(0.16 * strength));
    corners.push(corners[0]);
    scene.line(corners, OUTLINE, INK.on_white(strength));
}

/// A slider's guide. Its dashes are the same for all sliders on one line.
pub(super) fn guide(scene: &mut Scene, at: Point, angle: f64, strength: f64) {
    let (on, off) = (7.0, 5.0);
    let (start, end) = (turned(at, angle, (-GUIDE, 0.0)), turned(at, angle, (GUIDE, 0.0)));
    let before = start.0 * angle.cos() - start.1 * angle.sin();
    for line in dashes(&[start, end], on, off, before) {
        scene.line(line, 1.2, INK.on_white(0.75 * strength));
    }
}

/// A fixed support: a triangle below its point, on hatched ground.
pub(super) fn ground(scene: &mut Scene, at: Point) {
    let (half, height) = GROUND;
    let foot = at.1 + height;
    let mut corners = vec![at, (at.0 + half, foot), (at.0 - half, foot)];
    scene.area(corners.clone(), AXIS.on_white(0.15));
    corners.push(at);
    scene.line(corners, OUTLINE, AXIS);
    let side = half + 6.0;
    scene.line(vec![(at.0 - side, foot), (at.0 + side, foot)], OUTLINE, AXIS);
    for stroke in 0..6 {
        let x = at.0 - side + 2.0 * side * (f64::from(stroke) + 1.0) / 6.0;
        scene.line(vec![(x, foot), (x - 6.0, foot + 7.0)], 1.2, AXIS);
    }
}

/// The path of a point.
pub(super) fn trace(scene: &mut Scene, points: Vec<Point>, colour: Colour) {
    scene.line(points, TRACE, colour);
}

/// A circle.
pub(super) fn circle(scene: &mut Scene, at: Point, radius: f64, colour: Colour) {
    ring(scene, around(at, radius), colour);
}

/// The outline of a circle.
pub(super) fn around(at: Point, radius: f64) -> Vec<Point> {
    let mut outline = arc(at, radius, 0.0, TAU, 180);
    outline.extend(outline.first().copied());
    outline
}

/// A circle's outline, seen from anywhere.
pub(super) fn ring(scene: &mut Scene, outline: Vec<Point>, colour: Colour) {
    scene.line(outline, 0.6 * LINK, colour);
}

/// A road, a wall, a guide.
pub(super) fn curve(scene: &mut Scene, points: Vec<Point>, colour: Colour) {
    scene.line(points, 0.6 * LINK, colour);
}

/// A spring: as many turns at any length.
pub(super) fn spring(scene: &mut Scene, ends: [Point; 2], colour: Colour) {
    let (length, angle) = between(ends);
    // Straight ends, and half a turn from each peak to the next.
    let halves = 12;
    let width = SPRING.min(STOUTEST * length);
    let peak = |half: u32| {
        let along = 0.15 + 0.7 * (f64::from(half) + 0.5) / f64::from(halves);
        let across = if half.is_multiple_of(2) { width } else { -width };
        turned(ends[0], angle, (along * length, across))
    };
    let straight = |along: f64| turned(ends[0], angle, (along * length, 0.0));
    let mut points = vec![ends[0], straight(0.15)];
    points.extend((0..halves).map(peak));
    points.extend([straight(0.85), ends[1]]);
    scene.line(points, OUTLINE, colour);
}

/// A damper: a cylinder on the first end, a piston on the second.
pub(super) fn damper(scene: &mut Scene, ends: [Point; 2], colour: Colour) {
    let (length, angle) = between(ends);
    let width = SPRING.min(STOUTEST * length);
    let at = |along: f64, across: f64| turned(ends[0], angle, (along * length, across * width));
    let (bottom, piston, top) = (0.32, 0.52, 0.68);
    scene.line(vec![ends[0], at(bottom, 0.0)], OUTLINE, colour);
    scene.line(vec![at(top, 1.0), at(bottom, 1.0), at(bottom, -1.0), at(top, -1.0)], OUTLINE, colour);
    scene.line(vec![at(piston, 0.75), at(piston, -0.75)], OUTLINE, colour);
    scene.line(vec![at(piston, 0.0), ends[1]], OUTLINE, colour);
}

/// The distance from one place to the other, and its direction.
fn between([from, to]: [Point; 2]) -> (f64, f64) {
    let (right, down) = (to.0 - from.0, to.1 - from.1);
    (right.hypot(down), (-down).atan2(right))
}

/// The directions of x, y and z.
pub(super) fn axes(scene: &mut Scene, at: Point) {
    for (name, axis) in [("x", [1.0, 0.0, 0.0]), ("y", [0.0, 1.0, 0.0]), ("z", [0.0, 0.0, 1.0])] {
        let (right, up) = view::seen(&axis);
        let end = |length: f64| (at.0 + length * right, at.1 - length * up);
        scene.line(vec![at, end(AXES)], OUTLINE, AXIS);
        let (x, y) = end(AXES + 10.0);
        scene.text(name, (x, y + 5.0), 15.0, Anchor::Middle, INK);
    }
}

/// A bar of round length, at most this long on the sheet, from its left end; the unit of length is so long there.
pub(super) fn scale(scene: &mut Scene, at: Point, (name, unit): (&str, f64), longest: f64) {
    let exponent = (longest / unit).log10().floor() as i32;
    let sizes = [5, 2, 1].map(|digit| (digit, f64::from(digit) * 10.0_f64.powi(exponent)));
    let Some((digit, length)) = sizes.into_iter().find(|(_, length)| length * unit <= longest) else { return };
    let end = at.0 + length * unit;
    scene.line(vec![(at.0, at.1 - 6.0), at, (end, at.1), (end, at.1 - 6.0)], 1.2, AXIS);
    let text = format!("{} {name}", decimal(i64::from(digit), exponent));
    scene.text(&text, ((at.0 + end) / 2.0, at.1 - 9.0), 15.0, Anchor::Middle, INK);
}

fn arc(centre: Point, radius: f64, from: f64, turn: f64, steps: u32) -> Vec<Point> {
    let at = |step: u32| turned(centre, from + turn * f64::from(step) / f64::from(steps), (radius, 0.0));
    (0..=steps).map(at).collect()
}

/// A place given along and across a direction. Angles are counter-clockwise, as in the mechanism.
fn turned(origin: Point, angle: f64, (along, across): Point) -> Point {
    let (sine, cosine) = angle.sin_cos();
    (origin.0 + along * cosine - across * sine, origin.1 - along * sine - across * cosine)
}
