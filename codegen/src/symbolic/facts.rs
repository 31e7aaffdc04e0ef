//! What is known of an expression's sign for every value of its symbols. Nothing known means no.

use super::{Function, Graph, Node, Number};

/// Sign knowledge. Both false says nothing.
#[derive(Clone, Copy, PartialEq, Eq, Debug, Default)]
pub(super) struct Facts {
    /// Never below zero where it is defined.
    pub(super) nonnegative: bool,
    /// Never zero where it is defined.
    pub(super) nonzero: bool,
}

const POSITIVE: Facts = Facts { nonnegative: true, nonzero: true };

impl Facts {
    pub(super) fn of(graph: &Graph, node: &Node) -> Facts {
        match node {
            Node::Number(value) => Facts { nonnegative: !value.is_negative(), nonzero: !value.is_zero() },
            Node::Constant(_) => POSITIVE,
            Node::Symbol(_) | Node::Atan2(..) => Facts::default(),
            Node::Sum { constant, terms } => {
                let nonnegative = !constant.is_negative()
                    && terms.iter().all(|(term, c)| !c.is_negative() && graph.facts(*term).nonnegative);
                let one_positive =
                    *constant > Number::ZERO || terms.iter().any(|(term, _)| graph.facts(*term) == POSITIVE);
                Facts { nonnegative, nonzero: nonnegative && one_positive }
            }
            Node::Product { coefficient, factors } => Facts {
                nonnegative: !coefficient.is_negative()
                    && factors.iter().all(|(base, exponent)| exponent % 2 == 0 || graph.facts(*base).nonnegative),
                // Underflow is not zero in exact arithmetic; a base that is nonzero stays so.
                nonzero: factors.iter().all(|(base, _)| graph.facts(*base).nonzero),
            },
            // A real power exists only for bases that are not negative, and is not negative itself.
            Node::Power { base, .. } => Facts { nonnegative: true, nonzero: graph.facts(*base) == POSITIVE },
            Node::Call(Function::Exp | Function::Cosh, _) => POSITIVE,
            Node::Call(Function::Abs, argument) => Facts { nonnegative: true, nonzero: graph.facts(*argument).nonzero },
            Node::Call(..) => Facts::default(),
        }
    }
}
