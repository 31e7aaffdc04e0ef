//! In which order the equations of motion are solved, by structure alone.

use std::collections::BTreeSet;

/// Where a symmetric system has entries.
pub struct Pattern {
    kinds: Vec<Kind>,
    /// For each unknown those that it has an entry with, itself included.
    linked: Vec<BTreeSet<usize>>,
    /// In how many definitions of what is left each unknown occurs.
    occurrences: Vec<usize>,
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

/// The next unknown to be solved for, with those that it has entries with at that time.
pub struct Action {
    /// The unknown.
    pub unknown: usize,
    /// The others, in order; for an intermediate quantity those of its definition need not be among them.
    pub neighbours: Vec<usize>,
}

impl Pattern {
    /// The pattern of a system with these unknowns and entries.
    pub fn new(kinds: Vec<Kind>, entries: impl IntoIterator<Item = (usize, usize)>) -> Pattern {
        let mut linked = vec![BTreeSet::new(); kinds.len()];
        for (i, j) in entries {
            linked[i].insert(j);
            linked[j].insert(i);
        }
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
/// what they constrain is gone; intermediate quantities, the last defined first, when nothing else can be done. `None`
/// if an unknown is left without a pivot.
pub fn order(mut pattern: Pattern) -> Option<Vec<Action>> {
    let mut left: BTreeSet<usize> = (0..pattern.kinds.len()).collect();
    // What each multiplier constrains; what elimination links it with does not count.
    let mut constrained = pattern.linked.clone();
    constrained.iter_mut().enumerate().for_each(|(k, links)| {
        links.remove(&k);
    });
    let mut actions = Vec::with_capacity(left.len());
    while !left.is_empty() {
        let unknown = pattern.next(&left, &constrained)?;
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
    Some(actions)
}

/// Only the intermediate quantities, the last defined first.
pub fn substitutions(mut pattern: Pattern) -> Vec<Action> {
    let intermediates = (0..pattern.kinds.len()).rev().filter(|k| matches!(pattern.kinds[*k], Kind::Intermediate(_)));
    let intermediates: Vec<usize> = intermediates.collect();
    intermediates.into_iter().map(|unknown| Action { unknown, neighbours: pattern.remove(unknown) }).collect()
}

/// About how many multiplications a solution in the given order takes.
pub fn cost(pattern_kinds: &[Kind], actions: &[Action]) -> usize {
    let each = actions.iter().map(|Action { unknown, neighbours }| match &pattern_kinds[*unknown] {
        Kind::Intermediate(definition) => definition.len() * (neighbours.len() + definition.len() + 2),
        _ => neighbours.len() * (neighbours.len() + 5) / 2 + 1,
    });
    each.sum()
}

impl Pattern {
    fn next(&self, left: &BTreeSet<usize>, constrained: &[BTreeSet<usize>]) -> Option<usize> {
        let has_pivot = |k: usize| match &self.kinds[k] {
            Kind::Coordinate => self.linked[k].contains(&k) && self.occurrences[k] == 0,
            Kind::Multiplier => self.linked[k].contains(&k) && constrained[k].is_disjoint(left),
            Kind::Intermediate(_) => false,
        };
        let is_free = |k: usize| matches!(self.kinds[k], Kind::Intermediate(_)) && self.occurrences[k] == 0;
        let ready = left.iter().copied().filter(|k| has_pivot(*k)).min_by_key(|k| (self.linked[*k].len(), *k));
        // The last defined lies farthest out: from there elimination works its way in.
        ready.or_else(|| left.iter().rev().copied().find(|k| is_free(*k)))
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
