//! A mechanism whose freedoms are all driven: F(q, p) = 0, which has one solution for each p.
//!
//! F stacks the constraints and, for each drive, y(q, t) - y0 - r p. With redundant constraints it has more rows than
//! coordinates, and all of them take part, in least squares: which rows are redundant may change on the way, and
//! leaving out a fixed choice would create singular positions. The parameter p is the time of the sweep; on the way
//! from the assembled start to the beginning of the sweep, and where the mechanism rests in each position, time stands
//! still.

use super::driven::Driven;
use super::stand_in::{StandIn, stand_in};
use crate::model::Differentiable;
use crate::motion::mobility::{Mobility, mobility_of};
use crate::state::failure::{Failure, What};
use nalgebra::{DMatrix, DVector};

/// A quantity that moves uniformly: y = start + rate p.
#[derive(Clone, Copy, Debug)]
pub(super) struct Law {
    pub(super) driven: Driven,
    pub(super) start: f64,
    pub(super) rate: f64,
}

impl Law {
    pub(super) fn at(&self, p: f64) -> f64 {
        self.start + self.rate * p
    }
}

/// F(q, p) = 0.
#[derive(Clone)]
pub(super) struct System<'m> {
    pub(super) mechanism: &'m dyn Differentiable,
    pub(super) laws: Vec<Law>,
    /// The constraints that hold, by index, except those that a drive replaces.
    pub(super) rows: Vec<usize>,
    /// The constraints that drives replace.
    stand_ins: Vec<StandIn>,
    /// Whether time runs: t = p, or t = 0.
    runs: bool,
    /// Whether the mechanism rests in each position.
    pub(super) rests: bool,
}

/// F, F_q (m x n, m >= n), F_p and F_t at one place.
pub(super) struct Linear {
    pub(super) values: DVector<f64>,
    pub(super) jacobian: DMatrix<f64>,
    pub(super) by_parameter: DVector<f64>,
    /// Its part by time, with the drives at rest.
    pub(super) by_time: DVector<f64>,
}

impl<'m> System<'m> {
    /// The system of these laws at a position.
    ///
    /// # Errors
    /// [`What::NotDriven`] unless each degree of freedom has one law, [`What::NotOfPositions`].
    pub(super) fn new(
        mechanism: &'m dyn Differentiable,
        laws: Vec<Law>,
        q: &[f64],
    ) -> Result<(System<'m>, Mobility), Failure> {
        laws.iter().try_for_each(|law| law.driven.check(mechanism, 0.0, q))?;
        let found = mobility_of(mechanism, 0.0, q);
        let stand_ins: Vec<StandIn> =
            laws.iter().enumerate().filter_map(|(k, law)| stand_in(mechanism, law.driven, k, q)).collect();
        let freedoms = found.degrees_of_freedom + stand_ins.len();
        if freedoms != laws.len() {
            let what = What::NotDriven { freedoms, driven: laws.len() };
            return Err(mechanism.failure(what, 0.0, q));
        }
        let constraints = 0..mechanism.description().constraints.len();
        let holds = |row: &usize| mechanism.is_active(*row) && stand_ins.iter().all(|drive| drive.row != *row);
        let rows = constraints.filter(holds).collect();
        Ok((System { mechanism, laws, rows, stand_ins, runs: false, rests: false }, found))
    }

