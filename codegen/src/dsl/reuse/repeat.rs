//! Repetitions and sums written out, indices put in as numbers and as parts of names.

use super::Expander;
use super::index::{Indices, Range, not_whole, range, whole};
use super::names::check_free;
use super::places::MECHANISM;
use super::words::*;
use crate::dsl::limits;
use crate::dsl::region::here;
use proc_macro2::{Delimiter, Group, Ident, Literal, Punct, Spacing, Span, TokenStream, TokenTree};
use syn::ext::IdentExt;
use syn::parse::{ParseStream, Parser, Result};
use syn::{Error, Token};

const REPEAT: &str = "a repetition is written `repeat i in 1..=3 { .. }`";
const SUM: &str = "a sum is written `sum(i in 1..=3, term)`";

impl Expander<'_> {
    /// Copies words of an instance, without repetitions and indices.
    pub(super) fn unroll(
        &mut self,
        tokens: &[TokenTree],
        indices: &Indices,
        instance: usize,
    ) -> Result<Vec<TokenTree>> {
        let mut out = Vec::new();
        let mut at = 0;
        while at < tokens.len() {
            at += self.unroll_next(tokens, at, indices, instance, &mut out)?;
        }
        Ok(out)
    }

    /// Copies the item at `at`, and gives its number of words.
    fn unroll_next(
        &mut self,
        tokens: &[TokenTree],
        at: usize,
        indices: &Indices,
        instance: usize,
        out: &mut Vec<TokenTree>,
    ) -> Result<usize> {
        let (word, next) = (&tokens[at], tokens.get(at + 1));
        if is_word(Some(word), "repeat") && matches!(next, Some(TokenTree::Ident(_) | TokenTree::Literal(_))) {
            drop_documentation(out);
            return self.repetition(&tokens[at..], indices, instance, out);
        }
        if is_word(Some(word), "sum")
            && let Some(terms) = group(next, Delimiter::Parenthesis)
        {
            out.push(self.sum(terms, indices, instance)?);
            return Ok(2);
        }
        if let Some((name, words)) = self.indexed(&tokens[at..], indices, instance)? {
            out.push(name.into());
            return Ok(words);
        }
        self.count(word, instance)?;
        out.push(match word {
            TokenTree::Group(_) if is_unit(tokens, at) => self.copy(word, instance),
            TokenTree::Group(rows) if instance == MECHANISM && limits::is_of_literals(rows) => {
                self.copy(word, instance)
            }
            TokenTree::Group(group) => {
                let inner = self.unroll(&list(group.stream()), indices, instance)?;
                regroup(group, inner, self.places.place(group.span(), instance))
            }
            TokenTree::Ident(name) if !is_component(tokens, at) => match indices.get(&plain(name)) {
                Some(value) => self.number(name, value, next, instance)?,
                None => self.copy(word, instance),
            },
            TokenTree::Literal(literal) => self.literal(literal, indices, instance),
            _ => self.copy(word, instance),
        });
        Ok(1)
    }

    /// `repeat i in 1..=3 { .. }`
    fn repetition(
        &mut self,
        tokens: &[TokenTree],
        indices: &Indices,
        instance: usize,
        out: &mut Vec<TokenTree>,
    ) -> Result<usize> {
        let ends = |token: &TokenTree| is_punct(Some(token), ';') || group(Some(token), Delimiter::Brace).is_some();
        let end = tokens.iter().position(ends);
        let Some((end, body)) = end.and_then(|end| Some((end, group(tokens.get(end), Delimiter::Brace)?))) else {
            return Err(Error::new(self.places.place(tokens[0].span(), instance), REPEAT));
        };
        let header: TokenStream = tokens[1..=end].iter().map(|token| self.copy(token, instance)).collect();
        let parser = |input: ParseStream| {
            let index = input.call(Ident::parse_any).map_err(|e| Error::new(e.span(), REPEAT))?;
            if input.parse::<Option<Token![in]>>()?.is_none() {
                return Err(here(input, REPEAT));
            }
            let range = range(input, indices)?;
            if !input.peek(syn::token::Brace) {
                return Err(not_whole(input));
            }
            input.parse::<TokenTree>()?;
            Ok((index, range))
        };
        let (index, range) = parser.parse2(header)?;
        if range.first > range.last && range.is_literal {
            return Err(Error::new(index.span(), format!("nothing is repeated: {} is empty", range.text)));
        }
        let body = list(body.stream());
        for value in range.first..=range.last {
            let (indices, round) = self.round(&index, value, indices, instance)?;
            out.extend(self.unroll(&body, &indices, round)?);
        }
        Ok(end + 1)
    }

    /// One round of a repetition or sum: what its indices are, and its number among the instances.
    fn round(&mut self, index: &Ident, value: i64, indices: &Indices, instance: usize) -> Result<(Indices, usize)> {
        check_free(index)?;
        self.indices.entry(plain(index)).or_insert(index.span());
        self.count(&index.clone().into(), instance)?;
        let number = self.places.enter(format!("for {index} = {value}"), instance);
        Ok((indices.with(&plain(index), value), number))
    }

    /// `sum(i in 1..=3, term)` as `((term) + (term) + (term))`, or of many terms as a sum of such sums.
    fn sum(&mut self, terms: &Group, indices: &Indices, instance: usize) -> Result<TokenTree> {
        let place = self.places.place(terms.span(), instance);
        let words = list(terms.stream());
        let comma = words.iter().position(|word| is_punct(Some(word), ',')).unwrap_or(words.len());
        let header: TokenStream = words[..comma].iter().map(|token| self.copy(token, instance)).collect();
        let term = words.get(comma + 1..).filter(|term| !term.is_empty()).ok_or_else(|| Error::new(place, SUM))?;
        let parser = |input: ParseStream| -> Result<(Ident, Range)> {
            let index = input.call(Ident::parse_any).map_err(|_| Error::new(place, SUM))?;
            input.parse::<Token![in]>().map_err(|_| Error::new(place, SUM))?;
            if input.is_empty() {
                return Err(Error::new(place, SUM));
            }
            let range = range(input, indices)?;
            if input.is_empty() { Ok((index, range)) } else { Err(not_whole(input)) }
        };
        let (index, range) = parser.parse2(header)?;
        if range.first > range.last {
            return Err(Error::new(index.span(), format!("a sum has at least one term, and {} is empty", range.text)));
        }
        let mut summands = Vec::new();
        for value in range.first..=range.last {
            let (indices, round) = self.round(&index, value, indices, instance)?;
            let term = self.unroll(term, &indices, round)?;
            summands.push(regroup(terms, term, place));
        }
        Ok(nested_sum(terms, &summands, place))
    }

    /// `P_[i]`, and `leg_[i]_foot`: the name, and of how many words.
    fn indexed(&self, tokens: &[TokenTree], indices: &Indices, instance: usize) -> Result<Option<(Ident, usize)>> {
        let Some(first) = ident(tokens.first()) else { return Ok(None) };
        let (mut name, mut words) = (plain(first), 1);
        while name.ends_with('_')
            && let Some(brackets) = group(tokens.get(words), Delimiter::Bracket)
            && (words > 1 || is_index(first.span(), brackets, indices))
        {
            name += &self.index_values(brackets, indices, instance)?.join("_");
            words += 1;
            if let Some(more) = ident(tokens.get(words)).filter(|more| more.to_string().starts_with('_')) {
                name += &more.to_string();
                words += 1;
            }
        }
        let place = self.places.place(first.span(), instance);
        Ok((words > 1).then(|| (Ident::new(&name, place), words)))
    }

    /// The numbers in brackets, separated by commas.
    fn index_values(&self, brackets: &Group, indices: &Indices, instance: usize) -> Result<Vec<String>> {
        let parser = |input: ParseStream| {
            let content;
            syn::bracketed!(content in input);
            let mut values = Vec::new();
            loop {
                let place = content.span();
                let value = whole(&content, indices)?;
                if value < 0 {
                    return Err(Error::new(place, format!("this index is {value}; indices count from 0")));
                }
                values.push(value.to_string());
                if content.is_empty() {
                    return Ok(values);
                }
                if content.parse::<Option<Token![,]>>()?.is_none() {
                    return Err(not_whole(&content));
                }
            }
        };
        parser.parse2(self.copy(&brackets.clone().into(), instance).into())
    }

    /// An index or constant that stands in an expression.
    fn number(&self, name: &Ident, value: i64, next: Option<&TokenTree>, instance: usize) -> Result<TokenTree> {
        let place = self.places.place(name.span(), instance);
        let is_declared = is_punct(next, ':') || group(next, Delimiter::Bracket).is_some();
        if is_declared {
            let message = format!("`{name}` is a whole number here, an index or a `const`; choose another name");
            return Err(Error::new(place, message));
        }
        let mut digits = Literal::i64_unsuffixed(value.abs());
        digits.set_span(place);
        if value >= 0 {
            return Ok(digits.into());
        }
        let mut minus = Punct::new('-', Spacing::Alone);
        minus.set_span(place);
        let words = [TokenTree::from(minus), TokenTree::from(digits)];
        let mut group = Group::new(Delimiter::Parenthesis, words.into_iter().collect());
        group.set_span(place);
        Ok(group.into())
    }

    /// Titles and documentation may name indices in braces: `"Angle of rod {i}"`.
    fn literal(&self, literal: &Literal, indices: &Indices, instance: usize) -> TokenTree {
        let place = self.places.place(literal.span(), instance);
        let filled = text(literal).filter(|text| text.contains('{')).map(|text| indices.fill(&text));
        let mut literal = filled.map_or_else(|| literal.clone(), |text| Literal::string(&text));
        literal.set_span(place);
        literal.into()
    }

    /// The same word, at the place of this instance's words.
    pub(super) fn copy(&self, token: &TokenTree, instance: usize) -> TokenTree {
        let place = self.places.place(token.span(), instance);
        match token {
            TokenTree::Group(group) if !self.places.are_kept(instance) => {
                let inner = list(group.stream()).iter().map(|token| self.copy(token, instance)).collect();
                regroup(group, inner, place)
            }
            _ => {
                let mut token = token.clone();
                if !self.places.are_kept(instance) {
                    token.set_span(place);
                }
                token
            }
        }
    }
}

