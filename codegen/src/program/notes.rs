//! What an elimination has to say to whoever writes it down.

use super::values::Value;

/// Names for what was computed, and in which order some of it is best computed.
#[derive(Default)]
pub(super) struct Notes {
    names: Vec<(Value, String)>,
    order: Vec<Value>,
}

impl Notes {
    /// A name for a value.
    pub(super) fn name(&mut self, value: Value, name: String) {
        self.names.push((value, name));
    }

    /// The right-hand side of an unknown as the elimination leaves it. Noted for one unknown after the other.
    pub(super) fn right_hand_side(&mut self, value: Value, unknown: &str) {
        self.name(value, format!("rhs_{unknown}"));
        self.order.push(value);
    }

    /// The names; of several for a value the first counts.
    pub(super) fn names(&self) -> impl Iterator<Item = (Value, &String)> {
        self.names.iter().map(|(value, name)| (*value, name))
    }

    /// What is computed before the results, in this order, where it is needed at all. Right-hand sides lie beside the
    /// pivots that they wait for, so that a processor has both to do at a time.
    pub(super) fn order(&self) -> impl Iterator<Item = Value> {
        self.order.iter().copied()
    }
}
