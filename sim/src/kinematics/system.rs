//! A mechanism whose freedoms are all driven: as many equations F(q, p) = 0 as coordinates.
//!
//! F stacks the independent constraints and, for each drive, y(q, t) - y0 - r p. The parameter p is the time of the sweep;
//! on the way from the assembled start to where the sweep begins, time stands still.

use super::driven::Driven;
use crate::conditional::is_active;
use crate::failure::{Failure, What};
use crate::least_norm::least_norm;
use crate::mobility::{Mobility, mobility};
use crate::project::is_met;
use nalgebra::{DMatrix, DVector};
use sim_kernel::{Array, Mechanism};

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
#[derive(Clone, Debug)]
pub(super) struct System<'m, M: Mechanism> {
    pub(super) mechanism: &'m M,
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

impl<'m, M: Mechanism> System<'m, M> {
    /// The system of these laws, with the constraints that are independent at a position.
    ///
    /// # Errors
    /// [`What::NotDriven`] unless each degree of freedom has one law, [`What::NotOfPositions`].
    pub(super) fn new(mechanism: &'m M, laws: Vec<Law>, q: &M::Q) -> Result<(System<'m, M>, Mobility), Failure> {
        laws.iter().try_for_each(|law| law.driven.check(mechanism, 0.0, q))?;
        let found = mobility(mechanism, 0.0, q);
        if found.degrees_of_freedom != laws.len() {
            let what = What::NotDriven { freedoms: found.degrees_of_freedom, driven: laws.len() };
            return Err(Failure::at::<M>(what, 0.0, q));
        }
        let is_independent = |i: &usize| !found.dependent.contains(&M::DESCRIPTION.constraints[*i].name);
        let holds = |i: &usize| is_active(mechanism, *i);
        let rows = (0..M::L::LEN).filter(holds).filter(is_independent).collect();
        Ok((System { mechanism, laws, rows, runs: false }, found))
    }

    /// The same mechanism on other laws, with time running.
    pub(super) fn running(&self, laws: Vec<Law>) -> System<'m, M> {
        System { laws, runs: true, ..self.clone() }
    }

    pub(super) fn time(&self, p: f64) -> f64 {
        if self.runs { p } else { 0.0 }
    }

    pub(super) fn linear(&self, q: &M::Q, p: f64) -> Linear {
        let (n, time) = (M::Q::LEN, self.time(p));
        let constraints = self.mechanism.constraint_linearization(time, q);
        let drives: Vec<_> = self.laws.iter().map(|law| law.driven.gradient(self.mechanism, time, q)).collect();
        let flow = if self.runs { 1.0 } else { 0.0 };
        let mut linear =
            Linear { values: DVector::zeros(n), jacobian: DMatrix::zeros(n, n), by_parameter: DVector::zeros(n) };
        for (k, i) in self.rows.iter().enumerate() {
            linear.values[k] = constraints.values[*i];
            linear.by_parameter[k] = flow * constraints.time_derivative[*i];
            (0..n).for_each(|j| linear.jacobian[(k, j)] = constraints.jacobian[*i][j]);
        }
        for (k, (law, drive)) in self.laws.iter().zip(&drives).enumerate() {
            let k = k + self.rows.len();
            linear.values[k] = drive.value - law.at(p);
            linear.by_parameter[k] = flow * drive.by_time - law.rate;
            (0..n).for_each(|j| linear.jacobian[(k, j)] = drive.by_positions[j]);
        }
        linear
    }

    /// F'' without accelerations, at constant rates.
    pub(super) fn convective(&self, q: &M::Q, qd: &M::Q, p: f64) -> DVector<f64> {
        let time = self.time(p);
        let constraints = self.mechanism.constraint_convective(time, q, qd);
        let of_rows = self.rows.iter().map(|i| constraints[*i]);
        let of_drives = self.laws.iter().map(|law| law.driven.convective(self.mechanism, time, q, qd));
        DVector::from_iterator(M::Q::LEN, of_rows.chain(of_drives))
    }

    /// Multipliers of all constraints and of the drives from those of F. Where constraints depend on others they share
    /// the reactions with least norm, as in runs.
    pub(super) fn split(&self, multipliers: &DVector<f64>, q: &M::Q, p: f64) -> (M::L, Vec<f64>) {
        let mut constraints = M::L::filled(0.0);
        self.rows.iter().enumerate().for_each(|(k, i)| constraints[*i] = multipliers[k]);
        if self.rows.len() < M::L::LEN {
            let jacobian = self.mechanism.constraint_jacobian(self.time(p), q);
            constraints = least_norm::<M>(jacobian, &constraints, self.rows.len());
        }
        (constraints, multipliers.iter().skip(self.rows.len()).copied().collect())
    }

    /// Whether all constraints hold, those that depend on others too.
    pub(super) fn holds(&self, q: &M::Q, p: f64) -> bool {
        let time = self.time(p);
        is_met(self.mechanism, time, q, &self.mechanism.constraint_linearization(time, q))
    }

    /// That the drive does not determine the motion at a position.
    pub(super) fn singular(&self, q: &M::Q, p: f64) -> Failure {
        let driven = self.laws.first().map_or("nothing", |law| law.driven.quantity(const { &M::DESCRIPTION }).name);
        Failure::at::<M>(What::DriveSingular { driven }, self.time(p), q)
    }

    /// The coordinates that no drive holds directly.
    pub(super) fn dependent_columns(&self) -> impl Iterator<Item = usize> + '_ {
        (0..M::Q::LEN).filter(|j| self.laws.iter().all(|law| law.driven != Driven::Coordinate(*j)))
    }
}
