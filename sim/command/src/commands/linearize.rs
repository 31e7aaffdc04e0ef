//! `sim linearize`.

use crate::arguments::{LinearizeArguments, Voice};
use crate::commands::steady::{CORNER, advice};
use crate::events::{idle_events, only_in_runs, only_until_then};
use crate::files::asked;
use crate::given::as_given;
use crate::numbers::in_units;
use crate::settings::positive;
use crate::{Stop, print, unknown};
use nalgebra::{Complex, DMatrix};
use serde_json::{Map, Value, json};
use sim_kernel::Mechanism;
use sim_output::{WriteError, write_json, write_matrices};
use sim_runtime::{
    Control, Description, Linearization, Mode, Provenance, Settings, Start, State, assemble, equilibrium, linearize,
    readable, run_while,
};
use std::sync::atomic::{AtomicBool, Ordering};

/// Linearises a mechanism, writes the matrices and prints the modes.
pub(crate) fn linearize_command<M: Mechanism>(
    mechanism: M,
    arguments: &LinearizeArguments,
    voice: Voice,
) -> Result<(), Stop> {
    linearized(mechanism, arguments, &AtomicBool::new(false), &|found| tell(found, arguments, voice))
}

/// The same as a value. Where `interrupted` is set, a motion on the way to a time ends.
pub(crate) fn linearized_summary<M: Mechanism>(
    mechanism: M,
    arguments: &LinearizeArguments,
    interrupted: &AtomicBool,
) -> Result<Value, Stop> {
    linearized(mechanism, arguments, interrupted, &|found| Ok(summary(found, &arguments.at)))
}

/// Linearises a mechanism, and tells what is found.
fn linearized<M: Mechanism, T>(
    mechanism: M,
    arguments: &LinearizeArguments,
    interrupted: &AtomicBool,
    tell: &dyn Fn(&Found) -> Result<T, Stop>,
) -> Result<T, Stop> {
    let description = mechanism.description();
    let (mechanism, start) = as_given(&mechanism, &arguments.start.set, &arguments.start.initial)?;
    let inputs = controls(description, &arguments.input)?;
    let (mechanism, state) = state_at(mechanism, &start, &arguments.at, interrupted)?;
    let State { time, positions, speeds, .. } = &state;
    let Linearization {
        independent,
        independent_speeds,
        unsteady,
        is_steady,
        has_corner,
        bent_outputs,
        a,
        b,
        c,
        d,
        eigenvalues,
        modes,
        ..
    } = linearize(&mechanism, &state, &inputs)?;
    let undefined = undefined_outputs(description, [&c, &d]);
    let bent = bent_outputs.iter().map(|i| description.outputs[*i].name);
    let found = Found {
        description,
        time: *time,
        is_of_run: !PLACES.contains(&arguments.at.as_str()),
        positions: positions.as_ref(),
        speeds: speeds.as_ref(),
        states: states(description, &independent, &independent_speeds),
        is_steady,
        has_corner,
        unsteady: names(description, &unsteady),
        advice: advice(&mechanism, &state, &unsteady),
        inputs: inputs.iter().map(|input| input.name_in(description)).collect(),
        bent: bent.filter(|output| !undefined.contains(output)).collect(),
        undefined,
        matrices: [("A", &a), ("B", &b), ("C", &c), ("D", &d)],
        eigenvalues: &eigenvalues,
        modes: &modes,
    };
    tell(&found)
}

/// The results, for a mechanism of any type.
struct Found<'a> {
    description: &'static Description,
    time: f64,
    /// Whether a run has led there.
    is_of_run: bool,
    positions: &'a [f64],
    speeds: &'a [f64],
    /// The names of the entries of x.
    states: Vec<&'static str>,
    /// Whether A is constant.
    is_steady: bool,
    has_corner: bool,
    /// The coordinates in which the motion is not steady, and those in which it may be.
    unsteady: Vec<&'static str>,
    advice: Option<String>,
    inputs: Vec<&'static str>,
    /// The outputs that have a corner or a jump here, but a derivative.
    bent: Vec<&'static str>,
    /// The outputs that have no derivative here.
    undefined: Vec<&'static str>,
    matrices: [(&'static str, &'a DMatrix<f64>); 4],
    eigenvalues: &'a [Complex<f64>],
    modes: &'a [Mode],
}

