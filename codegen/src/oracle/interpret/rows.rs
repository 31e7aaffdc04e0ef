//! Calls of tables.

use super::Interpreter;
use crate::dsl::{DeclaredTable, Expression, Unit};
use crate::oracle::error::{OracleError, Result, refuse};
use crate::oracle::interpolation::Function;
use crate::oracle::plain::is_plain;
use crate::oracle::setting::Setting;
use crate::oracle::value::Value;

impl Interpreter<'_> {
    /// A table at an argument.
    pub(super) fn look_up(&mut self, index: usize, arguments: &[Expression]) -> Result<Value> {
        let table = &self.declaration.tables[index];
        let [argument] = arguments else { return refuse(format!("table `{}` takes one argument", table.name)) };
        let argument = self.scalar(argument)?;
        if self.tables[index].is_none() {
            self.tables[index] = Some(Function::new(table, &self.rows(table)?)?);
        }
        let found = self.tables[index].as_ref().map(|function| Value::Scalar(function.at(&argument)));
        found.ok_or_else(|| OracleError::new(format!("table `{}` is not known", table.name)))
    }

    /// The rows of a table in SI units; plain numbers are in the unit of their column.
    fn rows(&self, table: &DeclaredTable) -> Result<Vec<[f64; 2]>> {
        let mut fixed = Interpreter::new(self.declaration, self.si_factor, Setting::fixed(&[]));
        let mut entry = |expression: &Expression, unit: &Option<Unit>| -> Result<f64> {
            let unit = unit.as_ref().filter(|_| is_plain(expression)).map_or(1.0, self.si_factor);
            Ok(fixed.scalar(expression)?.value().value * unit)
        };
        table.rows.iter().map(|[x, y]| Ok([entry(x, &table.over)?, entry(y, &table.unit)?])).collect()
    }
}
