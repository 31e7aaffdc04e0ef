//! A mechanism's declaration, parsed again: its oracle and its Lagrange's equations.

use super::VerifyError;
use crate::model::{AnyMechanism, At};
use codegen::dsl::{self, Declaration};
use codegen::dynamics::{Lagrange, lagrange};
use codegen::model::{self, Model, Resolved, Unit};
use codegen::oracle::{Measured, Oracle, OracleError, Solution};
use codegen::symbolic::Graph;
use sim_kernel::{Description, Input, Mechanism};

/// A declaration, read again, with Lagrange's equations of it.
pub struct Declared {
    declaration: Declaration,
    pub(super) model: Model,
    pub(super) graph: Graph,
    pub(super) lagrange: Lagrange,
}

impl Declared {
    /// That of a mechanism.
    ///
    /// # Errors
    /// If it cannot be read, which would be a mistake of the mechanism's description.
    pub fn of<M: Mechanism>(mechanism: &M) -> Result<Declared, VerifyError> {
        Declared::read(mechanism.description())
    }

    fn read(description: &Description) -> Result<Declared, VerifyError> {
        let fail = |e: &dyn std::fmt::Display| VerifyError::Declaration(e.to_string());
        let tokens = description.declaration.parse().map_err(|_| fail(&"its text cannot be read as Rust tokens"))?;
        let declaration = codegen::parse(tokens).map_err(|e| fail(&e))?;
        let Resolved { model, mut graph, .. } = model::resolve(&declaration).map_err(|e| fail(&e))?;
        let lagrange = lagrange(&mut graph, &model);
        Ok(Declared { declaration, model, graph, lagrange })
    }

    /// The oracle, with the constraints that the mechanism holds.
    pub(super) fn oracle(&self, mechanism: &dyn AnyMechanism) -> Oracle<'_> {
        let active = mechanism.activities().iter().map(|activity| *activity != 0.0).collect();
        Oracle::new(&self.declaration, &si_factor).with_active(active)
    }
}

fn si_factor(unit: &dsl::Unit) -> f64 {
    Unit::resolve(unit).map_or(f64::NAN, |unit| unit.factor())
}

/// The value that each input of a mechanism is set to.
pub(super) fn held(mechanism: &dyn AnyMechanism) -> Vec<Option<f64>> {
    mechanism.inputs().into_iter().map(Input::held).collect()
}

pub(super) fn uninterpreted(error: OracleError) -> VerifyError {
    VerifyError::Declaration(error.to_string())
}

/// Accelerations and multipliers for the oracle.
pub(super) fn solution_of(accelerations: &[f64], multipliers: &[f64]) -> Solution {
    let given = |values: &[f64]| values.iter().map(|value| Measured::given(*value)).collect();
    Solution { accelerations: given(accelerations), multipliers: given(multipliers) }
}

/// The accelerations and multipliers that the kernels give at a state.
pub(super) fn solved(mechanism: &dyn AnyMechanism, at: &At<f64>) -> Result<Solution, VerifyError> {
    let found = mechanism.accelerate(*at)?;
    let (accelerations, multipliers) = found.as_slice().split_at(at.positions.len());
    Ok(solution_of(accelerations, multipliers))
}
