//! From the results of a kernel to the kernel.

use super::lifetimes::shorten_lifetimes;
use super::lower::Lowering;
use super::names::Names;
use super::notes::Notes;
use super::pieces::split;
use super::results::Results;
use super::schedule::{Schedule, Wishes};
use super::shared_products::{Moved, share_products};
use super::values::{Input, Leaves, Operation, Value, Values};
use super::{Entries, Kernel, Operations, Tree};
use crate::dynamics::EquationsOfMotion;
use crate::kernel_id::{Argument, Arguments, KernelId};
use crate::symbolic::{Expr, Symbol};
use rustc_hash::FxHashMap;

/// The source of a kernel.
struct Task<'a> {
    results: Results<Value>,
    /// The values computed before them.
    first: Vec<Value>,
    wishes: Wishes<'a>,
    leaves: Leaves,
}

impl<'a> Task<'a> {
    /// The same where values have moved.
    fn moved(
        moved: &Moved,
        results: &Results<Value>,
        notes: &Notes,
        mut wishes: Wishes<'a>,
        leaves: Leaves,
    ) -> Task<'a> {
        let new = |value: Value| moved.get(&value).copied();
        let mut new_wishes = Wishes::default();
        for (old, new) in moved {
            if let Some(name) = wishes.remove(old) {
                new_wishes.entry(*new).or_insert(name);
            }
        }
        Task {
            results: results.map(&mut |value| moved[value]),
            first: notes.order().filter_map(new).collect(),
            wishes: new_wishes,
            leaves: leaves.into_iter().filter_map(|(value, leaf)| Some((new(value)?, leaf))).collect(),
        }
    }
}

/// Plans the kernels of one mechanism.
pub(super) struct Planner<'a> {
    pub(super) equations: &'a EquationsOfMotion,
    inputs: FxHashMap<Symbol, Input>,
    definitions: FxHashMap<Symbol, Expr>,
    alternatives: &'a FxHashMap<Expr, Expr>,
    /// The squares of the norms of quaternions.
    divisors: Vec<Expr>,
    /// Preferred names for values of the model.
    labels: Vec<(Expr, String)>,
}

