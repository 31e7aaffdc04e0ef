//! Corners and jumps of accelerations at a state, where a linearisation holds on one side alone.

use crate::model::{At, Differentiable};
use nalgebra::DVector;

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
    let moved = |k: usize, by: f64| {
        let (mut q, mut qd) = (at.positions.to_vec(), at.speeds.to_vec());
        qd.resize(n, 0.0);
        let entry = if k < n { &mut q[k] } else { &mut qd[k - n] };
        *entry += by * sizes[k % n];
        (q, qd)
    };
    let conditions = |k: usize, by: f64| {
        let (q, qd) = moved(k, by);
        mechanism.load_conditions(At::moving(at.time, &q, &qd))
    };
    if n == 0 || !lies_at_zero(mechanism, &|k, by| conditions(k, by), 2 * n) {
        return false;
    }
    let accelerations = |k: usize, by: f64| -> Option<DVector<f64>> {
        let (q, qd) = moved(k, by);
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

/// Whether a condition that is no middle of a pulse lies at a zero, or at a row of its table.
fn lies_at_zero(mechanism: &dyn Differentiable, conditions: &dyn Fn(usize, f64) -> Vec<f64>, changes: usize) -> bool {
    let functions = mechanism.description().load_conditions;
    let sudden = |i: &usize| !functions[*i].kind.is_smooth();
    if !(0..functions.len()).any(|i| sudden(&i)) {
        return false;
    }
    let (here, around): (_, Vec<Vec<f64>>) =
        (conditions(0, 0.0), (0..changes).map(|k| conditions(k, BESIDE)).collect());
    (0..functions.len()).filter(sudden).any(|i| {
        let change: f64 = around.iter().map(|values| (values[i] - here[i]).abs()).sum();
        match functions[i].table {
            Some(table) => table.next_row(here[i] - change) <= here[i] + change,
            None => here[i].abs() <= change,
        }
    })
}
