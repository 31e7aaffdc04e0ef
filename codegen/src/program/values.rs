//! Values of a straight-line program, shared by construction: the same operation on the same values is one value.
//!
//! The engine has done the algebra before; here only 0 and 1 are simplified. One more thing happens: factors and terms
//! that depend on parameters alone are kept together, so that they are computed once for each set of parameters.

use super::Tree;
use super::columns::ColumnsShape;
use crate::symbolic::{Function, TableId};
use indexmap::IndexSet;
use rustc_hash::{FxBuildHasher, FxHashMap};
use std::rc::Rc;

/// A value of the program. Operands have smaller indices than their results.
#[derive(Clone, Copy, PartialEq, Eq, Hash, PartialOrd, Ord, Debug)]
pub(super) struct Value(u32);

/// The operation of a value.
#[derive(Clone, PartialEq, Eq, Hash, Debug)]
pub(super) enum Operation {
    /// A number that is not negative, by its bits.
    Constant(u64),
    /// An input of the kernel.
    Input(Input),
    /// Terms, each with whether it is subtracted.
    Sum(Vec<(bool, Value)>),
    /// Factors.
    Product(Vec<Value>),
    /// A quotient.
    Quotient(Value, Value),
    /// The opposite.
    Negate(Value),
    /// A function of one argument.
    Call(Function, Value),
    /// A square root.
    Sqrt(Value),
    /// A real power.
    Power(Value, Value),
    /// The angle of the point (x, y), as (y, x).
    Atan2(Value, Value),
    /// The second where the first is above zero, otherwise the third.
    Choice(Value, Value, Value),
    /// The derivative of this order of a table.
    Table(TableId, u8, Value),
    /// An input: the value it is set to, or its declared course.
    Held(Value, Value),
    /// The solutions of a system for many right-hand sides.
    Columns(Box<ColumnsOperation>),
    /// The entry of such a matrix in a row and a column.
    Entry(Value, usize, usize),
}

/// A matrix of right-hand sides with what solves it.
#[derive(Clone, PartialEq, Eq, Hash, Debug)]
pub(super) struct ColumnsOperation {
    pub(super) shape: Rc<ColumnsShape>,
    /// The reciprocals of pivots and the entries of L, by steps; then the right-hand sides, by rows.
    pub(super) operands: Vec<Value>,
}

/// An input of a kernel; numbers count in the order of declaration.
#[derive(Clone, Copy, PartialEq, Eq, Hash, PartialOrd, Ord, Debug)]
pub(super) enum Input {
    /// A parameter of the mechanism.
    Parameter(usize),
    /// The activity of a constraint that events switch.
    Activity(usize),
    /// The value that an input of the mechanism is set to, if any.
    Held(usize),
    /// Time.
    Time,
    /// A coordinate.
    Position(usize),
    /// Its speed.
    Speed(usize),
    /// Its acceleration.
    Acceleration(usize),
    /// A multiplier.
    Multiplier(usize),
    /// A generalised speed.
    GeneralizedSpeed(usize),
}

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
    pub(super) fn product(&mut self, factors: Vec<Value>) -> Value {
        let mut negative = false;
        let mut kept = Vec::with_capacity(factors.len());
        for factor in factors {
            let size = match *self.operation(factor) {
                Operation::Negate(inner) => {
                    negative = !negative;
                    inner
                }
                _ => factor,
            };
            if self.is_zero(size) {
                return size;
            }
            if !self.is_constant(size, 1.0) {
                kept.push(size);
            }
        }
        if let Some(parametric) = self.separate(&mut kept, |factor| *factor) {
            let together = self.product(parametric);
            kept.insert(0, together);
        }
        // In a fixed order, so that equal products are one value.
        kept.sort();
        let product = match kept.as_slice() {
            [] => self.constant(1.0),
            [one] => *one,
            _ => self.add(Operation::Product(kept)),
        };
        if negative { self.negate(product) } else { product }
    }

    /// The product of factors without signs, if it exists.
    pub(super) fn known_product(&self, mut factors: impl Iterator<Item = Value>) -> Option<Value> {
        let (first, second) = (factors.next()?, factors.next());
        let Some(second) = second else { return Some(first) };
        let mut factors: Vec<Value> = [first, second].into_iter().chain(factors).collect();
        factors.sort();
        self.find(&Operation::Product(factors))
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
    pub(super) fn operands(&self, value: Value) -> impl Iterator<Item = Value> + Clone + use<'_> {
        let (mut all_terms, mut all_factors, mut few) = (&[][..], &[][..], [None; 3]);
        match self.operation(value) {
            Operation::Constant(_) | Operation::Input(_) => {}
            Operation::Sum(terms) => all_terms = terms,
            Operation::Product(factors) => all_factors = factors,
            Operation::Columns(columns) => all_factors = &columns.operands,
            Operation::Quotient(a, b) | Operation::Power(a, b) | Operation::Atan2(a, b) | Operation::Held(a, b) => {
                few = [Some(*a), Some(*b), None];
            }
            Operation::Choice(a, b, c) => few = [a, b, c].map(|part| Some(*part)),
            Operation::Negate(a)
            | Operation::Call(_, a)
            | Operation::Sqrt(a)
            | Operation::Table(_, _, a)
            | Operation::Entry(a, ..) => {
                few = [Some(*a), None, None];
            }
        }
        let terms = all_terms.iter().map(|(_, term): &(bool, Value)| *term);
        terms.chain(all_factors.iter().copied()).chain(few.into_iter().flatten())
    }
}

impl Operation {
    /// The same on other operands.
    pub(super) fn map(&self, f: impl Fn(Value) -> Value) -> Operation {
        match self {
            Operation::Constant(_) | Operation::Input(_) => self.clone(),
            Operation::Sum(terms) => Operation::Sum(terms.iter().map(|(negative, x)| (*negative, f(*x))).collect()),
            Operation::Product(factors) => Operation::Product(factors.iter().map(|x| f(*x)).collect()),
            Operation::Quotient(above, below) => Operation::Quotient(f(*above), f(*below)),
            Operation::Negate(operand) => Operation::Negate(f(*operand)),
            Operation::Call(function, argument) => Operation::Call(*function, f(*argument)),
            Operation::Sqrt(argument) => Operation::Sqrt(f(*argument)),
            Operation::Power(base, exponent) => Operation::Power(f(*base), f(*exponent)),
            Operation::Atan2(y, x) => Operation::Atan2(f(*y), f(*x)),
            Operation::Choice(difference, above, other) => Operation::Choice(f(*difference), f(*above), f(*other)),
            Operation::Table(table, order, argument) => Operation::Table(*table, *order, f(*argument)),
            Operation::Held(held, course) => Operation::Held(f(*held), f(*course)),
            Operation::Columns(columns) => {
                let operands = columns.operands.iter().map(|x| f(*x)).collect();
                Operation::Columns(Box::new(ColumnsOperation { shape: columns.shape.clone(), operands }))
            }
            Operation::Entry(matrix, i, j) => Operation::Entry(f(*matrix), *i, *j),
        }
    }
}

impl Value {
    pub(super) fn index(self) -> usize {
        self.0 as usize
    }
}
