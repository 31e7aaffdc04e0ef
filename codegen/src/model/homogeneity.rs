//! Dimensional homogeneity: terms that are added or compared have the same dimension, and every place its required one.
//!
//! An unknown dimension fits everywhere: that of a plain 0, and those of names that were reported already.

use super::interpreter::Interpreter;
use super::measured::Measured;
use super::{Dimension, Point, Unit};
use crate::dsl::Expression;
use crate::symbolic::Expr;

impl Interpreter {
    /// The common dimension of two expressions that are added or compared; a difference is a mistake, explained by `rule`, and so
    /// is a bare number beside degrees.
    pub(super) fn common_dimension(
        &mut self,
        left: Measured,
        right: Measured,
        rule: &str,
    ) -> Option<Option<Dimension>> {
        let common = self.one_dimension(left, right, rule)?;
        if left.dimension.is_some() && right.dimension.is_some() {
            self.refuse_bare_beside(left.expression, right.expression)?;
            self.refuse_bare_beside(right.expression, left.expression)?;
        }
        Some(common)
    }

    /// The same of two that stand side by side, as components of a vector.
    pub(super) fn one_dimension(&mut self, left: Measured, right: Measured, rule: &str) -> Option<Option<Dimension>> {
        match (left.dimension, right.dimension) {
            (Some(of_left), Some(of_right)) if of_left != of_right => {
                let mistake = self.unlike(left.expression, of_left, right.expression, of_right, rule);
                self.blame(mistake, &[left.expression, right.expression])
            }
            (Some(_), Some(_)) => {
                self.refuse_cycles_beside(left.expression, right.expression)?;
                self.refuse_cycles_beside(right.expression, left.expression)?;
                Some(left.dimension.clone())
            }
            (of_left, of_right) => Some(of_left.clone().or_else(|| of_right.clone())),
        }
    }

    /// Checks that an expression has the dimension required by its place; `claim` says which: "a force is in [N]".
    pub(super) fn expect_dimension(&mut self, found: Measured, needed: &Dimension, claim: &str) -> Option<()> {
        self.expect_of((needed, &needed.si_unit()), found, claim)
    }

    /// The same, of a place that has a unit of its own.
    fn expect_of(&mut self, needed: (&Dimension, &str), found: Measured, claim: &str) -> Option<()> {
        match found.dimension {
            Some(dimension) if dimension != needed.0 => {
                let mistake = self.misplaced(found.expression, dimension, needed, claim);
                self.blame(mistake, &[found.expression])
            }
            _ => Some(()),
        }
    }

    /// Checks that an expression has the dimension of "a mass" or "an angle".
    pub(super) fn expect_in_place(&mut self, found: Measured, needed: &Dimension, what: &str) -> Option<()> {
        let claim = match needed.is_none() {
            true if what.contains("angle") => format!("{what} is in [rad] or [deg] or a pure number"),
            true => format!("{what} is a pure number"),
            false => format!("{what} is in [{}]", needed.si_unit()),
        };
        self.expect_dimension(found, needed, &claim)
    }

    /// A scalar of the required dimension: "a mass".
    pub(super) fn scalar_of(&mut self, expression: &Expression, needed: &Dimension, what: &str) -> Option<Expr> {
        let (value, dimension) = self.scalar_value(expression)?;
        self.expect_in_place(Measured { expression, dimension: &dimension }, needed, what);
        Some(value)
    }

    /// A vector of the required dimension: "a force".
    pub(super) fn point_of(&mut self, expression: &Expression, needed: &Dimension, what: &str) -> Option<Point> {
        let (point, dimension) = self.point_value(expression)?;
        self.expect_in_place(Measured { expression, dimension: &dimension }, needed, what);
        Some(point)
    }

    /// Checks that a value fits the declared unit: "output `height` is declared" of the name `height`.
    pub(super) fn expect_unit(&mut self, found: Measured, what: &str, name: &str, unit: &Unit) -> Option<()> {
        let claim = match (unit.is_declared(), found.dimension) {
            (false, Some(dimension)) => {
                let its_own = self.unit_of(found.expression, dimension);
                format!("{what} without a unit (write `{name} [{its_own}]`)")
            }
            _ => format!("{what} in [{}]", unit.text()),
        };
        self.expect_in_unit(found, unit, &claim)
    }

    /// Checks that a value is of the dimension of a unit, and is not misread: bare numbers as degrees, cycles as angles.
    pub(super) fn expect_in_unit(&mut self, found: Measured, unit: &Unit, claim: &str) -> Option<()> {
        self.expect_of((unit.dimension(), unit.text()), found, claim)?;
        if found.dimension.is_none() {
            return Some(());
        }
        self.refuse_bare_in(found.expression, unit, claim)?;
        self.refuse_cycles_in(found.expression, unit, claim)
    }

    /// The dimension of a power. The exponent is a pure number, and a constant if the base has a dimension.
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

    /// Checks that the arguments of `sin(x)`, `exp(x)` and the like are pure numbers.
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
