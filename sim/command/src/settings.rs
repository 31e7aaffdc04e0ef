//! How to run, from the command line.

use crate::quantity::parse_quantity;
use crate::{Stop, unknown};
use clap::Args;
use sim_kernel::Description;
use sim_runtime::{Method, Rows, Settings, Stabilisation, Stepping, StopAt, Tolerance};

/// Steps and rows beyond which the files of a run would take gigabytes.
const MOST: usize = 10_000_000;
/// A relative tolerance that doubles can still meet.
const LEAST_TOLERANCE: f64 = 1e-14;
/// The end of a run.
const T_END: &str = "2 s";
/// The method.
const METHOD: &str = "dop853";
/// The relative tolerance of a method that chooses its steps.
const RTOL: f64 = 1e-10;
/// Rows of a run whose method chooses its steps.
const ROWS: usize = 1024;
/// Steps of a method that does not choose them.
const STEPS: usize = 8192;

/// How to run.
#[derive(Args, Clone, Debug)]
pub(super) struct SettingsArguments {
    /// End of the run; in seconds unless a unit is given [default: 2 s].
    #[arg(long, value_name = "TIME", allow_hyphen_values = true)]
    t_end: Option<String>,

    /// Method: euler, heun, rk3, rk4, dopri5, radau5 (for stiff mechanisms), dop853 [default: dop853].
    #[arg(long, value_name = "NAME")]
    method: Option<String>,

    /// Relative tolerance of a method that chooses its steps: dopri5, radau5, dop853 [default: 1e-10].
    #[arg(long, value_name = "NUMBER", conflicts_with_all = ["steps", "step"], allow_hyphen_values = true)]
    rtol: Option<String>,

    /// Absolute tolerance: lengths in the mechanism's own length, angles in radians [default: rtol].
    #[arg(long, value_name = "NUMBER", conflicts_with_all = ["steps", "step"], allow_hyphen_values = true)]
    atol: Option<String>,

    /// Takes this many equal steps [default for euler, heun, rk3, rk4: 8192].
    #[arg(long, value_name = "N", conflicts_with = "step", value_parser = whole_number, allow_hyphen_values = true)]
    steps: Option<usize>,

    /// Takes equal steps of this size, made a little smaller if it does not divide the run.
    #[arg(long, value_name = "TIME", allow_hyphen_values = true)]
    step: Option<String>,

    /// What keeps the constraints: projection, mass-projection, partitioning; for comparison baumgarte=RATE (in 1/s)
    /// and none [default: projection].
    #[arg(long, value_name = "NAME")]
    projection: Option<String>,

    /// Records N + 1 rows at equal intervals, or `steps` for one after each step [default: steps where they are equal,
    /// else 1024]. A run that ends early has rows closer by a power of two, up to twice as many and one for four steps, and
    /// its last state.
    #[arg(long, value_name = "N|steps", allow_hyphen_values = true)]
    rows: Option<String>,

    /// Ends the run when an event happens, as in `--until period`, or for the third time: `--until period:3`.
    #[arg(long, value_name = "EVENT[:N]")]
    until: Option<String>,
}

impl SettingsArguments {
    /// What they say, or else the declaration's block `run`, or else the defaults.
    pub(super) fn settings(&self, description: &Description) -> Result<Settings, Stop> {
        self.with_declared(description).complete(description)
    }

    /// With what the declaration says of a run where these say nothing. Equal steps and tolerances exclude each other: whoever
    /// gives one of them, or a method that has no use for the declared ones, does not get the declared others.
    fn with_declared(&self, description: &Description) -> SettingsArguments {
        let declared = |option: &str| {
            let found = description.run.iter().find(|default| default.option == option);
            found.map(|default| default.value.to_owned())
        };
        let mut all = self.clone();
        let says_steps = self.steps.is_some() || self.step.is_some();
        let says_tolerance = self.rtol.is_some() || self.atol.is_some();
        let takes_equal = |name: &str| Method::ALL.iter().any(|method| method.name() == name && !method.is_adaptive());
        let has_tolerance = !self.method.as_deref().is_some_and(takes_equal);
        all.t_end = all.t_end.or_else(|| declared("t-end"));
        all.method = all.method.or_else(|| declared("method"));
        all.projection = all.projection.or_else(|| declared("projection"));
        all.rows = all.rows.or_else(|| declared("rows"));
        all.until = all.until.or_else(|| declared("until"));
        if !(says_steps || says_tolerance) {
            all.steps = declared("steps").and_then(|steps| steps.parse().ok());
            all.step = declared("step");
        }
        if !says_steps && has_tolerance {
            all.rtol = all.rtol.or_else(|| declared("rtol"));
            all.atol = all.atol.or_else(|| declared("atol"));
        }
        all
    }

    /// What a run is told where nothing else is said: options, values, and whether they are declared.
    pub(super) fn defaults(description: &Description) -> Vec<(&'static str, &'static str, bool)> {
        let declared = description.run.iter().map(|default| (default.option, default.value, true));
        let is_declared = |options: &[&str]| description.run.iter().any(|default| options.contains(&default.option));
        let mut all: Vec<_> = declared.collect();
        if !is_declared(&["t-end"]) {
            all.push(("t-end", T_END, false));
        }
        if !is_declared(&["method"]) {
            all.push(("method", METHOD, false));
        }
        all
    }

