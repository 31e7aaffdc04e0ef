//! Products of two factors that several products have in common, computed once.
//!
//! `k sin(a) a'^2` and `l sin(a) a'^2` are two values that share `sin(a) a'^2`. The pair that saves most
//! multiplications is taken out first, as Breuer does with sums and products alike (Generation of optimal code for
//! expressions via factorization, CACM 12, 1969). Common factors of sums have been taken out before. Where latency
//! dominates, a pair that would delay a product is left in it: `late * early * early` is `late * (early * early)`.
//!
//! The rule about waiting applies only where the longest chain of operations takes longer than all operations one after
//! the other; applied everywhere, it would slow down kernels such as an arm's inverse dynamics.

use super::latency::{self, Time, times};
use super::values::{Leaves, Operation, Value, Values};
use indexmap::IndexMap;
use rustc_hash::{FxBuildHasher, FxHashMap};
use std::cmp::Reverse;
use std::collections::BinaryHeap;

/// The new places of values, operands first.
pub(super) type Moved = IndexMap<Value, Value, FxBuildHasher>;

/// Values with shared products taken out.
pub(super) struct Shared {
    /// The values that are needed.
    pub(super) values: Values,
    /// Their previous places.
    pub(super) moved: Moved,
}

/// Takes shared products out of `roots` and their operands, if there are any; operands of `leaves` stay unchanged.
pub(super) fn share_products(values: &Values, roots: &[Value], leaves: &Leaves) -> Option<Shared> {
    let mut needed = values.reachable(roots, leaves);
    needed.retain(|value| !leaves.contains_key(value));
    if !has_shared_pair(values, &needed) {
        return None;
    }
    let times = times(values, &needed);
    let latest = times.iter().max().copied().unwrap_or(0);
    let operations = needed.iter().map(|value| values.operands(*value).count().saturating_sub(1)).sum::<usize>();
    let mut products = Products { is_hurried: latest as usize > operations, ..Default::default() };
    for value in needed {
        if let Operation::Product(factors) = values.operation(value) {
            products.add(value, factors.iter().map(|factor| (Factor::Value(*factor), times[factor.index()])));
        }
    }
    products.find_pairs();
    products.take_out_pairs();
    let is_shared = !products.pairs.is_empty();
    is_shared.then(|| products.rebuild(values, &values.reachable(roots, &Leaves::default())))
}

/// Whether two factors stand together in several products.
fn has_shared_pair(values: &Values, needed: &[Value]) -> bool {
    let mut seen: FxHashMap<(Value, Value), Value> = FxHashMap::with_capacity_and_hasher(needed.len(), FxBuildHasher);
    let is_new = |product: Value, pair: (Value, Value), seen: &mut FxHashMap<_, _>| {
        seen.insert(pair, product).is_none_or(|other| other == product)
    };
    !needed.iter().all(|value| match values.operation(*value) {
        Operation::Product(factors) => {
            factors.iter().enumerate().all(|(j, b)| factors[..j].iter().all(|a| is_new(*value, (*a, *b), &mut seen)))
        }
        _ => true,
    })
}

/// A factor: a value, or a pair that was taken out, by number.
#[derive(Clone, Copy, PartialEq, Eq, Hash, PartialOrd, Ord)]
enum Factor {
    Value(Value),
    Pair(usize),
}

/// Two factors, the smaller one first.
type Pair = (Factor, Factor);

/// Factors and when they are known, in order.
type Factors = Vec<(Factor, Time)>;

#[derive(Default)]
struct Products {
    /// Whether no product may be delayed: the operations, at about one per cycle, take less time than the longest chain
    /// of them.
    is_hurried: bool,
    factors: Vec<Factors>,
    by_value: FxHashMap<Value, usize>,
    /// The products that each pair is in, if there are several.
    containing: FxHashMap<Pair, Vec<usize>>,
    /// The pairs that were taken out.
    pairs: Vec<Pair>,
}

impl Products {
    fn add(&mut self, value: Value, factors: impl Iterator<Item = (Factor, Time)>) {
        self.by_value.insert(value, self.factors.len());
        let mut factors: Factors = factors.collect();
        factors.sort();
        self.factors.push(factors);
    }

