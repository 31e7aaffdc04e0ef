//! Expressions as text, in the notation of the language.

use super::{Constant, Expr, Graph, Node, Number};

/// How tightly the outermost operation of a text binds.
#[derive(Clone, Copy, PartialEq, PartialOrd)]
enum Binding {
    Sum,
    Product,
    Power,
    Atom,
}

/// The expression in infix notation, with the fewest parentheses.
///
/// Shared parts are written out each time: for reading, not for large systems.
pub fn infix(graph: &Graph, expr: Expr) -> String {
    text(graph, expr).0
}

fn text(graph: &Graph, expr: Expr) -> (String, Binding) {
    match graph.node(expr) {
        Node::Number(value) => number(value),
        Node::Constant(Constant::Pi) => ("pi".into(), Binding::Atom),
        Node::Constant(Constant::E) => ("e".into(), Binding::Atom),
        Node::Symbol(symbol) => (graph.symbol_name(*symbol).to_owned(), Binding::Atom),
        Node::Sum { constant, terms } => (sum(graph, constant, terms), Binding::Sum),
        Node::Product { coefficient, factors } => product(graph, coefficient, factors),
        Node::Power { base, exponent } => {
            let half = graph.as_number(*exponent).is_some_and(|e| e.to_fraction() == Some((1, 2)));
            match half {
                true => (format!("sqrt({})", infix(graph, *base)), Binding::Atom),
                false => (format!("{}^{}", atom(graph, *base), atom(graph, *exponent)), Binding::Power),
            }
        }
        Node::Call(function, argument) => (format!("{}({})", function.name(), infix(graph, *argument)), Binding::Atom),
        Node::Atan2(y, x) => (format!("atan2({}, {})", infix(graph, *y), infix(graph, *x)), Binding::Atom),
    }
}

fn number(value: &Number) -> (String, Binding) {
    let binding = match (value.is_negative(), value.is_integer()) {
        (true, _) => Binding::Sum,
        (_, true) => Binding::Atom,
        (_, false) => Binding::Product,
    };
    (value.to_string(), binding)
}

fn bound(graph: &Graph, expr: Expr, at_least: Binding) -> String {
    let (text, binding) = text(graph, expr);
    if binding >= at_least { text } else { format!("({text})") }
}

fn atom(graph: &Graph, expr: Expr) -> String {
    bound(graph, expr, Binding::Atom)
}

fn sum(graph: &Graph, constant: &Number, terms: &[(Expr, Number)]) -> String {
    let mut out = String::new();
    for (term, coefficient) in terms {
        let (size, negative) = (coefficient.abs(), coefficient.is_negative());
        push_sign(&mut out, negative);
        let term = bound(graph, *term, Binding::Product);
        out += &match (size.is_one(), term.strip_prefix("1/")) {
            (true, _) => term,
            (false, Some(below)) => format!("{}/{below}", number_factor(&size)),
            (false, None) => format!("{}*{term}", number_factor(&size)),
        };
    }
    if !constant.is_zero() {
        push_sign(&mut out, constant.is_negative());
        out += &constant.abs().to_string();
    }
    out
}

fn push_sign(out: &mut String, negative: bool) {
    *out += match (out.is_empty(), negative) {
        (true, true) => "-",
        (true, false) => "",
        (false, true) => " - ",
        (false, false) => " + ",
    };
}

fn number_factor(value: &Number) -> String {
    if value.is_integer() { value.to_string() } else { format!("({value})") }
}

fn product(graph: &Graph, coefficient: &Number, factors: &[(Expr, i64)]) -> (String, Binding) {
    let sign = if coefficient.is_negative() { "-" } else { "" };
    let size = coefficient.abs();
    let power = |base: Expr, exponent: i64| match exponent.unsigned_abs() {
        1 => bound(graph, base, Binding::Power),
        exponent => format!("{}^{exponent}", atom(graph, base)),
    };
    let mut above: Vec<String> = Vec::new();
    if !size.is_one() {
        above.push(number_factor(&size));
    }
    above.extend(factors.iter().filter(|(_, e)| *e > 0).map(|(base, e)| power(*base, *e)));
    let below: Vec<String> = factors.iter().filter(|(_, e)| *e < 0).map(|(base, e)| power(*base, *e)).collect();
    let above = if above.is_empty() { "1".to_owned() } else { above.join("*") };
    let text = match below.as_slice() {
        [] => format!("{sign}{above}"),
        [one] => format!("{sign}{above}/{one}"),
        _ => format!("{sign}{above}/({})", below.join("*")),
    };
    let single = sign.is_empty() && size.is_one() && factors.len() == 1 && factors[0].1 > 0;
    let binding = match (sign.is_empty(), single) {
        (false, _) => Binding::Sum,
        (true, true) => Binding::Power,
        (true, false) => Binding::Product,
    };
    (text, binding)
}
