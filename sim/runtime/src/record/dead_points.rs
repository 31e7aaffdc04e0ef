//! Dead points that a run passes, from dense output.
//!
//! With one degree of freedom the independent speed is, by Cramer's rule, the determinant of C_qd times the speed along
//! the curve: only a product of speeds is computed until its sign changes. A position where C_q itself loses rank is
//! singular, not dead. The mass matrix makes columns comparable.

use crate::integrate::Step;
use crate::motion::mobility::Mobility;
use crate::numerics::root::find_root;
use crate::state::failure::Failure;
use crate::state::trajectory::State;
use sim_kernel::{Array, Mechanism, Start};

/// A dead point that a motion has passed: here the independent coordinates do not determine the others, which continue
/// on another branch: a knee bent to one side is then bent to the other.
#[derive(Clone, Debug)]
pub struct DeadPoint<M: Mechanism> {
    /// The independent coordinates.
    pub of: Vec<&'static str>,
    /// When and where, from dense output.
    pub state: State<M>,
}

/// A pivot this small, relative to its rows, is zero.
const SINGULAR: f64 = 1e-10;
/// With more rows a determinant at every step would cost as much as the step.
const MOST_ROWS: usize = 12;

/// Searches dead points, step by step.
pub(super) struct DeadPoints<M: Mechanism> {
    pub(super) found: Vec<DeadPoint<M>>,
    names: Vec<&'static str>,
    independent: Vec<usize>,
    /// The independent rows of C_q, and the columns of all other coordinates.
    rows: Vec<usize>,
    columns: Vec<usize>,
    /// The scales that make columns comparable: moving any coordinate at its unit of speed takes equal energy.
    scales: M::Q,
    /// Whether one speed suffices: with one degree of freedom and constraints without explicit time, it is a multiple
    /// of the determinant, by Cramer's rule.
    is_told_by_speed: bool,
    /// The determinant where it was last known.
    last: Option<f64>,
    /// The power of the unit that determinants are taken in: that of the first.
    units: Option<i32>,
    /// Whether it has been unknown since.
    is_unknown: bool,
    /// The places of pivots.
    order: [Vec<usize>; 2],
}

impl<M: Mechanism> DeadPoints<M> {
    /// For a motion that starts there; `None` if no dead points can be found.
    pub(super) fn new(mechanism: &M, start: &State<M>, mobility: &Mobility) -> Option<DeadPoints<M>> {
        let description = mechanism.description();
        let is_plain = description.conditionals.is_empty()
            && description.norm_constraints.is_empty()
            && description.speed_constraints.is_empty();
        let (n, freedoms) = (mechanism.n(), mobility.degrees_of_freedom);
        let given = (0..n).filter(|j| description.coordinates[*j].start == Start::Given);
        let independent: Vec<usize> = given.take(freedoms).collect();
        let constraints = description.constraints.iter().enumerate();
        let rows = constraints.filter(|(_, c)| !mobility.dependent.contains(&c.name)).map(|(row, _)| row);
        let (rows, columns): (Vec<usize>, Vec<usize>) =
            (rows.collect(), (0..n).filter(|j| !independent.contains(j)).collect());
        // Constraints may stand still for an instant, but not at two.
        let stands =
            |time: f64| mechanism.constraint_time_derivative(time, &start.positions).iter().all(|rate| *rate == 0.0);
        let is_told_by_speed = freedoms == 1 && stands(start.time + 0.37) && stands(start.time + 0.83);
        let is_sought =
            !rows.is_empty() && independent.len() == freedoms && freedoms > 0 && rows.len() == columns.len();
        if !is_plain || !is_sought || !(is_told_by_speed || rows.len() <= MOST_ROWS) {
            return None;
        }
        let mass = mechanism.mass_matrix(start.time, &start.positions);
        let scales = M::Q::with_len(mechanism.n(), |j| if mass[j][j] > 0.0 { mass[j][j].sqrt().recip() } else { 1.0 });
        let names = independent.iter().map(|j| description.coordinates[*j].position.name).collect();
        let order = [rows.clone(), columns.clone()];
        let (found, last, units, is_unknown) = (Vec::new(), None, None, true);
        Some(DeadPoints {
            found,
            names,
            independent,
            rows,
            columns,
            scales,
            is_told_by_speed,
            last,
            units,
            is_unknown,
            order,
        })
    }

    /// Restarts after an event has changed the motion.
    pub(super) fn restart(&mut self) {
        (self.last, self.is_unknown) = (None, true);
    }

    /// Searches a step up to a time.
    ///
    /// # Errors
    /// As dense output.
    #[inline]
    pub(super) fn watch(&mut self, step: &mut Step<M>, until: f64) -> Result<(), Failure> {
        if self.is_told_by_speed && !self.is_unknown {
            let speed = |state: &State<M>| state.speeds[self.independent[0]];
            // In the same direction at both ends.
            if speed(&step.from.state) * speed(&step.to.state) > 0.0 {
                return Ok(());
            }
        }
        self.look(step, until)
    }

