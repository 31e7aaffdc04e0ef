//! Derivatives against dual numbers.

use crate::harness::{Outcome, Verdict, check};
use crate::tree::{NAMES, Point, Tree, Workspace, generic_point, tree};
use codegen::notation::infix;
use codegen::symbolic::{Constant, Differential, Expr, Function, Graph, Node, Number};
use num_dual::{Dual2_64, Dual64, DualNum, HyperDual64};
use proptest::prelude::*;
use proptest::test_runner::TestCaseError;
use std::array::from_fn;
use std::f64::consts::{E, FRAC_PI_2, PI};

const CASES: u32 = crate::harness::sampled(1_500, 5_000);

/// How far each intermediate result is moved to see what its rounding would do.
const NUDGE: f64 = 1e-9;

/// Dual numbers part by part.
trait Parts: DualNum<Primitive = f64> {
    fn map(self, change: impl FnMut(f64) -> f64) -> Self;
}

impl Parts for Dual64 {
    fn map(self, change: impl FnMut(f64) -> f64) -> Dual64 {
        let [re, eps] = [self.re, self.eps].map(change);
        Dual64::new(re, eps)
    }
}

impl Parts for Dual2_64 {
    fn map(self, change: impl FnMut(f64) -> f64) -> Dual2_64 {
        let [re, v1, v2] = [self.re, self.v1, self.v2].map(change);
        Dual2_64::new(re, v1, v2)
    }
}

impl Parts for HyperDual64 {
    fn map(self, change: impl FnMut(f64) -> f64) -> HyperDual64 {
        let [re, eps1, eps2, eps1eps2] = [self.re, self.eps1, self.eps2, self.eps1eps2].map(change);
        HyperDual64::new(re, eps1, eps2, eps1eps2)
    }
}

/// Evaluates trees in dual numbers, every part of every intermediate result moved by a factor of its own.
struct Interpreter {
    nudge: f64,
    state: u64,
}

impl Interpreter {
    fn evaluate<D: Parts>(&mut self, tree: &Tree, point: &[D]) -> D {
        let mut at = |tree: &Tree| self.evaluate(tree, point);
        let value = match tree {
            Tree::Number(p, q) => D::from(*p as f64 / *q as f64),
            Tree::Decimal(digits) => D::from(digits.parse().expect(digits)),
            Tree::Constant(Constant::Pi) => D::from(PI),
            Tree::Constant(Constant::E) => D::from(E),
            Tree::Symbol(at) => point[*at].clone(),
            Tree::Add(a, b) => at(a) + at(b),
            Tree::Sub(a, b) => at(a) - at(b),
            Tree::Mul(a, b) => at(a) * at(b),
            Tree::Div(a, b) => at(a) * at(&Tree::Power(b.clone(), -1, 1)),
            Tree::Power(a, p @ ..0, 1) => nonzero(at(a)).powi(*p as i32),
            Tree::Power(a, p, 1) => at(a).powi(*p as i32),
            Tree::Power(a, p, q) => nonzero(at(a).powf(*p as f64 / *q as f64)),
            Tree::SymbolicPower(a, b) => nonzero(at(a).powd(at(b))),
            Tree::Call(function, a) => apply(*function, at(a)),
            Tree::Choice(difference, above, otherwise) => {
                // Next to the switch rounding decides.
                let difference = nonzero(at(difference)).re();
                let chosen = if difference > 0.0 { at(above) } else { at(otherwise) };
                only_if(!difference.is_nan(), chosen)
            }
            Tree::Atan2(y, x) => {
                let (y, x) = (at(y), at(x));
                self.angle(nonzero(y), x)
            }
        };
        self.nudged(value)
    }

    /// `DualNum::atan2` without its loss of digits at small x.
    fn angle<D: Parts>(&mut self, y: D, x: D) -> D {
        match y.re().abs() < x.re().abs() {
            true => y.atan2(x),
            false => (-x * self.nudged(y.recip())).atan() + FRAC_PI_2.copysign(y.re()),
        }
    }

