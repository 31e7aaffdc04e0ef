//! Loads.

use super::jet::Jet;
use super::measured::Measured;

/// One component of a force or a moment, and the coordinate or angle along which it works.
pub(super) struct Effort {
    /// The component.
    pub(super) force: Measured,
    /// Its virtual work is `force` times the variation of this.
    pub(super) place: Jet,
}
