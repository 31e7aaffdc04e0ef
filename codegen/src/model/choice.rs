//! `if`, `min` and `max`.

use super::interpreter::Interpreter;
use super::measured::Measured;
use super::space::Spatial;
use super::value::{Shape, Value};
use crate::dsl::{self, Comparison, Expression, Region};
use crate::symbolic::{Expr, Graph};

impl Interpreter {
    /// `if a > b then x else y`: x or y, of one kind.
    pub(super) fn choice(&mut self, choice: &dsl::Choice) -> Option<Value> {
        let (left, right) = (self.scalar_value(&choice.left), self.scalar_value(&choice.right));
        let (yes, no) = (self.value(&choice.yes), self.value(&choice.no));
        let ((left, of_left), (right, of_right), yes, no) = (left?, right?, yes?, no?);
        let compared = [(&choice.left, &of_left), (&choice.right, &of_right)];
        let [a, b] = compared.map(|(expression, dimension)| Measured { expression, dimension });
        self.common_dimension(a, b, "only quantities of one dimension can be compared")?;
        let (a, b) = (yes.measured(&choice.yes), no.measured(&choice.no));
        let dimension = self.common_dimension(a, b, "both values of an `if` are of one dimension")?;
        let (all_yes, all_no) = (self.components(&yes), self.components(&no));
        let mut choose = |yes: Expr, no: Expr| {
            // `a >= b` is what `b > a` is not.
            let (difference, above, otherwise) = match choice.comparison {
                Comparison::Greater => (self.graph.sub(left, right), yes, no),
                Comparison::Less => (self.graph.sub(right, left), yes, no),
                Comparison::AtLeast => (self.graph.sub(right, left), no, yes),
                Comparison::AtMost => (self.graph.sub(left, right), no, yes),
            };
            self.graph.choice(difference, above, otherwise)
        };
        let shape = match (&yes.shape, &no.shape) {
            (Shape::Scalar(yes), Shape::Scalar(no)) => Shape::Scalar(choose(*yes, *no)),
            (Shape::Vector([a, b]), Shape::Vector([c, d])) => Shape::Vector([choose(*a, *c), choose(*b, *d)]),
            (Shape::Spatial(_), Shape::Spatial(_)) => {
                let chosen = std::array::from_fn(|k| choose(all_yes[k], all_no[k]));
                Shape::Spatial(Spatial::world(chosen))
            }
            _ => {
                let message = format!("`then` gives {} and `else` {}; both must be of one kind", yes.kind(), no.kind());
                return self.refuse(choice.yes.region.to(choice.no.region), message);
            }
        };
        let bases = self.common_basis([(choice.yes.region, &yes), (choice.no.region, &no)])?;
        Some(Value { shape, dimension, bases })
    }

    /// The smallest or the largest of two or more scalars.
    pub(super) fn extreme(
        &mut self,
        region: Region,
        name: &str,
        arguments: &[Expression],
        of_two: fn(&mut Graph, Expr, Expr) -> Expr,
    ) -> Option<Value> {
        let values: Vec<_> = arguments.iter().map(|argument| self.scalar_value(argument)).collect();
        if values.len() < 2 {
            return self.refuse(region, format!("`{name}` is written `{name}(a, b)`, of two values or more"));
        }
        let rule = format!("`{name}` takes quantities of one dimension");
        let mut values = values.into_iter().enumerate();
        let (_, first) = values.next()?;
        let (mut extreme, mut dimension) = first?;
        for (at, value) in values {
            let (value, own) = value?;
            let b = Measured { expression: &arguments[at], dimension: &own };
            for before in &arguments[..at] {
                let a = Measured { expression: before, dimension: &dimension };
                dimension = self.common_dimension(a, b, &rule)?;
            }
            extreme = of_two(&mut self.graph, extreme, value);
        }
        Some(Value::scalar(extreme, dimension))
    }
}
