//! Rotations: about an axis, by a sequence of Euler's angles, and their products.

use super::basis::Basis;
use super::frames::Step;
use super::triple::{self, Matrix, Triple, add, cross, identity, scaled, sub};
use super::{Bases, Spatial, Turn};
use crate::dsl::{Expression, Kind, Region};
use crate::model::interpreter::Interpreter;
use crate::model::level;
use crate::model::scope::plain;
use crate::model::value::{Shape, Value};
use crate::model::{Dependence, Dimension};
use crate::symbolic::{Expr, Function, Symbol, evaluate};
use syn::Ident;

const AXES: [char; 3] = ['x', 'y', 'z'];

impl Value {
    pub(in crate::model) fn rotation(turn: Turn) -> Value {
        Value::new(Shape::Rotation(turn), Some(Dimension::none()))
    }
}

impl Interpreter {
    /// A rotation.
    pub(in crate::model) fn turn(&mut self, expression: &Expression) -> Option<(Turn, Bases)> {
        let value = self.value(expression)?;
        match value.shape {
            Shape::Rotation(turn) => Some((turn, value.bases)),
            _ => {
                let message = format!(
                    "{} stands where a rotation is needed; a rotation is written `rotation(axis, angle)`, `euler(zxz, a, b, c)` \
                     or `quaternion(q0, q1, q2, q3)`",
                    value.kind()
                );
                self.refuse(expression.region, message)
            }
        }
    }

    /// `rotation(axis, angle)`
    pub(in crate::model) fn rotation(&mut self, axis: &Expression, angle: &Expression) -> Option<Value> {
        let (axis, angle) = (self.axis(axis), level::angle(angle, "the angle of a rotation", self));
        let step = self.about(axis?, angle?);
        Some(Value::rotation(self.frames.single(&mut self.graph, step)))
    }

    /// `euler(zxz, psi, theta, phi)`: about z, then about the new x, then about the new z.
    pub(in crate::model) fn euler(&mut self, region: Region, arguments: &[Expression]) -> Option<Value> {
        const FORM: &str = "Euler's angles are written `euler(zxz, psi, theta, phi)`: the axes, each in the frame left by \
                            the rotations before it, and as many angles";
        let [sequence, angles @ ..] = arguments else { return self.refuse(region, FORM) };
        let Kind::Name(sequence_name) = &sequence.kind else { return self.refuse(sequence.region, FORM) };
        let letters: Vec<char> = plain(sequence_name).chars().collect();
        if letters.len() != 3 || letters.iter().any(|letter| !AXES.contains(letter)) {
            return self.refuse(sequence.region, format!("`{sequence_name}` is not a sequence of axes; {FORM}"));
        }
        if letters.windows(2).any(|pair| pair[0] == pair[1]) {
            let message = format!("`{sequence_name}` turns about the same axis twice in a row");
            return self.refuse(sequence.region, message);
        }
        if angles.len() != letters.len() {
            return self.refuse(region, format!("{} angles wanted, {} given; {FORM}", letters.len(), angles.len()));
        }
        let angles: Vec<_> = angles.iter().map(|a| level::angle(a, "the angle of a rotation", self)).collect();
        let mut turn = Turn::NONE;
        for (letter, angle) in letters.into_iter().zip(angles) {
            let axis = self.unit(letter)?;
            let step = self.about(axis, angle?);
            let single = self.frames.single(&mut self.graph, step);
            turn = self.frames.product(&mut self.graph, turn, single);
        }
        Some(Value::rotation(turn))
    }

