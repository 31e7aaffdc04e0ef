//! The equations of motion of one mechanism, and how its states are kept on the constraints.

use crate::conditional::released_rows;
use crate::failure::{Failure, What, constraint_name, largest};
use crate::gimbal;
use crate::least_norm::least_norm;
use crate::partition::Partition;
use crate::project::{by_mass, project, project_measured, rates};
use crate::settings::Stabilisation;
use crate::singular::{AT, weakest_constraint};
use crate::solve::{Solved, solve};
use crate::trajectory::{Sample, State};
use sim_kernel::{Array, Dynamics, Mechanism};
use std::cell::{Cell, RefCell};

/// A mechanism in motion: its right-hand side, its stabilisation, and what they have been asked.
#[derive(Debug)]
pub struct Motion<'m, M: Mechanism> {
    mechanism: &'m M,
    prepared: M::Prepared,
    stabilisation: Stabilisation,
    partition: RefCell<Partition>,
    /// How many constraints depend on others everywhere, or are released.
    redundant: usize,
    evaluations: Cell<u64>,
    /// The squares of the longest rows of C_q so far.
    longest: Cell<M::L>,
    /// 1/s^2 where a state was last kept on the constraints; s is the smallest sine between a row of C_q and those before.
    closeness: Cell<f64>,
    /// Whether states inside a step are brought onto the constraints too.
    keeps_stages: Cell<bool>,
}

