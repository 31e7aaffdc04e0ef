//! Cycles and angles: 1 Hz and 1 rad/s are of one dimension and differ by 2 pi.

use super::Unit;
use super::interpreter::Interpreter;
use crate::dsl::{Expression, Kind};

impl Interpreter {
    /// Refuses what counts cycles beside what measures angles.
    pub(super) fn refuse_cycles_beside(&mut self, angle: &Expression, cycles: &Expression) -> Option<()> {
        // Units take a while to read, and most sums have none in Hz.
        if !self.own_unit(cycles).is_some_and(|unit| unit.contains("Hz")) {
            return Some(());
        }
        let (Some(of_angle), Some(of_cycles)) = (self.unit_told(angle), self.unit_told(cycles)) else {
            return Some(());
        };
        if !of_cycles.counts_cycles_of(&of_angle) {
            return Some(());
        }
        let (angle, cycles) = (unsigned(angle), unsigned(cycles));
        let message = format!(
            "`{cycles}` is in [{}] and `{angle}` in [{}]: cycles and angles; write `2*pi*{cycles}`",
            of_cycles.text(),
            of_angle.text()
        );
        self.refuse(cycles.region, message)
    }

    /// Refuses cycles in a place for angles, and the other way round; `claim` says which: "`u` is declared in [rpm]".
    pub(super) fn refuse_cycles_in(&mut self, found: &Expression, unit: &Unit, claim: &str) -> Option<()> {
        let Some(given) = self.unit_told(found) else { return Some(()) };
        let found = unsigned(found);
        let (kinds, right) = match (given.counts_cycles_of(unit), unit.counts_cycles_of(&given)) {
            (true, _) => ("angles and cycles", format!("2*pi*{found}")),
            (_, true) => ("cycles and angles", format!("{found}/(2*pi)")),
            _ => return Some(()),
        };
        let message = format!("{claim}, and `{found}` is in [{}]: {kinds}; write `{right}`", given.text());
        self.refuse(found.region, message)
    }

    /// The unit of a name, a number or the rate of a name.
    fn unit_told(&self, expression: &Expression) -> Option<Unit> {
        Unit::parse(&self.own_unit(expression)?).ok()
    }
}

fn unsigned(expression: &Expression) -> &Expression {
    match &expression.kind {
        Kind::Negate(operand) => unsigned(operand),
        _ => expression,
    }
}
