//! Loads that jump with a speed and hold it at the jump, as Coulomb's dry friction does.

use crate::motion::Motion;
use crate::state::trajectory::State;
use sim_kernel::{Array, Mechanism, SwitchingKind};

/// How near to its jump a condition is, as a part of the change of it by speeds that count as 1.
const NEAR: f64 = 1e-3;
/// Conditions change by speeds of this part of those, and accelerations are asked for beside the jump by a hundred times that.
const PART: f64 = 1e-9;
const BESIDE: f64 = 100.0 * PART;

/// Whether a load jumps about here with a speed, and drives the motion back to the jump from both sides: it sticks there, and no step of
/// the equations of motion is right.
pub(super) fn sticks<M: Mechanism>(motion: &Motion<M>, at: &State<M>) -> bool {
    let (mechanism, scales) = (motion.mechanism(), motion.measures().coordinates());
    let conditions = mechanism.description().load_conditions;
    let values = |speeds: &M::Q| mechanism.load_conditions(at.time, &at.positions, speeds);
    let here = values(&at.speeds);
    let by = |k: usize, j: usize| {
        let faster = at.speeds.like(|i| if i == j { at.speeds[i] + PART * scales[i] } else { at.speeds[i] });
        (values(&faster)[k] - here[k]) / PART
    };
    let jumps = |k: &usize| conditions[*k].kind == SwitchingKind::Form && conditions[*k].table.is_none();
    (0..conditions.len()).filter(jumps).any(|k| {
        let slopes = at.speeds.like(|j| by(k, j));
        let size = slopes.iter().map(|slope| slope * slope).sum::<f64>().sqrt();
        if !(size > 0.0) || here[k].abs() > NEAR * size {
            return false;
        }
        // The rate of the condition where it has such a value.
        let rate_at = |value: f64| {
            let way = (value - here[k]) / (size * size);
            let speeds = at.speeds.like(|j| at.speeds[j] + way * slopes[j] * scales[j]);
            let there = motion.sample(State { speeds, ..at.clone() }).ok()?;
            Some((0..slopes.len()).map(|j| slopes[j] / scales[j] * there.accelerations[j]).sum::<f64>())
        };
        let [behind, ahead] = [-BESIDE * size, BESIDE * size].map(rate_at);
        behind.is_some_and(|rate| rate > 0.0) && ahead.is_some_and(|rate| rate < 0.0)
    })
}
