//! Derivatives of the motion against difference quotients of what the oracle solves.

use crate::build::State;
use codegen::oracle::{self, Oracle};

/// The quotients are of fourth order, over these steps: what they lose, h^4 times a fifth derivative and rounding eps cond/h, is
/// about 1e-10 of quantities of order 1. Two that differ by more than this part of their size are undecided, and a
/// derivative is off where it differs by a hundred times that.
const STEPS: [f64; 2] = [2e-3, 1e-3];
const DECIDED: f64 = 1e-7;
/// What rounding of the terms can do to a solution, as a part of its size: divided by a step it is a tenth of the tolerance.
/// More, and a row that no coordinate moves, say, has a pivot that is nothing but rounding, whose quotients agree all the same.
const KNOWN: f64 = 1e-9;
const TOLERANCE: f64 = 1e-5;

/// How much has been compared: entries, and how far they are apart relative to their column.
#[derive(Debug, Default)]
pub(crate) struct Derivatives {
    pub(crate) compared: usize,
    pub(crate) undecided: usize,
    pub(crate) worst: f64,
}

/// d(q'', lambda) by positions, speeds and parameters.
pub(crate) fn compare(
    oracle: &Oracle,
    state: &State,
    found: &[(String, Vec<f64>)],
    declaration: &str,
    derived: &mut Derivatives,
) {
    let values = |name: &str| &found.iter().find(|(known, _)| known == name).unwrap().1;
    let State { time, parameters, coordinates, speeds, .. } = state;
    let solved = |parameters: &[f64], coordinates: &[f64], speeds: &[f64]| -> Option<Vec<f64>> {
        let at = oracle::State { time: *time, parameters, coordinates, speeds, inputs: &[None] };
        let solution = oracle.accelerations(&oracle.terms(&at).ok()?).ok()?;
        let unknowns = || solution.accelerations.iter().chain(&solution.multipliers);
        let size = unknowns().fold(1.0f64, |size, x| size.max(x.value.abs()));
        let is_known = unknowns().all(|x| f64::EPSILON * x.magnitude <= KNOWN * size);
        is_known.then(|| unknowns().map(|x| x.value).collect())
    };
    let mut columns = |name: &str, count: usize, at: &dyn Fn(usize, f64) -> Option<Vec<f64>>| {
        let generated = values(name);
        for j in 0..count {
            let [Some(far), Some(near)] = STEPS.map(|h| quotient(h, &|step| at(j, step))) else {
                derived.undecided += 1;
                continue;
            };
            let size = near.iter().fold(1.0f64, |size, x| size.max(x.abs()));
            assert_eq!(generated.len(), near.len() * count, "{name}");
            for (i, (far, near)) in far.iter().zip(&near).enumerate() {
                if !((far - near).abs() <= DECIDED * size) {
                    derived.undecided += 1;
                    continue;
                }
                let entry = generated[i * count + j];
                let apart = (entry - near).abs() / size;
                assert!(
                    apart <= TOLERANCE,
                    "{name} {i} {j}: {entry} is not {near}, at {time} {coordinates:?} {speeds:?} in\n{declaration}"
                );
                derived.worst = derived.worst.max(apart);
                derived.compared += 1;
            }
        }
    };
    let changed = |values: &[f64], j: usize, by: f64| -> Vec<f64> {
        values.iter().enumerate().map(|(i, x)| if i == j { x + by } else { *x }).collect()
    };
    let n = coordinates.len();
    columns("by_positions", n, &|j, by| solved(parameters, &changed(coordinates, j, by), speeds));
    columns("by_speeds", n, &|j, by| solved(parameters, coordinates, &changed(speeds, j, by)));
    columns("by_parameters", parameters.len(), &|j, by| solved(&changed(parameters, j, by), coordinates, speeds));
}

/// (8 (f(h) - f(-h)) - (f(2 h) - f(-2 h)))/(12 h).
fn quotient(h: f64, f: &dyn Fn(f64) -> Option<Vec<f64>>) -> Option<Vec<f64>> {
    let [a, b, c, d] = [f(-2.0 * h)?, f(-h)?, f(h)?, f(2.0 * h)?];
    Some((0..a.len()).map(|i| (8.0 * (c[i] - b[i]) - (d[i] - a[i])) / (12.0 * h)).collect())
}
