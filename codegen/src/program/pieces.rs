//! Long programs split into functions that rustc can compile in a few seconds: its time grows faster than the square of
//! a function's length.
//!
//! Each piece hands on the values that later ones need. That costs a third of such a kernel's time, so pieces are as
//! long as compile times allow.

use super::{Name, Results, Statement, Tree};
use std::collections::BTreeSet;

/// The longest function that is made.
const MOST_STATEMENTS: usize = 2200;

/// A part of a program, which runs before the rest and hands on what is still needed.
pub struct Piece {
    /// The values that earlier pieces have handed on.
    pub given: Vec<Name>,
    /// The statements, in order.
    pub statements: Vec<Statement>,
    /// The values that later pieces need.
    pub handed_on: Vec<Name>,
}

/// Splits a program into pieces and the rest of it.
pub(super) fn split(mut statements: Vec<Statement>, results: &Results<Tree>) -> (Vec<Piece>, Vec<Statement>) {
    let count = statements.len().div_ceil(MOST_STATEMENTS).max(1);
    let length = statements.len().div_ceil(count);
    let mut pieces = Vec::new();
    let mut given: Vec<Name> = Vec::new();
    while statements.len() > length {
        let rest = statements.split_off(length);
        let needed = names_needed(&rest, results);
        let defined = statements.iter().flat_map(Statement::gives);
        let known: BTreeSet<&Name> = given.iter().chain(defined).collect();
        let handed_on: Vec<Name> = known.into_iter().filter(|name| needed.contains(*name)).cloned().collect();
        pieces.push(Piece { given, statements, handed_on: handed_on.clone() });
        (given, statements) = (handed_on, rest);
    }
    (pieces, statements)
}

fn names_needed(statements: &[Statement], results: &Results<Tree>) -> BTreeSet<Name> {
    let mut names = BTreeSet::new();
    let mut need = |name: &Name| {
        names.insert(name.clone());
    };
    statements.iter().for_each(|statement| statement.needs(&mut need));
    results.entries().into_iter().for_each(|tree| tree.needs(&mut need));
    names
}

#[cfg(test)]
mod tests {
    use super::*;

    /// Each statement needs the one before and one long before.
    fn program(length: usize) -> Vec<Statement> {
        let name = |i: usize| Tree::Name(format!("x{i}").into());
        let value = |i: usize| Tree::Sum(vec![(false, name(i.saturating_sub(1))), (true, name(i / 3))]);
        (1..=length).map(|i| Statement::Let { name: format!("x{i}").into(), value: value(i) }).collect()
    }

    #[test]
    fn every_piece_is_given_what_it_needs_and_no_more() {
        let length = 3 * MOST_STATEMENTS + 7;
        let results = Results::Scalar(Tree::Name("x5".into()));
        let (pieces, rest) = split(program(length), &results);
        assert_eq!(pieces.len(), 3);
        let mut given = BTreeSet::from([Name::from("x0")]);
        let mut count = 0;
        for piece in &pieces {
            assert!(piece.statements.len() <= MOST_STATEMENTS);
            assert!(piece.given.iter().all(|name| given.contains(name)));
            let mut known: BTreeSet<Name> = piece.given.iter().cloned().chain(["x0".into()]).collect();
            for statement in &piece.statements {
                let needed = names_needed(std::slice::from_ref(statement), &Results::Vector(vec![]));
                assert!(needed.is_subset(&known));
                known.extend(statement.gives().into_iter().cloned());
                count += 1;
            }
            assert!(piece.handed_on.iter().all(|name| known.contains(name)));
            given = piece.handed_on.iter().cloned().chain(["x0".into()]).collect();
        }
        let needed = names_needed(&rest, &results);
        let defined: BTreeSet<Name> = rest.iter().flat_map(Statement::gives).cloned().collect();
        assert!(needed.iter().all(|name| given.contains(name) || defined.contains(name)));
        assert!(given.iter().all(|name| &**name == "x0" || needed.contains(name)));
        assert_eq!(count + rest.len(), length);
    }

    #[test]
    fn a_short_program_stays_whole() {
        let (pieces, rest) = split(program(MOST_STATEMENTS), &Results::Scalar(Tree::Constant(1.0)));
        assert!(pieces.is_empty());
        assert_eq!(rest.len(), MOST_STATEMENTS);
    }
}
