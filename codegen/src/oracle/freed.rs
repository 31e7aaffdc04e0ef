//! Newton's and Euler's equations of each body freed from the others.
//!
//! The force that a body needs is m a and the moment about its centre of mass J w' + w x J w, with a, w and w' of the
//! body as it moves in time; neither a mass matrix nor convective terms enter. The loads and reactions on the body are
//! subtracted from both; a force at a point acts on the body that the point moves with rigidly. The remainder must come
//! through joints that were not cut. These do no work, so summed over all bodies the remainder has no power along any
//! motion that the coordinates allow (Jourdain). A body that no other moves with is balanced by itself, force by force
//! and moment by moment.
//!
//! A load or constraint that acts on no single body, such as one written in coordinates or angles, enters by its
//! virtual work alone.

use super::effort::Effort;
use super::elements::{dissipation, element, potential};
use super::error::{OracleError, Result};
use super::interpret::Interpreter;
use super::jet::Jet;
use super::measured::Measured;
use super::motion::Solution;
use super::setting::Setting;
use super::state::State;
use super::value::Value;
use super::{Mechanics, Oracle};
use crate::dsl::{Body, Equation, Expression, Extent, Kind, Load};

mod moving;
mod vector;

use moving::{Freed, Point, as_it_is};
use vector::{Vector, filled, scaled};

/// The residual of an equation of a freed body, or of all bodies along a coordinate.
#[derive(Clone, Debug)]
pub struct Balance {
    /// The body, or the coordinate.
    pub name: String,
    /// In N or N*m, or as a power along the coordinate in W per its unit of speed.
    pub missing: f64,
    /// The sum of the magnitudes of all terms of the equation, and of the terms of its loads.
    pub size: f64,
    /// The inertia in the equation; residuals divided by its root are comparable. 0 where nothing with mass moves.
    pub inertia: f64,
}

impl Oracle<'_> {
    /// Newton's and Euler's equations of every freed body with these accelerations and multipliers.
    ///
    /// # Errors
    /// As [`Oracle::terms`].
    pub fn freed(&self, at: &State, solution: &Solution) -> Result<Vec<Balance>> {
        let mechanics = self.mechanics(at)?;
        let mut cut = Cut::new(self, at, solution)?;
        self.declaration.loads.iter().try_for_each(|load| cut.load(load))?;
        cut.reactions(&mechanics, &solution.multipliers)?;
        Ok(cut.balances())
    }
}

/// All bodies, and the loads that act on no single one.
struct Cut<'d> {
    oracle: &'d Oracle<'d>,
    positions: Interpreter<'d>,
    motion: Interpreter<'d>,
    speeds: Interpreter<'d>,
    bodies: Vec<Freed>,
    /// The power of the rest along each coordinate.
    unborne: Vec<Measured>,
}

