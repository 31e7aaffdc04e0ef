//! Trajectories as columns with names and units.

use crate::any::{Any, AnyMechanism, At};
use crate::trajectory::Trajectory;
use sim_kernel::{Description, Mechanism};
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

/// The columns of a trajectory: time, coordinates, speeds, accelerations, multipliers, outputs; in their units.
#[derive(Clone, Debug, PartialEq)]
pub struct Table {
    /// The columns, time first.
    pub columns: Vec<Column>,
    /// Where the outputs start.
    first_output: usize,
}

impl Table {
    /// The table of a trajectory that starts with this mechanism.
    pub fn of<M: Mechanism>(mechanism: &M, trajectory: &Trajectory<M>) -> Table {
        let rows = trajectory.with_mechanisms(mechanism).map(|(mechanism, sample)| {
            let at = At::sample(sample);
            (at, Any(&mechanism).outputs(at))
        });
        Table::from_rows(const { &M::DESCRIPTION }, &rows.collect::<Vec<_>>())
    }

    /// The table of samples with their outputs.
    fn from_rows(description: &'static Description, rows: &[(At<f64>, Vec<f64>)]) -> Table {
        let column = |name: String, unit: &'static str, factor: f64, value: &dyn Fn(&At<f64>) -> f64| Column {
            name,
            unit: unit.into(),
            values: rows.iter().map(|(at, _)| value(at) / factor).collect(),
        };
        let mut columns = vec![column("t".into(), "s", 1.0, &|at| at.time)];
        for (i, c) in description.coordinates.iter().enumerate() {
            let q = &c.position;
            columns.push(column(q.name.into(), q.unit, q.factor, &|at| at.positions[i]));
        }
        for (i, c) in description.coordinates.iter().enumerate() {
            columns.push(column(c.speed.name.into(), c.speed.unit, c.speed.factor, &|at| at.speeds[i]));
        }
        for (i, c) in description.coordinates.iter().enumerate() {
            let a = &c.acceleration;
            columns.push(column(a.name.into(), a.unit, a.factor, &|at| at.accelerations[i]));
        }
        for (i, c) in description.constraints.iter().enumerate() {
            columns.push(column(format!("lambda_{}", c.name), c.unit, c.factor, &|at| at.multipliers[i]));
        }
        let first_output = columns.len();
        for (i, o) in description.outputs.iter().enumerate() {
            let values = rows.iter().map(|(_, outputs)| outputs[i] / o.factor).collect();
            columns.push(Column { name: o.name.into(), unit: o.unit.into(), values });
        }
        Table { columns, first_output }
    }

    /// Puts columns of the same length before the outputs.
    pub(crate) fn insert_before_outputs(&mut self, columns: Vec<Column>) {
        let added = columns.len();
        self.columns.splice(self.first_output..self.first_output, columns);
        self.first_output += added;
    }

    /// A table of columns of one length, time first, that are no outputs.
    #[cfg(test)]
    pub(crate) fn from_columns(columns: Vec<Column>) -> Table {
        Table { first_output: columns.len(), columns }
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

    /// A column by name.
    pub fn column(&self, name: &str) -> Option<&Column> {
        self.columns.iter().find(|column| column.name == name)
    }
}
