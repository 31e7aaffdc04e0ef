//! Inverse dynamics: what drives must exert so that what they drive moves as prescribed.

use super::driven::Driven;
use super::system::{Law, System};
use crate::failure::{Failure, What};
use crate::trajectory::{Sample, State};
use nalgebra::DVector;
use sim_kernel::{Array, Mechanism};

/// A determinant this small beside the product of its columns' lengths is zero: of what would be divided by it, fewer than
/// six digits were left.
pub(super) const SINGULAR: f64 = 1e-10;

/// A motion that drives prescribe.
#[derive(Clone, Debug)]
pub struct Prescribed<M: Mechanism> {
    /// The state with its accelerations, and the reactions of the constraints; its power is that of loads and drives.
    pub sample: Sample<M>,
    /// What each drive exerts on the mechanism, along what it drives: a torque in N*m for an angle, a force in N for a
    /// length.
    pub forces: Vec<f64>,
    /// det [C_q; y_q], of the constraints that do not depend on others.
    pub(super) determinant: f64,
    /// The length of each column of [C_q; y_q].
    pub(super) columns: M::Q,
}

/// The motion of a mechanism at a position, each of whose degrees of freedom a drive moves: drive k at the rate
/// `rates[k]`, which changes by `accelerations[k]`.
///
/// Speeds and accelerations solve [C_q; y_q] q' = [-C_t; rate - y_t] and its derivative; the drives' forces u are the
/// multipliers of their conditions, with the sign of a load: M q'' + C_q' lambda = Q - T_q' M g + y_q' u.
/// (de Jalón and Bayo, Kinematic and Dynamic Simulation of Multibody Systems, 1994, ch. 6.)
///
/// # Errors
/// [`What::NotDriven`] unless each degree of freedom has one drive; [`What::DriveSingular`] in a dead point of the drives;
/// [`What::NotOfPositions`], [`What::NotFinite`].
pub fn inverse_dynamics<M: Mechanism>(
    mechanism: &M,
    time: f64,
    q: &M::Q,
    drives: &[Driven],
    rates: &[f64],
    accelerations: &[f64],
) -> Result<Prescribed<M>, Failure> {
    let laws = drives.iter().zip(rates);
    let laws = laws.map(|(driven, rate)| Law { driven: *driven, start: 0.0, rate: *rate }).collect();
    let (system, _) = System::new(mechanism, laws, q)?;
    prescribed(&system.running(system.laws.clone()), q, time, accelerations)
}

/// The motion of a system at a position; accelerations that are left out are zero.
pub(super) fn prescribed<M: Mechanism>(
    system: &System<M>,
    q: &M::Q,
    p: f64,
    accelerations: &[f64],
) -> Result<Prescribed<M>, Failure> {
    let (mechanism, time) = (system.mechanism, system.time(p));
    let linear = system.linear(q, p);
    let determinant = linear.jacobian.determinant();
    let columns = M::Q::from_fn(|j| linear.jacobian.column(j).norm());
    let is_singular = !(determinant.abs() > SINGULAR * columns.iter().product::<f64>());
    let factors = linear.jacobian.clone().lu();
    let solve = |rhs: &DVector<f64>| factors.solve(rhs).filter(|found| found.iter().all(|value| value.is_finite()));
    let singular = || system.singular(q, p);
    if is_singular {
        return Err(singular());
    }
    let qd = as_array::<M>(&solve(&-linear.by_parameter).ok_or_else(singular)?);
    let mut open = -system.convective(q, &qd, p);
    let first_drive = M::Q::LEN - system.laws.len();
    accelerations.iter().enumerate().for_each(|(k, value)| open[first_drive + k] += value);
    let qdd = as_array::<M>(&solve(&open).ok_or_else(singular)?);
    let mass = mechanism.mass_matrix(time, q);
    let (load, convective) = (mechanism.generalized_forces(time, q, &qd), mechanism.convective_forces(time, q, &qd));
    let left = |i: usize| load[i] - convective[i] - (0..M::Q::LEN).map(|j| mass[i][j] * qdd[j]).sum::<f64>();
    let rest = DVector::from_fn(M::Q::LEN, |i, _| left(i));
    if rest.iter().any(|value| !value.is_finite()) {
        return Err(Failure::at::<M>(What::NotFinite { quantity: "a load".into() }, time, q));
    }
    let multipliers = linear.jacobian.transpose().lu().solve(&rest).ok_or_else(singular)?;
    let (lambda, reactions) = system.split(&multipliers, q, p);
    let forces: Vec<f64> = reactions.iter().map(|reaction| -reaction).collect();
    let driving: f64 = forces.iter().zip(&system.laws).map(|(force, law)| force * law.rate).sum();
    let power = mechanism.power(time, q, &qd, &qdd, &lambda) + driving;
    let state = State { time, positions: *q, speeds: qd, work: 0.0 };
    let sample = Sample { state, accelerations: qdd, multipliers: lambda, power, inputs: mechanism.inputs() };
    Ok(Prescribed { sample, forces, determinant, columns })
}

fn as_array<M: Mechanism>(values: &DVector<f64>) -> M::Q {
    M::Q::from_fn(|j| values[j])
}
