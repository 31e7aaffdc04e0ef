//! The driven quantity: a coordinate, or an output that is a function of positions.

use crate::model::{At, Differentiable};
use crate::motion::typed::Any;
use crate::state::failure::{Failure, What};
use sim_kernel::{Description, Dual, Mechanism, Quantity};

/// A quantity y(q, t) that a drive moves or holds.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Driven {
    /// A coordinate, by index.
    Coordinate(usize),
    /// An output, by index, that depends neither on speeds nor on reactions.
    Output(usize),
}

/// y, y_q and y_t.
pub(super) struct Gradient {
    pub(super) value: f64,
    pub(super) by_positions: Vec<f64>,
    pub(super) by_time: f64,
}

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

    /// The unit of its driving force: N*m for an angle, N for a length, J per its SI unit for anything else.
    pub fn force_unit(self, description: &'static Description) -> String {
        let quantity = self.quantity(description);
        match si_unit(quantity).as_str() {
            _ if is_angle(quantity.unit) => "N*m".to_owned(),
            "m" => "N".to_owned(),
            "1" => "J".to_owned(),
            other => format!("J/({other})"),
        }
    }

    /// A whole turn in radians, if it is an angle.
    pub fn turn(self, description: &'static Description) -> Option<f64> {
        is_angle(self.quantity(description).unit).then_some(std::f64::consts::TAU)
    }

    /// y at a position.
    #[inline(never)]
    pub fn value<M: Mechanism>(self, mechanism: &M, time: f64, q: &M::Q) -> f64 {
        self.value_of(&Any(mechanism), time, q.as_ref())
    }

    /// The same of a mechanism of any type.
    pub(super) fn value_of(self, mechanism: &dyn Differentiable, time: f64, q: &[f64]) -> f64 {
        match self {
            Driven::Coordinate(i) => q[i],
            Driven::Output(i) => mechanism.outputs(At::moving(time, q, &[]))[i],
        }
    }

    /// y with its derivatives: by dual numbers if it is an output.
    pub(super) fn gradient(self, mechanism: &dyn Differentiable, time: f64, q: &[f64]) -> Gradient {
        let unit = |at: usize| (0..q.len()).map(|j| f64::from(u8::from(j == at))).collect::<Vec<f64>>();
        match self {
            Driven::Coordinate(i) => Gradient { value: q[i], by_positions: unit(i), by_time: 0.0 },
            Driven::Output(i) => Gradient {
                value: self.value_of(mechanism, time, q),
                by_positions: (0..q.len()).map(|j| slope(mechanism, i, [time, 0.0], q, &unit(j))).collect(),
                by_time: slope(mechanism, i, [time, 1.0], q, &vec![0.0; q.len()]),
            },
        }
    }

    /// (y_q q' + y_t)_q q' + (..)_t: y'' without accelerations, the change of y' along the motion.
    pub(super) fn convective(self, mechanism: &dyn Differentiable, time: f64, q: &[f64], qd: &[f64]) -> f64 {
        let Driven::Output(output) = self else { return 0.0 };
        let rated = mechanism.description().rated_outputs.iter().position(|rated| *rated == output);
        let Some(rated) = rated else { return f64::NAN };
        let moving = |value: f64, derivative: f64| Dual { value, derivative };
        let positions: Vec<Dual> = q.iter().zip(qd).map(|(q, qd)| moving(*q, *qd)).collect();
        let speeds: Vec<Dual> = qd.iter().map(|qd| Dual::constant(*qd)).collect();
        mechanism.output_rates_along(At::moving(moving(time, 1.0), &positions, &speeds))[rated].derivative
    }

    /// Checks that it can be driven: an output must depend on positions alone.
    ///
    /// # Errors
    /// [`What::NotOfPositions`].
    pub(super) fn check(self, mechanism: &dyn Differentiable, time: f64, q: &[f64]) -> Result<(), Failure> {
        let Driven::Output(i) = self else { return Ok(()) };
        match is_of_positions(mechanism, i, time, q) {
            true => Ok(()),
            false => {
                let output = self.quantity(mechanism.description()).name;
                Err(mechanism.failure(What::NotOfPositions { output }, time, q))
            }
        }
    }
}

/// The SI unit of a quantity.
#[cfg(feature = "analysis")]
fn si_unit(quantity: &Quantity) -> String {
    codegen::model::Unit::parse(quantity.unit).map_or_else(|_| "1".to_owned(), |unit| unit.si_text())
}

/// The SI unit of a quantity, as so many of its own: nothing here reads units.
#[cfg(not(feature = "analysis"))]
fn si_unit(quantity: &Quantity) -> String {
    match quantity.factor {
        _ if quantity.is_length => "m".to_owned(),
        1.0 => quantity.unit.to_owned(),
        factor => format!("{} {}", 1.0 / factor, quantity.unit),
    }
}

/// Whether a unit is one of angles: degrees, turns, or radians with or without a prefix.
pub(super) fn is_angle(unit: &str) -> bool {
    ["deg", "rev"].contains(&unit) || unit.strip_suffix("rad").is_some_and(|prefix| prefix.chars().count() <= 1)
}

/// Whether an output has a rate and does not change with speeds.
pub(super) fn is_of_positions(mechanism: &dyn Differentiable, output: usize, time: f64, q: &[f64]) -> bool {
    mechanism.description().rated_outputs.contains(&output)
        && (0..q.len()).all(|j| speed_slope(mechanism, output, time, q, j) == 0.0)
}

/// The derivative of an output along a change of position and time.
fn slope(mechanism: &dyn Differentiable, output: usize, [time, dt]: [f64; 2], q: &[f64], dq: &[f64]) -> f64 {
    let moving = |value: f64, derivative: f64| Dual { value, derivative };
    let q: Vec<_> = q.iter().zip(dq).map(|(q, dq)| moving(*q, *dq)).collect();
    mechanism.outputs_along(At::moving(moving(time, dt), &q, &[]), None)[output].derivative
}

/// The derivatives of an output by each coordinate.
pub(super) fn changes(mechanism: &dyn Differentiable, output: usize, time: f64, q: &[f64]) -> Vec<f64> {
    let unit = |j: usize| (0..q.len()).map(|k| f64::from(u8::from(j == k))).collect::<Vec<f64>>();
    (0..q.len()).map(|j| slope(mechanism, output, [time, 0.0], q, &unit(j))).collect()
}

/// The derivative of an output by a speed.
fn speed_slope(mechanism: &dyn Differentiable, output: usize, time: f64, q: &[f64], by: usize) -> f64 {
    let q: Vec<Dual> = q.iter().map(|q| Dual::constant(*q)).collect();
    // At speeds without symmetry, so that no square of a speed has its minimum there.
    let moving = |j: usize| Dual { value: 0.37 + 0.11 * j as f64, derivative: f64::from(u8::from(j == by)) };
    let qd: Vec<Dual> = (0..q.len()).map(moving).collect();
    mechanism.outputs_along(At::moving(Dual::constant(time), &q, &qd), None)[output].derivative
}
