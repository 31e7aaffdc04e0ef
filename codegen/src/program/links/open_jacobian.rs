//! The derivatives of an open tree's accelerations and multipliers by its state.
//!
//! With M q'' = Q - h, any derivative of q'' solves M dq'' = d(Q - M q'' - h) at fixed q''. What the links take is
//! differentiated along the tree, and M is eliminated from the tips on. A body that moves freely notices neither its place nor
//! where it is turned, unless loads tell it, if weights fall with it: its columns come from those of its angular velocity.

use super::base::{Base, quaternion_turned, speed};
use super::coriolis::Derivatives;
use super::open::OpenTerms;
use super::triple::{Triple, apply, difference, inner, product, sum};
use crate::dynamics::order::Multipliers;
use crate::dynamics::{BaseDerivatives, OpenDerivatives};
use crate::program::eliminate::{Factors, System, Unknown, factorise};
use crate::program::lower::Lowering;
use crate::program::notes::Notes;
use crate::program::right_hand_sides::solve_each;
use crate::program::values::{Value, Values};

/// Derivatives by the coordinates, then by their speeds.
pub(in crate::program) struct StateDerivatives {
    /// For each coordinate, of q''.
    pub(in crate::program) accelerations: [Vec<Vec<Value>>; 2],
    /// Of lambda.
    pub(in crate::program) multipliers: [Vec<Vec<Value>>; 2],
    /// The pivots of the elimination with the scale of each.
    pub(in crate::program) pivots: Vec<(Value, Value)>,
}

/// M, eliminated.
struct Eliminated {
    /// Which unknown stands at each place.
    unknowns: Vec<usize>,
    factors: Factors,
}

/// A free base with its motion.
struct Moving<'a> {
    base: &'a Base<'a>,
    derivatives: &'a BaseDerivatives,
    /// The acceleration of its origin less free fall, and the rate of its angular velocity, in its frame.
    proper: Triple,
    turning: Triple,
    /// q.q'/q.q, and what q'' has along q.
    stretched: Value,
    along: Value,
    /// For each component of the angular velocity the derivatives of all accelerations.
    by_spin: &'a [Vec<Value>],
}

/// The variable of a column: a coordinate, or its speed.
#[derive(Clone, Copy)]
struct Variable {
    coordinate: usize,
    /// 0 for the coordinate itself, 1 for its speed.
    level: usize,
}

/// What the columns come from.
struct Parts<'a> {
    derivatives: &'a OpenDerivatives,
    along_tree: Derivatives,
    /// Of what acts beside links, at the coordinates.
    forces: Vec<Value>,
    /// By all unknowns.
    accelerations: Vec<Value>,
}

