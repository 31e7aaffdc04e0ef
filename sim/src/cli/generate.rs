//! `sim generate`.

use super::arguments::{GenerateArguments, Generated};
use super::run_file::SCHEMA;
use super::{Entry, Stop, own, print, program};

/// Prints completions, the man page or the schema.
pub(super) fn generate(arguments: &GenerateArguments, mechanisms: &[Entry]) -> Result<(), Stop> {
    let mut text = Vec::new();
    match arguments.what {
        Generated::Completions { shell } => {
            clap_complete::generate(shell, &mut own::with_names(mechanisms, &program()), program(), &mut text);
        }
        Generated::Man => man(mechanisms, &mut text)?,
        Generated::Schema => text.extend(SCHEMA.bytes()),
    }
    print(&String::from_utf8_lossy(&text))
}

/// One page with all commands.
fn man(mechanisms: &[Entry], out: &mut Vec<u8>) -> Result<(), Stop> {
    let mut command = own::command(mechanisms, &program());
    command.build();
    clap_mangen::Man::new(command.clone()).render(out)?;
    for sub in command.get_subcommands().filter(|sub| sub.get_name() != "help") {
        out.extend(format!(".SH \"COMMAND {}\"\n", sub.get_name().to_uppercase()).bytes());
        let page = clap_mangen::Man::new(sub.clone());
        page.render_description_section(out)?;
        page.render_synopsis_section(out)?;
        page.render_options_section(out)?;
    }
    Ok(())
}