    fn nudged<D: Parts>(&mut self, value: D) -> D {
        // The cubes of parts, as in second derivatives of a reciprocal, shall be far from overflow.
        value.map(|part| match part.abs() < 1e30 {
            true => part * (1.0 + self.nudge * self.next_sign()),
            false => f64::NAN,
        })
    }

    /// -1 or 1, by Knuth's linear congruential generator.
    fn next_sign(&mut self) -> f64 {
        self.state = self.state.wrapping_mul(6_364_136_223_846_793_005).wrapping_add(1_442_695_040_888_963_407);
        if self.state >> 63 == 0 { 1.0 } else { -1.0 }
    }
}

fn only_if<D: Parts>(condition: bool, value: D) -> D {
    value.map(|part| if condition { part } else { f64::NAN })
}

/// The value, unless rounding or underflow may decide whether it is zero.
fn nonzero<D: Parts>(value: D) -> D {
    only_if(value.re().abs() > 1e-6, value)
}

/// The value, unless it is at the edge of the domain of arcsine and arccosine.
fn inside<D: Parts>(value: D) -> D {
    only_if(value.re().abs() < 1.0 - 1e-6, value)
}

fn apply<D: Parts>(function: Function, x: D) -> D {
    match function {
        Function::Sin => x.sin(),
        Function::Cos => x.cos(),
        Function::Tan => x.tan(),
        Function::Asin => inside(x).asin(),
        Function::Acos => inside(x).acos(),
        Function::Atan => x.atan(),
        Function::Sinh => x.sinh(),
        Function::Cosh => x.cosh(),
        // The slope is 1 - tanh(x)^2 in the engine, which loses its digits where tanh(x) comes close to 1.
        Function::Tanh => only_if(x.re().abs() < 4.0, x).tanh(),
        Function::Exp => nonzero(x.exp()),
        Function::Ln => x.ln(),
        Function::Abs => nonzero(x).abs(),
        Function::Sign => nonzero(x.clone()) * 0.0 + x.re().signum(),
    }
}

/// A derivative by dual numbers, and how far the derivative by the engine may be away from it.
///
/// Roundings are ten million times smaller than the nudges, and so is what they do to the result. The
/// engine has another derivative of the same function, with more operations on larger numbers; a factor of
/// ten thousand covers that in all cases. The last few roundings, of the result itself, are added.
struct Reference {
    value: f64,
    tolerance: f64,
}

impl Reference {
    /// `None` without a value, or where the nudges change it so much that it says nothing.
    fn new<D: Parts>(tree: &Tree, point: &[D], part: impl Fn(D) -> f64) -> Option<Reference> {
        let at = |nudge, state| part(Interpreter { nudge, state }.evaluate(tree, point));
        let value = at(0.0, 0);
        let moved = [1, 2, 3, 4, 5, 6, 7, 8].map(|state| (at(NUDGE, state) - value).abs());
        let known = value.abs() < 1e12 && moved.iter().all(|moved| *moved < 1e-3 * (1.0 + value.abs()));
        let most = moved.into_iter().fold(0.0, f64::max);
        known.then_some(Reference { value, tolerance: 1e-3 * most + 1e-14 * (1.0 + value.abs()) })
    }

    fn compare(reference: Option<Reference>, space: &Workspace, derivative: Expr, point: &Point) -> Outcome {
        let Some(Reference { value, tolerance }) = reference else { return Ok(Verdict::Open) };
        if is_steep(&space.graph, derivative) {
            return Ok(Verdict::Open);
        }
        let result = space.evaluate(derivative, point);
        if (result - value).abs() <= tolerance {
            return Ok(Verdict::Holds);
        }
        let text = infix(&space.graph, derivative);
        Err(TestCaseError::fail(format!("{result} instead of {value} within {tolerance:e}: {text}")))
    }
}

