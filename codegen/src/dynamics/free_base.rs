//! Links that move freely in the world, by three coordinates of their origin and a quaternion.
//!
//! In its own frame such a link has the velocity v of its origin and the angular velocity w,
//!
//! ```text
//! x' = S v,   q' = G' w/2 + (q.q'/q.q) q,   w = 2 G q'/q.q
//! ```
//!
//! (Wittenburg, Dynamics of Multibody Systems, 2nd ed., section 2.4): six speeds in place of seven, with which the link's own
//! inertia is constant.

use super::constraints::Constraints;
use crate::model::Model;
use crate::symbolic::{Expr, Graph};

/// A link that moves freely in the world.
pub struct FreeBase {
    /// Its name: that of its first body.
    pub name: String,
    /// Which link.
    pub link: usize,
    /// The coordinates of its origin.
    pub place: [usize; 3],
    /// Those of its quaternion, the scalar part first.
    pub quaternion: [usize; 4],
    /// The constraint row that keeps q.q.
    pub norm: usize,
}

impl FreeBase {
    /// Its coordinates.
    pub fn coordinates(&self) -> impl Iterator<Item = usize> + use<> {
        self.place.into_iter().chain(self.quaternion)
    }
}

/// All of them.
pub(super) fn free_bases(graph: &mut Graph, model: &Model, constraints: &Constraints) -> Vec<FreeBase> {
    (0..model.links.len()).filter_map(|link| free_base(graph, model, constraints, link)).collect()
}

fn free_base(graph: &mut Graph, model: &Model, constraints: &Constraints, at: usize) -> Option<FreeBase> {
    let link = &model.links[at];
    let positions: Vec<Expr> = model.coordinates.iter().map(|c| graph.variable(c.position)).collect();
    let coordinate = |x: Expr| positions.iter().position(|position| *position == x);
    let ([Some(x), Some(y), Some(z)], None) = (link.offset.map(coordinate), link.before) else { return None };
    let components = link.quaternion?;
    let [Some(a), Some(b), Some(c), Some(d)] = components.map(coordinate) else { return None };
    let (two, zero) = (graph.integer(2), graph.zero());
    let mut by_norm = vec![zero; positions.len()];
    for (at, component) in [a, b, c, d].into_iter().zip(components) {
        by_norm[at] = graph.mul(two, component);
    }
    let norm = constraints.jacobian.iter().position(|row| *row == by_norm)?;
    let is_kept = model.norm_constraints.contains(&norm) && model.constraints[norm].activity.is_none();
    let name = link.bodies.first().map(|fixed| model.bodies[fixed.body].name.clone()).unwrap_or_default();
    is_kept.then_some(FreeBase { name, link: at, place: [x, y, z], quaternion: [a, b, c, d], norm })
}