impl<'d> Cut<'d> {
    fn new(oracle: &'d Oracle<'d>, at: &State, solution: &Solution) -> Result<Cut<'d>> {
        let auxiliaries = oracle.declaration.auxiliary.len();
        let positions = Setting::positions(at.time, at.parameters, at.coordinates, auxiliaries);
        let mut cut = Cut {
            oracle,
            positions: oracle.interpreter(positions),
            motion: oracle.interpreter(at.motion()),
            speeds: oracle.interpreter(Setting::speeds(at, auxiliaries).with_inputs(at.inputs)),
            bodies: vec![],
            unborne: vec![Measured::ZERO; at.coordinates.len()],
        };
        let mut fixed = oracle.interpreter(Setting::fixed(at.parameters));
        let mut moving = oracle.interpreter(at.accelerated_motion(&solution.accelerations));
        for body in &oracle.declaration.bodies {
            cut.bodies.push(Freed::new(body, at.coordinates.len(), &mut fixed, &mut cut.positions, &mut moving)?);
        }
        Ok(cut)
    }

    fn load(&mut self, load: &Load) -> Result<()> {
        let efforts = match load {
            Load::Force { force, point } => return self.force_at(force, point),
            Load::Gravity { acceleration, .. } => {
                let g = filled(self.motion.vector(acceleration)?.iter().map(Jet::value));
                self.bodies.iter_mut().for_each(|body| body.take_force(scaled(g, body.mass), None));
                return Ok(());
            }
            Load::Torque { moment, body } => match self.body(&body.to_string()) {
                Some(at) => return self.torque(moment, at),
                None => {
                    let (force, place) = (self.motion.scalar(moment)?.value(), self.positions.named(body)?.scalar()?);
                    vec![Effort { force, place }]
                }
            },
            Load::Element(load) => {
                let efforts = element(&load.law, &load.extent, &mut self.positions, &mut self.motion)?;
                let Extent::Distance(from, to) = &load.extent else { return self.bear_none(&efforts) };
                let force = filled(efforts.iter().map(|effort| effort.force));
                let ends = [self.point(to)?, self.point(from)?];
                let [to, from] = ends;
                self.apply(force, &to);
                self.apply(scaled(force, Measured::given(-1.0)), &from);
                return Ok(());
            }
            Load::Potential(energy) => potential(energy, &mut self.positions)?,
            Load::Dissipation(function) => dissipation(function, &mut self.speeds, &self.positions)?,
        };
        self.bear_none(&efforts)
    }

    fn force_at(&mut self, force: &Expression, point: &Expression) -> Result<()> {
        let force = filled(self.motion.vector(force)?.iter().map(Jet::value));
        let point = self.point(point)?;
        self.apply(force, &point);
        Ok(())
    }

    fn torque(&mut self, moment: &Expression, body: usize) -> Result<()> {
        let components = match self.motion.value(moment)? {
            Value::Scalar(about_z) => [Measured::ZERO, Measured::ZERO, about_z.value()],
            other => filled(other.vector()?.iter().map(Jet::value)),
        };
        self.bodies[body].take_moment(components);
        Ok(())
    }

    /// The forces of all constraints: for one between two points, -lambda on the first and lambda on the second.
    fn reactions(&mut self, mechanics: &Mechanics, multipliers: &[Measured]) -> Result<()> {
        let mut first = 0;
        for (equation, constraint) in self.oracle.declaration.constraints.iter().zip(&mechanics.constraints) {
            let rows = &constraint.rows;
            let lambda = &multipliers[first..first + rows.len()];
            first += rows.len();
            if !rows.iter().all(|row| row.active) {
                continue;
            }
            if let Some([left, right]) = self.points_of(equation, rows.len())? {
                let force = filled(lambda.iter().copied());
                self.apply(scaled(force, Measured::given(-1.0)), &left);
                self.apply(force, &right);
                continue;
            }
            for (row, lambda) in rows.iter().zip(lambda) {
                let power = self.unborne.iter_mut().zip(&row.jacobian);
                power.for_each(|(power, slope)| *power = *power - *lambda * as_it_is(*slope));
            }
        }
        Ok(())
    }

    /// Both sides of a constraint between points.
    fn points_of(&mut self, equation: &Equation, rows: usize) -> Result<Option<[Point; 2]>> {
        if rows < 2 || self.oracle.declaration.has_rates(equation) {
            return Ok(None);
        }
        let n = self.unborne.len();
        let sides = [self.positions.value(&equation.left)?, self.positions.value(&equation.right)?];
        Ok(match sides {
            [Value::Vector(left), Value::Vector(right)] => Some([Point::new(&left, n), Point::new(&right, n)]),
            _ => None,
        })
    }

    fn point(&mut self, expression: &Expression) -> Result<Point> {
        Ok(Point::new(&self.positions.vector(expression)?, self.unborne.len()))
    }

    fn body(&self, name: &str) -> Option<usize> {
        self.bodies.iter().position(|body| body.name == name)
    }

    /// A force at a point: on the body that the point belongs to, or by its power.
    fn apply(&mut self, force: Vector, point: &Point) {
        match self.bodies.iter_mut().find(|body| body.carries(point)) {
            Some(body) => body.take_force(force, Some(point)),
            None => {
                let power = self.unborne.iter_mut().zip(&point.velocities);
                power.for_each(|(power, velocity)| *power = *power + vector::inner(force, *velocity));
            }
        }
    }

    /// Loads by their power alone.
    fn bear_none(&mut self, efforts: &[Effort]) -> Result<()> {
        for effort in efforts {
            let power = self.unborne.iter_mut().zip(effort.place.gradient());
            power.for_each(|(power, slope)| *power = *power + effort.force * *slope);
        }
        Ok(())
    }

    fn balances(&self) -> Vec<Balance> {
        let coordinates = self.oracle.declaration.coordinates.iter();
        let along = coordinates.enumerate().map(|(j, coordinate)| {
            let needed = self.bodies.iter().map(|body| body.power_needed(j)).sum::<Measured>() - self.unborne[j];
            let inertia = self.bodies.iter().map(|body| body.inertia_along(j)).sum();
            Balance { name: coordinate.name.to_string(), missing: needed.value, size: needed.magnitude, inertia }
        });
        let alone = (0..self.bodies.len()).filter(|at| self.is_alone(*at));
        along.chain(alone.flat_map(|at| self.bodies[at].own_balances())).collect()
    }

    /// Whether this body can move in every way by coordinates that move no other body and that no unassigned load acts
    /// along.
    fn is_alone(&self, at: usize) -> bool {
        let own = |j: &usize| {
            let others = self.bodies.iter().enumerate().filter(|(other, _)| *other != at);
            self.unborne[*j].magnitude == 0.0 && others.into_iter().all(|(_, body)| !body.moves_along(*j))
        };
        let own: Vec<usize> = (0..self.unborne.len()).filter(own).collect();
        self.bodies[at].is_free_along(&own)
    }
}

/// The entries of an inertia as written: one, three, or six.
fn inertia_entries(body: &Body, fixed: &mut Interpreter) -> Result<Vec<Measured>> {
    let Some(inertia) = &body.inertia else { return Ok(vec![]) };
    match &inertia.kind {
        Kind::Vector(entries) => entries.iter().map(|entry| Ok(fixed.scalar(entry)?.value())).collect(),
        _ => Ok(vec![fixed.scalar(inertia)?.value()]),
    }
}

fn known<T>(found: Option<T>, what: &str) -> Result<T> {
    found.ok_or_else(|| OracleError::new(format!("{what} is not known")))
}
