//! A mechanism at rest: its forces and its stiffness.

use super::derivatives::Derivatives;
use super::reduce::Reduction;
use crate::model::{At, Differentiable};
use crate::numerics::graded::Graded;
use crate::state::failure::{Failure, What};
use nalgebra::{Cholesky, DMatrix, DVector, RowDVector, SymmetricEigen};

/// Accelerations up to this count as rest, in radians and in the mechanism's own length per s^2.
const AT_REST: f64 = 1e-8;
/// Along what nothing holds any acceleration leads away: the largest one that is rounding, likewise.
const PUSHED: f64 = 1e-13;
/// So are those that the rounding of positions makes, in stiff mechanisms: q'' changes by q''_q times q times as many ulp.
const ROUNDINGS: f64 = 64.0;
/// The rounding of a stiffness, beside the terms that make it; and where derivatives are differences.
const ROUNDED: f64 = 16.0 * f64::EPSILON;
const DIFFERENCED: f64 = 1e-10;
/// The least margin of stiffness in a descent, as a part of the largest one: the rounding of a decomposition.
const REGULAR: f64 = 1e-14;
/// What is unstable by less is neutral, likewise.
const NEUTRAL: f64 = 1e-12;
/// The longest step of Newton's method at an equilibrium, in the scales of the coordinates: the rest of it is rounding.
const SETTLED: f64 = 1e-4;
/// The positions beside one at which that is asked for too, in its last digits.
const BESIDE: [f64; 5] = [1.0, -2.0, 3.0, -1.0, 2.0];
/// An acceleration that is too much for rest even if rounding makes it, as of [`AT_REST`].
const SHAKEN: f64 = 1e-2;
/// How far away, in the same scales, a stiffness that is rounding is thought to hold something.
const FAR: f64 = 100.0;
/// Sweeps after which a decomposition is given up; a few for each row are usual.
const MOST_SWEEPS: usize = 10_000;
/// The distance searched for a singular position after a search fails, in the scales of the coordinates.
const NEARBY: f64 = 0.02;

/// A position on the constraints, at rest. Forces and changes are those of the f independent speeds.
pub(crate) struct Statics {
    /// The position, n.
    pub(crate) q: Vec<f64>,
    reduction: Reduction,
    /// The scales of the coordinates, n.
    pub(crate) sizes: Vec<f64>,
    /// The accelerations, n, and how they change with each independent coordinate, n x h.
    accelerations: DVector<f64>,
    by_positions: DMatrix<f64>,
    /// The rounding of a stiffness, beside the terms that make it; a direction this soft beside its own coordinates is free.
    rounded: f64,
    /// The reduced mass matrix M, and L with L L' = M, f x f.
    mass: DMatrix<f64>,
    root: DMatrix<f64>,
}

/// Newton's method at a position.
pub(crate) struct Tangent {
    factors: Graded,
    /// Directions up to this soft are left out.
    least: f64,
    /// They, f x k, and their part in the mass matrix: a step does not move along them, as measured by it.
    free: DMatrix<f64>,
    momentum: DMatrix<f64>,
}

