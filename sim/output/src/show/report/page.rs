//! The page: its template, filled.

use super::Shown;
use super::data::data;
use super::html::escaped;
use super::live::{self, Live};
use sim_kernel::Description;
use sim_runtime::Provenance;

const TEMPLATE: &str = include_str!("../../../assets/report/page.html");
const STYLE: [&str; 2] =
    [include_str!("../../../assets/uplot/uPlot.min.css"), include_str!("../../../assets/report/style.css")];
const UPLOT: &str = include_str!("../../../assets/uplot/uPlot.iife.min.js");
const UPLOT_LICENSE: &str = include_str!("../../../assets/uplot/LICENSE.txt");
const SCRIPT: [&str; 8] = [
    include_str!("../../../assets/report/samples.js"),
    include_str!("../../../assets/report/format.js"),
    include_str!("../../../assets/report/view.js"),
    include_str!("../../../assets/report/drawing.js"),
    include_str!("../../../assets/report/pinch.js"),
    include_str!("../../../assets/report/plots.js"),
    include_str!("../../../assets/report/player.js"),
    include_str!("../../../assets/report/page.js"),
];

/// The policy of a page from a file; one that is served has a stricter one in its head.
const POLICY: &str = "<meta http-equiv=\"Content-Security-Policy\" content=\"default-src 'none'; script-src 'unsafe-inline'; \
    style-src 'unsafe-inline'; img-src data:\">\n";

/// The size of typeset equations, in bytes, beyond which they are omitted.
#[cfg(feature = "analysis")]
const MOST_OF_EQUATIONS: usize = 300_000;

/// The whole page; with what keeps it up to date if it is served.
pub(super) fn page(shown: &Shown, live: Option<&Live>) -> String {
    let description = shown.description;
    fill(TEMPLATE, |slot| match slot {
        "title" => escaped(&spaced(description.type_name)),
        "docs" => with_code(&escaped(&description.docs.replace('\n', " "))),
        "style" => STYLE.concat() + live.map_or("", |_| live::STYLE),
        "policy" => live.map_or(POLICY, |_| "").to_owned(),
        "nonce" => live.map_or(String::new(), Live::attribute),
        "number" => live.map_or(String::new(), Live::number),
        "failure" => failure(shown),
        "facts" => facts(shown),
        "tables" => shown.tables.clone(),
        "equations" => equations(description),
        "reproduce" => reproduce(shown),
        "generator" => escaped(&Provenance::program()),
        "provenance" => escaped(&shown.table.provenance.to_json().to_string()),
        "footer" => footer(&shown.table.provenance),
        // Within a script element only its end tag must not occur.
        // So that no text of a declaration ends the script, or begins what a page reads otherwise.
        "data" => data(shown).to_string().replace('<', "\\u003c"),
        "uplot" => format!("/*!\n{UPLOT_LICENSE}*/\n{UPLOT}"),
        // One script: a browser draws the page between two, before the reader's choices are made again.
        "script" => script(&SCRIPT.concat(), &live.map_or(String::new(), |_| live::SCRIPT.concat())),
        other => other.to_owned(),
    })
}

/// Scripts in a scope of their own.
fn script(parts: &str, more: &str) -> String {
    format!("(() => {{\n\"use strict\";\n{parts}{more}}})();")
}

/// What made the page, of what, and which run it is; the command stands above.
fn footer(provenance: &Provenance) -> String {
    let mut footer = escaped(&Provenance::program());
    for (name, text) in [("declaration", &provenance.declaration), ("run", &provenance.run)] {
        footer += &text.as_ref().map_or(String::new(), |text| format!("; {name} <code>{}</code>", escaped(text)));
    }
    footer + ". Plots by uPlot 1.6, under the MIT licence."
}

/// The template with each `{{slot}}` replaced; inserted text is not processed again.
fn fill(template: &str, content: impl Fn(&str) -> String) -> String {
    let mut page = String::new();
    let mut pieces = template.split("{{");
    page += pieces.next().unwrap_or_default();
    for piece in pieces {
        let (slot, rest) = piece.split_once("}}").unwrap_or((piece, ""));
        page += &content(slot);
        page += rest;
    }
    page
}

