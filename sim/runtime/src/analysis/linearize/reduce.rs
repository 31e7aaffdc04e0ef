//! From changes of the independent coordinates and speeds to those of all.

use super::split::{Split, Wanted};
use crate::model::{At, Differentiable, constants};
use crate::motion::lengths::measure;
use crate::motion::mobility::{Mobility, mobility_of};
use crate::state::failure::{Failure, What};
use nalgebra::{Complex, DMatrix, DVector};
use sim_kernel::{Description, Dual, Start};

/// Newton steps after which the dependent coordinates are given up; from nearby it takes three or four.
const MOST_STEPS: usize = 20;
/// A state this close to a singular position, in the scales of the coordinates, counts as singular: rounding of 1e-16
/// is amplified by the square of the distance.
const BESIDE: f64 = 1e-6;
/// The step of the differences used to search for such a position.
const STEP: f64 = 1e-4;

/// dq = H dq_i, dq' = N dq_i' + S dq_i. Where constraints hold between speeds alone there are more independent coordinates
/// than independent speeds; elsewhere H is N.
pub(crate) struct Reduction {
    of_positions: Split,
    of_speeds: Split,
    /// H, n x h.
    by_positions: DMatrix<f64>,
    /// S, n x h.
    speeds_by_positions: DMatrix<f64>,
    /// N, n x f.
    by_speeds: DMatrix<f64>,
}

impl Reduction {
    /// # Errors
    /// [`What::SingularState`] in a singular position, or so close to one that rounding decides.
    pub(crate) fn at(mechanism: &dyn Differentiable, at: At<f64>) -> Result<Reduction, Failure> {
        let (n, freedoms) = (at.positions.len(), mobility_of(mechanism, at.time, at.positions));
        if let Some(failure) = singular(mechanism, at.time, at.positions, &freedoms) {
            return Err(failure);
        }
        let of_speeds = mechanism.constraint_jacobian(at.time, at.positions);
        let of_positions = mechanism.between_positions(of_speeds.clone());
        let wanted = wanted(mechanism.description());
        let sizes = measure(mechanism, at.time, at.positions).0;
        let moves = Split::new(&of_positions, n - freedoms.configuration_freedom, &wanted, &sizes);
        let rates = Split::new(&of_speeds, n - freedoms.degrees_of_freedom, &wanted, &sizes);
        let found = Reduction::of(mechanism, at, moves, rates);
        for direction in found.by_positions.column_iter() {
            let size = direction.iter().zip(&sizes).fold(0.0, |size: f64, (part, of)| size.max((part / of).abs()));
            match found.singular_along(mechanism, at.time, at.positions, &(direction / size), BESIDE) {
                Some(failure) => return Err(failure),
                None => continue,
            }
        }
        Ok(found)
    }

    /// The same coordinates at another state.
    pub(super) fn moved(&self, mechanism: &dyn Differentiable, at: At<f64>) -> Reduction {
        Reduction::of(mechanism, at, self.of_positions.clone(), self.of_speeds.clone())
    }

    fn of(mechanism: &dyn Differentiable, at: At<f64>, moves: Split, rates: Split) -> Reduction {
        let (n, jacobian) = (at.positions.len(), mechanism.constraint_jacobian(at.time, at.positions));
        let none = |columns: usize| DMatrix::zeros(jacobian.nrows(), columns);
        let [h, f] = [&moves, &rates].map(|split| split.independent.len());
        let by_positions = moves.complete(&mechanism.between_positions(jacobian.clone()), moves.units(n), &none(h));
        let bent = rates_by_positions(mechanism, at) * &by_positions;
        Reduction {
            speeds_by_positions: rates.complete(&jacobian, DMatrix::zeros(n, h), &bent),
            by_speeds: rates.complete(&jacobian, rates.units(n), &none(f)),
            by_positions,
            of_positions: moves,
            of_speeds: rates,
        }
    }

    /// The independent coordinates, h of them.
    pub(crate) fn independent(&self) -> &[usize] {
        &self.of_positions.independent
    }

    /// The independent speeds, f of them.
    pub(crate) fn independent_speeds(&self) -> &[usize] {
        &self.of_speeds.independent
    }

    /// N, n x f.
    pub(super) fn by_speeds(&self) -> &DMatrix<f64> {
        &self.by_speeds
    }

