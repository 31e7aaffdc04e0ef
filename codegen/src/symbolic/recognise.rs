//! Known expressions found in others, also as a part of a longer sum or product, and replaced.

use super::{Expr, Graph, Node, Number, with_operands};
use rustc_hash::FxHashMap;

/// Replaces known expressions wherever they occur: as operands, as terms of a sum that all have the same multiple
/// there, and as factors of a product. Expressions that equal a known one only after rewriting are not found.
pub struct Recognition {
    known: Vec<(Expr, Expr)>,
    done: FxHashMap<Expr, Expr>,
}

impl Recognition {
    /// Known expressions with their replacements; the first match is used.
    pub fn of(known: impl IntoIterator<Item = (Expr, Expr)>) -> Recognition {
        let known: Vec<(Expr, Expr)> = known.into_iter().collect();
        Recognition { done: known.iter().copied().collect(), known }
    }

    /// Another known expression, for what has not been replaced yet.
    pub fn learn(&mut self, expr: Expr, new: Expr) {
        self.known.push((expr, new));
        self.done.insert(expr, new);
    }

    /// The expression with known parts replaced.
    pub fn replace(&mut self, graph: &mut Graph, expr: Expr) -> Expr {
        if let Some(done) = self.done.get(&expr) {
            return *done;
        }
        let found = self.known.iter().find_map(|(known, new)| Some((*new, part(graph, expr, *known)?)));
        let replaced = match found {
            Some((new, Occurrence::Terms(multiple, rest))) => {
                let rest = self.replace(graph, rest);
                graph.linear_combination(&[(new, multiple), (rest, Number::ONE)])
            }
            Some((new, Occurrence::Factors(rest))) => {
                let rest = self.replace(graph, rest);
                graph.mul(new, rest)
            }
            None => {
                let operands: Vec<Expr> = graph.operands(expr).collect();
                let new: FxHashMap<Expr, Expr> =
                    operands.into_iter().map(|operand| (operand, self.replace(graph, operand))).collect();
                with_operands(graph, expr, |operand| new[&operand])
            }
        };
        self.done.insert(expr, replaced);
        replaced
    }
}

/// How an expression contains a known one.
enum Occurrence {
    /// `multiple * known + rest`
    Terms(Number, Expr),
    /// `known * rest`
    Factors(Expr),
}

fn part(graph: &mut Graph, expr: Expr, known: Expr) -> Option<Occurrence> {
    match (graph.node(expr), graph.node(known)) {
        (Node::Sum { terms, .. }, Node::Sum { terms: sought, .. }) => {
            let ratio = |(term, sought): &(Expr, Number)| {
                let at = terms.binary_search_by_key(term, |(term, _)| *term).ok()?;
                Some(&terms[at].1 * &sought.recip()?)
            };
            let multiple = ratio(sought.first()?)?;
            if sought.iter().any(|each| ratio(each).as_ref() != Some(&multiple)) {
                return None;
            }
            let rest = graph.linear_combination(&[(expr, Number::ONE), (known, -&multiple)]);
            Some(Occurrence::Terms(multiple, rest))
        }
        (Node::Product { coefficient, factors }, Node::Product { coefficient: own, factors: sought }) => {
            let mut rest = factors.to_vec();
            for (base, exponent) in sought {
                let place = rest.iter_mut().find(|(other, e)| {
                    other == base && (*e > 0) == (*exponent > 0) && e.unsigned_abs() >= exponent.unsigned_abs()
                })?;
                place.1 -= exponent;
            }
            rest.retain(|(_, exponent)| *exponent != 0);
            let coefficient = coefficient * &own.recip()?;
            let rest = graph.canonical_product(Number::ONE, rest);
            Some(Occurrence::Factors(graph.scale(&coefficient, rest)))
        }
        _ => None,
    }
}
