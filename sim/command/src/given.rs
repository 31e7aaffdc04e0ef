//! A mechanism and its start as the user gives them.

use crate::quantity::{parse_quantity, split_assignment};
use crate::{Stop, unknown};
use sim_kernel::{Description, Input, Mechanism};
use sim_runtime::{Start, declared_start};

/// A mechanism with the parameters, and its start with the values, that the user gives.
pub(super) fn as_given<M: Mechanism>(mechanism: &M, set: &[String], initial: &[String]) -> Result<(M, Start<M>), Stop> {
    let mechanism = with_set(mechanism, set)?;
    let start = start_with(&mechanism, initial)?;
    Ok((mechanism, start))
}

/// The mechanism with the parameters that the user sets.
fn with_set<M: Mechanism>(mechanism: &M, settings: &[String]) -> Result<M, Stop> {
    let mut parameters = mechanism.parameters();
    set(parameters.as_mut(), mechanism.description(), settings)?;
    Ok(mechanism.with_parameters(parameters))
}

/// Sets parameters to the user's values.
pub(super) fn set(parameters: &mut [f64], description: &Description, settings: &[String]) -> Result<(), Stop> {
    for text in settings {
        let (name, value) = split_assignment("--set", text)?;
        let known = || description.parameters.iter().map(|p| p.name);
        if description.coordinates.iter().any(|c| [c.position.name, c.speed.name].contains(&name)) {
            return Err(Stop::Usage(format!("`{name}` is not a parameter; set its start with `--initial {text}`")));
        }
        if description.inputs.iter().any(|input| input.name == name) {
            return Err(Stop::Usage(format!("`{name}` is an input; hold it with `run --input {text}`")));
        }
        let at = known().position(|p| p == name).ok_or_else(|| unknown("parameter", name, known()))?;
        parameters[at] = parse_quantity(name, value, description.parameters[at].unit)?;
    }
    Ok(())
}

/// The mechanism with inputs held at the user's values.
pub(super) fn held_at<M: Mechanism>(mechanism: &M, settings: &[String]) -> Result<M, Stop> {
    let mut inputs = mechanism.inputs();
    hold(inputs.as_mut(), mechanism.description(), settings)?;
    Ok(mechanism.with_inputs(inputs))
}

/// Holds inputs at the user's values.
pub(super) fn hold(inputs: &mut [Input<f64>], description: &Description, settings: &[String]) -> Result<(), Stop> {
    for text in settings {
        let (name, value) = split_assignment("--input", text)?;
        let known = || description.inputs.iter().map(|input| input.name);
        if description.parameters.iter().any(|p| p.name == name) {
            return Err(Stop::Usage(format!("`{name}` is a parameter; set it with `--set {text}`")));
        }
        let at = known().position(|input| input == name).ok_or_else(|| unknown("input", name, known()))?;
        inputs[at] = Input::Held(parse_quantity(name, value, description.inputs[at].unit)?);
    }
    Ok(())
}

/// The declared start with the user's values.
fn start_with<M: Mechanism>(mechanism: &M, settings: &[String]) -> Result<Start<M>, Stop> {
    let description = mechanism.description();
    let mut start = declared_start(mechanism);
    for (started, value) in started(description, settings)? {
        match started {
            Started::Position(at) => {
                start.positions[at] = value;
                start.position_given[at] = description.coordinates[at].start != sim_kernel::Start::Guess;
            }
            Started::Speed(at) => {
                start.speeds[at] = value;
                start.speed_given[at] = true;
            }
        }
    }
    Ok(start)
}

/// A coordinate or a speed, by index.
enum Started {
    Position(usize),
    Speed(usize),
}

/// The user's start values.
fn started(description: &Description, settings: &[String]) -> Result<Vec<(Started, f64)>, Stop> {
    let mut said = Vec::new();
    for text in settings {
        let (name, value) = split_assignment("--initial", text)?;
        let coordinates = description.coordinates;
        if let Some(at) = coordinates.iter().position(|c| c.position.name == name) {
            said.push((Started::Position(at), parse_quantity(name, value, coordinates[at].position.unit)?));
        } else if let Some(at) = coordinates.iter().position(|c| c.speed.name == name) {
            said.push((Started::Speed(at), parse_quantity(name, value, coordinates[at].speed.unit)?));
        } else {
            if description.parameters.iter().any(|p| p.name == name) {
                return Err(Stop::Usage(format!("`{name}` is a parameter; set it with `--set {text}`")));
            }
            let known = coordinates.iter().flat_map(|c| [c.position.name, c.speed.name]);
            return Err(unknown("coordinate or speed", name, known));
        }
    }
    Ok(said)
}
