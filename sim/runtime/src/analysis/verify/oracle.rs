//! The kernels against the oracle, term by term.

use super::declared::{Declared, held, solution_of, uninterpreted};
use super::{Check, VerifyError, places};
use crate::model::{AnyMechanism, At};
use crate::motion::typed::Any;
use crate::state::trajectory::Sample;
use codegen::oracle::{Comparison, Computed, Observed, State};
use nalgebra::DMatrix;
use sim_kernel::Mechanism;

/// The largest difference of a term, relative to the magnitudes of its operands.
const TERM: f64 = 1e-12;

/// A term this small relative to the largest of its name, such as a power where nothing moves, may be rounding from
/// cancellation.
const VANISHING: f64 = 1e-2;

/// Mass matrix, forces, constraints with their derivatives, kinetic energy, events, power and outputs, against
/// the oracle.
///
/// # Errors
/// If the oracle cannot interpret the declaration.
pub fn kernels_against_oracle<M: Mechanism>(
    mechanism: &M,
    declared: &Declared,
    samples: &[Sample<M>],
) -> Result<Check, VerifyError> {
    compare_with_oracle(&Any(mechanism), declared, &places(samples))
}

pub(super) fn compare_with_oracle(
    mechanism: &dyn AnyMechanism,
    declared: &Declared,
    samples: &[At<f64>],
) -> Result<Check, VerifyError> {
    let mut comparison = Comparison::new(VANISHING);
    let (oracle, parameters, inputs) = (declared.oracle(mechanism), mechanism.parameters(), held(mechanism));
    for sample in samples {
        let (coordinates, speeds) = (sample.positions, sample.speeds);
        let at = State { time: sample.time, parameters: &parameters, inputs: &inputs, coordinates, speeds };
        comparison.enter(&computed_by(mechanism, sample), &oracle, &at).map_err(uninterpreted)?;
        let solution = solution_of(sample.accelerations, sample.multipliers);
        comparison.enter_solved(&observed_by(mechanism, sample), &oracle, &at, &solution).map_err(uninterpreted)?;
    }
    let (worst, term) = comparison.worst();
    let meaning = match term {
        "" => "largest difference relative to the magnitudes of terms".into(),
        term => format!("largest difference relative to the magnitudes of terms: {term}"),
    };
    Ok(Check::new("kernels against the oracle", worst, TERM, meaning))
}

/// The results of a mechanism's kernels at a state, in the form of the oracle's comparison.
pub fn computed<M: Mechanism>(mechanism: &M, t: f64, q: &M::Q, qd: &M::Q) -> Computed {
    computed_by(&Any(mechanism), &At::moving(t, q.as_ref(), qd.as_ref()))
}

/// Their results with these accelerations and multipliers.
pub fn observed<M: Mechanism>(mechanism: &M, t: f64, q: &M::Q, qd: &M::Q, qdd: &M::Q, lambda: &M::L) -> Observed {
    let (accelerations, multipliers) = (qdd.as_ref(), lambda.as_ref());
    observed_by(&Any(mechanism), &At { accelerations, multipliers, ..At::moving(t, q.as_ref(), qd.as_ref()) })
}

fn computed_by(mechanism: &dyn AnyMechanism, at: &At<f64>) -> Computed {
    let (t, q, qd) = (at.time, at.positions, at.speeds);
    // Entries of matrices here are by columns.
    let by_rows = |matrix: DMatrix<f64>| matrix.transpose().as_slice().to_vec();
    Computed {
        mass_matrix: by_rows(mechanism.mass_matrix(t, q)),
        convective_forces: mechanism.convective_forces(t, q, qd).as_slice().to_vec(),
        generalized_forces: mechanism.generalized_forces(t, q, qd).as_slice().to_vec(),
        constraints: mechanism.constraints(t, q).as_slice().to_vec(),
        constraint_jacobian: by_rows(mechanism.constraint_jacobian(t, q)),
        constraint_time_derivative: mechanism.constraint_time_derivative(t, q).as_slice().to_vec(),
        constraint_convective: mechanism.constraint_convective(t, q, qd).as_slice().to_vec(),
        kinetic_energy: mechanism.kinetic_energy(t, q, qd),
        event_values: mechanism.event_values(*at),
    }
}

fn observed_by(mechanism: &dyn AnyMechanism, at: &At<f64>) -> Observed {
    Observed { events: mechanism.events(*at), outputs: mechanism.outputs(*at), power: mechanism.power(*at) }
}
