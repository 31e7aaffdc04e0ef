//! Points of the curve and the steps between them.

use super::beside::Beside;
use super::series::Series;
use nalgebra::DVector;
use std::cell::OnceCell;

/// A point of the curve: z = (q, p), each in its size, and its unit tangent.
#[derive(Clone, Debug)]
pub(super) struct Point {
    pub(super) z: DVector<f64>,
    pub(super) tangent: DVector<f64>,
    /// The dimensionless distance of F_z from a lower rank there.
    pub(super) regularity: f64,
    /// The possible amplification of rounding there.
    pub(super) condition: f64,
}

/// A step along the curve, for x from -1 to 1.
pub(super) struct Piece {
    pub(super) from: Point,
    pub(super) to: Point,
    pub(super) length: f64,
    /// z(x).
    pub(super) curve: Vec<Series>,
    /// The places where other branches cross, in order.
    pub(super) crossings: Vec<f64>,
    /// The place where the drive turns back.
    pub(super) limit: Option<f64>,
    /// The values computed once for a step in which another branch crosses.
    pub(super) beside: OnceCell<Option<Vec<Beside>>>,
}

impl Piece {
    /// The possible amplification of rounding at its ends.
    pub(super) fn condition(&self) -> f64 {
        self.from.condition.max(self.to.condition)
    }

    pub(super) fn z(&self, x: f64) -> DVector<f64> {
        DVector::from_fn(self.curve.len(), |j, _| self.curve[j].at(x))
    }
}
