//! Texts with letters and words left out, doubled, exchanged and replaced.

use crate::Random;

/// A text in which up to three words are changed; words end with these separators, and some are put in for others.
pub fn mangled(text: &str, separators: &[char], words: &[&str], random: &mut Random) -> String {
    let below = |random: &mut Random, n: usize| (random.between(0.0, n as f64) as usize).min(n.saturating_sub(1));
    let mut all: Vec<String> = text.split_inclusive(separators).map(str::to_owned).collect();
    for _ in 0..1 + below(random, 3) {
        let (at, other) = (below(random, all.len()), below(random, all.len()));
        match below(random, 5) {
            0 => all[at].clear(),
            1 => all.swap(at, other),
            2 => all[at] = all[other].clone(),
            3 => all[at] = format!("{} ", words[below(random, words.len())]),
            _ => {
                let drop = below(random, all[at].chars().count().max(1));
                all[at] = all[at].chars().enumerate().filter(|(i, _)| *i != drop).map(|(_, c)| c).collect();
            }
        }
    }
    all.concat()
}

/// The seeds of as many cases: `LINKWRIGHT_FUZZ=200` makes two hundred times as many, by `LINKWRIGHT_SEED=N` from another one on.
pub fn seeds(cases: usize) -> std::ops::Range<usize> {
    let given = |name: &str| std::env::var(name).ok().and_then(|text| text.parse::<usize>().ok());
    let first = given("LINKWRIGHT_SEED").unwrap_or(0);
    first..first + cases * given("LINKWRIGHT_FUZZ").unwrap_or(1)
}
