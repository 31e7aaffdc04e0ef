//! `sim compare`.

use crate::arguments::{CompareArguments, Voice};
use crate::files::stored::{Stored, make, provenance_of};
use crate::{Stop, print};
use sim_output::show::{self, Curve, Plot};

/// Draws each quantity of all the runs in one figure.
pub(crate) fn compare(arguments: &CompareArguments, voice: Voice) -> Result<(), Stop> {
    let runs: Vec<Stored> = arguments.runs.iter().map(|path| Stored::read(path)).collect::<Result<_, _>>()?;
    let labels = labels(&runs, arguments);
    let quantities = quantities(&runs, &arguments.quantity)?;
    make(&arguments.out)?;
    let (mut written, provenance) = (Vec::new(), provenance_of(&runs));
    for quantity in &quantities {
        let figure = Figure::of(&runs, quantity)?;
        let curves = labels.iter().zip(&figure.curves).map(|(label, values)| Curve { label, values: values.clone() });
        let plot = Plot {
            title: "",
            x_label: "time [s]",
            y_label: &figure.y_label,
            x: &figure.times,
            curves: curves.collect(),
        };
        show::panels_with(&[plot], arguments.size.show().into(), &arguments.out, quantity, &provenance)?;
        written.push(format!("{quantity}.svg"));
        written.push(format!("{quantity}.png"));
    }
    match voice.quiet {
        true => Ok(()),
        false if voice.json => {
            print(&format!("{:#}\n", serde_json::json!({ "directory": arguments.out, "files": written })))
        }
        false => print(&format!("written      {}: {}\n", arguments.out.display(), written.join(", "))),
    }
}

/// The name of each run: its directory, or its whole path if directories have the same name.
fn labels(runs: &[Stored], arguments: &CompareArguments) -> Vec<String> {
    let is_unique = |run: &Stored| runs.iter().filter(|other| other.name == run.name).count() == 1;
    match runs.iter().all(is_unique) {
        true => runs.iter().map(|run| run.name.clone()).collect(),
        false => arguments.runs.iter().map(|path| path.display().to_string()).collect(),
    }
}

/// The requested quantities, or all that every run has, except time and accelerations.
fn quantities(runs: &[Stored], asked: &[String]) -> Result<Vec<String>, Stop> {
    if !asked.is_empty() {
        return Ok(asked.to_vec());
    }
    let Some((first, others)) = runs.split_first() else { return Ok(Vec::new()) };
    let shared = first.names().filter(|name| *name != "t" && !name.ends_with("_ddot"));
    let shared: Vec<String> =
        shared.filter(|name| others.iter().all(|run| run.column(name).is_ok())).map(String::from).collect();
    match shared.is_empty() {
        true => Err(Stop::Usage("these runs have no quantity in common but time".into())),
        false => Ok(shared),
    }
}

/// One quantity of several runs, whose times differ: the runs one after the other, each curve with a gap where others
/// are.
struct Figure {
    times: Vec<f64>,
    curves: Vec<Vec<f64>>,
    y_label: String,
}

impl Figure {
    fn of(runs: &[Stored], quantity: &str) -> Result<Figure, Stop> {
        let mut figure = Figure { times: Vec::new(), curves: vec![Vec::new(); runs.len()], y_label: String::new() };
        for (index, run) in runs.iter().enumerate() {
            let (times, column) = (run.column("t")?, run.column(quantity)?);
            if figure.y_label.is_empty() {
                figure.y_label = column.header();
            } else if figure.y_label != column.header() {
                let (one, other) = (&figure.y_label, column.header());
                return Err(Stop::Usage(format!(
                    "`{quantity}` has different units in {}: {one} and {other}",
                    run.name
                )));
            }
            figure.times.extend(&times.values);
            for (other, curve) in figure.curves.iter_mut().enumerate() {
                match other == index {
                    true => curve.extend(&column.values),
                    false => curve.extend(std::iter::repeat_n(f64::NAN, column.values.len())),
                }
            }
        }
        Ok(figure)
    }
}
