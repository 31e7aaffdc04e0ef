//! `sim new --file`.

use crate::arguments::{NewArguments, Voice};
use crate::chosen::chosen;
use crate::commands::new::{CRATE, type_name};
use crate::files::new::write_declaration;
use crate::{Entry, Stop};
use sim_runtime::Provenance;

/// Writes a declaration to a file of its own.
pub(crate) fn new_file(mechanisms: &[Entry], arguments: &NewArguments, voice: Voice) -> Result<(), Stop> {
    let path = &arguments.path;
    if path.extension().is_none_or(|extension| extension != "mech") {
        return Err(Stop::Usage(format!(
            "{}: a declaration's file ends in `.mech`, as in `linkage.mech`",
            path.display()
        )));
    }
    let text = match &arguments.from {
        Some(model) => {
            format!("{}\n{}", head(), chosen(mechanisms, model, voice.quiet)?.model.description().declaration)
        }
        None => {
            let stem = path.file_stem().map(|stem| stem.to_string_lossy().into_owned()).unwrap_or_default();
            let name = type_name(&stem);
            if !name.starts_with(|c: char| c.is_ascii_uppercase()) || !name.chars().all(|c| c.is_ascii_alphanumeric()) {
                return Err(Stop::Usage(format!(
                    "`{stem}` cannot name a mechanism: letters and digits do, as in `my-linkage`"
                )));
            }
            format!("{}\n{}", head(), first(&name))
        }
    };
    write_declaration(path, &text, voice)
}

fn head() -> String {
    format!("// Written by {}.\nlanguage 1;\n", Provenance::program())
}

/// The declaration of a new crate, out of its braces.
fn first(name: &str) -> String {
    let (_, inside) = CRATE.split_once("mechanism! {\n").unwrap_or(("", CRATE));
    let inside = inside.trim_end().trim_end_matches('}').replace("{{type}}", name);
    inside.lines().map(|line| format!("{}\n", line.strip_prefix("    ").unwrap_or(line))).collect()
}
