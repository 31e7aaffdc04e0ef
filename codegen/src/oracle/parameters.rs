//! The defaults of parameters.

use super::error::Result;
use super::function::is_function;
use super::interpret::{Interpreter, Setting};
use crate::dsl::{Declaration, Expression, Kind, Unit};

/// Every default in SI units. A default sees the parameters above it.
pub(super) fn defaults(declaration: &Declaration, si_factor: &dyn Fn(&Unit) -> f64) -> Result<Vec<f64>> {
    let mut values = Vec::new();
    for parameter in &declaration.parameters {
        let mut interpreter = Interpreter::new(declaration, si_factor, Setting::fixed(&values));
        let value = interpreter.scalar(&parameter.value)?.value().value;
        let unit = parameter.unit.as_ref().filter(|_| is_plain(&parameter.value));
        values.push(value * unit.map_or(1.0, si_factor));
    }
    Ok(values)
}

/// Whether neither a unit nor a name, other than that of a constant, stands in the expression.
pub(super) fn is_plain(expression: &Expression) -> bool {
    match &expression.kind {
        // A table has its own units.
        Kind::Call(function, _) if !is_function(&function.to_string()) => false,
        Kind::Number { unit, .. } => unit.is_none(),
        Kind::Name(name) => name == "pi" || name == "e",
        _ => expression.parts().into_iter().all(is_plain),
    }
}
