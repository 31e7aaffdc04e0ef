//! Kinematic analysis: a mechanism with all of its freedoms driven, through a range of one of them.

mod algebra;
mod at_rest;
mod beside;
mod bounds;
mod breaks;
mod crossing;
mod driven;
mod extremes;
mod inverse;
mod locate;
mod motion;
mod path;
mod piece;
mod range;
mod search;
mod series;
mod sizes;
mod stand_in;
mod sweep;
mod system;
mod tabulate;
mod walk;

use crate::motion::measured::check_bodies;
use crate::motion::mobility::Mobility;
use crate::motion::typed::Any;
use crate::start::assemble::{Start, assemble};
use crate::state::failure::{Failure, What, constraint_name};
use crate::state::trajectory::Trajectory;
use inverse::AnyPrescribed;
use sim_kernel::{Array, Description, Mechanism};
use std::sync::atomic::AtomicBool;
use sweep::Swept;

pub use driven::Driven;
pub use extremes::{Extremes, TimeRatio};
pub use inverse::{Prescribed, inverse_dynamics};
pub use range::{Extreme, Range};
pub use sweep::{SpecialPosition, Sweep};
pub use {stand_in::prescribed_coordinate, tabulate::quotient};

/// The motion of a mechanism that is driven through a range.
#[derive(Clone, Debug)]
pub struct Kinematics<M: Mechanism> {
    /// The mechanism with its parameters.
    pub mechanism: M,
    /// The specification of the sweep.
    pub sweep: Sweep,
    /// The motion, with the reactions of the constraints. It ends with a failure in a limit position of the drive.
    pub trajectory: Trajectory<M>,
    /// The value of what is driven at each sample, in SI units.
    pub values: Vec<f64>,
    /// The force of the drive, and after it of each hold, on the mechanism at each sample: see [`Prescribed::forces`].
    pub forces: Vec<Vec<f64>>,
    /// The transmission index at each sample, from 0 in a dead point to 1.
    ///
    /// It is |det C_qd| over the product of the largest length that each column of C_qd has anywhere in the range,
    /// where C_qd are the columns of the constraint Jacobian that no drive holds (with redundant constraints, all rows
    /// count and the determinant is the volume spanned by the columns). It measures how well the drive determines the
    /// rest, relative to the best possible, as in Sutherland and Roth, A transmission index for spatial mechanisms (J.
    /// Eng. Ind. 95, 1973). For a four-bar linkage driven at its crank it is sin mu, with mu the transmission angle
    /// (Balli and Chand, Transmission angle in mechanisms, Mech. Mach. Theory 37, 2002), for a slider-crank sin mu over
    /// its largest value.
    pub transmission: Vec<f64>,
    /// At each sample dy/ds of each output y that has a rate ([`Description::rated_outputs`]), where s is what is driven, at fixed
    /// time: by virtual work the force of the drive over that at y, whatever else moves with time.
    pub ratios: Vec<Vec<f64>>,
    /// Degrees of freedom without drives and dependent constraints, at the start.
    pub mobility: Mobility,
    /// The positions where other branches cross the one that was followed.
    pub branches: Vec<SpecialPosition>,
    /// The limit position of the drive.
    pub limit: Option<SpecialPosition>,
    /// The least and greatest values of all quantities, and their positions.
    pub extremes: Extremes,
}

/// Drives a mechanism through a range, on the branch on which it is assembled.
///
/// With a speed of 0 the mechanism rests in each position, and time stands still at 0: forces are static, and what moves
/// with t has neither speed nor acceleration.
///
/// Positions by continuation along the curve of C(q, t) = 0 and the drives' conditions, in steps that adapt to its
/// direction and not to what is recorded; velocities, accelerations and reactions exactly from the kernels, by
/// [`inverse_dynamics`]. The given start values close the loops; from there drive and holds are first moved to the
/// beginning of the sweep.
///
/// The sweep replaces a constraint that prescribes the driven coordinate as a function of time; the drive's force is
/// then the reaction of that constraint.
///
/// # Errors
/// If the start cannot be assembled, if [`What::NotDriven`], [`What::NotHolonomic`] or, at rest, [`What::MovedByTime`], if an angle
/// is so large that its turns are lost in rounding ([`What::Unusable`]), or if the beginning of the sweep cannot be reached. A failure
/// that ends the sweep on the way does not lose it: it stands in the trajectory.
pub fn kinematics<M: Mechanism>(mechanism: M, start: &Start<M>, sweep: &Sweep) -> Result<Kinematics<M>, Failure> {
    kinematics_until(&AtomicBool::new(false), mechanism, start, sweep)
}

