//! Lines of the `tables` block: functions given by rows.

use super::expression::expression;
use super::lines::{ended, lines};
use super::unit::optional_unit;
use super::words::{accept_word, docs, equals, expect_word, keyword, name};
use crate::dsl::region::here;
use crate::dsl::vocabulary::TableWord;
use crate::dsl::{Between, DeclaredTable, Ends, Expression, Outside, Region};
use syn::ext::IdentExt;
use syn::parse::{ParseStream, Result};
use syn::{Ident, LitStr, Token};

const FORM: &str = "a table is written `lift [mm] over [deg] = cubic, periodic { 0, 0; 90, 10; 360, 0; }`";
const ROW: &str = "a row is an argument and a value: `90, 10;`";

/// Reads a table.
pub(super) fn table(input: ParseStream) -> Result<DeclaredTable> {
    let docs = docs(input)?;
    let name = name(input, "a table: `lift [mm] over [deg] = linear { 0, 0; 90, 10; }`")?;
    let unit = optional_unit(input)?;
    let over = match input.peek(Ident::peek_any) {
        true => {
            expect_word(input, "over", "lift [mm] over [deg] = ..")?;
            match optional_unit(input)? {
                Some(over) => Some(over),
                None => return Err(here(input, "`over` is followed by the unit of the arguments: `over [deg]`")),
            }
        }
        false => None,
    };
    equals(input, FORM)?;
    let mut words = Words::default();
    words.read(input)?;
    let Some(between) = words.between else {
        return Err(syn::Error::new(name.span(), format!("table `{name}` is `linear`, `cubic` or `monotone`; {FORM}")));
    };
    if accept_word(input, "from")? {
        let message = "a file of rows is named in quotes: `from \"lift.csv\"`";
        return Err(here(input, message));
    }
    if !input.peek(syn::token::Brace) {
        return Err(here(input, format!("expected `,`, the rows in braces or `from` a file; {FORM}")));
    }
    let content;
    syn::braced!(content in input);
    let headings = if content.peek(LitStr) { Some(ended(headings)(&content)?) } else { None };
    let rows = lines(&content, ended(row))?;
    input.parse::<Option<Token![;]>>()?;
    let outside = words.outside.unwrap_or(Outside::Held);
    Ok(DeclaredTable { docs, name, unit, over, between, ends: words.ends, outside, headings, rows })
}

/// `"t [ms]", "F [kN]"`, as over the rows of a file.
fn headings(input: ParseStream) -> Result<[LitStr; 2]> {
    let argument = input.parse()?;
    if input.parse::<Option<Token![,]>>()?.is_none() || !input.peek(LitStr) {
        return Err(here(
            input,
            "a heading has two texts, for the arguments and for the values: `\"t [s]\", \"F [N]\";`",
        ));
    }
    Ok([argument, input.parse()?])
}

fn row(input: ParseStream) -> Result<[Expression; 2]> {
    let argument = expression(input)?;
    if input.parse::<Option<Token![,]>>()?.is_none() {
        return Err(here(input, ROW));
    }
    let value = expression(input)?;
    match input.peek(Token![,]) {
        true => Err(here(input, format!("{ROW}, and no more"))),
        false => Ok([argument, value]),
    }
}

/// The words before the rows.
#[derive(Default)]
struct Words {
    between: Option<Between>,
    ends: Option<(Ends, Region)>,
    outside: Option<Outside>,
}

impl Words {
    fn read(&mut self, input: ParseStream) -> Result<()> {
        loop {
            let (word, says) = keyword(input)?;
            let at = Region::from(&word);
            let twice = match says {
                TableWord::Linear => self.between.replace(Between::Linear).is_some(),
                TableWord::Cubic => self.between.replace(Between::Cubic).is_some(),
                TableWord::Monotone => self.between.replace(Between::Monotone).is_some(),
                TableWord::Natural => self.ends.replace((Ends::Natural, at)).is_some(),
                TableWord::Clamped => self.ends.replace((Ends::Clamped, at)).is_some(),
                TableWord::Held => self.outside.replace(Outside::Held).is_some(),
                TableWord::Continued => self.outside.replace(Outside::Continued).is_some(),
                TableWord::Periodic => self.outside.replace(Outside::Periodic).is_some(),
            };
            if twice {
                let message = format!("`{word}` repeats or contradicts an earlier word; give one word of each kind");
                return Err(at.error(message));
            }
            if input.parse::<Option<Token![,]>>()?.is_none() {
                return Ok(());
            }
        }
    }
}
