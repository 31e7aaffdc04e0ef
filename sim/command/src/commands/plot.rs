//! `sim plot`.

use crate::arguments::{PlotArguments, Voice};
use crate::files::stored::{Stored, StoredColumn, make, place, provenance_of};
use crate::{Stop, print};
use codegen::model::{Dimension, Unit};
use sim_output::show::{self, Curve, Plot};

/// Draws quantities of a run over time or another quantity, those of one unit in one panel; lengths against a length to one scale.
pub(crate) fn plot(arguments: &PlotArguments, voice: Voice) -> Result<(), Stop> {
    let run = Stored::read(&arguments.run)?;
    let across = run.column(&arguments.against)?;
    let mut groups: Vec<Vec<&StoredColumn>> = Vec::new();
    for name in &arguments.quantities {
        let column = run.column(name)?;
        match groups.iter_mut().find(|group| group[0].unit == column.unit) {
            Some(group) => group.push(column),
            None => groups.push(vec![column]),
        }
    }
    let x_label = if across.name == "t" { "time [s]".to_owned() } else { across.header() };
    let y_labels: Vec<String> = groups
        .iter()
        .map(|group| if let [only] = group.as_slice() { only.header() } else { format!("[{}]", group[0].unit) })
        .collect();
    let plots: Vec<Plot> = groups
        .iter()
        .zip(&y_labels)
        .map(|(group, y_label)| Plot {
            title: &arguments.title,
            x_label: &x_label,
            y_label,
            x: &across.values,
            curves: group.iter().map(|column| Curve { label: &column.name, values: column.values.clone() }).collect(),
        })
        .collect();
    let against = if across.name == "t" { String::new() } else { format!("-against-{}", across.name) };
    let default = || {
        let directory = if arguments.run.is_dir() { arguments.run.clone() } else { place(&arguments.run).0 };
        directory.join(format!("plot-{}{against}", arguments.quantities.join("-")))
    };
    let (directory, name) = place(&arguments.out.clone().unwrap_or_else(default));
    make(&directory)?;
    let (provenance, size) = (provenance_of(std::slice::from_ref(&run)), arguments.size.show().into());
    let ratio = groups.first().and_then(|group| ratio_of_lengths(&group[0].unit, &across.unit));
    match (plots.as_slice(), ratio) {
        ([plot], Some(ratio)) => show::path_with(plot, ratio, size, &directory, &name, &provenance)?,
        (plots, _) => show::panels_with(plots, size, &directory, &name, &provenance)?,
    }
    let written = directory.join(name);
    match voice.quiet {
        true => Ok(()),
        false if voice.json => {
            let files = ["svg", "png"].map(|extension| format!("{}.{extension}", written.display()));
            print(&format!("{:#}\n", serde_json::json!({ "files": files })))
        }
        false => print(&format!("written      {0}.svg, {0}.png\n", written.display())),
    }
}

/// The size of one unit by that of another, if both are units of length.
fn ratio_of_lengths(one: &str, other: &str) -> Option<f64> {
    let metres = |unit: &str| {
        let unit = Unit::parse(unit).ok()?;
        (*unit.dimension() == Dimension::length()).then(|| unit.factor())
    };
    Some(metres(one)? / metres(other)?)
}
