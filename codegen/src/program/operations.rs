//! Counting the operations of a kernel.

use super::{Results, Statement, Tree};
use std::fmt;

/// The number of operations of each kind in a kernel.
#[derive(Clone, Copy, PartialEq, Eq, Debug, Default)]
pub struct Operations {
    /// Additions, subtractions and changes of sign.
    pub additions: usize,
    /// Multiplications.
    pub multiplications: usize,
    /// Divisions.
    pub divisions: usize,
    /// Sines and cosines of one argument, counted once for both.
    pub sine_cosines: usize,
    /// Tables looked up, with all derivatives that are needed.
    pub table_look_ups: usize,
    /// Square roots.
    pub square_roots: usize,
    /// Other functions.
    pub other_functions: usize,
}

impl Operations {
    pub(super) fn of(statements: &[Statement], results: &Results<Tree>) -> Operations {
        let mut operations = Operations::default();
        for statement in statements {
            match statement {
                Statement::Let { value, .. } => operations.count(value),
                Statement::SinCos(waves) => {
                    waves.iter().for_each(|wave| operations.count(&wave.argument));
                    operations.sine_cosines += waves.len();
                }
                Statement::Table(look_up) => {
                    operations.count(&look_up.argument);
                    operations.table_look_ups += 1;
                }
                Statement::Columns(columns) => {
                    columns.operands().for_each(|tree| operations.count(tree));
                    let counted = columns.shape.operations();
                    operations.additions += counted - columns.shape.steps.len() * columns.shape.columns;
                    operations.multiplications += counted;
                }
            }
        }
        results.entries().into_iter().for_each(|tree| operations.count(tree));
        operations
    }

    /// All of them.
    pub fn total(&self) -> usize {
        self.additions
            + self.multiplications
            + self.divisions
            + self.sine_cosines
            + self.table_look_ups
            + self.square_roots
            + self.other_functions
    }

    fn count(&mut self, tree: &Tree) {
        match tree {
            Tree::Constant(_) | Tree::Name(_) | Tree::Field(_) => {}
            Tree::Sum(terms) => {
                self.additions += terms.len() - 1;
                terms.iter().for_each(|(_, term)| self.count(term));
            }
            Tree::Product(factors) => {
                self.multiplications += factors.len() - 1;
                factors.iter().for_each(|factor| self.count(factor));
            }
            Tree::Quotient(above, below) => {
                self.divisions += 1;
                self.count(above);
                self.count(below);
            }
            Tree::Negate(operand) => {
                self.additions += 1;
                self.count(operand);
            }
            Tree::Method(name, arguments) => {
                match *name {
                    "sqrt" => self.square_roots += 1,
                    "abs" | "sign" | "choose" => self.additions += 1,
                    // A choice that is the same at every step.
                    "or" => {}
                    _ => self.other_functions += 1,
                }
                arguments.iter().for_each(|argument| self.count(argument));
            }
        }
    }
}

impl fmt::Display for Operations {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        let parts = [
            (self.additions, "addition"),
            (self.multiplications, "multiplication"),
            (self.divisions, "division"),
            (self.sine_cosines, "sine-cosine pair"),
            (self.table_look_ups, "table look-up"),
            (self.square_roots, "square root"),
            (self.other_functions, "other function"),
        ];
        let counted = |(n, what): &(usize, &str)| format!("{n} {what}{}", if *n == 1 { "" } else { "s" });
        let parts: Vec<_> = parts.iter().filter(|(n, _)| *n > 0).map(counted).collect();
        if parts.is_empty() { write!(f, "none") } else { write!(f, "{}", parts.join(", ")) }
    }
}
