//! From shared values to statements: which values get a statement, in which order, and under which name.
//!
//! A value used once stands inside the expression that uses it; one used more often, a sine or cosine, or one
//! whose expression would grow beyond a line, gets a statement of its own.

use super::names::Names;
use super::values::{ColumnsOperation, Leaves, Operation, Value, Values};
use super::{Columns, LookUp, Name, Statement, Tree, Wave};
use crate::symbolic::{Function, TableId};
use rustc_hash::FxHashMap;
use std::borrow::Cow;

/// The number of operations in one expression beyond which a part gets a name.
const LONGEST_EXPRESSION: usize = 14;
/// The order of the highest derivative of a table that is not zero.
const HIGHEST_DERIVATIVE: u8 = 3;

/// Preferred names for values.
pub(super) type Wishes<'a> = FxHashMap<Value, Cow<'a, str>>;

/// A schedule for the values that `roots` need.
pub(super) struct Schedule<'a> {
    values: &'a Values,
    labels: &'a Wishes<'a>,
    /// Which values get a statement.
    named: Vec<bool>,
    /// Angles by their depth of nested sines; those of a level are evaluated together.
    angles: Vec<Vec<Value>>,
    /// The level of each angle.
    levels: Vec<usize>,
    uses: Vec<usize>,
    local_names: Names,
    leaves: &'a Leaves,
    /// Names of what is stated.
    names: FxHashMap<Value, Name>,
    /// The statements, in order.
    pub(super) statements: Vec<Statement>,
}