/// The same, but it ends, as a failure, once `interrupt` is true.
///
/// # Errors
/// As [`kinematics`].
#[inline(never)]
pub fn kinematics_until<M: Mechanism>(
    interrupt: &AtomicBool,
    mechanism: M,
    start: &Start<M>,
    sweep: &Sweep,
) -> Result<Kinematics<M>, Failure> {
    let sensible = sweep.steps > 0 && sweep.from != sweep.to;
    if !sensible || ![sweep.from, sweep.to, sweep.speed].iter().all(|value| value.is_finite()) {
        let quantity = "the way of the sweep or its speed".to_owned();
        return Err(Failure::at(&mechanism, What::NotFinite { quantity }, 0.0, &start.positions));
    }
    let checked = sweep.check_rounding(mechanism.description());
    checked.map_err(|what| Failure::at(&mechanism, what, 0.0, &start.positions))?;
    if let Some(row) = mechanism.description().speed_constraints.first() {
        let what = What::NotHolonomic { constraint: constraint_name(&mechanism, *row) };
        return Err(Failure::at(&mechanism, what, 0.0, &start.positions));
    }
    let none = vec![false; mechanism.n()];
    let still = Start { speeds: M::Q::repeat(mechanism.n(), 0.0), speed_given: none, ..start.clone() };
    let assembled = assemble(&mechanism, &still)?.positions;
    check_bodies(&mechanism, 0.0, &assembled)?;
    let any = Any(&mechanism);
    let swept = sweep::sweep(&any, assembled.as_ref().to_vec(), sweep, interrupt)?;
    let extremes = extremes::extremes(&swept, sweep);
    let transmission = transmission(&swept);
    let ratios = swept.motion.iter().map(|motion| motion.ratios(&swept.system)).collect();
    let work = work(&swept);
    let samples = swept.motion.iter().zip(work).map(|(motion, work)| motion.sample(&mechanism, work)).collect();
    let (values, forces) = drives(&swept);
    Ok(Kinematics {
        mechanism: mechanism.clone(),
        sweep: sweep.clone(),
        values,
        forces,
        transmission,
        ratios,
        extremes,
        mobility: swept.mobility.clone(),
        branches: swept.branches.clone(),
        limit: swept.limit.clone(),
        trajectory: Trajectory { samples, phases: vec![], failure: swept.failure.clone() },
    })
}

/// The values of what is driven, and the forces of each drive.
fn drives(swept: &Swept) -> (Vec<f64>, Vec<Vec<f64>>) {
    let law = swept.system.laws[0];
    let values = swept.motion.iter().map(|motion| law.at(motion.parameter)).collect();
    let forces = |k: usize| swept.motion.iter().map(|motion| motion.forces[k]).collect();
    (values, (0..swept.system.laws.len()).map(forces).collect())
}

/// The work of loads and drives, which is the change of kinetic energy; none at rest.
fn work(swept: &Swept) -> Vec<f64> {
    if swept.system.rests {
        return vec![0.0; swept.motion.len()];
    }
    let kinetic =
        |motion: &AnyPrescribed| swept.system.mechanism.kinetic_energy(motion.time, &motion.positions, &motion.speeds);
    let first = swept.motion.first().map_or(0.0, kinetic);
    swept.motion.iter().map(|motion| kinetic(motion) - first).collect()
}

/// See [`Kinematics::transmission`].
fn transmission(swept: &Swept) -> Vec<f64> {
    let largest = swept.found.largest_columns();
    swept.motion.iter().map(|motion| (motion.volume.ln() - largest).exp()).collect()
}

impl<M: Mechanism> Kinematics<M> {
    /// Whether the driven quantity is an angle that makes one whole turn, after which the mechanism is where it was.
    pub fn is_cycle(&self) -> bool {
        let samples = &self.trajectory.samples;
        let (Some(first), Some(last)) = (samples.first(), samples.last()) else { return false };
        let turns = |change: f64| (change / std::f64::consts::TAU - (change / std::f64::consts::TAU).round()).abs();
        let returns = |j: usize| {
            let change = last.state.positions[j] - first.state.positions[j];
            let is_angle = Driven::Coordinate(j).turn(self.mechanism.description()).is_some();
            if is_angle { turns(change) < 1e-9 } else { change.abs() < 1e-9 }
        };
        self.sweep.is_turn(self.mechanism.description())
            && self.trajectory.failure.is_none()
            && (0..self.mechanism.n()).all(returns)
    }
}

impl Sweep {
    /// Whether an angle is driven through one whole turn.
    pub fn is_turn(&self, description: &'static Description) -> bool {
        let turn = self.driven.turn(description);
        turn.is_some_and(|turn| ((self.to - self.from).abs() - turn).abs() <= 1e-9 * turn)
    }
}
