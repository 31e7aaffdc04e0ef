//! `sim generate`.

use super::arguments::{Arguments, GenerateArguments, Generated};
use super::run_file::SCHEMA;
use super::{Stop, print, program};
use clap::CommandFactory;

/// Prints completions, the man page or the schema.
pub(super) fn generate(arguments: &GenerateArguments) -> Result<(), Stop> {
    let mut text = Vec::new();
    match arguments.what {
        Generated::Completions { shell } => {
            clap_complete::generate(shell, &mut Arguments::command(), program(), &mut text);
        }
        Generated::Man => man(&mut text)?,
        Generated::Schema => text.extend(SCHEMA.bytes()),
    }
    print(&String::from_utf8_lossy(&text))
}

/// One page with all commands.
fn man(out: &mut Vec<u8>) -> Result<(), Stop> {
    let mut command = Arguments::command().name("sim");
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
