//! Bodies of space as a tree of links, with their inertial parameters regrouped.
//!
//! A link's mass distribution is its mass M, its first moment h and its second moments P about its origin. What the motion
//! of a joint cannot tell apart moves to the link before: all of it, if the link is fixed there; P, where it moves without
//! turning; and where it turns about an axis k, the mass, h_k and P_kk, as a rod along the axis does not notice the turning
//! (Gautier, J. Robotic Systems 8, 1991; Khalil and Dombre, Modeling, Identification and Control of Robots, 2002, section
//! 9.4.2; they write inertias in place of second moments, which takes two entries where P_kk is one). What reaches the world
//! is at rest. Forces along the coordinates stay what they are.

use super::free_base::FreeBase;
use super::link::Link;
use super::mass_distribution::MassDistribution;
use super::open_tree::OpenTree;
use super::rows::load_rows_besides;
use super::tmt::Tmt;
use super::variables::{Derivatives, Variables};
use crate::model::triple::Triple;
use crate::model::{Dependence, Dependences, FixedBody, Model};
use crate::symbolic::{Differential, Expr, Graph, substitute};

/// A tree of links, and what else moves.
pub struct Links {
    /// Each after those before it.
    pub links: Vec<Link>,
    /// g in the world.
    pub gravity: Triple,
    /// All rows of T but those of bodies fixed in links.
    pub rest: Tmt,
    /// The same with what moves freely by its velocity, if the tree is open.
    pub open: Option<OpenTree>,
}

impl Links {
    /// Nothing where no body is fixed in a link.
    pub(super) fn derive(
        graph: &mut Graph,
        model: &Model,
        variables: &Variables,
        derivatives: &mut Derivatives,
        bases: &[FreeBase],
    ) -> Option<Links> {
        if model.links.is_empty() {
            return None;
        }
        let zero = graph.zero();
        let mut motion = model.time_derivative(graph);
        let mut links: Vec<Link> = model.links.iter().map(|link| moving(graph, model, &mut motion, link)).collect();
        regroup(graph, &mut model.dependences.clone(), &mut links);
        let fixed = model.links.iter().flat_map(|link| &link.bodies).map(|fixed| fixed.body).collect::<Vec<_>>();
        let rows = load_rows_besides(graph, model, &fixed);
        let open = OpenTree::derive(graph, model, bases, (variables, derivatives), &links, rows.clone());
        let rest = Tmt::derive(graph, variables, derivatives, rows);
        let gravity = model.gravity.as_ref().map_or([zero; 3], |gravity| [gravity[0], gravity[1], gravity[2]]);
        Some(Links { links, gravity, rest, open })
    }
}

impl Links {
    /// Whether derivatives by the state come from recursions.
    pub(super) fn have_derivatives(&self) -> bool {
        self.open.as_ref().is_some_and(|open| open.derivatives.is_some())
    }
}

/// A link with its rates, and the mass of its own bodies.
fn moving(graph: &mut Graph, model: &Model, motion: &mut Differential, link: &crate::model::Link) -> Link {
    let zero = graph.zero();
    let still: Vec<_> = model.coordinates.iter().map(|c| (c.acceleration, zero)).collect();
    let offset_rate = link.offset.map(|x| motion.of(graph, x));
    let offset_acceleration = offset_rate.map(|x| motion.of(graph, x));
    let mut convective = |of: Triple| of.map(|x| substitute(graph, &[x], &still)[0]);
    let (spin_rate, offset_acceleration) = (convective(link.spin_rate), convective(offset_acceleration));
    let mut columns = Vec::new();
    for (j, coordinate) in model.coordinates.iter().enumerate() {
        let mut by = Differential::partial(graph, coordinate.speed);
        let column = [link.spin, offset_rate].map(|rate| rate.map(|x| by.of(graph, x)));
        if column.iter().flatten().any(|x| !graph.is_zero(*x)) {
            columns.push((j, column));
        }
    }
    let mut mass = MassDistribution::none(graph);
    for FixedBody { body, centre } in &link.bodies {
        mass.add_body(graph, &model.bodies[*body], *centre);
    }
    Link {
        before: link.before,
        turn: link.turn,
        spin: [link.spin, spin_rate],
        offset: [link.offset, offset_rate, offset_acceleration],
        columns,
        mass,
    }
}

/// From the tips to the world.
fn regroup(graph: &mut Graph, dependences: &mut Dependences, links: &mut [Link]) {
    let anything = Dependence::TIME.or(Dependence::COORDINATE).or(Dependence::SPEED).or(Dependence::INPUT);
    for at in (0..links.len()).rev() {
        let link = &links[at];
        let mut is_fixed = |x: &Expr| !dependences.of(graph, *x).meets(anything);
        let keeps_direction = link.turn.iter().flatten().all(&mut is_fixed);
        let keeps_place = link.offset[0].iter().all(&mut is_fixed);
        let turns = link.spin[0].map(|x| !graph.is_zero(x));
        let none = MassDistribution::none(graph);
        let moved = match turns {
            _ if keeps_direction && keeps_place => Some(std::mem::replace(&mut links[at].mass, none)),
            _ if keeps_direction => {
                let second = std::mem::replace(&mut links[at].mass.second, none.second);
                Some(MassDistribution { second, ..none })
            }
            _ if !keeps_place => None,
            [true, false, false] | [false, true, false] | [false, false, true] => {
                let axis = turns.iter().position(|turns| *turns).unwrap_or(0);
                link.turns_about(graph, axis).then(|| links[at].mass.take_rod(graph, axis))
            }
            _ => None,
        };
        let (Some(moved), Some(before)) = (moved, links[at].before) else { continue };
        let seen = moved.seen_from(graph, &links[at].turn, &links[at].offset[0]);
        links[before].mass.add(graph, &seen);
    }
}
