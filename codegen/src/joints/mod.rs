//! Stage 2: joints, free bodies and points on bodies, written out as coordinates, equations and ordinary expressions.
//! Later stages do not see joints.
//!
//! The rewritten parts carry the user's spans. A body placed by joints has a pose that is a product of rotations along
//! the tree, as a user would write it, so its kernels are no longer than those written by hand.

mod added_coordinates;
mod axes;
mod coordinates;
mod equations;
mod expressions;
mod frames;
mod free;
mod made;
mod marks;
mod no_constraint;
mod points;
mod spanning_tree;
mod spatial;

use crate::dsl::Declaration;
use crate::mistakes::Mistakes;
use expressions::expressions;

/// Writes out all joints, free bodies and points on bodies.
///
/// # Errors
/// Unknown bodies, bodies that nothing places or that lack a position or an angle, invalid axes, and names of
/// coordinates that are already taken.
pub fn write_out(mut declaration: Declaration) -> syn::Result<Declaration> {
    axes::write_out(&mut declaration);
    free::give_coordinates(&mut declaration)?;
    spanning_tree::place_bodies(&mut declaration)?;
    let frames = points::frames(&declaration)?;
    let mut mistakes = Mistakes::default();
    for joint in std::mem::take(&mut declaration.joints) {
        if let Some(equations) = mistakes.note(equations::equations(&frames, joint)) {
            declaration.constraints.extend(equations);
        }
    }
    for expression in expressions(&mut declaration) {
        mistakes.note(points::write_out(&frames, expression));
    }
    mistakes.or(declaration)
}
