//! The parts of a mechanism in one position, as they lie on the sheet before it has a scale.

use sim_kernel::{Description, Shape};

use super::palette::{Colour, series};
use super::scene::Point;
use super::ticks::shown;
use super::{Pose, ShowError, view};

/// The opacity of the poses after the first, from the second to the last.
const STRENGTH: (f64, f64) = (0.5, 0.2);

/// A shape with its places, in metres and radians.
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
}

/// Shapes in the plane or in space.
#[derive(Clone, Copy, Debug)]
pub struct Shapes<'a> {
    /// 2 or 3.
    pub dimension: usize,
    /// The shapes.
    pub shapes: &'a [Shape],
}

impl Shapes<'static> {
    /// The drawn parts of a mechanism.
    pub fn of(description: &Description) -> Self {
        Shapes { dimension: description.dimension, shapes: description.drawing }
    }
}

/// The poses' parts.
pub(super) fn placed(shapes: Shapes, poses: &[Pose], name: &str) -> Result<Vec<Placed>, ShowError> {
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
            return Err(ShowError::Pose { figure, time: pose.time, numbers, needed });
        }
        placed.push(Placed { parts: parts(shapes, pose.numbers), strength: strength(index, poses.len()) });
    }
    Ok(placed)
}

fn strength(index: usize, poses: usize) -> f64 {
    match index {
        0 => 1.0,
        1 => STRENGTH.0,
        _ => STRENGTH.0 + (STRENGTH.1 - STRENGTH.0) * (index - 1) as f64 / (poses - 2) as f64,
    }
}

/// The parts from a pose's numbers, without those that are not finite.
fn parts(Shapes { dimension, shapes }: Shapes, mut numbers: &[f64]) -> Vec<Part> {
    let mut colours = 0;
    let mut parts = Vec::new();
    for shape in shapes {
        let (own, rest) = numbers.split_at(shape.numbers(dimension));
        numbers = rest;
        let (points, more) = own.split_at(dimension * shape.points());
        let points: Vec<Point> = points.chunks_exact(dimension).map(view::seen).collect();
        match shape {
            Shape::Slider | Shape::Circle if !own.iter().all(|number| shown(*number)) => {}
            Shape::Slider => parts.push(Part::Slider {
                centre: points[0],
                angle: if let [angle] = *more { angle } else { view::angle(more) },
            }),
            Shape::Circle => parts.push(match *more {
                [radius] => Part::Circle { centre: points[0], radius, colour: series(colours) },
                _ => Part::Ring { points: view::circle(own, more[0], &more[1..]), colour: series(colours) },
            }),
            _ => parts.extend(through(*shape, &points, series(colours))),
        }
        colours += usize::from(matches!(shape, Shape::Line(_) | Shape::Circle));
    }
    parts
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
        Shape::Slider | Shape::Circle => Vec::new(),
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
