//! From programs to instructions.

use super::allocate::{Sizes, allocate};
use super::in_place::in_place;
use super::instruction::{Instruction, LookUp, Wave, Waves};
use super::parts::{Parts, Place};
use super::schedule::scheduled;
use super::{Code, Field, Order, Returned};
use crate::kernel_id::{Argument, KernelId, Receiver};
use crate::model::Model;
use crate::program::{self, Entries, Kernel, Name, Program, Results, Statement, Tree};
use crate::symbolic::Function;
use crate::threads;
use rustc_hash::FxHashMap;

/// Every kernel of a program.
pub fn codes(model: &Model, program: &Program, order: Order) -> Vec<Code> {
    let of_mechanism: FxHashMap<&str, Field> = fields_of_mechanism(model).collect();
    let prepared = program.kernels.iter().find(|kernel| kernel.id == KernelId::Prepare);
    let of_prepared: FxHashMap<&str, Field> = prepared.into_iter().flat_map(fields_of_prepared).collect();
    let inputs: FxHashMap<&str, usize> =
        model.inputs.iter().enumerate().map(|(i, input)| (input.name.as_str(), i)).collect();
    let code = |kernel: &Kernel| {
        let fields = match kernel.id.signature().receiver {
            Receiver::Mechanism => &of_mechanism,
            Receiver::Prepared => &of_prepared,
        };
        Writer::new(fields, &inputs).code(kernel, order)
    };
    threads::map(&program.kernels, code)
}

fn fields_of_mechanism(model: &Model) -> impl Iterator<Item = (&str, Field)> {
    let parameters = model.parameters.iter().enumerate().map(|(i, p)| (p.name.as_str(), Field::Parameter(i)));
    let activities = model.conditionals.iter().enumerate().map(|(i, c)| (c.field.as_str(), Field::Activity(i)));
    parameters.chain(activities)
}

fn fields_of_prepared(prepare: &Kernel) -> Vec<(&str, Field)> {
    match &prepare.results {
        Results::Record(_, fields) => {
            fields.iter().enumerate().map(|(i, (name, _))| (name.as_str(), Field::Prepared(i))).collect()
        }
        _ => Vec::new(),
    }
}

/// Writes one kernel.
pub(super) struct Writer<'a> {
    fields_by_name: &'a FxHashMap<&'a str, Field>,
    inputs: &'a FxHashMap<&'a str, usize>,
    pub(super) names: FxHashMap<Name, Place>,
    constants: Vec<f64>,
    constants_by_bits: FxHashMap<u64, Place>,
    fields: Vec<Field>,
    arguments: Vec<(Argument, usize)>,
    locals: usize,
    results: usize,
    instructions: Vec<Instruction<Place>>,
    waves: Vec<Waves<Place>>,
    look_ups: Vec<LookUp<Place>>,
}