    /// The same mechanism on other laws, with time running.
    pub(super) fn running(&self, laws: Vec<Law>) -> System<'m> {
        System { laws, runs: true, ..self.clone() }
    }

    /// The same mechanism on other laws, at rest in each position.
    pub(super) fn resting(&self, laws: Vec<Law>) -> System<'m> {
        System { laws, rests: true, ..self.clone() }
    }

    pub(super) fn time(&self, p: f64) -> f64 {
        if self.runs { p } else { 0.0 }
    }

    pub(super) fn linear(&self, q: &[f64], p: f64) -> Linear {
        let (n, m, time) = (q.len(), self.rows.len() + self.laws.len(), self.time(p));
        let constraints = self.mechanism.constraint_linearization(time, q);
        let flow = if self.runs { 1.0 } else { 0.0 };
        let [values, by_parameter, by_time] = std::array::from_fn(|_| DVector::zeros(m));
        let mut linear = Linear { values, jacobian: DMatrix::zeros(m, n), by_parameter, by_time };
        for (k, i) in self.rows.iter().enumerate() {
            linear.values[k] = constraints.values[*i];
            linear.by_time[k] = flow * constraints.time_derivative[*i];
            linear.by_parameter[k] = linear.by_time[k];
            linear.jacobian.set_row(k, &constraints.jacobian.row(*i));
        }
        for (k, law) in self.laws.iter().enumerate() {
            let (k, drive) = (k + self.rows.len(), law.driven.gradient(self.mechanism, time, q));
            linear.values[k] = drive.value - law.at(p);
            linear.by_time[k] = flow * drive.by_time;
            linear.by_parameter[k] = linear.by_time[k] - law.rate;
            (0..n).for_each(|j| linear.jacobian[(k, j)] = drive.by_positions[j]);
        }
        linear
    }

    /// F'' without accelerations, at constant rates.
    pub(super) fn convective(&self, q: &[f64], qd: &[f64], p: f64) -> DVector<f64> {
        let time = self.time(p);
        let constraints = self.mechanism.constraint_convective(time, q, qd);
        let of_rows = self.rows.iter().map(|i| constraints[*i]);
        let of_drives = self.laws.iter().map(|law| law.driven.convective(self.mechanism, time, q, qd));
        DVector::from_iterator(self.rows.len() + self.laws.len(), of_rows.chain(of_drives))
    }

    /// Sets driven coordinates to the values of their laws, to the last bit.
    pub(super) fn prescribe(&self, value: impl Fn(usize) -> f64, of: &mut DVector<f64>) {
        for (k, law) in self.laws.iter().enumerate() {
            if let Driven::Coordinate(j) = law.driven {
                of[j] = value(k);
            }
        }
    }

    /// Multipliers of all constraints and of the drives, from those of F. The force of a drive that replaces a
    /// constraint is the reaction of that constraint.
    pub(super) fn split(&self, multipliers: &DVector<f64>) -> (Vec<f64>, Vec<f64>) {
        let mut constraints = vec![0.0; self.mechanism.description().constraints.len()];
        self.rows.iter().enumerate().for_each(|(k, i)| constraints[*i] = multipliers[k]);
        let drives: Vec<f64> = multipliers.iter().skip(self.rows.len()).copied().collect();
        self.stand_ins.iter().for_each(|drive| constraints[drive.row] = drives[drive.law] / drive.factor);
        (constraints, drives)
    }

    /// The multipliers of constraints without those that drives replace.
    pub(super) fn without_stand_ins(&self, multipliers: &[f64]) -> Vec<f64> {
        let mut multipliers = multipliers.to_vec();
        self.stand_ins.iter().for_each(|drive| multipliers[drive.row] = 0.0);
        multipliers
    }

    /// The failure if the drive does not determine the motion at a position.
    pub(super) fn singular(&self, q: &[f64], p: f64) -> Failure {
        self.mechanism.failure(What::DriveSingular { driven: self.drive() }, self.time(p), q)
    }

    /// The name of the first driven quantity.
    pub(super) fn drive(&self) -> &'static str {
        self.laws.first().map_or("nothing", |law| law.driven.quantity(self.mechanism.description()).name)
    }

    /// The coordinates that no drive holds directly.
    pub(super) fn dependent_columns(&self) -> impl Iterator<Item = usize> + '_ {
        let all = 0..self.mechanism.description().coordinates.len();
        all.filter(|j| self.laws.iter().all(|law| law.driven != Driven::Coordinate(*j)))
    }
}
