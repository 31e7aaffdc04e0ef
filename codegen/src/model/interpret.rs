//! Expressions of the language to symbolic values.

use super::homogeneity::Measured;
use super::origin::Origins;
use super::scope::{self, Names, Values, plain};
use super::space::{Frames, Quaternion, Spatial};
use super::tables;
use super::value::{Shape, Value};
use super::{Dependence, Dependences, Dimension, Point, Unit};
use crate::dsl::{Expression, Kind, Region};
use crate::mistakes::Mistakes;
use crate::symbolic::{Constant, Differential, Expr, Graph, Number, evaluate};
use syn::Ident;

/// Turns expressions into values. `None` means a mistake that has been taken note of.
pub(super) struct Interpreter {
    pub(super) graph: Graph,
    pub(super) dependences: Dependences,
    pub(super) values: Values,
    pub(super) tables: Names<tables::Function>,
    pub(super) origins: Origins,
    /// Whether dimensions are looked at: they are unless no unit is declared anywhere.
    pub(super) with_units: bool,
    /// Reserved names that something is called nevertheless: its uses are no mistakes too.
    pub(super) misnamed: Vec<String>,
    /// Words that have a meaning in one expression alone.
    pub(super) local: Vec<(&'static str, Value)>,
    /// The multipliers of each constraint; absent until constraints are resolved.
    pub(super) reactions: Option<Names<Value>>,
    /// Names of the outputs, which are no values.
    pub(super) outputs: Vec<String>,
    pub(super) time: Expr,
    pub(super) motion: Differential,
    pub(super) mistakes: Mistakes,
    /// All rotations.
    pub(super) frames: Frames,
    /// Those quaternions whose components are coordinates.
    pub(super) quaternions: Vec<Quaternion>,
    /// How many components the first vector has, and where it stands: all others have as many.
    pub(super) vectors: Option<(usize, Region)>,
}

impl Interpreter {
    /// A mistake at a place.
    pub(super) fn refuse<T>(&mut self, region: Region, message: impl std::fmt::Display) -> Option<T> {
        self.mistakes.add(region.error(message));
        None
    }

    /// A scalar.
    pub(super) fn scalar(&mut self, expression: &Expression) -> Option<Expr> {
        self.scalar_value(expression).map(|(value, _)| value)
    }

    pub(super) fn scalar_value(&mut self, expression: &Expression) -> Option<(Expr, Option<Dimension>)> {
        let value = self.value(expression)?;
        match value.shape {
            Shape::Scalar(scalar) => Some((scalar, value.dimension)),
            Shape::Vector(_) | Shape::Spatial(_) => self.refuse(
                expression.region,
                "a vector stands where a scalar belongs; take a component (`.x`, `.y`) or `norm(..)`",
            ),
            Shape::Rotation(_) => self.refuse(expression.region, "a rotation stands where a scalar belongs"),
        }
    }

    /// A vector by its components in the world.
    pub(super) fn point_value(&mut self, expression: &Expression) -> Option<(Point, Option<Dimension>)> {
        let value = self.vector_value(expression)?;
        self.expect_world(expression.region, &value.bases)?;
        Some((self.components(&value), value.dimension))
    }

    /// A vector of the plane or of space.
    pub(super) fn vector_value(&mut self, expression: &Expression) -> Option<Value> {
        let value = self.value(expression)?;
        match value.shape {
            Shape::Vector(_) | Shape::Spatial(_) => Some(value),
            Shape::Scalar(_) => {
                let form = if self.is_spatial() { "[x, y, z]" } else { "[x, y]" };
                self.refuse(
                    expression.region,
                    format!("a scalar stands where a vector belongs; a vector is written `{form}`"),
                )
            }
            Shape::Rotation(_) => {
                self.refuse(expression.region, "a rotation stands where a vector belongs; `R*[x, y, z]` turns one")
            }
        }
    }

    /// A vector of space, and what else is known of it.
    pub(super) fn spatial_value(&mut self, expression: &Expression) -> Option<(Spatial, Value)> {
        let value = self.vector_value(expression)?;
        match &value.shape {
            Shape::Spatial(vector) => Some((vector.clone(), value)),
            _ => self.refuse(expression.region, "a vector of the plane stands where one of space belongs, `[x, y, z]`"),
        }
    }

