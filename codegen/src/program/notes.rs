//! Hints of an elimination for the writer of its statements.

use super::values::Value;

/// Names of computed values, and a preferred order for some of them.
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

    /// The right-hand side of an unknown as the elimination leaves it, noted for each unknown in turn.
    pub(super) fn right_hand_side(&mut self, value: Value, unknown: &str) {
        self.name(value, format!("rhs_{unknown}"));
        self.order.push(value);
    }

    /// More notes, after these.
    pub(super) fn extend(&mut self, others: impl IntoIterator<Item = Notes>) {
        for other in others {
            self.names.extend(other.names);
            self.order.extend(other.order);
        }
    }

    /// The names; if a value has several, the first counts.
    pub(super) fn names(&self) -> impl Iterator<Item = (Value, &String)> {
        self.names.iter().map(|(value, name)| (*value, name))
    }

    /// The values computed before the results, in this order, if they are needed at all. Right-hand sides lie beside
    /// the pivots that they depend on, so that a processor can work on both in parallel.
    pub(super) fn order(&self) -> impl Iterator<Item = Value> {
        self.order.iter().copied()
    }
}
