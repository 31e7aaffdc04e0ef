//! A mechanism whose freedoms are all driven: as many equations F(q, p) = 0 as coordinates.
//!
//! F stacks the independent constraints and, for each drive, y(q, t) - y0 - r p. The parameter p is the time of the sweep;
//! on the way from the assembled start to where the sweep begins, time stands still.

use super::driven::Driven;
use crate::any::AnyMechanism;
use crate::failure::{Failure, What};
use crate::mobility::{Mobility, mobility_of};
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
    pub(super) mechanism: &'m dyn AnyMechanism,
    pub(super) laws: Vec<Law>,
    /// The constraints that do not depend on others, by index.
    rows: Vec<usize>,
    /// Whether time runs: t = p, or t = 0.
    runs: bool,
}

/// F, F_q (n x n) and F_p at one place.
pub(super) struct Linear {
    pub(super) values: DVector<f64>,
    pub(super) jacobian: DMatrix<f64>,
    pub(super) by_parameter: DVector<f64>,
}

impl<'m> System<'m> {
    /// The system of these laws, with the constraints that are independent at a position.
    ///
    /// # Errors
    /// [`What::NotDriven`] unless each degree of freedom has one law, [`What::NotOfPositions`].
    pub(super) fn new(
        mechanism: &'m dyn AnyMechanism,
        laws: Vec<Law>,
        q: &[f64],
    ) -> Result<(System<'m>, Mobility), Failure> {
        laws.iter().try_for_each(|law| law.driven.check(mechanism, 0.0, q))?;
        let found = mobility_of(mechanism, 0.0, q);
        if found.degrees_of_freedom != laws.len() {
            let what = What::NotDriven { freedoms: found.degrees_of_freedom, driven: laws.len() };
            return Err(mechanism.failure(what, 0.0, q));
        }
        let constraints = mechanism.description().constraints;
        let is_independent = |i: &usize| !found.dependent.contains(&constraints[*i].name);
        let rows = (0..constraints.len()).filter(|i| mechanism.is_active(*i)).filter(is_independent).collect();
        Ok((System { mechanism, laws, rows, runs: false }, found))
    }

    /// The same mechanism on other laws, with time running.
    pub(super) fn running(&self, laws: Vec<Law>) -> System<'m> {
        System { laws, runs: true, ..self.clone() }
    }

    pub(super) fn time(&self, p: f64) -> f64 {
        if self.runs { p } else { 0.0 }
    }

    pub(super) fn linear(&self, q: &[f64], p: f64) -> Linear {
        let (n, time) = (q.len(), self.time(p));
        let constraints = self.mechanism.constraint_linearization(time, q);
        let flow = if self.runs { 1.0 } else { 0.0 };
        let mut linear =
            Linear { values: DVector::zeros(n), jacobian: DMatrix::zeros(n, n), by_parameter: DVector::zeros(n) };
        for (k, i) in self.rows.iter().enumerate() {
            linear.values[k] = constraints.values[*i];
            linear.by_parameter[k] = flow * constraints.time_derivative[*i];
            linear.jacobian.set_row(k, &constraints.jacobian.row(*i));
        }
        for (k, law) in self.laws.iter().enumerate() {
            let (k, drive) = (k + self.rows.len(), law.driven.gradient(self.mechanism, time, q));
            linear.values[k] = drive.value - law.at(p);
            linear.by_parameter[k] = flow * drive.by_time - law.rate;
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
        DVector::from_iterator(q.len(), of_rows.chain(of_drives))
    }

    /// Multipliers of all constraints and of the drives from those of F. Where constraints depend on others they share
    /// the reactions with least norm, as in runs.
    pub(super) fn split(&self, multipliers: &DVector<f64>, q: &[f64], p: f64) -> (Vec<f64>, Vec<f64>) {
        let mut constraints = vec![0.0; self.mechanism.description().constraints.len()];
        self.rows.iter().enumerate().for_each(|(k, i)| constraints[*i] = multipliers[k]);
        if self.rows.len() < constraints.len() {
            constraints = self.mechanism.least_norm(self.time(p), q, &constraints, self.rows.len());
        }
        (constraints, multipliers.iter().skip(self.rows.len()).copied().collect())
    }

    /// That the drive does not determine the motion at a position.
    pub(super) fn singular(&self, q: &[f64], p: f64) -> Failure {
        let description = self.mechanism.description();
        let driven = self.laws.first().map_or("nothing", |law| law.driven.quantity(description).name);
        self.mechanism.failure(What::DriveSingular { driven }, self.time(p), q)
    }

    /// The coordinates that no drive holds directly.
    pub(super) fn dependent_columns(&self) -> impl Iterator<Item = usize> + '_ {
        let all = 0..self.mechanism.description().coordinates.len();
        all.filter(|j| self.laws.iter().all(|law| law.driven != Driven::Coordinate(*j)))
    }
}
