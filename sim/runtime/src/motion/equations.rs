//! The equations of motion at one state, solved: for accelerations and multipliers, and for impulses.

use crate::model::conditional::is_active;
use crate::motion::gimbal;
use crate::motion::least_norm::least_norm;
use crate::motion::measures::Measures;
use crate::motion::reduction::Reduction;
use crate::numerics::{
    power_of_two::power_of_two,
    solve::{Solved, solve},
};
use crate::state::failure::{Failure, What, constraint_name};
use sim_kernel::{Array, Dynamics, Mechanism};

/// M^-1 C_q' (C_q M^-1 C_q')^-1 r: the change of speeds by an impulse along the constraints that changes their rates by
/// r.
pub(crate) fn by_inertia<M: Mechanism>(
    mechanism: &M,
    time: f64,
    q: &M::Q,
    jacobian: &M::LQ,
    residual: &M::L,
) -> Result<M::Q, Failure> {
    Ok(impulse(mechanism, time, q, jacobian, (&q.like(|_| 0.0), residual))?.0)
}

/// That change, and its impulse, of a momentum too: x and y with [M C_q'; C_q 0] [x; y] = [p; r]. If constraints depend on each
/// other y is that of least norm, in SI units.
pub(crate) fn impulse<M: Mechanism>(
    mechanism: &M,
    time: f64,
    q: &M::Q,
    jacobian: &M::LQ,
    (momentum, residual): (&M::Q, &M::L),
) -> Result<(M::Q, M::L), Failure> {
    let matrix = saddle(mechanism, &mechanism.mass_matrix(time, q), jacobian);
    let n = mechanism.n();
    let rhs = M::Z::with_len(mechanism.n() + mechanism.m(), |i| if i < n { momentum[i] } else { residual[i - n] });
    let solution = solve_motion(mechanism, matrix, rhs, time, q)?;
    let found = residual.like(|i| solution.solution[n + i]);
    let impulses = match solution.undetermined().count() {
        0 => found,
        undetermined => least_norm(jacobian.clone(), &found, mechanism.m() - undetermined),
    };
    Ok((q.like(|i| solution.solution[i]), impulses))
}

/// [M C_q'; C_q 0].
fn saddle<M: Mechanism>(mechanism: &M, mass: &M::QQ, jacobian: &M::LQ) -> M::ZZ {
    let (n, size) = (mechanism.n(), mechanism.n() + mechanism.m());
    let entry = |i: usize, j: usize| match (i < n, j < n) {
        (true, true) => mass[i][j],
        (true, false) => jacobian[j - n][i],
        (false, true) => jacobian[i - n][j],
        (false, false) => 0.0,
    };
    M::ZZ::with_len(size, |i| M::Z::with_len(size, |j| entry(i, j)))
}

/// The solution of a system of so many accelerations, then multipliers. Where something is undetermined that has an equation,
/// as the system is, it is balanced first: that of a mechanism of micrometres has entries of a square of its size beside their
/// fourth powers, which no pivot tells from rounding unless the scales of both kinds of unknowns are known.
fn solve_balanced<A: Array<R>, R: Array<f64>>(matrix: A, rhs: R, n: usize) -> Solved<R> {
    let solved = solve(matrix.clone(), rhs.clone());
    let undetermined = solved.undetermined().count();
    // Those beyond the rank of reduced constraints.
    let without_equation = || (n..rhs.len()).filter(|k| matrix[*k].iter().all(|entry| *entry == 0.0)).count();
    if undetermined == 0 || undetermined == without_equation() {
        return solved;
    }
    let mut scale = rhs.like(|i| if i < n { 1.0 / power_of_two(matrix[i][i].abs().sqrt()) } else { 1.0 });
    for k in n..rhs.len() {
        scale[k] = 1.0 / power_of_two((0..n).map(|j| (matrix[k][j] * scale[j]).abs()).fold(0.0, f64::max));
    }
    let balanced = matrix.like(|i| matrix[i].like(|j| matrix[i][j] * scale[i] * scale[j]));
    let mut again = solve(balanced, rhs.like(|i| rhs[i] * scale[i]));
    if again.undetermined().count() >= undetermined {
        return solved;
    }
    again.solution = again.solution.like(|i| again.solution[i] * scale[i]);
    again
}

/// Solves for accelerations and multipliers. Reactions that no equation determines, because their constraints are
/// redundant, are zero here.
fn solve_motion<M: Mechanism>(
    mechanism: &M,
    matrix: M::ZZ,
    rhs: M::Z,
    time: f64,
    q: &M::Q,
) -> Result<Solved<M::Z>, Failure> {
    let fail =
        |unknown: usize| Failure::at(mechanism, What::Singular { unknown: unknown_name(mechanism, unknown) }, time, q);
    let solved = solve_balanced(matrix, rhs, mechanism.n());
    let acceleration = solved.undetermined().find(|unknown| *unknown < mechanism.n());
    match acceleration {
        Some(acceleration) => Err(fail(acceleration)),
        None if !solved.is_consistent => {
            // A released constraint has no equation, and contradicts nothing.
            let active = solved.undetermined().find(|unknown| is_active(mechanism, *unknown - mechanism.n()));
            Err(fail(active.or(solved.undetermined().next()).unwrap_or(0)))
        }
        None => Ok(solved),
    }
}

