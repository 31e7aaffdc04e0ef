//! Random tables.

use crate::random::Random;

/// Tables of every kind: smooth ones for positions, and others.
pub(crate) fn tables(random: &mut Random) -> String {
    let outside = |random: &mut Random| *random.pick(&["held", "continued"]);
    let (first, second, third) = (outside(random), outside(random), outside(random));
    let ends = *random.pick(&["", ", natural", ", clamped"]);
    let close = random.between(-1.0, 1.0);
    let hills = format!("cubic, periodic {{ -1, {close:?}; {} {close:?}; }}", rows(random, -1.0, 5));
    let stairs = format!("cubic{ends}, {first} {{ {} }}", rows(random, -2.0, 7).trim_end_matches("5.5, "));
    let kinks = format!("linear, {second} {{ {} }}", rows(random, -1.5, 3).trim_end_matches("5.5, "));
    let bends = format!("monotone, {third} {{ {} }}", rows(random, -3.0, 9).trim_end_matches("5.5, "));
    format!("tables {{ hills = {hills} stairs = {stairs} kinks = {kinks} bends = {bends} }}\n")
}

/// Rows beyond an argument, and an argument beyond them.
fn rows(random: &mut Random, after: f64, count: usize) -> String {
    let step = (5.0 - after) / count as f64;
    let mut rows = String::new();
    for i in 1..=count {
        let x = after + step * (i as f64 - random.between(0.1, 0.9));
        rows += &format!("{x:.3}, {:.3}; ", random.between(-1.0, 1.0));
    }
    rows + "5.5, "
}