impl<'m, M: Mechanism> Motion<'m, M> {
    /// The motion of a mechanism, kept on its constraints in this way.
    pub fn new(mechanism: &'m M, stabilisation: Stabilisation) -> Motion<'m, M> {
        Motion::with_redundant(mechanism, stabilisation, 0)
    }

    /// The same where so many constraints depend on others everywhere.
    pub fn with_redundant(mechanism: &'m M, stabilisation: Stabilisation, redundant: usize) -> Motion<'m, M> {
        let partition = RefCell::new(Partition::default());
        Motion {
            mechanism,
            prepared: mechanism.prepare(),
            stabilisation,
            partition,
            redundant: redundant + released_rows(mechanism),
            evaluations: Cell::new(0),
            longest: Cell::new(M::L::filled(0.0)),
            closeness: Cell::new(0.0),
            keeps_stages: Cell::new(false),
        }
    }

    /// The mechanism.
    pub fn mechanism(&self) -> &'m M {
        self.mechanism
    }

    /// How many right-hand sides have been evaluated.
    pub fn evaluations(&self) -> u64 {
        self.evaluations.get()
    }

    /// The right-hand side at a state inside a step. Where only independent coordinates are integrated, the others
    /// are first made to follow.
    ///
    /// # Errors
    /// As [`accelerate`], and as the solution of the constraints.
    #[inline(always)]
    pub fn sample(&self, mut state: State<M>) -> Result<Sample<M>, Failure> {
        self.evaluations.set(self.evaluations.get() + 1);
        if self.stabilisation == Stabilisation::Partitioning {
            self.partition.borrow().follow(self.mechanism, &mut state)?;
        } else if self.keeps_stages.get() {
            self.keep_stage(&mut state)?;
        }
        let mut dynamics =
            solve_equations(self.mechanism, &self.prepared, state.time, &state.positions, &state.speeds)?;
        if let Stabilisation::Baumgarte(rate) = self.stabilisation {
            let push = baumgarte(self.mechanism, &state, rate)?;
            dynamics.accelerations = M::Q::from_fn(|i| dynamics.accelerations[i] - push[i]);
        }
        Ok(Sample::new(state, &dynamics, self.mechanism.inputs()))
    }

    #[cold]
    fn keep_stage(&self, state: &mut State<M>) -> Result<(), Failure> {
        project(self.mechanism, state, self.redundant)
    }

    /// d(q'')/dq and d(q'')/dq' at a sample: the generated kernel, or difference quotients where that refuses a pivot or is
    /// not what is integrated.
    ///
    /// # Errors
    /// As the right-hand side.
    pub fn jacobian(&self, at: &Sample<M>) -> Result<(M::QQ, M::QQ), Failure> {
        let state = &at.state;
        let generated = self.mechanism.dynamics_jacobian(state.time, &state.positions, &state.speeds);
        let is_wanted = matches!(self.stabilisation, Stabilisation::Projection | Stabilisation::MassProjection);
        if is_wanted && !generated.refused {
            return Ok((generated.accelerations_by_positions, generated.accelerations_by_speeds));
        }
        self.difference_quotients(at)
    }

    #[cold]
    fn difference_quotients(&self, at: &Sample<M>) -> Result<(M::QQ, M::QQ), Failure> {
        let zero = M::QQ::filled(M::Q::filled(0.0));
        let (mut by_positions, mut by_speeds) = (zero, zero);
        for j in 0..M::Q::LEN {
            let (mut moved, mut hastened) = (at.state, at.state);
            let step = |x: f64| f64::EPSILON.sqrt() * x.abs().max(1.0);
            let steps = [step(moved.positions[j]), step(hastened.speeds[j])];
            moved.positions[j] += steps[0];
            hastened.speeds[j] += steps[1];
            let [moved, hastened] = [self.sample(moved)?.accelerations, self.sample(hastened)?.accelerations];
            for i in 0..M::Q::LEN {
                by_positions[i][j] = (moved[i] - at.accelerations[i]) / steps[0];
                by_speeds[i][j] = (hastened[i] - at.accelerations[i]) / steps[1];
            }
        }
        Ok((by_positions, by_speeds))
    }

    /// Brings the end of a step, or a point inside it, onto the constraints.
    ///
    /// # Errors
    /// As the projection.
    #[inline]
    pub fn keep(&self, state: &mut State<M>) -> Result<(), Failure> {
        match self.stabilisation {
            Stabilisation::Projection => {
                self.closeness.set(project_measured(self.mechanism, state, self.redundant, &self.longest)?);
                return Ok(());
            }
            Stabilisation::MassProjection => by_mass(self.mechanism, state)?,
            Stabilisation::Partitioning => self.partition.borrow().follow(self.mechanism, state)?,
            Stabilisation::Baumgarte(_) | Stabilisation::None => {}
        }
        self.closeness.set(weakest_constraint(self, state).map_or(0.0, |(_, sine)| sine.powi(-2)));
        Ok(())
    }

    /// The smallest sine between a row of C_q and those before it, where a state was last kept on the constraints.
    #[inline]
    pub(crate) fn least_sine(&self) -> f64 {
        1.0 / self.closeness.get().sqrt()
    }

    /// Whether that state was known better before it was kept, so near is a singular position.
    pub(crate) fn is_at_singularity(&self) -> bool {
        self.closeness.get() > const { 1.0 / (AT * AT) }
    }

    /// Has states inside a step brought onto the constraints too, or no longer.
    pub(crate) fn keep_stages(&self, keeps: bool) {
        self.keeps_stages
            .set(keeps && matches!(self.stabilisation, Stabilisation::Projection | Stabilisation::MassProjection));
    }

    /// The squares of the longest rows of C_q so far.
    pub(crate) fn longest(&self) -> M::L {
        self.longest.get()
    }

    /// Takes note of the squares of the lengths of rows.
    pub(crate) fn lengthen(&self, square: impl Fn(usize) -> f64) {
        let longest = self.longest.get();
        self.longest.set(M::L::from_fn(|row| longest[row].max(square(row))));
    }

    /// Makes ready for a step from a state: chooses independent coordinates again if the choice has aged.
    ///
    /// # Errors
    /// If no choice determines the motion.
    #[inline]
    pub fn prepare(&self, state: &State<M>) -> Result<(), Failure> {
        match self.stabilisation {
            Stabilisation::Partitioning => self.partition.borrow_mut().renew(self.mechanism, state),
            _ => Ok(()),
        }
    }
}

/// What Baumgarte's method takes from the accelerations: x with [M C_q'; C_q 0] [x; .] = [0; 2 a C' + a^2 C].
#[cold]
fn baumgarte<M: Mechanism>(mechanism: &M, state: &State<M>, rate: f64) -> Result<M::Q, Failure> {
    let linear = mechanism.constraint_linearization(state.time, &state.positions);
    let speeds = rates::<M>(&linear, &state.speeds);
    let open = M::L::from_fn(|i| 2.0 * rate * speeds[i] + rate * rate * linear.values[i]);
    by_inertia(mechanism, state.time, &state.positions, &linear.jacobian, &open)
}

/// M^-1 C_q' (C_q M^-1 C_q')^-1 r: the change of speeds that an impulse along the constraints makes to change their
/// rates by r.
pub(crate) fn by_inertia<M: Mechanism>(
    mechanism: &M,
    time: f64,
    q: &M::Q,
    jacobian: &M::LQ,
    residual: &M::L,
) -> Result<M::Q, Failure> {
    Ok(impulse(mechanism, time, q, jacobian, residual)?.0)
}

/// That change, and the impulse that makes it: x and y with [M C_q'; C_q 0] [x; y] = [0; r].
pub(crate) fn impulse<M: Mechanism>(
    mechanism: &M,
    time: f64,
    q: &M::Q,
    jacobian: &M::LQ,
    residual: &M::L,
) -> Result<(M::Q, M::L), Failure> {
    let matrix = saddle::<M>(&mechanism.mass_matrix(time, q), jacobian);
    let n = M::Q::LEN;
    let rhs = M::Z::from_fn(|i| if i < n { 0.0 } else { residual[i - n] });
    let solution = solve_motion::<M>(matrix, rhs, time, q)?;
    Ok((M::Q::from_fn(|i| solution.solution[i]), M::L::from_fn(|i| solution.solution[n + i])))
}

/// [M C_q'; C_q 0].
fn saddle<M: Mechanism>(mass: &M::QQ, jacobian: &M::LQ) -> M::ZZ {
    let n = M::Q::LEN;
    let entry = |i: usize, j: usize| match (i < n, j < n) {
        (true, true) => mass[i][j],
        (true, false) => jacobian[j - n][i],
        (false, true) => jacobian[i - n][j],
        (false, false) => 0.0,
    };
    M::ZZ::from_fn(|i| M::Z::from_fn(|j| entry(i, j)))
}

/// Solves for accelerations and multipliers. Reactions that no equation determines, because their constraints say
/// what others say already, are zero here.
fn solve_motion<M: Mechanism>(matrix: M::ZZ, rhs: M::Z, time: f64, q: &M::Q) -> Result<Solved<M::Z>, Failure> {
    let fail = |unknown: usize| Failure::at::<M>(What::Singular { unknown: unknown_name::<M>(unknown) }, time, q);
    let solved = solve(matrix, rhs);
    let undetermined = || solved.undetermined();
    match undetermined().find(|unknown| *unknown < M::Q::LEN) {
        Some(acceleration) => Err(fail(acceleration)),
        None if !solved.is_consistent => Err(fail(undetermined().next().unwrap_or(0))),
        None => Ok(solved),
    }
}

/// Accelerations, multipliers and power at a state, by the generated elimination; where that refuses a pivot, by
/// complete pivoting on the mass matrix and the constraint Jacobian. Where constraints depend on each other the multipliers
/// are those of least norm, in SI units.
///
/// # Errors
/// [`What::Singular`] if no unique solution exists, [`What::NotFinite`] if an expression leaves its domain.
#[inline]
pub fn accelerate<M: Mechanism>(
    mechanism: &M,
    time: f64,
    q: &M::Q,
    qd: &M::Q,
) -> Result<Dynamics<f64, M::Q, M::L>, Failure> {
    solve_equations(mechanism, &mechanism.prepare(), time, q, qd)
}

#[inline]
fn solve_equations<M: Mechanism>(
    mechanism: &M,
    prepared: &M::Prepared,
    time: f64,
    q: &M::Q,
    qd: &M::Q,
) -> Result<Dynamics<f64, M::Q, M::L>, Failure> {
    let solved = M::prepared_dynamics(prepared, time, q, qd);
    if !solved.refused && is_finite(&solved) {
        return Ok(solved);
    }
    accelerate_by_pivoting(mechanism, time, q, qd)
}

/// Whether all of a solution is.
#[inline(always)]
fn is_finite<Q: Array<f64>, L: Array<f64>>(solved: &Dynamics<f64, Q, L>) -> bool {
    let values = solved.accelerations.iter().chain(solved.multipliers.iter());
    values.chain([&solved.power]).all(|value| value.is_finite())
}

#[cold]
fn accelerate_by_pivoting<M: Mechanism>(
    mechanism: &M,
    time: f64,
    q: &M::Q,
    qd: &M::Q,
) -> Result<Dynamics<f64, M::Q, M::L>, Failure> {
    let fail = |what| Failure::at::<M>(what, time, q);
    let (n, m) = (M::Q::LEN, M::L::LEN);
    let mass = mechanism.mass_matrix(time, q);
    let jacobian = mechanism.constraint_jacobian(time, q);
    let (force, convective) = (mechanism.generalized_forces(time, q, qd), mechanism.convective_forces(time, q, qd));
    let constraint_convective = mechanism.constraint_convective(time, q, qd);
    let matrix = saddle::<M>(&mass, &jacobian);
    let rhs = M::Z::from_fn(|i| if i < n { force[i] - convective[i] } else { -constraint_convective[i - n] });
    // Constraints first: what is wrong with them spoils the equations of the coordinates too.
    let is_sound = |row: &usize| matrix[*row].iter().sum::<f64>().is_finite() && rhs[*row].is_finite();
    if let Some(row) = (n..n + m).chain(0..n).find(|row| !is_sound(row)) {
        let quantity = match row < n {
            true => format!("the equation of {}", unknown_name::<M>(row)),
            false => format!("constraint `{}`", constraint_name::<M>(row - n)),
        };
        return Err(fail(What::NotFinite { quantity }));
    }
    let solved = solve_motion::<M>(matrix, rhs, time, q);
    let solved = solved.map_err(|failure| gimbal::explained(failure, mechanism, time, q))?;
    let accelerations = M::Q::from_fn(|i| solved.solution[i]);
    let mut multipliers = M::L::from_fn(|i| solved.solution[n + i]);
    let undetermined = solved.undetermined().count();
    if undetermined > 0 {
        multipliers = least_norm::<M>(jacobian, &multipliers, m - undetermined);
    }
    let power = mechanism.power(time, q, qd, &accelerations, &multipliers);
    if !power.is_finite() {
        return Err(fail(What::NotFinite { quantity: "the power of the loads".into() }));
    }
    Ok(Dynamics { accelerations, multipliers, power, refused: false })
}

fn unknown_name<M: Mechanism>(unknown: usize) -> String {
    match M::DESCRIPTION.coordinates.get(unknown) {
        Some(coordinate) => format!("the acceleration of `{}`", coordinate.position.name),
        None => format!("the reaction of `{}`", constraint_name::<M>(unknown - M::Q::LEN)),
    }
}

/// The largest magnitudes of C and of C_q q' + C_t at a state.
pub fn residuals<M: Mechanism>(mechanism: &M, state: &State<M>) -> (f64, f64) {
    let linear = mechanism.constraint_linearization(state.time, &state.positions);
    let rates = rates::<M>(&linear, &state.speeds);
    let size = |values: &M::L| largest(values.iter()).map_or(0.0, |(_, value)| value.abs());
    (size(&linear.values), size(&rates))
}
