//! The lines of `events`: conditions and their actions.

use super::equation::equation;
use super::expression::expression;
use super::lines::{ended, lines};
use super::words::{accept_word, docs, equals, keyword, name};
use crate::dsl::region::here;
use crate::dsl::vocabulary::ActionWord;
use crate::dsl::{Action, Activity, Direction, Event, Region};
use syn::parse::{ParseStream, Result};
use syn::{Ident, LitInt, Token};

/// `name: left = right;`, or with a direction and actions: `name: left = right falling { .. }`.
pub(super) fn event(input: ParseStream) -> Result<Event> {
    let condition = equation(input)?;
    let direction = direction(input)?;
    if !input.peek(syn::token::Brace) {
        if input.parse::<Option<Token![;]>>()?.is_none() {
            return Err(here(
                input,
                "expected `;` at the end of this line, or `rising`, `falling`, `{ .. }` with what happens then",
            ));
        }
        return Ok(Event { condition, direction, actions: vec![] });
    }
    let content;
    syn::braced!(content in input);
    let actions = lines(&content, ended(action))?;
    input.parse::<Option<Token![;]>>()?;
    Ok(Event { condition, direction, actions })
}

fn direction(input: ParseStream) -> Result<Option<Direction>> {
    Ok(if accept_word(input, "rising")? {
        Some(Direction::Rising)
    } else if accept_word(input, "falling")? {
        Some(Direction::Falling)
    } else {
        None
    })
}

fn action(input: ParseStream) -> Result<Action> {
    docs(input)?;
    let (word, action) = keyword(input)?;
    match action {
        ActionWord::Record => Ok(Action::Record),
        ActionWord::Stop => stop(input, Region::from(&word)),
        ActionWord::Set => set(input),
        ActionWord::Swap => {
            let first = name(input, "a coordinate: `swap q1, q2;`")?;
            if input.parse::<Option<Token![,]>>()?.is_none() {
                return Err(here(input, "two coordinates are swapped: `swap q1, q2;`"));
            }
            Ok(Action::Swap(first, name(input, "a coordinate: `swap q1, q2;`")?))
        }
        ActionWord::Impact => {
            let constraint = name(input, "the name of a constraint: `impact floor restitution e;`")?;
            let restitution = if accept_word(input, "restitution")? { Some(expression(input)?) } else { None };
            Ok(Action::Impact { constraint, restitution })
        }
        ActionWord::Activate => switch(input, &word, Activity::Active),
        ActionWord::Release => switch(input, &word, Activity::Released),
    }
}

fn switch(input: ParseStream, word: &Ident, to: Activity) -> Result<Action> {
    let constraint = name(input, &format!("the name of a constraint: `{word} contact;`"))?;
    Ok(Action::Switch { constraint, to })
}

fn stop(input: ParseStream, place: Region) -> Result<Action> {
    if !accept_word(input, "after")? {
        return Ok(Action::Stop { after: 1, place });
    }
    const FORM: &str = "`stop after` takes the number of an occurrence, a whole number from 1: `stop after 3;`";
    let mistake = here(input, FORM);
    let count = input.parse::<LitInt>().ok().and_then(|count| count.base10_parse::<usize>().ok());
    match count.filter(|count| *count > 0) {
        Some(after) => Ok(Action::Stop { after, place }),
        None => Err(mistake),
    }
}

fn set(input: ParseStream) -> Result<Action> {
    const FORM: &str = "what is set: `set x = 0;`, `set dot(x) = 0;` or `set m = 2;`";
    let first = name(input, FORM)?;
    let (name, is_speed) = if first == "dot" && input.peek(syn::token::Paren) {
        let content;
        syn::parenthesized!(content in input);
        let coordinate: Ident = name(&content, "a coordinate: `set dot(alpha) = ..;`")?;
        if !content.is_empty() {
            return Err(here(
                &content,
                "only the speed of a coordinate can be set, `set dot(alpha) = ..;`, not that of an expression",
            ));
        }
        (coordinate, true)
    } else {
        (first, false)
    };
    equals(input, FORM)?;
    Ok(Action::Set { name, is_speed, value: expression(input)? })
}
