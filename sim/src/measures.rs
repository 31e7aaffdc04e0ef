//! What the coordinates and the constraints of a mechanism are measured by, so that no unit of length decides what is small,
//! what is near, and what depends on what.

use crate::any::{Any, AnyMechanism, array};
use crate::conditional::released_rows;
use crate::mobility::{Mobility, mobility};
use crate::saved::{Bytes, Damaged};
use nalgebra::DMatrix;
use sim_kernel::{Array, Mechanism};

/// What the coordinates and the constraints of a mechanism are measured by, and the ranks of its constraint Jacobian: found
/// once, where a motion starts.
#[derive(Clone, Copy, Debug)]
pub struct Measures<M: Mechanism> {
    /// For each coordinate the change that counts as 1: the mechanism's own length for lengths, and 1 for all others, n.
    coordinates: M::Q,
    /// For each constraint the largest that its terms are, or that such changes of the coordinates make it, m.
    constraints: M::L,
    /// The ranks of C_q without the rows between speeds, and with them.
    ranks: [usize; 2],
    /// Whether some of the constraints that hold say what others say already.
    is_redundant: bool,
}

impl<M: Mechanism> Measures<M> {
    /// Those of a mechanism at a position on its constraints.
    pub fn at(mechanism: &M, time: f64, q: &M::Q) -> Measures<M> {
        Measures::with_mobility(mechanism, time, q, &mobility(mechanism, time, q))
    }

    /// The same, its degrees of freedom being known.
    pub fn with_mobility(mechanism: &M, time: f64, q: &M::Q, mobility: &Mobility) -> Measures<M> {
        let n = M::Q::LEN;
        let ranks = [n - mobility.configuration_freedom.min(n), n - mobility.degrees_of_freedom.min(n)];
        Measures { ranks, is_redundant: !mobility.dependent.is_empty(), ..Measures::of_independent(mechanism, time, q) }
    }

    /// The same where all constraints that hold are taken to be independent.
    pub(crate) fn of_independent(mechanism: &M, time: f64, q: &M::Q) -> Measures<M> {
        let any: &dyn AnyMechanism = &Any(mechanism);
        let (coordinates, constraints) = measure(any, time, q.as_ref());
        let rank = M::L::LEN - released_rows(mechanism);
        let between_positions = rank.saturating_sub(M::DESCRIPTION.speed_constraints.len());
        Measures {
            coordinates: array(&coordinates),
            constraints: array(&constraints),
            ranks: [between_positions, rank],
            is_redundant: false,
        }
    }

    /// All of it as bytes, or from them.
    pub(crate) fn transfer(&mut self, bytes: &mut Bytes) -> Result<(), Damaged> {
        bytes.numbers(self.coordinates.as_mut())?;
        bytes.numbers(self.constraints.as_mut())?;
        self.ranks.iter_mut().try_for_each(|rank| bytes.index(rank, M::Q::LEN.max(M::L::LEN) + 1))?;
        bytes.flag(&mut self.is_redundant)
    }

    /// For each coordinate the change that counts as 1, in SI units, n.
    pub fn coordinates(&self) -> &M::Q {
        &self.coordinates
    }

    /// For each constraint the size of its terms, in SI units, m.
    pub fn constraints(&self) -> &M::L {
        &self.constraints
    }

    /// The rank of C_q away from singular positions, of the rows between positions alone.
    pub(crate) fn rank_of_positions(&self) -> usize {
        self.ranks[0]
    }

    /// The rank of C_q away from singular positions.
    pub(crate) fn rank(&self) -> usize {
        self.ranks[1]
    }

    /// Whether some of the constraints that hold say what others say already.
    #[inline(always)]
    pub(crate) fn is_redundant(&self) -> bool {
        self.is_redundant
    }

    /// C_q with its columns times the changes that count as 1, m x n.
    #[inline(always)]
    pub(crate) fn columns(&self, jacobian: &M::LQ) -> M::LQ {
        match const { mixes_lengths::<M>() } {
            false => *jacobian,
            true => M::LQ::from_fn(|i| M::Q::from_fn(|j| jacobian[i][j] * self.coordinates[j])),
        }
    }

    /// A change of coordinates in SI units from one in the changes that count as 1, n.
    #[inline(always)]
    pub(crate) fn change(&self, change: M::Q) -> M::Q {
        match const { mixes_lengths::<M>() } {
            false => change,
            true => M::Q::from_fn(|j| change[j] * self.coordinates[j]),
        }
    }

    /// The largest part of a change of coordinates, beside those that count as 1.
    #[inline(always)]
    pub(crate) fn size(&self, change: &M::Q) -> f64 {
        let largest = |part: &dyn Fn(usize) -> f64| (0..M::Q::LEN).fold(0.0f64, |size, j| size.max(part(j).abs()));
        match const { mixes_lengths::<M>() } {
            false => largest(&|j| change[j]) / self.coordinates[0],
            true => largest(&|j| change[j] / self.coordinates[j]),
        }
    }
}