    /// `axes(u, v, w)`: of x, y and z to three axes at right angles.
    pub(in crate::model) fn axes(&mut self, region: Region, arguments: &[Expression; 3]) -> Option<Value> {
        let [u, v, w] = arguments.each_ref().map(|argument| self.axis(argument));
        let columns = [u?, v?, w?];
        let third = cross(&mut self.graph, &columns[0], &columns[1]);
        for (a, b, cosine) in [(&columns[0], &columns[1], 0.0), (&third, &columns[2], 1.0)] {
            let found = triple::inner(&mut self.graph, a, b);
            if (1..=3).any(|k| !((self.sampled(found, k) - cosine).abs() < 1e-9)) {
                let message = "`axes(u, v, w)` takes three axes at right angles, the third of them u x v: write \
                               `axes(u, v, cross(u, v))`";
                return self.refuse(region, message);
            }
        }
        let step = self.towards(columns);
        Some(Value::rotation(self.frames.single(&mut self.graph, step)))
    }

    /// The axes as columns, with w = [v'.w, w'.u, u'.v] in the turned frame.
    fn towards(&mut self, columns: [Triple; 3]) -> Step {
        let Interpreter { graph, motion, .. } = self;
        let rates = columns.map(|axis| axis.map(|x| motion.of(graph, x)));
        let spin: Triple = std::array::from_fn(|k| triple::inner(graph, &rates[(k + 1) % 3], &columns[(k + 2) % 3]));
        let spin_rate = spin.map(|x| motion.of(graph, x));
        Step { matrix: triple::transposed(&columns), spin, spin_rate, quaternion: None }
    }

    /// The unit vector of an axis by its letter.
    fn unit(&mut self, letter: char) -> Option<Triple> {
        let index = AXES.iter().position(|axis| *axis == letter)?;
        Some(identity(&mut self.graph)[index])
    }

    /// A direction of length 1: a vector, or `x`, `y` or `z` unless that is another name.
    pub(in crate::model) fn axis(&mut self, expression: &Expression) -> Option<Triple> {
        if let Kind::Name(name) = &expression.kind {
            let text = plain(name);
            let letter = text.chars().next().filter(|letter| text.len() == 1 && AXES.contains(letter));
            if let Some(letter) = letter {
                if self.values.get_region(&text).is_none() {
                    return self.unit(letter);
                }
                if let Some(Value { shape: Shape::Scalar(_), .. }) = self.values.get(&text) {
                    let message =
                        format!("`{text}` is a name declared here, not an axis; write `[0, 0, 1]` or the like");
                    return self.refuse(expression.region, message);
                }
            }
        }
        let (direction, value) = self.spatial_value(expression)?;
        let components = self.resolved(&direction);
        level::position_level(expression, &components, "an axis", self)?;
        self.expect_in_place(value.measured(expression), &Dimension::none(), "an axis");
        self.check_unit(expression.region, &components)?;
        Some(components)
    }

    /// Refuses vectors that are not of length 1 for all values of their variables.
    fn check_unit(&mut self, region: Region, axis: &Triple) -> Option<()> {
        let square = triple::inner(&mut self.graph, axis, axis);
        let lengths: Vec<f64> = (1..=3).map(|k| self.sampled(square, k).sqrt()).collect();
        let is_unit = |length: &f64| (length - 1.0).abs() < 1e-9;
        if lengths.iter().all(is_unit) {
            return Some(());
        }
        let constant = self.dependences.of(&self.graph, square) == Dependence::NONE;
        let length = if constant { format!(", and this one has {}", lengths[0]) } else { String::new() };
        self.refuse(region, format!("an axis is a vector of length 1{length}; write `u/norm(u)`"))
    }

    /// The value of an expression at sample values of its variables, different for each `k`.
    pub(super) fn sampled(&self, expr: Expr, k: usize) -> f64 {
        let symbols = self.graph.symbols_of(&[expr]);
        let number = |symbol: Symbol| {
            let at = symbols.iter().position(|other| *other == symbol).unwrap_or(0);
            0.3 + ((7 * k + 3 * at + 1) as f64 * 0.618_033_988_75).fract()
        };
        evaluate(&self.graph, &[expr], number)[0]
    }

