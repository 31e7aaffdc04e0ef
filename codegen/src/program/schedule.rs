//! From shared values to statements: what gets a name, in which order, and under which name.
//!
//! A value used once stands inside the expression that uses it; one used more often, a sine or cosine, or one
//! whose expression would grow beyond a line, gets a statement of its own.

use super::names::Names;
use super::values::{Input, Operation, Value, Values};
use super::{Statement, Tree};
use crate::symbolic::Function;
use rustc_hash::FxHashMap;

/// Operations in one expression, beyond which a part of it gets a name.
const LONGEST_EXPRESSION: usize = 14;

/// A schedule for the values that `roots` need.
pub(super) struct Schedule<'a> {
    values: &'a Values,
    names: FxHashMap<Value, String>,
    /// What was scheduled, in order.
    pub(super) statements: Vec<Statement>,
}

impl<'a> Schedule<'a> {
    /// Schedules everything that `roots` are made of. `labels` are names wished for; `inputs` the names of inputs.
    pub(super) fn new(
        values: &'a Values,
        roots: &[Value],
        labels: &FxHashMap<Value, String>,
        inputs: &FxHashMap<Input, String>,
        names: &mut Names,
    ) -> Schedule<'a> {
        let mut schedule = Schedule { values, names: FxHashMap::default(), statements: vec![] };
        let uses = count_uses(values, roots);
        for value in values.all().filter(|value| uses[value.index()] > 0) {
            if let Operation::Input(input) = values.operation(value)
                && let Some(name) = inputs.get(input)
            {
                schedule.names.insert(value, name.clone());
            }
        }
        let named = choose_named(values, &uses);
        for value in values.all().filter(|value| named[value.index()]) {
            if schedule.names.contains_key(&value) {
                continue;
            }
            schedule.state(value, &uses, labels, names);
        }
        schedule
    }

    /// The statement that computes a value, and its sine's or cosine's partner with it.
    fn state(&mut self, value: Value, uses: &[usize], labels: &FxHashMap<Value, String>, names: &mut Names) {
        let partner = self.partner(value).filter(|partner| uses[partner.index()] > 0);
        let mut name_of = |schedule: &Self, value: Value| {
            let wished = labels.get(&value).cloned().unwrap_or_else(|| schedule.derived_name(value, labels));
            names.unique(&wished)
        };
        let name = name_of(self, value);
        let tree = self.operation_tree(value);
        self.names.insert(value, name.clone());
        let Some(partner) = partner else {
            return self.statements.push(Statement::Let { name, value: tree });
        };
        let partner_name = name_of(self, partner);
        self.names.insert(partner, partner_name.clone());
        let Operation::Call(function, argument) = self.values.operation(value) else { return };
        let argument = self.tree(*argument);
        let (sin, cos) = if *function == Function::Sin { (name, partner_name) } else { (partner_name, name) };
        self.statements.push(Statement::SinCos { sin, cos, argument });
    }

    /// The cosine that belongs to a sine, and the other way round.
    fn partner(&self, value: Value) -> Option<Value> {
        match self.values.operation(value) {
            Operation::Call(Function::Sin, argument) => self.values.find(&Operation::Call(Function::Cos, *argument)),
            Operation::Call(Function::Cos, argument) => self.values.find(&Operation::Call(Function::Sin, *argument)),
            _ => None,
        }
    }

    /// A name that says what the value is, where that is short.
    fn derived_name(&self, value: Value, labels: &FxHashMap<Value, String>) -> String {
        let short = |value: &Value| {
            let name = self.names.get(value).or_else(|| labels.get(value))?;
            (name.len() <= 24).then(|| name.clone())
        };
        let name = match self.values.operation(value) {
            Operation::Call(function, argument) => short(argument).map(|name| format!("{}_{name}", function.name())),
            Operation::Sqrt(argument) => short(argument).map(|name| format!("sqrt_{name}")),
            Operation::Product(factors) => match factors.as_slice() {
                [a, b] if a == b => short(a).map(|name| format!("{name}_squared")),
                _ => None,
            },
            _ => None,
        };
        name.unwrap_or_else(|| "w".into())
    }

    /// The expression that stands for a value: its name, or what it is made of.
    pub(super) fn tree(&self, value: Value) -> Tree {
        match self.names.get(&value) {
            Some(name) if self.is_parameter(value) => Tree::Parameter(name.clone()),
            Some(name) => Tree::Name(name.clone()),
            None => self.operation_tree(value),
        }
    }

    /// A factor; the factors of a product that stands inside another.
    fn factors(&self, value: Value) -> Vec<Tree> {
        match self.tree(value) {
            Tree::Product(factors) => factors,
            other => vec![other],
        }
    }

    fn is_parameter(&self, value: Value) -> bool {
        matches!(self.values.operation(value), Operation::Input(Input::Parameter(_)))
    }

    fn operation_tree(&self, value: Value) -> Tree {
        let boxed = |value: &Value| Box::new(self.tree(*value));
        match self.values.operation(value) {
            Operation::Constant(bits) => Tree::Constant(f64::from_bits(*bits)),
            Operation::Input(_) => Tree::Constant(0.0),
            Operation::Sum(terms) => {
                Tree::Sum(terms.iter().map(|(negative, term)| (*negative, self.tree(*term))).collect())
            }
            Operation::Product(factors) => {
                Tree::Product(factors.iter().flat_map(|factor| self.factors(*factor)).collect())
            }
            Operation::Quotient(above, below) => Tree::Quotient(boxed(above), boxed(below)),
            Operation::Negate(operand) => Tree::Negate(boxed(operand)),
            Operation::Call(function, argument) => Tree::Method(function.name(), vec![self.tree(*argument)]),
            Operation::Sqrt(argument) => Tree::Method("sqrt", vec![self.tree(*argument)]),
            Operation::Power(base, exponent) => Tree::Method("powf", vec![self.tree(*base), self.tree(*exponent)]),
            Operation::Atan2(y, x) => Tree::Method("atan2", vec![self.tree(*y), self.tree(*x)]),
        }
    }
}

