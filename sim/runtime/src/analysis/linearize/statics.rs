//! A mechanism at rest: its forces and its stiffness.

use super::derivatives::Derivatives;
use super::reduce::Reduction;
use crate::model::{At, Differentiable};
use crate::state::failure::{Failure, What};
use nalgebra::{Cholesky, DMatrix, DVector, SymmetricEigen};

/// Accelerations up to this count as rest, in radians and in the mechanism's own length per s^2.
const AT_REST: f64 = 1e-8;
/// So are those that the rounding of positions makes, in stiff mechanisms: q'' changes by q''_q times q times as many ulp.
const ROUNDINGS: f64 = 64.0;
/// Directions this much softer than the stiffest are free.
const FREE: f64 = 1e-12;
/// Sweeps after which a decomposition is given up; a few for each row are usual.
const MOST_SWEEPS: usize = 10_000;
/// The distance searched for a singular position after a search fails, in the scales of the coordinates.
const NEARBY: f64 = 0.02;

/// A position on the constraints, at rest. Changes of the f independent coordinates are y = L' dx with M = L L' the reduced
/// mass matrix, so that all entries are in sqrt(kg) m, and forces in sqrt(kg) m/s^2.
pub(crate) struct Statics {
    /// The position, n.
    pub(crate) q: Vec<f64>,
    reduction: Reduction,
    /// The scales of the coordinates, n.
    pub(crate) sizes: Vec<f64>,
    /// The accelerations, n, and how they change with each independent coordinate, n x h.
    accelerations: DVector<f64>,
    by_positions: DMatrix<f64>,
    /// L, f x f.
    root: DMatrix<f64>,
    /// N L'^-1: the change of all coordinates with y, n x f.
    moves: DMatrix<f64>,
}

impl Statics {
    /// In these scales of the coordinates: those of the start of a search. A mechanism without a length of its own, such as two
    /// masses on springs of no length, has none at its equilibrium.
    ///
    /// # Errors
    /// As the right-hand side; and in a singular position.
    pub(crate) fn at(mechanism: &dyn Differentiable, q: Vec<f64>, sizes: &[f64]) -> Result<Statics, Failure> {
        let still = vec![0.0; q.len()];
        let at = At::moving(0.0, &q, &still);
        let derivatives = Derivatives::at(mechanism, at, &[])?;
        let reduction = Reduction::at(mechanism, at)?;
        let by_speeds = reduction.by_speeds();
        let mass = by_speeds.transpose() * mechanism.mass_matrix(0.0, &q) * by_speeds;
        let f = mass.nrows();
        let root = Cholesky::new(mass).map_or_else(|| DMatrix::identity(f, f), |factors| factors.l());
        let inverse = root.transpose().solve_upper_triangular(&DMatrix::identity(f, f));
        let moves = by_speeds * inverse.unwrap_or_else(|| DMatrix::identity(f, f));
        let independent = reduction.independent();
        let mut by_positions = DMatrix::zeros(q.len(), independent.len());
        for k in 0..independent.len() {
            by_positions.set_column(k, &derivatives.along(&reduction, k)?.accelerations);
        }
        let accelerations = DVector::from_column_slice(derivatives.accelerations());
        let numbers = accelerations.iter().chain(&by_positions).chain(&moves);
        if numbers.into_iter().any(|number| !number.is_finite()) {
            let quantity = "how accelerations change with the position".into();
            return Err(mechanism.failure(What::NotFinite { quantity }, 0.0, &q));
        }
        Ok(Statics { sizes: sizes.to_vec(), reduction, accelerations, by_positions, root, moves, q })
    }

    /// L' q_i'', f.
    pub(crate) fn force(&self) -> DVector<f64> {
        self.root.tr_mul(&self.accelerations.select_rows(self.reduction.independent_speeds()))
    }

    /// Its derivative by y, f x f.
    fn stiffness(&self) -> DMatrix<f64> {
        let accelerations = self.by_positions.select_rows(self.reduction.independent_speeds());
        self.root.tr_mul(&accelerations) * self.moves.select_rows(self.reduction.independent())
    }

