//! Robots' files with letters and words left out, doubled, exchanged and replaced: they are read or refused, and nothing panics.

use crate::{ARM, KINDS, QUADRUPED};
use sim::DeclarationFile;
use std::path::Path;
use std::time::{Duration, Instant};
use tests::mangling::{mangled, seeds};
use tests::{Random, peak_memory};

/// `LINKWRIGHT_FUZZ` and `LINKWRIGHT_SEED` choose others.
const CASES: usize = tests::sampled(90, 300);

/// A robot that takes this many times as long as its original is timed again, so often.
const PLAINLY: f64 = 1.2;
const TIMES: usize = 7;

/// Words end with these.
const SEPARATORS: [char; 4] = [' ', '\n', '"', '>'];

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

/// How many times as long as its original a robot takes, which took this long before. One that seems to take plainly longer is
/// timed again, by turns with its original, as both take longer while the computer does other work.
fn beside(original: &str, text: &str, [before, time]: [Duration; 2]) -> f64 {
    let ratio = |time: Duration, before: Duration| time.as_secs_f64() / before.as_secs_f64();
    if ratio(time, before) < PLAINLY {
        return ratio(time, before);
    }
    let by_turns = (0..TIMES).map(|_| [original, text].map(|text| time_of(text).0));
    let [before, time] = by_turns.fold([Duration::MAX; 2], |[a, b], [c, d]| [a.min(c), b.min(d)]);
    ratio(time, before)
}

#[test]
fn mangled_robots_are_refused_or_read() {
    let texts = [ARM, QUADRUPED, KINDS];
    let originals = texts.map(|text| (0..3).map(|_| time_of(text).0).min().unwrap_or_default());
    let seeds = seeds(CASES);
    let cases = seeds.len();
    let (mut accepted, mut slowest, mut longest) = (0, Duration::ZERO, (0.0f64, 0));
    for seed in seeds {
        let text = mangled(texts[seed % texts.len()], &SEPARATORS, WORDS, &mut Random(seed as u64));
        let (time, is_accepted) = time_of(&text);
        accepted += usize::from(is_accepted);
        slowest = slowest.max(time);
        if is_accepted {
            let beside = beside(texts[seed % texts.len()], &text, [originals[seed % texts.len()], time]);
            longest = if beside > longest.0 { (beside, seed) } else { longest };
        }
    }
    println!("{cases} robots, {accepted} accepted");
    println!("the slowest robot, in s: {:.3}", slowest.as_secs_f64());
    println!("an accepted robot beside its original: {:.2} (case {})", longest.0, longest.1);
    println!("the most memory, in MB: {:.1}", peak_memory().unwrap_or(0) as f64 / 1e6);
    assert!(accepted > cases / 5);
}
