//! LaTeX: display formulas for `amsmath`.

use super::greek;
use super::layout::{Layout, Operator};

/// The names of functions that LaTeX knows.
const FUNCTIONS: [&str; 10] = ["sin", "cos", "tan", "arcsin", "arccos", "arctan", "sinh", "cosh", "tanh", "ln"];

/// Lines with their left side, aligned at the sign between them; a continued one has no left side.
pub(super) fn lines(lines: &[(Option<Layout>, Layout)]) -> String {
    let rows: Vec<String> = lines
        .iter()
        .map(|(left, right)| match left {
            Some(left) => format!("  {} &= {}", text(left), text(right)),
            None => format!("  &\\quad {}", text(right).trim_start()),
        })
        .collect();
    format!("\\begin{{align*}}\n{}\n\\end{{align*}}\n", rows.join(" \\\\\n"))
}

fn text(layout: &Layout) -> String {
    match layout {
        Layout::Row(parts) => parts.iter().map(text).collect(),
        Layout::Number(digits) => digits.clone(),
        Layout::Word(word, bold) => set_word(word, *bold),
        Layout::Function(name) if FUNCTIONS.contains(name) => format!("\\{name}"),
        Layout::Function(name) => format!("\\operatorname{{{name}}}"),
        Layout::Operator(operator) => sign(*operator).into(),
        Layout::Fraction(above, below) => format!("\\frac{{{}}}{{{}}}", text(above), text(below)),
        Layout::Superscript(base, exponent) => format!("{}^{{{}}}", text(base), text(exponent)),
        Layout::Subscript(base, indices) => {
            format!("{}_{{{}}}", text(base), indices.iter().map(text).collect::<Vec<_>>().join(","))
        }
        Layout::Root(radicand, None) => format!("\\sqrt{{{}}}", text(radicand)),
        Layout::Root(radicand, Some(degree)) => format!("\\sqrt[{degree}]{{{}}}", text(radicand)),
        Layout::Dots(base, dots) => format!("\\{}ot{{{}}}", "d".repeat(*dots), text(base)),
        Layout::Parentheses(inner) => format!("\\left({}\\right)", text(inner)),
        Layout::Bars(inner) => format!("\\left|{}\\right|", text(inner)),
        Layout::Cases(rows) => {
            let row = |(value, case): &(Layout, Layout)| format!("{} & {}", text(value), text(case));
            format!("\\begin{{cases}} {} \\end{{cases}}", rows.iter().map(row).collect::<Vec<_>>().join(" \\\\ "))
        }
        Layout::Text(words) => format!("\\text{{{words}}}"),
        Layout::Matrix(rows) => matrix(rows),
    }
}

fn matrix(rows: &[Vec<Layout>]) -> String {
    let columns = "c".repeat(rows.first().map_or(0, Vec::len));
    let row = |row: &Vec<Layout>| row.iter().map(text).collect::<Vec<_>>().join(" & ");
    let rows = rows.iter().map(row).collect::<Vec<_>>().join(" \\\\ ");
    format!("\\left(\\begin{{array}}{{{columns}}} {rows} \\end{{array}}\\right)")
}

fn sign(operator: Operator) -> &'static str {
    match operator {
        Operator::Plus => " + ",
        Operator::Minus => " - ",
        Operator::Greater => " > ",
        Operator::Negative => "-",
        Operator::Times => " \\, ",
        Operator::Dot => " \\cdot ",
        Operator::Comma => ", ",
        Operator::Apply => " ",
        Operator::Transpose => "\\top",
        Operator::Prime => "\\prime ",
    }
}

fn set_word(word: &str, bold: bool) -> String {
    let mut letters = word.chars();
    let single = letters.next().filter(|_| letters.next().is_none());
    let greek = single.and_then(greek::name).or_else(|| greek::letter(word).map(|_| word));
    match (greek, single) {
        (Some(name), _) if bold => format!("\\boldsymbol{{\\{name}}}"),
        (Some(name), _) => format!("\\{name}"),
        (None, _) if bold => format!("\\mathbf{{{}}}", escaped(word)),
        (None, Some(letter)) if letter.is_ascii() => letter.to_string(),
        (None, _) => format!("\\mathrm{{{}}}", escaped(word)),
    }
}

fn escaped(word: &str) -> String {
    word.replace('_', "\\_")
}
