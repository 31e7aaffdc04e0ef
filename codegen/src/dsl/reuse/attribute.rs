//! Which instance a mistake is in.
//!
//! All instances of a fragment have their words at the same place. Where a declaration has mistakes, it is therefore
//! checked again once for each instance, with the words of that one alone in their places: mistakes that still show
//! there are of that instance.

use super::expand_at;
use super::places::Places;
use crate::dsl::Region;
use crate::dsl::limits;
use crate::mistakes::Mistakes;
use proc_macro2::{LineColumn, Span, TokenStream, TokenTree};
use syn::{Error, Result};

/// The number of instances checked; if there are more, half are from the start and half from the end.
const MOST_CHECKS: usize = 24;
/// The number of words checked in all of these.
const MOST_WORDS: usize = 100_000;
/// The number of mistakes shown at one place, which may differ only by the name of the instance.
const MOST_AT_A_PLACE: usize = 2;

/// Writes out fragments and repetitions, and names the instance of each mistake that `check` finds.
///
/// # Errors
/// The mistakes of writing out, and those of `check`.
pub fn attributed<T>(tokens: TokenStream, check: impl Fn(TokenStream) -> Result<T>) -> Result<T> {
    limits::check(tokens.clone())?;
    let mut places = Places::default();
    let written = expand_at(tokens.clone(), &mut places).and_then(&check);
    written.map_err(|mistakes| match places.len() {
        0 => mistakes,
        _ => labelled(mistakes, &places, &|focus| expand_at(tokens.clone(), focus).and_then(&check).err(), &tokens),
    })
}

/// The start of a mistake and its message.
type Finding = (LineColumn, String);

fn finding(mistake: &Error) -> Finding {
    (mistake.span().start(), mistake.to_string())
}

fn labelled(
    mistakes: Error,
    places: &Places,
    check: &dyn Fn(&mut Places) -> Option<Error>,
    tokens: &TokenStream,
) -> Error {
    let elsewhere = tokens.clone().into_iter().next().map_or_else(Span::call_site, |token| token.span());
    let count = places.len();
    let half = (MOST_WORDS / places.words.max(1)).clamp(2, MOST_CHECKS) / 2;
    let looked_at = (1..=count).filter(|i| *i <= half || *i > count.saturating_sub(half));
    let found: Vec<(usize, Vec<Finding>)> = looked_at
        .map(|instance| {
            let mistakes = check(&mut Places::focused(instance, elsewhere));
            let here = mistakes.into_iter().flatten().filter(|mistake| mistake.span().start() != elsewhere.start());
            (instance, here.map(|mistake| finding(&mistake)).collect())
        })
        .collect();
    let mut shown: Vec<Finding> = Vec::new();
    let mut labelled = Mistakes::default();
    for mistake in mistakes {
        let what = finding(&mistake);
        let there = shown.iter().filter(|(place, _)| *place == what.0).count();
        if shown.contains(&what) || there == MOST_AT_A_PLACE {
            continue;
        }
        let labels = found.iter().filter(|(_, findings)| findings.contains(&what)).map(|(i, _)| places.label(*i));
        labelled.add(with_label(&mistake, &labels.collect::<Vec<_>>()));
        shown.push(what);
    }
    labelled.or(()).err().unwrap_or(Error::new(elsewhere, "this declaration has mistakes"))
}

fn with_label(mistake: &Error, labels: &[&str]) -> Error {
    let of = match labels {
        [] => return mistake.clone(),
        [one] => (*one).to_owned(),
        [first, second] => format!("{first} and {second}"),
        [first, rest @ ..] => format!("{first} and {} more", rest.len()),
    };
    let words: Vec<TokenTree> = mistake.to_compile_error().into_iter().collect();
    let ends = words.first().map_or_else(|| mistake.span(), TokenTree::span);
    let region = Region::from(ends).to(words.last().map_or(ends, TokenTree::span).into());
    region.error(format!("{mistake} ({of})"))
}
