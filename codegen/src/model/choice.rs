//! `if`, `min` and `max`.

use super::interpret::Interpreter;
use super::value::{Shape, Value, common_dimension};
use crate::dsl::{self, Comparison, Expression, Region};
use crate::symbolic::{Expr, Graph};

impl Interpreter {
    /// `if a > b then x else y`: x or y, of one kind.
    pub(super) fn choice(&mut self, choice: &dsl::Choice) -> Option<Value> {
        let (left, right) = (self.scalar_value(&choice.left), self.scalar_value(&choice.right));
        let (yes, no) = (self.value(&choice.yes), self.value(&choice.no));
        let ((left, _), (right, _), yes, no) = (left?, right?, yes?, no?);
        let dimension = common_dimension(yes.dimension.clone(), no.dimension.clone());
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
        let shape = match (yes.shape, no.shape) {
            (Shape::Scalar(yes), Shape::Scalar(no)) => Shape::Scalar(choose(yes, no)),
            (Shape::Vector([a, b]), Shape::Vector([c, d])) => Shape::Vector([choose(a, c), choose(b, d)]),
            _ => {
                let message =
                    format!("{} stands after `then` and {} after `else`; both are of one kind", yes.kind(), no.kind());
                return self.refuse(choice.yes.region.to(choice.no.region), message);
            }
        };
        Some(Value { shape, dimension })
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
        let mut values = values.into_iter();
        let mut extreme = values.next()??;
        for value in values {
            let (value, dimension) = value?;
            extreme = (of_two(&mut self.graph, extreme.0, value), common_dimension(extreme.1, dimension));
        }
        Some(Value::scalar(extreme.0, extreme.1))
    }
}
