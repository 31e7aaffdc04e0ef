//! Canonical form, substitution and notation keep every value.

use crate::harness::{Outcome, Verdict, check};
use crate::reader::read;
use crate::tracked::{Kind, Tracked};
use crate::tree::{Tree, Workspace, point, tree};
use codegen::notation::infix;
use codegen::symbolic::{Expr, Graph, Node, Number, substitute};
use proptest::collection::vec;
use proptest::prelude::*;
use proptest::test_runner::TestCaseError;

const CASES: u32 = crate::harness::sampled(2_000, 10_000);

/// Where the right value is known, the engine's is within its error bound; where there is none, the engine
/// has none.
fn compare(right: Tracked, value: f64, context: impl Fn() -> String) -> Outcome {
    match right.agrees(value) {
        Some(true) => Ok(Verdict::Holds),
        Some(false) => Err(TestCaseError::fail(format!("{value} instead of {right:?}: {}", context()))),
        None => Ok(Verdict::Open),
    }
}

#[test]
fn canonical_form_keeps_every_value() {
    check(CASES, 90, (tree(), point()), |(tree, point)| {
        let mut space = Workspace::new();
        let expr = space.build(&tree);
        let right = space.track(&tree, &point);
        compare(right, space.evaluate(expr, &point), || infix(&space.graph, expr))
    });
}

/// Much of what canonical form must not do shows only where there is no value.
#[test]
fn poles_and_undefined_values_survive() {
    let singular = (tree(), point())
        .prop_filter("has a value", |(tree, point)| Workspace::new().track(tree, point).kind() == Kind::NotFinite);
    check(CASES / 2, 100, singular, |(tree, point)| {
        let mut space = Workspace::new();
        let expr = space.build(&tree);
        let right = space.track(&tree, &point);
        compare(right, space.evaluate(expr, &point), || infix(&space.graph, expr))
    });
}

#[test]
fn infix_notation_reads_back_as_the_same_value() {
    check(CASES, 90, (tree(), point()), |(tree, point)| {
        let mut space = Workspace::new();
        let expr = space.build(&tree);
        let text = infix(&space.graph, expr);
        compare(space.track(&read(&text), &point), space.evaluate(expr, &point), || text.clone())
    });
}

#[test]
fn substitution_commutes_with_evaluation() {
    let replacements = proptest::array::uniform4(proptest::option::of(tree()));
    check(CASES, 65, (tree(), replacements, point()), |(tree, replacements, point)| {
        let mut space = Workspace::new();
        let expr = space.build(&tree);
        let mut replaced_point = point;
        let mut pairs = vec![];
        for (at, replacement) in replacements.iter().enumerate() {
            let Some(replacement) = replacement else { continue };
            let replacement = space.build(replacement);
            replaced_point[at] = space.evaluate(replacement, &point);
            pairs.push((space.symbols[at], replacement));
        }
        let substituted = substitute(&mut space.graph, &[expr], &pairs)[0];
        let right = space.track(&tree.substitute(&replacements), &point);
        // A symbol has a finite value, and the engine simplifies accordingly.
        if right.kind() != Kind::Finite && replaced_point.iter().any(|x| !x.is_finite()) {
            return Ok(Verdict::Open);
        }
        let context = || format!("{} -> {}", infix(&space.graph, expr), infix(&space.graph, substituted));
        compare(right, space.evaluate(substituted, &point), context)?;
        compare(right, space.evaluate(expr, &replaced_point), context)
    });
}

#[test]
fn order_of_operands_does_not_matter() {
    let shuffled = vec(tree(), 2..6).prop_flat_map(|trees| (Just(trees.clone()), Just(trees).prop_shuffle()));
    check(CASES, 100, shuffled, |(trees, shuffled)| {
        let mut space = Workspace::new();
        let operands: Vec<_> = trees.iter().map(|tree| space.build(tree)).collect();
        let others: Vec<_> = shuffled.iter().map(|tree| space.build(tree)).collect();
        let graph = &mut space.graph;
        prop_assert_eq!(graph.sum(&operands), graph.sum(&others));
        let product = graph.product(&operands);
        prop_assert_eq!(product, graph.product(&others));
        let one = graph.one();
        prop_assert_eq!(product, others.iter().fold(one, |product, factor| graph.mul(product, *factor)));
        Ok(Verdict::Holds)
    });
}

