//! Expressions to values: names, operators and functions of the language.

use super::error::{OracleError, Result, refuse};
use super::jet::Jet;
use super::measured::Measured;
use super::value::{Value, inner};
use crate::dsl::{Declaration, Expression, Kind, Unit};
use syn::Ident;

/// What the names of a declaration stand for.
pub(super) struct Setting {
    /// In how many variables the jets are.
    variables: usize,
    /// The first of the declaration's parameters; later ones are not known.
    parameters: Vec<Jet>,
    /// The coordinates and the time; `None` where only parameters are known.
    motion: Option<(Vec<Jet>, Jet)>,
    /// Whether the first variable is time along the motion, so that `dot` has a meaning.
    along_time: bool,
    /// The multipliers of each constraint, where they are known.
    reactions: Option<Vec<Value>>,
}

impl Setting {
    /// Parameters alone.
    pub(super) fn fixed(parameters: &[f64]) -> Setting {
        let parameters = constants(parameters, 0);
        Setting { variables: 0, parameters, motion: None, along_time: false, reactions: None }
    }

    /// Positions: jets in the variables (q, t).
    pub(super) fn positions(time: f64, parameters: &[f64], coordinates: &[f64]) -> Setting {
        let variables = coordinates.len() + 1;
        let q = coordinates.iter().enumerate().map(|(i, q)| Jet::variable(*q, i, variables)).collect();
        Setting {
            variables,
            parameters: constants(parameters, variables),
            motion: Some((q, Jet::variable(time, variables - 1, variables))),
            along_time: false,
            reactions: None,
        }
    }

    /// Quantities along the motion: jets of `coordinates` as functions of time, the first of some variables.
    pub(super) fn motion(time: f64, parameters: &[f64], coordinates: Vec<Jet>, variables: usize) -> Setting {
        Setting {
            variables,
            parameters: constants(parameters, variables),
            motion: Some((coordinates, Jet::variable(time, 0, variables))),
            along_time: true,
            reactions: None,
        }
    }

    /// The same with the multipliers of each constraint, in order.
    pub(super) fn with_reactions(self, reactions: Vec<Value>) -> Setting {
        Setting { reactions: Some(reactions), ..self }
    }
}

fn constants(values: &[f64], variables: usize) -> Vec<Jet> {
    values.iter().map(|value| Jet::constant(Measured::given(*value), variables)).collect()
}

/// Evaluates the expressions of one declaration in one setting.
pub(super) struct Interpreter<'d> {
    declaration: &'d Declaration,
    si_factor: &'d dyn Fn(&Unit) -> f64,
    setting: Setting,
    /// What each `let` named, once it was needed.
    definitions: Vec<Option<Value>>,
    /// Words that have a meaning in one expression alone.
    local: Vec<(&'static str, Jet)>,
    /// How many of the `let`s can be seen: a `let` sees only those above it.
    visible: usize,
}

