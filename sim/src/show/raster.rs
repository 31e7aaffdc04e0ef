//! Shapes to pixels. A mark's shapes are united in 8 by 8 samples per pixel, then laid on the canvas at once,
//! so that where pieces of one line meet nothing shows.

use super::palette::{Colour, WHITE};
use super::scene::Point;

/// Samples across a pixel.
const SAMPLES: usize = 8;

/// An image of red, green and blue bytes.
pub(super) struct Canvas {
    width: usize,
    height: usize,
    bytes: Vec<u8>,
}

/// Pixels from the first to before the last.
#[derive(Clone, Copy)]
struct Window {
    left: usize,
    right: usize,
    top: usize,
    bottom: usize,
}

/// Which samples of the pixels in a window a mark covers.
pub(super) struct Mask {
    window: Window,
    samples: Vec<u64>,
}

/// How much of the pixels in a window a text covers.
pub(super) struct Ink {
    window: Window,
    cover: Vec<f64>,
}

impl Window {
    /// The pixels of a canvas within a distance of the points.
    fn around(canvas: &Canvas, points: &[Point], distance: f64) -> Self {
        let bounds = |of: fn(&Point) -> f64, most: usize| {
            let low = points.iter().map(of).fold(f64::INFINITY, f64::min) - distance;
            let high = points.iter().map(of).fold(f64::NEG_INFINITY, f64::max) + distance;
            // Casts saturate: nothing is below 0.
            let low = (low.floor() as usize).min(most);
            (low, (high.ceil() as usize).min(most).max(low))
        };
        let (left, right) = bounds(|point| point.0, canvas.width);
        let (top, bottom) = bounds(|point| point.1, canvas.height);
        Window { left, right, top, bottom }
    }

    fn width(self) -> usize {
        self.right - self.left
    }

    fn len(self) -> usize {
        self.width() * (self.bottom - self.top)
    }
}

impl Canvas {
    /// White paper.
    pub(super) fn new(width: usize, height: usize) -> Self {
        let bytes = [WHITE.0, WHITE.1, WHITE.2].repeat(width * height);
        Canvas { width, height, bytes }
    }

    pub(super) fn width(&self) -> usize {
        self.width
    }

    pub(super) fn height(&self) -> usize {
        self.height
    }

    /// The pixels, row by row.
    pub(super) fn bytes(&self) -> &[u8] {
        &self.bytes
    }

    /// No ink yet, within a distance of the points.
    pub(super) fn ink_around(&self, points: &[Point], distance: f64) -> Ink {
        let window = Window::around(self, points, distance);
        Ink { window, cover: vec![0.0; window.len()] }
    }

    /// Colours what a mask covers.
    pub(super) fn lay(&mut self, mask: &Mask, colour: Colour) {
        let share = |samples: &u64| f64::from(samples.count_ones()) / (SAMPLES * SAMPLES) as f64;
        self.blend(mask.window, mask.samples.iter().map(share), colour);
    }

    /// Colours what a text covers.
    pub(super) fn lay_ink(&mut self, ink: &Ink, colour: Colour) {
        self.blend(ink.window, ink.cover.iter().map(|cover| cover.min(1.0)), colour);
    }

    fn blend(&mut self, window: Window, shares: impl Iterator<Item = f64>, colour: Colour) {
        for (index, share) in shares.enumerate().filter(|(_, share)| *share > 0.0) {
            let row = window.top + index / window.width();
            let at = 3 * (row * self.width + window.left + index % window.width());
            if let Some([red, green, blue]) = self.bytes.get_mut(at..at + 3) {
                (*red, *green, *blue) = {
                    let mixed = Colour(*red, *green, *blue).blend(colour, share);
                    (mixed.0, mixed.1, mixed.2)
                };
            }
        }
    }
}

impl Ink {
    /// Adds an area, in pixels, at a point.
    pub(super) fn add(&mut self, (x, y): Point, area: f64) {
        let window = self.window;
        let (column, row) = (x.floor(), y.floor());
        let inside = |at: f64, low: usize, high: usize| at >= low as f64 && at < high as f64;
        if inside(column, window.left, window.right) && inside(row, window.top, window.bottom) {
            let index = (row as usize - window.top) * window.width() + column as usize - window.left;
            self.cover[index] += area;
        }
    }
}

impl Mask {
    /// Nothing covered yet, within a distance of the points.
    pub(super) fn around(canvas: &Canvas, points: &[Point], distance: f64) -> Self {
        let window = Window::around(canvas, points, distance);
        Mask { window, samples: vec![0; window.len()] }
    }

    /// Covers a line with round ends.
    pub(super) fn add_stroke(&mut self, from: Point, to: Point, radius: f64) {
        let (low, high) = (from.1.min(to.1) - radius, from.1.max(to.1) + radius);
        let (dx, dy) = (to.0 - from.0, to.1 - from.1);
        let length = dx.hypot(dy);
        let side = if length > 0.0 { (-dy / length * radius, dx / length * radius) } else { (0.0, 0.0) };
        let corners = [
            (from.0 + side.0, from.1 + side.1),
            (to.0 + side.0, to.1 + side.1),
            (to.0 - side.0, to.1 - side.1),
            (from.0 - side.0, from.1 - side.1),
        ];
        self.cover(low, high, |y| {
            hull(hull(polygon_row(&corners, y), disc_row(from, radius, y)), disc_row(to, radius, y))
        });
    }