impl<'a> Planner<'a> {
    /// `alternatives` are other forms of expressions, used where they cost less.
    pub(super) fn new(equations: &'a EquationsOfMotion, alternatives: &'a FxHashMap<Expr, Expr>) -> Planner<'a> {
        let model = &equations.model;
        let mut inputs = FxHashMap::default();
        inputs.insert(model.time, Input::Time);
        inputs.extend(model.parameters.iter().enumerate().map(|(i, p)| (p.symbol, Input::Parameter(i))));
        inputs.extend(model.conditionals.iter().enumerate().map(|(i, c)| (c.symbol, Input::Activity(i))));
        for (i, c) in model.coordinates.iter().enumerate() {
            let levels = [
                (c.position, Input::Position(i)),
                (c.speed, Input::Speed(i)),
                (c.acceleration, Input::Acceleration(i)),
            ];
            inputs.extend(levels);
        }
        inputs.extend(model.constraints.iter().enumerate().map(|(i, c)| (c.multiplier, Input::Multiplier(i))));
        inputs.extend(
            model.generalized_speeds.iter().enumerate().map(|(i, speed)| (speed.symbol, Input::GeneralizedSpeed(i))),
        );
        inputs.extend(model.inputs.iter().enumerate().map(|(i, input)| (input.symbol, Input::Held(i))));
        if let Some(inverse) = &equations.inverse {
            let given = inverse.accelerations.iter().enumerate();
            inputs.extend(given.map(|(i, symbol)| (*symbol, Input::Acceleration(i))));
        }
        let courses = model.inputs.iter().map(|input| (input.symbol, input.course));
        let definitions = equations.intermediates.iter().flat_map(|y| {
            y.symbols.into_iter().zip([y.definition.position, y.definition.velocity, y.acceleration, y.time_derivative])
        });
        Planner {
            equations,
            inputs,
            definitions: definitions.chain(courses).chain(equations.shorthands.iter().copied()).collect(),
            alternatives,
            divisors: model.norms.iter().map(|norm| norm.square).collect(),
            labels: labels(equations),
        }
    }

    pub(super) fn lowering(&self) -> Lowering<'_> {
        Lowering::new(&self.equations.graph, &self.inputs, &self.definitions, self.alternatives, &self.divisors)
    }

    /// A kernel of its own, of the mechanism.
    pub(super) fn kernel(&self, id: KernelId, wanted: impl FnOnce(&mut Lowering) -> Results<Value>) -> Kernel {
        let mut lowering = self.lowering();
        let results = wanted(&mut lowering);
        self.finish(id, &lowering, &results, &Notes::default(), Leaves::default())
    }

    /// What a kernel computes, with the sizes of this mechanism; `more` is said of this kernel alone.
    pub(super) fn documentation(&self, kernel: KernelId, len: usize, more: &[(&str, String)]) -> String {
        let model = &self.equations.model;
        let rows_left = self.equations.speeds.as_ref().map_or(0, |speeds| speeds.rows.len());
        let sizes = [
            ("n", model.coordinates.len()),
            ("m", model.constraints.len()),
            ("p", model.parameters.len()),
            ("k", model.generalized_speeds.len()),
            ("r", rows_left),
            ("len", len),
        ];
        let sizes = sizes.map(|(word, size)| (word, size.to_string()));
        kernel.documentation(&[sizes.as_slice(), more].concat())
    }

    /// The kernel that returns `results`; `leaves` are known beside the inputs.
    pub(super) fn finish(
        &self,
        id: KernelId,
        lowering: &Lowering,
        results: &Results<Value>,
        notes: &Notes,
        leaves: Leaves,
    ) -> Kernel {
        let roots: Vec<Value> = results.entries().into_iter().copied().collect();
        let wishes = self.names_wished(lowering, notes);
        match share_products(&lowering.values, &roots, &leaves) {
            None => {
                let task =
                    Task { results: results.map(&mut |value| *value), first: notes.order().collect(), wishes, leaves };
                self.write(id, &lowering.values, task)
            }
            Some(shared) => {
                let task = Task::moved(&shared.moved, results, notes, wishes, leaves);
                self.write(id, &shared.values, task)
            }
        }
    }

    /// The kernel as statements.
    fn write(&self, id: KernelId, values: &Values, task: Task) -> Kernel {
        let Task { results, first, wishes, mut leaves } = task;
        let roots: Vec<Value> = results.entries().into_iter().copied().collect();
        let mut names = Names::new();
        if id.signature().arguments == Arguments::GeneralizedSpeeds {
            names.unique(Argument::GeneralizedSpeeds.name());
        }
        let entries = self.name_inputs(values, &roots, &mut names, &mut leaves);
        let schedule = Schedule::new(values, &first, &roots, &wishes, &leaves, names);
        let results = results.map(&mut |value| schedule.tree(*value));
        let statements = schedule.statements;
        let operations = Operations::of(&statements, &results);
        let docs = self.documentation(id, results.vector_len(), &[]);
        let (pieces, statements) = split(shorten_lifetimes(statements, &results), &results);
        Kernel { id, docs, entries, pieces, statements, results, operations }
    }

    /// Names for values: those of the user, then those of the method. The first wish for a value wins.
    pub(super) fn names_wished<'s>(&'s self, lowering: &Lowering, notes: &'s Notes) -> Wishes<'s> {
        let users = self.labels.iter().filter_map(|(expr, name)| Some((lowering.lowered(*expr)?, name)));
        let mut by_value = Wishes::default();
        for (value, name) in users.chain(notes.names()) {
            if let Some(opposite) = lowering.values.opposite(value) {
                by_value.entry(opposite).or_insert_with(|| format!("minus_{name}").into());
            }
            by_value.entry(value).or_insert(name.into());
        }
        by_value
    }

    /// Local names for the inputs that are needed, under the user's names where these are free.
    fn name_inputs(&self, values: &Values, roots: &[Value], names: &mut Names, leaves: &mut Leaves) -> Entries {
        let model = &self.equations.model;
        let needed: FxHashMap<Input, Value> = values
            .reachable(roots, leaves)
            .into_iter()
            .filter_map(|value| match values.operation(value) {
                Operation::Input(input) => Some((*input, value)),
                _ => None,
            })
            .collect();
        if let Some(time) = needed.get(&Input::Time) {
            leaves.insert(*time, Tree::Name("t".into()));
        }
        let mut field = |input: Input, name: &str| {
            needed.get(&input).map(|value| leaves.insert(*value, Tree::Field(name.into())));
        };
        for (i, parameter) in model.parameters.iter().enumerate() {
            field(Input::Parameter(i), &parameter.name);
        }
        for (i, conditional) in model.conditionals.iter().enumerate() {
            field(Input::Activity(i), &conditional.field);
        }
        for (i, held) in model.inputs.iter().enumerate() {
            field(Input::Held(i), &held.name);
        }
        let mut name = |input: Input, wished: [&str; 2]| {
            let value = needed.get(&input)?;
            let name = names.unique(&wished.concat());
            leaves.insert(*value, Tree::Name(name.clone()));
            Some(name)
        };
        let coordinates = || model.coordinates.iter().enumerate();
        let constraints = || model.constraints.iter().enumerate();
        Entries {
            positions: coordinates().map(|(i, c)| name(Input::Position(i), [&c.name, ""])).collect(),
            speeds: coordinates().map(|(i, c)| name(Input::Speed(i), [&c.name, "_dot"])).collect(),
            accelerations: coordinates().map(|(i, c)| name(Input::Acceleration(i), [&c.name, "_ddot"])).collect(),
            generalized_speeds: model
                .generalized_speeds
                .iter()
                .enumerate()
                .map(|(i, speed)| name(Input::GeneralizedSpeed(i), [&speed.name, ""]))
                .collect(),
            multipliers: constraints().map(|(i, c)| name(Input::Multiplier(i), ["lambda_", &c.name])).collect(),
        }
    }
}

