//! Constraints at one state: a row that holds between positions, or one that holds between speeds.

use super::error::Result;
use super::interpret::Interpreter;
use super::jet::Jet;
use super::measured::{Measured, inner};
use super::setting::Setting;
use super::state::State;
use super::value::Value;
use crate::dsl::{Declaration, Equation, Unit};

/// One row w = 0 between speeds, w = A q' + b: either as declared, or the rate of a row C = 0 between positions.
#[derive(Clone, Debug)]
pub(super) struct ConstraintRow {
    /// C; zero for a row between speeds.
    pub(super) value: Measured,
    /// A \[n\]: C_q, or w_q'.
    pub(super) jacobian: Vec<Measured>,
    /// A for the rates of the auxiliary displacements.
    pub(super) by_auxiliary: Vec<Measured>,
    /// b: C_t, or w without speeds.
    pub(super) time_derivative: Measured,
    /// w' without accelerations.
    pub(super) convective: Measured,
    /// Whether it holds; if not, everything above is zero.
    pub(super) active: bool,
}

impl ConstraintRow {
    /// The row of a constraint that is released.
    fn released(self) -> ConstraintRow {
        let zeros = |row: &[Measured]| vec![Measured::ZERO; row.len()];
        ConstraintRow {
            value: Measured::ZERO,
            jacobian: zeros(&self.jacobian),
            by_auxiliary: zeros(&self.by_auxiliary),
            time_derivative: Measured::ZERO,
            convective: Measured::ZERO,
            active: false,
        }
    }
}

/// A constraint: one row, or the two of a vector.
pub(super) struct Constraint {
    pub(super) rows: Vec<ConstraintRow>,
}

/// All constraints of a declaration; `active` says for each one that events switch whether it holds.
pub(super) fn constraints(
    declaration: &Declaration,
    si_factor: &dyn Fn(&Unit) -> f64,
    at: &State,
    active: &[bool],
) -> Result<Vec<Constraint>> {
    let interpreter = |setting| Interpreter::new(declaration, si_factor, setting);
    let auxiliaries = declaration.auxiliary.len();
    let mut positions = interpreter(Setting::positions(at.time, at.parameters, at.coordinates, auxiliaries));
    let mut speeds = interpreter(Setting::speeds(at, auxiliaries));
    let mut switched = active.iter().copied();
    let constraint = |equation: &Equation| {
        let holds = equation.initially.is_none() || switched.next().unwrap_or(true);
        let rows: Vec<ConstraintRow> = match declaration.has_rates(equation) {
            true => rows(&speeds.difference(equation)?, |row| between_speeds(row, at, auxiliaries)),
            false => rows(&positions.difference(equation)?, |row| between_positions(row, at, auxiliaries)),
        };
        Ok(Constraint { rows: rows.into_iter().map(|row| if holds { row } else { row.released() }).collect() })
    };
    declaration.constraints.iter().map(constraint).collect()
}

fn rows(value: &Value, row: impl Fn(&Jet) -> ConstraintRow) -> Vec<ConstraintRow> {
    value.clone().components().iter().map(row).collect()
}

/// From C as a jet in (q, t, s).
fn between_positions(row: &Jet, at: &State, auxiliaries: usize) -> ConstraintRow {
    let n = at.speeds.len();
    ConstraintRow {
        value: row.value(),
        jacobian: row.gradient()[..n].to_vec(),
        by_auxiliary: row.gradient()[n + 1..].to_vec(),
        time_derivative: row.gradient()[n],
        convective: row.curvature(&at.rates(auxiliaries)),
        active: true,
    }
}

/// From w as a jet in (q, t, s, q', s').
fn between_speeds(row: &Jet, at: &State, auxiliaries: usize) -> ConstraintRow {
    let n = at.speeds.len();
    let (by_positions, by_speeds) = row.gradient().split_at(n + 1 + auxiliaries);
    let speeds: Vec<Measured> = at.speeds.iter().copied().map(Measured::given).collect();
    ConstraintRow {
        value: Measured::ZERO,
        jacobian: by_speeds[..n].to_vec(),
        by_auxiliary: by_speeds[n..].to_vec(),
        time_derivative: row.value() - inner(&by_speeds[..n], &speeds),
        convective: inner(by_positions, &at.rates(auxiliaries)),
        active: true,
    }
}
