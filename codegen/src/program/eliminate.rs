//! The planned solution of the equations of motion: a straight-line factorisation whose order is chosen from the
//! structure of the system when the mechanism is built.
//!
//! The system is symmetric, with three kinds of unknowns. A coordinate is eliminated by its pivot, L D L'. The
//! acceleration of an intermediate quantity is known from those that it is defined by, `u = sum of a_j u_j + c`, and
//! is substituted in rows and columns alike; so a chain of bodies is worked off from its tip as by the
//! articulated-body method (Featherstone, Rigid Body Dynamics Algorithms, 2008, chapter 7). A multiplier is eliminated
//! when all of its coordinates are gone: then the pivots are those of -C_q M^-1 C_q', which is definite as long as M
//! is and the constraints are independent; one taken earlier could meet a pivot that is zero at some position, unless the
//! pivot depends on parameters alone.
//!
//! Each pivot comes with the scale of its terms, so that cancellation can be checked at run time.

use super::collect::add_multiples;
use super::notes::Notes;
use super::values::{Value, Values};
use crate::dynamics::order::{self, Action, Kind, Multipliers, Pattern, order, substitutions};
use indexmap::IndexMap;
use rustc_hash::FxBuildHasher;

/// A symmetric linear system; missing entries are zero at every position.
pub(super) struct System {
    /// The kind of each unknown.
    pub(super) unknowns: Vec<Unknown>,
    /// Entries (i, j), j <= i.
    pub(super) entries: Vec<(usize, usize, Value)>,
    /// When its multipliers are eliminated.
    pub(super) multipliers: Multipliers,
}

/// A kind of unknown.
pub(super) enum Unknown {
    /// The acceleration of a coordinate.
    Coordinate,
    /// The acceleration of an intermediate quantity: unknowns with their coefficients in its definition.
    Intermediate(Vec<(usize, Value)>),
    /// A multiplier.
    Multiplier,
}

impl System {
    fn pattern(&self, values: &Values) -> Pattern {
        let kind = |unknown: &Unknown| match unknown {
            Unknown::Coordinate => Kind::Coordinate,
            Unknown::Intermediate(definition) => Kind::Intermediate(definition.iter().map(|(j, _)| *j).collect()),
            Unknown::Multiplier => Kind::Multiplier,
        };
        let entry = |(i, j, value): &(usize, usize, Value)| order::Entry {
            place: (*i, *j),
            is_moving: !values.is_parametric(*value),
        };
        Pattern::new(self.unknowns.iter().map(kind).collect(), self.entries.iter().map(entry))
    }
}

/// A factorised system, which solves any right-hand side.
pub(super) struct Factors {
    pub(super) steps: Vec<Step>,
    /// Each pivot with the scale for its cancellation.
    pub(super) pivots: Vec<(Value, Value)>,
}

/// The elimination of one unknown.
pub(super) enum Step {
    /// Rows below with their entries of L, and the reciprocal of the pivot.
    Eliminate { unknown: usize, column: Vec<(usize, Value)>, inverse: Value },
    /// Its definition, its column of the matrix, and its diagonal entry.
    Substitute { unknown: usize, definition: Vec<(usize, Value)>, column: Vec<(usize, Value)>, diagonal: Value },
}

/// An entry under elimination: a sum that is still growing.
type Entry = Vec<(bool, Value)>;

/// A symmetric matrix under elimination, each entry once: under its indices, the smaller one first.
pub(super) struct Matrix {
    entries: IndexMap<(usize, usize), Entry, FxBuildHasher>,
    is_multiplier: Vec<bool>,
    /// The scale for the cancellation in each diagonal entry: the terms with the sign that the pivot must have, and the
    /// magnitudes of those that may have either.
    sizes: Vec<Entry>,
}

impl Matrix {
    fn of(values: &Values, system: &System) -> Matrix {
        let is_multiplier: Vec<bool> = system.unknowns.iter().map(|u| matches!(u, Unknown::Multiplier)).collect();
        let sizes = vec![vec![]; is_multiplier.len()];
        let mut matrix = Matrix { entries: IndexMap::default(), is_multiplier, sizes };
        for (i, j, value) in &system.entries {
            // A multiplier has a negative diagonal, if it has one.
            let (negative, size) = if matrix.is_multiplier[*j] { values.signed(*value) } else { (false, *value) };
            matrix.add(*i, *j, negative, size);
            if i == j {
                matrix.sizes[*i].push((false, size));
            }
        }
        matrix
    }

