//! What a sweep found, to be read.

use crate::{Kinematics, Range};
use sim_kernel::Mechanism;

/// Strokes, peaks and where they are, in declared units.
pub(super) fn report<M: Mechanism>(found: &Kinematics<M>) -> String {
    let description = const { &M::DESCRIPTION };
    let (driven, sweep, extremes) = (found.sweep.driven.quantity::<M>(), &found.sweep, &found.extremes);
    let value = |si: f64| format!("{:.6} {}", si / driven.factor, driven.unit);
    let mut text = format!("{:<12} {}\n", "model", description.name);
    text += &format!(
        "{:<12} {} from {} to {} at {:.6} {}/s, {} positions\n",
        "drive",
        driven.name,
        value(sweep.from),
        value(sweep.to),
        sweep.rate() / driven.factor,
        driven.unit,
        found.values.len()
    );
    for position in &found.branches {
        text += &format!("{:<12} another branch of the motion crosses at {}\n", "branches", value(position.value));
    }
    if let Some(position) = &found.limit {
        text += &format!("{:<12} {} goes no further than {}\n", "limit", driven.name, value(position.value));
    }
    text += &format!("{:<22} {:>14} {:>14} {:>14} {:>14}  unit\n", "", "least", "at", "greatest", "at");
    let mut row = |name: &str, range: &Option<Range>, factor: f64, unit: &str| {
        let Some(Range { least, greatest }) = range else { return };
        let numbers =
            [least.value / factor, least.at / driven.factor, greatest.value / factor, greatest.at / driven.factor];
        let numbers = numbers.map(|number| format!("{:>14}", significant(number))).join(" ");
        text += &format!("{name:<22} {numbers}  {unit}\n");
    };
    let drives = [sweep.driven].into_iter().chain(sweep.held.iter().map(|(held, _)| *held));
    for (driven, range) in drives.zip(&extremes.forces) {
        row(&format!("drive_{}", driven.quantity::<M>().name), range, 1.0, driven.force_unit::<M>());
    }
    row("transmission_index", &extremes.transmission, 1.0, "1");
    for (c, range) in description.constraints.iter().zip(&extremes.multipliers) {
        row(&format!("lambda_{}", c.name), range, c.factor, c.unit);
    }
    for (o, range) in description.outputs.iter().zip(&extremes.outputs) {
        row(o.name, range, o.factor, o.unit);
    }
    for (o, ratio) in description.outputs.iter().zip(&extremes.time_ratios) {
        let Some(ratio) = ratio else { continue };
        let (working, returning) = (value(ratio.working), value(ratio.returning));
        text += &format!("{:<12} {}: {:.9} ({working} to {returning})\n", "time ratio", o.name, ratio.ratio);
    }
    text
}

/// Nine significant digits.
fn significant(value: f64) -> String {
    let plain = value == 0.0 || (1e-3..1e6).contains(&value.abs());
    if plain { format!("{value:.6}") } else { format!("{value:.6e}") }
}