impl Tangent {
    /// The shortest change that takes a force away; none where nothing moves.
    pub(crate) fn step(&self, force: &DVector<f64>) -> Option<DVector<f64>> {
        let mut step = self.factors.solve(&-force, self.least)?;
        if !self.free.is_empty() {
            let along = (&self.momentum * &self.free).lu().solve(&(&self.momentum * &step))?;
            step -= &self.free * along;
        }
        (step.norm() > 0.0).then_some(step)
    }
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
        let root = Cholesky::new(mass.clone()).map_or_else(|| DMatrix::identity(f, f), |factors| factors.l());
        let independent = reduction.independent();
        let mut by_positions = DMatrix::zeros(q.len(), independent.len());
        for k in 0..independent.len() {
            by_positions.set_column(k, &derivatives.along_roughly(&reduction, k)?.accelerations);
        }
        let accelerations = DVector::from_column_slice(derivatives.accelerations());
        let rounded = if derivatives.are_exact() { ROUNDED } else { DIFFERENCED };
        let numbers = accelerations.iter().chain(&by_positions).chain(&mass);
        if numbers.into_iter().any(|number| !number.is_finite()) {
            let quantity = "how accelerations change with the position".into();
            return Err(mechanism.failure(What::NotFinite { quantity }, 0.0, &q));
        }
        Ok(Statics { sizes: sizes.to_vec(), reduction, accelerations, by_positions, rounded, mass, root, q })
    }

    /// M q_i'', f: what drives each independent coordinate alone, as accelerations do not where masses couple them.
    pub(crate) fn force(&self) -> DVector<f64> {
        &self.mass * self.accelerations.select_rows(self.reduction.independent_speeds())
    }

    /// The length of a force as the mass matrix measures it, in sqrt(kg) m/s^2.
    pub(crate) fn strength(&self, force: &DVector<f64>) -> f64 {
        self.root.solve_lower_triangular(force).map_or(f64::INFINITY, |force| force.norm())
    }

    /// The derivative of the force by changes, f x f, and the rounding in it: of the terms of the products here, and of those that
    /// cancel in the derivatives, as where all falls freely and no angle changes that.
    fn stiffness(&self) -> (DMatrix<f64>, DMatrix<f64>) {
        let (independent, speeds) = (self.reduction.independent(), self.reduction.independent_speeds());
        let accelerations = self.by_positions.select_rows(speeds);
        let moves = self.reduction.by_speeds().select_rows(independent);
        // Far out, where forces fade, derivatives are as small as accelerations beside the distance.
        let sizes = independent.iter().map(|j| self.sizes[*j].max(self.q[*j].abs()).recip());
        let per_size = RowDVector::from_iterator(independent.len(), sizes);
        let terms = accelerations.abs() + self.accelerations.select_rows(speeds).abs() * per_size;
        let errors = self.mass.abs() * terms * moves.abs() * self.rounded;
        (&self.mass * accelerations * moves, errors)
    }

    /// The largest part of a step, in the scales of the coordinates.
    pub(crate) fn size(&self, step: &DVector<f64>) -> f64 {
        self.parts(step).fold(0.0, f64::max)
    }

    fn parts(&self, step: &DVector<f64>) -> impl Iterator<Item = f64> {
        let parts = self.reduction.by_speeds() * step;
        self.sizes.iter().enumerate().map(move |(j, size)| (parts[j] / size).abs())
    }

    /// None where nothing can move.
    pub(crate) fn tangent(&self) -> Option<Tangent> {
        if self.mass.is_empty() {
            return None;
        }
        let (stiffness, errors) = self.stiffness();
        let factors = Graded::new(stiffness, &errors)?;
        let least = self.rounded * self.mass.nrows() as f64;
        let free = factors.free(least);
        Some(Tangent { momentum: free.tr_mul(&self.mass), free, factors, least })
    }

    /// The first of these directions along which a force accelerates by more than this.
    fn pushed(&self, free: &DMatrix<f64>, force: &DVector<f64>, least: f64) -> Option<DVector<f64>> {
        self.pushed_beyond(&DVector::zeros(force.len()), (free, force), least)
    }

    /// The same, with a force that is but so well known.
    fn pushed_beyond(
        &self,
        error: &DVector<f64>,
        (free, force): (&DMatrix<f64>, &DVector<f64>),
        least: f64,
    ) -> Option<DVector<f64>> {
        let is_pushed = |direction: &DVector<f64>| {
            let direction = direction / self.size(direction);
            let inertia = direction.dot(&(&self.mass * &direction));
            let rounding = ROUNDINGS * f64::EPSILON * direction.abs().dot(&force.abs());
            let rounding = rounding + direction.abs().dot(error);
            direction.dot(force).abs() > least * inertia + rounding
        };
        free.column_iter().map(|direction| direction.into_owned()).find(is_pushed)
    }

    /// The shortest change that Newton's method takes; none where nothing moves.
    pub(crate) fn newton_step(&self) -> Option<DVector<f64>> {
        self.tangent()?.step(&self.force())
    }

    /// Whether no force acts along what is free, and Newton's method would not go on.
    pub(crate) fn is_settled(&self, mechanism: &dyn Differentiable) -> bool {
        let is_settled = |tangent: Tangent| {
            let (free, force) = (&tangent.free, &self.force());
            let gently = || self.pushed_beyond(&self.rounding_of_force(), (free, force), PUSHED);
            let pushed = self.pushed(free, force, AT_REST).or_else(gently);
            pushed.is_none() && self.driven(mechanism, &tangent).is_none()
        };
        self.tangent().is_none_or(is_settled)
    }

    /// Newton's step from here, or from beside it where the last digits differ, if it is long, or a free direction that is pushed
    /// there: rounding may let it rest in one place.
    fn driven(&self, mechanism: &dyn Differentiable, tangent: &Tangent) -> Option<DVector<f64>> {
        let coordinates = self.reduction.independent_speeds();
        let digits = |sample: usize| {
            let part = |k: usize| f64::EPSILON * self.q[coordinates[k]] * BESIDE[(sample + k) % BESIDE.len()];
            DVector::from_fn(coordinates.len(), |k, _| part(k))
        };
        let beside = (0..BESIDE.len()).filter_map(|sample| self.moved(mechanism, &digits(sample)).ok());
        let mut forces = std::iter::once(self.force()).chain(beside.map(|(_, force)| force));
        forces.find_map(|force| {
            let step = tangent.step(&force).filter(|step| self.size(step) > SETTLED);
            step.or_else(|| self.pushed(&tangent.free, &force, SHAKEN))
        })
    }

    /// The coordinate that may rest elsewhere, because rounding hides the stiffness that holds it, or the force that drives it.
    pub(crate) fn hidden(&self, mechanism: &dyn Differentiable) -> Option<usize> {
        let (tangent, force, (_, errors)) = (self.tangent()?, self.force(), self.stiffness());
        let may_be_held = |direction: &DVector<f64>| {
            let direction = direction / self.size(direction);
            let least = direction.abs().dot(&(&errors * direction.abs()));
            direction.dot(&force).abs() <= FAR * least
        };
        // Where a force fades the step is long and nothing rounds.
        let mut accelerations = self.accelerations.iter().zip(&self.sizes);
        let is_short = tangent.step(&force).is_none_or(|step| self.size(&step) <= SETTLED);
        let is_rounding = is_short || accelerations.any(|(part, size)| part.abs() > AT_REST * size);
        let pushed = self.pushed(&tangent.free, &force, AT_REST).filter(may_be_held);
        let driven = || self.driven(mechanism, &tangent).filter(|_| is_rounding && self.is_at_rest());
        pushed.or_else(driven).map(|direction| self.leading(&direction))
    }

    /// The coordinate with the largest part in a step.
    fn leading(&self, step: &DVector<f64>) -> usize {
        let parts = self.parts(step).enumerate();
        parts.max_by(|(_, a), (_, b)| a.total_cmp(b)).map_or(0, |(j, _)| j)
    }

    /// A change that leads down, and whether Newton's step does too, that is, whether no direction is unstable.
    ///
    /// The margin is a fraction of the least stiffness, so that what is soft moves beside what is stiff.
    pub(crate) fn descent(&self, stiffer: f64) -> (DVector<f64>, bool) {
        let (force, (stiffness, _)) = (self.force(), self.stiffness());
        let symmetric = (&stiffness + stiffness.transpose()) / 2.0;
        let rates = self.root.solve_lower_triangular(&symmetric);
        let rates = rates.and_then(|half| self.root.solve_lower_triangular(&half.transpose()));
        let eigen = rates.and_then(|rates| SymmetricEigen::try_new(rates, f64::EPSILON, MOST_SWEEPS));
        let Some(eigen) = eigen else { return (force, false) };
        let (largest, size) = (eigen.eigenvalues.max(), eigen.eigenvalues.amax());
        let added = largest.max(0.0) + stiffer * largest.abs() + REGULAR * size;
        let added = if size > 0.0 { added } else { 1.0 };
        let step = (&self.mass * added - stiffness).lu().solve(&force);
        (step.unwrap_or(force), largest <= NEUTRAL * size)
    }

    /// Whether constraints leave it no freedom.
    pub(crate) fn is_rigid(&self) -> bool {
        self.reduction.independent_speeds().is_empty()
    }

    /// The end of a step, and the force there with the mass matrix here.
    ///
    /// # Errors
    /// If the constraints cannot be met there; as the right-hand side.
    pub(crate) fn moved(
        &self,
        mechanism: &dyn Differentiable,
        step: &DVector<f64>,
    ) -> Result<(Vec<f64>, DVector<f64>), Failure> {
        let change = self.reduction.by_speeds() * step;
        let mut q: Vec<f64> = self.q.iter().zip(&change).map(|(q, change)| q + change).collect();
        let mut still = vec![0.0; q.len()];
        self.reduction.follow(mechanism, 0.0, (&mut q, &mut still))?;
        let accelerations = mechanism.accelerate(At::moving(0.0, &q, &[]))?;
        let force = &self.mass * accelerations.select_rows(self.reduction.independent_speeds());
        Ok((q, force))
    }

    /// Whether nothing accelerates.
    pub(crate) fn is_at_rest(&self) -> bool {
        (0..self.q.len()).all(|i| self.accelerations[i].abs() <= AT_REST * self.sizes[i] + self.rounding(i))
    }

    /// What the rounding of positions makes of an acceleration.
    fn rounding(&self, i: usize) -> f64 {
        let independent = self.reduction.independent().iter().enumerate();
        let of = |(k, j): (usize, &usize)| self.by_positions[(i, k)].abs() * (self.q[*j].abs() + self.sizes[*j]);
        ROUNDINGS * f64::EPSILON * independent.map(of).sum::<f64>()
    }

    /// The same of the force.
    fn rounding_of_force(&self) -> DVector<f64> {
        let speeds = self.reduction.independent_speeds();
        self.mass.abs() * DVector::from_fn(speeds.len(), |k, _| self.rounding(speeds[k]))
    }

    /// Refuses a position where a speed moves next to nothing, in the scales of the start.
    ///
    /// # Errors
    /// [`What::Singular`] there.
    pub(crate) fn check_inertia(&self, mechanism: &dyn Differentiable) -> Result<(), Failure> {
        super::check_inertia(mechanism, At::moving(0.0, &self.q, &[]), &self.reduction, &self.sizes)
    }

    /// The coordinate with the largest acceleration, and this, in SI units.
    pub(crate) fn largest_acceleration(&self) -> (usize, f64) {
        let sizes = self.accelerations.iter().map(|acceleration| acceleration.abs()).enumerate();
        sizes.max_by(|(_, a), (_, b)| a.total_cmp(b)).unwrap_or_default()
    }

    /// The failure that names the singular position beside this one in the direction of Newton's step, if there is one.
    pub(crate) fn singular_nearby(&self, mechanism: &dyn Differentiable) -> Option<Failure> {
        let step = self.newton_step().unwrap_or_else(|| self.force());
        let direction = self.reduction.by_speeds() * &step / self.size(&step);
        self.reduction.singular_along(mechanism, 0.0, &self.q, &direction, NEARBY)
    }
}