    /// I + sin(a) [n] + (1 - cos(a)) [n]^2 (Rodrigues), with w = a' n + sin(a) n' - (1 - cos(a)) n x n' in the turned
    /// frame.
    fn about(&mut self, axis: Triple, angle: Expr) -> Step {
        let Interpreter { graph, motion, .. } = self;
        let (sine, cosine) = (graph.call(Function::Sin, angle), graph.call(Function::Cos, angle));
        let one = graph.one();
        let versine = graph.sub(one, cosine);
        let matrix: Matrix = std::array::from_fn(|i| {
            std::array::from_fn(|j| {
                if i == j {
                    // c + (1 - c) n_i^2, which is c or 1 where n_i is 0 or 1.
                    let square = graph.integer_power(axis[i], 2);
                    let rest = graph.sub(one, square);
                    let terms = [graph.mul(cosine, rest), square];
                    return graph.sum(&terms);
                }
                let both = graph.product(&[versine, axis[i], axis[j]]);
                let turned = graph.mul(sine, axis[3 - i - j]);
                if (j + 3 - i) % 3 == 1 { graph.sub(both, turned) } else { graph.add(both, turned) }
            })
        });
        let rate = motion.of(graph, angle);
        let moving = axis.map(|x| motion.of(graph, x));
        let along = scaled(graph, rate, axis);
        let tilting = scaled(graph, sine, moving);
        let swept = cross(graph, &axis, &moving);
        let swept = scaled(graph, versine, swept);
        let sum = add(graph, along, tilting);
        let spin = sub(graph, sum, swept);
        let spin_rate = spin.map(|x| motion.of(graph, x));
        Step { matrix, spin, spin_rate, quaternion: None }
    }

    /// `transpose(R)`
    pub(in crate::model) fn transpose(&mut self, rotation: &Expression) -> Option<Value> {
        let (turn, bases) = self.turn(rotation)?;
        let inverse = Value::rotation(self.frames.inverse(&mut self.graph, turn));
        Some(Value { bases: bases.inverse(), ..inverse })
    }

    /// The attitude that a body is declared with, to the world's frame.
    pub(in crate::model) fn attitude_of(&mut self, rotation: &Expression) -> Option<Turn> {
        let (turn, bases) = self.turn(rotation)?;
        if let Some(basis @ Basis::Body(body)) = &bases.to {
            let message = format!(
                "this rotation R turns vectors into {basis}, but an attitude turns them into the world's frame: `attitude({body})*R`"
            );
            return self.refuse(rotation.region, message);
        }
        Some(turn)
    }

    /// `attitude(body)`
    pub(in crate::model) fn attitude(&mut self, body: &Ident, rotation: &Expression) -> Option<Value> {
        let (turn, _) = self.turn(rotation)?;
        Some(Value { bases: Bases::attitude(plain(body)), ..Value::rotation(turn) })
    }

    /// `R*S` or `R*v`.
    pub(in crate::model) fn turned(
        &mut self,
        region: Region,
        (turn, bases): (Turn, Bases),
        other: Value,
    ) -> Option<Value> {
        match other.shape {
            Shape::Rotation(second) => {
                let product = Value::rotation(self.frames.product(&mut self.graph, turn, second));
                Some(Value { bases: bases.then(other.bases), ..product })
            }
            Shape::Spatial(v) => {
                self.expect_basis(region, &other.bases.to, &bases.from)?;
                let shape = Shape::Spatial(self.frames.turned(&mut self.graph, turn, &v));
                Some(Value { shape, dimension: other.dimension, bases: Bases::of(bases.to) })
            }
            _ => self.refuse(
                region,
                format!("a rotation turns vectors of three components and other rotations, not {}", other.kind()),
            ),
        }
    }

    /// `angular_velocity(R)`, in world components.
    pub(in crate::model) fn angular_velocity(&mut self, rotation: &Expression) -> Option<Value> {
        let (turn, bases) = self.turn(rotation)?;
        let spin = self.frames.spin(turn);
        let dimension = Some(Dimension::none().over(&Dimension::time()));
        let shape = Shape::Spatial(Spatial::within(turn, spin));
        Some(Value { shape, dimension, bases: Bases::of(bases.to) })
    }
}
