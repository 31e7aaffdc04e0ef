//! The terms of the equations of motion by recursions over links, and what else moves by its rows of T.

use super::tree::LinkTree;
use super::triple::zero;
use crate::dynamics::{Links, Tmt};
use crate::program::entries::mass_entries;
use crate::program::lower::Lowering;
use crate::program::values::{Input, Operation, Value};
use crate::symbolic::{Expr, Graph};

/// The equations of motion of a mechanism with links, but its constraints.
pub(in crate::program) struct LinkTerms<'a> {
    rest: &'a Tmt,
    tree: LinkTree,
}

impl<'a> LinkTerms<'a> {
    pub(in crate::program) fn of(lowering: &mut Lowering, links: &'a Links) -> LinkTerms<'a> {
        LinkTerms { rest: &links.rest, tree: LinkTree::of(lowering, links) }
    }

    /// The entries (i, j), j <= i, of the mass matrix that are not always zero; those that meet are to be added up.
    pub(in crate::program) fn mass_matrix(&self, graph: &Graph, lowering: &mut Lowering) -> Vec<(usize, usize, Value)> {
        let mut entries = mass_entries(lowering, graph, &self.rest.mass_matrix);
        entries.extend(self.tree.mass_matrix(&mut lowering.values));
        entries
    }

    /// Q - h, n.
    pub(in crate::program) fn right_hand_side(&self, lowering: &mut Lowering) -> Vec<Value> {
        let mut forces = lowering.lower_all(&self.rest.right_hand_side);
        for (force, needed) in forces.iter_mut().zip(self.tree.forces(&mut lowering.values, None)) {
            *force = lowering.values.sum(vec![(false, *force), (true, needed)]);
        }
        forces
    }

    /// M q'' + h - Q for given accelerations, n.
    pub(in crate::program) fn inverse_dynamics(&self, lowering: &mut Lowering) -> Vec<Value> {
        let given = (0..self.tree.coordinates).map(|i| lowering.values.add(Operation::Input(Input::Acceleration(i))));
        let given: Vec<Value> = given.collect();
        let mut forces = self.tree.forces(&mut lowering.values, Some(&given));
        for (i, force) in forces.iter_mut().enumerate() {
            let mut terms = vec![(false, *force), (true, lowering.lower(self.rest.right_hand_side[i]))];
            for (entry, acceleration) in self.rest.mass_matrix[i].iter().zip(&given) {
                let entry = lowering.lower(*entry);
                terms.push((false, lowering.values.product(vec![entry, *acceleration])));
            }
            *force = lowering.values.sum(terms);
        }
        forces
    }

    /// h, n: what the motion takes where nothing has weight and q'' = 0.
    pub(in crate::program) fn convective_forces(mut self, lowering: &mut Lowering) -> Vec<Value> {
        let weightless = zero(&mut lowering.values);
        self.tree.links.iter_mut().for_each(|link| link.gravity = weightless);
        let own = self.tree.forces(&mut lowering.values, None);
        self.with_rest(lowering, &self.rest.convective_forces, own)
    }

    /// Q, n.
    pub(in crate::program) fn generalized_forces(&self, lowering: &mut Lowering) -> Vec<Value> {
        let weights = self.tree.weights(&mut lowering.values);
        self.with_rest(lowering, &self.rest.generalized_forces, weights)
    }

    /// Q q': the power of loads and weights, where nothing depends on explicit time.
    pub(in crate::program) fn power(&self, lowering: &mut Lowering) -> Value {
        let forces = self.generalized_forces(lowering).into_iter().enumerate();
        let powers = forces.map(|(i, force)| {
            let speed = lowering.values.add(Operation::Input(Input::Speed(i)));
            (false, lowering.values.product(vec![force, speed]))
        });
        let powers = powers.collect();
        lowering.values.sum(powers)
    }

    /// Forces of links, and those of what else moves.
    fn with_rest(&self, lowering: &mut Lowering, rest: &[Expr], of_links: Vec<Value>) -> Vec<Value> {
        let rest = lowering.lower_all(rest);
        let both = rest.into_iter().zip(of_links);
        both.map(|(rest, own)| lowering.values.sum(vec![(false, rest), (false, own)])).collect()
    }
}
