//! Commands whose results stay in memory: for programs in other languages.

use crate::Stop;
use crate::arguments::{Arguments, Command, KinematicsArguments, PoincareArguments, RunArguments};
use crate::commands::kinematics::swept;
use crate::commands::linearize::linearized_summary;
use crate::commands::poincare::{Sectioned, sectioned};
use crate::commands::run::{Asked, asked, failures, made};
use crate::commands::statics::{assembled, balanced};
use crate::commands::verify::verified;
use crate::files::asked::of_words;
use crate::files::reproduction::in_si;
use crate::files::written::Files;
use crate::given::{hold, set};
use crate::sizes::stepping;
use clap::Parser;
use serde_json::Value;
use sim_kernel::Mechanism;
use sim_output::show::{About, ShowError, report_text, sweep_report_text};
use sim_output::{Recorded, summary_of};
use sim_runtime::verify::VerifyError;
use sim_runtime::{Erased, Failure, Model, Run, Table, What};
use std::sync::Arc;
use std::sync::atomic::{AtomicBool, Ordering};

/// What a command finds.
pub struct Answer {
    /// As `--json` prints it, without the names of files.
    pub summary: Value,
    /// The columns of the motion, of a command that finds one.
    pub table: Option<Table>,
    /// What is wrong with the results, which are valid until then.
    pub problem: Option<Problem>,
    page: Option<Page>,
}

/// What is wrong with results.
#[derive(Clone, Debug)]
pub struct Problem {
    /// For readers.
    pub message: String,
    /// Where and why a motion ended, if it did.
    pub failure: Option<Failure>,
}

/// Draws a report.
type Page = Box<dyn Fn() -> Result<String, ShowError> + Send + Sync>;

impl Answer {
    fn of(summary: Value) -> Answer {
        Answer { summary, table: None, problem: None, page: None }
    }

    /// The report that shows the motion, a page for browsers; `None` of a command that has no report.
    ///
    /// # Errors
    /// If there is nothing to draw.
    pub fn report(&self) -> Option<Result<String, Refusal>> {
        let page = self.page.as_ref()?;
        Some(page().map_err(Stop::from).map_err(Refusal::from))
    }
}

/// Why a command finds nothing.
#[derive(Debug, thiserror::Error)]
pub enum Refusal {
    /// It is not asked for as it should be.
    #[error("{0}")]
    Usage(String),
    /// The mechanism fails at a state.
    #[error("{0}")]
    Failure(Failure),
    /// Something else.
    #[error("{0}")]
    Other(String),
}

impl Refusal {
    fn of(why: anyhow::Error) -> Refusal {
        match why.downcast_ref::<Failure>() {
            Some(failure) => Refusal::Failure(failure.clone()),
            None => match why.downcast_ref::<VerifyError>() {
                Some(VerifyError::Run(failure)) => Refusal::Failure(failure.clone()),
                _ => Refusal::Other(format!("{why:#}")),
            },
        }
    }
}

impl From<Stop> for Refusal {
    fn from(stop: Stop) -> Refusal {
        match stop {
            Stop::Usage(why) => Refusal::Usage(why),
            Stop::Told => Refusal::Other("the work failed".to_owned()),
            Stop::Failed(why) | Stop::Interrupted(why) => Refusal::of(why),
        }
    }
}

/// Executes a command line, without the program's name, on a model in place of the mechanism that it names: `run`,
/// `assemble`, `equilibrium`, `kinematics`, `linearize`, `poincare` or `verify`. Nothing is written or printed. Where
/// `interrupted` is set, a motion ends.
///
/// # Errors
/// [`Refusal`].
pub fn answer(model: Arc<dyn Model>, words: &[String], interrupted: &AtomicBool) -> Result<Answer, Refusal> {
    answered(model, words, interrupted).map_err(Refusal::from)
}

fn answered(model: Arc<dyn Model>, words: &[String], interrupted: &AtomicBool) -> Result<Answer, Stop> {
    let command = || {
        let (first, options) = words.split_at(words.len().min(2));
        let values = values_apart(&*model, words);
        of_words("sim", first.iter().chain(&values).chain(options).map(Into::into))
    };
    match parsed(words)? {
        Command::Run(arguments) => stepping!(ran, model, &arguments, interrupted),
        Command::Assemble(arguments) => assembled(Erased::of(model), &arguments).map(|said| Answer::of(said.json)),
        Command::Equilibrium(arguments) => balanced(Erased::of(model), &arguments).map(|said| Answer::of(said.json)),
        Command::Linearize(arguments) => linearized_summary(Erased::of(model), &arguments, interrupted).map(Answer::of),
        Command::Kinematics(arguments) => {
            let command = command();
            driven(Erased::of(model), &arguments, command, interrupted)
        }
        Command::Poincare(arguments) => stepping!(crossed, model, &arguments, interrupted),
        Command::Verify(arguments) => verified(Erased::of(model), &arguments, interrupted).map(|(said, failing)| {
            let problem = failing.map(|message| Problem { message, failure: None });
            Answer { problem, ..Answer::of(said.json) }
        }),
        _ => {
            Err(Stop::Usage(format!("`{}` has no results that stay in memory", words.first().map_or("", |word| word))))
        }
    }
}

