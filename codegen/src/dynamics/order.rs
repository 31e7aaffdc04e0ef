//! The order in which the equations of motion are solved, chosen by structure alone.
//!
//! Coordinates with the fewest neighbours come first, a multiplier when all of its coordinates are gone, and among
//! equals the one that waits for the fewest others. A row of linkages is thus eliminated from both ends at once, which
//! halves the chain of dependent operations. A multiplier eliminated earlier could meet a pivot that vanishes at some
//! position; late multipliers also keep rounding small where masses are small. Where loops are turned (`turns`), a
//! multiplier whose pivot depends on parameters alone may come early.
//!
//! A pivot is refused at run time if cancellation has taken half of its digits. The runtime then solves that state by
//! complete pivoting. Where no order exists, as for a coordinate without inertia, every state is solved that way.
//!
//! Each step comes just before the step that needs it: two independent chains of operations then lie within the
//! processor's reach, and run in parallel.

use rustc_hash::FxHashSet;
use std::collections::BTreeSet;

/// The sparsity pattern of a symmetric system.
pub struct Pattern {
    kinds: Vec<Kind>,
    /// For each unknown, those that share an entry with it, itself included.
    linked: Vec<BTreeSet<usize>>,
    /// The entries that depend on more than parameters, the smaller index first.
    moving: FxHashSet<(usize, usize)>,
    /// The number of remaining definitions in which each unknown occurs.
    occurrences: Vec<usize>,
    /// The length of the longest chain of steps before each unknown.
    levels: Vec<usize>,
}

/// A kind of unknown.
#[derive(Clone)]
pub enum Kind {
    /// The acceleration of a coordinate.
    Coordinate,
    /// The acceleration of an intermediate quantity, with the unknowns that it is defined by.
    Intermediate(Vec<usize>),
    /// A multiplier.
    Multiplier,
}

impl Kind {
    /// The unknowns that an intermediate quantity is defined by.
    fn definition(&self) -> &[usize] {
        match self {
            Kind::Intermediate(definition) => definition,
            Kind::Coordinate | Kind::Multiplier => &[],
        }
    }
}

/// The next unknown to be solved for, with those that share entries with it at that time.
pub struct Action {
    /// The unknown.
    pub unknown: usize,
    /// The others, in order; for an intermediate quantity those of its definition need not be among them.
    pub neighbours: Vec<usize>,
}

/// An entry of a system.
#[derive(Clone, Copy, PartialEq, Eq, PartialOrd, Ord)]
pub struct Entry {
    /// Its row and column.
    pub place: (usize, usize),
    /// Whether it depends on more than parameters.
    pub is_moving: bool,
}

/// When multipliers are eliminated.
#[derive(Clone, Copy, PartialEq, Eq)]
pub enum Multipliers {
    /// After all coordinates, each when what it constrains is gone.
    Last,
    /// When what they constrain is gone, or as soon as they have a pivot that depends on parameters alone; before
    /// coordinates with as many neighbours.
    ///
    /// A multiplier's pivot is the sum of what its coordinates have left there, all of one sign: if it exists and
    /// depends on parameters alone, it is zero at no position.
    Soon,
}

impl Pattern {
    /// The pattern of a system with these unknowns and entries.
    pub fn new(kinds: Vec<Kind>, entries: impl IntoIterator<Item = Entry>) -> Pattern {
        let mut linked = vec![BTreeSet::new(); kinds.len()];
        let mut moving = FxHashSet::default();
        for Entry { place: (i, j), is_moving } in entries {
            linked[i].insert(j);
            linked[j].insert(i);
            if is_moving {
                moving.insert(in_order(i, j));
            }
        }
        let mut occurrences = vec![0; kinds.len()];
        for kind in &kinds {
            if let Kind::Intermediate(definition) = kind {
                definition.iter().for_each(|j| occurrences[*j] += 1);
            }
        }
        let levels = vec![0; kinds.len()];
        Pattern { kinds, linked, moving, occurrences, levels }
    }
}

/// Coordinates with the fewest neighbours first, as soon as they occur in no remaining definition; intermediate
/// quantities, the last defined first, when nothing else can be done. `None` if an unknown is left without a pivot.
pub fn order(mut pattern: Pattern, multipliers: Multipliers) -> Option<Vec<Action>> {
    let mut left: BTreeSet<usize> = (0..pattern.kinds.len()).collect();
    // What each multiplier constrains, without the links added by elimination.
    let mut constrained = pattern.linked.clone();
    constrained.iter_mut().enumerate().for_each(|(k, links)| {
        links.remove(&k);
    });
    let mut actions = Vec::with_capacity(left.len());
    while !left.is_empty() {
        let unknown = pattern.next(&left, &constrained, multipliers)?;
        left.remove(&unknown);
        if let Kind::Intermediate(definition) = &pattern.kinds[unknown] {
            for links in &mut constrained {
                if links.remove(&unknown) {
                    links.extend(definition);
                }
            }
        }
        actions.push(Action { unknown, neighbours: pattern.remove(unknown) });
    }
    Some(as_late_as_possible(actions, &pattern))
}

