//! Inverse dynamics: the forces that drives must exert for a prescribed motion.

use super::driven::Driven;
use super::sizes::Sizes;
use super::system::{Law, System};
use crate::model::At;
use crate::motion::typed::Any;
use crate::numerics::arrays::array;
use crate::state::failure::{Failure, What};
use crate::state::trajectory::{Sample, State};
use nalgebra::{DMatrix, DVector};
use sim_kernel::Mechanism;

/// The sine of the angle between a column of [C_q; y_q] and those before it that is zero: a division by it would leave
/// fewer than six digits.
const SINGULAR: f64 = 1e-10;

/// A motion that drives prescribe.
#[derive(Clone, Debug)]
pub struct Prescribed<M: Mechanism> {
    /// The state with its accelerations, and the reactions of the constraints; its power is that of loads and drives.
    pub sample: Sample<M>,
    /// The force of each drive on the mechanism, along its driven quantity: a torque in N*m for an angle, a force in N
    /// for a length.
    pub forces: Vec<f64>,
}

/// The same for a mechanism of any type, with a measure of how well the drives determine it.
pub(super) struct AnyPrescribed {
    /// p, which is the time unless time stands still.
    pub(super) parameter: f64,
    pub(super) time: f64,
    pub(super) positions: Vec<f64>,
    /// dq/dp: the speeds, unless the mechanism rests.
    pub(super) direction: Vec<f64>,
    /// Its part by time: the speeds with the drives at rest.
    pub(super) drift: Vec<f64>,
    pub(super) speeds: Vec<f64>,
    pub(super) accelerations: Vec<f64>,
    pub(super) multipliers: Vec<f64>,
    pub(super) power: f64,
    pub(super) forces: Vec<f64>,
    /// The volume that the columns of [C_q; y_q] span: |det| where it is square.
    pub(super) volume: f64,
    /// The length of each column of [C_q; y_q].
    pub(super) columns: Vec<f64>,
}

impl AnyPrescribed {
    pub(super) fn at(&self) -> At<'_, f64> {
        At {
            time: self.time,
            positions: &self.positions,
            speeds: &self.speeds,
            accelerations: &self.accelerations,
            multipliers: &self.multipliers,
        }
    }

    /// dy/ds of each output y that has a rate, where s is what is driven first, at fixed time: what moves with t does no virtual
    /// work.
    pub(super) fn ratios(&self, system: &System) -> Vec<f64> {
        let mut rates = self.rates(system, &self.direction);
        let by_time = self.rates(system, &self.drift);
        // Where an output has no slope, as a root at zero, nobody knows its part by time.
        let known = rates.iter_mut().zip(by_time).filter(|(_, by_time)| !by_time.is_nan());
        known.for_each(|(rate, by_time)| *rate -= by_time);
        rates
    }

    /// dy/ds of the same along the sweep, with what moves with t.
    pub(super) fn slopes(&self, system: &System) -> Vec<f64> {
        if system.rests { self.ratios(system) } else { self.rates(system, &self.direction) }
    }

    /// The rates of outputs at these speeds, relative to that of what is driven.
    fn rates(&self, system: &System, speeds: &[f64]) -> Vec<f64> {
        let rates = system.mechanism.output_rates(At { speeds, ..self.at() });
        rates.iter().map(|rate| rate / system.laws[0].rate).collect()
    }

    /// It with the power of loads and drives.
    pub(super) fn with_power(mut self, system: &System) -> AnyPrescribed {
        if system.rests {
            return self;
        }
        let driving: f64 = self.forces.iter().zip(&system.laws).map(|(force, law)| force * law.rate).sum();
        let multipliers = system.without_stand_ins(&self.multipliers);
        self.power = driving + system.mechanism.power(At { multipliers: &multipliers, ..self.at() });
        self
    }

    /// It as a sample of the mechanism's own type.
    pub(super) fn sample<M: Mechanism>(&self, mechanism: &M, work: f64) -> Sample<M> {
        let (positions, speeds) = (array(mechanism.n(), &self.positions), array(mechanism.n(), &self.speeds));
        Sample {
            state: State { time: self.time, positions, speeds, work },
            accelerations: array(mechanism.n(), &self.accelerations),
            multipliers: array(mechanism.m(), &self.multipliers),
            power: self.power,
            inputs: mechanism.inputs(),
        }
    }
}

