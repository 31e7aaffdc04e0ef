//! What a drive moves: a coordinate, or an output that is a function of positions.

use crate::failure::{Failure, What};
use sim_kernel::{Array, Description, Dual, Mechanism, Quantity};

/// A quantity y(q, t) that a drive moves or holds.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Driven {
    /// A coordinate, by index.
    Coordinate(usize),
    /// An output, by index, that depends neither on speeds nor on reactions.
    Output(usize),
}

/// y, y_q and y_t.
pub(super) struct Gradient<Q> {
    pub(super) value: f64,
    pub(super) by_positions: Q,
    pub(super) by_time: f64,
}

type Twice = Dual<Dual<f64>>;

impl Driven {
    /// The coordinate or output of this name.
    pub fn find(description: &Description, name: &str) -> Option<Driven> {
        let coordinate = description.coordinates.iter().position(|c| c.position.name == name);
        let output = || description.outputs.iter().position(|o| o.name == name);
        coordinate.map(Driven::Coordinate).or_else(|| output().map(Driven::Output))
    }

    /// Its name, unit and documentation.
    pub fn quantity(self, description: &'static Description) -> &'static Quantity {
        match self {
            Driven::Coordinate(i) => &description.coordinates[i].position,
            Driven::Output(i) => &description.outputs[i],
        }
    }

    /// What moves it: N*m for an angle, N for a length, J per its unit for anything else.
    pub fn force_unit(self, description: &'static Description) -> &'static str {
        match self.quantity(description).unit {
            unit if is_angle(unit) => "N*m",
            unit if is_one_of(unit, "m", &["inch", "ft"]) => "N",
            _ => "J",
        }
    }

    /// A whole turn in radians, if it is an angle.
    pub fn turn(self, description: &'static Description) -> Option<f64> {
        is_angle(self.quantity(description).unit).then_some(std::f64::consts::TAU)
    }

    /// y at a position.
    pub fn value<M: Mechanism>(self, mechanism: &M, time: f64, q: &M::Q) -> f64 {
        match self {
            Driven::Coordinate(i) => q[i],
            Driven::Output(i) => {
                let zero = M::Q::filled(0.0);
                mechanism.outputs(time, q, &zero, &zero, &M::L::filled(0.0))[i]
            }
        }
    }

    /// y with its derivatives: by dual numbers where it is an output.
    pub(super) fn gradient<M: Mechanism>(self, mechanism: &M, time: f64, q: &M::Q) -> Gradient<M::Q> {
        match self {
            Driven::Coordinate(i) => Gradient { value: q[i], by_positions: unit::<M::Q>(i), by_time: 0.0 },
            Driven::Output(i) => {
                let along = |dq: &M::Q, dt: f64| slope(mechanism, i, [time, dt], q, dq);
                let still = M::Q::filled(0.0);
                Gradient {
                    value: self.value(mechanism, time, q),
                    by_positions: M::Q::from_fn(|j| along(&unit::<M::Q>(j), 0.0)),
                    by_time: along(&still, 1.0),
                }
            }
        }
    }

    /// (y_q q' + y_t)_q q' + (..)_t: y'' without accelerations.
    pub(super) fn convective<M: Mechanism>(self, mechanism: &M, time: f64, q: &M::Q, qd: &M::Q) -> f64 {
        match self {
            Driven::Coordinate(_) => 0.0,
            Driven::Output(i) => {
                let lifted = mechanism.on(constant);
                let moving = |value: f64, rate: f64| Dual {
                    value: Dual { value, derivative: rate },
                    derivative: Dual { value: rate, derivative: 0.0 },
                };
                second_slope(&lifted, i, moving(time, 1.0), |j| moving(q[j], qd[j]))
            }
        }
    }

    /// That it can be driven: an output must depend on positions alone.
    ///
    /// # Errors
    /// [`What::NotOfPositions`].
    pub(super) fn check<M: Mechanism>(self, mechanism: &M, time: f64, q: &M::Q) -> Result<(), Failure> {
        let Driven::Output(i) = self else { return Ok(()) };
        match is_of_positions(mechanism, i, time, q) {
            true => Ok(()),
            false => Err(Failure::at::<M>(
                What::NotOfPositions { output: self.quantity(const { &M::DESCRIPTION }).name },
                time,
                q,
            )),
        }
    }
}

fn is_angle(unit: &str) -> bool {
    is_one_of(unit, "rad", &["deg", "rev"])
}

/// Whether a unit is a base, with a prefix or without, or one of others.
fn is_one_of(unit: &str, base: &str, others: &[&str]) -> bool {
    others.contains(&unit) || unit.strip_suffix(base).is_some_and(|prefix| prefix.chars().count() <= 1)
}

/// Whether an output has a rate and does not change with speeds.
pub(super) fn is_of_positions<M: Mechanism>(mechanism: &M, output: usize, time: f64, q: &M::Q) -> bool {
    // At speeds without symmetry, so that no square of a speed has its minimum there.
    let speeds = M::Q::from_fn(|j| 0.37 + 0.11 * j as f64);
    M::DESCRIPTION.rated_outputs.contains(&output)
        && (0..M::Q::LEN).all(|j| speed_slope(mechanism, output, time, q, &speeds, j) == 0.0)
}

fn unit<Q: Array<f64>>(at: usize) -> Q {
    Q::from_fn(|j| f64::from(u8::from(j == at)))
}

fn constant(value: f64) -> Twice {
    Dual::constant(Dual::constant(value))
}

/// The derivative of an output along a change of position and time.
fn slope<M: Mechanism>(mechanism: &M, output: usize, [time, dt]: [f64; 2], q: &M::Q, dq: &M::Q) -> f64 {
    let lifted = mechanism.on(Dual::constant);
    let moving = |value: f64, derivative: f64| Dual { value, derivative };
    let still = |_| Dual::constant(0.0);
    outputs(&lifted, moving(time, dt), |j| moving(q[j], dq[j]), still)[output].derivative
}

/// The derivative of an output by a speed.
fn speed_slope<M: Mechanism>(mechanism: &M, output: usize, time: f64, q: &M::Q, qd: &M::Q, by: usize) -> f64 {
    let lifted = mechanism.on(Dual::constant);
    let moving = |j: usize| Dual { value: qd[j], derivative: f64::from(u8::from(j == by)) };
    outputs(&lifted, Dual::constant(time), |j| Dual::constant(q[j]), moving)[output].derivative
}

fn second_slope<M: Mechanism<Twice>>(mechanism: &M, output: usize, time: Twice, q: impl Fn(usize) -> Twice) -> f64 {
    outputs(mechanism, time, q, |_| constant(0.0))[output].derivative.derivative
}

/// Outputs without accelerations and reactions.
fn outputs<S: sim_kernel::Scalar, M: Mechanism<S>>(
    mechanism: &M,
    time: S,
    q: impl Fn(usize) -> S,
    qd: impl Fn(usize) -> S,
) -> M::Outputs {
    let zero = S::from_f64(0.0);
    mechanism.outputs(time, &M::Q::from_fn(q), &M::Q::from_fn(qd), &M::Q::filled(zero), &M::L::filled(zero))
}
