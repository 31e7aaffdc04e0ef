//! The parts of a mechanism in one position, as they lie on the sheet before it has a scale.

use sim_kernel::{Description, Shape};

use super::palette::{Colour, series};
use super::scene::Point;
use super::ticks::shown;
use super::{Positions, ShowError, view};

/// With more bars than these, later poses are drawn plainly.
const MOST_BARS: usize = 4;
/// The opacity of the poses after the first, from the second to the last.
const STRENGTH: (f64, f64) = (0.5, 0.2);
/// The same of thin lines.
const STRENGTH_PLAIN: (f64, f64) = (0.7, 0.35);

/// A shape with its places, in a unit of length and radians.
pub(super) enum Part {
    Line {
        points: Vec<Point>,
        colour: Colour,
    },
    Curve(Vec<Point>),
    Spring([Point; 2]),
    Damper([Point; 2]),
    Slider {
        centre: Point,
        angle: f64,
    },
    Ground(Vec<Point>),
    Points(Vec<Point>),
    Circle {
        centre: Point,
        radius: f64,
        colour: Colour,
    },
    /// A circle seen from the side.
    Ring {
        points: Vec<Point>,
        colour: Colour,
    },
}

/// The parts in one position.
pub(super) struct Placed {
    pub(super) parts: Vec<Part>,
    pub(super) strength: f64,
    /// Whether it is drawn by thin lines, without joints and marks.
    pub(super) plain: bool,
}

/// Shapes in the plane or in space.
#[derive(Clone, Copy, Debug)]
pub struct Shapes<'a> {
    /// 2 or 3.
    pub dimension: usize,
    /// The shapes.
    pub shapes: &'a [Shape],
}

impl Shapes<'_> {
    /// Whether so much is drawn that several positions of it hide each other.
    pub(super) fn are_crowded(self) -> bool {
        let bars = self.shapes.iter().map(|shape| match shape {
            Shape::Line(points) => points.saturating_sub(1),
            Shape::Spring | Shape::Damper => 1,
            // One seen from the side is crossed by others.
            Shape::Circle => self.dimension - 1,
            Shape::Curve(_) | Shape::Slider | Shape::Ground(_) | Shape::Points(_) | Shape::Trace(_) => 0,
        });
        bars.sum::<usize>() > MOST_BARS
    }
}

impl Shapes<'static> {
    /// The drawn parts of a mechanism.
    pub fn of(description: &Description) -> Self {
        Shapes { dimension: description.dimension, shapes: description.drawing }
    }
}

/// The poses' parts.
pub(super) fn placed(positions: &Positions, name: &str) -> Result<Vec<Placed>, ShowError> {
    let Positions { shapes, unit, poses, .. } = *positions;
    if shapes.shapes.is_empty() {
        return Err(ShowError::empty(name, "no shapes"));
    }
    if poses.is_empty() {
        return Err(ShowError::empty(name, "no positions"));
    }
    let needed = shapes.shapes.iter().map(|shape| shape.numbers(shapes.dimension)).sum();
    let mut placed = Vec::with_capacity(poses.len());
    for (index, pose) in poses.iter().enumerate() {
        if pose.numbers.len() != needed {
            let (figure, numbers) = (name.to_owned(), pose.numbers.len());
            return Err(ShowError::Pose { figure, at: pose.at, numbers, needed });
        }
        let parts = parts(shapes, unit.metres, pose.numbers);
        let plain = index > 0 && shapes.are_crowded();
        placed.push(Placed { parts, strength: strength(index, poses.len(), plain), plain });
    }
    Ok(placed)
}

fn strength(index: usize, poses: usize, plain: bool) -> f64 {
    let (second, last) = if plain { STRENGTH_PLAIN } else { STRENGTH };
    match index {
        0 => 1.0,
        1 => second,
        _ => second + (last - second) * (index - 1) as f64 / (poses - 2) as f64,
    }
}

/// The parts a pose's numbers make, in a unit of so many metres; what is not finite is left out.
fn parts(Shapes { dimension, shapes }: Shapes, metres: f64, mut numbers: &[f64]) -> Vec<Part> {
    let scaled = |point: Point| (point.0 / metres, point.1 / metres);
    let mut colours = 0;
    let mut parts = Vec::new();
    for shape in shapes {
        let (own, rest) = numbers.split_at(shape.numbers(dimension));
        numbers = rest;
        let (points, more) = own.split_at(dimension * shape.points());
        let points: Vec<Point> = points.chunks_exact(dimension).map(view::seen).map(scaled).collect();
        match shape {
            Shape::Slider | Shape::Circle if !own.iter().all(|number| shown(*number)) => {}
            Shape::Slider => parts.push(Part::Slider {
                centre: points[0],
                angle: if let [angle] = *more { angle } else { view::angle(more) },
            }),
            Shape::Circle => parts.push(match *more {
                [radius] => Part::Circle { centre: points[0], radius: radius / metres, colour: series(colours) },
                _ => {
                    let points = view::circle(own, more[0], &more[1..]).into_iter().map(scaled).collect();
                    Part::Ring { points, colour: series(colours) }
                }
            }),
            _ => parts.extend(through(*shape, &points, series(colours))),
        }
        colours += usize::from(is_coloured(*shape));
    }
    parts
}

/// Whether a shape has a colour of its own.
pub(super) fn is_coloured(shape: Shape) -> bool {
    matches!(shape, Shape::Line(_) | Shape::Circle | Shape::Trace(_))
}

/// Shapes drawn through or at points.
fn through(shape: Shape, points: &[Point], colour: Colour) -> Vec<Part> {
    let finite = |point: &Point| shown(point.0) && shown(point.1);
    let pieces = points.split(|point| !finite(point)).filter(|piece| !piece.is_empty()).map(<[Point]>::to_vec);
    let ends = || <[Point; 2]>::try_from(points).ok().filter(|ends| ends.iter().all(finite));
    let all = || points.iter().copied().filter(finite).collect();
    match shape {
        Shape::Line(_) => pieces.map(|points| Part::Line { points, colour }).collect(),
        Shape::Curve(_) => pieces.map(Part::Curve).collect(),
        Shape::Spring => ends().map(Part::Spring).into_iter().collect(),
        Shape::Damper => ends().map(Part::Damper).into_iter().collect(),
        Shape::Ground(_) => vec![Part::Ground(all())],
        Shape::Points(_) => vec![Part::Points(all())],
        Shape::Slider | Shape::Circle | Shape::Trace(_) => Vec::new(),
    }
}

impl Part {
    /// The points that it extends to, without the sizes of symbols.
    pub(super) fn extent(&self) -> Vec<Point> {
        match self {
            Part::Line { points, .. } | Part::Ring { points, .. } => points.clone(),
            Part::Curve(points) | Part::Ground(points) | Part::Points(points) => points.clone(),
            Part::Spring(ends) | Part::Damper(ends) => ends.to_vec(),
            Part::Slider { centre, .. } => vec![*centre],
            Part::Circle { centre: (x, y), radius, .. } => vec![(x - radius, y - radius), (x + radius, y + radius)],
        }
    }
}
