//! What a sweep has found, as JSON and to be read.

use crate::events::{idle_events, only_in_runs};
use crate::said::counted;
use serde_json::{Map, Value, json};
use sim_kernel::{Description, Mechanism, Quantity};
use sim_runtime::{
    Driven, Extreme, Extremes, Failure, Kinematics, Mobility, Range, SpecialPosition, Sweep, quotient, readable,
};

/// The results, without the type of the mechanism.
pub(super) struct Found<'a> {
    description: &'static Description,
    sweep: &'a Sweep,
    values: &'a [f64],
    is_cycle: bool,
    mobility: &'a Mobility,
    branches: &'a [SpecialPosition],
    limit: Option<&'a SpecialPosition>,
    extremes: &'a Extremes,
    pub(super) failure: Option<&'a Failure>,
}

impl<'a> Found<'a> {
    pub(super) fn new<M: Mechanism>(found: &'a Kinematics<M>) -> Found<'a> {
        Found {
            description: found.mechanism.description(),
            sweep: &found.sweep,
            values: &found.values,
            is_cycle: found.is_cycle(),
            mobility: &found.mobility,
            branches: &found.branches,
            limit: found.limit.as_ref(),
            extremes: &found.extremes,
            failure: found.trajectory.failure.as_ref(),
        }
    }

    /// The driven quantity.
    fn driven(&self) -> &'static Quantity {
        self.sweep.driven.quantity(self.description)
    }

    /// The drive and the holds, each with its force.
    fn drives(&self) -> impl Iterator<Item = (Driven, &'a Option<Range>)> {
        let held = self.sweep.held.iter().map(|(held, _)| *held);
        [self.sweep.driven].into_iter().chain(held).zip(&self.extremes.forces)
    }
}

/// The driven quantity and its range.
fn drive(found: &Found) -> Value {
    let driven = found.driven();
    let value = |si: f64| si / driven.factor;
    json!({
        "name": driven.name,
        "unit": driven.unit,
        "from": value(found.sweep.from),
        "to": value(found.sweep.to),
        "speed": value(found.sweep.rate()),
        "reached": found.limit.map(|limit| limit.value).or_else(|| found.values.last().copied()).map(value),
        "samples": found.values.len(),
    })
}

/// The results, in declared units.
pub(super) fn summary(found: &Found) -> Value {
    let (description, driven) = (found.description, found.driven());
    let value = |si: f64| si / driven.factor;
    let special = |position: &SpecialPosition| {
        let coordinates = description.coordinates.iter().zip(&position.positions);
        let coordinates = coordinates.map(|(c, q)| (c.position.name.to_owned(), json!(q / c.position.factor)));
        json!({ "at": value(position.value), "coordinates": coordinates.collect::<Map<_, _>>() })
    };
    let extreme = |extreme: &Extreme, factor: f64| json!({ "value": extreme.value / factor, "at": value(extreme.at) });
    let range = |range: &Range, factor: f64, unit: &str| {
        let (least, greatest) = (extreme(&range.least, factor), extreme(&range.greatest, factor));
        json!({ "unit": unit, "least": least, "greatest": greatest, "stroke": range.stroke() / factor })
    };
    let extremes = found.extremes;
    let outputs = description.outputs.iter().enumerate().filter_map(|(i, o)| {
        let mut entry = range(extremes.outputs[i].as_ref()?, o.factor, o.unit);
        if let Some(ratio) = &extremes.time_ratios[i] {
            let [working, returning] = [ratio.working, ratio.returning].map(value);
            entry["time_ratio"] = json!({ "ratio": ratio.ratio, "working": working, "returning": returning });
        }
        if let Some(ratio) = &extremes.ratios[i] {
            let peak = ratio.peak();
            let least = driven.factor.recip() * o.factor / peak.value;
            entry["least_mechanical_advantage"] =
                json!({ "value": least, "unit": quotient(driven, o), "at": value(peak.at) });
        }
        Some((o.name.to_owned(), entry))
    });
    let multipliers = description.constraints.iter().zip(&extremes.multipliers);
    let multipliers =
        multipliers.filter_map(|(c, found)| Some((c.name.to_owned(), range(found.as_ref()?, c.factor, c.unit))));
    let drives = found.drives().filter_map(|(driven, found)| {
        let unit = &driven.force_unit(description);
        Some((driven.quantity(description).name.to_owned(), range(found.as_ref()?, 1.0, unit)))
    });
    json!({
        "model": description.name,
        "drive": drive(found),
        "failure": found.failure.map(ToString::to_string),
        "failure_code": found.failure.map(|failure| failure.what.code()),
        "degrees_of_freedom": found.mobility.degrees_of_freedom,
        "redundant_constraints": found.mobility.dependent,
        "cycle": found.is_cycle,
        "limit_position": found.limit.map(special),
        "branch_positions": found.branches.iter().map(special).collect::<Vec<_>>(),
        "drives": drives.collect::<Map<_, _>>(),
        "transmission_index": extremes.transmission.as_ref().map(|found| range(found, 1.0, "1")),
        "outputs": outputs.collect::<Map<_, _>>(),
        "multipliers": multipliers.collect::<Map<_, _>>(),
        "without_bounds": without_bounds(found),
        "events_without_effect": idle_events(description),
    })
}

