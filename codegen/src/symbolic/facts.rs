//! Facts about an expression that hold for every real value of its symbols. Unknown means no.

use super::{Expr, Function, Node, Number};

/// Knowledge of sign and size. All false says nothing.
#[derive(Clone, Copy, PartialEq, Eq, Debug, Default)]
pub(super) struct Facts {
    /// Never below zero where it is defined.
    pub(super) nonnegative: bool,
    /// Never zero where it is finite.
    pub(super) nonzero: bool,
    /// Defined everywhere, and without a pole.
    pub(super) finite: bool,
}

impl Facts {
    /// Whether `x/x` is 1 everywhere.
    pub(super) fn invertible(self) -> bool {
        self.nonzero && self.finite
    }

    fn positive(self) -> bool {
        self.nonnegative && self.nonzero
    }

    /// The facts of a node, from the facts and numbers of its operands.
    pub(super) fn of<'n>(
        node: &Node,
        facts: impl Fn(Expr) -> Facts,
        number: impl Fn(Expr) -> Option<&'n Number>,
    ) -> Facts {
        match node {
            Node::Number(value) => Facts { nonnegative: !value.is_negative(), nonzero: !value.is_zero(), finite: true },
            Node::Constant(_) => Facts { nonnegative: true, nonzero: true, finite: true },
            Node::Symbol(_) => Facts { finite: true, ..Facts::default() },
            Node::Atan2(y, x) => Facts { finite: facts(*y).finite && facts(*x).finite, ..Facts::default() },
            Node::Table(_, _, argument) => Facts { finite: facts(*argument).finite, ..Facts::default() },
            Node::Choice(difference, above, otherwise) => {
                let (difference, a, b) = (facts(*difference), facts(*above), facts(*otherwise));
                Facts {
                    nonnegative: a.nonnegative && b.nonnegative,
                    nonzero: a.nonzero && b.nonzero,
                    finite: difference.finite && a.finite && b.finite,
                }
            }
            Node::Sum { constant, terms } => {
                let nonnegative = !constant.is_negative()
                    && terms.iter().all(|(term, c)| !c.is_negative() && facts(*term).nonnegative);
                let one_positive = *constant > Number::ZERO || terms.iter().any(|(term, _)| facts(*term).positive());
                Facts {
                    nonnegative,
                    nonzero: nonnegative && one_positive,
                    finite: terms.iter().all(|(term, _)| facts(*term).finite),
                }
            }
            Node::Product { coefficient, factors } => Facts {
                nonnegative: !coefficient.is_negative()
                    && factors.iter().all(|(base, exponent)| exponent % 2 == 0 || facts(*base).nonnegative),
                // Underflow is not zero in exact arithmetic: a nonzero base stays nonzero.
                nonzero: factors.iter().all(|(base, _)| facts(*base).nonzero),
                finite: factors.iter().all(|(base, exponent)| match exponent {
                    1.. => facts(*base).finite,
                    _ => facts(*base).invertible(),
                }),
            },
            // A root exists only for bases that are not negative, and is not negative itself. A symbolic
            // exponent may turn out to be an odd integer.
            Node::Power { base, exponent } => {
                let base = facts(*base);
                let root = number(*exponent).and_then(Number::to_fraction).is_some_and(|(p, _)| p > 0);
                Facts {
                    nonnegative: root || base.nonnegative,
                    nonzero: base.positive(),
                    finite: base.finite && base.nonnegative && (root || base.nonzero && facts(*exponent).finite),
                }
            }
            Node::Call(function, argument) => Facts::of_call(*function, facts(*argument)),
        }
    }

    fn of_call(function: Function, argument: Facts) -> Facts {
        use Function::*;
        Facts {
            nonnegative: matches!(function, Exp | Cosh | Abs),
            nonzero: match function {
                Exp | Cosh => true,
                Abs => argument.nonzero,
                _ => false,
            },
            finite: argument.finite
                && match function {
                    Tan | Asin | Acos => false,
                    Ln => argument.positive(),
                    _ => true,
                },
        }
    }
}
