//! The report of a sweep: what is driven stands along the abscissa and under the slider.

use super::data::Group;
use super::html::{escaped, number, table as html_table, unit};
use super::tables::{constraints, outputs, pair, parameters};
use super::{Abscissa, Fact, Shown, write_page};
use crate::outcome::list;
use crate::show::ShowError;
use crate::show::figures::label;
use sim_kernel::{Description, Mechanism, Quantity};
use sim_runtime::{Extremes, Kinematics, Range, Table};
use std::path::Path;

/// How long the animation of a mechanism at rest takes, in seconds.
const PLAYED: f64 = 6.0;

/// Writes the report of a sweep to a file, with the command that repeats it.
///
/// # Errors
/// As [`report`](super::report).
pub fn sweep_report<M: Mechanism>(
    found: &Kinematics<M>,
    table: &Table,
    command: &str,
    path: &Path,
) -> Result<(), ShowError> {
    write_page(&sweep_report_text(found, table, command)?, path)
}

/// The same as a text.
///
/// # Errors
/// If there is no sample.
pub fn sweep_report_text<M: Mechanism>(
    found: &Kinematics<M>,
    table: &Table,
    command: &str,
) -> Result<String, ShowError> {
    let description = found.mechanism.description();
    let sweep = &found.sweep;
    let driven = sweep.driven.quantity(description);
    let rate = if sweep.is_at_rest() { (sweep.to - sweep.from) / PLAYED } else { sweep.rate() };
    let abscissa = Abscissa {
        name: driven.name,
        unit: driven.unit,
        label: format!("{} [{}]", label(driven.docs, driven.name).trim_end_matches('.'), driven.unit),
        from: sweep.from / driven.factor,
        rate: rate / driven.factor,
    };
    let swept = Swept {
        description,
        driven,
        extremes: &found.extremes,
        drives: std::iter::once(sweep.driven).chain(sweep.held.iter().map(|(held, _)| *held)).collect(),
    };
    let shown = Shown {
        description,
        rows: found,
        table,
        times: found.values.iter().map(|value| (value - sweep.from) / rate).collect(),
        abscissa: Some(abscissa),
        figures: &|| figures(table, driven),
        has_energy: !sweep.is_at_rest(),
        is_at_rest: sweep.is_at_rest(),
        marks: found.branches.iter().map(|branch| (branch.value - sweep.from) / rate).collect(),
        period: None,
        failure: found.trajectory.failure.as_ref(),
        facts: facts(found, driven),
        tables: [
            parameters(
                description,
                &list(&found.mechanism.parameters()),
                &list(&found.mechanism.as_declared().parameters()),
            ),
            swept.special(
                &found.branches.iter().map(|at| at.value).collect::<Vec<_>>(),
                found.limit.as_ref().map(|at| at.value),
            ),
            swept.extremes(),
            constraints(description),
            outputs(description),
        ]
        .concat(),
        command,
        run_file: None,
    };
    shown.page(None)
}

/// The sweep in short.
fn facts<M: Mechanism>(found: &Kinematics<M>, driven: &Quantity) -> Vec<Fact> {
    let (sweep, description) = (&found.sweep, found.mechanism.description());
    let value = |si: f64| number(si / driven.factor, 9);
    let reached = found.values.last().copied().unwrap_or(sweep.from);
    let unit = if driven.unit == "1" { String::new() } else { format!(" {}", driven.unit) };
    let speed = match sweep.is_at_rest() {
        true => "at rest in each position".to_owned(),
        false => format!("{}{unit}/s", value(sweep.rate())),
    };
    let mut facts = vec![
        ("Driven", format!("{} from {} to {}{unit}", driven.name, value(sweep.from), value(reached)), false),
        ("Speed", speed, false),
        ("Positions", found.values.len().to_string(), false),
        ("Coordinates", description.coordinates.len().to_string(), false),
    ];
    if !description.constraints.is_empty() {
        facts.push(("Constraints", description.constraints.len().to_string(), false));
    }
    facts
}

/// The figures of a sweep's own columns.
fn figures(table: &Table, driven: &Quantity) -> Vec<Group> {
    let of = |title: String, prefix: &str| {
        let columns = table.columns.iter().enumerate().skip(1);
        let columns = columns.filter(|(_, column)| column.name.starts_with(prefix)).map(|(index, _)| index - 1);
        Group { title, columns: columns.collect() }
    };
    let groups = [
        of("What the drive exerts".into(), "drive_"),
        of("Transmission index".into(), "transmission_index"),
        of(format!("Ratios of rates to that of {}", driven.name), "ratio_"),
    ];
    groups.into_iter().filter(|group| !group.columns.is_empty()).collect()
}

/// The results of a sweep, without the type of its mechanism.
struct Swept<'a> {
    description: &'static Description,
    driven: &'static Quantity,
    extremes: &'a Extremes,
    drives: Vec<sim_runtime::Driven>,
}

impl Swept<'_> {
    /// A value of what is driven, with its unit.
    fn place(&self, si: f64) -> String {
        format!("{} {}", number(si / self.driven.factor, 9), self.driven.unit)
    }

    /// The positions where branches cross, or the drive goes no further.
    fn special(&self, branches: &[f64], limit: Option<f64>) -> String {
        let branches = branches.iter().map(|at| pair("another branch crosses at", &self.place(*at)));
        let limit = limit.map(|at| pair("the drive goes no further than", &self.place(at)));
        html_table("Special positions", &[], &branches.chain(limit).collect::<Vec<_>>(), "")
    }

    /// The least and greatest values.
    fn extremes(&self) -> String {
        let (description, extremes) = (self.description, self.extremes);
        let drives = self.drives.iter().zip(&extremes.forces).map(|(driven, range)| {
            let name = format!("drive_{}", driven.quantity(description).name);
            self.range(&name, range, 1.0, &driven.force_unit(description))
        });
        let transmission = std::iter::once(self.range("transmission_index", &extremes.transmission, 1.0, "1"));
        let multipliers = description.constraints.iter().zip(&extremes.multipliers);
        let multipliers =
            multipliers.map(|(c, range)| self.range(&format!("lambda_{}", c.name), range, c.factor, c.unit));
        let outputs = description.outputs.iter().zip(&extremes.outputs);
        let outputs = outputs.map(|(o, range)| self.range(o.name, range, o.factor, o.unit));
        let rows: Vec<String> = drives.chain(transmission).chain(multipliers).chain(outputs).collect();
        let at = format!("at {} {}", self.driven.name, unit(self.driven.unit));
        let head = [("", ""), ("number", "least"), ("number", &at), ("number", "greatest"), ("number", &at), ("", "")];
        html_table("Least and greatest values", &head, &rows, "Found along the way, not among the recorded positions.")
    }

    fn range(&self, name: &str, range: &Option<Range>, factor: f64, own_unit: &str) -> String {
        let cell = |value: f64| format!("<td class=\"number\">{}</td>", number(value, 7));
        let cells: String = match range {
            None => "<td colspan=\"4\">not finite everywhere, or unbounded</td>".to_owned(),
            Some(Range { least, greatest }) => [least, greatest]
                .map(|extreme| cell(extreme.value / factor) + &cell(extreme.at / self.driven.factor))
                .concat(),
        };
        format!("<tr><th>{}</th>{cells}<td class=\"unit\">{}</td></tr>", escaped(name), unit(own_unit))
    }
}
