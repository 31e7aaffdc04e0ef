//! Values of a straight-line program, shared by construction: the same operation on the same values is one value.
//!
//! The engine has done the algebra before; here only 0 and 1 are simplified. One more thing happens: factors and terms
//! that depend on parameters alone are kept together, so that they are computed once for each set of parameters.

use super::Tree;
use crate::symbolic::Function;
use indexmap::IndexSet;
use rustc_hash::{FxBuildHasher, FxHashMap};

pub(super) use super::operation::{ColumnsOperation, Input, Operands, Operation, Value};

/// Values that need no statement: inputs and prepared values.
pub(super) type Leaves = FxHashMap<Value, Tree>;

/// All values of a program.
#[derive(Default)]
pub(super) struct Values {
    operations: IndexSet<Operation, FxBuildHasher>,
    /// For each value whether it depends on nothing but parameters and activities, which change only at events.
    parametric: Vec<bool>,
}

impl Values {
    /// None, with room for some.
    pub(super) fn with_room(room: usize) -> Values {
        Values {
            operations: IndexSet::with_capacity_and_hasher(room, FxBuildHasher),
            parametric: Vec::with_capacity(room),
        }
    }

    pub(super) fn operation(&self, value: Value) -> &Operation {
        &self.operations[value.index()]
    }

    pub(super) fn len(&self) -> usize {
        self.operations.len()
    }

    /// All values, operands first.
    pub(super) fn all(&self) -> impl Iterator<Item = Value> + use<> {
        (0..self.operations.len() as u32).map(Value)
    }

    pub(super) fn add(&mut self, operation: Operation) -> Value {
        let value = Value(self.operations.insert_full(operation).0 as u32);
        if value.index() == self.parametric.len() {
            let parametric = match self.operation(value) {
                Operation::Input(input) => matches!(input, Input::Parameter(_) | Input::Activity(_)),
                _ => self.operands(value).all(|operand| self.is_parametric(operand)),
            };
            self.parametric.push(parametric);
        }
        value
    }

    /// Whether a value depends on nothing but parameters.
    pub(super) fn is_parametric(&self, value: Value) -> bool {
        self.parametric[value.index()]
    }

    pub(super) fn find(&self, operation: &Operation) -> Option<Value> {
        self.operations.get_index_of(operation).map(|index| Value(index as u32))
    }

    pub(super) fn constant(&mut self, number: f64) -> Value {
        let size = self.add(Operation::Constant(number.abs().to_bits()));
        if number.is_sign_negative() { self.negate(size) } else { size }
    }

    pub(super) fn is_constant(&self, value: Value, number: f64) -> bool {
        *self.operation(value) == Operation::Constant(number.to_bits())
    }

    pub(super) fn is_zero(&self, value: Value) -> bool {
        self.is_constant(value, 0.0)
    }

    pub(super) fn negate(&mut self, value: Value) -> Value {
        match *self.operation(value) {
            Operation::Negate(inner) => inner,
            Operation::Constant(bits) if bits == 0.0f64.to_bits() => value,
            _ => self.add(Operation::Negate(value)),
        }
    }

    /// The sum of terms, each with whether it is subtracted; one that is added comes first.
    pub(super) fn sum(&mut self, terms: Vec<(bool, Value)>) -> Value {
        let mut terms: Vec<_> = terms
            .into_iter()
            .filter(|(_, term)| !self.is_zero(*term))
            .map(|(negative, term)| match self.operation(term) {
                Operation::Negate(inner) => (!negative, *inner),
                _ => (negative, term),
            })
            .collect();
        if let Some(parametric) = self.separate(&mut terms, |(_, term)| *term) {
            let together = self.sum(parametric);
            terms.insert(0, self.signed(together));
        }
        if let Some(first) = terms.iter().position(|(negative, _)| !negative) {
            terms[..=first].rotate_right(1);
        }
        match terms.as_slice() {
            [] => self.constant(0.0),
            [(false, one)] => *one,
            [(true, one)] => self.negate(*one),
            _ if terms[0].0 => {
                let opposite = terms.into_iter().map(|(negative, term)| (!negative, term)).collect();
                let opposite = self.sum(opposite);
                self.negate(opposite)
            }
            _ => self.add(Operation::Sum(terms)),
        }
    }

    /// A number with its sign.
    pub(super) fn number(&self, value: Value) -> Option<f64> {
        match self.operation(value) {
            Operation::Constant(bits) => Some(f64::from_bits(*bits)),
            Operation::Negate(inner) => self.number(*inner).map(|number| -number),
            _ => None,
        }
    }

    /// A sum of two, of which one depends on parameters alone: this one, then the other, each with whether it is subtracted.
    pub(super) fn parametric_and_moving(&self, value: Value) -> Option<[(bool, Value); 2]> {
        let Operation::Sum(terms) = self.operation(value) else { return None };
        let [a, b] = terms[..] else { return None };
        match [a, b].map(|(_, term)| self.is_parametric(term)) {
            [true, false] => Some([a, b]),
            [false, true] => Some([b, a]),
            _ => None,
        }
    }