/// Each step just before what needs it, so that steps that do not need each other lie side by side.
fn as_late_as_possible(actions: Vec<Action>, pattern: &Pattern) -> Vec<Action> {
    let last = pattern.levels.iter().copied().max().unwrap_or(0);
    let mut levels = vec![last; pattern.kinds.len()];
    for Action { unknown, neighbours } in actions.iter().rev() {
        let definition = pattern.kinds[*unknown].definition();
        for needing in neighbours.iter().chain(definition) {
            levels[*unknown] = levels[*unknown].min(levels[*needing].saturating_sub(1));
        }
    }
    let mut actions = actions;
    actions.sort_by_key(|action| levels[action.unknown]);
    actions
}

/// Only the intermediate quantities, the last defined first.
pub fn substitutions(mut pattern: Pattern) -> Vec<Action> {
    let intermediates = (0..pattern.kinds.len()).rev().filter(|k| matches!(pattern.kinds[*k], Kind::Intermediate(_)));
    let intermediates: Vec<usize> = intermediates.collect();
    intermediates.into_iter().map(|unknown| Action { unknown, neighbours: pattern.remove(unknown) }).collect()
}

/// The approximate number of multiplications of a solution in the given order.
pub fn cost(pattern_kinds: &[Kind], actions: &[Action]) -> usize {
    let each = actions.iter().map(|Action { unknown, neighbours }| match &pattern_kinds[*unknown] {
        Kind::Intermediate(definition) => definition.len() * (neighbours.len() + definition.len() + 2),
        _ => neighbours.len() * (neighbours.len() + 5) / 2 + 1,
    });
    each.sum()
}

impl Pattern {
    fn next(&self, left: &BTreeSet<usize>, constrained: &[BTreeSet<usize>], multipliers: Multipliers) -> Option<usize> {
        let has_pivot = |k: usize| match &self.kinds[k] {
            Kind::Coordinate => self.linked[k].contains(&k) && self.occurrences[k] == 0,
            Kind::Multiplier => {
                let has_fixed_pivot = multipliers == Multipliers::Soon && !self.is_moving(k, k);
                self.linked[k].contains(&k) && (has_fixed_pivot || constrained[k].is_disjoint(left))
            }
            Kind::Intermediate(_) => false,
        };
        let is_free = |k: usize| matches!(self.kinds[k], Kind::Intermediate(_)) && self.occurrences[k] == 0;
        let is_multiplier = |k: usize| matches!(self.kinds[k], Kind::Multiplier);
        let rank = |k: &usize| {
            let (neighbours, level) = (self.linked[*k].len(), self.levels[*k]);
            match multipliers {
                Multipliers::Last => (is_multiplier(*k), neighbours, false, level, *k),
                Multipliers::Soon => (false, neighbours, !is_multiplier(*k), level, *k),
            }
        };
        let ready = left.iter().copied().filter(|k| has_pivot(*k)).min_by_key(rank);
        // The last defined lies farthest out: from there elimination works its way in.
        ready.or_else(|| left.iter().rev().copied().find(|k| is_free(*k)))
    }

    fn is_moving(&self, i: usize, j: usize) -> bool {
        self.moving.contains(&in_order(i, j))
    }

    /// Removes an unknown and links those that its removal brings together; gives those it was linked with.
    fn remove(&mut self, k: usize) -> Vec<usize> {
        let mut neighbours = std::mem::take(&mut self.linked[k]);
        let had_diagonal = neighbours.remove(&k);
        let level = self.levels[k] + 1;
        for needing in neighbours.iter().chain(self.kinds[k].definition()) {
            self.levels[*needing] = self.levels[*needing].max(level);
        }
        neighbours.iter().for_each(|i| {
            self.linked[*i].remove(&k);
        });
        if let Kind::Intermediate(definition) = self.kinds[k].clone() {
            definition.iter().for_each(|j| self.occurrences[*j] -= 1);
            for i in neighbours.iter().copied().chain(definition.iter().copied().filter(|_| had_diagonal)) {
                definition.iter().for_each(|j| self.link(i, *j, true));
            }
        } else {
            let pivot_moves = self.is_moving(k, k);
            let moves: Vec<bool> = neighbours.iter().map(|i| pivot_moves || self.is_moving(*i, k)).collect();
            for (at, (i, i_moves)) in neighbours.iter().zip(&moves).enumerate() {
                for (j, j_moves) in neighbours.iter().zip(&moves).take(at + 1) {
                    self.link(*i, *j, *i_moves || *j_moves);
                }
            }
        }
        neighbours.into_iter().collect()
    }

