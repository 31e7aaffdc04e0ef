//! Motion written by the attitudes of links.
//!
//! What a quaternion q turns moves by its turn S and its angular velocity w, with S' = S [w]. Derived from q itself, rates of
//! points are long: each entry of S is a quotient of polynomials. Here entries of S, w and w' are variables, and so are
//! S' and S''. A change dq turns the link by J dq, J = w_q', in its own frame: with e for that turn the derivatives of
//! anything x are
//!
//! ```text
//! x_q = x_e J + x_w w_q + x_w' w'_q,   x_q' = x_w J + x_w' w'_q'
//! ```
//!
//! besides those by q where it stands elsewhere: so x is differentiated by three components in place of four, and by parts that
//! have much in common.

use super::constraints::switched;
use super::inverse::velocities_and_forces;
use super::rows::{Along, LoadRow, Weight};
use super::shorthands::Shorthands;
use crate::model::triple::{add, cross};
use crate::model::{Level, Link, Model};
use crate::symbolic::{Differential, Expr, Graph, Recognition, Symbol};
use std::ops::Range;

/// Expressions in which the attitudes of links are variables, and their rates.
pub(super) struct Attitudes<'a> {
    model: &'a Model,
    attitudes: Vec<Attitude<'a>>,
    pub(super) shorthands: Shorthands,
    /// How many shorthands stand for the attitudes themselves.
    own: usize,
    known: Recognition,
    motion: Differential,
}

/// What a quaternion turns.
struct Attitude<'a> {
    link: &'a Link,
    turn: [[Symbol; 3]; 3],
    spin: [Symbol; 3],
    spin_rate: [Symbol; 3],
}

/// A component of an attitude, with the derivatives of expressions by the turn, by w and by w'.
struct Component<'a> {
    link: &'a Link,
    at: usize,
    by: [Vec<Expr>; 3],
}

