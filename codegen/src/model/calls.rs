//! Calls of functions.

use super::interpreter::Interpreter;
use super::measured::Measured;
use super::scope::{self, plain};
use super::space::{Spatial, triple};
use super::value::{Shape, Value};
use super::{Dependence, Dimension};
use crate::dsl::{Expression, Kind, Region};
use crate::nearest;
use crate::symbolic::{Function, Graph, Number};
use syn::Ident;

impl Interpreter {
    /// Of a function or a table.
    pub(super) fn call(&mut self, region: Region, name: &Ident, arguments: &[Expression]) -> Option<Value> {
        let text = plain(name);
        if let Some(function) = Function::ALL.into_iter().find(|f| f.name() == text) {
            return self.elementary(region, function, arguments);
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
                Some(Value::scalar(self.norm(&a), a.dimension))
            }
            "inner" => {
                let [a, b] = self.arguments(region, &text, arguments, ["a", "b"])?;
                let (left, right) = (self.vector_value(a), self.vector_value(b));
                let (left, right) = (left?, right?);
                self.common_basis([(a.region, &left), (b.region, &right)])?;
                let inner = self.inner(&left, &right);
                let dimension = left.dimension.zip(right.dimension).map(|(a, b)| a.times(&b));
                Some(Value::scalar(inner, dimension))
            }
            text if scope::SPATIAL_FUNCTIONS.contains(&text) => self.call_in_space(region, text, arguments),
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
            _ => self.unknown_function(name),
        }
    }

    /// Of one of the engine's own functions.
    fn elementary(&mut self, region: Region, function: Function, arguments: &[Expression]) -> Option<Value> {
        let [argument] = self.arguments(region, function.name(), arguments, ["x"])?;
        let (x, dimension) = self.scalar_value(argument)?;
        let dimension = match function {
            Function::Abs => dimension,
            Function::Sign => Some(Dimension::none()),
            _ => {
                self.expect_pure(function.name(), Measured { expression: argument, dimension: &dimension })?;
                Some(Dimension::none())
            }
        };
        Some(Value::scalar(self.graph.call(function, x), dimension))
    }

    /// Of one of the functions of space.
    fn call_in_space(&mut self, region: Region, text: &str, arguments: &[Expression]) -> Option<Value> {
        match text {
            "cross" => {
                let [a, b] = self.arguments(region, text, arguments, ["a", "b"])?;
                self.cross(a, b)
            }
            "rotation" => {
                let [axis, angle] = self.arguments(region, text, arguments, ["axis", "angle"])?;
                self.rotation(axis, angle)
            }
            "euler" => self.euler(region, arguments),
            "quaternion" => {
                let components = self.arguments(region, text, arguments, ["q0", "q1", "q2", "q3"])?;
                self.quaternion(region, components)
            }
            "axes" => {
                let axes = self.arguments(region, text, arguments, ["u", "v", "w"])?;
                self.axes(region, axes)
            }
            "transpose" => {
                let [rotation] = self.arguments(region, text, arguments, ["R"])?;
                self.transpose(rotation)
            }
            _ => {
                let [rotation] = self.arguments(region, text, arguments, ["R"])?;
                self.angular_velocity(rotation)
            }
        }
    }

    fn unknown_function(&mut self, name: &Ident) -> Option<Value> {
        let text = plain(name);
        if self.values.get_region(&text).is_some() {
            return self.refuse(name.into(), format!("`{text}` is not a function; a product is written `{text}*(..)`"));
        }
        let functions = scope::functions().map(str::to_owned);
        let known: Vec<String> = self.tables.names().map(str::to_owned).chain(functions).collect();
        let near = nearest::suggestion(&text, known.iter().map(String::as_str));
        let all = if near.is_empty() { format!("; there are {}", known.join(", ")) } else { String::new() };
        self.refuse(name.into(), format!("no function is called `{text}`{near}{all}"))
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
        let bases = value.bases.clone();
        let Interpreter { graph, motion, frames, .. } = self;
        let shape = match value.shape {
            Shape::Spatial(vector) => Shape::Spatial(frames.rate(graph, motion, &vector)),
            _ => value.map(|x| motion.of(graph, x)).shape,
        };
        Some(Value { shape, dimension, bases })
    }

    /// The vector product.
    fn cross(&mut self, left: &Expression, right: &Expression) -> Option<Value> {
        let (a, b) = (self.spatial_value(left), self.spatial_value(right));
        let ((a, of_a), (b, of_b)) = (a?, b?);
        let bases = self.common_basis([(left.region, &of_a), (right.region, &of_b)])?;
        let (turn, a, b) = self.in_common(&a, &b);
        let product = Spatial::within(turn, triple::cross(&mut self.graph, &a, &b));
        let dimension = of_a.dimension.zip(of_b.dimension).map(|(a, b)| a.times(&b));
        Some(Value { shape: Shape::Spatial(product), dimension, bases })
    }

    fn reaction(&mut self, region: Region, arguments: &[Expression]) -> Option<Value> {
        let [argument] = self.arguments(region, "reaction", arguments, ["constraint"])?;
        let Kind::Name(name) = &argument.kind else {
            return self.refuse(argument.region, "`reaction(..)` takes the name of a constraint");
        };
        let Some(reactions) = &self.reactions else {
            return self.refuse(region, "`reaction(..)` can stand only in outputs");
        };
        let text = plain(name);
        let of_vector = |(whole, component): (&str, &str)| {
            let is_component = ["x", "y", "z"].contains(&component) && reactions.get(whole).is_some();
            is_component.then(|| format!("no constraint is called `{text}`; write `reaction({whole}).{component}`"))
        };
        match text.rsplit_once('_').filter(|_| reactions.get(&text).is_none()).and_then(of_vector) {
            Some(message) => self.refuse(argument.region, message),
            None => reactions.find(name, &mut self.mistakes),
        }
    }
}
