//! `sim verify`.

use crate::Stop;
use crate::arguments::{VerifyArguments, Voice};
use crate::given::as_given;
use crate::said::Said;
use crate::settings::positive;
use serde_json::{Value, json};
use sim_kernel::Mechanism;
use sim_runtime::verify::{Check, verify_while};
use std::sync::atomic::{AtomicBool, Ordering};

/// Prints one row for each check; fails if one does.
pub(crate) fn verify_command<M: Mechanism>(
    mechanism: M,
    arguments: &VerifyArguments,
    voice: Voice,
) -> Result<(), Stop> {
    let (said, failing) = verified(mechanism, arguments, &AtomicBool::new(false))?;
    said.tell(voice)?;
    failing.map_or(Ok(()), |failing| Err(Stop::Failed(anyhow::Error::msg(failing))))
}

/// All checks, and which of them fail. Where `interrupted` is set, they end.
pub(crate) fn verified<M: Mechanism>(
    mechanism: M,
    arguments: &VerifyArguments,
    interrupted: &AtomicBool,
) -> Result<(Said, Option<String>), Stop> {
    let description = mechanism.description();
    let (mechanism, start) = as_given(&mechanism, &arguments.set, &arguments.initial)?;
    let end = positive("--t-end", &arguments.t_end)?;
    let checks = verify_while(mechanism, &start, end, &|| !interrupted.load(Ordering::Relaxed))?;
    let failing: Vec<&str> = checks.iter().filter(|check| !Check::passes(check)).map(|check| check.name).collect();
    let failing = (!failing.is_empty())
        .then(|| format!("{} of {} checks fail: {}", failing.len(), checks.len(), failing.join(", ")));
    Ok((Said { json: as_json(&checks), text: as_text(description.name, &checks) }, failing))
}

fn as_json(checks: &[Check]) -> Value {
    let row = |check: &Check| {
        json!({
            "name": check.name, "figure": check.figure, "bound": check.bound, "passes": check.passes(), "what": check.meaning,
        })
    };
    checks.iter().map(row).collect()
}

fn as_text(name: &str, checks: &[Check]) -> String {
    let mut text = format!("{name:<34} {:>9} {:>9}  {:<7} what\n", "figure", "bound", "verdict");
    for check in checks {
        let verdict = match check.figure {
            None => "-",
            Some(_) if check.passes() => "ok",
            Some(_) => "FAILS",
        };
        let Check { name, bound, meaning, .. } = check;
        let figure = check.figure.map_or("-".into(), |figure| format!("{figure:.1e}"));
        text += &format!("{name:<34} {figure:>9} {bound:>9.1e}  {verdict:<7} {meaning}\n");
    }
    text
}
