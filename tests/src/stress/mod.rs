//! Random linkages: drawn, run in one of their forms, and judged by others.

mod draw;
mod geometry;
mod judge;
mod ranges;
mod sizes;
mod spatial;
#[allow(dead_code)]
mod topology;
mod typed;

use draw::Drawn;
use judge::Verdict;
use std::collections::BTreeMap;
use std::process::ExitCode;
use std::sync::Mutex;
use std::sync::atomic::{AtomicU64, Ordering};
use std::time::{Duration, Instant};
use typed::{Linkage, Typed};

include!(concat!(env!("OUT_DIR"), "/stress.rs"));

const USAGE: &str = "stress COUNT [--seed S] [--of LINKAGE] [--turns T]    runs draws 0 to COUNT - 1
stress --draw NUMBER [--seed S] [--turns T]           repeats one draw and tells all of it
Runs go T turns at most, or 4, and sweeps 12.5 T.";

/// What is asked for.
struct Asked {
    draws: std::ops::Range<u64>,
    drawn: Drawn,
}

fn asked() -> Result<Asked, String> {
    let mut asked = Asked { draws: 0..0, drawn: Drawn { seed: 1, of: None, turns: draw::MOST_TURNS } };
    let mut words = std::env::args().skip(1);
    while let Some(word) = words.next() {
        let number =
            |text: Option<String>| text.and_then(|text| text.parse().ok()).ok_or(format!("{word}: a number is needed"));
        match word.as_str() {
            "--seed" => asked.drawn.seed = number(words.next())?,
            "--draw" => {
                let one: u64 = number(words.next())?;
                asked.draws = one..one + 1;
            }
            "--of" => asked.drawn.of = words.next(),
            "--turns" => asked.drawn.turns = turns(words.next())?,
            _ => asked.draws = 0..number(Some(word.clone()))?,
        }
    }
    if asked.draws.is_empty() { Err("say how many draws".to_owned()) } else { Ok(asked) }
}

/// How far runs go: far enough to be compared, and no farther than is known in a reasonable time.
fn turns(text: Option<String>) -> Result<f64, String> {
    let turns = text.and_then(|text| text.parse().ok()).filter(|turns| (0.25..=100.0).contains(turns));
    turns.ok_or("--turns: a number from 0.25 to 100 is needed".to_owned())
}

pub(crate) fn main() -> ExitCode {
    let asked = match asked() {
        Ok(asked) => asked,
        Err(why) => {
            eprintln!("{why}\n{USAGE}");
            return ExitCode::from(2);
        }
    };
    std::panic::set_hook(Box::new(|_| {}));
    let is_one = asked.draws.end - asked.draws.start == 1;
    let next = AtomicU64::new(asked.draws.start);
    let tally = Mutex::new(Tally { next: asked.draws.start, ..Tally::default() });
    let threads = std::thread::available_parallelism().map_or(2, usize::from);
    std::thread::scope(|scope| {
        for _ in 0..threads {
            scope.spawn(|| {
                loop {
                    let number = next.fetch_add(1, Ordering::Relaxed);
                    if number >= asked.draws.end {
                        return;
                    }
                    let begun = Instant::now();
                    let judged = draw::draw(&asked.drawn, number).map(|draw| {
                        let verdict = judge::judge(&draw);
                        (draw, verdict)
                    });
                    if let (true, Some((draw, verdict))) = (is_one, &judged) {
                        println!("{}\n{:?}\n{verdict:?}", draw.command(), draw.task);
                    }
                    if let Ok(mut tally) = tally.lock() {
                        tally.add(&asked.drawn, number, judged, begun.elapsed());
                    }
                }
            });
        }
    });
    match tally.into_inner() {
        Ok(tally) => tally.conclude(),
        Err(_) => ExitCode::FAILURE,
    }
}

/// How many of each verdict.
#[derive(Default)]
struct Tally {
    tried: usize,
    right: usize,
    undecided: usize,
    unanswered: usize,
    refused: BTreeMap<String, usize>,
    /// By form and way.
    wrong: BTreeMap<String, usize>,
    /// What has been judged, but not told, as a draw before it has not been judged.
    untold: BTreeMap<u64, Option<String>>,
    /// The first draw that has not been told.
    next: u64,
    slowest: (Duration, u64),
}

impl Tally {
    /// Counts a draw, and tells what is worth a word, in the order of the draws.
    fn add(&mut self, drawn: &Drawn, number: u64, judged: Option<(draw::Draw, Verdict)>, took: Duration) {
        self.slowest = self.slowest.max((took, number));
        let story = judged.and_then(|(draw, verdict)| {
            let what = self.count(&draw, verdict)?;
            Some(format!("{what}: {}\n    stress {} --draw {number}", draw.summary(), drawn.options()))
        });
        self.untold.insert(number, story);
        while let Some(story) = self.untold.remove(&self.next) {
            story.iter().for_each(|story| println!("{story}"));
            self.next += 1;
            if self.next.is_multiple_of(1000) {
                eprintln!("{} draws", self.next);
            }
        }
    }

    /// What there is to say of a draw that is not right.
    fn count(&mut self, draw: &draw::Draw, verdict: Verdict) -> Option<String> {
        self.tried += 1;
        match verdict {
            Verdict::Right => {
                self.right += 1;
                None
            }
            Verdict::Unanswered => {
                self.unanswered += 1;
                None
            }
            Verdict::Undecided(why) => {
                self.undecided += 1;
                Some(format!("undecided, {why}"))
            }
            Verdict::Refused(name, words) => {
                *self.refused.entry(name).or_default() += 1;
                Some(format!("refused, {words}"))
            }
            Verdict::Wrong(words) => {
                *self.wrong.entry(draw.class()).or_default() += 1;
                Some(format!("WRONG, {words}"))
            }
        }
    }

    fn conclude(self) -> ExitCode {
        let (refused, wrong): (usize, usize) = (self.refused.values().sum(), self.wrong.values().sum());
        self.refused.iter().for_each(|(name, count)| println!("refused {count:>6}  {name}"));
        self.wrong.iter().for_each(|(class, count)| println!("wrong   {count:>6}  {class}"));
        println!(
            "tried {}, right {}, refused {refused} though there is an answer and {} without one, undecided {}, wrong {wrong}",
            self.tried, self.right, self.unanswered, self.undecided
        );
        eprintln!("the slowest draw is {}: {:.1} s", self.slowest.1, self.slowest.0.as_secs_f64());
        if wrong == 0 { ExitCode::SUCCESS } else { ExitCode::FAILURE }
    }
}