    fn look(&mut self, step: &mut Step<M>, until: f64) -> Result<(), Failure> {
        let mechanism = step.motion.mechanism();
        if self.last.is_none() || self.is_told_by_speed {
            self.note(mechanism, &step.from.state);
        }
        let end = if until < step.to.state.time { step.at(until)? } else { step.to.state.clone() };
        let (before, was_unknown) = (self.last, self.is_unknown);
        self.note(mechanism, &end);
        let (Some(before), Some(after), false) = (before, self.last, self.is_unknown) else { return Ok(()) };
        if before * after > 0.0 {
            return Ok(());
        }
        let (from, length) = (step.from.state.time, end.time - step.from.state.time);
        let state = match was_unknown {
            true => step.from.state.clone(),
            false => {
                let tolerance = crate::events::tolerance(end.time, length) / length;
                let mut value = |fraction: f64| {
                    let state = step.at(from + fraction * length)?;
                    Ok::<f64, Failure>(self.determinant(mechanism, &state).0)
                };
                let fraction = find_root(before, after, tolerance, &mut value)?;
                step.at(from + fraction * length)?
            }
        };
        if self.has_full_rank(mechanism, &state) {
            self.found.push(DeadPoint { of: self.names.clone(), state });
        }
        Ok(())
    }

    /// Records the determinant at a state, unless a pivot is nearly zero: then it has no sign. With many rows it is small
    /// everywhere.
    fn note(&mut self, mechanism: &M, state: &State<M>) {
        let (value, least) = self.determinant(mechanism, state);
        self.is_unknown = !(least > SINGULAR);
        self.last = if self.is_unknown { self.last } else { Some(value) };
    }

    /// det C_qd relative to the lengths of the rows of C_q, times a power of two that is the same at all states, and the
    /// least of its pivots.
    fn determinant(&mut self, mechanism: &M, state: &State<M>) -> (f64, f64) {
        self.order[1].clone_from(&self.columns);
        let Pivots { product, units, least } = self.pivots(mechanism, state);
        let units = *self.units.get_or_insert(units) - units;
        (product * UNIT.powi(units), least)
    }

    /// Whether the rows of C_q do not depend on each other.
    fn has_full_rank(&mut self, mechanism: &M, state: &State<M>) -> bool {
        self.order[1] = (0..mechanism.n()).collect();
        self.pivots(mechanism, state).least > SINGULAR.sqrt()
    }

    /// The pivots of these columns, by complete pivoting, of rows of length 1.
    fn pivots(&mut self, mechanism: &M, state: &State<M>) -> Pivots {
        self.order[0].clone_from(&self.rows);
        let [rows, columns] = &mut self.order;
        let mut c = mechanism.constraint_jacobian(state.time, &state.positions);
        for row in rows.iter() {
            (0..state.positions.len()).for_each(|j| c[*row][j] *= self.scales[j]);
            let length = c[*row].iter().map(|entry| entry * entry).sum::<f64>().sqrt();
            (0..state.positions.len()).for_each(|j| c[*row][j] /= length);
        }
        let mut found = Pivots { product: 1.0, units: 0, least: f64::INFINITY };
        for k in 0..rows.len() {
            let places = (k..rows.len()).flat_map(|i| (k..columns.len()).map(move |j| (i, j)));
            let size = |(i, j): &(usize, usize)| c[rows[*i]][columns[*j]].abs();
            let Some((i, j)) = places.max_by(|a, b| size(a).total_cmp(&size(b))) else {
                return Pivots { product: 0.0, units: 0, least: 0.0 };
            };
            let is_even = (i == k) == (j == k);
            rows.swap(i, k);
            columns.swap(j, k);
            let pivot = c[rows[k]][columns[k]];
            found.times(if is_even { pivot } else { -pivot });
            for row in &rows[k + 1..] {
                let factor = c[*row][columns[k]] / pivot;
                for column in &columns[k + 1..] {
                    let change = factor * c[rows[k]][*column];
                    c[*row][*column] -= change;
                }
            }
        }
        found
    }
}

/// The pivots of a matrix.
struct Pivots {
    /// Their product with the sign of their order, times a power of `UNIT`: of many rows it would be too small a number.
    product: f64,
    /// That power.
    units: i32,
    /// The least of them.
    least: f64,
}

/// A power of two, so that it costs no digits.
const UNIT: f64 = (1u128 << 100) as f64;

impl Pivots {
    /// With another one; its sign counts for the product alone.
    fn times(&mut self, pivot: f64) {
        self.least = self.least.min(pivot.abs());
        self.product *= pivot;
        if self.product.abs() < 1.0 / UNIT {
            self.product *= UNIT;
            self.units += 1;
        }
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    /// A thousand pivots of 0.3 make 1e-523, which is no number; the sign of the last one tells on which side of a dead point it is.
    #[test]
    fn products_of_many_pivots_keep_sign_and_digits() {
        let product = |last: f64| {
            let mut found = Pivots { product: 1.0, units: 0, least: f64::INFINITY };
            (0..1000).map(|_| 0.3).chain([last]).for_each(|pivot| found.times(pivot));
            found
        };
        let [before, after] = [0.5, -0.25].map(product);
        assert_eq!((before.units, before.least, after.least), (after.units, 0.3, 0.25));
        assert_eq!(before.product, -2.0 * after.product);
        // The logarithm has lost three digits.
        let log = before.product.log2() - 100.0 * f64::from(before.units);
        assert!((log - (1000.0 * 0.3f64.log2() - 1.0)).abs() < 1e-10, "{log}");
    }
}
