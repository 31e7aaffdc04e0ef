//! Common parts of sums, found by their terms, and expressions written with them.

use super::formulation::Formulation;
use super::rows::{Along, LoadRow};
use super::variables::Variables;
use crate::model::{Dependence, Model};
use crate::symbolic::{Expr, Graph, Node, Symbol, with_operands};
use rustc_hash::FxHashMap;
use std::collections::BTreeSet;

/// Sums that may become intermediates: rows, named quantities, and the angles in them; with their symbols.
pub(super) struct Candidates {
    /// From short to long.
    sums: Vec<Candidate>,
}

struct Candidate {
    sum: Expr,
    symbols: [Symbol; 4],
    /// The number of coordinates in it.
    depth: usize,
}

impl Candidates {
    pub(super) fn of(graph: &mut Graph, model: &Model, plain: &Formulation) -> Candidates {
        let named: Vec<Expr> = model.named.iter().map(|(_, expr)| *expr).collect();
        let positions: Vec<Expr> = plain.rows.iter().map(LoadRow::quantity).chain(named).collect();
        let angles = arguments(graph, &positions).into_iter();
        let sums: BTreeSet<Expr> = angles.chain(positions).filter(|expr| length(graph, *expr) > 1).collect();
        let coordinates = Variables::coordinates(model).positions;
        let (mut dependences, mut candidates) = (model.dependences.clone(), Vec::new());
        for sum in sums {
            let symbols = graph.symbols_of(&[sum]);
            let depth = symbols.iter().filter(|symbol| coordinates.contains(symbol)).count();
            let rates = Dependence::SPEED.or(Dependence::ACCELERATION).or(Dependence::MULTIPLIER);
            if depth > 1 && !dependences.of(graph, sum).meets(rates) {
                candidates.push((sum, depth));
            }
        }
        candidates.sort_by_key(|(sum, _)| (length(graph, *sum), *sum));
        let sums = candidates.into_iter().enumerate().map(|(i, (sum, depth))| {
            let symbols = ["", "_dot", "_ddot", "_t"].map(|rate| graph.symbol(&format!("y{i}{rate}")));
            Candidate { sum, symbols, depth }
        });
        Candidates { sums: sums.collect() }
    }

    /// Rows and constraints over those candidates that are part of others and made of at least `depth` coordinates.
    pub(super) fn formulation(
        &self,
        graph: &mut Graph,
        model: &Model,
        plain: &Formulation,
        depth: usize,
    ) -> Option<Formulation> {
        let eligible: Vec<&Candidate> = self.sums.iter().filter(|candidate| candidate.depth >= depth).collect();
        let sums: Vec<Expr> = eligible.iter().map(|candidate| candidate.sum).collect();
        let all: Vec<Expr> = self.sums.iter().map(|candidate| candidate.sum).collect();
        let used: BTreeSet<Expr> = self
            .sums
            .iter()
            .filter_map(|candidate| longest_part(graph, candidate.sum, &sums))
            .chain(arguments(graph, &all))
            .collect();
        let chosen: Vec<&Candidate> = eligible.into_iter().filter(|candidate| used.contains(&candidate.sum)).collect();
        let parts: Vec<Expr> = chosen.iter().map(|candidate| candidate.sum).collect();
        let mut writer = Writer::new(graph, model, &chosen, parts);
        let definitions: Vec<Expr> = chosen.iter().map(|candidate| writer.define(graph, candidate.sum)).collect();
        let symbols: Vec<[Symbol; 4]> = chosen.iter().map(|candidate| candidate.symbols).collect();
        let order = definition_order(graph, &definitions, &symbols)?;
        Some(Formulation {
            rows: plain.rows.iter().map(|row| writer.row(graph, row)).collect(),
            constraints: plain.constraints.iter().map(|value| writer.rewrite(graph, *value)).collect(),
            definitions: order.iter().map(|i| definitions[*i]).collect(),
            symbols: order.iter().map(|i| symbols[*i]).collect(),
            names: order.iter().map(|i| name(model, chosen[*i].sum, *i)).collect(),
        })
    }
}

/// The arguments of functions in expressions.
fn arguments(graph: &Graph, exprs: &[Expr]) -> Vec<Expr> {
    let all = graph.reachable(exprs).into_iter();
    let arguments = all.filter_map(|expr| match graph.node(expr) {
        Node::Call(_, argument) => Some(*argument),
        _ => None,
    });
    arguments.collect()
}

fn name(model: &Model, sum: Expr, number: usize) -> String {
    let named = model.named.iter().find(|(_, expr)| *expr == sum);
    named.map_or_else(|| format!("part_{number}"), |(name, _)| name.clone())
}

