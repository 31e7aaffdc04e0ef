//! Velocities and accelerations of points, carried from frame to frame.

use super::triple::{self, Triple, add, cross, inner, scaled};
use super::{Frames, Spatial, Turn};
use crate::model::Rates;
use crate::symbolic::{Differential, Expr, Graph, Number};

impl Frames {
    /// Velocity and acceleration of the point at `place`, as components in a frame.
    pub(in crate::model) fn point_rates(
        &self,
        graph: &mut Graph,
        motion: &mut Differential,
        place: &Spatial,
        turn: Turn,
    ) -> Rates {
        let moving: Vec<_> = place.terms().iter().map(|(own, u)| (*own, self.moved(graph, motion, *own, u))).collect();
        let velocities: Vec<_> = moving.iter().map(|(own, rates)| (*own, rates.velocity)).collect();
        let accelerations: Vec<_> = moving.iter().map(|(own, rates)| (*own, rates.acceleration)).collect();
        Rates {
            velocity: self.carried(graph, &velocities, turn),
            acceleration: self.carried(graph, &accelerations, turn),
            turning: self.spin(turn),
        }
    }

    /// The acceleration of the point at `place` and another one, together, as components in a frame.
    pub(in crate::model) fn proper_acceleration(
        &self,
        graph: &mut Graph,
        motion: &mut Differential,
        place: &Spatial,
        other: &Spatial,
        turn: Turn,
    ) -> Triple {
        let mut terms = other.terms().to_vec();
        for (own, u) in place.terms() {
            terms.push((*own, self.moved(graph, motion, *own, u).acceleration));
        }
        self.carried(graph, &terms, turn)
    }

    /// The rate of a vector, each of its parts in its own frame.
    pub(in crate::model) fn rate(&self, graph: &mut Graph, motion: &mut Differential, v: &Spatial) -> Spatial {
        let mut rate = Spatial::world(triple::zero(graph));
        for (turn, u) in v.terms() {
            let own = u.map(|x| motion.of(graph, x));
            let swept = cross(graph, &self.spin(*turn), u);
            let sum = add(graph, own, swept);
            rate = rate.combine(&Spatial::within(*turn, sum), graph, Graph::add);
        }
        rate
    }

    /// The angular velocity of a frame and its rate, in the frame.
    pub(in crate::model) fn spin_rates(&self, turn: Turn) -> Rates {
        Rates { velocity: self.spin(turn), acceleration: self.spin_rate(turn), turning: self.spin(turn) }
    }

    /// w x u + u', and ([w'] + [w]^2) u + 2 w x u' + u''.
    fn moved(&self, graph: &mut Graph, motion: &mut Differential, turn: Turn, u: &Triple) -> Rates {
        let spin = self.spin(turn);
        let relative = u.map(|x| motion.of(graph, x));
        let relative_rate = relative.map(|x| motion.of(graph, x));
        let swept = cross(graph, &spin, u);
        let turning = self.turning(graph, turn).map(|row| inner(graph, &row, u));
        let two = graph.integer(2);
        let coriolis = cross(graph, &spin, &relative);
        let coriolis = scaled(graph, two, coriolis);
        let apparent = add(graph, coriolis, relative_rate);
        Rates { velocity: add(graph, swept, relative), acceleration: add(graph, turning, apparent), turning: spin }
    }

    /// [w'] + [w]^2, which takes fixed points to their accelerations.
    fn turning(&self, graph: &mut Graph, turn: Turn) -> [Triple; 3] {
        let (w, a) = (self.spin(turn), self.spin_rate(turn));
        let mut of = |i: usize, j: usize| -> Expr {
            if i == j {
                let squares = [w[(i + 1) % 3], w[(i + 2) % 3]].map(|x| graph.integer_power(x, 2));
                let sum = graph.sum(&squares);
                return graph.scale(&Number::MINUS_ONE, sum);
            }
            let product = graph.mul(w[i], w[j]);
            let other = a[3 - i - j];
            match (j + 3 - i) % 3 {
                1 => graph.sub(product, other),
                _ => graph.add(product, other),
            }
        };
        std::array::from_fn(|i| std::array::from_fn(|j| of(i, j)))
    }
}
