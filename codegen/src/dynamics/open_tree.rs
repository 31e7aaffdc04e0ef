//! Trees of links without loops: each coordinate moves one link, and constraints keep the norms of quaternions alone.
//!
//! A link that moves freely, by three coordinates of its origin and a quaternion, has in its own frame the velocity v of its
//! origin and the angular velocity w,
//!
//! ```text
//! x' = S v,   q' = G' w/2 + (q.q'/q.q) q,   w = 2 G q'/q.q
//! ```
//!
//! (Wittenburg, Dynamics of Multibody Systems, 2nd ed., section 2.4). Six speeds in place of seven, with which the link's own
//! inertia is constant. Their rates give x'' and q'' back, with the part of q'' along q from the norm that is kept, and a load
//! on the coordinates is a force S' Q_x and a moment G Q_q/2; what it has along q is for the multiplier.

use super::constraints::Constraints;
use super::links::Link;
use super::rows::{Along, LoadRow};
use super::tmt::Tmt;
use super::variables::{Derivatives, Variables};
use crate::model::Model;
use crate::symbolic::{Expr, Graph};

/// What else moves a tree of links that is open.
pub struct OpenTree {
    /// The links that move freely.
    pub bases: Vec<FreeBase>,
    /// All rows of T but those of bodies fixed in links and the norms of quaternions; its mass matrix is diagonal.
    pub rest: Tmt,
}

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

impl OpenTree {
    /// Nothing for other mechanisms. `rows` are those of T but of bodies fixed in links.
    pub(super) fn derive(
        graph: &mut Graph,
        model: &Model,
        constraints: &Constraints,
        (variables, derivatives): (&Variables, &mut Derivatives),
        links: &[Link],
        mut rows: Vec<LoadRow>,
    ) -> Option<OpenTree> {
        let mut moved = vec![0; model.coordinates.len()];
        links.iter().flat_map(|link| &link.columns).for_each(|(coordinate, _)| moved[*coordinate] += 1);
        if moved.iter().any(|links| *links != 1) {
            return None;
        }
        let bases: Vec<FreeBase> =
            (0..links.len()).filter_map(|link| free_base(graph, model, constraints, links, link)).collect();
        if bases.len() != model.constraints.len() || bases.len() != model.norms.len() {
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
        is_diagonal.then_some(OpenTree { bases, rest })
    }
}

impl FreeBase {
    fn coordinates(&self) -> impl Iterator<Item = usize> + use<> {
        self.place.into_iter().chain(self.quaternion)
    }
}

fn free_base(
    graph: &mut Graph,
    model: &Model,
    constraints: &Constraints,
    links: &[Link],
    at: usize,
) -> Option<FreeBase> {
    let (link, declared) = (&links[at], &model.links[at]);
    let positions: Vec<Expr> = model.coordinates.iter().map(|c| graph.variable(c.position)).collect();
    let coordinate = |x: Expr| positions.iter().position(|position| *position == x);
    let ([Some(x), Some(y), Some(z)], None) = (link.offset[0].map(coordinate), link.before) else { return None };
    let components = declared.quaternion?;
    let [Some(a), Some(b), Some(c), Some(d)] = components.map(coordinate) else { return None };
    let two = graph.integer(2);
    let zero = graph.zero();
    let mut by_norm = vec![zero; positions.len()];
    for (at, component) in [a, b, c, d].into_iter().zip(components) {
        by_norm[at] = graph.mul(two, component);
    }
    let norm = constraints.jacobian.iter().position(|row| *row == by_norm)?;
    let is_kept = model.norm_constraints.contains(&norm) && model.constraints[norm].activity.is_none();
    let name = declared.bodies.first().map(|fixed| model.bodies[fixed.body].name.clone());
    let base = FreeBase { name: name.unwrap_or_default(), link: at, place: [x, y, z], quaternion: [a, b, c, d], norm };
    let mut moving: Vec<usize> = link.columns.iter().map(|(coordinate, _)| *coordinate).collect();
    let mut own: Vec<usize> = base.coordinates().collect();
    moving.sort_unstable();
    own.sort_unstable();
    (is_kept && moving == own).then_some(base)
}
