//! Open trees, with what moves freely by its velocity in its own frame.

use super::forward::{Beside, Forward, Joints};
use super::tree::{Column, LinkTree, LinkValues};
use super::triple::{Triple, apply, cross, difference, dot, identity, inner, product, sum, transposed, zero};
use crate::dynamics::{EquationsOfMotion, FreeBase, Links, OpenTree};
use crate::program::lower::Lowering;
use crate::program::notes::Notes;
use crate::program::values::{Input, Operation, Value, Values};

/// The equations of motion of an open tree. Its unknowns are the coordinates, and after them for each free base the velocity of
/// its origin and its angular velocity; the coordinates of free bases stand for nothing.
pub(in crate::program) struct OpenTerms<'a> {
    equations: &'a EquationsOfMotion,
    open: &'a OpenTree,
    tree: LinkTree,
    bases: Vec<Base<'a>>,
}

/// A free base at a state.
struct Base<'a> {
    declared: &'a FreeBase,
    /// Its first unknown.
    first: usize,
    turn: [Triple; 3],
    spin: Triple,
    /// The scalar part of its quaternion, and the rest.
    quaternion: (Value, Triple),
    /// 1/q.q
    inverse_square: Value,
}

/// What `dynamics` solves for.
pub(in crate::program) struct Solved {
    pub(in crate::program) accelerations: Vec<Value>,
    pub(in crate::program) multipliers: Vec<Value>,
    pub(in crate::program) pivots: Vec<(Value, Value)>,
}

impl<'a> OpenTerms<'a> {
    /// Nothing where the tree is not open.
    pub(in crate::program) fn of(
        lowering: &mut Lowering,
        equations: &'a EquationsOfMotion,
        links: &'a Links,
    ) -> Option<OpenTerms<'a>> {
        let open = links.open.as_ref()?;
        let mut tree = LinkTree::of(lowering, links);
        let mut bases = Vec::with_capacity(open.bases.len());
        for declared in &open.bases {
            let base = Base::of(lowering, declared, tree.coordinates, &tree.links[declared.link]);
            base.replace(&mut lowering.values, &mut tree.links[declared.link]);
            tree.coordinates += 6;
            bases.push(base);
        }
        Some(OpenTerms { equations, open, tree, bases })
    }

    /// q'' and lambda.
    pub(in crate::program) fn solve(&self, lowering: &mut Lowering, joints: Joints, notes: &mut Notes) -> Solved {
        let forces = lowering.lower_all(&self.open.rest.right_hand_side);
        let inertias = self.open.rest.mass_matrix.iter().enumerate().map(|(i, row)| lowering.lower(row[i]));
        let mut beside = Beside { inertias: inertias.collect(), forces };
        let none = lowering.values.constant(0.0);
        let mut multipliers = vec![none; self.equations.model.constraints.len()];
        for base in &self.bases {
            let [along, wrench @ ..] = base.wrench(&mut lowering.values, &beside.forces);
            multipliers[base.declared.norm] = along[0];
            beside.forces.extend(wrench.concat());
            beside.inertias.extend([none; 6]);
        }
        let names = self.names();
        let forward = self.tree.forward(&mut lowering.values, beside, joints, (&names, notes));
        let Forward { mut accelerations, pivots } = forward;
        for base in &self.bases {
            let convective = lowering.lower(self.equations.constraints.convective[base.declared.norm]);
            base.accelerations(&mut lowering.values, convective, &mut accelerations);
        }
        accelerations.truncate(self.equations.model.coordinates.len());
        Solved { accelerations, multipliers, pivots }
    }

    /// Q q': the power of loads and weights, where nothing depends on explicit time.
    pub(in crate::program) fn power(&self, lowering: &mut Lowering) -> Value {
        let weights = self.tree.weights(&mut lowering.values);
        let forces = lowering.lower_all(&self.open.rest.generalized_forces);
        let values = &mut lowering.values;
        let mut powers = Vec::new();
        for (i, force) in forces.into_iter().enumerate() {
            let both = sum(values, &[force, weights[i]]);
            let speed = speed(values, i);
            powers.push(product(values, both, speed));
        }
        for base in &self.bases {
            let velocity = base.declared.place.map(|i| speed(values, i));
            let velocity = apply(values, &transposed(&base.turn), &velocity);
            let of = |first: usize| std::array::from_fn(|i| weights[base.first + first + i]);
            powers.extend([dot(values, &of(0), &velocity), dot(values, &of(3), &base.spin)]);
        }
        sum(values, &powers)
    }

    fn names(&self) -> Vec<String> {
        let coordinates = self.equations.model.coordinates.iter().map(|c| c.name.clone());
        let parts = ["velocity_x", "velocity_y", "velocity_z", "spin_x", "spin_y", "spin_z"];
        let bases = self.bases.iter().map(|base| &base.declared.name);
        coordinates.chain(bases.flat_map(|name| parts.map(|part| format!("{name}_{part}")))).collect()
    }
}

