//! The oracle against what is known without it: closed forms, a published mechanism, identities of mechanics.

mod andrews;
mod closed_forms;
mod identities;
mod language;
mod quick_return;

use codegen::dsl::{Declaration, Unit};
use codegen::oracle::{Measured, Oracle, Solution, State, Terms};
use codegen::parse;

type Outcome<T = ()> = Result<T, Box<dyn std::error::Error>>;

/// Some hundred operations went into each number compared, half an ulp (1.1e-16) each, most of them far smaller than the
/// magnitude: 1e-14 of it is more than their rounding and less than any fault. A state that was rounded to 53 bits from
/// more digits counts as one operation with each of its numbers.
const ROUNDING: f64 = 1e-14;

/// A mechanism with its default parameters.
struct Mechanism {
    declaration: Declaration,
}

/// Everything the oracle says of one state.
struct Answer {
    terms: Terms,
    solution: Solution,
    outputs: Vec<Measured>,
    power: Measured,
}

impl Mechanism {
    fn parse(text: &str) -> Outcome<Mechanism> {
        Ok(Mechanism { declaration: parse(text.parse()?)? })
    }

    fn oracle(&self) -> Oracle<'_> {
        Oracle::new(&self.declaration, &si_factor)
    }

    fn at(&self, time: f64, coordinates: &[f64], speeds: &[f64]) -> Outcome<Answer> {
        let oracle = self.oracle();
        let parameters = oracle.default_parameters()?;
        let state = State { time, parameters: &parameters, inputs: &[], coordinates, speeds };
        let terms = oracle.terms(&state)?;
        let solution = oracle.accelerations(&terms)?;
        let outputs = oracle.outputs(&state, &solution)?;
        let power = oracle.power(&state, &solution)?;
        Ok(Answer { terms, solution, outputs, power })
    }
}

/// The few units of these tests.
fn si_factor(unit: &Unit) -> f64 {
    match unit.text.as_str() {
        "mm" => 1e-3,
        "deg" => std::f64::consts::PI / 180.0,
        "rpm" => std::f64::consts::PI / 30.0,
        _ => 1.0,
    }
}

#[track_caller]
fn assert_value(found: Measured, expected: f64) {
    let error = (found.value - expected).abs();
    assert!(error <= ROUNDING * found.magnitude, "{} is not {expected}; magnitude {}", found.value, found.magnitude);
    assert!(found.magnitude >= found.value.abs(), "magnitude {} below |{}|", found.magnitude, found.value);
}

#[track_caller]
fn assert_values(found: &[Measured], expected: &[f64]) {
    assert_eq!(found.len(), expected.len(), "{found:?} is not {expected:?}");
    found.iter().zip(expected).for_each(|(found, expected)| assert_value(*found, *expected));
}

/// One row of a table of references.
struct Sample<'s> {
    names: Vec<&'s str>,
    values: Vec<f64>,
}

impl Sample<'_> {
    /// The entry of this name; NaN, which equals nothing, if there is none.
    fn get(&self, name: &str) -> f64 {
        self.names.iter().position(|n| *n == name).map_or(f64::NAN, |i| self.values[i])
    }
}

/// The rows of a table whose first line has the names.
fn samples(table: &str) -> Outcome<Vec<Sample<'_>>> {
    let mut lines = table.lines();
    let names: Vec<&str> = lines.next().ok_or("no first line")?.split(',').collect();
    let row = |line: &str| {
        let values = line.split(',').map(str::parse).collect::<Result<Vec<f64>, _>>()?;
        assert_eq!(values.len(), names.len());
        Ok(Sample { names: names.clone(), values })
    };
    lines.map(row).collect()
}
