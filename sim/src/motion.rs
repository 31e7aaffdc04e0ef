//! The equations of motion at one state.

use crate::failure::{Failure, What, constraint_name, largest};
use crate::solve::solve;
use crate::trajectory::State;
use sim_kernel::{Array, Dynamics, Mechanism};

/// Accelerations, multipliers and power at a state, by the generated elimination; where that refuses a pivot, by
/// complete pivoting on the mass matrix and the constraint Jacobian.
///
/// # Errors
/// [`What::Singular`] if no unique solution exists, [`What::NotFinite`] if an expression leaves its domain.
#[inline]
pub fn accelerate<M: Mechanism>(
    mechanism: &M,
    time: f64,
    q: &M::Q,
    qd: &M::Q,
) -> Result<Dynamics<f64, M::Q, M::L>, Failure> {
    let solved = mechanism.dynamics(time, q, qd);
    if !solved.refused && is_finite(&solved) {
        return Ok(solved);
    }
    accelerate_by_pivoting(mechanism, time, q, qd)
}

/// Whether all of a solution is.
#[inline(always)]
fn is_finite<Q: Array<f64>, L: Array<f64>>(solved: &Dynamics<f64, Q, L>) -> bool {
    let values = solved.accelerations.iter().chain(solved.multipliers.iter());
    values.chain([&solved.power]).all(|value| value.is_finite())
}

#[cold]
fn accelerate_by_pivoting<M: Mechanism>(
    mechanism: &M,
    time: f64,
    q: &M::Q,
    qd: &M::Q,
) -> Result<Dynamics<f64, M::Q, M::L>, Failure> {
    let fail = |what| Failure::at::<M>(what, time, q);
    let (n, m) = (M::Q::LEN, M::L::LEN);
    let mass = mechanism.mass_matrix(time, q);
    let jacobian = mechanism.constraint_jacobian(time, q);
    let (force, convective) = (mechanism.generalized_forces(time, q, qd), mechanism.convective_forces(time, q, qd));
    let constraint_convective = mechanism.constraint_convective(time, q, qd);
    let entry = |i: usize, j: usize| match (i < n, j < n) {
        (true, true) => mass[i][j],
        (true, false) => jacobian[j - n][i],
        (false, true) => jacobian[i - n][j],
        (false, false) => 0.0,
    };
    let matrix = M::ZZ::from_fn(|i| M::Z::from_fn(|j| entry(i, j)));
    let rhs = M::Z::from_fn(|i| if i < n { force[i] - convective[i] } else { -constraint_convective[i - n] });
    // Constraints first: what is wrong with them spoils the equations of the coordinates too.
    let is_sound = |row: &usize| matrix[*row].iter().sum::<f64>().is_finite() && rhs[*row].is_finite();
    if let Some(row) = (n..n + m).chain(0..n).find(|row| !is_sound(row)) {
        let quantity = match row < n {
            true => format!("the equation of {}", unknown_name::<M>(row)),
            false => format!("constraint `{}`", constraint_name::<M>(row - n)),
        };
        return Err(fail(What::NotFinite { quantity }));
    }
    let solution = solve(matrix, rhs)
        .map_err(|deficient| fail(What::Singular { unknown: unknown_name::<M>(deficient.unknown) }))?;
    let accelerations = M::Q::from_fn(|i| solution[i]);
    let multipliers = M::L::from_fn(|i| solution[n + i]);
    let power = mechanism.power(time, q, qd, &accelerations, &multipliers);
    if !power.is_finite() {
        return Err(fail(What::NotFinite { quantity: "the power of the loads".into() }));
    }
    Ok(Dynamics { accelerations, multipliers, power, refused: false })
}

fn unknown_name<M: Mechanism>(unknown: usize) -> String {
    match M::DESCRIPTION.coordinates.get(unknown) {
        Some(coordinate) => format!("the acceleration of `{}`", coordinate.position.name),
        None => format!("the reaction of `{}`", constraint_name::<M>(unknown - M::Q::LEN)),
    }
}

/// The largest magnitudes of C and of C_q q' + C_t at a state.
pub fn residuals<M: Mechanism>(mechanism: &M, state: &State<M>) -> (f64, f64) {
    let linear = mechanism.constraint_linearization(state.time, &state.positions);
    let rate = |i: usize| {
        let row: f64 = linear.jacobian[i].iter().zip(state.speeds.iter()).map(|(c, v)| c * v).sum();
        row + linear.time_derivative[i]
    };
    let rates = M::L::from_fn(rate);
    let size = |values: &M::L| largest(values.iter()).map_or(0.0, |(_, value)| value.abs());
    (size(&linear.values), size(&rates))
}
