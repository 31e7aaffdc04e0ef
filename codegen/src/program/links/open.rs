//! Open trees, with what moves freely by its velocity in its own frame.

use super::base::{Base, speed};
use super::forward::{Beside, Forward, Joints};
use super::tree::LinkTree;
use super::triple::{apply, dot, product, sum, transposed};
use crate::dynamics::{EquationsOfMotion, Links, OpenTree};
use crate::program::entries::mass_entries;
use crate::program::lower::Lowering;
use crate::program::notes::Notes;
use crate::program::values::Value;

/// The equations of motion of an open tree. Its unknowns are the coordinates, and after them for each free base the velocity of
/// its origin and its angular velocity; the coordinates of free bases stand for nothing.
pub(in crate::program) struct OpenTerms<'a> {
    pub(super) equations: &'a EquationsOfMotion,
    pub(super) open: &'a OpenTree,
    pub(super) tree: LinkTree,
    pub(super) bases: Vec<Base<'a>>,
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
        let mut bases = Vec::with_capacity(equations.free_bases.len());
        for declared in &equations.free_bases {
            let base = Base::of(lowering, equations, declared, tree.coordinates);
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
            multipliers[base.declared.norm] = base.multiplier(&mut lowering.values, &beside.forces);
            let wrench = base.wrench(&mut lowering.values, &beside.forces);
            beside.forces.extend(wrench.concat());
            beside.inertias.extend([none; 6]);
        }
        let names = self.names();
        let forward = self.tree.forward(&mut lowering.values, beside, joints, (&names, notes));
        let Forward { mut accelerations, mut pivots } = forward;
        for base in &self.bases {
            let convective = lowering.lower(self.equations.constraints.convective[base.declared.norm]);
            base.accelerations(&mut lowering.values, convective, &mut accelerations);
            // Without a quaternion no direction is known.
            pivots.push((base.square, base.square));
        }
        accelerations.truncate(self.equations.model.coordinates.len());
        Solved { accelerations, multipliers, pivots }
    }

    /// The entries (i, j), j <= i, of the mass matrix that are not always zero, by unknowns; those that meet are to be added up.
    pub(in crate::program) fn mass_matrix(&self, lowering: &mut Lowering) -> Vec<(usize, usize, Value)> {
        let mut entries = mass_entries(lowering, &self.equations.graph, &self.open.rest.mass_matrix);
        entries.extend(self.tree.mass_matrix(&mut lowering.values));
        entries
    }

    /// The unknown of each velocity, in the order of coordinates.
    pub(in crate::program) fn velocities(&self) -> Vec<usize> {
        let n = self.equations.model.coordinates.len();
        let mut unknowns: Vec<Option<usize>> = (0..n).map(Some).collect();
        for Base { declared, first, .. } in &self.bases {
            let [scalar, vector @ ..] = declared.quaternion;
            unknowns[scalar] = None;
            declared.place.into_iter().chain(vector).enumerate().for_each(|(i, of)| unknowns[of] = Some(first + i));
        }
        unknowns.into_iter().flatten().collect()
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

    pub(super) fn names(&self) -> Vec<String> {
        let coordinates = self.equations.model.coordinates.iter().map(|c| c.name.clone());
        let parts = ["velocity_x", "velocity_y", "velocity_z", "spin_x", "spin_y", "spin_z"];
        let bases = self.bases.iter().map(|base| &base.declared.name);
        coordinates.chain(bases.flat_map(|name| parts.map(|part| format!("{name}_{part}")))).collect()
    }
}