    fn add(&mut self, i: usize, j: usize, negative: bool, value: Value) {
        self.entries.entry((i.min(j), i.max(j))).or_default().push((negative, value));
    }

    /// A pivot, and the scale for its cancellation.
    ///
    /// Pivots of coordinates are positive and those of multipliers negative. Eliminating one kind subtracts from the
    /// pivots of the same kind and adds to those of the other, so terms of known sign need no magnitudes.
    fn pivot(&self, values: &mut Values, k: usize) -> (Value, Value) {
        let mut terms = self.entries.get(&(k, k)).cloned().unwrap_or_default();
        let size = values.sum(self.sizes[k].clone());
        if self.is_multiplier[k] {
            terms.retain(|(_, term)| !self.sizes[k].contains(&(false, *term)));
            terms.insert(0, (true, size));
        }
        (values.sum(terms), size)
    }

    /// Whether there is an entry that may be nonzero.
    pub(super) fn holds(&self, i: usize, j: usize) -> bool {
        self.entries.contains_key(&(i.min(j), i.max(j)))
    }

    /// The entry as it stands.
    pub(super) fn entry(&mut self, values: &mut Values, i: usize, j: usize) -> Value {
        self.value(values, i, j).unwrap_or_else(|| values.constant(0.0))
    }

    /// The entry as it stands, as one value from now on; nothing if it is zero.
    pub(super) fn value(&mut self, values: &mut Values, i: usize, j: usize) -> Option<Value> {
        let entry = self.entries.get_mut(&(i.min(j), i.max(j)))?;
        let terms = add_multiples(values, std::mem::take(entry));
        let sum = values.sum(terms);
        *entry = vec![(false, sum)];
        (!values.is_zero(sum)).then_some(sum)
    }

    /// The entries of a column in the given rows.
    fn column(&mut self, values: &mut Values, k: usize, rows: &[usize]) -> Vec<(usize, Value)> {
        rows.iter().filter(|i| **i != k).filter_map(|i| Some((*i, self.value(values, *i, k)?))).collect()
    }
}

/// Plans the factorisation. `None` if no order of this kind exists, as for a coordinate without mass.
pub(super) fn factorise(values: &mut Values, system: &System, names: &[String], notes: &mut Notes) -> Option<Factors> {
    let actions = order(system.pattern(values), system.multipliers)?;
    let mut matrix = Matrix::of(values, system);
    let mut factors = Factors { steps: vec![], pivots: vec![] };
    for Action { unknown, neighbours } in actions {
        let step = match &system.unknowns[unknown] {
            Unknown::Intermediate(definition) => substitute(values, &mut matrix, unknown, definition, &neighbours),
            _ => {
                let (step, pivot) = eliminate(values, &mut matrix, unknown, &neighbours, names, notes);
                factors.pivots.push(pivot);
                step
            }
        };
        factors.steps.push(step);
    }
    Some(factors)
}

/// The matrix after substitution of the intermediate quantities only.
pub(super) fn reduce(values: &mut Values, system: &System) -> Matrix {
    let mut matrix = Matrix::of(values, system);
    for Action { unknown, neighbours } in substitutions(system.pattern(values)) {
        if let Unknown::Intermediate(definition) = &system.unknowns[unknown] {
            substitute(values, &mut matrix, unknown, definition, &neighbours);
        }
    }
    matrix
}

fn eliminate(
    values: &mut Values,
    matrix: &mut Matrix,
    k: usize,
    neighbours: &[usize],
    names: &[String],
    notes: &mut Notes,
) -> (Step, (Value, Value)) {
    let (pivot, size) = matrix.pivot(values, k);
    notes.name(pivot, format!("pivot_{}", names[k]));
    let one = values.constant(1.0);
    let inverse = values.quotient(one, pivot);
    notes.name(inverse, format!("inverse_{}", names[k]));
    let mut column: Vec<(usize, Value)> = Vec::new();
    let entries = matrix.column(values, k, neighbours);
    for (at, (i, value)) in entries.iter().enumerate() {
        notes.name(*value, format!("k_{}_{}", names[*i], names[k]));
        let factor = values.product(vec![*value, inverse]);
        notes.name(factor, format!("l_{}_{}", names[*i], names[k]));
        column.push((*i, factor));
        for (j, value) in &entries[..=at] {
            let product = values.product(vec![factor, *value]);
            matrix.add(*i, *j, true, product);
            if i == j && matrix.is_multiplier[*i] != matrix.is_multiplier[k] {
                // Over a multiplier's pivot the product is negative.
                matrix.sizes[*i].push((matrix.is_multiplier[k], product));
            }
        }
    }
    (Step::Eliminate { unknown: k, column, inverse }, (pivot, size))
}

