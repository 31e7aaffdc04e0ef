//! Pairs of constraint rows turned along and across a link.
//!
//! Two rows that hold along x and y hold as well along any other two directions at right angles:
//!
//! ```text
//! [ C_q along  ]   [  cos phi  sin phi ] [ C_q x ]    [ lambda x ]   [ cos phi  -sin phi ] [ lambda along  ]
//! [ C_q across ] = [ -sin phi  cos phi ] [ C_q y ],   [ lambda y ] = [ sin phi   cos phi ] [ lambda across ]
//! ```
//!
//! Along and across a link at the angle phi, the link's own coordinate stands in one row alone, mostly with a coefficient of
//! parameters: one entry less to eliminate, and a pivot that no position makes zero. As the turn is orthonormal the
//! equations stay as well conditioned as they were.
//!
//! Both forms are planned, and the one with fewer operations is taken: rows of four-bars gain, Andrews' squeezer stays
//! as declared. Derivatives are taken of the turned rows. Their multipliers turn back with -lambda_y and lambda_x times
//! the change of the angle. Kernels other than `dynamics` and its derivatives do not know of turned rows.

use super::column::Column;
use super::constraints::Constraints;
use super::shorthands::Shorthands;
use crate::model::Model;
use crate::symbolic::{Expr, Function, Graph, Node, Symbol};
use std::cmp::Reverse;
use std::collections::BTreeSet;

/// The largest sum that multiplying out may make.
const LONGEST_EXPANSION: usize = 64;

/// Entries made of more expressions are not tried: a link's own are short.
const MOST_EXPRESSIONS: usize = 24;

/// The constraint rows in a form in which the equations of motion can be solved, m of them: as declared, or with
/// pairs turned.
pub struct ConstraintForm {
    /// The pairs that are turned.
    pub turns: Vec<RowTurn>,
    /// Their derivatives.
    pub rows: ConstraintRows,
    /// The same by the attitudes of links, where constraints contain these.
    pub shortened: Option<ConstraintRows>,
    /// The multipliers of these rows, m.
    pub multipliers: Vec<Symbol>,
    /// The derivatives of the residual by coordinates and speeds, in each way in which it is written: on request and without
    /// intermediates.
    pub by_state: Vec<[Vec<Column>; 2]>,
    /// Its derivatives by the parameters, likewise.
    pub by_parameters: Option<Vec<Column>>,
}

/// The derivatives of m rows.
#[derive(Clone)]
pub struct ConstraintRows {
    /// C_q, m x n.
    pub jacobian: Vec<Vec<Expr>>,
    /// (C_q q' + C_t)_q q' + (..)_t, m.
    pub convective: Vec<Expr>,
}

/// A pair of rows turned by an angle: the first along it, the second across.
pub struct RowTurn {
    /// Which rows.
    pub rows: [usize; 2],
    /// The angle, in rad.
    pub angle: Expr,
    /// Its cosine and sine.
    pub direction: [Expr; 2],
}

impl ConstraintForm {
    /// The rows as they are declared.
    pub(super) fn declared(model: &Model, constraints: &Constraints) -> ConstraintForm {
        ConstraintForm {
            turns: vec![],
            rows: ConstraintRows { jacobian: constraints.jacobian.clone(), convective: constraints.convective.clone() },
            shortened: None,
            multipliers: model.constraints.iter().map(|constraint| constraint.multiplier).collect(),
            by_state: vec![],
            by_parameters: None,
        }
    }

    /// The rows with pairs of neighbours turned, if that makes entries zero.
    pub(super) fn turned(graph: &mut Graph, model: &Model, constraints: &Constraints) -> Option<ConstraintForm> {
        let mut form = ConstraintForm::declared(model, constraints);
        let mut i = 0;
        while i + 1 < form.rows.jacobian.len() {
            let rows = [i, i + 1];
            let is_switched = rows.iter().any(|row| model.constraints[*row].activity.is_some());
            let best = if is_switched { None } else { best_turn(graph, model, &form.rows.jacobian, rows) };
            i += if best.is_some() { 2 } else { 1 };
            if let Some(turned) = best {
                form.enter(graph, model, turned);
            }
        }
        (!form.turns.is_empty()).then_some(form)
    }

