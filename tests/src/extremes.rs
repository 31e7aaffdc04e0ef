//! How far the extremes of a sweep depend on its rows and its range.

use models::QuickReturn;
use sim::{Compiled, Driven, Extremes, Range, Sweep, declared_start, kinematics};
use std::f64::consts::{PI, TAU};

/// What it is, the largest difference between the extremes of any column and those of a turn in 720 rows, as a part of their
/// range, and its bound.
pub fn lines() -> Vec<(String, f64, f64)> {
    let rows = [1, 8, 36].map(|rows| (TAU, rows));
    beside_a_turn(rows.into_iter().chain([(100.0, 7), (500.0, 100), (1500.0, 100), (2000.0, 100), (2000.0, 1)]))
}

/// The same of sweeps to these angles in so many rows.
pub fn beside_a_turn(sweeps: impl IntoIterator<Item = (f64, usize)>) -> Vec<(String, f64, f64)> {
    let turn = extremes(TAU, 720);
    let line = |(to, rows): (f64, usize)| {
        (
            format!("quick-return, {rows} rows to {to:.6} rad beside 720 of a turn"),
            apart(&turn, &extremes(to, rows)),
            1e-9,
        )
    };
    sweeps.into_iter().map(line).collect()
}

fn extremes(to: f64, steps: usize) -> Extremes {
    let mechanism = QuickReturn::default();
    let sweep = Sweep { driven: Driven::Coordinate(0), from: 0.0, to, speed: 2.5 * PI, steps, held: Vec::new() };
    let found = kinematics(mechanism, &declared_start(&mechanism), &sweep);
    found.map_or_else(|_| none(), |found| found.extremes)
}

fn none() -> Extremes {
    let outputs = <QuickReturn as Compiled>::DESCRIPTION.outputs.len();
    let ranges = vec![None; outputs];
    Extremes {
        multipliers: vec![None; <QuickReturn as Compiled>::DESCRIPTION.constraints.len()],
        forces: vec![None],
        transmission: None,
        time_ratios: vec![None; outputs],
        ratios: ranges.clone(),
        is_rated: vec![false; outputs],
        outputs: ranges,
    }
}

/// The largest difference between least or greatest values, as a part of the range; what one has and the other not counts as 1.
fn apart(one: &Extremes, other: &Extremes) -> f64 {
    let all = |found: &Extremes| {
        let lists = [&found.outputs, &found.multipliers, &found.forces, &found.ratios];
        lists.into_iter().flatten().chain([&found.transmission]).copied().collect::<Vec<_>>()
    };
    all(one).into_iter().zip(all(other)).map(|pair| off(pair.0, pair.1)).fold(0.0, f64::max)
}

fn off(one: Option<Range>, other: Option<Range>) -> f64 {
    let (one, other) = match (one, other) {
        (Some(one), Some(other)) => (one, other),
        (None, None) => return 0.0,
        _ => return 1.0,
    };
    let off = (one.least.value - other.least.value).abs().max((one.greatest.value - other.greatest.value).abs());
    if off == 0.0 { 0.0 } else { off / one.stroke() }
}
