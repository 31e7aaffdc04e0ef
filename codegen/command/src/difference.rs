//! The differences between two texts.

use similar::TextDiff;

/// Lines of context around a change.
const CONTEXT: usize = 2;
/// Changes beyond these are only counted.
const SHOWN: usize = 8;

/// The changes as a unified diff, headed by the place of the first one; empty if there are none.
pub(crate) fn difference(file: &str, expected: &str, found: &str) -> Option<String> {
    if expected == found {
        return None;
    }
    let diff = TextDiff::from_lines(expected, found);
    let mut unified = diff.unified_diff();
    unified.context_radius(CONTEXT);
    let hunks: Vec<String> = unified.iter_hunks().map(|hunk| hunk.to_string()).collect();
    let same = expected.lines().zip(found.lines()).take_while(|(a, b)| a == b).count();
    let mut out = format!("{file}:{}: differs from what is generated now, in {} places\n", same + 1, hunks.len());
    out += &format!("--- {file}\n+++ generated\n");
    hunks.iter().take(SHOWN).for_each(|hunk| out += hunk);
    if hunks.len() > SHOWN {
        out += &format!("and {} more\n", hunks.len() - SHOWN);
    }
    Some(out)
}
