//! The equations of motion in generalised speeds.
//!
//! With u in place of q' the equations are those of the TMT method with partial velocities, the derivatives of the
//! velocities of T's rows by u, for T_q: Kane's equations (Kane and Levinson, Dynamics: Theory and Applications, 1985,
//! chapters 2, 4 and 6; Wittenburg, Dynamics of Multibody Systems, 2nd ed., chapter 5). A velocity that is a
//! generalised speed becomes that variable wherever it occurs, so that a body whose speeds are the components of its
//! angular velocity has Euler's equations. The remaining q' become N u + n. Norms of quaternions and constraints
//! between speeds hold by construction.

use super::constraints::switched;
use super::kinematics::{Kinematics, satisfied};
use super::rows::{Along, LoadRow};
use super::tmt::{Tmt, TmtRow};
use super::variables::Differentiated;
use crate::model::{Level, Model};
use crate::symbolic::{Differential, Expr, Graph, Recognition, Symbol, substitute};

/// The equations of motion in k generalised speeds, with r of the m constraints.
pub struct SpeedEquations {
    /// q' = N u + n.
    pub kinematics: Kinematics,
    /// Mass matrix, k x k, and forces, k, of rows of T by partial velocities; all in u.
    pub tmt: Tmt,
    /// Which constraints are not satisfied by construction.
    pub rows: Vec<usize>,
    /// The derivatives of their rates by u, r x k.
    pub jacobian: Vec<Vec<Expr>>,
    /// C'' where u' = 0, r.
    pub convective: Vec<Expr>,
}

/// Nothing where there are no generalised speeds.
pub(super) fn derive(graph: &mut Graph, model: &Model, rows: &[LoadRow]) -> Option<SpeedEquations> {
    if model.generalized_speeds.is_empty() {
        return None;
    }
    let mut motion = model.time_derivative(graph);
    let satisfied = satisfied(graph, model, &mut motion);
    let kinematics = Kinematics::derive(graph, model, &satisfied);
    let mut speeds = InSpeeds::of(graph, model, motion, &kinematics, &satisfied);
    let rows = rows.iter().map(|row| speeds.row(graph, row)).collect();
    let tmt = Tmt::of(graph, rows, model.generalized_speeds.len());
    let satisfied = model.satisfied_rows();
    let rows: Vec<usize> = (0..model.constraints.len()).filter(|row| !satisfied.contains(row)).collect();
    let (jacobian, convective) = rows.iter().map(|row| speeds.constraint(graph, model, *row)).unzip();
    Some(SpeedEquations { kinematics, tmt, rows, jacobian, convective })
}

/// Translates expressions of q, q' and t into expressions of q, u and t.
struct InSpeeds {
    /// The total time derivative of what is written in q.
    motion: Differential,
    /// Generalised speeds, wherever they occur.
    known: Recognition,
    /// The remaining speeds.
    rates: Vec<(Symbol, Expr)>,
    by_speeds: Vec<Differential>,
    /// The total time derivative where u' = 0 of what is written in u.
    convective: Differential,
}

impl InSpeeds {
    fn of(
        graph: &mut Graph,
        model: &Model,
        motion: Differential,
        kinematics: &Kinematics,
        satisfied: &[Expr],
    ) -> InSpeeds {
        let Model { generalized_speeds: speeds, coordinates, .. } = model;
        let zero = graph.zero();
        let speeds = speeds.iter().map(|speed| (speed.value, graph.variable(speed.symbol)));
        let known = Recognition::of(speeds.chain(satisfied.iter().map(|rate| (*rate, zero))));
        let rates = coordinates.iter().map(|c| c.speed).zip(kinematics.rates.iter().copied()).collect();
        let (by_speeds, convective) = (kinematics.by_speeds(graph, model), kinematics.convective(graph, model));
        InSpeeds { motion, known, rates, by_speeds, convective }
    }

    fn expression(&mut self, graph: &mut Graph, expr: Expr) -> Expr {
        let seen = self.known.replace(graph, expr);
        substitute(graph, &[seen], &self.rates)[0]
    }

    /// A velocity with its partial velocities and its rate where u' = 0.
    fn velocity(&mut self, graph: &mut Graph, velocity: Expr) -> Differentiated {
        let velocity = self.expression(graph, velocity);
        let jacobian = self.by_speeds.iter_mut().map(|by| by.of(graph, velocity)).collect();
        let (zero, convective) = (graph.zero(), self.convective.of(graph, velocity));
        Differentiated { position: zero, jacobian, time_derivative: zero, velocity, convective }
    }

    fn row(&mut self, graph: &mut Graph, row: &LoadRow) -> TmtRow {
        let motion = match row.along {
            Along::Position(position) => {
                let velocity = self.motion.of(graph, position);
                self.velocity(graph, velocity)
            }
            Along::Rate { velocity, transport, .. } => {
                let motion = self.velocity(graph, velocity);
                let [ahead, back] = transport.map(|(turning, velocity)| {
                    let product = graph.mul(turning, velocity);
                    self.expression(graph, product)
                });
                let convective = graph.sum(&[motion.convective, ahead]);
                Differentiated { convective: graph.sub(convective, back), ..motion }
            }
        };
        let loads = row.forces.iter().copied().chain(row.weight.map(|weight| weight.force));
        let forces = loads.map(|force| self.expression(graph, force)).collect();
        let gyroscopic = self.expression(graph, row.gyroscopic);
        let row = LoadRow { gyroscopic, forces, weight: None, ..row.clone() };
        TmtRow::of(graph, row, motion, &[])
    }

    /// The derivatives of a constraint's rate by u, and C'' where u' = 0.
    fn constraint(&mut self, graph: &mut Graph, model: &Model, row: usize) -> (Vec<Expr>, Expr) {
        let constraint = &model.constraints[row];
        let rate = match constraint.level {
            Level::Positions => self.motion.of(graph, constraint.value),
            Level::Speeds => constraint.value,
        };
        let motion = self.velocity(graph, rate);
        let mut switched = |expr: Expr| constraint.activity.map_or(expr, |activity| switched(graph, activity, expr));
        (motion.jacobian.into_iter().map(&mut switched).collect(), switched(motion.convective))
    }
}