/// The motion of a mechanism at a position, with a drive for each degree of freedom: drive k at the rate `rates[k]`,
/// which changes by `accelerations[k]`.
///
/// Speeds and accelerations solve [C_q; y_q] q' = [-C_t; rate - y_t] and its derivative; the drives' forces u are the
/// multipliers of their conditions, with the sign of a load: M q'' + C_q' lambda = Q - T_q' M g + y_q' u.
/// (de Jalón and Bayo, Kinematic and Dynamic Simulation of Multibody Systems, 1994, ch. 6.)
///
/// # Errors
/// [`What::NotDriven`] unless each degree of freedom has one drive; [`What::DriveSingular`] in a dead point of the drives;
/// [`What::NotOfPositions`], [`What::NotFinite`].
pub fn inverse_dynamics<M: Mechanism>(
    mechanism: &M,
    time: f64,
    q: &M::Q,
    drives: &[Driven],
    rates: &[f64],
    accelerations: &[f64],
) -> Result<Prescribed<M>, Failure> {
    let laws = drives.iter().zip(rates);
    let laws = laws.map(|(driven, rate)| Law { driven: *driven, start: 0.0, rate: *rate }).collect();
    let any = Any(mechanism);
    let (system, _) = System::new(&any, laws, q.as_ref())?;
    let system = system.running(system.laws.clone());
    let found = prescribed(&system, &Sizes::new(&system, q.as_ref(), 0.0), (q.as_ref(), time), accelerations)?;
    Ok(Prescribed { sample: found.sample(mechanism, 0.0), forces: found.forces })
}

/// The motion of a system at a position; omitted accelerations are zero.
///
/// # Errors
/// [`What::DriveSingular`] where the drives do not determine it, [`What::NotFinite`].
pub(super) fn prescribed(
    system: &System,
    sizes: &Sizes,
    (q, p): (&[f64], f64),
    accelerations: &[f64],
) -> Result<AnyPrescribed, Failure> {
    let linear = system.linear(q, p);
    let factors = Factors::new(&linear.jacobian, sizes);
    let singular = || system.singular(q, p);
    if !(factors.sine > SINGULAR) {
        return Err(singular());
    }
    let mut qd = factors.solve(&-linear.by_parameter).ok_or_else(singular)?;
    system.prescribe(|k| system.laws[k].rate, &mut qd);
    let direction = qd.as_slice().to_vec();
    let mut drift = factors.solve(&-linear.by_time).ok_or_else(singular)?;
    system.prescribe(|_| 0.0, &mut drift);
    let mut qdd = DVector::zeros(q.len());
    if system.rests {
        qd.fill(0.0);
    } else {
        let mut open = -system.convective(q, qd.as_slice(), p);
        accelerations.iter().enumerate().for_each(|(k, value)| open[system.rows.len() + k] += value);
        qdd = factors.solve(&open).ok_or_else(singular)?;
        system.prescribe(|k| accelerations.get(k).copied().unwrap_or(0.0), &mut qdd);
    }
    let rest = left_over(system, q, p, [&qd, &qdd])?;
    let (multipliers, reactions) = system.split(&factors.solve_transposed(&rest).ok_or_else(singular)?);
    let found = AnyPrescribed {
        parameter: p,
        time: system.time(p),
        positions: q.to_vec(),
        direction,
        drift: drift.as_slice().to_vec(),
        speeds: qd.as_slice().to_vec(),
        accelerations: qdd.as_slice().to_vec(),
        multipliers,
        power: 0.0,
        forces: reactions.iter().map(|reaction| -reaction).collect(),
        volume: factors.volume,
        columns: factors.columns,
    };
    Ok(found.with_power(system))
}

