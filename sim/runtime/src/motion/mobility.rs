//! Degrees of freedom, redundant constraints, and constraints that are dependent in one position alone.
//!
//! Positions nearby tell redundant from singular: rows that depend on others at all of them are redundant, and rows
//! that do so at the start alone make it singular.

use crate::model::AnyMechanism;
use crate::motion::lengths::{measure, without_units};
use crate::motion::nearby::nearby_positions;
use crate::state::failure::{Failure, What};
use crate::state::saved::{Bytes, Damaged};
use nalgebra::{DMatrix, DVector};
use sim_kernel::Mechanism;

/// The freedom that the constraints leave at a position and near it.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct Mobility {
    /// The number of independent speeds: n less the rank of C_q, rows between speeds included.
    pub degrees_of_freedom: usize,
    /// The number of independent coordinates: more than the degrees of freedom if constraints hold between speeds
    /// alone.
    pub configuration_freedom: usize,
    /// The constraints that depend on those before them, here and in every position near this one: they are redundant.
    pub dependent: Vec<&'static str>,
    /// The constraints that do so here and not nearby: the position is singular.
    pub singular: Vec<&'static str>,
    /// For each of them, the ones before it that it follows from; none if the row is empty. Their individual reactions
    /// are not determined; those of least norm, the smallest sum of lambda^2 in SI units, are given.
    pub implied_by: Vec<Vec<&'static str>>,
}

impl Mobility {
    /// A line for each dependent constraint: the others that it follows from, and the reactions that are shown.
    pub fn redundancies(&self) -> Vec<String> {
        let line = |(name, others): (&&str, &Vec<&str>)| match others.is_empty() {
            true => format!("`{name}` constrains nothing here; its reaction is shown as 0"),
            false => format!(
                "`{name}` is implied by `{}` at the start; their reactions are not determined one by one, and the ones of \
                 least norm in SI units are shown",
                others.join("`, `")
            ),
        };
        self.dependent.iter().zip(&self.implied_by).map(line).collect()
    }

    /// A line for each constraint that depends on others in this position alone.
    pub fn singularities(&self) -> Vec<String> {
        let line = |name: &&str| {
            format!(
                "`{name}` depends on others here, and not nearby: more than one motion may lead on, and a run cannot start"
            )
        };
        self.singular.iter().map(line).collect()
    }

    /// All of it as bytes, or from them.
    pub(crate) fn transfer<M: Mechanism>(&mut self, mechanism: &M, bytes: &mut Bytes) -> Result<(), Damaged> {
        let name = |bytes: &mut Bytes, name: &mut &'static str| bytes.constraint(mechanism, name);
        bytes.count(&mut self.degrees_of_freedom)?;
        bytes.count(&mut self.configuration_freedom)?;
        bytes.list(&mut self.dependent, || "", name)?;
        bytes.list(&mut self.singular, || "", name)?;
        bytes.list(&mut self.implied_by, Vec::new, |bytes, others| bytes.list(others, || "", name))
    }

    /// Checks that a motion can start here.
    ///
    /// # Errors
    /// [`What::SingularStart`] if the position is singular.
    pub(crate) fn check_regular<M: Mechanism>(&self, mechanism: &M, time: f64, q: &M::Q) -> Result<(), Failure> {
        match self.singular.first() {
            None => Ok(()),
            Some(constraint) => Err(Failure::at(mechanism, What::SingularStart { constraint }, time, q)),
        }
    }
}

/// A part of a constraint this small relative to the whole is rounding.
const NO_PART: f64 = 1e-7;

/// A row is dependent if its distance from the space of those before it is less than this fraction of its length, here
/// or nearby.
const DEPENDENT: f64 = 1e-7;

/// Degrees of freedom and dependent constraints at a position, by orthogonalisation of the rows of C_q, in order. Rows
/// that depend on others there are checked at nearby positions too.
pub(crate) fn mobility_of(mechanism: &dyn AnyMechanism, time: f64, q: &[f64]) -> Mobility {
    let jacobians = jacobians(mechanism, time, q);
    let (n, m) = (q.len(), jacobians[0].nrows());
    let length = |row: usize| jacobians.iter().map(|jacobian| jacobian.row(row).norm()).fold(0.0, f64::max);
    let lengths: Vec<f64> = (0..m).map(length).collect();
    let dependent = |jacobian: &DMatrix<f64>| dependent_rows(mechanism, jacobian, &lengths);
    let here = dependent(&jacobians[0]);
    let (jacobian, rows) =
        jacobians[1..].iter().fold((&jacobians[0], here.clone()), |fewest, jacobian| match dependent(jacobian) {
            rows if rows.len() < fewest.1.len() => (jacobian, rows),
            _ => fewest,
        });
    let of_positions = dependent(&mechanism.between_positions(jacobian.clone())).len();
    let is_singular = |row: &&usize| !rows.contains(row);
    let singular = here.iter().filter(is_singular).take(here.len() - rows.len());
    let held = (0..m).filter(|row| mechanism.is_active(*row)).count();
    let name = |row: usize| mechanism.constraint_name(row);
    let implying = |row: &usize| implying(jacobian, *row, &rows).into_iter().map(name).collect();
    Mobility {
        degrees_of_freedom: n + rows.len() - held,
        configuration_freedom: n + of_positions - held,
        singular: singular.map(|row| name(*row)).collect(),
        implied_by: rows.iter().map(implying).collect(),
        dependent: rows.iter().map(|row| name(*row)).collect(),
    }
}

