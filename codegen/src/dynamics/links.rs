//! Bodies of space as a tree of links, with their inertial parameters regrouped.
//!
//! A link's mass distribution is its mass M, its first moment h and its second moments P about its origin. What the motion
//! of a joint cannot tell apart moves to the link before: all of it, if the link is fixed there; P, where it moves without
//! turning; and where it turns about an axis k, the mass, h_k and P_kk, as a rod along the axis does not notice the turning
//! (Gautier, J. Robotic Systems 8, 1991; Khalil and Dombre, Modeling, Identification and Control of Robots, 2002, section
//! 9.4.2; they write inertias in place of second moments, which takes two entries where P_kk is one). What reaches the world
//! is at rest. Forces along the coordinates stay what they are.

use super::free_base::FreeBase;
use super::open_tree::OpenTree;
use super::rows::load_rows_besides;
use super::tmt::Tmt;
use super::variables::{Derivatives, Variables};
use crate::model::triple::{Matrix, Triple, add, apply, identity, product, scaled, transposed};
use crate::model::{Body, Dependence, Dependences, FixedBody, Model};
use crate::symbolic::{Differential, Expr, Graph, Number, substitute};

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

/// A frame, its motion in the one before, and the mass in it.
pub struct Link {
    /// The link before it, by index; none if that is the world.
    pub before: Option<usize>,
    /// S, from its own frame to the one before.
    pub turn: Matrix,
    /// Its angular velocity in the frame before, in its own; and the rate of these components where q'' = 0.
    pub spin: [Triple; 2],
    /// Its origin in the frame before, r, with r'; and r'' where q'' = 0.
    pub offset: [Triple; 3],
    /// For each coordinate that moves it in the frame before: the derivatives of `spin` and r' by its speed.
    pub columns: Vec<(usize, [Triple; 2])>,
    /// The mass that moves with it, regrouped.
    pub mass: MassDistribution,
}

/// A mass distribution about an origin.
#[derive(Clone)]
pub struct MassDistribution {
    /// M.
    pub mass: Expr,
    /// h, the integral of r.
    pub first: Triple,
    /// P, the integral of r r', by rows.
    pub second: Matrix,
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

impl Link {
    /// Whether its turning leaves an axis of its frame at rest.
    fn turns_about(&self, graph: &mut Graph, axis: usize) -> bool {
        let unit = identity(graph)[axis];
        self.turn[axis] == unit && transposed(&self.turn)[axis] == unit
    }
}

impl MassDistribution {
    fn none(graph: &mut Graph) -> MassDistribution {
        let zero = graph.zero();
        MassDistribution { mass: zero, first: [zero; 3], second: [[zero; 3]; 3] }
    }

    fn add(&mut self, graph: &mut Graph, other: &MassDistribution) {
        self.mass = graph.add(self.mass, other.mass);
        self.first = add(graph, self.first, other.first);
        self.second = std::array::from_fn(|i| add(graph, self.second[i], other.second[i]));
    }

    /// P = tr(J)/2 - J + m c c' with the inertia J about the centre of mass c.
    fn add_body(&mut self, graph: &mut Graph, body: &Body, centre: Option<Triple>) {
        let zero = graph.zero();
        let Some(attitude) = &body.attitude else { return };
        let trace = graph.sum(&attitude.inertia.moments);
        let half = graph.scale(&Number::HALF, trace);
        let second = std::array::from_fn(|i| {
            std::array::from_fn(|j| {
                let moment = attitude.inertia.entry(i, j);
                graph.sub(if i == j { half } else { zero }, moment)
            })
        });
        let about_centre = MassDistribution { mass: zero, first: [zero; 3], second };
        self.add(graph, &about_centre);
        if let (Some((mass, _)), Some(centre)) = (&body.mass, centre) {
            let point = MassDistribution { mass: *mass, ..MassDistribution::none(graph) };
            let point = point.moved(graph, &centre);
            self.add(graph, &point);
        }
    }

    /// Takes out the part that turning about an axis does not move.
    fn take_rod(&mut self, graph: &mut Graph, axis: usize) -> MassDistribution {
        let zero = graph.zero();
        let mut rod = MassDistribution::none(graph);
        rod.mass = std::mem::replace(&mut self.mass, zero);
        rod.first[axis] = std::mem::replace(&mut self.first[axis], zero);
        rod.second[axis][axis] = std::mem::replace(&mut self.second[axis][axis], zero);
        rod
    }

    /// The same in the frame before, where it has to be fixed: S h, S P S', about the origin there.
    fn seen_from(&self, graph: &mut Graph, turn: &Matrix, offset: &Triple) -> MassDistribution {
        let first = apply(graph, turn, &self.first);
        let half = product(graph, turn, &self.second);
        let second = product(graph, &half, &transposed(turn));
        MassDistribution { mass: self.mass, first, second }.moved(graph, offset)
    }

    /// The same about another origin, from which this one is at r: h + M r, P + r h' + h r' + M r r'.
    fn moved(&self, graph: &mut Graph, r: &Triple) -> MassDistribution {
        let carried = scaled(graph, self.mass, *r);
        let second = std::array::from_fn(|i| {
            std::array::from_fn(|j| {
                let terms = [
                    self.second[i][j],
                    graph.mul(r[i], self.first[j]),
                    graph.mul(self.first[i], r[j]),
                    graph.mul(carried[i], r[j]),
                ];
                graph.sum(&terms)
            })
        });
        MassDistribution { mass: self.mass, first: add(graph, self.first, carried), second }
    }
}
