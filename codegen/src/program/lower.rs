//! Symbolic expressions to program values.

use super::collect::{Term, collect};
use super::values::{Input, Operation, Value, Values};
use crate::symbolic::{Expr, Graph, Node, Number, Symbol};
use rustc_hash::{FxBuildHasher, FxHashMap};

/// The initial capacity for expressions.
const ROOM: usize = 256;

/// Lowers expressions of one graph into one program.
pub(super) struct Lowering<'a> {
    graph: &'a Graph,
    inputs: &'a FxHashMap<Symbol, Input>,
    /// The values of symbols, and the courses of the mechanism's inputs.
    definitions: &'a FxHashMap<Symbol, Expr>,
    /// Other forms of expressions.
    alternatives: &'a FxHashMap<Expr, Expr>,
    /// Divisors used so often that their reciprocal is computed once.
    divisors: &'a [Expr],
    pub(super) values: Values,
    done: FxHashMap<Expr, Value>,
    computed: FxHashMap<Symbol, Value>,
    /// Whether the requested results need each value.
    wanted: Vec<bool>,
}

impl<'a> Lowering<'a> {
    pub(super) fn new(
        graph: &'a Graph,
        inputs: &'a FxHashMap<Symbol, Input>,
        definitions: &'a FxHashMap<Symbol, Expr>,
        alternatives: &'a FxHashMap<Expr, Expr>,
        divisors: &'a [Expr],
    ) -> Lowering<'a> {
        Lowering {
            graph,
            inputs,
            definitions,
            alternatives,
            divisors,
            wanted: vec![],
            values: Values::with_room(ROOM),
            done: FxHashMap::with_capacity_and_hasher(ROOM, FxBuildHasher),
            computed: FxHashMap::default(),
        }
    }

    /// The value of an expression, if it has been lowered.
    pub(super) fn lowered(&self, expr: Expr) -> Option<Value> {
        self.done.get(&expr).copied()
    }

    /// The value of an expression, in whichever form costs less, given the values that exist already.
    pub(super) fn lower(&mut self, expr: Expr) -> Value {
        let known = self.done.contains_key(&expr);
        let mut value = self.lower_form(expr);
        if let Some(other) = self.alternatives.get(&expr).filter(|_| !known) {
            let other = self.lower_form(*other);
            if self.cost(other) < self.cost(value) {
                value = other;
                self.done.insert(expr, value);
            }
        }
        self.want(value);
        value
    }

    /// Operations that a value needs beyond existing ones. Those on parameters alone are free.
    fn cost(&mut self, value: Value) -> usize {
        let new = self.want(value);
        new.iter().for_each(|new| self.wanted[new.index()] = false);
        let variable = new.into_iter().filter(|new| !self.values.is_parametric(*new));
        let operations = |operands: usize| if operands < 2 { operands } else { operands - 1 };
        variable.map(|new| operations(self.values.operands(new).count())).sum()
    }

    /// Marks a value and all of its operands as needed; gives the newly marked ones.
    fn want(&mut self, value: Value) -> Vec<Value> {
        self.wanted.resize(self.values.len(), false);
        if self.wanted[value.index()] {
            return vec![];
        }
        let (mut new, mut stack) = (vec![], vec![value]);
        while let Some(value) = stack.pop() {
            if !std::mem::replace(&mut self.wanted[value.index()], true) {
                new.push(value);
                stack.extend(self.values.operands(value));
            }
        }
        new
    }

    fn lower_form(&mut self, expr: Expr) -> Value {
        if let Some(done) = self.done.get(&expr) {
            return *done;
        }
        let graph = self.graph;
        let value = match graph.node(expr) {
            Node::Number(number) => self.values.constant(number.to_f64()),
            Node::Constant(constant) => self.values.constant(constant.to_f64()),
            Node::Symbol(symbol) => self.symbol(*symbol),
            Node::Sum { constant, terms } => self.sum(constant, terms),
            Node::Product { coefficient, factors } => self.product(coefficient, factors),
            Node::Power { base, exponent } => self.power(*base, *exponent),
            Node::Call(function, argument) => {
                let argument = self.lower_form(*argument);
                self.values.add(Operation::Call(*function, argument))
            }
            Node::Choice(difference, above, otherwise) => {
                let [difference, above, otherwise] = [difference, above, otherwise].map(|part| self.lower_form(*part));
                self.values.add(Operation::Choice(difference, above, otherwise))
            }
            Node::Table(table, order, argument) => {
                let argument = self.lower_form(*argument);
                self.values.add(Operation::Table(*table, *order, argument))
            }
            Node::Atan2(y, x) => {
                let (y, x) = (self.lower_form(*y), self.lower_form(*x));
                self.values.add(Operation::Atan2(y, x))
            }
        };
        self.done.insert(expr, value);
        value
    }

    fn symbol(&mut self, symbol: Symbol) -> Value {
        if let Some(computed) = self.computed.get(&symbol) {
            return *computed;
        }
        match (self.inputs.get(&symbol), self.definitions.get(&symbol)) {
            (Some(input), Some(course)) => {
                let (held, course) = (self.values.add(Operation::Input(*input)), self.lower_form(*course));
                self.values.add(Operation::Held(held, course))
            }
            (Some(input), _) => self.values.add(Operation::Input(*input)),
            (_, Some(definition)) => self.lower_form(*definition),
            // The model has no other symbols; were there one, its value would be unknown.
            _ => self.values.constant(f64::NAN),
        }
    }

    pub(super) fn lower_all(&mut self, exprs: &[Expr]) -> Vec<Value> {
        exprs.iter().map(|expr| self.lower(*expr)).collect()
    }

    fn sum(&mut self, constant: &Number, terms: &[(Expr, Number)]) -> Value {
        let mut summands: Vec<Term> = terms.iter().map(|(term, coefficient)| self.term(*term, coefficient)).collect();
        let size = self.values.constant(constant.abs().to_f64());
        summands.push(Term { negative: constant.is_negative(), factors: vec![size], divisors: vec![] });
        collect(&mut self.values, summands)
    }

    /// `coefficient * expr` by its factors.
    fn term(&mut self, expr: Expr, coefficient: &Number) -> Term {
        let graph = self.graph;
        let (inner, factors) = match graph.node(expr) {
            Node::Product { coefficient, factors } => (coefficient.to_f64(), &**factors),
            _ => (1.0, &[(expr, 1)][..]),
        };
        let number = coefficient.to_f64() * inner;
        let mut term = Term { negative: false, factors: Vec::with_capacity(factors.len() + 1), divisors: vec![] };
        term.factors.push(self.values.constant(number.abs()));
        for (base, exponent) in factors {
            let (power, is_above) = self.integer_power(*base, *exponent);
            let list = if is_above { &mut term.factors } else { &mut term.divisors };
            list.push(power);
        }
        term.negative = number < 0.0;
        for factor in term.factors.iter_mut().chain(&mut term.divisors) {
            let (negative, size) = self.values.signed(*factor);
            term.negative ^= negative;
            *factor = size;
        }
        term
    }

    fn product(&mut self, coefficient: &Number, factors: &[(Expr, i64)]) -> Value {
        let mut above = vec![self.values.constant(coefficient.to_f64())];
        let mut below = vec![];
        for (base, exponent) in factors {
            let (power, is_above) = self.integer_power(*base, *exponent);
            if is_above { above.push(power) } else { below.push(power) }
        }
        let (above, below) = (self.values.product(above), self.values.product(below));
        self.values.quotient(above, below)
    }

    /// A power, and whether it is a factor; otherwise it is a divisor.
    fn integer_power(&mut self, base: Expr, exponent: i64) -> (Value, bool) {
        let mut value = self.lower_form(base);
        let is_inverted = exponent < 0 && self.divisors.contains(&base);
        if is_inverted {
            let one = self.values.constant(1.0);
            value = self.values.quotient(one, value);
        }
        (self.values.integer_power(value, exponent.unsigned_abs()), exponent > 0 || is_inverted)
    }

    fn power(&mut self, base: Expr, exponent: Expr) -> Value {
        let value = self.lower_form(base);
        let half = self.graph.as_number(exponent).is_some_and(|e| e.to_fraction() == Some((1, 2)));
        if half {
            return self.values.add(Operation::Sqrt(value));
        }
        let exponent = self.lower_form(exponent);
        self.values.add(Operation::Power(value, exponent))
    }
}

impl Lowering<'_> {
    /// From now on these symbols are values that the program has computed.
    pub(super) fn replace(&mut self, computed: FxHashMap<Symbol, Value>) {
        self.computed.extend(computed);
    }
}
