//! Which equations contain speeds.

use super::{Declaration, Equation, Expression, Kind};
use syn::Ident;

impl Declaration {
    /// Whether an equation contains `dot(..)` or an angular velocity, directly or through a `let`: then it holds
    /// between speeds.
    pub fn has_rates(&self, equation: &Equation) -> bool {
        let mut rated: Vec<&Ident> = Vec::new();
        for definition in &self.lets {
            if mentions_rate(&definition.value, &rated) {
                rated.push(&definition.name);
            }
        }
        mentions_rate(&equation.left, &rated) || mentions_rate(&equation.right, &rated)
    }
}

/// Whether a rate stands in an expression, or one of the names of rates.
fn mentions_rate(expression: &Expression, rated: &[&Ident]) -> bool {
    match &expression.kind {
        Kind::Number { .. } => false,
        Kind::Name(name) => rated.contains(&name),
        Kind::Call(function, _) if ["dot", "ddot", "angular_velocity"].iter().any(|rate| function == rate) => true,
        _ => expression.parts().into_iter().any(|part| mentions_rate(part, rated)),
    }
}