impl<'a> Schedule<'a> {
    /// Schedules `roots` with all of their operands, and before them the needed values of `first`. `labels` are
    /// preferred names, `local_names` those still free.
    pub(super) fn new(
        values: &'a Values,
        first: &[Value],
        roots: &[Value],
        labels: &'a Wishes<'a>,
        leaves: &'a Leaves,
        local_names: Names,
    ) -> Schedule<'a> {
        let mut needed = values.reachable(roots, leaves);
        needed.retain(|value| !leaves.contains_key(value));
        let uses = count_uses(values, roots, &needed);
        let named = choose_named(values, &uses, &needed, leaves);
        let (levels, angles) = wave_levels(values, &needed);
        let (names, statements) = (FxHashMap::default(), vec![]);
        let mut schedule =
            Schedule { values, labels, named, angles, levels, uses, local_names, leaves, names, statements };
        // From the results backwards: values used together are computed together, and few stay alive for long.
        let is_needed = |value: &&Value| schedule.uses[value.index()] > 0 && !leaves.contains_key(value);
        let first: Vec<&Value> = first.iter().filter(is_needed).collect();
        for root in first.into_iter().chain(roots) {
            if schedule.named[root.index()] { schedule.state(*root) } else { schedule.require(*root) }
        }
        schedule
    }

    /// Emits the statement of a value that needs one and has none yet, after its operands.
    fn state(&mut self, value: Value) {
        if !self.named[value.index()] || self.names.contains_key(&value) {
            return;
        }
        if let Operation::Call(Function::Sin | Function::Cos, angle) = self.values.operation(value) {
            return self.state_waves(self.levels[angle.index()]);
        }
        if let Operation::Table(table, _, argument) = self.values.operation(value) {
            return self.look_up(*table, *argument);
        }
        if let Operation::Entry(matrix, ..) = self.values.operation(value) {
            return self.state(*matrix);
        }
        if let Operation::Columns(columns) = self.values.operation(value) {
            return self.state_columns(value, columns);
        }
        self.require(value);
        let tree = self.operation_tree(value);
        let name = self.give_name(value);
        self.statements.push(Statement::Let { name, value: tree });
    }

    /// Emits the statements that the expression of a value needs.
    fn require(&mut self, value: Value) {
        if self.leaves.contains_key(&value) {
            return;
        }
        let values = self.values;
        for operand in values.operands(value) {
            match self.named[operand.index()] {
                true => self.state(operand),
                false => self.require(operand),
            }
        }
    }

    /// Emits the sines and cosines of all angles of a level together.
    fn state_waves(&mut self, level: usize) {
        let angles = std::mem::take(&mut self.angles[level]);
        for angle in &angles {
            self.state(*angle);
            self.require(*angle);
        }
        let waves = angles.iter().map(|angle| {
            let argument = self.tree(*angle);
            let [sin, cos] = [Function::Sin, Function::Cos].map(|function| {
                let value = self.values.find(&Operation::Call(function, *angle))?;
                (self.uses[value.index()] > 0).then(|| self.give_name(value))
            });
            Wave { sin, cos, argument }
        });
        let waves = waves.collect();
        self.statements.push(Statement::SinCos(waves));
    }

    /// Emits a table at an argument with all needed derivatives.
    fn look_up(&mut self, table: TableId, argument: Value) {
        self.state(argument);
        self.require(argument);
        let tree = self.tree(argument);
        let mut names: Vec<Option<Name>> = (0..=HIGHEST_DERIVATIVE)
            .map(|order| {
                let value = self.values.find(&Operation::Table(table, order, argument))?;
                self.named[value.index()].then(|| self.give_name(value))
            })
            .collect();
        names.truncate(names.iter().rposition(Option::is_some).map_or(0, |last| last + 1));
        self.statements.push(Statement::Table(LookUp { table, names, argument: tree }));
    }

    /// Emits a system with its right-hand sides, and names for the solutions that are needed.
    fn state_columns(&mut self, value: Value, columns: &ColumnsOperation) {
        self.require(value);
        let ColumnsOperation { shape, operands } = columns;
        let trees: Vec<Tree> = operands.iter().map(|operand| self.tree(*operand)).collect();
        let (inverses, rest) = trees.split_at(shape.steps.len());
        let (entries, right_hand_sides) = rest.split_at(rest.len() - shape.steps.len() * shape.columns);
        let name = self.give_name(value);
        let names = (0..shape.steps.len()).map(|i| {
            let name = |j: usize| {
                let entry = self.values.find(&Operation::Entry(value, i, j))?;
                self.named[entry.index()].then(|| {
                    let wished = format!("{name}_{i}_{j}");
                    let name = self.local_names.unique(self.labels.get(&entry).map_or(&*wished, |wished| wished));
                    self.names.insert(entry, name.clone());
                    name
                })
            };
            (0..shape.columns).map(name).collect()
        });
        let names = names.collect();
        self.statements.push(Statement::Columns(Columns {
            shape: shape.clone(),
            inverses: inverses.to_vec(),
            entries: entries.to_vec(),
            right_hand_sides: right_hand_sides.chunks(shape.columns).map(<[Tree]>::to_vec).collect(),
            names,
        }));
    }

    fn give_name(&mut self, value: Value) -> Name {
        let name = match self.labels.get(&value) {
            Some(wished) => self.local_names.unique(wished),
            None => self.local_names.unique(self.derived_name(value).as_deref().unwrap_or("w")),
        };
        self.names.insert(value, name.clone());
        name
    }

    /// A descriptive name for the value, if it is short.
    fn derived_name(&self, value: Value) -> Option<String> {
        let known = |value: Value| match (self.leaves.get(&value), self.names.get(&value)) {
            (Some(Tree::Name(name) | Tree::Field(name)), _) | (_, Some(name)) => Some(&**name),
            _ => self.labels.get(&value).map(|name| &**name),
        };
        derived_name(self.values, value, known)
    }

    /// The expression of a value: its name, or its operation.
    pub(super) fn tree(&self, value: Value) -> Tree {
        match (self.leaves.get(&value), self.names.get(&value)) {
            (Some(leaf), _) => leaf.clone(),
            (_, Some(name)) => Tree::Name(name.clone()),
            _ => self.operation_tree(value),
        }
    }

    fn operation_tree(&self, value: Value) -> Tree {
        let boxed = |value: &Value| Box::new(self.tree(*value));
        match self.values.operation(value) {
            Operation::Constant(bits) => Tree::Constant(f64::from_bits(*bits)),
            // Every input is a leaf, and every table and matrix has a statement.
            Operation::Input(_) | Operation::Table(..) | Operation::Columns(_) | Operation::Entry(..) => {
                Tree::Constant(f64::NAN)
            }
            Operation::Sum(terms) => {
                Tree::Sum(terms.iter().map(|(negative, term)| (*negative, self.tree(*term))).collect())
            }
            Operation::Product(factors) => {
                let mut all = Vec::with_capacity(factors.len());
                for factor in factors {
                    // The factors of a product that stands inside another.
                    match self.tree(*factor) {
                        Tree::Product(factors) => all.extend(factors),
                        other => all.push(other),
                    }
                }
                Tree::Product(all)
            }
            Operation::Quotient(above, below) => Tree::Quotient(boxed(above), boxed(below)),
            Operation::Negate(operand) => Tree::Negate(boxed(operand)),
            Operation::Call(function, argument) => Tree::Method(function.name(), vec![self.tree(*argument)]),
            Operation::Sqrt(argument) => Tree::Method("sqrt", vec![self.tree(*argument)]),
            Operation::Power(base, exponent) => Tree::Method("powf", vec![self.tree(*base), self.tree(*exponent)]),
            Operation::Choice(difference, above, otherwise) => Tree::Method(
                "choose",
                [difference, above, otherwise].into_iter().map(|part| self.tree(*part)).collect(),
            ),
            Operation::Held(held, course) => Tree::Method("or", vec![self.tree(*held), self.tree(*course)]),
            Operation::Atan2(y, x) => Tree::Method("atan2", vec![self.tree(*y), self.tree(*x)]),
        }
    }
}