/// The options that give a model the values that it has apart from its declaration, but those that the words give.
fn values_apart(model: &dyn Model, words: &[String]) -> Vec<String> {
    let (description, values, declared) = (model.description(), model.values(), model.as_declared().values());
    let parameters = description.parameters.iter().zip(values.parameters).zip(declared.parameters);
    let parameters =
        parameters.filter(|((_, value), declared)| value != declared).map(|((of, value), _)| ("set", of, value));
    let inputs = description.inputs.iter().zip(values.inputs);
    let inputs = inputs.filter_map(|(of, input)| Some(("input", of, input.held()?)));
    let is_given = |option: &str, name: &str| words.iter().any(|word| word.starts_with(&format!("--{option}={name}=")));
    let apart = parameters.chain(inputs).filter(|(option, of, _)| !is_given(option, of.name));
    apart.map(|(option, of, value)| format!("--{option}={}={}", of.name, in_si(of, value))).collect()
}

/// A model with parameters and inputs, each `NAME=VALUE` as on the command line.
///
/// # Errors
/// [`Refusal::Usage`] of names and values that are none.
pub fn with_values(model: &dyn Model, parameters: &[String], inputs: &[String]) -> Result<Arc<dyn Model>, Refusal> {
    let mut values = model.values();
    set(&mut values.parameters, model.description(), parameters)?;
    hold(&mut values.inputs, model.description(), inputs)?;
    Ok(model.with_values(&values))
}

/// The command of these words.
pub(super) fn parsed(words: &[String]) -> Result<Command, Stop> {
    let words = std::iter::once("sim").chain(words.iter().map(String::as_str));
    let arguments = Arguments::try_parse_from(words).map_err(|error| {
        let said = error.to_string();
        let said = said.split("\n\nUsage:").next().unwrap_or(&said);
        let said = said.split("\n\nFor more information").next().unwrap_or(said);
        Stop::Usage(said.trim_start_matches("error: ").trim_end().to_owned())
    })?;
    Ok(arguments.command)
}

fn problem(failure: Option<&Failure>, problems: &[String]) -> Option<Problem> {
    (!problems.is_empty()).then(|| Problem { message: problems.join("\n"), failure: failure.cloned() })
}

fn ran<M: Mechanism + Send + Sync + 'static>(
    mechanism: M,
    arguments: &RunArguments,
    interrupted: &AtomicBool,
) -> Result<Answer, Stop>
where
    Run<M>: Send + Sync,
{
    let Asked { mechanism, start, settings, mut reproduction } = asked(&mechanism, arguments)?;
    let found = made(arguments)(mechanism, &start, &settings, &mut |_| !interrupted.load(Ordering::Relaxed))?;
    let outcome = found.outcome();
    let mut table = Table::of(&found.mechanism, &found.trajectory);
    let mut summary = summary_of(&outcome, &table);
    Files::name_run(&mut table, reproduction.command.clone(), &mut [&mut reproduction.file, &mut summary]);
    let (provenance, problems) = (table.provenance.clone(), failures(outcome.failure.as_ref(), &table));
    let (told, text) = (summary.clone(), reproduction.text());
    let page = move || {
        let outcome = found.outcome();
        let mut table = Table::of(&found.mechanism, &found.trajectory);
        table.provenance = provenance.clone();
        let about = About { summary: &told, command: &reproduction.command, run_file: Some(&text) };
        report_text(&found, &outcome, &table, &about)
    };
    let problem = problem(outcome.failure.as_ref(), &problems);
    Ok(Answer { summary, table: Some(table), problem, page: Some(Box::new(page)) })
}

fn driven<M: Mechanism + Send + Sync + 'static>(
    mechanism: M,
    arguments: &KinematicsArguments,
    command: String,
    interrupted: &AtomicBool,
) -> Result<Answer, Stop>
where
    sim_runtime::Kinematics<M>: Send + Sync,
{
    let (found, mut summary) = swept(mechanism, arguments, interrupted)?;
    let mut table = found.table();
    Files::name_run(&mut table, command.clone(), &mut [&mut summary]);
    let failure = found.trajectory.failure.clone();
    let problems: Vec<String> = failure.iter().map(ToString::to_string).collect();
    let provenance = table.provenance.clone();
    let page = move || {
        let mut table = found.table();
        table.provenance = provenance.clone();
        sweep_report_text(&found, &table, &command)
    };
    let problem = problem(failure.as_ref(), &problems);
    Ok(Answer { summary, table: Some(table), problem, page: Some(Box::new(page)) })
}

fn crossed<M: Mechanism>(
    mechanism: M,
    arguments: &PoincareArguments,
    interrupted: &AtomicBool,
) -> Result<Answer, Stop> {
    let Sectioned { table, summary, failure, problems } =
        sectioned(mechanism, arguments, &mut |_| !interrupted.load(Ordering::Relaxed))?;
    let problem = problem(failure.as_ref(), &problems);
    Ok(Answer { summary, table: Some(table), problem, page: None })
}

impl Problem {
    /// Whether the motion was ended by whoever asked for it.
    pub fn is_interrupted(&self) -> bool {
        self.failure.as_ref().is_some_and(|failure| failure.what == What::Interrupted)
    }
}