    /// Whether vectors have three components.
    pub(super) fn is_spatial(&self) -> bool {
        self.vectors.is_some_and(|(components, _)| components == 3)
    }

    /// The components of a value: of a vector those in the world, of a rotation those of its matrix.
    pub(super) fn components(&mut self, value: &Value) -> Vec<Expr> {
        match &value.shape {
            Shape::Scalar(scalar) => vec![*scalar],
            Shape::Vector(components) => components.to_vec(),
            Shape::Spatial(vector) => self.resolved(vector).to_vec(),
            Shape::Rotation(turn) => self.frames.matrix(*turn).concat(),
        }
    }

    /// Refuses an expression that depends on what it must not depend on here; `rule` says why.
    pub(super) fn restrict(&mut self, place: Region, values: &[Expr], forbidden: Dependence, rule: &str) -> Option<()> {
        for value in values {
            if self.dependences.of(&self.graph, *value).meets(forbidden) {
                return self.refuse(place, rule);
            }
        }
        Some(())
    }

    /// Any value.
    pub(super) fn value(&mut self, expression: &Expression) -> Option<Value> {
        let region = expression.region;
        let mut value = match &expression.kind {
            Kind::Number { literal, unit } => self.number(region, literal, unit.as_ref()),
            Kind::Name(name) => self.name(name),
            Kind::Vector(components) => self.vector(region, components),
            Kind::Negate(operand) => {
                let value = self.value(operand)?;
                Some(value.map(|x| self.graph.neg(x)))
            }
            Kind::Binary(operator, left, right) => self.binary(*operator, left, right),
            Kind::Call(function, arguments) => self.call(region, function, arguments),
            Kind::Component(vector, name) => self.component(vector, name),
            Kind::If(choice) => self.choice(choice),
            Kind::Attitude(body, rotation) => self.attitude(body, rotation),
        }?;
        let components = self.components(&value);
        self.check_constants(region, &components)?;
        value.dimension = value.dimension.filter(|_| self.with_units);
        Some(value)
    }

    /// Refuses constants that are no real numbers, such as `sqrt(-1)`, and coefficients beyond the range of `f64`.
    pub(super) fn check_constants(&mut self, region: Region, values: &[Expr]) -> Option<()> {
        for value in values {
            let constant = self.dependences.of(&self.graph, *value) == Dependence::NONE;
            if constant && !evaluate(&self.graph, &[*value], |_| f64::NAN)[0].is_finite() {
                return self.refuse(region, "this is not a finite real number");
            }
            if !self.graph.numbers_in_range(*value) {
                return self
                    .refuse(region, "a coefficient here is outside the range of numbers (about 1e-308 to 1e308)");
            }
        }
        Some(())
    }

    fn number(&mut self, region: Region, literal: &str, unit: Option<&crate::dsl::Unit>) -> Option<Value> {
        let Some(number) = Number::parse_decimal(literal) else {
            return self.refuse(region, format!("`{literal}` is outside the range of numbers (about 1e-308 to 1e308)"));
        };
        let zero = number.is_zero();
        let value = self.graph.number(number);
        let Some(unit) = unit else {
            return Some(Value::scalar(value, (!zero).then(Dimension::none)));
        };
        let unit = self.mistakes.note(Unit::resolve(unit))?;
        let factor = unit.factor_expression(&mut self.graph);
        Some(Value::scalar(self.graph.mul(value, factor), Some(unit.dimension().clone())))
    }

    fn name(&mut self, name: &Ident) -> Option<Value> {
        let text = plain(name);
        if self.misnamed.contains(&text) {
            return None;
        }
        match text.as_str() {
            "pi" => return Some(Value::scalar(self.graph.constant(Constant::Pi), Some(Dimension::none()))),
            "e" => return Some(Value::scalar(self.graph.constant(Constant::E), Some(Dimension::none()))),
            "t" => return Some(Value::scalar(self.time, Some(Dimension::time()))),
            _ => {}
        }
        if let Some((_, value)) = self.local.iter().find(|(word, _)| *word == text) {
            return Some(value.clone());
        }
        let is_hidden = self.values.get_region(&text).is_some();
        if !is_hidden && scope::functions().any(|function| function == text) {
            return self.refuse(name.into(), format!("`{text}` is a function; call it: `{text}(..)`"));
        }
        if self.tables.get_region(&text).is_some() {
            return self.refuse(name.into(), format!("`{text}` is a table; it takes an argument: `{text}(x)`"));
        }
        if self.values.get_region(&text).is_none() {
            if let Some((rate, coordinate)) = self.rate_of_coordinate(&text) {
                return self
                    .refuse(name.into(), format!("the rate of `{coordinate}` is written `{rate}({coordinate})` here"));
            }
            if self.outputs.contains(&text) {
                let message =
                    format!("`{text}` is an output; to use it here too, name its expression: `let {text} = ..;`");
                return self.refuse(name.into(), message);
            }
        }
        self.values.find(name, &mut self.mistakes)
    }