    fn complete(&self, description: &Description) -> Result<Settings, Stop> {
        let end = positive("--t-end", self.t_end.as_deref().unwrap_or(T_END))?;
        let method = self.method()?;
        let stepping = self.stepping(method, end)?;
        let (stabilisation, rows) = (self.stabilisation()?, self.rows(stepping)?);
        let stop = self.until.as_deref().map(|text| stop_at(text, description)).transpose()?;
        Ok(Settings { method, stepping, stabilisation, rows, stop, ..Settings::new(end) })
    }

    fn method(&self) -> Result<Method, Stop> {
        let name = self.method.as_deref().unwrap_or(METHOD);
        let names = Method::ALL.iter().map(|method| method.name());
        Method::ALL.into_iter().find(|method| method.name() == name).ok_or_else(|| unknown("method", name, names))
    }

    fn stepping(&self, method: Method, end: f64) -> Result<Stepping, Stop> {
        let steps = match (&self.step, self.steps) {
            // A step that divides the run within rounding is used unchanged.
            (Some(step), _) => (end / positive("--step", step)? * (1.0 - 1e-12)).ceil().max(1.0),
            (None, Some(steps)) => steps as f64,
            (None, None) if method.is_adaptive() => return Ok(Stepping::Adaptive(self.tolerance()?)),
            (None, None) if self.rtol.is_some() || self.atol.is_some() => return Err(no_tolerance(method)),
            (None, None) => STEPS as f64,
        };
        match (1.0..=MOST as f64).contains(&steps) {
            true => Ok(Stepping::Equal(steps as usize)),
            false => Err(Stop::Usage(format!("{steps} steps are asked for; from 1 to {MOST} are possible"))),
        }
    }

    fn tolerance(&self) -> Result<Tolerance, Stop> {
        let relative = self.rtol.as_deref().map_or(Ok(RTOL), |text| number("--rtol", text))?;
        let absolute = self.atol.as_deref().map_or(Ok(relative), |text| number("--atol", text))?;
        let possible = (LEAST_TOLERANCE..=0.1).contains(&relative) && absolute > 0.0;
        match possible {
            true => Ok(Tolerance { relative, absolute }),
            false => Err(Stop::Usage(format!(
                "--rtol from {LEAST_TOLERANCE:e} to 0.1 and --atol above 0 are possible; numbers here have 16 digits"
            ))),
        }
    }

    fn stabilisation(&self) -> Result<Stabilisation, Stop> {
        let known = ["projection", "mass-projection", "partitioning", "baumgarte=20", "none"];
        match self.projection.as_deref().unwrap_or("projection") {
            "projection" => Ok(Stabilisation::Projection),
            "mass-projection" => Ok(Stabilisation::MassProjection),
            "partitioning" => Ok(Stabilisation::Partitioning),
            "none" => Ok(Stabilisation::None),
            text => match text.strip_prefix("baumgarte=") {
                Some(rate) => Ok(Stabilisation::Baumgarte(number("--projection baumgarte", rate)?)),
                None => Err(unknown("projection", text, known.into_iter())),
            },
        }
    }

    fn rows(&self, stepping: Stepping) -> Result<Rows, Stop> {
        match (self.rows.as_deref(), stepping) {
            (None, Stepping::Adaptive(_)) => Ok(Rows::Even(ROWS)),
            (None, Stepping::Equal(_)) | (Some("steps"), _) => Ok(Rows::Steps),
            (Some(text), _) => match text.parse::<usize>() {
                Ok(rows) if (1..=MOST).contains(&rows) => Ok(Rows::Even(rows)),
                _ => Err(Stop::Usage(format!("--rows: `steps` or a whole number from 1 to {MOST} is needed"))),
            },
        }
    }
}

/// The message for a method that has no use for a tolerance.
fn no_tolerance(method: Method) -> Stop {
    let adaptive: Vec<&str> =
        Method::ALL.iter().filter(|method| method.is_adaptive()).map(|method| method.name()).collect();
    Stop::Usage(format!(
        "--rtol and --atol: {} takes equal steps and estimates no error; give their number with --steps, or a method that \
         chooses them: {}",
        method.name(),
        adaptive.join(", ")
    ))
}

fn stop_at(text: &str, description: &Description) -> Result<StopAt, Stop> {
    let (name, occurrence) = match text.split_once(':') {
        Some((name, count)) => (name, whole_number(count).map_err(|e| Stop::Usage(format!("--until {text}: {e}")))?),
        None => (text, 1),
    };
    let events = || description.events.iter().map(|event| event.name);
    let event = events().position(|event| event == name).ok_or_else(|| unknown("event", name, events()))?;
    Ok(StopAt { event, occurrence })
}

/// A time above 0, in seconds.
pub(super) fn positive(option: &str, text: &str) -> Result<f64, Stop> {
    let time = parse_quantity(option, text, "s")?;
    if time > 0.0 { Ok(time) } else { Err(Stop::Usage(format!("{option}: a time above 0 is needed, not `{text}`"))) }
}

fn number(option: &str, text: &str) -> Result<f64, Stop> {
    let value = parse_quantity(option, text, "1")?;
    if value > 0.0 {
        Ok(value)
    } else {
        Err(Stop::Usage(format!("{option}: a number above 0 is needed, not `{text}`")))
    }
}

fn whole_number(text: &str) -> Result<usize, String> {
    text.parse().ok().filter(|n| *n > 0).ok_or_else(|| "a whole number above 0 is needed, such as 8192".to_owned())
}

#[cfg(test)]
mod tests {
    use super::*;

    /// What the language calls methods is what they are called here.
    #[test]
    fn the_language_knows_the_methods() {
        let names = Method::ALL.map(|method| (method.name(), method.is_adaptive()));
        assert_eq!(codegen::model::METHODS, names);
    }
}
