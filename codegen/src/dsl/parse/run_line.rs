//! Lines of `run`.

use super::unit::optional_unit;
use super::words::{docs, equals, name};
use crate::dsl::region::here;
use crate::dsl::{Region, RunSetting, RunValue};
use syn::ext::IdentExt;
use syn::parse::{ParseStream, Result};
use syn::{Ident, Lit, LitInt, Token};

const FORM: &str = "a setting: `t_end = 30 [ms];`, `rtol = 1e-11;`, `method = dop853;` or `until = period;`";

/// `t_end = 30 [ms]`, `until = period: 3`
pub(super) fn setting(input: ParseStream) -> Result<RunSetting> {
    docs(input)?;
    let name = name(input, FORM)?;
    equals(input, FORM)?;
    Ok(RunSetting { name, value: value(input)? })
}

fn value(input: ParseStream) -> Result<RunValue> {
    if input.peek(Lit) {
        let literal: Lit = input.parse()?;
        let text = match &literal {
            Lit::Int(number) if number.suffix().is_empty() => number.base10_digits().to_owned(),
            Lit::Float(number) if number.suffix().is_empty() => number.base10_digits().to_owned(),
            other => return Err(syn::Error::new(other.span(), format!("expected {FORM}"))),
        };
        let region = Region::from(literal.span());
        return Ok(RunValue::Number { text, unit: optional_unit(input)?, region });
    }
    if !input.peek(Ident::peek_any) {
        return Err(here(input, format!("expected {FORM}")));
    }
    let word = input.call(Ident::parse_any)?;
    let mut count = None;
    if input.parse::<Option<Token![:]>>()?.is_some() {
        let literal: LitInt = input.parse()?;
        let positive = literal.base10_parse().ok().filter(|count| *count > 0);
        count = Some(positive.ok_or_else(|| syn::Error::new(literal.span(), "a whole number above 0 is needed"))?);
    }
    Ok(RunValue::Word { word, count })
}
