//! What the derivatives of an open tree's accelerations by its state need beside recursions.

use super::free_base::FreeBase;
use super::link::Link;
use super::tmt::Tmt;
use crate::model::triple::{Matrix, Triple};
use crate::model::{Dependence, Dependences, Model};
use crate::symbolic::{Differential, Expr, Graph, Symbol, substitute};

/// Derivatives by each coordinate, then by each speed.
pub struct OpenDerivatives {
    /// Of Q - M q'' of what moves beside links, at fixed accelerations: for each variable n of them.
    pub rest: [Vec<Vec<Expr>>; 2],
    /// Of each free base.
    pub bases: Vec<BaseDerivatives>,
}

/// Derivatives of the motion of a free base by the components of its quaternion.
pub struct BaseDerivatives {
    /// Of S.
    pub turn: [Matrix; 4],
    /// Of the angular velocity in its own frame, by the components and by their rates.
    pub spin: [[Triple; 4]; 2],
}

impl OpenDerivatives {
    /// Nothing where a joint is more than an axis that is fixed in its link, or where the state changes the weights.
    pub(super) fn derive(
        graph: &mut Graph,
        model: &Model,
        bases: &[FreeBase],
        links: &[Link],
        rest: &Tmt,
    ) -> Option<OpenDerivatives> {
        let mut dependences = model.dependences.clone();
        let state = Dependence::COORDINATE.or(Dependence::SPEED);
        if model.gravity.iter().flatten().any(|g| dependences.of(graph, *g).meets(state)) {
            return None;
        }
        let is_base = |at: usize| bases.iter().any(|base| base.link == at);
        let joints = links.iter().enumerate().filter(|(at, _)| !is_base(*at)).map(|(_, link)| link);
        if !joints.into_iter().all(|link| is_simple(graph, model, &mut dependences, link)) {
            return None;
        }
        let accelerations = model.accelerations(graph);
        let forces = rest.right_hand_side.iter().enumerate().map(|(i, force)| {
            let inertial = graph.mul(rest.mass_matrix[i][i], accelerations[i]);
            graph.sub(*force, inertial)
        });
        let forces: Vec<Expr> = forces.collect();
        let mut by_all = |symbols: Vec<Symbol>| -> Vec<Vec<Expr>> {
            let mut all = Vec::with_capacity(symbols.len());
            for symbol in symbols {
                let mut by = Differential::partial(graph, symbol);
                all.push(forces.iter().map(|force| by.of(graph, *force)).collect());
            }
            all
        };
        let coordinates = || model.coordinates.iter();
        let rest =
            [by_all(coordinates().map(|c| c.position).collect()), by_all(coordinates().map(|c| c.speed).collect())];
        let bases = bases.iter().map(|base| BaseDerivatives::derive(graph, model, base)).collect();
        Some(OpenDerivatives { rest, bases })
    }
}

impl BaseDerivatives {
    fn derive(graph: &mut Graph, model: &Model, base: &FreeBase) -> BaseDerivatives {
        let link = &model.links[base.link];
        let quaternion = base.quaternion.map(|i| &model.coordinates[i]);
        let mut partial = |symbol: Symbol| Differential::partial(graph, symbol);
        let mut by_position = quaternion.map(|c| partial(c.position));
        let mut by_speed = quaternion.map(|c| partial(c.speed));
        let turn = by_position.each_mut().map(|by| link.turn.map(|row| row.map(|x| by.of(graph, x))));
        let mut spin = |by: &mut Differential| link.spin.map(|x| by.of(graph, x));
        BaseDerivatives { turn, spin: [by_position.each_mut().map(&mut spin), by_speed.each_mut().map(&mut spin)] }
    }
}

/// Whether a link turns about one axis that is fixed in both frames, or slides along fixed directions, or is fixed. Turns about
/// different axes have columns that move.
fn is_simple(graph: &mut Graph, model: &Model, dependences: &mut Dependences, link: &Link) -> bool {
    let moving = Dependence::TIME.or(Dependence::COORDINATE).or(Dependence::SPEED).or(Dependence::INPUT);
    let mut is_fixed = |graph: &Graph, of: &[Expr]| of.iter().all(|x| !dependences.of(graph, *x).meets(moving));
    let keeps_direction = is_fixed(graph, link.turn.as_flattened());
    let keeps_place = is_fixed(graph, &link.offset[0]);
    let has_fixed_columns = link.columns.iter().all(|(_, column)| is_fixed(graph, column.as_flattened()));
    if !has_fixed_columns || !(keeps_direction || keeps_place) {
        return false;
    }
    // Nothing but the speeds of its coordinates moves it, and their axes stay.
    let still: Vec<_> = model.coordinates.iter().map(|c| (c.speed, graph.zero())).collect();
    let at_rest = substitute(graph, &[link.spin[0], link.offset[1]].concat(), &still);
    let convective = [link.spin[1], link.offset[2]].concat();
    at_rest.iter().chain(&convective).all(|x| graph.is_zero(*x))
}
