//! What is seen of a robot: its links' forms, or lines from joint to joint.

use super::blocks::Blocks;
use super::{Written, one_line};
use crate::urdf::mesh::{self, Missing};
use crate::urdf::number::Number;
use crate::urdf::outline::outlines;
use crate::urdf::robot::{Geometry, Kind, Place, Visual};
use crate::urdf::warnings::Warnings;
use indexmap::IndexMap;
use nalgebra::Vector3;

/// As many points are drawn on links; the rest is seen by its lines alone. A declaration has a limited length.
const MOST_POINTS: usize = 1200;

/// Corners of a mesh's outlines: as many as there is room for, between these.
const CORNERS: [usize; 2] = [4, 12];

/// Writes the drawing.
pub(super) fn draw(written: &Written, frames: &[String], blocks: &mut Blocks, warnings: &mut Warnings) {
    let Written { robot, tree, .. } = written;
    let is_mesh = |visual: &&Visual| matches!(visual.geometry, Geometry::Mesh { .. });
    let meshes = robot.links.iter().flat_map(|link| &link.visuals).filter(is_mesh).count();
    let corners = (MOST_POINTS / (3 * meshes.max(1))).saturating_sub(1).clamp(CORNERS[0], CORNERS[1]);
    let mut drawing = Drawing { blocks, points: 0, corners, left_out: IndexMap::new() };
    if tree.is_grounded(tree.root) {
        drawing.line("ground [0, 0, 0];".to_owned());
    }
    for joint in &robot.joints {
        let is_apart = joint.origin.xyz.iter().any(|number| !number.is_zero()) || joint.kind == Kind::Prismatic;
        if is_apart {
            let [from, to] = [joint.parent, joint.child].map(|link| format!("on({}, [0, 0, 0])", frames[link]));
            drawing.line(format!("line {from}, {to};"));
        }
    }
    for link in &tree.order {
        for visual in &robot.links[*link].visuals {
            drawing.visual(written, &frames[*link], visual);
        }
    }
    for (why, (count, place)) in drawing.left_out {
        let forms = if count == 1 { "this is".to_owned() } else { format!("this and {} others are", count - 1) };
        warnings.add(&place, format!("{forms} not drawn: {why}"));
    }
}

struct Drawing<'b> {
    blocks: &'b mut Blocks,
    points: usize,
    /// Of the outline of a mesh.
    corners: usize,
    /// Why forms are not drawn: how many, and where the first is.
    left_out: IndexMap<String, (usize, Place)>,
}

impl Drawing<'_> {
    fn line(&mut self, line: String) {
        self.blocks.line("drawing", line);
    }

    fn visual(&mut self, written: &Written, frame: &str, visual: &Visual) {
        if self.points > MOST_POINTS {
            const WHY: &str = "there is room for so many forms, and these links are seen by their lines";
            return self.is_left_out(WHY.to_owned(), visual);
        }
        let at = |x: Vector3<f64>| visual.origin.vector() + visual.origin.rotation * x;
        match &visual.geometry {
            Geometry::Box(sides) => {
                let half = Vector3::from(*sides) / 2.0;
                let corner = |x: f64, y: f64, z: f64| at(Vector3::new(x, y, z).component_mul(&half));
                for z in [-1.0, 1.0] {
                    let around = [(-1.0, -1.0), (1.0, -1.0), (1.0, 1.0), (-1.0, 1.0), (-1.0, -1.0)];
                    self.curve(frame, &around.map(|(x, y)| corner(x, y, z)));
                }
                for (x, y) in [(-1.0, -1.0), (1.0, -1.0), (1.0, 1.0), (-1.0, 1.0)] {
                    self.curve(frame, &[-1.0, 1.0].map(|z| corner(x, y, z)));
                }
            }
            Geometry::Cylinder { radius, length } => {
                let end = |x: f64, y: f64, z: f64| at(Vector3::new(x * radius, y * radius, z * length / 2.0));
                let axis = visual.origin.rotation * Vector3::z();
                for z in [-1.0, 1.0] {
                    self.circle(frame, end(0.0, 0.0, z), *radius, axis);
                }
                for (x, y) in [(1.0, 0.0), (0.0, 1.0), (-1.0, 0.0), (0.0, -1.0)] {
                    self.curve(frame, &[-1.0, 1.0].map(|z| end(x, y, z)));
                }
            }
            Geometry::Sphere(radius) => {
                for k in 0..3 {
                    self.circle(frame, at(Vector3::zeros()), *radius, Vector3::ith(k, 1.0));
                }
            }
            Geometry::Mesh { file, scale } => {
                let found =
                    mesh::find(file, written.folder, &written.options.packages).and_then(|path| mesh::vertices(&path));
                match found {
                    Ok(vertices) => {
                        let scaled: Vec<_> = vertices
                            .into_iter()
                            .map(|vertex| at(vertex.component_mul(&Vector3::from(*scale))))
                            .collect();
                        outlines(&scaled, self.corners).iter().for_each(|outline| self.curve(frame, outline));
                    }
                    Err(why) => self.is_missing(file, why, visual),
                }
            }
        }
    }

    fn is_missing(&mut self, file: &str, why: Missing, visual: &Visual) {
        let why = match why {
            Missing::Package(name) => {
                let name = one_line(&name);
                format!(
                    "the folder of package `{name}` is not known; `sim import FILE --package {name}=FOLDER` says it"
                )
            }
            Missing::OtherKind => "of meshes STL alone is read".to_owned(),
            Missing::Outside => "meshes are read from the robot's folder and from those of packages alone".to_owned(),
            Missing::File(why) => format!("{}: {why}", one_line(file)),
        };
        self.is_left_out(why, visual);
    }

    fn is_left_out(&mut self, why: String, visual: &Visual) {
        let (count, _) = self.left_out.entry(why).or_insert_with(|| (0, visual.place.clone()));
        *count += 1;
    }

    fn curve(&mut self, frame: &str, points: &[Vector3<f64>]) {
        if !points.iter().all(is_drawable) {
            return;
        }
        self.points += points.len();
        let points: Vec<String> = points.iter().map(|at| on(frame, at)).collect();
        self.line(format!("curve {};", points.join(", ")));
    }

    fn circle(&mut self, frame: &str, centre: Vector3<f64>, radius: f64, normal: Vector3<f64>) {
        if !is_drawable(&centre) || !(radius < FARTHEST) {
            return;
        }
        self.points += 2;
        let [a, b, c] = [0, 1, 2].map(|k| Number::of(normal[k]));
        let radius = rounded(radius).with("m");
        self.line(format!("circle {} radius {radius} normal attitude({frame})*[{a}, {b}, {c}];", on(frame, &centre)));
    }
}

/// Nothing is drawn farther away, in metres.
const FARTHEST: f64 = 1e6;

fn is_drawable(at: &Vector3<f64>) -> bool {
    at.iter().all(|x| x.abs() < FARTHEST)
}

fn on(frame: &str, at: &Vector3<f64>) -> String {
    let [x, y, z] = [0, 1, 2].map(|k| rounded(at[k]).with("m"));
    format!("on({frame}, [{x}, {y}, {z}])")
}

/// A length to a hundredth of a millimetre: it is only drawn.
fn rounded(length: f64) -> Number {
    Number::of((length * 1e5).round() / 1e5)
}
