//! Mistakes with their places, to be shown under the user's own line.

use std::fmt::Write;
use std::ops::Range;

/// A mistake in a text.
#[derive(Clone, PartialEq, Eq, Debug)]
pub struct Mistake {
    /// Its kind: `E-TEXT` of what is not made of words, `E-FORM` of what is not said as the language says it, `E-TABLE` of a
    /// table's file, `E-MEANING` of what means nothing.
    pub code: &'static str,
    /// What is wrong, and what would be right.
    pub message: String,
    /// Where it starts.
    pub start: Position,
    /// Where it ends.
    pub end: Position,
    /// Other places that belong to it: the first definition of a name that is defined twice.
    pub related: Vec<Related>,
}

/// A place that belongs to a mistake elsewhere.
#[derive(Clone, PartialEq, Eq, Debug)]
pub struct Related {
    /// What stands there.
    pub message: String,
    /// Where it starts.
    pub start: Position,
    /// Where it ends.
    pub end: Position,
}

/// A place in a text, all numbers from 0.
#[derive(Clone, Copy, PartialEq, Eq, Debug)]
pub struct Position {
    /// The line.
    pub line: usize,
    /// Characters of the line before it.
    pub column: usize,
    /// The same in units of UTF-16.
    pub column_utf16: usize,
    /// Bytes of the text before it.
    pub byte: usize,
}

impl Mistake {
    /// A mistake at bytes of a text.
    pub fn at(text: &str, code: &'static str, bytes: Range<usize>, message: String) -> Mistake {
        let [start, end] = [bytes.start, bytes.end].map(|byte| Position::at(text, byte));
        Mistake { code, message, start, end, related: Vec::new() }
    }

    /// All mistakes of a kind in a text, in order of their places.
    pub fn all(text: &str, code: &'static str, mistakes: syn::Error) -> Vec<Mistake> {
        let mut all: Vec<Mistake> = Vec::new();
        for mistake in mistakes {
            let (span, message) = (mistake.span(), mistake.to_string());
            let [start, end] = [span.start(), span.end()].map(|at| Position::of(text, at.line.max(1) - 1, at.column));
            match all.last_mut() {
                Some(of) if tells_of_a_place(&message) => of.related.push(Related { message, start, end }),
                _ => all.push(Mistake { code, message, start, end, related: Vec::new() }),
            }
        }
        all.sort_by_key(|mistake| mistake.start.byte);
        all
    }

    /// The word that is right, where the message knows one.
    pub fn suggestion(&self) -> Option<&str> {
        let (_, after) = self.message.split_once("did you mean `")?;
        Some(after.split_once('`')?.0)
    }

    /// The message, the place, the line with the words in question underlined, and what else the message says; then every
    /// related place.
    pub fn shown(&self, file: &str, text: &str) -> String {
        let mut out = shown(&self.message, [self.start, self.end], file, text);
        for Related { message, start, end } in &self.related {
            out += "\nnote: ";
            out += &shown(message, [*start, *end], file, text);
        }
        out
    }
}

/// Whether a message says what stands at a place, `.. is here`, and so belongs to the mistake before it.
fn tells_of_a_place(message: &str) -> bool {
    message.split([';', ':', ',', '\n']).next().is_some_and(|clause| clause.ends_with(" here"))
}

fn shown(message: &str, [start, end]: [Position; 2], file: &str, text: &str) -> String {
    let (message, more) = message.split_once('\n').unwrap_or((message, ""));
    let Position { line, column, .. } = start;
    let words: Vec<char> = text.lines().nth(line).unwrap_or_default().chars().collect();
    let number = (line + 1).to_string();
    let margin = " ".repeat(number.len());
    let [first, last] = excerpt(words.len(), column);
    let [before, after] = [first > 0, last < words.len()].map(|is_cut| if is_cut { "..." } else { "" });
    let end = if end.line == line { end.column } else { words.len() };
    let underline = "^".repeat(end.min(last.max(column + 1)).saturating_sub(column).max(1));
    // Tabs stay tabs, so that the mark stands under the word.
    let blank = before.chars().chain(words[first..last].iter().copied().take(column - first));
    let indent: String = blank.map(|c| if c == '\t' { c } else { ' ' }).collect();
    let words: String = words[first..last].iter().collect();
    let mut out = format!("{message}\n{margin}--> {file}:{number}:{}\n{margin} |\n", column + 1);
    out += &format!("{number} | {before}{words}{after}\n{margin} | {indent}{underline}");
    more.lines().for_each(|line| {
        // Writing to a string does not fail.
        let _ = write!(out, "\n{margin} = {}", line.trim_start());
    });
    out
}

/// The longest line that is shown whole, in characters.
const WIDEST: usize = 160;

/// The columns of a line that are shown: all, or those around a column.
fn excerpt(length: usize, column: usize) -> [usize; 2] {
    let first = column.saturating_sub(WIDEST / 2).min(length.saturating_sub(WIDEST)).min(column);
    [first, length.min(first + WIDEST)]
}

impl Position {
    fn at(text: &str, byte: usize) -> Position {
        let before = text.get(..byte).unwrap_or(text);
        let line = before.matches('\n').count();
        let column = before.rsplit('\n').next().unwrap_or_default().chars().count();
        Position::of(text, line, column)
    }

    fn of(text: &str, line: usize, column: usize) -> Position {
        let start: usize = text.split_inclusive('\n').take(line).map(str::len).sum();
        let before: String = text[start..].chars().take(column).collect();
        Position { line, column, column_utf16: before.encode_utf16().count(), byte: start + before.len() }
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn words_are_underlined_where_they_stand() {
        let text = "pub Bob;\ncoordinates { \u{1d70b} [rad]; }\n\tbodies { ball: mas m; }\n";
        let at = |line, column| Position::of(text, line, column);
        let (message, related) = ("no word\n  known: mass".into(), Vec::new());
        let mistake = Mistake { code: "E-FORM", message, start: at(2, 15), end: at(2, 18), related };
        let shown =
            "no word\n --> bob.mech:3:16\n  |\n3 | \tbodies { ball: mas m; }\n  | \t              ^^^\n  = known: mass";
        assert_eq!(mistake.shown("bob.mech", text), shown);
        // Of a long line the part around the word, with dots where it is cut.
        let long = format!("a{};\n", " + a".repeat(100));
        let (message, related) = ("no word".into(), Vec::new());
        let mistake = Mistake {
            code: "E-FORM",
            message,
            start: Position::of(&long, 0, 200),
            end: Position::of(&long, 0, 201),
            related,
        };
        let shown = mistake.shown("bob.mech", &long);
        let lines: Vec<&str> = shown.lines().collect();
        assert!(lines[3].starts_with("1 | ...a + a") && lines[3].ends_with("a + a + ..."), "{shown}");
        assert_eq!(lines[3].chars().nth(lines[4].chars().count() - 1), Some('a'), "{shown}");
        // A letter of four bytes and two units stands before this.
        assert_eq!(at(1, 16), Position { line: 1, column: 16, column_utf16: 17, byte: 9 + 19 });
        assert_eq!(at(9, 0).byte, text.len());
    }
}
