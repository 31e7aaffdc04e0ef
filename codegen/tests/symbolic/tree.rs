//! Expressions as plain trees: what the user wrote, without any rewriting.

use crate::tracked::{Kind, Tracked};
use codegen::symbolic::{Constant, Expr, Function, Graph, Number, Symbol};
use proptest::prelude::*;
use proptest::sample::select;
use std::fmt;

#[derive(Clone)]
pub(crate) enum Tree {
    Number(i64, i64),
    Decimal(String),
    Constant(Constant),
    Symbol(usize),
    Add(Box<Tree>, Box<Tree>),
    Sub(Box<Tree>, Box<Tree>),
    Mul(Box<Tree>, Box<Tree>),
    Div(Box<Tree>, Box<Tree>),
    /// With the exponent a fraction.
    Power(Box<Tree>, i64, i64),
    SymbolicPower(Box<Tree>, Box<Tree>),
    Call(Function, Box<Tree>),
    Atan2(Box<Tree>, Box<Tree>),
    Choice(Box<Tree>, Box<Tree>, Box<Tree>),
}

pub(crate) const NAMES: [&str; 4] = ["x", "y", "z", "w"];

pub(crate) type Point<T = f64> = [T; NAMES.len()];

/// A graph whose symbols are those of the trees.
pub(crate) struct Workspace {
    pub(crate) graph: Graph,
    pub(crate) symbols: [Symbol; NAMES.len()],
}

impl Workspace {
    pub(crate) fn new() -> Workspace {
        let mut graph = Graph::new();
        let symbols = NAMES.map(|name| graph.symbol(name));
        Workspace { graph, symbols }
    }

    /// The tree through the constructors of the engine.
    pub(crate) fn build(&mut self, tree: &Tree) -> Expr {
        let mut operand = |tree: &Tree| self.build(tree);
        match tree {
            Tree::Number(p, q) => self.graph.number(Number::fraction(*p, *q).unwrap()),
            Tree::Decimal(digits) => self.graph.number(Number::parse_decimal(digits).expect(digits)),
            Tree::Constant(constant) => self.graph.constant(*constant),
            Tree::Symbol(at) => self.graph.variable(self.symbols[*at]),
            Tree::Power(base, p, q) => {
                let base = operand(base);
                let exponent = self.graph.number(Number::fraction(*p, *q).unwrap());
                self.graph.power(base, exponent)
            }
            Tree::Call(function, argument) => {
                let argument = operand(argument);
                self.graph.call(*function, argument)
            }
            Tree::Add(a, b) => {
                let (a, b) = (operand(a), operand(b));
                self.graph.add(a, b)
            }
            Tree::Sub(a, b) => {
                let (a, b) = (operand(a), operand(b));
                self.graph.sub(a, b)
            }
            Tree::Mul(a, b) => {
                let (a, b) = (operand(a), operand(b));
                self.graph.mul(a, b)
            }
            Tree::Div(a, b) => {
                let (a, b) = (operand(a), operand(b));
                self.graph.div(a, b)
            }
            Tree::SymbolicPower(a, b) => {
                let (a, b) = (operand(a), operand(b));
                self.graph.power(a, b)
            }
            Tree::Atan2(a, b) => {
                let (a, b) = (operand(a), operand(b));
                self.graph.atan2(a, b)
            }
            Tree::Choice(a, b, c) => {
                let (a, b, c) = (operand(a), operand(b), operand(c));
                self.graph.choice(a, b, c)
            }
        }
    }

    /// The value of an expression as the engine computes it.
    pub(crate) fn evaluate(&self, expr: Expr, point: &Point) -> f64 {
        let value = |symbol| point[self.symbols.iter().position(|s| *s == symbol).unwrap()];
        codegen::symbolic::evaluate(&self.graph, &[expr], value)[0]
    }