impl<'a> Writer<'a> {
    fn new(fields_by_name: &'a FxHashMap<&'a str, Field>, inputs: &'a FxHashMap<&'a str, usize>) -> Writer<'a> {
        Writer {
            fields_by_name,
            inputs,
            names: FxHashMap::default(),
            constants: Vec::new(),
            constants_by_bits: FxHashMap::default(),
            fields: Vec::new(),
            arguments: Vec::new(),
            locals: 0,
            results: 0,
            instructions: Vec::new(),
            waves: Vec::new(),
            look_ups: Vec::new(),
        }
    }

    fn code(mut self, kernel: &Kernel, order: Order) -> Code {
        // MINUS_ZERO and ONE.
        self.constant(-0.0);
        self.constant(1.0);
        self.load(kernel);
        kernel.pieces.iter().flat_map(|piece| &piece.statements).for_each(|statement| self.statement(statement));
        kernel.statements.iter().for_each(|statement| self.statement(statement));
        let (mut returned, mut pivots) = (Vec::new(), Some(Vec::new()));
        self.results("", &kernel.results, &mut returned, &mut pivots);
        let sizes = Sizes {
            constants: self.constants.len(),
            fields: self.fields.len(),
            arguments: self.arguments.len(),
            locals: self.locals,
            results: self.results,
        };
        let mut parts = in_place(Parts { instructions: self.instructions, waves: self.waves, look_ups: self.look_ups });
        if order == Order::Scheduled {
            parts.instructions = scheduled(&parts);
        }
        let done = allocate(&parts, sizes);
        for result in &mut returned {
            for row in &mut result.rows {
                *row = done.first_result + row.start..done.first_result + row.end;
            }
        }
        let register = |place| sizes.register(place, done.first_result);
        Code {
            kernel: kernel.id,
            constants: self.constants,
            fields: self.fields,
            arguments: self.arguments,
            registers: done.registers,
            instructions: done.instructions,
            waves: done.waves,
            look_ups: done.look_ups,
            results: returned,
            pivots: pivots.map(|pivots| pivots.into_iter().map(|pair| pair.map(register)).collect()),
        }
    }

    /// The arguments that the kernel needs.
    fn load(&mut self, kernel: &Kernel) {
        self.argument(Argument::Time, 0, &Argument::Time.name().into());
        let Entries { positions, speeds, accelerations, multipliers, generalized_speeds } = &kernel.entries;
        let all = [
            (Argument::Positions, positions),
            (Argument::Speeds, speeds),
            (Argument::Accelerations, accelerations),
            (Argument::Multipliers, multipliers),
            (Argument::GeneralizedSpeeds, generalized_speeds),
        ];
        for (argument, names) in all {
            let named = names.iter().enumerate().filter_map(|(i, name)| Some((i, name.as_ref()?)));
            named.for_each(|(i, name)| self.argument(argument, i, name));
        }
    }

    fn argument(&mut self, argument: Argument, entry: usize, name: &Name) {
        self.names.insert(name.clone(), Place::Argument(self.arguments.len()));
        self.arguments.push((argument, entry));
    }

    fn statement(&mut self, statement: &Statement) {
        match statement {
            Statement::Let { name, value } => {
                let place = self.value(value);
                self.names.insert(name.clone(), place);
            }
            Statement::SinCos(waves) => {
                let place = self.waves.len() as u32;
                let waves = waves.iter().map(|wave| {
                    let angle = self.value(&wave.argument);
                    Wave { angle, sin: self.named(wave.sin.as_ref()), cos: self.named(wave.cos.as_ref()) }
                });
                let waves = waves.collect();
                self.waves.push(waves);
                self.instructions.push(Instruction::Waves { place });
            }
            Statement::Table(program::LookUp { table, names, argument }) => {
                let (a, place) = (self.value(argument), self.look_ups.len() as u32);
                let to = std::array::from_fn(|order| self.named(names.get(order).and_then(Option::as_ref)));
                self.look_ups.push(LookUp { table: table.index(), to, count: names.len() });
                self.instructions.push(Instruction::LookUp { place, a });
            }
            Statement::Columns(columns) => self.columns(columns),
        }
    }

    pub(super) fn local(&mut self) -> Place {
        self.locals += 1;
        Place::Local(self.locals - 1)
    }

    /// A local of this name, or one that nothing reads.
    fn named(&mut self, name: Option<&Name>) -> Place {
        let place = self.local();
        if let Some(name) = name {
            self.names.insert(name.clone(), place);
        }
        place
    }

    /// Where the value of an expression is, after the instructions that compute it.
    pub(super) fn value(&mut self, tree: &Tree) -> Place {
        match tree {
            Tree::Constant(value) => self.constant(*value),
            Tree::Name(name) => self.names.get(name).copied().unwrap_or_else(|| self.constant(f64::NAN)),
            Tree::Field(name) => self.field(name),
            _ => {
                // Operands before the result, whose register may then be one of theirs.
                let instruction = self.operation(tree);
                let to = self.local();
                self.push(instruction, to)
            }
        }
    }

    fn constant(&mut self, value: f64) -> Place {
        let next = Place::Constant(self.constants.len());
        let place = *self.constants_by_bits.entry(value.to_bits()).or_insert(next);
        if place == next {
            self.constants.push(value);
        }
        place
    }

    fn field(&mut self, name: &Name) -> Place {
        // The program names no others.
        let Some(field) = self.fields_by_name.get(&**name).copied() else { return self.constant(f64::NAN) };
        let known = self.fields.iter().position(|known| *known == field);
        Place::Field(known.unwrap_or_else(|| {
            self.fields.push(field);
            self.fields.len() - 1
        }))
    }

    pub(super) fn push(&mut self, instruction: impl FnOnce(Place) -> Instruction<Place>, to: Place) -> Place {
        self.instructions.push(instruction(to));
        to
    }

    /// The last operation of an expression, after the instructions that compute its operands.
    fn operation(&mut self, tree: &Tree) -> Box<dyn FnOnce(Place) -> Instruction<Place>> {
        match tree {
            Tree::Constant(_) | Tree::Name(_) | Tree::Field(_) => {
                let a = self.value(tree);
                Box::new(move |to| Instruction::Copy { to, a })
            }
            Tree::Sum(terms) => self.sum(terms),
            Tree::Product(factors) => self.product(factors),
            Tree::Quotient(above, below) => {
                let (a, b) = (self.value(above), self.value(below));
                Box::new(move |to| Instruction::Divide { to, a, b })
            }
            Tree::Negate(operand) => {
                let a = self.value(operand);
                Box::new(move |to| Instruction::Negate { to, a })
            }
            Tree::Method(name, arguments) => self.method(name, arguments),
        }
    }

    /// Terms from the left to the right.
    fn sum(&mut self, terms: &[(bool, Tree)]) -> Box<dyn FnOnce(Place) -> Instruction<Place>> {
        let mut terms = terms.iter();
        let Some((negative, first)) = terms.next() else { return self.operation(&Tree::Constant(0.0)) };
        let mut last = match negative {
            true => self.operation(&Tree::Negate(Box::new(first.clone()))),
            false => self.operation(first),
        };
        // What stands somewhere already is added to from there.
        let is_there = !negative && matches!(first, Tree::Constant(_) | Tree::Name(_) | Tree::Field(_));
        let mut there = is_there.then(|| self.value(first));
        for (negative, term) in terms {
            let a = there.take().unwrap_or_else(|| {
                let to = self.local();
                self.push(last, to)
            });
            last = match (term, negative) {
                (Tree::Product(factors), _) if factors.len() > 1 => {
                    let (b, c) = self.last_factors(factors);
                    match negative {
                        true => Box::new(move |to| Instruction::SubtractProduct { to, a, b, c }),
                        false => Box::new(move |to| Instruction::AddProduct { to, a, b, c }),
                    }
                }
                _ => {
                    let b = self.value(term);
                    match negative {
                        true => Box::new(move |to| Instruction::Subtract { to, a, b }),
                        false => Box::new(move |to| Instruction::Add { to, a, b }),
                    }
                }
            };
        }
        last
    }

    fn product(&mut self, factors: &[Tree]) -> Box<dyn FnOnce(Place) -> Instruction<Place>> {
        match factors {
            [] => self.operation(&Tree::Constant(1.0)),
            [one] => self.operation(one),
            _ => {
                let (a, b) = self.last_factors(factors);
                Box::new(move |to| Instruction::Multiply { to, a, b })
            }
        }
    }

    /// The product of all factors but the last, from the left to the right, and the last one.
    fn last_factors(&mut self, factors: &[Tree]) -> (Place, Place) {
        let mut places = Vec::with_capacity(factors.len());
        for factor in factors {
            places.push(self.value(factor));
        }
        let last = places.pop().unwrap_or_else(|| self.constant(1.0));
        let mut places = places.into_iter();
        let mut product = places.next().unwrap_or_else(|| self.constant(1.0));
        for b in places {
            let (a, to) = (product, self.local());
            product = self.push(|to| Instruction::Multiply { to, a, b }, to);
        }
        (product, last)
    }

    fn method(&mut self, name: &str, arguments: &[Tree]) -> Box<dyn FnOnce(Place) -> Instruction<Place>> {
        if let ("or", [Tree::Field(held), course]) = (name, arguments) {
            let (input, a) = (self.inputs.get(&**held).copied().unwrap_or_default() as u32, self.value(course));
            return Box::new(move |to| Instruction::Held { input, to, a });
        }
        let places: Vec<Place> = arguments.iter().map(|argument| self.value(argument)).collect();
        match (name, places.as_slice()) {
            ("sqrt", &[a]) => Box::new(move |to| Instruction::SquareRoot { to, a }),
            ("powf", &[a, b]) => Box::new(move |to| Instruction::Power { to, a, b }),
            ("atan2", &[a, b]) => Box::new(move |to| Instruction::Atan2 { to, a, b }),
            ("choose", &[a, b, c]) => Box::new(move |to| Instruction::Choose { to, a, b, c }),
            (_, &[a, ..]) => match Function::ALL.into_iter().find(|function| function.name() == name) {
                Some(function) => Box::new(move |to| Instruction::Call { function, to, a }),
                None => self.operation(&Tree::Constant(f64::NAN)),
            },
            _ => self.operation(&Tree::Constant(f64::NAN)),
        }
    }

    /// A result, in the next register of those.
    fn result(&mut self, tree: &Tree) {
        let instruction = self.operation(tree);
        self.push_result(instruction);
    }

    fn push_result(&mut self, instruction: impl FnOnce(Place) -> Instruction<Place>) -> Place {
        self.results += 1;
        self.push(instruction, Place::Result(self.results - 1))
    }

    /// Where a value stands when the program ends. What it begins with stays where it is.
    fn kept(&mut self, tree: &Tree) -> Place {
        match self.value(tree) {
            a @ Place::Local(_) => self.push_result(|to| Instruction::Copy { to, a }),
            place => place,
        }
    }

    fn row<'t>(&mut self, entries: impl IntoIterator<Item = &'t Tree>) -> std::ops::Range<usize> {
        let start = self.results;
        for entry in entries {
            self.result(entry);
        }
        start..self.results
    }

    fn results(
        &mut self,
        name: &str,
        results: &Results<Tree>,
        returned: &mut Vec<Returned>,
        pivots: &mut Option<Vec<[Place; 2]>>,
    ) {
        let rows = match results {
            Results::Scalar(value) => vec![self.row([value])],
            Results::Vector(entries) => vec![self.row(entries)],
            Results::Matrix(_, rows) => rows.iter().map(|entries| self.row(entries)).collect(),
            Results::Sparse(shape, entries) => self.sparse(*shape, entries),
            Results::Record(_, fields) => {
                fields.iter().for_each(|(name, field)| self.results(name, field, returned, pivots));
                return;
            }
            Results::Refused(found) => {
                *pivots = found
                    .as_ref()
                    .map(|found| found.iter().map(|(pivot, terms)| [self.kept(pivot), self.kept(terms)]).collect());
                return;
            }
        };
        returned.push(Returned { name: name.to_owned(), rows });
    }

    /// A matrix by its entries that are not always 0.
    fn sparse(&mut self, [rows, columns]: [usize; 2], entries: &[([usize; 2], Tree)]) -> Vec<std::ops::Range<usize>> {
        let zero = Tree::Constant(0.0);
        let mut all = vec![vec![&zero; columns]; rows];
        entries.iter().for_each(|([i, j], entry)| all[*i][*j] = entry);
        all.into_iter().map(|row| self.row(row)).collect()
    }
}