/// A descriptive name for a value, if it is short, from the names of its operands.
pub(super) fn derived_name<'a>(
    values: &Values,
    value: Value,
    known: impl Fn(Value) -> Option<&'a str>,
) -> Option<String> {
    let short = |value: Value| known(value).filter(|name| name.len() <= 24);
    match values.operation(value) {
        Operation::Call(function, argument) => Some(format!("{}_{}", function.name(), short(*argument)?)),
        Operation::Sqrt(argument) => Some(format!("sqrt_{}", short(*argument)?)),
        Operation::Columns(_) => Some("solved".to_owned()),
        Operation::Quotient(one, below) if values.is_constant(*one, 1.0) => Some(format!("inverse_{}", short(*below)?)),
        Operation::Product(factors) => match factors.as_slice() {
            [a, b] if a == b => Some(format!("{}_squared", short(*a)?)),
            _ => None,
        },
        _ => None,
    }
}

/// How often each value is an operand or a root; 0 for values that the roots do not need.
fn count_uses(values: &Values, roots: &[Value], needed: &[Value]) -> Vec<usize> {
    let mut uses = vec![0; values.len()];
    let operands = needed.iter().flat_map(|value| values.operands(*value));
    operands.chain(roots.iter().copied()).for_each(|value| uses[value.index()] += 1);
    uses
}

/// The depth of nested sines of each value, and the angles of each level.
fn wave_levels(values: &Values, needed: &[Value]) -> (Vec<usize>, Vec<Vec<Value>>) {
    let mut levels = vec![0; values.len()];
    let mut angles: Vec<Vec<Value>> = Vec::new();
    for value in needed.iter().copied() {
        let level = values.operands(value).map(|operand| levels[operand.index()]).max().unwrap_or(0);
        levels[value.index()] = level;
        if let Operation::Call(Function::Sin | Function::Cos, angle) = values.operation(value) {
            angles.resize(angles.len().max(level + 1), vec![]);
            if !angles[level].contains(angle) {
                angles[level].push(*angle);
            }
            levels[value.index()] = level + 1;
        }
    }
    (levels, angles)
}

fn choose_named(values: &Values, uses: &[usize], needed: &[Value], leaves: &Leaves) -> Vec<bool> {
    let mut named = vec![false; values.len()];
    let mut size = vec![0; values.len()];
    for value in needed.iter().copied() {
        let operands = values.operands(value);
        // An expression that is too long gives up its largest parts first.
        let weight = |size: &[usize], named: &[bool]| -> usize {
            operands.clone().map(|x| if named[x.index()] { 0 } else { size[x.index()] }).sum()
        };
        while weight(&size, &named) > LONGEST_EXPRESSION {
            let largest = operands.clone().filter(|x| !named[x.index()]).max_by_key(|x| size[x.index()]);
            let Some(largest) = largest.filter(|x| size[x.index()] > 0) else { break };
            named[largest.index()] = true;
        }
        let count = operands.clone().count();
        size[value.index()] = weight(&size, &named) + count.saturating_sub(1).max(count.min(1));
        let leaf = match values.operation(value) {
            Operation::Constant(_) | Operation::Input(_) => true,
            Operation::Negate(operand) => values.operands(*operand).next().is_none() || leaves.contains_key(operand),
            _ => false,
        };
        let several = matches!(
            values.operation(value),
            Operation::Call(Function::Sin | Function::Cos, _)
                | Operation::Table(..)
                | Operation::Columns(_)
                | Operation::Entry(..)
        );
        named[value.index()] = !leaf && (several || uses[value.index()] > 1);
    }
    named
}
