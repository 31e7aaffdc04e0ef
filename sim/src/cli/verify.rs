//! `sim verify`.

use super::Stop;
use super::arguments::VerifyArguments;
use super::run::{mechanism_with, start_with};
use super::settings::positive;
use crate::verify::{Check, verify};
use sim_kernel::Mechanism;
use std::io::Write;

/// Prints one row for each check; fails if one does.
pub(super) fn verify_command<M: Mechanism>(arguments: &VerifyArguments) -> Result<(), Stop> {
    let description = const { &M::DESCRIPTION };
    let mechanism = mechanism_with::<M>(description, &arguments.set)?;
    let start = start_with(&mechanism, description, &arguments.initial)?;
    let checks = verify(mechanism, &start, positive("--t-end", &arguments.t_end)?)?;
    let mut out = std::io::stdout().lock();
    writeln!(out, "{:<34} {:>9} {:>9}  {:<7}what", description.name, "figure", "bound", "verdict")?;
    for check in &checks {
        let verdict = if check.passes() { "ok" } else { "FAILS" };
        writeln!(
            out,
            "{:<34} {:>9.1e} {:>9.0e}  {verdict:<7} {}",
            check.name, check.figure, check.bound, check.meaning
        )?;
    }
    let failing: Vec<&str> = checks.iter().filter(|check| !Check::passes(check)).map(|check| check.name).collect();
    match failing.is_empty() {
        true => Ok(()),
        false => Err(Stop::Failed(anyhow::anyhow!(
            "{} of {} checks fail: {}",
            failing.len(),
            checks.len(),
            failing.join(", ")
        ))),
    }
}