    /// Covers a convex polygon.
    pub(super) fn add_polygon(&mut self, corners: &[Point]) {
        let low = corners.iter().map(|corner| corner.1).fold(f64::INFINITY, f64::min);
        let high = corners.iter().map(|corner| corner.1).fold(f64::NEG_INFINITY, f64::max);
        self.cover(low, high, |y| polygon_row(corners, y));
    }

    /// Covers, in every row of samples between two heights, the interval of that row.
    fn cover(&mut self, low: f64, high: f64, interval: impl Fn(f64) -> Option<(f64, f64)>) {
        let fine = SAMPLES as f64;
        let (top, bottom) = (self.window.top * SAMPLES, self.window.bottom * SAMPLES);
        let first = ((low * fine).floor() as usize).clamp(top, bottom);
        let end = ((high * fine).ceil() as usize).clamp(top, bottom);
        for row in first..end {
            if let Some((left, right)) = interval((row as f64 + 0.5) / fine) {
                self.cover_row(row, left * fine, right * fine);
            }
        }
    }

    /// Covers the samples of a row whose middles are in an interval, in samples.
    fn cover_row(&mut self, row: usize, left: f64, right: f64) {
        let (start, end) = (self.window.left * SAMPLES, self.window.right * SAMPLES);
        let first = ((left - 0.5).ceil().max(0.0) as usize).clamp(start, end);
        let after = ((right + 0.5).floor().max(0.0) as usize).clamp(start, end);
        let cells = (row / SAMPLES - self.window.top) * self.window.width();
        let mut at = first;
        while at < after {
            let stop = after.min((at / SAMPLES + 1) * SAMPLES);
            let bits = ((1_u64 << (stop - at)) - 1) << (at % SAMPLES);
            self.samples[cells + at / SAMPLES - self.window.left] |= bits << (row % SAMPLES * SAMPLES);
            at = stop;
        }
    }
}

/// What a row cuts out of a convex polygon.
fn polygon_row(corners: &[Point], y: f64) -> Option<(f64, f64)> {
    let mut cut = None;
    for (index, from) in corners.iter().enumerate() {
        let to = corners[(index + 1) % corners.len()];
        if (from.1 <= y) != (to.1 <= y) {
            let x = from.0 + (to.0 - from.0) * (y - from.1) / (to.1 - from.1);
            cut = hull(cut, Some((x, x)));
        }
    }
    cut
}

/// What a row cuts out of a disc.
fn disc_row(centre: Point, radius: f64, y: f64) -> Option<(f64, f64)> {
    let square = radius * radius - (y - centre.1) * (y - centre.1);
    (square > 0.0).then(|| (centre.0 - square.sqrt(), centre.0 + square.sqrt()))
}

/// The least interval around two.
fn hull(one: Option<(f64, f64)>, other: Option<(f64, f64)>) -> Option<(f64, f64)> {
    match (one, other) {
        (Some(one), Some(other)) => Some((one.0.min(other.0), one.1.max(other.1))),
        (one, other) => one.or(other),
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    fn covered(mask: &Mask) -> f64 {
        mask.samples.iter().map(|samples| f64::from(samples.count_ones())).sum::<f64>() / 64.0
    }

    #[test]
    fn areas_are_those_of_the_shapes() {
        let canvas = Canvas::new(100, 100);
        let middle = (50.3, 49.6);
        let mut disc = Mask::around(&canvas, &[middle], 20.0);
        disc.add_stroke(middle, middle, 20.0);
        assert!((covered(&disc) - std::f64::consts::PI * 400.0).abs() < 1.0);
        let corners = [(10.0, 10.0), (60.0, 20.0), (30.0, 70.0)];
        let mut triangle = Mask::around(&canvas, &corners, 0.0);
        triangle.add_polygon(&corners);
        assert!((covered(&triangle) - 1400.0).abs() < 4.0);
        let mut stroke = Mask::around(&canvas, &corners[..2], 2.0);
        stroke.add_stroke(corners[0], corners[1], 2.0);
        let length = 50.0_f64.hypot(10.0);
        assert!((covered(&stroke) - (4.0 * length + std::f64::consts::PI * 4.0)).abs() < 1.0);
    }

    #[test]
    fn what_is_off_the_canvas_is_cut_off() {
        let mut canvas = Canvas::new(10, 10);
        let points = [(-50.0, 5.0), (50.0, 5.0)];
        let mut mask = Mask::around(&canvas, &points, 1.0);
        mask.add_stroke(points[0], points[1], 1.0);
        canvas.lay(&mask, Colour(0, 0, 0));
        assert_eq!(covered(&mask), 20.0);
        let away = [(200.0, 300.0), (250.0, 300.0)];
        let mut mask = Mask::around(&canvas, &away, 1.0);
        mask.add_stroke(away[0], away[1], 1.0);
        assert_eq!(covered(&mask), 0.0);
    }
}
