//! The paths of traced points.

use sim_kernel::Shape;

use super::Positions;
use super::palette::{Colour, series};
use super::parts::is_coloured;
use super::scene::Point;
use super::ticks::shown;
use super::view;

/// A path between its gaps, in the unit of length.
pub(super) struct Path {
    pub(super) points: Vec<Point>,
    pub(super) colour: Colour,
}

/// The paths of all traced points, each in the colour of its shape.
pub(super) fn paths(positions: &Positions) -> Vec<Path> {
    let Positions { shapes, unit, motion, .. } = positions;
    let dimension = shapes.dimension;
    let (mut first, mut colours, mut paths) = (0, 0, Vec::new());
    for shape in shapes.shapes {
        if let Shape::Trace(points) = shape {
            for at in (0..*points).map(|point| first + dimension * point) {
                let seen = |row: &Vec<f64>| row.get(at..at + dimension).map_or((f64::NAN, f64::NAN), view::seen);
                let places: Vec<Point> =
                    motion.iter().map(seen).map(|place| (place.0 / unit.metres, place.1 / unit.metres)).collect();
                let pieces = places.split(|place| !shown(place.0) || !shown(place.1));
                let pieces = pieces.filter(|piece| piece.len() > 1).map(<[Point]>::to_vec);
                paths.extend(pieces.map(|points| Path { points, colour: series(colours) }));
            }
        }
        first += shape.numbers(dimension);
        colours += usize::from(is_coloured(*shape));
    }
    paths
}
