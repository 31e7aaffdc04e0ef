//! The command line over any mechanisms. A user's own program gets all of it in one line:
//!
//! ```no_run
//! sim::mechanism! {
//!     /// A mass that falls.
//!     pub Falling;
//!     coordinates { y [m]; }
//!     parameters { m [kg] = 1; }
//!     bodies { ball: mass m at [0, y]; }
//!     loads { gravity [0, -9.81 [m/s^2]]; }
//! }
//!
//! fn main() -> std::process::ExitCode {
//!     sim::cli::main(&[sim::cli::entry::<Falling>()])
//! }
//! ```

mod arguments;
mod commands;
mod files;
mod given;
mod own;
mod progress;
mod quantity;
mod settings;
mod signals;

use arguments::{
    Arguments, AssembleArguments, Command, KinematicsArguments, LinearizeArguments, PoincareArguments, RunArguments,
    StartArguments, VerifyArguments, Voice,
};
use clap::{FromArgMatches, Parser};
use codegen::nearest;
use commands::{compare, generate, info, kinematics, linearize, list, new, plot, poincare, run, statics, verify};
use files::run_file::RunFile;
use sim_kernel::{Compiled, Description};
use std::ffi::OsString;
use std::io::Write;
use std::process::ExitCode;

/// A mechanism that the command line can run.
#[derive(Clone, Copy)]
pub struct Entry {
    description: &'static Description,
    run: fn(&RunArguments, Voice) -> Result<(), Stop>,
    facts: fn() -> info::Facts,
    verify: fn(&VerifyArguments, Voice) -> Result<(), Stop>,
    assemble: fn(&AssembleArguments, Voice) -> Result<(), Stop>,
    equilibrium: fn(&StartArguments, Voice) -> Result<(), Stop>,
    kinematics: fn(&KinematicsArguments, Voice) -> Result<(), Stop>,
    linearize: fn(&LinearizeArguments, Voice) -> Result<(), Stop>,
    poincare: fn(&PoincareArguments, Voice) -> Result<(), Stop>,
}

/// Registers a mechanism with [`main`].
pub fn entry<M: Compiled>() -> Entry {
    Entry {
        description: const { &M::DESCRIPTION },
        run: run::run_command::<M>,
        facts: info::facts::<M>,
        verify: verify::verify_command::<M>,
        assemble: statics::assemble_command::<M>,
        equilibrium: statics::equilibrium_command::<M>,
        kinematics: kinematics::kinematics_command::<M>,
        linearize: linearize::linearize_command::<M>,
        poincare: poincare::poincare_command::<M>,
    }
}

/// Why a command failed.
enum Stop {
    /// The command line is wrong; exit status 2.
    Usage(String),
    /// The work failed; exit status 1.
    Failed(anyhow::Error),
    /// The user interrupted it; exit status 130.
    Interrupted(anyhow::Error),
}

impl<E: Into<anyhow::Error>> From<E> for Stop {
    fn from(error: E) -> Stop {
        Stop::Failed(error.into())
    }
}

/// Executes the command line and gives the exit status: 0 for success, 1 for a failed run, 2 for a wrong command line,
/// 130 for an interrupted run.
pub fn main(mechanisms: &[Entry]) -> ExitCode {
    signals::listen();
    let words: Vec<OsString> = std::env::args_os().collect();
    let matches = own::command(mechanisms, &program()).get_matches_from(&words);
    let arguments = Arguments::from_arg_matches(&matches).unwrap_or_else(|error| error.exit());
    match with_run_file(mechanisms, arguments, &words) {
        Ok(()) => ExitCode::SUCCESS,
        Err(Stop::Usage(message)) => {
            eprintln!("error: {message}");
            ExitCode::from(2)
        }
        Err(Stop::Failed(error)) => {
            eprintln!("error: {error:#}");
            ExitCode::from(1)
        }
        Err(Stop::Interrupted(error)) => {
            eprintln!("{error:#}");
            ExitCode::from(130)
        }
    }
}