impl<'d> Interpreter<'d> {
    pub(super) fn new(
        declaration: &'d Declaration,
        si_factor: &'d dyn Fn(&Unit) -> f64,
        setting: Setting,
    ) -> Interpreter<'d> {
        let visible = declaration.lets.len();
        Interpreter { declaration, si_factor, setting, definitions: vec![None; visible], local: vec![], visible }
    }

    pub(super) fn scalar(&mut self, expression: &Expression) -> Result<Jet> {
        self.value(expression)?.scalar()
    }

    pub(super) fn vector(&mut self, expression: &Expression) -> Result<[Jet; 2]> {
        self.value(expression)?.vector()
    }

    pub(super) fn value(&mut self, expression: &Expression) -> Result<Value> {
        match &expression.kind {
            Kind::Number { literal, unit } => self.number(literal, unit.as_ref()),
            Kind::Name(name) => self.named(name),
            Kind::Vector(components) => self.components(components),
            Kind::Negate(operand) => Ok(self.value(operand)?.negate()),
            Kind::Binary(operator, left, right) => self.value(left)?.combine(*operator, self.value(right)?),
            Kind::Call(function, arguments) => self.call(function, arguments),
            Kind::Component(vector, name) => self.value(vector)?.component(&name.to_string()),
        }
    }

    fn number(&self, literal: &str, unit: Option<&Unit>) -> Result<Value> {
        let number: f64 = literal.parse().map_err(|_| OracleError::new(format!("`{literal}` is not a number")))?;
        Ok(self.constant(number * unit.map_or(1.0, self.si_factor)))
    }

    fn constant(&self, value: f64) -> Value {
        Value::Scalar(Jet::constant(Measured::given(value), self.setting.variables))
    }

    fn components(&mut self, components: &[Expression]) -> Result<Value> {
        match components {
            [x, y] => Ok(Value::Vector([self.scalar(x)?, self.scalar(y)?])),
            _ => refuse("a vector of the plane has two components"),
        }
    }

    /// A scalar in which some words have a meaning of their own.
    pub(super) fn scalar_with(&mut self, expression: &Expression, words: Vec<(&'static str, Jet)>) -> Result<Jet> {
        self.local = words;
        let value = self.scalar(expression);
        self.local.clear();
        value
    }

    /// Coordinate number `index`.
    pub(super) fn coordinate_jet(&self, index: usize) -> Result<Jet> {
        let known = self.setting.motion.as_ref().and_then(|(coordinates, _)| coordinates.get(index));
        known.cloned().ok_or_else(|| OracleError::new("coordinates are not known here"))
    }

    /// What a name stands for.
    pub(super) fn named(&mut self, name: &Ident) -> Result<Value> {
        let declaration = self.declaration;
        if let Some((_, value)) = self.local.iter().find(|(word, _)| name == word) {
            return Ok(Value::Scalar(value.clone()));
        }
        if let Some(index) = declaration.coordinates.iter().position(|c| c.name == *name) {
            return self.coordinate(index, name);
        }
        if let Some(index) = declaration.parameters.iter().position(|p| p.name == *name) {
            let known = self.setting.parameters.get(index).cloned();
            return known.map(Value::Scalar).ok_or_else(|| OracleError::new(format!("`{name}` is declared later")));
        }
        if let Some(index) = declaration.lets[..self.visible].iter().position(|l| l.name == *name) {
            return self.defined(index);
        }
        self.reserved(name)
    }

    fn coordinate(&self, index: usize, name: &Ident) -> Result<Value> {
        let varies = |_| OracleError::new(format!("`{name}` varies; only parameters may stand here"));
        self.coordinate_jet(index).map(Value::Scalar).map_err(varies)
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
        match (name.as_str(), arguments) {
            ("dot", [x]) => self.dot(x),
            ("ddot", [x]) => self.dot(x)?.dot(),
            ("reaction", [constraint]) => self.reaction(constraint),
            ("norm", [v]) => {
                let v = self.vector(v)?;
                known(inner(&v, &v).call("sqrt"), &name)
            }
            ("inner", [a, b]) => Ok(Value::Scalar(inner(&self.vector(a)?, &self.vector(b)?))),
            ("atan2", [y, x]) => Ok(Value::Scalar(self.scalar(y)?.atan2(&self.scalar(x)?))),
            (_, [x]) => known(self.scalar(x)?.call(&name), &name),
            _ => refuse(format!("`{name}` is no function of {} arguments", arguments.len())),
        }
    }

    fn dot(&mut self, x: &Expression) -> Result<Value> {
        if !self.setting.along_time {
            return refuse("a position or a constraint has no time derivatives in it");
        }
        self.value(x)?.dot()
    }

    fn reaction(&self, constraint: &Expression) -> Result<Value> {
        let Kind::Name(name) = &constraint.kind else { return refuse("`reaction` is of a constraint, by its name") };
        let Some(reactions) = &self.setting.reactions else { return refuse("reactions are not known here") };
        let index = self.declaration.constraints.iter().position(|c| c.name == *name);
        let reaction = index.and_then(|index| reactions.get(index)).cloned();
        reaction.ok_or_else(|| OracleError::new(format!("`{name}` is not a constraint")))
    }
}

fn known(result: Option<Jet>, function: &str) -> Result<Value> {
    result.map(Value::Scalar).ok_or_else(|| OracleError::new(format!("`{function}` is not a function")))
}