#[test]
fn canonical_form_is_a_fixed_point() {
    check(CASES, 100, tree(), |tree| {
        let mut space = Workspace::new();
        let expr = space.build(&tree);
        let graph = &mut space.graph;
        prop_assert_eq!(substitute(graph, &[expr], &[]), [expr]);
        let (negated, twice) = (graph.neg(expr), graph.add(expr, expr));
        prop_assert_eq!(graph.neg(negated), expr);
        prop_assert_eq!(graph.sub(twice, expr), expr);
        let difference = graph.sub(expr, expr);
        prop_assert!(graph.is_zero(difference));
        for node in graph.reachable(&[expr, negated, twice]) {
            prop_assert!(is_canonical(graph, node), "{:?} in {}", graph.node(node), infix(graph, expr));
        }
        Ok(Verdict::Holds)
    });
}

/// What the documentation of `Node` promises.
fn is_canonical(graph: &Graph, expr: Expr) -> bool {
    let operands_first = graph.operands(expr).all(|operand| operand.index() < expr.index());
    operands_first
        && match graph.node(expr) {
            Node::Sum { constant, terms } => {
                terms.len() + usize::from(!constant.is_zero()) > 1
                    && terms.windows(2).all(|pair| pair[0].0 < pair[1].0)
                    && terms.iter().all(|(term, c)| !c.is_zero() && is_monic(graph, *term))
            }
            Node::Product { coefficient, factors } => {
                !coefficient.is_zero()
                    && !matches!(&**factors, [(_, 1)] if coefficient.is_one())
                    && factors.windows(2).all(|pair| pair[0].0 < pair[1].0 || is_quotient(pair))
                    && factors.iter().all(|(base, exponent)| *exponent != 0 && is_primitive(graph, *base))
            }
            Node::Power { exponent, .. } => graph.as_number(*exponent).is_none_or(is_unit_fraction),
            _ => true,
        }
}

/// `x^2/x`, which is not x.
fn is_quotient(pair: &[(Expr, i64)]) -> bool {
    pair[0].0 == pair[1].0 && pair[0].1 > 0 && pair[1].1 < 0
}

/// A sum that is a factor has coprime integer coefficients, the first one positive.
fn is_primitive(graph: &Graph, base: Expr) -> bool {
    match graph.node(base) {
        Node::Sum { constant, terms } => {
            let divisor = terms.iter().fold(constant.abs(), |divisor, (_, c)| divisor.gcd(c));
            divisor.is_one() && !terms[0].1.is_negative()
        }
        _ => true,
    }
}

fn is_monic(graph: &Graph, term: Expr) -> bool {
    match graph.node(term) {
        Node::Number(_) | Node::Sum { .. } => false,
        Node::Product { coefficient, .. } => coefficient.is_one(),
        _ => true,
    }
}

fn is_unit_fraction(number: &Number) -> bool {
    number.to_fraction().is_some_and(|(p, q)| p == 1 && q > 1)
}

#[test]
fn trees_are_read_as_they_are_meant() {
    let symbol = |at| Box::new(Tree::Symbol(at));
    let quotient = Tree::Div(Tree::Power(symbol(0), 2, 1).into(), symbol(0));
    let mut space = Workspace::new();
    assert_eq!(space.track(&quotient, &[3.0, 0.0, 0.0, 0.0]).agrees(3.0), Some(true));
    assert_eq!(space.track(&quotient, &[0.0; 4]).kind(), Kind::NotFinite);
    let difference = Tree::Sub(quotient.clone().into(), quotient.into());
    assert_eq!(space.track(&difference, &[0.0; 4]).kind(), Kind::Unknown);
}
