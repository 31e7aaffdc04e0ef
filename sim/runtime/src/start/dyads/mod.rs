//! Loops that close in closed form: which constraints determine which coordinates, and all solutions.
//!
//! Dyads (RRR, RRP) are recognised from the kernels alone: if constraints are a + b cos + c sin of a coordinate at
//! several places, to rounding, it is an angle; if they are a + b s, a length. Constraints in one or two unknown
//! coordinates, given the others, are closed one after the other. All other loops are left to Newton's method. (Assur
//! groups of the second class: Galletti, Mech. Mach. Theory 21, 1986.)

mod close;
mod harmonic;

pub use close::Form;

use crate::model::AnyMechanism;
use sim_kernel::Mechanism;
use std::collections::btree_map::Entry;
use std::collections::{BTreeMap, BTreeSet};

/// A loop that closes in closed form.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct Loop {
    /// The constraints that close it.
    pub constraints: Vec<&'static str>,
    /// The coordinates that they determine.
    pub coordinates: Vec<&'static str>,
    /// How.
    pub form: Form,
}

/// All configurations of a mechanism that satisfy its given start.
#[derive(Clone, Debug)]
pub struct Branches<M: Mechanism> {
    /// The loops that close in closed form, in the order of solution.
    pub loops: Vec<Loop>,
    /// The coordinates that are not found this way.
    pub open: Vec<&'static str>,
    /// The configurations, nearest to the guesses first; at most the 256 nearest, because each loop doubles their
    /// number.
    pub positions: Vec<M::Q>,
}

/// The configurations so far; coordinates not found yet keep their guesses and do not count.
const MOST_BRANCHES: usize = 256;

/// The rows and unknowns of a loop, by index.
type Block = (Vec<usize>, Vec<usize>);

/// All configurations of a mechanism, of any type, that satisfy its given start.
pub(crate) struct Closed {
    pub(crate) loops: Vec<Loop>,
    pub(crate) open: Vec<&'static str>,
    pub(crate) positions: Vec<Vec<f64>>,
}

/// Closes all loops that close in closed form, from the given coordinates of the start; the others keep their guesses.
pub(crate) fn close_loops(mechanism: &dyn AnyMechanism, guesses: &[f64], given: &[bool]) -> Closed {
    let mut found = Closed { loops: Vec::new(), open: Vec::new(), positions: vec![guesses.to_vec()] };
    let depends = dependence(mechanism, guesses);
    let mut known = given.to_vec();
    let mut refused: Vec<Block> = Vec::new();
    while let Some(block) = next_block(&depends, &known, &refused) {
        match close_all(mechanism, &found.positions, (&block, &depends), guesses) {
            None => refused.push(block),
            Some((form, positions)) => {
                block.1.iter().for_each(|j| known[*j] = true);
                found.loops.push(named(mechanism, &block, form));
                found.positions = positions;
                if found.positions.len() > MOST_BRANCHES {
                    found.sort(guesses);
                    found.positions.truncate(MOST_BRANCHES);
                }
            }
        }
    }
    let names = mechanism.description().coordinates.iter().zip(&known);
    found.open = names.filter(|(_, known)| !**known).map(|(c, _)| c.position.name).collect();
    if found.open.is_empty() {
        found.positions.retain(|q| is_closed(mechanism, q));
    }
    found.sort(guesses);
    found
}

impl Closed {
    /// Nearest to the guesses first.
    pub(crate) fn sort(&mut self, guesses: &[f64]) {
        let distance = |q: &[f64]| q.iter().zip(guesses).map(|(a, b)| (a - b) * (a - b)).sum::<f64>();
        self.positions.sort_by(|a, b| distance(a).total_cmp(&distance(b)));
    }
}

/// The nearest configuration, if all loops close in closed form.
pub(crate) fn nearest(mechanism: &dyn AnyMechanism, guesses: &[f64], given: &[bool]) -> Option<Vec<f64>> {
    let found = close_loops(mechanism, guesses, given);
    if found.loops.is_empty() || !found.open.is_empty() { None } else { found.positions.into_iter().next() }
}