    /// `dot` and `x` for `x_dot`.
    fn rate_of_coordinate<'t>(&self, text: &'t str) -> Option<(&'static str, &'t str)> {
        let (rate, base) = match (text.strip_suffix("_ddot"), text.strip_suffix("_dot")) {
            (Some(base), _) => ("ddot", base),
            (None, base) => ("dot", base?),
        };
        self.values.get_region(base).map(|_| (rate, base))
    }

    fn vector(&mut self, region: Region, components: &[Expression]) -> Option<Value> {
        let values: Vec<_> = components.iter().map(|c| self.scalar_value(c)).collect();
        if ![2, 3].contains(&values.len()) {
            let message = match values.len() {
                6 => "six numbers in brackets are an inertia; a vector has two components in the plane, `[x, y]`, and \
                      three in space, `[x, y, z]`"
                    .to_owned(),
                given => format!(
                    "a vector of the plane has two components, `[x, y]`, and one of space three, `[x, y, z]`; this has {given}"
                ),
            };
            return self.refuse(region, message);
        }
        self.check_length(region, values.len())?;
        let mut entries = Vec::new();
        let (first, mut dimension) = (&components[0], None);
        for (component, value) in components.iter().zip(values) {
            let (value, own) = value?;
            let (a, b) = (
                Measured { expression: first, dimension: &dimension },
                Measured { expression: component, dimension: &own },
            );
            let rule = match components.len() {
                2 => "both components of a vector are of one dimension",
                _ => "all components of a vector are of one dimension",
            };
            dimension = self.common_dimension(a, b, rule)?;
            entries.push(value);
        }
        let shape = match entries.as_slice() {
            [x, y] => Shape::Vector([*x, *y]),
            [x, y, z] => Shape::Spatial(Spatial::world([*x, *y, *z])),
            _ => return None,
        };
        Some(Value::new(shape, dimension))
    }

    /// Refuses a vector with more or fewer components than those before it.
    fn check_length(&mut self, region: Region, components: usize) -> Option<()> {
        let (known, first) = *self.vectors.get_or_insert((components, region));
        if components == 3 {
            self.frames.begin(&mut self.graph);
        }
        if known == components {
            return Some(());
        }
        let message = match known {
            2 => {
                "this vector has three components, and the mechanism is planar, as its first vector says; write `[x, y]`, \
                  or three components everywhere"
            }
            _ => {
                "this vector has two components, and the mechanism is spatial, as its first vector says; write `[x, y, 0]`, \
                  or two components everywhere"
            }
        };
        let mut mistake = region.error(message);
        mistake.combine(first.error("the first vector stands here"));
        self.mistakes.add(mistake);
        None
    }

    fn component(&mut self, vector: &Expression, name: &Ident) -> Option<Value> {
        let value = self.value(vector)?;
        if let Shape::Scalar(_) | Shape::Rotation(_) = value.shape {
            return self.refuse(name.into(), format!("{} has no component `.{name}`", value.kind()));
        }
        let components = self.components(&value);
        let place = ["x", "y", "z"].iter().position(|axis| plain(name) == *axis);
        match place.and_then(|place| components.get(place)) {
            Some(component) => Some(Value::scalar(*component, value.dimension)),
            None if components.len() == 2 => self
                .refuse(name.into(), format!("a vector of the plane has the components `.x` and `.y`, not `.{name}`")),
            None => self.refuse(
                name.into(),
                format!("a vector of space has the components `.x`, `.y` and `.z`, not `.{name}`"),
            ),
        }
    }
}
