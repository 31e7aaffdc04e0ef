//! Dead points that a run has passed.

use super::driven::Driven;
use super::system::{Law, System};
use crate::any::{Any, AnyMechanism};
use crate::interpolate::hermite;
use crate::root::find_root;
use crate::run::Run;
use crate::trajectory::State;
use sim_kernel::{Mechanism, Start};
use std::convert::Infallible;

/// A determinant this small beside the lengths of its columns has no sign.
const NOTHING: f64 = 1e-10;

/// A dead point that a motion has passed: here the independent coordinates do not determine the others, which go on upon
/// another branch: a knee that was bent to one side is bent to the other.
#[derive(Clone, Debug)]
pub struct DeadPoint<M: Mechanism> {
    /// The independent coordinates.
    pub of: Vec<&'static str>,
    /// When and where, from dense output.
    pub state: State<M>,
}

/// The dead points along a run of the coordinates whose values the declaration gives at the start, as many as there are
/// degrees of freedom: where det C_qd changes its sign between two rows, with C_qd the columns of the constraint
/// Jacobian of all other coordinates. None where the declaration gives fewer, or where constraints
/// hold between speeds or keep the norm of a quaternion, one component of which may change its sign at any time.
pub fn dead_points<M: Mechanism>(run: &Run<M>) -> Vec<DeadPoint<M>> {
    // Where events switch constraints, which coordinates are independent changes on the way.
    if !M::DESCRIPTION.conditionals.is_empty() || !M::DESCRIPTION.norm_constraints.is_empty() {
        return Vec::new();
    }
    let any = Any(&run.mechanism);
    let start = run.trajectory.samples.first().map(|sample| sample.state.positions);
    let independent = start.and_then(|start| independent(&any, start.as_ref(), run.mobility.degrees_of_freedom));
    let Some((independent, system)) = independent else { return Vec::new() };
    let redundant: Vec<usize> = system.redundant_rows(&run.mobility);
    let determinant =
        |state: &State<M>| relative_determinant(&system, &redundant, state.positions.as_ref(), state.time);
    let mut found = Vec::new();
    let mut last: Option<(usize, f64)> = None;
    let samples = &run.trajectory.samples;
    for (i, sample) in samples.iter().enumerate() {
        let value = determinant(&sample.state);
        // What is nearly zero has no sign.
        if !(value.abs() > NOTHING) {
            continue;
        }
        if let Some((before, known)) = last.filter(|(_, known)| known * value < 0.0) {
            let between = |fraction: f64| hermite(&samples[before], sample, fraction);
            let place = find_root(known, value, 1e-14, &mut |s| Ok::<f64, Infallible>(determinant(&between(s))));
            found.push(DeadPoint { of: independent.clone(), state: between(place.unwrap_or(1.0)) });
        }
        last = Some((i, value));
    }
    found
}

/// det C_qd without redundant rows, beside the lengths of the columns.
fn relative_determinant(system: &System, redundant: &[usize], q: &[f64], time: f64) -> f64 {
    let jacobian = system.linear(q, time).jacobian.remove_rows_at(redundant);
    let size: f64 = jacobian.column_iter().map(|column| column.norm()).product();
    jacobian.determinant() / size
}

/// The names of the independent coordinates, and the system in which they are held.
fn independent<'m>(
    mechanism: &'m dyn AnyMechanism,
    start: &[f64],
    freedoms: usize,
) -> Option<(Vec<&'static str>, System<'m>)> {
    let description = mechanism.description();
    let given = (0..start.len()).filter(|i| description.coordinates[*i].start == Start::Given);
    let chosen: Vec<usize> = given.take(freedoms).collect();
    if description.constraints.is_empty() || !description.speed_constraints.is_empty() {
        return None;
    }
    let law = |i: &usize| Law { driven: Driven::Coordinate(*i), start: 0.0, rate: 0.0 };
    let laws: Vec<Law> = chosen.iter().map(law).collect();
    let (system, _) = System::new(mechanism, laws.clone(), start).ok()?;
    let names = chosen.iter().map(|i| description.coordinates[*i].position.name).collect();
    Some((names, system.running(laws)))
}
