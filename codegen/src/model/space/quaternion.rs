//! Unit quaternions.
//!
//! `quaternion(q0, q1, q2, q3)` is the rotation of the quaternion's direction, q/|q|, whatever its length: R(q/|q|),
//! with the angular velocity 2 G(q) q'/|q|^2. So every formulation agrees on states off the norm constraint too, no
//! force arises along q, and the multiplier of the norm is 0. This costs one division.
//!
//! M would be singular along q, so there is an inertia along q.q, the mean moment of the body. The norm constraint
//! keeps it from moving, and the planned elimination has a pivot. The oracle and Lagrange's equations have the same
//! term.

use super::frames::Step;
use super::norms::Quaternion;
use super::triple::{Matrix, Triple};
use crate::dsl::{Expression, Region};
use crate::model::interpreter::Interpreter;
use crate::model::level::position_level;
use crate::model::value::Value;
use crate::model::{Dependence, Dimension};
use crate::symbolic::{Expr, Graph, Node};

impl Interpreter {
    /// `quaternion(q0, q1, q2, q3)`, the scalar part first.
    pub(in crate::model) fn quaternion(&mut self, region: Region, arguments: &[Expression; 4]) -> Option<Value> {
        let components = arguments.each_ref().map(|argument| {
            let value = self.scalar_of(argument, &Dimension::none(), "a component of a quaternion")?;
            position_level(argument, &[value], "a quaternion", self)?;
            Some(value)
        });
        let [Some(q0), Some(q1), Some(q2), Some(q3)] = components else { return None };
        let q = [q0, q1, q2, q3];
        let is_of_coordinates = self.note_coordinates(region, q);
        let Interpreter { graph, motion, .. } = self;
        let square = norm_square(graph, &q);
        if graph.is_zero(square) {
            let message =
                "four zeros are no quaternion: they have no direction; `quaternion(1, 0, 0, 0)` turns nothing";
            return self.refuse(region, message);
        }
        let inverse = graph.integer_power(square, -1);
        let matrix = matrix(graph, &q, inverse);
        let rates = q.map(|x| motion.of(graph, x));
        let spin = spin(graph, &q, &rates, inverse);
        let spin_rate = spin.map(|x| motion.of(graph, x));
        let step = Step { matrix, spin, spin_rate, quaternion: is_of_coordinates.then_some(q) };
        Some(Value::rotation(self.frames.single(&mut self.graph, step)))
    }

    /// Records a quaternion whose components are coordinates.
    fn note_coordinates(&mut self, place: Region, components: [Expr; 4]) -> bool {
        let symbols = components.map(|x| match self.graph.node(x) {
            Node::Symbol(symbol) => Some(*symbol),
            _ => None,
        });
        let [Some(a), Some(b), Some(c), Some(d)] = symbols else { return false };
        if components.iter().any(|x| !self.dependences.of(&self.graph, *x).meets(Dependence::COORDINATE)) {
            return false;
        }
        if !self.quaternions.iter().any(|known| known.components == components) {
            let symbols = [a, b, c, d];
            let names = symbols.map(|symbol| self.graph.symbol_name(symbol).to_owned());
            self.quaternions.push(Quaternion { components, symbols, names, place });
        }
        true
    }
}

/// q.q
pub(in crate::model) fn norm_square(graph: &mut Graph, q: &[Expr; 4]) -> Expr {
    let squares = q.map(|x| graph.integer_power(x, 2));
    graph.sum(&squares)
}

/// I + 2 (q0 [v] + [v]^2)/q.q.
fn matrix(graph: &mut Graph, q: &[Expr; 4], inverse: Expr) -> Matrix {
    let two = graph.integer(2);
    let double = graph.mul(two, inverse);
    let v = [q[1], q[2], q[3]];
    std::array::from_fn(|i| {
        std::array::from_fn(|j| {
            if i == j {
                let others = [v[(i + 1) % 3], v[(i + 2) % 3]].map(|x| graph.integer_power(x, 2));
                let sum = graph.sum(&others);
                let lost = graph.mul(double, sum);
                let one = graph.one();
                return graph.sub(one, lost);
            }
            let (both, turned) = (graph.mul(v[i], v[j]), graph.mul(q[0], v[3 - i - j]));
            let sum = if (j + 3 - i) % 3 == 1 { graph.sub(both, turned) } else { graph.add(both, turned) };
            graph.mul(double, sum)
        })
    })
}

/// 2 (q0 v' - q0' v - v x v')/q.q, in the turned frame.
fn spin(graph: &mut Graph, q: &[Expr; 4], rates: &[Expr; 4], inverse: Expr) -> Triple {
    let two = graph.integer(2);
    std::array::from_fn(|i| {
        let (j, k) = (1 + (i + 1) % 3, 1 + (i + 2) % 3);
        let i = i + 1;
        let terms = [
            (graph.mul(q[0], rates[i]), false),
            (graph.mul(q[i], rates[0]), true),
            (graph.mul(q[j], rates[k]), true),
            (graph.mul(q[k], rates[j]), false),
        ];
        let signed: Vec<Expr> =
            terms.into_iter().map(|(term, minus)| if minus { graph.neg(term) } else { term }).collect();
        let sum = graph.sum(&signed);
        graph.product(&[two, inverse, sum])
    })
}
