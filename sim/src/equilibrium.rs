//! Static equilibrium, and small motions about it.

use crate::assemble::{Start, assemble};
use crate::failure::{Failure, What};
use crate::level::between_positions;
use crate::linearize::linearize;
use crate::mobility::mobility;
use crate::motion::Motion;
use crate::settings::Stabilisation;
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
    let mut state = State { speeds: M::Q::filled(0.0), ..assemble(mechanism, &at_rest(start))? };
    let redundant = mobility(mechanism, state.time, &state.positions).dependent.len();
    let motion = Motion::with_redundant(mechanism, Stabilisation::Projection, redundant);
    let mut residual = residual_at(&motion, &state)?;
    for _ in 0..MOST_STEPS {
        let size = residual.norm();
        let jacobian = jacobian_at(&motion, &state)?;
        let Ok(step) = jacobian.svd(true, true).solve(&residual, 1e-12) else { break };
        let mut scale = 1.0;
        let better = loop {
            let positions = M::Q::from_fn(|i| state.positions[i] - scale * step[i]);
            let trial = State { positions, ..state };
            match residual_at(&motion, &trial) {
                Ok(residual) if residual.norm() < size => break Some((trial, residual)),
                _ if scale < 1e-6 => break None,
                _ => scale /= 2.0,
            }
        };
        // At rounding no step is better.
        let Some(found) = better else { break };
        (state, residual) = found;
    }
    motion.keep(&mut state)?;
    state.speeds = M::Q::filled(0.0);
    let sample = motion.sample(state)?;
    let (by_positions, _) = motion.jacobian(&sample)?;
    let rounding = |i: usize| (0..M::Q::LEN).map(|j| (by_positions[i][j] * state.positions[j]).abs()).sum::<f64>();
    let moves = |i: &usize| !(sample.accelerations[*i].abs() <= AT_REST + ROUNDINGS * f64::EPSILON * rounding(*i));
    if (0..M::Q::LEN).any(|i| moves(&i)) {
        let acceleration = sample.accelerations.iter().fold(0.0f64, |largest, a| largest.max(a.abs()));
        return Err(Failure::at::<M>(What::NoEquilibrium { acceleration }, state.time, &state.positions));
    }
    let eigenvalues = linearize(mechanism, &state, &[])?.eigenvalues;
    Ok(Equilibrium { state, multipliers: sample.multipliers, eigenvalues })
}

/// The same start with all coordinates free and no speeds.
fn at_rest<M: Mechanism>(start: &Start<M>) -> Start<M> {
    let none = vec![false; M::Q::LEN];
    Start { speeds: M::Q::filled(0.0), position_given: none.clone(), speed_given: none, ..start.clone() }
}

/// q'' and C.
fn residual_at<M: Mechanism>(motion: &Motion<M>, state: &State<M>) -> Result<DVector<f64>, Failure> {
    let sample = motion.sample(*state)?;
    let constraints = motion.mechanism().constraints(state.time, &state.positions);
    let values: Vec<f64> = sample.accelerations.iter().chain(constraints.iter()).copied().collect();
    Ok(DVector::from_vec(values))
}

fn jacobian_at<M: Mechanism>(motion: &Motion<M>, state: &State<M>) -> Result<DMatrix<f64>, Failure> {
    let (by_positions, _) = motion.jacobian(&motion.sample(*state)?)?;
    let constraints = between_positions::<M>(&motion.mechanism().constraint_jacobian(state.time, &state.positions));
    let n = M::Q::LEN;
    Ok(DMatrix::from_fn(n + M::L::LEN, n, |i, j| if i < n { by_positions[i][j] } else { constraints[i - n][j] }))
}
