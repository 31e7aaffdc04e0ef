//! The command line over any mechanisms. A user's own program has all of it in one line:
//!
//! ```ignore
//! fn main() -> std::process::ExitCode {
//!     sim::cli::main(&[sim::cli::entry::<MyLinkage>()])
//! }
//! ```

mod arguments;
mod list;
mod quantity;
mod run;
mod settings;
mod statics;
mod verify;

use arguments::{Arguments, Command, RunArguments, StartArguments, VerifyArguments};
use clap::Parser;
use codegen::nearest;
use sim_kernel::{Description, Mechanism};
use std::process::ExitCode;

/// A mechanism that the command line can run.
#[derive(Clone, Copy)]
pub struct Entry {
    description: &'static Description,
    run: fn(&RunArguments) -> Result<(), Stop>,
    verify: fn(&VerifyArguments) -> Result<(), Stop>,
    assemble: fn(&StartArguments) -> Result<(), Stop>,
    equilibrium: fn(&StartArguments) -> Result<(), Stop>,
}

/// Makes a mechanism known to [`main`].
pub fn entry<M: Mechanism>() -> Entry {
    Entry {
        description: const { &M::DESCRIPTION },
        run: run::run_command::<M>,
        verify: verify::verify_command::<M>,
        assemble: statics::assemble_command::<M>,
        equilibrium: statics::equilibrium_command::<M>,
    }
}

/// Why a command did not do what it was asked.
enum Stop {
    /// The words of the command line are wrong; exit status 2.
    Usage(String),
    /// The work failed; exit status 1.
    Failed(anyhow::Error),
}

impl<E: Into<anyhow::Error>> From<E> for Stop {
    fn from(error: E) -> Stop {
        Stop::Failed(error.into())
    }
}

/// Reads the command line, does what it says, and gives the exit status: 0 for success, 1 for a run that failed,
/// 2 for words that could not be understood.
pub fn main(mechanisms: &[Entry]) -> ExitCode {
    match execute(mechanisms, Arguments::parse()) {
        Ok(()) => ExitCode::SUCCESS,
        Err(Stop::Usage(message)) => {
            eprintln!("error: {message}");
            ExitCode::from(2)
        }
        Err(Stop::Failed(error)) => {
            eprintln!("error: {error:#}");
            ExitCode::from(1)
        }
    }
}

fn execute(mechanisms: &[Entry], arguments: Arguments) -> Result<(), Stop> {
    match arguments.command {
        Command::List => list::list(mechanisms.iter().map(|entry| entry.description)),
        Command::Run(arguments) => {
            let entry = find(mechanisms, &arguments.model)?;
            (entry.run)(&arguments)
        }
        Command::Verify(arguments) => (find(mechanisms, &arguments.model)?.verify)(&arguments),
        Command::Assemble(arguments) => (find(mechanisms, &arguments.model)?.assemble)(&arguments),
        Command::Equilibrium(arguments) => (find(mechanisms, &arguments.model)?.equilibrium)(&arguments),
    }
}

fn find<'a>(mechanisms: &'a [Entry], name: &str) -> Result<&'a Entry, Stop> {
    let names = || mechanisms.iter().map(|entry| entry.description.name);
    mechanisms.iter().find(|entry| entry.description.name == name).ok_or_else(|| unknown("model", name, names()))
}

/// The message for a name that is not known.
fn unknown<'a>(kind: &str, name: &str, known: impl Iterator<Item = &'a str>) -> Stop {
    let known: Vec<&str> = known.collect();
    let near = nearest::suggestion(name, known.iter().copied());
    Stop::Usage(format!("no {kind} is called `{name}`{near}\nknown: {}", known.join(", ")))
}