    /// The product of factors, with signs in front.
    pub(super) fn product(&mut self, mut factors: Vec<Value>) -> Value {
        let mut negative = false;
        for factor in &mut factors {
            if let Some(opposite) = self.opposite(*factor) {
                negative = !negative;
                *factor = opposite;
            }
            if self.is_zero(*factor) {
                return *factor;
            }
        }
        factors.retain(|factor| !self.is_constant(*factor, 1.0));
        if let Some(parametric) = self.separate(&mut factors, |factor| *factor) {
            let together = self.product(parametric);
            factors.insert(0, together);
        }
        // In a fixed order, so that equal products are one value.
        factors.sort();
        let product = match factors.as_slice() {
            [] => self.constant(1.0),
            [one] => *one,
            _ => self.add(Operation::Product(factors)),
        };
        if negative { self.negate(product) } else { product }
    }

    /// The product of factors without signs, `left_out` left out, if it exists.
    pub(super) fn known_product(&self, factors: &[Value], left_out: &[Value]) -> Option<Value> {
        let mut rest = factors.to_vec();
        rest.retain(|factor| !left_out.contains(factor));
        match rest.as_slice() {
            [] => None,
            [one] => Some(*one),
            _ => {
                rest.sort();
                self.find(&Operation::Product(rest))
            }
        }
    }

    /// The value as a multiple of another by a factor that depends on parameters alone.
    pub(super) fn as_multiple(&mut self, value: Value) -> (Value, Value) {
        let (mut coefficient, mut rest) = (self.constant(1.0), value);
        while let Operation::Product(factors) = self.operation(rest) {
            // All factors that depend on parameters alone are one factor.
            let (parametric, other) = match factors.as_slice() {
                [a, b] if self.is_parametric(*a) => (*a, *b),
                [a, b] if self.is_parametric(*b) => (*b, *a),
                _ => break,
            };
            rest = other;
            coefficient = self.product(vec![coefficient, parametric]);
        }
        (coefficient, rest)
    }

    /// A quotient; if the divisor depends on parameters alone, a product with its reciprocal.
    pub(super) fn quotient(&mut self, above: Value, below: Value) -> Value {
        if self.is_parametric(below) && !self.is_parametric(above) {
            let one = self.constant(1.0);
            let reciprocal = self.quotient(one, below);
            return self.product(vec![reciprocal, above]);
        }
        let (above_size, below_size) = (self.size(above), self.size(below));
        let quotient = match self.is_constant(below_size, 1.0) {
            true => above_size,
            false => self.add(Operation::Quotient(above_size, below_size)),
        };
        if (above_size == above) == (below_size == below) { quotient } else { self.negate(quotient) }
    }

    /// Takes out the operands that depend on parameters alone, if there are several, and others too.
    fn separate<T: Copy>(&self, operands: &mut Vec<T>, value: impl Fn(&T) -> Value) -> Option<Vec<T>> {
        let is_parametric = |operand: &T| self.is_parametric(value(operand));
        let count = operands.iter().filter(|operand| is_parametric(operand)).count();
        (1 < count && count < operands.len()).then(|| {
            let (parametric, others) = operands.iter().partition(|operand| is_parametric(operand));
            *operands = others;
            parametric
        })
    }

    /// A value as a term: whether it is subtracted, and its size.
    pub(super) fn signed(&self, value: Value) -> (bool, Value) {
        (self.opposite(value).is_some(), self.size(value))
    }

    /// The absolute value.
    pub(super) fn magnitude(&mut self, value: Value) -> Value {
        let size = self.size(value);
        self.add(Operation::Call(Function::Abs, size))
    }

    /// The value that this one negates, if it is a negation.
    pub(super) fn opposite(&self, value: Value) -> Option<Value> {
        match *self.operation(value) {
            Operation::Negate(inner) => Some(inner),
            _ => None,
        }
    }

    /// The value without a minus sign in front.
    fn size(&self, value: Value) -> Value {
        self.opposite(value).unwrap_or(value)
    }

    /// `base^exponent` by squaring, for exponents of at least 1.
    pub(super) fn integer_power(&mut self, base: Value, exponent: u64) -> Value {
        match exponent {
            1 => base,
            _ if exponent.is_multiple_of(2) => {
                let half = self.integer_power(base, exponent / 2);
                self.product(vec![half, half])
            }
            _ => {
                let lower = self.integer_power(base, exponent - 1);
                self.product(vec![lower, base])
            }
        }
    }

    /// `roots` and all of their operands, operands first, without the operands of `leaves`.
    pub(super) fn reachable(&self, roots: &[Value], leaves: &Leaves) -> Vec<Value> {
        let mut seen = vec![false; self.len()];
        let mut stack = roots.to_vec();
        while let Some(value) = stack.pop() {
            if !std::mem::replace(&mut seen[value.index()], true) && !leaves.contains_key(&value) {
                stack.extend(self.operands(value));
            }
        }
        self.all().filter(|value| seen[value.index()]).collect()
    }

    /// The operands of a value, in order.
    pub(super) fn operands(&self, value: Value) -> Operands<'_> {
        self.operation(value).operands()
    }
}
