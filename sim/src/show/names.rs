//! What the points of a drawing are called, from the declaration.

use sim_kernel::Description;

/// The names of each shape's points: what the declaration calls them, or numbers where it cannot be read.
pub(super) fn points(description: &Description) -> Vec<Vec<String>> {
    let numbered = || {
        let mut number = 0;
        let mut next = || {
            number += 1;
            format!("point {number}")
        };
        description.drawing.iter().map(|shape| (0..shape.points()).map(|_| next()).collect()).collect()
    };
    let fits = |names: &Vec<Vec<String>>| {
        names.len() == description.drawing.len()
            && names.iter().zip(description.drawing).all(|(names, shape)| names.len() == shape.points())
    };
    declared(description).filter(fits).unwrap_or_else(numbered)
}

#[cfg(not(feature = "analysis"))]
fn declared(_: &Description) -> Option<Vec<Vec<String>>> {
    None
}

#[cfg(feature = "analysis")]
fn declared(description: &Description) -> Option<Vec<Vec<String>>> {
    use codegen::dsl;
    let declaration = dsl::parse(description.declaration.parse().ok()?).ok()?;
    let names = |points: &[dsl::Expression]| points.iter().map(printed).collect();
    let shape = |shape: &dsl::Shape| match shape {
        dsl::Shape::Points { points, .. } => names(points),
        dsl::Shape::Slider { at, .. } | dsl::Shape::Circle { at, .. } => names(std::slice::from_ref(at)),
    };
    Some(declaration.drawing.iter().map(shape).collect())
}

#[cfg(feature = "analysis")]
pub(crate) use words::printed;

/// Expressions as they were written.
#[cfg(feature = "analysis")]
mod words {
    use codegen::dsl::{Comparison, Expression, Kind, Operator};

    pub(crate) fn printed(expression: &Expression) -> String {
        let list = |items: &[Expression]| items.iter().map(printed).collect::<Vec<_>>().join(", ");
        match &expression.kind {
            Kind::Number { literal, unit: None } => literal.clone(),
            Kind::Number { literal, unit: Some(unit) } => format!("{literal} [{}]", unit.text),
            Kind::Name(name) => name.to_string(),
            Kind::Vector(components) => format!("[{}]", list(components)),
            Kind::Negate(operand) => format!("-{}", operand_of(operand)),
            Kind::Binary(operator, left, right) => {
                format!("{}{}{}", operand_of(left), sign(*operator), operand_of(right))
            }
            Kind::Call(function, arguments) => format!("{function}({})", list(arguments)),
            Kind::Component(vector, name) => format!("{}.{name}", operand_of(vector)),
            Kind::If(choice) => {
                let [left, right, yes, no] = [&choice.left, &choice.right, &choice.yes, &choice.no].map(printed);
                let than = compared(choice.comparison);
                format!("if {left} {than} {right} then {yes} else {no}")
            }
        }
    }

    /// Sums within other operations stand in parentheses.
    fn operand_of(expression: &Expression) -> String {
        match &expression.kind {
            Kind::Binary(Operator::Add | Operator::Subtract, ..) | Kind::If(_) => format!("({})", printed(expression)),
            _ => printed(expression),
        }
    }

    fn compared(comparison: Comparison) -> &'static str {
        match comparison {
            Comparison::Less => "<",
            Comparison::AtMost => "<=",
            Comparison::Greater => ">",
            Comparison::AtLeast => ">=",
        }
    }

    fn sign(operator: Operator) -> &'static str {
        match operator {
            Operator::Add => " + ",
            Operator::Subtract => " - ",
            Operator::Multiply => "*",
            Operator::Divide => "/",
            Operator::Power => "^",
        }
    }
}
