//! Statements reordered so that fewer values are alive at a time.
//!
//! Long kernels have more values than a processor has registers, and the rest goes through memory. A statement that is
//! the last use of some value therefore comes as early as it can: from then on its own value is kept instead. This
//! helps kernels that just outgrow the instruction cache.

use super::{Name, Results, Statement, Tree};
use rustc_hash::FxHashMap;

/// The number of values that registers hold, on most processors.
const REGISTERS: usize = 16;

/// The same statements, with those that end a value's life moved to the first place where they can be computed.
pub(super) fn shorten_lifetimes(statements: Vec<Statement>, results: &Results<Tree>) -> Vec<Statement> {
    if statements.len() <= REGISTERS {
        return statements;
    }
    let order = Lifetimes::new(&statements, results).order();
    let mut statements: Vec<Option<Statement>> = statements.into_iter().map(Some).collect();
    order.into_iter().filter_map(|at| statements[at].take()).collect()
}

/// Statements by number.
struct Lifetimes {
    /// The statements that each needs, once each.
    needed: Vec<Vec<usize>>,
    /// The statements that need each.
    users: Vec<Vec<usize>>,
    /// The number of remaining uses, results included.
    uses_left: Vec<usize>,
    /// Whether a register may hold what a statement gives: sines and tables come in arrays.
    is_in_register: Vec<bool>,
    is_placed: Vec<bool>,
}

impl Lifetimes {
    fn new(statements: &[Statement], results: &Results<Tree>) -> Lifetimes {
        let giving = statements.iter().map(Statement::gives).enumerate();
        let giving: FxHashMap<&Name, usize> =
            giving.flat_map(|(at, names)| names.into_iter().map(move |name| (name, at))).collect();
        let needed = statements.iter().map(|each| {
            let mut needed = Vec::new();
            each.needs(&mut |name| needed.extend(giving.get(name)));
            sorted(needed)
        });
        let needed: Vec<Vec<usize>> = needed.collect();
        let mut users = vec![vec![]; statements.len()];
        for (at, needed) in needed.iter().enumerate() {
            needed.iter().for_each(|giver| users[*giver].push(at));
        }
        let mut uses_left: Vec<usize> = users.iter().map(Vec::len).collect();
        let mut of_results = Vec::new();
        results.entries().into_iter().for_each(|tree| tree.needs(&mut |name| of_results.extend(giving.get(name))));
        sorted(of_results).into_iter().for_each(|giver| uses_left[giver] += 1);
        let is_in_register = statements.iter().map(|each| matches!(each, Statement::Let { .. })).collect();
        Lifetimes { needed, users, uses_left, is_in_register, is_placed: vec![false; statements.len()] }
    }

    fn order(mut self) -> Vec<usize> {
        let mut order = Vec::with_capacity(self.needed.len());
        for next in 0..self.needed.len() {
            // After each statement, those that it makes possible, in their original order.
            let mut stack = vec![next];
            while let Some(at) = stack.pop() {
                if self.is_placed[at] || !self.is_possible(at) || (at != next && !self.lets_go(at)) {
                    continue;
                }
                self.is_placed[at] = true;
                order.push(at);
                self.needed[at].iter().for_each(|giver| self.uses_left[*giver] -= 1);
                let concerned = stack.len();
                self.push_concerned(at, &mut stack);
                stack[concerned..].sort_unstable_by(|a, b| b.cmp(a));
            }
        }
        order
    }

    /// Statements that may have become possible, or the last use of a value, after a statement was placed.
    fn push_concerned(&self, placed: usize, stack: &mut Vec<usize>) {
        let nearly_done = self.needed[placed].iter().filter(|giver| self.uses_left[**giver] == 1);
        let givers = nearly_done.chain([&placed]);
        stack.extend(givers.flat_map(|giver| &self.users[*giver]).filter(|user| !self.is_placed[**user]));
    }

    fn is_possible(&self, at: usize) -> bool {
        self.needed[at].iter().all(|giver| self.is_placed[*giver])
    }

    /// Whether it is the last to use a value that a register may hold.
    fn lets_go(&self, at: usize) -> bool {
        self.needed[at].iter().any(|giver| self.is_in_register[*giver] && self.uses_left[*giver] == 1)
    }
}

/// In order, each once.
fn sorted(mut numbers: Vec<usize>) -> Vec<usize> {
    numbers.sort_unstable();
    numbers.dedup();
    numbers
}

#[cfg(test)]
mod tests {
    use super::*;
    use std::collections::BTreeSet;

    /// `length` terms, all made first, then added up one after the other.
    fn terms_then_sums(length: usize) -> Vec<Statement> {
        let name = |letter: &str, i: usize| -> Name { format!("{letter}{i}").into() };
        let terms = (0..length).map(|i| Statement::Let { name: name("x", i), value: Tree::Constant(1.0) });
        let sums = (0..length).map(|i| {
            let before = if i == 0 { Tree::Constant(0.0) } else { Tree::Name(name("s", i - 1)) };
            let value = Tree::Sum(vec![(false, before), (false, Tree::Name(name("x", i)))]);
            Statement::Let { name: name("s", i), value }
        });
        terms.chain(sums).collect()
    }

    /// The largest number of values that are kept at a time.
    fn most_kept(statements: &[Statement], results: &Results<Tree>) -> usize {
        let kept = |at: usize| {
            let mut needed: BTreeSet<&Name> = BTreeSet::new();
            let mut need = |name| {
                needed.insert(name);
            };
            statements[at + 1..].iter().for_each(|each| each.needs(&mut need));
            results.entries().into_iter().for_each(|tree| tree.needs(&mut need));
            statements[..=at].iter().flat_map(Statement::gives).filter(|name| needed.contains(name)).count()
        };
        (0..statements.len()).map(kept).max().unwrap_or(0)
    }

    #[test]
    fn what_ends_a_life_comes_as_soon_as_it_can() {
        let results = Results::Scalar(Tree::Name("s39".into()));
        assert_eq!(most_kept(&terms_then_sums(40), &results), 40);
        let shorter = shorten_lifetimes(terms_then_sums(40), &results);
        assert_eq!(shorter.len(), 80);
        assert!(most_kept(&shorter, &results) <= 2, "{}", most_kept(&shorter, &results));
    }

    #[test]
    fn every_statement_comes_once_after_what_it_needs() {
        let results = Results::Scalar(Tree::Name("s29".into()));
        let mut given = BTreeSet::new();
        for statement in shorten_lifetimes(terms_then_sums(30), &results) {
            statement.needs(&mut |name| assert!(given.contains(name), "{name}"));
            for name in statement.gives() {
                assert!(given.insert(name.clone()), "{name}");
            }
        }
        assert_eq!(given.len(), 60);
    }
}
