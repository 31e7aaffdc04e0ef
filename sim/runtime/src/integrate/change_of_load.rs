//! A change of form of a load within a step, or the middle of a pulse.

use sim_kernel::SwitchingKind;

/// Changes within this part of a step are one.
pub(super) const SAME: f64 = 1e-9;

/// A change of form of a load within a step.
#[derive(Clone, Copy, Debug)]
pub(super) struct Change {
    /// Its time, in seconds.
    pub(super) time: f64,
    /// Whether it is a row of a table: there the load is continuous.
    pub(super) is_row: bool,
    /// Whether second derivatives are continuous too: what a step over one such row leads through, its ends have seen.
    pub(super) is_gentle: bool,
    /// What is there.
    pub(super) kind: SwitchingKind,
}

/// Makes those one that are at one time, of a step of such a length, and of which all are sudden, or of the same smooth kind. What is a
/// pole to one is a pole.
pub(super) fn merge(changes: &mut Vec<Change>, length: f64) {
    changes.dedup_by(|next, kept| {
        let is_like = next.kind == kept.kind || !next.kind.is_smooth() && !kept.kind.is_smooth();
        let is_same = next.time - kept.time <= SAME * length && is_like;
        if is_same {
            kept.is_row &= next.is_row;
            kept.kind = if next.kind == SwitchingKind::Pole { next.kind } else { kept.kind };
        }
        is_same
    });
}

#[cfg(test)]
mod tests {
    use super::*;

    /// A jump at a pole is one change, so that nothing stands between both and hides it; the middle of a pulse there is another.
    #[test]
    fn what_is_at_one_time_is_one_change_if_it_is_sudden() {
        let change = |time: f64, kind: SwitchingKind, is_row: bool| Change { time, is_row, is_gentle: false, kind };
        let mut changes = vec![
            change(1.0, SwitchingKind::Form, false),
            change(1.0, SwitchingKind::Pole, false),
            change(1.0, SwitchingKind::Middle, false),
            change(1.5, SwitchingKind::Form, true),
            change(1.5, SwitchingKind::Form, false),
        ];
        merge(&mut changes, 1.0);
        let found: Vec<_> = changes.iter().map(|change| (change.time, change.kind, change.is_row)).collect();
        let expected =
            [(1.0, SwitchingKind::Pole, false), (1.0, SwitchingKind::Middle, false), (1.5, SwitchingKind::Form, false)];
        assert_eq!(found, expected);
    }
}
