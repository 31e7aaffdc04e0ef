//! Static equilibrium, and small motions about it.

use crate::any::{Any, AnyMechanism, At, array, below};
use crate::assemble::{Start, assemble};
use crate::failure::{Failure, What};
use crate::linearize::{Derivatives, linearize};
use crate::measures::Measures;
use crate::project::project;
use crate::trajectory::State;
use nalgebra::{Complex, DMatrix, DVector};
use sim_kernel::{Array, Mechanism};

/// A position in which a mechanism at rest stays.
#[derive(Clone, Debug)]
pub struct Equilibrium<M: Mechanism> {
    /// It, at rest at time 0.
    pub state: State<M>,
    /// The reactions there.
    pub multipliers: M::L,
    /// The eigenvalues of small motions about it, 2 for each degree of freedom, by imaginary part; a positive real part
    /// is unstable.
    pub eigenvalues: Vec<Complex<f64>>,
}

const MOST_STEPS: usize = 100;
/// Accelerations up to here, in SI units, are at rest.
const AT_REST: f64 = 1e-8;
/// So are those that the rounding of positions makes, in stiff mechanisms: q'' changes by q''_q times q times as many ulp.
const ROUNDINGS: f64 = 64.0;

/// The equilibrium near a start, by Newton's method on q''(q, 0) = 0 with C(q) = 0, in steps of least norm that are halved
/// until the residual falls.
///
/// # Errors
/// If the start cannot be assembled, or [`What::NoEquilibrium`].
pub fn equilibrium<M: Mechanism>(mechanism: &M, start: &Start<M>) -> Result<Equilibrium<M>, Failure> {
    let any: &dyn AnyMechanism = &Any(mechanism);
    let assembled = assemble(mechanism, &at_rest(start))?;
    let near = still_position(any, assembled.positions.as_ref().to_vec())?;
    let mut state = State { positions: array(&near), speeds: M::Q::filled(0.0), ..assembled };
    let measures = Measures::at(mechanism, assembled.time, &assembled.positions);
    project(mechanism, &measures, &mut state)?;
    state.speeds = M::Q::filled(0.0);
    let multipliers = check_rest(any, state.positions.as_ref())?;
    let eigenvalues = linearize(mechanism, &state, &[])?.eigenvalues;
    Ok(Equilibrium { state, multipliers: array(&multipliers), eigenvalues })
}

/// The same start with all coordinates free and no speeds.
fn at_rest<M: Mechanism>(start: &Start<M>) -> Start<M> {
    let none = vec![false; M::Q::LEN];
    Start { speeds: M::Q::filled(0.0), position_given: none.clone(), speed_given: none, ..start.clone() }
}

/// Where q'' and C are least, near a position.
fn still_position(mechanism: &dyn AnyMechanism, mut q: Vec<f64>) -> Result<Vec<f64>, Failure> {
    let mut residual = residual_at(mechanism, &q)?;
    for _ in 0..MOST_STEPS {
        let jacobian = jacobian_at(mechanism, &q)?;
        let Ok(step) = jacobian.svd(true, true).solve(&residual, 1e-12) else { break };
        let mut scale = 1.0;
        let better = loop {
            let trial: Vec<f64> = q.iter().zip(&step).map(|(q, step)| q - scale * step).collect();
            match residual_at(mechanism, &trial) {
                Ok(found) if found.norm() < residual.norm() => break Some((trial, found)),
                _ if scale < 1e-6 => break None,
                _ => scale /= 2.0,
            }
        };
        // At rounding no step is better.
        let Some(found) = better else { break };
        (q, residual) = found;
    }
    Ok(q)
}

/// That nothing accelerates at a position; gives the reactions there.
fn check_rest(mechanism: &dyn AnyMechanism, q: &[f64]) -> Result<Vec<f64>, Failure> {
    let (n, by_positions) = (q.len(), accelerations_by_positions(mechanism, q)?);
    let solution = mechanism.accelerate(At::moving(0.0, q, &[]))?;
    let (accelerations, multipliers) = solution.as_slice().split_at(n);
    let rounding = |i: usize| (0..n).map(|j| (by_positions[(i, j)] * q[j]).abs()).sum::<f64>();
    let moves = |i: usize| !(accelerations[i].abs() <= AT_REST + ROUNDINGS * f64::EPSILON * rounding(i));
    if (0..n).any(moves) {
        let acceleration = accelerations.iter().fold(0.0f64, |largest, a| largest.max(a.abs()));
        return Err(mechanism.failure(What::NoEquilibrium { acceleration }, 0.0, q));
    }
    Ok(multipliers.to_vec())
}

/// q'' and C.
fn residual_at(mechanism: &dyn AnyMechanism, q: &[f64]) -> Result<DVector<f64>, Failure> {
    let solution = mechanism.accelerate(At::moving(0.0, q, &[]))?;
    Ok(DVector::from_vec([&solution.as_slice()[..q.len()], mechanism.constraints(0.0, q).as_slice()].concat()))
}

fn jacobian_at(mechanism: &dyn AnyMechanism, q: &[f64]) -> Result<DMatrix<f64>, Failure> {
    let constraints = mechanism.between_positions(mechanism.constraint_jacobian(0.0, q));
    Ok(below(accelerations_by_positions(mechanism, q)?, constraints))
}

fn accelerations_by_positions(mechanism: &dyn AnyMechanism, q: &[f64]) -> Result<DMatrix<f64>, Failure> {
    let still = vec![0.0; q.len()];
    Ok(Derivatives::at(mechanism, At::moving(0.0, q, &still), &[])?.by_positions().rows(0, q.len()).into())
}
