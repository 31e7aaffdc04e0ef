//! How a mechanism is run where nothing else is said: as Modelica's annotation `experiment`, in the language.

use super::dimension::Dimension;
use super::interpreter::Interpreter;
use super::scope::plain;
use super::units::Unit;
use crate::dsl::{Declaration, Region, RunSetting, RunValue};
use crate::nearest;

/// Methods, with whether they choose their steps.
pub const METHODS: [(&str, bool); 7] = [
    ("euler", false),
    ("heun", false),
    ("rk3", false),
    ("rk4", false),
    ("dopri5", true),
    ("radau5", true),
    ("dop853", true),
];

/// What keeps the constraints.
const PROJECTIONS: [&str; 4] = ["projection", "mass_projection", "partitioning", "none"];

/// A setting, as a program takes it on its command line.
#[derive(Clone, PartialEq, Eq, Debug)]
pub struct RunDefault {
    /// The option, without dashes in front: `t-end`.
    pub option: &'static str,
    /// Its value: `30 ms`.
    pub value: String,
}

/// What may be set.
#[derive(Clone, Copy, PartialEq, Eq)]
enum Setting {
    Time,
    Number,
    Count,
    CountOrSteps,
    Method,
    Projection,
    Event,
}

/// By its name here and on a command line.
const SETTINGS: [(&str, &str, Setting); 9] = [
    ("t_end", "t-end", Setting::Time),
    ("method", "method", Setting::Method),
    ("rtol", "rtol", Setting::Number),
    ("atol", "atol", Setting::Number),
    ("steps", "steps", Setting::Count),
    ("step", "step", Setting::Time),
    ("projection", "projection", Setting::Projection),
    ("rows", "rows", Setting::CountOrSteps),
    ("until", "until", Setting::Event),
];

/// The settings of the block `run`.
pub(super) fn resolve_run(declaration: &Declaration, interpreter: &mut Interpreter) -> Vec<RunDefault> {
    let mut settings: Vec<RunDefault> = Vec::new();
    for setting in &declaration.run {
        match resolved(setting, declaration, &settings) {
            Ok(found) => settings.push(found),
            Err(mistake) => interpreter.mistakes.add(mistake),
        }
    }
    settings
}

fn resolved(setting: &RunSetting, declaration: &Declaration, before: &[RunDefault]) -> syn::Result<RunDefault> {
    let (name, place) = (plain(&setting.name), Region::from(&setting.name));
    let names = || SETTINGS.iter().map(|(name, ..)| *name);
    let Some((_, option, kind)) = SETTINGS.iter().find(|(known, ..)| *known == name) else {
        let near = nearest::suggestion(&name, names());
        let known = names().map(|name| format!("`{name}`")).collect::<Vec<_>>().join(", ");
        return Err(place.error(format!("`{name}` is no setting of a run{near}; settings are {known}")));
    };
    if before.iter().any(|other| other.option == *option) {
        return Err(place.error(format!("`{name}` is set twice")));
    }
    let value = text(&setting.value, *kind, declaration)?;
    if let Some(other) = contradicts(option, &value, before) {
        return Err(place.error(other));
    }
    Ok(RunDefault { option, value })
}

/// What another setting leaves no room for.
fn contradicts(option: &str, value: &str, before: &[RunDefault]) -> Option<String> {
    let has = |options: &[&str]| before.iter().find(|other| options.contains(&other.option)).map(|other| other.option);
    let others: &[&str] = match option {
        "steps" => &["step", "rtol", "atol"],
        "step" => &["steps", "rtol", "atol"],
        "rtol" | "atol" => &["steps", "step"],
        _ => &[],
    };
    if let Some(other) = has(others) {
        let other = other.replace('-', "_");
        return Some(format!("`{option}` and `{other}` exclude each other: steps are equal, or chosen by a tolerance"));
    }
    let takes_equal = |name: &str| METHODS.iter().any(|(method, chooses)| *method == name && !chooses);
    let method = before.iter().find(|other| other.option == "method").map_or("dop853", |other| &other.value);
    let is_tolerance = ["rtol", "atol"].contains(&option);
    if is_tolerance && takes_equal(method)
        || option == "method" && takes_equal(value) && has(&["rtol", "atol"]).is_some()
    {
        let method = if is_tolerance { method } else { value };
        return Some(format!("{method} takes equal steps and has no tolerance; give `steps` or `step`"));
    }
    None
}