fn speed(values: &mut Values, coordinate: usize) -> Value {
    values.add(Operation::Input(Input::Speed(coordinate)))
}

impl<'a> Base<'a> {
    fn of(lowering: &mut Lowering, declared: &'a FreeBase, first: usize, link: &LinkValues) -> Base<'a> {
        let values = &mut lowering.values;
        let [scalar, x, y, z] = declared.quaternion.map(|i| values.add(Operation::Input(Input::Position(i))));
        let squares = [scalar, x, y, z].map(|x| product(values, x, x));
        let square = sum(values, &squares);
        let one = values.constant(1.0);
        Base {
            declared,
            first,
            turn: link.turn,
            spin: link.spin[0],
            quaternion: (scalar, [x, y, z]),
            inverse_square: values.quotient(one, square),
        }
    }

    /// Its link with speeds of its own.
    fn replace(&self, values: &mut Values, link: &mut LinkValues) {
        let (none, axes) = (zero(values), identity(values));
        let shifts = axes.map(|axis| (none, axis));
        let turns = axes.map(|axis| (axis, none));
        let columns = shifts.into_iter().chain(turns).enumerate();
        link.columns = columns.map(|(i, (spin, shift))| Column { coordinate: self.first + i, spin, shift }).collect();
        link.gravity = apply(values, &transposed(&link.turn), &link.gravity);
        link.turn = axes;
        link.offset = [none; 3];
        link.spin[1] = none;
    }

    /// What forces along its coordinates are: the multiplier of the norm, in front, then force and moment in its frame.
    fn wrench(&self, values: &mut Values, forces: &[Value]) -> [Triple; 3] {
        let place = self.declared.place.map(|i| forces[i]);
        let [first, rest @ ..] = self.declared.quaternion.map(|i| forces[i]);
        let (scalar, vector) = &self.quaternion;
        let half = values.constant(0.5);
        let swept = cross(values, vector, &rest);
        let moment = std::array::from_fn(|i| {
            let minus = values.negate(vector[i]);
            let turned = inner(values, &[(*scalar, rest[i]), (minus, first)]);
            let both = difference(values, turned, swept[i]);
            product(values, half, both)
        });
        let parts = [product(values, *scalar, first), dot(values, vector, &rest)];
        let along = sum(values, &parts);
        let along = product(values, along, self.inverse_square);
        let multiplier = product(values, half, along);
        [[multiplier; 3], apply(values, &transposed(&self.turn), &place), moment]
    }

    /// x'' and q'' from the accelerations in its frame.
    fn accelerations(&self, values: &mut Values, convective: Value, solved: &mut [Value]) {
        let of = |first: usize| std::array::from_fn(|i| solved[self.first + first + i]);
        let (shifting, turning): (Triple, Triple) = (of(0), of(3));
        let place = apply(values, &self.turn, &shifting);
        let (scalar, vector) = &self.quaternion;
        let rates = self.declared.quaternion.map(|i| speed(values, i));
        let stretched = [(*scalar, rates[0]), (vector[0], rates[1]), (vector[1], rates[2]), (vector[2], rates[3])];
        let stretched = inner(values, &stretched);
        let stretched = product(values, stretched, self.inverse_square);
        let minus_half = values.constant(-0.5);
        let along = product(values, convective, self.inverse_square);
        let along = product(values, minus_half, along);
        let half = values.constant(0.5);
        let turning: Triple = std::array::from_fn(|i| inner(values, &[(half, turning[i]), (stretched, self.spin[i])]));
        let swept = cross(values, vector, &turning);
        let carried = dot(values, vector, &turning);
        let first = product(values, *scalar, along);
        let first = difference(values, first, carried);
        let rest: Triple = std::array::from_fn(|i| {
            let own = inner(values, &[(*scalar, turning[i]), (vector[i], along)]);
            sum(values, &[own, swept[i]])
        });
        let coordinates = self.declared.place.into_iter().chain(self.declared.quaternion);
        for (coordinate, acceleration) in coordinates.zip(place.into_iter().chain([first]).chain(rest)) {
            solved[coordinate] = acceleration;
        }
    }
}