    /// The largest part of a step, in the scales of the coordinates.
    pub(crate) fn size(&self, step: &DVector<f64>) -> f64 {
        let parts = &self.moves * step;
        parts.iter().zip(&self.sizes).fold(0.0, |largest, (part, size)| largest.max((part / size).abs()))
    }

    /// The shortest y that Newton's method takes; none where nothing moves.
    pub(crate) fn newton_step(&self) -> Option<DVector<f64>> {
        if self.root.is_empty() {
            return None;
        }
        let factors = self.stiffness().try_svd(true, true, f64::EPSILON, MOST_SWEEPS)?;
        let least = FREE * factors.singular_values.amax();
        let step = factors.solve(&-self.force(), least.max(f64::MIN_POSITIVE)).ok()?;
        (step.norm() > 0.0).then_some(step)
    }

    /// A y that leads down, and whether Newton's step does too, that is, whether no direction is unstable.
    pub(crate) fn descent(&self, stiffer: f64) -> (DVector<f64>, bool) {
        let (force, stiffness) = (self.force(), self.stiffness());
        let f = force.len();
        let symmetric = (&stiffness + stiffness.transpose()) / 2.0;
        let Some(eigen) = SymmetricEigen::try_new(symmetric, f64::EPSILON, MOST_SWEEPS) else { return (force, false) };
        let (largest, size) = (eigen.eigenvalues.max(), eigen.eigenvalues.amax());
        let added = if size > 0.0 { 1.1 * largest.max(0.0) + stiffer * size } else { 1.0 };
        let step = (DMatrix::identity(f, f) * added - stiffness).lu().solve(&force);
        (step.unwrap_or(force), largest <= stiffer * size)
    }

    /// The end of a step, and the force there in the same coordinates and scales.
    ///
    /// # Errors
    /// If the constraints cannot be met there; as the right-hand side.
    pub(crate) fn moved(
        &self,
        mechanism: &dyn Differentiable,
        step: &DVector<f64>,
    ) -> Result<(Vec<f64>, DVector<f64>), Failure> {
        let change = &self.moves * step;
        let mut q: Vec<f64> = self.q.iter().zip(&change).map(|(q, change)| q + change).collect();
        let mut still = vec![0.0; q.len()];
        self.reduction.follow(mechanism, 0.0, (&mut q, &mut still))?;
        let accelerations = mechanism.accelerate(At::moving(0.0, &q, &[]))?;
        let force = self.root.tr_mul(&accelerations.select_rows(self.reduction.independent_speeds()));
        Ok((q, force))
    }

    /// Whether nothing accelerates.
    pub(crate) fn is_at_rest(&self) -> bool {
        let independent = self.reduction.independent().iter().enumerate();
        (0..self.q.len()).all(|i| {
            let rounding =
                |(k, j): (usize, &usize)| self.by_positions[(i, k)].abs() * (self.q[*j].abs() + self.sizes[*j]);
            let rounding: f64 = independent.clone().map(rounding).sum();
            self.accelerations[i].abs() <= AT_REST * self.sizes[i] + ROUNDINGS * f64::EPSILON * rounding
        })
    }

    /// Refuses a position where a speed moves next to nothing, in the scales of the start.
    ///
    /// # Errors
    /// [`What::Singular`] there.
    pub(crate) fn check_inertia(&self, mechanism: &dyn Differentiable) -> Result<(), Failure> {
        super::check_inertia(mechanism, At::moving(0.0, &self.q, &[]), &self.reduction, &self.sizes)
    }

    /// The largest acceleration, in SI units.
    pub(crate) fn largest_acceleration(&self) -> f64 {
        self.accelerations.amax()
    }

    /// The failure that names the singular position beside this one in the direction of Newton's step, if there is one.
    pub(crate) fn singular_nearby(&self, mechanism: &dyn Differentiable) -> Option<Failure> {
        let step = self.newton_step().unwrap_or_else(|| self.force());
        let direction = &self.moves * &step / self.size(&step);
        self.reduction.singular_along(mechanism, 0.0, &self.q, &direction, NEARBY)
    }
}
