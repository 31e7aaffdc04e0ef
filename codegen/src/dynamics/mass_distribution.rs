//! Mass distributions by their moments.

use crate::model::Body;
use crate::model::triple::{Matrix, Triple, add, apply, product, scaled, transposed};
use crate::symbolic::{Expr, Graph, Number};

/// A mass distribution about an origin.
#[derive(Clone)]
pub struct MassDistribution {
    /// M.
    pub mass: Expr,
    /// h, the integral of r.
    pub first: Triple,
    /// P, the integral of r r', by rows.
    pub second: Matrix,
}

impl MassDistribution {
    pub(super) fn none(graph: &mut Graph) -> MassDistribution {
        let zero = graph.zero();
        MassDistribution { mass: zero, first: [zero; 3], second: [[zero; 3]; 3] }
    }

    pub(super) fn add(&mut self, graph: &mut Graph, other: &MassDistribution) {
        self.mass = graph.add(self.mass, other.mass);
        self.first = add(graph, self.first, other.first);
        self.second = std::array::from_fn(|i| add(graph, self.second[i], other.second[i]));
    }

    /// P = tr(J)/2 - J + m c c' with the inertia J about the centre of mass c.
    pub(super) fn add_body(&mut self, graph: &mut Graph, body: &Body, centre: Option<Triple>) {
        let zero = graph.zero();
        let Some(attitude) = &body.attitude else { return };
        let trace = graph.sum(&attitude.inertia.moments);
        let half = graph.scale(&Number::HALF, trace);
        let second = std::array::from_fn(|i| {
            std::array::from_fn(|j| {
                let moment = attitude.inertia.entry(i, j);
                graph.sub(if i == j { half } else { zero }, moment)
            })
        });
        let about_centre = MassDistribution { mass: zero, first: [zero; 3], second };
        self.add(graph, &about_centre);
        if let (Some((mass, _)), Some(centre)) = (&body.mass, centre) {
            let point = MassDistribution { mass: *mass, ..MassDistribution::none(graph) };
            let point = point.moved(graph, &centre);
            self.add(graph, &point);
        }
    }

    /// Takes out the part that turning about an axis does not move.
    pub(super) fn take_rod(&mut self, graph: &mut Graph, axis: usize) -> MassDistribution {
        let zero = graph.zero();
        let mut rod = MassDistribution::none(graph);
        rod.mass = std::mem::replace(&mut self.mass, zero);
        rod.first[axis] = std::mem::replace(&mut self.first[axis], zero);
        rod.second[axis][axis] = std::mem::replace(&mut self.second[axis][axis], zero);
        rod
    }

    /// The same in the frame before, where it has to be fixed: S h, S P S', about the origin there.
    pub(super) fn seen_from(&self, graph: &mut Graph, turn: &Matrix, offset: &Triple) -> MassDistribution {
        let first = apply(graph, turn, &self.first);
        let half = product(graph, turn, &self.second);
        let second = product(graph, &half, &transposed(turn));
        MassDistribution { mass: self.mass, first, second }.moved(graph, offset)
    }

    /// The same about another origin, from which this one is at r: h + M r, P + r h' + h r' + M r r'.
    fn moved(&self, graph: &mut Graph, r: &Triple) -> MassDistribution {
        let carried = scaled(graph, self.mass, *r);
        let second = std::array::from_fn(|i| {
            std::array::from_fn(|j| {
                let terms = [
                    self.second[i][j],
                    graph.mul(r[i], self.first[j]),
                    graph.mul(self.first[i], r[j]),
                    graph.mul(carried[i], r[j]),
                ];
                graph.sum(&terms)
            })
        });
        MassDistribution { mass: self.mass, first: add(graph, self.first, carried), second }
    }
}
