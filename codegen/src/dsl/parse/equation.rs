//! Equations, and whether they hold at the start.

use super::expression::expression;
use super::words::{accept_word, colon, docs, equals, keyword, name};
use crate::dsl::vocabulary::ActivityWord;
use crate::dsl::{Activity, Equation};
use syn::parse::{ParseStream, Result};

pub(super) fn equation(input: ParseStream) -> Result<Equation> {
    docs(input)?;
    let name = name(input, "a named equation: `closure: left = right;`")?;
    colon(input, "an equation has a name: `closure: left = right;`")?;
    let left = expression(input)?;
    equals(input, "an equation has two sides: `closure: left = right;`")?;
    Ok(Equation { name, left, right: expression(input)?, initially: None, is_of_joint: false })
}

/// An equation, and whether it holds at the start if events switch it.
pub(super) fn constraint(input: ParseStream) -> Result<Equation> {
    let equation = equation(input)?;
    Ok(Equation { initially: initially(input)?, ..equation })
}

/// `initially active`, or `initially released`.
pub(super) fn initially(input: ParseStream) -> Result<Option<Activity>> {
    if !accept_word(input, "initially")? {
        return Ok(None);
    }
    Ok(Some(match keyword(input)?.1 {
        ActivityWord::Active => Activity::Active,
        ActivityWord::Released => Activity::Released,
    }))
}
