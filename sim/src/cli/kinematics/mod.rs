//! `sim kinematics`.

mod arguments;
mod report;
mod summary;

pub(super) use arguments::KinematicsArguments;

use super::arguments::Voice;
use super::files::Files;
use super::run::{mechanism_with, start_with};
use super::{Stop, print};
use crate::show::{self, SWEEP_FIGURES};
use crate::{Kinematics, kinematics, write_json};
use report::report;
use sim_kernel::Mechanism;
use summary::summary;

/// Drives a mechanism through a range, writes what it did, and prints a summary.
pub(in crate::cli) fn kinematics_command<M: Mechanism>(
    arguments: &KinematicsArguments,
    voice: Voice,
) -> Result<(), Stop> {
    let description = const { &M::DESCRIPTION };
    let mechanism = mechanism_with::<M>(description, &arguments.set)?;
    let start = start_with(&mechanism, description, &arguments.initial)?;
    let sweep = arguments.sweep(&mechanism, &start)?;
    let directory = arguments.out.clone().unwrap_or_else(|| format!("out/{}-kinematics", description.name).into());
    let mut files = Files::new(description, &directory, &SWEEP_FIGURES)?;
    let found = kinematics(mechanism, &start, &sweep)?;
    write(&found, arguments, &mut files);
    if voice.json && !voice.quiet {
        let mut said = summary(&found);
        said["directory"] = directory.to_string_lossy().into();
        said["files"] = files.names.clone().into();
        print(&format!("{said:#}\n"))?;
    } else if !voice.quiet {
        print(&format!("{}written      {}: {}\n", report(&found), directory.display(), files.names.join(", ")))?;
    }
    files.check(found.trajectory.failure.iter().map(ToString::to_string).collect())
}

fn write<M: Mechanism>(found: &Kinematics<M>, arguments: &KinematicsArguments, files: &mut Files) {
    let table = found.table();
    files.add_table(&table, &arguments.format);
    files.add("summary.json", |path| write_json(&summary(found), path));
    if !arguments.no_figures && !table.times().is_empty() {
        files.add_figures(&show::sweep_figures(found, &table, files.directory(), arguments.size.show()));
    }
}