impl<'a> Attitudes<'a> {
    /// Of no links.
    pub(super) fn none(graph: &mut Graph, model: &'a Model) -> Attitudes<'a> {
        Attitudes::of(graph, model, [])
    }

    /// Of all links that quaternions turn.
    pub(super) fn all(graph: &mut Graph, model: &'a Model) -> Attitudes<'a> {
        Attitudes::of(graph, model, model.links.iter().filter(|link| link.quaternion.is_some()))
    }

    fn of(graph: &mut Graph, model: &'a Model, links: impl IntoIterator<Item = &'a Link>) -> Attitudes<'a> {
        let (mut shorthands, mut known) = (Shorthands::default(), vec![]);
        let mut symbol = |expr: &Expr| {
            let symbol = shorthands.symbol(graph, *expr);
            known.push((*expr, graph.variable(symbol)));
            symbol
        };
        let attitudes = links.into_iter().map(|link| Attitude {
            link,
            turn: link.turn.each_ref().map(|row| row.each_ref().map(&mut symbol)),
            spin: link.spin.each_ref().map(&mut symbol),
            spin_rate: link.spin_rate.each_ref().map(&mut symbol),
        });
        let attitudes: Vec<Attitude> = attitudes.collect();
        let own = shorthands.len();
        let mut motion = model.time_derivative(graph);
        attitudes.iter().for_each(|attitude| attitude.enter(graph, &mut shorthands, &mut motion));
        Attitudes { model, attitudes, shorthands, own, known: Recognition::of(known), motion }
    }

    /// Whether an attitude occurs in a constraint between positions.
    pub(super) fn are_constrained(&mut self, graph: &mut Graph) -> bool {
        let turns: Vec<Symbol> = self.attitudes.iter().flat_map(|attitude| attitude.turn).flatten().collect();
        let model = self.model;
        model.constraints.iter().any(|constraint| {
            let value = self.known.replace(graph, constraint.value);
            constraint.level == Level::Positions && graph.depends_on(value, &turns)
        })
    }

    /// C' of constraints between positions and w of those between speeds, linear in the speeds, and their rates.
    pub(super) fn constraints(&mut self, graph: &mut Graph) -> [Vec<Expr>; 2] {
        let model = self.model;
        let rates = model.constraints.iter().map(|constraint| {
            let value = self.known.replace(graph, constraint.value);
            let rate = match constraint.level {
                Level::Positions => self.motion.of(graph, value),
                Level::Speeds => value,
            };
            let accelerated = self.motion.of(graph, rate);
            let mut switched = |expr| constraint.activity.map_or(expr, |activity| switched(graph, activity, expr));
            (switched(rate), switched(accelerated))
        });
        let (rates, accelerated) = rates.unzip();
        [rates, accelerated]
    }

    /// The velocity along each row with the force that its motion takes.
    pub(super) fn velocities_and_forces(&mut self, graph: &mut Graph, rows: &[LoadRow]) -> Vec<(Expr, Expr)> {
        // All velocities first, as forces contain them.
        let along: Vec<Along> = rows.iter().map(|row| self.along(graph, row.along)).collect();
        let rows: Vec<LoadRow> = rows.iter().zip(along).map(|(row, along)| self.row(graph, row, along)).collect();
        velocities_and_forces(graph, &mut self.motion, &rows)
    }

    fn along(&mut self, graph: &mut Graph, along: Along) -> Along {
        match along {
            Along::Position(position) => Along::Position(self.known.replace(graph, position)),
            Along::Rate { velocity, acceleration, transport } => {
                let found = self.known.replace(graph, velocity);
                let name = if self.attitudes.is_empty() { found } else { self.shorthands.named(graph, found) };
                self.known.learn(velocity, name);
                self.known.learn(found, name);
                Along::Rate { velocity: name, acceleration: self.known.replace(graph, acceleration), transport }
            }
        }
    }

    fn row(&mut self, graph: &mut Graph, row: &LoadRow, along: Along) -> LoadRow {
        let mut found = |expr: Expr| self.known.replace(graph, expr);
        LoadRow {
            along,
            gyroscopic: found(row.gyroscopic),
            weight: row.weight.map(|weight| Weight { force: found(weight.force), proper: found(weight.proper) }),
            forces: row.forces.iter().map(|force| found(*force)).collect(),
            ..row.clone()
        }
    }

    /// The derivatives of expressions by all coordinates, then by their speeds.
    pub(super) fn by_state(&mut self, graph: &mut Graph, exprs: &[Expr]) -> [Vec<Vec<Expr>>; 2] {
        let changing = self.own..self.shorthands.len();
        let components = self.components(graph, &changing, exprs);
        let mut all = [vec![], vec![]];
        for coordinate in &self.model.coordinates {
            let [mut by_position, mut by_speed] =
                [coordinate.position, coordinate.speed].map(|symbol| Differential::partial(graph, symbol));
            let mut found = [&mut by_position, &mut by_speed].map(|by| {
                let elsewhere = self.shorthands.derivatives(graph, changing.clone(), by, exprs);
                elsewhere.into_iter().map(|expr| vec![expr]).collect::<Vec<Vec<Expr>>>()
            });
            for Component { link, at, by } in &components {
                let (spin, spin_rate) = (link.spin[*at], link.spin_rate[*at]);
                let turned = by_speed.of(graph, spin);
                let by_position = [turned, by_position.of(graph, spin), by_position.of(graph, spin_rate)];
                let by_speed = [graph.zero(), turned, by_speed.of(graph, spin_rate)];
                for (found, changes) in found.iter_mut().zip([by_position, by_speed]) {
                    for (by, change) in by.iter().zip(changes) {
                        let change = self.shorthands.named(graph, change);
                        found.iter_mut().zip(by).for_each(|(terms, by)| terms.push(graph.mul(*by, change)));
                    }
                }
            }
            for (all, found) in all.iter_mut().zip(found) {
                all.push(found.iter().map(|terms| graph.sum(terms)).collect());
            }
        }
        all
    }

    fn components(&mut self, graph: &mut Graph, changing: &Range<usize>, exprs: &[Expr]) -> Vec<Component<'a>> {
        let mut all = vec![];
        for attitude in &self.attitudes {
            for at in 0..3 {
                let by = [
                    Differential::along(attitude.turning(graph, at)),
                    Differential::partial(graph, attitude.spin[at]),
                    Differential::partial(graph, attitude.spin_rate[at]),
                ];
                let by = by.map(|mut by| {
                    let derivatives = self.shorthands.derivatives(graph, changing.clone(), &mut by, exprs);
                    derivatives.into_iter().map(|expr| self.shorthands.named(graph, expr)).collect()
                });
                all.push(Component { link: attitude.link, at, by });
            }
        }
        all
    }
}

impl Attitude<'_> {
    /// Makes S' = S [w] and S'' = S ([w'] + [w]^2) the rates of its turn.
    fn enter(&self, graph: &mut Graph, shorthands: &mut Shorthands, motion: &mut Differential) {
        let [spin, spin_rate] = [&self.spin, &self.spin_rate].map(|of| of.map(|symbol| graph.variable(symbol)));
        self.spin.iter().zip(spin_rate).for_each(|(spin, rate)| motion.extend(*spin, rate));
        for row in &self.turn {
            let turn = row.map(|symbol| graph.variable(symbol));
            let rates = cross(graph, &turn, &spin).map(|rate| shorthands.symbol(graph, rate));
            let first = rates.map(|symbol| graph.variable(symbol));
            let (by_spin, by_rate) = (cross(graph, &first, &spin), cross(graph, &turn, &spin_rate));
            for (at, second) in add(graph, by_spin, by_rate).into_iter().enumerate() {
                motion.extend(row[at], first[at]);
                motion.extend(rates[at], shorthands.named(graph, second));
            }
        }
    }

    /// The rates of S as the link turns about an axis of its own frame.
    fn turning(&self, graph: &mut Graph, axis: usize) -> Vec<(Symbol, Expr)> {
        let mut unit = [graph.zero(); 3];
        unit[axis] = graph.one();
        let rates = self.turn.iter().flat_map(|row| {
            let turn = row.map(|symbol| graph.variable(symbol));
            row.iter().copied().zip(cross(graph, &turn, &unit))
        });
        rates.collect()
    }
}