/// The columns that have no least and no greatest value.
fn without_bounds(found: &Found) -> Vec<String> {
    let (description, extremes) = (found.description, found.extremes);
    let drives = found.drives().map(|(driven, range)| (format!("drive_{}", driven.quantity(description).name), range));
    let multipliers = description.constraints.iter().zip(&extremes.multipliers);
    let multipliers = multipliers.map(|(c, range)| (format!("lambda_{}", c.name), range));
    let outputs = description.outputs.iter().zip(&extremes.outputs).map(|(o, range)| (o.name.to_owned(), range));
    let all = drives.chain(multipliers).chain(outputs);
    all.filter(|(_, range)| range.is_none()).map(|(name, _)| name).collect()
}

/// The same to be read.
pub(super) fn report(found: &Found) -> String {
    let description = found.description;
    let (driven, sweep, extremes) = (found.driven(), found.sweep, found.extremes);
    let value = |si: f64| format!("{} {}", readable(si / driven.factor, 6), driven.unit);
    let mut text = format!("{:<12} {}\n", "model", description.name);
    text += &format!(
        "{:<12} {} from {} to {} {}, {}\n",
        "drive",
        driven.name,
        value(sweep.from),
        value(sweep.to),
        if sweep.is_at_rest() {
            "at rest in each".to_owned()
        } else {
            speed(sweep.rate() / driven.factor, driven.unit)
        },
        counted(found.values.len(), "position")
    );
    found.mobility.redundancies().iter().for_each(|line| text += &format!("{:<12} {line}\n", "redundant"));
    text += &passed(found);
    text += &format!("{:<22} {:>14} {:>14} {:>14} {:>14}  unit\n", "", "least", "at", "greatest", "at");
    let mut row = |name: &str, range: &Option<Range>, factor: f64, unit: &str| {
        let Some(Range { least, greatest }) = range else {
            text +=
                &format!("{name:<22} not finite everywhere, or without bound, as at a pole or beside a dead point\n");
            return;
        };
        let numbers =
            [least.value / factor, least.at / driven.factor, greatest.value / factor, greatest.at / driven.factor];
        let numbers = numbers.map(|number| format!("{:>14}", readable(number, 6))).join(" ");
        text += &format!("{name:<22} {numbers}  {unit}\n");
    };
    for (driven, range) in found.drives() {
        row(&format!("drive_{}", driven.quantity(description).name), range, 1.0, &driven.force_unit(description));
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

/// What the sweep comes upon, to be read.
fn passed(found: &Found) -> String {
    let driven = found.driven();
    let value = |si: f64| format!("{} {}", readable(si / driven.factor, 6), driven.unit);
    let mut text = String::new();
    for position in found.branches {
        text += &format!("{:<12} another branch of the motion crosses at {}\n", "branches", value(position.value));
    }
    if let Some(position) = found.limit {
        text += &format!("{:<12} {} goes no further than {}\n", "limit", driven.name, value(position.value));
    }
    if let Some(line) = only_in_runs(found.description) {
        text += &format!("{:<12} {line}\n", "events");
    }
    text
}

/// A speed, to be read.
fn speed(value: f64, unit: &str) -> String {
    format!("at {} {unit}/s", readable(value, 6))
}