    /// The value of the tree itself.
    pub(crate) fn track(&mut self, tree: &Tree, point: &Point) -> Tracked {
        match tree {
            Tree::Number(p, q) => Tracked::exact(*p as f64).over(Tracked::exact(*q as f64)),
            Tree::Decimal(digits) => Tracked::rounded(digits.parse().expect(digits)),
            Tree::Constant(constant) => Tracked::rounded(constant.to_f64()),
            Tree::Symbol(at) => Tracked::exact(point[*at]),
            Tree::Add(a, b) => self.track(a, point).plus(self.track(b, point)),
            Tree::Sub(a, b) => self.track(a, point).minus(self.track(b, point)),
            Tree::Mul(a, b) => {
                let (left, right) = (self.track(a, point), self.track(b, point));
                self.unless_dropped(left.times(right), &[(a, right), (b, left)])
            }
            Tree::Div(a, b) => {
                let (left, right) = (self.track(a, point), self.track(b, point).power(-1));
                self.unless_dropped(left.times(right), &[(a, right)])
            }
            Tree::Power(base, p, 1) => self.track(base, point).power(*p),
            Tree::Power(base, p, q) => {
                let exponent = Tracked::exact(*p as f64).over(Tracked::exact(*q as f64));
                self.track(base, point).to_the(exponent, p.unsigned_abs() as u32)
            }
            // An exponent that turns out to be a number may have a numerator of up to seven digits.
            Tree::SymbolicPower(a, b) => self.track(a, point).to_the(self.track(b, point), 10_000_000),
            Tree::Call(function, argument) => self.track(argument, point).call(*function),
            Tree::Atan2(y, x) => self.track(y, point).atan2(self.track(x, point)),
            Tree::Choice(difference, above, otherwise) => {
                let chosen =
                    self.track(difference, point).choose(self.track(above, point), self.track(otherwise, point));
                // A choice between equals is that, whatever it is made by.
                match self.build(above) == self.build(otherwise) {
                    true => self.track(above, point),
                    false => chosen,
                }
            }
        }
    }

    /// `0*x` is 0 in the engine, whatever x is: where a factor is the number 0 and the other one has no
    /// finite value, the product is not to be compared.
    fn unless_dropped(&mut self, product: Tracked, factors: &[(&Tree, Tracked)]) -> Tracked {
        for (factor, other) in factors {
            if other.kind() != Kind::Finite {
                let factor = self.build(factor);
                if self.graph.is_zero(factor) {
                    return Tracked::Unknown;
                }
            }
        }
        product
    }
}

impl Tree {
    /// The tree with symbols replaced.
    pub(crate) fn substitute(&self, replacements: &[Option<Tree>]) -> Tree {
        let sub = |tree: &Tree| Box::new(tree.substitute(replacements));
        match self {
            Tree::Symbol(at) => replacements[*at].clone().unwrap_or_else(|| self.clone()),
            Tree::Number(..) | Tree::Decimal(_) | Tree::Constant(_) => self.clone(),
            Tree::Add(a, b) => Tree::Add(sub(a), sub(b)),
            Tree::Sub(a, b) => Tree::Sub(sub(a), sub(b)),
            Tree::Mul(a, b) => Tree::Mul(sub(a), sub(b)),
            Tree::Div(a, b) => Tree::Div(sub(a), sub(b)),
            Tree::Power(base, p, q) => Tree::Power(sub(base), *p, *q),
            Tree::SymbolicPower(a, b) => Tree::SymbolicPower(sub(a), sub(b)),
            Tree::Call(function, argument) => Tree::Call(*function, sub(argument)),
            Tree::Atan2(y, x) => Tree::Atan2(sub(y), sub(x)),
            Tree::Choice(a, b, c) => Tree::Choice(sub(a), sub(b), sub(c)),
        }
    }
}

/// With all parentheses.
impl fmt::Debug for Tree {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        match self {
            Tree::Number(p, 1) => write!(f, "{p}"),
            Tree::Number(p, q) => write!(f, "({p}/{q})"),
            Tree::Decimal(digits) => write!(f, "{digits}"),
            Tree::Constant(constant) => write!(f, "{constant:?}"),
            Tree::Symbol(at) => write!(f, "{}", NAMES[*at]),
            Tree::Add(a, b) => write!(f, "({a:?} + {b:?})"),
            Tree::Sub(a, b) => write!(f, "({a:?} - {b:?})"),
            Tree::Mul(a, b) => write!(f, "({a:?} * {b:?})"),
            Tree::Div(a, b) => write!(f, "({a:?} / {b:?})"),
            Tree::Power(a, p, q) => write!(f, "({a:?} ^ ({p}/{q}))"),
            Tree::SymbolicPower(a, b) => write!(f, "({a:?} ^ {b:?})"),
            Tree::Call(function, a) => write!(f, "{}({a:?})", function.name()),
            Tree::Atan2(y, x) => write!(f, "atan2({y:?}, {x:?})"),
            Tree::Choice(a, b, c) => write!(f, "choice({a:?}, {b:?}, {c:?})"),
        }
    }
}

pub(crate) fn add(a: Tree, b: Tree) -> Tree {
    Tree::Add(a.into(), b.into())
}

pub(crate) fn mul(a: Tree, b: Tree) -> Tree {
    Tree::Mul(a.into(), b.into())
}

pub(crate) fn div(a: Tree, b: Tree) -> Tree {
    Tree::Div(a.into(), b.into())
}

