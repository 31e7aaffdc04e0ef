//! The scales of a mechanism's coordinates and constraints, which make smallness, nearness and dependence independent
//! of the unit of length.
//!
//! Coordinates are measured by the mechanism's own length or by 1 rad, constraints by their terms. Projections, sines
//! of rows, choices of coordinates and absolute tolerances all use these scales. The mechanism's length is the median
//! lever arm in the rows of C_q: it depends neither on the origin nor on masses, where one light body would spoil the
//! metric.

use crate::model::AnyMechanism;
use crate::model::conditional::released_rows;
use crate::motion::lengths::{measure, of_constraints};
use crate::motion::mobility::Mobility;
use crate::numerics::arrays::array;
use crate::numerics::numbers::{all, larger};
use crate::state::saved::{Bytes, Damaged};
use sim_kernel::{Array, Mechanism, Scalar};

/// The scales of a mechanism's coordinates and constraints, and the ranks of its constraint Jacobian, found once at the
/// start of a motion.
#[derive(Clone, Debug)]
pub struct Measures<M: Mechanism<S>, S: Scalar = f64> {
    /// For each coordinate the change that counts as 1: the mechanism's own length for lengths, and 1 for all others, n.
    coordinates: M::Q,
    /// For each constraint the largest of its terms, or of its changes by such changes of the coordinates, m.
    constraints: M::L,
    /// The ranks of C_q without the rows between speeds, and with them.
    ranks: [usize; 2],
    /// Whether some of the constraints that hold are redundant.
    is_redundant: bool,
}

impl<M: Mechanism> Measures<M> {
    /// Those of a mechanism at a position, with known degrees of freedom.
    pub(crate) fn of(
        mechanism: &M,
        any: &dyn AnyMechanism,
        (time, q): (f64, &M::Q),
        mobility: &Mobility,
    ) -> Measures<M> {
        let n = mechanism.n();
        let ranks = [n - mobility.configuration_freedom.min(n), n - mobility.degrees_of_freedom.min(n)];
        let is_redundant = !mobility.dependent.is_empty();
        Measures { ranks, is_redundant, ..Measures::of_independent(mechanism, any, time, q) }
    }

    /// The same, with all constraints that hold taken as independent.
    pub(crate) fn of_independent(mechanism: &M, any: &dyn AnyMechanism, time: f64, q: &M::Q) -> Measures<M> {
        let (coordinates, constraints) = measure(any, time, q.as_ref());
        let rank = mechanism.m() - released_rows(mechanism);
        let between_positions = rank.saturating_sub(mechanism.description().speed_constraints.len());
        Measures {
            coordinates: array(mechanism.n(), &coordinates),
            constraints: array(mechanism.m(), &constraints),
            ranks: [between_positions, rank],
            is_redundant: false,
        }
    }

    /// The same with coordinates measured as in others, of the same motion before a change: a ball that has come to the floor is
    /// no smaller for that.
    pub(crate) fn measuring_as(
        self,
        before: &Measures<M>,
        any: &dyn AnyMechanism,
        (time, q): (f64, &M::Q),
    ) -> Measures<M> {
        let coordinates = before.coordinates.clone();
        let constraints = of_constraints(any, time, q.as_ref(), coordinates.as_ref());
        Measures { constraints: array(self.constraints.len(), &constraints), coordinates, ..self }
    }

    /// All of it as bytes, or from them.
    pub(crate) fn transfer(&mut self, bytes: &mut Bytes) -> Result<(), Damaged> {
        bytes.numbers(self.coordinates.as_mut())?;
        bytes.numbers(self.constraints.as_mut())?;
        let rows = self.constraints.len();
        self.ranks.iter_mut().try_for_each(|rank| bytes.index(rank, rows + 1))?;
        bytes.flag(&mut self.is_redundant)
    }

    /// The same ranks with scales on other numbers.
    pub(crate) fn on<S: Scalar>(
        &self,
        coordinate: impl Fn(usize) -> S,
        constraint: impl Fn(usize) -> S,
    ) -> Measures<M::On<S>, S> {
        Measures {
            coordinates: Array::with_len(self.coordinates.len(), coordinate),
            constraints: Array::with_len(self.constraints.len(), constraint),
            ranks: self.ranks,
            is_redundant: self.is_redundant,
        }
    }
}

impl<S: Scalar, M: Mechanism<S>> Measures<M, S> {
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

    /// Whether some of the constraints that hold are redundant.
    #[inline(always)]
    pub(crate) fn is_redundant(&self) -> bool {
        self.is_redundant
    }

    /// C_q with its columns times the changes that count as 1, m x n.
    #[inline(always)]
    pub(crate) fn columns(&self, mechanism: &M, jacobian: &M::LQ) -> M::LQ {
        match mixes_lengths(mechanism) {
            false => jacobian.clone(),
            true => jacobian.like(|i| jacobian[i].like(|j| jacobian[i][j] * self.coordinates[j])),
        }
    }

    /// A change of coordinates in SI units from one in the changes that count as 1, n.
    #[inline(always)]
    pub(crate) fn change(&self, mechanism: &M, change: M::Q) -> M::Q {
        match mixes_lengths(mechanism) {
            false => change,
            true => change.like(|j| change[j] * self.coordinates[j]),
        }
    }

    /// Where each part of a change of coordinates is at most this fraction of those that count as 1.
    #[inline(always)]
    pub(crate) fn is_within(&self, change: &M::Q, fraction: f64) -> S::Mask {
        all::<S>(change.len(), |j| change[j].abs().at_most(S::from_f64(fraction) * self.coordinates[j]))
    }

    /// The largest part of a change of coordinates, relative to those that count as 1.
    #[inline(always)]
    pub(crate) fn size(&self, mechanism: &M, change: &M::Q) -> S {
        let largest =
            |part: &dyn Fn(usize) -> S| (0..change.len()).fold(S::ZERO, |size, j| larger(size, part(j).abs()));
        match mixes_lengths(mechanism) {
            false => largest(&|j| change[j]) / self.coordinates[0],
            true => largest(&|j| change[j] / self.coordinates[j]),
        }
    }
}

/// Whether the coordinates contain both lengths and others, so that they have different scales.
#[inline(always)]
pub(crate) fn mixes_lengths<S: Scalar, M: Mechanism<S>>(mechanism: &M) -> bool {
    mechanism.description().mixes_lengths
}
