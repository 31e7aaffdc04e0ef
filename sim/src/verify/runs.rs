//! Checks of whole runs.

use super::Check;
use crate::equations::residuals;
use crate::run::Run;
use sim_kernel::{Array, Mechanism};

/// The constraints of every sample, in positions and velocities.
pub fn constraint_residuals<M: Mechanism>(run: &Run<M>) -> Check {
    let (mut worst, mut meaning) = (0.0, String::from("largest |C| and |C_q q' + C_t|"));
    for (mechanism, sample) in run.trajectory.with_mechanisms(&run.mechanism) {
        let (position, velocity) = residuals(&mechanism, &sample.state);
        if !(position.max(velocity) <= worst) || position.is_nan() || velocity.is_nan() {
            worst = if position.is_nan() { f64::NAN } else { position.max(velocity) };
            meaning = format!(
                "largest |C| and |C_q q' + C_t|: {position:.1e}, {velocity:.1e} at t = {:.4} s",
                sample.state.time
            );
        }
    }
    Check { name: "constraints along the run", figure: worst, bound: 1e-9, meaning }
}

/// Kinetic energy less the work of loads and drives.
pub fn energy_balance<M: Mechanism>(run: &Run<M>) -> Check {
    let meaning = "change of kinetic energy less work and what events take, relative to the largest of them".into();
    Check { name: "energy and work", figure: run.energy_balance, bound: 1e-7, meaning }
}

/// Two runs of one mechanism.
pub fn runs_agree<M: Mechanism>(name: &'static str, one: &Run<M>, other: &Run<M>) -> Check {
    let (figure, worst) = difference(one, other);
    let meaning = format!("largest difference of a coordinate or speed, relative to its largest: `{worst}`");
    Check { name, figure, bound: 1e-6, meaning }
}

/// The largest difference of any coordinate or speed between two runs with the same rows, relative to the largest of each,
/// and whose it is.
pub fn difference<M: Mechanism>(one: &Run<M>, other: &Run<M>) -> (f64, &'static str) {
    let (a, b) = (&one.trajectory.samples, &other.trajectory.samples);
    if a.len() != b.len() {
        return (f64::INFINITY, "number of rows");
    }
    let mut found = (0.0, "");
    for i in 0..2 * M::Q::LEN {
        let coordinate = &M::DESCRIPTION.coordinates[i % M::Q::LEN];
        let is_speed = i >= M::Q::LEN;
        let value = |sample: &crate::Sample<M>| match is_speed {
            true => sample.state.speeds[i - M::Q::LEN],
            false => sample.state.positions[i],
        };
        let name = if is_speed { coordinate.speed.name } else { coordinate.position.name };
        let (mut largest, mut apart) = (0.0f64, 0.0f64);
        for (a, b) in a.iter().zip(b) {
            largest = largest.max(value(a).abs());
            apart = if (value(a) - value(b)).is_nan() { f64::NAN } else { apart.max((value(a) - value(b)).abs()) };
        }
        // A coordinate that only rounding moves is compared with its unit.
        let unit = if is_speed { coordinate.speed.factor } else { coordinate.position.factor };
        let relative = apart / largest.max(1e-3 * unit);
        if !(relative <= found.0) {
            found = (relative, name);
        }
    }
    found
}