/// With `u_k = sum of a_j u_j + c`: `W_ij += a_i W_kj + W_ik a_j + a_i W_kk a_j`.
fn substitute(
    values: &mut Values,
    matrix: &mut Matrix,
    k: usize,
    definition: &[(usize, Value)],
    neighbours: &[usize],
) -> Step {
    let column = matrix.column(values, k, neighbours);
    let diagonal = matrix.value(values, k, k).unwrap_or_else(|| values.constant(0.0));
    for (i, w) in &column {
        for (j, a) in definition {
            let product = values.product(vec![*w, *a]);
            matrix.add(*i, *j, false, product);
            // A pair of different unknowns occurs from both sides, an unknown with itself only once.
            if i == j {
                matrix.add(*i, *j, false, product);
                let magnitude = values.magnitude(product);
                matrix.sizes[*i].extend([(false, magnitude); 2]);
            }
        }
    }
    for (at, (i, a)) in definition.iter().enumerate() {
        let scaled = values.product(vec![*a, diagonal]);
        for (j, b) in &definition[..=at] {
            let product = values.product(vec![scaled, *b]);
            if values.is_zero(product) {
                continue;
            }
            matrix.add(*i, *j, false, product);
            if i == j {
                matrix.sizes[*i].push((false, product));
            }
        }
    }
    Step::Substitute { unknown: k, definition: definition.to_vec(), column, diagonal }
}

impl Step {
    /// Its unknown, given those that are eliminated after it and the rest of the right-hand side.
    pub(super) fn unknown(&self, values: &mut Values, unknowns: &[Value], constants: &[Value]) -> Value {
        let (first, negative, column) = match self {
            Step::Eliminate { unknown, column, inverse } => {
                (values.product(vec![unknowns[*unknown], *inverse]), true, column)
            }
            Step::Substitute { unknown, definition, .. } => (constants[*unknown], false, definition),
        };
        let mut terms = vec![(false, first)];
        terms.extend(column.iter().map(|(i, factor)| (negative, values.product(vec![*factor, unknowns[*i]]))));
        values.sum(terms)
    }
}

impl Factors {
    /// The solution for a right-hand side, given the constants in the definitions of the intermediate quantities; both
    /// have an entry for each unknown.
    pub(super) fn solve(
        &self,
        values: &mut Values,
        rhs: Vec<Value>,
        constants: &[Value],
        label: &mut dyn FnMut(Value, usize),
    ) -> Vec<Value> {
        let mut unknowns = self.forward(values, rhs, constants, label);
        for step in self.steps.iter().rev() {
            let (Step::Eliminate { unknown, .. } | Step::Substitute { unknown, .. }) = step;
            unknowns[*unknown] = step.unknown(values, &unknowns, constants);
        }
        unknowns
    }

    /// The right-hand side as the steps leave it.
    pub(super) fn forward(
        &self,
        values: &mut Values,
        rhs: Vec<Value>,
        constants: &[Value],
        label: &mut dyn FnMut(Value, usize),
    ) -> Vec<Value> {
        let mut rhs: Vec<Entry> = rhs.into_iter().map(|value| vec![(false, value)]).collect();
        for step in &self.steps {
            match step {
                Step::Eliminate { unknown, column, .. } => {
                    let reduced = values.sum(std::mem::take(&mut rhs[*unknown]));
                    label(reduced, *unknown);
                    for (i, factor) in column {
                        rhs[*i].push((true, values.product(vec![*factor, reduced])));
                    }
                    rhs[*unknown] = vec![(false, reduced)];
                }
                Step::Substitute { unknown, definition, column, diagonal } => {
                    let constant = constants[*unknown];
                    for (i, w) in column {
                        rhs[*i].push((true, values.product(vec![*w, constant])));
                    }
                    rhs[*unknown].push((true, values.product(vec![*diagonal, constant])));
                    let passed_on = values.sum(std::mem::take(&mut rhs[*unknown]));
                    for (j, a) in definition {
                        rhs[*j].push((false, values.product(vec![*a, passed_on])));
                    }
                }
            }
        }
        rhs.into_iter().map(|entry| values.sum(entry)).collect()
    }
}