/// Words between backticks as code.
fn with_code(html: &str) -> String {
    let pieces = html.split('`').enumerate();
    pieces.map(|(i, piece)| if i % 2 == 1 { format!("<code>{piece}</code>") } else { piece.to_owned() }).collect()
}

/// `QuickReturn` as `Quick return`.
fn spaced(type_name: &str) -> String {
    let mut words = String::new();
    let letters: Vec<char> = type_name.chars().collect();
    for (i, letter) in letters.iter().enumerate() {
        let starts_word = i > 0 && letter.is_uppercase() && !letters[i - 1].is_uppercase();
        let is_acronym = letters.get(i + 1).is_some_and(|next| next.is_uppercase());
        if starts_word {
            words.push(' ');
        }
        match starts_word && !is_acronym {
            true => words.extend(letter.to_lowercase()),
            false => words.push(*letter),
        }
    }
    words
}

fn failure(shown: &Shown) -> String {
    let Some(failure) = shown.failure else { return String::new() };
    let what = if shown.abscissa.is_some() { "sweep" } else { "run" };
    format!("<p class=\"failure\"><strong>The {what} ended early.</strong> {}</p>", escaped(&failure.to_string()))
}

/// The motion in short.
fn facts(shown: &Shown) -> String {
    let item = |(name, value, warn): &(&str, String, bool)| {
        let class = if *warn { " class=\"warn\"" } else { "" };
        format!("<li{class}><span>{name}</span>{}</li>", escaped(value))
    };
    shown.facts.iter().map(item).collect::<Vec<_>>().join("\n")
}

/// The equations of motion, if the declaration can be derived again.
#[cfg(feature = "analysis")]
fn equations(description: &Description) -> String {
    let Ok(parts) = codegen::equations_as(codegen::notation::Notation::MathMl, description.declaration) else {
        return String::new();
    };
    let length: usize = parts.iter().map(|part| part.text.len()).sum();
    if length > MOST_OF_EQUATIONS {
        let note = "The equations are too long to be read here; `codegen` prints the kernels made of them.";
        return format!(
            "<section class=\"card equations\"><h2>Equations of motion</h2><p class=\"note\">{note}</p></section>"
        );
    }
    let part = |part: &codegen::notation::Section| {
        let heading = if part.name == "system" { String::new() } else { format!("<h3>{}</h3>\n", part.title) };
        format!("{heading}<div class=\"row\">{}</div>", apart(&part.text))
    };
    let parts: Vec<String> = parts.iter().map(part).collect();
    format!("<section class=\"card equations\"><h2>Equations of motion</h2>\n{}</section>", parts.join("\n"))
}

/// Adds space between factors and arguments, as in print: browsers give invisible operators none.
#[cfg(feature = "analysis")]
fn apart(mathml: &str) -> String {
    let spaced = |space: &str, sign: char| format!("<mo {space}=\"0.14em\">{sign}</mo>");
    let (apply, times) = ('\u{2061}', '\u{2062}');
    mathml
        .replace(&format!("<mo>{apply}</mo>"), &spaced("rspace", apply))
        .replace(&format!("<mo>{times}</mo>"), &spaced("lspace", times))
}

/// The equations of motion need the derivation at run time.
#[cfg(not(feature = "analysis"))]
fn equations(_: &Description) -> String {
    String::new()
}

fn reproduce(shown: &Shown) -> String {
    let mut html = format!("<pre>{}</pre>", escaped(shown.command));
    if let Some(run_file) = shown.run_file {
        html += &format!(
            "<details class=\"source\"><summary>The run file, run.json</summary><pre>{}</pre></details>",
            escaped(run_file)
        );
    }
    let declaration = escaped(shown.description.declaration.trim_end());
    html += &format!("<details class=\"source\"><summary>The declaration</summary><pre>{declaration}</pre></details>");
    html
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn slots_are_filled_once() {
        let page = fill("<a>{{one}}</a>{{two}}", |slot| format!("[{slot} {{{{one}}}}]"));
        assert_eq!(page, "<a>[one {{one}}]</a>[two {{one}}]");
        assert!(!TEMPLATE.contains("</script>\n{{"));
    }

    #[test]
    fn names_of_types_are_words() {
        assert_eq!(spaced("QuickReturn"), "Quick return");
        assert_eq!(spaced("FourBar"), "Four bar");
        assert_eq!(spaced("SCARA"), "SCARA");
    }
}