/// The definitions in an order in which each needs only those before it; none if they are circular.
fn definition_order(graph: &Graph, definitions: &[Expr], symbols: &[[Symbol; 4]]) -> Option<Vec<usize>> {
    let place: FxHashMap<Symbol, usize> =
        symbols.iter().enumerate().map(|(i, [position, ..])| (*position, i)).collect();
    let needs = |i: usize| graph.symbols_of(&[definitions[i]]).into_iter().filter_map(|s| place.get(&s).copied());
    let needs: Vec<Vec<usize>> = (0..definitions.len()).map(|i| needs(i).collect()).collect();
    let (mut order, mut placed) = (Vec::new(), vec![false; definitions.len()]);
    while order.len() < definitions.len() {
        let ready = |i: usize| !placed[i] && needs[i].iter().all(|need| placed[*need]);
        let next: Vec<usize> = (0..definitions.len()).filter(|i| ready(*i)).collect();
        if next.is_empty() {
            return None;
        }
        next.iter().for_each(|i| placed[*i] = true);
        order.extend(next);
    }
    Some(order)
}

/// Writes expressions in terms of intermediates.
struct Writer {
    /// From short to long.
    parts: Vec<Expr>,
    variables: FxHashMap<Expr, Expr>,
    done: FxHashMap<Expr, Expr>,
}

impl Writer {
    fn new(graph: &mut Graph, model: &Model, chosen: &[&Candidate], parts: Vec<Expr>) -> Writer {
        let mut variables = FxHashMap::default();
        let mut rate = model.time_derivative(graph);
        for candidate in chosen {
            let [position, speed, ..] = candidate.symbols.map(|symbol| graph.variable(symbol));
            variables.insert(candidate.sum, position);
            // Loads depend on speeds too.
            variables.insert(rate.of(graph, candidate.sum), speed);
        }
        Writer { parts, done: variables.clone(), variables }
    }

    /// A sum, or anything else, in terms of its longest part and the rest.
    fn define(&mut self, graph: &mut Graph, sum: Expr) -> Expr {
        match longest_part(graph, sum, &self.parts) {
            Some(part) => {
                let rest = graph.sub(sum, part);
                let rest = self.rewrite(graph, rest);
                graph.add(self.variables[&part], rest)
            }
            None => self.rewrite_operands(graph, sum),
        }
    }

    fn rewrite_operands(&mut self, graph: &mut Graph, expr: Expr) -> Expr {
        let operands: Vec<Expr> = graph.operands(expr).collect();
        for operand in operands {
            self.rewrite(graph, operand);
        }
        with_operands(graph, expr, |operand| self.done[&operand])
    }

    fn row(&mut self, graph: &mut Graph, row: &LoadRow) -> LoadRow {
        let along = match row.along {
            Along::Position(position) => Along::Position(self.rewrite(graph, position)),
            rate => rate,
        };
        LoadRow {
            along,
            inertia: row.inertia,
            coupling: row.coupling.clone(),
            gyroscopic: row.gyroscopic,
            weight: row.weight,
            forces: row.forces.iter().map(|force| self.rewrite(graph, *force)).collect(),
        }
    }

    fn rewrite(&mut self, graph: &mut Graph, expr: Expr) -> Expr {
        if let Some(done) = self.done.get(&expr) {
            return *done;
        }
        let new = self.define(graph, expr);
        self.done.insert(expr, new);
        new
    }
}

/// The part, of `parts` from short to long, that leaves the shortest rest of a sum; none if no part shortens it.
fn longest_part(graph: &Graph, sum: Expr, parts: &[Expr]) -> Option<Expr> {
    let length_of_sum = length(graph, sum);
    let shorter = parts.iter().filter(|part| **part != sum && length(graph, **part) < length_of_sum);
    let rests = shorter.map(|part| (rest_length(graph, sum, *part), *part));
    rests.filter(|(rest, _)| rest + 1 < length_of_sum).min_by_key(|(rest, part)| (*rest, *part)).map(|(_, part)| part)
}

/// The number of terms of a sum; 0 for anything else.
fn length(graph: &Graph, expr: Expr) -> usize {
    match graph.node(expr) {
        Node::Sum { constant, terms } => terms.len() + usize::from(!constant.is_zero()),
        _ => 0,
    }
}

/// The number of terms of `sum - part`.
fn rest_length(graph: &Graph, sum: Expr, part: Expr) -> usize {
    let (Node::Sum { constant: c, terms: a }, Node::Sum { constant: d, terms: b }) =
        (graph.node(sum), graph.node(part))
    else {
        return usize::MAX - 1;
    };
    let (mut i, mut j, mut rest) = (0, 0, usize::from(c != d));
    while i < a.len() && j < b.len() {
        match a[i].0.cmp(&b[j].0) {
            std::cmp::Ordering::Equal => {
                rest += usize::from(a[i].1 != b[j].1);
                (i, j) = (i + 1, j + 1);
            }
            std::cmp::Ordering::Less => (i, rest) = (i + 1, rest + 1),
            std::cmp::Ordering::Greater => (j, rest) = (j + 1, rest + 1),
        }
    }
    rest + (a.len() - i) + (b.len() - j)
}
