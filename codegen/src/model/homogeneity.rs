//! Dimensional homogeneity: what is added, compared or put in a place is of the dimension that belongs there.
//!
//! A dimension that is not known fits everywhere: that of a plain 0, and those of names that were complained of already.

use super::interpreter::Interpreter;
use super::measured::Measured;
use super::{Dimension, Point, Unit};
use crate::dsl::Expression;
use crate::symbolic::Expr;

impl Interpreter {
    /// The dimension that two expressions share; where they differ that is a mistake, and `rule` says why.
    pub(super) fn common_dimension(
        &mut self,
        left: Measured,
        right: Measured,
        rule: &str,
    ) -> Option<Option<Dimension>> {
        match (left.dimension, right.dimension) {
            (Some(of_left), Some(of_right)) if of_left != of_right => {
                let mistake = self.unlike(left.expression, of_left, right.expression, of_right, rule);
                self.blame(mistake, &[left.expression, right.expression])
            }
            (of_left, of_right) => Some(of_left.clone().or_else(|| of_right.clone())),
        }
    }

    /// Sees to it that an expression has the dimension that belongs in its place; `claim` says what belongs there:
    /// "a force is in [N]".
    pub(super) fn expect_dimension(&mut self, found: Measured, needed: &Dimension, claim: &str) -> Option<()> {
        match found.dimension {
            Some(dimension) if dimension != needed => {
                let mistake = self.misplaced(found.expression, dimension, needed, claim);
                self.blame(mistake, &[found.expression])
            }
            _ => Some(()),
        }
    }

    /// Sees to it that an expression has the dimension of "a mass" or "an angle".
    pub(super) fn expect_in_place(&mut self, found: Measured, needed: &Dimension, what: &str) -> Option<()> {
        let claim = match needed.is_none() {
            true if what.contains("angle") => format!("{what} is in [rad] or [deg] or a pure number"),
            true => format!("{what} is a pure number"),
            false => format!("{what} is in [{}]", needed.si_unit()),
        };
        self.expect_dimension(found, needed, &claim)
    }

    /// A scalar of the dimension that belongs in its place: "a mass".
    pub(super) fn scalar_of(&mut self, expression: &Expression, needed: &Dimension, what: &str) -> Option<Expr> {
        let (value, dimension) = self.scalar_value(expression)?;
        self.expect_in_place(Measured { expression, dimension: &dimension }, needed, what);
        Some(value)
    }

    /// A vector of the dimension that belongs in its place: "a force".
    pub(super) fn point_of(&mut self, expression: &Expression, needed: &Dimension, what: &str) -> Option<Point> {
        let (point, dimension) = self.point_value(expression)?;
        self.expect_in_place(Measured { expression, dimension: &dimension }, needed, what);
        Some(point)
    }

    /// Sees to it that a value fits the unit of what is declared: "output `height` is declared" of the name `height`.
    pub(super) fn expect_unit(&mut self, found: Measured, what: &str, name: &str, unit: &Unit) -> Option<()> {
        let claim = match (unit.is_declared(), found.dimension) {
            (false, Some(dimension)) => {
                let its_own = self.unit_of(found.expression, dimension);
                format!("{what} without a unit (write `{name} [{its_own}]`)")
            }
            _ => format!("{what} in [{}]", unit.text()),
        };
        self.expect_dimension(found, unit.dimension(), &claim)
    }

    /// The dimension of a power. The exponent is a pure number, and one that is known if the base has a dimension.
    pub(super) fn dimension_of_power(
        &mut self,
        base: Measured,
        exponent: Expr,
        written: Measured,
    ) -> Option<Option<Dimension>> {
        self.expect_dimension(written, &Dimension::none(), "an exponent is a pure number")?;
        match (base.dimension, self.graph.as_number(exponent)) {
            (Some(dimension), Some(number)) => Some(Some(dimension.to_the(number))),
            (Some(dimension), None) if !dimension.is_none() => {
                let is = self.describe(base.expression, dimension);
                let rule = "its exponent must be a number such as `2` or `1/3`, since the unit depends on it";
                self.refuse(written.expression.region, format!("{is}; {rule}"))
            }
            (dimension, _) => Some(dimension.clone()),
        }
    }

    /// Sees to it that `sin(x)`, `exp(x)` and the like are of pure numbers.
    pub(super) fn expect_pure(&mut self, function: &str, argument: Measured) -> Option<()> {
        let what = match (function, argument.dimension) {
            ("sin" | "cos" | "tan", Some(dimension)) if *dimension == Dimension::time() => {
                "an angle (a rate times `t`: `w*t` with `w [rad/s]`)"
            }
            ("sin" | "cos" | "tan", _) => "an angle",
            _ => "a pure number",
        };
        self.expect_dimension(argument, &Dimension::none(), &format!("`{function}(..)` takes {what}"))
    }
}
