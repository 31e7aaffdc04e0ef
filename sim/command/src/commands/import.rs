//! `sim import`.

use crate::arguments::{ImportArguments, Voice};
use crate::chosen::warn;
use crate::files::new::write_declaration;
use crate::{Stop, print};
use sim_runtime::{DeclarationFile, Provenance};

/// Writes a robot's declaration.
pub(crate) fn import(arguments: &ImportArguments, voice: Voice) -> Result<(), Stop> {
    let path = &arguments.file;
    if path.extension().is_none_or(|extension| !extension.eq_ignore_ascii_case("urdf")) {
        return Err(Stop::Usage(format!("{}: a robot's file ends in `.urdf`", path.display())));
    }
    let file = DeclarationFile::read(path)?.with_robots(arguments.options());
    let robot = file.robot()?;
    if !voice.quiet {
        warn(&file.warnings());
    }
    let text = format!("// Written by {}, from {}.\n{}", Provenance::program(), said(path), robot.text);
    match &arguments.out {
        Some(out) => write_declaration(out, &text, voice),
        None => print(&text),
    }
}

/// The name of the file alone, on one line.
fn said(path: &std::path::Path) -> String {
    let name = path.file_name().map(|name| name.to_string_lossy().into_owned()).unwrap_or_default();
    name.chars().map(|c| if c.is_control() { ' ' } else { c }).collect()
}
