//! A saved file becomes a page: derived, run and drawn in memory.

use super::board::{Board, Page};
use super::files::{Changes, Job};
use super::server::secret;
use crate::Stop;
use crate::arguments::RunArguments;
use crate::commands::run::{Asked, asked, failures};
use crate::files::reproduction::Reproduction;
use crate::files::written::Files;
use crate::sizes::stepping;
use codegen::mistakes::{Mistake, Position};
use serde_json::{Value, json};
use sim_kernel::Mechanism;
use sim_output::show::{About, Live, live_report, waiting_page};
use sim_output::{Recorded, summary_of};
use sim_runtime::{DeclarationFile, LoadError, Table, What, run_compared};
use std::path::Path;

/// Whether a run is still wanted.
type GoesOn<'a> = dyn Fn() -> bool + Sync + 'a;

/// A page, and what is wrong with the run that it shows.
struct Drawn {
    html: String,
    failures: Vec<String>,
}

/// The page that is shown before there is a report.
pub(super) fn first_page() -> Result<Page, Stop> {
    let live = Live { number: 1, nonce: secret()? };
    Ok(Page { number: live.number, html: waiting_page(&live).into(), nonce: live.nonce })
}

/// Makes a page of each change for ever. A change ends the work on an earlier one.
pub(super) fn follow(path: &Path, name: Option<&str>, arguments: &RunArguments, changes: &Changes, board: &Board) -> ! {
    let mut number = 1;
    // One for all pages: a browser compiles scripts anew under another. Nothing that is shown can know it.
    let nonce = board.now().page.nonce;
    loop {
        let (job, count) = changes.wait();
        let is_last = || changes.count() == count;
        let (page, notice) = match job {
            Job::Missing(why) => (None, Some(notice(&why, Vec::new()))),
            Job::Run(file) => {
                let live = Live { number: number + 1, nonce: nonce.clone() };
                match made(&file, name, arguments, &live, &is_last) {
                    Ok((page, failures)) => (Some(page), said(&failures)),
                    Err(wrong) => (None, Some(wrong.shown(path))),
                }
            }
        };
        if is_last() {
            number = page.as_ref().map_or(number, |page| page.number);
            board.put(page, notice);
        }
    }
}

/// Why there is no page.
enum Wrong {
    Declared(LoadError),
    Ran(Stop),
}

impl Wrong {
    fn shown(&self, path: &Path) -> Value {
        match self {
            Wrong::Declared(LoadError::Mistakes { text, mistakes, .. }) => {
                let file = path.file_name().unwrap_or_default().to_string_lossy();
                let title =
                    if mistakes.len() == 1 { "1 mistake".to_owned() } else { format!("{} mistakes", mistakes.len()) };
                let shown = mistakes.iter().flat_map(|mistake| shown(&file, text, mistake)).collect();
                notice(&format!("{title} in {file}; what is shown below is from before."), shown)
            }
            Wrong::Declared(other) => notice(&other.to_string(), Vec::new()),
            Wrong::Ran(Stop::Usage(why)) => notice(why, Vec::new()),
            Wrong::Ran(Stop::Failed(why) | Stop::Interrupted(why)) => notice(&format!("{why:#}"), Vec::new()),
            Wrong::Ran(Stop::Told) => notice("the run failed", Vec::new()),
        }
    }
}

fn made(
    file: &DeclarationFile,
    name: Option<&str>,
    arguments: &RunArguments,
    live: &Live,
    goes_on: &GoesOn<'_>,
) -> Result<(Page, Vec<String>), Wrong> {
    let model = file.model(name).map_err(Wrong::Declared)?;
    let drawn = stepping!(ran, model, arguments, live, goes_on).map_err(Wrong::Ran)?;
    Ok((Page { number: live.number, nonce: live.nonce.clone(), html: drawn.html.into() }, drawn.failures))
}

/// Runs a mechanism as `run` does, and draws its report.
fn ran<M: Mechanism>(mechanism: M, arguments: &RunArguments, live: &Live, goes_on: &GoesOn<'_>) -> Result<Drawn, Stop> {
    let Asked { mechanism, start, settings, mut reproduction } = asked(&mechanism, arguments)?;
    let found = run_compared(mechanism, &start, &settings, &mut |_| goes_on())?;
    let table = Table::of(&found.mechanism, &found.trajectory);
    reported(&found, table, &mut reproduction, live)
}

fn reported(run: &dyn Recorded, mut table: Table, reproduction: &mut Reproduction, live: &Live) -> Result<Drawn, Stop> {
    let outcome = run.outcome();
    if outcome.failure.as_ref().is_some_and(|failure| failure.what == What::Interrupted) {
        // A newer file: nobody waits for this.
        return Err(Stop::Told);
    }
    let mut summary = summary_of(&outcome, &table);
    Files::name_run(&mut table, reproduction.command.clone(), &mut [&mut reproduction.file, &mut summary]);
    let text = reproduction.text();
    let about = About { summary: &summary, command: &reproduction.command, run_file: Some(&text) };
    let html = live_report(run, &outcome, &table, &about, live)?;
    Ok(Drawn { html, failures: failures(outcome.failure.as_ref(), &table) })
}

/// Failures of a run whose report is shown.
fn said(failures: &[String]) -> Option<Value> {
    (!failures.is_empty()).then(|| notice(&failures.join("\n"), Vec::new()))
}

fn notice(title: &str, mistakes: Vec<Value>) -> Value {
    json!({ "title": title, "mistakes": mistakes })
}

/// A mistake and what is told of other places that belong to it, each with its line.
fn shown(file: &str, text: &str, mistake: &Mistake) -> Vec<Value> {
    let Mistake { code, message, start, end, related } = mistake;
    let notes = related.iter().map(|of| quoted(file, text, ("note", &of.message), [of.start, of.end]));
    [quoted(file, text, (code, message), [*start, *end])].into_iter().chain(notes).collect()
}

/// A line in which the words that are meant stand apart, and what is said of them.
fn quoted(file: &str, text: &str, (code, message): (&str, &str), [start, end]: [Position; 2]) -> Value {
    let line = text.lines().nth(start.line).unwrap_or_default();
    let place = |column: usize| line.char_indices().nth(column).map_or(line.len(), |(at, _)| at);
    let from = place(start.column);
    let to = if end.line > start.line { line.len() } else { place(end.column).max(from) };
    json!({
        "code": code,
        "message": message,
        "place": format!("{file}:{}:{}", start.line + 1, start.column + 1),
        "line": { "before": &line[..from], "words": &line[from..to], "after": &line[to..] },
    })
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn the_words_that_are_meant_stand_apart() {
        let text = "pub A;\ncoordinates { x [m]; }\nparameters { m [kg] = 1; }\n\
                    bodies { b: mass m at [x, 0]; }\n/* \u{1d400} */ outputs { o = y; }\n";
        let file = DeclarationFile::of(Path::new("some/a.mech"), text.to_owned());
        let Err(LoadError::Mistakes { text, mistakes, .. }) = file.model(None) else { panic!("accepted") };
        let [shown] = &shown("a.mech", &text, &mistakes[0])[..] else { panic!("one place") };
        assert_eq!(shown["line"], json!({ "before": "/* \u{1d400} */ outputs { o = ", "words": "y", "after": "; }" }));
        assert_eq!(shown["place"], "a.mech:5:23");
    }
}
