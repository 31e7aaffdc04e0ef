//! The mechanics of a declaration at one state: body rows, loads and constraints as jets in (q, t).

use super::constraint::{self, Constraint, constraints};
use super::elements::{dissipation, element, potential};
use super::error::{OracleError, Result};
use super::interpret::{Interpreter, Setting};
use super::jet::Jet;
use super::measured::Measured;
use super::state::State;
use super::value::Value;
use crate::dsl::{Body, Declaration, Equation, Expression, Load, Operator, Unit};
use syn::Ident;

/// One row of x = T(q, t): a coordinate of a mass point, or the angle of a body.
pub(super) struct Row {
    /// Its mass or moment of inertia.
    pub(super) inertia: Measured,
    /// Where it is.
    pub(super) place: Jet,
}

/// One component of a force or a moment, and the coordinate or angle along which it works.
pub(super) struct Effort {
    /// The component.
    pub(super) force: Measured,
    /// Its virtual work is `force` times the variation of this.
    pub(super) place: Jet,
}

/// Everything of a declaration that enters the equations of motion, at one state.
pub(super) struct Mechanics {
    /// The rows of x = T(q, t) that have inertia.
    pub(super) rows: Vec<Row>,
    /// All loads.
    pub(super) efforts: Vec<Effort>,
    /// All constraints.
    pub(super) constraints: Vec<Constraint>,
    /// (q', 1, 0, ..): how the variables (q, t, s) of a position change in time.
    pub(super) rates: Vec<Measured>,
    /// How many coordinates there are.
    pub(super) coordinates: usize,
    /// How many auxiliary displacements there are.
    pub(super) auxiliaries: usize,
}

impl Mechanics {
    pub(super) fn new(
        declaration: &Declaration,
        si_factor: &dyn Fn(&Unit) -> f64,
        at: &State,
        active: &[bool],
    ) -> Result<Mechanics> {
        let auxiliaries = declaration.auxiliary.len();
        let interpreter = |setting| Interpreter::new(declaration, si_factor, setting);
        let mut builder = Builder {
            fixed: interpreter(Setting::fixed(at.parameters)),
            positions: interpreter(Setting::positions(at.time, at.parameters, at.coordinates, auxiliaries)),
            motion: interpreter(at.motion()),
            speeds: interpreter(Setting::speeds(at, auxiliaries).with_inputs(at.inputs)),
        };
        let bodies = declaration.bodies.iter().map(|body| builder.body(body)).collect::<Result<Vec<_>>>()?;
        let mut efforts = Vec::new();
        for load in &declaration.loads {
            efforts.extend(builder.load(load, &declaration.bodies, &bodies)?);
        }
        Ok(Mechanics {
            rows: bodies.into_iter().flatten().collect(),
            efforts,
            constraints: constraints(declaration, si_factor, at, active)?,
            rates: at.rates(auxiliaries),
            coordinates: at.coordinates.len(),
            auxiliaries,
        })
    }

    /// All rows of the constraints: a vector has two, x and y.
    pub(super) fn constraint_rows(&self) -> Vec<constraint::Row> {
        self.constraints.iter().flat_map(|constraint| constraint.rows.clone()).collect()
    }
}

/// left - right.
pub(super) fn difference(interpreter: &mut Interpreter, equation: &Equation) -> Result<Value> {
    let left = interpreter.value(&equation.left)?;
    left.combine(Operator::Subtract, interpreter.value(&equation.right)?)
}

struct Builder<'d> {
    fixed: Interpreter<'d>,
    positions: Interpreter<'d>,
    motion: Interpreter<'d>,
    speeds: Interpreter<'d>,
}

impl Builder<'_> {
    /// x and y with the mass, the angle with the moment of inertia, whichever the body has.
    fn body(&mut self, body: &Body) -> Result<Vec<Row>> {
        let mut rows = Vec::new();
        if let Some((mass, position)) = &body.mass {
            let inertia = self.fixed.scalar(mass)?.value();
            let place = self.positions.vector(needed(position.as_ref(), &body.name, "at")?)?;
            rows.extend(place.map(|place| Row { inertia, place }));
        }
        if let Some(inertia) = &body.inertia {
            let inertia = self.fixed.scalar(inertia)?.value();
            rows.push(Row {
                inertia,
                place: self.positions.scalar(needed(body.angle.as_ref(), &body.name, "angle")?)?,
            });
        }
        Ok(rows)
    }

    fn load(&mut self, load: &Load, bodies: &[Body], rows: &[Vec<Row>]) -> Result<Vec<Effort>> {
        match load {
            Load::Force { force, point } => {
                let (force, place) = (self.motion.vector(force)?, self.positions.vector(point)?);
                Ok(force.iter().zip(place).map(|(force, place)| Effort { force: force.value(), place }).collect())
            }
            Load::Torque { moment, body } => {
                let force = self.motion.scalar(moment)?.value();
                let place = match bodies.iter().find(|b| b.name == *body) {
                    Some(body) => self.positions.scalar(needed(body.angle.as_ref(), &body.name, "angle")?)?,
                    None => self.positions.named(body)?.scalar()?,
                };
                Ok(vec![Effort { force, place }])
            }
            Load::Potential(energy) => potential(energy, &mut self.positions),
            Load::Dissipation(function) => dissipation(function, &mut self.speeds, &self.positions),
            Load::Element(load) => element(&load.law, &load.extent, &mut self.positions, &mut self.motion),
            Load::Gravity { acceleration, .. } => {
                let acceleration = self.motion.vector(acceleration)?.map(|component| component.value());
                let massive = bodies.iter().zip(rows).filter(|(body, _)| body.mass.is_some());
                Ok(massive.flat_map(|(_, rows)| weight(rows, &acceleration)).collect())
            }
        }
    }
}

/// m g, of a body whose first two rows are those of its mass.
fn weight(rows: &[Row], acceleration: &[Measured; 2]) -> Vec<Effort> {
    let components = rows.iter().zip(acceleration);
    components.map(|(row, g)| Effort { force: row.inertia * *g, place: row.place.clone() }).collect()
}

fn needed<'e>(expression: Option<&'e Expression>, body: &Ident, word: &str) -> Result<&'e Expression> {
    expression.ok_or_else(|| OracleError::new(format!("body `{body}` has no `{word}`")))
}
