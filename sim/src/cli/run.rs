//! `sim run`.

use super::arguments::RunArguments;
use super::list::counted;
use super::quantity::{parse_quantity, split_assignment};
use super::{Stop, unknown};
use crate::show;
use crate::{Grid, Run, Start, Table, WriteError, declared_start, run, summary, write_csv, write_json};
use serde_json::json;
use sim_kernel::{Array, Description, Mechanism};
use std::fs;
use std::io::Write;
use std::path::{Path, PathBuf};
use std::time::Instant;

/// Steps beyond which the files of a run would take gigabytes.
const MOST_STEPS: usize = 10_000_000;

/// Runs a mechanism, writes what it found, and prints a short table.
pub(super) fn run_command<M: Mechanism>(arguments: &RunArguments) -> Result<(), Stop> {
    let description = const { &M::DESCRIPTION };
    let clock = Instant::now();
    let mechanism = mechanism_with::<M>(description, &arguments.set)?;
    let start = start_with(&mechanism, description, &arguments.initial)?;
    let grid = grid(arguments)?;
    let directory = arguments.out.clone().unwrap_or_else(|| PathBuf::from("out").join(description.name));
    remove_earlier_results(description, &directory)?;
    let found = run(mechanism, &start, grid)?;
    fs::create_dir_all(&directory).map_err(|e| WriteError::new(&directory, e))?;
    let table = Table::of(&found.mechanism, &found.trajectory);
    write_csv(&table, &directory.join("trajectory.csv"))?;
    write_json(&summary(&found, &table), &directory.join("summary.json"))?;
    let before_figures = clock.elapsed();
    let wanted = !arguments.no_figures && !table.times().is_empty();
    let figures = if wanted { show::figures(&found, &table, &directory) } else { show::Figures::default() };
    if !table.times().is_empty() {
        let command = format!("sim run {}", description.name);
        let about = show::About { summary: &summary(&found, &table), command: &command, run_file: None };
        show::report(&found, &table, &about, &directory.join("report.html"))?;
    }
    let timing = json!({
        "integration_seconds": found.integration_time.as_secs_f64(),
        "without_figures_seconds": before_figures.as_secs_f64(),
        "total_seconds": clock.elapsed().as_secs_f64(),
    });
    write_json(&timing, &directory.join("timing.json"))?;
    let times = [before_figures.as_secs_f64(), clock.elapsed().as_secs_f64()];
    print(&report(&found, &table, figures.drawn, &directory, times))?;
    match (found.trajectory.failure, table.undefined_outputs().first(), figures.failures.into_iter().next()) {
        (Some(failure), ..) => Err(failure.into()),
        (None, Some((name, time)), _) => Err(Stop::Failed(anyhow::anyhow!(
            "output `{name}` is not finite at t = {time} s: its expression leaves its domain there (division by zero, root or \
             logarithm of a negative number). The motion is not affected"
        ))),
        (None, None, Some(failure)) => Err(failure.into()),
        (None, None, None) => Ok(()),
    }
}

/// Prints to a standard output that may be closed: whoever closed it has read enough.
fn print(text: &str) -> Result<(), Stop> {
    match std::io::stdout().lock().write_all(text.as_bytes()) {
        Err(error) if error.kind() != std::io::ErrorKind::BrokenPipe => Err(error.into()),
        _ => Ok(()),
    }
}

/// Removes what an earlier run wrote, so that nothing there is older than the run that it seems to belong to.
fn remove_earlier_results(description: &Description, directory: &Path) -> Result<(), Stop> {
    let figures = description.figures.iter().map(|figure| figure.name).chain(["mechanism"]);
    let figures = figures.flat_map(|name| [format!("{name}.svg"), format!("{name}.png")]);
    let tables = ["trajectory.csv", "summary.json", "timing.json"].map(String::from);
    for name in figures.chain(tables) {
        let path = directory.join(name);
        if path.is_file() {
            fs::remove_file(&path).map_err(|e| WriteError::new(&path, e))?;
        }
    }
    Ok(())
}

fn mechanism_with<M: Mechanism>(description: &Description, settings: &[String]) -> Result<M, Stop> {
    let mut parameters = M::defaults().parameters();
    for text in settings {
        let (name, value) = split_assignment("--set", text)?;
        let known = || description.parameters.iter().map(|p| p.name);
        if description.coordinates.iter().any(|c| [c.position.name, c.speed.name].contains(&name)) {
            return Err(Stop::Usage(format!("`{name}` is no parameter; its start is set by `--initial {text}`")));
        }
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
            if description.parameters.iter().any(|p| p.name == name) {
                return Err(Stop::Usage(format!("`{name}` is a parameter; it is set by `--set {text}`")));
            }
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

/// The short table for the terminal.
fn report<M: Mechanism>(
    run: &Run<M>,
    table: &Table,
    figures: usize,
    directory: &Path,
    [without, total]: [f64; 2],
) -> String {
    let description = const { &M::DESCRIPTION };
    let (steps, end) = (run.grid.steps, run.grid.end);
    let method = format!("{}, {} of {:.6e} s, projected", crate::RK4.name, counted(steps, "step"), end / steps as f64);
    let reached = table.times().last().copied().unwrap_or(0.0);
    let span = if reached == end { format!("0 to {end:?} s") } else { format!("0 to {reached:?} s of {end:?} s") };
    let mut rows = vec![("model", description.name.to_owned()), ("method", method), ("time", span)];
    match run.period() {
        Some(period) => rows.push(("period", format!("{period:.12} s"))),
        None if description.events.contains(&"period") => rows.push(("period", "not reached".into())),
        None => {}
    }
    for event in run.events.iter().filter(|event| event.name != "period").take(8) {
        rows.push(("event", format!("{} at {:.12} s", event.name, event.state.time)));
    }
    if M::L::LEN > 0 {
        let (positions, velocities) = (run.position_residual, run.velocity_residual);
        rows.push((
            "constraints",
            format!("open by at most {positions:.1e} (positions), {velocities:.1e} (velocities)"),
        ));
    }
    rows.push((
        "energy",
        format!("balance of kinetic energy and work off by at most {:.1e}, relative", run.energy_balance),
    ));
    if !(run.energy_balance < crate::DOUBTFUL_BALANCE) {
        rows.push(("warning", "energy does not balance: take smaller steps before you trust these numbers".into()));
    }
    let integration = 1e3 * run.integration_time.as_secs_f64();
    let (without, total) = (1e3 * without, 1e3 * total);
    rows.push((
        "wall time",
        format!("{integration:.2} ms integration, {without:.0} ms without figures, {total:.0} ms in all"),
    ));
    let files = format!("trajectory.csv, summary.json, timing.json, {}", counted(figures, "figure"));
    rows.push(("written", format!("{}: {files}", directory.display())));
    rows.iter().map(|(name, value)| format!("{name:<12} {value}\n")).collect()
}