/// Accelerations, multipliers and power at a state, by the generated elimination; if that refuses a pivot, by complete
/// pivoting on the mass matrix and the constraint Jacobian.
///
/// # Errors
/// [`What::Singular`] if no unique solution exists, [`What::NotFinite`] if an expression leaves its domain.
#[inline(always)]
pub(crate) fn solve_equations<M: Mechanism>(
    mechanism: &M,
    prepared: &M::Prepared,
    time: f64,
    q: &M::Q,
    qd: &M::Q,
) -> Result<Dynamics<f64, M::Q, M::L>, Failure> {
    match planned::<M>(prepared, time, q, qd) {
        Some(solved) => Ok(solved),
        None => accelerate_by_pivoting(mechanism, None, time, q.clone(), qd.clone()),
    }
}

/// The solution by the generated elimination, unless that refuses a pivot.
#[inline(always)]
pub(crate) fn planned<M: Mechanism>(
    prepared: &M::Prepared,
    time: f64,
    q: &M::Q,
    qd: &M::Q,
) -> Option<Dynamics<f64, M::Q, M::L>> {
    let solved = M::prepared_dynamics(prepared, time, q, qd);
    (!solved.refused && is_finite(&solved)).then_some(solved)
}

/// Whether all of a solution is.
#[inline(always)]
fn is_finite<Q: Array<f64>, L: Array<f64>>(solved: &Dynamics<f64, Q, L>) -> bool {
    let all_finite = |values: &[f64]| values.iter().all(|value| value.is_finite());
    all_finite(solved.accelerations.as_ref()) && all_finite(solved.multipliers.as_ref()) && solved.power.is_finite()
}

/// The solution by complete pivoting, with redundant constraints according to measures, if these are given. By value, so that
/// other states stay in registers.
#[cold]
pub(crate) fn accelerate_by_pivoting<M: Mechanism>(
    mechanism: &M,
    redundant: Option<&Measures<M>>,
    time: f64,
    q: M::Q,
    qd: M::Q,
) -> Result<Dynamics<f64, M::Q, M::L>, Failure> {
    let (q, qd) = (&q, &qd);
    let fail = |what| Failure::at(mechanism, what, time, q);
    let (n, m) = (mechanism.n(), mechanism.m());
    let mass = mechanism.mass_matrix(time, q);
    let jacobian = mechanism.constraint_jacobian(time, q);
    let (force, convective) = (mechanism.generalized_forces(time, q, qd), mechanism.convective_forces(time, q, qd));
    let constraint_convective = mechanism.constraint_convective(time, q, qd);
    let system = |jacobian: &M::LQ, constraint_convective: &M::L| {
        let rhs = |i: usize| if i < n { force[i] - convective[i] } else { -constraint_convective[i - n] };
        (saddle(mechanism, &mass, jacobian), M::Z::with_len(mechanism.n() + mechanism.m(), rhs))
    };
    let (matrix, rhs) = system(&jacobian, &constraint_convective);
    // Constraints first: their errors spoil the equations of the coordinates too.
    let is_sound = |row: &usize| matrix[*row].iter().sum::<f64>().is_finite() && rhs[*row].is_finite();
    if let Some(row) = (n..n + m).chain(0..n).find(|row| !is_sound(row)) {
        let quantity = match row < n {
            true => format!("the equation of {}", unknown_name(mechanism, row)),
            false => format!("constraint `{}`", constraint_name(mechanism, row - n)),
        };
        return Err(fail(What::NotFinite { quantity }));
    }
    let reduction =
        redundant.map(|measures| (Reduction::new(mechanism, &jacobian, measures, measures.rank()), measures));
    let (matrix, rhs) = match &reduction {
        Some((reduction, _)) => system(&reduction.rows(&jacobian), &reduction.values(&constraint_convective)),
        None => (matrix, rhs),
    };
    let solved = solve_motion(mechanism, matrix, rhs, time, q);
    let solved = solved.map_err(|failure| gimbal::explained(failure, mechanism, time, q))?;
    let accelerations = q.like(|i| solved.solution[i]);
    let found = M::L::with_len(mechanism.m(), |i| solved.solution[n + i]);
    let multipliers = match (reduction, solved.undetermined().count()) {
        (Some((reduction, measures)), _) => reduction.multipliers(measures, &found),
        (None, 0) => found,
        (None, undetermined) => least_norm(jacobian, &found, m - undetermined),
    };
    let power = mechanism.power(time, q, qd, &accelerations, &multipliers);
    if !power.is_finite() {
        return Err(fail(What::NotFinite { quantity: "the power of the loads".into() }));
    }
    Ok(Dynamics { accelerations, multipliers, power, refused: false })
}

fn unknown_name<M: Mechanism>(mechanism: &M, unknown: usize) -> String {
    match mechanism.description().coordinates.get(unknown) {
        Some(coordinate) => format!("the acceleration of `{}`", coordinate.position.name),
        None => format!("the reaction of `{}`", constraint_name(mechanism, unknown - mechanism.n())),
    }
}