pub(crate) fn sub(a: Tree, b: Tree) -> Tree {
    Tree::Sub(a.into(), b.into())
}

pub(crate) fn call(function: Function, argument: Tree) -> Tree {
    Tree::Call(function, argument.into())
}

fn square(a: Tree) -> Tree {
    Tree::Power(a.into(), 2, 1)
}

/// `a sin(u)^2 + b cos(u)^2`.
fn squares(u: Tree, a: Tree, b: Tree) -> Tree {
    add(mul(a, square(call(Function::Sin, u.clone()))), mul(square(call(Function::Cos, u)), b))
}

fn leaf() -> impl Strategy<Value = Tree> {
    prop_oneof![
        6 => (0..NAMES.len()).prop_map(Tree::Symbol),
        3 => (-4i64..=4, select(vec![1, 1, 1, 2, 3, 4, 5])).prop_map(|(p, q)| Tree::Number(p, q)),
        1 => select(vec![Constant::Pi, Constant::E]).prop_map(Tree::Constant),
    ]
}

/// Any expression; sums and products, of which canonical form knows most, are the most frequent.
pub(crate) fn tree() -> impl Strategy<Value = Tree> {
    leaf().prop_recursive(5, 20, 2, |inner| {
        let pair = (inner.clone(), inner.clone());
        prop_oneof![
            6 => pair.clone().prop_map(|(a, b)| add(a, b)),
            6 => pair.clone().prop_map(|(a, b)| sub(a, b)),
            6 => pair.clone().prop_map(|(a, b)| mul(a, b)),
            6 => pair.clone().prop_map(|(a, b)| div(a, b)),
            4 => (inner.clone(), -3i64..=4).prop_map(|(a, p)| Tree::Power(a.into(), p, 1)),
            4 => (inner.clone(), select(vec![(1, 2), (3, 2), (-1, 2), (1, 3)]))
                .prop_map(|(a, (p, q))| Tree::Power(a.into(), p, q)),
            2 => pair.clone().prop_map(|(a, b)| Tree::SymbolicPower(a.into(), b.into())),
            8 => (select(&Function::ALL[..]), inner.clone()).prop_map(|(f, a)| call(f, a)),
            2 => pair.clone().prop_map(|(a, b)| Tree::Atan2(a.into(), b.into())),
            3 => (inner.clone(), pair.clone()).prop_map(|(a, (b, c))| Tree::Choice(a.into(), b.into(), c.into())),
            4 => pair.prop_flat_map(|(a, b)| select(repetitions(a, b))),
        ]
    })
}

/// What random operands would hardly ever do: the same part twice, in the ways that canonical form rewrites.
fn repetitions(a: Tree, b: Tree) -> Vec<Tree> {
    let one = Tree::Number(1, 1);
    let two = Tree::Number(2, 1);
    let quotient = |a: Tree| div(square(a.clone()), a);
    vec![
        div(mul(a.clone(), b.clone()), a.clone()),
        quotient(a.clone()),
        quotient(add(one.clone(), square(a.clone()))),
        quotient(add(one.clone(), Tree::Power(a.clone().into(), 1, 2))),
        quotient(add(one.clone(), Tree::SymbolicPower(a.clone().into(), b.clone().into()))),
        div(call(Function::Exp, a.clone()), mul(b.clone(), call(Function::Exp, a.clone()))),
        sub(a.clone(), add(b.clone(), a.clone())),
        sub(mul(two.clone(), add(a.clone(), b.clone())), mul(a.clone(), two.clone())),
        add(mul(sub(a.clone(), b.clone()), a.clone()), mul(sub(b.clone(), a.clone()), b.clone())),
        squares(a.clone(), two, one),
        squares(a.clone(), b.clone(), b),
        div(Tree::Number(1, 1), div(Tree::Number(-3, 2), a)),
    ]
}

/// Values that collide, vanish and reach the edges of domains, and some that do none of it.
pub(crate) fn point() -> impl Strategy<Value = Point> {
    let coordinate = prop_oneof![
        select(vec![0.0, 1.0, -1.0, 0.5, -2.0]),
        (-12i8..=12).prop_map(|quarters| f64::from(quarters) / 4.0),
        -3.0..3.0f64,
    ];
    [coordinate.clone(), coordinate.clone(), coordinate.clone(), coordinate]
}

/// Values that do not collide; two of them are positive, for roots and logarithms.
pub(crate) fn generic_point() -> impl Strategy<Value = Point> {
    [-3.0..3.0f64, -3.0..3.0f64, 0.1..3.0f64, 0.1..3.0f64]
}
