//! The quantities that a controller changes.

use sim_kernel::{Description, Mechanism};

/// The quantity that a controller changes: by index, in the order of declaration.
#[derive(Clone, Copy, PartialEq, Eq, Debug)]
pub enum Control {
    /// An input.
    Input(usize),
    /// A parameter that stands for one.
    Parameter(usize),
}

impl Control {
    /// Its name.
    pub fn name<M: Mechanism>(self, mechanism: &M) -> &'static str {
        self.name_in(mechanism.description())
    }

    /// Its name in a mechanism of this description.
    pub fn name_in(self, description: &'static Description) -> &'static str {
        match self {
            Control::Input(index) => description.inputs[index].name,
            Control::Parameter(index) => description.parameters[index].name,
        }
    }
}
