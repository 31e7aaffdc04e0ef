//! Files that a user goes on from.

use crate::arguments::Voice;
use crate::{Stop, print, program};
use sim_output::WriteError;
use std::fs::File;
use std::io::{ErrorKind, Write};
use std::path::Path;

/// Writes a declaration to a new file, and tells how it is run. One that is there is never overwritten.
pub(crate) fn write_declaration(path: &Path, text: &str, voice: Voice) -> Result<(), Stop> {
    let made =
        File::options().write(true).create_new(true).open(path).and_then(|mut file| file.write_all(text.as_bytes()));
    let shown = path.display();
    made.map_err(|why| match why.kind() {
        ErrorKind::AlreadyExists => Stop::Usage(format!("{shown} exists already; name a new file")),
        _ => WriteError::new(path, why).into(),
    })?;
    match voice {
        _ if voice.quiet => Ok(()),
        _ if voice.json => print(&format!("{:#}\n", serde_json::json!({ "file": path }))),
        _ => print(&format!("made         {shown}\nnext         {} run {shown}\n", program())),
    }
}
