//! Messages about wrong dimensions: the units of both sides, and where they come from.

use super::interpreter::Interpreter;
use super::origin::Origin;
use super::scope::plain;
use super::value::Value;
use super::{Dimension, Unit};
use crate::dsl::{Expression, Kind, Operator};
use syn::Ident;

impl Interpreter {
    /// Two expressions of unlike dimension that meet.
    pub(super) fn unlike(
        &self,
        left: &Expression,
        of_left: &Dimension,
        right: &Expression,
        of_right: &Dimension,
        rule: &str,
    ) -> syn::Error {
        let (left_is, right_is) = (self.describe(left, of_left), self.describe(right, of_right));
        // A number that lacks a unit is to blame; otherwise the left side is taken as right.
        let lacking = self.lacking(left, of_left, self.unit_of(right, of_right));
        let lacking = lacking.or_else(|| self.lacking(right, of_right, self.unit_of(left, of_left)));
        let (place, advice) = lacking.unwrap_or((right, String::new()));
        place.region.error(format!("{left_is} and {right_is}; {rule}{advice}"))
    }

    /// An expression in a place that needs another dimension, in a unit of it.
    pub(super) fn misplaced(
        &self,
        expression: &Expression,
        dimension: &Dimension,
        needed: (&Dimension, &str),
        claim: &str,
    ) -> syn::Error {
        let is = self.describe(expression, dimension);
        let lacking = match dimension.is_none() {
            true => self.lacking(expression, dimension, needed.1.to_owned()),
            false => factor_without_unit(expression, needed, dimension),
        };
        let (place, advice) = lacking.unwrap_or((expression, String::new()));
        place.region.error(format!("{claim}, and {is}{advice}"))
    }

    /// Records the mistake, with the definitions of names that stand for whole expressions. A name without a unit of
    /// its own is reported once.
    pub(super) fn blame<T>(&mut self, mut mistake: syn::Error, expressions: &[&Expression]) -> Option<T> {
        for expression in expressions {
            if let Some(from) = single_name(expression).and_then(|name| self.shown_origin(&plain(name))) {
                mistake.combine(from);
            }
            if let Some(from) = self.reaction_origin(expression) {
                mistake.combine(from);
            }
        }
        self.mistakes.add(mistake);
        None
    }

    /// Where a name comes from, shown once.
    fn shown_origin(&mut self, name: &str) -> Option<syn::Error> {
        let region = self.values.get_region(name)?;
        let (from, has_unit) = match self.origins.show(name)? {
            Origin::Declared(Some(unit)) => (format!("`{name}` is declared in [{unit}] here"), true),
            Origin::Declared(None) => (format!("`{name}` is declared without a unit here"), false),
            Origin::Defined(parts) => (format!("`{name}` is defined here{parts}"), false),
        };
        if !has_unit {
            self.values.change(name, |value| value.dimension = None);
        }
        Some(region.error(from))
    }

    fn reaction_origin(&self, expression: &Expression) -> Option<syn::Error> {
        let (constraint, dimension) = self.reaction_of(expression)?;
        let region = self.reactions.as_ref()?.get_region(&plain(constraint))?;
        let reaction = dimension.si_unit();
        Some(
            region
                .error(format!("the reaction of `{constraint}`, here, is in [{reaction}]: work per unit of its sides")),
        )
    }

    /// "`m*g` is in [N] (m [kg], g [m/s^2])"
    pub(super) fn describe(&self, expression: &Expression, dimension: &Dimension) -> String {
        let (text, unit) = (expression.excerpt(), self.unit_of(expression, dimension));
        let shown_itself = single_name(expression).is_some() || self.reaction_of(expression).is_some();
        let parts = if shown_itself { String::new() } else { self.parts(expression) };
        match unit.as_str() {
            "1" => format!("`{text}` is a pure number{parts}"),
            _ => format!("`{text}` is in [{unit}]{parts}"),
        }
    }

    /// The unit of an expression, the user's own where it has one.
    pub(super) fn unit_of(&self, expression: &Expression, dimension: &Dimension) -> String {
        self.own_unit(expression).unwrap_or_else(|| dimension.si_unit())
    }

    /// The unit that stands with a name or a number, of the rate of a name its own per time.
    pub(super) fn own_unit(&self, expression: &Expression) -> Option<String> {
        match &expression.kind {
            Kind::Number { unit, .. } => unit.as_ref().map(|unit| unit.text.clone()),
            Kind::Name(name) => match self.origins.get(&plain(name)) {
                Some(Origin::Declared(unit)) => unit.clone(),
                _ => None,
            },
            Kind::Negate(operand) => self.own_unit(operand),
            Kind::Call(function, arguments) if function == "dot" => {
                let unit = Unit::parse(&self.own_unit(arguments.first()?)?).ok()?;
                Some(unit.per_time(1).text().to_owned())
            }
            _ => None,
        }
    }

