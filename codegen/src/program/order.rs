//! In which order a symmetric system is solved, by structure alone.

use super::eliminate::{System, Unknown};
use std::collections::BTreeSet;

/// Where a system has entries.
pub(super) struct Pattern {
    kinds: Vec<Kind>,
    /// For each unknown those that it has an entry with, itself included.
    linked: Vec<BTreeSet<usize>>,
    /// In how many definitions of what is left each unknown occurs.
    occurrences: Vec<usize>,
}

/// What an unknown waits for.
#[derive(Clone)]
enum Kind {
    Coordinate,
    /// The unknowns of its definition.
    Intermediate(BTreeSet<usize>),
    /// The coordinates and intermediate quantities that it constrains.
    Multiplier(BTreeSet<usize>),
}

/// The next unknown to be solved for, with those that it has entries with at that time.
pub(super) struct Action {
    /// The unknown.
    pub(super) unknown: usize,
    /// The others, in order; for an intermediate quantity those of its definition need not be among them.
    pub(super) neighbours: Vec<usize>,
}

impl Pattern {
    pub(super) fn of(system: &System) -> Pattern {
        let mut linked = vec![BTreeSet::new(); system.unknowns.len()];
        for (i, j, _) in &system.entries {
            linked[*i].insert(*j);
            linked[*j].insert(*i);
        }
        let kind = |(k, unknown): (usize, &Unknown)| match unknown {
            Unknown::Coordinate => Kind::Coordinate,
            Unknown::Intermediate(definition) => Kind::Intermediate(definition.iter().map(|(j, _)| *j).collect()),
            Unknown::Multiplier => Kind::Multiplier(linked[k].clone()),
        };
        let kinds: Vec<Kind> = system.unknowns.iter().enumerate().map(kind).collect();
        let mut occurrences = vec![0; kinds.len()];
        for kind in &kinds {
            if let Kind::Intermediate(definition) = kind {
                definition.iter().for_each(|j| occurrences[*j] += 1);
            }
        }
        Pattern { kinds, linked, occurrences }
    }
}

/// Coordinates with the fewest neighbours first, as soon as no definition is left that they occur in; multipliers when
/// what they constrain is gone; intermediate quantities when nothing else can be done. `None` if an unknown is left
/// without a pivot.
pub(super) fn order(mut pattern: Pattern) -> Option<Vec<Action>> {
    let mut left: BTreeSet<usize> = (0..pattern.kinds.len()).collect();
    let mut actions = Vec::with_capacity(left.len());
    while !left.is_empty() {
        let unknown = pattern.next(&left)?;
        left.remove(&unknown);
        actions.push(Action { unknown, neighbours: pattern.remove(unknown) });
    }
    Some(actions)
}

impl Pattern {
    fn next(&self, left: &BTreeSet<usize>) -> Option<usize> {
        let has_pivot = |k: usize| match &self.kinds[k] {
            Kind::Coordinate => self.linked[k].contains(&k) && self.occurrences[k] == 0,
            Kind::Multiplier(constrained) => self.linked[k].contains(&k) && constrained.is_disjoint(left),
            Kind::Intermediate(_) => false,
        };
        let is_free = |k: usize| matches!(self.kinds[k], Kind::Intermediate(_)) && self.occurrences[k] == 0;
        let smallest = |candidates: &dyn Fn(usize) -> bool| {
            left.iter().copied().filter(|k| candidates(*k)).min_by_key(|k| (self.linked[*k].len(), *k))
        };
        smallest(&has_pivot).or_else(|| smallest(&is_free))
    }

    /// Removes an unknown and links those that its removal brings together; gives those it was linked with.
    fn remove(&mut self, k: usize) -> Vec<usize> {
        let mut neighbours = std::mem::take(&mut self.linked[k]);
        let had_diagonal = neighbours.remove(&k);
        neighbours.iter().for_each(|i| {
            self.linked[*i].remove(&k);
        });
        if let Kind::Intermediate(definition) = self.kinds[k].clone() {
            definition.iter().for_each(|j| self.occurrences[*j] -= 1);
            for i in neighbours.iter().copied().chain(definition.iter().copied().filter(|_| had_diagonal)) {
                definition.iter().for_each(|j| self.link(i, *j));
            }
            for kind in &mut self.kinds {
                if let Kind::Multiplier(constrained) = kind
                    && constrained.remove(&k)
                {
                    constrained.extend(&definition);
                }
            }
        } else {
            for i in &neighbours {
                neighbours.iter().for_each(|j| self.link(*i, *j));
            }
        }
        neighbours.into_iter().collect()
    }

    fn link(&mut self, i: usize, j: usize) {
        self.linked[i].insert(j);
        self.linked[j].insert(i);
    }
}