/// A value as text.
fn text(value: &RunValue, kind: Setting, declaration: &Declaration) -> syn::Result<String> {
    let fail = |message: String| Err(value.region().error(message));
    match (kind, value) {
        (Setting::Time, RunValue::Number { text, unit, region }) => time(text, unit.as_ref(), *region),
        (Setting::Number, RunValue::Number { text, unit: None, .. }) if is_positive(text) => Ok(text.clone()),
        (Setting::Count | Setting::CountOrSteps, RunValue::Number { text, unit: None, .. })
            if text.parse::<usize>().is_ok_and(|count| count > 0) =>
        {
            Ok(text.clone())
        }
        (Setting::CountOrSteps, RunValue::Word { word, count: None }) if word == "steps" => Ok("steps".to_owned()),
        (Setting::Method, RunValue::Word { word, count: None }) => {
            one_of(&plain(word), "method", METHODS.iter().map(|(name, _)| *name), value.region())
        }
        (Setting::Projection, RunValue::Word { word, count: None }) => {
            let found = one_of(&plain(word), "projection", PROJECTIONS.into_iter(), value.region())?;
            Ok(found.replace('_', "-"))
        }
        (Setting::Event, RunValue::Word { word, count }) => {
            let names: Vec<String> = declaration.events.iter().map(|event| plain(&event.condition.name)).collect();
            let event = one_of(&plain(word), "event", names.iter().map(String::as_str), value.region())?;
            Ok(count.map_or(event.clone(), |count| format!("{event}:{count}")))
        }
        (Setting::Time, _) => fail("a time is needed: `t_end = 30 [ms];`".to_owned()),
        (Setting::Number, _) => fail("a number above 0 is needed: `rtol = 1e-11;`".to_owned()),
        (Setting::Count, _) => fail("a whole number above 0 is needed: `steps = 8192;`".to_owned()),
        (Setting::CountOrSteps, _) => fail("a whole number above 0, or `steps`, is needed: `rows = 600;`".to_owned()),
        (Setting::Method, _) => fail("a method is needed: `method = dop853;`".to_owned()),
        (Setting::Projection, _) => fail("a projection is needed: `projection = partitioning;`".to_owned()),
        (Setting::Event, _) => fail("an event is needed: `until = period;`, or `until = period: 3;`".to_owned()),
    }
}

fn is_positive(text: &str) -> bool {
    text.parse::<f64>().is_ok_and(|value| value > 0.0 && value.is_finite())
}

/// A time above 0, in seconds where it has no unit.
fn time(text: &str, unit: Option<&crate::dsl::Unit>, region: Region) -> syn::Result<String> {
    if !is_positive(text) {
        return Err(region.error("a time above 0 is needed"));
    }
    let Some(written) = unit else { return Ok(format!("{text} s")) };
    let unit = Unit::resolve(written)?;
    match *unit.dimension() == Dimension::time() {
        true => Ok(format!("{text} {}", unit.text())),
        false => Err(written.region.error(format!("`{}` is no unit of time; write `[s]` or `[ms]`", unit.text()))),
    }
}

/// The word, if it is one of these.
fn one_of<'a>(word: &str, kind: &str, known: impl Iterator<Item = &'a str> + Clone, at: Region) -> syn::Result<String> {
    if known.clone().any(|one| one == word) {
        return Ok(word.to_owned());
    }
    let near = nearest::suggestion(word, known.clone());
    let all: Vec<String> = known.map(|one| format!("`{one}`")).collect();
    let told = if all.is_empty() { "there is none".to_owned() } else { format!("there are {}", all.join(", ")) };
    Err(at.error(format!("no {kind} is called `{word}`{near}; {told}")))
}