/// The outputs whose rows are not finite: they have no derivative here, as a distance has none where it is 0.
fn undefined_outputs(description: &'static Description, matrices: [&DMatrix<f64>; 2]) -> Vec<&'static str> {
    let is_finite = |matrix: &DMatrix<f64>, i: usize| matrix.row(i).iter().all(|entry| entry.is_finite());
    let outputs = description.outputs.iter().enumerate();
    let undefined = outputs.filter(|(i, _)| !matrices.iter().all(|matrix| is_finite(matrix, *i)));
    undefined.map(|(_, output)| output.name).collect()
}

/// Writes and prints the results.
fn tell(found: &Found, arguments: &LinearizeArguments, voice: Voice) -> Result<(), Stop> {
    let directory = arguments.out.clone().unwrap_or_else(|| format!("out/{}-linear", found.description.name).into());
    std::fs::create_dir_all(&directory).map_err(|why| WriteError::new(&directory, why))?;
    let provenance = Provenance { command: Some(asked::command()), ..Provenance::of(found.description) };
    let mut said = summary(found, &arguments.at);
    said["provenance"] = provenance.to_json();
    write_json(&said, &directory.join("linear.json"))?;
    write_matrices(&found.matrices, &provenance, &directory.join("linear.npz"))?;
    match voice {
        Voice { quiet: true, .. } => Ok(()),
        Voice { json: true, .. } => print(&format!("{said:#}\n")),
        _ => print(&format!("{}written      {}: linear.json, linear.npz\n", report(found), directory.display())),
    }
}

/// The named inputs, or all.
fn controls(description: &'static Description, named: &[String]) -> Result<Vec<Control>, Stop> {
    let inputs = description.inputs.iter().enumerate().map(|(i, input)| (input.name, Control::Input(i)));
    if named.is_empty() {
        return Ok(inputs.map(|(_, control)| control).collect());
    }
    let parameters = description.parameters.iter().enumerate().map(|(i, p)| (p.name, Control::Parameter(i)));
    let known: Vec<(&str, Control)> = inputs.chain(parameters).collect();
    let control = |name: &String| {
        let found = known.iter().find(|(known, _)| known == name).map(|(_, control)| *control);
        found.ok_or_else(|| unknown("input or parameter", name, known.iter().map(|(known, _)| *known)))
    };
    named.iter().map(control).collect()
}

/// The states that are no times of a run.
const PLACES: [&str; 2] = ["equilibrium", "initial"];

/// The state in question, and the mechanism as events have left it there.
fn state_at<M: Mechanism>(
    mechanism: M,
    start: &Start<M>,
    place: &str,
    interrupted: &AtomicBool,
) -> Result<(M, State<M>), Stop> {
    match place {
        "equilibrium" => equilibrium(&mechanism, start).map(|found| (mechanism, found.state)).map_err(Stop::from),
        "initial" => assemble(&mechanism, start).map(|state| (mechanism, state)).map_err(Stop::from),
        time => {
            let settings = Settings::new(positive("--at", time)?);
            let run = run_while(mechanism.clone(), start, &settings, &mut |_| !interrupted.load(Ordering::Relaxed))?;
            let last = run.trajectory.with_mechanisms(&mechanism).last();
            match (run.trajectory.failure.clone(), last) {
                (Some(failure), _) => Err(failure.into()),
                (None, Some((_, sample))) if sample.state.time < settings.end => Err(Stop::Usage(format!(
                    "--at {time}: the motion ends at t = {:?} s, where an event stops it",
                    sample.state.time
                ))),
                (None, Some((mechanism, sample))) => Ok((mechanism, sample.state.clone())),
                (None, None) => Err(Stop::Failed(anyhow::anyhow!("nothing was recorded"))),
            }
        }
    }
}

fn summary(found: &Found, place: &str) -> Value {
    let coordinates = found.description.coordinates;
    let rows = |matrix: &DMatrix<f64>| -> Value {
        matrix.row_iter().map(|row| row.iter().copied().collect::<Vec<f64>>()).collect::<Vec<_>>().into()
    };
    let mode = |mode: &Mode| {
        let shape = coordinates
            .iter()
            .zip(&mode.shape)
            .map(|(c, entry)| (c.position.name.to_owned(), json!({ "amplitude": entry.norm(), "phase": entry.arg() })));
        json!({
            "eigenvalue": [mode.eigenvalue.re, mode.eigenvalue.im],
            "frequency_hz": mode.frequency(),
            "damping_ratio": mode.damping_ratio(),
            "neutral": mode.is_neutral,
            "shape": shape.collect::<Map<_, _>>(),
        })
    };
    let positions = coordinates.iter().zip(found.positions).map(|(c, q)| (c.position.name.to_owned(), json!(q)));
    let speeds = coordinates.iter().zip(found.speeds).map(|(c, qd)| (c.speed.name.to_owned(), json!(qd)));
    let mut said = json!({
        "model": found.description.name,
        "at": place,
        "time": found.time,
        "coordinates": positions.collect::<Map<_, _>>(),
        "speeds": speeds.collect::<Map<_, _>>(),
        "states": found.states,
        "steady": found.is_steady,
        "unsteady": found.unsteady,
        "corner": found.has_corner,
        "advice": found.advice,
        "inputs": found.inputs,
        "outputs": found.description.outputs.iter().map(|o| o.name).collect::<Vec<_>>(),
        "outputs_without_derivative": found.undefined,
        "outputs_with_corner": found.bent,
        "events_without_effect": idle_events(found.description),
        "warnings": warnings(found),
    });
    for (name, matrix) in found.matrices {
        said[name] = rows(matrix);
    }
    said["eigenvalues"] = found.eigenvalues.iter().map(|value| json!([value.re, value.im])).collect();
    said["modes"] = found.modes.iter().map(mode).collect();
    said
}

/// The names of coordinates.
fn names(description: &Description, coordinates: &[usize]) -> Vec<&'static str> {
    coordinates.iter().map(|j| description.coordinates[*j].position.name).collect()
}

