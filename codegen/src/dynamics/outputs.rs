//! Outputs and the rates of those that have one.

use crate::model::{Dependence, Model};
use crate::symbolic::Expr;

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

    pub(super) fn derive(model: &mut Model) -> Outputs {
        let mut rate = model.time_derivative();
        let values: Vec<Expr> = model.outputs.iter().map(|output| output.value).collect();
        let no_rate = Dependence::ACCELERATION.or(Dependence::MULTIPLIER).or(Dependence::INPUT);
        let rates = values
            .iter()
            .map(|value| {
                let has_rate = !model.dependences.of(&model.graph, *value).meets(no_rate);
                has_rate.then(|| rate.of(&mut model.graph, *value))
            })
            .collect();
        Outputs { values, rates }
    }
}
