//! Pieces of HTML.

use crate::show::typeset;

/// Text as HTML.
pub(super) fn escaped(text: &str) -> String {
    let mut html = String::with_capacity(text.len());
    for letter in text.chars() {
        match letter {
            '&' => html += "&amp;",
            '<' => html += "&lt;",
            '>' => html += "&gt;",
            '"' => html += "&quot;",
            other => html.push(other),
        }
    }
    html
}

/// A unit as it is printed; nothing for a pure number.
pub(super) fn unit(unit: &str) -> String {
    if unit == "1" { String::new() } else { escaped(bare(&typeset(&format!("[{unit}]")))) }
}

fn bare(bracketed: &str) -> &str {
    bracketed.trim_start_matches('[').trim_end_matches(']')
}

/// A number with at most so many significant digits, the shortest way.
pub(super) fn number(value: f64, digits: usize) -> String {
    let rounded: f64 = format!("{value:.*e}", digits.saturating_sub(1)).parse().unwrap_or(value);
    let plain = rounded == 0.0 || (1e-4..1e7).contains(&rounded.abs());
    let text = if plain { format!("{rounded}") } else { format!("{rounded:e}") };
    text.replace('-', "\u{2212}")
}

/// A card with a heading and a table; nothing without rows.
pub(super) fn table(heading: &str, head: &[(&str, &str)], rows: &[String], note: &str) -> String {
    if rows.is_empty() {
        return String::new();
    }
    let cells: String = head.iter().map(|(class, text)| format!("<th class=\"{class}\">{text}</th>")).collect();
    let head = if head.is_empty() { String::new() } else { format!("<thead><tr>{cells}</tr></thead>") };
    let note = if note.is_empty() { String::new() } else { format!("<p class=\"note\">{note}</p>") };
    format!(
        "<div class=\"card\"><h2>{heading}</h2><div class=\"scroll\"><table>{head}<tbody>\n{}\n</tbody></table></div>{note}</div>\n",
        rows.join("\n")
    )
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn numbers_are_short() {
        assert_eq!(number(0.1 + 0.2, 12), "0.3");
        assert_eq!(number(-1.5e-7, 12), "\u{2212}1.5e\u{2212}7");
        assert_eq!(number(0.877_997_139_511_224_4, 12), "0.877997139511");
        assert_eq!(number(2e9, 6), "2e9");
        assert_eq!(number(0.0, 6), "0");
    }

    #[test]
    fn units_and_text_are_safe() {
        assert_eq!(unit("kg*m^2"), "kg·m²");
        assert_eq!(unit("1"), "");
        assert_eq!(escaped("a < b & \"c\""), "a &lt; b &amp; &quot;c&quot;");
    }
}
