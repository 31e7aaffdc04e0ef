//! Equations as lines: long sums are broken between terms.

use super::equation_groups::{Block, Equation};
use super::formula::Formula;
use super::infix;
use super::layout::{self, Layout, layout};
use super::sharing::LINE;
use super::width::{set_width, text_width};

/// Equations set in two dimensions: left side and right side, or more of a right side.
pub(super) fn set(equations: &[Equation]) -> Vec<(Option<Layout>, Layout)> {
    let mut lines = Vec::new();
    for equation in equations {
        let mut left = Some(Layout::Row(equation.left.iter().map(set_block).collect()));
        match &equation.right {
            Block::Formula(Formula::Sum(terms)) => {
                for (at, line) in broken(terms, set_width).into_iter().enumerate() {
                    lines.push((left.take(), layout::sum(line, at == 0)));
                }
            }
            right => lines.push((left, set_block(right))),
        }
    }
    lines
}

fn set_block(block: &Block) -> Layout {
    match block {
        Block::Formula(formula) => layout(formula),
        Block::Matrix(rows) => Layout::Matrix(rows.iter().map(|row| row.iter().map(layout).collect()).collect()),
    }
}

/// Equations as text.
pub(super) fn text(equations: &[Equation]) -> String {
    equations.iter().map(text_equation).collect()
}

fn text_equation(equation: &Equation) -> String {
    let left = equation.left.iter().map(text_block).collect::<Vec<_>>().join(" * ");
    let right = match &equation.right {
        Block::Formula(Formula::Sum(terms)) => {
            let lines = broken(terms, text_width).into_iter().enumerate();
            lines.map(|(at, line)| infix::sum(line, at == 0)).collect::<Vec<_>>().join("\n    ")
        }
        right => text_block(right),
    };
    format!("{left} = {right}\n")
}

/// A matrix with commas between entries and semicolons between rows; on lines of its own if it is long.
fn text_block(block: &Block) -> String {
    let rows = match block {
        Block::Formula(formula) => return infix::text(formula),
        Block::Matrix(rows) => rows,
    };
    let rows: Vec<String> = rows.iter().map(|row| row.iter().map(infix::text).collect::<Vec<_>>().join(", ")).collect();
    let line = rows.join("; ");
    match line.chars().count() <= LINE / 2 {
        true => format!("[{line}]"),
        false => format!("[\n    {}\n]", rows.join(";\n    ")),
    }
}

/// Terms in groups that fit on a line each, as far as terms do.
fn broken(terms: &[(bool, Formula)], width: fn(&Formula) -> usize) -> Vec<&[(bool, Formula)]> {
    let mut lines = Vec::new();
    let (mut start, mut length) = (0, 0);
    for (at, (_, term)) in terms.iter().enumerate() {
        let needed = width(term) + 3;
        if at > start && length + needed > LINE {
            lines.push(&terms[start..at]);
            (start, length) = (at, 0);
        }
        length += needed;
    }
    lines.push(&terms[start..]);
    lines
}
