//! The derivatives of an open tree's accelerations and multipliers by its state.
//!
//! With M q'' = Q - h, any derivative of q'' solves M dq'' = d(Q - M q'' - h) at fixed q''. What the links take is
//! differentiated along the tree, and M is eliminated from the tips on. A body that moves freely notices neither its place nor
//! where it is turned, unless loads tell it, if weights fall with it: its columns come from those of its angular velocity.

use super::base::{Base, quaternion_turned, speed};
use super::coriolis::Derivatives;
use super::newton_euler::Motion;
use super::open::OpenTerms;
use super::triple::{Matrix, Triple, apply, difference, inner, product, sum};
use crate::dynamics::order::Multipliers;
use crate::dynamics::{BaseDerivatives, OpenDerivatives};
use crate::program::eliminate::{Factors, System, Unknown, factorise};
use crate::program::lower::Lowering;
use crate::program::notes::Notes;
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
    by_spin: [Vec<Value>; 3],
}

/// The variable of a column: a coordinate, or its speed.
#[derive(Clone, Copy)]
struct Variable {
    coordinate: usize,
    /// 0 for the coordinate itself, 1 for its speed.
    level: usize,
}

impl OpenTerms<'_> {
    /// Nothing where they are not wanted or a joint is not a simple one.
    pub(in crate::program) fn jacobian(&self, lowering: &mut Lowering, notes: &mut Notes) -> Option<StateDerivatives> {
        let derivatives = self.open.derivatives.as_ref()?;
        let eliminated = self.eliminated(lowering, notes)?;
        let forces = lowering.lower_all(&self.open.rest.right_hand_side);
        let (mut needed, zero) = (self.along_unknowns(&mut lowering.values, &forces), lowering.values.constant(0.0));
        for (needed, taken) in needed.iter_mut().zip(self.tree.forces(&mut lowering.values, None)) {
            *needed = difference(&mut lowering.values, *needed, taken);
        }
        let accelerations = eliminated.solve(&mut lowering.values, needed, zero);
        let along_tree = self.tree.derivatives(&mut lowering.values, &accelerations);
        let bases = self.bases.iter().zip(&derivatives.bases).map(|(base, derivatives)| {
            self.moving(lowering, &eliminated, &along_tree, (base, derivatives), &accelerations)
        });
        let bases: Vec<Moving> = bases.collect();
        let mut columns = [0, 1].map(|level| {
            let all = (0..self.equations.model.coordinates.len()).map(|coordinate| Variable { coordinate, level });
            let column = |of| self.column(lowering, &eliminated, derivatives, (&along_tree, &bases, &forces), of);
            all.map(column).collect::<Vec<_>>()
        });
        let mut pivots = eliminated.factors.pivots;
        pivots.extend(self.bases.iter().map(|base| (base.square, base.square)));
        let multipliers =
            columns.each_mut().map(|columns| columns.iter_mut().map(|(_, own)| std::mem::take(own)).collect());
        let accelerations = columns.map(|columns| columns.into_iter().map(|(own, _)| own).collect());
        Some(StateDerivatives { accelerations, multipliers, pivots })
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

    fn moving<'a>(
        &self,
        lowering: &mut Lowering,
        eliminated: &Eliminated,
        along_tree: &Derivatives,
        (base, derivatives): (&'a Base<'a>, &'a BaseDerivatives),
        accelerations: &[Value],
    ) -> Moving<'a> {
        let convective = lowering.lower(self.equations.constraints.convective[base.declared.norm]);
        let values = &mut lowering.values;
        let zero = values.constant(0.0);
        let by_spin = std::array::from_fn(|i| {
            let taken = along_tree.by_speeds[base.first + 3 + i].iter().map(|x| values.negate(*x)).collect();
            eliminated.solve(values, taken, zero)
        });
        let Motion { proper, .. } = along_tree.motions[base.declared.link];
        let rates = base.declared.quaternion.map(|i| speed(values, i));
        let stretched = base.along_quaternion(values, rates);
        let (stretched, minus_half) = (product(values, stretched, base.inverse_square), values.constant(-0.5));
        let along = product(values, convective, base.inverse_square);
        Moving {
            base,
            derivatives,
            proper,
            turning: std::array::from_fn(|i| accelerations[base.first + 3 + i]),
            stretched,
            along: product(values, minus_half, along),
            by_spin,
        }
    }

    /// The derivatives of q'' and of lambda by a variable.
    fn column(
        &self,
        lowering: &mut Lowering,
        eliminated: &Eliminated,
        derivatives: &OpenDerivatives,
        (along_tree, bases, forces): (&Derivatives, &[Moving], &[Value]),
        of: Variable,
    ) -> (Vec<Value>, Vec<Value>) {
        let beside = lowering.lower_all(&derivatives.rest[of.level][of.coordinate]);
        let mut needed = self.along_unknowns(&mut lowering.values, &beside);
        let own = bases.iter().find_map(|moving| Some((moving, moving.component(of)?)));
        let taken = if of.level == 0 { &along_tree.by_positions } else { &along_tree.by_speeds };
        for (needed, taken) in needed.iter_mut().zip(&taken[of.coordinate]) {
            *needed = difference(&mut lowering.values, *needed, *taken);
        }
        if let Some((moving, component)) = own.filter(|_| of.level == 0) {
            let turned = moving.wrench_turned(lowering, component, forces).concat();
            let values = &mut lowering.values;
            for (needed, turned) in needed[moving.base.first..].iter_mut().zip(turned) {
                *needed = sum(values, &[*needed, turned]);
            }
        }
        let zero = lowering.values.constant(0.0);
        let mut solved = match needed.iter().all(|x| lowering.values.is_zero(*x)) {
            true => needed,
            false => eliminated.solve(&mut lowering.values, needed, zero),
        };
        if let Some((moving, component)) = own {
            moving.add_turning(lowering, of, component, &mut solved);
        }
        let mut multipliers = vec![zero; self.equations.model.constraints.len()];
        for moving in bases {
            let component = own.filter(|(own, _)| std::ptr::eq(*own, moving)).map(|(_, component)| component);
            moving.finish(lowering, of, component, &mut solved);
            let values = &mut lowering.values;
            let norm = moving.base.declared.norm;
            multipliers[norm] = moving.base.multiplier(values, &beside);
            if let Some(component) = component.filter(|_| of.level == 0) {
                let stretched = moving.multiplier_stretched(values, component, forces);
                multipliers[norm] = sum(values, &[multipliers[norm], stretched]);
            }
        }
        solved.truncate(self.equations.model.coordinates.len());
        (solved, multipliers)
    }
}