/// Whether there is a power of which rounding takes more digits than a nudge, such as `(x^(1/q))^p` with a
/// large p.
fn is_steep(graph: &Graph, expr: Expr) -> bool {
    graph.reachable(&[expr]).into_iter().any(|part| match graph.node(part) {
        Node::Product { factors, .. } => factors.iter().any(|(_, exponent)| exponent.abs() > 1000),
        _ => false,
    })
}

fn symbol() -> impl Strategy<Value = usize> {
    0..NAMES.len()
}

#[test]
fn partial_derivatives_are_those_of_dual_numbers() {
    check(CASES, 70, (tree(), symbol(), generic_point()), |(tree, along, point)| {
        let mut space = Workspace::new();
        let expr = space.build(&tree);
        let derivative = Differential::partial(&mut space.graph, space.symbols[along]).of(&mut space.graph, expr);
        let dual: Point<Dual64> = from_fn(|at| Dual64::new(point[at], f64::from(at == along)));
        Reference::compare(Reference::new(&tree, &dual, |d| d.eps), &space, derivative, &point)
    });
}

#[test]
fn directional_derivatives_follow_the_rates() {
    let rates = proptest::array::uniform4(proptest::option::of(tree()));
    check(CASES, 60, (tree(), rates, generic_point()), |(tree, rates, point)| {
        let mut space = Workspace::new();
        let expr = space.build(&tree);
        let rates = rates.map(|rate| space.build(&rate.unwrap_or(Tree::Number(0, 1))));
        let mut differential = Differential::along(space.symbols.into_iter().zip(rates));
        let derivative = differential.of(&mut space.graph, expr);
        let dual: Point<Dual64> = from_fn(|at| Dual64::new(point[at], space.evaluate(rates[at], &point)));
        Reference::compare(Reference::new(&tree, &dual, |d| d.eps), &space, derivative, &point)
    });
}

#[test]
fn mixed_second_derivatives_are_those_of_hyperdual_numbers() {
    check(CASES, 70, (tree(), symbol(), symbol(), generic_point()), |(tree, first, second, point)| {
        let mut space = Workspace::new();
        let mut derivative = space.build(&tree);
        for along in [first, second] {
            let symbol = space.symbols[along];
            derivative = Differential::partial(&mut space.graph, symbol).of(&mut space.graph, derivative);
        }
        let part = |at, along| f64::from(at == along);
        let dual: Point<HyperDual64> =
            from_fn(|at| HyperDual64::new(point[at], part(at, first), part(at, second), 0.0));
        Reference::compare(Reference::new(&tree, &dual, |d| d.eps1eps2), &space, derivative, &point)
    });
}

/// The second total time derivative, with z the speed of x and w that of y, of constant acceleration.
#[test]
fn accelerations_are_those_of_second_order_duals() {
    let quarters = || -8i64..=8;
    check(CASES, 70, (tree(), [quarters(), quarters()], generic_point()), |(tree, accelerations, point)| {
        let mut space = Workspace::new();
        let expr = space.build(&tree);
        let [x, y, z, w] = space.symbols;
        let graph = &mut space.graph;
        let rates = accelerations.map(|quarters| graph.number(Number::fraction(quarters, 4).unwrap()));
        let mut time =
            Differential::along([(x, graph.variable(z)), (y, graph.variable(w)), (z, rates[0]), (w, rates[1])]);
        let speed = time.of(graph, expr);
        let acceleration = time.of(graph, speed);
        let [ddx, ddy] = accelerations.map(|quarters| quarters as f64 / 4.0);
        let dual = [
            Dual2_64::new(point[0], point[2], ddx),
            Dual2_64::new(point[1], point[3], ddy),
            Dual2_64::new(point[2], ddx, 0.0),
            Dual2_64::new(point[3], ddy, 0.0),
        ];
        Reference::compare(Reference::new(&tree, &dual, |d| d.v2), &space, acceleration, &point)
    });
}
