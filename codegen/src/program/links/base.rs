//! A link that moves freely, by the velocity of its origin and its angular velocity in its own frame.

use super::tree::{Column, LinkValues};
use super::triple::{Matrix, Triple, apply, cross, difference, dot, identity, inner, product, sum, transposed, zero};
use crate::dynamics::{EquationsOfMotion, FreeBase};
use crate::program::lower::Lowering;
use crate::program::values::{Input, Operation, Value, Values};

/// A free base at a state.
pub(in crate::program) struct Base<'a> {
    pub(super) declared: &'a FreeBase,
    /// Its first unknown.
    pub(super) first: usize,
    pub(super) turn: Matrix,
    pub(super) spin: Triple,
    /// The scalar part of its quaternion, and the rest.
    pub(super) quaternion: (Value, Triple),
    /// q.q
    pub(super) square: Value,
    /// Its reciprocal.
    pub(super) inverse_square: Value,
}

pub(super) fn speed(values: &mut Values, coordinate: usize) -> Value {
    values.add(Operation::Input(Input::Speed(coordinate)))
}

impl<'a> Base<'a> {
    pub(in crate::program) fn of(
        lowering: &mut Lowering,
        equations: &EquationsOfMotion,
        declared: &'a FreeBase,
        first: usize,
    ) -> Base<'a> {
        let link = &equations.model.links[declared.link];
        let turn = link.turn.map(|row| row.map(|x| lowering.lower(x)));
        let spin = link.spin.map(|x| lowering.lower(x));
        let values = &mut lowering.values;
        let [scalar, x, y, z] = declared.quaternion.map(|i| values.add(Operation::Input(Input::Position(i))));
        let squares = [scalar, x, y, z].map(|x| product(values, x, x));
        let square = sum(values, &squares);
        let one = values.constant(1.0);
        Base {
            declared,
            first,
            turn,
            spin,
            quaternion: (scalar, [x, y, z]),
            square,
            inverse_square: values.quotient(one, square),
        }
    }

    /// The rates of its coordinates, place and quaternion, for each of its velocities: x' = S v, q' = G' w/2.
    pub(in crate::program) fn rates(&self, values: &mut Values) -> [(Vec<usize>, Vec<Value>); 6] {
        let (place, quaternion) = (self.declared.place.to_vec(), self.declared.quaternion.to_vec());
        let (scalar, v) = &self.quaternion;
        let half = values.constant(0.5);
        std::array::from_fn(|at| match at < 3 {
            true => (place.clone(), (0..3).map(|i| self.turn[i][at]).collect()),
            false => {
                let i = at - 3;
                let (j, k) = ((i + 1) % 3, (i + 2) % 3);
                let mut row = [values.negate(v[i]); 4];
                row[1 + i] = *scalar;
                row[1 + j] = v[k];
                row[1 + k] = values.negate(v[j]);
                (quaternion.clone(), row.iter().map(|x| product(values, half, *x)).collect())
            }
        })
    }

    /// Its link with speeds of its own.
    pub(super) fn replace(&self, values: &mut Values, link: &mut LinkValues) {
        let (none, axes) = (zero(values), identity(values));
        let shifts = axes.map(|axis| (none, axis));
        let turns = axes.map(|axis| (axis, none));
        let columns = shifts.into_iter().chain(turns).enumerate();
        link.columns = columns.map(|(i, (spin, shift))| Column { coordinate: self.first + i, spin, shift }).collect();
        link.moves_freely = true;
        link.gravity = apply(values, &transposed(&link.turn), &link.gravity);
        link.turn = axes;
        link.offset = [none; 3];
        link.spin[1] = none;
    }

    /// The force and the moment in its frame that forces along its coordinates are: S' Q_x and G Q_q/2.
    pub(super) fn wrench(&self, values: &mut Values, forces: &[Value]) -> [Triple; 2] {
        self.wrench_of(values, (&self.turn, &self.quaternion), forces)
    }

    /// The same with S and q replaced, in which it is linear.
    pub(super) fn wrench_of(
        &self,
        values: &mut Values,
        (turn, (scalar, vector)): (&Matrix, &(Value, Triple)),
        forces: &[Value],
    ) -> [Triple; 2] {
        let place = self.declared.place.map(|i| forces[i]);
        let [first, rest @ ..] = self.declared.quaternion.map(|i| forces[i]);
        let half = values.constant(0.5);
        let swept = cross(values, vector, &rest);
        let moment = std::array::from_fn(|i| {
            let minus = values.negate(vector[i]);
            let turned = inner(values, &[(*scalar, rest[i]), (minus, first)]);
            let both = difference(values, turned, swept[i]);
            product(values, half, both)
        });
        [apply(values, &transposed(turn), &place), moment]
    }

    /// What forces along its quaternion leave for the multiplier of its norm: q'Q_q/(2 q.q).
    pub(super) fn multiplier(&self, values: &mut Values, forces: &[Value]) -> Value {
        let along = self.along_quaternion(values, self.declared.quaternion.map(|i| forces[i]));
        let half = values.constant(0.5);
        let along = product(values, along, self.inverse_square);
        product(values, half, along)
    }

    /// x'' and q'' from the accelerations in its frame, given C'' without accelerations of its norm.
    pub(super) fn accelerations(&self, values: &mut Values, convective: Value, solved: &mut [Value]) {
        let of = |first: usize| std::array::from_fn(|i| solved[self.first + first + i]);
        let place = apply(values, &self.turn, &of(0));
        let quaternion = self.quaternion_acceleration(values, convective, &of(3));
        let coordinates = self.declared.place.into_iter().chain(self.declared.quaternion);
        for (coordinate, acceleration) in coordinates.zip(place.into_iter().chain(quaternion)) {
            solved[coordinate] = acceleration;
        }
    }

    /// q'' = G' (w'/2 + w q.q'/q.q) - q c/(2 q.q), with c = 2 q'.q'.
    fn quaternion_acceleration(&self, values: &mut Values, convective: Value, turning: &Triple) -> [Value; 4] {
        let rates = self.declared.quaternion.map(|i| speed(values, i));
        let stretched = self.along_quaternion(values, rates);
        let stretched = product(values, stretched, self.inverse_square);
        let (half, minus_half) = (values.constant(0.5), values.constant(-0.5));
        let along = product(values, convective, self.inverse_square);
        let along = product(values, minus_half, along);
        let turning: Triple = std::array::from_fn(|i| inner(values, &[(half, turning[i]), (stretched, self.spin[i])]));
        quaternion_turned(values, &self.quaternion, along, &turning)
    }

    /// q'v.
    pub(super) fn along_quaternion(&self, values: &mut Values, [first, rest @ ..]: [Value; 4]) -> Value {
        let (scalar, vector) = &self.quaternion;
        let pairs = [(*scalar, first), (vector[0], rest[0]), (vector[1], rest[1]), (vector[2], rest[2])];
        inner(values, &pairs)
    }
}

/// G' t + q a.
pub(super) fn quaternion_turned(
    values: &mut Values,
    (scalar, vector): &(Value, Triple),
    along: Value,
    turning: &Triple,
) -> [Value; 4] {
    let (swept, carried) = (cross(values, vector, turning), dot(values, vector, turning));
    let first = product(values, *scalar, along);
    let first = difference(values, first, carried);
    let [x, y, z] = std::array::from_fn(|i| {
        let own = inner(values, &[(*scalar, turning[i]), (vector[i], along)]);
        sum(values, &[own, swept[i]])
    });
    [first, x, y, z]
}