/// How often each value is an operand or a root; 0 for what the roots do not need.
fn count_uses(values: &Values, roots: &[Value]) -> Vec<usize> {
    let mut uses = vec![0; values.len()];
    for root in roots {
        uses[root.index()] += 1;
    }
    for value in values.all().rev() {
        if uses[value.index()] > 0 {
            for operand in values.operands(value) {
                uses[operand.index()] += 1;
            }
        }
    }
    uses
}

fn choose_named(values: &Values, uses: &[usize]) -> Vec<bool> {
    let mut named = vec![false; values.len()];
    let mut size = vec![0; values.len()];
    for value in values.all().filter(|value| uses[value.index()] > 0) {
        let operands = values.operands(value);
        // Too long an expression gives up its largest parts first.
        let weight = |size: &[usize], named: &[bool]| -> usize {
            operands.iter().map(|x| if named[x.index()] { 0 } else { size[x.index()] }).sum()
        };
        while weight(&size, &named) > LONGEST_EXPRESSION {
            let largest = operands.iter().filter(|x| !named[x.index()]).max_by_key(|x| size[x.index()]);
            let Some(largest) = largest.filter(|x| size[x.index()] > 0) else { break };
            named[largest.index()] = true;
        }
        size[value.index()] = weight(&size, &named) + operands.len().saturating_sub(1).max(operands.len().min(1));
        let leaf = match values.operation(value) {
            Operation::Constant(_) | Operation::Input(_) => true,
            Operation::Negate(operand) => values.operands(*operand).is_empty(),
            _ => false,
        };
        let wave = matches!(values.operation(value), Operation::Call(Function::Sin | Function::Cos, _));
        named[value.index()] = !leaf && (wave || uses[value.index()] > 1);
    }
    named
}
