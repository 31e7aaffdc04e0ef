//! Corners and jumps of accelerations and outputs at a state, where a linearisation holds on one side alone.

use super::Change;
use super::derivatives::{Derivatives, outputs_beside};
use crate::model::{At, Differentiable};
use nalgebra::DVector;
use sim_kernel::{Dual, SwitchingKind};

/// Changes of positions and speeds, beside those that count as 1, within which a condition lies at its zero, and by which
/// accelerations are compared on both sides, farther away and near by.
const BESIDE: f64 = 1e-7;
const AROUND: f64 = 1e-5;
const NEARER: f64 = 0.1;
const NEAR_BY: [f64; 2] = [1e-7, 1e-8];
/// By which part the changes to both sides differ at a corner, and those to one side at a jump; the part of the difference that stays
/// at a tenth of the distance, where that of a smooth law shrinks; and rounding, as a part of the accelerations.
const DIFFERENT: f64 = 1e-2;
const STAYS: f64 = 0.5;
const ROUNDING: f64 = 1e-9;

/// Whether loads or constraints change their form at a state, and accelerations with it: small motions differ to either side.
pub(super) fn has_corner(mechanism: &dyn Differentiable, at: At<f64>, sizes: &[f64]) -> bool {
    let n = sizes.len();
    if n == 0 || !lies_at_zero(mechanism, at, sizes, |kind| !kind.is_smooth()) {
        return false;
    }
    let accelerations = |k: usize, by: f64| -> Option<DVector<f64>> {
        let (q, qd) = moved(at, sizes, k, by);
        mechanism.accelerate(At::moving(at.time, &q, &qd)).ok().map(|all| all.rows(0, n).into_owned())
    };
    let Some(here) = accelerations(0, 0.0) else { return false };
    let differs = |k: usize| {
        let changes = |by: f64| Some([accelerations(k, by)? - &here, &here - accelerations(k, -by)?]);
        let ([ahead, behind], [nearer, _]) = (changes(AROUND)?, changes(NEARER * AROUND)?);
        let least = DIFFERENT * ahead.amax().max(behind.amax()) + ROUNDING * here.amax();
        // A change by a jump is as large near by; that of a smooth law is a tenth at a tenth of the distance, or less.
        let jumps = ahead.iter().zip(&nearer).any(|(ahead, nearer)| nearer.abs() / NEARER > ahead.abs() + least);
        if jumps || (&ahead - behind).amax() <= least {
            return Some(jumps);
        }
        let [[far, far_behind], [near, near_behind]] = [changes(NEAR_BY[0])?, changes(NEAR_BY[1])?];
        let (bend, size) = ((&near - &near_behind).amax(), near.amax().max(near_behind.amax()));
        let was = (far - far_behind).amax() * NEAR_BY[1] / NEAR_BY[0];
        Some(bend > DIFFERENT * size && bend > STAYS * was)
    };
    (0..2 * n).any(|k| differs(k).unwrap_or(false))
}

/// The outputs that have a corner or a jump at a state, by index, as it changes with the entries of x. Where
/// an output changes its form with accelerations or multipliers, that is not seen.
pub(super) fn bent_outputs(derivatives: &Derivatives, columns: &[Change], sizes: &[f64]) -> Vec<usize> {
    let (mechanism, at) = (derivatives.mechanism(), derivatives.state());
    let counts = |kind: SwitchingKind| !kind.is_smooth() || kind == SwitchingKind::Output;
    if sizes.is_empty() || !lies_at_zero(mechanism, at, sizes, counts) {
        return Vec::new();
    }
    let mut bent = vec![false; mechanism.description().outputs.len()];
    for change in columns {
        let of =
            |changes: &DVector<f64>| changes.iter().zip(sizes).map(|(d, size)| (d / size).abs()).fold(0.0, f64::max);
        let by = of(&change.positions).max(of(&change.speeds)).recip();
        let sides = |distance: f64| [1.0, -1.0].map(|sign| outputs_beside(derivatives, change, sign * distance * by));
        let ([ahead, behind], [near, near_behind]) = (sides(NEAR_BY[0]), sides(NEAR_BY[1]));
        for (i, bent) in bent.iter_mut().enumerate() {
            let stays = |part: &dyn Fn(&Dual) -> f64| {
                let was = (part(&ahead[i]) - part(&behind[i])).abs();
                let (a, b) = (part(&near[i]), part(&near_behind[i]));
                (a - b).abs() > STAYS * was
                    && (a - b).abs() > ROUNDING * a.abs().max(b.abs()) + f64::EPSILON * near[i].value.abs()
            };
            *bent |= stays(&|output| output.value) || stays(&|output| output.derivative * by);
        }
    }
    (0..bent.len()).filter(|i| bent[*i]).collect()
}

/// A state in which a coordinate, or after them a speed, is another by so many of what counts as 1.
fn moved(at: At<f64>, sizes: &[f64], k: usize, by: f64) -> (Vec<f64>, Vec<f64>) {
    let n = sizes.len();
    let (mut q, mut qd) = (at.positions.to_vec(), at.speeds.to_vec());
    qd.resize(n, 0.0);
    let entry = if k < n { &mut q[k] } else { &mut qd[k - n] };
    *entry += by * sizes[k % n];
    (q, qd)
}

/// Whether a condition of a kind that counts lies at a zero, or at a row of its table.
fn lies_at_zero(
    mechanism: &dyn Differentiable,
    at: At<f64>,
    sizes: &[f64],
    counts: impl Fn(SwitchingKind) -> bool,
) -> bool {
    let functions = mechanism.description().load_conditions;
    let counts = |i: &usize| counts(functions[*i].kind);
    if !(0..functions.len()).any(|i| counts(&i)) {
        return false;
    }
    let conditions = |k: usize, by: f64| {
        let (q, qd) = moved(at, sizes, k, by);
        mechanism.load_conditions(At::moving(at.time, &q, &qd))
    };
    let here = conditions(0, 0.0);
    let around: Vec<Vec<f64>> = (0..2 * sizes.len()).map(|k| conditions(k, BESIDE)).collect();
    (0..functions.len()).filter(counts).any(|i| {
        let change: f64 = around.iter().map(|values| (values[i] - here[i]).abs()).sum();
        match functions[i].table {
            Some(table) => table.next_row(here[i] - change) <= here[i] + change,
            None => here[i].abs() <= change,
        }
    })
}
