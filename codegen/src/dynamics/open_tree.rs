//! Trees of links without loops: each coordinate moves one link, and constraints keep the norms of quaternions alone.
//!
//! What moves freely can do so by its velocities there. Their rates give x'' and q'' back, with the part of q'' along q from the
//! norm that is kept, and a load on the coordinates is a force S' Q_x and a moment G Q_q/2; what it has along q is for the
//! multiplier.

use super::free_base::FreeBase;
use super::link::Link;
use super::open_derivatives::OpenDerivatives;
use super::rows::{Along, LoadRow};
use super::sensitivity;
use super::tmt::Tmt;
use super::variables::{Derivatives, Variables};
use crate::model::Model;
use crate::symbolic::Graph;

/// What else moves a tree of links that is open.
pub struct OpenTree {
    /// All rows of T but those of bodies fixed in links and the norms of quaternions; its mass matrix is diagonal.
    pub rest: Tmt,
    /// What its derivatives by the state need, if they are wanted and its joints are simple ones.
    pub derivatives: Option<OpenDerivatives>,
}

impl OpenTree {
    /// Nothing for other mechanisms. `rows` are those of T but of bodies fixed in links.
    pub(super) fn derive(
        graph: &mut Graph,
        model: &Model,
        bases: &[FreeBase],
        (variables, derivatives): (&Variables, &mut Derivatives),
        links: &[Link],
        mut rows: Vec<LoadRow>,
    ) -> Option<OpenTree> {
        let mut moved = vec![0; model.coordinates.len()];
        links.iter().flat_map(|link| &link.columns).for_each(|(coordinate, _)| moved[*coordinate] += 1);
        let is_alone = |base: &FreeBase| links[base.link].columns.len() == base.coordinates().count();
        let counts = [model.constraints.len(), model.norms.len()];
        if moved.iter().any(|links| *links != 1) || counts != [bases.len(); 2] || !bases.iter().all(is_alone) {
            return None;
        }
        let zero = graph.zero();
        for row in &mut rows {
            if model.norms.iter().any(|norm| row.along == Along::Position(norm.square)) {
                row.inertia = zero;
            }
        }
        let rest = Tmt::derive(graph, variables, derivatives, rows);
        let of_bases: Vec<usize> = bases.iter().flat_map(FreeBase::coordinates).collect();
        let is_diagonal = rest.mass_matrix.iter().enumerate().all(|(i, row)| {
            let mut entries = row.iter().enumerate().filter(|(_, entry)| !graph.is_zero(**entry));
            entries.all(|(j, _)| i == j && !of_bases.contains(&i))
        });
        if !is_diagonal {
            return None;
        }
        let wanted = sensitivity::is_wanted_by_state(model);
        let derivatives = wanted.then(|| OpenDerivatives::derive(graph, model, bases, links, &rest)).flatten();
        Some(OpenTree { rest, derivatives })
    }
}
