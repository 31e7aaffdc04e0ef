//! A sweep as a table: that of its trajectory, with the columns of a sweep.

use super::{Extremes, Kinematics, Sweep};
use crate::record::table::{Column, Table};
use sim_kernel::{Description, Mechanism, Quantity};

impl<M: Mechanism> Kinematics<M> {
    /// The columns of the trajectory and, before the outputs: `drive_NAME`, the force of each drive and hold;
    /// `transmission_index`; and for each output y that is a function of positions `ratio_y`, dy/ds at fixed time with
    /// s the driven quantity, and `advantage_y`, the mechanical advantage ds/dy; none for outputs that move by rounding alone.
    #[inline(never)]
    pub fn table(&self) -> Table {
        let mut table = Table::of(&self.mechanism, &self.trajectory);
        let swept = Columns {
            description: self.mechanism.description(),
            sweep: &self.sweep,
            forces: &self.forces,
            transmission: &self.transmission,
            extremes: &self.extremes,
            ratios: &self.ratios,
        };
        table.insert_before_outputs(swept.columns());
        table
    }
}

/// The data of a sweep's columns.
struct Columns<'a> {
    description: &'static Description,
    sweep: &'a Sweep,
    forces: &'a [Vec<f64>],
    transmission: &'a [f64],
    extremes: &'a Extremes,
    ratios: &'a [Vec<f64>],
}

impl Columns<'_> {
    fn columns(&self) -> Vec<Column> {
        let driven = [self.sweep.driven].into_iter().chain(self.sweep.held.iter().map(|(driven, _)| *driven));
        let mut columns: Vec<Column> = driven
            .zip(self.forces)
            .map(|(driven, forces)| Column {
                name: format!("drive_{}", driven.quantity(self.description).name),
                unit: driven.force_unit(self.description).into(),
                values: forces.clone(),
            })
            .collect();
        let transmission = self.transmission.to_vec();
        columns.push(Column { name: "transmission_index".into(), unit: "1".into(), values: transmission });
        columns.extend(self.ratios());
        columns
    }

    fn ratios(&self) -> impl Iterator<Item = Column> + '_ {
        let s = self.sweep.driven.quantity(self.description);
        let rated = self.description.rated_outputs.iter().enumerate();
        let rated = rated.filter(|(_, output)| self.extremes.is_rated[**output]);
        rated.flat_map(move |(place, output)| {
            let y = &self.description.outputs[*output];
            let values = self.ratios.iter().map(|ratios| ratios[place] * s.factor / y.factor);
            let values: Vec<f64> = values.collect();
            let inverse = values.iter().map(|value| 1.0 / value).collect();
            [
                Column { name: format!("ratio_{}", y.name), unit: quotient(y, s).into(), values },
                Column { name: format!("advantage_{}", y.name), unit: quotient(s, y).into(), values: inverse },
            ]
        })
    }
}

/// The unit of a quotient: `m/rad`, or 1.
pub fn quotient(above: &Quantity, below: &Quantity) -> String {
    let bracketed = |unit: &str| if unit.contains(['*', '/']) { format!("({unit})") } else { unit.to_owned() };
    match (above.unit, below.unit) {
        (above, below) if above == below => "1".into(),
        (above, "1") => above.into(),
        (above, below) => format!("{above}/{}", bracketed(below)),
    }
}
