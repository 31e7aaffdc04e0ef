//! Tables at arguments.

use super::interpreter::Interpreter;
use super::measured::Measured;
use super::scope::plain;
use super::value::Value;
use crate::dsl::{Expression, Region};
use syn::Ident;

impl Interpreter {
    /// `lift(phi)`
    pub(super) fn look_up(&mut self, region: Region, name: &Ident, arguments: &[Expression]) -> Option<Value> {
        let text = plain(name);
        let function = self.tables.find(name, &mut self.mistakes);
        let [argument] = arguments else {
            let message =
                format!("table `{text}` is written `{text}(x)`: 1 argument wanted, {} given", arguments.len());
            return self.refuse(region, message);
        };
        let (x, dimension) = self.scalar_value(argument)?;
        let function = function?;
        let claim = match function.argument.is_declared() {
            true => format!("table `{text}` is over [{}]", function.argument.text()),
            false => format!("table `{text}` is over pure numbers (`over [..]` says which unit its arguments have)"),
        };
        let found = Measured { expression: argument, dimension: &dimension };
        self.expect_in_unit(found, &function.argument, &claim)?;
        Some(Value::scalar(self.graph.look_up(function.table, 0, x), Some(function.value)))
    }
}