/// Names for values of the model: those of the user's `let`s, and those of the method.
fn labels(equations: &EquationsOfMotion) -> Vec<(Expr, String)> {
    let model = &equations.model;
    let mut labels: Vec<(Expr, String)> = model.named.iter().map(|(name, expr)| (*expr, name.clone())).collect();
    labels.extend(
        model.inputs.iter().filter_map(|input| Some((equations.graph.existing(input.symbol)?, input.name.clone()))),
    );
    for y in &equations.intermediates {
        let rates = [y.definition.position, y.definition.velocity, y.definition.convective];
        let suffixes = ["", "_dot", "_convective"];
        labels.extend(rates.into_iter().zip(suffixes).map(|(expr, suffix)| (expr, format!("{}{suffix}", y.name))));
    }
    let names = variable_names(equations);
    for (i, row) in equations.tmt.mass_matrix.iter().enumerate() {
        labels.extend(row[..=i].iter().enumerate().map(|(j, expr)| (*expr, format!("mass_{}_{}", names[i], names[j]))));
    }
    for (row, constraint) in equations.constraints.jacobian.iter().zip(&model.constraints) {
        labels.extend(row.iter().enumerate().map(|(j, expr)| (*expr, format!("{}_by_{}", constraint.name, names[j]))));
    }
    labels.extend(equations.graph.look_ups().into_iter().map(|(expr, table, order)| {
        let derivative = ["", "_slope", "_curvature", "_third"][usize::from(order).min(3)];
        (expr, format!("{}{derivative}", equations.graph.table(table).name))
    }));
    labels
}

/// The names of coordinates and intermediates.
pub(super) fn variable_names(equations: &EquationsOfMotion) -> Vec<String> {
    let coordinates = equations.model.coordinates.iter().map(|c| c.name.clone());
    coordinates.chain(equations.intermediates.iter().map(|y| y.name.clone())).collect()
}
