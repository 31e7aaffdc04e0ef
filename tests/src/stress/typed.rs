//! A linkage in one form, run without its type.

use sim::{Description, Driven, Mechanism, Settings, Start, Sweep, Table, declared_start, kinematics, run};
use std::panic::{AssertUnwindSafe, catch_unwind};

/// The forms of a linkage.
pub(crate) struct Linkage {
    pub(crate) name: &'static str,
    /// The first is what references are made of.
    pub(crate) forms: &'static [&'static dyn Form],
}

/// What is found: columns by name, in SI units.
#[derive(Clone)]
pub(crate) struct Found {
    pub(crate) names: Vec<String>,
    pub(crate) columns: Vec<Vec<f64>>,
}

/// Why there is no result.
#[derive(Clone, Debug, PartialEq)]
pub(crate) enum Refusal {
    /// The name of the failure, and what it says.
    Named(String, String),
    Panic(String),
}

/// A mechanism without its type. Parameters are given by name; the others keep their defaults.
pub(crate) trait Form: Sync {
    fn name(&self) -> &'static str;
    /// A run from the declared start: its outputs.
    fn run(&self, parameters: &[(String, f64)], settings: &Settings) -> Result<Found, Refusal>;
    /// The first body driven: its outputs, and the extremes of these.
    fn sweep(&self, parameters: &[(String, f64)], span: [f64; 3], rows: usize) -> Result<Found, Refusal>;
    /// Whether the angle of its first body is a coordinate, and so can be driven.
    fn is_driven(&self) -> bool;
}

/// A mechanism of a type: what makes it with its declared values.
pub(crate) struct Typed<M>(pub(crate) fn() -> M);

impl<M: Mechanism> Form for Typed<M> {
    fn name(&self) -> &'static str {
        self.0().description().name
    }

    fn run(&self, parameters: &[(String, f64)], settings: &Settings) -> Result<Found, Refusal> {
        run_of(&self.0(), parameters, settings)
    }

    fn sweep(&self, parameters: &[(String, f64)], span: [f64; 3], rows: usize) -> Result<Found, Refusal> {
        sweep_of(&self.0(), parameters, span, rows)
    }

    fn is_driven(&self) -> bool {
        first_angle(self.0().description()).is_some()
    }
}

fn run_of<M: Mechanism>(mechanism: &M, parameters: &[(String, f64)], settings: &Settings) -> Result<Found, Refusal> {
    let (mechanism, start) = declared(mechanism, parameters);
    caught(|| {
        let run = run(mechanism.clone(), &start, settings)?;
        match run.trajectory.failure {
            Some(failure) => Err(failure),
            None => Ok(found(&Table::of(&mechanism, &run.trajectory))),
        }
    })
}

fn sweep_of<M: Mechanism>(
    mechanism: &M,
    parameters: &[(String, f64)],
    [from, to, speed]: [f64; 3],
    rows: usize,
) -> Result<Found, Refusal> {
    let (mechanism, start) = declared(mechanism, parameters);
    let description = mechanism.description();
    let driven = first_angle(description).unwrap_or(Driven::Coordinate(0));
    let sweep = Sweep { driven, from, to, speed, steps: rows, held: vec![] };
    caught(|| {
        let swept = kinematics(mechanism.clone(), &start, &sweep)?;
        if let Some(failure) = swept.trajectory.failure {
            return Err(failure);
        }
        let mut found = found(&Table::of(&mechanism, &swept.trajectory));
        for (i, range) in swept.extremes.outputs.iter().enumerate() {
            found.names.push(format!("extreme_{}", description.outputs[i].name));
            found.columns.push(range.map_or(vec![f64::NAN; 2], |range| vec![range.least.value, range.greatest.value]));
        }
        Ok(found)
    })
}

/// The coordinate that is the angle of the first body.
fn first_angle(description: &'static Description) -> Option<Driven> {
    let named = |name: &str| description.coordinates.iter().position(|c| c.position.name == name);
    ["phi_0", "rel_0", "b_0_phi", "j_0", "a_0"].into_iter().find_map(named).map(Driven::Coordinate)
}

fn declared<M: Mechanism>(mechanism: &M, parameters: &[(String, f64)]) -> (M, Start<M>) {
    let mut values = mechanism.parameters();
    for (i, quantity) in mechanism.description().parameters.iter().enumerate() {
        if let Some((_, value)) = parameters.iter().find(|(name, _)| name == quantity.name) {
            values[i] = *value;
        }
    }
    let mechanism = mechanism.with_parameters(values);
    let start = declared_start(&mechanism);
    (mechanism, start)
}

/// The outputs of a table.
fn found(table: &Table) -> Found {
    let outputs = table.outputs();
    let names = outputs.iter().map(|column| column.name.clone()).collect();
    Found { names, columns: outputs.iter().map(|column| column.values.clone()).collect() }
}

/// What is found, with panics as refusals.
fn caught<T>(work: impl FnOnce() -> Result<T, sim::Failure>) -> Result<T, Refusal> {
    match catch_unwind(AssertUnwindSafe(work)) {
        Ok(found) => found.map_err(|failure| {
            let name = format!("{:?}", failure.what);
            let name = name.split([' ', '{', '(']).next().unwrap_or_default().to_owned();
            Refusal::Named(name, failure.to_string())
        }),
        Err(_) => Err(Refusal::Panic("panicked".to_owned())),
    }
}