/// Executes the command line; the arguments of a run file are put before the user's own.
fn with_run_file(mechanisms: &[Entry], arguments: Arguments, words: &[OsString]) -> Result<(), Stop> {
    let path = match &arguments.command {
        Command::Run(run) if run.model.ends_with(".json") => run.model.clone(),
        _ => return execute(mechanisms, arguments),
    };
    let file = RunFile::open(&path)?;
    let of_file = |entry: &&Entry| file.declaration().is_some_and(|(model, _)| model == entry.description.name);
    let difference = mechanisms.iter().find(of_file).and_then(|entry| file.difference(entry.description));
    if let Some(difference) = difference.filter(|_| !arguments.voice.quiet) {
        eprintln!("warning: {difference}");
    }
    let arguments = Arguments::try_parse_from(file.expand(words)?).map_err(|error| {
        let said = error.to_string();
        Stop::Usage(file.blamed(said.trim_start_matches("error: ").trim_end()))
    })?;
    execute(mechanisms, arguments).map_err(|stop| match stop {
        Stop::Usage(message) => Stop::Usage(file.blamed(&message)),
        other => other,
    })
}

fn execute(mechanisms: &[Entry], arguments: Arguments) -> Result<(), Stop> {
    let voice = arguments.voice;
    match arguments.command {
        Command::List => list::list(mechanisms.iter().map(|entry| entry.description), voice),
        Command::Info(arguments) => info::info(&(find(mechanisms, &arguments.model)?.facts)(), voice),
        Command::Run(arguments) => (find(mechanisms, &arguments.model)?.run)(&arguments, voice),
        Command::Verify(arguments) => (find(mechanisms, &arguments.model)?.verify)(&arguments, voice),
        Command::Assemble(arguments) => (find(mechanisms, &arguments.start.model)?.assemble)(&arguments, voice),
        Command::Equilibrium(arguments) => (find(mechanisms, &arguments.model)?.equilibrium)(&arguments, voice),
        Command::Kinematics(arguments) => (find(mechanisms, arguments.model())?.kinematics)(&arguments, voice),
        Command::Linearize(arguments) => (find(mechanisms, &arguments.start.model)?.linearize)(&arguments, voice),
        Command::Poincare(arguments) => (find(mechanisms, &arguments.start.model)?.poincare)(&arguments, voice),
        Command::Plot(arguments) => plot::plot(&arguments, voice),
        Command::Compare(arguments) => compare::compare(&arguments, voice),
        Command::New(arguments) => new::new(&arguments, voice),
        Command::Generate(arguments) => generate::generate(&arguments, mechanisms),
    }
}

/// Prints to standard output, which the reader may have closed.
fn print(text: &str) -> Result<(), Stop> {
    match std::io::stdout().lock().write_all(text.as_bytes()) {
        Err(error) if error.kind() != std::io::ErrorKind::BrokenPipe => Err(error.into()),
        _ => Ok(()),
    }
}

/// The name of this program.
fn program() -> String {
    let name = std::env::args_os().next().map(std::path::PathBuf::from);
    let name = name.as_ref().and_then(|path| path.file_stem()).map(|name| name.to_string_lossy().into_owned());
    name.unwrap_or_else(|| "sim".to_owned())
}

fn find<'a>(mechanisms: &'a [Entry], name: &str) -> Result<&'a Entry, Stop> {
    let names = || mechanisms.iter().map(|entry| entry.description.name);
    mechanisms.iter().find(|entry| entry.description.name == name).ok_or_else(|| unknown("model", name, names()))
}

/// The message for a name that is not known.
fn unknown<'a>(kind: &str, name: &str, known: impl Iterator<Item = &'a str>) -> Stop {
    not_among(kind, name, &known.collect::<Vec<_>>())
}

fn not_among(kind: &str, name: &str, known: &[&str]) -> Stop {
    let near = nearest::suggestion(name, known.iter().copied());
    Stop::Usage(format!("no {kind} is called `{name}`{near}\nknown: {}", known.join(", ")))
}
