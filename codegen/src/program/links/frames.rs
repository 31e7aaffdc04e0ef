//! The accelerations of frames that joints add, from the world to the tips.

use super::tree::LinkTree;
use super::triple::{Triple, add, apply, cross, product, sum, transposed, zero};
use crate::program::values::{Value, Values};

/// The accelerations of frames that joints add.
pub(super) struct Frames<'a> {
    tree: &'a LinkTree,
    /// What each link gets from the one before, as far as it is known.
    carried: Vec<Option<[Triple; 2]>>,
}

impl Frames<'_> {
    pub(super) fn of(tree: &LinkTree) -> Frames<'_> {
        Frames { tree, carried: vec![None; tree.links.len()] }
    }

    /// Of the angular velocity and the origin, in the frame of a link, without its own joints.
    pub(super) fn carried(&mut self, values: &mut Values, at: usize, solved: &[Value]) -> [Triple; 2] {
        if let Some(known) = self.carried[at] {
            return known;
        }
        let link = &self.tree.links[at];
        let Some(before) = link.before else { return [zero(values); 2] };
        let [mut turning, mut shifting] = self.carried(values, before, solved);
        let inner = &self.tree.links[before];
        for column in &inner.columns {
            let shift = apply(values, &transposed(&inner.turn), &column.shift);
            for i in 0..3 {
                let [turned, shifted] =
                    [column.spin[i], shift[i]].map(|x| product(values, x, solved[column.coordinate]));
                turning[i] = sum(values, &[turning[i], turned]);
                shifting[i] = sum(values, &[shifting[i], shifted]);
            }
        }
        let arm = cross(values, &turning, &link.offset[0]);
        let origin = add(values, &shifting, &arm);
        let back = transposed(&link.turn);
        let carried = [apply(values, &back, &turning), apply(values, &back, &origin)];
        self.carried[at] = Some(carried);
        carried
    }
}