/// The force that loads leave for constraints and drives: Q - T_q' M g - M q''. At rest inertia has none, though g may have a
/// part by t.
fn left_over(system: &System, q: &[f64], p: f64, [qd, qdd]: [&DVector<f64>; 2]) -> Result<DVector<f64>, Failure> {
    let (mechanism, time) = (system.mechanism, system.time(p));
    let mut rest = mechanism.generalized_forces(time, q, qd.as_slice());
    if !system.rests {
        rest = rest - mechanism.convective_forces(time, q, qd.as_slice()) - mechanism.mass_matrix(time, q) * qdd;
    }
    match rest.iter().all(|value| value.is_finite()) {
        true => Ok(rest),
        false => Err(mechanism.failure(What::NotFinite { quantity: "a load".into() }, time, q)),
    }
}

/// [C_q; y_q], of full column rank and at least as high as wide, as Q R; and the same made dimensionless, which is more
/// accurate for solving.
pub(super) struct Factors<'a> {
    sizes: &'a Sizes,
    orthonormal: DMatrix<f64>,
    triangle: DMatrix<f64>,
    /// An orthonormal basis of the range of the matrix, unless that is the whole space.
    image: Option<DMatrix<f64>>,
    /// The length of each column.
    pub(super) columns: Vec<f64>,
    /// The smallest sine between a column and those before it.
    sine: f64,
    pub(super) volume: f64,
}

impl<'a> Factors<'a> {
    pub(super) fn new(matrix: &DMatrix<f64>, sizes: &'a Sizes) -> Factors<'a> {
        let scaled = |i: usize, j: usize| matrix[(i, j)] * sizes.coordinates[j] / sizes.rows[i];
        let scaled = DMatrix::from_fn(matrix.nrows(), matrix.ncols(), scaled);
        let factors = scaled.clone().qr();
        let own = (!matrix.is_square()).then(|| matrix.clone().qr());
        let triangle = factors.r();
        let sines = (0..matrix.ncols()).map(|j| triangle[(j, j)].abs() / scaled.column(j).norm());
        // NaN fails this comparison.
        let sine = sines.fold(1.0, |least: f64, sine| if sine >= least { least } else { sine });
        let unscaled = || sizes.rows.iter().product::<f64>() / sizes.coordinates.iter().product::<f64>();
        let volume = match &own {
            Some(own) => own.r().diagonal().iter().product::<f64>().abs(),
            None => triangle.diagonal().iter().product::<f64>().abs() * unscaled(),
        };
        let columns = matrix.column_iter().map(|column| column.norm()).collect();
        Factors { sizes, orthonormal: factors.q(), triangle, image: own.map(|own| own.q()), columns, sine, volume }
    }

    /// The x with A x nearest to the right-hand side.
    fn solve(&self, rhs: &DVector<f64>) -> Option<DVector<f64>> {
        let rhs = DVector::from_fn(rhs.len(), |i, _| rhs[i] / self.sizes.rows[i]);
        let found = self.triangle.solve_upper_triangular(&self.orthonormal.tr_mul(&rhs))?;
        finite(DVector::from_fn(found.len(), |j, _| found[j] * self.sizes.coordinates[j]))
    }

    /// The shortest y with A' y = rhs: where constraints depend on others, reactions of least norm in SI units.
    fn solve_transposed(&self, rhs: &DVector<f64>) -> Option<DVector<f64>> {
        let rhs = DVector::from_fn(rhs.len(), |j, _| rhs[j] * self.sizes.coordinates[j]);
        let found = &self.orthonormal * self.triangle.tr_solve_upper_triangular(&rhs)?;
        let found = DVector::from_fn(found.len(), |i, _| found[i] / self.sizes.rows[i]);
        finite(match &self.image {
            None => found,
            Some(image) => image * image.tr_mul(&found),
        })
    }
}

fn finite(found: DVector<f64>) -> Option<DVector<f64>> {
    found.iter().all(|value| value.is_finite()).then_some(found)
}