impl OpenTerms<'_> {
    /// Nothing where they are not wanted or a joint is not a simple one.
    pub(in crate::program) fn jacobian(&self, lowering: &mut Lowering, notes: &mut Notes) -> Option<StateDerivatives> {
        let derivatives = self.open.derivatives.as_ref()?;
        let eliminated = self.eliminated(lowering, notes)?;
        let forces = lowering.lower_all(&self.open.rest.right_hand_side);
        let values = &mut lowering.values;
        let mut needed = self.along_unknowns(values, &forces);
        for (needed, taken) in needed.iter_mut().zip(self.tree.forces(values, None)) {
            *needed = difference(values, *needed, taken);
        }
        let accelerations = eliminated.solve(values, vec![needed]).concat();
        let along_tree = self.tree.derivatives(values, &accelerations);
        let parts = Parts { derivatives, along_tree, forces, accelerations };
        let variables = self.variables();
        let spins = self.bases.iter().flat_map(|base| base.first + 3..base.first + 6);
        let taken = spins.map(|spin| &parts.along_tree.by_speeds[spin]);
        let by_spins = taken.map(|taken| taken.iter().map(|x| lowering.values.negate(*x)).collect());
        let mut needed: Vec<Vec<Value>> = by_spins.collect();
        needed.extend(variables.iter().map(|of| self.needed(lowering, &parts, *of)));
        let mut solved = eliminated.solve(&mut lowering.values, needed);
        let by_variable = solved.split_off(3 * self.bases.len());
        let bases = self.bases.iter().zip(&derivatives.bases).zip(solved.chunks(3));
        let bases = bases
            .map(|((base, derivatives), by_spin)| Moving::of(self, lowering, &parts, (base, derivatives), by_spin));
        let bases: Vec<Moving> = bases.collect();
        let none = vec![vec![]; self.equations.model.coordinates.len()];
        let (mut accelerations, mut multipliers) = ([none.clone(), none.clone()], [none.clone(), none]);
        for (of, solved) in variables.into_iter().zip(by_variable) {
            let column = self.column(lowering, &parts, &bases, of, solved);
            [accelerations[of.level][of.coordinate], multipliers[of.level][of.coordinate]] = column;
        }
        let mut pivots = eliminated.factors.pivots;
        pivots.extend(self.bases.iter().map(|base| (base.square, base.square)));
        Some(StateDerivatives { accelerations, multipliers, pivots })
    }

    /// All of them, those of one limb beside each other, as their right-hand sides are zero elsewhere.
    fn variables(&self) -> Vec<Variable> {
        let mut coordinates: Vec<usize> = self.bases.iter().flat_map(|base| base.declared.coordinates()).collect();
        let joints = self.tree.links.iter().filter(|link| !link.moves_freely);
        coordinates.extend(joints.flat_map(|link| &link.columns).map(|column| column.coordinate));
        coordinates.into_iter().flat_map(|coordinate| [0, 1].map(|level| Variable { coordinate, level })).collect()
    }

    fn eliminated(&self, lowering: &mut Lowering, notes: &mut Notes) -> Option<Eliminated> {
        let unknowns = self.velocities();
        let place = |unknown: usize| unknowns.iter().position(|other| *other == unknown);
        let entries = self.mass_matrix(lowering).into_iter().filter_map(|(i, j, entry)| {
            let (i, j) = (place(i)?, place(j)?);
            Some((i.max(j), i.min(j), entry))
        });
        let system = System {
            entries: entries.collect(),
            unknowns: unknowns.iter().map(|_| Unknown::Coordinate).collect(),
            multipliers: Multipliers::Last,
        };
        let all = self.names();
        let names: Vec<String> = unknowns.iter().map(|unknown| all[*unknown].clone()).collect();
        let factors = factorise(&mut lowering.values, &system, &names, notes)?;
        Some(Eliminated { unknowns, factors })
    }

    /// Forces along the coordinates, and after them those along the velocities of free bases.
    fn along_unknowns(&self, values: &mut Values, forces: &[Value]) -> Vec<Value> {
        let mut all = forces.to_vec();
        for base in &self.bases {
            all.extend(base.wrench(values, forces).concat());
        }
        all
    }

    /// d(Q - M q'' - h) by a variable, but what comes with the angular velocity of a base.
    fn needed(&self, lowering: &mut Lowering, parts: &Parts, of: Variable) -> Vec<Value> {
        let Parts { derivatives, along_tree, forces, .. } = parts;
        let beside = lowering.lower_all(&derivatives.rest[of.level][of.coordinate]);
        let mut needed = self.along_unknowns(&mut lowering.values, &beside);
        let taken = if of.level == 0 { &along_tree.by_positions } else { &along_tree.by_speeds };
        for (needed, taken) in needed.iter_mut().zip(&taken[of.coordinate]) {
            *needed = difference(&mut lowering.values, *needed, *taken);
        }
        for (base, derivatives) in self.bases.iter().zip(&derivatives.bases).filter(|_| of.level == 0) {
            let Some(component) = of.component(base) else { continue };
            // Loads on its coordinates, as it is turned.
            let turn = derivatives.turn[component].map(|row| row.map(|x| lowering.lower(x)));
            let values = &mut lowering.values;
            let unit = unit(values, component);
            let turned = base.wrench_of(values, (&turn, &unit), forces).concat();
            for (needed, turned) in needed[base.first..].iter_mut().zip(turned) {
                *needed = sum(values, &[*needed, turned]);
            }
        }
        needed
    }

    /// The derivatives of q'' and of lambda by a variable, from what is solved for its right-hand side.
    fn column(
        &self,
        lowering: &mut Lowering,
        parts: &Parts,
        bases: &[Moving],
        of: Variable,
        mut solved: Vec<Value>,
    ) -> [Vec<Value>; 2] {
        let beside = lowering.lower_all(&parts.derivatives.rest[of.level][of.coordinate]);
        for moving in bases {
            moving.add_turning(lowering, of, &mut solved);
        }
        let mut multipliers = vec![lowering.values.constant(0.0); self.equations.model.constraints.len()];
        for moving in bases {
            moving.finish(lowering, of, &mut solved);
            let values = &mut lowering.values;
            let stretched = moving.multiplier_stretched(values, of, &parts.forces);
            let multiplier = moving.base.multiplier(values, &beside);
            multipliers[moving.base.declared.norm] = sum(values, &[multiplier, stretched]);
        }
        solved.truncate(self.equations.model.coordinates.len());
        [solved, multipliers]
    }
}

