//! What a sweep found, for programs.

use crate::kinematics::quotient;
use crate::{Extreme, Kinematics, Range};
use serde_json::{Map, Value, json};
use sim_kernel::{Array, Mechanism};

/// What was found, in declared units.
pub(super) fn summary<M: Mechanism>(found: &Kinematics<M>) -> Value {
    let description = const { &M::DESCRIPTION };
    let driven = found.sweep.driven.quantity::<M>();
    let value = |si: f64| si / driven.factor;
    let special = |position: &crate::SpecialPosition<M>| {
        let coordinates = description.coordinates.iter().zip(position.positions.iter());
        let coordinates = coordinates.map(|(c, q)| (c.position.name.to_owned(), json!(q / c.position.factor)));
        json!({ "at": value(position.value), "coordinates": coordinates.collect::<Map<_, _>>() })
    };
    let extreme = |extreme: &Extreme, factor: f64| json!({ "value": extreme.value / factor, "at": value(extreme.at) });
    let range = |range: &Range, factor: f64, unit: &str| {
        let (least, greatest) = (extreme(&range.least, factor), extreme(&range.greatest, factor));
        json!({ "unit": unit, "least": least, "greatest": greatest, "stroke": range.stroke() / factor })
    };
    let extremes = &found.extremes;
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
    let drives = [found.sweep.driven].into_iter().chain(found.sweep.held.iter().map(|(held, _)| *held));
    let drives = drives.zip(&extremes.forces).filter_map(|(driven, found)| {
        let unit = driven.force_unit::<M>();
        Some((driven.quantity::<M>().name.to_owned(), range(found.as_ref()?, 1.0, unit)))
    });
    json!({
        "model": description.name,
        "drive": {
            "name": driven.name,
            "unit": driven.unit,
            "from": value(found.sweep.from),
            "to": value(found.sweep.to),
            "speed": value(found.sweep.rate()),
            "reached": found.values.last().copied().map(value),
            "samples": found.values.len(),
        },
        "failure": found.trajectory.failure.as_ref().map(ToString::to_string),
        "degrees_of_freedom": found.mobility.degrees_of_freedom,
        "redundant_constraints": found.mobility.dependent,
        "cycle": found.is_cycle(),
        "limit_position": found.limit.as_ref().map(special),
        "branch_positions": found.branches.iter().map(special).collect::<Vec<_>>(),
        "drives": drives.collect::<Map<_, _>>(),
        "transmission_index": extremes.transmission.as_ref().map(|found| range(found, 1.0, "1")),
        "outputs": outputs.collect::<Map<_, _>>(),
        "multipliers": multipliers.collect::<Map<_, _>>(),
    })
}
