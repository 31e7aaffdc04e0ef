//! Kernels against the oracle, entry by entry: the one comparison of `sim verify`, the tests of kernels and the random declarations.

use super::error::Result;
use super::measured::Measured;
use super::motion::{Solution, Terms};
use super::{Oracle, State};

/// The results of a mechanism's kernels at one state, matrices row by row.
#[derive(Clone, Debug)]
pub struct Computed {
    /// T_q' M T_q \[n*n\].
    pub mass_matrix: Vec<f64>,
    /// T_q' M g \[n\].
    pub convective_forces: Vec<f64>,
    /// T_q' F \[n\].
    pub generalized_forces: Vec<f64>,
    /// C \[m\].
    pub constraints: Vec<f64>,
    /// C_q \[m*n\].
    pub constraint_jacobian: Vec<f64>,
    /// C_t \[m\].
    pub constraint_time_derivative: Vec<f64>,
    /// C'' without accelerations \[m\].
    pub constraint_convective: Vec<f64>,
    /// In joules.
    pub kinetic_energy: f64,
    /// The values that the actions of events set.
    pub event_values: Vec<f64>,
}

/// The results of the kernels for a state with its accelerations and multipliers.
#[derive(Clone, Debug)]
pub struct Observed {
    /// left - right of each event.
    pub events: Vec<f64>,
    /// Outputs in the order of declaration.
    pub outputs: Vec<f64>,
    /// In watts.
    pub power: f64,
}

/// The differences found so far.
#[derive(Clone, Debug)]
pub struct Comparison {
    least: f64,
    entries: Vec<Entry>,
}

/// The difference of an entry from the oracle's, which has this magnitude.
#[derive(Clone, Debug)]
struct Entry {
    term: &'static str,
    apart: f64,
    magnitude: f64,
}

impl Comparison {
    /// An entry is compared with its magnitude, and at least with this part of the largest magnitude of its term.
    pub fn new(least: f64) -> Comparison {
        Comparison { least, entries: Vec::new() }
    }

    /// Everything that follows from a state.
    ///
    /// # Errors
    /// As [`Oracle::terms`].
    pub fn enter(&mut self, found: &Computed, oracle: &Oracle, at: &State) -> Result<Terms> {
        let terms = oracle.terms(at)?;
        self.term("mass matrix", &found.mass_matrix, &terms.mass_matrix.concat());
        self.term("convective forces", &found.convective_forces, &terms.convective);
        self.term("generalised forces", &found.generalized_forces, &terms.applied_forces);
        self.term("constraints", &found.constraints, &terms.constraints);
        self.term("constraint Jacobian", &found.constraint_jacobian, &terms.constraint_jacobian.concat());
        self.term("C_t", &found.constraint_time_derivative, &terms.constraint_time_derivative);
        self.term("convective terms of constraints", &found.constraint_convective, &terms.constraint_convective);
        self.term("kinetic energy", &[found.kinetic_energy], &[terms.kinetic_energy]);
        self.term("what events set", &found.event_values, &oracle.event_values(at)?);
        Ok(terms)
    }

    /// Everything that follows from a state with its accelerations and multipliers.
    ///
    /// # Errors
    /// As [`Oracle::terms`].
    pub fn enter_solved(&mut self, found: &Observed, oracle: &Oracle, at: &State, solution: &Solution) -> Result<()> {
        self.term("events", &found.events, &oracle.events(at, solution)?);
        self.term("outputs", &found.outputs, &oracle.outputs(at, solution)?);
        self.term("power", &[found.power], &[oracle.power(at, solution)?]);
        Ok(())
    }

    /// The entries of a term. Entries without a value on both sides are not compared. An entry with a value on one side
    /// only counts as infinitely far, and so does a term with another number of entries.
    pub fn term(&mut self, term: &'static str, values: &[f64], expected: &[Measured]) {
        if values.len() != expected.len() {
            self.entries.push(Entry { term, apart: f64::INFINITY, magnitude: 1.0 });
        }
        for (value, Measured { value: right, magnitude }) in values.iter().zip(expected) {
            let apart = match (value.is_finite(), right.is_finite()) {
                (false, false) => continue,
                (true, true) => (value - right).abs(),
                _ => f64::INFINITY,
            };
            let magnitude = if magnitude.is_finite() { *magnitude } else { right.abs() };
            self.entries.push(Entry { term, apart, magnitude });
        }
    }

    /// The largest relative difference and its term; 0 and no term if all are equal.
    pub fn worst(&self) -> (f64, &'static str) {
        let mut largest: Vec<(&str, f64)> = Vec::new();
        for Entry { term, magnitude, .. } in &self.entries {
            match largest.iter_mut().find(|(known, _)| known == term) {
                Some((_, size)) => *size = size.max(*magnitude),
                None => largest.push((term, *magnitude)),
            }
        }
        let mut worst = (0.0, "");
        for Entry { term, apart, magnitude } in &self.entries {
            let size = largest.iter().find(|(known, _)| known == term).map_or(0.0, |(_, size)| *size);
            let relative = apart / magnitude.max(self.least * size).max(f64::MIN_POSITIVE);
            if relative > worst.0 {
                worst = (relative, term);
            }
        }
        worst
    }
}

/// |K z - r| of the oracle's equations at a solution z of the kernels, in eps n (|K||z| + |r|), in the largest norm. |r| is
/// the sum of the magnitudes of its terms, as each side computes it with its own rounding. Infinite where it is NaN.
pub fn residual(terms: &Terms, accelerations: &[f64], multipliers: &[f64]) -> f64 {
    let n = accelerations.len();
    let z = [accelerations, multipliers].concat();
    let (mut residual, mut matrix_norm, mut rhs_norm) = (0.0f64, 0.0f64, 0.0f64);
    for i in 0..z.len() {
        let row: Vec<f64> = match i.checked_sub(n) {
            None => {
                let reactions = terms.constraint_jacobian.iter().map(|row| &row[i]);
                terms.mass_matrix[i].iter().chain(reactions).map(|entry| entry.value).collect()
            }
            Some(k) => terms.constraint_jacobian[k].iter().map(|entry| entry.value).collect(),
        };
        let rhs = i.checked_sub(n).map_or_else(|| terms.generalized_forces[i], |k| -terms.constraint_convective[k]);
        let missing = (row.iter().zip(&z).map(|(k, z)| k * z).sum::<f64>() - rhs.value).abs();
        residual = if missing.is_nan() { f64::INFINITY } else { residual.max(missing) };
        matrix_norm = matrix_norm.max(row.iter().map(|k| k.abs()).sum());
        rhs_norm = rhs_norm.max(rhs.magnitude);
    }
    let largest = z.iter().fold(0.0f64, |largest, z| largest.max(z.abs()));
    let size = matrix_norm * largest + rhs_norm;
    residual / (f64::EPSILON * z.len() as f64 * size).max(f64::MIN_POSITIVE)
}

#[cfg(test)]
mod tests;
