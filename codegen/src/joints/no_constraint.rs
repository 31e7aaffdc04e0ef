//! Refuses to treat joints that have become coordinates as constraints.

use super::expressions::expressions;
use super::spatial::ADDED_TO_NAMES;
use crate::dsl::{Action, Declaration, Expression, Joint, Kind, Region};
use crate::mistakes::Mistakes;
use syn::Ident;
use syn::ext::IdentExt;

/// Refuses reactions, releases and impacts of these joints.
pub(super) fn refuse(joints: &[Joint], declaration: &mut Declaration, mistakes: &mut Mistakes) {
    for joint in joints.iter().filter(|joint| joint.initially.is_some()) {
        mistakes.add(fixed(joint, &joint.name));
    }
    for action in declaration.events.iter().flat_map(|event| &event.actions) {
        if let Action::Switch { constraint, .. } | Action::Impact { constraint, .. } = action
            && let Some(joint) = joints.iter().find(|joint| is_of(constraint, joint))
        {
            mistakes.add(fixed(joint, constraint));
        }
    }
    let constraints = declaration.constraints.iter().map(|equation| &equation.name);
    let others: Vec<Ident> = constraints.chain(declaration.auxiliary.iter().map(|a| &a.name)).cloned().collect();
    for expression in expressions(declaration) {
        for reaction in reactions(expression) {
            let is_other = others.contains(reaction);
            if let Some(joint) = joints.iter().find(|joint| !is_other && is_of(reaction, joint)) {
                mistakes.add(unfelt(joint, reaction));
            }
        }
    }
}

/// Whether a name is that of a joint, or of an equation that it would have.
fn is_of(name: &Ident, joint: &Joint) -> bool {
    let name = name.unraw().to_string();
    let added = name.strip_prefix(&joint.name.unraw().to_string());
    added.is_some_and(|added| added.is_empty() || ADDED_TO_NAMES.contains(&added))
}

fn fixed(joint: &Joint, place: &Ident) -> syn::Error {
    Region::from(place).error(format!(
        "joint `{}` places a body, so events cannot switch it; make the body `free`, and the joint becomes a constraint",
        joint.name
    ))
}

fn unfelt(joint: &Joint, place: &Ident) -> syn::Error {
    Region::from(place).error(format!(
        "joint `{}` places a body, so it has no reaction of its own; make the body `free`, and the joint becomes a constraint, or \
         put an `auxiliary` displacement into its point and take the reaction of that",
        joint.name
    ))
}

/// Those whose `reaction(..)` is taken.
fn reactions(expression: &Expression) -> Vec<&Ident> {
    match &expression.kind {
        Kind::Call(function, arguments) if function == "reaction" => match arguments.as_slice() {
            [Expression { kind: Kind::Name(name), .. }] => vec![name],
            _ => vec![],
        },
        _ => expression.parts().into_iter().flat_map(reactions).collect(),
    }
}