/// Whether there are lengths and others among the coordinates, so that they have to be measured by different numbers.
pub(crate) const fn mixes_lengths<M: Mechanism>() -> bool {
    let (coordinates, mut lengths, mut j) = (M::DESCRIPTION.coordinates, 0, 0);
    while j < coordinates.len() {
        lengths += coordinates[j].position.is_length as usize;
        j += 1;
    }
    0 < lengths && lengths < coordinates.len()
}

/// A matrix of columns for coordinates and rows for constraints in what these are measured by.
pub(crate) fn without_units(
    mut jacobian: DMatrix<f64>,
    (coordinates, constraints): &(Vec<f64>, Vec<f64>),
) -> DMatrix<f64> {
    for (j, change) in coordinates.iter().enumerate() {
        jacobian.column_mut(j).iter_mut().zip(constraints).for_each(|(entry, size)| *entry *= change / size);
    }
    jacobian
}

/// What coordinates and constraints are measured by, n and m.
pub(crate) fn measure(mechanism: &dyn AnyMechanism, time: f64, q: &[f64]) -> (Vec<f64>, Vec<f64>) {
    let coordinates = of_coordinates(mechanism, time, q);
    let (terms, jacobian) = (mechanism.constraint_magnitudes(time, q), mechanism.constraint_jacobian(time, q));
    let of_row = |row: usize| {
        let changes = coordinates.iter().enumerate().map(|(j, change)| (jacobian[(row, j)] * change).abs());
        let size = changes.fold(terms[row].abs(), f64::max);
        if size > 0.0 && size.is_finite() { size } else { 1.0 }
    };
    let constraints = (0..jacobian.nrows()).map(of_row).collect();
    (coordinates, constraints)
}

/// For each coordinate the change that counts as 1, in SI units: the mechanism's own length for lengths, 1 for angles and
/// numbers.
fn of_coordinates(mechanism: &dyn AnyMechanism, time: f64, q: &[f64]) -> Vec<f64> {
    let coordinates = mechanism.description().coordinates;
    let length = own_length(mechanism, time, q);
    coordinates.iter().map(|coordinate| if coordinate.position.is_length { length } else { 1.0 }).collect()
}

/// An arm by which an angle moves a point is no measure where it is this small beside the root of moments of inertia over masses.
const SHORTEST: f64 = 0.01;

/// The mechanism's own length, in metres: all lengths of the same mechanism twice as large make it twice as large.
///
/// How far its points move for a change of its angles: by the constraints, the median of rows in which both lengths and
/// angles stand; else by its inertia; else the largest length that it starts at, or that is a parameter of it; else 1 m.
pub(crate) fn own_length(mechanism: &dyn AnyMechanism, time: f64, q: &[f64]) -> f64 {
    let coordinates = mechanism.description().coordinates;
    let is_length: Vec<bool> = coordinates.iter().map(|coordinate| coordinate.position.is_length).collect();
    let sources: [&dyn Fn() -> f64; 3] = [
        &|| {
            // An arm that is short beside its inertia is one in a dead point.
            let shortest = SHORTEST * gyration(&mechanism.mass_matrix(time, q), &is_length);
            let mut arms = lever_arms(&mechanism.constraint_jacobian(time, q), &is_length);
            arms.retain(|arm| !(*arm < shortest && shortest.is_finite()));
            median(arms)
        },
        &|| gyration(&mechanism.mass_matrix(time, q), &is_length),
        &|| {
            let description = mechanism.description();
            let starts = q.iter().zip(&is_length).filter(|(_, is_length)| **is_length).map(|(q, _)| q.abs());
            let parameters = description.parameters.iter().zip(mechanism.parameters());
            let lengths = parameters.filter(|(parameter, _)| parameter.is_length).map(|(_, value)| value.abs());
            starts.chain(lengths).fold(0.0, f64::max)
        },
    ];
    sources.iter().map(|length| length()).find(|length| *length > 0.0 && length.is_finite()).unwrap_or(1.0)
}

/// For each row with both kinds of coordinates how long its part of angles is beside that of lengths.
fn lever_arms(jacobian: &DMatrix<f64>, is_length: &[bool]) -> Vec<f64> {
    let part = |row: usize, of_lengths: bool| {
        let columns = (0..is_length.len()).filter(|j| is_length[*j] == of_lengths);
        columns.map(|j| jacobian[(row, j)].powi(2)).sum::<f64>().sqrt()
    };
    let arms = (0..jacobian.nrows()).map(|row| part(row, false) / part(row, true));
    arms.filter(|arm| *arm > 0.0 && arm.is_finite()).collect()
}

/// The larger of the two in the middle; 0 of none.
fn median(mut values: Vec<f64>) -> f64 {
    values.sort_unstable_by(f64::total_cmp);
    values.get(values.len() / 2).copied().unwrap_or(0.0)
}

/// The root of the moments of inertia over the masses.
fn gyration(mass: &DMatrix<f64>, is_length: &[bool]) -> f64 {
    let sum = |of_lengths: bool| {
        (0..is_length.len()).filter(|j| is_length[*j] == of_lengths).map(|j| mass[(j, j)]).sum::<f64>()
    };
    (sum(false) / sum(true)).sqrt()
}