/// The names of the entries of x.
fn states(description: &Description, independent: &[usize], independent_speeds: &[usize]) -> Vec<&'static str> {
    let coordinates = description.coordinates;
    let positions = independent.iter().map(|j| coordinates[*j].position.name);
    positions.chain(independent_speeds.iter().map(|j| coordinates[*j].speed.name)).collect()
}

/// Why the matrices may not be what was asked for.
fn warnings(found: &Found) -> Vec<String> {
    let of = |outputs: &[&str], why: &str| (!outputs.is_empty()).then(|| format!("{}: {why}", outputs.join(", ")));
    let warnings = [
        found.has_corner.then(|| CORNER.to_owned()),
        of(&found.bent, "a corner or a jump here, so rows of C and D hold on one side at most"),
        of(&found.undefined, "no derivative here, so rows of C and D are not numbers"),
    ];
    warnings.into_iter().flatten().collect()
}

fn report(found: &Found) -> String {
    let coordinates = found.description.coordinates;
    let mut text = format!("{:<12} t = {:?} s\n", "at", found.time);
    let positions = in_units(coordinates.iter().map(|c| &c.position), found.positions, 12);
    for (c, q) in coordinates.iter().zip(positions) {
        text += &format!("{:<12} {q:>20} {}\n", c.position.name, c.position.unit);
    }
    text += &format!("{:<12} {}\n", "states", found.states.join(", "));
    if let Some(advice) = &found.advice {
        let coordinates = found.unsteady.join(", ");
        text += &format!(
            "{:<12} no: A changes along with {coordinates}, and the modes hold for one instant only\n",
            "steady"
        );
        text += &format!("{:<12} {advice}\n", "");
    } else if !found.is_steady {
        text += &format!("{:<12} no: what acts changes with time, and the modes hold for one instant only\n", "steady");
    } else if found.speeds.iter().any(|speed| *speed != 0.0) {
        text += &format!("{:<12} yes: A is constant along the motion\n", "steady");
    }
    for warning in warnings(found) {
        text += &format!("{:<12} {warning}\n", "warning");
    }
    let said = if found.is_of_run { only_until_then } else { only_in_runs };
    if let Some(line) = said(found.description) {
        text += &format!("{:<12} {line}\n", "events");
    }
    let largest = found.modes.iter().map(|mode| mode.eigenvalue.norm()).fold(0.0, f64::max);
    for (k, mode) in found.modes.iter().enumerate() {
        let Mode { eigenvalue, is_neutral, .. } = mode;
        text += &format!("{:<12} {} 1/s", format!("mode {}", k + 1), complex(*eigenvalue, largest));
        text += &match (eigenvalue.im == 0.0, eigenvalue.re > 0.0) {
            _ if *is_neutral => ", 0 but for rounding: stays where it is, or drifts\n".to_owned(),
            (true, true) => ", grows\n".to_owned(),
            (true, false) => ", does not oscillate\n".to_owned(),
            _ => {
                let (frequency, ratio) = (readable(mode.frequency(), 9), plain(mode.damping_ratio(), 6));
                format!(", {frequency} Hz, damping ratio {ratio:.6}\n")
            }
        };
        let entries = coordinates.iter().zip(&mode.shape);
        let entries = entries.map(|(c, entry)| format!("{} {}", c.position.name, polar(entry.norm(), entry.arg())));
        text += &format!("{:<12} {}\n", "", entries.collect::<Vec<_>>().join(", "));
    }
    text
}

/// Both parts with nine decimals; of a slow mode, of what a power of ten multiplies that suits the larger one. Beside the
/// largest eigenvalue, what is 0 but for rounding is not slow.
fn complex(Complex { re, im }: Complex<f64>, largest: f64) -> String {
    let size = re.abs().max(im.abs());
    let exponent =
        if (1e-300..1e-3).contains(&size) && size > 1e-7 * largest { size.log10().floor() as i32 } else { 0 };
    let part = |value: f64| plain(value / 10f64.powi(exponent), 9);
    let text = format!("{:.9} {:+.9} i", part(re), part(im));
    if exponent == 0 { text } else { format!("({text}) e{exponent}") }
}

/// The number, without the sign where so many digits print it as zero.
fn plain(value: f64, digits: i32) -> f64 {
    if value.abs() < 0.5 * 0.1f64.powi(digits) { 0.0 } else { value }
}

/// A real number if the phase is 0 or half a turn, otherwise amplitude and phase in degrees.
fn polar(amplitude: f64, phase: f64) -> String {
    match phase {
        _ if phase.sin().abs() < 1e-6 || amplitude < 1e-9 => format!("{:.6}", plain(amplitude * phase.cos(), 6)),
        _ => format!("{amplitude:.6} at {:.2} deg", phase.to_degrees()),
    }
}
