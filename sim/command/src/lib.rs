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

mod answer;
mod arguments;
mod chosen;
mod commands;
mod entry;
mod events;
mod files;
mod given;
mod numbers;
mod own;
mod progress;
mod quantity;
mod said;
mod settings;
mod signals;
mod simulated;
mod sizes;
mod tell;

use crate::tell::tell;
pub use answer::{Answer, Problem, Refusal, answer, with_values};
use arguments::{Arguments, Command};
use chosen::{Chosen, chosen, file as file_named};
use clap::{FromArgMatches, Parser};
use codegen::nearest;
use commands::{
    check, compare, evaluate, generate, import, info, kinematics, linearize, list, new, new_file, plot, poincare, run,
    statics, verify, watch,
};
pub use entry::{Entry, entry, entry_with_own_loops, model_entry, text_entry};
use files::run_file::RunFile;
use sim_runtime::Erased;
pub use simulated::{GoesOn, Simulated, Stand, simulated};
use sizes::stepping;
use std::ffi::OsString;
use std::io::Write;
use std::path::Path;
use std::process::ExitCode;
use std::sync::{Mutex, PoisonError};

/// Why a command failed.
enum Stop {
    /// The command line is wrong; exit status 2.
    Usage(String),
    /// The work failed; exit status 1.
    Failed(anyhow::Error),
    /// The same, where all has been said; exit status 1.
    Told,
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
    ExitCode::from(main_of(mechanisms, std::env::args_os().collect()))
}

/// The same for a command line, the program's name first, that this process was not called with: of a program in another
/// language.
pub fn main_of(mechanisms: &[Entry], words: Vec<OsString>) -> u8 {
    signals::listen();
    *WORDS.lock().unwrap_or_else(PoisonError::into_inner) = words.clone();
    let matches = own::command(mechanisms, &program()).get_matches_from(&words);
    let arguments = Arguments::from_arg_matches(&matches).unwrap_or_else(|error| error.exit());
    match with_run_file(mechanisms, arguments, &words) {
        Ok(()) => 0,
        Err(Stop::Usage(message)) => {
            tell!("error: {message}");
            2
        }
        Err(Stop::Failed(error)) => {
            tell!("error: {error:#}");
            1
        }
        Err(Stop::Told) => 1,
        Err(Stop::Interrupted(error)) => {
            tell!("{error:#}");
            130
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
    let is_lacking = |model: &&str| file_named(model).is_some_and(|(path, _)| !path.exists());
    if let Some(declared) = file.declaration().map(|(model, _)| model).filter(is_lacking) {
        return Err(Stop::Usage(file.blamed(&format!(
            "model: there is no `{declared}` here. It is named as it was when the run was made: repeat the run in the folder where \
             that was",
        ))));
    }
    let model = file.declaration().and_then(|(model, _)| chosen(mechanisms, model, true).ok());
    let difference = model.and_then(|chosen| file.difference(chosen.model.description()));
    if let Some(difference) = difference.filter(|_| !arguments.voice.quiet) {
        tell!("warning: {difference}");
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
    let model = |word: &str| Ok::<_, Stop>(chosen(mechanisms, word, voice.quiet)?.model);
    match &arguments.command {
        Command::List => list::list(mechanisms, voice),
        Command::Info(info) => info::info_command(Erased::of(model(&info.model)?), voice),
        Command::Run(run) => {
            let Chosen { model, run: own } = chosen(mechanisms, &run.model, voice.quiet)?;
            match own {
                Some(own) => own(run, voice),
                None => stepping!(run::run_command, model, run, voice),
            }
        }
        Command::Verify(verify) => verify::verify_command(Erased::of(model(&verify.model)?), verify, voice),
        Command::Assemble(start) => statics::assemble_command(Erased::of(model(&start.start.model)?), start, voice),
        Command::Equilibrium(start) => statics::equilibrium_command(Erased::of(model(&start.model)?), start, voice),
        Command::Kinematics(sweep) => kinematics::kinematics_command(Erased::of(model(sweep.model())?), sweep, voice),
        Command::Linearize(about) => linearize::linearize_command(Erased::of(model(&about.start.model)?), about, voice),
        Command::Poincare(of) => stepping!(poincare::poincare_command, model(&of.start.model)?, of, voice),
        Command::Evaluate(of) => evaluate::evaluate(&*model(&of.model)?, of, voice),
        Command::Watch(arguments) => watch::watch(arguments, voice),
        Command::Check(arguments) => check::check(arguments, voice),
        Command::Import(arguments) => import::import(arguments, voice),
        Command::Plot(arguments) => plot::plot(arguments, voice),
        Command::Compare(arguments) => compare::compare(arguments, voice),
        Command::New(arguments) if arguments.file => new_file::new_file(mechanisms, arguments, voice),
        Command::New(arguments) => new::new(arguments, voice),
        Command::Generate(arguments) => generate::generate(arguments, mechanisms),
    }
}

/// Prints to standard output, which the reader may have closed.
fn print(text: &str) -> Result<(), Stop> {
    match std::io::stdout().lock().write_all(text.as_bytes()) {
        Err(error) if error.kind() != std::io::ErrorKind::BrokenPipe => Err(error.into()),
        _ => Ok(()),
    }
}

/// The command line, the program's name first.
static WORDS: Mutex<Vec<OsString>> = Mutex::new(Vec::new());

fn words() -> Vec<OsString> {
    WORDS.lock().unwrap_or_else(PoisonError::into_inner).clone()
}

/// The name of this program.
fn program() -> String {
    let words = words();
    let name = words.first().map(Path::new).and_then(Path::file_stem);
    name.map_or_else(|| "sim".to_owned(), |name| name.to_string_lossy().into_owned())
}

/// The message for a name that is not known.
fn unknown<'a>(kind: &str, name: &str, known: impl Iterator<Item = &'a str>) -> Stop {
    not_among(kind, name, &known.collect::<Vec<_>>())
}

fn not_among(kind: &str, name: &str, known: &[&str]) -> Stop {
    Stop::Usage(missing(kind, name, known))
}

/// The sentence on a name that nothing has.
fn missing(kind: &str, name: &str, known: &[&str]) -> String {
    if known.is_empty() {
        return format!("no {kind} is called `{name}`: there is none");
    }
    let near = nearest::suggestion(name, known.iter().copied());
    format!("no {kind} is called `{name}`{near}\nknown: {}", known.join(", "))
}
