//! The defaults of parameters.

use super::error::Result;
use super::interpret::Interpreter;
use super::plain::is_plain;
use super::setting::Setting;
use crate::dsl::{Declaration, Unit};

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
