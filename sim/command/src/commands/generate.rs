//! `sim generate`.

use crate::arguments::{GenerateArguments, Generated};
use crate::files::run_file::SCHEMA;
use crate::own;
use crate::{Entry, Stop, print, program};
use clap::Command;
use clap_complete::Shell;

/// Prints completions, the man page or the schema.
pub(crate) fn generate(arguments: &GenerateArguments, mechanisms: &[Entry]) -> Result<(), Stop> {
    let mut text = Vec::new();
    match arguments.what {
        Generated::Completions { shell } => {
            let mut command = own::with_names(mechanisms, &program());
            clap_complete::generate(shell, &mut command, program(), &mut text);
            if shell == Shell::Fish {
                text.extend(fish_names(&command, mechanisms, &program()).bytes());
            }
        }
        Generated::Man => man(mechanisms, &mut text)?,
        Generated::Schema => text.extend(SCHEMA.bytes()),
    }
    print(&String::from_utf8_lossy(&text))
}

/// The names of mechanisms for fish, for which clap_complete offers no values of positional arguments.
fn fish_names(command: &Command, mechanisms: &[Entry], program: &str) -> String {
    let names: Vec<&str> = mechanisms.iter().map(|entry| entry.name()).collect();
    let takes_one = |sub: &&Command| sub.get_arguments().any(|argument| argument.get_id() == "model");
    let function = format!("__fish_{}_using_subcommand", program.replace('-', "_"));
    let line = |sub: &Command| {
        format!("complete -c {program} -n \"{function} {}\" -f -a \"{}\"\n", sub.get_name(), names.join(" "))
    };
    command.get_subcommands().filter(takes_one).map(line).collect()
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
