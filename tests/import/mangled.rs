//! Robots' files with letters and words left out, doubled, exchanged and replaced: they are read or refused, and nothing panics.

use crate::{ARM, KINDS, QUADRUPED};
use sim::DeclarationFile;
use std::path::Path;
use std::time::{Duration, Instant};
use tests::{Random, peak_memory};

/// `LINKWRIGHT_FUZZ=67` makes 67 times as many, by `LINKWRIGHT_SEED=N` from another one on.
const CASES: usize = 300;

/// What is put in for other words.
const WORDS: &[&str] = &[
    "<",
    ">",
    "/>",
    "\"",
    "'",
    "&",
    "&amp;",
    "&#0;",
    "&x;",
    "<!--",
    "-->",
    "<![CDATA[",
    "<?x",
    "<!DOCTYPE a>",
    "\0",
    "\u{1d70b}",
    "0",
    "-1",
    "1e308",
    "1e-320",
    "nan",
    "inf",
    "1e400",
    "xyz=\"1e200 1e200 1e200\"",
    "xyz=\"0 0 0\"",
    "rpy=\"1e9 0 0\"",
    "value=\"0\"",
    "type=\"fixed\"",
    "type=\"floating\"",
    "type=\"planar\"",
    "type=\"prismatic\"",
    "<mimic joint=\"elbow\"/>",
    "name=\"t\"",
    "name=\"\"",
    "<joint>",
    "</joint>",
    "<link name=\"x\"/>",
    "<link",
    "</link>",
    "<robot>",
    "</robot>",
    "multiplier=\"1e300\"",
    "ixx=\"-1\"",
    "<dynamics damping=\"1e300\"/>",
    "lower=\"1\"",
    "upper=\"-1\"",
    "${x}",
    "filename=\"../../x.stl\"",
];

fn mangled(text: &str, random: &mut Random) -> String {
    let below = |random: &mut Random, n: usize| (random.between(0.0, n as f64) as usize).min(n.saturating_sub(1));
    let mut words: Vec<String> = text.split_inclusive([' ', '\n', '"', '>']).map(str::to_owned).collect();
    for _ in 0..1 + below(random, 3) {
        let (at, other) = (below(random, words.len()), below(random, words.len()));
        match below(random, 5) {
            0 => words[at].clear(),
            1 => words.swap(at, other),
            2 => words[at] = words[other].clone(),
            3 => words[at] = format!("{} ", WORDS[below(random, WORDS.len())]),
            _ => {
                let drop = below(random, words[at].chars().count().max(1));
                words[at] = words[at].chars().enumerate().filter(|(i, _)| *i != drop).map(|(_, c)| c).collect();
            }
        }
    }
    words.concat()
}

fn time_of(text: &str) -> (Duration, bool) {
    let clock = Instant::now();
    let file = DeclarationFile::of(Path::new("mangled.urdf"), text.to_owned());
    let is_accepted = match file.model(None) {
        Ok(_) => true,
        Err(failure) => {
            assert!(!failure.to_string().is_empty(), "{text}");
            false
        }
    };
    (clock.elapsed(), is_accepted)
}

#[test]
fn mangled_robots_are_refused_or_read() {
    let texts = [ARM, QUADRUPED, KINDS];
    let originals = texts.map(|text| (0..3).map(|_| time_of(text).0).min().unwrap_or_default());
    let given = |name: &str| std::env::var(name).ok().and_then(|text| text.parse::<usize>().ok());
    let (cases, first) = (CASES * given("LINKWRIGHT_FUZZ").unwrap_or(1), given("LINKWRIGHT_SEED").unwrap_or(0));
    let (mut accepted, mut slowest, mut longest) = (0, Duration::ZERO, 0.0f64);
    for seed in first..first + cases {
        let text = mangled(texts[seed % texts.len()], &mut Random(seed as u64));
        let (time, is_accepted) = time_of(&text);
        accepted += usize::from(is_accepted);
        slowest = slowest.max(time);
        if is_accepted {
            longest = longest.max(time.as_secs_f64() / originals[seed % texts.len()].as_secs_f64());
        }
    }
    println!("{cases} robots, {accepted} accepted");
    println!("the slowest robot, in s: {:.3}", slowest.as_secs_f64());
    println!("an accepted robot beside its original: {longest:.2}");
    println!("the most memory, in MB: {:.1}", peak_memory().unwrap_or(0) as f64 / 1e6);
    assert!(accepted > cases / 5);
}
