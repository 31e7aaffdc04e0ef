//! Expressions of the language to symbolic values.

use super::homogeneity::Measured;
use super::origin::Origins;
use super::scope::{self, Names, Values, plain};
use super::space::{Frames, Quaternion, Spatial, triple};
use super::tables;
use super::value::{Shape, Value};
use super::{Dependence, Dependences, Dimension, Point, Unit};
use crate::dsl::{Expression, Kind, Operator, Region};
use crate::mistakes::Mistakes;
use crate::nearest;
use crate::symbolic::{Constant, Differential, Expr, Function, Graph, Number, evaluate};
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

    /// A vector of space.
    pub(super) fn spatial_value(&mut self, expression: &Expression) -> Option<(Spatial, Option<Dimension>)> {
        let value = self.vector_value(expression)?;
        match value.shape {
            Shape::Spatial(vector) => Some((vector, value.dimension)),
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
        Some(Value { shape, dimension })
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

    fn binary(&mut self, operator: Operator, left: &Expression, right: &Expression) -> Option<Value> {
        let (a, b) = (self.value(left), self.value(right));
        let (a, b) = (a?, b?);
        match operator {
            Operator::Add | Operator::Subtract => self.sum(operator, left, right, a, b),
            Operator::Multiply => match a.shape {
                Shape::Rotation(turn) => self.turned(right.region, turn, b),
                _ => self.multiply(left, right, a, b),
            },
            Operator::Divide => self.divide(right, a, b),
            Operator::Power => self.power(left, right, a, b),
        }
    }

    fn sum(&mut self, operator: Operator, left: &Expression, right: &Expression, a: Value, b: Value) -> Option<Value> {
        let (operation, rule): (fn(&mut Graph, Expr, Expr) -> Expr, _) = match operator {
            Operator::Subtract => (Graph::sub, "only quantities of one dimension can be subtracted"),
            _ => (Graph::add, "only quantities of one dimension can be added"),
        };
        let shape = match (&a.shape, &b.shape) {
            (Shape::Scalar(a), Shape::Scalar(b)) => Shape::Scalar(operation(&mut self.graph, *a, *b)),
            (Shape::Vector([ax, ay]), Shape::Vector([bx, by])) => {
                Shape::Vector([operation(&mut self.graph, *ax, *bx), operation(&mut self.graph, *ay, *by)])
            }
            (Shape::Spatial(a), Shape::Spatial(b)) => Shape::Spatial(a.combine(b, &mut self.graph, operation)),
            _ => {
                let (a, b) = (a.kind(), b.kind());
                let message = format!(
                    "{a} and {b} cannot be added or subtracted; take a component (`.x`, `.y`) or build a vector `[x, y]`"
                );
                return self.refuse(left.region.to(right.region), message);
            }
        };
        let (left, right) = (a.measured(left), b.measured(right));
        Some(Value { shape, dimension: self.common_dimension(left, right, rule)? })
    }

    fn multiply(&mut self, left: &Expression, right: &Expression, a: Value, b: Value) -> Option<Value> {
        let dimension = a.dimension.as_ref().zip(b.dimension.as_ref()).map(|(a, b)| a.times(b));
        if let Shape::Rotation(_) = b.shape {
            let message =
                "a rotation stands left of what it turns: `R*v`, and `transpose(R)*v` for the other way round";
            return self.refuse(left.region.to(right.region), message);
        }
        let (scalar, other) = match (&a.shape, &b.shape) {
            (Shape::Scalar(scalar), _) => (*scalar, b),
            (_, Shape::Scalar(scalar)) => (*scalar, a),
            (Shape::Spatial(_), Shape::Spatial(_)) => {
                return self.refuse(
                    left.region.to(right.region),
                    "two vectors cannot be multiplied with `*`; the scalar product is `inner(a, b)`, the vector product \
                     `cross(a, b)`",
                );
            }
            _ => {
                return self.refuse(
                    left.region.to(right.region),
                    "two vectors cannot be multiplied with `*`; the scalar product is `inner(a, b)`",
                );
            }
        };
        let product = other.map(|x| self.graph.mul(scalar, x));
        Some(Value { dimension, ..product })
    }

    fn divide(&mut self, right: &Expression, a: Value, b: Value) -> Option<Value> {
        let dimension = a.dimension.as_ref().zip(b.dimension.as_ref()).map(|(a, b)| a.over(b));
        if let Shape::Rotation(_) = a.shape {
            return self.refuse(right.region, "a rotation cannot be divided; its inverse is `transpose(R)`");
        }
        let Shape::Scalar(divisor) = b.shape else {
            return self.refuse(right.region, "a vector cannot divide; divide by `norm(..)` or by a component");
        };
        if self.graph.is_zero(divisor) {
            return self.refuse(right.region, "division by zero");
        }
        let quotient = a.map(|x| self.graph.div(x, divisor));
        Some(Value { dimension, ..quotient })
    }

    fn power(&mut self, left: &Expression, right: &Expression, a: Value, b: Value) -> Option<Value> {
        let Shape::Scalar(base) = a.shape else {
            return self.refuse(
                left.region,
                "a vector cannot be raised to a power; the square of its length is `inner(a, a)`",
            );
        };
        let Shape::Scalar(exponent) = b.shape else {
            return self.refuse(right.region, "an exponent is a scalar");
        };
        let dimension = self.dimension_of_power(a.measured(left), exponent, b.measured(right))?;
        Some(Value::scalar(self.graph.power(base, exponent), dimension))
    }

    fn call(&mut self, region: Region, name: &Ident, arguments: &[Expression]) -> Option<Value> {
        let text = plain(name);
        if let Some(function) = Function::ALL.into_iter().find(|f| f.name() == text) {
            let [argument] = self.arguments(region, &text, arguments, ["x"])?;
            let (x, dimension) = self.scalar_value(argument)?;
            let dimension = match function {
                Function::Abs => dimension,
                Function::Sign => Some(Dimension::none()),
                _ => {
                    self.expect_pure(&text, Measured { expression: argument, dimension: &dimension })?;
                    Some(Dimension::none())
                }
            };
            return Some(Value::scalar(self.graph.call(function, x), dimension));
        }
        if self.tables.get_region(&text).is_some() {
            return self.look_up(region, name, arguments);
        }
        match text.as_str() {
            "sqrt" => {
                let [argument] = self.arguments(region, &text, arguments, ["x"])?;
                let (x, dimension) = self.scalar_value(argument)?;
                let root = self.graph.sqrt(x);
                Some(Value::scalar(root, dimension.zip(Number::fraction(1, 2)).map(|(d, half)| d.to_the(&half))))
            }
            "atan2" => {
                let [y, x] = self.arguments(region, &text, arguments, ["y", "x"])?;
                let (of_y, of_x) = (self.scalar_value(y), self.scalar_value(x));
                let ((of_y, dy), (of_x, dx)) = (of_y?, of_x?);
                let (y, x) = (Measured { expression: y, dimension: &dy }, Measured { expression: x, dimension: &dx });
                self.common_dimension(y, x, "`atan2(y, x)` takes two of one dimension")?;
                Some(Value::scalar(self.graph.atan2(of_y, of_x), Some(Dimension::none())))
            }
            "min" => self.extreme(region, &text, arguments, Graph::min),
            "max" => self.extreme(region, &text, arguments, Graph::max),
            "norm" => {
                let [a] = self.arguments(region, &text, arguments, ["a"])?;
                let a = self.vector_value(a)?;
                let square = self.inner(&a, &a);
                Some(Value::scalar(self.graph.sqrt(square), a.dimension))
            }
            "inner" => {
                let [a, b] = self.arguments(region, &text, arguments, ["a", "b"])?;
                let (a, b) = (self.vector_value(a), self.vector_value(b));
                let (a, b) = (a?, b?);
                let inner = self.inner(&a, &b);
                let dimension = a.dimension.zip(b.dimension).map(|(a, b)| a.times(&b));
                Some(Value::scalar(inner, dimension))
            }
            "cross" => {
                let [a, b] = self.arguments(region, &text, arguments, ["a", "b"])?;
                let (a, b) = (self.spatial_value(a), self.spatial_value(b));
                let ((a, da), (b, db)) = (a?, b?);
                let (turn, a, b) = self.in_common(&a, &b);
                let product = Spatial::within(turn, triple::cross(&mut self.graph, &a, &b));
                Some(Value { shape: Shape::Spatial(product), dimension: da.zip(db).map(|(a, b)| a.times(&b)) })
            }
            "rotation" => {
                let [axis, angle] = self.arguments(region, &text, arguments, ["axis", "angle"])?;
                self.rotation(axis, angle)
            }
            "euler" => self.euler(region, arguments),
            "quaternion" => {
                let components = self.arguments(region, &text, arguments, ["q0", "q1", "q2", "q3"])?;
                self.quaternion(region, components)
            }
            "transpose" => {
                let [rotation] = self.arguments(region, &text, arguments, ["R"])?;
                self.transpose(rotation)
            }
            "angular_velocity" => {
                let [rotation] = self.arguments(region, &text, arguments, ["R"])?;
                self.angular_velocity(rotation)
            }
            "omega" | "attitude" => self.refuse(region, format!("`{text}(..)` takes the name of a body that turns")),
            "dot" => {
                let [x] = self.arguments(region, &text, arguments, ["x"])?;
                self.rate(x)
            }
            "ddot" => {
                let [x] = self.arguments(region, &text, arguments, ["x"])?;
                let rate = self.rate(x)?;
                self.rate_of(x.region, rate)
            }
            "reaction" => self.reaction(region, arguments),
            _ => {
                if self.values.get_region(&text).is_some() {
                    return self.refuse(
                        name.into(),
                        format!("`{text}` is not a function; a product is written `{text}*(..)`"),
                    );
                }
                let functions = scope::functions().map(str::to_owned);
                let known: Vec<String> = self.tables.names().map(str::to_owned).chain(functions).collect();
                let near = nearest::suggestion(&text, known.iter().map(String::as_str));
                let all = if near.is_empty() { format!("; there are {}", known.join(", ")) } else { String::new() };
                self.refuse(name.into(), format!("no function is called `{text}`{near}{all}"))
            }
        }
    }

    fn arguments<'a, const N: usize>(
        &mut self,
        region: Region,
        function: &str,
        arguments: &'a [Expression],
        names: [&str; N],
    ) -> Option<&'a [Expression; N]> {
        match arguments.try_into() {
            Ok(arguments) => Some(arguments),
            Err(_) => {
                let (form, given) = (names.join(", "), arguments.len());
                self.refuse(region, format!("`{function}` is written `{function}({form})`: {N} wanted, {given} given"))
            }
        }
    }

    /// The scalar product of two vectors.
    pub(super) fn inner(&mut self, a: &Value, b: &Value) -> Expr {
        if let (Shape::Spatial(a), Shape::Spatial(b)) = (&a.shape, &b.shape) {
            let (_, a, b) = self.in_common(a, b);
            return triple::inner(&mut self.graph, &a, &b);
        }
        let (a, b) = (self.components(a), self.components(b));
        let products: Vec<Expr> = a.iter().zip(&b).map(|(x, y)| self.graph.mul(*x, *y)).collect();
        self.graph.sum(&products)
    }

    /// The total time derivative of an expression.
    fn rate(&mut self, expression: &Expression) -> Option<Value> {
        let value = self.value(expression)?;
        self.rate_of(expression.region, value)
    }

    pub(super) fn rate_of(&mut self, region: Region, value: Value) -> Option<Value> {
        if let Shape::Rotation(_) = value.shape {
            return self.refuse(region, "the rate of a rotation is an angular velocity: `angular_velocity(R)`");
        }
        let components = self.components(&value);
        self.restrict(
            region,
            &components,
            Dependence::MULTIPLIER,
            "a reaction has no derivative here: its rate is not computed",
        )?;
        self.restrict(region, &components, Dependence::INPUT, "the rate of an input is not known: it may jump")?;
        self.restrict(
            region,
            &components,
            Dependence::ACCELERATION,
            "a third derivative is not computed; `ddot` of positions is the highest",
        )?;
        let dimension = value.dimension.as_ref().map(|d| d.over(&Dimension::time()));
        let Interpreter { graph, motion, frames, .. } = self;
        let shape = match value.shape {
            Shape::Spatial(vector) => Shape::Spatial(frames.rate(graph, motion, &vector)),
            _ => value.map(|x| motion.of(graph, x)).shape,
        };
        Some(Value { shape, dimension })
    }

    fn reaction(&mut self, region: Region, arguments: &[Expression]) -> Option<Value> {
        let [argument] = self.arguments(region, "reaction", arguments, ["constraint"])?;
        let Kind::Name(name) = &argument.kind else {
            return self.refuse(argument.region, "`reaction(..)` takes the name of a constraint");
        };
        match &self.reactions {
            Some(reactions) => reactions.find(name, &mut self.mistakes),
            None => self.refuse(region, "`reaction(..)` can stand only in outputs"),
        }
    }
}
