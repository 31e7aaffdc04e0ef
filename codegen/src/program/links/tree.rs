//! A tree of links in values.

use super::triple::{Matrix, Triple};
use crate::dynamics::{Link, Links, MassDistribution};
use crate::program::lower::Lowering;
use crate::program::values::Value;
use crate::symbolic::Expr;

/// Links of values, as [`Links`] has them of expressions.
pub(super) struct LinkTree {
    /// Each after the one before it.
    pub(super) links: Vec<LinkValues>,
    /// How many coordinates there are.
    pub(super) coordinates: usize,
}

pub(super) struct LinkValues {
    pub(super) before: Option<usize>,
    /// Whether it goes by its velocity, with six columns.
    pub(super) moves_freely: bool,
    /// g in the frame before it, if that is at rest.
    pub(super) gravity: Triple,
    /// S, from its own frame to the one before.
    pub(super) turn: Matrix,
    /// Its angular velocity in the frame before, in its own, with the convective part of its rate.
    pub(super) spin: [Triple; 2],
    /// Its origin in the frame before, with its velocity there and the convective part of its acceleration.
    pub(super) offset: [Triple; 3],
    /// The derivatives of the angular velocity and of the origin's velocity by the speed of a coordinate.
    pub(super) columns: Vec<Column>,
    pub(super) mass: Mass,
}

/// How the speed of a coordinate moves a link in the frame before.
pub(super) struct Column {
    pub(super) coordinate: usize,
    /// Of the angular velocity, in its own frame.
    pub(super) spin: Triple,
    /// Of the origin's velocity, in the frame before.
    pub(super) shift: Triple,
}

/// A mass distribution about an origin: M, h and P.
#[derive(Clone)]
pub(super) struct Mass {
    pub(super) mass: Value,
    pub(super) first: Triple,
    pub(super) second: Matrix,
}

impl LinkTree {
    pub(super) fn of(lowering: &mut Lowering, links: &Links) -> LinkTree {
        let (gravity, coordinates) = (triple(lowering, &links.gravity), links.rest.mass_matrix.len());
        LinkTree { links: links.links.iter().map(|own| link(lowering, gravity, own)).collect(), coordinates }
    }
}

fn link(lowering: &mut Lowering, gravity: Triple, link: &Link) -> LinkValues {
    let columns = link.columns.iter().map(|(coordinate, [spin, shift])| Column {
        coordinate: *coordinate,
        spin: triple(lowering, spin),
        shift: triple(lowering, shift),
    });
    LinkValues {
        before: link.before,
        moves_freely: false,
        gravity,
        columns: columns.collect(),
        turn: link.turn.each_ref().map(|row| triple(lowering, row)),
        spin: link.spin.each_ref().map(|part| triple(lowering, part)),
        offset: link.offset.each_ref().map(|part| triple(lowering, part)),
        mass: mass(lowering, &link.mass),
    }
}

fn mass(lowering: &mut Lowering, own: &MassDistribution) -> Mass {
    Mass {
        mass: lowering.lower(own.mass),
        first: triple(lowering, &own.first),
        second: own.second.each_ref().map(|row| triple(lowering, row)),
    }
}

fn triple(lowering: &mut Lowering, exprs: &[Expr; 3]) -> Triple {
    exprs.map(|expr| lowering.lower(expr))
}
