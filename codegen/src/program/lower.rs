//! Symbolic expressions to program values.

use super::values::{Input, Operation, Value, Values};
use crate::symbolic::{Expr, Graph, Node, Number, Symbol};
use rustc_hash::FxHashMap;

/// Lowers expressions of one graph into one program.
pub(super) struct Lowering<'a> {
    graph: &'a Graph,
    inputs: &'a FxHashMap<Symbol, Input>,
    pub(super) values: Values,
    done: FxHashMap<Expr, Value>,
    computed: FxHashMap<Input, Value>,
}

impl<'a> Lowering<'a> {
    pub(super) fn new(graph: &'a Graph, inputs: &'a FxHashMap<Symbol, Input>) -> Lowering<'a> {
        Lowering {
            graph,
            inputs,
            values: Values::default(),
            done: FxHashMap::default(),
            computed: FxHashMap::default(),
        }
    }

    /// The value of an expression, if it has been lowered.
    pub(super) fn lowered(&self, expr: Expr) -> Option<Value> {
        self.done.get(&expr).copied()
    }

    pub(super) fn lower(&mut self, expr: Expr) -> Value {
        if let Some(done) = self.done.get(&expr) {
            return *done;
        }
        let graph = self.graph;
        let value = match graph.node(expr) {
            Node::Number(number) => self.values.constant(number.to_f64()),
            Node::Constant(constant) => self.values.constant(constant.to_f64()),
            Node::Symbol(symbol) => {
                let Some(input) = self.inputs.get(symbol).copied() else {
                    // The model has no other symbols; were there one, its value would be unknown.
                    return self.values.constant(f64::NAN);
                };
                self.computed.get(&input).copied().unwrap_or_else(|| self.values.add(Operation::Input(input)))
            }
            Node::Sum { constant, terms } => self.sum(constant, terms),
            Node::Product { coefficient, factors } => self.product(coefficient, factors),
            Node::Power { base, exponent } => self.power(*base, *exponent),
            Node::Call(function, argument) => {
                let argument = self.lower(*argument);
                self.values.add(Operation::Call(*function, argument))
            }
            Node::Atan2(y, x) => {
                let (y, x) = (self.lower(*y), self.lower(*x));
                self.values.add(Operation::Atan2(y, x))
            }
        };
        self.done.insert(expr, value);
        value
    }

    pub(super) fn lower_all(&mut self, exprs: &[Expr]) -> Vec<Value> {
        exprs.iter().map(|expr| self.lower(*expr)).collect()
    }

    fn sum(&mut self, constant: &Number, terms: &[(Expr, Number)]) -> Value {
        let mut values: Vec<(bool, Value)> = Vec::with_capacity(terms.len() + 1);
        for (term, coefficient) in terms {
            let value = self.lower(*term);
            let size = self.values.constant(coefficient.abs().to_f64());
            values.push((coefficient.is_negative(), self.values.product(vec![size, value])));
        }
        values.push((constant.is_negative(), self.values.constant(constant.abs().to_f64())));
        self.values.sum(values)
    }

    fn product(&mut self, coefficient: &Number, factors: &[(Expr, i64)]) -> Value {
        let mut above = vec![self.values.constant(coefficient.to_f64())];
        let mut below = vec![];
        for (base, exponent) in factors {
            let base = self.lower(*base);
            let power = self.values.integer_power(base, exponent.unsigned_abs());
            if *exponent > 0 { above.push(power) } else { below.push(power) }
        }
        let (above, below) = (self.values.product(above), self.values.product(below));
        self.values.quotient(above, below)
    }

    fn power(&mut self, base: Expr, exponent: Expr) -> Value {
        let value = self.lower(base);
        let half = self.graph.as_number(exponent).is_some_and(|e| e.to_fraction() == Some((1, 2)));
        if half {
            return self.values.add(Operation::Sqrt(value));
        }
        let exponent = self.lower(exponent);
        self.values.add(Operation::Power(value, exponent))
    }
}

impl Lowering<'_> {
    /// From now on these inputs are values that the program has computed.
    pub(super) fn replace_inputs(&mut self, replacements: FxHashMap<Input, Value>) {
        self.computed = replacements;
    }

    /// The inputs that values need.
    pub(super) fn inputs_of(&self, roots: &[Value]) -> Vec<Input> {
        let mut seen = vec![false; self.values.len()];
        let mut stack = roots.to_vec();
        let mut inputs = Vec::new();
        while let Some(value) = stack.pop() {
            if std::mem::replace(&mut seen[value.index()], true) {
                continue;
            }
            match self.values.operation(value) {
                Operation::Input(input) => inputs.push(*input),
                _ => stack.extend(self.values.operands(value)),
            }
        }
        inputs
    }
}