    /// The names that an expression is made of, with their units: " (m [kg], g [m/s^2])".
    pub(super) fn parts(&self, expression: &Expression) -> String {
        const SHOWN: usize = 6;
        let mut parts: Vec<String> = Vec::new();
        for part in expression.names().into_iter().filter_map(|name| self.with_unit(name)) {
            if !parts.contains(&part) {
                parts.push(part);
            }
        }
        let rest = if parts.len() > SHOWN { ", .." } else { "" };
        match parts.len() {
            0 => String::new(),
            all => format!(" ({}{rest})", parts[..all.min(SHOWN)].join(", ")),
        }
    }

    fn with_unit(&self, part: &Expression) -> Option<String> {
        let unit = match (&part.kind, self.own_unit(part)) {
            (_, Some(unit)) => unit,
            (Kind::Name(name), None) => match plain(name).as_str() {
                "t" => "s".to_owned(),
                name => self.value_named(name)?.dimension.as_ref()?.si_unit(),
            },
            _ => self.reaction_of(part)?.1.si_unit(),
        };
        Some(if unit == "1" { format!("{part} without a unit") } else { format!("{part} [{unit}]") })
    }

    fn value_named(&self, name: &str) -> Option<&Value> {
        let local = self.local.iter().find(|(word, _)| *word == name).map(|(_, value)| value);
        local.or_else(|| self.values.get(name))
    }

    /// The constraint whose reaction an expression is, apart from sign and component, and the dimension of that
    /// reaction.
    fn reaction_of<'e>(&self, expression: &'e Expression) -> Option<(&'e Ident, Dimension)> {
        match &expression.kind {
            Kind::Negate(operand) | Kind::Component(operand, _) => self.reaction_of(operand),
            Kind::Call(function, arguments) if function == "reaction" => {
                let constraint = single_name(arguments.first()?)?;
                let value = self.reactions.as_ref()?.get(&plain(constraint))?;
                Some((constraint, value.dimension.clone()?))
            }
            _ => None,
        }
    }

    /// The part of a pure number that lacks a unit, and what to write instead.
    fn lacking<'e>(
        &self,
        expression: &'e Expression,
        dimension: &Dimension,
        unit: String,
    ) -> Option<(&'e Expression, String)> {
        if !dimension.is_none() {
            return None;
        }
        if let Some((number, literal)) = bare_number(expression) {
            return Some((number, format!("; write `{literal} [{unit}]`")));
        }
        let name = single_name(expression)?;
        let is_bare = matches!(self.origins.get(&plain(name)), Some(Origin::Declared(None)));
        is_bare.then(|| (expression, format!("; declare it as `{name} [{unit}]`")))
    }
}

/// The first factor of a product of wrong dimension, if it is a number: its unit may be missing.
fn factor_without_unit<'e>(
    product: &'e Expression,
    needed: (&Dimension, &str),
    dimension: &Dimension,
) -> Option<(&'e Expression, String)> {
    match &product.kind {
        Kind::Negate(operand) => factor_without_unit(operand, needed, dimension),
        Kind::Binary(Operator::Multiply, ..) => {
            let (number, literal) = bare_number(product)?;
            let (needed, unit) = needed;
            let by = dimension.si_unit();
            let by = if by.contains(['*', '/']) { format!("({by})") } else { by };
            let in_that = Unit::parse(&format!("{unit}/{by}")).ok();
            let unit = match needed.is_none() && *dimension == Dimension::time() {
                true => "rad/s".to_owned(),
                false if unit == needed.si_unit() => needed.over(dimension).si_unit(),
                false => in_that.map_or_else(|| needed.over(dimension).si_unit(), |unit| unit.text().to_owned()),
            };
            Some((number, format!("; if a unit is missing, write `{literal} [{unit}]`")))
        }
        _ => None,
    }
}

/// The name that an expression consists of, apart from sign and component.
fn single_name(expression: &Expression) -> Option<&Ident> {
    match &expression.kind {
        Kind::Name(name) => Some(name),
        Kind::Negate(operand) | Kind::Component(operand, _) => single_name(operand),
        _ => None,
    }
}

/// The first number without a unit that determines the size of an expression: in `-9.81`, in `[0, 0.2]`, in
/// `0.1*sin(w*t)`.
pub(super) fn bare_number(expression: &Expression) -> Option<(&Expression, &str)> {
    match &expression.kind {
        Kind::Number { literal, unit: None } => {
            let is_zero = !literal.contains(|c| ('1'..='9').contains(&c));
            (!is_zero).then_some((expression, literal))
        }
        Kind::Negate(operand) | Kind::Component(operand, _) => bare_number(operand),
        Kind::Vector(components) => components.iter().find_map(bare_number),
        Kind::Binary(Operator::Multiply, left, _) => bare_number(left),
        Kind::Binary(Operator::Add | Operator::Subtract, left, right) => {
            bare_number(left).or_else(|| bare_number(right))
        }
        _ => None,
    }
}