/// The dimensionless C_q at a position, and if rows depend on others or vanish there, at nearby positions too.
fn jacobians(mechanism: &dyn AnyMechanism, time: f64, q: &[f64]) -> Vec<DMatrix<f64>> {
    let measures = measure(mechanism, time, q);
    let jacobian = |q: &[f64]| without_units(mechanism.constraint_jacobian(time, q), &measures);
    let here = jacobian(q);
    let lengths: Vec<f64> = here.row_iter().map(|row| row.norm()).collect();
    let vanishes = lengths.iter().any(|length| *length <= DEPENDENT);
    let nearby = match vanishes || !dependent_rows(mechanism, &here, &lengths).is_empty() {
        true => nearby_positions(mechanism, time, q),
        false => Vec::new(),
    };
    [here].into_iter().chain(nearby.iter().map(|q| jacobian(q))).collect()
}

/// The rows that depend on those before them, among those that hold, relative to these lengths.
fn dependent_rows(mechanism: &dyn AnyMechanism, jacobian: &DMatrix<f64>, lengths: &[f64]) -> Vec<usize> {
    let sines = independence(jacobian, lengths);
    (0..sines.len()).filter(|row| mechanism.is_active(*row) && !(sines[*row] > DEPENDENT)).collect()
}

/// The independent constraints before a row that it is a combination of.
fn implying(jacobian: &DMatrix<f64>, row: usize, dependent: &[usize]) -> Vec<usize> {
    let before: Vec<usize> = (0..row).filter(|i| !dependent.contains(i)).collect();
    let direction = |i: usize| {
        let entries: DVector<f64> = jacobian.row(i).transpose();
        let length = entries.norm();
        if length > 0.0 { entries / length } else { entries }
    };
    let directions = DMatrix::from_fn(jacobian.ncols(), before.len(), |j, k| direction(before[k])[j]);
    if before.is_empty() || directions.iter().any(|entry| !entry.is_finite()) {
        return vec![];
    }
    let Ok(parts) = directions.svd(true, true).solve(&direction(row), DEPENDENT) else { return vec![] };
    before.into_iter().zip(parts.iter()).filter(|(_, part)| part.abs() > NO_PART).map(|(i, _)| i).collect()
}

/// For each row of C_q the sine of its angle to the space of those before it, times its length relative to its length
/// elsewhere.
fn independence(jacobian: &DMatrix<f64>, lengths: &[f64]) -> Vec<f64> {
    let mut basis: Vec<DVector<f64>> = Vec::new();
    let of_row = |(i, length): (usize, &f64)| {
        let mut rest: DVector<f64> = jacobian.row(i).transpose();
        // Twice, to remove the rounding of the first subtraction.
        for direction in basis.iter().chain(&basis) {
            rest -= direction * direction.dot(&rest);
        }
        let sine = rest.norm() / length;
        if sine > DEPENDENT {
            basis.push(rest.normalize());
        }
        sine
    };
    lengths.iter().enumerate().map(of_row).collect()
}

/// A negative kinetic energy this small relative to the others is rounding.
const NEGATIVE: f64 = 1e-10;

/// Whether a unit contains a mass.
fn has_mass(unit: &str) -> bool {
    let words = unit.split(|c: char| !c.is_alphabetic());
    let is_mass = |word: &str| word == "lb" || word.strip_suffix('g').is_some_and(|prefix| prefix.chars().count() <= 1);
    words.into_iter().any(is_mass)
}

/// Checks that no motion has negative kinetic energy: the mass matrix, constraints apart, has no negative eigenvalue.
///
/// # Errors
/// [`What::NegativeMass`], with the parameters that are negative.
pub(crate) fn check_masses_of(mechanism: &dyn AnyMechanism, time: f64, q: &[f64]) -> Result<(), Failure> {
    let matrix = mechanism.mass_matrix(time, q);
    if matrix.is_empty() || matrix.iter().any(|entry| !entry.is_finite()) {
        return Ok(());
    }
    let eigen = matrix.symmetric_eigen();
    let (at, least) = eigen.eigenvalues.argmin();
    if least >= -NEGATIVE * eigen.eigenvalues.amax() {
        return Ok(());
    }
    let description = mechanism.description();
    let coordinate = description.coordinates[eigen.eigenvectors.column(at).iamax()].position.name;
    let parameters = description.parameters.iter().zip(mechanism.parameters());
    let negative = parameters.filter(|(p, value)| *value < 0.0 && has_mass(p.unit));
    let names: Vec<String> =
        negative.map(|(p, value)| format!("`{}` is {} {}", p.name, value / p.factor, p.unit)).collect();
    let suspects = if names.is_empty() { String::new() } else { format!("; {}", names.join(", ")) };
    Err(mechanism.failure(What::NegativeMass { coordinate, suspects }, time, q))
}
