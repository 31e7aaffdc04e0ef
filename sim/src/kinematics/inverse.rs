//! Inverse dynamics: what drives must exert so that what they drive moves as prescribed.

use super::driven::Driven;
use super::system::{Law, System};
use crate::any::{Any, At, array};
use crate::failure::{Failure, What};
use crate::trajectory::{Sample, State};
use nalgebra::DVector;
use sim_kernel::Mechanism;

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
}

/// The same of a mechanism of any type, with what tells how well the drives determine it.
pub(super) struct AnyPrescribed {
    pub(super) time: f64,
    pub(super) positions: Vec<f64>,
    pub(super) speeds: Vec<f64>,
    pub(super) accelerations: Vec<f64>,
    pub(super) multipliers: Vec<f64>,
    pub(super) power: f64,
    pub(super) forces: Vec<f64>,
    /// det [C_q; y_q], of the constraints that do not depend on others.
    pub(super) determinant: f64,
    /// The length of each column of [C_q; y_q].
    pub(super) columns: Vec<f64>,
}

impl AnyPrescribed {
    pub(super) fn at(&self) -> At<'_, f64> {
        At {
            time: self.time,
            positions: &self.positions,
            speeds: &self.speeds,
            accelerations: &self.accelerations,
            multipliers: &self.multipliers,
        }
    }

    /// It as a sample of the mechanism's own type.
    pub(super) fn sample<M: Mechanism>(&self, mechanism: &M, work: f64) -> Sample<M> {
        let (positions, speeds) = (array(&self.positions), array(&self.speeds));
        Sample {
            state: State { time: self.time, positions, speeds, work },
            accelerations: array(&self.accelerations),
            multipliers: array(&self.multipliers),
            power: self.power,
            inputs: mechanism.inputs(),
        }
    }
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
    let any = Any(mechanism);
    let (system, _) = System::new(&any, laws, q.as_ref())?;
    let found = prescribed(&system.running(system.laws.clone()), q.as_ref(), time, accelerations)?;
    Ok(Prescribed { sample: found.sample(mechanism, 0.0), forces: found.forces })
}

/// The motion of a system at a position; accelerations that are left out are zero.
pub(super) fn prescribed(system: &System, q: &[f64], p: f64, accelerations: &[f64]) -> Result<AnyPrescribed, Failure> {
    let (mechanism, time) = (system.mechanism, system.time(p));
    let linear = system.linear(q, p);
    let determinant = linear.jacobian.determinant();
    let columns: Vec<f64> = linear.jacobian.column_iter().map(|column| column.norm()).collect();
    let is_singular = !(determinant.abs() > SINGULAR * columns.iter().product::<f64>());
    let factors = linear.jacobian.clone().lu();
    let solve = |rhs: &DVector<f64>| factors.solve(rhs).filter(|found| found.iter().all(|value| value.is_finite()));
    let singular = || system.singular(q, p);
    if is_singular {
        return Err(singular());
    }
    let qd = solve(&-linear.by_parameter).ok_or_else(singular)?;
    let mut open = -system.convective(q, qd.as_slice(), p);
    let first_drive = q.len() - system.laws.len();
    accelerations.iter().enumerate().for_each(|(k, value)| open[first_drive + k] += value);
    let qdd = solve(&open).ok_or_else(singular)?;
    let load = mechanism.generalized_forces(time, q, qd.as_slice());
    let rest = load - mechanism.convective_forces(time, q, qd.as_slice()) - mechanism.mass_matrix(time, q) * &qdd;
    if rest.iter().any(|value| !value.is_finite()) {
        return Err(mechanism.failure(What::NotFinite { quantity: "a load".into() }, time, q));
    }
    let multipliers = linear.jacobian.transpose().lu().solve(&rest).ok_or_else(singular)?;
    let (multipliers, reactions) = system.split(&multipliers, q, p);
    let forces: Vec<f64> = reactions.iter().map(|reaction| -reaction).collect();
    let driving: f64 = forces.iter().zip(&system.laws).map(|(force, law)| force * law.rate).sum();
    let [speeds, accelerations] = [qd, qdd].map(|values| values.as_slice().to_vec());
    let positions = q.to_vec();
    let mut found = AnyPrescribed {
        time,
        positions,
        speeds,
        accelerations,
        multipliers,
        power: driving,
        forces,
        determinant,
        columns,
    };
    found.power += mechanism.power(found.at());
    Ok(found)
}