    fn link(&mut self, i: usize, j: usize, is_moving: bool) {
        self.linked[i].insert(j);
        self.linked[j].insert(i);
        if is_moving {
            self.moving.insert(in_order(i, j));
        }
    }
}

fn in_order(i: usize, j: usize) -> (usize, usize) {
    (i.min(j), i.max(j))
}

#[cfg(test)]
mod tests {
    use super::*;

    /// Coordinates in a row, each with an entry with the next.
    fn row(length: usize) -> Pattern {
        let diagonal = (0..length).map(|k| (k, k));
        let beside = (1..length).map(|k| (k, k - 1));
        Pattern::new(vec![Kind::Coordinate; length], diagonal.chain(beside).map(moving))
    }

    /// Coordinates in a row, each pair of neighbours held by a multiplier.
    fn held_row(length: usize) -> Pattern {
        let mut kinds = vec![Kind::Coordinate; length];
        kinds.extend(vec![Kind::Multiplier; length - 1]);
        let diagonal = (0..length).map(|k| (k, k));
        let held = (1..length).flat_map(|k| [(length + k - 1, k - 1), (length + k - 1, k)]);
        Pattern::new(kinds, diagonal.chain(held).map(moving))
    }

    fn moving(place: (usize, usize)) -> Entry {
        Entry { place, is_moving: true }
    }

    fn fixed(place: (usize, usize)) -> Entry {
        Entry { place, is_moving: false }
    }

    /// The length of the longest chain of steps.
    fn longest_wait(actions: &[Action], unknowns: usize) -> usize {
        let mut waits = vec![1; unknowns];
        for Action { unknown, neighbours } in actions {
            for needing in neighbours {
                waits[*needing] = waits[*needing].max(waits[*unknown] + 1);
            }
        }
        waits.into_iter().max().unwrap_or(0)
    }

    #[test]
    fn a_row_is_eliminated_from_both_ends() {
        for length in [2, 5, 20, 41] {
            let actions = order(row(length), Multipliers::Last).unwrap();
            assert!(actions.iter().all(|action| action.neighbours.len() <= 1), "fill-in of {length}");
            assert_eq!(longest_wait(&actions, length), length / 2 + 1, "{length}");
            let actions = order(held_row(length), Multipliers::Last).unwrap();
            // The coordinates side by side, then the multipliers as a row of their own.
            assert_eq!(longest_wait(&actions, 2 * length - 1), (length - 1) / 2 + 2, "{length}");
        }
    }

    #[test]
    fn every_step_comes_before_what_needs_it_and_not_long_before() {
        let actions = order(held_row(30), Multipliers::Last).unwrap();
        let place = |unknown: usize| actions.iter().position(|action| action.unknown == unknown).unwrap();
        for action in &actions {
            let first = action.neighbours.iter().map(|needing| place(*needing)).min();
            let own = place(action.unknown);
            assert!(first.is_none_or(|first| own < first && first - own <= 8), "{}: {own} {first:?}", action.unknown);
        }
    }

    /// Three coordinates held by one multiplier, the first with a coefficient that is as given, the others with an entry.
    fn held_by_one(first: fn((usize, usize)) -> Entry) -> Pattern {
        let mut kinds = vec![Kind::Coordinate; 3];
        kinds.push(Kind::Multiplier);
        let others = [(1, 1), (2, 2), (2, 1), (3, 1), (3, 2)].map(moving);
        let entries = [fixed((0, 0)), first((3, 0))].into_iter().chain(others);
        Pattern::new(kinds, entries)
    }

    #[test]
    fn a_multiplier_is_eliminated_early_only_with_a_pivot_of_parameters() {
        let unknowns = |pattern: Pattern, multipliers: Multipliers| -> Vec<usize> {
            order(pattern, multipliers).unwrap().iter().map(|action| action.unknown).collect()
        };
        let is_before = |unknowns: &[usize], a: usize, b: usize| {
            unknowns.iter().position(|k| *k == a) < unknowns.iter().position(|k| *k == b)
        };
        let fixed_soon = unknowns(held_by_one(fixed), Multipliers::Soon);
        assert!(is_before(&fixed_soon, 0, 3) && is_before(&fixed_soon, 3, 1) && is_before(&fixed_soon, 3, 2));
        assert_eq!(unknowns(held_by_one(fixed), Multipliers::Last).last(), Some(&3));
        assert_eq!(unknowns(held_by_one(moving), Multipliers::Soon).last(), Some(&3));
    }
}
