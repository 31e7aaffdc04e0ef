//! Trajectories as columns with names and units.

use crate::model::{AnyMechanism, At};
use crate::motion::typed::Any;
use crate::state::provenance::Provenance;
use crate::state::trajectory::Trajectory;
use sim_kernel::{Description, Mechanism, Quantity};
use std::borrow::Cow;

/// A column of a table.
#[derive(Clone, Debug, PartialEq)]
pub struct Column {
    /// Its name.
    pub name: String,
    /// The unit its values are in.
    pub unit: Cow<'static, str>,
    /// Its values, one for each sample.
    pub values: Vec<f64>,
}

impl Column {
    /// `name [unit]`.
    pub fn header(&self) -> String {
        format!("{} [{}]", self.name, self.unit)
    }
}

/// The columns of a trajectory: time, coordinates, speeds, accelerations, multipliers, the work of loads and drives, outputs;
/// in their units.
#[derive(Clone, Debug, PartialEq)]
pub struct Table {
    /// The columns, time first.
    pub columns: Vec<Column>,
    /// Where it comes from: what files and figures of it say.
    pub provenance: Provenance,
    /// The index of the first output.
    first_output: usize,
}

impl Table {
    /// The table of a trajectory that starts with this mechanism.
    #[inline(never)]
    pub fn of<M: Mechanism>(mechanism: &M, trajectory: &Trajectory<M>) -> Table {
        let mut rows = trajectory.with_mechanisms(mechanism).map(|(mechanism, sample)| {
            let at = At::sample(sample);
            (at, sample.state.work, Any(&mechanism).outputs(at))
        });
        Table::from_rows(mechanism.description(), trajectory.samples.len(), &mut rows)
    }

    /// The table of these samples with work and outputs. Rows, which may be millions, are never held twice.
    fn from_rows<'a>(
        description: &'static Description,
        count: usize,
        rows: &mut dyn Iterator<Item = (At<'a, f64>, f64, Vec<f64>)>,
    ) -> Table {
        let mut table = Table::empty(description, count);
        let factors: Vec<f64> = factors(description).collect();
        for (at, work, outputs) in rows {
            let At { time, positions, speeds, accelerations, multipliers } = at;
            let (time, work) = ([time], [work]);
            let values = [&time, positions, speeds, accelerations, multipliers, &work, &outputs].into_iter().flatten();
            for ((column, value), factor) in table.columns.iter_mut().zip(values).zip(&factors) {
                column.values.push(value / factor);
            }
        }
        table
    }

    /// Its columns, with room for so many rows.
    fn empty(description: &'static Description, count: usize) -> Table {
        let column = |name: Cow<'static, str>, unit: &'static str| Column {
            name: name.into_owned(),
            unit: unit.into(),
            values: Vec::with_capacity(count),
        };
        let of = |q: &Quantity| column(q.name.into(), q.unit);
        let mut columns = vec![column("t".into(), "s")];
        let coordinates = description.coordinates;
        columns.extend(coordinates.iter().map(|c| of(&c.position)));
        columns.extend(coordinates.iter().map(|c| of(&c.speed)));
        columns.extend(coordinates.iter().map(|c| of(&c.acceleration)));
        columns.extend(description.constraints.iter().map(|c| column(format!("lambda_{}", c.name).into(), c.unit)));
        columns.push(column(work_name(description).into(), "J"));
        let first_output = columns.len();
        columns.extend(description.outputs.iter().map(of));
        Table { columns, provenance: Provenance::of(description), first_output }
    }

    /// Puts columns of the same length before the outputs.
    pub(crate) fn insert_before_outputs(&mut self, columns: Vec<Column>) {
        let added = columns.len();
        self.columns.splice(self.first_output..self.first_output, columns);
        self.first_output += added;
    }

    /// A table of columns of one length, time first, without outputs.
    #[doc(hidden)]
    pub fn from_columns(columns: Vec<Column>) -> Table {
        Table { first_output: columns.len(), provenance: Provenance::default(), columns }
    }

    /// The times of the samples.
    pub fn times(&self) -> &[f64] {
        self.columns.first().map_or(&[], |column| &column.values)
    }

    /// The outputs, in the order of declaration.
    pub fn outputs(&self) -> &[Column] {
        &self.columns[self.first_output..]
    }

    /// The outputs that are not finite everywhere, each with the first time at which it is not.
    pub fn undefined_outputs(&self) -> Vec<(&str, f64)> {
        let first = |column: &Column| column.values.iter().position(|value| !value.is_finite());
        self.outputs().iter().filter_map(|column| Some((column.name.as_str(), self.times()[first(column)?]))).collect()
    }

    /// The same with the time and these columns alone, each by its name or, where `*` stands for anything, by a pattern.
    ///
    /// # Errors
    /// The first word that is the name of no column.
    pub fn choose<'w>(&self, words: &'w [String]) -> Result<Table, &'w str> {
        let are_asked = |column: &Column| words.iter().any(|word| is_like(word, &column.name));
        if let Some(word) = words.iter().find(|word| !self.columns.iter().any(|column| is_like(word, &column.name))) {
            return Err(word);
        }
        let chosen = |columns: &[Column]| columns.iter().filter(|column| are_asked(column)).cloned().collect();
        let (before, outputs) = self.columns.split_at(self.first_output);
        let (time, before) = before.split_at(1);
        let columns: Vec<Column> = [time.to_vec(), chosen(before), chosen(outputs)].concat();
        let first_output = columns.len() - outputs.iter().filter(|column| are_asked(column)).count();
        Ok(Table { columns, provenance: self.provenance.clone(), first_output })
    }

    /// The table of no samples of a mechanism: what its columns are called.
    pub fn headers(description: &'static Description) -> Table {
        Table::empty(description, 0)
    }

    /// A column by name.
    pub fn column(&self, name: &str) -> Option<&Column> {
        self.columns.iter().find(|column| column.name == name)
    }
}

/// Whether a name is like a pattern, in which `*` stands for any letters or none.
fn is_like(pattern: &str, name: &str) -> bool {
    match pattern.split_once('*') {
        None => pattern == name,
        Some((head, tail)) => {
            let rest = name.strip_prefix(head);
            rest.is_some_and(|rest| (0..=rest.len()).any(|k| rest.is_char_boundary(k) && is_like(tail, &rest[k..])))
        }
    }
}

/// The name of the column of work. Declared names have no hyphen.
fn work_name(description: &Description) -> &'static str {
    let coordinates = description.coordinates.iter().map(|coordinate| coordinate.position.name);
    let mut declared = coordinates.chain(description.outputs.iter().map(|output| output.name));
    if declared.any(|name| name == "work") { "work-done" } else { "work" }
}

/// Each column's unit in SI units.
fn factors(description: &Description) -> impl Iterator<Item = f64> {
    let coordinates = description.coordinates.iter();
    let positions = coordinates.clone().map(|c| c.position.factor);
    let speeds = coordinates.clone().map(|c| c.speed.factor);
    let accelerations = coordinates.map(|c| c.acceleration.factor);
    let multipliers = description.constraints.iter().map(|c| c.factor);
    let outputs = description.outputs.iter().map(|o| o.factor);
    let states = [1.0].into_iter().chain(positions).chain(speeds).chain(accelerations);
    states.chain(multipliers).chain([1.0]).chain(outputs)
}
