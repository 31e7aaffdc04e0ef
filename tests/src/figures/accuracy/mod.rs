//! How many digits the right-hand sides have, and how many operations they take, beside what they had and took before bodies of a
//! tree were written by recursions.

mod exact;

use super::Table;
use super::counts::{self, operations};
use super::size::{LEG, ROBOTS, WISHBONE};
use ::f256::f256;
use codegen::Derived;
use codegen::dynamics::EquationsOfMotion;
use exact::Exact;
use sim::{At, Kernel, Model, interpret};
use std::collections::HashMap;
use tests::{Random, shipped};

/// States of each mechanism.
const STATES: usize = 1000;

/// The same at the commit before recursions, b0bed40, measured by these files.
const BEFORE: &str = include_str!("before.txt");

/// A right-hand side.
struct Measured {
    operations: usize,
    /// The middle of its errors and what one in a hundred exceeds, relative to the largest acceleration or multiplier; none where
    /// nothing exact is known.
    errors: Option<[f64; 2]>,
}

pub(super) fn accuracy(table: &mut Table) {
    table.heading(
        "Right-hand sides beside those before recursions: operations, and errors at 1,000 states against 71 digits",
    );
    let before: HashMap<&str, Measured> = BEFORE.lines().filter_map(read).collect();
    let mut worst = [0.0f64; 2];
    for (name, text) in declarations() {
        let (Some(now), Some(before)) = (measured(table, name, text), before.get(name)) else {
            table.line(name, "not derived", "measured before too", false);
            continue;
        };
        let mut what = format!("{name}: operations");
        if let Some(before) = before.errors {
            let now = now.errors.unwrap_or([f64::INFINITY; 2]);
            what += &format!("; errors {:.1e}, {:.1e}; before {:.1e}, {:.1e}", now[0], now[1], before[0], before[1]);
            (0..2).for_each(|i| worst[i] = worst[i].max(now[i] / before[i]));
        }
        table.at_most(&what, now.operations as f64, before.operations as f64);
    }
    table.at_most("middle of the errors beside that before, worst", worst[0], 4.0);
    table.at_most("error that one state in 100 exceeds, beside that before, worst", worst[1], 4.0);
}

/// Shipped mechanisms and robots.
fn declarations() -> impl Iterator<Item = (&'static str, &'static str)> {
    let robots =
        ROBOTS.iter().map(|(name, text, _)| (*name, *text)).chain([("double wishbone", WISHBONE), ("leg", LEG)]);
    shipped().into_iter().map(|description| (description.name, description.declaration)).chain(robots)
}

/// `name; operations; middle error; error that one in 100 exceeds`.
fn read(line: &str) -> Option<(&str, Measured)> {
    let mut fields = line.split("; ");
    let (name, operations) = (fields.next()?, fields.next()?.parse().ok()?);
    let errors: Vec<f64> = fields.filter_map(|field| field.parse().ok()).collect();
    Some((name, Measured { operations, errors: <[f64; 2]>::try_from(errors).ok() }))
}

fn measured(table: &mut Table, name: &str, text: &str) -> Option<Measured> {
    let derived = counts::derived(table, name, text)?;
    let operations = operations(&derived, "dynamics")?;
    Some(Measured { operations, errors: errors(&derived, text) })
}

fn errors(derived: &Derived, text: &str) -> Option<[f64; 2]> {
    let declaration = codegen::dsl::declarations(text).ok()?.into_iter().next()?;
    let equations = codegen::equations(declaration).ok()?;
    let (exact, model) = (Exact::of(&equations)?, interpret(derived));
    let mut random = Random(1);
    let error = |_| {
        let state = state(&equations, &*model, &mut random);
        error(&exact, &*model, &state)
    };
    let mut errors: Vec<f64> = (0..STATES).filter_map(error).collect();
    errors.sort_by(f64::total_cmp);
    Some([*errors.get(errors.len() / 2)?, *errors.get(errors.len() * 99 / 100)?])
}

/// The error of the kernel, relative to the largest acceleration or multiplier, infinite where it refuses the state; none where
/// the equations are singular.
fn error(exact: &Exact, model: &dyn Model, [q, qd]: &[Vec<f64>; 2]) -> Option<f64> {
    let expected = exact.motion(&model.values().parameters, [q, qd])?;
    let mut found = Vec::new();
    let at = At { time: 0.0, positions: q, speeds: qd, accelerations: &[], multipliers: &[] };
    let is_refused = model.call(Kernel::Dynamics, at, &mut |row, numbers| {
        // Accelerations and multipliers; the power follows.
        if row < 2 {
            found.extend_from_slice(numbers);
        }
    });
    if is_refused {
        return Some(f64::INFINITY);
    }
    let both: Vec<(f64, f256)> = found.into_iter().zip(expected).collect();
    let (accelerations, multipliers) = both.split_at(q.len());
    // Those of quaternions' norms are zero, but for rounding.
    let norms = model.description().norm_constraints;
    let forces = multipliers.iter().enumerate().filter(|(i, _)| !norms.contains(i)).map(|(_, force)| *force);
    Some(relative(accelerations).max(relative(&forces.collect::<Vec<_>>())))
}

/// The largest difference beside the largest number; infinite if one is no number.
fn relative(found: &[(f64, f256)]) -> f64 {
    let worst = found.iter().map(|(a, b)| number(&(f256::from(*a) - *b).abs())).fold(0.0, f64::max);
    let largest = found.iter().map(|(_, b)| number(&b.abs())).fold(0.0, f64::max);
    match worst {
        _ if found.iter().any(|(a, _)| !a.is_finite()) => f64::INFINITY,
        0.0 => 0.0,
        worst => worst / largest,
    }
}

/// The nearest number of double precision.
fn number(x: &f256) -> f64 {
    format!("{x:e}").parse().unwrap_or(f64::NAN)
}

/// A state near the start, with quaternions of length 1; lengths by the longest at the start.
fn state(equations: &EquationsOfMotion, model: &dyn Model, random: &mut Random) -> [Vec<f64>; 2] {
    let description = model.description();
    let [mut q, _] = model.initial();
    let is_length: Vec<bool> = description.coordinates.iter().map(|c| c.position.is_length).collect();
    let lengths = q.iter().zip(&is_length).filter(|(_, is_length)| **is_length);
    let longest = lengths.map(|(x, _)| x.abs()).fold(0.0, f64::max);
    let scales: Vec<f64> =
        is_length.iter().map(|is_length| if *is_length { 0.2 * longest + 0.01 } else { 1.0 }).collect();
    q.iter_mut().zip(&scales).for_each(|(x, scale)| *x += random.between(-scale, *scale));
    for norm in &equations.model.norms {
        let symbols = equations.graph.symbols_of(&[norm.square]);
        let of = |i: &usize| symbols.contains(&equations.model.coordinates[*i].position);
        let quaternion: Vec<usize> = (0..q.len()).filter(of).collect();
        let length = quaternion.iter().map(|i| q[*i] * q[*i]).sum::<f64>().sqrt();
        quaternion.iter().for_each(|i| q[*i] /= length);
    }
    let qd = scales.iter().map(|scale| random.between(-scale, *scale)).collect();
    [q, qd]
}
