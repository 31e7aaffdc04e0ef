//! `sim run`.

use super::arguments::RunArguments;
use super::quantity::{parse_quantity, split_assignment};
use super::{Stop, unknown};
use crate::show;
use crate::{Grid, Run, Start, Table, WriteError, declared_start, run, summary, write_csv, write_json};
use serde_json::json;
use sim_kernel::{Array, Description, Mechanism};
use std::fs;
use std::path::{Path, PathBuf};
use std::time::Instant;

/// Steps beyond which a run would not fit in memory.
const MOST_STEPS: usize = 100_000_000;

/// Runs a mechanism, writes what it found, and prints a short table.
pub(super) fn run_command<M: Mechanism>(arguments: &RunArguments) -> Result<(), Stop> {
    let description = const { &M::DESCRIPTION };
    let clock = Instant::now();
    let mechanism = mechanism_with::<M>(description, &arguments.set)?;
    let start = start_with(&mechanism, description, &arguments.initial)?;
    let grid = grid(arguments)?;
    let directory = arguments.out.clone().unwrap_or_else(|| PathBuf::from("out").join(description.name));
    let found = run(mechanism, &start, grid)?;
    fs::create_dir_all(&directory).map_err(|e| WriteError::new(&directory, e))?;
    let table = Table::of(&found.mechanism, &found.trajectory);
    write_csv(&table, &directory.join("trajectory.csv"))?;
    write_json(&summary(&found), &directory.join("summary.json"))?;
    let before_figures = clock.elapsed();
    let figures = if arguments.no_figures { 0 } else { show::figures(&found, &table, &directory)? };
    let timing = json!({
        "integration_seconds": found.integration_time.as_secs_f64(),
        "without_figures_seconds": before_figures.as_secs_f64(),
        "total_seconds": clock.elapsed().as_secs_f64(),
    });
    write_json(&timing, &directory.join("timing.json"))?;
    report(&found, &table, figures, &directory, [before_figures.as_secs_f64(), clock.elapsed().as_secs_f64()]);
    match found.trajectory.failure {
        Some(failure) => Err(failure.into()),
        None => Ok(()),
    }
}

fn mechanism_with<M: Mechanism>(description: &Description, settings: &[String]) -> Result<M, Stop> {
    let mut parameters = M::defaults().parameters();
    for text in settings {
        let (name, value) = split_assignment("--set", text)?;
        let known = || description.parameters.iter().map(|p| p.name);
        let at = known().position(|p| p == name).ok_or_else(|| unknown("parameter", name, known()))?;
        parameters[at] = parse_quantity(name, value, description.parameters[at].unit)?;
    }
    Ok(M::with_parameters(parameters))
}

fn start_with<M: Mechanism>(mechanism: &M, description: &Description, settings: &[String]) -> Result<Start<M>, Stop> {
    let mut start = declared_start(mechanism);
    for text in settings {
        let (name, value) = split_assignment("--initial", text)?;
        let coordinates = description.coordinates;
        if let Some(at) = coordinates.iter().position(|c| c.position.name == name) {
            start.positions[at] = parse_quantity(name, value, coordinates[at].position.unit)?;
            let stays_guess = coordinates[at].start == sim_kernel::Start::Guess;
            start.position_given[at] = if stays_guess { 0.0 } else { 1.0 };
        } else if let Some(at) = coordinates.iter().position(|c| c.speed.name == name) {
            start.speeds[at] = parse_quantity(name, value, coordinates[at].speed.unit)?;
            start.speed_given[at] = 1.0;
        } else {
            let known = coordinates.iter().flat_map(|c| [c.position.name, c.speed.name]);
            return Err(unknown("coordinate or speed", name, known));
        }
    }
    Ok(start)
}

fn grid(arguments: &RunArguments) -> Result<Grid, Stop> {
    let end = positive("--t-end", &arguments.t_end)?;
    let steps = match &arguments.step {
        // A step that divides the run up to rounding is taken as it is.
        Some(step) => (end / positive("--step", step)? * (1.0 - 1e-12)).ceil().max(1.0),
        None => arguments.steps as f64,
    };
    if !(1.0..=MOST_STEPS as f64).contains(&steps) {
        return Err(Stop::Usage(format!("{steps:e} steps are asked for; from 1 to {MOST_STEPS:e} are possible")));
    }
    Ok(Grid { end, steps: steps as usize })
}

fn positive(option: &str, text: &str) -> Result<f64, Stop> {
    let time = parse_quantity(option, text, "s")?;
    if time > 0.0 { Ok(time) } else { Err(Stop::Usage(format!("{option}: a time above 0 is needed, not `{text}`"))) }
}

/// The short table on the terminal.
fn report<M: Mechanism>(run: &Run<M>, table: &Table, figures: usize, directory: &Path, [without, total]: [f64; 2]) {
    let description = const { &M::DESCRIPTION };
    let reached = table.times().last().copied().unwrap_or(0.0);
    let mut rows = vec![
        ("model", description.name.to_owned()),
        (
            "method",
            format!(
                "{}, {} steps of {:.6e} s to {} s, projected",
                crate::RK4.name,
                run.grid.steps,
                run.grid.end / run.grid.steps as f64,
                reached
            ),
        ),
    ];
    match run.period() {
        Some(period) => rows.push(("period", format!("{period:.12} s"))),
        None if description.events.contains(&"period") => rows.push(("period", "not reached".into())),
        None => {}
    }
    for event in run.events.iter().filter(|event| event.name != "period").take(8) {
        rows.push(("event", format!("{} at {:.12} s", event.name, event.state.time)));
    }
    if M::L::LEN > 0 {
        rows.push((
            "constraints",
            format!(
                "open by at most {:.1e} (positions), {:.1e} (velocities)",
                run.position_residual, run.velocity_residual
            ),
        ));
    }
    rows.push(("energy", format!("kinetic energy minus work changes by at most {:.1e}, relative", run.energy_balance)));
    rows.push((
        "time",
        format!(
            "{:.2} ms integration, {:.0} ms without figures, {:.0} ms in all",
            1e3 * run.integration_time.as_secs_f64(),
            1e3 * without,
            1e3 * total
        ),
    ));
    rows.push((
        "written",
        format!("{}: trajectory.csv, summary.json, timing.json, {figures} figures", directory.display()),
    ));
    for (name, value) in rows {
        println!("{name:<12} {value}");
    }
}