    fn find_pairs(&mut self) {
        let pairs: Vec<(usize, Pair)> = (0..self.factors.len())
            .flat_map(|product| self.pairs_in(product).into_iter().map(move |pair| (product, pair)))
            .collect();
        let mut counts: FxHashMap<Pair, usize> = FxHashMap::default();
        pairs.iter().for_each(|(_, pair)| *counts.entry(*pair).or_default() += 1);
        for (product, pair) in pairs {
            if counts[&pair] > 1 {
                self.containing.entry(pair).or_default().push(product);
            }
        }
    }

    /// The pairs of factors of a product that may be taken out.
    fn pairs_in(&self, product: usize) -> Vec<Pair> {
        let factors = &self.factors[product];
        let mut pairs = Vec::with_capacity(factors.len() * (factors.len() - 1) / 2);
        for (j, (b, _)) in factors.iter().enumerate() {
            for (i, (a, _)) in factors[..j].iter().enumerate() {
                let is_open = !self.is_hurried || !makes_wait(factors, i, j);
                if is_open && !pairs.contains(&(*a, *b)) {
                    pairs.push((*a, *b));
                }
            }
        }
        pairs
    }

    /// Multiplications saved by computing a pair once.
    fn saving(&self, pair: Pair) -> usize {
        self.containing.get(&pair).map_or(0, |products| products.len().saturating_sub(1))
    }

    /// The pair that saves most first, then by order of values.
    fn take_out_pairs(&mut self) {
        let mut candidates: BinaryHeap<(usize, Reverse<Pair>)> = BinaryHeap::new();
        let consider = |candidates: &mut BinaryHeap<_>, saving: usize, pair: Pair| {
            if saving > 0 {
                candidates.push((saving, Reverse(pair)));
            }
        };
        self.containing.keys().for_each(|pair| consider(&mut candidates, self.saving(*pair), *pair));
        while let Some((saving, Reverse(pair))) = candidates.pop() {
            let now = self.saving(pair);
            if now < saving {
                consider(&mut candidates, now, pair);
                continue;
            }
            for new in self.take_out(pair) {
                consider(&mut candidates, self.saving(new), new);
            }
        }
    }

    /// Makes a pair one factor of all products that contain it; gives the pairs that these then have.
    fn take_out(&mut self, pair: Pair) -> Vec<Pair> {
        let taken = Factor::Pair(self.pairs.len());
        self.pairs.push(pair);
        let mut new = Vec::new();
        for product in self.containing.remove(&pair).unwrap_or_default() {
            for old in self.pairs_in(product) {
                if let Some(products) = self.containing.get_mut(&old) {
                    products.retain(|each| *each != product);
                }
            }
            let factors = &mut self.factors[product];
            let mut times = [0; 2];
            for (factor, time) in [pair.0, pair.1].into_iter().zip(&mut times) {
                if let Some(at) = factors.iter().position(|(each, _)| *each == factor) {
                    *time = factors.remove(at).1;
                }
            }
            factors.push((taken, latency::product(&mut times)));
            for pair in self.pairs_in(product) {
                self.containing.entry(pair).or_default().push(product);
                new.push(pair);
            }
        }
        new.sort();
        new.dedup();
        new
    }

    fn rebuild(&self, values: &Values, needed: &[Value]) -> Shared {
        let mut shared = Shared { values: Values::with_room(needed.len()), moved: Moved::default() };
        let mut taken: Vec<Option<Value>> = vec![None; self.pairs.len()];
        for value in needed {
            let new = match self.by_value.get(value) {
                Some(product) => {
                    self.product(self.factors[*product].iter().map(|(factor, _)| *factor), &mut shared, &mut taken)
                }
                None => {
                    let operation = values.operation(*value).map(|operand| shared.moved[&operand]);
                    shared.values.add(operation)
                }
            };
            shared.moved.insert(*value, new);
        }
        shared
    }

    fn product(
        &self,
        factors: impl Iterator<Item = Factor>,
        shared: &mut Shared,
        taken: &mut [Option<Value>],
    ) -> Value {
        let mut values: Vec<Value> = Vec::new();
        for factor in factors {
            values.push(match factor {
                Factor::Value(value) => shared.moved[&value],
                Factor::Pair(pair) => match taken[pair] {
                    Some(known) => known,
                    None => {
                        let (a, b) = self.pairs[pair];
                        let new = self.product([a, b].into_iter(), shared, taken);
                        taken[pair] = Some(new);
                        new
                    }
                },
            });
        }
        values.sort();
        match values.as_slice() {
            [one] => *one,
            _ => shared.values.add(Operation::Product(values)),
        }
    }
}

