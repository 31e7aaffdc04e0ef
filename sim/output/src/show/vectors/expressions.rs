//! Rewriting of expressions.

use codegen::dsl::{Choice, Expression, Kind, Operator, Output};

/// Half the distance between the two places from which a constraint's derivative is taken, in metres: exact to
/// rounding for constraints of degree two in a point, which those of linkages are.
pub(super) const REACH: f64 = 0.000_976_562_5;

const AXES: [&str; 3] = ["x", "y", "z"];

/// C with the point, or its velocity, moved forwards along an axis, minus C with it moved back.
pub(super) fn change(constraint: &Expression, point: &Expression, axis: usize, dimension: usize) -> Expression {
    let step = made(Kind::Vector((0..dimension).map(|i| number(if i == axis { REACH } else { 0.0 })).collect()));
    let moved = |sign: Operator| substitute(constraint, point, &binary(sign, point.clone(), step.clone()));
    binary(Operator::Subtract, moved(Operator::Add), moved(Operator::Subtract))
}

/// Whether it is a vector, given the names of some.
pub(super) fn is_vector(expression: &Expression, vectors: &[String]) -> bool {
    match &expression.kind {
        Kind::Vector(_) => true,
        Kind::Name(name) => vectors.contains(&name.to_string()),
        Kind::Negate(operand) => is_vector(operand, vectors),
        Kind::Binary(_, left, right) => is_vector(left, vectors) || is_vector(right, vectors),
        Kind::Call(function, operands) => {
            let is_rate = function == "dot" || function == "ddot";
            is_rate && operands.iter().all(|x| is_vector(x, vectors)) || function == "angular_velocity"
        }
        Kind::If(choice) => is_vector(&choice.yes, vectors),
        Kind::Number { .. } | Kind::Component(..) | Kind::Attitude(..) => false,
    }
}

/// The names in an expression, each once.
pub(super) fn named(expression: &Expression) -> Vec<String> {
    let mut names: Vec<String> = match &expression.kind {
        Kind::Name(name) => vec![name.to_string()],
        _ => expression.parts().into_iter().flat_map(named).collect(),
    };
    names.sort();
    names.dedup();
    names
}

/// The replacement of a name, or of its rate.
fn substitute(expression: &Expression, point: &Expression, by: &Expression) -> Expression {
    rebuilt(expression, &|part| is_same(part, point).then(|| by.clone()))
}

fn is_same(a: &Expression, b: &Expression) -> bool {
    match (&a.kind, &b.kind) {
        (Kind::Name(a), Kind::Name(b)) => a == b,
        (Kind::Call(f, a), Kind::Call(g, b)) => {
            f == g && a.len() == b.len() && a.iter().zip(b).all(|(a, b)| is_same(a, b))
        }
        _ => false,
    }
}

/// The expression with some parts replaced.
fn rebuilt(expression: &Expression, replaced: &dyn Fn(&Expression) -> Option<Expression>) -> Expression {
    if let Some(other) = replaced(expression) {
        return other;
    }
    let again = |expression: &Expression| rebuilt(expression, replaced);
    let boxed = |expression: &Expression| Box::new(again(expression));
    let kind = match &expression.kind {
        Kind::Name(name) => Kind::Name(name.clone()),
        Kind::Number { literal, unit } => Kind::Number { literal: literal.clone(), unit: unit.clone() },
        Kind::Vector(items) => Kind::Vector(items.iter().map(again).collect()),
        Kind::Negate(operand) => Kind::Negate(boxed(operand)),
        Kind::Binary(operator, left, right) => Kind::Binary(*operator, boxed(left), boxed(right)),
        Kind::Call(function, items) => Kind::Call(function.clone(), items.iter().map(again).collect()),
        Kind::Component(vector, axis) => Kind::Component(boxed(vector), axis.clone()),
        Kind::Attitude(body, rotation) => Kind::Attitude(body.clone(), boxed(rotation)),
        Kind::If(choice) => Kind::If(Box::new(Choice {
            left: again(&choice.left),
            comparison: choice.comparison,
            right: again(&choice.right),
            yes: again(&choice.yes),
            no: again(&choice.no),
        })),
    };
    Expression { region: expression.region, kind }
}

fn made(kind: Kind) -> Expression {
    Expression { region: span().into(), kind }
}

fn span() -> proc_macro2::Span {
    proc_macro2::Span::call_site()
}

pub(super) fn name(name: &str) -> Expression {
    made(Kind::Name(proc_macro2::Ident::new(name, span())))
}

pub(super) fn rate(of: &str) -> Expression {
    made(Kind::Call(proc_macro2::Ident::new("dot", span()), vec![name(of)]))
}

fn number(value: f64) -> Expression {
    made(Kind::Number { literal: format!("{value:?}"), unit: None })
}

pub(super) fn binary(operator: Operator, left: Expression, right: Expression) -> Expression {
    made(Kind::Binary(operator, Box::new(left), Box::new(right)))
}

pub(super) fn components(vector: &Expression, dimension: usize) -> Vec<Expression> {
    let component = |axis| made(Kind::Component(Box::new(vector.clone()), proc_macro2::Ident::new(axis, span())));
    AXES[..dimension].iter().copied().map(component).collect()
}

pub(super) fn output(value: Expression) -> Output {
    Output { docs: String::new(), name: proc_macro2::Ident::new("arrow", span()), unit: None, value }
}