/// Whether all constraints hold, to the accuracy lost by a root next to a dead point, which a correction restores.
fn is_closed(mechanism: &dyn AnyMechanism, q: &[f64]) -> bool {
    let (values, magnitudes) = (mechanism.constraints(0.0, q), mechanism.constraint_magnitudes(0.0, q));
    mechanism.is_met(0.0, q) || values.iter().zip(&magnitudes).all(|(value, magnitude)| value.abs() <= 1e-9 * magnitude)
}

/// Which constraint depends on which coordinate: it does not if C_q is exactly zero at several positions.
fn dependence(mechanism: &dyn AnyMechanism, q: &[f64]) -> Vec<Vec<bool>> {
    let moved = |k: usize| -> Vec<f64> {
        q.iter().enumerate().map(|(j, q)| q + 0.1 * (k * (j + 1)) as f64 + 0.03 * k as f64).collect()
    };
    let jacobian = |k: usize| mechanism.between_positions(mechanism.constraint_jacobian(0.0, &moved(k)));
    let jacobians = [0, 1, 2].map(jacobian);
    let depends = |i: usize, j: usize| jacobians.iter().any(|jacobian| jacobian[(i, j)] != 0.0);
    (0..jacobians[0].nrows()).map(|i| (0..q.len()).map(|j| depends(i, j)).collect()).collect()
}

/// One constraint in one unknown coordinate, otherwise two in two, that have not been refused.
fn next_block(depends: &[Vec<bool>], known: &[bool], refused: &[Block]) -> Option<Block> {
    let unknowns: Vec<Vec<usize>> =
        depends.iter().map(|row| (0..known.len()).filter(|j| !known[*j] && row[*j]).collect()).collect();
    let open: Vec<usize> = (0..depends.len()).filter(|i| (1..=2).contains(&unknowns[*i].len())).collect();
    let single = open.iter().map(|i| (vec![*i], unknowns[*i].clone()));
    let pairs = open.iter().enumerate().flat_map(|(k, i)| open[k + 1..].iter().map(move |j| [*i, *j]));
    let pairs = pairs.map(|[i, k]| {
        let both: BTreeSet<usize> = unknowns[i].iter().chain(&unknowns[k]).copied().collect();
        (vec![i, k], both.into_iter().collect())
    });
    let is_square = |(rows, unknowns): &Block| rows.len() == unknowns.len();
    single.chain(pairs).filter(is_square).find(|block| !refused.contains(block))
}

/// All solutions of a loop from each configuration so far; `None` if its form is unknown. Configurations that differ
/// only in coordinates that the loop does not depend on share its solutions.
fn close_all(
    mechanism: &dyn AnyMechanism,
    so_far: &[Vec<f64>],
    ((rows, unknowns), depends): (&Block, &[Vec<bool>]),
    guesses: &[f64],
) -> Option<(Form, Vec<Vec<f64>>)> {
    let matters = |j: &usize| !unknowns.contains(j) && rows.iter().any(|i| depends[*i][*j]);
    let inputs: Vec<usize> = (0..guesses.len()).filter(matters).collect();
    let guesses: Vec<f64> = unknowns.iter().map(|j| guesses[*j]).collect();
    let mut known: BTreeMap<Vec<u64>, (Form, Vec<Vec<f64>>)> = BTreeMap::new();
    let mut form = None;
    let mut closed = Vec::new();
    for q in so_far {
        let with = |values: &[f64]| {
            let mut q = q.clone();
            unknowns.iter().zip(values).for_each(|(j, value)| q[*j] = *value);
            q
        };
        let residual = |values: &[f64]| -> Vec<f64> {
            let all = mechanism.constraints(0.0, &with(values));
            rows.iter().map(|i| all[*i]).collect()
        };
        let (found, solutions) = match known.entry(inputs.iter().map(|j| q[*j].to_bits()).collect()) {
            Entry::Occupied(known) => known.into_mut(),
            Entry::Vacant(new) => new.insert(close::close(&residual, &guesses)?),
        };
        form = Some(*found);
        closed.extend(solutions.iter().map(|values| with(values)));
    }
    form.map(|form| (form, closed))
}

fn named(mechanism: &dyn AnyMechanism, (rows, unknowns): &Block, form: Form) -> Loop {
    Loop {
        constraints: rows.iter().map(|i| mechanism.constraint_name(*i)).collect(),
        coordinates: unknowns.iter().map(|j| mechanism.description().coordinates[*j].position.name).collect(),
        form,
    }
}