/// Whether a product is known later if two of its factors are multiplied first.
fn makes_wait(factors: &Factors, i: usize, j: usize) -> bool {
    let mut times: Vec<Time> = factors.iter().map(|(_, time)| *time).collect();
    let known = latency::product(&mut times);
    times.clear();
    times.extend(factors.iter().enumerate().filter(|(k, _)| *k != i && *k != j).map(|(_, (_, time))| *time));
    times.push(latency::product(&mut [factors[i].1, factors[j].1]));
    latency::product(&mut times) > known
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::program::values::Input;
    use crate::symbolic::Function;

    struct Case {
        values: Values,
        roots: Vec<Value>,
    }

    impl Case {
        fn inputs<const N: usize>() -> (Case, [Value; N]) {
            let mut values = Values::default();
            let inputs = std::array::from_fn(|i| values.add(Operation::Input(Input::Position(i))));
            (Case { values, roots: vec![] }, inputs)
        }

        fn product(&mut self, factors: &[Value]) {
            let product = self.values.product(factors.to_vec());
            self.roots.push(product);
        }

        /// Multiplications before and after; the values of the roots must stay what they are.
        fn multiplications(&self) -> [usize; 2] {
            let shared = share_products(&self.values, &self.roots, &Leaves::default());
            let Some(Shared { values, moved }) = shared else {
                return [count(&self.values, &self.roots); 2];
            };
            let new: Vec<Value> = self.roots.iter().map(|root| moved[root]).collect();
            for (old, new) in self.roots.iter().zip(&new) {
                let (expected, found) = (evaluate(&self.values, *old), evaluate(&values, *new));
                // A rounding for each multiplication.
                assert!((found - expected).abs() <= 8.0 * f64::EPSILON * expected.abs(), "{found} {expected}");
            }
            [count(&self.values, &self.roots), count(&values, &new)]
        }
    }

    fn count(values: &Values, roots: &[Value]) -> usize {
        let multiplications = |value: Value| match values.operation(value) {
            Operation::Product(factors) => factors.len() - 1,
            _ => 0,
        };
        values.reachable(roots, &Leaves::default()).into_iter().map(multiplications).sum()
    }

    fn evaluate(values: &Values, value: Value) -> f64 {
        match values.operation(value) {
            Operation::Input(Input::Position(i)) => 1.5 + *i as f64,
            Operation::Call(Function::Exp, argument) => evaluate(values, *argument).exp(),
            Operation::Product(factors) => factors.iter().map(|factor| evaluate(values, *factor)).product(),
            other => unreachable!("{other:?}"),
        }
    }

    #[test]
    fn what_products_have_in_common_is_computed_once() {
        let (mut case, [k, l, s, q]) = Case::inputs();
        case.product(&[k, s, q]);
        case.product(&[l, s, q]);
        case.product(&[s, q]);
        assert_eq!(case.multiplications(), [5, 3]);
    }

    #[test]
    fn the_pair_that_saves_most_goes_first_and_pairs_may_hold_pairs() {
        let (mut case, [a, b, c, d]) = Case::inputs();
        let late = case.values.add(Operation::Call(Function::Exp, d));
        case.product(&[a, b, c]);
        case.product(&[a, b, late]);
        case.product(&[a, b, c, late]);
        case.product(&[b, c]);
        // ab, (ab) c, (ab) late, (abc) late, bc
        assert_eq!(case.multiplications(), [8, 5]);
    }

    #[test]
    fn powers_keep_their_factors() {
        let (mut case, [a, b, c]) = Case::inputs();
        case.product(&[a, a, b, c]);
        case.product(&[a, b, b, c]);
        case.product(&[a, a, b, b]);
        let [before, after] = case.multiplications();
        // ab and (ab) a, of these (ab) a c and (ab) a b, and (ab) b c.
        assert_eq!([before, after], [9, 6]);
    }

    #[test]
    fn no_product_waits_longer_for_what_it_shares() {
        let (mut case, [a, b, c]) = Case::inputs();
        let late = case.values.add(Operation::Call(Function::Exp, c));
        case.product(&[a, b, late]);
        case.product(&[a, late]);
        // `a late` would be there, but `b` would have to wait for it and be multiplied last.
        assert_eq!(case.multiplications(), [3, 3]);
        case.product(&[a, b]);
        assert_eq!(case.multiplications(), [4, 3]);
    }
}
