//! The axis of a joint, and the marks across it.
//!
//! An axis n determines two marks t1 and t2 with t1 x t2 = n: for an axis of the frame, the next two axes in turn.

use super::made::{call, number, quotient, vector, zero};
use crate::dsl::{Expression, Kind, Operator, Region, Side};
use syn::Result;

/// An axis of length 1 and the marks across it, in one frame.
pub(super) struct Marks {
    /// n
    pub(super) axis: Expression,
    /// t1 and t2.
    pub(super) across: [Expression; 2],
}

impl Marks {
    /// In the frame of a joint's side; about z if no axis is given.
    pub(super) fn of(side: &Side) -> Result<Marks> {
        match &side.axis {
            Some(axis) => Marks::about(axis),
            None => Marks::about(&coordinate_axis(side.at.region, 2, false)),
        }
    }

    /// About an axis that is written as a vector.
    pub(super) fn about(axis: &Expression) -> Result<Marks> {
        let at = axis.region;
        let form = || {
            at.error(
                "the axis of a joint is written in the frame of its body, with numbers, `[0.6, 0, 0.8]`, or with a plain 0 among its \
                 components, `[0, sin(a), cos(a)]`, or as the name of such a vector; turn the body's frame instead",
            )
        };
        let Kind::Vector(components) = &axis.kind else { return Err(form()) };
        if components.len() != 3 {
            return Err(form());
        }
        let Some(values) = components.iter().map(value).collect::<Option<Vec<f64>>>() else {
            // Among axes made of parameters, only those across a known axis have marks.
            let across = components.iter().position(|x| value(x) == Some(0.0)).ok_or_else(form)?;
            let axis = unit(axis.clone());
            let first = coordinate_axis(at, across, false);
            let second = call(at, "cross", vec![axis.clone(), first.clone()]);
            return Ok(Marks { axis, across: [first, second] });
        };
        let length = values.iter().map(|x| x * x).sum::<f64>().sqrt();
        if !(length > 0.0) {
            return Err(at.error("an axis of length 0 has no direction; write `[0, 0, 1]`"));
        }
        let aligned = (0..3).find(|k| values[*k].abs() == length);
        if let Some(k) = aligned {
            let across = [coordinate_axis(at, (k + 1) % 3, false), coordinate_axis(at, (k + 2) % 3, values[k] < 0.0)];
            return Ok(Marks { axis: coordinate_axis(at, k, values[k] < 0.0), across });
        }
        let axis = if (length - 1.0).abs() < 1e-15 { axis.clone() } else { unit(axis.clone()) };
        let least = (0..3).min_by(|i, k| values[*i].abs().total_cmp(&values[*k].abs())).unwrap_or(0);
        let first = unit(call(at, "cross", vec![axis.clone(), coordinate_axis(at, least, false)]));
        let second = call(at, "cross", vec![axis.clone(), first.clone()]);
        Ok(Marks { axis, across: [first, second] })
    }

    /// About the axis n of the first side, with the axis m of the second across it, if both are numbers at right angles
    /// as written: n, m and n x m, in either frame.
    pub(super) fn crossed(first: &Side, second: &Side) -> Result<Option<Marks>> {
        let [n, m] = [Marks::of(first)?.axis, Marks::of(second)?.axis];
        let [a, b] = [direction(first), direction(second)];
        let inner = |a: &[f64], b: &[f64]| a.iter().zip(b).map(|(a, b)| a * b).sum::<f64>();
        Ok(a.zip(b).filter(|(a, b)| inner(a, b).powi(2) <= RIGHT * inner(a, a) * inner(b, b)).map(|_| {
            let third = call(n.region, "cross", vec![n.clone(), m.clone()]);
            Marks { axis: n, across: [m, third] }
        }))
    }

    /// The rotation from the frame of t1, t2 and n, as its x, y and z, to that in which they are written.
    pub(super) fn frame(&self, at: Region) -> Expression {
        let [t1, t2] = self.across.clone();
        call(at, "axes", vec![t1, t2, self.axis.clone()])
    }

    /// The same three permuted: n, t1, t2 in the places of t1, t2, n.
    pub(super) fn in_turn(self) -> Marks {
        let [t1, t2] = self.across;
        Marks { axis: t2, across: [self.axis, t1] }
    }
}

/// The squared cosine of a right angle, to rounding.
const RIGHT: f64 = 1e-28;

/// The axis of a side as it is written, if it is of numbers.
fn direction(side: &Side) -> Option<Vec<f64>> {
    match &side.axis {
        None => Some(vec![0.0, 0.0, 1.0]),
        Some(Expression { kind: Kind::Vector(components), .. }) => components.iter().map(value).collect(),
        Some(_) => None,
    }
}

/// v/|v|
fn unit(v: Expression) -> Expression {
    quotient(v.clone(), call(v.region, "norm", vec![v]))
}

/// x, y or z, or the opposite.
fn coordinate_axis(at: Region, k: usize, is_opposite: bool) -> Expression {
    let one = if is_opposite { "-1" } else { "1" };
    vector(at, (0..3).map(|i| if i == k { number(at, one) } else { zero(at) }).collect())
}

/// The value of an expression of numbers.
fn value(expression: &Expression) -> Option<f64> {
    match &expression.kind {
        Kind::Number { literal, unit: None } => literal.parse().ok(),
        Kind::Negate(operand) => Some(-value(operand)?),
        Kind::Binary(operator, left, right) => {
            let (a, b) = (value(left)?, value(right)?);
            Some(match operator {
                Operator::Add => a + b,
                Operator::Subtract => a - b,
                Operator::Multiply => a * b,
                Operator::Divide => a / b,
                Operator::Power => a.powf(b),
            })
        }
        Kind::Call(function, arguments) => match arguments.as_slice() {
            [x] if function == "sqrt" => Some(value(x)?.sqrt()),
            [x] if function == "sin" => Some(value(x)?.sin()),
            [x] if function == "cos" => Some(value(x)?.cos()),
            _ => None,
        },
        _ => None,
    }
}
