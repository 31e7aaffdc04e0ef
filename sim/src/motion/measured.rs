//! The scales of a mechanism at the start of a motion.

use crate::motion::measures::Measures;
use crate::motion::mobility::{Mobility, mobility};
use crate::motion::typed::Any;
use sim_kernel::Mechanism;

impl<M: Mechanism> Measures<M> {
    /// Those of a mechanism at a position on its constraints.
    pub fn at(mechanism: &M, time: f64, q: &M::Q) -> Measures<M> {
        Measures::with_mobility(mechanism, time, q, &mobility(mechanism, time, q))
    }

    /// The same with known degrees of freedom.
    pub fn with_mobility(mechanism: &M, time: f64, q: &M::Q, mobility: &Mobility) -> Measures<M> {
        let freedoms = [mobility.configuration_freedom, mobility.degrees_of_freedom];
        Measures::of(mechanism, &Any(mechanism), (time, q), freedoms, !mobility.dependent.is_empty())
    }
}
