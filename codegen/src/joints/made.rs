//! Expressions made by the language itself, for joints and points on bodies. Their regions are the user's.

use crate::dsl::{Expression, Guide, Kind, Operator, Region};
use proc_macro2::Span;
use syn::Ident;

/// The distance of a point from a line, to its left.
pub(super) fn across(at: Region, point: Expression, guide: &Guide) -> Expression {
    let sine = call(at, "sin", vec![guide.along.clone()]);
    let normal =
        vec![Expression { region: at, kind: Kind::Negate(Box::new(sine)) }, call(at, "cos", vec![guide.along.clone()])];
    inner(at, difference(point, guide.through.clone()), Expression { region: at, kind: Kind::Vector(normal) })
}

pub(super) fn direction(at: Region, along: &Expression) -> Expression {
    let components = ["cos", "sin"].map(|function| call(at, function, vec![along.clone()]));
    Expression { region: at, kind: Kind::Vector(components.into()) }
}

pub(super) fn inner(at: Region, a: Expression, b: Expression) -> Expression {
    call(at, "inner", vec![a, b])
}

pub(super) fn call(region: Region, function: &str, arguments: Vec<Expression>) -> Expression {
    Expression { region, kind: Kind::Call(Ident::new(function, Span::call_site()), arguments) }
}

/// `attitude(body)`, written out.
pub(super) fn attitude(region: Region, body: &Ident, rotation: Expression) -> Expression {
    Expression { region, kind: Kind::Attitude(body.clone(), Box::new(rotation)) }
}

/// A table at an argument.
pub(super) fn called(table: &Ident, argument: Expression) -> Expression {
    Expression { region: table.into(), kind: Kind::Call(table.clone(), vec![argument]) }
}

pub(super) fn component(vector: &Expression, axis: &str) -> Expression {
    let name = Ident::new(axis, Span::call_site());
    Expression { region: vector.region, kind: Kind::Component(Box::new(vector.clone()), name) }
}

pub(super) fn zero(region: Region) -> Expression {
    Expression { region, kind: Kind::Number { literal: "0".into(), unit: None } }
}

pub(super) fn number(region: Region, literal: &str) -> Expression {
    let number = |literal: &str| Expression { region, kind: Kind::Number { literal: literal.into(), unit: None } };
    match literal.strip_prefix('-') {
        Some(size) => Expression { region, kind: Kind::Negate(Box::new(number(size))) },
        None => number(literal),
    }
}

/// The circle's ratio.
pub(super) fn pi(region: Region) -> Expression {
    named(&Ident::new("pi", region.start()), region)
}

/// A name as an expression.
pub(super) fn named(name: &Ident, region: Region) -> Expression {
    Expression { region, kind: Kind::Name(name.clone()) }
}

pub(super) fn negated(operand: Expression) -> Expression {
    Expression { region: operand.region, kind: Kind::Negate(Box::new(operand)) }
}

pub(super) fn sum(a: Expression, b: Expression) -> Expression {
    binary(Operator::Add, a, b)
}

pub(super) fn vector(region: Region, components: Vec<Expression>) -> Expression {
    Expression { region, kind: Kind::Vector(components) }
}

pub(super) fn quotient(a: Expression, b: Expression) -> Expression {
    binary(Operator::Divide, a, b)
}

pub(super) fn product(a: Expression, b: Expression) -> Expression {
    binary(Operator::Multiply, a, b)
}

pub(super) fn difference(a: Expression, b: Expression) -> Expression {
    binary(Operator::Subtract, a, b)
}

pub(super) fn binary(operator: Operator, left: Expression, right: Expression) -> Expression {
    let region = left.region.to(right.region);
    Expression { region, kind: Kind::Binary(operator, Box::new(left), Box::new(right)) }
}
