//! Many right-hand sides of one factorised system, each zero in most places.
//!
//! Where what is left of a right-hand side is zero for an unknown, the unknown follows those that are eliminated after it,
//! `x_k = -sum of l_ik x_i`; where it is zero for some of these too, they follow in turn, and x_k depends on the others alone. The
//! coefficients of that are the same for all such right-hand sides: a leg of a robot that another leg moves follows six
//! accelerations of the trunk, not each of its own joints.

use super::eliminate::{Factors, Step};
use super::values::{Value, Values};
use indexmap::IndexMap;
use rustc_hash::FxHashMap;

/// Unknowns with their coefficients.
type Row = Vec<(usize, Value)>;

/// The factors with the coefficients that are known.
pub(super) struct Responses<'a> {
    factors: &'a Factors,
    /// For an unknown and the places of zeros after it.
    known: FxHashMap<(usize, Vec<usize>), Row>,
    /// For each unknown the rows after it, with their entries of L; nothing for what is substituted.
    columns: Vec<Option<&'a [(usize, Value)]>>,
}

impl<'a> Responses<'a> {
    pub(super) fn of(factors: &'a Factors, unknown_count: usize) -> Responses<'a> {
        let mut columns = vec![None; unknown_count];
        for step in &factors.steps {
            if let Step::Eliminate { unknown, column, .. } = step {
                columns[*unknown] = Some(column.as_slice());
            }
        }
        Responses { factors, known: FxHashMap::default(), columns }
    }

    /// The solution for a right-hand side; no constants occur in the definitions of intermediate quantities.
    pub(super) fn solve(&mut self, values: &mut Values, rhs: Vec<Value>) -> Vec<Value> {
        let constants = vec![values.constant(0.0); rhs.len()];
        let mut unknowns = self.factors.forward(values, rhs, &constants, &mut |_, _| ());
        let is_zero: Vec<bool> = unknowns.iter().map(|x| values.is_zero(*x)).collect();
        for step in self.factors.steps.iter().rev() {
            let k = match step {
                Step::Eliminate { unknown, .. } | Step::Substitute { unknown, .. } => *unknown,
            };
            unknowns[k] = match self.response(values, k, &is_zero) {
                Some(response) if is_zero[k] => {
                    let terms = response.iter().map(|(i, entry)| (false, values.product(vec![*entry, unknowns[*i]])));
                    let terms = terms.collect();
                    values.sum(terms)
                }
                _ => step.unknown(values, &unknowns, &constants),
            };
        }
        unknowns
    }

    /// The coefficients of an unknown for those after it that are not zero; nothing for what is substituted.
    fn response(&mut self, values: &mut Values, k: usize, is_zero: &[bool]) -> Option<Row> {
        let column = self.columns[k]?;
        let zeros: Vec<usize> = column.iter().map(|(i, _)| *i).filter(|i| is_zero[*i]).collect();
        let key = (k, zeros);
        if let Some(known) = self.known.get(&key) {
            return Some(known.clone());
        }
        let mut terms: IndexMap<usize, Vec<(bool, Value)>> = IndexMap::new();
        for (i, entry) in column {
            match self.response(values, *i, is_zero).filter(|_| is_zero[*i]) {
                None => terms.entry(*i).or_default().push((true, *entry)),
                Some(response) => {
                    for (j, by_j) in response {
                        terms.entry(j).or_default().push((true, values.product(vec![*entry, by_j])));
                    }
                }
            }
        }
        let response: Row = terms.into_iter().map(|(i, terms)| (i, values.sum(terms))).collect();
        self.known.insert(key, response.clone());
        Some(response)
    }
}