impl Eliminated {
    /// The solutions for forces along the unknowns, zero for what stands for nothing.
    fn solve(&self, values: &mut Values, mut forces: Vec<Vec<Value>>) -> Vec<Vec<Value>> {
        let zero = values.constant(0.0);
        let acts = |values: &Values, column: &[Value]| column.iter().any(|x| !values.is_zero(*x));
        let acting: Vec<usize> = (0..forces.len()).filter(|j| acts(values, &forces[*j])).collect();
        if acting.is_empty() {
            return forces;
        }
        let sides = acting.iter().map(|j| self.unknowns.iter().map(|unknown| forces[*j][*unknown]).collect());
        let solved = solve_each(values, &self.factors, sides.collect());
        for (j, solved) in acting.into_iter().zip(solved) {
            forces[j].fill(zero);
            self.unknowns.iter().zip(solved).for_each(|(unknown, x)| forces[j][*unknown] = x);
        }
        forces
    }
}

impl Variable {
    /// Which component of a base's quaternion it is, or the rate of which.
    fn component(&self, base: &Base) -> Option<usize> {
        base.declared.quaternion.iter().position(|i| *i == self.coordinate)
    }
}

impl<'a> Moving<'a> {
    fn of(
        terms: &OpenTerms,
        lowering: &mut Lowering,
        parts: &Parts,
        (base, derivatives): (&'a Base<'a>, &'a BaseDerivatives),
        by_spin: &'a [Vec<Value>],
    ) -> Moving<'a> {
        let convective = lowering.lower(terms.equations.constraints.convective[base.declared.norm]);
        let values = &mut lowering.values;
        let rates = base.declared.quaternion.map(|i| speed(values, i));
        let stretched = base.along_quaternion(values, rates);
        let (stretched, minus_half) = (product(values, stretched, base.inverse_square), values.constant(-0.5));
        let along = product(values, convective, base.inverse_square);
        Moving {
            base,
            derivatives,
            proper: parts.along_tree.motions[base.declared.link].proper,
            turning: std::array::from_fn(|i| parts.accelerations[base.first + 3 + i]),
            stretched,
            along: product(values, minus_half, along),
            by_spin,
        }
    }

    /// -lambda (q.q)_q/q.q, and what stands with q in it.
    fn multiplier_stretched(&self, values: &mut Values, of: Variable, forces: &[Value]) -> Value {
        let Some(component) = of.component(self.base).filter(|_| of.level == 0) else { return values.constant(0.0) };
        let (half, minus_two) = (values.constant(0.5), values.constant(-2.0));
        let multiplier = self.base.multiplier(values, forces);
        let own = product(values, half, forces[self.base.declared.quaternion[component]]);
        let doubled = product(values, minus_two, self.component_value(component));
        let carried = product(values, doubled, multiplier);
        let both = sum(values, &[own, carried]);
        product(values, both, self.base.inverse_square)
    }

