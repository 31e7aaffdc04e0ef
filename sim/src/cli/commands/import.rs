//! `sim import`.

use crate::cli::arguments::{ImportArguments, Voice};
use crate::cli::chosen::warn;
use crate::cli::{Stop, print, program};
use crate::{DeclarationFile, LoadError, Provenance, WriteError};
use std::fs::File;
use std::io::{ErrorKind, Write};

/// Writes a robot's declaration.
pub(in crate::cli) fn import(arguments: &ImportArguments, voice: Voice) -> Result<(), Stop> {
    let path = &arguments.file;
    if path.extension().is_none_or(|extension| !extension.eq_ignore_ascii_case("urdf")) {
        return Err(Stop::Usage(format!("{}: a robot's file ends in `.urdf`", path.display())));
    }
    let file = DeclarationFile::read(path)?.with_robots(arguments.options());
    let robot = file.robot().map_err(|mistakes| LoadError::Mistakes {
        path: path.clone(),
        text: file.text().to_owned(),
        mistakes,
    })?;
    if !voice.quiet {
        warn(&file.warnings());
    }
    let text = format!("// Written by {}, from {}.\n{}", Provenance::program(), said(path), robot.text);
    let Some(out) = &arguments.out else { return print(&text) };
    // One that is there is never overwritten.
    let made =
        File::options().write(true).create_new(true).open(out).and_then(|mut file| file.write_all(text.as_bytes()));
    made.map_err(|why| match why.kind() {
        ErrorKind::AlreadyExists => Stop::Usage(format!("{} exists already; name a new file", out.display())),
        _ => WriteError::new(out, why).into(),
    })?;
    match voice {
        _ if voice.quiet => Ok(()),
        _ if voice.json => print(&format!("{:#}\n", serde_json::json!({ "file": out }))),
        _ => print(&format!("made         {}\nnext         {} run {}\n", out.display(), program(), out.display())),
    }
}

/// The name of the file alone, on one line.
fn said(path: &std::path::Path) -> String {
    let name = path.file_name().map(|name| name.to_string_lossy().into_owned()).unwrap_or_default();
    name.chars().map(|c| if c.is_control() { ' ' } else { c }).collect()
}
