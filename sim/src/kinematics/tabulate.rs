//! A sweep as a table: that of its trajectory, and what only a sweep has.

use super::Kinematics;
use crate::table::{Column, Table};
use sim_kernel::{Mechanism, Quantity};

impl<M: Mechanism> Kinematics<M> {
    /// The columns of the trajectory and, before the outputs: `drive_NAME`, what each drive and hold exerts;
    /// `transmission_index`; and for each output y that is a function of positions `ratio_y`, dy/ds with s what is driven,
    /// and `advantage_y`, the mechanical advantage ds/dy.
    pub fn table(&self) -> Table {
        let mut table = Table::of(&self.mechanism, &self.trajectory);
        let driven = [self.sweep.driven].into_iter().chain(self.sweep.held.iter().map(|(driven, _)| *driven));
        let mut columns: Vec<Column> = driven
            .zip(&self.forces)
            .map(|(driven, forces)| Column {
                name: format!("drive_{}", driven.quantity(const { &M::DESCRIPTION }).name),
                unit: driven.force_unit(const { &M::DESCRIPTION }).into(),
                values: forces.clone(),
            })
            .collect();
        columns.push(Column { name: "transmission_index".into(), unit: "1".into(), values: self.transmission.clone() });
        columns.extend(self.ratios());
        table.insert_before_outputs(columns);
        table
    }

    fn ratios(&self) -> impl Iterator<Item = Column> + '_ {
        let (s, rate) = (self.sweep.driven.quantity(const { &M::DESCRIPTION }), self.sweep.rate());
        let rated = M::DESCRIPTION.rated_outputs.iter().enumerate();
        let rated = rated.filter(|(_, output)| self.extremes.ratios[**output].is_some());
        rated.flat_map(move |(place, output)| {
            let y = &M::DESCRIPTION.outputs[*output];
            let samples = self.trajectory.samples.iter();
            let values: Vec<f64> = samples
                .map(|sample| {
                    let (state, accelerations) = (&sample.state, &sample.accelerations);
                    let rates = self.mechanism.output_rates(state.time, &state.positions, &state.speeds, accelerations);
                    rates[place] / rate * s.factor / y.factor
                })
                .collect();
            let inverse = values.iter().map(|value| 1.0 / value).collect();
            [
                Column { name: format!("ratio_{}", y.name), unit: quotient(y, s).into(), values },
                Column { name: format!("advantage_{}", y.name), unit: quotient(s, y).into(), values: inverse },
            ]
        })
    }
}

/// The unit of a quotient: `m/rad`, or 1.
pub(crate) fn quotient(above: &Quantity, below: &Quantity) -> String {
    let bracketed = |unit: &str| if unit.contains(['*', '/']) { format!("({unit})") } else { unit.to_owned() };
    match (above.unit, below.unit) {
        (above, below) if above == below => "1".into(),
        (above, "1") => above.into(),
        (above, below) => format!("{above}/{}", bracketed(below)),
    }
}