    fn enter(&mut self, graph: &mut Graph, model: &Model, Turned { turn, columns, .. }: Turned) {
        let [i, j] = turn.rows;
        let convective = turn.of(graph, [self.rows.convective[i], self.rows.convective[j]]);
        for (at, row) in turn.rows.into_iter().enumerate() {
            self.rows.jacobian[row] = columns.iter().map(|entries| entries[at]).collect();
            self.rows.convective[row] = convective[at];
            self.multipliers[row] = graph.symbol(&format!("lambda_{}_turned", model.constraints[row].name));
        }
        self.turns.push(turn);
    }

    /// Enters the rows as declared once more in another form, where that contains shorthands.
    pub(super) fn shorten(&mut self, graph: &mut Graph, shorthands: &Shorthands, declared: &ConstraintRows) {
        let mut turned = declared.clone();
        for turn in &self.turns {
            for column in 0..self.rows.jacobian.first().map_or(0, Vec::len) {
                let entries = turn.of(graph, turn.rows.map(|row| declared.jacobian[row][column]));
                turn.rows.into_iter().zip(entries).for_each(|(row, entry)| turned.jacobian[row][column] = entry);
            }
            let convective = turn.components(graph, turn.rows.map(|row| declared.convective[row]));
            turn.rows.into_iter().zip(convective).for_each(|(row, expr)| turned.convective[row] = expr);
        }
        let is_short =
            |expr: Expr| graph.symbols_of(&[expr]).into_iter().any(|symbol| shorthands.definition(symbol).is_some());
        let mut shortened = self.rows.clone();
        let entries = shortened.jacobian.iter_mut().flatten().chain(&mut shortened.convective);
        let turned = turned.jacobian.into_iter().flatten().chain(turned.convective);
        // With shorthands zero might not show as such.
        let changed = entries.zip(turned).filter(|(old, new)| !graph.is_zero(**old) && is_short(*new));
        changed.for_each(|(old, new)| *old = new);
        self.shortened = Some(shortened);
    }

    /// Derivatives of the residual of the rows as declared, for these rows. The angles need not move: the residual of a
    /// solution is 0 in all directions, and so are its multipliers' derivatives turned like the multipliers.
    pub(super) fn at_fixed_angles(&self, graph: &mut Graph, columns: &[Vec<Expr>]) -> Vec<Column> {
        let zero = graph.zero();
        let mut column = |declared: &Vec<Expr>| {
            let mut residual = declared.clone();
            let first = residual.len() - self.rows.jacobian.len();
            for turn in &self.turns {
                let places = turn.rows.map(|row| first + row);
                let turned = turn.components(graph, places.map(|at| declared[at]));
                places.into_iter().zip(turned).for_each(|(at, turned)| residual[at] = turned);
            }
            Column { residual, angles: vec![zero; self.turns.len()] }
        };
        columns.iter().map(&mut column).collect()
    }
}

impl RowTurn {
    fn by(graph: &mut Graph, rows: [usize; 2], angle: Expr) -> RowTurn {
        let direction = [Function::Cos, Function::Sin].map(|function| graph.call(function, angle));
        RowTurn { rows, angle, direction }
    }

    /// The components of a vector (x, y) along the angle and across it, multiplied out.
    fn of(&self, graph: &mut Graph, vector: [Expr; 2]) -> [Expr; 2] {
        self.components(graph, vector).map(|sum| graph.expand(sum, LONGEST_EXPANSION).unwrap_or(sum))
    }

    fn components(&self, graph: &mut Graph, [x, y]: [Expr; 2]) -> [Expr; 2] {
        let [cos, sin] = self.direction;
        let (x_along, y_along, x_across, y_across) =
            (graph.mul(cos, x), graph.mul(sin, y), graph.mul(sin, x), graph.mul(cos, y));
        [graph.add(x_along, y_along), graph.sub(y_across, x_across)]
    }
}

/// A turn, and the entries of its rows, column by column.
struct Turned {
    turn: RowTurn,
    columns: Vec<[Expr; 2]>,
    /// The numbers of zero entries, of other entries that depend on parameters alone, and of rows in which the angle's
    /// coordinate occurs.
    rank: (usize, usize, Reverse<usize>),
}

