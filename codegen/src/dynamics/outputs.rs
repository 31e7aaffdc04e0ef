//! Outputs and the rates of those that have one.

use crate::model::{Dependence, Model};
use crate::symbolic::{Expr, Graph};

/// The outputs of a model, in the order of declaration.
pub struct Outputs {
    /// Their values.
    pub values: Vec<Expr>,
    /// Their total time derivatives; `None` where an acceleration, a multiplier or an input occurs, whose rates are not
    /// computed.
    pub rates: Vec<Option<Expr>>,
}

impl Outputs {
    /// The outputs that have a rate, by index.
    pub fn rated(&self) -> Vec<usize> {
        (0..self.rates.len()).filter(|i| self.rates[*i].is_some()).collect()
    }

    pub(super) fn derive(graph: &mut Graph, model: &Model) -> Outputs {
        let mut dependences = model.dependences.clone();
        let mut rate = model.time_derivative(graph);
        let values: Vec<Expr> = model.outputs.iter().map(|output| output.value).collect();
        let no_rate = Dependence::ACCELERATION.or(Dependence::MULTIPLIER).or(Dependence::INPUT);
        let rates = values
            .iter()
            .map(|value| {
                let has_rate = !dependences.of(graph, *value).meets(no_rate);
                has_rate.then(|| rate.of(graph, *value))
            })
            .collect();
        Outputs { values, rates }
    }
}
