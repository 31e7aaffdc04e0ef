//! `sim check`.

use crate::arguments::{CheckArguments, Voice};
use crate::chosen::warn;
use crate::{Stop, print};
use codegen::mistakes::{Mistake, Position, Related};
use serde_json::{Value, json};
use sim_runtime::{DeclarationFile, LoadError};

/// Shows the mistakes of a file.
pub(crate) fn check(arguments: &CheckArguments, voice: Voice) -> Result<(), Stop> {
    let path = &arguments.file;
    let file = DeclarationFile::read(path)?;
    let found = file.check();
    if !voice.quiet && !voice.json {
        warn(&file.warnings());
    }
    if voice.json {
        let (names, mistakes) = match &found {
            Ok(names) => (names.clone(), Vec::new()),
            Err(mistakes) => (Vec::new(), mistakes.iter().map(as_json).collect()),
        };
        print(&format!("{:#}\n", json!({ "file": path, "mechanisms": names, "mistakes": mistakes })))?;
    }
    match found {
        Ok(names) if !voice.json && !voice.quiet => {
            print(&format!("{}: no mistakes in {}\n", path.display(), names.join(", ")))
        }
        Ok(_) => Ok(()),
        Err(mistakes) => {
            let failure = LoadError::Mistakes { path: path.clone(), text: file.text().to_owned(), mistakes };
            Err(if voice.json { Stop::Told } else { failure.into() })
        }
    }
}

/// For editors: ranges as the Language Server Protocol has them, and in bytes.
fn as_json(mistake: &Mistake) -> Value {
    let place = |at: Position| json!({ "line": at.line, "character": at.column_utf16 });
    let range = |start, end| json!({ "start": place(start), "end": place(end) });
    let bytes = |start: Position, end: Position| json!({ "start": start.byte, "end": end.byte });
    let related = |Related { message, start, end }: &Related| json!({ "message": message, "range": range(*start, *end), "bytes": bytes(*start, *end) });
    json!({
        "code": mistake.code,
        "message": mistake.message,
        "suggestion": mistake.suggestion(),
        "range": range(mistake.start, mistake.end),
        "bytes": bytes(mistake.start, mistake.end),
        "related": mistake.related.iter().map(related).collect::<Vec<_>>(),
    })
}