impl Eliminated {
    /// The solution for forces along the unknowns, zero for what stands for nothing.
    fn solve(&self, values: &mut Values, forces: Vec<Value>, zero: Value) -> Vec<Value> {
        let mut all = vec![zero; forces.len()];
        let right_hand_side = self.unknowns.iter().map(|unknown| forces[*unknown]).collect();
        let constants = vec![zero; self.unknowns.len()];
        let solved = self.factors.solve(values, right_hand_side, &constants, &mut |_, _| ());
        self.unknowns.iter().zip(solved).for_each(|(unknown, x)| all[*unknown] = x);
        all
    }
}

impl Moving<'_> {
    /// Which component of its quaternion a variable is, or the rate of which.
    fn component(&self, of: Variable) -> Option<usize> {
        self.base.declared.quaternion.iter().position(|i| *i == of.coordinate)
    }

    /// What the wrench of loads on its coordinates changes by as it is turned.
    fn wrench_turned(&self, lowering: &mut Lowering, component: usize, forces: &[Value]) -> [Triple; 2] {
        let turn = lowered(lowering, &self.derivatives.turn[component]);
        let unit = unit(&mut lowering.values, component);
        self.base.wrench_of(&mut lowering.values, (&turn, &unit), forces)
    }

    /// -lambda (q.q)_q/q.q, and what stands with q in it.
    fn multiplier_stretched(&self, values: &mut Values, component: usize, forces: &[Value]) -> Value {
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
    fn add_turning(&self, lowering: &mut Lowering, of: Variable, component: usize, solved: &mut [Value]) {
        let spin = self.spin(lowering, of, component);
        let values = &mut lowering.values;
        for (i, solved) in solved.iter_mut().enumerate() {
            let turned = inner(values, &[0, 1, 2].map(|k| (self.by_spin[k][i], spin[k])));
            *solved = sum(values, &[*solved, turned]);
        }
    }

    /// x'' and q'' from the accelerations in its frame.
    fn finish(&self, lowering: &mut Lowering, of: Variable, component: Option<usize>, solved: &mut [Value]) {
        let base = self.base;
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
            let turn = lowered(lowering, &self.derivatives.turn[component]);
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

fn lowered(lowering: &mut Lowering, matrix: &[[crate::symbolic::Expr; 3]; 3]) -> Matrix {
    matrix.map(|row| row.map(|x| lowering.lower(x)))
}

/// A quaternion of one component.
fn unit(values: &mut Values, component: usize) -> (Value, Triple) {
    let [scalar, x, y, z] = std::array::from_fn(|i| values.constant(if i == component { 1.0 } else { 0.0 }));
    (scalar, [x, y, z])
}
