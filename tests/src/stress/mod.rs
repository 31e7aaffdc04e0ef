//! Random linkages: drawn, run in one of their forms, and judged by others.

mod draw;
mod geometry;
mod judge;
mod sizes;
mod spatial;
#[allow(dead_code)]
mod topology;
mod typed;

use judge::Verdict;
use std::collections::BTreeMap;
use std::process::ExitCode;
use std::sync::Mutex;
use std::sync::atomic::{AtomicU64, Ordering};
use typed::{Linkage, Typed};

include!(concat!(env!("OUT_DIR"), "/stress.rs"));

const USAGE: &str = "stress COUNT [--seed S] [--of LINKAGE]    runs draws 0 to COUNT - 1
stress --draw NUMBER [--seed S]          repeats one draw and tells all of it";

/// What is asked for.
struct Asked {
    seed: u64,
    draws: std::ops::Range<u64>,
    of: Option<String>,
}

fn asked() -> Result<Asked, String> {
    let mut asked = Asked { seed: 1, draws: 0..0, of: None };
    let mut words = std::env::args().skip(1);
    while let Some(word) = words.next() {
        let number =
            |text: Option<String>| text.and_then(|text| text.parse().ok()).ok_or(format!("{word}: a number is needed"));
        match word.as_str() {
            "--seed" => asked.seed = number(words.next())?,
            "--draw" => {
                let one: u64 = number(words.next())?;
                asked.draws = one..one + 1;
            }
            "--of" => asked.of = words.next(),
            _ => asked.draws = 0..number(Some(word.clone()))?,
        }
    }
    if asked.draws.is_empty() { Err("say how many draws".to_owned()) } else { Ok(asked) }
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
    let tally = Mutex::new(Tally::default());
    let threads = std::thread::available_parallelism().map_or(2, usize::from);
    std::thread::scope(|scope| {
        for _ in 0..threads {
            scope.spawn(|| {
                loop {
                    let number = next.fetch_add(1, Ordering::Relaxed);
                    if number >= asked.draws.end {
                        return;
                    }
                    if number > 0 && number.is_multiple_of(1000) {
                        eprintln!("{number} draws");
                    }
                    let Some(draw) = draw::draw(asked.seed, number, asked.of.as_deref()) else { continue };
                    let verdict = judge::judge(&draw);
                    if is_one {
                        println!("{}\n{:?}\n{verdict:?}", draw.command(), draw.task);
                    }
                    if let Ok(mut tally) = tally.lock() {
                        tally.add(asked.seed, number, &draw, verdict);
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
    stories: BTreeMap<u64, String>,
}

impl Tally {
    fn add(&mut self, seed: u64, number: u64, draw: &draw::Draw, verdict: Verdict) {
        self.tried += 1;
        let story = |what: &str| format!("{what}: {}\n    stress --seed {seed} --draw {number}", draw.summary());
        match verdict {
            Verdict::Right => self.right += 1,
            Verdict::Unanswered => self.unanswered += 1,
            Verdict::Undecided(why) => {
                self.undecided += 1;
                self.stories.insert(number, story(&format!("undecided, {why}")));
            }
            Verdict::Refused(name, words) => {
                *self.refused.entry(name).or_default() += 1;
                self.stories.insert(number, story(&format!("refused, {words}")));
            }
            Verdict::Wrong(words) => {
                *self.wrong.entry(draw.class()).or_default() += 1;
                self.stories.insert(number, story(&format!("WRONG, {words}")));
            }
        }
    }

    fn conclude(self) -> ExitCode {
        self.stories.values().for_each(|story| println!("{story}"));
        let (refused, wrong): (usize, usize) = (self.refused.values().sum(), self.wrong.values().sum());
        self.refused.iter().for_each(|(name, count)| println!("refused {count:>6}  {name}"));
        self.wrong.iter().for_each(|(class, count)| println!("wrong   {count:>6}  {class}"));
        println!(
            "tried {}, right {}, refused {refused} though there is an answer and {} without one, undecided {}, wrong {wrong}",
            self.tried, self.right, self.unanswered, self.undecided
        );
        if wrong == 0 { ExitCode::SUCCESS } else { ExitCode::FAILURE }
    }
}
