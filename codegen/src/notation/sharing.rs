//! Which expressions get a name: the user's if the expression is a `let`, and a generated one if it would otherwise be
//! repeated, or be too wide for a line.

use super::names::Names;
use super::translate::Translation;
use super::width::set_width;
use crate::dynamics::EquationsOfMotion;
use crate::model::Model;
use crate::symbolic::{Expr, Graph};

/// The width of a line.
pub(super) const LINE: usize = 90;
/// The width allowed inside another expression.
const WIDEST_INSIDE: usize = 60;
/// The width from which repeated expressions get a name.
const WORTH_A_NAME: usize = 24;

/// The names of everything that is made of `roots`, and the expressions that they define, operands first.
pub(super) fn names(equations: &EquationsOfMotion, roots: &[Expr]) -> (Names, Vec<Expr>) {
    let EquationsOfMotion { model, graph, .. } = equations;
    let mut names = symbols(model, graph);
    let used = graph.reachable(roots);
    let mut defined = Vec::new();
    for (name, expr) in &model.named {
        if !is_leaf(graph, *expr) && used.binary_search(expr).is_ok() && names.of(*expr).is_none() {
            names.name_expression(*expr, name);
            defined.push(*expr);
        }
    }
    let uses = uses(graph, &used, roots);
    let prefix = free_prefix(model, graph);
    let mut count = 0;
    for expr in used.into_iter().filter(|expr| !is_leaf(graph, *expr)) {
        if names.of(expr).is_some() {
            continue;
        }
        let width = set_width(&Translation { graph, names: &names }.definition(expr));
        let Uses { operands, is_root } = uses[expr.index()];
        let shared = width >= WORTH_A_NAME && operands + usize::from(is_root) > 1;
        let too_wide = width > WIDEST_INSIDE && operands > 0;
        if shared || too_wide {
            count += 1;
            names.name_expression(expr, &format!("{prefix}_{count}"));
            defined.push(expr);
        }
    }
    defined.sort();
    (names, defined)
}

/// The symbols of a model, each with its dots.
fn symbols(model: &Model, graph: &Graph) -> Names {
    let mut names = Names::default();
    let mut name = |symbol, word: &str, dots| {
        names.name_symbol(symbol, graph.symbol_name(symbol), word, dots);
    };
    name(model.time, "t", 0);
    for c in &model.coordinates {
        name(c.position, &c.name, 0);
        name(c.speed, &c.name, 1);
        name(c.acceleration, &c.name, 2);
    }
    model.parameters.iter().for_each(|p| name(p.symbol, &p.name, 0));
    model.inputs.iter().for_each(|input| name(input.symbol, &input.name, 0));
    model.constraints.iter().for_each(|c| name(c.multiplier, &format!("lambda_{}", c.name), 0));
    graph.tables().iter().for_each(|table| names.name_table(&table.name));
    names
}

fn is_leaf(graph: &Graph, expr: Expr) -> bool {
    graph.operands(expr).next().is_none()
}

/// Where an expression occurs.
#[derive(Clone, Copy, Default)]
struct Uses {
    /// In how many others.
    operands: usize,
    is_root: bool,
}

fn uses(graph: &Graph, used: &[Expr], roots: &[Expr]) -> Vec<Uses> {
    let mut uses = vec![Uses::default(); graph.len()];
    for expr in used {
        graph.operands(*expr).for_each(|operand| uses[operand.index()].operands += 1);
    }
    roots.iter().for_each(|root| uses[root.index()].is_root = true);
    uses
}

/// A letter that no name of the declaration starts with before an underscore.
fn free_prefix(model: &Model, graph: &Graph) -> String {
    let words = model.coordinates.iter().map(|c| &c.name);
    let words = words.chain(model.parameters.iter().map(|p| &p.name));
    let words =
        words.chain(model.inputs.iter().map(|input| &input.name)).chain(model.named.iter().map(|(name, _)| name));
    let words: Vec<&String> = words.chain(graph.tables().iter().map(|table| &table.name)).collect();
    let mut prefix = String::from("s");
    while words.iter().any(|word| word.split('_').next() == Some(&prefix)) {
        prefix.push('s');
    }
    prefix
}
