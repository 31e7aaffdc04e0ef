//! Expressions to values: names, operators and functions of the language.

mod rotations;
mod rows;

use super::error::{OracleError, Result, refuse};
use super::jet::Jet;
use super::measured::Measured;
use super::names::{Meaning, Names};
use super::plain::is_plain;
use super::rotation::Rotation;
use super::setting::{Rates, Setting};
use super::value::{Value, cross, inner};
use crate::dsl::{Choice, Comparison, Declaration, Equation, Expression, Kind, Operator, Unit};
use std::sync::Arc;
use syn::Ident;

/// Evaluates the expressions of one declaration in one setting.
pub(super) struct Interpreter<'d> {
    declaration: &'d Declaration,
    si_factor: &'d dyn Fn(&Unit) -> f64,
    names: Arc<Names>,
    setting: Setting,
    /// The value of each `let`, once evaluated.
    definitions: Vec<Option<Value>>,
    /// Words that have a meaning in one expression alone.
    local: Vec<(&'static str, Jet)>,
    /// The number of visible `let`s: a `let` sees only those above it.
    visible: usize,
}

impl<'d> Interpreter<'d> {
    pub(super) fn new(
        declaration: &'d Declaration,
        si_factor: &'d dyn Fn(&Unit) -> f64,
        setting: Setting,
    ) -> Interpreter<'d> {
        Interpreter::with_names(declaration, si_factor, Arc::new(Names::of(declaration)), setting)
    }

    /// The same with the names of the declaration known, which saves most of the time at a single state.
    pub(super) fn with_names(
        declaration: &'d Declaration,
        si_factor: &'d dyn Fn(&Unit) -> f64,
        names: Arc<Names>,
        setting: Setting,
    ) -> Interpreter<'d> {
        let visible = declaration.lets.len();
        let definitions = vec![None; visible];
        Interpreter { declaration, si_factor, names, setting, definitions, local: vec![], visible }
    }

    pub(super) fn scalar(&mut self, expression: &Expression) -> Result<Jet> {
        self.value(expression)?.scalar()
    }

    pub(super) fn vector(&mut self, expression: &Expression) -> Result<Vec<Jet>> {
        self.value(expression)?.vector()
    }

    pub(super) fn rotation(&mut self, expression: &Expression) -> Result<Rotation> {
        self.value(expression)?.rotation()
    }

    pub(super) fn value(&mut self, expression: &Expression) -> Result<Value> {
        match &expression.kind {
            Kind::Number { literal, unit } => self.number(literal, unit.as_ref()),
            Kind::Name(name) => self.named(name),
            Kind::Vector(components) => self.components(components),
            Kind::Negate(operand) => Ok(self.value(operand)?.negate()),
            Kind::Binary(operator, left, right) => self.value(left)?.combine(*operator, self.value(right)?),
            Kind::Call(function, arguments) => self.call(function, arguments),
            Kind::If(choice) => self.choice(choice),
            Kind::Attitude(_, rotation) => self.value(rotation),
            Kind::Component(vector, name) => self.value(vector)?.component(&name.to_string()),
        }
    }

    /// left - right.
    pub(super) fn difference(&mut self, equation: &Equation) -> Result<Value> {
        let left = self.value(&equation.left)?;
        left.combine(Operator::Subtract, self.value(&equation.right)?)
    }

    fn number(&self, literal: &str, unit: Option<&Unit>) -> Result<Value> {
        let number: f64 = literal.parse().map_err(|_| OracleError::new(format!("`{literal}` is not a number")))?;
        Ok(self.constant(number * unit.map_or(1.0, self.si_factor)))
    }

    fn constant(&self, value: f64) -> Value {
        Value::Scalar(Jet::constant(Measured::given(value), self.setting.variables))
    }

    fn components(&mut self, components: &[Expression]) -> Result<Value> {
        match components.len() {
            2 | 3 => components.iter().map(|x| self.scalar(x)).collect::<Result<_>>().map(Value::Vector),
            _ => refuse("a vector has two or three components"),
        }
    }

    /// A scalar in which some words have a meaning of their own.
    pub(super) fn scalar_with(&mut self, expression: &Expression, words: Vec<(&'static str, Jet)>) -> Result<Jet> {
        self.local = words;
        let value = self.scalar(expression);
        self.local.clear();
        value
    }

    /// Everything that moves: coordinates, and auxiliary displacements where they are variables.
    pub(super) fn moving(&self) -> Vec<Jet> {
        let coordinates = self.setting.motion.iter().flat_map(|(coordinates, _)| coordinates);
        coordinates.chain(&self.setting.auxiliaries).cloned().collect()
    }

    fn coordinate_jet(&self, index: usize) -> Result<Jet> {
        let known = self.setting.motion.as_ref().and_then(|(coordinates, _)| coordinates.get(index));
        known.cloned().ok_or_else(|| OracleError::new("coordinates are not known here"))
    }

    /// The value of a name.
    pub(super) fn named(&mut self, name: &Ident) -> Result<Value> {
        if let Some((_, value)) = self.local.iter().find(|(word, _)| name == word) {
            return Ok(Value::Scalar(value.clone()));
        }
        match self.names.meaning(name) {
            Some(Meaning::Coordinate(index)) => self.coordinate(index, name),
            Some(Meaning::Parameter(index)) => {
                let known = self.setting.parameters.get(index).cloned();
                known.map(Value::Scalar).ok_or_else(|| OracleError::new(format!("`{name}` is declared later")))
            }
            Some(Meaning::Input(index)) => self.input(index),
            Some(Meaning::Auxiliary(index)) => {
                let variable = self.setting.auxiliaries.get(index).cloned();
                Ok(variable.map_or_else(|| self.constant(0.0), Value::Scalar))
            }
            Some(Meaning::Let(index)) if index < self.visible => self.defined(index),
            _ => self.reserved(name),
        }
    }

    /// A coordinate, by its name.
    pub(super) fn coordinate_named(&mut self, name: &Ident) -> Result<Jet> {
        match self.declaration.coordinates.iter().position(|c| c.name == *name) {
            Some(index) => self.coordinate(index, name)?.scalar(),
            None => refuse(format!("`{name}` is not a coordinate")),
        }
    }

    fn coordinate(&self, index: usize, name: &Ident) -> Result<Value> {
        let varies = |_| OracleError::new(format!("`{name}` varies; only parameters may stand here"));
        self.coordinate_jet(index).map(Value::Scalar).map_err(varies)
    }

    /// The value that an input is set to, or its declared course, with plain numbers in its unit.
    fn input(&mut self, index: usize) -> Result<Value> {
        let input = &self.declaration.inputs[index];
        match self.setting.inputs.as_ref().and_then(|inputs| inputs.get(index)) {
            Some(Some(value)) => Ok(self.constant(*value)),
            Some(None) => {
                let course = self.scalar(&input.value)?;
                let unit = input.unit.as_ref().filter(|_| is_plain(&input.value));
                let size = self.constant(unit.map_or(1.0, self.si_factor)).scalar()?;
                Ok(Value::Scalar(&course * &size))
            }
            None => refuse(format!("input `{}` cannot stand here", input.name)),
        }
    }

    fn defined(&mut self, index: usize) -> Result<Value> {
        if let Some(Some(value)) = self.definitions.get(index) {
            return Ok(value.clone());
        }
        let visible = std::mem::replace(&mut self.visible, index);
        let value = self.value(&self.declaration.lets[index].value);
        self.visible = visible;
        let value = value?;
        self.definitions[index] = Some(value.clone());
        Ok(value)
    }

    fn reserved(&self, name: &Ident) -> Result<Value> {
        match name.to_string().as_str() {
            "pi" => Ok(self.constant(std::f64::consts::PI)),
            "e" => Ok(self.constant(std::f64::consts::E)),
            "t" => match &self.setting.motion {
                Some((_, time)) => Ok(Value::Scalar(time.clone())),
                None => refuse("`t` varies; only parameters may stand here"),
            },
            _ => refuse(format!("`{name}` is not known here")),
        }
    }

    fn call(&mut self, function: &Ident, arguments: &[Expression]) -> Result<Value> {
        let name = function.to_string();
        if let Some(index) = self.declaration.tables.iter().position(|table| table.name == *function) {
            return self.look_up(index, arguments);
        }
        match (name.as_str(), arguments) {
            ("dot", [x]) => self.dot(x),
            ("ddot", [x]) => {
                let rate = self.dot(x)?;
                self.rate(&rate)
            }
            ("reaction", [constraint]) => self.reaction(constraint),
            ("norm", [v]) => {
                let v = self.vector(v)?;
                known(inner(&v, &v)?.call("sqrt"), &name)
            }
            ("inner", [a, b]) => inner(&self.vector(a)?, &self.vector(b)?).map(Value::Scalar),
            ("cross", [a, b]) => cross(&self.vector(a)?, &self.vector(b)?).map(Value::Vector),
            ("rotation", [axis, angle]) => self.about(axis, angle),
            ("euler", [sequence, angles @ ..]) => self.euler(sequence, angles),
            ("quaternion", [a, b, c, d]) => self.quaternion([a, b, c, d]),
            ("axes", [u, v, w]) => self.axes([u, v, w]),
            ("transpose", [rotation]) => Ok(Value::Rotation(self.rotation(rotation)?.transposed())),
            ("angular_velocity", [rotation]) => {
                let rotation = self.rotation(rotation)?;
                let rates = self.rate(&Value::Vector(rotation.entries.clone()))?.components();
                Ok(Value::Vector(rotation.angular_velocity(&rates)))
            }
            ("atan2", [y, x]) => Ok(Value::Scalar(self.scalar(y)?.atan2(&self.scalar(x)?))),
            ("min", _) => self.extreme(arguments, |value, least| value < least),
            ("max", _) => self.extreme(arguments, |value, most| value > most),
            (_, [x]) => known(self.scalar(x)?.call(&name), &name),
            _ => refuse(format!("`{name}` is no function of {} arguments", arguments.len())),
        }
    }

    /// Only what is chosen is evaluated.
    fn choice(&mut self, choice: &Choice) -> Result<Value> {
        let (left, right) = (self.scalar(&choice.left)?.value().value, self.scalar(&choice.right)?.value().value);
        if left.is_nan() || right.is_nan() {
            return Ok(self.value(&choice.yes)?.multiplied(f64::NAN));
        }
        let holds = match choice.comparison {
            Comparison::Less => left < right,
            Comparison::AtMost => left <= right,
            Comparison::Greater => left > right,
            Comparison::AtLeast => left >= right,
        };
        self.value(if holds { &choice.yes } else { &choice.no })
    }

    /// The first of the extreme values.
    fn extreme(&mut self, values: &[Expression], is_beyond: fn(f64, f64) -> bool) -> Result<Value> {
        let mut extreme: Option<Jet> = None;
        for value in values {
            let value = self.scalar(value)?;
            let replaces = extreme.as_ref().is_none_or(|so_far| {
                let (value, so_far) = (value.value().value, so_far.value().value);
                is_beyond(value, so_far) || value.is_nan()
            });
            if replaces {
                extreme = Some(value);
            }
        }
        extreme.map(Value::Scalar).ok_or_else(|| OracleError::new("the extreme of nothing"))
    }

    fn dot(&mut self, x: &Expression) -> Result<Value> {
        let value = self.value(x)?;
        self.rate(&value)
    }

    fn rate(&self, value: &Value) -> Result<Value> {
        match &self.setting.rates {
            Rates::None => refuse("a position has no time derivatives in it"),
            Rates::AlongTime => value.rate(Jet::dot),
            Rates::Of(rates) => value.rate(|jet| jet.rate(rates)),
        }
    }

    fn reaction(&self, constraint: &Expression) -> Result<Value> {
        let Kind::Name(name) = &constraint.kind else { return refuse("`reaction` is of a constraint, by its name") };
        let Some(reactions) = &self.setting.reactions else { return refuse("reactions are not known here") };
        let constraints = self.declaration.constraints.iter().map(|c| &c.name);
        let index = constraints.chain(self.declaration.auxiliary.iter().map(|a| &a.name)).position(|n| n == name);
        let reaction = index.and_then(|index| reactions.get(index)).cloned();
        reaction
            .ok_or_else(|| OracleError::new(format!("`{name}` is neither a constraint nor an auxiliary displacement")))
    }
}

fn known(result: Option<Jet>, function: &str) -> Result<Value> {
    result.map(Value::Scalar).ok_or_else(|| OracleError::new(format!("`{function}` is not a function")))
}
