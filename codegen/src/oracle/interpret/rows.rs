//! Calls of tables.

use super::Interpreter;
use crate::dsl::{DeclaredTable, Expression, Unit};
use crate::oracle::error::{Result, refuse};
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
        let function = self.names.function(index, || Function::new(table, &self.rows(table)?))?;
        Ok(Value::Scalar(function.at(&argument)))
    }

    /// The rows of a table in SI units; plain numbers are in the unit of their column.
    fn rows(&self, table: &DeclaredTable) -> Result<Vec<[f64; 2]>> {
        let names = self.names.clone();
        let mut fixed = Interpreter::with_names(self.declaration, self.si_factor, names, Setting::fixed(&[]));
        let mut entry = |expression: &Expression, unit: &Option<Unit>| -> Result<f64> {
            let unit = unit.as_ref().filter(|_| is_plain(expression)).map_or(1.0, self.si_factor);
            Ok(fixed.scalar(expression)?.value().value * unit)
        };
        table.rows.iter().map(|[x, y]| Ok([entry(x, &table.over)?, entry(y, &table.unit)?])).collect()
    }
}