    fn component_value(&self, component: usize) -> Value {
        let (scalar, [x, y, z]) = self.base.quaternion;
        [scalar, x, y, z][component]
    }

    /// The change of its angular velocity.
    fn spin(&self, lowering: &mut Lowering, of: Variable, component: usize) -> Triple {
        self.derivatives.spin[of.level][component].map(|x| lowering.lower(x))
    }

    /// What comes with its angular velocity.
    fn add_turning(&self, lowering: &mut Lowering, of: Variable, solved: &mut [Value]) {
        let Some(component) = of.component(self.base) else { return };
        let spin = self.spin(lowering, of, component);
        let values = &mut lowering.values;
        for (i, solved) in solved.iter_mut().enumerate() {
            let turned = inner(values, &[0, 1, 2].map(|k| (self.by_spin[k][i], spin[k])));
            *solved = sum(values, &[*solved, turned]);
        }
    }

    /// x'' and q'' from the accelerations in its frame.
    fn finish(&self, lowering: &mut Lowering, of: Variable, solved: &mut [Value]) {
        let (base, component) = (self.base, of.component(self.base));
        let own = |solved: &[Value], first: usize| std::array::from_fn(|i| solved[base.first + first + i]);
        let (pushed, turned): (Triple, Triple) = (own(solved, 0), own(solved, 3));
        let half = lowering.values.constant(0.5);
        let mut place = apply(&mut lowering.values, &base.turn, &pushed);
        let mut turning = turned.map(|x| product(&mut lowering.values, half, x));
        let mut along = lowering.values.constant(0.0);
        if let Some(component) = component {
            let spin = self.spin(lowering, of, component);
            let [stretched, drawn] = self.stretching(&mut lowering.values, of, component);
            along = drawn;
            let values = &mut lowering.values;
            turning = std::array::from_fn(|i| {
                let carried = inner(values, &[(stretched, base.spin[i]), (self.stretched, spin[i])]);
                sum(values, &[turning[i], carried])
            });
        }
        let mut quaternion = quaternion_turned(&mut lowering.values, &base.quaternion, along, &turning);
        if let Some(component) = component.filter(|_| of.level == 0) {
            let turn = self.derivatives.turn[component].map(|row| row.map(|x| lowering.lower(x)));
            let values = &mut lowering.values;
            let swung = apply(values, &turn, &self.proper);
            place = std::array::from_fn(|i| sum(values, &[place[i], swung[i]]));
            let turning =
                std::array::from_fn(|i| inner(values, &[(half, self.turning[i]), (self.stretched, base.spin[i])]));
            let unit = unit(values, component);
            let own = quaternion_turned(values, &unit, self.along, &turning);
            quaternion = std::array::from_fn(|i| sum(values, &[quaternion[i], own[i]]));
        }
        let coordinates = base.declared.place.into_iter().chain(base.declared.quaternion);
        coordinates.zip(place.into_iter().chain(quaternion)).for_each(|(i, x)| solved[i] = x);
    }

    /// The derivatives of q.q'/q.q, and of what q'' has along q, -q'.q'/q.q.
    fn stretching(&self, values: &mut Values, of: Variable, component: usize) -> [Value; 2] {
        let (minus_two, q) = (values.constant(-2.0), self.component_value(component));
        let rate = speed(values, of.coordinate);
        let [stretched, along] = match of.level {
            0 => {
                let doubled = product(values, minus_two, q);
                let carried = product(values, doubled, self.stretched);
                [sum(values, &[rate, carried]), product(values, doubled, self.along)]
            }
            _ => [q, product(values, minus_two, rate)],
        };
        [stretched, along].map(|x| product(values, x, self.base.inverse_square))
    }
}

/// A quaternion of one component.
fn unit(values: &mut Values, component: usize) -> (Value, Triple) {
    let [scalar, x, y, z] = std::array::from_fn(|i| values.constant(if i == component { 1.0 } else { 0.0 }));
    (scalar, [x, y, z])
}