/// Terms in brackets with plus signs between them. Many of them are halved, as an expression is taken apart sign by sign.
fn nested_sum(brackets: &Group, terms: &[TokenTree], place: Span) -> TokenTree {
    const MOST_TERMS: usize = 64;
    if terms.len() > MOST_TERMS {
        let halves = terms.chunks(terms.len().div_ceil(2)).map(|half| nested_sum(brackets, half, place));
        return nested_sum(brackets, &halves.collect::<Vec<_>>(), place);
    }
    let mut sum = Vec::new();
    for term in terms {
        if !sum.is_empty() {
            sum.push(Punct::new('+', Spacing::Alone).into());
        }
        sum.push(term.clone());
    }
    regroup(brackets, sum, place)
}

/// Whether brackets after a name that ends in `_` hold an index, and not a unit: all of their names are indices, or no
/// space stands in front of them.
fn is_index(name: Span, brackets: &Group, indices: &Indices) -> bool {
    let words = list(brackets.stream());
    let known = |word: &TokenTree| ident(Some(word)).is_none_or(|name| indices.get(&plain(name)).is_some());
    let adjoins = name.end() == brackets.span_open().start() && name.end().line > 0;
    words.iter().all(known) || adjoins
}

/// The same brackets around other words.
pub(super) fn regroup(group: &Group, inner: Vec<TokenTree>, place: Span) -> TokenTree {
    // Brackets that are kept also keep the places of their ends.
    if same(&list(group.stream()), &inner) && place.start() == group.span().start() {
        return group.clone().into();
    }
    let mut copy = Group::new(group.delimiter(), inner.into_iter().collect());
    copy.set_span(place);
    copy.into()
}

fn same(a: &[TokenTree], b: &[TokenTree]) -> bool {
    a.len() == b.len()
        && a.iter().zip(b).all(|(a, b)| match (a, b) {
            (TokenTree::Group(a), TokenTree::Group(b)) => same(&list(a.stream()), &list(b.stream())),
            (TokenTree::Ident(a), TokenTree::Ident(b)) => a == b,
            (TokenTree::Punct(a), TokenTree::Punct(b)) => a.as_char() == b.as_char(),
            _ => a.to_string() == b.to_string(),
        })
}
