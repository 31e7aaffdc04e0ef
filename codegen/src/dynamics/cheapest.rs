//! Which parts of long sums get variables of their own.
//!
//! In a chain the position of each body is that of the one before and a little more. Written in coordinates alone each
//! row of T depends on all coordinates before it, and T_q' M T_q costs the cube of their number. With the positions
//! in between as variables y = phi(y, q, t), each row depends on a few variables, and elimination from the tip costs
//! as much as there are bodies. Which sums are worth it is counted, not declared.

use super::formulation::Formulation;
use super::parts::Candidates;
use super::rows::LoadRow;
use crate::model::Model;
use crate::symbolic::Graph;

/// With fewer coordinates the equations are short in any form.
const FEWEST_COORDINATES: usize = 5;

/// The least number of coordinates in a candidate for an intermediate.
const DEPTHS: [usize; 4] = [2, 3, 4, 6];

/// The cheapest way to write rows and constraints.
pub(super) fn cheapest(graph: &mut Graph, model: &Model, rows: Vec<LoadRow>) -> Formulation {
    let plain = Formulation::without(model, rows);
    // In chains of spatial bodies velocities are carried from frame to frame, which is as short.
    if model.coordinates.len() < FEWEST_COORDINATES || model.dimension == 3 {
        return plain;
    }
    let mut best = (plain.cost(graph, model), None);
    let candidates = Candidates::of(graph, model, &plain);
    for depth in DEPTHS {
        let Some(formulation) = candidates.formulation(graph, model, &plain, depth) else { continue };
        let cost = formulation.cost(graph, model);
        if cost < best.0 {
            best = (cost, Some(formulation));
        }
    }
    best.1.unwrap_or(plain)
}