/// The turn that makes most entries zero; among equals, the one that makes most other entries depend on parameters
/// alone, by the angle of a coordinate that occurs in the fewest rows.
fn best_turn(graph: &mut Graph, model: &Model, jacobian: &[Vec<Expr>], rows: [usize; 2]) -> Option<Turned> {
    let moving: Vec<Symbol> = model.coordinates.iter().map(|c| c.position).chain([model.time]).collect();
    let columns: Vec<[Expr; 2]> =
        (0..model.coordinates.len()).map(|column| rows.map(|row| jacobian[row][column])).collect();
    let mut best: Option<Turned> = None;
    let mut tried: Vec<Expr> = vec![];
    for (column, entries) in columns.iter().enumerate() {
        for angle in angles(graph, entries) {
            let turn = RowTurn::by(graph, rows, angle);
            let own = turn.of(graph, *entries);
            if tried.contains(&angle) || zeros(graph, &[own]) <= zeros(graph, &[*entries]) {
                continue;
            }
            tried.push(angle);
            let turned: Vec<[Expr; 2]> = columns.iter().map(|entries| turn.of(graph, *entries)).collect();
            let fixed = turned.iter().flatten().filter(|entry| !graph.depends_on(**entry, &moving)).count();
            let occurrences = jacobian.iter().filter(|row| !graph.is_zero(row[column])).count();
            let rank = (zeros(graph, &turned), fixed, Reverse(occurrences));
            if rank.0 > zeros(graph, &columns) && best.as_ref().is_none_or(|best| rank > best.rank) {
                best = Some(Turned { turn, columns: turned, rank });
            }
        }
    }
    best
}

fn zeros(graph: &Graph, columns: &[[Expr; 2]]) -> usize {
    columns.iter().flatten().filter(|entry| graph.is_zero(**entry)).count()
}

/// The angles whose sines and cosines occur in short entries.
fn angles(graph: &Graph, entries: &[Expr]) -> Vec<Expr> {
    // Not all of a large graph for each pair of rows.
    let (mut reachable, mut stack) = (BTreeSet::new(), entries.to_vec());
    while let Some(expr) = stack.pop() {
        if reachable.insert(expr) {
            stack.extend(graph.operands(expr));
        }
        if reachable.len() > MOST_EXPRESSIONS {
            return vec![];
        }
    }
    let angles = reachable.into_iter().filter_map(|expr| match graph.node(expr) {
        Node::Call(Function::Sin | Function::Cos, angle) => Some(*angle),
        _ => None,
    });
    angles.collect()
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::dynamics::{EquationsOfMotion, derive};
    use crate::{model, parse};

    const FOUR_BAR: &str = "
        /// A four-bar.
        pub FourBar;
        coordinates { coupler [rad]; crank [rad]; rocker [rad]; }
        parameters { l [m] = 1; m [kg] = 1; tilt [rad] = 0.1; }
        let A = l*[cos(crank), sin(crank)];
        let B = A + 2*l*[cos(coupler + tilt), sin(coupler + tilt)];
        let C = [l, 0] + l*[cos(rocker), sin(rocker)];
        bodies { tip: mass m at A, inertia m*l^2, angle coupler; rod: inertia m*l^2, angle rocker; }";

    fn turned(rest: &str) -> (EquationsOfMotion, Option<ConstraintForm>) {
        let text = format!("{FOUR_BAR} {rest}");
        let declaration = parse(text.parse().unwrap()).unwrap();
        let mut equations = derive(model::resolve(&declaration).unwrap());
        let turned = equations.turned.take();
        (equations, turned)
    }

    #[test]
    fn a_link_stands_in_one_of_its_rows_alone_and_never_moves_there() {
        let (EquationsOfMotion { graph, model, .. }, form) = turned("constraints { closed: B = C; }");
        let form = form.unwrap();
        let [turn] = form.turns.as_slice() else { panic!("{}", form.turns.len()) };
        assert!(graph.depends_on(turn.angle, &[model.coordinates[0].position]));
        let coupler = [0, 1].map(|row| form.rows.jacobian[row][0]);
        assert!(graph.is_zero(coupler[0]));
        let moving: Vec<Symbol> = model.coordinates.iter().map(|c| c.position).collect();
        assert!(!graph.is_zero(coupler[1]) && !graph.depends_on(coupler[1], &moving));
        // Those of the others are sines and cosines of differences.
        assert!((0..2).all(|row| (1..3).all(|column| !graph.is_zero(form.rows.jacobian[row][column]))));
    }

    #[test]
    fn rows_that_are_no_pair_are_left_as_they_are() {
        assert!(turned("constraints { height: B.y = C.y; }").1.is_none());
        assert!(turned("constraints { lengths: norm(B - [l, 0]) = l; level: crank = 2*rocker; }").1.is_none());
    }

    #[test]
    fn rows_that_events_switch_are_left_as_they_are() {
        let switched =
            "constraints { closed: B = C initially active; } events { far: crank = 1 rising { release closed; } }";
        assert!(turned(switched).1.is_none());
    }
}