    /// The failure that names the singular position beside this one in a direction, if one is within reach: where a
    /// pivot in the solution for dependent speeds changes its sign.
    pub(super) fn singular_along(
        &self,
        mechanism: &dyn Differentiable,
        time: f64,
        q: &[f64],
        direction: &DVector<f64>,
        reach: f64,
    ) -> Option<Failure> {
        let moved = |way: f64| -> Vec<f64> { q.iter().zip(direction).map(|(q, part)| q + way * part).collect() };
        let pivots = |way: f64| self.of_speeds.pivot_values(&mechanism.constraint_jacobian(time, &moved(way)));
        let (mut way, mut step) = (0.0, STEP);
        // Three steps of the secant method square the error three times.
        for _ in 0..3 {
            let roots = pivots(way).into_iter().zip(pivots(way + step)).map(|(a, b)| -a * step / (b - a));
            step = roots.filter(|root| root.is_finite()).min_by(|a, b| a.abs().total_cmp(&b.abs()))?;
            way += step;
            if !(way.abs() <= reach) {
                return None;
            }
            if step.abs() <= f64::EPSILON {
                break;
            }
        }
        let q = moved(way);
        singular(mechanism, time, &q, &mobility_of(mechanism, time, &q))
    }

    /// The change of positions and speeds with entry k of x.
    pub(super) fn change(&self, k: usize) -> (DVector<f64>, DVector<f64>) {
        let h = self.independent().len();
        match k < h {
            true => (self.by_positions.column(k).into(), self.speeds_by_positions.column(k).into()),
            false => (DVector::zeros(self.by_positions.nrows()), self.by_speeds.column(k - h).into()),
        }
    }

    /// The change of all coordinates in a mode.
    pub(super) fn positions(&self, x: &DVector<Complex<f64>>) -> DVector<Complex<f64>> {
        self.by_positions.map(|entry| Complex::new(entry, 0.0)) * x.rows(0, self.independent().len())
    }

    /// Makes the dependent coordinates and speeds follow from the independent ones.
    ///
    /// # Errors
    /// [`What::NotProjected`].
    pub(crate) fn follow(
        &self,
        mechanism: &dyn Differentiable,
        time: f64,
        (q, qd): (&mut [f64], &mut [f64]),
    ) -> Result<(), Failure> {
        let n = q.len();
        let column = |values: &[f64]| DMatrix::from_column_slice(values.len(), 1, values);
        let mut steps = 0;
        while self.of_positions.rank() > 0 {
            let linear = mechanism.constraint_linearization(time, q);
            let by_positions = mechanism.between_positions(linear.jacobian);
            let open = column(linear.values.as_slice());
            let change = self.of_positions.complete(&by_positions, DMatrix::zeros(n, 1), &open);
            q.iter_mut().zip(&change).for_each(|(q, change)| *q += change);
            steps += 1;
            // Once more after convergence, to reduce the error to rounding.
            if steps > 1 && mechanism.is_met(time, q) {
                break;
            }
            if steps == MOST_STEPS || !q.iter().all(|q| q.is_finite()) {
                let residual = linear.values.amax();
                let constraint = mechanism.constraint_name(linear.values.iamax());
                return Err(mechanism.failure(What::NotProjected { constraint, residual, iterations: steps }, time, q));
            }
        }
        let linear = mechanism.constraint_linearization(time, q);
        let mut own = DMatrix::zeros(n, 1);
        self.independent_speeds().iter().for_each(|j| own[*j] = qd[*j]);
        let speeds = self.of_speeds.complete(&linear.jacobian, own, &column(linear.time_derivative.as_slice()));
        qd.copy_from_slice(speeds.as_slice());
        Ok(())
    }
}

/// The failure of a singular position, if this is one.
fn singular(mechanism: &dyn Differentiable, time: f64, q: &[f64], freedoms: &Mobility) -> Option<Failure> {
    let constraint = freedoms.singular.first()?;
    Some(mechanism.failure(What::SingularState { constraint }, time, q))
}

/// Which coordinates should be independent: those whose speeds, and after them those whose values the declaration gives.
fn wanted(description: &Description) -> Vec<Wanted> {
    let of = |given: bool, speed_given: bool| match (given, speed_given) {
        (_, true) => Wanted::First,
        (true, false) => Wanted::Independent,
        (false, false) => Wanted::Dependent,
    };
    description.coordinates.iter().map(|c| of(c.start == Start::Given, c.speed_given)).collect()
}

/// (C_q q' + C_t)_q, m x n, by dual numbers.
fn rates_by_positions(mechanism: &dyn Differentiable, at: At<f64>) -> DMatrix<f64> {
    let (n, m) = (at.positions.len(), mechanism.description().constraints.len());
    let mut rates = DMatrix::zeros(m, n);
    for by in 0..n {
        let mut positions = constants(at.positions);
        positions[by] = Dual::variable(at.positions[by]);
        let moving = At::moving(Dual::constant(at.time), &positions, &[]);
        let [_, jacobian, time_derivative] = mechanism.constraints_along(moving, None);
        for i in 0..m {
            let turning = jacobian[n * i..n * (i + 1)].iter().zip(at.speeds).map(|(c, speed)| c.derivative * speed);
            rates[(i, by)] = turning.sum::<f64>() + time_derivative[i].derivative;
        }
    }
    rates
}
